r"""How stiff may a spring be in a simulator?

A simulator integrates Newton's law by Euler's method, and computes the force from position and
velocity of the simulated mass. The stiffness limits in simulation code apply to this loop. Are they
exact for it, and are they valid for a real device?
"""

from sympy import Matrix, Rational, S, eye

from symhaptic.book.lemmas.decided import SI, decided_by, escapes
from symhaptic.book.lemmas.held_motion import of_two_samples, settle_by_two_samples
from symhaptic.book.sources import CLAIMED, STATEMENTS
from symhaptic.loops.plant import moving_mass
from symhaptic.notation import B, K, T, alpha, beta, m, z
from symhaptic.notation.proposition import both
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import add_assum, conj, mp
from symhaptic.proof.theorems.tactics import counterexample, every, example, for_all, not_all
from symhaptic.rules.other_loops import EXPLICIT, SEMI_IMPLICIT

SEMI, PLAIN, BOTH, ONE, HELD = (
    f"rules:{name}"
    for name in (
        *("semi-implicit-euler", "euler-explicit", "both-below-two", "one-mass"),
        "euler-for-devices",
    )
)
POINT = {K: S.One, B: S.Half, T: S.One, m: S.One}
EDGE = {K: S.Half, B: Rational(19, 10), T: S.One, m: S.One}


def derive(page):
    _steps(page)
    bounds = {id: STATEMENTS[id].printed for id in (SEMI, PLAIN)}
    found = {
        SEMI: decided_by(SEMI_IMPLICIT, *bounds[SEMI]),
        PLAIN: decided_by(EXPLICIT, *bounds[PLAIN]),
    }
    for id, name in ((SEMI, "Semi-implicit Euler"), (PLAIN, "Explicit Euler")):
        symbols, given, _ = taken_apart(CLAIMED[id](bounds[id]))
        theorem = page.lemma(
            f"{name} is stable just within these bounds",
            found[id],
            because="they are Jury's inequalities for two zeros",
            boxed=True,
        )
        page.settle(
            id,
            for_all(symbols, given, add_assum(theorem, *given)),
            example=example(POINT, given),
            note="exact for this simulator",
        )
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
    """The polynomials, from the motion of a mass."""
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
    """Two checks that are made one by one."""
    claim = CLAIMED[BOTH](STATEMENTS[BOTH].printed)
    symbols, given, then = taken_apart(claim)
    loops = [found[id].conclusion for id in (SEMI, PLAIN)]
    given = given[:2]
    page.lemma("Explicit Euler lets $KT^2/m=1$, $BT/m=\\frac12$ grow", escapes(EXPLICIT, POINT))
    page.lemma(
        "Semi-implicit Euler lets $KT^2/m=\\frac12$, $BT/m=\\frac{19}{10}$ grow",
        escapes(SEMI_IMPLICIT, EDGE),
    )
    cases = [
        counterexample(claim, at, not_all(then.at(at), escapes(loop, at)))
        for loop, at in ((EXPLICIT, POINT), (SEMI_IMPLICIT, EDGE))
    ]
    theorem = conj(*(found[id] for id in (SEMI, PLAIN)))
    page.settle(
        BOTH,
        for_all(symbols, given, add_assum(theorem, *given)),
        instead=every(symbols, given, both(loops)),
        corrected=[
            r"K<\tfrac{4m}{T^2}-\tfrac{2B}{T}\ \text{with semi-implicit Euler}",
            r"K<\tfrac BT\ \text{and}\ K>\tfrac{2B}{T}-\tfrac{4m}{T^2}\ \text{with explicit Euler}",
        ],
        misprint=False,
        example=example(POINT, given),
        unless=cases,
        shows="explicit Euler is unstable at $(1,\\tfrac12)$, semi-implicit Euler at "
        "$(\\tfrac12,\\tfrac{19}{10})$: spring and damper share one bound",
    )


def _one_mass(page, exact):
    """A quarter of the end of the bound."""
    claim = CLAIMED[ONE](STATEMENTS[ONE].printed)
    symbols, given, _ = taken_apart(claim)
    little = 3 * m / (2 * T) >= B
    here = SI.and_(*given, little)
    bounds = exact.conclusion.of[0]
    theorem = page.lemma(
        "With little damping a quarter of $4m/T^2$ is stable in a simulator",
        here.closed(mp(exact, here.show(bounds))),
        because="with a damping of up to three quarters of $2m/T$ at least a quarter of the bound "
        "remains",
    )
    given = [*given, little]
    page.settle(
        ONE,
        for_all(symbols, given, add_assum(theorem, *given)),
        example=example(POINT | {K: S.Half}, given),
        unless=[counterexample(claim, EDGE, escapes(SEMI_IMPLICIT, EDGE), but=little)],
        shows="$m=T=1$: $K=\\tfrac12$, $B=\\tfrac{19}{10}$ grows",
        note="of semi-implicit Euler; for a device in place of a simulator no multiple of "
        "$m/T^2$ is a limit (\\chapter{s8c_four_masses})",
    )


def _held(page):
    """The same bound for a device."""
    page.say(
        "A device differs from a simulator in two ways: its force is held while it moves, and its "
        "velocity is the difference of two samples. Each of the two delays the wall by half a "
        "period:"
    )
    page.step(
        "The simulator's bound is this many times that of a free mass without delay",
        (4 * m / T**2 - 2 * B / T) / of_two_samples(),
        1 + 2 * m / (B * T),
        because="more than twice for $BT<2m$, and without bound for little damping",
    )
    settle_by_two_samples(
        page, HELD, "exact for semi-implicit Euler, and at least twice what a device bears"
    )
