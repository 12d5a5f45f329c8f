"""JAX and PyTorch on every device that is there: what compiling takes, and an element then.

`python benchmarks/arrays.py 1000000` asks for so many elements of each function, in double
precision and in single, beside the compiled ufunc on one core.  Each library is a process of its
own.  Where there is no GPU only the processor is measured, and the table says so.
"""

import subprocess
import sys
import time

import numpy as np

import symhaptic
from symhaptic.export import kernels

RNG = np.random.default_rng(0)
RANGES = {
    "theta": (0.01, 1.04), "alpha": (0.0, 0.1), "beta": (0.0, 0.5), "gamma": (0.0, 1e-3),
    "delta": (1e-3, 0.02), "epsilon": (0.0, 0.9),
}  # fmt: skip
"""Devices inside (23) of the paper and walls that most of them bear; delays of 0 to 5 periods."""

FUNCTIONS = [form for form in kernels.forms() if hasattr(symhaptic, form.name)]


def columns(form, count, fractions):
    """So many arguments of a function."""
    delay = RNG.integers(0, 6, count) + (0.5 if fractions else 0.0)
    return [delay if s.name == "d" else RNG.uniform(*RANGES[s.name], count) for s in form.arguments]


def clock(work, rounds=5):
    """The shortest of some calls on the clock, after one that is not counted."""
    work()
    times = []
    for _ in range(rounds):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


def by_jax(count):
    """Every device that JAX knows: functions under jit."""
    import jax

    jax.config.update("jax_enable_x64", True)
    places = {d.platform: d for d in (*jax.devices("cpu"), *jax.devices())}

    def row(form, place, kind, given):
        arrays = [jax.device_put(v.astype(kind), places[place]) for v in given]
        function = jax.jit(getattr(symhaptic, form.name))
        begin = time.perf_counter()
        made = function.lower(*arrays).compile()
        compiled = time.perf_counter() - begin
        return compiled, clock(lambda: jax.block_until_ready(made(*arrays)))

    return places, row


def by_torch(count):
    """The processor, and the first CUDA device where there is one: functions called as they are."""
    import torch

    places = ["cpu", *(["cuda"] if torch.cuda.is_available() else [])]

    def row(form, place, kind, given):
        arrays = [torch.as_tensor(v.astype(kind), device=place) for v in given]
        function = getattr(symhaptic, form.name)

        def work():
            function(*arrays)
            if place == "cuda":
                torch.cuda.synchronize()

        return 0.0, clock(work, 3)

    return places, row


LIBRARIES = {"jax": by_jax, "torch": by_torch}


def measured(library, count, wanted):
    """One line for each function, device and precision."""
    places, row = LIBRARIES[library](count)
    for form in FUNCTIONS:
        if wanted and form.name not in wanted:
            continue
        late = any(s.name == "d" for s in form.arguments)
        for fractions in (False, True) if late else (False,):
            given = columns(form, count, fractions)
            beside = clock(lambda given=given, form=form: getattr(symhaptic, form.name)(*given))
            delay = ("a fraction" if fractions else "whole") if late else ""
            for place in places:
                for kind in (np.float64, np.float32):
                    compiled, each = row(form, place, kind, given)
                    print(
                        f"| `{form.name}` | {delay} "
                        f"| {library}, {place} | {np.dtype(kind).name} | {compiled:.1f} s "
                        f"| {1e9 * each / count:.0f} ns | {each / beside:.2f} |",
                        flush=True,
                    )


if __name__ == "__main__":
    if sys.argv[1:2] == ["--one"]:
        measured(sys.argv[2], int(sys.argv[3]), sys.argv[4:])
    else:
        count = sys.argv[1] if len(sys.argv) > 1 else "1000000"
        print("| function | delay | on | precision | to compile | an element | times NumPy's |")
        print("|---|---|---|---|---|---|---|", flush=True)
        for library in LIBRARIES:
            command = [sys.executable, __file__, "--one", library, count, *sys.argv[2:]]
            subprocess.run(command, check=True)
