"""Slips that are usual where a formula becomes code: of what is written, of arguments, of results.

A slip is what it is called and a change; :mod:`symhaptic.check.mistakes` compares with somebody's
function what the changed formula gives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
import sympy as sp
from sympy import Expr, Symbol

Columns = list[Any]
Written = Callable[[Expr], Expr]

_TURNING = (sp.tan, sp.sin, sp.cos)
_BY: dict[str, Expr] = {"twice the angle": sp.Integer(2), "half the angle": sp.Rational(1, 2)}
_BY |= {"the angle as degrees": sp.pi / 180, "the angle turned into degrees": 180 / sp.pi}
_PI = {"3.14": "3.14", "3.1416": "3.1416", "3.14159": "3.14159", "22/7": "22/7"}


def written(whole: Sequence[str]) -> Iterator[tuple[str, Written]]:
    """Changes of a formula; ``whole`` are arguments that are whole numbers.

    >>> from sympy.abc import x
    >>> dict(written([]))["half the angle in tan"](sp.tan(x))
    tan(x/2)
    """
    for said, by in _BY.items():
        for one in _TURNING:
            yield f"{said} in {one}", partial(_turned, some=(one,), by=by)
        yield f"{said} in tan, sin and cos", partial(_turned, some=_TURNING, by=by)
    yield "1/2 as a division of whole numbers, 0", _halves
    yield "a division of whole numbers, rounded down", partial(_floored, whole=whole)
    yield "the absolute value left out", lambda e: e.replace(sp.Abs, lambda x: x)
    yield "the square root left out", partial(_powers, old=sp.Rational(1, 2))
    yield "a square left out", partial(_powers, old=sp.Integer(2))
    for said, value in _PI.items():
        yield f"{said} for pi", partial(_with_pi, value=sp.Rational(value))


def also(id: str, printed: Sequence[Expr]) -> Iterator[Sequence[Expr]]:
    """The same equation as it is written elsewhere, as with half the angle in a tangent."""
    if id == "eq11":
        names = {s.name: s for e in printed for s in e.free_symbols}
        b, d = names["b"] if "b" in names else names["delta"], names["d"]
        period = names.get("T", sp.S.One)
        yield [b * 2 / period * sp.tan(sp.pi / (4 * (d + 1))), *printed[1:]]


def _turned(e: Expr, some: Sequence[Any], by: Expr) -> Expr:
    for one in some:
        e = e.replace(one, lambda x, f=one: f(by * x))
    return e


def _halves(e: Expr) -> Expr:
    """Sums with a half in them, such as d + 1/2."""
    return e.replace(
        lambda x: x.is_Add and any(a.is_Rational and a.q > 1 for a in x.args),
        lambda x: sp.Add(*(sp.floor(a) if a.is_Rational else a for a in x.args)),
    )


def _floored(e: Expr, whole: Sequence[str]) -> Expr:
    """Quotients of whole numbers, such as d/(d + 1)."""

    def quotient(x: Expr) -> bool:
        below = sp.fraction(x)[1]
        names = {s.name for s in x.free_symbols}
        return bool(x.is_Mul and below != 1 and names and names <= set(whole) and not x.has(sp.pi))

    return e.replace(
        quotient, lambda x: -sp.floor(-x) if x.could_extract_minus_sign() else sp.floor(x)
    )


def _powers(e: Expr, old: Expr) -> Expr:
    return e.replace(lambda x: x.is_Pow and x.exp == old, lambda x: x.base)


def _with_pi(e: Expr, value: Expr) -> Expr:
    return e.xreplace({sp.pi: value})


_UNITS = {
    "T": ("taken in milliseconds", 1e3),
    "t_d": ("taken in milliseconds", 1e3),
    "m": ("taken in grams", 1e3),
    "omega": ("taken in Hz, and turned into rad/s", 2 * np.pi),
    "theta": ("taken as degrees", np.pi / 180),
}
"""Units in which an argument may be expected; what it is multiplied by."""


def taken(ranges: Mapping[str, Any], columns: Columns) -> Iterator[tuple[str, Columns]]:
    """Arguments as they are misunderstood."""
    at = dict(zip(ranges, columns, strict=True))
    for name, (said, by) in _UNITS.items():
        if name in at:
            yield f"{name} is {said}", list((at | {name: at[name] * by}).values())
            yield (
                f"{name} is {said}, the other way around",
                list((at | {name: at[name] / by}).values()),
            )
    if {"T", "d"} <= at.keys():
        yield (
            "d is taken in seconds, not in periods",
            list((at | {"d": at["d"] / at["T"]}).values()),
        )
    if {"T", "t_d"} <= at.keys():
        yield (
            "t_d is taken in periods, not in seconds",
            list((at | {"t_d": at["t_d"] * at["T"]}).values()),
        )
    for name in at:
        yield f"{name} is taken twice", list((at | {name: 2 * at[name]}).values())
        yield f"half of {name} is taken", list((at | {name: at[name] / 2}).values())


def given(values: Columns) -> Iterator[tuple[str, Columns]]:
    """Results as they are spoilt behind a right formula."""
    if any(np.asarray(v).dtype == bool for v in values):
        yield "true and false are exchanged", [~np.asarray(v, dtype=bool) for v in values]
        return
    yield "the sign of all results is turned", [-v for v in values]
    yield "negative results are cut off at 0", [np.maximum(v, 0) for v in values]
    yield "results are given without their sign", [np.abs(v) for v in values]
    yield "results are rounded down to whole numbers", [np.floor(v) for v in values]
    yield "angular frequencies are given in Hz", [v / (2 * np.pi) for v in values]


def factor(ranges: Mapping[str, Any], columns: Columns, right: Any, mine: Any) -> str | None:
    """A constant times powers of the arguments by which a result is wrong; None where it is not.

    >>> T = np.array([1.0, 2.0, 3.0, 5.0, 7.0, 8.0])
    >>> factor({"T": ()}, [T], T**2, 2 * T)
    '2/T'
    """
    told = np.isfinite(right) & np.isfinite(mine) & (right != 0) & (mine != 0)
    used = [np.asarray(column, dtype=float) for column in columns]
    for column in used:
        told &= column > 0
    if told.sum() < 3 * (len(used) + 1) or np.ptp(np.sign(mine[told] / right[told])):
        return None
    rows = np.column_stack([np.ones(told.sum()), *(np.log(column[told]) for column in used)])
    wanted = np.log(np.abs(mine[told] / right[told]))
    found = np.linalg.lstsq(rows, wanted, rcond=None)[0]
    powers = np.round(2 * found[1:]) / 2
    constant = float(np.exp(np.median(wanted - rows[:, 1:] @ powers)))
    if np.abs(wanted - rows[:, 1:] @ powers - np.log(constant)).max() > 1e-6:
        return None
    sign = -1 if mine[told][0] / right[told][0] < 0 else 1
    if sign * constant == 1 or (not powers.any() and abs(sign * constant - 1) < 1e-4):
        return None
    found_ = {
        name: sp.Rational(p).limit_denominator(2) for name, p in zip(ranges, powers, strict=True)
    }
    near = sp.Rational(constant).limit_denominator(1000)
    plain = near.p <= 1000 and abs(near - constant) <= 1e-7 * constant
    number = sign * (near if plain else sp.Float(constant, 6))
    return str(sp.Mul(number, *(Symbol(n, positive=True) ** p for n, p in found_.items())))
