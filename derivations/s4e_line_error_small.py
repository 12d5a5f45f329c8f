r"""Up to which stiffness is the error of the linear condition small?

Fig. 10 marks errors of 2 and 5 per cent. On the boundary we look for a range of stiffnesses in
which the larger of these levels is not exceeded, for every arm of (23).
"""

from symhaptic.book.lemmas.linear_small_error import above, below, small_errors
from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "In the coordinates of \\chapter{s4e_line_error_rises} the walls with an error of "
        "$\\varepsilon$ lie on the ray $b=(d+\\frac12)(1+\\varepsilon)A$. Jury's minor rises with "
        "$b$ and is zero on the boundary. On the ray of 5\\,\\% it is positive:"
    )
    page.lemma(
        "Without delay $b\\le1.05\\cdot\\frac12A$ on the boundary, up to $\\alpha=0.09$", below(0)
    )
    page.lemma("For $d=1$ $b\\le1.05\\cdot\\frac32A$, up to $\\alpha=0.026$", below(1))
    page.say(
        "On the ray of $-5\\,\\%$ it is negative from $A=\\gamma$ on, since the gap at the start "
        "is narrow (\\chapter{s4e_line_two_percent}):"
    )
    page.lemma("Without delay $0.95\\cdot\\frac12A\\le b$ for $A\\ge\\gamma$", above(0))
    page.lemma("For $d=1$ $0.95\\cdot\\frac32A\\le b$ for $A\\ge\\gamma$", above(1))
    _, given, _ = taken_apart(CLAIMED["s6-linear-small-error"](()))
    page.settle(
        "s6-linear-small-error",
        small_errors(),
        example=example(dict.fromkeys((alpha, beta, gamma, delta), S.Zero), given),
        enclosed=True,
        note="for $d=0$ and $d=1$, and for $\\beta\\le0.1$. Next to $\\alpha=-\\gamma$ the error "
        "is larger (\\texttt{linear-error-corner}). For $d=1$ the range ends before the "
        "$\\alpha=0.03$ that no device of the paper exceeds",
    )
