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
MEANT = "forall M T, passive M T -> 0 < 2", ("intros; lra.",)
"""Rests on what `passive` means, which stands in the prelude."""


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


def recorded(*names):
    return {"checked": "whole", "rests": [*names, foreign.REALS]}


def test_each_rests_on_what_the_record_says_and_on_its_own_axioms(folder, monkeypatch):
    one = taken(folder, "one", MEANT)
    stored = "rule_stored_1", "0 < 3"
    other = taken(folder, "other", MEANT, ("0 < 3", ("exact rule_stored_1.",)), believed=[stored])
    known = {
        "statements": {f"{n}-{i}": recorded("passive") for n in ("one", "other") for i in (0, 1)}
    }
    asked, listed = [], together.listed
    monkeypatch.setattr(together, "listed", lambda *a: asked.append(a[1]) or listed(*a))
    found = together.asked([one, other], folder, known)
    assert asked == [[one.module, other.module]]
    assert found["one"].rules("one-0") == ["passive", foreign.REALS]
    assert found["other"].rules("other-0") == ["passive", foreign.REALS]
    assert found["other"].rules("other-1") == ["stored", foreign.REALS]
    assert set(found["other"].statements.values()) == {"whole"}


def test_what_is_not_recorded_of_all_of_them_is_laid_to_none_that_does_not_use_it(folder):
    """Rocq lists `passive` for both, of which the record of neither knows."""
    one, other = taken(folder, "plain", ADDED), taken(folder, "meant", MEANT)
    known = {"statements": {"plain-0": recorded(), "meant-0": recorded()}}
    found = together.asked([one, other], folder, known, workers=2)
    assert found["plain"].rules("plain-0") == [foreign.REALS]
    assert found["meant"].rules("meant-0") == ["passive", foreign.REALS]


def test_a_predicate_is_laid_to_those_that_name_it_and_parts_nobody(folder, monkeypatch):
    """Each alone where the record has it of one whose lemmas do not name it."""
    one, other = taken(folder, "bare", ADDED), taken(folder, "named", MEANT)
    asked, listed = [], together.listed
    monkeypatch.setattr(together, "listed", lambda *a: asked.append(a[1]) or listed(*a))
    known = {"statements": {"bare-0": recorded(), "named-0": recorded("passive")}}
    found = together.asked([one, other], folder, known)
    assert asked == [[one.module, other.module]]
    assert found["bare"].rules("bare-0") == [foreign.REALS]
    assert found["named"].rules("named-0") == ["passive", foreign.REALS]
    alone = []
    monkeypatch.setattr(compiled.Taken, "alone", lambda one: alone.append(one) or one.outcome)
    known = {"statements": {id: recorded("passive") for id in ("bare-0", "named-0")}}
    together.asked([one, other], folder, known)
    assert alone == [one]


def test_an_axiom_that_nobody_named_is_found_among_others_too(folder):
    """Of one that takes it from a file of which its index tells that it is a lemma."""
    known = {"statements": {"third-0": recorded(), "fourth-0": recorded()}}
    third, fourth = taken(folder, "third", ADDED), taken(folder, "fourth", ADDED)
    hidden = taken(folder, "hidden", ("0 < 5", ("exact rule_hidden_1.",)),
                   believed=[("rule_hidden_1", "0 < 5")])  # fmt: skip
    third = replace(third, module=hidden.module)
    found = together.asked([third, fourth], folder, known)
    assert "rule_hidden_1, which nobody named" in found["third"].statements["third-0"]


def test_what_rocq_does_not_list_is_not_whole(folder, monkeypatch):
    known = {"statements": {"fifth-0": recorded(), "sixth-0": recorded()}}
    some = [taken(folder, "fifth", ADDED), taken(folder, "sixth", ADDED)]
    failed = subprocess.CompletedProcess([], 1, "", "Out of\nmemory")
    monkeypatch.setattr(compiled, "_compiled", lambda *a: failed)
    for one in together.asked(some, folder, known).values():
        [said] = one.statements.values()
        assert said == "coqc: does not say on what it rests: Out of memory"
