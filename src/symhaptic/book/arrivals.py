"""What a chapter's process sends, read as data: nothing in it is run but what makes data of ours.

Of a theorem that the reader had derived before, and that the chapter's process had from it, the
place among these is sent; every other is derived anew.

A pickle names functions and calls them, and changes what it has named.  Here it may name the
records of this package, the two functions by which a theorem is found or derived anew, and what
terms are made of; what it names is out of its reach, only records that it has made itself get their
fields, and no text is given to SymPy, which would run it.  A symbol that SymPy has counted there
gets a number that is counted here, so that none is there twice.
"""

from __future__ import annotations

import io
import pickle
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path, PosixPath, WindowsPath
from types import MappingProxyType
from typing import Any, ClassVar, NoReturn, TypeAlias

import sympy as sp
from sympy import Basic
from sympy.core.function import AppliedUndef, UndefinedFunction
from sympy.parsing import sympy_parser

from symhaptic.book.chapters import BadChapter
from symhaptic.notation.fresh import made_before, mark
from symhaptic.notation.proposition import Proposition
from symhaptic.notation.terms import FUNCTIONS
from symhaptic.proof.seal import Sealed
from symhaptic.proof.theorems import kernel
from symhaptic.proof.theorems.kernel import Theorem

_RELATIONS = {sp.Eq, sp.Ne, sp.Lt, sp.Le, sp.Gt, sp.Ge}
_SYMBOLS = {sp.Symbol, sp.Dummy}
_ATOMS = (sp.pi, sp.E, sp.I, sp.S.Zero, sp.S.One, sp.S.NegativeOne, sp.S.Half)
_TERMS = {sp.Add, sp.Mul, sp.Pow, sp.Integer, sp.Rational, *FUNCTIONS, *map(type, _ATOMS)}
_PLAIN = {Counter, Path, PosixPath, WindowsPath, set, frozenset}
_WRONG = (
    *(pickle.UnpicklingError, AttributeError, ImportError, LookupError, TypeError, ValueError),
    RecursionError,
)


Places: TypeAlias = Mapping[int, int]
"""The place of each theorem that is known where a result arrives, by what it is."""


def places(known: Sequence[Theorem]) -> Places:
    """The places of theorems among those that are known, which have to be kept."""
    return {id(theorem): place for place, theorem in enumerate(known)}


def sent(result: Any, known: Places = MappingProxyType({})) -> bytes:
    """A result as it is sent to who has derived the theorems at these places."""
    stream = io.BytesIO()
    _Writer(stream, known).dump(result)
    return stream.getvalue()


class _Writer(pickle.Pickler):
    """Writes the place of a theorem that is known where it arrives.

    What is wrong with a chapter is written as it is made, however other packages would have it, and
    an enumerated name by its value: Pythons before 3.11.4 would have who reads look it up.
    """

    def __init__(self, file: io.BytesIO, known: Places) -> None:
        super().__init__(file)
        self.places = known

    def reducer_override(self, part: Any) -> Any:
        if type(part) is BadChapter:
            return BadChapter, part.args
        if isinstance(part, Enum):
            return type(part), (part.value,)
        place = self.places.get(id(part)) if type(part) is Theorem else None
        return NotImplemented if place is None else (_known, (place,))


def _known(place: int) -> Theorem:
    """The theorem of a place; asked of who reads, and of nobody else."""
    raise pickle.UnpicklingError(f"no theorem is known to be at {place}")


@contextmanager
def without_text() -> Iterator[None]:
    """Within it SymPy takes no text for a term, wherever somebody has put some: it would run it."""
    run, sympy_parser.eval_expr = sympy_parser.eval_expr, _not_run
    try:
        yield
    finally:
        sympy_parser.eval_expr = run


def _not_run(code: str, *names: Any) -> NoReturn:
    raise SyntaxError("text is no term")


def arrived(sent: bytes, path: Path, known: Sequence[Theorem] = ()) -> Any:
    """The result of a chapter, its theorems derived anew; or what is wrong with what was sent."""
    try:
        with without_text():
            return _Reader(io.BytesIO(sent), known).load()
    except _WRONG as wrong:
        said = " ".join(str(wrong).split())
        return BadChapter(path, f"what its process sent is no result: {said}")


class _Named:
    """Something that a pickle names; of it there is no more than what it makes."""

    def __init__(self, kind: Any) -> None:
        self.kind = kind

    def called(self, *args: Any, **named: Any) -> Any:
        """What a call of it gives."""
        if self.kind in _SYMBOLS or _is_made_of_terms(self.kind):
            return self.anew(*args, **named)
        return self.kind(*args, **named)

    def anew(self, *args: Any, **named: Any) -> Any:
        """One that has no fields yet, or a term."""
        if _is_made_of_terms(self.kind) and not all(isinstance(a, (Basic, int)) for a in args):
            name = self.kind.__name__
            raise pickle.UnpicklingError(f"{name} of text is not allowed in it")
        if self.kind in _RELATIONS:
            return self.kind(*args, evaluate=False)
        if isinstance(self.kind, type):
            return self.kind.__new__(self.kind, *args, **named)
        raise pickle.UnpicklingError(f"{self.kind.__name__} makes nothing without a call")


class _Reader(pickle._Unpickler):
    """Every step of the pickle that makes or changes anything, in Python."""

    stack: list[Any]
    dispatch: ClassVar[dict[int, Any]] = dict(pickle._Unpickler.dispatch)

    def __init__(self, file: io.BytesIO, known: Sequence[Theorem]) -> None:
        super().__init__(file)
        self.records: dict[int, Any] = {}
        self.dummies: dict[sp.Dummy, sp.Dummy] = {}
        self.mark = mark()
        self.known = known

    def find_class(self, module: str, name: str) -> _Named:
        if (module, name) == (__name__, "_known"):
            return _Named(self.known.__getitem__)
        if (module, name) == (kernel.__name__, "_arrived"):
            return _Named(kernel._arrived)
        if (module, name) == (AppliedUndef.__module__, "_rebuild_undef"):
            return _Named(_unknown)
        ours = module.startswith("symhaptic.")
        if not ours and module not in sys.modules:
            raise pickle.UnpicklingError(f"{module} is not allowed in it")
        found = super().find_class(module, name)
        if found in _SYMBOLS or found in _PLAIN or _is_made_of_terms(found):
            return _Named(found)
        where = getattr(found, "__module__", None), getattr(found, "__name__", None)
        if ours and isinstance(found, type) and where == (module, name) and _is_record(found):
            return _Named(found)
        raise pickle.UnpicklingError(f"{module}.{name} is not allowed in it")

    def load_reduce(self) -> None:
        args = self.stack.pop()
        self.stack[-1] = self._here(self._asked(self.stack[-1]).called(*args))

    def load_newobj(self) -> None:
        args = self.stack.pop()
        self._made(self.stack.pop(), args, {})

    def load_newobj_ex(self) -> None:
        named, args = self.stack.pop(), self.stack.pop()
        self._made(self.stack.pop(), args, named)

    def _made(self, named: Any, args: Any, keywords: Any) -> None:
        made = self._here(self._asked(named).anew(*args, **keywords))
        if is_dataclass(made):
            self.records[id(made)] = made
        self.stack.append(made)

    def _here(self, made: Any) -> Any:
        """What was made; for a symbol that was counted elsewhere one that is counted here."""
        if type(made) is not sp.Dummy or made_before(made, self.mark):
            return made
        if made not in self.dummies:
            self.dummies[made] = sp.Dummy(made.name, **made.assumptions0)
        return self.dummies[made]

    def _asked(self, named: Any) -> _Named:
        if type(named) is not _Named:
            raise pickle.UnpicklingError(f"{type(named).__name__} makes nothing in it")
        return named

    def load_build(self) -> None:
        """The fields of a record that was made here, and nothing else of it."""
        state, made = self.stack.pop(), self.stack[-1]
        if type(made) is BadChapter:
            return  # made of what it says
        if id(made) not in self.records or isinstance(made, Proposition):
            raise pickle.UnpicklingError(f"{type(made).__name__} does not change in it")
        made.__dict__.update({field.name: state[field.name] for field in fields(made)})

    def refused(self) -> None:
        """What no sender of ours writes."""
        raise pickle.UnpicklingError("what no record is written with is not allowed in it")

    dispatch[pickle.REDUCE[0]] = load_reduce
    dispatch[pickle.NEWOBJ[0]] = load_newobj
    dispatch[pickle.NEWOBJ_EX[0]] = load_newobj_ex
    dispatch[pickle.BUILD[0]] = load_build
    for op in (pickle.INST, pickle.OBJ, pickle.EXT1, pickle.EXT2, pickle.EXT4, pickle.PERSID):
        dispatch[op[0]] = refused


def _is_made_of_terms(kind: Any) -> bool:
    """Whether SymPy makes it of terms, which no text may stand for."""
    if not isinstance(kind, type):
        return False
    return kind in _TERMS or kind in _RELATIONS or type(kind) is UndefinedFunction


def _unknown(name: object, assumed: Any) -> _Named:
    """A function of which nothing is known but its name, and what is assumed of its values."""
    if type(name) is not str or not all(type(holds) is bool for holds in assumed.values()):
        raise pickle.UnpicklingError("a function that is more than its name is not allowed in it")
    return _Named(sp.Function(name, **assumed))


def _is_record(kind: type) -> bool:
    """Whether a class is one of data: a record that is not sealed, or one of few values."""
    if issubclass(kind, Sealed):
        return False
    return is_dataclass(kind) or issubclass(kind, (Enum, BadChapter))
