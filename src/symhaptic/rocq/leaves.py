"""The leaves: what our deciders found, as Rocq checks it."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy import Expr, floor

from symhaptic.notation import a, e, n_0, n_1
from symhaptic.notation.proposition import Predicate, Relation
from symhaptic.notation.terms import term
from symhaptic.proof.ball import sign
from symhaptic.proof.normal import is_zero
from symhaptic.proof.plants import AT_ONE, LATE, LOSS, TOGETHER
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.identities import Image, same, script
from symhaptic.rocq.logic import Written
from symhaptic.rocq.propositions import needed
from symhaptic.rocq.steps import Proof, premises
from symhaptic.rocq.terms import Names, complex_, real_text

__all__ = ["BOXED", "COUNTED", "LEAVES"]

LEAVES: dict[str, Written] = {}
"""How a leaf of each kind is checked."""


def shows(write: Written) -> Written:
    """A leaf's proof, under the rule's name."""
    LEAVES[write.__name__] = write
    return write


def _relation(theorem: Theorem) -> Relation:
    claim = theorem.conclusion
    assert isinstance(claim, Relation)
    return claim


@shows
def identity(proof: Proof, theorem: Theorem) -> None:
    claim = _relation(theorem)
    proof.say("opened; defined.", *same(claim.left, claim.right, proof.names))


@shows
def number(proof: Proof, theorem: Theorem) -> None:
    claim = _relation(theorem)
    if claim.sign == "=" or (claim.sign == "<=" and sign(claim.right - claim.left) == 0):
        proof.say("opened; defined.")
        if claim.sign == "<=":
            proof.say("apply Req_le.")
        proof.say(*same(claim.left, claim.right, proof.names))
    elif any(_nested(t) for t in claim.terms):
        proof.say("repeat split; numeric.")
    else:
        proof.say("opened; defined; numeric.")


def _nested(number: Expr) -> bool:
    """Whether it has a root of what is not rational: that this is not negative is said, too."""
    roots = (p for p in number.atoms(sp.Pow) if p.exp.is_Rational and not p.exp.is_Integer)
    return any(not p.base.is_Rational for p in roots)


@shows
def roots_inside(proof: Proof, theorem: Theorem) -> None:
    """By Schur's reduction in numbers, which a checker that is proved there does."""
    claim: Any = theorem.conclusion
    inside = claim if isinstance(claim, Predicate) else claim.of[0]
    degree = int(sp.degree(inside.of[0], *inside.over))
    beside = " repeat (split; [rooted |]);" * _nested(inside.of[0])
    proof.say(f"opened; defined;{beside} zeros {_BITS + 2 * degree}%positive.")


LEAVES["root_outside"] = roots_inside
COUNTED = frozenset({"roots_inside", "root_outside"})
"""Leaves that are checked by counting zeros."""
_BITS = 80
"""Of floats; each step of the reduction costs up to two more."""

Write = Callable[[Expr, Names], str]


@dataclass(frozen=True)
class _Product:
    """A product of theorems and rationals: its factors, as pairs of sides or numbers."""

    factors: tuple[tuple[Expr, Expr], ...]
    equation: tuple[Expr, Expr] | None

    def written(self, names: Names, write: Write) -> str:
        """As it stands in the sum."""
        return " * ".join(_way(f, names, write) for f in self.factors) or "1"

    def value(self, of: Image) -> Expr:
        """Made of the images of its sides."""
        return sp.Mul(*(of(right) - of(left) for left, right in self.factors))


def _way(factor: tuple[Expr, Expr], names: Names, write: Write) -> str:
    if write is complex_text and not complex_(*factor):
        return f"RtoC ({_way(factor, names, real_text)})"
    left, right = (write(t, names) for t in factor)
    return f"({right})" if factor[0] == 0 and factor[1].is_Rational else f"({right} - ({left}))"


def _product(given: Any) -> _Product:
    factors, equation = list[tuple[Expr, Expr]](), None
    for factor in given:
        if isinstance(factor, Theorem):
            claim: Any = factor.conclusion
            factors.append((claim.left, claim.right))
            equation = factors[-1] if claim.sign == "=" else equation
        else:
            factors.append((sp.S.Zero, term(factor)))
    return _Product(tuple(factors), equation)


@shows
def combined(proof: Proof, theorem: Theorem) -> None:
    claim, names = _relation(theorem), proof.names
    products = [_product(p) for p in theorem.given[1:]]
    terms = [claim.left, claim.right, *(t for p in products for f in p.factors for t in f)]
    for premise in theorem.premises:
        proof.keep(premise)
    of_complex = complex_(*terms)
    c, scope, nought = ("C", "%C", "(RtoC 0)") if of_complex else ("", "", "0")
    write, zeroed, ring = (
        (complex_text, "Czero", "Cring") if of_complex else (real_text, "lra", "ring")
    )
    zero = [p for p in products if p.equation]
    signed = [p for p in products if not p.equation]
    t, z = (" + ".join(p.written(names, write) for p in some) or "0" for some in (signed, zero))

    def plain_sum(of: Image) -> Expr:
        return of(claim.right) - of(claim.left) - sp.Add(*(p.value(of) for p in products))

    turned = claim.sign == "!=" and not is_zero(plain_sum(lambda x: x))

    def difference(of: Image) -> Expr:
        if not turned:
            return plain_sum(of)
        return of(claim.left) - of(claim.right) - sp.Add(*(p.value(of) for p in products))

    name = {"<": "lt", "<=": "le", "!=": "ne", "=": "eq"}[claim.sign] + ("'" if turned else "")
    sums = f"({z}){scope}" if claim.sign == "=" else f"({t}){scope} ({z}){scope}"
    if c and not complex_(claim.left, claim.right):
        sides = " ".join(f"(RtoC ({real_text(t, names)}))" for t in (claim.left, claim.right))
        of = {"<": "less_of", "<=": "less_eq_of", "!=": "apart_of", "=": "equal_of"}[claim.sign]
        proof.say(
            f"opened; defined; apply ({of} {sides}); [| reflexivity | reflexivity].", "Cpushed."
        )
    else:
        proof.say("opened; defined.")
    lines = script(terms, difference, names)
    # of angles that are sums over several symbols only the sum shows that the left side is real
    angles = (f for f in claim.left.atoms(sp.exp) if complex_(f))
    by_sum = claim.sign in ("<", "<=") and any(len(f.free_symbols) > 2 for f in angles)
    if by_sum:
        low, high = (f"({complex_text(side, names)})%C" for side in (claim.left, claim.right))
        proof.say(f"assert (Sum : ({high} - {low} = ({t}) + ({z}))%C).", "{", *lines, "}")
        proof.say(f"apply (Cby_sum_{name} _ _ {sums}).", "- exact Sum.")
    else:
        proof.say(f"apply ({c}by_sum_{name} _ _ {sums}).")
        proof.say(f"- {lines[0]}", *(f"  {line}" for line in lines[1:]))
    zeros = [
        f"replace ({_way(p.equation, names, write)}){scope} with {nought} by {zeroed}"
        for p in zero
        if p.equation
    ]
    proof.say("- " + "; ".join([*dict.fromkeys(zeros), ring]) + ".")
    known = _differences(signed, names) if c and claim.sign == "!=" else []
    above = c and claim.sign == "!=" and len(theorem.premises) == 1 and not known
    if above and _relation(theorem.premises[0]).sign == "<":
        proof.say(
            "- first [Capart | intro Z; match goal with P : Cless _ _ |- _ => "
            "destruct (Cpos_minus _ _ P) as [_ Q] end; rewrite Z in Q; simpl in Q; lra]."
        )
    elif known:
        proof.say("-", *(f"  {line}" for line in known), "  Capart.")
    elif claim.sign != "=":
        proof.say(f"- {c}apart." if claim.sign == "!=" else f"- {c}signed.")
    if by_sum:
        moved = f"({high} - (({t}) + ({z})))%C"
        proof.say(f"- replace {low} with {moved} by (rewrite <- Sum; ring); Cimaginary.")
    elif c and claim.sign in ("<", "<="):
        proof.say("- Cimaginary.")


def _differences(products: Sequence[_Product], names: Names) -> list[str]:
    """Tactics that say of two complex numbers known to differ that their difference is not zero."""
    pairs = dict.fromkeys(f for p in products for f in p.factors if complex_(*f) and f[0] != 0)
    sides = ([complex_text(t, names) for t in pair] for pair in pairs)
    return [
        f"try assert (({right} - ({left}))%C <> RtoC 0) by (let E := fresh in intro E; "
        f"match goal with N : ?l <> ?r |- _ => apply N; transitivity (r - (r - l))%C; "
        "[ring | rewrite E; ring] end)."
        for left, right in sides
    ]


@shows
def factor(proof: Proof, theorem: Theorem) -> None:
    (product,), (of, _, other) = theorem.premises, theorem.given
    of, other, claim = term(of), term(other), product.conclusion
    assert isinstance(claim, Relation)
    low, high, names = claim.left, claim.right, proof.names
    c = complex_(of, other, low, high)
    proof.keep(product)
    write = complex_text if c else real_text
    sides = [write(t, names) for t in (high, low, of, other)]
    said = f"{sides[0]} - ({sides[1]}) = ({sides[2]}) * ({sides[3]})"
    product_ = f"(({sides[2]}) * ({sides[3]})){'%C' if c else ''}"
    found = script([low, high, of, other], lambda f: f(high) - f(low) - f(of) * f(other), names)
    proof.say(
        "opened; defined.",
        f"assert (Fact : ({said} :> C)%C)." if c else f"assert (Fact : {said}).",
        "{",
        *found,
        "}",
        "intro Z.",
    )
    if c and not complex_(of):
        proof.say(f"apply (Cof_real _ _ (({sides[2]})%C)) in Z; [| Cpushed; Cring].")
    nought = "RtoC 0" if c else "0"
    proof.say(
        f"assert (Nil : {product_} = {nought}) by (rewrite Z; ring).",
        "pose proof (eq_trans Fact Nil) as Zero.",
    )
    if c and not complex_(low, high):
        pair = [real_text(t, names) for t in (high, low)]
        proof.say(f"apply (Creal_zero _ (({pair[0]}) - ({pair[1]}))) in Zero; [| Cpushed; Cring].")
        proof.say("refuted.")
    else:
        proof.say(f"{'C' if c else ''}refuted.")


@shows
def mirrored(proof: Proof, theorem: Theorem) -> None:
    proof.keep(theorem.premises[0])
    proof.say("opened; defined; Cmirrored.")


@shows
def is_whole(proof: Proof, theorem: Theorem) -> None:
    for premise in premises(theorem):
        proof.keep(premise)
    proof.say("opened; defined; wholes.")


@shows
def broken(proof: Proof, theorem: Theorem) -> None:
    value = theorem.conclusion.parts[0].terms[0]
    proof.say(f"broken ({floor(value)})%Z.")


@shows
def on_plants(proof: Proof, theorem: Theorem) -> None:
    """By the pieces of our certificate, which a checker that is proved there evaluates."""
    (certificate,) = theorem.given
    given, used = certificate.given, certificate.expr.free_symbols
    named = {s: m for s, m in given.meanings.items() if s in used} if given else {}
    names, claim = proof.names, _relation(theorem)
    meanings = {s: term(m).xreplace(PLANT_NUMBERS) for s, m in named.items()}
    meant = {s: f"({real_text(m, names)})" for s, m in meanings.items() if s != m}
    sides = [tuple(real_text(term(x), names) for x in pair) for pair in certificate.box.values()]
    old = real_text(claim.right, names)
    names.spelled |= meant
    new = real_text(term(certificate.expr), names)
    proof.say(*["defined."] * bool(needed(*claim.terms)))
    if new != old:
        proof.say(f"apply (positive_as _ ({new})); [same_field |].")
    cuts = " ".join(textwrap.wrap(certificate.cuts, 60))
    over = _list([names[s] for s in certificate.box], "R")
    ends = _list([f"({x}, {y})" for x, y in sides], "(R * R)")
    way = f"of_device {_list([*meant.values()], 'R')}" if named else "in_pieces"
    proof.say(f'{way} {over} {ends} "{cuts}".')


LEAVES["on_box"] = on_plants
BOXED = frozenset({"on_box", "on_plants"})
"""Leaves that are checked by the pieces of a box."""
PLANT_NUMBERS = {LOSS: 1 - e, TOGETHER: n_1 + n_0, LATE: n_0, AT_ONE: 1 - a + e}


def _list(items: Sequence[str], of: str) -> str:
    return f"({' :: '.join([*items, f'@nil {of}'])})"
