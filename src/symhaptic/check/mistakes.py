"""Which mistake it may be: what somebody's function gives, beside what known mistakes give.

Misprints are read from the paper's print, rules of thumb from those in circulation, and slips are
changes of the print in one place.  What is named is a guess at the cause, and no verdict.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import islice, permutations
from typing import Any, cast

import flint
import numpy as np
import sympy as sp

from symhaptic.bench.printed import dimensionless, in_units, limit, placed
from symhaptic.check import slips
from symhaptic.check.checked import Checked
from symhaptic.notation import alpha, beta, gamma
from symhaptic.paper import STATEMENTS
from symhaptic.proof.mutants import mutants
from symhaptic.rules import STATEMENTS as RULES

Point = tuple[float, ...]
Columns = list[Any]

_MOST = 0.95
"""Of the values that a mistake has to explain."""

_NEAR = 1e-9
"""A share of a value that is far more than rounding, and far less than single precision."""

_BY_CHANCE = 0.2
"""Of the values that are right in single precision as well, such as 0."""

_SLIPS = 400
"""Changes in one place that are tried."""

_CONDITIONS = ("eq6", "eq25")
"""Conditions of the paper that may be taken for a limit of something else."""

_SAMPLE = 400


def named(checked: Checked, some: Sequence[Point], got: Sequence[Point]) -> tuple[str, ...]:
    """Mistakes that give what was found where the formula itself does not."""
    few = list(zip(some, got, strict=True))[-_SAMPLE:]  # random points, behind the edges
    points, mine = [p for p, _ in few], np.array([g for _, g in few], dtype=float)
    columns = [np.array(column) for column in zip(*points, strict=True)]
    exact = _exact(checked, points)
    near = _share(exact, mine, 1e-5) > _MOST
    by = _NEAR if near else 1e-6  # what is nearly right is told from pi = 3.14159, too
    right = _share(exact, mine, by)
    ways = (name for name, values in _candidates(checked, columns)
            if _share(values, mine, by) > max(_MOST, right))  # fmt: skip
    names = list(islice(ways, 1))
    if near and _single(mine) and not _single(np.array(exact, dtype=float)):
        names.append("single precision: every result is a float32")
    elif not names and near and right < _BY_CHANCE:
        names.append("as far off as single precision, somewhere in between")
    if not names:
        names += _factors(checked, columns, exact, mine)
    if not names:
        too = "; where it is a number it is wrong, too" if _wrong(exact, mine) else ""
        names += [f"{name}{too}" for name in islice(_undefined(checked, some, got), 1)]
    return tuple(names)


def _candidates(checked: Checked, columns: Columns) -> Iterator[tuple[str, Columns]]:
    """Each mistake with what it gives."""
    with np.errstate(all="ignore"):
        yield from _ordered(checked, columns)
        for name, exprs in _written(checked):
            yield name, _values(checked, exprs)(columns)
        numbers = _numbers(checked)
        printed = _values(checked, _print(checked)) if checked.printed else numbers
        for name, taken in slips.taken(checked.ranges, columns):
            yield name, numbers(taken)  # behind a fraction of a period they are not the print
            yield name, printed(taken)
        yield from slips.given(numbers(columns))
        for name, expr in _rules(checked):
            yield name, _ruled(checked, expr, columns)


def _factors(checked: Checked, columns: Columns, exact: Columns, mine: Any) -> Iterator[str]:
    """The first result that is off by one factor, as by a unit or a forgotten period."""
    for name, right, column in zip(checked.results, exact, mine.T, strict=False):
        by = slips.factor(checked.ranges, columns, np.asarray(right, dtype=float), column)
        if by is not None:
            yield f"{name} is {by} times what is right"
            return


def _ordered(checked: Checked, columns: Columns) -> Iterator[tuple[str, Columns]]:
    """Results or arguments in another order than is asked for."""
    given = _values(checked, _print(checked)) if checked.printed else _numbers(checked)
    values = given(columns)
    count = min(len(values), len(checked.results))
    for order in islice(permutations(range(count)), 1, None):
        told = ", ".join(checked.results[i] for i in order)
        yield f"results are given in the order {told}", [values[i] for i in order]
    names = list(checked.ranges)
    for order in islice(permutations(range(len(names))), 1, None):
        taken = ",".join(names[order.index(i)] for i in range(len(names)))
        said = f"arguments are taken in another order; --arguments {taken}"
        yield said, given([columns[i] for i in order])


def _numbers(checked: Checked) -> Callable[[Columns], Columns]:
    """The package's own; nothing where it refuses an argument or takes long."""

    def given(columns: Columns) -> Columns:
        if checked.near is None or checked.balls < _SAMPLE:
            return []
        try:
            return list(checked.near(*columns))
        except ValueError:
            return []

    return given


def _print(checked: Checked, lines: Any = None) -> Sequence[sp.Expr]:
    """What is printed, or what these lines say, of each result."""
    read = in_units if {"T", "m"} & set(checked.ranges) else dimensionless
    return read(checked.printed, lines or STATEMENTS[checked.printed].printed)


def _written(checked: Checked) -> Iterator[tuple[str, Sequence[sp.Expr]]]:
    """What is printed, the same with sines for cosines, and with one thing changed."""
    if not checked.printed:
        return
    printed, called = _print(checked), f"({checked.printed.removeprefix('eq')})"
    yield f"this is {called} as printed; see the erratum of {checked.printed}", printed
    for form in (printed, *slips.also(checked.printed, printed)):
        for slip, change in slips.written(checked.whole):
            changed = [change(e) for e in form]
            if changed != list(form):
                yield f"this is {called} with {slip}", changed
    turns = {f: sp.cos(*f.args) for e in printed for f in e.atoms(sp.sin)}
    turns |= {f: sp.sin(*f.args) for e in printed for f in e.atoms(sp.cos)}
    yield f"this is {called} with sine and cosine swapped", [e.xreplace(turns) for e in printed]
    for s in {s: None for e in printed for s in e.free_symbols if s.name in checked.ranges}:
        for other in (s + 1, s - 1) if s.name in checked.whole else (2 * s, s / 2):
            yield f"this is {called} with {other} for {s}", [e.subs(s, other) for e in printed]
    if checked.printed in ("eq12", "eq14", "eq18"):  # each of their changes takes long to read
        return
    for mutant in islice(mutants(STATEMENTS[checked.printed].printed), _SLIPS):
        try:
            exprs = _print(checked, mutant.form)
        except (ZeroDivisionError, AttributeError):
            continue
        yield f"this is {called} with a slip: {mutant.change}", exprs


def _rules(checked: Checked) -> Iterator[tuple[str, sp.Expr]]:
    """The stiffness up to which a rule allows a wall."""
    if not (checked.id.startswith(("is_", "max_")) or "." in checked.id):
        return
    rules = [(s.says, s.id, s.printed) for s in RULES.values()]
    rules += [(f"({id[2:]}) is taken for it", id, STATEMENTS[id].printed) for id in _CONDITIONS]
    for says, id, printed in rules:
        (expr,) = limit([placed(line) for line in printed])
        told = f"a rule in circulation: {says}" if id in RULES else says
        yield f"{told}; see {id}", expr


def _ruled(checked: Checked, expr: sp.Expr, columns: Columns) -> Columns:
    """Whether a wall is allowed, or the largest stiffness that is."""
    at = dict(zip(checked.ranges, columns, strict=True))
    if "m" in at:
        size = at["m"] / at["T"] ** 2
        at |= {"gamma": at["k"] / size, "delta": at["b"] * at["T"] / at["m"]}
    else:
        size = 1.0
    names = [s for s in (beta, gamma, *expr.free_symbols) if s != beta or "beta" in at]
    expr = expr if "beta" in at else expr.subs(beta, 0)
    used = [s for s in dict.fromkeys(names) if s.name in at and s != alpha]
    allowed = sp.lambdify(used, expr, "numpy")(*(at[s.name] for s in used)) * size
    return [at["alpha"] < allowed] if "alpha" in at else [allowed]


def _values(checked: Checked, exprs: Sequence[sp.Expr]) -> Callable[[Columns], Columns]:
    """Expressions at points, complex as square roots may be; none where they fail."""
    names = {s.name: s for e in exprs for s in e.free_symbols}
    names |= {"theta": names["omega_hat"]} if "omega_hat" in names else {}
    arguments = tuple(names.get(name, sp.Symbol(name)) for name in checked.ranges)
    known = {s for e in exprs for s in e.free_symbols} <= set(arguments)
    if not known or any(e.has(sp.zoo, sp.oo, sp.nan) for e in exprs):
        return lambda columns: []
    function = _function(arguments, tuple(exprs))

    def given(columns: Columns) -> Columns:
        try:
            return [np.real(value) for value in function(*(c.astype(complex) for c in columns))]
        except ZeroDivisionError:
            return []

    return given


@cache
def _function(arguments: tuple[sp.Symbol, ...], exprs: tuple[sp.Expr, ...]) -> Callable[..., Any]:
    """Expressions as a function of arrays, made once for all that are checked."""
    down = {"floor": lambda x: np.floor(np.real(x))}
    return cast("Callable[..., Any]", sp.lambdify(arguments, exprs, [down, "numpy"], cse=True))


def _share(values: Sequence[Any], mine: Any, by: float) -> float:
    """The share of values that are near, of those that both have."""
    near = told = 0
    for right, column in zip(values, mine.T, strict=False):
        right = np.broadcast_to(np.asarray(right, dtype=float), column.shape)
        both = np.isfinite(right) & np.isfinite(column)
        told += int(both.sum())
        away = np.abs(column[both] - right[both])
        near += int((away <= by * np.maximum(np.abs(right[both]), 1e-12)).sum())
    return near / told if told > mine.shape[0] // 4 else 0.0


def _exact(checked: Checked, points: Sequence[Point]) -> Columns:
    """Exact values as floats; NaN where there are none."""
    with flint.ctx.workprec(256):
        rows = [[math.nan if v is None else float(v) for v in checked.exact(*p)] for p in points]
    return list(np.array(rows).T)


def _single(mine: Any) -> bool:
    """Whether all numbers are floats of single precision."""
    values = mine[np.isfinite(mine) & (np.abs(mine) < 1e38)]
    return bool(values.size and (values.astype(np.float32) == values).all())


def _wrong(exact: Columns, mine: Any) -> bool:
    """Whether more than cancellation parts the numbers that are there from what is right."""
    right = np.array(exact).T[:, : mine.shape[1]]
    both = np.isfinite(right) & np.isfinite(mine[:, : right.shape[1]])
    away = np.abs(mine[:, : right.shape[1]] - right)[both]
    far = away > 1e-2 * np.maximum(np.abs(right[both]), 1e-12)
    return bool(far.size and far.mean() > 1 - _MOST)


def _undefined(checked: Checked, some: Sequence[Point], got: Sequence[Point]) -> Iterator[str]:
    """NaN where what is printed has no value either."""
    if not checked.printed:
        return
    nothing = [p for p, g in zip(some, got, strict=True) if any(map(math.isnan, g))][-_SAMPLE:]
    if not nothing:
        return
    with np.errstate(all="ignore"):
        columns = [np.array(column) for column in zip(*nothing, strict=True)]
        values = _values(checked, _print(checked))(columns)
    at = dict(zip(checked.ranges, columns, strict=True))
    if {"b", "k", "m"} <= at.keys() and (at["b"] ** 2 < 4 * at["k"] * at["m"]).all():
        yield "NaN where the device swings: a real square root of b^2 - 4km"
    elif {"gamma", "delta"} <= at.keys() and (at["delta"] ** 2 < 4 * at["gamma"]).all():
        yield "NaN where the device swings: a real square root of delta^2 - 4 gamma"
    elif all(not np.isfinite(np.asarray(v)).any() for v in values[:1]):
        called = f"({checked.printed.removeprefix('eq')})"
        yield f"0/0 where {called} as printed is 0/0; see the erratum of {checked.printed}"
