"""Do the damper and the spring of an arm hardly matter?

The paper concludes that neither the damper nor the spring matters much inside the range (23). We
compare the largest stable stiffness with and without the damper and the spring: numerically for
delays up to seven periods, and by one spring for long delays.
"""

from symhaptic.book.lemmas.marginal import AT_ONCE, LONG, by_a_factor, changes, none_pushes
from symhaptic.book.lemmas.near_tip import FINE, none_above, wall_below
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.undamped_robust import excluded
from symhaptic.paper.propositions.conclusion import CHANGES

PARTS = {
    gamma: ("spring", r"$\delta=0$", r"$\delta=0.02$"),
    delta: ("damper", r"$\gamma=0$", r"$\gamma=0.001$"),
}


def derive(page):
    page.say(
        "For each end of the range (23) a stable wall next to the tip and a bound of all stable "
        "walls enclose the largest stable stiffness. An example is an undamped arm with "
        r"$\gamma=0.001$ for $d=7$:"
    )
    arm = (Rational(1, 1000), S.Zero)
    wall, stable = wall_below(arm, 7, FINE)
    limit, softer = none_above(arm, 7, FINE)
    page.lemma(f"The wall with $\\alpha={float(wall[0]):.12f}$ is stable", stable)
    page.lemma(f"All stable walls have $\\alpha<{float(limit):.12f}$", softer)
    in_numbers(page, delta, "s6-damping-marginal")
    in_numbers(page, gamma, "s6-stiffness-marginal")
    page.lemma(
        r"Without a damper no wall with $\alpha\ge0$ is stable with the spring "
        r"$(d+1)\sqrt\gamma=\frac\pi2$",
        excluded(),
        because=r"\chapter{s5c_robust} proves this; for $d=49$ the spring is "
        r"$\gamma=(\frac\pi{100})^2<0.001$",
    )
    page.say(
        "So with long delays the damper and the spring are not marginal: for $d=49$ no wall "
        r"with $\alpha\ge0$ is stable with this spring and without a damper. No factor bounds "
        "the effect of the damper and of the spring."
    )
    damping(page)
    spring(page)


def in_numbers(page, parameter, id):
    """The changes between the ends of one range."""
    name, *ends = PARTS[parameter]
    rows = [[str(n), *row] for n, row in enumerate(zip(*CHANGES[parameter].values(), strict=True))]
    page.table(
        f"Change of the largest stable stiffness between the arm without and with the {name}, in "
        "per cent of the smaller one, with truncated decimals."
        if parameter == gamma
        else f"Growth of the largest stable stiffness by the {name}, in per cent, with truncated "
        "decimals.",
        ["$d$", *ends],
        rows,
    )
    ranges = r"$\gamma=0.001$" if parameter == gamma else r"$\delta=0.02$"
    page.settle(
        id,
        changes(parameter),
        enclosed=True,
        note=f"the changes are given for {ranges} and delays of 0 to 7 periods, at both ends of "
        "the range of the other parameter; whether they matter depends on the use. With long "
        rf"delays the change is not small (\texttt{{{id.replace('marginal', 'any-delay')}}})",
    )


def damping(page):
    """No factor bounds the effect of the damper."""
    id = "s6-damping-any-delay"
    then = taken_apart(page.claim(id))[2]
    theorem = by_a_factor(then, {delta: S.Zero}, {})
    point = {**LONG, delta: Rational(1, 50)}
    wall = {alpha: Rational(1, 2000), beta: S.Zero}
    denial = none_pushes(then.at(point), tuple(wall.values()), stable_at(wall | point))
    page.settle(
        id,
        theorem,
        example={gamma: S.Zero, delta: S.Zero, d: S.Zero},
        unless={AT_ONCE: (point, denial)},
        shows=r"at $d=49$, $\gamma=(\pi/100)^2$ no wall with $\alpha\ge0$ is stable without "
        r"damping, and $\alpha=0.0005$ is stable with $\delta=0.02$",
        note="this holds for integer delays; without delay the factor is less than 1.05 on all of "
        "(23)",
    )


def spring(page):
    """No factor bounds the effect of the spring."""
    id = "s6-stiffness-any-delay"
    then = taken_apart(page.claim(id))[2]
    free: dict = {gamma: S.Zero}
    theorem = conj(by_a_factor(then.of[0], free, {}), by_a_factor(then.of[1], {}, free))
    point = {**LONG, delta: S.Zero}
    wall = {alpha: Rational(1, 5000), beta: Rational(47, 2500)}
    denial = none_pushes(then.of[1].at(point), tuple(wall.values()), stable_at(wall | point | free))
    page.settle(
        id,
        theorem,
        example={gamma: S.Zero, delta: S.Zero, d: S.Zero},
        unless={AT_ONCE: (point, not_all(then.at(point), denial))},
        shows=r"at $d=49$ without damping the spring $\gamma=(\pi/100)^2$ excludes every wall with "
        r"$\alpha\ge0$, and $\alpha=0.0002$ is stable for a free mass",
        note="this holds for integer delays; without delay the factor is less than 1.05 on all of "
        "(23)",
    )
