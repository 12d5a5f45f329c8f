"""Python with its own numbers, for the package's calls of one wall where no compiler was found."""

from __future__ import annotations

import keyword
from collections.abc import Sequence
from types import MappingProxyType

from symhaptic.export.branches import Block, Choice, guarded
from symhaptic.export.language import Target, called
from symhaptic.export.routine import Library, Routine
from symhaptic.export.statements import Words, worded, wrapped

_WORDS = Words(
    end="",
    when="if {}:",
    otherwise="else:",
    decided="",
    loop="for count_{0} in range({1}):",
    leave=("if {}:", "  break"),
    looped="",
    each=("for {name} in inverse_factorial[slice({first}, {last} - 1, -{step})]:",),
)


class Plain(Target):
    """A module of functions of floats.

    A public function gives None where an argument is outside of its domain.  Dividing by zero and
    overflow raise.  What a device is made of is kept, as most calls are of one device.
    """

    name, title = "plain", "Python"
    choice = "({1} if {0} else {2})"
    words = MappingProxyType({"!": "not ", "&&": "and", "||": "or", "false": "False"})
    keywords = frozenset([*keyword.kwlist, "math", "range", "slice", "inf", "nan", "lru_cache"])
    operations = called(
        "",
        Abs="abs({0})",
        Max="max({0}, {1})",
        Min="min({0}, {1})",
        Infinity="inf",
        NaN="nan",
        TwoProdError="two_prod_error({0}, {1})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.py."""
        table = self.table(library)
        lines = ["# 1/n!", f"inverse_factorial = ({table},)"]
        for helper in library.helpers:
            kept = {s.name for s in helper.arguments} in _DEVICES
            lines += ["", *["@lru_cache(256)"] * kept, *self._written(helper, guarded(helper))]
        for routine in library.public:
            (inside,) = guarded(routine)
            assert isinstance(inside, Choice)
            outside = f"if {self.printing().doprint(inside.condition)}:"
            lines += ["", *self._written(routine, inside.no, [f"  {outside}", "    return None"])]
        return {f"{library.name}.py": "\n".join([_HEAD, *wrapped(lines, " \\"), ""])}

    def _written(self, routine: Routine, block: Block, first: Sequence[str] = ()) -> list[str]:
        args = ", ".join(self.rename(s.name) for s in routine.arguments)
        outs = [f"{self.rename(name)}_out" for name, _ in routine.results]
        body = [line for line in worded(self, block, outs, _WORDS, "  ") if line.strip()]
        head = f"def {self.call(routine.name)}({args}):"
        return [head, *first, *body, f"  return {', '.join(outs)}"]

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """As a tuple."""
        return f"{', '.join(names)} = {function}({args})"


_DEVICES = {"gamma", "delta"}, {"gamma", "delta", "part"}
"""Arguments of helpers whose results are kept."""

_HEAD = '''"""How large is it, of one?  The stable forms as functions of floats, without NumPy."""

from functools import lru_cache
from math import atan2, cos, exp, expm1, floor, inf, nan, sin, sqrt, tan
'''

TARGET = Plain()
