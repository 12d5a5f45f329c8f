"""The course of a loop: a wall as its controller computes it, a device as it moves.

Without units: time in periods, forces in units of m/T^2 times the unit of length.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from symhaptic.loops.controller import Wall, controller
from symhaptic.loops.engine import STEPS, Engine
from symhaptic.loops.motion import POWERS, Array, Forms, Friction, Handle, Motion, cuts
from symhaptic.loops.structure import SecondMass


class Course(NamedTuple):
    """What a simulation gives, one value for each time."""

    time: Array
    position: Array
    velocity: Array
    force: Array
    measured: Array
    energy: Array
    works: dict[str, Array]
    """By the names of ``POWERS``, and ``integrator`` for what Euler's steps add."""


def simulate(
    engine: Engine,
    wall: Wall,
    start: tuple[float, float],
    outside: Array,
    friction: float,
    between: int,
) -> Course:
    """The course from a start, with a force from outside that is held for each period.

    ``between`` is how many times between two samples are told.  Values beyond the range of floats
    are NaN, and so are all after them.
    """
    answers = _Answers(engine, wall, start, outside)
    with np.errstate(over="ignore", invalid="ignore"):
        if engine.integrator == "hold":
            return _held(engine, answers, start, friction, between)
        return _stepped(engine, answers, start, friction)


class _Answers:
    """The forces of each period: the command before, that of its sample, and from outside."""

    def __init__(
        self, engine: Engine, wall: Wall, start: tuple[float, float], outside: Array
    ) -> None:
        self.periods = len(outside)
        self.measured = np.full(self.periods + 1, np.nan)
        self.forces = np.full((self.periods + 1, 3), np.nan)
        self._outside = np.append(outside, outside[-1:]).tolist()
        self._commands = [0.0] * (math.floor(engine.delay) + 1)
        self._sampled = controller(wall, engine.velocity, engine.period, start)

    def at(self, k: int, position: float, velocity: float) -> tuple[float, float, float] | None:
        """The forces from sample k on; none beyond the range of floats."""
        if not math.isfinite(position):
            return None
        self.measured[k], command = self._sampled(position, velocity)
        self._commands.append(command)
        forces = self._commands[k], self._commands[k + 1], self._outside[k]
        self.forces[k] = forces
        return forces


def _held(
    engine: Engine, answers: _Answers, start: tuple[float, float], friction: float, between: int
) -> Course:
    plant, handle, periods = engine.plant, _handle(engine), answers.periods
    forms = Forms(plant, engine.gamma, engine.delta, handle)
    motion = Motion(plant, forms, 1 / handle.mass if handle else 1.0, handle is not None)
    fraction, told = engine.delay % 1, {n / (between + 1) for n in range(between + 1)}
    legs = cuts({fraction, *told}, motion.longest if friction else math.inf)
    if len(legs) > _MOST:
        raise ValueError(
            f"coulomb_friction: a period of {len(legs)} pieces is not allowed; "
            "leave out coulomb_friction, or the actuator or structure that is so fast"
        )
    state, moving = np.zeros(len(plant.state)), 4 if handle else 2
    state[:moving:2], state[1:moving:2] = start
    stuck = np.zeros(periods * len(legs), dtype=bool)
    eventful: dict[int, Array] = {}
    if friction:
        moved = Friction(motion, friction)
        rows = np.full((periods * len(legs) + 1, len(motion.free)), np.nan)
        for k in range(periods + 1):
            forces = answers.at(k, float(plant.position @ state), float(plant.velocity @ state))
            if forces is None:
                break
            z = np.array([*state, *forces[1:], 0.0])
            for row, (at, time) in enumerate(legs, k * len(legs)):
                z[-3] = forces[at >= fraction]
                if row == len(stuck):
                    rows[row] = z
                    break
                rows[row], stuck[row], work, z = moved.advance(z, time)
                if work is not None:
                    eventful[row] = work
            state = z[:-3]
    else:
        step, samples = _whole(motion, legs, fraction), np.full((periods + 1, len(state)), np.nan)
        for k in range(periods + 1):
            samples[k] = state
            forces = answers.at(k, float(plant.position @ state), float(plant.velocity @ state))
            if forces is None:
                break
            state = step @ [*state, *forces]
        rows = _between(motion, legs, fraction, samples, answers.forces)
    works = np.zeros((len(rows), len(POWERS)))
    for j, (_, time) in enumerate(legs):
        for kind in {*stuck[j :: len(legs)].tolist()}:
            chosen = np.flatnonzero(stuck[j :: len(legs)] == kind) * len(legs) + j
            for n, form in enumerate(motion.legs(time, kind).work):
                works[chosen + 1, n] = _form(form, rows[chosen])
    for row, work in eventful.items():
        works[row + 1] = work
    is_told = np.append(np.tile([at in told for at, _ in legs], periods), True)
    rows, works = rows[is_told], np.cumsum(works, axis=0)[is_told]
    return Course(
        np.arange(len(rows)) / (between + 1),
        rows[:, :-3] @ plant.position,
        rows[:, :-3] @ plant.velocity,
        rows @ forms.force,
        np.repeat(answers.measured, between + 1)[: len(rows)],
        _form(forms.energy, rows),
        dict(zip(POWERS, works.T, strict=True)),
    )


_MOST = 10_000
"""Pieces of a period: with more, a second takes hours."""


def _form(form: Array, rows: Array) -> Array:
    """z' form z of each row."""
    return np.asarray(((rows @ form) * rows).sum(axis=1))


def _whole(motion: Motion, legs: list[tuple[float, float]], fraction: float) -> Array:
    """The state after a period, as a matrix times the state and the forces before it."""
    size = len(motion.free) - 3
    state, forces = np.split(np.eye(size + 3), [size])
    for at, time in legs:
        z = np.vstack([state, forces[int(at >= fraction)], forces[2], 0 * forces[2]])
        state = (motion.legs(time, False).step @ z)[:size]
    return state


def _between(
    motion: Motion, legs: list[tuple[float, float]], fraction: float, samples: Array, forces: Array
) -> Array:
    """z at the start of each leg of each period, up to the last sample."""
    found = []
    z = np.column_stack([samples, forces[:, 1:], np.zeros(len(samples))])
    for at, time in legs:
        z[:, -3] = forces[:, int(at >= fraction)]
        found.append(z)
        z = z @ motion.legs(time, False).step.T
    every = np.stack(found, axis=1).reshape(-1, z.shape[1])
    return every[: len(every) - len(legs) + 1]


def _handle(engine: Engine) -> Handle | None:
    for part in engine.parts:
        if isinstance(part, SecondMass):
            stiff, damped = engine.period**2 / engine.mass, engine.period / engine.mass
            return Handle(part.mass / engine.mass, part.stiffness * stiff, part.damping * damped)
    return None


def _stepped(
    engine: Engine, answers: _Answers, start: tuple[float, float], friction: float
) -> Course:
    """By the steps of a simulator; friction takes at most the velocity of a step."""
    sampled = STEPS[engine.integrator](engine.plant)
    step, accelerates = sampled.step, sampled.early[:, 0]
    periods = answers.periods
    states, stops = np.full((periods + 1, 2), np.nan), np.zeros(periods + 1)
    state = np.array(start)
    for k in range(periods + 1):
        states[k] = state
        forces = answers.at(k, *state.tolist())
        if forces is None:
            break
        state = state + step @ state + accelerates * (forces[1] + forces[2])
        stops[k] = -min(max(state[1], -friction), friction)
        state = state + accelerates * stops[k]
    x, v = states.T
    way = np.diff(x)
    given = (answers.forces[:-1, 1], answers.forces[:-1, 2], engine.delta * v[:-1], -stops[:-1])
    works = {
        name: np.append(0.0, np.cumsum(force * way))
        for name, force in zip(POWERS, given, strict=True)
    }
    energy = (v**2 + engine.gamma * x**2) / 2
    gained = works["wall"] + works["outside"] - works["damper"] - works["friction"]
    works["integrator"] = energy - energy[0] - gained
    time = np.arange(periods + 1.0)
    return Course(time, x, v, answers.forces[:, 1], answers.measured, energy, works)
