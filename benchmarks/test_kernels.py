"""The generated kernels on NumPy arrays beside the exported C, and public functions beside kernels.

`.venv/bin/pytest benchmarks/test_kernels.py --benchmark-only -s`; ratios within one run count,
since the machine is shared.
"""

import ctypes
import shutil
import statistics
import subprocess
import time
import timeit
from concurrent.futures import ThreadPoolExecutor
from functools import partial

import numpy as np
import pytest
from scipy.signal import cont2discrete

import symhaptic
import symhaptic.numeric.compiled
from symhaptic.export import kernels, request
from symhaptic.export.targets import TARGETS
from symhaptic.kernels import haptic

COUNT = 10**5
GOAL = 3
"""Times the time of C."""
RNG = np.random.default_rng(0)
COLUMNS = {
    "theta": RNG.uniform(0.01, 1.04, COUNT),  # below pi/(d + 1), where all of them mean something
    "alpha": RNG.normal(size=COUNT),
    "beta": RNG.normal(size=COUNT),
    "gamma": RNG.uniform(0, 10, COUNT),
    "delta": RNG.uniform(0, 2, COUNT),
    "d": np.full(COUNT, 2.0),
    "epsilon": RNG.uniform(0, 1, COUNT),
}
FORMS = {form.name: form for form in kernels.forms()}


def seconds(work, rounds=9):
    """Median time of a call, that of others on this processor not counted."""
    times = []
    for _ in range(rounds):
        begin = time.process_time()
        work()
        times.append(time.process_time() - begin)
    return statistics.median(times)


def say(text):
    print(f"\n    {text}", end="")


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    """The exported C with a loop over each function, by gcc -O2."""
    if shutil.which("gcc") is None:
        pytest.skip("no gcc here: nothing to compare with")
    folder = tmp_path_factory.mktemp("c")
    made, files = request.built(TARGETS["c"], list(FORMS.values()), vectors=False)
    loops = ['#include "haptic.h"']
    for routine in made.public:
        names = [s.name for s in routine.arguments]
        given = ", ".join(f"{n}[i]" for n in names)
        outs = [f"out + {k}*count + i" for k in range(len(routine.results))]
        call = f"haptic_{routine.name}({given}"
        call = f"{call}, {', '.join(outs)});" if len(outs) > 1 else f"out[i] = {call});"
        pointers = ", ".join(f"const double *{n}" for n in names)
        head = f"void loop_{routine.name}(long count, {pointers}, double *out)"
        loops.append(f"{head} {{ for (long i = 0; i < count; ++i) {call} }}")
    for name, text in (files | {"loops.c": "\n".join(loops)}).items():
        (folder / name).write_text(text, encoding="utf-8")
    subprocess.run(
        ["gcc", "-O2", "-shared", "-fPIC", "-o", "all.so", "haptic.c", "loops.c", "-lm"],
        cwd=folder,
        check=True,
    )
    return ctypes.CDLL(str(folder / "all.so"))


@pytest.mark.parametrize("name", FORMS)
def test_numpy_beside_c(benchmark, compiled, name):
    form = FORMS[name]
    columns = [COLUMNS[s.name] for s in form.arguments]
    out = np.empty((len(form.results), COUNT))
    pointers = [ctypes.c_void_p(c.ctypes.data) for c in (*columns, out)]
    loop = getattr(compiled, f"loop_{name}")
    quick = seconds(lambda: loop(ctypes.c_long(COUNT), *pointers))
    found = benchmark.pedantic(getattr(haptic, name), columns, rounds=1)
    slow = seconds(lambda: getattr(haptic, name)(*columns))
    last = 8 * 2**-52  # eight last places of terms of size one, where a result passes through zero
    assert np.allclose(np.stack(np.atleast_2d(found)), out, rtol=1e-13, atol=last, equal_nan=True)
    benchmark.extra_info["times slower than C"] = round(slow / quick, 2)
    print(
        f"\n    {name}: C {1e9 * quick / COUNT:.0f} ns, NumPy {1e9 * slow / COUNT:.0f} ns, "
        f"ratio {slow / quick:.2f}, goal {GOAL}",
        end="",
    )


@pytest.mark.parametrize("name", ["discretize", "stability_boundary", "is_stable", "linear_limit"])
def test_public_functions_beside_kernels(benchmark, name):
    """What checking the arguments costs."""
    columns = [COLUMNS[s.name] for s in FORMS[name].arguments]
    bare = seconds(lambda: getattr(haptic, name)(*columns))
    benchmark.pedantic(getattr(symhaptic, name), columns, rounds=1)
    ratio = seconds(lambda: getattr(symhaptic, name)(*columns)) / bare
    benchmark.extra_info["times the kernel"] = round(ratio, 2)
    print(f"\n    {name}: {ratio:.2f} times the kernel", end="")


PUBLIC = {
    "discretize": 3, "is_stable": 3, "stability_boundary": 3, "linear_limit": 3,
    "passivity_margin_at": 3, "discretize_fractional": 3, "unstable_roots": 3,
    "passivity_margin": 10, "max_stable_stiffness": 10, "max_passive_stiffness": 10,
    "passivity_boundary": 10,
}  # fmt: skip
"""What one call may take, in microseconds."""


@pytest.mark.parametrize("name", PUBLIC)
def test_public_functions_beside_c(benchmark, compiled, name):
    """Arrays beside the exported C in a plain loop, and one call with floats; all checked.

    The loop writes to the same place each time, the function to memory that it is given: once that
    of an allocator which has kept some, and once fresh from the system.
    """
    if symhaptic.numeric.compiled.MODULE is None:
        pytest.skip("the install found no compiler")
    form, function = FORMS[name], getattr(symhaptic, name)
    columns = [COLUMNS[s.name] for s in form.arguments]
    if name == "max_stable_stiffness":
        columns = [columns[0] / 10, *columns[1:]]  # where its kernel has an answer
    loop = getattr(compiled, f"loop_{name}")
    ratios = []
    for count in (COUNT // 10, COUNT):
        rows = [np.ascontiguousarray(c[:count]) for c in columns]
        out = np.empty((len(form.results), count))
        pointers = [ctypes.c_void_p(c.ctypes.data) for c in (*rows, out)]
        bare = partial(loop, ctypes.c_long(count), *pointers)
        ratios.append(in_turns(partial(function, *rows), bare))
    benchmark.pedantic(function, columns, rounds=1)
    one = [float(c[0]) for c in columns]
    call = seconds(lambda: [function(*one) for _ in range(1000)]) / 1000
    say(
        f"{name}: 10^4 elements {ratios[0]:.2f} times C, 10^5 {ratios[1]:.2f} (goal 1.1), "
        f"one call {1e6 * call:.1f} us (goal {PUBLIC[name]})"
    )


def in_turns(one, other, rounds=60):
    """The ratio of the two's times, the best of many turns, since the machine is shared."""
    turns = [(seconds(one, 1), seconds(other, 1)) for _ in range(rounds)]
    return min(first for first, _ in turns) / min(second for _, second in turns)


@pytest.mark.parametrize("name", ["NumPy's tan", "is_stable", "max_stable_stiffness"])
def test_two_threads(benchmark, name):
    """Halves of an array: the lock is released, so that two cores work; NumPy's own beside it."""
    if name in FORMS:
        columns = [COLUMNS[s.name] for s in FORMS[name].arguments]
        function = getattr(symhaptic, name)
    else:
        columns, function = [np.tile(COLUMNS["gamma"], 10)], np.tan
    if name == "max_stable_stiffness":
        columns = [columns[0] / 10, *columns[1:]]
    columns = [np.tile(c, 3) for c in columns]
    halves = [[np.array_split(c, 2)[i] for c in columns] for i in range(2)]

    def times(work):
        begin, used = time.perf_counter(), time.process_time()
        work()
        return time.perf_counter() - begin, time.process_time() - used

    with ThreadPoolExecutor(2) as pool:
        pair = lambda: list(pool.map(lambda half: function(*half), halves))  # noqa: E731
        alone = lambda: [function(*half) for half in halves]  # noqa: E731
        found = [(times(alone), times(pair)) for _ in range(15)]
    benchmark.pedantic(alone, rounds=1)
    clock = sorted(one[0] / two[0] for one, two in found)
    work = statistics.median(two[1] / one[1] for one, two in found)
    say(
        f"{name}: two threads {clock[7]:.2f} times as fast as one ({clock[0]:.2f} to "
        f"{clock[-1]:.2f}; goal 1.8), {work:.2f} times the processor time"
    )


ONE = {"gamma": 0.1, "delta": 0.2, "alpha": 0.3, "beta": 0.4, "d": 2.0, "theta": 0.7}
"""A wall behind two periods of delay; its device swings once in twenty periods."""

INSIDE = {**ONE, "gamma": 0.001, "delta": 0.02, "alpha": 0.03, "beta": 0.1}
"""The device at the end of the paper's range (23)."""


def polynomial(n1, n0, a, e, alpha, beta, delay):
    found = np.concatenate([[1.0, -a, e], np.zeros(int(delay) + 1)])
    found[-3:] += np.convolve([n1, n0], [alpha + beta, -beta])
    return found


def by_scipy(name, at):
    """Sampled by SciPy; roots and answers at one angle by NumPy."""
    num, den, _ = cont2discrete(([1.0], [1.0, at["delta"], at["gamma"]]), 1.0)
    sampled = (*num.ravel()[1:], -den[1], den[2])
    if name == "discretize":
        return sampled
    if name == "is_stable":
        roots = np.roots(polynomial(*sampled, at["alpha"], at["beta"], at["d"]))
        return np.abs(roots).max() < 1
    z = np.exp(1j * at["theta"])
    q = -(z ** at["d"]) * np.polyval(den, z) / np.polyval(num.ravel(), z)
    beta = q.imag / np.sin(at["theta"])
    return q.real - beta * (1 - np.cos(at["theta"])), beta


def by_control(name, at):
    """The same by python-control, as its guide has it."""
    control = pytest.importorskip("control", reason="no python-control here: not compared")
    device = control.sample_system(control.tf([1], [1, at["delta"], at["gamma"]]), 1.0, "zoh")
    num, den = device.num[0][0], device.den[0][0]
    if name == "discretize":
        return (*num[-2:], -den[1], den[2])
    if name == "is_stable":
        wall = [at["alpha"] + at["beta"], -at["beta"]]
        loop = control.feedback(device, control.tf(wall, [1] + [0] * (int(at["d"]) + 1), 1.0))
        return np.abs(loop.poles()).max() < 1
    late = control.tf([1], [1] + [0] * int(at["d"]), 1.0)
    q = -1 / (device * late)(np.exp(1j * at["theta"]))
    beta = q.imag / np.sin(at["theta"])
    return q.real - beta * (1 - np.cos(at["theta"])), beta


PEERS = {"SciPy": (by_scipy, 100), "python-control": (by_control, 1000)}


@pytest.mark.parametrize("name", ["discretize", "is_stable", "stability_boundary"])
@pytest.mark.parametrize("peer", PEERS)
@pytest.mark.parametrize("at", [INSIDE, ONE], ids=["of (23)", "swinging"])
def test_one_wall_beside_peers(benchmark, at, peer, name):
    """From the plant's parameters to the answer, the best of many turns on the clock."""
    work, goal = PEERS[peer]
    given = [at[s.name] for s in FORMS[name].arguments]
    function = getattr(symhaptic, name)
    assert np.allclose(work(name, at), benchmark.pedantic(function, given, rounds=1))
    slow, quick = [], []
    known = {"work": work, "name": name, "at": at, "function": function, "given": given}
    for _ in range(30):
        slow.append(timeit.timeit("work(name, at)", number=5, globals=known) / 5)
        quick.append(timeit.timeit("function(*given)", number=500, globals=known) / 500)
    device = f"gamma {at['gamma']:g}, delta {at['delta']:g}"
    say(
        f"{name} of {device}: {peer} {1e6 * min(slow):.0f} us, "
        f"the package {1e6 * min(quick):.2f} us, ratio {min(slow) / min(quick):.0f} (goal {goal})"
    )
