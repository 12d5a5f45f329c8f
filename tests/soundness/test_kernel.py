"""The kernel says no: by hand, under other hypotheses, about something else, and vacuously."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace

import pytest
import sympy as sp
from sympy import Ne, Rational, S, cos, exp, pi, sin, symbols
from sympy.core.function import AppliedUndef

from symhaptic.notation.proposition import (
    FALSE,
    And,
    Exists,
    ForAll,
    Iff,
    Implies,
    Not,
    Or,
    Predicate,
    Relation,
    proposition,
    whole,
)
from symhaptic.notation.terms import NoTerm, term
from symhaptic.proof.certificate import Positive
from symhaptic.proof.theorems import kernel, tactics
from symhaptic.proof.theorems.definedness import conditions, real
from symhaptic.proof.theorems.definitions import loop
from symhaptic.proof.theorems.derivation import leaves_of
from symhaptic.proof.theorems.familiar import ordered, square
from symhaptic.proof.theorems.kernel import (
    NotShown,
    Theorem,
    assume,
    choose,
    conj,
    conjunct,
    contr,
    disch,
    disj,
    disj_cases,
    exists,
    gen,
    imp_antisym,
    inst,
    mp,
    not_intro,
    prove_hyp,
    spec,
    subst,
    undisch,
)
from symhaptic.proof.theorems.leaves import (
    combined,
    identity,
    number,
    on_box,
)
from symhaptic.proof.theorems.roots import first_minors
from symhaptic.proof.theorems.tactics import denied

x, y, z = symbols("x y z")
ONE = number(sp.Lt(0, 1, evaluate=False))


# -- nobody but a rule makes a theorem ------------------------------------------------------


def test_a_theorem_is_not_made_by_hand() -> None:
    with pytest.raises(NotShown):
        Theorem(None, ((), FALSE), "assume", ((), ()))
    with pytest.raises(NotShown):
        Theorem(object(), ((), FALSE), "assume", ((), ()))
    with pytest.raises(AttributeError):
        ONE.conclusion = FALSE


def test_no_theorem_hides_from_what_rests_on_it() -> None:
    known = square(x)
    rests = leaves_of(combined(2 * x**2 >= 0, [2, known]))
    assert rests["square"] == 1
    for hidden in (frozenset([2, known]), iter([2, known])):
        assert leaves_of(combined(2 * x**2 >= 0, hidden)) == rests


def test_what_a_theorem_says_does_not_change_with_a_list() -> None:
    parts, bound = [ONE.conclusion], [x]
    known = conjunct(ONE, And(parts))  # type: ignore[arg-type]
    there = exists(ONE, Exists(bound, ONE.conclusion), {x: S.One})  # type: ignore[arg-type]
    parts.append(FALSE)
    bound.append(y)
    assert known.conclusion == And((ONE.conclusion,))
    assert there.conclusion == Exists((x,), ONE.conclusion)
    with pytest.raises(NotShown):
        conjunct(known, FALSE)


@pytest.mark.parametrize(
    "make",
    [
        lambda p: Not((p, p)),
        lambda p: Implies((p,)),
        lambda p: Implies((p, p, FALSE)),
        lambda p: Iff((p, p, p)),
        lambda p: And((p, x)),
        lambda p: ForAll((x,), x > 0),
    ],
)
def test_what_is_joined_are_so_many_propositions(make) -> None:
    with pytest.raises(NoTerm):
        make(ONE.conclusion)


def test_the_same_rule_of_the_same_is_the_same_theorem() -> None:
    def derived(x: sp.Symbol) -> Theorem:
        return gen(number(sp.Lt(3, 4, evaluate=False)), x)

    one, same, other = derived(x), derived(x), derived(y)
    assert one is same
    assert other.conclusion == one.conclusion
    # named otherwise, it can be asked for by that name only
    assert (one.conclusion.over, other.conclusion.over) == ((x,), (y,))
    with pytest.raises(NotShown):
        spec(other, {x: S.Zero})
    assert spec(other, {y: S.Zero}) is not spec(one, {x: S.Zero})


def test_a_number_of_another_kind_is_another_argument() -> None:
    assert assume(sp.Eq(x, 1)).conclusion == proposition(sp.Eq(x, 1))
    assert identity(x + 1, 1 + x) is identity(x + 1, 1 + x)
    for wrong in (True, 1.0, "1"):
        with pytest.raises(NoTerm):
            identity(S.One, wrong)


def test_a_rule_stands_in_the_kernel_only() -> None:
    def cheat() -> kernel.Judgement:
        return (), FALSE

    with pytest.raises(NotShown):
        kernel.rule(cheat)


# -- terms ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "wrong",
    [
        "x",
        0.5,
        True,
        sp.Float(1),
        sp.oo,
        sp.zoo,
        sp.nan,
        sp.Symbol("x", positive=True),
        sp.Symbol("A", commutative=False),
        sp.Integral(x, x),
        sp.Sum(x, (x, 0, 1)),
        sp.Piecewise((1, x > 0), (0, True)),
        sp.sign(x),
        sp.floor(x),
        x > 0,
        sp.Matrix([x]),
    ],
)
def test_what_is_no_term_is_refused(wrong: object) -> None:
    with pytest.raises(NoTerm):
        term(wrong)


def test_propositions_are_equal_up_to_bound_names_only() -> None:
    one = ForAll((x,), proposition(x > y))
    assert one == ForAll((sp.Symbol("w"),), proposition(sp.Symbol("w") > y))
    assert one != ForAll((y,), proposition(x > y))
    assert one != ForAll((x,), proposition(x > x + y))
    assert one != Exists((x,), proposition(x > y))
    # z is complex in the notation, w is real
    assert ForAll((z,), proposition(Ne(z, 1))) != ForAll(
        (sp.Symbol("w"),), proposition(Ne(sp.Symbol("w"), 1))
    )


def test_bound_symbols_give_way() -> None:
    claim = ForAll((x,), proposition(Ne(x, y)))
    moved = claim.at({y: x})
    assert moved != ForAll((x,), proposition(sp.Ne(x, x, evaluate=False)))
    assert x in moved.free


# -- definedness ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("expr", "divisor"),
    [
        (1 / x, x),
        (x ** Rational(-1, 2), x),
        (x**y, x),
        (sp.log(x), x),
        (sp.tan(x), cos(x)),
        (sp.cot(x), sin(x)),
        (exp(1 / x), x),
        (sin(1 / (x - 1)), x - 1),
    ],
)
def test_a_divisor_is_a_condition(expr: sp.Expr, divisor: sp.Expr) -> None:
    assert Relation(divisor, "!=", S.Zero) in conditions(expr)


@pytest.mark.parametrize("expr", [sp.sqrt(x), sp.log(x), z, exp(sp.I * x), x**y, (-1) ** x])
def test_what_need_not_be_real_is_not_real_by_its_form(expr: sp.Expr) -> None:
    assert not real(expr)


def test_an_identity_says_where_it_holds() -> None:
    assert identity((x**2 - 1) / (x - 1), x + 1).hypotheses == {Relation(x - 1, "!=", S.Zero)}


def test_a_hypothesis_does_not_become_weaker_when_sympy_cancels() -> None:
    """y/x = 1 says that x is not zero; with x for y it would become 1 = 1.

    The symbols are this test's own: a term x/x that was read before stays as it was written.
    """
    x, y = sp.symbols("x_here y_here")
    nonzero = inst(assume(sp.Eq(y / x, 1)), {y: x})
    assert Relation(x, "!=", S.Zero) in nonzero.hypotheses
    assert Relation(S.Zero, "!=", S.Zero) in inst(nonzero, {x: S.Zero}).hypotheses


def test_a_divisor_lost_under_a_quantifier_is_refused() -> None:
    w = sp.Symbol("w")
    claim = ForAll((w,), proposition(sp.Eq(y * w / w**2, 1)))
    with pytest.raises(NotShown):
        inst(assume(claim), {y: S.Zero})


def test_no_complex_term_for_a_real_symbol() -> None:
    positive = gen(square(x), x)
    for value in (sp.I, z, sp.sqrt(y), exp(sp.I * y)):
        with pytest.raises(NotShown):
            spec(positive, {x: value})
        with pytest.raises(NotShown):
            inst(square(x), {x: value})


# -- logic ----------------------------------------------------------------------------------


def test_rules_of_logic_refuse_what_does_not_follow() -> None:
    p, q = assume(x > 0), assume(y > 0)
    refused = [
        lambda: disch(p),
        lambda: mp(disch(p, x > 0), q),
        lambda: mp(p, q),
        lambda: conjunct(conj(p, q), x > 1),
        lambda: disj(p, Or((proposition(y > 0), proposition(y < 0)))),
        lambda: disj(p, And((proposition(x > 0),))),
        lambda: disj_cases(ordered(x, S.Zero), p),
        lambda: disj_cases(ordered(x, S.Zero), p, q),
        lambda: disj_cases(p, p),
        lambda: not_intro(p, q),
        lambda: not_intro(p, assume(x > -1)),
        lambda: denied(p, x > -1),
        lambda: denied(assume(x >= 0), x > 0),
        lambda: contr(p, x < 0),
        lambda: imp_antisym(disch(p, x > 0), disch(q, x > 0)),
        lambda: gen(p, x),
        lambda: spec(p, {x: S.One}),
        lambda: prove_hyp(p, q),
        lambda: undisch(p),
        lambda: choose(p, q),
    ]
    for wrong in refused:
        with pytest.raises(NotShown):
            wrong()


def test_a_witness_has_a_value_for_each_bound_symbol_and_for_no_other() -> None:
    """z = 2 and x = 1 at (1, 2) is no reason for an x with z = 2, whatever z is."""
    both = conj(identity(S(2), 2), identity(S.One, 1))
    wanted = Exists((x,), And((proposition(sp.Eq(z, 2)), proposition(sp.Eq(x, 1)))))
    for values in ({x: S.One, z: S(2)}, {z: S(2)}, {}):
        with pytest.raises(NotShown, match="no value for each"):
            exists(both, wanted, values)
    with pytest.raises(NotShown, match="no value for each"):
        exists(ONE, ONE.conclusion, {})


def test_what_is_substituted_into_is_what_was_shown() -> None:
    """0 < 1 and x = y say nothing of x < 1."""
    equation = assume(sp.Eq(x, y))
    with pytest.raises(NotShown, match="is not"):
        subst(Relation(z, "<", S.One), z, ONE, equation)
    with pytest.raises(NotShown, match="no relation with ="):
        subst(Relation(S.Zero, "<=", z), z, assume(x >= 0), assume(x < y))


def test_a_case_may_use_its_own_disjunct_only() -> None:
    cover = ordered(x, S.Zero)
    claim = proposition(x**2 >= 0)
    one, other = square(x), kernel.add_assum(square(x), x < 1)
    found = disj_cases(cover, one, other)
    assert proposition(x < 1) in found.hypotheses
    assert found.conclusion == claim


def test_of_no_case_nothing_follows() -> None:
    with pytest.raises(NotShown, match="one theorem for each case"):
        disj_cases(assume(FALSE))


def test_a_denied_relation_need_not_be_the_opposite_one() -> None:
    """not a < b holds where a has no value; b <= a does not follow."""
    with pytest.raises(NotShown):
        not_intro(assume(Not((proposition(1 / x < y),))), assume(Not((proposition(y <= 1 / x),))))


def test_existence_is_shown_by_real_values_and_says_no_more() -> None:
    claim = Exists((x,), proposition(x**2 < 0))
    with pytest.raises(NotShown):
        exists(number(sp.Lt(-1, 0, evaluate=False)), claim, {x: sp.I})
    with pytest.raises(NotShown):
        exists(ONE, claim, {x: S.One})
    existence = assume(Exists((x,), proposition(x > y)))
    with pytest.raises(NotShown):
        choose(existence, assume(x > y))


def test_order_of_quantifiers() -> None:
    """That each y has a larger x is not that one x is larger than every y."""
    each = ForAll((y,), Exists((x,), proposition(x > y)))
    there = spec(assume(each), {y: y})
    larger = assume(x > y)
    with pytest.raises(NotShown):
        gen(larger, y)
    with pytest.raises(NotShown):
        choose(there, disch(larger, x > y) and larger)


def test_a_theorem_knows_what_it_rests_on() -> None:
    found = combined(x * y > 0, [assume(x > 0), assume(y > 0)])
    assert leaves_of(found) == {"combined": 1, "assume": 2}


def test_whole_numbers() -> None:
    assert whole(x) == Predicate("whole", (), (x,))
    assert Implies((proposition(x > 0), proposition(y > 0))).free == {x, y}
    assert conditions(sp.tan(pi / 8)) == frozenset()


def test_reductio_needs_falsehood() -> None:
    with pytest.raises(NotShown):
        tactics.reductio(assume(x > 0), x > 0)


@pytest.mark.parametrize("rule", [conj, lambda made: conjunct(made, FALSE), undisch])
def test_only_what_a_rule_made_is_a_theorem(rule):
    made = SimpleNamespace(hypotheses=frozenset(), conclusion=FALSE)
    with pytest.raises(NotShown, match="is no theorem"):
        rule(made)


class Twice(Sequence[S]):
    """Says something else when it is read again."""

    def __init__(self, *ways):
        self.ways = list(ways)

    def __len__(self):
        return len(self.ways[0])

    def __getitem__(self, at):
        return self.ways[0][at]

    def __iter__(self):
        return iter(self.ways.pop(0) if len(self.ways) > 1 else self.ways[0])


def test_what_a_rule_is_given_is_read_once():
    """A loop without a wall, and one with 5: they are not stable together."""
    values = Twice((0, 0, 1, 1, 0), (5, 0, 1, 1, 0))
    assert loop(values, z) is loop((0, 0, 1, 1, 0), z)


class Changing(Positive):
    """Says first that it is of -1, and then of 1."""

    def __getattribute__(self, name):
        told = object.__getattribute__(self, "__dict__")
        if name == "expr":
            told["asked"] = told.get("asked", 0) + 1
            return told["expr"] if told["asked"] > 1 else S.NegativeOne
        return object.__getattribute__(self, name)


class Anything(And):
    """Says of itself that it is equal to everything."""

    def __eq__(self, other):
        return True

    __hash__ = And.__hash__


class Count(int):
    """Says that its double is more."""

    def __rmul__(self, other):
        return 10


class Unknown(AppliedUndef):
    """An unknown function that knows something of itself."""


class Number(sp.Integer):
    """A number of its own."""


@pytest.mark.parametrize(
    "made",
    [
        lambda: on_box(Changing(S.One, {x: (S.Zero, S.One)}, ".", 96)),
        lambda: disch(assume(FALSE), Anything(())),
        lambda: assume(Or((Anything(()), FALSE))),
        lambda: assume(ForAll((x,), Anything(()))),
        lambda: first_minors(assume(Predicate("stable", (z,), (z + x,))), Count(1)),
        lambda: identity(Unknown(x), Unknown(x)),
        lambda: identity(Number(5), S(5)),
        lambda: identity(sp.Add(x, Number(5), evaluate=False), x + 5),
    ],
)
def test_a_class_of_ones_own_says_nothing_to_a_rule(made):
    for known in (S(5), x + 5):  # what is equal was read before
        identity(known, known)
    with pytest.raises((NotShown, NoTerm)):
        made()
