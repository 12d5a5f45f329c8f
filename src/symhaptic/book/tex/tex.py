"""LaTeX from templates, and PDF from LaTeX where a TeX is installed."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from symhaptic.book.processes import run
from symhaptic.notation.extras import missing

NEEDS = "a report needs jinja2 and matplotlib: pip install 'symhaptic[report]'"
NO_TEX = (
    "no latexmk and pdflatex found; on Debian: "
    "apt-get install latexmk texlive-latex-recommended lmodern"
)
BAD = r"^(?:Overfull \\[hv]box.*|LaTeX Warning: Reference.*|.*has been referenced but does not.*)$"
"""Lines of TeX's log about what a reader would find: a line or page too long, a link to nowhere."""

TITLE = "Passivity and stability of haptic walls, derived and verified"

_SAFE = ("-interaction=nonstopmode", "-halt-on-error", "-latexoption=-no-shell-escape")
"""TeX asks nothing, stops at an error, and starts no other program."""

_TOLD = 20
"""Bad lines that a message lists."""


class ReportError(RuntimeError):
    """The report cannot be written; the message is one line."""


def filled(name: str, **words: Any) -> str:
    """A template with its places filled."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("symhaptic.book.tex"),
        undefined=StrictUndefined,
        autoescape=False,
        keep_trailing_newline=True,
        variable_start_string="<<",
        variable_end_string=">>",
        block_start_string="<%",
        block_end_string="%>",
        comment_start_string="<#",
        comment_end_string="#>",
    )
    return environment.get_template(name).render(title=TITLE, **words)


def can() -> bool:
    """Whether what writes a report is installed."""
    return not missing("jinja2", "matplotlib")


def has_tex() -> bool:
    """Whether latexmk and pdflatex are installed."""
    return shutil.which("latexmk") is not None and shutil.which("pdflatex") is not None


def typeset(folder: Path, say: Callable[[str], None], name: str = "book") -> None:
    """Run latexmk on a document; overfull lines and undefined references are errors."""
    say(f"typesetting {name}.pdf")
    done = run(
        ["latexmk", "-pdf", *_SAFE, f"{name}.tex"],
        cwd=folder,
        errors="replace",
        env=os.environ | {"SOURCE_DATE_EPOCH": "0", "max_print_line": "1000"},
    )
    log_file = folder / f"{name}.log"
    log = log_file.read_text(encoding="utf-8", errors="replace") if log_file.is_file() else ""
    if done.returncode != 0:
        first = next((line for line in log.splitlines() if line.startswith("!")), "no message")
        files = re.findall(r"\(\./([\w.-]+)\.tex", log)
        raise ReportError(f"latexmk failed in {files[-1] if files else name}.tex: {first}")
    bad = [(m.group(), log[: m.start()]) for m in re.finditer(BAD, log, re.MULTILINE)]
    if bad:
        opened = [re.findall(r"\(\./([\w.-]+)\.tex", before)[-1:] for _, before in bad]
        lines = [f"{' '.join(o)}.tex: {line}" for o, (line, _) in zip(opened, bad, strict=True)]
        raise ReportError(f"{len(bad)} bad lines in the report: {'; '.join(lines[:_TOLD])}")
