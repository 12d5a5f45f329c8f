r"""What does a first-order lag say about the stability of a wall?

The paper's linear condition comes from continuous time: hold and delay become one first-order lag,
and the Routh-Hurwitz criterion decides. We repeat that and name everything that is left out.
"""

from symhaptic.book.lemmas.linear import forbidden, of_the_walls, stable_with_lag
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import lag
from symhaptic.notation import t_e


def derive(page):
    neglected(page)
    a_3, a_2, a_1, a_0 = lag.characteristic(Plant())
    page.step(
        "The loop with the lag has the polynomial",
        Plant().characteristic * (1 + t_e * s) + lag.WALL,
        a_3 * s**3 + a_2 * s**2 + a_1 * s + a_0,
        because="device times lag, plus wall",
    )
    page.lemma(
        "In the loop with the lag two inequalities say which walls are stable",
        stable_with_lag(),
        because="of the three minors of a cubic, $a_2=m+bt_e$ is positive, and the third is "
        "$a_0=k+K$ times the second, $a_2a_1-a_3a_0$",
        boxed=True,
    )
    whole = page.step(
        "For this loop Hurwitz' determinant is (24) and a term more",
        lag.margin(Plant()),
        b + B - K * t_e + b * t_e / m * (b + B + k * t_e),
        name=r"\tfrac1m(a_2a_1-a_3a_0)",
    )
    h, heavy = symbols("h"), symbols("m_0")
    kept = page.limit(
        "For a heavy mass, $m=m_0/h$, the determinant tends to (24)",
        whole.subs(m, heavy / h),
        h,
        S.Zero,
        b + B - K * t_e,
        name=r"\tfrac1m(a_2a_1-a_3a_0)",
        because="this is what (24) keeps",
    )
    linear = page.step(
        "Solved for the stiffness (24) is damping over delay",
        K + kept / t_e,
        (b + B) / t_e,
        name=r"K_{\text{lin}}",
        paper="24",
    )
    page.say(
        "So (24) drops the term $\\frac{bt_e}m(b+B+kt_e)$. At the border of (24) it is the share "
        "$\\frac{bt_e}m(1+\\frac kK)$ of what is kept: of order $T$ for a given device, but not "
        "zero unless $b=0$, and with the spring in it."
    )
    settle(page, linear.subs(t_e, lag.DELAY) > K)


def settle(page, derived):
    """Without damping (24) and K > -k are Hurwitz' conditions of the lag."""
    same = taken_apart(page.claim("eq24"))[2]
    easy = {m: S.One, T: S.One, t_d: HALF, b: S.Zero, k: S.Zero, B: S.One, K: HALF}
    damped = {m: S.One, T: S.One, t_d: HALF, b: S.One, k: S.Zero, B: S.Zero, K: 3 * HALF}
    page.settle(
        "eq24",
        of_the_walls(same.of[0]),
        derived,
        example=easy,
        unless={Eq(b, 0): (damped, forbidden(same, damped))},
        shows=r"$m=b=T=1$, $t_d=\tfrac12$, $k=B=0$: Routh allows $K<2$, (24) only $K<1$",
        note="as Routh's condition for the lag, which else has $\\frac{bt_e}m(b+B+kt_e)$ more. "
        "For the sampled loop it is neither necessary nor sufficient",
    )


def neglected(page):
    """Hold, delay and difference against lag and derivative."""
    page.say(
        "Held for a period and late by $t_d$, a force is $H_0=e^{-t_ds}(1-e^{-Ts})/(Ts)$ times "
        "itself; the backward difference is $D=(1-e^{-Ts})/T$; and the sampler adds images "
        "around multiples of $2\\pi/T$. All this is replaced by a lag $1/(1+t_es)$ with the "
        "effective delay $t_e=t_d+\\tfrac T2$, by $s$, and by nothing. The first two agree "
        "to first order in $s$, and leave out"
    )
    page.limit(
        "The lag errs in the second order",
        (lag.held() - 1 / (1 + lag.DELAY * s)) / s**2,
        s,
        S.Zero,
        T**2 / 24 - lag.DELAY**2 / 2,
        name=r"\frac1{s^2}\Bigl(H_0-\frac1{1+t_es}\Bigr)",
    )
    page.limit(
        "The derivative errs in the second order by half a period",
        ((1 - exp(-s * T)) / T - s) / s**2,
        s,
        S.Zero,
        -T / 2,
        name=r"\frac1{s^2}(D-s)",
        because="times $K$ and $B$ both are masses: of order $T$ beside $m$, if $K$ is of order "
        "$1/T$ as on the border of (24)",
    )
