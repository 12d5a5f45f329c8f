"""Rules on the zeros of polynomials: each is a theorem of ``Circle.v`` or ``HalfPlane.v``.

A theorem there is about a list of real coefficients with their exponents, natural numbers.  Here a
polynomial is written as such a list, and the text of the chapter is shown to say the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import Predicate, Relation, whole
from symhaptic.notation.terms import term
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.identities import plain, powers_of_few, same
from symhaptic.rocq.logic import Written
from symhaptic.rocq.steps import Proof
from symhaptic.rocq.terms import NotPrinted, complex_, real_text

ZEROS: dict[str, Written] = {}
"""How a step of each rule on zeros is proved."""


def shows(write: Written) -> Written:
    """A rule's proof, under the rule's name."""
    ZEROS[write.__name__] = write
    return write


@dataclass(frozen=True)
class Powers:
    """A polynomial as exponents with their coefficients, the leading one first."""

    terms: tuple[tuple[Expr, Expr], ...]

    def over(self, power: Expr) -> Powers:
        """Divided by a power of its variable."""
        return Powers(tuple((sp.expand(e - power), c) for e, c in self.terms))


def powers(polynomial: Any, variable: Symbol) -> Powers:
    """A polynomial, whose exponents may have symbols, as a sum of powers."""
    found: dict[Expr, Expr] = {}
    for summand in sp.Add.make_args(sp.expand(term(polynomial))):
        coefficient, power = summand.as_independent(variable, as_Add=False)
        factors = [f.as_base_exp() for f in sp.Mul.make_args(power) if f != 1]
        if any(base != variable for base, _ in factors):
            raise NotPrinted(f"{summand}, no multiple of a power of {variable}")
        exponent = sp.expand(sp.Add(*(e for _, e in factors)))
        found[exponent] = found.get(exponent, sp.S.Zero) + coefficient
    terms = sorted(((e, c) for e, c in found.items() if c != 0), key=lambda t: str(t[0]))
    leads = [t for t in terms if all(natural(t[0] - e - 1) for e, _ in terms if e != t[0])]
    return Powers((*leads, *(t for t in terms if t not in leads)))


def natural(exponent: Expr) -> bool:
    """Whether an exponent is a sum of symbols and a number, all of them taken whole times."""
    shares = sp.expand(exponent).as_coefficients_dict()
    return all(n.is_Integer and n >= 0 and (s == 1 or s.is_Symbol) for s, n in shares.items())


class Lists:
    """Polynomials as lists in a proof, where whole numbers are natural ones."""

    def __init__(self, proof: Proof) -> None:
        self.proof = proof
        self.numbers: dict[Expr, tuple[str, Expr]] = {}
        """Natural numbers by what they are without their constant, with this constant."""
        claims = (h for h in proof.step.hypotheses if isinstance(h, Predicate))
        known = [sp.expand(h.of[0]) for h in claims if h.name == "whole"]
        for of in sorted(known, key=lambda of: (not of.is_Symbol, of.as_coeff_Add()[0], str(of))):
            constant, rest = of.as_coeff_Add()
            if rest not in self.numbers and not rest.free_symbols <= self.numbers.keys():
                name = proof.new("N")
                self.numbers[rest] = name, constant
                proof.say(f"destruct {proof.find(whole(of))} as [{name} {proof.new('E')}].")

    def number(self, exponent: Expr) -> str:
        """An exponent as a natural number, its constant first."""
        constant, rest = sp.expand(exponent).as_coeff_Add()
        parts = []
        if natural(rest) and all(self.numbers.get(s, ("", 1))[1] == 0 for s in rest.free_symbols):
            shares = sorted(rest.as_coefficients_dict().items(), key=str)
            parts = [self.numbers[s][0] for s, n in shares if s.is_Symbol for _ in range(n)]
        elif rest in self.numbers:
            name, less = self.numbers[rest]
            constant, parts = constant - less, [name]
        elif rest != 0:
            raise NotPrinted(f"the exponent {exponent}")
        if not (constant.is_Integer and constant >= 0):
            raise NotPrinted(f"the exponent {exponent}")
        parts = [str(constant), *parts] if constant or not parts else parts
        return f"({' + '.join(parts)})%nat"

    def text(self, of: Powers) -> str:
        """A polynomial as a list."""
        pairs = (f"(({self._real(c)})%R, {self.number(e)})" for e, c in of.terms)
        return f"({' :: '.join([*pairs, 'nil'])})%list"

    def swapped(self, of: Powers) -> str:
        """The same with each exponent before its coefficient."""
        pairs = (f"({self.number(e)}, ({self._real(c)})%R)" for e, c in of.terms)
        return f"({' :: '.join([*pairs, 'nil'])})%list"

    def _real(self, coefficient: Expr) -> str:
        if complex_(coefficient):
            raise NotPrinted("a real coefficient that is written with j")
        return real_text(coefficient, self.proof.names)

    def turns(self, side: Expr, angle: Expr) -> list[str]:
        """Tactics that write exponentials in a goal as powers of exp(j angle)."""
        lines = []
        for turn in sorted(side.atoms(sp.exp), key=str):
            if complex_(turn):
                power = sp.expand(turn.args[0] / (sp.I * angle))
                there = f"Cexp (Ci * RtoC ({real_text(angle, self.proof.names)})%R)"
                mirrored = f"Cconj ({there})" if natural(-power) else there
                power = -power if natural(-power) else power
                there = f"({mirrored})" + f" ^ {self.number(power)}" * (power != 1)
                text = complex_text(turn, self.proof.names)
                lines.append(f"replace ({text})%C with ({there})%C by a_turn.")
        return lines

    def quarters(self, side: Expr, place: Symbol) -> list[str]:
        """The same of powers of j exp(place)."""
        lines, names = [], self.proof.names
        base = f"RtoC (exp ({real_text(place, names)})) * Ci"
        for turn in sorted(side.atoms(sp.exp), key=str):
            power = sp.expand(sp.cancel(turn.args[0] / (place + sp.I * sp.pi / 2)))
            if complex_(turn) and natural(power):
                text = complex_text(turn, names)
                lines.append(f"replace ({text})%C with (({base}) ^ {self.number(power)})%C")
                at = real_text(place, names)
                lines.append(f"  by (rewrite <- (Cexp_quarter_turn ({at}) _ eq_refl); a_turn).")
        return lines


def known_exponentials(proof: Proof, *terms: Expr, symbols: bool = False) -> None:
    """Real exponentials, of numbers or of all, are told as powers of few, for ``summed``."""
    atoms = {f for t in terms for f in t.atoms(sp.exp)}
    found = {plain(f) for f in atoms if symbols or not f.free_symbols}
    for equation in powers_of_few(sorted(found, key=str), proof.names):
        proof.say(f"assert ({proof.new('X')} : {equation}.")


def _inside(theorem: Theorem) -> tuple[Expr, Symbol]:
    """The polynomial of which a theorem says that its zeros lie inside, and its variable."""
    claim = theorem.conclusion
    assert isinstance(claim, Predicate)
    return claim.of[0], claim.over[0]


@shows
def zero_on_circle(proof: Proof, theorem: Theorem) -> None:
    """The polynomial is evaluated at exp(j theta)."""
    polynomial, variable, angle, zero = theorem.given
    polynomial, angle, names = term(polynomial), term(angle), proof.names
    side = zero.conclusion.left
    proof.keep(zero)
    lists = Lists(proof)
    real = real_text(angle, names)
    point = f"Cexp (Ci * RtoC ({real})%R)"
    proof.say("opened.", f"apply (zero_on_circle _ ({real})%R); cbv beta.")
    for power in sorted(polynomial.atoms(sp.Pow), key=str):
        if power.base == variable and power.exp.free_symbols:
            text, number = complex_text(power.exp, names), lists.number(power.exp)
            proof.say(f"replace (Craised ({point}) ({text}))%C with (({point}) ^ {number})%C")
            proof.say("  by (symmetry; apply Craised_natural; counted).")
    value = sp.exp(sp.I * angle)
    if not value.has(sp.exp):
        proof.say(f"replace ({point})%C with ({complex_text(value, names)} : C)%C by turned_value.")
    if side == 0:
        proof.say("summed_powers.")
    else:
        known = "taken"
        if not complex_(side):  # the zero is known in real numbers
            there = f"transitivity (RtoC ({real_text(side, names)}))"
            known = f"first [taken | {there}; [Cpushed; Cring | taken]]"
        proof.say(
            f"transitivity ({complex_text(side, names)})%C; [| {known}].",
            *lists.turns(side, angle),
            "summed_powers.",
        )


@shows
def all_inside(proof: Proof, theorem: Theorem) -> None:
    """The zeros of a product are those of its factors."""
    variable, power, *factors = theorem.given
    power, names = term(power), proof.names
    known = [proof.keep(f) for f in factors]
    with names.bound(variable) as [v]:
        names.as_complex.add(variable)
        inside = (_inside(f) for f in factors)
        texts = [complex_text(of.xreplace({v: variable}), names) for of, v in inside]
        raised = complex_text(variable**power, names) if power.free_symbols else f"{v} ^ {power}"
        names.as_complex.discard(variable)
    product = " * ".join(f"({t})" for t in (raised, *texts))
    proof.say(
        f"apply (stable_alike _ (fun {v} : C => {product})%C).",
        f"- intro {v}; cbn [Cpower]; summed.",
    )
    shown = "apply power_inside" if power.free_symbols else f"apply (literal_inside {power})"
    for name in known:
        shown = f"apply Circle.all_inside; [{shown} | opened; assumption]" if name else shown
    proof.say(f"- {shown}.")


@shows
def last_coefficient(proof: Proof, theorem: Theorem) -> None:
    """It is the product of the zeros, up to its sign."""
    inside, *power = theorem.given
    lowest = sp.expand(term(power[0])) if power else sp.S.Zero
    rest = powers(*_inside(inside)).over(lowest)
    proof.keep(inside)
    lists = Lists(proof)
    known_exponentials(proof, _inside(inside)[0])
    lead = lists.number(rest.terms[0][0])
    proof.say(
        "opened; defined; with_inside ltac:(fun p S =>",
        f"  apply (last_inside p (powers {lists.text(rest)}) {lead} {lists.number(lowest)});",
        "  [apply powers_monic; degrees | lia | exact S | as_powers | at_zero]).",
    )


@shows
def opposite(proof: Proof, theorem: Theorem) -> None:
    """The zeros of p(-z) are the opposite ones."""
    (inside,) = theorem.given
    lead, _ = powers(*_inside(inside)).terms[0]
    proof.keep(inside)
    lists = Lists(proof)
    proof.say(
        f"with_inside ltac:(fun p S => apply (opposite p _ ((- RtoC 1) ^ {lists.number(lead)})%C);",
        "  [apply sign_apart | exact S |]).",
        *(f"pose proof (sign_square {n}) as {proof.new('Q')}." for n, _ in lists.numbers.values()),
        "opposed.",
    )


@shows
def roots_stay(proof: Proof, theorem: Theorem) -> None:
    """No zero crosses the circle on the way from f to f + g."""
    start, change, variable, share, angle, crossing, static, begin, *inwards = theorem.given
    f, g = powers(start, variable), powers(change, variable)
    h = powers(*_inside(begin))
    for premise in (begin, *inwards):
        proof.keep(premise)
    lists = Lists(proof)
    first, then, lead = lists.text(f), lists.text(g), f.terms[0][0]
    proof.say(
        f"apply (stable_alike (fun z => powers {first} z + powers {then} z)%C); [as_powers |].",
    )
    known = [
        "apply powers_monic; degrees",
        "apply powers_below; degrees",
        *["apply powers_real"] * 2,
    ]
    if inwards:
        sides = (f"({real_text(t.conclusion.right, proof.names)})" for t in reversed(inwards))
        proof.say(
            f"apply (roots_stay_inwards (powers {first}) (powers {lists.text(h)}) (powers {then}) "
            f"{lists.number(lead - 1)} {' '.join(sides)}).",
        )
        known = ["as_powers", *known, *["at_one"] * 2]
    else:
        proof.say(f"apply (roots_stay (powers {first}) (powers {then}) {lists.number(lead)}).")
    proof.say(*(f"- {line}." for line in known))
    between = [(share, "Y", sp.S.One), (angle, "T", sp.pi)]
    for premise, over in ((crossing, between), (static, between[:1])):
        scope = dict(proof.scope)
        with proof.names.introduced(*(s for s, *_ in over)) as names:
            ends = " ".join(f"[{letter}0 {letter}1]" for _, letter, _ in over)
            proof.say(f"- intros {' '.join(names)} {ends} Z.")
            for symbol, letter, upper in over:
                proof.scope[Relation(sp.S.Zero, "<", symbol)] = f"{letter}0"
                proof.scope[Relation(symbol, "<=", upper)] = f"{letter}1"
            proof.say(f"  pose proof {proof.have(premise)} as A; opened.")
            side = premise.conclusion.left
            proof.say(*(f"  {line}" for line in _contradicted(lists, side, angle)))
        proof.scope = scope
    proof.say(
        "- with_inside ltac:(fun p S => apply (stable_alike p); [as_powers | exact S]).",
        *["- opened; assumption."] * len(inwards),
    )


def _contradicted(lists: Lists, side: Expr, angle: Expr) -> list[str]:
    """A premise says that this is not zero, and Z says that it is, as a sum of powers."""
    text = complex_text(side, lists.proof.names)
    return [
        f"absurd (({text})%C = RtoC 0); [apart_by |].",
        "rewrite <- Z; cbn [powers].",
        *lists.turns(side, angle),
        "summed_powers.",
    ]


@shows
def none_enters(proof: Proof, theorem: Theorem) -> None:
    """No zero of p(v^2) + g(v) crosses the border of what lies to the right outside the circle."""
    begin, change, over, *shown = theorem.given
    variable, share, place, x, y = over
    p, g = powers(*_inside(begin)), powers(change, variable)
    lead, *rest = ((2 * e, c) for e, c in p.terms)
    proof.keep(begin)
    wholes = {h: proof.new("W") for h in proof.step.hypotheses if getattr(h, "name", "") == "whole"}
    proof.say(*(f"pose proof {proof.find(h)} as {copy}." for h, copy in wholes.items()))
    lists = Lists(proof)  # takes what is whole apart
    proof.scope |= wholes
    first, then, names = lists.text(p), lists.text(g), proof.names
    proof.say(
        f"assert (E := none_enters (powers {first}) (powers {then}) {lists.number(lead[0])}).",
        f"destruct (powers_monic {lists.number(lead[0])} {lists.text(Powers(tuple(rest)))} "
        "ltac:(degrees)) as (a' & L' & F').",
        "specialize (E ltac:(exists a'; split; [exact L' | intro; rewrite <- F'; "
        f"{_SQUARED} summed])); clear a' L' F'.",
        "specialize (E ltac:(apply powers_below; degrees) ltac:(apply powers_real) "
        "ltac:(apply powers_real)).",
        "specialize (E ltac:(with_inside "
        "ltac:(fun p S => apply (stable_alike p); [as_powers | exact S]))).",
    )
    within = (share, "Y", sp.S.One), (place, "T", sp.pi / 2)
    for premise, ends in zip(shown, (within, within[:1], within), strict=True):
        scope, axis = dict(proof.scope), premise is shown[2]
        with names.introduced(*(s for s, *_ in ends)) as named:
            known = [f"[{letter}0 {letter}1]" for _, letter, _ in ends]
            known[1:] = ["T0"] if axis else known[1:]
            proof.say("match type of E with ?P -> _ => assert (A : P) end.", "{")
            proof.say(f"intros {' '.join(named)} {' '.join(known)} Z.")
            for symbol, letter, upper in ends:
                proof.scope[Relation(sp.S.Zero, "<", symbol)] = f"{letter}0"
                proof.scope[Relation(symbol, "<=", upper)] = f"{letter}1"
            side = premise.conclusion.left
            proof.say(f"pose proof {proof.have(premise)} as A; opened.")
            if axis:
                known_exponentials(proof, side, symbols=True)
            proof.say(f"absurd (({complex_text(side, names)})%C = RtoC 0 :> C); [apart_by |].")
            proof.say("rewrite <- Z; cbn [powers].")
            proof.say(*(lists.quarters(side, place) if axis else lists.turns(side, place)))
            last = _WITH_J if axis else "summed_powers"
            proof.say(f"{_SQUARED} {last}.", "}", "specialize (E A); clear A.")
        proof.scope = scope
    with names.introduced(x, y) as [along, across]:
        proof.say(
            f"intros {along} {across} [X O]; assert (A : ({along} + Ci * {across})%C <> RtoC 0)",
            "  by (let K := fresh in intro K; apply (f_equal Re) in K; simpl in K; lra).",
            "repeat (split; [assumption |]).",
            f"intro Z; apply (E {along} {across} X O); rewrite <- Z.",
            f"generalize ({along} + Ci * {across})%C; intro; natural_powers; {_SQUARED} summed.",
        )


_SQUARED = (
    "cbn [powers]; repeat rewrite Cpower_plus; cbn [Cpower]; repeat rewrite Cpower_product; "
    "rewrite ?Cpower_one;"
)
"""Tactics that write powers of squares as powers."""
_WITH_J = (
    "exponentials; Cpushed; cbn [Cpower]; assert (Sq := Ci_square); undivided; "
    "first [solve [field [Sq]; Cnz] | solve [ring [Sq]]]"
)


@shows
def outpaces(proof: Proof, theorem: Theorem) -> None:
    """On the circle it turns faster than half its degree."""
    inside, angle = theorem.given[0], term(theorem.given[1])
    of = powers(*_inside(inside))
    claim: Any = theorem.conclusion
    proof.keep(inside)
    lists = Lists(proof)
    known_exponentials(proof, _inside(inside)[0])
    (degree, _), *rest = of.terms
    point = f"(Cexp (Ci * RtoC ({real_text(angle, proof.names)})%R)%C)"
    proof.say(
        f"with_inside ltac:(fun p S => assert (O := outpaces_powers {lists.number(degree)}",
        f"  {lists.text(Powers(tuple(rest)))} {point}",
        "  ltac:(degrees) ltac:(lia) ltac:(apply Cmod_turned)",
        "  ltac:(apply (stable_alike p); [as_powers | exact S]))).",
        "refine (eq_ind _ (Cless (RtoC 0)) O _ _); clear O; swung.",
        *lists.turns(claim.right, angle),
        "conjugates; summed_powers.",
    )


@shows
def first_minors(proof: Proof, theorem: Theorem) -> None:
    """They are made of sums over the coefficients."""
    inside, _ = theorem.given
    of = powers(*_inside(inside))
    proof.keep(inside)
    lists = Lists(proof)
    known_exponentials(proof, _inside(inside)[0])
    (degree, _), *rest = of.terms
    proof.say(
        f"with_inside ltac:(fun p S => destruct (first_minors {lists.number(degree)}",
        f"  {lists.text(Powers(tuple(rest)))} ltac:(degrees)",
        "  ltac:(apply (stable_alike p); [as_powers | exact S])) as (C0 & C1 & C2)).",
        "try specialize (C1 ltac:(lia)); try specialize (C2 ltac:(lia)).",
        "repeat split; first [minor_of C0 | minor_of C1 | minor_of C2].",
    )


@shows
def jury(proof: Proof, theorem: Theorem) -> None:
    """Jury's inequalities up to the fourth degree; z times a quadratic is a cubic."""
    polynomial, variable = theorem.given
    found = {int(e): c for e, c in powers(polynomial, variable).terms}
    degree = max(found)
    a, b, c, d = (found.get(degree - k, sp.S.Zero) for k in range(1, 5))
    if degree == 2:
        wanted = [1 + a + b, 1 - a + b, 1 - b]
        said = ["1 + {a} + {b}", "1 - {a} + {b}", "1 - {b}"]
    elif degree == 3:
        wanted = [1 + a + b + c, 3 + a - b - 3 * c, 1 - a + b - c, 1 - b + a * c - c**2]
        said = ["1 + {a} + {b} + {c}", "3 + {a} - {b} - 3 * {c}", "1 - {a} + {b} - {c}",
                "1 - {b} + {a} * {c} - {c} ^ 2"]  # fmt: skip
    elif degree == 4:
        wanted = [1 + a + b + c + d, 6 - 2 * b + 6 * d, 1 - a + b - c + d, 1 - d,
                  (1 - d) * (1 - d**2) - b * (1 - d) ** 2 + (a - c) * (c - a * d)]  # fmt: skip
        said = ["1 + {a} + {b} + {c} + {d}", "6 - 2 * {b} + 6 * {d}", "1 - {a} + {b} - {c} + {d}",
                "1 - {d}", "(1 - {d}) * (1 - {d} ^ 2) - {b} * (1 - {d}) ^ 2 + "
                "({a} - {c}) * ({c} - {a} * {d})"]  # fmt: skip
    else:
        raise NotPrinted(f"Jury's inequalities for the degree {degree}")
    _criterion(proof, theorem, f"jury_{degree}", [a, b, c, d][:degree], wanted, said)


@shows
def hurwitz(proof: Proof, theorem: Theorem) -> None:
    """Hurwitz' determinants of a cubic."""
    polynomial, variable = theorem.given
    found = {int(e): c for e, c in powers(polynomial, variable).terms}
    if max(found) != 3:
        raise NotPrinted(f"Hurwitz' determinants for the degree {max(found)}")
    a, b, c, d = (found.get(k, sp.S.Zero) for k in (3, 2, 1, 0))
    wanted = [b, b * c - a * d, d * (b * c - a * d)]
    said = ["{b}", "{b} * {c} - {a} * {d}", "{d} * ({b} * {c} - {a} * {d})"]
    _criterion(proof, theorem, "hurwitz_cubic", [a, b, c, d], wanted, said)


def _criterion(
    proof: Proof,
    theorem: Theorem,
    name: str,
    coefficients: list[Expr],
    wanted: list[Expr],
    said: list[str],
) -> None:
    """A criterion for these coefficients; its expressions are written as the theorem has them."""
    claim: Any = theorem.conclusion
    names = proof.names
    if complex_(*coefficients):
        raise NotPrinted("a real coefficient that is written with j")
    texts = [f"({real_text(c, names)})" for c in coefficients]
    holds = dict(zip("abcd", texts, strict=False))
    inequalities = claim.of[1].of
    known_exponentials(proof, claim.of[0].of[0])
    given = " ltac:(opened; assumption)" if name == "hurwitz_cubic" else ""
    if name == "jury_2":
        positive = " /\\ ".join(f"0 < {one.format(**holds)}" for one in said)
        proof.say(
            "lazymatch goal with |- context [stable ?p] => "
            f"assert (J : stable p <-> {positive}) by (",
            "  apply (iff_trans (iff_sym (times_z p (fun z => z * p z)%C (fun z => eq_refl))));",
            f"  apply (iff_trans (jury_3 (fun z => z * p z)%C {' '.join(texts)} 0",
            "    ltac:(as_powers)));",
            "  split; intros; opened; repeat split; lra) end.",
        )
    else:
        proof.say(
            f"lazymatch goal with |- context [stable ?p] => assert (J := {name} p {' '.join(texts)}"
            f"{given} ltac:(as_powers))"
            f" | |- context [hurwitz ?p] => assert (J := {name} p {' '.join(texts)}"
            f"{given} ltac:(as_powers)) end.",
        )
    # what stands in others is written last
    for one, text, inequality in reversed(list(zip(wanted, said, inequalities, strict=True))):
        shown = same(one, inequality.right, names)
        equal = f"{text.format(**holds)} = {real_text(inequality.right, names)}"
        proof.say(f"assert (Q : {equal}).", "{", *shown, "}", "try rewrite Q in J; clear Q.")
    proof.say("finish J.")


@shows
def degree(proof: Proof, theorem: Theorem) -> None:
    """The leading coefficient is not zero."""
    polynomial, variable, power = theorem.given
    of = powers(polynomial, variable)
    lists = Lists(proof)
    (lead, coefficient), *rest = of.terms
    proof.say(
        "opened; defined.",
        f"apply (degree_of _ ({real_text(coefficient, proof.names)}) {lists.number(lead)} "
        f"{lists.text(Powers(tuple(rest)))}); [nz | degrees | as_powers | counted_real].",
    )
    del power


@shows
def not_of_degree(proof: Proof, theorem: Theorem) -> None:
    """Nothing has a degree."""
    if sp.expand(term(theorem.given[0])) != 0:
        raise NotPrinted("a polynomial without this power")
    proof.say("apply no_degree; reflexivity.")
