"""From a request to a folder: what is asked for is checked before anything is written."""

from __future__ import annotations

import os
import re
import shutil
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from symhaptic.export.language import Refused, Target
from symhaptic.export.library import library
from symhaptic.export.precision import PRECISIONS
from symhaptic.export.readme import readme
from symhaptic.export.rounding import goals
from symhaptic.export.routine import Library
from symhaptic.export.sampled import MARGIN, delay_margin
from symhaptic.export.targets import TARGETS
from symhaptic.export.vectors import text as test_vectors
from symhaptic.forms import stable
from symhaptic.forms.derivatives import differentiable, with_derivatives
from symhaptic.forms.stable import Form, NoForm, of_whole_delays
from symhaptic.model.parts import FULL, Parts, left
from symhaptic.notation import epsilon
from symhaptic.notation.suggest import suggested

TITLE = "Passivity and stability of haptic walls"

LISTING = "FILES"
"""Name of the file that lists all files of an export: only these may be replaced."""

LISTED = "`symhaptic export --list` lists all"

_LONGEST = 6
"""Periods up to which a polynomial is written out."""

_LETTERS = 31
"""Of a name: so many count in every language."""


def target(name: str, precision: str | None = None) -> Target:
    """The target of this name, in a precision; in its own if none is named."""
    if name not in TARGETS:
        raise Refused(f"--target {name}: is not a target; {suggested(name, TARGETS)}")
    if precision is None:
        return TARGETS[name]
    if precision not in PRECISIONS:
        raise Refused(f"--precision {precision}: is not known; {suggested(precision, PRECISIONS)}")
    return TARGETS[name].at(PRECISIONS[precision])


def scene(words: str) -> Parts:
    """The loop that is left, such as ``"no-stiffness,no-delay"``.

    >>> scene("no-stiffness,no-delay").name
    'damping, virtual damping'
    """
    try:
        return left(words)
    except ValueError as wrong:
        raise Refused(f"--scene {wrong}") from None


def chosen(
    names: Sequence[str],
    parts: Parts = FULL,
    delay: int | None = None,
    derivatives: Sequence[str] = (),
    whole_delays: bool = False,
) -> list[Form]:
    """The forms of these names, or of these formulas of the paper; all of the scene if none.

    For integer delays alone where that is asked.
    With derivatives by these arguments, where any are named; of all forms, by those that each has.
    """
    if delay is not None and not 0 <= delay <= _LONGEST:
        raise Refused(f"--delay {delay}: is out of range; give an integer from 0 to {_LONGEST}")
    if delay is not None and not parts.delay:
        raise Refused(f"--delay {delay}: the scene has no delay; leave --delay out")
    if delay is not None and not any(_is_for_one_delay(n) for n in names or stable.FOR_ONE_DELAY):
        raise Refused(
            f"--delay {delay}: changes nothing for {', '.join(names)}; give it with "
            f"{', '.join(stable.FOR_ONE_DELAY)}"
        )
    if whole_delays and not parts.delay:
        raise Refused("--whole-delays: the scene has no delay; leave --whole-delays out")
    periods = (1 if delay is None else delay) if parts.delay else None
    if not names:
        every = list(stable.forms(parts, periods))
        if whole_delays:
            every = [of_whole_delays(form) for form in every if epsilon not in form.arguments]
        return _all_differentiated(every, derivatives) if derivatives else every
    found = {}
    for name in dict.fromkeys(names):
        form = _by_name(name, parts, periods)
        with _refused("--whole-delays"):
            found[form.name] = of_whole_delays(form) if whole_delays else form
    if not derivatives:
        return list(found.values())
    with _refused("--derivative"):
        by = tuple(dict.fromkeys(derivatives))
        return [with_derivatives(form, by) for form in found.values()]


@contextmanager
def _refused(option: str) -> Iterator[None]:
    """What has no form is refused with the option that asks for it."""
    try:
        yield
    except NoForm as lacking:
        raise Refused(f"{option}: {lacking}") from None


def _is_for_one_delay(name: str) -> bool:
    known = {id: own for own, ids in stable.STATEMENTS.items() for id in ids}
    return known.get(name, name) in stable.FOR_ONE_DELAY


def _all_differentiated(every: list[Form], by: Sequence[str]) -> list[Form]:
    """Each form by those arguments by which it has one; what has none is left as it is."""
    known = sorted({symbol.name for form in every for symbol in form.arguments})
    for name in by:
        if name not in known:
            raise Refused(
                f"--derivative {name}: is no argument of any function; {suggested(name, known)}"
            )
    found = []
    for form in every:
        has = differentiable(form)
        own = tuple(name for name in dict.fromkeys(by) if name in has)
        found.append(with_derivatives(form, own) if own else form)
    return found


def _by_name(name: str, parts: Parts, delay: int | None) -> Form:
    known = {id: own for own, ids in stable.STATEMENTS.items() for id in ids}
    own = known.get(name, name)
    if own == MARGIN:
        with _refused("FORMULA"):
            return delay_margin(stable.form("is_stable", parts))
    if re.fullmatch(r"eq([1-9]|[12]\d|3[01])", own):
        raise Refused(f"FORMULA: {stable.without_form(own)}")
    if own not in stable.FORMS:
        close = suggested(name, [*stable.FORMS, MARGIN, *known], LISTED)
        raise Refused(f"FORMULA: {name!r} has no stable form; {close}")
    with _refused("FORMULA"):
        return stable.form(own, parts, delay)


def built(
    language: Target, forms: Sequence[Form], name: str = "haptic", vectors: bool = True
) -> tuple[Library, dict[str, str]]:
    """The library and all files of an export, by name; without ``vectors`` the source alone."""
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or len(name) > _LETTERS:
        raise Refused(
            f"--name {name}: is no name; give a lower-case letter, then up to {_LETTERS - 1} "
            "of these, digits and _"
        )
    taken = {"selftest", "example", "main", "python", "numpy", *(form.name for form in forms)}
    if language.reserves(name) or name in taken | language.modules:
        raise Refused(f"--name {name}: is reserved in {language.title}; give another word")
    if MARGIN in {form.name for form in forms} and not language.samples:
        raise Refused(f"{MARGIN}: is exported in C only; leave it out")
    made = library(name, TITLE, forms, language)
    files = language.source(made)
    if not vectors:
        return made, files
    text = test_vectors(made.forms, language.precision)
    files |= language.package(made) | language.selftest(made)
    files |= {goal.file: goal.text for r in made.public for goal in goals(r, language)}
    files |= {"vectors.txt": text, "README.md": readme(made, language, text.count("\n"))}
    files[LISTING] = "\n".join(sorted([*files, LISTING])) + "\n"
    return made, files


def write(files: dict[str, str], folder: Path) -> None:
    """A folder that appears whole or not at all, in place of an older export at most.

    What no export has written in that one, such as what is built of it, stays.
    """
    kept = _kept(files, folder)
    try:
        draft = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.parent))
    except OSError as wrong:
        raise Refused(
            f"-o {folder}: cannot write there ({wrong.strerror}); a folder in one that exists is "
            "allowed"
        ) from None
    try:
        new = draft / "new"
        for name, text in files.items():
            path = new / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        for path in kept:
            copy = new / path.relative_to(folder)
            if path.is_dir() and not path.is_symlink():
                copy.mkdir(parents=True, exist_ok=True)
            else:
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(path, copy, follow_symlinks=False)
        if folder.exists():
            os.replace(folder, draft / "old")
        os.replace(new, folder)
    except OSError as wrong:
        if (draft / "old").exists() and not folder.exists():
            os.replace(draft / "old", folder)
        raise Refused(f"-o {folder}: cannot write there ({wrong.strerror})") from None
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def _kept(files: Iterable[str], folder: Path) -> list[Path]:
    """What is in the folder of an older export and not its own, folders included; nothing that
    is to be written may be in its place."""
    if folder.is_symlink() or (folder.exists() and not folder.is_dir()):
        raise Refused(f"-o {folder}: is no folder; give a new or an empty one")
    if not folder.exists():
        return []
    listing = folder / LISTING
    own = listing.read_text(encoding="utf-8").split("\n") if listing.is_file() else []
    above = {parent for name in own for parent in Path(name).parents}
    kept = []
    for path in sorted(folder.rglob("*")):
        inside = path.relative_to(folder)
        if inside.as_posix() in own or inside in above:
            continue
        loose = path.is_symlink() or not path.is_dir()
        if loose and (not own or _meets(inside, files)):
            raise Refused(
                f"-o {folder}: holds other files ({inside.as_posix()}); give a new or empty "
                "folder, or that of an earlier export"
            )
        kept.append(path)
    return kept


def _meets(place: Path, files: Iterable[str]) -> bool:
    """Whether one of the files is there, or below it, or above it."""
    return any(place in (p := Path(f), *p.parents) or p in place.parents for f in files)
