"""The table of changes that survive: complete, and no row longer than a page."""

import json

from symhaptic.book.report.latex import page
from symhaptic.book.report.pages import TOGETHER, mutants


def test_many_changes_of_one_thing_stand_in_several_rows(tmp_path):
    changes = [f"{i} for 5" for i in range(2 * TOGETHER + 1)]
    survivors = [["eq1", "digit", change, "as its source has it"] for change in changes]
    record = {"statements": {"eq1": {"digit": 3}}, "tables": {}, "survivors": survivors}
    path = tmp_path / "mutants.json"
    path.write_text(json.dumps({"chapters": {"s0": record}}))
    text = page(mutants(path), "").replace(r"\allowbreak{}", "")
    rows = [line for line in text.splitlines() if " for 5" in line]
    assert [row.count("; ") + 1 for row in rows] == [TOGETHER, TOGETHER, 1]
    assert f"{len(changes)} changes were not refused" in text
    assert all(sum(rf"\texttt{{{change}}}" in row for row in rows) == 1 for change in changes)
