"""Falsehood is tried from what Rocq accepts of a source of a user's own."""

import shutil

import pytest

from symhaptic.book.chapters import run
from symhaptic.rocq import compiled
from symhaptic.rocq.shared import FOLDER

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("coqc") is None, reason=compiled.INSTALL),
]

SOURCE = '''"""A source whose device has the poles -1 +- j sqrt(sqrt(2) - 1)."""

from sympy import S, sqrt

from symhaptic.notation import z
from symhaptic.notation.proposition import Not, Predicate
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.statement import Source, Statement
from symhaptic.proof.theorems.definitions import loop_substituted

SOURCE = Source("odd", "On odd walls", "A. Author", "2026")
STATEMENTS = (
    Statement("odd:loop", "(1)", "the characteristic polynomial of a wall that pulls"),
    Statement("odd:left", "(2)", "this wall is not stable"),
)
WALL = (S(-100), S.Zero, sqrt(2), S(2), S.Zero)


@claims("odd:loop")
def _loop(printed):
    return loop_substituted(WALL, z, 1).conclusion


@claims("odd:left")
def _left(printed):
    return Not((Predicate("stable_substituted", (), WALL),))
'''

CHAPTER = '''"""Is a wall that pulls stable?"""

from sympy import S, sqrt

from symhaptic.book.lemmas.boundary import at_rest
from symhaptic.book.lemmas.passive_is_stable import NUMBERS
from symhaptic.notation import delta, gamma, z
from symhaptic.notation.proposition import Relation, whole
from symhaptic.proof.theorems.definitions import loop_substituted
from symhaptic.proof.theorems.familiar import device_exists, loop_of_device
from symhaptic.proof.theorems.kernel import choose, conjunct, inst
from symhaptic.proof.theorems.leaves import combined
from symhaptic.proof.theorems.tactics import closed, denied_by, fact, zero_beyond

WALL = (S(-100), S.Zero, sqrt(2), S(2), S.Zero)
AT = {gamma: sqrt(2), delta: S(2)}


def derive(page):
    page.settle("odd:loop", closed(loop_substituted(WALL, z, 1), fact(whole(S.Zero))))
    static, pushed = (inst(theorem, AT) for theorem in at_rest())
    readings = loop_of_device(NUMBERS, WALL)
    loop = conjunct(readings, readings.conclusion.parts[1])
    zeros = loop.conclusion.parts[1].terms[0]
    away = fact(Relation(S.Zero, "<=", 100 - sqrt(2)))
    value = combined(Relation(zeros.subs(z, 1), "<=", S.Zero), [pushed, away], [static, 1])
    known = whole(S.Zero), Relation(S.Zero, "<=", sqrt(2)), Relation(S.Zero, "<", S(2))
    never = closed(denied_by(loop, zero_beyond(zeros, z, value)), *map(fact, known))
    page.settle("odd:left", choose(device_exists(sqrt(2), S(2), NUMBERS), never))
'''

JACKPOT = """From Symhaptic Require Import Control Boxes Zeros.
From Symhaptic.{folder} Require Import {chapter}.
Lemma jackpot : False.
Proof.
  apply statement_odd_left, statement_odd_loop.
  (* were the root of 1 - sqrt(2) nothing, nothing would be left of the wall *)
  assert (N : -4 * sqrt 2 + 4 <= 0).
  {{ assert (1 <= sqrt 2) by (rewrite <- sqrt_1; apply sqrt_le_1_alt; lra); lra. }}
  rewrite (sqrt_neg_0 _ N).
  replace (-1 - 0 / 2) with (-1) by lra; replace (-1 + 0 / 2) with (-1) by lra.
  assert (D : forall w : C, (w / RtoC 0)%C = RtoC 0).
  {{ intro w; apply injective_projections; simpl; unfold Rdiv;
      rewrite ?Rmult_0_l, ?Rmult_0_r, ?Rplus_0_r, ?Rinv_0; ring. }}
  match goal with |- stable ?p =>
    replace p with (fun z : C => z * (z^2 - z * (2 * RtoC (exp (-1))) + RtoC (exp (-2))))%C end.
  - zeros 100%positive.
  - apply functional_extensionality; intro z; rewrite !D; unfold Cdiv; simpl; ring.
Qed.
"""


def test_the_root_of_a_negative_number_is_no_real_root(tmp_path):
    """Printed as Rocq's sqrt, which is 0 there, two statements that are whole gave False."""
    (tmp_path / "source.py").write_text(SOURCE)
    (tmp_path / "odd.py").write_text(CHAPTER)
    folder = compiled.prepared(tmp_path / "rocq")
    compiled.prelude_compiled(folder)
    found = compiled.asked(run(tmp_path / "odd.py"), folder)
    assert set(found.statements) == {"odd:loop", "odd:left"}
    [chapter] = [path.stem for path in (folder / FOLDER).glob("odd_*.vo")]
    (folder / "Jackpot.v").write_text(JACKPOT.format(folder=FOLDER, chapter=chapter))
    done = compiled._compiled(folder, "Jackpot")
    assert done.returncode, "False is proved"
    assert "sqrt" in done.stderr
