"""Words that readers do not know: each has a term of control engineering or of computing."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]

WORDS = {
    r"\bperiods? late\b|\bcomes late\b": "delayed by, with a delay of",
    r"\blate (force|device|wall|loop)s?\b": "a delayed force, with a fractional delay",
    r"\bwhole delays?\b": "integer delay",
    r"\b(half|whole) (turns?|swings?)\b": "omega_d T a multiple of pi",
    r"\bbehind (a|one|any|every|whole|the next) (integer |fractional )?delays?\b": "with a delay",
    r"\bin (a|every|no) hand\b|\bungrabbed\b|\bnobody holds\b": "with an arm, without an arm",
    r"\bstiffest (stable|passive) walls?\b": "wall of maximum stiffness",
    r"\bwalls? (bears?|wants?)\b": "delay margin; required damping",
    r"\bwhat (a|the) walls? needs?\b": "required damping",
    r"\b(give|gives|giving) (no )?energy away\b|\bburn(s|t)?\b": "deliver energy, dissipate",
    r"\bas printed\b|\bprinted (form|formula)s?\b": "as published",
    r"\bforeign judge\b|\bsecond judge\b": "independent check in Rocq",
    r"\b(has|have) to be (believed|trusted)\b": "trusted base",
    r"\bturned down by (one|a) line\b|\bsays nothing by itself\b": "is refused",
    r"\broom to\b|\bwith room to spare\b": "slack, with a positive margin",
    r"\b(at )?all the more\b|\bso it is, too\b": "say what holds",
}
"""What is found, and what to say instead."""

GUIDES = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "docs/*.md")
PROGRAMS = (
    *("docs/gallery/*.py", "derivations/s*.py"),
    *(
        f"src/symhaptic/{room}/*.py"
        for room in ("check", "cli", "export", "rules", "scene", "loops", "sweeps")
    ),
    *("src/symhaptic/book/parts.py", "src/symhaptic/book/consequences.py"),
    *("src/symhaptic/book/report/*.py", "src/symhaptic/notation/predicates.py"),
)


def prose():
    """What people read, each with its file: text outside of code, and strings of programs."""
    for pattern in GUIDES:
        for path in sorted(ROOT.glob(pattern)):
            text = path.read_text(encoding="utf-8")
            yield path, re.sub(r"```.*?```|`[^`]*`", "", text, flags=re.DOTALL)
    for pattern in PROGRAMS:
        for path in sorted(ROOT.glob(pattern)):
            nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
            parts = (n.value for n in nodes if isinstance(n, ast.Constant))
            text = "\n".join(part for part in parts if isinstance(part, str))
            yield path, text


@pytest.mark.skipif(not (ROOT / "derivations").is_dir(), reason="no repository around the tests")
@pytest.mark.parametrize("word", WORDS, ids=list(WORDS.values()))
def test_people_read_the_words_of_their_field(word):
    found = {
        f"{path.relative_to(ROOT)}: {re.sub(chr(10), ' ', hit[0])}"
        for path, text in prose()
        for hit in re.finditer(word, text)
    }
    assert sorted(found) == [], f"say: {WORDS[word]}"


@pytest.mark.parametrize(
    "text", ["half a period late", "behind a fractional delay", "what a wall needs", "it burns"]
)
def test_a_word_is_found(text):
    assert any(re.search(word, text) for word in WORDS)
