"""The generated kernels on NumPy arrays beside the exported C, and public functions beside kernels.

`.venv/bin/pytest benchmarks/test_kernels.py --benchmark-only -s`; ratios within one run count,
since the machine is shared.
"""

import ctypes
import shutil
import statistics
import subprocess
import time

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
    "passivity_margin": 10, "max_stable_stiffness": 10, "max_passive_stiffness": 10,
}  # fmt: skip
"""What one call may take, in microseconds."""


@pytest.mark.parametrize("name", PUBLIC)
def test_public_functions_beside_c(benchmark, compiled, name):
    """Arrays beside the exported C in a plain loop, and one call with floats; all checked."""
    if symhaptic.numeric.compiled.MODULE is None:
        pytest.skip("the install found no compiler")
    form, function = FORMS[name], getattr(symhaptic, name)
    columns = [COLUMNS[s.name] for s in form.arguments]
    if name == "max_stable_stiffness":
        columns = [columns[0] / 10, *columns[1:]]  # where its kernel has an answer
    out = np.empty((len(form.results), COUNT))
    pointers = [ctypes.c_void_p(c.ctypes.data) for c in (*columns, out)]
    loop = getattr(compiled, f"loop_{name}")
    found = benchmark.pedantic(function, columns, rounds=1)
    assert found is not None
    quick = seconds(lambda: loop(ctypes.c_long(COUNT), *pointers))
    ours = seconds(lambda: function(*columns))
    one = [float(c[0]) for c in columns]
    call = seconds(lambda: [function(*one) for _ in range(1000)]) / 1000
    print(
        f"\n    {name}: arrays {ours / quick:.2f} times C (goal 1.1), "
        f"one call {1e6 * call:.1f} us (goal {PUBLIC[name]})",
        end="",
    )


def test_one_wall_beside_scipy(benchmark):
    """SciPy samples the device, NumPy finds the roots: what is done without the package."""
    gamma, delta, alpha, beta, delay = 0.1, 0.2, 0.3, 0.4, 2

    def by_scipy():
        num, den, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0)
        wall = np.array([alpha + beta, -beta])
        p = np.concatenate([den, np.zeros(delay + 1)])
        p[-3:] += np.convolve(num.ravel()[1:], wall)
        return np.abs(np.roots(p)).max() < 1

    def by_us():
        return symhaptic.is_stable(alpha, beta, gamma, delta, float(delay))

    assert by_scipy() == benchmark(by_us)
    theirs = seconds(lambda: [by_scipy() for _ in range(200)]) / 200
    ours = seconds(lambda: [by_us() for _ in range(200)]) / 200
    print(
        f"\n    is_stable: SciPy and NumPy {1e6 * theirs:.0f} us, the package {1e6 * ours:.1f} us, "
        f"ratio {theirs / ours:.0f}",
        end="",
    )
