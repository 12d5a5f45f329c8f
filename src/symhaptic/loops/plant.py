"""How a device moves, and what of it is seen once a period.

A device is d/dt state = A state + b force, with the position and the velocity of what the sensor
measures as rows.  Held forces, delayed by a part of a period, give its samples exactly; a
simulator replaces the motion by steps of Euler's methods.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from symhaptic.loops.number import Number

Row: TypeAlias = tuple[Number, ...]


class Plant(NamedTuple):
    """d/dt state = A state + b force, in sampling periods and units of the mass."""

    state: tuple[Row, ...]
    force: Row
    position: Row
    velocity: Row
    free: bool = False
    """Whether it can rest anywhere without a force (det A = 0), like a device without a spring."""


def moving_mass(gamma: Number = 0, delta: Number = 0) -> Plant:
    """x'' + delta x' + gamma x = force: the mass-spring-damper of the paper, (2)."""
    return Plant(((0, 1), (-gamma, -delta)), (0, 1), (1, 0), (0, 1), gamma == 0)


class Sampled(NamedTuple):
    """state+ = (1 + step) state + previous force(-1) + early force, once a period.

    ``early`` is what the force of this sample does within the period, ``late`` what is left of it
    in the next one if it arrives late by a part of a period.  Arrays, the loops in front.
    """

    step: NDArray[np.float64]
    early: NDArray[np.float64]
    late: NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    free: bool


def held(plant: Plant, fraction: Number = 0.0) -> Sampled:
    """The samples of a device under forces that are held for a period.

    Each force is delayed by ``fraction`` of a period, from 0 up to 1.
    """
    state, force, position, velocity = arrays(plant)
    part = np.asarray(fraction, dtype=float)[..., None, None]
    step, _ = grown(state)
    on, early = grown(state * (1 - part))
    _, late = grown(state * part)
    early, late = (1 - part) * (early @ force), part * (late @ force)
    return Sampled(step, early, late + on @ late, position, velocity, plant.free)


def explicit_euler(plant: Plant) -> Sampled:
    """x+ = x + v, v+ = v + acceleration: steps of a simulator, all from the old state."""
    state, force, position, velocity = arrays(plant)
    return Sampled(state, force, 0 * force, position, velocity, plant.free)


def semi_implicit_euler(plant: Plant) -> Sampled:
    """v+ = v + acceleration, x+ = x + v+: steps of a simulator that moves by the new velocity.

    Places and velocities stand in turn in the state, as in :func:`moving_mass`.
    """
    state, force, position, velocity = arrays(plant)
    size = state.shape[-1]
    moves = np.eye(size)
    moves[np.arange(0, size - 1, 2), np.arange(1, size, 2)] = 1.0  # the place takes the new speed
    accelerates = state.copy()
    accelerates[..., 0::2, :] = 0.0
    step = moves @ (np.eye(size) + accelerates) - np.eye(size)
    return Sampled(step, moves @ force, 0 * force, position, velocity, plant.free)


def grown(state: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """exp(A) - 1 and the integral of exp(A s) for s from 0 to 1, as exact as their entries.

    A short time's series, doubled: exp(2A) - 1 = 2 E + E^2 takes no difference of like numbers,
    and so small entries keep their digits.
    """
    size = np.abs(state).sum(axis=-1).max(initial=0.0)
    halvings = max(0, int(np.ceil(np.log2(size))) + 1) if size > 0 else 0
    short = state / 2.0**halvings
    one = np.eye(state.shape[-1])
    integral = np.broadcast_to(one, state.shape)
    for n in range(_TERMS, 1, -1):  # Horner of sum A^(n-1)/n!
        integral = one + short @ integral / n
    step = short @ integral
    for _ in range(halvings):
        integral = integral @ (one + step / 2)
        step = 2 * step + step @ step
    return step, integral


_TERMS = 18
"""Of a matrix of norm 1/2 the terms beyond are below 2^-18/18!, 6e-22."""


def arrays(plant: Plant) -> tuple[NDArray[np.float64], ...]:
    """The state matrix and columns and rows of a plant as arrays, the loops in front."""
    numbers = [np.asarray(x, dtype=float) for row in plant.state for x in row]
    column = [np.asarray(x, dtype=float) for x in plant.force]
    shape = np.broadcast_shapes(*(x.shape for x in (*numbers, *column)))
    size = len(plant.state)
    state = np.stack([np.broadcast_to(x, shape) for x in numbers], axis=-1)
    force = np.stack([np.broadcast_to(x, shape) for x in column], axis=-1)
    return (
        state.reshape(*shape, size, size),
        force[..., None],
        np.asarray(plant.position, dtype=float),
        np.asarray(plant.velocity, dtype=float),
    )


def transfer(
    sampled: Sampled, row: NDArray[np.float64], column: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """row adj(w - step) column and det(w - step): coefficients of 1, w, w^2, ... on the last axis.

    There may be many columns, the loops in front.  For a free device det(-step) is exactly 0;
    computed from rounded entries, it may have either sign.
    """
    rows, bottom = _resolvent(sampled.step.tobytes(), row.tobytes())
    if sampled.free:
        bottom = np.concatenate([np.zeros(1), bottom[1:]])
    return (rows @ column)[..., 0], bottom


@lru_cache(maxsize=256)
def _resolvent(step: bytes, row: bytes) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """row adj(w - step), one row for each power of w, and det(w - step).

    By Faddeev and LeVerrier: adj(w - S) = sum of w^k M_k.  They are computed in whole numbers and
    rounded at the end.  In floats a device with modes of 1 Hz and 1 kHz would lose all digits.
    """
    from flint import fmpz_mat

    size = len(row) // 8
    entries = np.frombuffer(step)
    if not np.isfinite(entries).all():
        return np.full((size, size), np.nan), np.full(size + 1, np.nan)
    ratios = [x.as_integer_ratio() for x in entries.tolist()]
    unit = max(below for _, below in ratios)  # powers of 2
    whole = fmpz_mat(size, size, [above * (unit // below) for above, below in ratios])
    seen = [x.as_integer_ratio() for x in np.frombuffer(row).tolist()]
    scale = max(below for _, below in seen)
    left = fmpz_mat(1, size, [above * (scale // below) for above, below in seen])
    one = fmpz_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])
    adjugate, rows, bottom = one, [], [1.0]
    for n in range(1, size + 1):
        of_unit = unit ** (n - 1) * scale
        rows.append([int(each) / of_unit for each in (left * adjugate).entries()])
        turned = whole * adjugate
        last = -sum(turned[i, i] for i in range(size)) // n
        bottom.append(int(last) / unit**n)
        adjugate = turned + one * last
    return np.array(rows[::-1]), np.array(bottom[::-1])
