"""The claims of Sec. II and IV-A to IV-C: wall, delay, device and arm.

The discrete equivalent of (12) is a claim for every z: a force z^k that is held during period k
moves the device at sample k to X z^k, and X is the equivalent at z. This excludes poles, because
there is no such X.
"""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import F_E, T_s, X, X_d, c_1, c_2, c_3, d_1, d_2, function
from symhaptic.paper.propositions.prelude import *

DEVICE = (m, b, k, T)
GIVEN = (T > 0, m > 0, b >= 0, k >= 0)
NUMBERS = (c_1, c_2, c_3)
p, q = Symbol("p"), Symbol("q")


def whole(value: Expr) -> Predicate:
    """``value`` is an integer that is not negative."""
    return Predicate("whole", (), (value,))


TABLE = {rule.lhs: rule for rule in transcribed("tab1")}
"""The rules of Table I."""
WALL = transcribed("eq1")[0].rhs
"""H(z) of (1)."""
PLANT = transcribed("eq12")[0].lhs
"""1/(m s^2 + b s + k)."""


def answers(response: Expr, answer: Expr, period: Expr = T) -> Predicate:
    """``answer`` is the response of a device with this transfer function to a held force z^k."""
    return Predicate("answers", (s,), (response, z, answer, period))


def normalised(*symbols: Symbol) -> list[Expr]:
    """The rules of Table I for these symbols."""
    return [TABLE[symbol] for symbol in symbols]


def held(symbols: Sequence[Symbol], given: Sequence[object], then: object) -> Proposition:
    """A claim for every device, period and z, where X is the response of the device."""
    over = (*DEVICE, *symbols, z, X)
    return ForAll(over, implied([*GIVEN, *given, answers(PLANT, X)], then))


# -- Sec. IV-A and IV-B: the sampled device and the loop --------------------------------------


@claims("eq12")
def _sampled_device(printed: Printed) -> Proposition:
    """With (13), the right side is the response of the device on the left."""
    [line] = printed
    then = Relation(X, "=", line.rhs)
    given = [*GIVEN, *transcribed("eq13"), answers(line.lhs, X)]
    return ForAll((*DEVICE, *NUMBERS, z, X), implied(given, then))


@claims("eq14")
def _sampled_device_in_units(printed: Printed) -> Proposition:
    """The claim of (12) in the parameters of Table I, with (15)."""
    [line] = printed
    given = [*GIVEN, *normalised(gamma, delta), *transcribed("eq15"), answers(line.lhs, X)]
    over = (*DEVICE, gamma, delta, *NUMBERS, z, X)
    return ForAll(over, implied(given, Relation(X, "=", line.rhs)))


@claims("eq15")
def _abbreviations(printed: Printed) -> Proposition:
    """In the parameters of Table I, the abbreviations (13) are these."""
    given = [*GIVEN, *normalised(gamma, delta), *transcribed("eq13")]
    over = (*DEVICE, gamma, delta, *NUMBERS)
    return ForAll(over, implied(given, both(printed)))


@claims("s4a-delay-equivalent")
def _sampled_delay(printed: Printed) -> Proposition:
    """In front of the device, the left side is the right side after the samples; T_s is a time."""
    [line] = printed
    given = [d >= 0, T_s > 0, answers(line.lhs * PLANT, X_d)]
    return held((d, T_s, X_d), given, Relation(X_d, "=", line.rhs * X))


@claims("s2c-positive-delay")
def _not_negative(printed: Printed) -> Proposition:
    """The delay t_d >= 0 is not negative in periods either; zero is allowed, as in Fig. 7."""
    return ForAll((t_d, T), implied([t_d >= 0, T > 0], t_d / T >= 0))


SUBSTITUTED = (p, q, alpha, beta, n_1, n_0, a, e)
"""A delay of p/(q + 1) periods, a wall and a device, in the parameters of Table I."""


@claims("s2c-rational-delay")
def _rational_delay(printed: Printed) -> Proposition:
    """With d = p/(q + 1) and z = w^(q + 1), z^-d is w^-p; this is an approximation.

    The polynomial of the loop then has integer exponents only, with the highest one p + 3 (q + 1).
    For some device, the response to a held force that is delayed by d periods is not z^-d times the
    undelayed response.
    """
    fine = w ** (q + 1)
    below, above = fine**2 - a * fine + e, n_1 * fine + n_0
    loop = w ** (p + q + 1) * below + above * ((alpha + beta) * fine - beta)
    degree = Predicate("degree", (w,), (sp.expand(sp.powsimp(sp.expand(loop))), p + 3 * (q + 1)))
    whole_delay = ForAll(SUBSTITUTED, implied([whole(p), whole(q)], degree))
    return both([whole_delay, Exists((*DEVICE, d, z, X, X_d), both(approximated()))])


def approximated() -> list[Proposition]:
    """The response of a device to a delayed held force is not z^-d times the undelayed response."""
    given = [*GIVEN, d >= 0, answers(PLANT, X), answers(delayed(PLANT), X_d)]
    return [*map(proposition, given), Relation(X_d, "!=", z**-d * X)]


@claims("s4a-exact-instants")
def _exact_at_the_samples(printed: Printed) -> Proposition:
    """The loop has the same response to a held external force with z^-d in place of the delay."""
    real, replaced = 1 + X_d * WALL, 1 + z**-d * X * WALL
    apart = [Relation(gain, "!=", sp.S.Zero) for gain in (real, replaced)]
    given = [d >= 0, answers(delayed(PLANT), X_d), *apart]
    return held((K, B, d, X_d), given, Relation(X / real, "=", X / replaced))


def delayed(response: Expr, late: Expr = d * T) -> Expr:
    """The transfer function of a delay."""
    return sp.exp(-late * s) * response


def closed_loop(transfer: Expr, top: Expr, bottom: Expr, late: Expr = d) -> Proposition:
    """G_x is X/(1 + X_d H): position over the external force, which is also held.

    X_d is the response to the force of the wall, which is delayed by d periods.
    """
    n, p = (function(name)(z) for name in ("n", "p"))
    form = transfer.xreplace({n: top, p: bottom}).xreplace({d: late})
    symbols = (K, B, *([d] if late == d else []), *TABLE_SYMBOLS, *NUMBERS, X_d)
    gain = 1 + X_d * WALL
    given = [
        *([d >= 0] if late == d else []),
        *normalised(*TABLE_SYMBOLS),
        *transcribed("eq15"),
        answers(delayed(PLANT, late * T), X_d),
        Relation(gain, "!=", sp.S.Zero),
    ]
    return held(symbols, given, Relation(X / gain, "=", form))


TABLE_SYMBOLS = (alpha, beta, gamma, delta)


def _side(id: str) -> Expr:
    return transcribed(id)[0].rhs


@claims("eq16")
def _closed_loop(printed: Printed) -> Proposition:
    """The closed loop with n of (17) and p of (18)."""
    return closed_loop(printed[0].rhs, _side("eq17"), _side("eq18"))


@claims("eq17")
def _numerator(printed: Printed) -> Proposition:
    """n is the numerator of (16). It does not contain the delay, so (16) is read without delay."""
    return closed_loop(_side("eq16"), printed[0].rhs, _side("eq18"), sp.S.Zero)


@claims("eq18")
def _characteristic_polynomial(printed: Printed) -> Proposition:
    """p is the denominator of (16)."""
    return closed_loop(_side("eq16"), _side("eq17"), printed[0].rhs)


# -- what the loop depends on --------------------------------------------------------------


@claims("s2c-delays-lump")
def _delays_add_up(printed: Printed) -> Proposition:
    """A loop with several delays has the characteristic equation of their sum d.

    The force is delayed by d_1 periods, the reading of the position by d_2, and the computation
    takes l periods; d_1 and d_2 are real, and l is an integer. X is the response of the device with
    the delays d_1 and d_2, so that the loop has the equation 1 + X z^-l H(z) = 0. X_d is the
    response with the delay d. For a device (n_1 z + n_0)/(z^2 - a z + e) in the units of Table I,
    with z^-d_1 at the wall and z^-d_2 at the device, the polynomial without divisors is (18) for
    d_1 + d_2.
    """
    given = [
        *(delay >= 0 for delay in (d_1, d_2)),
        whole(l),
        Relation(d, "=", d_1 + d_2 + l),
        answers(delayed(PLANT, (d_1 + d_2) * T), X),
        answers(delayed(PLANT), X_d),
    ]
    same = Relation(1 + X * z**-l * WALL, "=", 1 + X_d * WALL)
    below, above = z**2 - a * z + e, n_1 * z + n_0
    push = (alpha + beta * (z - 1) / z) * z**-d_1
    total = d_1 + d_2
    two = (below + above * z**-d_2 * push) * z ** (total + 1)
    one = below * z ** (total + 1) + above * ((alpha + beta) * z - beta)
    cleared = ForAll((a, e, n_1, n_0, alpha, beta), Relation(two, "=", one))
    over = (*DEVICE, K, B, d, d_1, d_2, l, z, X, X_d)
    return ForAll(over, implied([*GIVEN, *given], both([same, cleared])))


@claims("s2d-arm-in-force")
def _arm_in_the_force(printed: Printed) -> Proposition:
    """(2) with F_E and (3) with F_E less the force on the arm give the same motion, for every s."""
    held, free = ({line.lhs: line.rhs for line in transcribed(id)} for id in ("eq2", "eq3"))
    need = m * s**2 + b * s + k
    arm = (m_H * s**2 + b_H * s + k_H) * X
    given = [m_D > 0, *(part >= 0 for part in (b_D, m_H, b_H, k_H))]
    both_ways = Iff(
        (
            Relation(need.xreplace(held) * X, "=", F_E),
            Relation(need.xreplace(free) * X, "=", F_E - arm),
        )
    )
    return ForAll((m_D, b_D, m_H, b_H, k_H, F_E, s, X), implied(given, both_ways))


UNIT_PLANT = 1 / (s**2 + delta * s + gamma)
"""The device in units of its mass and of the period."""


@claims("s4b-seven-to-five")
def _seven_to_five(printed: Printed) -> Proposition:
    """A loop is equivalent to the loop of mass and period 1 with the five numbers of Table I.

    The wall and 1/X are in units of m/T^2.
    """
    unit = alpha + beta * (z - 1) / z
    scaled = answers(delayed(UNIT_PLANT, d), m / T**2 * X, sp.S.One)
    same = Iff((answers(delayed(PLANT, t_d), X), scaled))
    wall = Relation(WALL * T**2 / m, "=", unit)
    table = normalised(d, *TABLE_SYMBOLS)
    over = (*DEVICE, K, B, t_d, d, *TABLE_SYMBOLS, z, X)
    given = [*GIVEN, t_d >= 0, *table, Relation(z, "!=", sp.S.Zero)]
    return ForAll(over, implied(given, both([same, wall])))


SECOND = {v: Symbol(f"{v.name}_2") for v in (*DEVICE, K, B, t_d)} | {X: X_d}
"""Another loop."""


@claims("s4b-five-parameters")
def _five_parameters(printed: Printed) -> Proposition:
    """Two loops with the same five numbers have the same product of device, delay and wall.

    p(z) vanishes where this product is -1.
    """
    table = normalised(d, *TABLE_SYMBOLS)
    sides = [*GIVEN, t_d >= 0, *table, answers(delayed(PLANT, t_d), X)]
    others = [proposition(g).at(SECOND) for g in sides]
    here, there = X * WALL, (X * WALL).xreplace(SECOND)
    over = (*SECOND, *SECOND.values(), d, *TABLE_SYMBOLS, z)
    return ForAll(over, implied([*sides, *others], Relation(here, "=", there)))


@claims("s4d-degree")
def _degree(printed: Printed) -> Proposition:
    """The degree of p of (18), for every device and delay."""
    given = [gamma >= 0, delta >= 0, d >= 0, *transcribed("eq15")]
    degree = Predicate("degree", (z,), (_side("eq18"), d + 3))
    return ForAll((alpha, beta, gamma, delta, d, *NUMBERS), implied(given, degree))
