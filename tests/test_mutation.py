"""The machinery that changes what was proved: it finds a checker that is too friendly."""

import json
from collections import Counter
from dataclasses import replace

import pytest
import sympy as sp
from flint import acb, arb
from symhaptic.proof.changes import changes, opposite
from symhaptic.proof.checks import Decimals, Free, Limit, Roots, Same, Sign, confirmed
from symhaptic.proof.condition import holds
from symhaptic.proof.second_opinion import alike, says

from symhaptic.book.chapters import folder, run
from symhaptic.book.mutation import trials
from symhaptic.book.mutation.statements import changes_of
from symhaptic.book.mutation.tables import changes_of_tables
from symhaptic.book.page import Page
from symhaptic.book.record import FalseStep
from symhaptic.paper.quoted import Quoted
from symhaptic.proof import box, checks, settle, sign
from symhaptic.proof.verdict import Unfounded

x, y, z = sp.symbols("x y z")
ONE = sp.S.One

CHECKS = [
    Same((sp.cos(2 * x),), (1 - 2 * sp.sin(x) ** 2,)),
    Same((x + y < 1,), (2 * x + 2 * y < 2,)),
    Limit(sp.sin(3 * x) / x, x, sp.S.Zero, sp.Integer(3)),
    Free(sp.sin(x) ** 2 + sp.cos(x) ** 2, x),
    Roots(z**2 - y, {y: sp.Rational(1, 2)}),
    Roots(z**2 - y, {y: sp.Integer(2)}, inside=False),
    Decimals(arb("0.41421356 +/- 1e-9"), "0.4142"),
    Sign(box.positive(2 - x**2, {x: (sp.S.Zero, ONE)})),
    Sign(sign.combined(x + 2 * y, [sign.assume(x)], [2, sign.assume(y)])),
    Sign(sign.quotient(1 / x, sign.number(ONE), sign.assume(x))),
    Sign(
        sign.integrated(
            x**2, up := sign.Interval(x, sp.S.Zero), sign.combined(2 * x, [2, up.above])
        )
    ),
]


@pytest.mark.parametrize(
    "check", CHECKS, ids=[f"{type(c).__name__}{i}" for i, c in enumerate(CHECKS)]
)
def test_a_check_holds_and_its_changes_do_not(check):
    assert confirmed(check)
    tried = [change for change in changes(check) if change.check is not None]
    assert len(tried) >= 3
    wrong = [c.what for c in tried if confirmed(c.check) and c.excuse() is None]
    assert wrong == []
    contrary = opposite(check)
    assert contrary is None or not confirmed(contrary)


def test_a_widened_box_reaches_to_where_the_claim_is_wrong():
    check = Sign(box.positive(2 - x**2, {x: (sp.S.Zero, ONE)}))
    wider = [c for c in changes(check) if c.kind == "domain"]
    assert [c.what for c in wider] == ["x to -4", "x to 2"]  # 2 - x^2 < 0 beyond sqrt 2
    assert not any(confirmed(c.check) for c in wider)


def test_a_box_that_is_not_the_largest_is_named():
    check = Sign(box.positive(2 + x**2, {x: (sp.S.Zero, ONE)}))
    wider = [c for c in changes(check) if c.kind == "domain"]
    assert [c.check for c in wider] == [None, None]
    assert all("hold" in c.excuse() for c in wider)


def test_nested_facts_are_changed_too():
    inner = sign.combined(x + y, [sign.assume(x)], [sign.assume(y)])
    outer = sign.quotient(1 / (x + y), sign.number(ONE), inner)
    assert inner in list(sign.facts_below(outer))


CHAPTERS = [
    pytest.param("s3_energy", marks=pytest.mark.slow),
    "s4d_free_mass",
    pytest.param("s3c_stiffness_maximum", marks=pytest.mark.slow),
    "s4d_parts_of_the_arm",
    "s4d_scaling",
]


@pytest.mark.parametrize("name", CHAPTERS)
def test_a_checker_that_accepts_everything_is_caught(monkeypatch, name):
    chapter = run(folder() / f"{name}.py")
    assert trials.trial(chapter).accepted == []
    monkeypatch.setattr(trials, "confirmed", lambda check: True)
    assert trials.trial(chapter).accepted


ALIKE = '''
"""What stays the same?"""

from sympy import Symbol, cos, sin

x = Symbol("x")


def derive(page):
    page.state("alike", "the squares of sine and cosine add up to the same everywhere")
    page.settle("alike", page.free_of("the sum", sin(x) ** 2 + cos(x) ** 2, x))
'''


def test_a_friendly_derivative_is_caught(monkeypatch, tmp_path):
    path = tmp_path / "alike.py"
    path.write_text(ALIKE.lstrip())
    chapter = run(path)
    assert not trials.trial(chapter).accepted
    monkeypatch.setattr(checks, "is_zero", lambda expr: True)
    assert trials.trial(chapter).accepted


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "place", "part", "friendly"),
    [
        ("s3b_extent", checks, "equal", lambda left, right: True),
        ("s4d_free_mass", sign, "is_zero", lambda expr: True),
        ("s4d_roots_delay_margin", Roots, "holds", lambda self: True),
        ("s4d_figure9_delayed", box, "ball", lambda expr, at=None, bits=64: acb(1)),
        (
            "s3c_damping_maximum",
            settle.Settlement,
            "accepts",
            lambda self, printed, kinds=None: True,
        ),
        ("s3c_stiffness_maximum", settle, "holds", lambda quoted, number: True),
    ],
    ids=["same", "sign", "roots", "box", "verdict", "number"],
)
def test_one_friendly_part_is_caught(monkeypatch, name, place, part, friendly):
    chapter = run(folder() / f"{name}.py")
    monkeypatch.setattr(place, part, friendly)
    assert trials.trial(chapter).accepted


def test_a_weaker_bound_survives_with_the_number_and_a_wrong_one_does_not():
    settled = run(folder() / "s3c_stiffness_maximum.py").page.settled["s3c-kmax-27"]
    outcome = {c.what: (confirmed(c.check), c.excuse()) for c in changes_of(settled)}
    accepted, why = outcome["below 0.28 for below 0.27"]
    assert accepted
    assert why.startswith("weaker, and true: the number is 0.2679")  # 2 - sqrt 3
    assert outcome["below 0.26 for below 0.27"] == (False, None)
    assert outcome["above 0.27 for below 0.27"] == (False, None)


@pytest.mark.parametrize(
    ("how", "digits", "right"),
    [
        ("about", "0.27", True),
        ("about", "0.26", False),
        ("below", "0.27", True),
        ("below", "0.26", False),
        ("above", "0.26", True),
        ("above", "0.27", False),
    ],
)
def test_the_second_opinion_on_numbers(how, digits, right):
    """2 - sqrt 3 = 0.26794919..., a textbook number."""
    assert says(Quoted(how, digits), arb("0.26794919 +/- 1e-8")) is right


def test_the_second_opinion_on_formulas():
    assert alike((sp.tan(x),), (sp.sin(x) / sp.cos(x),))
    assert not alike((sp.tan(x),), (sp.sin(x),))
    assert not alike((x < y,), (y < x,))
    assert not alike((sp.Eq(x, y),), (sp.Eq(x, -y),))


def settled_page(**how):
    from symhaptic.notation import K, b

    page = Page("test")
    page.state("my-claim", "b is above K", "b > K")
    page.settle("my-claim", b > K, **how)
    return page


def test_a_counterexample_stands_against_what_is_proved():
    from symhaptic.notation import K, b

    point = {K: ONE, b: sp.Integer(2)}
    with pytest.raises(Unfounded, match="stands against"):
        settled_page(unless=point, truth=b < K, shows="something")


def test_a_counterexample_lies_outside_its_condition():
    from symhaptic.notation import K, b

    how = {"truth": sp.Gt(K, 3 * b, evaluate=False), "shows": "something"}
    settled_page(provided=r"K\ge2", unless={K: ONE, b: sp.Integer(2)}, **how)
    with pytest.raises(Unfounded, match="condition holds"):
        settled_page(provided=r"K\ge1", unless={K: ONE, b: sp.Integer(2)}, **how)


@pytest.mark.parametrize(
    ("condition", "answer"),
    [
        (r"d\in\mathbb{N}_0", False),
        (r"K\ge0,\ K\ne2", True),
        (r"K\ge0\ \text{and}\ K\ne1", False),
        (r"0<K\le\tfrac12", False),
        (r"H(1)\ge0", None),
        (r"\gamma\ge0", None),
        (r"K\ge0\ \text{or}\ K\ne1", None),
        (r"K=2,\ \text{for some arms}", False),
    ],
)
def test_a_condition_is_read_as_far_as_it_is_a_formula(condition, answer):
    from symhaptic.notation import K, d

    assert holds(condition, {d: sp.S.Half, K: ONE}) is answer


def test_the_page_keeps_what_was_confirmed_only():
    page = Page("test")
    page.step("A square", (x + 1) ** 2, x**2 + 2 * x + 1)
    with pytest.raises(FalseStep):
        page.step("A wrong one", (x + 1) ** 2, x**2 + 1)
    [(title, check)] = page.checks
    assert title == "A square"
    assert confirmed(check)
    assert not confirmed(replace(check, right=(x**2 + 1,)))


def test_the_ledger_holds_nothing_of_the_checks():
    """Entries go from one process to another; they carry verdicts, not closures."""
    import pickle

    from symhaptic.book.ledger import of_derivation

    entries = of_derivation(folder() / "s4d_parts_delay.py")
    assert len(pickle.dumps(entries)) < 200_000


def test_the_digits_of_a_table_are_changed(monkeypatch, tmp_path):
    """A chapter that needs 3 + 4 = 7 notices each of its digits, and no other one."""
    from dataclasses import make_dataclass

    from symhaptic.paper import tables

    Row = make_dataclass("Row", ["name", "left", "right", "unused"])
    monkeypatch.setattr(tables, "TABLE_X", (Row("one", "3", "4", "5"),), raising=False)
    path = tmp_path / "adds.py"
    path.write_text(
        '"""Do they add up?"""\n'
        "from sympy import Integer\n"
        "from symhaptic.paper.tables import TABLE_X\n"
        "def derive(page):\n"
        "    [row] = TABLE_X\n"
        "    page.step('Sum', Integer(row.left) + Integer(row.right), Integer(7))\n",
        encoding="utf-8",
    )
    outcome = {c.what: confirmed(c.check) for c in changes_of_tables(run(path), [path])}
    assert sum(outcome.values()) == 2
    assert all(("unused" in what) is accepted for what, accepted in outcome.items())
    assert len(outcome) == 6


def test_a_record_of_another_sympy_has_the_same_statements(tmp_path):
    found = [trials.Trial("one", {"eq5": Counter(sign=3)})]
    path = tmp_path / "mutants.json"
    record = json.loads(trials.committed(found))
    path.write_text(json.dumps(record | {"sympy": "0"}), encoding="utf-8")
    assert not trials.stale(path, found)
    path.write_text(json.dumps(record | {"sympy": "0", "chapters": {}}), encoding="utf-8")
    assert trials.stale(path, found)
