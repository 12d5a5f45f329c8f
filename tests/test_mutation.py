"""The machinery that changes what was proved: it finds a judge that is too friendly."""

import json
import pickle
from collections import Counter

import pytest
import sympy as sp
from chapters import chapter
from flint import arb

from symhaptic import notation
from symhaptic.book.chapters import folder, run
from symhaptic.book.ledger import of_derivation
from symhaptic.book.mutation import trials
from symhaptic.book.mutation.judgements import Rejudged
from symhaptic.book.mutation.statements import Decided, _alike, changes_of, says
from symhaptic.book.mutation.tables import Derived, changes_of_tables
from symhaptic.book.page import Page
from symhaptic.paper.quoted import Quoted
from symhaptic.proof import settle
from symhaptic.proof.settle import Settlement
from symhaptic.proof.theorems import judge
from symhaptic.proof.theorems.judge import Case, Judged
from symhaptic.proof.verdict import Kind

x, y = sp.symbols("x y")


def accepted(name, id):
    """Kinds of the wrong changes of a statement that are accepted."""
    settled = chapter(name).page.settled[id]
    found = trials.Trial(name)
    found.put(id, changes_of(settled), Counter())
    return {survivor.kind for survivor in found.accepted}


CHAPTERS = [
    pytest.param("s3_energy", marks=pytest.mark.slow),
    pytest.param("s3c_stiffness_maximum", marks=pytest.mark.slow),
    pytest.param("s4b_normalisation", marks=pytest.mark.slow),
    pytest.param("s4c_arm_limits", marks=pytest.mark.slow),
    "s2b_wall",  # a definition
    "s4d_parts_of_the_arm",
    "s8c_four_masses",
]


@pytest.mark.parametrize("name", CHAPTERS)
def test_a_judge_that_accepts_everything_is_caught(monkeypatch, name):
    assert trials.trial(chapter(name)).accepted == []
    for check in (Decided, Rejudged, Derived):
        monkeypatch.setattr(check, "holds", lambda self: True)
    assert trials.trial(chapter(name)).accepted


@pytest.mark.ci  # 4 s
def test_a_judge_that_accepts_all_data_from_outside_is_caught(monkeypatch):
    assert accepted("s4c_arm_limits", "eq22") == set()
    monkeypatch.setattr(Decided, "holds", lambda self: True)
    monkeypatch.setattr(Rejudged, "holds", lambda self: True)
    assert accepted("s4c_arm_limits", "eq22")


@pytest.mark.parametrize(
    ("place", "part", "friendly", "name", "id", "kind"),
    [
        # a theorem of anything, for each verdict that a theorem gives
        (judge, "_extra", lambda claim, shown: (), "s3a_passivity_condition", "s3a-mass-free",
         "claim"),
        (judge, "_extra", lambda claim, shown: (), "s3c_stiffness_maximum", "s3c-kmax-27",
         "claim"),  # enclosed with its number
        (judge, "_extra", lambda claim, shown: (), "s8c_four_masses", "rules:four-masses",
         "formula"),  # refuted, with what is right in short
        (judge, "_extra", lambda claim, shown: (), "s8e_damped_contact", "rules:damped-contact",
         "formula"),  # refuted, with a corrected print
        # a vacuous theorem
        (Judged, "_check_example", lambda self, conclusion: None, "s3a_passivity_condition",
         "s3a-mass-free", "grounds"),
        # a counterexample that shows nothing
        (Case, "refutes", lambda self, claim: True, "s8c_four_masses", "rules:four-masses",
         "claim"),
        # a print that is another, a number that is another
        (Settlement, "accepts", lambda self, printed, kinds=None: True, "s3a_passivity_condition",
         "eq5", "formula"),
        (settle, "holds", lambda quoted, number: True, "s3c_stiffness_maximum", "s3c-kmax-27",
         "digit"),
    ],
)  # fmt: skip
def test_one_friendly_part_is_caught(monkeypatch, place, part, friendly, name, id, kind):
    assert accepted(name, id) == set()
    monkeypatch.setattr(place, part, friendly)
    assert kind in accepted(name, id)


def test_a_definition_is_changed_by_what_its_theorem_says(monkeypatch):
    """The theorem alone would prove it; changes were refused for that."""
    page = Page("test")
    page.define("The way", notation.x, notation.v * notation.T)
    page.state("way", "the way in a period", "x = v T")
    assert page.settle("way").kind == Kind.DEFINITION
    changes = list(changes_of(page.settled["way"]))
    assert not any(change.check.holds() and change.excuse() is None for change in changes)
    monkeypatch.setattr(judge, "_extra", lambda claim, shown: ())
    assert {c.kind for c in changes if c.check.holds()} >= {"claim", "formula"}


def test_a_weaker_bound_survives_with_the_number_and_a_wrong_one_does_not():
    settled = chapter("s3c_stiffness_maximum").page.settled["s3c-kmax-27"]
    outcome = {c.what: (c.check.holds(), c.excuse()) for c in changes_of(settled)}
    holds, why = outcome["below 0.28 for below 0.27"]
    assert holds
    assert why.startswith("weaker, and true: the number is 0.2679")  # 2 - sqrt 3
    assert outcome["below 0.26 for below 0.27"] == (False, None)
    assert outcome["above 0.27 for below 0.27"] == (False, None)


@pytest.mark.parametrize(
    ("how", "digits", "right"),
    [
        ("about", "0.27", True),
        ("about", "0.26", False),
        ("below", "0.27", True),
        ("below", "0.26", False),
        ("above", "0.26", True),
        ("above", "0.27", False),
    ],
)
def test_whether_a_number_is_right_is_seen_from_the_ends_of_its_ball(how, digits, right):
    """2 - sqrt 3 = 0.26794919..., a textbook number."""
    assert says(Quoted(how, digits), arb("0.26794919 +/- 1e-8")) is right


def test_a_change_is_excused_only_where_no_point_tells_it_from_the_print():
    assert _alike((sp.tan(x),), (sp.sin(x) / sp.cos(x),))
    assert not _alike((sp.tan(x),), (sp.sin(x),))
    assert not _alike((x < y,), (y < x,))
    assert not _alike((sp.Eq(x, y),), (sp.Eq(x, -y),))
    assert not _alike((x,), (x, x))


def test_the_ledger_holds_nothing_of_the_theorems():
    """Entries go from one process to another; they carry verdicts, not closures."""
    entries = of_derivation(folder() / "s4d_parts_delay.py")
    assert len(pickle.dumps(entries)) < 200_000


def test_the_digits_of_a_table_are_changed(monkeypatch, tmp_path):
    """A chapter that needs 3 + 4 = 7 notices each of its digits, and no other one."""
    from dataclasses import make_dataclass

    from symhaptic.paper import tables

    Row = make_dataclass("Row", ["name", "left", "right", "unused"])
    monkeypatch.setattr(tables, "TABLE_X", (Row("one", "3", "4", "5"),), raising=False)
    path = tmp_path / "adds.py"
    path.write_text(
        '"""Do they add up?"""\n'
        "from sympy import Integer\n"
        "from symhaptic.paper.tables import TABLE_X\n"
        "def derive(page):\n"
        "    [row] = TABLE_X\n"
        "    page.step('Sum', Integer(row.left) + Integer(row.right), Integer(7))\n",
        encoding="utf-8",
    )
    outcome = {c.what: c.check.holds() for c in changes_of_tables(run(path), [path])}
    assert sum(outcome.values()) == 2
    assert all(("unused" in what) is accepted for what, accepted in outcome.items())
    assert len(outcome) == 6


def test_a_record_of_another_sympy_has_the_same_statements(tmp_path):
    found = [trials.Trial("one", {"eq5": Counter(sign=3)})]
    path = tmp_path / "mutants.json"
    record = json.loads(trials.committed(found))
    path.write_text(json.dumps(record | {"sympy": "0"}), encoding="utf-8")
    assert not trials.stale(path, found)
    path.write_text(json.dumps(record | {"sympy": "0", "chapters": {}}), encoding="utf-8")
    assert trials.stale(path, found)
