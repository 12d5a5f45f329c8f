r"""What is left of the passivity condition without delay?

Without delay the kernel of the condition is a constant, and one cosine is left. The paper sums the
condition up for all frequencies at once; on the border, and for walls that pull, the summary says
something else.
"""

from sympy import Rational, S, cos

from symhaptic.book.lemmas.undelayed import (
    HALF,
    OFF_BORDER,
    either,
    enough,
    not_six,
    off_the_border,
    on_the_border,
    passive,
    weakly_needed,
)
from symhaptic.model import passivity
from symhaptic.notation import B, K, T, b, d, theta
from symhaptic.notation.proposition import Relation
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.passivity import SIX, UNDELAYED
from symhaptic.proof.theorems.definitions import gains
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import (
    absurd,
    applied,
    assume,
    conjoined,
    discharged,
    part,
    weakened,
)
from symhaptic.proof.theorems.leaves import identity, number
from symhaptic.proof.theorems.tactics import (
    counterexample,
    example,
    for_all,
    none_of,
)


def derive(page):
    undelayed = page.step(
        "Without delay the kernel is a half",
        passivity.dirichlet_form().subs(d, 0),
        K * T / 2 - B * cos(theta),
        name=r"\left.\text{need}\right|_{d=0}",
    )
    page.step(
        "For $B\\ge0$ no angle needs more than the border",
        K * T / 2 + B - undelayed,
        2 * B * cos(theta / 2) ** 2,
        name=r"\tfrac{KT}{2}+B-\text{need}",
        because="tends to 0 for $\\theta\\to\\pi$ and is positive before",
    )
    claim = CLAIMED["s3a-undelayed"]((UNDELAYED,))
    symbols, loop, same = taken_apart(claim)
    frequencies = same.of[0]
    sufficient = page.lemma("The summary (6) is enough at every frequency", enough(frequencies))
    needed = page.lemma(
        "What holds at every frequency holds weakly on the border",
        weakly_needed(frequencies),
        because="the cosine comes as close to 1 and to $-1$ as one likes, and reaches neither",
    )
    page.say(
        "So $KT/2+|B|$ is the least upper bound over the open interval, and for $B\\ne0$ it is "
        "not attained: a wall with $b$ exactly there still satisfies (5) at every frequency. The "
        "strict sign of (6) excludes it; with $\\ge$ in place of $>$ both would agree. And a "
        "negative $K$ satisfies either one without being passive."
    )
    agree = off_the_border(frequencies, sufficient, needed)
    border = {K: S.One, B: S.One, b: Rational(3, 2), T: S.One}
    easy = {K: S.One, B: S.Zero, b: S.One, T: S.One}
    given = [*loop, OFF_BORDER]
    sides = none_of(
        OFF_BORDER.at(border), number(Relation(S.One, "!=", S.Zero)), identity(border[b], border[b])
    )
    met = on_the_border(frequencies.at(border))
    broken = absurd(applied(assume(same.at(border)), met), not_six(border), same.at(border))
    off = either(OFF_BORDER.at(easy), identity(S.Zero, S.Zero))
    page.settle(
        "s3a-undelayed",
        for_all(symbols, given, weakened(agree, *loop)),
        UNDELAYED,
        example=example(easy, given, off),
        unless=[counterexample(claim, border, sides, broken, but=OFF_BORDER)],
        shows=r"(5) holds at every frequency, (6) says $\tfrac32>\tfrac32$",
        note="the form for $d=0$ is right for all values; its summary (6) needs the condition",
    )
    six = CLAIMED["eq6"]((SIX,))
    symbols, loop, both = taken_apart(six)
    safe = page.lemma("The summary makes a wall passive that does not pull", passive())
    whole = conjoined(agree, discharged(safe, SIX))
    given = [*loop, K >= 0, OFF_BORDER]
    pulled = {K: -S.One, B: S.Zero, b: S.One, T: S.One}
    meets = number(Relation(-HALF, "<", S.One))
    pulls = gains([*pulled.values(), S.Zero], 4 * [(1, 1)])
    there = both.at(pulled)
    runs = absurd(applied(part(assume(there), there.of[1]), meets), pulls, there)
    there = both.at(border)
    apart = absurd(applied(part(assume(there), there.of[0]), met), not_six(border), there)
    page.settle(
        "eq6",
        for_all(symbols, given, weakened(whole, *loop)),
        SIX,
        example=example(easy, given, off),
        unless=[
            counterexample(
                six,
                pulled,
                *(runs, either(OFF_BORDER.at(pulled), identity(S.Zero, S.Zero))),
                holds=[OFF_BORDER],
                but=K >= 0,
            ),
            counterexample(six, border, sides, apart, holds=[K >= 0], but=OFF_BORDER),
        ],
        shows="a spring with $K=-1$ meets (6), but four unit steps gain 2",
    )
