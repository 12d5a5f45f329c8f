"""What can be checked: arguments in their order, exact values, and mistakes known by name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from flint import acb, arb

from symhaptic.bench.exact import EXACT

Exact = Callable[..., tuple[Any, ...]]


@dataclass(frozen=True)
class Checked:
    """A formula: ``exact`` gives one ball for each result, or truth values.

    ``ranges`` has for each argument the least and the largest value and hard values, and ``scale``
    the size that an error is measured by where a result is smaller, as by cancellation.
    """

    id: str
    ranges: dict[str, tuple[float, float, tuple[float, ...]]]
    results: tuple[str, ...]
    exact: Exact
    scale: Exact | None = None
    mistakes: dict[str, Exact] = field(default_factory=dict)
    whole: tuple[str, ...] = ()
    naught: str = ""
    """What it tells of NaN where the formula has a value."""


_B = (0.0, 50.0, (1e-300, 1e-8))
_PERIOD = (1e-4, 1e-2, (1e-3,))
_DELAY = (0.0, 8.0, ())
_GAMMA = (0.0, 9.8, (1e-300, 1e-16, 1e-8, 1.0, 2.25))
_DELTA = (0.0, 4.0, (1e-300, 1e-16, 1e-8, 2.0, 3.0))


def _eq11(b: float, T: float, d: float) -> tuple[Any, ...]:
    alpha, beta, _ = EXACT["max_passive_stiffness"](b, d)
    return alpha / arb(T), beta


def _eq11_turned(b: float, T: float, d: float) -> tuple[Any, ...]:
    n = arb(d) + 1
    angle = arb.pi() / (2 * n)
    return (
        2 * arb(b) * (1 - angle.sin()) / (arb(T) * (angle * d).sin()),
        arb(b) * ((angle * d).cos() - arb(d) / n) / angle.cos(),
    )


def _eq12(b: float, k: float, m: float, T: float) -> tuple[Any, ...]:
    mass, period = arb(m), arb(T)
    n1, n0, a, e = EXACT["discretize"](arb(k) * period**2 / mass, arb(b) * period / mass)
    return n1 * period**2 / mass, n0 * period**2 / mass, a, e


def _eq12_printed(b: float, k: float, m: float, T: float) -> tuple[Any, ...]:
    """Without the factor m/T."""
    mass, period, damping = arb(m), arb(T), arb(b)
    inside = damping**2 - 4 * arb(k) * mass
    c1 = acb(inside).sqrt() * period / mass
    half = damping * period / (2 * mass)
    c2, c3 = (-half - c1 / 2).exp(), (-half + c1 / 2).exp()
    e, below = (-2 * half).exp(), -2 * arb(k) * inside
    odd = damping * c1 * (c3 - c2)
    n1 = (odd + inside * (c2 + c3 - 2)) / below
    n0 = (-odd + inside * (c2 + c3 - 2 * e)) / below
    return n1.real, n0.real, (c2 + c3).real, e


def _stable(alpha: float, beta: float, gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    """Schur's recursion on the characteristic polynomial; None where the balls cannot tell."""
    n1, n0, a, e = EXACT["discretize"](gamma, delta)
    slope, be = arb(alpha) + arb(beta), arb(beta)
    loop = [n1 * slope, n0 * slope - n1 * be, -n0 * be]
    p = [arb(1), -a, e, arb(0)] + [arb(0)] * int(d)
    p[-3:] = [x + y for x, y in zip(p[-3:], loop, strict=True)]
    while len(p) > 1:
        if abs(p[-1]) > abs(p[0]):
            return (False,)
        if not abs(p[-1]) < abs(p[0]):
            return (None,)
        p = [p[0] * x - p[-1] * y for x, y in zip(p, reversed(p), strict=True)][:-1]
    return (True,)


def _below(limit: float) -> Exact:
    """A rule in circulation: stable below so many masses over the squared period."""
    return lambda alpha, *others: (alpha < limit,)


_PLANT: dict[str, tuple[float, float, tuple[float, ...]]] = {"gamma": _GAMMA, "delta": _DELTA}
_ZERO = "0/0 for k = 0 or critical damping, as (14) and (12) are printed"

CHECKED = {
    c.id: c
    for c in (
        Checked(
            "eq11",
            {"b": _B, "T": _PERIOD, "d": _DELAY},
            ("K", "B"),
            _eq11,
            lambda b, T, d: (0.0, b),
            {"sine and cosine are swapped": _eq11_turned},
            ("d",),
        ),
        Checked(
            "eq12",
            {
                "b": (0.0, 50.0, (1e-8, 2.0)),
                "k": (0.0, 2000.0, (1e-8, 1.0)),
                "m": (0.1, 5.0, (1.0,)),
                "T": _PERIOD,
            },
            ("n1", "n0", "a", "e"),
            _eq12,
            None,
            {"this is (12) as printed, without m/T; see the erratum": _eq12_printed},
            (),
            _ZERO,
        ),
        Checked(
            "eq14",
            _PLANT,
            ("n1", "n0", "a", "e"),
            EXACT["discretize"],
            lambda gamma, delta: (0.5, 0.5, 2.0, 0.0),
            {},
            (),
            _ZERO,
        ),
        Checked(
            "linear_limit",
            {"beta": (-4.0, 4.0, ()), "delta": _DELTA, "d": _DELAY},
            ("alpha",),
            EXACT["linear_limit"],
            lambda beta, delta, d: (max(abs(beta), abs(delta)) / (d + 0.5),),
        ),
        Checked(
            "is_stable",
            {
                "alpha": (0.0, 5.0, (1e-8,)),
                "beta": (-0.5, 2.5, ()),
                "gamma": (0.0, 1.0, (1e-8,)),
                "delta": (0.0, 1.0, (1e-8,)),
                "d": (0.0, 3.0, ()),
            },
            ("stable",),
            _stable,
            None,
            {
                "K = 4m/T^2 is taken for a limit; see rules:four-masses": _below(4),
                "K = 2m/T^2 is taken for a limit; see rules:two-masses": _below(2),
            },
            ("d",),
        ),
    )
}
CHECKED["discretize"] = CHECKED["eq14"]
