"""What rounding costs, as goals for Gappa: of results that sums, products and quotients lead to.

A goal is made of the very lines that the C source has, read as C reads them: operators of one rank
from the left.  Each operation is rounded once, u = 2^-53 of its result at most; how that adds up is
counted here, and proved by Gappa, whose proof Coq checks.  What a function of a library or another
routine gives is taken as it is: the bound is of what is done with it.
"""

from __future__ import annotations

import ast
import math
import re
from dataclasses import dataclass, replace
from fractions import Fraction

import sympy as sp

from symhaptic.export.blocks import Assign, Block, Choice, Return
from symhaptic.export.branches import guarded
from symhaptic.export.gappa_script import FORMATS, NotStraight, Script
from symhaptic.export.precision import Precision
from symhaptic.export.printing import Language
from symhaptic.export.routine import Routine, Several

MARK = "# Written by `symhaptic export`; do not edit."

AND = " /\\ "


@dataclass(frozen=True)
class Goal:
    """A bound of the rounding errors of one result."""

    name: str
    result: str
    given: tuple[str, ...]
    """Functions whose values are taken as they are."""
    bound: Fraction
    """In units in the last place: of the result, or of the largest term of a sum."""
    text: str
    """For Gappa."""
    whole: bool = False
    """Whether it is of whole delays only."""

    def at(self, bound: Fraction) -> str:
        """The same goal with another bound."""
        return self.text.replace(_dyadic(self.bound, self.bits), _dyadic(bound, self.bits))

    @property
    def file(self) -> str:
        """Where an export has it."""
        return f"rounding/{self.name}.gappa"

    @property
    def bits(self) -> int:
        """Of a float."""
        return next(bits for bits, (name, _, _) in FORMATS.items() if name in self.text)


def goals(routine: Routine, target: Language) -> list[Goal]:
    """What Gappa proves of a public routine: of each result that is rounded on a straight way.

    Of one that chooses between whole delays and others, it is the result of a whole delay.
    """
    found: list[Goal] = []
    try:
        steps, leaves, results, whole = _straight(guarded(routine), routine, target)
    except NotStraight:
        return found
    for (name, _), expr in zip(routine.results, results, strict=True):
        script = Script(target, steps, leaves)
        try:
            goal = _goal(script, f"{routine.name}_{name}", name, expr)
        except NotStraight:
            continue
        found += [replace(goal, whole=whole)] if goal else []
    return found


def _straight(
    block: Block, routine: Routine, target: Language
) -> tuple[dict[str, sp.Expr], dict[str, str], tuple[sp.Basic, ...], bool]:
    """The steps of the one way that is taken inside the domain, by name; what is given; the end.

    Last stands whether it is the way of whole delays.
    """
    steps: dict[str, sp.Expr] = {}
    meant: dict[sp.Basic, sp.Expr] = {}
    whole = False
    leaves = {target.rename(s.name): "" for s in routine.arguments}
    while True:
        for statement in block:
            if isinstance(statement, Assign):
                steps[target.rename(statement.name.name)] = statement.expr
                meant[statement.name] = statement.expr.xreplace(meant)
            elif isinstance(statement, Several):
                for symbol in statement.names:
                    name = target.rename(symbol.name)
                    leaves[name] = name.removesuffix("_of")
            elif isinstance(statement, Return):
                return steps, leaves, statement.results, whole
            elif isinstance(statement, Choice):
                fraction = _is_fraction(statement.condition, meant)
                block = statement.yes if fraction else _inside(statement, routine)
                whole = whole or fraction
            else:
                raise NotStraight(type(statement).__name__)


def _inside(choice: Choice, routine: Routine) -> Block:
    outside = (Return((routine.outside,) * len(routine.results)),)
    if choice.yes == outside:
        return choice.no
    raise NotStraight(str(choice.condition))


def _is_fraction(asked: sp.Basic, meant: dict[sp.Basic, sp.Expr]) -> bool:
    """Whether it is asked if a delay has no fraction of a period, x - floor(x) = 0."""
    if not isinstance(asked, sp.Eq) or asked.rhs != 0:
        return False
    part = asked.lhs.xreplace(meant)
    return any(part == of.args[0] - of for of in part.atoms(sp.floor))


def _goal(script: Script, name: str, result: str, expr: sp.Basic) -> Goal | None:
    """The goal of one result; none where nothing is rounded."""
    node = script.read(expr)
    while isinstance(node, ast.Name) and node.id in script.steps:
        node = script.read(script.steps[node.id])
    try:
        value = script.value(node)
        said, error = f"{value.float_} -/ {value.exact}", value.error
    except NotStraight:
        script = Script(script.target, script.steps, script.leaves)
        said, error = script.sum(node)
    if not error:
        return None
    bits = script.target.precision.bits
    bound = Fraction(math.ceil(100 * error / script.unit), 100)
    limit = _dyadic(bound, bits)
    said += f" in [-{limit},{limit}]" if "-/" in said else f" <= {limit}"
    given = AND.join(script.ranges)
    lines = [
        MARK,
        f"# {name}, rounded as in C, against what it is exactly: for floats of {bits} bits",
        f"@rnd = float<{FORMATS[bits][0]}, ne>;",
        *script.rounded,
        *script.exact,
        f"{{ {given} -> {said} }}",
        *script.hints,
    ]
    taken = tuple(dict.fromkeys(of for of in script.used.values() if of))
    return Goal(name, result, taken, bound, "\n".join(lines) + "\n")


def _dyadic(bound: Fraction, bits: int) -> str:
    """So many units, rounded down, as Gappa writes numbers."""
    return f"{math.floor(bound * 1024)}b-{bits + 10}"


_BY_FIELD = (
    "intros; field; repeat split; first [assumption | intro Z; match goal with "
    "H : _ <> _ |- _ => apply H; rewrite Z; ring end]."
)
"""A quotient rewritten; where a product is not zero, no factor is."""


def for_coq(proof: str) -> str:
    """What `gappa -Bcoq` writes, with each rewriting that it was told of shown, and not assumed."""
    shown = re.sub(
        r"^Hypothesis (\w+ : .*?\.)$", rf"Lemma \1\nProof. {_BY_FIELD} Qed.", proof, flags=re.M
    )
    last = re.findall(r"^Lemma (\w+)", proof, flags=re.M)[-1]
    return f"Require Import Reals.\n{shown.rstrip()}\nPrint Assumptions {last}.\n"


def told(found: list[Goal], precision: Precision) -> list[str]:
    """What a README says of what is proved."""
    if not found:
        return []
    _, low, high = FORMATS[precision.bits]
    lines = ["", "Proved of the rounding of sums, products and quotients, by Gappa and Coq, in"]
    lines += ["units in the last place of the largest term:", ""]
    for goal in found:
        values = f"value{'s' * (len(goal.given) > 1)} of {', '.join(goal.given)}"
        given = f", from the {values} on" if goal.given else ""
        given += ", of whole delays" if goal.whole else ""
        lines.append(f"- {goal.result}: at most {float(goal.bound):g}{given} ({goal.file})")
    return [
        *lines,
        "",
        f"where each result on the way is from 2^{low} to 2^{high} in size, and compiled without",
        "contraction to fma. All else is measured.",
    ]


__all__ = ["Goal", "for_coq", "goals", "told"]
