"""What a wall needs at an angle, in entire functions, and the walls that are just passive."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_forms import Block, Later, Named, nonzero
from symhaptic.forms import required_damping, stable
from symhaptic.forms.entire import Chord, Sinc, written_out

ANGLE = tuple(map(proposition, (theta > 0, theta < pi)))
HALF_ANGLE = tuple(map(proposition, (psi > 0, psi < pi / 2)))
WALL = {alpha: S.One, beta: S.Half, delta: S(2)}
S_0, S_1, S_2, S_3, S_4, S_5, Z, Z_1, Z_2 = symbols("S_0 S_1 S_2 S_3 S_4 S_5 Z Z_1 Z_2")
"""Of sines over their angles, and of the entire functions of a delay and an angle."""
SINES = ((S_0, 1), (S_1, 2 * l + 1), (S_2, 2 * l + 2), (S_3, 2 * l + 3), (S_4, 2 * l + 4), (S_5, 2))
ENTIRE = {
    **{Sinc(order * psi): name for name, order in SINES},
    Chord(l, 2 * psi): Z_1,
    Chord(l + 1, 2 * psi): Z_2,
}


def named(expr: Expr, entire: Mapping[Expr, Symbol]) -> Expr:
    """A computed formula with names for its entire functions; what is a cosine is one."""
    return written_out(expr.xreplace(dict(entire)))


def defined(entire: Mapping[Expr, Symbol]) -> Named:
    """What they stand for."""
    return tuple((name, written_out(function)) for function, name in entire.items())


def kernel(order: Expr, angle: Expr) -> Expr:
    """sin((k + 1/2) theta)/(2 sin(theta/2))."""
    return sin((order + HALF) * angle) / (2 * sin(angle / 2))


def straight(delay: Expr) -> Expr:
    """What straight motions need at an integer delay."""
    return alpha * kernel(delay, 2 * psi) - beta * cos(2 * (delay + 1) * psi)


def _needs() -> Block:
    """What is needed at an angle, and how that changes with the angle and with the wall."""
    whole, later = straight(l), straight(l + 1)
    between, steep = (1 - epsilon) * x + epsilon * y, (1 - epsilon) * v + epsilon * w
    names = (
        *defined(ENTIRE),
        *((x, whole), (y, later), (v, derivative(whole, psi)), (w, derivative(later, psi))),
    )
    share = epsilon * (1 - epsilon)
    size = alpha**2 + 4 * beta * (alpha + beta) * sin(psi) ** 2
    cosines = (1 - epsilon) * cos(2 * (l + 1) * psi) + epsilon * cos(2 * (l + 2) * psi)
    exact = (
        x,
        x + epsilon * (y - x),
        v,
        delta**2 - delta * between - share * size / 4,
        delta * steep + 2 * share * beta * (alpha + beta) * sin(psi) * cos(psi),
        share * (alpha + 2 * beta) * sin(psi) ** 2 - delta * cosines,
    )
    computed = (named(ours, ENTIRE) for ours, _ in required_damping.derived())
    pairs = tuple(Relation(ours, "=", known) for ours, known in zip(computed, exact, strict=True))
    free = psi, l, epsilon, alpha, beta, delta
    where = *HALF_ANGLE, proposition(l >= 0)
    point = {psi: S.One, l: S.One, epsilon: S.Half} | WALL
    return Block(free, where, names, pairs, point, _orders)


def _orders() -> list[Theorem]:
    """No angle, no sine of it and no multiple of the delay is zero."""
    wide = positive(psi < pi, [psi < pi / 2], [Rational(1, 2), number(Relation(S.Zero, "<", pi))])
    sine = closed(sign_of(sin, psi), wide)
    orders = (positive(2 * l + n > 0, [2, l >= 0], [n, one()]) for n in (1, 2, 3, 4))
    return [
        *(nonzero(2 * l + n, o, times=S.One) for n, o in enumerate(orders, start=1)),
        nonzero(psi, assume(psi > 0), times=S.One),
        nonzero(sin(psi), sine, times=S.One),
        nonzero(sin(psi) / psi, sine, times=psi),
    ]


def half_angle() -> list[Theorem]:
    """Neither the angle nor the sine of its half is zero."""
    right, sine = assume(theta > 0), sine_of_half(theta)
    return [nonzero(theta, right, times=S.One), nonzero(sin(theta / 2), sine, times=S.One)]


def _at_an_angle() -> Block:
    """What is left at an angle, for integer delays and for those with a fraction."""
    computed = (written_out(ours) for ours, _ in stable.form("passivity_margin_at").equal)
    whole, later = (
        alpha * kernel(delay, theta) - beta * cos((delay + 1) * theta) for delay in (l, l + 1)
    )
    between, share = (1 - epsilon) * whole + epsilon * later, epsilon * (1 - epsilon)
    size = alpha**2 + 4 * beta * (alpha + beta) * sin(theta / 2) ** 2
    exact = (
        delta - (alpha * kernel(d, theta) - beta * cos((d + 1) * theta)),
        between,
        delta**2 - delta * between - share * size / 4,
        S.Zero,
    )
    pairs = tuple(Relation(ours, "=", known) for ours, known in zip(computed, exact, strict=True))
    point = {theta: S.One, d: S.One, l: S.One, epsilon: HALF, w: S.One} | WALL
    free = theta, d, l, epsilon, alpha, beta, delta, w
    return Block(free, ANGLE, (), pairs, point, _sines)


def _sines() -> list[Theorem]:
    """The sine of the angle is not zero either."""
    return [*half_angle(), nonzero(sin(theta), closed(sign_of(sin, theta)), times=S.One)]


NEEDS, MARGIN = Later(_needs), Later(_at_an_angle)
