"""Is a wall stable if its stiffness is below four or two masses over the squared period?

The two rules depend only on the mass and the period, and not on damping or delay. We test them
with the simplest device, a free mass without delay.
"""

from symhaptic.book.lemmas.circulation import NOTHING, never_undamped, outside
from symhaptic.book.lemmas.prelude import *

RULES = "rules:four-masses", "rules:two-masses"
WALL = {K: S.One, B: S.Zero, T: S.One, m: S.One, b: S.Zero, k: S.Zero, d: S.Zero}
ROOTS = {alpha: S.One, beta: S.Zero, gamma: S.Zero, delta: S.Zero, d: S.Zero}


def derive(page):
    found = page.lemma(
        "Without any damping, no stiffness is stable, however small",
        never_undamped(),
        because="the hold delays the force of a spring by half a period on average, and a delayed "
        "spring adds energy",
        boxed=True,
    )
    page.lemma("With $m=T=1$ the wall $K=1$ has a root outside the circle", outside(ROOTS))
    for rule in RULES:
        symbols, (*given, _), _ = taken_apart(page.claim(rule))
        page.settle(
            rule,
            found,
            instead=every(symbols, [*given, *NOTHING], found.conclusion),
            corrected=[r"\text{no}\ K>0\ \text{is stable for}\ b=k=B=d=0"],
            misprint=False,
            example=WALL,
            unless=[(WALL, outside(ROOTS))],
            shows="a free mass with $m=T=1$: $K=1$ is already unstable",
        )
