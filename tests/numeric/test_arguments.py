"""What the numeric functions take for numbers, and the one line with which they refuse the rest."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy

from symhaptic import (
    characteristic_polynomial,
    delay_margin,
    discretize,
    grid_boundary,
    is_stable,
    limit_at,
    linear_limit,
    max_delay,
    max_stable_stiffness,
    passivity_boundary,
    robust_region,
    stability_boundary,
    stable_region,
    unstable_roots,
)
from symhaptic.numeric import arguments, compiled

FUNCTIONS = {
    is_stable: ("alpha", "beta", "gamma", "delta", "delay"),
    unstable_roots: ("alpha", "beta", "gamma", "delta", "delay"),
    characteristic_polynomial: ("alpha", "beta", "gamma", "delta", "delay"),
    stability_boundary: ("theta", "gamma", "delta", "delay"),
    max_stable_stiffness: ("gamma", "delta", "delay"),
    limit_at: ("beta", "gamma", "delta", "delay"),
    stable_region: ("gamma", "delta", "delay"),
    delay_margin: ("alpha", "beta", "gamma", "delta", "delay"),
    max_delay: ("alpha", "beta", "gamma", "delta"),
    discretize: ("gamma", "delta"),
}
GIVEN = {"alpha": 0.1, "beta": 0.2, "gamma": 0.3, "delta": 0.4, "delay": 1, "theta": 1.0}
PLACES = [(f, name) for f, names in FUNCTIONS.items() for name in names]
NO_NUMBERS = [1j, np.array([1j]), np.array([[1 + 1j, 2]] * 9), "1.0", b"1", None, [0.1, None],
              [[1, 2], [3]], {}, object(), np.datetime64("2020-01-01"), 10**400,
              10**5000]  # fmt: skip


@pytest.mark.parametrize(("function", "name"), PLACES, ids=lambda v: getattr(v, "__name__", v))
def test_what_is_no_real_number_is_named_on_one_line(function, name):
    for bad in NO_NUMBERS:
        given = [bad if n == name else GIVEN[n] for n in FUNCTIONS[function]]
        with pytest.raises(ValueError, match=f"^{name}: ") as caught:
            function(*given)
        text = str(caught.value)
        assert text.endswith("is not allowed; give real numbers")
        assert "\n" not in text
        assert len(text) < 140


@pytest.mark.parametrize("bad", [None, "1", (1, "a"), {}, 10**400])
def test_what_is_asked_for_beside_a_plant_is_named_too(bad):
    for name, call in {
        "tolerance": lambda: stable_region(0.0, 0.4, 1, tolerance=bad),
        "tolerance: ": lambda: robust_region(0.4, 1, tolerance=bad),
        "threshold": lambda: grid_boundary(0.0, 0.4, 1, [0, 1], [0, 1], threshold=bad),
        "delta": lambda: robust_region(bad, 1),
        "delay": lambda: robust_region(0.4, bad),
    }.items():
        with pytest.raises(ValueError, match=f"^{name}.* is not allowed; give real numbers$"):
            call()


@pytest.mark.parametrize("several", [[], [0.1, 0.2]])
def test_of_a_region_and_its_tolerance_there_is_one(several):
    for name, call in {
        "tolerance": lambda: stable_region(0.0, 0.4, 1, tolerance=several),
        "delta": lambda: robust_region(several, 1),
        "delay": lambda: robust_region(0.4, several),
    }.items():
        with pytest.raises(ValueError, match=rf"^{name}: .* is not allowed; give one number$"):
            call()
    with pytest.raises(ValueError, match=r"^delay: .* is not allowed; give at most 100 periods"):
        robust_region(0.4, 1e15)


@pytest.mark.parametrize("number", [
    1, True, np.float32(1), np.int8(1), np.float64(1), np.array(1), Fraction(1), Decimal(1),
    sympy.Integer(1), sympy.Float(1), [1], np.array([1], dtype=object), np.float16(1),
])  # fmt: skip
def test_every_kind_of_real_number_is_taken(number):
    for function, names in FUNCTIONS.items():
        if function in (characteristic_polynomial, stable_region) and np.ndim(number):
            continue  # one number only
        plain = [GIVEN[n] if n != "gamma" else 1.0 for n in names]
        given = [GIVEN[n] if n != "gamma" else number for n in names]
        if function is stable_region:
            assert function(*given).area == function(*plain).area
        else:
            assert np.array_equal(np.ravel(function(*given)), np.ravel(function(*plain)))


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: is_stable(2e70, 0, 0, 0, 0), r"alpha: 2e\+70 .*; give numbers up to 1e\+70"),
        (lambda: discretize(2e15, 0), r"gamma: 2\S+ .*; give numbers 0 <= gamma <= 1e\+15"),
        (lambda: discretize(0, 2e70), r"delta: 2e\+70 .*; give numbers 0 <= delta <= 1e\+70"),
        (lambda: is_stable(0, 0, 0, 0, 2e15), r"delay: 2\S+ .* 0 <= delay <= 1e\+15"),
        (lambda: stable_region([0.0, 1.0], 0, 0), r"gamma: array.*; give one number"),
        (lambda: stable_region(np.nan, 0, 0), "gamma: nan .*; give finite numbers gamma >= 0"),
        (lambda: characteristic_polynomial(0, 0, 0, 0, 0.5), "delay: 0.5 .*; give whole"),
        (lambda: characteristic_polynomial([1, 2], 0, 0, 0, 0), "alpha: .*; give one number"),
    ],
)  # fmt: skip
def test_a_number_that_is_too_large_or_not_alone_is_named(call, says):
    with pytest.raises(ValueError, match=f"^{says}"):
        call()


BLOCK = arguments._BLOCK
SHAPES = [(), (1,), (0,), (3,), (BLOCK - 1,), (BLOCK,), (BLOCK + 1,), (2, BLOCK), (3, 1)]


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("other", [(), (1,), (1, 1)], ids=str)
def test_pieces_are_put_together_in_the_order_of_the_elements(shape, other):
    many = np.arange(float(np.prod(shape, dtype=int))).reshape(shape)
    scale = np.full(other, 3.0)
    rows = arguments.in_blocks(lambda a, b: (a * b, a + b, b), many, scale)
    together = np.broadcast_shapes(shape, other)
    assert rows.shape == (3, *together)
    assert np.array_equal(rows[0], np.broadcast_to(many * scale, together))
    assert np.array_equal(rows[1], many + scale)
    assert np.all(rows[2] == 3.0)


def test_any_layout_in_memory():
    rng = np.random.default_rng(71)
    alpha, beta = rng.normal(size=(2, 130, 150))
    expected = unstable_roots(alpha, beta, 0.3, 0.4, 2)
    for other in (np.asfortranarray(alpha), alpha[::-1][::-1], alpha.astype(">f8")):
        other.flags.writeable = False
        assert np.array_equal(unstable_roots(other, beta, 0.3, 0.4, 2), expected)
    assert np.array_equal(unstable_roots(alpha.T, beta.T, 0.3, 0.4, 2), expected.T)
    thin = unstable_roots(alpha[::3, ::-2], beta[::3, ::-2], 0.3, 0.4, 2)
    assert np.array_equal(thin, expected[::3, ::-2])
    rows = unstable_roots(alpha, beta, np.full((130, 1), 0.3), 0.4, np.full(150, 2))
    assert np.array_equal(rows, expected)


def test_what_is_finite_and_what_is_told():
    for one, is_finite, is_told in (
        (0.1, True, True), (1.7e308, True, True), (np.inf, False, True), (np.nan, False, False),
    ):  # fmt: skip
        for value in (one, np.array([0.1, one, -0.2]), np.array([[-0.1], [-one]])):
            assert compiled.finite(value) == is_finite
            assert compiled.told(value) == is_told


def test_numbers_give_numbers():
    """As NumPy's own functions do, whether compiled or not; not arrays without axes."""
    for found in (
        linear_limit(0.1, 0.02, 1),
        is_stable(0.1, 0.4, 0.0, 0.02, 1),
        delay_margin(0.01, 0.05, 0.0, 0.0),
        *discretize(0.1, 0.2),
        *max_stable_stiffness(0.0, 0.02, 1),
        *passivity_boundary(0.5, 1.0, 1),
    ):
        assert isinstance(found, np.generic)
        assert found.shape == ()
