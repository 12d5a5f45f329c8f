"""The arms and devices of the paper's (23): 0 <= gamma <= 0.001, 0 <= delta <= 0.02."""

from sympy import Rational, S

from symhaptic.notation import delta, gamma

STIFF = Rational(1, 1000)
"""The largest gamma."""

DAMPED = Rational(1, 50)
"""The largest delta."""

RANGES = {gamma: (S.Zero, STIFF), delta: (S.Zero, DAMPED)}
"""Both parameters with the ends of their ranges."""
