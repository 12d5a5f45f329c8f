r"""Is the envelope the boundary of the passive walls?

Each frequency up to $\pi/(T(d+1))$ gives one point of the envelope. The envelope bounds the passive
walls if, for a given stiffness, one of these frequencies is stricter than all others. With
$\psi=\omega T/2$, $N=2(d+1)$, $u=KT/(2b)$ and $w=(B+KT/2)/b$ as before, this reduces to signs of
functions on $0<N\psi<\pi$ for $N>2$; each sign is proved.
"""

from symhaptic.book.lemmas.chords import bend, chord_after, chord_before, flatter, width
from symhaptic.book.lemmas.envelope import LOWER, UPPER, rises
from symhaptic.book.lemmas.motions import STEPS, half_late, not_on_boundary
from symhaptic.book.lemmas.passive_boundary import on_boundary
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import at_every_angle
from symhaptic.book.lemmas.tip import tip
from symhaptic.book.lemmas.touching import touches
from symhaptic.book.lemmas.upper_boundary import met, needed_there, upper_boundary
from symhaptic.notation.latex import latex
from symhaptic.paper.propositions.passivity import BORDER


def derive(page):
    _extent(page)
    page.lemma("The sine of the larger angle is flatter", flatter())
    page.lemma("The sine of twice the larger angle is flatter", width())
    page.lemma(r"$\sin N\psi>N\sin\psi\cos((N-1)\psi)$, by concavity of the sine", chord_before())
    page.lemma("The chord after the angle is positive", chord_after())
    rising = bend().conclusion.right
    page.step(
        "Two chords are the factors of the slope",
        diff(rising, psi),
        4 * chord_before().conclusion.right * chord_after().conclusion.right / (N * sin(psi) ** 2),
        name=rf"\frac{{\partial}}{{\partial\psi}}\Bigl({latex(rising)}\Bigr)",
    )
    page.lemma("The slope's numerator rises from zero", bend())
    wall = {d: N / 2 - 1, theta: 2 * psi}
    divisor = width().conclusion.right
    curve = page.step(
        "The envelope's stiffness has this form",
        passivity.envelope()[0].subs(wall) * T / (2 * b),
        2 * N * sin(psi) ** 2 * sin(N * psi) / divisor,
        name="U",
    )
    page.step(
        "The envelope's stiffness rises to $N\\psi=\\pi/2$ and falls after",
        diff(curve, psi),
        2 * N**2 * sin(psi) ** 2 * cos(N * psi) * rising / divisor**2,
        name=r"\partial U/\partial\psi",
        because="its sign is that of $\\cos N\\psi$",
    )
    page.lemma("Up to $N\\psi=\\pi/2$ a larger angle has the larger stiffness", rises(LOWER))
    page.lemma("From $N\\psi=\\pi/2$ on a larger angle has the smaller stiffness", rises(UPPER))
    page.step(
        "For a given stiffness the angle with $U=u$ is the strictest",
        diff((u * cot(psi) * sin(N * psi) - 1) / cos(N * psi), psi),
        divisor / (2 * sin(psi) ** 2 * cos(N * psi) ** 2) * (u - curve),
        name=r"\partial w/\partial\psi",
        because="its sign is that of $u-U$. On each side of $N\\psi=\\pi/2$ the strictest angle is "
        "the one with $U=u$: the lower one bounds $w$ from below, the upper one from above. Where "
        "$u$ is less than $U$ at $\\theta\\to0$, the lower bound is the line of $\\theta\\to0$",
    )
    page.lemma("The tip leaves a margin at every angle", tip())
    page.lemma(
        "Every wall of the envelope leaves a margin at every angle",
        touches(),
        because="for angles on the same side of the tip this follows from the order of the "
        "borders, and for angles on the other side from the larger stiffness of the tip",
    )
    page.say(
        "For $N>2$, that is $d>0$, the envelope from $\\theta\\to0$ to $\\pi/(d+1)$ is therefore "
        "on the boundary, closed by the line of $\\theta\\to0$ below and by $K=0$. For $d=0$ the "
        "slope of $U$ vanishes: the envelope shrinks to one point and the boundary is (6)."
    )
    page.step(
        "Without delay the envelope's stiffness does not change",
        curve.subs(N, 2),
        S.One,
        name=r"U|_{d=0}",
    )
    _boundary(page)


def _boundary(page):
    """The walls of (7), and above the corner no others, with integer delays and up to pi/(d+1)."""
    printed = STATEMENTS["eq7"].printed
    then = taken_apart(page.claim("eq7"))[2]
    curve, others = then.of
    on_it = page.lemma(
        "A wall of (7) is passive, and requires exactly the damping $b$",
        on_boundary(*map(assume, printed)),
    )
    page.say(
        "Does the boundary have other walls, with more damping than the end of the line of "
        r"$\theta\to0$? Let a boundary wall have more damping than that end, and $K>0$. The ray "
        "from the origin through this wall lies between the ray through the end of the line and "
        "the ray $K=0$. The walls of (7) cover all rays in between:"
    )
    page.lemma(
        "Of the walls of (7) one lies on the ray of a wall beyond the corner",
        met(),
        because="the distance of the wall from the ray has different signs at both ends, here with "
        "$u=KT/2$ and $w=B+KT/2$, not divided by $b$",
    )
    page.lemma(
        "A wall of the boundary requires the same damping as the wall of (7) on its ray",
        needed_there(),
        because="with this damping the wall is passive, and at this angle it requires no less "
        "damping",
    )
    above = page.lemma(
        "Above the corner each wall of the boundary is one of (7)",
        upper_boundary(others.of[1]),
        because="both walls require the same damping, so that they are equal; for $K=0$ the wall "
        "is $(0,b)$",
        boxed=True,
    )
    found = conj(
        disch(add_assum(on_it, *curve.of[0].of), curve.of[0]),
        disch(closed(above, conjunct(assume(others.of[0]), BORDER)), others.of[0]),
    )
    end = omega <= pi / (T * (d + 1))
    half = _wall(printed, {d: S.Half, T: S.One, b: S.One, omega: pi / 3})
    high = _wall(printed, {d: S.One, T: S.One, b: S.One, omega: 2 * pi / 3})
    stiffness, damping = (e.subs(theta, omega * T) for e in passivity.envelope())
    page.settle(
        "eq7",
        found,
        Eq(K, stiffness),
        Eq(B, damping),
        example=_wall(printed, UNDELAYED | {omega: pi / 2}),
        unless={
            whole(d): (half, not_on_boundary(then, half, half_late(Rational(17, 10)))),
            end: (high, not_on_boundary(then, high, STEPS)),
        },
        shows=r"for $d=1$, $\omega T=\tfrac23\pi$ (7) gives $K=-4$, $B=2$: it has a negative "
        "stiffness",
        note="without delay (7) is the single point $(2b/T,0)$, and the rest of the boundary is "
        "(6); for other $d>0$ it bounds the walls of (5); higher frequencies bound nothing",
    )


UNDELAYED = {d: S.Zero, T: S.One, b: S.One}


def _wall(printed, at):
    """The wall that (7) gives at a frequency."""
    return at | {line.lhs: line.rhs.subs(at) for line in printed}


def _extent(page):
    page.say(
        "The envelope is drawn by frequencies up to Nyquist, but only some of the lines bound "
        "the region. We show, for every real $d\\ge0$ and $K\\ge0$, that the conditions at "
        "frequencies above $\\pi/(T(d+1))$ are redundant."
    )
    page.say(
        r"Let $\psi=\theta/2$, $N=2(d+1)\ge2$ and write the wall with $u=KT/(2b)\ge0$ and "
        "$w=(B+KT/2)/b$. The condition is then linear in $u$ and $w$:"
    )
    wall = {K: 2 * b * u / T, B: b * (w - u), d: N / 2 - 1, theta: 2 * psi}
    margin = page.step(
        "The margin over $b$ is linear in $u$ and $w$",
        passivity.margin().subs(wall) / b,
        1 - u * cot(psi) * sin(N * psi) + w * cos(N * psi),
        name=r"1-b_{\min}/b",
    )
    page.step(
        r"At $N\psi=\pi$ the condition depends on $w$ only",
        margin.subs(psi, pi / N),
        1 - w,
        name=r"1-b_{\min}/b",
        because="so $w\\le1$",
    )
    page.limit(
        "At the lower end the margin is a line",
        margin,
        psi,
        S.Zero,
        1 + w - N * u,
        name=r"\bigl(1-b_{\min}/b\bigr)",
        because="so $w\\ge Nu-1\\ge-1$",
    )
    page.step(
        r"Angles with $N\psi$ differing by $2\pi$ differ only in a cotangent",
        cot(psi) - cot(phi),
        sin(phi - psi) / (sin(psi) * sin(phi)),
        because=r"the difference is positive for $\psi<\varphi<\pi/2$, since the cotangent falls",
    )
    page.say(
        r"Beyond $N\psi=\pi$: where $\sin N\psi\ge0$, the angle with $N\psi$ smaller by $2\pi$ "
        r"has the same sine and cosine but a larger cotangent, and is stricter since $u\ge0$. "
        r"Where $\sin N\psi<0$, the margin is at least $1-|w|\ge0$ by the two limits above. So "
        r"only $0<N\psi\le\pi$ matters, that is $0<\omega T\le\pi/(d+1)$."
    )
    page.lemma(
        r"A margin for $0<N\psi\le\pi$ implies a margin at every angle",
        at_every_angle(),
        because=r"multiples of $2\pi$ are subtracted from $N\psi$",
        boxed=True,
    )
