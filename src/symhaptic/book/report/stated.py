r"""A theorem as a textbook states it: conditions in a line, and formulas that stand by themselves.

What has quantifiers within quantifiers, or too many lines, is for a program to read: of this a page
has the words and the number, and the site and the ledger have the proposition.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from sympy import Expr

from symhaptic.book.report.breaking import LINE, pieces, rows_of, width
from symhaptic.notation.latex import latex
from symhaptic.notation.proposition import (
    And,
    Exists,
    ForAll,
    Iff,
    Implies,
    Not,
    Or,
    Predicate,
    Proposition,
    Relation,
    conjuncts,
    implied,
)
from symhaptic.notation.written import SIGNS, TURNED, parted, told_apart, upper, written
from symhaptic.proof.theorems.kernel import Theorem

SHORT = 14.0
"""Width in em up to which a condition stands in a line of text."""

MOST = 9
"""Lines that a theorem may have on a page."""

_JOINED: dict[type[Proposition], str] = {Iff: r"\Longleftrightarrow", Implies: r"\Longrightarrow"}
_SOME: dict[type[Proposition], str] = {ForAll: "all", Exists: "some"}
_OR = r"\quad\text{or}\quad "


@dataclass(frozen=True)
class Stated:
    """Short conditions as LaTeX, and the rows of the long ones and of the conclusion."""

    given: tuple[str, ...]
    let: tuple[str, ...]
    then: tuple[str, ...]


def stated(theorem: Theorem) -> Stated | None:
    """What a theorem says; None where only a program would read it."""
    hypotheses = sorted(theorem.hypotheses, key=written)
    given, then = _peeled(told_apart(implied(hypotheses, theorem.conclusion)))
    if not all(map(_readable, (*given, *then))):
        return None
    short, long = list[str](), list[Proposition]()
    for chain in _chains(given):
        shown = _line(chain, inline=True)
        if width(shown) <= SHORT and all(map(_plain, chain)):
            short.append(shown)
        else:
            long += chain
    let, rows = _rows(long), _rows(then)
    if len(let) + len(rows) > MOST or any(width(row) > LINE + 3 for row in (*let, *rows)):
        return None
    return Stated(tuple(sorted(short, key=len)), tuple(let), tuple(rows))


def _peeled(claim: Proposition) -> tuple[list[Proposition], tuple[Proposition, ...]]:
    """Conditions and conclusions; what is free holds for all values, as what is bound outside."""
    given = list[Proposition]()
    while True:
        if isinstance(claim, Implies):
            given += conjuncts(claim.of[0])
            claim = claim.of[1]
        elif isinstance(claim, ForAll) and not any(p.free & set(claim.over) for p in given):
            claim = claim.body
        else:
            return given, conjuncts(claim)


def _plain(claim: Proposition) -> bool:
    """Whether no quantifier and no arrow stands in it."""
    if isinstance(claim, (Relation, Predicate)):
        return True
    return isinstance(claim, (And, Or, Not)) and all(map(_plain, claim.parts))


def _readable(claim: Proposition) -> bool:
    """Whether it is plain, quantified once, or two of these with an arrow between them."""
    if isinstance(claim, (Iff, Implies)):
        return all(_plain(p) or (_once(p)) for p in claim.of)
    return _plain(claim) or _once(claim)


def _once(claim: Proposition) -> bool:
    if isinstance(claim, (ForAll, Exists)):
        _, rest, body = parted(claim)
        return not rest and _plain(body)
    return isinstance(claim, And) and all(_plain(p) or _once(p) for p in claim.of)


def _chains(claims: Sequence[Proposition]) -> Iterator[tuple[Proposition, ...]]:
    """Propositions one by one, two bounds of one term together."""
    left = list(claims)
    while left:
        claim = left.pop(0)
        above = upper(claim, left)
        if above is None:
            yield (claim,)
        else:
            left.remove(above)
            yield claim, above


# -- in one line ----------------------------------------------------------------------


def _sides(chain: Sequence[Proposition]) -> list[tuple[Expr | str, str, Expr]]:
    """A relation, or two bounds of a term, as lines of which the second has no left side."""
    first, *rest = (one for one in chain if isinstance(one, Relation))
    if not rest and not first.left.free_symbols and first.right.free_symbols:
        return [(first.right, TURNED[first.sign], first.left)]
    return [
        (first.left, SIGNS[first.sign], first.right),
        *(("", SIGNS[one.sign], one.right) for one in rest),
    ]


def _line(chain: Sequence[Proposition], inline: bool = False) -> str:
    """All in one line."""
    (claim, *_) = chain
    if isinstance(claim, Relation):
        (left, sign, right), *rest = _sides(chain)
        shown = f"{latex(left, inline)} {sign} {latex(right, inline)}"
        return shown + "".join(f" {sign} {latex(right, inline)}" for _, sign, right in rest)
    if isinstance(claim, (Iff, Implies)):
        return rf"\quad {_JOINED[type(claim)]}\quad ".join(_inside([p]) for p in claim.of)
    if isinstance(claim, And):
        return _beside(list(_chains(conjuncts(claim))), r",\quad ")
    if isinstance(claim, Or):
        return _beside([(p,) for p in claim.of], _OR) or r"\text{false}"
    if isinstance(claim, (ForAll, Exists)):
        head, _, body = parted(claim)
        return rf"{_inside([body])}\quad\text{{for {_SOME[type(claim)]}}}\ {head}"
    return written(claim, inline)


def _inside(chain: Sequence[Proposition]) -> str:
    """The same beside something else: in brackets where it would not be clear how far it goes."""
    line = _line(chain)
    return line if isinstance(chain[0], (Relation, Predicate, Not)) else rf"\left({line}\right)"


def _beside(chains: Sequence[Sequence[Proposition]], mark: str) -> str:
    return _line(chains[0]) if len(chains) == 1 else mark.join(map(_inside, chains))


# -- in several -----------------------------------------------------------------------


def _rows(claims: Sequence[Proposition]) -> list[str]:
    """Rows of a display, aligned at their signs where all are relations."""
    chains = list(_chains(claims))
    together = _beside(chains, r",\qquad ") if chains else ""
    if width(together) <= LINE and len(chains) < 4:
        return [f"&{together}"] if chains else []
    if all(len(chain) == 1 and isinstance(chain[0], Relation) for chain in chains):
        return rows_of(line for chain in chains for line in _sides(chain))
    return [row for chain in chains for row in _broken(chain)]


def _broken(chain: Sequence[Proposition]) -> list[str]:
    """A proposition in as many rows as it takes."""
    line = _line(chain)
    (claim, *_) = chain
    if width(line) <= LINE:
        return [f"&{line}"]
    if isinstance(claim, Relation):
        (left, *_), *_ = sides = _sides(chain)
        assert isinstance(left, Expr)
        first, *rest = pieces(left, LINE)
        rows = [f"&{first}", *(rf"&\quad {part}" for part in rest)]
        for _, sign, right in sides:
            first, *rest = pieces(right, LINE - 3)
            rows += [rf"&\quad {sign} {first}", *(rf"&\qquad {part}" for part in rest)]
        return rows
    if isinstance(claim, (Iff, Implies)):
        before, after = (_held([p]) for p in claim.of)
        return [*before, *_led(rf"{_JOINED[type(claim)]}\quad ", after)]
    if isinstance(claim, And):
        return [row for one in _chains(conjuncts(claim)) for row in _broken(one)]
    if isinstance(claim, Or):
        parts = [_held([p]) for p in claim.of]
        return [*parts[0], *(row for part in parts[1:] for row in _led(_OR, part))]
    if isinstance(claim, (ForAll, Exists)):
        head, _, body = parted(claim)
        return [*_held([body]), rf"&\quad\text{{for {_SOME[type(claim)]}}}\ {head}"]
    return [f"&{line}"]


def _held(chain: Sequence[Proposition]) -> list[str]:
    """The same beside something else."""
    rows = _broken(chain)
    if isinstance(chain[0], (Relation, Predicate, Not)):
        return rows
    if len(rows) == 1:
        return [rf"&\left({rows[0][1:]}\right)"]
    return [*_led(r"\Bigl(", rows[:-1]), rf"{rows[-1]}\Bigr)"]


def _led(mark: str, rows: Sequence[str]) -> list[str]:
    """Rows with a mark before the first."""
    return [f"&{mark}{rows[0][1:]}", *rows[1:]]
