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
from typing import Any

Points = Sequence[tuple[float, ...]]
Caller = Callable[[Points], list[tuple[float, ...]]]


def python(name: str, results: int) -> Caller:
    """``module:function``, called with one point at a time; the folder one stands in counts."""
    module, _, attribute = name.partition(":")
    sys.path.insert(0, os.getcwd())
    try:
        function = getattr(importlib.import_module(module), attribute)
    except (ImportError, AttributeError, ValueError) as wrong:
        raise ValueError(f"--python: {name!r} is not found ({wrong}); MODULE:NAME is") from None
    except SystemExit as early:
        raise ValueError(f"--python: {module!r} ends the program ({early.code})") from None
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


def called(function: Callable[..., Any], results: int) -> Caller:
    """An error of arithmetic (a division by zero, a logarithm of nothing) is NaN."""

    def run(points: Points) -> list[tuple[float, ...]]:
        found = []
        for point in points:
            try:
                value = function(*point)
            except (ArithmeticError, ValueError):
                value = (float("nan"),) * results
            except TypeError as wrong:
                given = ", ".join(map(str, point))
                raise ValueError(f"--python: called with {given} it fails ({wrong})") from None
            except SystemExit as early:
                given = ", ".join(map(str, point))
                raise ValueError(
                    f"--python: called with {given} it ends the program ({early.code})"
                ) from None
            many = value if isinstance(value, tuple | list) else (value,)
            try:
                found.append(tuple(float(v) for v in many))
            except (TypeError, ValueError):
                given = ", ".join(map(str, point))
                raise ValueError(
                    f"--python: called with {given} it gives {value!r}; numbers are allowed"
                ) from None
        return found

    return run


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

    def run(points: Points) -> list[tuple[float, ...]]:
        text = "".join(" ".join(v.hex() for v in p) + "\n" for p in points)
        try:
            done = subprocess.run(shlex.split(line), input=text, capture_output=True, text=True)
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


def _number(word: str) -> float:
    return float.fromhex(word) if "x" in word.lower() else float(word)
