"""The law of a wall as C: K, B and the velocity filter of a scene, to be called once a period."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from symhaptic.loops.controller import recursion
from symhaptic.loops.velocity import Difference, Filter, Measured
from symhaptic.scene.loop import DeviceLoop
from symhaptic.scene.walls import is_stable

_TESTED = 64
"""Positions of the self-test."""


def files(scene: DeviceLoop, K: float, B: float, single: bool = False) -> dict[str, str]:
    """wall.h, wall.c and test_wall.c of a wall in SI units.

    Raises :class:`ValueError` for a wall that the scene does not keep stable, for a velocity that
    is not computed from positions, and for a wall that single precision cannot hold.
    """
    scene.refuse_coupling("a controller in C")
    velocity = scene.velocity or Difference()
    if isinstance(velocity, Measured):
        raise ValueError(
            f"velocity: {velocity.words} cannot be computed in C; give a velocity that is computed "
            "from one position a period, such as Difference() or LowPass(cutoff=...)"
        )
    if not is_stable(scene, K, B):
        raise ValueError(f"K: {K!r} with B={B!r} is not stable for this device; give a stable wall")
    period = scene.sampling_period
    above, below = recursion(velocity, period)
    if single:
        _check_single(scene, K, B)
    real, f = ("float", "f") if single else ("double", "")
    units = {name: scene.printed(unit) for name, unit in (("K", "N/m"), ("B", "N*s/m"))}
    rotary = scene.rotary
    words = {
        "real": real,
        "f": f,
        "K": f"{float(K)!r}{f}",
        "B": f"{float(B)!r}{f}",
        "M": f"{scene.virtual_mass or 0.0!r}{f}",
        "T": f"{period!r}{f}",
        "unit_K": units["K"],
        "unit_B": units["B"],
        "position": "rad" if rotary else "m",
        "force": "N m" if rotary else "N",
        "velocity": velocity.words,
        "above": ", ".join(f"{c!r}{f}" for c in above),
        "below": ", ".join(f"{c!r}{f}" for c in below) or f"0{f and '.0f'}",
        "many": len(above),
        "past": len(below),
        "held": max(len(above), 2),
        "kept": max(len(below), 1),
    }
    positions, forces = _motion(scene, K, B)
    rows = ",\n".join(f"    {{{x!r}{f}, {y!r}{f}}}" for x, y in zip(positions, forces, strict=True))
    largest = max(map(abs, forces))
    words |= {
        "rows": rows,
        "rounds": repr((1e-4 if single else 1e-12) * largest) + f,
        "count": len(positions),
    }
    return {"wall.h": _HEADER % words, "wall.c": _SOURCE % words, "test_wall.c": _TEST % words}


def _check_single(scene: DeviceLoop, K: float, B: float) -> None:
    """Raise :class:`ValueError` if the wall is another one in single precision, or not stable."""
    T = scene.sampling_period
    numbers = {"K": K, "B": B, "virtual_mass": scene.virtual_mass or 0.0, "sampling_period": T * T}
    float32 = np.finfo(np.float32)
    for name, value in numbers.items():
        if value and not float32.tiny < abs(value) * _TINY_MOTION < abs(value) < float32.max:
            given = f"{T!r} squared" if name == "sampling_period" else repr(value)
            raise ValueError(
                f"{name}: {given} is beyond the range of single precision; give double precision"
            )
    velocity = scene.velocity or Difference()
    if velocity.over:
        return  # its coefficients are alike
    above, below = (np.array(c, np.float32).astype(float) for c in recursion(velocity, T))
    gain = above.sum() / (1 + below.sum()) if 1 + below.sum() else np.inf
    poles = np.roots([1.0, *below])
    if not abs(gain - 1) < _GAIN or np.any(np.abs(poles) >= 1):
        raise ValueError(
            f"velocity: {velocity.words} loses its digits in single precision, where its poles are "
            "too near to 1; give double precision"
        )
    rounded = replace(scene, velocity=Filter((above / gain).tolist(), [1.0, *below]))
    if not is_stable(rounded, K, B * gain):
        raise ValueError(
            f"K: {K!r} with B={B!r} is not stable with a filter in single precision; "
            "give double precision"
        )


_TINY_MOTION = 1e-7
"""Forces of motions of this size in m or rad have all digits, too."""

_GAIN = 1e-3
"""By this part a constant velocity may be wrong."""


def _motion(scene: DeviceLoop, K: float, B: float) -> tuple[list[float], list[float]]:
    """Positions of a swing into the wall and out of it, and the forces of its law.

    The forces are sums over all differences so far, in powers of 1/z, and not the recursion that
    the C code runs.
    """
    period = scene.sampling_period
    above, below = recursion(scene.velocity or Difference(), period)
    positions = 1e-3 * np.sin(np.arange(_TESTED) * 0.3) * np.exp(-np.arange(_TESTED) / 40)
    differences = np.diff(positions, prepend=positions[0])
    response = _response(above, below)
    speed = np.convolve(differences, response)[:_TESTED] / period
    change = np.diff(differences, prepend=0.0) / period**2
    force = -(K * positions + B * speed + (scene.virtual_mass or 0.0) * change)
    force = np.where(positions > 0, np.minimum(force, 0.0), 0.0)
    return positions.tolist(), (force + 0.0).tolist()


def _response(above: list[float], below: list[float]) -> Any:
    """Of the filter to one unit: the quotient of two polynomials in 1/z, by long division."""
    rest = np.zeros(_TESTED + len(below))
    rest[: min(len(above), _TESTED)] = above[:_TESTED]
    found = np.zeros(_TESTED)
    for n in range(_TESTED):
        found[n] = rest[n]
        rest[n + 1 : n + 1 + len(below)] -= found[n] * np.array(below)
    return found


_HEADER = """\
/* A virtual wall: %(K)s %(unit_K)s and %(B)s %(unit_B)s, to be called every %(T)s s.
   Velocity: %(velocity)s.  Written by symhaptic. */

#ifndef WALL_H
#define WALL_H

typedef struct {
    %(real)s position;            /* of the last sample */
    %(real)s differences[%(held)d];      /* of positions, the newest first */
    %(real)s velocities[%(kept)d];       /* times T, the newest first */
} wall_state;

/* Begin at a position in %(position)s, at rest. */
void wall_begin(wall_state *state, %(real)s position);

/* The force in %(force)s for a position in %(position)s.
   The wall is at positions > 0 and only pushes, towards negative positions.  A position that is not
   finite gives the force 0 and leaves the state as it is. */
%(real)s wall(wall_state *state, %(real)s position);

#endif
"""

_SOURCE = """\
#include "wall.h"

static const %(real)s K = %(K)s;            /* %(unit_K)s */
static const %(real)s B = %(B)s;            /* %(unit_B)s */
static const %(real)s M = %(M)s;            /* virtual mass */
static const %(real)s T = %(T)s;            /* s */
static const %(real)s above[] = {%(above)s};
static const %(real)s below[] = {%(below)s};

enum { ABOVE = %(many)d, BELOW = %(past)d, HELD = %(held)d };

void wall_begin(wall_state *state, %(real)s position)
{
    int n;
    state->position = position - position == 0 ? position : 0;
    for (n = 0; n < HELD; n++)
        state->differences[n] = 0;
    for (n = 0; n < %(kept)d; n++)
        state->velocities[n] = 0;
}

%(real)s wall(wall_state *state, %(real)s position)
{
    %(real)s velocity = 0, change, force;
    int n;
    if (!(position - position == 0)) /* NaN or infinite: it would stay in the filter */
        return 0;
    for (n = HELD - 1; n > 0; n--)
        state->differences[n] = state->differences[n - 1];
    state->differences[0] = position - state->position;
    state->position = position;
    for (n = 0; n < ABOVE; n++)
        velocity += above[n] * state->differences[n];
    for (n = 0; n < BELOW; n++)
        velocity -= below[n] * state->velocities[n];
    for (n = BELOW - 1; n > 0; n--)
        state->velocities[n] = state->velocities[n - 1];
    state->velocities[0] = velocity;
    change = state->differences[0] - state->differences[1];
    force = -(K * position + B * (velocity / T) + M * (change / (T * T)));
    return position > 0 && force < 0 ? force : 0;
}
"""

_TEST = """\
/* The wall beside its law: cc wall.c test_wall.c && ./a.out ends with 0. */

#include <stdio.h>
#include "wall.h"

static const %(real)s motion[][2] = { /* position, force */
%(rows)s
};

int main(void)
{
    wall_state state;
    int n, wrong = 0;
    wall_begin(&state, motion[0][0]);
    for (n = 0; n < %(count)d; n++) {
        %(real)s force = wall(&state, motion[n][0]), apart = force - motion[n][1];
        if (!(apart <= %(rounds)s && apart >= -%(rounds)s)) {
            printf("sample %%d: %%g instead of %%g\\n", n, (double)force, (double)motion[n][1]);
            wrong = 1;
        }
    }
    return wrong;
}
"""
