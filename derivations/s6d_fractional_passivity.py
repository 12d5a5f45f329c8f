r"""When is a wall with a fractional delay passive?

With a delay of $\ell+\varepsilon$ periods the force changes inside a period, so that the motion
within the period matters. Which inequality ensures that no motion extracts energy, and what is its
limit for integer delays?
"""

from symhaptic.book.lemmas.late_passivity import condition_at_every_angle, passive_at_every_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import wall
from symhaptic.notation import function, q_k

N, NEED = symbols("n"), function("b_0")
KERNEL = K * T / (2 * sin(theta / 2))


def derive(page):
    rest = 1 - epsilon
    page.say(
        "Consider the device while one force is held. Its displacement in this time is $p_k$. "
        r"After $(1-\varepsilon)T$ the wall takes its next sample; let the position then differ "
        r"by $q_k$ from the value $(1-\varepsilon)p_k$ of a motion at constant speed. In both "
        r"parts, of the durations $(1-\varepsilon)T$ and $\varepsilon T$, the dissipation is "
        "smallest at constant speed:"
    )
    page.step(
        "A damper dissipates at least this energy, times $T/b$",
        (rest * p_k + q_k) ** 2 / rest + (epsilon * p_k - q_k) ** 2 / epsilon,
        p_k**2 + q_k**2 / (epsilon * rest),
    )
    page.say(
        "The position at the beginning is $p/(z-1)$, so the sample is "
        "$(1/(z-1)+1-\\varepsilon)p+q$, and the force that belongs to it comes $\\ell+1$ periods "
        "later. Per period and at one angle the energy that damper and wall absorb is "
        "$\\tfrac bT(|p|^2+|q|^2/(\\varepsilon(1-\\varepsilon)))"
        "+\\Re\\{G\\,(\\ldots p+q)\\,\\bar p\\}$ with $G=z^{-\\ell-1}H$."
    )
    page.step(
        "The sample is taken between two integer delays",
        1 / (z - 1) + rest,
        rest * z / (z - 1) + epsilon / (z - 1),
        because=r"the delays are $\ell$ and $\ell+1$ periods, with the weights $1-\varepsilon$ "
        r"and $\varepsilon$",
    )
    form = fractional.energy_form()
    straight = page.step(
        "The required damping of a motion with $q=0$",
        b - T * form[0, 0],
        KERNEL * (rest * sin((l + HALF) * theta) + epsilon * sin((l + 3 * HALF) * theta))
        - B * (rest * cos((l + 1) * theta) + epsilon * cos((l + 2) * theta)),
        name=N,
        because="the negative of the energy that the wall receives from such a motion, times $T$",
    )
    page.step(
        "The required damping at an angle for an integer delay $d$",
        b - passivity.margin(),
        passivity.dirichlet_form(),
        name=NEED(d),
    )
    page.step(
        "The required damping is a mean of those of two integer delays",
        straight,
        rest * NEED(l) + epsilon * NEED(l + 1),
        name=N,
    )
    force = passivity.on_circle(wall.transfer() * z ** (-l - 1))
    square = page.step(
        "The size of the wall does not contain the delay",
        T**2 * force * force.xreplace({I: -I}),
        fractional.stiffness_squared(),
        name="T^2|H|^2",
        because="on the unit circle the delay changes only the phase",
    )
    det = form[0, 0] * form[1, 1] - form[0, 1] * form[1, 0]
    margin = b * (b - straight) - epsilon * rest * square / 4
    page.step(
        "The form in $p$ and $q$ is positive with its determinant",
        det * T**2 * epsilon * rest,
        b * (b - N) - epsilon * rest * square / 4,
        name=r"\varepsilon(1-\varepsilon)T^2\det",
        because=r"as its corner $b/(T\varepsilon(1-\varepsilon))$ is positive; the second term is "
        r"the "
        "maximal gain by a deviation $q$",
        boxed=True,
    )
    root = (u + sqrt(u**2 + w)) / 2
    page.step(
        "Solved for the damping there is one positive solution",
        root * (root - u) - w / 4,
        S.Zero,
        name=r"\det\big|_{b=\frac12(n+\sqrt{n^2+\varepsilon(1-\varepsilon)T^2|H|^2})}",
        because="the other solution is not positive, since the product of both is not",
    )
    page.same("as in the model", margin, fractional.margin())
    page.say(
        r"Which angles matter? With $\psi=\theta/2$ write $r^2=w^2+u^2\cot^2\psi$ for the wall "
        r"$u=KT/(2b)$, $w=(B+KT/2)/b$, and $\varrho^2=1-4\varepsilon(1-\varepsilon)\sin^2\psi$ "
        r"for the delay. Both fall with $\theta$ if $K\ge0$. The size of the wall is "
        r"$T|H|=2br\sin\psi$, and $n=br\varrho\cos\varphi$ with some phase $\varphi$; below, $x$ "
        r"stands for $\varrho$."
    )
    page.step(
        "In $u$ and $w$ the size of the wall falls with the angle",
        square.subs({K: 2 * b * u / T, B: b * (w - u)}) / (2 * b * sin(theta / 2)) ** 2,
        w**2 + u**2 * cot(theta / 2) ** 2,
        name=r"\Bigl(\frac{T|H|}{2b\sin\psi}\Bigr)^2",
    )
    need_ = r * (1 + x) / 2
    page.step(
        "The damping $\\tfrac12(1+x)\\,br$ is enough at every angle",
        need_**2 - need_ * r * x * cos(phi) - (1 - x**2) * r**2 / 4,
        r**2 * x * (1 + x) * (1 - cos(phi)) / 2,
        name=r"\frac{1}{b^2}\Bigl(b(b-n)-\ldots\Bigr)",
        because=r"the difference is never negative, and zero for $\varphi=0$. Angles beyond "
        r"the first one with $\varphi=0$ therefore require no more damping",
    )
    for title, end, delay in (
        ("Without a fraction it is the condition of the delay $\\ell$", 0, l),
        ("At a full period it is the condition of the delay $\\ell+1$", 1, l + 1),
    ):
        page.step(
            title,
            fractional.margin().subs(epsilon, end),
            b * (b - NEED(delay)),
            name=rf"b(b-n)\big|_{{\varepsilon={end}}}",
        )
    page.say(
        "As for integer delays it is sufficient to consider motions that return to their start "
        r"if $K\ge0$: the energy of the spring can be recovered by a slow return, with "
        "arbitrarily little dissipation. At equality no energy is gained either."
    )
    found = page.lemma(
        "No motion extracts energy if and only if this holds at every angle",
        passive_at_every_angle(),
        because="the sum over all motions is not negative where the form is not, at every angle",
    )
    page.state(
        "fractional-passivity",
        "for a delay of $(\\ell+\\varepsilon)T$ and $K\\ge0$ no motion can extract energy if and "
        "only if for all $0<\\theta<\\pi$",
        r"b^2 + bB ((1-\varepsilon) \cos((\ell+1)\theta) "
        r"+ \varepsilon \cos((\ell+2)\theta)) "
        r"\br - \frac{bKT}{2 \sin(\theta/2)} ((1-\varepsilon) \sin((\ell+\tfrac{1}{2})\theta) "
        r"+ \varepsilon \sin((\ell+\tfrac{3}{2})\theta)) "
        r"\br \geq \frac{\varepsilon(1-\varepsilon)}{4} (K^2T^2 + 4B(KT+B) \sin^2(\theta/2))",
        claim=condition_at_every_angle(),
        condition=True,
    )
    point = {K: S.Zero, B: S.Zero, b: S.One, T: S.One, l: S.Zero, epsilon: HALF}
    page.settle("fractional-passivity", margin >= 0, found, example=point)
