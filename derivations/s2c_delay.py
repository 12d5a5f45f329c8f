"""What does a delay do to the loop, and must it be an integer number of periods?

Reading the position, computing the force and driving the motor each cause a delay. We ask whether
only their sum matters, and whether $z^{-d}$ is right for a delay that is not a multiple of the
sampling period.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.sampled import late_answer, lumped
from symhaptic.book.lemmas.sampled_points import FREE, completed, shown_at
from symhaptic.model.plant import normalised, sampled
from symhaptic.notation import d_1, d_2, function
from symhaptic.notation.proposition import TRUE
from symhaptic.proof.theorems.roots import degree


def derive(page):
    P, H = function("P")(z), function("H")(z)
    page.say(
        "Let $P(z)$ be the sampled device. The wall receives the position with a delay of $d_1$ "
        "periods, and its force reaches the device with a further delay of $d_2$ periods."
    )
    loop = P / (1 + P * z ** (-d_2) * H * z ** (-d_1))
    page.step(
        "Two delays act on the loop as their sum",
        loop,
        P / (1 + P * H * z ** (-(d_1 + d_2))),
        because="in a linear loop powers of $z$ commute with all other factors, and their "
        "exponents add up",
    )
    page.say(
        "A delay between hold and sampler commutes with the device. The same therefore holds if "
        "this delay is any real number of periods. The denominator is the characteristic "
        "polynomial, and it depends on the sum only. A delay of the external force would change "
        "the numerator only."
    )
    claim = page.claim("s2c-delays-lump")
    page.lemma(
        "Delays before the device, after the device and in the computation act as their sum",
        lumped(claim),
        because=r"a force that is delayed by an integer number of periods is $z^{-\ell}$ times the "
        "force, and the response of the device is unique",
    )
    point = FREE | {d: S(2), d_1: S.Half, d_2: S.Half, l: S.One, z: S(4)}
    page.settle(
        "s2c-delays-lump",
        lumped(claim),
        example=shown_at(claim, point),
        note="the delays of device and sensor may be fractional; those of the computation are "
        "integers",
    )
    _not_negative(page)
    page.say(
        r"Now consider the free mass, $\gamma=\delta=0$, in units of $m$ and $T$. A unit force is "
        r"held for "
        "one period and arrives with a delay of $d<1$ periods. Where is the mass at the next "
        "sample?"
    )
    free = normalised(Parts(stiffness=False, damping=False))
    late = page.step(
        "A force that is delayed by less than a period changes the next sample",
        free.held(1 - d)[0],
        (1 - d) ** 2 / 2,
        name="x_1",
        because="the force has acted for the time $1-d$ only",
    )
    undelayed = sampled(free)
    page.step(
        "An integer delay changes none of the samples",
        late.subs(d, 0),
        undelayed.n1,
        name="x_1|_{d=0}",
        because="an integer delay shifts the samples and does not change their values",
    )
    page.say(
        r"The model $z^{-d}P(z)$ predicts no motion at the next sample. For $d=\tfrac12$ the "
        r"mass has moved by $\tfrac18$. So $z^{-d}$ is exact for integer delays only. For other "
        "delays, the substitution $z=w^q$ gives a polynomial and is an approximation, as the "
        "paper says. The function $P(w^q)$ is not the device sampled $q$ times as often. It "
        "describes $q$ copies of the slow device, coupled by the delay."
    )
    page.lemma(
        "For integer delays $z^{-d}$ is exact, for every device",
        late_answer(),
        because="a force that is delayed by an integer number of periods is $z^{-d}$ times the "
        "force",
    )
    _rational(page)


def _rational(page):
    """The substitution gives integer exponents, and is an approximation."""
    polynomial, some = page.claim("s2c-rational-delay").of
    symbols, given, has = taken_apart(polynomial)
    found = degree(has.of[0], has.over[0], has.of[1])
    known = [assume(part) for part in given]
    open_ = found.hypotheses.difference(given)
    steps = [is_whole(h.of[0], *known) if isinstance(h, Predicate) else fact(h) for h in open_]
    found = page.lemma(
        "With $z=w^{q+1}$ the polynomial of the loop has integer exponents", closed(found, *steps)
    )
    late = FREE | {d: S.Half, z: S(4)}
    values, answers = completed(every(some.over, some.body.of[:-1], TRUE), late)
    there = [p.at(values) for p in some.body.of]
    shown = [*answers, *(fact(p) for p in there if isinstance(p, Relation))]
    apart = closed(conj(*map(assume, there)), *shown)
    page.settle(
        "s2c-rational-delay",
        conj(for_all(symbols, given, found), exists(apart, some, values)),
        note="with a delay of half a period, the response of a free mass at $z=4$ is "
        r"$\tfrac{41}{288}$ and not $\tfrac12\cdot\tfrac5{18}$; for fractional delays the modified "
        r"z-transform is exact (\texttt{fractional-polynomial})",
    )


def _not_negative(page):
    """The delay may be zero."""
    given, period = [t_d >= 0, T > 0], positive(Ne(T, 0), T > 0)
    page.settle(
        "s2c-positive-delay",
        for_all((t_d, T), given, closed(over(t_d / T >= 0, *given), period)),
        example={t_d: S.Zero, T: S.One},
        note="the delay may also be zero, as in Fig. 7",
    )
