r"""What does a measured velocity change?

Some devices have a tachometer, and in a simulator that holds its force for several steps the
velocity is known. The wall then takes the velocity itself and no difference of positions. How stiff
may it be, and does its limit hold for a difference?
"""

from sympy import Matrix, S, eye

from symhaptic.book.lemmas.circulation import damped_contact, outside
from symhaptic.book.lemmas.decided import decided_by
from symhaptic.book.sources import CLAIMED, STATEMENTS
from symhaptic.loops.plant import moving_mass
from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, k, m, t, z
from symhaptic.paper.reading import read
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import add_assum
from symhaptic.proof.theorems.tactics import counterexample, example, for_all
from symhaptic.rules.other_loops import MEASURED

KNOWN, TAKEN = "rules:known-velocity", "rules:two-dampings"
RIGHT = r"K < \frac{2B(2m-BT)}{T(2m+BT)}"


def derive(page):
    mass = moving_mass()
    rate, push = Matrix(mass.state), Matrix(mass.force)
    page.say(
        "A free mass has $\\dot x=v$ and $\\dot v=F$ in units of mass and period. Under a force "
        "that is held the state after a time $t$ is $\\Phi(t)$ times the old one and $\\Gamma(t)F$:"
    )
    phi, held = eye(2) + rate * t, push * t + rate * push * t**2 / 2
    for name, motion, force in ((r"\Phi", phi, 0), (r"\Gamma", held, 1)):
        for row, letter in enumerate("xv"):
            for column in range(motion.cols):
                page.step(
                    f"$\\{name[1:]}$ obeys Newton's law",
                    motion[row, column].diff(t),
                    (rate * motion)[row, column] + force * push[row],
                    name=rf"\dot{name}_{{{letter}{column + 1}}}",
                )
    one, moved = phi.subs(t, 1), held.subs(t, 1)
    page.step(
        "With a measured velocity the loop has this polynomial",
        (z * eye(2) - one + moved * Matrix([[alpha, beta]])).det(),
        (z - 1) ** 2 + (alpha / 2 + beta) * (z - 1) + alpha,
        name=r"\det(z-A)",
    )
    claim = CLAIMED[KNOWN](STATEMENTS[KNOWN].printed)
    symbols, given, _ = taken_apart(claim)
    found = page.lemma(
        "With a measured velocity a wall of a free mass is stable just within these bounds",
        decided_by(MEASURED, *STATEMENTS[KNOWN].printed),
        because="they are Jury's inequalities for two zeros",
        boxed=True,
    )
    point = {K: S.One, B: S.One, T: S.One, m: S.One}
    page.settle(
        KNOWN,
        for_all(symbols, given, add_assum(found, *given)),
        example=example(point, given),
        note="exact for a free mass whose force is held for a period and comes without delay",
    )
    page.say(
        "The stiffness may rise with the damping up to the largest one, $B=2m/T$. There the damper "
        "alone reverses the velocity in each period. With the difference of two samples "
        "the limit falls to zero instead:"
    )
    _difference(page)


def _difference(page):
    claim = CLAIMED[TAKEN](STATEMENTS[TAKEN].printed)
    [right] = read(RIGHT)
    symbols, given, _ = taken_apart(CLAIMED[TAKEN]((right,)))
    page.step(
        "The bound is this many times that for a difference of two samples",
        (2 * B / T) / right.rhs,
        (2 * m + B * T) / (2 * m - B * T),
        because="close to 1 for little damping, and without bound towards $BT=2m$",
    )
    wall = {K: S.One, B: S.One, T: S.One, m: S.One, b: S.Zero, k: S.Zero, d: S.Zero}
    driven = {alpha: S.One, beta: S.One, gamma: S.Zero, delta: S.Zero, d: S.Zero}
    page.lemma("The wall $K=B=1$ of $m=T=1$ has a root outside the circle", outside(driven))
    page.settle(
        TAKEN,
        for_all(symbols, given, add_assum(damped_contact(right), *given)),
        corrected=[RIGHT],
        misprint=False,
        example=example(wall | {K: S.Half}, given),
        unless=[counterexample(claim, wall, outside(driven))],
        shows="$m=T=B=1$: $K=1$ is half of what is allowed, and the limit is $\\tfrac23$",
        note="exact for a measured velocity; for a difference it is the tangent at the origin",
    )
