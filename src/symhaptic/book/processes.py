"""Workers, programs and temporary folders that do not outlive this process, even if it is killed.

A killed process cannot clean up.  Each worker therefore watches its parent, and a small Python
process holds each program and each temporary folder: it waits for the end of its standard input,
which the system closes when this process ends.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import tempfile
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from multiprocessing.connection import Connection, wait
from pathlib import Path
from subprocess import PIPE, CompletedProcess, Popen
from typing import Any
from uuid import uuid4


def end_with_parent(*pipes: Connection) -> None:
    """Prepare a worker process: only its parent reacts to Ctrl-C, and it ends with its parent.

    It also ends when the other end of one of the ``pipes`` is closed.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    threading.Thread(target=_watch, args=pipes, daemon=True).start()


def _watch(*pipes: Connection) -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel, *pipes])
        os._exit(1)


_FOLDER = """
import os, shutil, sys, time
sys.stdin.read()
for _ in range(100):  # a program that is being killed may still write there
    shutil.rmtree(sys.argv[1], ignore_errors=True)
    if not os.path.lexists(sys.argv[1]):
        break
    time.sleep(0.05)
for parent in sys.argv[2:]:
    if os.path.isdir(parent) and not os.listdir(parent):
        os.rmdir(parent)
"""

_PROGRAM = """
import os, signal, subprocess, sys, threading
program = subprocess.Popen(sys.argv[1:], stdin=subprocess.DEVNULL)
def end():
    sys.stdin.read()
    os.killpg(0, signal.SIGKILL) if hasattr(os, "killpg") else program.kill()
threading.Thread(target=end, daemon=True).start()
os._exit(program.wait() & 255)
"""


def _held(what: str, *arguments: str | Path, **options: Any) -> Popen[str]:
    """Start a process that holds something, in a session that no signal of a terminal reaches."""
    command = [sys.executable, "-I", "-S", "-c", what, *map(str, arguments)]
    return Popen(command, stdin=PIPE, start_new_session=True, text=True, **options)


@contextmanager
def folder(prefix: str = "symhaptic-", parent: Path | None = None) -> Iterator[Path]:
    """Make a temporary folder, which is removed at the end; so are new parents that stay empty."""
    new = [] if parent is None else [p for p in (parent, *parent.parents) if not p.exists()]
    made = (parent or Path(tempfile.gettempdir())) / f"{prefix}{uuid4().hex}"
    with _held(_FOLDER, made, *new):  # started first: a kill in between leaves nothing
        if new:
            new[0].mkdir(parents=True, exist_ok=True)
        made.mkdir(0o700)
        yield made


@contextmanager
def temporary() -> Iterator[None]:
    """Keep what is temporary, also of compilers, in a folder that is removed after a kill, too."""
    of_python, of_programs = tempfile.tempdir, os.environ.get("TMPDIR")
    with folder() as made:
        tempfile.tempdir = os.environ["TMPDIR"] = str(made)
        try:
            yield
        finally:
            tempfile.tempdir = of_python
            if of_programs is None:
                del os.environ["TMPDIR"]
            else:
                os.environ["TMPDIR"] = of_programs


@contextmanager
def program(command: Sequence[str | Path], **options: Any) -> Iterator[Popen[str]]:
    """Start a program without input; it ends at the end, with all that it has started."""
    with _held(_PROGRAM, *command, **options) as process:
        held, process.stdin = process.stdin, None  # or `communicate` would close it
        assert held is not None
        with held:
            yield process


def run(command: Sequence[str | Path], **options: Any) -> CompletedProcess[str]:
    """Run a program to its end, and return its status and what it prints."""
    with program(command, stdout=PIPE, stderr=PIPE, **options) as process:
        said, complained = process.communicate()
    return CompletedProcess(list(command), process.returncode, said, complained)
