"""Rules on devices and loops: each is a theorem of ``Device.v`` or ``Loop.v``.

A loop's polynomial is made of the four numbers of its device, which are written as the model has
them.
"""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import sha256
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic import notation as n
from symhaptic.model import plant
from symhaptic.model.parts import Parts
from symhaptic.notation.proposition import Relation
from symhaptic.notation.terms import symbols_in, term
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.identities import polar, script
from symhaptic.rocq.logic import Written
from symhaptic.rocq.steps import Proof, Step
from symhaptic.rocq.terms import Names, NotPrinted, complex_, imaginary, real_text
from symhaptic.rocq.zeros import Lists, known_exponentials

LOOPS: dict[str, Written] = {}
"""How a step of each rule on devices and loops is proved."""


def shows(write: Written) -> Written:
    """A rule's proof, under the rule's name."""
    LOOPS[write.__name__] = write
    return write


_NUMBERS = (n.n_1, n.n_0, n.a, n.e)
_WHY = "The numbers of the device that this loop has."


def _alike(proof: Proof, parts: Sequence[Expr]) -> list[str]:
    """Tactics for an equation between terms that are made of these."""
    unlike = sp.Dummy()  # what is compared are no rational functions of the parts
    return script(parts, lambda of: sp.Add(unlike, *map(of, parts)), proof.names)


class _Device:
    """A device in a proof: names for its four numbers, and what each of them is in the model."""

    def __init__(self, proof: Proof, spring: Expr, damper: Expr) -> None:
        self.proof = proof
        parts = Parts(stiffness=spring != 0, damping=damper != 0)
        place = {n.gamma: spring, n.delta: damper}
        of = plant.sampled(plant.normalised(parts))
        numbers = dict(zip(_NUMBERS, (of.n1, of.n0, of.a, of.e), strict=True))
        self.values = {s: imaginary(term(v).xreplace(place)) for s, v in numbers.items()}
        self.names = {s: proof.new("D") for s in _NUMBERS}
        self.known = proof.new("V")
        given = " ".join(f"({real_text(v, proof.names)})" for v in (spring, damper))
        bound = " & ".join([*self.names.values(), self.known])
        proof.say(f"destruct (device_exists {given}) as ({bound}).")
        if symbols_in(spring) | symbols_in(damper):
            self._numbers(spring, damper)
            return
        equal = " & ".join(f"E{self.names[s]}" for s in _NUMBERS)
        lemma = self._lemma(given, spring, damper)
        proof.say(f"destruct ({lemma} _ _ _ _ {self.known}) as ({equal}).")

    def _lemma(self, given: str, spring: Expr, damper: Expr) -> str:
        """The name of a lemma that tells the numbers of a device, which many loops use."""
        write = Names()
        told = " /\\ ".join(
            f"(RtoC {s.name} = {complex_text(self.values[s], write)} :> C)%C" for s in _NUMBERS
        )
        bound = " ".join(s.name for s in _NUMBERS)
        statement = f"forall {bound} : R, device {given} {bound} -> {told}"
        name = f"device_{sha256(statement.encode()).hexdigest()[:8]}"
        step = self.proof.step
        own = Step(name, step.rule, (), (), step.conclusion, statement, why=_WHY)
        outer = self.proof, self.names, self.known
        self.proof = Proof(own, {}, write)
        self.names, self.known = {s: s.name for s in _NUMBERS}, "V"
        self.proof.say(f"intros {bound} V.")
        self._numbers(spring, damper)
        self.proof.say("repeat split; assumption.")
        own.lines = self.proof.lines
        self.proof, self.names, self.known = outer
        self.proof.helpers.append(own)
        return name

    def _numbers(self, spring: Expr, damper: Expr) -> None:
        if spring != 0:
            self._by_poles(spring, damper)
        elif damper != 0:
            self._with_damper(damper)
        else:
            self._free()

    def _told(self, symbol: Symbol, lines: Sequence[str]) -> None:
        """What a number is, as a complex number."""
        name, text = self.names[symbol], complex_text(self.values[symbol], self.proof.names)
        self.proof.say(f"assert (E{name} : (RtoC {name} = {text} :> C)%C).", "{", *lines, "}")

    def _free(self) -> None:
        equal = " & ".join(f"F{self.names[s]}" for s in (n.a, n.e, n.n_1, n.n_0))
        self.proof.say(f"destruct (device_free _ _ _ _ {self.known}) as ({equal}).")
        for symbol in _NUMBERS:
            self._told(symbol, [f"rewrite F{self.names[symbol]}; summed."])

    def _with_damper(self, damper: Expr) -> None:
        names, write = self.names, self.proof.names
        known_exponentials(self.proof, *self.values.values())
        equal = " & ".join(f"F{names[s]}" for s in (n.a, n.e, n.n_1, n.n_0))
        told = f"device_unsprung _ _ _ _ _ {self.known} ltac:(nz)"
        self.proof.say(f"destruct ({told}) as ({equal}); cbv zeta in *.")
        loss = real_text(sp.exp(-damper), write)
        self.proof.say(
            f"replace (exp (- ({real_text(damper, write)}))) with ({loss}) in F{names[n.e]} "
            "by (f_equal; field).",
        )
        order = f"F{names[n.n_0]}, ?F{names[n.n_1]}, ?F{names[n.a]}, ?F{names[n.e]}"
        for symbol in _NUMBERS:
            self._told(symbol, [f"rewrite ?{order}.", "summed."])

    def _by_poles(self, spring: Expr, damper: Expr) -> None:
        names, write = self.names, self.proof.names
        apart = imaginary(sp.sqrt(sp.expand(damper**2 - 4 * spring)))
        if symbols_in(apart) or not apart.has(sp.I):
            raise NotPrinted("a device whose poles are real, or may be")
        p, q = ((-damper + sign * apart) / 2 for sign in (1, -1))
        texts = [f"({complex_text(t, write)})%C" for t in (p, q, apart)]
        held, given = (f"RtoC ({real_text(t, write)})%R" for t in (damper, spring))
        sides = f"({texts[0]} + {texts[1]})%C", f"({texts[0]} * {texts[1]})%C"
        self.proof.say(
            f"assert (Sum : ({sides[0]} = - {held})%C).",
            "{",
            *_alike(self.proof, [p, q, damper]),
            "}",
            f"assert (Product : ({sides[1]} = {given})%C).",
            "{",
            *_alike(self.proof, [p, q, spring]),
            "}",
            f"assert (Apart : {texts[0]} <> {texts[1]}).",
            "{",
            f"intro Z; assert (Q : {texts[2]} = RtoC 0).",
            "{",
            f"transitivity ({texts[0]} - {texts[1]})%C; [| rewrite Z; ring].",
            *_alike(self.proof, [p, q, apart]),
            "}",
            "revert Q; Cnz.",
            "}",
        )
        equal = " & ".join(f"F{names[s]}" for s in (n.a, n.e, n.n_1, n.n_0))
        told = f"device_by_poles _ _ _ _ _ _ {texts[0]} {texts[1]} {self.known} Sum Product Apart"
        self.proof.say(
            f"destruct ({told}) as ({equal}).",
            f"specialize (F{names[n.n_1]} ltac:(nz)); cbv zeta in *.",
        )
        self.proof.say("clear Sum Product Apart.")
        for pole, text in zip((p, q), texts, strict=False):
            size, _ = polar(sp.exp(pole, evaluate=False))
            if not any(map(complex_, sp.exp(pole).atoms(sp.exp))):  # its angle is known
                there = f"({real_text(size, write)})"
                value = complex_text(sp.exp(pole), write)
                self.proof.say(
                    f"assert (There : (Cexp {text} = ({value} : C) :> C)%C) by turned_to {there}.",
                    "rewrite There in *; clear There.",
                )
        parts = [sp.exp(p), sp.exp(q), p, q]
        loss = real_text(sp.exp(-damper), write)
        for symbol in _NUMBERS:
            lines = [f"rewrite F{names[symbol]}{f', F{names[n.n_1]}' * (symbol == n.n_0)}."]
            if symbol == n.e:
                exponent = f"exp (- ({real_text(damper, write)}))"
                way = "f_equal; field" if damper != 0 else "rewrite Ropp_0, exp_0; reflexivity"
                lines += [f"replace ({exponent}) with ({loss}) by ({way}).", "summed."]
            else:
                lines += _alike(self.proof, [*parts, self.values[symbol]])
            self._told(symbol, lines)

    def rewritten(self) -> str:
        """A tactic that writes the four numbers as the model has them."""
        return f"rewrite {', '.join(f'?E{self.names[s]}' for s in _NUMBERS)}."


@shows
def loop_substituted(proof: Proof, theorem: Theorem) -> None:
    """The polynomial of the device's numbers is that of the model."""
    _loop(proof, theorem, int(theorem.given[2]), "loop_in_w")


@shows
def loop(proof: Proof, theorem: Theorem) -> None:
    """The same behind whole delays."""
    _loop(proof, theorem, 1, "loop_behind")


def _loop(proof: Proof, theorem: Theorem, share: int, by: str) -> None:
    claim: Any = theorem.conclusion
    stable, zeros = claim.of
    [variable], late, names = zeros.over, stable.of[4], proof.names
    lists = Lists(proof)
    power = lists.number(share * late)
    proof.say("opened; defined.")
    device = _Device(proof, *stable.of[2:4])
    given = " ".join(f"({real_text(v, names)})" for v in stable.of)
    args = f"_ _ _ _ {power} {share}" if by == "loop_in_w" else f"{power} _ _ _ _"
    counted = "ltac:(lia) " * (by == "loop_in_w") + "ltac:(counted_delay)"
    known_exponentials(proof, zeros.of[0])
    proof.say("peeled.")
    proof.say(f"apply (iff_trans ({by} {given} {args} {device.known} {counted})).")
    with names.introduced(variable) as [v]:
        proof.say(f"apply stable_alike; intro {v}; unfold characteristic.", device.rewritten())
        # a high power of which no more is known than that it is one
        if not late.is_number:
            proof.say("natural_powers; repeat rewrite Cpower_plus.")
        elif share * late > 3:
            high = share * late
            proof.say(f"change ({v} ^ {high + share})%C with ({v} ^ ({share} + {high}))%C.")
            proof.say(
                f"rewrite (Cpower_plus {v} {share} {high}).", f"generalize ({v} ^ {high})%C; intro."
            )
    proof.say("summed.")


@shows
def after_a_blow(proof: Proof, theorem: Theorem) -> None:
    """What moves a device is compared over the time of one period."""
    device, first, second, ago, test, kernel = theorem.given
    f, names = term(test), proof.names
    slopes = [sp.diff(f, ago, k) for k in range(3)]
    known = proof.keep(device)
    forces = " ".join(f"({real_text(term(t), names)})" for t in (first, second))
    functions = " ".join(proof.function(ago, s) for s in slopes)
    claim: Any = kernel.conclusion
    claim_of: Any = device.conclusion
    proof.say(
        "opened.",
        f"assert (B := after_a_blow _ _ _ _ _ _ {known} ltac:(lra) {forces} {functions}).",
        *["specialize (B ltac:(intro; cbv beta; evar_last; [slope | derived]))."] * 2,
        *["specialize (B ltac:(cbv beta; at_point))."] * 2,
        f"destruct B as [{'B _' if claim.sign == '<' else '_ B'}].",
    )
    scope = dict(proof.scope)
    with names.introduced(ago) as [u]:
        holds = f"0 {claim.sign} {real_text(claim.right, names)}"
        proof.say(
            f"assert (K : forall {u} : R, 0 < {u} < 1 -> {holds}).", "{", f"intros {u} [L U]."
        )
        undamped = claim_of.of[1] == 0
        held = f"replace (- 0 * {u}) with 0 by ring; rewrite exp_0; " if undamped else ""
        proof.scope[Relation(sp.S.Zero, "<", ago)] = "L"
        proof.scope[Relation(ago, "<", sp.S.One)] = "U"
        proof.say(f"pose proof {proof.have(kernel)} as Q; opened; assumption.", "}")
        proof.say(
            f"finish (B ltac:(intros {u} U; refine (eq_ind _ (fun x => 0 {claim.sign} x) (K {u} U) "
            f"_ _); {held}same_kernel)).",
        )
    proof.scope = scope


@shows
def pole_at(proof: Proof, theorem: Theorem) -> None:
    """The polynomial of the device's numbers vanishes there."""
    claim: Any = theorem.conclusion
    *loop, pole = claim.of
    share = term(theorem.given[2])
    exponent = term(theorem.given[3])
    names = proof.names
    lists = Lists(proof)
    power, number = lists.number(sp.expand(share * loop[4])), lists.number(share)
    proof.say("opened; defined.")
    device = _Device(proof, *loop[2:4])
    known_exponentials(proof, *device.values.values(), pole, symbols=True)
    given = f"(Cexp ({complex_text(exponent / share, names)}))%C"
    size, _ = polar(sp.exp(exponent, evaluate=False))
    exists = [*(device.names[s] for s in _NUMBERS), power, number, given]
    proof.say(
        f"exists {', '.join(exists)}.",
        f"split; [exact {device.known} |]; split; [apply INR_lt; simpl; counted_back |].",
        "split; [counted_delay |].",
        f"replace ({given} ^ {number})%C with ({complex_text(pole, names)} : C)%C.",
        f"2: {{ symmetry; rewrite Cexp_power; counted_turn ({real_text(size, names)}). }}",
        f"split; [reflexivity |]; generalize ({given} ^ {power})%C; intro.",
        f"unfold characteristic; {device.rewritten()}",
        "cbn [Cpower]; summed.",
    )
