"""The chapters, each run once per process for tests that only look at them, and altered ones."""

from functools import cache

from symhaptic.book.chapters import folder, run


@cache
def chapter(name):
    """A derivation by the name of its file."""
    return run(folder() / f"{name}.py")


def run_altered(name, old, new, place):
    """The same with something else written in place of a text that must be there."""
    text = (folder() / f"{name}.py").read_text(encoding="utf-8")
    assert old in text
    path = place / f"{name}.py"
    path.write_text(text.replace(old, new), encoding="utf-8")
    return run(path)
