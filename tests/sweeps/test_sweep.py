"""Sweeps beside the functions they call, on every kind of worker, and what they refuse."""

import inspect
import json
import math
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress

import numpy as np
import pytest
from once import registry

import symhaptic
from symhaptic import (
    Arm,
    Scene,
    is_stable,
    max_stable_stiffness,
    passivity_margin,
    stability_boundary,
    sweep,
)
from symhaptic.forms.stable import STATEMENTS as FORMS
from symhaptic.sweeps import work
from symhaptic.sweeps.plan import lengths_of
from symhaptic.sweeps.quantities import QUANTITIES

xarray = pytest.importorskip("xarray", reason="no xarray here: no sweeps")
pytest.importorskip("dask", reason="no Dask here: no sweeps")

ALPHA, BETA = np.linspace(-0.01, 0.5, 23), np.linspace(-0.1, 1.2, 17)
GAMMA, DELTA = np.linspace(0, 0.001, 5), np.linspace(0, 0.02, 7)
WALLS = {"alpha": ALPHA, "beta": BETA, "gamma": GAMMA, "delta": DELTA, "delay": 1.0}


def grid(delay=1.0):
    """The same walls in one array of four dimensions."""
    alpha, beta, gamma, delta = np.ix_(ALPHA, BETA, GAMMA, DELTA)
    return is_stable(alpha, beta, gamma, delta, delay)


def test_every_axis_becomes_a_dimension_with_units():
    found = sweep("is_stable", **WALLS)
    assert found.is_stable.dims == ("alpha", "beta", "gamma", "delta")
    assert np.array_equal(found.is_stable, grid())
    assert found.is_stable.attrs["formula"] == "eq18"
    assert found.alpha.attrs == {
        "units": "1", "long_name": "virtual stiffness, K T^2/m", "symbol": r"\alpha"
    }  # fmt: skip
    assert found.delay.item() == 1
    assert "kernels" in found.attrs["source"]


@pytest.mark.parametrize(
    ("chunks", "lazy"), [(None, False), (None, True), (1, False), (100, True), ({"beta": 5}, False)]
)
def test_reductions_are_those_of_numpy_whatever_the_blocks(chunks, lazy):
    words = ("all", "any", "mean", "count")
    over = ("gamma", "delta")
    found = sweep("is_stable", over=over, reduce=words, chunks=chunks, lazy=lazy, **WALLS)
    every = grid()
    for word, wanted in (("all", every.all((2, 3))), ("any", every.any((2, 3))),
                         ("mean", every.mean((2, 3))), ("count", every.sum((2, 3)))):  # fmt: skip
        one = found[f"is_stable_{word}"]
        assert one.chunks is not None if lazy else one.chunks is None
        assert one.dtype == wanted.dtype
        assert np.array_equal(one, wanted)
    assert found.is_stable_all.attrs["cell_methods"] == "gamma: delta: minimum"


def test_numbers_are_reduced_and_nan_is_not_left_out():
    delta, delay = [0.0, 0.01, 0.02], [0, 0.5, 3]
    spring = [0.0, 5.0, math.pi**2]  # the last of these, undamped, is never stable
    found = sweep("max_stable_stiffness", gamma=spring, delta=delta, delay=delay,
                  over="delta", reduce=["min", "max", "mean"])  # fmt: skip
    every = max_stable_stiffness(*np.ix_(spring, delta, delay)).alpha
    for word in ("min", "max", "mean"):
        wanted = getattr(every, word)(axis=1)
        assert found[f"alpha_{word}"].to_numpy() == pytest.approx(wanted, rel=1e-15, nan_ok=True)
    assert np.isnan(found.alpha_min[2]).all()
    assert np.isfinite(found.alpha_min[0]).all()


def test_a_block_takes_little_memory_however_much_it_reduces():
    """Tiles of the walls of one point of a map: the sum over them is what NumPy has."""
    found = sweep("is_stable", alpha=0.05, beta=0.3, gamma=np.linspace(0, 0.4, 3000),
                  delta=np.linspace(0, 0.02, 100), delay=1.0,
                  over=("gamma", "delta"), reduce="count")  # fmt: skip
    every = is_stable(0.05, 0.3, np.linspace(0, 0.4, 3000)[:, None], np.linspace(0, 0.02, 100), 1.0)
    assert found.is_stable.item() == every.sum()
    assert 0 < every.sum() < every.size


def test_arms_whose_numbers_belong_together_share_a_dimension():
    gamma = xarray.DataArray([1e-4, 5e-4, 2e-4], dims="arm", coords={"arm": list("abc")})
    delta = xarray.DataArray([1e-3, 2e-2, 5e-3], dims="arm")
    found = sweep("max_stable_stiffness", gamma=gamma, delta=delta, delay=[0, 1])
    assert found.alpha.dims == ("arm", "delay")
    assert found.arm.to_numpy().tolist() == ["a", "b", "c"]
    wanted = max_stable_stiffness(gamma.values[:, None], delta.values[:, None], [0, 1])
    assert np.array_equal(found.alpha, wanted.alpha)
    worst = sweep("max_stable_stiffness", gamma=gamma, delta=delta, delay=[0, 1],
                  over="arm", reduce="min")  # fmt: skip
    assert np.array_equal(worst.alpha, wanted.alpha.min(axis=0))


def test_a_series_of_pandas_keeps_its_index():
    pandas = pytest.importorskip("pandas", reason="no pandas here: its Series are not tried")
    gamma = pandas.Series([1e-4, 5e-4], index=pandas.Index(["p", "q"], name="person"))
    found = sweep("max_stable_stiffness", gamma=gamma, delta=0.01, delay=1.0)
    assert found.alpha.dims == ("person",)
    assert found.person.to_numpy().tolist() == ["p", "q"]


def test_an_axis_of_a_function_of_ones_own_keeps_its_name():
    def sway(omega):
        return 2 * omega

    assert sweep(sway, omega=[1.0, 2.0]).sway.dims == ("omega",)


def test_a_scene_is_swept_in_its_units():
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-4, delay=1.5e-3)
    late = np.array([0.0, 1e-4, 3e-4, 7e-4])  # whole periods, though 3e-4/1e-4 is no whole float
    found = sweep("max_stable_stiffness", scene, delay=late, damping=[0.5, 1.0])
    assert found.K.dims == ("delay", "damping")
    assert found.K.attrs["units"] == "N/m"
    assert found.K.attrs["long_name"] == "largest stable virtual stiffness"
    assert found.delay.attrs["units"] == "s"
    for i, delay in enumerate(late):
        for j, damping in enumerate((0.5, 1.0)):
            one = Scene(mass=0.1, damping=damping, sampling_period=1e-4, delay=float(delay))
            stiffest = one.max_stable_stiffness()
            assert found.K[i, j] == pytest.approx(stiffest.K, rel=1e-14)
            assert found.B[i, j] == pytest.approx(stiffest.B, rel=1e-14)
            assert found.frequency_hz[i, j] == pytest.approx(stiffest.frequency_hz, rel=1e-12)
    margin = sweep("delay_margin", scene, K=[500.0, 1000.0], B=5.0).delay_margin
    assert margin.attrs["units"] == "s"
    assert margin[1] == pytest.approx(scene.delay_margin(K=1000.0, B=5.0), rel=1e-12)
    most = sweep("max_delay", scene, K=[500.0, 1000.0], B=5.0).max_delay
    assert most.to_numpy() == pytest.approx(margin.to_numpy() + 1.5e-3, rel=1e-12)
    frequency = np.array([1.0, 200.0])  # theta = 2 pi f T, the angle of a swing in a period
    edge = sweep("stability_boundary", scene, frequency_hz=frequency)
    alone = stability_boundary(2 * np.pi * frequency * 1e-4, 0.0, 0.5 * 1e-4 / 0.1, 15.0)
    assert edge.K.to_numpy() == pytest.approx(alone[0] * 0.1 / 1e-4**2, rel=1e-9)
    plain = sweep("delay_margin", alpha=[0.01], beta=0.05, gamma=0.0, delta=0.0)
    assert plain.delay_margin[0] == pytest.approx(3.969213, abs=1e-6)
    masses = sweep("is_stable", scene, K=[100.0, 4000.0], B=5.0, mass=[0.05, 0.1, 2.0])
    assert masses.is_stable[:, 1].values.tolist() == scene.is_stable([100.0, 4000.0], 5.0).tolist()
    samples = sweep("is_passive", scene, K=[400.0], B=[0.0], delay_samples=[0.0, 15.0])
    assert samples.is_passive.to_numpy().ravel().tolist() == [True, False]


def test_an_arm_counts_for_stability_and_not_for_passivity():
    """(2) and (3): a device of 0.05 to 0.2 kg and 0.5 Ns/m, without delay, in an arm."""
    arm = Arm(mass=0.5, damping=6.0, stiffness=40.0)
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, arm=arm)
    masses = [0.05, 0.1, 0.2]
    stiffest = sweep("max_stable_stiffness", scene, mass=masses)
    for found, mass in zip(stiffest.K.to_numpy(), masses, strict=True):
        both = Scene(mass=mass + 0.5, damping=6.5, stiffness=40.0, sampling_period=1e-3)
        assert found == pytest.approx(both.max_stable_stiffness().K, rel=1e-14)
    assert "0.5 kg, 6 Ns/m, 40 N/m" in stiffest.attrs["arm"]
    # Colgate and Schenkel: b > K T/2 + |B| with the damping of the device
    walls = {"K": [999.0, 1001.0], "B": 0.0}
    assert sweep("is_passive", scene, **walls).is_passive.to_numpy().tolist() == [True, False]
    margin = sweep("passivity_margin", scene, K=400.0, B=0.1, damping=[0.5, 1.0])
    assert margin.passivity_margin.to_numpy() == pytest.approx([0.2, 0.7])
    passive = sweep("max_passive_stiffness", scene, mass=masses)
    assert passive.K.to_numpy() == pytest.approx([1000.0] * 3)
    assert "arm" not in passive.attrs


def test_pint_is_converted_and_checked():
    unit = registry()
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3)
    found = sweep("is_stable", scene, K=[1.0, 2.0] * unit("N/mm"), B=5.0)
    assert found.K.to_numpy().tolist() == [1000.0, 2000.0]
    with pytest.raises(
        ValueError, match=r"^K: .+ is not allowed; give a quantity that converts to N/m$"
    ):
        sweep("is_stable", scene, K=[1.0] * unit("N"), B=5.0)
    with pytest.raises(ValueError, match=r"^gamma: .+; give a number without dimension$"):
        sweep("max_stable_stiffness", gamma=[1.0] * unit("N"), delta=0.0, delay=0.0)


def passive_share(alpha, beta):
    return passivity_margin(alpha, beta, 1.0, 0.0) / (1 + alpha)


def test_a_function_of_ones_own():
    found = sweep(passive_share, alpha=ALPHA[1:], beta=BETA)
    assert np.array_equal(found.passive_share, passive_share(ALPHA[1:, None], BETA))
    assert sweep(is_stable, **WALLS).equals(sweep("is_stable", **WALLS))


def turning(x):
    return x * 1j


def growing(x):
    return np.where(x > 1, 1.5 * x, x) if np.size(x) > 1 else 1


def deciding(x):
    return 2.0 * x if np.size(x) > 1 else x > 1


@pytest.mark.parametrize(
    ("function", "told"),
    [
        (turning, "turning: 1j is not allowed; give real numbers"),
        (growing, "growing: float64 is not allowed; the first point gave int64"),
        (deciding, "deciding: float64 is not allowed; the first point gave bool"),
        (
            lambda x: np.ones(np.shape(x), np.uint8) if np.size(x) > 1 else True,
            "<lambda>: uint8 is not allowed; the first point gave bool",
        ),
        (lambda value: None, "<lambda>: None is not allowed; give real numbers"),
        (
            lambda value: np.uint64(2**63 + 1) + np.zeros(np.shape(value), np.uint64),
            "<lambda>: uint64 is not allowed; the first point gave int64",
        ),
    ],
)
def test_what_a_function_of_ones_own_gives_is_not_cut_to_a_kind(function, told):
    """An imaginary part, a fraction or a sign would be lost."""
    name = next(iter(inspect.signature(function).parameters))
    with pytest.raises(ValueError, match=f"^{re.escape(told)}"):
        sweep(function, **{name: [1.0, 2.2]})


@pytest.mark.parametrize(
    ("function", "told"),
    [
        (lambda a: (a,) * (1 + int(a.max())), "gives 3 results at some points, and 1 at the first"),
        (lambda a: (a,) * (3 - int(a.max())), "gives 1 results at some points, and 3 at the first"),
        (lambda a: (), "returns nothing; give it a result"),
    ],
)
def test_a_function_gives_as_many_results_everywhere(function, told):
    """None is left out, and none is missed."""

    def mine(a):
        return function(np.asarray(a))

    with pytest.raises(ValueError, match=rf"^quantity: mine {told}"):
        sweep(mine, a=[0.0, 2.0], chunks=1)


def test_unsigned_numbers_that_signed_ones_hold_are_kept():
    found = sweep(lambda x: np.asarray(x).astype(np.uint64 if np.size(x) > 1 else int), x=[1, 7])
    assert found["<lambda>"].to_numpy().tolist() == [1, 7]


def test_what_a_function_of_ones_own_masks_is_nan():
    found = sweep(lambda x: np.ma.array(x, mask=np.asarray(x) > 1), x=[1.0, 2.0])["<lambda>"]
    assert np.array_equal(found, [1.0, np.nan], equal_nan=True)


WRONG = """
import multiprocessing, time
import numpy as np
from symhaptic import sweep

def mine(alpha):
    if multiprocessing.parent_process() is not None:
        time.sleep(1 if alpha.ravel()[0] > 0 else 900)
        raise ArithmeticError("mine")
    return alpha

if __name__ == "__main__":
    sweep(mine, alpha=np.array([0.0, 1.0]), on="processes", workers=2, chunks=1)
"""


def test_an_error_ends_the_other_processes_at_once(tmp_path):
    """One block is wrong after a second; the other one would go on for 15 minutes."""
    program = tmp_path / "program.py"
    program.write_text(WRONG)
    run = subprocess.run(
        [sys.executable, program], capture_output=True, text=True, timeout=1200, check=False
    )
    assert run.returncode == 1
    assert run.stderr.endswith("ArithmeticError: mine\n")


BAR = """
import numpy as np
from symhaptic import sweep

found = sweep("is_stable", alpha=np.linspace(0, 1, 20), beta=1.0, gamma=0.0, delta=0.0, delay=0.0,
              chunks=1)
print(found.is_stable.size)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo terminals")
def test_a_function_that_is_another_one_in_a_worker_process_is_refused(tmp_path):
    """A worker imports the program anew: what is set later is not set there."""
    program = tmp_path / "mine.py"
    program.write_text(
        "import sys\nfrom symhaptic import sweep\nGAIN, KNOWN = 2.0, {}\n"
        "def mine(alpha):\n    KNOWN[len(KNOWN)] = alpha\n    return GAIN * alpha\n"
        "if __name__ == '__main__':\n    GAIN = float(sys.argv[1])\n    try:\n"
        "        found = sweep(mine, alpha=[0.0, 1.0], on='processes', workers=1, chunks=1)\n"
        "        print(found.mine.values.tolist())\n"
        "    except ValueError as wrong:\n        print(wrong)\n"
    )

    def told(gain):
        command = [sys.executable, str(program), gain]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    assert told("2.0") == "[0.0, 2.0]\n"
    assert told("5.0").startswith("on: mine is another function in a worker process, which")


def test_a_terminal_has_a_bar_of_errors_which_is_gone_at_the_end():
    """On standard error alone: what a program prints stays as it is."""
    import pty

    terminal, end = pty.openpty()
    told = {**os.environ, "TERM": "xterm", "COLUMNS": "80"}
    command = [sys.executable, "-c", BAR]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=end, env=told) as run:
        os.close(end)
        seen = b""
        with suppress(OSError):  # the end of a terminal
            while more := os.read(terminal, 1024):
                seen += more
        assert run.stdout.read() == b"20\n"
    os.close(terminal)
    assert run.returncode == 0
    assert b"sweep" in seen
    assert b"20/20" in seen
    assert seen.endswith(b"\x1b[2K")  # the line is empty again


def test_threads_processes_and_executors_give_the_same_bits():
    few = {**WALLS, "over": ("gamma",), "reduce": "mean", "chunks": 1500}
    alone = sweep("is_stable", workers=1, **few)
    assert alone.identical(sweep("is_stable", workers=3, **few))
    assert alone.identical(sweep("is_stable", on="processes", workers=2, **few))
    with ThreadPoolExecutor(2) as pool:
        assert alone.identical(sweep("is_stable", on=pool, **few))
        assert pool.submit(int).result() == 0  # still open
    assert alone.identical(sweep("is_stable", lazy=True, **few).compute())


def test_what_does_not_fit_stays_lazy(monkeypatch):
    """Any part of it is computed when it is asked for."""
    system = pytest.importorskip("distributed.system", reason="no dask.distributed here")
    monkeypatch.setattr(system, "MEMORY_LIMIT", 10**9)
    many = np.linspace(0, 0.5, 10**5)
    found = sweep("is_stable", alpha=many, beta=many, gamma=0.0, delta=0.01, delay=1.0)
    assert found.is_stable.nbytes == 10**10
    part = found.is_stable[40_000, 40_000:40_003].compute(scheduler="sync")
    wanted = is_stable(many[40_000], many[40_000:40_003], 0.0, 0.01, 1.0)
    assert part.to_numpy().tolist() == wanted.tolist()


@pytest.mark.parametrize("name", QUANTITIES)
def test_quantities_are_public_and_name_their_statement(name):
    from symhaptic.book.sources import STATEMENTS

    known = QUANTITIES[name]
    assert symhaptic._HOME[name] == f"symhaptic.{known.home}"
    rows = {n: [0.1, 0.2] if n == "theta" else 0.01 for n in sweep_arguments(name)}
    found = sweep(name, **rows)
    assert len(found.data_vars) == len(known.results)
    assert ledger_has(known.statement, STATEMENTS)
    assert known.statement in FORMS.get(name, (known.statement,))
    for result in known.results:
        assert found[result.name].dtype == result.kind
        assert found[result.name].attrs["long_name"]


def sweep_arguments(name):
    from symhaptic.sweeps.quantities import work_of

    return work_of(name, {}, None).arguments


def ledger_has(id, statements):
    ledger = json.loads((symhaptic_root() / "reports" / "ledger.json").read_text("utf-8"))
    return id in statements or id in json.dumps(ledger)


def symhaptic_root():
    from pathlib import Path

    return Path(__file__).parents[2]


def labelled(values, **labels):
    """An array along x, with coordinates."""
    return xarray.DataArray(values, dims="x", coords={n: ("x", v) for n, v in labels.items()})


REFUSED = [
    ({"alhpa": 1.0}, r"^alhpa: this quantity has no such argument; did you mean 'alpha'"),
    ({"alpha": []}, r"^alpha: no values are not allowed"),
    ({"gamma": [0.1, -0.2]}, r"^gamma: -0.2 is not allowed"),
    ({"alpha": np.zeros((2, 2))}, r"^alpha: 2 dimensions are not allowed"),
    ({"alpha": np.ma.MaskedArray([1.0], mask=[True])}, r"^alpha: .+without masks"),
    ({"over": "gama", "reduce": "all"}, r"^over: 'gama' is not allowed"),
    ({"over": "gamma"}, r"^over: .+both or neither"),
    ({"over": "gamma", "reduce": "min"}, r"^reduce: 'min' of is_stable is not allowed"),
    ({"over": "gamma", "reduce": "median"}, r"^reduce: 'median' is not allowed"),
    ({"over": ("gamma", "gamma"), "reduce": "all"}, r"^over: .+ each dimension once"),
    ({"alpha": xarray.Variable("x", [0.1])}, r"^alpha: .+ xarray's DataArrays"),
    ({"alpha": xarray.DataArray([0.1], dims="is_stable")}, r"^is_stable: a result has the name"),
    ({"alpha": labelled([0.1, 0.2], x=[1, 2]), "beta": labelled([0.1, 0.2], x=[2, 1])},
     r"^beta: its labels 'x' are not allowed; another argument has others"),
    ({"alpha": labelled([0.1, 0.2], x=[1, 2], beta=[3, 4]), "beta": 0.4},
     r"^beta: its labels 'beta' are not allowed; another argument has others"),
    ({"chunks": 0}, r"^chunks: 0 is not allowed"),
    ({"chunks": {"x": 1}}, r"^chunks: 'x' is not allowed"),
    ({"on": "clouds"}, r"^on: 'clouds' is not allowed"),
    ({"to": "here.csv"}, r"^to: 'here.csv' is not allowed"),
    ({"to": "here.zarr", "lazy": True}, r"^lazy: True and to="),
]  # fmt: skip


@pytest.mark.parametrize(("words", "told"), REFUSED)
def test_what_cannot_be_is_refused_on_one_line(words, told):
    with pytest.raises(ValueError, match=told) as caught:
        sweep("is_stable", **{**WALLS, **words})
    assert "\n" not in str(caught.value)


def test_words_go_to_the_function():
    axes = {"gamma": 0.0, "delta": 0.02, "delay": [0.5, 1.5]}
    found = sweep("max_stable_stiffness", sheet="principal", **axes)
    wanted = max_stable_stiffness(0.0, 0.02, [0.5, 1.5], sheet="principal").alpha
    assert np.array_equal(found.alpha, wanted)
    assert found.attrs["sheet"] == "principal"
    with pytest.raises(ValueError, match=r"^sheet: 'x' is not allowed"):
        sweep("max_stable_stiffness", sheet="x", **axes)


def test_other_mistakes():
    with pytest.raises(ValueError, match=r"^quantity: 'is_stabel' is not allowed; did you mean"):
        sweep("is_stabel")
    with pytest.raises(ValueError, match=r"^delta: is missing; max_stable_stiffness takes"):
        sweep("max_stable_stiffness", gamma=0.0, delay=1.0)
    with pytest.raises(ValueError, match=r"^scene: your function"):
        sweep(passive_share, Scene(mass=1.0, sampling_period=1.0), alpha=1.0, beta=1.0)
    one = xarray.DataArray([0.1, 0.2], dims="x")
    with pytest.raises(ValueError, match=r"^beta: 3 values along 'x' are not allowed; give 2"):
        sweep("is_stable", **{**WALLS, "alpha": one, "beta": xarray.DataArray([1, 2, 3], dims="x")})
    with pytest.raises(ValueError, match=r"^mass: 0.0 is not allowed"):
        sweep("is_stable", Scene(mass=1.0, sampling_period=1.0), K=1.0, B=1.0, mass=[0.0])


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"K": "1"}, "K: '1' is not allowed; give a number and a unit"),
        ({"sheet": 3}, "sheet: 3 is not allowed; give 'exact' or 'principal'"),
        ({"sheets": "exact"}, "sheets: this quantity has no such argument; give one of K, B"),
        ({"scene": "device"}, "scene: 'device' is not allowed; give a Scene"),
        ({"over": 3, "reduce": "all"}, "over: 3 is not allowed; give a word or several"),
        ({"over": "K", "reduce": [3]}, r"reduce: \[3\] is not allowed; give a word or several"),
        ({"workers": 0}, "workers: 0 is not allowed; give whole numbers > 0"),
        ({"workers": 1.5}, "workers: 1.5 is not allowed; give whole numbers > 0"),
    ],
)
def test_what_is_given_is_named_and_not_called_missing(arguments, said):
    scene = Scene(mass=1.0, sampling_period=1.0)
    with pytest.raises(ValueError, match=f"^{said}"):
        sweep("is_stable", **{"scene": scene, "K": [1.0], "B": 1.0, **arguments})


def test_a_delay_of_nan_spoils_its_own_wall_only():
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3)
    found = sweep("max_stable_stiffness", scene, delay=[np.nan, 0.001]).K.values
    assert np.isnan(found[0])
    assert found[1] == sweep("max_stable_stiffness", scene, delay=0.001).K.values
    assert not sweep("is_stable", scene, K=1.0, B=1.0, delay=np.nan).is_stable


def test_a_bar_on_a_terminal_only(capsys, monkeypatch):
    sweep("is_stable", chunks=1000, **WALLS)
    assert capsys.readouterr() == ("", "")
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    sweep("is_stable", chunks=1000, **WALLS)
    out, err = capsys.readouterr()
    assert out == ""
    assert "sweep" in err


def test_importing_the_package_loads_nothing_of_it():
    program = (
        "import sys, symhaptic; dir(symhaptic);"
        "print([n for n in ('xarray', 'dask', 'zarr', 'symhaptic.sweeps') if n in sys.modules])"
    )
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)
    assert told.stdout.split() == [b"[]"]


WALL = {"K": 1.0, "B": 1.0}
OF_A_SCENE = [
    ("is_stable", {**WALL, "stiffness": [1e30, 1.0]}, "^stiffness: gamma = 1e+25 is not allowed"),
    ("is_stable", {**WALL, "mass": [1e-90, 1.0]}, "^K: alpha = 1e+84 is not allowed"),
    ("is_passive", {**WALL, "damping": 1e90}, "^damping: delta = 1e+88 is not allowed"),
    ("stability_boundary", {"frequency_hz": [0.0, 9.0]}, "^frequency_hz: theta = 0.0 is not"),
]


@pytest.mark.parametrize(("quantity", "axes", "told"), OF_A_SCENE)
def test_of_a_scene_what_cannot_be_is_told_by_what_was_given(quantity, axes, told):
    scene = Scene(mass=0.1, sampling_period=1e-3)
    with pytest.raises(ValueError, match=told.replace("+", r"\+")):
        sweep(quantity, scene, **axes)


def test_limits_over_the_damping_are_those_of_the_scene():
    """The K-B chart of a device, and of several delays."""
    device = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, delay=1.5e-3)
    B = np.array([0.0, 5.0, 50.0, 500.0])
    chart = sweep("limit_at", device, B=B)
    limits = device.limit_at(B)
    assert chart.K.attrs["units"] == "N/m"
    assert chart.K.values == pytest.approx(limits.K, nan_ok=True)
    assert chart.frequency_hz.values == pytest.approx(limits.frequency_hz, nan_ok=True)
    assert chart.equals(sweep("max_stable_stiffness", device, B=["0 Ns/m", "5 Ns/m", 50.0, 500.0]))
    several = sweep("limit_at", device, B=B, delay=["0 ms", "1.5 ms"])
    assert several.K.sel(delay=1.5e-3).values == pytest.approx(chart.K.values, nan_ok=True)
    plain = sweep("max_stable_stiffness", beta=[0.4, 1.0], gamma=0.0, delta=0.0, delay=0)
    assert plain.alpha.values == pytest.approx([2 * b * (2 - b) / (2 + b) for b in (0.4, 1.0)])


def test_a_rotary_scene_is_swept_in_its_units(tmp_path):
    knob = Scene(inertia=1e-4, damping=2e-3, sampling_period=1e-3)
    line = Scene(mass=1e-4, damping=2e-3, sampling_period=1e-3)
    found = sweep(
        "max_stable_stiffness", knob, inertia=["1 g cm^2", "1e-4 kg m^2"], delay=[0, 1e-3]
    )
    alike = sweep("max_stable_stiffness", line, mass=[1e-7, 1e-4], delay=[0, 1e-3])
    assert found.K.values.tolist() == alike.K.values.tolist()
    assert (found.K.attrs["units"], found.B.attrs["units"]) == ("N m/rad", "N m s/rad")
    assert found.inertia.attrs["units"] == "kg m^2"
    held = knob.held_by(Arm(inertia=1e-4))
    walls = sweep("is_stable", held, K=["0.5 N m/turn", "1 N m/deg"], B="1 mN m s/deg")
    assert walls.is_stable.values.tolist() == [
        bool(held.is_stable(K, "1 mN m s/deg")) for K in ("0.5 N m/turn", "1 N m/deg")
    ]
    stored = sweep("passivity_margin", knob, K=[0.1, 1.0], B=0.0, to=tmp_path / "knob.parquet")
    assert stored.passivity_margin.attrs["units"] == "N m s/rad"
    with pytest.raises(ValueError, match="mass: this quantity has no such argument; "):
        sweep("limit_at", knob, B=[0.0], mass=[1.0])
    with pytest.raises(ValueError, match="K: '1 N/m' is not allowed; give a number and a unit"):
        sweep("is_stable", knob, K="1 N/m", B=0.0)


def test_a_bar_of_a_sweep_that_goes_on_begins_where_it_was(capsys, monkeypatch):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    with ThreadPoolExecutor(1) as pool:
        assert sorted(work.done(pool, str, [1, 2], 2, 5)) == ["1", "2"]
    assert "3/5" in capsys.readouterr().err


@pytest.mark.parametrize("shape", [(7,), (50, 40, 3), (3, 40, 50), (9, 1, 8, 7)])
@pytest.mark.parametrize("points", [1, 10, 1000])
def test_blocks_have_at_most_so_many_points_and_more_than_a_quarter(shape, points):
    """Equal parts of each dimension: two of them are more than the rest that is left over."""
    lengths = lengths_of(dict(zip("abcd", shape, strict=False)), {}, points)
    assert math.prod(lengths) <= points
    assert math.prod(lengths) > points / 4 ** len(shape) or lengths == shape
    assert all(1 <= length <= n for length, n in zip(lengths, shape, strict=True))
