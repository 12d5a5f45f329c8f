"""The hyperbolic cotangent of half a number exceeds two over the number."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.analysis import grows


def cotangent_exceeds() -> Theorem:
    """0 < coth(delta/2) - 2/delta for 0 < delta, as t cosh(t/2) - 2 sinh(t/2) rises from 0."""
    half = positive(t / 2 > 0, [Rational(1, 2), t > 0])
    sine = closed(rising(sinh, S.Zero, t / 2), half)
    rest = t * cosh(t / 2) - 2 * sinh(t / 2)
    slope = positive(diff(rest, t) > 0, [Rational(1, 2), t > 0, sine])
    above = positive(rest.subs(t, delta) > 0, [grows(rest, t, S.Zero, delta, slope)])
    sine = inst(sine, {t: delta})
    below = positive(delta * sinh(delta / 2) > 0, [delta > 0, sine])
    apart = positive(Ne(sinh(delta / 2), 0), [sine]), positive(Ne(delta, 0), delta > 0)
    excess = cosh(delta / 2) / sinh(delta / 2) - 2 / delta
    return closed(over(excess > 0, above, below), *apart)
