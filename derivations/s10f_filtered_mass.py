r"""What does a filter of the velocity cost a light device?

A low-pass filter of the velocity, $1/(\tau_fs+1)$ by backward Euler, delays the force of the
damper. For a free mass we derive how stiff the wall may be, and whether the filter is equivalent to
a delay by its time constant.
"""

from symhaptic.book.lemmas.decided import SI, escapes, in_z
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.sources import STATEMENTS
from symhaptic.loops.velocity import DIFFERENCE, exponential_average
from symhaptic.notation import f_v, tau_f
from symhaptic.rules.other_loops import AVERAGING, LOW_PASS, POLE

EXACT, DELAY = "rules:low-pass-mass", "rules:filter-as-delay"


def derive(page):
    mass = plant.sampled(plant.normalised(Parts(False, False)))
    page.step(
        "By backward Euler the low-pass filter is an exponential average",
        1 / (tau_f / T * (1 - 1 / z) + 1),
        ((1 - f_v) * z / (z - f_v)).subs(f_v, tau_f / (T + tau_f)),
        because="backward Euler replaces $s$ by $(1-1/z)/T$, and the pole is "
        r"$f_v=\tau_f/(T+\tau_f)$",
    )
    wall = alpha + beta * in_z(DIFFERENCE.times(exponential_average(f_v)))
    page.step(
        "A free mass with a filtered velocity has this polynomial",
        (z - 1) ** 2 * (z - f_v) * (1 + mass.numerator / mass.denominator * wall),
        LOOP.of[0].subs({K: alpha, B: beta}),
        name=r"p_f(z)",
        because="the state of the filter replaces the previous sample",
    )
    page.lemma(
        "For $m=T=1$ a free mass with a filtered velocity is stable if and only if these bounds "
        "hold",
        in_units(),
        because="the last of Jury's inequalities is the quadratic one, and no wall with "
        "negative damping satisfies all of them",
    )
    printed = STATEMENTS[EXACT].printed
    found = page.lemma(
        "A free mass with a filtered velocity is stable if and only if these bounds hold",
        decides(*printed),
        boxed=True,
    )
    soft = {K: S.One / 4, B: S.One / 4, T: S.One, m: S.One, tau_f: S.One}
    page.settle(
        EXACT,
        found,
        example=soft,
        note=r"the bounds are exact without delay; for $\tau_f=0$ they are those of a wall without "
        "a filter",
    )
    _tangent(page, printed)
    _delay(page, printed, soft)


def _tangent(page, printed):
    """The filter does not change the tangent at the origin; it bends the boundary."""
    left, right = printed[-1].args
    page.step(
        "On the line $K=2B/T$ the last bound is violated by a multiple of $B^2$",
        (left - right).subs(K, 2 * B / T),
        4 * B**2 * (T + tau_f) * (T + 2 * tau_f) / T**2,
        because="the excess is of second order, so this line is the tangent at the origin for "
        "every filter; the filter affects only the curvature of the boundary",
    )
    page.lemma(
        "With every filter a stable wall of a free mass lies below the line $K=2B/T$",
        below_the_tangent(*printed),
    )
    page.say(
        "This line is also the tangent without the filter. For slow motions the delay of the "
        "spring is decisive, and the spring is not filtered. The delay of the damper has only a "
        "second-order effect. If the forces of spring and damper are both delayed by $t_d$, the "
        r"tangent changes to $K=B/(\frac12T+t_d)$."
    )


def _delay(page, printed, soft):
    [rule] = STATEMENTS[DELAY].printed
    found = page.lemma(
        r"With little damping a filter reduces the stiffness less than a wall delay of $\tau_f$",
        counted_as_delay(rule, *printed),
        boxed=True,
    )
    strong = soft | {K: S.Half, B: S.One}
    page.lemma(
        r"With $m=T=\tau_f=B=1$ the stiffness $\frac12$ is unstable", escapes(LOW_PASS, strong)
    )
    page.settle(
        DELAY,
        found,
        example=soft | {K: S.One / 8},
        unless={LITTLE: (strong, escapes(LOW_PASS, strong))},
        shows=r"for $m=T=\tau_f=B=1$ the rule allows $K<\tfrac23$, but $K=\tfrac12$ is unstable",
        note=r"at the origin the rule is too strict by the factor $1+2\tau_f/T$. The rule allows "
        r"unstable walls if $B>2m\tau_f/(T(T+4\tau_f))$, and for every $B$ if $\tau_f=0$",
    )


# The stable stiffness of a free mass with a filtered velocity.

UNITS = {T: S.One, m: S.One}
LOOP: Any = AVERAGING.at(UNITS)
LEFT = f_v * (1 + f_v) * K**2 + (1 - f_v) * (2 * (1 - f_v) + (1 + 3 * f_v) * B) * K
QUADRATIC: Any = proposition(2 * (1 - f_v) ** 2 * B * (2 - B) - LEFT > 0)
"""The last of Jury's inequalities for m = T = 1, which is quadratic in the stiffness."""

BOUNDS = And((proposition(K > 0), proposition(B > 0), QUADRATIC))
HERE = Given(*POLE)
for claim in 1 - f_v > 0, 1 + f_v > 0:
    HERE.have(claim)


@cache
def in_units() -> Theorem:
    """stable <=> K > 0, B > 0 and QUADRATIC, for m = T = 1 and 0 <= f_v < 1."""
    criterion = HERE.closed(jury(LOOP.of[0], z))
    wanted: Any = criterion.conclusion.of[1]  # type: ignore[attr-defined]
    inside = mp(criterion, assume(LOOP))
    first, second, _, last = (conjunct(inside, p) for p in wanted.parts)
    pushes = HERE.show(K > 0, over(K > 0, first, HERE.show(1 - f_v > 0)))
    room = show(QUADRATIC, last)
    # for B <= 0 the quadratic is minus a sum of products of y = -B >= 0
    slack = positive(f_v * K + (1 - f_v) * B > 0, [S.Half, second])
    none = HERE.and_(pushes, slack, B <= 0)
    against = combined(
        QUADRATIC.right <= 0,
        [2, slack, slack],
        [slack, pushes, none.show(1 - f_v > 0)],
        [2, pushes, none.show(1 - f_v > 0), none.show(1 - f_v > 0)],
        [4, none.show(-B >= 0), none.show(1 - f_v > 0), none.show(1 - f_v > 0)],
    )
    never = contr(not_intro(room, against), B > 0)
    damps = disj_cases(ordered(S.Zero, B), assume(B > 0), never)
    bounds = HERE.and_(*BOUNDS.of)
    back = mp(criterion, bounds.show(wanted))
    return HERE.closed(either_way(back, conj(pushes, damps, room), BOUNDS, LOOP))


TAU = SI.and_(tau_f >= 0)
SCALE = {K: K * T**2 / m, B: B * T / m, f_v: tau_f / (T + tau_f)}
SHARES = (m / T**2, m / T, (m * (T + tau_f) / T**2) ** 2)
"""The factors that convert each bound to SI units."""


@cache
def decides(*printed: Any) -> Theorem:
    """stable <=> the bounds in SI units, with the time constant of the filter."""
    for positive_ in T + tau_f > 0, m * (T + tau_f) / T**2 > 0, 1 / (T + tau_f) > 0:
        TAU.have(positive_)
    found = inst(in_units(), SCALE)
    bounds, loop = found.conclusion.of  # type: ignore[attr-defined]
    wanted = both(printed)
    there, back = [], []
    for raw, bound, share in zip(bounds.of, conjuncts(wanted), SHARES, strict=True):
        known, given = conjunct(assume(bounds), raw), conjunct(assume(wanted), bound)
        there.append(combined(bound, [TAU.show(share > 0), known]))
        back.append(combined(raw, [TAU.show(1 / share > 0), given]))
    forth = mp(found, conj(*back))
    here = prove_hyp(conj(*there), mp(found, assume(loop)))
    return TAU.closed(either_way(forth, here, wanted, loop), TAU.show(1 / T > 0))


LITTLE = proposition(2 * m * tau_f / (T * (T + 4 * tau_f)) >= B)
"""With less damping than this the filter reduces the stiffness less than a delay by tau_f."""


@cache
def counted_as_delay(rule: Any, *printed: Any) -> Theorem:
    """A wall with little damping and K < B/(T/2 + tau) is stable."""
    here = TAU.and_(K > 0, B > 0, rule, LITTLE)
    end = B / (T / 2 + tau_f)
    known = here.show(end > 0), assume(K > 0)
    below = assume(rule)
    far, slope = here.show(T + 2 * tau_f > 0), here.show(2 * m + B * (T + 4 * tau_f) > 0)
    share = here.show(B * (T + 4 * tau_f) / (T + 2 * tau_f) > 0)
    rows = [[below, assume(tau_f >= 0), far, t] for t in known]
    room = combined(printed[-1], *rows, [below, slope], [4, share, assume(LITTLE)])
    bounds = conj(assume(K > 0), assume(B > 0), room)
    return here.closed(mp(decides(*printed), bounds))


@cache
def below_the_tangent(*printed: Any) -> Theorem:
    """A stable wall has K < 2B/T with every filter."""
    inside = mp(decides(*printed), assume(LOW_PASS))
    pushes, damps, room = (conjunct(inside, p) for p in conjuncts(inside.conclusion))
    here = TAU.and_(pushes, damps)
    far, slope = here.show(T + 2 * tau_f > 0), here.show(B * (T + 4 * tau_f) > 0)
    rows = [pushes, pushes, assume(tau_f >= 0), far], [pushes, slope], [2, damps, damps]
    share = here.show(1 / (2 * m) > 0)
    return TAU.closed(combined(K < 2 * B / T, [share, room], *([share, *row] for row in rows)))
