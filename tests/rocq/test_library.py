"""Theorems of the library: each is what it says, and a wrong variant of it is not proved by it."""

import re
import shutil

import pytest

from symhaptic.book import foreign
from symhaptic.rocq import assumptions, compiled
from symhaptic.rocq.preludes import PRELUDES

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("coqc") is None, reason=compiled.INSTALL),
]

THEOREMS = {
    # by its name: what is changed in its statement, one place at a time
    "all_inside": [("f z * g z", "f z + g z"), ("stable f -> ", "")],
    "last_inside": [("-1 < c /\\ c < 1", "0 < c /\\ c < 1"), ("stable p -> ", "")],
    "opposite": [("s <> RtoC 0 -> ", ""), ("p (- z)", "p (1 - z)")],
    "zero_on_circle": [("Ci * t", "Ci + t"), ("~ stable p", "stable p")],
    "jury_3": [("1 + a + b + c", "1 + a + b - c"), ("- c^2", "- c"), ("0 < 1 - a", "0 <= 1 - a")],
    "jury_4": [("0 < 1 - d /\\", "0 < 1 + d /\\"), ("(a - c) * (c", "(c - a) * (c")],
    "hurwitz_cubic": [("0 < a -> ", ""), ("b * c - a * d", "b * c + a * d")],
    "device_unique": [("n_0 = m_0", "n_0 = m_1"), ("device gamma delta m_1", "device gamma 0 m_1")],
    "device_at_rest": [("n_0 + n_1", "n_0 - n_1"), ("+ 1", "+ 2")],
    "device_loss": [("exp (- delta)", "exp delta"), ("e = exp", "a = exp")],
    "device_turns": [("PI^2", "PI^3"), ("-2 *", "-1 *")],
    "device_pushed": [("0 <= gamma", "-1 <= gamma"), ("0 < n_0", "1 < n_0")],
    "device_forgets": [("0 < delta", "-1 < delta"), ("- a * z", "a + z")],
    "undamped_device": [("n_1 = n_0", "n_1 = - n_0"), ("2 * cos x", "2 * sin x")],
    "device_free": [("a = 2", "a = 1"), ("n_0 = 1 / 2", "n_0 = 1 / 3")],
    "late_device_and_device": [("m_0 = n_1", "m_0 = 2 * n_1"), ("u = 0 ->", "u = 1 ->")],
    "after_a_blow": [("< PI^2", "< PI^3"), ("p * n_1 + q * n_0 - f 1) /\\", "p * n_1 - f 1) /\\")],
    "loop_in_w": [("(w^p)", "(w^q)"), ("d * INR q = INR p -> ", ""), ("(0 < q)%nat -> ", "")],
    "loop_behind": [("(z^n)", "(z^(S n))"), ("d = INR n -> ", "")],
    "loop_of_late_device": [("z^(2 + l)", "z^(1 + l)"), ("INR l + u", "INR l - u")],
    "half_a_period": [("INR l + 1 / 2", "INR l + 1 / 3"), ("0 < x -> ", "")],
    "held_by_a_pole": [("1 <= x^2", "0 <= x^2"), ("~ stable", "stable")],
    "on_plants": [("e = exp (- d)", "e = exp d"), ("held g d n1", "held d g n1")],
}  # fmt: skip


def theorem(name):
    """A theorem by its full name, and what it says in the library."""
    for path in PRELUDES:
        text = path.read_text(encoding="utf-8")
        if found := re.search(rf"^Theorem {name} : (.*?)\.\nProof\.", text, re.S | re.M):
            return f"{path.stem}.{name}", " ".join(found[1].split())
    raise LookupError(name)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = compiled.prepared(tmp_path_factory.mktemp("rocq"))
    compiled.prelude_compiled(made)
    return made


def test_a_wrong_variant_is_not_proved_by_the_theorem(folder):
    text, wrong = "From Symhaptic Require Import Control Boxes Zeros.\n", set()
    for name, changes in THEOREMS.items():
        full, right = theorem(name)
        variants = {f"right_{name}": right}
        for i, (old, new) in enumerate(changes):
            assert old in right, (name, old)
            variants[f"wrong_{name}_{i}"] = right.replace(old, new)
        wrong |= variants.keys() - {f"right_{name}"}
        for said, claim in variants.items():
            way = f"first [exact {full} | intros; eapply {full}; eauto]"
            text += f"Lemma {said} : {claim}.\nProof.\n  {way}.\nQed.\n"
    assert set(compiled.failing(folder, text)) == wrong


def test_what_is_defined_rests_on_the_axioms_of_the_reals_alone(folder):
    names = [theorem(name)[0] for name in THEOREMS if name != "on_plants"]
    (folder / "defined.v").write_text(
        "From Symhaptic Require Import Control.\n"
        f"Definition all_of_it := ({', '.join(names)}).\n"
        "Print Assumptions all_of_it.\n"
    )
    done = compiled._compiled(folder, "defined")
    assert done.returncode == 0, done.stderr
    assert set(assumptions.axioms(done.stdout)) == {foreign.REALS}


def test_a_device_in_numbers_is_no_other(folder):
    """By hand: a free mass moves by 1/2 under the force 1, and keeps its speed."""
    claims = {
        "free": "device 0 0 n_1 n_0 a e -> n_1 + n_0 = 1 /\\ a = 2",
        "loses": "device 0 0 n_1 n_0 a e -> e < 1",
        "gains": "device 0 0 n_1 n_0 a e -> 2 < a",
        "never": "device 0 0 n_1 n_0 a e -> False",
    }
    way = "intro V; destruct (device_free _ _ _ _ V) as (A & E & N & M); repeat split; lra"
    text = "From Symhaptic Require Import Control.\n" + "".join(
        f"Lemma {name} : forall n_1 n_0 a e : R, {claim}.\nProof.\n  intros n_1 n_0 a e; {way}.\n"
        "Qed.\n"
        for name, claim in claims.items()
    )
    assert set(compiled.failing(folder, text)) == claims.keys() - {"free"}
