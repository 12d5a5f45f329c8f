"""What is installed is what is in the repository, and importing it is light."""

import ast
import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import symhaptic

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src" / "symhaptic"


def python(code: str, **options) -> str:
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, **options
    )
    return run.stdout.strip()


def test_importing_the_package_loads_nothing_symbolic():
    code = (
        "import sys, symhaptic; "
        "print([m for m in ('sympy', 'flint', 'matplotlib', 'typer') if m in sys.modules])"
    )
    assert python(code) == "[]"


def test_the_numeric_functions_load_nothing_symbolic():
    code = (
        "import sys, symhaptic; "
        "symhaptic.stable_region, symhaptic.max_stable_stiffness, symhaptic.is_passive; "
        "heavy = ('sympy', 'flint', 'mpmath', 'matplotlib', 'jax', 'torch'); "
        "print([m for m in heavy if m in sys.modules])"
    )
    assert python(code) == "[]"


def test_every_public_name_loads_when_used():
    code = "import symhaptic; print(all(getattr(symhaptic, n) for n in symhaptic.__all__))"
    assert python(code) == "True"


@pytest.mark.ci
@pytest.mark.early
def test_the_types_agree():
    """mypy's answer, here and not before the tests, since it keeps one processor busy alone."""
    said = subprocess.run(
        [sys.executable, "-m", "mypy"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert said.returncode == 0, said.stdout + said.stderr


def test_no_blanket_except_and_no_simplify():
    for path in [*SOURCE.rglob("*.py"), *(ROOT / "derivations").glob("*.py")]:
        text = path.read_text(encoding="utf-8")
        assert "simplify(" not in text, path
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.ExceptHandler):
                assert node.type is not None, path
                names = {n.id for n in ast.walk(node.type) if isinstance(n, ast.Name)}
                if (
                    path.parent.name == "check"
                ):  # what a function of somebody else's raises is reported
                    names -= {"BaseException"}
                assert not names & {"BaseException", "Exception"}, path


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    """A copy of what an install needs, where nothing is left of earlier builds."""
    pytest.importorskip("setuptools")
    folder = tmp_path_factory.mktemp("source")
    names = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    ).stdout.split("\n")  # fmt: skip
    for name in filter(None, names):
        if (ROOT / name).is_file() and not name.startswith(("tests/", "benchmarks/")):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
    return folder


def wheel_of(source, folder, environment=None):
    """The wheel, unpacked."""
    subprocess.run(
        [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation",
         "--disable-pip-version-check", "-w", folder, source],
        check=True, env=environment,
    )  # fmt: skip
    (wheel,) = folder.glob("*.whl")
    zipfile.ZipFile(wheel).extractall(folder / "site")
    return folder / "site"


@pytest.fixture(scope="module")
def unpacked(source, tmp_path_factory):
    return wheel_of(source, tmp_path_factory.mktemp("wheel"))


@pytest.mark.ci
def test_the_wheel_works_outside_the_repository(unpacked, tmp_path):
    code = (
        "import symhaptic, symhaptic.cli.main; print(symhaptic.__file__, flush=True); "
        "import sys; sys.argv = ['symhaptic', 'verify', 'eq1', 'eq5', '--format', 'json']; "
        "symhaptic.cli.main.main()"
    )
    environment = os.environ | {"PYTHONPATH": str(unpacked)}
    first, _, rest = python(code, cwd=tmp_path, env=environment).partition("\n")
    assert first.startswith(str(unpacked))
    verdicts = {r["id"]: r["verdict"] for r in json.loads(rest)["statements"]}
    assert verdicts == {"eq1": "definition", "eq5": "qualified"}


@pytest.mark.ci
def test_the_wheel_has_all_that_its_commands_read(source, unpacked):
    """Templates, scripts and styles beside the modules, chapters, guides and records."""
    inside = unpacked / "symhaptic"
    for path in (p for p in source.rglob("*") if "build" not in p.relative_to(source).parts):
        name = path.relative_to(source)
        if name.parts[:2] == ("src", "symhaptic") and path.suffix not in (".c", ".h"):
            assert (inside / name.relative_to("src/symhaptic")).exists(), name
        if name.parts[0] in ("derivations", "docs") or name.match("reports/*.json"):
            assert (inside / name).exists(), name
    assert (inside / "CONTRIBUTING.md").is_file()


@pytest.mark.slow
def test_the_wheel_makes_the_site(unpacked, tmp_path):
    environment = os.environ | {"PYTHONPATH": str(unpacked)}
    code = "from symhaptic.__main__ import main; main()"
    subprocess.run(
        [sys.executable, "-c", code, "report", "--format", "html", "-o", "made"],
        cwd=tmp_path, env=environment, check=True,
    )  # fmt: skip
    pages = {path.stem for path in (tmp_path / "made" / "site").glob("*.html")}
    assert {"index", "explorer", "tutorial", "contributing", "s5b_stiffest_wall"} <= pages


def test_the_version_stands_in_one_place():
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"version: {symhaptic.__version__}\n" in citation


@pytest.mark.ci
def test_the_wheel_says_that_it_is_typed(unpacked):
    """PEP 561: without this file a checker takes every name of the package for Any."""
    assert (unpacked / "symhaptic" / "py.typed").is_file()


def test_a_public_name_is_not_hidden_by_a_module():
    """A submodule of the same name would take its place once it is imported."""
    code = (
        "import importlib, pkgutil, symhaptic; "
        "modules = {m.name for m in pkgutil.iter_modules(symhaptic.__path__)}; "
        "print(modules & set(symhaptic.__all__))"
    )
    assert python(code) == "set()"


CLEAN = (
    "import symhaptic; print(symhaptic.__file__, flush=True); symhaptic.show_config(); "
    "print(*symhaptic.discretize(0.0, 0.0))"
)


@pytest.mark.ci
def test_without_a_compiler_the_install_works_on_the_array_kernels(source, tmp_path):
    """PATH holds nothing and no compiler is named: the extension is left out."""
    copied = shutil.copytree(source, tmp_path / "source", ignore=shutil.ignore_patterns("build"))
    environment = {k: v for k, v in os.environ.items() if k not in ("CC", "CXX", "PYTHONPATH")}
    environment["PATH"] = str(tmp_path / "empty")
    wheel_of(copied, tmp_path, environment)
    environment["PYTHONPATH"] = str(tmp_path / "site")
    found = python(CLEAN, cwd=tmp_path, env=environment).split("\n")
    assert found[0].startswith(str(tmp_path / "site"))
    assert "kernels: array" in found
    assert found[-1] == "0.5 0.5 2.0 1.0"  # a free mass: t^2/2 and two roots at 1


@pytest.mark.ci
@pytest.mark.skipif(shutil.which("cc") is None, reason="no compiler here")
def test_the_wheel_needs_no_compiler_to_run_its_compiled_kernels(unpacked, tmp_path):
    environment = os.environ | {"PYTHONPATH": str(unpacked), "PATH": str(tmp_path)}
    found = python(CLEAN, cwd=tmp_path, env=environment).split("\n")
    assert found[0].startswith(str(unpacked))
    assert "kernels: compiled" in found
    assert found[-1] == "0.5 0.5 2.0 1.0"
