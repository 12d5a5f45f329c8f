"""Is the computed stability boundary equal to the derived one?

The explicit boundary contains a quotient of two polynomials on the unit circle. Near the angle 0
cosines cancel in these polynomials. Formulas with half the angle avoid this cancellation.
"""

from symhaptic.book.lemmas.computed import settle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_boundary import BOUNDARY, LATE_BOUNDARY
from symhaptic.forms.entire import CosNext, SinNext

UNDEFINED = "if neither form divides by zero"


def derive(page):
    c, s = cos(theta / 2), sin(theta / 2)
    page.say(
        r"A root at $z=e^{j\theta}$ requires $\alpha+\beta(1-1/z)=Q$ with $Q=-z^{d+1}A/(zN)$ and "
        r"$N=n_1z+n_0$, so $\beta=\Im Q/\sin\theta$ and $\alpha=\Re Q-\beta(1-\cos\theta)$. "
        r"With a fractional delay $Q=-z^{\ell+1}A/M$ and $M=m_2z^2+m_1z+m_0$. In terms of half the "
        "angle, $A$, $N$ and $M$ are combinations of their values at $z=1$ and $z=-1$. Separate "
        r"functions compute these values (\chapter{s9a_computed_device} and "
        r"\chapter{s9a_computed_late_device}):"
    )
    page.step(
        "The values at 1 and $-1$ give the denominator on the circle",
        on_circle((z**2 - a * z + e) / z),
        (1 - a + e) * c**2 - (1 + a + e) * s**2 + 2 * I * s * c * (1 - e),
        name=r"A/z",
    )
    page.step(
        "The values at 1 and $-1$ give the numerator on the circle",
        on_circle(n_1 * z + n_0),
        (n_1 + n_0) * c**2 - (n_1 - n_0) * s**2 + 2 * I * s * c * n_1,
        name="N",
    )
    page.step(
        "With a fractional delay the values at 1 and $-1$ and a difference give the numerator",
        on_circle((m_2 * z**2 + m_1 * z + m_0) / z),
        (m_2 + m_1 + m_0) * c**2 - (m_2 - m_1 + m_0) * s**2 + 2 * I * s * c * (m_2 - m_0),
        name="M/z",
    )
    page.say(
        "Near the angle 0 the first two terms are small without a subtraction, since $1-a+e$ has "
        r"the factor $\gamma$. In contrast, the derived formula adds numbers near 1, $-2$ and 1 "
        r"and divides the sum by $\sin\theta$. We compute $p$ and $q$, the real and the imaginary "
        "part of $A/(zN)$, or of $A/M$. Two functions compute the sine and cosine of "
        r"$(d+1)\theta$ without rounding the product. A rounded product costs three digits for a "
        "delay of a thousand periods."
    )
    turned = r"(d,\theta)"
    for function, title in ((CosNext, "cosine"), (SinNext, "sine")):
        page.define(
            rf"One function is the {title} of $(d+1)\theta$, without rounding the product",
            rf"\mathrm{{{function.__name__}}}{turned}",
            function.definition(d, theta),
        )
    page.say(
        r"The wall is then $\beta=-(p\,\mathrm{SinNext}+q\,\mathrm{CosNext})/\sin\theta$ and "
        r"$\alpha=q\,\mathrm{SinNext}-p\,\mathrm{CosNext}-\beta\sin\theta\tan(\theta/2)$. For "
        r"the derivative another form with $r=q/(\cos(\theta/2)\sin(\theta/2))$ avoids a "
        "quotient that is 0/0 at the angle 0. The theorem proves the two forms."
    )
    settle(
        page,
        "stability_boundary",
        (BOUNDARY, LATE_BOUNDARY),
        "the computed wall at an angle is the derived one, for any coefficients of the device "
        f"and for integer and fractional delays, {UNDEFINED}",
    )
