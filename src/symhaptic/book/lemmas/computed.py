"""What a statement on a computed form says, and its theorem: its pairs, block by block."""

from __future__ import annotations

from importlib import import_module

from symhaptic.book.lemmas.stable_forms import Block
from symhaptic.book.page import Page
from symhaptic.notation.proposition import Proposition, both
from symhaptic.proof.theorems.kernel import Theorem, conjoined

FORMS = {
    "discretize": ("device", "DISCRETE"),
    "discretize_fractional": ("device", "ALL", "LATE"),
    "characteristic_polynomial": ("device", "POLYNOMIAL"),
    "stability_conditions": ("device", "CONDITIONS"),
    "is_stable": ("device", "ALL", "LATE"),
    "unstable_roots": ("device", "ALL", "LATE"),
    "stability_boundary": ("boundary", "BOUNDARY", "LATE_BOUNDARY"),
    "max_stable_stiffness": ("slope", "SEARCHED", "EARLY", "UNDELAYED"),
    "passivity_margin_at": ("need", "MARGIN"),
    "passivity_margin": ("need", "NEEDS"),
    "passivity_boundary": ("walls", "TOUCHED"),
    "max_passive_stiffness": ("walls", "STIFFEST", "LATE_STIFFEST"),
    "linear_limit": ("walls", "LINEAR"),
}
"""The module beside this one, and the blocks in it, that are a form's own."""

RESTS = {
    "stability_boundary": "discretize_fractional",
    "max_stable_stiffness": "discretize_fractional",
    "passivity_boundary": "passivity_margin",
    "max_passive_stiffness": "passivity_margin",
}
"""Forms that are made, beside, of what the statement on another form is about."""


def blocks(form: str) -> tuple[Block, ...]:
    """The blocks of a form."""
    module, *names = FORMS[form]
    home = import_module(f".stable_{module}", __package__)
    return tuple(getattr(home, name) for name in names)


def statement(form: str) -> str:
    """The id of the statement on a form.

    >>> statement("is_stable")
    'computed-is-stable'
    """
    return f"computed-{form.replace('_', '-')}"


def claim(form: str) -> Proposition:
    """That what is computed is what is derived."""
    return both(block.says() for block in blocks(form))


def theorem(form: str) -> Theorem:
    """That as a theorem; a block is shown once."""
    shown = [block.theorem for block in blocks(form)]
    return shown[0] if len(shown) == 1 else conjoined(*shown)


def settle(page: Page, form: str, says: str) -> None:
    """State it on a page, and settle it."""
    page.state(statement(form), says, claim=claim(form))
    first, *others = blocks(form)
    example = None if others else first.example()
    page.settle(statement(form), theorem(form), example=example)
