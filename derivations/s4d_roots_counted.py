"""How can unstable roots be counted at a cost that does not grow with the delay?

Computing the zeros of the characteristic polynomial, or Jury's inequalities, costs more with every
period of delay. By the argument principle the number of roots follows from the change of the
polynomial's argument on half the unit circle. The polynomial is a sum of two terms, one of the
plant and one of the wall. At each angle the argument of the sum differs from that of the larger
term by less than a quarter turn.
"""

from symhaptic.book.figures.arguments import half_circle
from symhaptic.book.lemmas.prelude import *


def derive(page):
    y = symbols("y")
    top, wall, bottom = n_1 * z + n_0, (alpha + beta) * z - beta, z**2 - a * z + e
    page.say(
        "Write $p_1=f+g$ with the plant's part $f=z^{d+1}A$ and the wall's part $g=NW$, where "
        r"$A=z^2-az+e$, $N=n_1z+n_0$ and $W=(\alpha+\beta)z-\beta$. A root on the circle requires "
        r"$|f|=|g|$. Let $y=4\sin^2(\theta/2)$, which goes from 0 at $z=1$ to 4 at $z=-1$:"
    )
    sizes = [
        ("A", bottom, (1 - a + e) ** 2 + ((1 - e) ** 2 - (1 - a + e) * (1 + e)) * y + e * y**2),
        ("N", top, (n_1 + n_0) ** 2 - n_1 * n_0 * y),
        ("W", wall, alpha**2 + (alpha + beta) * beta * y),
    ]
    page.define("The number $y$ is the square of the chord from $z$ to 1", y, 2 - z - 1 / z)
    for name, factor, form in sizes:
        page.step(
            f"On the circle $|{name}|^2$ is a polynomial in $y$",
            factor * factor.subs(z, 1 / z),
            form,
            name=f"|{name}(z)|^2",
        )
    page.say(
        "So $|f|^2-|g|^2$ is a polynomial of degree two in $y$ that does not contain the delay. "
        r"At most two angles $\theta_i$ in $(0,\pi)$ give the two terms the same size, and these "
        r"angles are the same for every delay. At $z=1$ the wall dominates if $|\alpha|>\gamma$, "
        r"as $1-a+e=\gamma(n_1+n_0)$."
    )
    page.say(
        "We also need the phases of the two terms. Each factor times a power of $z$ stays in "
        "one half plane:"
    )
    for name, factor, height in (
        ("A/z", bottom / z, (1 - e) * sin(theta)),
        ("N", top, n_1 * sin(theta)),
        ("W", wall, (alpha + beta) * sin(theta)),
    ):
        turned = on_circle(factor)
        page.step(
            rf"The imaginary part of ${name}$ is a multiple of $\sin\theta$",
            (turned - turned.xreplace({I: -I})) / (2 * I),
            height,
            name=rf"\Im {name}",
            because=r"the imaginary part has one sign for $0<\theta<\pi$, so the phase is a "
            "continuous arctangent",
        )
    page.say(
        r"With these angles, $\Phi(\theta)=\arg N+\arg W-\arg(A/z)-(d+2)\theta$ is the phase of "
        r"$g/f$, continuous from 0 to $\pi$. Where $f$ dominates, $p_1=f\,(1+g/f)$ and the "
        r"bracket stays in the right half plane; where $g$ dominates, $p_1=g\,(1+f/g)$. At an "
        "angle where $f$ and $g$ have the same size, the phase of the bracket is half that of "
        "$g/f$:"
    )
    page.step(
        "The sum of two terms of equal size has the mean phase",
        1 + exp(I * phi),
        2 * cos(phi / 2) * exp(I * phi / 2),
        because=r"the equality is used for $\varphi=\Phi-2\pi k$ between $-\pi$ and $\pi$; the "
        r"integer $k=[\Phi/2\pi]$ is the one nearest to $\Phi/2\pi$",
    )
    page.say(
        "Where $g$ begins to dominate, the change of argument of $p_1$ differs from that of $f$ "
        r"alone by $-\Phi+\varphi=-2\pi k$. Where $g$ ceases to dominate, it differs by $+2\pi "
        "k$. The poles of a damped plant with a spring lie inside the unit circle, so the "
        r"argument of $f$ grows by $(d+3)\pi$ on the half circle. The argument of $p_1$ grows by "
        r"$\pi$ times the number of roots inside. The number of roots outside is therefore a "
        "difference of two sums. The first sum adds $2k$ over the angles where $g$ begins to "
        "dominate; the second sum adds $2k$ over the angles where $g$ ceases to dominate. If $g$ "
        r"already dominates at $\theta=0$, this angle belongs to the first sum, with $2k=\arg "
        r"g(1)/\pi$. If $g$ still dominates at $\theta=\pi$, this angle belongs to the second "
        r"sum, with $2k=\arg g(-1)/\pi-(d+3)$. The count takes a square root and a few "
        "arctangents, for $d=0$ as well as for $d=10^6$. A plant without damper or spring has "
        r"the same count as a plant with a small $\delta$ or $\gamma$."
    )
    page.figure(
        "half_circle",
        r"Arguments for the wall $\alpha=0.55$, $\beta=0.5$ with one period of delay "
        r"($\gamma=0.05$, $\delta=0.4$). The wall dominates up to $\theta_1$, and the plant beyond "
        r"$\theta_1$. Up to $\theta_1$ the sum follows the argument of the wall, and then that of "
        r"the plant minus $2\pi$. So $k=-1$ at the angle where the wall ceases to dominate, and "
        "two of four roots lie outside.",
        half_circle,
        panels=(1, 2),
        height=0.6,
    )
    page.say(
        r"The same angles give the delays at which a root is on the circle: $\Phi$ is then an odd "
        r"multiple of $\pi$. Let $\Phi_0=\arg N+\arg W-\arg(A/z)$ and $z^d=e^{jd\theta}$ (the "
        "principal sheet):"
    )
    k, turned = symbols("k"), symbols("Phi_0")
    page.step(
        "The critical delays are an arithmetic sequence",
        turned - (d + 2) * theta + (2 * k + 1) * pi,
        (((turned + (2 * k + 1) * pi) / theta - 2) - d) * theta,
        because=r"a root is on the circle for $d=(\Phi_0+(2k+1)\pi)/\theta-2$ with "
        r"$\theta=\theta_1$ or $\theta=\theta_2$",
    )
    page.say(
        "For integer delays, the loop is first unstable at the first integer above a critical "
        "delay, unless it becomes stable again before this integer."
    )
    m_2, m_1, m_0 = symbols("m_2 m_1 m_0")
    late, whole = m_2 * z**2 + m_1 * z + m_0, m_2 + m_1 + m_0
    form = whole**2 + ((m_2 - m_0) ** 2 - whole * (m_2 + m_0)) * y + m_2 * m_0 * y**2
    page.step(
        "With a fractional delay, the numerator has degree two",
        late * late.subs(z, 1 / z),
        form,
        name="|M(z)|^2",
        because="the numerator is $M=m_2z^2+m_1z+m_0$; the surplus then has degree three, and the "
        "rest of the argument is the same",
    )
    _equally_large(page)


def _equally_large(page):
    turn = exp(I * theta)
    plant = exp(I * (d + 1) * theta) * (turn**2 - a * turn + e)
    wall = (n_1 * turn + n_0) * ((alpha + beta) * turn - beta)
    later = symbols("d'")
    equal = Relation(_size(plant), "=", _size(wall))
    then = equal.at({d: later})
    walls = (alpha, beta, n_1, n_0, a, e, theta, d, later)
    page.state(
        "counting-ignores-delay",
        "the angles at which plant and wall have the same size do not depend on the delay",
        claim=every(walls, [], Iff((equal, then))),
    )
    there, here = (combined(q, [assume(p), 1]) for p, q in ((equal, then), (then, equal)))
    page.settle("counting-ignores-delay", for_all(walls, [], either_way(there, here, equal, then)))


def _size(of):
    """The square of the absolute value."""
    mirror = of.xreplace({I: -I})
    return ((of + mirror) / 2) ** 2 + ((of - mirror) / (2 * I)) ** 2
