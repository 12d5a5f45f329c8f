"""What routines and their results are called in source code."""

from __future__ import annotations

import re

_CODE_NAMES = {"C": "cosh_root", "S": "sinhc_root"}

_BRIEF = {
    "denominator_at_minus_one": "at_minus_one", "numerator_at_one": "together",
    "numerator_gap": "n_gap", "plant_n0": "n0", "plant_n1": "n1", "plant_trace": "trace",
    "cos_next": "cosine", "sin_next": "sine", "late_first": "m2", "late_last": "m0",
    "late_apart": "apart", "late_kick": "kicked",
}  # fmt: skip
"""What a result of a routine is called where it is used."""


def code_name(name: str) -> str:
    """The name of a routine in source code.

    >>> code_name("PlantN0Series"), code_name("C")
    ('plant_n0_series', 'cosh_root')
    """
    return _CODE_NAMES.get(name, re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower())


def brief(name: str) -> str:
    """The name of a variable that has the result of a routine, or its part of a joint name.

    >>> brief("plant_n1_of"), brief("plant_n1_of2"), brief("plant_n1"), brief("kick_of")
    ('n1', 'n1_2', 'n1', 'kick_of')
    """
    base, of, number = name.partition("_of")
    if base not in _BRIEF or (of and number and not number.isdigit()):
        return name
    return f"{_BRIEF[base]}_{number}" if number else _BRIEF[base]


def routine_name(name: str) -> str:
    """The name of a routine, from that in source code.

    >>> routine_name("plant_n0_series"), routine_name("cosh_root")
    ('PlantN0Series', 'C')
    """
    special = {code: own for own, code in _CODE_NAMES.items()}
    return special.get(name) or "".join(part.capitalize() for part in name.split("_"))
