"""Terms as Rocq writes them: real ones in ``R``, those with j or with a complex symbol in ``C``.

Rocq's functions are total.  Where a term has no value here, 1/0 is *some* number there; so a
relation is printed with what its terms divide by (:mod:`symhaptic.rocq.propositions`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from typing import Any

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef
from sympy.printing.str import StrPrinter

from symhaptic.notation.terms import is_complex, symbols_in
from symhaptic.proof.ball import sign


class NotPrinted(ValueError):
    """What cannot be said in Rocq yet; the message says what it is."""


_RESERVED = (
    "as at cofix else end exists exists2 fix for forall fun if IF in let match mod Prop return Set "
    "then Type using where with R C N Z Q I S O E D PI INR IZR exp ln sin cos tan cot sqrt sinh "
    "cosh tanh atan pow Rabs Rpower true false nat whole increasing tends up stable hurwitz "
    "passive degree answers pole device swings Re Im Ci Lo Hi Ends Goal Fact"
)
_TAKEN = frozenset(_RESERVED.split())
"""Names that a variable would hide."""

_NAMES: Mapping[Any, str] = {
    **{f: f.__name__ for f in (sp.exp, sp.sin, sp.cos, sp.tan, sp.cot, sp.sinh, sp.cosh, sp.tanh)},
    sp.atan: "atan",
    sp.log: "ln",
    sp.Abs: "Rabs",
}


class Names:
    """Names of symbols in one lemma: the symbol's own, with a prime where two share it."""

    def __init__(self, other: str | None = None) -> None:
        self._of: dict[Symbol, str] = {}
        self.other = other
        """What is written for a symbol that is not bound; it is refused where there is nothing."""
        self.as_complex: set[Symbol] = set()
        """Bound symbols that are complex where they are bound, whatever their name says."""
        self.spelled: dict[Expr, str] = {}
        """Variables that stand for what is written so."""

    def __getitem__(self, symbol: Symbol) -> str:
        found = self._of.get(symbol, self.other)
        if found is None:
            raise NotPrinted(f"the symbol {symbol} is not bound")
        return found

    def __contains__(self, symbol: object) -> bool:
        return symbol in self._of

    def written(self, symbol: Symbol) -> str:
        """A symbol in a term: its name, or what it stands for."""
        return self.spelled.get(symbol) or self[symbol]

    @contextmanager
    def bound(self, *symbols: Symbol) -> Iterator[list[str]]:
        """Names for symbols that are bound meanwhile."""
        before = dict(self._of)
        for symbol in symbols:
            self._of.pop(symbol, None)
            self._of[symbol] = self.fresh(symbol.name)
        yield [self._of[s] for s in symbols]
        self._of = before

    @contextmanager
    def introduced(self, *symbols: Symbol) -> Iterator[list[str]]:
        """Names for symbols that a proof brings in beside all that are there."""
        before = dict(self._of)
        for symbol in symbols:
            self._of[symbol] = self.fresh(symbol.name)
        yield [self._of[s] for s in symbols]
        self._of = before

    def fresh(self, name: str) -> str:
        """A name that nothing has."""
        name = "".join(c for c in name if c.isascii() and (c.isalnum() or c == "_")).strip("_")
        name = f"{name or 'x'}_" if name in _TAKEN or name[:1].isdigit() or not name else name
        while name in self._of.values():
            name += "'"
        return name


def complex_(*terms: Expr) -> bool:
    """Whether one of them is no real number by its form."""
    return any(map(_complex, terms))


@cache
def _complex(term: Expr) -> bool:
    return bool(imaginary(term).has(sp.I)) or any(map(is_complex, symbols_in(term)))


@cache
def imaginary(term: Expr) -> Expr:
    """The same term, in which each root of a negative number is j times a real root.

    Rocq's ``sqrt`` is 0 where its argument is negative.  A real term has no imaginary part.

    >>> imaginary(1 + sp.sqrt(1 - sp.sqrt(2)) + sp.im(Symbol("omega")))
    1 + I*sqrt(-1 + sqrt(2))
    """
    parts = {f for f in term.atoms(sp.re, sp.im) if not complex_(f.args[0])}
    if parts:
        real = {f: f.args[0] if isinstance(f, sp.re) else sp.S.Zero for f in parts}
        return imaginary(term.xreplace(real))
    roots = {p: sp.I**p.exp.p * (-p.base) ** p.exp for p in term.atoms(sp.Pow) if _of_negative(p)}
    return imaginary(term.xreplace(roots)) if roots else term


@cache
def _of_negative(power: Expr) -> bool:
    of_number = is_root(power) and power.exp.q == 2 and not symbols_in(power.base)
    return of_number and not power.base.has(sp.I) and sign(power.base) == -1


@cache
def may_be_positive(of: Expr) -> bool:
    """Whether a term has symbols or is a positive number."""
    return bool(symbols_in(of)) or sign(of) == 1


def is_root(part: Expr) -> bool:
    """Whether an expression is a power whose exponent is a fraction."""
    return bool(part.is_Pow and part.exp.is_Rational and not part.exp.is_Integer)


class Real(StrPrinter):  # type: ignore[misc]
    """Prints real terms; what Rocq has no name for is refused."""

    def __init__(self, names: Names) -> None:
        super().__init__({"order": "lex"})
        self.names = names

    def emptyPrinter(self, expr: Any) -> str:
        """Refuse what is not known."""
        raise NotPrinted(f"{type(expr).__name__}")

    def _print_Symbol(self, expr: Symbol) -> str:
        return self.names.written(expr)

    _print_Dummy = _print_Symbol  # noqa: N815

    def _print_Rational(self, expr: Any) -> str:
        return f"{expr.p}/{expr.q}"

    def _print_Pi(self, expr: Any) -> str:
        return "PI"

    def _print_Exp1(self, expr: Any) -> str:
        return "exp(1)"

    def _print_ImaginaryUnit(self, expr: Any) -> str:
        return "Ci"

    def _print_Function(self, expr: Any) -> str:
        if isinstance(expr, AppliedUndef):
            raise NotPrinted(f"the unknown function {expr.func.__name__}")
        if expr.func not in _NAMES:
            raise NotPrinted(f"the function {expr.func.__name__}")
        if isinstance(expr, sp.log) and not may_be_positive(expr.args[0]):
            raise NotPrinted("the logarithm of a number that is not positive")
        return f"{_NAMES[expr.func]}({self._print(expr.args[0])})"

    _print_exp = _print_log = _print_Abs = _print_Function  # noqa: N815
    _print_re = _print_im = _print_conjugate = _print_Function

    def _print_Pow(self, expr: Any, rational: bool = False) -> str:
        base, power = expr.as_base_exp() if isinstance(expr, sp.exp) else expr.args
        if power.is_Rational and power < 0:
            below = self._raised(base, -power)
            return f"1/{below if power == -1 and base.is_Atom else f'({below})'}"
        return self._raised(base, power)

    def _raised(self, base: Expr, power: Expr) -> str:
        if power == 1:
            return str(self._print(base))
        if power.is_Integer:
            return f"{self.inside(base)}^{power}"
        if power.is_Rational and power.q == 2:
            root = f"sqrt({self._print(base)})"
            return root if power.p == 1 else f"{root}^{power.p}"
        if base.is_Rational and base > 0:
            return f"Rpower ({self._print(base)}) ({self._print(power)})"
        raise NotPrinted(f"{base} with the exponent {power}")

    def inside(self, base: Expr) -> str:
        """A base, in brackets unless it is a name or an application."""
        text = str(self._print(base))
        plain = base.is_Symbol or (base.is_Integer and base >= 0) or base.is_Function
        return text if plain or base is sp.pi else f"({text})"


_WRITTEN: dict[Any, str] = {}
"""Terms by how they are printed and with which names: most stand in many lemmas."""


def printed_by(printer: type[Real], expr: Expr, names: Names) -> str:
    """A term, which is printed only once with the same names."""
    expr = imaginary(expr)
    symbols = symbols_in(expr)
    said = frozenset((s, names.written(s), s in names.as_complex) for s in symbols)
    found = _WRITTEN.get(of := (printer, expr, said))
    if found is None:
        found = _WRITTEN[of] = str(printer(names)._print(expr))
    return found


def real_text(expr: Expr, names: Names) -> str:
    """A real term."""
    return printed_by(Real, expr, names)
