"""No zero enters the right half of what lies outside the circle: each hypothesis is needed."""

import numpy as np
import pytest
import sympy as sp
from sympy import I, Ne, Rational, S, exp, pi, symbols

from symhaptic.notation import z
from symhaptic.notation.proposition import (
    And,
    ForAll,
    Implies,
    Not,
    Predicate,
    Relation,
    proposition,
    whole,
)
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.roots import none_enters
from symhaptic.proof.theorems.tactics import at, every

v, q, t, x, y, n, p = symbols("v q t x y n p")
OVER = (v, q, t, x, y)
PART, LESS, AHEAD, QUARTER = map(proposition, (q > 0, q <= 1, t > 0, t <= pi / 2))
BORDER = (I * t, S.Zero, t + I * pi / 2)
KNOWN = ([PART, LESS, AHEAD, QUARTER], [PART, LESS], [PART, LESS, AHEAD])
RNG = np.random.default_rng(1949)


def stable(polynomial):
    return Predicate("stable", (z,), (sp.sympify(polynomial),))


def path(polynomial, change, w):
    """p(v^2) + q g(v) at v = exp(w)."""
    late = sp.Add(*(f * exp(2 * e * w) for e, f in powers(polynomial, z)))
    return late + q * sp.Add(*(f * exp(e * w) for e, f in powers(change, v)))


def powers(of, variable):
    for part in sp.Add.make_args(sp.expand(of)):
        factor, power = part.as_independent(variable, as_Add=False)
        yield power.as_base_exp()[1] if power != 1 else S.Zero, factor


def shown(polynomial, change, known=KNOWN):
    """The three premises, each from a closed hypothesis that says so where it may be asked."""
    for w, given in zip(BORDER, known, strict=True):
        claim = every([q, t], given, Ne(path(polynomial, change, w), 0, evaluate=False))
        yield at(assume(claim), {q: q, t: t}, *map(assume, given))


def entered(polynomial, change, over=OVER, known=KNOWN):
    return none_enters(assume(stable(polynomial)), change, over, *shown(polynomial, change, known))


def value(conclusion, **there):
    return complex(sp.N(conclusion.body.of[1].left.subs({x: there["x"], y: there["y"]})))


def test_what_it_says():
    found = entered(z**2 - p, p * v**3)
    outside = And((proposition(x > 0), Relation(S.One, "<=", x**2 + y**2)))
    assert isinstance(found.conclusion, ForAll)
    assert found.conclusion.over == (x, y)
    assert found.conclusion.body.of[0] == outside
    left = found.conclusion.body.of[1].left
    assert sp.expand(left - (x + I * y) ** 4 + p - p * (x + I * y) ** 3) == 0
    # the polynomial, and the three that are closed: nothing is left of the share or the place
    assert len(found.hypotheses) == 4
    assert stable(z**2 - p) in found.hypotheses
    assert not {q, t} & set().union(*(h.free for h in found.hypotheses))


EDGES = {
    "half circle": np.exp(1j * np.linspace(1e-3, np.pi / 2, 2000)),
    "at 1": np.array([1.0]),
    "axis": 1j * np.exp(np.linspace(1e-3, 5, 2000)),
}


def crosses(late, change, edge):
    """Whether f + q g, 0 < q <= 1, is zero near one of these: there -f/g is real, in (0, 1]."""
    shares = -np.polyval(late, edge) / np.polyval(change, edge)
    if len(edge) == 1:
        return bool(0 < shares.real[0] <= 1)
    # the imaginary part changes its sign through zero, or is zero all along
    real = np.abs(shares.imag[1:]) <= np.abs(np.diff(shares.imag)) + 1e-12
    return bool((real & (shares.real[1:] > 0) & (shares.real[1:] <= 1.01)).any())


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_where_the_border_is_free_of_zeros_there_are_none_to_the_right(degree):
    """Random p with its zeros inside, and random g: all zeros of p(v^2) + g(v), by numpy."""
    seen = left = 0
    for _ in range(400):
        late = np.zeros(2 * degree + 1)
        late[::2] = np.poly(RNG.uniform(-0.9, 0.9, degree))
        change = RNG.normal(size=2 * degree) * RNG.choice([0.3, 2.0])
        if any(crosses(late, change, edge) for edge in EDGES.values()):
            continue
        zeros = np.roots(np.polyadd(late, change))
        seen += 1
        left += (np.abs(zeros) > 1).any()
        assert not (np.abs(zeros[zeros.real > 0]) >= 1).any()
    assert seen > 20
    assert left > 3 or degree == 1  # the rule is not about the whole circle


def test_exponents_in_symbols_are_whole_by_hypothesis():
    found = entered(z ** (n + 2) - p, v**3)
    assert {whole(n + 2), whole(n)} <= found.hypotheses
    assert whole(2 * n + 4) in found.hypotheses


@pytest.mark.parametrize(
    ("polynomial", "change"),
    [
        (2 * z**2 - p, v),  # not monic
        (z**2 - p, v**4),  # no lower degree
        (z**2 - p, v**5),
        (z**n - p, v),  # n may be 0
        (z**2 - I * p, v),  # not real
        (z**2 - p, I * v),
        (z**2 - p, 1 / v),  # no polynomial
        (z**2 - 1 / z, v),
        (z ** Rational(5, 2) - p, v),
        (z**2 - x, v),  # x and y are bound
        (z**2 - p, y * v),
        (z**2 - q, v),  # and so are the share and the place
        (z**2 - p, t * v),
    ],
)
def test_what_is_no_path_of_real_polynomials_is_refused(polynomial, change):
    with pytest.raises(NotShown):
        entered(polynomial, change)


@pytest.mark.parametrize("dropped", range(3))
def test_each_part_of_the_border_is_needed(dropped):
    """One premise is about another place: of each there is a p and a g with a zero that enters."""
    premises = list(shown(z**2 - p, p * v))
    premises[dropped] = assume(Ne(path(z**2 - p, p * v, I * t + 1), 0))
    with pytest.raises(NotShown):
        none_enters(assume(stable(z**2 - p)), p * v, OVER, *premises)
    del premises[dropped]
    with pytest.raises((NotShown, ValueError)):
        none_enters(assume(stable(z**2 - p)), p * v, OVER, *premises)


@pytest.mark.parametrize(
    ("place", "less"),
    [
        (0, proposition(t <= pi / 3)),
        (0, proposition(q <= Rational(1, 2))),
        (1, proposition(q <= Rational(1, 2))),
        (2, proposition(t > 1)),
        (2, proposition(t <= 1)),
    ],
)
def test_a_premise_that_knows_more_of_the_place_is_refused(place, less):
    known = list(KNOWN)
    known[place] = [*known[place], less]
    with pytest.raises(NotShown, match="is about"):
        entered(z**2 - p, p * v, known=known)


@pytest.mark.parametrize(
    ("where", "change"),
    [
        ("half circle", [-2.0, 2.1, 0.0, 0.0]),  # v^2 (v^2 - 2 q v + 2.1 q)
        ("at 1", [-2.0, 0.0, 0.0, 0.0]),  # v^3 (v - 2 q)
        ("axis", [-2.0, 9.0, -3.0, -1.0]),  # two go around to the left
    ],
)
def test_through_each_part_of_the_border_alone_zeros_do_enter(where, change):
    """v^4 + q g begins with all zeros at 0; at q = 1 two, or one, are to the right and outside."""
    change = np.array(change)
    crossed = {name for name, at_ in EDGES.items() if crosses([1, 0, 0, 0, 0], change, at_)}
    assert crossed == {where}
    zeros = np.roots(np.polyadd([1, 0, 0, 0, 0], change))
    assert (np.abs(zeros[zeros.real > 0]) > 1.3).any()


@pytest.mark.parametrize(
    "over", [(v, q, t, x, x), (v, q, q, x, y), (v, q, t, z, y), (v, q, t, v, y), (q, q, t, x, y)]
)
def test_symbols_are_of_their_own_and_real(over):
    with pytest.raises(NotShown):
        entered(z**2 - p, p * v, over=over)


@pytest.mark.parametrize(
    "theorem", [assume(Not((stable(z**2 - p),))), assume(proposition(x < y)), assume(whole(n))]
)
def test_the_path_begins_with_zeros_inside(theorem):
    with pytest.raises(NotShown):
        none_enters(theorem, p * v, OVER, *shown(z**2 - p, p * v))
    # p(v^2) + 0 would have the zeros +-2: the conclusion is false of it, and so is the hypothesis
    claim = entered(z - 4, S.Zero).conclusion
    assert isinstance(claim.body, Implies)
    assert value(claim, x=2, y=0) == 0
