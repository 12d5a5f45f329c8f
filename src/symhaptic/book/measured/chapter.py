"""The committed measurement as a page of the book: speed against error."""

from __future__ import annotations

import re
from pathlib import Path

from docutils.nodes import Node, section

from symhaptic.book.measured import record as records
from symhaptic.book.measured.says import sentences
from symhaptic.book.measured.tables import Table, about, tables
from symhaptic.book.report import tree


def measurement(path: Path) -> section | None:
    """The page; None where nothing is committed.

    Raises :class:`symhaptic.book.measured.record.BadRecord` for a file that is no record.
    """
    if not path.is_file():
        return None
    record = records.read(path)
    every = map(_table, tables(record))
    calls, judges, floats, digits, boundary, times, wrong, models, peers = every
    says = {name: typeset(text) for name, text in sentences(record).items()}
    return tree.section(
        "Speed against error",
        _prose(
            "Everything before this section is proved. This section is measured: the cost of each "
            "formula, the number of correct digits, and the cost and the errors of alternatives. "
            "Times depend on the machine and its load; compare only times of one table. "
            r"\texttt{symhaptic bench} repeats the measurement."
        ),
        tree.paragraph(about(record), " ", record["method"]),
        *calls,
        *judges,
        tree.rubric("Formulas"),
        _prose(
            r"As published, (14) and (18) are $0/0$ for $\gamma=0$ and at critical damping. Inside "
            r"the paper's range (23), where $\gamma$ and $\delta$ are small, their differences "
            "lose digits. A higher precision reduces this loss, but not the $0/0$. "
            f"{says['formulas']} In single precision an angle has no correct digits after a delay "
            r"of many thousand periods. \emph{Package} is the package's code for arrays, "
            "including its checks of the arguments: kernels that the exporter generated. "
            r"\emph{C} is the exported code."
        ),
        *floats,
        *digits,
        tree.figure("bench_functions", "", tree.words(
            "Worst error over time per evaluation; a bar ends at the median error. Dots are double "
            "precision, triangles single precision, and diamonds 30 and 50 digits. Squares are "
            "balls of 53 and 128 bits, whose error is their radius. Grey lines are the last "
            "places of these precisions. An error larger than the largest term is drawn at the "
            "top, and an error below $10^{-55}$ at the bottom; NaN is the share of points without "
            "a number. Derived forms are shown in double precision only."
        )),
        tree.rubric("The boundary of stability"),
        _prose(
            "The cost of the paper's grid and of bisections along rays grows with each digit and "
            "each period of delay. The explicit form is one evaluation for every delay. "
            + says["boundary"]
        ),
        tree.figure("bench_boundary", "", tree.words(
            "The largest distance of a computed point from the exact curve, over the time per "
            "point. Along each line the threshold of the bisection decreases."
        )),
        *boundary,
        tree.rubric("Stable or not"),
        _prose(
            "The time to count the roots outside the unit circle does not depend on the delay. The "
            "steps of an eigenvalue solver grow with the cube of the delay, and those of Jury's "
            "table with its square. Close to the boundary, rounding errors decide the verdicts "
            "of these two methods, and the count gives no verdict. With (14) as published there "
            "is no verdict without stiffness or at critical damping. "
            f"{says['stability']}"
        ),
        tree.figure("bench_stability", "", tree.words(
            "Left: time per wall over the delay. Right: wrong verdicts over the relative distance "
            "of a wall from the boundary, for the walls of all delays."
        )),
        *times,
        *wrong,
        tree.rubric("Simpler models"),
        _prose(says["models"]),
        tree.figure("bench_models", "", tree.words(
            "Median error of the largest stable stiffness over time per limit, in the paper's "
            "ranges (23). The virtual damping is a quarter of that of the stiffest wall."
        )),
        *models,
        tree.rubric("Other tools"),
        _prose(
            "Each tool is called as a user would call it. Tools without arrays are called once for "
            "each point. "
            + says["peers"]
        ),
        *peers,
        to="page",
        at="bench",
        code="bench.json",
    )  # fmt: skip


def _prose(text: str) -> Node:
    return tree.paragraph(tree.words(text))


def _table(table: Table) -> list[Node]:
    """What a table says, and the table."""
    rows = [[tree.words(typeset(cell)) for cell in row] for row in (table.head, *table.rows)]
    columns = "l" * table.words + "r" * (len(table.head) - table.words)
    says = tree.paragraph(tree.emphasis(f"{table.title}."), " ", tree.words(table.says))
    return [says, tree.table("numbers", rows, columns=columns)]


_NUMBER = re.compile(
    r"\bd = (?P<delay>\d+)"
    r"|(?<![\w.])(?P<sign>-?)(?P<digits>\d+(?:\.\d+)?)(?:e(?P<power>-?\d+))?"
    r"(?: (?P<unit>ns|us|ms|s)\b)?"
)


def typeset(text: str) -> str:
    r"""Plain words as prose, their numbers, powers of ten and units typeset.

    >>> typeset("1.2e-7 to 3.5 us, and 20 per cent at d = 8"), typeset("d"), typeset("-")
    ('$1.2\\cdot10^{-7}$ to 3.5\\,$\\mu$s, and 20 per cent at $d = 8$', '$d$', '–')
    """
    return {"d": "$d$", "-": "–"}.get(text) or _NUMBER.sub(_typeset, text)


def _typeset(found: re.Match[str]) -> str:
    mu = r"$\mu$s"
    sign, digits, power, unit = found["sign"], found["digits"], found["power"], found["unit"]
    if found["delay"]:
        return f"${found[0]}$"
    shown = sign + digits
    if power:
        shown = f"{sign}10^{{{power}}}" if digits == "1" else rf"{shown}\cdot10^{{{power}}}"
    if sign or power:
        shown = f"${shown}$"
    return shown + (rf"\,{unit.replace('us', mu)}" if unit else "")
