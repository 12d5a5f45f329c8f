"""Blocks of statements, in languages with braces and in languages with words."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp
from sympy import Symbol

from symhaptic.export.branches import Assign, Block, Choice, Join, Return, Set, expressions
from symhaptic.export.language import Target, bare
from symhaptic.export.routine import Repeat, Several


def braces(
    target: Target, block: Block, ends: list[str], declare: str, depth: int = 1
) -> list[str]:
    """Statements in a language with braces; ``ends`` are the lines that return the results."""
    printer, pad = target.printing(), "    " * depth
    lines: list[str] = []

    def prepared() -> None:
        for head, given in target.waiting():
            _declared(target, lines, pad + head, given)

    for i, statement in enumerate(block):
        if isinstance(statement, Assign):
            name = target.rename(statement.name.name)
            given = f"{name} = {printer.whole(statement.expr)};"
            prepared()
            _declared(target, lines, f"{pad}{declare} ", given)
        elif isinstance(statement, Repeat):
            lines += [pad + line for line in _repeated(target, statement, declare)]
        elif isinstance(statement, Several):
            ends_so = block[i + 1 :] == (Return(statement.names),)
            if ends_so and (given := target.passed_on(statement)):
                prepared()
                return [*lines, pad + given]
            head, given = target.received(statement)
            prepared()
            if head:
                _declared(target, lines, pad + head, given)
            elif given:
                lines.append(pad + given)
        elif isinstance(statement, Choice) and (given := _returned(target, statement, ends)):
            _beside(target, lines, pad, given)
        elif isinstance(statement, Choice):
            head = f"{pad}if ({printer.doprint(statement.condition)}) {{"
            inner = braces(target, statement.yes, ends, declare, depth + 1)
            rest = braces(target, statement.no, ends, declare, depth)
            inner = _without_end(inner, rest)
            short = f"{head} {inner[0].lstrip()} }}"
            if target.shares and len(inner) == 1 and len(short) <= WIDTH:
                lines.append(short)
            else:
                lines += [head, *inner, f"{pad}}}"]
            lines += rest
        elif isinstance(statement, Join) and (value := _chosen(target, statement)):
            (n,) = statement.names
            given = f"{target.rename(n.name)} = {bare(value)};"
            _declared(target, lines, f"{pad}{declare} ", given)
        elif isinstance(statement, Join) and (given := _at_first(target, statement)):
            _declared(target, lines, f"{pad}{target.varying} ", f"{given};")
            lines.append(f"{pad}if ({printer.doprint(statement.condition)}) {{")
            lines += [*braces(target, statement.yes, ends, declare, depth + 1), f"{pad}}}"]
        elif isinstance(statement, Join):
            for n in statement.names:
                _declared(target, lines, f"{pad}{target.late} ", f"{target.rename(n.name)};")
            word = "if"
            while True:
                lines.append(f"{pad}{word} ({printer.doprint(statement.condition)}) {{")
                lines += braces(target, statement.yes, ends, declare, depth + 1)
                first, *others = statement.no
                if others or not isinstance(first, Join) or first.names:
                    break
                statement, word = first, "} " + target.words.get("else if", "else if")
            lines.append(f"{pad}}} else {{")
            lines += [*braces(target, statement.no, ends, declare, depth + 1), f"{pad}}}"]
        elif isinstance(statement, Set):
            given = f"{target.rename(statement.name.name)} = {printer.whole(statement.expr)};"
            prepared()
            _beside(target, lines, pad, given)
        elif isinstance(statement, Return):
            shown = [printer.whole(r) for r in statement.results]
            ended = target.ended(ends, shown)
            prepared()
            for end in ended:
                _beside(target, lines, pad, end)
    return lines


def _returned(target: Target, choice: Choice, ends: list[str]) -> str:
    """The statement that returns one of two values, if that is short and all that is done."""
    sides = choice.yes, choice.no
    if not target.shares or ends[1:] or not ends:
        return ""
    if not all(len(s) == 1 and isinstance(s[0], Return) and len(s[0].results) == 1 for s in sides):
        return ""
    printer = target.printing()
    found = [e for s in sides for e in expressions(s[0])]
    if any(e in (sp.nan, sp.oo) for e in found):  # of C's own type
        return ""
    values = map(printer.doprint, found)
    (end,) = ends
    given = end.format(target.choice.format(printer.doprint(choice.condition), *values))
    return given if len(given) <= _BRIEF else ""


def _without_end(inner: list[str], rest: list[str]) -> list[str]:
    """The lines of one side of a choice, without an end that is all that follows the choice."""
    end = [line.lstrip() for line in rest]
    last = [line.lstrip() for line in inner[-len(rest) :]]
    return inner[: -len(rest)] if end == last and len(inner) > len(rest) else inner


def _chosen(target: Target, join: Join) -> str:
    """The one value that a join sets, where nothing has to be done for it; else nothing."""
    if len(join.names) > 1 or not all(map(_plain, (join.yes, join.no))):
        return ""
    return _value(target, (join,))


def _at_first(target: Target, join: Join) -> str:
    """The number that the one name of a join is, if the other side has nothing else to do."""
    if len(join.names) > 1 or len(join.no) > 1 or not join.names:
        return ""
    (only,) = join.no
    if not isinstance(only, Set) or not only.expr.is_number:
        return ""
    return f"{target.rename(only.name.name)} = {target.printing().doprint(only.expr)}"


def _plain(block: Block) -> bool:
    """Whether a block does nothing but set one name, by other conditions perhaps."""
    if len(block) != 1:
        return False
    (only,) = block
    if isinstance(only, Join):
        return not only.names and _plain(only.yes) and _plain(only.no)
    return isinstance(only, Set)


def _value(target: Target, block: Block) -> str:
    (only,) = block
    printer = target.printing()
    if isinstance(only, Join):
        sides = _value(target, only.yes), _value(target, only.no)
        return target.choice.format(printer.doprint(only.condition), *sides)
    assert isinstance(only, Set)
    return printer.doprint(only.expr)


_BRIEF = 48
"""Characters up to which a choice between two results is one expression."""


def _declared(target: Target, lines: list[str], head: str, name: str) -> None:
    """One more declaration, on the line of those before if there is room."""
    before = lines[-1] if lines else ""
    joined = f"{before[:-1]}, {name}"
    if target.shares and before.startswith(head) and len(joined) <= WIDTH:
        lines[-1] = joined
    else:
        lines.append(head + name)


def _beside(target: Target, lines: list[str], pad: str, statement: str) -> None:
    """One more short statement, beside those that set values before it if there is room."""
    before = lines[-1] if lines else ""
    joined = f"{before} {statement}"
    if target.shares and len(joined) <= WIDTH and _SETS.fullmatch(before):
        lines[-1] = joined
    else:
        lines.append(pad + statement)


_SETS = re.compile(r"\s*\*?\w+ = [^{}]*;")
"""A line of these."""


def _at_once(loop: Repeat) -> tuple[Symbol, Symbol] | None:
    """A state that the last step may replace, since nothing asks for either of them any more."""
    last = loop.steps[-1][0]
    states = [state for state, after in loop.turned if after == last]
    read = [after for state, after in loop.turned if state not in states]
    return (states[0], last) if len(states) == 1 and states[0] not in read else None


def _repeated(target: Target, loop: Repeat, declare: str) -> list[str]:
    printer = target.printing()
    states = [target.rename(s.name) for s in loop.states]
    count = target.rename(f"count_{loop.states[0].name}")
    lines: list[str] = []
    for name, first in zip(states, loop.start, strict=True):
        given = f"{name} = {printer.whole(first)};"
        _declared(target, lines, f"{target.varying} ", given)
    if loop.number is None:
        lines.append(target.times.format(count, loop.most))
        leave = target.words.get("break", "break")
        inner = [f"if ({printer.doprint(loop.done)}) {{ {leave}; }}"]
    else:
        words = target.series(loop)
        head, *first = (line.format(**words) for line in target.each)
        lines.append(head)
        inner = [line.strip() for line in first]
    last = _at_once(loop)
    for n, e in loop.steps:
        value = printer.whole(e)
        if last and n == last[1]:
            inner.append(f"{target.rename(last[0].name)} = {value};")
        else:
            _declared(target, inner, f"{declare} ", f"{target.rename(n.name)} = {value};")
    for s, n in loop.turned:
        if (s, n) != last:
            _beside(target, inner, "", f"{target.rename(s.name)} = {target.rename(n.name)};")
    return [*lines, *(f"    {line}" for line in inner), "}"]


@dataclass(frozen=True)
class Words:
    """How a language without braces writes what a block is made of."""

    end: str
    """Behind an assignment."""
    when: str
    otherwise: str
    decided: str
    loop: str
    """With the first state and the number of turns."""
    leave: tuple[str, ...]
    """With the condition."""
    looped: str
    each: tuple[str, ...]
    """Instead of a loop for the sum of a series, as in Target."""


def worded(
    target: Target, block: Block, results: list[str], words: Words, pad: str, depth: int = 1
) -> list[str]:
    """Statements in such a language; the results are variables."""
    printer, before, lines = target.printing(), pad * depth, []
    for statement in block:
        if isinstance(statement, (Assign, Set)):
            value = printer.whole(statement.expr)
            lines.append(f"{before}{target.rename(statement.name.name)} = {value}{words.end}")
        elif isinstance(statement, Repeat):
            lines += [before + line for line in _turned(target, statement, words)]
        elif isinstance(statement, Several):
            lines.append(before + "".join(target.received(statement)))
        elif isinstance(statement, (Choice, Join)):
            lines.append(before + words.when.format(printer.doprint(statement.condition)))
            lines += worded(target, statement.yes, results, words, pad, depth + 1)
            lines.append(before + words.otherwise)
            lines += worded(target, statement.no, results, words, pad, depth + 1)
            lines.append(before + words.decided)
        elif isinstance(statement, Return):
            for name, value in zip(results, statement.results, strict=True):
                lines.append(f"{before}{name} = {printer.whole(value)}{words.end}")
    return lines


def _turned(target: Target, loop: Repeat, words: Words) -> list[str]:
    printer = target.printing()
    states = [target.rename(s.name) for s in loop.states]
    begin = zip(states, loop.start, strict=True)
    lines = [f"{name} = {printer.whole(first)}{words.end}" for name, first in begin]
    if loop.number is None:
        lines.append(words.loop.format(states[0], loop.most))
        lines += ["  " + line.format(printer.doprint(loop.done)) for line in words.leave]
    else:
        head = target.series(loop)
        lines += [line.format(**head) for line in words.each]
    done = [(target.rename(n.name), printer.whole(e)) for n, e in loop.steps]
    done += [(target.rename(s.name), target.rename(n.name)) for s, n in loop.turned]
    lines += [f"  {name} = {value}{words.end}" for name, value in done]
    return [*lines, words.looped]


# -- Lines of source that people can read: broken where a language lets them go on ----------------

WIDTH = 100

_COMMENT = re.compile(r"\s*(//[/!]?|\*|%|!|#) ")
_GAP = re.compile(
    r"[,?] |\{ (?!\w+; \})|(?<= ): |\((?!\))|(?<= )[-+=] |(?<![ */])[*/](?![*/])"
    r"|(?:&&|\|\||\.and\.|\.or\.|[&|]) "
)
"""Behind these a line may end: no language takes what is before for a whole statement, and a block
of one word stays together."""


def wrapped(lines: Iterable[str], end: str = "", width: int = WIDTH) -> list[str]:
    """Lines of source and comments; ``end`` is what a line that goes on ends with."""
    return [part for line in lines for part in _parts(line, end, width)]


def _parts(line: str, end: str, width: int, inside: bool = False) -> list[str]:
    if len(line) <= width:
        return [line]
    if lead := _COMMENT.match(line):
        text = line[lead.end() :]
        return textwrap.wrap(
            text, width, initial_indent=lead[0], subsequent_indent=lead[0],
            break_long_words=False, break_on_hyphens=False,
        )  # fmt: skip
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    found = []
    while len(line) > width and (at := _best(line, width - len(end), inside)):
        found.append(line[:at].rstrip() + end)
        line, inside = indent + line[at:].lstrip(), False
    return [*found, line]


def _best(line: str, width: int, inside: bool = False) -> int:
    """Where to break: inside as few brackets as possible, then as late as possible; 0 if nowhere.

    In one bracket at least, if it has to be inside.

    >>> line = "    y = f(a, b) + g(c, d);"
    >>> line[: _best(line, 20)]
    '    y = f(a, b) + '
    """
    start = len(line) - len(line.lstrip())
    gaps = [m.end() for m in _GAP.finditer(line, start) if m.end() <= width]
    gaps = [at for at in gaps if depth(line[:at]) > 0] if inside else gaps
    late = [at for at in gaps if at > start + 0.4 * (width - start)] or gaps[-1:]
    return min(late, key=lambda at: (depth(line[:at]), -at), default=0)


def depth(text: str) -> int:
    """Brackets that are open behind a text."""
    return sum((c in "([{") - (c in ")]}") for c in text)


def in_brackets(line: str) -> list[str]:
    """A statement of Python, with brackets round what would not go on without them."""
    if len(line) <= WIDTH:
        return [line]
    pad = line[: len(line) - len(line.lstrip())]
    names, equals, value = line.strip().partition(" = ")
    if not equals or depth(names):
        word, value = line.strip().split(" ", 1)
        return _valued(pad, f"{word} ", value)
    if len(pad + names) < WIDTH - 10:
        return _valued(pad, f"{names} = ", value)
    return [f"{pad}(", *wrapped([f"{pad}    {names}"]), *_valued(pad, ") = ", value)]


def _valued(pad: str, start: str, value: str) -> list[str]:
    """A value behind the start of its statement; a call goes on inside its own brackets."""
    parts = _parts(pad + start + value, "", WIDTH, inside=_is_call(value))
    inside = (depth("".join(parts[:i])) > depth(start) for i in range(1, len(parts)))
    if parts[1:] and all(inside):
        return parts
    first, *others = wrapped([f"{pad}    {value}"])
    inner = [first, *(other.removeprefix("    ") for other in others)]
    return [f"{pad}{start}(", *inner, f"{pad})"]


def _is_call(value: str) -> bool:
    """Whether one call is all of it.

    >>> _is_call("f(x, g(y))"), _is_call("f(x)*g(y)")
    (True, False)
    """
    name, _, rest = value.partition("(")
    closed = (at for at in range(len(rest)) if depth(rest[: at + 1]) < 0)
    return name.isidentifier() and next(closed, None) == len(rest) - 1
