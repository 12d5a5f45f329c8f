"""No wrong variant of a statement or a table survives; what does survive is committed by name."""

import json
from functools import cache

import pytest
import sympy as sp
from chapters import chapter

from symhaptic.book.chapters import expected_ledger, expected_mutants, shipped
from symhaptic.book.committed import UNPROVED, expected
from symhaptic.book.mutation.trials import trial
from symhaptic.paper import STATEMENTS

ENOUGH = 15  # wrong variants of a printed formula

# These formulas are too short for fifteen; the numbers count by hand what can be changed: each
# symbol doubled, negated or exchanged, each sign, the whole halved, squared or inverted.
SHORT = {
    "s4a-delay-equivalent": 8,  # one power, two symbols
    "s4d-left-bound": 6,  # minus one symbol
}
UPDATE = "`symhaptic mutants` writes reports/mutants.json anew"
PATHS = {path.stem: path for path in shipped()}


@cache
def listed():
    """The committed outcome."""
    assert expected_mutants().is_file(), UPDATE
    return json.loads(expected_mutants().read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", ["s3a_passivity_condition", "s3c_stiffness_maximum"])
def test_no_wrong_change_is_accepted(record_property, name):
    """Of two chapters; `symhaptic mutants --check` does the same for all."""
    found = trial(chapter(name))
    record_property("mutants", found.refused)
    assert found.accepted == []
    # another SymPy orders the terms of a sum differently, and other ones are changed
    if listed()["sympy"] == sp.__version__:
        assert found.as_json() == listed()["chapters"].get(name), UPDATE


@pytest.mark.parametrize("name", PATHS)
def test_a_printed_formula_has_enough_variants(name):
    """Counted in the committed outcome, for what is printed and was derived."""
    for id, counts in listed()["chapters"][name]["statements"].items():
        if "formula" in counts and STATEMENTS.get(id) and STATEMENTS[id].printed:
            assert counts["formula"] >= SHORT.get(id, ENOUGH), id


def test_the_committed_chapters_are_the_shipped_ones():
    assert list(listed()["chapters"]) == list(PATHS), UPDATE


def test_there_are_thousands():
    records = listed()["chapters"].values()
    counts = [c for r in records for c in (r["tables"], *r["statements"].values())]
    assert sum(sum(c.values()) for c in counts) > 8000


def test_every_survivor_has_a_reason():
    for record in listed()["chapters"].values():
        assert all(len(survivor) == 4 and all(survivor) for survivor in record["survivors"])


def test_every_statement_that_a_theorem_settles_has_mutants():
    """Also one that is false: its correction is changed, and its counterexample left out."""
    verdicts = expected(expected_ledger())
    theorems = {id for id, kind in verdicts.items() if kind not in UNPROVED}
    records = listed()["chapters"].values()
    changed = {id for r in records for id, counts in r["statements"].items() if counts}
    assert theorems - changed == set(), UPDATE
