"""Fig. 9: what bounds the stable walls one and with two periods of delay, at the four limits of
(23)."""

from symhaptic.book.lemmas.enclosed import enclosed_walls_are_stable
from symhaptic.book.lemmas.near_tip import Arm, none_above, wall_below
from symhaptic.book.lemmas.one_plane import not_left_of_the_line, stable_curve
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.paper.propositions.plots import BESIDE, THIN

NEAR = {1: Rational(3, 10), 2: Rational(1, 4)}
"""The virtual damping of a stable wall next to the left bound."""


def valued(claim: Proposition, symbol: Symbol, value: Expr, theorem: Theorem) -> Theorem:
    """What holds for one value of a symbol, with the symbol in its place, where it has it."""
    equal = combined(Relation(value, "=", symbol), [assume(Eq(symbol, value)), -1])
    return subst(claim, symbol, theorem, equal)


def each_value(
    claim: Proposition,
    given: Mapping[Symbol, Proposition],
    build: Callable[[dict[Symbol, Expr]], Theorem],
) -> Theorem:
    """A claim for all values that these symbols may have, from that at each choice of them."""

    def cases(known: dict[Symbol, Expr]) -> Theorem:
        rest = [s for s in given if s not in known]
        if not rest:
            return build(known)
        symbol, here = rest[0], claim.at(known)
        choice: Any = given[symbol]
        values = [p.terms[1] for p in choice.of]
        shown = (valued(here, symbol, v, cases({**known, symbol: v})) for v in values)
        return disj_cases(assume(choice), *shown)

    return cases({})


@cache
def right_of_the_line() -> Theorem:
    """-gamma < alpha of a stable wall, for every arm of (23) and an integer delay."""
    pushed = on_box(n_1 + n_0, RANGES)
    static = of_device("device at rest", assume(DEVICE))
    return not_left_of_the_line(static, pushed)


def at_corner(claim: Any, corner: dict[Symbol, Expr]) -> Theorem:
    """What the figure shows of one arm and delay."""
    _, _, left, near, tip = claim.at(corner).of
    arm: Arm = (corner[gamma], corner[delta])
    late = int(corner[d])
    solid = numbers_known(inst(stable_curve(), corner))
    line = numbers_known(inst(right_of_the_line(), corner))
    bound = for_all(left.over, [left.body.of[0]], line)
    beside = (-corner[gamma] + THIN / 2, NEAR[late])
    held = stable_at({**dict(zip((alpha, beta), beside, strict=True)), **corner})
    values = dict(zip(BESIDE, beside, strict=True))
    reached = exists(conj(held, fact(near.body.of[1].at(values))), near, values)
    wall, stable = wall_below(arm, late)
    limit, below = none_above(arm, late)
    values = dict(zip(BESIDE, wall, strict=True))
    others = tip.body.of[1].at(values).body
    most = positive(others.of[1], [below], [wall[0] + THIN - limit])
    stiffest = exists(conj(stable, for_all((alpha, beta), [others.of[0]], most)), tip, values)
    within = numbers_known(inst(enclosed_walls_are_stable(), corner))
    return conj(solid, within, bound, reached, stiffest)


@cache
def drawn() -> Theorem:
    """All of Fig. 9."""
    region, visible = CLAIMED["fig9"](()).of  # type: ignore[attr-defined]
    symbols, given, then = taken_apart(region)
    found = each_value(
        then, dict(zip(symbols, given, strict=True)), lambda corner: at_corner(then, corner)
    )
    whole_region = as_claimed(region, found)
    over, (damper, late), narrow = taken_apart(visible)

    def width(known: dict[Symbol, Expr]) -> Theorem:
        limit, below = none_above((STIFF, known[delta]), 2)
        found = positive(narrow, [below], [narrow.right - limit])  # type: ignore[attr-defined]
        return for_all((alpha, beta), [late.at(known)], found)

    walls = each_value(every((alpha, beta), [late], narrow), {delta: damper}, width)
    inner = at(walls, {alpha: alpha, beta: beta}, assume(late))
    return conj(whole_region, for_all(over, [damper, late], add_assum(inner, damper, late)))
