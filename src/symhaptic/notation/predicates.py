"""The named predicates of propositions: how each is written, and what it means."""

from __future__ import annotations

MEANINGS: dict[str, tuple[int, int, str, str]] = {
    # name: bound symbols, terms, LaTeX, meaning of the LaTeX with the terms of TERMS
    "whole": (0, 1, r"{0}\in\mathbb{{N}}_0", "$n$ is a whole number, zero included"),
    "increasing": (
        *(1, 3),
        r"{0}\ \text{{increases with}}\ {s}\ \text{{on}}\ ({1},{2})",
        "$f$ is defined, real and strictly increasing on the open interval",
    ),
    "limit": (
        *(1, 3),
        r"\lim_{{{s}\to {1}}} {0:term}={2}",
        "$f$ has this limit from both sides",
    ),
    "stable": (
        *(1, 1),
        r"\text{{all zeros of}}\ {0}\ \text{{in}}\ {s}\ \text{{lie in}}\ |{s}|<1",
        "every zero of the polynomial $p$ lies inside the unit circle",
    ),
    "hurwitz": (
        *(1, 1),
        r"\text{{all zeros of}}\ {0}\ \text{{in}}\ {s}\ \text{{lie in}}\ \Re {s}<0",
        "every zero of the polynomial $p$ has a negative real part",
    ),
    "passive": (
        *(1, 2),
        r"\text{{no motion gains energy from}}\allowbreak\ H({s})={0}"
        r"\allowbreak\ \text{{beside a loss of}}\ {1}\allowbreak\ "
        r"\text{{per squared displacement}}",
        "$\\sum_k(cp_k^2+p_k(Hx)_k)\\ge0$ for any finite sequence of displacements "
        "$p_k=x_{k+1}-x_k$ from rest at $x=0$; for each, a damper dissipates $cp_k^2$, and the "
        "motion works against the force $(Hx)_k=h_0x_k+h_1x_{k-1}+\\ldots$",
    ),
    "passive_wall": (
        *(0, 5),
        r"\mathrm{{passive}}({0},{1},{2},{3},{4})",
        "no motion of a device with damping $b$ gains energy from the wall $K+B(z-1)/(Tz)$, "
        "sampled every $T$, its force held for $T$ and delayed by $d$ periods",
    ),
    "passive_device": (
        *(1, 6),
        r"\mathrm{{passive}}({1},{2},{3},{4},{5};\ E({s})={0})",
        "the work that moves a device from rest, $v=0$, is never negative; it is the stored energy "
        "$E$ at the final speed $v$, here that of a mass, plus the energy that the damping $b$ and "
        "the same wall absorb",
    ),
    "passive_counted": (
        *(1, 5),
        r"\text{{no motion gains energy from}}\allowbreak\ F({s})={0}"
        r"\allowbreak\ \text{{beside}}\ ({1},{2}),\allowbreak\ "
        r"\text{{sampled every}}\ {3}\ \text{{in counts of}}\ {4}",
        "for every motion from rest at $x=0$, $\\sum_kF(y_k)p_k+\\int(bv^2+f_c|v|)\\,dt\\ge0$ "
        "at its end; $p_k$ is the displacement in period $k$, and $y_k$ a multiple of $\\Delta$ "
        "nearest to the position at its start, whose force $F$ is held for the period $T$",
    ),
    "stable_loop": (
        *(0, 5),
        r"\mathrm{{stable}}({0},{1},{2},{3},{4})",
        "the loop of wall $(\\alpha,\\beta)$, spring $\\gamma$, damper $\\delta$ and a delay of "
        "$d$ periods, all in units of mass and period, comes to rest from every state",
    ),
    "stable_substituted": (
        *(0, 5),
        r"\mathrm{{stable}}_{{(18)}}({0},{1},{2},{3},{4})",
        "in the paper's reading: every zero of the characteristic polynomial (18), that is, of "
        "$z^{d+1}(z^2-az+e)+(n_1z+n_0)((\\alpha+\\beta)z-\\beta)$ with the numbers of the device "
        "$(\\gamma,\\delta)$, lies inside the unit circle; for a delay of $d=p/q$ periods, every "
        "zero of the polynomial in $w$ after the substitution $z=w^q$ does",
    ),
    "stable_principal": (
        *(0, 5),
        r"\mathrm{{stable}}_{{\text{{principal}}}}({0},{1},{2},{3},{4})",
        "no zero $z$ of the same with $|z|\\ge1$, where $z^d$ is the principal value, "
        "$\\exp(d\\ln|z|+jd\\arg z)$ with $-\\pi<\\arg z<\\pi$",
    ),
    "pole": (
        *(0, 6),
        r"{5}\ \text{{is a pole of}}\ p_{{(18)}}({0},{1},{2},{3},{4})",
        "in the paper's reading: $z$ is a zero of the characteristic polynomial; for a delay of "
        "$d=p/q$ periods, $z=w^q$ with a zero $w$ of the polynomial after this substitution",
    ),
    "swings": (
        *(0, 4),
        r"{0:factor}\ddot x+{1:factor}\dot x+{2:factor}x=0\ \text{{swings with}}\ {3}",
        "there is a motion $x=e^{\\sigma t}\\sin\\omega t$ with a real $\\sigma$",
    ),
    "degree": (
        *(1, 2),
        r"{0}\ \text{{has degree }}{1}\text{{ in }}{s}",
        "$n$ is the highest power in the polynomial $p$ whose coefficient is not zero",
    ),
    "answers": (
        *(1, 4),
        r"{0}\ \text{{answers }}{1:base}^k\text{{, held every }}{3}"
        r"\text{{, by }}{2:factor}\,{1:base}^k",
        "a force $z^k$ that is held during period $k$, of length $T$, acts through a device with "
        "the transfer function $P$; exactly one motion is multiplied by $z$ in each period, and "
        "its position at sample $k$ is $Xz^k$, for all $k$, negative ones included ($P$, $z$, $X$ "
        "and $T$ have values)",
    ),
    "device": (
        *(0, 6),
        r"\frac{{{2:factor}z+{3:term}}}{{z^2-{4:factor}z+{5:term}}}"
        r"\ \text{{samples the device}}\ ({0},{1})",
        "$a=\\mathrm{tr}\\,\\Phi$, $e=\\det\\Phi$, $n_1=\\Gamma_1$ and "
        "$n_0=\\Phi_{12}\\Gamma_2-\\Phi_{22}\\Gamma_1$, where $\\Phi$ and $\\Gamma$ take the state "
        "$(x,v)$ and a held force to the state one period later, of "
        "$\\ddot x+\\delta\\dot x+\\gamma x=F$, in units of mass and period",
    ),
    "late_device": (
        *(0, 8),
        r"\frac{{{3:factor}z^2+{4:factor}z+{5:term}}}{{z\,(z^2-{6:factor}z+{7:term})}}"
        r"\ \text{{samples the device}}\ ({0},{1})"
        r"\ \text{{late by}}\ {2}",
        "the same device with the same $a$ and $e$, each held force delayed by $u$ periods, "
        "$0\\le u\\le1$: with $G=\\Gamma(1-u)$ and $H=\\Phi(1-u)\\,\\Gamma(u)$, "
        "$m_2=G_1$, $m_1=\\Phi_{12}G_2-\\Phi_{22}G_1+H_1$ and $m_0=\\Phi_{12}H_2-\\Phi_{22}H_1$",
    ),
}
"""Each predicate: how many symbols it binds, how many terms it has, its LaTeX and its meaning.

A term has brackets where it is not one, or no factor, or no base of a power, as it is marked."""

JUDGING = frozenset(
    name for name in MEANINGS if name.startswith(("stable", "passive")) or name == "hurwitz"
)
"""Those that judge a wall, a loop or a polynomial; a published formula may be their condition."""

TERMS: dict[str, tuple[str, ...]] = {
    "whole": ("n",),
    "increasing": ("f(x)", "u", "v"),
    "limit": ("f(x)", "u", "y"),
    "stable": ("p(z)",),
    "hurwitz": ("p(s)",),
    "passive": (r"h_0+h_1/z+\ldots", "c"),
    "passive_wall": ("K", "B", "b", "T", "d"),
    "passive_device": ("mv^2/2", "K", "B", "b", "T", "d"),
    "passive_counted": ("F(y)", "b", "f_c", "T", r"\Delta"),
    "stable_loop": (r"\alpha", r"\beta", r"\gamma", r"\delta", "d"),
    "stable_substituted": (r"\alpha", r"\beta", r"\gamma", r"\delta", "d"),
    "stable_principal": (r"\alpha", r"\beta", r"\gamma", r"\delta", "d"),
    "pole": (r"\alpha", r"\beta", r"\gamma", r"\delta", "d", "z"),
    "swings": ("m", "b", "k", r"\omega"),
    "degree": ("p(z)", "n"),
    "answers": ("P(s)", "z", "X", "T"),
    "device": (r"\gamma", r"\delta", "n_1", "n_0", "a", "e"),
    "late_device": (r"\gamma", r"\delta", "u", "m_2", "m_1", "m_0", "a", "e"),
}
"""LaTeX of the terms in the meaning of a predicate."""
