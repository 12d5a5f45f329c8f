"""Steps are done only where they are needed, and there once."""

import pytest
import sympy as sp

from symhaptic.export.branches import Assign, Choice, Join, Set, lazy
from symhaptic.export.notation import Steps
from symhaptic.export.routine import choose

x, y = sp.symbols("x y")


def paths(block, met=()):
    """For each way through a block, what is done on it; () where both sides go on together."""
    for at, statement in enumerate(block):
        if isinstance(statement, Choice | Join):
            rest = () if isinstance(statement, Choice) else block[at + 1 :]
            for side, holds in ((statement.yes, True), (statement.no, False)):
                yield from paths((*side, *rest), (*met, (statement.condition, holds)))
            return
        met = (*met, statement)
    yield met


def calls(path):
    """The functions that are called on a way."""
    return [f for s in path if isinstance(s, Assign | Set) for f in s.expr.atoms(sp.exp, sp.sin)]


def routine(do, result):
    """Of x and y."""
    return do.routine("Own", "an example", (x, y), result)


def test_what_both_sides_need_is_done_before_them():
    do = Steps()
    fade = do("fade", sp.exp(-x))
    twice = do("twice", choose(y > 1, fade * fade, fade + sp.sin(y)))
    block = lazy(routine(do, twice + 1))
    assert block[0] == Assign(fade, sp.exp(-x))


def test_what_one_side_needs_is_done_there_alone():
    do = Steps()
    fade = do("fade", sp.exp(-x))
    found = do("found", choose(y > 1, fade * fade, y))
    ways = list(paths(lazy(routine(do, found + 1))))
    assert sorted(len(calls(way)) for way in ways) == [0, 1]


@pytest.mark.parametrize("limits", [(1, 2), (2, 1)])
def test_values_that_choose_differently_share_what_they_need(limits):
    """One limit decides another one of the same number, and no way calls a function twice."""
    do = Steps()
    fade = do("fade", sp.exp(-x))
    one, two = limits
    first = do("first", choose(y > 0, choose(x < one, fade, y), x))
    second = do("second", choose(y > 0, choose(x < two, fade * fade, y), x))
    ways = list(paths(lazy(routine(do, first + second))))
    for way in ways:
        assert len(calls(way)) <= 1
        assert not {(x < 1, True), (x < 2, False)} <= set(way)
    assert len(ways) == 4


def test_a_cheap_question_comes_first():
    """What only one answer to it needs is found there, not before."""
    do = Steps()
    fade = do("fade", sp.exp(-x))
    first = do("first", choose(y > 0, choose(fade < 1, sp.sin(y), y), x))
    second = do("second", choose(y > 0, choose(x < 2, fade * sp.sin(x), y), x))
    for way in paths(lazy(routine(do, first + second))):
        met = [step for step in way if isinstance(step, tuple)]
        assert met[:2] in ([(y > 0, True), (x < 2, True)], [(y > 0, True), (x < 2, False)]) or (
            met == [(y > 0, False)]
        )


def test_a_decided_choice_is_not_done_before():
    """Both sides need it, but each needs one side of it."""
    do = Steps()
    sign = do("sign", choose(x < 0, -y, y))
    wave = do("wave", sp.sin(sign))
    found = do("found", choose(x < 0, wave + sp.exp(x), wave * wave))
    (join, _) = lazy(routine(do, found + 1))
    assert isinstance(join, Join)
    assert len(list(paths((join,)))) == 2
