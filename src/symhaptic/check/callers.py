"""A user's function, from Python, a shared library or a command, as one that takes points.

It runs in a process of its own (:mod:`symhaptic.check.worker`), which ends with all that it has
started when the time is up, when it prints too much, and when this process ends.
"""

from __future__ import annotations

import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import ExitStack, suppress
from pathlib import Path
from threading import Thread
from time import monotonic
from typing import Any, Self

from symhaptic.book.processes import folder
from symhaptic.check import worker
from symhaptic.check.worker import Points

SECONDS, MEMORY = 60.0, 4.0
"""Limits of time (s) and memory (GiB) of the user's code."""

_OUTPUT, _LINE = 1 << 20, 1 << 10
"""Limits of the printed bytes: in total, and in addition for each point."""

_GRACE = 2.0
"""Seconds in which a correct function has to end after the last point."""

Values = list[tuple[float, ...]]


def called(function: Callable[..., Any]) -> Callable[[Points], Values]:
    """A function of this process, as pytest has it."""
    return lambda points: list(worker.called(function, points))


class Theirs(ExitStack):
    """A function of somebody else's, called with points; a context, which ends its process.

    Raises :class:`ValueError`, in one line, for all that keeps it from giving its results.
    """

    def __init__(
        self,
        kind: str,
        name: str,
        arguments: int,
        results: int,
        seconds: float = SECONDS,
        memory: float = MEMORY,
    ) -> None:
        super().__init__()
        self.kind, self.name, self.seconds, self.left = kind, name, seconds, seconds
        self.words = _words(name) if kind == "command" else [name]
        cpu = (int(seconds) + 5) * (os.cpu_count() or 1)
        self.limits = [cpu, int(memory * 2**30), _OUTPUT, _LINE, arguments, results]
        self.process: subprocess.Popen[bytes] | None = None
        self.about: dict[str, Any] = {}
        """File, and place and line of a Python function."""

    def __enter__(self) -> Self:
        place = self.enter_context(folder("symhaptic-check-"))
        self.points, self.found, self.said = (place / n for n in ("points", "found", "said"))
        self.callback(self._end)
        try:
            if self.kind != "command":
                self.process = self._started(stdin=subprocess.PIPE, stdout=subprocess.PIPE)
                self.about = self._answer("when it is loaded")
        except BaseException:
            self.close()
            raise
        return self

    def __call__(self, points: Points) -> Values:
        """Its results, a tuple for each point."""
        lines = [" ".join(map(float.hex, map(float, point))) for point in points]
        self.points.write_text("\n".join(lines) + "\n")
        self.found.write_bytes(b"")
        if self.kind == "command":
            self._run(len(points))
        else:
            if self.process is not None and self.process.stdin is not None:
                with suppress(BrokenPipeError):
                    self.process.stdin.write(b"\n")
                    self.process.stdin.flush()
            self._answer("at last", points)
        with open(self.found, errors="replace") as file:
            rows = file.read().splitlines()
        try:
            found = [self._numbers(row) for row in rows]
        except ValueError as wrong:
            raise self._wrong(f"{wrong}; print numbers, a line for each point") from None
        if len(found) != len(points):
            raise self._wrong(
                f"prints {len(found)} lines; print one for each of {len(points)} points"
            )
        return found

    def _numbers(self, row: str) -> tuple[float, ...]:
        """Numbers of a line; none where a function has had an error of arithmetic."""
        if row == "-" and self.kind != "command":
            return ()
        return tuple(float.fromhex(w) if "x" in w.lower() else float(w) for w in row.split())

    def finish(self) -> None:
        """See whether it ends without an error when there is nothing left to do."""
        if self.process is not None and self.process.stdin is not None:
            self.process.stdin.close()
            with suppress(subprocess.TimeoutExpired):
                if status := self.process.wait(_GRACE):
                    raise self._wrong(f"ends the program ({status}) at last{self._last()}")

    def files(self) -> set[Path]:
        """What is read when the function is called, as far as its name tells."""
        words = [self.name.partition(":")[0]] if self.kind == "library" else self.words
        every = (*words, self.about.get("file"))
        return {Path(os.path.realpath(word)) for word in every if word}

    def place(self) -> tuple[str, int] | None:
        """File and line of a Python function below the folder one stands in."""
        with suppress(KeyError, ValueError):
            file = Path(self.about["place"]).resolve().relative_to(Path.cwd())
            return file.as_posix(), self.about["line"]
        return None

    def _started(self, **streams: Any) -> subprocess.Popen[bytes]:
        program = [sys.executable, "-P", worker.__file__, self.kind, *map(str, self.limits)]
        program += [str(self.said.parent), *self.words]
        with open(self.said, "wb") as said:
            return subprocess.Popen(program, stderr=said, start_new_session=True, **streams)

    def _run(self, count: int) -> None:
        """The command, with all points as its input."""
        self.limits[2] = _OUTPUT + _LINE * count
        begin = monotonic()
        with open(self.points, "rb") as points, open(self.found, "wb") as found:
            self.process = self._started(stdin=points, stdout=found)
        try:
            status = self.process.wait(max(self.left, 0.001))
        except subprocess.TimeoutExpired:
            raise self._late("no end") from None
        finally:
            self._end()
            self.left -= monotonic() - begin
        if max(self.found.stat().st_size, self.said.stat().st_size) >= self.limits[2]:
            raise self._wrong(f"prints more than {self.limits[2]} bytes for {count} points")
        if status:
            raise self._wrong(f"ends with status {status}{self._last()}; end with 0")

    def _answer(self, when: str, points: Points = ()) -> dict[str, Any]:
        """What the process says within the time that is left."""
        begin, said, process = monotonic(), list[bytes](), self.process
        if process is None or process.stdout is None:
            raise self._wrong("has ended")
        answers = process.stdout
        reading = Thread(target=lambda: said.append(answers.readline()), daemon=True)
        reading.start()
        reading.join(max(self.left, 0.001))
        self.left -= monotonic() - begin
        row = self.found.read_bytes().count(b"\n") if points else 0
        if row < len(points):
            when = f"when called with {', '.join(map(str, points[row]))}"
        if not said:
            self._end()
            raise self._late("no answer", f" {when}")
        if not said[0]:
            raise self._wrong(f"ends the program ({process.wait()}) {when}{self._last()}")
        told: dict[str, Any] = json.loads(said[0])
        if "wrong" in told:
            raise self._wrong(told["wrong"])
        return told

    def _late(self, what: str, when: str = "") -> ValueError:
        return self._wrong(f"{what} after {self.seconds:g} s{when}; --timeout allows more")

    def _wrong(self, what: str) -> ValueError:
        return ValueError(f"--{self.kind} {self.name}: {what}")

    def _last(self) -> str:
        """The last line that it has printed as an error."""
        with open(self.said, errors="replace") as file:
            lines = file.read(_OUTPUT).strip().splitlines()
        return f" ({worker.short(lines[-1])})" if lines else ""

    def _end(self) -> None:
        """End the process and those that it has started."""
        if self.process is not None:
            with suppress(ProcessLookupError, PermissionError):
                if hasattr(os, "killpg"):
                    os.killpg(self.process.pid, signal.SIGKILL)
                else:
                    self.process.kill()
            self.process.wait()
            self.process = None


def python_name(name: str) -> str:
    """``MODULE:NAME``; a file is refused with the module that is meant."""
    module, _, attribute = name.partition(":")
    if module.endswith(".py") or not all(map(str.isidentifier, module.split("."))):
        such = f"{Path(module).stem or 'module'}:{attribute or 'name'}"
        raise ValueError(f"--python {name}: no module and name; give MODULE:NAME, such as {such}")
    return name


def _words(line: str) -> list[str]:
    """A command's program and what it is given."""
    try:
        words = shlex.split(line)
    except ValueError as wrong:
        raise ValueError(f"--command {line}: {wrong}; give a program and its arguments") from None
    if not words or shutil.which(words[0]) is None:
        found = repr(words[0]) if words else "an empty line"
        raise ValueError(f"--command {line}: {found} is no program; give one and its arguments")
    return words
