"""What the routines are written with."""

import sympy as sp
from sympy import (
    Abs,
    And,
    Eq,
    Expr,
    Max,
    Min,
    Ne,
    Not,
    Or,
    Rational,
    S,
    Symbol,
    atan2,
    binomial,
    cos,
    exp,
    factorial,
    floor,
    pi,
    sin,
    sqrt,
    tan,
)
from sympy.codegen.cfunctions import expm1

from symhaptic.export.notation import Pair, Steps, do, pick, routine
from symhaptic.export.routine import Search, TwoProdError, choose
