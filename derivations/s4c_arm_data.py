"""What do the arms of the literature have in common?

Table II of the paper lists eleven arms from eleven articles. We do not have the articles, but we
can check the ratios, the damping and the conversion of units.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.arm import k_1, k_2
from symhaptic.paper.tables import EXCLUDED, TABLE_II

POUND, GRAVITY, INCH = Rational("0.45359237"), Rational("9.80665"), Rational("0.0254")
"""kg, m/s^2 and m, exact by their international definitions."""

ROWS = {
    row.authors: tuple(Rational(text) for text in (row.mass, row.stiffness, row.damping))
    for row in TABLE_II
}


def derive(page):
    page.say(
        r"Only the ratios of stiffness and damping to the mass enter $\gamma$ and $\delta$. The "
        r"damping ratio of each arm is $\zeta=b_H/(2\sqrt{k_Hm_H})$:"
    )
    page.table(
        "Ratios of the arms, rounded, from the published decimals of Table II.",
        ["article", "$k_H/m_H$ in s$^{-2}$", "$b_H/m_H$ in s$^{-1}$", "$\\zeta$"],
        [
            [
                f"{row.authors} [{row.reference}]",
                f"{float(k / m):.2f}",
                f"{float(b / m):.2f}",
                f"{float(b / (2 * sqrt(k * m))):.2f}",
            ]
            for row, (m, k, b) in zip(TABLE_II, ROWS.values(), strict=True)
        ],
    )
    checks = converted(page)
    page.say(
        "One row is exceptional: the paper says that the arm was strapped down and only the "
        "hand was measured. We divide the ratios of this row by the next largest ones, which "
        "are those of Hogan and of Tsuji et al.:"
    )
    shown = []
    for column, name in ((1, r"\frac{k_H/m_H}{(k_H/m_H)_2}"), (2, r"\frac{b_H/m_H}{(b_H/m_H)_2}")):
        all_of_them = ratios(column)
        most = all_of_them.pop(EXCLUDED)
        shown.append((name, most / max(all_of_them.values())))
    page.enclosed(
        "The ratios of Kuchenbecker et al. exceed the next ones by the factors", shown, places=6
    )
    page.settle(
        "s4c-outlier",
        conj(*map(fact, page.claim("s4c-outlier").of)),
        note="the two ratios of this arm are at least 3 times those of every other arm, and 9.4 "
        "and 3.4 times the next largest ones",
    )
    page.say("Two springs in series share the force, and their displacements add up:")
    series(page)
    page.settle_external(
        "tab2",
        "on the eleven articles that it cites",
        r"two rows are conversions: of $4\pi^2$ and $4\pi$ (a model of arm and device), and of "
        rf"0.1, 1 and 1 in pounds and inches; {len(checks)} numbers agree to the last digit",
    )


def series(page):
    """Two springs in series are less stiff than each of them."""
    symbols, given, then = taken_apart(page.claim("s4c-series"))
    k = symbols[0]
    found = []
    for wanted, own, other in zip(then.of, (k_1, k_2), (k_2, k_1), strict=True):
        soft = over(1 / other > 0, one(), other > 0)
        both = [assume(k > 0), assume(own > 0), soft]
        found.append(combined(wanted, both, [assume(given[-1]), -k * own]))
    apart = [positive(Ne(part, 0), part > 0) for part in symbols]
    theorem = page.lemma(
        "Two joints in series are less stiff than each of them", closed(conj(*found), *apart)
    )
    half = {k: S.Half, k_1: S.One, k_2: S.One}
    page.settle(
        "s4c-series",
        theorem,
        example=half,
        note="the difference of the stiffnesses depends on the joints",
    )


def ratios(column):
    """The ratio of stiffness (column 1) or damping (column 2) to mass, by article."""
    return {authors: numbers[column] / numbers[0] for authors, numbers in ROWS.items()}


def converted(page):
    """Two rows are conversions of simple numbers; each number rounds to the published one."""
    daniel, lawrence = TABLE_II[0], TABLE_II[6]
    force = POUND * GRAVITY / INCH
    page.say(
        "The first row is a mass of 1 kg with a natural frequency of 1 Hz and critical damping: "
        r"$k_H=4\pi^2$, $b_H=4\pi$. By its footnote it describes arm and device together, so "
        "its mass is not $m_H$. The values of Lawrence are 0.1, 1 and 1 in units of pounds of "
        "force, inches and seconds, with 1 lb $=$ 0.45359237 kg, 1 in $=$ 0.0254 m and $g=$ "
        "9.80665 m/s$^2$."
    )
    page.step(
        r"At a natural frequency of 1 Hz, $b_H=4\pi m_H$ is critical damping",
        (4 * pi) ** 2 - 4 * (4 * pi**2),
        S.Zero,
        name=r"b_H^2-4k_Hm_H\,\big|_{m_H=1,\ k_H=4\pi^2,\ b_H=4\pi}",
    )
    found = (
        (r"4\pi^2", 4 * pi**2, daniel.stiffness),
        (r"4\pi", 4 * pi, daniel.damping),
        (r"0.1\,\mathrm{lbf\,s^2/in}", force / 10, lawrence.mass),
        (r"1\,\mathrm{lbf/in}", force, lawrence.stiffness),
        (r"1\,\mathrm{lbf\,s/in}", force, lawrence.damping),
    )
    page.enclosed(
        "The two rows have these values in SI units",
        [(name, value) for name, value, _ in found],
        because="the paper gives 39.5, 12.6, 17.51, 175.1 and 175.1",
        places=6,
    )
    return [rounded(value, printed) for _, value, printed in found]


def rounded(value, printed):
    """The number differs from the published decimal by less than half a unit of the last digit."""
    digits = len(printed.partition(".")[2])
    half = Rational(1, 2 * 10**digits)
    off = (value - Rational(printed)) ** 2
    return number(Relation(off, "<", half**2))
