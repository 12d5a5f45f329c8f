"""Walls of (27) are those of (7), in the units of Table I; and so are those of the boundary."""

from symhaptic.book.lemmas.passive_boundary import on_boundary
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import DELAY
from symhaptic.book.lemmas.upper_boundary import upper_boundary
from symhaptic.notation import omega_hat
from symhaptic.paper.propositions.device import normalised

TABLE = normalised(alpha, beta, delta)
CURVE = transcribed("eq27")
ON_CURVE = Exists((omega_hat,), both([omega_hat > 0, omega_hat < pi, *CURVE]))
"""A wall is one of (27)."""


def in_units() -> Theorem:
    """A wall of (27) is on the boundary, by Table I and for omega_hat <= pi/(d+1)."""
    stiff, damped, lossy, spring, damper = map(assume, (*TABLE, *CURVE))
    known = inst(on_boundary(*map(assume, transcribed("eq7"))), {omega: omega_hat / T})
    stiffness, damping = (line.subs(omega, omega_hat / T) for line in transcribed("eq7"))
    wall = [
        combined(stiffness, [stiff, -m / T**2], [_damped(spring, lossy), m / T**2]),
        combined(damping, [damped, -m / T], [_damped(damper, lossy), m / T]),
    ]
    here = DELAY.and_(m > 0, omega_hat > 0, omega_hat < pi, omega_hat <= pi / (d + 1))
    return here.closed(closed(known, *wall), degree=3)


def _damped(line: Theorem, lossy: Theorem) -> Theorem:
    """One line of (27), with b T/m for delta; or of (7), the other way round."""
    said: Any = line.conclusion
    place, known = Symbol("q"), lossy.conclusion.left  # type: ignore[attr-defined]
    pattern = Relation(said.left, "=", said.right.xreplace({known: place}))
    return subst(pattern, place, line, lossy)


def above_in_units(wanted: Any) -> Theorem:
    """A wall of the boundary with B > b d/(2d+3), d > 0, is one of (27) at omega_hat = omega T."""
    inside = [omega > 0, omega < pi / T]
    found = upper_boundary(Exists((omega,), both([*inside, *transcribed("eq7")])))
    low, high, *lines = map(assume, found.conclusion.body.of)  # type: ignore[attr-defined]
    *table, lossy = map(assume, TABLE)
    here = Given(T > 0, m > 0, low, high)
    damper = combined(Eq(b, delta * m / T), [lossy, -m / T])
    there = [p.at({omega_hat: omega * T}) for p in wanted.body.of]
    shown = [
        *map(here.show, there[:2]),
        *(
            combined(goal, [of, 1], [_damped(line, damper), scale])
            for goal, of, line, scale in zip(
                there[2:], table, lines, (T**2 / m, T / m), strict=True
            )
        ),
    ]
    at = exists(conj(*shown), wanted, {omega_hat: omega * T})
    return here.closed(choose(found, at))
