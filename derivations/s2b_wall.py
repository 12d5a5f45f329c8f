"""Which force does the virtual wall return?

Once per period $T$ the wall reads the position. It returns the force of a spring $K$ and a damper
$B$; the velocity is the difference of the last two positions, divided by $T$.
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
        because="the factor $1/z$ is a shift to the previous period, so $x_k-x_{k-1}$ becomes "
        r"$(1-1/z)\,x$",
    )
    form = page.step(
        "The transfer function of the wall has one pole, at $z=0$",
        law,
        K + B * (z - 1) / (T * z),
        name=H(z),
        paper="1",
        because="the two terms are written over the common denominator $z$",
    )
    page.step(
        "At a constant position the wall is its spring alone",
        law.subs(z, 1),
        K,
        name="H(1)",
        because="at a constant position, $z=1$, the virtual damper has no effect; passivity "
        r"requires $H(1)\ge0$",
    )
    page.settle("eq1", Eq(H(z), form), definition=True)
