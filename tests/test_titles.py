"""The title of a step says something by itself: it does not go on from the one before."""

import ast
import re
from functools import cache

import pytest

from symhaptic.book.chapters import shipped
from symhaptic.book.parts import numbers

TITLED = {"define", "enclosed", "lemma", "limit", "minimal", "step"}
LEANS = re.compile(r"(And|As before|The same|So does|So is|So are)\b")


@cache
def calls(path):
    """What a chapter calls with a text first: the name, and the text."""
    return [
        (node.func.attr, node.args[0].value)
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and node.args
        and isinstance(node.args[0], ast.Constant)
    ]


def titles():
    """Titles that a chapter writes out, each with its file."""
    return [(path, t) for path in shipped() for name, t in calls(path) if name in TITLED]


def test_no_title_leans_on_the_step_before():
    assert [title for title in titles() if LEANS.match(str(title[1]))] == []


ENDS_IN = re.compile(
    r"^(It|They|That) .*|.*\b(is|are|has|have|to|by|at|with|reach)$|^\w+$|^The \w+$"
)


def test_the_title_of_a_step_says_what_holds():
    """It is no beginning of a sentence that the formula ends, and no bare word."""
    whole = lemmas()  # a theorem's title may end so: "if the stiffer one is"
    assert [t for t in titles() if ENDS_IN.match(str(t[1])) and t not in whole] == []


ALONE = re.compile(
    r"(So|It|There(?! is)|Beyond|Up to there)\b|.*\b(as a theorem|too|does not)$"
    r"|.*\b(such a|that) wall\b",
    re.IGNORECASE,
)


def lemmas():
    """Titles of theorems, which stand alone in the table of their part, each with its file."""
    return [(path, t) for path in shipped() for name, t in calls(path) if name == "lemma"]


def test_the_title_of_a_theorem_says_what_it_says_without_its_page():
    assert [title for title in lemmas() if ALONE.match(title[1])] == []


STALE = re.compile(
    r"chapters?\s+(before|s\d|on\b)|(next|last|earlier|previous|that)\s+chapters?\b", re.IGNORECASE
)


def test_a_chapter_is_referred_to_by_its_name_and_not_by_where_it_stands():
    for path in shipped():
        text = path.read_text(encoding="utf-8")
        words = re.sub(r'"\s*\n\s*r?"', "", text)  # literals that Python joins
        assert STALE.findall(words) == [], path
        assert set(re.findall(r"\\chapter\{(\w+)\}", words)) <= set(numbers()), path


def test_no_formula_in_a_text_has_a_control_character():
    r"""Without the prefix r, the first two characters of ``\theta`` are a tab."""
    for path in shipped():
        nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        texts = (n.value for n in nodes if isinstance(n, ast.Constant))
        found = [t for t in texts if isinstance(t, str) and re.search("[\a\b\t\v\f\r]", t)]
        assert found == [], path


@pytest.mark.parametrize(
    "title",
    ["As a theorem", "The damping is covered, too", "For a damped device it does not"],
)
def test_a_title_that_leans_is_found(title):
    assert ALONE.match(title)


@pytest.mark.parametrize("words", ["by the chapter before, the", "(chapter s5a)", "next chapter"])
def test_a_place_that_may_change_is_found(words):
    assert STALE.search(words)
