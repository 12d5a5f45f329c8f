"""What does a first-order lag predict for the stability of a wall?

The paper derives its linear condition in continuous time: hold and delay become one first-order
lag, and the Routh-Hurwitz criterion decides. We repeat this derivation and state every term that
the paper drops.
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
        because="the polynomial is the product of the denominators of the device and of the "
        "lag, plus the wall",
    )
    page.lemma(
        "Two inequalities decide the stability of the loop with the lag",
        stable_with_lag(),
        because="a cubic has three Hurwitz minors: the first, $a_2=m+bt_e$, is positive, the "
        "second is $a_2a_1-a_3a_0$, and the third is $a_0=k+K$ times the second",
        boxed=True,
    )
    whole = page.step(
        "Hurwitz' determinant of this loop is the margin of (24) plus one term",
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
        because="the limit consists of the terms of (24)",
    )
    linear = page.step(
        "By (24), the stiffness is less than the damping divided by the delay",
        K + kept / t_e,
        (b + B) / t_e,
        name=r"K_{\text{lin}}",
        paper="24",
    )
    page.say(
        r"So (24) drops the term $\frac{bt_e}m(b+B+kt_e)$. At equality in (24), the ratio of "
        r"this term to the other terms is $\frac{bt_e}m(1+\frac kK)$. For a given device the "
        "ratio is of order $T$ and depends on the stiffness $k$; it is zero only for $b=0$."
    )
    settle(page, linear.subs(t_e, lag.DELAY) > K)


def settle(page, derived):
    """Without damping, (24) and K > -k are Hurwitz' conditions for the loop with the lag."""
    same = taken_apart(page.claim("eq24"))[2]
    easy = {m: S.One, T: S.One, t_d: HALF, b: S.Zero, k: S.Zero, B: S.One, K: HALF}
    damped = {m: S.One, T: S.One, t_d: HALF, b: S.One, k: S.Zero, B: S.Zero, K: 3 * HALF}
    page.settle(
        "eq24",
        of_the_walls(same.of[0]),
        derived,
        example=easy,
        unless={Eq(b, 0): (damped, forbidden(same, damped))},
        shows=r"for $m=b=T=1$, $t_d=\tfrac12$ and $k=B=0$, Routh's condition allows $K<2$, and "
        "(24) only $K<1$",
        note="condition (24) is Routh's condition for the lag without the term "
        r"$\frac{bt_e}m(b+B+kt_e)$. For the sampled loop, (24) is neither necessary nor "
        "sufficient",
    )


def neglected(page):
    """Compare hold, delay and difference with lag and derivative."""
    page.say(
        "Hold and delay have the transfer function $H_0=e^{-t_ds}(1-e^{-Ts})/(Ts)$, the backward "
        "difference is $D=(1-e^{-Ts})/T$, and the sampler adds aliases around multiples of "
        r"$2\pi/T$. The paper replaces $H_0$ by a lag $1/(1+t_es)$ with the effective delay "
        r"$t_e=t_d+\tfrac T2$, replaces $D$ by $s$, and neglects the aliases. Both replacements "
        "are right to first order in $s$, and their errors are of second order:"
    )
    page.limit(
        "The error of the lag is of second order",
        (lag.held() - 1 / (1 + lag.DELAY * s)) / s**2,
        s,
        S.Zero,
        T**2 / 24 - lag.DELAY**2 / 2,
        name=r"\frac1{s^2}\Bigl(H_0-\frac1{1+t_es}\Bigr)",
    )
    page.limit(
        "The error of the derivative is of second order",
        ((1 - exp(-s * T)) / T - s) / s**2,
        s,
        S.Zero,
        -T / 2,
        name=r"\frac1{s^2}(D-s)",
        because="multiplied by $K$ and $B$, the two errors act like masses. At equality in "
        "(24), $K$ is of order $1/T$, and these masses are of order $T$",
    )
