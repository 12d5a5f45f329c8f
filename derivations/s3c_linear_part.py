r"""Is the lower part of the passivity boundary a straight line?

For small stiffness and negative damping the boundary in the $(K,B)$ plane looks straight. It is the
line of the limit $\omega\to0$. We ask how far this line reaches, and for which walls the condition
of the line is sufficient.
"""

from symhaptic.book.lemmas.linear_part import ends_at_corner, met_at_every_frequency, on_line
from symhaptic.book.lemmas.lower_boundary import lower_boundary, on_the_line
from symhaptic.book.lemmas.motions import HALF_LATE
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.analysis import no_other_limit


def derive(page):
    line = page.limit(
        "At low frequencies the boundary is a line",
        passivity.margin(),
        theta,
        S.Zero,
        b + B - K * T * (d + Rational(1, 2)),
        name="F",
    )
    stiffness, damping = passivity.envelope()
    end_stiffness = page.limit(
        "The envelope ends on the line with this stiffness",
        stiffness,
        theta,
        S.Zero,
        6 * b * (d + 1) / (T * (2 * d + 1) * (2 * d + 3)),
        name=K,
    )
    end_damping = page.limit(
        "The envelope ends on the line with the damping $bd/(2d+3)$",
        damping,
        theta,
        S.Zero,
        b * d / (2 * d + 3),
        name=B,
    )
    page.say(
        r"By \chapter{s3b_rise}, the condition is strictest for $\theta\to0$ for the walls "
        "between $(0,-b)$ and the end of the envelope. So the line bounds the walls of (5) for "
        r"every real $d\ge0$. In (8), a parameter $y$ grows from 0 to 1 along the line."
    )
    on_line = {K: end_stiffness * y, B: (end_damping + b) * y - b}
    page.step(
        "Every point of (8) lies on the line",
        line.subs(on_line),
        S.Zero,
        name=r"F\big|_{\text{(8)}}",
        paper="8",
    )
    _line(page, Eq(K, on_line[K]), Eq(B, on_line[B]))
    page.say(
        r"Only the end $y=1$ is the limit of the envelope (7) for $\theta\to0$. The points "
        "before it belong to the line itself, which is the limit of (5)."
    )
    _lower_part(page)


def _line(page, *derived):
    """The walls of (8), and no others with at most the damping of its end, are the boundary."""
    then = taken_apart(page.claim("eq8"))[2]
    page.lemma(
        "A wall of (8) is passive, and requires exactly the damping $b$",
        on_line(*map(assume, then.of[1].body.of[2:])),
        because="the wall lies between $(0,-b)$ and the corner of the envelope, and neither of "
        "them has a negative margin at any angle",
    )
    page.lemma(
        "A wall on the boundary with at most the damping of the end of (8) lies on the line (8)",
        on_the_line(),
        because="a passive wall off the line has a positive margin at every angle, and would be "
        "passive with less damping of the device",
    )
    found = page.lemma(
        "Up to the damping of its end, the line (8) is the boundary",
        lower_boundary(then),
        boxed=True,
    )
    late = {K: S.One, B: S.Zero, b: S.One, T: S.One, d: S.Half}
    page.settle(
        "eq8",
        found,
        *derived,
        example=late | {d: S.Zero, B: -S.Half},
        unless={whole(d): (late, _gains(then.at(late), Rational(8, 9)))},
        shows="with a delay of half a period, the wall $K=b/T$, $B=0$ on this line delivers energy",
        note="the line (8) bounds the walls that satisfy (5), for every real $d$",
    )


def _gains(claim, share):
    """A motion gains energy from the wall at this share of the line."""
    lower, line = claim.of
    there = conj(*(number(p) for p in line.body.at({y: share}).of))
    passive = conjunct(mp(assume(claim), exists(there, line, {y: share})), lower.of[0].of[0])
    return not_intro(passive, gains(passive.conclusion.of, HALF_LATE), claim)


def _lower_part(page):
    """The line is the limit of (5); the envelope tends to one of its points."""
    then = taken_apart(page.claim("s3c-lower-part"))[2]
    straight, *limits = then.of
    top = Eq(y, 1)
    line = met_at_every_frequency(straight)
    found = conj(line, *(ends_at_corner(limit, assume(top)) for limit in limits))
    bottom = {b: S.One, T: S.One, d: S.One, y: S.Zero}
    denied, there = limits[0].at(bottom), then.at(bottom)
    end = tends(denied.of[0], omega, S.Zero, Rational(4, 5))
    other = no_other_limit(end, number(Ne(Rational(4, 5), denied.of[2], evaluate=False)))
    denied = not_intro(conjunct(assume(there), denied), other, there)
    page.settle(
        "s3c-lower-part",
        found,
        example=bottom | {y: S.One},
        unless={top: (bottom, denied)},
        shows=r"for $\omega\to0$, (7) tends to $K=\tfrac45b/T$, not to the point $(0,-b)$ of (8)",
        note=r"the lower part of the boundary is linear for every real $d\ge0$",
    )
