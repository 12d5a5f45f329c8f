"""The package's own kernels: what the exporter writes for arrays, committed."""

from __future__ import annotations

from difflib import unified_diff
from pathlib import Path

from symhaptic.export import request
from symhaptic.export.targets import TARGETS
from symhaptic.forms import stable
from symhaptic.forms.stable import Form

FOLDER = Path(__file__).parents[1] / "kernels"

_HEADER = "# Written by `symhaptic kernels` from the stable forms; do not edit.\n"

_ABOUT = '''"""How large is it, bare?  The stable forms as functions of arrays of any library.

Nothing symbolic; written by `symhaptic kernels`.  Imports nothing; used by ``numeric``.
"""
'''


def forms() -> list[Form]:
    """All forms of a whole scene but those of one delay."""
    return [stable.form(name) for name in stable.FORMS if name not in stable.FOR_ONE_DELAY]


def files() -> dict[str, str]:
    """The files of the folder, by name."""
    _, made = request.built(TARGETS["numpy"], forms(), vectors=False)
    return {"__init__.py": _HEADER + _ABOUT} | {n: _HEADER + text for n, text in made.items()}


def differences(folder: Path = FOLDER) -> str:
    """A diff from what is there to what would be written; empty if nothing is stale."""
    lines: list[str] = []
    new = files()
    there = {path.name for path in folder.glob("*.py")}
    for name in sorted(there | set(new)):
        old = (folder / name).read_text(encoding="utf-8") if name in there else ""
        lines += unified_diff(
            old.splitlines(True), new.get(name, "").splitlines(True), f"a/{name}", f"b/{name}"
        )
    return "".join(lines)


def write(folder: Path = FOLDER) -> None:
    """All files, each whole or not at all, and no others."""
    folder.mkdir(exist_ok=True)
    new = files()
    for name, text in new.items():
        draft = folder / f".{name}-draft"
        draft.write_text(text, encoding="utf-8")
        draft.replace(folder / name)
    for path in folder.glob("*.py"):
        if path.name not in new:
            path.unlink()
