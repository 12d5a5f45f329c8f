"""Finds the derivations and runs them: each file is one chapter, in the order of their names."""

from __future__ import annotations

import ast
import importlib.util
import inspect
import symtable
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from traceback import TracebackException
from types import ModuleType, TracebackType

from symhaptic.book.page import Page
from symhaptic.book.record import PACKAGE
from symhaptic.book.sources import add
from symhaptic.paper.statement import Source, Statement
from symhaptic.proof.recheck import confirm


class BadChapter(ValueError):
    """A derivation that cannot be run, or that proves nothing; the message is one line."""

    def __init__(self, path: Path, what: str, line: int | None = None) -> None:
        super().__init__(path, what, line)
        self.path, self.what, self.line = path, what, line

    @property
    def place(self) -> str:
        """The file, and where known the line in it."""
        return str(self.path) if self.line is None else f"{self.path}:{self.line}"

    def __str__(self) -> str:
        return f"{self.place}: {self.what}"


_LONGEST = 500
"""Letters of an error that a line shows."""

NO_DERIVE = "has no function derive(page)"
NO_TITLE = "has no docstring; its first line is the chapter's title"

_NOT_RUN_BY_A_CALL = (
    inspect.iscoroutinefunction,
    inspect.isgeneratorfunction,
    inspect.isasyncgenfunction,
)


@dataclass(frozen=True)
class Chapter:
    """A derivation that has been run."""

    path: Path
    title: str
    introduction: str
    page: Page
    seconds: float

    @property
    def name(self) -> str:
        """File name without ending."""
        return self.path.stem

    @property
    def source(self) -> str:
        """Where the derivation stands, relative to the project."""
        return source(self.path)


def beside(name: str) -> Path:
    """A file or folder of the project: inside an installed package, or in the repository."""
    inside = PACKAGE / name
    return inside if inside.exists() else PACKAGE.parents[1] / name


def folder() -> Path:
    """The folder of the paper's derivations."""
    return beside("derivations")


def source(path: Path) -> str:
    """Where a derivation stands, relative to the project, or its name alone."""
    return f"derivations/{path.name}" if path.resolve().parent == folder() else path.name


def expected_ledger() -> Path:
    """The committed ledger that `symhaptic verify` compares with."""
    return beside("reports") / "ledger.json"


def expected_mutants() -> Path:
    """The committed outcome of `symhaptic mutants`."""
    return beside("reports") / "mutants.json"


def expected_rocq() -> Path:
    """The committed record of what Rocq has checked."""
    return beside("reports") / "rocq.json"


def expected_bench() -> Path:
    """The committed measurement of `symhaptic bench`, which the report shows."""
    return beside("reports") / "bench.json"


def shipped() -> list[Path]:
    """The paper's derivations, in the order of the paper."""
    return sorted(folder().glob("s*.py"))


SOURCE_FILE = "source.py"

_sources: dict[Path, Source] = {}
"""The sources of users that were read, by their folders."""


def source_beside(path: Path) -> Source | None:
    """Return the source in whose folder a chapter stands, or None.

    Its ``source.py`` is run when it is asked for first.  Raises :class:`BadChapter` if something is
    wrong with it.
    """
    folder = path.resolve().parent
    file = folder / SOURCE_FILE
    if folder not in _sources and file.is_file():
        module = _load(file)
        with _SomebodyElses(file):
            if not hasattr(module, "SOURCE") or not hasattr(module, "STATEMENTS"):
                raise BadChapter(file, "has no SOURCE or no STATEMENTS")
            source, statements = module.SOURCE, tuple(module.STATEMENTS)
            if not isinstance(source, Source) or any(
                not isinstance(s, Statement) for s in statements
            ):
                raise BadChapter(file, "SOURCE is no Source, or STATEMENTS are no Statements")
            _sources[folder] = add(source, statements)
    return _sources.get(folder)


def run(path: Path) -> Chapter:
    """Run one derivation.

    Raises :class:`BadChapter` with one line that names the file and what is wrong with it.
    """
    begin = time.perf_counter()
    source_beside(path)
    module = _load(path)
    derive = getattr(module, "derive", None)
    if not callable(derive):
        raise BadChapter(path, NO_DERIVE)
    text = module.__doc__ if isinstance(module.__doc__, str) else ""
    title, _, introduction = text.strip().partition("\n")
    if not title:
        raise BadChapter(path, NO_TITLE)
    if any(kind(derive) for kind in _NOT_RUN_BY_A_CALL):
        raise BadChapter(path, "derive is async or has a yield; give a plain function")
    page = Page(path.stem)
    with _SomebodyElses(path):
        derive(page)
        confirm(page.certificates)
    if not any(block.verdict == "proved" for block in page.blocks) and not page.settled:
        raise BadChapter(path, "proves nothing; a chapter has at least one step or verdict")
    return Chapter(path, title, introduction.strip(), page, time.perf_counter() - begin)


def found(path: Path) -> Path:
    """The path itself; raises :class:`BadChapter` where no file is."""
    if not path.is_file():
        what = "is a folder" if path.is_dir() else "no such file"
        raise BadChapter(path, f"{what}; a derivation is a Python file")
    return path


def readable(path: Path) -> Path:
    """The path itself, looked at without being run.

    Raises :class:`BadChapter` for a file that is no Python, or has no docstring or no ``derive``.
    """
    with _SomebodyElses(path):
        text = importlib.util.decode_source(found(path).read_bytes())
        tree = ast.parse(text, str(path))
        names = symtable.symtable(text, str(path), "exec")
    if not _binds(tree, names, "derive"):
        raise BadChapter(path, NO_DERIVE)
    if not (ast.get_docstring(tree) or _binds(tree, names, "__doc__")):
        raise BadChapter(path, NO_TITLE)
    return path


def _binds(tree: ast.Module, names: symtable.SymbolTable, name: str) -> bool:
    """Whether a module may give a name a meaning."""
    if any(isinstance(n, ast.ImportFrom) and n.names[0].name == "*" for n in ast.walk(tree)):
        return True
    if name not in names.get_identifiers():
        return False
    symbol = names.lookup(name)
    return symbol.is_assigned() or symbol.is_imported()


def _load(path: Path) -> ModuleType:
    """The module of a file, read anew each time; nothing is written beside it."""
    spec = importlib.util.spec_from_file_location(f"derivation_{path.stem}", found(path))
    if spec is None or spec.loader is None:
        raise BadChapter(path, "not a Python file; a derivation ends in .py")
    module = importlib.util.module_from_spec(spec)
    with _SomebodyElses(path):
        text = importlib.util.decode_source(path.read_bytes())
        exec(compile(text, str(path), "exec"), vars(module))
    return module


class _SomebodyElses:
    """The border to a derivation's own code: whatever it raises becomes one line that names it."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __enter__(self) -> None:
        # what it prints is for people, not part of a listing
        self.stdout, sys.stdout = sys.stdout, sys.stderr

    def __exit__(
        self,
        kind: type[BaseException] | None,
        wrong: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        sys.stdout = self.stdout
        if kind is None or wrong is None or issubclass(kind, (KeyboardInterrupt, BadChapter)):
            return
        # str() of an error may itself raise an error
        said = (
            str(wrong.msg)
            if isinstance(wrong, SyntaxError)
            else str(TracebackException(kind, wrong, None))
        )
        line = " ".join(said.split()) or "no message"
        line = line if len(line) <= _LONGEST else f"{line[:_LONGEST]}..."
        own = str(kind.__module__).startswith("symhaptic")
        what = line if own else f"{kind.__name__}: {line}"
        raise BadChapter(self.path, what, self._line(wrong, trace)) from wrong

    def _line(self, wrong: BaseException, trace: TracebackType | None) -> int | None:
        """The line of the chapter in which it went wrong: the innermost one that is its own."""
        if isinstance(wrong, SyntaxError) and wrong.filename and self._is_own(wrong.filename):
            return wrong.lineno
        line = None
        while trace is not None:
            if self._is_own(trace.tb_frame.f_code.co_filename):
                line = trace.tb_lineno
            trace = trace.tb_next
        return line

    def _is_own(self, file: str) -> bool:
        return Path(file).resolve() == self.path.resolve()
