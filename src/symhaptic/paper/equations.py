"""The numbered equations (1) to (31), transcribed as published."""

from __future__ import annotations

from symhaptic.paper.quoted import Quoted
from symhaptic.paper.statement import Statement

_FRACTIONS_7 = (
    r"\frac{\sin((d+2)\omega T) - 2\sin((d+1)\omega T) + \sin(d \cdot \omega T)}"
    r"{\sin(2(d+1)\omega T) - 2(1+d)\sin(\omega T)}",
    r"\frac{d \cdot \sin((d+1)\omega T) - (1+d)\sin(d \cdot \omega T)}"
    r"{\sin(2(d+1)\omega T) - 2(1+d)\sin(\omega T)}",
)
_FRACTIONS_27 = tuple(f.replace(r"\omega T", r"\hat{\omega}") for f in _FRACTIONS_7)

EQUATIONS = (
    Statement(
        "eq1",
        "Sec. II-B",
        "transfer function of the virtual wall",
        (r"H(z) = K + B \frac{z-1}{Tz}",),
        quote="the transfer function of the virtual environment is",
    ),
    Statement(
        "eq2",
        "Sec. II-D",
        "arm and device combined, for stability",
        (r"m = m_D + m_H", r"b = b_D + b_H", r"k = k_H"),
        quote="the physical parameters of the haptic device and the human can be combined to",
    ),
    Statement(
        "eq3",
        "Sec. II-D",
        "the device alone, for passivity",
        (r"m = m_D", r"b = b_D", r"k = 0"),
        quote="the considered physical system parameters are",
    ),
    Statement(
        "eq4",
        "Sec. III",
        "passivity condition for a virtual environment $H(z)$",
        (
            r"b > \frac{T}{2} \frac{1}{1 - \cos(\omega T)} "
            r"\Re\{(1 - e^{-j\omega T})H(e^{j\omega T})\}",
        ),
        r"0 < \omega < \omega_N",
        quote="Their condition guarantees passivity for a haptic device interacting with a "
        "virtual environment with transfer function $H(z)$. It reads",
    ),
    Statement(
        "eq5",
        "Sec. III-A",
        "passivity condition for a delayed virtual wall",
        (
            r"b > \left( (\cos(d \cdot \omega T) - \cos((d+1)\omega T))KT \br "
            r"+ (\cos(d \cdot \omega T) - 2\cos((d+1)\omega T) + \cos((d+2)\omega T))B \right) "
            r"/ (2 - 2\cos(\omega T))",
        ),
        r"0 < \omega < \omega_N",
        quote=r"the passivity condition (4) can be solved analytically for constant $d \geq 0$",
    ),
    Statement(
        "eq6",
        "Sec. III-A",
        "passivity condition without delay",
        (r"b > \frac{KT}{2} + |B|",),
        quote="which can be easily summarized as",
    ),
    Statement(
        "eq7",
        "Sec. III-B",
        "explicit passivity boundary",
        (
            r"\begin{pmatrix} K \\ B \end{pmatrix} = 2b \cdot \begin{pmatrix} "
            rf"\frac{{d+1}}{{T}} {_FRACTIONS_7[0]} \\ {_FRACTIONS_7[1]} \end{{pmatrix}}",
        ),
        quote="the explicit representation results in",
    ),
    Statement(
        "eq8",
        "Sec. III-C",
        "linear part of the passivity boundary",
        (
            r"\begin{pmatrix} K \\ B \end{pmatrix}_{\text{lin}} = \begin{pmatrix} "
            r"\frac{b}{T} \cdot \frac{6(d+1)}{(2d+1)(2d+3)} \\ "
            r"b \cdot \left(\frac{d}{2d+3} + 1\right) \end{pmatrix} \cdot y "
            r"+ \begin{pmatrix} 0 \\ -b \end{pmatrix}",
        ),
        r"y \in [0, 1]",
        quote=r"They can be derived as limits of the explicit passivity condition (7) at $\omega "
        r"\rightarrow 0$ as",
    ),
    Statement(
        "eq9",
        "Sec. III-C",
        "linear passivity condition",
        (r"K < \frac{b+B}{(0.5+d)T}",),
        r"B \in \left[-1, \frac{d}{2d+3}\right]b",
        quote="which can be rewritten as",
    ),
    Statement(
        "eq10",
        "Sec. III-C",
        "the linear passivity condition in words",
        (r"\text{Virtual Stiffness} < \frac{\sum \text{Damping}}{\sum \text{Delay}}",),
        reading=(r"K < \frac{b+B}{(0.5+d)T}",),
        quote="the virtual stiffness $K$ must be smaller than the sum of dampings $b+B$ divided "
        "by the total delay $(0.5+d)T$, or in other words",
    ),
    Statement(
        "eq11",
        "Sec. III-C",
        "largest passive stiffness and its damping",
        (
            r"\begin{pmatrix} K \\ B \end{pmatrix}_{K_{\max}} = b \cdot \begin{pmatrix} "
            r"\frac{2}{T} \cdot \frac{1 - \cos(\frac{1}{2} \frac{\pi}{d+1})}"
            r"{\cos(\frac{1}{2} \frac{\pi d}{d+1})} \\ "
            r"\frac{\sin(\frac{1}{2} \frac{\pi d}{d+1}) - \frac{d}{d+1}}"
            r"{\sin(\frac{1}{2} \frac{\pi}{d+1})} \end{pmatrix}",
        ),
        quote=r"the $(K, B)$ value pairs for maximum possible passive virtual stiffness $K_{\max}$"
        " results as",
    ),
    Statement(
        "eq12",
        "Sec. IV-A",
        "discrete equivalent of the mass-spring-damper",
        (
            r"\frac{1}{ms^2 + bs + k} \hat{=} \br "
            r"\frac{((c_2 + c_3 - 2)z + (c_2 + c_3 - 2e^{-bT/m}))(b^2 - 4km) \br "
            r"+ bc_1(c_3 - c_2)(z - 1)}"
            r"{2k(z^2 - (c_2 + c_3)z + e^{-bT/m})(4km - b^2)}",
        ),
        quote="The exact discrete-time equivalent of the mass-spring-damper system, can be "
        "determined by some calculations [2], while assuming the input force $F_E$ being "
        "constant during one sampling period $T$, as shown in (12)",
    ),
    Statement(
        "eq13",
        "Sec. IV-A",
        "abbreviations of (12)",
        (
            r"c_1 = \sqrt{\left(\frac{bT}{m}\right)^2 - \frac{4kT^2}{m}}",
            r"c_2 = e^{-(bT/m+c_1)/2}",
            r"c_3 = e^{-(bT/m-c_1)/2}",
        ),
    ),
    Statement(
        "eq14",
        "Sec. IV-B",
        "discrete equivalent in dimensionless parameters",
        (
            r"\frac{1}{ms^2 + bs + k} \hat{=} \br \frac{T^2}{2m} "
            r"\frac{((2 - c_2 - c_3)c_1 + (c_2 - c_3)\delta)z \br "
            r"+ (2e^{-\delta} - c_3 - c_2)c_1 + (c_3 - c_2)\delta}"
            r"{c_1\gamma(z^2 - (c_2 + c_3)z + e^{-\delta})}",
        ),
        quote="Inserting these substitution rules, the transfer function (12) becomes (14)",
    ),
    Statement(
        "eq15",
        "Sec. IV-B",
        "abbreviations of (14)",
        (
            r"c_1 = \sqrt{\delta^2 - 4\gamma}",
            r"c_2 = e^{-(\delta+c_1)/2}",
            r"c_3 = e^{-(\delta-c_1)/2}",
        ),
    ),
    Statement(
        "eq16",
        "Sec. IV-B",
        "closed loop from force to position",
        (r"G_x(z) = \frac{T^2 z^{1+d}}{m} \cdot \frac{n(z)}{p(z)}",),
        quote="This transfer function from force $F_E^*$ to position $x^*$ results in",
    ),
    Statement(
        "eq17",
        "Sec. IV-B",
        "numerator of the closed loop",
        (
            r"n(z) = ((c_2 + c_3 - 2)c_1 - (c_2 - c_3)\delta)z \br "
            r"+ (c_2 + c_3 - 2e^{-\delta})c_1 + (c_2 - c_3)\delta",
        ),
    ),
    Statement(
        "eq18",
        "Sec. IV-B",
        "characteristic polynomial",
        (
            r"p(z) = ((c_3 + c_2 - 2)c_1 + (c_3 - c_2)\delta)(\alpha + \beta) z^2 "
            r"\br + \left( ((c_3 + c_2 - 2e^{-\delta})c_1 + (c_2 - c_3)\delta)\alpha "
            r"\br + \left( 2((1 - e^{-\delta})c_1 + (c_2 - c_3)\delta)\beta \right) \right) z "
            r"\br - 2(z^2 - z(c_3 + c_2) + e^{-\delta})c_1\gamma z^{1+d} "
            r"\br + ((2e^{-\delta} - c_3 - c_2)c_1 + (c_3 - c_2)\delta)\beta",
        ),
        quote="the normalized characteristic polynomial $p(z)$",
    ),
    Statement(
        "eq19",
        "Sec. IV-C",
        "the normalised arm parameters",
        (
            r"\gamma = T^2 \cdot \frac{k_H}{m_D + m_H}",
            r"\delta = T \cdot \frac{b_D + b_H}{m_D + m_H}",
        ),
        quote="the definitions of these two parameters are recalled first",
    ),
    Statement(
        "eq20",
        "Sec. IV-C",
        "bounds without the combined mass",
        (
            r"\gamma < T^2 \cdot \frac{k_H}{m_H}",
            r"\delta < T \cdot \left( \frac{b_D}{m_D} + \frac{b_H}{m_H} \right)",
        ),
        quote="Assuming positive masses and dampers, these definitions can be used to derive the "
        "following two inequalities:",
    ),
    Statement(
        "eq21",
        "Sec. IV-C",
        "largest ratios of Table II without Kuchenbecker et al.",
        (
            r"\frac{k_H}{m_H} \leq 710 \text{ s}^{-2}",
            r"\frac{b_H}{m_H} \leq 14.6 \text{ s}^{-1}",
        ),
        quote="For all the other values holds",
    ),
    Statement(
        "eq22",
        "Sec. IV-C",
        "limits of the normalised parameters",
        (
            r"0 \leq \gamma < T^2 \cdot 710 \text{ s}^{-2}",
            r"0 \leq \delta < T \cdot 15.225 \text{ s}^{-1}",
        ),
        quote="the following limits for the normalized parameters can be stated:",
    ),
    Statement(
        "eq23",
        "Sec. IV-C",
        "parameter ranges considered",
        (
            r"0 \leq \gamma \leq 1 \times 10^{-3}",
            r"0 \leq \delta \leq 20 \times 10^{-3}",
        ),
        quote="the following parameter ranges will be considered",
    ),
    Statement(
        "eq24",
        "Sec. IV-E",
        "linear stability condition",
        (r"K < \frac{b + B}{t_d + T/2}",),
        quote="This criterion yields the linear stability condition as",
    ),
    Statement(
        "eq25",
        "Sec. IV-E",
        "linear stability condition, normalised",
        (r"\beta + \delta > \alpha \left( \frac{1}{2} + d \right)",),
        quote="it can be also expressed by normalized parameters",
    ),
    Statement(
        "eq26",
        "Sec. IV-E",
        "relative error of the linear condition",
        (r"\left| \frac{\alpha_{\text{lin}} - \alpha}{\alpha + \gamma} \right|",),
        quote="the relative error of the linear condition, defined by",
    ),
    Statement(
        "eq27",
        "Sec. V-A",
        "explicit passivity boundary, normalised",
        (
            r"\begin{pmatrix} \alpha \\ \beta \end{pmatrix} = \delta \cdot \begin{pmatrix} "
            rf"2(d+1) {_FRACTIONS_27[0]} \\ 2 {_FRACTIONS_27[1]} \end{{pmatrix}}",
        ),
        r"0 < \hat{\omega} < \pi",
        quote="the explicit representation of the passivity boundaries (7) becomes",
    ),
    Statement(
        "eq28",
        "Sec. V-C",
        "frequency of the damped oscillation",
        (r"\omega = \sqrt{\frac{k}{m} - \frac{b^2}{4m^2}}",),
        r"k > \frac{b^2}{4m}",
        quote="The physical stiffness is influencing the oscillation frequency",
    ),
    Statement(
        "eq29",
        "Sec. V-C",
        "the same in normalised parameters",
        (r"\omega = \frac{\sqrt{\gamma - \delta^2/4}}{T}",),
        quote="Substituting the physical by the normalized parameters yields",
    ),
    Statement(
        "eq30",
        "Sec. V-C",
        "oscillation up to the Nyquist frequency",
        (r"\gamma - \delta^2/4 \leq \pi^2",),
        quote="this section investigates the stability of the haptic system for frequencies up to"
        " the Nyquist frequency",
    ),
    Statement(
        "eq31",
        "Sec. V-C, Example 5.1",
        "stiffness that reaches the Nyquist frequency",
        (r"k = \pi^2 m/T^2 + b^2/4m \approx 987\,000 \text{ N/m}",),
        r"m = 0.1\text{ kg},\ T = 0.001\text{ s}",
        reading=(r"k = \pi^2 m/T^2 + b^2/4m",),
        quoted=(Quoted("about", "987e3"),),
        quote="a physical stiffness of [...] would be necessary, without considering mass of the "
        "human arm",
    ),
)
