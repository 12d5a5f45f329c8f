"""A wall that is stable with one spring is moved a little, and is stable with another one.

It is moved a share eta of its way to (-gamma, 1), and to the right by the difference of the
springs.  Delays are none.
"""

from symhaptic.book.lemmas.passive_is_stable import DEVICE, NUMBERS
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.spring_box import (
    CHANGE,
    COST,
    HIGH,
    LEAST,
    LITTLE,
    LOW,
    PRIMED,
    PULL,
    SHARE,
    START,
    WIDE,
    L,
    bounds,
    eta,
    g,
    numbers_near,
    on_walls,
    primed,
    y_0,
    y_1,
)
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import inequalities, on_box
from symhaptic.paper.propositions.plots import OTHER, THICK

SIDES = "right", "left", "up", "down"


class Moved:
    """A wall that is stable with one spring, and where it is moved for the other one.

    ``softer`` says that the other spring is not the stiffer one.
    """

    def __init__(self, softer: bool) -> None:
        self.softer = softer
        self.gap = gamma - OTHER if softer else OTHER - gamma
        self.share = START + SHARE * self.gap if softer else START
        self.stiffness = -OTHER + (1 - self.share) * (alpha + gamma)
        self.damping = beta + self.share * (1 - beta)
        one, late = PRIMED[n_1], PRIMED[n_0]
        self.places = {
            **{u: alpha + gamma, h: self.gap, g: gamma, m_1: one, m_0: late, eta: self.share},
            **{y_1: one - n_1, y_0: late - n_0, L: 1 - e},
        }
        order = gamma >= OTHER if softer else gamma <= OTHER
        springs = order, gamma >= 0, gamma <= STIFF, OTHER >= 0, OTHER <= STIFF
        self.apart = positive(self.gap >= 0, order)
        self.around = Given(*springs).and_(*(bounds()[side] for side in SIDES))
        near = (*numbers_near(), *map(primed, numbers_near()))
        self.numbers = self.around.and_(*near, self.same_loss())
        self.low = self.around.show(Relation(S.Zero, "<=", self.share))
        self.high = self.around.show(Relation(self.share, "<=", 2 * THICK))

    def on_walls(self, expr: Expr) -> Theorem:
        """0 < f of this wall and these devices, which lie in the box."""
        return self.numbers.closed(inst(on_walls(expr), self.places), degree=1)

    def same_loss(self) -> Theorem:
        """e = e'."""
        loss = of_device("device's loss", assume(DEVICE))
        return combined(Eq(e, PRIMED[e]), [loss], [primed(loss), -S.One])

    def there(self) -> tuple[Theorem, list[Theorem]]:
        """stable <=> Jury's inequalities of the moved wall, and these."""
        loop = inst(
            by_inequalities(0), {gamma: OTHER, **PRIMED, alpha: self.stiffness, beta: self.damping}
        )
        wanted = list(conjuncts(loop.conclusion.of[1]))  # type: ignore[attr-defined]
        return loop, [
            self.first(wanted[0]),
            self.second(wanted[1]),
            self.third(wanted[2]),
            self.minor(wanted[3]),
        ]

    def static(self) -> tuple[Theorem, Theorem]:
        """1 - a + e = gamma (n_1 + n_0), of both devices."""
        found = of_device("device at rest", assume(DEVICE))
        return found, primed(found)

    def eased(self) -> Theorem:
        """0 < 1 - eta."""
        claim = Relation(S.Zero, "<", 1 - self.share)
        return combined(claim, [self.high], [1 - 2 * THICK])

    def first(self, wanted: Any) -> Theorem:
        """The zero at 1 is inside."""
        total = primed(on_box(n_1 + n_0, RANGES))
        return positive(wanted, [total, self.eased(), bounds()["right"]], [self.static()[1], -1])

    def second(self, wanted: Any) -> Theorem:
        """The first of the half planes."""
        here, there = self.static()
        weight = show(1 - beta / 3 > 0, bounds()["down"])
        return positive(
            wanted,
            [self.on_walls(_plane(self.softer))],
            [weight, inequalities(0)[1]],
            [here, 1 - beta / 3],
            [there, -S.One],
            [self.same_loss(), -2],
        )

    def third(self, wanted: Any) -> Theorem:
        """The other half plane, far away."""
        plane = by_inequalities(0).conclusion.of[1].of[2].right  # type: ignore[attr-defined]
        wide = {**RANGES, alpha: (-2 * STIFF, WIDE), beta: (LOW, HIGH)}
        wall = {gamma: OTHER, **PRIMED, alpha: self.stiffness, beta: self.damping}
        found = combined(wanted, [inst(on_box(plane, wide), wall)])
        return self.around.closed(found, self.eased(), self.low)

    def minor(self, wanted: Any) -> Theorem:
        """Jury's minor."""
        here, there = self.static()
        eased, share = self.eased(), self.low
        pull = positive(PULL.xreplace(self.places) > 0, [self.on_walls(PULL - LEAST)], [LEAST])
        late, below = (self.on_walls(e) for e in (m_0, 1 - m_0))
        cost = self.on_walls(COST)
        little = Rational(1, 100)
        if self.softer:
            rest = show(LITTLE - little * self.share >= 0, self.high)
            gain = self.on_walls(SHARE * PULL - COST + little - LITTLE)
            spring = [[self.apart, gain], [self.apart, share, cost], [self.apart, rest]]
            loss = self.on_walls(START * PULL - CHANGE)
        else:
            spring = [[eased, self.apart, cost]]
            loss = self.on_walls(START * PULL - CHANGE - little * h)
        late_ = PRIMED[n_0]
        return combined(
            wanted,
            [eased, inequalities(0)[3]],
            [eased, loss],
            [START, share, pull],
            [share, assume(OTHER >= 0), late, below],
            *spring,
            [here, -(1 - self.share) * beta * n_0],
            [there, self.damping * late_],
            [self.same_loss(), self.damping * late_ - 1],
        )

    def stable(self) -> Theorem:
        """The moved wall is stable with the other spring."""
        loop, known = self.there()
        found = closed(mp(loop, conj(*known)))
        found = choose(device_exists(OTHER, delta, tuple(PRIMED.values())), found)
        return choose(device_exists(gamma, delta, NUMBERS), found)


def _plane(softer: bool) -> Expr:
    """The first half plane of the moved wall, less 1 - beta/3 times that of the wall itself."""
    share, change = (START + SHARE * h, -h) if softer else (START, h)
    return (
        2 * L * beta / 3
        + u * (m_1 - m_0) * (beta / 3 - share)
        + 2 * m_0 * (change + g * beta / 3)
        + 2 * (m_1 + m_0) * (beta**2 / 3 + share * (1 - beta))
        + (1 - beta / 3) * (u * (y_1 - y_0) + 2 * g * y_0 + 2 * beta * (y_1 + y_0))
    )
