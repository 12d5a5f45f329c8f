"""A device that is sampled once, and the functions that judge walls with its numbers.

A target that has records writes one function that finds the numbers of device and delay, and for
each verdict one that takes them with the wall.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.export.passes import hoisted, merged, of_form, with_late_device
from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine, choose, names, parts, replaced
from symhaptic.export.routines.margin import SAMPLED
from symhaptic.forms import fractional_delay
from symhaptic.forms.device_forms import across_of, device_of, fractional_of
from symhaptic.forms.form import Form, NoForm, either
from symhaptic.forms.implicit import LOOP, DelayMargin
from symhaptic.forms.root_count import ARGUMENTS, FRACTIONAL_ARGUMENTS
from symhaptic.model.parts import Parts
from symhaptic.notation import d, delta, epsilon, gamma

MARGIN = "delay_margin"
"""The form that is for targets that sample a device alone, where it is asked for by name."""

JUDGES = ("is_stable", "unstable_roots", "verdict", MARGIN)
"""Functions of a wall and a device."""

_DEVICE = (gamma, delta, d)

_WHOLE, _PART = sp.symbols("whole part")
"""The whole periods of the delay, and the fraction."""

_COUNTS = {
    "WholeRoots": ARGUMENTS,
    "FreeStable": tuple(s for s in ARGUMENTS if s != gamma),
    "FractionalRoots": FRACTIONAL_ARGUMENTS,
}
"""What these call their arguments."""


def with_verdict(forms: Iterable[Form]) -> Iterator[Form]:
    """The forms, and beside `is_stable` one that says whether its answer is certain."""
    for form in forms:
        yield form
        if form.name == "is_stable":
            ((_, verdict),) = form.results
            title = "1 if the loop is stable, 0 if it is not, -1 if rounding leaves it undecided"
            results, outside = (("verdict", verdict),), sp.Integer(-1)
            yield replace(form, name="verdict", title=title, results=results, outside=outside)


def delay_margin(stable: Form) -> Form:
    """The form of the delay that may be added, made of that of `is_stable`."""
    if d not in stable.arguments:
        raise NoForm(f"{MARGIN}: is about a delay, and the scene has none")
    ((_, verdict),) = stable.results
    loop = (s if s in stable.arguments else sp.S.Zero for s in LOOP)
    title = (
        "delay that may be added before a root reaches the unit circle, rounded down; 0 if the "
        "loop is not certainly stable, infinite if no delay makes it unstable, NaN if unknown (C "
        "only)"
    )
    added = (("added", DelayMargin(verdict, *loop)),)
    return replace(stable, name=MARGIN, title=title, results=added, outside=sp.nan)


def sampled_at(forms: Iterable[Form], precision: Precision) -> dict[str, Routine]:
    """What finds the numbers of a device at any delay, where a delay margin is asked for."""
    margin = next((form for form in forms if form.name == MARGIN), None)
    if margin is None:
        return {}
    scene = Parts(stiffness=gamma in margin.arguments, damping=delta in margin.arguments)
    x, late, last = device_of(scene), fractional_of(scene), fractional_delay.ends(scene)
    kick = fractional_delay.brief(scene, sp.S.One).kick
    kicked = fractional_delay.brief(scene, 1 - epsilon).kick
    numbers = (
        x.n1, either(x.n1, last[0]), either(sp.S.Zero, last[1]), x.at_minus_one, x.loss, x.together,
        either(x.apart, late.apart), either(x.n1, across_of(scene) / 2), kick,
        either(sp.S.Zero, kicked),
    )  # fmt: skip
    results = tuple(zip(SAMPLED, numbers, strict=True))
    form = replace(margin, name="SampledAt", title="a device with a delay", results=results,
                   arguments=_DEVICE)  # fmt: skip
    made = merged(of_form(with_late_device(form), precision))
    return {"SampledAt": replace(made, record="Sampled", within=())}


def apart(forms: Iterable[Form], precision: Precision) -> tuple[Routine, ...]:
    """What finds the numbers of a device, and each function that judges a wall with them.

    Nothing if there is no such function, or if the device has no parameters.
    """
    forms = [form for form in forms if form.name in JUDGES]
    if not forms:
        return ()
    together = tuple((form.name, expr) for form in forms for _, expr in form.results)
    joint = merged(of_form(replace(forms[0], results=together), precision))
    device, wall = hoisted(joint, _DEVICE)
    if device is None:
        return ()
    within = dict(zip(joint.arguments, joint.within, strict=True))
    own = tuple(s for s in joint.arguments if s not in _DEVICE)
    made = {s for step in wall.steps for s in names(step)}
    fields = _fields(wall, device.arguments, {*own, *made})
    wall = replaced(wall, {expr: field for field, expr in fields.items()})
    late = _late(device)
    some = {f: e for f, e in fields.items() if e.free_symbols & late}
    steps = tuple((f, choose(sp.Eq(_PART, 0), 0, e)) for f, e in some.items())
    device = replace(
        device,
        name="device_init",
        steps=(*device.steps, *steps),
        results=tuple((f.name, f if f in some else e) for f, e in fields.items()),
        within=tuple(within[s] for s in device.arguments),
        outside=sp.nan,
    )
    there = sp.Ge(device.arguments[0], 0)  # all numbers are NaN outside of the domain
    ranges = (*(within[s] for s in own), there)
    judges = (
        replace(
            wall,
            name=f"device_{form.name}",
            arguments=(*own, *fields),
            results=(result,),
            within=ranges,
            outside=form.outside,
        )
        for form, result in zip(forms, wall.results, strict=True)
    )
    return (device, *judges)


def _fields(wall: Routine, given: tuple[Symbol, ...], own: set[Symbol]) -> dict[Symbol, Expr]:
    """The names of all numbers of the device that a wall is judged with, and what they are."""
    found: dict[Expr, Symbol] = {s: s for s in given}
    calls = {type(p).__name__: p for p in parts(wall.expressions) if isinstance(p, sp.Function)}
    for kind, arguments in _COUNTS.items():
        given_to = calls[kind].args if kind in calls else ()
        for argument, expr in zip(arguments, given_to, strict=False):
            if expr.is_number or expr in found or expr.free_symbols & own:
                continue
            late = "delayed_" * (argument in found.values())
            found[expr] = expr if expr == _WHOLE else Symbol(f"{late}{argument.name}")
    left = replaced(wall, found).expressions
    asked = {s for e in left for s in e.free_symbols} - own - {*found.values()}
    found |= {s: s for s in sorted(asked, key=lambda s: str(s.name))}
    return {field: expr for expr, field in found.items()}


def _late(device: Routine) -> set[Symbol]:
    """What is asked for only where there is a fraction."""
    found: set[Symbol] = set()
    for step in device.steps:
        free = step[1].free_symbols if isinstance(step, tuple) else step.free_symbols
        if free & {_PART, *found}:
            found |= set(names(step))
    return found
