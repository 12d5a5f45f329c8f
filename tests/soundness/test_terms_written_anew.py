"""SymPy evaluates a term whenever symbols in it are replaced; nothing may be gained by that."""

import copy

import pytest
import sympy as sp
from sympy import I, Rational, S

from symhaptic.notation.proposition import ForAll, Relation, both, whole
from symhaptic.notation.terms import PLACES, NoTerm, term
from symhaptic.proof.theorems.analysis import induction
from symhaptic.proof.theorems.axioms import known
from symhaptic.proof.theorems.axioms import x as axiom_x
from symhaptic.proof.theorems.definedness import real
from symhaptic.proof.theorems.derivation import replayed
from symhaptic.proof.theorems.kernel import (
    NotShown,
    assume,
    discharged,
    general,
    instance,
    part,
    placed,
)
from symhaptic.proof.theorems.leaves import combined, identity, mirrored, number

x, y, n, m = sp.symbols("x y n m")


@pytest.mark.parametrize("assumed", [{"positive": True}, {"real": True}, {"zero": True}])
def test_a_dummy_with_an_assumption_is_no_term(assumed: dict[str, bool]) -> None:
    # |p| is p at once for SymPy, so that 0 <= |p| would be 0 <= p, and that for all p
    p = sp.Dummy("p", **assumed)
    with pytest.raises(NoTerm, match="carries assumptions"):
        instance(known("Abs"), {axiom_x: p})
    with pytest.raises(NoTerm, match="carries assumptions"):
        term(sp.Function("f", **assumed)(x))
    assert term(sp.Dummy("p")).is_Symbol


def test_no_subclass_of_a_function_is_one() -> None:
    class twice(sp.exp):  # noqa: N801, a function
        def fdiff(self, argindex: int = 1) -> sp.Expr:
            return S(7)

    with pytest.raises(NoTerm, match="no part of a term"):
        term(twice(x, evaluate=False))


def test_the_places_of_bound_symbols_are_no_symbols() -> None:
    # for all x: x = bound_0 would be equal to for all x: x = x
    place = PLACES[0]
    true = general(identity(x, x), x)
    with pytest.raises(NoTerm, match="stands for bound ones"):
        part(true, ForAll((x,), Relation(x, "=", place)))


@pytest.mark.parametrize(
    "lost",
    [
        sp.Mul(0, 1 / x, evaluate=False),
        sp.Mul(x, 1 / x, evaluate=False),
        sp.Add(1 / x, -1 / x, evaluate=False),
        sp.Pow(1 / x, 0, evaluate=False),
        sp.Pow(sp.Pow(x, -1), -1, evaluate=False),
        sp.Mul(0, sp.log(x), evaluate=False),
        sp.exp(sp.log(x), evaluate=False),
        sp.Mul(0, sp.tan(x), evaluate=False),
        sp.Mul(0, x**y, evaluate=False),
        y + sp.sin(sp.Mul(0, 1 / x, evaluate=False), evaluate=False),
        # one part is written otherwise, and then meets a divisor beside it
        sp.Mul(1 / x, sp.Add(x, 0, evaluate=False), evaluate=False),
        sp.Mul(
            1 / (x + y), sp.Add(y, sp.Mul(1, x, evaluate=False), evaluate=False), evaluate=False
        ),
        sp.Mul(1 / sp.tan(x - y), sp.tan(y - x, evaluate=False), evaluate=False),
    ],
    ids=str,
)
def test_what_is_lost_when_sympy_writes_it_anew_is_no_term(lost: sp.Expr) -> None:
    # under a quantifier 0/x = 0, false at x = 0, would be equal to 0 = 0
    with pytest.raises(NoTerm, match="loses a divisor"):
        ForAll((x,), Relation(lost, "=", S.Zero))


def test_what_is_only_written_otherwise_is_a_term() -> None:
    for kept in (
        sp.Pow(sp.Mul(2, x + 1, evaluate=False), -1, evaluate=False),
        sp.factor(1 / (2 * x + 2 * y) ** 2),
        (x - y) ** -2 + sp.tan(y - x),
        sp.Pow(x * y, -1, evaluate=False),
        sp.Mul(2, x + 1, evaluate=False) / (y + 1),
    ):
        assert term(kept) == kept


def test_a_step_of_an_induction_keeps_its_divisors() -> None:
    # (2n - 2)/(n - 1) = 2 is false at n = 1, where it divides by zero; of n + 1 SymPy says 2 = 2
    claim = Relation((2 * n - 2) / (n - 1), "=", S(2))
    step = discharged(identity(2, 2), both([whole(n), claim]))
    with pytest.raises(NotShown, match="a divisor of"):
        induction(claim, n, identity(2, 2), step)
    kept = Relation(2 * n + m, "=", m + n + n)
    step = discharged(identity(*(kept.at({n: n + 1}).terms)), both([whole(n), kept]))
    assert induction(kept, n, identity(m, m), step).conclusion == kept


IMAGINARY = sp.im(sp.exp(I * x), evaluate=False)
"""sin x; of exp(-j x) it is -sin x."""


@pytest.mark.parametrize(
    "expr",
    [
        I * IMAGINARY,  # j sin x
        # on the cut of atan, at x = 0, neither is the conjugate of the other
        sp.atan(x + 2 * I) * sp.atan(x - 2 * I),
        I * sp.Abs(sp.log(x) + I) - I * sp.Abs(sp.log(x) - I),  # at x = -1: j (pi + 1) - j (pi - 1)
    ],
    ids=str,
)
def test_what_is_not_real_everywhere_is_not_real_by_its_form(expr: sp.Expr) -> None:
    assert not real(expr)
    with pytest.raises(NotShown, match="not real by its form"):
        instance(known("square"), {axiom_x: expr})


@pytest.mark.parametrize("side", [IMAGINARY, sp.Abs(sp.log(x) + I)], ids=str)
def test_no_conjugate_where_j_stands_in_what_is_real(side: sp.Expr) -> None:
    # im exp(j x) = sin x, but im exp(-j x) = -sin x
    with pytest.raises(NotShown, match="conjugate"):
        mirrored(identity(side, side))


def test_real_by_their_form() -> None:
    for expr in (
        sp.Abs(x + I),
        sp.atan(x / 3),
        sp.re(sp.log(x + 1) * sp.log(x)),
        Rational(1, 3) ** x,
    ):
        assert real(expr)
    assert mirrored(identity(sp.Abs(sp.exp(I * x)), sp.Abs(sp.exp(I * x))))


def test_what_is_bound_is_a_symbol() -> None:
    # for all g(u): g(u) = 1 would be equal to for all y: y = 1
    other = sp.Function("g")(x)
    for wrong in (other, x**2, S.One):
        with pytest.raises(NoTerm, match="no symbol that could be bound"):
            ForAll((wrong,), Relation(wrong, "=", S.One))
    with pytest.raises(NotShown, match="is about"):
        general(assume(Relation(other, "=", S.One)), other)
    with pytest.raises(NoTerm, match="carries assumptions"):
        ForAll((sp.Symbol("x", real=True),), Relation(x, "=", x))


def test_what_is_kept_of_a_proposition_does_not_travel() -> None:
    # its hash says where it is looked for, its free symbols what it is about
    claim, true = Relation(x, "<", y), Relation(S.Zero, "<", S.One)
    claim.__dict__["_hash"] = hash(true)
    with pytest.raises(NotShown, match="is no part of"):
        part(number(true), claim)
    about = Relation(x, "<", S.Zero)
    about.__dict__["free"] = frozenset()
    with pytest.raises(NotShown, match="is about x"):
        replayed(general(assume(about), x))
    assert hash(copy.deepcopy(claim)) != hash(true)
    with pytest.raises(NoTerm, match="does not change"):
        claim.__setstate__({"left": S.One})


def test_a_power_of_zero_may_have_a_value_where_a_divisor_has_none() -> None:
    # at x = 0 and y = 1 the power x^y is 0, and 1/x has no value
    given = assume(Relation(S.Zero, "<=", x**y))
    divided = sp.Mul(x ** (y + 1), 1 / x, evaluate=False)
    found = combined(Relation(S.Zero, "<=", divided), [given])
    assert Relation(x, "!=", S.Zero) in found.hypotheses
    # neither is it lost where a divisor becomes the base of such a power
    beside = Relation(S.Zero, "<=", x**y + m / n)
    moved = placed(assume(beside), {n: x, m: S.Zero})
    assert moved.conclusion == Relation(S.Zero, "<=", x**y)
    assert Relation(x, "!=", S.Zero) in moved.hypotheses
    # a power that stays as it is keeps what it had
    kept = placed(assume(Relation(S.Zero, "<=", x**y + m)), {m: n})
    assert kept.hypotheses == {Relation(S.Zero, "<=", x**y + n)}


def test_no_power_of_a_bound_symbol_is_lost() -> None:
    # for all x: 0 <= x^m + x^n is false at x = 0 for n < 0
    claim = ForAll((x,), Relation(S.Zero, "<=", x**m + y * x**n))
    with pytest.raises(NotShown, match="lost under its quantifier"):
        placed(assume(claim), {y: S.Zero})
