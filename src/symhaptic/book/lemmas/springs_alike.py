"""Without delay two springs of (23) have nearly the same stable walls."""

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
from symhaptic.book.lemmas.undelayed_curve import between
from symhaptic.paper.propositions.plots import (
    BESIDE,
    OTHER,
    THICK,
    alike,
    between_line_and_curve,
    near,
    undelayed,
)

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
        return combined(Relation(S.Zero, "<", 1 - self.share), [self.high], [1 - 2 * THICK])

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


def both_orders(made: Any) -> Theorem:
    """What holds where the other spring is softer and where it is stiffer."""
    stiffer = positive(gamma <= OTHER, gamma < OTHER)
    return disj_cases(ordered(gamma, OTHER), closed(made(False), stiffer), made(True))


@cache
def moves(softer: bool) -> tuple[Moved, Theorem]:
    """A moved wall, and that it is stable."""
    moved = Moved(softer)
    return moved, moved.stable()


def steps(moved: Moved) -> tuple[Theorem, ...]:
    """The way of a moved wall is at most THICK (1 - eta), in each direction."""
    ways, room = (moved.stiffness - alpha, moved.damping - beta), THICK * (1 - moved.share)
    here = moved.around.and_(moved.low, moved.high)
    return tuple(here.show(room + sign * way >= 0) for way in ways for sign in (1, -1))


def kept(softer: bool) -> Theorem:
    """Near a stable wall one is stable with the other spring."""
    moved, stable = moves(softer)
    wall = dict(zip(BESIDE, (moved.stiffness, moved.damping), strict=True))
    claim = Exists(BESIDE, both([*near(), undelayed(BESIDE, OTHER)]))
    ways = [
        combined(p.at(wall), [step], [THICK, moved.low])
        for p, step in zip(map(proposition, near()), steps(moved), strict=True)
    ]
    return exists(conj(*ways, stable), claim, wall)


def filled(softer: bool) -> Theorem:
    """Where all near walls are stable with the other spring, a wall is stable.

    It is what one of them is moved to, from the other spring to this one.
    """
    moved, stable = moves(not softer)
    swap = {gamma: OTHER, OTHER: gamma}
    share = moved.share.xreplace(swap)
    wall = {alpha: (alpha + gamma) / (1 - share) - OTHER, beta: (beta - share) / (1 - share)}
    other = undelayed(BESIDE, OTHER)
    around = ForAll(BESIDE, implied(near(), other))
    zero = [number(Relation(-THICK, "<=", S.Zero)), number(Relation(S.Zero, "<=", THICK))]
    itself = at(assume(around), dict(zip(BESIDE, (alpha, beta), strict=True)), *zero, *zero)
    back = [inst(t, swap) for t in steps(moved)]
    eased = inst(moved.eased(), swap)
    beside = dict(zip(BESIDE, (wall[alpha], wall[beta]), strict=True))
    left, right, down, up = back
    ways = [
        over(p.at(beside), step, eased)
        for p, step in zip(map(proposition, near()), (right, left, up, down), strict=True)
    ]
    there = at(assume(around), beside, *ways)
    found = inst(inst(stable, swap), wall)
    for s in (alpha, beta):
        found = _renamed(found, s)
    apart = combined(Relation(1 - share, "!=", S.Zero), [eased])
    found = closed(found, closed(there, apart), apart)
    return closed(found, itself)


def _renamed(theorem: Theorem, to: Symbol) -> Theorem:
    """A stable wall whose stiffness or damping is another expression for this one."""
    said: Any = theorem.conclusion
    index = (alpha, beta).index(to)
    place = Symbol("q")
    terms = [place if i == index else t for i, t in enumerate(said.of)]
    pattern = Predicate(said.name, (), tuple(terms))
    return subst(pattern, place, theorem, identity(said.of[index], to))


@cache
def springs_alike() -> Theorem:
    """Two springs of (23) have the same stable walls, within THICK of each coordinate."""
    walls = taken_apart(alike())[2]
    parts = []
    for claim, made in zip(walls.body.of, (kept, filled), strict=True):  # type: ignore[attr-defined]
        parts.append(disch(both_orders(made), claim.of[0]))
    return as_claimed(alike(), gen(conj(*parts), alpha, beta))


@cache
def line_and_curve() -> Theorem:
    """The stable walls lie above beta = -1, between alpha = -gamma and the curve."""
    return as_claimed(between_line_and_curve(), between())
