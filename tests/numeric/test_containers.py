"""What labels, units, masks and laziness become, beside the plain numbers they stand for."""

import inspect
import subprocess
import sys

import numpy as np
import pytest
from once import registry

import symhaptic
from symhaptic import (
    characteristic_polynomial,
    delay_margin,
    discretize,
    discretize_fractional,
    is_passive,
    is_stable,
    limit_at,
    linear_limit,
    max_delay,
    max_passive_stiffness,
    max_stable_stiffness,
    passivity_boundary,
    passivity_margin,
    passivity_margin_at,
    stability_boundary,
    stable_region,
    unstable_roots,
)

ARRAYS = {
    is_stable: (5, bool), unstable_roots: (5, int), stability_boundary: (4, float),
    max_stable_stiffness: (3, float), delay_margin: (5, float), max_delay: (4, float),
    is_passive: (4, bool),
    passivity_margin: (4, float), passivity_boundary: (3, float),
    max_passive_stiffness: (2, float), linear_limit: (3, float), discretize: (2, float),
    passivity_margin_at: (5, float), discretize_fractional: (3, float), limit_at: (4, float),
}  # fmt: skip
each = pytest.mark.parametrize("function", ARRAYS, ids=lambda f: f.__name__)


def library(name):
    return pytest.importorskip(name, reason=f"no {name} here: its arrays are not tried")


def some(function):
    """Numbers for every argument that differ from argument to argument, and the plain results."""
    count, kind = ARRAYS[function]
    rows = [np.array([0.1, 0.2, 0.4]) + 0.03 * i for i in range(count)]
    found = function(*rows)
    return rows, list(found) if isinstance(found, tuple) else [found], kind


def listed(found):
    return list(found) if isinstance(found, tuple) else [found]


def test_every_public_function_of_arrays_is_tried():
    numeric = {
        getattr(symhaptic, n) for n in symhaptic.__all__
        if symhaptic._HOME[n].split(".")[1] in ("numeric", "tracer")
    }  # fmt: skip
    functions = {f for f in numeric if inspect.isfunction(f)}
    single = {characteristic_polynomial, stable_region}
    single |= {symhaptic.robust_region, symhaptic.grid_boundary}
    assert functions == set(ARRAYS) | single | {symhaptic.show_config}


@each
def test_xarray_broadcasts_by_the_names_of_dimensions(function):
    xarray = library("xarray")
    rows, _, kind = some(function)
    first = xarray.DataArray(rows[0], dims="K", coords={"K": [5, 6, 7]})
    second = xarray.DataArray(rows[1], dims="B")
    rest = [float(r[0]) for r in rows[2:]]
    expected = listed(function(rows[0][:, None], rows[1], *rest))
    for found, wanted in zip(listed(function(first, second, *rest)), expected, strict=True):
        assert isinstance(found, xarray.DataArray)
        assert found.dims == ("K", "B")
        assert found.dtype == kind
        assert found.K.to_numpy().tolist() == [5, 6, 7]
        assert np.array_equal(found.to_numpy(), wanted, equal_nan=kind is float)


def test_xarray_whose_labels_disagree_is_refused_on_one_line():
    xarray = library("xarray")
    one, two = (xarray.DataArray([0.1, 0.2], dims="K", coords={"K": k}) for k in ([1, 2], [2, 3]))
    with pytest.raises(ValueError, match=r"^coordinates of the arguments: [^\n]+$"):
        is_stable(one, two, 0.0, 0.1, 0)
    with pytest.raises(ValueError, match=r"^beta: .+ is not allowed; give arrays of xarray"):
        is_stable(one, np.array([0.1, 0.2]), 0.0, 0.1, 0)


@each
def test_dask_stays_lazy_and_gives_the_same(function):
    array = library("dask.array")
    rows, expected, kind = some(function)
    lazy = [array.from_array(r, chunks=2) for r in rows]
    for found, wanted in zip(listed(function(*lazy)), expected, strict=True):
        assert isinstance(found, array.Array)
        assert found.dtype == kind
        assert found.shape == (3,)
        assert np.array_equal(found.compute(scheduler="sync"), wanted)


@each
def test_chunks_are_unified_with_those_of_other_arrays(function):
    """As Dask's own functions of elements do, whether the others have other chunks or none."""
    array = library("dask.array")
    rows, expected, _ = some(function)
    pieces = [array.from_array(row, chunks=1 + i % 2) for i, row in enumerate(rows)]
    for beside in (rows, pieces):
        mixed = [array.from_array(rows[0], chunks=2), *beside[1:]]
        for found, wanted in zip(listed(function(*mixed)), expected, strict=True):
            assert isinstance(found, array.Array)
            assert np.array_equal(found.compute(scheduler="sync"), wanted)


def test_xarray_on_dask_stays_lazy():
    xarray, array = library("xarray"), library("dask.array")
    alpha = xarray.DataArray(array.linspace(0.1, 0.4, 8, chunks=4), dims="K")
    found = is_stable(alpha, 0.2, 0.0, 0.0, 0)
    assert isinstance(found.data, array.Array)
    wanted = is_stable(np.linspace(0.1, 0.4, 8), 0.2, 0.0, 0.0, 0)
    assert found.compute(scheduler="sync").to_numpy().tolist() == wanted.tolist()


@each
def test_pandas_keeps_its_index(function):
    pandas = library("pandas")
    rows, expected, _ = some(function)
    series = [pandas.Series(r, index=["a", "b", "c"]) for r in rows]
    for found, wanted in zip(listed(function(*series)), expected, strict=True):
        assert isinstance(found, pandas.Series)
        assert found.index.tolist() == ["a", "b", "c"]
        assert found.to_numpy().tolist() == wanted.tolist()


def test_pandas_with_other_labels_is_refused():
    pandas = library("pandas")
    one, two = pandas.Series([0.1, 0.2], index=[0, 1]), pandas.Series([0.1, 0.2], index=[1, 0])
    with pytest.raises(ValueError, match=r"^beta: .+ is not allowed; give the labels of the first"):
        is_stable(one, two, 0.0, 0.1, 0)
    with pytest.raises(ValueError, match=r"^beta: .+ is not allowed; give arrays of pandas"):
        is_stable(one, np.array([0.1, 0.2]), 0.0, 0.1, 0)
    with pytest.raises(ValueError, match=r"^alpha: .+ is not allowed; give a Series"):
        is_stable(pandas.Index([0.1]), 0.1, 0.0, 0.1, 0)
    frame = pandas.DataFrame({"p": [0.1, 0.2], "q": [0.3, 9.0]})
    found = is_stable(frame, 0.4, 0.0, 0.0, 0)
    assert found.equals(pandas.DataFrame({"p": [True, True], "q": [True, False]}))


@each
def test_pint_is_converted_to_plain_numbers(function):
    unit = registry()
    rows, expected, kind = some(function)
    given = [1000 * rows[0] * unit("mm/m"), *rows[1:]]
    for found, wanted in zip(listed(function(*given)), expected, strict=True):
        assert (type(found) is unit.Quantity) == (kind is float)
        plain = found.magnitude if kind is float else found
        assert plain == pytest.approx(wanted, rel=1e-9)


def test_pint_of_another_dimension_is_refused():
    unit = registry()
    with pytest.raises(ValueError, match=r"^delay: .+ .*; give a number without dimension"):
        is_stable(0.1, 0.1, 0.0, 0.1, 1.5 * unit.ms)
    with pytest.raises(ValueError, match=r"^gamma: .+ .*; give a number without dimension"):
        stable_region(5 * unit.N, 0.1, 0)
    assert is_stable(100 * unit("mm/m"), 0.4, 0.0, 0.0, 0)
    assert not is_stable(100, 0.4, 0.0, 0.0, 0)


@each
def test_masks_are_kept(function):
    rows, expected, _ = some(function)
    given = [np.ma.MaskedArray(rows[0], mask=[False, True, False]), *rows[1:]]
    for found, wanted in zip(listed(function(*given)), expected, strict=True):
        assert np.ma.getmaskarray(found).tolist() == [False, True, False]
        assert found.compressed().tolist() == wanted[[0, 2]].tolist()


def test_behind_a_mask_are_real_numbers_only():
    for bad in ([0.5 + 1j, 0.5], ["0.5", "1"], np.array([1, 2], "m8[s]"), [1j, 0.5j]):
        for kind in (None, object):
            given = np.ma.MaskedArray(np.array(bad, dtype=kind), mask=[False, True])
            with pytest.raises(ValueError, match=r"^alpha: .+ is not allowed; give real numbers$"):
                is_stable(given, 0.4, 0.0, 0.1, 0)
    given = np.ma.MaskedArray([0.1, None], mask=[False, True])
    assert is_stable(given, 0.4, 0.0, 0.1, 0).tolist() == [True, None]


def test_one_loop_takes_no_labels():
    pandas = library("pandas")
    with pytest.raises(ValueError, match=r"^alpha: .+ is not allowed; give plain numbers$"):
        characteristic_polynomial(pandas.Series([0.1]), 0.1, 0.0, 0.1, 0)


def test_none_of_these_libraries_is_loaded_for_plain_numbers():
    program = (
        "import sys, symhaptic; symhaptic.is_stable([0.1], 0.2, 0.0, 0.1, 0);"
        "symhaptic.stable_region(0.0, 0.1, 0);"
        "names = 'xarray', 'dask', 'pandas', 'pint', 'torch', 'matplotlib';"
        "print([n for n in names if n in sys.modules])"
    )
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)
    assert told.stdout.split() == [b"[]"]


def test_formulas_as_functions_keep_labels_and_units():
    xarray, unit = library("xarray"), registry()
    stiffest = symhaptic.lambdify("eq11")
    delay = xarray.DataArray([0.0, 1.0], dims="d")
    alpha, _, theta = stiffest(1.0, delay)
    assert alpha.dims == theta.dims == ("d",)
    assert alpha.to_numpy() == pytest.approx([2, 2 * np.tan(np.pi / 8)])  # 2 tan(pi/(4 (d + 1)))
    assert stiffest(1000 * unit("mm/m"), 0.0)[0].magnitude == pytest.approx(2)
    with pytest.raises(ValueError, match="a number without dimension"):
        stiffest(1.0, 1 * unit.ms)


def test_labels_of_an_argument_do_not_describe_a_result():
    """A stiffness has a unit and a name of its own; an answer has neither."""
    xarray = library("xarray")
    axis = xarray.DataArray([0.1, 0.2], dims="K", attrs={"units": "N/m", "long_name": "stiffness"})
    assert linear_limit(axis, 0.1, 1).attrs == {}
    assert is_stable(axis.variable, 0.1, 0.1, 0.1, 1).attrs == {}


def test_series_of_what_is_no_real_number_are_refused():
    """Dates are not counted in nanoseconds, and an imaginary part is not cut off."""
    pandas = library("pandas")
    for values in (pandas.to_datetime(["2020-01-01"]), pandas.to_timedelta([1]), [1j], ["1.0"]):
        with pytest.raises(ValueError, match=r"^beta: .* is not allowed; give real numbers$"):
            linear_limit(pandas.Series(values), 0.1, 1)
    for values in ([True], pandas.array([1, None], dtype="Int64")):
        assert len(linear_limit(pandas.Series(values), 0.1, 1)) == len(values)


def test_other_kinds_of_these_libraries_are_refused_on_one_line():
    xarray, pint, delayed = library("xarray"), library("pint"), library("dask").delayed
    units = pint.UnitRegistry()
    for value in (xarray.DataTree(xarray.Dataset({"K": 0.1})), units.dimensionless, delayed(0.1)):
        with pytest.raises(ValueError, match=r"^alpha: .* is not allowed; give .*$"):
            is_stable(value, 0.1, 0.1, 0.1, 1)


def test_a_number_of_pint_may_stand_beside_labels():
    """The result has the labels; a number without dimension needs no unit."""
    xarray, pandas, pint = library("xarray"), library("pandas"), library("pint")
    tenth = pint.UnitRegistry().Quantity(100.0, "mm/m")
    axis = xarray.DataArray([0.1, 0.2], dims="beta", coords={"beta": [1, 2]})
    assert linear_limit(axis, tenth, 1).identical(linear_limit(axis, 0.1, 1))
    series = pandas.Series([0.1, 0.2], index=["a", "b"])
    pandas.testing.assert_series_equal(linear_limit(series, tenth, 1), linear_limit(series, 0.1, 1))


def test_a_word_is_no_array():
    with pytest.raises(ValueError, match=r"^sheet: array.* .*; give 'exact' or 'principal'"):
        is_stable(0.1, 0.1, 0.1, 0.1, 0.5, sheet=np.ones(2))


@pytest.mark.filterwarnings("error")
def test_what_no_float_holds_is_infinite():
    beyond = np.array(["1e400"], dtype=np.longdouble)
    with pytest.raises(ValueError, match="beta: inf is not allowed; give finite numbers"):
        linear_limit(beyond, 0.1, 1)
