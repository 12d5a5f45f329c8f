"""Published devices: mass and damping where a source gives them, and the limits of a driver.

The numbers are the published decimals; the arms of the paper are in :mod:`symhaptic.paper.tables`.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Device:
    """One device; a value without a source is ``None``."""

    name: str
    source: str
    """The source of each number."""
    mass: str | None = None
    """m_D in kg."""
    damping: str | None = None
    """b_D in Ns/m."""
    K: str | None = None
    """The largest recommended stiffness in N/m."""
    B: str | None = None
    """The largest recommended virtual damping in Ns/m."""


_CHAI3D = (
    "{K} N/m and {B} Ns/m are the largest linear stiffness and damping of CHAI3D 3, "
    "src/devices/{file}{model}; mass and damping are not published with them."
)


def _driver(name: str, K: str, B: str, file: str, model: str = "") -> Device:
    """A device for which only its driver gives limits."""
    said = f' ("{model}")' if model else ""
    return Device(name, _CHAI3D.format(K=K, B=B, file=file, model=said), K=K, B=B)


DEVICES = (
    Device(
        "Phantom Premium 1.5",
        "Mass and damping as published for its first axis; 800 N/m and 5 Ns/m are the largest "
        'linear stiffness and damping of CHAI3D 3, src/devices/CPhantomDevices.cpp ("PHANTOM '
        'Premium 1.5 6DOF").',
        mass="0.072",
        damping="0.005",
        K="800",
        B="5",
    ),
    Device(
        "A one-axis device of a course",
        "Course notes on haptic rendering: 0.04 kg, 0.8 Ns/m and 1600 N/m at 1 ms, twice the "
        "damping per millisecond.",
        mass="0.04",
        damping="0.8",
        K="1600",
        B="0",
    ),
    Device(
        "Example 5.1 of the paper",
        "m = 0.1 kg, there sampled every millisecond; its damping is left open.",
        mass="0.1",
    ),
    _driver("Force Dimension omega", "5000", "30", "CDeltaDevices.cpp", "omega.3"),
    _driver("Force Dimension delta", "5000", "30", "CDeltaDevices.cpp", "delta.3"),
    _driver("Force Dimension sigma", "4000", "30", "CDeltaDevices.cpp", "sigma.7"),
    _driver("Novint Falcon", "3000", "20", "CDeltaDevices.cpp", "Falcon"),
    _driver("Touch", "400", "4", "CPhantomDevices.cpp", "Touch"),
    _driver("Phantom Omni", "700", "5", "CPhantomDevices.cpp", "PHANTOM Omni"),
    _driver("Phantom Desktop", "1000", "5", "CPhantomDevices.cpp", "PHANTOM Desktop"),
    _driver("Phantom Premium 3.0", "1000", "5", "CPhantomDevices.cpp", "PHANTOM Premium 3.0 6DOF"),
)
"""Devices of field studies, then devices for which only the limits of the driver are known."""
