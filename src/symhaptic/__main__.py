"""``symhaptic`` and ``python -m symhaptic``: the command line, which can be ended at any moment."""

from __future__ import annotations

import os
import signal
import sys
from threading import Timer, main_thread
from typing import NoReturn

_GRACE = 10
"""Seconds in which a command that is asked to end removes its drafts; then it is killed."""


def _end(number: int, _: object) -> NoReturn:
    """Unwind as Python does on Ctrl-C, without waiting for what workers are computing."""
    from multiprocessing import active_children

    if hasattr(signal, "alarm"):
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.alarm(_GRACE)
    for worker in active_children():
        worker.terminate()
    _received.append(number)
    raise KeyboardInterrupt


def _swallowed(ignored: sys.UnraisableHookArgs) -> None:
    """Ask again if the interruption came where Python ignores errors, as in a finaliser."""
    if isinstance(ignored.exc_value, KeyboardInterrupt) and _received:
        Timer(0.05, _interrupt, _received[:1]).start()
    else:
        sys.__unraisablehook__(ignored)


def _interrupt(number: int) -> None:
    """Send a signal to the main thread, also where it sleeps."""
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(main_thread().ident or 0, number)
    else:
        signal.raise_signal(number)


_received: list[int] = []
"""The signals that asked the command to end."""


def _opened() -> None:
    """Open the standard streams that somebody has closed, or a file of results would be one.

    Without a standard output what is printed would be lost, and the command would seem to succeed.
    """
    lost = sys.stdout is None
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        pass
    os.close(number)
    if sys.stderr is None:
        sys.stderr = open(2, "w")  # noqa: SIM115 - it stays open
    if lost:
        sys.stderr.write("symhaptic: error: standard output: is closed; give it a place\n")
        raise SystemExit(2)


def main() -> None:
    """What the command line does; interrupted, one line, and the exit status of its signal."""
    for number in (signal.SIGINT, signal.SIGTERM):
        if signal.getsignal(number) in (signal.SIG_DFL, signal.default_int_handler):
            signal.signal(number, _end)
    sys.unraisablehook = _swallowed
    _opened()
    try:
        from symhaptic.cli.main import main as answered

        answered()
    except KeyboardInterrupt:
        sys.stderr.write("symhaptic: interrupted\n")
        raise SystemExit(130) from None
    finally:
        if _received:
            exec("")  # Python ends by a signal if its last `exec` was interrupted
            raise SystemExit(128 + _received[0]) from None


if __name__ == "__main__":
    main()
