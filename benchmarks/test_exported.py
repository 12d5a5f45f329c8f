"""Exported C beside the same algorithms written by hand for speed, both with gcc -O2.

`.venv/bin/pytest benchmarks/test_exported.py --benchmark-only -s`; the ratio of the best of many
turns counts, since the machine is shared.
"""

import ctypes
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest

from symhaptic.export import request
from symhaptic.export.targets import TARGETS

COUNT = 1024
ROUNDS = 200
RNG = np.random.default_rng(0)
FORMS = ("discretize", "stability_boundary", "passivity_margin_at", "is_stable")

PLANTS = {
    "slow": (RNG.uniform(0, 1e-3, COUNT), RNG.uniform(0, 0.02, COUNT)),
    "ordinary": (RNG.uniform(0, 4, COUNT), RNG.uniform(0, 2, COUNT)),
    "swinging": (RNG.uniform(4, 40, COUNT), RNG.uniform(0, 3, COUNT)),
    "creeping": (RNG.uniform(0, 1, COUNT), RNG.uniform(3, 60, COUNT)),
}
OTHERS = {
    "theta": RNG.uniform(0.01, 3.1, COUNT),
    "alpha": RNG.uniform(-0.1, 0.5, COUNT),
    "beta": RNG.uniform(-0.2, 0.5, COUNT),
    "d": RNG.integers(0, 9, COUNT).astype(float),
}


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """Each function in a loop of its own, exported and by hand, in one shared library."""
    folder = tmp_path_factory.mktemp("exported")
    forms = request.chosen(FORMS)
    _, files = request.built(TARGETS["c"], forms, vectors=False)
    for name, text in files.items():
        (folder / name).write_text(text)
    (folder / "hand.c").write_text((Path(__file__).parent / "hand_written.c").read_text())
    for kind, source in (("haptic", "haptic.c"), ("hand", "hand.c")):
        lines = [f'#include "{source}"']
        for form in forms:
            args = [f"const double *{s.name}" for s in form.arguments]
            given = [f"{s.name}[k]" for s in form.arguments]
            outs = [f"y{i}" for i in range(len(form.results))]
            call = f"{kind}_{form.name}"
            single = len(outs) == 1
            inner = ", ".join(given if single else [*given, *(f"{y} + k" for y in outs)])
            body = f"y0[k] = {call}({inner})" if single else f"{call}({inner})"
            lines.append(
                f"void all_{call}(long n, {', '.join([*args, *(f'double *{y}' for y in outs)])}) "
                f"{{ for (long k = 0; k < n; ++k) {body}; }}"
            )
        (folder / f"{kind}_loops.c").write_text("\n".join(lines))
    sources = [folder / "haptic_loops.c", folder / "hand_loops.c"]
    made = folder / "exported.so"
    command = ["gcc", "-std=c99", "-O2", "-shared", "-fPIC", "-o", made, *sources, "-lm"]
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(made))


@pytest.mark.parametrize("plant", PLANTS)
@pytest.mark.parametrize("name", FORMS)
def test_exported_beside_hand_written(benchmark, library, name, plant):
    """The same values, and the ratio of times; both take turns."""
    (form,) = request.chosen([name])
    at = {**OTHERS, **dict(zip(("gamma", "delta"), PLANTS[plant], strict=True))}
    calls, found, times = {}, {}, {"haptic": [], "hand": []}
    for kind in times:
        outs = [np.empty(COUNT) for _ in form.results]
        arrays = [np.ascontiguousarray(at[s.name]) for s in form.arguments]
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (*arrays, *outs)]
        function = getattr(library, f"all_{kind}_{name}")
        calls[kind], found[kind] = (function, pointers, arrays), outs
    for _ in range(ROUNDS):
        for kind, (function, pointers, _) in calls.items():
            begin = time.perf_counter()
            function(ctypes.c_long(COUNT), *pointers)
            times[kind].append((time.perf_counter() - begin) / COUNT)
    for ours, theirs in zip(found["haptic"], found["hand"], strict=True):
        np.testing.assert_allclose(ours, theirs, rtol=1e-9, atol=1e-13)
    function, pointers, _ = calls["haptic"]
    benchmark.pedantic(function, (ctypes.c_long(COUNT), *pointers), rounds=5)
    ours, theirs = (min(times[kind]) for kind in ("haptic", "hand"))
    benchmark.extra_info["ratio"] = round(ours / theirs, 2)
    print(
        f"\n    {name}, {plant}: exported {1e9 * ours:.0f} ns, by hand {1e9 * theirs:.0f} ns, "
        f"ratio {ours / theirs:.2f}",
        end="",
    )
