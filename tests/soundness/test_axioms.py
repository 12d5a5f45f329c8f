"""Axioms hold at many points, by mpmath; the kernel and the classical rules stay short."""

import ast
import random
from functools import cache
from pathlib import Path

import mpmath
import pytest
import sympy as sp

from symhaptic.notation.proposition import And, Exists, Implies, Not, Or, Relation
from symhaptic.proof.theorems import kernel
from symhaptic.proof.theorems.axioms import AXIOMS, known
from symhaptic.proof.theorems.familiar import axiom
from symhaptic.proof.theorems.kernel import NotShown


@cache
def function(term, symbols):
    return sp.lambdify(symbols, term, "mpmath")


def true(claim, values):
    """A proposition of relations at numbers, None where it says more than relations do."""
    if isinstance(claim, Relation):
        left, right = (
            mpmath.mpmathify(function(t, tuple(values))(*values.values())) for t in claim.terms
        )
        close = abs(left - right) < mpmath.mpf(10) ** -30 * (1 + abs(left))
        if claim.sign in ("=", "!="):
            return close == (claim.sign == "=")
        return bool(left < right or (claim.sign == "<=" and close))
    if isinstance(claim, And):
        return all(true(p, values) for p in claim.of)
    if isinstance(claim, Or):
        return any(true(p, values) for p in claim.of)
    if isinstance(claim, Not):
        return not true(claim.of[0], values)
    if isinstance(claim, Implies):
        return not true(claim.of[0], values) or true(claim.of[1], values)
    raise TypeError(claim)


def relations_only(claim):
    if isinstance(claim, Exists):
        return False  # a point that exists is tried for itself, below
    return isinstance(claim, Relation) or (
        bool(claim.parts) and all(map(relations_only, claim.parts))
    )


ORDINARY = [n for n, axiom in AXIOMS.items() if relations_only(axiom.says.body)]


@pytest.mark.parametrize("name", ORDINARY)
def test_an_axiom_about_numbers_holds_at_many_numbers(name):
    claim = AXIOMS[name].says
    draw = random.Random(name)
    special = [0, 1, -1, mpmath.pi, -mpmath.pi / 2, mpmath.pi / 2, 3, mpmath.mpf("1e-12")]
    with mpmath.workdps(50):
        for _ in range(300):
            values = {
                s: draw.choice([*special, draw.uniform(-4, 4), draw.uniform(0, 1)])
                for s in claim.over
            }
            try:
                assert true(claim.body, values), values
            except ZeroDivisionError:
                continue  # a relation of what has no value is false; its hypothesis was, too


def test_most_of_school_mathematics_is_tried():
    assert len(ORDINARY) >= 20


@pytest.mark.parametrize("name", AXIOMS)
def test_an_axiom_is_closed_and_says_where_it_is_from(name):
    assert not AXIOMS[name].says.free
    assert AXIOMS[name].source
    assert known(name).conclusion == AXIOMS[name].says
    assert not known(name).hypotheses


def test_nobody_else_states_an_axiom():
    with pytest.raises(NotShown):
        known("the moon is full")
    with pytest.raises(NotShown):
        kernel.rule(true)
    with pytest.raises(TypeError):
        AXIOMS["the moon is full"] = AXIOMS["square"]


def test_an_axiom_at_what_has_no_value_says_nothing():
    x = sp.Symbol("x")
    assert (
        Relation(sp.S.Zero, "<", 1 / x) in axiom("size", 1 / x).hypotheses
        or Relation(sp.S.Zero, "<=", 1 / x) in axiom("size", 1 / x).hypotheses
    )
    assert Relation(x, "!=", sp.S.Zero) in axiom("square", 1 / x).hypotheses
    with pytest.raises(NotShown):
        axiom("square", sp.I)
    with pytest.raises(NotShown):
        axiom("square", sp.sqrt(x))


def lines_of_code(path):
    """Lines without comments, docstrings, imports and blank lines."""
    text = path.read_text()
    left_out = set()
    for node in ast.walk(ast.parse(text)):
        string = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        if string or isinstance(node, ast.Import | ast.ImportFrom):
            left_out |= set(range(node.lineno, node.end_lineno + 1))
    lines = enumerate(text.splitlines(), 1)
    return sum(
        1
        for i, line in lines
        if line.strip() and not line.lstrip().startswith("#") and i not in left_out
    )


def test_kernel_and_classical_rules_can_be_read_in_an_hour():
    home = Path(kernel.__file__).parent
    names = ("kernel", "analysis", "energy", "roots", "samples")
    assert sum(lines_of_code(home / f"{name}.py") for name in names) < 900


def test_every_point_to_the_right_has_polar_coordinates():
    claim = AXIOMS["polar"].says
    given, then = claim.body.of
    draw = random.Random("polar")
    x, y = claim.over
    for _ in range(200):
        along, across = draw.choice([1e-9, 1.0, draw.uniform(0, 5)]), draw.uniform(-9, 9)
        at = {x: sp.Float(along, 50), y: sp.Float(across, 50)}
        size, angle = then.over
        there = at | {size: sp.sqrt(at[x] ** 2 + at[y] ** 2), angle: sp.atan2(at[y], at[x])}
        with mpmath.workdps(50):
            values = {s: mpmath.mpmathify(sp.N(v, 50)) for s, v in there.items()}
            assert true(given, values)
            assert true(then.body, values)
    assert not true(given, {x: mpmath.mpf(0), y: mpmath.mpf(1)})  # upright, there is none
