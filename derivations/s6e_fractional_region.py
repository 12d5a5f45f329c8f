"""Is the paper's passivity condition safe for a fractional delay?

In (5) to (11) the paper uses a fractional $d$ in formulas that are exact for integer delays. We
compare these formulas with the exact condition in two cases of the paper: at low frequencies and
without stiffness.
"""

from symhaptic.book.figures.fractional import passive_regions
from symhaptic.book.lemmas.late_damping import damping_late, limit_points
from symhaptic.book.lemmas.late_passivity import low_frequencies, needed_at_low_frequencies
from symhaptic.book.lemmas.prelude import *

POINT = {K: S.One, B: S.Zero, b: S.One, T: S.One, l: S.Zero, epsilon: HALF}


def derive(page):
    margin, rest = fractional.margin(), 1 - epsilon
    page.say(
        "A wall is passive if $D=b(b-n)-\\tfrac14\\varepsilon(1-\\varepsilon)T^2|H|^2$ is not "
        "negative at any angle."
    )
    low = page.limit(
        "At low frequencies the condition is (9) with one more term",
        margin / b,
        theta,
        S.Zero,
        b + B - K * T * (l + epsilon + HALF) - epsilon * rest * (K * T) ** 2 / (4 * b),
        name="D/b",
        because=r"the delay is $d=\ell+\varepsilon$. The lower part of the boundary is not the "
        "straight part (8), (9) but an arc of a parabola that touches it at $(0,-b)$",
    )
    page.state(
        "fractional-low-frequencies",
        r"every passive wall satisfies the following condition, and for $0<\varepsilon<1$ no wall "
        "with $K>0$ on the straight part (8), (9) satisfies it",
        r"b + B \geq KT(\ell+\varepsilon+\tfrac{1}{2}) "
        r"+ \frac{\varepsilon(1-\varepsilon)K^2T^2}{4b}",
        claim=low_frequencies(),
        condition=True,
    )
    page.settle(
        "fractional-low-frequencies",
        low >= 0,
        needed_at_low_frequencies(),
        example=POINT,
        note=r"at $d=\tfrac12$ and $B=0$ the paper allows $KT=b$; the exact limit is $0.944\,b$",
    )
    without_stiffness(page, margin / b**2)
    page.figure(
        "passive-fractional",
        "Passive walls for two fractional delays: the exact region (shaded), the paper's (7) "
        "(dashed), and the region for the next integer delay (dotted).",
        passive_regions,
    )


def without_stiffness(page, share):
    one, two = (l + 1) * theta / 2, (l + 2) * theta / 2
    rest = 1 - epsilon
    loss = epsilon * rest * sin(theta / 2) ** 2
    mixed = rest * sin(one) * cos(one) + epsilon * sin(two) * cos(two)
    page.say(
        "Without stiffness, $D$ is quadratic in $B$ and concave. By the identity of Lagrange, "
        "$D$ is a sum of squares at two dampings:"
    )
    for title, damping, form in (
        ("The damping $-b$ is passive", -b, sin),
        ("The damping $b$ is passive, with a positive margin", b, cos),
    ):
        part = rest * form(one) ** 2 + epsilon * form(two) ** 2
        squares = 2 * part**2 + 2 * mixed**2 + loss
        page.step(title, share.subs({K: 0, B: damping}), squares, name="D/b^2")
    found = page.lemma(
        "For every fractional delay the passive damping ranges from $-b$ to more than $b$",
        damping_late(),
        because=r"for $\theta\ge\pi/(2(\ell+2))$ the last term of $D$ leaves a positive margin at "
        r"$B=b$; for smaller angles no cosine is negative. For $\theta\to0$ the condition is "
        r"$D=b(b+B)\ge0$, and at $\theta=\pi/(\ell+2)$ no damping beyond $b/\varepsilon$ is "
        "passive",
        boxed=True,
    )
    page.state(
        "fractional-limit-points",
        "without stiffness the passive damping begins at $B=-b$ for every delay, and for "
        "$0<\\varepsilon<1$ it ends above $b$",
        claim=limit_points(),
    )
    page.settle(
        "fractional-limit-points",
        found,
        example=POINT,
        note="the paper gives $(0,-b)$ and $(0,b)$ for every delay; with a delay of half a period "
        r"the passive damping ends at $1.296\,b$",
    )
