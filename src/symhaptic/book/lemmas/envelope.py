"""The envelope (7) for every N > 2: its stiffness rises and falls, and its damping bounds F.

With u = KT/(2b) and w = (B + KT/2)/b the margin of a wall is b F, F = line(u, w, psi), psi =
theta/2 and N = 2(d+1).  The envelope is (u, w) = (stiffness(phi), damping(phi)).
"""

from symhaptic.book.lemmas.chords import bend, lemma, sine, size, width
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
    here = Given(N > 2, angle > 0, N * angle < pi, beside(side, angle))
    wave = sign_of(cos, N * angle if side == LOWER else N * angle - pi)
    return here.show(side * cos(N * angle) > 0, wave)


apart = lemma(Ne(divisor(), 0), width)


@cache
def rises(side: int) -> Theorem:
    """U(phi) < U(psi) for phi < psi up to pi/2, and U(psi) < U(phi) beyond."""
    reach = N * psi <= pi / 2 if side == LOWER else N * phi >= pi / 2
    here = Given(N > 2, phi > 0, N * psi < pi, reach, x > phi, x < psi)
    slope = 2 * N**2 * sin(x) ** 2 * side * cos(N * x) * difference(bend(x))
    curve, known = side * stiffness(x), (size(), sine(x), width(x), bend(x), turned(side, x))
    found = over(derivative(curve, x) > 0, slope > 0, divisor(x) ** 2 > 0)
    inside = here.closed(found, *known), *here.defined(curve, *known)
    ends = Given(N > 2, phi > 0, psi > phi, N * psi < pi, reach)
    return ends.closed(grows(curve, x, phi, psi, *inside), width(phi), width(psi))


def border(stiff: Expr, angle: Expr = psi) -> Expr:
    """The damping -w that a stiffness leaves at an angle: F = cos(N psi) (w - border)."""
    return (1 - stiff * cos(angle) * sin(N * angle) / sin(angle)) / cos(N * angle)


@cache
def same_side(side: int, after: bool) -> Theorem:
    """0 < F of the wall (U, W)(phi) at psi, both on one side of N psi = pi/2."""
    stiff = stiffness(phi)
    low, high = (phi, psi) if after else (psi, phi)
    way = side if after else -side
    ends = Given(
        N > 2, low > 0, N * high < pi, low < high, beside(side, (low, high)[side == LOWER])
    )
    here = ends.and_(x > low, x < high)
    moved = inst(rises(side), {psi: x} if after else {phi: x, psi: phi})
    known = [f(x) for f in (sine, width)] + [turned(side, x), width(phi), sine(phi), moved]
    curve = way * border(stiff, x)
    slope = over(
        derivative(curve, x) > 0,
        divisor(x) * way * (stiffness(x) - stiff) > 0,
        2 * sin(x) ** 2 * cos(N * x) ** 2 > 0,
    )
    slope = here.closed(slope, *known)
    found = grows(curve, x, low, high, slope, *here.defined(curve, *known))
    signs = [t for v in (phi, psi) for t in (turned(side, v), sine(v), width(v))]
    return ends.show(line(stiff, damping(phi)) > 0, *signs, ends.closed(found, *signs))
