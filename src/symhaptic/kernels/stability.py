r"""Stability of the loop in numbers, at a cost that does not grow with the delay.

With :math:`f=z^{l+2}A` of the plant and :math:`g=M\,((\alpha+\beta)z-\beta)` of the wall, the
characteristic polynomial is :math:`p=f+g`.  On the unit circle a root needs :math:`|f|=|g|`, an
equation in :math:`y=4\sin^2(\theta/2)` of degree two (three for a fractional delay) that does not
contain the delay.  Between its solutions one of f and g leads and takes the argument of p along,
so that only the phase :math:`\Phi=\arg g-\arg f` at the solutions decides: where g stops or
starts to lead, p has turned :math:`2\pi\,[\Phi/2\pi]` more or less than f, with the nearest whole
number in the brackets.  Chapter s4d_roots_counted derives this.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.kernels import arguments, cubic
from symhaptic.kernels.arguments import Array
from symhaptic.kernels.plant import Device, device, discretize

SHEETS = ("exact", "principal")


class Crossing(NamedTuple):
    """A solution of |f| = |g| on the upper half circle, if it is one."""

    y: Array
    """4 sin(theta/2)^2."""
    rest: Array
    """4 - y, kept beside it for angles near pi."""
    rises: NDArray[np.bool_]
    """Whether |f|^2 - |g|^2 grows with y, that is whether g stops to lead."""
    there: NDArray[np.bool_]


class Wall(NamedTuple):
    """The wall's part (alpha + beta) z - beta by what is needed of it."""

    alpha: Array
    beta: Array
    slope: Array
    """alpha + beta."""
    at_minus_one: Array
    """-(alpha + 2 beta) is its value at -1."""


def wall(alpha: Array, beta: Array) -> Wall:
    """The wall, with no negative zeros."""
    return Wall(alpha + 0.0, beta + 0.0, alpha + beta + 0.0, alpha + 2 * beta)


def surplus(x: Device, v: Wall) -> tuple[Array, ...]:
    """|f|^2 - |g|^2 as a polynomial in y, and in 4 - y; constant term first."""
    near = _surplus(
        x.at_one, x.e, x.loss, x.numerator_at_one, x.m2, x.m0, v.alpha, v.slope * v.beta
    )
    far = _surplus(
        x.at_minus_one,
        x.e,
        x.loss,
        x.numerator_at_minus_one,
        x.m2,
        x.m0,
        v.at_minus_one,
        -v.slope * v.beta,
    )
    return (*near, *far)


def _surplus(
    at: Array, e: Array, loss: Array, top: Array, m2: Array, m0: Array, v: Array, vv: Array
) -> tuple[Array, Array, Array, Array]:
    """The four coefficients from the values at the end of the half circle.

    |A|^2 = at^2 + (loss^2 - at (1 + e)) y + e y^2, likewise |M|^2, and |wall|^2 = v^2 + vv y.
    """
    m_linear, m_square = (m2 - m0) ** 2 - top * (m2 + m0), m2 * m0
    scaled = top * v
    constant = (at - scaled) * (at + scaled)
    linear = loss**2 - at * (1 + e) - m_linear * v**2 - top**2 * vv
    square = e - m_square * v**2 - m_linear * vv
    return constant, linear, square, -m_square * vv


def _quadratic(c: Array, b: Array, a: Array, disc: Array) -> tuple[Array, Array]:
    """Roots (-b - s)/(2 a) and (-b + s)/(2 a), s = sqrt(disc), without cancellation."""
    root = np.sqrt(disc)
    upper = b >= 0
    q = -(b + np.where(upper, root, -root)) / 2
    one, two = q / a, c / q
    return np.where(upper, one, two), np.where(upper, two, one)


def crossings(near: tuple[Array, ...], far: tuple[Array, ...], whole: bool) -> list[Crossing]:
    """Where |f| = |g| on the open upper half circle."""
    if not whole:
        return [Crossing(*c) for c in cubic.roots(near, far)]
    c, b, a, _ = near
    c_far, b_far, _, _ = far
    # the discriminant is the same for y and for 4 - y; the smaller b rounds less
    closer = np.abs(b) <= np.abs(b_far)
    disc = np.where(closer, b * b - 4 * a * c, b_far * b_far - 4 * a * c_far)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        falling, rising = _quadratic(c, b, a, disc)
        rising_far, falling_far = _quadratic(c_far, b_far, a, disc)
    found = []
    for y, rest, rises in ((falling, falling_far, np.False_), (rising, rising_far, np.True_)):
        small = y < rest  # their sum is 4 but for rounding, and where both are far off the circle
        there = (y > 0) & (rest > 0) & (np.where(small, y, rest) < 4)
        y = np.where(there, np.where(small, y, 4 - rest), 2.0)
        rest = np.where(there, np.where(small, 4 - y, rest), 2.0)
        found.append(Crossing(y, rest, np.asarray(rises), there))
    return found


def _leads(c: Array, b: Array, a: Array, k: Array) -> NDArray[np.bool_]:
    """Whether g leads next to the end of the half circle: the first nonzero coefficient < 0."""
    return np.where(c != 0, c, np.where(b != 0, b, np.where(a != 0, a, k))) < 0


class Angle(NamedTuple):
    """halves pi + rest: near a multiple of pi the rest keeps the digits that the sum would lose."""

    halves: Array
    rest: Array


def _angle(height: Array, at_one: Array, at_minus_one: Array, c: Crossing, sine: Array) -> Angle:
    """Angle of at_one (1 + cos)/2 - at_minus_one (1 - cos)/2 + j height sin, for height >= 0."""
    real = at_one * c.rest - at_minus_one * c.y
    back = real < 0
    up = height * sine
    side = np.where(height < 0, -1.0, 1.0)
    return Angle(np.where(back, side, 0.0), np.arctan2(np.where(back, -up, up), np.abs(real)))


def phase(x: Device, v: Wall, c: Crossing) -> Angle:
    """arg g - arg f without the delay's part, continuous in theta from 0 to pi.

    Each factor, turned by a power of z, keeps to one half plane: the angle of A/z, of M/z and of
    the wall is an arctangent that never jumps.
    """
    sine = 2 * np.sqrt(c.y * c.rest)
    below = _angle(x.loss, x.at_one, x.at_minus_one, c, sine)
    above = _angle(x.m2 - x.m0, x.numerator_at_one, x.numerator_at_minus_one, c, sine)
    force = _angle(v.slope, v.alpha, v.at_minus_one, c, sine)
    return Angle(above.halves + force.halves - below.halves, above.rest + force.rest - below.rest)


def theta(c: Crossing) -> Angle:
    """The crossing's angle."""
    far = c.y > 2
    half = np.arctan2(np.sqrt(np.where(far, c.rest, c.y)), np.sqrt(np.where(far, c.y, c.rest)))
    return Angle(np.where(far, 1.0, 0.0), np.where(far, -2.0, 2.0) * half)


def turns(bare: Angle, late: Angle, steps: Array) -> Array:
    """The nearest whole number of turns in a phase behind a delay."""
    halves = bare.halves - (steps + 2) * late.halves
    rest = (bare.rest - (steps + 2) * late.rest) / (2 * np.pi)
    even = np.floor(halves / 2)
    left = halves / 2 - even
    # at an odd number of half turns the sign of the rest decides, however small it is
    return even + np.where(left == 0.5, np.floor(rest) + 1, np.rint(rest + left))


def count(
    x: Device,
    v: Wall,
    steps: Array,
    whole: bool = True,
    principal: bool = False,
    on_circle: Array | None = None,
) -> Array:
    """Number of roots outside the unit circle, as floats; ``steps`` is the whole delay.

    With ``on_circle``, the y of a root on the circle, this root and its conjugate are left out:
    the phase there is an odd multiple of pi, which is rounded to the side that has them inside.
    """
    terms = surplus(x, v)
    near, far = terms[:4], terms[4:]
    found = crossings(near, far, whole)
    total = np.zeros(np.broadcast_shapes(v.alpha.shape, steps.shape, x.m2.shape))
    nearest = None
    if on_circle is not None and found:
        away = [np.where(c.there, np.abs(c.y - on_circle), np.inf) for c in found]
        nearest = np.argmin(np.stack(np.broadcast_arrays(*away)), axis=0)
    for i, c in enumerate(found):
        bare = phase(x, v, c)
        if nearest is not None:
            shift = np.where(nearest == i, np.where(c.rises, 1.0, -1.0), 0.0)
            bare = Angle(bare.halves + shift, bare.rest)
        whole_turns = turns(bare, theta(c), steps)
        total += np.where(c.there, np.where(c.rises, -2, 2) * whole_turns, 0.0)
    side = np.where(v.slope >= 0, 1.0, -1.0)
    begin = np.where(v.alpha > 0, 0.0, side)
    end = np.where(v.at_minus_one > 0, side, 0.0) - (steps + 3)
    end += np.where(x.numerator_at_minus_one > 0, np.where(x.m2 >= x.m0, 1.0, -1.0), 0.0)
    if principal:
        end = 2 * np.rint(end / 2)
    total += np.where(_leads(*near), begin, 0.0)
    total -= np.where(_leads(*far), end, 0.0)
    return total


def split(delay: Array, sheet: str) -> tuple[Array, Array | None]:
    """The whole delay and, for the exact sheet where it occurs, the fraction."""
    if sheet == "principal":
        return delay, None
    steps = np.floor(delay)
    part = delay - steps
    return steps, part if np.any(part) else None


def _count(
    alpha: Array, beta: Array, gamma: Array, delta: Array, delay: Array, sheet: str
) -> Array:
    steps, part = split(delay, sheet)
    given = (gamma, delta) if part is None else (gamma, delta, part)
    plant = arguments.in_blocks(device, *given)

    def work(al: Array, be: Array, st: Array, *numbers: Array) -> list[Array]:
        return [count(Device(*numbers), wall(al, be), st, part is None, sheet == "principal")]

    return np.asarray(arguments.in_blocks(work, alpha, beta, steps, *plant)[0])


def _arguments(
    alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, delta: ArrayLike, delay: ArrayLike
) -> tuple[Array, Array, Array, Array, Array]:
    return (
        arguments.finite("alpha", alpha),
        arguments.finite("beta", beta),
        arguments.nonnegative("gamma", gamma),
        arguments.nonnegative("delta", delta),
        arguments.periods("delay", delay),
    )


def unstable_roots(
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
) -> NDArray[np.int64]:
    """Number of characteristic roots outside the unit circle; the cost does not grow with delay.

    Dimensionless wall ``alpha``, ``beta``, plant ``gamma`` >= 0, ``delta`` >= 0 and ``delay`` >= 0
    in periods, whole or fractional (exact, by the modified z-transform); arrays broadcast.  With
    ``sheet="principal"`` a fractional delay is the paper's z^-d on the principal sheet.  A root
    within rounding of the circle may be counted on either side.  NaN gives -1.

    Raises :class:`ValueError` for an infinite wall and an impossible plant or delay.

    >>> unstable_roots([0.5, 5.0], 1.0, 0.0, 0.0, 0).tolist()
    [0, 2]
    """
    arguments.one_of("sheet", sheet, SHEETS)
    values = _arguments(alpha, beta, gamma, delta, delay)
    unknown = np.isnan(sum(values))
    found = _count(*values, sheet)
    return np.where(unknown, -1, np.where(unknown, 0.0, found)).astype(np.int64)


def is_stable(
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
) -> NDArray[np.bool_]:
    """Whether all characteristic roots lie inside the unit circle; see :func:`unstable_roots`.

    On the line alpha = -gamma a root lies at 1, and an undamped device without a wall keeps on
    swinging: neither is stable, and NaN is not either.

    >>> is_stable([0.03, 0.003], 0.05, 0.001, 0.02, 5).tolist()
    [False, True]
    """
    al, be, g, dl, _ = _arguments(alpha, beta, gamma, delta, delay)
    swings = (al == 0) & (be == 0) & (dl == 0)
    count = unstable_roots(al, be, g, dl, delay, sheet)
    return np.asarray((count == 0) & (al > -g) & ~swings)


def characteristic_polynomial(
    alpha: float, beta: float, gamma: float, delta: float, delay: int
) -> Array:
    """Coefficients of the monic characteristic polynomial, highest power first.

    z^(d+1) (z^2 - a z + e) + (n1 z + n0) ((alpha+beta) z - beta), of degree d + 3, for one wall
    and a whole delay d >= 0.  Derived in chapter s4b_polynomial ((18) of the paper, monic).

    Raises :class:`ValueError` for a delay that is not whole and for impossible arguments.

    >>> characteristic_polynomial(0.5, 1.0, 0.0, 0.0, 0).tolist()
    [1.0, -1.25, 1.25, -0.5]
    """
    names = ("alpha", "beta", "gamma", "delta", "delay")
    arrays = _arguments(alpha, beta, gamma, delta, delay)
    values = [arguments.single(*pair) for pair in zip(names, arrays, strict=True)]
    if values[4] != np.floor(values[4]):
        raise ValueError(f"delay: {delay!r} is not allowed; whole numbers delay >= 0 are")
    n1, n0, a, e = (float(x) for x in discretize(values[2], values[3]))
    coefficients = np.zeros(int(values[4]) + 4)
    coefficients[:3] = 1.0, -a, e
    coefficients[-3:] += np.convolve([n1, n0], [values[0] + values[1], -values[1]])
    return coefficients
