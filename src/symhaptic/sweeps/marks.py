"""Digests of code and values, by which a store knows whether what made it has changed."""

from __future__ import annotations

import copyreg
import dis
import hashlib
import pickle
import platform
import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import cache, cached_property, reduce
from importlib import import_module
from importlib.metadata import PackageNotFoundError, distribution
from importlib.util import resolve_name
from operator import methodcaller
from pathlib import Path
from types import (
    BuiltinFunctionType,
    CodeType,
    FunctionType,
    GetSetDescriptorType,
    MappingProxyType,
    MethodType,
)
from types import ModuleType as Module
from typing import Any

from symhaptic.version import __version__

_ATOMS = (type(None), type(...), type(NotImplemented), bool, int, float, complex, str, bytes)

_NOT_GIVEN = {
    *("__dict__", "__weakref__", "__module__", "__doc__", "__annotations__", "__firstlineno__"),
    *("__static_attributes__", "__abstractmethods__", "_abc_impl", "__slotnames__"),
}
"""Attributes that Python gives to a class or a function; what these do does not depend on them."""

_Cached = type(cache(len))

_BY_NAME = ("_GLOBAL", "_NAME", "_GLOBALS")
"""Ends of the instructions that read a variable of a module."""

_UNSEEN = {"eval", "exec", "globals", "__import__"}
"""Functions that read what no instruction names."""


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
        kind = type(value)
        if isinstance(value, CodeType):
            yield from self._code(value)
        elif isinstance(value, Module):
            yield from self._module(value, names)
        elif isinstance(value, FunctionType | type):
            yield f"{_home(value)}.{value.__qualname__}"
            if (version := _installed_as(value)) is not None:
                yield version
            elif isinstance(value, type):
                yield from map(self.of, (type(value), value.__bases__))
                yield self.of(_attributes(value))
            else:
                yield from self._function(value)
        elif isinstance(value, MethodType):
            yield from map(self.of, (value.__func__, value.__self__))
        elif isinstance(value, BuiltinFunctionType):
            yield value.__qualname__
            home = sys.modules.get(value.__module__ or "")
            yield self.of(home if isinstance(value.__self__, Module | None) else value.__self__)
        elif isinstance(value, property):
            yield from map(self.of, (kind, value.fget, value.fset, value.fdel))
            yield self.of(_attributes(value))
        elif isinstance(value, cached_property):
            yield from map(self.of, (kind, value.func))
        elif isinstance(value, GetSetDescriptorType):
            yield value.__qualname__
            yield self.of(value.__objclass__)
        elif isinstance(value, MappingProxyType):
            yield self.of(dict(value))
        elif kind in (set, frozenset):
            yield from sorted(map(self.of, value))
        elif kind is list:
            yield from map(self.of, value)
        elif kind is dict:
            yield from map(self.of, value.items())
        elif isinstance(value, staticmethod | classmethod | _Cached):
            yield from map(self.of, (kind, value.__wrapped__))
            yield self.of(_attributes(value))
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
        yield self.of(_attributes(function))
        for cell in function.__closure__ or ():
            try:
                contents = cell.cell_contents
            except ValueError:  # it is empty
                continue
            yield self.of(contents)
        home = function.__globals__.get("__name__") or ""
        version = _installed(home)
        if version is not None and function.__globals__ is vars(sys.modules[home]):
            yield version
            return
        codes = [*_nested(function.__code__)]
        attributes = frozenset(name for code in codes for name in code.co_names)
        read = [
            [i for i in dis.get_instructions(code) if i.opname != "EXTENDED_ARG"] for code in codes
        ]
        names = {i.argval for some in read for i in some if i.opname.endswith(_BY_NAME)}
        for name in sorted(names & set(function.__globals__)):
            yield _digest(name, self.of(function.__globals__[name], attributes))
        if unseen := sorted((names - set(function.__globals__)) & _UNSEEN):
            raise ValueError(
                f"quantity: {function.__qualname__} calls {unseen[0]}, so what it computes cannot "
                "be compared when the sweep is resumed; name what it uses, or leave to= out"
            )
        for name in sorted(_imported(read, function.__globals__.get("__package__") or "")):
            yield self.of(sys.modules[name], attributes)

    def _module(self, module: Module, names: frozenset[str]) -> Iterator[str]:
        yield _own(module.__name__)
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
            raise _incomparable(kind, str(wrong)) from None
        if isinstance(made, str):
            yield from (made, self.of(kind))
            homes = [m for m in [*sys.modules.values()] if _holds(m, made, value)]
            if not homes:
                raise _incomparable(kind, f"no module has it as {made}")
            if all(_installed(module.__name__) is None for module in homes):
                yield from sorted(self.of(module) for module in homes)
            return
        yield from map(self.of, made[:3])
        yield from (self.of(None if more is None else [*more]) for more in made[3:5])


def _incomparable(kind: type, why: str) -> ValueError:
    return ValueError(
        f"quantity: refers to a {kind.__module__}.{kind.__qualname__}, which cannot be "
        f"compared when the sweep is resumed ({why}); make it inside of the function, "
        "or leave to= out"
    )


def _holds(module: Any, name: str, value: Any) -> bool:
    """Whether a module has a value under a name, in classes too."""
    first, *rest = name.split(".")
    found = vars(module).get(first) if isinstance(module, Module) else None
    return reduce(lambda one, part: getattr(one, part, None), rest, found) is value


def _attributes(value: Any) -> list[tuple[str, Any]]:
    """What was given to a class, function or descriptor."""
    return sorted((n, v) for n, v in getattr(value, "__dict__", {}).items() if n not in _NOT_GIVEN)


def _digest(*parts: str) -> str:
    found = hashlib.sha256()
    for part in parts:
        found.update(f"{len(part)}:".encode() + part.encode("utf-8", "surrogatepass"))
    return found.hexdigest()


def _nested(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _nested(constant)


def _imported(read: Sequence[Sequence[dis.Instruction]], package: str) -> set[str]:
    """The modules that instructions import; they are imported here as they are there."""
    found = set[str]()
    for some in read:
        for i, one in enumerate(some):
            if one.opname == "IMPORT_NAME":
                level, parts = some[i - 2].argval, some[i - 1].argval
                with suppress(ImportError):  # which the function may catch
                    name = resolve_name("." * level + one.argval, package)
                    import_module(name)
                    found.add(name)
                    for part in parts or ():
                        if not hasattr(sys.modules[name], part):
                            import_module(f"{name}.{part}")
                    found |= {name[:k] for k, c in enumerate(name) if c == "."}
    return found


def _home(value: Any) -> str:
    """The module of a function or class; nothing where a class describes that of its objects."""
    name = value.__module__
    return _own(name) if isinstance(name, str) else ""


def _own(name: str) -> str:
    """The name of a module; a worker process calls the program that was started by another."""
    return "__main__" if name == "__mp_main__" else name


def _installed_as(value: Any) -> str | None:
    """What tells the version of a function or class of an installed module.

    Nothing for one that a module made while it ran: it may have been made of the user's own.
    """
    home = _home(value)
    version = _installed(home)
    if version is None or (isinstance(value, type) and not value.__flags__ & _MADE):
        return version
    return version if _holds(sys.modules.get(home), value.__qualname__, value) else None


_MADE = 1 << 9
"""The flag of a class that is not compiled into a module."""


@cache
def _installed(name: str) -> str | None:
    """What tells the version of a module that is installed; nothing for one of the user's own."""
    top = name.partition(".")[0]
    if _own(top) == "__main__":
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
