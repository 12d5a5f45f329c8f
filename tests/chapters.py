"""The chapters, each run once per process, for all tests that only look at them."""

from functools import cache

from symhaptic.library import folder, run


@cache
def chapter(name):
    """A derivation by the name of its file."""
    return run(folder() / f"{name}.py")
