"""The library that chapters use, and what makes two texts one to Rocq."""

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


_PART = re.compile(r'"(?:[^"]|"")*"|\(\*|\*\)|[ \t\r\n]+|[^"(* \t\r\n]+|.', re.S)


@cache
def code(text: str) -> str:
    """A text without comments, and with one blank for all space between two tokens.

    Comments are nested, and strings stand in them.  A text in which Rocq might see a comment
    elsewhere is left as it is: one that begins within a token, or that does not end.

    >>> code('Check 1. (* (* one *) "*)" two *)\\n Check "(* three *)".')
    ' Check 1. Check "(* three *)".'
    >>> code("Check 1.(* one *)")
    'Check 1.(* one *)'
    """
    found, depth = [" "], 0
    for part in _PART.findall(text):
        begins = part == "(*"
        if part == '"' or (begins and not depth and found[-1] != " "):
            return text
        if not (begins or depth or part[0] in " \t\r\n"):
            found.append(part)
            continue
        depth += begins - (depth > 0 and part == "*)")
        if found[-1] != " ":
            found.append(" ")
    return text if depth else "".join(found)


def text_mark(text: str) -> str:
    """What two texts share that say the same to Rocq, as do the preludes that they import."""
    said = [*_imported(code(text)).values(), code(text)]
    return hashlib.sha256("\n".join(said).encode()).hexdigest()


def _imported(text: str) -> dict[str, str]:
    """The preludes that a text imports, by name, each after those that it imports itself."""
    known = {path.stem: path for path in PRELUDES}
    found: dict[str, str] = {}
    for names in re.findall(r"\bFrom Symhaptic Require \w+ ([\w ]+)\.(?!\w)", text):
        for name in names.split():
            of_it = code(known[name].read_text(encoding="utf-8"))
            found |= _imported(of_it) | {name: of_it}
    return found
