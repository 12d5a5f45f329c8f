r"""When is a wall with a fractional delay passive?

With a delay of $\ell+\varepsilon$ periods the force changes inside a period, so the motion
within the period matters. We ask which inequality ensures that no motion extracts energy, and what
this inequality becomes for integer delays.
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
        r"After $(1-\varepsilon)T$ the wall takes its next sample; let the displacement at this "
        r"sample differ by $q_k$ from the value $(1-\varepsilon)p_k$ of a motion at constant "
        r"speed. The sample divides the period into two parts, of the durations $(1-\varepsilon)T$ "
        r"and $\varepsilon T$. In each part the dissipation is smallest at constant speed:"
    )
    page.step(
        "A damper dissipates at least this energy, times $T/b$",
        (rest * p_k + q_k) ** 2 / rest + (epsilon * p_k - q_k) ** 2 / epsilon,
        p_k**2 + q_k**2 / (epsilon * rest),
    )
    page.say(
        "The position at the beginning of a period is $p/(z-1)$, so the sample is "
        r"$(1/(z-1)+1-\varepsilon)p+q$. The force that belongs to this sample acts $\ell+1$ "
        r"periods later. At one angle damper and wall absorb in each period the energy $\tfrac "
        r"bT(|p|^2+|q|^2/(\varepsilon(1-\varepsilon)))+\Re\{G\,(\ldots p+q)\,\bar p\}$ with "
        r"$G=z^{-\ell-1}H$."
    )
    page.step(
        "The sample is a mean of the samples of two integer delays",
        1 / (z - 1) + rest,
        rest * z / (z - 1) + epsilon / (z - 1),
        because=r"the delays are $\ell$ and $\ell+1$ periods, with the weights $1-\varepsilon$ "
        r"and $\varepsilon$",
    )
    form = fractional.energy_form()
    straight = page.step(
        "A motion with $q=0$ requires this damping",
        b - T * form[0, 0],
        KERNEL * (rest * sin((l + HALF) * theta) + epsilon * sin((l + 3 * HALF) * theta))
        - B * (rest * cos((l + 1) * theta) + epsilon * cos((l + 2) * theta)),
        name=N,
        because="the required damping is $-T$ times the energy that the wall receives from such a "
        "motion",
    )
    page.step(
        r"For an integer delay $d$ a sinusoidal motion at the angle $\theta$ requires this damping",
        b - passivity.margin(),
        passivity.dirichlet_form(),
        name=NEED(d),
    )
    page.step(
        "For $q=0$ the required damping is a mean of those of two integer delays",
        straight,
        rest * NEED(l) + epsilon * NEED(l + 1),
        name=N,
    )
    force = passivity.on_circle(wall.transfer() * z ** (-l - 1))
    square = page.step(
        "The magnitude of the wall does not depend on the delay",
        T**2 * force * force.xreplace({I: -I}),
        fractional.stiffness_squared(),
        name="T^2|H|^2",
        because="on the unit circle the delay changes only the phase",
    )
    det = form[0, 0] * form[1, 1] - form[0, 1] * form[1, 0]
    margin = b * (b - straight) - epsilon * rest * square / 4
    page.step(
        "The form in $p$ and $q$ is positive if its determinant is positive",
        det * T**2 * epsilon * rest,
        b * (b - N) - epsilon * rest * square / 4,
        name=r"\varepsilon(1-\varepsilon)T^2\det",
        because=r"the coefficient of $|q|^2$ in the form, $b/(T\varepsilon(1-\varepsilon))$, is "
        "positive; the second term is the maximal gain by a deviation $q$",
        boxed=True,
    )
    root = (u + sqrt(u**2 + w)) / 2
    page.step(
        "Exactly one positive damping makes the determinant zero",
        root * (root - u) - w / 4,
        S.Zero,
        name=r"\det\big|_{b=\frac12(n+\sqrt{n^2+\varepsilon(1-\varepsilon)T^2|H|^2})}",
        because="the other solution is not positive, since the product of the two solutions is "
        "not positive",
    )
    page.same("as in the model", margin, fractional.margin())
    page.say(
        r"We ask which angles decide. Let $\psi=\theta/2$. For the wall let $u=KT/(2b)$, "
        r"$w=(B+KT/2)/b$ and $r^2=w^2+u^2\cot^2\psi$. For the delay let "
        r"$\varrho^2=1-4\varepsilon(1-\varepsilon)\sin^2\psi$. If $K\ge0$, $r$ and $\varrho$ "
        r"fall with $\theta$. The size of the wall is $T|H|=2br\sin\psi$, and "
        r"$n=br\varrho\cos\varphi$ with some phase $\varphi$. In the next steps, $x$ stands for "
        r"$\varrho$."
    )
    page.step(
        "In $u$ and $w$ the size of the wall falls with the angle",
        square.subs({K: 2 * b * u / T, B: b * (w - u)}) / (2 * b * sin(theta / 2)) ** 2,
        w**2 + u**2 * cot(theta / 2) ** 2,
        name=r"\Bigl(\frac{T|H|}{2b\sin\psi}\Bigr)^2",
    )
    need_ = r * (1 + x) / 2
    page.step(
        r"The damping $\tfrac12(1+x)\,br$ is sufficient at every angle",
        need_**2 - need_ * r * x * cos(phi) - (1 - x**2) * r**2 / 4,
        r**2 * x * (1 + x) * (1 - cos(phi)) / 2,
        name=r"\frac{1}{b^2}\Bigl(b(b-n)-\ldots\Bigr)",
        because=r"the difference is never negative, and is zero for $\varphi=0$. Therefore angles "
        r"beyond the first one with $\varphi=0$ require no more damping",
    )
    for title, end, delay in (
        (r"For $\varepsilon=0$ the condition is that of the delay $\ell$", 0, l),
        (r"For $\varepsilon=1$ the condition is that of the delay $\ell+1$", 1, l + 1),
    ):
        page.step(
            title,
            fractional.margin().subs(epsilon, end),
            b * (b - NEED(delay)),
            name=rf"b(b-n)\big|_{{\varepsilon={end}}}",
        )
    page.say(
        r"As for integer delays, it is sufficient for $K\ge0$ to consider motions that return to "
        "their start. A slow return recovers the energy of the spring with arbitrarily little "
        "dissipation. In the case of equality, no motion gains energy either."
    )
    found = page.lemma(
        "No motion extracts energy if and only if the determinant is not negative at any angle",
        passive_at_every_angle(),
        because="the absorbed energy of a motion is a sum of the form over all angles, so it is "
        "not negative if the form is not negative at any angle",
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
