"""Pictures of sweeps, one call each: without units inside the paper's (23), or for one's own scene.

Each returns Matplotlib's figure; ``figure.savefig("walls.png")`` keeps it.  They are drawn from
points of a grid, which show, and prove nothing; ``Scene.simplest`` proves.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from numbers import Integral
from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.notation.extras import needed
from symhaptic.notation.quantities import shown
from symhaptic.numeric.column import legend_below
from symhaptic.scene.dimensionless import units
from symhaptic.scene.loop import together
from symhaptic.scene.picture import EDGE, PASSIVE, STABLE, UNSTABLE
from symhaptic.sweeps.axes import scene_or_none
from symhaptic.sweeps.drawing import figure_and_axes, filled, in_ms, labelled, plain, said
from symhaptic.sweeps.quantities import IN_SI, INPUTS, in_si
from symhaptic.sweeps.sweep import sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from symhaptic.scene.scene import Scene

Range = tuple[float, float]
"""From the lowest to the highest."""

STIFF, DAMPED = (0.0, 0.001), (0.0, 0.02)
"""gamma and delta of the paper's (23)."""

_ALL = 7
"""Arms along each of stiffness and damping."""


def robust_limits(
    scene: Scene | None = None,
    *,
    stiffness: Range | None = None,
    damping: Range | None = None,
    delay: float | None = None,
    points: int = 200,
) -> Figure:
    """Which walls are stable for every arm of a range, and which for some of them only.

    ``stiffness`` in N/m and ``damping`` in Ns/m are the ends of the range, all of the device beside
    the arm included.  Without a ``scene`` they are gamma and delta, those of the paper's (23) where
    they are not given, and ``delay`` is in periods (1 where it is not).

    >>> figure = robust_limits(points=20)
    """
    scene = _begun("robust_limits", scene)
    names = ("alpha", "beta", "gamma", "delta") if scene is None else _SI
    late: dict[str, Any] = {} if delay is None else {"delay": delay}
    if scene is None:
        late = {"delay": 1.0 if delay is None else delay}
    arms, points = _arms(scene, stiffness, damping), _enough(points)
    far = sweep("max_stable_stiffness", scene, over=names[2:], reduce="max", **arms, **late)
    far = far.rename(alpha="K", beta="B") if scene is None else far
    most, wide = 1.12 * float(far.K), 2.3 * float(far.B)
    walls: dict[str, Any] = {
        names[0]: np.linspace(-0.06 * most, most, points),
        names[1]: np.linspace(-0.12 * wide, wide, points),
    }
    found = sweep(
        "is_stable", scene, over=names[2:], reduce=("all", "any"), **walls, **arms, **late
    )
    figure, axes = figure_and_axes()
    x, y = found[names[0]], found[names[1]]
    count = len(arms[names[2]]) * len(arms[names[3]])
    shown = (
        ("any", "#f3dfb0", "stable for some of them only"),
        ("all", STABLE, f"stable for all of {count} arms" if count > 1 else "stable"),
    )
    for word, colour, label in shown:
        values = found[f"is_stable_{word}"].astype(float).T
        axes.contourf(x, y, values, levels=[0.5, 1.5], colors=[colour])
        axes.contour(x, y, values, levels=[0.5], colors=[EDGE], linewidths=0.8)
        axes.fill([], [], color=colour, label=label)
    axes.axhline(0, color="black", lw=0.5)
    axes.axvline(0, color="black", lw=0.5)
    labelled(axes, x, y)
    axes.set_title(_range(scene, arms), fontsize=7, loc="left")
    legend_below(axes)
    return figure


def stiffest(
    scene: Scene | None = None,
    *,
    delay: Range | None = None,
    damping: Range | None = None,
    points: int = 160,
) -> Figure:
    """The largest stable stiffness over delay and physical damping.

    ``delay`` in s and ``damping`` in Ns/m are the ends of the axes, the default four periods and
    all up to twice the scene's own damping.  Without a ``scene`` alpha over d and delta, of the
    paper's (23).

    >>> figure = stiffest(points=20)
    """
    scene = _begun("stiffest", scene)
    fixed: dict[str, Any] = {}
    if scene is None:
        axes_of = {"delay": delay or (0.0, 4.0), "delta": damping or DAMPED}
        fixed, name = {"gamma": 0.0}, "alpha"
    else:
        own = scene.damping or units(scene.mass_or_inertia, scene.sampling_period)[1] / 100
        period = scene.sampling_period
        axes_of = {"delay": delay or (0.0, 4 * period), "damping": damping or (0.0, 2 * own)}
        name = "K"
    lines: dict[str, Any] = {n: _line(n, e, _enough(points)) for n, e in axes_of.items()}
    found = sweep("max_stable_stiffness", scene, **lines, **fixed)
    x, y = (found[n] for n in lines)
    values = found[name].transpose(*reversed(lines))
    figure, axes = figure_and_axes()
    across = in_ms(x)
    filled(figure, axes, across, y, values, said(found[name]))
    labelled(axes, across, y)
    return figure


def delay_margin(
    scene: Scene | None = None, *, K: Range | None = None, B: Range | None = None, points: int = 100
) -> Figure:
    """Delay margin of walls: the delay that may be added to that of the scene.

    ``K`` in N/m and ``B`` in Ns/m are the ends of the axes, by default those of all walls that are
    stable with half a period of added delay.  Without a ``scene``, alpha and beta of a free mass
    with the mean damping of the paper's (23), without delay, and margins in periods.

    >>> figure = delay_margin(points=12)
    """
    scene = _begun("delay_margin", scene)
    names = ("alpha", "beta") if scene is None else ("K", "B")
    fixed: dict[str, Any] = {"gamma": 0.0, "delta": 0.01} if scene is None else {}
    later: dict[str, Any] = {"delay": 0.5}
    if scene is not None:
        later = {"delay_samples": float(scene.periods) + 0.5}
    far = sweep("max_stable_stiffness", scene, **fixed, **later)
    high = (float(far[names[0]]), 2.2 * float(far[names[1]]))
    ends = {"K": K or (0.0, high[0]), "B": B or (0.0, high[1])}
    lines = (_line(name, e, _enough(points)) for name, e in ends.items())
    walls: dict[str, Any] = dict(zip(names, lines, strict=True))
    found = sweep("delay_margin", scene, **walls, **fixed)
    x, y = found[names[0]], found[names[1]]
    margin = in_ms(found.delay_margin).transpose(names[1], names[0])
    figure, axes = figure_and_axes()
    filled(figure, axes, x, y, margin, said(margin))
    lost = (margin == 0).astype(float)
    axes.contourf(x, y, lost, levels=[0.5, 1.5], colors=["#dddddd"])
    axes.fill([], [], color="#dddddd", label="not stable")
    ever = np.isinf(margin).astype(float)
    if bool(ever.any()):
        axes.contourf(x, y, ever, levels=[0.5, 1.5], colors=[PASSIVE])
        axes.fill([], [], color=PASSIVE, label="stable with any delay")
    labelled(axes, x, y)
    legend_below(axes)
    return figure


def model_costs(
    scene: Scene | None = None,
    *,
    stiffness: Range | None = None,
    damping: Range | None = None,
    delays: Sequence[float] | None = None,
) -> Figure:
    """How far off the largest stable stiffness is where parts of the loop are left out.

    The largest error over a range of arms, at each of some ``delays`` (in s; in periods without a
    ``scene``).  ``stiffness`` and ``damping`` are the ends of the range as in
    :func:`robust_limits`.

    >>> figure = model_costs(delays=[0, 1])
    """
    scene = _begun("model_costs", scene)
    from matplotlib.ticker import LogFormatter

    period = 1.0 if scene is None else scene.sampling_period
    names = ("gamma", "delta") if scene is None else _SI[2:]
    arms = _arms(scene, stiffness, damping)
    late = np.asarray(delays if delays is not None else period * np.linspace(0, 8, 33))
    name = "alpha" if scene is None else "K"
    full = sweep("max_stable_stiffness", scene, **arms, delay=late)
    figure, axes = figure_and_axes()
    across = in_ms(full.delay)
    parts = (
        ("without spring", names[:1], EDGE, "-"),
        ("without damper", names[1:], PASSIVE, "-"),
        ("with neither", names, UNSTABLE, "--"),
    )
    for says, left_out, colour, line in parts:
        kept: dict[str, Any] = {n: 0.0 if n in left_out else v for n, v in arms.items()}
        less = sweep("max_stable_stiffness", scene, **kept, delay=late)
        error = 100 * abs(less[name] / full[name] - 1).max(names)
        axes.plot(across, error, color=colour, linestyle=line, label=says)
    axes.set(yscale="log")
    axes.yaxis.set_major_formatter(plain)
    axes.yaxis.set_minor_formatter(LogFormatter())  # a narrow range, and without powers of ten
    axes.set(xlim=(float(across.min()), float(across.max())))
    axes.set(xlabel=said(across), ylabel="largest error of the stiffest wall in %")
    axes.set_title(_range(scene, arms), fontsize=7, loc="left")
    legend_below(axes, 3)
    return figure


_SI = ("K", "B", "stiffness", "damping")


def _arms(scene: Scene | None, stiffness: Range | None, damping: Range | None) -> dict[str, Any]:
    """Springs and dampers of a range: the paper's, or from none to those of the scene."""
    names = ("gamma", "delta") if scene is None else _SI[2:]
    paper = (STIFF, DAMPED) if scene is None else (_own(scene, _SI[2]), _own(scene, _SI[3]))
    given = {"stiffness": stiffness or paper[0], "damping": damping or paper[1]}
    lines = (np.unique(_line(name, ends, _ALL)) for name, ends in given.items())
    return dict(zip(names, lines, strict=True))


def _line(name: str, ends: Range, points: int) -> NDArray[Any]:
    """Points from the one end of a range to the other."""
    pair = isinstance(ends, tuple | list | np.ndarray) and len(ends) == 2
    rising = False
    with suppress(TypeError):
        rising = pair and bool(ends[0] <= ends[1])
    if not rising:
        raise ValueError(f"{name}: {shown(ends)} is not allowed; give (lowest, highest)")
    return np.linspace(*ends, points)


def _enough(points: int) -> int:
    """So many that there is an area between them."""
    if not isinstance(points, Integral) or points < 2:
        raise ValueError(f"points: {shown(points)} is not allowed; give whole numbers >= 2")
    return points


def _begun(chart: str, scene: Scene | None) -> Scene | None:
    """Device and arm as one: the charts show stability, and their ranges are those of both."""
    needed(f"symhaptic.sweeps.charts.{chart}", "dask", "matplotlib", "xarray", extra="sweep")
    scene_or_none(scene)
    return scene and together(scene)


def _own(scene: Scene, part: str) -> Range:
    """From nothing to what the scene has."""
    return 0.0, getattr(scene, part) or 0.0


def _range(scene: Scene | None, arms: dict[str, Any]) -> str:
    """The range in words."""
    parts = []
    for name, values in arms.items():
        meaning = INPUTS[name] if scene is None else in_si(IN_SI[name], scene.rotary)
        unit = f" {meaning.unit}" if meaning.unit != "1" else ""
        ends = f"{values[0]:g} to {values[-1]:g}" if values.size > 1 else f"{values[0]:g}"
        parts.append(f"${meaning.latex}$ = {ends}{unit}")
    return ", ".join(parts)
