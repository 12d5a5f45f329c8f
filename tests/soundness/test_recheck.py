"""The second check says no to what is not a proof, whatever a certificate is made of."""

from dataclasses import fields, replace

import pytest
import sympy as sp
from flint import arb
from sympy import I, Rational, S, cos, oo, pi, sqrt, tan

from symhaptic import recheck
from symhaptic.notation import alpha, delta, gamma
from symhaptic.proof import box as boxes
from symhaptic.proof.box import NotShown
from symhaptic.proof.certificate import Known, Largest, Positive, Zero
from symhaptic.proof.plants import Named
from symhaptic.proof.roots import zero
from symhaptic.proof.theorems import kernel
from symhaptic.proof.theorems.leaves import on_plants

x, y, h = sp.symbols("x y h")
ENDS = [
    (0, oo),
    (-oo, oo),
    (0, sp.nan),
    (sp.zoo, 1),
    (0, 1 + I),
    (I, 2 * I),
    (1, 0),
    (sp.sqrt(2), sp.sqrt(2) - 1),
    (0, y),
    ("0", "1"),
    ("[print('EVALUATED'), 0][1]", 1),
    (0, None),
    (0, sp.acos(2)),
    (0, sp.Function("f")(1)),
]


@pytest.mark.parametrize("ends", ENDS, ids=str)
def test_ends_must_be_real_numbers_in_their_order(ends, capsys):
    assert not recheck(Positive(x**2 + 1, {x: ends}, ".", 96))
    assert not recheck(Positive(sp.Integer(1), {x: ends}, ".", 96))
    root = zero(cos(x), x, S.One, S(2))
    assert not recheck(replace(root, between=ends))
    assert capsys.readouterr().out == ""


def test_what_is_given_overrides_no_symbol_of_the_box():
    # x > 4 is false on [0, 1], whatever somebody knows of x
    known = Known({x: arb(5)})
    assert not recheck(Positive(x - 4, {x: (0, 1)}, ".", 96, known))
    with pytest.raises(NotShown, match="given a meaning as well"):
        boxes.positive(x - 4, {x: (0, 1)}, known)
    assert recheck(Positive(h - 4, {x: (0, 1)}, ".", 96, Known({h: arb(5)})))
    assert not recheck(Positive(h - 4, {x: (0, 1)}, ".", 96, Known({h: arb("inf")})))


class Numbers:
    """Numbers that stand for a symbol of the box behind its back."""

    of = (x,)
    meanings = {h: x + y}  # noqa: RUF012

    def numbers(self, at):
        return {x: at[x] + 5, y: at[x]}

    def __call__(self, at):
        return {h: at[x] + 5}


def test_numbers_override_no_symbol_of_the_box():
    assert not recheck(Positive(h - 4, {x: (0, 1)}, ".", 96, Numbers()))


@pytest.mark.parametrize("bits", [0, -1, 1, 10**12, 1.5, None])
def test_the_precision_must_be_one(bits):
    assert not recheck(Positive(x + 1, {x: (0, 1)}, ".", bits))


@pytest.mark.parametrize("expr", [1, "x + 1", None, [x], x > 0, sp.Function("f")(x), y + 1])
def test_what_is_no_formula_of_the_box_is_not_positive(expr):
    assert not recheck(Positive(expr, {x: (1, 2)}, ".", 96))


def test_a_zero_is_of_the_variable_that_is_free():
    root = zero(cos(x), x, S.One, S(2))
    assert recheck(root)
    assert not recheck(replace(root, at={x: S.One}))
    assert not recheck(Zero(x - 1 + y, y, (S.Zero, S(2)), root.ball, 256, {x: S.One, y: S.Zero}))


def test_a_zero_of_the_real_part_is_none():
    # sqrt(x - 1) + x - 2 is complex below 1
    expr = sqrt(x - 1) * (x - 2)
    assert not recheck(Zero(expr, x, (S.Zero, S(3)), arb("2 +/- 0.1"), 96))


def test_the_bounds_of_a_maximum_are_real_numbers():
    found = boxes.maximum(x * (1 - x), {x: (0, 1)}, Rational(1, 100))
    assert recheck(found)
    for wrong in (
        replace(found, lower=-oo),
        replace(found, lower=sp.nan),
        replace(found, lower=found.lower - I),
        replace(found, where={x: HALF + I}),
        replace(found, where={x: pi}),
        replace(found, upper=oo, below=replace(found.below, expr=oo - x)),
    ):
        assert not recheck(wrong)


def test_a_bound_is_a_number_and_what_it_bounds_is_defined():
    # tan has a pole at pi/2, and 1/x at 0; of tan x + 1 or 1/x + 1 there is 1 left
    for expr, ends in ((tan(x), (0, 2)), (1 / x, (-1, 1)), (x, (0, 1))):
        certain = Positive(S.One, {x: ends}, ".", 96)
        assert not recheck(Largest(expr, certain, {x: S.One}, S.Zero, expr + 1))


def test_what_is_given_is_computed_on_each_piece():
    # alpha < 1/2 is false on [-1, 1]; the lower half is looked at first, for the same device
    meant = Named({h: alpha})
    point = {gamma: (HALF, HALF), delta: (HALF, HALF)}
    wrong = Positive(HALF - h, {alpha: (-S.One, S.One), **point}, "0..", 96, meant)
    assert not recheck(wrong)
    with pytest.raises(kernel.NotShown):
        on_plants(wrong)
    with pytest.raises(NotShown):
        boxes.positive(HALF - h, wrong.box, meant)


HALF = Rational(1, 2)


def test_what_is_no_certificate_is_named():
    for nothing in (None, "Positive", {}, Largest):
        with pytest.raises(TypeError, match="is no certificate"):
            recheck(nothing)


def test_nothing_but_symbols_has_values():
    # with -2 for the number 1, x^2 + 1 would have the zero of x^2 - 2
    root = zero(x**2 - 2, x, S.One, S(2))
    assert recheck(root)
    assert not recheck(replace(root, expr=x**2 + 1, at={S.One: S(-2)}))
    assert not recheck(replace(root, expr=x**2 - 2, variable=x**2, between=(S.One, S(3))))
    assert not recheck(Zero(5 + sqrt(2), sqrt(2), (S(-6), S(-4)), arb("-5 +/- 1e-20"), 96))


@pytest.mark.parametrize("bits", [0, -5, "x", None, 10**12])
def test_no_zero_has_a_precision_beyond_reason(bits):
    assert not recheck(replace(zero(x**2 - 2, x, S.One, S(2)), bits=bits))


JUNK = [None, 1, 1.5, "x", b"x", [], (), {}, x, S.One, arb(1), object(), x > 0, sp.Matrix([1]), int]
JUNK += [{x: 1}, {x: (1,)}, {x: "12"}, {x: (0, int)}, (1, 2, 3), ("0", "1")]
ROOT = Zero(x - y, x, (0, 2), arb(1, 0.1), 96, {y: arb(1)})
LARGEST = Largest(x, Positive(2 - x, {x: (0, 1)}, ".", 96), {x: S.One}, S.One, S(2))


@pytest.mark.parametrize("of", [Positive(x, {x: (1, 2)}, ".", 96), ROOT, LARGEST])
def test_what_is_made_of_anything_shows_nothing(of):
    """In one answer, and never in an error that Python or SymPy tells."""
    assert recheck(of)
    for field in fields(of):
        for junk in JUNK:
            assert recheck(replace(of, **{field.name: junk})) in (True, False)
    for given in (Known, Named):
        for junk in JUNK:
            assert recheck(Positive(x, {x: (1, 2)}, ".", 96, given({y: junk}))) in (True, False)
