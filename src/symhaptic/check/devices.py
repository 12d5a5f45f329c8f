"""What can be checked of one device and its loop, with all parts: functions of walls in SI units.

The values are those of the package's engine, with the errors that it states: verdicts of walls
farther from a boundary than 1e-9 of K + B/T, and boundaries to 1e-11 of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from flint import arb

from symhaptic.check.checked import Argument, Checked, Point
from symhaptic.scene.scene import Scene
from symhaptic.scene.walls import why_not_passive

_NEAR = 1e-9
"""Distance from a boundary in parts of K + B/T within which no verdict is compared."""

_BOUNDARY, _LIMIT = 1e-11, 1e-10
"""Errors of a boundary and of a limit, in parts of K + B/T."""

_MORE = 1.5, 2.25
"""Multiples of the stiffness and the damping of the stiffest wall that are ordinary."""


def known(scene: Scene | None) -> dict[str, Checked]:
    """What can be checked: of a scene, or without one of the paper."""
    from symhaptic.check.formulas import CHECKED

    return CHECKED if scene is None else of_device(scene)


def of_device(scene: Scene) -> dict[str, Checked]:
    """What can be checked of a scene, by name."""
    period = scene.sampling_period
    stiffest = scene.max_stable_stiffness()
    unit = scene.limit(1.0, 1.0, 1.0)
    K, B = (
        float(value) if value > 0 else other
        for value, other in ((stiffest.K, unit.K), (stiffest.B, unit.B))
    )
    arguments = {
        "K": Argument(0.0, _MORE[0] * K, 1e-6 * K, 1e3 * K, (0.0, K), signed=True),
        "B": Argument(0.0, _MORE[1] * B, 1e-6 * B, 1e3 * B, (0.0, B), signed=True),
        "frequency_hz": Argument(
            1e-3 / period, 0.49 / period, 1e-4 / period, 0.499 / period, (0.25 / period,),
            top=0.5 / period,
        ),
    }  # fmt: skip

    def size(K: Any, B: Any) -> Any:
        return abs(K) + abs(B) / period + (scene.coupled.stiffness or 0.0)

    def checked(
        name: str,
        names: str,
        results: tuple[str, ...],
        values: Callable[[Scene], Callable[..., tuple[Any, ...]]],
        **more: Any,
    ) -> Checked:
        return Checked(
            f"device.{name}",
            {each: arguments[each] for each in names.split()},
            results,
            near=values(scene),
            variants=tuple((said, values(other)) for said, other in _simpler(scene)),
            precisions=1,
            **more,
        )

    def verdict(told: Callable[..., Any]) -> Callable[[float, float], tuple[bool | None]]:
        """A verdict that walls next to this one share."""

        def exact(K: float, B: float) -> tuple[bool | None]:
            off = _NEAR / 2 * size(K, B) * np.array([0.0, 1.0, -1.0, 0.0, 0.0])
            found = told(K + off, B + period * np.roll(off, 2))
            return (bool(found[0]) if found.all() == found.any() else None,)

        return exact

    def boundary(frequency: float) -> tuple[arb, arb]:
        K, B = map(float, scene.stability_boundary(frequency))
        off = _BOUNDARY * size(K, B)
        return arb(K, off), arb(B, off * period)

    def boundary_sizes(frequency: Any) -> tuple[Any, Any]:
        both = size(*scene.stability_boundary(frequency))
        return both, both * period

    def limit(B: float) -> tuple[arb]:
        K = float(scene.limit_at(B).K)
        return (arb(K, _LIMIT * size(K, B)),)

    def beside_curve(dice: Any, by: float, *wall: float) -> list[Point]:
        near = scene.stability_boundary(dice.uniform(0.02, 0.9) * 0.5 / period)
        return [tuple(float(x) * (1 + s) for x in near) for s in (-by, by)]

    def beside_passive(dice: Any, by: float, *wall: float) -> list[Point]:
        B = float(wall[1])
        K = float(scene.max_passive_stiffness(B=B))
        return [(K * (1 + s), B) for s in (-by, by)] if K > 0 else []

    found = {
        "is_stable": checked(
            "is_stable", "K B", ("stable",), lambda of: lambda K, B: (of.is_stable(K, B),),
            exact=verdict(scene.is_stable), border=beside_curve, nearest=_NEAR,
        ),
        "limit_at": checked(
            "limit_at", "B", ("K",), lambda of: lambda B: (of.limit_at(B).K,),
            exact=limit, scale=lambda B: (size(scene.limit_at(B).K, B),), balls=200,
            open=("dampings at which no wall is stable",),
        ),
        "stability_boundary": checked(
            "stability_boundary", "frequency_hz", ("K", "B"), lambda of: of.stability_boundary,
            exact=boundary, scale=boundary_sizes,
        ),
    }  # fmt: skip
    if scene.damping and not why_not_passive(scene):
        found["is_passive"] = checked(
            "is_passive", "K B", ("passive",), lambda of: lambda K, B: (of.is_passive(K, B),),
            exact=verdict(scene.is_passive), border=beside_passive, nearest=_NEAR, balls=300,
        )  # fmt: skip
    return found


def _simpler(scene: Scene) -> Iterator[tuple[str, Scene]]:
    """The scene without one of its parts, of which somebody may not have thought."""
    for name in ("arm", "delay", "delay_samples", *scene.further):
        value = getattr(scene, name)
        if value is not None and name != "dynamics":
            without: dict[str, Any] = {name: "hold" if name == "integrator" else None}
            yield f"without {name} the loop gives these results", replace(scene, **without)
