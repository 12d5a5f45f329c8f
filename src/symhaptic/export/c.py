"""C99, with records: a float beside what it misses, and all results of a routine.

Routines have flat lists of arguments and results.  In C, a name and the one behind it that ends in
``_low`` are a ``Pair``, and several results are one struct, which has the name that the routine
gives it; what is found of a device together is a ``Device``.  Results of the same names are the
same struct.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field
from itertools import groupby

import sympy as sp
from sympy import Expr, Piecewise

from symhaptic.export import package, reserved
from symhaptic.export.branches import guarded
from symhaptic.export.language import Target, called, describe
from symhaptic.export.package import FLAGS, STRICT
from symhaptic.export.precision import DOUBLE
from symhaptic.export.reserved import vocabulary
from symhaptic.export.routine import (
    Library,
    Repeat,
    Routine,
    Search,
    Several,
    computed,
    fresh,
    names,
)
from symhaptic.export.routines.roots import WHOLE_LOOP
from symhaptic.export.statements import WIDTH, braces, wrapped

PAIR = "Pair"

MADE = {"Loop": tuple(s.name for s in WHOLE_LOOP)}
"""Records that no routine returns: the caller builds them from their numbers."""


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
        """The places of records among the arguments of a routine and of its calls."""
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


# -- C99 -----------------------------------------------------------------------------------------


CPP_KEYWORDS = vocabulary(
    "auto break case char const continue default do double else enum extern float for goto if "
    "inline int long register restrict return short signed sizeof static struct switch typedef "
    "union unsigned void volatile while _Bool _Complex _Imaginary main alignas alignof and and_eq "
    "asm bitand bitor bool catch char16_t char32_t class compl constexpr const_cast decltype "
    "delete dynamic_cast explicit export false friend mutable namespace new noexcept not not_eq "
    "nullptr operator or or_eq private protected public reinterpret_cast static_assert static_cast "
    "template this thread_local throw true try typeid typename using virtual wchar_t xor xor_eq "
    "std"
)
"""Those of C and of C++, whose programs read the header of C, too."""


class Family(Target):
    """What C and C++ have in common."""

    keywords = CPP_KEYWORDS
    shares = True
    each = (
        "for (int n = {first}; n >= {last}; n -= {step}) {{",
        "    const {real} {name} = inverse_factorial[n];",
    )

    @property
    def late(self) -> str:
        """The type."""
        return self.real

    def number(self, value: float) -> str:
        """A literal of the type."""
        return super().number(value) + ("" if self.precision is DOUBLE else "f")


class C(Family):
    """One source file and its header."""

    name, title = "c", "C99"
    proves = samples = True
    helper = "static inline"
    """What declares a function that others here call: inlined, they take a tenth less time."""
    modules = reserved.C
    operations = called(
        "",
        Abs="fabs({0})",
        Infinity="INFINITY",
        NaN="NAN",
        Max="fmax({0}, {1})",
        Min="fmin({0}, {1})",
        TwoProdError="fma({0}, {1}, -({0}*{1}))",
    )
    single = called(
        "",
        "f",
        Abs="fabsf({0})",
        Infinity="INFINITY",
        NaN="NAN",
        Max="fmaxf({0}, {1})",
        Min="fminf({0}, {1})",
        TwoProdError="fmaf({0}, {1}, -({0}*{1}))",
    )

    records: Records | None = None
    """Those of the library that is written."""
    writes: Routine | None = None
    """The routine that is written."""
    places = Places()
    """Where its names are that are in a record."""

    def rename(self, name: str) -> str:
        """As in all languages; in a routine, of a number in a record that record and its field."""
        return self.places.written.get(name) or super().rename(name)

    def source(self, library: Library) -> dict[str, str]:
        """NAME.c and NAME.h."""
        guard = f"{library.name.upper()}_H"
        heads = []
        for form, routine in zip(library.forms, library.public, strict=True):
            about = describe(form, self.precision)
            heads += ["/*", *(f" * {line}" for line in about), " */"]
            heads += [f"{self._head(f'{library.name}_{routine.name}', routine)};", ""]
        heads += self._sampled_heads(library)
        truth = ["#include <stdbool.h>", ""] * any(r.truth for r in library.public)
        header = [f"#ifndef {guard}", f"#define {guard}", "", *truth, *_LINKED, *heads,
                  "#ifdef __cplusplus", "}", "#endif", "", "#endif", ""]  # fmt: skip
        lines = [f'#include "{library.name}.h"', "", "#include <float.h>", "#include <math.h>", "",
                 *STRICT.split("\n")]  # fmt: skip
        lines += self.prelude(library)
        if table := self.table(library):
            lines += ["// 1/n!", f"static const {self.real} inverse_factorial[] = {{{table}}};", ""]
        own = copy(self)
        own.records = records = Records(self, library.helpers)
        if types := records.declared():
            lines += [*types, ""]
        for helper in library.helpers:
            if helper.name not in records.fields:
                lines += [f"// {helper.about}", *own._helper(helper)]
        for routine in library.public:
            if not own._judged(library, routine):
                head = self._head(f"{library.name}_{routine.name}", routine)
                lines += own._written(routine, head)
        lines += own._sampled(library)
        files = {f"{library.name}.h": header, f"{library.name}.c": lines}
        return {name: "\n".join(wrapped(text)) for name, text in files.items()}

    def prelude(self, library: Library) -> list[str]:
        """What stands before all functions."""
        return []

    def _out(self, name: str) -> str:
        return f"{name}_out"

    def _helper(self, routine: Routine) -> list[str]:
        """One that others here call: of pairs, and with all results in a record."""
        assert self.records is not None
        args = ", ".join(self.records.arguments(routine)) or "void"
        kind = self.records.kind(routine)
        head = f"{self.helper} {kind} {self.call(routine.name)}({args})"
        return self._written(routine, head, [] if kind != self.real else ["return {0};"])

    def _written(
        self,
        routine: Routine,
        head: str,
        ends: list[str] | None = None,
        fields: Mapping[str, str] | None = None,
    ) -> list[str]:
        """A function; ``fields`` are arguments of it that are in a record."""
        if ends is None:
            ends = [f"*{self._out(n)} = {{{i}}};" for i, (n, _) in enumerate(routine.results)]
            ends = ["return {0};"] if len(ends) == 1 else [*ends, "return;"]
        own = copy(self)
        if self.records is not None:
            own.places = self.records.places(routine)
            own.places.written.update(fields or {})
            own.writes = routine
        body = braces(own, guarded(routine), ends, f"const {self.real}")
        if body[-1].endswith("return;"):
            body[-1:] = [line] if (line := body[-1].removesuffix("return;").rstrip()) else []
        short = f"{head} {{ {body[0].lstrip()} }}"
        if len(body) == 1 and len(short) <= WIDTH:
            return [short, ""]
        return [f"{head} {{", *body, "}", ""]

    def called(self, call: Expr) -> str:
        """A call, with pairs where the routine takes them."""
        name, printer = call.func.__name__, self.printing()
        args = [printer.whole(a) for a in call.args]
        if self.records is not None:
            given = self.records.given(name, args)
            args = [self.places.variable(self._handed(a)) for a in given]
            if name in self.records.fields:
                name, field = self.records.fields[name]
                return f"{self.call(name)}({', '.join(args)}).{field}"
        return f"{self.call(name)}({', '.join(args)})"

    def received(self, several: Several) -> tuple[str, str]:
        """As a record."""
        assert self.records is not None
        kind = self.records.kind(self.records.routines[several.call.func.__name__])
        variable, _, _ = self.rename(several.names[0].name).partition(".")
        for pair in self.places.passed:
            if pair.partition(".")[0] == variable:
                self.places.calls[pair] = several.call
                return "", ""
        return f"const {kind} ", f"{variable} = {self.called(several.call)};"

    def passed_on(self, several: Several) -> str:
        """Where both are helpers and give the same record."""
        assert self.records is not None
        assert self.writes is not None
        called = self.records.routines[several.call.func.__name__]
        alike = self.records.kind(self.writes) == self.records.kind(called)
        if self.writes.name not in self.records.routines or not alike:
            return ""
        return f"return {self.called(several.call)};"

    def waiting(self) -> list[tuple[str, str]]:
        """Records that are made for what is written next."""
        found = list(self.places.waiting)
        self.places.waiting.clear()
        self.places.made.clear()
        return found

    def ended(self, ends: list[str], results: list[str]) -> list[str]:
        """Several results of a helper as a record."""
        if ends:
            return super().ended(ends, results)
        assert self.records is not None
        assert self.writes is not None
        made = self.records.made(self.writes, results, self.places, self._handed)
        return [f"return {made};"]

    def _handed(self, pair: str) -> str:
        """A pair, or the call that gives it."""
        call = self.places.calls.get(pair)
        _, dot, field = pair.partition(".")
        return pair if call is None else f"{self.called(call)}{dot}{field}"

    def _head(self, name: str, routine: Routine) -> str:
        args = [f"{self.real} {self.rename(s.name)}" for s in routine.arguments]
        kind = "bool" if routine.truth else self.real
        if len(routine.results) > 1:
            kind, args = "void", args + [f"{self.real} *{self._out(n)}" for n, _ in routine.results]
        return f"{kind} {name}({', '.join(args) or 'void'})"

    def _record(self, library: Library) -> tuple[str, dict[str, str]]:
        """The type of a sampled device, and the names of its numbers there."""
        device = library.sampled[0]
        return f"{library.name}_sampled_device", {n: self.rename(n) for n, _ in device.results}

    def _sampled_head(self, library: Library, routine: Routine) -> str:
        kind, fields = self._record(library)
        given = [s.name for s in routine.arguments]
        judges = routine != library.sampled[0]
        given = [self.rename(n) for n in given if not judges or n not in fields]
        args = [f"{'const ' * judges}{kind} *sampled", *(f"{self.real} {n}" for n in given)]
        result = ("bool" if routine.truth else self.real) if judges else "void"
        return f"{result} {library.name}_{routine.name}({', '.join(args)})"

    def _sampled_heads(self, library: Library) -> list[str]:
        """The type of a sampled device and the functions that take one, for the header."""
        if not library.sampled:
            return []
        kind, fields = self._record(library)
        init, *judges = (f"{self._sampled_head(library, r)};" for r in library.sampled)
        return [
            "/*",
            " * A device with its delay, which the function below samples once, for the functions",
            " * that take it. Outside the domain all its numbers are NaN.",
            " */",
            f"typedef struct {{ {self.real} {', '.join(fields.values())}; }} {kind};",
            "",
            init,
            "",
            "/* Functions of a wall and a sampled device, with the same results as those above. */",
            *judges,
            "",
        ]

    def _sampled(self, library: Library) -> list[str]:
        """What samples a device, what judges a wall with it, and the same in one call."""
        if not library.sampled:
            return []
        kind, fields = self._record(library)
        init, *judges = library.sampled
        given = ", ".join(f"{{{i}}}" for i in range(len(fields)))
        ends = [f"*sampled = ({kind}){{{{{given}}}}};", "return;"]
        lines = self._written(init, self._sampled_head(library, init), ends)
        places = {name: f"sampled->{field}" for name, field in fields.items()}
        known = [self.rename(s.name) for s in init.arguments]
        device = f"{library.name}_device"
        for judge in judges:
            head = self._sampled_head(library, judge)
            wall = [self.rename(s.name) for s in judge.arguments if s.name not in fields]
            if judge.truth:  # beside it is the verdict, which also says that it is undecided
                asked = f"{device}_verdict(sampled, {', '.join(wall)})"
                lines += [f"{head} {{", f"    return {asked} > {self.number(0.0)};", "}", ""]
            else:
                lines += self._written(judge, head, fields=places)
        for routine in (r for r in library.public if self._judged(library, r)):
            lines += [
                f"{self._head(f'{library.name}_{routine.name}', routine)} {{",
                f"    {kind} sampled;",
                f"    {device}_init({', '.join(['&sampled', *known])});",
                f"    return {device}_{routine.name}({', '.join(['&sampled', *wall])});",
                "}",
                "",
            ]
        return lines

    def _judged(self, library: Library, routine: Routine) -> bool:
        """Whether it is written in terms of a sampled device."""
        return f"device_{routine.name}" in {r.name for r in library.sampled}

    def notes(self, library: Library) -> list[str]:
        """What it refuses to be compiled with, how it is found, and what is in SI units."""
        name = library.name
        si = package.header(library, self.real, self.precision)
        lines = package.notes(name, f"{name}.h")
        if library.sampled:
            given = ", ".join(s.name for s in library.sampled[0].arguments)
            lines += [
                f"{name}_device_init(&sampled, {given}) samples a device once. Then the functions",
                f"{name}_device_... judge walls, with the same results as those without device_.",
            ]
        if si:
            lines += [
                f"{name}_si.h has the same functions for a device in SI units (kg, s, N/m, Ns/m)."
            ]
        if "example.c" in si:
            lines += ["example.c is a controller at 1 kHz with a wall below its limit."]
        return [*lines, "The headers can also be included in C++."]

    def package(self, library: Library) -> dict[str, str]:
        """For CMake and pkg-config; the same in SI units, and a controller."""
        name, si = library.name, package.header(library, self.real, self.precision)
        headers = [f"{name}.h", *(file for file in si if file.endswith(".h"))]
        programs = ["selftest.c", *(file for file in si if file.endswith(".c"))]
        made = package.package(name, library.title, "c_std_99", f"{name}.c", headers, programs)
        return made | si

    def usage(self, library: Library) -> str:
        """The declaration of the first function."""
        first = library.public[0]
        head = self._head(f"{library.name}_{first.name}", first)
        return "\n".join([f'#include "{library.name}.h"', "", *wrapped([f"{head};"])])

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.c."""
        cases = []
        for r in library.public:
            count = len(r.arguments)
            args = [f"x[{i}]" for i in range(count)]
            name = f"{library.name}_{r.name}"
            if len(r.results) > 1:
                args += [f"&got[{i}]" for i in range(len(r.results))]
                call = f"{name}({', '.join(args)})"
            else:
                call = f"got[0] = {name}({', '.join(args)})"
            call += self._compared(library, r)
            cases.append(
                f'        if (strcmp(name, "{r.name}") == 0) {{\n'
                f"            arguments = {count}, results = {len(r.results)};\n"
                f"            read_all(file, x, arguments + 2*results);\n"
                + "".join(f"{part}\n" for part in wrapped([f"            {call};"]))
                + "        }\n"
            )
        sampled = f"    {self._record(library)[0]} sampled;\n" if library.sampled else ""
        words = library.name, self.real, self.real, self.real, sampled, "".join(cases)
        return {"selftest.c": _SELFTEST % words}

    def _compared(self, library: Library, routine: Routine) -> str:
        """What the self-test asks of a function that judges with a sampled device, too."""
        if not self._judged(library, routine):
            return ""
        at = {s: f"x[{i}]" for i, s in enumerate(routine.arguments)}
        device = [at[s] for s in library.sampled[0].arguments]
        wall = [own for s, own in at.items() if s not in library.sampled[0].arguments]
        name = f"{library.name}_device"
        return (
            f"; {name}_init({', '.join(['&sampled', *device])}); different += !isnan(got[0]) && "
            f"got[0] != {name}_{routine.name}({', '.join(['&sampled', *wall])})"
        )

    def commands(self, name: str) -> list[list[str]]:
        """Compile with warnings as errors, then run."""
        return [
            ["gcc", "-std=c99", *FLAGS, "-o", "selftest", "selftest.c", f"{name}.c", "-lm"],
            ["./selftest"],
        ]


_LINKED = ["#ifdef __cplusplus", 'extern "C" {', "#endif", ""]

_SELFTEST = """#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "%s.h"

static void read_all(FILE *file, %s *into, int count) {
    int i;
    char word[64];
    for (i = 0; i < count; ++i) {
        if (fscanf(file, "%%63s", word) != 1) exit(2);
        into[i] = (%s)strtod(word, NULL); /* exact */
    }
}

int main(void) {
    %s x[256], got[128];
    char name[64];
%s    int tried = 0, missed = 0, different = 0;
    FILE *file = fopen("vectors.txt", "r");
    if (file == NULL) return 2;
    while (fscanf(file, "%%63s", name) == 1) {
        int arguments = 0, results = 0, i;
%s        if (results == 0) return 2;
        for (i = 0; i < results; ++i) {
            const double found = (double)got[i], expected = (double)x[arguments + 2*i];
            ++tried;
            if (!(fabs(found - expected) <= (double)x[arguments + 2*i + 1]) &&
                !(isnan(found) && isnan(expected))) {
                ++missed;
                printf("%%s, result %%d: %%.17g instead of %%.17g\\n", name, i, found, expected);
            }
        }
    }
    fclose(file);
    missed += different;
    printf("%%d values, %%d missed\\n", tried, missed);
    return tried == 0 || missed > 0;
}
"""

TARGET = C()
