"""What a chapter takes from another is what it would prove by the same proof, or is refused."""

import json
import shutil
from dataclasses import replace

import pytest
from chapters import chapter
from sympy import Symbol

from symhaptic.book import foreign
from symhaptic.notation.proposition import proposition
from symhaptic.rocq import assumptions, compiled
from symhaptic.rocq.chapter import File
from symhaptic.rocq.shared import FOLDER, Seen
from symhaptic.rocq.steps import Step

TEXT = proposition(Symbol("x") > 0)


def step(name, statement, *lines, kind="Lemma"):
    return Step(name, "rule", (), (), TEXT, statement, kind, list(lines))


def file(name, *steps):
    return File(name, "Mine", list(steps), {"one": (steps[-1].name,)})


FIRST = (
    step("rule_stored_1", "0 < 2", kind="Axiom"),
    step("step_2", "0 < 1", "lra."),
    step("step_3", "0 < 1 /\\ 0 < 2", "exact (conj step_2 rule_stored_1)."),
)
OTHER = (
    step("step_1", "0 < 1", "lra."),
    step("rule_stored_4", "0 < 2", kind="Axiom"),
    step("step_5", "0 < 1 /\\ 0 < 2", "exact (conj step_1 rule_stored_4)."),
)
"""The same under other names."""


def proved(folder, *steps):
    """The file in which some steps stand."""
    (folder / FOLDER).mkdir(parents=True, exist_ok=True)
    found = Seen(folder, file("first", *steps))
    found.keep()
    return found


def taken(folder, *steps):
    """Which of some steps are taken from it."""
    return set(Seen(folder, file("second", *steps)).there)


def test_the_same_is_taken_under_whatever_name(tmp_path):
    proved(tmp_path, *FIRST)
    assert taken(tmp_path, *OTHER) == {"step_1", "rule_stored_4", "step_5"}
    # and those on which nothing that is left stands are not written
    assert [s.name for s in Seen(tmp_path, file("second", *OTHER)).file.steps] == ["step_5"]


@pytest.mark.parametrize(
    ("number", "changed", "left"),
    [
        (0, {"statement": "0 < 3"}, {"step_1", "step_5"}),  # and what it is used for
        (0, {"lines": ["nra."]}, {"step_1", "step_5"}),
        (0, {"kind": "Axiom"}, {"step_1", "step_5"}),
        (1, {"rule": "other"}, {"rule_stored_4", "step_5"}),
        (1, {"statement": "0 < 4"}, {"rule_stored_4", "step_5"}),
        (2, {"statement": "0 < 1 /\\ 0 < 4"}, {"step_5"}),
        (2, {"lines": ["exact (conj step_1 step_1)."]}, {"step_5"}),
    ],
)
def test_what_differs_in_one_place_is_not_taken(tmp_path, number, changed, left):
    proved(tmp_path, *FIRST)
    steps = list(OTHER)
    steps[number] = replace(steps[number], **changed)
    assert {s.name for s in steps} - taken(tmp_path, *steps) == left


def test_axioms_that_say_the_same_are_each_known_again(tmp_path):
    """Rocq lists the one by which a lemma was proved, which is known here by either name."""
    twice = (*FIRST[:1], step("rule_stored_9", "0 < 2", kind="Axiom"), *FIRST[1:])
    first = proved(tmp_path, *twice)
    again = Seen(tmp_path, file("first", *twice))
    names = ["rule_stored_1", "rule_stored_9"]
    assert [again.own[f"{first.name}.{name}"] for name in names] == [names, names]
    listed = assumptions.axioms(f"Axioms:\n{first.name}.rule_stored_1 : 0 < 2\n")
    assert assumptions.resting(file("first", *twice), listed, again.own) == {"one": names}


def test_what_rests_on_an_open_step_is_never_taken(tmp_path):
    open_ = (step("open_step_2", "0 < 1", kind="Axiom"),
             step("step_3", "0 < 1", "exact open_step_2."))  # fmt: skip
    proved(tmp_path, *open_)
    assert taken(tmp_path, *open_) == set()


def test_a_prelude_that_changed_forgets_all(tmp_path):
    compiled.prepared(tmp_path)
    proved(tmp_path, *FIRST)
    assert taken(compiled.prepared(tmp_path), *OTHER)
    text = (tmp_path / "Prelude.v").read_text()
    (tmp_path / "Prelude.v").write_text(f"(* In other words. *)\n{text}")
    assert taken(compiled.prepared(tmp_path), *OTHER)
    assert (tmp_path / "Prelude.v").read_text() == text
    (tmp_path / "Prelude.v").write_text("")
    assert not taken(compiled.prepared(tmp_path), *OTHER)


needs_rocq = pytest.mark.skipif(shutil.which("coqc") is None, reason=compiled.INSTALL)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = compiled.prepared(tmp_path_factory.mktemp("rocq"))
    compiled.prelude_compiled(made)
    return made


def forged(folder, mark, *steps):
    """A file of which its index tells that a step of it is what is looked for."""
    name = f"forged_{len([*(folder / FOLDER).glob('*.v')])}"
    text = file(name, *steps).written()
    (folder / FOLDER / f"{name}.v").write_text(text)
    assert compiled._compiled(folder, f"{FOLDER}/{name}").returncode == 0
    index = folder / FOLDER / f"{name}.json"
    index.write_text(json.dumps({steps[-1].name: mark}))
    return index


@pytest.mark.slow
@needs_rocq
def test_an_index_that_lies_is_found_out(folder):
    """Rocq compares what both say; what was believed there is an axiom that nobody named here."""
    mine = file("mine", step("lemma_1", "0 < 2", "lra."))
    [mark] = Seen(folder, mine).marks.values()
    index = forged(folder, mark, step("step_1", "0 < 1", "lra."))  # of something else
    seen, done = compiled._asked(mine, folder)
    assert "step_1" in done.stderr
    assert set(compiled.failing(folder, seen.text)) == {"lemma_1"}
    index.unlink()
    index = forged(folder, mark, step("step_1", "0 < 2", kind="Axiom"))
    seen, done = compiled._asked(mine, folder)
    listed = assumptions.axioms(compiled.listed(folder, [seen.name]))
    rests = assumptions.resting(mine, listed, seen.names)
    assert "which nobody named" in assumptions.told(mine, rests)["one"]
    index.unlink()


@pytest.mark.slow
@needs_rocq
def test_a_chapter_that_takes_all_rests_on_the_same(folder, monkeypatch):
    """Under the names of its own axioms; and what it is marked by is what is written."""
    one = chapter("s3b_envelope")
    first = compiled.asked(one, folder)
    (folder / "s3b_envelope.json").unlink()
    again = compiled.asked(one, folder)
    [text] = [t for f in (folder / FOLDER).glob("*.v") if "exact s3b" in (t := f.read_text())]
    assert "lra" not in text
    assert not again.kept
    assert (again.rests, again.statements, again.text) == (
        first.rests, first.statements, first.text,
    )  # fmt: skip
    assert foreign.REALS in next(iter(again.rests.values()))
    (folder / "s3b_envelope.v").write_text("(* In other words. *)")
    assert compiled.asked(one, folder).kept
    monkeypatch.setattr(compiled, "reader", lambda: "another compiler")
    assert not compiled.asked(one, folder).kept
    assert (folder / "s3b_envelope.v").read_text() == compiled.printed(one).written()


@pytest.mark.slow
@needs_rocq
def test_what_a_record_has_open_is_left_open_where_the_text_is_the_same(folder, monkeypatch):
    """And nothing that rests on it is whole; of another text nothing is believed."""
    one = chapter("s3b_envelope")
    text = compiled.text_mark(compiled.printed(one).written())
    name = next(s.name for s in compiled.printed(one).steps if s.kind == "Lemma")
    why = "not checked: coqc: No applicable tactic."
    monkeypatch.setattr(compiled, "failing", lambda *_: pytest.fail("tried again"))
    (folder / "s3b_envelope.json").unlink(missing_ok=True)
    left = {"text": text, "open": {f"open_{name}": why}}
    found = compiled.begun(one, folder, recorded=left).alone()
    assert found.open == left["open"]
    assert found.text == text
    assert "whole" not in found.statements.values()
    (folder / "s3b_envelope.json").unlink()
    assert compiled.begun(one, folder, recorded=left | {"text": "other"}).outcome.open == {}


def test_what_is_not_reached_in_time_is_left_open(tmp_path, monkeypatch):
    monkeypatch.setattr(compiled, "TOGETHER", 4)
    right = "Lemma a : 1 = 1.\nProof.\nreflexivity.\nQed.\n"
    long = "Lemma b : 2 = 2.\nProof.\ndo 1000000000 idtac.\nreflexivity.\nQed.\n"
    assert compiled.failing(tmp_path, right + long) == {"b": "coqc: not reached within 4 s"}
