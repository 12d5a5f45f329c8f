"""All walls of a convex polygon are stable, for one arm and one integer delay.

One wall of it is stable, and none has a zero on the circle: each zero at exp(j theta) lies beyond
one of the sides, for all angles of an interval, or the device outweighs all walls there.  On the
way from the one wall to any other no zero then crosses the circle.
"""

from dataclasses import dataclass

import numpy as np

from symhaptic.book.lemmas.outpaced import at_point
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.numeric.plant import discretize
from symhaptic.paper.propositions.areas import Side, Wall, sides, within
from symhaptic.paper.propositions.stability import SQUARE

Arm: TypeAlias = tuple[Expr, Expr]

TURN = exp(I * theta)
TOP = n_1 * TURN + n_0
PLANT = TURN**2 - a * TURN + e
WALL = (alpha + beta) * TURN - beta
LATE = exp(I * (d + 1) * theta)
ROOT = Relation(LATE * PLANT + TOP * WALL, "=", S.Zero)
HALF = exp(-I * theta / 2)


def middle(corners: Sequence[Wall]) -> Wall:
    """The mean of the corners."""
    count = Rational(len(corners))
    x, y = (sum(values) / count for values in zip(*corners, strict=True))
    return x, y


# -- where a zero at an angle lies ----------------------------------------------------------


def beyond(side: Side, delay: int) -> Expr:
    """(p alpha + q beta - c) |N|^2 cos(theta/2) of a wall that has a zero at exp(j theta).

    With A/z = x + j y and N/sqrt(z) = u + j v such a wall has (alpha cos(theta/2) + j (alpha +
    2 beta) sin(theta/2)) |N|^2 = -exp(j (d + 1) theta) (x + j y) (u - j v).  Nothing in this form
    is a small difference of large numbers.
    """
    p, q, c = side
    low, high, turn = sin(theta / 2), cos(theta / 2), (delay + 1) * theta
    x_ = (1 - a + e) * high**2 - (1 + a + e) * low**2
    u_, lean = (n_1 + n_0) * high, n_1 - n_0
    along = x_ * u_ + 2 * (1 - e) * lean * low**2 * high
    up = 2 * (1 - e) * high * u_ - x_ * lean
    # sin((d + 1) theta)/sin(theta/2)
    waves = 2 * sp.Add(*(cos((n + S.Half) * theta) for n in range(delay + 1)))
    stiff = low**2 * waves * up - along * cos(turn)
    rise = -(along * waves + up * cos(turn))
    return (p - q / 2) * stiff + high * (q / 2 * rise - c * SQUARE)


def extremes(corners: Sequence[Wall]) -> tuple[Rational, Rational]:
    """The largest |alpha| and |alpha + 2 beta|."""
    return max(abs(x) for x, _ in corners), max(abs(x + 2 * u) for x, u in corners)


def outweighs(corners: Sequence[Wall]) -> Expr:
    """|A|^2 less the largest |N W|^2."""
    stiff, turned = extremes(corners)
    device = 1 + a**2 + e**2 + 2 * e * cos(2 * theta) - 2 * a * (1 + e) * cos(theta)
    return device - SQUARE * (stiff**2 * cos(theta / 2) ** 2 + turned**2 * sin(theta / 2) ** 2)


@dataclass(frozen=True)
class Stretch:
    """The angles up to ``high``, and the side beyond which their walls lie; None where the device
    outweighs all walls of the polygon."""

    high: Expr
    side: Side | None


def stretches(arm: Arm, delay: int, corners: Sequence[Wall]) -> list[Stretch]:
    """Angles from 0 to pi by the side that tells; found by a search."""
    values = discretize(float(arm[0]), float(arm[1]))
    known = dict(zip(NUMBERS, map(float, values), strict=True))
    grid = np.linspace(0.0, np.pi, 8001)
    runs: list[tuple[Side | None, np.ndarray[Any, Any]]] = []
    symbols = sp.symbols("p q c")
    value = sp.lambdify((theta, *symbols), beyond(symbols, delay).xreplace(known), "numpy")
    for line in sides(corners):
        found_beyond = value(grid, *map(float, line)) > 0
        runs.append((line, found_beyond & (grid < np.pi - 1e-3)))
    outweighed = sp.lambdify(theta, outweighs(corners).xreplace(known), "numpy")
    runs.append((None, outweighed(grid) > 0))

    def best(at: int) -> tuple[int, int, Side | None]:
        """The side that tells at an angle, and the first and last angle up to which it does."""
        found = []
        for side, good in runs:
            if good[at]:
                below, above = np.flatnonzero(~good[:at]), np.flatnonzero(~good[at:])
                first = int(below[-1]) + 1 if below.size else 0
                last = at + int(above[0]) - 1 if above.size else len(grid) - 1
                found.append((last, first, side))
        if not found:
            raise ValueError(f"at the angle {grid[at]:.4f} no side of {corners} tells")
        last, first, side = max(found, key=lambda f: f[0])
        return first, last, side

    found, at = [], 0
    _, last, side = best(0)
    while last < len(grid) - 1:
        first, after, other = best(last + 1)
        turn = (max(first, at) + last) // 2
        found.append(Stretch(Rational(round(float(grid[turn]) * 10**5), 10**5), side))
        at, last, side = turn, after, other
    return [*found, Stretch(pi, side)]


# -- no zero on the circle --------------------------------------------------------------------


@cache
def weights() -> dict[str, Theorem]:
    """0 <= |N|^2, and 0 < sin(theta/2), 0 < cos(theta/2) for 0 < theta < pi."""
    here = Given(theta > 0, theta < pi)
    return {
        "size": positive(SQUARE >= 0, [square(n_1 + n_0 * cos(theta))], [square(n_0 * sin(theta))]),
        "sine": here.show(sin(theta / 2) > 0),
        "cosine": here.show(cos(theta / 2) > 0),
    }


def _not_beyond(side: Side, delay: int, ranges: Any) -> Theorem:
    """No wall on the inner side has a zero at an angle of the interval."""
    p, q, c = side
    known, over_ = weights(), (p * alpha + q * beta - c) * SQUARE * cos(theta / 2)
    side_ = Relation(p * alpha + q * beta, "<=", c)
    inner = positive(over_ <= 0, [assume(side_), known["size"], known["cosine"]])
    root, back = assume(ROOT.at({d: S(delay)})), HALF * mirror(TOP)
    # real and imaginary part are |N|^2 times alpha cos(theta/2), (alpha + 2 beta) sin(theta/2)
    share = (p - q / 2) * back / 2 + q / 2 * cos(theta / 2) / sin(theta / 2) * back / (2 * I)
    zero = [root, -share], [mirrored(root), -mirror(share)]
    outer = positive(over_ > 0, [at_point(beyond(side, delay), ranges)], *zero)
    return closed(not_intro(outer, inner), not_zero(known["sine"]))


def _not_outweighed(corners: Sequence[Wall], delay: int, ranges: Any) -> Theorem:
    """Where the device outweighs all walls, none of them has a zero."""
    stiff, turned = extremes(corners)
    size, late = weights()["size"], LATE.xreplace({d: S(delay)}) * PLANT
    push = TOP * WALL
    root = assume(ROOT.at({d: S(delay)}))
    less = [
        positive(
            limit**2 - value**2 >= 0,
            [_at_most(value, limit, corners), _at_most(-value, limit, corners)],
        )
        for value, limit in ((alpha, stiff), (alpha + 2 * beta, turned))
    ]
    wide = [square(cos(theta / 2)), square(sin(theta / 2))]
    gap = PLANT * mirror(PLANT) - push * mirror(push)
    ahead = combined(
        Relation(S.Zero, "<", gap),
        [at_point(outweighs(corners), ranges)],
        *([size, more, turn] for more, turn in zip(less, wide, strict=True)),
    )
    nothing = combined(Relation(S.Zero, "=", gap), [root, -mirror(late)], [mirrored(root), push])
    return not_intro(ahead, nothing)


def _at_most(value: Expr, limit: Rational, corners: Sequence[Wall]) -> Theorem:
    """0 <= limit - value in the polygon, by the two sides that meet where the value is largest."""
    slope = value.coeff(alpha), value.coeff(beta)
    best = max(
        range(len(corners)), key=lambda i: slope[0] * corners[i][0] + slope[1] * corners[i][1]
    )
    before, after = sides(corners)[best - 1], sides(corners)[best]
    shares = sp.Matrix([[before[0], after[0]], [before[1], after[1]]]).solve(sp.Matrix(slope))
    rest = limit - shares[0] * before[2] - shares[1] * after[2]
    known = [
        [share, assume(Relation(p * alpha + q * beta, "<=", c))]
        for share, (p, q, c) in zip(shares, (before, after), strict=True)
        if share != 0
    ]
    return combined(limit - value >= 0, *known, *([[rest]] if rest else []))


def no_zero(arm: Arm, delay: int, corners: Sequence[Wall]) -> Theorem:
    """No wall of the polygon has a zero at exp(j theta), 0 < theta <= pi: falsehood of its root."""
    here = dict(zip((gamma, delta), ((v, v) for v in arm), strict=True))
    plan = stretches(arm, delay, corners)
    bounds = [S.Zero, *(s.high for s in plan)]

    def shown(index: int) -> Theorem:
        """From the angle ``bounds[index]`` on."""
        stretch = plan[index]
        ranges = {**here, theta: (bounds[index], stretch.high)}
        if stretch.side is None:
            found = _not_outweighed(corners, delay, ranges)
        else:
            found = _not_beyond(stretch.side, delay, ranges)
        if stretch.high == pi:
            return found
        below = number(Relation(stretch.high, "<", pi))
        found = Given(theta < stretch.high).closed(found, below)
        return disj_cases(ordered(theta, stretch.high), found, shown(index + 1))

    found = shown(0)
    low = positive(theta >= 0, theta > 0)
    return numbers_known(closed(found, low))


@cache
def all_stable(arm: Arm, delay: int, corners: tuple[Wall, ...]) -> Theorem:
    """All walls of the polygon are stable, with this arm and delay."""
    late, start = S(delay), middle(corners)
    here = dict(zip((gamma, delta), arm, strict=True))
    ways = dict(zip((alpha, beta), (alpha - start[0], beta - start[1]), strict=True))
    wall = {s: s - (1 - y) * way for s, way in ways.items()}
    more, rest = assume(proposition(y > 0)), positive(1 - y >= 0, y <= 1)
    kept = [
        combined(side.at(wall), [more, assume(side)], [rest, c - p * start[0] - q * start[1]])
        for side, (p, q, c) in zip(within(sides(corners)), sides(corners), strict=True)
    ]
    leftmost = min(x for x, _ in corners)
    none = closed(inst(no_zero(arm, delay, corners), wall), *kept)
    path = ROOT.at({d: late, **wall}).left  # type: ignore[attr-defined]
    wanted = proposition(Ne(path, 0))
    crossing = disj_cases(decided(path, S.Zero), contr(none, wanted), assume(wanted))

    left = _at_most(-alpha, -leftmost, corners)
    static = of_device("device at rest", assume(DEVICE))
    pushed = at_point(n_1 + n_0, {s: (v, v) for s, v in here.items()})
    stiff = positive(
        wall[alpha] + gamma > 0,
        [more, left],
        [rest, start[0] - leftmost],
        [leftmost + arm[0]],
        [assume(gamma >= arm[0])],
    )
    at_one = combined(
        Ne(1 - a + e + (n_1 + n_0) * wall[alpha], 0), [pushed, stiff], [static, -S.One]
    )
    held = stable_at({**dict(zip((alpha, beta), start, strict=True)), **here, d: late})
    begin = mp(inst(by_zeros(*start, gamma, delta, late), here), held)
    top = n_1 * z + n_0
    bottom, push = z ** (late + 1) * (z**2 - a * z + e), top * ((alpha + beta) * z - beta)
    first = bottom + top * ((start[0] + start[1]) * z - start[1])
    change = bottom + push - first
    zeros = inst(roots_stay(first, change, z, y, theta, crossing, at_one, begin), here)
    reading = inst(by_zeros(alpha, beta, gamma, delta, late), here)
    found = choose(device_exists(*arm, NUMBERS), closed(mp(reading, zeros), fact(whole(late))))
    found = numbers_known(found)
    return for_all((alpha, beta), within(sides(corners)), found)
