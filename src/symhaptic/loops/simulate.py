"""The motion of a loop over time: the controller computes the wall, and the device moves.

Without units: time in periods, forces in units of m/T^2 times the unit of length.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from symhaptic.loops.actuator import Lag
from symhaptic.loops.circle import Array
from symhaptic.loops.controller import Wall, controller
from symhaptic.loops.engine import STEPS, Engine
from symhaptic.loops.motion import POWERS, Forms, Friction, Handle, Motion, cuts
from symhaptic.loops.oversampled import Oversampled
from symhaptic.loops.plant import Plant, moving_mass
from symhaptic.loops.structure import SecondMass
from symhaptic.loops.system import LinearDevice


class Course(NamedTuple):
    """The result of a simulation, one value for each time."""

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
    """The motion from a start, with a force from outside that is held for each period.

    ``between`` is the number of additional times between two samples.  Values beyond the range of
    floats are NaN, and so are all after them.
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
        self.periods, self._plant = len(outside), engine.plant
        self.measured = np.full(self.periods + 1, np.nan)
        self.forces = np.full((self.periods + 1, 3), np.nan)
        self._outside = np.append(outside, outside[-1:]).tolist()
        self._commands = [0.0] * (math.floor(engine.delay) + 1)
        velocity, period, (place, speed) = engine.velocity, engine.period, start
        self.times = 1
        """Readings of the position a period."""
        if isinstance(velocity, Oversampled):
            self.times, velocity = velocity.times, velocity.velocity
            period, speed = period / self.times, speed / self.times
        alone = replace(wall, beta=wall.beta * self.times)  # of a velocity in readings
        self._sampled = controller(alone, velocity, period, (place, speed))

    def at(self, k: int, state: Array) -> tuple[float, float, float] | None:
        """The forces from sample k on; none beyond the range of floats."""
        position = float(self._plant.position @ state)
        if not math.isfinite(position):
            return None
        self.measured[k], command = self._sampled(position, float(self._plant.velocity @ state))
        self._commands.append(command)
        forces = self._commands[k], self._commands[k + 1], self._outside[k]
        self.forces[k] = forces
        return forces

    def between(self, part: float, z: Array) -> None:
        """A reading within a period, where there is one."""
        if part and (part * self.times).is_integer():
            state = z[:-3]
            self._sampled(float(self._plant.position @ state), float(self._plant.velocity @ state))


def _held(
    engine: Engine, answers: _Answers, start: tuple[float, float], friction: float, between: int
) -> Course:
    plant, periods, handle = engine.plant, answers.periods, _handle(engine)
    lagging = any(isinstance(part, Lag) for part in engine.parts)
    forms = Forms(plant, engine.gamma, engine.delta, handle, lagging)
    outside = [0.0, 1.0] if handle is None else [0.0, 0.0, 0.0, 1 / handle.mass]
    state, system = np.zeros(len(plant.state)), _system(engine)
    if system is None:
        state[: len(outside) : 2], state[1 : len(outside) : 2] = start
    elif friction or any(start):
        name = "coulomb_friction" if friction else "position0 or velocity0"
        raise ValueError(
            f"{name}: cannot be used with dynamics, whose matrices do not define its effect; "
            "use external_force instead"
        )
    else:
        outside = [*system.force]
    motion = Motion(plant, forms, np.array(outside))
    longest = motion.longest if friction else math.inf
    if longest * _MOST < 1:
        raise ValueError(
            f"coulomb_friction: a period would need {1 / longest:.3g} pieces; "
            "leave out coulomb_friction, or give a slower actuator or structure"
        )
    reported = {n / (between + 1) for n in range(between + 1)}
    read = {n / answers.times for n in range(answers.times)}
    period = _Period(motion, engine.delay % 1, cuts({engine.delay % 1, *reported, *read}, longest))
    if friction:
        rows, works = _with_friction(period, answers, state, Friction(motion, friction))
    else:
        rows, works = _without_friction(period, answers, state)
    is_reported = np.append(np.tile([at in reported for at, _ in period.legs], periods), True)
    rows, works = rows[is_reported], np.cumsum(works, axis=0)[is_reported]
    energy = _form(forms.energy, rows)
    if system is not None:
        energy, works = np.full_like(energy, np.nan), np.full_like(works, np.nan)
    return Course(
        np.arange(len(rows)) / (between + 1),
        rows[:, :-3] @ plant.position,
        rows[:, :-3] @ plant.velocity,
        rows @ forms.force,
        np.repeat(answers.measured, between + 1)[: len(rows)],
        energy,
        dict(zip(POWERS, works.T, strict=True)),
    )


_MOST = 10_000
"""Pieces of a period: with more, a second takes hours."""


class _Period(NamedTuple):
    """A sampling period, cut into legs: their starts and lengths."""

    motion: Motion
    fraction: float
    """When the command of this period arrives."""
    legs: list[tuple[float, float]]

    def works(self, rows: Array, stuck: NDArray[np.bool_]) -> Array:
        """The energies of each leg, from z at its start; the first row is 0."""
        found, count = np.zeros((len(rows), len(POWERS))), len(self.legs)
        for j, (_, time) in enumerate(self.legs):
            for kind in {*stuck[j::count].tolist()}:
                chosen = np.flatnonzero(stuck[j::count] == kind) * count + j
                for n, form in enumerate(self.motion.legs(time, kind).work):
                    found[chosen + 1, n] = _form(form, rows[chosen])
        return found

    def step(self) -> Array:
        """The state after the period, as a matrix times the state and the forces before it."""
        size = len(self.motion.free) - 3
        state, forces = np.split(np.eye(size + 3), [size])
        for at, time in self.legs:
            z = np.vstack([state, forces[int(at >= self.fraction)], forces[2], 0 * forces[2]])
            state = (self.motion.legs(time, False).step @ z)[:size]
        return state

    def through(
        self, state: Array, forces: tuple[float, float, float]
    ) -> Iterator[tuple[float, Array]]:
        """The start of each leg of a period, and z there."""
        z = np.array([*state, *forces[1:], 0.0])
        for at, time in self.legs:
            z[-3] = forces[int(at >= self.fraction)]
            yield at, z
            z = self.motion.legs(time, False).step @ z

    def rows(self, samples: Array, forces: Array) -> Array:
        """z at the start of each leg of each period, up to the last sample."""
        found = []
        z = np.column_stack([samples, forces[:, 1:], np.zeros(len(samples))])
        for at, time in self.legs:
            z[:, -3] = forces[:, int(at >= self.fraction)]
            found.append(z)
            z = z @ self.motion.legs(time, False).step.T
        every = np.stack(found, axis=1).reshape(-1, z.shape[1])
        return every[: len(every) - len(self.legs) + 1]


def _without_friction(period: _Period, answers: _Answers, state: Array) -> tuple[Array, Array]:
    """z at the start of each leg, and what the energies change in it."""
    step, samples = period.step(), np.full((answers.periods + 1, len(state)), np.nan)
    for k in range(answers.periods + 1):
        samples[k] = state
        forces = answers.at(k, state)
        if forces is None:
            break
        if answers.times > 1:
            for part, z in period.through(state, forces):
                answers.between(part, z)
        state = step @ [*state, *forces]
    rows = period.rows(samples, answers.forces)
    return rows, period.works(rows, np.zeros(len(rows) - 1, dtype=bool))


def _with_friction(
    period: _Period, answers: _Answers, state: Array, friction: Friction
) -> tuple[Array, Array]:
    """The same where the motor sticks and slips."""
    count = answers.periods * len(period.legs)
    rows, stuck = np.full((count + 1, len(state) + 3), np.nan), np.zeros(count, dtype=bool)
    eventful: dict[int, Array] = {}
    for k in range(answers.periods + 1):
        forces = answers.at(k, state)
        if forces is None:
            break
        z = np.array([*state, *forces[1:], 0.0])
        for row, (at, time) in enumerate(period.legs, k * len(period.legs)):
            z[-3] = forces[at >= period.fraction]
            if row == count:
                rows[row] = z
                break
            answers.between(at, z)
            rows[row], stuck[row], work, z = friction.advance(z, time)
            if work is not None:
                eventful[row + 1] = work
        state = z[:-3]
    works = period.works(rows, stuck)
    for row, work in eventful.items():
        works[row] = work
    return rows, works


def _form(form: Array, rows: Array) -> Array:
    """z' form z of each row."""
    return np.asarray(((rows @ form) * rows).sum(axis=1))


def _system(engine: Engine) -> Plant | None:
    """A device by its matrices, which do not say what its energies are."""
    for part in engine.parts:
        if isinstance(part, LinearDevice):
            return part.before(moving_mass(), engine.mass, engine.period)
    return None


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
        forces = answers.at(k, state)
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
