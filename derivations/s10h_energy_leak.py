r"""What does a sampled spring give away?

Textbooks explain the limit $K\le2b/T$ by energy: a spring with a held force delivers some energy in
every period, and the damper has to dissipate it. We check the numbers of this explanation, and what
it predicts for a delay.
"""

from sympy import Eq, Rational, S

from symhaptic.book.lemmas.energy_leak import behind_a_delay, differs, without_delay
from symhaptic.book.lemmas.motions import HALF_LATE
from symhaptic.book.sources import CLAIMED, STATEMENTS
from symhaptic.notation import K, T, b, d, v, x
from symhaptic.notation.proposition import whole
from symhaptic.proof.theorems.definitions import gains
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import add_assum, assume, mp, not_intro
from symhaptic.proof.theorems.leaves import number
from symhaptic.proof.theorems.tactics import counterexample, example, for_all

LEAK, DELAY = "rules:energy-leak", "rules:delay-damping"


def derive(page):
    page.say(
        "A device with the speed $v$ moves by $vT$ in a period. The spring pushes with the force "
        "for the position $x$ at the start of the period, or for the previous sample if it is "
        "delayed by a period. On the way into the wall the user does less work than the spring "
        "stores:"
    )
    page.step(
        "In a period the spring gives away half of $K(vT)^2$",
        K * ((x + v * T) ** 2 - x**2) / 2 - K * x * v * T,
        K * (v * T) ** 2 / 2,
        name=r"E_{\text{hold}}",
    )
    page.step(
        "Each period of delay adds twice as much",
        K * x * v * T - K * (x - v * T) * v * T,
        K * (v * T) ** 2,
        name=r"E_{\text{delay}}",
    )
    page.say(
        "In the same time the damper dissipates $bv^2T$. The energy that the spring delivers is "
        "$KT/(2b)$ of this, which is the ratio in the rule."
    )
    page.say(
        "On the way out the spring delivers more than it stored, by the same amount. This "
        "calculation is for constant speed. It remains to show that no other motion gains more "
        "energy."
    )
    claim = CLAIMED[DELAY](STATEMENTS[DELAY].printed)
    symbols, given, then = taken_apart(claim)
    rule, passive = then.of
    found = page.lemma(
        "Behind a whole delay a spring is passive if and only if the damper bears the losses at "
        "constant speed",
        behind_a_delay(rule),
        because="low frequencies are the strictest for a wall without virtual damping",
        boxed=True,
    )
    extra = [*given, whole(d)]
    late = {K: S.One, b: Rational(101, 100), T: S.One, d: S.Half}
    at = passive.at(late)
    gained = gains(list(at.of), HALF_LATE)
    alike = then.at(late)
    page.settle(
        DELAY,
        for_all(symbols, extra, add_assum(found, *extra)),
        example=example(late | {b: S(2), d: S.One}, extra),
        unless=[
            counterexample(
                claim,
                late,
                not_intro(mp(assume(alike), number(rule.at(late))), gained, alike),
                but=whole(d),
            )
        ],
        shows="with a delay of half a period, $K=1$ meets the rule for $b=\\tfrac{101}{100}$, "
        "$T=1$ and delivers energy",
        note="exact for integer delays without virtual damping; round a fractional delay up",
    )
    claim = CLAIMED[LEAK](STATEMENTS[LEAK].printed)
    symbols, given, then = taken_apart(claim)
    rule, _ = then.of
    found = page.lemma(
        "Without delay a spring is passive if and only if the ratio is at most one",
        without_delay(rule),
    )
    extra = [*given, Eq(d, 0)]
    late = {K: S.One, b: Rational(3, 4), T: S.One, d: S.One}
    page.settle(
        LEAK,
        for_all(symbols, extra, add_assum(found, *extra)),
        example=example(late | {d: S.Zero}, extra),
        unless=[counterexample(claim, late, differs(rule, late), but=Eq(d, 0))],
        shows="with a delay of one period, $K=1$ with $b=\\tfrac34$, $T=1$ has the ratio "
        "$\\tfrac23$ and delivers energy",
        note="exact without delay and virtual damping; a delay by $d$ periods multiplies the loss "
        "by $2d+1$",
    )
