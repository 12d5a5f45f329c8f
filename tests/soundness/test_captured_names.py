"""A symbol that a rule binds stands for nothing else, and what limits a term is not dropped."""

from collections.abc import Iterator

import pytest
import sympy as sp
from sympy import I, Rational, S, exp, pi

from symhaptic.notation import X, s, z
from symhaptic.notation.proposition import FALSE, Exists, ForAll, Not, Predicate, Relation
from symhaptic.notation.terms import NoTerm
from symhaptic.proof.theorems.analysis import in_the_limit
from symhaptic.proof.theorems.axioms import known
from symhaptic.proof.theorems.axioms import x as axiom_x
from symhaptic.proof.theorems.definitions import loop, loop_substituted
from symhaptic.proof.theorems.energy import toeplitz
from symhaptic.proof.theorems.kernel import (
    NotShown,
    Theorem,
    add_assum,
    assume,
    contr,
    disch,
    exists,
    gen,
    inst,
    mp,
    not_intro,
    spec,
    subst,
    undisch,
)
from symhaptic.proof.theorems.leaves import (
    combined,
    identity,
    is_whole,
    number,
    root_outside,
    tends,
)
from symhaptic.proof.theorems.roots import (
    all_inside,
    degree,
    hurwitz,
    jury,
    none_enters,
    roots_stay,
)
from symhaptic.proof.theorems.samples import held_answer
from symhaptic.proof.theorems.tactics import reductio

v, q, t, x, y, w = sp.symbols("v q t x y w")


def zero_at(place: sp.Expr) -> Theorem:
    """-1 < place < 1 |- all zeros of z - place lie inside."""
    return undisch(spec(known("linear"), {axiom_x: place}))


def test_a_product_does_not_capture() -> None:
    # z - 3v has its zero inside for v = 0; in v it would be -2v, and z - v^2 + 2 a wrong polynomial
    for place in (v, 3 * v, v**2 - 2):
        with pytest.raises(NotShown, match="is about"):
            all_inside(v, 0, zero_at(place))
    assert all_inside(w, 0, zero_at(3 * v)).conclusion.terms == (w - 3 * v,)


def never(*claims: sp.Expr) -> list[Theorem]:
    """That these are not zero, from what knows of neither q nor t."""
    some = (Relation(claim, "!=", S.Zero) for claim in claims)
    return [spec(assume(ForAll((q, t), claim)), {q: q, t: t}) for claim in some]


def test_a_path_does_not_capture() -> None:
    # z - v at z = v^2, or z times it, would be v^2 - v; v^2 - v - 1 has a zero outside, v = 1.6
    f, g = v**2 - v, S.NegativeOne
    circle, right = exp(2 * I * t) - exp(I * t) - q, -exp(2 * t) - I * exp(t) - q
    inside = all_inside(z, 1, zero_at(v))
    with pytest.raises(NotShown, match="is about"):
        roots_stay(f, g, v, q, t, *never(circle, -q), inside)
    with pytest.raises(NotShown, match="is about"):
        none_enters(zero_at(v), g, (v, q, t, x, y), *never(circle, -q, right))


def test_a_path_begins_where_all_zeros_are_shown_to_lie_inside() -> None:
    """z - 3 + y has no zero on the circle, and z none outside, but z - 2 is not z + y."""
    outside = never(exp(I * t) - 3 + q, q - 2)
    halves = (z - 1) * (z - Rational(1, 2))
    level = never(exp(I * t) ** 2 - 3 * exp(I * t) / 2 + S.Half + q, q)
    for f, path, at in ((z - 3, outside, S.Zero), (halves, level, S.Half), (halves, level, S.Zero)):
        with pytest.raises(NotShown, match="is not where the path begins"):
            roots_stay(f, S.One, z, q, t, *path, zero_at(at))


@pytest.mark.parametrize(
    ("device", "answer"),
    [((1 + s, 2 - s, 0), X), ((1, s, -s), X), ((2 + s, 1, -s), X)],
)
def test_a_response_does_not_capture(device: tuple[sp.Expr, ...], answer: sp.Expr) -> None:
    # of m = 1 + s and b = 2 - s the sum does not know s
    with pytest.raises(NotShown, match="bound"):
        held_answer(device, (0, 0), s, z, answer, [1, 0, 0, 1, 0, 0], t)


def test_a_device_does_not_change_where_its_sum_stays() -> None:
    with pytest.raises(NotShown, match="changes with t"):
        held_answer((1 + t, 1 - t, 0), (0, 0), s, z, X, [1, 0, 0, 1, 0, 0], t)


@pytest.mark.parametrize("values", [(10 * z, 0, 1, 1, 0), (0, z, 1, 1, 0), (0, 0, 1, 1, z)])
def test_a_loop_of_z_is_not_one_of_its_bound_symbol(values: tuple[sp.Expr, ...]) -> None:
    # stable_loop(0, ...) would be what 10 w for alpha says, for z = 0
    for made in (lambda: loop(values, w), lambda: loop_substituted(values, w, 2)):
        with pytest.raises(NotShown, match="is bound"):
            made()


def test_what_a_predicate_binds_is_not_the_symbol_of_that_name() -> None:
    # all zeros of x lie inside, and that says nothing of the x in 1/x
    inside = Predicate("stable", (x,), (x,))
    claim = gen(disch(add_assum(identity(x, x), inside), inside), x)
    assert spec(claim, {x: 1 / y}).hypotheses == {Relation(y, "!=", S.Zero)}


CANCELS = (x**2 - 1) / (4 * (x - 1))
"""(x + 1)/4 but for x = 1, where it has no value; a polynomial with it has no zeros there."""


def test_a_polynomial_without_a_value_is_not_stable() -> None:
    limit = Relation(4 * x - 4, "!=", S.Zero)
    assert limit in jury(z - CANCELS, z).hypotheses
    assert limit in hurwitz(s + CANCELS, s).hypotheses


EXPANDS = w * (1 + 1 / w)
"""w + 1 for SymPy, once it is multiplied out, but without a value for w = 0."""


def test_what_is_multiplied_out_keeps_its_divisors() -> None:
    limit = Relation(w, "!=", S.Zero)
    assert limit in toeplitz(EXPANDS + 1 / z, z, 5, t).hypotheses
    assert limit in degree(z + EXPANDS, z, 1).hypotheses
    path = never(exp(I * t) + q * (w + 1), 1 + q * (w + 1))
    assert limit in roots_stay(z, EXPANDS, z, q, t, *path, zero_at(S.Zero)).hypotheses


def unlike(claim: sp.Expr) -> Theorem:
    """That a number is not zero."""
    return number(Relation(claim, "!=", S.Zero))


def test_a_path_is_along_a_symbol() -> None:
    # at the end of the path, at -1 and 1, z^2 + 4 is not zero; its zeros are 2j and -2j
    five = unlike(S(5))
    with pytest.raises(NotShown, match="is about"):
        roots_stay(z**2, S(4), z, S.One, pi, five, five, all_inside(z, 2))
    # v^2 - 4 is not zero at three places of the border; one of its zeros is 2
    spots = unlike(S(-5)), unlike(S(-3)), unlike(-exp(pi) - 4)
    with pytest.raises(NotShown, match="is about"):
        none_enters(all_inside(z, 1), S(-4), (v, S.One, pi / 2, x, y), *spots)


def test_an_end_of_an_interval_does_not_know_what_runs_through_it() -> None:
    # x - 1 is positive for 0 < x < x - 1, where there is no x at all, and tends to -1 at 0
    never = combined(Relation(S.Zero, "<", S.NegativeOne), [assume(x < x - 1)])
    empty = not_intro(never, number(Relation(S.NegativeOne, "<", S.Zero)))
    positive = add_assum(contr(empty, x > 1), x > 0)
    difference = positive.conclusion.terms[1] - positive.conclusion.terms[0]
    start = tends(difference, x, 0, -1)
    with pytest.raises(NoTerm, match="bound"):
        in_the_limit(positive, x, 0, x - 1, start)


def test_a_divisor_is_not_kept_by_a_bound_symbol_of_its_name() -> None:
    # 2 (x - w)/(x - w) + 1/y is 2 + 1/y, but for x = w; with w + y for x that y is not the bound y
    two = (2 * x - 2 * w) / (x - w)
    claim = Relation(two + 1 / y, "=", 2 + 1 / y)
    same = combined(Relation(two, "=", S(2)), [assume(claim)])
    nowhere = subst(
        Relation((2 * v - 2 * w) / (v - w), "=", S(2)), v, same, assume(Relation(x, "=", w))
    )
    assert nowhere.conclusion == FALSE
    denied = gen(reductio(nowhere, claim), y)
    assert denied.conclusion == ForAll((y,), Not((claim,)))
    found = inst(denied, {x: w + y})
    assert found.conclusion == ForAll((t,), Not((Relation(2 + 1 / t, "=", 2 + 1 / t),)))
    assert Relation(y, "!=", S.Zero) in found.hypotheses


def test_what_is_free_of_the_bound_symbol_goes_on() -> None:
    half = Rational(1, 2)
    found = all_inside(z, 1, zero_at(half))
    assert found.conclusion.terms == (z * (z - half),)
    assert jury(z - x / 4, z).hypotheses == frozenset()


@pytest.mark.parametrize("inner", [Exists, ForAll])
def test_a_bound_symbol_is_not_another_one(inner: type[Exists]) -> None:
    # for all x there is a y = 1, and not for all x a y with x = 1: both counted from 0
    one, other = (ForAll((x,), inner((y,), Relation(s, "=", S.One))) for s in (y, x))
    assert one != other
    assert one == ForAll((v,), inner((w,), Relation(w, "=", S.One)))
    shown = gen(exists(identity(S.One, S.One), Exists((y,), Relation(y, "=", S.One)), {y: 1}), x)
    with pytest.raises(NotShown, match="is not what is implied from"):
        mp(disch(assume(other), other), shown)


def with_next_numbers(name: str | None = None) -> Iterator[sp.Dummy]:
    """Symbols with the numbers that SymPy gives to those that it makes next."""
    for ahead in range(8):
        count = sp.Dummy._count + ahead
        number_ = sp.Dummy._base_dummy_index + count
        yield sp.Dummy(name or f"Dummy_{count}", dummy_index=number_)


def test_a_symbol_with_a_number_by_hand_is_not_the_kernels_own() -> None:
    for own in with_next_numbers("x"):
        there = exists(identity(y, y), Exists((x,), Relation(x, "=", y)), {x: y})
        assert inst(there, {y: own + x}).conclusion.free == {own, x}
    for own in with_next_numbers():
        with pytest.raises(NotShown, match="not made of whole numbers"):
            is_whole(own, is_whole(S.One))
    for own in with_next_numbers():  # its zeros are not those of own^2/2 + own
        with pytest.raises(NotShown, match="no zero is shown to be outside"):
            root_outside(own**2 / 2 - sp.sqrt(2) / 10, own)
    for own in with_next_numbers("eps"):
        with pytest.raises(NotShown):
            tends(x + own, x, S.One, S.One)
