"""The sampled device in entire functions, without a delay and with a fractional delay."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_forms import Block, Later, Named, nonzero
from symhaptic.forms import fractional_delay, stable
from symhaptic.forms.device_forms import device_of, made_of
from symhaptic.forms.entire import written_out
from symhaptic.forms.fractional_delay import Brief
from symhaptic.forms.response import closed
from symhaptic.model import loop

DELAY = 2
"""Forms that are made for one integer delay are shown for this one."""
SPRING = (delta**2 - c**2) / 4
"""gamma, of the difference c of the poles."""
h, h_1, h_2, v, v_1, p_2 = symbols("h h_1 h_2 v v_1 p_2")
"""The way by a unit impulse, and the speed that is left of a unit speed, of a whole period and of
its parts."""
RISE, FALL = (c - delta) / 2, -(c + delta) / 2


def impulse(time: Expr) -> Expr:
    """How far a unit impulse moves the device."""
    return (exp(RISE * time) - exp(FALL * time)) / c


def pushed(time: Expr) -> Expr:
    """How far a unit force that is held moves it."""
    return ((exp(RISE * time) - 1) / RISE - (exp(FALL * time) - 1) / FALL) / c


def kept(time: Expr, way: Expr) -> Expr:
    """What is left of a unit speed."""
    return exp(RISE * time) + FALL * way


BY_TRANSITION = (
    (gamma, SPRING),
    (h, impulse(S.One)),
    (v, kept(S.One, h)),
    (n_1, pushed(S.One)),
    (n_0, h**2 - v * n_1),
    (a, 2 * exp(RISE) - c * h),
    (e, exp(-delta)),
)
"""The numbers of the device, by the transition matrix."""
DERIVED = made_of(Sampled(n_1, n_0, a, e))
EXACT = (*DERIVED.numbers, h)
APART = tuple(map(proposition, (Ne(c, 0), Ne(gamma, 0), Ne(delta, 0))))
POINT = {c: S.One, delta: S(3)}


def in_poles(expr: Expr) -> Expr:
    """A computed formula, written out, with c for the root."""
    return written_out(expr).subs(sqrt(delta**2 - 4 * gamma), c)


@cache
def computed() -> tuple[Expr, ...]:
    """The numbers and the impulse, as they are computed."""
    kick = fractional_delay.brief(FULL, S.One).kick
    return tuple(map(in_poles, (*device_of(FULL).numbers, kick)))


def spring_there() -> Theorem:
    """(delta^2 - c^2)/4 != 0."""
    equal = assume(Eq(gamma, SPRING))
    return combined(Ne(SPRING, 0), [assume(Ne(gamma, 0))], [equal, -1])


def _poles() -> list[Theorem]:
    """No pole is zero, where there is a spring."""
    spring = spring_there()
    return [spring, *(nonzero(x, spring) for x in (RISE, FALL, -FALL))]


def device_block(*which: int, polynomial: bool = False) -> Block:
    """Numbers of the device, by their places in ``Device.numbers``; the impulse is the last."""
    more = (_polynomial(),) if polynomial else ()
    pairs = tuple(Relation(computed()[i], "=", EXACT[i]) for i in which)
    free = (c, delta, *((alpha, beta, z) if more else ()))
    point = POINT | ({alpha: S.One, beta: S.One, z: S(2)} if more else {})
    where = APART if 8 in which else APART[:2]
    return Block(free, where, BY_TRANSITION, (*pairs, *more), point, _poles)


def _polynomial() -> Relation:
    """The sum of the computed coefficients, and the polynomial of the loop."""
    form = stable.form("characteristic_polynomial", FULL, DELAY)
    powers = range(len(form.results) - 1, -1, -1)
    known = dict(zip(device_of(FULL).numbers, DERIVED.numbers, strict=True))
    terms = (x.xreplace(known) * z**n for n, (_, x) in zip(powers, form.results, strict=True))
    return Relation(sp.Add(*terms), "=", loop.named().subs(d, DELAY))


REST, PART = 1 - epsilon, epsilon
"""The rest of a period, and its beginning."""
k_1, k_2, x_1, x_2, y_1, y_2, g_1, g_2 = symbols("k_1 k_2 x_1 x_2 y_1 y_2 g_1 g_2")
"""What an impulse and a held force do in the rest, and in the beginning: the ways, and n_0."""


def _part_of_period(time: Expr, x: Symbol, y: Symbol, g: Symbol, k: Symbol) -> tuple[Brief, Named]:
    """What is computed of a part of a period: its numbers as names, and what they stand for."""
    known = fractional_delay.brief(FULL, time)
    ours = known.rise, known.fall, known.apart, known.kick
    names = tuple(zip((x, y, g, k), map(in_parts, ours), strict=True))
    return Brief(x, y, g, k, S.Zero, written_out(known.loss)), names


def in_parts(expr: Expr) -> Expr:
    """A computed formula of a part of the period, written out; the part's root is c times it."""
    found = written_out(expr)
    for time in (REST, PART):
        found = found.subs(sqrt((delta * time) ** 2 - 4 * gamma * time**2), c * time)
    return found


AFTER = (
    (h_1, impulse(REST)),
    (v_1, kept(REST, h_1)),
    (h_2, impulse(PART)),
    (m_2, pushed(REST)),
    (p_2, pushed(PART)),
    (m_1, h * h_1 - v * m_2 + (v_1 + delta * h_1) * p_2 + h_1 * h_2),
    (m_0, h * (v_1 * h_2 - gamma * h_1 * p_2) - v * ((v_1 + delta * h_1) * p_2 + h_1 * h_2)),
)
"""The numbers of the late device: the force before, then the new one, and the transition."""


def _late() -> Block:
    """What is made of the two parts of a period beside the late force."""
    first, first_names = _part_of_period(REST, x_1, y_1, g_1, k_1)
    last, last_names = _part_of_period(PART, x_2, y_2, g_2, k_2)
    fallen = exp(-delta * REST) * last.fall
    ours = (
        first.rise,
        fallen,
        n_1 + n_0,
        closed(fractional_delay.at_minus_one(FULL, first, last)),
        computed()[7] - (first.rise + fallen),
        fractional_delay.across(FULL, first, n_1 + n_0, n_1 - n_0, computed()[6], h),
        written_out(fractional_delay.half_turned(FULL)),
    )
    at_minus_one = m_2 - m_1 + m_0
    exact = m_2, m_0, m_2 + m_1 + m_0, at_minus_one, m_1, 2 * (m_2 - m_0), at_minus_one
    where = (*APART, *map(proposition, (Ne(epsilon, 0), Ne(epsilon, 1))))
    names = (*BY_TRANSITION[:5], *first_names, *last_names, *AFTER)
    pairs = tuple(Relation(x, "=", y) for x, y in zip(ours, exact, strict=True))
    return Block((c, delta, epsilon), where, names, pairs, POINT | {epsilon: S.Half}, _parts)


def _parts() -> list[Theorem]:
    """No pole of a part of a period is zero, and no part is."""
    spring, *poles = _poles()
    parts = [assume(Ne(epsilon, 0)), combined(Ne(REST, 0), [-1, assume(Ne(epsilon, 1))])]
    shorter = [
        nonzero(way * of / 2 - delta * of / 2, spring, part)
        for part, of in zip(parts[::-1], (REST, PART), strict=True)
        for way in (c, -c)
    ]
    return [spring, *parts, *poles, *shorter]


DISCRETE = Later(partial(device_block, 0, 1, 2, 3))
POLYNOMIAL = Later(partial(device_block, 0, 1, 2, 3, polynomial=True))
CONDITIONS = Later(partial(device_block, 0, 1, 4, 6))
ALL = Later(partial(device_block, *range(10)))
LATE = Later(_late)
