"""The user's code in a process of its own, with limits; nothing of the package is imported.

``python`` and ``library`` stay and answer on standard output: a line with a JSON object when the
function is there, and one for each batch that is asked for by a line on standard input.  A batch is
read from the file ``points`` of the folder they run in and written to the file ``found``, a line of
hexadecimal floats for each point.  ``command`` becomes the command.
"""

from __future__ import annotations

import ctypes
import importlib
import inspect
import json
import os
import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

Points = Sequence[tuple[float, ...]]


class Failed(ValueError):
    """An error of the user's code, in one line."""


def limited(**most: int) -> None:
    """Set limits such as ``CPU`` (seconds) and ``FSIZE`` (bytes of a file), where there are any."""
    try:
        import resource
    except ImportError:  # Windows has none
        return
    for name, value in most.items():
        kind = getattr(resource, f"RLIMIT_{name}")
        hard = resource.getrlimit(kind)[1]
        least = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(kind, (least, hard))


def called(function: Callable[..., Any], points: Points) -> Iterator[tuple[float, ...]]:
    """Results at points, none for an error of arithmetic (a division by zero, a logarithm of 0)."""
    at: tuple[float, ...] = ()
    try:
        for at in points:
            try:
                value = function(*at)
            except (ArithmeticError, ValueError):
                yield ()
            else:
                yield _numbers(at, value)
    except (Failed, KeyboardInterrupt, GeneratorExit):
        raise
    except SystemExit as wrong:
        raise Failed(f"ends the program ({wrong.code}) when called with {_told(at)}") from None
    except BaseException as wrong:
        raise Failed(f"{_line(wrong)} when called with {_told(at)}") from None


def _numbers(at: tuple[float, ...], value: Any) -> tuple[float, ...]:
    values = tuple(value) if isinstance(value, tuple | list) else (value,)
    try:
        if values:
            return tuple(float(v) for v in values)
        raise ValueError
    except (TypeError, ValueError, OverflowError):
        got = short(repr(values[0] if len(values) == 1 else values))
        raise Failed(f"gives {got} and no numbers when called with {_told(at)}") from None


def _told(at: tuple[float, ...]) -> str:
    return ", ".join(map(str, at))


def _line(wrong: BaseException) -> str:
    return f"{type(wrong).__name__}: {short(str(wrong))}"


def short(text: str) -> str:
    """At most 500 letters in one line."""
    line = " ".join(text.split())
    return line if len(line) <= 500 else f"{line[:500]}..."


def _python(name: str) -> tuple[Callable[..., Any], dict[str, Any]]:
    """``module:function`` and the file and line of it; the folder one stands in counts."""
    module, _, attribute = name.partition(":")
    sys.path.insert(0, os.getcwd())
    try:
        function = getattr(importlib.import_module(module), attribute)
    except (ImportError, AttributeError) as wrong:
        raise Failed(f"{' '.join(str(wrong).split())} (expected MODULE:NAME)") from None
    except SystemExit as wrong:
        raise Failed(f"ends the program ({wrong.code}) when it is imported") from None
    except BaseException as wrong:
        raise Failed(f"{_line(wrong)} when it is imported") from None
    about: dict[str, Any] = {"file": getattr(sys.modules[module], "__file__", None)}
    try:
        real = inspect.unwrap(function)
        about |= {"place": inspect.getsourcefile(real), "line": inspect.getsourcelines(real)[1]}
    except (TypeError, OSError):  # it is not written in Python
        pass
    return function, about


def _library(name: str, arguments: int, results: int) -> tuple[Callable[..., Any], dict[str, Any]]:
    """``FILE:function`` in C: doubles by value; several results by pointers behind them.

    ``FILE:function:bool`` and ``:int`` return that instead of a double.
    """
    double = ctypes.c_double
    kind: Any = double
    for word, other in (("bool", ctypes.c_bool), ("int", ctypes.c_int)):
        if name.endswith(f":{word}"):
            name, kind = name.removesuffix(f":{word}"), other
    file, _, symbol = name.rpartition(":")
    try:
        function = getattr(ctypes.CDLL(os.path.abspath(file)), symbol)
    except (OSError, AttributeError) as wrong:
        raise Failed(f"{wrong} (expected FILE:NAME, FILE:NAME:bool or FILE:NAME:int)") from None
    found = [double() for _ in range(results)]
    function.argtypes = [double] * arguments
    function.restype = kind if results == 1 else None
    if results == 1:
        return function, {}
    function.argtypes += [ctypes.POINTER(double)] * results

    def call(*point: float) -> list[float]:
        function(*point, *found)
        return [one.value for one in found]

    return call, {}


def main(kind: str, numbers: list[int], folder: str, words: list[str]) -> None:
    """Serve batches until standard input ends, or become the command."""
    seconds, memory, output, line, arguments, results = numbers
    limited(CPU=seconds, DATA=memory, FSIZE=output, CORE=0)
    if sys.platform == "linux":  # end with the process that has started this one
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)
    if kind == "command":
        for one in (signal.SIGPIPE, signal.SIGXFSZ):  # Python has them ignored
            signal.signal(one, signal.SIG_DFL)
        os.execvp(words[0], words)
    asked, answers = os.fdopen(os.dup(0)), os.dup(1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os.dup2(2, 1)  # what the function prints

    def answer(**said: Any) -> None:
        os.write(answers, (json.dumps(said) + "\n").encode())

    try:
        if kind == "python":
            function, about = _python(words[0])
        else:
            function, about = _library(words[0], arguments, results)
        answer(**about)
        for _ in asked:
            lines = Path(folder, "points").read_text().splitlines()
            limited(FSIZE=output + line * len(lines))
            points = [tuple(map(float.fromhex, one.split())) for one in lines]
            with open(Path(folder, "found"), "wb", buffering=0) as file:
                for values in called(function, points):
                    file.write((" ".join(map(float.hex, values)) or "-").encode() + b"\n")
            answer()
    except Failed as wrong:
        answer(wrong=str(wrong))


if __name__ == "__main__":
    main(sys.argv[1], [int(n) for n in sys.argv[2:8]], sys.argv[8], sys.argv[9:])
