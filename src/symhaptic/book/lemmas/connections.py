"""Systems side by side and fed back to each other are passive if each of them is."""

from symhaptic.book.lemmas.late_passive_is_stable import late_passive_is_stable
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.comparison import LOOP, PASSIVE_WALL
from symhaptic.paper.propositions.systems import (
    CHAIN,
    FED_BACK,
    KIND,
    PARALLEL,
    PRODUCT,
    R_1,
    R_2,
    REAL,
    SIZE,
    X_1,
    connected,
)
from symhaptic.proof.theorems.definitions import loop

NO_CHAIN = KIND < CHAIN
HELD = alpha + gamma > 0
DAMPED_DEVICE = delta > 0


@cache
def parallel() -> Theorem:
    """n = 1 => 0 <= R_1 + R_2."""
    return disch(positive(REAL[PARALLEL] >= 0, [R_1 >= 0], [R_2 >= 0]), Eq(KIND, PARALLEL))


@cache
def fed_back() -> Theorem:
    """n = 2, 1 + Z_1 Z_2 != 0 => 0 <= Re Z_1/(1 + Z_1 Z_2)."""
    apart = assume(Ne(SIZE, 0))
    along, across = square(1 + PRODUCT[0]), square(PRODUCT[1])
    size = strictly(combined(SIZE >= 0, [along], [across]), apart)
    answer = R_1 + (R_1**2 + X_1**2) * R_2
    first, turned = [R_2 >= 0, square(R_1)], [R_2 >= 0, square(X_1)]
    found = over(REAL[FED_BACK] >= 0, positive(answer >= 0, [R_1 >= 0], first, turned), size)
    return disch(closed(found, apart), Eq(KIND, FED_BACK), Ne(SIZE, 0))


def no_chain() -> Theorem:
    """n = 3 => anything, for n < 3."""
    never = combined(KIND >= CHAIN, [assume(Eq(KIND, CHAIN)), -1])
    return disch(contr(not_intro(assume(NO_CHAIN), never), REAL[CHAIN] >= 0), Eq(KIND, CHAIN))


@cache
def connected_is_passive() -> tuple[Theorem, ...]:
    """Side by side and fed back, 0 <= Re, for 0 <= R_1 and 0 <= R_2; of a chain nothing is said."""
    return parallel(), fed_back(), no_chain()


def negative(point: Mapping[Expr, Expr]) -> Theorem:
    """Not (n = 3 => 0 <= Re Z_1 Z_2), at a point where it is negative."""
    claim = connected(CHAIN).at(point)
    kind, real = claim.of  # type: ignore[attr-defined]
    below = fact(negated(real))
    return not_intro(mp(assume(claim), fact(kind)), below, claim)


@cache
def passive_wall_is_stable() -> Theorem:
    """A passive wall keeps a damped device stable, with any delay, if a spring or it holds it."""
    turns = closed(with_rest(d, S.One, l), one())
    behind = {alpha: alpha, beta: beta, gamma: gamma, delta: delta, l: l, epsilon: d - l}
    given = [
        *map(assume, (gamma >= 0, DAMPED_DEVICE, HELD, whole(l))),
        combined(d - l >= 0, [assume(l <= d)]),
        combined(d - l < 1, [assume(d < l + 1)]),
        assume(PASSIVE_WALL),
    ]
    return choose(turns, at(late_passive_is_stable(), behind, *given))


def stays_on_circle(point: Mapping[Expr, Expr], angle: Expr) -> Theorem:
    """A loop without delay has a zero at exp(j angle), on the circle: it does not come to rest."""
    values = [point[s] for s in LOOP]
    parts = {"stiffness": point[gamma] != 0, "damping": point[delta] != 0}
    found = closed(loop(values, z, **parts), fact(whole(S.Zero)))
    zeros = found.conclusion.of[1].of[0]  # type: ignore[attr-defined]
    value = sp.expand(zeros.xreplace({z: sp.exp(sp.I * angle)}))
    return denied_by(found, zero_on_circle(zeros, z, angle, identity(value, S.Zero)))
