"""A wall that the plant outweighs all around the circle is stable with every integer delay."""

from symhaptic.book.lemmas.outpaced import at_point
from symhaptic.book.lemmas.passive_is_stable import LOOP
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.ratio import ARM

LATE = Rational(59, 10**5)
"""The stiffness of a wall without virtual damping that is stable with every delay, for the arm of
Figs. 11 and 12 with the spring."""

TURN = exp(I * theta)
PLANT, FORCE = TURN**2 - a * TURN + e, LATE * (n_1 * TURN + n_0)
HERE = {s: (v, v) for s, v in ARM.items()}


@cache
def lead() -> Theorem:
    """0 < |A|^2 - alpha^2 |N|^2 at every angle: a square in y = 2 - 2 cos(theta) and more."""
    chord, static = sp.Symbol("Y"), 1 - a + e
    plant = static**2 + ((1 - e) ** 2 - static * (1 + e)) * chord + e * chord**2
    wall = LATE**2 * ((n_1 + n_0) ** 2 - n_1 * n_0 * chord)
    first, second, third = sp.Poly(plant - wall, chord).all_coeffs()
    bend, least = at_point(first, HERE), at_point(4 * first * third - second**2, HERE)
    surplus = PLANT * mirror(PLANT) - FORCE * mirror(FORCE)
    whole_square = square(2 * first * (2 - 2 * cos(theta)) + second)
    share = 1 / (4 * first)
    turned = positive(share > 0, [_inverse(bend)])
    found = combined(surplus > 0, [turned, whole_square], [turned, least])
    return closed(found, not_zero(bend))


def _inverse(theorem: Theorem) -> Theorem:
    """0 < 1/(4 x) from 0 < x."""
    value = theorem.conclusion.right  # type: ignore[attr-defined]
    return over(1 / (4 * value) > 0, one(), positive(4 * value > 0, [4, theorem]))


@cache
def no_crossing() -> Theorem:
    """p(exp(j theta)) != 0 for the wall turned up to y, 0 < y <= 1."""
    late = exp(I * (d + 1) * theta) * PLANT
    push = y * FORCE * TURN
    root = assume(sp.Eq(late + push, 0))
    less = positive(1 - y >= 0, y <= 1)
    along, across = (FORCE + mirror(FORCE)) / 2, (FORCE - mirror(FORCE)) / (2 * I)
    more = positive(1 + y > 0, [S.One], y > 0)
    sizes = [[less, more, square(part_)] for part_ in (along, across)]
    gap = PLANT * mirror(PLANT) - y**2 * FORCE * mirror(FORCE)
    ahead = combined(Relation(S.Zero, "<", gap), [lead()], *sizes)
    nothing = combined(Relation(S.Zero, "=", gap), [root, -mirror(late)], [mirrored(root), push])
    wanted = proposition(Ne(late + push, 0))
    contrary = contr(not_intro(ahead, nothing), wanted)
    return disj_cases(decided(late + push, S.Zero), contrary, assume(wanted))


@cache
def stable_behind_every_delay() -> Theorem:
    """The wall (LATE, 0) is stable for every whole d, with the arm of the figures."""
    device = assume(DEVICE)
    rest = device_at_rest(device)
    static, pushed, _ = (conjunct(rest, claim) for claim in rest.conclusion.of)  # type: ignore[attr-defined]
    plant, wall = z**2 - a * z + e, (n_1 * z + n_0) * (LATE * z)
    at_one = positive(
        Ne(1 - a + e + y * LATE * (n_1 + n_0), 0),
        [pushed, positive(gamma + LATE * y > 0, gamma >= 0, [LATE, y > 0])],
        [static, -S.One],
    )
    begin = all_inside(z, d + 1, device_comes_to_rest(device))
    zeros = roots_stay(z ** (d + 1) * plant, wall, z, y, theta, no_crossing(), at_one, begin)
    found = closed(mp(by_zeros(LATE, S.Zero, *LOOP[2:]), zeros), *LATER_WHOLE)
    return numbers_known(inst(of_every_plant(found), ARM))
