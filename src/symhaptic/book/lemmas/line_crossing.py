"""The walls on the line of (25) that are stable are those below one of them, for d = 0 and d = 1.

Each of Jury's inequalities is a polynomial f(alpha) on the line. At its start, alpha = -gamma, it
is not negative: there the gap s_1 - delta - gamma/2 of the arm's numbers decides. Where f is
concave it is then positive between the start and each wall at which it is positive.
"""

from sympy import div

from symhaptic.book.lemmas.arm_numbers import gap, pushed, together
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import no_stiffer, on_box
from symhaptic.model.circle import powers
from symhaptic.model.linear import on_the_line
from symhaptic.paper.propositions.linear import safe

TOP = {0: Rational(72, 100), 1: Rational(16, 100)}
"""No wall that is stable is as stiff."""
NEAR = {0: Rational(83, 100), 1: Rational(424, 1000)}
TOTAL = n_1 + n_0
ARMS = Given(gamma >= 0, gamma <= STIFF, delta >= 0, delta <= DAMPED)
AT_REST = 1 + e - gamma * TOTAL
"""a of a device beside its spring."""
ROOM = 1 - e + gamma * n_0 - (delta + gamma / 2) * TOTAL
"""The gap times n_1 + n_0."""


@cache
def below_the_top(delay: int) -> Theorem:
    """alpha < 0.72, or 0.16 with one period of delay, of a stable wall."""
    return no_stiffer(delay, (TOP[delay], NEAR[delay]), RANGES)


@cache
def room() -> Theorem:
    """0 <= (s_1 - delta - gamma/2) (n_1 + n_0)."""
    found = combined(Relation(S.Zero, "<=", ROOM), [gap(), together()])
    return closed(found, slow(), positive(Ne(TOTAL, 0), [together()]))


def slow() -> Theorem:
    """The arms of (23) do not swing by half a turn in a period."""
    far = number(Relation(STIFF, "<", pi**2))
    return show(gamma - delta**2 / 4 < pi**2, gamma <= STIFF, far, square(delta))


def start(value: Expr) -> Theorem:
    """0 <= f(-gamma), from the gap where it counts and from balls where it does not."""
    resting = expanded(value.xreplace({a: AT_REST}))
    share, rest = div(resting, ROOM, e)
    moved = divided(value, a, AT_REST)
    turn = combined(Relation(a, "=", AT_REST), [device_static(assume(DEVICE)), -1])
    claim = Relation(S.Zero, "<=", value)
    if rest != 0:
        return combined(claim, [on_box(value, RANGES)])
    known: list[list[Any]] = [[turn, -moved]] if moved != 0 else []
    if share != 0:
        known.append([room(), on_box(share, RANGES)])
    return combined(claim, *known)


def divided(value: Expr, by: Symbol, to: Expr) -> Expr:
    """(f(to) - f(by))/(to - by) of a polynomial f."""
    return expanded(
        Add(
            *(
                c * Add(*(to**i * by ** (k - 1 - i) for i in range(k)))
                for k, c in powers(value, by).items()
                if k
            )
        )
    )


def bent(value: Expr) -> Expr:
    """The second divided difference of f over -gamma, x and alpha."""
    return divided(divided(value, alpha, x), alpha, -gamma)


def softer(value: Expr, there: Theorem, delay: int) -> Theorem:
    """0 < f(x) from 0 < f(alpha), -gamma < x and x <= alpha."""
    above, more = assume(-gamma < x), assume(x <= alpha)
    first = start(expanded(value.xreplace({alpha: -gamma})))
    length = show(alpha + gamma > 0, above, more)
    rows: list[list[Any]] = [[above, there], [more, first]]
    curve = bent(value)
    if curve != 0:
        wide = (-STIFF, TOP[delay])
        down = on_box(-curve, {**RANGES, alpha: wide, x: wide})
        rows.append([more, above, length, down])
    here = value.xreplace({alpha: x})
    apart = positive(Ne(alpha + gamma, 0), [length])
    return closed(over(here > 0, positive((alpha + gamma) * here > 0, *rows), length), apart)


@cache
def stays_stable() -> tuple[Theorem, ...]:
    """The wall x of the line is stable where alpha is, for -gamma < x <= alpha, on (23)."""
    return tuple(map(_stays_stable, TOP))


def _stays_stable(delay: int) -> Theorem:
    loop = inst(by_inequalities(delay), {beta: on_the_line(alpha, delay)})
    wanted = inst(by_inequalities(delay), {alpha: x, beta: on_the_line(x, delay)})
    known = mp(loop, assume(loop.conclusion.of[0]))  # type: ignore[attr-defined]
    parts = []
    for claim in conjuncts(known.conclusion):
        value = expanded(claim.right)  # type: ignore[attr-defined]
        there = combined(Relation(S.Zero, "<", value), [conjunct(known, claim)])
        parts.append(softer(value, there, delay))
    goals = conjuncts(wanted.conclusion.of[1])  # type: ignore[attr-defined]
    shown = [combined(goal, [known]) for goal, known in zip(goals, parts, strict=True)]
    return of_every_plant(within(mp(wanted, conj(*shown)), delay))


def within(theorem: Theorem, delay: int) -> Theorem:
    """The stiffness of both walls is between -0.001 and the top."""
    stiff = inst(below_the_top(delay), {beta: on_the_line(alpha, delay)})
    return ARMS.and_(-gamma < x, x <= alpha).closed(theorem, stiff)


@cache
def one_crossing() -> Theorem:
    """For -gamma < x < alpha: if alpha is stable, so is x, and alpha < 1; for d = 0 and d = 1."""
    return conj(*map(_one_crossing, TOP))


def _one_crossing(delay: int) -> Theorem:
    stiff = inst(below_the_top(delay), {beta: on_the_line(alpha, delay)})
    found = conj(stays_stable()[delay], positive(alpha < 1, [stiff], [1 - TOP[delay]]))
    wall = next(p for p in stiff.hypotheses if isinstance(p, Predicate))
    return disch(closed(found, positive(x <= alpha, x < alpha)), wall)


DAMPING = -Rational(22, 1000), Rational(2, 5)
"""What is on the line from -gamma to the top, on (23)."""


def in_the_triangle(delay: int) -> Theorem:
    """A wall above the line, -gamma < alpha, with at most the damping of a stable wall x on it."""
    share = delay + S.Half
    there = expanded((beta + delta) / share)
    [line] = (r.subs(d, delay) for r in transcribed("eq25"))
    less = positive(there - alpha > 0, [1 / share, line])
    here = ARMS.and_(-gamma < alpha, line, beta <= on_the_line(x, delay))
    on_it = here.closed(inst(stays_stable()[delay], {alpha: x, x: there}))
    loop = by_inequalities(delay)
    known = mp(inst(loop, {alpha: there}), assume(on_it.conclusion))
    wide = {**RANGES, alpha: (-STIFF, TOP[delay]), beta: DAMPING}
    parts = []
    for claim, way in zip(conjuncts(loop.conclusion.of[1]), _WAYS[delay], strict=True):  # type: ignore[attr-defined]
        value = claim.right  # type: ignore[attr-defined]
        if way == "start":
            parts.append(combined(claim, *_from_the_start(value)))
        elif way == "box":
            parts.append(combined(claim, [on_box(value, wide)]))
        else:
            higher = combined(
                Relation(S.Zero, "<", expanded(value.xreplace({alpha: there}))),
                [conjunct(known, _like(claim, known, there))],
            )
            fall = -divided(value, alpha, y)
            down = inst(on_box(fall, {**wide, y: wide[alpha]}), {y: there})
            parts.append(combined(claim, [higher], [less, down]))
    found = closed(of_every_plant(mp(loop, conj(*parts))), on_it)
    stiff = inst(below_the_top(delay), {alpha: x, beta: on_the_line(x, delay)})
    return here.closed(found, stiff, slow())


_WAYS = {0: ("start", "start", "box", "down"), 1: ("start", "box", "box", "box", "down")}
"""How each inequality is shown in the triangle."""


def _like(claim: Proposition, known: Theorem, there: Expr) -> Proposition:
    """The inequality of the wall on the line that is this one."""
    return claim.at({alpha: there})


def _from_the_start(value: Expr) -> list[list[Any]]:
    """p(1) = (n_1 + n_0) (alpha + gamma); or the second without delay, by the gap."""
    above = assume(-gamma < alpha)
    [line] = (r.subs(d, 0) for r in transcribed("eq25"))
    turn = combined(Relation(a, "=", AT_REST), [device_static(assume(DEVICE)), -1])
    if beta not in value.free_symbols:
        return [[together(), above], [turn, S.One]]
    return [[2, room()], [2, together(), assume(line)], [2, pushed()[0], above], [turn, S.One]]


@cache
def below_the_crossing() -> Theorem:
    """The claim of the triangle for d = 0 and d = 1, each from its parts."""
    every: Any = taken_apart(safe())[2]
    return conj(
        *(
            disch(in_the_triangle(delay), *conjuncts(claim.of[0]))
            for delay, claim in zip(TOP, every.of, strict=True)
        )
    )
