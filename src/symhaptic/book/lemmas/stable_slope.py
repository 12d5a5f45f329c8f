"""The slope of the stiffness on the boundary, which vanishes at the stable wall of maximum
stiffness."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_boundary import (
    ANGLES,
    BOTTOM,
    LATE,
    LATE_NUMBERS,
    MADE,
    POINT,
    WHOLE,
    force,
    inside,
    turned,
)
from symhaptic.book.lemmas.stable_forms import Block, Later, Named, nonzero
from symhaptic.forms import max_stiffness_slope

f, g, v, w, q, r = symbols("f g v w q r")
"""Of the force A/M: its real and imaginary part below, over cos(theta/2)^2, and what it turns."""
u_1, u_2, w_1, w_2, U, W = symbols("u_1 u_2 w_1 w_2 U W")
"""A and M at exp(j theta), over exp(j theta) cos(theta/2)^2: real and imaginary parts, squares."""
A_1, A_2, L, M_1, M_2 = VALUES = symbols("A_1 A_2 L M_1 M_2")
"""A at 1 and -1, 1 - e, and M at 1 and -1."""
k_4, k_3, k_2, k_1, k_0 = COEFFICIENTS = symbols("k_4 k_3 k_2 k_1 k_0")


def derived(top: Expr, delay: Expr, shift: int) -> tuple[Named, Expr]:
    """Q and its slope by the angle, both with their conjugates; the slope of the stiffness."""
    needed, away = force(top, delay, shift), delay + shift
    turn = away * BOTTOM * top + z * (derivative(BOTTOM, z) * top - BOTTOM * derivative(top, z))
    slope = -I * exp(I * away * theta) * turned(turn) / turned(top) ** 2
    names = (
        *((X, needed), (c_1, mirror(needed)), (c_2, slope), (c_3, mirror(slope))),
        *((y, (X - c_1) / (2 * I)), (f, (c_2 + c_3) / 2), (g, (c_2 - c_3) / (2 * I))),
    )
    return names, f - g * t - y * (1 + t**2) / 2


def _values(late: bool) -> Named:
    """t, and A and M at z = 1 and z = -1."""
    ends = (m_2 + m_1 + m_0, m_2 - m_1 + m_0) if late else (n_1 + n_0, n_1 - n_0)
    found = MADE.at_one, MADE.at_minus_one, MADE.loss, *ends
    return ((t, tan(theta / 2)), *zip(VALUES, found, strict=True))


def _searched() -> Block:
    """The slope whose zero is searched for, with any delay."""
    names, exact = derived(LATE, l, 1)
    grown, half, across = 1 + t**2, (2 * l + 3) * (theta / 2), m_2 - m_0
    turns = (l + Rational(3, 2)) * (U * W) + grown * (
        L * (A_1 + A_2 * t**2) * W - across * (M_1 + M_2 * t**2) * U
    )
    swells = grown * ((2 * L**2 - A_2 * u_1) * W - (2 * across**2 - M_2 * w_1) * U)
    computed = (
        *(
            (u_1, A_1 - A_2 * t**2),
            (u_2, 2 * t * L),
            (w_1, M_1 - M_2 * t**2),
            (w_2, 2 * t * across),
        ),
        *((U, u_1**2 + u_2**2), (W, w_1**2 + w_2**2)),
        *((v, u_1 * w_1 + u_2 * w_2), (w, u_2 * w_1 - u_1 * w_2), (q, turns), (r, swells)),
    )
    along, up = cos(half), sin(half)
    rise = q * (v * up + w * along) - t * (r + U * W / 2) * (v * along - w * up)
    pair = Relation(rise / (U * W**2 * cos(theta / 2)), "=", exact)
    where = *ANGLES, *(proposition(Ne(turned(p), 0)) for p in (LATE, BOTTOM))
    point = {theta: S.One, l: S.One} | LATE_NUMBERS
    named = *_values(True), *names, *computed
    divisors = partial(_divisors, LATE, True)
    return Block((theta, l, *LATE_NUMBERS), where, named, (pair,), point, divisors)


def _polynomial(top: Expr, late: bool) -> Block:
    """The same for delays below one period, or for none, as a polynomial in the square of t."""
    numbers = LATE_NUMBERS if late else POINT
    if late:
        found, arguments = max_stiffness_slope.early(), max_stiffness_slope.EARLY
        square = (M_1 - M_2 * t**2) ** 2 + 4 * t**2 * (m_2 - m_0) ** 2
    else:
        found, arguments = max_stiffness_slope.undelayed(), max_stiffness_slope.UNDELAYED
        square = M_1**2 + M_2**2 * t**2
    known = dict(zip(arguments, (*VALUES, m_0), strict=False))
    names, exact = derived(top, S.Zero, int(late))
    powers = COEFFICIENTS[-len(found) :]
    computed = tuple(zip(powers, (k.xreplace(known) for k in found), strict=True))
    rise = S.Zero
    for name in powers:
        rise = rise * t**2 + name
    pair = Relation(t * (rise / ((1 + t**2) * square**2)), "=", exact)
    where = (*ANGLES, proposition(Ne(turned(top), 0)))
    named = *_values(late), *names, *computed
    point, divisors = {theta: S.One} | numbers, partial(_divisors, top, False)
    return Block((theta, *numbers), where, named, (pair,), point, divisors)


def size_not_zero(top: Expr, known: Sequence[Theorem]) -> Theorem:
    """The square of a polynomial's size over cos(theta/2)^4, or ^2, is not zero."""
    one, other = top.subs(z, 1), top.subs(z, -1)
    tangent = tan(theta / 2)
    if top == WHOLE:
        size = MADE.together**2 + MADE.apart**2 * tangent**2
        return nonzero(size, *known, times=cos(theta / 2) ** 2)
    across = 1 - e if top == BOTTOM else m_2 - m_0
    size = (one - other * tangent**2) ** 2 + 4 * tangent**2 * across**2
    return nonzero(size, *known, times=cos(theta / 2) ** 4)


def _divisors(top: Expr, searched: bool) -> list[Theorem]:
    """What a slope is divided by, in both forms of it."""
    known = inside(top)
    if searched:
        alive = assume(Ne(turned(BOTTOM), 0))
        other = size_not_zero(BOTTOM, [alive, mirrored(alive)])
    else:
        unit = fact(Relation(S.One, "!=", S.Zero))
        other = nonzero(1 + tan(theta / 2) ** 2, unit, times=cos(theta / 2) ** 2)
    return [*known, size_not_zero(top, known[2:]), other]


SEARCHED = Later(_searched)
EARLY, UNDELAYED = (Later(partial(_polynomial, *x)) for x in ((LATE, True), (WHOLE, False)))
