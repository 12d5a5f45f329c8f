"""A wall that is passive with any delay keeps every damped device stable there."""

from symhaptic.book.lemmas.late_boundary import A, M
from symhaptic.book.lemmas.late_device import TOP
from symhaptic.book.lemmas.late_loop import ALL_NUMBERS, LATE_STABLE, LOOP, numbers_of_a_late_device
from symhaptic.book.lemmas.late_passivity import EVERY_MARGIN, MARGIN, passive_late
from symhaptic.book.lemmas.passive_is_stable import (
    margin_to_the_end,
    passive_is_stable,
    sine_not_zero,
    turned_up,
)
from symhaptic.book.lemmas.passivity import every_margin, passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.model.fractional import required_straight, stiffness_squared
from symhaptic.proof.theorems.axioms import LATE_NUMBERS

UNITS = {K: alpha, B: beta, b: delta, T: S.One}
PASSIVE = Predicate("passive_wall", (), (alpha, beta, delta, S.One, l + epsilon))
LATE_MARGIN = MARGIN.xreplace(UNITS)
ONE = Relation(S.Zero, "<", S.One)
PAIR = epsilon * (1 - epsilon)
GIVEN = (
    *map(proposition, (gamma >= 0, delta > 0, alpha + gamma > 0)),
    whole(l),
    *map(proposition, (epsilon >= 0, epsilon < 1)),
)


def late_passive_walls_are_stable() -> Proposition:
    """Passive walls are stable, with every damped device and with every delay."""
    return every(LOOP, [*GIVEN, PASSIVE], LATE_STABLE)


def _size(expr: Expr) -> Theorem:
    """0 <= |e|^2."""
    size = expr * mirror(expr)
    along, across = (expr + mirror(expr)) / 2, (expr - mirror(expr)) / (2 * I)
    return combined(size >= 0, [square(along)], [square(across)])


@cache
def no_crossing() -> Theorem:
    """p(exp(j theta)) != 0 for the wall turned up to y, 0 < y <= 1 and 0 < theta <= pi.

    With p and q of the motion, the wall's force y G per displacement and the margin D the energy is
    2 Re conj(p) root = 0, and a sum of what is positive: what is burnt beyond delta (p^2 + q^2),
    p^2 D and |2 delta q + epsilon (1 - epsilon) y conj(G) p|^2.
    """
    turn = exp(I * theta)
    top = n_1 * turn + n_0
    way, off = (turn - 1) * top, M - (epsilon + (1 - epsilon) * turn) * top
    delayed = exp(I * (l + 2) * theta)
    push = (alpha + beta) * turn - beta
    path, force = delayed * A + y * M * push, push / delayed
    energy = axiom("late held steady state", gamma, delta, epsilon, *ALL_NUMBERS, theta)
    burnt = energy.conclusion.right - energy.conclusion.left  # type: ignore[attr-defined]
    eased = _eased(force)
    gained = _size(2 * delta * off + PAIR * y * mirror(force) * way)
    total = 4 * delta * burnt + 4 * PAIR * way * mirror(way) * eased.conclusion.right  # type: ignore[attr-defined]
    total += gained.conclusion.right  # type: ignore[attr-defined]
    share = positive(PAIR > 0, [epsilon > 0, positive(1 - epsilon > 0, epsilon < 1)])
    above = combined(
        Relation(S.Zero, "<", total),
        [4, assume(delta > 0), energy],
        [4, share, _size(way), eased],
        [gained],
    )
    root = assume(Eq(path, 0))
    worked = 2 * delta * PAIR * mirror(way) / delayed
    balance = combined(
        Relation(S.Zero, "=", total), [root, -worked], [mirrored(root), -mirror(worked)]
    )
    contrary = not_intro(closed(above, sine_not_zero()), closed(balance, sine_not_zero()))
    wanted = proposition(Ne(path, 0))
    return disj_cases(decided(path, S.Zero), contr(contrary, wanted), assume(wanted))


def _eased(force: Expr) -> Theorem:
    """0 <= the margin of the wall turned down to y: it is concave in y."""
    need, size = (f().xreplace(UNITS) for f in (required_straight, stiffness_squared))
    less = positive(1 - y >= 0, y <= 1)
    pair = positive(PAIR >= 0, [epsilon >= 0, positive(1 - epsilon >= 0, epsilon < 1)])
    stiff = combined(size >= 0, [_size(force.xreplace({l: S.Zero}))])  # of every delay the same
    return combined(
        delta**2 - y * delta * need - PAIR * y**2 * size / 4 >= 0,
        [less, assume(delta > 0), assume(delta > 0)],
        [assume(y > 0), margin_to_the_end(LATE_MARGIN)],
        [Rational(1, 4), pair, assume(y > 0), less, stiff],
    )


@cache
def late_passive_is_stable() -> Theorem:
    """Passive walls are stable, with every damped device and with every delay."""
    whole_one = _behind_a_whole_delay()
    apart = strictly(assume(epsilon >= 0), combined(Ne(0, epsilon), [assume(Ne(epsilon, 0))]))
    found = disj_cases(decided(epsilon, S.Zero), whole_one, closed(_between(), apart))
    return for_all(LOOP, [*GIVEN, PASSIVE], add_assum(found, *GIVEN, PASSIVE))


def _between() -> Theorem:
    """stable, for 0 < epsilon < 1."""
    stable = turned_up(l + 2, TOP, no_crossing(), numbers_of_a_late_device()[0])
    loop = axiom(
        "loop of a late device", alpha, beta, gamma, delta, l, epsilon, *LATE_NUMBERS, a, e
    )
    steps = [is_whole(l + n, assume(whole(l))) for n in (2, 3, 4)]
    passive = inst(passive_late(), UNITS)
    margin = conjunct(mp(passive, assume(PASSIVE)), EVERY_MARGIN.at(UNITS))
    inside = positive(epsilon >= 0, epsilon > 0), positive(epsilon <= 1, epsilon < 1)
    found = closed(mp(loop, closed(stable, *steps)), margin, *inside, fact(ONE))
    device = closed(axiom("late device", gamma, delta, epsilon), *inside)
    return choose(device, found)


def _behind_a_whole_delay() -> Theorem:
    """stable, for epsilon = 0."""
    none, late = assume(Eq(epsilon, 0)), Symbol("q")
    at_once = subst(PASSIVE.at({epsilon: late}), late, assume(PASSIVE), none)
    passive = closed(inst(passive_by_angle(l), UNITS), fact(ONE))
    margin = conjunct(mp(passive, at_once), every_margin(l).at(UNITS))
    stable = closed(
        conjunct(inst(passive_is_stable(), {d: l}), LATE_STABLE.at({epsilon: S.Zero})), margin
    )
    back = combined(Eq(0, epsilon), [none, -S.One])
    return subst(LATE_STABLE.at({epsilon: late}), late, stable, back)
