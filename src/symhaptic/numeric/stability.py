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

from itertools import product
from operator import methodcaller
from typing import Any, NamedTuple

import numpy as np
from array_api_compat import is_numpy_array
from numpy.typing import ArrayLike, NDArray

from symhaptic.kernels import haptic
from symhaptic.notation import sizes
from symhaptic.numeric import arguments
from symhaptic.numeric import certified as by_balls
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.compiled import at_once
from symhaptic.numeric.containers import kept, numbers_only
from symhaptic.numeric.crossings import Crossing, Wall, crossings, surplus, wall
from symhaptic.numeric.cubic import Terms
from symhaptic.numeric.given import Given, single, to_numpy
from symhaptic.numeric.plant import Device, device, discretize


def _leads(terms: Terms) -> NDArray[np.bool_]:
    """Whether g leads next to the end of the half circle: the first nonzero coefficient < 0."""
    c, b, a, k = terms
    return np.where(c != 0, c, np.where(b != 0, b, np.where(a != 0, a, k))) < 0


class Angle(NamedTuple):
    """halves pi + rest: near a multiple of pi the rest keeps the digits that the sum would lose."""

    halves: Array
    rest: Array


def _angle(real: Array, up: Array) -> Angle:
    """Angle of real + j up where up keeps its sign, which is + for 0."""
    back = real < 0
    side = np.where(up < 0, -1.0, 1.0)
    return Angle(np.where(back, side, 0.0), np.arctan2(np.where(back, -up, up), np.abs(real)))


def phase(x: Device, v: Wall, c: Crossing) -> Angle:
    """arg g - arg f without the delay's part, continuous in theta from 0 to pi.

    Each factor, turned by a power of z, keeps to one half plane: the angle of A/z, of M/z and of
    the wall is an arctangent that never jumps.
    """
    a, m, w = below(x, c), above(x, c), force(v, c)
    return Angle(m.halves + w.halves - a.halves, m.rest + w.rest - a.rest)


def _sine(c: Crossing) -> Array:
    """4 sin(theta): the real parts beside it are those at the angle times 4."""
    return 2 * np.sqrt(c.y * c.rest)


def below(x: Device, c: Crossing) -> Angle:
    """The angle of A/z."""
    return _angle(-2 * (1 + x.e) * c.off, x.loss * _sine(c))


def above(x: Device, c: Crossing) -> Angle:
    """The angle of M/z."""
    middle = x.numerator_at_one * c.rest - x.numerator_at_minus_one * c.y
    return _angle(middle, x.gap * _sine(c))


def force(v: Wall, c: Crossing) -> Angle:
    """The angle of the wall."""
    return _angle(v.alpha * c.rest - v.at_minus_one * c.y, v.slope * _sine(c))


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
    on_circle: Array | None = None,
) -> Array:
    """Number of roots outside the unit circle, as floats; ``steps`` is the whole delay.

    -1 where that is not known: of a wall whose squares vanish together with those of the damping.

    With ``on_circle``, the angle of a root on the circle, this root and its conjugate are left
    out: the phase there is an odd multiple of pi, rounded to the side that has them inside.
    """
    terms = surplus(x, v)
    found = crossings(terms, whole)
    total = np.zeros(np.broadcast_shapes(v.slope.shape, steps.shape, x.m2.shape))
    nearest = None
    if on_circle is not None and found:
        y, rest = 4 * np.sin(on_circle / 2) ** 2, 4 * np.cos(on_circle / 2) ** 2
        away = [
            np.where(c.there, np.abs(np.where(y < 2, c.y - y, c.rest - rest)), np.inf)
            for c in found
        ]
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
    end = end + np.where(x.numerator_at_minus_one > 0, np.where(x.gap >= 0, 1.0, -1.0), 0.0)
    end = np.where(steps == np.floor(steps), end, 2 * np.rint(end / 2))  # on the principal sheet
    total += np.where(_leads(terms.near), begin, 0.0)
    total -= np.where(_leads(terms.far), end, 0.0)
    if on_circle is not None:
        return total
    size = np.abs(v.alpha) + np.abs(v.beta)
    return np.where((size > 0) & (size + x.loss < sizes.FAINT), -1.0, total)


_SHAKEN = 2.0**-42
"""Some thousand last places: rounding moves no wall so far."""


def _count(alpha: Array, beta: Array, gamma: Array, delta: Array, delay: Array) -> Array:
    """On the principal sheet; -1 where a wall next to this one has another count."""
    plant = arguments.in_blocks(device, gamma, delta)

    def work(al: Array, be: Array, dy: Array, *numbers: Array) -> list[Array]:
        found = [
            count(Device(*numbers), wall(al * (1 + s), be * (1 + t)), dy)
            for s, t in ((0, 0), *product((-_SHAKEN, _SHAKEN), repeat=2))
        ]
        same = np.logical_and.reduce([other == found[0] for other in found])
        return [np.where(same, found[0], -1.0)]

    return np.asarray(arguments.in_blocks(work, alpha, beta, delay, *plant)[0])


@at_once("unstable_roots", into=methodcaller("astype", np.int64))
@kept(unstable_roots=int)
def unstable_roots(
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
    *,
    certified: bool = False,
) -> NDArray[np.int64]:
    """Number of characteristic roots outside the unit circle.

    The cost does not grow with the delay.

    Parameters
    ----------
    alpha, beta : array_like
        Virtual stiffness K T^2/m and virtual damping B T/m of the wall, finite.
    gamma, delta : array_like
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).
    certified : bool, optional
        Count where bounds of the rounding errors are proved, first in double precision, then in
        ball arithmetic of up to 2560 bits, which takes about 0.3 ms per loop.  The count is then
        -1 only for NaN, and if a root is on the circle or too close to it for these bits.

    Returns
    -------
    int or ndarray of int
        The count, exact for the given floats, of the shape to which the arguments broadcast.  It is
        -1 if it is not known:

        * a root is so close to the circle that rounding cannot decide on which side it is;
        * squares underflow: ``abs(alpha) + abs(beta) + 1 - exp(-delta) < 2**-400`` or
          ``0 < max(abs(alpha), gamma) < 2**-400``;
        * an argument is NaN;
        * on the principal sheet, a wall that differs by some thousand ulps has another count.

    Raises
    ------
    ValueError
        If the wall is infinite, or if ``gamma``, ``delta`` or ``delay`` is negative or too large.

    See Also
    --------
    is_stable : Whether the count is 0.

    Notes
    -----
    The roots are those of :func:`symhaptic.characteristic_polynomial` or, for a fractional delay,
    of the polynomial with the modified z-transform.  They are counted by the argument principle
    (chapter s4d_roots_counted).
    Arrays in single precision are computed in double precision, if their library has it.  Inside
    ``jax.jit`` every branch is compiled, which takes XLA about ten seconds.  ``torch.compile``
    breaks its graph here.

    Examples
    --------
    >>> unstable_roots([0.5, 5.0], 1.0, 0.0, 0.0, 0).tolist()
    [0, 2]
    """
    arguments.check_sheet(sheet)
    given = Given(alpha=alpha, beta=beta, gamma=gamma, delta=delta, delay=delay).in_double()
    if certified:
        by_balls.whole(sheet, given)
    found = by_balls.roots(given) if certified else _outside(given, sheet)
    xp = given.xp
    kind = xp.__array_namespace_info__().default_dtypes()["integral"]
    known = xp.astype(xp.where(xp.isnan(found), xp.full_like(found, -1.0), found), kind)
    return single(known) if is_numpy_array(known) else known  # type: ignore[no-any-return]


def _outside(given: Given, sheet: str) -> Any:
    """The count of roots outside; -1 or NaN where it is not known."""
    xp, delay = given.xp, given.values[4]
    if sheet == "exact":
        return given(haptic.unstable_roots)
    if given.whole(delay):
        return xp.where(delay == xp.floor(delay), given(haptic.unstable_roots), -1.0)

    def work(al: Array, be: Array, g: Array, dl: Array, dy: Array) -> tuple[Array]:
        unknown = np.isnan(al + be + g + dl + dy)
        return (np.where(unknown, np.nan, np.where(unknown, 0.0, _count(al, be, g, dl, dy))),)

    return given.by_numpy(work)[0]


def _stable(given: Given, sheet: str) -> Any:
    """Where the loop is stable; not where that is not known."""
    *numbers, delay = given.values
    if sheet == "exact":
        return given(haptic.is_stable)
    if given.whole(delay):
        return (delay == given.xp.floor(delay)) & given(haptic.is_stable)
    return haptic.stable(given.xp, _outside(given, sheet), *numbers) > 0


@at_once("is_stable")
@kept(is_stable=bool)
def is_stable(
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
    *,
    certified: bool = False,
) -> NDArray[np.bool_]:
    """Whether all characteristic roots lie inside the unit circle.

    Parameters
    ----------
    alpha, beta : array_like
        Virtual stiffness K T^2/m and virtual damping B T/m of the wall, finite.
    gamma, delta : array_like
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).
    certified : bool, optional
        Count where bounds of the rounding errors are proved, first in double precision, then in
        ball arithmetic of up to 2560 bits, which takes about 0.3 ms per loop.  False is
        then right, too.

    Returns
    -------
    bool or ndarray of bool
        Of the shape to which the arguments broadcast.  True is always right.  False is wrong only
        for some stable loops very close to the boundary, where :func:`unstable_roots` is -1 (not
        known).  NaN is not stable.

    Raises
    ------
    ValueError
        If the wall is infinite, or if ``gamma``, ``delta`` or ``delay`` is negative or too large.
    ArithmeticError
        If ``certified`` is true and a root is on the circle, or too close to it.

    See Also
    --------
    max_stable_stiffness : The largest stable stiffness.
    delay_margin : The delay that may be added.

    Notes
    -----
    Loops with a root on the circle are not stable: on the line alpha = -gamma, for an undamped
    device without a wall, and for an undamped device with omega_d T at a multiple of pi, whatever
    the wall.

    Examples
    --------
    >>> is_stable([0.03, 0.003], 0.05, 0.001, 0.02, 5).tolist()
    [False, True]
    >>> wall = 0.6862915010152394, 0.8284271247461901, 0.0, 0.0, 0  # the limit is 12 - 8 sqrt(2)
    >>> bool(is_stable(*wall)), bool(is_stable(*wall, certified=True))
    (False, True)
    """
    arguments.check_sheet(sheet)
    given = Given(alpha=alpha, beta=beta, gamma=gamma, delta=delta, delay=delay).in_double()
    if certified:
        by_balls.whole(sheet, given)
        return by_balls.stable(given)  # type: ignore[no-any-return]
    return _stable(given, sheet)  # type: ignore[no-any-return]


@numbers_only
def characteristic_polynomial(
    alpha: float, beta: float, gamma: float, delta: float, delay: int
) -> Array:
    r"""Coefficients of the monic characteristic polynomial of the loop.

    Parameters
    ----------
    alpha, beta : float
        Virtual stiffness K T^2/m and virtual damping B T/m of the wall, finite.
    gamma, delta : float
        Physical stiffness k T^2/m >= 0 and physical damping b T/m >= 0.
    delay : int
        Delay d in sampling periods, an integer >= 0.

    Returns
    -------
    ndarray of shape (d + 4,)
        Coefficients, highest power first.

    Raises
    ------
    ValueError
        If ``delay`` is not an integer, or if another argument is out of its range.

    Notes
    -----
    The polynomial of degree d + 3 is

    .. math:: z^{d+1}(z^2-az+e)+(n_1z+n_0)((\alpha+\beta)z-\beta)

    with the four numbers of :func:`discretize`; derived in chapter s4b_polynomial.  It is (18) of
    the paper divided by its leading coefficient.

    Examples
    --------
    >>> characteristic_polynomial(0.5, 1.0, 0.0, 0.0, 0).tolist()
    [1.0, -1.25, 1.25, -0.5]
    """
    names = ("alpha", "beta", "gamma", "delta", "delay")
    given = Given(alpha=alpha, beta=beta, gamma=gamma, delta=delta, delay=delay)
    arrays = map(to_numpy, given.values)
    values = [arguments.single(*pair) for pair in zip(names, arrays, strict=True)]
    if values[4] != np.floor(values[4]):
        raise ValueError(f"delay: {delay!r} is not allowed; give whole numbers delay >= 0")
    n1, n0, a, e = (float(x) for x in discretize(values[2], values[3]))
    coefficients = np.zeros(int(values[4]) + 4)
    coefficients[:3] = 1.0, -a, e
    coefficients[-3:] += np.convolve([n1, n0], [values[0] + values[1], -values[1]])
    return given.own(coefficients)  # type: ignore[no-any-return]
