"""What users install: the sdist, the wheel that is built from it, and what the wheel's commands do.

Both are built once.  The wheel is installed into an environment of its own, which has only what
its metadata asks for with the extras report and sweep; these are links to what is installed here.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import venv
import zipfile
from email.parser import HeaderParser
from importlib.metadata import distribution
from pathlib import Path

import pytest
from once import once

import symhaptic
from symhaptic.cli.main import app

requirements = pytest.importorskip("packaging.requirements")
pytest.importorskip("setuptools")

ROOT = Path(__file__).parents[1]
CLEAN = {
    name: value
    for name, value in os.environ.items()
    if name not in ("PYTHONPATH", "PYTEST_ADDOPTS", "SYMHAPTIC_KERNELS")
}
pytestmark = [pytest.mark.ci, pytest.mark.early]


def done(command, folder, **changed):
    """What a command prints, which has to succeed; ``changed`` is its environment."""
    run = subprocess.run(
        list(map(str, command)), cwd=folder, env=CLEAN | changed, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    assert run.returncode == 0, f"{command}\n{run.stdout[-2000:]}{run.stderr[-2000:]}"
    return run.stdout


def sources():
    """Names of the files that make up the project: those of Git, or all of an unpacked sdist."""
    if (ROOT / ".git").exists():
        listed = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
        return [name for name in done(listed, ROOT).split("\n") if (ROOT / name).is_file()]
    names = [path.relative_to(ROOT) for path in ROOT.rglob("*") if path.is_file()]
    return [n for n in names if not n.parts[0].startswith(".") and n.parts[0] not in _BUILT]


_BUILT = {"build", "dist"}


def build(what, folder, source, **changed):
    """Make the sdist or the wheel of a source with the backend that pyproject.toml names."""
    backend = "import sys; from setuptools import build_meta; build_meta.build_{}(sys.argv[1])"
    done([sys.executable, "-c", backend.format(what), folder], source, **changed)


@pytest.fixture(scope="module")
def sdist(tmp_path_factory):
    """The sdist, unpacked; it is made of a copy, where nothing is left of earlier builds."""

    def make(folder):
        for name in sources():
            (folder / "copy" / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / "copy" / name)
        build("sdist", folder, folder / "copy")
        (packed,) = folder.glob("*.tar.gz")
        shutil.unpack_archive(packed, folder)

    return once(tmp_path_factory, "sdist", make) / f"symhaptic-{symhaptic.__version__}"


@pytest.fixture(scope="module")
def wheel(sdist, tmp_path_factory):
    """The wheel, built from the sdist, and unpacked beside it."""

    def make(folder):
        build("wheel", folder, sdist)
        (packed,) = folder.glob("*.whl")
        zipfile.ZipFile(packed).extractall(folder / "unpacked")

    (packed,) = once(tmp_path_factory, "wheel", make).glob("*.whl")
    return packed


@pytest.fixture(scope="module")
def inside(wheel):
    """The package in the wheel."""
    return wheel.parent / "unpacked" / "symhaptic"


@pytest.fixture(scope="module")
def metadata(inside):
    """What the wheel says of itself."""
    (found,) = inside.parent.glob("*.dist-info/METADATA")
    return HeaderParser().parsestr(found.read_text(encoding="utf-8"))


def needed(asked, extras):
    """The installed distributions that requirements with these extras ask for, at any depth."""
    waiting = [(text, frozenset(extras)) for text in asked]
    found = {}
    while waiting:
        text, extras = waiting.pop()
        one = requirements.Requirement(text)
        if one.marker and not any(one.marker.evaluate({"extra": e}) for e in extras | {""}):
            continue
        known = found.setdefault(one.name.lower(), set())
        if not known or not one.extras <= known:
            known.update(one.extras, {""})
            below = distribution(one.name).requires or []
            waiting += [(text, frozenset(one.extras)) for text in below]
    return [distribution(name) for name in found]


@pytest.fixture(scope="module")
def clean(wheel, metadata, tmp_path_factory):
    """The programs of an environment with the wheel, what it asks for, and nothing else."""

    def make(folder):
        venv.create(folder, symlinks=True)
        (site,) = folder.glob("lib/*/site-packages")
        for one in needed(metadata.get_all("Requires-Dist"), ("report", "sweep")):
            for top in {file.parts[0] for file in one.files or ()} - {"..", "__pycache__"}:
                if not (site / top).exists():
                    (site / top).symlink_to(one.locate_file(top))
        pip = [sys.executable, "-m", "pip", "--python", folder / "bin/python", "install", "--quiet"]
        pip += ["--no-deps", "--no-index", "--disable-pip-version-check"]
        done([*pip, wheel], folder)

    return once(tmp_path_factory, "clean", make) / "bin"


# -- the sdist --------------------------------------------------------------------------------


def test_the_tests_of_the_sdist_can_be_collected(sdist):
    """The quick ones, those of guides and docstrings among them."""
    collect = [sys.executable, "-m", "pytest", "--collect-only"]
    found = done(collect, sdist, PYTHONPATH=str(sdist / "src"))
    assert re.search(r"^\d{4,}/\d{4,} tests collected", found, re.MULTILINE), found[-500:]


def test_the_sdist_has_all_files_but_reports(sdist):
    ours = {str(name) for name in sources() if not str(name).startswith((".", "reports/"))}
    there = {str(path.relative_to(sdist)) for path in sdist.rglob("*") if path.is_file()}
    assert ours <= there, ours - there


# -- the wheel --------------------------------------------------------------------------------


def test_the_wheel_has_all_that_its_commands_read(sdist, inside):
    """Templates, scripts, styles and types beside the modules, chapters, guides and records."""
    for path in (p for p in sdist.rglob("*") if p.is_file() and p.suffix != ".pyc"):
        name = path.relative_to(sdist)
        source = path.suffix in (".c", ".cpp", ".h", ".so")
        if name.parts[:2] == ("src", "symhaptic") and not source:
            assert (inside / name.relative_to("src/symhaptic")).exists(), name
        if name.parts[0] in ("derivations", "docs", "reports"):
            assert (inside / name).exists(), name
    assert (inside / "CONTRIBUTING.md").is_file()
    assert (inside / "py.typed").is_file()  # PEP 561


def test_the_description_needs_no_file_beside_it(metadata):
    """An index shows the README alone, where a relative link leads nowhere."""
    assert metadata["Description-Content-Type"] == "text/markdown"
    text = metadata.get_payload()
    assert "Verified formulas for haptic control" in text
    assert [link for link in re.findall(r"\]\(([^)]*)\)", text) if "://" not in link] == []
    assert metadata.get_all("Project-URL")
    versions = {c for c in metadata.get_all("Classifier") if ":: 3." in c}
    assert f"Programming Language :: Python :: 3.{sys.version_info[1]}" in versions


NUMBERS = "import symhaptic; symhaptic.show_config(); print(*symhaptic.discretize(0.0, 0.0))"
FREE_MASS = "0.5 0.5 2.0 1.0"  # t^2/2 and two roots at 1


@pytest.mark.skipif(shutil.which("cc") is None, reason="no compiler here")
def test_the_wheel_needs_no_compiler_to_run_its_compiled_kernels(clean, tmp_path):
    found = done([clean / "python", "-c", NUMBERS], tmp_path, PATH=str(tmp_path)).split("\n")
    assert "kernels: compiled" in found
    assert found[-2] == FREE_MASS


def test_without_a_compiler_the_install_works_on_the_array_kernels(sdist, tmp_path):
    """PATH holds nothing and no compiler is named: the extension is left out."""
    skipped = shutil.ignore_patterns("build", "tests", "*.so")
    copy = shutil.copytree(sdist, tmp_path / "copy", ignore=skipped)
    nowhere = {"PATH": str(tmp_path / "empty"), "CC": "", "CXX": ""}
    build("wheel", tmp_path, copy, **nowhere)
    (made,) = tmp_path.glob("*.whl")
    zipfile.ZipFile(made).extractall(tmp_path / "site")
    path = {"PYTHONPATH": str(tmp_path / "site")}
    found = done([sys.executable, "-c", NUMBERS], tmp_path, **nowhere, **path).split("\n")
    assert "kernels: array" in found
    assert found[-2] == FREE_MASS


# -- its commands -----------------------------------------------------------------------------


DEVICE = """
mass = "72 g"
damping = "0.005 Ns/mm"
sampling_period = "1 ms"
delay = "1.5 ms"
"""
MINE = """
def limit(beta, delta, d):
    return (beta + delta)/(d + 0.5)
"""
SWEPT = """
from symhaptic import Scene, sweep

scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.001)
for to in ("limits.zarr", "limits.parquet"):
    sweep("max_stable_stiffness", scene, damping=[0.5, 2.0], delay=[0.0, 0.001], to=to)
assert scene.is_stable(K=100.0, B=1.0)
scene.plot()
"""
FEW = """
from dataclasses import replace

from symhaptic.bench import measuring, timing
from symhaptic.book import chapters
from symhaptic.cli.main import main

few = [chapters.folder() / f"{name}.py" for name in ("s2a_device", "s5b_stiffest_wall")]
chapters.shipped = lambda: few
timing.LEAST = 0.0
effort = measuring.functions.Effort(12, 2, 20)
names = ("max_passive_stiffness",)
measuring.QUICK = replace(measuring.QUICK, effort=effort, names=names, long=(0, 2), plants=2)
main()
"""
"""The commands with two chapters, and with few and short measurements.

Other tests look at all chapters, and at what is measured.
"""
COMMANDS = [
    ("--version", "--version", r"symhaptic [\d.]+ \(compiled kernels\)\n"),
    ("verify", "verify eq11 --strict", "qualified"),
    ("verify list", "verify --list", "eq11"),
    ("verify a source", "verify --source notes --strict", "misprint"),
    ("mutants", "mutants --source notes", "0 accepted though wrong"),
    ("report a chapter", "report --chapter s2a_device --standalone --format tex -o out", "wrote"),
    ("report one page", "report --chapter s2a_device --standalone --format html -o page", "wrote"),
    ("report list", "report --list", "s2a_device"),
    ("export", "export is_stable linear_limit --target c -o device", "wrote"),
    ("check", "check --formula linear_limit --python mine:limit --points 200", "agrees"),
    ("check list", "check --list", "eq11"),
    ("check table", "check --formula eq11 --format table --points 5", ","),
    ("limits", "limits device.toml", "N/m"),
    ("limits drawn", "limits device.toml -o walls.svg", "passive up to"),
    ("controller", "controller stiff.toml -o wall", "wrote"),
    ("trace", "trace --gamma 0.001 --delta 0.02 --delay 1.5 -o region.svg", ""),
    ("jury", "jury 1 --gamma 0.001 --delta 0.02", "alpha"),
    ("kernels", "kernels --check", ""),
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with the files that a user of the commands has."""
    folder = tmp_path_factory.mktemp("used")
    (folder / "device.toml").write_text(DEVICE)
    (folder / "stiff.toml").write_text(DEVICE + '[wall]\nK = "0.4 N/mm"\nB = 5\n')
    (folder / "mine.py").write_text(MINE)
    (folder / "swept.py").write_text(SWEPT)
    (folder / "few.py").write_text(FEW)
    (folder / "notes").mkdir()
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "CONTRIBUTING.md").read_text(), re.DOTALL)
    (source,) = (i for i, block in enumerate(blocks) if block.startswith("# source.py"))
    (folder / "notes/source.py").write_text(blocks[source])
    (folder / "notes/drift.py").write_text(blocks[source + 1])
    return folder


def test_each_command_is_tried():
    """What is new has to be added above."""
    tried = {words.split()[0] for _, words, _ in COMMANDS} | {"bench"}
    assert tried >= {command.callback.__name__ for command in app.registered_commands}


@pytest.mark.parametrize(("asked", "said"), [pytest.param(*c[1:], id=c[0]) for c in COMMANDS])
def test_each_command_of_the_wheel_works(asked, said, clean, folder):
    found = done([clean / "symhaptic", *asked.split()], folder)
    assert re.search(said, found), found


def test_verdicts_of_the_wheel_are_those_committed(clean, folder):
    found = done([clean / "symhaptic", "verify", "eq1", "eq5", "--format", "json"], folder)
    verdicts = {r["id"]: r["verdict"] for r in json.loads(found)["statements"]}
    assert verdicts == {"eq1": "definition", "eq5": "qualified"}


def test_a_sweep_and_a_picture_from_the_wheel(clean, folder):
    done([clean / "python", "swept.py"], folder)
    assert (folder / "limits.zarr").is_dir()
    assert (folder / "limits.parquet").is_dir()


def test_the_site_of_the_wheel_has_guides_and_explorer(clean, folder):
    done([clean / "python", "few.py", "report", "--format", "html"], folder)
    pages = {path.stem for path in (folder / "reports" / "site").glob("*.html")}
    assert {"index", "explorer", "tutorial", "contributing", "s5b_stiffest_wall"} <= pages


def test_a_measurement_from_the_wheel(clean, folder):
    said = done([clean / "python", "few.py", "bench", "--quick", "-o", "measured"], folder)
    assert "tables and plots" in said
