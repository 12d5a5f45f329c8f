r"""What do faster sampling and more mass gain?

The conclusion of the paper: much faster sampling does not gain much where the delay outweighs it,
and more mass gains nothing. Here the delay $t_d=dT$ is kept while $T$ shrinks.
"""

from sympy import Rational, S, cos, diff, pi, sin, tan

from symhaptic.bounds.walls import most, over
from symhaptic.model import plant, wall
from symhaptic.notation import B, K, T, b, d, function, h, k, m, phi, psi, t_d, z
from symhaptic.proof import box, sign
from symhaptic.proof.certificate import Known
from symhaptic.proof.enclosed import given, value
from symhaptic.proof.roots import zero

LONG = phi**2 * cos(phi)


def derive(page):
    passive(page)
    facts = stable(page)
    page.settle(
        "s6-faster-sampling",
        *facts,
        provided=r"t_d\ge10\,T,\ \text{and}\ b=k=0\ \text{for the stable stiffness}",
        unless={d: S.One},
        truth=(2 * K - h > 0, facts[-1]),
        shows=r"at $d=1$, where the delay is twice the half period of the hold, endlessly fast "
        r"sampling gives a free mass 3.8 times the stable stiffness",
        note=r"at most $1+1/d$ times the passive and $(1+1/d)^2$ times the stable stiffness",
    )
    heavier(page)


def passive(page):
    """The passive stiffness for a given delay in seconds."""
    stiffness = 2 * b / T * tan(pi / (4 * (d + 1)))
    scaled = page.step(
        "The largest passive stiffness, (11), with $T=t_d/d$",
        (stiffness * t_d / b).subs(T, t_d / d),
        2 * d * tan(pi / (4 * (d + 1))),
        name=r"Kt_d/b",
    )
    in_h = scaled.subs(d, 1 / h - 1)
    page.limit("Endlessly fast sampling", in_h, h, S.Zero, pi / 2, name=r"Kt_d/b", because="")
    page.say("with $h=1/(d+1)$. How much is missing at a finite rate?")
    up, end = sign.assume(psi), sign.assume(pi / 2 - psi)
    low = sign.Interval(psi, S.Zero, (end, sign.number(S.One)))
    sine = sign.sine(up, sign.combined(pi - psi, [end], [sign.number(pi / 2)]))
    chord = sin(psi) - psi * cos(psi)
    above = sign.integrated(chord, low, sign.combined(diff(chord, psi), [up, sine]))
    page.positive(
        "The tangent is above its angle",
        above,
        r"0<\psi<\tfrac\pi2",
        because="so $Kt_d/b\\ge\\frac\\pi2\\frac d{d+1}$ with $\\psi=\\frac\\pi4h$: the gain is at "
        "most $1+\\frac1d$, for any device",
    )


def stable(page):
    """The stable stiffness of a free mass, likewise."""
    page.say(
        "For a free mass $Kt_d^2/m=d^2\\alpha_{\\max}$. In the chapter on long delays "
        "$(d+1)^2\\alpha_{\\max}$ falls with the delay, to $\\varphi_*^2\\cos\\varphi_*$, which is "
        "what endlessly fast sampling gives. So the gain is at most $(1+\\frac1d)^2$: 21 % for "
        "$d=10$, and 10 % for the passive stiffness. With little delay it is more:"
    )
    angle = zero(2 * cos(phi) - phi * sin(phi), phi, S.One, Rational(11, 10))
    limit = value(LONG, {phi: angle})
    now = {n: most(S.Zero, S.Zero, n) for n in (1, 10)}
    page.enclosed(
        "The gain of a free mass",
        [
            (rf"d={n}:\quad\text{{gain}}", over(limit, over(n**2 * S.One, over(S.One, now[n]))))
            for n in now
        ],
    )
    gap = box.positive(h - 2 * K, {}, Known(given({h: limit, K: now[1]})))
    ten = box.positive(121 * K - h, {}, Known(given({h: limit, K: now[10]})))
    return [ten, gap]


def heavier(page):
    """More mass and equally more stiffness."""
    device = plant.sampled(plant.Plant(), T)
    physical = device.denominator + device.numerator * wall.delayed()
    grown = {m: 2 * m, K: 2 * K, B: 2 * B, b: 2 * b, k: 2 * k}
    proof = page.same("the same loop", physical.xreplace(grown), physical)
    page.show(
        "Twice the mass and everything else",
        r"p(z)\big|_{2m,\,2K,\,2B,\,2b,\,2k}",
        function("p")(z),
        proof,
        because="the roots, and with them every motion, stay as they are; so does $K/m$",
    )
