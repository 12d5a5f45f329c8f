"""What a page keeps: its blocks, what was asked and confirmed on the way, and the verdicts."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import sympy as sp
from sympy import Expr
from sympy.core.function import AppliedUndef

from symhaptic.notation.latex import refused
from symhaptic.notation.terms import NoTerm
from symhaptic.notation.written import chains, written
from symhaptic.paper import Statement
from symhaptic.paper.propositions import Claim
from symhaptic.proof.certificate import Certificate
from symhaptic.proof.decide import Comparison, compare
from symhaptic.proof.names import carrying
from symhaptic.proof.settle import Settlement
from symhaptic.proof.shape import Form, parts
from symhaptic.proof.theorems.kernel import NotShown, Theorem
from symhaptic.proof.theorems.leaves import tends
from symhaptic.proof.verdict import Verdict

PACKAGE = Path(__file__).parents[1]


class FalseStep(ValueError):
    """A step that is not true, or that could not be proved."""


def in_latex(where: str, *texts: Any) -> None:
    """Raise :class:`FalseStep` where a text is no LaTeX that can be printed in a formula."""
    for text in texts:
        if isinstance(text, str) and (why := refused(text)):
            raise FalseStep(f"{where}: {text!r} {why}")


def line_at_work() -> int:
    """The line of the chapter that is at work: of the innermost frame outside the package."""
    package = str(PACKAGE)
    chapters = str(PACKAGE / "derivations")
    frame = sys._getframe(1)
    while frame.f_back is not None:
        file = frame.f_code.co_filename
        if not file.startswith(package) or file.startswith(chapters):
            break
        frame = frame.f_back
    return frame.f_lineno


@dataclass(frozen=True)
class Evidence:
    """How something that is not written on the page was proved."""

    how: str | Comparison

    @property
    def method(self) -> str:
        """How it is proved, in words."""
        return in_words(self.how)


def in_words(how: str | Comparison) -> str:
    """How something is proved."""
    return how if isinstance(how, str) else how.method


@dataclass(frozen=True)
class Block:
    """One element of a page: prose, an equation with its proof, a table or a figure."""

    kind: str
    title: str = ""
    text: str = ""
    lines: tuple[tuple[str, str, Any], ...] = ()
    """Left side, relation sign and right side of each line; sides are SymPy or LaTeX."""
    verdict: str = ""
    how: str | Comparison = ""
    """In words, or what was compared, which finds the words when they are read."""
    number: int = 0
    boxed: bool = False
    draw: Callable[..., None] | None = None
    panels: tuple[int, int] = (1, 1)
    height: float = 0.62
    paper: str = ""
    """Number of the paper's equation that this one stands for."""
    rows: tuple[tuple[Any, ...], ...] = ()
    """Cells of a table, its head first."""
    theorem: Theorem | None = None
    """The theorem that stands in it instead of lines."""

    @property
    def method(self) -> str:
        """How it is proved, in words."""
        return in_words(self.how)

    @cached_property
    def said(self) -> tuple[tuple[str, ...], str]:
        """LaTeX of the theorem's hypotheses, the short ones first, and of its conclusion."""
        if self.theorem is None:
            raise ValueError(f"{self.title}: no theorem stands in it")
        given = sorted(chains(sorted(self.theorem.hypotheses, key=written)), key=len)
        return tuple(given), written(self.theorem.conclusion)


@dataclass
class Settled:
    """A statement with what settles it and how long that took."""

    statement: Statement
    settlement: Settlement
    verdict: Verdict
    seconds: float


@dataclass
class Record:
    """A page without its author's steps."""

    name: str
    blocks: list[Block] = field(default_factory=list)
    settled: dict[str, Settled] = field(default_factory=dict)
    own: dict[str, Statement] = field(default_factory=dict)
    claimed: dict[str, Claim] = field(default_factory=dict)
    """What statements of one's own claim."""
    certificates: list[Certificate] = field(default_factory=list)
    """Of the balls that the chapter rests on; they are checked again when it has been run."""
    definitions: list[tuple[Expr, Expr]] = field(default_factory=list)
    """What a symbol or a function stands for on this page."""
    _lines: dict[tuple[str, str], int] = field(default_factory=dict)
    """Where each id was stated and where it was settled."""
    _count: int = 0
    _since: float = field(default_factory=time.perf_counter)

    def _record(
        self, statement: Statement, settlement: Settlement, verdict: Verdict | None = None
    ) -> Verdict:
        if verdict is None:
            verdict = settlement.decide(statement.printed)
        self._once("settled", statement.id)
        now = time.perf_counter()
        seconds, self._since = now - self._since, now
        self.settled[statement.id] = Settled(statement, settlement, verdict, seconds)
        return verdict

    def _once(self, what: str, id: str) -> None:
        """An id is stated once and settled once."""
        line, first = line_at_work(), self._lines.get((what, id))
        if first is not None:
            raise FalseStep(f"{id!r} is {what} twice, in lines {first} and {line}")
        self._lines[what, id] = line

    def _tends(self, title: str, expr: Expr, variable: sp.Symbol, at: Expr, value: Expr) -> Theorem:
        """A limit as a theorem, with the conditions under which it was shown."""
        try:
            return tends(expr, variable, at, value)
        except (NotShown, NoTerm) as wrong:
            raise FalseStep(f"step {title!r}: {wrong}") from None

    def _proved(self, title: str, left: Form, right: Form) -> Comparison:
        """Two forms are equal, or they are when the definitions on the page are put in."""
        if told := carrying(*parts(left), *parts(right)):
            raise FalseStep(f"step {title!r}: {told}")
        result = compare(left, right)
        if not result.equal and self.definitions:
            ours, theirs = ([self._meant(p) for p in parts(form)] for form in (left, right))
            meant = compare(ours, theirs)
            result = meant if meant.equal else result
        if result.equal:
            return result
        if result.equal is None:
            raise FalseStep(f"step {title!r} is undecided: {result.method}")
        at = ", ".join(f"{s} = {v}" for s, v in (result.point or {}).items())
        raise FalseStep(f"step {title!r} is false" + (f" at {at}" if at else ""))

    def _meant(self, form: Expr) -> Expr:
        """A form with what its names stand for on the page."""
        for _ in self.definitions:
            before = form
            for name, meaning in self.definitions:
                if isinstance(name, AppliedUndef):
                    form = form.replace(name.func, sp.Lambda(name.args, meaning))
                elif not meaning.has(name):
                    form = form.xreplace({name: meaning})
            if form == before:
                break
        return form

    def _add(self, block: Block) -> None:
        """Add an equation or a theorem, with its number."""
        if not block.lines and block.theorem is None:
            raise FalseStep(f"{block.title}: nothing is shown; give one line or more")
        for left, _, right in block.lines:
            in_latex(f"step {block.title!r}", left, right)
        self._count += 1
        self.blocks.append(replace(block, number=self._count))
