r"""What is the largest stiffness that can be passive?

It is the rightmost point of the boundary. There a change of the damping must not help, so its
coefficient in the condition vanishes; that fixes the frequency, and everything else follows.
"""

from symhaptic.book.lemmas.motions import half_late, not_passive
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import bound, stiffest_wall
from symhaptic.book.lemmas.stiffness_ratio import case, ratio
from symhaptic.book.lemmas.tip_frequency import first_without_damping
from symhaptic.model import passivity
from symhaptic.paper import STATEMENTS


def derive(page):
    need = passivity.dirichlet_form()
    page.say(
        "By \\chapter{s3a_passivity_condition} a wall needs at the angle $\\theta=\\omega T$ a "
        "device that is damped by "
        "$b>\\frac{KT\\sin(d+\\frac12)\\theta}{2\\sin\\frac\\theta2}-B\\cos(d+1)\\theta$; call "
        "the right side its need."
    )
    page.step(
        "The coefficient of the virtual damping is a cosine",
        diff(need, B),
        -cos((d + 1) * theta),
        name=r"\partial\,\text{need}/\partial B",
    )
    angle = pi / (2 * (d + 1))
    page.step(
        "The coefficient of $B$ vanishes first at $\\theta=\\pi/(2(d+1))$",
        cos((d + 1) * angle),
        S.Zero,
        name=r"\cos(d+1)\theta\,|_{\theta=\pi/(2(d+1))}",
        because="later zeros lie beyond $\\pi/(d+1)$ and cut off nothing",
    )
    _frequency(page, Eq(omega, angle / T))
    left = b - need.subs(theta, angle)
    largest = -left.subs(K, 0) / diff(left, K)
    stiffness = page.step(
        "At that angle only the stiffness counts, and has a limit",
        largest,
        2 * b / T * tan(pi / (4 * (d + 1))),
        name=K,
        because="the damping has dropped out of the condition",
        boxed=True,
        paper="11",
    )
    on_curve = [e.subs(theta, angle) for e in passivity.envelope()]
    page.step(
        "The stiffest passive wall lies on the envelope",
        on_curve[0] - stiffness,
        S.Zero,
        name=r"K\big|_{\text{(7)}}-K",
    )
    damping = page.step(
        "The largest stiffness takes this damping",
        on_curve[1],
        b * (cos(angle) - d / (d + 1)) / sin(angle),
        name=B,
        paper="11",
        because="and by \\chapter{s3b_rise} the stiffness of the envelope rises up to this "
        "frequency and falls after it, for every real $d>0$",
    )
    _stiffest(page, Eq(K, stiffness), Eq(B, damping))
    page.say("Relative to the undelayed wall, whose largest stiffness is $2b/T$:")
    share = stiffness / stiffness.subs(d, 0)
    one = page.step(
        "One period of delay leaves 41 per cent",
        share.subs(d, 1),
        sqrt(2) - 1,
        name=r"K_{\max}(1)/K_{\max}(0)",
    )
    two = page.step(
        "Two periods of delay leave 27 per cent",
        share.subs(d, 2),
        2 - sqrt(3),
        name=r"K_{\max}(2)/K_{\max}(0)",
    )
    for id, delay, value in (("s3c-kmax-41", 1, one), ("s3c-kmax-27", 2, two)):
        claim = CLAIMED[id](())
        found = ratio(claim, PRINTED, delay)
        page.settle(id, found, example=case(claim, PRINTED, delay), enclosed=True, value=value)


PRINTED = STATEMENTS["eq11"].printed


def _frequency(page, derived):
    """There the damping does nothing, at no lower one, and (11) just meets (5)."""
    [printed] = STATEMENTS["s3c-kmax-frequency"].printed
    symbols, given, then = taken_apart(CLAIMED["s3c-kmax-frequency"]((printed,)))
    found = first_without_damping(printed, then)
    page.settle(
        "s3c-kmax-frequency",
        for_all(symbols, given, add_assum(found, *given)),
        derived,
        example=example({T: S.One, d: S.Zero, omega: pi / 2}, given),
        note="for $d=0$ every frequency gives this point, which is then a corner; the slash has "
        "to be read as dividing by the whole product",
    )


def _stiffest(page, *derived):
    """(11) is passive, and no passive wall is stiffer, behind whole delays."""
    page.lemma(
        "No passive wall is stiffer",
        bound(),
        because="by \\chapter{s3a_passivity_condition} its margin is not negative at "
        "$\\theta=\\pi/(2(d+1))$, where $\\cos(d+1)\\theta=0$ and "
        "$\\sin(d+\\frac12)\\theta=\\cos\\frac\\theta2$: that is "
        "$b\\ge\\frac12KT\\cot\\frac\\theta2$",
    )
    claim = CLAIMED["eq11"](PRINTED)
    symbols, given, then = taken_apart(claim)
    found = page.lemma(
        "The wall of (11) is passive, and the stiffest",
        stiffest_wall(*map(assume, given[-2:])),
        because="by \\chapter{s3b_rise} the envelope is softer on either side of this angle, so "
        "that the margin of this wall, divided by $\\cos(d+1)\\theta$, falls there from plus to "
        "minus through zero, and the margin itself is not negative. At larger angles "
        "\\chapter{s3b_extent} says so. With the step before no passive wall is stiffer",
        boxed=True,
    )
    more = [*given, whole(d)]
    at_half = {d: S.Half, T: S.One, b: S.One}
    wall = at_half | {line.lhs: line.rhs.subs(at_half) for line in PRINTED}
    page.settle(
        "eq11",
        for_all(symbols, more, add_assum(found, *given)),
        *derived,
        example=example({d: S.Zero, T: S.One, b: S.One, K: S(2), B: S.Zero}, more),
        unless=[
            counterexample(
                claim, wall, not_passive(then, wall, half_late(Rational(17, 10))), but=whole(d)
            )
        ],
        shows=r"half a period late, this wall gives energy away in 60 periods",
        note="the largest stiffness that satisfies (5), for every real $d$",
    )
