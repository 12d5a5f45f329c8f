"""What most claims of the paper use: symbols, propositions and their registry."""

from collections.abc import Callable, Sequence

from sympy import Expr, Rational, S, Symbol, pi

from symhaptic.notation import (
    B,
    K,
    T,
    a,
    alpha,
    b,
    b_D,
    b_H,
    beta,
    d,
    delta,
    e,
    gamma,
    k,
    k_H,
    l,
    m,
    m_D,
    m_H,
    n_0,
    n_1,
    omega,
    omega_hat,
    s,
    t_d,
    theta,
    v,
    w,
    z,
)
from symhaptic.notation.proposition import (
    Exists,
    ForAll,
    Iff,
    Not,
    Or,
    Predicate,
    Proposition,
    Relation,
    both,
    implied,
    proposition,
)
from symhaptic.paper import STATEMENTS
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.ranges import STIFF
from symhaptic.paper.reading import Printed


def transcribed(id: str) -> Printed:
    """Return another equation of the paper, as published."""
    return STATEMENTS[id].printed
