"""Which parts of a loop must be modelled: the smallest model with a proved bound of its error."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Literal, NamedTuple, TypeAlias

from symhaptic.bounds.simplest.at_damping import at_damping, error_of_line
from symhaptic.bounds.simplest.cost import Cost, Model, cost, error
from symhaptic.bounds.simplest.max_stiffness import stiffest
from symhaptic.bounds.simplest.plants import NOTHING, Box, Interval, NotCovered
from symhaptic.model.parts import Parts
from symhaptic.notation.quantities import decimal, in_unit, number

Range: TypeAlias = float | tuple[float, float]
"""One number, or the lowest and the highest."""

LINEAR, FULL = "linear limit", "full"
LONGEST = 10
"""With a given virtual damping the boundary is a polynomial of this degree and two more."""

WITHOUT = {"stiffness": 0, "damping": 1}
"""The parts that may be left out, and their intervals."""


class Loop(NamedTuple):
    """A loop in SI units; what is ``None`` is not there.  ``mass`` may be a moment of inertia."""

    parts: Parts
    periods: Fraction
    """The delay in sampling periods."""
    sampling_period: float
    mass: float
    stiffness: float | None
    damping: float | None
    unit: Callable[[str], str] = str
    """The unit that takes the place of one for motion along a line."""


@dataclass(frozen=True)
class Simplest:
    """The smallest model that is proved to be good enough, and what each model costs."""

    model: Parts | Literal["linear"]
    """The parts to model, or the linear limit."""
    name: str
    error_bound: float
    """No relative error of its stiffness limit is larger anywhere in the range."""
    costs: Mapping[str, float]
    """This bound for each model, the smallest first; infinite where nothing is proved."""
    reasons: Mapping[str, str]
    """Why nothing is proved."""

    def __str__(self) -> str:
        """One line for each model."""
        lines = []
        for name, bound in self.costs.items():
            says = self.reasons.get(name) or ("exact" if bound == 0 else f"below {_up(bound)}")
            lines.append(f"{'*' if name == self.name else ' '} {name}: {says}")
        return "\n".join(lines)


_LEADING = 8
"""Bounds of more places behind the point are written with a power of ten."""


def _up(bound: float) -> str:
    """A bound in per cent of three digits, rounded up.

    >>> _up(0.00041651), _up(5e-324)
    ('0.0417 %', '4.95e-322 %')
    """
    places = max(0, 2 - math.floor(math.log10(100 * bound)))
    digits = math.ceil(100 * Fraction(bound) * 10**places)
    if places > _LEADING:
        return f"{digits / 100:.2f}e-{places - 2} %"
    return f"{digits / 10**places:.{places}f} %"


def simplest(loop: Loop, rtol: float, over: Mapping[str, Range | None]) -> Simplest:
    """What :meth:`symhaptic.scene.scene.Scene.simplest` returns."""
    if isinstance(rtol, str):
        raise ValueError(f"rtol: {rtol!r} is not allowed; give finite numbers > 0")
    _real("rtol", rtol, "", "> 0")
    given = {name: value for name, value in over.items() if value is not None}
    ranges = {
        name: _interval(name, value, loop.unit(_UNITS[name])) for name, value in given.items()
    }
    box, there = _box(loop, ranges)
    parts = replace(loop.parts, **{name: there[name] for name in WITHOUT})
    delay = loop.periods
    models = _models(parts)
    costs = dict.fromkeys(models, math.inf) | {FULL: 0.0}
    reasons: dict[str, str] = {}
    for name in [name for name in models if name != FULL]:
        try:
            least, costs[name] = _cost(box, models[name], delay, there, rtol)
        except NotCovered as why:
            reasons[name] = f"not proved: {why}"
        else:
            if costs[name] == math.inf:
                reasons[name] = f"no bound found, and at one point {100 * least:.3g} %"
    best = next(name for name, bound in costs.items() if bound < rtol)
    return Simplest(models[best], best, costs[best], costs, reasons)


def _models(parts: Parts) -> dict[str, Parts | Literal["linear"]]:
    """All models of a loop, the smallest first."""
    here = [name for name in WITHOUT if getattr(parts, name)]
    models: dict[str, Parts | Literal["linear"]] = {LINEAR: "linear"}
    if len(here) == len(WITHOUT):
        models["without stiffness and damping"] = parts.without(here[0]).without(here[1])
    models |= {f"without {name}": parts.without(name) for name in here}
    return {**models, FULL: parts}


def _cost(
    box: Box,
    kept: Parts | Literal["linear"],
    delay: Fraction,
    there: Mapping[str, bool],
    rtol: float,
) -> Cost:
    if delay.denominator != 1:
        raise NotCovered(f"a delay of {float(delay):.6g} periods is not whole")
    periods = int(delay)
    if not there["B"]:
        if kept == "linear":
            raise NotCovered("it has no largest stiffness, but grows with B; give B")
        whole, box = stiffest(periods), box[:2]
    elif periods > LONGEST:
        raise NotCovered(f"with a given B, delays up to {LONGEST} periods are covered")
    else:
        whole = at_damping(periods)
    if kept == "linear":
        return cost(error_of_line(periods), box, rtol)
    out = [i for name, i in WITHOUT.items() if there[name] and not getattr(kept, name)]
    return cost(error(whole, Model(whole, out)), box, rtol)


def _box(loop: Loop, ranges: Mapping[str, Interval]) -> tuple[Box, dict[str, bool]]:
    """Intervals of gamma, delta and beta that cover the range, and which of them are there."""
    period = decimal(loop.sampling_period)
    mass = ranges.get("mass") or ranges.get("inertia") or _point(loop.mass)
    box, there = [], {}
    for name, power in (("stiffness", 2), ("damping", 1), ("B", 1)):
        value = getattr(loop, name, None)
        inside = ranges.get(name) or (None if value is None else _point(value))
        there[name] = inside is not None
        ends = [end * period**power / m for end in inside or NOTHING for m in mass]
        box.append(Interval(min(ends), max(ends)))
    return tuple(box), there


def _point(value: float) -> Interval:
    return Interval(decimal(value), decimal(value))


def _interval(name: str, value: Range, unit: str) -> Interval:
    """A range as an argument gives it."""
    ends = value if isinstance(value, tuple) else (value, value)
    if len(ends) != 2:
        raise ValueError(f"{name}: {value!r} is not allowed; give a number or (lowest, highest)")
    least = {"mass": "> 0", "inertia": "> 0", "B": ""}.get(name, ">= 0")
    low, high = (_real(name, end, unit, least) for end in ends)
    if low > high:
        raise ValueError(f"{name}: {value!r} is not allowed; give (lowest, highest)")
    return Interval(low, high)


_UNITS = {"mass": "kg", "inertia": "kg", "stiffness": "N/m", "damping": "N*s/m", "B": "N*s/m"}


def _real(name: str, value: Any, unit: str, least: str) -> Fraction:
    """A finite number, in its range; text and quantities of Pint are converted."""
    number(name, value, unit, least)
    return decimal(in_unit(name, value, unit))
