"""Rules on energy and answers: theorems of ``Energy.v``, ``Stored.v`` and ``Answers.v``."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy import cos

from symhaptic.notation.terms import term
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.proof.theorems.roots import summands
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.identities import same
from symhaptic.rocq.logic import Written, evaluated
from symhaptic.rocq.steps import Proof
from symhaptic.rocq.terms import NotPrinted, complex_, real_text
from symhaptic.rocq.zeros import Lists, Powers, known_exponentials

ENERGY: dict[str, Written] = {}
"""How a step of each rule on energy is proved."""


def shows(write: Written) -> Written:
    """A rule's proof, under the rule's name."""
    ENERGY[write.__name__] = write
    return write


@shows
def toeplitz(proof: Proof, theorem: Theorem) -> None:
    """The coefficients of the filter are listed; static value and margin are those of the list."""
    response, variable, _, angle = theorem.given
    claim: Any = theorem.conclusion
    static, always = claim.of[1].of
    margin, names = always.body.of[1].right, proof.names
    lists = Lists(proof)
    taps = Powers(tuple((-e, c) for e, c in summands(term(response), variable)))
    whole = sum(c for _, c in taps.terms)
    proof.say(
        "lazymatch goal with |- context [passive ?H ?c] => assert (F : passive H c <-> "
        f"0 <= {real_text(static.right, names)} /\\ "
        f"forall t : R, 0 < t < PI -> 0 <= {proof.function(angle, margin)} t) end.",
        "{",
        f"apply (toeplitz_as _ _ {lists.swapped(taps)}); [as_taps | |].",
        f"- cbn [static fold_right snd]; transitivity {proof.real(whole)}; [same_field |].",
        *(f"  {line}" for line in same(whole, static.right, names)),
    )
    with names.introduced(angle) as [t]:
        proof.say(f"- intros {t} N; cbv beta; cbn [margin fold_right fst snd].")
        for exponent, _ in taps.terms:
            number = lists.number(exponent)
            for at, multiple in ((f"S {number}", 1 + exponent), (number, -exponent)):
                wanted = real_text(cos(multiple * angle), names)
                proof.say(f"  replace (cos (INR ({at}) * {t})) with ({wanted}) by a_cosine.")
        proof.say("  same_field.")
    proof.say("}", "as_passive F.")


@shows
def stored(proof: Proof, theorem: Theorem) -> None:
    """A store that is not negative, and nothing at rest."""
    speed, some = theorem.given[1], theorem.given[2]
    store, names = some.conclusion.right, proof.names
    proof.say("opened; apply stored; [assumption | assumption | |].")
    with names.introduced(speed) as [v]:
        there, real = complex_text(store, names), real_text(store, names)
        proof.say(
            f"- intro {v}; cbv beta; replace ({there})%C with (RtoC ({real})) by summed.",
            f"  simpl; pose proof {proof.have(some)} as Q; opened; finish Q.",
        )
    proof.say("- transitivity (Re (RtoC 0)); [f_equal; cbv beta; summed | reflexivity].")


@shows
def turns(proof: Proof, theorem: Theorem) -> None:
    """It is part of what an answer is."""
    proof.keep(theorem.premises[0])
    proof.say("opened; eapply answer_turns; eassumption.")


@shows
def one_answer(proof: Proof, theorem: Theorem) -> None:
    """The motion is unique, and so are the numbers of the device."""
    for premise in theorem.premises:
        proof.keep(premise)
    proof.say("answer_unique.")


@shows
def held_answer(proof: Proof, theorem: Theorem) -> None:
    """Phi and Gamma obey the equation, and are evaluated where the force changes and is sampled."""
    device, delay, _, at, answer, motion, time = theorem.given
    names, lists = proof.names, Lists(proof)
    mass, damping, stiffness = map(term, device)
    periods, rest = map(term, delay)
    if complex_(mass, damping, stiffness, rest, term(at), term(answer)):
        raise NotPrinted("an answer that is no real number")
    x_1, x_2, v_1, v_2, held, held_speed = map(term, motion)
    moved = [x_1, v_1, x_2, v_2, mass * held, mass * held_speed]
    functions = [proof.new("F") for _ in moved]
    texts = (proof.function(time, f) for f in moved)
    proof.say(*(f"pose ({f} := {text})." for f, text in zip(functions, texts, strict=True)))
    given = " ".join(map(proof.real, (mass, damping, stiffness)))
    share = proof.real(rest)
    proof.say(
        f"assert (M : motions ({proof.real(stiffness)} / {proof.real(mass)}) "
        f"({proof.real(damping)} / {proof.real(mass)}) {' '.join(functions)}).",
        "{",
        f"unfold {', '.join(functions)}.",
        "split; try (intro; split; (evar_last; [slope | cbv beta; derived])); at_point.",
        "}",
        "lazymatch goal with |- (answers ?P ?z ?X _) <-> _ =>",
        f"  assert (A := held_answer {given} {' '.join(functions)} ltac:(nz) M P z X "
        f"{lists.number(periods)} {share} ltac:(shown_transfer) ltac:(lra)) end.",
        "cbv zeta in A; unfold determinant in A.",
    )
    for place_, there in (("1", sp.S.One), (share, rest), (f"(1 - {share})", 1 - rest)):
        for f, name in zip(moved, functions, strict=True):
            value = f.xreplace({time: there})
            turns = evaluated(f.atoms(sp.Function), {time: there}, names)
            shown = "; ".join([f"unfold {name}", *turns, "at_point"])
            equal = f"{name} {place_} = {real_text(value, names)}"
            proof.say(f"assert (V : {equal}) by ({shown}).", "try rewrite V in A; clear V.")
    claim: Any = theorem.conclusion
    known_exponentials(proof, *(t for part in claim.of[1].of for t in part.terms))
    proof.say(
        "apply (iff_trans A); clear A M.",
        "apply conditions_alike; [reflexivity | Cpulled | Cpulled | Cpulled].",
    )


@shows
def gains(proof: Proof, theorem: Theorem) -> None:
    """The pieces of the motion are rational, and its energy is a number."""
    wall, motion = theorem.given
    reals = " ".join(f"({real_text(term(v), proof.names)})" for v in wall)
    pieces = "nil"
    for time, way in reversed(motion):
        pieces = f"(cons ({_rational(time)}, {_rational(way)}) {pieces})"
    proof.say(
        f"assert (G := gains_energy {reals} {_rational(wall[4])} {pieces}).",
        "repeat match type of G with ?P -> _ => "
        "let H := fresh in assert (H : P) by gained; specialize (G H); clear H end.",
        "finish G.",
    )


def _rational(value: Any) -> str:
    """A rational number as Rocq's library has it."""
    value = sp.Rational(value)
    return f"(QArith_base.Qmake ({value.p}) {value.q})"
