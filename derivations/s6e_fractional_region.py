r"""On which side does the paper's passivity condition err at a fractional delay?

Its (5) to (11) put a fractional $d$ into formulas that are exact for whole delays. We hold them
against the exact condition at two places that the paper speaks of: at low frequencies and without
stiffness.
"""

from sympy import Rational, S, cos, sin

from symhaptic.book.figures.fractional import passive_regions
from symhaptic.model import fractional
from symhaptic.notation import B, K, T, b, epsilon, l, theta

HALF = Rational(1, 2)


def derive(page):
    margin, rest = fractional.margin(), 1 - epsilon
    page.say(
        "A wall is passive if $D=b(b-n)-\\tfrac14\\varepsilon(1-\\varepsilon)T^2|H|^2$ is not "
        "negative at any angle."
    )
    low = page.limit(
        "Low frequencies",
        margin / b,
        theta,
        S.Zero,
        b + B - K * T * (l + epsilon + HALF) - epsilon * rest * (K * T) ** 2 / (4 * b),
        name="D/b",
        because="the condition (9), with the delay $d=\\ell+\\varepsilon$, and a term more: the "
        "lower part of the boundary is no line but an arc of a parabola, tangent to it at "
        "$(0,-b)$",
    )
    page.state(
        "fractional-low-frequencies",
        "every passive wall obeys, and for $0<\\varepsilon<1$ no wall with $K>0$ on the straight "
        "part (8), (9) does",
        r"b + B \geq KT(\ell+\varepsilon+\tfrac{1}{2}) "
        r"+ \frac{\varepsilon(1-\varepsilon)K^2T^2}{4b}",
    )
    page.settle(
        "fractional-low-frequencies",
        low >= 0,
        note="at $d=\\tfrac12$ and $B=0$ the paper allows $KT=b$, and $0.944\\,b$ is true",
    )
    without_stiffness(page, margin / b**2)
    page.figure(
        "passive-fractional",
        "Passive walls for two fractional delays: exact (shaded), by the paper's (7) (dashed), and "
        "for the next whole delay (dotted).",
        passive_regions,
    )


def without_stiffness(page, share):
    one, two = (l + 1) * theta / 2, (l + 2) * theta / 2
    rest = 1 - epsilon
    squares = []
    for title, damping, form, because in (
        ("$K=0$, $B=-b$", -b, sin, "not negative: the lower limiting point is exact"),
        (
            "$K=0$, $B=b$",
            b,
            cos,
            "positive, also for $\\theta\\to0$ and $\\pi$, as two angles that differ by "
            "$\\frac\\theta2\\le\\frac\\pi2$ cannot both have the cosine 0: the upper limiting "
            "point lies inside",
        ),
    ):
        first, second = 2 * (rest * form(one)) ** 2, 2 * (epsilon * form(two)) ** 2
        mixed = sin((2 * l + 3) * theta / 2) ** 2 + 4 * form(one) ** 2 * form(two) ** 2
        pair = share.subs({K: 0, B: damping}), first + second + epsilon * rest * mixed
        page.step(title, *pair, name="D/b^2", because=because)
        squares.append(pair)
    ends = page.limits(share.subs(K, 0), theta, S.Zero, 1 + B / b)
    page.state(
        "fractional-limit-points",
        "without stiffness the passive damping begins at $B=-b$ for every delay, and for "
        "$0<\\varepsilon<1$ it ends above $b$",
    )
    sums = [page.same("squares", *pair) for pair in squares]
    page.settle(
        "fractional-limit-points",
        *sums,
        ends,
        note="the paper gives $(0,-b)$ and $(0,b)$ for every delay; half a period late the end is "
        "$1.296\\,b$ (next chapter)",
    )
