"""Somebody's function, from Python, a shared library or a command, as one that takes points."""

from __future__ import annotations

import importlib
import inspect
import os
import shlex
import struct
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

Points = Sequence[tuple[float, ...]]
Caller = Callable[[Points], list[tuple[float, ...]]]


class _Theirs:
    """Whatever somebody's code raises is one line, but for an interrupt."""

    def __init__(self, said: Callable[[], str], lost: str = "") -> None:
        self.said, self.lost = said, lost

    def __enter__(self) -> None:
        """Their code begins."""

    def __exit__(
        self,
        kind: type[BaseException] | None,
        wrong: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if kind is None or isinstance(wrong, KeyboardInterrupt):
            return
        if isinstance(wrong, SystemExit):
            raise ValueError(f"--python: {self.said()} ends the program ({wrong.code})") from None
        line = " ".join(str(wrong).split())
        if self.lost and isinstance(wrong, ImportError | AttributeError):
            raise ValueError(f"--python: {self.lost} ({line}); MODULE:NAME is") from None
        raise ValueError(f"--python: {self.said()} fails ({kind.__name__}: {line})") from None


def python(name: str, results: int) -> Caller:
    """``module:function``, called with one point at a time; the folder one stands in counts."""
    module, _, attribute = name.partition(":")
    if module.endswith(".py") or not all(map(str.isidentifier, module.split("."))):
        such = f"{Path(module).stem or 'module'}:{attribute or 'name'}"
        raise ValueError(f"--python: {name!r} is not allowed; MODULE:NAME is, such as {such}")
    sys.path.insert(0, os.getcwd())
    with _Theirs(lambda: repr(module), f"{name!r} is not found"):
        function = getattr(importlib.import_module(module), attribute)
    return called(function, results)


def place(name: str) -> tuple[str, int] | None:
    """File and line of ``module:function``, below the folder one stands in."""
    module, _, attribute = name.partition(":")
    try:
        function = inspect.unwrap(getattr(importlib.import_module(module), attribute))
        file = Path(inspect.getsourcefile(function) or "").resolve().relative_to(Path.cwd())
        return file.as_posix(), inspect.getsourcelines(function)[1]
    except (TypeError, ValueError, OSError):  # it is none of Python's own, or lies elsewhere
        return None


def files(python: str | None, library: str | None, command: str | None) -> set[Path]:
    """What is read when the function is called, as far as its name tells."""
    words = [] if command is None else _words(command)
    if library is not None:
        words.append(library.rpartition(":")[0])
    if python is not None:
        words.append(getattr(sys.modules[python.partition(":")[0]], "__file__", None) or "")
    return {Path(word).resolve() for word in words}


def called(function: Callable[..., Any], results: int) -> Caller:
    """An error of arithmetic (a division by zero, a logarithm of nothing) is NaN."""

    def run(points: Points) -> list[tuple[float, ...]]:
        found, at = [], points[0]
        with _Theirs(lambda: f"called with {', '.join(map(str, at))} it"):
            for at in points:
                try:
                    value = function(*at)
                except (ArithmeticError, ValueError):
                    value = (float("nan"),) * results
                found.append(tuple(value) if isinstance(value, tuple | list) else (value,))
        return [_numbers(*pair) for pair in zip(points, found, strict=True)]

    return run


def _numbers(point: tuple[float, ...], values: Sequence[Any]) -> tuple[float, ...]:
    try:
        return tuple(float(v) for v in values)
    except (TypeError, ValueError, OverflowError):
        given, got = ", ".join(map(str, point)), values[0] if len(values) == 1 else values
        raise ValueError(
            f"--python: called with {given} it gives {got!r}; numbers are allowed"
        ) from None


def library(name: str, arguments: int, results: int) -> Caller:
    """``FILE:function`` in C: doubles by value; several results by pointers behind them.

    It is called in a process of its own, which it may end.
    """
    file, _, symbol = name.rpartition(":")
    program = [sys.executable, "-I", str(Path(__file__).with_name("apart.py"))]
    program += [str(Path(file).resolve()), symbol, str(arguments), str(results)]

    def run(points: Points) -> list[tuple[float, ...]]:
        given = b"".join(struct.pack(f"={arguments}d", *point) for point in points)
        done = subprocess.run(program, input=given, stdout=subprocess.PIPE, check=False)
        told, sent = done.stdout[:1], done.stdout[1:]
        if told == b"-":
            wrong = sent.decode()
            raise ValueError(f"--library: {name!r} is not found ({wrong}); FILE:NAME is")
        whole = len(sent) // (8 * results)
        found = list(struct.iter_unpack(f"={results}d", sent[: 8 * results * whole]))
        if done.returncode or len(found) != len(points):
            at = ", ".join(map(str, points[whole])) if whole < len(points) else ""
            when = "when it is loaded" if not told else f"called with {at}" if at else "at last"
            raise ValueError(f"--library: {when} it ends the program ({done.returncode})")
        return found

    return run


def command(line: str) -> Caller:
    """A line of hexadecimal floats for each point in, a line of results for each out."""
    words = _words(line)

    def run(points: Points) -> list[tuple[float, ...]]:
        text = "".join(" ".join(v.hex() for v in p) + "\n" for p in points)
        try:
            done = subprocess.run(words, input=text, capture_output=True, text=True)
            lines = done.stdout.splitlines()
            found = [tuple(_number(w) for w in one.split()) for one in lines]
        except (OSError, ValueError) as wrong:
            raise ValueError(f"--command: {line!r} cannot be used ({wrong})") from None
        if done.returncode or len(found) != len(points):
            said = "".join(f" ({last})" for last in done.stderr.strip().splitlines()[-1:])
            raise ValueError(
                f"--command: {line!r} ended with status {done.returncode} and {len(found)} lines"
                f"{said}; 0 and {len(points)} lines are allowed"
            )
        return found

    return run


def _words(line: str) -> list[str]:
    """A command's program and what it is given."""
    try:
        words = shlex.split(line)
    except ValueError as wrong:
        raise ValueError(f"--command: {line!r} cannot be used ({wrong})") from None
    if not words:
        raise ValueError(f"--command: {line!r} is not allowed; a program and its words are")
    return words


def _number(word: str) -> float:
    return float.fromhex(word) if "x" in word.lower() else float(word)
