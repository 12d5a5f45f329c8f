"""The largest term in derivatives that swing through zero: what their last place is measured by."""

from __future__ import annotations

from typing import Any

import numpy as np

from symhaptic.forms.angle_slopes import ChordSlope, Ripple, SpreadSlope
from symhaptic.forms.slopes import (
    Bend,
    Coast,
    Ebb,
    Echo,
    Kick,
    NumeratorGapDrop,
    PlantN0Drop,
    PlantN1Drop,
)

_DEVICE = (Kick, Coast, Ebb, Echo, PlantN1Drop, PlantN0Drop, NumeratorGapDrop)


def size(cls: Any, args: Any) -> Any:
    """Of one of these functions, at floats or arrays of them; 0 where the value itself counts."""
    args = [np.asarray(a, dtype=float) for a in args]
    if cls in _DEVICE:
        return _of_device(cls, *args)
    if cls is Bend:
        return np.where(args[0] < -4, 0.5 / np.maximum(-args[0], 4), 0.0)
    return _of_angle(cls, *args) if cls in (Ripple, SpreadSlope, ChordSlope) else 0.0


def _of_device(cls: Any, gamma: Any, delta: Any) -> Any:
    w = delta * delta / 4 - gamma
    root, fall = np.sqrt(np.abs(w)), np.exp(-delta / 2)
    slow, far = gamma / np.maximum(delta / 2 + root, 1e-300), np.maximum(root, 1.0)
    stiff = np.maximum(gamma, 4.0)
    kick = fall / far
    echo = fall / (2 * far * far)
    pair = (kick + delta * echo) / 2
    creeping: Any = 0.0
    if cls is Kick:
        swinging = kick
    elif cls is Coast:
        swinging = fall + delta / 2 * kick
        creeping = slow * np.exp(-slow) / np.maximum(2 * root, 1.0)
    elif cls is Echo:
        swinging = echo
    elif cls is Ebb:
        swinging = echo + fall / stiff
        creeping = (2 + slow) * np.exp(-slow) / np.maximum(2 * root, 2.0) ** 2
        creeping = creeping / np.maximum(delta / 2 + root, 2.0)
    elif cls is NumeratorGapDrop:
        swinging = (1 / stiff / np.maximum(delta, 1.0) + echo) / stiff
    else:
        swinging = ((1 if cls is PlantN1Drop else fall) / stiff + pair) / stiff
    counts = (w < 0) & ((gamma >= 4) | (cls is Coast))
    return np.where(counts, swinging, np.where(w < 0, 0.0, creeping))


def _of_angle(cls: Any, k: Any, x: Any) -> Any:
    n = k + 1
    sine, half, near = np.abs(np.sin(x)), np.sin(x / 2), n * x < 1.5
    if cls is Ripple:
        return np.where(near, np.abs(np.sin(n * x)) / 2, n / np.maximum(sine, 1e-300))
    cube = np.maximum(x, 1e-100) ** 3
    top = 4 * n if cls is SpreadSlope else 2 * n * n * sine + 4 * n * half * half
    return np.where(near, 0.0, top / cube)
