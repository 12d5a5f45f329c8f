r"""What happens to the loop when the spring swings with the Nyquist frequency?

The device returns to its mirror image after each period, a little smaller if it is damped. We ask
what this leaves to the wall.
"""

from symhaptic.book.lemmas.mirror import inside, mirrored_pole, split, triangle
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import loop
from symhaptic.paper.propositions.comparison import kept_at_minus_one, q
from symhaptic.proof.theorems.familiar import held_by_a_pole


def derive(page):
    page.say(
        "Without damping the sampled device degenerates there: it returns to its mirror image "
        "after each period. Its numerator shares the double pole at $-1$ once."
    )
    page.step(
        "At $\\gamma=\\pi^2$, $\\delta=0$ the polynomial has the factor $z+1$",
        loop.characteristic(Parts(damping=False)).subs(gamma, pi**2),
        (z + 1) * ((z + 1) * z ** (d + 1) + 2 * ((alpha + beta) * z - beta) / pi**2),
        name="p_1(z)",
        because="the root at $-1$ is there for every wall and every delay",
    )
    pole = page.lemma(
        "Without damping a pole lies at $-1$, and no wall moves it",
        mirrored_pole(S.Zero),
        because="for a delay of $\\ell/q$ periods $w=e^{j\\pi/q}$ is a zero of the polynomial in "
        "$w$, and $w^q=-1$",
    )
    page.lemma(
        "For whole delays $-1$ is a zero of the device that the sampled motion does not show",
        split(),
        because="the polynomial is $z+1$ times another one, which is zero at $-1$ only for "
        "$\\alpha+2\\beta=0$",
    )
    page.say(
        "The loop is limit stable where the other zeros lie inside and $-1$ is a simple one. "
        "Without delay the other factor is of second order:"
    )
    page.lemma(
        "For $d=0$ the other zeros lie inside just for a triangle of walls",
        triangle(),
        boxed=True,
    )
    once = {alpha: S.One, beta: S.Zero, delta: S.One, l: S.One, q: S.One}
    symbols, given, _ = taken_apart(kept_at_minus_one())
    held = held_by_a_pole(pole, number(Relation(S.One, "<=", S.One)))
    kept = for_all(symbols, given, add_assum(conj(pole, held), *given))
    page.settle(
        "s5c-undamped-limit",
        conj(kept, split(), triangle()),
        note="the pole for every delay of $\\ell/q$ periods, the factor for whole delays, the "
        "region for $d=0$; for other delays no region is shown",
    )
    damped = page.lemma(
        "With damping a pole lies at $-e^{-\\delta/2}$, and no wall moves it",
        mirrored_pole(delta),
        because="for $\\gamma=\\pi^2+\\delta^2/4$, the Nyquist frequency of a damped device",
    )
    symbols, given, _ = taken_apart(CLAIMED["s5c-pole-inside"](()))
    page.settle(
        "s5c-pole-inside",
        for_all(symbols, given, add_assum(conj(damped, *inside()), *given)),
        example=example(once, given, fact(whole(S.One))),
        note=r"at the Nyquist frequency it is $-e^{-\delta/2}$, whatever wall and delay",
    )
