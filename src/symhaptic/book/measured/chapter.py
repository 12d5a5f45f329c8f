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
            "All before this section is proved; what follows is measured: what a formula costs, "
            "how many digits it gives, and what another way costs or loses. Times depend on the "
            "machine and on what else it does; compare those of one table with each other. "
            r"\texttt{symhaptic bench} measures again."
        ),
        tree.paragraph(about(record), " ", record["method"]),
        *calls,
        *judges,
        tree.rubric("Formulas"),
        _prose(
            r"As printed, (14) and (18) are $0/0$ for $\gamma=0$ and at critical damping, and "
            r"inside the paper's own range (23), where $\gamma$ and $\delta$ are small, their "
            f"differences lose digits; more digits move the loss and leave the $0/0$. "
            f"{says['formulas']} In single precision an angle behind a delay of many thousand "
            r"periods has no digits to keep. \emph{Package} is what the package itself computes "
            "with on arrays, its checks of the arguments included: kernels that the exporter "
            r"wrote. \emph{C} is the exported code."
        ),
        *floats,
        *digits,
        tree.figure("bench_functions", "", tree.words(
            "Worst error over time per evaluation, with a bar down to the median: dots are double "
            "precision, triangles single, diamonds 30 and 50 digits, squares balls of 53 and 128 "
            "bits, whose error is their radius. Grey lines are the last places of these "
            "precisions. An error larger than the largest term is drawn at the top, one below "
            "$10^{-55}$ at the bottom; NaN is the share of points without a number. Derived forms "
            "are shown in double precision only."
        )),
        tree.rubric("The boundary of stability"),
        _prose(
            "The paper's grid and bisections along rays pay for each digit and for each period of "
            "delay; the explicit form is one evaluation, whatever the delay. " + says["boundary"]
        ),
        tree.figure("bench_boundary", "", tree.words(
            "Largest distance of points from the exact curve over time per point; along a line "
            "the threshold of the bisection gets smaller."
        )),
        *boundary,
        tree.rubric("Stable or not"),
        _prose(
            "The count of the roots outside the unit circle does not see how long the delay is; "
            "of eigenvalues the steps grow with the cube of the delay, and of Jury's table with "
            "its square. Close to the boundary these two judge by their rounding, where the count "
            "gives no verdict. With (14) as printed there is none without stiffness or at "
            f"critical damping. {says['stability']}"
        ),
        tree.figure("bench_stability", "", tree.words(
            "Left: time per wall over the delay. Right: wrong verdicts over the relative distance "
            "of a wall from the boundary, walls of all delays together."
        )),
        *times,
        *wrong,
        tree.rubric("Simpler models"),
        _prose(says["models"]),
        tree.figure("bench_models", "", tree.words(
            "Median error of the largest stable stiffness over time per limit, with a quarter of "
            "the virtual damping of the stiffest wall, over the paper's ranges (23)."
        )),
        *models,
        tree.rubric("Other tools"),
        _prose(
            "Each question as users ask it; tools without arrays take one after the other. "
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
