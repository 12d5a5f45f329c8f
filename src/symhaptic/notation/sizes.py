"""How large and how small numbers may be that floats of double precision compute with."""

LARGEST = 1e70
"""Fourth powers of such numbers are floats: no sum or product of the formulas overflows."""

STIFFEST = 1e15
"""Of a stiffer plant a float64 does not tell how far it swings in a period."""

LONGEST = 1e15
"""Delays beyond have no fractions of a period in float64."""

FAINT = 2.0**-400
"""Squares of such numbers are floats with all of their digits; of a wall and a damping that are
smaller together, none is seen to lead."""
