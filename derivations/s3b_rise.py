r"""Is the envelope the boundary of the passive walls?

Each frequency up to $\pi/(T(d+1))$ gives one point of the envelope. The envelope bounds the
passive walls if, for a given stiffness, the condition is strictest at one of these frequencies. We
use $\psi=\omega T/2$, $N=2(d+1)$, $u=KT/(2b)$ and $w=(B+KT/2)/b$. The question then reduces to the
signs of functions on $0<N\psi<\pi$ for $N>2$, and we prove each sign.
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
    page.lemma(r"$N\sin\psi$ exceeds $\sin N\psi$", flatter())
    page.lemma(r"$N\sin2\psi$ exceeds $\sin2N\psi$", width())
    page.lemma(r"$\sin N\psi>N\sin\psi\cos((N-1)\psi)$, by concavity of the sine", chord_before())
    page.lemma(r"$\sin N\psi$ exceeds $N\sin\psi\cos((N+1)\psi)$", chord_after())
    rising = bend().conclusion.right
    page.step(
        "The differences of the last two steps are factors of this slope",
        diff(rising, psi),
        4 * chord_before().conclusion.right * chord_after().conclusion.right / (N * sin(psi) ** 2),
        name=rf"\frac{{\partial}}{{\partial\psi}}\Bigl({latex(rising)}\Bigr)",
    )
    page.lemma("A factor of the slope of the stiffness $U$ on the envelope is positive", bend())
    wall = {d: N / 2 - 1, theta: 2 * psi}
    divisor = width().conclusion.right
    curve = page.step(
        "The normalised stiffness $U=KT/(2b)$ on the envelope is a quotient of sines",
        passivity.envelope()[0].subs(wall) * T / (2 * b),
        2 * N * sin(psi) ** 2 * sin(N * psi) / divisor,
        name="U",
    )
    page.step(
        r"The stiffness $U$ rises up to $N\psi=\pi/2$ and falls beyond",
        diff(curve, psi),
        2 * N**2 * sin(psi) ** 2 * cos(N * psi) * rising / divisor**2,
        name=r"\partial U/\partial\psi",
        because=r"the slope has the sign of $\cos N\psi$",
    )
    page.lemma("Up to $N\\psi=\\pi/2$ a larger angle has the larger stiffness", rises(LOWER))
    page.lemma(r"Above $N\psi=\pi/2$ a larger angle has the smaller stiffness", rises(UPPER))
    page.step(
        "For a given stiffness, the condition is strictest at the angle with $U=u$",
        diff((u * cot(psi) * sin(N * psi) - 1) / cos(N * psi), psi),
        divisor / (2 * sin(psi) ** 2 * cos(N * psi) ** 2) * (u - curve),
        name=r"\partial w/\partial\psi",
        because=r"the slope has the sign of $u-U$. On each side of $N\psi=\pi/2$ the condition "
        "is strictest at the angle with $U=u$: the smaller of these angles bounds $w$ from "
        "below, the larger one from above. If $u$ is less than the limit of $U$ for "
        r"$\theta\to0$, the lower bound is the line of $\theta\to0$",
    )
    page.lemma("The tip of the envelope has no negative margin at any angle", tip())
    page.lemma(
        "No wall on the envelope has a negative margin at any angle",
        touches(),
        because="for angles on the same side of the tip, this follows from the order of the "
        "bounds of $w$ at a given stiffness; for angles on the other side, from the "
        "larger stiffness of the tip",
    )
    page.say(
        r"For $N>2$, that is, $d>0$, the envelope from $\theta\to0$ to $\pi/(d+1)$ is therefore "
        r"part of the boundary. The line of $\theta\to0$ and the line $K=0$ close the boundary. "
        "For $d=0$ the slope of $U$ vanishes: the envelope shrinks to one point and the "
        "boundary is (6)."
    )
    page.step(
        "Without delay, the stiffness $U$ is constant along the envelope",
        curve.subs(N, 2),
        S.One,
        name=r"U|_{d=0}",
    )
    _boundary(page)


def _boundary(page):
    """The walls of (7) up to pi/(d+1), and no others, are the boundary above the corner."""
    printed = STATEMENTS["eq7"].printed
    then = taken_apart(page.claim("eq7"))[2]
    curve, others = then.of
    on_it = page.lemma(
        "A wall of (7) is passive, and requires exactly the damping $b$",
        on_boundary(*map(assume, printed)),
    )
    page.say(
        "Does the boundary have other walls, with more damping than the end of the line of "
        r"$\theta\to0$? This end is the corner of the boundary. Let a boundary wall have more "
        "damping than the corner, and $K>0$. The ray from the origin through this wall lies "
        "between the ray through the corner and the ray $K=0$. The walls of (7) cover all rays "
        "between these two:"
    )
    page.lemma(
        "The ray of a wall beyond the corner contains a wall of (7)",
        met(),
        because="the distance of a wall of (7) from the ray has different signs at the two ends "
        "of (7). Here $u$ is $KT/2$ and $w$ is $B+KT/2$: they are not divided by $b$",
    )
    page.lemma(
        "A wall on the boundary requires the same damping as the wall of (7) on its ray",
        needed_there(),
        because="with this damping the boundary wall is passive, and at the angle of the wall "
        "of (7) it requires at least this damping",
    )
    above = page.lemma(
        "Above the corner each wall on the boundary satisfies (7)",
        upper_boundary(others.of[1]),
        because="two walls on the same ray that require the same damping are equal; for $K=0$ "
        "the wall is $(0,b)$",
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
        shows=r"for $d=1$ and $\omega T=\tfrac23\pi$, (7) gives the wall $K=-4$, $B=2$, whose "
        "stiffness is negative",
        note="without delay, (7) is the single point $(2b/T,0)$, and the rest of the boundary is "
        "(6). For other $d>0$, (7) bounds the walls of (5). At higher frequencies the curve "
        "bounds nothing",
    )


UNDELAYED = {d: S.Zero, T: S.One, b: S.One}


def _wall(printed, at):
    """The wall that (7) gives at a frequency."""
    return at | {line.lhs: line.rhs.subs(at) for line in printed}


def _extent(page):
    page.say(
        "All frequencies up to the Nyquist frequency have a line, but only some of these lines "
        r"bound the region. We show, for every real $d\ge0$ and $K\ge0$, that the conditions at "
        r"frequencies above $\pi/(T(d+1))$ are redundant."
    )
    page.say(
        r"Let $\psi=\theta/2$, $N=2(d+1)\ge2$ and describe the wall by $u=KT/(2b)\ge0$ and "
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
        because=r"a passive wall has no negative margin, so $w\le1$",
    )
    page.limit(
        r"For $\psi\to0$ the margin has a linear limit",
        margin,
        psi,
        S.Zero,
        1 + w - N * u,
        name=r"\bigl(1-b_{\min}/b\bigr)",
        because=r"a passive wall has no negative margin, so $w\ge Nu-1\ge-1$",
    )
    page.step(
        r"If $N\psi$ and $N\varphi$ differ by $2\pi$, the margins differ only in a cotangent",
        cot(psi) - cot(phi),
        sin(phi - psi) / (sin(psi) * sin(phi)),
        because=r"the difference is positive for $\psi<\varphi<\pi/2$, since the cotangent falls",
    )
    page.say(
        r"Now let $N\psi>\pi$. If $\sin N\psi\ge0$, subtract a multiple of $2\pi$ from $N\psi$. "
        "The smaller angle has the same sine and cosine but a larger cotangent, so the "
        r"condition is stricter there, because $u\ge0$. If $\sin N\psi<0$, the margin is at "
        r"least $1-|w|\ge0$, because $-1\le w\le1$. So only $0<N\psi\le\pi$ matters, that is, "
        r"$0<\omega T\le\pi/(d+1)$."
    )
    page.lemma(
        r"A margin that is not negative for $0<N\psi\le\pi$ is not negative at any angle",
        at_every_angle(),
        because=r"subtracting multiples of $2\pi$ from $N\psi$ gives an angle with $N\psi\le\pi$ "
        "at which the condition is stricter",
        boxed=True,
    )
