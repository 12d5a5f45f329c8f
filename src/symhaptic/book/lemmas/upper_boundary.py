"""Above its corner the boundary of the passive walls is the curve (7), and nothing else.

On the ray of a wall with u = KT/2 > 0 and w = B + KT/2 beyond the corner, (N^2+2) u < 3 N w, lies a
wall of the envelope, N = 2 (d+1) > 2; both need their whole damping, and so the same.
"""

from symhaptic.book.lemmas.chords import sine, sine_of_larger, size, width
from symhaptic.book.lemmas.envelope import divisor
from symhaptic.book.lemmas.linear_part import known
from symhaptic.book.lemmas.lower_boundary import border_needs, is_some, of_border
from symhaptic.book.lemmas.passive_boundary import of_the_end
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import (
    first_half,
    limits,
    needed,
    on_first_half,
    pushes,
    sufficient,
)
from symhaptic.book.lemmas.touching import touches
from symhaptic.paper.propositions.passivity import ABOVE
from symhaptic.proof.theorems.analysis import crosses_zero


def aside(angle: Expr = psi) -> Expr:
    """How far a wall is off the ray of the wall of the envelope at an angle."""
    across = 2 * sin(N * angle) - N * sin(2 * angle) * cos(N * angle)
    return u * across - w * 2 * N * sin(angle) ** 2 * sin(N * angle)


BEYOND = (N**2 + 2) * u < 3 * N * w
"""A wall lies beyond the ray of the corner."""


@cache
def met() -> Theorem:
    """An angle 0 < psi < pi/N whose wall of the envelope lies on the ray of a wall; N > 2."""
    start = 2 * N * ((N**2 + 2) * u - 3 * N * w) / 3
    end = u * N**4 * sin(2 * pi / N) / pi**3
    off = aside() / psi**3
    ends = (tends(off, psi, *end) for end in ((S.Zero, start), (pi / N, end)))
    here = Given(N > 2, u > 0, BEYOND)
    found = crosses_zero(*ends, show(Ne(psi, 0), psi > 0))
    return here.closed(found, here.show(sin(2 * pi / N) > 0))


WHOLE = {N: 2 * d + 2, u: K * T / 2, w: B + K * T / 2}
TURN = psi * (2 * d + 2)
RAY = proposition(Eq(aside().subs(WHOLE), 0))
SHARE = 4 * (d + 1) * sin(psi) ** 2 * sin(TURN)
"""The stiffness of the envelope at the angle, but for its divisor."""
NEED = K * T * divisor().subs(WHOLE) / (2 * SHARE)
"""The damping with which a wall on that ray is one of the envelope."""


BESIDE = Given(d > 0, T > 0, psi > 0, pi > TURN)


@cache
def _there() -> Given:
    """What is known of N = 2 (d+1) > 2 and an angle 0 < psi < pi/N."""
    return BESIDE.and_(*(inst(t(), {N: 2 * d + 2}) for t in (size, sine, sine_of_larger, width)))


@cache
def needed_there() -> Theorem:
    """b = NEED on the boundary, for K > 0, beside an angle of the ray; d is whole."""
    ray, here = assume(RAY), _there().and_(K > 0)
    device = here.show(NEED > 0)
    envelope = inst(touches(), {N: 2 * d + 2, phi: psi, psi: phi})
    margin = combined(
        first_half().body.of[1].at({b: NEED}),  # type: ignore[attr-defined]
        [device, envelope],
        [ray, cos(phi * (2 * d + 2)) / SHARE],
    )
    always = on_first_half(here.closed(margin))
    passive = closed(inst(sufficient(), {b: NEED}), always, here.show(K >= 0))
    enough = border_needs(NEED, passive, here.show(NEED >= 0, device))
    least = of_border(at(needed(), {phi: psi}, assume(psi > 0), assume(pi > TURN)))
    least = combined(b >= NEED, [least], [ray, -cos(TURN) / SHARE])
    return here.closed(both_ways(enough, least))


END = pi / (T * (d + 1))


def on_the_curve(wanted: Any) -> Theorem:
    """A wall of the boundary, K > 0, beside an angle of its ray: it is (7) at omega = 2 psi/T."""
    frequency = {omega: 2 * psi / T}
    *inside, stiffness, damping = (p.at(frequency) for p in wanted.body.of)
    ray, need = assume(RAY), needed_there()
    share_of = [-derivative(line.right, b) for line in (stiffness, damping)]
    shown = [
        *map(_there().show, inside),
        combined(stiffness, [need, share_of[0]]),
        combined(damping, [need, share_of[1]], [ray, -1 / SHARE]),
    ]
    return _there().closed(exists(conj(*shown), wanted, frequency))


def at_the_axis(wanted: Any) -> Theorem:
    """A wall of the boundary with K = 0 and B >= 0 is (0, b), the end of (7)."""
    soft, damped = assume(Eq(K, 0)), assume(B >= 0)
    wave = phi * (2 * d + 2)
    margin = combined(
        first_half().body.of[1].at({b: B}),  # type: ignore[attr-defined]
        [damped, known()[2]],
        [soft, -T / 2 * (cos(wave) - cos(phi) * sin(wave) / sin(phi))],
    )
    passive = closed(inst(sufficient(), {b: B}), on_first_half(margin), show(K >= 0, soft))
    least = show(b >= B, of_border(limits()[0]), soft)
    full = both_ways(border_needs(B, passive, damped), least)
    *inside, stiffness, damping = wanted.body.of
    end, here = assume(Eq(omega, END)), Given(T > 0, d > 0)
    none, device = of_the_end(stiffness.right, damping.right, end)
    shown = [
        *(here.show(p, end) for p in inside),
        combined(stiffness, [soft, S.One], [none, -S.One]),
        combined(damping, [full, -S.One], [device, -S.One]),
    ]
    there = closed(conj(*shown), *shown[:2])
    return here.closed(choose(is_some(omega, END), exists(there, wanted, {omega: omega})))


@cache
def loss() -> Theorem:
    """0 <= d b/(2d+3)."""
    return show(d * b / (2 * d + 3) >= 0, d >= 0, b >= 0)


def upper_boundary(wanted: Any) -> Theorem:
    """A wall of the boundary with B > b d/(2d+3) is one of (7), for a whole d > 0."""
    here = Given(T > 0, d > 0)
    rest = show(B - d * b / (2 * d + 3) > 0, ABOVE[1])
    beyond = here.show(BEYOND.subs(WHOLE), of_border(limits()[1]), rest)
    angle = inst(met(), WHOLE)
    *_, off = angle.conclusion.body.of  # type: ignore[attr-defined]
    inside = here.and_(psi > 0, psi < pi / (2 * d + 2))
    ray = inside.closed(combined(RAY, [assume(off), psi**3]))
    curve = inside.closed(closed(on_the_curve(wanted), ray))
    curve = here.and_(K > 0).closed(choose(angle, curve), beyond)
    apart = strictly(of_border(pushes()), show(Ne(S.Zero, K), Ne(K, 0)))
    axis = closed(at_the_axis(wanted), show(B >= 0, rest, loss()))
    return here.closed(disj_cases(decided(K, 0), axis, closed(curve, apart)))
