"""Classical rules: those of analysis are proved here, the others are axioms with their source."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, product
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import Relation, proposition
from symhaptic.notation.terms import term
from symhaptic.proof.normal import is_zero
from symhaptic.proof.theorems.definedness import conditions
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.identities import plain, same
from symhaptic.rocq.logic import Written, evaluated
from symhaptic.rocq.propositions import needed
from symhaptic.rocq.steps import Proof
from symhaptic.rocq.terms import NotPrinted, complex_, real_text

CLASSICAL: dict[str, Written] = {}
"""How a step of each classical rule is proved."""

ELEMENTARY = {
    "square": "intros; apply pow2_ge_0.",
    "quotient": "intros x y [H G]; split; [lra | apply Rdiv_lt_0_compat; assumption].",
    "weak quotient": "intros x y [H G]; split; [lra | apply Rdiv_le_0_compat; assumption].",
    "order": "intros x y; destruct (Rlt_le_dec x y); [left | right]; assumption.",
    "strictly": "intros x y [H G]; lra.",
    "both ways": "intros x y [H G]; lra.",
    "sin": "intros x [H G]; apply sin_gt_0; assumption.",
    "cos": "intros x [H G]; apply cos_gt_0; lra.",
    "exp": "intros; apply exp_pos.",
    "cosh": "intro x; apply one_le_cosh.",
    "sqrt": "intros x H; split; [exact H | apply sqrt_pos].",
    "Abs": "intros; apply Rabs_pos.",
    "size": "intros x H; apply Rabs_pos_eq; exact H.",
    "opposite size": "intros x H; apply Rabs_left1; exact H.",
    "sin bounded": "intro x; generalize (pythagoras x) (pow2_ge_0 (cos x)); lra.",
    "cos bounded": "intro x; generalize (pythagoras x) (pow2_ge_0 (sin x)); lra.",
    "exp rises": "intros x y H; apply exp_increasing; exact H.",
    "sinh rises": "intros x y H; apply sinh_lt; exact H.",
    "atan rises": "intros x y H; apply atan_increasing; exact H.",
    "sin rises": "intros x y H; opened; apply sin_increasing_1; lra.",
    "cos falls": "intros x y H; opened; apply cos_decreasing_1; lra.",
    "not negative": "intros x H; apply whole_start; exact H.",
    "equality": "intros s z; destruct (Ceq_dec s z); [left | right]; assumption.",
    "full turns": "intros x p [n E]; subst p; split; "
    "[rewrite <- (sin_period x n) | rewrite <- (cos_period x n)]; f_equal; ring.",
    "polar": "intros x y X; apply right_of_axis; exact X.",
    "linear": "intros x [A B]; apply linear_inside; split; assumption.",
    "swings": "intros m b k w W; apply (iff_trans (swinging m b k w W)); swung_as.",
    "device": "exact device_exists.",
    "device at rest": "of_device_by device_at_rest.",
    "device's loss": "of_device_by device_loss.",
    "device pushed": "intros; opened; finish (device_pushed _ _ _ _ _ _ ltac:(eauto)).",
    "device forgets": "intros; opened; eapply device_forgets; eauto.",
    "undamped device": "intros; opened; finish (undamped_device _ _ _ _ _ ltac:(eassumption)).",
    "free mass": "intros; finish (free_mass _ _ _ _ ltac:(eassumption)).",
    "device turns": "intros; opened; "
    "finish (device_turns _ _ _ _ _ _ ltac:(split; [eassumption | lra])).",
    "late device": "intros; opened; apply late_device_exists; split; assumption.",
    "late device and device": "intros; opened; "
    "finish (late_device_and_device _ _ _ _ _ _ _ _ _ _ _ _ "
    "ltac:(eassumption) ltac:(eassumption)).",
    "undamped late device": "intros; "
    "finish (undamped_late_device _ _ _ _ _ _ _ ltac:(eassumption)).",
    "free late mass": "intros; finish (free_late_mass _ _ _ _ _ _ ltac:(eassumption)).",
    "loop of a device": "whole_loop.",
    "loop of a late device": "late_loop.",
    "loop in w": "loop_of_fraction.",
    "loop as the paper reads it": "loop_read.",
    "half a period on the principal sheet": "principal_half.",
    "held by a pole": "pole_held.",
    "passive wall": "wall_of_filter.",
    "passive late wall": "late_wall_of_filter.",
    "held steady state": "whole_steady.",
    "late held steady state": "late_steady.",
    "units": "other_units.",
    "later": "later_answers.",
    "amplified": "amplified_answers.",
    "rest": "intros x y [H G]; destruct (with_rest x y H G) as (p & P & Q & L); exists p; "
    "repeat split; [exact P | lra | lra].",
}
"""Axioms of our kernel that are theorems of Rocq's library."""


def shows(write: Written) -> Written:
    """A rule's proof, under the rule's name."""
    CLASSICAL[write.__name__] = write
    return write


def _refused(*terms: Expr) -> None:
    if complex_(*terms) or any(t.has(sp.Abs) for t in terms):
        raise NotPrinted("a slope or a limit of a complex term")


def _slope(proof: Proof, expr: Expr, variable: Symbol, theorem: Theorem) -> tuple[str, str, str]:
    """A function, its derivative, and how the derivative is shown."""
    claim: Any = theorem.conclusion
    _refused(expr, claim.right)
    with proof.names.bound(variable):
        shown = " ".join(same(sp.diff(expr, variable), claim.right, proof.names))
    shown = "derived." if shown == "same_field." else shown
    return proof.function(variable, expr), proof.function(variable, claim.right), shown


def _inside(
    proof: Proof,
    variable: Symbol,
    ends: Sequence[Expr],
    then: Sequence[Theorem],
    last: str,
    claim: str = "",
) -> None:
    """In the open interval: what the premises say there, and the tactics that use it.

    A claim that is given is shown there, beside the goal, under the name that it has.
    """
    proof.say(*[f"assert ({claim}).", "{"] * bool(claim))
    before = dict(proof.scope)
    with proof.names.introduced(variable) as [v]:
        proof.say(f"- intros {v} [Lo Hi].")
        low, high = (Relation(*p) for p in ((ends[0], "<", variable), (variable, "<", ends[1])))
        for said in (low, high):
            name = proof.new("A")
            proof.say(f"  assert ({name} : {proof.text(said)}) by (opened; defined; assumption).")
            proof.scope[said] = name
        for premise in then:
            proof.keep(premise)
        proof.say(f"  {last}")
    proof.scope = before
    proof.say(*["}"] * bool(claim))


@shows
def increases(proof: Proof, theorem: Theorem) -> None:
    """The derivative is positive on the interval, by Coquelicot's."""
    expr, variable, lower, upper, slope, *defined = theorem.given
    expr, lower, upper = term(expr), term(lower), term(upper)
    f, g, shown = _slope(proof, expr, variable, slope)
    ends = (lower, upper)
    proof.say(*["split; [solve [opened; first [assumption | nz]] |]."] * len(needed(*ends)))
    if needed(expr):
        low, high = (real_text(t, proof.names) for t in ends)
        with proof.names.bound(variable) as [v]:
            claim = f"forall {v} : R, {low} < {v} < {high} -> {_conditions(proof, expr)}"
        _inside(proof, variable, ends, defined, "opened; repeat split; nz.", claim=f"Q : {claim}")
        proof.say(
            "split; [intros y L U; generalize (Q y (conj L U)); clear; intros; opened; "
            "repeat split; assumption |].",
        )
    proof.say(f"apply (rises {f} {g}).")
    _inside(proof, variable, ends, defined, f"evar_last; [slope |]. {shown}")
    _inside(proof, variable, ends, [slope], "opened; assumption.")


def _conditions(proof: Proof, expr: Expr) -> str:
    found = sorted(proof.text(c) for c in needed(expr))
    return " /\\ ".join(found)


@shows
def grows(proof: Proof, theorem: Theorem) -> None:
    """The derivative is positive between, and the function is smooth up to the ends."""
    expr, variable, x, y, slope, *defined = theorem.given
    expr, ends = term(expr), (term(x), term(y))
    f, g, shown = _slope(proof, expr, variable, slope)
    low, high = map(proof.real, ends)
    proof.say(f"assert (Ends : {low} < {high}) by (opened; assumption).")
    claims = [c for c in conditions(expr) if variable in c.free]
    if claims:
        with proof.names.introduced(variable) as [v]:
            told = " /\\ ".join(sorted(map(proof.text, claims)))
        claim = f"forall {v} : R, {low} < {v} < {high} -> {told}"
        _inside(proof, variable, ends, defined, "opened; repeat split; nz.", claim=f"Q : {claim}")
    proof.say(
        f"assert (Goal : {f} {low} < {f} {high}).",
        "{",
        f"apply (grows {f} {g}); [exact Ends | | |].",
    )
    with proof.names.introduced(variable) as [v]:
        proof.say(f"- intros {v} [Lo Hi].")
    if claims:
        proof.say(
            "  destruct (Rle_lt_or_eq_dec _ _ Lo) as [Lo1 | Lo1];"
            " [destruct (Rle_lt_or_eq_dec _ _ Hi) as [Hi1 | Hi1] |].",
            f"  + generalize (Q {v} (conj Lo1 Hi1)); intros; opened; slope.",
            f"  + clear Q; subst {v}; slope.",
            f"  + clear Q; subst {v}; slope.",
        )
    else:
        proof.say("  slope.")
    _inside(proof, variable, ends, defined, f"evar_last; [slope |]. {shown}")
    _inside(proof, variable, ends, [slope], "opened; assumption.")
    proof.say("}", "cbv beta in Goal; finish Goal.")


@shows
def above_its_start(proof: Proof, theorem: Theorem) -> None:
    """What increases lies above its limit."""
    rise, start = theorem.premises
    claim: Any = rise.conclusion
    [variable], (expr, lower, upper) = claim.over, claim.of
    _refused(expr)
    proof.keep(rise)
    proof.keep(start)
    f = proof.function(variable, expr)
    proof.say(
        "opened.",
        f"assert (Goal : {real_text(start.conclusion.of[2], proof.names)} < "  # type: ignore[attr-defined]
        f"{f} {proof.names[variable]}) by (apply (above_its_start {f} "
        f"{proof.real(lower)} {proof.real(upper)}); assumption).",
        f"cbv beta in Goal; inside {proof.names[variable]}; defined; assumption.",
    )


@shows
def in_the_limit(proof: Proof, theorem: Theorem) -> None:
    """A weak inequality is kept in the limit."""
    premise, end = theorem.premises
    variable, lower, upper = theorem.given[1], term(theorem.given[2]), term(theorem.given[3])
    claim: Any = premise.conclusion
    limit: Any = end.conclusion
    _refused(claim.left, claim.right, limit.of[0])
    proof.keep(end)
    f = proof.function(variable, limit.of[0])
    at = "lower" if limit.of[1] == lower else "upper"
    ends = [*map(proof.real, (lower, upper))]
    proof.say(f"assert (Ends : {ends[0]} < {ends[1]}) by (opened; assumption).")
    weak = f"Q : forall v, {ends[0]} < v < {ends[1]} -> 0 <= {f} v"
    _inside(proof, variable, (lower, upper), [premise], "opened; cbv beta; weakly.", claim=weak)
    proof.say(
        "opened; defined.",
        f"apply (weak_at_the_{at}_end {f} {' '.join(ends)}); "
        "[exact Ends | intros; apply Q; split; assumption | assumption].",
    )


@shows
def crosses_zero(proof: Proof, theorem: Theorem) -> None:
    """Between limits of different sign lies a zero."""
    below, above, *defined = theorem.premises
    claim: Any = below.conclusion
    [variable], (expr, lower, start) = claim.over, claim.of
    upper, end = above.conclusion.of[1:]  # type: ignore[attr-defined]
    _refused(expr)
    proof.keep(below)
    proof.keep(above)
    f = proof.function(variable, expr)
    ends = [*map(proof.real, (lower, upper))]
    with proof.names.bound(variable) as [v]:
        told = _conditions(proof, expr) or "True"
        domain = f"W : forall {v} : R, {ends[0]} < {v} < {ends[1]} -> {told}"
    proof.say("opened.")
    _inside(proof, variable, (lower, upper), defined, "opened; repeat split; nz.", claim=domain)
    proof.say(
        f"destruct (crosses_zero {f} {' '.join(ends)} {proof.real(start)} {proof.real(end)}) "
        "as (v & Lo & Hi & Z); "
        "[assumption .. | | assumption | assumption |].",
        "- intros v Lo Hi; generalize (W v (conj Lo Hi)); intros; opened; slope.",
        "- generalize (W v (conj Lo Hi)); intros; opened; exists v; cbv beta in Z; "
        "repeat split; assumption.",
    )


@shows
def tends(proof: Proof, theorem: Theorem) -> None:
    """By continuity, or as the quotient of slopes where both parts vanish."""
    variable = theorem.given[1]
    expr, at, value = (term(theorem.given[i]) for i in (0, 2, 3))
    _refused(expr, at, value)
    names = proof.names
    a, limit = proof.real(at), proof.real(value)
    there = {variable: at}
    above, below = sp.fraction(sp.together(plain(expr)))

    chains = [_until(below, variable, at)]
    _sine_apart(proof, chains[0][-1].xreplace(there))

    def at_point(of: Expr) -> str:
        """Shows what a term is there."""
        turns = evaluated(of.atoms(sp.Function), there, names)
        return "; ".join(["cbv beta", *turns, "at_point"])

    proof.say("opened; defined.")
    if len(chains[0]) == 1:
        f, shown = proof.function(variable, expr), at_point(expr)
        proof.say(f"apply (tends_at {f} {a} {limit}); [slope | {shown}].")
        return
    order = len(chains[0]) - 1
    chains.insert(0, [sp.diff(above, variable, i) for i in range(order + 1)])
    if not all(is_zero(f.xreplace(there)) for f in chains[0][:-1]):
        raise NotPrinted("a limit that does not exist")
    lead = [chain[-1].xreplace(there) for chain in chains]
    ends = " ".join(proof.real(c / sp.factorial(order)) for c in lead)
    functions = " ".join(proof.function(variable, of) for of in (expr, above, below))
    proof.say(f"apply (tends_quotient {functions} {a} {ends} {limit} {order}).")
    for chain in chains:
        proof.say("-")
        made = [proof.function(variable, of) for of in chain]
        for i, (f, slope) in enumerate(pairwise(made)):
            size = chain[-1].xreplace(there) / sp.factorial(order - i - 1)
            proof.say(
                f"  apply (order_up {f} {slope} {a} {proof.real(size)} "
                f"{proof.real(size / (order - i))} {order - i - 1}); "
                "[intros; evar_last; [slope | first [derived | same]] "
                f"| {at_point(chain[i])} | simpl; same_field |]."
            )
        proof.say(f"  apply order_none; [slope | {at_point(chain[-1])}].")
    proof.say(
        "- nz.",
        f"- {' '.join(same(lead[0] / lead[1], value, names))}",
        "- intros x Q; cbv beta in *; unfold tan, cot, cosh, sinh, tanh in *; field; nz.",
    )


def _sine_apart(proof: Proof, divisor: Expr) -> None:
    """A sine is not zero where a series' coefficient is said not to be, 2 j sin w exp(j n w)."""
    names = proof.names
    for claim, name in list(proof.scope.items()):
        if not (isinstance(claim, Relation) and claim.sign == "!=" and complex_(claim.left)):
            continue
        for sine, quarter, n in product(divisor.atoms(sp.sin), range(4), range(-3, 4)):
            share = sine * 2 * sp.I**quarter * sp.exp(n * sp.I * sine.args[0])
            if is_zero(claim.left - share):
                sides = [complex_text(t, names) for t in (claim.left, share)]
                proof.say(
                    f"assert (Apart : {real_text(sine, names)} <> 0).",
                    "{",
                    f"intro Z; apply {name}.",
                    f"assert (F : ({sides[0]} = {sides[1]} :> C)%C).",
                    "{",
                    *same(claim.left, share, names),
                    "}",
                    "rewrite F, Z; ring.",
                    "}",
                )
                return


def _until(expr: Expr, variable: Symbol, at: Expr) -> list[Expr]:
    """An expression and its derivatives until one is not zero."""
    found = [expr]
    while is_zero(found[-1].xreplace({variable: at})):
        if len(found) > 8:
            raise NotPrinted("a limit of high order")
        found.append(sp.diff(found[-1], variable))
    return found


@shows
def no_other_limit(proof: Proof, theorem: Theorem) -> None:
    """A limit is unique."""
    for premise in theorem.premises:
        proof.keep(premise)
    proof.say("opened; intro Q; opened; no_other_limit.")


@shows
def induction(proof: Proof, theorem: Theorem) -> None:
    """Induction over the natural numbers that whole numbers are."""
    claim, number, start, step = theorem.given
    claim = proposition(claim)
    with proof.names.bound(number) as [n]:
        body = proof.text(claim)
    proof.say(f"pose proof (by_induction (fun {n} : R => {body})) as Q; cbv beta in Q.")
    proof.say(f"apply Q; [finish {proof.have(start)} | | assumption].")
    with proof.names.introduced(number) as [n]:
        proof.say(f"intros {n}.")
        proof.say(f"finish {proof.have(step)}.")
