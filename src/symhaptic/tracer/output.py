"""A stable region as text for other programs, and as a picture."""

from __future__ import annotations

import io
import json
from typing import Any

from symhaptic.kernels.extremum import Extremum
from symhaptic.tracer.region import Region


def csv_text(region: Region) -> str:
    """One row per point of the outline: number of its ring, alpha, beta; all digits."""
    rows = ["ring,alpha,beta"]
    for number, ring in enumerate(region.outline):
        rows += [f"{number},{float(alpha)!r},{float(beta)!r}" for alpha, beta in ring]
    return "\n".join(rows) + "\n"


def json_text(region: Region) -> str:
    """Everything that is known of the region; an angle is null where only a real root is."""
    loop = region.loop
    content: dict[str, Any] = {
        "gamma": loop.gamma,
        "delta": loop.delta,
        "delay": loop.delay,
        "sheet": loop.sheet,
        "area": region.area,
        "error": region.error,
        "touches_left_bound": region.touches_left_bound,
        "max_stiffness": _extremum(region.max_stiffness),
        "max_damping": _extremum(region.max_damping),
        "min_damping": _extremum(region.min_damping),
        "corners": region.corners.tolist(),
        "outline": [ring.tolist() for ring in region.outline],
    }
    return json.dumps(content, indent=1, allow_nan=False) + "\n"


def _extremum(point: Extremum) -> dict[str, float | None]:
    values = {name: float(value) for name, value in point._asdict().items()}
    return {name: value if value == value else None for name, value in values.items()}


def picture(region: Region, format: str) -> bytes:
    """The region in the (alpha, beta) plane as a PNG or SVG file."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    from symhaptic.report.figures import COLOURS, STYLE, WIDTH

    loop = region.loop
    with matplotlib.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(WIDTH, 0.7 * WIDTH), layout="constrained")
        region.plot(axes, color=COLOURS[0], fill="#E4EFE9")
        axes.axhline(0, color="black", linewidth=0.4)
        axes.set_xlabel(r"virtual stiffness $\alpha=KT^2/m$")
        axes.set_ylabel(r"virtual damping $\beta=BT/m$")
        axes.set_title(
            rf"stable for $\gamma={loop.gamma:g}$, $\delta={loop.delta:g}$, $d={loop.delay:g}$"
        )
        file = io.BytesIO()
        metadata = {"Date": None} if format == "svg" else {"Software": None}
        figure.savefig(file, format=format, dpi=200, metadata=metadata)
        plt.close(figure)
    return file.getvalue()
