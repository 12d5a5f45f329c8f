r"""On which side does the linear condition err?

Routh's condition for the loop with a lag has one term more than the paper's (24). We ask for its
sign, in units and in the parameters of Table I, and what the arm's spring does in it.
"""

from sympy import Eq, Rational, S

from symhaptic.model import lag
from symhaptic.model.plant import Plant
from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, k, m, t_d, t_e
from symhaptic.proof import sign

HALF = Rational(1, 2)


def derive(page):
    whole, kept = lag.margin(Plant()), b + B - K * t_e
    within, pull = sign.assume(kept), sign.assume(K + k)
    mass, late, loss = sign.assume(m), sign.assume(t_e), sign.assume(b, strict=False)
    scale = sign.quotient(b * t_e / m, sign.combined(b * t_e, [loss, late]), mass)
    page.step(
        "The dropped term",
        whole - kept,
        b * t_e / m * ((b + B - K * t_e) + (K + k) * t_e),
        name=r"\tfrac1m(a_2a_1-a_3a_0)-(b+B-Kt_e)",
    )
    safe = page.positive(
        "Where (24) and $K>-k$ hold",
        sign.combined(whole, [within], [scale, within], [scale, pull, late]),
        r"b+B>Kt_e,\ K>-k",
        name=r"\tfrac1m(a_2a_1-a_3a_0)",
        because="for the lag (24) errs on the safe side, whatever $b$ and $k$ are. The other two "
        "conditions of Routh, $m+bt_e>0$ and $k+K>0$, hold too",
    )
    page.state("linear-lag", "every wall with (24) and $K>-k$ is stable in the loop with the lag")
    page.settle("linear-lag", safe, note="the sampled loop is another matter")
    stiffness(page, whole)
    plane(page, kept, whole)


def stiffness(page, whole):
    """The arm's spring in Routh's condition."""
    undamped = page.free_of("Routh without damping", whole.subs(b, 0), k)
    bound = page.step(
        "Routh's condition, solved for the stiffness",
        K + whole / t_e,
        (b + B) / t_e + b / m * (b + B + k * t_e),
        name=r"K_{\text{Routh}}",
        because="the spring is in it unless $b=0$, and raises it",
    )
    page.settle(
        "s4e-stiffness-free",
        undamped,
        provided=r"b=0,\ \text{for the lag}",
        unless={m: S.One, t_e: S.One, b: S.One, k: S.One, B: S.Zero},
        truth=Eq(bound, bound.subs(k, 0)),
        shows=r"$m=b=t_e=k=1$, $B=0$: Routh allows $K<3$, and $K<2$ without the spring",
        note="(24) has no $k$ as it drops the term with $k$; that the lower limit is $K>-k$ is "
        "exact for the lag ($a_0=k+K$) and necessary for the sampled loop (s4d-left-bound)",
    )


def plane(page, kept, whole):
    """(25), and Routh's condition beside it."""
    scaled = {K: alpha * m / T**2, B: beta * m / T, b: delta * m / T, k: gamma * m / T**2}
    scaled |= {t_d: d * T}
    small, large = ((f.subs(t_e, lag.DELAY) * T / m).subs(scaled) for f in (kept, whole))
    line = page.step(
        "(24) in the parameters of Table I, times $T/m$",
        small,
        beta + delta - alpha * (HALF + d),
        name=r"\tfrac Tm(b+B-Kt_e)",
        paper="25",
    )
    routh = page.step(
        "Routh's condition in them",
        large,
        line + delta * (d + HALF) * (beta + delta + gamma * (d + HALF)),
        name=r"\tfrac T{m^2}(a_2a_1-a_3a_0)",
        because="on the line $\\beta+\\delta=\\alpha(\\tfrac12+d)$ the last term is the share "
        "$\\delta(d+\\tfrac12)(1+\\gamma/\\alpha)$: 1\\,\\% for $\\delta=0.02$, $d=0$, and "
        "17\\,\\% for $d=8$, without a spring",
    )
    page.settle(
        "eq25",
        line > 0,
        provided=r"\delta=0,\ \text{for the lag}",
        unless={alpha: 3 * HALF, beta: S.Zero, gamma: S.Zero, delta: S.One, d: HALF},
        truth=routh > 0,
        shows=r"$\delta=1$, $d=\tfrac12$, $\beta=\gamma=0$: Routh allows $\alpha<2$, (25) only "
        r"$\alpha<1$",
        note="it is (24) by Table I, for $m,T>0$, and as good as (24)",
    )
