"""Presets of the explorer: devices and arms, each with where its numbers are from."""

from __future__ import annotations

from typing import NamedTuple

from symhaptic.paper.tables import TABLE_II


class Preset(NamedTuple):
    """A device or an arm; what is not among its values stays as it is."""

    name: str
    values: dict[str, str]
    """m (kg), b (Ns/m), k (N/m), T and t_d (s), K (N/m), B (Ns/m): decimals as published."""
    source: str


def _driver(name: str, K: str, B: str, file: str) -> Preset:
    """The largest wall that a driver allows; mass and damping are not published with it."""
    source = (
        f"K and B are the largest linear stiffness and damping of CHAI3D, src/devices/{file}; mass "
        "and damping stay as they are."
    )
    return Preset(f"{name}, its driver's largest wall", {"K": K, "B": B}, source)


DEVICES = (
    Preset(
        "Phantom Premium 1.5",
        {"m": "0.072", "b": "0.005", "k": "0", "T": "0.001", "t_d": "0.0015", "K": "800", "B": "5"},
        "Mass and damping as published for its first axis; 800 N/m and 5 Ns/m are the largest that "
        "CHAI3D allows for it.",
    ),
    Preset(
        "A one-axis device of a course",
        {"m": "0.04", "b": "0.8", "k": "0", "T": "0.001", "t_d": "0", "K": "1600", "B": "0"},
        "Course notes on haptic rendering, which name 1600 N/m, twice the damping per millisecond.",
    ),
    Preset(
        "Example 5.1 of the paper",
        {"m": "0.1", "b": "0", "k": "0", "T": "0.001", "t_d": "0", "K": "1000", "B": "5"},
        "m = 0.1 kg and T = 1 ms.",
    ),
    _driver("Force Dimension omega", "5000", "30", "CDeltaDevices.cpp"),
    _driver("Force Dimension sigma", "4000", "30", "CDeltaDevices.cpp"),
    _driver("Novint Falcon", "3000", "20", "CDeltaDevices.cpp"),
    _driver("Phantom Omni", "700", "5", "CPhantomDevices.cpp"),
)

ARMS = tuple(
    Preset(
        arm.authors,
        {"m": arm.mass, "b": arm.damping, "k": arm.stiffness},
        f"Table II of the paper, [{arm.reference}]"
        + (", arm and device together." if arm.with_device else "."),
    )
    for arm in TABLE_II
)
