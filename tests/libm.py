"""Which mathematical library computes here: the last place of a sine is its own."""

from __future__ import annotations

import math
import platform
import re
import struct
import subprocess
import zlib
from pathlib import Path

FUNCTIONS = ("sin", "cos", "tan", "exp", "expm1", "sinh", "cosh", "tanh", "log", "log1p", "atan")
"""What exported code may call; each also has its own rounding."""

_COUNT = 2000
_GOLDEN = (math.sqrt(5.0) - 1) / 2


def tag() -> str:
    """Name, version and machine of the C library, and a sum over what its functions return.

    The sum tells processors apart for which one library takes different roads (with and without
    fused multiplication), which the version does not.
    """
    total = 0
    for name in FUNCTIONS:
        function = getattr(math, name)
        for k in range(1, _COUNT + 1):
            x = 10 ** (k % 7 - 4) * (k * _GOLDEN % 1)
            total = zlib.crc32(struct.pack("<d", function(min(x, 700.0))), total)
    return " ".join([*platform.libc_ver(), platform.machine(), f"{total:08x}"])


def musl() -> str:
    """Name and version of the musl that is installed beside; nothing where there is none.

    Its functions are the same on all processors of a kind: no sum over them is needed.
    """
    for loader in sorted(Path("/lib").glob("ld-musl-*.so.1")):
        told = subprocess.run([loader], capture_output=True, text=True).stderr
        if found := re.search(r"Version (\S+)", told):
            return f"musl {found[1]}"
    return ""
