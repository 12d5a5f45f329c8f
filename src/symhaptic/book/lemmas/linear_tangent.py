"""The line (25) is the tangent of the boundary, where that starts, for a free mass only."""

from sympy import Rel

from symhaptic.book.lemmas.arm_numbers import ARM, BY_NUMBERS, GAP, TOTAL, pushed, share, signs
from symhaptic.book.lemmas.linear_start import (
    ACROSS,
    UP,
    WIDTH,
    apart,
    limit_at_start,
    tends_at_start,
    width,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.analysis import no_other_limit
from symhaptic.proof.theorems.samples import after_a_blow

GIVEN = (*ARM[1:], d >= 0)
FREE = {gamma: S.Zero, delta: S.Zero}
SURPLUS = UP + delta - (d + HALF) * ACROSS
"""How far the boundary lies above the line."""

_BENT = 6 * (1 - 2 * nu) * s_2 + 6 * (d + 1) ** 2 * s_1 + gamma * d * (d + 1) * (4 * d + 5)
LOW = (-_BENT / 12).xreplace(BY_NUMBERS)
_PLACE = Symbol("q")
_ON = (limit_at_start(SURPLUS, S.Zero), limit_at_start(SURPLUS / theta**2, S.Zero))


def tangent() -> Proposition:
    """The boundary starts on the line and along it, for a free mass and for no other arm.

    Both its surplus over the line, and that per alpha + gamma, of order theta^2, tend to zero.
    """
    only = implied(_ON, both(map(_zero, FREE)))
    free = every(NUMBERS, [DEVICE.at(FREE)], both(p.at(FREE) for p in _ON))
    arms = every(NUMBERS, [DEVICE], both([*_wide(), only]))
    return every((gamma, delta, d), GIVEN, both([arms, free]))


def _wide() -> tuple[Proposition, ...]:
    return limit_at_start((ACROSS + gamma) / theta**2, WIDTH), Relation(S.Zero, "<", WIDTH)


def _zero(of: Expr) -> Relation:
    return Relation(of, "=", S.Zero)


@cache
def free_mass_only() -> Theorem:
    """What :func:`tangent` concludes; its conditions are hypotheses."""
    arms = for_all(
        NUMBERS,
        [DEVICE],
        conj(tends_at_start((ACROSS + gamma) / theta**2, WIDTH), width(), _only()),
    )
    free = for_all(NUMBERS, [DEVICE.at(FREE)], _along())
    return conj(arms, free)


def _only() -> Theorem:
    """No spring and no damper where the line is the tangent."""
    below = tends_at_start(SURPLUS, -GAP)
    level = _must(-GAP, below, _ON[0])
    beyond = tends_at_start((SURPLUS + GAP) / theta**2, LOW)
    pattern = limit_at_start((SURPLUS - _PLACE) / theta**2, LOW)
    flat = _must(LOW, subst(pattern, _PLACE, beyond, level), _ON[1])
    known = signs()
    mass, line = (conjunct(known, p) for p in known.conclusion.parts[2:4])
    first = positive(BY_NUMBERS[s_1] >= 0, [line], [delta >= 0], [HALF, gamma >= 0])
    slim = positive(HALF - BY_NUMBERS[nu] >= 0, [share()[1]])
    sums = [2, slim, mass], [d >= 0, d >= 0, first], [2, d >= 0, first], [line]
    late = [[Rational(n, 6), gamma >= 0, *[d >= 0] * k] for k, n in ((3, 4), (2, 9), (1, 5))]
    ends = {delta: (1, [HALF, gamma >= 0]), gamma: (2, [delta >= 0])}
    zeros = []
    for of, (times, rest) in ends.items():
        rows = [[times, *row] for row in (*sums, *late, rest)]
        less = _sum(of <= 0, rows, [flat, -2 * S(times)])
        zeros.append(both_ways(less, positive(of >= 0, of >= 0)))
    return disch(closed(conj(*reversed(zeros)), *apart({})), *_ON)


def _sum(claim: object, rows: list[list[object]], equation: list[object]) -> Theorem:
    made = [[assume(p) if isinstance(p, Rel) else p for p in row] for row in rows]
    return combined(claim, *made, equation)


def _must(value: Expr, limit: Theorem, claim: Proposition) -> Theorem:
    """What tends to a value, and to zero as assumed, tends to a value that is zero."""
    equal = _zero(value)
    other = no_other_limit(limit, assume(Relation(value, "!=", S.Zero)))
    never = contr(not_intro(assume(claim), other), equal)
    return disj_cases(decided(value, S.Zero), assume(equal), never)


def _along() -> Theorem:
    """Of a free mass n_1 = n_0 and e = 1, so that its boundary starts along the line."""
    device = assume(DEVICE.at(FREE))
    nothing = number(Relation(S.Zero, "<=", S.Zero))
    known = nothing, number(Relation(S.Zero, "<", pi**2))
    image = of_device("device's loss", device)
    less = inst(pushed()[2], FREE)
    more = positive(n_0 >= n_1, [after_a_blow(device, -1, 1, u, 0, nothing)])
    same = both_ways(less, more)
    gap, low = GAP.xreplace(FREE), LOW.xreplace(FREE)
    level = combined(_zero(gap), [image, -1 / TOTAL])
    rest = BY_NUMBERS[s_2].xreplace(FREE)
    flat = combined(_zero(low), [image, (d + 1) ** 2 / (2 * TOTAL)], [same, rest / (2 * TOTAL)])
    start = tends_at_start(SURPLUS, -GAP, FREE)
    first = subst(limit_at_start(SURPLUS.xreplace(FREE), -_PLACE), _PLACE, start, level)
    bare = SURPLUS.xreplace(FREE)
    beyond = tends_at_start((SURPLUS + GAP) / theta**2, LOW, FREE)
    pattern = limit_at_start((bare + _PLACE) / theta**2, low)
    second = subst(pattern, _PLACE, beyond, level)
    second = subst(limit_at_start(bare / theta**2, _PLACE), _PLACE, second, flat)
    return closed(conj(first, second), *apart(FREE), *known)
