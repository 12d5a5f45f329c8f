"""What can be said of a statement, and on what grounds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sympy import Expr

from symhaptic.notation.proposition import Proposition
from symhaptic.notation.written import written
from symhaptic.proof.certificate import Certificate


class Kind(StrEnum):
    """The verdicts, from the best to the worst."""

    DEFINITION = "definition"
    PROVED = "proved"
    ENCLOSED = "enclosed"
    QUALIFIED = "qualified"
    MISPRINT = "misprint"
    REFUTED = "refuted"
    EXTERNAL = "external"
    SLIP = "slip"
    ARGUED = "argued"
    UNDECIDED = "undecided"


PASSES = frozenset({Kind.DEFINITION, Kind.PROVED, Kind.ENCLOSED})
"""Verdicts of what is right as it stands."""


class Unfounded(ValueError):
    """Grounds that do not support what is claimed of a statement."""


def called(kind: str, argued_for: str | None) -> str:
    """A kind, and what an argument in words claims."""
    return f"{kind} ({argued_for})" if argued_for else str(kind)


@dataclass(frozen=True)
class Verdict:
    """A verdict with its grounds.  True in a condition only when the statement is right.

    ``condition`` is LaTeX; ``corrected`` is a SymPy form; ``counterexample`` gives a value to
    each symbol and may be empty where nothing has to be chosen.
    """

    kind: Kind
    method: str
    condition: str | None = None
    corrected: tuple[Expr, ...] | None = None
    corrected_latex: str | None = None
    counterexample: Mapping[str, str] | None = None
    shows: str | None = None
    """What happens at the counterexample, in words or LaTeX."""
    value: str | None = None
    radius: str | None = None
    note: str | None = None
    argued_for: Kind | None = None
    """What an argument in words claims, of a verdict that is *argued*."""
    claim: Proposition | None = None
    """What the statement claims."""
    rests: tuple[str, ...] = ()
    """The deciders and rules that the theorem rests on."""
    certificate: Certificate | None = field(default=None, repr=False, compare=False)
    """Of an inequality on a box; :func:`symhaptic.recheck` checks it again."""

    @property
    def proposition(self) -> str | None:
        """LaTeX of what the statement claims."""
        return None if self.claim is None else written(self.claim)

    @property
    def claimed(self) -> Kind:
        """The kind, or what is argued for."""
        return self.argued_for or self.kind

    def __bool__(self) -> bool:
        return self.kind in PASSES

    @property
    def named(self) -> str:
        """The kind, and what is argued for."""
        return called(self.kind, self.argued_for)

    def __str__(self) -> str:
        parts = [f"{self.named}: {self.method}"]
        if self.condition:
            parts.append(f"if {self.condition}")
        if self.counterexample:
            at = ", ".join(f"{k} = {v}" for k, v in self.counterexample.items())
            parts.append(f"counterexample {at}")
        return "; ".join(parts)


UNSETTLED = Verdict(Kind.UNDECIDED, "no derivation settles it yet")
