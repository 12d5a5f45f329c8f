r"""What does the virtual wall push back with?

Once per period $T$ the wall reads the position and answers with the force of a spring $K$ and
of a damper $B$, whose velocity is the difference of the last two positions.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model import wall
from symhaptic.notation import function


def derive(page):
    H = function("H")
    law = wall.transfer()
    page.define(
        "Once per period the wall pulls by position and speed",
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
        because="a constant position meets the spring only; this number decides more than it seems",
    )
    page.settle("eq1", Eq(H(z), form), definition=True)
