"""The library that chapters use, and what makes two texts one to Rocq."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

LIBRARY = (
    *("Prelude", "Polynomials", "Circle", "HalfPlane", "Device", "Loop"),
    *("Energy", "Stored", "Steady", "Answers", "Control", "Boxes", "Zeros"),
)
PRELUDES = tuple(Path(__file__).with_name(f"{name}.v") for name in LIBRARY)
"""What chapters use; each uses those before it."""


def text_mark(text: str) -> str:
    """What two texts share that Rocq is given alike, with the preludes that they import."""
    return hashlib.sha256("".join([*_imported(text).values(), text]).encode()).hexdigest()


def _imported(text: str) -> dict[str, str]:
    """The preludes that a text imports, by name, each after those that it imports itself."""
    known = {path.stem: path for path in PRELUDES}
    found: dict[str, str] = {}
    for names in re.findall(r"^From Symhaptic Require \w+ ([\w ]+)\.$", text, re.M):
        for name in names.split():
            of_it = known[name].read_text(encoding="utf-8")
            found |= _imported(of_it) | {name: of_it}
    return found
