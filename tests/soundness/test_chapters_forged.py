"""A theorem that a chapter forged is found where it arrives: derived again, and judged again."""

from __future__ import annotations

import pickle
import subprocess
import sys
from pathlib import Path

from sympy import Symbol
from typer.testing import CliRunner

from symhaptic.cli.main import app
from symhaptic.notation.proposition import Exists, proposition

HEAD = '"""A title\n\nAn introduction.\n"""\n'


def chapter(folder: Path, name: str, body: str) -> Path:
    path = folder / f"{name}.py"
    path.write_text(HEAD + body, encoding="utf-8")
    return path


FORGED = """
from sympy import symbols
import symhaptic.proof.theorems.kernel as kernel
from symhaptic.notation.proposition import ForAll, proposition
def derive(page):
    x, y = symbols("x y")
    claim = ForAll((x, y), proposition(x > y))
    page.state("forged", "of two numbers each is the larger one", claim=claim)
    forged = object.__new__(kernel.Theorem)
    object.__setattr__(forged, "hypotheses", frozenset())
    object.__setattr__(forged, "conclusion", claim)
    object.__setattr__(forged, "_rule", "assume")
    object.__setattr__(forged, "_given", ((claim,), ()))
    page.settle("forged", forged)
"""


def test_a_forged_theorem_is_found_where_it_arrives(tmp_path: Path) -> None:
    path = chapter(tmp_path, "forged", FORGED)
    out = tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code == 1
    assert "DIFFERS  forged: open:" in out.read_text()


ANOTHER_KEY = """
from sympy import Integer, symbols
from symhaptic.notation.proposition import ForAll, Relation
from symhaptic.proof.theorems.kernel import general, part
from symhaptic.proof.theorems.leaves import number
def derive(page):
    x, y = symbols("x y")
    true = number(Relation(Integer(0), "<", Integer(1)))
    larger = Relation(y, "<", x)
    larger.__dict__["key"] = true.conclusion.key
    larger.__dict__["free"] = frozenset()
    claim = ForAll((x, y), Relation(y, "<", x))
    page.state("forged", "of two numbers each is the larger one", claim=claim)
    page.settle("forged", general(part(true, larger), x, y))
"""


def test_what_a_proposition_is_equal_to_is_not_told_by_a_chapter(tmp_path: Path) -> None:
    path = chapter(tmp_path, "forged", ANOTHER_KEY)
    out = tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code != 0
    assert "proved" not in (out.read_text() if out.exists() else "")


ELSEWHERE = """
import pickle, sys
from sympy import symbols
from symhaptic.notation import x
from symhaptic.notation.proposition import Exists, proposition
from symhaptic.proof.theorems.kernel import assume, general
y = symbols("y")
claim = Exists((y,), proposition(x < y))
hash(claim)
pickle.dump(assume(claim), sys.stdout.buffer)
"""


def test_a_theorem_of_another_process_says_the_same_here() -> None:
    """Where processes are not forked, symbols that stand for a place differ between them."""
    x, y = Symbol("x"), Symbol("y")
    claim = Exists((y,), proposition(x < y))
    sent = subprocess.run([sys.executable, "-c", ELSEWHERE], capture_output=True, check=True)
    arrived = pickle.loads(sent.stdout)
    assert arrived.conclusion == claim
    assert arrived.hypotheses == {claim}
