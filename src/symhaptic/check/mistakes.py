"""Which common error it may be: what somebody's function gives, beside what known errors give.

Misprints are read from the paper, rules of thumb from those in circulation; other errors change the
equation as published, its arguments or its results.  What is named is a guess at the cause, and no
verdict.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from itertools import islice, permutations
from typing import Any, cast

import numpy as np
import sympy as sp
from sympy import Expr, Symbol

from symhaptic.bench.printed import dimensionless, in_units, limit, placed
from symhaptic.check.checked import Checked, Point, exact
from symhaptic.notation import alpha, beta, gamma
from symhaptic.paper import STATEMENTS
from symhaptic.proof.mutants import mutants
from symhaptic.rules import PLAIN as RULES

Columns = list[Any]

_MOST = 0.95
"""Of the values that an error has to explain."""
_NEAR = 1e-9
"""A share of a value that is far more than rounding, and far less than single precision."""
_BY_CHANCE = 0.2
"""Of the values that are right in single precision as well, such as 0."""
_CHANGES = 400
"""Changes of the published equation in one place that are tried."""
_SAMPLE = 400

_TURNING = (sp.tan, sp.sin, sp.cos)
_ANGLES: tuple[tuple[str, Expr], ...] = (
    ("twice the angle", sp.Integer(2)),
    ("half the angle", sp.Rational(1, 2)),
    ("the angle as degrees", sp.pi / 180),
    ("the angle turned into degrees", 180 / sp.pi),
)
_PI = ("3.14", "3.1416", "3.14159", "22/7")
_TAKEN = (
    ("T", "taken in milliseconds", 1e3),
    ("t_d", "taken in milliseconds", 1e3),
    ("m", "taken in grams", 1e3),
    ("omega", "taken in Hz, and turned into rad/s", 2 * np.pi),
    ("theta", "taken as degrees", np.pi / 180),
)
"""Units in which an argument may be expected; what it is multiplied by."""
_GIVEN: tuple[tuple[str, Callable[[Any], Any]], ...] = (
    ("the sign of all results is turned", lambda v: -v),
    ("negative results are cut off at 0", lambda v: np.maximum(v, 0)),
    ("results are given without their sign", np.abs),
    ("results are rounded down to whole numbers", np.floor),
    ("angular frequencies are given in Hz", lambda v: v / (2 * np.pi)),
)
_CONDITIONS = ("eq6", "eq25")
"""Conditions of the paper that may be taken for a limit of something else."""


def named(
    checked: Checked, some: Sequence[Point], got: Sequence[Point], nothing: Sequence[Point]
) -> tuple[str, ...]:
    """The error that gives what was found at ordinary points where the formula itself does not.

    ``nothing`` are points at which the function gives NaN.
    """
    if not some:
        return ()
    points, mine = some[-_SAMPLE:], np.array(got[-_SAMPLE:], dtype=float)
    columns = [np.array(column) for column in zip(*points, strict=True)]
    right = _exact(checked, points)
    near = _share(right, mine, 1e-5) > _MOST
    by = _NEAR if near else 1e-6  # what is nearly right is told from pi = 3.14159, too
    share = _share(right, mine, by)
    models = [(_share(model(*columns), mine, by), said) for said, model in checked.variants]
    if models and max(models)[0] > max(_MOST, share):
        return (max(models)[1],)
    same = bool((mine == mine[0]).all()) and not near
    with np.errstate(all="ignore"):  # where a wrong formula is not defined
        for name, values in _ruled(checked, columns) if same else _candidates(checked, columns):
            if _share(values, mine, by) > max(_MOST, share):
                return (name,)
    if same:
        return (f"every result is {', '.join(f'{value:g}' for value in mine[0])}",)
    single = near and _single(mine) and not _single(np.array(right, dtype=float))
    if single or (near and share < _BY_CHANCE):
        every = "every result is a float32"
        said = "as far off as single precision, somewhere in between"
        return (f"single precision: {every}" if single else said,)
    for name, wanted, column in zip(checked.results, right, mine.T, strict=False):
        times = factor(checked.arguments, columns, np.asarray(wanted, dtype=float), column)
        if times is not None:
            return (f"{name} is {times} times what is right",)
    too = "; where it is a number it is wrong, too" if _wrong(right, mine) else ""
    return tuple(f"{name}{too}" for name in islice(_undefined(checked, nothing[-_SAMPLE:]), 1))


def _candidates(checked: Checked, columns: Columns) -> Iterator[tuple[str, Columns]]:
    """Each error with what it gives."""
    numbers = _numbers(checked)
    printed = _values(checked, _print(checked)) if checked.printed else numbers
    names, values = list(checked.arguments), printed(columns)
    for order in islice(permutations(range(min(len(values), len(checked.results)))), 1, None):
        told = ", ".join(checked.results[i] for i in order)
        yield f"results are given in the order {told}", [values[i] for i in order]
    for order in islice(permutations(range(len(names))), 1, None):
        taken = ",".join(names[order.index(i)] for i in range(len(names)))
        said = f"arguments are taken in another order; --arguments {taken}"
        yield said, printed([columns[i] for i in order])
    for name, exprs in _written(checked):
        yield name, _values(checked, exprs)(columns)
    for name, other in _taken(dict(zip(names, columns, strict=True))):
        for given in (numbers, printed):  # at a fraction of a period they differ
            yield name, given(list(other.values()))
    if isinstance(exact(checked, _first(columns))[0][0], bool):
        yield "true and false are exchanged", [1 - np.asarray(v) for v in numbers(columns)]
    else:
        for name, change in _GIVEN:
            yield name, [change(v) for v in numbers(columns)]
    yield from _ruled(checked, columns)


def _first(columns: Columns) -> Point:
    return tuple(float(column[0]) for column in columns)


def _numbers(checked: Checked) -> Callable[[Columns], Columns]:
    """The package's own; nothing where it refuses an argument or takes long."""

    def given(columns: Columns) -> Columns:
        try:
            return list(checked.near(*columns)) if checked.near and checked.balls >= 400 else []
        except ValueError:
            return []

    return given


def _print(checked: Checked, lines: Any = None) -> Sequence[Expr]:
    """What is printed, or what these lines say, of each result."""
    read = in_units if {"T", "m"} & set(checked.arguments) else dimensionless
    return read(checked.printed, lines or STATEMENTS[checked.printed].printed)


def _written(checked: Checked) -> Iterator[tuple[str, Sequence[Expr]]]:
    """The equation as published, and with one thing changed."""
    if not checked.printed:
        return
    printed, called = _print(checked), f"({checked.printed.removeprefix('eq')})"
    whole = [name for name, argument in checked.arguments.items() if argument.whole]
    yield f"this is {called} as published; see the erratum of {checked.printed}", printed
    for form in (printed, *also(checked.printed, printed)):
        for said, change in changes(whole):
            changed = [change(e) for e in form]
            if changed != list(form):
                yield f"this is {called} with {said}", changed
    turns = {f: sp.cos(*f.args) for e in printed for f in e.atoms(sp.sin)}
    turns |= {f: sp.sin(*f.args) for e in printed for f in e.atoms(sp.cos)}
    yield f"this is {called} with sine and cosine swapped", [e.xreplace(turns) for e in printed]
    for s in {s: None for e in printed for s in e.free_symbols if s.name in checked.arguments}:
        for other in (s + 1, s - 1) if s.name == "d" else (2 * s, s / 2):
            yield f"this is {called} with {other} for {s}", [e.subs(s, other) for e in printed]
    if checked.printed in ("eq12", "eq14", "eq18"):  # each of their changes takes long to read
        return
    for mutant in islice(mutants(STATEMENTS[checked.printed].printed), _CHANGES):
        try:
            exprs = _print(checked, mutant.form)
        except (ZeroDivisionError, AttributeError):
            continue
        yield f"this is {called} with a slip: {mutant.change}", exprs


def changes(whole: Sequence[str]) -> Iterator[tuple[str, Callable[[Expr], Expr]]]:
    """Usual changes of a formula; ``whole`` are arguments that are whole numbers.

    >>> from sympy.abc import x
    >>> dict(changes([]))["half the angle in tan"](sp.tan(x))
    tan(x/2)
    """

    def is_half_sum(x: Expr) -> bool:
        return bool(x.is_Add and any(a.is_Rational and a.q > 1 for a in x.args))

    def is_quotient(x: Expr) -> bool:
        names = {s.name for s in x.free_symbols}
        divided = x.is_Mul and sp.fraction(x)[1] != 1
        return bool(divided and names and names <= set(whole) and not x.has(sp.pi))

    def down(x: Expr) -> Expr:
        return -sp.floor(-x) if x.could_extract_minus_sign() else sp.floor(x)

    def halves(x: Expr) -> Expr:
        return sp.Add(*(sp.floor(a) if a.is_Rational else a for a in x.args))

    for said, by in _ANGLES:
        for some in (*((one,) for one in _TURNING), _TURNING):
            where = some[0].__name__ if len(some) == 1 else "tan, sin and cos"
            yield f"{said} in {where}", partial(_turned, some=some, by=by)
    yield "1/2 as a division of whole numbers, 0", lambda e: e.replace(is_half_sum, halves)
    yield "a division of whole numbers, rounded down", lambda e: e.replace(is_quotient, down)
    yield "the absolute value left out", lambda e: e.replace(sp.Abs, lambda x: x)
    yield "the square root left out", partial(_without, power=sp.Rational(1, 2))
    yield "a square left out", partial(_without, power=sp.Integer(2))
    for value in _PI:
        yield f"{value} for pi", partial(Expr.xreplace, rule={sp.pi: sp.Rational(value)})


def _turned(e: Expr, some: Sequence[Any], by: Expr) -> Expr:
    for one in some:
        e = e.replace(one, lambda x, f=one: f(by * x))
    return e


def _without(e: Expr, power: Expr) -> Expr:
    return e.replace(lambda x: x.is_Pow and x.exp == power, lambda x: x.base)


def also(id: str, printed: Sequence[Expr]) -> Iterator[Sequence[Expr]]:
    """The same equation as it is written elsewhere, as with half the angle in a tangent."""
    if id == "eq11":
        names = {s.name: s for e in printed for s in e.free_symbols}
        b, d = names["b"] if "b" in names else names["delta"], names["d"]
        period = names.get("T", sp.S.One)
        yield [b * 2 / period * sp.tan(sp.pi / (4 * (d + 1))), *printed[1:]]


def _taken(at: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Arguments as they are misunderstood."""
    for name, said, by in _TAKEN:
        if name in at:
            yield f"{name} is {said}", at | {name: at[name] * by}
            yield f"{name} is {said}, the other way around", at | {name: at[name] / by}
    if {"T", "d"} <= at.keys():
        yield "d is taken in seconds, not in periods", at | {"d": at["d"] / at["T"]}
    if {"T", "t_d"} <= at.keys():
        yield "t_d is taken in periods, not in seconds", at | {"t_d": at["t_d"] * at["T"]}
    for name in at:
        yield f"{name} is taken twice", at | {name: 2 * at[name]}
        yield f"half of {name} is taken", at | {name: at[name] / 2}


def _ruled(checked: Checked, columns: Columns) -> Iterator[tuple[str, Columns]]:
    """Whether a rule in circulation allows a wall, or the largest stiffness that it allows."""
    if not checked.id.startswith(("is_", "max_", "scene.")):
        return
    at = dict(zip(checked.arguments, columns, strict=True))
    size = at["m"] / at["T"] ** 2 if "m" in at else 1.0
    if "m" in at:
        at |= {"gamma": at["k"] / size, "delta": at["b"] * at["T"] / at["m"]}
    rules = [(f"a rule in circulation: {s.says}", s.id, s.printed) for s in RULES.values()]
    rules += [(f"({id[2:]}) is taken for it", id, STATEMENTS[id].printed) for id in _CONDITIONS]
    for says, id, lines in rules:
        (expr,) = limit([placed(line) for line in lines])
        expr = expr if "beta" in at else expr.subs(beta, 0)
        names = dict.fromkeys([s for s in (beta, gamma, *expr.free_symbols) if s.name in at])
        used = [s for s in names if s != alpha]
        allowed = sp.lambdify(used, expr, "numpy")(*(at[s.name] for s in used)) * size
        yield f"{says}; see {id}", [at["alpha"] < allowed] if "alpha" in at else [allowed]


def factor(names: Any, columns: Columns, right: Any, mine: Any) -> str | None:
    """A constant times powers of the arguments by which a result is wrong; None where it is not.

    >>> T = np.array([1.0, 2.0, 3.0, 5.0, 7.0, 8.0])
    >>> factor({"T": ()}, [T], T**2, 2 * T)
    '2/T'
    """
    told = np.isfinite(right) & np.isfinite(mine) & (right != 0) & (mine != 0)
    used = [np.asarray(column, dtype=float) for column in columns]
    told &= np.all([column > 0 for column in used], axis=0)
    if told.sum() < 3 * (len(used) + 1) or np.ptp(np.sign(mine[told] / right[told])):
        return None
    rows = np.column_stack([np.ones(told.sum()), *(np.log(column[told]) for column in used)])
    wanted = np.log(np.abs(mine[told] / right[told]))
    powers = np.round(2 * np.linalg.lstsq(rows, wanted, rcond=None)[0][1:]) / 2
    constant = float(np.exp(np.median(wanted - rows[:, 1:] @ powers)))
    if np.abs(wanted - rows[:, 1:] @ powers - np.log(constant)).max() > 1e-6:
        return None
    sign = -1 if mine[told][0] / right[told][0] < 0 else 1
    if sign * constant == 1 or (not powers.any() and abs(sign * constant - 1) < 1e-4):
        return None
    near = sp.Rational(constant).limit_denominator(1000)
    plain = near.p <= 1000 and abs(near - constant) <= 1e-7 * constant
    number = sign * (near if plain else sp.Float(constant, 6))
    found = zip(names, powers, strict=True)
    shares = (Symbol(n, positive=True) ** sp.Rational(p).limit_denominator(2) for n, p in found)
    return str(sp.Mul(number, *shares))


def _values(checked: Checked, exprs: Sequence[Expr]) -> Callable[[Columns], Columns]:
    """Expressions at points, complex as square roots may be; none where they fail."""
    names = {s.name: s for e in exprs for s in e.free_symbols}
    names |= {"theta": names["omega_hat"]} if "omega_hat" in names else {}
    arguments = tuple(names.get(name, Symbol(name)) for name in checked.arguments)
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
def _function(arguments: tuple[Symbol, ...], exprs: tuple[Expr, ...]) -> Callable[..., Any]:
    """Expressions as a function of arrays, made once for all that are checked."""
    down = {"floor": lambda x: np.floor(np.real(x))}
    return cast("Callable[..., Any]", sp.lambdify(arguments, exprs, [down, "numpy"]))


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
    rows = [[math.nan if v is None else float(v) for v in exact(checked, p)[0]] for p in points]
    return list(np.array(rows).T)


def _single(mine: Any) -> bool:
    """Whether all numbers are floats of single precision."""
    values = mine[np.isfinite(mine) & (np.abs(mine) < 1e38)]
    return bool(values.size and (values.astype(np.float32) == values).all())


def _wrong(right: Columns, mine: Any) -> bool:
    """Whether more than cancellation parts the numbers that are there from what is right."""
    wanted = np.array(right).T[:, : mine.shape[1]]
    both = np.isfinite(wanted) & np.isfinite(mine)
    there, mine = wanted[both], mine[both]
    far = np.abs(mine - there) > 1e-2 * np.maximum(np.abs(there), 1e-12)
    return bool(far.size and far.mean() > 1 - _MOST)


def _undefined(checked: Checked, nothing: Sequence[Point]) -> Iterator[str]:
    """NaN where what is printed has no value either."""
    if not checked.printed or not nothing:
        return
    with np.errstate(all="ignore"):
        columns = [np.array(column) for column in zip(*nothing, strict=True)]
        values = _values(checked, _print(checked))(columns)
    at = dict(zip(checked.arguments, columns, strict=True))
    if {"b", "k", "m"} <= at.keys() and (at["b"] ** 2 < 4 * at["k"] * at["m"]).mean() > 0.5:
        yield "NaN where the device swings: a real square root of b^2 - 4km"
    elif {"gamma", "delta"} <= at.keys() and (at["delta"] ** 2 < 4 * at["gamma"]).mean() > 0.5:
        yield "NaN where the device swings: a real square root of delta^2 - 4 gamma"
    elif all(not np.isfinite(np.asarray(v)).any() for v in values[:1]):
        called = f"({checked.printed.removeprefix('eq')})"
        yield f"0/0 where {called} as published is 0/0; see the erratum of {checked.printed}"
