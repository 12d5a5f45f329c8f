"""Points and exact values as a table, for tests in a language that this package does not speak."""

from __future__ import annotations

import flint

from symhaptic.check.compare import points
from symhaptic.check.formulas import Checked


def csv_text(checked: Checked, count: int) -> str:
    """Arguments as hexadecimal floats, then 25 digits of each result; ``nan`` where it has none."""
    lines = [",".join((*checked.ranges, *checked.results))]
    for point in points(checked, count):
        with flint.ctx.workprec(2400):
            exact = [
                str(right) if isinstance(right, bool | None) else right.str(25, radius=False)
                for right in checked.exact(*point)
            ]
        lines.append(",".join((*(v.hex() for v in point), *exact)))
    return "\n".join(lines) + "\n"
