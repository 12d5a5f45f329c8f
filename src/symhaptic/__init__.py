"""Verified formulas for haptic control.

Derives, checks and typesets the formulas of *Passivity and Stability Boundaries for Haptic
Systems with Time Delay* (Hulin, Albu-Schaeffer, Hirzinger, 2014).  Importing the package loads
nothing symbolic; each name loads what it needs when it is first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from symhaptic.formulas import Formula, formula
    from symhaptic.proof.decide import prove
    from symhaptic.proof.verdict import Verdict

__version__ = "0.1.0"

_HOME = {
    "Formula": "symhaptic.formulas",
    "formula": "symhaptic.formulas",
    "prove": "symhaptic.proof.decide",
    "Verdict": "symhaptic.proof.verdict",
}

__all__ = ["Formula", "Verdict", "formula", "prove"]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'symhaptic' has no attribute {name!r}")
    value = getattr(import_module(_HOME[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
