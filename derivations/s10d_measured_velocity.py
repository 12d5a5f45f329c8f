r"""What does a measured velocity change?

Some devices have a tachometer, and a simulator knows the velocity of its mass. The damper of the
wall then uses this velocity and not a difference of positions. How stiff may the wall be, and does
the same limit hold for a difference of positions?
"""

from sympy import Matrix, S, eye

from symhaptic.book.lemmas.decided import decided_by
from symhaptic.book.lemmas.held_motion import of_two_samples, settle_by_two_samples, show_motion
from symhaptic.book.sources import STATEMENTS
from symhaptic.loops.plant import moving_mass
from symhaptic.notation import B, K, T, alpha, beta, m, t, z
from symhaptic.rules.other_loops import MEASURED

KNOWN, TAKEN = "rules:known-velocity", "rules:two-dampings"


def derive(page):
    mass = moving_mass()
    rate, push = Matrix(mass.state), Matrix(mass.force)
    page.say(
        r"A free mass has $\dot x=v$ and $\dot v=F$ in units of mass and period. Under a held "
        r"force, the state after a time $t$ is $\Phi(t)$ times the old state plus $\Gamma(t)F$:"
    )
    phi, held = eye(2) + rate * t, push * t + rate * push * t**2 / 2
    show_motion(page, mass, (phi, held), "xv", "obeys Newton's law")
    one, moved = phi.subs(t, 1), held.subs(t, 1)
    page.step(
        "With a measured velocity the loop has this polynomial",
        (z * eye(2) - one + moved * Matrix([[alpha, beta]])).det(),
        (z - 1) ** 2 + (alpha / 2 + beta) * (z - 1) + alpha,
        name=r"\det(z-A)",
    )
    found = page.lemma(
        "With a measured velocity a wall of a free mass is stable if and only if these bounds hold",
        decided_by(MEASURED, *STATEMENTS[KNOWN].printed),
        because="the bounds are Jury's inequalities for a quadratic polynomial",
        boxed=True,
    )
    page.settle(
        KNOWN,
        found,
        example=dict.fromkeys((K, B, T, m), S.One),
        note="the bounds are exact for a free mass whose force is held for a period and has no "
        "delay",
    )
    page.say(
        "The stiffness limit rises with the damping up to the largest damping, $B=2m/T$. At "
        "this damping the damper alone reverses the velocity in each period. With the "
        "difference of two samples, the limit falls to zero instead:"
    )
    page.step(
        "A measured velocity raises the bound by this stiffness",
        2 * B / T - of_two_samples(),
        4 * B**2 / (2 * m + B * T),
        because="for little damping this increase is small; at $BT=2m$ it is the whole stiffness",
    )
    settle_by_two_samples(
        page,
        TAKEN,
        "the bound is exact for a measured velocity; for a difference of two samples it is the "
        "tangent at the origin",
    )
