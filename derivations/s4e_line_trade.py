"""Is virtual damping equivalent to physical damping?

The linear condition (24) contains only the sum of the two dampings. The paper concludes that
damping in discrete time dissipates like damping in continuous time where this condition holds. We
exchange one damping for the other on the exact boundary.
"""

from symhaptic.book.lemmas.linear import turned
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.model import linear
from symhaptic.paper.propositions.linear import EXCHANGED, decides

G = symbols("g")


def derive(page):
    stiffness, damping = boundary.solved(on_circle(-(z**d) * linear.near()))
    scaled = {
        theta: h * theta,
        gamma: h**4 * gamma,
        delta: h**2 * delta,
        s_1: h**2 * delta + h**4 * gamma / 2 + h**10 * G,
        nu: HALF - h**2 * delta / 12,
        s_2: S.One,
    }
    flat, rise = 6 * (d + 1) ** 2 + 1, (d + 1) * (2 * d + 1) * (2 * d + 3)
    apart = theta**2 * (rise * theta**2 - flat * delta) / 12
    lies = linear.surplus(stiffness, damping).subs(scaled, simultaneous=True)
    bound = (d + HALF) * alpha - delta + alpha * (rise * alpha - flat * delta) / 12
    page.limit(
        "For short periods the boundary is a parabola, to second order",
        lies / h**4,
        h,
        S.Zero,
        apart,
        name=r"\Delta/h^4",
        because=r"here $\theta^2$ stands for $\alpha$, and $\Delta$ is the surplus over the "
        r"line. The parabola is $\beta=(d+\frac12)\alpha-\delta+\Delta$",
    )
    page.step(
        "A unit of physical damping replaces more than one unit of virtual damping",
        -diff(bound, delta),
        1 + flat * alpha / 12,
        name=r"-\frac{\partial\beta}{\partial\delta}\Big|_\alpha",
        boxed=True,
        because=r"the ratio tends to 1 for $\alpha\to0$; at $\alpha=0.01$ it exceeds 1 by about "
        r"0.6\,\% for $d=0$ and by 2\,\% for $d=1$",
    )
    page.say(
        "The difference between the dampings matters even for walls at which the linear "
        r"condition is accurate to a few percent. Take $d=1$, $\gamma=0.001$ and the wall "
        r"$\alpha=0.01$ with $\beta+\delta=0.015$, on the line of (25). With physical damping "
        "this wall is stable, and with virtual damping alone it is not:"
    )
    wall = {alpha: Rational(1, 100), gamma: Rational(1, 1000), d: S.One}
    physical = {**wall, beta: -Rational(1, 200), delta: Rational(1, 50)}
    virtual = {**wall, beta: Rational(3, 200), delta: S.Zero}
    page.lemma(
        "With physical damping, $\\delta=0.02$ and $\\beta=-0.005$, the loop is stable",
        stable_at(physical),
    )
    page.lemma(
        r"With virtual damping alone, $\delta=0$ and $\beta=0.015$, the loop is not stable",
        unstable_at(virtual),
    )
    settle(page, physical, virtual)


def settle(page, physical, virtual):
    """The two dampings are equivalent if (25) is right for both."""
    page.say(
        r"So the two dampings are equivalent in the limit $\alpha\to0$. For larger $\alpha$ they "
        "are equivalent only if (25) is correct with either damping, since (25) contains only "
        "the sum of the dampings."
    )
    claim = page.claim("s6-linear-dissipation")
    same = taken_apart(claim)[2]
    extra = [decides(), decides().at(EXCHANGED)]
    easy = {**physical, alpha: Rational(1, 1000), delta: Rational(1, 100), x: Rational(1, 200)}
    more_virtual, less_virtual = {**virtual, x: physical[delta]}, {**physical, x: -physical[delta]}
    page.settle(
        "s6-linear-dissipation",
        as_claimed(claim, exchanged(), *extra),
        example=(easy, *(at_point(e, easy) for e in extra)),
        unless={
            but: (at, *(at_point(e, at) for e in (same, *extra)))
            for but, at in zip(extra[::-1], (more_virtual, less_virtual), strict=True)
        },
        shows=r"for $d=1$, $\gamma=0.001$ and $\alpha=0.01$, the sum $\beta+\delta=0.015$ is "
        r"stable with $\delta=0.02$ and unstable with $\delta=0$",
        note=r"the statement holds in the limit of small $\alpha$. To lowest order in $\alpha$ one "
        r"unit of physical damping replaces $1+\frac1{12}(6(d+1)^2+1)\,\alpha$ units of virtual "
        "damping",
    )


# Physical damping in place of virtual damping, for walls for which (25) is right, and for others.


@cache
def exchanged() -> Theorem:
    """If (25) is right for both, exchanging x of the damping does not change stability."""
    before, after = decides(), decides().at(EXCHANGED)
    line, same = before.parts[0], after.parts[0]
    equal = either_way(combined(same, [assume(line)]), combined(line, [assume(same)]), line, same)
    return chained(chained(turned(assume(before)), equal), assume(after))


def at_point(same: Proposition, point: Terms) -> Theorem:
    """The equivalence p <=> q at a point, or its negation."""
    there = same.at(point)
    known = [_settled(part) for part in there.parts]
    (one, p), (other, q) = zip(known, there.parts, strict=True)
    if one.conclusion == p and other.conclusion == q:
        return either_way(add_assum(other, p), add_assum(one, q), p, q)
    if one.conclusion != p and other.conclusion != q:
        never = [not_intro(assume(c), t) for c, t in zip(there.parts, known, strict=True)]
        return either_way(contr(never[0], q), contr(never[1], p), p, q)
    held, denied = (one, other) if one.conclusion == p else (other, one)
    return not_intro(mp(assume(there), held), denied, there)


def _settled(claim: Proposition) -> Theorem:
    """A claim about numbers, or its negation."""
    if isinstance(claim, Relation):
        try:
            return number(claim)
        except NotShown:
            return number(negated(claim))
    wall = dict(zip((alpha, beta, gamma, delta, d), claim.terms, strict=True))
    try:
        return stable_at(wall)
    except NotShown:
        found = unstable_at(wall)
        assert found.conclusion == Not((claim,))
        return found
