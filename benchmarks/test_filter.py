"""Verdicts on walls beside the exported C, and how many walls need which stage.

`.venv/bin/pytest benchmarks/test_filter.py --benchmark-only -s`; ratios within one run count.
`python benchmarks/test_filter.py` compiles the kernels for one instruction set after the other.
`WALLS=1000000` compares so many hard walls with balls, at some 0.5 ms each.
"""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

import symhaptic
from symhaptic.balls import winding
from symhaptic.bench.exported import compiled
from symhaptic.export import request

RNG = np.random.default_rng(0)
COUNT = 10**6
HARD = int(os.environ.get("WALLS", "20000"))


def ordinary(fraction):
    """Walls and devices inside the paper's (23)."""
    delay = RNG.integers(0, 9, COUNT) + (RNG.random(COUNT) if fraction else 0.0)
    ranges = (0, 0.5), (-0.02, 1), (0, 1e-3), (0, 0.02)
    return [*(RNG.uniform(*ends, COUNT) for ends in ranges), delay]


def hard(count, seed):
    """Walls within 1e-14 to 1e-10 of the boundary, a fifth of devices that swing in a period."""
    rng = np.random.default_rng(seed)
    fast = rng.random(count) < 0.2
    gamma = np.where(fast, 10 ** rng.uniform(-3, 2.5, count), rng.uniform(0, 1e-3, count))
    delta = np.where(fast, 10 ** rng.uniform(-8, 1, count), rng.uniform(0, 0.02, count))
    delay = rng.integers(0, 9, count) + np.where(rng.random(count) < 0.3, rng.random(count), 0)
    theta = rng.uniform(0.02, 1, count) * np.pi / (2 * delay + 2)
    alpha, beta = symhaptic.stability_boundary(theta, gamma, delta, delay)
    off = 1 + rng.choice([-1, 1], count) * 10 ** rng.uniform(-14, -10, count)
    return alpha * off, beta * off, gamma, delta, delay


def seconds(work, rounds=5):
    """Least processor time of a call."""
    times = []
    for _ in range(rounds):
        begin = time.process_time()
        work()
        times.append(time.process_time() - begin)
    return min(times)


def beside_exported_c(folder, fraction):
    """Print the times of a wall; return the walls."""
    exported = compiled(request.chosen(["is_stable"])[0], folder)
    rows = ordinary(fraction)
    one = [*rows[:2], *(float(row[0]) for row in rows[2:])]
    c = seconds(lambda: exported(rows)) / COUNT
    many, alone = (seconds(lambda w=w: symhaptic.is_stable(*w)) / COUNT for w in (rows, one))
    certified = seconds(lambda: symhaptic.is_stable(*rows, certified=True)) / COUNT
    ns = [f"{1e9 * t:.0f} ns ({c / t:.1f} times as fast)" for t in (many, alone, certified)]
    print(f"\n    exported C {1e9 * c:.0f} ns; is_stable {ns[0]}; one device {ns[1]}; "
          f"certified {ns[2]}", end="")  # fmt: skip
    assert np.array_equal(symhaptic.is_stable(*rows), exported(rows)[0] != 0)
    return rows


@pytest.mark.parametrize("fraction", [False, True])
def test_beside_exported_c(benchmark, tmp_path, fraction):
    if shutil.which("gcc") is None:
        pytest.skip("no gcc here: nothing to compare with")
    benchmark(symhaptic.is_stable, *beside_exported_c(tmp_path, fraction))


def test_stages_of_hard_walls(benchmark):
    from symhaptic.kernels import _compiled

    rows = hard(HARD, 1)
    counts, kernel = _compiled.certain_roots(*rows), symhaptic.unstable_roots(*rows)
    said = symhaptic.is_stable(*rows)
    walls = zip(*(row.tolist() for row in rows), strict=True)
    begin = time.process_time()
    exact = np.array([-1 if (n := winding.unstable(*w)) is None else n for w in walls])
    took = (time.process_time() - begin) / HARD
    sure = exact >= 0
    wrong = int((said & (exact > 0)).sum())
    lied = int((sure & (counts >= 0) & (counts != exact)).sum())
    print(f"\n    {HARD} hard walls: the filter decides {(counts != -1).mean():.1%}, the kernel "
          f"{((counts == -1) & (kernel >= 0)).mean():.1%}, balls the rest in {1e3 * took:.2f} ms "
          f"each; called stable wrongly {wrong}, certain and wrong {lied}, undecided "
          f"{int((~sure).sum())}", end="")  # fmt: skip
    assert wrong == lied == 0
    benchmark(symhaptic.is_stable, *rows)


def with_set(architecture):
    """Compile a copy of the package for this instruction set alone, and print its times."""
    with TemporaryDirectory() as folder:
        tree = Path(folder) / "tree"
        shutil.copytree(Path(__file__).parents[1], tree,
                        ignore=shutil.ignore_patterns(".*", "*.so", "build"))  # fmt: skip
        flags = f"-DONE_SET -march={architecture}"
        build = [sys.executable, "setup.py", "--quiet", "build_ext", "--inplace"]
        subprocess.run(
            build, cwd=tree, env={**os.environ, "CFLAGS": flags, "CXXFLAGS": flags}, check=True
        )
        run = [sys.executable, str(tree / "benchmarks" / Path(__file__).name), folder]
        subprocess.run(run, env={**os.environ, "PYTHONPATH": str(tree / "src")}, check=True)


if __name__ == "__main__":
    if sys.argv[1:]:
        for fraction in (False, True):
            beside_exported_c(Path(sys.argv[1]), fraction)
    else:
        for architecture in ("x86-64", "x86-64-v3", "x86-64-v4"):
            print(f"\n{architecture}", end="", flush=True)
            with_set(architecture)
