"""Terms are inert: no replacement, renaming or comparison of theirs evaluates anything."""

import pytest
import sympy as sp
from sympy import I, Rational, S

from symhaptic.notation.proposition import (
    FALSE,
    ForAll,
    Predicate,
    Proposition,
    Relation,
    both,
    whole,
)
from symhaptic.notation.terms import NoTerm, term, tree
from symhaptic.proof.theorems.analysis import induction
from symhaptic.proof.theorems.axioms import known
from symhaptic.proof.theorems.axioms import x as axiom_x
from symhaptic.proof.theorems.definedness import conditions, real
from symhaptic.proof.theorems.kernel import (
    NotShown,
    assume,
    disch,
    gen,
    inst,
    spec,
)
from symhaptic.proof.theorems.leaves import combined, identity, mirrored, tends
from symhaptic.proof.theorems.roots import first_minors
from symhaptic.proof.theorems.tactics import fact

x, y, n, m, z = sp.symbols("x y n m z")


@pytest.mark.parametrize("assumed", [{"positive": True}, {"real": True}, {"zero": True}])
def test_a_dummy_with_an_assumption_is_no_term(assumed: dict[str, bool]) -> None:
    # |p| is p at once for SymPy, so that 0 <= |p| would be 0 <= p, and that for all p
    p = sp.Dummy("p", **assumed)
    with pytest.raises(NoTerm, match="carries assumptions"):
        spec(known("Abs"), {axiom_x: p})
    with pytest.raises(NoTerm, match="carries assumptions"):
        term(sp.Function("f", **assumed)(x))
    assert term(sp.Dummy("p")).is_Symbol


def test_no_subclass_of_a_function_is_one() -> None:
    class twice(sp.exp):  # noqa: N801, a function
        pass

    with pytest.raises(NoTerm, match="no part of a term"):
        term(twice(x, evaluate=False))


LOST = [
    (sp.Mul(0, 1 / x, evaluate=False), 0),
    (sp.Mul(x, 1 / x, evaluate=False), 0),
    (sp.Add(1 / x, -1 / x, evaluate=False), 0),
    (sp.Pow(1 / x, 0, evaluate=False), 0),
    (sp.Pow(sp.Pow(x, -1), -1, evaluate=False), 0),
    (sp.Mul(0, sp.log(x), evaluate=False), 0),
    (sp.exp(sp.log(x), evaluate=False), 0),
    (sp.Mul(0, sp.cot(x), evaluate=False), 0),
    (sp.Mul(0, x**y, evaluate=False), 0),
    (y + sp.sin(sp.Mul(0, 1 / x, evaluate=False), evaluate=False), 0),
    # one part is written otherwise, and then meets a divisor beside it
    (sp.Mul(1 / x, sp.Add(x, 0, evaluate=False), evaluate=False), 0),
    (
        sp.Mul(
            1 / (x + y), sp.Add(y, sp.Mul(1, x, evaluate=False), evaluate=False), evaluate=False
        ),
        1,
    ),
    (sp.Mul(1 / sp.tan(x - y), sp.tan(y - x, evaluate=False), evaluate=False), -1),
    # the base of a power with an unknown exponent is no divisor
    (sp.Add(sp.Mul(1 / x, x, y, evaluate=False), x**y, evaluate=False), 0),
]
"""Terms that SymPy would write without a divisor, each with an x where it has no value, y = -1."""


@pytest.mark.parametrize(("lost", "at"), LOST)
def test_a_divisor_stays_whatever_sympy_would_make_of_it(lost: sp.Expr, at: int) -> None:
    claim = Relation(lost, "=", S.Zero)
    assert tree(tree(lost).shown) is tree(lost)
    # under a quantifier 0/x = 0, false at x = 0, would be equal to 0 = 0
    assert ForAll((x,), claim) != ForAll((m,), Relation(lost.xreplace({x: m}), "=", S.Zero))
    there = inst(assume(claim), {x: m})
    point = {m: S(at), y: S.NegativeOne}
    assert any(_false(h.at(point)) for h in there.hypotheses)


def _false(claim: Proposition) -> bool:
    """Whether a claim about numbers is false: a side has no value, or it says 0 != 0."""
    return claim == FALSE or (isinstance(claim, Relation) and claim.left == claim.right == 0)


def test_what_was_read_before_changes_nothing() -> None:
    """Twice ten is 20 in an answer, whoever has read 2*10 as it stands before."""
    tree(sp.Mul(2, 10, evaluate=False))
    tree(sp.Add(x, sp.Mul(2, 10, evaluate=False), evaluate=False))
    claim = Relation(x + m * y, "=", S.Zero)
    assert claim.at({m: S(2), y: S(10)}) == Relation(x + 20, "=", S.Zero)


SINE = sp.sin(x - y)
TURNED = sp.Mul((-SINE) ** Rational(3, 2), 1 / SINE)
"""SymPy writes sin(y - x) as -sin(x - y), by the alphabet, and this quotient as a root then."""


@pytest.mark.parametrize("name", ["a", "w", "xx", "y", "z_1"])
def test_a_bound_symbol_is_renamed_and_nothing_else_happens(name: str) -> None:
    """By comparing and by making way the quotient had lost its divisor."""
    v = sp.Symbol(name)
    claim = ForAll((y,), Relation(TURNED, "=", S.One))
    assert ForAll((v,), claim.body.inst({y: tree(v)})) == claim
    root = TURNED.xreplace({y: v})
    if not conditions(root):
        assert ForAll((v,), Relation(root, "=", S.One)) != claim
    # x becomes v: the bound symbol gives way, and the divisor stays or the rule refuses
    try:
        moved = spec(assume(ForAll((x,), claim)), {x: v}).conclusion
    except NotShown:
        return
    assert conditions(moved.body.left)


def test_a_symbolic_degree_is_a_whole_number() -> None:
    """stable(z; z^(m+1)) with m = -1 has no zero, and its first minor is 0."""
    inside = assume(Predicate("stable", (z,), (z ** (m + 1),)))
    shown = first_minors(inside, 1)
    assert {whole(m), whole(m + 1)} <= shown.hypotheses
    there = inst(shown, {m: -S.One})
    assert whole(-S.One) in there.hypotheses
    with pytest.raises(NotShown):
        fact(whole(-S.One))


def test_sums_and_products_have_no_order_and_no_brackets() -> None:
    one = sp.Add(x, sp.Add(y, m, evaluate=False), evaluate=False)
    assert tree(one) is tree(m + y + x)
    assert tree(sp.Mul(x, sp.Mul(y, m, evaluate=False), evaluate=False)) is tree(m * x * y)
    assert tree(sp.Add(x, x, evaluate=False)) is not tree(2 * x)
    assert tree(sp.Mul(2, x + y, evaluate=False)) is not tree(2 * x + 2 * y)


def test_a_bound_symbol_is_known_by_its_place() -> None:
    assert ForAll((x, y), Relation(x, "<", y)) == ForAll((y, x), Relation(y, "<", x))
    assert ForAll((x, y), Relation(x, "<", y)) != ForAll((x, y), Relation(y, "<", x))
    nested = ForAll((x,), ForAll((y,), Relation(x, "<", y)))
    assert nested == ForAll((y,), ForAll((x,), Relation(y, "<", x)))
    assert nested != ForAll((x,), ForAll((x,), Relation(x, "<", x)))
    # an unknown function of nothing is none of the places
    odd = sp.Function("bound 0")()
    assert ForAll((x,), Relation(x, "=", odd)) != ForAll((x,), Relation(x, "=", x))


def test_a_step_of_an_induction_keeps_its_divisors() -> None:
    # (2n - 2)/(n - 1) = 2 is false at n = 1, where it divides by zero; of n + 1 SymPy says 2 = 2
    claim = Relation((2 * n - 2) / (n - 1), "=", S(2))
    step = disch(identity(2, 2), both([whole(n), claim]))
    with pytest.raises(NotShown, match="a divisor of"):
        induction(claim, n, identity(2, 2), step)
    kept = Relation(2 * n + m, "=", m + n + n)
    step = disch(identity(*(kept.at({n: n + 1}).terms)), both([whole(n), kept]))
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
)
def test_what_is_not_real_everywhere_is_not_real_by_its_form(expr: sp.Expr) -> None:
    assert not real(expr)
    with pytest.raises(NotShown, match="not real by its form"):
        spec(known("square"), {axiom_x: expr})


@pytest.mark.parametrize("side", [IMAGINARY, sp.Abs(sp.log(x) + I)])
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
        gen(assume(Relation(other, "=", S.One)), other)
    with pytest.raises(NoTerm, match="carries assumptions"):
        ForAll((sp.Symbol("x", real=True),), Relation(x, "=", x))


def test_a_power_of_zero_may_have_a_value_where_a_divisor_has_none() -> None:
    # at x = 0 and y = 1 the power x^y is 0, and 1/x has no value
    given = assume(Relation(S.Zero, "<=", x**y))
    divided = sp.Mul(x ** (y + 1), 1 / x, evaluate=False)
    found = combined(Relation(S.Zero, "<=", divided), [given])
    assert Relation(x, "!=", S.Zero) in found.hypotheses
    # neither is it lost where a divisor becomes the base of such a power
    beside = Relation(S.Zero, "<=", x**y + m / n)
    moved = inst(assume(beside), {n: x, m: S.Zero})
    assert moved.conclusion == Relation(S.Zero, "<=", x**y)
    assert Relation(x, "!=", S.Zero) in moved.hypotheses
    # a power that stays as it is keeps what it had
    kept = inst(assume(Relation(S.Zero, "<=", x**y + m)), {m: n})
    assert kept.hypotheses == {Relation(S.Zero, "<=", x**y + n)}


def test_no_power_of_a_bound_symbol_is_lost() -> None:
    # for all x: 0 <= x^m + x^n is false at x = 0 for n < 0
    claim = ForAll((x,), Relation(S.Zero, "<=", x**m + y * x**n))
    with pytest.raises(NotShown, match="lost under its quantifier"):
        inst(assume(claim), {y: S.Zero})


def test_no_branch_is_found_by_decimals() -> None:
    # SymPy does not see that b = -2: of the root of b^-3, 0.35 j, it made -b^(-3/2), -0.35 j
    b = -2 + sp.I * (sp.sin(1) ** 2 + sp.cos(1) ** 2 - 1)
    root = sp.Pow(sp.Pow(x, -3), sp.S.Half, evaluate=False)
    with pytest.raises(NoTerm, match="by decimals"):
        inst(identity(root, root), {x: b})
    assert inst(identity(root, root), {x: sp.Integer(-2)}).conclusion.free == frozenset()
    inverse = sp.Pow(1 / sp.tan(2), sp.S.Half, evaluate=False)  # in exponentials, not seen either
    with pytest.raises(NotShown, match="by decimals"):
        tends(inverse + 5 + x, x, 0, inverse + 5)
