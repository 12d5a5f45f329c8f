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


def pytest_itemcollected(item):
    """Tests that look at chapters are one group, so that one process alone runs the chapters."""
    module = vars(getattr(item, "module", None) or object)
    taken = {getattr(value, "__module__", None) for value in module.values()}
    if not taken.isdisjoint({"chapters", "oracles.subject"}):
        item.add_marker(pytest.mark.xdist_group("chapters"))


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items):
    """The tests of chapters begin in one process, and in another those that take long."""
    items.sort(key=_place)


def _place(item):
    if item.get_closest_marker("early"):
        return 1
    return 0 if item.get_closest_marker("xdist_group") else 2


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """With ``--dist loadgroup`` the other tests of a file are a group, too: they share fixtures."""
    if config.getoption("dist") != "loadgroup":
        return None
    from xdist.scheduler import LoadGroupScheduling

    class Scheduling(LoadGroupScheduling):
        def _split_scope(self, nodeid):
            return super()._split_scope(nodeid).partition("::")[0]

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
