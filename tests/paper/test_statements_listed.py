"""docs/statements.md: each statement of the paper has an id that exists, or a reason."""

import re
from pathlib import Path

import pytest

from symhaptic.paper import STATEMENTS
from symhaptic.rules import STATEMENTS as RULES

ROOT = Path(__file__).parents[2]
LINES = (ROOT / "docs" / "statements.md").read_text(encoding="utf-8").splitlines()
ROWS = [
    [cell.strip() for cell in line.strip("|").split(" | ")] for line in LINES if "|" in line[:1]
]
HEAD, _, *ROWS = ROWS
OURS = {
    id
    for path in (ROOT / "derivations").glob("*.py")
    for id in re.findall(r'"([a-z0-9-]+)"', path.read_text(encoding="utf-8"))
}
NO_IDS = {"grid_boundary", "s4d_jury_counted"}
"""A function and a chapter that reasons name."""


def ids(row):
    return set(re.findall(r"`([^`]+)`", row[2])) - NO_IDS


def test_the_table_has_three_columns_and_more_rows_than_a_referee_counted():
    assert HEAD == ["place", "the paper says", "settled as"]
    assert {len(row) for row in ROWS} == {3}
    assert len(ROWS) >= 144


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[1][:40])
def test_each_row_names_statements_that_exist_or_a_reason(row):
    assert ids(row) <= set(STATEMENTS) | set(RULES) | OURS
    assert ids(row) or row[2].startswith("no statement: ")


def test_each_statement_of_the_paper_is_in_the_table():
    assert set(STATEMENTS) - set().union(*map(ids, ROWS)) == set()
