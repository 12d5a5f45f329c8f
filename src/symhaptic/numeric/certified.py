"""Verdicts that are right for the numbers given: by the filter, else by balls of growing precision.

The filter of the compiled kernels counts in doubles with proved bounds of their errors, and leaves
what it is not certain of to :mod:`symhaptic.balls.winding`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from symhaptic.notation.quantities import decimal, shown
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.compiled import MODULE
from symhaptic.numeric.given import Given

_AT_LEAST_ONE = -2
"""What the filter gives where a root is outside, but their number is not known."""


def roots(given: Given) -> Any:
    """The number of roots outside of each loop; -1 where no precision decides it, or NaN is given.

    Raises :class:`ValueError` for traced arrays, which have no values.
    """
    from symhaptic.balls.winding import unstable

    return _each(lambda *loop: _settled(unstable, _filtered(*loop), *loop), given)


def stable(given: Given) -> Any:
    """Whether each loop is stable; not where an argument is NaN.

    Raises :class:`ArithmeticError` where no precision decides it, and :class:`ValueError` for
    traced arrays.
    """
    from symhaptic.balls import winding

    def work(*loop: Array) -> NDArray[np.bool_]:
        counts = _filtered(*loop)
        known = np.where(counts >= 0, counts == 0, np.where(counts == _AT_LEAST_ONE, 0.0, -1.0))
        found = _settled(winding.stable, known, *loop)
        left = np.flatnonzero((found < 0) & ~np.isnan(sum(loop)))
        if left.size:
            first = [float(a[left[0]]) for a in loop]
            undecided(_NAMES, first, f"{left.size} of {found.size} loops")
        return found > 0

    return _each(work, given)


_NAMES = ("alpha", "beta", "gamma", "delta", "delay")


def undecided(names: Sequence[str], numbers: Sequence[float], share: str) -> NoReturn:
    """Raise :class:`ArithmeticError` for a loop, the first of a number of loops."""
    loop = ", ".join(f"{n}={float(v)!r}" for n, v in zip(names, numbers, strict=True))
    raise ArithmeticError(
        f"certified: {loop} is on the boundary, or too close to it for balls to decide ({share}); "
        "change one of these numbers, or ask without certified=True"
    )


def _each(work: Callable[..., Any], given: Given) -> Any:
    if given.traced:
        raise ValueError("certified: True is not available for traced arrays; give numbers")

    def rows(*values: Array) -> list[Any]:
        loop = np.broadcast_arrays(*values)
        return [work(*(a.reshape(-1) for a in loop)).reshape(loop[0].shape)]

    return given.by_numpy(rows)[0]


def _filtered(*loop: Array) -> Array:
    """What doubles are certain of."""
    if MODULE is None or not loop[0].size:
        return np.full(loop[0].size, -1.0)
    found: Array = MODULE.certain_roots(*loop)
    return found


def _settled(exact: Callable[..., Any], found: Array, *loop: Array) -> Array:
    """The same with what ``exact`` tells where it is negative; -1 for None and NaN."""
    for i in np.flatnonzero((found < 0) & ~np.isnan(sum(loop))):
        verdict = exact(*(float(a[i]) for a in loop))
        found[i] = -1.0 if verdict is None else float(verdict)
    return np.maximum(found, -1.0)


def passive(given: Given, near: NDArray[np.bool_], sure: Array, must: bool) -> Any:
    """Whether no motion extracts energy: ``sure``, but by balls where ``near`` is true.

    Where no precision decides it a wall is not passive.  If it ``must`` be decided, raises
    :class:`ArithmeticError`.
    """

    def rows(*values: Array) -> list[Array]:
        wall = [np.broadcast_to(a, near.shape) for a in values]
        found = np.array(sure, dtype=bool)
        for at in zip(*np.nonzero(near), strict=True) if near.ndim else [()] * bool(near):
            numbers = [float(a[at]) for a in wall]
            verdict = passively(*numbers)
            if verdict is None and must:
                undecided(("alpha", "beta", "delta", "delay"), numbers, f"one of {near.size}")
            found[at] = bool(verdict)
        return [found]

    return given.by_numpy(rows)[0]


def _ratio(value: Any) -> tuple[int, int]:
    """Numerator and denominator of a float or a rational number of flint."""
    top, bottom = value.as_integer_ratio() if isinstance(value, float) else (value.p, value.q)
    return top, bottom


_PASSIVE_BITS = (128, 256, 512, 1024)


def passively(alpha: Any, beta: Any, delta: Any, delay: Any) -> bool | None:
    """Whether the margin is not negative, in balls of growing precision; None if not decided.

    Without delay the wall needs alpha/2 + abs(beta), which is compared exactly, as are the limits
    of what it needs at the angles 0 and pi.
    """
    import flint

    wall = [flint.fmpq(*_ratio(v)) for v in (alpha, beta, delta, delay)]
    if delay == 0:
        stiffness, damping, device, _ = wall
        return bool(alpha >= 0 and stiffness + 2 * abs(damping) <= 2 * device)
    if alpha < 0 or _loses_at_an_end(*wall):
        return False

    from symhaptic.balls.implicit import passivity_margin

    for bits in _PASSIVE_BITS:
        with flint.ctx.workprec(bits):
            try:
                margin = passivity_margin(alpha, beta, delta, delay)[0]
            except ArithmeticError:  # too wide
                continue
            if margin >= 0 or margin < 0:
                return bool(margin >= 0)
    return None


def _loses_at_an_end(alpha: Any, beta: Any, delta: Any, delay: Any) -> bool:
    """Whether the margin is negative in the limit at the angle 0 or pi, of rational numbers."""
    whole = int(delay.floor())
    part = delay - whole
    held = part * (1 - part)
    turned = (1 - 2 * part) * (beta + alpha / 2)
    ends = (
        (delta + beta - alpha * (2 * delay + 1) / 2, alpha),
        (delta + turned if whole % 2 else delta - turned, alpha + 2 * beta),
    )
    return any(left < 0 or 4 * delta * left < held * force**2 for left, force in ends)


def of_walls(verdict: Callable[[Fraction, Fraction], bool | None], K: Any, B: Any) -> Any:
    """What a verdict on exact stiffness and damping says of walls in decimals; not of NaN."""

    def work(*walls: Array) -> NDArray[np.bool_]:
        found = np.zeros(walls[0].size, dtype=bool)
        for i in np.flatnonzero(~np.isnan(sum(walls))):
            stiffness, damping = (float(a[i]) for a in walls)
            said = verdict(decimal(stiffness), decimal(damping))
            if said is None:
                undecided(("K", "B"), (stiffness, damping), f"one of {found.size} walls")
            found[i] = said
        return found

    return _each(work, Given(K=K, B=B))


def whole(sheet: str, given: Given) -> None:
    """Refuse fractional delays on the principal sheet, of which no ball is known."""
    delay = given.values[-1]
    if sheet != "exact" and not given.whole(delay):
        raise ValueError(f"certified: True is not available with sheet={shown(sheet)} and a "
                         "fractional delay; give sheet='exact'")  # fmt: skip
