"""What can be said of a statement, and on what grounds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from symhaptic.notation.proposition import Proposition
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
    UNDECIDED = "undecided"


PASSES = frozenset({Kind.DEFINITION, Kind.PROVED, Kind.ENCLOSED})
"""Verdicts of what is right as it stands."""


class Unfounded(ValueError):
    """Grounds that do not support what is claimed of a statement."""


@dataclass(frozen=True, repr=False)
class Verdict:
    """A verdict with its reasons.  As a truth value, true only if the statement is right.

    ``condition`` and ``corrected`` are LaTeX; ``counterexample`` gives a value to each symbol and
    is empty if there is no symbol.  :func:`symhaptic.prove` returns it, and printed it is a
    sentence.
    """

    kind: Kind
    method: str
    condition: str | None = None
    corrected: str | None = None
    counterexample: Mapping[str, str] | None = None
    shows: str | None = None
    """What happens at the counterexample, in words or LaTeX."""
    value: str | None = None
    radius: str | None = None
    note: str | None = None
    claim: Proposition | None = field(default=None)
    """What the statement claims."""
    proposition: str | None = None
    """LaTeX of the same."""
    definitions: tuple[str, ...] = ()
    """Definitions of the chapter from which the statement follows, in LaTeX."""
    rests: tuple[str, ...] = ()
    """The deciders and rules that the theorem rests on."""
    certificate: Certificate | None = field(default=None, compare=False)
    """Of an inequality on a box; :func:`symhaptic.recheck` checks it again."""

    def __bool__(self) -> bool:
        return self.kind in PASSES

    def __repr__(self) -> str:
        """The sentence, which pytest shows if ``assert prove(...)`` fails."""
        return f"<{self}>"

    def __str__(self) -> str:
        parts = [f"{self.kind}: {self.method}"]
        if self.condition:
            parts.append(f"if {self.condition}")
        if self.counterexample:
            at = ", ".join(f"{k} = {v}" for k, v in self.counterexample.items())
            parts.append(f"counterexample {at}")
        return "; ".join(parts)


UNSETTLED = Verdict(Kind.UNDECIDED, "no derivation settles it yet")
