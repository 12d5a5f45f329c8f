"""Bounds of gamma and delta by what arm and device have on their own."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import second
from symhaptic.paper.propositions.arm import y_D, y_H

PLAIN = dict.fromkeys((T, m_D, m_H, b_D, b_H, k_H, delta), S.One) | {gamma: S.Half}
"""An arm and a device in ones."""
WHOLE = {m: S(2), b: S(2), k: S.One}
"""Mass, damper and spring of both."""
SPRING, DAMPER = T**2 * k_H / (m_D + m_H), T * (b_D + b_H) / (m_D + m_H)
"""gamma and delta of (19)."""


MASSES = Given(m_D > 0, m_H > 0)


def numbers(claim: Proposition) -> Theorem:
    """gamma and delta of (19), from Table I for the m, b and k of (2)."""
    _, given, then = taken_apart(claim)
    mass, damper, spring, stiff, slow = (assume(p) for p in given[-5:])
    share = {gamma: T**2 * k_H, delta: T * (b_D + b_H)}
    found = [
        combined(wanted, [rule, S.One], [part, power / m], [mass, -share[name] / (m * (m_D + m_H))])
        for wanted, name, rule, part, power in zip(
            then.parts, (gamma, delta), (stiff, slow), (spring, damper), (T**2, T), strict=True
        )
    ]
    here = Given(m_D > 0, m_H >= 0, mass)
    return here.closed(conj(*found))


p = Symbol("p")
"""The device's share of the mass."""


def weighted(claim: Proposition) -> Theorem:
    """delta/T is the mean of x and y with the weights p and 1 - p, which are positive."""
    _, given, then = taken_apart(claim)
    plain, mean, above, below = then.parts
    rules = {r.left: assume(r) for r in given if isinstance(r, Relation) and r.sign == "="}
    here = MASSES.and_(T > 0)
    own = m_D / (m_D + m_H)
    made = combined(
        mean,
        [rules[delta], S.One],
        [rules[p], -T * (x - y)],
        [rules[x], -T * own],
        [rules[y], -T * (1 - own)],
    )
    found = combined(plain, [rules[delta], 1 / T]), made
    return here.closed(conj(*found, *(here.show(part, rules[p]) for part in (above, below))))


def _named(claim: Proposition, above: list[Theorem]) -> list[Theorem]:
    """The parts of a claim on gamma and delta from those on (19)."""
    _, given, then = taken_apart(claim)
    rules = {p.left: p for p in given if isinstance(p, Relation) and p.sign == "="}
    found = []
    for part, known in zip(then.parts, above, strict=True):
        wanted: Any = part.parts[1] if isinstance(part, Implies) else part
        found.append(MASSES.closed(show(wanted, known, rules[wanted.left])))
    return found


def bounds(claim: Proposition) -> list[Theorem]:
    """gamma < T^2 k_H/m_H and delta < T (b_D/m_D + b_H/m_H), if k_H, b_D and b_H > 0."""
    here = MASSES.and_(T > 0)
    softer = here.show(T**2 * k_H / m_H - SPRING > 0, k_H > 0)
    calmer = here.show(T * (b_D / m_D + b_H / m_H) - DAMPER > 0, b_D > 0, b_H > 0)
    return _named(claim, [softer, calmer])


def limits(claim: Proposition) -> list[Theorem]:
    """gamma <= T^2 x and delta <= T (y_D + y_H) from limits x, y_D and y_H per mass.

    And delta <= T y from y_D, y_H <= y.
    """
    spring = MASSES.and_(T > 0, k_H >= 0, k_H / m_H <= x)
    spring.have(k_H / m_H >= 0)
    damper = MASSES.and_(T > 0, b_D >= 0, b_H >= 0, b_D / m_D <= y_D, b_H / m_H <= y_H)
    damper.have(b_D / m_D >= 0)
    damper.have(b_H / m_H >= 0)
    calm = damper.show(T * (y_D + y_H) - DAMPER >= 0)
    shared = damper.show(T * y - DAMPER >= 0, y_D <= y, y_H <= y)
    *sums, mean = _named(claim, [spring.show(T**2 * x - SPRING >= 0), calm, shared])
    return [*sums, disch(mean, y_D <= y, y_H <= y)]


def in_seconds(claim: Proposition) -> Theorem:
    """A relation between numbers over powers of the second, or one of several."""
    if isinstance(claim, Or):
        case = next(p for p in claim.of if _difference(p)[0] > 0)
        return disj(in_seconds(case), claim)
    return show(claim, second > 0)


def _difference(claim: Proposition) -> tuple[Expr, int]:
    """q and n, where the sides of a relation differ by q/s^n."""
    assert isinstance(claim, Relation)
    share, rate = (claim.right - claim.left).as_independent(second, as_Add=False)
    return share, int(-rate.as_base_exp()[1]) if share else 0


def in_numbers(claim: Proposition, at: Terms) -> Theorem:
    """Relations that hold in numbers, where symbols equal these."""
    found = []
    for wanted in claim.parts:
        known = fact(wanted.at(at))
        for name, value in at.items():
            place = Symbol("q")
            turned = combined(Relation(value, "=", name), [assume(Eq(name, value)), -S.One])
            known = subst(wanted.at({name: place}), place, known, turned)
        found.append(known)
    return conj(*found)


def within(spring: Expr, damper: Expr, device: Expr) -> list[Theorem]:
    """0 <= gamma < T^2 spring/s^2 and 0 <= delta < T (damper + device)/s, of (19).

    From limits in units of a second: of the arm's stiffness and damping per mass, and of the
    device's damping per mass.
    """
    here = MASSES.and_(T > 0, second > 0)
    here.have(T**2 > 0)
    rate = here.have(1 / second > 0)
    stiff, both = spring / second**2, (damper + device) / second
    soft, calm, light = (
        k_H / m_H <= stiff,
        b_H / m_H <= damper / second,
        b_D / m_D < device / second,
    )
    above = positive(
        T**2 * (stiff * (m_D + m_H) - k_H) > 0,
        [T > 0, T > 0, soft, m_H > 0],
        [spring, T > 0, T > 0, rate, rate, m_D > 0],
    )
    slower = positive(
        T * (both * (m_D + m_H) - b_D - b_H) > 0,
        [T > 0, light, m_D > 0],
        [T > 0, calm, m_H > 0],
        [damper, T > 0, rate, m_D > 0],
        [device, T > 0, rate, m_H > 0],
    )
    mass = MASSES.show(m_D + m_H > 0)
    return [
        here.show(SPRING >= 0, k_H >= 0),
        here.closed(show(T**2 * stiff > SPRING, over(T**2 * stiff - SPRING > 0, above, mass))),
        here.show(DAMPER >= 0, b_D >= 0, b_H >= 0),
        here.closed(show(T * both > DAMPER, over(T * both - DAMPER > 0, slower, mass))),
    ]
