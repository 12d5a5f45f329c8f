"""The paper's forms, printed or derived, as functions of a stable form's arguments."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.book.chapters import run, shipped
from symhaptic.book.listing import needed
from symhaptic.forms.stable import STATEMENTS, Form
from symhaptic.notation import (
    B,
    K,
    T,
    alpha,
    b,
    beta,
    c_1,
    d,
    delta,
    gamma,
    k,
    m,
    omega,
    t_d,
    theta,
    z,
)
from symhaptic.paper import STATEMENTS as PRINTED

_UNITS = {K: alpha, B: beta, k: gamma, T: sp.S.One, b: delta, m: sp.S.One, omega: theta, t_d: d}
_UNITS[Symbol("omega_hat")] = theta
"""From the paper's symbols to the dimensionless parameters of Table I."""


@cache
def expressions(form: Form, kind: str) -> tuple[Expr, ...]:
    """The published or the derived formula of each result.

    Only the units and the abbreviations (15) are substituted.  Empty if the paper has no such
    formula.
    """
    ids = STATEMENTS.get(form.name)
    if ids is None:
        return ()
    return dimensionless(ids[0], _lines(ids[0], kind))


def results(found: Sequence[Expr], short: str = "eq15") -> tuple[Expr, ...]:
    """Formulas without abbreviations."""
    written = {line.lhs: line.rhs for line in PRINTED[short].printed}
    root = {c_1: written.pop(c_1)}
    return tuple(expr.xreplace(written).xreplace(root) for expr in found)


def dimensionless(id: str, lines: Sequence[Any]) -> tuple[Expr, ...]:
    """The formula of each result in the parameters of Table I."""
    return results(_READ.get(id, _sides)([placed(line) for line in lines]))


def in_units(id: str, lines: Sequence[Any]) -> tuple[Expr, ...]:
    """The same in SI units."""
    return results(_transfer(list(lines)) if id == "eq12" else _sides(list(lines)), "eq13")


def function(form: Form, kind: str, modules: str) -> Callable[..., list[Any]]:
    """The same as a function of numbers; complex where the abbreviation c_1 is."""
    found: Callable[..., list[Any]] = sp.lambdify(
        form.arguments, expressions(form, kind), modules, cse=True
    )
    return found


def swings(form: Form, kind: str) -> bool:
    """Whether square roots make the numbers complex."""
    roots = (p for e in expressions(form, kind) for p in e.atoms(sp.Pow))
    return any(p.exp.is_Rational and not p.exp.is_Integer for p in roots)


@cache
def _lines(id: str, kind: str) -> tuple[Any, ...]:
    """One relation for each line; only the chapter that derives it is run."""
    if kind == "printed":
        return tuple(PRINTED[id].printed)
    settled = [run(path).page.settled for path in needed([id], shipped())]
    return tuple(next(found[id] for found in settled if id in found).settlement.derived)


def placed(line: Any) -> Any:
    """A line in the parameters of Table I."""
    names = {s: _UNITS.get(s, _UNITS.get(Symbol(s.name), s)) for s in line.free_symbols}
    return line.xreplace(names)


def _sides(lines: list[Any]) -> list[Expr]:
    return [line.rhs for line in lines]


def _gap(lines: list[Any]) -> list[Expr]:
    """By how much an inequality holds."""
    return [lines[0].gts - lines[0].lts]


def limit(lines: list[Any]) -> list[Expr]:
    """The alpha at which an inequality, linear in it, is an equality."""
    (gap,) = _gap(lines)
    return [-gap.subs(alpha, 0) / sp.diff(gap, alpha)]


def _coefficient(expr: Expr, power: int) -> Expr:
    """The coefficient of a power of z, by derivatives: nothing is expanded."""
    return sp.diff(expr, z, power).subs(z, 0) / sp.factorial(power)


def _transfer(lines: list[Any]) -> list[Expr]:
    """n1, n0, a and e of a transfer function."""
    top, bottom = sp.fraction(lines[0].rhs)
    lead = _coefficient(bottom, 2)
    one, nought = _coefficient(top, 1) / lead, _coefficient(top, 0) / lead
    return [one, nought, -_coefficient(bottom, 1) / lead, _coefficient(bottom, 0) / lead]


def _polynomial(lines: list[Any]) -> list[Expr]:
    """Coefficients of the monic polynomial for a delay of one period, highest power first."""
    expr = lines[0].rhs.subs(d, 1)
    found = [_coefficient(expr, power) for power in range(4, -1, -1)]
    return [c / found[0] for c in found]


_READ = {"eq5": _gap, "eq14": _transfer, "eq18": _polynomial, "eq25": limit}
