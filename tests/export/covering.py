"""Few combinations of factors in which every pair of values occurs that can occur."""

import random
from itertools import combinations, product

import pytest


def pairs(row):
    """All pairs of values of different factors."""
    return set(combinations(sorted(row.items()), 2))


def covering(factors, allowed, tries=60, seed=1):
    """Rows, each a value for every factor, that have all pairs of the allowed rows among them.

    Greedy: of some random rows around a pair that is missing, the one with most missing pairs.
    """
    rng = random.Random(seed)
    names = list(factors)
    every = [dict(zip(names, values, strict=True)) for values in product(*factors.values())]
    every = [row for row in every if allowed(row)]
    holding = {}
    for row in every:
        for pair in pairs(row):
            holding.setdefault(pair, []).append(row)
    left, found = set(holding), []
    while left:
        rows = holding[min(left, key=repr)]
        best = max((rng.choice(rows) for _ in range(tries)), key=lambda r: len(pairs(r) & left))
        found.append(best)
        left -= pairs(best)
    return found


def every_value(first, second, quick=None):
    """All pairs as parameters of a test, those slow that are not needed for each value to occur.

    Each of the longer meets the next of the other.  Those of one of ``second`` are beside each
    other.  If some are ``quick``, the other needed ones run with `make ci`.
    """
    first, second = list(first), list(second)
    rows = range(max(len(first), len(second)))
    usual = {(first[row % len(first)], second[row % len(second)]) for row in rows}
    quick = usual if quick is None else quick

    def when(pair):
        return [] if pair in quick else pytest.mark.ci if pair in usual else pytest.mark.slow

    return [pytest.param(one, other, marks=when((one, other))) for other in second for one in first]


def one_of(values, *some):
    """Parameters of a test, slow but for some."""
    return [pytest.param(v, marks=[] if v in some else pytest.mark.slow) for v in values]
