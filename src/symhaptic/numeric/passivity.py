r"""Passivity of a delayed wall in numbers, at a cost that does not grow with the delay.

The generated kernels know what a wall needs behind a delay of :math:`\ell+\varepsilon` periods,
by chapter s6d_fractional_passivity; with :math:`\ell=d` and :math:`\varepsilon=0` it is what the
paper asks for, its principal sheet.  Walls that are just passive are as large as the damping.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.kernels import haptic
from symhaptic.numeric import arguments, slopes
from symhaptic.numeric import certified as by_balls
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.compiled import at_once
from symhaptic.numeric.containers import kept
from symhaptic.numeric.digits import in_digits
from symhaptic.numeric.extremum import Extremum
from symhaptic.numeric.given import Given, to_numpy
from symhaptic.numeric.renamed import renamed


def _stiffest(kernel: Any, delta: Any, delay: Any) -> tuple[Any, Any, Any]:
    """The stiffest passive wall by its kernel; without delay its damping is 0, no difference."""
    alpha, beta, theta = kernel(delta, delay)
    none = delay == 0
    if none.any() if isinstance(none, np.ndarray) else none:
        beta = np.where(none, 0.0, beta)[()]
    return alpha, beta, theta


def _needed(xp: Any, alpha: Any, beta: Any, steps: Any, part: Any) -> Any:
    """The damping against which no motion extracts energy; infinite for a pulling wall."""
    size = xp.abs(alpha) + xp.abs(beta)
    scale = xp.where(size > 0, size, 1.0)  # squares of a tiny wall would vanish
    stiffness, damping = xp.where(alpha > 0, alpha, 0.0) / scale, beta / scale
    psi = haptic.worst_angle(xp, stiffness, damping, steps, part)
    need = haptic.damping_at(xp, stiffness, damping, steps, part, psi)
    return xp.where(alpha < 0, math.inf, scale * need)


@at_once("passivity_margin")
@kept(margin=float)
@slopes.in_jax(("margin",), instead="lambdify('passivity_margin', modules='jax') has derivatives")
def passivity_margin(
    alpha: ArrayLike,
    beta: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
    *,
    digits: int | None = None,
) -> Array:
    """Physical damping minus the damping that the wall requires, at its worst angle.

    Parameters
    ----------
    alpha, beta : array_like
        Virtual stiffness K T^2/m and virtual damping B T/m of the wall, finite.
    delta : array_like
        Physical damping b T/m of the device, >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).
    digits : int, optional
        Return balls of python-flint (``flint.arb``) that are correct to this many digits.

    Returns
    -------
    float or ndarray
        The margin in units of m/T.  If it is not negative, no motion extracts energy from the wall.
        -inf if ``alpha`` < 0: such a wall delivers more energy the farther it is pushed, so no
        damping is enough.

    Raises
    ------
    ValueError
        If the wall is infinite, or ``delta`` or ``delay`` is negative or infinite; NaN gives NaN.

    See Also
    --------
    passivity_margin_at : The margin at one angle.

    Notes
    -----
    For integer delays and with ``sheet="principal"`` the required damping is that of (5) of the
    paper.  The general case is derived in chapter s6d_fractional_passivity.

    Examples
    --------
    >>> [round(float(x), 6) for x in passivity_margin(1.0, 0.0, 1.0, [0, 0.5, 1])]
    [0.5, -0.059017, -0.5]
    """
    arguments.check_sheet(sheet)
    if digits is not None:
        return in_digits(  # type: ignore[no-any-return]
            "passivity_margin", digits, sheet, alpha=alpha, beta=beta, delta=delta, delay=delay
        )
    given = Given(alpha=alpha, beta=beta, delta=delta, delay=delay)

    if sheet == "exact" and not given.traced:
        return given(haptic.passivity_margin)  # type: ignore[no-any-return]

    def margin(xp: Any, al: Any, be: Any, dl: Any, dy: Any) -> Any:
        steps = dy if sheet == "principal" else xp.floor(dy)
        return dl - _needed(xp, al, be, steps, dy - steps)

    return given.each(margin)  # type: ignore[no-any-return]


@at_once("passivity_margin_at")
@kept(margin=float)
def passivity_margin_at(
    theta: ArrayLike,
    alpha: ArrayLike,
    beta: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
    *,
    digits: int | None = None,
) -> Array:
    r"""Physical damping minus the damping that the wall requires, at one angle.

    Parameters
    ----------
    theta : array_like
        Angle omega T of the motion, 0 < theta < pi.
    alpha, beta : array_like
        Virtual stiffness K T^2/m and virtual damping B T/m of the wall, finite.
    delta : array_like
        Physical damping b T/m of the device, >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).
    digits : int, optional
        Return balls of python-flint (``flint.arb``) that are correct to this many digits.

    Returns
    -------
    float or ndarray
        The margin in units of m/T.  If alpha >= 0, its smallest value over theta is
        :func:`passivity_margin`.

    Raises
    ------
    ValueError
        If ``theta`` is outside (0, pi), the wall is infinite, or ``delta`` or ``delay`` is negative
        or infinite; NaN gives NaN.

    Notes
    -----
    For integer delays and with ``sheet="principal"`` the margin is, by (5) of the paper,

    .. math:: \delta-\alpha\,\frac{\sin((d+1/2)\theta)}{2\sin(\theta/2)}
       +\beta\cos((d+1)\theta)

    For a fractional delay it is the margin of the worst motion at this angle, exact for the sampled
    loop; derived in chapter s6d_fractional_passivity.

    Examples
    --------
    >>> [round(float(x), 6) for x in passivity_margin_at(1.0, 1.0, 0.5, 1.0, [0, 0.5, 1])]
    [0.770151, 0.138338, -0.248376]
    """
    arguments.check_sheet(sheet)
    loop = {"theta": theta, "alpha": alpha, "beta": beta, "delta": delta, "delay": delay}
    if digits is not None:
        return in_digits("passivity_margin_at", digits, sheet, **loop)  # type: ignore[no-any-return]
    given = Given(**loop)
    if sheet == "exact":
        return given(haptic.passivity_margin_at)  # type: ignore[no-any-return]

    def margin(xp: Any, th: Any, al: Any, be: Any, dl: Any, dy: Any) -> Any:
        half = th / 2
        kernel = haptic.sin_next(xp, 2 * dy, half) / (2 * xp.sin(half))
        return dl - al * kernel + be * haptic.cos_next(xp, dy, th)

    return given.each(margin)  # type: ignore[no-any-return]


_NEAR = 2.0**-46
"""Margins up to this share of the largest sum of terms are compared with 0 in balls: 128 units in
the last place, of which the kernel needs 2 (`tests/numeric/test_certified.py`)."""


def _room(size: Callable[[Any], Any], alpha: Any, beta: Any, delta: Any, delay: Any) -> Any:
    return _NEAR * (size(alpha) * (delay + 1) + size(beta) + delta)


@kept(is_passive=bool)
def is_passive(
    alpha: ArrayLike,
    beta: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
    *,
    certified: bool = False,
) -> NDArray[np.bool_]:
    """Whether no motion can extract energy from the wall.

    Parameters
    ----------
    alpha, beta : array_like
        Virtual stiffness K T^2/m and virtual damping B T/m of the wall, finite.
    delta : array_like
        Physical damping b T/m of the device, >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).
    certified : bool, optional
        Enclose every margin in ball arithmetic of up to 1024 bits.

    Returns
    -------
    bool or ndarray of bool
        Whether :func:`passivity_margin` is not negative.  NaN is not passive.

    Raises
    ------
    ValueError
        If the wall is infinite, or ``delta`` or ``delay`` is negative or infinite.
    ArithmeticError
        If ``certified`` is true and balls cannot decide the sign of a margin.

    Notes
    -----
    Walls on the boundary are passive, too; the strict sign of (4) of the paper excludes them.  Only
    the damping of the device counts, not that of an arm, (3).

    A margin that is within rounding of 0 is enclosed in balls, which takes from some milliseconds
    to some seconds a wall.  If these do not tell its sign, or it is traced, or of a fractional
    delay with ``sheet="principal"``, the wall counts as not passive.

    Examples
    --------
    >>> is_passive([1.9, 2.0, 2.1, -0.1], 0.0, 1.0, 0).tolist()
    [True, True, False, False]
    """
    arguments.check_sheet(sheet)
    plain = all(type(v) in (float, int) for v in (alpha, beta, delta, delay))
    if plain and sheet == "exact" and not certified:
        margin = passivity_margin(alpha, beta, delta, delay)
        if abs(margin) > _room(abs, alpha, beta, delta, delay):
            return margin > 0
    given = Given(alpha=alpha, beta=beta, delta=delta, delay=delay).in_double()
    if certified:
        by_balls.whole(sheet, given)
    al, be, dl, dy = given.values
    if sheet == "exact":  # only without this argument the compiled kernel is called directly
        margin = passivity_margin(al, be, dl, dy)
    else:
        margin = passivity_margin(al, be, dl, dy, sheet)
    room = _room(given.xp.abs, al, be, dl, dy)
    sure = margin > room
    if given.traced and not certified:
        return sure  # type: ignore[no-any-return]
    known = to_numpy(margin)
    near = np.abs(known) <= to_numpy(room)
    if certified:
        near = ~np.isnan(known)
    elif sheet != "exact":
        near &= np.floor(to_numpy(dy)) == to_numpy(dy)
    if not near.any():
        return sure  # type: ignore[no-any-return]
    return by_balls.passive(given, near, to_numpy(sure), certified)  # type: ignore[no-any-return]


def _printed(xp: Any, theta: Any, delay: Any) -> tuple[Any, Any]:
    """(27) of the paper at any real delay, for a damping of 1; NaN beyond pi/(delay + 1)."""
    half = haptic.sinc(xp, theta / 2)
    up = haptic.sin_next(xp, delay, theta)
    rise = half * half * (delay + 1) * up / theta
    below = haptic.spread(xp, delay, theta)
    lead = haptic.lead(xp, theta, delay, xp.zeros_like(delay))
    wall = 2 * rise / below, (haptic.chord(xp, delay, theta) - rise) / below
    return haptic.rated(xp, lead, wall[0]), haptic.rated(xp, lead, wall[1])


@renamed(omega="theta")
@at_once("passivity_boundary")
@kept(alpha=float, beta=float)
@slopes.in_jax(("alpha", "beta"), ("delta",))
def passivity_boundary(
    theta: ArrayLike,
    delta: ArrayLike,
    delay: ArrayLike,
    sheet: str = "exact",
    *,
    digits: int | None = None,
) -> tuple[Array, Array]:
    """The wall (alpha, beta) on the passivity boundary with the worst angle ``theta``.

    Parameters
    ----------
    theta : array_like
        Worst angle omega T, 0 < theta < pi.  The old keyword ``omega`` still works, with a
        :class:`DeprecationWarning`.
    delta : array_like
        Physical damping b T/m of the device, >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).
    digits : int, optional
        Return balls of python-flint (``flint.arb``) that are correct to this many digits. Only for
        integer delays.

    Returns
    -------
    alpha, beta : float or ndarray
        K T^2/m and B T/m.  NaN beyond the end of the curve, where the stiffness is 0: there (27)
        gives walls that are not passive.  For integer delays and with ``sheet="principal"`` the end
        is at pi/(delay + 1).

    Raises
    ------
    ValueError
        If an argument is out of its range; NaN gives NaN.

    Notes
    -----
    For integer delays and with ``sheet="principal"`` the curve is (27) of the paper.

    Two more pieces complete the boundary.  The walls with worst angle 0 lie between (0, -delta) and
    the limit of the curve at theta -> 0, on alpha (delay + 1/2) + e alpha^2/(4 delta) =
    delta + beta with e = part (1 - part) for the fractional part of the delay.  For delays up to
    2/9 of a period the curve does not end before pi; the walls with worst angle pi lie between its
    limit there and (0, delta/(1 - delay)), on beta + alpha/2 = delta/(1 - delay).

    Examples
    --------
    >>> alpha, beta = passivity_boundary([0.5, 1.0], 1.0, 1)
    >>> alpha.round(6).tolist(), beta.round(6).tolist()
    ([0.817217, 0.811125], [0.232804, 0.375311])
    """
    arguments.check_sheet(sheet)
    if digits is not None:
        return in_digits(  # type: ignore[no-any-return]
            "passivity_boundary", digits, sheet, theta=theta, delta=delta, delay=delay
        )

    def walls(xp: Any, angle: Any, damping: Any, periods: Any) -> tuple[Any, Any]:
        unit = haptic.elementwise(xp, partial(_printed, xp), angle, periods)
        return damping * unit[0], damping * unit[1]

    given = Given(theta=theta, delta=delta, delay=delay)
    exact = sheet == "exact"
    return given(haptic.passivity_boundary if exact else partial(walls, given.xp))  # type: ignore[no-any-return]


@at_once("max_passive_stiffness", into=Extremum, work=_stiffest)
@kept(Extremum, alpha=float, beta=float, theta=float)
@slopes.in_jax(
    Extremum._fields,
    ("delta",),
    instead="lambdify('max_passive_stiffness', modules='jax') has derivatives",
)
def max_passive_stiffness(
    delta: ArrayLike, delay: ArrayLike, sheet: str = "exact", *, digits: int | None = None
) -> Extremum:
    """The passive wall of largest stiffness, with its virtual damping and its worst angle.

    Parameters
    ----------
    delta : array_like
        Physical damping b T/m of the device, >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    sheet : {"exact", "principal"}, optional
        Meaning of a fractional delay: ``"exact"`` is the modified z-transform, ``"principal"`` the
        paper's z^-d = exp(-j d theta).
    digits : int, optional
        Return balls of python-flint (``flint.arb``) that are correct to this many digits. Only for
        integer delays.

    Returns
    -------
    Extremum
        ``alpha`` = K T^2/m, ``beta`` = B T/m and ``theta`` = omega T, of the shape to which the
        arguments broadcast.  Without delay all angles are equally bad for this wall, and theta is
        pi/2.

    Raises
    ------
    ValueError
        If ``delta`` or ``delay`` is negative or infinite; NaN gives NaN.

    Notes
    -----
    For integer delays and with ``sheet="principal"`` this is the stable form of (11) of the paper,
    alpha = 2 delta tan(pi/(4 (delay + 1))).  For fractional delays the wall is derived in chapter
    s6f_stiffest_passive_wall.

    Examples
    --------
    >>> alpha, beta, theta = max_passive_stiffness(1.0, [0, 0.5, 1])
    >>> alpha.round(6).tolist(), beta.round(6).tolist()
    ([2.0, 1.175869, 0.828427], [0.0, 0.323979, 0.292893])
    """
    arguments.check_sheet(sheet)
    if digits is not None:
        return Extremum(
            *in_digits("max_passive_stiffness", digits, sheet, delta=delta, delay=delay)
        )

    def stiffest(xp: Any, damping: Any, late: Any) -> tuple[Any, Any, Any]:
        if sheet == "principal":
            theta = math.pi / (2 * (late + 1))
            unit = haptic.elementwise(xp, partial(_printed, xp), theta, late)
            alpha, beta = (damping * one for one in unit)
        else:
            alpha, beta, theta = given.kernel(haptic.max_passive_stiffness)(damping, late)
        beta = xp.where(late == 0, xp.zeros_like(beta), beta)  # exactly, not a difference
        return alpha, beta, theta + 0 * damping

    given = Given(delta=delta, delay=delay)
    return Extremum(*given(partial(stiffest, given.xp)))


def stiffest_passive_at(beta: Array, delta: float, delay: float) -> Extremum:
    """The largest stiffness of a passive wall with a given damping, and its worst angle.

    What a wall needs is a largest value of what motions need, each of which is linear in the wall:
    so the passive walls are convex, and those of one damping an interval.  With an integer delay
    the interval begins at no stiffness: the worst angle of a damper alone is 0 or pi/(d+1), and
    there a stiffness takes from the margin.  NaN if the damper alone is not passive, which is
    safe with other delays, too.
    """
    shape, beta = np.shape(beta), np.ravel(beta)
    most = float(max_passive_stiffness(delta, delay).alpha)

    def margin(alpha: Array) -> Array:
        return passivity_margin(alpha, beta, delta, delay)

    low, high = np.zeros_like(beta), np.full_like(beta, 2 * most)
    known = margin(low) >= 0
    for _ in range(64):
        middle = (low + high) / 2
        inside = margin(middle) >= 0
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    alpha, steps = np.where(known, low, np.nan), np.floor(np.full_like(beta, delay))
    psi = haptic.worst_angle(np, alpha, beta, steps, delay - steps)
    found = alpha, beta, np.where(known, 2 * psi, np.nan)
    return Extremum(*(one.reshape(shape) for one in found))
