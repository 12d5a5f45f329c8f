"""What is the passivity condition without delay?

Without delay the kernel of the condition is constant, and one cosine remains. The paper replaces
the condition at all frequencies by one inequality (6). We compare the two for equality and for
negative stiffness.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import (
    APART,
    OFF_BORDER,
    damped_side,
    decides,
    either,
    enough,
    not_six,
    off_the_border,
    on_the_border,
    passive,
    undelayed_form,
    weakly_needed,
)
from symhaptic.model import passivity
from symhaptic.paper.propositions.passivity import SIX, UNDELAYED
from symhaptic.proof.theorems.definitions import gains


def derive(page):
    undelayed = page.step(
        r"Without delay the kernel is $\frac12$",
        passivity.dirichlet_form().subs(d, 0),
        K * T / 2 - B * cos(theta),
        name=r"\left.\text{need}\right|_{d=0}",
    )
    page.step(
        r"For $B\ge0$ the required damping is at most $\frac{KT}2+B$",
        K * T / 2 + B - undelayed,
        2 * B * cos(theta / 2) ** 2,
        name=r"\tfrac{KT}{2}+B-\text{need}",
        because="tends to 0 for $\\theta\\to\\pi$ and is positive before",
    )
    claim = CLAIMED["s3a-undelayed"]((UNDELAYED,))
    symbols, loop, (form, same) = _parts(claim)
    frequencies = same.of[0]
    sufficient = page.lemma("(6) implies (5) at every frequency", enough(frequencies))
    needed = page.lemma(
        r"(5) at every frequency implies (6) with $\ge$",
        weakly_needed(frequencies),
        because="the cosine comes arbitrarily close to 1 and to $-1$, and reaches neither",
    )
    page.say(
        r"So $KT/2+|B|$ is the least upper bound over the open interval, and for $B\ne0$ it is "
        "not attained: a wall with equality still satisfies (5) at every frequency. The strict "
        r"sign of (6) excludes it; with $\ge$ in place of $>$ both agree. A negative $K$ can "
        "satisfy both conditions, but is not passive."
    )
    agree = off_the_border(frequencies, sufficient, needed)
    border = {K: S.One, B: S.One, b: Rational(3, 2), T: S.One}
    easy = {K: S.One, B: S.Zero, b: S.One, T: S.One}
    given = [*loop, OFF_BORDER]
    sides = none_of(
        OFF_BORDER.at(border), number(Relation(S.One, "!=", S.Zero)), identity(border[b], border[b])
    )
    met = on_the_border(frequencies.at(border))
    off = either(OFF_BORDER.at(easy), identity(S.Zero, S.Zero))

    def broken(whole_claim):
        """(6) does not sum up (5) on the border."""
        there = whole_claim.at(border)
        summed = conjunct(assume(there), same.at(border))
        return not_intro(mp(summed, met), not_six(border), there)

    whole = conj(undelayed_form(form), agree)
    page.settle(
        "s3a-undelayed",
        for_all(symbols, given, add_assum(whole, *loop)),
        UNDELAYED,
        example=example(easy, given, off),
        unless=[counterexample(claim, border, sides, broken(And((form, same))), but=OFF_BORDER)],
        shows=r"(5) holds at every frequency, (6) says $\tfrac32>\tfrac32$",
        note="the form for $d=0$ is right for all values; (6) needs the condition",
    )
    six = CLAIMED["eq6"]((SIX,))
    symbols, loop, both = taken_apart(six)
    page.lemma(r"A wall with $K\ge0$ that meets (6) is passive", passive())
    deciding = page.lemma(
        "Without delay every passive wall meets (6), except for equality",
        decides(),
        because=r"a strict inequality at every angle holds with $\ge$ in the limits at $0$ and "
        r"$\pi$",
    )
    off = closed(agree, either(OFF_BORDER, assume(APART)))
    given = [*loop, K >= 0, APART]
    pulled = {K: -S.One, B: S.Zero, b: S.One, T: S.One}
    meets = number(Relation(-HALF, "<", S.One))
    pulls = gains([*pulled.values(), S.Zero], 4 * [(1, 1)])
    there = both.at(pulled)
    runs = not_intro(mp(conjunct(assume(there), there.of[1]), meets), pulls, there)
    page.settle(
        "eq6",
        for_all(symbols, given, add_assum(conj(off, deciding), *loop)),
        SIX,
        example=example(easy, given),
        unless=[
            counterexample(six, pulled, runs, holds=[APART], but=K >= 0),
            counterexample(six, border, broken(both), holds=[K >= 0], but=APART),
        ],
        shows="a spring with $K=-1$ meets (6), but four unit steps gain 2",
        note=r"with $\ge$ it describes the passive walls with $K\ge0$, including those with "
        "equality",
    )
    upper_part(page)


def upper_part(page):
    """(6) for walls that damp."""
    symbols, given, _ = taken_apart(CLAIMED["s3c-upper-part"](()))
    found = page.lemma("For $B\\ge0$ the summary (6) is $b>\\frac{KT}2+B$", damped_side())
    page.settle(
        "s3c-upper-part",
        for_all(symbols, given, add_assum(found, *given)),
        example=example({K: S.One, B: S.One, b: S(2), T: S.One}, given),
        note="the condition that (5) becomes at the frequency of the largest damping "
        "(\\texttt{s3c-bmax-frequency}); the lower part, for $B<0$, is $b>\\frac{KT}2-B$",
    )


def _parts(claim):
    """A claim with the parts of its conclusion."""
    symbols, given, then = taken_apart(claim)
    return symbols, given, then.of
