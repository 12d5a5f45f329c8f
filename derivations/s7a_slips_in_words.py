"""Which names and numbers in the text are wrong?

Some errors in the text do not affect a formula, such as a wrong section, panel or name. The paper's
sections, tables, captions and references show what is meant.
"""


def derive(page):
    page.say(
        "The following entries compare one passage of the text with another. They do not count "
        "as theorems."
    )
    page.say("Section IV is headed Stability. The conclusion is Section VI.")
    page.settle_slip(
        "s1-conclusion",
        "Section IV",
        r"\text{Section VI}",
        "Section IV is Stability, Section VI the Conclusion",
    )
    page.say(
        "According to the captions, the first panel of Fig. 12 shows the two stiffnesses, and "
        "the other two panels show their ratio. The captions of these two panels are identical."
    )
    page.settle_slip(
        "s5b-ratio-panels",
        "Fig. 12(a) and (c)",
        r"\text{Fig. 12(b) and (c)}",
        "by the caption, (a) shows the stiffnesses",
    )
    page.settle_slip(
        "s5b-captions-alike",
        "(c) Relation of maximum virtual stiffness",
        r"\text{each with the delays for which it is drawn}",
        "two plots with the same caption; Sec. V-B says that their delay axes differ; possibly "
        "an error of the text conversion",
    )
    page.say(
        "By Table I, $K$ is the virtual stiffness and $B$ the virtual damping. A bound that is "
        "linear in $m$ and $1/T$ has the unit of a damping."
    )
    page.settle_slip(
        "s4d-bound-of-b",
        "virtual stiffness $B$",
        r"\text{virtual damping}\ B",
        "Table I, and the unit of the bound",
    )
    page.say("According to the list of references, [3] is by Hannaford and Ryu.")
    page.settle_slip(
        "s1-et-al",
        "Hannaford, et al. [3]",
        r"\text{Hannaford and Ryu [3]}",
        "the list of references names two authors",
    )
    page.say(
        "According to the list of references, [21], [28] and [30] have two authors each. So has "
        "[27], and Table II names both authors of [27]."
    )
    page.settle_slip(
        "s4c-et-al",
        "Daniel et al. [21]",
        r"\text{two names for each of}\ [21],[28],[30]",
        "the list of references, and [27] in the same table",
    )
