"""Records of C: a float beside what it misses, and all results of a routine.

Routines have flat lists of arguments and results.  In C, a name and the one behind it that ends in
``_low`` are a ``Pair``, and several results are one struct, which has the name that the routine
gives it, or that of the routine.  Results of the same names are the same struct.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import groupby

import sympy as sp
from sympy import Expr

from symhaptic.export.routine import Repeat, Routine, Search, Several, computed, fresh, names
from symhaptic.export.target import Target

PAIR = "Pair"


@dataclass(frozen=True)
class Places:
    """Where the names of one routine are that are in a record."""

    written: dict[str, str] = field(default_factory=dict)
    """How each is written."""
    variables: dict[str, str] = field(default_factory=dict)
    """All records that the routine asks others for, with their types."""
    passed: set[str] = field(default_factory=set)
    """Pairs that have no name of their own, as they are only handed on, once."""
    calls: dict[str, Expr] = field(default_factory=dict)
    """What gives such a pair."""


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

    def _named(self, routine: Routine) -> str:
        if len(joined(_fields(routine))) == 1:
            return PAIR
        words = self.target.call(routine.name).split("_")
        return routine.record or "".join(word.capitalize() for word in words)

    def kind(self, routine: Routine) -> str:
        """The type of what a routine gives."""
        return self.kinds.get(_fields(routine), self.target.real)

    def declared(self) -> dict[str, str]:
        """The definition of each type but pairs, by the first routine that gives it."""
        found = {}
        for fields, name in self.kinds.items():
            if name != PAIR:
                first = next(h.name for h in self.routines.values() if _fields(h) == fields)
                found[first] = self._definition(name, fields)
        return found

    def pair(self) -> str:
        """That of a pair, if there is one; else nothing."""
        flat = *map(_arguments, self.routines.values()), *self.kinds
        asked = any(len(part) > 1 for one in flat for part in joined(one))
        return f"typedef struct {{ {self.target.real} hi, lo; }} {PAIR};" if asked else ""

    def _definition(self, name: str, fields: tuple[str, ...]) -> str:
        kinds = groupby(joined(fields), key=len)
        runs = (f"{self._kind(size)} {', '.join(p[0] for p in parts)};" for size, parts in kinds)
        return f"typedef struct {{ {' '.join(runs)} }} {name};"

    def _kind(self, size: int) -> str:
        return PAIR if size > 1 else self.target.real

    def arguments(self, routine: Routine) -> list[str]:
        """Those of a routine, with their types."""
        parts = joined(_arguments(routine))
        return [f"{self._kind(len(part))} {self.target.rename(part[0])}" for part in parts]

    def places(self, routine: Routine) -> Places:
        """Of the arguments of a routine of these, and of what any routine asks these for."""
        found = Places()
        if routine.name in self.routines:
            for part in joined(_arguments(routine)):
                found.written.update(_pair(part, self.target.rename(part[0])))
        taken = {s.name for s in routine.arguments}
        taken |= {s.name for step in routine.steps for s in names(step)}
        for step in routine.steps:
            if isinstance(step, Several):
                self._receive(step, taken, found)
        found.passed.update(self._passed(routine, found))
        return found

    def _passed(self, routine: Routine, places: Places) -> Iterable[str]:
        """Pairs whose two numbers stand in one call, as one of its pairs, and nowhere else."""
        used: Counter[str] = Counter()
        whole_: Counter[str] = Counter()
        for step in (*routine.steps, *routine.results):
            again = 2 if isinstance(step, (Repeat, Search)) else 1
            exprs = computed(step) if step in routine.steps else step[1:]
            for expr in exprs:
                for part in sp.preorder_traversal(expr):
                    if part.is_Symbol:
                        used[part.name] += again
                    elif (name := part.func.__name__) in self.routines:
                        whole_.update(self._pairs(name, part.args, places))
        for step in routine.steps:
            if isinstance(step, Several):
                high, low, *more = (s.name for s in step.names)
                variable = places.written[high].removesuffix(".hi")
                if not more and used[high] == used[low] == whole_[variable] == 1:
                    yield variable

    def _pairs(self, name: str, args: Sequence[Expr], places: Places) -> Iterable[str]:
        """The pairs that a call is given, by their names."""
        shown = [places.written.get(str(a), "") for a in args]
        return (p for p in _grouped(_arguments(self.routines[name]), shown, "") if "{" not in p)

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
            for part, here in zip(joined(_fields(called)), _like(called, own), strict=True):
                place = f"{variable}.{part[0]}"
                found.written.update(_pair(here, place) or {here[0]: place})
        found.variables[variable] = kind

    def given(self, name: str, arguments: Sequence[str]) -> list[str]:
        """The arguments of a call, which are given as they are written, with pairs."""
        if name not in self.routines:
            return list(arguments)
        return _grouped(_arguments(self.routines[name]), arguments, f"({PAIR})")

    def made(self, routine: Routine, results: Sequence[str], places: Places) -> str:
        """The record of the results of a routine."""
        kind = self.kind(routine)
        parts = _grouped(_fields(routine), results, "" if kind != PAIR else f"({PAIR})")
        if kind == PAIR:
            return parts[0]
        fields = [part[0] for part in joined(_fields(routine))]
        for variable, other in places.variables.items():
            if kind == other and parts == [f"{variable}.{name}" for name in fields]:
                return variable
        return f"({kind}){{{', '.join(parts)}}}"


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
    found = re.fullmatch(r"([\w.]+)\.hi", high)
    return found[1] if found and low == f"{found[1]}.lo" else ""


def _grouped(flat: tuple[str, ...], written: Sequence[str], literal: str) -> list[str]:
    found, at = [], 0
    for part in joined(flat):
        own, at = written[at : at + len(part)], at + len(part)
        pair = len(part) > 1 and (whole(*own) or f"{literal}{{{', '.join(own)}}}")
        found.append(pair or own[0])
    return found


def _like(called: Routine, own: tuple[str, ...]) -> list[tuple[str, ...]]:
    """The names that a caller has for the results, in the pairs that these are."""
    found, at = [], 0
    for part in joined(_fields(called)):
        found.append(own[at : at + len(part)])
        at += len(part)
    return found


def _arguments(routine: Routine) -> tuple[str, ...]:
    return tuple(s.name for s in routine.arguments)


def _fields(routine: Routine) -> tuple[str, ...]:
    return tuple(name for name, _ in routine.results)


def _pair(part: tuple[str, ...], variable: str) -> dict[str, str]:
    """How both names of a pair are written."""
    return {part[0]: f"{variable}.hi", part[1]: f"{variable}.lo"} if len(part) > 1 else {}
