"""Blocks of statements, in languages with braces and in languages with words."""

from __future__ import annotations

from dataclasses import dataclass

from symhaptic.export.blocks import Assign, Block, Choice, Join, Set
from symhaptic.export.routine import Repeat, Several
from symhaptic.export.target import Target


def braces(
    target: Target, block: Block, ends: list[str], declare: str, depth: int = 1
) -> list[str]:
    """Statements in a language with braces; ``ends`` are the lines that return the results."""
    printer, pad, lines = target.printing(), "    " * depth, []
    for statement in block:
        if isinstance(statement, Assign):
            name = target.rename(statement.name.name)
            lines.append(f"{pad}{declare} {name} = {printer.doprint(statement.expr)};")
        elif isinstance(statement, Repeat):
            lines += [pad + line for line in _repeated(target, statement, declare)]
        elif isinstance(statement, Several):
            lines += [pad + line for line in _unpacked(target, statement)]
        elif isinstance(statement, Choice):
            lines.append(f"{pad}if ({printer.doprint(statement.condition)}) {{")
            lines += braces(target, statement.yes, ends, declare, depth + 1)
            lines += [f"{pad}}}", *braces(target, statement.no, ends, declare, depth)]
        elif isinstance(statement, Join):
            lines += [f"{pad}{target.late} {target.rename(n.name)};" for n in statement.names]
            lines.append(f"{pad}if ({printer.doprint(statement.condition)}) {{")
            lines += braces(target, statement.yes, ends, declare, depth + 1)
            lines.append(f"{pad}}} else {{")
            lines += [*braces(target, statement.no, ends, declare, depth + 1), f"{pad}}}"]
        elif isinstance(statement, Set):
            name = target.rename(statement.name.name)
            lines.append(f"{pad}{name} = {printer.doprint(statement.expr)};")
        else:
            shown = [printer.doprint(r) for r in statement.results]
            lines += [pad + end.format(*shown) for end in ends]
    return lines


def _unpacked(target: Target, several: Several) -> list[str]:
    printer, call = target.printing(), several.call
    names = [target.rename(s.name) for s in several.names]
    args = ", ".join(map(printer.doprint, call.args))
    return target.unpacked(names, target.call(call.func.__name__), args)


def _repeated(target: Target, loop: Repeat, declare: str) -> list[str]:
    printer = target.printing()
    states = [target.rename(s.name) for s in loop.states]
    count = f"count_{states[0]}"
    lines = [
        f"{target.changing or target.real} {name} = {printer.doprint(first)};"
        for name, first in zip(states, loop.start, strict=True)
    ]
    if loop.number is None:
        lines.append(target.times.format(count, loop.most))
        inner = [f"if ({printer.doprint(loop.done)}) {{ break; }}"]
    else:
        numbers = ", ".join(map(printer.doprint, loop.numbers))
        given = target.rename(loop.number.name), numbers, loop.most, target.real
        lines += [line.format(*given) for line in target.each]
        inner = []
    inner += [f"{declare} {target.rename(n.name)} = {printer.doprint(e)};" for n, e in loop.steps]
    inner += [f"{target.rename(s.name)} = {target.rename(n.name)};" for s, n in loop.turned]
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
    """Instead of a loop once for each of some numbers: a name, all of them, how many."""


def worded(
    target: Target, block: Block, results: list[str], words: Words, pad: str, depth: int = 1
) -> list[str]:
    """Statements in such a language; the results are variables."""
    printer, before, lines = target.printing(), pad * depth, []
    for statement in block:
        if isinstance(statement, (Assign, Set)):
            value = printer.doprint(statement.expr)
            lines.append(f"{before}{target.rename(statement.name.name)} = {value}{words.end}")
        elif isinstance(statement, Repeat):
            lines += [before + line for line in _turned(target, statement, words)]
        elif isinstance(statement, Several):
            lines += [before + line for line in _unpacked(target, statement)]
        elif isinstance(statement, (Choice, Join)):
            lines.append(before + words.when.format(printer.doprint(statement.condition)))
            lines += worded(target, statement.yes, results, words, pad, depth + 1)
            lines.append(before + words.otherwise)
            lines += worded(target, statement.no, results, words, pad, depth + 1)
            lines.append(before + words.decided)
        else:
            for name, value in zip(results, statement.results, strict=True):
                lines.append(f"{before}{name} = {printer.doprint(value)}{words.end}")
    return lines


def _turned(target: Target, loop: Repeat, words: Words) -> list[str]:
    printer = target.printing()
    states = [target.rename(s.name) for s in loop.states]
    begin = zip(states, loop.start, strict=True)
    lines = [f"{name} = {printer.doprint(first)}{words.end}" for name, first in begin]
    if loop.number is None:
        lines.append(words.loop.format(states[0], loop.most))
        lines += ["  " + line.format(printer.doprint(loop.done)) for line in words.leave]
    else:
        numbers = ", ".join(map(printer.doprint, loop.numbers))
        name = target.rename(loop.number.name)
        lines += [line.format(name, numbers, loop.most) for line in words.each]
    done = [(target.rename(n.name), printer.doprint(e)) for n, e in loop.steps]
    done += [(target.rename(s.name), target.rename(n.name)) for s, n in loop.turned]
    lines += [f"  {name} = {value}{words.end}" for name, value in done]
    return [*lines, words.looped]
