"""What a theorem rests on; nothing here has to be believed."""

from __future__ import annotations

from symhaptic.proof.theorems import analysis, energy, roots, samples
from symhaptic.proof.theorems.axioms import AXIOMS
from symhaptic.proof.theorems.kernel import Theorem


def sources() -> dict[str, str]:
    """Each classical rule and each axiom with where it is from."""
    rules = analysis.SOURCES | energy.SOURCES | roots.SOURCES | samples.SOURCES
    return rules | {name: axiom.source for name, axiom in AXIOMS.items()}


def leaves_of(theorem: Theorem) -> dict[str, int]:
    """The rules and axioms that a theorem rests on, with how often each is used."""
    seen: set[int] = set()
    counts: dict[str, int] = {}
    stack = [theorem]
    while stack:
        part = stack.pop()
        if id(part) not in seen:
            seen.add(id(part))
            name = part.given[0] if part.rule == "known" else part.rule
            counts[name] = counts.get(name, 0) + 1
            stack += part.premises
    return counts
