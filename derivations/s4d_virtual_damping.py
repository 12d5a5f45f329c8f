"""Can too much virtual damping make a wall unstable?

A physical damper only dissipates energy. The virtual damper uses the mean speed of the last period,
and its force is held for the next. We look for a bound of the virtual damping that no stable wall
can exceed.
"""

from symhaptic.book.lemmas.passive_is_stable import LOOP
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.model import loop
from symhaptic.paper.propositions.stability import AFTER, lost_by_damping

ARM = {gamma: Rational(1, 1000), delta: Rational(1, 50), alpha: Rational(1, 20)}
"""The largest spring and damper of (23)."""


def derive(page):
    polynomial = loop.named()
    last = polynomial - (z ** (d + 1)) * polynomial.coeff(z ** (d + 1))
    page.step(
        "The constant coefficient is $-\\beta n_0$ for every delay",
        last.subs(z, 0),
        -beta * n_0,
        name="p_1(0)",
        because="for every integer $d$, the rest of the polynomial has the factor $z^{d+1}$",
    )
    page.say(
        "The polynomial is monic, so its constant coefficient is the product of its roots, up "
        r"to the sign. If all roots lie inside the unit circle, $|n_0\beta|<1$ for all $\alpha$, "
        r"$\gamma$, $\delta$ and delays. A free mass has $n_0=\tfrac12$ and $|\beta|<2$, that is "
        "$|B|<2m/T$. With a delay of $p/q$ periods the same argument holds for the polynomial in "
        "$z^{1/q}$. The coefficient $n_0$ can be 0 for springs far stiffer than an arm. Then the "
        r"next coefficient bounds $n_1\beta$, and if also $n_1=0$, no wall is stable."
    )
    bounded = page.lemma(
        r"For each device and delay all stable walls have $\beta$ below one bound",
        bounded_damping(),
        boxed=True,
    )
    page.say(
        r"The examples have the largest spring and damper of (23), $\gamma=0.001$ and "
        r"$\delta=0.02$, and the stiffness $\alpha=0.05$:"
    )
    for delay, low, high in ((0, "1.9", "2.1"), (1, "0.7", "0.9")):
        for text, shown, word in ((low, stable_at, "stable"), (high, unstable_at, "not stable")):
            wall = {**ARM, d: S(delay), beta: Rational(text)}
            where = f"For $d={delay}$, $\\gamma=0.001$, $\\delta=0.02$"
            page.lemma(f"{where} the wall $(0.05,{text})$ is {word}", shown(wall))
    page.say(
        "With a delay the bound of the damping is lower. By the first theorem the bound does not "
        "depend on the virtual stiffness."
    )
    given = [gamma >= 0, delta >= 0, d >= 0]
    page.settle(
        "s4d-too-much-damping",
        conj(for_all((gamma, delta, d), given, add_assum(bounded, *given)), _lost()),
        note=r"every stable wall has $|n_0\beta|<1$, for every delay",
    )


def _lost():
    """Without delay, at alpha = 0.05, beta = 1.9 is stable and beta = 2.1 is not."""
    wanted = lost_by_damping()
    little, much = ({**ARM, d: S.Zero, beta: Rational(text)} for text in ("1.9", "2.1"))
    values = {**little, AFTER: much[beta]}
    known = {t.conclusion: t for t in (stable_at(little), unstable_at(much))}
    there = [part.at(values) for part in wanted.body.parts]
    return exists(conj(*(known.get(p) or fact(p) for p in there)), wanted, values)


# One bound limits the virtual damping of all stable walls, for every stiffness and delay.

OVER, LESS, FEWER = sp.symbols("p q r")
"""The delay is d = p/(s + 1), and q = p - 1."""


@cache
def none_or_more() -> Theorem:
    """An integer p >= 0 is 0, or p - 1 is an integer that is not negative."""
    none, more = Relation(OVER, "=", S.Zero), whole(OVER - 1)
    claim = Or((none, more))
    start = disj(identity(S.Zero, S.Zero), claim.at({OVER: S.Zero}))
    following = claim.at({OVER: OVER + 1})
    step = disj(is_whole(OVER, assume(whole(OVER))), following)
    return induction(claim, OVER, start, disch(step, whole(OVER), claim))


LATE = loop_late(NUMBERS, LOOP, (OVER, LESS))
"""A stable loop has a delay of p/(s + 1) periods."""

ZEROS = LATE.conclusion.of[1].body.of[-1]
BOUND = Exists((x,), every((alpha, beta), [STABLE], beta < x))
"""One bound of beta for all walls of a device and a delay."""


@cache
def bounded_damping() -> Theorem:
    """For each device and each d >= 0 there is an x with beta < x for every stable wall."""
    either = disj_cases(
        ordered(n_0, S.Zero),
        _by_the_product(-n_0),
        disj_cases(ordered(S.Zero, n_0), _by_the_product(n_0), _without_a_last_number()),
    )
    return choose(device_exists(gamma, delta, NUMBERS), either)


def _by_the_product(size: Expr) -> Theorem:
    """If n_0 is not 0, beta < 1/abs(n_0)."""
    product = _last(assume(ZEROS))
    signs = [conjunct(product, p) for p in product.conclusion.parts]
    return _bound(positive(1 - beta * size > 0, [signs[size != n_0]]), size)


def _bound(room: Theorem, size: Expr) -> Theorem:
    """BOUND follows from 0 < c - beta n with a number 0 < n of the device."""
    there = positive(size > 0, -size < 0) if size.could_extract_minus_sign() else assume(size > 0)
    most = sp.expand(room.conclusion.right + beta * size) / size
    wall = over(beta < most, room, there)
    walls = for_all((alpha, beta), [STABLE], choose(undisch(LATE), wall))
    return closed(exists(walls, BOUND, {x: most}), positive(Ne(*size.free_symbols, 0), [there]))


@cache
def _without_a_last_number() -> Theorem:
    """If n_0 = 0, beta < (2 + e^2)/abs(n_1); if also n_1 = 0, no wall is stable."""
    return disj_cases(
        ordered(n_1, S.Zero),
        _by_the_next(-n_1),
        disj_cases(ordered(S.Zero, n_1), _by_the_next(n_1), _without_numbers()),
    )


NO_LAST = both_ways(assume(n_0 <= 0), assume(n_0 >= 0))
NO_FIRST = both_ways(assume(n_1 <= 0), assume(n_1 >= 0))


def _last(inside: Theorem, power: Expr = S.Zero) -> Theorem:
    """Bounds of the last coefficient, for integers p, q and s."""
    return _in_whole(last_coefficient(inside, power))


def _in_whole(found: Theorem) -> Theorem:
    exponents = [
        h.of[0] for h in found.hypotheses if isinstance(h, Predicate) and h.name == "whole"
    ]
    sums = [t for t in exponents if not t.is_Symbol]
    return closed(found, *(is_whole(t, *(assume(whole(s)) for s in t.free_symbols)) for t in sums))


def _zero(claim: Proposition, symbol: Symbol, equation: Theorem) -> Theorem:
    """The claim with 0 in place of a symbol."""
    return subst(claim, symbol, assume(claim), equation)


def _by_the_next(size: Expr) -> Theorem:
    """If n_0 = 0, the lowest power of z is z^(s+1)."""
    inside = _zero(ZEROS, n_0, NO_LAST)
    claim = inside.conclusion
    none = prove_hyp(_last(_zero(claim, OVER, assume(sp.Eq(OVER, 0))), LESS + 1), inside)
    later = _last(assume(claim.at({OVER: FEWER + 1})), LESS + 1)
    later = prove_hyp(inst(later, {FEWER: OVER - 1}), inside)
    side, half = size != n_1, S.Half if size == n_1 else -S.Half
    wanted = 2 + e**2 - beta * size > 0
    lines = [conjunct(found, found.conclusion.parts[side]) for found in (none, later)]
    undelayed = positive(wanted, [lines[0]], [square(e - half)], [sp.Rational(3, 4)])
    delayed = positive(wanted, [lines[1]], [square(e)], [S.One])
    return _bound(disj_cases(none_or_more(), undelayed, delayed), size)


def _without_numbers() -> Theorem:
    """If n_1 = n_0 = 0, the held force does not move the device, and z = 1 stays a zero."""
    first = _zero(ZEROS, n_0, NO_LAST)
    inside = prove_hyp(_zero(first.conclusion, n_1, NO_FIRST), first)
    static = device_static(assume(DEVICE))
    zero = combined(sp.Eq(1 - a + e, 0), [static, 1], [NO_FIRST, gamma], [NO_LAST, gamma])
    never = _in_whole(zero_on_circle(inside.conclusion.terms[0], z, S.Zero, zero))
    wall = contr(not_intro(inside, never), beta < 0)
    walls = for_all((alpha, beta), [STABLE], choose(undisch(LATE), wall))
    return exists(walls, BOUND, {x: S.Zero})
