"""Public docstrings have the sections of numpydoc, and name every argument."""

import inspect
import re

import pytest

import symhaptic


def public():
    """Names and callables: all functions, and the classes and methods that people call."""
    for name in symhaptic.__all__:
        thing = getattr(symhaptic, name)
        if not inspect.isclass(thing):
            yield name, thing
    for method, of in vars(symhaptic.Scene).items():
        if not method.startswith("_") and (inspect.isfunction(of) or hasattr(of, "__func__")):
            yield f"Scene.{method}", getattr(of, "__func__", of)


CALLED = dict(public())
QUIET = ("show_config",)
"""Without a result."""


def section(text, title):
    """The lines of a section."""
    shape = rf"^{title}\n-+\n(.*?)(?=\n\n[A-Z][^\n]*\n---|\Z)"
    found = re.search(shape, text, re.DOTALL | re.MULTILINE)
    return found[1] if found else ""


@pytest.mark.parametrize("name", CALLED)
def test_a_docstring_describes_every_argument_and_the_result(name):
    thing = CALLED[name]
    text = inspect.getdoc(thing) or ""
    heads = re.findall(r"^(\S.*?) : ", section(text, "Parameters"), re.MULTILINE)
    heads += re.findall(r"^\*\*(\w+)$", section(text, "Parameters"), re.MULTILINE)
    described = [one for head in heads for one in head.split(", ")]
    parameters = [n for n in inspect.signature(thing).parameters if n not in ("self", "cls")]
    assert described == parameters
    assert section(text, "Returns") or name in QUIET
    assert len(text.split("\n\n")[0].split("\n")) == 1, "the summary takes one line"


@pytest.mark.parametrize("name", CALLED)
def test_a_docstring_has_an_example(name):
    assert ">>> " in (inspect.getdoc(CALLED[name]) or "")


def test_a_missing_argument_is_found():
    text = "Sum.\n\nParameters\n----------\na, b : float\n    Both.\n\nReturns\n-------\nfloat"
    assert section(text, "Parameters") == "a, b : float\n    Both."
    assert section(text, "Raises") == ""
