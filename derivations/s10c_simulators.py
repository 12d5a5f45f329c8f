r"""How stiff may a spring be in a simulator?

A simulator integrates Newton's law by Euler's method, and computes the force from position and
velocity of the simulated mass. The stiffness limits in simulation code apply to this loop. Are
these limits exact for a simulator, and are they valid for a real device?
"""

from sympy import Matrix

from symhaptic.book.lemmas.decided import SI, decided_by, escapes
from symhaptic.book.lemmas.held_motion import of_two_samples, settle_by_two_samples
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.sources import STATEMENTS
from symhaptic.loops.plant import moving_mass
from symhaptic.rules.other_loops import EXPLICIT, SEMI_IMPLICIT

SEMI, PLAIN, BOTH = "rules:semi-implicit-euler", "rules:euler-explicit", "rules:both-below-two"
ONE, HELD = "rules:one-mass", "rules:euler-for-devices"
POINT = {K: S.One, B: S.Half, T: S.One, m: S.One}
EDGE = {K: S.Half, B: Rational(19, 10), T: S.One, m: S.One}


def derive(page):
    _steps(page)
    found = {
        id: decided_by(loop, *STATEMENTS[id].printed)
        for id, loop in ((SEMI, SEMI_IMPLICIT), (PLAIN, EXPLICIT))
    }
    for id, name in ((SEMI, "Semi-implicit Euler"), (PLAIN, "Explicit Euler")):
        theorem = page.lemma(
            f"{name} is stable if and only if these bounds hold",
            found[id],
            because="the bounds are Jury's inequalities for a quadratic polynomial",
            boxed=True,
        )
        page.settle(id, theorem, example=POINT, note="the bounds are exact for this simulator")
    page.say(
        "The well-known limits $K<4m/T^2$ and $B<2m/T$ are the two end points of the first bound. "
        "At $B=0$ the oscillation of semi-implicit Euler neither grows nor decays. Each unit of "
        "damping reduces the stiffness limit by $2/T$. Explicit Euler is unstable at $B=0$: it "
        "requires $B>KT$."
    )
    _below_two(page, found)
    _one_mass(page, found[SEMI])
    _held(page)


def _steps(page):
    """Derive the polynomials from the motion of a mass."""
    mass = moving_mass()
    rate, push = Matrix(mass.state), Matrix(mass.force)
    wall = Matrix([[alpha, beta]])
    new_speed = eye(2) + Matrix([[0, 0], rate.row(1)]) - push * wall
    moves = Matrix([[1, 1], [0, 1]])
    page.say(
        "In units of mass and period the force is $-(\\alpha x+\\beta v)$. In both methods this "
        "force changes the velocity. Semi-implicit Euler then moves the mass by the new velocity, "
        "explicit Euler by the old one."
    )
    page.step(
        "The loop of semi-implicit Euler has this polynomial",
        (z * eye(2) - moves * new_speed).det(),
        z**2 + (alpha + beta - 2) * z + 1 - beta,
        name=r"\det(z-A_{\text{semi}})",
    )
    page.step(
        "The loop of explicit Euler has this polynomial",
        (z * eye(2) - (eye(2) + rate - push * wall)).det(),
        z**2 + (beta - 2) * z + 1 - beta + alpha,
        name=r"\det(z-A_{\text{explicit}})",
    )


def _below_two(page, found):
    """Refute the rule that bounds spring and damper separately."""
    symbols, given, then = taken_apart(page.claim(BOTH))
    exact = [found[id] for id in (SEMI, PLAIN)]
    page.lemma(
        r"With explicit Euler the wall $KT^2/m=1$, $BT/m=\frac12$ is unstable",
        escapes(EXPLICIT, POINT),
    )
    page.lemma(
        r"With semi-implicit Euler the wall $KT^2/m=\frac12$, $BT/m=\frac{19}{10}$ is unstable",
        escapes(SEMI_IMPLICIT, EDGE),
    )
    page.settle(
        BOTH,
        conj(*exact),
        instead=every(symbols, given[:2], both(t.conclusion for t in exact)),
        corrected=[
            r"K<\tfrac{4m}{T^2}-\tfrac{2B}{T}\ \text{with semi-implicit Euler}",
            r"K<\tfrac BT\ \text{and}\ K>\tfrac{2B}{T}-\tfrac{4m}{T^2}\ \text{with explicit Euler}",
        ],
        misprint=False,
        example=POINT,
        unless=[
            (at, not_all(then.at(at), escapes(loop, at)))
            for loop, at in ((EXPLICIT, POINT), (SEMI_IMPLICIT, EDGE))
        ],
        shows=r"explicit Euler is unstable for $KT^2/m=1$, $BT/m=\tfrac12$, and semi-implicit "
        r"Euler for $KT^2/m=\tfrac12$, $BT/m=\tfrac{19}{10}$: one bound limits the spring "
        "and the damper together",
    )


def _one_mass(page, exact):
    """Settle the rule that a quarter of 4 m/T^2 is a stable stiffness."""
    little = 3 * m / (2 * T) >= B
    here = SI.and_(*taken_apart(page.claim(ONE))[1], little)
    bounds = exact.conclusion.of[0]
    theorem = page.lemma(
        "With little damping, a quarter of $4m/T^2$ is a stable stiffness in a simulator",
        here.closed(mp(exact, here.show(bounds))),
        because="if the damping is at most three quarters of $2m/T$, at least a quarter of the "
        "bound remains",
    )
    page.settle(
        ONE,
        theorem,
        example=POINT | {K: S.Half},
        unless={little: (EDGE, escapes(SEMI_IMPLICIT, EDGE))},
        shows=r"for $m=T=1$ the wall $K=\tfrac12$, $B=\tfrac{19}{10}$ is unstable",
        note="the statement holds for semi-implicit Euler; for a device instead of a simulator, "
        "no stiffness limit proportional to $m/T^2$ guarantees stability "
        r"(\chapter{s8c_four_masses})",
    )


def _held(page):
    """Compare the bound of a simulator with that of a device."""
    page.say(
        "A device differs from a simulator in two ways: its force is held while it moves, and "
        "its velocity is the difference of two samples. Each of these two differences adds a "
        "delay of half a period, which reduces the stable stiffness:"
    )
    page.step(
        "The ratio of the simulator's bound to that of a free mass without delay exceeds 2",
        (4 * m / T**2 - 2 * B / T) / of_two_samples(),
        1 + 2 * m / (B * T),
        because="the ratio exceeds 2 for $BT<2m$, and it grows without bound as the damping "
        "tends to 0",
    )
    settle_by_two_samples(
        page,
        HELD,
        "the bound is exact for semi-implicit Euler, and at least twice the limit of a device",
    )
