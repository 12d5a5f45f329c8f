"""Which environments h_0 + h_1/z + h_2/z^2 give no energy away: (4) for any three answers."""

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.largest_damping import divisors
from symhaptic.book.lemmas.passivity import INSIDE
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.passivity import ANSWER, TAPS
from symhaptic.proof.theorems.energy import toeplitz

PUSHES = Add(*TAPS) >= 0
"""H(1) >= 0: at rest the environment does not pull."""

_WHOLE = tuple(is_whole(d + late, assume(whole(d))) for late in (1, 2))


def by_angle() -> Theorem:
    """passive <=> H(1) >= 0 and the margin at every angle."""
    return toeplitz(ANSWER, z, b / T, theta)


def exactly() -> Theorem:
    """The same for T > 0 and a whole delay."""
    return closed(by_angle(), *apart(), *_WHOLE)


def no_motion_gains(frequencies: Any) -> Theorem:
    """Passive, from (4) at every frequency and H(1) >= 0."""
    angle, period = theta / T, over(1 / T > 0, one(), T > 0)
    inside = (
        over(angle > 0, theta > 0, T > 0),
        over(angle < pi / T, assume(theta < pi), T > 0),
    )
    met = at(assume(frequencies), {omega: angle}, *inside)
    energy = by_angle()
    static, always = energy.conclusion.of[1].of  # type: ignore[attr-defined]
    margin = closed(positive(always.body.of[1], [met, period]), *divisors(theta), *apart())
    found = follows(energy, assume(static), for_all([theta], INSIDE, margin))
    return closed(found, *apart(), *_WHOLE)


def apart() -> tuple[Theorem, ...]:
    """T is not zero."""
    return (positive(Ne(T, 0), T > 0),)


def holds(frequencies: Any, point: Mapping[Any, Any], *margin: Any) -> Theorem:
    """(4) at every frequency for an environment in numbers, by the products of its margin."""
    relation = frequencies.body.of[1].at(point)
    half = sine_of_half(omega)
    turned = not_zero(positive(1 - cos(omega) > 0, [2, half, half]))
    found = closed(combined(relation, *margin), turned)
    return for_all([omega], [omega > 0, omega < pi], found)


def pulled() -> Theorem:
    """-(1 + 1/z + 1/z^2) gives energy away beside the damper b/T = 1."""
    energy = toeplitz(ANSWER.subs(dict.fromkeys(TAPS, -1) | {d: 0}), z, S.One, theta)
    static, _ = energy.conclusion.of[1].of  # type: ignore[attr-defined]
    negative = denied(combined(Relation(S(-3), "<", S.Zero), [3]), static)
    gains = denied_by(energy, not_all(energy.conclusion.of[1], negative))  # type: ignore[attr-defined]
    return closed(gains, *map(is_whole, map(Integer, range(3))))
