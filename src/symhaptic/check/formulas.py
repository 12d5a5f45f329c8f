"""All that can be checked, by its name: the package's functions and the paper's equations."""

from __future__ import annotations

from dataclasses import replace

from symhaptic.check.checked import Checked
from symhaptic.check.equations import EQUATIONS
from symhaptic.check.functions import FUNCTIONS

_ALSO = {
    "eq14": "discretize",
    "eq18": "characteristic_polynomial",
    "eq25": "linear_limit",
    "eq27": "passivity_boundary",
}
"""Equations of the paper that a function computes."""

CHECKED: dict[str, Checked] = {c.id: c for c in (*EQUATIONS, *FUNCTIONS)}
CHECKED |= {id: replace(CHECKED[name], id=id) for id, name in _ALSO.items()}
