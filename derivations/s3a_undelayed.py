r"""What is left of the passivity condition without delay?

Without delay the kernel of the condition is a constant, and one cosine is left. The paper sums the
condition up for all frequencies at once; on the border, and for walls that pull, the summary says
something else.
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
    form, same = taken_apart(page.claim("s3a-undelayed"))[2].of
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
        whole,
        UNDELAYED,
        example=(easy, off),
        unless={OFF_BORDER: (border, sides, broken(And((form, same))))},
        shows=r"(5) holds at every frequency, (6) says $\tfrac32>\tfrac32$",
        note="the form for $d=0$ is right for all values; its summary (6) needs the condition",
    )
    both = taken_apart(page.claim("eq6"))[2]
    page.lemma("The summary makes a wall passive that does not pull", passive())
    deciding = page.lemma(
        "The summary is what passive walls without delay meet, but for those on the border",
        decides(),
        because="what holds at every angle holds weakly of its limits at $0$ and $\\pi$",
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
        note="with $\\ge$ it is the passive walls with $K\\ge0$, those on the border as well",
    )
    upper_part(page)


def upper_part(page):
    """(6) for walls that damp."""
    found = page.lemma("For $B\\ge0$ the summary (6) is $b>\\frac{KT}2+B$", damped_side())
    page.settle(
        "s3c-upper-part",
        found,
        example={K: S.One, B: S.One, b: S(2), T: S.One},
        note="the condition that (5) becomes at the frequency of the largest damping "
        "(\\texttt{s3c-bmax-frequency}); the lower part, for $B<0$, is $b>\\frac{KT}2-B$",
    )
