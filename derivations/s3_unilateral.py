"""Does the condition also hold for a wall that only pushes?

In practice a virtual wall only pushes: its force is zero without contact. The paper cites its first
reference for the claim that the passivity condition is the same. We check how much of this claim
follows from a simple bound.
"""

from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "Let the spring force $f(x)$ have a slope between 0 and $K$, as a unilateral spring "
        "has. Let $U$ be its energy. In one step, $U$ grows by at most the initial force times "
        "the step, plus a term that the slope causes:"
    )
    page.step(
        "A spring of constant slope $K$ gains the most energy",
        K * (x + p_k) ** 2 / 2 - K * x**2 / 2,
        K * x * p_k + K * p_k**2 / 2,
        name=r"U(x+p)-U(x)",
        because=r"the slope $K$ is the steepest, so in general $f(x)\,p\ge "
        r"U(x+p)-U(x)-\tfrac12Kp^2$",
    )
    q = symbols("q")
    page.step(
        "A product of two steps is at most half the sum of their squares",
        (p_k**2 + q**2) / 2,
        p_k * q + (p_k - q) ** 2 / 2,
        because=r"the last square is not negative, so $|p_kq|\le\tfrac12(p_k^2+q^2)$ for "
        "every step $q$ within the delay",
    )
    page.say(
        "With an integer delay of $d$ periods the spring force differs from $f(x_k)$ by at most "
        r"$K$ times the sum $|p_{k-1}|+\ldots+|p_{k-d}|$ of the last $d$ steps. The damper force "
        "is $B/T$ times one earlier step. So the wall delivers at most "
        r"$(K(d+\tfrac12)+|B|/T)\sum p_k^2$. Therefore $b\ge KT(d+\tfrac12)+|B|$ is sufficient "
        "for a wall that only pushes. Without delay this condition is (6) itself; with a delay "
        r"it is (9) for $-b\le B\le0$. For positive damping and a delay it is stricter than (5). "
        "That (5) itself is sufficient is a result of the reference, which we do not prove."
    )
    page.settle_external(
        "s3-unilateral",
        "the proof for general $B$ and $d$ is in the paper's reference [1]",
        checked=r"shown for $d=0$, and for integer $d$ with $-b\le B\le0$",
    )
