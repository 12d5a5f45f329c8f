"""Is a passive wall stable with every spring, and how do the passive walls depend on the damping?

The passivity condition does not contain the spring: a passive wall is stable with every arm,
however stiff the arm is.
"""

from symhaptic.book.lemmas.connections import passive_wall_is_stable, stays_on_circle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import passive_in_numbers
from symhaptic.book.lemmas.walls import divisors


def derive(page):
    _robust(page)
    _scaled(page)


def _robust(page):
    """A passive wall with stiffness is stable with every spring and delay if b > 0."""
    robust = taken_apart(page.claim("s5c-robust-subset"))[2]
    stiff = proposition(alpha * delta > 0)
    known = assume(stiff)
    damper = strictly(assume(delta >= 0), factor(delta, known, alpha))
    push = over(alpha * delta / delta > 0, known, damper)
    push = closed(positive(alpha > 0, [push]), positive(Ne(delta, 0), [damper]))
    held = positive(alpha + gamma > 0, [push], gamma >= 0)
    springs = for_all([gamma], [gamma >= 0], closed(passive_wall_is_stable(), held, damper))
    wall = {alpha: S.One, beta: S.Zero, delta: S.One, d: S.Zero}
    drift = wall | {alpha: S.Zero, beta: HALF}

    def shown(point):
        return passive_in_numbers({K: point[alpha], B: point[beta], b: point[delta], T: S.One})

    free = drift | {gamma: S.Zero}
    there = robust.at(drift)
    calm = at(assume(there), {gamma: S.Zero}, fact(Relation(S.Zero, "<=", S.Zero)))
    shaken = not_intro(calm, stays_on_circle(free, S.Zero), there)
    page.settle(
        "s5c-robust-subset",
        springs,
        example=(wall, shown(wall)),
        unless={stiff: (drift, shown(drift), shaken)},
        shows="without any stiffness, the device drifts",
        note="the statement holds for every passive wall with stiffness if the device has a "
        r"damper, and for every $\gamma\ge0$, even if the natural frequency is above the Nyquist "
        "frequency",
    )


def _scaled(page):
    """(5) is linear in the wall and the damper."""
    need = passivity.dirichlet_form()
    page.step(
        "A wall with $y$ times the stiffness and damping requires $y$ times the damping",
        need.subs({K: y * K, B: y * B}, simultaneous=True),
        y * need,
        name=r"b_{\min}(yK,yB)",
        because="the condition is linear in the wall: if the damping is multiplied by $y$, the "
        "wall multiplied by $y$ is passive",
    )
    _, given, scaled = taken_apart(page.claim("s5a-proportional"))
    small, large = scaled.of
    inside = [assume(p) for p in small.body.of[0].of]
    up = positive(large.body.of[1], [at(assume(small), {omega: omega}, *inside), y > 0])
    share = over(1 / y > 0, one(), y > 0)
    down = positive(small.body.of[1], [at(assume(large), {omega: omega}, *inside), share])
    both = (
        for_all(
            [omega], small.body.of[0].of, closed(way, positive(Ne(y, 0), y > 0), *divisors(omega))
        )
        for way in (up, down)
    )
    same = add_assum(either_way(*both, small, large), *given)
    point = {alpha: S.One, beta: S.Zero, delta: S.One, d: S.Zero, y: S.One}
    page.settle("s5a-proportional", same, example=point)
