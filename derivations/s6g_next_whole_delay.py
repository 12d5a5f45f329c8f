r"""Is a wall passive at a fractional delay if it is at the next whole one?

The paper's formulas are exact for whole delays. If a fractional delay is never worse than the next
whole one, rounding the delay up keeps what they say of whole delays. It is so for every wall.
"""

from symhaptic.book.lemmas.late_passivity import GIVEN
from symhaptic.book.lemmas.next_whole import (
    NEXT_WALL,
    NOTHING,
    before,
    beyond,
    low,
    nothing_is_passive,
    rounded_up,
    safe_when_rounded_up,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import fractional, passivity
from symhaptic.notation import b, chi, kappa, r, u, w


def derive(page):
    page.say(
        "As before let $\\psi=\\theta/2$, $u=KT/(2b)$ and $w=(B+KT/2)/b$, and $N=2(\\ell+2)$ for "
        "the next whole delay $\\ell+1$. At one angle write $w=r\\sin\\kappa$ and "
        "$u\\cot\\psi=r\\cos\\kappa$; for $K>0$ that is $|\\kappa|<\\frac\\pi2$."
    )
    polar = {K: 2 * b * u / T, B: b * (w - u), theta: 2 * psi}
    turned = {u: r * cos(kappa) * tan(psi), w: r * sin(kappa)}
    need = passivity.dirichlet_form().subs(polar).subs(turned).subs(d, N / 2 - 1) / b
    page.step(
        "The next whole delay needs one sine",
        need,
        r * sin(N * psi - kappa),
        name=r"\text{need}\big|_{d=\ell+1}/b",
        because="we write $\\chi=N\\psi-\\kappa$; for $\\ell$ it is $r\\sin(\\chi-2\\psi)$",
    )
    share = (fractional.margin() / b**2).subs(polar).subs(turned)
    page.step(
        "The exact condition is between two sines, and a term more",
        share.subs(l, N / 2 - 2).subs(kappa, N * psi - chi),
        1
        - r * ((1 - epsilon) * sin(chi - 2 * psi) + epsilon * sin(chi))
        - epsilon * (1 - epsilon) * r**2 * sin(psi) ** 2,
        name="f",
        because="is $f\\ge0$",
    )
    page.say(
        "Let the next whole delay be passive: $r\\sin\\chi\\le1$ at all angles. Where "
        "$\\chi\\ge\\frac\\pi2$, look at the smaller angle $\\psi'$ with "
        "$N\\psi'=\\frac\\pi2+\\kappa$. What is needed there, "
        "$\\cos\\kappa\\,u\\cot\\psi'+w\\sin\\kappa$, is not less than the same with "
        "$\\cot\\psi$, and that is $r$: so $r\\le1$."
    )
    page.lemma(
        "Where $\\chi\\ge\\frac\\pi2$ the margin is a sum of squares",
        beyond(room(r)),
        because="$r\\le1$",
    )
    page.lemma(
        "Where $\\frac12\\psi\\le\\chi<\\frac\\pi2$ the margin is a sum of what is not negative",
        before(room(r * sin(N * psi - kappa))),
        because="$r\\sin\\chi\\le1$",
    )
    page.lemma(
        "Where $\\chi<\\frac12\\psi$ the margin is one again",
        low(room(r * sin(kappa))),
        because="$\\kappa$ lies between $(N-\\frac12)\\psi$ and $\\frac\\pi2$, and at "
        "$N\\psi=\\pi$ the whole delay needs $w=r\\sin\\kappa$, so that this is at most 1",
    )
    found = page.lemma(
        "A delay that is rounded up to whole periods is on the safe side",
        safe_when_rounded_up(),
        because="without stiffness the passive damping of every delay begins at $-b$, and that of "
        "the next whole one ends at $b$",
        boxed=True,
    )
    page.state(
        "fractional-next-whole",
        "a wall that is passive for the whole delay $\\ell+1$ is passive for every delay between "
        "$\\ell$ and $\\ell+1$",
        claim=rounded_up(),
    )
    page.settle(
        "fractional-next-whole",
        found,
        example=example(NOTHING, [*GIVEN, NEXT_WALL], nothing_is_passive()),
        note="so (5) to (9) and (11) are safe with $d$ rounded up",
    )


def room(size):
    """0 <= 1 - size, from size <= 1."""
    return positive(1 - size >= 0, size <= 1)
