"""A theorem that a chapter forged is found where it arrives: derived again, and judged again."""

from __future__ import annotations

from pathlib import Path

from typer.testing import CliRunner

from symhaptic.cli.main import app

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
