"""Is the computed stability boundary the derived one?

The explicit boundary contains a quotient of two polynomials on the unit circle, in which cosines
cancel near the angle 0. They are computed with half the angle, which avoids the cancellation.
"""

from symhaptic.book.lemmas.computed import settle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_boundary import BOUNDARY, LATE_BOUNDARY
from symhaptic.forms.entire import CosNext, SinNext

UNDEFINED = "wherever neither form divides by zero"


def derive(page):
    c, s = cos(theta / 2), sin(theta / 2)
    page.say(
        r"A root at $z=e^{j\theta}$ needs the wall $Q=-z^{d+1}A/(zN)$ with $N=n_1z+n_0$, whose "
        r"parts give $\beta=\Im Q/\sin\theta$ and $\alpha=\Re Q-\beta(1-\cos\theta)$; with a "
        r"fractional delay it is $-z^{\ell+1}A/M$ with $M=m_2z^2+m_1z+m_0$. With half the angle "
        "all three polynomials are combinations of their values at $z=1$ and $z=-1$. These "
        r"values are computed by separate functions, see \chapter{s9a_computed_device} and "
        r"\chapter{s9a_computed_late_device}:"
    )
    page.step(
        "On the circle the denominator is given by its values at 1 and $-1$",
        on_circle((z**2 - a * z + e) / z),
        (1 - a + e) * c**2 - (1 + a + e) * s**2 + 2 * I * s * c * (1 - e),
        name=r"A/z",
    )
    page.step(
        "On the circle the numerator is given by its values at 1 and $-1$",
        on_circle(n_1 * z + n_0),
        (n_1 + n_0) * c**2 - (n_1 - n_0) * s**2 + 2 * I * s * c * n_1,
        name="N",
    )
    page.step(
        "With a fractional delay the numerator is given by its values in the same way",
        on_circle((m_2 * z**2 + m_1 * z + m_0) / z),
        (m_2 + m_1 + m_0) * c**2 - (m_2 - m_1 + m_0) * s**2 + 2 * I * s * c * (m_2 - m_0),
        name="M/z",
    )
    page.say(
        "Near the angle 0 the first two terms are as small as $A$ is: $1-a+e$ has the factor "
        r"$\gamma$, and $s^2$ is small without a subtraction. The derived formula adds numbers "
        r"near 1, $-2$ and 1 and divides the sum by $\sin\theta$. We compute $p$ and $q$, the "
        "real and the imaginary part of $A/(zN)$, or of $A/M$. Two functions compute the sine "
        r"and cosine of $(d+1)\theta$ without rounding the product: with a rounded product a "
        "delay of a thousand periods would cost three digits."
    )
    turned = r"(d,\theta)"
    for function, title in ((CosNext, "cosine"), (SinNext, "sine")):
        page.define(
            f"The {title} of $(d+1)\\theta$, without rounding the product",
            rf"\mathrm{{{function.__name__}}}{turned}",
            function.definition(d, theta),
        )
    page.say(
        r"The wall is then $\beta=-(p\,\mathrm{SinNext}+q\,\mathrm{CosNext})/\sin\theta$ and "
        r"$\alpha=q\,\mathrm{SinNext}-p\,\mathrm{CosNext}-\beta\sin\theta\tan(\theta/2)$. For the "
        "derivative it is written without a quotient that is 0/0 at the angle 0, with "
        r"$r=q/(\cos(\theta/2)\sin(\theta/2))$. The theorem proves both forms."
    )
    settle(
        page,
        "stability_boundary",
        (BOUNDARY, LATE_BOUNDARY),
        "the computed wall at an angle is the derived one, for any numbers of the device, behind "
        f"integer delays and with fractional delays, {UNDEFINED}",
    )
