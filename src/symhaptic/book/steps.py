"""Steps that are proved as they are written down: what a chapter does before it settles anything.

A step is proved or raises :class:`FalseStep`.  A ``name`` says what the first expression is called:
a symbol, an unknown function, or LaTeX that is no formula of known symbols; a formula in known
symbols has to be equal to that expression.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Sequence
from typing import Any

import sympy as sp
from flint import arb
from sympy import Expr
from sympy.core.function import AppliedUndef

from symhaptic.book.record import Block, Evidence, FalseStep, Record
from symhaptic.notation import FUNCTIONS
from symhaptic.notation.latex import is_sum, latex
from symhaptic.notation.terms import is_complex
from symhaptic.notation.written import chains, written
from symhaptic.paper.reading import Unreadable, names_something, read, undressed
from symhaptic.proof.decide import Comparison, compare
from symhaptic.proof.enclosed import Source, enclosed
from symhaptic.proof.names import alike, carrying
from symhaptic.proof.normal import is_zero
from symhaptic.proof.points import outside
from symhaptic.proof.roots import Algebraic, begins_with, decimals, is_minimal, real_roots
from symhaptic.proof.shape import Form, parts
from symhaptic.proof.theorems.definedness import real
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.proof.units import UnitError, dimension_of, of_another_unit, shown


class Steps(Record):
    """A page as far as it is written down step by step; see the module for what is proved."""

    # -- prose and definitions ----------------------------------------------------------

    def say(self, text: str) -> None:
        """A paragraph; formulas between dollar signs."""
        self.blocks.append(Block("prose", text=text))

    def define(self, title: str, name: Expr | str, meaning: Expr, because: str = "") -> Expr:
        """``name`` stands for ``meaning`` from here on; its units must agree."""
        formula = self._read_name(title, name)
        size = isinstance(formula, sp.Abs) and isinstance(meaning, sp.Abs)
        if formula is not None and not (formula.atoms(AppliedUndef) or size):
            raise FalseStep(f"{title}: {name} is no name; a symbol or an unknown function is")
        try:
            unit = shown(dimension_of(meaning))
        except UnitError as wrong:
            raise FalseStep(f"{title}: {wrong}") from None
        if isinstance(name, Expr) and (other := of_another_unit(name, meaning)):
            raise FalseStep(f"{title}: {other}")
        self._defined(name, meaning)
        note = "units agree" if unit == "1" else f"units agree: {unit}"
        self._show(title, because, [(name, "=", meaning)], "definition", note)
        return meaning

    def _show(
        self,
        title: str,
        because: str,
        lines: Sequence[tuple[Any, str, Any]],
        verdict: str,
        how: str | Comparison,
        **given: Any,
    ) -> None:
        self._add(Block("equation", title, because, tuple(lines), verdict, how, **given))

    def limits(self, expr: Expr, variable: sp.Symbol, at: Expr, value: Expr) -> Evidence:
        """A limit proved without being written on the page."""
        self._tends("limit", expr, variable, at, value)
        return Evidence("exact series")

    def _defined(self, name: Expr | str | None, meaning: Expr, once: bool = True) -> None:
        """Keep what a name stands for: not itself, and one thing.

        A statement that is a definition may say what the name means in one of several cases.
        """
        if not isinstance(name, (sp.Symbol, AppliedUndef)):
            return
        if told := carrying(name, meaning) or alike(name, meaning):
            raise FalseStep(f"{name}: {told}")
        if once and name in self._meant(meaning).atoms(type(name)):
            raise FalseStep(f"{name} is defined by itself")
        for other, before in self.definitions:
            if once and other == name and not compare(*map(self._meant, (before, meaning))).equal:
                raise FalseStep(f"{name} stands for more than one thing on the page: {before}")
        number = self._meant(meaning)
        if not (number.free_symbols or number.atoms(AppliedUndef)) and outside(name, number):
            raise FalseStep(f"{name} is never {meaning}: it has another domain in the notation")
        if meaning.has(sp.I) and not _may_stand_for(name, meaning):
            raise FalseStep(f"{name} is real; {meaning} is not, by its form")
        self.definitions.append((name, meaning))

    # -- steps --------------------------------------------------------------------------

    def step(
        self,
        title: str,
        *chain: Expr,
        because: str = "",
        name: Expr | str | None = None,
        boxed: bool = False,
        paper: str = "",
    ) -> Expr:
        """A chain of equal expressions, each proved equal to the one before; the last is returned.

        With a ``name`` the first expression is what the name stands for and is not written;
        ``paper`` is the number of the paper's equation, shown beside ours.
        """
        if len(chain) < 2:
            raise FalseStep(f"{title}: a step needs two sides")
        for side in parts(chain):
            if not isinstance(side, Expr):
                raise FalseStep(f"{title}: {side} is no expression; a lemma shows a relation")
        if told := alike(*parts(chain)):
            raise FalseStep(f"step {title!r}: {told}")
        how: str | Comparison = ""
        for left, right in itertools.pairwise(chain):
            how = self._proved(title, left, right)
        self._is_name(title, name, chain[0])
        self._defined(name, chain[0])
        written = chain if name is None else chain[1:]
        left = written[0] if name is None else name
        rights = written[1:] if name is None else written
        lines = [(left if i == 0 else "", "=", right) for i, right in enumerate(rights)]
        self._show(title, because, lines, "proved", how, boxed=boxed, paper=paper)
        return chain[-1]

    def _is_name(self, title: str, name: Expr | str | None, means: Expr) -> None:
        """Refuse a name that is a formula in known symbols and does not say what it stands for."""
        formula = self._read_name(title, name)
        if formula is not None:
            self._proved(title, formula, means)

    def _read_name(self, title: str, name: Expr | str | None) -> Expr | None:
        """The formula that a name is; None for a symbol, an unknown function, or other LaTeX."""
        if isinstance(name, str):
            try:
                forms = read(undressed(name))
            except Unreadable:
                if not names_something(name):
                    raise FalseStep(f"{title}: {name} is no name") from None
                return None
            if len(forms) != 1 or not isinstance(forms[0], Expr):
                raise FalseStep(f"{title}: {name} is no name")
            name = forms[0]
        return None if isinstance(name, (sp.Symbol, AppliedUndef)) else name

    def lemma(
        self, title: str, theorem: Theorem, because: str = "", boxed: bool = False
    ) -> Theorem:
        """A theorem of the kernel: its hypotheses, and what they imply."""
        if type(theorem) is not Theorem:
            raise FalseStep(f"{title}: {theorem!r} is no theorem")
        if told := alike(*theorem.conclusion.free.union(*(p.free for p in theorem.hypotheses))):
            raise FalseStep(f"step {title!r}: {told}")
        how = "a theorem of the kernel"
        self._add(Block("theorem", title, because, (), "proved", how, boxed=boxed, theorem=theorem))
        return theorem

    def minimal(
        self, title: str, numbers: Sequence[tuple[str, Algebraic]], because: str = ""
    ) -> None:
        """Minimal polynomials of numbers, each the smallest positive root of its own."""
        for name, number in numbers:
            if number.positive_roots_below:
                raise FalseStep(f"{title}: {name} has a smaller positive root")
            if not is_minimal(number):
                raise FalseStep(f"{title}: {name} has another minimal polynomial")
        lines = [(name, "=", number.minimal) for name, number in numbers]
        method = r"irreducible over $\mathbb{Q}$; balls around the roots"
        self._show(title, because, lines, "proved", method)

    def enclosed(
        self,
        title: str,
        values: Sequence[tuple[Expr | str, Source]],
        because: str = "",
        places: int = 24,
    ) -> None:
        """Positive numbers by their first decimals, which the balls around them settle.

        A number is given by what shows it, and a name that is a number has these decimals, too.
        """
        if places < 1:
            raise FalseStep(f"{title}: {places} decimals; at least one is shown")
        rows = []
        for pair in values:
            if not (isinstance(pair, tuple) and len(pair) == 2):
                raise FalseStep(f"{title}: {pair!r} is no pair of a name and what shows its number")
            name, source = pair
            value = self._shown(source)
            text = decimals(value, places)
            number = self._read_name(title, name)
            if number is not None and number.free_symbols:
                raise FalseStep(f"{title}: {name} is no name; give an expression without symbols")
            if number is not None:
                own = enclosed(number).ball
                if not (begins_with(own, text) and own.overlaps(value)):
                    raise FalseStep(f"{title}: {name} is not {text}...")
            rows.append((name, "=", text + r"\ldots"))
        self._show(title, because, rows, "enclosed", "ball arithmetic")

    def _shown(self, source: Source) -> arb:
        """A ball, whose certificates are kept."""
        number = enclosed(source)
        self.certificates += number.certificates
        return number.ball

    def limit(
        self,
        title: str,
        expr: Expr,
        variable: sp.Symbol,
        at: Expr,
        value: Expr,
        because: str = "",
        name: Expr | str | None = None,
    ) -> Expr:
        """The limit of ``expr`` as ``variable`` tends to ``at`` is ``value``, by exact series.

        The conditions under which this was shown are written below it.
        """
        theorem = self._tends(title, expr, variable, at, value)
        if told := alike(expr, variable, at, value):
            raise FalseStep(f"step {title!r}: {told}")
        self._is_name(title, name, expr)
        inner = name if isinstance(name, str) else latex(expr if name is None else name)
        inner = rf"\bigl({inner}\bigr)" if name is None and is_sum(inner) else inner
        left = rf"\lim_{{{latex(variable)}\to {latex(at)}}} {inner}"
        given = ",\\ ".join(chains(sorted(theorem.hypotheses, key=written)))
        why = "; ".join(filter(None, [f"for ${given}$" if given else "", because]))
        self._show(title, why, [(left, "=", value)], "proved", "exact series")
        return value

    def free_of(self, what: str, expr: Expr, *symbols: sp.Symbol) -> Evidence:
        """``expr`` contains the symbols and does not change with them.

        Its difference for two values of a symbol is zero in the normal form.
        """
        if not symbols:
            raise FalseStep(f"{what}: no symbol is given; give those that drop out")
        for symbol in symbols:
            if symbol not in expr.free_symbols:
                raise FalseStep(f"{what}: {symbol} is not in it, so nothing is shown to drop out")
            if not is_zero(expr - expr.xreplace({symbol: sp.Dummy(symbol.name)})):
                raise FalseStep(f"{what}: it changes with {symbol}")
        names = ", ".join(f"${latex(s)}$" for s in symbols)
        return Evidence(f"the same for any two values of {names}")

    def all_zeros(
        self, what: str, coefficients: Sequence[arb], lower: arb, upper: arb, zeros: Sequence[arb]
    ) -> Evidence:
        """A real polynomial (lowest power first) has these zeros in an interval, and no other."""
        if not (lower.is_finite() and upper.is_finite() and lower <= upper):
            raise FalseStep(f"{what}: {lower} to {upper} is no interval")
        found = [y for y in real_roots(tuple(coefficients)) if not (y < lower or y > upper)]
        if len(found) != len(zeros) or not all(map(arb.overlaps, found, zeros)):
            raise FalseStep(f"{what}: these are not all the zeros")
        return Evidence("balls around all roots of the polynomials")

    def same(self, what: str, *forms: Form) -> Evidence:
        """All the forms are proved equal, without being written on the page.

        Where SymPy makes one expression of two forms as it evaluates them, the method says so.
        """
        how: str | Comparison = ""
        if len(forms) < 2:
            raise FalseStep(f"{what}: a comparison needs two sides")
        for left, right in itertools.pairwise(forms):
            how = self._proved(what, left, right)
            if parts(left) == parts(right):
                how = "both sides evaluate to one expression"
        return Evidence(how)

    def table(self, caption: str, head: Sequence[str], rows: Sequence[Sequence[Any]]) -> None:
        """Columns of numbers or formulas as they were computed; text may hold formulas in $."""
        for row in rows:
            if len(row) != len(head):
                raise ValueError(f"table: {len(row)} cells under {len(head)} heads: {row}")
        cells = (tuple(head), *(tuple(row) for row in rows))
        self.blocks.append(Block("table", text=caption, rows=cells))

    def figure(
        self,
        name: str,
        caption: str,
        draw: Callable[..., None],
        panels: tuple[int, int] = (1, 1),
        height: float = 0.62,
    ) -> None:
        """A plot: ``draw(axes)`` is called by the report, with Matplotlib's axes.

        ``panels`` are rows and columns, ``height`` is in widths of the text; ``draw`` gets the
        array of axes where there are several panels.
        """
        if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_.-]*", name):
            raise FalseStep(
                f"figure {name!r}: a file is named so; use letters and digits of ASCII, '-', '_' "
                "and '.'"
            )
        self.blocks.append(
            Block("figure", title=name, text=caption, draw=draw, panels=panels, height=height)
        )


def _may_stand_for(name: Expr, meaning: Expr) -> bool:
    """Whether what is real stands for what is real by its form.

    A function of the paper has real coefficients: it is real where its argument is.
    """
    if isinstance(name, sp.Symbol):
        return is_complex(name) or real(meaning)
    at_real = {s: sp.Dummy() for s in meaning.free_symbols if is_complex(s)}
    return name.func.__name__ not in FUNCTIONS or real(meaning.xreplace(at_real))
