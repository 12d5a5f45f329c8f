r"""Does one damping describe a held device, for passivity and for stability?

By (2) the damping of the loop is that of device and arm together. By (3) the damping that counts
for passivity is that of the device alone. Figs. 11 to 13 and the ratio $\eta$ have one $\delta$ for
both.
"""

from symhaptic.book.lemmas.one_delta import (
    counterexample_of,
    drawn_too_large,
    easy,
    in_numbers,
    outdone_by_the_arm,
    ratios_kept,
    right,
    shown,
    stays_stable,
)
from symhaptic.notation import T, b_D, b_H, delta, m_D, m_H
from symhaptic.paper.propositions.one_delta import (
    instead,
    oversized,
    ratios,
    still_true,
)


def derive(page):
    page.say(
        "Let a device with the mass $m_D$ and the damping $b_D$ be held by an arm with the mass "
        "$m_H$, the damping $b_H$ and the stiffness $k_H$. The mass of (2) normalises the wall: "
        "$\\alpha=KT^2/(m_D+m_H)$ and $\\beta=BT/(m_D+m_H)$. In these units the damping of the "
        "loop is $\\delta$, and that of the device is $\\delta_D$:"
    )
    page.define("Damping of device and arm", delta, T * (b_D + b_H) / (m_D + m_H))
    page.define("Damping of the device", r"\delta_D", T * b_D / (m_D + m_H))
    page.lemma(
        "The wall meets (5) with the damping $b_D$ of (3) if and only if it meets (5) in the "
        "normalised plane with $\\delta_D$",
        right(),
        because="(5) is linear in $K$, $B$ and $b$; $\\omega T$ is the normalised angle",
    )
    page.say(
        "So the passive walls of a held device are those that (5) gives for $\\delta_D$. The "
        "region that (5) gives for $\\delta$ is larger by the factor $1+b_H/b_D$ in each "
        "direction. A passive wall is stable all the same, and some stable walls are stiffer by "
        "this factor than every passive wall."
    )
    page.lemma(
        "A wall with $K>0$ that meets (5) with the damping of the device is stable in every arm",
        stays_stable(),
        because="such a wall meets (5) with the larger damping of device and arm, and a wall that "
        "does so is stable with every spring",
    )
    page.lemma(
        "In every arm some stable wall is at least $1+b_H/b_D$ times as stiff as all passive walls",
        outdone_by_the_arm(),
        because="the wall (11) with the damping of device and arm is stable in the arm; every "
        "passive wall is softer than (11) with the damping of the device",
        boxed=True,
    )
    page.say(
        "So $\\eta\\le b_D/(b_D+b_H)$ for every whole delay. The ratio comes near 1 only for an "
        "arm without damping. The number 0.9998 that Fig. 12 reaches at $d=40$ describes no device "
        "that is held by an arm with damping."
    )
    numbers(page)
    page.settle(
        "one-delta",
        shown(),
        instead=instead(),
        corrected=(
            r"\text{passive:}\ (5)\ \text{with}\ \delta_D=\frac{b_DT}{m_D+m_H}",
            r"\text{stable:}\ \delta=\frac{(b_D+b_H)T}{m_D+m_H}",
            r"\eta\le\frac{b_D}{b_D+b_H}",
        ),
        misprint=False,
        unless=[counterexample_of()],
        shows=r"a device of 1 kg and 0.625 Ns/m in an arm of 1 kg and 14.6 Ns/m, $T=1$ ms and "
        r"$K=10\,000$ N/m: (5) holds with $\delta$ and fails with $b_D$",
        note=r"right for an arm without damping. What stays true: passive walls are stable with "
        r"every spring; the ratio of stable to passive stiffness exceeds 17.8 at $d=0$ and 9.3 at "
        r"$d=1$. What does not: that $\eta$ comes near 1, and the sizes of the passive regions in "
        r"Figs. 11 and 13",
    )


def numbers(page):
    """An arm at the limits of (21), and the figures."""
    page.say(
        "An example at the limits of the paper: $b_D/m_D=0.625\\,\\mathrm s^{-1}$, "
        "$b_H/m_H=14.6\\,\\mathrm s^{-1}$, $k_H/m_H=710\\,\\mathrm s^{-2}$, $m_D=m_H$ and "
        "$T=1$ ms. Then $\\gamma=0.000355$, $\\delta=0.0076125$ and $\\delta_D=0.0003125$."
    )
    page.state(
        "one-delta-ratio",
        "for this arm and $d=0$ the largest stable stiffness is between 45.7 and 45.8 times the "
        "stiffness that (5) allows with $\\delta$, and between 1114 and 1115 times the largest "
        "passive stiffness, which is that of $\\delta_D$",
        claim=ratios(),
    )
    page.settle("one-delta-ratio", in_numbers(), enclosed=True)
    page.say(
        "Figs. 11 and 13 draw the passive walls for $\\delta=0.02$. At 1 kHz no device of Sec. "
        "IV-C has more than $\\delta_D=0.000625$:"
    )
    claim = oversized()
    page.state(
        "one-delta-figures",
        "for $b_D/m_D\\le0.625\\,\\mathrm s^{-1}$ and $T\\le1$ ms a wall that is 32 times as large "
        "as a passive wall still meets (5) with $\\delta=0.02$",
        claim=claim,
    )
    page.settle("one-delta-figures", drawn_too_large(), example=easy(claim))
    page.say("The two ratios of Sec. V-B stay true, for they become larger:")
    claim = still_true()
    page.state(
        "one-delta-kept",
        "on all of (23), with any damping of the device up to that of device and arm, some stable "
        "wall is more than 17.8 times as stiff as all passive walls at $d=0$, and more than 9.3 "
        "times at $d=1$",
        claim=claim,
    )
    page.settle("one-delta-kept", ratios_kept(), example=easy(claim))
    page.say(
        "Who tunes a device uses $b_D$ for passivity and $b_D+b_H$ for stability. Whoever puts the "
        "damping of the arm into (5) calls walls passive that are $1+b_H/b_D$ times too stiff: 24 "
        "times in the example. Such a wall can push the hand as soon as the grip loosens."
    )
