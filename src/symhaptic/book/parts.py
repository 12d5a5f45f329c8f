"""The parts of the book: a chapter finds its part by the section in its name."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import TypeVar

from symhaptic.book.chapters import shipped

_Item = TypeVar("_Item")


@dataclass(frozen=True)
class Part:
    """Chapters that belong together, by how their names begin behind the ``s``."""

    title: str
    sections: tuple[str, ...]
    opening: str
    """What the part asks and finds, in a paragraph; formulas between dollar signs."""


PARTS = (
    Part(
        "Foundations",
        ("2", "4a", "4b", "4c"),
        "A user moves a device. A computer reads its position once per period $T$ and commands "
        "the force of a spring $K$ and a damper $B$, with a delay of $d$ periods. This part "
        "derives the loop from these assumptions alone. It solves Newton's law between the "
        "samples, compares the power $z^{-d}$ with an exact delay, reduces the loop to five "
        "dimensionless parameters, and examines the published data of human arms.",
    ),
    Part(
        "Passivity",
        ("3",),
        "A wall is passive if no motion of the device extracts energy from it. The only loss of "
        "the device is its damping $b$, so the question is which damping the wall requires at "
        "each frequency. The answer is a line in the plane of $K$ and $B$ for each angle "
        "$\\theta=\\omega T$. These lines envelop the passive region, and the tip of the region "
        "is the passive wall of maximum stiffness.",
    ),
    Part(
        "Stability",
        ("4d",),
        "A loop is stable if all roots of its characteristic polynomial lie inside the unit "
        "circle. A root can leave only across the circle, and the walls with a root on the "
        "circle form an explicit curve. The chapters of this part follow this curve from its "
        "start, count the roots on either side, and show how mass, spring, damper, delay and "
        "sampling period change the stable region.",
    ),
    Part(
        "The linear condition",
        ("4e",),
        "Close to the origin the stability boundary is nearly a straight line: the damping of "
        "wall and device must exceed the stiffness times the delay, including that of the hold. "
        "These chapters derive the line, its distance from the boundary, and the side on which "
        "its walls are unstable.",
    ),
    Part(
        "Passivity and stability compared",
        ("5", "6_"),
        "A passive wall is stable with every spring and damper that an arm may add, but it is "
        "less stiff. This part compares the maximum stiffness of passive and stable walls, with "
        "the damping that counts for each. It shows what happens when the stiffness of a wall "
        "is reduced, when a spring reaches the Nyquist frequency, and when spring, damper and "
        "sampling rate change.",
    ),
    Part(
        "Fractional delays",
        ("6",),
        "Measured delays are seldom integer multiples of the period. The force then changes "
        "within a period, and the power $z^{-d}$ is only an approximation. In this part the "
        "delayed force is sampled exactly, for every delay $(\\ell+\\varepsilon)T$. Passivity, "
        "stability and their boundaries are derived again and compared with the approximation.",
    ),
    Part(
        "Rules in circulation",
        ("8",),
        "In practice the stiffness of a wall is often limited by rules that are shorter than "
        "the formulas of this book. In this part each rule is a statement like those of the "
        "paper, with its users: for which walls is it safe, and which wall is a counterexample? "
        "The last chapter says which rule to use when.",
    ),
    Part(
        "Other loops",
        ("10",),
        "Real loops have a velocity filter, a simulated mass, an encoder with finite "
        "resolution, or an actuator with a lag. Each chapter of this part derives one such loop "
        "from physics, finds its passive or stable walls, and tests the rules of thumb for it.",
    ),
    Part(
        "Forms for computing",
        ("9",),
        "A formula that is right may still be useless in floating-point arithmetic: it can be "
        "0/0, or lose digits by cancellation. The computed and exported forms are therefore "
        "written in other functions. In this part each computed formula is proved equal to the "
        "derived one. For a value that is found by a search, the criterion of the search is "
        "proved. Round-off errors are measured and are not part of a theorem.",
    ),
    Part(
        "What is wrong",
        ("7",),
        "Most errors of the paper appear where the formula is derived. Those that belong to no "
        "derivation are collected here. The errata that follow this part list all of them, each "
        "with the correct result.",
    ),
)
"""In the order of the book."""

OWN = Part("Chapters of your own", (), "Derivations beside those of the paper.")
"""Where a chapter stands whose name has no section of the paper."""


def part_of(name: str) -> Part:
    """The part whose sections begin the name with the most letters.

    >>> part_of("s6_gains").title, part_of("s6a_fractional_plant").title
    ('Passivity and stability compared', 'Fractional delays')
    """
    found = [
        (len(section), part)
        for part in PARTS
        for section in part.sections
        if name.startswith(f"s{section}")
    ]
    return max(found, key=lambda one: one[0])[1] if found else OWN


def in_parts(items: Iterable[_Item], name: Callable[[_Item], str]) -> list[_Item]:
    """Chapters, or what stands for them, in the order of the book; within a part as they come."""
    order = {part.title: at for at, part in enumerate((*PARTS, OWN))}
    return sorted(items, key=lambda item: order[part_of(name(item)).title])


@cache
def numbers() -> Mapping[str, int]:
    """Number of each chapter of the book, by its name."""
    names = in_parts([path.stem for path in shipped()], lambda name: name)
    return {name: number for number, name in enumerate(names, 1)}


@cache
def titles() -> Mapping[str, str]:
    """Title of each chapter of the book, by its name, without running it."""
    texts = {path.stem: ast.parse(path.read_text(encoding="utf-8")) for path in shipped()}
    return {
        name: (ast.get_docstring(tree) or name).partition("\n")[0] for name, tree in texts.items()
    }
