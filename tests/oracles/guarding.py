"""Which chapter an oracle guards: ``@guards("s3b_rise")`` before a test function."""

import ast
from pathlib import Path

import pytest


def guards(*chapters):
    """The test that follows checks these chapters by another road than their proofs."""
    return pytest.mark.guards(*chapters)


def guarded(folder=Path(__file__).parent):
    """The oracles of each chapter, read from the files beside this one without running them."""
    found = {}
    for path in sorted(folder.glob("test_section_*.py")):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
                for mark in node.decorator_list:
                    if isinstance(mark, ast.Call) and ast.unparse(mark.func) == "guards":
                        for argument in mark.args:
                            chapter = ast.literal_eval(argument)
                            found.setdefault(chapter, []).append(f"{path.name}::{node.name}")
    return found
