"""Presets of the explorer: devices and arms, each with where its numbers are from."""

from __future__ import annotations

from symhaptic.paper.tables import TABLE_II

DEVICES: tuple[tuple[str, dict[str, float], str], ...] = (
    (
        "Phantom Premium 1.5",
        {"mD": 0.072, "bD": 0.005, "T": 1.0, "td": 1.5, "K": 800.0, "B": 5.0},
        "mass and damping as published for its first axis; 800 N/m and 5 Ns/m are the largest that "
        "CHAI3D allows for it",
    ),
    (
        "A one-axis device of a course",
        {"mD": 0.04, "bD": 0.8, "T": 1.0, "td": 0.0, "K": 1600.0, "B": 0.0},
        "course notes on haptic rendering, which name 1600 N/m, twice the damping per millisecond",
    ),
    (
        "Example 5.1 of the paper",
        {"mD": 0.1, "bD": 0.0, "T": 1.0, "td": 0.0, "K": 1000.0, "B": 5.0},
        "m = 0.1 kg and T = 1 ms",
    ),
)
"""Name, values in SI units (times in ms) and source."""

ARMS: tuple[tuple[str, dict[str, float], str], ...] = (
    ("none, a device that nobody holds", {"mH": 0.0, "bH": 0.0, "kH": 0.0}, "(3) of the paper"),
    *(
        (
            arm.authors,
            {"mH": float(arm.mass), "bH": float(arm.damping), "kH": float(arm.stiffness)},
            f"Table II of the paper, [{arm.reference}]"
            + (", arm and device together" if arm.with_device else ""),
        )
        for arm in TABLE_II
    ),
)
