"""The compiled ufuncs: what NumPy expects of one, and the same numbers as the kernels for arrays.

Needs of the repository nothing beside this file, so that wheels are tested by it.
"""

import os
import subprocess
import sys
import threading
from types import ModuleType

import numpy as np
import pytest

import symhaptic
from symhaptic.cli.main import main
from symhaptic.kernels import haptic
from symhaptic.numeric import compiled

ufuncs = pytest.importorskip(
    "symhaptic.kernels._compiled", reason="the install found no compiler", exc_type=ImportError
)

RNG = np.random.default_rng(19)
COLUMNS = {
    "theta": RNG.uniform(0.01, 3.1, 500),
    "alpha": RNG.normal(size=500),
    "beta": RNG.normal(size=500),
    "gamma": RNG.choice([0, 1e-3, 1, 9, 40], 500) * RNG.uniform(0.5, 1, 500),
    "delta": RNG.choice([0, 1e-3, 1, 5], 500) * RNG.uniform(0.5, 1, 500),
    "d": RNG.choice([0, 0.3, 1, 2.5, 7], 500),
    "epsilon": RNG.uniform(0, 1, 500),
}
NAMES = [name for name in vars(haptic) if f"one_{name}" in vars(ufuncs)]


def columns(name, kind=np.float64):
    """The arguments, by the names that the documentation's first line gives."""
    given = getattr(ufuncs, name).__doc__.split(" of (")[1].split(")")[0].split(", ")
    return [COLUMNS[n].astype(kind) for n in given]


def rows(found):
    return np.stack(np.atleast_2d(found))


@pytest.mark.parametrize("name", NAMES)
def test_the_numbers_are_those_of_the_array_kernels(name):
    """Each is within a few last places of the exact values; what passes through 0 of its terms.

    The slopes of searched angles and sine and cosine of the C library differ in last places from
    NumPy's, so bits are compared where neither is used: `linear_limit` below, and truth values.
    """
    given = columns(name)
    with np.errstate(all="ignore"):
        one, other = rows(getattr(ufuncs, name)(*given)), rows(getattr(haptic, name)(*given))
    if one.dtype == bool or name == "unstable_roots":
        assert np.array_equal(one, other)
    last = 16 * 2**-52 * np.nanmax(np.where(np.isfinite(other), abs(other), 0), axis=0)
    assert np.allclose(one, other, rtol=1e-12, atol=np.maximum(last, 1e-15), equal_nan=True)
    assert not np.all(np.isnan(one.astype(float)))


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_a_routine_from_inside_gives_what_it_gives_there(kind):
    given = [COLUMNS[n].astype(kind) for n in ("gamma", "delta", "epsilon")]
    one, other = rows(ufuncs.late_device(*given)), rows(haptic.late_device(np, *given))
    assert one.dtype == kind
    assert np.allclose(one, other, rtol=0, atol=8 * np.finfo(kind).eps)


def test_bits_are_the_same_where_both_are_exact():
    """A sum and a quotient, each rounded once by IEEE 754."""
    given = columns("linear_limit")
    assert np.array_equal(ufuncs.linear_limit(*given), haptic.linear_limit(*given))


@pytest.mark.parametrize("name", NAMES)
def test_single_precision_has_its_own_routines(name):
    ufunc, given = getattr(ufuncs, name), columns(name, np.float32)
    found = rows(ufunc(*given))
    assert found.dtype in (np.float32, np.bool_)
    wide = rows(ufunc(*[g.astype(np.float64) for g in given])).astype(float)
    close = np.isclose(found, wide, rtol=1e-3, atol=1e-4, equal_nan=True)
    assert np.mean(close) > 0.95  # at edges of a region a last place decides


def test_they_are_ufuncs():
    """NumPy's reference: `out`, `where`, broadcasting, casting, several results."""
    out = np.full(3, -7.0)
    kept = np.array([True, False, True])
    found = ufuncs.linear_limit(np.arange(3.0), 0.5, 0.5, out=out, where=kept)
    assert found is out
    assert out.tolist() == [0.5, -7.0, 2.5]
    assert ufuncs.linear_limit([[0], [1]], [0, 1, 2], 0).shape == (2, 3)
    assert ufuncs.linear_limit(1, 1, 0).dtype == np.float64
    assert ufuncs.linear_limit(np.float32(1), np.float32(1), np.float32(0)).dtype == np.float32
    with pytest.raises(TypeError):
        ufuncs.linear_limit(1j, 0, 0)
    n1, n0, a, e = ufuncs.discretize(0.0, 0.0)  # a free mass: t^2/2 and two roots at 1
    assert (n1, n0, a, e) == (0.5, 0.5, 2.0, 1.0)
    assert ufuncs.discretize(np.empty(0), 1.0)[0].shape == (0,)


@pytest.mark.parametrize("name", NAMES)
def test_what_they_say(name):
    said = getattr(ufuncs, name).__doc__
    assert "Domain" in said
    assert "outside" in said


@pytest.mark.filterwarnings("error")
def test_out_of_range_is_nan_without_a_warning():
    given = np.array([-1.0, np.nan, np.inf, 1e71])
    assert np.isnan(rows(ufuncs.discretize(given, 1.0))).all()
    assert np.isnan(rows(ufuncs.discretize(1.0, given))).all()
    assert not ufuncs.is_stable(0.01, 0.1, given, 0.1, 0.0).any()
    assert (ufuncs.unstable_roots(0.01, 0.1, given, 0.1, 0.0) == -1).all()


@pytest.mark.parametrize("shape", [(), (3,)])
@pytest.mark.parametrize(
    ("name", "given", "said"),
    [
        ("discretize", (-1.0, 0.1), "gamma: -1.0 is not allowed; give finite numbers gamma >= 0"),
        ("discretize", (0.1, np.inf), "delta: inf is not allowed; give finite numbers delta >= 0"),
        ("is_stable", (0.1, 0.1, 0.1, -2.0, 1.0), "delta: -2.0 is not allowed"),
        ("is_stable", (np.inf, 0.1, 0.1, 2.0, 1.0), "alpha: inf is not allowed"),
        ("stability_boundary", (4.0, 0.1, 0.1, 1.0), "theta: 4.0 is not allowed"),
        ("linear_limit", (0.1, 0.1, -1.0), "delay: -1.0 is not allowed"),
    ],
)
def test_public_functions_refuse_by_name(name, given, said, shape):
    with pytest.raises(ValueError) as told:  # noqa: PT011 - the text is looked at
        getattr(symhaptic, name)(*[np.full(shape, v) if shape else v for v in given])
    assert str(told.value).startswith(said)


def test_public_functions_take_names_and_shapes_as_ever():
    a = symhaptic.is_stable(0.003, 0.05, gamma=0.001, delta=0.02, delay=5.0)
    assert type(a) is np.bool_
    assert a.shape == ()
    assert a
    with pytest.raises(ValueError, match="shapes of the arguments"):
        symhaptic.linear_limit(np.zeros(2), np.zeros(3), 1.0)
    with pytest.raises(TypeError):
        symhaptic.linear_limit(1.0, 1.0)
    assert np.isnan(symhaptic.linear_limit(np.nan, 1.0, 1.0))
    assert symhaptic.linear_limit(np.zeros((0, 2)), 1.0, 1.0).shape == (0, 2)


BEYOND = [np.nan, np.inf, -np.inf, 1e71, -1e71]


@pytest.mark.parametrize("name", NAMES)
def test_a_loop_tells_of_one_argument_that_is_out_of_range(name):
    """Anywhere, also in the middle of a part that is left out or not next to each other."""
    ufunc, given = getattr(ufuncs, name), columns(name)
    ufuncs.outside()
    ufunc(*given)
    assert not ufuncs.outside()
    for i in range(len(given)):
        for value in BEYOND:
            wrong = [g.copy() for g in given]
            wrong[i][377] = value
            ufunc(*wrong)
            assert ufuncs.outside()
            assert not ufuncs.outside()  # told once
            ufunc(*(w[::-1] for w in wrong))
            assert ufuncs.outside()
            ufunc(*(w[:377] for w in wrong))
            assert not ufuncs.outside()


def test_each_thread_is_told_of_its_own_arguments():
    ufuncs.outside()
    told = []

    def elsewhere():
        ufuncs.linear_limit(np.nan, 1.0, 1.0)
        told.append(ufuncs.outside())

    thread = threading.Thread(target=elsewhere)
    thread.start()
    thread.join()
    assert told == [True]
    assert not ufuncs.outside()


def test_others_work_while_an_array_is_worked_on():
    """The lock is released: between two looks at a long call there is time for thousands."""
    given = [np.tile(c, 800) for c in columns("is_stable")]
    call = threading.Thread(target=symhaptic.is_stable, args=given)
    looks = 0
    call.start()
    while call.is_alive():
        looks += 1
    assert looks > 1000


@pytest.mark.parametrize("name", NAMES)
def test_a_call_with_numbers_is_that_with_arrays(name):
    """The same bits, of the same types; None where it is not for them."""
    ufunc, one = getattr(ufuncs, name), getattr(ufuncs, f"one_{name}")
    given = columns(name)
    together = rows(ufunc(*given))
    for i, values in enumerate(zip(*(g.tolist() for g in given), strict=True)):
        found = one(*values)
        if found is None:
            assert np.isnan(together[:, i].astype(float)).any()
            continue
        kinds = {type(f) for f in (found if isinstance(found, tuple) else (found,))}
        assert kinds == {np.bool_ if together.dtype == bool else np.float64}
        assert np.array_equal(np.ravel(found), together[:, i])
    for i in range(len(values)):
        for wrong in (*BEYOND, "1", None, 1j, True, 2**53 + 1, 10**400, np.ones(1), np.float32(1)):
            assert one(*values[:i], wrong, *values[i + 1 :]) is None
    assert one(*values[1:]) is None
    assert one(*values, 1.0) is None


@pytest.mark.parametrize("scale", [1e71, 1e80, 1e300])
@pytest.mark.parametrize("shape", [(), (4,)])
def test_a_wall_that_is_too_large_is_no_wall_of_size_one(scale, shape):
    """What is scaled before it is looked at passes every question."""
    given = [np.full(shape, v) if shape else v for v in (scale, scale, 0.0, 0.5)]
    with pytest.raises(ValueError, match=r"alpha: .* is not allowed; give numbers up to 1e"):
        symhaptic.passivity_margin(*given)


@pytest.mark.parametrize("delay", [0.0, 0.5, 1.0, 1.5])
@pytest.mark.parametrize("wall", [(1.0, 0.3), (0.3, -1.0), (1e-3, 1.0)])
def test_squares_of_a_tiny_wall_do_not_vanish(wall, delay):
    """The needed damping is homogeneous, in C and in Python, in both precisions."""
    for scales, kind in (((2.0**-900, 2.0**-500), np.float64), ((2.0**-110, 2.0**-60), np.float32)):
        for kernel in (ufuncs.passivity_margin, haptic.passivity_margin):
            wide = [np.array([v], dtype=kind) for v in (*wall, 0.0, delay)]
            need = kernel(*wide)[0]
            for scale in scales:
                small = [wide[0] * kind(scale), wide[1] * kind(scale), *wide[2:]]
                assert kernel(*small)[0] == need * kind(scale)


@pytest.mark.parametrize("scale", [2.0**-900, 2.0**-500, 2.0**200])
def test_a_margin_grows_with_wall_and_damping(scale):
    """The needed damping is homogeneous in the wall: powers of two do not change a digit."""
    for row in zip(*(COLUMNS[n].tolist() for n in ("alpha", "beta", "delta", "d")), strict=True):
        alpha, beta, delta, delay = row
        one = symhaptic.passivity_margin(alpha, beta, delta, delay)
        scaled = symhaptic.passivity_margin(scale * alpha, scale * beta, scale * delta, delay)
        assert scaled == scale * one


SEARCHES = {
    "passivity_margin": ("alpha", "beta", "delta", "d"),
    "max_stable_stiffness": ("gamma", "delta", "d"),
    "max_passive_stiffness": ("delta", "d"),
}


@pytest.mark.parametrize("name", SEARCHES)
def test_one_by_one_is_as_together(name):
    """Floats take the short way, lists the long one."""
    given = [COLUMNS[n][:40] for n in SEARCHES[name]]
    search = getattr(symhaptic, name)
    together = rows(search(*(g.tolist() for g in given)))
    single = [np.ravel(search(*one)) for one in zip(*(g.tolist() for g in given), strict=True)]
    assert np.array_equal(np.stack(single, axis=1), together, equal_nan=True)


def told(choice):
    code = "import symhaptic; symhaptic.show_config(); print(*symhaptic.discretize(0.0, 0.0))"
    environment = os.environ | {compiled.CHOICE: choice}
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=environment
    )


def test_either_kernels_can_be_asked_for():
    for choice in ("array", "compiled"):
        found = told(choice)
        assert f"kernels: {choice}\n" in found.stdout
        assert found.stdout.endswith("\n0.5 0.5 2.0 1.0\n")
    wrong = told("fast")
    assert wrong.returncode == 1
    assert "give 'array' or 'compiled'" in wrong.stderr


def test_the_variable_is_refused_on_one_line_by_every_command(monkeypatch, capsys):
    """An unknown word, and compiled kernels where the install found no compiler."""
    for word, missing in (("fast", False), ("compiled", True)):
        monkeypatch.setenv(compiled.CHOICE, word)
        monkeypatch.delitem(sys.modules, compiled.__name__)
        monkeypatch.delattr("symhaptic.numeric.compiled")
        if missing:
            monkeypatch.setitem(sys.modules, "symhaptic.kernels._compiled", None)
            monkeypatch.delattr("symhaptic.kernels._compiled")
        for words in (["--version"], ["export", "--list"]):
            monkeypatch.setattr(sys, "argv", ["symhaptic", *words])
            with pytest.raises(SystemExit) as ended:
                main()
            out, err = capsys.readouterr()
            assert (ended.value.code, out, err.count("\n")) == (2, "", 1)
            assert f"{compiled.CHOICE}: '{word}' is not a" in err
            assert "'array'" in err
        monkeypatch.undo()


@pytest.mark.parametrize("stamp", [None, "of other sources"])
def test_kernels_that_are_compiled_of_other_sources_are_left_aside(stamp, monkeypatch):
    """One line says what to do; a module of a time before there was a stamp has no `outside`."""
    other = ModuleType("symhaptic.kernels._compiled")
    if stamp is not None:
        other.STAMP = stamp
    monkeypatch.setitem(sys.modules, other.__name__, other)
    monkeypatch.setattr("symhaptic.kernels._compiled", other)
    for choice in ("", "array", "compiled"):
        monkeypatch.setenv(compiled.CHOICE, choice)
        if choice == "compiled":
            with pytest.raises(ValueError, match=r"^SYMHAPTIC_KERNELS: 'compiled' .*anew.*'array'"):
                compiled._module()
        elif choice == "array":
            assert compiled._module() is None
        else:
            with pytest.warns(RuntimeWarning, match="`pip install -e .` compiles them anew; until"):
                assert compiled._module() is None


def test_one_count_is_a_number():
    for sheet in ("exact", "principal"):
        one = symhaptic.unstable_roots(0.5, 1.0, 0.0, 0.0, 0.5, sheet=sheet)
        assert isinstance(one, np.integer)
