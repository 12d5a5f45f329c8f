"""The rules of logic: what each is in Rocq's."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

import sympy as sp
from sympy import Expr, Pow, S, Symbol, exp, sqrt

from symhaptic.book.rests import said
from symhaptic.notation.proposition import (
    And,
    Exists,
    ForAll,
    Iff,
    Implies,
    Or,
    Proposition,
    Terms,
    proposition,
)
from symhaptic.notation.terms import is_complex, term
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.steps import Proof, Step, premises
from symhaptic.rocq.terms import Names, NotPrinted, complex_, real_text

Written = Callable[[Proof, Theorem], None]
LOGIC: dict[str, Written] = {}
"""How a step of each rule is proved."""


def shows(write: Written) -> Written:
    """A rule's proof, under the rule's name."""
    LOGIC[write.__name__] = write
    return write


def _assumed(proof: Proof, claim: Proposition) -> None:
    """A hypothesis that is at the head of the goal."""
    name = proof.new("G")
    proof.say(f"intros {name}.")
    proof.know(claim, name)


def _given(parts: tuple[Any, ...]) -> Proposition:
    found = tuple(proposition(p) for p in parts)
    return found[0] if len(found) == 1 else And(found)


@shows
def add_assum(proof: Proof, theorem: Theorem) -> None:
    """Hypotheses that are not used are left out."""
    proof.say(f"finish {proof.have(theorem.premises[0])}.")


@shows
def disch(proof: Proof, theorem: Theorem) -> None:
    """The hypothesis is brought in, and the premise has it."""
    _assumed(proof, _given(theorem.given[1:]))
    proof.say(f"finish {proof.have(theorem.premises[0])}.")


@shows
def prove_hyp(proof: Proof, theorem: Theorem) -> None:
    """What lemmas conclude is known before the theorem is used."""
    first, *lemmas = premises(theorem)
    for lemma in lemmas:
        proof.keep(lemma)
    proof.say(f"finish {proof.have(first)}.")


@shows
def mp(proof: Proof, theorem: Theorem) -> None:
    """An implication is a function; an equivalence a pair of them."""
    implication, given = theorem.premises
    found, known = proof.keep(implication), proof.keep(given)
    proof.know(given.conclusion, known)
    claim = implication.conclusion
    if isinstance(claim, Implies):
        given_: Proposition = claim.of[0]
        proof.say(f"finish ({found} {proof.find(given_)}).")
        return
    assert isinstance(claim, Iff)
    left, right = claim.parts
    for one, other, side in ((left, right, "proj1"), (right, left, "proj2")):
        if other == theorem.conclusion and proof.knows(one):
            proof.say(f"finish ({side} {found} {proof.find(one)}).")
            return
    raise NotPrinted("an equivalence that is applied to neither side")


@shows
def conj(proof: Proof, theorem: Theorem) -> None:
    """A proof of a conjunction is made of those of its parts."""
    proof.say(f"finish {proof.joined([proof.have(p) for p in theorem.premises])}.")


@shows
def conjunct(proof: Proof, theorem: Theorem) -> None:
    """A part of a conjunction is one of its components."""
    proof.keep(theorem.premises[0])
    proof.say(f"finish {proof.find(theorem.conclusion)}.")


@shows
def disj(proof: Proof, theorem: Theorem) -> None:
    """A disjunction is proved on one of its sides."""
    wanted, known = theorem.conclusion, theorem.premises[0]
    assert isinstance(wanted, Or)
    place = wanted.of.index(known.conclusion)
    last = place == len(wanted.of) - 1
    proof.say(
        " ".join(["right;"] * place + ([] if last else ["left;"]))
        + " " * (place > 0 or not last)
        + f"finish {proof.have(known)}."
    )


@shows
def disj_cases(proof: Proof, theorem: Theorem) -> None:
    """A disjunction is taken apart, and each case has its own proof."""
    cover, *cases = theorem.premises
    claim = cover.conclusion
    assert isinstance(claim, Or)
    names = [proof.new("D") for _ in claim.of]
    pattern = names[-1]
    for name in reversed(names[:-1]):
        pattern = f"[{name} | {pattern}]"
    taken = "destruct" if len(names) > 1 else "pose proof"
    proof.say(f"{taken} {proof.have(cover)} as {pattern}.")
    before = dict(proof.scope)
    for name, disjunct, case in zip(names, claim.of, cases, strict=True):
        proof.scope = dict(before)
        proof.scope.pop(disjunct, None)
        proof.know(disjunct, name)
        proof.say(f"- finish {proof.have(case)}.")


@shows
def not_intro(proof: Proof, theorem: Theorem) -> None:
    """What contradicts itself proves falsehood."""
    one, other = theorem.premises
    if theorem.given[2:]:
        _assumed(proof, _given(theorem.given[2:]))
    proof.say(f"contradict_by {proof.have(one)} {proof.have(other)}.")


@shows
def contr(proof: Proof, theorem: Theorem) -> None:
    """Falsehood has no case."""
    proof.say(f"destruct {proof.have(theorem.premises[0])}.")


@shows
def imp_antisym(proof: Proof, theorem: Theorem) -> None:
    """Both directions."""
    there, back = theorem.premises
    proof.say("split.", f"- finish {proof.have(there)}.", f"- finish {proof.have(back)}.")


@shows
def gen(proof: Proof, theorem: Theorem) -> None:
    """A symbol is brought in that nothing is known of."""
    claim = theorem.conclusion
    assert isinstance(claim, ForAll)
    with proof.names.introduced(*claim.over) as names:
        proof.say(f"intros {' '.join(names)}.", f"finish {proof.have(theorem.premises[0])}.")


def _values(proof: Proof, over: Any, values: Any) -> list[str]:
    return [_value(proof, s, term(values[s])) for s in over]


def _value(proof: Proof, symbol: Symbol, value: Expr) -> str:
    if is_complex(symbol):
        return f"({complex_text(value, proof.names)})%C"
    if complex_(value):
        text, known = f"({complex_text(value, proof.names)})%C", proof.new("E")
        proof.say(f"assert ({known} : {text} = RtoC (Re {text})) by (apply Creal; Cunmoved).")
        return f"(Re {text})"
    return f"({real_text(value, proof.names)})"


def _functions(claim: Proposition, bound: frozenset[Symbol] = frozenset()) -> Iterator[Expr]:
    """Real values of functions in a proposition, without those of symbols that it binds."""
    bound |= set(claim.bound)
    left = list(claim.terms)
    while left:
        part = left.pop()
        root = part.is_Pow and part.exp.is_Rational and not part.exp.is_Integer
        if not (part.is_Function or root):
            left += part.args
        elif not (part.free_symbols & bound or complex_(part)):
            yield sqrt(part.base) if root else part
    for inner in claim.parts:
        yield from _functions(inner, bound)


TENTH = {
    sp.pi / 10: {sp.sin: "proj1 turn_by_a_tenth", sp.cos: "proj2 (proj2 turn_by_a_tenth)"},
    2 * sp.pi / 5: {sp.cos: "proj1 (proj2 turn_by_a_tenth)"},
}
"""Angles whose sines or cosines are roots that the library does not know, and where they stand."""


def _evaluated(proof: Proof, claim: Proposition, values: Terms) -> list[str]:
    """Tactics that write functions as SymPy does where terms stand in place of symbols."""
    lines = evaluated(_functions(claim), values, proof.names)
    moved = {s: term(v) for s, v in values.items()}
    if complex_(*moved, *moved.values()):
        return lines
    for f in dict.fromkeys(_functions(claim)):
        angle = f.args[0].xreplace(moved)
        if isinstance(f, (sp.sin, sp.cos)) and f.func in TENTH.get(angle, {}):
            way, new = f"({f.func}({real_text(angle, proof.names)}))", f.xreplace(moved)
            written = f"{way} ({real_text(new, proof.names)})"
            lines = [line.replace(written, f"{way} {way}") for line in lines]
            lines.insert(-1, f"rewrite ?({TENTH[angle][f.func]})")
            proof.helpers += [_tenth(proof)] * all(h.name != TURN for h in proof.helpers)
    return lines


TURN = "turn_by_a_tenth"


def _tenth(proof: Proof) -> Step:
    """From cos 3 x = sin 2 x for a twentieth of a turn."""
    root = "-1/4 + sqrt(5)/4"
    said = f"sin(PI/10) = {root} /\\ cos(2*PI/5) = {root} /\\ cos(PI/10) = sqrt(sqrt(5)/8 + 5/8)"
    lines = """
assert (P := PI_RGT_0); assert (Q : sqrt 5 * sqrt 5 = 5) by (apply sqrt_sqrt; lra).
assert (S : 0 < sin (PI/10)) by (apply sin_gt_0; lra).
assert (C : 0 < cos (PI/10)) by (apply cos_gt_0; lra); assert (One := pythagoras (PI/10)).
assert (D : cos (2*(PI/10) + PI/10) = sin (2*(PI/10))) by (rewrite <- cos_shift; f_equal; field).
rewrite cos_plus, sin_2a, cos_2a in D.
assert (E : 4 * sin (PI/10) ^ 2 + 2 * sin (PI/10) - 1 = 0).
{ apply Rmult_eq_reg_l with (cos (PI/10)); [nra | lra]. }
assert (F : sin (PI/10) = -1/4 + sqrt 5 / 4) by (assert (R := sqrt_pos 5); nra).
split; [exact F |]; split.
- rewrite <- F, <- (cos_shift (PI/10)); f_equal; field.
- apply Rsqr_inj; [lra | apply sqrt_pos |]; rewrite Rsqr_sqrt by (assert (R := sqrt_pos 5); lra).
  unfold Rsqr; rewrite F in One; nra.
"""
    rule, claim = proof.step.rule, proof.step.conclusion
    return Step(TURN, rule, (), (), claim, said, lines=lines.strip().splitlines())


def evaluated(functions: Iterable[Expr], values: Terms, names: Names) -> list[str]:
    """The same of real functions: each by way of the function of its argument's new form."""
    values = {s: term(v) for s, v in values.items() if s != v}
    if complex_(*values, *values.values()):
        return []
    found = [f for f in functions if f.free_symbols & set(values)]
    kept = dict(names.spelled)
    texts = {s: real_text(v, names) for s, v in values.items()}
    names.spelled |= {s: t if values[s].is_Symbol else f"({t})" for s, t in texts.items()}
    before = {f: real_text(f, names) for f in found}
    names.spelled = kept
    lines = set()
    for f, old in before.items():
        new = real_text(f.xreplace(values), names)
        if old.replace("((", "(").replace("))", ")") != new.replace("((", "(").replace("))", ")"):
            way = f"{old[: old.index('(')]}({real_text(f.args[0].xreplace(values), names)})"
            lines.add(f"rewritten ({old}) ({way}) ({new})")
    return [*sorted(lines), "tidied"] if lines else []


@shows
def spec(proof: Proof, theorem: Theorem) -> None:
    """What holds for all holds for a term, in the form that SymPy gives it."""
    (premise,), values = theorem.premises, theorem.given[1]
    claim = premise.conclusion
    assert isinstance(claim, ForAll)
    if any(is_complex(v) for s, v in values.items() if v.is_Symbol and not is_complex(s)):
        _spec_of_real(proof, theorem)
        return
    found = f"{proof.have(premise)} {' '.join(_values(proof, claim.over, values))}"
    turns, angles = _evaluated(proof, claim.body, values), _turned(proof, claim.body, values)
    if _vanishes(claim.body, values):
        name = proof.new("P")
        proof.say(
            f"pose proof ({found}) as {name}; cbv beta in {name}.",
            f"repeat match type of {name} with context [Cexp ?a] => "
            f"rewrite (Cexp_nought a) in {name} by Cring end.",
            f"finish {name}.",
        )
    elif turns or angles:
        given, name = proof.new("G"), proof.new("P")
        implied = isinstance(theorem.conclusion, Implies)
        proof.say(*[f"intros {given}."] * implied, f"pose proof ({found}) as {name}.")
        proof.say(*(f"{angle} in {name} by (f_equal; Cpushed; Csame_field)." for angle in angles))
        proof.say(*(f"{turn} in {name}." for turn in turns))
        proof.say(*[f"feed {name} {given}."] * implied, f"finish {name}.")
    else:
        proof.say(f"finish ({found}).")


def _spec_of_real(proof: Proof, theorem: Theorem) -> None:
    """At complex symbols that what is implied says to be real: each is taken for its real part."""
    claim: Any = theorem.premises[0].conclusion
    values = [term(theorem.given[1][s]) for s in claim.over]
    given, known, names = proof.new("G"), proof.new("P"), proof.names
    proof.say(f"intros {given}.")
    kept = dict(names.spelled)
    for symbol in dict.fromkeys(v for v in values if v.is_Symbol and is_complex(v)):
        at, real = names[symbol], proof.new("r")
        proof.say(
            f"assert (E : {at} = RtoC (Re {at})) by (opened; match goal with A : Cless _ {at} |- _ "
            "=> apply injective_projections; [reflexivity | exact (proj1 (proj2 A))] end).",
            f"revert {given} E; generalize (Re {at}); intros {real} {given} E; subst {at}.",
        )
        names.spelled[symbol] = f"(RtoC {real})"
    parts = " ".join(f"(Re ({complex_text(v, names)})%C)" for v in values)
    names.spelled = kept
    proof.say(
        f"revert {given}; pose proof ({proof.have(theorem.premises[0])} {parts}) as {known}.",
        f"simpl in {known}; finish {known}.",
    )


@shows
def undisch(proof: Proof, theorem: Theorem) -> None:
    """An implication is applied to its hypotheses."""
    (premise,) = theorem.premises
    claim = premise.conclusion
    assert isinstance(claim, Implies)
    proof.say(f"finish ({proof.have(premise)} {proof.find(claim.of[0])}).")


@shows
def inst(proof: Proof, theorem: Theorem) -> None:
    """A lemma at terms; its hypotheses are found among those that SymPy made of them."""
    (premise,), values = theorem.premises, theorem.given[1]
    if premise.rule == "assume":
        proof.say(f"finish {proof.find(premise.conclusion.at(values))}.")
        return
    step = proof.known[said(premise)]
    at = {s: values.get(s, s) for s in step.free}
    inner = {s: proof.value(s) for s in step.free if s not in values}
    args = [inner[s] if s in inner else _values(proof, [s], at)[0] for s in step.free]
    name = proof.new("P")
    proof.say(f"pose proof ({' '.join([step.name, *args])}) as {name}.")
    whole = Implies((And(step.hypotheses), step.conclusion))
    proof.say(*(f"{turn} in {name}." for turn in _evaluated(proof, whole, values)))
    for claim in step.hypotheses:
        moved = claim.at(values)
        known = proof.scope.get(moved, "I")
        proof.say(f"feed {name} {known}.")
    proof.say(f"finish {name}.")


@shows
def subst(proof: Proof, theorem: Theorem) -> None:
    """Equals for equals, by the principle of equality."""
    pattern, place, known, equation = (
        proposition(theorem.given[0]),
        theorem.given[1],
        *theorem.premises,
    )
    claim: Any = equation.conclusion
    kind, write = ("C", complex_text) if is_complex(place) else ("R", real_text)
    if kind == "R" and complex_(claim.left, claim.right):
        raise NotPrinted("a real number that is written with j, in place of a symbol")
    scope = "%C" if kind == "C" else ""
    sides = [f"({write(t, proof.names)}){scope}" for t in (claim.left, claim.right)]
    proof.keep(equation)
    before = proof.have(known)
    with proof.names.bound(place) as [name]:
        body = proof.text(pattern)
    old, new, turned = proof.new("P"), proof.new("P"), proof.new("E")
    there, here = (_evaluated(proof, pattern, {place: t}) for t in (claim.left, claim.right))
    proof.say(
        f"assert ({old} : (fun {name} : {kind} => {body}) {sides[0]}).",
        "{",
        "cbv beta.",
        *(f"{turn}." for turn in there),
        f"finish {before}.",
        "}",
        f"assert ({turned} : {sides[0]} = {sides[1]}) by (opened; assumed).",
        f"pose proof (eq_ind _ (fun {name} : {kind} => {body}) {old} _ {turned}) as {new}.",
        f"cbv beta in {new}; clear {old}.",
        *(f"{turn} in {new}." for turn in here),
        f"finish {new}.",
    )


@shows
def exists(proof: Proof, theorem: Theorem) -> None:
    """A term that has the property."""
    wanted, values = theorem.conclusion, theorem.given[2]
    assert isinstance(wanted, Exists)
    terms = ", ".join(_values(proof, wanted.over, values))
    turns = _evaluated(proof, wanted.body, values)
    proof.say(f"exists {terms}.", *(f"{turn}." for turn in turns))
    proof.say(*_square_roots(wanted.body, values))
    proof.say(f"finish {proof.have(theorem.premises[0])}.")


def _vanishes(claim: Proposition, values: Terms) -> bool:
    """Whether the exponent of a complex exponential becomes zero."""
    exponents = (
        f.args[0] for p in _all_parts(claim) for t in p.terms for f in t.atoms(exp) if complex_(f)
    )
    return any(e.xreplace(dict(values)) == 0 for e in exponents if e != 0)


def _turned(proof: Proof, claim: Proposition, values: Terms) -> list[str]:
    """Tactics that write complex exponentials as SymPy does where a quotient stands in them."""
    quotients = {s: v for s, v in values.items() if term(v).is_Mul and sp.denom(v).free_symbols}
    turns = {f for p in _all_parts(claim) for t in p.terms for f in t.atoms(exp) if complex_(f)}
    names, kept, lines = proof.names, dict(proof.names.spelled), set()
    for turn in turns:
        if turn.free_symbols & quotients.keys() and not complex_(*values.values()):
            new = complex_text(turn.xreplace(quotients), names)
            names.spelled |= {s: f"({real_text(term(v), names)})%R" for s, v in quotients.items()}
            old, names.spelled = complex_text(turn, names), dict(kept)
            lines.add(f"replace ({old})%C with ({new})%C")
    return sorted(lines)


def _square_roots(claim: Proposition, values: Terms) -> list[str]:
    """Tactics that say what the roots of squares are, of complex symbols at rational numbers."""
    powers = {p for part in _all_parts(claim) for t in part.terms for p in t.atoms(Pow)}
    lines = set()
    for power in powers:
        base, exponent = (term(of).xreplace(dict(values)) for of in power.args)
        root = sqrt(base)
        if complex_(power.base) and abs(exponent) == S.Half and root.is_Rational and root > 0:
            lines.add(f"rewrite (Craised_root ({base}) ({root})) by lra.")
    return sorted(lines)


def _all_parts(claim: Proposition) -> Iterator[Proposition]:
    yield claim
    for part in claim.parts:
        yield from _all_parts(part)


@shows
def choose(proof: Proof, theorem: Theorem) -> None:
    """What exists is given a name."""
    existence, then = theorem.premises
    claim = existence.conclusion
    assert isinstance(claim, Exists)
    source = proof.have(existence)
    with proof.names.introduced(*claim.over) as names:
        held = proof.new("B")
        pattern = held
        for name in reversed(names):
            pattern = f"[{name} {pattern}]"
        proof.say(f"destruct {source} as {pattern}.")
        proof.know(claim.body, held)
        proof.say(f"finish {proof.have(then)}.")
