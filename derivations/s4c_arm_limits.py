r"""How large are stiffness and damping per mass for the arms of the literature?

The paper takes the largest ratios of Table II and adds the damping of a device. We repeat the
calculation in exact fractions.
"""

from sympy import Le, Lt, ceiling

from symhaptic.book.lemmas.arm import in_seconds, within
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import second
from symhaptic.paper.tables import DEVICE_RATIO, EXCLUDED, TABLE_II

RATIOS = {
    row.authors: [Rational(r) / Rational(row.mass) for r in (row.stiffness, row.damping)]
    for row in TABLE_II
}
KEPT = {authors: pair for authors, pair in RATIOS.items() if authors != EXCLUDED}
DEVICE, PERIOD = Rational(DEVICE_RATIO), Rational(1, 1000)
"""b_D/m_D in 1/s, and the longest period in s."""


def derive(page):
    limits(page, *largest(page))


def largest(page):
    """(21): the largest ratios of the rows that are kept; the second is rounded up."""
    stiff, slow = (max(KEPT, key=lambda name: KEPT[name][i]) for i in (0, 1))
    printed = {row.authors: row for row in TABLE_II}
    hogan, tsuji = printed[stiff], printed[slow]
    spring = page.step(
        f"{stiff} has the largest stiffness per mass",
        KEPT[stiff][0],
        S(710),
        name=rf"\frac{{{hogan.stiffness}}}{{{hogan.mass}}}",
    )
    damper = page.step(
        f"{slow} have the largest damping per mass",
        KEPT[slow][1],
        Rational(131, 9),
        name=rf"\frac{{{tsuji.damping}}}{{{tsuji.mass}}}",
        because=r"the paper rounds $14.555\ldots$ up to 14.6",
    )
    up = ceiling(10 * damper) / S(10)
    symbols, given, then = taken_apart(page.claim("eq21"))
    page.settle(
        "eq21",
        for_all(symbols, given, conj(*map(in_seconds, then.of))),
        k_H / m_H <= spring / second**2,
        b_H / m_H <= up / second,
        example={second: S.One},
        note=r"Hogan's arm attains the first bound; the second is $\tfrac{131}9$, the ratio of "
        "Tsuji et al., rounded up",
    )
    page.say(
        "The bound 710 is attained, but the mass of 0.8 kg has one digit only. An error of half a "
        "unit of the last digits would allow this ratio:"
    )
    page.step(
        "The published digits allow a ratio of up to 758",
        Rational("568.5") / Rational("0.75"),
        S(758),
        name=r"\frac{568.5}{0.75}",
    )
    page.say(
        rf"The row of {EXCLUDED} is left out. We compute its $\gamma$ and $\delta$ at $T=1$ ms "
        "and with a massless device:"
    )
    hard, viscous = RATIOS[EXCLUDED]
    page.step(
        "The stiffness of the row that is left out exceeds the range (23)",
        hard * PERIOD**2,
        Rational(1, 150),
        name=r"\frac{kT^2}m\Big|_{T=1\,\mathrm{ms}}",
    )
    page.step(
        "The damping of the row that is left out exceeds the range (23)",
        viscous * PERIOD,
        Rational(1, 20),
        name=r"\frac{bT}m\Big|_{T=1\,\mathrm{ms}}",
    )
    return spring, up


def limits(page, spring, damper):
    """(22) from (19), (21) and the devices of the paper's reference [8]."""
    total = damper + DEVICE
    page.step(
        "The damping limits of arm and device add up",
        total,
        Rational("15.225"),
        name="14.6+0.625",
        because="the limits in 1/s are 14.6 for the arm and 0.625 for the device",
        paper="22",
    )
    page.settle_external(
        "s4c-device-damping",
        "on the devices listed in [8]",
        "the paper uses it in (22) only, where $14.6+0.625=15.225$",
    )
    held = {gamma: T**2 * k_H / (m_D + m_H), delta: T * (b_D + b_H) / (m_D + m_H)}
    for name, meaning in held.items():
        page.define("(19) defines the parameters of device and arm", name, meaning)
    inside = page.lemma(
        "Arm and device within their limits are together within (22)",
        conj(*within(spring, damper, DEVICE)),
        because="the limits (21) bound the ratios of the arm, and 0.625 bounds the damping per "
        "mass of the devices of [8]",
    )
    signs = {"<": Lt, "<=": Le}
    names = {meaning: name for name, meaning in held.items()}
    forms = [
        signs[p.sign](p.left.xreplace(names), p.right.xreplace(names), evaluate=False)
        for p in inside.conclusion.of
    ]
    page.settle_external(
        "eq22",
        "on $b_D/m_D<0.625\\,\\mathrm{s}^{-1}$ for the devices of [8], and on Table II",
        r"follows from both; their mean, weighted by the masses, gives the smaller bound $14.6\,T$",
        *forms,
    )
