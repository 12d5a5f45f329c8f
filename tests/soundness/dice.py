"""Random formulas, made to be taken for each other: branch cuts, roots, parts, assumptions."""

from __future__ import annotations

import random

import sympy as sp
from sympy import I, Rational, pi

PLAIN = sp.symbols("u v w")
f = sp.Function("f")
ASSUMED = [
    sp.Symbol("u", positive=True),
    sp.Symbol("u", real=True),
    sp.Symbol("v", negative=True),
    sp.Symbol("v", nonnegative=True),
    sp.Symbol("n", integer=True),
    sp.Symbol("n", positive=True, integer=True),
    sp.Symbol("q", imaginary=True),
    sp.Symbol("r", complex=True),
    sp.Symbol("k", even=True),
    sp.Symbol("_zeta"),
    sp.Symbol("_g1"),
]
NUMBERS = [sp.S(k) for k in (-2, -1, 1, 2, 3)] + [
    Rational(1, 2),
    Rational(-1, 3),
    Rational(2, 3),
    pi,
    pi / 3,
    I,
    sp.sqrt(2),
    sp.S.Zero,
]
SMOOTH = [sp.exp, sp.sin, sp.cos, sp.tan, sp.sinh, sp.cosh, sp.tanh, sp.cot]
CUT = [sp.log, sp.asin, sp.acos, sp.atan, sp.acosh, sp.asinh, sp.LambertW]
PARTS = [sp.re, sp.im, sp.Abs, sp.conjugate]
POWERS = [Rational(1, 2), Rational(1, 3), Rational(-1, 2), Rational(3, 2), sp.S(2), sp.S(-1)]


def leaf(dice: random.Random, letters):
    return dice.choice(letters) if dice.random() < 0.7 else dice.choice(NUMBERS)


def expression(dice: random.Random, letters, depth: int):
    """A random expression."""
    if depth == 0:
        return leaf(dice, letters)
    kind = dice.random()
    inner = lambda: expression(dice, letters, dice.randrange(depth))  # noqa: E731
    if kind < 0.04:  # as it is written
        return dice.choice([sp.Add, sp.Mul, sp.Pow])(inner(), inner(), evaluate=False)
    if kind < 0.25:
        return inner() + inner()
    if kind < 0.5:
        return inner() * inner()
    if kind < 0.62:
        return inner() ** dice.choice(POWERS)
    if kind < 0.68:
        return inner() ** leaf(dice, letters)
    if kind < 0.85:
        return dice.choice(SMOOTH)(inner())
    if kind < 0.9:
        return dice.choice(CUT)(inner())
    if kind < 0.97:
        return dice.choice(PARTS)(inner(), evaluate=dice.random() < 0.5)
    return f(inner())


def letters(dice: random.Random):
    """The symbols of one question, some of them with assumptions, at most one of each name."""
    pool = list(PLAIN) if dice.random() < 0.5 else [*PLAIN, *ASSUMED]
    dice.shuffle(pool)
    chosen = {}
    for symbol in pool[:4]:
        chosen.setdefault(symbol.name, symbol)
    return list(chosen.values())[: dice.randint(1, 3)]


def _rule(dice: random.Random, e):
    """What might be thought to be the same as an expression; often it is not."""
    options = [e]
    if e.is_Pow:
        b, p = e.args
        options += [sp.exp(p * sp.log(b)), 1 / b**-p, b ** (p - 1) * b, sp.Abs(b) ** p]
        if b.is_Mul:
            options.append(sp.Mul(*(x**p for x in b.args)))
        if b.is_Pow:
            options.append(b.args[0] ** (b.args[1] * p))
        if isinstance(b, sp.exp):
            options.append(sp.exp(b.args[0] * p))
    if e.is_Mul:
        options += [sp.expand(e), sp.exp(sp.Add(*(sp.log(a) for a in e.args)))]
        roots = [a for a in e.args if a.is_Pow and a.args[1] == Rational(1, 2)]
        if len(roots) > 1:
            joined = sp.sqrt(sp.Mul(*(r.args[0] for r in roots)))
            options.append(e / sp.Mul(*roots) * joined)
    if e.is_Add:
        options += [sp.factor_terms(e), sp.together(e), sp.sqrt(e**2), sp.sqrt(e) ** 2]
    if isinstance(e, sp.Function) and len(e.args) == 1:
        a = e.args[0]
        c, s = sp.cos, sp.sin
        options += {
            sp.sin: [
                c(a - pi / 2),
                2 * s(a / 2) * c(a / 2),
                sp.sqrt(1 - c(a) ** 2),
                sp.im(sp.exp(I * a)),
            ],
            sp.cos: [s(a + pi / 2), 1 - 2 * s(a / 2) ** 2, sp.re(sp.exp(I * a)), (-1) ** (a / pi)],
            sp.tan: [s(a) / c(a), s(2 * a) / (1 + c(2 * a)), 1 / sp.cot(a)],
            sp.cot: [c(a) / s(a), 1 / sp.tan(a)],
            sp.exp: [sp.exp(a / 2) ** 2, sp.sqrt(sp.exp(2 * a)), c(-I * a) + I * s(-I * a)],
            sp.sinh: [(sp.exp(a) - sp.exp(-a)) / 2, -I * s(I * a)],
            sp.cosh: [(sp.exp(a) + sp.exp(-a)) / 2, c(I * a)],
            sp.tanh: [sp.sinh(a) / sp.cosh(a), (sp.exp(2 * a) - 1) / (sp.exp(2 * a) + 1)],
            sp.log: [sp.log(a**2) / 2, sp.log(sp.Abs(a)), 2 * sp.log(sp.sqrt(a)), -sp.log(1 / a)],
            sp.re: [a, (a + sp.conjugate(a)) / 2, a - I * sp.im(a), sp.re(sp.conjugate(a))],
            sp.im: [-sp.im(sp.conjugate(a)), (a - sp.conjugate(a)) / (2 * I), sp.S.Zero],
            sp.Abs: [a, -a, sp.sqrt(a**2), sp.sqrt(a * sp.conjugate(a))],
            sp.conjugate: [a, sp.re(a) - I * sp.im(a), 2 * sp.re(a) - a],
            sp.asin: [pi / 2 - sp.acos(a), sp.re(e)],
            sp.acos: [pi / 2 - sp.asin(a), sp.re(e)],
        }.get(e.func, [sp.re(e, evaluate=False), sp.conjugate(e)])
    options += [sp.re(e, evaluate=False), sp.log(sp.exp(e)), sp.exp(sp.log(e)), e**2 / e]
    return dice.choice(options)


def changed(dice: random.Random, e):
    """The expression with some of its parts written in another way."""
    if not e.free_symbols or sum(1 for _ in sp.preorder_traversal(e)) > 40:
        return e  # SymPy takes long to look at towers of numbers
    if e.args:
        args = [changed(dice, a) if dice.random() < 0.6 else a for a in e.args]
        if args != list(e.args):
            e = e.func(*args)
    return _rule(dice, e) if dice.random() < 0.4 else e


def pair(dice: random.Random):
    """Two expressions that may be the same, and their symbols."""
    names = letters(dice)
    left = expression(dice, names, dice.randint(1, 3))
    if dice.random() < 0.85:
        right = next((r for r in (changed(dice, left) for _ in range(6)) if r != left), left)
    else:
        right = expression(dice, names, 2)
    if dice.random() < 0.3:  # somebody else's symbols, of which other things are assumed
        bare = {s: sp.Symbol(s.name) for s in right.free_symbols}
        right = right.xreplace(bare)
    return left, right, names


def relations(dice: random.Random):
    """Two relations that may say the same, and their symbols."""
    names = letters(dice)
    kinds = [sp.Eq, sp.Ne, sp.Lt, sp.Le, sp.Gt, sp.Ge]
    kind = dice.choice(kinds)
    sides = [expression(dice, names, dice.randint(0, 2)) for _ in range(2)]
    others = [changed(dice, side) if dice.random() < 0.5 else side for side in sides]
    scale, shift = dice.choice([1, 1, 2, -1, Rational(1, 3)]), leaf(dice, [*names, 0])
    others = [scale * other + shift for other in others]
    other_kind = kind
    if dice.random() < 0.5:
        others.reverse()
        turned = {sp.Lt: sp.Gt, sp.Gt: sp.Lt, sp.Le: sp.Ge, sp.Ge: sp.Le}
        other_kind = turned.get(kind, kind)
    if dice.random() < 0.2:
        other_kind = dice.choice(kinds)
    left, right = kind(*sides, evaluate=False), other_kind(*others, evaluate=False)
    return left, right, names


def number(dice: random.Random, symbol):
    """A number that a symbol may be."""
    for _ in range(200):
        size = dice.choice([1, 1, 3, 10])
        value = Rational(dice.randint(-99, 99), dice.randint(1, 20)) / size
        if dice.random() < 0.3:
            value = sp.Integer(dice.randint(-4, 4))
        if symbol.is_imaginary:
            value = value * I
        elif symbol.is_complex and symbol.is_real is None:
            value += I * Rational(dice.randint(-9, 9), 7)
        known = symbol.assumptions0.items()
        if all(getattr(value, f"is_{what}", holds) is holds for what, holds in known):
            return value
    return None


def real(dice: random.Random, names, depth: int):
    """An expression for an inequality, mostly real."""
    if depth == 0:
        return dice.choice([*names, *names, *(s for s in NUMBERS if s.is_real and s != 0)])
    inner = lambda: real(dice, names, dice.randrange(depth))  # noqa: E731
    kind = dice.random()
    if kind < 0.35:
        return inner() + inner()
    if kind < 0.6:
        return inner() * inner()
    if kind < 0.8:
        return inner() ** dice.choice([*POWERS, sp.S(2), sp.S(3)])
    return dice.choice([sp.exp, sp.sin, sp.cos, sp.tan, sp.log, sp.atan, sp.Abs, sp.tanh])(inner())


def box(dice: random.Random):
    """A relation, its box, and the relation's symbols."""
    names = list(sp.symbols("u v"))[: dice.randint(1, 2)]
    smaller = real(dice, names, dice.randint(1, 3))
    if dice.random() < 0.5:  # a side stands on both
        common = real(dice, names, 2)
        smaller, larger = common + smaller, common + real(dice, names, 1)
    else:
        larger = real(dice, names, dice.randint(0, 3))
    if dice.random() < 0.4:
        larger = larger + dice.choice([1, 2, 5])
    kind = dice.choice([sp.Lt, sp.Le, sp.Gt, sp.Ge])
    ends = {}
    for symbol in names:
        low = Rational(dice.randint(-6, 6), dice.randint(1, 4))
        ends[symbol] = (low, low + Rational(dice.randint(1, 12), dice.randint(1, 6)))
    if dice.random() < 0.3:
        smaller = vanishing(dice, smaller, ends)
    return kind(smaller, larger, evaluate=False), ends


def vanishing(dice: random.Random, side, ends):
    """A side with something beside it that is zero where it is defined, which SymPy would drop."""
    symbol = dice.choice(list(ends))
    low, high = ends[symbol]
    place = symbol - dice.choice([low, high, (low + high) / 2, low - 1])
    part = dice.choice([1 / place, sp.log(place), sp.sqrt(place), sp.tan(place), sp.exp(1 / place)])
    if dice.random() < 0.5:
        part = dice.choice([sp.im, sp.Abs, sp.conjugate])(part, evaluate=False)
    if dice.random() < 0.5:
        return sp.Add(side, part, sp.Mul(-1, part, evaluate=False), evaluate=False)
    return sp.Add(side, sp.Mul(0, part, evaluate=False), evaluate=False)
