"""Digests of code and values, by which a store knows whether what made it has changed."""

from __future__ import annotations

import copyreg
import dis
import hashlib
import pickle
import platform
import sys
from collections.abc import Iterator
from functools import cache, cached_property
from importlib.metadata import PackageNotFoundError, distribution
from itertools import accumulate
from operator import methodcaller
from pathlib import Path
from types import BuiltinFunctionType, CodeType, FunctionType, MappingProxyType, MethodType
from types import ModuleType as Module
from typing import Any

from symhaptic.version import __version__

_ATOMS = (type(None), type(...), type(NotImplemented), bool, int, float, complex, str, bytes)

_OF_NO_CLASS = {
    *("__dict__", "__weakref__", "__module__", "__doc__", "__annotations__", "__firstlineno__"),
    *("__static_attributes__", "__abstractmethods__", "_abc_impl"),
}
"""Attributes that Python gives to a class; methods do not depend on them."""


@cache
def package() -> str:
    """Return the version of this package and a digest of its code."""
    home, found = Path(__file__).parents[1], hashlib.sha256()
    for path in sorted(home.rglob("*.py")):
        found.update(f"{path.relative_to(home).as_posix()}\n".encode() + path.read_bytes())
    return f"{__version__} ({found.hexdigest()[:12]})"


def mark(function: Any) -> str:
    """Return a digest of a function with all that it refers to.

    Included are constants, nested functions, default values, closures, and the functions, classes
    and values that it finds in its module and in others.  Of installed packages, the files that
    were installed count; of Python and its library, the version.

    Raises :class:`ValueError` for a value that cannot be compared with that of another run.
    """
    return _Marks().of(function)


class _Marks:
    """The digests of one function; what refers to itself is counted once."""

    def __init__(self) -> None:
        self._seen: dict[object, tuple[int, Any]] = {}

    def of(self, value: Any, names: frozenset[str] = frozenset()) -> str:
        """Return the digest of a value; of a module, of its attributes with these names."""
        kind = type(value)
        if kind in _ATOMS:
            return _digest(kind.__name__, repr(value))
        if kind is tuple:
            return _digest("tuple", *map(self.of, value))
        key = (id(value), names if kind is Module else None)
        if key in self._seen:
            return _digest("again", str(self._seen[key][0]))
        self._seen[key] = len(self._seen), value  # which keeps its id from being given again
        return _digest(kind.__qualname__, *self._parts(value, names))

    def _parts(self, value: Any, names: frozenset[str]) -> Iterator[str]:
        if isinstance(value, CodeType):
            yield from self._code(value)
        elif isinstance(value, Module):
            yield from self._module(value, names)
        elif isinstance(value, FunctionType | type):
            yield f"{value.__module__}.{value.__qualname__}"
            if (version := _installed(value.__module__)) is not None:
                yield version
            elif isinstance(value, type):
                yield from map(self.of, value.__bases__)
                own = {n: v for n, v in vars(value).items() if n not in _OF_NO_CLASS}
                yield self.of(sorted(own.items()))
            else:
                yield from self._function(value)
        elif isinstance(value, MethodType):
            yield from map(self.of, (value.__func__, value.__self__))
        elif isinstance(value, BuiltinFunctionType):
            yield value.__qualname__
            home = sys.modules.get(value.__module__ or "")
            yield self.of(home if isinstance(value.__self__, Module | None) else value.__self__)
        elif isinstance(value, property):
            yield from map(self.of, (value.fget, value.fset, value.fdel))
        elif isinstance(value, cached_property):
            yield self.of(value.func)
        elif isinstance(value, set | frozenset):
            yield from sorted(map(self.of, value))
        elif isinstance(value, MappingProxyType):
            yield self.of(dict(value))
        elif type(value) is list:
            yield from map(self.of, value)
        elif type(value) is dict:
            yield from map(self.of, value.items())
        elif hasattr(value, "__wrapped__") and type(value).__module__ in ("functools", "builtins"):
            yield self.of(value.__wrapped__)
        else:
            yield from self._object(value)

    def _code(self, code: CodeType) -> Iterator[str]:
        yield repr((
            *(code.co_code, code.co_exceptiontable, code.co_flags, code.co_names),
            *(code.co_varnames, code.co_cellvars, code.co_freevars),
            *(code.co_argcount, code.co_posonlyargcount, code.co_kwonlyargcount),
        ))  # fmt: skip
        yield from map(self.of, code.co_consts)

    def _function(self, function: FunctionType) -> Iterator[str]:
        yield from map(self.of, (function.__code__, function.__defaults__, function.__kwdefaults__))
        for cell in function.__closure__ or ():
            try:
                contents = cell.cell_contents
            except ValueError:  # it is empty
                continue
            yield self.of(contents)
        codes = [*_nested(function.__code__)]
        attributes = frozenset(name for code in codes for name in code.co_names)
        read = [i for code in codes for i in dis.get_instructions(code)]
        names = {i.argval for i in read if i.opname.endswith(("_GLOBAL", "_NAME"))}
        for name in sorted(names & set(function.__globals__)):
            yield _digest(name, self.of(function.__globals__[name], attributes))
        home = function.__globals__.get("__package__") or ""
        parents = ["", *accumulate(home.split("."), _dot)]
        imported = {i.argval for i in read if i.opname == "IMPORT_NAME"}
        for name in sorted({_dot(parent, name) for parent in parents for name in imported}):
            if name in sys.modules:
                yield self.of(sys.modules[name], attributes)

    def _module(self, module: Module, names: frozenset[str]) -> Iterator[str]:
        yield module.__name__
        version = _installed(module.__name__)
        if version is not None:
            yield version
            return
        file = getattr(module, "__file__", None) or ""
        if file and not file.endswith(".py"):
            yield hashlib.sha256(Path(file).read_bytes()).hexdigest()
        for name in sorted(names & set(vars(module))):
            yield _digest(name, self.of(vars(module)[name], names))

    def _object(self, value: Any) -> Iterator[str]:
        """As it would be copied: its class, and what makes it this one."""
        kind = type(value)
        reduced = copyreg.dispatch_table.get(kind, methodcaller("__reduce_ex__", 4))
        try:
            made: Any = reduced(value)
        except (TypeError, ValueError, AttributeError, RuntimeError, pickle.PicklingError) as wrong:
            raise ValueError(
                f"quantity: refers to a {kind.__module__}.{kind.__qualname__}, which cannot be "
                f"compared when the sweep is resumed ({wrong}); make it inside of the function, "
                "or leave to= out"
            ) from None
        if isinstance(made, str):
            yield from (made, self.of(kind))
            return
        yield from map(self.of, made[:3])
        yield from (self.of(None if more is None else [*more]) for more in made[3:5])


def _digest(*parts: str) -> str:
    found = hashlib.sha256()
    for part in parts:
        found.update(f"{len(part)}:".encode() + part.encode("utf-8", "surrogatepass"))
    return found.hexdigest()


def _dot(parent: str, name: str) -> str:
    return f"{parent}.{name}".strip(".")


def _nested(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _nested(constant)


@cache
def _installed(name: str) -> str | None:
    """What tells the version of a module that is installed; nothing for one of the user's own."""
    top = name.partition(".")[0]
    if top == "__main__":
        return None
    if top in sys.stdlib_module_names:
        return platform.python_version()
    if top == "symhaptic":
        return package()
    file = getattr(sys.modules.get(name), "__file__", None) or ""
    if not {"site-packages", "dist-packages"} & set(Path(file).parts):
        return None
    try:
        found = distribution(top)
    except PackageNotFoundError:
        return str(getattr(sys.modules[top], "__version__", ""))
    return found.read_text("RECORD") or found.version
