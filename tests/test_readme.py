"""What the README counts is what the committed reports have."""

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
REPORTS = ROOT / "reports"
pytestmark = pytest.mark.skipif(not REPORTS.is_dir(), reason="the reports are not beside the tests")


@pytest.fixture(scope="module")
def counted():
    """The figures of the README, by the words behind them."""
    text = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    shapes = {
        "statements": r"Of the paper's (\w+) statements",
        "theorems": r"statements, (\w+) rest on a theorem",
        "rocq": r"has checked (\w+) of the statements from end to end",
        "others": r"(\w+) statements are definitions or rest on data outside",
        "slips": r"(\w+) are errors in the text",
        "undecided": r"(\w+) are undecided",
        "rules": r"(\w+) rules of thumb",
        "record": r"(\w+) statements of a public design record",
        "own": r"and (\w+) statements of our own",
        "computed": r"(\w+) of these say that the functions",
        "refused": r"([\d ]+) changes were refused",
    }
    found = {name: re.search(shape, text)[1].strip() for name, shape in shapes.items()}
    return {name: int(n.replace(" ", "")) for name, n in found.items()}


def test_the_statements_are_those_of_the_ledger(counted):
    entries = json.loads((REPORTS / "ledger.json").read_text(encoding="utf-8"))["statements"]
    rules = [e for e in entries if e["id"].startswith("rules:")]
    own = [e for e in entries if e["source"] is None]
    record = [e for e in entries if e["id"].startswith("coupling:")]
    paper = [e for e in entries if ":" not in e["id"] and e not in own]
    assert counted["statements"] == len(paper)
    assert counted["theorems"] == sum(bool(e["rests"]) for e in paper)
    assert counted["others"] == sum(e["verdict"] in ("definition", "external") for e in paper)
    assert counted["slips"] == sum(e["verdict"] == "slip" for e in paper)
    assert counted["undecided"] == sum(e["verdict"] == "undecided" for e in paper)
    assert counted["rules"] == len(rules)
    assert counted["record"] == len(record)
    assert counted["own"] == len(own)
    assert counted["computed"] == sum(e["id"].startswith("computed-") for e in own)

    checked = json.loads((REPORTS / "rocq.json").read_text(encoding="utf-8"))["statements"]
    assert counted["rocq"] == sum(checked[e["id"]]["checked"] == "whole" for e in paper)


def test_so_many_changes_were_refused_to_a_thousand(counted):
    chapters = json.loads((REPORTS / "mutants.json").read_text(encoding="utf-8"))["chapters"]
    counts = (c for one in chapters.values() for c in (*one["statements"].values(), one["tables"]))
    refused = sum(sum(count.values()) for count in counts)
    assert counted["refused"] == refused // 1000 * 1000
