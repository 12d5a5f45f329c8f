"""Which force does the virtual wall return?

Once per period $T$ the wall reads the position. It returns the force of a spring $K$ and a damper
$B$; the velocity is the difference of the last two positions over $T$.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model import wall
from symhaptic.notation import function


def derive(page):
    H = function("H")
    law = wall.transfer()
    page.define(
        "The wall force from the last two samples",
        "H(z)",
        law,
        because="a period earlier is a factor $1/z$, so $x_k-x_{k-1}$ becomes $(1-1/z)\\,x$",
    )
    form = page.step(
        "The wall is a quotient with one pole, at $z=0$",
        law,
        K + B * (z - 1) / (T * z),
        name=H(z),
        paper="1",
        because="both fractions are brought over $z$",
    )
    page.step(
        "A wall at rest is its spring alone",
        law.subs(z, 1),
        K,
        name="H(1)",
        because=r"at a constant position only the spring acts; passivity requires $H(1)\ge0$",
    )
    page.settle("eq1", Eq(H(z), form), definition=True)
