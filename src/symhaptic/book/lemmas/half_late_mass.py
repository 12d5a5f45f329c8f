"""Half a period late a wall that is stable for a free mass is stable in the paper's reading.

The loop has the polynomial F(z), and what the paper reads is P(v) with v^2 = z and
v P(v) = F(v^2) - (v-1)^4 W(v^2)/8.  Along F(v^2) - q (v-1)^4 W(v^2)/8, 0 < q <= 1, no zero crosses
the border of the region 0 < Re v, 1 <= |v|.
"""

from symhaptic.book.lemmas.half_late_circle import (
    LOOP,
    PUSH,
    TRUE,
    WALL,
    counted,
    differs,
    no_crossing,
    path,
    pushes,
    q,
    zeros,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.principal import FREE, in_truth, read_loop
from symhaptic.proof.theorems.roots import none_enters

READ = Predicate("stable_principal", (), LOOP)
v = Symbol("v")


def half_late_mass() -> Proposition:
    """A wall that is stable half a period late is stable on the principal sheet."""
    return every((alpha, beta, l), [whole(l), TRUE], READ)


@cache
def on_the_axis() -> Theorem:
    """f != 0 at j r, 1 < r = exp(psi): z^(l+2) (z-1)^2 and W are real there, and (v-1)^4 is not."""
    _, brake, stiff = pushes()
    size, sign = exp(psi), exp(I * pi * l)
    above = [sign_of(exp, psi), assume(q > 0)]
    longer = closed(rising(exp, S.Zero, 2 * psi), positive(2 * psi > 0, [2, psi > 0]))
    imaginary = q * size * (size**2 - 1) * (PUSH * size**2 + beta)
    pushed = [*above, longer, stiff, sign_of(exp, 2 * psi)], [*above, longer, brake]
    turns = full_turns(S.Zero, assume(whole(l)))
    sine, cosine = (conjunct(turns, claim) for claim in turns.conclusion.parts)
    real = combined(Eq(sign, 1 / sign), [cosine, 1 / sign], [sine, I / sign])
    there = path(psi + I * pi / 2)
    zero = assume(Eq(there, 0))
    none = combined(
        Relation(imaginary, "=", S.Zero),
        [zero, -I],
        [mirrored(zero), I],
        [real, I * exp(2 * psi * (l + 2)) * (size**2 + 1) ** 2],
    )
    return differs(there, not_intro(combined(imaginary > 0, *pushed), none))


@cache
def stable_as_read() -> Theorem:
    """That."""
    static = positive(Ne(alpha, 0), pushes()[0])
    change = -((v - 1) ** 4) * (PUSH * v**2 - beta) / 8
    shown = no_crossing(), static, on_the_axis()
    never = none_enters(zeros(), change, (v, q, psi, x, y), *shown)
    sheet = read_loop(FREE, WALL, l)
    outside, apart = sheet.conclusion.parts[1].body.of  # type: ignore[attr-defined]
    known = at(never, {x: x, y: y}, *map(assume, outside.of))
    here = x + I * y
    root = assume(Eq(here, 0))
    twice = combined(Relation(2 * x, "=", S.Zero), [root], [mirrored(root)])
    right = differs(here, not_intro(positive(2 * x > 0, [2, x > 0]), twice))
    found = closed(factor(apart.left, known, -here), right)
    found = mp(sheet, for_all((x, y), outside.of, found))
    return for_all((alpha, beta, l), [whole(l), TRUE], counted(found))


def stands() -> tuple[dict[Any, Expr], Theorem]:
    """A wall, and that it is stable half a period late."""
    wall: dict[Any, Expr] = {alpha: Rational(1, 20), beta: Rational(1, 2)}
    return {**wall, l: S.Zero}, in_truth(FREE, wall, True)
