"""The passive wall of maximum stiffness with an integer delay: the tip of the envelope."""

from symhaptic.book.lemmas.corners import stiffest
from symhaptic.book.lemmas.passivity import PASSIVE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import DELAY, measured, needed, on_first_half, sufficient

TURN = pi / (4 * (d + 1))
"""Half the angle at which damping does nothing, theta = pi/(2 (d+1))."""


@cache
def waves(*given: Any) -> Given:
    """Where sine and cosine of TURN and of twice it are positive: 0 < T and 0 <= d, or as given."""
    here = Given(*given) if given else DELAY.and_()
    for claim in TURN > 0, pi / 2 > TURN, sin(TURN) > 0, cos(TURN) > 0, sin(2 * TURN) > 0:
        here.have(claim)
    return here


def stiffest_wall(stiffness: Theorem, damping: Theorem) -> Theorem:
    """The wall of (11) is passive, and no passive one is stiffer; d is whole."""
    found = DELAY.closed(inst(stiffest(), {psi: phi, N: 2 * d + 2}))
    always = on_first_half(measured(stiffness, damping, [assume(b >= 0), found]))
    pushes = combined(K >= 0, [assume(b >= 0), slope()], [stiffness, -S.One])
    passive = waves().closed(closed(sufficient(), always, pushes))
    return conj(passive, largest(stiffness))


def per_damping() -> Expr:
    """The largest stiffness per damping, 2/T tan(pi/(4 (d+1)))."""
    return 2 * (1 - cos(2 * TURN)) / (T * sin(2 * TURN))


@cache
def slope() -> Theorem:
    """0 < 2/T tan(pi/(4 (d+1)))."""
    return waves().show(per_damping() > 0, show(1 - cos(2 * TURN) > 0, waves().show(sin(TURN) > 0)))


@cache
def bound() -> Theorem:
    """K <= 2b/T tan(pi/(4 (d+1))) for every passive wall; d is whole."""
    inside = waves().show(TURN > 0), waves().show((2 * d + 2) * TURN < pi)
    there = at(needed(), {phi: TURN}, *inside)
    return waves().closed(show(b * per_damping() >= K, slope(), there))


def largest(stiffness: Theorem) -> Theorem:
    """No passive wall is stiffer than that of (11)."""
    found = show(x <= K, inst(bound(), {K: x, B: y}), stiffness)
    return for_all([x, y], [PASSIVE.at({K: x, B: y})], waves().closed(found))


def largest_of(printed: Any, delay: int) -> tuple[Theorem, Theorem, Expr]:
    """The largest stiffness of a delay: its wall is passive, none is stiffer, and its value."""
    wall = stiffest_wall(*map(assume, printed))
    at_delay = {d: S(delay)}
    values = {line.lhs: line.rhs.xreplace(at_delay) for line in printed}
    there = inst(wall, at_delay | values)
    known = [identity(value, value) for value in values.values()]
    passive = conjunct(closed(there, *known), PASSIVE.at(at_delay | values))
    bare = Given(b >= 0, T > 0)
    return bare.closed(passive), bare.closed(inst(bound(), at_delay)), values[K]
