"""The package's own kernels: what the exporter writes for arrays, committed."""

from __future__ import annotations

from difflib import unified_diff
from hashlib import sha256
from pathlib import Path

from symhaptic.export import request
from symhaptic.export.precision import SINGLE
from symhaptic.export.targets import TARGETS
from symhaptic.export.ufuncs import MODULE, UNSTAMPED, ufuncs
from symhaptic.forms import stable
from symhaptic.forms.stable import Form

FOLDER = Path(__file__).parents[1] / "kernels"

_HEADER = "# Written by `symhaptic kernels` from the stable forms; do not edit.\n"

_REMARK = "/* Written by `symhaptic kernels` from the stable forms; do not edit. */\n"

_WRITTEN = ("*.py", "*.pyi", "*.c", "*.h")

_ABOUT = '''"""How large is it, bare?  The stable forms as functions of arrays of any library.

Nothing symbolic; written by `symhaptic kernels`.  Imports nothing; used by ``numeric``.
"""

STAMP = "%s"
"""Of the sources in C, as the module that is compiled of them has it."""
'''


def forms() -> list[Form]:
    """All forms of a whole scene but those of one delay."""
    return [stable.form(name) for name in stable.FORMS if name not in stable.FOR_ONE_DELAY]


def files() -> dict[str, str]:
    """The files of the folder, by name: for arrays of all libraries, and in C for NumPy's."""
    every = forms()
    _, made = request.built(TARGETS["numpy"], every, vectors=False)
    in_double, in_single = TARGETS["c"], TARGETS["c"].at(SINGLE)
    double, in_c = request.built(in_double, every, vectors=False)
    single, more = request.built(in_single, every, name="haptic_single", vectors=False)
    in_c |= more | ufuncs(double, single, in_double, in_single)
    stamp = sha256("".join(in_c.values()).encode()).hexdigest()[:16]
    in_c[f"{MODULE}.c"] = in_c[f"{MODULE}.c"].replace(UNSTAMPED, stamp)
    made |= {"__init__.py": _ABOUT % stamp} | in_c
    return {
        name: (_REMARK if name.endswith((".c", ".h")) else _HEADER) + text
        for name, text in made.items()
    }


def _there(folder: Path) -> list[Path]:
    """Those of a folder that are written here."""
    return [path for pattern in _WRITTEN for path in folder.glob(pattern)]


def differences(folder: Path = FOLDER) -> str:
    """A diff from what is there to what would be written; empty if nothing is stale."""
    lines: list[str] = []
    new = files()
    there = {path.name for path in _there(folder)}
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
    for path in _there(folder):
        if path.name not in new:
            path.unlink()
