"""The plots of passive walls and of the walls of a free mass, from the derived formulas."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from symhaptic.book.figures.style import COLOURS
from symhaptic.model import boundary as boundary_of
from symhaptic.model import jury, passivity, plant
from symhaptic.model.parts import Parts
from symhaptic.notation import T, alpha, b, beta, d, theta
from symhaptic.paper.tables import DELAYS

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@cache
def _envelope() -> Any:
    """(KT/b, B/b) of the envelope over theta and d, as a NumPy function."""
    stiffness, damping = passivity.envelope()
    unit = {b: 1, T: 1}
    return sp.lambdify((theta, d), [stiffness.subs(unit), damping.subs(unit)], "numpy")


@cache
def _largest() -> Any:
    """(KT/b, B/b) of the largest passive stiffness over d."""
    angle = sp.pi / (2 * (d + 1))
    point = [e.subs(theta, angle).subs({b: 1, T: 1}) for e in passivity.envelope()]
    return sp.lambdify(d, point, "numpy")


@cache
def _corner() -> Any:
    """(KT/b, B/b) of the end of the straight part over d."""
    from symhaptic.proof.series import limit

    point = [limit(e, theta).subs({b: 1, T: 1}) for e in passivity.envelope()]
    return sp.lambdify(d, point, "numpy")


def boundary(delay: float) -> tuple[Any, Any]:
    """The closed boundary of the passive walls in the plane of KT/b and B/b."""
    corner = _corner()(delay)
    if delay == 0:
        return np.array([0, corner[0], 0]), np.array([-1, corner[1], 1])
    angles = np.linspace(0, np.pi / (delay + 1), 402)[1:]
    x, y = _envelope()(angles[10:], delay)
    return np.concatenate([[0, corner[0]], x]), np.concatenate([[-1, corner[1]], y])


def passive_regions(axes: Axes) -> None:
    """Fig. 4: boundaries for seven delays, largest stiffness, ends of the straight part."""
    ends = np.linspace(0, 60, 600)
    for colour, text in zip(COLOURS, DELAYS, strict=True):
        axes.plot(*boundary(float(text)), color=colour, label=f"$d = {float(text):g}$")
    axes.add_artist(axes.legend(loc="upper right", ncols=2))
    styles = [
        axes.plot(*curve(ends), color="black", linestyle=style, linewidth=0.8, label=label)[0]
        for curve, style, label in (
            (_largest(), "dashdot", "largest stiffness"),
            (_corner(), "dashed", "end of the straight part"),
        )
    ]
    axes.axhline(0, color="black", linewidth=0.4)
    axes.set_xlim(0, 2.1)
    axes.set_ylim(-1.05, 1.05)
    axes.set_xlabel("virtual stiffness $KT/b$")
    axes.set_ylabel("virtual damping $B/b$")
    axes.legend(handles=styles, loc="lower right")


def largest_stiffness(axes: Axes) -> None:
    """Fig. 5: the largest passive stiffness over the delay factor."""
    delays = np.linspace(0, 8, 400)
    axes.plot(delays, _largest()(delays)[0], color=COLOURS[0])
    for delay in (0, 1, 2):
        value = float(_largest()(delay)[0])
        axes.plot([delay], [value], "o", color=COLOURS[0], markersize=3)
        axes.annotate(
            f"{100 * value / 2:.1f} %", (delay, value), (4, 4), textcoords="offset points"
        )
    axes.set_xlim(0, 8)
    axes.set_ylim(0, 2.1)
    axes.set_xlabel("delay factor $d$")
    axes.set_ylabel(r"largest passive stiffness $K_{\max}T/b$")


@cache
def _free_mass() -> Any:
    """(alpha, beta) of a free mass's boundary over theta and d."""
    device = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    return sp.lambdify((theta, d), boundary_of.wall(device), "numpy")


def free_mass(axes: Axes) -> None:
    """Stable walls of a free mass for five whole delays, with the stiffest of each."""
    for colour, delay in zip(COLOURS, (0, 1, 2, 4, 8), strict=False):
        angles = np.linspace(0, np.pi / (2 * (delay + 1)), 2001)[1:]
        x, y = (np.real(side) for side in _free_mass()(angles, delay))
        x, y = np.append(x, 0), np.append(y, 0)
        axes.fill(x, y, color=colour, alpha=0.12, linewidth=0)
        axes.plot(np.append(x, x[0]), np.append(y, y[0]), color=colour, label=f"$d = {delay}$")
        axes.plot(x.max(), y[x.argmax()], "o", color=colour, markersize=3)
    axes.set_xlim(-0.01, 0.72)
    axes.set_ylim(-0.02, 2.05)
    axes.set_xlabel(r"virtual stiffness $\alpha$")
    axes.set_ylabel(r"virtual damping $\beta$")
    axes.legend(loc="upper right")


def free_mass_inequalities(axes: Axes) -> None:
    """Stability of a free mass with two periods of delay: each inequality, and all of them."""
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    found = jury.criterion(jury.coefficients(2, free)).expressions
    x, y = np.meshgrid(np.linspace(-0.6, 1, 400), np.linspace(-0.7, 1.4, 400))
    values = [sp.lambdify((alpha, beta), e, "numpy")(x, y) * np.ones_like(x) for e in found]
    axes.contourf(x, y, np.min(values, axis=0), levels=[0, np.inf], colors=[COLOURS[0]], alpha=0.25)
    kinds = [("half planes", COLOURS[2], 0.9)] * 4
    kinds += [("first minor", COLOURS[6], 0.9), ("last minor", COLOURS[0], 2.2)]
    for value, (label, colour, width) in zip(values, kinds, strict=True):
        axes.contour(x, y, value, levels=[0], colors=[colour], linewidths=[width])
        if label not in axes.get_legend_handles_labels()[1]:
            axes.plot([], [], color=colour, linewidth=width, label=label)
    angles = np.linspace(0.02, np.pi - 0.02, 60)
    stiffness, damping = (np.real(side) for side in _free_mass()(angles, 2))
    axes.plot(stiffness, damping, "o", color="black", markersize=2, label="explicit boundary")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=4)
    axes.set_xlim(-0.6, 1)
    axes.set_ylim(-0.7, 1.4)
    axes.set_xlabel(r"virtual stiffness $\alpha$")
    axes.set_ylabel(r"virtual damping $\beta$")
