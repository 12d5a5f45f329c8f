"""Public functions on arrays of every library: of its kind, and with NumPy's numbers."""

import numpy as np
import pytest
from kernels.test_array_libraries import MAKE, jax_numpy
from scipy.linalg import expm

import symhaptic


def roots_outside(alpha, beta, gamma, delta, delay):
    """By numpy.roots of the polynomial, whose device is a matrix exponential."""
    m = expm(np.array([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]))
    a, e = m[0, 0] + m[1, 1], m[0, 0] * m[1, 1] - m[0, 1] * m[1, 0]
    n1 = m[0, 2]
    n0 = m[0, 1] * m[1, 2] - m[1, 1] * m[0, 2]
    p = np.concatenate([[1, -a, e], np.zeros(delay + 1)])
    p[-3:] += np.convolve([n1, n0], [alpha + beta, -beta])
    return int((np.abs(np.roots(p)) > 1).sum())


JAX = pytest.param("jax", marks=pytest.mark.slow)
"""It compiles each function."""


@pytest.mark.parametrize("library", ["numpy", "array-api-strict", JAX, "torch"])
def test_public_functions_answer_in_the_library_of_their_arguments(library):
    rng = np.random.default_rng(91)
    alpha, beta = rng.uniform(-0.5, 1, (2, 40))
    gamma, delta = rng.uniform(0, 2, (2, 40))
    make = MAKE[library]
    given = [make(v) for v in (alpha, beta, gamma, delta)]
    counted = symhaptic.unstable_roots(*given, 2)
    stable = symhaptic.is_stable(*given, 2)
    want = [roots_outside(*wall, 2) for wall in zip(alpha, beta, gamma, delta, strict=True)]
    assert type(counted) is type(given[0])
    assert np.asarray(counted).tolist() == want
    assert np.asarray(stable).tolist() == [
        n == 0 and a > -g for n, a, g in zip(want, alpha, gamma, strict=True)
    ]
    others = [
        symhaptic.passivity_margin(*given[:2], given[3], 0.5),
        symhaptic.delay_margin(*given),
        *symhaptic.max_stable_stiffness(*given[2:], 0),
        *symhaptic.stability_boundary(1.0, *given[2:], 0.5),
        *symhaptic.stability_boundary(1.0, *given[2:], 1),
        *symhaptic.passivity_boundary(0.5, given[3], 1),
        *symhaptic.max_passive_stiffness(given[3], 1),
        *symhaptic.discretize(*given[2:]),
        symhaptic.linear_limit(given[1], given[3], 1),
    ]
    for one in others:
        assert type(one) is type(given[0])
        assert one.shape == given[0].shape


@pytest.mark.parametrize("library", ["array-api-strict", "jax", "torch"])
def test_bad_values_are_named_in_every_library(library):
    bad = MAKE[library](np.array([0.1, -0.25]))
    with pytest.raises(ValueError, match=r"^gamma: -0.25 is not allowed; finite numbers gamma"):
        symhaptic.discretize(bad, 0.0)
    with pytest.raises(ValueError, match=r"^delta: .* is not allowed; real numbers are"):
        symhaptic.discretize(0.0, MAKE[library](np.array([1j])))


def test_what_stays_single_and_what_does_not():
    one = np.float32([0.1, 0.2])
    assert symhaptic.discretize(one, 0.3)[0].dtype == np.float32
    assert symhaptic.discretize(one, [0.3, 0.4])[0].dtype == np.float32
    assert symhaptic.discretize(one, np.array([0.3, 0.4]))[0].dtype == np.float64
    assert symhaptic.discretize([1, 2], 0)[0].dtype == np.float64
    assert symhaptic.passivity_margin(one, 0.0, 1.0, 0.5).dtype == np.float32
    assert symhaptic.is_stable(one, 0.1, 0.1, 0.1, 1).dtype == np.bool_


def test_mapped_searches_broadcast_their_arguments():
    """`jax.vmap` over one argument beside arrays that it does not map, as NumPy has them."""
    jnp, jax = jax_numpy(), pytest.importorskip("jax")
    gamma, delay = np.array([0.0, 1.0, 2.0]), np.array([0.0, 0.5, 1.0])
    want = symhaptic.max_stable_stiffness(gamma[:, None], 0.02, delay).alpha

    def stiffest(spring, late):
        return symhaptic.max_stable_stiffness(spring, 0.02, late).alpha

    beside = jax.vmap(lambda spring: stiffest(spring, jnp.asarray(delay)))(jnp.asarray(gamma))
    assert np.asarray(beside).tolist() == want.tolist()
    one_by_one = jax.vmap(stiffest)(jnp.asarray(gamma), jnp.asarray(delay))
    assert np.asarray(one_by_one).tolist() == np.diag(want).tolist()
    margin = jax.vmap(
        lambda spring: symhaptic.delay_margin(0.1, jnp.asarray([0.4, 0.2]), spring, 0.02)
    )(jnp.asarray(gamma))
    expected = symhaptic.delay_margin(0.1, [0.4, 0.2], gamma[:, None], 0.02)
    assert np.asarray(margin).tolist() == expected.tolist()
