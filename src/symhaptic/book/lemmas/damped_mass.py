"""Without a spring and without delay: which walls of a damped mass are stable, delta <= 1/3.

The device has a = 1 + e and 1 - e = delta (n_1 + n_0), so that Jury's inequalities are made of n_1,
n_0 and delta.
"""

from symhaptic.book.lemmas.arm_numbers import pushed
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import damping_between, inequalities, on_box, towards
from symhaptic.proof.theorems.samples import after_a_blow

FREE = {gamma: S.Zero}
LIGHT = {gamma: (S.Zero, S.Zero), delta: (S.Zero, Rational(1, 3))}
WIDEST = S(3)
"""Stable walls have |beta| < 1/n_0, which is less."""
TOTAL = n_1 + n_0
MINOR = TOTAL * (beta + delta) * (1 - n_0 * beta) - n_0 * alpha * (1 + n_1 * beta)
"""The largest minor of such a device."""
WALLS = both([alpha > 0, beta > -delta, Relation(S.Zero, "<", MINOR)])


@cache
def slow() -> Theorem:
    """It swings less than half a turn in a period, as it does not swing at all."""
    return show(-(delta**2) / 4 < pi**2, square(delta))


@cache
def signs() -> tuple[Theorem, ...]:
    """0 < n_1, 0 < n_0 and n_0 <= n_1."""
    return tuple(numbers_known(closed(inst(t, FREE), slow())) for t in pushed())


@cache
def numbers() -> tuple[Theorem, Theorem]:
    """1 - a + e = 0 and 1 - e = delta (n_1 + n_0)."""
    device = assume(DEVICE.at(FREE))
    image = of_device("device's loss", device)
    nothing, test = number(Relation(S.Zero, "<=", S.Zero)), u * (1 - exp(-delta * u))

    def weak(claim: Any, sign: int) -> Theorem:
        way = after_a_blow(device, sign * delta, sign * delta, u, sign * test, nothing)
        return closed(combined(claim, [way], [image, -sign]), slow())

    loss = both_ways(weak(1 - e <= delta * TOTAL, 1), weak(1 - e >= delta * TOTAL, -1))
    return inst(device_static(assume(DEVICE)), FREE), loss


def said_of(claim: Any, known: Theorem) -> Theorem:
    """A relation that says the same of such a device, with a and e given by n_1, n_0 and delta."""
    static, loss = numbers()
    wanted, given = proposition(claim), known.conclusion
    difference = sp.expand(_difference(wanted) - _difference(given))
    by_trace = derivative(difference, a)
    by_loss = derivative(sp.expand(difference.subs(a, 1 + e)), e)
    return combined(wanted, [known], [static, by_trace], [loss, by_loss])


def _difference(claim: Any) -> Expr:
    found: Expr = claim.right - claim.left
    return found


def light(theorem: Theorem) -> Theorem:
    """What is known of all plants of the box, without a spring."""
    return numbers_known(inst(theorem, FREE))


@cache
def needed() -> Theorem:
    """0 < alpha, -delta < beta and 0 < MINOR for a stable wall."""
    low, high, inside = damping_between(0, LIGHT, WIDEST)
    *planes, minor = inequalities(0)
    toward = towards(planes, minor, inside, {**LIGHT, beta: (-WIDEST, WIDEST)})
    toward = closed(light(toward), light(low), light(high))
    first, second, _ = signs()
    rise = positive(TOTAL > 0, [first], [second])
    stiff = by_multiple(alpha > 0, rise, [said_of(TOTAL * alpha > 0, light(planes[0]))])
    kept = said_of(Relation(S.Zero, "<", MINOR), light(minor))
    lost = positive(MINOR < 0, [rise, beta <= -delta, light(inside)], [second, stiff, toward])
    damped = by_contradiction(-delta < beta, kept, lost)
    return closed(conj(stiff, damped, kept), not_zero(second))


@cache
def enough() -> Theorem:
    """Such a wall is stable."""
    push, brake, last = (assume(p) for p in WALLS.parts)
    first, second, apart = signs()
    rise = positive(TOTAL > 0, [first], [second])
    still = light(on_box(1 - delta * n_1, LIGHT))
    less = positive(1 - delta * n_0 > 0, [still], [delta >= 0, apart])
    more = positive(1 + delta * n_0 > 0, [1], [second, delta >= 0])
    above = positive(1 + n_1 * beta > 0, [still], [first, brake])
    soft = light(on_box((2 + e) * n_0 - n_1, LIGHT))
    soft = said_of(3 * n_0 - delta * TOTAL * n_0 - n_1 > 0, soft)
    both_ = positive(TOTAL * (beta + delta) > 0, [rise, brake])
    edge = by_multiple(1 - n_0 * beta > 0, both_, [last], [second, push, above])
    loop = inst(by_inequalities(0), FREE)
    at_one, at_half, flat, minor = loop.conclusion.of[1].parts  # type: ignore[attr-defined]
    plane = _of_damped(at_half)
    plane = positive(plane > 0, [2, rise, brake], [apart, push])
    third = _of_damped(flat)
    scale = positive((1 + delta * n_0) * n_0 * (1 + n_1 * beta) > 0, [more, second, above])
    third = by_multiple(
        third > 0,
        scale,
        [more, apart, last],
        [4, edge, second, still, less],
        [2, brake, rise, soft],
        [more, apart, apart, brake, edge],
    )
    found = conj(
        said_of(at_one, positive(TOTAL * alpha > 0, [rise, push])),
        said_of(at_half, plane),
        said_of(flat, third),
        said_of(minor, last),
    )
    return mp(loop, found)


def _of_damped(claim: Any) -> Expr:
    """What is positive, made of n_1, n_0 and delta."""
    found: Expr = claim.right.subs(a, 1 + e).subs(e, 1 - delta * TOTAL)
    return found


@cache
def stable_damped_mass() -> Theorem:
    """stable <=> 0 < alpha, -delta < beta and 0 < MINOR."""
    stable = inst(by_inequalities(0), FREE).conclusion.of[0]  # type: ignore[attr-defined]
    return either_way(needed(), enough(), stable, WALLS)
