"""The command line in processes of their own, forked from one that has imported the package.

That one runs nothing else, so that each is as if it had been started anew, but for the second or
two that the imports take, most of what a command takes.  ``test_cli.py`` has some that are started
from nothing.
"""

import os
import subprocess
import sys
import tempfile
from multiprocessing import get_context
from multiprocessing.reduction import DupFd

_FORKED = get_context("forkserver")
_OURS = ("book.figures", "book.listing", "book.parallel", "book.parts", "book.report.printed",
         "bounds.walls", "check.callers", "check.checked", "check.compare", "check.formulas",
         "check.report", "cli.main", "numeric.tracing.output", "scene.device_file",
         "scene.scene")  # fmt: skip
_THEIRS = "matplotlib.figure", "matplotlib.backends.backend_svg", "pydantic"
_FORKED.set_forkserver_preload([*(f"symhaptic.{name}" for name in _OURS), *_THEIRS])


def symhaptic(*arguments, cwd=None, text=True, timeout=300):
    """What the command says, and its exit status."""
    command = ["symhaptic", *map(str, arguments)]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = _FORKED.Process(
            target=_run, args=(command, cwd, *(DupFd(f.fileno()) for f in (out, err)))
        )
        process.start()
        process.join(timeout)
        if process.is_alive():
            process.kill()
            raise subprocess.TimeoutExpired(command, timeout)
        said = [_read(file, text) for file in (out, err)]
    return subprocess.CompletedProcess(command, process.exitcode, *said)


def _read(file, text):
    file.seek(0)
    return file.read().decode() if text else file.read()


def _run(command, cwd, out, err):
    from symhaptic.cli.main import main

    for place, file in ((1, out), (2, err)):
        os.dup2(file.detach(), place)
    if cwd is not None:
        os.chdir(cwd)
    sys.argv = command
    main()
