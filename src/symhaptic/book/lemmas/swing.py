"""With which frequency does a damped mass on a spring swing?"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.familiar import divided, swinging

RATE = Symbol("sigma")
MOVING = (m, b, k, omega)
SWINGS = Predicate("swings", (), MOVING)
SQUARE = k / m - b**2 / (4 * m**2)
"""omega^2 of a device that swings."""


@cache
def swings() -> Theorem:
    """swings <=> omega^2 = k/m - b^2/(4 m^2), for m > 0 and omega > 0."""
    meaning = swinging(MOVING, RATE)
    some = meaning.conclusion.of[1]  # type: ignore[attr-defined]
    sine, cosine = (assume(p) for p in some.body.of)
    rate = -b / (2 * m)
    apart = [positive(Ne(s, 0), s > 0) for s in (m, omega)]
    slow = combined(Eq(RATE, rate), [cosine, 1 / (2 * m * omega)])
    wanted = proposition(Eq(omega**2, SQUARE))
    there = choose(assume(some), combined(wanted, [sine, -1 / m], [slow, RATE - rate]))
    damped = identity(2 * m * rate * omega + b * omega, S.Zero)
    square = assume(wanted)
    swung, slowed = (claim.at({RATE: rate}) for claim in some.body.of)
    held = combined(swung, [square, -m])
    still = combined(slowed, [damped, S.One])
    same = either_way(there, exists(conj(held, still), some, {RATE: rate}), some, wanted)
    return closed(chained(meaning, same), *apart)


@cache
def by_its_square(radicand: Expr) -> Theorem:
    """omega = sqrt(x) <=> omega^2 = x, for 0 <= x and omega > 0."""
    root = sign_of(sqrt, x)
    value, wanted = proposition(Eq(omega, sqrt(x))), proposition(Eq(omega**2, x))
    there = combined(wanted, [assume(value), omega + sqrt(x)])
    both = omega + sqrt(x)
    apart = positive(Ne(both, 0), [omega > 0], [root])
    back = closed(combined(value, [assume(wanted), 1 / both]), apart)
    return inst(either_way(there, back, value, wanted), {x: radicand})


def rewritten(left: Theorem, right: Theorem) -> Theorem:
    """p <=> r from p <=> q and r <=> q."""
    p = left.conclusion.of[0]  # type: ignore[attr-defined]
    r = right.conclusion.of[0]  # type: ignore[attr-defined]
    return either_way(mp(right, mp(left, assume(p))), mp(left, mp(right, assume(r))), p, r)


@cache
def up_to_nyquist() -> Theorem:
    """gamma - delta^2/4 <= pi^2 <=> omega <= pi/T, for (29), gamma >= delta^2/4 and T > 0."""
    turns = sqrt(gamma - delta**2 / 4)
    value = assume(Eq(omega, turns / T))
    real = positive(gamma - delta**2 / 4 >= 0, gamma >= delta**2 / 4)
    root = closed(sign_of(sqrt, gamma - delta**2 / 4), real)
    both = positive(pi + turns > 0, [number(Relation(S.Zero, "<", pi))], [root])
    small, slow = proposition(gamma - delta**2 / 4 <= pi**2), proposition(omega <= pi / T)
    below = divided(proposition(turns <= pi), assume(small), both)
    there = combined(slow, [below, over(1 / T > 0, one(), T > 0)], [value])
    back = combined(small, [assume(slow), assume(T > 0), both], [value, -T * (pi + turns)])
    apart = positive(Ne(T, 0), T > 0), positive(Ne(pi + turns, 0), [both])
    return either_way(closed(there, *apart), closed(back, *apart), small, slow)


@cache
def spring_of_nyquist() -> Theorem:
    """k = pi^2 m/T^2 + b^2/(4 m) <=> the device swings with pi/T, for m > 0 and T > 0."""
    spring = proposition(Eq(k, pi**2 * m / T**2 + b**2 / (4 * m)))
    there = inst(swings(), {omega: pi / T})
    same = there.conclusion.of[1]  # type: ignore[attr-defined]
    square = combined(same, [assume(spring), -1 / m])
    value = combined(spring, [mp(there, assume(there.conclusion.of[0])), -m])  # type: ignore[attr-defined]
    both = either_way(mp(there, square), value, spring, there.conclusion.of[0])  # type: ignore[attr-defined]
    fast = over(pi / T > 0, number(Relation(S.Zero, "<", pi)), T > 0)
    return closed(both, fast, *(positive(Ne(s, 0), s > 0) for s in (m, T)))
