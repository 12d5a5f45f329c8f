"""Fig. 10: the boundary for ten plants, and the walls on it whose linear condition errs so much."""

from symhaptic.book.lemmas.enclosed import enclosed_walls_are_stable
from symhaptic.book.lemmas.figure9 import each_value, right_of_the_line
from symhaptic.book.lemmas.one_plane import stable_curve
from symhaptic.book.lemmas.outpaced import at_point
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.springs_alike import line_and_curve
from symhaptic.bounds.linear_points import Arc, points
from symhaptic.paper.propositions.plots import BEFORE, BESIDE, LEVELS
from symhaptic.paper.propositions.stability import SQUARE, damping, stiffness

FAR = -Rational(1, 10**5)
"""Marks next to the corner lie left of this, and are not drawn."""


@cache
def _arc(damper: Expr, delay: int) -> Arc:
    return Arc(STIFF, damper, delay)


@cache
def angle_of(damper: Expr, delay: int, level: Expr) -> Rational:
    """Where the error is about this, as a search finds it."""
    [found] = (p for p in points(_arc(damper, delay), level) if p.alpha.mid() > float(FAR))
    return Rational(round(float(found.theta.mid()) * 10**10), 10**10)


def mark(claim: Any, damper: Expr, delay: int, level: Expr) -> Theorem:
    """The wall of the boundary at this angle has an error near the level."""
    some = taken_apart(claim)[2]
    here = {gamma: STIFF, delta: damper}
    ranges = {s: (v, v) for s, v in here.items()}
    angle = angle_of(damper, delay, level)
    size, half = SQUARE.xreplace({theta: angle}), cos(angle / 2)
    along, across = (f(S(delay)).xreplace({theta: angle}) for f in (stiffness, damping))
    wall = {theta: angle, BESIDE[0]: along / (half * size), BESIDE[1]: across / (sin(angle) * size)}
    below = half * sin(angle) * size

    def on_curve(expr: Expr) -> Theorem:
        return numbers_known(inst(at_point(expr, ranges), here))

    bottom = on_curve(below)
    share = over(Relation(S.Zero, "<", 1 / below), one(), bottom)
    there = some.body.at(wall).of  # type: ignore[attr-defined]
    parts = [fact(there[0]), fact(there[1])]
    parts.append(conj(*(identity(p.left, p.right) for p in there[2].of)))
    symbolic = some.body.of[3:]  # type: ignore[attr-defined]
    top = {BESIDE[0]: along * sin(angle), BESIDE[1]: across * half}
    for shown, meant in zip(there[3:], symbolic, strict=True):
        # homogeneous of degree one in the wall and what is divided out
        difference = meant.right - meant.left
        rest = difference.xreplace(dict.fromkeys(BESIDE, S.Zero))
        scaled = (difference - rest).expand().xreplace(top) + rest * below
        parts.append(positive(shown, [on_curve(scaled), share]))
    found = exists(conj(*parts), some, wall)
    apart = not_zero(bottom), not_zero(on_curve(size))
    return as_claimed(claim, closed(found, *apart, *apart))


@cache
def drawn() -> Theorem:
    """All of Fig. 10."""
    marks_of, _ = CLAIMED["fig10"](()).of  # type: ignore[attr-defined]
    curves, *more = marks_of.of
    symbols, given, then = taken_apart(curves)

    def build(known: dict[Any, Expr]) -> Theorem:
        plant = {**known, gamma: STIFF}
        _, _, left, *marks = then.at(known).of  # type: ignore[attr-defined]
        within = numbers_known(inst(enclosed_walls_are_stable(), plant))
        solid = numbers_known(inst(stable_curve(), plant))
        line = numbers_known(inst(right_of_the_line(), plant))
        bound = for_all((alpha, beta), [left.body.of[0]], line)
        late = int(known[d])
        found = (
            mark(claim, known[delta], late, level)
            for claim, level in zip(marks, LEVELS, strict=True)
        )
        return conj(solid, within, bound, *found)

    found = each_value(then, dict(zip(symbols, given, strict=True)), build)
    others = (
        mark(claim, damper, int(late), -LEVELS[1])
        for claim, (late, damper) in zip(more, BEFORE, strict=True)
    )
    return conj(conj(as_claimed(curves, found), *others), line_and_curve())
