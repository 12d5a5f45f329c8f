r"""What can be swept: functions of arrays, with the units and the meaning of all that they know.

Without units as in the paper, :math:`\alpha=KT^2/m`, :math:`\beta=BT/m`, :math:`\gamma=kT^2/m`,
:math:`\delta=bT/m`, :math:`d=t_d/T`; for a scene the same in N/m, Ns/m, kg and s.
"""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from symhaptic.notation import SYMBOLS
from symhaptic.notation.quantities import decimal, nearest, shown
from symhaptic.notation.suggest import suggested
from symhaptic.notation.units import said, spelled
from symhaptic.scene.arms import ROTARY, UNITS, Arm, added
from symhaptic.scene.dimensionless import per_unit, units
from symhaptic.scene.scene import Scene
from symhaptic.sweeps.marks import mark


class Meaning(NamedTuple):
    """What a number is: its unit, as it is said, and as a formula."""

    unit: str
    says: str
    latex: str = ""

    @property
    def attributes(self) -> dict[str, str]:
        """As conventions have it: ``units``, ``long_name``, and the ``symbol``."""
        said = {"units": self.unit, "long_name": self.says, "symbol": self.latex}
        return {key: value for key, value in said.items() if value}


class Result(NamedTuple):
    """One of the numbers that a quantity gives."""

    name: str
    meaning: Meaning
    kind: type = float


class Quantity(NamedTuple):
    """A function of arrays: its module, its results, and the statement that it rests on."""

    home: str
    results: tuple[Result, ...]
    statement: str
    passive: bool = False
    """Whether it counts the device alone, (3), and not the arm that holds it."""


def _symbol(name: str, says: str = "") -> Meaning:
    known = SYMBOLS[name]
    return Meaning(known.unit, says or known.meaning, known.latex)


INPUTS: dict[str, Meaning] = {
    **{name: _symbol(name) for name in ("alpha", "beta", "gamma", "delta", "theta")},
    "delay": _symbol("d"),
}
"""Arguments without units."""

IN_SI: dict[str, Meaning] = {
    "K": _symbol("K"),
    "B": _symbol("B"),
    "mass": _symbol("m"),
    "inertia": Meaning("kg", "moment of inertia of the device", "J"),
    "sampling_period": _symbol("T"),
    "damping": _symbol("b"),
    "stiffness": _symbol("k"),
    "delay": _symbol("t_d"),
    "delay_samples": _symbol("d"),
    "frequency_hz": Meaning("Hz", "frequency of the oscillation", "f"),
}
"""Arguments of a scene and its walls; those of a rotary scene have other units, see below."""


def in_si(meaning: Meaning, rotary: bool) -> Meaning:
    """What a number of a scene is, with its unit for a rotary device if it is one."""
    own = ROTARY.get(spelled(meaning.unit)) if rotary else None
    return meaning if own is None else meaning._replace(unit=said(own))


_TRUE = Meaning("1", "whether all characteristic roots are inside the unit circle")
_STIFFEST = (
    Result("alpha", _symbol("alpha", "largest stable virtual stiffness, K T^2/m")),
    Result("beta", _symbol("beta", "its virtual damping, B T/m")),
    Result("theta", _symbol("theta", "angle at which the loop oscillates there, omega T")),
)
_SAFEST = (
    Result("alpha", _symbol("alpha", "largest passive virtual stiffness, K T^2/m")),
    Result("beta", _symbol("beta", "its virtual damping, B T/m")),
    Result("theta", _symbol("theta", "its worst angle, omega T")),
)
_EDGE = (Result("alpha", _symbol("alpha")), Result("beta", _symbol("beta")))
_MARGIN = Meaning("1", "physical damping minus the required damping of the wall, times T/m")
_ADDED = Meaning("1", "delay margin, in sampling periods")
_LONGEST = Meaning("1", "largest delay up to which the loop is stable, in sampling periods", "d")

QUANTITIES: dict[str, Quantity] = {
    "is_stable": Quantity("numeric.stability", (Result("is_stable", _TRUE, bool),), "eq18"),
    "unstable_roots": Quantity(
        "numeric.stability",
        (Result("unstable_roots", Meaning("1", "roots outside the unit circle"), int),),
        "eq18",
    ),
    "stability_boundary": Quantity("numeric.boundary", _EDGE, "fractional-boundary"),
    "max_stable_stiffness": Quantity(
        "numeric.tracing.extremes", _STIFFEST, "fractional-boundary"
    ),
    "limit_at": Quantity(
        "numeric.tracing.extremes", (_STIFFEST[0], _STIFFEST[2]), "fractional-boundary"
    ),
    "delay_margin": Quantity(
        "numeric.tracing.margin", (Result("delay_margin", _ADDED),), "delay-margin"
    ),
    "max_delay": Quantity(
        "numeric.tracing.margin", (Result("max_delay", _LONGEST),), "delay-margin"
    ),
    "is_passive": Quantity(
        "numeric.passivity",
        (Result("is_passive", Meaning("1", "whether no motion extracts energy"), bool),),
        "fractional-passivity",
        passive=True,
    ),
    "passivity_margin": Quantity(
        "numeric.passivity",
        (Result("passivity_margin", _MARGIN),),
        "fractional-passivity",
        passive=True,
    ),
    "passivity_margin_at": Quantity(
        "numeric.passivity", (Result("passivity_margin", _MARGIN),), "eq5", passive=True
    ),
    "passivity_boundary": Quantity("numeric.passivity", _EDGE, "eq27", passive=True),
    "max_passive_stiffness": Quantity("numeric.passivity", _SAFEST, "eq11", passive=True),
    "linear_limit": Quantity("numeric.linear", (_EDGE[0],), "eq25"),
    "discretize": Quantity(
        "numeric.plant", tuple(Result(n, _symbol(f"{n[0]}_{n[1]}" if n[1:] else n))
                               for n in ("n1", "n0", "a", "e")), "eq14",
    ),
}  # fmt: skip
"""By the names of the public functions."""

_SI: dict[str, tuple[str, Meaning]] = {
    "alpha": ("K", Meaning("N/m", "", "K")),
    "beta": ("B", Meaning("Ns/m", "", "B")),
    "theta": ("frequency_hz", Meaning("Hz", "frequency of the oscillation", "f")),
    "passivity_margin": (
        "passivity_margin",
        Meaning("Ns/m", "physical damping minus the required damping of the wall"),
    ),
    "delay_margin": ("delay_margin", Meaning("s", "delay margin")),
    "max_delay": ("max_delay", Meaning("s", "largest delay up to which the loop is stable", "t_d")),
}
"""What results are called for a scene; a meaning that stays loses its last words, the formula."""

_PARTS = {
    "alpha": ("K",), "beta": ("B",), "gamma": ("stiffness",), "delta": ("damping",),
    "theta": ("frequency_hz",),
}  # fmt: skip


@dataclass(frozen=True)
class Work:
    """A function of arrays by name that returns a tuple of results."""

    function: Callable[..., Any]
    arguments: tuple[str, ...]
    """The names of its arrays."""
    results: tuple[Result, ...]
    words: Mapping[str, Any]
    """What it is given besides."""
    says: str
    """The quantity's name."""
    statement: str = ""
    in_si: bool = False
    arm: Arm | None = None
    """The arm that is added to the device, for results that count it."""
    rotary: bool = False
    """Whether the device turns."""
    scene: Scene | None = None
    """A scene with parts beyond the paper's loop, which is asked itself."""

    @property
    def meanings(self) -> dict[str, Meaning]:
        """What its arguments are."""
        if not self.in_si:
            return INPUTS
        return {name: in_si(meaning, self.rotary) for name, meaning in IN_SI.items()}

    def __call__(self, **arrays: Any) -> tuple[Any, ...]:
        """The results for arrays that broadcast."""
        if not self.in_si:
            return self._plain(arrays)
        if self.scene is not None:
            return _asked(self.scene, self.says, arrays, [r.kind for r in self.results])
        arrays = {"mass" if n == "inertia" else n: values for n, values in arrays.items()}
        if self.arm is not None:
            arrays = {n: _together(self.arm, n, values) for n, values in arrays.items()}
        period, mass = arrays["sampling_period"], arrays["mass"]
        try:
            found = self._plain({n: _scaled(n, arrays) for n in self.own_arguments})
        except ValueError as wrong:
            name, _, said = str(wrong).partition(":")
            given = [p for p in _PARTS.get(name, ()) if p in arrays]
            raise ValueError(f"{given[0]}: {name} ={said}" if given else str(wrong)) from None
        unit_K, unit_B = units(mass, period)
        scale = {
            "K": unit_K,
            "B": unit_B,
            "frequency_hz": 1 / (2 * math.pi * period),
            "passivity_margin": unit_B,
            "delay_margin": period,
            "max_delay": period,
        }
        return tuple(
            value * scale[result.name] if result.name in scale else value
            for result, value in zip(self.results, found, strict=True)
        )

    @property
    def own_arguments(self) -> tuple[str, ...]:
        """The arguments of the function itself."""
        return tuple(n for n in inspect.signature(self.function).parameters if n in INPUTS)

    @property
    def body(self) -> str:
        """The mark of a function of the user's own."""
        return "" if self.results else mark(self.function)

    def _plain(self, arrays: Mapping[str, Any]) -> tuple[Any, ...]:
        found = self.function(**arrays, **self.words)
        return tuple(found) if isinstance(found, tuple) else (found,)


def _together(arm: Arm, name: str, values: Any) -> Any:
    """A mass, damping or stiffness of the device, with that of the arm."""
    if name not in UNITS:
        return values
    summed = np.frompyfunc(lambda own: own if math.isnan(own) else added(arm, name, own), 1, 1)
    return np.asarray(summed(values), dtype=np.float64)


def _scaled(name: str, si: Mapping[str, Any]) -> Any:
    """An argument without units; integer delays written in decimals stay whole."""
    period, mass = si["sampling_period"], si["mass"]
    if name == "delay":
        late = _periods(si["delay"], period) if "delay" in si else si["delay_samples"]
        return np.asarray(late, dtype=np.float64)
    (part,) = _PARTS[name]
    stiff, damped = per_unit(mass, period)
    scales = {
        "K": stiff, "stiffness": stiff, "B": damped, "damping": damped,
        "frequency_hz": 2 * math.pi * period,
    }  # fmt: skip
    return np.asarray(si[part] * scales[part])


def _in_periods(late: float, period: float) -> float:
    """A delay without units; NaN stays NaN."""
    return nearest(decimal(late) / decimal(period)) if not math.isnan(late) else late


_periods = np.frompyfunc(_in_periods, 2, 1)


def work_of(
    quantity: str | Callable[..., Any], axes: Mapping[str, Any], scene: Scene | None
) -> Work:
    """The quantity of this name, a public function, or a function of the user's own.

    What a public function takes besides its arrays goes to it as it is, and what is text to a
    function of the user's own.  Raises :class:`ValueError` for a name that is none, and for a
    scene with one's own function.
    """
    name = quantity if isinstance(quantity, str) else getattr(quantity, "__name__", "")
    if quantity == "max_stable_stiffness" and {"beta", "B"} & axes.keys():
        name = "limit_at"
    known = QUANTITIES.get(name)
    if known is not None:
        function = getattr(import_module(f"symhaptic.{known.home}"), name)
        if callable(quantity) and quantity is not function:
            known = None
    if known is None:
        words = {n: v for n, v in axes.items() if isinstance(v, str)}
        return _own(quantity, words, scene is not None)
    takes = inspect.signature(function).parameters
    needed = tuple(n for n in takes if n in INPUTS)
    words = {n: v for n, v in axes.items() if n in takes and n not in INPUTS}
    if scene is None:
        needed = tuple(n for n in needed if n in axes or takes[n].default is takes[n].empty)
        return Work(function, needed, known.results, words, name, known.statement)
    parts = [p for n in needed for p in _PARTS.get(n, (n,))]
    results = tuple(_in_si(r, scene.rotary) for r in known.results)
    all_parts = (*parts, "inertia" if scene.rotary else "mass", "sampling_period")
    arm = None if known.passive else scene.arm
    own = None
    if scene.further:
        own = scene
        if name not in _ASKED:
            raise ValueError(
                f"quantity: {name} is not available for a scene with {scene.further[0]}; "
                f"give one of {', '.join(_ASKED)}"
            )
    return Work(
        function, all_parts, results, words, name, known.statement, True, arm, scene.rotary, own
    )


_ASKED: dict[str, Callable[[Scene, Mapping[str, Any]], Any]] = {
    "is_stable": lambda scene, at: scene.is_stable(at["K"], at["B"]),
    "is_passive": lambda scene, at: scene.is_passive(at["K"], at["B"]),
    "passivity_margin": lambda scene, at: scene.passivity_margin(at["K"], at["B"]),
    "delay_margin": lambda scene, at: scene.delay_margin(at["K"], at["B"]),
    "max_delay": lambda scene, at: scene.max_delay(at["K"], at["B"]),
    "stability_boundary": lambda scene, at: scene.stability_boundary(at["frequency_hz"]),
    "limit_at": lambda scene, at: scene.limit_at(at["B"])[::2],
    "max_stable_stiffness": lambda scene, at: _one(scene.max_stable_stiffness()),
    "max_passive_stiffness": lambda scene, at: _one(scene.max_passive_stiffness()),
}
"""What a scene with further parts answers, for arrays of walls."""

_WALL = ("K", "B", "frequency_hz")


def _one(found: Any) -> tuple[float, float, float]:
    return found.K, found.B, found.frequency_hz


def _asked(
    scene: Scene, name: str, arrays: Mapping[str, Any], kinds: list[type]
) -> tuple[Any, ...]:
    """The answers of each device, period and delay among the arrays to its walls.

    Where an argument is NaN the result is NaN, or no.
    """
    each = dict(zip(arrays, np.broadcast_arrays(*arrays.values()), strict=True))
    shape = next(iter(each.values())).shape
    flat = {n: np.asarray(values, dtype=np.float64).ravel() for n, values in each.items()}
    size = next(iter(flat.values())).size
    found = [
        np.full(size, False if kind is bool else np.nan) for kind in kinds
    ]  # NaN is not stable
    known = np.flatnonzero(~np.isnan(np.stack(list(flat.values()))).any(axis=0))
    devices = [n for n in flat if n not in _WALL]
    different, which = np.unique(
        np.stack([flat[n][known] for n in devices], axis=1), axis=0, return_inverse=True
    )
    for row, numbers in enumerate(different):
        here = known[which.ravel() == row]
        own: dict[str, Any] = dict(zip(devices, map(float, numbers), strict=True))
        if {"delay", "delay_samples"} & own.keys():
            own = {"delay": None, "delay_samples": None, **own}
        own |= {n: None for n in _MAY_LACK if own.get(n) == 0}
        told = _ASKED[name](replace(scene, **own), {n: flat[n][here] for n in _WALL if n in flat})
        rows = told if isinstance(told, tuple) else (told,)
        for n, values in enumerate(rows):
            found[n][here] = values
    return tuple(values.reshape(shape) for values in found)


_MAY_LACK = ("damping", "stiffness", "delay", "delay_samples")
"""Parts that a scene may be without; 0 says so here."""


def _in_si(result: Result, rotary: bool) -> Result:
    name, meaning = _SI.get(result.name, (result.name, result.meaning))
    says = meaning.says or result.meaning.says.split(",")[0]
    return Result(name, in_si(meaning._replace(says=says), rotary), result.kind)


def _own(quantity: Any, words: Mapping[str, Any], in_si: bool) -> Work:
    if not callable(quantity):
        allowed = (
            suggested(quantity, QUANTITIES) if isinstance(quantity, str) else "give a function"
        )
        raise ValueError(f"quantity: {shown(quantity)} is not allowed; {allowed}")
    if in_si:
        raise ValueError(
            f"scene: your function {shown(quantity)} takes no scene; give one of "
            f"{', '.join(QUANTITIES)}"
        )
    names = [n for n in inspect.signature(quantity).parameters if n not in words]
    name = getattr(quantity, "__name__", "quantity")
    return Work(quantity, tuple(names), (), dict(words), name)
