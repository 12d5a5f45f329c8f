"""Adds up the mutants that were tried, over all processes, and says so at the end."""

import gc
import os
import re
import signal
from functools import cache

import pytest

# millions of expressions stay, and the collector of cycles finds none among them
gc.set_threshold(100_000, 50, 50)
# SymPy, which reads this when it is imported, forgets less
os.environ.setdefault("SYMPY_CACHE_SIZE", "20000")
# matrices are small here: threads of several processes would only get in each other's way
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
# JAX's compiler takes most of the time of its tests, and its best code runs only once there
os.environ.setdefault(
    "XLA_FLAGS", "--xla_backend_optimization_level=0 --xla_llvm_disable_expensive_passes=true"
)

# a shell that starts the tests in the background has them ignore what some tests send
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@cache
def _group(path):
    """What one process runs: all tests that look at chapters, so that chapters are run once.

    The tests of each other file stay together, since they share fixtures.
    """
    return "chapters" if _OF_CHAPTERS.search(path.read_text(encoding="utf-8")) else str(path)


_OF_CHAPTERS = re.compile(r"^from (chapters|oracles\.subject) import", re.MULTILINE)


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items):
    """The tests of chapters begin in one process, and in another those that take long."""
    items.sort(key=_place)


def _place(item):
    if item.get_closest_marker("early"):
        return 1
    return 0 if _group(item.path) == "chapters" else 2


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """With ``--dist loadfile`` a process takes one group of tests after the other."""
    if config.getoption("dist") != "loadfile":
        return None
    from xdist.scheduler import LoadFileScheduling

    class Scheduling(LoadFileScheduling):
        def _split_scope(self, nodeid):
            return _group(config.rootpath / nodeid.partition("::")[0])

    return Scheduling(config, log)


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish():
    """What all tests have left is not looked through once more for cycles before a process ends."""
    gc.freeze()


def pytest_terminal_summary(terminalreporter):
    counts = [
        value
        for report in terminalreporter.getreports("passed")
        for name, value in report.user_properties
        if name == "mutants"
    ]
    if counts:
        terminalreporter.write_line(
            f"{sum(counts)} wrong mutants of {len(counts)} statements rejected"
        )
