r"""What is left of the passivity condition without delay?

Without delay the kernel of the condition is a constant, and one cosine is left. The paper sums the
condition up for all frequencies at once; on the border, and for walls that pull, the summary says
something else.
"""

from sympy import Abs, Eq, Ne, Rational, S, cos, pi

from symhaptic.book.lemmas.passivity import INSIDE, passive_by_angle
from symhaptic.model import passivity
from symhaptic.notation import B, K, T, b, d, omega, theta
from symhaptic.notation.proposition import Or, Relation, proposition
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.passivity import SIX, UNDELAYED
from symhaptic.proof.theorems.analysis import in_the_limit
from symhaptic.proof.theorems.definitions import gains
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import (
    absurd,
    applied,
    assume,
    by_cases,
    conjoined,
    cut,
    discharged,
    ordered,
    part,
    weakened,
    widened,
)
from symhaptic.proof.theorems.leaves import (
    bounded,
    combined,
    identity,
    magnitude,
    number,
    sign_of,
    square,
    strictly,
    tends,
)
from symhaptic.proof.theorems.tactics import (
    at,
    closed,
    counterexample,
    either_way,
    example,
    follows,
    for_all,
    none_of,
    over,
    positive,
)

HALF = S.Half
BORDER = K * T / 2 + Abs(B)
OFF_BORDER = Or((proposition(Eq(B, 0)), proposition(Ne(b, BORDER))))
PI = number(Relation(S.Zero, "<", pi))


def derive(page):
    undelayed = page.step(
        "Without delay the kernel is a half",
        passivity.dirichlet_form().subs(d, 0),
        K * T / 2 - B * cos(theta),
        name=r"\left.\text{need}\right|_{d=0}",
    )
    page.step(
        "Distance to the border, $B\\ge0$",
        K * T / 2 + B - undelayed,
        2 * B * cos(theta / 2) ** 2,
        name=r"\tfrac{KT}{2}+B-\text{need}",
        because="tends to 0 for $\\theta\\to\\pi$ and is positive before",
    )
    claim = CLAIMED["s3a-undelayed"]((UNDELAYED,))
    symbols, loop, same = taken_apart(claim)
    frequencies = same.of[0]
    enough = page.lemma("The summary (6) is enough at every frequency", _enough(frequencies))
    needed = page.lemma(
        "What holds at every frequency holds weakly on the border",
        _in_the_limit(frequencies),
        because="the cosine comes as close to 1 and to $-1$ as one likes, and reaches neither",
    )
    page.say(
        "So $KT/2+|B|$ is the least upper bound over the open interval, and for $B\\ne0$ it is "
        "not attained: a wall with $b$ exactly there still satisfies (5) at every frequency. The "
        "strict sign of (6) excludes it; with $\\ge$ in place of $>$ both would agree. And a "
        "negative $K$ satisfies either one without being passive."
    )
    agree = _off_border(frequencies, enough, needed)
    border = {K: S.One, B: S.One, b: Rational(3, 2), T: S.One}
    easy = {K: S.One, B: S.Zero, b: S.One, T: S.One}
    given = [*loop, OFF_BORDER]
    sides = none_of(
        OFF_BORDER.at(border), number(Relation(S.One, "!=", S.Zero)), identity(border[b], border[b])
    )
    met = _on_the_border(frequencies.at(border))
    broken = absurd(applied(assume(same.at(border)), met), *_not_six(border), same.at(border))
    off = _either(OFF_BORDER.at(easy), identity(S.Zero, S.Zero))
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
    passive = page.lemma("The summary makes a wall passive that does not pull", _passive())
    whole = conjoined(agree, discharged(passive, SIX))
    given = [*loop, K >= 0, OFF_BORDER]
    pulled = {K: -S.One, B: S.Zero, b: S.One, T: S.One}
    meets = number(Relation(-HALF, "<", S.One))
    pulls = gains([*pulled.values(), S.Zero], 4 * [(1, 1)])
    there = both.at(pulled)
    runs = absurd(applied(part(assume(there), there.of[1]), meets), pulls, there)
    there = both.at(border)
    apart = absurd(applied(part(assume(there), there.of[0]), met), *_not_six(border), there)
    page.settle(
        "eq6",
        for_all(symbols, given, weakened(whole, *loop)),
        SIX,
        example=example(easy, given, off),
        unless=[
            counterexample(
                six,
                pulled,
                *(runs, _either(OFF_BORDER.at(pulled), identity(S.Zero, S.Zero))),
                holds=[OFF_BORDER],
                but=K >= 0,
            ),
            counterexample(six, border, sides, apart, holds=[K >= 0], but=OFF_BORDER),
        ],
        shows="a spring with $K=-1$ meets (6), but four unit steps gain 2",
    )


def _cosine(angle):
    """0 <= 1 + cos and 0 <= 1 - cos."""
    size = bounded(cos, angle)
    return [
        combined(1 + way * cos(angle) >= 0, [HALF, square(1 + way * cos(angle))], [HALF, size])
        for way in (1, -1)
    ]


def _by_sign_of_damping(up, down):
    return by_cases(ordered(B, S.Zero), down, up)


def _enough(frequencies):
    angle = omega * T
    claim = frequencies.body.of[1]
    up, down = _cosine(angle)
    above = combined(claim, [assume(SIX)], [magnitude(B), -1], [assume(B >= 0), up])
    below = combined(
        claim, [assume(SIX)], [magnitude(B, negative=True), -1], [positive(-B >= 0, B < 0), down]
    )
    below = closed(below, positive(B <= 0, B < 0))
    return for_all([omega], frequencies.body.of[0].of, _by_sign_of_damping(above, below))


def _at_angle(frequencies):
    """The condition at an angle between 0 and pi."""
    angle = theta / T
    inside = over(angle > 0, theta > 0, T > 0), over(angle < pi / T, assume(theta < pi), T > 0)
    return closed(at(assume(frequencies), {omega: angle}, *inside), positive(Ne(T, 0), T > 0))


def _in_the_limit(frequencies):
    inside = _at_angle(frequencies)
    rest = b - (K * T / 2 - B * cos(theta))
    ends = [
        cut(in_the_limit(inside, theta, S.Zero, pi, tends(rest, theta, end, value)), PI)
        for end, value in ((pi, b - K * T / 2 - B), (S.Zero, b - K * T / 2 + B))
    ]
    above = combined(b >= BORDER, [ends[0]], [magnitude(B), 1])
    below = combined(b >= BORDER, [ends[1]], [magnitude(B, negative=True), 1])
    return _by_sign_of_damping(above, closed(below, positive(B <= 0, B < 0)))


def _off_border(frequencies, enough, needed):
    """(6) and the condition at every frequency, away from the border or without damping."""
    middle = at(assume(frequencies), {omega: pi / (2 * T)}, *_middle())
    none = assume(Eq(B, 0))
    calm = combined(SIX, [middle], [none, 1], [magnitude(B), 1])
    calm = closed(
        calm,
        combined(B >= 0, [none, -1]),
        positive(Ne(T, 0), T > 0),
        positive(Ne(2 * T, 0), [2, T > 0]),
    )
    apart = strictly(needed, assume(Ne(b, BORDER)))
    there = by_cases(assume(OFF_BORDER), calm, apart)
    return either_way(there, enough, frequencies, SIX)


def _middle():
    half = number(Relation(S.Zero, "<", pi / 2))
    return (
        over(pi / (2 * T) > 0, half, T > 0),
        over(pi / (2 * T) < pi / T, half, T > 0),
    )


def _passive():
    found = passive_by_angle(S.Zero)
    margin = passivity.margin().subs(d, 0)
    up, down = _cosine(theta)
    above = combined(margin >= 0, [assume(SIX)], [magnitude(B), -1], [assume(B >= 0), up])
    below = combined(
        margin >= 0,
        [assume(SIX)],
        [magnitude(B, negative=True), -1],
        [positive(-B >= 0, B < 0), down],
    )
    below = closed(below, positive(B <= 0, B < 0))
    always = for_all([theta], INSIDE, _by_sign_of_damping(above, below))
    return follows(found, assume(K >= 0), always)


def _on_the_border(frequencies):
    """1/2 - cos(omega) < 3/2 at every frequency."""
    half = closed(
        sign_of(cos, omega / 2),
        positive(omega / 2 > -pi / 2, [HALF, omega > 0], [HALF, PI]),
        positive(omega / 2 < pi / 2, [HALF, omega < pi]),
    )
    found = combined(frequencies.body.of[1], [2, half, half])
    return for_all([omega], frequencies.body.of[0].of, found)


def _not_six(point):
    """The border itself is no wall of (6)."""
    edge = (K * T / 2 + Abs(B)).subs(point)
    return (identity(edge, point[b]),)


def _either(claim, theorem):
    return widened(theorem, claim)
