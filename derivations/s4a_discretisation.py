r"""What does the device do between two samples?

A force that is held for a period drives a mass with a damper and a spring. We solve the motion over
one period exactly. Its samples give a transfer function in $z$ that agrees with the continuous
motion at every sampling instant.
"""

from sympy import Matrix, zeros

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.sampled import device_claim, late_answer
from symhaptic.book.lemmas.sampled_points import FREE, SWINGING, fails, shown_at
from symhaptic.model.plant import sampled
from symhaptic.notation import T_s, function

CORRECTED = (
    r"\frac{((c_2 + c_3 - 2)z + (c_2 + c_3 - 2e^{-bT/m}))(b^2 - 4km) \br "
    r"+ b\changed{\tfrac{m}{T}}c_1(c_3 - c_2)(z - 1)}"
    r"{2k(z^2 - (c_2 + c_3)z + e^{-bT/m})(4km - b^2)}"
)

WHOLE = r"\frac{1}{ms^2 + bs + k} \hat{=} \br " + CORRECTED
DELAYS = r"e^{-dT_s} \hat{=} z^{-d}", r"e^{-d\changed{Ts}} \hat{=} z^{-d}"
"""The equivalent of the delay as published, and as corrected."""


def derive(page):
    plant = Plant()
    page.say(
        r"Newton's law $m\ddot x+b\dot x+kx=F$ has the state matrix $A$ and the poles $s_1$ and "
        r"$s_2$. Putzer's formula gives $e^{At}=e^{s_1t}+(A-s_1)\,(e^{s_1t}-e^{s_2t})/(s_1-s_2)$. "
        "We verify this formula:"
    )
    law = plant.state_matrix
    phi, held = plant.transition(t), plant.held(t)
    page.step(
        "Putzer's formula solves the equation of motion",
        (diff(phi, t) - law * phi)[1, 1],
        S.Zero,
        name=r"\bigl(\tfrac{d}{dt}e^{At}-Ae^{At}\bigr)_{22}",
    )
    page.same("all four entries", Matrix(diff(phi, t) - law * phi), zeros(2))
    page.same("from rest at t = 0", phi.subs(t, 0), eye(2))
    page.same("the held force", diff(held, t) - law * held, plant.input_matrix)
    page.same("from rest", held.subs(t, 0), zeros(2, 1))
    page.say(
        "In the same way the other three entries, the initial values, and the response to a held "
        "unit force are checked against the differential equation."
    )

    # in units of m and T the poles are (-bT/m +- c_1)/2
    rate, spring = b * T / m, k * T**2 / m
    unit = Plant(1, rate, spring)
    one, two = unit.poles(c_1)
    page.step(
        "The poles differ by $c_1/T$",
        unit.split,
        sqrt((b * T / m) ** 2 - 4 * k * T**2 / m),
        name=c_1,
        paper="13",
    )
    page.say("Sampling maps the poles $s_1$ and $s_2$ to $e^{s_1T}=c_3$ and $e^{s_2T}=c_2$:")
    page.step(
        "The faster pole gives $c_2$", exp(two), exp(-(b * T / m + c_1) / 2), name=c_2, paper="13"
    )
    page.step(
        "The slower pole gives $c_3$", exp(one), exp(-(b * T / m - c_1) / 2), name=c_3, paper="13"
    )
    page.settle("eq13", Eq(c_1, unit.split), Eq(c_2, exp(two)), Eq(c_3, exp(one)), definition=True)

    page.say(
        r"The samples obey $x_{k+1}=\Phi x_k+\Gamma F_k$ with $\Phi=e^{AT}$, so the transfer "
        r"function is $(1,0)(z-\Phi)^{-1}\Gamma$. In terms of $c_1$, $c_2$ and $c_3$ it is:"
    )
    device = sampled(unit, split=c_1)
    exact = T**2 / m * device.transfer
    (form,) = read(CORRECTED)
    page.step(
        "The discrete equivalent is (12) with an additional factor $m/T$",
        exact,
        form,
        name=function("P")(z),
        paper="12",
    )
    page.say(
        "The last term of the numerator needs the factor $m/T$, which is missing in (12). Without "
        "this factor (12) adds a damping to a squared damping, and the result depends on the "
        "units. The formula is $0/0$ for $k=0$ and at critical damping, although the motion itself "
        "is regular."
    )
    swing = FREE | {m: S(2), b: S(4), k: Rational(3, 2)}
    claim = page.claim("eq12")
    corrected = CLAIMED["eq12"](read(WHOLE))
    apart = [Ne(c_1, 0), Ne(k, 0)]
    page.settle(
        "eq12",
        device_claim(corrected, apart),
        Eq(1 / (m * s**2 + b * s + k), exact),
        corrected=(WHOLE,),
        example=shown_at(corrected, SWINGING, *apart),
        unless=[fails(claim, swing)],
        shows=r"at $T=1$, $m=2$, $b=4$, $k=\tfrac32$ ($c_1=1$), $z=2$ the published form gives "
        "0.1882, but the device has 0.1366",
        note="the corrected formula is $0/0$ for $k=0$ and for $b^2=4km$",
    )
    _delay(page)


def _delay(page):
    page.say("A delay of $d$ periods is the factor $e^{-dTs}$. We write $z=e^{Ts}$:")
    page.define("A shift by one period is a factor $z$", z, exp(T * s))
    page.step(
        "On the unit circle the delay changes only the phase",
        on_circle(z ** (-d), omega * T),
        exp(-I * d * omega * T),
        name=r"z^{-d}\big|_{s=j\omega}",
    )
    page.lemma(
        "A force that is delayed by an integer number of periods is $z^{-d}$ times the force",
        late_answer(),
        because="the response of every device is shifted by $d$ samples, with any spring and any "
        "damper",
    )
    claim, corrected = (CLAIMED["s4a-delay-equivalent"](read(p)) for p in DELAYS)
    free = FREE | {d: S.One, T_s: S(2)}
    page.settle(
        "s4a-delay-equivalent",
        as_claimed(corrected, late_answer(), whole(d)),
        Eq(exp(-d * T * s), exp(T * s) ** (-d), evaluate=False),
        corrected=(DELAYS[1],),
        example=shown_at(corrected, free, whole(d)),
        unless=[fails(claim, free)],
        shows="at $d=T=1$, $T_s=2$ the response of a free mass would be multiplied by $e^{-2}$ and "
        r"not by $\tfrac12$",
        note="the text conversion may have replaced $Ts$ by $T_s$; the equivalence is exact at the "
        "samples for integer delays",
    )
