"""Which damping does a stiffness need?  All that are stable, and the one with most spare delay."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from symhaptic.notation.quantities import in_unit, number, with_unit
from symhaptic.numeric import arguments
from symhaptic.numeric.containers import kept
from symhaptic.numeric.given import Given
from symhaptic.numeric.tracing.extremes import dampings_at
from symhaptic.numeric.tracing.margin import delay_margin
from symhaptic.scene.dimensionless import units
from symhaptic.scene.loop import DeviceLoop, wall_units

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Dampings(NamedTuple):
    """The damping with the largest delay margin for each of many stiffnesses, in SI units."""

    B: Any
    """Virtual damping in Ns/m, or N m s/rad of a rotary device; NaN if none makes a stable wall."""
    low: Any
    """The lower end of the interval of stable dampings that contains ``B``."""
    high: Any
    """Its upper end."""
    delay_margin: Any
    """The delay in s that may be added with ``B``; 0 if no damping makes a stable wall."""


class Damping(float):
    """A virtual damping in Ns/m or N m s/rad, with what is known of it."""

    K: float
    """The stiffness for which it is."""
    intervals: tuple[tuple[float, float], ...]
    """All dampings of stable walls of this stiffness: the ends of each interval, which are open."""
    delay_margin: float
    """The delay in s that may be added."""

    def __new__(
        cls, B: float, K: float, intervals: tuple[tuple[float, float], ...], delay_margin: float
    ) -> Damping:
        """A number with three more beside it."""
        self = super().__new__(cls, B)
        self.K, self.intervals, self.delay_margin = K, intervals, delay_margin
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return Damping, (float(self), self.K, self.intervals, self.delay_margin)


def damping_for(scene: DeviceLoop, K: Any) -> Damping | Dampings:
    """What :meth:`symhaptic.scene.scene.Scene.damping_for` returns."""
    stiff, damped = scene.unit("N/m"), scene.unit("N*s/m")
    if not (isinstance(K, list | tuple) or getattr(K, "ndim", None)):
        one = number("K", K, stiff)
        (found,) = _intervals(scene, np.asarray([one]))
        B, _, _, late = _best(scene, np.asarray([one]), [found])[:, 0]
        pairs = tuple((float(low), float(high)) for low, high in found)
        return Damping(float(B), one, pairs, float(late))

    def rows(stiffness: NDArray[np.float64]) -> NDArray[np.float64]:
        arguments.refuse("K", stiffness, ~np.isfinite(stiffness), "finite numbers")
        flat = stiffness.reshape(-1)
        return _best(scene, flat, _intervals(scene, flat)).reshape(4, *stiffness.shape)

    @kept(B=float, low=float, high=float, delay_margin=float)
    def answer(K: Any) -> Any:
        return Given(K=K).by_numpy(rows, 4)

    own = (damped, damped, damped, "s")
    found = answer(in_unit("K", K, stiff))
    return Dampings(*(with_unit(v, unit, K) for v, unit in zip(found, own, strict=True)))


def _intervals(scene: DeviceLoop, K: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """The stable dampings of each stiffness."""
    scale, _ = wall_units(scene)
    alphas = arguments.unitless("K", K, K * scale)
    unit = units(scene.coupled.mass, scene.sampling_period)[1]
    if scene.further:
        found = scene.engine.trace.dampings(alphas)
        return [unit * np.array(pairs).reshape(-1, 2) for pairs in found]
    return [unit * dampings_at(float(alpha), *scene.dimensionless) for alpha in alphas]


_GRID = np.arange(1, 32) / 32
"""Parts of an interval at which the delay margin is computed first."""

_ZOOMS = 3
"""Times that this is repeated between the neighbours of the best: by 16 each, to 1e-5."""


_Margins = Callable[["NDArray[np.float64]", "NDArray[np.float64]"], "NDArray[np.float64]"]


def _margins(scene: DeviceLoop) -> tuple[_Margins, _Margins]:
    """Delay margins in periods, and a faster function that is never less; NaN for a simulator."""
    if not scene.further:

        def exact(alpha: NDArray[np.float64], beta: NDArray[np.float64]) -> NDArray[np.float64]:
            return np.asarray(delay_margin(alpha, beta, *scene.dimensionless))

        return exact, exact
    if scene.integrator != "hold":
        return (lambda alpha, beta: np.full(beta.shape, np.nan),) * 2
    return scene.engine.delay_margin, scene.engine.most_delay


def _best(
    scene: DeviceLoop, K: NDArray[np.float64], intervals: list[NDArray[np.float64]]
) -> NDArray[np.float64]:
    """B, the ends of its interval and its delay margin, one column for each stiffness."""
    found = np.full((4, K.size), np.nan)
    found[3] = 0.0
    owner = np.repeat(np.arange(K.size), [len(pairs) for pairs in intervals])
    if not owner.size:
        return found
    low, high = np.concatenate(intervals).T
    stiff, damped = wall_units(scene)
    exact, fast = _margins(scene)
    alpha = stiff * K[owner]
    B, about = _largest(fast, alpha, damped, low, high)
    late = np.nan_to_num(exact(alpha, damped * B), nan=-1.0, posinf=np.inf)
    if not np.allclose(late, about, rtol=_ALIKE, atol=_ALIKE):
        B, late = _largest(exact, alpha, damped, low, high)
    B = np.where(late >= 0, B, (low + high) / 2)
    for i in np.lexsort((high - low, late)):  # the best interval of a stiffness comes last
        margin = late[i] * scene.sampling_period if late[i] >= 0 else np.nan
        found[:, owner[i]] = B[i], low[i], high[i], margin
    return found


def _largest(
    margins: _Margins,
    alpha: NDArray[np.float64],
    damped: float,
    low: NDArray[np.float64],
    high: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The damping of each interval with the largest margin, and this margin in periods."""
    row, begin, end = np.arange(low.size), low, high
    for _ in range(1 + _ZOOMS):
        B = begin[:, None] + (end - begin)[:, None] * _GRID
        late = margins(np.broadcast_to(alpha[:, None], B.shape), damped * B)
        late = np.nan_to_num(late, nan=-1.0, posinf=np.inf)
        best = np.argmax(late, axis=1)
        endless = np.isposinf(late)
        # of several that tolerate every delay, the middle one
        count = np.count_nonzero(endless, axis=1)
        middle = np.argmax(np.cumsum(endless, axis=1) > count[:, None] // 2, axis=1)
        best = np.where(count > 0, middle, best)
        edges = np.column_stack([begin, B, end])
        begin, end = edges[row, best], edges[row, best + 2]
    return B[row, best], late[row, best]


_ALIKE = 1e-9
"""By so much the fast margin of the best damping may differ from its exact one; otherwise the best
is sought once more by exact margins."""
