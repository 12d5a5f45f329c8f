"""The walls that no arm of a range makes unstable, in N/m and Ns/m, as a proved result.

The mathematics is in :mod:`symhaptic.bounds.safe`; nothing is proved here.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from symhaptic.bounds.safe.arms import Loops
from symhaptic.bounds.safe.check import Certificate, recheck
from symhaptic.bounds.safe.delay import borne, guessed
from symhaptic.bounds.safe.find import certified
from symhaptic.bounds.safe.passive import is_passive, passive
from symhaptic.notation.quantities import decimal, in_unit, number, shown
from symhaptic.numeric import arguments
from symhaptic.scene.arms import Arm, ArmRange, checked_range
from symhaptic.scene.loop import DeviceLoop
from symhaptic.scene.picture import (
    EDGE,
    PASSIVE,
    STABLE,
    digits,
    explicit_boundary,
    finish,
    mark,
    new_axes,
)
from symhaptic.scene.walls import max_stable_stiffness
from symhaptic.scene.words import table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray


Arms = ArmRange | Arm | Iterable[Arm] | None
"""A range of arms, one, some of them and all between, or by (23) of the paper."""

_TRIED = 12
"""Dampings that are compared for the best of them."""


class Rectangle(NamedTuple):
    """All walls of two ranges are safe."""

    K: tuple[float, float]
    """The lowest and the highest stiffness in N/m."""
    B: tuple[float, float]
    """The lowest and the highest damping in Ns/m."""


class Best(NamedTuple):
    """The damping with the largest delay margin for one stiffness."""

    B: float
    """Virtual damping in Ns/m."""
    safe: tuple[float, float]
    """The range of dampings in Ns/m with which the stiffness is safe."""
    delay_margin: float
    """Estimated delay margin in s, from some arms; :meth:`SafeWalls.delay_margin` proves one."""


@dataclass(frozen=True)
class SafeWalls:
    """The walls that are proved to be stable for every arm of a range.

    For each virtual damping B in Ns/m from 0 on, all stiffnesses K in N/m from nearly 0 up to a
    limit.  The limits hold for whole columns, from one damping to the next, and are proved by
    balls; what is left out beside them is about a hundredth.
    """

    scene: DeviceLoop
    """The device without an arm."""
    arms: ArmRange
    certificate: Certificate = field(repr=False)
    passive_corners: tuple[tuple[float, float], ...] = field(repr=False)
    """(K, B) of passive walls; by (3) those between them are passive, whatever arm there is."""

    @cached_property
    def _edges(self) -> NDArray[np.float64]:
        return np.array(self.certificate.columns.edges)

    @cached_property
    def _tops(self) -> NDArray[np.float64]:
        return np.array(self.certificate.columns.tops)

    @property
    def _units(self) -> tuple[str, str]:
        """Units of K and B, as they are printed."""
        return self.scene.printed("N/m"), self.scene.printed("N*s/m")

    def _wall(self, K: Any, B: Any) -> tuple[float, float]:
        return number("K", K, self.scene.unit("N/m")), number("B", B, self.scene.unit("N*s/m"))

    def limit_at(self, B: Any) -> Any:
        """The largest stiffness in N/m that is proved safe with the damping ``B`` in Ns/m.

        0 where none is, NaN for NaN.  Arrays are welcome.
        """
        B = arguments.real("B", in_unit("B", B, self.scene.unit("N*s/m")))
        last = len(self._tops) - 1
        found = np.where(np.isnan(B), np.nan, 0.0)
        sides: tuple[Literal["left", "right"], ...] = ("left", "right")
        for side in sides:  # an edge belongs to the columns on both sides of it
            at = np.searchsorted(self._edges, B, side=side) - 1
            inside = (at >= 0) & (at <= last)
            found = np.maximum(found, np.where(inside, self._tops[np.clip(at, 0, last)], 0.0))
        return float(found) if found.ndim == 0 else found

    def contains(self, K: Any, B: Any) -> Any:
        """Whether walls of ``K`` in N/m and ``B`` in Ns/m are proved stable for every arm.

        ``False`` says that nothing is proved, and so do NaN and infinite numbers.
        """
        K = arguments.real("K", in_unit("K", K, self.scene.unit("N/m")))
        found = (self.softest <= K) & (self.limit_at(B) >= K)
        return bool(found) if np.ndim(found) == 0 else found

    def is_passive(self, K: Any, B: Any) -> Any:
        """Whether walls are proved passive, and so for every arm that is."""
        from shapely import MultiPoint, intersects_xy

        K = arguments.real("K", in_unit("K", K, self.scene.unit("N/m")))
        B = arguments.real("B", in_unit("B", B, self.scene.unit("N*s/m")))
        hull = MultiPoint(self.passive_corners).convex_hull
        found = intersects_xy(hull, *np.broadcast_arrays(K, B))
        return bool(found) if np.ndim(found) == 0 else found

    @property
    def softest(self) -> float:
        """The softest wall that is proved, in N/m; 0 itself holds nothing without a spring."""
        return self.certificate.columns.low

    @cached_property
    def stiffest(self) -> tuple[float, float]:
        """K in N/m and B in Ns/m of the stiffest safe wall."""
        i = int(np.argmax(self._tops))
        return float(self._tops[i]), float((self._edges[i] + self._edges[i + 1]) / 2)

    @cached_property
    def stiffest_passive(self) -> tuple[float, float] | None:
        """K in N/m and B in Ns/m of the stiffest wall that is proved passive."""
        return max(self.passive_corners, default=None)

    @cached_property
    def area(self) -> float:
        """Of the safe walls, in N^2 s/m^2."""
        return float(self._tops @ np.diff(self._edges))

    @cached_property
    def rectangle(self) -> Rectangle:
        """The largest rectangle of safe walls: K and B may be chosen apart from each other."""
        best, found = 0.0, (0.0, (0, 0))
        for first in range(len(self._tops)):
            height = np.inf
            for last in range(first, len(self._tops)):
                height = min(height, self._tops[last])
                size = height * (self._edges[last + 1] - self._edges[first])
                if size > best:
                    best, found = size, (float(height), (first, last + 1))
        height, (first, after) = found
        return Rectangle(
            (self.softest, height), (float(self._edges[first]), float(self._edges[after]))
        )

    def best_damping(self, K: float) -> Best:
        """The damping with the largest delay margin for the stiffness ``K`` in N/m.

        Raises :class:`ValueError` if no damping makes this stiffness safe.
        """
        K = number("K", K, self.scene.unit("N/m"))
        (safe,) = np.nonzero((self._tops >= K) & (self.softest <= K))
        if not len(safe):
            raise ValueError(
                f"K: {K!r} is not allowed; give {self.softest:.3g} to {self.stiffest[0]:.6g} "
                f"{self._units[0]}"
            )
        gap = np.nonzero(np.diff(safe) > 1)[0]
        run = max(np.split(safe, gap + 1), key=len)
        low, high = float(self._edges[run[0]]), float(self._edges[run[-1] + 1])
        tried = np.linspace(low, high, _TRIED)
        loops = self.certificate.loops
        late = [guessed(loops, K, float(B)) for B in tried]
        best = int(np.argmax(late))
        spare = (late[best] - float(loops.periods[0])) * float(loops.period)
        return Best(float(tried[best]), (low, high), spare)

    def delay_margin(self, K: float, B: float) -> float:
        """Delay in s that may be added with every arm for the wall ``K`` (N/m), ``B`` (Ns/m).

        A proved lower bound of the smallest delay margin of all arms.  The wall is stable for
        every delay from the scene's own to that plus the margin.  Raises :class:`ValueError` for a
        wall that is not proved safe.
        """
        K, B = self._wall(K, B)
        if not self.contains(K, B):
            raise ValueError(f"K: {K!r} with B={B!r} is not proved safe")
        loops = self.certificate.loops
        at, _ = borne(loops, K, B)
        return float((at - loops.periods[0]) * loops.period)

    def recheck(self) -> bool:
        """Whether the second check confirms all of it: the walls, and the passive corners.

        The certificate has to be one of this device, with these arms.
        """
        loops = self.certificate.loops
        return (
            loops == _loops(self.scene, self.arms)
            and recheck(self.certificate)
            and all(is_passive(loops, wall) for wall in self.passive_corners)
        )

    @cached_property
    def outline(self) -> NDArray[np.float64]:
        """Corners of the safe walls, one row (K, B) each, of the largest run of columns."""
        run = max(self.certificate.columns.runs(), key=len)
        B = np.repeat(self._edges[run.start : run.stop + 1], 2)[1:-1]
        K = np.repeat(self._tops[run.start : run.stop], 2)
        low = self.softest
        corners = np.column_stack([K, B])
        return np.vstack([[low, B[0]], corners, [low, B[-1]], [low, B[0]]])

    def __str__(self) -> str:
        """In words."""
        facts = self.facts()
        lines = [f"proved for every arm of {facts.pop('arms')}:"]
        return "\n".join(lines + [f"  {name:<14} {said}" for name, said in facts.items()])

    def plot(self, axes: Axes | None = None) -> Axes:
        """Safe and passive walls over B in Ns/m, with the largest rectangle.

        Draws into ``axes`` of matplotlib's, or into new ones, and returns them.
        """
        axes = axes if axes is not None else new_axes("SafeWalls.plot")
        draw_safe(axes, self)
        return axes

    def _repr_html_(self) -> str:
        return table(self.facts())

    def facts(self) -> dict[str, str]:
        """What there is to say, in words with units."""
        (K, B), box, free = self.stiffest, self.rectangle, self.limit_at(0.0)
        in_K, in_B = self._units
        found = {
            "arms": str(self.arms),
            "stable up to": f"{K:.5g} {in_K} with B = {B:.4g} {in_B}",
            "without B": f"{free:.4g} {in_K}" if free > 0 else "nothing",
            "any wall of": f"{box.K[0]:.2g} to {box.K[1]:.5g} {in_K} "
            f"with {box.B[0]:.4g} to {box.B[1]:.4g} {in_B}",
            "passive up to": "nothing",
        }
        if self.stiffest_passive:
            K, B = self.stiffest_passive
            found["passive up to"] = f"{K:.5g} {in_K} with B = {B:.4g} {in_B}"
        return found


def _range(arm: Arms) -> ArmRange:
    """The range that is meant."""
    if arm is None:
        return ArmRange()
    if isinstance(arm, ArmRange):
        return arm
    some = [arm] if isinstance(arm, Arm) else list(arm) if isinstance(arm, Iterable) else []
    if not some or not all(isinstance(one, Arm) for one in some):
        allowed = "an ArmRange(...), an Arm(...) or several of them"
        raise ValueError(f"arm: {shown(arm)} is not allowed; give {allowed}")
    return ArmRange.around(some)


def safe_walls(scene: DeviceLoop, arm: Arms) -> SafeWalls:
    """What :meth:`symhaptic.scene.scene.Scene.safe_walls` returns."""
    if scene.arm is not None:
        if arm is not None:
            raise ValueError(
                f"arm: {shown(arm)} would be a second arm beside the scene's {scene.arm!r}; "
                "use scene.device.safe_walls(...) for another arm"
            )
        scene, arm = scene.device, scene.arm
    arms = checked_range(_range(arm), scene.rotary)
    loops = _loops(scene, arms)
    return SafeWalls(scene, arms, certified(loops), passive(loops))


def _loops(scene: DeviceLoop, arms: ArmRange) -> Loops:
    """The loops of a device with all arms of a range, in exact numbers."""
    return Loops(
        decimal(scene.mass_or_inertia),
        decimal(scene.damping or 0.0),
        decimal(scene.stiffness or 0.0),
        decimal(scene.sampling_period),
        (scene.periods, scene.periods),
        tuple((decimal(low), decimal(high)) for low, high in arms.hands),  # type: ignore[arg-type]
        arms.by_mass,
    )


def draw_safe(axes: Axes, safe: SafeWalls, wall: tuple[float, float] | None = None) -> None:
    """Walls that every arm of a range keeps stable, with their largest rectangle, passive ones.

    The border of the stable walls of the device without an arm is drawn beside them.
    """
    outline, box = safe.outline, safe.rectangle
    axes.fill(outline[:, 0], outline[:, 1], color=STABLE, lw=0, label="stable with every arm")
    alone = safe.scene
    most = max_stable_stiffness(alone)
    high = {
        "K": 1.12 * max(most.K, safe.stiffest[0], wall[0] if wall else 0.0),
        "B": 1.05 * max(2 * most.B, outline[:, 1].max(), wall[1] if wall else 0.0),
    }
    K, B = explicit_boundary(alone)
    far = {name: 2 * end for name, end in high.items()}
    seen = (K > 0) & (far["K"] > K) & (abs(B) < far["B"])
    axes.plot(
        np.where(seen, K, np.nan), np.where(seen, B, np.nan),
        color=EDGE, lw=1.3, label="border without an arm",
    )  # fmt: skip
    (low, top), (left, right) = box
    in_K, in_B = safe._units
    axes.plot(
        [low, low, top, top, low], [left, right, right, left, left],
        color="black", lw=1, ls="--",
        label=f"{digits(top)} {in_K} with {left:.3g} to {right:.3g} {in_B}",
    )  # fmt: skip
    if safe.passive_corners:
        corners = np.array(safe.passive_corners)
        axes.fill(corners[:, 0], corners[:, 1], color=PASSIVE, lw=0, label="passive")
        stiff = safe.stiffest_passive
        if stiff and stiff[0] < 0.02 * high["K"]:
            axes.plot(*stiff[:2], "d", ms=5, color=PASSIVE, zorder=3, clip_on=False)
    if wall is not None:
        mark(axes, alone, wall, bool(safe.contains(*wall)))
    axes.set(xlim=(0, high["K"]), ylim=(0, high["B"]))
    finish(axes, in_K, in_B)
