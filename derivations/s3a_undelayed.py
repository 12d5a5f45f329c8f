"""What is the passivity condition without delay?

Without delay the kernel of the condition is constant, and one cosine remains. The paper replaces
the condition at all frequencies by one inequality (6). We compare (5) and (6) at equality and for
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
from symhaptic.paper.propositions.passivity import SIX, UNDELAYED


def derive(page):
    undelayed = page.step(
        r"Without delay the kernel is $\frac12$",
        passivity.dirichlet_form().subs(d, 0),
        K * T / 2 - B * cos(theta),
        name=r"\left.b_{\min}\right|_{d=0}",
    )
    page.step(
        r"For $B\ge0$ the required damping is at most $\frac{KT}2+B$",
        K * T / 2 + B - undelayed,
        2 * B * cos(theta / 2) ** 2,
        name=r"\tfrac{KT}{2}+B-b_{\min}",
        because=r"the difference is positive for $\theta<\pi$ and tends to 0 for $\theta\to\pi$",
    )
    form, same = taken_apart(page.claim("s3a-undelayed"))[2].of
    frequencies = same.of[0]
    sufficient = page.lemma("(6) implies (5) at every frequency", enough(frequencies))
    needed = page.lemma(
        r"(5) at every frequency implies (6) with $\ge$",
        weakly_needed(frequencies),
        because="the cosine comes arbitrarily close to 1 and to $-1$, and reaches neither",
    )
    page.say(
        "So $KT/2+|B|$ is the least upper bound of the required damping over the open interval. "
        r"For $B\ne0$ this bound is not attained: a wall with equality still satisfies (5) at "
        r"every frequency. The strict sign of (6) excludes this wall; with $\ge$ in place of "
        "$>$, (5) and (6) agree. A wall with negative $K$ can satisfy (5) and (6), but is not "
        "passive."
    )
    agree = off_the_border(frequencies, sufficient, needed)
    border = {K: S.One, B: S.One, b: Rational(3, 2), T: S.One}
    easy = {K: S.One, B: S.Zero, b: S.One, T: S.One}
    sides = none_of(
        OFF_BORDER.at(border), number(Relation(S.One, "!=", S.Zero)), identity(border[b], border[b])
    )
    met = on_the_border(frequencies.at(border))
    off = either(OFF_BORDER.at(easy), identity(S.Zero, S.Zero))

    def broken(whole_claim):
        """At equality (6) is not equivalent to (5)."""
        there = whole_claim.at(border)
        summed = conjunct(assume(there), same.at(border))
        return not_intro(mp(summed, met), not_six(border), there)

    whole = conj(undelayed_form(form), agree)
    page.settle(
        "s3a-undelayed",
        whole,
        UNDELAYED,
        example=(easy, off),
        unless={OFF_BORDER: (border, sides, broken(And((form, same))))},
        shows="the wall satisfies (5) at every frequency, but for this wall (6) is "
        r"$\tfrac32>\tfrac32$",
        note="the form of (5) for $d=0$ is valid for all values; (6) requires the condition",
    )
    both = taken_apart(page.claim("eq6"))[2]
    page.lemma(r"A wall with $K\ge0$ that meets (6) is passive", passive())
    deciding = page.lemma(
        r"Without delay every passive wall meets (6) with $\ge$ in place of $>$",
        decides(),
        because=r"a strict inequality at every angle holds with $\ge$ in the limits at $0$ and "
        r"$\pi$",
    )
    off = closed(agree, either(OFF_BORDER, assume(APART)))
    pulled = {K: -S.One, B: S.Zero, b: S.One, T: S.One}
    meets = number(Relation(-HALF, "<", S.One))
    pulls = gains([*pulled.values(), S.Zero], 4 * [(1, 1)])
    there = both.at(pulled)
    runs = not_intro(mp(conjunct(assume(there), there.of[1]), meets), pulls, there)
    page.settle(
        "eq6",
        conj(off, deciding),
        SIX,
        example=easy,
        unless={K >= 0: (pulled, runs), APART: (border, broken(both))},
        shows="a spring with $K=-1$ meets (6), but four unit steps gain 2",
        note=r"with $\ge$, (6) describes the passive walls with $K\ge0$, including those with "
        "equality",
    )
    upper_part(page)


def upper_part(page):
    """(6) for walls with B >= 0."""
    found = page.lemma("For $B\\ge0$ the summary (6) is $b>\\frac{KT}2+B$", damped_side())
    page.settle(
        "s3c-upper-part",
        found,
        example={K: S.One, B: S.One, b: S(2), T: S.One},
        note="condition (5) has this form at the frequency of the largest damping "
        r"(\texttt{s3c-bmax-frequency}); for $B<0$ the summary (6) is $b>\frac{KT}2-B$",
    )
