"""What has to be believed: the rules of the kernel, the deciders, classical theorems, meanings."""

from __future__ import annotations

import inspect
import re
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from types import ModuleType

from symhaptic.proof.theorems.axioms import AXIOMS
from symhaptic.proof.theorems.derivation import sources
from symhaptic.proof.theorems.kernel import MODULES

NAMES: Mapping[str, str] = {
    "above_its_start": "one-sided limits",
    "all_inside": "roots of a product",
    "degree": "degree",
    "dissipates": "storage function",
    "filtered": "Toeplitz forms of a filter",
    "from_there_on": "monotony",
    "held_answer": "motion under a held force",
    "held_by_a_pole": "a pole outside",
    "held_steady_state": "held steady state",
    "increases": "sign of the derivative",
    "in_the_limit": "limits of inequalities",
    "in_units": "change of units",
    "induction": "induction",
    "jury": "Jury's criterion",
    "last_coefficient": "Vieta's product of roots",
    "linear": "root of a linear factor",
    "no_other_limit": "uniqueness of limits",
    "none_enters": "continuity of roots to the right",
    "not_of_degree": "degree, denied",
    "pole_at": "pole at a point",
    "roots_stay": "continuity of roots",
    "stored": "stored energy",
    "swing_gains": "repeated swing",
    "toeplitz": "Toeplitz forms",
    "zero_beyond": "a root at 1 or beyond",
    "zero_on_circle": "a root on the circle",
}
"""Short names of classical rules; others are called by what their source calls them."""


def _modules() -> dict[str, ModuleType]:
    return {name: import_module(f"symhaptic.proof.theorems.{name}") for name in MODULES}


@cache
def classical() -> Mapping[str, str]:
    """Each classical rule and each axiom with its source."""
    return sources()


def called(rule: str) -> str:
    """What a classical rule is called in a sentence: "by continuity of roots"."""
    if rule in NAMES:
        return NAMES[rule]
    if rule in AXIOMS:
        return rule
    name, _, rest = classical().get(rule, "").partition(";")
    return name if rest and len(name) < 40 else rule.replace("_", " ")


@cache
def others() -> Mapping[str, Mapping[str, str]]:
    """The rules of each module that are not classical, with what they say."""
    found = {}
    for name, module in _modules().items():
        found[name] = {
            rule: says(rule)
            for rule, function in vars(module).items()
            if inspect.isfunction(function)  # what only keeps its values is none
            and hasattr(function, "__wrapped__")
            and getattr(function, "__module__", "") == module.__name__
            and rule not in classical()
        }
    return {name: rules for name, rules in found.items() if rules}


@cache
def says(rule: str) -> str:
    """What a rule says, hypotheses and all: its docstring without names of arguments and examples.

    >>> says("zero_on_circle")
    'p(exp(j theta)) = 0 for a real theta gives that not all zeros lie inside.'
    """
    found = next((f for m in _modules().values() if (f := vars(m).get(rule)) is not None), None)
    told = (inspect.getdoc(found) or "").partition(">>>")[0]
    told = re.sub(r"\s*\((?:[a-z ]+)?(?:``\w+``|:mod:`[\w.]+`)\)", "", told)
    return " ".join(told.replace("``", "").split())
