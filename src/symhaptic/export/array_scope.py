"""Bodies of Python functions of arrays: statements, names, and what they need before them."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp
from sympy import Expr, Piecewise, Symbol

from symhaptic.export.array_blocks import (
    alone_of_their_kind,
    base,
    ends_with_search,
    factors,
    handed_on,
    last_uses,
    lone_expression,
    mere_call,
    product,
    products,
    repeated_conditions,
    variables,
)
from symhaptic.export.blocks import Assign, Block, Choice, Join, Return, expressions, inputs
from symhaptic.export.routine import Repeat, Search, Several, TwoProdError
from symhaptic.export.target import Target
from symhaptic.export.wrapping import depth


class Scope:
    """The body of one function."""

    def __init__(self, target: Target, block: Block) -> None:
        self.target, self.block = target, block
        self.printer = target.printing()
        self.printer.scope = self
        self.names: dict[Symbol, str] = {
            s: self.target.rename(base(s)) for s in alone_of_their_kind(block)
        }
        """Names without a number that only another function needs, or of what is done with."""
        self.split: dict[Expr, str] = {}
        """Factors whose halves are there, and the name of these."""
        self.factors = factors(block)
        """How often the halves of each are asked for."""
        self.products = products(block)
        self.cases: dict[Expr, str] = {}
        """Conditions that have a name."""
        self.handed = handed_on(block)
        """Where each call stands in whose place both of its results are handed on, and nowhere."""
        self.calls: dict[tuple[Expr, ...], str] = {}
        """How these calls are written."""

    def name(self, symbol: Symbol) -> str:
        """A variable as it is written."""
        return self.names.get(symbol) or self.target.rename(symbol.name)

    def named(self, symbols: Iterable[Symbol]) -> list[str]:
        """Variables as they are written."""
        return [self.name(s) for s in symbols]

    # -- lines -----------------------------------------------------------------------------

    def written(self, depth: int) -> list[str]:
        """The statements."""
        pad, lines = "    " * depth, []
        often = repeated_conditions(self.block)
        last = last_uses(self.block, self.products, self.handed)
        ended = ends_with_search(self.block)
        idle: dict[str, list[str]] = {}
        for i, statement in enumerate(self.block):
            shown = expressions(statement)
            for expr in shown:
                lines += [pad + line for line in self._before(expr, often)]
            if isinstance(statement, Assign):
                value = self.printer.doprint(statement.expr)
                self._retired(last.get(i, ()), idle)
                self._renamed(statement.name, idle)
                if value != (name := self.name(statement.name)):
                    lines.append(f"{pad}{name} = {value}")
            elif isinstance(statement, Repeat):
                lines += (self._repeat if statement.number is None else self._sum)(statement, depth)
            elif isinstance(statement, Search):
                lines += self._search(statement, depth)
                if ended:
                    lines[-1] = lines[-1].replace(f"{self.name(statement.name)} =", "return", 1)
                    break
            elif isinstance(statement, Several):
                name, args = self._called(statement.call)
                self._retired(last.get(i, ()), idle)
                if i in self.handed:
                    self.calls[statement.names] = f"*{name}(xp, {args})"
                    continue
                if self.block[i + 1 :] == (Return(statement.names),):
                    lines.append(f"{pad}return {name}(xp, {args})")
                    break
                used = set(inputs(self.block[i + 1 :]))
                for symbol in used.intersection(statement.names):
                    self._renamed(symbol, idle)
                names = [self.name(s) if s in used else "_" for s in statement.names]
                lines.append(pad + self.target.unpacked(names, name, args))
            elif isinstance(statement, Join) and self.block[i + 1 :] == (Return(statement.names),):
                lines += self._selected(statement, depth, f"{pad}return")
                break
            elif isinstance(statement, Join):
                lines += self._join(statement, depth)
            elif isinstance(statement, Choice):
                lines += self._choice(statement, depth)
            else:
                lines.append(f"{pad}return {', '.join(self.printer.doprint(r) for r in shown)}")
        return lines

    def _retired(self, symbols: Iterable[Symbol], idle: dict[str, list[str]]) -> None:
        """Their names are free from here on."""
        for symbol in symbols:
            idle.setdefault(base(symbol), []).append(self.name(symbol))

    def _renamed(self, symbol: Symbol, idle: dict[str, list[str]]) -> None:
        """It takes a free name of its kind, if there is one."""
        if free := idle.get(base(symbol)):
            self.names[symbol] = free.pop()

    def _choice(self, choice: Choice, depth: int) -> list[str]:
        pad = "    " * depth
        yes, no = lone_expression(choice.yes), lone_expression(choice.no)
        if yes is not None and no is not None:
            whole = Piecewise((yes, choice.condition), (no, True))
            return [f"{pad}return {self.printer.doprint(whole)}"]
        return self._selected(choice, depth, f"{pad}return")

    def _join(self, join: Join, depth: int) -> list[str]:
        """The names with their values, each side computed where it counts."""
        names = ", ".join(self.named(join.names))
        return self._selected(join, depth, f"{'    ' * depth}{names} =")

    def _selected(self, choice: Choice | Join, depth: int, start: str) -> list[str]:
        lines: list[str] = []
        given: list[tuple[str, str]] = []
        condition = self.condition(choice.condition)
        for name, block in (("yes", choice.yes), ("no", choice.no)):
            wanted = inputs(block) or _first(choice.condition)
            inside = Scope(self.target, block)
            made = self._function(name, inside, wanted, depth)
            side = _short(made)
            if not side and (call := mere_call(block)):
                side = self._handing(call)
                wanted = list(call.args)
            lines += ["", *made] * (not side)
            given.append((side or name, f", {_listed(self.named(wanted))}"))
        (yes, values), (no, others) = given
        others = others if others != values else ""
        end = f"{start} select(xp, {condition}, {yes}{values}, {no}{others})"
        return [*lines, *[""] * bool(lines), end]

    def _handing(self, call: Expr) -> str:
        """A function that hands its arguments on to the one that is called."""
        return f"lambda *v: {self.target.call(call.func.__name__)}(xp, *v)"

    def _function(self, name: str, inside: Scope, given: list[Symbol], depth: int) -> list[str]:
        head = f"{'    ' * depth}def {name}({', '.join(inside.named(given))}):"
        first, *others = inside.written(depth + 1)
        return [head, *[first] * bool(first), *others]

    def _repeat(self, loop: Repeat, depth: int) -> list[str]:
        """Its condition and its steps as two functions, which a helper calls."""
        pad, lines = "    " * depth, []
        start = [self.printer.doprint(first) for first in loop.start]
        bodies: dict[str, Block] = {
            "over": (Return((loop.done,)),),
            "step": (*(Assign(*s) for s in loop.steps), Return(loop.next)),
        }
        outer = sorted({s for b in bodies.values() for s in inputs(b)} - set(loop.states), key=str)
        for name, block in bodies.items():
            inside = Scope(self.target, block)
            lines += ["", *self._function(name, inside, [*loop.states, *outer], depth)]
        states = ", ".join(self.named(loop.states))
        call = (
            f"repeat(xp, {loop.most}, over, step, {_listed(start)}, {_listed(self.named(outer))})"
        )
        return [*lines, "", f"{pad}{states} = {call}"]

    def _search(self, search: Search, depth: int) -> list[str]:
        """What is searched for as a function, which a helper calls."""
        pad, block = "    " * depth, (Return((search.value,)),)
        outer = sorted(search.value.free_symbols - {search.at}, key=str)
        lines, value = [], "value"
        if (call := mere_call(block)) and call.args[0] == search.at:
            outer, value = list(call.args[1:]), self._handing(call)
        else:
            inside = Scope(self.target, block)
            lines = ["", *self._function(value, inside, [search.at, *outer], depth), ""]
        ends = (self.printer.doprint(e) for e in (search.low, search.high, search.close))
        found = f"crossing(xp, {value}, {', '.join(ends)}, {_listed(self.named(outer))})"
        return [*lines, f"{pad}{self.name(search.name)} = {found}"]

    def _sum(self, loop: Repeat, depth: int) -> list[str]:
        """A loop over numbers, which are the same for all elements; a helper lets some wait."""
        pad = "    " * depth
        states, given = ", ".join(self.named(loop.states)), loop.factorials
        number = self.target.rename(str(loop.number))
        if loop.brief == sp.false:
            inside = Scope(self.target, tuple(Assign(*s) for s in loop.steps))
            inside.names = dict(self.names)
            return [
                f"{pad}{states} = {', '.join(self.printer.doprint(first) for first in loop.start)}",
                f"{pad}for {number} in INVERSE_FACTORIAL[{given[0]}:{given.stop}:{given.step}]:",
                *inside.written(depth + 1),
                f"{pad}    {states} = {', '.join(inside.named(loop.next))}",
            ]
        block: Block = (*(Assign(*s) for s in loop.steps), Return(loop.next))
        assert loop.number is not None
        outer = sorted(set(inputs(block)) - {*loop.states, loop.number}, key=str)
        inside = Scope(self.target, block)
        wanted = [*loop.states, loop.number, *outer]
        terms = f"{given[0]}, {loop.few}, {given[-1]}, {-given.step}"
        call = (
            f"series(xp, add, {len(loop.states)}, {self.condition(loop.brief)}, {terms}, "
            f"{_listed(self.named(outer))})"
        )
        return ["", *self._function("add", inside, wanted, depth), "", f"{pad}{states} = {call}"]

    # -- what has to be there before an expression --------------------------------------------

    def _before(self, expr: Expr, often: set[Expr]) -> list[str]:
        lines = []
        for part in sp.postorder_traversal(expr):
            if isinstance(part, TwoProdError):
                for factor, other in (part.args, part.args[::-1]):
                    if factor in self.split:
                        continue
                    whole = name = self.printer.doprint(factor)
                    if factor.is_number:
                        name = f"number{len(self.split)}"
                        whole = f"xp.full_like({self.name(other)}, {whole})"
                    self.split[factor] = f"halves(xp, {whole})"
                    if self.factors[factor] > 1:
                        lines.append(f"{name}_halves = {self.split[factor]}")
                        self.split[factor] = f"{name}_halves"
            elif isinstance(part, Piecewise):
                for _, condition in part.args[:-1]:
                    if condition in often and condition not in self.cases:
                        name = f"case{len(self.cases) + 1}"
                        lines.append(f"{name} = {self.printer.doprint(condition)}")
                        self.cases[condition] = name
        return lines

    # -- expressions -----------------------------------------------------------------------

    def call(self, expr: Expr) -> str:
        """A call of a routine."""
        name, args = self._called(expr)
        return f"{name}(xp, {args})"

    def _called(self, expr: Expr) -> tuple[str, str]:
        """The routine, and its arguments, which are all arrays."""
        like = min(self.named(variables(expr, self.block, self.handed)), default=None)
        plain = expr.func.__name__ in _OF_NUMBERS
        args, given = [], list(expr.args)
        while given:
            arg = given.pop(0)
            if call := self.calls.get((arg, *given[:1])):
                args.append(call)
                del given[0]
            elif arg.is_number and not plain:
                args.append(f"xp.full_like({like}, {self.printer.doprint(arg)})")
            else:
                args.append(self.printer.doprint(arg))
        return self.target.call(expr.func.__name__), ", ".join(args)

    def two_prod_error(self, one: Expr, two: Expr) -> str:
        """What a product misses; the product itself may have a name."""
        name = product(self.products, one, two)
        factors = (self.printer.doprint(factor) for factor in (one, two))
        shown = self.name(name) if name else "*".join(factors)
        return f"two_prod_error({shown}, {self.split[one]}, {self.split[two]})"

    def condition(self, condition: Expr) -> str:
        """A condition, by its name if it has one."""
        return self.cases.get(condition) or str(self.printer.doprint(condition))

    def like(self, condition: Expr) -> str:
        """An array of the kind that a condition looks at."""
        return min(self._symbols(condition))

    def _symbols(self, expr: Expr) -> list[str]:
        return self.named(expr.free_symbols)


_OF_NUMBERS = "FastTwoSum", "TwoDiff", "PairSum", "PairDiff", "OnePlus", "OneMinus", "ScaledSum"
"""Routines that take numbers beside arrays."""


_BRIEF = 64
"""Characters of a function that needs no name."""


def _short(lines: list[str]) -> str:
    """A function that returns something at once as a lambda, if that is short; else nothing."""
    if len(lines) != 2:
        return ""
    head, value = (line.strip() for line in lines)
    value = value.removeprefix("return ")
    shown = f"({value})" if _several(value) else value
    text = f"lambda {head[head.index('(') + 1 : -2]}: {shown}"
    return text if len(text) <= _BRIEF else ""


def _several(text: str) -> bool:
    """Whether a comma stands outside of all brackets."""
    return any(c == "," and depth(text[:at]) == 0 for at, c in enumerate(text))


def _first(condition: Expr) -> list[Symbol]:
    return sorted(condition.free_symbols, key=str)[:1]


def _listed(names: list[str]) -> str:
    return f"({', '.join(names)}{',' * (len(names) == 1)})"
