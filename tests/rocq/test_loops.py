"""The printed polynomial of a loop is that of its device, sampled by a matrix exponential."""

import mpmath
import pytest
from flint import acb, ctx
from sympy import S, pi, sqrt

from symhaptic.book.chapters import folder, run
from symhaptic.notation import z
from symhaptic.proof.theorems.definitions import loop, loop_substituted
from symhaptic.rocq.chapter import theorems_of
from symhaptic.rocq.propositions import text
from symhaptic.rocq.reading import read
from symhaptic.rocq.steps import order
from symhaptic.rocq.terms import Names

SAMPLES = (0.6 + 0.3j, -1.2 + 0.4j, 0.9 - 0.8j)
"""Values of z^(1/q) at which two polynomials are compared."""


@pytest.fixture(autouse=True)
def _precision():
    before, ctx.prec = ctx.prec, 200
    with mpmath.workdps(40):
        yield
    ctx.prec = before


def of_device(wall, share, w):
    """z^d z (z^2 - a z + e) + (n_1 z + n_0) ((alpha + beta) z - beta) at z = w^share."""
    alpha, beta, gamma, delta, late = (mpmath.mpf(v.evalf(40)) for v in map(S, wall))
    step = mpmath.expm(mpmath.matrix([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]))
    n_1, n_0 = step[0, 2], step[0, 1] * step[1, 2] - step[1, 1] * step[0, 2]
    a, e = step[0, 0] + step[1, 1], step[0, 0] * step[1, 1] - step[0, 1] * step[1, 0]
    z_, behind = mpmath.mpc(w) ** share, mpmath.mpc(w) ** int(share * late)
    return behind * z_ * (z_**2 - a * z_ + e) + (n_1 * z_ + n_0) * ((alpha + beta) * z_ - beta)


def printed(theorem):
    """The text of the predicate on the polynomial, as it is printed."""
    return text(theorem.conclusion.of[1], Names())


def agrees(said, theorem, share):
    """Whether the text, with the values that Rocq gives its functions, is that polynomial."""
    *guards, stable = read(said)
    for guard in guards:
        assert (guard.right({}) - guard.left({})).real >= 0
    wall = theorem.conclusion.of[0].of
    for w in SAMPLES:
        found = complex(stable.terms[0]({stable.variable: acb(w.real, w.imag)}))
        if abs(found - complex(of_device(wall, share, w))) > 1e-12 * (1 + abs(found)):
            return False
    return True


@pytest.mark.slow
def test_each_loop_in_numbers_of_the_marginal_chapter_is_that_of_its_device():
    """Its device has gamma = pi^2/10000 and delta = 1/50, and so the root of a negative number."""
    chapter = run(folder() / "s6_marginal.py")
    count = 0
    for theorem in order(t for _, _, t in theorems_of(chapter)):
        if theorem.rule not in ("loop", "loop_substituted") or theorem.conclusion.free:
            continue
        share = theorem.given[2] if theorem.rule == "loop_substituted" else 1
        assert agrees(printed(theorem), theorem, share), theorem.conclusion.of[0]
        count += 1
    assert count >= 2


WALLS = [
    # that of the chapter; that of the jackpot; poles at a right angle; a delay of half a period
    ((S(1) / 2000, 0, pi**2 / 10000, S(1) / 50, 49), 1),
    ((-100, 0, sqrt(2), 2, 0), 1),
    ((1, 2, pi**2 / 4, 0, 1), 1),
    ((1, 2, 3, 1, S.Half), 2),
]


@pytest.mark.parametrize(("wall", "share"), WALLS)
def test_a_loop_is_that_of_its_device(wall, share):
    theorem = loop_substituted(wall, z, share)
    assert agrees(printed(theorem), theorem, share)


@pytest.mark.parametrize(
    ("wall", "old", "new"),
    [
        # printed as Rocq's sqrt, the root of a negative number is 0, and so the poles are one
        (WALLS[1][0], "Ci*sqrt(-4 + 4*sqrt(2))", "sqrt(-4*sqrt(2) + 4)"),
        (WALLS[0][0], "Ci*sqrt(", "sqrt(-"),
        (WALLS[2][0], "4/(PI)^2", "3/(PI)^2"),
    ],
)
def test_another_polynomial_is_found_out(wall, old, new):
    said = printed(theorem := loop(wall, z))
    assert old in said
    assert not agrees(said.replace(old, new), theorem, 1)
