r"""How do the inequalities grow with the delay?

The criterion of \chapter{s4d_jury} is applied to the loop, with the device's numbers $n_1$, $n_0$,
$a$ and $e$ left as symbols. Which of its inequalities form the boundary of the stable region, is
any of them idle, and how large do they become?
"""

from itertools import combinations

from sympy import Mul, Rational, S, symbols

from symhaptic.book.lemmas.jury_inequalities import decided_by_jury, jury_decides
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.model import jury, plant
from symhaptic.model.parts import Parts
from symhaptic.model.plant import Sampled
from symhaptic.notation import a, alpha, beta, e, n_0, n_1, z
from symhaptic.proof.sign import number

FREE = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
HEAVY = Sampled(Rational(17, 100), Rational(4, 100), Rational(101, 100), Rational(1, 100))
"""About a mass with delta = 4.6."""

HEAD = ["$d$", "inequalities", "half planes", "terms", "degree in $\\alpha$", "in $\\beta$"]


def derive(page):
    page.say("Without delay, $n=3$, there are three half planes and one minor, for any device:")
    page.result(
        "Without delay a wall is stable if and only if",
        (
            1 - a + e + (n_1 + n_0) * alpha > 0,
            3 - a - e + (n_1 - n_0) * alpha + 2 * (n_1 + n_0) * beta > 0,
            1 + a + e - (n_1 - n_0) * (alpha + 2 * beta) > 0,
            1 - e + (n_1 - n_0 + a * n_0) * beta
            - n_0 * (n_1 + n_0) * beta**2 - n_0 * alpha * (1 + n_1 * beta) > 0,
        ),
        equal_to=jury.inequalities(0),
    )  # fmt: skip
    page.lemma(
        "Without delay four inequalities say which walls are stable",
        by_inequalities(0),
        because="for the numbers of any device; so it is with each whole delay",
    )
    none_is_idle(page)
    page.say(
        "The function \\texttt{jury} and the command \\texttt{symhaptic jury} give the "
        "inequalities for every whole delay, with the device's numbers as symbols or in numbers."
    )
    page.state(
        "jury-inequalities",
        "a wall is stable if and only if all inequalities of \\texttt{jury} hold, for $d=0$, 1 "
        "and 2 and the numbers of any device",
        claim=decided_by_jury(),
    )
    page.settle(
        "jury-inequalities",
        jury_decides(),
        note="for longer delays they are made in the same way and compared with roots in tests",
    )
    page.say("With delay there are $d+4$ inequalities, and they grow:")
    page.table(
        "The inequalities in $\\alpha$, $\\beta$ and the device's four numbers: how many, how many "
        "of them are half planes of the $(\\alpha,\\beta)$-plane; terms and degrees of the largest "
        "one, and its terms for a free mass.",
        [*HEAD, "free mass"],
        [row(delay) for delay in range(9)],
    )

    page.say("The largest one has a meaning. For roots $r_1,\\ldots,r_n$ of a monic polynomial:")
    pairs(page)
    page.say(
        "It is so for every $n$. Up to a positive number the last minor is the resultant of $F$ "
        "and $G$. That is zero where they share a root $x$, where $p(z)=p(1/z)=0$, so it has every "
        "factor $1-r_ir_k$; the degrees agree, and both sides are 1 for $z^n$. On the way out of "
        "the stable region \\emph{only $p(1)$, $p(-1)$ and the last minor can be the first to "
        "vanish}: a root leaves at 1, at $-1$ or with its conjugate, $r\\bar r=1$. The others tell "
        "the region from places with an even number of roots outside."
    )


def none_is_idle(page):
    """Four walls, each of which violates one inequality and no other."""
    walls = ((FREE, -1, 1), (FREE, 25, -4), (HEAVY, 1, 8), (FREE, 5, 1))
    for violated, (device, stiffness, damping) in enumerate(walls):
        found = jury.criterion(jury.coefficients(0, device)).expressions
        for i, expr in enumerate(found):
            value = expr.subs({alpha: stiffness, beta: damping})
            number(-value if i == violated else value)
    page.say(
        "None of the four can be left out. The first, second and last are each violated alone by a "
        "free mass ($n_1=n_0=\\tfrac12$, $a=2$, $e=1$), with the walls $(\\alpha,\\beta)=(-1,1)$, "
        "$(25,-4)$ and $(5,1)$. The third is violated alone by the wall $(1,8)$ at $n_1=0.17$, "
        "$n_0=0.04$, $a=1.01$, $e=0.01$, which are about the numbers of a device with "
        "$\\delta=4.6$."
    )


def pairs(page):
    """The last minor is the product of 1 - r_i r_k."""
    for n in (2, 4, 5, 3):
        roots = symbols(f"r_1:{n + 1}")
        product = Mul(*(1 - one * two for one, two in combinations(roots, 2)))
        falling = Mul(*(z - r for r in roots)).as_poly(z).all_coeffs()
        proof = page.same("pairs", jury.criterion(falling).expressions[-1], product)
    a_0, a_1, a_2 = symbols("a_0:3")
    minor = 1 - a_1 + a_0 * a_2 - a_0**2
    page.same("last minor", jury.criterion([S.One, a_2, a_1, a_0]).expressions[-1], minor)
    page.show("For degree 3 the last minor is a product over the roots", minor, product, proof)


def row(delay):
    """One line of the table."""
    found = jury.criterion(jury.coefficients(delay))
    free = jury.criterion(jury.coefficients(delay, FREE))
    planes = sum(all(i + k <= 1 for i, k, *_ in p.monoms()) for p in found.polynomials)
    degrees = [found.degree(symbol) for symbol in (alpha, beta)]
    return [delay, len(found.polynomials), planes, found.terms, *degrees, free.terms]
