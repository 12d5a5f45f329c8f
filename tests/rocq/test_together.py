"""Chapters that are asked together rest on no more than each of them does by the record."""

import shutil
import subprocess
from dataclasses import replace

import pytest
from sympy import Symbol

from symhaptic.book import foreign
from symhaptic.notation.proposition import proposition
from symhaptic.rocq import compiled, together
from symhaptic.rocq.chapter import File
from symhaptic.rocq.compiled import Taken
from symhaptic.rocq.outcome import Outcome
from symhaptic.rocq.steps import Step

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("coqc") is None, reason=compiled.INSTALL),
]
TEXT = proposition(Symbol("x") > 0)
ADDED = "0 < 2", ("lra.",)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = compiled.prepared(tmp_path_factory.mktemp("rocq"))
    compiled.prelude_compiled(made)
    return made


def taken(folder, name, *lemmas, believed=()):
    """A chapter of some lemmas, one for each statement, that Rocq has taken."""
    steps = [
        Step(axiom, "rule", (), (), TEXT, said, "Axiom", [])
        for axiom, said in believed
    ] + [
        Step(f"lemma_{i}", "rule", (), (), TEXT, said, "Lemma", list(lines))
        for i, (said, lines) in enumerate(lemmas)
    ]  # fmt: skip
    statements = {f"{name}-{i}": (f"lemma_{i}",) for i in range(len(lemmas))}
    file = File(name, "Mine", steps, statements)
    seen, done = compiled._asked(file, folder)
    assert done.returncode == 0, done.stderr
    outcome = Outcome(name, dict.fromkeys(statements, "not asked yet"))
    return Taken(file, outcome, folder, seen.name, seen.names)


def recorded(names):
    return {"checked": "whole", "rests": [*names]}


def test_each_rests_on_what_the_record_says_and_on_its_own_axioms(folder, monkeypatch):
    one = taken(folder, "one", ADDED)
    stored = "rule_stored_1", "0 < 3"
    other = taken(folder, "other", ADDED, ("0 < 3", ("exact rule_stored_1.",)), believed=[stored])
    library = one.alone().rules("one-0")
    assert foreign.REALS in library
    known = {
        "statements": {f"{n}-{i}": recorded(library) for n in ("one", "other") for i in (0, 1)}
    }
    asked, listed = [], together.listed
    monkeypatch.setattr(together, "listed", lambda *a: asked.append(a[1]) or listed(*a))
    found = together.asked([one, other], folder, known)
    assert asked == [[one.module, other.module]]
    assert found["one"].rules("one-0") == library
    assert found["other"].rules("other-0") == library
    assert found["other"].rules("other-1") == ["stored", *library]
    assert set(found["other"].statements.values()) == {"whole"}


def test_an_axiom_that_nobody_named_is_found_among_others_too(folder):
    """Of one that takes it from a file of which its index tells that it is a lemma."""
    known = {"statements": {id: recorded([foreign.REALS]) for id in ("third-0", "fourth-0")}}
    third, fourth = taken(folder, "third", ADDED), taken(folder, "fourth", ADDED)
    hidden = taken(folder, "hidden", ("0 < 5", ("exact rule_hidden_1.",)),
                   believed=[("rule_hidden_1", "0 < 5")])  # fmt: skip
    third = replace(third, module=hidden.module)
    found = together.asked([third, fourth], folder, known)
    assert "rule_hidden_1, which nobody named" in found["third"].statements["third-0"]


def test_what_rocq_does_not_list_is_not_whole(folder, monkeypatch):
    known = {"statements": {id: recorded([foreign.REALS]) for id in ("fifth-0", "sixth-0")}}
    some = [taken(folder, "fifth", ADDED), taken(folder, "sixth", ADDED)]
    failed = subprocess.CompletedProcess([], 1, "", "Out of\nmemory")
    monkeypatch.setattr(compiled, "_compiled", lambda *a: failed)
    for one in together.asked(some, folder, known).values():
        [said] = one.statements.values()
        assert said == "coqc: does not say on what it rests: Out of memory"
