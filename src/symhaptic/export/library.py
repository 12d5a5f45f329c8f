"""From stable forms to an ordered list of routines: what a target writes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache

from symhaptic.export.language import Refused, Target
from symhaptic.export.passes import (
    fused,
    merged,
    of_form,
    with_free_verdict,
    with_late_device,
    without_zeros,
)
from symhaptic.export.precision import DOUBLE, SINGLE, Precision
from symhaptic.export.routine import Library, Routine, calls, needs, operations
from symhaptic.export.routines import ROUTINES
from symhaptic.export.routines.arithmetic import two_prod_error
from symhaptic.export.sampled import apart, sampled_at, with_verdict
from symhaptic.forms.stable import Form


class Known(Mapping[str, Routine]):
    """All routines by name, each made when it is first asked for."""

    def __init__(self, precision: Precision) -> None:
        self.precision = precision
        self.made: dict[str, Routine] = {}

    def __getitem__(self, name: str) -> Routine:
        """The routine of that name."""
        if name not in self.made:
            self.made[name] = ROUTINES[name].make(self.precision)
        return self.made[name]

    def __iter__(self) -> Iterator[str]:
        """Their names, in the order of their files."""
        return iter(ROUTINES)

    def __len__(self) -> int:
        """How many there are."""
        return len(ROUTINES)


@cache
def known(precision: Precision = DOUBLE) -> Mapping[str, Routine]:
    """All routines by name."""
    return Known(precision)


def named(name: str, routines: Mapping[str, Routine]) -> Routine:
    """The routine of that name, or the joint one of several names."""
    parts = name.split("_")
    if len(parts) == 1:
        return routines[name]
    made = routines.made if isinstance(routines, Known) else {}
    if name not in made:
        made[name] = fused(parts, routines)
    return made[name]


def precise(name: str) -> bool:
    """Whether the routine, or one of those that it joins, depends on the precision."""
    return any(ROUTINES[part].precise for part in name.split("_"))


def _reached(helpers: Mapping[str, Routine], public: Iterable[Routine]) -> set[str]:
    """The helpers that are called, and operations that are written out."""
    left = list(public)
    found: set[str] = set()
    while left:
        asked = needs(left.pop()) & helpers.keys() - found
        found |= asked
        left += (helpers[name] for name in asked)
    return found


def library(
    name: str, title: str, forms: Iterable[Form], target: Target, merges: bool = True
) -> Library:
    """Everything that a target writes for these forms, each routine alone if none are merged.

    Raises :class:`Refused` for an operation that the target does not have.
    """
    forms = tuple(with_verdict(forms) if target.samples else forms)
    together = [with_free_verdict(form) for form in forms]
    together = [with_late_device(form) for form in together] if merges else together
    public = tuple(of_form(form, target.precision) for form in together)
    routines = known(target.precision)
    if merges:
        public = tuple(map(merged, public))
    if target.samples:
        public += apart(together, target.precision)
    own = {}
    if target.operations["TwoProdError"].startswith("two_prod_error("):
        own["TwoProdError"] = two_prod_error.make(target.precision)
    own |= sampled_at(forms, target.precision)
    ordered: dict[str, Routine] = {}

    def add(wanted: Routine) -> None:
        for other in sorted(calls(wanted) | (operations(wanted) & set(own))):
            if other not in ordered:
                found = own.get(other) or named(other, routines)
                add(found)
                if target.writes_both and other not in own and precise(other):
                    add(named(other, known(SINGLE)))
                ordered[other] = found

    for one in public:
        add(one)
    if merges and target.leaves_zeros_out:
        found, public = without_zeros(ordered, public)
        reached = _reached(found, public)
        ordered = {name: found[name] for name in ordered if name in reached}
    for one in (*ordered.values(), *public):
        for missing in sorted(operations(one) - set(target.operations)):
            raise Refused(f"{target.name}: has no operation {missing!r}, which {one.name} needs")
    count = len(forms)
    return Library(name, title, forms, tuple(ordered.values()), public[:count], public[count:])
