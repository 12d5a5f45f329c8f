"""What a printed relation or predicate says to Rocq, compared with what it says to our kernel.

Rocq's functions are total: 1/0 is 0, and so is the real square root of a negative number.  The text
of an atom is read back with these values (``reading``) and compared with the atom at a few points.
A difference refutes the text.  Agreement proves nothing, and nothing rests on it.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, TypeAlias

from flint import acb, arb, ctx
from sympy import Expr, Symbol

from symhaptic.notation.proposition import Exists, ForAll, Predicate, Proposition, Relation
from symhaptic.notation.terms import is_complex
from symhaptic.proof.ball import ball
from symhaptic.rocq.propositions import SIGNS, text
from symhaptic.rocq.reading import Compared, Misread, Named, Undecided, read
from symhaptic.rocq.terms import Names

_BITS = 256
_POINTS, _TRIES = 4, 200
"""Points at which an atom is compared, and points that are tried to find these."""
_ALIKE = arb(2) ** -100
"""Values that differ by this share of their size are equal; round-off of 256 bits is less."""

Point: TypeAlias = Mapping[Symbol, acb]


def differs(claims: Iterable[Proposition], given: Iterable[Proposition] = ()) -> str | None:
    """Where a text of these propositions says something else than they do, or None.

    Only points are tried at which the inequalities that are ``given`` hold.
    """
    bounds = tuple(g for g in given if isinstance(g, Relation) and g.sign != "=")
    for claim in claims:
        names = Names()
        with names.bound(*sorted(claim.free, key=str)):
            for atom in _atoms(claim, names):
                if found := _different(atom, bounds):
                    return found
    return None


@dataclass(frozen=True)
class _Atom:
    """A relation or a predicate, its text, and the names of its free symbols there."""

    claim: Relation | Predicate
    said: str
    names: frozenset[tuple[Symbol, str]]


def _atoms(claim: Proposition, names: Names) -> Iterator[_Atom]:
    if isinstance(claim, (Relation, Predicate)):
        yield _Atom(claim, text(claim, names), frozenset((s, names[s]) for s in claim.free))
    elif isinstance(claim, (ForAll, Exists)):
        with names.bound(*claim.over):
            yield from _atoms(claim.body, names)
    else:
        for part in claim.parts:
            yield from _atoms(part, names)


@cache
def _different(atom: _Atom, given: tuple[Relation, ...]) -> str | None:
    before, ctx.prec = ctx.prec, _BITS
    try:
        for point in _points(atom, given):
            if not _agree(atom, point):
                names = sorted((name, point[symbol]) for symbol, name in atom.names)
                there = ", ".join(f"{name} = {at.str(6, radius=False)}" for name, at in names)
                return f"the text {atom.said[:60]!r} says something else{there and f' at {there}'}"
    finally:
        ctx.prec = before
    return None


def _points(atom: _Atom, given: tuple[Relation, ...]) -> Iterator[Point]:
    """Points at which nothing is false that is given."""
    symbols = {s for s, _ in atom.names}.union(*(g.free for g in given))
    chance = random.Random(0)  # the same points from run to run
    found = 0
    for _ in range(_TRIES if symbols else 1):
        point = {s: _drawn(s, chance) for s in sorted(symbols, key=str)}
        if all(_truth(g, point) is not False for g in given):
            yield point
            found += 1
            if found == _POINTS:
                return


def _drawn(symbol: Symbol, chance: random.Random) -> acb:
    size = arb(chance.randint(1, 3000)) / 997
    if is_complex(symbol):
        return acb(size, arb(chance.randint(-3000, 3000)) / 997)
    return acb(size if chance.random() < 0.5 else -size)


def _agree(atom: _Atom, point: Point) -> bool:
    """Whether text and atom say the same there; they do where the atom has no value."""
    values = {name: point[s] for s, name in atom.names}
    try:
        conjuncts = read(atom.said)
        if isinstance(atom.claim, Relation):
            return _relation_agrees(atom.claim, conjuncts, point, values)
        return _predicate_agrees(atom.claim, conjuncts, point, values)
    except Undecided:
        return True
    except Misread:
        return False


def _relation_agrees(claim: Relation, conjuncts: list[Any], point: Point, values: Any) -> bool:
    ours = [_value(t, point) for t in claim.terms]
    *guards, said = conjuncts
    theirs = [said.left(values), said.right(values)]
    guarded = all(_holds(g, values) for g in guards)
    if guarded and not all(map(_alike, ours, theirs)):
        return False
    return (guarded and _compared(theirs, said.sign)) == _compared(ours, SIGNS[claim.sign])


def _predicate_agrees(claim: Predicate, conjuncts: list[Any], point: Point, values: Any) -> bool:
    *guards, said = conjuncts
    assert isinstance(said, Named)
    terms, theirs = list(claim.of), list(said.terms)
    if len(terms) != len(theirs):
        return False
    pairs = []
    if claim.over:
        [variable], body, text_of_body = claim.over, terms.pop(0), theirs.pop(0)
        for sample in _samples(claim, point):
            ours = _value(body, {**point, variable: sample})
            pairs.append((ours, text_of_body({**values, said.variable: sample})))
    ours_ = [_value(t, point) for t in terms]
    pairs += zip(ours_, (t(values) for t in theirs), strict=True)
    return all(_holds(g, values) for g in guards) and all(_alike(*pair) for pair in pairs)


def _samples(claim: Predicate, point: Point) -> Iterator[acb]:
    """Values of a bound variable: in the interval, near the place of a limit, or in the plane."""
    if claim.name == "increasing":
        low, high = (_value(t, point) for t in claim.of[1:])
        yield from (low + (high - low) * share / 7 for share in (2, 5))
    elif claim.name == "limit":
        yield from (_value(claim.of[1], point) + sign / acb(1009) for sign in (1, -1))
    else:
        yield from (acb(arb(3) / 5, arb(2) / 7), acb(-arb(8) / 7, arb(1) / 3))


def _value(term: Expr, point: Point) -> acb:
    """What our kernel means by a term; raises :class:`Undecided` where it has no value."""
    value = ball(term, dict(point), _BITS)
    if not value.is_finite() or value.rad() > _ALIKE * (1 + abs(value).mid()):
        raise Undecided("no value")
    return value


def _truth(claim: Relation, point: Point) -> bool | None:
    try:
        return _compared([_value(t, point) for t in claim.terms], SIGNS[claim.sign])
    except Undecided:
        return None


def _holds(guard: Any, values: Mapping[str, acb]) -> bool:
    assert isinstance(guard, Compared)
    return _compared([guard.left(values), guard.right(values)], guard.sign)


def _alike(one: acb, other: acb) -> bool:
    return bool(abs(one - other) <= _ALIKE * (1 + abs(one)) or (one - other).contains(0))


def _compared(sides: list[acb], sign: str) -> bool:
    """Whether a relation holds between two numbers; an order holds between real ones only."""
    difference = sides[1] - sides[0]
    equal = bool(difference.contains(0))
    if sign in ("=", "<>"):
        return equal == (sign == "=")
    if not all(side.imag.contains(0) for side in sides):
        return False
    if equal and not difference.real.is_zero():
        raise Undecided("two sides that are nearly equal")
    return bool(difference.real > 0 or (sign == "<=" and equal))
