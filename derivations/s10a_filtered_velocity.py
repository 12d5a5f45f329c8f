r"""Which walls are passive if the velocity is filtered?

Most controllers filter the difference of two samples by an exponential average,
$v_k=f_v\,v_{k-1}+(1-f_v)(x_k-x_{k-1})/T$ with a pole $0\le f_v<1$. How much damping must the device
have, and does a passive wall stay passive with the filter?
"""

from sympy import Eq, I, Rational, S, cos, exp, pi

from symhaptic.book.lemmas.decided import in_z
from symhaptic.book.lemmas.filtered_wall import (
    FAST,
    MARGIN,
    SLOW,
    by_angle,
    decides,
    gives_energy,
    without_filter,
)
from symhaptic.loops.velocity import DIFFERENCE, exponential_average
from symhaptic.notation import B, K, T, b, d, f_v, theta, z

FILTERED, PLAIN = "rules:average-damping", "rules:plain-damping"


def derive(page):
    wall = page.define(
        "The damper takes the average of the differences",
        r"H(z)",
        K + B / T * in_z(DIFFERENCE.times(exponential_average(f_v))),
    )
    page.step(
        "The filter moves the pole of the wall from 0 to $f_v$",
        wall,
        K + B * (1 - f_v) * (z - 1) / (T * (z - f_v)),
        name="H(z)",
        because="the transfer function of the average is $(1-f_v)z/(z-f_v)$",
    )
    turn = exp(I * theta)
    lag = (wall / (z - 1)).subs(z, turn)
    page.step(
        "A filtered wall requires this damping of the device at each angle",
        -T * (lag + lag.subs(I, -I)) / 2,
        b - MARGIN.right,
        name=r"b_{\min}(\theta)",
        because=r"by the balance of energy the required damping is $-T\,\Re\{H/(z-1)\}$ at "
        r"$z=e^{j\theta}$",
    )
    page.lemma(
        "A filtered wall is passive if and only if its stiffness is not negative and the device "
        "dissipates enough at each angle",
        by_angle(),
        because="the impulse response of the filter decays, so the energy of a motion is an "
        "integral over its spectrum, as for a wall without a filter",
    )
    slow, fast = b - SLOW.left, b - FAST.left
    weight = (1 - f_v) ** 2 * (1 + cos(theta)) / (2 * (1 - 2 * f_v * cos(theta) + f_v**2))
    page.step(
        "The margin is a weighted mean of its values at frequency zero and at the Nyquist "
        "frequency",
        MARGIN.right,
        weight * slow + (1 - weight) * fast,
        because="the weights are not negative and their sum is 1",
    )
    found = page.lemma(
        r"A filtered wall with $K\ge0$ is passive if and only if it meets the bounds at "
        "frequency zero and at the Nyquist frequency",
        decides(),
        because="a mean of two nonnegative numbers is nonnegative, and the margin comes "
        "arbitrarily close to each of the two values",
        boxed=True,
    )
    easy = {K: S.One, B: S.One, b: S.One, T: S.One, f_v: S.Half}
    page.settle(
        FILTERED,
        found,
        example=easy,
        note="the bounds are exact for this loop without delay, including walls on the bounds. The "
        "first bound is stricter for $B>0$ and the second for $B<0$; no filter relaxes the second "
        "bound. With a delay, condition (4) decides",
    )
    page.say(
        "The filter removes the virtual damper at high frequencies, where sampling makes it "
        "active. With $f_v=0.9$ only a nineteenth of $B$ remains in the first bound. This "
        "result concerns passivity. The same filter reduces the stable stiffness of a light "
        r"device; see \chapter{s10f_filtered_mass}."
    )
    found = page.lemma("A wall that meets (6) is passive with every filter", without_filter())
    late = {K: S.One, B: S.One / 8, b: Rational(3, 4), T: S.One, f_v: S.Half, d: S.One}
    page.settle(
        PLAIN,
        found,
        example=late | {d: S.Zero},
        unless={Eq(d, 0): (late, gives_energy(late, pi / 3))},
        shows=r"with a delay of one period and $T=1$, the wall $K=1$, $B=\tfrac18$ with "
        r"$b=\tfrac34$ delivers energy in slow motions",
        note="the rule is safe with every filter and exact without a filter; it does not allow for "
        "a delay",
    )
