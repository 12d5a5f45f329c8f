"""The slips in plain words, as relations between what is printed in one place and in another.

What has to be believed is the transcription of the print: the numbers and names in
:mod:`symhaptic.paper.outline` and the tables.  Each number below is read from there.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from sympy import Integer, Rational

from symhaptic.notation import SYMBOLS, TABLE_I, T, m
from symhaptic.notation.proposition import Proposition, Relation, both
from symhaptic.paper import outline, tables
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed

MORE = 3
"""One author and others are three at least: Table II writes both names of [27]."""


def same(one: int | Fraction, other: int | Fraction) -> Proposition:
    """Two numbers are the same."""
    return Relation(Rational(one), "=", Rational(other))


def at_least(low: int, high: int) -> Proposition:
    """One number is at most the other."""
    return Relation(Integer(low), "<=", Integer(high))


def conclusion_is(section: int) -> Proposition:
    """The number of a section is that of the section headed Conclusion."""
    return same(section, outline.SECTIONS.index("Conclusion") + 1)


@claims("s1-conclusion")
def _conclusion(printed: Printed) -> Proposition:
    """The section that is named is the one with this heading."""
    return conclusion_is(outline.conclusion_named())


def ratio_in(panels: Sequence[str]) -> Proposition:
    """As many of these panels show the ratio as are named, and as many as there are."""
    shown = [panel.name for panel in outline.FIGURE_12 if panel.quantity == "ratio"]
    right = sum(name in shown for name in panels)
    return both([same(right, len(panels)), same(right, len(shown))])


@claims("s5b-ratio-panels")
def _ratio(printed: Printed) -> Proposition:
    """The panels that are named are those with the ratio on their axis."""
    return ratio_in(outline.ratio_named())


def told_apart(parts: Sequence[str]) -> Proposition:
    """In one of these parts at least, (b) is not (c)."""
    second, third = outline.FIGURE_12[1:]
    return at_least(1, sum(getattr(second, part) != getattr(third, part) for part in parts))


@claims("s5b-captions-alike")
def _captions(printed: Printed) -> Proposition:
    """What a caption is for: it names something in which its plot is not the other."""
    return told_apart(outline.CAPTION)


def called(name: str) -> Proposition:
    """The row of Table I with this name is that of B."""
    rows = [[row.parameter for row in TABLE_I], [row.variable for row in TABLE_I]]
    return same(rows[0].index(name) + 1, rows[1].index("B") + 1)


@claims("s4d-bound-of-b")
def _bound_of_damping(printed: Printed) -> Proposition:
    """The name that the text gives to B is the one of Table I, row for row."""
    return called(outline.name_of_b())


def damping_has_the_unit() -> Proposition:
    """B is the virtual damping of Table I, in the unit of m/T, in which its bound is linear."""
    damping = SYMBOLS["B"].dimension
    powers = [SYMBOLS[str(s)].dimension for s in (m, T)]
    unit = [of_m - of_t for of_m, of_t in zip(*powers, strict=True)]
    return both([called("virtual damping"), *map(same, unit, damping)])


def written_with_others() -> list[tables.Arm]:
    """The rows of Table II that name one author and others."""
    return [row for row in tables.TABLE_II if "et al." in row.authors]


@claims("s4c-et-al")
def _others(printed: Printed) -> Proposition:
    """Where one author and others are named, the list of references has three or more."""
    return both([at_least(MORE, row.writers) for row in written_with_others()])


def two_names(numbers: Sequence[int]) -> Proposition:
    """These articles have two authors, as [27] has, and the others of those rows three or more."""
    rows = written_with_others()
    both_named = [row for row in tables.TABLE_II if row.reference == 27]
    pairs = [row for row in rows if row.reference in numbers]
    rest = [row for row in rows if row.reference not in numbers]
    two = [same(row.writers, 2) for row in (*pairs, *both_named)]
    return both([*two, *(at_least(MORE, row.writers) for row in rest)])
