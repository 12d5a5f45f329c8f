"""In which box the stable walls without delay lie, and the numbers of two devices of (23).

The devices differ in their springs.  With u = alpha + gamma Jury's minor is
F = L + beta (n_1 + n_0 (1-L)) - u n_0 (1 + n_1 beta) - beta^2 n_0 S + gamma n_0 (1 - n_0 beta),
where L = 1 - e and S = n_1 + n_0.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import damping_between, inequalities, no_stiffer, on_box
from symhaptic.paper.propositions.plots import OTHER, THICK
from symhaptic.proof import box
from symhaptic.proof.theorems.leaves import on_box as on_plain_box

PRIMED = {s: Symbol(f"{s}'") for s in NUMBERS}
"""The numbers of the device with it."""

START, SHARE = Rational(12, 10**4), Rational(72, 100)
"""How far a wall is moved: START, and SHARE of what the spring is softer."""

WIDE, LOW, HIGH = Rational(722, 1000), -Rational(3, 100), Rational(203, 100)
"""Stable walls have 0 < alpha + gamma < WIDE and LOW < beta < HIGH."""

NEAR = {n_1: Rational(20, 10**5), n_0: Rational(9, 10**5)}
"""So near to a half less a part of 1 - e are these."""
MIDDLE, SLOPE = S.Half - Rational(3, 10**5), {n_1: Rational(1, 6), n_0: Rational(1, 3)}

LEAST, LITTLE = Rational(9, 20), Rational(1, 1000)

u, h, g, m_1, m_0, y_1, y_0, L, eta = sp.symbols("u h g m_1 m_0 y_1 y_0 L eta")
"""alpha + gamma, how far the springs are apart, the first one, numbers of the other device, what
those of the first are less, 1 - e, and the share of its way to (-gamma, 1) that a wall is moved."""

THIN = {
    m_1: (Rational(4965, 10000), Rational(5001, 10000)),
    m_0: (Rational(4932, 10000), Rational(5001, 10000)),
    L: (-Rational(1, 1000), Rational(21, 1000)),
}
APART = {y: (-2 * NEAR[n], 2 * NEAR[n]) for y, n in ((y_1, n_1), (y_0, n_0))}
WALLS = {u: (S.Zero, WIDE), beta: (LOW, HIGH)}


PULL = (
    m_1
    + m_0 * (1 - L)
    + L
    - u * m_0 * m_1 * (1 - beta) * (1 - eta)
    + m_0 * (m_0 + m_1) * ((1 - beta) ** 2 * (1 - eta) - 1)
)
"""What F gains for a wall that is moved, per eta, but for a part with the spring."""
COST = m_0 * (1 - m_0 * beta) + Rational(1, 100)
"""What it loses with a softer spring, per gamma, and a little more."""
CHANGE = (
    y_1 * beta * (m_0 * (beta + u) - 1)
    + y_0 * (beta * (L - 1) + beta**2 * (2 * m_0 + m_1) + u * (1 + beta * m_1))
    + y_0 * g * (2 * beta * m_0 - 1)
    - beta * y_0 * (beta * (y_0 + y_1) + g * y_0 + u * y_1)
)
"""What it loses with other numbers."""


@cache
def on_walls(expr: Expr) -> Theorem:
    """0 < f for all walls and numbers, by balls."""
    ranges = {**WALLS, **THIN, **APART, eta: (S.Zero, 2 * THICK)}
    ranges |= dict.fromkeys((g, h), (S.Zero, STIFF))
    used = {s: ends for s, ends in ranges.items() if s in expr.free_symbols}
    return on_plain_box(box.positive(expr, used))


def primed(theorem: Theorem) -> Theorem:
    """The same of the device with the other spring."""
    return inst(theorem, {gamma: OTHER, **PRIMED})


@cache
def numbers_near() -> tuple[Theorem, ...]:
    """What is known of the numbers of a device of (23): each is positive."""
    known = []
    for number, s in ((n_1, m_1), (n_0, m_0), (1 - e, L)):
        known += [number - THIN[s][0], THIN[s][1] - number]
    for number, slope in SLOPE.items():
        middle = MIDDLE - slope * (1 - e)
        known += [NEAR[number] + number - middle, NEAR[number] - number + middle]
    return tuple(on_box(expr, RANGES) for expr in known)


@cache
def bounds() -> dict[str, Theorem]:
    """0 < alpha + gamma < WIDE, LOW < beta < HIGH and n_0 beta < 1 of a stable wall of (23)."""
    static = of_device("device at rest", assume(DEVICE))
    first, second, _, _ = inequalities(0)
    _, _, inside = damping_between(0, RANGES)
    stiff = no_stiffer(0, (Rational(72, 100), Rational(83, 100)), RANGES)
    total, late = on_box(n_1 + n_0, RANGES), on_box(n_0, RANGES)
    right = by_multiple(alpha + gamma > 0, total, [first], [static])
    wide = {**RANGES, alpha: (-STIFF, WIDE)}
    room = on_box(-2 * LOW * (n_1 + n_0) - (3 - a - e) - alpha * (n_1 - n_0), wide)
    up = by_multiple(beta - LOW > 0, show(2 * (n_1 + n_0) > 0, total), [second], [room])
    here = Given(gamma <= STIFF)
    found = {
        "right": right,
        "left": here.show(WIDE - alpha - gamma > 0, stiff),
        "up": here.closed(up, right, stiff),
        "down": by_multiple(HIGH - beta > 0, late, [inside], [on_box(n_0 * HIGH - 1, RANGES)]),
        "inside": inside,
    }
    return {name: t if name == "inside" else of_every_plant(t) for name, t in found.items()}
