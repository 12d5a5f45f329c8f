"""Optional dependencies, and what installs them."""

from __future__ import annotations

from importlib.util import find_spec


def missing(*modules: str) -> list[str]:
    """Return those of the modules that are not installed, by the names of their distributions."""
    return [_CALLED.get(name, name) for name in modules if find_spec(name) is None]


_CALLED = {"pypandoc": "pypandoc_binary"}


def needed(what: str, *modules: str, extra: str | None = None) -> None:
    """Raise :class:`ModuleNotFoundError`, in one line, if ``what`` needs a module that is missing.

    The line says how to install it: by the ``extra`` of the package, or by its own name.

    >>> needed("symhaptic.sweep", "sys", "dusk", "xerxes", extra="sweep")
    Traceback (most recent call last):
    ModuleNotFoundError: symhaptic.sweep needs dusk and xerxes: pip install 'symhaptic[sweep]'
    """
    if found := missing(*modules):
        *first, last = found
        names = f"{', '.join(first)} and {last}" if first else last
        install = f"'symhaptic[{extra}]'" if extra else " ".join(found)
        raise ModuleNotFoundError(f"{what} needs {names}: pip install {install}", name=last)
