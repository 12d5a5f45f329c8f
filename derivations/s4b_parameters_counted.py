r"""Why do seven parameters become five?

The loop has seven physical parameters. Their units decide how many of them can be removed by a
choice of units, and how many numbers must remain.
"""

from sympy import Integer, Matrix, Rational

from symhaptic.notation import SYMBOLS, TABLE_I, K, T, alpha, b, beta, d, delta, gamma, k, m, t_d
from symhaptic.notation import B as VIRTUAL_DAMPING


def derive(page):
    names = [row.variable for row in TABLE_I]
    powers = [[Rational(p) for p in SYMBOLS[name].dimension] for name in names]
    page.table(
        "Powers of kilogram, metre and second in the units of Table I.",
        ["", *(f"${name}$" for name in names)],
        [
            [unit, *(row[i] for row in powers)]
            for i, unit in enumerate(("kilogram", "metre", "second"))
        ],
    )
    rank = Integer(Matrix(powers).rank())
    page.say(
        "A product of powers of the seven is a pure number if the powers of all three units "
        "vanish. The three equations for the seven exponents have the rank"
    )
    page.step(
        "The rank of the table",
        rank,
        Integer(2),
        because="the metre drops out: with it every force and every length would only be scaled",
    )
    left = page.step(
        "Independent pure numbers",
        len(names) - rank,
        Integer(5),
        because="parameters minus rank (Buckingham)",
    )
    groups = {
        d: t_d / T,
        alpha: K * T**2 / m,
        beta: VIRTUAL_DAMPING * T / m,
        gamma: k * T**2 / m,
        delta: b * T / m,
    }
    for name, group in groups.items():
        page.define("A pure number", name, group)
    page.say("Each of them has a parameter that the others have not: they are independent.")
    page.settle(
        "s4b-seven-to-five",
        page.same("five are left", left, Integer(len(groups))),
        note="no choice of units leaves fewer than five",
    )
