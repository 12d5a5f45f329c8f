"""A wall of the boundary, with beta < 0 <= alpha, where the error of the linear condition is large.

It is given by the chord y of the zero that the loop then has on the circle.
"""

from symhaptic.book.lemmas.arm_numbers import TOTAL, together
from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.line_crossing import AT_REST, room, slow
from symhaptic.book.lemmas.linear_boundary import HIGH, LOW, TOP, minor, reached, turn
from symhaptic.book.lemmas.linear_rays import share
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import of_every_plant, on_box
from symhaptic.model import linear
from symhaptic.model.circle import expanded
from symhaptic.model.plant import Sampled
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


def beyond(delay: int, spring: Expr, more: Expr, ranges: Ranges) -> Theorem:
    """The claim ``far`` for the arms of a box, by the wall with y = spring gamma + more."""
    chord = spring * gamma + more
    right, up, area = (expanded(f.xreplace({linear.CHORD: chord})) for f in arc(delay))
    there = {alpha: chord * right / area - gamma, beta: up / area}
    stiff, damped = (assume(Relation(s, "=", w)) for s, w in there.items())
    known = {f: on_box(f, ranges) for f in (right, area, spring * right - area)}
    first = spring * ranges[gamma][0] + more
    least = positive(chord > 0, [spring, gamma >= ranges[gamma][0]], [first])

    def by_stiffness(claim: Any, top: Theorem, share_: Any = -1) -> Theorem:
        return combined(claim, [quotient(top, known[area])], [stiff, share_])

    def by_damping(claim: Any, top: Theorem, share_: Any = -1) -> Theorem:
        return combined(claim, [quotient(top, known[area])], [damped, share_])

    left = by_stiffness(-gamma < alpha, positive(chord * right > 0, [least, known[right]]))
    pulled = [[gamma >= 0, known[spring * right - area]], *([[more, known[right]]] if more else [])]
    push = by_stiffness(alpha >= 0, positive(chord * right - gamma * area >= 0, *pulled))
    room_ = on_box(expanded(TOP[delay] * area - chord * right + gamma * area), ranges)
    less = by_damping(beta < 0, on_box(-up, ranges), 1)
    ends = (
        positive(alpha <= TOP[delay], [by_stiffness(alpha < TOP[delay], room_, 1)]),
        positive(beta >= LOW, [by_damping(beta > LOW, on_box(up - LOW * area, ranges))]),
        positive(beta <= HIGH, [less], [HIGH]),
    )
    boundary = closed(reached(delay), left, on_the_circle(delay, stiff, damped), *ends)
    value, weight = error(delay), share(delay)
    rest = -(beta + delta) + weight * alpha - LEVEL * weight * (alpha + gamma)
    away = quotient(_away(delay, chord, ranges, least), known[area])
    away = combined(rest > 0, [away], [stiff, -(1 - LEVEL) * weight], [damped, S.One])
    width = positive(weight * (alpha + gamma) > 0, [weight, left])
    down = combined(value < -LEVEL, [quotient(away, width)])
    beyond_ = combined(far_at(delay).body.of[-1], [down], [magnitude(value, True), -S.One])
    beyond_ = closed(beyond_, positive(value <= 0, [down], [LEVEL]))
    found = conj(boundary, push, less, beyond_)
    found = exists(found, far_at(delay), {s: s for s in there})
    apart = [*map(not_zero, (*known.values(), width)), positive(Ne(alpha + gamma, 0), [left])]
    found = closed(found, *apart, slow())
    return of_every_plant(closed(unnamed(found, there), not_zero(known[area])))


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
