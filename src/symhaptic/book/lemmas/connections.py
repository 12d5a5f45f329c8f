"""Systems side by side and fed back to each other are passive if each of them is."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from sympy import Eq, Expr, Ne

from symhaptic.book.lemmas.passive_is_stable import passive_is_stable
from symhaptic.book.lemmas.walls import damped, margins
from symhaptic.notation import alpha, gamma
from symhaptic.notation.proposition import Proposition, negated
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.systems import (
    CHAIN,
    KIND,
    LOOP,
    PARALLEL,
    PRODUCT,
    R_1,
    R_2,
    REAL,
    SIZE,
    X_1,
    connected,
)
from symhaptic.proof.theorems.familiar import square, strictly
from symhaptic.proof.theorems.kernel import (
    Theorem,
    absurd,
    anything,
    applied,
    assume,
    discharged,
    part,
)
from symhaptic.proof.theorems.leaves import combined
from symhaptic.proof.theorems.tactics import closed, fact, over, positive

NO_CHAIN = KIND < CHAIN
HELD = alpha + gamma > 0


@cache
def parallel() -> Theorem:
    """n = 1 => 0 <= R_1 + R_2."""
    return discharged(positive(REAL[PARALLEL] >= 0, [R_1 >= 0], [R_2 >= 0]), Eq(KIND, PARALLEL))


@cache
def fed_back() -> Theorem:
    """n = 2, 1 + Z_1 Z_2 != 0 => 0 <= Re Z_1/(1 + Z_1 Z_2)."""
    apart = assume(Ne(SIZE, 0))
    along, across = square(1 + PRODUCT[0]), square(PRODUCT[1])
    size = strictly(combined(SIZE >= 0, [along], [across]), apart)
    answer = R_1 + (R_1**2 + X_1**2) * R_2
    first, turned = [R_2 >= 0, square(R_1)], [R_2 >= 0, square(X_1)]
    found = over(REAL[LOOP] >= 0, positive(answer >= 0, [R_1 >= 0], first, turned), size)
    return discharged(closed(found, apart), Eq(KIND, LOOP), Ne(SIZE, 0))


def no_chain() -> Theorem:
    """n = 3 => anything, for n < 3."""
    never = combined(KIND >= CHAIN, [assume(Eq(KIND, CHAIN)), -1])
    claim = anything(absurd(assume(NO_CHAIN), never), REAL[CHAIN] >= 0)
    return discharged(claim, Eq(KIND, CHAIN))


@cache
def connected_is_passive() -> tuple[Theorem, ...]:
    """Side by side and fed back, 0 <= Re, for 0 <= R_1 and 0 <= R_2; of a chain nothing is said."""
    return parallel(), fed_back(), no_chain()


def negative(point: Mapping[Expr, Expr]) -> Theorem:
    """Not (n = 3 => 0 <= Re Z_1 Z_2), at a point where it is negative."""
    claim = connected(CHAIN).at(point)
    kind, real = claim.of  # type: ignore[attr-defined]
    below = fact(negated(real))
    return absurd(applied(assume(claim), fact(kind)), below, claim)


def passive_wall_is_stable(frequencies: Proposition) -> Theorem:
    """A wall that does not pull and meets (5) is stable if it or the spring holds the device."""
    found = closed(part(passive_is_stable(), STABLE), margins(frequencies))
    return closed(found, damped(frequencies))
