"""The preludes that chapters use, what they leave open, and what makes two texts one to Rocq."""

from __future__ import annotations

import hashlib
import re
from functools import cache
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


@cache
def meant() -> frozenset[str]:
    """What the prelude leaves open: the predicates, whose meaning the model has."""
    found = re.findall(r"^Parameters? ([\w\s]+):", _preludes(), re.M)
    return frozenset(name for names in found for name in names.split())


@cache
def known_there() -> frozenset[str]:
    """What the prelude believes of the predicates: rules of our kernel, by their names there."""
    return frozenset(re.findall(r"^Axiom (rule_\w+)", _preludes(), re.M))


def _preludes() -> str:
    return "".join(path.read_text(encoding="utf-8") for path in PRELUDES)
