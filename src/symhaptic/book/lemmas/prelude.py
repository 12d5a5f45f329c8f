"""What most lemmas use: symbols, propositions, the kernel's rules and the tactics above them."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, partial
from pathlib import Path
from typing import Any, TypeAlias

import sympy as sp
from sympy import (
    Abs,
    Add,
    Eq,
    Expr,
    Function,
    I,
    Integer,
    Ne,
    Poly,
    Rational,
    S,
    Symbol,
    cos,
    cosh,
    cot,
    diff,
    exp,
    expand,
    eye,
    pi,
    sin,
    sinh,
    sqrt,
    symbols,
    tan,
)

from symhaptic.model import boundary, fractional, passivity, plant
from symhaptic.model.circle import expanded
from symhaptic.model.parts import FULL, Parts
from symhaptic.model.passivity import mirror, on_circle, real_part
from symhaptic.model.plant import Plant, Sampled
from symhaptic.notation import (
    B,
    F,
    K,
    N,
    Omega,
    T,
    X,
    a,
    alpha,
    b,
    b_D,
    b_H,
    beta,
    c,
    c_1,
    c_2,
    c_3,
    d,
    delta,
    e,
    epsilon,
    gamma,
    h,
    k,
    k_H,
    kappa,
    l,
    m,
    m_0,
    m_1,
    m_2,
    m_D,
    m_H,
    n_0,
    n_1,
    nu,
    omega,
    p_k,
    phi,
    psi,
    r,
    s,
    s_1,
    s_2,
    t,
    t_d,
    tau,
    theta,
    u,
    v,
    w,
    x,
    y,
    z,
)
from symhaptic.notation.proposition import (
    And,
    Exists,
    ForAll,
    Iff,
    Implies,
    Not,
    Or,
    Predicate,
    Proposition,
    Relation,
    Terms,
    both,
    conjuncts,
    implied,
    negated,
    proposition,
    whole,
)
from symhaptic.paper import STATEMENTS
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.prelude import transcribed
from symhaptic.paper.ranges import DAMPED, RANGES, STIFF
from symhaptic.paper.reading import read
from symhaptic.proof.derivative import derivative
from symhaptic.proof.theorems.analysis import above_its_start, in_the_limit, increases, induction
from symhaptic.proof.theorems.definitions import gains
from symhaptic.proof.theorems.familiar import (
    axiom,
    both_ways,
    bounded,
    decided,
    device_at_rest,
    device_comes_to_rest,
    device_exists,
    device_static,
    full_turns,
    held_steady_state,
    loop_late,
    loop_of_device,
    magnitude,
    not_negative,
    of_device,
    ordered,
    rising,
    sign_of,
    square,
    strictly,
    with_rest,
)
from symhaptic.proof.theorems.judge import Case, taken_apart
from symhaptic.proof.theorems.kernel import (
    NotShown,
    Theorem,
    add_assum,
    assume,
    choose,
    conj,
    conjunct,
    contr,
    disch,
    disj,
    disj_cases,
    exists,
    gen,
    inst,
    mp,
    not_intro,
    prove_hyp,
    relation,
    subst,
    undisch,
)
from symhaptic.proof.theorems.leaves import (
    combined,
    factor,
    identity,
    is_whole,
    mirrored,
    number,
    on_plants,
    root_outside,
    roots_inside,
    tends,
)
from symhaptic.proof.theorems.positivity import (
    Given,
    difference,
    load_certificates,
    nlinarith,
    show,
)
from symhaptic.proof.theorems.roots import (
    all_inside,
    first_minors,
    jury,
    last_coefficient,
    outpaces,
    roots_stay,
    zero_on_circle,
)
from symhaptic.proof.theorems.tactics import (
    as_claimed,
    at,
    by_contradiction,
    by_multiple,
    chained,
    closed,
    counterexample,
    denied,
    denied_by,
    either_way,
    every,
    example,
    fact,
    follows,
    for_all,
    none_of,
    not_all,
    one,
    over,
    positive,
    reductio,
    sine_of_half,
    zero_beyond,
)

load_certificates(Path(__file__).with_name("certificates.json"))

HALF = Rational(1, 2)
INSIDE = (theta > 0, theta < pi)
"""The angles of the upper half of the circle."""
NUMBERS = (n_1, n_0, a, e)
DEVICE = Predicate("device", (), (gamma, delta, *NUMBERS))
"""A device in units of its mass and of the period, and the numbers of it that is sampled."""
LATER_WHOLE = tuple(is_whole(d + n, assume(whole(d))) for n in (1, 2, 3))
"""d + 1, d + 2 and d + 3 are whole if d is."""


def by_zeros(*wall: Any) -> Theorem:
    """stable <=> all zeros of z^(d+1) A + N W inside; of alpha, beta, gamma, delta, a whole d."""
    readings = loop_of_device(NUMBERS, wall)
    return conjunct(readings, readings.conclusion.parts[1])


def zeros_of_stable(*wall: Any) -> Theorem:
    """All these zeros lie inside, of a wall that is stable."""
    loop = by_zeros(*wall)
    return mp(loop, assume(loop.conclusion.parts[0]))


def of_every_plant(theorem: Theorem) -> Theorem:
    """What does not speak of the plant's numbers holds without them."""
    return choose(device_exists(gamma, delta, NUMBERS), theorem)


def numbers_known(theorem: Theorem) -> Theorem:
    """Without the hypotheses that have no symbols."""
    return closed(theorem, *(fact(p) for p in theorem.hypotheses if not p.free))


def not_zero(theorem: Theorem) -> Theorem:
    """e != 0 from 0 < e."""
    return positive(Relation(relation(theorem).right, "!=", S.Zero), [theorem])
