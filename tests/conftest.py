"""Adds up the mutants that were tried, over all processes, and says so at the end."""

import gc
import os

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


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items):
    """Tests that look at chapters come early, so that one process alone runs the chapters.

    Each process begins with tests beside each other; who is done takes over from another's end.
    """
    items.sort(key=_place)


def _place(item):
    if item.get_closest_marker("early"):
        return 0
    return 1 if _looks_at_chapters(getattr(item, "module", None)) else 2


def _looks_at_chapters(module):
    taken = {getattr(value, "__module__", None) for value in vars(module or object).values()}
    return not taken.isdisjoint({"chapters", "oracles.subject"})


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
