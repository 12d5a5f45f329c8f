"""Limits of stable and passive walls for a device, from a file."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from enum import StrEnum
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from symhaptic.cli.shared import app, can_draw, refuse, writable, write

if TYPE_CHECKING:
    from symhaptic.scene.device_file import Device
    from symhaptic.scene.safe import SafeWalls
    from symhaptic.scene.scene import Scene


class LimitsFormat(StrEnum):
    """What `limits` writes."""

    text = "text"
    json = "json"
    svg = "svg"
    png = "png"
    pdf = "pdf"


DRAWN = LimitsFormat.svg, LimitsFormat.png, LimitsFormat.pdf
ENDINGS = {**LimitsFormat.__members__, "txt": LimitsFormat.text}
"""What the ending of a file's name says that it holds."""


@app.command()
def limits(
    device: Annotated[
        Path,
        typer.Argument(
            metavar="FILE",
            help="TOML file with device (or mass or inertia, damping), sampling_period or "
            "sampling_rate, delay; [arm], [arms], [wall].",
        ),
    ],
    format: Annotated[
        LimitsFormat | None,
        typer.Option("--format", help="Default: the ending of FILE, or text."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", metavar="FILE", help="Write to FILE. Pictures do not replace the printed limits."
        ),
    ] = None,
    chart: Annotated[
        bool,
        typer.Option("--chart", help="Also compute the limits for many dampings B: the K-B chart."),
    ] = False,
) -> None:
    """Print the limits of stable and passive walls for a device.

    The arm counts for stability, not for passivity.  With [arms], a range of arms, also prove which
    walls are stable for every arm of the range.  With [wall], also print which damping gives its
    stiffness the largest delay margin.  A rotary device has its limits in N m/rad and N m s/rad.
    """
    from symhaptic.book.listing import replace
    from symhaptic.bounds.safe.find import NothingSafe
    from symhaptic.scene.device_file import BadDevice, read

    writable(output)
    if output is not None and output.resolve() == device.resolve():
        refuse(f"-o {output}: is the input file; give another one")
    said, into = asked(output, format)
    if into in DRAWN:
        can_draw(f"-o {output}")
    try:
        found = read(device)
    except BadDevice as wrong:
        refuse(str(wrong))
    safe = None
    try:
        data = answers(found.scene, found.wall)
        if chart:
            data["chart"] = charted(found.scene, LISTED if said is LimitsFormat.text else DRAWN_AT)
        if found.arms is not None:
            try:
                safe = found.scene.device.safe_walls(found.arms)
                data["safe"] = proved(safe, found.wall)
            except NothingSafe as unproved:
                data["safe"] = {"arms": str(found.arms), "not_proved": str(unproved)}
    except ValueError as wrong:
        refuse(f"{device}: {wrong}")
    words = text(data) if said is LimitsFormat.text else json.dumps(data, indent=1) + "\n"
    if output is None or into is None or into in DRAWN:
        typer.echo(words, nl=False)
    else:
        write(replace, output, words)
    if output is not None and into in DRAWN:
        write(replace, output, picture(found, safe, into, chart))
    if output is not None:
        typer.echo(f"wrote {output}", err=True)


def asked(
    output: Path | None, given: LimitsFormat | None
) -> tuple[LimitsFormat, LimitsFormat | None]:
    """The format that is printed, and that of the file: the same, or a picture."""
    plain = None if given in DRAWN else given
    if output is None:
        if given in DRAWN:
            refuse(f"--format {given}: needs -o FILE; text and json can be printed")
        return plain or LimitsFormat.text, None
    ending = output.suffix.lower().removeprefix(".")
    into = ENDINGS.get(ending) if ending else given
    if into is None:
        every = ", ".join(f".{name}" for name in ENDINGS)
        refuse(f"-o {output}: the ending {output.suffix!r} is not allowed; give one of {every}")
    if given not in (None, into) and (given in DRAWN or into not in DRAWN):
        refuse(f"-o {output}: does not end as --format {given} does; give .{given}, or none")
    return plain or (LimitsFormat.text if into in DRAWN else into), into


def picture(found: Device, safe: SafeWalls | None, format: LimitsFormat, chart: bool) -> bytes:
    """Walls of a device, the proved ones if there are any, or its chart; always the same bytes."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    from symhaptic.scene.chart import draw_chart
    from symhaptic.scene.picture import draw, new_axes
    from symhaptic.scene.safe import draw_safe

    axes = new_axes("limits")
    if chart:
        draw_chart(axes, found.scene, found.wall)
    elif safe is None:
        draw(axes, found.scene, found.wall)
    else:
        draw_safe(axes, safe, found.wall)
    drawn = BytesIO()
    dated = {"svg": "Date", "pdf": "CreationDate"}
    metadata = {dated[format]: None} if format in dated else {}
    pyplot.savefig(drawn, format=format, metadata=metadata)
    pyplot.close("all")
    return drawn.getvalue()


def answers(scene: Scene, wall: tuple[float, float] | None) -> dict[str, Any]:
    """Limits as (K, B, frequency_hz), with ``None`` for values that are not finite.

    Stability is that of device and arm together, passivity that of the device alone.
    """

    from symhaptic.scene.walls import binding, quantised_limits, why_not_passive
    from symhaptic.scene.words import quantised

    def limit(found: Any) -> dict[str, Any]:
        values = {"K": found.K, "B": found.B, "frequency_hz": found.frequency_hz}
        return {k: finite(v) for k, v in values.items()}

    def finite(value: float) -> float | None:
        return value if math.isfinite(value) else None

    no_passivity = why_not_passive(scene)
    damped = bool(scene.damping) and not no_passivity
    data: dict[str, Any] = {
        "units": {"K": scene.printed("N/m"), "B": scene.printed("N*s/m"), "frequency_hz": "Hz"},
        "arm": None if scene.arm is None else str(scene.arm),
        "stiffest_stable": limit(scene.max_stable_stiffness()),
        "stable_without_virtual_damping": limit(scene.limit_at(B=0.0)),
        "stiffest_passive": limit(scene.max_passive_stiffness()) if damped else None,
    }
    if no_passivity:
        data["passivity_not_computed"] = no_passivity
    if scene.encoder is not None and not why_not_passive(replace(scene, velocity=None)):
        limits = quantised_limits(scene)
        by = binding(limits)
        each = {name: finite(K) for name, K in limits.items()}
        words = {"limited_by": by, "limits_K": each, "words": quantised(scene)}
        data["passive_with_encoder"] = limit(limits[by]) | words
    if wall is not None:
        K, B = wall
        best = scene.damping_for(K)
        delays = scene.integrator == "hold"
        data["wall"] = {
            "K": K,
            "B": B,
            "stable": bool(scene.is_stable(K=K, B=B)),
            "stable_up_to": limit(scene.max_stable_stiffness(B)),
            "passive_up_to": limit(scene.max_passive_stiffness(B)) if damped else None,
            "passive": None if no_passivity else bool(scene.is_passive(K=K, B=B)),
            "passivity_margin": None if no_passivity else finite(scene.passivity_margin(K=K, B=B)),
            # both are None if no delay destabilises the wall, the first alone if it is not computed
            "delay_margin_s": finite(scene.delay_margin(K=K, B=B)) if delays else None,
            "max_delay_s": finite(scene.max_delay(K=K, B=B)) if delays else None,
            "stable_B": [list(ends) for ends in best.intervals],
            # None if there is no such damping, or no margin is computed
            "best_B": None if math.isnan(best.delay_margin) else finite(best),
            "best_delay_margin_s": finite(best.delay_margin) if best.intervals else None,
        }
        if not delays:
            data["wall"]["delay_margin_not_computed"] = "a simulator has no time between its steps"
    return data


LISTED, DRAWN_AT = 20, 200
"""Dampings of a chart as text, and as numbers."""


def charted(scene: Scene, count: int) -> dict[str, list[float | None]]:
    """The limits over the damping, with ``None`` where no stiffness is stable or passive."""
    from symhaptic.scene.chart import chart

    return {
        name: [value if math.isfinite(value) else None for value in values.tolist()]
        for name, values in zip(_COLUMNS, chart(scene, count), strict=True)
    }


_COLUMNS = "B", "stable_up_to", "frequency_hz", "passive_up_to"


def proved(safe: Any, wall: tuple[float, float] | None) -> dict[str, Any]:
    """Walls that are proved stable for every arm of a range, in N/m, Ns/m and s."""
    K, B = safe.stiffest
    best = safe.best_damping(wall[0]) if wall and safe.softest <= wall[0] <= K else None
    return {
        "arms": str(safe.arms),
        "stiffest": {"K": K, "B": B},
        "without_virtual_damping": {"K": safe.limit_at(0.0), "B": 0.0},
        "rectangle": {"K": list(safe.rectangle.K), "B": list(safe.rectangle.B)},
        "edges_B": list(safe.certificate.columns.edges),
        "limits_K": list(safe.certificate.columns.tops),
        "softest_K": safe.softest,
        "passive_corners": [{"K": K, "B": B} for K, B in safe.passive_corners],
        "wall": None if wall is None else bool(safe.contains(*wall)),
        "best_damping": None if best is None else {"B": best.B, "safe_B": list(best.safe)},
    }


def text(data: dict[str, Any]) -> str:
    """The same in words."""
    in_K, in_B = data["units"]["K"], data["units"]["B"]

    def said(limit: dict[str, float | None] | None) -> str:
        if limit is None or limit["K"] is None:
            return "no stiffness"
        at = "" if limit["frequency_hz"] is None else f", at {limit['frequency_hz']:.4g} Hz"
        return f"{limit['K']:.5g} {in_K} with B = {limit['B']:.4g} {in_B}{at}"

    no_passivity = data.get("passivity_not_computed")
    why = f"not computed ({no_passivity})" if no_passivity else ""
    arm = f"arm              {data['arm']}; counts for stability, not for passivity"
    lines = [
        *([arm] if data["arm"] else []),
        f"stable up to     {said(data['stiffest_stable'])}",
        f"  without B      {said(data['stable_without_virtual_damping'])}",
        f"passive up to    {why or said(data['stiffest_passive'])}",
    ]
    if with_encoder := data.get("passive_with_encoder"):
        lines.append(f"with encoder     {with_encoder['words']}")
    if wall := data.get("wall"):
        margin = wall["passivity_margin"]
        spare = "none, because K < 0" if margin is None else f"{margin:.4g} {in_B}"
        passive = "" if why else f" and {'passive' if wall['passive'] else 'not passive'}"
        lines += [
            f"the wall         {wall['K']:g} {in_K} with {wall['B']:g} {in_B} is "
            f"{'stable' if wall['stable'] else 'NOT STABLE'}{passive}",
            f"  with this B    stable up to {said(wall['stable_up_to'])}",
            f"                 passive up to {why or said(wall['passive_up_to'])}",
            f"passivity margin {'not computed' if why else spare}",
            f"delay margin     {_delay_said(wall)}",
            f"  with this K    {_dampings_said(wall, in_B)}",
        ]
    if safe := data.get("safe"):
        lines.append(f"with every arm   of {safe['arms']}:")
        lines += _safe_said(safe, data.get("wall"), in_K, in_B)
    if chart := data.get("chart"):
        lines += ["", *_chart_said(chart, in_K, in_B)]
    return "\n".join(lines) + "\n"


def _delay_said(wall: dict[str, Any]) -> str:
    margin, most = wall["delay_margin_s"], wall["max_delay_s"]
    if not wall["stable"]:
        return "none, because the wall is not stable"
    if not_computed := wall.get("delay_margin_not_computed"):
        return f"not computed ({not_computed})"
    if most is None:
        return "unlimited"
    if margin is None:
        return "not computed, because the wall is unstable with some smaller delay"
    return f"{1000 * margin:.4g} ms, up to a delay of {1000 * most:.4g} ms"


def _dampings_said(wall: dict[str, Any], in_B: str) -> str:
    if not wall["stable_B"]:
        return "no damping makes it stable"
    ranges = ", ".join(f"{low:.4g} to {high:.4g}" for low, high in wall["stable_B"])
    found = f"stable with B = {ranges} {in_B}"
    if wall["best_B"] is None:
        return found
    margin = wall["best_delay_margin_s"]
    most = "unlimited" if margin is None else f"{1000 * margin:.4g} ms"
    return f"{found}; the largest delay margin, {most}, has B = {wall['best_B']:.4g} {in_B}"


def _chart_said(chart: dict[str, list[float | None]], in_K: str, in_B: str) -> list[str]:
    head = (f"B in {in_B}", f"stable K in {in_K}", "at Hz", f"passive K in {in_K}")
    rows = [
        ["-" if value is None else f"{value:.4g}" for value in row]
        for row in zip(*chart.values(), strict=True)
    ]
    widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]
    return ["  ".join(map(str.rjust, row, widths)) for row in (head, *rows)]


def _safe_said(
    safe: dict[str, Any], wall: dict[str, Any] | None, in_K: str, in_B: str
) -> list[str]:
    if "not_proved" in safe:
        lines = [f"  not proved     {safe['not_proved']}"]
        return lines + (["  the wall is    NOT PROVED SAFE"] if wall else [])
    (low, high), (left, right) = safe["rectangle"]["K"], safe["rectangle"]["B"]
    stiffest, free = safe["stiffest"], safe["without_virtual_damping"]["K"]
    lines = [
        f"  proved stable  up to {stiffest['K']:.5g} {in_K} with B = {stiffest['B']:.4g} {in_B}",
        f"  without B      {f'{free:.4g} {in_K}' if free else 'no stiffness'}",
        f"  any wall of    {low:.2g} to {high:.5g} {in_K} with {left:.4g} to {right:.4g} {in_B}",
    ]
    if wall:
        lines.append(f"  the wall is    {'safe' if safe['wall'] else 'NOT PROVED SAFE'}")
    if wall and (best := safe["best_damping"]):
        low, high = best["safe_B"]
        lines.append(
            f"  best damping   {best['B']:.3g} {in_B} gives {wall['K']:g} {in_K} the largest delay "
            f"margin; safe are {low:.3g} to {high:.3g} {in_B}"
        )
    return lines
