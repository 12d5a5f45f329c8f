"""Records of C: a float beside what it misses, and all results of a routine.

Routines have flat lists of arguments and results.  In C, a name and the one behind it that ends in
``_low`` are a ``Pair``, and several results are one struct, which has the name that the routine
gives it; what is found of a device together is a ``Device``.  Results of the same names are the
same struct.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby

import sympy as sp
from sympy import Expr, Piecewise

from symhaptic.export.root_count import BEYOND, CENTER, LOOP
from symhaptic.export.routine import Repeat, Routine, Search, Several, computed, fresh, names
from symhaptic.export.target import Target

PAIR = "Pair"

MADE = {"Loop": tuple(s.name for s in (*LOOP, CENTER, BEYOND))}
"""Records that no routine gives: who has their numbers makes them."""


@dataclass(frozen=True)
class Places:
    """Where the names of one routine are that are in a record."""

    written: dict[str, str] = field(default_factory=dict)
    """How each is written."""
    variables: dict[str, str] = field(default_factory=dict)
    """All records that the routine asks others for, with their types."""
    passed: set[str] = field(default_factory=set)
    """Pairs that have no name of their own, as they are only handed on, once; of a record that is
    found for nothing else, too."""
    calls: dict[str, Expr] = field(default_factory=dict)
    """What gives such a pair."""
    made: dict[str, str] = field(default_factory=dict)
    """Records that the next statement makes, and their variables."""
    names: set[str] = field(default_factory=set)
    """Of all of these variables."""
    waiting: list[tuple[str, str]] = field(default_factory=list)
    """Declarations of these that are to stand before what is written next."""

    def variable(self, written: str) -> str:
        """Where a record is that is made, else what is written."""
        kind = next((k for k in MADE if written.startswith(f"({k}){{")), "")
        if not kind:
            return written
        if written not in self.made:
            self.names.update(self.variables)
            self.made[written] = fresh(kind.lower(), self.names).name
            given = written.removeprefix(f"({kind})")
            self.waiting.append((f"const {kind} ", f"{self.made[written]} = {given};"))
        return f"&{self.made[written]}"


class Records:
    """Those of the routines of a library."""

    def __init__(self, target: Target, helpers: Iterable[Routine]) -> None:
        self.target = target
        self.routines = {helper.name: helper for helper in helpers}
        self.kinds: dict[tuple[str, ...], str] = {}
        """The types, by the names of their fields."""
        for helper in self.routines.values():
            if len(fields := _fields(helper)) > 1:
                self.kinds.setdefault(fields, self._named(helper))
        asked = {kind for helper in self.routines.values() for kind in helper.takes}
        for kind in asked & MADE.keys():
            given = {a for h in self.routines.values() if kind in h.takes for a in _arguments(h)}
            self.kinds[tuple(name for name in MADE[kind] if name in given)] = kind
        parts = ((name, self._field(helper)) for name, helper in self.routines.items())
        self.fields = {name: found for name, found in parts if found}
        """Routines that give one number of a record that another one gives, and both names."""

    def _field(self, routine: Routine) -> tuple[str, str] | None:
        if len(routine.steps) != 1 or len(routine.results) != 1:
            return None
        (only,), ((_, result),) = routine.steps, routine.results
        if not isinstance(only, Several) or only.call.args != routine.arguments:
            return None
        called = self.routines[only.call.func.__name__]
        if result not in only.names or self.kind(called) == PAIR or self._taken(called):
            return None
        return called.name, _fields(called)[only.names.index(result)]

    def _named(self, routine: Routine) -> str:
        if len(joined(_fields(routine))) == 1:
            return PAIR
        return str(fresh(routine.record or "Device", set(self.kinds.values())).name)

    def kind(self, routine: Routine) -> str:
        """The type of what a routine gives."""
        return self.kinds.get(_fields(routine), self.target.real)

    def declared(self) -> list[str]:
        """The definitions of all types, that of pairs first."""
        flat = *map(_arguments, self.routines.values()), *self.kinds
        asked = any(len(part) > 1 for one in flat for part in joined(one))
        pair = (
            f"typedef struct {{ {self.target.real} hi, lo; }} {PAIR}; // and what its float misses"
        )
        kinds = [self._definition(name, own) for own, name in self.kinds.items() if name != PAIR]
        return [pair] * asked + kinds

    def _definition(self, name: str, fields: tuple[str, ...]) -> str:
        kinds = groupby(joined(fields), key=len)
        runs = (f"{self._kind(size)} {', '.join(p[0] for p in parts)};" for size, parts in kinds)
        return f"typedef struct {{ {' '.join(runs)} }} {name};"

    def _kind(self, size: int) -> str:
        return PAIR if size > 1 else self.target.real

    def _taken(self, routine: Routine) -> dict[str, dict[str, str]]:
        """Where the arguments are that are taken out of records, by the types of these."""
        fields = {kind: _inside(names) for names, kind in self.kinds.items() if kind != PAIR}
        given = _arguments(routine)
        found = {
            kind: {name: place for name, place in fields.get(kind, {}).items() if name in given}
            for kind in routine.takes
        }
        return {kind: own for kind, own in found.items() if own}

    def _parts(self, routine: Routine) -> list[tuple[str, ...]]:
        """The other arguments."""
        taken = set().union(*self._taken(routine).values())
        return joined(name for name in _arguments(routine) if name not in taken)

    def arguments(self, routine: Routine) -> list[str]:
        """Those of a routine, with their types; records stand before all others."""
        taken = self._taken(routine)
        records = [f"const {kind} *{self.target.rename(kind.lower())}" for kind in taken]
        parts = self._parts(routine)
        others = [f"{self._kind(len(part))} {self.target.rename(part[0])}" for part in parts]
        return [*records, *others]

    def places(self, routine: Routine) -> Places:
        """Of the arguments of a routine of these, and of what any routine asks these for."""
        found = Places()
        if routine.name in self.routines:
            for part in self._parts(routine):
                found.written.update(_pair(part, self.target.rename(part[0])))
            for kind, own in self._taken(routine).items():
                variable = self.target.rename(kind.lower())
                found.variables[variable] = kind
                found.written.update({name: f"{variable}->{place}" for name, place in own.items()})
        taken = {s.name for s in routine.arguments}
        taken |= {s.name for step in routine.steps for s in names(step)} | set(found.variables)
        for step in routine.steps:
            if isinstance(step, Several):
                self._receive(step, taken, found)
        found.passed.update(self._passed(routine, found))
        return found

    def _passed(self, routine: Routine, places: Places) -> Iterable[str]:
        """Pairs whose two numbers stand in one call, as one of its pairs, and nowhere else."""
        used: Counter[str] = Counter()
        whole_: Counter[str] = Counter()
        exprs = [(e, step) for step in routine.steps for e in computed(step)]
        for expr, step in [*exprs, *((e, None) for _, e in routine.results)]:
            again = 2 if isinstance(step, (Repeat, Search)) else 1
            for part in sp.preorder_traversal(expr):
                if part.is_Symbol:
                    used[part.name] += again
                elif (name := part.func.__name__) in self.routines:
                    whole_.update(self._pairs(name, part.args, places))
        if routine.name in self.routines:
            results = dict(routine.results)
            for part in (p for p in joined(_fields(routine)) if len(p) > 1):
                for ends in _arms(*(results[name] for name in part)):
                    whole_[whole(*(places.written.get(str(end), "") for end in ends))] += 1
        for step in routine.steps:
            if isinstance(step, Several):
                asked = [s.name for s in step.names if used[s.name]]
                pair = whole(*(places.written[name] for name in asked)) if len(asked) == 2 else ""
                if pair and {used[name] for name in asked} == {whole_[pair]} == {1}:
                    yield pair

    def _pairs(self, name: str, args: Sequence[Expr], places: Places) -> Iterable[str]:
        """The pairs that a call is given, by their names."""
        called = self.routines[name]
        shown = dict(
            zip(_arguments(called), (places.written.get(str(a), "") for a in args), strict=True)
        )
        return (_grouped(part, shown, "") for part in self._parts(called) if len(part) > 1)

    def _receive(self, step: Several, taken: set[str], found: Places) -> None:
        called = self.routines[step.call.func.__name__]
        own = tuple(s.name for s in step.names)
        kind = self.kind(called)
        if kind == PAIR:
            variable = self.target.rename(own[0])
            found.written.update(_pair(own, variable))
        else:
            name = fresh((called.record or "device").lower(), taken).name
            variable = self.target.rename(name)
            inside = _inside(_fields(called)).values()
            found.written.update(
                {name: f"{variable}.{place}" for name, place in zip(own, inside, strict=True)}
            )
        found.variables[variable] = kind

    def given(self, name: str, arguments: Sequence[str]) -> list[str]:
        """The arguments of a call, which are given as they are written, with pairs."""
        if name not in self.routines:
            return list(arguments)
        called = self.routines[name]
        shown = dict(zip(_arguments(called), arguments, strict=True))
        records = [self._record(kind, own, shown) for kind, own in self._taken(called).items()]
        return [*records, *(_grouped(part, shown, f"({PAIR})") for part in self._parts(called))]

    def _record(self, kind: str, places: dict[str, str], shown: dict[str, str]) -> str:
        """The record that has these numbers, made of them if there is none."""
        (first, place), *_ = places.items()
        for link, address in (("->", ""), (".", "&")):
            variable = shown[first].removesuffix(link + place)
            if all(shown[name] == f"{variable}{link}{place}" for name, place in places.items()):
                return address + variable
        if kind in MADE and len(places) == len(next(f for f, k in self.kinds.items() if k == kind)):
            return f"({kind}){{{', '.join(shown[name] for name in places)}}}"
        given = (f".{place} = {shown[name]}" for name, place in places.items())
        return f"{'&' * (kind not in MADE)}({kind}){{{', '.join(given)}}}"

    def made(
        self, routine: Routine, results: Sequence[str], places: Places, handed: Callable[[str], str]
    ) -> str:
        """The record of the results of a routine; ``handed`` is how a pair is written."""
        kind = self.kind(routine)
        shown = dict(zip(_fields(routine), results, strict=True))
        if kind == PAIR:
            return handed(_grouped(_fields(routine), shown, f"({PAIR})"))
        parts = [_grouped(part, shown, "") for part in joined(_fields(routine))]
        fields = [part[0] for part in joined(_fields(routine))]
        for variable, other in places.variables.items():
            if kind == other and parts == [f"{variable}.{name}" for name in fields]:
                return variable
        return f"({kind}){{{', '.join(map(handed, parts))}}}"


def joined(flat: Iterable[str]) -> list[tuple[str, ...]]:
    """Names, each with the one of what it misses.

    >>> joined(["w", "w_low", "root", "reach"])
    [('w', 'w_low'), ('root',), ('reach',)]
    """
    found: list[tuple[str, ...]] = []
    for name in flat:
        if found and name == f"{found[-1][0]}_low":
            found[-1] = (*found[-1], name)
        else:
            found.append((name,))
    return found


def whole(high: str, low: str) -> str:
    """The pair whose parts these are, as they are written, if there is one; else nothing.

    >>> whole("total.hi", "total.lo"), whole("2.0*total.hi", "2.0*total.lo")
    ('total', '')
    """
    found = re.fullmatch(r"(\w+(?:(?:\.|->)\w+)*)\.hi", high)
    return found[1] if found and low == f"{found[1]}.lo" else ""


def _grouped(part: tuple[str, ...], shown: Mapping[str, str], literal: str) -> str:
    """A number or a pair, whose numbers are given as they are written."""
    own = [shown[name] for name in part]
    return own[0] if len(own) == 1 else whole(*own) or f"{literal}{{{', '.join(own)}}}"


def _arms(one: Expr, two: Expr) -> Iterable[tuple[Expr, Expr]]:
    """Two results side by side, in each branch."""
    both = isinstance(one, Piecewise) and isinstance(two, Piecewise)
    if not both or [c for _, c in one.args] != [c for _, c in two.args]:
        yield one, two
        return
    for (left, _), (right, _) in zip(one.args, two.args, strict=True):
        yield from _arms(left, right)


def _inside(fields: tuple[str, ...]) -> dict[str, str]:
    """Where each number is in a record of these fields.

    >>> _inside(("w", "w_low", "root"))
    {'w': 'w.hi', 'w_low': 'w.lo', 'root': 'root'}
    """
    found: dict[str, str] = {}
    for part in joined(fields):
        found |= _pair(part, part[0]) or {part[0]: part[0]}
    return found


def _arguments(routine: Routine) -> tuple[str, ...]:
    return tuple(s.name for s in routine.arguments)


def _fields(routine: Routine) -> tuple[str, ...]:
    return tuple(name for name, _ in routine.results)


def _pair(part: tuple[str, ...], variable: str) -> dict[str, str]:
    """How both names of a pair are written."""
    return {part[0]: f"{variable}.hi", part[1]: f"{variable}.lo"} if len(part) > 1 else {}
