"""Whatever is proved holds where it is tried, and whatever is refuted fails where it is said to.

The judge is mpmath on the expression's tree.  SYMHAPTIC_SOUNDNESS is the number of identities
that are tried; a tenth as many boxes are.
"""

import os
import random
from collections import Counter

import pytest
import sympy as sp
from soundness import dice as made
from soundness import judge

from symhaptic import prove
from symhaptic.proof.verdict import Kind

COUNT = int(os.environ.get("SYMHAPTIC_SOUNDNESS", "400"))
FIRST = int(os.environ.get("SYMHAPTIC_SOUNDNESS_SEED", "0"))
CHUNKS = 8
STEPS = 200_000


def shares(total: int):
    return [
        range(FIRST + total * i // CHUNKS, FIRST + total * (i + 1) // CHUNKS) for i in range(CHUNKS)
    ]


def unknown_of(dice):
    """A function of complex values, of which nothing special is true."""
    a, b, c = (complex(dice.randint(-9, 9) / 7, dice.randint(1, 5)) for _ in range(3))
    return lambda name, args: a + sum(b * x + c * x * x for x in args)


def line_of(point):
    """The line that a counterexample takes an unknown function for."""

    def line(name, args):
        first, second = (judge.value(sp.sympify(point.get(f"{name}_{i}", 0)), {}) for i in (0, 1))
        return first + second * sum(args)

    return line


def allowed(point, symbols):
    """Whether a counterexample has what is assumed of the symbols."""
    for symbol in symbols:
        if symbol.name in point:
            value = sp.sympify(point[symbol.name])
            for what, holds in symbol.assumptions0.items():
                assert getattr(value, f"is_{what}", holds) is holds, (symbol, value, what)


def judge_identity(seed):
    dice = random.Random(seed)
    left, right, _ = (made.relations if seed % 5 == 0 else made.pair)(dice)
    if left.has(sp.zoo, sp.nan, sp.oo) or right.has(sp.zoo, sp.nan, sp.oo):
        return "no formula"
    symbols = left.free_symbols | right.free_symbols
    verdict = prove(left, right, steps=STEPS)
    if verdict.kind == Kind.PROVED:
        joined = {}
        for symbol in symbols:
            joined.setdefault(symbol.name, {}).update(symbol.assumptions0)
        joined = [sp.Symbol(name, **known) for name, known in joined.items()]
        tried = 0
        for _ in range(12):
            point = {s.name: made.number(dice, s) for s in joined}
            if None in point.values():
                continue
            at = {name: judge.value(number, {}) for name, number in point.items()}
            try:
                same = judge.alike(left, right, at, unknown_of(dice))
            except ArithmeticError:
                continue
            tried += 1
            assert same, f"seed {seed}: {left} = {right} is proved, and false at {point}"
        return "proved" if tried else "proved, not tried"
    if verdict.kind == Kind.REFUTED:
        point = verdict.counterexample
        allowed(point, symbols)
        if not {s.name for s in symbols} <= set(point):
            return "refuted, a definition"
        at = {name: judge.value(sp.sympify(text), {}) for name, text in point.items()}
        try:
            same = judge.alike(left, right, at, line_of(point))
        except judge.Unclear:
            return "refuted, unclear"
        assert not same, f"seed {seed}: {left} = {right} is refuted, and true at {point}"
        return "refuted"
    return "undecided"


def judge_box(seed):
    dice = random.Random(seed)
    relation, ends = made.box(dice)
    if relation.has(sp.zoo, sp.nan, sp.oo, sp.I):
        return "no formula"
    verdict = prove(relation, ends, steps=STEPS)
    if verdict.kind == Kind.ENCLOSED:
        for _ in range(20):
            share = {s: sp.Rational(dice.randint(0, 1000), 1000) for s in ends}
            if dice.random() < 0.3:
                share = {s: sp.Integer(dice.randint(0, 1)) for s in ends}
            point = {s.name: low + (high - low) * share[s] for s, (low, high) in ends.items()}
            at = {name: judge.value(number, {}) for name, number in point.items()}
            try:
                holds = judge.truth(relation, at)
            except judge.Unclear:
                continue
            assert holds, f"seed {seed}: {relation} is enclosed, and false at {point}"
        return "enclosed"
    if verdict.kind == Kind.REFUTED:
        point = {name: sp.sympify(text) for name, text in verdict.counterexample.items()}
        for symbol, (low, high) in ends.items():
            assert low <= point[symbol.name] <= high
        at = {name: judge.value(number, {}) for name, number in point.items()}
        try:
            holds = judge.truth(relation, at)
        except judge.Unclear:
            return "refuted, unclear"
        assert not holds, f"seed {seed}: {relation} is refuted, and true at {point}"
        return "refuted"
    return "undecided"


@pytest.mark.parametrize("seeds", shares(COUNT), ids=str)
def test_random_identities(seeds):
    found = Counter(map(judge_identity, seeds))
    if len(seeds) >= 40:  # the dice are good for something
        assert {"proved", "refuted", "undecided"} <= set(found)


@pytest.mark.parametrize("seeds", shares(COUNT // 10), ids=str)
def test_random_boxes(seeds):
    Counter(map(judge_box, seeds))
