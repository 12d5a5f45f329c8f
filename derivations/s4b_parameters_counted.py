"""Why do five of the seven parameters remain?

The loop has seven physical parameters. We count how many of them can be removed by a choice of
units.
"""

from sympy import Matrix, zeros

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.units import SEVEN, in_own_units, scaled_wall
from symhaptic.notation import SYMBOLS, TABLE_I


def derive(page):
    names = [row.variable for row in TABLE_I]
    powers = Matrix([[Integer(power) for power in SYMBOLS[name].dimension] for name in names])
    head = ["", *(f"${name}$" for name in names)]
    units = ("kilogram", "metre", "second")
    page.table(
        "Powers of the units in the parameters of Table I.",
        head,
        [[unit, *powers.col(i)] for i, unit in enumerate(units)],
    )
    page.say(
        "A product of powers of the seven parameters is dimensionless if the exponents of all "
        "three units vanish. These are three equations for seven exponents."
    )
    rank = page.step(
        "The units of the seven parameters have rank two",
        Integer(powers.rank()),
        Integer(2),
        name=r"\text{rank}",
        because="the metre does not occur, since a linear loop contains force and length only as a "
        "ratio",
    )
    left = page.step(
        "Five dimensionless numbers are independent",
        len(names) - rank,
        Integer(5),
        name=r"7-\text{rank}",
        because="by Buckingham's theorem the difference is the number of dimensionless parameters",
    )
    rules = [read(row.dimensionless)[0] for row in TABLE_I if row.dimensionless is not None]
    chosen = Matrix([[r.rhs.as_powers_dict()[Symbol(name)] for name in names] for r in rules])
    page.table(
        "Powers of the parameters in the five numbers of Table I.",
        head,
        [[rule.lhs, *chosen.row(i)] for i, rule in enumerate(rules)],
    )
    page.same("pure numbers", chosen * powers, zeros(len(rules), len(units)))
    page.same("independent", Integer(chosen.rank()), left)
    page.say(
        "The product of the two tables is zero, so all five numbers are dimensionless. The "
        "rank of the second table is five, so none of the numbers follows from the others. "
        "So the loop depends on these five numbers, and mass and period are only units."
    )
    _settle(page)


def _settle(page):
    """In units of mass and period, five of the seven parameters determine the loop."""
    then = taken_apart(page.claim("s4b-seven-to-five"))[2]
    device = page.lemma(
        "In units of its mass and of the period, two numbers describe a device", in_own_units()
    )
    wall = page.lemma(
        "In units of the mass and of the period, two numbers describe a wall",
        scaled_wall(then.of[1]),
    )
    page.settle(
        "s4b-seven-to-five",
        conj(device, wall),
        example=SEVEN,
        note="no choice of units leaves fewer than five parameters",
    )
