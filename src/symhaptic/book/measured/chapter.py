"""The committed measurement as a chapter of the book: speed against error."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from symhaptic.book.measured import record as records
from symhaptic.book.measured.says import sentences
from symhaptic.book.measured.tables import Table, about, tables
from symhaptic.book.tex.words import literally, prose

_SHORT = 14
"""Rows of a table that stays on one page."""


def measurement(path: Path) -> dict[str, Any]:
    """What the template of the chapter needs; empty where nothing is committed.

    Raises :class:`symhaptic.book.measured.record.BadRecord` for a file that is no record.
    """
    if not path.is_file():
        return {}
    record = records.read(path)
    names = ("floats", "digits", "boundary", "times", "wrong", "models", "peers")
    shown = {name: table_tex(t) for name, t in zip(names, tables(record), strict=True)}
    says = {name: prose_tex(text) for name, text in sentences(record).items()}
    known = {"about": literally(about(record)), "method": record["method"]}
    return {**known, "tables": shown, "says": says}


def prose_tex(text: str) -> str:
    r"""A sentence for LaTeX, its numbers and units typeset.

    >>> prose_tex("1.2e-7 to 3.5 us, and 20 per cent at d = 8")
    '$1.2\\cdot10^{-7}$ to 3.5\\,$\\mu$s, and 20 per cent at $d = 8$'
    """
    shown = re.sub(r"\bd = (\d+)", r"\0\1\0", text)  # a formula, which keeps its number
    parts = shown.split("\0")
    return "".join(f"$d = {part}$" if i % 2 else cell_tex(part) for i, part in enumerate(parts))


def table_tex(table: Table) -> str:
    """What a table says and the table below, which may be as wide as text and margin together.

    A long one goes on over pages, but not in the midst of a group.
    """
    columns = "l" * table.words + "r" * (len(table.head) - table.words)
    says = f"\\emph{{{table.title}.}}\\enspace {prose(table.says)}"
    head = f"\\toprule {_line(table.head)} \\\\ \\midrule"
    lines = [
        "{\\footnotesize\\setlength{\\LTleft}{0pt}\\setlength{\\LTright}{-37mm}"
        "\\setlength{\\tabcolsep}{4.5pt}\\setlength{\\LTpre}{9pt}\\setlength{\\LTpost}{0pt}",
    ]
    if len(table.rows) > _SHORT:
        over = f"\\multicolumn{{{len(table.head)}}}{{@{{}}l@{{}}}}"
        says = f"\\rlap{{\\parbox[b]{{\\textwidth}}{{{says}\\strut}}}}"
        end = "\\end{longtable}"
        lines += [
            f"\\begin{{longtable}}{{@{{}}{columns}@{{}}}}",
            f"{over}{{{says}}} \\\\[4pt] {head}\\endfirsthead",
            f"{head}\\endhead \\bottomrule\\endfoot",
        ]
    else:
        end = "\\bottomrule\n\\end{tabular}}"
        lines += [
            "\\needspace{16\\baselineskip}",
            f"{says}\\par\\nopagebreak",
            f"\\makebox[\\textwidth][l]{{\\begin{{tabular}}{{@{{}}{columns}@{{}}}}",
            head,
        ]
    for at, row in enumerate(table.rows):
        closes = at + 1 == len(table.rows) or bool(table.rows[at + 1][0])
        apart = "[3pt]" if closes and table.words > 1 else ""
        lines.append(f"{_line(row)} \\\\{'' if closes else '*'}{apart}")
    return "\n".join([*lines, f"{end}\\par}}", "\\medskip", ""])


def _line(cells: tuple[str, ...]) -> str:
    return " & ".join(cell_tex(cell) for cell in cells)


def cell_tex(text: str) -> str:
    r"""Plain text for LaTeX, powers of ten and units typeset.

    >>> cell_tex("1.2e-7"), cell_tex("3.5 us"), cell_tex("d")
    ('$1.2\\cdot10^{-7}$', '3.5\\,$\\mu$s', '$d$')
    """
    if text in ("d", "-"):
        return {"d": "$d$", "-": "--"}[text]
    return _NUMBER.sub(_typeset, literally(text))


_NUMBER = re.compile(r"(?<![\w.])(-?)(\d+(?:\.\d+)?)(?:e(-?\d+))?(?: (ns|us|ms|s)\b)?")


_UNITS = {"us": r"$\mu$s"}


def _typeset(found: re.Match[str]) -> str:
    sign, digits, power, unit = found.groups()
    shown = sign + digits
    if power:
        shown = f"{sign}10^{{{power}}}" if digits == "1" else rf"{shown}\cdot10^{{{power}}}"
    if sign or power:
        shown = f"${shown}$"
    return shown + (rf"\,{_UNITS.get(unit, unit)}" if unit else "")
