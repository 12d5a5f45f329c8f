"""No stable wall is stiffer than this: by one point of the circle, for any integer delay.

Of p with its zeros inside, n |p|^2 < 2 Re conj(p) z p' on the circle (``outpaces``).  Both sides
are quadratic in the wall, and the left one wins for every damping once the stiffness is large.  At
the angle of the tip of the stable region this bound is the tip itself.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import Ranges
from symhaptic.model.circle import powers
from symhaptic.proof import box
from symhaptic.proof.plants import BALLS, LATE, named

Side: TypeAlias = tuple[Expr, Expr, Expr]
"""p, q and c of the half plane p alpha + q beta < c."""

POWERS = {
    d + 3: S.One,
    d + 2: -a,
    d + 1: e,
    S(2): n_1 * (alpha + beta),
    S.One: n_0 * (alpha + beta) - n_1 * beta,
    S.Zero: -n_0 * beta,
}
"""The characteristic polynomial of integer delays by its powers."""

ROOM = sp.Add(
    *(
        c * f * (k + m - (d + 3)) * cos((k - m) * theta)
        for k, c in POWERS.items()
        for m, f in POWERS.items()
    )
)
"""2 Re conj(p) z p' - n |p|^2 at z = exp(j theta)."""


@cache
def room() -> Theorem:
    """0 < ROOM of a stable wall, for a whole d and every theta."""
    zeros = zeros_of_stable(alpha, beta, gamma, delta, d)
    return closed(combined(Relation(S.Zero, "<", ROOM), [outpaces(zeros, theta)]), *LATER_WHOLE)


def at_point(expr: Expr, ranges: Ranges) -> Theorem:
    """0 < f of the plant's numbers on a small box, by balls."""
    return on_plants(box.positive(sp.sympify(expr), ranges, named({**BALLS, n_0: LATE})))


def softer_than(limit: Expr, delay: int, angle: Expr, ranges: Ranges) -> Theorem:
    """alpha < ``limit`` for every stable wall and all plants of the box."""
    return on_this_side((S.One, S.Zero, limit), delay, angle, ranges)


def on_this_side(side: Side, delay: int, angle: Expr, ranges: Ranges) -> Theorem:
    """p alpha + q beta < c for every stable wall and all plants of the box.

    ``side`` is p, q and c; at the angle of the point of the boundary that it touches nothing is
    given away.
    """
    p, q, limit = side
    known = closed(inst(room(), {d: S(delay), theta: angle}), fact(whole(S(delay))))
    value = known.conclusion.right  # type: ignore[attr-defined]
    other = beta if p != 0 else alpha
    over_, along = sp.symbols("u v")
    moved = {other: along, (alpha if p != 0 else beta): _solved(side, over_, along)}
    plain = {c: sp.Dummy() for c in value.atoms(cos)}
    back = {c: f for f, c in plain.items()}
    form = powers(-value.xreplace(plain).xreplace(moved), over_)
    of = {
        (i, j): powers(form.get(i, S.Zero), along).get(j, S.Zero).xreplace(back)
        for i, j in ((0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (0, 2))
    }
    bend, outside = of[0, 2], assume(p * alpha + q * beta >= limit)
    tilt = of[1, 1] * (p * alpha + q * beta - limit) + of[0, 1]
    rest = [
        4 * bend * of[0, 0] - of[0, 1] ** 2,
        4 * bend * of[1, 0] - 2 * of[1, 1] * of[0, 1],
        4 * bend * of[2, 0] - of[1, 1] ** 2,
    ]
    turn = at_point(bend, ranges)
    less = combined(
        Relation(4 * bend * value, "<=", S.Zero),
        [square(2 * bend * other + tilt)],
        *([at_point(f, ranges), *[outside] * n] for n, f in enumerate(rest)),
    )
    above = Relation(S.Zero, "<", 4 * bend * value)
    contrary = not_intro(positive(above, [4, turn, known]), less)
    wanted = Relation(p * alpha + q * beta, "<", limit)
    found = disj_cases(ordered(wanted.left, limit), assume(wanted), contr(contrary, wanted))
    return of_every_plant(found)


def _solved(side: Side, over_: Symbol, along: Symbol) -> Expr:
    """The coordinate that is eliminated, at p alpha + q beta = c + u."""
    p, q, limit = side
    return (limit + over_ - q * along) / p if p != 0 else (limit + over_) / q
