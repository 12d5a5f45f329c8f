"""The explicit boundary in a form for computing, and the slope of its stiffness."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_forms import Block, Later, nonzero
from symhaptic.forms.device_forms import made_of

TURN = exp(I * theta)
ANGLES = tuple(map(proposition, (theta > 0, theta < pi)))
p, q, r, u, w = symbols("p q r u w")
"""Of the computed formula: what is in phase, what is ahead, that over cos sin, above, below."""
BOTTOM = z**2 - a * z + e
WHOLE, LATE = n_1 * z + n_0, m_2 * z**2 + m_1 * z + m_0
MADE = made_of(Sampled(n_1, n_0, a, e))
POINT = {a: S.One, e: S.Half, n_1: S.One, n_0: S.Half}
LATE_NUMBERS = {a: S.One, e: S.Half, m_2: S.One, m_1: S.Half, m_0: S.Half}


def turned(expr: Expr) -> Expr:
    """At z = exp(j theta)."""
    return expr.xreplace({z: TURN})


def force(top: Expr, delay: Expr, shift: int) -> Expr:
    """Q(exp(j theta)), the wall that a root needs."""
    return -exp(I * (delay + shift) * theta) * turned(BOTTOM) / turned(top)


def ends(late: bool) -> tuple[Expr, Expr, Expr]:
    """M at 1 and -1, and what its imaginary part has."""
    if late:
        return m_2 + m_1 + m_0, m_2 - m_1 + m_0, 2 * (m_2 - m_0)
    return MADE.together, MADE.apart, 2 * n_1


def _size(late: bool) -> Expr:
    """The square of the numerator's size."""
    together, apart, _ = ends(late)
    real = together * cos(theta / 2) ** 2 - apart * sin(theta / 2) ** 2
    return real**2 + _flat(late)


def _flat(late: bool) -> Expr:
    """The square of its imaginary part."""
    return (sin(theta / 2) * cos(theta / 2)) ** 2 * ends(late)[2] ** 2


def wall(top: Expr, delay: Expr, late: bool) -> Block:
    """Both ways in which the boundary is computed, beside the real and imaginary part of Q."""
    together, apart, across = ends(late)
    cosine, sine = cos(theta / 2), sin(theta / 2)
    needed = force(top, delay, int(late))
    flat, size = (sine * cosine) ** 2, w**2 + _flat(late)
    names = (
        (X, needed),
        (c_1, mirror(needed)),
        (x, (X + c_1) / 2),
        (y, (X - c_1) / (2 * I)),
        (u, MADE.at_one * cosine**2 - MADE.at_minus_one * sine**2),
        (w, together * cosine**2 - apart * sine**2),
        (p, (u * w + flat * (2 * MADE.loss) * across) / size),
        (r, (2 * MADE.loss * w - u * across) / size),
        (q, sine * cosine * r),
    )
    swing, back = sin((delay + 1) * theta), cos((delay + 1) * theta)
    pull = p * swing + q * back
    first = q * swing - p * back + pull * tan(theta / 2), -pull / sin(theta)
    damping = -(r * back / 2 + p * (swing / sin(theta)))
    second = sine * cosine * r * swing - p * back - 2 * sine**2 * damping, damping
    exact = x - y / sin(theta) * (1 - cos(theta)), y / sin(theta)
    pairs = (
        Relation(ours, "=", derived)
        for way in (first, second)
        for ours, derived in zip(way, exact, strict=True)
    )
    free = theta, delay, *(LATE_NUMBERS if late else POINT)
    where = (*ANGLES, proposition(Ne(turned(top), 0)))
    point = {theta: S.One, delay: S.One} | (LATE_NUMBERS if late else POINT)
    divisors = partial(_divisors, late, dict(names)[w])
    return Block(free, where, names, tuple(pairs), point, divisors)


def inside(top: Expr) -> list[Theorem]:
    """sin theta, cos(theta/2), and the numerator's two conjugates are not zero."""
    sine = sign_of(sin, theta)
    there = assume(Ne(turned(top), 0))
    return [
        combined(Ne(sin(theta), 0), [sine]),
        nonzero(cos(theta / 2), sine, times=2 * sin(theta / 2)),
        there,
        mirrored(there),
    ]


def _divisors(late: bool, below: Expr) -> list[Theorem]:
    """The size of the numerator, too, as it is written with w for its real part."""
    known = inside(LATE if late else WHOLE)
    size = nonzero(_size(late), *known[2:], times=S.One)
    named = Relation(w**2 + _flat(late), "!=", S.Zero)
    return [*known, size, combined(named, [size], [assume(Relation(w, "=", below)), w + below])]


BOUNDARY = Later(partial(wall, WHOLE, d, False))
LATE_BOUNDARY = Later(partial(wall, LATE, l, True))
