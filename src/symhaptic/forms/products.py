"""Products whose derivative loses digits when it is taken factor by factor, with that derivative.

Such as gamma NumeratorAtOne = 1 - a + e, which is differentiated as a whole.
"""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Expr, Symbol, exp

from symhaptic.forms import fractional_delay
from symhaptic.forms.entire import C, Decay, Fade, Lag, S
from symhaptic.forms.entire_device import NumeratorAtOne, NumeratorGap, PlantN0
from symhaptic.forms.slopes import Coast, Echo, Kick, NumeratorGapDrop
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import delta, epsilon, gamma


def _stretched() -> Iterator[tuple[Expr, dict[Symbol, Expr]]]:
    """What moves in a part of a period: by its length, as it moves at its end; longest first."""
    still, loose = FULL.without("stiffness"), FULL.without("damping")
    for parts in (FULL, still, loose):
        for time, way in ((1 - epsilon, -1), (epsilon, 1)):
            yield from _moved(parts, time, way)


def _moved(parts: Parts, time: Expr, way: int) -> Iterator[tuple[Expr, dict[Symbol, Expr]]]:
    x = fractional_delay.brief(parts, time)
    scaled = gamma * time**2, delta * time
    if not parts.damping:  # without the half before S(..)^2
        yield 2 * x.rise, {epsilon: 2 * way * x.kick}
        yield x.kick, {epsilon: way * C(-scaled[0])}
        return
    yield exp(-delta * (1 - time)) * x.fall, {epsilon: way * exp(-delta * (1 - time)) * x.kick}
    turned = {epsilon: way * delta * x.fall}
    if parts.stiffness:
        turned |= {gamma: -delta * time**5 * NumeratorGapDrop(*scaled),
                   delta: time**3 * (PlantN0(*scaled) - 2 * Echo(*scaled))}  # fmt: skip
        speed = Coast(*scaled)
    else:
        turned |= {delta: time**3 * (Fade(scaled[1]) - 2 * Lag(scaled[1]))}
        speed = exp(-scaled[1])
    yield x.apart, turned
    yield x.rise, {epsilon: way * x.kick}
    yield x.fall, {epsilon: way * (x.kick - delta * x.fall)}
    kept = exp(-scaled[1])
    yield x.loss, {delta: time * kept, epsilon: way * delta * kept}
    yield x.kick, {epsilon: way * speed}


WHOLE: tuple[tuple[Expr, dict[Symbol, Expr]], ...] = (
    (
        gamma * NumeratorAtOne(gamma, delta),
        {gamma: Kick(gamma, delta), delta: -gamma * PlantN0(gamma, delta)},
    ),
    (
        delta * NumeratorGap(gamma, delta),
        {
            gamma: -delta * NumeratorGapDrop(gamma, delta),
            delta: PlantN0(gamma, delta) - 2 * Echo(gamma, delta),
        },
    ),
    (delta * Decay(delta), {delta: exp(-delta)}),
    (delta * Lag(delta), {delta: Fade(delta) - 2 * Lag(delta)}),
    (gamma * S(-gamma / 4) ** 2, {gamma: S(-gamma)}),
    *_stretched(),
)
"""Products and their derivatives: 1 - a + e, n1 - n0, 1 - e, these without spring or damper, and
the device after a part of a period."""
