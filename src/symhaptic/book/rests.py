"""What rests on what: from a statement to the theorems on the pages, and from these to rules."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from symhaptic.book.chapters import Chapter
from symhaptic.book.rules import classical
from symhaptic.notation.proposition import Proposition
from symhaptic.proof.theorems.kernel import Theorem

Said: TypeAlias = tuple[frozenset[Proposition], Proposition]
"""Hypotheses and conclusion, by which a theorem is known again."""


@dataclass(frozen=True)
class Shown:
    """A theorem that stands on a page."""

    chapter: int
    number: int
    title: str
    theorem: Theorem = field(repr=False, compare=False)

    @property
    def place(self) -> str:
        """Its number, as printed."""
        return f"{self.chapter}.{self.number}"


@dataclass(frozen=True)
class Rest:
    """What theorems rest on: others on the pages, and the classical rules applied beside them."""

    shown: tuple[Shown, ...]
    rules: tuple[str, ...]


def said(theorem: Theorem) -> Said:
    """What a theorem says."""
    return theorem.hypotheses, theorem.conclusion


def shown_in(chapters: Iterable[tuple[int, Chapter]]) -> dict[Said, Shown]:
    """The theorems on the pages of numbered chapters, each where it stands first."""
    found: dict[Said, Shown] = {}
    for number, chapter in chapters:
        for block in chapter.page.blocks:
            if block.theorem is not None:
                one = Shown(number, block.number, block.title, block.theorem)
                found.setdefault(said(block.theorem), one)
    return found


def rests(theorems: Sequence[Theorem], shown: Mapping[Said, Shown]) -> Rest:
    """What these theorems rest on, not looking behind a theorem that stands on another page.

    The theorems themselves are looked behind, even where they are on a page.
    """
    below: dict[str, Shown] = {}
    rules: set[str] = set()
    own = {said(theorem) for theorem in theorems}
    seen: set[int] = set()
    stack = list(theorems)
    while stack:
        theorem = stack.pop()
        if id(theorem) in seen:
            continue
        seen.add(id(theorem))
        what = said(theorem)
        if what in shown and what not in own:
            below[shown[what].place] = shown[what]
            continue
        rules.add(theorem.given[0] if theorem.rule == "known" else theorem.rule)
        stack += theorem.premises
    order = sorted(below.values(), key=lambda one: (one.chapter, one.number))
    return Rest(tuple(order), tuple(name for name in classical() if name in rules))


def between(chapters: Sequence[tuple[int, Chapter]]) -> dict[int, frozenset[int]]:
    """For each chapter that applies theorems of other chapters, which these are."""
    shown = shown_in(chapters)
    found = {}
    for number, chapter in chapters:
        page = chapter.page
        stated = [[one.theorem] for one in shown.values() if one.chapter == number]
        judged = [item.settlement.judged for item in page.settled.values()]
        settled = [[one.theorem, *(c.theorem for c in one.unless)] for one in judged if one]
        below = {one.chapter for made in stated + settled for one in rests(made, shown).shown}
        if below - {number}:
            found[number] = frozenset(below - {number})
    return found


def used(statements: Iterable[Sequence[str]]) -> Counter[str]:
    """How many statements rest on each rule, of which each names its own."""
    return Counter(name for rests in statements for name in set(rests))
