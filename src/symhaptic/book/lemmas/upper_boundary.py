"""Above its corner the boundary of the passive walls is the curve (7), and nothing else.

On the ray of a wall with u = KT/2 > 0 and w = B + KT/2 beyond the corner, (N^2+2) u < 3 N w, lies a
wall of the envelope, N = 2 (d+1) > 2; both need their whole damping, and so the same.
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import (
    HALF,
    PI,
    not_zero,
    quarter,
    sine,
    sine_of_larger,
    size,
    width,
)
from symhaptic.book.lemmas.envelope import divisor
from symhaptic.book.lemmas.linear_part import known, shares
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
from symhaptic.notation import b, u, w
from symhaptic.paper.propositions.passivity import ABOVE
from symhaptic.proof.theorems.analysis import crosses_zero

THIRD = Rational(1, 3)


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
    found = crosses_zero(*ends, not_zero(assume(psi > 0)))
    turn = over(pi / N > 0, PI, size())
    half = over(2 * pi / N < pi, positive(pi * (N - 2) > 0, [PI, N > 2]), size())
    wave = closed(sign_of(sin, 2 * pi / N), half, positive(2 * pi / N > 0, [2, turn]))
    above = over(
        end > 0,
        positive(u * N**4 * sin(2 * pi / N) > 0, [u > 0, *4 * [size()], wave]),
        number(Relation(S.Zero, "<", pi**3)),
    )
    below = positive(start < 0, [2 * THIRD, size(), BEYOND])
    return closed(found, below, above, turn, not_zero(size()))


WHOLE = {N: 2 * d + 2, u: K * T / 2, w: B + K * T / 2}
TURN = psi * (2 * d + 2)
RAY = proposition(Eq(aside().subs(WHOLE), 0))
SHARE = 4 * (d + 1) * sin(psi) ** 2 * sin(TURN)
"""The stiffness of the envelope at the angle, but for its divisor."""
NEED = K * T * divisor().subs(WHOLE) / (2 * SHARE)
"""The damping with which a wall on that ray is one of the envelope."""


def _there(theorem: Theorem) -> Theorem:
    """What is known of N > 2 and an angle 0 < psi < pi/N, of N = 2 (d+1)."""
    late = positive(2 * d + 2 > 2, [2, d > 0])
    return closed(inst(theorem, {N: 2 * d + 2}), late)


@cache
def share() -> Theorem:
    """0 < SHARE."""
    known = [2, *map(_there, (size(), sine(), sine(), sine_of_larger()))]
    return positive(SHARE > 0, known)


@cache
def divisors() -> tuple[Theorem, ...]:
    """What the damping, the frequency and (7) divide by is not zero."""
    products = sine(), sine_of_larger(), width()
    parts = [*map(_there, products), positive(4 * d + 4 > 0, [4, shares()[0]]), assume(T > 0)]
    curve = combined(Ne(-divisor().subs(WHOLE), 0), [_there(width())])
    return curve, *map(not_zero, parts)


@cache
def needed_there() -> Theorem:
    """b = NEED on the boundary, for K > 0, beside an angle of the ray; d is whole."""
    ray = assume(RAY)
    top = positive(K * T * divisor().subs(WHOLE) > 0, [K > 0, T > 0, _there(width())])
    device = over(NEED > 0, top, positive(2 * SHARE > 0, [2, share()]))
    envelope = inst(touches(), {N: 2 * d + 2, phi: psi, psi: phi})
    margin = combined(
        first_half().body.of[1].at({b: NEED}),  # type: ignore[attr-defined]
        [device, closed(envelope, positive(2 * d + 2 > 2, [2, d > 0]))],
        [ray, cos(phi * (2 * d + 2)) / SHARE],
    )
    always = on_first_half(closed(margin, *divisors()))
    passive = closed(inst(sufficient(), {b: NEED}), always, positive(K >= 0, K > 0))
    enough = border_needs(NEED, passive, positive(NEED >= 0, [device]))
    inside = assume(psi > 0), assume(pi > TURN)
    least = of_border(at(needed(), {phi: psi}, *inside))
    least = combined(b >= NEED, [least], [ray, -cos(TURN) / SHARE])
    return closed(both_ways(enough, least), *divisors(), positive(d >= 0, d > 0))


END = pi / (T * (d + 1))


def on_the_curve(wanted: Any) -> Theorem:
    """A wall of the boundary, K > 0, beside an angle of its ray: it is (7) at omega = 2 psi/T."""
    frequency = {omega: 2 * psi / T}
    *inside, stiffness, damping = (p.at(frequency) for p in wanted.body.of)
    period, ray, need = assume(T > 0), assume(RAY), needed_there()
    low = over(2 * psi / T > 0, positive(2 * psi > 0, [2, psi > 0]), period)
    half = positive(pi - 2 * psi > 0, [2, _there(quarter())])
    turn = positive(pi - 2 * psi * (d + 1) >= 0, pi > TURN)
    last = over(2 * psi / T <= END, turn, positive(T * (d + 1) > 0, [period, shares()[0]]))
    shown_of = {t.conclusion: t for t in (low, over(2 * psi / T < pi / T, half, period), last)}
    share_of = [-derivative(line.right, b) for line in (stiffness, damping)]
    shown = [
        *(shown_of[p] for p in inside),
        combined(stiffness, [need, share_of[0]]),
        combined(damping, [need, share_of[1]], [ray, -1 / SHARE]),
    ]
    found = exists(conj(*shown), wanted, frequency)
    return closed(found, *divisors(), positive(d >= 0, d > 0))


def at_the_axis(wanted: Any) -> Theorem:
    """A wall of the boundary with K = 0 and B >= 0 is (0, b), the end of (7)."""
    soft, damped = assume(Eq(K, 0)), assume(B >= 0)
    wave = phi * (2 * d + 2)
    margin = combined(
        first_half().body.of[1].at({b: B}),  # type: ignore[attr-defined]
        [damped, known()[2]],
        [soft, -T / 2 * (cos(wave) - cos(phi) * sin(wave) / sin(phi))],
    )
    pushes = combined(K >= 0, [soft, -S.One])
    passive = closed(inst(sufficient(), {b: B}), on_first_half(margin), pushes)
    least = combined(b >= B, [of_border(limits()[0])], [soft, -T / 2])
    full = both_ways(border_needs(B, passive, damped), least)
    *inside, stiffness, damping = wanted.body.of
    end = assume(Eq(omega, END))
    none, device = of_the_end(stiffness.right, damping.right, end)
    period, turn = assume(T > 0), positive(T * (d + 1) > 0, [T > 0, shares()[0]])
    start = combined(inside[0], [over(END > 0, PI, turn)], [end, -S.One])
    left = over(pi / T - END > 0, positive(pi * d > 0, [PI, d > 0]), turn)
    shown_of = {t.conclusion: t for t in (start, combined(omega < pi / T, [left], [end, S.One]))}
    shown_of |= {proposition(omega <= END): combined(omega <= END, [end, S.One])}
    shown = [
        *(shown_of[p] for p in inside),
        combined(stiffness, [soft, S.One], [none, -S.One]),
        combined(damping, [full, -S.One], [device, -S.One]),
    ]
    there = closed(conj(*shown), *shown[:2])
    found = choose(is_some(omega, END), exists(there, wanted, {omega: omega}))
    return closed(found, not_zero(turn), not_zero(period), not_zero(shares()[0]))


@cache
def loss() -> Theorem:
    """0 <= d b/(2d+3)."""
    high = shares()[2]
    found = over(d * b / (2 * d + 3) >= 0, positive(d * b >= 0, [d >= 0, b >= 0]), high)
    return closed(found, not_zero(high))


def upper_boundary(wanted: Any) -> Theorem:
    """A wall of the boundary with B > b d/(2d+3) is one of (7), for a whole d > 0."""
    stiff, more = assume(K > 0), shares()
    rest = positive(B - d * b / (2 * d + 3) > 0, ABOVE[1])
    beyond = positive(BEYOND.subs(WHOLE), [2, d >= 0, of_border(limits()[1])], [2, more[2], rest])
    angle = inst(met(), WHOLE)
    *_, off = angle.conclusion.body.of  # type: ignore[attr-defined]
    ray = combined(RAY, [assume(off), psi**3])
    below = positive(pi > TURN, [positive(2 * d + 2 > 0, [2, more[0]]), psi < pi / (2 * d + 2)])
    late = positive(2 * d + 2 > 2, [2, d > 0])
    curve = closed(on_the_curve(wanted), ray, below, not_zero(assume(psi > 0)))
    force = positive(K * T / 2 > 0, [HALF, stiff, T > 0])
    curve = closed(choose(angle, curve), beyond, force, late)
    apart = strictly(of_border(pushes()), combined(Ne(S.Zero, K), [assume(Ne(K, 0))]))
    damped = positive(B >= 0, [rest], [loss()])
    found = disj_cases(decided(K, 0), closed(at_the_axis(wanted), damped), closed(curve, apart))
    divisors_ = *map(not_zero, more), not_zero(positive(2 * d + 2 > 0, [2, more[0]]))
    return closed(found, *divisors_, positive(d >= 0, d > 0))
