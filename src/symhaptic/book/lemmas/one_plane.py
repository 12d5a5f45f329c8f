"""Figs. 11 and 13: what the curves of passive and of stable walls are, and which lies inside."""

from symhaptic.book.lemmas.boundary import at_rest, zero_on_circle_is_explicit
from symhaptic.book.lemmas.connections import passive_wall_is_stable
from symhaptic.book.lemmas.enclosed import enclosed_walls_are_stable
from symhaptic.book.lemmas.late_passivity import passive_late
from symhaptic.book.lemmas.normalised_boundary import ON_CURVE, above_in_units, in_units
from symhaptic.book.lemmas.passive_is_stable import LOOP
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.comparison import PASSIVE_WALL
from symhaptic.paper.propositions.passivity import BORDER
from symhaptic.paper.propositions.plots import solid
from symhaptic.paper.propositions.stability import at_angle

UNIT = {m: S.One, T: S.One, K: alpha, B: beta, b: DAMPED, delta: DAMPED}
"""Mass, period and damper of Fig. 11."""


def passive_curve(claim: Any) -> Theorem:
    """The walls of (27) for delta = 0.02, and no others, are on the boundary; d is whole."""
    found = []
    for implication, made in zip(claim.of, (in_units(), above_in_units(ON_CURVE)), strict=True):
        given, there = implication.of[0], inst(made, UNIT)
        known = [fact(h) for h in there.hypotheses if not h.free]
        there = closed(there, *known, *_same(there))
        if implication is claim.of[1]:
            there = closed(there, conjunct(assume(given), BORDER.at(UNIT)))
        found.append(disch(there, given))
    return conj(*found)


def _same(theorem: Theorem) -> list[Theorem]:
    """alpha = alpha and so on."""
    equal = [h for h in theorem.hypotheses if isinstance(h, Relation) and h.left == h.right]
    return [identity(h.left, h.right) for h in equal]


@cache
def stable_curve() -> Theorem:
    """What is said of the curve of stable walls, for an integer delay and every plant."""
    exact, never = solid().of  # type: ignore[attr-defined]
    on_it = as_claimed(exact, zero_on_circle_is_explicit())
    loop = by_zeros(*LOOP)
    zeros = loop.conclusion.parts[1].terms[0]
    none = denied_by(
        loop, closed(zero_on_circle(zeros, z, theta, assume(at_angle())), *LATER_WHOLE)
    )
    return conj(on_it, as_claimed(never, closed(none, *LATER_WHOLE)))


@cache
def right_of_the_line() -> Theorem:
    """-gamma < alpha of a stable wall beside a damped device, with an integer delay."""
    return not_left_of_the_line(*at_rest())


def not_left_of_the_line(static: Theorem, pushed: Theorem) -> Theorem:
    """-gamma < alpha of a stable wall, with an integer delay, from 0 < n_1 + n_0 of the device."""
    loop = by_zeros(*LOOP)
    zeros = loop.conclusion.parts[1].terms[0]
    away = positive(-gamma - alpha >= 0, alpha <= -gamma)
    value = combined(Relation(zeros.subs(z, 1), "<=", S.Zero), [pushed, away], [static, 1])
    never = of_every_plant(closed(denied_by(loop, zero_beyond(zeros, z, value)), *LATER_WHOLE))
    wanted = Relation(-gamma, "<", alpha)
    outside = contr(not_intro(assume(STABLE), never), wanted)
    return disj_cases(ordered(-gamma, alpha), assume(wanted), outside)


@cache
def in_one_plane() -> Theorem:
    """Fig. 11."""
    drawn, region = CLAIMED["fig11"](()).of  # type: ignore[attr-defined]
    _, given, then = taken_apart(drawn)
    arm = {gamma: STIFF, delta: DAMPED}
    curve, *_, left = then.of  # type: ignore[attr-defined]
    line = numbers_known(inst(right_of_the_line(), arm))
    line = for_all(left.over, [left.body.of[0]], line)
    curves = (stable_curve(), enclosed_walls_are_stable())
    found = conj(passive_curve(curve), *(inst(t, arm) for t in curves), line)
    shown = as_claimed(drawn, _at_each(found, given[0]))
    inside = taken_apart(region)[1]
    stable = _at_each(numbers_known(inst(held_passive_is_stable(), arm)), inside[0])
    return conj(shown, as_claimed(region, stable))


@cache
def up_to_nyquist() -> Theorem:
    """Fig. 13."""
    drawn, region = CLAIMED["fig13"](()).of  # type: ignore[attr-defined]
    _, given, then = taken_apart(drawn)
    curves = conj(stable_curve(), enclosed_walls_are_stable())
    found = []
    for claim, damper in zip(then.of, (DAMPED, S.Zero), strict=True):  # type: ignore[attr-defined]
        springs = claim.body.of[0].of
        found.append(for_all([gamma], springs, add_assum(inst(curves, {delta: damper}), *springs)))
    shown = as_claimed(drawn, _at_each(conj(*found), given[0]))
    _, inside, robust = taken_apart(region)
    springs = robust.body.of[0].of  # type: ignore[attr-defined]
    stable = closed(passive_wall_is_stable(), positive(alpha + gamma > 0, alpha > 0, gamma >= 0))
    stable = numbers_known(inst(stable, {delta: DAMPED}))
    stable = for_all([gamma], springs, add_assum(stable, *springs))
    stable = _at_each(stable, inside[0])
    return conj(shown, as_claimed(region, stable))


def _at_each(theorem: Theorem, delays: Any) -> Theorem:
    """For each of some delays, what is shown of whole ones or of those that are not negative."""
    delay = (proposition(d >= 0), whole(d))
    for hypothesis in filter(theorem.hypotheses.__contains__, delay):
        cases = []
        for choice in delays.of:
            value = choice.terms[1]
            equal = combined(Relation(value, "=", d), [assume(choice), -S.One])
            cases.append(subst(hypothesis, d, fact(hypothesis.at({d: value})), equal))
        theorem = closed(theorem, disj_cases(assume(delays), *cases))
    return theorem


@cache
def not_pulling() -> Theorem:
    """0 <= alpha of a passive wall beside a damper, for every delay of the held force."""
    turns = closed(with_rest(d, S.One, l), one())
    units = {K: alpha, B: beta, b: delta, T: S.One, epsilon: d - l}
    passive = closed(
        inst(passive_late(), units),
        combined(d - l >= 0, [assume(l <= d)]),
        positive(d - l <= 1, [combined(d - l < 1, [assume(d < l + 1)])]),
        number(Relation(S.Zero, "<", S.One)),
    )
    return choose(turns, conjunct(mp(passive, assume(PASSIVE_WALL)), alpha >= 0))


@cache
def held_passive_is_stable() -> Theorem:
    """A passive wall keeps a device with spring and damper stable, for every delay."""
    held = positive(alpha + gamma > 0, [not_pulling()], gamma > 0)
    stiff = positive(gamma >= 0, gamma > 0)
    return closed(passive_wall_is_stable(), held, stiff)
