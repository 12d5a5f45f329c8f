"""The envelope (7) for every N > 2: its stiffness rises and falls, and its damping bounds F.

With u = KT/(2b) and w = (B + KT/2)/b the margin of a wall is b F, F = line(u, w, psi), psi =
theta/2 and N = 2(d+1).  The envelope is (u, w) = (stiffness(phi), damping(phi)).
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, anywhere, bend, not_zero, sine, size, width
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.analysis import grows

LOWER, UPPER = 1, -1
"""The angles with 0 < N psi < pi/2, and those with pi/2 < N psi < pi."""

TURN = pi / (2 * N)


def line(u: Expr, w: Expr, angle: Expr = psi) -> Expr:
    """1 - u cot psi sin N psi + w cos N psi."""
    return 1 - u * cos(angle) * sin(N * angle) / sin(angle) + w * cos(N * angle)


def divisor(angle: Expr = psi) -> Expr:
    """N sin 2 psi - sin 2 N psi."""
    return N * sin(2 * angle) - sin(2 * N * angle)


def stiffness(angle: Expr = psi) -> Expr:
    """KT/(2b) on the envelope."""
    return 2 * N * sin(angle) ** 2 * sin(N * angle) / divisor(angle)


def damping(angle: Expr = psi) -> Expr:
    """(B + KT/2)/b on the envelope."""
    return (2 * sin(N * angle) - N * sin(2 * angle) * cos(N * angle)) / divisor(angle)


def beside(side: int, angle: Expr) -> Any:
    """On which side of pi/2 the larger angle lies."""
    return N * angle < pi / 2 if side == LOWER else N * angle > pi / 2


@cache
def turned(side: int, angle: Expr = psi) -> Theorem:
    """0 < cos N psi below pi/2, and 0 < -cos N psi above."""
    known = assume(beside(side, angle))
    if side == LOWER:
        low = positive(N * angle > -pi / 2, [size(), angle > 0], [HALF, PI])
        return closed(sign_of(cos, N * angle), low, known)
    low = positive(N * angle - pi > -pi / 2, [known])
    high = positive(N * angle - pi < pi / 2, N * angle < pi, [HALF, PI])
    return closed(sign_of(cos, N * angle - pi), low, high)


@anywhere
def apart() -> Theorem:
    """The divisor of (7) is not zero."""
    return not_zero(width())


@cache
def rises(side: int) -> Theorem:
    """U(phi) < U(psi) for phi < psi up to pi/2, and U(psi) < U(phi) beyond."""
    slope = 2 * N**2 * sin(x) ** 2 * side * cos(N * x) * bend(x).conclusion.right  # type: ignore[attr-defined]
    top = positive(slope > 0, [2, size(), size(), sine(x), sine(x), turned(side, x), bend(x)])
    bottom = positive(divisor(x) ** 2 > 0, [width(x), width(x)])
    curve = side * stiffness(x)
    found = over(derivative(curve, x) > 0, top, bottom)
    found = closed(found, not_zero(bottom), apart(x), not_zero(size()), not_zero(sine(x)))
    first = side == LOWER
    inside = [
        positive(x > 0, phi > 0, x > phi),
        positive(N * x < pi, N * psi < pi, [size(), x < psi]),
        positive(N * x < pi / 2, N * psi <= pi / 2, [size(), x < psi])
        if first
        else positive(N * x > pi / 2, N * phi >= pi / 2, [size(), x > phi]),
    ]
    found = grows(curve, x, phi, psi, closed(found, *inside), closed(apart(x), *inside))
    ends = [
        positive(N * phi < pi, N * psi < pi, [size(), phi < psi]),
        positive(psi > 0, phi > 0, psi > phi),
    ]
    return closed(found, apart(phi), apart(psi), *ends)


def border(stiff: Expr, angle: Expr = psi) -> Expr:
    """The damping -w that a stiffness leaves at an angle: F = cos(N psi) (w - border)."""
    return (1 - stiff * cos(angle) * sin(N * angle) / sin(angle)) / cos(N * angle)


@cache
def same_side(side: int, after: bool) -> Theorem:
    """0 < F of the wall (U, W)(phi) at psi, both on one side of N psi = pi/2."""
    stiff = stiffness(phi)
    low, high = (phi, psi) if after else (psi, phi)
    way = side if after else -side
    moved = inst(rises(side), {psi: x} if after else {phi: x, psi: phi})
    top = positive(divisor(x) * way * (stiffness(x) - stiff) > 0, [width(x), moved])
    squared = 2 * sin(x) ** 2 * cos(N * x) ** 2
    bottom = positive(squared > 0, [2, sine(x), sine(x), turned(side, x), turned(side, x)])
    curve = way * border(stiff, x)
    slope = over(derivative(curve, x) > 0, top, bottom)
    inside = [
        positive(x > 0, low > 0, x > low),
        positive(N * x < pi, N * high < pi, [size(), x < high]),
        positive(N * x < pi / 2, beside(side, high), [size(), x < high])
        if side == LOWER
        else positive(N * x > pi / 2, beside(side, low), [size(), x > low]),
        positive(beside(side, x).lts <= beside(side, x).gts, beside(side, x)),
        positive(beside(side, phi).lts <= beside(side, phi).gts, beside(side, phi)),
    ]
    known = [*divisors_at(x, side), apart(phi)]
    slope = closed(slope, *known, *inside)
    shown = [closed(t, *inside) for t in divisors_at(x, side)]
    found = grows(curve, x, low, high, slope, *shown, apart(phi))
    goal = line(stiff, damping(phi)) > 0
    found = positive(goal, [turned(side), found])
    ends = [
        positive(N * low < pi, N * high < pi, [size(), low < high]),
        positive(high > 0, low > 0, high > low),
        positive(N * low < pi / 2, beside(LOWER, high), [size(), low < high]),
        positive(N * high > pi / 2, beside(UPPER, low), [size(), low < high]),
    ]
    return closed(found, *divisors_at(phi, side), *divisors_at(psi, side), *known, *ends)


@cache
def divisors_at(angle: Expr, side: int) -> tuple[Theorem, ...]:
    """What the margin and the envelope divide by is not zero on one side of N psi = pi/2."""
    cosine = positive(Ne(cos(N * angle), 0), [turned(side, angle)])
    return not_zero(sine(angle)), cosine, apart(angle)
