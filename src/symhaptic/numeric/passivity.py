r"""Passivity of a delayed wall in numbers, at a cost that does not grow with the delay.

At one angle :math:`\theta=2\psi` straight motions need the damping

.. math:: n = u\cot\psi\,\overline{\sin N\psi} - w\,\overline{\cos N\psi},\qquad
          u=\alpha/2,\ w=\beta+\alpha/2,

where the bars stand for the mean over the two whole delays beside :math:`\ell+\varepsilon`, with
:math:`N=2(\ell+1)` and :math:`2(\ell+2)` and the weights :math:`1-\varepsilon` and
:math:`\varepsilon`.  All motions together need :math:`\frac12(n+\sqrt{n^2+q})` with
:math:`q=4\varepsilon(1-\varepsilon)(u^2\cos^2\psi+w^2\sin^2\psi)`; chapter
s6d_fractional_passivity.  The worst angle lies below the first one at which wall and delay are in
phase, and there is one maximum up to there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symhaptic.kernels import haptic
from symhaptic.numeric import arguments
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.bracket import rising_root
from symhaptic.numeric.extremum import Extremum
from symhaptic.numeric.given import Given

SHEETS = ("exact", "principal")

_NEAR_ZERO = 1e-6
"""Share of the range of angles below which the worst angle is taken to be 0: what that changes
in the damping is of the order of its fourth power."""

_FLAT = 2.0**-27
"""Relative distance to which the worst angle is found: the need is flat there."""

_TERMS = 9
"""Of the series of x - sin x for x < 1: the next one is below 1/21! = 2e-20."""


class Delay(NamedTuple):
    """A delay of ``steps`` + ``part`` periods; 0 <= part < 1."""

    steps: Array
    part: Array

    @property
    def bound(self) -> Array:
        """An angle psi beyond the first at which wall and delay are in phase."""
        return np.asarray(np.pi / (2 * (self.steps + 1)))

    @property
    def mixed(self) -> Array:
        """4 part (1 - part), by which a motion that is not straight gains."""
        return np.asarray(4 * self.part * (1 - self.part))


class Need(NamedTuple):
    """What a wall needs at one angle."""

    total: Array
    slope: Array
    """Has the sign of the derivative with respect to psi."""
    damping: Array
    """Has the sign of the derivative with respect to beta."""


def split(delay: Array, sheet: str) -> Delay:
    """The delay as whole and fraction; on the principal sheet all of it counts as whole."""
    steps = delay if sheet == "principal" else np.floor(delay)
    return Delay(steps, delay - steps)


def _gap(x: Array) -> Array:
    """x - sin x, without cancellation."""
    small = np.abs(x) < 1
    square = np.where(small, x, 0.0) ** 2
    series = np.ones_like(square)
    for k in range(_TERMS, 1, -1):
        series = 1 - square * series / ((2 * k) * (2 * k + 1))
    return np.where(small, x * square * series / 6, x - np.sin(x))


def _straight(u: Array, w: Array, steps: Array, psi: Array) -> tuple[Array, Array, Array]:
    """What straight motions need at a whole delay, its derivative, and cos(N psi)."""
    order = 2 * (steps + 1)
    x, sine, cosine = order * psi, np.sin(psi), np.cos(psi)
    up, along = np.sin(x), np.cos(x)
    # (N/2) sin 2 psi cos x - sin x, for small x from x - sin x
    near = _gap(x) - order / 2 * _gap(2 * psi) * along - 2 * x * np.sin(x / 2) ** 2
    turn = np.where(x < 1, near, order * sine * cosine * along - up)
    slope = u * turn / sine**2 + w * order * up
    return u * cosine / sine * up - w * along, slope, along


def _need(u: Array, w: Array, delay: Delay, psi: Array) -> Need:
    """The need at an angle 0 < psi <= pi/2."""
    early, late = (_straight(u, w, steps, psi) for steps in (delay.steps, delay.steps + 1))
    n, slope, along = (a + delay.part * (b - a) for a, b in zip(early, late, strict=True))
    sine, cosine = np.sin(psi), np.cos(psi)
    size = (u * cosine) ** 2 + (w * sine) ** 2
    extra = delay.mixed * size
    # root - |n| without cancellation, and from it root - n and root + n
    root = np.sqrt(n**2 + extra)
    sum_ = root + np.abs(n)
    rest = extra / np.where(sum_ > 0, sum_, 1.0)
    less, more = np.where(n > 0, rest, sum_), np.where(n > 0, sum_, rest)
    grows = (w - u) * (w + u) * sine * cosine / np.where(size > 0, size, 1.0)
    return Need(more / 2, slope + grows * less, delay.mixed * w * sine**2 - along * more)


def _at_zero(u: Array, w: Array, delay: Delay) -> Array:
    """The limit of the need for psi -> 0."""
    n = 2 * u * (delay.steps + delay.part + 1) - w
    return np.asarray((n + np.sqrt(n**2 + delay.mixed * u**2)) / 2)


def _in_phase(u: Array, w: Array, delay: Delay) -> Array:
    """An angle psi at which wall and delay are in phase; no larger one needs more damping."""

    def beyond(psi: Array) -> Array:
        part, double = delay.part, 2 * psi
        late = np.arctan2(part * np.sin(double), 1 - part + part * np.cos(double))
        own = np.arctan2(u * np.cos(psi), w * np.sin(psi))
        return (2 * (delay.steps + 1) * psi - np.pi) + late + own

    return rising_root(beyond, np.zeros_like(u), delay.bound, _FLAT)


def _worst(u: Array, w: Array, delay: Delay) -> tuple[Array, Array]:
    """The largest need of a wall with u >= 0, and its angle psi."""
    low = _NEAR_ZERO * delay.bound
    if np.any(delay.part > 0):
        high = np.maximum(_in_phase(u, w, delay), low)
        psi = rising_root(lambda x: -_need(u, w, delay, x).slope, low, high, _FLAT)
        inner = _need(u, w, delay, psi).total
    else:

        def falls(x: Array) -> Array:
            return -_straight(u, w, delay.steps, x)[1]

        psi = rising_root(falls, low, delay.bound, _FLAT)
        inner = _straight(u, w, delay.steps, psi)[0]
    zero = _at_zero(u, w, delay)
    flat = (psi <= low) | (zero >= inner)
    return np.where(flat, zero, inner), np.where(flat, 0.0, psi)


def _largest_need(alpha: Array, beta: Array, steps: Array, part: Array) -> Array:
    """The damping against which no motion extracts energy; infinite for a pulling wall."""
    u, w = alpha / 2, beta + alpha / 2
    size = np.hypot(u, w)
    scale = np.where(size > 0, size, 1.0)
    pulls = alpha < 0
    need, _ = _worst(np.where(pulls, 0.0, u / scale), w / scale, Delay(steps, part))
    return np.where(pulls, np.inf, size * need)


def passivity_margin(
    alpha: ArrayLike, beta: ArrayLike, delta: ArrayLike, delay: ArrayLike, sheet: str = "exact"
) -> Array:
    r"""Physical damping minus the damping that the wall needs at its worst angle.

    For the wall ``alpha`` = K T^2/m, ``beta`` = B T/m, the damping ``delta`` = b T/m >= 0 and
    ``delay`` >= 0 periods, whole or fractional; arrays broadcast.  No motion whatever extracts
    energy where the margin is not negative.  A wall with ``alpha`` < 0 gives away more the farther
    it is pushed, and no damping is enough: its margin is -inf.  With ``sheet="principal"`` the
    damping that (5) of the paper asks for; both agree for whole delays.  Derived in chapter
    s6d_fractional_passivity.

    Raises :class:`ValueError` for an infinite wall, a negative or infinite ``delta`` or ``delay``;
    NaN gives NaN.

    >>> [round(float(x), 6) for x in passivity_margin(1.0, 0.0, 1.0, [0, 0.5, 1])]
    [0.5, -0.059017, -0.5]
    """
    arguments.one_of("sheet", sheet, SHEETS)
    given = Given(alpha=alpha, beta=beta, delta=delta, delay=delay)

    def margin(al: Array, be: Array, dl: Array, dy: Array) -> list[Array]:
        need = arguments.in_blocks(
            lambda *block: [_largest_need(*block)], al, be, *split(dy, sheet)
        )
        return [dl - need[0]]

    return given.by_numpy(margin)[0]  # type: ignore[no-any-return]


def is_passive(
    alpha: ArrayLike, beta: ArrayLike, delta: ArrayLike, delay: ArrayLike, sheet: str = "exact"
) -> NDArray[np.bool_]:
    """Whether no motion can extract energy: the margin is not negative, and NaN is not passive.

    On the boundary no motion gains energy either; the strict sign of the paper's (4) leaves it
    out.  Arguments and errors as for :func:`passivity_margin`.

    >>> is_passive([1.9, 2.1, -0.1], 0.0, 1.0, 0).tolist()
    [True, False, False]
    """
    return passivity_margin(alpha, beta, delta, delay, sheet) >= 0


# -- the boundary --------------------------------------------------------------------------


def _envelope(psi: Array, delay: Delay) -> tuple[Array, Array]:
    """(u, w) of (27), over the damping, for a whole delay or a real one on the principal sheet.

    u = 2 N sin^2(psi) sin(N psi)/D and w = (2 sin(N psi) - N sin(2 psi) cos(N psi))/D with
    D = N sin(2 psi) - sin(2 N psi); for N = 2 they are 1 at every angle.
    """
    order = 2 * (delay.steps + 1)
    x, late = order * psi, order * _gap(2 * psi)
    below = _gap(2 * x) - late
    chord = 4 * x * np.sin(x / 2) ** 2 - 2 * _gap(x) + late * np.cos(x)
    free = order == 2
    with np.errstate(divide="ignore", invalid="ignore"):
        u = 2 * order * np.sin(psi) ** 2 * np.sin(x) / below
        w = chord / below
    return np.where(free, 1.0, u), np.where(free, 1.0, w)


def _touched(psi: Array, delay: Delay) -> tuple[Array, Array]:
    """(u, w) of the wall whose worst angle is psi, over the damping; NaN if there is none."""
    quarter = np.full(np.broadcast_shapes(psi.shape, delay.steps.shape), np.pi / 2)

    def slope(turn: Array) -> Array:
        return _need(np.cos(turn), np.sin(turn), delay, psi).slope

    turn = rising_root(slope, 0 * quarter, quarter)  # a wall with w < 0 is worst at psi = 0
    u, w = np.cos(turn), np.sin(turn)
    need = np.where(turn < quarter, _need(u, w, delay, psi).total, np.nan)
    return u / need, w / need


def _boundary(omega: Array, delta: Array, steps: Array, part: Array) -> Array:
    psi, delay = omega / 2, Delay(steps, part)
    u, w = _envelope(psi, delay)
    if np.any(part > 0):
        late = part > 0
        exact = _touched(psi, delay)
        u, w = np.where(late, exact[0], u), np.where(late, exact[1], w)
    return np.stack(np.broadcast_arrays(2 * delta * u, delta * (w - u)))


def passivity_boundary(
    omega: ArrayLike, delta: ArrayLike, delay: ArrayLike, sheet: str = "exact"
) -> tuple[Array, Array]:
    """The wall (alpha, beta) that is just passive, and whose worst angle is ``omega`` = omega T.

    For 0 < ``omega`` < pi, ``delta`` >= 0 and ``delay`` >= 0; arrays broadcast.  For whole delays
    and with ``sheet="principal"`` this is (27) of the paper, which bounds nothing beyond
    pi/(delay + 1); for fractional delays it is NaN beyond the angle where the stiffness vanishes.
    At omega -> 0 there is more boundary, from (0, -delta) to the limit of this curve: all walls
    with worst angle 0, on alpha (delay + 1/2) + e alpha^2/(4 delta) = delta + beta with
    e = part (1 - part) for the fractional part of the delay.

    Raises :class:`ValueError` for an angle, damping or delay outside its range; NaN gives NaN.

    >>> alpha, beta = passivity_boundary([0.5, 1.0], 1.0, 1)
    >>> alpha.round(6).tolist(), beta.round(6).tolist()
    ([0.817217, 0.811125], [0.232804, 0.375311])
    """
    arguments.one_of("sheet", sheet, SHEETS)
    given = Given(omega=omega, delta=delta, delay=delay)
    if sheet == "principal" or given.whole(given.values[2]):
        alpha, beta = given(haptic.passivity_boundary)
    else:
        alpha, beta = given.by_numpy(_by_delay(_boundary), 2)
    return alpha, beta


def _by_delay(work: Callable[..., Array]) -> Callable[..., Array]:
    """A function of the delay from one of whole periods and the rest, on pieces."""

    def found(*values: Array) -> Array:
        *others, delay = values
        return arguments.in_blocks(work, *others, *split(delay, "exact"))

    return found


def _stiffest(delta: Array, steps: Array, part: Array) -> Array:
    """(alpha, beta, theta) of the largest passive stiffness."""
    delay = Delay(steps, part)
    psi = np.pi / (4 * (steps + 1))
    u, share = np.tan(psi), steps / (steps + 1)
    # cos 2 psi - d/(d + 1), for large d without the difference of two numbers near 1
    far = 1 / (steps + 1) - 2 * np.sin(psi) ** 2
    damping = np.where(steps < 1, np.sin(np.pi / 2 * share) - share, far) / np.sin(2 * psi)
    if np.any(part > 0):
        late = part > 0

        def favours(angle: Array) -> Array:
            """Whether less damping would need less at this angle's wall."""
            wall = _touched(angle, delay)
            gone = np.isnan(wall[0])
            u, w = np.where(gone, 0.0, wall[0]), np.where(gone, 1.0, wall[1])
            return _need(u, w, delay, angle).damping

        high = np.pi / (2 * (steps + part + 1))
        exact = rising_root(favours, _NEAR_ZERO * high, high)
        wall = _touched(exact, delay)
        psi, u = np.where(late, exact, psi), np.where(late, wall[0], u)
        damping = np.where(late, wall[1] - wall[0], damping)
    return np.stack(np.broadcast_arrays(2 * delta * u, delta * damping, 2 * psi + 0 * delta))


def max_passive_stiffness(delta: ArrayLike, delay: ArrayLike, sheet: str = "exact") -> Extremum:
    r"""The passive wall of largest stiffness, and its worst angle.

    For whole delays and with ``sheet="principal"`` (11) of the paper, alpha =
    2 delta tan(pi/(4 (delay + 1))), in its stable form; arrays broadcast.  Without delay every
    angle is equally bad for this wall, and theta is pi/2.

    Raises :class:`ValueError` for a negative or infinite damping or delay; NaN gives NaN.

    >>> alpha, beta, theta = max_passive_stiffness(1.0, [0, 0.5, 1])
    >>> alpha.round(6).tolist(), beta.round(6).tolist()
    ([2.0, 1.175869, 0.828427], [0.0, 0.323979, 0.292893])
    """
    arguments.one_of("sheet", sheet, SHEETS)
    given = Given(delta=delta, delay=delay)
    if sheet == "principal" or given.whole(given.values[1]):
        alpha, beta, theta = given(haptic.max_passive_stiffness)
        undelayed = (given.values[1] == 0) & given.xp.isfinite(beta)  # exactly 0, not a difference
        return Extremum(alpha, given.xp.where(undelayed, given.xp.zeros_like(beta), beta), theta)
    return Extremum(*given.by_numpy(_by_delay(_stiffest), 3))
