"""What takes long to make is made once: for a worker of pytest-xdist, or for all of them."""

import fcntl
import os
from functools import cache

import pytest


def once(factory, name, make):
    """A folder that ``make`` fills the first time that a worker asks for it."""
    root = factory.getbasetemp()
    root = root.parent if "PYTEST_XDIST_WORKER" in os.environ else root
    folder, ready = root / name, root / f"{name}.ready"
    with (root / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not ready.exists():
            folder.mkdir()
            make(folder)
            ready.touch()
    return folder


@cache
def registry():
    """The units of Pint, which takes a tenth of a second to read them."""
    return pytest.importorskip("pint", reason="no Pint here").UnitRegistry()
