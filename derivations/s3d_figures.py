r"""Which walls do the plots of the passivity boundary enclose?

Fig. 4 of the paper draws the boundary for seven delays, two of them fractions of a period. The
shape of this boundary is derived in \chapter{s3b_rise}. For which delays do these curves bound the
passive walls?
"""

from symhaptic.book.figures.passivity import passive_regions
from symhaptic.book.lemmas.extent import sine
from symhaptic.book.lemmas.linear_part import known, on_line
from symhaptic.book.lemmas.lower_boundary import border_needs, nothing_else, of_border
from symhaptic.book.lemmas.motions import half_late
from symhaptic.book.lemmas.passive_boundary import on_boundary
from symhaptic.book.lemmas.passivity import PASSIVE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import bordering, first_half, limits, pushes, sufficient
from symhaptic.book.lemmas.stiffest_passive import stiffest_wall
from symhaptic.book.lemmas.upper_boundary import loss, upper_boundary
from symhaptic.paper.propositions.passivity import BORDER, UPPER
from symhaptic.paper.tables import DELAYS
from symhaptic.proof.ball import ball
from symhaptic.proof.roots import decimals
from symhaptic.proof.series import limit

UNIT = {b: 1, T: 1}


def derive(page):
    stiffness, damping = (e.subs(UNIT) for e in passivity.envelope())
    corner = [limit(e, theta, S.Zero) for e in (stiffness, damping)]
    angle = pi / (2 * (d + 1))
    tip = [e.subs(theta, angle) for e in (stiffness, damping)]
    page.say(
        "In units of $b$ and $T$ each curve of Fig. 4 is a straight line from $(0,-1)$ to a "
        "corner. From the corner the boundary curves to its tip and ends at $(0,1)$."
    )
    delay = 3 * y / (1 - 2 * y)
    dashed = page.step(
        "The dashed curve of the corners is a hyperbola in $y=B/b$",
        corner[0].subs(d, delay),
        2 * (1 + y) * (1 - 2 * y) / (1 + 4 * y),
        name=r"\frac{K_cT}{b}",
        because=r"the corners lie on an arc of a hyperbola from $(2,0)$ to $(0,\tfrac12)$",
    )
    page.same("the corner's damping", corner[1].subs(d, delay), y)
    tips = page.step(
        "The dash-dotted curve of the tips is (11)",
        tip[0],
        2 * tan(angle / 2),
        name=r"\frac{K_{\max}T}{b}",
        because="formula (11) is also the curve of Fig. 5, which falls with the delay",
    )
    low = (cos(angle) - d / (d + 1)) / sin(angle)
    page.step(
        "The damping of the tips is that of (11)", tip[1], low, name=r"\frac Bb\Big|_{K_{\max}}"
    )
    page.table(
        "Corner and tip of the seven curves (7) of Fig. 4; decimals cut off.",
        ["$d$", "corner $KT/b$", "corner $B/b$", "tip $KT/b$", "tip $B/b$"],
        [row(text, *corner, tips, low) for text in DELAYS],
    )
    far = {d: 1 / h - 1}
    title, share = "For long delays the tips fall like $\\pi h/2$", r"\frac{K_{\max}T}{bh}"
    page.limit(title, tips.subs(far) / h, h, S.Zero, pi / 2, name=share)
    because = r"we write $h=1/(d+1)$; the corners tend to $(0,\tfrac12)$"
    title = "For long delays the damping of the tips tends to a constant"
    share = r"\frac Bb\Big|_{K_{\max}}"
    page.limit(title, low.subs(far), h, S.Zero, 2 / pi, name=share, because=because)
    fractions(page)
    page.figure(
        "fig4",
        "Fig. 4 of the paper: boundaries (7) for seven delays, tips (dash-dotted) and corners "
        "(dashed). For $d=0.25$ and $0.5$ the walls inside satisfy (5) but are not all passive.",
        passive_regions,
    )
    page.same("dashed", dashed, corner[0].subs(d, delay))
    page.same("dash-dotted", tip[0], tips)
    _curves(page)


def row(text, *values):
    """Four coordinates for one delay, as decimals."""
    cells = [v.subs(d, Rational(text)) for v in values]
    known = [v if v.is_Rational else decimals(ball(v, None, 128).real, 4) for v in cells]
    return [f"${text}$", *(f"${v}$" for v in known)]


def fractions(page):
    """With a fractional delay the walls on the straight part are not passive."""
    page.say(
        "For integer delays the walls inside the curve are the passive ones. For a fractional "
        r"delay, $d=\ell+\varepsilon$, passivity requires another condition, $D\ge0$ "
        r"(\chapter{s6d_fractional_passivity})."
    )
    line = {B: K * T * (l + epsilon + Rational(1, 2)) - b}
    page.limit(
        "On the straight part of (7) low frequencies extract energy",
        fractional.margin().subs(line),
        theta,
        S.Zero,
        -epsilon * (1 - epsilon) * (K * T) ** 2 / 4,
        name="D",
        because="the limit is negative, so no wall with $K>0$ on this line is passive",
    )


HALF = {d: S.Half, T: S.One, b: S.One}
TIP = HALF | {line.lhs: line.rhs.subs(HALF) for line in STATEMENTS["eq11"].printed}
GAINS = half_late(Rational(17, 10))


def _curves(page):
    """Fig. 4 is right for integer delays; with a delay of half a period its tip is not passive."""
    _, given, then = taken_apart(page.claim("fig4"))
    case = TIP | {omega: pi / 2, y: S.One}
    some, none = (
        of.at(case | {d: value}) for of, value in ((given[-1], S.Half), (given[-1], S.Zero))
    )
    there = then.at(case)
    tip = there.of[-1]
    point = conj(*(number(e) for e in tip.of[0].of))
    held = mp(conjunct(assume(there), tip), point)
    denied = not_intro(
        conjunct(held, PASSIVE.at(case)), gains(list(PASSIVE.at(case).of), GAINS), there
    )
    page.settle(
        "fig4",
        drawn(then),
        example=(case | {d: S.Zero}, disj(identity(S.Zero, S.Zero), none)),
        unless={whole(d): (case, disj(identity(S.Half, S.Half), some), denied)},
        shows="with a delay of half a period, the tip of the curve for $d=0.5$ delivers energy",
        note="five of the seven curves show what the caption says; the other two, for fractional "
        "delays, bound the walls of (5)",
    )


# Fig. 4 for an integer delay: the boundary is the curve (7) and the line (8), with the tip (11).


def drawn(claim: Any) -> Theorem:
    """The walls of Fig. 4 are on the boundary, the boundary has no others, and (11) is the tip."""
    *parts, others, tip = claim.of
    made = on_boundary, on_line, lambda *_: on_it()
    found = [_implied(of, how) for of, how in zip(parts, made, strict=True)]
    return conj(*found, _no_others(others), _implied(tip, stiffest_wall))


def _implied(implication: Any, made: Callable[..., Theorem]) -> Theorem:
    """An implication whose last hypothesis is the published equation."""
    known = conjuncts(implication.of[0])
    return disch(add_assum(made(*map(assume, known[-2:])), *known), implication.of[0])


def _no_others(implication: Any) -> Theorem:
    """A wall of the boundary is on the arc, on the line or, without delay, on the upper part."""
    border, cover = implication.of
    arc, line, _ = cover.of
    late = strictly(assume(d >= 0), show(Ne(S.Zero, d), Ne(d, 0)))
    above = disj(closed(upper_boundary(arc), late), cover)
    damped = show(B >= 0, d * b / (2 * d + 3) < B, loss())
    at_once = disj(closed(its_damping(), damped), cover)
    high = disj_cases(decided(d, 0), at_once, above)
    low = disj(nothing_else(line.body.of[2:]), cover)
    found = disj_cases(ordered(d * b / (2 * d + 3), B), high, low)
    found = closed(Given(d >= 0).closed(found), conjunct(assume(border), BORDER))
    return disch(found, border)


# Without delay the upper part of the boundary is b = KT/2 + B, for B >= 0 and K >= 0.

NONE, STIFF, DAMPED, FULL = UPPER.parts
LEAST = K * T / 2 + B
"""The required damping of these walls."""


@cache
def enough() -> Theorem:
    """Without delay a wall with K >= 0 and B >= 0 is passive if b = KT/2 + B."""
    there = {b: LEAST, d: S.Zero}
    always = first_half().at(there)
    given, goal = always.body.of
    margin = combined(goal, [assume(DAMPED), inst(known()[2], {d: S.Zero})])
    margin = for_all([phi], given.of, Given(phi * 2 < pi, phi > 0).closed(margin, sine(phi)))
    found = Given(K >= 0, T > 0).closed(closed(inst(sufficient(), there), margin))
    pattern = PASSIVE.at({b: LEAST, d: x})
    return subst(pattern, x, found, show(Eq(S.Zero, d), NONE))


@cache
def on_it() -> Theorem:
    """A wall with b = KT/2 + B, B >= 0 and K >= 0 is on the boundary."""
    full = assume(FULL)
    passive = subst(PASSIVE.at({b: x}), x, enough(), show(Eq(LEAST, b), full))
    least = show(b <= x, inst(limits()[0], {b: x}), full)
    return bordering(passive, least)


@cache
def its_damping() -> Theorem:
    """A wall of the boundary with B >= 0 has b = KT/2 + B and K >= 0."""
    stiff = of_border(pushes())
    force = show(LEAST >= 0, stiff, T > 0, DAMPED)
    need = border_needs(LEAST, closed(enough(), stiff), force)
    full = both_ways(need, show(b >= LEAST, of_border(limits()[0])))
    return conj(assume(NONE), stiff, assume(DAMPED), full)
