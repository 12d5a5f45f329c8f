"""The parts of the book, each with what rests on what in it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from symhaptic.book.chapters import Chapter
from symhaptic.book.parts import OWN, PARTS, part_of
from symhaptic.book.record import Settled
from symhaptic.book.rests import Rest, Said, Shown, rests, said, shown_in
from symhaptic.book.rules import called
from symhaptic.book.tex.forms import reference
from symhaptic.book.tex.words import anchor, place_of, prose

Numbered = tuple[int, Chapter]


def parts(chapters: Sequence[Numbered]) -> list[dict[str, Any]]:
    """Title, opening, chapters and table of each part that has a chapter."""
    shown, again = shown_in(chapters), repeated(chapters)
    found = []
    for part in (*PARTS, OWN):
        inside = [(number, one) for number, one in chapters if part_of(one.name) is part]
        if inside:
            found.append(
                {
                    "title": part.title,
                    "opening": prose(part.opening),
                    "names": [one.name for _, one in inside],
                    "rows": [row for one in inside for row in _rows(one, shown, again)],
                }
            )
    return found


def _rows(
    numbered: Numbered, shown: Mapping[Said, Shown], again: Mapping[Said, Sequence[str]]
) -> list[dict[str, str]]:
    """The theorems of a chapter, then the statements that it settles by theorems."""
    number, chapter = numbered
    here = [one for one in shown.values() if one.chapter == number]
    rows = [
        _row(
            "".join(f"\\rowplace{{{place}}}" for place in again[said(one.theorem)])
            + f"\\theoremlink{{{one.place}}}",
            prose(one.title),
            rests([one.theorem], shown),
        )
        for one in here
    ]
    return rows + [_settled(item, shown) for item in _by_theorem(chapter)]


def repeated(chapters: Sequence[Numbered]) -> dict[Said, list[str]]:
    """The places of each theorem; of one that stands on several pages the table has the first."""
    found: dict[Said, list[str]] = {}
    for number, chapter in chapters:
        for one in shown_in([(number, chapter)]).values():
            found.setdefault(said(one.theorem), []).append(one.place)
    return found


def _by_theorem(chapter: Chapter) -> list[Settled]:
    return [s for s in chapter.page.settled.values() if s.settlement.judged is not None]


def _settled(item: Settled, shown: Mapping[Said, Shown]) -> dict[str, str]:
    judged = item.settlement.judged
    assert judged is not None
    theorems = [judged.theorem, *(case.theorem for case in judged.unless)]
    id = item.statement.id
    place = f"\\statementlink{{{place_of(id)}}}{{{reference(id)}}}"
    kind = f"\\kind{{{item.verdict.kind}}}{{{item.verdict.kind}}}"
    return _row(place, f"{prose(item.statement.says)} ({kind})", rests(theorems, shown))


def _row(place: str, says: str, rest: Rest) -> dict[str, str]:
    names = {called(rule): rule for rule in rest.rules}
    return {
        "place": place,
        "says": says,
        "theorems": ", ".join(f"\\theoremlink{{{one.place}}}" for one in rest.shown),
        "rules": ", ".join(f"\\byrule{{{anchor(r)}}}{{{prose(n)}}}" for n, r in names.items()),
    }
