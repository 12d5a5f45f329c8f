r"""With a delay of half a period, does stability in the paper's reading imply stability?

For a fractional delay the paper puts $z^{-d}=e^{-jd\theta}$ into the polynomial of an integer
delay. We compare this with the exact polynomial for a free mass and $d=\ell+\tfrac12$. The two
boundaries are $Q=-z^{\ell+1}A/M$ and $Q_p=-z^dA/N$. Every stable wall is stable in the paper's
reading, but not conversely.
"""

from symhaptic.book.lemmas.half_late_circle import (
    LOOP,
    PUSH,
    TRUE,
    WALL,
    counted,
    differs,
    no_crossing,
    path,
    pushes,
    q,
    zeros,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.principal import FREE, in_truth, one_error, read_loop, read_too_largely
from symhaptic.proof.theorems.roots import none_enters


def derive(page):
    free = fractional.late(plant.normalised(Parts(stiffness=False, damping=False)))
    poles = free.device.denominator
    exact = -(z ** (l + 1)) * poles / free.numerator
    printed = -(z ** (l + epsilon)) * poles / free.device.numerator
    top = on_circle(free.numerator)
    page.step(
        "For every fraction, $|M|$ is larger than $|N|$",
        top * top.xreplace({I: -I}),
        cos(theta / 2) ** 2 + 4 * epsilon**2 * (1 - epsilon) ** 2 * sin(theta / 2) ** 4,
        name="|M|^2",
        because=r"here $|N|^2=\cos^2\frac\theta2$, so $|Q|\le|Q_p|$",
    )
    ratio = on_circle(exact / printed)
    page.limit(
        "The phases of the two boundaries differ by a term of third order in the angle",
        (ratio - real_part(ratio)) / (I * theta**3),
        theta,
        S.Zero,
        epsilon * (1 - epsilon) * (1 - 2 * epsilon) / 12,
        name=r"\frac{1}{\theta^3}\,\Im\frac{Q}{Q_p}",
        because=r"the phase of the exact delay is larger for a fraction below $\frac12$, and "
        r"smaller for a fraction above $\frac12$",
    )
    half, c = {epsilon: S.Half}, cos(theta / 2)
    shrinks = page.step(
        "With a delay of half a period the wall on the exact boundary is the smaller one",
        ratio.subs(half),
        2 * c / (1 + c**2),
        name="Q/Q_p",
        because=r"the ratio is positive, and less than 1 as $(1-\cos\frac\theta2)^2>0$",
    )
    page.step(
        "With a delay of half a period the two boundaries $Q$ and $Q_p$ have the same phase",
        on_circle(printed.subs(half)) * exp(-I * (l + 1) * theta),
        4 * sin(theta / 2) ** 2 / c,
        name=r"Q_p\,e^{-j(\ell+1)\theta}",
        because=r"the quotient is positive, so $Q$ and $Q_p$ have the phase $(\ell+1)\theta$",
    )
    page.step(
        "The two boundaries are farthest apart at $\\ell=0$, $\\theta=\\frac\\pi3$",
        1 - shrinks.subs(theta, pi / 3),
        1 - 4 * sqrt(3) / 7,
        name="1-Q/Q_p",
        because=r"the difference is 1.03\,\%; it increases with $\theta$, and the first arc ends "
        r"at $\theta=\pi/(2\ell+3)$",
    )
    page.say(
        "So the exact boundary is slightly closer to the origin. This comparison covers the "
        "first arcs only. To compare the regions, we deform the exact loop into that of the "
        r"paper's reading and follow the roots $\zeta=\sqrt z$ with $\Re\zeta>0$. The two "
        r"polynomials differ by a term that is small near $\zeta=1$:"
    )
    polynomial = fractional.characteristic(Parts(False, False)).subs(half)
    wall = (alpha + beta) * z - beta
    theirs = z ** (l + S.Half) * z * poles + free.device.numerator * wall
    late = (sqrt(z) - 1) ** 4 / 8
    page.step(
        "The polynomial of the paper's reading is the exact one plus a term",
        on_circle(sqrt(z) * theirs - polynomial),
        on_circle(-late * wall),
        name=r"\zeta\,p_p(\zeta)-p_1(\zeta^2)\big|_{\zeta=e^{j\theta/2}}",
        because=r"the term is $-\tfrac18(\zeta-1)^4\bigl((\alpha+\beta)\zeta^2-\beta\bigr)$. The "
        "proof multiplies this term by a factor $q$ from 0 to 1; for $q=0$ no root of a stable "
        r"loop has $|\zeta|\ge1$",
    )
    page.step(
        "On the circle the term reduces the wall slightly",
        on_circle((free.numerator.subs(half) - q * late) / z),
        (1 + c**2) / 2 - q * (1 - c) ** 2 / 2,
        name=r"\frac{1}{z}\Bigl(M-\frac{q}{8}(\zeta-1)^4\Bigr)",
        because="the factor is real, so a root on the circle is a root of the exact loop with "
        r"a wall $yW$. Here $W=\alpha+\beta(1-1/z)$ and "
        r"$1-y=q(1-\cos\frac\theta2)^2/(1+\cos^2\frac\theta2)$",
    )
    page.say(
        "Such a root is impossible if the wall $W$ itself is stable. The phase of a polynomial "
        "of degree $n$ with all roots inside increases along the circle at a rate of more than "
        r"$\frac n2$. At this root $p_1=-(1-y)z^{\ell+2}A/y$, and the phase of $p_1$ rises by "
        r"$(\ell+3-(1+w)/y)/(1-1/y)$, where $w$ is the rate for $zW$. So "
        r"$w>\frac12(\ell+2)(1+y)$, which is nearly $\ell+2$. The next step contradicts this "
        "inequality:"
    )
    needed = {
        alpha: (sin((l + 2) * theta) - sin((l + 1) * theta)) / sin(theta),
        beta: sin((l + 1) * theta) / sin(theta),
    }
    page.step(
        "On the boundary the phase of the wall increases more slowly",
        real_part(on_circle((alpha + beta) * z / wall)).subs(needed),
        sin((l + 2) * theta) * cos((l + 1) * theta) / sin(theta),
        name="w",
        because="$Q$ has the phase $(\\ell+1)\\theta$. The rate $w$ is at most "
        "$1+(\\ell+1)\\cos^2\\theta$ for $\\theta<\\frac\\pi2$, and at most 1 for larger angles, "
        "since $\\beta>0$: $2p_1'(1)-(\\ell+4)p_1(1)=2\\beta-\\ell\\alpha$ is positive, and so is "
        "$p_1(1)=\\alpha$",
    )
    page.lemma(
        "No root crosses the half circle",
        no_crossing(),
        because="the half circle consists "
        r"of the points $\zeta=e^{j\psi}$",
    )
    page.lemma(
        "No root crosses the imaginary axis outside the circle",
        on_the_axis(),
        because=r"on the axis $\zeta=je^\psi$ and $z<0$, so only the term has an imaginary "
        "part",
    )
    found = page.lemma(
        "Every stable wall is stable in the paper's reading",
        stable_as_read(),
        because=r"the exact loop has no root with $\Re\zeta>0$ and $|\zeta|\ge1$, and none enters "
        r"this region during the deformation",
        boxed=True,
    )
    page.state(
        "fractional-half-mass",
        r"with a delay of half a period, $d=\ell+\tfrac12$, a wall that keeps a free mass stable "
        "is stable in the paper's reading",
        claim=half_late_mass(),
    )
    point, held = stands()
    page.settle("fractional-half-mass", found, example=(point, held))
    found = page.lemma(
        "Some wall is stable in the paper's reading and unstable in the exact loop",
        one_error(),
        because=r"the wall $(\alpha,\beta)=(\tfrac1{15},\tfrac{16}{15})$ lies between the two "
        r"boundaries for $\ell=0$, and balls around all roots prove both statements",
    )
    page.state(
        "fractional-half-mass-apart",
        "with a delay of half a period some wall is stable for a free mass in the paper's "
        "reading, the principal sheet, and unstable in the exact loop",
        claim=read_too_largely(),
    )
    page.settle("fractional-half-mass-apart", found)


# With half a period of delay a stable wall of a free mass is stable in the paper's reading.
#
# The loop has the polynomial F(z), and the paper's reading has P(v) with v^2 = z and v P(v) =
# F(v^2) - (v-1)^4 W(v^2)/8.  Along F(v^2) - q (v-1)^4 W(v^2)/8, 0 < q <= 1, no zero crosses the
# border of the region 0 < Re v, 1 <= |v|.

READ = Predicate("stable_principal", (), LOOP)
v = Symbol("v")


def half_late_mass() -> Proposition:
    """A wall that is stable with a delay of half a period is stable on the principal sheet."""
    return every((alpha, beta, l), [whole(l), TRUE], READ)


@cache
def on_the_axis() -> Theorem:
    """On the imaginary axis outside the circle the polynomial is not zero."""
    _, brake, stiff = pushes()
    size, sign = exp(psi), exp(I * pi * l)
    above = [sign_of(exp, psi), assume(q > 0)]
    longer = closed(rising(exp, S.Zero, 2 * psi), positive(2 * psi > 0, [2, psi > 0]))
    imaginary = q * size * (size**2 - 1) * (PUSH * size**2 + beta)
    pushed = [*above, longer, stiff, sign_of(exp, 2 * psi)], [*above, longer, brake]
    turns = full_turns(S.Zero, assume(whole(l)))
    sine, cosine = (conjunct(turns, claim) for claim in turns.conclusion.parts)
    real = combined(Eq(sign, 1 / sign), [cosine, 1 / sign], [sine, I / sign])
    there = path(psi + I * pi / 2)
    zero = assume(Eq(there, 0))
    none = combined(
        Relation(imaginary, "=", S.Zero),
        [zero, -I],
        [mirrored(zero), I],
        [real, I * exp(2 * psi * (l + 2)) * (size**2 + 1) ** 2],
    )
    return differs(there, not_intro(combined(imaginary > 0, *pushed), none))


@cache
def stable_as_read() -> Theorem:
    static = positive(Ne(alpha, 0), pushes()[0])
    change = -((v - 1) ** 4) * (PUSH * v**2 - beta) / 8
    shown = no_crossing(), static, on_the_axis()
    never = none_enters(zeros(), change, (v, q, psi, x, y), *shown)
    sheet = read_loop(FREE, WALL, l)
    outside, apart = sheet.conclusion.parts[1].body.of
    known = at(never, {x: x, y: y}, *map(assume, outside.of))
    here = x + I * y
    root = assume(Eq(here, 0))
    twice = combined(Relation(2 * x, "=", S.Zero), [root], [mirrored(root)])
    right = differs(here, not_intro(positive(2 * x > 0, [2, x > 0]), twice))
    found = closed(factor(apart.left, known, -here), right)
    found = mp(sheet, for_all((x, y), outside.of, found))
    return for_all((alpha, beta, l), [whole(l), TRUE], counted(found))


def stands() -> tuple[dict[Any, Expr], Theorem]:
    """A wall that is stable with a delay of half a period."""
    wall: dict[Any, Expr] = {alpha: Rational(1, 20), beta: Rational(1, 2)}
    return {**wall, l: S.Zero}, in_truth(FREE, wall, True)
