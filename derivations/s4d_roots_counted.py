r"""How many roots are unstable, at a cost that does not grow with the delay?

The zeros of the characteristic polynomial, or the inequalities of Jury, cost more with every
period of delay. By the argument principle it is enough to know how far the polynomial turns on
half the unit circle. It is a sum of two parts, one of the plant and one of the wall; where one of
them is larger, the sum turns with it.
"""

from symhaptic.book.figures.arguments import half_circle
from symhaptic.book.lemmas.prelude import *


def derive(page):
    y = symbols("y")
    top, wall, bottom = n_1 * z + n_0, (alpha + beta) * z - beta, z**2 - a * z + e
    page.say(
        "Write $p_1=f+g$ with the plant's part $f=z^{d+1}A$ and the wall's part $g=NW$, where "
        "$A=z^2-az+e$, $N=n_1z+n_0$ and $W=(\\alpha+\\beta)z-\\beta$. A root on the circle needs "
        "$|f|=|g|$. Let $y=4\\sin^2(\\theta/2)$, which goes from 0 at $z=1$ to 4 at $z=-1$:"
    )
    sizes = [
        ("A", bottom, (1 - a + e) ** 2 + ((1 - e) ** 2 - (1 - a + e) * (1 + e)) * y + e * y**2),
        ("N", top, (n_1 + n_0) ** 2 - n_1 * n_0 * y),
        ("W", wall, alpha**2 + (alpha + beta) * beta * y),
    ]
    page.define("The chord from $z$ to 1 has this square", y, 2 - z - 1 / z)
    for name, factor, form in sizes:
        page.step(
            f"On the circle $|{name}|^2$ is a polynomial in $y$",
            factor * factor.subs(z, 1 / z),
            form,
            name=f"|{name}(z)|^2",
        )
    page.say(
        "So $|f|^2-|g|^2$ is a polynomial of degree two in $y$, and the delay is not in it: there "
        "are at most two angles $\\theta_i$ in $(0,\\pi)$ at which plant and wall are equally "
        "large, the same ones for every delay. At $z=1$ the wall leads if $|\\alpha|>\\gamma$, "
        "as $1-a+e=\\gamma(n_1+n_0)$."
    )
    page.say("The phases are no harder. Each factor, turned by a power of $z$, keeps to one side:")
    for name, factor, height in (
        ("A/z", bottom / z, (1 - e) * sin(theta)),
        ("N", top, n_1 * sin(theta)),
        ("W", wall, (alpha + beta) * sin(theta)),
    ):
        turned = on_circle(factor)
        page.step(
            f"Imaginary part of ${name}$",
            (turned - turned.xreplace({I: -I})) / (2 * I),
            height,
            name=rf"\Im {name}",
            because="of one sign for $0<\\theta<\\pi$: the angle is an arctangent without jumps",
        )
    page.say(
        "With these angles, $\\Phi(\\theta)=\\arg N+\\arg W-\\arg(A/z)-(d+2)\\theta$ is the "
        "phase of $g/f$, continuous from 0 to $\\pi$. Where $f$ leads, $p_1=f\\,(1+g/f)$ and the "
        "bracket stays in the right half plane; where $g$ leads, $p_1=g\\,(1+f/g)$. At an angle "
        "where they are equal, the bracket stands at half the phase,"
    )
    page.step(
        "Equal parts add up at half the phase",
        1 + exp(I * phi),
        2 * cos(phi / 2) * exp(I * phi / 2),
        because="for $\\varphi=\\Phi-2\\pi k$ between $-\\pi$ and $\\pi$, that is for the whole "
        "number $k=[\\Phi/2\\pi]$ next to $\\Phi/2\\pi$",
    )
    page.say(
        "so that, passing from $f$ to $g$, the change of argument of $p_1$ differs from that of "
        "$f$ alone by $-\\Phi+\\varphi=-2\\pi k$, and passing back by $+2\\pi k$. On the whole "
        "half circle $f$ turns by $(d+3)\\pi$, since the poles of a damped and held plant lie "
        "inside, and $p_1$ by $\\pi$ times its roots inside. Of its $d+3$ roots therefore "
        "as many lie outside as twice the sum of $k$ over the angles where $g$ starts to lead, "
        "less twice the sum of $k$ over those where it stops, "
        "with $2k=\\arg g(1)/\\pi$ for a lead from "
        "$\\theta=0$ on, and $2k=\\arg g(-1)/\\pi-(d+3)$ for one that lasts to $\\theta=\\pi$. "
        "A square root and a few arctangents: the same work for $d=0$ as for $d=10^6$. For a "
        "plant without damper or spring the count is that of one with a little of it."
    )
    page.figure(
        "half_circle",
        "A wall with $\\alpha=0.55$, $\\beta=0.5$ behind one period of delay ($\\gamma=0.05$, "
        "$\\delta=0.4$). The wall leads up to $\\theta_1$, the plant beyond. Up to $\\theta_1$ the "
        "sum keeps to the wall's argument, and then to the plant's, but for a full turn: $k=-1$ "
        "where the wall stops to lead, so that two of four roots lie outside.",
        half_circle,
        panels=(1, 2),
        height=0.6,
    )
    page.say(
        "The same angles give the delays at which a root is on the circle: where $\\Phi$ is an odd "
        "multiple of $\\pi$. With $\\Phi_0=\\arg N+\\arg W-\\arg(A/z)$, for $z^d$ on the principal "
        "sheet,"
    )
    k, turned = symbols("k"), symbols("Phi_0")
    page.step(
        "The critical delays are an arithmetic sequence",
        turned - (d + 2) * theta + (2 * k + 1) * pi,
        (((turned + (2 * k + 1) * pi) / theta - 2) - d) * theta,
        because="zero for $d=(\\Phi_0+(2k+1)\\pi)/\\theta-2$ at $\\theta=\\theta_1,\\theta_2$",
    )
    page.say(
        "For whole delays the first whole number behind a critical one, if the loop does not "
        "recover before, is the first that is unstable."
    )
    m_2, m_1, m_0 = symbols("m_2 m_1 m_0")
    late, whole = m_2 * z**2 + m_1 * z + m_0, m_2 + m_1 + m_0
    form = whole**2 + ((m_2 - m_0) ** 2 - whole * (m_2 + m_0)) * y + m_2 * m_0 * y**2
    page.step(
        "A delay with a fraction has a numerator of degree two",
        late * late.subs(z, 1 / z),
        form,
        name="|M(z)|^2",
        because="with $M=m_2z^2+m_1z+m_0$; the surplus then has degree three, and the rest is the "
        "same",
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
        "the angles at which plant and wall are equally large ignore the delay",
        claim=every(walls, [], Iff((equal, then))),
    )
    there, here = (combined(q, [assume(p), 1]) for p, q in ((equal, then), (then, equal)))
    page.settle("counting-ignores-delay", for_all(walls, [], either_way(there, here, equal, then)))


def _size(of):
    """Real part squared and imaginary part squared."""
    mirror = of.xreplace({I: -I})
    return ((of + mirror) / 2) ** 2 + ((of - mirror) / (2 * I)) ** 2
