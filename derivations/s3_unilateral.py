"""Does the condition also hold for a wall that only pushes?

A real virtual wall only pushes: its force is zero without contact. The paper cites its first
reference for the claim that the passivity condition is the same. We check how much of this claim
follows from a simple bound.
"""

from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "Let the spring force $f(x)$ have a slope between 0 and $K$, as a unilateral spring has. "
        "Let $U$ be its energy. Over one step $U$ grows by at most the initial force times "
        "the step, plus a term from the slope:"
    )
    page.step(
        "A spring of constant slope $K$ gains most",
        K * (x + p_k) ** 2 / 2 - K * x**2 / 2,
        K * x * p_k + K * p_k**2 / 2,
        name=r"U(x+p)-U(x)",
        because="the steepest case; in general $f(x)\\,p\\ge U(x+p)-U(x)-\\tfrac12Kp^2$",
    )
    q = symbols("q")
    page.step(
        "A product of two steps is at most half the sum of their squares",
        (p_k**2 + q**2) / 2,
        p_k * q + (p_k - q) ** 2 / 2,
        because="so $|p_kq|\\le\\tfrac12(p_k^2+q^2)$ for the steps that lie within the delay",
    )
    page.say(
        "With an integer delay of $d$ periods the spring force differs by $d$ steps of slope at "
        "most $K$, and the damper force by one more. So the wall delivers at most "
        r"$(K(d+\tfrac12)+|B|/T)\sum p_k^2$. Therefore $b\ge KT(d+\tfrac12)+|B|$ is sufficient "
        "for a wall that only pushes. Without delay this is (6) itself; with delay it is (9) for "
        r"$-b\le B\le0$. For positive damping with delay it is stricter than (5), and for (5) "
        "alone we rely on the reference."
    )
    page.settle_external(
        "s3-unilateral",
        "the proof for general $B$ and $d$ stands in the paper's reference [1]",
        checked=r"shown for $d=0$, and for integer $d$ with $-b\le B\le0$",
    )
