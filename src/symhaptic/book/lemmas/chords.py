"""Signs of sines and chords for 0 < N psi < pi and N > 2: what makes the envelope rise and fall.

Each function takes an angle and gives a theorem, under N > 2, 0 < psi and N psi < pi there.
"""

from __future__ import annotations

from functools import wraps

from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.normal import is_zero
from symhaptic.proof.theorems.analysis import grows

HALF = S.Half
PI = number(Relation(S.Zero, "<", pi))


def anywhere(theorem: Callable[[], Theorem]) -> Callable[..., Theorem]:
    """A theorem about psi, made once, at any angle."""
    made = cache(theorem)

    @cache
    @wraps(theorem)
    def there(angle: Expr = psi) -> Theorem:
        return made() if angle == psi else inst(made(), {psi: angle})

    return there


@cache
def size() -> Theorem:
    """0 < N, for N > 2."""
    return positive(N > 0, N > 2, [2])


@anywhere
def one_less() -> Theorem:
    """0 < (N - 1) psi."""
    return positive((N - 1) * psi > 0, [N > 2, psi > 0], [psi > 0])


@anywhere
def quarter() -> Theorem:
    """psi < pi/2, for 2 psi < N psi < pi."""
    more, up, low = assume(N > 2), assume(N * psi < pi), assume(psi > 0)
    return positive(psi < pi / 2, [HALF, up], [HALF, more, low])


@anywhere
def sine() -> Theorem:
    """0 < sin psi."""
    below = positive(psi < pi, [quarter(psi)], [HALF, PI])
    return closed(sign_of(sin, psi), below)


@anywhere
def cosine() -> Theorem:
    """0 < cos psi."""
    above = positive(psi > -pi / 2, psi > 0, [HALF, PI])
    return closed(sign_of(cos, psi), above, quarter(psi))


@anywhere
def sine_of_larger() -> Theorem:
    """0 < sin N psi."""
    return closed(sign_of(sin, N * psi), positive(N * psi > 0, [size(), psi > 0]))


@anywhere
def falls() -> Theorem:
    """0 < cos psi - cos N psi: the cosine of the larger psi is smaller."""
    order = positive(psi < N * psi, [one_less(psi)])
    first, last = positive(psi >= 0, psi > 0), positive(N * psi <= pi, N * psi < pi)
    found = closed(rising(cos, psi, N * psi), order, first, last)
    return positive(cos(psi) - cos(N * psi) > 0, [found])


def _before() -> Theorem:
    """N phi < pi for phi < psi."""
    return positive(N * phi < pi, N * psi < pi, [size(), phi < psi])


@anywhere
def flatter() -> Theorem:
    """0 < N sin psi - sin N psi: the sine of the larger psi is flatter."""
    rest = N * sin(phi) - sin(N * phi)
    slope = positive(derivative(rest, phi) > 0, [size(), falls(phi)])
    return _from_zero(rest, slope)


def _from_zero(rest: Expr, slope: Theorem) -> Theorem:
    """0 < f(psi), for f(0) = 0 and a positive slope before."""
    found = grows(rest, phi, S.Zero, psi, closed(slope, _before()))
    return positive(rest.xreplace({phi: psi}) > 0, [found])


@anywhere
def width() -> Theorem:
    """0 < N sin 2 psi - sin 2 N psi, the divisor of (7)."""
    whole = N * sin(2 * psi) - sin(2 * N * psi)
    return positive(
        whole > 0,
        [2, flatter(psi), cosine(psi)],
        [2, sine_of_larger(psi), falls(psi)],
    )


@anywhere
def chord_before() -> Theorem:
    """0 < sin N psi - N sin psi cos (N-1) psi."""
    rest = sin(N * phi) - N * sin(phi) * cos((N - 1) * phi)
    below = positive((N - 1) * phi < pi, N * phi < pi, phi > 0)
    less = closed(sign_of(sin, (N - 1) * phi), one_less(phi), below)
    slope = positive(derivative(rest, phi) > 0, [size(), N > 2, sine(phi), less])
    return _from_zero(rest, slope)


@anywhere
def chord_after() -> Theorem:
    """0 < sin N psi - N sin psi cos (N+1) psi, before (N+1) psi = pi and after."""
    rest = sin(N * phi) - N * sin(phi) * cos((N + 1) * phi)
    room = (N + 1) * psi
    inside = positive((N + 1) * phi < pi, [room < pi], [size(), phi < psi], [phi < psi])
    more = positive((N + 1) * phi > 0, [size(), phi > 0], phi > 0)
    above = closed(sign_of(sin, (N + 1) * phi), more, inside)
    slope = positive(
        derivative(rest, phi) > 0, [size(), size(), sine(phi), above], [2, size(), sine(phi), above]
    )
    early = _from_zero(rest, slope)
    low = positive(room - pi > -pi / 2, [assume(pi <= room)], [HALF, PI])
    high = positive(room - pi < pi / 2, N * psi < pi, [quarter(psi)])
    turned = closed(sign_of(cos, room - pi), low, high)
    goal = rest.xreplace({phi: psi}) > 0
    late = positive(goal, [sine_of_larger(psi)], [size(), sine(psi), turned])
    return disj_cases(ordered(room, pi), early, late)


@anywhere
def bend() -> Theorem:
    """0 < N sin 2 psi + sin 2 N psi - 4 sin^2 N psi cot psi/N: it rises from zero."""
    rest = N * sin(2 * phi) + sin(2 * N * phi) - 4 * sin(N * phi) ** 2 * cos(phi) / (N * sin(phi))
    top = positive(
        4 * chord_before(phi).conclusion.right * chord_after(phi).conclusion.right > 0,  # type: ignore[attr-defined]
        [4, chord_before(phi), chord_after(phi)],
    )
    bottom = positive(N * sin(phi) ** 2 > 0, [size(), sine(phi), sine(phi)])
    apart = not_zero(size()), not_zero(sine(phi))
    slope = closed(over(derivative(rest, phi) > 0, top, bottom), *apart)
    below = over(pi / N - phi > 0, positive(pi - N * phi > 0, N * phi < pi), size())
    inside = closed(positive(N * phi < pi, [size(), assume(phi < pi / N)]), *apart)
    slope, defined = closed(slope, inside), closed(apart[1], inside)
    rises = increases(rest, phi, S.Zero, pi / N, slope, defined)
    found = above_its_start(closed(rises, *apart), tends(rest, phi, S.Zero, S.Zero))
    found = closed(found, positive(phi < pi / N, [below]), *apart)
    return inst(found, {phi: psi})


def not_zero(theorem: Theorem) -> Theorem:
    """e != 0 from 0 < e."""
    return positive(Relation(theorem.conclusion.right, "!=", S.Zero), [theorem])  # type: ignore[attr-defined]


def lowest_coefficients(theorem: Theorem, sine_: Theorem, angle: Expr) -> list[Theorem]:
    """That multiples of 0 < sin x and powers of exp(j x), as series leave them, are not zero."""
    found = []
    for claim in theorem.hypotheses:
        if isinstance(claim, Relation) and claim.left.has(I):
            for other in (s * HALF * exp(-n * I * angle) for s in (1, -1) for n in range(5)):
                if is_zero(claim.left * other - sin(angle)):
                    found.append(factor(claim.left, sine_, other))
    return found
