"""Symbols of one name are one symbol, whatever is assumed of them in one place or another."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache

import sympy as sp
from sympy import Expr
from sympy.core.function import Application, AppliedUndef
from sympy.core.relational import Relational

from symhaptic.notation import SYMBOLS
from symhaptic.notation.latex import latex
from symhaptic.proof.rewriting import Unsupported

Names = Mapping[sp.Symbol, sp.Symbol]
"""The symbols that another one stands for."""


def shared(caller: str, symbols: Iterable[sp.Symbol]) -> Names:
    """Of several symbols with one name the one of which all is assumed that is of any.

    Raises :class:`ValueError` where the assumptions contradict each other.

    >>> x, p = sp.Symbol("x"), sp.Symbol("x", positive=True)
    >>> shared("prove", [x, p]) == {x: p}, shared("prove", [x, sp.Symbol("y")])
    (True, {})
    """
    by_name: dict[str, set[sp.Symbol]] = {}
    for symbol in symbols:
        if type(symbol) is sp.Symbol:
            by_name.setdefault(symbol.name, set()).add(symbol)
    names: dict[sp.Symbol, sp.Symbol] = {}
    for name, same in by_name.items():
        if len(same) > 1:
            one = _joined(caller, name, same)
            names |= {symbol: one for symbol in same if symbol != one}
    return names


def _joined(caller: str, name: str, same: set[sp.Symbol]) -> sp.Symbol:
    known: dict[str, bool] = {}
    for symbol in sorted(same, key=lambda s: len(s.assumptions0)):
        for what, holds in symbol.assumptions0.items():
            if known.setdefault(what, holds) != holds:
                raise ValueError(
                    f"{caller}: {name} is assumed to be {what} in one place and not to be in "
                    "another; one symbol of a name is needed"
                )
    try:
        return sp.Symbol(name, **known)
    except ValueError as wrong:  # no pair contradicts itself, but all of them together do
        raise ValueError(f"{caller}: {name}: the assumptions contradict each other") from wrong


def renamed(form: Expr, names: Names) -> Expr:
    """An expression or relation with its symbols replaced, and nothing evaluated.

    >>> x, y = sp.symbols("x y")
    >>> renamed(sp.Add(1 / x, -1 / y, evaluate=False), {y: x})
    -1/x + 1/x
    """
    return replaced(form, names.get) if names else form


def replaced(form: Expr, by: Callable[[Expr], Expr | None]) -> Expr:
    """A form with parts replaced by what is given for them (None: nothing), not evaluated.

    SymPy would cancel what need not be defined.  Raises :class:`Unsupported` where a part to be
    replaced stands in something else than a sum, a product, a power, a function or a relation.
    """
    known: dict[Expr, Expr] = {}

    def again(part: Expr) -> Expr:
        if part not in known:
            new = by(part)
            if new is None and part.args:
                inner = tuple(map(again, part.args))
                if any(one is not other for one, other in zip(inner, part.args, strict=True)):
                    if not isinstance(part, _WRITTEN):
                        raise Unsupported(f"{type(part).__name__} is not supported: {part}")
                    new = part.func(*inner, evaluate=False)
            known[part] = part if new is None else new
        return known[part]

    return again(form)


_WRITTEN = (sp.Add, sp.Mul, sp.Pow, Application, Relational)


def carrying(*forms: Expr) -> str | None:
    """Of which symbol or unknown function of some forms something is assumed, if of any.

    >>> x = sp.Symbol("x", positive=True)
    >>> carrying(sp.Symbol("y") ** 2), carrying(x < 1)
    (None, 'x carries assumptions; its domain in the notation is all that is known of it')
    """
    one = next((found for found in map(_carrying, forms) if found is not None), None)
    known = "its domain in the notation is all that is known of it"
    return None if one is None else f"{one} carries assumptions; {known}"


@lru_cache(maxsize=1 << 14)
def _carrying(form: Expr) -> Expr | None:
    for symbol in form.free_symbols:
        if len(symbol.assumptions0) > 1:  # more than that it commutes
            return symbol
    unknown = (f.func for f in form.atoms(AppliedUndef))
    return next((f for f in unknown if f._kwargs.keys() - {"commutative"}), None)


_TAKEN = {entry.latex for entry in SYMBOLS.values()} | {r"\pi", "e", "j", r"\mathrm{e}"}
_NO_NAME = re.compile(
    r"^[^A-Za-z\\]|[=<>+*/]|\\(?:n?eq?|leq?|geq?|not|in|approx|sim|equiv|cdot|times|frac|sqrt|sum|int)"
    r"(?![A-Za-z])"
)
"""LaTeX that is read as something else than a name."""


def alike(*forms: Expr) -> str | None:
    """Which name in some forms is printed as another one or as a formula, if one is.

    >>> x = sp.Symbol("x")
    >>> alike(x + sp.Dummy("x"))
    'two symbols are printed as x'
    >>> alike(sp.Symbol("pi") ** 2), alike(x**2)
    ("the name 'pi' is printed as \\\\pi", None)
    """
    forms, known = tuple(map(sp.sympify, forms)), dict[str, Expr]()
    for symbol in {s for form in forms for s in form.free_symbols}:
        printed = latex(symbol).strip()
        own = symbol.name not in SYMBOLS
        if own and (printed in _TAKEN or _NO_NAME.search(printed)):
            return f"the name {symbol.name!r} is printed as {printed}"
        if known.setdefault(printed, symbol) != symbol:
            return f"two symbols are printed as {printed}"
    for function in {f.func.__name__ for form in forms for f in form.atoms(AppliedUndef)}:
        command = function.removeprefix("\\")
        if _NO_NAME.search(function) or hasattr(sp.functions, command):
            return f"the name {function!r} is printed as a formula"
    return None


def admissible(symbol: Expr, value: Expr) -> bool:
    """Whether a number is known to be all that a symbol is assumed to be.

    >>> n = sp.Symbol("n", integer=True)
    >>> admissible(n, sp.S(2)), admissible(n, sp.S.Half), admissible(sp.Symbol("x"), sp.S.Half)
    (True, False, True)
    """
    return all(
        getattr(value, f"is_{what}", None) is holds for what, holds in symbol.assumptions0.items()
    )
