"""How wide the gap between the line and the start of the boundary is at most: gamma^2 delta/32."""

from symhaptic.book.lemmas.arm_numbers import SLOW, damped_or_not, pushed, turned, undamped
from symhaptic.book.lemmas.line_crossing import ROOM
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.analysis import grows
from symhaptic.proof.theorems.samples import after_a_blow

HALF, QUARTER = S.Half, Rational(1, 4)
MOST = gamma**2 * delta / 32
_PLACE, _BEFORE = Symbol("q"), Symbol("v")


@cache
def narrow() -> Theorem:
    """(s_1 - delta - gamma/2) (n_1 + n_0) <= gamma^2 delta/32."""
    given = (DEVICE, gamma >= 0, SLOW)
    implied = Implies((both(given), Relation(ROOM, "<=", MOST)))
    bare = [undamped(p) for p in given]
    free = disch(add_assum(_undamped(), *bare), *bare)
    found = damped_or_not(implied, disch(add_assum(_damped(), *given), *given), free)
    return closed(undisch(found), number(Relation(S.Zero, "<=", S.Zero)))


def _undamped() -> Theorem:
    """There is no gap: n_0 <= n_1 and e = 1."""
    device = assume(undamped(DEVICE))
    image, less = of_device("device's loss", device), inst(pushed()[2], {delta: S.Zero})
    claim = undamped(Relation(ROOM, "<=", MOST))
    return combined(claim, [HALF, assume(gamma >= 0), less], [image, -S.One])


def _damped() -> Theorem:
    """As the gap itself is found, with gamma^2 delta u^2/32 for what is left."""
    way = delta * u
    bent = (1 + way / 2) * exp(-way) - 1 + way / 2
    test = u * (1 - exp(-way)) + gamma * (1 - u) * bent / delta**2 - MOST * u**2
    first, second = delta + gamma / 2, delta - gamma / 2
    slope = derivative(test, u)
    kernel = first + second * exp(-way) - derivative(slope, u) - delta * slope - gamma * test
    here = Given(delta > 0, gamma >= 0, u > 0, u < 1)
    spring, loss, ago, rest = here.show(gamma**2 >= 0), delta > 0, u > 0, u < 1
    shown = positive(
        kernel >= 0,
        [spring, here.show(1 / delta**2 > 0), rest, inst(_bent(), {_PLACE: way})],
        [QUARTER, spring, loss, square(u - HALF)],
        [QUARTER, spring, loss, ago, rest, rest],
        [QUARTER, spring, loss, ago, ago, rest, rest],
        [Rational(1, 16), spring, loss, loss, ago],
        [Rational(1, 32), spring, gamma >= 0, loss, ago, ago],
    )
    found = here.closed(after_a_blow(assume(DEVICE), first, second, u, test, here.closed(shown)))
    return combined(Relation(ROOM, "<=", MOST), [found], [turned()[1], -S.One])


def _bent() -> Theorem:
    """0 < q^3/4 - ((1 + q/2) exp(-q) - 1 + q/2) for 0 < q."""
    inner = 3 * u**2 / 4 - HALF + (1 + u) * exp(-u) / 2
    speed = Given(u > 0).show(derivative(inner, u) > 0, rising(exp, -u, S.Zero))
    rise = grows(inner, u, S.Zero, _BEFORE, speed)
    outer = _BEFORE**3 / 4 - (1 + _BEFORE / 2) * exp(-_BEFORE) + 1 - _BEFORE / 2
    slope = combined(Relation(S.Zero, "<", derivative(outer, _BEFORE)), [rise])
    found = grows(outer, _BEFORE, S.Zero, _PLACE, slope)
    return positive(outer.subs(_BEFORE, _PLACE) > 0, [found])
