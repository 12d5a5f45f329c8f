"""Finds the derivations and runs them: each file is one chapter, in the order of their names."""

from __future__ import annotations

import ast
import importlib.util
import sys
import time
import traceback
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType, TracebackType

from symhaptic.chapter import Page
from symhaptic.proof.recheck import confirm


class BadChapter(ValueError):
    """A derivation that cannot be run, or that proves nothing; the message is one line."""


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
        return f"derivations/{self.path.name}" if self.path.parent == folder() else self.path.name


def _beside(name: str) -> Path:
    """A file or folder of the project: inside an installed package, or in the repository."""
    package = Path(__file__).parent
    inside = package / name
    return inside if inside.exists() else package.parents[1] / name


def folder() -> Path:
    """The folder of the paper's derivations."""
    return _beside("derivations")


def expected_ledger() -> Path:
    """The committed ledger that `symhaptic verify` compares with."""
    inside = Path(__file__).parent / "ledger.json"
    return inside if inside.exists() else _beside("reports") / "ledger.json"


def expected_mutants() -> Path:
    """The committed outcome of `symhaptic mutants`."""
    return _beside("reports") / "mutants.json"


def expected_bench() -> Path:
    """The committed measurement of `symhaptic bench`, which the report shows."""
    return _beside("reports") / "bench.json"


def shipped() -> list[Path]:
    """The paper's derivations, in the order of the paper."""
    return sorted(folder().glob("s*.py"))


def run(path: Path) -> Chapter:
    """Run one derivation.

    Raises :class:`BadChapter` with one line that names the file and what is wrong with it.
    """
    begin = time.perf_counter()
    module = _load(path)
    derive = getattr(module, "derive", None)
    if not callable(derive):
        raise BadChapter(f"{path}: has no function derive(page)")
    title, _, introduction = (module.__doc__ or "").strip().partition("\n")
    if not title:
        raise BadChapter(f"{path}: has no docstring; its first line is the chapter's title")
    page = Page(path.stem)
    with _SomebodyElses(path):
        derive(page)
        confirm(page.certificates)
    if not any(block.verdict == "proved" for block in page.blocks) and not page.settled:
        raise BadChapter(f"{path}: proves nothing; a chapter has at least one step or verdict")
    return Chapter(path, title, introduction.strip(), page, time.perf_counter() - begin)


def looked_at(path: Path) -> Path:
    """The path itself; raises :class:`BadChapter` for a file that cannot be a chapter.

    Nothing of it is run: it must parse, have a docstring and define ``derive``.
    """
    try:
        tree = ast.parse(found(path).read_text(encoding="utf-8"), str(path))
    except SyntaxError as wrong:
        raise BadChapter(f"{path}:{wrong.lineno}: SyntaxError: {wrong.msg}") from None
    except UnicodeDecodeError as wrong:
        raise BadChapter(f"{path}: not a text in UTF-8 ({wrong.reason})") from None
    names = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    names |= {
        a.asname or a.name for n in tree.body if isinstance(n, ast.ImportFrom) for a in n.names
    }
    names |= {
        t.id
        for n in tree.body
        if isinstance(n, ast.Assign)
        for t in n.targets
        if isinstance(t, ast.Name)
    }
    if "derive" not in names:
        raise BadChapter(f"{path}: has no function derive(page)")
    if not (ast.get_docstring(tree) or "").strip():
        raise BadChapter(f"{path}: has no docstring; its first line is the chapter's title")
    return path


def found(path: Path) -> Path:
    """The path itself; raises :class:`BadChapter` where no file is."""
    if not path.is_file():
        what = "is a folder" if path.is_dir() else "no such file"
        raise BadChapter(f"{path}: {what}; a derivation is a Python file")
    return path


def _load(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"derivation_{path.stem}", found(path))
    if spec is None or spec.loader is None:
        raise BadChapter(f"{path}: not a Python file; a derivation ends in .py")
    module = importlib.util.module_from_spec(spec)
    with _SomebodyElses(path):
        spec.loader.exec_module(module)
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
        if kind is None or not issubclass(kind, (Exception, SystemExit)):
            return
        line = " ".join(str(wrong).split()) or "no message"
        own = kind.__module__.startswith("symhaptic")
        at = [
            n for frame, n in traceback.walk_tb(trace) if frame.f_code.co_filename == str(self.path)
        ]
        place = f"{self.path}:{at[-1]}" if at else str(self.path)
        raise BadChapter(f"{place}: {line if own else f'{kind.__name__}: {line}'}") from wrong
