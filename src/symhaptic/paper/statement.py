"""What one statement of the paper is: an id, where it stands, and what is printed there."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property

from symhaptic.notation.proposition import Proposition, proposition, whole
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.reading import Notation, Printed, read


@dataclass(frozen=True)
class Source:
    """Where statements are from; its ``key`` stands in front of their ids, as in "rules:four"."""

    key: str
    title: str
    authors: str = ""
    year: str = ""
    where: str = ""
    """Journal, or where else it is found."""
    notation: Notation = ()
    """What it calls otherwise: its LaTeX, and the symbol's name in ``notation.SYMBOLS``."""


@dataclass(frozen=True)
class Statement:
    r"""A statement of the paper, as published.

    ``latex`` holds the printed formula line by line, or nothing where the statement is in
    words.  ``quote`` is the sentence of the paper that makes the statement or introduces the
    formula, with [...] for what is left out; ``says`` is our reading of it (both have LaTeX
    between dollar signs).  ``reading`` is LaTeX for the formula where the print has words instead
    of symbols.  A marker ``\br`` in the LaTeX is a place to break the line; it is not part of the
    formula.
    """

    id: str
    location: str
    says: str
    latex: tuple[str, ...] = ()
    domain: str = ""
    """LaTeX of where it holds, its parts separated by commas."""
    condition: bool = False
    """Whether the print is a condition, such as a bound used as a rule, and not asserted."""
    reading: tuple[str, ...] | None = None
    quoted: tuple[Quoted, ...] = ()
    """Numbers that the text quotes."""
    notation: Notation = ()
    """What its source calls otherwise."""
    quote: str = ""
    """The source's own words, in short; empty where a chapter states it itself."""

    def __getstate__(self) -> dict[str, object]:
        """Without what was read from the LaTeX, which not every SymPy can send to a process."""
        return {name: value for name, value in self.__dict__.items() if name != "printed"}

    @cached_property
    def printed(self) -> Printed:
        """The printed formula as SymPy relations or expressions; empty for one in words."""
        lines = self.latex if self.reading is None else self.reading
        return tuple(part for line in lines for part in read(line, self.notation))

    @property
    def given(self) -> tuple[Proposition, ...]:
        """The parts of the domain as propositions.

        Raises :class:`~symhaptic.paper.reading.Unreadable` for words.
        """
        parts = (part.strip() for part in re.split(r",(?:\\quad|\\[ ,;])?", self.domain))
        return tuple(p for part in parts if part for p in _supposed(part, self.notation))

    @property
    def text(self) -> str:
        """LaTeX of the statement: the printed formula, or what it says."""
        if not self.latex:
            return rf"\text{{{self.says}}}"
        joined = r",\quad ".join(self.latex).replace(r"\br ", "")
        return rf"{joined},\quad {self.domain}" if self.domain else joined


def _supposed(part: str, notation: Notation) -> list[Proposition]:
    r"""A part of a domain: relations, or ``d\in\mathbb{N}_0``."""
    name, of, numbers = part.partition(r"\in")
    if of and numbers.strip() == r"\mathbb{N}_0":
        return [whole(term) for term in read(name, notation)]
    return [proposition(relation) for relation in read(part, notation)]
