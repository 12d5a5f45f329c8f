r"""How do the spring, the damper and the mass of an arm change the area of the stable region?

Each of them can destabilise a single wall (\chapter{s4d_parts_of_the_arm}). This chapter compares
the areas of the regions without delay.
"""

from symhaptic.book.lemmas.areas import damper_adds, mass_adds
from symhaptic.book.lemmas.outpaced import at_point
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.spring_box import HIGH, LOW, PRIMED, THIN, WIDE, L, bounds
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import inequalities
from symhaptic.paper.propositions.areas import ENDS, moved_by_the_spring
from symhaptic.proof import box
from symhaptic.proof.theorems.leaves import on_box as on_plain_box


def derive(page):
    page.say(
        r"Without delay, a spring with $\gamma=0.001$ moves the region to the left and does not "
        r"make it smaller. Every stable wall, moved by $-0.001$ in $\alpha$, satisfies each of "
        "Jury's inequalities with the spring."
    )
    spring = page.lemma(
        r"A wall that is stable without a spring is stable with $\gamma=0.001$ if $\alpha$ is "
        "smaller by 0.001",
        spring_adds(),
    )
    damper = page.lemma(
        "A stable wall stays stable with more damping, for the arms of (23)",
        damper_adds(),
        because="therefore the region with more damping contains the region with less damping",
    )
    page.say(
        r"With twice the mass, $\alpha$ and $\beta$ of the same wall are half as large. "
        r"Therefore the same area in the plane of $\alpha$ and $\beta$ is four times as large in "
        "the plane of $K$ and $B$."
    )
    mass = page.lemma(
        "Four times the area with twice the mass exceeds the area with the single mass", mass_adds()
    )
    page.settle(
        "s4d-all-stabilising-area",
        conj(spring, damper, mass),
        note="the statement is proved without delay. The spring is the stiffest of (23), with "
        "the smallest and the largest damping. The damper may have any damping in the range "
        "(23). The mass is twice that of the arm of Figs. 11 and 12. A single wall can lose its "
        r"stability (\texttt{s4d-all-stabilising})",
    )


# Without delay the region with a spring contains the region without it, moved to the left.
#
# With L = 1 - e, the spring enlarges each of Jury's polynomials on a box that holds all walls.
# The coefficients of both devices are known to a part in a million, and so is their difference.

NEAR = Rational(5, 10**7)
"""The largest distance of n_1 and n_0 from their series in L minus gamma/24."""
SERIES = {n_1: S.Half - L / 6 - L**2 / 24, n_0: S.Half - L / 3 - L**2 / 24}
FREE = dict(zip(SERIES, sp.symbols("p_1 p_0"), strict=True))
SPRUNG = dict(zip(SERIES, sp.symbols("q_1 q_0"), strict=True))
"""The differences of n_1 and n_0 from the series, without a spring and with it."""
BOX = {
    **{alpha: (S.Zero, WIDE), beta: (LOW, HIGH), L: THIN[L]},
    **dict.fromkeys((*FREE.values(), *SPRUNG.values()), (-NEAR, NEAR)),
}
NAMED = {
    **{n: SERIES[n] + FREE[n] for n in SERIES},
    **{PRIMED[n]: SERIES[n] - STIFF / 24 + SPRUNG[n] for n in SERIES},
    e: 1 - L,
}
"""The coefficients of the devices in terms of the symbols of the box."""


class Both:
    """Two devices of the same damping, without and with a spring, and a wall of the first."""

    def __init__(self, damper: Expr) -> None:
        self.free = {gamma: S.Zero, delta: damper}
        self.sprung = {gamma: STIFF, delta: damper, **PRIMED}
        static = of_device("device at rest", assume(DEVICE))
        loss = of_device("device's loss", assume(DEVICE))
        self.static, self.static_sprung = inst(static, self.free), inst(static, self.sprung)
        self.same = combined(
            Eq(e, PRIMED[e]), [inst(loss, self.free)], [inst(loss, self.sprung), -S.One]
        )
        self.places: dict[Symbol, Expr] = {L: 1 - e}
        self.known = self._known()

    def of(self, expr: Expr, device: dict[Symbol, Expr]) -> Theorem:
        """0 < f for one of the devices."""
        return inst(at_point(expr, {s: (device[s], device[s]) for s in RANGES}), device)

    def _known(self) -> list[Theorem]:
        """The wall and the coefficients of the devices lie in the box."""
        self.wall = {n: numbers_known(inst(t, self.free)) for n, t in bounds().items()}
        known = [
            positive(alpha >= 0, [self.wall["right"]]),
            positive(alpha <= WIDE, [self.wall["left"]]),
            positive(beta >= LOW, [self.wall["up"]]),
            positive(beta <= HIGH, [self.wall["down"]]),
            combined(1 - e >= THIN[L][0], [self.of(1 - e - THIN[L][0], self.free)]),
            combined(1 - e <= THIN[L][1], [self.of(THIN[L][1] - 1 + e, self.free)]),
        ]
        for number, series in SERIES.items():
            more = number - series.xreplace({L: 1 - e})
            other = more + STIFF / 24
            # the series is the same, as e = e'
            after = other.xreplace({number: PRIMED[number]})
            share = sp.cancel((other.xreplace(PRIMED) - after) / (e - PRIMED[e]))
            self.places |= {FREE[number]: more, SPRUNG[number]: after}
            known += [
                combined(more <= NEAR, [self.of(NEAR - more, self.free)]),
                combined(more >= -NEAR, [self.of(NEAR + more, self.free)]),
                combined(after <= NEAR, [self.of(NEAR - other, self.sprung)], [-share, self.same]),
                combined(after >= -NEAR, [self.of(NEAR + other, self.sprung)], [share, self.same]),
            ]
        return known

    def gains(self, expr: Expr) -> Theorem:
        """0 < f for the wall and the devices, by ball arithmetic."""
        used = sp.expand(expr.xreplace(NAMED))
        ends = {s: BOX[s] for s in BOX if s in used.free_symbols}
        certificate: Any = box.positive(used, ends)
        return closed(inst(on_plain_box(certificate), self.places), *self.known)

    def inequality(self, goal: Any, before: Theorem | None) -> Theorem:
        """One of Jury's inequalities for the moved wall, from that for the wall (``before``)."""
        given = [] if before is None else [inst(before, self.free)]
        rest = goal.right - sum(t.conclusion.right for t in given)
        here, there = (rest.expand().coeff(n) for n in (a, PRIMED[a]))
        total = PRIMED[n_1] + PRIMED[n_0]
        rest = rest.xreplace({a: 1 + e, PRIMED[a]: 1 + PRIMED[e] - STIFF * total})
        gain = rest.xreplace({PRIMED[e]: e})
        share = sp.cancel((rest - gain) / (e - PRIMED[e]))
        return combined(
            goal,
            *([t] for t in given),
            [self.gains(gain)],
            [here, self.static],
            [there, self.static_sprung],
            [-share, self.same],
        )

    def stable(self) -> Theorem:
        """The moved wall is stable with the spring."""
        loop = inst(by_inequalities(0), {alpha: alpha - STIFF, **self.sprung})
        first, *others = conjuncts(loop.conclusion.of[1])
        total = self.of(n_1 + n_0, self.sprung)
        shown = [combined(first, [self.wall["right"], total], [self.static_sprung, -S.One])]
        known = inequalities(0)[1:]
        # the third is far from zero, and the spring does not enlarge it
        befores = (known[0], None, known[2])
        for goal, before in zip(others, befores, strict=True):
            shown.append(self.inequality(goal, before))
        found = mp(loop, conj(*shown))
        for device in (self.sprung, self.free):
            names = tuple(device.get(n, n) for n in NUMBERS)
            found = choose(device_exists(device[gamma], device[delta], names), found)
        return numbers_known(found)


@cache
def spring_adds() -> Theorem:
    """If a stable wall is moved, it is stable with the spring, for both dampings."""
    claim: Any = moved_by_the_spring()
    found = []
    for part, damper in zip(claim.of, ENDS, strict=True):
        found.append(as_claimed(part, Both(damper).stable()))
    return conj(*found)
