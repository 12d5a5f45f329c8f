"""Leaves and classical rules: each hypothesis that is dropped or weakened is refused."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy import Ne, Rational, S, cos, exp, pi, sin, symbols

from symhaptic.notation.proposition import (
    And,
    Exists,
    ForAll,
    Or,
    Predicate,
    Relation,
    both,
    implied,
    proposition,
    whole,
)
from symhaptic.notation.terms import NoTerm
from symhaptic.proof.box import positive as on_pieces
from symhaptic.proof.certificate import Known, Positive
from symhaptic.proof.theorems.analysis import (
    above_its_start,
    crosses_zero,
    grows,
    in_the_limit,
    increases,
    induction,
    no_other_limit,
)
from symhaptic.proof.theorems.definitions import gains, loop
from symhaptic.proof.theorems.energy import stored, toeplitz
from symhaptic.proof.theorems.familiar import (
    both_ways,
    bounded,
    divided,
    full_turns,
    magnitude,
    not_negative,
    rising,
    sign_of,
    square,
    strictly,
    whole_delay,
    with_rest,
)
from symhaptic.proof.theorems.kernel import NotShown, add_assum, assume, disch
from symhaptic.proof.theorems.leaves import (
    broken,
    combined,
    factor,
    identity,
    is_whole,
    mirrored,
    number,
    on_box,
    root_outside,
    roots_inside,
    tends,
)
from symhaptic.proof.theorems.roots import zero_on_circle
from symhaptic.proof.theorems.tactics import closed, over, positive, zero_beyond

x, y, n, z, theta, c, K = symbols("x y n z theta q K")


def lt(a: object, b: object) -> Relation:
    return Relation(sp.sympify(a), "<", sp.sympify(b))


ONE = number(lt(0, 1))


def refused(*attempts: object) -> None:
    for attempt in attempts:
        with pytest.raises((NotShown, NoTerm)):
            attempt()  # type: ignore[operator]


def test_identities() -> None:
    refused(
        lambda: identity(sp.sqrt(x**2), x),
        lambda: identity(sin(2 * x), 2 * sin(x)),
        lambda: identity(sp.log(x * y), sp.log(x) + sp.log(y)),
        lambda: identity((x**2) ** Rational(1, 2), sp.Abs(x)),
        lambda: identity(exp(sp.I * x) ** y, exp(sp.I * x * y)),
    )


def test_numbers() -> None:
    refused(
        lambda: number(lt(1, 0)),
        lambda: number(lt(0, 0)),
        lambda: number(lt(0, x)),
        lambda: number(And((lt(0, 1), lt(0, 2)))),
        lambda: number(lt(0, sp.I)),
        lambda: number(Relation(sp.pi, "=", Rational(355, 113))),
        lambda: number(Relation(sp.sqrt(2) ** 2, "!=", S(2))),
        lambda: number(lt(sp.I, 1 + sp.I)),
    )


def test_arithmetic_of_signs() -> None:
    p, q, weak, apart = assume(x > 0), assume(y > 0), assume(x >= 0), assume(Ne(x, 0))
    equal = assume(sp.Eq(x, y))
    refused(
        lambda: combined(Relation(x, "<", x)),
        lambda: combined(Relation(x, "!=", x)),
        lambda: combined(Relation(sp.sqrt(x), "<=", sp.sqrt(x))),
        lambda: combined(x > 0, [weak]),
        lambda: combined(x > 0, [apart]),
        lambda: combined(x > 0, [p], [-1, q]),
        lambda: combined(x - y > 0, [p], [S(-1), q]),
        lambda: combined(x * y > 0, [p, y]),
        lambda: combined(x > 0, [p, S.Zero]),
        lambda: combined(x > 0, [equal, 1]),
        lambda: combined(sp.Eq(x, 0), [weak]),
        lambda: combined(Ne(x + y, 0), [apart], [assume(Ne(y, 0))]),
        lambda: combined(Ne(x, 0), [weak]),
        lambda: combined(Ne(x, 0), [weak], [equal, 1]),
        lambda: combined(Relation(z, "<", x + z), [p]),
        lambda: combined(Relation(sp.I, "<", x + sp.I), [p]),
    )


def test_what_is_not_negative_is_no_equation() -> None:
    """The sides of 0 = x differ by x, of which x >= 0 does not say that it is 0."""
    for given in (assume(x >= 0), assume(x > 0)):
        with pytest.raises(NotShown, match="from equations only"):
            combined(Relation(S.Zero, "=", x), [given])


def test_only_relations_are_combined() -> None:
    no_relation = assume(Or((proposition(x > 0), proposition(y > 0))))
    with pytest.raises(NotShown, match="is no relation"):
        combined(x > 0, [no_relation])
    with pytest.raises(NotShown, match="is no relation"):
        combined(no_relation.conclusion, [assume(x > 0)])
    for claim in (x > 0, Or((proposition(x > 0),))):
        with pytest.raises(NotShown, match="is no equation"):
            mirrored(assume(claim))


def test_a_divisor_of_the_goal_is_open() -> None:
    claim = Relation(1 / y, "<", 1 / y + x)
    assert Relation(y, "!=", S.Zero) in combined(claim, [assume(x > 0)]).hypotheses


def test_quotients() -> None:
    p, q = assume(x > 0), assume(y > 0)
    refused(
        lambda: divided(x / y > 0, p, assume(y >= 0)),
        lambda: divided(x / y > 0, assume(x >= 0), q),
        lambda: divided(x / y > 0, p, assume(Ne(y, 0))),
        lambda: divided(y / x > 0, p, q),
        lambda: divided(-x / y > 0, p, q),
    )
    refused(
        lambda: factor(x, assume(x * y >= 0), y),
        lambda: factor(x, assume(sp.Eq(x * y, 0)), y),
        lambda: factor(x, assume(Ne(x + y, 0)), y),
    )
    refused(
        lambda: strictly(assume(x <= y), assume(Ne(x, 0))),
        lambda: strictly(assume(x < y), assume(x <= y)),
        lambda: both_ways(assume(x < y), assume(y <= x)),
    )
    assert Relation(y, "<=", x) in both_ways(assume(x <= y), assume(x <= y)).hypotheses


def test_elementary_functions() -> None:
    assert lt(0, x) in sign_of(sin, x).hypotheses
    assert lt(x, pi) in sign_of(sin, x).hypotheses
    assert {lt(-pi / 2, x), lt(x, pi / 2)} <= sign_of(cos, x).hypotheses
    assert Relation(S.Zero, "<=", x) in sign_of(sp.sqrt, x).hypotheses
    assert {lt(x, y), Relation(y, "<=", pi / 2)} <= rising(sin, x, y).hypotheses
    assert {Relation(S.Zero, "<=", x), Relation(y, "<=", pi)} <= rising(cos, x, y).hypotheses
    assert Relation(S.Zero, "<=", x) in magnitude(x).hypotheses
    assert Relation(x, "<=", S.Zero) in magnitude(x, negative=True).hypotheses
    refused(
        lambda: sign_of(exp, sp.I * x),
        lambda: sign_of(sp.log, x),
        lambda: sign_of(sp.tan, x),
        lambda: sign_of(exp, z),
        lambda: rising(sp.tan, x, y),
        lambda: rising(sp.cosh, x, y),
        lambda: bounded(sp.tan, x),
        lambda: bounded(cos, sp.I * x),
        lambda: square(z),
        lambda: square(sp.I),
    )
    # only where z is real, which the hypothesis says
    assert Relation(S.Zero, "<=", z) in magnitude(z).hypotheses


def test_whole_numbers() -> None:
    refused(
        lambda: is_whole(n),
        lambda: is_whole(Rational(1, 2)),
        lambda: is_whole(S(-1)),
        lambda: is_whole(n - 1, assume(whole(n))),
        lambda: is_whole(n / 2, assume(whole(n))),
        lambda: is_whole(n + x, assume(whole(n))),
        lambda: is_whole(n, assume(n >= 0)),
        lambda: is_whole(1 / n, assume(whole(n))),
        lambda: not_negative(assume(n > -1)),
        lambda: broken(S(2)),
        lambda: broken(n),
        lambda: broken(sp.pi),
    )


def test_boxes() -> None:
    certificate = on_pieces(x**2 - x + Rational(1, 2), {x: (0, 1)})
    assert on_box(certificate).hypotheses == {
        Relation(S.Zero, "<=", x),
        Relation(x, "<=", S.One),
    }
    refused(
        lambda: on_box(Positive(x - 1, {x: (S.Zero, S(2))}, ".", 96)),
        lambda: on_box(Positive(x, {x: (S.Zero, S.One)}, ".", 96, Known({x: sp.S(5)}))),
        lambda: on_box("x > 0"),
    )


def test_limits() -> None:
    found = tends(sin(c * x) / (c * x), x, S.Zero, S.One)
    assert any(c in p.free for p in found.hypotheses), "the divisor c x vanishes for c = 0"
    refused(
        lambda: tends(1 / x, x, S.Zero, S.Zero),
        lambda: tends(sin(x) / x, x, S.Zero, S.Zero),
        lambda: tends(sp.Abs(x) / x, x, S.Zero, S.One),
        lambda: tends(sp.sqrt(x), x, S.Zero, S.Zero),
        lambda: tends(sin(x) / x, x, S.Zero, x),
    )


def test_roots() -> None:
    refused(
        lambda: roots_inside(z**2 - 2, z, {}),
        lambda: roots_inside(z**2 - 1, z, {}),
        lambda: roots_inside(z**2 - y, z, {}),
        lambda: root_outside(z**2 - 1, z),
        lambda: root_outside(z**2 - Rational(1, 2), z),
    )
    refused(
        lambda: zero_beyond(z**2 - y, z, assume(1 - y > 0)),
        lambda: zero_beyond(y * z**2 - 2, z, assume(y - 2 <= 0)),
        lambda: zero_beyond(-(z**2) + Rational(1, 2), z, number(lt(Rational(-1, 2), 0))),
        lambda: zero_on_circle(z - 1, z, S.Zero, assume(sp.Eq(x, 0))),
        lambda: zero_on_circle(z - 2, z, sp.I, assume(sp.Eq(x, 0))),
    )


def test_increasing() -> None:
    slope = positive(2 * x > 0, [2, x > 0])
    rises = increases(x**2, x, S.Zero, S.One, slope)
    assert not rises.hypotheses
    # an end that divides by what may vanish
    assert increases(x, x, 1 / y, S(2), ONE).hypotheses == {proposition(sp.Ne(y, 0))}
    refused(
        # a slope that is known at one end of the interval only, or of something else
        lambda: increases(x**2, x, -S.One, S.One, slope),
        lambda: increases(x**3, x, S.Zero, S.One, slope),
        lambda: increases(x**2, x, S.Zero, S.One, positive(2 * x >= 0, [2, x >= 0])),
        lambda: increases(x**2, x, S.Zero, S.One, add_assum(slope, x < y)),
        # the tangent rises on both sides of its pole
        lambda: increases(
            sp.tan(x), x, S.Zero, pi, positive(1 + sp.tan(x) ** 2 > 0, [ONE], [square(sp.tan(x))])
        ),
        lambda: increases(-1 / x, x, -S.One, S.One, assume(1 / x**2 > 0)),
        lambda: increases(sp.sqrt(x), x, S.Zero, S.One, assume(1 / (2 * sp.sqrt(x)) > 0)),
        lambda: increases(sp.Abs(x), x, S.Zero, S.One, assume(sp.sign(x) > 0)),
        lambda: above_its_start(rises, tends(x**2, x, S.One, S.One)),
        lambda: above_its_start(rises, tends(x**3, x, S.Zero, S.Zero)),
        lambda: above_its_start(slope, tends(x**2, x, S.Zero, S.Zero)),
    )


def test_growing_from_one_value_to_another() -> None:
    slope = positive(2 * y > 0, [2, y > 0])
    start = grows(y**2, y, S.Zero, x, slope)
    assert start.hypotheses == {lt(0, x)}
    assert start.conclusion == lt(0, x**2)
    pole = assume(1 / y**2 > 0)
    refused(
        lambda: grows(y**2, y, -S.One, x, slope),
        lambda: grows(y**2, y, S.Zero, y, slope),
        lambda: grows(y**2, y, S.Zero, sp.I, slope),
        lambda: grows(y**3, y, S.Zero, x, slope),
        lambda: grows(-1 / y, y, -S.One, S.One, pole),
        lambda: grows(y**2, y, S.Zero, x, add_assum(slope, y < 1)),
    )
    # a divisor that vanishes at an end stays open, also where SymPy cancels it there
    beyond = positive(y > 0, x > 0, y > x)
    shown = closed(positive(Ne(y, 0), [y > 0]), beyond)
    steep = closed(over(1 / y**2 > 0, ONE, positive(y**2 > 0, [y > 0, y > 0])), beyond, shown)
    ends = grows(-1 / y, y, x, S.One, steep, shown)
    assert {Relation(x, "!=", S.Zero), lt(x, 1)} <= ends.hypotheses


def test_weak_in_the_limit() -> None:
    inside = positive(x * (1 - x) > 0, [x > 0, 1 - x > 0])
    end = tends(x * (1 - x), x, S.Zero, S.Zero)
    found = in_the_limit(kernel_cut(inside), x, S.Zero, S.One, end)
    assert found.conclusion == Relation(S.Zero, "<=", S.Zero)
    refused(
        lambda: in_the_limit(inside, x, S.Zero, S(2), end),
        lambda: in_the_limit(inside, x, S.Zero, S.One, tends(x, x, S.Zero, S.Zero)),
        lambda: in_the_limit(assume(Ne(x, 0)), x, S.Zero, S.One, end),
        lambda: in_the_limit(add_assum(inside, x < y), x, S.Zero, S.One, end),
    )


def test_a_limit_is_of_the_difference_and_at_an_end() -> None:
    """x (1 - x) > 0 on (0, 1), whose ends are no place of another limit, nor is the middle."""
    inside = kernel_cut(positive(x * (1 - x) > 0, [x > 0, 1 - x > 0]))
    half = Rational(1, 2)
    for end in (tends(x, x, S.Zero, S.Zero), tends(x * (1 - x), x, half, Rational(1, 4))):
        with pytest.raises(NotShown, match="no limit of"):
            in_the_limit(inside, x, S.Zero, S.One, end)


def test_between_two_signs_lies_a_zero() -> None:
    """Each hypothesis dropped: a limit, its sign, continuity between, ends in their order."""
    low, high = tends(x**2 - 2, x, S.One, -S.One), tends(x**2 - 2, x, S(2), S(2))
    found = crosses_zero(low, high)
    assert found.conclusion == Exists(
        (y,), And((lt(1, y), lt(y, 2), Relation(y**2 - 2, "=", S.Zero)))
    )
    assert found.hypotheses == {lt(-1, 0), lt(0, 2), lt(1, 2)}
    # a negative limit, a positive one and the order of the ends are asked for
    assert lt(2, 0) in crosses_zero(high, high).hypotheses
    assert lt(0, -1) in crosses_zero(low, low).hypotheses
    downwards = crosses_zero(tends(2 - x**2, x, S(2), -S(2)), tends(2 - x**2, x, S.One, S.One))
    assert lt(2, 1) in downwards.hypotheses
    # a pole between the ends changes the sign without a zero
    pole = tends(1 / x, x, -S.One, -S.One), tends(1 / x, x, S.One, S.One)
    refused(
        lambda: crosses_zero(*pole),
        lambda: crosses_zero(*pole, assume(Ne(x, 0))),
        lambda: crosses_zero(*pole, add_assum(assume(Ne(x, 0)), x < y)),
        # as does a step
        lambda: crosses_zero(tends(x / sp.Abs(x), x, -S.One, -S.One), high),
        # of two functions, or of one that is not real
        lambda: crosses_zero(low, tends(x**2 - 3, x, S(2), S.One)),
        lambda: crosses_zero(assume(limit_of(sp.I * x, -1)), assume(limit_of(sp.I * x, 1))),
        lambda: crosses_zero(assume(limit_of(sp.Function("f")(x), -1)), low),
        lambda: crosses_zero(
            *(assume(limit_of(sp.Function("f")(x), value)) for value in (-1, 1)),
        ),
        lambda: crosses_zero(found, high),
        lambda: crosses_zero(low, found),
    )
    # a divisor that is shown not to vanish between, and only there
    beyond = positive(Ne(x, 0), [x > 0])
    root = tends(x - 2 / x, x, S.One, -S.One), tends(x - 2 / x, x, S(2), S.One)
    open_ = crosses_zero(*root, closed(beyond, positive(x > 0, [x > 1], [1])))
    assert open_.hypotheses == {lt(-1, 0), lt(0, 1), lt(1, 2)}
    refused(lambda: crosses_zero(*root, beyond))


def limit_of(expr: sp.Expr, value: int) -> Predicate:
    """The limit at an end of (-1, 1), of the same sign."""
    return Predicate("limit", (x,), (expr, S(value), S(value)))


def kernel_cut(theorem: object) -> object:
    """x < 1 as the interval says it."""
    from symhaptic.proof.theorems.tactics import closed

    return closed(theorem, positive(1 - x > 0, x < 1))  # type: ignore[arg-type]


def test_induction() -> None:
    claim = proposition(n * (n + 1) >= 0)
    start = number(Relation(S.Zero, "<=", S.Zero))
    following = claim.at({n: n + 1})
    step = disch(assume(following), both([whole(n), claim]))
    refused(lambda: induction(claim, n, start, step))  # the step assumes what it shows
    refused(lambda: induction(claim, n, step, start))


def test_an_induction_begins_and_goes_on_with_its_claim() -> None:
    claim, other = proposition(n >= 0), Relation(S.Zero, "<=", S.Zero)
    step = disch(positive(n + 1 >= 0, [n >= 0], [ONE]), both([whole(n), claim]))
    start = number(other)
    assert induction(claim, n, start, step).conclusion == claim
    wrong = disch(assume(other), both([whole(n), other]))
    for begun, gone in ((ONE, step), (start, wrong), (start, start), (step, step)):
        with pytest.raises(NotShown, match="another claim"):
            induction(claim, n, begun, gone)


def test_the_angle_and_the_variable_of_an_energy_are_bound() -> None:
    for response, damping in ((K / z, theta), (K * theta / z, c)):
        with pytest.raises(NotShown, match="bound"):
            toeplitz(response, z, damping, theta)
    with pytest.raises(NotShown, match="bound"):
        toeplitz(K / y, y, y, theta)


def test_a_damping_is_real_by_its_form() -> None:
    for damping in (sp.I, sp.sqrt(c), c * sp.I):
        with pytest.raises(NotShown, match="not real by its form"):
            toeplitz(K / z, z, damping, theta)


def test_work_is_counted_at_a_rational_delay_of_a_rational_period() -> None:
    moves = [(1, 1)]
    for period, late in ((0, 0), (-1, 0), (1, -1), (sp.sqrt(2), 0), (1, sp.sqrt(2)), (y, 0)):
        with pytest.raises(NotShown, match="a rational period T > 0"):
            gains((-1, 0, 1, period, late), moves)


def test_energy() -> None:
    d = symbols("d")
    found = toeplitz(K * z**-d, z, c, theta)
    assert whole(d) in found.hypotheses
    assert whole(d) in whole_delay((K, 0, 1, 1, d)).hypotheses
    assert lt(0, y) in whole_delay((K, 0, 1, y, d)).hypotheses
    refused(
        lambda: toeplitz(K * exp(z), z, c, theta),
        lambda: toeplitz(K / (z - y), z, c, theta),
        lambda: toeplitz(sp.I * K / z, z, c, theta),
        lambda: toeplitz(K * z**-theta, z, c, theta),
        lambda: toeplitz(K / z, z, z, theta),
        lambda: gains((1, 0, 1, 1, 0), [(1, 1)]),
        lambda: gains((-1, 0, -1, 1, 0), [(1, 1)]),
        lambda: gains((-1, 0, 1, 1, 0), [(0, 1)]),
        lambda: gains((K, 0, 1, 1, 0), [(1, 1)]),
        lambda: loop((1, 1, x, y, 0), z, stiffness=False),
        lambda: loop((z, 1, x, y, 0), z),
    )
    assert not any(isinstance(p, ForAll) for p in found.hypotheses)
    assert isinstance(whole(d), Predicate)
    assert implied([], x > 0) == proposition(x > 0)


def test_full_turns() -> None:
    turns = assume(whole(n))
    found = full_turns(x, turns)
    assert Relation(sin(x + 2 * pi * n), "=", sin(x)) in found.conclusion.of  # type: ignore[attr-defined]
    assert found.hypotheses == {whole(n)}
    assert Relation(y, "!=", S.Zero) in full_turns(1 / y, turns).hypotheses
    refused(
        lambda: full_turns(x, assume(n >= 0)),
        lambda: full_turns(x, broken(Rational(1, 2))),
    )


def test_a_multiple_and_a_rest() -> None:
    found = with_rest(x, y, n)
    assert found.hypotheses == {proposition(x >= 0), lt(0, y)}
    assert whole(n) in found.conclusion.body.of  # type: ignore[attr-defined]
    refused(
        lambda: with_rest(n, y, n),
        lambda: with_rest(x, n * y, n),
    )


def test_a_limit_is_the_only_one() -> None:
    limit = tends(sin(x) / x, x, S.Zero, S.One)
    other = no_other_limit(limit, number(Relation(S.One, "!=", S.Zero)))
    assert other.conclusion.of[0].of[2] == 0  # type: ignore[attr-defined]
    refused(
        # apart from something else, or not apart, or no limit
        lambda: no_other_limit(limit, number(Relation(S(2), "!=", S.Zero))),
        lambda: no_other_limit(limit, assume(Relation(S.One, "=", S.Zero))),
        lambda: no_other_limit(limit, assume(Relation(S.One, "!=", x))),
        lambda: no_other_limit(assume(x > 0), number(Relation(S.One, "!=", S.Zero))),
    )


def test_a_store_does_not_matter() -> None:
    wall, nothing = (1, 0, 1, y, 0), identity(S.Zero, S.Zero)
    some = positive(c * x**2 >= 0, [c > 0, square(x)])
    found = stored(wall, x, some, nothing)
    assert found.hypotheses == {lt(0, c), lt(0, y), proposition(sp.Le(0, 0, evaluate=False))}
    full = positive(1 + x**2 >= 0, [S.One], [square(x)])
    refused(
        # a store that gives energy at rest, may be negative, jumps, or knows the speed
        lambda: stored(wall, x, full, nothing),
        lambda: stored(wall, x, full, identity(S.One, S.One)),
        lambda: stored(wall, x, assume(c * x >= 0), nothing),
        lambda: stored(wall, x, sign_of(sp.Abs, x), nothing),
        lambda: stored(wall, x, positive(c * x**2 > 0, [c > 0, x > 0, x > 0]), nothing),
        lambda: stored((x, 0, 1, 1, 0), x, some, nothing),
    )


def test_a_store_is_of_the_speed_alone() -> None:
    some, nothing = positive(c * x**2 >= 0, [c > 0, square(x)]), identity(S.Zero, S.Zero)
    for wall in ((x, 0, 1, y, 0), (1, 0, 1, y, x), (1, 0, 1, y)):
        with pytest.raises(NotShown, match="a wall K, B, b, T, d without x"):
            stored(wall, x, some, nothing)


def test_a_zero_on_the_circle_has_a_real_angle() -> None:
    """z - 1/e has a zero at exp(j j), which is inside."""
    inside = z - exp(-1)
    zero = identity(inside.xreplace({z: exp(sp.I * sp.I)}), S.Zero)
    with pytest.raises(NotShown, match="not real by its form"):
        zero_on_circle(inside, z, sp.I, zero)


def test_a_motion_in_algebraic_numbers() -> None:
    """Four steps against K = -sqrt(3), b = 1 leave 4 - 6 sqrt(3); K = -2/3 leaves nothing."""
    steps = 4 * [(1, 1)]
    assert not gains((-sp.sqrt(3), 0, 1, 1, 0), steps).hypotheses
    refused(
        lambda: gains((-Rational(2, 3), 0, 1, 1, 0), steps),
        lambda: gains((sp.sqrt(3) - sp.sqrt(3 + c), 0, 1, 1, 0), steps),
        lambda: gains((-1, 0, -sp.sqrt(3), 1, 0), steps),
        lambda: gains((-1, 0, sp.sqrt(-1), 1, 0), steps),
    )


def test_what_has_no_value_is_itself_only_under_a_condition_that_is_false():
    never = sin(x) ** 2 + cos(x) ** 2 - 1
    assert identity(1 / never, 1 / never).hypotheses == {Relation(never, "!=", S.Zero)}
