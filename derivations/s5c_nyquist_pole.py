r"""What happens to the loop when the spring swings with the Nyquist frequency?

The device returns to its mirror image after each period, a little smaller if it is damped. We ask
what this leaves to the wall.
"""

from sympy import S, pi

from symhaptic.book.lemmas.mirror import inside, mirrored_pole
from symhaptic.model import loop
from symhaptic.model.parts import Parts
from symhaptic.notation import alpha, beta, d, delta, gamma, l, z
from symhaptic.notation.proposition import Relation, whole
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.comparison import q
from symhaptic.proof.theorems.familiar import held_by_a_pole
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import conjoined, weakened
from symhaptic.proof.theorems.leaves import number
from symhaptic.proof.theorems.tactics import example, fact, for_all


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
    once = {alpha: S.One, beta: S.Zero, delta: S.One, l: S.One, q: S.One}
    symbols, given, _ = taken_apart(CLAIMED["s5c-undamped-limit"](()))
    held = held_by_a_pole(pole, number(Relation(S.One, "<=", S.One)))
    page.settle(
        "s5c-undamped-limit",
        for_all(symbols, given, weakened(conjoined(pole, held), *given)),
        example=example({s: once[s] for s in symbols}, given, fact(whole(S.One))),
        note="no wall is asymptotically stable there; a second root at $-1$ or one outside makes "
        "it unstable",
    )
    damped = page.lemma(
        "With damping a pole lies at $-e^{-\\delta/2}$, and no wall moves it",
        mirrored_pole(delta),
        because="for $\\gamma=\\pi^2+\\delta^2/4$, the Nyquist frequency of a damped device",
    )
    symbols, given, _ = taken_apart(CLAIMED["s5c-pole-inside"](()))
    page.settle(
        "s5c-pole-inside",
        for_all(symbols, given, weakened(conjoined(damped, *inside()), *given)),
        example=example(once, given, fact(whole(S.One))),
        note=r"at the Nyquist frequency it is $-e^{-\delta/2}$, whatever wall and delay",
    )
