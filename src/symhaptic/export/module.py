"""From stable forms to an ordered list of routines: what a target writes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from symhaptic.export import (
    angle_slopes,
    device,
    device_numbers,
    device_series,
    double_word,
    elementary,
    error_free,
    fractional_root_count,
    free_stable,
    late_device,
    max_stiffness,
    required_damping,
    response,
    root_count,
    search,
    slopes,
    whole_turns,
)
from symhaptic.export.code_names import code_name, routine_name
from symhaptic.export.free_stable import with_free_verdict
from symhaptic.export.fused import fused, merged
from symhaptic.export.late_device import with_late_device
from symhaptic.export.precision import DOUBLE, SINGLE, Precision
from symhaptic.export.printing import Language, Refused, calls, operations
from symhaptic.export.routine import Repeat, Routine
from symhaptic.export.shared import routine
from symhaptic.export.zeros import without_zeros
from symhaptic.forms.stable import Form


@dataclass(frozen=True)
class Library:
    """Forms with the routines that they need, each after those that it calls."""

    name: str
    title: str
    forms: tuple[Form, ...]
    helpers: tuple[Routine, ...]
    public: tuple[Routine, ...]

    @property
    def factorials(self) -> int:
        """How many inverse factorials its series take, from 1/0! on."""
        loops = (s for helper in self.helpers for s in helper.steps if isinstance(s, Repeat))
        return max((n + 1 for loop in loops for n in loop.factorials), default=0)

    def needed(self, routine: Routine) -> Iterator[Routine]:
        """The helpers that a routine calls, or one of these does, in their order."""
        wanted = _called(routine)
        for helper in reversed(self.helpers):
            if helper.name in wanted:
                wanted |= _called(helper)
        return (helper for helper in self.helpers if helper.name in wanted)


class Known(Mapping[str, Routine]):
    """All routines by name, each made when it is first asked for."""

    def __init__(self, precision: Precision) -> None:
        self.precision = precision
        self.made: dict[str, Routine] = {}

    def __getitem__(self, name: str) -> Routine:
        """The routine of that name: its maker has the name that it has in source code."""
        if name not in self.made:
            try:
                make, precise = _makers()[code_name(name)]
            except KeyError:
                raise KeyError(name) from None
            self.made[name] = make(self.precision) if precise else make()
        return self.made[name]

    def __iter__(self) -> Iterator[str]:
        """Their names, in the order of their files."""
        return map(routine_name, _makers())

    def __len__(self) -> int:
        """How many there are."""
        return len(_makers())


@cache
def known(precision: Precision = DOUBLE) -> Mapping[str, Routine]:
    """All routines by name."""
    return Known(precision)


@cache
def _makers() -> dict[str, tuple[Callable[..., Routine], bool]]:
    """What makes each routine, and whether that depends on the precision."""
    made = {f.__name__: (f, False) for module in _MODULES for f in module.ROUTINES}
    return made | {f.__name__: (f, True) for module in _MODULES for f in module.PRECISE}


_MODULES = (
    error_free, elementary, double_word, whole_turns, device, device_numbers, device_series, slopes,
    angle_slopes, root_count, fractional_root_count, free_stable, late_device, search,
    required_damping, response, max_stiffness,
)  # fmt: skip


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
    return any(_makers()[code_name(part)][1] for part in name.split("_"))


def _called(routine: Routine) -> frozenset[str]:
    """The routines that it calls, and operations that may have to be written out."""
    return calls(routine) | operations(routine)


def _reached(helpers: Mapping[str, Routine], public: Iterable[Routine]) -> set[str]:
    """The helpers that are called, and operations that are written out."""
    left = list(public)
    found: set[str] = set()
    while left:
        asked = _called(left.pop()) & helpers.keys() - found
        found |= asked
        left += (helpers[name] for name in asked)
    return found


def library(
    name: str, title: str, forms: Iterable[Form], target: Language, merges: bool = True
) -> Library:
    """Everything that a target writes for these forms, each routine alone if none are merged.

    Raises :class:`Refused` for an operation that the target does not have.
    """
    forms = tuple(forms)
    together = map(with_free_verdict, forms)
    together = map(with_late_device, together) if merges else together
    public = tuple(routine(form, target.precision) for form in together)
    routines = known(target.precision)
    if merges:
        public = tuple(map(merged, public))
    own = {}
    if target.operations["TwoProdError"].startswith("two_prod_error("):
        own["TwoProdError"] = elementary.two_prod_error(target.precision)
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
    return Library(name, title, forms, tuple(ordered.values()), public)
