"""Closed propositions that are accepted without a proof, each with its source.

Elementary mathematics comes first, then what the named predicates mean for a held force and for a
sampled device.  Symbols are real, but for z, s, X and c, which are complex.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from sympy import Abs, Expr, I, Rational, Symbol, atan, cos, cosh, exp, pi, sin, sinh, sqrt, symbols

from symhaptic import notation as n
from symhaptic.notation.proposition import (
    And,
    Exists,
    ForAll,
    Iff,
    Not,
    Or,
    Predicate,
    Proposition,
    Relation,
    both,
    implied,
    whole,
)
from symhaptic.notation.terms import term
from symhaptic.proof.theorems.kernel import Judgement, NotShown, rule


@dataclass(frozen=True)
class Axiom:
    """A closed proposition and where it is from."""

    says: Proposition
    source: str


_AXIOMS: dict[str, Axiom] = {}
AXIOMS: Mapping[str, Axiom] = MappingProxyType(_AXIOMS)
"""All of them by name."""


@rule
def known(name: str) -> Judgement:
    """The proposition of an axiom."""
    if name not in AXIOMS:
        raise NotShown(f"{name!r} is no axiom; {', '.join(AXIOMS)} are")
    return (), AXIOMS[name].says


def _believed(
    name: str, source: str, over: Sequence[Symbol], given: Sequence[Proposition], *then: Proposition
) -> None:
    _AXIOMS[name] = Axiom(ForAll(tuple(over), implied(given, both(then))), source)


def _lt(left: Any, right: Any) -> Relation:
    return Relation(left, "<", right)


def _le(left: Any, right: Any) -> Relation:
    return Relation(left, "<=", right)


def _eq(left: Any, right: Any) -> Relation:
    return Relation(left, "=", right)


def _ne(left: Any, right: Any) -> Relation:
    return Relation(left, "!=", right)


# -- order and elementary functions ----------------------------------------------------

x, y, p, q, u, f = symbols("x y p q u f")
z, s, X = n.z, n.s, n.X
_R = "Rudin, Principles of Mathematical Analysis, 3rd ed., "

_believed("square", _R + "1.18", [x], [], _le(0, x**2))
_believed("quotient", _R + "1.18", [x, y], [_lt(0, x), _lt(0, y)], _lt(0, x / y))
_believed("weak quotient", _R + "1.18", [x, y], [_le(0, x), _lt(0, y)], _le(0, x / y))
_believed("order", _R + "1.5", [x, y], [], Or((_lt(x, y), _le(y, x))))
_believed("equality", "excluded middle", [s, z], [], Or((_eq(s, z), _ne(s, z))))
_believed("strictly", _R + "1.5", [x, y], [_le(x, y), _ne(x, y)], _lt(x, y))
_believed("both ways", _R + "1.5", [x, y], [_le(x, y), _le(y, x)], _eq(x, y))
_believed("sin", _R + "8.7", [x], [_lt(0, x), _lt(x, pi)], _lt(0, sin(x)))
_believed("cos", _R + "8.7", [x], [_lt(-pi / 2, x), _lt(x, pi / 2)], _lt(0, cos(x)))
_believed("exp", _R + "8.6", [x], [], _lt(0, exp(x)))
_believed("cosh", _R + "8.6", [x], [], _le(1, cosh(x)))
_believed("sqrt", _R + "1.21", [x], [_le(0, x)], _le(0, sqrt(x)))
_believed("Abs", _R + "1.33", [x], [], _le(0, Abs(x)))
_believed("size", _R + "1.33", [x], [_le(0, x)], _eq(Abs(x), x))
_believed("opposite size", _R + "1.33", [x], [_le(x, 0)], _eq(Abs(x), -x))
_believed("sin bounded", _R + "8.7", [x], [], _le(sin(x) ** 2, 1))
_believed("cos bounded", _R + "8.7", [x], [], _le(cos(x) ** 2, 1))
for _f in (exp, sinh, atan):
    _believed(f"{_f.__name__} rises", _R + "5.11", [x, y], [_lt(x, y)], _lt(_f(x), _f(y)))
_quarter = [_lt(x, y), _le(-pi / 2, x), _le(y, pi / 2)]
_believed("sin rises", _R + "5.11", [x, y], _quarter, _lt(sin(x), sin(y)))
_half = [_lt(x, y), _le(0, x), _le(y, pi)]
_believed("cos falls", _R + "5.11", [x, y], _half, _lt(cos(y), cos(x)))

_right = And((_lt(0, p), _lt(-pi / 2, q), _lt(q, pi / 2), _eq(x, p * cos(q)), _eq(y, p * sin(q))))
_believed("polar", _R + "8.7", [x, y], [_lt(0, x)], Exists((p, q), _right))

_believed("not negative", "Peano", [x], [whole(x)], _le(0, x))
_same = (_eq(g(x + 2 * pi * p), g(x)) for g in (sin, cos))
_believed("full turns", _R + "8.7", [x, p], [whole(p)], *_same)
_between = And((whole(p), _le(p * y, x), _lt(x, (p + 1) * y)))
_believed("rest", _R + "1.20", [x, y], [_le(0, x), _lt(0, y)], Exists((p,), _between))

# -- what the predicates mean for walls and devices ------------------------------------

K, B, T, b, d, m, k, t_d = n.K, n.B, n.T, n.b, n.d, n.m, n.k, n.t_d
ell, epsilon = n.l, n.epsilon
alpha, beta, gamma, delta, theta = n.alpha, n.beta, n.gamma, n.delta, n.theta
n_1, n_0, a, e = NUMBERS = n.n_1, n.n_0, n.a, n.e
LOOP, WALL = (alpha, beta, gamma, delta, d), (K, B, b, T, d)
DEVICE = Predicate("device", (), (gamma, delta, *NUMBERS))
_damped, _sprung = _lt(0, delta), _le(0, gamma)
_A, _N = z**2 - a * z + e, n_1 * z + n_0


def _named(name: str, *of: Any, over: tuple[Symbol, ...] = ()) -> Predicate:
    return Predicate(name, over, of)


def _stable(polynomial: Expr) -> Predicate:
    return Predicate("stable", (z,), (polynomial,))


_believed("linear", "definition of a zero", [x], [_lt(-1, x), _lt(x, 1)], _stable(z - x))
_believed(
    "passive wall",
    "for a given displacement a damper dissipates least at constant speed, and the force is held; "
    "Colgate and Schenkel, J. Robot. Syst. 14(1), 1997",
    WALL,
    [whole(d), _lt(0, T)],
    Iff(
        (
            _named("passive_wall", *WALL),
            _named("passive", (K + B * (z - 1) / (T * z)) * z**-d, b / T, over=(z,)),
        )
    ),
)
_taps = (1 - epsilon) * z**-ell + epsilon * z ** (-ell - 1)
_off = epsilon * (1 - epsilon)
_believed(
    "passive late wall",
    "p is the displacement while one force is held, and q the deviation from a motion at constant "
    "speed at the time of its sample: the damper dissipates at least b p^2/T + b q^2/(T "
    "epsilon (1 - epsilon)), and the wall absorbs p H z^(-l-1) (x + (1 - epsilon) p + q); the sum "
    "is minimised over q",
    [K, B, b, T, ell, epsilon],
    [whole(ell), _lt(0, T), _lt(0, b), _le(0, epsilon), _le(epsilon, 1)],
    Iff(
        (
            _named("passive_wall", K, B, b, T, ell + epsilon),
            _named(
                "passive",
                (K + B * (z - 1) / (T * z)) * _taps
                + _off * B * (K * T + B) / (2 * b * T) * (1 - 1 / z),
                b / T - _off * ((K * T + B) ** 2 + B**2) / (4 * b * T),
                over=(z,),
            ),
        )
    ),
)
_polynomial = z ** (d + 1) * _A + _N * ((alpha + beta) * z - beta)
_believed(
    "loop of a device",
    "z^(d+1) A + N W; for integer delays the paper's reading and the exact one agree",
    [*LOOP, *NUMBERS],
    [DEVICE, whole(d)],
    *(
        Iff((_named(reading, *LOOP), _stable(_polynomial)))
        for reading in ("stable_loop", "stable_substituted")
    ),
)
_w = z ** (q + 1)
_late = (
    z ** (p + 3 * (q + 1))
    - a * z ** (p + 2 * (q + 1))
    + e * z ** (p + q + 1)
    + (n_1 * _w + n_0) * ((alpha + beta) * _w - beta)
)
_believed(
    "loop as the paper reads it",
    "a delay of d = p/(q+1) periods, with z = w^(q+1)",
    [*LOOP, *NUMBERS],
    [DEVICE, _le(0, d), _named("stable_substituted", *LOOP)],
    Exists((p, q), And((whole(p), whole(q), _eq(d * (q + 1), p), _stable(_late)))),
)
_believed(
    "loop in w",
    "definition of the paper's reading; for a fraction that is not in lowest terms the polynomial "
    "contains only powers of w^g, and has the same zeros w^g",
    [*LOOP, *NUMBERS, p, q],
    [DEVICE, whole(p), whole(q), _eq(d * (q + 1), p)],
    Iff((_named("stable_substituted", *LOOP), _stable(_late))),
)
_v = x + I * y
_believed(
    "half a period on the principal sheet",
    "the principal root of z is the v with z = v^2 and Re v > 0, and z^d = v^(2 d)",
    [alpha, beta, gamma, delta, ell, *NUMBERS],
    [DEVICE, whole(ell)],
    Iff(
        (
            _named("stable_principal", alpha, beta, gamma, delta, ell + Rational(1, 2)),
            ForAll(
                (x, y),
                implied(
                    [_lt(0, x), _le(1, x**2 + y**2)],
                    _ne(
                        _v ** (2 * ell + 3) * (_v**4 - a * _v**2 + e)
                        + (n_1 * _v**2 + n_0) * ((alpha + beta) * _v**2 - beta),
                        0,
                    ),
                ),
            ),
        )
    ),
)
_believed(
    "held by a pole",
    "in the paper's reading no pole of a stable loop has z^2 >= 1",
    [*LOOP, x],
    [_named("pole", *LOOP, x), _le(1, x**2)],
    Not((_named("stable_substituted", *LOOP),)),
)
_believed(
    "swings",
    "Newton's law for exp(sigma t) sin(omega t): its sine and cosine terms vanish",
    [m, b, k, n.omega],
    [_ne(n.omega, 0)],
    Iff(
        (
            _named("swings", m, b, k, n.omega),
            Exists(
                (x,),
                And(
                    (
                        _eq(m * (x**2 - n.omega**2) + b * x + k, 0),
                        _eq(2 * m * x * n.omega + b * n.omega, 0),
                    )
                ),
            ),
        )
    ),
)
_believed(
    "device",
    "a linear differential equation has one solution for each initial state",
    [gamma, delta],
    [],
    Exists(NUMBERS, DEVICE),
)
_numbers = [gamma, delta, *NUMBERS]
_static = _eq(1 - a + e, gamma * (n_1 + n_0))
_believed(
    "device at rest",
    "x = 1 is the equilibrium under the constant force gamma",
    _numbers,
    [DEVICE],
    _static,
)
_believed("device's loss", "det exp X = exp tr X", _numbers, [DEVICE], _eq(e, exp(-delta)))
_believed(
    "device pushed",
    "a held force moves a damped device in its own direction",
    _numbers,
    [DEVICE, _sprung, _damped],
    _lt(0, n_1 + n_0),
)
_believed(
    "device forgets",
    "its poles are exp s with s^2 + delta s + gamma = 0, and Re s < 0",
    _numbers,
    [DEVICE, _lt(0, gamma), _damped],
    _stable(_A),
)
_believed(
    "undamped device",
    "cos and sin of x t solve y'' + x^2 y = 0; the motion can be reversed in time",
    [x, *NUMBERS],
    [_named("device", x**2, 0, *NUMBERS)],
    _eq(a, 2 * cos(x)),
    _eq(n_1, n_0),
)
_believed(
    "free mass",
    "t^2/2 is its displacement under the force 1",
    [*NUMBERS],
    [_named("device", 0, 0, *NUMBERS)],
    _eq(n_1, Rational(1, 2)),
)
_believed(
    "device turns",
    "its poles are exp(-delta/2) times exp c and exp(-c), with c real or c = j w, w < pi",
    _numbers,
    [DEVICE, _lt(gamma - delta**2 / 4, pi**2)],
    _lt(-2 * exp(-delta / 2), a),
)
_turn = exp(I * theta)
_way = (_turn - 1) * (n_1 * _turn + n_0)
_work = _way * (_turn**-2 - a / _turn + e)


def _mirror(of: Expr) -> Expr:
    return of.xreplace({I: -I})


_believed(
    "held steady state",
    "the damper dissipates the work of the force in each period: more than delta p^2 with "
    "p = (z-1) F N/A, since the speed is not constant; Newton's law and the Schwarz inequality, "
    + _R
    + "11.35",
    [*_numbers, theta],
    [DEVICE, _sprung, _damped, _lt(0, theta), _le(theta, pi)],
    _lt(delta * _way * _mirror(_way), (_work + _mirror(_work)) / 2),
)

# -- devices whose force is delayed by a fraction of a period ---------------------------

m_2, m_1, m_0 = LATE_NUMBERS = n.m_2, n.m_1, n.m_0
LATE_DEVICE = Predicate("late_device", (), (gamma, delta, epsilon, *LATE_NUMBERS, a, e))
_M = m_2 * z**2 + m_1 * z + m_0
_late_numbers = [gamma, delta, epsilon, *LATE_NUMBERS, *NUMBERS]
_fraction = [_le(0, epsilon), _le(epsilon, 1)]


def _equal(*pairs: tuple[Any, Any]) -> And:
    return And(tuple(_eq(*pair) for pair in pairs))


_believed(
    "late device",
    "a linear differential equation has one solution for each initial state",
    [gamma, delta, epsilon],
    _fraction,
    Exists((*LATE_NUMBERS, *NUMBERS), And((LATE_DEVICE, DEVICE))),
)
_believed(
    "late device and device",
    "a constant force moves the device as it does without delay; the delays 0 and 1 change the "
    "force at a sample",
    _late_numbers,
    [LATE_DEVICE, DEVICE],
    _eq(m_2 + m_1 + m_0, n_1 + n_0),
    implied([_eq(epsilon, 0)], _equal((m_2, n_1), (m_1, n_0), (m_0, 0))),
    implied([_eq(epsilon, 1)], _equal((m_2, 0), (m_1, n_1), (m_0, n_0))),
)
_believed(
    "undamped late device",
    "1 - cos x t is the motion under the force x^2",
    [x, epsilon, *LATE_NUMBERS, a, e],
    [_named("late_device", x**2, 0, epsilon, *LATE_NUMBERS, a, e)],
    _eq(x**2 * m_2, 1 - cos(x * (1 - epsilon))),
    _eq(x**2 * (m_1 + (1 + a) * m_2), 1 - cos(x * (2 - epsilon))),
)
_believed(
    "free late mass",
    "t^2/2 is its displacement under the force 1",
    [epsilon, *LATE_NUMBERS, a, e],
    [_named("late_device", 0, 0, epsilon, *LATE_NUMBERS, a, e)],
    _eq(m_2, (1 - epsilon) ** 2 / 2),
    _eq(m_1 + (1 + a) * m_2, (2 - epsilon) ** 2 / 2),
)
_believed(
    "loop of a late device",
    "z^(l+2) A + M W: the state consists of that of the device and of the delayed forces",
    [alpha, beta, gamma, delta, ell, epsilon, *LATE_NUMBERS, a, e],
    [LATE_DEVICE, whole(ell), *_fraction],
    Iff(
        (
            _named("stable_loop", alpha, beta, gamma, delta, ell + epsilon),
            _stable(z ** (ell + 2) * _A + _M * ((alpha + beta) * z - beta)),
        )
    ),
)
_off_straight = _M.xreplace({z: _turn}) - (epsilon + (1 - epsilon) * _turn) * (n_1 * _turn + n_0)
_believed(
    "late held steady state",
    "as above, for the time in which one force is held: p is the displacement, and q the deviation "
    "from a motion at constant speed at the time of its sample, after 1 - epsilon; the damper "
    "dissipates more than delta p^2 + delta q^2/(epsilon (1 - epsilon)), since the speed is not "
    "constant in both parts",
    [*_late_numbers, theta],
    [
        *(LATE_DEVICE, DEVICE, _sprung, _damped),
        *(_lt(0, epsilon), _lt(epsilon, 1), _lt(0, theta), _le(theta, pi)),
    ],
    _lt(
        delta * (_off * _way * _mirror(_way) + _off_straight * _mirror(_off_straight)),
        _off * (_work + _mirror(_work)) / 2,
    ),
)

# -- what a held force does at the samples ---------------------------------------------


def transfer(device: Sequence[Any], late: Any, variable: Symbol) -> Expr:
    """exp(-late s)/(m s^2 + b s + k)."""
    mass, damping, stiffness = device
    below = mass * variable**2 + damping * variable + stiffness
    return term(exp(-late * variable) / below)


def answers(response: Any, variable: Symbol, at: Any, answer: Any, period: Any) -> Predicate:
    """A force at^k that is held in period k is answered by the position answer at^k at sample k."""
    return Predicate("answers", (variable,), (response, at, answer, period))


_mbk = (m, b, k)
_here = answers(transfer(_mbk, t_d, s), s, z, X, T)
_believed(
    "units",
    "a change of units, by u for time and by f for force per length",
    [*_mbk, t_d, z, X, T, u, f],
    [_lt(0, u), _ne(f, 0)],
    Iff(
        (
            _here,
            answers(transfer((m / (u**2 * f), b / (u * f), k / f), t_d / u, s), s, z, f * X, T / u),
        )
    ),
)
_believed(
    "later",
    "a force that is delayed by p periods is z^-p times the same force",
    [*_mbk, t_d, z, X, T, p],
    [whole(p)],
    Iff((_here, answers(transfer(_mbk, t_d + p * T, s), s, z, z**-p * X, T))),
)
_believed(
    "amplified",
    "linearity",
    [*_mbk, t_d, z, X, T, u],
    [_ne(u, 0)],
    Iff((_here, answers(u * transfer(_mbk, t_d, s), s, z, u * X, T))),
)
