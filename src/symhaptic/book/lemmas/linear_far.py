"""A wall of the boundary, with beta < 0 <= alpha, where the error of the linear condition is large.

It is given by the chord y of the zero that the loop then has on the circle.
"""

from symhaptic.book.lemmas.arm_numbers import TOTAL, together
from symhaptic.book.lemmas.line_crossing import AT_REST, room, slow
from symhaptic.book.lemmas.linear_boundary import HIGH, LOW, TOP, minor, reached, turn
from symhaptic.book.lemmas.linear_rays import share
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.model import linear
from symhaptic.paper.propositions.linear_error import LEVEL, error, far

Ranges = Mapping[Symbol, tuple[Any, Any]]

_TOTAL = Symbol("t")
"""A name for n_1 + n_0, by which polynomials are divided."""


@cache
def arc(delay: int) -> tuple[Expr, Expr, Expr]:
    """(alpha + gamma)/y, beta and |nu + (1 - nu) z|^2, times that and (n_1 + n_0)^2."""
    form, numbers = linear.arc(delay), linear.numbers(Sampled(_TOTAL - n_0, n_0, a, e))
    right, up, area = (
        expanded(expanded(f.xreplace(numbers) * _TOTAL**2).xreplace({_TOTAL: TOTAL}))
        for f in form[:2] + form[3:]
    )
    return expanded(right / linear.CHORD), up, area


class OnArc:
    """The wall of the boundary with a chord y, for the arms of a box; ``least`` says 0 < y."""

    def __init__(self, delay: int, chord: Expr, least: Theorem, ranges: Ranges) -> None:
        self.delay, self.chord, self.ranges = delay, chord, ranges
        self.right, self.up, self.area = (
            expanded(f.xreplace({linear.CHORD: chord})) for f in arc(delay)
        )
        self.there = {alpha: chord * self.right / self.area - gamma, beta: self.up / self.area}
        self.stiff, self.damped = (assume(Relation(s, "=", w)) for s, w in self.there.items())
        self.size, self.wide = on_box(self.area, ranges), on_box(self.right, ranges)
        self.left = self.by(
            self.stiff, -gamma < alpha, show(chord * self.right > 0, least, self.wide)
        )

    def by(self, equation: Theorem, claim: Any, top: Theorem, share_: Any = -1) -> Theorem:
        """A relation by alpha or beta of this wall, from the sign of a numerator."""
        return combined(claim, [quotient(top, self.size)], [equation, share_])

    def away(self, top: Theorem) -> Theorem:
        """0 < -(error + 0.02) (d + 1/2) (alpha + gamma), from the sign of its numerator."""
        weight = share(self.delay)
        rest = -(beta + delta) + weight * alpha - LEVEL * weight * (alpha + gamma)
        equations = [self.stiff, -(1 - LEVEL) * weight], [self.damped, S.One]
        return combined(rest > 0, [quotient(top, self.size)], *equations)

    def is_far(self, claim: Any, away: Theorem, less: Theorem, *more: Theorem) -> Theorem:
        """The wall is on the boundary, more, and its error is large; ``less`` says beta < 0."""
        top, area, value = TOP[self.delay], self.area, error(self.delay)
        soft = expanded(top * area - self.chord * self.right + gamma * area)
        soft_ = self.by(self.stiff, alpha < top, on_box(soft, self.ranges), 1)
        low = self.by(self.damped, beta > LOW, on_box(self.up - LOW * area, self.ranges))
        ends = show(alpha <= top, soft_), show(beta >= LOW, low), show(beta <= HIGH, less)
        circle = on_the_circle(self.delay, self.stiff, self.damped)
        boundary = closed(reached(self.delay), self.left, circle, *ends)
        width = positive(share(self.delay) * (alpha + gamma) > 0, [share(self.delay), self.left])
        down = combined(value < -LEVEL, [quotient(away, width)])
        far_ = combined(claim.body.of[-1], [down], [magnitude(value, True), -S.One])
        far_ = closed(far_, positive(value <= 0, [down], [LEVEL]))
        found = exists(conj(boundary, *more, less, far_), claim, {s: s for s in self.there})
        apart = not_zero(self.size), not_zero(width), positive(Ne(alpha + gamma, 0), [self.left])
        found = unnamed(closed(found, *apart, slow()), self.there)
        return closed(found, not_zero(self.size))


def beyond(delay: int, spring: Expr, more: Expr, ranges: Ranges) -> Theorem:
    """The claim ``far`` for the arms of a box, by the wall with y = spring gamma + more."""
    chord, low = spring * gamma + more, ranges[gamma][0]
    least = positive(chord > 0, [spring, gamma >= low], [spring * low + more])
    wall = OnArc(delay, chord, least, ranges)
    steep = on_box(spring * wall.right - wall.area, ranges)
    pulled = [[gamma >= 0, steep], *([[more, wall.wide]] if more else [])]
    pull = positive(chord * wall.right - gamma * wall.area >= 0, *pulled)
    push = wall.by(wall.stiff, alpha >= 0, pull)
    less = wall.by(wall.damped, beta < 0, on_box(-wall.up, ranges), 1)
    away = wall.away(_away(delay, chord, ranges, least))
    return of_every_plant(wall.is_far(far_at(delay), away, less, push))


def unnamed(theorem: Theorem, values: Terms) -> Theorem:
    """Without the equations that give names to these values."""
    named = both([Relation(s, "=", w) for s, w in values.items()])
    there_is = exists(
        conj(*(identity(w, w) for w in values.values())), Exists(tuple(values), named), values
    )
    return choose(there_is, theorem)


def far_at(delay: int) -> Any:
    """The claim for a delay of so many periods."""
    return far().at({d: S(delay)})


def quotient(top: Theorem, bottom: Theorem) -> Theorem:
    """A quotient has the sign of its numerator."""
    upper, lower = relation(top), relation(bottom)
    return over(Relation(S.Zero, upper.sign, upper.right / lower.right), top, bottom)


def on_the_circle(delay: int, stiff: Theorem, damped: Theorem) -> Theorem:
    """The minor of this wall is zero."""
    value = minor(delay)
    bare = value.xreplace({a: AT_REST})
    w, v = (relation(t).right for t in (stiff, damped))
    found = identity(bare.xreplace({alpha: w, beta: v}), S.Zero)
    for place, line, known in ((alpha, stiff, {beta: v}), (beta, damped, {})):
        back = combined(Relation(relation(line).right, "=", place), [line, -1])
        pattern = Relation(bare.xreplace(known), "=", S.Zero)
        found = subst(pattern, place, found, back)
    return combined(Relation(value, "=", S.Zero), [found], turn(-value))


def _away(delay: int, chord: Expr, ranges: Ranges, least: Theorem) -> Theorem:
    """0 < -(error + 0.02) times its denominator: the gap, and y times what is positive."""
    right, up, area = arc(delay)
    place = linear.CHORD
    above = up + delta * area - share(delay) * (place * right - gamma * area)
    value = expanded(-above - LEVEL * share(delay) * place * right)
    first = value.xreplace({place: S.Zero})
    rest = expanded((value - first) / place).xreplace({place: chord})
    return combined(
        Relation(S.Zero, "<", value.xreplace({place: chord})),
        [room(), together()],
        [least, on_box(expanded(rest), ranges)],
    )
