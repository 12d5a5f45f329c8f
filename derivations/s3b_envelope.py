"""Which walls are on the boundary of passivity at a given frequency?

At one frequency the condition is a half plane in the $(K,B)$ plane, bounded by a line. As the
frequency changes, this line moves, and the family of lines has an envelope.
"""

from symhaptic.book.figures.arguments import lines_of_angles
from symhaptic.book.lemmas.largest_damping import divisors
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.rates import with_damping_and_rate
from symhaptic.paper.propositions.passivity import scaled


def derive(page):
    line = page.define(
        "At one angle the condition is bounded by a line", r"F(\theta)", passivity.margin()
    )
    stiffness, damping = passivity.envelope()
    page.say(
        r"Two neighbouring lines meet at the point at which both $F$ and $\partial "
        r"F/\partial\theta$ vanish. These are two linear equations for $K$ and $B$ with one "
        "solution."
    )
    shared = sin(2 * (d + 1) * theta) - 2 * (d + 1) * sin(theta)
    nice_stiffness = page.step(
        "Two neighbouring lines meet at this stiffness",
        stiffness,
        2
        * b
        * (d + 1)
        * (sin((d + 2) * theta) - 2 * sin((d + 1) * theta) + sin(d * theta))
        / (T * shared),
        name=K,
        paper="7",
    )
    nice_damping = page.step(
        "Two neighbouring lines meet at this damping",
        damping,
        2 * b * (d * sin((d + 1) * theta) - (d + 1) * sin(d * theta)) / shared,
        name=B,
        paper="7",
    )
    on_curve = {K: nice_stiffness, B: nice_damping}
    page.step(
        "The point $(K,B)$ lies on the line of its angle",
        line.subs(on_curve),
        S.Zero,
        name=r"F\big|_{(K,B)}",
    )
    page.step(
        "The point $(K,B)$ lies on the neighbouring line, too",
        diff(line, theta).subs(on_curve),
        S.Zero,
        name=r"\partial F/\partial\theta\,\big|_{(K,B)}",
    )
    page.figure(
        "lines_of_angles",
        "One line for each angle, with one period of delay: a wall on the wrong side of any of "
        "them is not passive. The passive region is on the right side of all lines, which "
        "envelop it.",
        lines_of_angles,
    )
    page.say(
        "The coordinates $K$ and $B$ of this point are proportional to $b$. The product $KT$ "
        "does not contain $T$. So the stiffness is proportional to the sampling rate $1/T$, and "
        "not to the period."
    )
    _scaled(page)


def _scaled(page):
    """The walls of (5) are proportional to b, and their stiffness to 1/T."""
    claim, right = page.claim("s3b-linear-in-T"), scaled(T / y)
    found = conj(*with_damping_and_rate())
    stiff = {K: S.One, B: S.Zero, b: S.One, T: S.One, d: S.Zero, y: S(3)}
    then = taken_apart(claim)[2].at(stiff)
    walls, slow = then.of[1].of
    met = combined(walls.body.of[1], [S.Half])
    met = for_all([omega], walls.body.of[0].of, closed(met, *divisors(omega)))
    held = mp(conjunct(assume(then), then.of[1]), met)
    there = at(held, {omega: pi / 6}, *map(number, slow.body.of[0].at({omega: pi / 6}).of))
    broken = not_intro(there, number(negated(there.conclusion)), then)
    page.settle(
        "s3b-linear-in-T",
        found,
        instead=right,
        corrected=(r"K\propto b/T", r"B\propto b"),
        example=stiff,
        unless=[(stiff, broken)],
        shows="with three times the period, the stiffness is a third",
        note=r"the statement holds at each angle $\omega T$",
    )
