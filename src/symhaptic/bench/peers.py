"""The package compared with other tools, for single numbers and for arrays."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from typing import Any

import flint
import numpy as np
from flint import arb

from symhaptic.balls import closed, winding
from symhaptic.balls.exact import bits
from symhaptic.bench.printed import function
from symhaptic.bench.timing import seconds
from symhaptic.bench.verdicts import known, near
from symhaptic.export import request
from symhaptic.numeric.plant import discretize
from symhaptic.numeric.stability import is_stable, unstable_roots
from symhaptic.numeric.tracing.margin import delay_margin

Point = tuple[float, ...]
_ON_ARRAYS = ("printed (14), NumPy",)
"""Tools that take arrays too."""


@dataclass(frozen=True)
class Task:
    """A task: its points, the error of an answer, and the tools that answer."""

    name: str
    points: Sequence[Point]
    error: Callable[[Point, Any], float]
    own: Callable[..., Any]
    """Takes numbers or arrays."""
    peers: dict[str, Callable[..., Any] | None]
    """None for one that is not installed."""
    judged: Callable[..., Any] | None = None
    """The answer of the package, if that takes more than the function that is timed."""


def tasks(count: int) -> list[Task]:
    """The three questions that the other tools can answer."""
    rng = np.random.default_rng(7)
    plants = [(rng.uniform(0, 1e-3), rng.uniform(0, 0.02)) for _ in range(count)]
    walls, truth = near(2, 1e-12, count // 2)
    verdict = dict(zip(zip(*map(np.ndarray.tolist, walls), strict=True), truth, strict=True))
    soft = [(0.01 + 0.02 * rng.random(), 0.2 + 0.2 * rng.random(), *p) for p in plants]
    (form,) = request.chosen(["discretize"])
    paper = function(form, "printed", "numpy")
    tool = find_spec("control") is not None
    return [
        Task(
            "sampled device",
            plants,
            _plant_error,
            discretize,
            {
                "printed (14), NumPy": lambda g, d: [np.real(v) for v in paper(g + 0j, d + 0j)],
                "SciPy, cont2discrete": by_scipy,
                "python-control, sample_system": by_control if tool else None,
            },
        ),
        Task(
            "stable or not",
            list(verdict),
            lambda point, said: math.nan if np.isnan(said) else float(said != verdict[point]),
            lambda al, be, g, dl: is_stable(al, be, g, dl, 2),
            {
                "SciPy, numpy.roots": stable_by_scipy,
                "SciPy, dlti": stable_by_dlti,
                "python-control, feedback": stable_by_control if tool else None,
            },
            lambda al, be, g, dl: known(
                is_stable(al, be, g, dl, 2), unstable_roots(al, be, g, dl, 2)
            ),
        ),
        Task(
            "delay margin",
            soft,
            _margin_error,
            delay_margin,
            {"python-control, stability_margins": margin_by_control if tool else None},
        ),
    ]


def measured(count: int) -> Iterator[dict[str, Any]]:
    """One row for each question and tool, the package's own beside it in the same run."""
    for task in tasks(count):
        first = task.points[0]
        large = [np.resize(a, 20_000) for a in np.array(task.points).T]
        alone = seconds(partial(task.own, *first))
        together = seconds(partial(task.own, *large), 3) / large[0].size
        yield _row(task, "symhaptic", task.judged or task.own, alone, together, alone, together)
        for name, peer in task.peers.items():
            if peer is None:
                yield {"task": task.name, "tool": name, "installed": False}
                continue
            one = seconds(partial(peer, *first))
            many = one  # no arrays: one after the other
            if name in _ON_ARRAYS:
                many = seconds(partial(peer, *large), 3) / large[0].size
            yield _row(task, name, peer, one, many, alone, together)


def _row(
    task: Task, name: str, tool: Callable[..., Any], one: float, many: float, alone: float,
    together: float,
) -> dict[str, Any]:  # fmt: skip
    off = [task.error(point, tool(*point)) for point in task.points]
    good = [e for e in off if math.isfinite(e)]
    verdict = task.name == "stable or not"
    return {
        "task": task.name,
        "tool": name,
        "installed": True,
        "one": one,
        "many": many,
        "ratio_one": one / alone,
        "ratio_many": many / together,
        "median": float(np.median(good)) if good and not verdict else None,
        "worst": max(good) if good and not verdict else None,
        "wrong": float(np.mean(good)) if good and verdict else None,
        "missing": 1 - len(good) / len(off),
    }


# -- exact answers ------------------------------------------------------------------------


def _plant_error(point: Point, found: Any) -> float:
    """The largest relative error of n1 and n0."""
    with flint.ctx.workprec(bits(point)):
        right = closed.device(*point)
        return max(
            float(abs(arb(float(x)) - y) / abs(y)) for x, y in zip(found[:2], right, strict=False)
        )


def _margin_error(point: Point, found: Any) -> float:
    """The relative error of a delay margin; the exact one is found by bisection."""
    with flint.ctx.workprec(_BITS):
        low, high = arb(0), arb(1)
        while _stable_with(high, *point):
            low, high = high, 2 * high
        for _ in range(_HALVES):
            middle = (low + high) / 2
            low, high = (middle, high) if _stable_with(middle, *point) else (low, middle)
        return float(abs(arb(float(found)) - low) / low)


_BITS = 256
_HALVES = 64


def _stable_with(delay: arb, alpha: float, beta: float, gamma: float, delta: float) -> bool:
    """Whether the loop with an exact delay is stable, by its roots counted in balls."""
    whole, part = closed.split(delay)
    return winding.count(alpha, beta, gamma, winding.plant(gamma, delta, part), whole) == 0


# -- the others ---------------------------------------------------------------------------


def by_scipy(gamma: float, delta: float) -> tuple[float, ...]:
    """n1, n0, a and e by a matrix exponential in floats."""
    from scipy.signal import cont2discrete

    top, bottom, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0, method="zoh")
    return top[0][1], top[0][2], -bottom[1], bottom[2]


def _control_device(gamma: float, delta: float) -> Any:
    import control

    return control.sample_system(control.tf([1], [1, delta, gamma]), 1.0, "zoh")


def by_control(gamma: float, delta: float) -> tuple[float, ...]:
    """n1, n0, a and e."""
    device = _control_device(gamma, delta)
    top, bottom = device.num[0][0], device.den[0][0]
    return top[-2], top[-1], -bottom[1], bottom[2]


def _closed(alpha: float, beta: float, gamma: float, delta: float) -> Any:
    """The characteristic polynomial for a delay of two periods."""
    n1, n0, a, e = by_scipy(gamma, delta)
    p = np.array([1.0, -a, e, 0.0, 0.0, 0.0])
    p[-3:] += np.convolve([n1, n0], [alpha + beta, -beta])
    return p


def stable_by_scipy(*wall: float) -> bool:
    """The zeros of the characteristic polynomial."""
    return bool(np.abs(np.roots(_closed(*wall))).max() < 1)


def stable_by_dlti(*wall: float) -> bool:
    """The poles of a discrete system."""
    from scipy.signal import dlti

    return bool(np.abs(dlti([1.0], _closed(*wall), dt=1.0).poles).max() < 1)


def stable_by_control(alpha: float, beta: float, gamma: float, delta: float) -> bool:
    """The poles of a feedback loop."""
    import control

    wall = control.tf([alpha + beta, -beta], [1, 0, 0, 0], 1.0)
    loop = control.feedback(_control_device(gamma, delta), wall)
    return bool(np.abs(loop.poles()).max() < 1)


def margin_by_control(alpha: float, beta: float, gamma: float, delta: float) -> float:
    """The phase margin over its frequency."""
    import control

    loop = _control_device(gamma, delta) * control.tf([alpha + beta, -beta], [1, 0], 1.0)
    _, phase, _, _, at, _ = control.stability_margins(loop)
    return float(math.radians(phase) / at)
