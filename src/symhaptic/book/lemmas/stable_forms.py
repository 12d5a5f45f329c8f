"""What is computed is what is derived: forms in entire functions beside the formulas of the book.

A block has names, each defined by an equation, and equations between a computed formula and a
derived one in these names; all is proved by normal forms, where nothing is divided by zero.
"""

from dataclasses import dataclass
from functools import cached_property

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.renaming import definitions, explicit, renamed

Named = tuple[tuple[Symbol, Expr], ...]


@dataclass(frozen=True, eq=False)
class Block:
    """Equations between what is computed and what is derived, for all values of some symbols."""

    free: tuple[Symbol, ...]
    where: tuple[Proposition, ...]
    """Where nothing is divided by zero."""
    names: Named
    """What a name stands for; it may hold names before it."""
    pairs: tuple[Proposition, ...]
    """Computed on the left, derived on the right; or the limit that something computed has."""
    point: Mapping[Symbol, Expr]
    """Values of the free symbols at which all this has values."""
    divisors: Callable[[], Iterable[Theorem]] = tuple
    """What is divided by is not zero."""

    @property
    def defined(self) -> tuple[Relation, ...]:
        """The names' equations."""
        return tuple(Relation(name, "=", meaning) for name, meaning in self.names)

    @property
    def given(self) -> tuple[Proposition, ...]:
        """All hypotheses."""
        return (*self.where, *self.defined)

    @property
    def over(self) -> tuple[Symbol, ...]:
        """All symbols."""
        return (*self.free, *(name for name, _ in self.names))

    def says(self) -> Proposition:
        """The claim."""
        return ForAll(self.over, implied(self.given, both(self.pairs)))

    def written_out(self) -> tuple[Proposition, ...]:
        """The equations without the names."""
        names = definitions(self.defined)
        return tuple(explicit(pair, *names) for pair in self.pairs)

    def example(self) -> Case:
        """A point at which all hypotheses hold."""
        values = dict(self.point)
        for name, meaning in self.names:
            values[name] = meaning.xreplace(values)
        return example(values, self.given)

    def theorem(self) -> Theorem:
        """The claim as a theorem."""
        found = [self._pair(pair) for pair in self.pairs]
        whole = found[0] if len(found) == 1 else conj(*found)
        shown = add_assum(closed(whole, *self.divisors()), *self.given)
        return for_all(self.over, self.given, shown)

    def _pair(self, pair: Proposition) -> Theorem:
        """One of the equations, by the names that are in it."""
        met, used = set(pair.free), []
        for name, meaning in reversed(self.names):
            if name in met:
                met |= meaning.free_symbols
                used.append(Relation(name, "=", meaning))
        names = definitions(reversed(used))
        return renamed(_shown(explicit(pair, *names)), pair, *names)


class Later:
    """A block that is made when it is first asked for."""

    def __init__(self, make: Callable[[], Block]) -> None:
        self._make = make

    @cached_property
    def block(self) -> Block:
        """The block, which is kept."""
        return self._make()

    def derive(self) -> Theorem:
        """Its claim as a theorem, which is kept."""
        return self._theorem

    @cached_property
    def _theorem(self) -> Theorem:
        return self.block.theorem()


def _shown(claim: Proposition) -> Theorem:
    if isinstance(claim, Relation):
        return identity(claim.left, claim.right)
    assert isinstance(claim, Predicate)
    return tends(claim.of[0], claim.over[0], *claim.of[1:])


def nonzero(expr: Expr, *known: Theorem, times: Expr | None = None) -> Theorem:
    """expr != 0, where expr * times is the product of what is known not to be zero."""
    product = sp.Mul(*(_side(k) for k in known))
    other = sp.cancel(product / expr) if times is None else times
    return factor(expr, combined(Relation(product, "!=", S.Zero), list(known)), -other)


def _side(theorem: Theorem) -> Expr:
    """What a theorem says is not zero."""
    claim = theorem.conclusion
    assert isinstance(claim, Relation)
    return claim.right - claim.left if claim.sign == "<" else claim.left - claim.right
