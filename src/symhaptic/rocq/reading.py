"""Texts of relations and predicates read back, with the values that Rocq gives its functions.

Rocq's functions are total: ``1/0`` is 0, ``sqrt`` and ``ln`` of a negative number are 0.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TypeAlias

from flint import acb, arb

from symhaptic.notation.predicates import MEANINGS

At: TypeAlias = Mapping[str, acb]
Term: TypeAlias = Callable[[At], acb]
"""A term as a function of the values of its variables."""


class Undecided(ArithmeticError):
    """The precision does not decide between two cases of a function."""


class Misread(ValueError):
    """A text that is no relation or predicate; the message says where."""


@dataclass(frozen=True)
class Compared:
    """A relation between two terms."""

    left: Term
    sign: str
    right: Term


@dataclass(frozen=True)
class Named:
    """A predicate of terms; of a function of a bound variable, the variable and its body."""

    name: str
    variable: str
    terms: tuple[Term, ...]


Conjunct: TypeAlias = Compared | Named


def read(said: str) -> list[Conjunct]:
    """The conjuncts of a text.

    >>> [type(one).__name__ for one in read("(x <> 0 /\\\\ stable (fun z : C => z - 1/x)%C)")]
    ['Compared', 'Named']
    """
    reader = _Reader(said)
    found = reader.conjuncts()
    reader.skip("")
    return found


_TOKEN = re.compile(r"\s*(%C|:> C|: [CR] =>|/\\|->|<>|<=|[A-Za-z_][\w']*|\d+|[-+*/^()<=:,]|$)")
_SIGNS = ("=", "<>", "<", "<=")
_COMPLEX_ORDER = {"Cless": "<", "Cless_eq": "<="}


class _Reader:
    def __init__(self, said: str) -> None:
        self.tokens: list[str] = []
        place = 0
        while not self.tokens or self.tokens[-1]:
            if not (found := _TOKEN.match(said, place)):
                raise Misread(f"{said[place : place + 30]!r}")
            self.tokens.append(found[1])
            place = found.end()
        self.at = 0

    @property
    def next(self) -> str:
        return self.tokens[self.at]

    def skip(self, *wanted: str) -> str:
        found = self.next
        if found not in wanted:
            raise Misread(f"{found!r} in place of {' or '.join(wanted)}")
        self.at += 1
        return found

    def skipped(self, *wanted: str) -> str:
        return self.skip(*wanted) if self.next in wanted else ""

    # -- propositions

    def conjuncts(self) -> list[Conjunct]:
        found = self.conjunct()
        while self.skipped("/\\"):
            found += self.conjunct()
        return found

    def conjunct(self) -> list[Conjunct]:
        if self.next == "(" and self.tokens[self.at + 1] == "forall":
            self._skip_bracket()
            return []
        if self.next == "(" and self._holds_proposition():
            self.skip("(")
            found = self.conjuncts()
            self.skip(")")
            self.skipped("%C")
            return found
        if self.next in _COMPLEX_ORDER:
            sign = _COMPLEX_ORDER[self.skip(self.next)]
            return [Compared(self.primary(), sign, self.primary())]
        if self.next in PREDICATES:
            return [self.named()]
        left = self.sum()
        sign = self.skip(*_SIGNS)
        right = self.sum()
        self.skipped(":> C")
        return [Compared(left, sign, right)]

    def _skip_bracket(self) -> None:
        """A condition on a bound variable, which stands beside what is said of a function."""
        depth = 0
        while True:
            token = self.skip(self.next)
            depth += (token == "(") - (token == ")")
            if not (token and depth):
                return

    def _holds_proposition(self) -> bool:
        """Whether what the next bracket holds is no term."""
        depth = 0
        for token in self.tokens[self.at :]:
            depth += (token == "(") - (token == ")")
            if depth == 0:
                return False
            if token in _SIGNS or token in PREDICATES or token in _COMPLEX_ORDER:
                return True
        return False

    def named(self) -> Named:
        name, variable = self.skip(self.next), ""
        terms: list[Term] = []
        if self.next == "(" and self.tokens[self.at + 1] == "fun":
            self.skip("(")
            self.skip("fun")
            variable = self.skip(self.next)
            self.skip(": C =>", ": R =>")
            terms.append(self.sum())
            self.skip(")")
            self.skipped("%C")
        while self.next == "(" or self.next.isidentifier():
            terms.append(self.primary())
        return Named(name, variable, tuple(terms))

    # -- terms

    def sum(self) -> Term:
        found = self.product()
        while sign := self.skipped("+", "-"):
            found = _sum(found, self.product(), -1 if sign == "-" else 1)
        return found

    def product(self) -> Term:
        found = self.power()
        while sign := self.skipped("*", "/"):
            found = (_product if sign == "*" else _quotient)(found, self.power())
        return found

    def power(self) -> Term:
        if self.skipped("-"):
            return _opposite(self.power())
        found = self.application()
        return _power(found, int(self.skip(self.next))) if self.skipped("^") else found

    def application(self) -> Term:
        name = self.next
        if name not in FUNCTIONS:
            return self.primary()
        self.skip(name)
        count, function = FUNCTIONS[name]
        return _applied(function, [self.primary() for _ in range(count)])

    def primary(self) -> Term:
        if self.skipped("("):
            found = self.sum()
            self.skip(")")
            self.skipped("%C")
            return found
        token = self.skip(self.next)
        if token.isdigit():
            return _constant(acb(int(token)))
        if token in CONSTANTS:
            return lambda at: CONSTANTS[token]()
        if not token.isidentifier() and not token.rstrip("'").isidentifier():
            raise Misread(f"{token!r} in place of a term")
        return lambda at: at[token]


def _constant(value: acb) -> Term:
    return lambda at: value


def _sum(left: Term, right: Term, sign: int) -> Term:
    return lambda at: left(at) + sign * right(at)


def _product(left: Term, right: Term) -> Term:
    return lambda at: left(at) * right(at)


def _opposite(of: Term) -> Term:
    return lambda at: -of(at)


def _quotient(left: Term, right: Term) -> Term:
    return lambda at: left(at) * inverse(right(at))


def _power(base: Term, power: int) -> Term:
    return lambda at: base(at) ** power


def _applied(function: Callable[..., acb], args: list[Term]) -> Term:
    return lambda at: function(*(arg(at) for arg in args))


def vanishes(value: acb) -> bool:
    """Whether a value is 0; raises :class:`Undecided` where its ball does not decide that."""
    if value.contains(0) and not (value.real.is_zero() and value.imag.is_zero()):
        raise Undecided("a divisor near zero")
    return bool(value.contains(0))


def inverse(value: acb) -> acb:
    """Rocq's inverse, which is 0 at 0."""
    return acb(0) if vanishes(value) else 1 / value


def real(value: acb) -> arb:
    """A real number; Rocq accepts no other where it wants one."""
    if not value.imag.is_zero():
        raise Misread("a complex number in place of a real one")
    return value.real


def positive(value: acb) -> bool:
    """Whether a real number is positive, and not 0 or negative."""
    number = real(value)
    if number > 0 or number <= 0:
        return bool(number > 0)
    raise Undecided("the argument of a root near zero")


def _of_real(function: Callable[[arb], arb]) -> tuple[int, Callable[..., acb]]:
    return 1, lambda x: acb(function(real(x)))


def _of_positive(function: Callable[[arb], arb]) -> tuple[int, Callable[..., acb]]:
    return 1, lambda x: acb(function(real(x))) if positive(x) else acb(0)


def raised(base: acb, power: acb) -> acb:
    """``Craised``: the principal value, and 0^0 = 1."""
    if vanishes(base):
        return acb(int(vanishes(power)))
    return base.pow(power)


def _raised_real(base: acb, power: acb) -> acb:
    logarithm = real(base).log() if positive(base) else arb(0)
    return acb((real(power) * logarithm).exp())


CONSTANTS: dict[str, Callable[[], acb]] = {
    "PI": lambda: acb(arb.pi()),
    "Ci": lambda: acb(0, 1),
}
FUNCTIONS: dict[str, tuple[int, Callable[..., acb]]] = {
    "sqrt": _of_positive(arb.sqrt),
    "ln": _of_positive(arb.log),
    "exp": _of_real(arb.exp),
    "sin": _of_real(arb.sin),
    "cos": _of_real(arb.cos),
    "tan": (1, lambda x: acb(real(x).sin()) * inverse(acb(real(x).cos()))),
    "cot": (1, lambda x: acb(real(x).cos()) * inverse(acb(real(x).sin()))),
    "sinh": _of_real(arb.sinh),
    "cosh": _of_real(arb.cosh),
    "tanh": _of_real(arb.tanh),
    "atan": _of_real(arb.atan),
    "Rabs": _of_real(abs),
    "Rpower": (2, _raised_real),
    "Cexp": (1, lambda z: z.exp()),
    "Cconj": (1, lambda z: acb(z.real, -z.imag)),
    "Craised": (2, raised),
    "RtoC": (1, lambda x: acb(real(x))),
    "Re": (1, lambda z: acb(z.real)),
    "Im": (1, lambda z: acb(z.imag)),
}
PREDICATES = frozenset({*MEANINGS, "tends", "Ctends"})
