"""Bytes of exported code on a Cortex-M4, each function alone with all that it calls but libm.

`python benchmarks/microcontroller.py` prints what `export/microcontroller.py` records; needs
arm-none-eabi-gcc (Debian: gcc-arm-none-eabi).
"""

import subprocess
import tempfile
from pathlib import Path

from symhaptic.export import request
from symhaptic.export.microcontroller import COMPILER, CORTEX_M4, LEAN, SIZES
from symhaptic.export.targets import TARGETS
from symhaptic.forms import stable


def size(name, folder):
    """Bytes of text; there are no data."""
    forms = request.chosen([name], delay=1 if name in stable.FOR_ONE_DELAY else None)
    _, files = request.built(TARGETS["microcontroller"], forms, vectors=False)
    for file, text in files.items():
        (folder / file).write_text(text)
    build = [COMPILER, "-std=c99", *CORTEX_M4, *LEAN, "-c", "haptic.c"]
    subprocess.run(build, cwd=folder, check=True)
    told = subprocess.run(
        ["arm-none-eabi-size", "haptic.o"], cwd=folder, check=True, capture_output=True, text=True
    )
    return int(told.stdout.split("\n")[1].split()[0])


def main():
    for name, recorded in SIZES.items():
        with tempfile.TemporaryDirectory() as place:
            found = size(name, Path(place))
        print(f'    "{name}": {found},  # {recorded} recorded', flush=True)


if __name__ == "__main__":
    main()
