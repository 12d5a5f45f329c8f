"""Values to any number of digits: balls of growing precision until all digits are known."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from symhaptic.notation.quantities import shown
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.given import Given, to_numpy

_CLOSED = {"passivity_boundary", "max_passive_stiffness"}
"""Behind a fraction of a period these are searched for, not enclosed."""

_OTHER = {"delay": "d", "omega": "theta"}

_TRIES = 6
"""Precisions that are tried; each is twice the one before."""

_MOST = 100_000


def in_digits(name: str, digits: int, sheet: str = "exact", **arguments: Any) -> Any:
    """The results of a function as balls of python-flint, for each element of the arguments.

    The radius of each ball is at most 10^-digits of its value.

    Raises :class:`ValueError` for arguments that the function refuses, a number of digits outside
    [1, 100000], traced arrays, a fractional delay where it is not computed, and
    :class:`ArithmeticError` if the digits are not reached.
    """
    if type(digits) is not int or not 1 <= digits <= _MOST:
        raise ValueError(f"digits: {shown(digits)} is not allowed; give a whole number from 1 "
                         f"to {_MOST}")  # fmt: skip
    given = Given(**arguments)
    if given.traced:
        raise ValueError("digits: not available for traced arrays; give numbers")
    rows = np.broadcast_arrays(*map(to_numpy, given.values))
    names = [_OTHER.get(n, n) for n in arguments]
    if "d" in names and (sheet != "exact" or name in _CLOSED):
        delay = rows[names.index("d")]
        if np.any(delay != np.floor(delay)):
            what = f"digits of {name}" if sheet == "exact" else f"digits with sheet={sheet!r}"
            raise ValueError(
                f"delay: a fraction is not available for {what}; give a whole number of periods"
            )
    found = [_one(name, digits, names, values) for values in zip(*map(_flat, rows), strict=True)]
    if not rows[0].ndim:
        return found[0] if len(found[0]) > 1 else found[0][0]
    columns = []
    for column in zip(*found, strict=True) if found else ():
        filled = np.empty(len(column), dtype=object)
        filled[:] = column
        columns.append(filled.reshape(rows[0].shape))
    return tuple(columns) if len(columns) > 1 else columns[0] if columns else np.empty(0, object)


def _flat(row: Array) -> list[float]:
    numbers: list[float] = row.reshape(-1).tolist()
    return numbers


def _one(name: str, digits: int, names: list[str], values: tuple[float, ...]) -> tuple[Any, ...]:
    import flint

    from symhaptic.balls.exact import EXACT, bits

    most = flint.arb(10) ** -digits
    if any(math.isnan(v) for v in values):
        return tuple([flint.arb("nan")] * _results(name))
    start = bits(values) + math.ceil(3.33 * digits)
    for last, precision in ((i == _TRIES - 1, start << i) for i in range(_TRIES)):
        with flint.ctx.workprec(precision):
            try:
                found = EXACT[name](**dict(zip(names, values, strict=True)))
            except ArithmeticError:  # too wide
                continue
            if all(x.rad() <= abs(x) * most or (last and x.is_nan()) for x in found):
                return found
    said = ", ".join(f"{n}={v!r}" for n, v in zip(names, values, strict=True))
    raise ArithmeticError(
        f"digits: {digits} digits of {name} are not reached at {said}; a result may be zero "
        "without being known to be"
    )


def _results(name: str) -> int:
    return {"discretize": 4, "discretize_fractional": 5, "max_passive_stiffness": 3}.get(
        name, 2 if name.endswith("boundary") else 1
    )
