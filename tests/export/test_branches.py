"""Steps are done only where they are needed, and there once."""

import sympy as sp

from symhaptic.export.blocks import Assign, Choice, Join, Set
from symhaptic.export.branches import lazy
from symhaptic.export.routine import Steps, choose

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


def test_a_choice_that_is_asked_for_again_is_made_once():
    """Two results of one choice, the second needed only where y is small, or very small."""
    do = Steps()
    fade = do("fade", sp.exp(-x))
    first, second = (
        do(name, choose(x < 1, x + k, fade + k)) for k, name in ((1, "first"), (2, "second"))
    )
    near = do("near", choose(y < 1, second * second, x))
    nearer = do("nearer", choose(y < sp.Rational(1, 2), second + y, x))
    block = lazy(routine(do, first + near + nearer))
    for way in paths(block):
        assert len(calls(way)) <= 1
        asked = [step[0] for step in way if isinstance(step, tuple)]
        assert len(asked) == len(set(asked))


def test_a_choice_that_needs_more_is_made_where_it_is_needed():
    do = Steps()
    fade = do("fade", sp.exp(-x))
    first = do("first", choose(x < 1, x, fade))
    second = do("second", choose(x < 1, sp.S.Zero, sp.sin(x) + fade))
    near = do("near", choose(y < 1, second * second, x))
    ways = list(paths(lazy(routine(do, first + near))))
    assert all(sp.sin(x) not in calls(way) for way in ways if (y < 1, False) in way)
    assert any(sp.sin(x) in calls(way) for way in ways)


def test_a_decided_choice_is_not_done_before():
    """Both sides need it, but each needs one side of it."""
    do = Steps()
    sign = do("sign", choose(x < 0, -y, y))
    wave = do("wave", sp.sin(sign))
    found = do("found", choose(x < 0, wave + sp.exp(x), wave * wave))
    (join, _) = lazy(routine(do, found + 1))
    assert isinstance(join, Join)
    assert len(list(paths((join,)))) == 2
