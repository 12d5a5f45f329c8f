"""Which springs and walls are passive whose position is counted by an encoder."""

from __future__ import annotations

from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import Delta_x, f_c
from symhaptic.proof.theorems.energy import counted, dissipates, swing_gains
from symhaptic.rules.other_loops import SPRING, WALL

SAMPLED: Any = proposition(2 * b / T >= K)
COUNTED: Any = proposition(2 * f_c / Delta_x >= K)
BOUNDS = And((SAMPLED, COUNTED))
BESIDE = (b, f_c, T, Delta_x)
FORCES = (SPRING, WALL)
HERE = Given(T > 0, Delta_x > 0, b >= 0, f_c >= 0, K >= 0)
NEAR = (y - Delta_x / 2 <= x, x <= y + Delta_x / 2)
"""A count is off the position by half a count or less."""

HALF = S.Half


def _grows(store: Expr, force: Expr) -> Relation:
    """0 <= F(y) p + b p^2/T + f_c |p| - S(x + p) + S(x)."""
    taken = force * p_k + b * p_k**2 / T + f_c * Abs(p_k)
    return Relation(S.Zero, "<=", taken - store.xreplace({x: x + p_k}) + store)


def _both_signs(of: Expr, claim: Any, *rows: Any) -> Theorem:
    """A claim for either sign of a term: products, with |of| replaced by its cofactor (first)."""
    cofactor, plus, minus = rows
    ahead = combined(claim, *plus, [magnitude(of), -cofactor])
    back = combined(claim, *minus, [magnitude(of, negative=True), -cofactor])
    back = closed(back, show(of <= 0, of < 0))
    return disj_cases(ordered(of, S.Zero), back, ahead)


@cache
def spring_passive() -> Theorem:
    """A spring within both bounds is passive."""
    store, (low, high) = K * x**2 / 2, map(assume, NEAR)
    burnt = [HALF, assume(SAMPLED), square(p_k)]
    rubbed, pushed = [HALF, assume(COUNTED), assume(Delta_x > 0)], [assume(K >= 0)]
    ahead, back = assume(p_k >= 0), show(-p_k >= 0, p_k < 0)
    growth = _both_signs(
        p_k,
        _grows(store, SPRING),
        f_c,
        (burnt, [*rubbed, ahead], [*pushed, high, ahead]),
        (burnt, [*rubbed, back], [*pushed, low, back]),
    )
    some = HERE.show(store >= 0)
    return HERE.closed(
        dissipates(store, SPRING, BESIDE, (x, y, p_k), growth, some, identity(S.Zero, S.Zero))
    )


def _by_signs(claim: Any, sizes: Mapping[Symbol, Expr], *known: Any) -> Theorem:
    """A claim about absolute values, which it has names for, shown for each sign."""
    if not sizes:
        return Given(*known).show(claim)
    (size, of), *others = sizes.items()
    negative = closed(magnitude(of, negative=True), show(of <= 0, of < 0))
    found = []
    for sign, way, equal in ((of < 0, -1, negative), (of >= 0, 1, magnitude(of))):
        named = Relation(size, "=", way * of)
        there = _by_signs(claim, dict(others), *known, sign, named)
        found.append(closed(inst(there, {size: Abs(of)}), equal))
    return disj_cases(ordered(of, S.Zero), *found)


@cache
def wall_passive() -> Theorem:
    """A wall that only pushes is passive within the same bounds."""
    u, v = symbols("u v")
    reach = x + Abs(x)
    ahead = (x + u + 2 * p_k) ** 2 - (x + p_k + v) ** 2 >= 0
    bent = _by_signs(ahead, {u: x, v: x + p_k})
    over_, under = (
        _by_signs(Delta_x + way * (y + v - x - u) >= 0, {u: x, v: y}, *NEAR, Delta_x > 0)
        for way in (1, -1)
    )
    store = K * reach**2 / 8
    burnt = [HALF, assume(SAMPLED), square(p_k)]
    rubbed, pushed = [HALF, assume(COUNTED), assume(Delta_x > 0)], [HALF, assume(K >= 0)]
    stored_ = [HALF / 4, assume(K >= 0), bent]
    forth, back = assume(p_k >= 0), show(-p_k >= 0, p_k < 0)
    growth = _both_signs(
        p_k,
        _grows(store, WALL),
        f_c,
        (burnt, stored_, [*rubbed, forth], [*pushed, over_, forth]),
        (burnt, stored_, [*rubbed, back], [*pushed, under, back]),
    )
    some = HERE.show(store >= 0)
    none = identity(S.Zero, S.Zero)
    return HERE.closed(dissipates(store, WALL, BESIDE, (x, y, p_k), growth, some, none))


def passive(force: Expr) -> Predicate:
    """What the rule says of a spring or a wall."""
    return counted(force, y, BESIDE)


def _gain(force: Expr, swing: tuple[Any, ...], here: Given, *left: Any) -> Theorem:
    """A swing that gains energy, by what is left over: not passive."""
    _, way, *counts = swing
    one, other = (force.xreplace({y: n * Delta_x}) for n in counts)
    energy = one * way - other * way + 2 * b * way**2 / T + 2 * f_c * Abs(way)
    sizes = [[magnitude(of.args[0]), energy.expand().coeff(of)] for of in energy.atoms(Abs)]
    gain = combined(energy < 0, left, *sizes)
    return here.closed(swing_gains(force, y, BESIDE, swing, gain))


@cache
def across_a_count(force: Expr) -> Theorem:
    """Beyond 2 f_c/Delta_x a small swing across the edge of a count gains energy."""
    h, more = symbols("h"), K * Delta_x - 2 * f_c
    left = proposition(more - 4 * b * h / T > 0)
    here = HERE.and_(h > 0, h < Delta_x, left)
    found = _gain(force, (Delta_x / 2 - h, 2 * h, 0, 1), here, S(2), assume(h > 0), assume(left))
    there = HERE.and_(more > 0)
    there.have(more * T + 4 * b * Delta_x > 0)
    width = Delta_x * more * T / (2 * (more * T + 4 * b * Delta_x))
    return there.closed(inst(found, {h: width}))


@cache
def across_many(force: Expr) -> Theorem:
    """Beyond 2b/T a swing across many counts gains energy: friction grows with the way only."""
    n, more = symbols("n"), K - 2 * b / T
    left = proposition(n * Delta_x * more - 2 * f_c > 0)
    here = HERE.and_(whole(n), n > 0, left)
    here.have(n * Delta_x > 0)
    way = n * Delta_x
    found = _gain(
        force, (S.Zero, way, 0, n), here, assume(n > 0), assume(Delta_x > 0), assume(left)
    )
    there = HERE.and_(more > 0)
    there.have(Delta_x * more > 0)
    rest = there.closed(with_rest(2 * f_c, Delta_x * more, n))
    enough = inst(found, {n: n + 1})
    after = there.and_(*map(assume, conjuncts(rest.conclusion.body)))  # type: ignore[attr-defined]
    after.have(n + 1 > 0)
    return choose(rest, after.closed(enough))


@cache
def decides(force: Expr) -> Theorem:
    """passive <=> K <= 2b/T and K <= 2 f_c/Delta_x."""
    enough = spring_passive() if force == SPRING else wall_passive()
    claim = passive(force)
    found = []
    ways = (SAMPLED, K - 2 * b / T, across_many), (COUNTED, K * Delta_x - 2 * f_c, across_a_count)
    for bound, more, swing in ways:
        beyond = HERE.and_(bound.left > bound.right)
        denied_ = closed(swing(force), beyond.show(more > 0))
        never = contr(not_intro(assume(claim), denied_), bound)
        found.append(disj_cases(ordered(bound.right, bound.left), never, assume(bound)))
    needed = HERE.closed(conj(*found))
    return either_way(prove_hyp(enough, assume(BOUNDS)), needed, BOUNDS, claim)
