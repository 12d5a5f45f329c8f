"""Every pair of language, scene, derivative, delays, precision and function is exported and run.

The functions of rows that are alike otherwise share an export.  SYMHAPTIC_ALL_EXPORTS=1 takes each
function alone, in every scene, with every derivative, in every language.
"""

import os
from contextlib import suppress
from functools import cache
from itertools import product

import pytest
from export.covering import covering, pairs
from export.test_targets import run_all

from symhaptic.export import request, vectors
from symhaptic.export.language import Refused
from symhaptic.export.targets import TARGETS
from symhaptic.forms import stable
from symhaptic.forms.derivatives import differentiable, with_derivatives
from symhaptic.forms.stable import NoForm, of_whole_delays

ALL = bool(os.environ.get("SYMHAPTIC_ALL_EXPORTS"))
PARTS = "stiffness", "damping", "virtual-damping", "delay"
FEW = ["", "no-stiffness", "no-damping", "no-virtual-damping", "no-delay",
       "no-stiffness,no-damping", "no-stiffness,no-damping,no-delay"]  # fmt: skip
EVERY = [",".join(f"no-{p}" for p, out in zip(PARTS, some, strict=True) if out)
         for some in product([False, True], repeat=4)]  # fmt: skip
SOURCE = ".c", ".h", ".cpp", ".hpp", ".f90", ".rs", ".mjs", ".js", ".m", ".py"
FACTORS = {
    "language": list(TARGETS),
    "scene": EVERY if ALL else FEW,
    "by": ["", "delta", "d", "gamma", "alpha", "beta", "theta", "epsilon"] if ALL else ["", "all"],
    "delay": [None, 0, 1, 2, 3, 4, 5, 6] if ALL else [None, 0, 6],
    "precision": ["double", "single"],
    "function": list(stable.FORMS),
    "whole": [False, True],
}


@cache
def precisions(language):
    """Those that are not refused."""
    found = []
    for name in FACTORS["precision"]:
        with suppress(Refused):
            found.append(request.target(language, name) and name)
    return found


@cache
def form(name, scene, delay):
    """The form, if the scene has it."""
    parts = request.scene(scene)
    try:
        return stable.form(name, parts, delay)
    except NoForm:
        return None


def periods(row):
    return 0 if "no-delay" in row["scene"] and row["delay"] is None else row["delay"]


def allowed(row):
    """What is not refused; a derivative only of what has one, a delay only where it counts."""
    for_one = row["function"] in stable.FOR_ONE_DELAY
    if row["precision"] not in precisions(row["language"]):
        return False
    if for_one != (row["delay"] is not None or "no-delay" in row["scene"]):
        return False
    if "no-delay" in row["scene"] and row["delay"] is not None:
        return False
    own = form(row["function"], row["scene"], periods(row) if for_one else None)
    if own is None or (row["whole"] and not whole(own)):
        return False
    return row["by"] in ("", "all") or row["by"] in {s.name for s in own.arguments}


@cache
def whole(own):
    """The form for whole delays alone, if there is another one."""
    if "d" not in {s.name for s in own.arguments}:
        return None
    try:
        return of_whole_delays(own)
    except NoForm:
        return None


@cache
def slopes(own):
    return differentiable(own)


def asked(row):
    """The form of a row, with the derivatives that it has of those asked for."""
    for_one = row["function"] in stable.FOR_ONE_DELAY
    own = form(row["function"], row["scene"], periods(row) if for_one else None)
    own = whole(own) if row["whole"] else own
    by = () if not row["by"] else slopes(own) if row["by"] == "all" else (row["by"],)
    return with_derivatives(own, by) if by and set(by) <= set(slopes(own)) else own


def rows():
    if ALL:
        names, values = zip(*FACTORS.items(), strict=True)
        found = (dict(zip(names, row, strict=True)) for row in product(*values))
        return [row for row in found if allowed(row)]
    return covering(FACTORS, allowed)


@cache
def grouped():
    """Exports of each language and scene: their precision, and the rows of functions in them.

    Of forms for one delay only one is in an export, which has one function of each name.
    """
    exports, apart = {}, {}
    for row in rows():
        key = row["language"], row["scene"], row["precision"], row["function"]
        if ALL:
            key = *key, row["by"], row["delay"]
        level = apart[key] = apart.get(key, -1) + 1
        exports.setdefault((*key[:3], key[3:] if ALL else (), level), []).append(row)
    found = {}
    for (language, scene, precision, *_), members in exports.items():
        found.setdefault((language, scene), []).append((precision, members))
    return found


def each_of(languages):
    """Languages and scenes as parameters of a test; their exports are chosen when it runs."""
    cases = list(product(languages, FACTORS["scene"]))
    ids = [f"{language}-{scene or 'everything'}" for language, scene in cases]
    return pytest.mark.parametrize(("language", "scene"), cases, ids=ids)


def written(language, scene, folder, monkeypatch):
    """The exports of a language and a scene, with fewer vectors: the target and folder of each."""
    monkeypatch.setattr(vectors, "_MOST", 12)
    few = lambda form, p: (*vectors._rows(form, p), *vectors._outside(form, p))  # noqa: E731
    monkeypatch.setattr(vectors, "vectors", few)
    assert grouped()[language, scene]
    for place, (precision, members) in enumerate(grouped()[language, scene]):
        target = request.target(language, precision)
        _, files = request.built(target, [asked(row) for row in members])
        source = (text for name, text in files.items() if name.endswith(SOURCE))
        assert max(len(line) for text in source for line in text.splitlines()) <= 100
        request.write(files, folder / f"{place}")
        yield target, folder / f"{place}"


WATCHED = ["-g", "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]


@pytest.mark.slow
@each_of(TARGETS)
def test_the_self_test_passes(language, scene, tmp_path, monkeypatch):
    """In C and C++ also with sanitizers: nothing in it is undefined."""
    for target, folder in written(language, scene, tmp_path, monkeypatch):
        said = run_all(target, "haptic", folder)
        assert int(said.split()[0]) > 0
        if language in ("c", "cpp", "microcontroller"):
            compile_, run = target.commands("haptic")
            with monkeypatch.context() as patch:
                patch.setattr(target, "commands", lambda _, both=[[*compile_, *WATCHED], run]: both)
                assert run_all(target, "haptic", folder) == said


def test_every_pair_occurs():
    """Two of three factors with three values each take nine rows; one pair is forbidden."""
    factors = {"a": "xyz", "b": "123", "c": "+-"}
    rows = covering(factors, lambda row: (row["a"], row["b"]) != ("x", "1"))
    seen = set().union(*map(pairs, rows))
    assert len(seen) == 9 + 6 + 6 - 1
    assert 8 <= len(rows) <= 12
