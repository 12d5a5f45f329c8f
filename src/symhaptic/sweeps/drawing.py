"""How a chart is drawn: axes with units, and values as colours between round numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.numeric.column import STYLE, column_figure

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray


def figure_and_axes() -> tuple[Figure, Axes]:
    """A new figure, which needs no screen, and its axes."""
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    with rc_context(STYLE):
        figure = column_figure()()
        FigureCanvasAgg(figure)
        axes = figure.subplots()
    return figure, axes


def said(values: xarray.DataArray) -> str:
    """What it is, its symbol, and its unit."""
    about = values.attrs
    what = about["long_name"].split(",")[0]
    symbol = f" ${about['symbol']}$" if "symbol" in about else ""
    return f"{what}{symbol}" + (f" in {about['units']}" if about["units"] != "1" else "")


def labelled(axes: Axes, x: xarray.DataArray, y: xarray.DataArray) -> None:
    """Say on the axes what x and y are, and let them end where these do."""
    axes.set(xlabel=said(x), ylabel=said(y))
    axes.set(xlim=(float(x.min()), float(x.max())), ylim=(float(y.min()), float(y.max())))


def in_ms(values: xarray.DataArray) -> xarray.DataArray:
    """Seconds as milliseconds; anything else as it is."""
    if values.attrs.get("units") != "s":
        return values
    return (1000 * values).assign_attrs({**values.attrs, "units": "ms"})


def plain(value: float, _: object = None) -> str:
    """A number without powers of ten."""
    return f"{value:g}"


def _round_levels(values: NDArray[Any]) -> NDArray[Any]:
    """Round numbers over the range but for the least of it, closer where it is narrow."""
    finite = values[np.isfinite(values) & (values > 0)]
    low, high = (float(np.quantile(finite, q)) for q in (0.02, 1.0))
    powers = np.arange(np.floor(np.log10(low)) - 1, np.ceil(np.log10(high)) + 1)
    steps = (1, 2, 5) if high > 30 * low else (1, 1.5, 2, 3, 5, 7)
    every = np.unique(np.concatenate([m * 10.0**powers for m in steps]))
    first, last = np.searchsorted(every, [low, high])
    return np.asarray(every[max(first - 1, 0) : last + 1])


def filled(
    figure: Figure,
    axes: Axes,
    x: xarray.DataArray,
    y: xarray.DataArray,
    values: xarray.DataArray,
    label: str,
) -> None:
    """Values as colours on a logarithmic scale, with lines at round numbers.

    What is below or beyond all of these is drawn as the least and the largest; nothing where all
    is infinite or nothing.
    """
    from matplotlib import rc_context
    from matplotlib.colors import LogNorm

    if not bool((np.isfinite(values) & (values > 0)).any()):
        return
    levels = _round_levels(values.to_numpy())
    inside = values.clip(levels[0] * 1.0001, levels[-1] * 0.9999)
    norm = LogNorm(levels[0], levels[-1])
    areas = axes.contourf(x, y, inside, levels=levels, norm=norm, cmap="viridis")
    axes.contour(x, y, inside, levels=levels[1:-1], colors="white", linewidths=0.5)
    with rc_context(STYLE):
        bar = figure.colorbar(areas, ax=axes, ticks=levels)
        bar.ax.yaxis.set_major_formatter(plain)
        bar.ax.minorticks_off()
        bar.set_label(label)
