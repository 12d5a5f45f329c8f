r"""Is a wall passive at a fractional delay if it is at the next whole one?

The paper's formulas are exact for whole delays. If a fractional delay is never worse than the next
whole one, rounding the delay up keeps what they say of whole delays. It is so for every $K\ge0$.
"""

from sympy import Rational, S, cos, pi, sin, sqrt, tan

from symhaptic.model import fractional, passivity
from symhaptic.notation import B, K, N, T, b, chi, d, epsilon, kappa, l, psi, r, theta, u, w
from symhaptic.proof.sign import assume, chord, combined, number, quotient, sine

HALF = Rational(1, 2)
ANGLE, QUARTER = assume(psi), number(pi / 2)
SIZE, PART, REST = assume(r), assume(epsilon), assume(1 - epsilon)


def square(expr):
    return assume(expr**2, strict=False)


def derive(page):
    page.say(
        "As before let $\\psi=\\theta/2$, $u=KT/(2b)$ and $w=(B+KT/2)/b$, and $N=2(\\ell+2)$ for "
        "the next whole delay $\\ell+1$. At one angle write $w=r\\sin\\kappa$ and "
        "$u\\cot\\psi=r\\cos\\kappa$; for $K>0$ that is $|\\kappa|<\\frac\\pi2$."
    )
    polar = {K: 2 * b * u / T, B: b * (w - u), theta: 2 * psi}
    turned = {u: r * cos(kappa) * tan(psi), w: r * sin(kappa)}
    need = passivity.dirichlet_form().subs(polar).subs(turned).subs(d, N / 2 - 1) / b
    page.step(
        "The next whole delay needs",
        need,
        r * sin(N * psi - kappa),
        name=r"\text{need}\big|_{d=\ell+1}/b",
        because="we write $\\chi=N\\psi-\\kappa$; for $\\ell$ it is $r\\sin(\\chi-2\\psi)$",
    )
    share = (fractional.margin() / b**2).subs(polar).subs(turned)
    value = page.step(
        "The exact condition",
        share.subs(l, N / 2 - 2).subs(kappa, N * psi - chi),
        1
        - r * ((1 - epsilon) * sin(chi - 2 * psi) + epsilon * sin(chi))
        - epsilon * (1 - epsilon) * r**2 * sin(psi) ** 2,
        name="f",
        because="is $f\\ge0$",
    )
    page.say(
        "Let the next whole delay be passive: $r\\sin\\chi\\le1$ at all angles. From $\\psi=0$, "
        "where $\\chi=0$, to $N\\psi=\\pi$, where it is $\\pi-\\kappa>\\frac\\pi2$, there is a "
        "first $\\psi_0$ with $\\chi=\\frac\\pi2$, and there $r\\le1$. As $r$ falls, $r\\le1$ from "
        "there on; and for $K=0$ it is $|B|/b\\le1$ anyway. There:"
    )
    domain = r"\ 0<\varepsilon<1"
    late = page.positive("From $\\psi_0$ on", beyond(value), rf"r\le1,{domain}", name="f")
    page.say("Below $\\psi_0$, as long as $\\chi\\ge\\psi/2$, use $r\\sin\\chi\\le1$:")
    early = page.positive("Up to $\\psi_0$", before(value), rf"\psi\le2\chi<\pi,{domain}", name="f")
    page.say(
        "Where $\\chi<\\psi/2$, $\\kappa$ lies between $(N-\\frac12)\\psi$ and $\\frac\\pi2$. At "
        "$N\\psi=\\pi$ the whole delay needs $w=r\\sin\\kappa$, so that this is at most 1:"
    )
    first = page.positive("Near $\\psi=0$", low(value), rf"2\chi<\psi,{domain}", name="f")
    page.state(
        "fractional-next-whole",
        "a wall with $K\\ge0$ that is passive for the whole delay $\\ell+1$ is passive for every "
        "delay between $\\ell$ and $\\ell+1$",
    )
    note = "so (5) to (9) and (11) are safe with $d$ rounded up and $K\\ge0$"
    page.settle("fractional-next-whole", late, early, first, note=note)


def beyond(value):
    """r <= 1: all squares."""
    one, two = pi / 4 - chi / 2 + psi, pi / 4 - chi / 2
    room = assume(1 - r, strict=False)
    return combined(
        value,
        [2, SIZE, REST, REST, square(sin(one))],
        [2, SIZE, PART, PART, square(sin(two))],
        [SIZE, PART, REST, square(cos(chi - psi))],
        [4, SIZE, PART, REST, square(sin(one) * sin(two))],
        [room],
        [room, PART, REST, SIZE, square(sin(psi))],
    )


def before(value):
    """psi/2 <= chi < pi/2 and r sin(chi) <= 1."""
    room = assume(1 - r * sin(chi), strict=False)
    up, down = assume(pi / 2 - chi), assume(chi - psi / 2, strict=False)
    rises = combined(chi, [down], [HALF, ANGLE])
    sin_y = sine(ANGLE, combined(pi - psi, [2, up], [2, down]))
    double = combined(2 * chi - psi, [2, down]), combined(pi - 2 * chi + psi, [2, up], [ANGLE])
    inverse = quotient(1 / sin(chi), number(S.One), chord(QUARTER, up, rises))
    return combined(
        value,
        [SIZE, REST, sin_y, sine(*double), inverse],
        [SIZE, REST, REST, sin_y, sin_y, inverse],
        [room],
        [room, PART, REST, SIZE, sin_y, sin_y, inverse],
    )


def low(value):
    """chi < psi/2 and r sin(kappa) <= 1 with kappa = N psi - chi < pi/2."""
    turn = N * psi - chi
    small, up, more = assume(psi / 2 - chi), assume(pi / 2 - turn), assume(N - 4, strict=False)
    room = assume(1 - r * sin(turn), strict=False)
    left = combined(pi / 2 - 7 * psi / 2, [up], [small], [more, ANGLE])
    above = combined(chi + pi / 2, [up], [more, ANGLE], [4, ANGLE])
    after = combined(pi / 2 - psi / 2, [left], [3, ANGLE])
    sin_y = chord(QUARTER, combined(pi / 2 - psi, [left], [5 * HALF, ANGLE]), ANGLE)
    sin_half = chord(QUARTER, after, combined(psi / 2, [HALF, ANGLE]))
    gap = combined(turn - psi, [small], [more, ANGLE], [5 * HALF, ANGLE])
    wide = chord(combined(psi + pi / 2, [ANGLE], [QUARTER]), up, gap)
    first = chord(above, after, small)
    earlier = combined(chi - 2 * psi + pi / 2, [up], [more, ANGLE], [2, ANGLE])
    second = chord(earlier, after, combined(5 * psi / 2 - chi, [small], [2, ANGLE]))
    near = combined(pi / 4 - psi / 2, [Rational(1, 7), left], [number(5 * pi / 28)])
    steep = chord(number(3 * pi / 4), combined(psi / 2, [HALF, ANGLE]), near)
    flat = combined(3 * cos(psi / 2) / 2 - 1, [3 * HALF, steep], [number(3 * sqrt(2) / 4 - 1)])
    wider = combined(
        sin(turn) + sin(psi) - sin(psi / 2),
        [wide],
        [Rational(8, 3), sin_half, flat],
        [Rational(5, 3), sin_half],
    )
    inverse = quotient(1 / sin(turn), number(S.One), combined(sin(turn), [wide], [sin_y]))
    return combined(
        value,
        [SIZE, REST, second],
        [SIZE, PART, first],
        [SIZE, square(HALF - epsilon), sin_y, sin_y, inverse],
        [SIZE, wide, wider, inverse],
        [SIZE, sin_y, sin_half, flat, inverse],
        [room],
        [room, PART, REST, SIZE, sin_y, sin_y, inverse],
    )
