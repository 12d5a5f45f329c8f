"""The claims of Sec. VI and the slips of the text."""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import T, b, k, k_H, m, omega
from symhaptic.notation.proposition import ForAll, Proposition, both, implied
from symhaptic.paper.propositions.comparison import ABOUT, DAMPED, SWINGS
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed


@claims("s6-human-10000")
def _springs_against_arms(printed: Printed) -> Proposition:
    """A spring that swings with the Nyquist frequency has about 10000 times an arm's stiffness."""
    swings = SWINGS.at({omega: sp.pi / T})
    about = [ABOUT[0] * 10000 * k_H <= k, k <= ABOUT[1] * 10000 * k_H]
    given = [m > 0, T > 0, k_H > 0, *DAMPED, swings]
    return ForAll((m, b, k, k_H, T), implied(given, both(about)))
