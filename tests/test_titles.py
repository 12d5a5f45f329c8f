"""The title of a step says something by itself: it does not go on from the one before."""

import ast
import re

import pytest

from symhaptic.book.chapters import shipped

TITLED = {
    "define", "enclosed", "inside", "lemma", "limit", "minimal", "outside", "positive", "result",
    "show", "step",
}  # fmt: skip
LEANS = re.compile(r"(And|As before|The same|So does|So is|So are)\b")


def titles(path):
    """Titles that a chapter writes out."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if (
            isinstance(node, ast.Call)
            and isinstance(node.func, ast.Attribute)
            and node.func.attr in TITLED
            and node.args
            and isinstance(node.args[0], ast.Constant)
        ):
            yield node.args[0].value


@pytest.mark.parametrize("path", shipped(), ids=lambda path: path.stem)
def test_no_title_leans_on_the_step_before(path):
    assert [title for title in titles(path) if LEANS.match(str(title))] == []
