"""Limits: what walls a device bears, from a file."""

from __future__ import annotations

import json
import math
from enum import StrEnum
from pathlib import Path
from typing import Annotated, Any

import typer

from symhaptic.cli.shared import app, refuse, unwritable, writable


class LimitsFormat(StrEnum):
    """How `limits` prints."""

    text = "text"
    json = "json"


@app.command()
def limits(
    device: Annotated[
        Path,
        typer.Argument(
            metavar="FILE",
            help='TOML: mass, damping, sampling_period, delay, such as "72 g"; [arm], [wall].',
        ),
    ],
    format: Annotated[LimitsFormat, typer.Option("--format", help="How to print.")] = (
        LimitsFormat.text
    ),
    plot: Annotated[
        Path | None, typer.Option("-o", metavar="FILE", help="Draw it: .svg, .png or .pdf.")
    ] = None,
) -> None:
    """Say which walls a device bears: stable with the arm that holds it, passive by itself."""
    from symhaptic.scene.device_file import BadDevice, read

    writable(plot)
    if plot is not None and plot.suffix not in (".svg", ".png", ".pdf"):
        refuse(f"-o {plot}: {plot.suffix!r} is not allowed; .svg, .png and .pdf are")
    try:
        found = read(device)
    except BadDevice as wrong:
        refuse(str(wrong))
    data = answers(found.held, found.alone, found.wall)
    if format is LimitsFormat.json:
        typer.echo(json.dumps(data, indent=1))
    else:
        typer.echo(text(data), nl=False)
    if plot is not None:
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib import pyplot

        from symhaptic.scene.picture import draw

        figure, axes = pyplot.subplots(figsize=(7.2, 4.4), layout="constrained")
        draw(axes, found.held, found.alone, found.wall)
        try:
            figure.savefig(plot, dpi=150)
        except OSError as wrong:
            unwritable(plot, wrong.strerror)
        typer.echo(f"wrote {plot}", err=True)


def answers(held: Any, alone: Any, wall: tuple[float, float] | None) -> dict[str, Any]:
    """Limits as (K, B, frequency_hz); numbers that are none as None."""

    def limit(found: Any) -> dict[str, float | None]:
        values = {"K": found.K, "B": found.B, "frequency_hz": found.frequency_hz}
        return {k: v if math.isfinite(v) else None for k, v in values.items()}

    data: dict[str, Any] = {
        "stiffest_stable": limit(held.max_stable_stiffness()),
        "stable_without_virtual_damping": limit(held.limit_at(B=0.0)),
        "stiffest_passive": limit(alone.max_passive_stiffness()) if alone.damping else None,
    }
    if wall is not None:
        K, B = wall
        later = held.delay_margin(K=K, B=B)
        data["wall"] = {
            "K": K,
            "B": B,
            "stable": bool(held.is_stable(K=K, B=B)),
            "stable_up_to": limit(held.limit_at(B=B)),
            "passive": bool(alone.is_passive(K=K, B=B)),
            "passivity_margin": alone.passivity_margin(K=K, B=B),
            "delay_margin_s": later if math.isfinite(later) else None,
        }
    return data


def text(data: dict[str, Any]) -> str:
    """The same in words."""

    def said(limit: dict[str, float | None] | None) -> str:
        if limit is None or limit["K"] is None:
            return "no stiffness"
        at = "" if limit["frequency_hz"] is None else f", at {limit['frequency_hz']:.4g} Hz"
        return f"{limit['K']:.5g} N/m with B = {limit['B']:.4g} Ns/m{at}"

    lines = [
        f"stable up to     {said(data['stiffest_stable'])}",
        f"  without B      {said(data['stable_without_virtual_damping'])}",
        f"passive up to    {said(data['stiffest_passive'])}",
    ]
    if wall := data.get("wall"):
        later = wall["delay_margin_s"]
        more = "any delay" if later is None else f"{1000 * later:.4g} ms more delay"
        lines += [
            f"the wall         {wall['K']:g} N/m with {wall['B']:g} Ns/m is "
            f"{'stable' if wall['stable'] else 'NOT STABLE'} and "
            f"{'passive' if wall['passive'] else 'not passive'}",
            f"  with this B    stable up to {said(wall['stable_up_to'])}",
            f"  its margin     {wall['passivity_margin']:.4g} Ns/m to being passive"
            + (f"; it bears {more}" if wall["stable"] else ""),
        ]
    return "\n".join(lines) + "\n"
