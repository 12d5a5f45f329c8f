"""Rooms: each imports only rooms above it, no import goes in a circle, and nothing lies loose."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest

import symhaptic

HOME = Path(symhaptic.__file__).parent

ROOMS = (
    *("notation", "paper", "rules", "model", "proof", "forms", "export", "kernels", "balls"),
    *("numeric", "loops", "bounds", "book", "rocq", "scene", "sweeps", "bench", "check", "cli"),
)
"""Each may import those before it."""

ALL_NAMES = ("bench.functions", "book.report.reference")
"""They go through the public names of the package."""

LOOSE = {"__init__", "__main__", "version"}


@cache
def modules():
    """Dotted names below the package, with their files."""
    found = {}
    for path in sorted(HOME.rglob("*.py")):
        parts = path.relative_to(HOME).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


@cache
def imported(module):
    """What a module imports: at its top, when a function runs, and for types."""
    tree = ast.parse(modules()[module].read_text(encoding="utf-8"))
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {a.name for a in node.names if a.name.startswith("symhaptic")}
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("symhaptic"):
            found |= {
                f"{node.module}.{a.name}"
                if f"{node.module}.{a.name}".removeprefix("symhaptic.") in modules()
                else node.module
                for a in node.names
            }
    names = {name.removeprefix("symhaptic").removeprefix(".") for name in found}
    return sorted(names)


def room(module):
    return module.split(".")[0]


def test_nothing_lies_loose():
    assert {p.stem for p in HOME.glob("*.py")} == LOOSE
    folders = {p.name for p in HOME.iterdir() if p.is_dir() and (p / "__init__.py").is_file()}
    assert folders == set(ROOMS)


def about(folder):
    """What a folder says of itself."""
    path = HOME / folder / "__init__.py"
    return ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""


@pytest.mark.parametrize("name", ROOMS)
def test_a_room_says_its_question_and_its_neighbours(name):
    """The question, what each file answers, what may be imported there, from where it is used."""
    said = about(name)
    assert "?" in said.splitlines()[0]
    imports, users = re.fullmatch(r".*Imports\s(.*?); used\sby\s(.*)", said, re.DOTALL).groups()
    assert {r for r in re.findall(r"``(\w+)``", imports) if r in ROOMS} <= neighbours(name)
    for user in set(re.findall(r"``(\w+)``", users.partition(", and never")[0])) & set(ROOMS):
        assert name in neighbours(user), user


def neighbours(name):
    """The rooms from which a room imports."""
    return {room(other) for m in modules() if room(m) == name for other in imported(m)} - {name}


FOLDERS = sorted(str(path.parent.relative_to(HOME)) for path in HOME.glob("*/**/__init__.py"))
ROOT = Path(__file__).parents[1]


@pytest.mark.parametrize("folder", FOLDERS)
def test_the_files_that_a_folder_names_are_there(folder):
    """``name`` is a file beside it or a room; what looks like a path is one."""
    said = about(folder)
    beside = {path.stem for path in (HOME / folder).iterdir()}
    assert set(re.findall(r"``(\w+)``", said)) <= {*beside, *ROOMS, "symhaptic"}
    for path in re.findall(r"`([\w./*]+)`", said):
        if "/" in path or ("." in path and not path.startswith("symhaptic.")):
            assert any([*place.glob(path)] for place in (HOME / folder, HOME, ROOT)), path


@pytest.mark.parametrize("name", ROOMS)
def test_arrows_run_down(name):
    allowed = {*ROOMS[: ROOMS.index(name) + 1], "version"}
    up = {
        f"{module} -> {other or 'the package'}"
        for module in modules()
        if room(module) == name
        for other in imported(module)
        if room(other) not in allowed and not (other == "" and module in ALL_NAMES)
    }
    assert sorted(up) == []


def chain(start, goal, over):
    """A way of imports from one module to another, or nothing."""
    ways, seen = [[start]], {start}
    while ways:
        way = ways.pop(0)
        for other in over(way[-1]):
            if other == goal:
                return [*way, goal]
            if other in modules() and other not in seen:
                seen.add(other)
                ways.append([*way, other])
    return []


@pytest.mark.parametrize("name", ROOMS)
def test_no_import_goes_in_a_circle(name):
    """Imports of a function and for types count, too."""
    for module in modules():
        if room(module) == name:
            circle = chain(module, module, imported)
            assert not circle, " -> ".join(circle)


@pytest.mark.parametrize(
    ("start", "goal"),
    [("model", "paper"), ("forms", "paper"), ("numeric", "book"), ("bounds", "book")],
)
def test_a_room_never_reaches_another(start, goal):
    for module in modules():
        if room(module) == start:
            for other in modules():
                if room(other) == goal:
                    way = chain(module, other, imported)
                    assert not way, " -> ".join(way)
                    break


def parents(module):
    """Packages whose own file is run when a module is imported."""
    parts = module.split(".")
    return {".".join(parts[:i]) for i in range(1, len(parts))}


@pytest.mark.parametrize("start", ["numeric", "kernels"])
def test_numbers_never_load_sympy(start):
    needed = {m for m in modules() if room(m) == start}
    while more := {o for m in needed for o in {*imported(m), *parents(m)} if o} - needed:
        if not (more := {m for m in more if room(m) != "balls"}):  # loaded where digits are asked
            break
        needed |= more
    for module in needed:
        for node in ast.parse(modules()[module].read_text(encoding="utf-8")).body:
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            if isinstance(node, ast.ImportFrom):
                names = [node.module]
            assert not {n.split(".")[0] for n in names} & {"sympy", "flint", "mpmath"}, module


def test_kernels_need_nothing():
    assert {other for m in modules() if room(m) == "kernels" for other in imported(m)} <= {
        m for m in modules() if room(m) == "kernels"
    }
