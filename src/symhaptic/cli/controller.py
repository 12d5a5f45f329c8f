"""A wall of a device file as C for its controller."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from symhaptic.cli.shared import app, refuse


class Precision(StrEnum):
    """What the C code computes with."""

    double = "double"
    single = "single"


@app.command()
def controller(
    device: Annotated[
        Path, typer.Argument(metavar="DEVICE.toml", help="Device, its loop and its [wall].")
    ],
    output: Annotated[
        Path, typer.Option("-o", metavar="DIR", help="Folder of the C files.")
    ] = Path("wall"),
    precision: Annotated[
        Precision, typer.Option("--precision", help="Compute in double or in float.")
    ] = Precision.double,
) -> None:
    """Write the wall of a device as C: its force from the position, with the velocity filter.

    The files are wall.h, wall.c and test_wall.c, a self-test.  An unstable wall is refused.
    """
    from symhaptic.export import request
    from symhaptic.export.language import Refused
    from symhaptic.scene.controller import files
    from symhaptic.scene.device_file import BadDevice, read

    try:
        found = read(device)
        if found.wall is None:
            raise BadDevice(f"{device}: has no wall; give a table [wall] with K and B")
        made = files(found.scene, *found.wall, single=precision is Precision.single)
        listing = "\n".join(sorted([*made, request.LISTING])) + "\n"
        request.write({**made, request.LISTING: listing}, output)
    except (BadDevice, Refused) as wrong:
        refuse(str(wrong))
    except ValueError as wrong:
        refuse(f"{device}: {wrong}")
    typer.echo(f"wrote {output}")
