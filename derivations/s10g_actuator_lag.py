r"""Is a lag of the actuator the same as a delay?

Amplifiers and torque loops follow their command with a lag $1/(\tau_as+1)$. The usual advice is to
treat this lag as an additional delay of $\tau_a$. For a free mass we derive the exact loop with
the lag, and ask whether the advice is conservative.
"""

from sympy import Matrix, cos, exp, eye, pi, sin, sqrt

from symhaptic.book.lemmas.circulation import inside, outside
from symhaptic.book.lemmas.decided import SI, escapes
from symhaptic.book.lemmas.held_motion import show_motion
from symhaptic.book.lemmas.prelude import *
from symhaptic.loops.actuator import lagging
from symhaptic.loops.plant import moving_mass
from symhaptic.notation import tau_a
from symhaptic.proof.theorems.analysis import grows
from symhaptic.rules.other_loops import BEHIND, FADING, FOLLOWING, LAG, LAGGING, SWINGING

RULE, BELOW = "rules:lag-as-delay", "rules:lag-below-delay"


def derive(page):
    _loop(page)
    page.lemma(
        "For $m=T=1$ a stable wall satisfies $K(\\frac12+\\tau)<B$",
        in_units(),
        because="two of Hurwitz' inequalities imply this bound if five expressions in the lag "
        r"$\tau=\tau_a/T$ and $q=e^{-1/\tau}$ are positive",
    )
    for theorem, of in zip(
        exponentials(), ("the first", "the second", "the third", "the last"), strict=True
    ):
        page.lemma(f"The exponential exceeds {of} bound", theorem)
    found = page.lemma(
        r"With a lag every stable wall of a free mass satisfies $K(\frac T2+\tau_a)<B$",
        below_the_line(),
        boxed=True,
    )
    wall = {K: Rational(18, 100), B: Rational(56, 100), T: S.One, m: S.One, tau_a: S.One}
    page.settle(
        RULE,
        found,
        example=(wall, holds(LAGGING, wall)),
        note="at the origin the condition is necessary and sufficient: the lag is equivalent to a "
        "delay. Farther from the origin it is only necessary, and an equal delay reduces the "
        "stiffness more than the lag",
    )
    page.say(
        "Farther from the origin a lag reduces the stiffness less than an equal delay. A lag "
        "attenuates the high frequencies, at which a delayed wall becomes unstable."
    )
    page.lemma(
        r"With a lag of one period the wall $K=\frac{18}{100}$, $B=\frac{56}{100}$ is stable for "
        "$m=T=1$",
        holds(LAGGING, wall),
    )
    late = {alpha: wall[K], beta: wall[B], gamma: S.Zero, delta: S.Zero, d: S.One}
    page.lemma(
        r"With a delay of one period the wall $K=\frac{18}{100}$, $B=\frac{56}{100}$ is not stable",
        outside(late),
    )
    page.lemma(
        r"With a lag of one period the wall $K=\frac15$, $B=\frac{56}{100}$ is not stable",
        escapes(LAGGING, wall | {K: Rational(1, 5)}),
    )
    slow = {K: Rational(4, 100), B: S.Half, T: S.One, m: S.One, tau_a: S(5)}
    page.lemma(
        r"With a lag of five periods the wall $K=\frac4{100}$, $B=\frac12$ is stable",
        holds(LAGGING, slow),
    )
    late = late | {alpha: slow[K], beta: slow[B], d: S(5)}
    page.lemma(
        r"With a delay of five periods the wall $K=\frac4{100}$, $B=\frac12$ is not stable",
        outside(late),
    )
    _with_a_spring(page)


def _with_a_spring(page):
    """With a spring the lag may be worse than an equal delay."""
    lag, swing = LAG, sqrt(gamma)
    device = lagging(moving_mass(gamma), lag)
    page.say(
        "For a device with a spring a lag can be worse than an equal delay. Without damping, the "
        r"state after a time $t$ is again $\Phi(t)$ times the initial state plus $\Gamma(t)F$:"
    )
    fall, turn, rise = exp(-t / lag), cos(swing * t), sin(swing * t)
    pulled = lag**2 / (1 + swing**2 * lag**2) * (fall - turn + rise / (swing * lag))
    held = (1 - turn) / swing**2 - pulled
    phi = Matrix(
        [
            [turn, rise / swing, pulled],
            [-swing * rise, turn, pulled.diff(t)],
            [0, 0, fall],
        ]
    )
    push = Matrix([held, held.diff(t), 1 - fall])
    show_motion(page, device, (phi, push), "xvu", "obeys the equations of spring and actuator")
    page.step(
        "The loop of mass, spring, actuator and wall has this polynomial",
        closed_loop(phi, push, {alpha: alpha, beta: beta}) * gamma * (1 + gamma * lag**2),
        SWINGING.of[0].subs({K: alpha, B: beta, T: 1, m: 1, k: gamma, FADING: exp(-1 / lag)}),
        name=r"\gamma(1+\gamma\tau^2)\det(z-A)",
    )
    page.say(
        r"Take a device that oscillates once in four periods, $\gamma=\pi^2/4$, and a delay of "
        "three quarters of this oscillation:"
    )
    spring = pi**2 / 4
    late = {alpha: spring / 10, beta: spring / 20, gamma: spring, delta: S.Zero, d: S(3)}
    still = page.lemma(
        r"With a delay of three periods the wall $\alpha=\frac{\pi^2}{40}$, "
        r"$\beta=\frac{\pi^2}{80}$ is stable",
        inside(late),
    )
    wall = {K: late[alpha], B: late[beta], T: S.One, m: S.One, k: late[gamma], tau_a: S(3)}
    grown = page.lemma(
        "With a lag of three periods the same wall is unstable",
        escapes(SWINGING.at(BEHIND), wall),
        because="delayed by three quarters of an oscillation, the wall's spring acts as a damper",
    )
    page.settle(
        BELOW,
        conj(still, grown),
        instead=both([still.conclusion, grown.conclusion]),
        corrected=[r"\text{a lag has to be judged as a lag}"],
        misprint=False,
        unless=[(wall | {d: late[d]}, still, grown)],
        shows="a device that oscillates once in four periods is stable with a delay of three "
        "periods and unstable with a lag of three periods",
        note="a lag shifts the phase by less than 90 degrees and cannot replace a delay that acts "
        "as damping. Model the actuator with its lag",
    )


def closed_loop(phi, held, wall):
    """The polynomial of a device after a lag, with the previous position as a state."""
    one, moved = phi.subs(t, 1), held.subs(t, 1)
    step = Matrix(4, 4, lambda i, j: one[i, j] if i < 3 and j < 3 else int((i, j) == (3, 0)))
    push = Matrix([*moved, 0]) * Matrix([[wall[alpha] + wall[beta], 0, 0, -wall[beta]]])
    return (z * eye(4) - step + push).det(method="berkowitz")


def _loop(page):
    """The motion over a period under a held command, and the polynomial of the loop."""
    tau = LAG
    device = lagging(moving_mass(), tau)
    page.say(
        "In units of mass and period, the state is the position, the velocity and the "
        r"actuator's force $u$, with $\tau=\tau_a/T$ and $\tau\dot u=F-u$. Under a held command "
        r"$F$, the state after a time $t$ is $\Phi(t)$ times the initial state plus $\Gamma(t)F$:"
    )
    fall = exp(-t / tau)
    slip = tau * (1 - fall)
    phi = Matrix([[1, t, tau * (t - slip)], [0, 1, slip], [0, 0, fall]])
    held = Matrix([t**2 / 2 - tau * (t - slip), t - slip, 1 - fall])
    show_motion(page, device, (phi, held), "xvu", "obeys the equations of device and actuator")
    page.step(
        "With the previous position as the fourth state the loop has this polynomial",
        closed_loop(phi, held, {alpha: alpha, beta: beta}),
        LOOP.of[0].subs({K: alpha, B: beta, FADING: exp(-1 / tau)}),
        name=r"\det(z-A)",
    )


# A free mass with an actuator lag: the line of an equal delay bounds the stable stiffness.

h, u = symbols("h u")
AHEAD, BEFORE = Given(h > 0), Given(u > 0, u < h)


def _from_zero(rest: Expr, slope: Theorem) -> Theorem:
    """0 < f(h) if f(0) = 0 and the slope of f is positive on (0, h)."""
    return grows(rest, u, S.Zero, h, slope)


def _at_u(theorem: Theorem) -> Theorem:
    return BEFORE.closed(inst(theorem, {h: u}))


@cache
def exponentials() -> list[Theorem]:
    """1 < e^h, 1 + h < e^h, 1 + h + h^2/2 < e^h and 2 (e^h - 1) < h (e^h + 1), for h > 0."""
    grown = show(exp(h) - 1 > 0, rising(exp, S.Zero, h))
    found = [AHEAD.closed(grown)]
    for rest in exp(u) - 1 - u, exp(u) - 1 - u - u**2 / 2:
        found.append(_from_zero(rest, show(derivative(rest, u) > 0, _at_u(found[-1]))))
    rest = u * exp(u) - exp(u) + 1
    bent = combined(derivative(rest, u) > 0, [assume(u > 0), sign_of(exp, u)])
    turned = _at_u(_from_zero(rest, bent))
    rest = u * (exp(u) + 1) - 2 * (exp(u) - 1)
    found.append(_from_zero(rest, show(derivative(rest, u) > 0, turned)))
    return found


LOOP = FOLLOWING.at({T: S.One, m: S.One})
LOST = 1 - FADING
TURN = 1 + FADING - 2 * LAG * LOST
AHEAD_BY = LAG * LOST - FADING
BENT = 4 * LAG**2 * LOST**2 - 4 * LAG * FADING * LOST - 2 * FADING * LOST
SIGNS = tuple(proposition(t > 0) for t in (LOST, LAG, TURN, AHEAD_BY, BENT))


@cache
def in_units() -> Theorem:
    """A stable wall has K (1/2 + tau) < B for m = T = 1, by two of Hurwitz' inequalities."""
    found = first_minors(assume(LOOP), 2)
    _, first, second = (conjunct(found, p) for p in found.conclusion.parts)
    lag, turn, ahead, bent = map(assume, SIGNS[1:])
    pushes, damps = assume(K > 0), assume(B > 0)
    surplus = 8 * LOST**2 * (B - K * (LAG + S.Half))
    rows = (
        [second],
        [2, first, lag, turn, pushes],
        [4, first, ahead, damps],
        [2, pushes, damps, bent],
    )
    above = combined(surplus > 0, *rows)
    share = show(1 / (8 * LOST**2) > 0, SIGNS[0])
    return combined(K * (LAG + S.Half) < B, [share, above])


@cache
def below_the_line() -> Theorem:
    """A stable wall has K < B/(T/2 + tau), in SI units."""
    here = SI.and_(tau_a > 0, K > 0, B > 0)
    grown, once, twice, thrice = exponentials()
    h_ = T / tau_a
    fades = exp(-h)
    slow = Given(h > 0, *exponentials())
    signs = {FADING: fades, LAG: 1 / h}
    share, part = slow.show(1 / h > 0), sign_of(exp, -h)
    known = (
        combined(SIGNS[0].at(signs), [part, grown]),
        show(SIGNS[1].at(signs), share),
        combined(SIGNS[2].at(signs), [share, part, thrice]),
        combined(SIGNS[3].at(signs), [share, part, once]),
        combined(SIGNS[4].at(signs), [4, share, share, part, part, grown, twice]),
    )
    scale = {K: K * T**2 / m, B: B * T / m}
    found = inst(closed(inst(in_units(), signs), *known), scale | {h: h_})
    found = combined(B / (T / 2 + tau_a) > K, [here.show(m / (T * (T / 2 + tau_a)) > 0), found])
    return here.closed(found)


def holds(stable: Proposition, point: Mapping[Any, Any]) -> Theorem:
    """The loop with these numbers is stable, by balls around its zeros."""
    return roots_inside(stable.at(point).terms[0], z, {})
