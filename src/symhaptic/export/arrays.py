"""Python, for arrays of any library of the Array API standard.

What a routine chooses between becomes functions of their own, which `select` calls with the
elements that count.
"""

from __future__ import annotations

import re
import textwrap
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType

import sympy as sp
from sympy import Expr, Piecewise, Symbol
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean

from symhaptic.export import reserved
from symhaptic.export.array_runtime import (
    CROSSING,
    HALVES,
    PRELUDE,
    PRODUCT_ERROR,
    SELFTEST,
    SERIES,
    STEPS,
    UNFUSED,
)
from symhaptic.export.branches import (
    Assign,
    Block,
    Choice,
    Join,
    Return,
    expressions,
    functional,
    inputs,
    lazy,
    told,
)
from symhaptic.export.language import Printing, Target, bare, called, describe
from symhaptic.export.library import known, named, precise
from symhaptic.export.passes import hoisted
from symhaptic.export.precision import DOUBLE, SINGLE, Precision
from symhaptic.export.reserved import vocabulary
from symhaptic.export.routine import (
    Library,
    Repeat,
    Routine,
    Search,
    Several,
    TwoProdError,
    calls,
    fresh,
    propagated,
)
from symhaptic.export.statements import depth, in_brackets, wrapped
from symhaptic.forms.form import BELOW_PI, LARGEST, LONGEST, STIFFEST, Form


class ArrayPrinter(Printing):
    """Expressions of arrays, in the words of a scope."""

    def __init__(self, target: Target, scope: Scope) -> None:
        super().__init__(target)
        self.scope = scope

    def _as_ordered_terms(self, expr: Expr, order: str | None = None) -> list[Expr]:
        """SymPy's order, but first a term without a minus, which would be a step of its own."""
        terms = super()._as_ordered_terms(expr, order)
        first = next((t for t in terms if not t.could_extract_minus_sign()), terms[0])
        return [first, *(t for t in terms if t is not first)]

    def _print_Symbol(self, expr: Symbol) -> str:
        return self.scope.name(expr)

    def _print_Function(self, expr: Expr) -> str:
        return self.scope.call(expr)

    def _print_TwoProdError(self, expr: Expr) -> str:
        return self.scope.two_prod_error(*expr.args)

    def _print_Mul(self, expr: Expr) -> str:
        for sign, product in (("", expr), ("-", -expr)):
            if key(product) in self.scope.missing:
                plain = super()._print_Pow if product.is_Pow else super()._print_Mul
                return f"{sign}unfused(xp, {bare(plain(product))})"
        return str(super()._print_Mul(expr))

    def _print_Pow(self, expr: Expr, rational: bool = False) -> str:
        if key(expr) in self.scope.missing:
            return self._print_Mul(expr)
        return str(super()._print_Pow(expr, rational))

    def _part(self, condition: Boolean) -> str:
        """In brackets: of arrays `&` and `|` are done first."""
        return f"({self._print(condition)})"

    def _print_Piecewise(self, expr: Expr) -> str:
        *choices, (last, always) = expr.args
        if always != sp.true:
            raise ValueError(f"{expr}: has no value where no condition holds")
        text, number = str(self._print(last)), last.is_number
        for value, condition in reversed(choices):
            shown = str(self._print(value))
            if value.is_number and number:
                shown = f"xp.full_like({self.scope.like(condition)}, {shown})"
            text = f"xp.where({self.scope.condition(condition)}, {shown}, {text})"
            number = False
        return text


# -- What a block of statements is looked through for before functions of arrays are written -----


Products = dict[object, Symbol]
"""The names of products and squares, by their factors."""


def products(block: Block) -> Products:
    """Those that have a name in a block."""
    return {
        key(s.expr): s.name
        for s in block
        if isinstance(s, Assign) and (s.expr.is_Mul or s.expr.is_Pow)
    }


def key(product: Expr) -> object:
    """What tells a product or a square from others."""
    return frozenset(product.args) if product.is_Mul else product


def key_of(one: Expr, two: Expr) -> object:
    """The same, by its factors."""
    return one**2 if one == two else frozenset((one, two))


def product(known: Products, one: Expr, two: Expr) -> Symbol | None:
    """The name of a product, if it has one."""
    return known.get(key_of(one, two))


def base(symbol: Symbol) -> str:
    """Its name without a number at the end."""
    return str(symbol.name).rstrip("0123456789")


def alone_of_their_kind(block: Block) -> list[Symbol]:
    """Variables that are numbered, but not to tell them from others of the block."""
    own = {s.name for s in block if isinstance(s, Assign)}
    own |= {name for s in block if isinstance(s, Several) for name in s.names}
    kinds = Counter(map(base, own | set(inputs(block))))
    return [s for s in own if s.name[len(base(s)) :] not in ("", "0", "1") and kinds[base(s)] == 1]


def factors(block: Block) -> Counter[Expr]:
    """How often each is a factor of a product of which something is missed."""
    return Counter(factor for error in errors(block) for factor in error.args)


def errors(block: Block) -> Iterator[Expr]:
    """What is missed of products, as often as it is asked for."""
    shown = (expr for statement in block for expr in expressions(statement))
    parts = (part for expr in shown for part in sp.preorder_traversal(expr))
    return (part for part in parts if isinstance(part, TwoProdError))


def last_uses(block: Block, known: Products, handed: Mapping[int, int]) -> dict[int, list[Symbol]]:
    """For each statement, the variables of the block that are used there for the last time.

    Their names are free for the next ones of the same kind, and so is their memory.
    """
    own = {s.name for s in block if isinstance(s, Assign)}
    own |= {name for s in block if isinstance(s, Several) for name in s.names}
    last: dict[Symbol, int] = {}
    for i, statement in enumerate(block):
        used = set(inputs((statement,)))
        for expr in expressions(statement):
            for error in expr.atoms(TwoProdError):
                if name := product(known, *error.args):
                    used.add(name)
        last |= dict.fromkeys(sorted(used & own, key=str), _place(i, handed))
    found: dict[int, list[Symbol]] = {}
    for symbol, i in last.items():
        found.setdefault(i, []).append(symbol)
    return found


def _place(i: int, handed: Mapping[int, int]) -> int:
    """The statement that a statement is written in."""
    while i in handed:
        i = handed[i]
    return i


def handed_on(block: Block) -> dict[int, int]:
    """Calls whose two results are arguments side by side of one other call, and nothing else.

    By their places in the block, and that of the statement with the other call.
    """
    uses: Counter[Symbol] = Counter()
    users: dict[tuple[Expr, ...], int] = {}
    for i, statement in enumerate(block):
        shown = expressions(statement)
        for symbol in inputs((statement,)):
            uses[symbol] += not any(e.has(symbol) for e in shown)
        for part in (p for expr in shown for p in sp.preorder_traversal(expr)):
            if part.is_Symbol:
                uses[part] += 1
            elif isinstance(part, AppliedUndef):
                users |= dict.fromkeys(zip(part.args, part.args[1:], strict=False), i)
    return {
        i: users[s.names]
        for i, s in enumerate(block)
        if isinstance(s, Several) and s.names in users and all(uses[n] == 1 for n in s.names)
    }


def variables(expr: Expr, block: Block, handed: Mapping[int, int]) -> set[Symbol]:
    """Those of a call, and of calls whose results it is handed."""
    found: set[Symbol] = set()
    inner = {
        name: s.call
        for i, s in enumerate(block)
        if isinstance(s, Several) and i in handed
        for name in s.names
    }
    for symbol in expr.free_symbols:
        found |= variables(inner[symbol], block, handed) if symbol in inner else {symbol}
    return found


def repeated_conditions(block: Block) -> set[Expr]:
    """Conditions that occur more than once."""
    count: dict[Expr, int] = {}
    for statement in block:
        for expr in expressions(statement):
            for part in sp.preorder_traversal(expr):
                if isinstance(part, Piecewise):
                    for _, condition in part.args[:-1]:
                        count[condition] = count.get(condition, 0) + 1
    return {condition for condition, times in count.items() if times > 1}


def mere_call(block: Block) -> Expr | None:
    """The call that a block returns, if it does nothing else and all arguments are variables."""
    first = block[0]
    if not isinstance(first, Return) or len(first.results) > 1:
        return None
    (call,) = first.results
    alone = isinstance(call, AppliedUndef) or type(call).__module__.startswith("symhaptic.forms")
    return call if alone and all(a.is_Symbol for a in call.args) else None


def lone_expression(block: Block) -> Expr | None:
    """The expression of a block that has no other, makes no calls and is defined everywhere."""
    first = block[0]
    if not isinstance(first, Return) or len(first.results) > 1:
        return None
    (only,) = first.results
    if any(not power.exp.is_Integer or power.exp < 0 for power in only.atoms(sp.Pow)):
        return None
    return None if calls(Routine("", "", (), (), (("", only),))) else only


def ends_with_search(block: Block) -> bool:
    """Whether all that is left is what a search finds."""
    *before, last = block
    searched = before and isinstance(before[-1], Search) and before[-1].name
    return isinstance(last, Return) and last.results == (searched,)


# -- One body of a function for two precisions that differ in numbers alone ----------------------


_NUMBER = re.compile(
    r"(?P<sign> [-+] (?=[\d.e+-]+(?:$|[,)])))?"
    r"(?P<size>(?:(?<=[(=,] )-|(?<=\()-)?(?<![\w.])\d+(?:\.\d*)?(?:e[-+]?\d+)?(?![\w.]))"
)
"""A number; of a term that is nothing else, with its sign."""


def of_both(
    double: list[str], single: list[str], taken: Iterable[str]
) -> tuple[list[str], list[tuple[str, str, str]]] | None:
    """The body with names for the numbers that differ, and these: name, double and single.

    Nothing where the bodies differ in more than that.

    >>> of_both(["y = 2.0*x + 1e-15"], ["y = 2.0*x - 1e-07"], ["x"])
    (['y = 2.0*x + number'], [('number', '1e-15', '-1e-07')])
    """
    if _shapes(double) != _shapes(single):
        return None
    used = {*taken, *re.findall(r"\w+", " ".join(double))}
    names: dict[tuple[str, str], str] = {}

    def named(one: re.Match[str], other: re.Match[str]) -> str:
        if one[0] == other[0]:
            return one[0]
        pair = _signed(one), _signed(other)
        if pair not in names:
            names[pair] = fresh(_KNOWN.get(pair) or _usual(pair[0]), used).name
        return f"{' + ' * bool(one['sign'])}{names[pair]}"

    found = []
    for one, other in zip(double, single, strict=True):
        shown, end = "", 0
        for pair in zip(_NUMBER.finditer(one), _NUMBER.finditer(other), strict=True):
            shown, end = f"{shown}{one[end : pair[0].start()]}{named(*pair)}", pair[0].end()
        found.append(shown + one[end:])
    return found, [(name, *pair) for pair, name in names.items()]


def _shapes(lines: list[str]) -> list[str]:
    return [_NUMBER.sub(lambda n: f"{'+' * bool(n['sign'])}#", line) for line in lines]


def _signed(number: re.Match[str]) -> str:
    return f"{'-' * ('-' in (number['sign'] or ''))}{number['size']}"


def _usual(number: str) -> str:
    """What counts is where a series begins; for slow poles it begins later."""
    return "begin" if number.isdigit() else "number"


def _of(precision: Precision) -> dict[str, str]:
    sizes = {"close": precision.close, "flat": precision.flat, "last": precision.last}
    return {name: repr(float(size)) for name, size in sizes.items()}


_KNOWN = {(_of(DOUBLE)[name], _of(SINGLE)[name]): name for name in _of(DOUBLE)}
"""Numbers that a precision has a name for."""


# -- Bodies of Python functions of arrays: statements, names, and what they need before them -----


class Scope:
    """The body of one function."""

    def __init__(self, target: Target, block: Block) -> None:
        self.target, self.block = target, block
        self.printer = ArrayPrinter(target, self)
        self.names: dict[Symbol, str] = {
            s: self.target.rename(base(s)) for s in alone_of_their_kind(block)
        }
        """Names without a number that only another function needs, or of what is done with."""
        self.split: dict[Expr, str] = {}
        """Factors whose halves are there, and the name of these."""
        self.factors = factors(block)
        """How often the halves of each are asked for."""
        self.products = products(block)
        self.missing = {key_of(*error.args) for error in errors(block)}
        """Products of which something is missed: each has to be rounded before it is added."""
        self.cases: dict[Expr, str] = {}
        """Conditions that have a name."""
        self.handed = handed_on(block)
        """Calls whose two results are only passed on, and where each of them is written instead."""
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
            elif isinstance(statement, Join):
                returned = self.block[i + 1 :] == (Return(statement.names),)
                start = "return" if returned else f"{', '.join(self.named(statement.names))} ="
                lines += self._selected(statement, depth, pad + start)
                if returned:
                    break
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

    def _selected(self, choice: Choice | Join, depth: int, start: str) -> list[str]:
        """What ``start`` gives or returns, each side computed where it counts."""
        lines: list[str] = []
        given: list[tuple[str, str]] = []
        condition = self.condition(choice.condition)
        for name, block in (("yes", choice.yes), ("no", choice.no)):
            wanted = inputs(block) or sorted(choice.condition.free_symbols, key=str)[:1]
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
        shown = self.name(name) if name else f"unfused(xp, {'*'.join(factors)})"
        return f"two_prod_error({shown}, {self.split[one]}, {self.split[two]})"

    def condition(self, condition: Expr) -> str:
        """A condition, by its name if it has one."""
        return self.cases.get(condition) or str(self.printer.doprint(condition))

    def like(self, condition: Expr) -> str:
        """An array of the kind that a condition looks at."""
        return min(self.named(condition.free_symbols))


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


def _listed(names: list[str]) -> str:
    return f"({', '.join(names)}{',' * (len(names) == 1)})"


# -- Python, for arrays of any library of the Array API standard ---------------------------------


_MOST = {
    LARGEST: Symbol("most.size"),
    STIFFEST: Symbol("most.stiffness"),
    LONGEST: Symbol("most.periods"),
    BELOW_PI: Symbol("most.angle"),
}


class ArrayApi(Target):
    """One module of functions of arrays."""

    name, title = "numpy", "Python (NumPy, or any library of the Array API)"
    words = MappingProxyType({"&&": "&", "||": "|", "!": "~"})
    keywords = vocabulary(
        "False None True and as assert async await break class continue def del elif else except "
        "finally for from global if import in is lambda nonlocal not or pass raise return try "
        "while with yield match case xp np numpy selftest math operator sys array_namespace device "
        "is_array_api_obj is_lazy_array is_numpy_array is_torch_array arrays deferred elementwise "
        "functools select repeat over step is_jax_array by_value halves square_root two_prod_error "
        "unfused plant work inside limits guarded settled most yes no add series value crossing"
    )
    modules = reserved.PYTHON
    writes_both = True
    leaves_zeros_out = False  # its helpers are those of both precisions
    operations = single = called(
        "xp.",
        Infinity="xp.inf",
        NaN="xp.nan",
        Max="xp.where({0} > {1}, {0}, {1})",
        Min="xp.where({0} < {1}, {0}, {1})",
        TwoProdError="two_prod_error({0}, {1})",
        sqrt="square_root(xp, {0})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.py."""
        taken: set[str] = set()
        lines = [f'"""{library.title}."""', "", *PRELUDE.splitlines(), "", ""]
        lines += [*STEPS.splitlines(), "", ""]
        if library.factorials:
            lines += [*SERIES.splitlines(), "", ""]
        for helper in map(_without_numbers, library.helpers):
            if helper.name == "TwoProdError":
                lines += [*UNFUSED.splitlines(), "", "", *HALVES.splitlines(), "", ""]
                lines += [*PRODUCT_ERROR.splitlines(), "", ""]
                continue
            brief = None
            if precise(helper.name):
                brief = _without_numbers(named(helper.name, known(SINGLE)))
            lines += [*self._helper(helper, brief), "", ""]
            if helper.name == "NextGuess":
                lines += [*CROSSING.splitlines(), "", ""]
        conditions: dict[Boolean, str] = {}
        for form in library.forms:
            for symbol, condition in zip(form.arguments, form.within, strict=True):
                if condition not in conditions:
                    conditions[condition] = fresh(symbol.name, taken).name
        if conditions:
            lines += [*self._conditions(conditions), "", ""]
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += [*self._public(form, routine, conditions, library), "", ""]
        return {f"{library.name}.py": "\n".join(lines[:-2]) + "\n"}

    def _named(self, symbols: Iterable[Symbol]) -> list[str]:
        return [self.rename(s.name) for s in symbols]

    def _helper(self, routine: Routine, brief: Routine | None) -> list[str]:
        """A function; before it the one for single precision, where that has other steps.

        Where only numbers are others, these get names.
        """
        name, given = self.call(routine.name), self._named(routine.arguments)
        arguments = ", ".join(["xp", *given])
        head = [*wrapped([f"def {name}({arguments}):"]), *_documented([routine.about])]
        body = self._body(routine)
        if brief is None:
            return [*head, *_narrow(body)]
        other = self._body(brief)
        if (both := of_both(body, other, given)) is not None:
            found, numbers = both
            if numbers:
                names, double, single = (", ".join(column) for column in zip(*numbers, strict=True))
                pair = (double, single) if len(numbers) == 1 else (f"({double})", f"({single})")
                asked = f"if {given[0]}.dtype == xp.float32 else"
                head += _narrow([f"    {names} = {pair[1]} {asked} {pair[0]}"])
            return [*head, *_narrow(found)]
        head += [f"    if {given[0]}.dtype == xp.float32:",
                 *wrapped([f"        return {name}_single({arguments})"])]  # fmt: skip
        apart = wrapped([f"def {name}_single({arguments}):"])
        apart += _documented(["The same in single precision."])
        return [*apart, *_narrow(other), "", "", *head, *_narrow(body)]

    def _public(
        self, form: Form, routine: Routine, conditions: Mapping[Boolean, str], library: Library
    ) -> list[str]:
        about = describe(form, self.precision)
        names = self._named(routine.arguments)
        head = f"def {self.call(routine.name)}({', '.join(names)}):"
        lines = ["@by_value", *wrapped([head]), *_documented(about)]
        if not names:
            return [*lines, "    (xp,) = arrays()", *self._written(lazy(routine), 1)]
        lines.append(f"    {', '.join(['xp', *names])} = arrays({', '.join(names)})")
        plant, work = hoisted(routine)
        for other in library.forms:
            if (made := _in_terms_of(form, other)) is not None:
                plant, work = None, made
                counted = f"{self.call(other.name)}({', '.join(names)})"
                lines.append(f"    {self.rename(made.arguments[0].name)} = {counted}")
        for name, part in (("plant", plant), ("work", work)):
            if part is None:
                continue
            given = ", ".join(self._named(part.arguments))
            block = lazy(part)
            if part is work and form.truth:
                block = told(block)
            lines += ["", f"    def {name}({given}):", *self._written(block, 2)]
            lines.append("")
            if part.arguments[0] not in form.arguments:
                lines.append(f"    return settled(xp, {name}, {given})")
                continue
            inside = " ".join(self._asked(form, part, conditions))
            outside = form.outside if part is work else sp.nan
            shown = {sp.nan: "math.nan", sp.false: "False"}.get(outside, str(outside))
            many = len(part.results)
            call = f'guarded(xp, {name}, "{inside}", {many}, {shown}, {given})'
            results = ", ".join(self._named(Symbol(n) for n, _ in part.results))
            lines.append(f"    return {call}" if part is work else f"    {results} = {call}")
        return _narrow(lines)

    def _asked(self, form: Form, part: Routine, conditions: Mapping[Boolean, str]) -> Iterable[str]:
        """What its arguments are asked for, by the names of the conditions."""
        known = zip(form.arguments, form.within, strict=True)
        return (conditions[c] for s, c in known if s in part.arguments)

    def _conditions(self, names: Mapping[Boolean, str]) -> list[str]:
        """A table of all conditions by name."""
        lines = ["INSIDE = {"]
        for condition, name in names.items():
            (symbol,) = condition.free_symbols - set(_MOST)
            shown = Scope(self, ()).printer.doprint(condition.xreplace(_MOST))
            lines.append(f'    "{name}": lambda xp, most, {self.rename(symbol.name)}: {shown},')
        return [*lines, "}", '"""What is true of each argument inside its domain alone."""']

    def _body(self, routine: Routine) -> list[str]:
        """Of a helper; its first line is not blank."""
        body = self._written(lazy(routine), 1)
        return body[1:] if body[0] == "" else body

    def _written(self, block: Block, depth: int) -> list[str]:
        return Scope(self, functional(block)).written(depth)

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """From a tuple."""
        return f"{', '.join(names)} = {function}(xp, {args})"

    def notes(self, library: Library) -> list[str]:
        """What it makes of arrays, and what must not be done to it."""
        return [
            "Arrays of float32 are computed in single precision, all others in double precision;",
            "longer floats are rounded. Masked elements, and values that are not real numbers, are",
            "outside every domain.",
            "Never compile it with fastmath=True (Numba) or a similar option, which assumes that",
            "there is no NaN.",
        ]

    def usage(self, library: Library) -> str:
        """What it needs, and an import of the first function."""
        first = library.public[0].name
        return f"# needs NumPy and array-api-compat\nfrom {library.name} import {first}"

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.py."""
        counts = {r.name: len(r.arguments) for r in library.public}
        text = SELFTEST.replace("NAME", library.name).replace("COUNTS", repr(counts))
        text = text.replace("KIND", self.precision.kind.__name__)
        return {"selftest.py": text}

    def commands(self, name: str) -> list[list[str]]:
        """Run; a warning is an error."""
        return [["python", "-W", "error", "selftest.py"]]


def _in_terms_of(form: Form, other: Form) -> Routine | None:
    """The verdict of a form, made of what another one of the same arguments counts, if it is.

    That is its first argument.  Outside of its domain that one counts -1, of which, as of all but
    0, the verdict is no.
    """
    if not form.truth or other.outside != -1 or form.arguments != other.arguments:
        return None
    ((_, own),), ((name, count),) = form.results, other.results
    counts = [value for value, _ in count.args] if isinstance(count, sp.Piecewise) else [count]
    made = own.xreplace(dict.fromkeys(counts, Symbol(name)))
    verdicts = {v for v, _ in made.args} if isinstance(made, sp.Piecewise) else {made}
    if len(verdicts) > 1:
        return None
    (verdict,) = verdicts
    given = (Symbol(name), *(s for s in form.arguments if verdict.has(s)))
    return Routine(form.name, form.title, given, (), ((form.name, verdict),))


def _narrow(lines: Iterable[str]) -> list[str]:
    return [line for long in lines for line in in_brackets(long)]


def _documented(about: list[str]) -> list[str]:
    """A docstring: its first line, and the others below."""
    head, *text = (
        [f"    {part}" for part in textwrap.wrap(line, 92)]
        for line in (f'"""{about[0]}', *about[1:])
    )
    if not text:
        return [*head, '    """'] if head[1:] else [f'{head[0]}"""']
    return [*head, "", *(line for lines in text for line in lines), '    """']


def _without_numbers(routine: Routine) -> Routine:
    """The routine with the names of mere numbers replaced by these."""
    return propagated(routine, {}, lambda value: bool(value.is_number))


TARGET = ArrayApi()
