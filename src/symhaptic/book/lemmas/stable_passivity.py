"""What a wall needs at an angle, in entire functions, and the walls that are just passive."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from sympy import Expr, Ne, Rational, S, Symbol, cos, pi, sin, symbols, tan

from symhaptic.book.lemmas.stable_forms import Block, Named, not_zero
from symhaptic.forms import required_damping, stable
from symhaptic.forms.entire import Chord, Sinc, Spread, written_out
from symhaptic.model.parts import FULL
from symhaptic.notation import alpha, beta, d, delta, epsilon, l, psi, theta, v, w, x, y
from symhaptic.notation.proposition import Predicate, Relation, proposition
from symhaptic.proof.theorems.familiar import divided, sign_of
from symhaptic.proof.theorems.kernel import Theorem, assume
from symhaptic.proof.theorems.leaves import combined, number
from symhaptic.proof.theorems.tactics import closed, one, positive, sine_of_half

HALF = Rational(1, 2)
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
    """What straight motions need at a whole delay."""
    return alpha * kernel(delay, 2 * psi) - beta * cos(2 * (delay + 1) * psi)


def _needs() -> Block:
    """What is needed at an angle, and how that changes with the angle and with the wall."""
    whole, later = straight(l), straight(l + 1)
    between, steep = (1 - epsilon) * x + epsilon * y, (1 - epsilon) * v + epsilon * w
    names = (
        *defined(ENTIRE),
        *((x, whole), (y, later), (v, whole.diff(psi)), (w, later.diff(psi))),
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
    return Block(free, where, names, pairs, {psi: S.One, l: S.One, epsilon: S.Half} | WALL)


NEEDS = _needs()


@cache
def needs() -> Theorem:
    """That."""
    wide = positive(psi < pi, [psi < pi / 2], [Rational(1, 2), _pi()])
    sine = closed(sign_of(sin, psi), wide)
    right = assume(psi > 0)
    orders = (positive(2 * l + n > 0, [2, l >= 0], [n, one()]) for n in (1, 2, 3, 4))
    divisors = [not_zero(psi, right, times=S.One), not_zero(sin(psi), sine, times=S.One)]
    divisors += [not_zero(2 * l + n, o, times=S.One) for n, o in enumerate(orders, start=1)]
    divisors.append(not_zero(sin(psi) / psi, sine, times=psi))
    return NEEDS.proved(*divisors)


def _pi() -> Theorem:
    """0 < pi."""
    return number(Relation(S.Zero, "<", pi))


def _at_an_angle() -> Block:
    """What is left at an angle; the sine of (2 d + 1) halves of it, and the cosine."""
    ((computed, _),) = stable.form("passivity_margin_at").equal
    exact = delta - (alpha * kernel(d, theta) - beta * cos((d + 1) * theta))
    pair = Relation(written_out(computed), "=", exact)
    point = {theta: S.One, d: S.One} | WALL
    return Block((theta, d, alpha, beta, delta), ANGLE, (), (pair,), point)


LINE = (x, kernel(d, theta)), (y, kernel(d, theta).diff(theta))
"""The line of an angle, delta = alpha x - beta cos((d + 1) theta), and how its x changes."""
TURN, PUSH = 2 * (d + 1) * theta, 2 * (d + 1) * sin(theta)
ENVELOPE = {Sinc(theta / 2): S_0, Spread(d, theta): Z_1, Chord(d, theta): Z_2}


def _envelope() -> Block:
    """The wall in which the line of an angle meets that of the next."""
    computed = (ours for ours, _ in stable.form("passivity_boundary").equal[:2])
    below = (d + 1) * x * sin((d + 1) * theta) + y * cos((d + 1) * theta)
    exact = delta * (d + 1) * sin((d + 1) * theta) / below, -delta * y / below
    pairs = (
        Relation(named(o, ENVELOPE), "=", known) for o, known in zip(computed, exact, strict=True)
    )
    where = (*ANGLE, Relation(sin(TURN), "!=", PUSH))
    names = (*defined(ENVELOPE), *LINE)
    return Block((theta, d, delta), where, names, tuple(pairs), {theta: S.One, d: S.One, delta: S(2)})


WORST = pi * (1 / (d + 1)) / 2
"""The worst angle of the stiffest passive wall."""
STIFFEST_LINE = tuple((name, of.subs(theta, WORST)) for name, of in LINE)


def _stiffest() -> Block:
    """The passive wall of largest stiffness behind whole delays: there cos((d + 1) theta) = 0."""
    entire = {Sinc(WORST): S_0}
    computed = (ours for ours, _ in stable.form("max_passive_stiffness").equal[:2])
    exact = delta / x, -delta * y / ((d + 1) * x)
    pairs = (
        Relation(named(o, entire), "=", known) for o, known in zip(computed, exact, strict=True)
    )
    names = *defined(entire), *STIFFEST_LINE
    return Block((d, delta), (proposition(d >= 0),), names, tuple(pairs), {d: S(6), delta: S(2)})


def _linear() -> Block:
    """Where the linear condition is an equality the margin of slow motions is zero."""
    ((computed, exact),) = stable.form("linear_limit").equal
    margin = delta - (x * kernel(d, theta) - beta * cos((d + 1) * theta))
    limit = Predicate("limit", (theta,), (margin, S.Zero, S.Zero))
    pairs = Relation(written_out(computed), "=", exact), limit
    point = {d: S.One, beta: S.One, delta: S(2)}
    return Block((d, beta, delta), (proposition(d >= 0),), ((x, computed),), pairs, point)


MARGIN, TOUCHED, STIFFEST, LINEAR = _at_an_angle(), _envelope(), _stiffest(), _linear()


@cache
def margin() -> Theorem:
    """What is left at an angle."""
    half = sine_of_half(theta)
    return MARGIN.proved(not_zero(sin(theta / 2), half, times=S.One))


@cache
def touched() -> Theorem:
    """The boundary behind whole delays."""
    half = sine_of_half(theta)
    sine = not_zero(sin(theta / 2), half, times=S.One)
    right = not_zero(theta, assume(theta > 0), times=S.One)
    spread = combined(Ne(PUSH - sin(TURN), 0), [-1, assume(TOUCHED.where[-1])])
    below = dict(LINE)[x] * (d + 1) * sin((d + 1) * theta) + dict(LINE)[y] * cos((d + 1) * theta)
    crossed = not_zero(below, spread, times=8 * sin(theta / 2) ** 2)
    own = not_zero((PUSH - sin(TURN)) / theta**3, spread, times=theta**3)
    return TOUCHED.proved(sine, right, spread, crossed, own)


@cache
def stiffest() -> Theorem:
    """The stiffest passive wall behind whole delays."""
    late = positive(d + 1 > 0, [d >= 0], [one()])
    twice, rest = combined(2 * (d + 1) > 0, [2, late]), positive(2 * d + 1 > 0, [2, d >= 0], [one()])
    low = divided(WORST > 0, number(Relation(S.Zero, "<", pi)), twice)
    high = divided(WORST < pi, combined(pi * (2 * d + 1) > 0, [_pi(), rest]), twice)
    sine, half = closed(sign_of(sin, WORST), low, high), closed(sine_of_half(WORST), low, high)
    cosine = not_zero(cos(WORST / 2), sine, times=2 * sin(WORST / 2))
    other = sin((d + HALF) * WORST)
    known = [not_zero(sin(WORST), sine, times=S.One), not_zero(sin(WORST / 2), half, times=S.One)]
    known += [cosine, not_zero(other, cosine, times=S.One), not_zero(d + 1, late, times=S.One)]
    known.append(not_zero(other / (2 * sin(WORST / 2)), cosine, times=2 * sin(WORST / 2)))
    return STIFFEST.proved(*known)


@cache
def linear() -> Theorem:
    """The linear condition."""
    return LINEAR.proved(combined(Ne(d + HALF, 0), [positive(d + HALF > 0, [d >= 0], [HALF, one()])]))
