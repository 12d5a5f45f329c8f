"""The plots of stable regions, from the package's numeric functions, as vector graphics.

A fractional delay is drawn exactly; thin dotted curves are the paper's principal sheet.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.book.figures.passivity import boundary
from symhaptic.book.figures.style import COLOURS
from symhaptic.numeric.stability import is_stable
from symhaptic.numeric.tracing.extremes import max_stable_stiffness
from symhaptic.numeric.tracing.margin import delay_margin
from symhaptic.numeric.tracing.region import Region, stable_region
from symhaptic.numeric.tracing.robust import robust_region
from symhaptic.paper.tables import DELAYS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

GAMMA, DELTA = 0.001, 0.02
"""Upper limits of the parameter ranges (23)."""

STABLE, PASSIVE, GREY = COLOURS[5], COLOURS[0], "#8A8A8A"
DOTTED: dict[str, Any] = {"linestyle": (0, (1, 1.5)), "linewidth": 0.7}
"""Of the paper's principal sheet."""

DASHED: dict[str, Any] = {"linestyle": "dashed", "linewidth": 0.9}
"""Of passive walls."""

STIFFEST: dict[str, Any] = {"color": "black", "linestyle": "dashdot", "linewidth": 0.7}
"""Of the largest stable stiffness over the delay."""

FINE = 1e-4
"""Chords of the drawn outlines, relative to the region."""


@cache
def region(gamma: float, delta: float, delay: float, sheet: str = "exact") -> Region:
    """A stable region, fine enough for print."""
    return stable_region(gamma, delta, delay, sheet, FINE)


def limits(axes: Axes, delay: float) -> None:
    """Outlines for the four limits of the parameter ranges."""
    for delta, colour in ((0.0, COLOURS[2]), (DELTA, STABLE)):
        for gamma, style in ((0.0, "solid"), (GAMMA, (0, (4, 2)))):
            label = rf"$\delta={delta:g}$, $\gamma={gamma:g}$"
            region(gamma, delta, delay).plot(axes, color=colour, linestyle=style, label=label)


def plane(axes: Axes) -> None:
    """Names of the two coordinates and their zero lines."""
    axes.axhline(0, color=GREY, linewidth=0.4, zorder=0)
    axes.axvline(0, color=GREY, linewidth=0.4, zorder=0)
    axes.set_xlabel(r"virtual stiffness $\alpha$")
    axes.set_ylabel(r"virtual damping $\beta$")


def undelayed(axes: Axes) -> None:
    """Fig. 7: d = 0 at the limits of the parameter ranges."""
    limits(axes, 0)
    plane(axes)
    axes.set_xlim(-0.02, 0.78)
    axes.set_ylim(-0.08, 2.15)
    axes.legend(loc="upper right")


def origin(axes: Axes) -> None:
    """Fig. 8: close-up of Fig. 7, with five stiffnesses."""
    for delta, colour in ((DELTA, STABLE), (0.0, COLOURS[2])):
        for part in (0, 0.25, 0.5, 0.75, 1):
            label = rf"$\delta={delta:g}$" if part == 1 else None
            found = region(part * GAMMA, delta, 0)
            found.plot(axes, color=colour, linewidth=0.4 + 0.7 * part, label=label)
    plane(axes)
    axes.set_xlim(-0.0016, 0.0036)
    axes.set_ylim(-0.023, 0.008)
    above: dict[str, Any] = {
        "xytext": (0, 3),
        "textcoords": "offset points",
        "annotation_clip": False,
    }
    for part in (0, 0.25, 0.5, 0.75, 1):
        axes.annotate(f"{part:g}", (-part * GAMMA, 0.008), ha="center", **above)
    axes.annotate(r"$1000\,\gamma=$", (-1.15 * GAMMA, 0.008), ha="right", **above)
    axes.legend(loc="center right")


def key(axes: Axes, columns: int) -> None:
    """The legend of one panel below all of them."""
    handles, labels = axes.get_legend_handles_labels()
    axes.figure.legend(
        handles,
        labels,
        loc="outside lower center",
        ncols=columns,
        handlelength=1.6,
        handletextpad=0.5,
        columnspacing=1.1,
    )


def delayed(panels: Any) -> None:
    """Fig. 9: d = 1 and d = 2 at the limits of the parameter ranges."""
    for axes, delay in zip(panels.flat, (1, 2), strict=True):
        limits(axes, delay)
        plane(axes)
        axes.set_title(f"$d={delay}$", fontsize=9)
    key(panels.flat[0], 4)


def passive(delay: float) -> tuple[Any, Any]:
    """Boundary of the walls that satisfy (5), for the largest damping of the range."""
    stiffness, damping = boundary(delay)
    return DELTA * stiffness, DELTA * damping


def passive_and_stable(panels: Any) -> None:
    """Fig. 11: boundaries of passive and of stable walls for seven delays, and a close-up."""
    whole, close = panels.flat
    ends = np.linspace(0, 8, 161)
    most = max_stable_stiffness(GAMMA, DELTA, ends)
    for axes in (whole, close):
        for colour, text in zip(COLOURS, DELAYS, strict=True):
            delay = float(text)
            region(GAMMA, DELTA, delay).plot(axes, color=colour, label=f"$d={delay:g}$")
            if delay != int(delay):
                region(GAMMA, DELTA, delay, "principal").plot(axes, color=colour, **DOTTED)
            axes.plot(*passive(delay), color=colour, **DASHED)
        axes.plot(most.alpha, most.beta, **STIFFEST)
        plane(axes)
    whole.set_xlim(-0.02, 0.75)
    whole.set_ylim(-0.08, 2.15)
    close.set_xlim(-0.002, 0.045)
    close.set_ylim(-0.03, 0.09)
    left, right = close.get_xlim()
    low, high = close.get_ylim()
    frame = [left, right, right, left, left], [low, low, high, high, low]
    whole.plot(*frame, color=GREY, linewidth=0.8, zorder=5)
    for axes, name in ((whole, "(a)"), (close, "(b)")):
        axes.set_title(name, loc="left", fontsize=9)
    key(whole, 7)
    styles = {
        "stable": {},
        "stable, principal sheet": DOTTED,
        "passive": DASHED,
        "largest stable stiffness": STIFFEST,
    }
    for label, style in styles.items():
        whole.plot([], [], **{"color": "black", "label": label} | style)
    handles = whole.lines[-len(styles) :]
    whole.figure.legend(handles=handles, loc="outside upper center", ncols=len(styles))


def passive_stiffness(delays: Any) -> Any:
    """Largest passive alpha for the largest damping of the range, 2 delta tan(pi/(4(d+1)))."""
    return 2 * DELTA * np.tan(np.pi / (4 * (delays + 1)))


def largest_stiffnesses(panels: Any) -> None:
    """Fig. 12: largest passive and stable stiffness over the delay, and their ratio."""
    both, ratio, far = panels.flat
    delays = np.linspace(0, 8, 161)
    springs = ((0.0, "solid"), (GAMMA, (0, (4, 2))))
    both.semilogy(delays, passive_stiffness(delays), color=PASSIVE, label="passive")
    for gamma, style in springs:
        stable = max_stable_stiffness(gamma, DELTA, delays).alpha
        label = "stable" if gamma == 0 else None
        both.semilogy(delays, stable, color=STABLE, linestyle=style, label=label)
        name = rf"$\gamma={gamma:g}$"
        ratio.plot(
            delays, passive_stiffness(delays) / stable, color="black", linestyle=style, label=name
        )
        whole = np.unique(np.geomspace(1, 1000, 70).astype(int))
        stable = max_stable_stiffness(gamma, DELTA, whole).alpha
        far.semilogx(whole, passive_stiffness(whole) / stable, color="black", linestyle=style)
    both.set_ylabel(r"largest stiffness $\alpha$")
    both.legend(loc="upper right")
    ratio.set_ylabel(r"ratio $\eta$")
    ratio.legend(loc="upper left")
    ratio.set_ylim(0, 0.5)
    far.axhline(1, color=GREY, linewidth=0.5)
    far.set_ylim(0, 1.05)
    far.set_xlim(1, 1000)
    for axes, name in zip(panels.flat, ("(a)", "(b)", "(c)"), strict=True):
        axes.set_xlabel("delay factor $d$")
        axes.set_title(name, loc="left", fontsize=9)
    for axes in (both, ratio):
        axes.set_xlim(0, 8)


SPRINGS = np.linspace(0, 1, 41)
"""Stiffnesses of Fig. 13, in units of the one at the Nyquist frequency."""

ROWS = ((0.0, "exact"), (0.5, "exact"), (0.5, "principal"), (1.0, "exact"), (2.0, "exact"))
"""Delays of Fig. 13, half a period exactly and as the paper reads it."""


def springs(panels: Any) -> None:
    """Fig. 13: outlines for 41 springs up to the Nyquist frequency, with two close-ups."""
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import ListedColormap, Normalize

    colours = ListedColormap(colormaps["viridis"](0.9 * SPRINGS))
    for row, (delay, sheet) in zip(panels, ROWS, strict=True):
        whole, damped, undamped = row
        for delta, some in ((DELTA, (whole, damped)), (0.0, (undamped,))):
            for i, part in enumerate(SPRINGS):
                found = region(part * (np.pi**2 + delta**2 / 4), delta, delay, sheet)
                for axes in some:
                    found.plot(axes, color=colours(i), linewidth=0.4, in_layout=False)
        damped.fill(*passive(delay), color=PASSIVE, alpha=0.45, linewidth=0, zorder=3)
        robust = robust_region(DELTA, delay, sheet, tolerance=0.03)
        robust.plot(damped, color="black", linewidth=0.9, zorder=4)
        for axes in (damped, undamped):
            axes.set_xlim(-0.02, 0.07)
            axes.set_ylim(-0.04, 0.05)
        reading = ", principal" if sheet == "principal" else ""
        whole.set_ylabel(rf"$d={delay:g}${reading}" "\n" r"virtual damping $\beta$", fontsize=8)
    for axes in panels.flat:
        axes.tick_params(labelsize=7)
    for axes, delta in zip(panels[0], (DELTA, DELTA, 0), strict=True):
        axes.set_title(rf"$\delta={delta:g}$", fontsize=9)
    for axes in panels[-1]:
        axes.set_xlabel(r"virtual stiffness $\alpha$")
    panels[0, 0].figure.colorbar(
        ScalarMappable(Normalize(0, np.pi**2), colours),
        ax=panels,
        location="bottom",
        aspect=60,
        pad=0.01,
        label=r"physical stiffness $\gamma$",
    )


def delay_margins(panels: Any) -> None:
    """The largest delay that a wall bears, over the plane; regions of five delays outlined."""
    from matplotlib.colors import BoundaryNorm
    from matplotlib.path import Path

    levels = [0, 0.25, 0.5, 1, 2, 4, 8, 16, 32, 64]
    for axes, (right, high) in zip(panels.flat, ((0.76, 2.15), (0.075, 0.65)), strict=True):
        alpha, beta = np.meshgrid(
            np.linspace(-GAMMA * 0.999, right, 75), np.linspace(-0.03, high, 75)
        )
        stable = is_stable(alpha, beta, GAMMA, DELTA, 0)
        margin = np.zeros_like(alpha)
        margin[stable] = delay_margin(alpha[stable], beta[stable], GAMMA, DELTA)
        margin = np.minimum(margin, levels[-1])
        filled = axes.contourf(
            alpha, beta, margin, levels, cmap="YlGnBu", norm=BoundaryNorm(levels, 256)
        )
        for delay in (8, 4, 2, 1, 0):
            found = region(GAMMA, DELTA, delay)
            found.plot(axes, color="black", linewidth=0.7)
        filled.set_clip_path(Path(found.outline[0]), axes.transData)
        plane(axes)
        axes.set_xlim(-0.01 * right, right)
        axes.set_ylim(-0.03, high)
    panels.flat[0].figure.colorbar(
        filled,
        ax=panels,
        location="bottom",
        aspect=60,
        format="%g",
        label="delay margin in sampling periods",
    )
