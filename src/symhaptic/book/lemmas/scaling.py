"""Loops that differ in their units only, and walls that no other part of theirs can make stable."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import damping_between, no_stiffer, on_box
from symhaptic.model.circle import powers
from symhaptic.paper.propositions.stability import HEAVY, MORE, SOON, STIFFER, STRONGER, in_units
from symhaptic.paper.propositions.stability import SHARE as LIGHTER
from symhaptic.proof.theorems.definitions import loop_substituted

DAMPER, SPRING = MORE[1:]
"""Damper and spring of another loop."""

RATE = [Eq(DAMPER, 2 * b), Eq(SPRING, 4 * k)]
"""b T/m and k T^2/m are kept at half the period."""

KEPT = [Eq(DAMPER * SOON / HEAVY, b * T / m), Eq(SPRING * SOON**2 / HEAVY, k * T**2 / m)]
"""The same for another period and another mass."""

HELD = [Eq(DAMPER / HEAVY, b / m), Eq(SPRING / HEAVY, k / m)]
"""Damper and spring grow with the mass."""

FASTER = [Eq(DAMPER, y * b), Eq(SPRING, y**2 * k)]
"""b T/m and k T^2/m are kept at y times the rate."""

NOTHING = [proposition(Eq(b, 0)), proposition(Eq(k, 0))]
"""Without damper and spring."""

APART = [positive(Ne(s, 0), s > 0) for s in (T, m, SOON, HEAVY)]


@cache
def at_twice_the_rate() -> Theorem:
    """K has a stable B at T <=> K' = 4 K has one at T/2, under RATE."""
    before = in_units(K, B, T, m, b, k)
    after = in_units(STIFFER, B, T / 2, m, DAMPER, SPRING)
    return _same(B, before, after, 2 * B, B / 2, [Eq(STIFFER, 4 * K), *RATE])


@cache
def for_another_mass_and_rate() -> Theorem:
    """B has a stable K <=> B' = B (m'/T')/(m/T) has one for m' and T', under KEPT."""
    before = in_units(K, B, T, m, b, k)
    after = in_units(K, STRONGER, SOON, HEAVY, DAMPER, SPRING)
    more, wall = HEAVY * T**2 / (m * SOON**2), Eq(STRONGER, B * (HEAVY / SOON) / (m / T))
    return _same(K, before, after, K * more, K / more, [wall, *KEPT])


def _same(
    free: Symbol, before: Proposition, after: Proposition, up: Expr, down: Expr, kept: list[Any]
) -> Theorem:
    there = _carried(free, before, after, up, kept)
    here = _carried(free, after, before, down, kept)
    found = either_way(there, here, Exists((free,), before), Exists((free,), after))
    return closed(found, *APART)


def _carried(
    free: Symbol, before: Proposition, after: Proposition, value: Expr, kept: list[Any]
) -> Theorem:
    """There is a value for which ``after`` is stable, if there is one for ``before``."""
    other = Symbol(f"{free}'")
    named = Relation(other, "=", value)
    wall, damper, spring = map(assume, kept)
    pair = (assume(named), wall) if free == K else (wall, assume(named))
    known = [*pair, spring, damper]
    found = moved(assume(before), after.at({free: other}), known)
    some = exists(found, Exists((free,), after), {free: other})
    there_is = exists(identity(value, value), Exists((other,), named), {other: value})
    return choose(assume(Exists((free,), before)), choose(there_is, some))


def moved(found: Theorem, wanted: Any, known: Sequence[Theorem | None]) -> Theorem:
    """A stable loop in other terms, each equal to the old one by an equation or by itself."""
    place = Symbol("q")
    for i, equation in enumerate(known):
        terms = list(found.conclusion.terms)
        difference = wanted.terms[i] - terms[i]
        if equation is not None and difference != 0:
            left, right = equation.conclusion.terms
            share = sp.cancel(difference / (right - left))
            same = combined(Relation(terms[i], "=", wanted.terms[i]), [equation, share])
            terms[i] = place
            found = subst(Predicate(wanted.name, (), tuple(terms)), place, found, same)
    return found


@cache
def with_the_mass(stiffer: Symbol, stronger: Symbol) -> Theorem:
    """K and B are stable <=> K' = (m'/m) K and B' = (m'/m) B with the mass m', under HELD."""
    before = in_units(K, B, T, m, b, k)
    after = in_units(stiffer, stronger, T, HEAVY, DAMPER, SPRING)
    wall = Eq(stiffer, K * HEAVY / m), Eq(stronger, B * HEAVY / m)
    return _both_ways(before, after, wall, HELD)


@cache
def with_the_stiffness(stiffer: Symbol) -> Theorem:
    """K'/m' = K/m, and both walls are stable or none, for K' = (m'/m) K and all else like it."""
    grown = HEAVY / m
    before = in_units(K, B, T, m, b, k)
    after = in_units(stiffer, B * grown, T, HEAVY, b * grown, k * grown)
    equally = assume(Eq(stiffer, K * grown))
    same = combined(Eq(stiffer / HEAVY, K / m), [equally, 1 / HEAVY])
    known = [equally, None, None, None]
    there, back = moved(assume(before), after, known), moved(assume(after), before, known)
    return closed(conj(same, either_way(there, back, before, after)), *APART)


@cache
def with_the_rate(stiffer: Symbol, stronger: Symbol) -> Theorem:
    """K and B are stable <=> K' = y^2 K and B' = y B are at y times the rate, under FASTER."""
    before = in_units(K, B, T, m, b, k)
    after = in_units(stiffer, stronger, T / y, m, DAMPER, SPRING)
    wall = Eq(stiffer, y**2 * K), Eq(stronger, y * B)
    return closed(_both_ways(before, after, wall, FASTER), positive(Ne(y, 0), y > 0))


def _both_ways(
    before: Proposition, after: Proposition, wall: Sequence[Any], kept: list[Any]
) -> Theorem:
    known = [*map(assume, wall), assume(kept[1]), assume(kept[0])]
    there, back = moved(assume(before), after, known), moved(assume(after), before, known)
    return closed(either_way(there, back, before, after), *APART)


def free_mass(theorem: Theorem, kept: Sequence[Any]) -> Theorem:
    """The same with one damper and spring, b = 0 and k = 0, which ``kept`` keeps."""
    same = {DAMPER: b, SPRING: k}
    found = inst(theorem, same)
    for equation, symbol, none in zip(kept, (b, k), NOTHING, strict=True):
        wanted: Any = proposition(equation).at(same)
        share = sp.expand((wanted.left - wanted.right) / symbol)
        found = closed(found, combined(wanted, [assume(none), share]))
    return closed(found, *APART)


@cache
def lighter_hands() -> Theorem:
    """What a lighter hand leaves of the walls; and that it is more beside a heavier device."""
    walls, rises = CLAIMED["s6-light-device"](()).parts
    heavy, light = m_D + m_H, m_D + LIGHTER * m_H
    both_ = [m_H > 0, LIGHTER >= 0]
    masses = positive(heavy > 0, m_D > 0, m_H > 0), positive(light > 0, [m_D > 0], both_)
    free = free_mass(with_the_mass(STIFFER, STRONGER), HELD)
    found = inst(free, {m: heavy, HEAVY: light, b: S.Zero, k: S.Zero})
    rest = light / heavy
    found = inst(found, {STIFFER: K * rest, STRONGER: B * rest})
    zero = identity(S.Zero, S.Zero)
    apart = [positive(Ne(t.conclusion.right, 0), [t]) for t in masses]  # type: ignore[attr-defined]
    same = [identity(wall * rest, wall * rest) for wall in (K, B)]
    found = closed(found, zero, *same, *masses, *apart)
    kept = as_claimed(walls, found)
    less = taken_apart(rises)[2]
    lost = positive(m_H * (1 - LIGHTER) * (HEAVY - m_D) > 0, [m_H > 0, LIGHTER < 1, m_D < HEAVY])
    more = positive(HEAVY + m_H > 0, [m_D < HEAVY], [m_D > 0], [m_H > 0])
    size = combined((HEAVY + m_H) * heavy > 0, [more, masses[0]])
    top, bottom = lost.conclusion.right, size.conclusion.right  # type: ignore[attr-defined]
    gap = combined(less, [over(top / bottom > 0, lost, size)])
    apart = [positive(Ne(t.conclusion.right, 0), [t]) for t in (more, masses[0], size)]  # type: ignore[attr-defined]
    steep = as_claimed(rises, closed(gap, *apart))
    return conj(kept, steep)


# -- walls that cannot be made stable ----------------------------------------------------


def never(free: Symbol, wall: Proposition) -> Theorem:
    """No value of a symbol makes a loop without delay stable."""
    values = wall.terms
    parts = {"stiffness": values[2] != 0, "damping": values[3] != 0}
    loop = closed(loop_substituted(values, z, 1, **parts), fact(whole(values[4])))
    found = mp(loop, assume(wall))
    contrary = _too_damped(found) if free == K else _too_stiff(found, free)
    some = Exists((free,), wall)
    wrong = choose(assume(some), contr(contrary, Relation(S.One, "<", S.Zero)))
    return not_intro(wrong, number(Relation(S.Zero, "<=", S.One)), some)


def none_as_stiff(free: Symbol, wall: Predicate) -> Theorem:
    """No damping makes a wall of this stiffness stable without delay, for an arm of (23)."""
    limit = wall.of[0]
    less = no_stiffer(0, (limit, Rational(828, 1000)), _arm(wall))
    return _none(less, free, wall, Relation(limit, "<", limit))


def none_as_damped(free: Symbol, wall: Predicate) -> Theorem:
    """No stiffness makes a wall of this damping stable without delay, for an arm of (23)."""
    limit, arm = wall.of[1], _arm(wall)
    *_, inside = damping_between(0, arm)
    wrong = Relation(S.One, "<", S.One)
    more = on_box(n_0 * limit - 1, arm)
    never = combined(wrong, [inst(inside, {beta: limit})], [more])
    return _none(of_every_plant(never), free, wall, wrong)


def _arm(wall: Predicate) -> dict[Symbol, tuple[Expr, Expr]]:
    return {
        symbol: (value, value) for symbol, value in zip((gamma, delta), wall.of[2:4], strict=True)
    }


def _none(never: Theorem, free: Symbol, wall: Predicate, wrong: Relation) -> Theorem:
    """There is no such wall: of one that were stable something wrong is shown."""
    values = dict(zip((alpha, beta, gamma, delta), wall.of[:4], strict=True))
    some = Exists((free,), wall)
    found = choose(assume(some), numbers_known(inst(never, values)))
    return not_intro(found, number(Relation(wrong.right, "<=", wrong.left)), some)


def _too_damped(inside: Theorem) -> Theorem:
    """The product of the zeros is not below 1."""
    product = last_coefficient(inside)
    above = conjunct(product, product.conclusion.parts[0])
    last = above.conclusion.terms[1]
    return not_intro(above, number(Relation(last, "<=", -S.One)))


def _too_stiff(inside: Theorem, free: Symbol) -> Theorem:
    """The last minor is not positive where the second half plane, u > 0, is.

    With u for the damping it is -A u^2 - D u - C, and -A (u - r)^2 - (D + 2 A r) u - (C - A r^2).
    """
    criterion = mp(jury(inside.conclusion.terms[0], z), inside)
    _, plane, _, minor = (conjunct(criterion, p) for p in criterion.conclusion.parts)
    u = plane.conclusion.terms[1]
    slope, place = u.coeff(free, 1), Symbol("u")
    least = minor.conclusion.terms[1]
    turned = powers(-least.subs(free, (place - u.coeff(free, 0)) / slope), place)
    high, low, last = (turned.get(n, S.Zero) for n in (2, 1, 0))
    r = Rational(int(1000 * sp.sqrt((last / high).n(30))), 1000)
    sizes = high, low + 2 * high * r, last - high * r**2
    signs = [number(Relation(S.Zero, "<", size)) for size in sizes]
    sums = [signs[0], square(u - r)], [signs[1], plane], [signs[2]]
    return not_intro(minor, combined(Relation(least, "<=", S.Zero), *sums))
