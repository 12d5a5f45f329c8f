"""What is written for Rocq: the same from run to run, and nothing left out in silence."""

import os
import subprocess
import sys

import numpy as np
import pytest
from scipy.signal import cont2discrete, ss2tf
from sympy import Eq, Function, Rational, Symbol, cos, exp, expand, pi, sin, sqrt, symbols

from symhaptic.book.chapters import folder, run
from symhaptic.notation import z
from symhaptic.notation.proposition import ForAll, Implies, Predicate, Relation, proposition
from symhaptic.rocq.chapter import printed
from symhaptic.rocq.identities import _Parts
from symhaptic.rocq.propositions import half_said, text
from symhaptic.rocq.steps import comment
from symhaptic.rocq.terms import Names, NotPrinted, real_text

x, y, N = symbols("x y N")


def said(claim, *symbols):
    names = Names()
    with names.bound(*symbols):
        return text(claim, names)


@pytest.mark.parametrize(
    ("term", "wanted"),
    [
        (-(x**2) / y, "-x^2/y"),
        (1 / (x - 1), "1/(x - 1)"),
        (sqrt(x) ** 3, "sqrt(x)^3"),
        (Rational(-2, 3) * x, "-2*x/3"),
        (sin(N * x) ** 2 * pi, "PI*sin(N_*x)^2"),
        (exp(1), "exp(1)"),
    ],
)
def test_a_term_keeps_its_meaning(term, wanted):
    names = Names()
    with names.bound(x, y, N):
        assert real_text(term, names) == wanted


@pytest.mark.parametrize("term", [Function("f")(x), x**y])
def test_what_has_no_name_is_refused(term):
    names = Names()
    with names.bound(x, y), pytest.raises(NotPrinted):
        real_text(term, names)


def test_a_relation_stands_beside_what_it_divides_by():
    assert said(proposition(x / y < 1), x, y) == r"(y <> 0 /\ x/y < 1)"
    assert said(proposition(x < sqrt(y)), x, y) == r"(0 <= y /\ x < sqrt(y))"


@pytest.mark.parametrize(
    ("claim", "less"),
    [
        (proposition(Eq(x, sqrt(y))), False),  # x is real: neither holds for y < 0
        (proposition(x < sqrt(y)), False),
        (proposition(x < sqrt(y) / Symbol("T")), False),
        (proposition(Eq(x * sqrt(y), 0)), True),  # holds for x = 0 and y = -1
        (Relation(x, "!=", sqrt(y)), True),  # holds for y = -1, where Rocq would ask for 0 <= y
        (Relation(z, "=", sqrt(y)), True),
        (proposition(Eq(sqrt(x) * sqrt(y), -1)), True),  # i i = -1
        (proposition(cos(sqrt(y)) > 1), True),  # cos(i) = cosh(1)
        (Implies((proposition(Eq(z, sqrt(y))), proposition(x > 0))), True),
        (proposition(x < sqrt(2)), False),
    ],
)
def test_a_root_that_may_be_imaginary_is_seen(claim, less):
    assert half_said(claim) is less


def test_angles_are_taken_apart_into_few():
    """Of these a and a - 2 b is made all, where a = x (y + 1) and b = x are taken."""
    angles = [2 * x, 2 * x * (2 * y + 2), 2 * x * (y + 1), 2 * x * y, x * (2 * y + 2), x]
    made = _Parts([sin(angle) for angle in angles]).angles
    assert all(expand(sum(n * u for u, n in made[a]) - a) == 0 for a in angles)
    assert sum(abs(n) for of in made.values() for _, n in of) == 2 + 4 + 2 + (2 + 2) + 2 + 1


def test_a_statement_of_roots_that_may_be_imaginary_is_not_called_printed():
    file = printed(run(folder() / "s4b_polynomial_degree.py"))
    assert "s4d-degree" in file.missing
    assert "s4d-degree" not in file.statements


def test_a_bound_symbol_gives_way_to_a_free_one():
    other = symbols("x", cls=type(x))
    claim = ForAll((other,), Implies((proposition(other > 0), proposition(other > -1))))
    assert said(claim) == "(forall x : R, ((0 < x) -> (-1 < x)))"


def test_a_polynomial_is_complex():
    claim = Predicate("stable", (z,), (z**2 - x,))
    assert said(claim, x) == "(stable (fun z : C => -x + z^2)%C)"


@pytest.mark.parametrize("name", ["s3b_envelope", "s5a_passive_is_stable"])
def test_every_statement_is_printed_or_said_not_to_be(name):
    chapter = run(folder() / f"{name}.py")
    file = printed(chapter)
    assert set(chapter.page.settled) == set(file.statements) | set(file.missing)
    text = file.written()
    assert "Admitted" not in text
    assert "admit" not in text
    for step in file.steps:
        assert (step.kind == "Axiom") == step.name.startswith(("open_", "rule_", "axiom_"))
        assert not step.name.startswith("open_") or "not checked: " in text
    assert max(map(len, text.splitlines())) <= 100


@pytest.mark.slow
def test_the_text_is_the_same_from_run_to_run():
    """Lemmas of the last two are cut in the order of a set, which each process has for itself."""
    code = (
        "from symhaptic.book.chapters import folder, run\n"
        "from symhaptic.rocq.chapter import printed\n"
        "for name in ('s5a_passive_is_stable', 's2c_delay', 's4c_arm_limits'):\n"
        "    print(printed(run(folder() / f'{name}.py')).written())"
    )
    found = {
        subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
            text=True,
        ).stdout
        for seed in ("1", "2", "3")
    }
    assert len(found) == 1


@pytest.mark.parametrize(("spring", "loss"), [(0.3, 0.2), (0.001, 0.02), (2.0, 0.0), (0.0, 0.7)])
def test_what_boxes_take_of_a_device_is_so(spring, loss):
    """The theorem on_plants, by the power series there; the device is sampled by SciPy."""
    state, force = np.array([[0, 1], [-spring, -loss]]), np.array([[0], [1]])
    sampled = cont2discrete((state, force, np.array([[1, 0]]), np.zeros((1, 1))), 1)
    (_, n_1, n_0), (_, minus_a, e) = ss2tf(*sampled[:4])[0][0], ss2tf(*sampled[:4])[1]

    def way(damping):
        """The sum of snd (ways g d k)."""
        before, last, total = 0.0, 0.5, 0.5
        for m in range(40):
            following = -(damping * last / (m + 3) + spring * before / ((m + 3) * (m + 2)))
            before, last, total = last, following, total + following
        return total

    assert way(loss) == pytest.approx(n_1, rel=1e-12)
    assert way(-loss) == pytest.approx(n_0 / np.exp(-loss), rel=1e-12)
    assert e == pytest.approx(np.exp(-loss), rel=1e-12)
    assert 1 + minus_a + e == pytest.approx(spring * (n_1 + n_0), abs=1e-12)


def test_a_comment_holds_no_string_and_no_comment():
    assert comment('a "b" (* c *)') == "(* a 'b' ( * c * ) *)"
