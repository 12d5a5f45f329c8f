"""(5) at every frequency decides, but for walls that pull, fractional delays and the border."""

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.largest_damping import divisors
from symhaptic.book.lemmas.passivity import PASSIVE, every_margin, passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import passive_in_numbers
from symhaptic.paper.propositions.passivity import FIVE, at_every_frequency
from symhaptic.proof.theorems.definitions import gains


def frequencies_met(frequencies: Any) -> Theorem:
    """(5) at every frequency of a passive wall that needs another damping at each of them."""
    angle = omega * T
    inside = (
        positive(angle > 0, [omega > 0, T > 0]),
        closed(positive(angle < pi, [omega < pi / T, T > 0]), not_zero(assume(T > 0))),
    )
    always = conjunct(mp(passive_by_angle(), assume(PASSIVE)), every_margin())
    weak = positive(b >= FIVE.rhs, [at(always, {theta: angle}, *inside)])
    below = closed(closed(weak, *divisors(angle)), *inside, not_zero(assume(T > 0)))
    apart = at(assume(off_border()), {omega: omega}, *map(assume, INSIDE_BAND))
    return for_all([omega], frequencies.body.of[0].of, strictly(below, apart))


INSIDE_BAND = (omega > 0, omega < pi / T)


def off_border() -> Proposition:
    """At no frequency the wall needs just the damping of the device."""
    return at_every_frequency(Ne(b, FIVE.rhs))


def on_the_border(claim: Proposition, point: Terms) -> tuple[Theorem, Theorem]:
    """A spring that just meets (5) at every frequency is passive: not (5), and it is on the border.

    Said without delay and damping, of T = 1.
    """
    same = taken_apart(claim)[2].at(point)
    passive = passive_in_numbers(point)
    inside = [fact(proposition(p).at({omega: S.One, T: S.One})) for p in INSIDE_BAND]
    met = at(mp(assume(same), passive), {omega: S.One}, *inside)
    need = met.conclusion.left  # type: ignore[attr-defined]
    equal = identity(need, point[b])
    equal = closed(equal, *map(fact, equal.hypotheses))
    denied_ = off_border().at(point)
    apart = at(assume(denied_), {omega: S.One}, *inside)
    return not_intro(met, equal, same), not_intro(apart, equal, denied_)


INSIDE = (omega > 0, omega < pi)
"""The frequencies for T = 1."""


def holds(claim: Proposition, point: Terms, *products: Any) -> Theorem:
    """(5) at every frequency for a wall in numbers, by the products of its margin."""
    frequencies = taken_apart(claim)[2].parts[0]
    relation = frequencies.body.of[1].at(point)  # type: ignore[attr-defined]
    return for_all([omega], INSIDE, closed(combined(relation, *products), *divisors(omega)))


def apart(met: Theorem) -> Theorem:
    """Such a wall is off the border."""
    there = at(met, {omega: omega}, *map(assume, INSIDE))
    need, damping = there.conclusion.terms
    return for_all([omega], INSIDE, positive(Ne(damping, need), [there]))


def gaining(claim: Proposition, point: Terms, met: Theorem, motion: Any) -> Theorem:
    """It meets (5) and a motion gains energy: (5) does not decide."""
    there = taken_apart(claim)[2].at(point)
    return not_intro(mp(assume(there), met), gains(list(point.values()), motion), there)
