"""When is a wall passive that is late by a fraction of a period?  The condition at each angle."""

from symhaptic.book.lemmas.passivity import at_every_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.energy import toeplitz

WALL = (K, B, b, T, l, epsilon)
LATE = Predicate("passive_wall", (), (K, B, b, T, l + epsilon))
"""The wall is passive, l + epsilon periods late."""
GIVEN = tuple(map(proposition, (T > 0, b > 0, whole(l), epsilon >= 0, epsilon <= 1)))
MARGIN = fractional.margin()
EVERY_MARGIN = at_every_angle(MARGIN >= 0)


@cache
def passive_late() -> Theorem:
    """passive <=> 0 <= K and 0 <= b (b - n) - epsilon (1 - epsilon) T^2 |H|^2/4 at every angle."""
    energy = axiom("passive late wall", *WALL)
    sampled = energy.conclusion.parts[1]
    form = toeplitz(sampled.terms[0], z, sampled.terms[1], theta)
    wanted = And((proposition(K >= 0), EVERY_MARGIN))
    static, always = form.conclusion.parts[1].parts
    raw = always.body.of[1]  # type: ignore[attr-defined]
    here = Given(T > 0, b > 0, *INSIDE).and_(sine_of_half(theta))
    here.have(1 / T > 0)
    here.have(1 / b > 0)
    known = And((static, always))
    inside = [assume(p) for p in INSIDE]
    at_angle = at(conjunct(assume(known), always), {theta: theta}, *inside)
    there = here.show(MARGIN >= 0, at_angle, degree=3)
    margin = at(conjunct(assume(wanted), EVERY_MARGIN), {theta: theta}, *inside)
    back = here.show(raw, margin, degree=3)
    spring, sums = conjunct(assume(wanted), K >= 0), conjunct(assume(known), static)
    same = either_way(
        conj(show(K >= 0, sums), for_all([theta], INSIDE, there)),
        conj(show(static, spring), for_all([theta], INSIDE, back)),
        known,
        wanted,
    )
    return Given(T > 0, b > 0, whole(l)).closed(chained(energy, chained(form, same)))


# -- as it is printed ------------------------------------------------------------------

_REST, _HALF = 1 - epsilon, sp.S.Half
CONDITION = sp.Ge(
    b**2
    + b * B * (_REST * sp.cos((l + 1) * theta) + epsilon * sp.cos((l + 2) * theta))
    - b
    * K
    * T
    / (2 * sp.sin(theta / 2))
    * (_REST * sp.sin((l + _HALF) * theta) + epsilon * sp.sin((l + 3 * _HALF) * theta)),
    epsilon * _REST / 4 * (K**2 * T**2 + 4 * B * (K * T + B) * sp.sin(theta / 2) ** 2),
)
"""What a passive wall needs at an angle."""
LOW = sp.Ge(b + B, K * T * (l + epsilon + _HALF) + epsilon * _REST * K**2 * T**2 / (4 * b))
"""What it needs at low frequencies."""
LINE = sp.Eq(b + B, K * T * (l + epsilon + _HALF))
"""(8) and (9), with the delay l + epsilon."""


def condition_at_every_angle() -> Proposition:
    """For 0 <= K a wall is passive if and only if the condition holds at every angle."""
    return every(WALL, [*GIVEN, K >= 0], Iff((LATE, at_every_angle(CONDITION))))


@cache
def passive_at_every_angle() -> Theorem:
    """That."""
    found, spring = passive_late(), assume(K >= 0)
    here, inside = Given(*INSIDE).and_(sine_of_half(theta)), [assume(p) for p in INSIDE]

    def always(known: Theorem, margin: Any) -> Theorem:
        return for_all([theta], INSIDE, here.show(margin, at(known, {theta: theta}, *inside)))

    wanted = at_every_angle(CONDITION)
    there = always(conjunct(mp(found, assume(LATE)), EVERY_MARGIN), CONDITION)
    back = mp(found, conj(spring, always(assume(wanted), MARGIN >= 0)))
    same = either_way(there, back, LATE, wanted)
    return for_all(WALL, [*GIVEN, K >= 0], add_assum(same, *GIVEN, K >= 0))


def low_frequencies() -> Proposition:
    """A passive wall meets the condition at low frequencies; on the line no stiff wall does."""
    beyond = implied([epsilon > 0, epsilon < 1, K > 0, LINE], Not((proposition(LOW),)))
    return every(WALL, GIVEN, both([implied([LATE], LOW), beyond]))


@cache
def needed_at_low_frequencies() -> Theorem:
    """That: the margin over b tends to the difference of both sides."""
    always = conjunct(mp(passive_late(), assume(LATE)), EVERY_MARGIN)
    margin = at(always, {theta: theta}, *(assume(p) for p in INSIDE))
    here = Given(b > 0, T > 0)
    end = b * (LOW.lhs - LOW.rhs)
    limit = tends(MARGIN, theta, sp.S.Zero, end)
    start = in_the_limit(margin, theta, sp.S.Zero, sp.pi, limit)
    needed = here.closed(show(LOW, over(end / b >= 0, start, b > 0)))
    inside = here.and_(epsilon > 0, epsilon < 1, K > 0)
    more = inside.show(epsilon * _REST * K**2 * T**2 / (4 * b) > 0)
    lost = inside.show(Relation(LOW.lhs, "<", LOW.rhs), more, LINE)
    beyond = disch(denied(lost, LOW), epsilon > 0, epsilon < 1, K > 0, LINE)
    return for_all(WALL, GIVEN, add_assum(conj(disch(needed, LATE), beyond), *GIVEN))
