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
    "Abs": "sign of the absolute value",
    "above_its_start": "one-sided limits",
    "after_a_blow": "impulse response",
    "all_inside": "roots of a product",
    "amplified": "linearity",
    "atan rises": "monotone arctangent",
    "both ways": "antisymmetry",
    "cos": "sign of the cosine",
    "cos bounded": "bound of the cosine",
    "cos falls": "monotone cosine",
    "cosh": "bound of cosh",
    "degree": "degree",
    "device": "sampled device",
    "device at rest": "static displacement",
    "device forgets": "decay of a damped device",
    "device pushed": "direction of a held force",
    "device turns": "device below the Nyquist frequency",
    "device's loss": "determinant of the device",
    "dissipates": "storage function",
    "equality": "equal or different",
    "exp": "sign of the exponential",
    "exp rises": "monotone exponential",
    "filtered": "Toeplitz forms of a filter",
    "first_minors": "Hurwitz' minors",
    "free late mass": "free mass with a fractional delay",
    "full turns": "period of sine and cosine",
    "held by a pole": "a pole outside",
    "held_answer": "motion under a held force",
    "hurwitz": "Hurwitz' criterion",
    "in_the_limit": "limits of inequalities",
    "increases": "sign of the derivative",
    "induction": "induction",
    "jury": "Jury's criterion",
    "last_coefficient": "Vieta's product of roots",
    "late device": "device with a fractional delay",
    "late device and device": "fractional and integer delays",
    "late held steady state": "steady state with a fractional delay",
    "later": "shift by whole periods",
    "linear": "root of a linear factor",
    "loop of a late device": "loop with a fractional delay",
    "no_other_limit": "uniqueness of limits",
    "none_enters": "continuity of roots to the right",
    "not negative": "whole numbers",
    "not_of_degree": "no such degree",
    "one_answer": "unique response",
    "opposite": "mirrored roots",
    "opposite size": "absolute value of a negative number",
    "order": "total order",
    "outpaces": "phase rate of a polynomial",
    "passive late wall": "passive wall with a fractional delay",
    "polar": "polar coordinates",
    "pole_at": "pole at a point",
    "quotient": "sign of a quotient",
    "rest": "division with remainder",
    "roots_stay": "continuity of roots",
    "sin": "sign of the sine",
    "sin bounded": "bound of the sine",
    "sin rises": "monotone sine",
    "sinh rises": "monotone hyperbolic sine",
    "size": "absolute value",
    "sqrt": "sign of the square root",
    "square": "sign of a square",
    "stored": "stored energy",
    "strictly": "strict order",
    "swing_gains": "repeated motion",
    "swings": "natural frequency",
    "toeplitz": "Toeplitz forms",
    "turns": "a force without response",
    "undamped late device": "undamped device with a fractional delay",
    "units": "change of units",
    "weak quotient": "weak sign of a quotient",
    "zero_on_circle": "a root on the circle",
}
"""Names of classical rules and axioms in a sentence; others have the name of their source."""


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
    'If p(exp(j theta)) = 0 for a real theta, not all zeros lie inside the unit circle.'
    """
    found = next((f for m in _modules().values() if (f := vars(m).get(rule)) is not None), None)
    told = (inspect.getdoc(found) or "").partition(">>>")[0]
    told = re.sub(r"\s*\((?:[a-z ]+)?(?:``\w+``|:mod:`[\w.]+`)\)", "", told)
    return " ".join(told.replace("``", "").split())
