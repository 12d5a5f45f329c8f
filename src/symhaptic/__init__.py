"""Verified formulas for haptic control.

Derives, checks and typesets the formulas of *Passivity and Stability Boundaries for Haptic
Systems with Time Delay* (Hulin, Albu-Schaeffer, Hirzinger, 2014).  Importing the package loads
nothing symbolic; each name loads what it needs when it is first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from symhaptic.version import __version__ as __version__

if TYPE_CHECKING:
    from symhaptic.book.formulas import Formula, formula
    from symhaptic.loops.actuator import Lag
    from symhaptic.loops.oversampled import Oversampled
    from symhaptic.loops.sensor import Encoder
    from symhaptic.loops.structure import Coupling, SecondMass
    from symhaptic.loops.system import LinearDevice
    from symhaptic.loops.velocity import Average, Difference, Filter, LowPass, Measured, Window
    from symhaptic.model.jury import jury
    from symhaptic.numeric.boundary import stability_boundary
    from symhaptic.numeric.compiled import show_config
    from symhaptic.numeric.extremum import Extremum
    from symhaptic.numeric.linear import linear_limit
    from symhaptic.numeric.passivity import (
        is_passive,
        max_passive_stiffness,
        passivity_boundary,
        passivity_margin,
        passivity_margin_at,
    )
    from symhaptic.numeric.plant import discretize, discretize_fractional
    from symhaptic.numeric.stability import characteristic_polynomial, is_stable, unstable_roots
    from symhaptic.numeric.tracing.extremes import limit_at, max_stable_stiffness
    from symhaptic.numeric.tracing.grid import grid_boundary
    from symhaptic.numeric.tracing.margin import delay_margin, max_delay
    from symhaptic.numeric.tracing.region import Region, stable_region
    from symhaptic.numeric.tracing.robust import robust_region
    from symhaptic.proof.enclose import enclose, enclose_maximum
    from symhaptic.proof.prove import prove
    from symhaptic.proof.recheck import recheck
    from symhaptic.proof.verdict import Verdict
    from symhaptic.scene.arms import Arm, ArmRange
    from symhaptic.scene.callables import lambdify
    from symhaptic.scene.scene import Scene
    from symhaptic.sweeps.sweep import sweep


_HOME = {
    "Arm": "symhaptic.scene.arms",
    "ArmRange": "symhaptic.scene.arms",
    "Average": "symhaptic.loops.velocity",
    "Coupling": "symhaptic.loops.structure",
    "Difference": "symhaptic.loops.velocity",
    "Encoder": "symhaptic.loops.sensor",
    "Extremum": "symhaptic.numeric.extremum",
    "Filter": "symhaptic.loops.velocity",
    "Formula": "symhaptic.book.formulas",
    "Lag": "symhaptic.loops.actuator",
    "LinearDevice": "symhaptic.loops.system",
    "LowPass": "symhaptic.loops.velocity",
    "Measured": "symhaptic.loops.velocity",
    "Oversampled": "symhaptic.loops.oversampled",
    "Region": "symhaptic.numeric.tracing.region",
    "Scene": "symhaptic.scene.scene",
    "SecondMass": "symhaptic.loops.structure",
    "Verdict": "symhaptic.proof.verdict",
    "Window": "symhaptic.loops.velocity",
    "characteristic_polynomial": "symhaptic.numeric.stability",
    "delay_margin": "symhaptic.numeric.tracing.margin",
    "discretize": "symhaptic.numeric.plant",
    "discretize_fractional": "symhaptic.numeric.plant",
    "enclose": "symhaptic.proof.enclose",
    "enclose_maximum": "symhaptic.proof.enclose",
    "formula": "symhaptic.book.formulas",
    "grid_boundary": "symhaptic.numeric.tracing.grid",
    "is_passive": "symhaptic.numeric.passivity",
    "is_stable": "symhaptic.numeric.stability",
    "jury": "symhaptic.model.jury",
    "lambdify": "symhaptic.scene.callables",
    "limit_at": "symhaptic.numeric.tracing.extremes",
    "linear_limit": "symhaptic.numeric.linear",
    "max_delay": "symhaptic.numeric.tracing.margin",
    "max_passive_stiffness": "symhaptic.numeric.passivity",
    "max_stable_stiffness": "symhaptic.numeric.tracing.extremes",
    "passivity_boundary": "symhaptic.numeric.passivity",
    "passivity_margin": "symhaptic.numeric.passivity",
    "passivity_margin_at": "symhaptic.numeric.passivity",
    "prove": "symhaptic.proof.prove",
    "recheck": "symhaptic.proof.recheck",
    "robust_region": "symhaptic.numeric.tracing.robust",
    "show_config": "symhaptic.numeric.compiled",
    "stability_boundary": "symhaptic.numeric.boundary",
    "stable_region": "symhaptic.numeric.tracing.region",
    "sweep": "symhaptic.sweeps.sweep",
    "unstable_roots": "symhaptic.numeric.stability",
}

__all__ = [
    "Arm",
    "ArmRange",
    "Average",
    "Coupling",
    "Difference",
    "Encoder",
    "Extremum",
    "Filter",
    "Formula",
    "Lag",
    "LinearDevice",
    "LowPass",
    "Measured",
    "Oversampled",
    "Region",
    "Scene",
    "SecondMass",
    "Verdict",
    "Window",
    "characteristic_polynomial",
    "delay_margin",
    "discretize",
    "discretize_fractional",
    "enclose",
    "enclose_maximum",
    "formula",
    "grid_boundary",
    "is_passive",
    "is_stable",
    "jury",
    "lambdify",
    "limit_at",
    "linear_limit",
    "max_delay",
    "max_passive_stiffness",
    "max_stable_stiffness",
    "passivity_boundary",
    "passivity_margin",
    "passivity_margin_at",
    "prove",
    "recheck",
    "robust_region",
    "show_config",
    "stability_boundary",
    "stable_region",
    "sweep",
    "unstable_roots",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'symhaptic' has no attribute {name!r}")
    value = getattr(import_module(_HOME[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
