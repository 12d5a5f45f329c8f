"""What each statement claims, as a proposition of what is printed.

A claim is stated once, of the printed form that it is given: another print makes another claim.
Where the paper names no domain, all values are meant for which its symbols make sense (Sec. II):
T, m > 0, b, k, d >= 0, and K and B real.  One file a section of the paper.
"""

from __future__ import annotations

from symhaptic.paper.propositions import (  # noqa: F401  (each registers its claims)
    areas,
    arm,
    comparison,
    conclusion,
    device,
    far_higher,
    linear,
    linear_error,
    one_delta,
    passivity,
    plots,
    ratio,
    robust,
    slips,
    stability,
    systems,
)
from symhaptic.paper.propositions.registry import CLAIMED, Claim

__all__ = ["CLAIMED", "Claim"]
