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
    "toeplitz": [("0 <= static l /\\ ", ""), ("0 <= margin", "0 < margin"), ("< PI", "< 1")],
    "whole_wall": [("0 < T -> ", ""), ("/ z ^ m", "/ z ^ S m"), ("(z - 1)", "(z + 1)")],
    "late_wall": [("0 < b -> ", ""), ("/ (4 * T * b)", "/ (2 * T * b)"), ("0 <= u <= 1", "0 <= u")],
    "gains_energy": [("0 <= b -> ", ""), ("motion < 0", "motion <= 0"), ("~ passive", "passive")],
    "stored": [("Re (E (RtoC 0)) = 0 -> ", ""), ("0 <= Re (E", "-1 <= Re (E"), ("0 <= d ->", "")],
    "held_steady_state": [("0 < delta -> ", ""), ("z <> RtoC 1 ->", ""), ("delta * C", "1 * C")],
    "late_held_steady_state": [("0 < u < 1", "0 <= u"), ("Cmod z = 1 -> ", "")],
    "answer_later": [("z <> RtoC 0 /\\ ", ""), ("X / z^n", "X * z^n")],
    "answer_units": [("f <> 0 -> ", ""), ("(T / u)", "(T * u)")],
    "one_answer": [("P z Y T", "P z Y 1"), ("P z X T -> ", "")],
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
        f"Definition all_of_it := ({', '.join(names)}, @Answers.held_answer).\n"
        "Print Assumptions all_of_it.\n"
    )
    done = compiled._compiled(folder, "defined")
    assert done.returncode == 0, done.stderr
    assert assumptions.axioms(done.stdout) == set(foreign.LIBRARY) - {foreign.INTEGERS}


SPRING = """
  apply (whole_wall {K} 0 1 1 0 (fun z => (0 * (z - 1) / (1 * z) + {K}) / z^0)%C);
    [lra | intros; reflexivity |].
  apply (toeplitz _ _ ((0%nat, {K}) :: nil)); [as_taps | split; [cbn; lra |]].
  intros t T; assert (C : cos t < 1) by (apply cos_below_one; lra).
  rewrite at_angle_is by lra; cbn; lra.
"""


def test_walls_and_answers_in_numbers_are_no_others(folder):
    """By hand: beside b = 1 and T = 1 a spring of up to 2 b/T is passive, and what pulls is not."""
    answer = "answers (fun s => 1 / s^2)%C (RtoC 2) (RtoC {}) (RtoC 1)"
    claims = {
        "soft": ("passive_wall 2 0 1 1 0", SPRING.format(K=2)),
        "stiff": ("passive_wall 3 0 1 1 0", SPRING.format(K=3)),
        "never": ("forall K, ~ passive_wall K 0 1 1 0",
            "intros K P; specialize (P (fun _ => 0)); lra."),
        "always": ("forall K B, passive_wall K B 1 1 0", "intros K B v V e n E; unfold work; nra."),
        "undamped": ("~ passive_wall 0 0 (-1) 1 0",
            "intro P; set (H := (fun z => (0 * (z - 1) / (1 * z) + 0) / z^0)%C); "
            "apply (whole_wall 0 0 (-1) 1 0 H) in P; [| lra | reflexivity]; "
            "assert (F := passive_taps H (-1 / 1) ((0%nat, 0) :: nil) ltac:(unfold H; as_taps)); "
            "assert (Q := proj1 F P (fun _ => 1) 1%nat); "
            "unfold energy, force, place, impulse in Q; simpl in Q; lra."),
        "no_device": (answer.format("1") + " -> False", "intros (m & b & k & t & p & H); lra."),
    }  # fmt: skip
    text = "From Symhaptic Require Import Control.\n" + "".join(
        f"Lemma {name} : {claim}.\nProof.\n  {way}\nQed.\n" for name, (claim, way) in claims.items()
    )
    assert set(compiled.failing(folder, text)) == {"stiff", "never", "always", "no_device"}


def test_nothing_is_assumed_in_the_library():
    """No axiom, no parameter and no proof that is left out, so that no name stands for nothing.

    A module type says only what a module has to define that is given in its place.
    """
    for path in PRELUDES:
        text = re.sub(r"\(\*.*?\*\)", "", path.read_text(encoding="utf-8"), flags=re.S)
        text = re.sub(r"^Module Type .*?^End \w+\.$", "", text, flags=re.M | re.S)
        assert not re.findall(r"\b(?:Axiom|Parameter|Conjecture|Admitted|admit)s?\b", text), path


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
