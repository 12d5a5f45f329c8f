"""A stable region as a picture."""

from __future__ import annotations

import io
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from symhaptic.book.figures.style import COLOURS
from symhaptic.numeric.column import STYLE, column_figure, legend_below
from symhaptic.numeric.tracing.region import Region


def number(value: float) -> str:
    r"""Up to six digits of a number inside a formula, with a power of ten where it needs one.

    >>> number(0.02), number(6.944e-05), number(1e6)
    ('0.02', '6.944\\times10^{-5}', '10^{6}')
    """
    mantissa, _, power = f"{value:g}".partition("e")
    if not power:
        return mantissa
    ten = f"10^{{{int(power)}}}"
    return ten if mantissa == "1" else rf"{mantissa}\times{ten}"


def heading(region: Region) -> str:
    """What the region is of, for Matplotlib."""
    loop = region.loop
    gamma, delta, delay = (number(x) for x in (loop.gamma, loop.delta, loop.delay))
    return rf"stable for $\gamma={gamma}$, $\delta={delta}$, $d={delay}$"


_METADATA: dict[str, Any] = {
    "pdf": {"CreationDate": None},
    "svg": {"Date": None},
    "png": {"Software": None},
}
"""Without dates, so that a picture has the same bytes in every run."""


def picture(region: Region, format: str) -> bytes:
    """The region in the (alpha, beta) plane as a PNG, SVG or PDF file, for a column of 3.5 in."""
    with matplotlib.rc_context(STYLE):
        figure = plt.figure(FigureClass=column_figure())
        axes = figure.subplots()
        region.plot(axes, color=COLOURS[0], fill="#E4EFE9", label=heading(region))
        alpha, beta, _ = region.max_stiffness
        most = rf"maximum stiffness: $\alpha={number(float(f'{alpha:.4g}'))}$"
        most += rf", $\beta={number(float(f'{beta:.4g}'))}$"
        axes.plot(alpha, beta, "o", color="black", markersize=3, label=most)
        axes.axhline(0, color="black", linewidth=0.4)
        legend_below(axes)
        file = io.BytesIO()
        figure.savefig(file, format=format, metadata=_METADATA[format])
        plt.close(figure)
    return file.getvalue()
