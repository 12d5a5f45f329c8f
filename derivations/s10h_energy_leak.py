r"""How much energy does a sampled spring deliver?

Textbooks explain the limit $K\le2b/T$ by energy: a spring with a held force delivers some energy
in every period, and the damper has to dissipate it. We check the numbers in this explanation, and
its prediction for a delay.
"""

from symhaptic.book.lemmas.linear_part import passive_below
from symhaptic.book.lemmas.motions import HALF_LATE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import limits
from symhaptic.rules.other_loops import UNDAMPED

LEAK, DELAY = "rules:energy-leak", "rules:delay-damping"


def derive(page):
    page.say(
        "A device with the speed $v$ moves by $vT$ in a period. The spring force belongs to the "
        "position $x$ at the start of the period, or to the previous sample if the force is "
        "delayed by a period. On the way into the wall the user does less work than the spring "
        "stores:"
    )
    page.step(
        "In a period the held spring force delivers half of $K(vT)^2$",
        K * ((x + v * T) ** 2 - x**2) / 2 - K * x * v * T,
        K * (v * T) ** 2 / 2,
        name=r"E_{\text{hold}}",
    )
    page.step(
        "Each period of delay adds twice the energy that the held force delivers",
        K * x * v * T - K * (x - v * T) * v * T,
        K * (v * T) ** 2,
        name=r"E_{\text{delay}}",
    )
    page.say(
        "In the same time the damper dissipates $bv^2T$. The spring delivers $KT/(2b)$ times "
        r"this energy. The ratio $KT/(2b)$ is the one in the limit $K\le2b/T$."
    )
    page.say(
        "On the way out the spring delivers more than it stored, by the same amount. This "
        "calculation assumes constant speed. It remains to show that no other motion gains more "
        "energy."
    )
    then = taken_apart(page.claim(DELAY))[2]
    rule, passive = then.of
    found = page.lemma(
        "With an integer delay a spring is passive if and only if the damper dissipates the energy "
        "delivered at constant speed",
        behind_a_delay(rule),
        because="for a wall without virtual damping, the condition is strictest at low frequencies",
        boxed=True,
    )
    late = {K: S.One, b: Rational(101, 100), T: S.One, d: S.Half}
    alike, gained = then.at(late), gains(list(passive.at(late).of), HALF_LATE)
    denied = not_intro(mp(assume(alike), number(rule.at(late))), gained, alike)
    page.settle(
        DELAY,
        found,
        example=late | {b: S(2), d: S.One},
        unless={whole(d): (late, denied)},
        shows=r"with a delay of half a period, $b=\tfrac{101}{100}$ and $T=1$, the spring $K=1$ "
        "meets the rule and delivers energy",
        note="the rule is exact for integer delays without virtual damping; for a fractional "
        "delay, use the next integer",
    )
    rule = taken_apart(page.claim(LEAK))[2].of[0]
    found = page.lemma(
        "Without delay a spring is passive if and only if the ratio $KT/(2b)$ is at most one",
        without_delay(rule),
    )
    late = {K: S.One, b: Rational(3, 4), T: S.One, d: S.One}
    page.settle(
        LEAK,
        found,
        example=late | {d: S.Zero},
        unless={Eq(d, 0): (late, differs(rule, late))},
        shows=r"with a delay of one period, $b=\tfrac34$ and $T=1$, the spring $K=1$ has the "
        r"ratio $\tfrac23$ and delivers energy",
        note="the rule is exact without delay and virtual damping; a delay of $d$ periods "
        "multiplies the delivered energy by $2d+1$",
    )


# A spring is passive if and only if the damper dissipates what hold and delay add.

HERE = Given(T > 0, b > 0, d >= 0, K >= 0, whole(d))


@cache
def behind_a_delay(rule: Any) -> Theorem:
    """passive <=> the rule, for B = 0 and integer delays."""
    rule, still = proposition(rule), {B: S.Zero}
    room = show(b + B - K * T * (d + HALF) >= 0, assume(b - K * T * (d + HALF) >= 0), Eq(B, 0))
    enough = inst(passive_below(room), still)
    enough = HERE.closed(enough, HERE.show(b - K * T * (d + HALF) >= 0, rule))
    needed = show(rule, inst(limits()[1], still))
    return HERE.closed(either_way(enough, needed, rule, UNDAMPED))


@cache
def without_delay(rule: Any) -> Theorem:
    """passive <=> K T/(2 b) <= 1, without delay."""
    place, zero = Symbol("q"), show(Eq(S.Zero, d), Eq(d, 0))
    exact = behind_a_delay(b >= K * T / 2 + K * d * T)
    here = HERE.and_(Eq(d, 0))
    here.have(1 / b > 0)
    plain = exact.conclusion.of[0]  # type: ignore[attr-defined]
    rule = proposition(rule)
    there = mp(exact, here.show(plain, rule))
    found = either_way(there, here.show(rule, mp(exact, assume(UNDAMPED))), rule, UNDAMPED)
    at_once = subst(whole(place), place, fact(whole(0)), zero)
    return closed(here.closed(found), at_once)


def differs(rule: Any, point: Mapping[Any, Any]) -> Theorem:
    """The rule and passivity disagree for one wall with an integer delay."""
    exact = inst(behind_a_delay(b >= K * T / 2 + K * d * T), point)
    exact = closed(exact, *map(fact, exact.hypotheses))
    bound, passive = exact.conclusion.of  # type: ignore[attr-defined]
    denial = not_intro(mp(exact, assume(passive)), number(negated(bound)), passive)
    met = number(proposition(rule).at(point))
    same = Iff((met.conclusion, passive))
    return not_intro(mp(assume(same), met), denial, same)
