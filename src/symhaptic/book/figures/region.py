"""A stable region as a picture."""

from __future__ import annotations

import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from symhaptic.book.figures.passivity import COLOURS, STYLE, WIDTH
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


def picture(region: Region, format: str) -> bytes:
    """The region in the (alpha, beta) plane as a PNG or SVG file."""
    with matplotlib.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(WIDTH, 0.7 * WIDTH), layout="constrained")
        region.plot(axes, color=COLOURS[0], fill="#E4EFE9")
        axes.axhline(0, color="black", linewidth=0.4)
        axes.set_xlabel(r"virtual stiffness $\alpha=KT^2/m$")
        axes.set_ylabel(r"virtual damping $\beta=BT/m$")
        axes.set_title(heading(region))
        file = io.BytesIO()
        metadata = {"Date": None} if format == "svg" else {"Software": None}
        figure.savefig(file, format=format, dpi=200, metadata=metadata)
        plt.close(figure)
    return file.getvalue()
