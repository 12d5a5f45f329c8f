r"""Is any wall stable with every spring if the device has no damping?

A wall is robustly stable if it is stable with every spring up to the Nyquist frequency. The paper
observes that the region of these walls shrinks to the origin as $\delta\to0$. We show that it is
empty for $\delta=0$ and every delay, and that one spring excludes all walls with $\alpha\ge0$.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undamped_robust import chord, excluded, outpaced, pulled, vanishes
from symhaptic.model import loop


def derive(page):
    undamped, swing, apart = Parts(damping=False), {gamma: Omega**2}, 2 * I * Omega
    device = plant.sampled(plant.normalised(undamped), split=apart)
    page.say(
        r"Without damping the phase of the oscillating device grows by $\Omega=\sqrt\gamma$ per "
        r"period, and $n_1=n_0=(1-\cos\Omega)/\Omega^2$:"
    )
    page.step(
        "The device without damping has poles on the unit circle",
        device.denominator.subs(swing),
        z**2 - 2 * z * cos(Omega) + 1,
        name="A",
    )
    for which, name, number in (("first", n_1, device.n1), ("second", n_0, device.n0)):
        page.step(
            f"Without damping the {which} coefficient of the numerator contains one cosine",
            number.subs(swing),
            (1 - cos(Omega)) / Omega**2,
            name=name,
        )
    wall = (alpha + beta) * z - beta
    whole = z ** (d + 1) * (z**2 - 2 * z * cos(Omega) + 1) + n_0 * (z + 1) * wall
    page.same(
        "the polynomial",
        loop.characteristic(undamped, split=apart).subs(swing),
        whole.subs(n_0, (1 - cos(Omega)) / Omega**2),
    )
    page.say(
        "Each zero $a$ of a polynomial $p$ adds $z/(z-a)$ to $zp'/p$, and the real part of this "
        r"term exceeds $\tfrac12$ if $|a|<1=|z|$. So, if all $d+3$ zeros of $p_1$ lie inside the "
        r"circle, $2\Re(zp_1'\bar p_1)>(d+3)|p_1|^2$ holds on the circle. Consider the angle at "
        "which the denominator of the plant vanishes:"
    )
    value, speed = (on_circle(e, Omega) for e in (whole, z * diff(whole, z)))
    back, slowed = (e.xreplace({I: -I}) for e in (value, speed))
    along, across = alpha * (1 + cos(Omega)), (alpha + 2 * beta) * sin(Omega)
    total, late = alpha + beta, d + 1
    square = late * (total**2 + beta**2 - 2 * cos(Omega) * total * beta) - total**2 + beta**2
    page.step(
        r"At the angle $\theta=\Omega$ of the device two terms remain",
        speed * back + slowed * value - (d + 3) * value * back,
        -4 * n_0 * sin(Omega) * (along * sin(late * Omega) - across * cos(late * Omega))
        - 2 * n_0**2 * (1 + cos(Omega)) * square,
        name=r"2\Re(zp_1'\bar p_1)-(d+3)|p_1|^2",
        because="for a stable wall, this difference is positive",
    )
    page.say(
        r"Take the spring with $(d+1)\Omega=\tfrac\pi2$. The first term is then "
        r"$-4n_0\alpha\sin\Omega\,(1+\cos\Omega)$, and the second term is negative:"
    )
    page.step(
        "The second term is a sum of squares",
        (late + 1) * square,
        ((late + 1) * beta - late * cos(Omega) * total) ** 2
        + (late**2 * sin(Omega) ** 2 - 1) * total**2,
        name=r"(d+2)(\ldots)",
    )
    page.lemma(
        "A sine lies above its chord: $(d+1)\\sin\\Omega\\ge1$",
        chord(),
        because="the delay is $d=p/(q+1)$; the lemma is the inequality for sines with $M=q+1$, "
        r"$N=p+q+1$ and $\Omega=M\psi$",
    )
    page.lemma(
        r"With the polynomial in $w$, no wall with $\alpha\ge0$ is stable with this spring",
        outpaced(),
        because="neither term is positive; the delay is any rational number, and $z=w^{q+1}$ as in "
        "the paper",
    )
    page.lemma(
        r"No wall with $\alpha\ge0$ is stable with the spring $(d+1)\sqrt\gamma=\frac\pi2$",
        excluded(),
    )
    page.lemma(
        r"A wall with $\alpha<0$ is not stable with a spring $\gamma<-\alpha$",
        pulled(),
        because="the polynomial is not positive at 1",
    )
    page.say(
        r"So no wall is robustly stable. With the spring $(d+1)\sqrt\gamma=\frac\pi2$ every wall "
        r"with $\alpha\ge0$ except the origin has a zero outside the circle. If all roots were "
        r"inside or on the circle, the inequality would hold with $\ge$, but the sum of the two "
        "terms is negative. At the origin the device oscillates without a wall and is only "
        "limit stable."
    )
    symbols, given, then = taken_apart(page.claim("s5c-robust-vanishes"))
    page.settle(
        "s5c-robust-vanishes",
        for_all(symbols, given, vanishes(then.of[0])),
        example={alpha: S.Zero, beta: S.Zero, d: S.Zero},
        note="the statement holds for every delay; one spring excludes all walls with "
        r"$\alpha\ge0$",
    )
