"""Importing the package is light, its types agree, and its version stands in one place."""

import ast
import subprocess
import sys
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


def test_the_version_stands_in_one_place():
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"version: {symhaptic.__version__}\n" in citation


def test_a_public_name_is_not_hidden_by_a_module():
    """A submodule of the same name would take its place once it is imported."""
    code = (
        "import importlib, pkgutil, symhaptic; "
        "modules = {m.name for m in pkgutil.iter_modules(symhaptic.__path__)}; "
        "print(modules & set(symhaptic.__all__))"
    )
    assert python(code) == "set()"
