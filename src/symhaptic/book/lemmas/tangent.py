"""Behind a whole delay all stable walls lie on one side of each tangent of the stability boundary.

Of p with its zeros inside, n |p|^2 < 2 Re conj(p) z p' on the circle (``outpaces``).  Expand both
sides around the wall of the boundary that puts a zero at exp(j theta).  There p vanishes, and z p'
is j N times the velocity of the boundary.  The equation of the tangent and a quadratic form are
left.  The form is negative definite for 1 < (d + 1 - (n1^2 - n0^2)/|N|^2) sin(theta), which is so
from (d + 1) theta = 1 on, about.
"""

from symhaptic.book.lemmas.outpaced import ROOM, room
from symhaptic.book.lemmas.passive_is_stable import DEVICE, NUMBERS
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.plots import BESIDE
from symhaptic.paper.propositions.stability import SQUARE

TURN = exp(I * theta)
TOP = n_1 * TURN + n_0
LATE = exp(I * (d + 1) * theta)


def _value(wall: tuple[Expr, Expr]) -> Expr:
    """p at exp(j theta)."""
    stiff, damp = wall
    return LATE * (TURN**2 - a * TURN + e) + TOP * ((stiff + damp) * TURN - damp)


def _speed(wall: tuple[Expr, Expr]) -> Expr:
    """z p' at exp(j theta)."""
    stiff, damp = wall
    plant = LATE * ((d + 3) * TURN**2 - (d + 2) * a * TURN + (d + 1) * e)
    push = n_1 * TURN * ((stiff + damp) * TURN - damp) + TOP * (stiff + damp) * TURN
    return plant + push


ROOT = Relation(_value(BESIDE), "=", S.Zero)
"""The wall (alpha_1, beta_1) puts a zero at exp(j theta)."""
MOVES = Relation(I * _speed(BESIDE) + TOP * (x * TURN + y * (TURN - 1)), "=", S.Zero)
"""(x, y) is the derivative of the boundary with respect to theta, at this wall."""
WEIGHT = (d + 1) * SQUARE - (n_1**2 - n_0**2)
STEEP = Relation(SQUARE, "<", WEIGHT * sin(theta))
"""The angle is large enough for the quadratic form to be negative definite."""
ANGLE = (proposition(theta > 0), proposition(theta < pi))
SIDE = (alpha - BESIDE[0]) * y - (beta - BESIDE[1]) * x


@cache
def on_one_side() -> Theorem:
    """(alpha - alpha_1) y - (beta - beta_1) x < 0 for every stable wall."""
    right, up = alpha - BESIDE[0], beta - BESIDE[1]
    total, weight = right + up, WEIGHT + SQUARE
    size = combined(SQUARE >= 0, [square(n_1 + n_0 * cos(theta))], [square(n_0 * sin(theta))])
    wave, steep = sign_of(sin, theta), assume(STEEP)
    heavy = positive(WEIGHT * sin(theta) > 0, [steep], [size])
    first = over(WEIGHT > 0, heavy, wave)
    more = positive(weight > 0, [first], [size])
    room_ = room()
    away = assume(Relation(S.Zero, "<=", SIDE))
    root, moves = assume(ROOT), assume(MOVES)
    rest = TOP * (right * TURN + up * (TURN - 1))
    rise = n_1 * TURN * (right * TURN + up * (TURN - 1)) + TOP * total * TURN
    speed = _speed(BESIDE) + rise - (d + 3) * rest
    less = combined(
        Relation(weight * ROOM, "<=", S.Zero),
        [2, size, more, wave, away],
        [square(weight * up - WEIGHT * cos(theta) * total)],
        [steep, positive(WEIGHT * sin(theta) + SQUARE > 0, [heavy], [size]), square(total)],
        [root, weight * (mirror(speed) - (d + 3) * mirror(_value(BESIDE)))],
        [mirrored(root), weight * speed],
        [moves, -weight * I * mirror(rest)],
        [mirrored(moves), weight * I * rest],
    )
    contrary = not_intro(positive(weight * ROOM > 0, [more, room_]), less)
    wanted = Relation(SIDE, "<", S.Zero)
    found = disj_cases(ordered(SIDE, S.Zero), assume(wanted), contr(contrary, wanted))
    return closed(found, positive(Ne(sin(theta), 0), [wave]))


def tangents() -> Proposition:
    """Every stable wall lies on one side of the tangent at each steep angle; d is whole."""
    given = [*ANGLE, ROOT, MOVES, STEEP, STABLE]
    walls = (theta, *BESIDE, x, y, alpha, beta)
    every_ = ForAll(walls, implied(given, Relation(SIDE, "<", S.Zero)))
    return _of_plants(every_)


def tips() -> Proposition:
    """No stable wall is as stiff as the boundary where its stiffness is stationary; d is whole.

    That is at each steep angle at which the damping of the boundary rises.
    """
    given = [*ANGLE, ROOT, MOVES.at({x: S.Zero}), y > 0, STEEP, STABLE]
    walls = (theta, *BESIDE, y, alpha, beta)
    return _of_plants(ForAll(walls, implied(given, alpha < BESIDE[0])))


def _of_plants(then: Proposition) -> Proposition:
    plants = ForAll((gamma, delta, *NUMBERS), implied([DEVICE], then))
    return ForAll((d,), implied([whole(d)], plants))


def _for_plants(theorem: Theorem) -> Theorem:
    plants = for_all((gamma, delta, *NUMBERS), [DEVICE], add_assum(theorem, DEVICE))
    return for_all((d,), [whole(d)], add_assum(plants, whole(d)))


@cache
def all_tangents() -> Theorem:
    """:func:`tangents`."""
    walls, given, _ = taken_apart(_inner(tangents()))
    return _for_plants(for_all(walls, given, add_assum(on_one_side(), *given)))


@cache
def all_tips() -> Theorem:
    """:func:`tips`."""
    walls, given, _ = taken_apart(_inner(tips()))
    side, rise = inst(on_one_side(), {x: S.Zero}), assume(y > 0)
    below = over(BESIDE[0] - alpha > 0, positive((BESIDE[0] - alpha) * y > 0, [side]), rise)
    found = closed(positive(alpha < BESIDE[0], [below]), positive(Ne(y, 0), [rise]))
    return _for_plants(for_all(walls, given, add_assum(found, *given)))


def _inner(claim: Proposition) -> Proposition:
    """What is said of each plant."""
    return taken_apart(taken_apart(claim)[2])[2]
