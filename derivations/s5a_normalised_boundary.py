r"""What does the passivity boundary look like in the plane of the stability analysis?

Table I turns $(K,B)$ into $(\alpha,\beta)$. The passive walls can then be drawn in the same plane
as the stable ones, and depend only on the damping $\delta$ and the delay.
"""

from symhaptic.book.lemmas.motions import STEPS, half_late, not_on_boundary
from symhaptic.book.lemmas.normalised_boundary import above_in_units, in_units
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import omega_hat
from symhaptic.paper.propositions.passivity import BORDER


def derive(page):
    stiffness, damping = (e.subs(theta, omega_hat) for e in passivity.envelope())
    scaled = {b: delta * m / T}
    in_plane = [(stiffness * T**2 / m).subs(scaled), (damping * T / m).subs(scaled)]
    line = passivity.margin(omega_hat) * T / m
    line = line.subs({K: alpha * m / T**2, B: beta * m / T}).subs(scaled)
    free = page.free_of("the line", line, T, m)
    page.say(
        "We multiply the envelope of the passive walls by $T^2/m$ and $T/m$. The line of each "
        f"frequency then does not contain mass and period ({free.method}), nor does the "
        r"envelope. The coordinates $\alpha$ and $\beta$ of the envelope are proportional to "
        r"$\delta$."
    )
    page.step(
        "A line bounds the condition at one frequency",
        line,
        delta - passivity.dirichlet_form(omega_hat).subs({K: alpha, B: beta, T: 1}),
        name=r"\tfrac{T}{m}(b-b_{\min})",
    )
    page.say(
        r"As in physical units, for $d>0$ and $0<\hat\omega\le\pi/(d+1)$ the curve is the boundary "
        r"of the passive region. At larger angles, up to $\pi$, the curve is not part of this "
        r"boundary. For some delays, such as $d=\tfrac14$, the curve has a pole at one of these "
        "angles."
    )
    _boundary(page, Eq(alpha, in_plane[0]), Eq(beta, in_plane[1]))


def _boundary(page, *forms):
    """With Table I, (27) follows from (7)."""
    printed = STATEMENTS["eq27"].printed
    then = taken_apart(page.claim("eq27"))[2]
    curve, others = then.of
    on_it = page.lemma(
        "A wall of (27), in SI units, is passive, and requires exactly the damping $b$",
        in_units(),
        because=r"the wall is that of (7) with $\omega=\hat\omega/T$",
        boxed=True,
    )
    above = page.lemma(
        "With a delay the walls of (27) are the whole boundary above the corner",
        above_in_units(others.of[1]),
        because=r"by \chapter{s3b_rise} the walls on the boundary satisfy (7), which is (27) at "
        r"$\hat\omega=\omega T$",
        boxed=True,
    )
    found = conj(
        disch(add_assum(on_it, *curve.of[0].of), curve.of[0]),
        disch(closed(above, conjunct(assume(others.of[0]), BORDER)), others.of[0]),
    )
    end = omega_hat <= pi / (d + 1)
    half = _wall(printed, {d: S.Half, omega_hat: pi / 3})
    high = _wall(printed, {d: S.One, omega_hat: 2 * pi / 3})
    page.settle(
        "eq27",
        found,
        *forms,
        example=_wall(printed, {d: S.Zero, omega_hat: pi / 2}),
        unless={
            whole(d): (half, not_on_boundary(then, half, half_late(Rational(17, 10)))),
            end: (high, not_on_boundary(then, high, STEPS)),
        },
        shows=r"for $d=1$ and $\hat\omega=\tfrac23\pi$, (27) gives the wall $(-4,2)\,\delta$, "
        "which has a negative stiffness",
        note=r"without delay, (27) is the single point $(2\delta,0)$, and the rest of the "
        "boundary is (6). For $d>0$, (27) bounds the walls of (5), and its walls at larger "
        "angles are not on the boundary",
    )


def _wall(printed, at):
    """The wall of (27) at an angle, in units of mass and period, for a damping of 1."""
    unit = {m: S.One, T: S.One, b: S.One, delta: S.One} | at
    wall = {line.lhs: line.rhs.subs(unit) for line in printed}
    return unit | wall | {K: wall[alpha], B: wall[beta]}
