"""Rules on energy and on answers: each is a theorem of ``Energy.v``, ``Stored.v`` or ``Answers.v``."""

from __future__ import annotations

from typing import Any

from sympy import cos

from symhaptic.notation.terms import term
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.proof.theorems.roots import summands
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.identities import same
from symhaptic.rocq.logic import Written
from symhaptic.rocq.steps import Proof
from symhaptic.rocq.terms import real_text
from symhaptic.rocq.zeros import Lists, Powers

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
