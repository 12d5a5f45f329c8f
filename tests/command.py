"""The command line in processes of their own, forked from one that has imported the package.

That one runs nothing else, so that each is as if it had been started anew, but for the second or
two that the imports take, most of what a command takes.  ``test_cli.py`` has some that are started
from nothing.
"""

import os
import subprocess
import sys
import tempfile
from multiprocessing import forkserver, get_context
from multiprocessing.reduction import DupFd
from pathlib import Path
from unittest.mock import patch

_FORKED = get_context("forkserver")
_FORKED.set_forkserver_preload(["preloaded"])


def symhaptic(*arguments, cwd=None, text=True, timeout=1200):
    """What the command says, and its exit status."""
    here = os.pathsep.join([str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")])
    with patch.dict(os.environ, {"PYTHONPATH": here}):  # where the server looks, not its caller
        forkserver.ensure_running()
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
