"""What a statement on a computed form says, and its theorem: all its pairs, block by block."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from symhaptic.book.lemmas import stable_boundary as boundary
from symhaptic.book.lemmas import stable_device as device
from symhaptic.book.lemmas import stable_passivity as passivity
from symhaptic.book.lemmas import stable_slope as slope
from symhaptic.book.lemmas.stable_forms import Block
from symhaptic.notation.proposition import Proposition, both
from symhaptic.proof.theorems.kernel import Theorem, conjoined

Shown = tuple[Block, Callable[[], Theorem]]


def _device(block: Block) -> Shown:
    return block, partial(device.device, block)


def _slope(block: Block) -> Shown:
    return block, partial(slope.slope, block)


_LATE = (_device(device.ALL), (device.LATE, device.late))
_NEEDS = (passivity.NEEDS, passivity.needs)
FORMS: dict[str, tuple[Shown, ...]] = {
    "discretize": (_device(device.DISCRETE),),
    "discretize_fractional": _LATE,
    "characteristic_polynomial": (_device(device.POLYNOMIAL),),
    "stability_conditions": (_device(device.CONDITIONS),),
    "is_stable": _LATE,
    "unstable_roots": _LATE,
    "stability_boundary": (
        (boundary.BOUNDARY, partial(boundary.boundary, False)),
        (boundary.LATE_BOUNDARY, partial(boundary.boundary, True)),
        *_LATE,
    ),
    "max_stable_stiffness": (
        *map(_slope, (slope.SEARCHED, slope.EARLY, slope.UNDELAYED)),
        *_LATE,
    ),
    "passivity_margin_at": ((passivity.MARGIN, passivity.margin),),
    "passivity_margin": (_NEEDS,),
    "passivity_boundary": ((passivity.TOUCHED, passivity.touched), _NEEDS),
    "max_passive_stiffness": ((passivity.STIFFEST, passivity.stiffest), _NEEDS),
    "linear_limit": ((passivity.LINEAR, passivity.linear),),
}
"""The blocks of each form, and how each is shown."""


def statement(form: str) -> str:
    """The id of the statement on a form.

    >>> statement("is_stable")
    'computed-is-stable'
    """
    return f"computed-{form.replace('_', '-')}"


def claim(form: str) -> Proposition:
    """That what is computed is what is derived."""
    return both(block.says() for block, _ in FORMS[form])


def theorem(form: str) -> Theorem:
    """That as a theorem; each block is shown once."""
    shown = [prove() for _, prove in FORMS[form]]
    return shown[0] if len(shown) == 1 else conjoined(*shown)


def settle(page: object, form: str, says: str) -> None:
    """State it on a page, and settle it."""
    page.state(statement(form), says, claim=claim(form))  # type: ignore[attr-defined]
    first, *others = FORMS[form]
    example = None if others else first[0].example()
    page.settle(statement(form), theorem(form), example=example)  # type: ignore[attr-defined]
