"""The error (26) of the linear condition where the boundary starts: it has no bound there."""

from symhaptic.book.lemmas.arm_numbers import ARM, BY_NUMBERS, TOTAL, signs, together
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.stability import SQUARE, damping, stiffness

GIVEN = (*ARM[1:], gamma * delta > 0, d >= 0)
ACROSS = stiffness() / (cos(theta / 2) * SQUARE)
UP = damping() / (sin(theta) * SQUARE)
APART = (UP + delta) / (d + HALF) - ACROSS
"""alpha_lin - alpha at the damping of the boundary."""

WIDTH = (s_2 + (d + 1) * s_1 + d * (d + 1) * gamma / 2).xreplace(BY_NUMBERS)
_PLACE = Symbol("q")
_FREE = 1 + e - gamma * TOTAL
"""What a is, by the other numbers."""


def unbounded() -> Proposition:
    """At theta -> 0 the reciprocal of alpha_lin - alpha over alpha + gamma tends to zero.

    The error itself is defined near the start, as alpha + gamma is of order theta^2 there.
    """
    near = And(
        (
            limit_at_start((ACROSS + gamma) / theta**2, WIDTH),
            Relation(S.Zero, "<", WIDTH),
            limit_at_start((ACROSS + gamma) / APART, S.Zero),
        )
    )
    return every((gamma, delta, d), GIVEN, every(NUMBERS, ARM[:1], near))


def limit_at_start(expr: Expr, value: Expr) -> Predicate:
    """What tends to a value at the start of the boundary."""
    return Predicate("limit", (theta,), (expr, S.Zero, value))


@cache
def no_bound() -> Theorem:
    """The theorem of :func:`unbounded`, but for its outer quantifier, as hypotheses."""
    found = conj(
        tends_at_start((ACROSS + gamma) / theta**2, WIDTH),
        width(),
        tends_at_start((ACROSS + gamma) / APART, S.Zero),
    )
    return for_all(NUMBERS, ARM[:1], found)


def tends_at_start(expr: Expr, value: Expr, arm: Terms | None = None) -> Theorem:
    """A limit at the start, with a by the other numbers of the device at rest."""
    arm = arm or {}
    static = device_static(assume(DEVICE.at(arm)))
    rest, expr, value = (x.xreplace(dict(arm)) for x in (_FREE, expr, value))
    limit = closed(tends(expr.xreplace({a: rest}), theta, S.Zero, value), *apart(arm))
    equal = combined(Relation(rest, "=", a), [static, S.One])
    pattern = limit_at_start(expr.xreplace({a: _PLACE}), value)
    return closed(subst(pattern, _PLACE, limit, equal), *apart(arm))


def apart(arm: Terms) -> tuple[Theorem, ...]:
    """What limits divide by is not zero: of n_1 + n_0 and, without a given arm, the gap."""
    total = inst(together(), dict(arm)) if arm else together()
    powers = [(n, k) for k in (1, 2, 3) for n in (1, 2, 12)]
    found = [
        positive(Relation(expanded(n * TOTAL**k), "!=", S.Zero), [n, *[total] * k])
        for n, k in powers
    ]
    return (*found, *(() if arm else divisors()))


@cache
def width() -> Theorem:
    """0 < s_2 + (d+1) s_1 + d (d+1) gamma/2."""
    known = signs()
    mass, line = (conjunct(known, p) for p in known.conclusion.parts[2:4])
    first = positive(BY_NUMBERS[s_1] >= 0, [line], [delta >= 0], [HALF, gamma >= 0])
    sprung = [HALF, d >= 0, d >= 0, gamma >= 0], [HALF, d >= 0, gamma >= 0]
    return closed(positive(WIDTH > 0, [mass], [d >= 0, first], [first], *sprung), *divisors())


@cache
def divisors() -> tuple[Theorem, ...]:
    """n_1 + n_0, d + 1/2 and, for 0 < gamma delta, the gap are not zero."""
    total, known = together(), signs()
    above = mp(conjunct(known, known.conclusion.parts[4]), assume(gamma * delta > 0))
    apart = positive(Ne(TOTAL, 0), [total])
    start = 2 * delta * n_0 + 2 * delta * n_1 + 2 * e - gamma * n_0 + gamma * n_1 - 2
    below = closed(positive(start < 0, [2, above, total]), apart)
    return (
        apart,
        positive(Relation(expanded(TOTAL**2), "!=", S.Zero), [total, total]),
        positive(Relation(expanded(2 * TOTAL**2), "!=", S.Zero), [2, total, total]),
        positive(Ne(d + HALF, 0), [d >= 0], [HALF]),
        positive(Ne(start, 0), [below]),
    )
