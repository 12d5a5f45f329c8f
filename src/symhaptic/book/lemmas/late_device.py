"""What a device does at the samples with a force that arrives inside a period: exactly M/(zA) z^-l.

With the motion g(t) under a unit force from rest, n_1 = g(1), n_0 = g(2) - (1+a) n_1,
m_2 = g(1-epsilon), m_1 = g(2-epsilon) - (1+a) m_2, and m_2 + m_1 + m_0 = n_1 + n_0.
"""

from dataclasses import dataclass

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.renaming import definitions, explicit, renamed
from symhaptic.model.plant import normalised
from symhaptic.proof.theorems.axioms import answers, transfer
from symhaptic.proof.theorems.samples import held_answer

FRACTION = (whole(l), proposition(epsilon >= 0), proposition(epsilon <= 1))
SPLIT = sqrt(delta**2 - 4 * gamma)
"""The difference of the poles of a device."""
BOTTOM, TOP = z**2 - a * z + e, m_2 * z**2 + m_1 * z + m_0
"""A(z) and M(z)."""


@dataclass(frozen=True)
class Kind:
    """A kind of device: what is not zero, its motion under a unit force, and a; e = exp(-delta)."""

    plant: Plant
    apart: tuple[Expr, ...]
    moved: Expr
    trace: Expr

    @property
    def parts(self) -> tuple[Expr, Expr, Expr]:
        """Mass, damping and stiffness; a part that is not there is zero."""
        return self.plant.mass, self.plant.damping or S.Zero, self.plant.stiffness or S.Zero

    @property
    def definitions(self) -> tuple[Relation, ...]:
        """The numbers of the device, with and without the delay."""
        one, two, first, second = (self.moved.subs(t, n) for n in (1, 2, 1 - epsilon, 2 - epsilon))
        named = (
            (a, self.trace),
            (e, exp(-self.parts[1])),
            (n_1, one),
            (n_0, two - (1 + a) * n_1),
            (m_2, first),
            (m_1, second - (1 + a) * m_2),
            (m_0, n_1 + n_0 - m_2 - m_1),
        )
        return tuple(Relation(name, "=", value) for name, value in named)

    @property
    def given(self) -> tuple[Proposition, ...]:
        """What is not zero, the delay, and the numbers."""
        return (*(proposition(Ne(p, 0)) for p in self.apart), *FRACTION, *self.definitions)

    @property
    def over(self) -> tuple[Expr, ...]:
        """All symbols that are met."""
        names = frozenset[Expr]().union(*(p.free_symbols for p in self.apart))
        device = (p for p in (gamma, delta) if p in names)
        return (*device, epsilon, l, z, X, *(d.left for d in self.definitions))

    def says(self) -> Proposition:
        """The answer to z^k is X <=> z and A are not zero, and X = M/(zA) z^-l; and m_2 and m_1
        tend to n_1 and n_0 at 0, to themselves at epsilon, and to 0 and n_1 at 1."""
        response = transfer(self.parts, l + epsilon, s)
        apart = (proposition(Ne(f, 0)) for f in (z, BOTTOM))
        place = Relation(X, "=", TOP / (z * BOTTOM) * z**-l)
        answer = Iff((answers(response, s, z, X, S.One), And((*apart, place))))
        first, second = (self.moved.subs(t, n - x) for n in (1, 2))
        rest = second - (1 + a) * first
        ends = ((S.Zero, (n_1, n_0)), (epsilon, (m_2, m_1)), (S.One, (S.Zero, n_1)))
        limits = (
            Predicate("limit", (x,), (number, end, value))
            for end, values in ends
            for number, value in zip((first, rest), values, strict=True)
        )
        return both([answer, *limits])


_DECAY, _HALF = exp(-delta * t), exp(-delta * t / 2)
_SWING = cosh(SPLIT * t / 2) + delta * sinh(SPLIT * t / 2) / SPLIT
KINDS = (
    Kind(
        normalised(FULL),
        (gamma, delta**2 - 4 * gamma),
        (1 - _HALF * _SWING) / gamma,
        2 * exp(-delta / 2) * cosh(SPLIT / 2),
    ),
    Kind(
        Plant(S.One, delta, delta**2 / 4),
        (delta,),
        4 * (1 - (1 + delta * t / 2) * _HALF) / delta**2,
        2 * exp(-delta / 2),
    ),
    Kind(
        normalised(Parts(stiffness=False)),
        (delta,),
        (delta * t - 1 + _DECAY) / delta**2,
        1 + exp(-delta),
    ),
    Kind(normalised(Parts(stiffness=False, damping=False)), (), t**2 / 2, S(2)),
)
"""All devices: with a spring, critically damped, with a damper alone, and the free mass."""


def exact_plant() -> Proposition:
    """The answer, and that nothing jumps, for every device."""
    return both(ForAll(kind.over, implied(kind.given, kind.says())) for kind in KINDS)


@cache
def exact_late_plant() -> Theorem:
    """That."""
    return conj(*map(_exact, KINDS))


def _exact(kind: Kind) -> Theorem:
    names = definitions(kind.definitions)
    answer, *limits = explicit(kind.says(), *names).parts
    found = conj(_answer(kind, answer), *(tends(c.of[0], x, *c.of[1:]) for c in limits))
    found = renamed(closed(found, *_divisors(kind)), kind.says(), *names)
    return for_all(kind.over, kind.given, add_assum(found, *kind.given))


def _answer(kind: Kind, claim: Iff) -> Theorem:
    motion = (*kind.plant.transition(t), *kind.plant.held(t))
    held = held_answer(kind.parts, (l, epsilon), s, z, X, motion, t)
    answer, sampled = claim.of
    alive, apart, equal = (assume(p) for p in sampled.parts)
    claims = held.conclusion.of[1].parts  # type: ignore[attr-defined]
    known = [conjunct(mp(held, assume(answer)), p) for p in claims]
    bottom = apart.conclusion.left  # type: ignore[attr-defined]
    below = combined(Ne(bottom, 0), [known[1]])
    there = combined(equal.conclusion, [known[2], 1 / bottom])
    back = closed(combined(claims[2], [equal, bottom]), alive, apart)
    return either_way(
        conj(known[0], below, closed(there, below, known[0])),
        mp(held, conj(alive, combined(claims[1], [apart]), back)),
        answer,
        sampled,
    )


def _divisors(kind: Kind) -> tuple[Theorem, ...]:
    """What the motion of a device with a spring divides by is not zero."""
    if kind.plant.stiffness != gamma:
        return ()
    spring, square = (assume(Ne(p, 0)) for p in kind.apart)
    one, two = (-delta + SPLIT) / 2, (-delta - SPLIT) / 2
    poles = (factor(of, spring, -other) for of, other in ((one, two), (two, one)))
    lowest = (  # as the series leave them
        combined(
            Ne(expand(2 * gamma * (delta**2 - 4 * gamma) * exp(w)), 0),
            [2, spring, square, sign_of(exp, w)],
        )
        for w in (delta * epsilon, delta, 2 * delta)
    )
    return square, *poles, *lowest
