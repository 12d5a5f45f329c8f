"""What Rocq has checked is told beside the verdict, in print and on the site, and in the ledger."""

import json
from dataclasses import replace

import pytest
import sympy as sp
from chapters import chapter

from symhaptic.book import committed, foreign, ledger, listing
from symhaptic.book.foreign import mark
from symhaptic.book.report import pages
from symhaptic.book.report.printed import chapter_tex, text_files
from symhaptic.book.report.site import trees
from symhaptic.notation.proposition import Exists, ForAll, proposition

NAME, ID = "s3a_passivity_condition", "s3a-mass-free"
OTHER = "eq5"


@pytest.fixture
def recorded(tmp_path, monkeypatch):
    """A record of our own: one statement whole, one with open steps, all else not asked."""
    settled = chapter(NAME).page.settled
    path = tmp_path / "rocq.json"
    whole = {
        "checked": "whole", "why": None, "says": mark(settled[ID].settlement.judged),
        "rests": ["stored", foreign.REALS, foreign.EXCLUDED],
    }  # fmt: skip
    leaves = {
        **whole, "checked": "leaves", "why": "2 steps open: coqc: x_1 & {y}^2 ~ \\z",
        "says": mark(settled[OTHER].settlement.judged),
    }  # fmt: skip
    counts = {"identities": [3, 4], "limits": [2, 2]}
    known = {"rocq": "8.16.1", "statements": {ID: whole, OTHER: leaves}, "leaves": counts}
    path.write_text(json.dumps(known))
    monkeypatch.setattr(foreign, "expected_rocq", lambda: path)
    return path


def test_a_mark_is_of_what_is_said_however_its_terms_are_ordered():
    x, y = sp.symbols("x y")
    said = [
        proposition(x + y > 0), proposition(x * y > 0), proposition(x + y >= 0),
        proposition(sp.Eq(x + y, 0)), proposition(x + 2 * y > 0), proposition(x - y > 0),
        ForAll((x,), proposition(x + y > 0)), Exists((x,), proposition(x + y > 0)),
    ]  # fmt: skip
    turned = proposition(sp.Add(y, x, evaluate=False) > 0)
    assert foreign._said(turned) == foreign._said(said[0])
    assert len({foreign._said(one) for one in said}) == len(said)


def test_the_book_says_on_what_a_whole_statement_rests(recorded):
    text = chapter_tex(chapter(NAME), 1)
    wanted = (
        r"\emph{Rocq:} whole, by \byrule{stored}{stored energy}, the axioms of the reals, "
        "excluded middle"
    )
    assert wanted in text
    assert r"\emph{Rocq:} in part (2 steps open" in text


def test_the_site_says_it_too_with_the_reason(recorded):
    text = trees([(1, chapter(NAME))], whole=False)[NAME].astext()
    assert "Rocq: whole, by stored energy, the axioms of the reals, excluded middle" in text
    assert "Rocq: in part (2 steps open" in text
    entries = ledger.of_chapter(chapter(NAME))
    page = pages.ledger(entries, {}).astext()
    assert "steps in all chapters it has checked 3 of 4 identities and all 2 limits." in page
    assert "Rocq 8.16.1, an independent proof assistant" in page
    assert "1 whole, 1 with steps open, 0 not" in page


def test_the_printed_ledger_lists_why_others_are_not_whole(recorded):
    text = text_files([chapter(NAME)])["ledger.tex"]
    assert "Rocq 8.16.1, an independent proof assistant" in text
    assert "has checked these statements: 1 whole, 1 with steps open" in text
    assert r"\heading{Why Rocq has not checked the others whole}" in text
    assert r"coqc: x\_1 \& \{y\}\^{}2 \textasciitilde{} \textbackslash{}z" in text


def test_the_reasons_that_hold_back_most_statements_stand_first(recorded):
    first, *_ = ledger.of_chapter(chapter(NAME))
    entries = [
        replace(first, rocq=foreign.Checked(foreign.LEAVES, f"1 step open: {reason}"))
        for reason in ("rare", "usual", "usual")
    ]
    said = pages.ledger(entries, {}).astext()
    said = said[said.index("Why Rocq") :]
    assert 0 < said.index("usual") < said.index("rare")


def test_the_ledger_of_verify_tells_it(recorded):
    entries = ledger.of_chapter(chapter(NAME))
    found = {
        one["id"]: one["rocq"]
        for one in json.loads(listing.json_text(entries, [], False))["statements"]
    }
    assert found[ID] == {
        "checked": "whole", "why": None, "rests": ["stored", foreign.REALS, foreign.EXCLUDED]
    }  # fmt: skip
    assert found[OTHER]["checked"] == "leaves"
    assert '<property name="rocq" value="whole" />' in listing.junit(entries, [], False)
    assert "checked by Rocq, too: 1 whole, 1 with steps open" in listing.text(entries, [], False)
    # the record stands by itself, and is not copied into the committed ledger
    assert "rocq" not in json.loads(committed.committed(entries))["statements"][0]


def test_a_claim_that_has_changed_is_told_nowhere_as_checked(recorded):
    known = json.loads(recorded.read_text())
    known["statements"][ID]["says"] = "something else"
    recorded.write_text(json.dumps(known))
    foreign.recorded.cache_clear()
    assert r"\emph{Rocq:} whole" not in chapter_tex(chapter(NAME), 1)
    entry = next(e for e in ledger.of_chapter(chapter(NAME)) if e.statement.id == ID)
    assert entry.rocq.as_json() == {"checked": "not", "why": foreign.CHANGED, "rests": []}
