r"""Which walls are just passive at a given frequency?

At one frequency the condition is a half plane in the $(K,B)$ plane, bounded by a line. As the
frequency changes the line turns and shifts, and its neighbours cut off a curve: the envelope.
"""

from sympy import Eq, S, diff, sin

from symhaptic.model import passivity
from symhaptic.notation import B, K, T, b, d, theta, x


def derive(page):
    line = page.define("The line of one angle", r"F(\theta)", passivity.margin())
    stiffness, damping = passivity.envelope()
    page.say(
        "Two neighbouring lines meet where both $F$ and $\\partial F/\\partial\\theta$ vanish: two "
        "linear equations for $K$ and $B$, with one solution."
    )
    shared = sin(2 * (d + 1) * theta) - 2 * (d + 1) * sin(theta)
    nice_stiffness = page.step(
        "Stiffness",
        stiffness,
        2
        * b
        * (d + 1)
        * (sin((d + 2) * theta) - 2 * sin((d + 1) * theta) + sin(d * theta))
        / (T * shared),
        name=K,
        paper="7",
    )
    nice_damping = page.step(
        "Damping",
        damping,
        2 * b * (d * sin((d + 1) * theta) - (d + 1) * sin(d * theta)) / shared,
        name=B,
        paper="7",
    )
    on_curve = {K: nice_stiffness, B: nice_damping}
    page.step("The point lies on the line", line.subs(on_curve), S.Zero, name=r"F\big|_{(K,B)}")
    page.step(
        "It lies on the neighbour too",
        diff(line, theta).subs(on_curve),
        S.Zero,
        name=r"\partial F/\partial\theta\,\big|_{(K,B)}",
    )
    page.say(
        "Both coordinates are proportional to $b$. The product $KT$ does not contain $T$: the "
        "stiffness is proportional to $1/T$, the sampling rate, and not to the period."
    )
    page.settle(
        "s3b-linear-in-T",
        page.free_of("stiffness times period", stiffness * T, T),
        page.same("stiffness by damping", stiffness.subs(b, x * b), x * nice_stiffness),
        page.same("damping by damping", damping.subs(b, x * b), x * nice_damping),
        corrected=(r"K\propto b/T", r"B\propto b"),
        unless={d: S.One, theta: S.One, b: S.One, T: S.One},
        truth=Eq(nice_stiffness.subs(T, 2 * T), 2 * nice_stiffness),
        shows="twice the period halves the stiffness",
    )
