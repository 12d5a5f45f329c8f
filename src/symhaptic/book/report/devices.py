"""Presets of the explorer: devices and arms, each with where its numbers are from."""

from __future__ import annotations

from typing import NamedTuple

from symhaptic.paper.tables import TABLE_II
from symhaptic.rules import devices as published


class Preset(NamedTuple):
    """A device or an arm; what is not among its values stays as it is."""

    name: str
    values: dict[str, str]
    """Decimals as published: of a device m (kg), b (Ns/m), k (N/m), T and t_d (s), K (N/m) and
    B (Ns/m), of an arm m_H, b_H, k_H and whether they include the device."""
    source: str


_LATE = {"Phantom Premium 1.5": "0.0015"}
"""Delays in s at which the explorer shows a device; 0 otherwise."""

_SOFT = {"K": "1000", "B": "5"}
"""The wall at which it shows a device for which none is recommended."""


def _preset(device: published.Device) -> Preset:
    """What is published of a device."""
    moved = _moved(device) if device.mass else {}
    known = {k: v for k, v in {**moved, "K": device.K, "B": device.B}.items() if v is not None}
    if moved:
        return Preset(device.name, {**_SOFT, **known}, device.source)
    stays = " In the explorer they stay as they are."
    return Preset(f"{device.name}, its driver's largest wall", known, device.source + stays)


def _moved(device: published.Device) -> dict[str, str | None]:
    """A device of known mass, at rest at 1 kHz."""
    late = _LATE.get(device.name, "0")
    return {"m": device.mass, "b": device.damping or "0", "k": "0", "T": "0.001", "t_d": late}


DEVICES = tuple(map(_preset, published.DEVICES))

ARMS = tuple(
    Preset(
        arm.authors,
        {
            "m_H": arm.mass,
            "b_H": arm.damping,
            "k_H": arm.stiffness,
            "with_device": str(int(arm.with_device)),
        },
        f"Table II of the paper, [{arm.reference}]"
        + (", arm and device together." if arm.with_device else "."),
    )
    for arm in TABLE_II
)
