r"""Is the lower part of the passivity boundary a straight line?

Where small stiffness meets negative damping the boundary in the $(K,B)$ plane looks straight.
It is the line of vanishing frequency; we ask how far it reaches, and for which walls the simple
condition that comes from it is enough.
"""

from sympy import Eq, Ne, Rational, S

from symhaptic.book.lemmas.linear_part import (
    LOW,
    decides,
    ends_at_corner,
    met_at_every_frequency,
    on_line,
)
from symhaptic.book.lemmas.motions import HALF_LATE, STEPS, TO_AND_FRO, no_border
from symhaptic.book.lemmas.passivity import PASSIVE
from symhaptic.model import passivity
from symhaptic.notation import B, K, T, b, d, omega, theta, y
from symhaptic.notation.proposition import negated, proposition
from symhaptic.paper import STATEMENTS
from symhaptic.paper.propositions import CLAIMED
from symhaptic.proof.theorems.analysis import no_other_limit
from symhaptic.proof.theorems.definitions import gains
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import (
    absurd,
    applied,
    assume,
    conjoined,
    part,
    placed,
    weakened,
    whole,
)
from symhaptic.proof.theorems.leaves import number, tends
from symhaptic.proof.theorems.tactics import (
    closed,
    counterexample,
    either_way,
    example,
    fact,
    for_all,
)


def derive(page):
    line = page.limit(
        "Low frequencies",
        passivity.margin(),
        theta,
        S.Zero,
        b + B - K * T * (d + Rational(1, 2)),
        name="F",
    )
    stiffness, damping = passivity.envelope()
    end_stiffness = page.limit(
        "The envelope ends there, stiffness",
        stiffness,
        theta,
        S.Zero,
        6 * b * (d + 1) / (T * (2 * d + 1) * (2 * d + 3)),
        name=K,
    )
    end_damping = page.limit(
        "The envelope ends there, damping",
        damping,
        theta,
        S.Zero,
        b * d / (2 * d + 3),
        name=B,
    )
    page.say(
        "By the previous chapters no other frequency cuts into the line between $(0,-b)$ and this "
        "end: it bounds the passive walls for every real $d\\ge0$, with $y$ from 0 to 1 along it."
    )
    on_line = {K: end_stiffness * y, B: (end_damping + b) * y - b}
    page.step(
        "Every point of it", line.subs(on_line), S.Zero, name=r"F\big|_{\text{(8)}}", paper="8"
    )
    _line(page, Eq(K, on_line[K]), Eq(B, on_line[B]))
    page.say(
        "Only the end $y=1$ is the limit of the envelope (7). The points before it belong to the "
        "line itself, the limit of (5)."
    )
    _lower_part(page)
    page.say(
        "Solved for the stiffness this is the ratio of all damping to all delay, half a period of "
        "hold included:"
    )
    limit_of_k = page.step(
        "Damping over delay",
        (b + B) / (T * (d + Rational(1, 2))),
        2 * (b + B) / (T * (2 * d + 1)),
        name=r"\frac{b+B}{(d+\frac12)T}",
        paper="9",
    )
    page.step("On the line", line.subs(K, limit_of_k), S.Zero, name=r"F\big|_{K=(b+B)/((d+1/2)T)}")
    page.say(
        "For damping in the stated range the low frequencies are the strictest, and the condition "
        "is exact but for its border. For negative $K$ it says nothing: higher frequencies can "
        "fail."
    )
    _condition(page, limit_of_k > K)


def _line(page, *derived):
    """Each wall of (8) is on the boundary, behind whole delays."""
    claim = CLAIMED["eq8"](STATEMENTS["eq8"].printed)
    symbols, given, _ = taken_apart(claim)
    found = page.lemma(
        "A wall of (8) is passive, and needs all of the damping",
        on_line(*map(assume, given[-2:])),
        because="it lies between $(0,-b)$ and the corner of the envelope, which both leave a "
        "margin at every angle",
    )
    more = [*given, whole(d)]
    late = {K: S.One, B: S.Zero, b: S.One, T: S.One, d: S.Half, y: Rational(8, 9)}
    page.settle(
        "eq8",
        for_all(symbols, more, weakened(found, *given)),
        *derived,
        example=example(late | {d: S.Zero, y: S.Half, B: -S.Half}, more),
        unless=[counterexample(claim, late, no_border(claim, late), but=whole(d))],
        shows=r"half a period late, the wall $K=b/T$, $B=0$ on this line gives energy away",
        note="bounds the walls that satisfy (5) for every real $d$",
    )


def _lower_part(page):
    """The line is the limit of (5), and the envelope tends to one of its points."""
    claim = CLAIMED["s3c-lower-part"](())
    symbols, given, (straight, *limits) = (*taken_apart(claim)[:2], taken_apart(claim)[2].of)
    top = Eq(y, 1)
    line = met_at_every_frequency(straight)
    found = conjoined(line, *(ends_at_corner(limit, assume(top)) for limit in limits))
    bottom = {b: S.One, T: S.One, d: S.One, y: S.Zero}
    denied, there = limits[0].at(bottom), taken_apart(claim)[2].at(bottom)
    end = tends(denied.of[0], omega, S.Zero, Rational(4, 5))
    other = no_other_limit(end, number(Ne(Rational(4, 5), denied.of[2], evaluate=False)))
    denied = absurd(part(assume(there), denied), other, there)
    page.settle(
        "s3c-lower-part",
        for_all(symbols, [*given, top], weakened(found, *given, top)),
        example=example(bottom | {y: S.One}, [*given, top]),
        unless=[
            counterexample(claim, bottom, denied, but=top),
        ],
        shows=r"(7) tends to $K=\tfrac45b/T$, not to the point $(0,-b)$ of (8)",
        note="that the lower part is linear holds for every real $d\\ge0$",
    )


def _condition(page, nine):
    """(9) decides in its range, (10) with the range of (9)."""
    claim, ten = (CLAIMED[id](STATEMENTS[id].printed) for id in ("eq9", "eq10"))
    printed = claim.body.of[1].of[0]
    enough, needed = decides()
    page.lemma("It is enough for small damping", enough)
    page.lemma("It is needed, whatever the damping", needed)
    same = either_way(enough, needed, printed, PASSIVE)
    border = Ne(K, LOW)
    late = {K: S.One, B: S.Zero, b: Rational(101, 100), T: S.One, d: S.Half}
    pulled = {K: -S(3), B: S.Zero, b: S.One, T: S.One, d: S.One}
    edge = {K: S(2), B: S.Zero, b: S.One, T: S.One, d: S.Zero}
    steep = {K: S(2), B: S.Half, b: S.One, T: S.One, d: S.Zero}
    easy = {K: S.One, B: S.Zero, b: S.One, T: S.One, d: S.Zero}
    small = d * b / (2 * d + 3) >= B
    cases = [
        (late, HALF_LATE, whole(d)),
        (pulled, STEPS, K >= 0),
        (edge, None, border),
        (steep, TO_AND_FRO, small),
    ]
    for id, of, extra in (
        ("eq9", claim, [whole(d), K >= 0, border]),
        ("eq10", ten, [whole(d), K >= 0, border, small]),
    ):
        symbols, given, then = taken_apart(of)
        more = [*given, *(e for e in extra if proposition(e) not in given)]
        page.settle(
            id,
            for_all(symbols, more, weakened(same, *more)),
            nine,
            example=example(easy, more),
            unless=[
                counterexample(
                    of,
                    point,
                    not_alike(then, point, motion),
                    holds=[e for e in extra if proposition(e) != proposition(but)],
                    but=but,
                )
                for point, motion, but in cases
                if proposition(but) in map(proposition, extra)
            ],
            **WORDS[id],
        )


WORDS = {
    "eq9": {
        "shows": "half a period late, $K=b/(1.01\\,T)$ meets (9) and gives energy away",
        "note": "equality satisfies (5) too, but for $d=0$, $B=0$: $\\omega=0$ is left out",
    },
    "eq10": {
        "shows": r"$d=0$, $B=\tfrac12b$: (10) allows $K=2$, (5) fails at $\omega T=\tfrac56\pi$",
        "note": "with $\\le$ it is necessary for every $B$; sufficient in the range of (9) only",
    },
}


def not_alike(same, point, motion):
    """(9) and passivity differ at a point: a motion gains, or (9) is not met on the border."""
    there = same.at(point)
    nine, passive = there.of
    if motion is None:
        held = applied(assume(there), at_corner(point))
        return absurd(held, number(negated(nine)), there)
    met = number(nine)
    return absurd(applied(assume(there), met), gains(list(passive.of), motion), there)


def at_corner(point):
    """The wall of a point is passive, since it is the corner."""
    claim = CLAIMED["eq8"](STATEMENTS["eq8"].printed)
    found = part(on_line(*map(assume, taken_apart(claim)[1][-2:])), PASSIVE)
    there = placed(found, point | {y: S.One})
    return closed(there, *map(fact, there.hypotheses))
