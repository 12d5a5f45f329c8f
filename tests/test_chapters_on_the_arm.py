"""The human arm, Figs. 4 to 6, and claims and slips of the text, by other means than the package.

Numbers of the paper are typed here once more, from its Table II and Sec. IV-C.
"""

import itertools
import math
import warnings
from dataclasses import replace
from decimal import ROUND_CEILING, Decimal
from fractions import Fraction

import matplotlib as mpl
import mpmath
import numpy as np
import pytest
import scipy.constants as si
from chapters import chapter
from oracle import certified
from scipy.integrate import solve_ivp
from scipy.optimize import linprog

import symhaptic.paper.tables as tables
from symhaptic.book.chapters import BadChapter, folder, run
from symhaptic.book.figures.passivity import STYLE, WIDTH
from symhaptic.paper.reading import read
from symhaptic.proof.verdict import Kind

RNG = np.random.default_rng(14)

# Table II: reference, m_H/kg, k_H/(N/m), b_H/(Ns/m)
ARMS = """
21 1     39.5  12.6
17 0.8   568   5.5
22 4.54  12.5  6.83
23 1.95  55    2.46
24 0.15  1000  7.5
25 2.79  345   33.8
26 17.51 175.1 175.1
27 0.5   40    6
28 0.15  7     0.5
29 1.8   199.1 26.2
30 2.0   10.0  2.0
"""
ROWS = [line.split() for line in ARMS.split("\n") if line]
WRIST = "24"  # Kuchenbecker et al., which (21) leaves out


def verdict(name, id):
    return chapter(name).page.settled[id].verdict


def ratios(column):
    return {row[0]: Fraction(row[column]) / Fraction(row[1]) for row in ROWS}


# -- Table II -------------------------------------------------------------------------------


def test_table_ii_is_the_printed_one():
    typed = [[str(a.reference), a.mass, a.stiffness, a.damping] for a in tables.TABLE_II]
    assert typed == ROWS
    assert [a.reference for a in tables.TABLE_II if a.with_device] == [21]


def test_two_rows_are_conversions():
    """tab2: a critically damped mass of 1 kg at 1 Hz, and SciPy's lbf and inch."""
    for value, digits, printed in (
        ((2 * math.pi) ** 2, 1, "39.5"),  # k = m w^2
        (2 * 2 * math.pi, 1, "12.6"),  # b = 2 m w
        (0.1 * si.lbf / si.inch, 2, "17.51"),
        (si.lbf / si.inch, 1, "175.1"),
    ):
        assert f"{value:.{digits}f}" == printed


@pytest.mark.parametrize(
    ("row", "field"),
    [(0, "stiffness"), (0, "damping"), (6, "mass"), (6, "stiffness"), (6, "damping")],
)
def test_a_changed_digit_of_a_conversion_is_found(monkeypatch, row, field):
    text = getattr(tables.TABLE_II[row], field)
    patched(monkeypatch, row, **{field: text[:-1] + str((int(text[-1]) + 1) % 10)})
    with pytest.raises(BadChapter):
        run(folder() / "s4c_arm_data.py")


def patched(monkeypatch, row, **changed):
    rows = list(tables.TABLE_II)
    rows[row] = replace(rows[row], **changed)
    monkeypatch.setattr(tables, "TABLE_II", tuple(rows))


# -- (19) to (23) ---------------------------------------------------------------------------


def test_the_two_bodies_move_as_one():
    """(19): eigenvalues of the coupled bodies, in periods, against s^2 + delta s + gamma."""
    m_d, b_d, m_h, b_h, k_h, period = 0.3, 0.2, 0.8, 5.5, 568.0, 1e-3
    motion = np.array([[0, 1], [-k_h / (m_d + m_h), -(b_d + b_h) / (m_d + m_h)]]) * period
    gamma, delta = period**2 * k_h / (m_d + m_h), period * (b_d + b_h) / (m_d + m_h)
    expected = np.roots([1, delta, gamma])
    assert np.sort_complex(np.linalg.eigvals(motion)) == pytest.approx(np.sort_complex(expected))


def test_the_damping_of_the_whole_is_a_mean():
    """(20) and the mean ratio, in exact fractions at random points."""
    for _ in range(200):
        m_d, b_d, m_h, b_h = (Fraction(int(n), 7) for n in RNG.integers(1, 99, 4))
        whole = (b_d + b_h) / (m_d + m_h)
        assert min(b_d / m_d, b_h / m_h) <= whole <= max(b_d / m_d, b_h / m_h)
        assert whole < b_d / m_d + b_h / m_h


def test_bounds_say_nothing_strict_of_a_spring_that_is_not_there():
    """(20) assumes positive masses and dampers; without a spring both sides are zero."""
    printed = chapter("s4c_arm_and_device").page.settled["eq20"].statement.printed
    bounds = [line.rhs for line in printed]
    limp = {s: int(s.name != "k_H") for bound in bounds for s in bound.free_symbols}
    assert bounds[0].subs(limp) == 0  # as gamma is
    assert bounds[1].subs(limp) > 1  # delta is T (1 + 1)/(1 + 1)
    assert verdict("s4c_arm_and_device", "eq20").condition == "k_H>0"


def test_the_largest_ratios():
    """(21) and (22) from the typed table: 710 attained by Hogan, 14.6 rounded up for Tsuji."""
    stiffness, damping = ratios(2), ratios(3)
    wrist = stiffness.pop(WRIST), damping.pop(WRIST)
    assert max(stiffness.values()) == stiffness["17"] == 710
    up = Decimal(131) / Decimal(9)
    assert max(damping.values()) == damping["29"] == Fraction(131, 9)
    assert up.quantize(Decimal("0.1"), ROUND_CEILING) == Decimal("14.6")
    assert Decimal("14.6") + Decimal("0.625") == Decimal("15.225")
    assert float(wrist[0]) == pytest.approx(6666.7, abs=0.05)
    assert wrist[1] == 50
    # s4c-outlier
    assert float(wrist[0] / 710) == pytest.approx(9.39, abs=0.005)
    assert float(wrist[1] / Fraction(131, 9)) == pytest.approx(3.435, abs=0.0005)
    assert "9.4 and 3.4" in verdict("s4c_arm_data", "s4c-outlier").note


def test_the_ranges_are_thirty_per_cent_rounded_up():
    """(23) and s4c-extension-30: 1.3 times (22) in whole thousandths; 41 % and 31 %."""
    for limit, printed, factor in (
        (Decimal("710e-6"), Decimal("0.001"), 1.40845),
        (Decimal("15.225e-3"), Decimal("0.020"), 1.31363),
    ):
        wider = limit * Decimal("1.3")
        assert wider.quantize(Decimal("0.001"), ROUND_CEILING) == printed
        assert float(printed / limit) == pytest.approx(factor, abs=5e-6)
    assert verdict("s4c_arm_ranges", "s4c-extension-30").kind == Kind.REFUTED
    assert math.sqrt(0.001 / 710) * 1000 == pytest.approx(1.1867817, abs=5e-8)


DIGITS = [
    ("s4c_arm_limits", "eq21", Kind.PROVED, "710", "709"),
    ("s4c_arm_limits", "eq21", Kind.PROVED, "14.6", "14.7"),
    ("s4c_arm_limits", "eq22", Kind.EXTERNAL, "710", "720"),
    ("s4c_arm_limits", "eq22", Kind.EXTERNAL, "15.225", "15.226"),
    ("s4c_arm_ranges", "eq23", Kind.DEFINITION, "10^{-3}", "10^{-4}"),
    ("s4c_arm_ranges", "eq23", Kind.DEFINITION, "20", "19"),
    ("s4c_arm_and_device", "eq19", Kind.PROVED, "m_D + m_H", "m_D"),
    ("s4c_arm_and_device", "eq20", Kind.QUALIFIED, "m_H}", "m_D}"),
]


@pytest.mark.parametrize(("name", "id", "kind", "old", "new"), DIGITS)
def test_a_changed_digit_of_the_print_loses_its_verdict(name, id, kind, old, new):
    settled = chapter(name).page.settled[id]
    assert settled.verdict.kind == kind
    lines = [line.replace(old, new) for line in settled.statement.latex]
    changed = tuple(part for line in lines for part in read(line))
    assert changed != settled.statement.printed
    good = {Kind.PROVED, Kind.QUALIFIED, Kind.EXTERNAL, Kind.DEFINITION, Kind.ENCLOSED}
    # where theorems settle it, another print has another claim, which they do not say
    assert not settled.settlement.accepts(changed, frozenset(good))


@pytest.mark.parametrize(
    ("row", "changed"),
    [(1, {"stiffness": "569"}), (1, {"mass": "0.7"}), (9, {"damping": "26.3"})],
)
def test_a_changed_arm_changes_the_limits(monkeypatch, row, changed):
    patched(monkeypatch, row, **changed)
    with pytest.raises(BadChapter):
        run(folder() / "s4c_arm_limits.py")


# -- the figures ----------------------------------------------------------------------------


def drawn(name, title):
    """The axes of one figure, drawn without a warning."""
    mpl.use("Agg")
    import matplotlib.pyplot as plt

    (block,) = (b for b in chapter(name).page.blocks if b.kind == "figure" and b.title == title)
    with mpl.rc_context(STYLE), warnings.catch_warnings():
        warnings.simplefilter("error")
        made, axes = plt.subplots(figsize=(WIDTH, block.height * WIDTH), layout="constrained")
        block.draw(axes)
        made.canvas.draw()
    return made, axes


def test_figure_6_shows_every_row_at_its_place_and_no_label_covers_another():
    made, axes = drawn("s4c_arm_ranges", "fig6")
    points = {(line.get_xdata()[0], line.get_ydata()[0]) for line in axes.lines[2:]}
    assert points == {(float(r[2]) / float(r[1]), float(r[3]) / float(r[1])) for r in ROWS}
    boxes = [t.get_window_extent() for t in axes.texts]
    boxes.append(axes.get_legend().get_window_extent())
    assert len(axes.texts) == len(ROWS)
    assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))
    page = made.bbox
    assert all(page.x0 <= b.x0 and b.x1 <= page.x1 for b in boxes)
    # no label lies on the point of another row
    places = axes.transData.transform(sorted(points))
    assert not any(b.contains(*place) for b in boxes for place in places)
    corners = [(line.get_xdata()[0], line.get_ydata()[-1]) for line in axes.lines[:2]]
    assert corners == [(1000, 20), (710, 14.6)]  # (23) over T^2 and T at 1 ms, and (21)


def condition(angles, delay):
    """Rows of K and B in (5) as it is printed, b = T = 1."""
    cos, scale = np.cos, 2 - 2 * np.cos(angles)
    k = (cos(delay * angles) - cos((delay + 1) * angles)) / scale
    b = cos(delay * angles) - 2 * cos((delay + 1) * angles) + cos((delay + 2) * angles)
    return np.stack([k, b / scale], axis=1)


@pytest.mark.parametrize("delay", [0, 0.25, 0.5, 1, 2, 4, 8])
def test_tips_and_corners_of_figure_4(delay):
    """Tips by linear programming over (5) on 3000 angles, corners by mpmath on (7)."""
    (table,) = (b for b in chapter("s3d_figures").page.blocks if b.kind == "table")
    row = next(r for r in table.rows if r[0] == f"${delay:g}$")
    corner_k, corner_b, tip_k, tip_b = (float(Fraction(str(c).strip("$"))) for c in row[1:])
    angles = np.linspace(0, np.pi, 3002)[1:-1]
    found = linprog([-1, 0], condition(angles, delay), np.ones(3000), bounds=(-3, 3))
    assert tip_k <= found.x[0] + 1e-6  # decimals are cut off
    assert found.x[0] - tip_k < 2e-4  # of four decimals, and a chord of the grid
    if delay:  # without delay the point is a corner, in (5) an open one
        assert found.x[1] == pytest.approx(tip_b, abs=2e-3)  # flat there: root of the grid's error
        with mpmath.workdps(60):
            w, d = mpmath.mpf(10) ** -12, mpmath.mpf(delay)
            sin = mpmath.sin
            below = sin(2 * (d + 1) * w) - 2 * (1 + d) * sin(w)
            k = 2 * (d + 1) * (sin((d + 2) * w) - 2 * sin((d + 1) * w) + sin(d * w)) / below
            b = 2 * (d * sin((d + 1) * w) - (1 + d) * sin(d * w)) / below
        assert corner_k == pytest.approx(float(k), abs=1e-12)
        assert corner_b == pytest.approx(float(b), abs=1e-12)


def quadratic_form(stiffness, damping, periods):
    """Energy left to damper and wall, half a period late, as a matrix; b = T = 1.

    The motion has the displacements p_k and q_k in the halves of period k, at constant speed.
    """
    size = 2 * periods
    form = 2 * np.eye(size)  # b p^2/(T/2) in each half
    place = np.zeros((periods + 1, size))
    for k in range(periods):
        place[k + 1] = place[k]
        place[k + 1, 2 * k : 2 * k + 2] = 1
    force = stiffness * place[:-1] + damping * (place[:-1] - np.vstack([place[:1], place[:-2]]))
    late = np.vstack([np.zeros((1, size)), force[:-1]])
    for k in range(periods):
        form[2 * k] += late[k]
        form[2 * k + 1] += force[k]
    return (form + form.T) / 2


def test_half_a_period_late_a_stiffer_wall_than_figure_5_is_passive():
    """fig4, fig5: the form is positive at (1.17, 0.32) and negative at the tip of the curve."""
    tip = 2 * math.tan(math.pi / 6), (0.5 - 1 / 3) / (math.sqrt(3) / 2)  # (11) at d = 1/2
    assert np.linalg.eigvalsh(quadratic_form(1.17, 0.32, 120))[0] > 0
    assert np.linalg.eigvalsh(quadratic_form(*tip, 120))[0] < 0
    assert tip[0] < 1.17


# -- claims ---------------------------------------------------------------------------------


def test_a_chain_of_passive_lags_is_neither_passive_nor_stable():
    """s3-interconnection: Re of 1/(1+2j)^2 by hand, and the poles of the loop."""
    assert ((1 / (1 + 2j)) ** 2).real == pytest.approx(-3 / 25)
    poles = np.roots([1, 3, 3, 1 + 27])
    assert max(poles.real) == pytest.approx(0.5)


def test_a_ramp_is_not_seen_by_the_samples():
    """s4a-exact-instants: the motion of a free mass integrated by SciPy."""
    ramp = solve_ivp(lambda t, x: [x[1], t], (0, 1), [0, 0], rtol=1e-10, atol=1e-12)
    assert ramp.y[0, -1] == pytest.approx(1 / 6, abs=1e-9)
    late = solve_ivp(lambda t, x: [x[1], float(t > 0.5)], (0, 1), [0, 0], max_step=1e-3)
    assert late.y[0, -1] == pytest.approx(1 / 8, abs=1e-3)  # one step lies across the jump


@pytest.mark.parametrize(
    ("alpha", "beta", "gamma", "delay", "stable"),
    [
        ("0.05", "1.9", "0.001", 0, True),  # s4d-too-much-damping
        ("0.05", "2.1", "0.001", 0, False),
        ("0.05", "0.7", "0.001", 1, True),
        ("0.05", "0.9", "0.001", 1, False),
        ("0.0002", "0.0252", "0.001", 150, True),  # s5b-soft-contacts
        ("0", "0.0252", "0.001", 150, False),
        ("0.3", "0.47", "3", 2, True),
        ("0", "0.47", "3", 2, False),
    ],
)
def test_walls_of_the_claims(alpha, beta, gamma, delay, stable):
    """Roots outside the circle, counted by the oracle's certified balls."""
    wall = [Fraction(text) for text in (alpha, beta, gamma, "0.02")]
    assert (certified(*wall, delay) == 0) == stable


@pytest.mark.parametrize("delay", [0, 1, 3])
def test_no_stable_wall_has_more_virtual_damping_than_the_product_of_roots_allows(delay):
    """|n_0 beta| < 1, with n_0 of a free mass, 1/2, by hand."""
    for _ in range(300):
        alpha, beta = RNG.uniform(0, 4), RNG.choice([-1, 1]) * RNG.uniform(2, 6)
        p = np.concatenate([[1.0, -2.0, 1.0], np.zeros(delay + 1)])
        p[-3:] += np.convolve([0.5, 0.5], [alpha + beta, -beta])
        assert np.abs(np.roots(p)).max() >= 1


# -- slips ----------------------------------------------------------------------------------

SLIPS = ["s1-conclusion", "s5b-ratio-panels", "s5b-captions-alike", "s4d-bound-of-b", "s4c-et-al"]


@pytest.mark.parametrize("id", SLIPS)
def test_a_slip_says_what_is_meant_and_claims_nothing(id):
    found = verdict("s7a_slips_in_words", id)
    assert found.kind == Kind.SLIP
    assert found.corrected
    assert found.shows
    assert found.proposition is None
    assert not found


def test_what_no_author_would_call_an_error_is_none():
    """A delay may be zero by the print itself, and (30) has the spring of the Nyquist frequency."""
    assert verdict("s2c_delay", "s2c-positive-delay").kind == Kind.PROVED
    assert verdict("s5c_nyquist", "s5c-nyquist-spring").kind == Kind.PROVED
    assert verdict("s7b_slips_in_relations", "s5c-interval").kind == Kind.MISPRINT


def test_the_interval_is_attained():
    """s5c-interval: 0.02^2/4 in exact decimals."""
    assert Decimal("0.02") ** 2 / 4 == Decimal("0.0001")
