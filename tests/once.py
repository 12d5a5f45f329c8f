"""What takes long to make is made by one worker of pytest-xdist, and the others use it."""

import fcntl
import os


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
