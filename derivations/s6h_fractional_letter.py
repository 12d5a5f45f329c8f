r"""Which polynomial do the paper's curves for $d=1/4$ and $d=1/2$ belong to?

With $d=r/q$ the paper turns $z^{-d}$ into a polynomial by substituting $z=\zeta^q$. Taken
literally, all roots of this polynomial have to lie inside the unit circle. This is impossible for
the walls of the figures.
"""

from symhaptic.book.lemmas.chords import PI
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.walls import met
from symhaptic.paper.propositions.comparison import passive
from symhaptic.proof.theorems.roots import opposite


def derive(page):
    page.say(
        r"In $\zeta$ the polynomial is "
        r"$\zeta^{q+r}A(\zeta^q)+N(\zeta^q)((\alpha+\beta)\zeta^q-\beta)$, of degree $3q+r$. Each "
        r"of the $q$ values of $\zeta$ for one $z$ gives the wall a different phase, a multiple of "
        r"$2\pi d$. Let $q$ be even, as in all fractions of the paper. Then $r$ is odd, and "
        r"$\zeta=-1$ gives $z=1$ but $z^d=-1$. At this point the wall has the opposite sign."
    )
    static, total = device_static(assume(DEVICE)), n_1 + n_0
    for power, wall, title, because in (
        (
            1,
            gamma + alpha,
            r"At $\zeta=1$ the polynomial is a multiple of $\gamma+\alpha$",
            "the value is positive if all roots lie inside",
        ),
        (
            -1,
            alpha - gamma,
            r"At $\zeta=-1$ the polynomial is a multiple of $\alpha-\gamma$, for even $q$",
            "the value is negative if all roots lie inside, since the degree $3q+r$ is odd",
        ),
    ):
        value = Eq(power * (1 - a + e) + total * alpha, total * wall)
        page.lemma(title, combined(value, [static, power]), because=because)
    settle_literal(page)
    settle_figures(page)


def settle_literal(page):
    found = page.lemma(
        "Taken literally, the spring of the device bounds the stiffness of a stable wall if $q$ is "
        "even",
        within_the_spring(),
        because=r"all roots of $p_1(-\zeta)$ also lie inside, so the values at 1 and at "
        "$-1$ have the sign of the highest power",
    )
    page.state(
        "fractional-literal",
        r"taken literally, for even $q$, a wall is stable only if $|\alpha|<\gamma$; without a "
        "physical spring no wall is stable",
        claim=only_within_the_spring(),
    )
    idle = {alpha: HALF / 5, beta: HALF / 5, gamma: S.One, delta: S.One, p: S.Zero, q: S.Zero}
    page.settle("fractional-literal", found, example=(idle, stable_at(idle | {d: HALF})))


def settle_figures(page):
    page.say(
        r"In Fig. 11 $\gamma=0.001$, $\delta=0.02$, and the text says that the passive regions lie "
        r"inside the stable ones. By (11) the passive regions extend to $\alpha=0.023$ for "
        r"$d=\frac12$, and farther for $d=\frac14$. This is 23 times as far as the stable walls of "
        r"the literal reading. Sec. V-C is about walls that are stable for all $\gamma\ge0$, but "
        r"in the literal reading no wall is stable for $\gamma=0$."
    )
    page.state(
        "fractional-figures",
        "the curves of Fig. 11 and Fig. 13 for fractional delays are not those of the polynomial "
        "taken literally: with this polynomial some wall of Fig. 11 that satisfies (5) is not "
        "stable, and no wall of Fig. 13 is stable",
        claim=not_those_drawn(),
    )
    page.settle(
        "fractional-figures",
        drawn_otherwise(),
        note="Fig. 4 shows (7), which uses the principal sheet; the text does not say whether the "
        "other figures use it or the exact plant",
    )


# (18) taken literally, with all sheets of z^d: for an even denominator hardly any wall is stable.

p, q = Symbol("p"), Symbol("q")
EVEN = (2 * p + 1) / (2 * q + 2)
"""A delay with an even denominator, also in lowest terms."""
WALLS = (alpha, beta, gamma, delta, p, q)


def letter(late: Expr) -> Predicate:
    """Stable if (18) is taken literally."""
    return Predicate("stable_substituted", (), (alpha, beta, gamma, delta, late))


GIVEN = (gamma >= 0, whole(p), whole(q), letter(EVEN))
WITHIN = And(tuple(map(proposition, (gamma > 0, alpha > -gamma, alpha < gamma))))


def only_within_the_spring() -> Proposition:
    """Taken literally, (18) allows only walls with gamma > 0 and abs(alpha) < gamma."""
    return every(WALLS, GIVEN, WITHIN)


@cache
def within_the_spring() -> Theorem:
    """The polynomial is positive at w = 1, and has the sign of the highest power at w = -1."""
    over_, under = 2 * p + 1, 2 * q + 1
    found = axiom("loop in w", *(alpha, beta, gamma, delta, EVEN), *NUMBERS, over_, under)
    known = [assume(whole(s)) for s in (p, q)]
    count = closed(positive(q + 1 > 0, [q >= 0], [S.One]), axiom("not negative", q))
    divisor = positive(Ne(2 * q + 2, 0), [Integer(2), count])
    ratio = identity(EVEN * (under + 1), over_)
    steps = [is_whole(s, *known) for s in (over_, under)]
    found = closed(found, ratio, *steps)
    inside = mp(found, assume(letter(EVEN)))
    first, other = (
        conjunct(signs, signs.conclusion.parts[0])
        for signs in (first_minors(t, 0) for t in (inside, opposite(inside)))
    )
    static = device_static(assume(DEVICE))
    total = n_1 + n_0
    spring = positive(gamma * total > 0, [S.Half, first], [S.Half, other], [static, S.One])
    stiff = strictly(positive(gamma >= 0, gamma >= 0), factor(gamma, spring, total))
    pushed = closed(over(gamma * total / gamma > 0, spring, stiff), positive(Ne(gamma, 0), [stiff]))
    apart = positive(Ne(total, 0), [pushed])

    def share(claim: Expr, known: Theorem) -> Theorem:
        room = positive(total * claim > 0, [known], [static, S.One])
        return closed(over(total * claim / total > 0, room, pushed), apart)

    pushes, pulls = share(gamma + alpha, first), share(gamma - alpha, other)
    within = conj(stiff, positive(alpha > -gamma, [pushes]), positive(alpha < gamma, [pulls]))
    powers = [is_whole(h.of[0], *known) for h in within.hypotheses if _exponent(h)]
    found = choose(device_exists(gamma, delta, NUMBERS), closed(within, *powers, divisor))
    return for_all(WALLS, GIVEN, found)


def _exponent(claim: Proposition) -> bool:
    return isinstance(claim, Predicate) and claim.name == "whole" and claim.of[0] not in (p, q)


# -- the figures -----------------------------------------------------------------------

DELAYS = (HALF, HALF / 2)
DRAWN = {gamma: Rational(1, 1000), delta: Rational(1, 50)}
"""The device of Fig. 11."""
FREE = DRAWN | {gamma: S.Zero}
"""The device of Fig. 11 without a spring, which is one of the devices of Fig. 13."""
STIFF = {alpha: Rational(1, 100), beta: S.Zero}
"""A wall that meets (5), ten times as stiff as the spring of Fig. 11."""


def not_those_drawn() -> Proposition:
    """(18) taken literally, with a delay of half and a quarter of a period.

    Some wall of Fig. 11 that meets (5) is not stable, which the text excludes. No wall is stable
    without a spring, a device of Fig. 13.
    """
    return both(c for late in DELAYS for c in (_some_wall(late), _no_wall(late)))


def _some_wall(late: Expr) -> Proposition:
    return Exists((alpha, beta), And((passive(), Not((letter(d),)))).at(DRAWN | {d: late}))


def _no_wall(late: Expr) -> Proposition:
    return ForAll((alpha, beta), Not((letter(late).at(FREE),)))


@cache
def drawn_otherwise() -> Theorem:
    """The spring bounds the stiffness of stable walls, and the walls of the figures exceed it."""
    found = []
    for late in DELAYS:
        point = DRAWN | STIFF | {d: late}
        stiff = number(Relation(point[gamma], "<=", point[alpha]))
        there = conj(met(point, *_in_terms(late)), _beyond(point, stiff))
        found.append(exists(there, _some_wall(late), STIFF))
        free = {alpha: alpha, beta: beta, **FREE, d: late}
        found.append(gen(_beyond(free, number(Relation(S.Zero, "<=", S.Zero))), alpha, beta))
    return conj(*found)


def _beyond(point: Mapping[Symbol, Expr], denial: Theorem) -> Theorem:
    """Taken literally, (18) is not stable, because a necessary condition fails."""
    values = {s: point[s] for s in (alpha, beta, gamma, delta)}
    values |= {p: S.Zero, q: 1 / (2 * point[d]) - 1}
    stable = letter(EVEN).at(values)
    given = [fact(proposition(c).at(values)) for c in GIVEN[:-1]]
    within = at(within_the_spring(), values, *given, assume(stable))
    return not_intro(within, not_all(within.conclusion, denial), stable)


def _in_terms(late: Expr) -> list[Any]:
    """The terms of the margin of the stiff wall, in hundredths, with x = cos(late omega).

    For half a period the margin is 1 + (1 - x), for a quarter 1 + (1 - x) + 1/(4 x).
    """
    slow, share = late * omega, STIFF[alpha]
    x = cos(slow)
    falls = positive(1 - x >= 0, [HALF, square(1 - x)], [HALF, bounded(cos, slow)])
    terms: list[Any] = [[share], [share, falls]]
    if late == HALF / 2:
        low = positive(slow > -pi / 2, [late, omega > 0], [HALF, PI])
        high = positive(slow < pi / 2, [late, omega < pi], [late, PI])
        along = closed(sign_of(cos, slow), low, high)
        quarter = closed(over(1 / x > 0, one(), along), positive(Ne(x, 0), [along]))
        terms.append([share / 4, quarter])
    return terms
