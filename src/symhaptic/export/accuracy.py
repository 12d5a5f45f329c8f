"""What `benchmarks/accuracy.py` measured; a figure may only shrink where it was measured.

Each line of ``accuracy.json`` is the worst result of a function: precision, function, result,
error, arguments and, where the figure alone does not say all, a remark.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from symhaptic.export.precision import PRECISIONS, Precision

MEASURED_ON = "glibc 2.36 x86_64 96a68562"
"""Whose sines and exponentials the figures rest on, as `tests/libm.py` tells it; with another
library they differ in the last places, and only the goals hold."""

MUSL = "musl 1.2.3"
"""The other library that they were measured with, as `tests/libm.py` tells it."""


@dataclass(frozen=True)
class Worst:
    """The largest error of a function, in units in the last place of its largest term."""

    error: float
    result: str
    at: tuple[float, ...]
    remark: str = ""
    """What the figure alone does not say."""


Records = Mapping[Precision, Mapping[str, Worst]]


def _records(rows: list[Any]) -> Records:
    found: dict[Precision, dict[str, Worst]] = {}
    for precision, function, result, error, at, *remark in rows:
        worst = Worst(error, result, tuple(at), *remark)
        found.setdefault(PRECISIONS[precision], {})[function] = worst
    return found


_READ = json.loads(Path(__file__).with_suffix(".json").read_text(encoding="utf-8"))

MEASURED = _records(_READ["results"])
"""The worst results of 100 000 points a function; of the device, its polynomial, the stability
boundary and the linear limit in double precision also of the points that
`benchmarks/accuracy.py --around` goes on to from the worst ones."""

MEASURED_WITH_MUSL = _records(_READ["with musl"])
"""The same with the functions of musl, in whose place the figures rest on ``MUSL``: the worst of
100 000 points a function, of the largest passive stiffness in single precision 50 000; in double
precision of the passivity boundary 30 000, of the largest passive stiffness 20 000 and of the
largest stable one 15 000."""

DERIVATIVES = _records(_READ["derivatives"])
"""The worst derivatives of 10 000 points a function, by all arguments by which there are some; of
the largest stable stiffness 1500 in double precision.

Two have no record in single precision: of the stability boundary those by delta and d, which lose
digits to underflow where exp(-delta/2) over the square of gamma is below the smallest normal float,
and of the margin at its worst angle, where the wall is so nearly as good at all angles that a float
does not tell which is the worst one."""
