r"""How do the inequalities of Jury's criterion grow with the delay?

The criterion of \chapter{s4d_jury} is applied to the loop, with the device's coefficients $n_1$,
$n_0$, $a$ and $e$ left as symbols. We ask which inequalities form the boundary of the stable
region, whether one of them is redundant, and how large they become.
"""

from itertools import combinations

from sympy import Mul, sympify

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities, collected
from symhaptic.model import jury
from symhaptic.model.jury import jury as conditions_on

FREE = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
HEAVY = Sampled(Rational(17, 100), Rational(4, 100), Rational(101, 100), Rational(1, 100))
"""Approximately the coefficients of a mass with delta = 4.6."""

HEAD = ["$d$", "inequalities", "half planes", "terms", "degree in $\\alpha$", "in $\\beta$"]


def derive(page):
    page.say(
        "Without delay the degree is $n=3$, and there are three half planes and one minor for "
        "any device:"
    )
    found = page.lemma(
        "Without delay a wall is stable if and only if four inequalities hold",
        collected(
            by_inequalities(0),
            1 - a + e + (n_1 + n_0) * alpha > 0,
            3 - a - e + (n_1 - n_0) * alpha + 2 * (n_1 + n_0) * beta > 0,
            1 + a + e - (n_1 - n_0) * (alpha + 2 * beta) > 0,
            1
            - e
            + (n_1 - n_0 + a * n_0) * beta
            - n_0 * (n_1 + n_0) * beta**2
            - n_0 * alpha * (1 + n_1 * beta)
            > 0,
        ),
        because="the statement holds for any device; a corresponding theorem holds for each "
        "integer delay",
        boxed=True,
    )
    none_is_idle(page, found.conclusion.of[1])
    page.say(
        r"The function \texttt{jury} and the command \texttt{symhaptic jury} give the inequalities "
        "for every integer delay, with the device's coefficients as symbols or as numbers."
    )
    page.state(
        "jury-inequalities",
        "for any device and for $d=0$, 1 and 2 a wall is stable if and only if all inequalities of "
        r"\texttt{jury} hold",
        claim=decided_by_jury(),
    )
    page.settle(
        "jury-inequalities",
        jury_decides(),
        note="for longer delays the same program derives the inequalities, and tests compare "
        "them with computed roots",
    )
    page.say("With a delay there are $d+4$ inequalities, and the largest one grows with $d$:")
    page.table(
        r"Number of inequalities in $\alpha$, $\beta$ and the four coefficients of the device, "
        "number of half planes among them, terms and degrees of the largest inequality, and its "
        "terms for a free mass.",
        [*HEAD, "free mass"],
        [row(delay) for delay in range(9)],
    )

    page.say(
        r"The largest inequality has an interpretation. Let $r_1,\ldots,r_n$ be the roots of a "
        "monic polynomial. For degree 3 the last minor is a product over all pairs of roots:"
    )
    pairs(page)
    page.say(
        "The same holds for every $n$. Up to a positive factor the last minor is the resultant "
        "of $F$ and $G$. The resultant is zero if $F$ and $G$ share a root $x$, that is, if "
        "$p(z)=p(1/z)=0$. So the resultant has every factor $1-r_ir_k$. The degrees of the "
        "minor and of the product agree, and both are 1 for $z^n$. On a path out of the stable "
        r"region \emph{only $p(1)$, $p(-1)$ and the last minor can vanish first}: a root leaves "
        r"the unit circle at 1, at $-1$ or together with its conjugate, $r\bar r=1$. The other "
        "inequalities exclude walls with an even number of roots outside."
    )


def none_is_idle(page, four):
    """Four walls, each of which violates one inequality and no other."""
    free = "a free mass, $n_1=n_0=\\tfrac12$, $a=2$, $e=1$, and the wall "
    for place, (which, device, wall, because) in enumerate(
        (
            ("first", FREE, (-1, 1), free + "$(\\alpha,\\beta)=(-1,1)$"),
            ("second", FREE, (25, -4), free + "$(\\alpha,\\beta)=(25,-4)$"),
            (
                "third",
                HEAVY,
                (1, 8),
                "$n_1=0.17$, $n_0=0.04$, $a=1.01$, $e=0.01$, about the numbers of a device with "
                "$\\delta=4.6$, and the wall $(1,8)$",
            ),
            ("fourth", FREE, (5, 1), free + "$(\\alpha,\\beta)=(5,1)$"),
        )
    ):
        page.lemma(
            f"The {which} of the inequalities without delay can fail alone",
            fails_alone(four.parts, place, (device.n1, device.n0, device.a, device.e, *wall)),
            because=because,
        )
    page.say("So none of the four inequalities is redundant.")


def fails_alone(inequalities, place, numbers):
    """Some device and wall violate this inequality and no other."""
    values = dict(zip((*NUMBERS, alpha, beta), map(sympify, numbers), strict=True))
    claims = [negated(p) if i == place else p for i, p in enumerate(inequalities)]
    found = conj(*(fact(p.at(values)) for p in claims))
    return exists(found, Exists(tuple(values), And(tuple(claims))), values)


def pairs(page):
    """The last minor is the product of the factors 1 - r_i r_k."""
    for n in (2, 4, 5):
        roots = symbols(f"r_1:{n + 1}")
        product = Mul(*(1 - one * two for one, two in combinations(roots, 2)))
        falling = Mul(*(z - r for r in roots)).as_poly(z).all_coeffs()
        page.same("pairs", jury.criterion(falling).expressions[-1], product)
    one, two, three = symbols("r_1:4")
    by_roots = (-one * two * three, one * two + one * three + two * three, -one - two - three)
    rising = symbols("a_0:3")
    made = ((z - one) * (z - two) * (z - three)).expand()
    for power, (name, value) in enumerate(zip(rising, by_roots, strict=True)):
        page.step(
            f"The roots of a cubic give the coefficient of power {power}",
            made.coeff(z, power),
            value,
            name=name,
        )
    last, middle, first = rising
    page.step(
        "For degree 3 the last minor is a product over the roots",
        jury.criterion([S.One, first, middle, last]).expressions[-1],
        1 - middle + last * first - last**2,
        (1 - one * two) * (1 - one * three) * (1 - two * three),
        name=r"\Delta_2",
    )


def row(delay):
    """One row of the table."""
    found = jury.criterion(jury.coefficients(delay))
    free = jury.criterion(jury.coefficients(delay, FREE))
    planes = sum(all(i + k <= 1 for i, k, *_ in p.monoms()) for p in found.polynomials)
    degrees = [found.degree(symbol) for symbol in (alpha, beta)]
    return [delay, len(found.polynomials), planes, found.terms, *degrees, free.terms]


# The inequalities of ``symhaptic.jury`` are those of the criterion, and decide stability.

DELAYS = (0, 1, 2)
WALLS = (alpha, beta, gamma, delta, *NUMBERS)


def decided_by_jury() -> Proposition:
    """A wall is stable if and only if all inequalities of jury(d) hold, for d = 0, 1 and 2."""
    return both(every(WALLS, [DEVICE], Iff(_sides(n))) for n in DELAYS)


def _sides(delay: int) -> tuple[Proposition, Proposition]:
    return STABLE.at({d: sp.S(delay)}), both(conditions_on(delay))


@cache
def jury_decides() -> Theorem:
    return conj(*(for_all(WALLS, [DEVICE], add_assum(_same(n), DEVICE)) for n in DELAYS))


def _same(delay: int) -> Theorem:
    """Each polynomial is a positive multiple of one of the criterion's polynomials."""
    criterion = by_inequalities(delay)
    stable, wanted = _sides(delay)
    theirs: Any = criterion.conclusion.parts[1]
    inside = mp(criterion, assume(stable))
    there = conj(*(_scaled(p, [conjunct(inside, q) for q in theirs.parts]) for p in wanted.parts))
    known = [conjunct(assume(wanted), p) for p in wanted.parts]
    here = mp(criterion, conj(*(_scaled(q, known) for q in theirs.parts)))
    return either_way(there, here, stable, wanted)


def _scaled(claim: Any, known: list[Theorem]) -> Theorem:
    """A relation, from the known relation of which it is a multiple."""
    positive = proposition(claim)
    assert isinstance(positive, Relation)
    for theorem in known:
        share = sp.cancel(positive.right / theorem.conclusion.right)
        if share.is_Rational and share > 0:
            return combined(positive, [theorem, share])
    raise NotShown(f"{positive} is no multiple of what is known")
