"""The second check says no to what is not a proof, whatever a certificate is made of."""

from dataclasses import fields, replace
from numbers import Number

import pytest
import sympy as sp
from flint import acb, arb
from sympy import I, Rational, S, cos, oo, pi, sqrt, tan

from symhaptic import recheck
from symhaptic.notation import alpha, delta, gamma
from symhaptic.proof import box as boxes
from symhaptic.proof.box import NotShown
from symhaptic.proof.certificate import Known, Largest, Positive, Zero
from symhaptic.proof.plants import Named
from symhaptic.proof.roots import zero
from symhaptic.proof.theorems import kernel
from symhaptic.proof.theorems.leaves import on_box, on_plants

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


class Shifting(Number):
    """A number that is 1 the first time, and 0 afterwards."""

    asked = 0

    def _sympy_(self):
        self.asked += 1
        return S(int(self.asked == 1))

    __hash__ = object.__hash__


class Five(sp.Expr):
    """What says that it is the number 5."""

    is_Rational, p, q = True, 5, 1  # noqa: N815


class Everything(sp.Symbol):
    """A symbol that is equal to x."""

    def __eq__(self, other):
        return isinstance(other, sp.Symbol)

    def __hash__(self):
        return hash(x)


class Elsewhere(arb):
    """A ball that lies elsewhere when its ends are asked for."""

    def lower(self):
        return arb("1.5")

    def upper(self):
        return arb("1.6")


class Wide(int):
    """A precision that is in every range."""

    def __ge__(self, other):
        return True

    __le__ = __ge__


class Split(str):
    """Cuts whose signs are numbers of symbols that there are not."""

    def __iter__(self):
        return iter([Split("0"), ".", "."])

    def isdecimal(self):
        return True

    def __int__(self):
        return -1


class Like(Positive):
    """A certificate of a class of one's own."""


class Meant:
    """Meanings of a class of one's own, which has a number for everything."""

    of, meanings = (), {h: y}

    def numbers(self, at):
        return {y: acb(5)}


COSINE_ROOT = zero(cos(x), x, S.One, S(2))
SPOKEN = {
    "an end": Positive(x - HALF, {x: (Shifting(), S(2))}, ".", 96),
    "a number": Positive(Five(), {x: (0, 1)}, ".", 96),
    "a number in a sum": Positive(x + Five(), {x: (0, 1)}, ".", 96),
    "a side": Positive(x - HALF, {x: (1, 2)}, ".", 96, None, (Five(),)),
    "a symbol of the box": Positive(x - HALF, {Everything("y"): (1, 2)}, ".", 96),
    "a symbol": Positive(Everything("y") - HALF, {x: (1, 2)}, ".", 96),
    "cuts": Positive(x, {x: (1, 2)}, Split("0.."), 96),
    "a precision": Positive(x, {x: (1, 2)}, ".", Wide(-5)),
    "what is given": Positive(h - 4, {x: (0, 1)}, ".", 96, Meant()),
    "a ball that is given": Positive(h - 1, {x: (0, 1)}, ".", 96, Known({h: Elsewhere(3)})),
    "a ball": replace(COSINE_ROOT, ball=Elsewhere(5)),
    "a precision of a zero": replace(COSINE_ROOT, bits=Wide(-5)),
    "an upper bound": replace(LARGEST, where={x: Shifting()}),
}


@pytest.mark.parametrize("name", SPOKEN)
def test_no_class_of_ones_own_speaks_for_itself(name):
    assert not recheck(SPOKEN[name])


def test_an_end_that_changes_is_no_end_of_a_theorem():
    """0 <= x <= 2 would give 0 < x - 1/2, which is false at 1/4."""
    with pytest.raises(kernel.NotShown):
        on_box(Positive(x - HALF, {x: (Shifting(), S(2))}, ".", 96))


def test_a_certificate_of_a_class_of_ones_own_is_none():
    with pytest.raises(TypeError, match="is no certificate"):
        recheck(Like(x, {x: (1, 2)}, ".", 96))


def test_next_to_a_pole_of_the_cotangent_no_zero_is_shown():
    assert not recheck(Zero(sp.cot(x), x, (-S.One, S.One), arb("0 +/- 0.5"), 96))
