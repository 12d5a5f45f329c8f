"""The parameters and limits of a scene as text, HTML or LaTeX."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from html import escape

from symhaptic.scene.loop import UNITS, DeviceLoop
from symhaptic.scene.walls import (
    binding,
    limit_at,
    max_passive_stiffness,
    max_stable_stiffness,
    quantised_limits,
    why_not_passive,
)


def table(facts: Mapping[str, str]) -> str:
    """Two columns of HTML.

    >>> table({"mass": "0.1 kg"})
    '<table><tr><th>mass</th><td>0.1 kg</td></tr></table>'
    """
    rows = (
        f"<tr><th>{escape(name)}</th><td>{escape(said)}</td></tr>" for name, said in facts.items()
    )
    return f"<table>{''.join(rows)}</table>"


def lines(facts: Mapping[str, str]) -> str:
    """One line for each, the names in a column.

    >>> print(lines({"mass": "0.1 kg", "delay": "1.5 ms"}))
    mass   0.1 kg
    delay  1.5 ms
    """
    width = max(map(len, facts), default=0)
    return "\n".join(f"{name:<{width}}  {said}" for name, said in facts.items())


def facts(scene: DeviceLoop) -> dict[str, str]:
    """Parameters and limits of a scene, with units."""
    units = {name: UNITS[name] for name in ("mass", "inertia", "damping", "stiffness")}
    given = {name: (getattr(scene, name), scene.printed(unit)) for name, unit in units.items()}
    given["sampling_period"] = scene.sampling_period, "s"
    found = {
        name.replace("_", " "): f"{value:g} {unit}"
        for name, (value, unit) in given.items()
        if value is not None
    }
    if scene.parts.delay:
        seconds = float(scene.periods) * scene.sampling_period
        found["delay"] = f"{seconds:g} s, {float(scene.periods):g} sampling periods"
    if scene.arm is not None:
        found["arm"] = str(scene.arm)
    found |= _parts(scene)
    if scene.further and scene.engine.unlimited:
        found["stable up to"] = (
            "no upper limit, because the coupling is stable with a rigid wall; "
            "a softer wall may be unstable"
        )
    else:
        most, free = max_stable_stiffness(scene), limit_at(scene, 0.0)
        found["stable up to"] = _limit(scene, most.K, most.frequency_hz, most.B)
        found["without B"] = _limit(scene, free.K, free.frequency_hz)
    if why := why_not_passive(scene):
        found["passive up to"] = f"not computed ({why})"
    elif scene.damping:
        safe = max_passive_stiffness(scene)
        found["passive up to"] = _limit(scene, safe.K, safe.frequency_hz, safe.B)
    else:
        found["passive up to"] = "nothing, because the device has no damping"
    if scene.encoder is not None and not why_not_passive(replace(scene, velocity=None)):
        found["with encoder"] = quantised(scene)
    if scene.arm is not None:  # (2) and (3)
        found["stable up to"] += ", device and arm"
        found["passive up to"] += ", device alone"
    return found


def quantised(scene: DeviceLoop) -> str:
    """Up to which stiffness a wall is passive with the encoder, and what limits it."""
    if not scene.coulomb_friction:
        return "nothing: without Coulomb friction, the steps can sustain an oscillation at any K"
    limits, unit = quantised_limits(scene), scene.printed("N/m")
    least = binding(limits)
    (other,) = set(limits) - {least}
    if math.isnan(limits[least]):
        return f"nothing without B: {least} does not suffice for the virtual mass"
    return (
        f"passive up to {limits[least]:.4g} {unit} without B, limited by {least}; "
        f"{other} would allow {limits[other]:.4g} {unit}"
    )


def _parts(scene: DeviceLoop) -> dict[str, str]:
    """The parts that the paper's loop does not have, in words."""
    own = {
        name: getattr(scene, name)
        for name in ("dynamics", "velocity", "actuator", "structure", "coupling", "encoder")
    }
    found = {name: part.words for name, part in own.items() if part is not None}
    if scene.integrator != "hold":
        found["integrator"] = scene.integrator
    for name, unit in (("virtual_mass", "kg"), ("coulomb_friction", "N")):
        if (value := getattr(scene, name)) is not None:
            found[name.replace("_", " ")] = f"{value:g} {scene.printed(unit)}"
    return found


def _limit(scene: DeviceLoop, K: float, hz: float, B: float | None = None) -> str:
    if not (math.isfinite(K) and K > 0):
        return "nothing"
    found = f"{K:.4g} {scene.printed('N/m')}"
    if B is not None:
        found += f" with B = {B:.4g} {scene.printed('N*s/m')}"
    return f"{found}, at {hz:.4g} Hz" if math.isfinite(hz) else found


def latex(scene: DeviceLoop) -> str:
    r"""The parameters and the dimensionless ones of Table I, as LaTeX, and parts in words.

    With an arm, gamma and delta are those of device and arm together.

    >>> from symhaptic.scene.scene import Scene
    >>> print(latex(Scene(mass=0.1, sampling_period=0.001, delay=0.001)))
    $m = 0.1\,\mathrm{kg},\ T = 0.001\,\mathrm{s},\ t_d = 0.001\,\mathrm{s};\ d = 1$
    """
    n, arm = scene.dimensionless, scene.arm
    seconds = float(scene.periods) * scene.sampling_period
    device = "" if arm is None else "_D"
    mass, damped, stiff = (_latex_unit(scene.printed(unit)) for unit in ("kg", "N*s/m", "N/m"))
    parts = [
        (f"m{device}", scene.mass, mass),
        (f"J{device}", scene.inertia, mass),
        (f"b{device}", scene.damping, damped),
        (f"k{device}", scene.stiffness, stiff),
    ]
    if arm is not None:
        parts += [
            ("m_H", arm.mass, mass),
            ("J_H", arm.inertia, mass),
            ("b_H", arm.damping, damped),
            ("k_H", arm.stiffness, stiff),
        ]
    parts += [
        ("T", scene.sampling_period, "s"),
        ("t_d", seconds if scene.parts.delay else None, "s"),
    ]
    given = [rf"{s} = {_number(v)}\,\mathrm{{{unit}}}" for s, v, unit in parts if v is not None]
    without = [
        rf"{symbol} = {_number(value)}"
        for symbol, value, there in (
            (r"\gamma", n.gamma, scene.parts.stiffness),
            (r"\delta", n.delta, scene.parts.damping),
            ("d", n.delay, scene.parts.delay),
        )
        if there
    ]
    both = [r",\ ".join(each) for each in (given, without) if each]
    joined = r";\ ".join(both)
    words = [rf"\text{{{name}: {said}}}" for name, said in _parts(scene).items()]
    joined = r";\ ".join([joined, *words])
    return f"${joined}$"


def _latex_unit(unit: str) -> str:
    r"""A unit inside ``\mathrm``.

    >>> _latex_unit("N m s/rad"), _latex_unit("kg m^2")
    ('N\\,m\\,s/rad', 'kg\\,m^2')
    """
    return unit.replace(" ", r"\,")


def _number(value: float) -> str:
    r"""A number of six digits as LaTeX.

    >>> _number(0.25), _number(2.5e-7)
    ('0.25', '2.5\\cdot 10^{-7}')
    """
    text = f"{value:.6g}"
    digits, _, power = text.partition("e")
    return text if not power else rf"{digits}\cdot 10^{{{int(power)}}}"
