"""A formula of the paper: as printed, as derived, with its units, its domain and its verdict."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import sympy as sp

from symhaptic.book.chapters import run, shipped
from symhaptic.book.listing import needed
from symhaptic.book.sources import STATEMENTS
from symhaptic.forms.stable import FOR_ONE_DELAY, form
from symhaptic.forms.stable import STATEMENTS as FORMS_OF
from symhaptic.notation import SYMBOLS, Notation
from symhaptic.notation.latex import latex
from symhaptic.notation.suggest import suggested
from symhaptic.paper.reading import Printed
from symhaptic.proof.units import UnitError, dimension_of, shown
from symhaptic.proof.verdict import Verdict


@dataclass(frozen=True)
class Formula:
    """One formula of the paper.

    ``printed`` is the formula as published, misprints included; ``derived`` is the formula that the
    package derives.  Both are tuples with one relation per published line or vector component.
    :func:`symhaptic.formula` returns it.
    """

    id: str
    location: str
    says: str
    printed: Printed
    derived: Printed
    domain: str
    verdict: Verdict

    @property
    def symbols(self) -> dict[sp.Symbol, Notation]:
        """The symbols of both forms, with unit, domain and meaning."""
        found: set[sp.Symbol] = set()
        for part in (*self.printed, *self.derived):
            found |= part.free_symbols
        return {s: SYMBOLS[s.name] for s in sorted(found, key=str) if s.name in SYMBOLS}

    @property
    def units(self) -> tuple[str, ...]:
        """The unit of each published line, or the error in its units."""
        units = []
        for part in self.printed:
            try:
                units.append(shown(dimension_of(part)))
            except UnitError as wrong:
                units.append(str(wrong))
        return tuple(units)

    @property
    def stable(self) -> tuple[sp.Expr, ...]:
        """The numerically stable form in dimensionless arguments; empty if there is none.

        It contains entire functions of the package, which ``symhaptic.forms.entire.written_out``
        writes out.  A polynomial, such as (18), has a form for each integer delay, and none here.
        """
        named = (name for name, ids in FORMS_OF.items() if self.id in ids)
        every = (name for name in named if name not in FOR_ONE_DELAY)
        return tuple(part for name in every for part in form(name).expressions)

    def _repr_latex_(self) -> str:
        lines = r" \\ ".join(latex(part) for part in self.derived)
        return rf"$\displaystyle \begin{{gathered}} {lines} \end{{gathered}}$"


@cache
def _settled(path: Path) -> dict[str, tuple[Printed, Verdict]]:
    """What one derivation settles."""
    return {
        id: (settled.settlement.derived, settled.verdict)
        for id, settled in run(path).page.settled.items()
    }


def formula(id: str) -> Formula:
    """Return a formula of the paper; the first call runs its derivation.

    Parameters
    ----------
    id : str
        The id of the formula, such as ``"eq11"``.

    Returns
    -------
    Formula
        With ``printed``, ``derived``, ``stable``, ``symbols``, ``units``, ``domain`` and
        ``verdict``.

    Raises
    ------
    ValueError
        If the id has no published or derived formula.

    Examples
    --------
    >>> eq6 = formula("eq6")
    >>> eq6.derived[0], str(eq6.verdict.kind), eq6.units
    (b > K*T/2 + Abs(B), 'qualified', ('Ns/m',))
    """
    word = id if isinstance(id, str) else ""
    found: dict[str, tuple[Printed, Verdict]] = {}
    for path in needed([word], shipped()):
        found |= _settled(path)
    statement = STATEMENTS.get(word)
    derived, verdict = found.get(word, ((), None))
    if statement is None or verdict is None or not (statement.printed or derived):
        known = [k for k, known in STATEMENTS.items() if known.printed]
        close = suggested(id, known, "`symhaptic verify --list` lists all")
        raise ValueError(f"id: {id!r} is not a formula; {close}")
    return Formula(
        id,
        statement.location,
        statement.says,
        statement.printed,
        derived,
        statement.domain,
        verdict,
    )
