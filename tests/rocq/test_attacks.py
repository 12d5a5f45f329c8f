"""Rocq says no: what is wrong in one place is not proved by the proof of what is right."""

import re as regex
import shutil
from dataclasses import replace
from types import SimpleNamespace

import mpmath
import pytest
from sympy import E, I, Lt, Rational, S, atan, cos, exp, pi, re, sin, sqrt, symbols, tan

from symhaptic.book import foreign
from symhaptic.book.lemmas.stiffest_stable import SMALL, M, P
from symhaptic.notation import X, a, delta, e, gamma, n_0, n_1, s, theta, z
from symhaptic.notation.proposition import (
    ForAll,
    Implies,
    Or,
    Predicate,
    Relation,
    proposition,
    whole,
)
from symhaptic.paper.ranges import RANGES
from symhaptic.proof import box
from symhaptic.proof.certificate import Positive
from symhaptic.proof.plants import AT_ONE, LOSS, named
from symhaptic.proof.theorems.analysis import (
    above_its_start,
    crosses_zero,
    grows,
    increases,
    induction,
    no_other_limit,
)
from symhaptic.proof.theorems.definitions import gains, loop, loop_substituted
from symhaptic.proof.theorems.energy import toeplitz
from symhaptic.proof.theorems.familiar import axiom
from symhaptic.proof.theorems.kernel import (
    assume,
    conj,
    disch,
    disj_cases,
    exists,
    gen,
    inst,
    not_intro,
    spec,
    subst,
    undisch,
)
from symhaptic.proof.theorems.leaves import (
    broken,
    combined,
    factor,
    identity,
    is_whole,
    mirrored,
    number,
    on_box,
    on_plants,
    root_outside,
    roots_inside,
    tends,
)
from symhaptic.proof.theorems.roots import jury, last_coefficient, none_enters, zero_on_circle
from symhaptic.proof.theorems.samples import after_a_blow, held_answer
from symhaptic.proof.theorems.tactics import at, every, one, over
from symhaptic.rocq import assumptions, compiled
from symhaptic.rocq.chapter import printed

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("coqc") is None, reason=compiled.INSTALL),
]

x, y, n = symbols("x y n")
ABOVE = proposition(x > 0)
NUMBERS = (gamma, delta, n_1, n_0, a, e)


def less(left, right):
    return number(Lt(left, right, evaluate=False))


def cases():
    cover = axiom("order", 0, x)
    right = combined(x**2 >= 0, [assume(Relation(S.Zero, "<", x))] * 2)
    left = combined(x**2 >= 0, [combined(-x >= 0, [assume(x <= 0)])] * 2)
    return disj_cases(cover, right, left)


def sum_of_whole():
    start = is_whole(S.Zero)
    step = disch(is_whole(n + 1, assume(whole(n))), whole(n), whole(n))
    return induction(whole(n), n, start, step)


def squared():
    """0 < x^2 for 1 < x."""
    return combined(x**2 > 0, [assume(x > 1)] * 2, [2, assume(x > 1)], [less(S.Zero, S.One)])


def apart():
    """x != 0 for 1 < x."""
    return [combined(Relation(x, "!=", S.Zero), [assume(x > 1)], [less(S.Zero, S.One)])]


def entered():
    """Along z^2 - p with z = v^2 nothing enters when p v^3 is added, if nothing crosses."""
    p, v, q, t = symbols("p v q t")
    ahead, part = [proposition(t > 0)], [proposition(q > 0), proposition(q <= 1)]
    spots = [
        (I * t, [*part, *ahead, proposition(t <= pi / 2)]),
        (S.Zero, part),
        (t + I * pi / 2, [*part, *ahead]),
    ]
    shown = []
    for w, given in spots:
        side = exp(4 * w) - p + q * p * exp(3 * w)
        claim = every([q, t], given, Relation(side, "!=", S.Zero))
        shown.append(at(assume(claim), {q: q, t: t}, *map(assume, given)))
    begin = assume(Predicate("stable", (z,), (z**2 - p,)))
    return none_enters(begin, p * v**3, (v, q, t, x, y), *shown)


def chosen_number():
    from symhaptic.notation.proposition import Exists

    wanted = Exists((y,), proposition(y > 1))
    return exists(less(S.One, S(2)), wanted, {y: S(2)})


def sine_at_a_quotient():
    """Of some y the sine of x y is positive: of n/x."""
    from symhaptic.notation.proposition import Exists

    wanted = Exists((y,), proposition(sin(x * y) > 0))
    return exists(assume(proposition(sin(n) > 0)), wanted, {y: n / x})


def known_device():
    return assume(Predicate("device", (), NUMBERS))


def certificate(expr, ends, given=None):
    return box.positive(expr, ends, given)


def plants(expr):
    """Of the numbers of all plants of the paper's (23)."""
    return certificate(expr, RANGES, named(SMALL))


TENTH = "the roots of a tenth of a half turn"
ATTACKS = {
    # kind: the theorem, and wrong variants of its statement
    "an identity": (
        lambda: identity((x**2 - 1) / (x - 1), x + 1),
        [("x + 1)", "x - 1)"), ("(x - 1 <> 0) -> ", ""), ("(x^2 - 1)", "(x^3 - 1)")],
    ),
    "quotients of numbers": (
        lambda: identity((x / 2 + Rational(1, 3)) ** 2, x**2 / 4 + x / 3 + Rational(1, 9)),
        [("x^2/4", "x^2/3"), ("1/9", "1/8"), ("x/3 +", "-x/3 +"), ("(x/2", "(x/4")],
    ),
    "j below a line": (
        lambda: roots_inside(z - 1 / (1 + sqrt(3) * I) - 1 / (1 - sqrt(3) * I), z, {}),
        [("sqrt(3)", "sqrt(0)"), ("- 1/(1", "- 3/(1")],
    ),
    "the case of one case": (
        lambda: disj_cases(
            assume(Or((proposition(x > 1),))),
            combined(x > 0, [assume(x > 1)], [S.One]),
        ),
        [("(0 < x)", "(2 < x)"), ("(1 < x) -> ", "")],
    ),
    "sines of sums": (
        lambda: identity(sin(3 * x), 3 * sin(x) - 4 * sin(x) ** 3),
        [("3*sin(x)", "2*sin(x)"), ("4*sin", "-4*sin"), ("sin(3*x)", "cos(3*x)")],
    ),
    "sines of sums of sums": (
        lambda: identity(2 * sin(x * (y + 1)) * cos(x), sin(x * (y + 2)) + sin(x * y)),
        [("= sin(x*y)", "= -sin(x*y)"), ("(y + 2)", "(y + 3)"), ("*cos(x) =", "*sin(x) =")],
    ),
    "a tangent": (
        lambda: identity(tan(x) ** 2 * cos(x) ** 2, 1 - cos(x) ** 2),
        [("1)", "2)"), ("(cos(x) <> 0) -> ", "")],
    ),
    "an exponential": (
        lambda: identity((exp(x) + exp(-x)) ** 2, exp(2 * x) + 2 + exp(-2 * x)),
        [("^2", "^3"), ("exp(-2*x)", "exp(2*x)"), ("2 +", "3 +")],
    ),
    "powers of e": (
        lambda: number(Relation((E - 1) / (exp(S.Half) - 1), "=", exp(S.Half) + 1)),
        [("(-1 + exp(1))", "(-2 + exp(1))"), ("= 1 +", "= 2 +"), ("exp(1))/", "exp(2))/")],
    ),
    "a root": (
        lambda: combined(
            proposition(y**2 < 3 * x), [assume(x > 0)], [assume(Relation(y**2, "<", 2 * x))]
        ),
        [("y^2 < 3*x)", "y^2 < x)"), ("(0 < x) -> ", "")],
    ),
    "j": (
        lambda: identity(exp(I * x) - exp(-I * x), 2 * I * sin(x)),
        [("2*Ci", "Ci"), ("Cexp(-Ci*x)", "Cexp(Ci*x)"), ("sin(x)", "cos(x)")],
    ),
    "a mirror": (
        lambda: mirrored(assume(Relation(exp(I * x), "=", I * y))),
        [("= -Ci*y", "= Ci*y"), ("(Cexp(-Ci*x)", "(Cexp(-2*Ci*x)")],
    ),
    "a mirror of what is not zero": (
        lambda: mirrored(assume(Relation(n + y * exp(I * x), "!=", S.Zero))),
        [
            ("+ y*Cexp(-Ci*x)", "- y*Cexp(-Ci*x)"),
            ("Cexp(-Ci*x)", "Cexp(-2*Ci*x)"),
            ("((n + y*Cexp(Ci*x) <> 0 :> C)%C) -> ", ""),
        ],
    ),
    "digits": (
        lambda: less(Rational(16568, 10000), 4 * tan(pi / 8)),
        [("2071/1250 <", "2072/1250 <"), ("2071/1250 <", "2071/1249 <"), ("4*sqrt", "3*sqrt")],
    ),
    "a sum of products": (
        lambda: combined(y > 0, [assume(x > 0)], [assume(y >= x)]),
        [("(0 < x) -> ", ""), ("-> (0 < y)", "-> (0 < y - x)"), ("(x <= y)", "(y <= x)")],
    ),
    "a factor": (
        lambda: factor(x, assume(Relation(S.Zero, "!=", x * y)), y),
        [("-> (x <> 0)", "-> (x - 1 <> 0)"), ("(0 <> x*y) -> ", "")],
    ),
    "whole numbers": (
        lambda: is_whole(2 * n + 1, assume(whole(n))),
        [("2*n + 1", "2*n - 1"), ("2*n + 1", "n/2 + 1"), ("(whole (n)) -> ", "")],
    ),
    "no whole number": (
        lambda: broken(Rational(5, 2)),
        [("5/2", "6/2"), ("5/2", "2")],
    ),
    "a growing function": (
        lambda: grows(
            x**3,
            x,
            S.One,
            y,
            combined(
                3 * x**2 > 0,
                [3, assume(x > 1), assume(x > 1)],
                [6, assume(x > 1)],
                [3, less(S.Zero, S.One)],
            ),
        ),
        [("(1 < y^3)", "(2 < y^3)"), ("(1 < y) -> ", ""), ("(1 < y^3)", "(y^3 < 1)")],
    ),
    "an increasing function": (
        lambda: increases(x**2, x, S.Zero, S(2), combined(2 * x > 0, [2, assume(x > 0)])),
        [("(0) (2)", "(-1) (2)"), ("x^2", "-x^2")],
    ),
    "a limit": (
        lambda: tends(sin(3 * x) / sin(x), x, S.Zero, S(3)),
        [("(0) (3)", "(0) (2)"), ("(0) (3)", "(1) (3)"), ("sin(3*x)", "sin(2*x)")],
    ),
    "a value": (
        lambda: tends(y * cos(x) - x, x, S.Zero, y),
        [("(0) (y)", "(0) (-y)"), ("cos", "sin")],
    ),
    "induction": (sum_of_whole, [("(whole (n)) -> ", "")]),
    "cases": (cases, [("0 <= x^2", "0 < x^2"), ("0 <= x^2", "1 <= x^2")]),
    "an instance": (
        lambda: undisch(
            spec(gen(disch(combined(2 * x > 0, [2, assume(x > 0)]), x > 0), x), {x: y + 1})
        ),
        [("(0 < y + 1) -> ", ""), ("0 < 2*y + 2", "0 < 2*y - 2")],
    ),
    "an instance at the angle 0": (
        lambda: spec(
            assume(
                ForAll(
                    (x,),
                    Implies((proposition(x >= 0), Relation(n + y * exp(I * x), "!=", S.Zero))),
                )
            ),
            {x: S.Zero},
        ),
        [("n + y <> 0", "n - y <> 0"), ("(0 <= x)", "(1 <= x)"), ("Ci*x", "Ci*(x + 1)")],
    ),
    "a symbol replaced": (
        lambda: inst(combined(2 * x > 0, [2, assume(x > 0)]), {x: y**2}),
        [("(0 < y^2) -> ", ""), ("0 < 2*y^2", "0 < 2*y")],
    ),
    "equals for equals": (
        lambda: subst(
            proposition(y > 1), y, assume(proposition(x > 1)), assume(Relation(x, "=", n))
        ),
        [("(x = n) -> ", ""), ("(1 < n)", "(2 < n)")],
    ),
    "an example": (chosen_number, [("1 < y", "2 < y"), ("1 < y", "y < 1")]),
    "an example in a sine": (
        sine_at_a_quotient,
        [("sin(x*y)", "sin(2*x*y)"), ("(0 < sin(n)) -> ", ""), ("sin(x*y)", "cos(x*y)")],
    ),
    "a contradiction": (
        lambda: not_intro(assume(x < y), assume(y <= x), x < y),
        [("(y <= x) -> ", ""), ("y <= x", "x <= y")],
    ),
    "a motion that gains": (
        lambda: gains((-1, 0, 1, 1, 0), [(1, 1)] * 4),
        [("(-1)", "(1)"), ("(-1)", "(-1/9)"), ("(0))", "(9))"), ("(~ (pass", "((pass")],
    ),
    "zeros inside": (
        lambda: roots_inside(z**2 - z / 2 + Rational(1, 3), z, {}),
        [("1/3", "4/3"), ("z/2", "5*z/2"), ("(stable", "(~ stable")],
    ),
    "zeros of many": (
        lambda: roots_inside(z**40 - z**39 + Rational(1, 50), z, {}),
        [("1/50", "1/20"), ("1/50", "0"), ("- z^39", "+ z^41"), ("z^40 -", "z^40/2 -")],
    ),
    "zeros that nearly touch the circle": (
        lambda: roots_inside((z**2 - 1 + Rational(1, 10**12)) * (z - exp(-1) / 2), z, {}),
        [("999999999999/1000000000000", "1"), ("exp(-1)/2", "3*exp(-1)")],
    ),
    "a zero outside": (
        lambda: root_outside(z**2 - z / 2 + Rational(4, 3), z),
        [("4/3", "1/3"), ("(~ (stable", "((stable")],
    ),
    "zeros in numbers with j": (
        lambda: roots_inside(z**2 - z * (exp(I) + exp(-I)) / 2 + Rational(1, 3), z, {}),
        [("1/3", "4/3"), ("Cexp(-Ci)", "5*Cexp(-Ci)")],
    ),
    "a limit of second order": (
        lambda: tends((1 - cos(x)) / x**2, x, S.Zero, Rational(1, 2)),
        [("(0) (1/2)", "(0) (1/3)"), ("cos(x)", "cos(2*x)"), ("/x^2", "/x^4")],
    ),
    "a real number with j": (
        lambda: axiom("square", exp(I * x) + exp(-I * x)),
        [("Cless_eq", "Cless"), ("Cexp(-Ci*x)", "Cexp(-2*Ci*x)"), ("Cexp(-Ci*x)", "-Cexp(-Ci*x)")],
    ),
    "a real factor": (
        lambda: factor(sin(x), assume(Relation(S.Zero, "!=", exp(I * x) - exp(-I * x))), 2 * I),
        [("-> (sin(x)", "-> (cos(x)"), ("- Cexp(-Ci*x)", "+ Cexp(-Ci*x)")],
    ),
    "a factor of a real number": (
        lambda: factor(y * exp(I * x), assume(Relation(S.Zero, "!=", y)), exp(-I * x)),
        [("(0 <> y)", "(0 <= y)"), ("*Cexp(Ci*x) <> 0", "*Cexp(Ci*x) <> y")],
    ),
    "complex equals": (
        lambda: subst(
            Relation(z, "!=", S.Zero),
            z,
            assume(Relation(X, "!=", S.Zero)),
            assume(Relation(X, "=", s)),
        ),
        [("(s <> 0", "(s <> 1"), ("(X = s", "(X = -s - 1")],
    ),
    "an angle over d + 1": (
        lambda: identity(cos(pi * y / (y + 1)), -cos(pi / (y + 1))),
        [("-cos", "cos"), ("-cos(PI/(y", "-cos(2*PI/(y"), ("= -cos", "= sin")],
    ),
    "an angle that has a known sine": (
        lambda: inst(combined(sin(x) < sin(x) + y, [assume(y > 0)]), {x: pi / 4}),
        [("(0 < y) -> ", ""), ("y + sqrt(2)/2", "y + sqrt(2)/3"), ("(sqrt(2)/2 <", "(sqrt(3)/2 <")],
    ),
    "a sine a quarter further": (
        lambda: inst(combined(sin(x) < sin(x) + y, [assume(y > 0)]), {x: pi / 2 - n}),
        [("y + cos(n)", "y - cos(n)"), ("(cos(n) <", "(sin(n) <")],
    ),
    "equals in a sine": (
        lambda: subst(
            proposition(x < sin(2 * y)),
            y,
            assume(proposition(x < 1)),
            assume(Relation(pi / 4, "=", n)),
        ),
        [("(PI/4 = n)", "(PI/3 = n)"), ("x < sin(2*n)", "x < sin(3*n)"), ("(x < 1) -> ", "")],
    ),
    "a growing function that divides": (
        lambda: grows(-1 / x, x, S.One, y, over(1 / x**2 > 0, one(), squared()), *apart()),
        [("-1 < -1/y", "-1 < -2/y"), ("(1 < y) -> ", "")],
    ),
    "above its start": (
        lambda: above_its_start(
            increases(-1 / x, x, S.One, S(3), over(1 / x**2 > 0, one(), squared()), *apart()),
            tends(-1 / x, x, S.One, S(-1)),
        ),
        [("(1 < x) -> ", ""), ("-1 < -1/x", "-1 < 1/x - 2"), ("(x < 3) -> ", "(x < 4) -> ")],
    ),
    "a limit that another excludes": (
        lambda: no_other_limit(
            tends(sin(3 * x) / sin(x), x, S.Zero, S(3)),
            number(Relation(S(3), "!=", S(2))),
        ),
        [("(0) (2)", "(0) (3)"), ("(~ (", "(("), ("sin(3*x)", "sin(2*x)")],
    ),
    "a zero between two signs": (
        lambda: crosses_zero(tends(x**2 - y, x, S.One, 1 - y), tends(x**2 - y, x, S(2), 4 - y)),
        [("(0 < -y + 4) -> ", ""), ("(-y + 1 < 0) -> ", ""), ("x^2 - y = 0", "x^2 + y = 0")],
    ),
    "a zero between two signs, beside a divisor": (
        lambda: crosses_zero(
            tends(x - 2 / x, x, S.One, S(-1)), tends(x - 2 / x, x, S(2), S.One), *apart()
        ),
        [("x < 2", "x < 1"), ("= 0", "= 1/2")],
    ),
    "no root enters": (
        entered,
        [
            ("(0 < x)", "(-1 < x)"),
            ("1 <= x^2", "1/2 <= x^2"),
            ("<= PI/2", "<= PI/3"),
            ("q <= 1)", "q <= 1/2)"),
            ("(stable (fun z : C => -p + z^2)%C) -> ", ""),
        ],
    ),
    "an order of exponentials": (
        lambda: combined(
            Relation(exp(I * x * (y + n)) + exp(-I * x * (y + n)), "<=", S(2)),
            [2, assume(Relation(cos(x * (y + n)), "<=", S.One))],
        ),
        [("(cos(x*(n + y)) <= 1) -> ", ""), ("Cexp(Ci*", "Cexp(2*Ci*"), ("(2)%C", "(1)%C")],
    ),
    "an imaginary number": (
        lambda: number(Relation(2 * I * pi, "!=", S.Zero)),
        [("2*Ci*PI", "0*Ci*PI"), ("<> 0", "<> 2*Ci*PI")],
    ),
    "a multiple of a complex number": (
        lambda: combined(
            Relation(-2 * z * y, "!=", S.Zero),
            [2, assume(Relation(z, "!=", S.Zero)), assume(Relation(y, "!=", S.Zero))],
        ),
        [("((z <> 0 :> C)%C) -> ", ""), ("(y <> 0) -> ", ""), ("-2*y*z <> 0", "-2*y*z <> -2")],
    ),
    "other units": (
        lambda: axiom("units", x, y, n, S.Zero, z, X, S(2), S(2), Rational(1, 4)),
        [("2*s*y", "3*s*y"), ("X/4", "X/3"), ("4*n", "2*n")],
    ),
    "a Toeplitz form": (
        lambda: toeplitz(x + y / z, z, n, theta),
        [("0 <= x + y", "0 <= x - y"), ("x + y/z", "x + y/z^2"), ("(theta < PI)", "(theta < 9)")],
    ),
    "an answer in numbers": (
        lambda: held_answer((1, 0, 0), (0, 0), s, 4, Rational(5, 18), (1, y, 0, 1, y**2 / 2, y), y),
        [("(5/18)", "(5/17)"), ("(9 <> 0)", "(9 <> 9)"), ("1/(s^2)", "1/(2*s^2)")],
    ),
    "no delay": (
        lambda: axiom("passive wall", x, y, n, S(2), S.Zero),
        [("(n/2)", "(n/3)"), ("x + y", "x - y"), ("(passive_wall (x)", "(passive_wall (y)")],
    ),
    "a box": (
        lambda: on_box(certificate(x - x**2 + Rational(1, 8), {x: (0, 1)})),
        [
            ("+ 1/8", "- 1/8"),
            ("(x <= 1)", "(x <= 2)"),
            ("(0 <= x) -> ", ""),
            ("-x^2 + x", "-5*x^2 + x"),
            ("-x^2 + x", "-x^2 - x"),
        ],
    ),
    "a box by slopes": (
        lambda: on_box(
            Positive(x - x**2 + Rational(1, 8), {x: (Rational(1, 4), Rational(3, 4))}, ":", 96)
        ),
        [("+ 1/8", "- 1/4"), ("(x <= 3/4)", "(x <= 5/4)"), ("(1/4 <= x) -> ", "")],
    ),
    "a box of plants": (
        lambda: on_plants(plants(Rational(1, 10) - M)),
        [
            ("n_0 - 2/5", "n_0 - 3/5"),
            ("n_0 - 2/5", "-n_0 - 2/5"),
            ("(delta <= 1/50)", "(delta <= 5)"),
            ("(device (gamma) (delta) (n_1) (n_0) (a) (e)) -> ", ""),
            ("(0 <= delta) -> ", ""),
        ],
    ),
    "a box of plants that just allows it": (
        lambda: on_plants(plants(Rational(1, 100) - M)),
        [
            ("n_0 - 49/100", "n_0 - 1/2"),
            ("n_0 - 49/100", "-n_0 + 49/100"),
            ("(gamma <= 1/1000)", "(gamma <= 1/2)"),
            ("(delta <= 1/50)", "(delta <= 1/20)"),
        ],
    ),
    "all numbers of a plant": (
        lambda: on_plants(plants(Rational(1, 10) - M - LOSS - P - AT_ONE)),
        [
            ("(0 < a", "(0 < -a"),
            ("+ n_1", "- n_1"),
            ("17/5", "18/5"),
            ("(gamma <= 1/1000)", "(gamma <= 1)"),
        ],
    ),
    "a cosine at a slope": (
        lambda: inst(
            combined(cos(x) < cos(x) + y, [assume(y > 0)]), {x: 2 * atan(Rational(1, 3)) / 2}
        ),
        [("y + 3*sqrt(10)/10", "y + 2*sqrt(10)/10"), ("(0 < y) -> ", "")],
    ),
    "a wall one period late": (
        lambda: axiom("passive wall", x, y, n, S(2), S.One),
        [("/z)%C", "/z^2)%C"), ("/z)%C", ")%C"), ("(n/2)", "(n/3)")],
    ),
    "what is not zero in real numbers": (
        lambda: identity((exp(I * x) - exp(-I * x)) / (2 * I * sin(x)), 1),
        [("(sin(x) <> 0) -> ", ""), ("Cexp(-Ci*x)", "Cexp(Ci*x)"), ("= 1 ", "= 2 ")],
    ),
    "a real number that is zero, times j": (
        lambda: combined(
            Relation(y * exp(I * x) - n * exp(I * x), "=", S.Zero),
            [assume(Relation(y, "=", n)), exp(I * x)],
        ),
        [("(y = n) -> ", ""), ("y*Cexp(Ci*x)", "-y*Cexp(Ci*x)"), ("n*Cexp(Ci*x)", "n*Cexp(-Ci*x)")],
    ),
    "a real relation from a complex one": (
        lambda: combined(
            Relation(S.Zero, "<", 2 * cos(x)),
            [assume(Relation(S.Zero, "<", exp(I * x) + exp(-I * x)))],
        ),
        [("2*cos(x)", "-2*cos(x)"), ("2*cos(x)", "2*sin(x)"), ("Cexp(-Ci*x)", "Cexp(-2*Ci*x)")],
    ),
    "a loop with poles apart": (
        lambda: loop((x, y, S(2), S.Zero, n), z),
        [
            ("+ 1) + (-y", "+ 2) + (-y"),
            ("(n + 1)", "(n + 2)"),
            ("^2/8", "^2/9"),
            ("(whole (n)) -> ", ""),
        ],
    ),
    "a loop with a damper": (
        lambda: loop((x, y, S.Zero, n, S.One), z, stiffness=False),
        [("(n <> 0) -> ", ""), ("exp(-n)", "exp(-2*n)"), ("-y + z", "y + z")],
    ),
    "a loop of a free mass": (
        lambda: loop((x, y, S.Zero, S.Zero, S(2)), z, stiffness=False, damping=False),
        [("1/2", "1/3"), ("z^3", "z^4"), ("(stable_loop (x) (y)", "(stable_loop (y) (x)")],
    ),
    "a loop at half a period": (
        lambda: loop_substituted((x, y, S.Zero, S.Zero, S.Half), z, 2, False, False),
        [("(1/2)", "(1/3)"), ("z^3", "z^2"), ("(stable_substituted", "(stable_loop")],
    ),
    "a loop whose poles turn by a quarter": (
        lambda: loop((S.Zero, S.Zero, pi**2 / 4, S.Zero, S.Zero), z),
        [
            ("z*(z^2 + 1)", "z*(z^2 - 1)"),
            ("(PI^2/4)", "(PI^2/9)"),
            ("stable_loop (0)", "stable_loop (1)"),
        ],
    ),
    "a loop whose poles are a nested root": (
        lambda: loop((x, y, sqrt(2), S(2), S.Zero), z),
        [("sqrt(-4 + 4*sqrt(2))", "sqrt(-4*sqrt(2) + 4)"), ("exp(-2)", "exp(-1)")],
    ),
    "a blow": (
        lambda: after_a_blow(known_device(), 1, 0, n, S.Zero, less(S.Zero, S.One)),
        [("0 < n_1", "0 < -n_1"), ("0 < n_1", "1 < n_1"), ("< PI^2) -> ", "< PI^3) -> ")],
    ),
    "a blow without a damper": (
        lambda: after_a_blow(
            assume(Predicate("device", (), (x, S.Zero, n_1, n_0, a, e))),
            -1,
            1,
            n,
            S.Zero,
            number(Relation(S.Zero, "<=", S.Zero)),
        ),
        [("n_0 - n_1", "n_1 - n_0 + 1"), ("(x < PI^2) -> ", ""), ("(x) (0)", "(x) (1)")],
    ),
    "a zero on the circle at 1": (
        lambda: zero_on_circle(z**2 - x, z, S.Zero, assume(Relation(1 - x, "=", S.Zero))),
        [("(-x + 1 = 0) -> ", ""), ("-x + z^2", "-2*x + z^2"), ("(~ (stable", "((stable")],
    ),
    "a quadratic by Jury's inequalities": (
        lambda: jury(z**2 + x * z + y, z),
        [("(0 < -y + 1)", "(0 < y + 1)"), ("x + y + 1", "x + y + 2"), ("x*z", "2*x*z")],
    ),
    "complex numbers that differ": (
        lambda: combined(
            Relation(z**2 - z, "!=", S.Zero),
            [assume(Relation(z, "!=", S.One)), assume(Relation(z, "!=", S.Zero))],
        ),
        [("((z <> 1 :> C)%C) -> ", ""), ("((z <> 0 :> C)%C) -> ", ""), ("z^2 - z", "z^2 - 2*z")],
    ),
    "a positive number in place of a complex one": (
        lambda: combined(Relation(z, "!=", S.Zero), [assume(Relation(S.Zero, "<", z))]),
        [("-> ((z <> 0", "-> ((z <> 1"), ("((Cless (0)%C (z)%C)) -> ", "")],
    ),
    "a real number that is a complex symbol": (
        lambda: spec(
            gen(disch(combined(x * y > 0, [assume(x > 0), assume(y > 0)]), x > 0, y > 0), x),
            {x: z},
        ),
        [("(Cless (0)%C (z)%C)", "(True)"), ("(Cless (0)%C (y*z)", "(Cless (1)%C (y*z)")],
    ),
    "an angle that becomes a quotient": (
        lambda: spec(
            assume(
                ForAll(
                    (x,),
                    Implies((proposition(x > 0), Relation(y + exp(I * n * x), "!=", S.Zero))),
                )
            ),
            {x: theta / n},
        ),
        [("y + Cexp(Ci*theta)", "y + Cexp(-Ci*theta)"), ("Cexp(Ci*n*x)", "Cexp(Ci*n^2*x)")],
    ),
    TENTH: (
        lambda: inst(combined(cos(pi / x) + y >= 0, [assume(y + cos(pi / x) >= 0)]), {x: S(10)}),
        [
            ("-> (0 <= sqrt(5)/8 + 5/8 /\\ 0 <= y", "-> (0 <= sqrt(5)/8 + 5/8 /\\ 1 <= y"),
            ("y + sqrt(sqrt(5)/8 + 5/8)) -> ", "y + sqrt(sqrt(5)/8 + 7/8)) -> "),
        ],
    ),
    "real parts of a product": (
        lambda: combined(
            cos(x + n) >= 0, [assume(Relation(S.Zero, "<=", re(exp(I * x) * exp(I * n))))]
        ),
        [("cos(n + x)", "sin(n + x)"), ("cos(n + x)", "cos(n - x)")],
    ),
    "zeros in a root of pi": (
        lambda: roots_inside(z**2 - z * sqrt(pi**2 - 9) / 2 + Rational(1, 3), z, {}),
        [("1/3", "4/3"), ("/\\ stable", "/\\ ~ stable"), ("-9 + PI^2", "-10 + PI^2")],
    ),
    "the last coefficient": (
        lambda: last_coefficient(assume(Predicate("stable", (z,), (z**3 - x * z + y,)))),
        [("y < 1", "x < 1"), ("-1 < y", "0 < y"), ("z^3", "z")],
    ),
    "a conjunction": (
        lambda: conj(assume(x > 0), assume(y > 0)),
        [("(0 < x) -> ", ""), ("-> ((0 < x)", "-> ((1 < x)")],
    ),
}


BEGIN = "From Symhaptic Require Import Control Boxes Zeros.\nSet Default Timeout 10.\n\n"
"""What is right is proved in a second; what is wrong some tactics do not give up for minutes."""


def file_of(theorem):
    page = SimpleNamespace(
        blocks=[SimpleNamespace(theorem=theorem, number=1, title="A step")], settled={}
    )
    return printed(SimpleNamespace(name="attack", title="An attack", page=page))


def variants(number, kind):
    """The lemmas of a theorem, and those of its wrong variants, under names of their own.

    What is wrong is written into the statement alone, and into its proof as well.
    """
    make, wrong = ATTACKS[kind]
    *before, target = file_of(make()).steps
    assert target.name == "lemma_1", (kind, target.why)
    texts = {f"kind_{number}_right": target.written()}
    for i, (old, new) in enumerate(wrong):
        assert old in target.statement, (kind, old, target.statement)
        other = replace(target, statement=target.statement.replace(old, new))
        texts[f"kind_{number}_{i}"] = other.written()
        lines = [line.replace(old, new) for line in target.lines]
        texts[f"kind_{number}_{i}_both"] = replace(other, lines=lines).written()
    body = "\n".join(s.written() for s in before)
    for name, text in texts.items():
        body += "\n" + regex.sub(rf"\b{target.name}\b", name, text)
    for step in before:
        body = regex.sub(rf"\b{step.name}\b", f"of_{number}_{step.name}", body)
    return body, {name: (kind, name) for name in texts}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """With the prelude compiled."""
    made = compiled.prepared(tmp_path_factory.mktemp("rocq"))
    compiled.prelude_compiled(made)
    return made


def test_other_roots_are_not_those_of_a_tenth_of_a_half_turn(folder):
    (lemma,) = (s for s in file_of(ATTACKS[TENTH][0]()).steps if s.name == "turn_by_a_tenth")
    wrong = [("-1/4 + sqrt(5)/4 /\\ cos", "1/4 + sqrt(5)/4 /\\ cos"), ("+ 5/8", "- 5/8")]
    for i, (old, new) in enumerate(wrong):
        other = replace(lemma, name=f"wrong_{i}", statement=lemma.statement.replace(old, new))
        assert other.statement != lemma.statement
        assert list(compiled.failing(folder, BEGIN + other.written())) == [other.name]


@pytest.mark.parametrize("kind", ATTACKS)
def test_what_is_wrong_in_one_place_is_refused(folder, kind):
    body, wanted = variants(list(ATTACKS).index(kind), kind)
    failed = compiled.failing(folder, f"{BEGIN}{body}\n")
    right = {n for n in wanted if n.endswith("right")}
    assert {wanted[n]: failed[n] for n in right & set(failed)} == {}
    assert [wanted[n] for n in wanted if n not in failed | dict.fromkeys(right)] == []


COVERED = on_box(Positive(x * y + 1 - x / 2, {x: (0, 1), y: (0, 2)}, "00..1..", 96))
"""On a box of two pieces, of which the lower is cut once more and the upper in y."""


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ('"00..1.."', '"00..1."'),  # a piece of which nothing is said
        ('"00..1.."', '"00..1..."'),  # and one that is none
        ('"00..1.."', '"00..2.."'),  # cut across what is no side
        ('"00..1.."', '"00..x.."'),
        ('"00..1.."', '""'),
        ('"00..1.."', '"0"'),
        ("(0, 1)", "(0, 1/2)"),  # a part of the box
        ("(0, 1)", "(1, 0)"),  # nothing of it
        ("(0, 1)", "(0, 4)"),  # more, of which it is not so
        ("(x :: y", "(y :: x"),  # sides of others
        ("(x :: y", "(y"),
    ],
)
def test_a_certificate_that_does_not_cover_the_box_is_refused(folder, right, wrong):
    [step] = file_of(COVERED).steps
    assert right in step.lines[-1]
    other = replace(step, name="other", lines=[line.replace(right, wrong) for line in step.lines])
    failed = compiled.failing(folder, f"{BEGIN}{step.written()}\n{other.written()}\n")
    assert set(failed) == {"other"}


UNKNOWN = (
    "RtoC 0",  # no polynomial that something leads
    "z - z + RtoC 0",
    "z - RtoC 1",  # a zero on the circle
    "z^3 + RtoC 1",
    "(z - RtoC 1/2)*(z - Ci)",
    "z - RtoC (tan (PI/4))",
    "RtoC 0*z^2 + z - RtoC 2",  # what seems to lead is nothing
    "z + RtoC 3/z",  # no polynomial
    "z + Cexp(z)",
    "Cconj z",
)
"""Of which neither is to be proved."""


def test_zeros_that_nothing_is_known_of_are_refused(folder):
    claims = {f"neither_{i}_{j}": f"{sign}stable (fun z : C => {wrong})%C"
              for i, wrong in enumerate(UNKNOWN) for j, sign in enumerate(["", "~ "])}  # fmt: skip
    claims["unstable"] = "stable (fun z : C => (fun w : C => w - RtoC 3) z)%C"
    claims["right"] = "stable (fun z : C => z - RtoC 1/2)%C"
    by = "Proof.\n  zeros 100%positive.\nQed.\n"
    text = "".join(f"Lemma {name} : {claim}.\n{by}" for name, claim in claims.items())
    assert set(compiled.failing(folder, f"{BEGIN}{text}")) == claims.keys() - {"right"}


FRACTIONS = {
    "x / x = 1": "x / x = x",
    "(x * / x) * (x - 1) = x - 1": "(x * / x) * (x - 1) = x",
    "(1 - cos y * cos y) / x = sin y * sin y / x": "(1 - cos y * cos y) / x = sin x * sin y / x",
    "sqrt y * sqrt y / x = y * / x": "sqrt y * sqrt y / x = sqrt y / x",
}
"""What is so of numbers x and y where x is not zero and y positive, and what is not."""


def test_a_fraction_is_nothing_where_it_divides_by_zero(folder):
    """Nor is a root of what may be negative one of which the square is known."""
    given = {"right": "x <> 0 -> 0 < y", "no_x": "x = x -> 0 < y", "no_y": "x <> 0 -> y < 1"}
    claims = {
        f"{name}_{i}{also}": f"forall x y : R, {so} -> {claim}"
        for i, both in enumerate(FRACTIONS.items())
        for also, claim in zip(("", "_wrong"), both, strict=True)
        for name, so in given.items()
    }
    by = "Proof.\n  intros; by_squares.\nQed.\n"
    text = "".join(f"Lemma {name} : {claim}.\n{by}" for name, claim in claims.items())
    taken = {f"right_{i}" for i in range(4)} | {f"no_y_{i}" for i in range(3)}
    assert claims.keys() - set(compiled.failing(folder, f"{BEGIN}{text}")) == taken


def test_inverses_are_names_where_only_sums_and_products_are_compared(folder):
    text = "".join(
        f"Lemma {name} : forall x y : R, {claim}.\nProof.\n  intros; polynomial.\nQed.\n"
        for name, claim in {
            "right": "(x + y) / y - x / y = y * / y",
            "no_inverse": "(x + y) / y = x / y + 1",
            "another": "x / (y + 1) = x / (y + 2)",
        }.items()
    )
    assert set(compiled.failing(folder, f"{BEGIN}{text}")) == {"no_inverse", "another"}


def test_the_checker_of_boxes_rests_on_the_library_alone(folder):
    """The axioms of the reals and primitive floats; nothing is believed of a device."""
    for kind in ("Fast", "Exact"):
        (folder / f"asked_{kind}.v").write_text(
            "From Symhaptic Require Import Boxes.\n"
            f"Definition both := ({kind}.boxed, {kind}.boxed_numbers).\nPrint Assumptions both.\n"
        )
        done = compiled._compiled(folder, f"asked_{kind}")
        assert done.returncode == 0, done.stderr
        assert assumptions.axioms(done.stdout) == set(foreign.LIBRARY)


def test_a_box_is_as_sharp_as_its_series_and_its_floats(folder):
    """The first number of a device, by its closed forms, beside its neighbours on both sides.

    The series with 15 terms and 53 bits decides the first, with 41 terms the second; the third
    needs floats of 120 bits.
    """
    with mpmath.workdps(60):
        soft, stiff = mpmath.mpf(3) / 10, mpmath.mpf(987) / 100
        turned = mpmath.sqrt(soft)
        first = {
            ("3/10", "0", 13): (1 - mpmath.cos(turned)) / soft,
            ("987/100", "0", 7): (1 - mpmath.cos(mpmath.sqrt(stiff))) / stiff,
            ("0", "1/50", 30): 2500 * (mpmath.exp(-mpmath.mpf(1) / 50) - 1) + 50,
        }
        claims = {}
        for i, ((g, d, digits), value) in enumerate(first.items()):
            below = int(mpmath.floor(value * 10**digits))
            for name, bound in ((f"right_{i}", below), (f"wrong_{i}", below + 1)):
                claims[name] = g, d, f"n_1 - {bound}/{10**digits}"
        claims["wrong_3"] = "11", "0", "n_1 - n_1 + 1"  # too stiff for 41 terms
    text = "".join(
        f"Lemma {name} : forall a delta e gamma n_0 n_1 : R, {g} <= gamma -> gamma <= {g} -> "
        f"{d} <= delta -> delta <= {d} -> device gamma delta n_1 n_0 a e -> 0 < {claim}.\n"
        f"Proof.\n  intros; of_device (@nil R) (gamma :: delta :: @nil R) "
        f'(({g}, {g}) :: ({d}, {d}) :: @nil (R * R)) ".".\nQed.\n'
        for name, (g, d, claim) in claims.items()
    )
    assert set(compiled.failing(folder, f"{BEGIN}{text}")) == {
        name for name in claims if name.startswith("wrong")
    }


def test_the_counter_of_zeros_rests_on_the_library_alone(folder):
    (folder / "counted.v").write_text(
        "From Symhaptic Require Import Zeros.\nDefinition both := (zeros_inside, zero_outside).\n"
        "Print Assumptions both.\n"
    )
    done = compiled._compiled(folder, "counted")
    assert done.returncode == 0, done.stderr
    assert assumptions.axioms(done.stdout) == set(foreign.LIBRARY)
