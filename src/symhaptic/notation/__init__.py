"""How is it written?  Every symbol once, with its unit, its domain and what it means.

The symbols are plain SymPy symbols without assumptions, so that a formula typed with
``sympy.symbols("K B T")`` is the same formula; domains are data, used when a counterexample is
looked for.

* ``latex``, ``term_order``, ``written``: formulas and propositions as LaTeX
* ``units``, ``quantities``: units that a user writes, and numbers with units
* ``proposition``, ``predicates``, ``terms``: the language of claims and theorems
* ``exact``, ``fresh``, ``sizes``: rational numbers, new symbols, the largest floats that are
  allowed
* ``extras``, ``suggest``: optional dependencies, names that were meant

Imports no other room; used by all of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sympy import Symbol
    from sympy.core.function import UndefinedFunction

Dimension = tuple[Fraction, Fraction, Fraction]
"""Exponents of kilogram, metre and second."""


def dimension(kg: int = 0, m: int = 0, s: int = 0) -> Dimension:
    """The dimension kg^a m^b s^c.

    >>> dimension(kg=1, s=-2) == UNITS["N/m"]
    True
    """
    return (Fraction(kg), Fraction(m), Fraction(s))


ONE = dimension()

UNITS: dict[str, Dimension] = {
    "1": ONE,
    "s": dimension(s=1),
    "1/s": dimension(s=-1),
    "kg": dimension(kg=1),
    "m": dimension(m=1),
    "m/s": dimension(m=1, s=-1),
    "N": dimension(kg=1, m=1, s=-2),
    "N/m": dimension(kg=1, s=-2),
    "Ns/m": dimension(kg=1, s=-1),
    "m/N": dimension(kg=-1, s=2),
    "J": dimension(kg=1, m=2, s=-2),
}


@dataclass(frozen=True)
class Notation:
    """One symbol of the paper: spelling in code, LaTeX, unit, domain, meaning.

    ``domain`` is an open or closed interval written as the paper would, or ``"complex"``.
    """

    name: str
    latex: str
    unit: str
    domain: str
    meaning: str

    @property
    def symbol(self) -> Symbol:
        """The SymPy symbol."""
        from sympy import Symbol  # numbers need quantities and names, and no symbols

        return Symbol(self.name)

    @property
    def dimension(self) -> Dimension:
        """The exponents of kg, m and s."""
        return UNITS[self.unit]


_TABLE = [
    # physical, Sec. II
    ("m_D", "m_D", "kg", "positive", "mass of the device"),
    ("b_D", "b_D", "Ns/m", "nonnegative", "viscous damping of the device"),
    ("m_H", "m_H", "kg", "nonnegative", "mass of the human arm"),
    ("b_H", "b_H", "Ns/m", "nonnegative", "viscous damping of the human arm"),
    ("k_H", "k_H", "N/m", "nonnegative", "stiffness of the human arm"),
    ("m", "m", "kg", "positive", "moving mass, device and arm together"),
    ("b", "b", "Ns/m", "nonnegative", "physical damping, device and arm together"),
    ("k", "k", "N/m", "nonnegative", "physical stiffness, that of the arm"),
    ("K", "K", "N/m", "real", "stiffness of the virtual wall"),
    ("B", "B", "Ns/m", "real", "damping of the virtual wall"),
    ("T", "T", "s", "positive", "sampling period"),
    ("t_d", "t_d", "s", "nonnegative", "time delay in the loop"),
    ("d", "d", "1", "nonnegative", "delay in sampling periods, t_d/T"),
    ("t", "t", "s", "nonnegative", "time"),
    ("t_e", "t_e", "s", "positive", "effective delay, t_d + T/2"),
    ("x", "x", "m", "real", "position"),
    ("v", "v", "m/s", "real", "velocity"),
    ("F", "F", "N", "real", "force of the virtual wall"),
    ("F_E", "F_E", "N", "real", "external force"),
    ("X", "X", "m/N", "complex", "response of the device: a held force z^k moves it to X z^k"),
    ("X_d", "X_d", "m/N", "complex", "its response to a force that is delayed by d periods"),
    # parts beyond the paper's loop
    ("f_v", "f_v", "1", "[0, 1]", "pole of the filter of the velocity"),
    ("tau_f", r"\tau_f", "s", "nonnegative", "time constant of the filter of the velocity"),
    ("m_v", "m_v", "kg", "real", "virtual mass"),
    ("Delta_x", r"\Delta_x", "m", "positive", "resolution of the encoder"),
    ("f_c", "f_c", "N", "nonnegative", "Coulomb friction of the device"),
    ("tau_a", r"\tau_a", "s", "positive", "time constant of the actuator"),
    # transforms and frequencies
    ("s", "s", "1/s", "complex", "Laplace variable"),
    ("z", "z", "1", "complex", "variable of the z-transform"),
    ("omega", r"\omega", "1/s", "positive", "angular frequency"),
    ("omega_N", r"\omega_N", "1/s", "positive", "Nyquist frequency, pi/T"),
    ("theta", r"\theta", "1", "(0, pi)", "angle on the unit circle, omega T"),
    ("omega_hat", r"\hat{\omega}", "1", "(0, pi)", "normalised frequency, omega T"),
    ("phi", r"\varphi", "1", "(0, pi)", "phase over a delay and one period more, (d+1) theta"),
    # dimensionless, Table I
    ("alpha", r"\alpha", "1", "real", "virtual stiffness, K T^2/m"),
    ("beta", r"\beta", "1", "real", "virtual damping, B T/m"),
    ("gamma", r"\gamma", "1", "nonnegative", "physical stiffness, k T^2/m"),
    ("delta", r"\delta", "1", "nonnegative", "physical damping, b T/m"),
    # abbreviations of Sec. IV
    ("c_1", "c_1", "1", "complex", "difference of the plant's poles, times T"),
    ("c_2", "c_2", "1", "complex", "image of the plant's faster pole"),
    ("c_3", "c_3", "1", "complex", "image of the plant's slower pole"),
    ("y", "y", "1", "[0, 1]", "position along the linear part of the passivity boundary"),
    ("T_s", "T_s", "s", "positive", "a subscripted T that the paper prints once"),
    ("alpha_lin", r"\alpha_{\text{lin}}", "1", "real", "limit of the linear condition"),
    ("second", r"\mathrm{s}", "s", "positive", "the unit second"),
    ("newton_per_metre", r"\mathrm{N/m}", "N/m", "positive", "the unit newton per metre"),
    # of our own
    ("p_k", "p_k", "m", "real", "displacement during period k"),
    ("q_k", "q_k", "m", "real", "how far a sample within period k lies off the straight line"),
    ("l", r"\ell", "1", "nonnegative", "integer part of a delay, in periods"),
    ("epsilon", r"\varepsilon", "1", "[0, 1]", "rest of a delay, a fraction of a period"),
    ("m_2", "m_2", "1", "real", "first sample of the response to a force with a fractional delay"),
    ("m_1", "m_1", "1", "real", "second coefficient of the numerator with a fractional delay"),
    ("m_0", "m_0", "1", "real", "third coefficient of the numerator with a fractional delay"),
    ("d_1", "d_1", "1", "nonnegative", "delay between wall and device"),
    ("d_2", "d_2", "1", "nonnegative", "delay between device and wall"),
    ("N", "N", "1", "positive", "twice the periods of a delay and one more, 2(d+1)"),
    ("psi", r"\psi", "1", "(0, pi/2)", "half of the angle, theta/2"),
    ("tau", r"\tau", "1", "positive", "tangent of half the angle, tan(theta/2)"),
    ("s_1", "s_1", "1", "nonnegative", "first coefficient of 1/P at z = 1"),
    ("s_2", "s_2", "1", "nonnegative", "second coefficient of 1/P at z = 1"),
    ("nu", r"\nu", "1", "real", "share of the second coefficient, n_0/(n_1 + n_0)"),
    ("rho", r"\rho", "1", "positive", "largest stable alpha of a free mass, over 4"),
    ("h", "h", "1", "positive", "1/(d+1), or a small scale"),
    ("w", "w", "1", "real", "wall by damping of the device, (B + K T/2)/b"),
    ("r", "r", "1", "positive", "required damping of a wall at one angle, at its worst phase"),
    ("kappa", r"\kappa", "1", "(0, pi/2)", "phase of a wall at one angle"),
    ("chi", r"\chi", "1", "real", "phase of wall and delay at one angle"),
    ("u", "u", "1", "nonnegative", "stiffness of a wall by damping of the device, K T/(2 b)"),
    ("a", "a", "1", "real", "trace of the sampled plant"),
    ("e", "e", "1", "positive", "determinant of the sampled plant"),
    ("n_1", "n_1", "1", "real", "first sample of the plant's step response"),
    ("n_0", "n_0", "1", "real", "second coefficient of the sampled plant's numerator"),
    ("Omega", r"\Omega", "1", "nonnegative", "undamped angular frequency times T, sqrt(gamma)"),
    ("c", "c", "1", "complex", "difference of the plant's poles, times T, sqrt(delta^2 - 4 gamma)"),
]

SYMBOLS: dict[str, Notation] = {row[0]: Notation(*row) for row in _TABLE}


def __getattr__(name: str) -> Symbol:
    """``from symhaptic.notation import K, B`` gives the SymPy symbols."""
    try:
        return SYMBOLS[name].symbol
    except KeyError:
        raise AttributeError(f"notation has no symbol {name!r}") from None


def function(name: str) -> UndefinedFunction:
    """A function of the paper whose law is left open, such as H(z)."""
    from sympy import Function

    return Function(name)


FUNCTIONS: dict[str, tuple[str, str]] = {
    # name: unit of its value, meaning
    "H": ("N/m", "transfer function of the virtual environment"),
    "P": ("m/N", "transfer function of the device, sampled"),
    "G_x": ("m/N", "closed loop, from external force to position"),
    "n": ("1", "numerator of G_x"),
    "p": ("1", "characteristic polynomial"),
}


@dataclass(frozen=True)
class Normalisation:
    """One row of Table I: a parameter, its variable and its dimensionless counterpart."""

    parameter: str
    variable: str
    dimensionless: str | None
    """LaTeX of the definition as printed, or None where the table has a dash."""


TABLE_I = (
    Normalisation("sampling period", "T", None),
    Normalisation("mass", "m", None),
    Normalisation("delay", "t_d", r"d := t_d / T"),
    Normalisation("virtual stiffness", "K", r"\alpha := KT^2 / m"),
    Normalisation("virtual damping", "B", r"\beta := BT / m"),
    Normalisation("physical stiffness", "k", r"\gamma := kT^2 / m"),
    Normalisation("physical damping", "b", r"\delta := bT / m"),
)
