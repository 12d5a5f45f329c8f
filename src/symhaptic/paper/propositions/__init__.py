"""The claim of each statement, as a proposition about the published form.

A claim is a function of the published form, so that a changed form gives a changed claim. Where the
paper names no domain, a claim is for all values for which its symbols make sense (Sec. II): T, m >
0, b, k, d >= 0, and K and B real. There is one file for each section of the paper.
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
