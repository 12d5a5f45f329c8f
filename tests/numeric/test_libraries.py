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
    with pytest.raises(ValueError, match=r"^gamma: -0.25 .*; give finite numbers gamma"):
        symhaptic.discretize(bad, 0.0)
    with pytest.raises(ValueError, match=r"^delta: .* is not allowed; give real numbers"):
        symhaptic.discretize(0.0, MAKE[library](np.array([1j])))


def test_what_stays_single_and_what_does_not():
    one = np.float32([0.1, 0.2])
    assert symhaptic.discretize(one, 0.3)[0].dtype == np.float32
    assert symhaptic.discretize(one, [0.3, 0.4])[0].dtype == np.float32
    assert symhaptic.discretize(one, np.array([0.3, 0.4]))[0].dtype == np.float64
    assert symhaptic.discretize([1, 2], 0)[0].dtype == np.float64
    assert symhaptic.passivity_margin(one, 0.0, 1.0, 0.5).dtype == np.float32
    assert symhaptic.is_stable(one, 0.1, 0.1, 0.1, 1).dtype == np.bool_
    assert symhaptic.max_stable_stiffness(one, 0.3, 1).alpha.dtype == np.float32
    assert symhaptic.delay_margin(one, 0.4, 0.0, 0.1).dtype == np.float32


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


def forward(function, x, h=1e-6):
    """The slope to the right, by differences of second order."""
    return (4 * function(x + h) - 3 * function(x) - function(x + 2 * h)) / (2 * h)


SLOPES = {
    "max_stable_stiffness": [(0.001, 0.02, 1.0), (0.0, 0.0, 1.5), (0.001, 0.02, 0.0)],
    "max_passive_stiffness": [(0.02, 1.0), (0.02, 1.5), (0.02, 0.1)],
    "passivity_margin": [(0.003, 0.01, 0.02, 1.0), (0.003, 0.01, 0.02, 2.25)],
}


@pytest.mark.ci
@pytest.mark.parametrize("name", SLOPES)
def test_jax_differentiates_formulas_that_search(name):
    """The first result by each argument, beside differences of the function in NumPy."""
    jax_numpy(), pytest.importorskip("jax")
    import jax

    own, function = getattr(symhaptic, name), symhaptic.lambdify(name, modules="jax")
    for point in SLOPES[name]:
        for i in range(len(point)):

            def first(x, of=function, point=point, i=i):
                found = of(*point[:i], x, *point[i + 1 :])
                return found[0] if isinstance(found, tuple) else found

            slope = float(jax.grad(first)(point[i]))
            near = forward(lambda x, i=i, point=point: float(first(x, own, point, i)), point[i])
            assert slope == pytest.approx(near, rel=1e-6), (point, i)


def test_jax_differentiates_the_formula_for_the_largest_passive_stiffness():
    """(11): alpha = 2 delta tan(pi/(4 (d + 1))) for integer delays."""
    jax_numpy(), pytest.importorskip("jax")
    import jax

    for function in (symhaptic.lambdify("eq11", modules="jax"), symhaptic.max_passive_stiffness):
        for d in (0.0, 1.0, 3.0):
            slope = jax.grad(lambda x, d=d, function=function: function(x, d)[0])(0.02)
            assert float(slope) == pytest.approx(2 * np.tan(np.pi / (4 * (d + 1))), rel=1e-12)
            angle = jax.grad(lambda x, d=d, function=function: function(x, d)[2])(0.02)
            assert angle == 0
    edge = jax.grad(lambda x: symhaptic.passivity_boundary(1.0, x, 1.0)[0])(0.02)
    assert edge == pytest.approx(float(symhaptic.passivity_boundary(1.0, 1.0, 1.0)[0]), rel=1e-12)
    with pytest.raises(ValueError, match=r"^delay: JAX cannot differentiate max_passive_stiffness"):
        jax.grad(lambda d: symhaptic.max_passive_stiffness(0.02, d).alpha)(1.0)


@pytest.mark.ci
def test_derivatives_in_jax_of_arrays_and_of_compiled_functions():
    jnp, jax = jax_numpy(), pytest.importorskip("jax")
    delta, function = np.array([0.01, 0.02, 0.03]), symhaptic.lambdify("max_stable_stiffness")

    def stiffest(x):
        return function(0.001, x, 1.5)[0]

    near = forward(lambda x: symhaptic.max_stable_stiffness(0.001, x, 1.5).alpha, delta)
    for found in (
        jax.grad(lambda x: stiffest(x).sum())(jnp.asarray(delta)),
        jnp.diag(jax.jacfwd(stiffest)(jnp.asarray(delta))),
    ):
        assert np.asarray(found) == pytest.approx(near, rel=1e-6)
    assert isinstance(jax.jit(symhaptic.max_stable_stiffness)(0.0, 0.0, 1.0), symhaptic.Extremum)
    assert jax.grad(stiffest)(jnp.float32(0.02)).dtype == jnp.float32


@pytest.mark.ci  # JAX traces and compiles for 4 s
def test_what_jax_cannot_differentiate_says_what_to_do():
    jax_numpy(), pytest.importorskip("jax")
    import jax

    def stiffest(x, i=0):
        return symhaptic.lambdify("max_stable_stiffness")(0.001, x, 1.0)[i]

    assert np.isnan(jax.grad(lambda x: stiffest(x, 1))(0.02))  # the envelope is about alpha alone
    # without delay every angle is a worst one of the stiffest passive wall
    assert np.isnan(jax.grad(lambda d: symhaptic.lambdify("eq11")(0.02, d)[0])(0.0))
    use = r"lambdify\('{}', modules='jax'\) has derivatives".format
    values = "take differences of its values"
    for function, name, title, instead in (
        (lambda x: symhaptic.delay_margin(x, 0.1, 0.0, 0.02), "alpha", "delay_margin", values),
        (lambda x: symhaptic.max_delay(0.01, x, 0.0, 0.02), "beta", "max_delay", values),
        (
            lambda x: symhaptic.passivity_boundary(x, 0.02, 1.5)[0],
            *("theta", "passivity_boundary", values),
        ),
        (
            lambda x: symhaptic.max_stable_stiffness(0.0, x, 1.5).alpha,
            *("delta", "max_stable_stiffness", use("max_stable_stiffness")),
        ),
        (
            lambda x: symhaptic.passivity_margin(x, 0.0, 0.02, 1.5),
            *("alpha", "passivity_margin", use("passivity_margin")),
        ),
        (
            lambda x: symhaptic.max_passive_stiffness(0.02, x).alpha,
            *("delay", "max_passive_stiffness", use("max_passive_stiffness")),
        ),
        (
            lambda x: symhaptic.lambdify("eq11", derivatives=["delta"])(x, 1.5)[3],
            *("delta", "max_passive_stiffness_and_derivatives", values),
        ),
    ):
        said = f"^{name}: JAX cannot differentiate {title} with respect to it; {instead}"
        with pytest.raises(ValueError, match=said):
            jax.grad(function)(0.02)
    with pytest.raises(ValueError, match=r"^max_stable_stiffness: JAX cannot differentiate it twi"):
        jax.grad(jax.grad(stiffest))(0.02)
