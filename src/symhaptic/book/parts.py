"""The parts of the book: a chapter finds its part by the section in its name."""

from __future__ import annotations

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
        "A hand holds a device, a computer reads where it is once per period $T$, and answers with "
        "the force of a spring $K$ and a damper $B$ that comes $d$ periods late. Nothing else is "
        "put into this book. Newton's law is solved from one sample to the next, the delay is "
        "written as a power of $z$ and held against what a late force really does, the loop is "
        "brought to five pure numbers, and the numbers of human arms are looked at one by one.",
    ),
    Part(
        "Passivity",
        ("3",),
        "A wall is passive if no motion of the device, however clever, takes energy out of it. The "
        "only loss that it can live on is the damping $b$ of the device, so that the question is "
        "how much of it each frequency needs. The answer is a line in the plane of $K$ and $B$ for "
        "each angle $\\theta=\\omega T$; these lines envelop the passive walls, and the tip of the "
        "region is the stiffest of them.",
    ),
    Part(
        "Stability",
        ("4d",),
        "A loop is stable if it comes to rest from every state, that is if all roots of its "
        "characteristic polynomial lie inside the unit circle. A root can leave only across the "
        "circle, and the walls that put one on it are an explicit curve. The chapters of this part "
        "follow the curve from its start, count the roots on either side, and ask what mass, "
        "spring, damper, delay and sampling period do to the region that it bounds.",
    ),
    Part(
        "The linear condition",
        ("4e",),
        "Close to the origin the boundary of stability is nearly a straight line: the damping of "
        "wall and device has to outweigh the stiffness times the delay, that of the hold included. "
        "These chapters say where the line comes from, how far it is from the boundary, and on "
        "which side of it the walls are that are not stable.",
    ),
    Part(
        "Passivity and stability compared",
        ("5", "6_"),
        "A passive wall is stable with every spring and damper that a hand may add, and pays "
        "for it with stiffness. How much is asked in this part: by the ratio of the stiffest "
        "walls, with the damping that counts for each; by what happens as a wall is softened; "
        "by springs so stiff that they swing as fast as the computer looks; and by how much "
        "spring, damper and sampling rate change the largest stiffness.",
    ),
    Part(
        "Fractional delays",
        ("6",),
        "Measured delays are seldom whole multiples of the period. The force then changes within "
        "the period, and the power $z^{-d}$ no longer says what happens. In this part the late "
        "force is sampled exactly, for every delay $(\\ell+\\varepsilon)T$; passivity, stability "
        "and their boundaries are derived once more, and held against what a power of $z$ says.",
    ),
    Part(
        "Rules in circulation",
        ("8",),
        "People limit the stiffness of a wall by rules that are shorter than the formulas of this "
        "book. In this part each of them is a statement like those of the paper, with who uses it: "
        "is what it allows stable, for which walls, and if not, which wall shows it? The last "
        "chapter says which rule to use when.",
    ),
    Part(
        "Other loops",
        ("10",),
        "Real loops filter their velocity, turn a mass over in a simulator, count the position in "
        "steps of an encoder, or drive it with an actuator that lags. Each chapter of this part "
        "derives one such loop from physics, finds which of its walls are passive or stable, and "
        "asks what the rules in circulation are worth there.",
    ),
    Part(
        "Forms for computing",
        ("9",),
        "A formula that is right may still be useless to a computer: where it is 0/0, and close to "
        "there, where what cancels takes the digits along. What is computed, and exported, is "
        "therefore written in other functions. In this part each formula that is computed is held "
        "against the one that was derived; of a value that is searched for, what its search goes "
        "by. A last digit that is wrong is another matter: it is measured, and no theorem.",
    ),
    Part(
        "What is wrong",
        ("7",),
        "Most slips come up where the formula is derived. Those that belong to no derivation are "
        "collected here; the errata behind this part have all of them, each with what is right.",
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
