"""The leaves: what our deciders found, as Rocq checks it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp
from flint import acb, arb, ctx
from sympy import Expr, Symbol, floor

from symhaptic.notation import a, delta, e, gamma, n_0, n_1
from symhaptic.notation.proposition import And, Predicate, Relation, term
from symhaptic.proof.ball import sign
from symhaptic.proof.certificate import Positive
from symhaptic.proof.normal import is_zero
from symhaptic.proof.plants import AT_ONE, LATE, LOSS, TOGETHER
from symhaptic.proof.program import real
from symhaptic.proof.theorems.kernel import Theorem, absurd, applied, assume, conjoined, part
from symhaptic.proof.theorems.leaves import number as settled
from symhaptic.proof.theorems.roots import jury
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.identities import Image, polar, same, script
from symhaptic.rocq.logic import Written
from symhaptic.rocq.propositions import text, typed
from symhaptic.rocq.steps import Proof, Step, premises
from symhaptic.rocq.terms import Names, NotPrinted, complex_, real_text

__all__ = ["LEAVES", "SPELLED"]

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
    else:
        proof.say("opened; defined; numeric.")


@cache
def by_jury(theorem: Theorem) -> Theorem:
    """The same of the polynomial in real numbers, by Jury's criterion and signs of numbers."""
    claim: Any = theorem.conclusion
    inside = _inside(claim)
    [polynomial], [variable] = inside.of, inside.over
    poly = sp.Poly(polynomial, variable)
    if poly.degree() > _HIGHEST:
        raise NotPrinted(f"the determinants of a polynomial of degree {poly.degree()}")
    if polynomial.has(sp.I):
        polynomial = sp.Add(*(_real_part(c) * variable**n for (n,), c in poly.terms()))
    judged = jury(polynomial, variable)
    stable, signs = judged.conclusion.parts
    if inside is claim:
        return applied(judged, conjoined(*map(settled, signs.parts)))
    wrong: Any = next(s for s in signs.parts if sign(s.terms[1]) == -1)
    given = part(applied(judged, assume(stable)), wrong)
    return absurd(given, settled(Relation(wrong.right, "<", wrong.left)), stable)


_HIGHEST = 8
"""The highest degree of which determinants are written out."""


def _real_part(number: Expr) -> Expr:
    """A number that is real, without j."""
    turned = {
        e: sp.exp(size) * (sp.cos(angle) + sp.I * sp.sin(angle))
        for e in number.atoms(sp.exp)
        for size, angle in [polar(e)]
    }
    return sp.expand(number.xreplace(turned)).as_independent(sp.I, as_Add=True)[0]


@shows
def roots_inside(proof: Proof, theorem: Theorem) -> None:
    known = by_jury(theorem)
    claims = [theorem.conclusion, known.conclusion]
    (polynomial, real), [variable] = (_inside(c).of[0] for c in claims), _inside(claims[0]).over
    with proof.names.introduced(variable) as [v]:
        proof.names.as_complex.add(variable)
        texts = [f"(fun {v} : C => {complex_text(p, proof.names)})%C" for p in (polynomial, real)]
        lines = same(polynomial, real, proof.names)
    proof.say(
        f"assert (Same : {texts[0]} = {texts[1]}).",
        "{",
        f"apply functional_extensionality; intro {v}.",
        *lines,
        "}",
        f"rewrite Same; exact {proof.have(known)}.",
    )


LEAVES["root_outside"] = roots_inside


def _inside(claim: Any) -> Predicate:
    return claim if isinstance(claim, Predicate) else claim.of[0]


SPELLED = {"roots_inside": by_jury, "root_outside": by_jury}
"""Leaves that are printed as other steps to the same theorem, or to one that is nearer."""

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
    proof.say(f"apply ({c}by_sum_{name} _ _ {sums}).")
    lines = script(terms, difference, names)
    proof.say(f"- {lines[0]}", *(f"  {line}" for line in lines[1:]))
    zeros = [
        f"replace ({_way(p.equation, names, write)}){scope} with {nought} by {zeroed}"
        for p in zero
        if p.equation
    ]
    proof.say("- " + "; ".join([*dict.fromkeys(zeros), ring]) + ".")
    if claim.sign != "=":
        proof.say(f"- {c}apart." if claim.sign == "!=" else f"- {c}signed.")
    if c and claim.sign in ("<", "<="):
        proof.say("- Cimaginary.")


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
def gains(proof: Proof, theorem: Theorem) -> None:
    wall, motion = theorem.given
    reals = " ".join(f"({real_text(term(v), proof.names)})" for v in wall)
    pieces = "nil"
    for time, way in reversed(motion):
        pieces = f"(cons ({_rational(time)}, {_rational(way)}) {pieces})"
    proof.say(
        f"assert (G := rule_gains {reals} {_rational(wall[4])} {pieces}).",
        "repeat match type of G with ?P -> _ => "
        "let H := fresh in assert (H : P) by gained; specialize (G H); clear H end.",
        "finish G.",
    )


def _rational(value: Any) -> str:
    value = sp.Rational(value)
    return f"(QArith_base.Qmake ({value.p}) {value.q})"


@shows
def on_plants(proof: Proof, theorem: Theorem) -> None:
    """The pieces of our certificate: on each the plant's numbers between two, then one interval."""
    (certificate,) = theorem.given
    given = certificate.given.meanings if certificate.given else {}
    meanings = {s: term(m).xreplace(PLANT_NUMBERS) for s, m in given.items()}
    ends = {s: (term(low), term(high)) for s, (low, high) in certificate.box.items()}
    if not all(end.is_Rational for pair in ends.values() for end in pair):
        raise NotPrinted("a box whose ends are no rational numbers")
    names, claim = proof.names, _relation(theorem)
    with names.introduced(*meanings) as new:
        of = {s: f"Q{i}" for i, s in enumerate(meanings, 1)}
        proof.say(
            *(
                f"named {v} {of[s]} ({real_text(m, names)})."
                for v, (s, m) in zip(new, meanings.items(), strict=True)
            )
        )
        if meanings:
            proof.say(_written_as(term(certificate.expr), claim.right, names, of.values()))
    proof.say(*_pieces(proof, certificate, ends, meanings))


LEAVES["on_box"] = on_plants


def _written_as(new: Expr, old: Expr, names: Names, by: Iterable[str]) -> str:
    """A term is written as another, by what variables are called."""
    texts = [real_text(t, names) for t in (old, new)]
    shown = f"rewrite {', '.join(f'?{q}' for q in by)}; same_field"
    return f"replace ({texts[0]}) with ({texts[1]}) by ({shown})."


PLANT_NUMBERS = {LOSS: 1 - e, TOGETHER: n_1 + n_0, LATE: n_0, AT_ONE: 1 - a + e}
_DIGITS = 11
"""Of what a number of a plant is said to lie between."""
Sides = Mapping[Symbol, tuple[Expr, Expr]]


def _left_out(ends: Sides) -> Expr:
    """A bound of the plant's series beyond its eighth power, a power of ten."""
    g, dl = (max(map(abs, ends[s])) for s in (gamma, delta))
    sizes = (
        (dl**6 + 5 * g * dl**4 + 6 * g**2 * dl**2 + g**3) / 40320,
        (dl**7 + 6 * g * dl**5 + 10 * g**2 * dl**3 + 4 * g**3 * dl) / 181440,
    )
    return sp.Integer(10) ** floor(sp.log(max(*sizes, sp.Integer(10) ** -40), 10) + 1)


Tree = str | tuple[Symbol, "Tree", "Tree"]
"""How a piece is decided, or what it is cut across and its halves."""


def _tree(symbols: Sequence[Symbol], cuts: Iterator[str]) -> Tree:
    cut = next(cuts)
    if not cut.isdecimal():
        return cut
    lower = _tree(symbols, cuts)
    return symbols[int(cut)], lower, _tree(symbols, cuts)


def _across(tree: Tree) -> set[Symbol]:
    """What a piece is cut across."""
    return set() if isinstance(tree, str) else {tree[0]} | _across(tree[1]) | _across(tree[2])


def _pieces(
    proof: Proof, certificate: Positive, ends: Sides, meanings: Mapping[Symbol, Expr]
) -> Iterator[str]:
    """The pieces of our certificate; the plant's numbers before sides that they do not see."""
    given: Any = certificate.given
    seen = [s for s in ends if given and s in set(given.of)]

    def numbers(box: Sides) -> str:
        with ctx.workprec(certificate.bits):
            found = given({s: acb(real(x).union(real(y))) for s, (x, y) in box.items()})
        balls = {m: found[s].real for s, m in meanings.items()}
        bounds = {m: (-_rounded(-x.lower()), _rounded(x.upper())) for m, x in balls.items()}
        lemma = _numbers(proof, {s: box[s] for s in seen}, bounds)
        symbols = " ".join(proof.names[s] for s in lemma.free)
        return f"numbers ({lemma.name} {symbols})."

    def shown(tree: Tree, box: Sides, known: bool) -> Iterator[str]:
        if seen and not known and not _across(tree) & set(seen):
            yield numbers(box)
            known = True
        if isinstance(tree, str):
            yield from _centred(proof, certificate.expr, box) if tree == ":" else ()
            yield "interval."
            return
        low, high = box[tree[0]]
        middle = (low + high) / 2
        yield f"halved {proof.names[tree[0]]} ({middle})."
        yield from shown(tree[1], {**box, tree[0]: (low, middle)}, known)
        yield from shown(tree[2], {**box, tree[0]: (middle, high)}, known)

    return shown(_tree(list(ends), iter(certificate.cuts)), ends, False)


def _centred(proof: Proof, expr: Expr, box: Sides) -> Iterator[str]:
    """A polynomial by the way from the middle of a piece, of which its slopes are coefficients."""
    if not expr.is_polynomial(*box):
        raise NotPrinted("the slopes of what is no polynomial")
    middle = {s: (low + high) / 2 for s, (low, high) in box.items()}
    with proof.names.introduced(*(ways := {s: sp.Dummy(s.name) for s in box}).values()) as new:
        by = [f"W{i}" for i, _ in enumerate(box, 1)]
        for s, x, w in zip(box, new, by, strict=True):
            yield f"named {x} {w} ({real_text(s - middle[s], proof.names)})."
            wide = (box[s][1] - box[s][0]) / 2
            yield f"assert (- ({wide}) <= {x} <= {wide}) by (rewrite {w}; lra)."
        moved = sp.expand(expr.xreplace({s: middle[s] + x for s, x in ways.items()}))
        yield _written_as(moved, expr, proof.names, by)


def _numbers(proof: Proof, box: Sides, bounds: Mapping[Expr, tuple[Expr, Expr]]) -> Step:
    """A lemma of all plants of a box: between what each of their numbers lies."""
    device = Predicate("device", (), (gamma, delta, n_1, n_0, a, e))
    sides = [r for s, (x, y) in box.items() for r in (Relation(x, "<=", s), Relation(s, "<=", y))]
    known = [And((Relation(x, "<=", m), Relation(m, "<=", y))) for m, (x, y) in bounds.items()]
    free = (*box, n_1, n_0, a, e)
    names = Names()
    with names.bound(*free) as over:
        said = [text(claim, names) for claim in (device, *sides, And(tuple(known)))]
        statement = f"forall {typed(free, over)}, {' -> '.join(said)}"
        d, meant = names[delta], f"rule_on_plants {' '.join(names[s] for s in device.of)} V"
    if statement not in proof.shared:
        lines = [
            f"intros {' '.join(over)} V {' '.join(f'H{i}' for i, _ in enumerate(sides, 1))}.",
            f"sampled_by ({meant}) ({_left_out(box)}).",
            *[f"split; [within {d} |]."] * (len(known) - 1),
            f"within {d}.",
        ]
        name = f"numbers_{len(proof.shared) + 1}"
        proof.shared[statement] = Step(
            name, "on_plants", free, (device, *sides), And(tuple(known)), statement, lines=lines
        )
    return proof.shared[statement]


def _rounded(number: arb) -> Expr:
    """A decimal number that is not less."""
    mantissa, exponent = number.mid().man_exp()
    exact = sp.Integer(int(mantissa)) * sp.Integer(2) ** int(exponent)
    return sp.ceiling(exact * 10**_DIGITS) / sp.Integer(10) ** _DIGITS
