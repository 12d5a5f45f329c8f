"""The generated kernels on arrays of every library, beside the vectors that exports ship with.

Expected values are mpmath's, of the definitions in `symhaptic.model`, to 60 digits.
"""

import math
import warnings
from functools import cache

import array_api_strict
import mpmath
import numpy as np
import pytest
from mpmath import mpf

import symhaptic
from symhaptic import lambdify
from symhaptic.export import kernels
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.vectors import vectors
from symhaptic.kernels import haptic

FORMS = {form.name: form for form in kernels.forms()}
CONTINUOUS = [name for name in FORMS if name not in ("is_stable", "unstable_roots")]
PLANTS = [(1e-8, 1e-3), (1.0, 0.5), (0.3, 1.9), (6.0, 0.3), (9.0, 8.0), (20.0, 0.01), (2, 30)]
GUARDED = [(0.0, 0.0), (0.0, 3.0), (1.0, 2.0), (25.0, 10.0), (3.0, 0.0)]


@cache
def known(name, precision=DOUBLE):
    """Columns of arguments, and rows of expected results and of how far off these may be."""
    rows = np.array(vectors(FORMS[name], precision))
    count = len(FORMS[name].arguments)
    return rows[:, :count].T, rows[:, count::2].T, rows[:, count + 1 :: 2].T


def host(values):
    """Results as rows of NumPy arrays."""
    values = values if isinstance(values, tuple) else (values,)
    return np.stack([np.asarray(v.cpu() if hasattr(v, "cpu") else v) for v in values])


def hold(found, expected, tolerance, times=1):
    """NaN where it is expected, outside of the domain."""
    found = host(found).astype(float)
    assert np.array_equal(np.isnan(found), np.isnan(expected))
    off = np.abs(found - expected) / (times * tolerance + (tolerance == 0))
    off = np.where(np.isnan(expected), 0.0, off)
    at = np.unravel_index(np.nanargmax(off), off.shape)
    assert np.isfinite(off).all()
    assert off.max() <= 1, f"result {at[0]}, vector {at[1]}: {off.max() * times:.2f} times"


def jax_numpy():
    jax = pytest.importorskip("jax", reason="no jax here: its arrays are not tried")
    jax.config.update("jax_enable_x64", True)
    return pytest.importorskip("jax.numpy")


def torch_():
    return pytest.importorskip("torch", reason="no torch here: its arrays are not tried")


def cuda():
    torch = torch_()
    if not torch.cuda.is_available():
        pytest.skip("no CUDA device here: torch's arrays on one are not tried")
    return torch


def cupy():
    return pytest.importorskip("cupy", reason="no CuPy here: its arrays are not tried")


MAKE = {
    "numpy": lambda v: np.asarray(v),
    "array-api-strict": lambda v: array_api_strict.asarray(v),
    "jax": lambda v: jax_numpy().asarray(v),
    "torch": lambda v: torch_().asarray(v),
    "torch on CUDA": lambda v: cuda().asarray(v, device="cuda"),
    "cupy": lambda v: cupy().asarray(v),
}


@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize("library", MAKE)
def test_vectors_in_double_precision(library, name):
    columns, expected, tolerance = known(name)
    given = [MAKE[library](c) for c in columns]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = getattr(haptic, name)(*given)
    first = found[0] if isinstance(found, tuple) else found
    assert type(first) is type(given[0])
    assert ("bool" if name == "is_stable" else "float64") in str(first.dtype)
    hold(found, expected, tolerance)


@pytest.mark.parametrize("name", CONTINUOUS)
@pytest.mark.parametrize("library", MAKE)
def test_vectors_in_single_precision(library, name):
    columns, expected, tolerance = known(name, SINGLE)
    given = [MAKE[library](c.astype(np.float32)) for c in columns]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = getattr(haptic, name)(*given)
    first = found[0] if isinstance(found, tuple) else found
    assert "float32" in str(first.dtype)
    hold(found, expected, tolerance)


@pytest.mark.ci
def test_vectors_of_jax_compiled():
    make, jax = jax_numpy().asarray, pytest.importorskip("jax")
    columns, expected, tolerance = known("discretize")
    hold(jax.jit(haptic.discretize)(*map(make, columns)), expected, tolerance)


@pytest.mark.ci
def test_stiff_devices_of_jax_compiled():
    """XLA joins a product and a sum; the product's rounding error was then subtracted twice."""
    make, jax = jax_numpy().asarray, pytest.importorskip("jax")
    gamma, delta = np.array([(1.3 * 10.0**k, 0.03) for k in range(1, 13)]).T
    found = host(jax.jit(haptic.discretize)(make(gamma), make(delta)))
    with mpmath.workdps(60):
        for g, d, n1 in zip(gamma, delta, found[0], strict=True):
            root = mpmath.sqrt(mpf(g) - mpf(d) ** 2 / 4)
            wave = mpmath.cos(root) + mpf(d) / 2 * mpmath.sin(root) / root
            expected = (1 - mpmath.exp(-mpf(d) / 2) * wave) / mpf(g)
            assert n1 == pytest.approx(float(expected), rel=1e-15, abs=0), g


@pytest.mark.slow
def test_an_unstable_wall_of_jax_compiled():
    """Two of its roots lie outside of the unit circle by 2e-14, as mpmath finds to 120 digits."""
    make, jax = jax_numpy().asarray, pytest.importorskip("jax")
    wall = 1.1542065691417248e19, -2.885548476338517e18, 986171029.6704594, 6.835241456660492e-10, 0
    assert not jax.jit(haptic.is_stable)(*(make([float(x)]) for x in wall))


@pytest.mark.slow
def test_root_counts_of_jax_compiled():
    """NaN gives -1: what is traced raises no error."""
    make, jax = jax_numpy().asarray, pytest.importorskip("jax")
    columns, (outside,), _ = known("unstable_roots")
    walls = np.column_stack([np.array(columns), [0.1, 0.1, 0.1, 0.2, math.nan]])
    counted = jax.jit(symhaptic.unstable_roots)(*map(make, walls))
    assert np.asarray(counted).tolist() == [*outside, -1]


@pytest.mark.slow
@pytest.mark.parametrize("name", FORMS)
def test_every_function_can_be_traced(name):
    """No number is looked at: shapes alone come out, of what no compiler has seen."""
    make, jax = jax_numpy().asarray, pytest.importorskip("jax")
    columns, expected, _ = known(name)
    found = jax.eval_shape(getattr(haptic, name), *(make(c) for c in columns))
    found = found if isinstance(found, tuple) else (found,)
    assert [v.shape for v in found] == [row.shape for row in expected]


@pytest.mark.slow
def test_vectors_of_a_traced_search_step_by_step(monkeypatch):
    """What `jax.jit` compiles, searches and all, but without the minute of its compiler."""
    make, jax = jax_numpy().asarray, pytest.importorskip("jax")
    monkeypatch.setattr(haptic, "_at_hand", lambda _: False)
    columns, expected, tolerance = known("max_stable_stiffness")
    arrays = [make(c) for c in columns]
    traced = jax.make_jaxpr(haptic.max_stable_stiffness)(*arrays)
    hold(tuple(stepped(traced, arrays)), expected, tolerance)


def stepped(traced, given):
    """What a traced function gives, each of its operations done by itself."""
    variables = (*traced.jaxpr.constvars, *traced.jaxpr.invars)
    values = dict(zip(variables, (*traced.consts, *given), strict=True))

    def value(atom):
        return atom.val if hasattr(atom, "val") else values[atom]

    for equation in traced.jaxpr.eqns:
        args, has = [value(atom) for atom in equation.invars], equation.params
        if equation.primitive.name == "cond":
            found = stepped(has["branches"][int(args[0])], args[1:])
        elif equation.primitive.name == "while":
            asks, goes = has["cond_nconsts"], has["cond_nconsts"] + has["body_nconsts"]
            found = args[goes:]
            while bool(stepped(has["cond_jaxpr"], [*args[:asks], *found])[0]):
                found = stepped(has["body_jaxpr"], [*args[asks:goes], *found])
        elif "jaxpr" in has:
            found = stepped(has["jaxpr"], args)
        else:
            found = equation.primitive.bind(*args, **has)
            found = found if equation.primitive.multiple_results else [found]
        values.update(zip(equation.outvars, found, strict=True))
    return [value(atom) for atom in traced.jaxpr.outvars]


@pytest.mark.ci
def test_jax_without_x64_stays_single():
    jax_numpy()
    jax = pytest.importorskip("jax")
    with jax.enable_x64(False), warnings.catch_warnings():
        warnings.simplefilter("error")
        found = jax.jit(haptic.discretize)(jax.numpy.asarray([0.0, 1.0]), 0.5)
        assert all(v.dtype == np.float32 for v in found)
        counted = symhaptic.unstable_roots(jax.numpy.asarray([0.1, 9.0]), 0.1, 0.0, 0.1, 1)
    assert counted.tolist() == [0, 2]  # numpy.roots of the polynomial


@pytest.mark.slow
def test_slopes_by_jax():
    """Beside mpmath's numerical derivatives of the definition; no NaN where a guard steps in."""
    jnp = jax_numpy()
    jax = pytest.importorskip("jax")
    slopes = jax.jit(jax.vmap(jax.jacrev(lambda p: jnp.stack(haptic.discretize(p[0], p[1])))))(
        jnp.asarray(PLANTS + GUARDED)
    )
    assert np.isfinite(np.asarray(slopes)).all()
    exact = lambdify("discretize", modules="mpmath")
    for (gamma, delta), found in zip(PLANTS, np.asarray(slopes), strict=False):
        for i in range(4):
            for k in (0, 1):
                with mpmath.workdps(40):
                    at = mpf(gamma), mpf(delta)
                    want = mpmath.diff(lambda *x, i=i: exact(*x)[i], at, (1 - k, k), h=1e-15)
                assert found[i, k] == pytest.approx(float(want), rel=1e-9, abs=1e-12)


@pytest.mark.slow
def test_torch_slopes_and_compiled():
    """Gradients through the gathering; a whole graph where torch compiles, without a break.

    Inductor takes minutes over a kernel here, so that what runs is its own ahead-of-time graph.
    """
    torch = torch_()
    gamma = torch.tensor([1.0, 6.0, 9.0], dtype=torch.float64, requires_grad=True)
    n1, *_ = haptic.discretize(gamma, torch.tensor([0.5, 0.3, 8.0], dtype=torch.float64))
    n1.sum().backward()
    exact = lambdify("discretize", modules="mpmath")
    for slope, (g, d) in zip(gamma.grad.tolist(), [(1, 0.5), (6, 0.3), (9, 8)], strict=True):
        with mpmath.workdps(40):
            want = mpmath.diff(lambda x, d=d: exact(x, mpf(d))[0], mpf(g))
        assert slope == pytest.approx(float(want), rel=1e-9)
    columns, expected, tolerance = known("linear_limit")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # torch's own, of what it traces through
        compiled = torch.compile(haptic.linear_limit, backend="aot_eager", fullgraph=True)
        found = compiled(*(torch.asarray(c) for c in columns))
    hold(found, expected, tolerance)


@pytest.mark.parametrize("module", ["jax", "torch"])
def test_formulas_as_functions(module):
    """`lambdify` on arrays of the library that it names."""
    make = MAKE[module]
    columns, expected, tolerance = known("max_passive_stiffness")
    arrays = [make(c) for c in columns]
    found = lambdify("eq11", modules=module)(*arrays)
    hold(found, expected, tolerance)
    assert type(found[0]).__module__.split(".")[0] in (module, "jaxlib")


@pytest.mark.slow
def test_traced_values_are_not_looked_at():
    """Fractions of a delay included; NaN for NaN and never an error."""
    make, jax = jax_numpy().asarray, pytest.importorskip("jax")
    delay = make([1.0, 0.5, math.nan])
    alpha, _ = jax.jit(symhaptic.stability_boundary)(1.0, 0.1, 0.2, delay)
    assert np.isnan(np.asarray(alpha)).tolist() == [False, False, True]
    want, _ = symhaptic.stability_boundary(1.0, 0.1, 0.2, [1.0, 0.5])
    assert np.asarray(alpha)[:2] == pytest.approx(want, rel=1e-12)
    jax.jit(symhaptic.discretize)(make(-1.0), make(-1.0))
    late = make([0.0, 0.0, 0.5])
    margin = jax.jit(symhaptic.passivity_margin)(make([1.0, -1.0, 4 * 5**0.5 - 8]), 0.0, 1.0, late)
    # (6): b - K T/2 without delay; half a period late 4 sqrt(5) - 8 is just passive
    assert np.asarray(margin) == pytest.approx([0.5, -math.inf, 0.0], abs=1e-14)


@pytest.mark.slow
def test_torch_compiles_around_public_functions():
    """Its graph breaks there: thousands of operations would keep it busy for minutes."""
    torch = torch_()

    def kept(alpha):
        stable = symhaptic.is_stable(2 * alpha, 0.4, 0.0, 0.02, 1)
        return torch.where(stable, symhaptic.delay_margin(2 * alpha, 0.4, 0.0, 0.02), 0.0)

    alpha = torch.linspace(0.01, 0.5, 5, dtype=torch.float64)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # torch's own, of what it traces through
        found = torch.compile(kept, backend="aot_eager")(alpha)
    assert found.tolist() == kept(alpha).tolist()
    assert 0 < np.count_nonzero(found) < 5
