"""A wall that meets the passivity condition at every angle keeps every damped device stable."""

from symhaptic.book.lemmas.passivity import at_every_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.model.passivity import margin
from symhaptic.proof.theorems.familiar import linear

LOOP = (alpha, beta, gamma, delta, d)
MARGIN = margin().xreplace({K: alpha, B: beta, b: delta, T: sp.S.One})
"""delta - alpha sin((d+1/2) theta)/(2 sin(theta/2)) + beta cos((d+1) theta)."""
EVERY_MARGIN = at_every_angle(MARGIN >= 0)


@cache
def margin_to_the_end(margin_: Expr = MARGIN) -> Theorem:
    """0 <= margin for 0 < theta <= pi, from the angles below pi."""
    always = assume(at_every_angle(margin_ >= 0))
    below = at(always, {theta: theta}, *map(assume, INSIDE))
    end = margin_.xreplace({theta: pi})
    limit = tends(margin_, theta, pi, end)
    last = in_the_limit(below, theta, sp.S.Zero, pi, limit)
    last = prove_hyp(last, number(sp.Lt(0, pi, evaluate=False)))
    equal = both_ways(assume(theta >= pi), assume(theta <= pi))
    return disj_cases(ordered(theta, pi), below, subst(margin_ >= 0, theta, last, equal))


@cache
def sine_not_zero() -> Theorem:
    """sin(theta/2) != 0 for 0 < theta <= pi."""
    return Given(theta > 0, theta <= pi).show(Ne(sin(theta / 2), 0))


@cache
def no_crossing() -> Theorem:
    """p(exp(j theta)) != 0 for the wall turned up to y, 0 < y <= 1 and 0 < theta <= pi."""
    turn = exp(I * theta)
    way = (turn - 1) * (n_1 * turn + n_0)
    delayed = exp(I * (d + 1) * theta)
    plant = turn**2 - a * turn + e
    wall = (n_1 * turn + n_0) * ((alpha + beta) * turn - beta)
    path = delayed * plant + y * wall
    energy = held_steady_state(assume(DEVICE), theta)
    gain = energy.conclusion.right - energy.conclusion.left  # type: ignore[attr-defined]
    eased = delta + y * (MARGIN - delta)
    safe = positive(eased >= 0, [y <= 1, delta > 0], [y > 0, margin_to_the_end()])
    size = way * mirror(way)
    along, across = (way + mirror(way)) / 2, (way - mirror(way)) / (2 * I)
    nonnegative = combined(size >= 0, [square(along)], [square(across)])
    apart = sine_not_zero()
    both = closed(combined(gain + size * eased > 0, [energy], [nonnegative, safe]), apart)
    root = assume(sp.Eq(path, 0))
    turned = way * delayed / 2
    balance = combined(
        Relation(sp.S.Zero, "=", gain + size * eased),
        [mirrored(root), -turned],
        [root, -mirror(turned)],
    )
    return by_contradiction(Ne(path, 0), both, closed(balance, apart))


@cache
def passive_is_stable() -> Theorem:
    """stable, from the margin at every angle, 0 <= gamma, 0 < delta, 0 < alpha + gamma, d whole."""
    stable = turned_up(d + 1, n_1 * z + n_0, no_crossing())
    found = loop_of_device(NUMBERS, LOOP)
    readings = [conjunct(found, reading) for reading in found.conclusion.of]  # type: ignore[attr-defined]
    both = conj(*(mp(reading, closed(stable, *LATER_WHOLE)) for reading in readings))
    return choose(device_exists(gamma, delta, NUMBERS), both)


def turned_up(power: Expr, top: Expr, crossing: Theorem, *same: Theorem) -> Theorem:
    """All zeros of z^power A + top W lie inside, if none crosses on the way from no wall.

    ``same`` says that top is n_1 + n_0 at z = 1, where it is not so by its form.
    """
    device = assume(DEVICE)
    rest = device_at_rest(device)
    static, pushed, decay = (conjunct(rest, claim) for claim in rest.conclusion.of)  # type: ignore[attr-defined]
    stiff = positive(y * alpha + gamma > 0, [y > 0, alpha + gamma > 0], [y <= 1, gamma >= 0])
    total = top.subs(z, 1)
    at_one = combined(
        Ne((1 - a + e) + y * total * alpha, 0),
        [pushed, stiff],
        [static, -sp.S.One],
        *([t, -y * alpha] for t in same),
    )
    plant, wall = z**2 - a * z + e, top * ((alpha + beta) * z - beta)
    held = all_inside(z, power, device_comes_to_rest(device))
    sprung = roots_stay(z**power * plant, wall, z, y, theta, crossing, at_one, held)
    pushes = positive(total > 0, [pushed], *([t, -sp.S.One] for t in same))
    free = _from_a_pole_at_one(power, top, crossing, static, pushes, decay)
    nothing = both_ways(assume(gamma <= 0), assume(gamma >= 0))
    return disj_cases(ordered(sp.S.Zero, gamma), sprung, prove_hyp(free, nothing))


def _from_a_pole_at_one(
    power: Expr, top: Expr, crossing: Theorem, static: Theorem, pushes: Theorem, decay: Theorem
) -> Theorem:
    """Without a spring one pole of the device lies at 1; the first stiffness moves it inwards."""
    place = sp.Symbol("q")
    free = assume(sp.Eq(gamma, 0))
    trace = combined(sp.Eq(a, 1 + e), [static, -1], [free, -(n_1 + n_0)])
    devices = (
        subst(known.at({a: place}), place, assume(known), trace)
        for known in crossing.hypotheses
        if a in known.free
    )
    pull = positive(alpha > 0, [alpha + gamma > 0], [free, 1])
    plant, wall = z**2 - (1 + e) * z + e, top * ((alpha + beta) * z - beta)
    crossing = prove_hyp(inst(crossing, {a: 1 + e}), *devices)
    total = top.subs(z, 1)
    at_one = positive(Ne(y * total * alpha, 0), [y > 0, pushes, pull])
    below_one = Given(delta > 0).closed(rising(exp, -delta, S.Zero))
    slow = combined(e < 1, [below_one], [decay, 1])
    last = combined(e > -1, [sign_of(exp, -delta)], [decay, -1], [sp.S.One])
    begin = all_inside(z, power, linear(z, last, slow))
    inwards = positive(total * alpha > 0, [pushes, pull]), positive(1 - e > 0, [slow])
    start = z**power * plant
    stable = roots_stay(start, wall, z, y, theta, crossing, at_one, begin, *inwards)
    back = combined(sp.Eq(1 + e, a), [trace, -1])
    pattern = Predicate("stable", (z,), (z**power * (z**2 - place * z + e) + wall,))
    return subst(pattern, place, stable, back)
