"""A sweep of many walls reduced to a map: what it costs, how that grows, and what more hands do.

`python benchmarks/sweep.py 100000000` sweeps so many walls at most.  Ratios within one run count,
since the machine is shared; processor time is what a sweep costs whoever else works.
"""

import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from distributed import Client, LocalCluster

from symhaptic import sweep

CELLS = 100, 100
"""Walls of the map: (alpha, beta)."""

CORES = 100
"""Of the cluster that nobody has lent."""


def axes(points, delay):
    """So many walls: a map of 10^4, each for devices inside (23)."""
    devices = max(1, points // (CELLS[0] * CELLS[1]))
    springs = max(1, round(devices**0.5 / 2))
    return {
        "alpha": np.linspace(0, 0.2, CELLS[0]),
        "beta": np.linspace(-0.05, 0.6, CELLS[1]),
        "gamma": np.linspace(0, 0.001, springs),
        "delta": np.linspace(0, 0.02, devices // springs),
        "delay": delay,
        "over": ("gamma", "delta"),
        "reduce": "all",
    }


def worked():
    """Processor seconds of this process and of those that have ended."""
    own, children = (
        resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    )
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def timed(**words):
    """Seconds on the clock and of processors, and the map."""
    begin, clock = worked(), time.perf_counter()
    found = sweep("is_stable", **words)
    return time.perf_counter() - clock, worked() - begin, found


def in_a_process(points, delay, workers):
    """The same in a fresh process, which tells its largest memory in MB, too."""
    program = (
        f"import sys; sys.path.insert(0, {str(Path(__file__).parent)!r});"
        "import resource; import sweep as b;"
        f"wall, work, _ = b.timed(**b.axes({points}, {delay}), workers={workers});"
        "print(wall, work, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)"
    )
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)
    return [float(word) for word in told.stdout.split()]


def growth(most):
    """Cost over the number of walls."""
    print("| walls | delay | on the clock | processor time | per 10^9 walls | memory |")
    print("|---|---|---|---|---|---|")
    for delay in (1.0, 1.5):
        points = 10**6
        while points <= most:
            wall, work, memory = in_a_process(points, delay, 2)
            each = work / points * 1e9
            print(
                f"| 10^{round(np.log10(points))} | {delay:g} | {wall:.1f} s | {work:.1f} s "
                f"| {each:.0f} s | {memory:.0f} MB |",
                flush=True,
            )
            points *= 10


def hands(points, rounds=3):
    """One worker beside two, in turns: threads, processes, and workers of a local cluster.

    On the clock, and in processor time, which is what is lost by working together.
    """
    swept = axes(points, 1.0)
    turns = {
        kind: [[timed(**swept, on=kind, workers=n)[:2] for n in (1, 2)] for _ in range(rounds)]
        for kind in ("threads", "processes")
    }
    turns["workers of a cluster"] = [
        [on_a_cluster(swept, n) for n in (1, 2)] for _ in range(rounds)
    ]
    for kind, found in turns.items():
        clock, work = (sorted(one[i] / two[i] for one, two in found) for i in (0, 1))
        middle = len(found) // 2
        print(
            f"two {kind}: {clock[middle]:.2f} times as fast as one ({clock[0]:.2f} to "
            f"{clock[-1]:.2f}), {1 / work[middle]:.2f} times the processor time",
            flush=True,
        )


def on_a_cluster(swept, workers):
    """Seconds on the clock without the start, and of all processors with it."""
    begin = worked()
    with (
        LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        sweep("is_stable", **axes(10**4, 1.0), on=client)  # imports are made before
        clock = timed(**swept, on=client)[0]
    return clock, worked() - begin


def resumed(points):
    """Killed half-way and gone on, beside a whole run: the same bytes, and what it costs more."""
    with tempfile.TemporaryDirectory() as folder:
        whole, killed = Path(folder, "whole.zarr"), Path(folder, "killed.zarr")
        clock, work, _ = timed(**axes(points, 1.0), to=whole, workers=2)
        blocks = sum(p.is_file() for p in (whole / "blocks/done/c").rglob("*"))
        program = (
            f"import sys; sys.path.insert(0, {str(Path(__file__).parent)!r}); import sweep as b;"
            f"b.timed(**b.axes({points}, 1.0), to={str(killed)!r}, workers=2)"
        )
        child = subprocess.Popen([sys.executable, "-c", program])
        while not killed.exists() or done(killed) < blocks // 2:
            time.sleep(0.01)
        child.kill()
        child.wait()
        kept = done(killed)
        _, rest, _ = timed(**axes(points, 1.0), to=killed, workers=2)
        files = [
            {p.relative_to(place): p.read_bytes() for p in place.rglob("*") if p.is_file()}
            for place in (whole, killed)
        ]
        size = sum(map(len, files[0].values()))
        same = "the same" if files[0] == files[1] else "DIFFER"
        shutil.rmtree(folder, ignore_errors=True)
    print(f"killed with {kept} of {blocks} blocks done and gone on: the rest took "
          f"{rest / work:.2f} of the whole, bytes {same}; "
          f"{size / 1e3:.0f} kB in {len(files[0])} files, {clock:.1f} s", flush=True)  # fmt: skip


def done(place):
    """Marks of blocks."""
    return sum(p.is_file() for p in (place / "blocks/done/c").rglob("*"))


def overhead(blocks=2000):
    """What a block costs besides its walls, on a local cluster: what limits a large one."""
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        few = {**axes(10**4, 1.0), "alpha": np.linspace(0, 0.2, blocks), "beta": 0.1,
               "chunks": {"alpha": 1}}  # fmt: skip
        sweep("is_stable", **axes(10**4, 1.0), on=client)
        begin = time.process_time()  # the scheduler's, which runs here; not that of the workers
        timed(**few, on=client)
        each = (time.process_time() - begin) / blocks
    print(f"a block on a cluster, besides its walls: {1e3 * each:.1f} ms of one processor here")
    return each


def large(cores):
    """What a cluster would take, calculated from one block and one scheduler measured here."""
    _, work, _ = in_a_process(10**7, 1.0, 1)
    each, block = work / 1e7, 2**22
    handed = overhead()
    for points in (1e9, 1e12):
        computed, scheduled = points * each / cores, points / block * handed
        print(f"calculated for {points:.0e} walls on {cores} such cores: {computed:.0f} s, and "
              f"{scheduled:.0f} s of one scheduler beside it", flush=True)  # fmt: skip
    print(f"one scheduler keeps up with {block * each / handed:.0f} such cores")


if __name__ == "__main__":
    most = int(sys.argv[1]) if len(sys.argv) > 1 else 10**7
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    growth(most)
    hands(min(most, 10**8))
    resumed(min(most, 4 * 10**7))
    large(CORES)
    print(f"load {os.getloadavg()[0]:.1f}")
