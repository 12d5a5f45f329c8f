"""What the named predicates mean: the physics that a proposition about a wall stands for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.model.loop import characteristic
from symhaptic.notation import alpha, beta, d, delta, gamma, z
from symhaptic.notation.proposition import (
    And,
    Exists,
    Iff,
    Implies,
    Not,
    Predicate,
    Proposition,
    Relation,
    term,
)
from symhaptic.proof.ball import sign
from symhaptic.proof.theorems.definedness import conditions, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, Theorem, rule, whole
from symhaptic.scene import Parts


@rule
def whole_delay(wall: Sequence[Any], variable: Symbol) -> Judgement:
    """Behind whole delays d the wall's force is (K + B (z-1)/(Tz)) z^-d x, held.

    A device burns b p^2/T at least while it moves by p within a period, at constant speed, and the
    held force works F p: Colgate and Schenkel, J. Robot. Syst. 14(1), 1997.
    """
    K, B, b, T, late = (term(t) for t in wall)
    if any(variable in t.free_symbols for t in (K, B, b, T, late)):
        raise NotShown(f"{variable} is bound")
    response = (K + B * (variable - 1) / (T * variable)) * variable**-late
    sampled = Predicate("passive", (variable,), (response, b / T))
    period = Relation(sp.S.Zero, "<", T)
    return {whole(late), period}, Iff((Predicate("passive_wall", (), (K, B, b, T, late)), sampled))


@rule
def loop(
    values: Sequence[Any], variable: Symbol, stiffness: bool = True, damping: bool = True
) -> Judgement:
    """Behind whole delays a loop is stable where its characteristic polynomial is.

    ``values`` are alpha, beta, gamma, delta and d.  A device without spring or damper is another
    one: its gamma or delta is 0, and its polynomial is made of its own motion.  That the poles of
    the device differ is a hypothesis, as far as its polynomial divides by their difference.
    """
    divisors, zeros = loop_polynomial(values, variable, 1, stiffness, damping)
    found = tuple(term(v) for v in values)
    return divisors | {whole(found[4])}, Iff((Predicate("stable_loop", (), found), zeros))


def loop_polynomial(
    values: Sequence[Any], variable: Symbol, share: Any, stiffness: bool, damping: bool
) -> tuple[set[Proposition], Predicate]:
    """A loop's polynomial in w, with z = w^share, has its zeros inside; and its divisors."""
    found = [term(v) for v in values]
    if any(variable in t.free_symbols for t in found):
        raise NotShown(f"{variable} is bound")
    if (not stiffness and found[2] != 0) or (not damping and found[3] != 0):
        raise NotShown("a part that is not modelled is zero")
    if term(share).is_number and not (term(share).is_Integer and share >= 1):
        raise NotShown(f"{share} is no share of a period")
    polynomial = characteristic(Parts(stiffness=stiffness, damping=damping))
    names = dict(zip((alpha, beta, gamma, delta, d), found, strict=True))
    placed = polynomial.xreplace({s: v for s, v in names.items() if s != v})
    powers = _raised(placed, variable, share)
    # of the variable there are powers only
    divisors = {c for c in conditions(powers) if variable not in c.free}
    return divisors, Predicate("stable", (variable,), (powers,))


def _raised(expr: Expr, variable: Symbol, share: Any) -> Expr:
    """With variable^share for z."""
    if expr == z or (expr.is_Pow and expr.args[0] == z):
        return variable ** (share * expr.as_base_exp()[1])
    return expr.func(*(_raised(a, variable, share) for a in expr.args)) if expr.args else expr


@rule
def loop_substituted(
    values: Sequence[Any],
    variable: Symbol,
    share: int,
    stiffness: bool = True,
    damping: bool = True,
) -> Judgement:
    """The paper's reading of a delay of d = p/q periods: the polynomial in w, with z = w^q.

    ``share`` is q; that q d is whole is a hypothesis.
    """
    judged = loop_polynomial(values, variable, int(share), stiffness, damping)
    late = term(values[4])
    return judged[0] | {whole(share * late)}, Iff(
        (Predicate("stable_substituted", (), tuple(map(term, values))), judged[1])
    )


@rule
def gains(wall: Sequence[Any], motion: Sequence[tuple[Any, Any]]) -> Judgement:
    """A motion at constant speeds, (time in periods, displacement) piece by piece, gains energy.

    Times and ways are rational, K, B and b real numbers: over each piece the damper burns
    b p^2/(duration T), and the wall takes F p with the force that is held then,
    K x + B (x - x')/T of the sample d periods before.
    """
    K, B, b, T, late = (term(t) for t in wall)
    pieces = [(sp.Rational(duration), sp.Rational(way)) for duration, way in motion]
    if not (T.is_Rational and late.is_Rational) or T <= 0 or late < 0:
        raise NotShown("a rational period T > 0 and delay d >= 0 are wanted")
    if any(v.free_symbols or not real(v) for v in (K, B, b)) or sign(b) not in (0, 1):
        raise NotShown("a wall in real numbers is wanted, with b >= 0")
    if any(duration <= 0 for duration, _ in pieces):
        raise NotShown("a piece takes no time")
    ends, places = [sp.S.Zero], [sp.S.Zero]
    for duration, way in pieces:
        ends.append(ends[-1] + duration)
        places.append(places[-1] + way)

    def position(time: Expr) -> Expr:
        if time <= 0:
            return sp.S.Zero
        i = next((i for i, end in enumerate(ends) if end >= time), None)
        if i is None:
            return places[-1]
        share = (time - ends[i - 1]) / (ends[i] - ends[i - 1])
        return places[i - 1] + share * (places[i] - places[i - 1])

    energy = sp.S.Zero
    for i, (duration, way) in enumerate(pieces):
        begin, end = ends[i], ends[i + 1]
        energy += b * way**2 / (duration * T)
        k = sp.floor(begin - late)
        while k + late < end:
            here, before = position(k), position(k - 1)
            force = K * here + B * (here - before) / T
            first, last = max(begin, k + late), min(end, k + 1 + late)
            energy += force * (position(last) - position(first))
            k += 1
    if sign(energy) != -1:
        raise NotShown(f"the motion leaves the energy {energy}")
    return (), Not((Predicate("passive_wall", (), (K, B, b, T, late)),))


@rule
def loop_of_device(numbers: Sequence[Any], values: Sequence[Any], variable: Symbol) -> Judgement:
    """With the numbers of its device a loop is stable where z^(d+1) A + N W is.

    W = (alpha + beta) z - beta, A = z^2 - a z + e and N = n1 z + n0.  The paper's
    reading of the delay and the exact one agree where it is whole.
    """
    found = [term(v) for v in values]
    n1, n0, a_, e_ = (term(v) for v in numbers)
    if any(variable in t.free_symbols for t in (*found, n1, n0, a_, e_)):
        raise NotShown(f"{variable} is bound")
    stiffness, damping, spring, damper, late = found
    polynomial = variable ** (late + 1) * (variable**2 - a_ * variable + e_) + (
        n1 * variable + n0
    ) * ((stiffness + damping) * variable - damping)
    device = Predicate("device", (), (spring, damper, n1, n0, a_, e_))
    zeros = Predicate("stable", (variable,), (polynomial,))
    named = [Predicate(name, (), tuple(found)) for name in ("stable_loop", "stable_substituted")]
    return {device, whole(late)}, And(tuple(Iff((one, zeros)) for one in named))


@rule
def loop_late(
    numbers: Sequence[Any], values: Sequence[Any], variable: Symbol, names: Sequence[Symbol]
) -> Judgement:
    """A loop that is stable as the paper reads it has a delay d = p/(s+1), p and s whole.

    Then all zeros of z^(d+1) A + N W with z = w^(s+1) lie inside; for 0 <= d.
    """
    found = [term(v) for v in values]
    n1, n0, a_, e_ = (term(v) for v in numbers)
    used = {s for t in (*found, n1, n0, a_, e_) for s in t.free_symbols}
    if len(set(names)) != 2 or {variable, *names} & used or variable in names:
        raise NotShown("two new names, and a variable that is not bound, are wanted")
    stiffness, damping, spring, damper, late = found
    over, less = names
    w = variable ** (less + 1)
    polynomial = (
        variable ** (over + 3 * (less + 1))
        - a_ * variable ** (over + 2 * (less + 1))
        + e_ * variable ** (over + less + 1)
        + (n1 * w + n0) * ((stiffness + damping) * w - damping)
    )
    body = And(
        (
            whole(over),
            whole(less),
            Relation(late * (less + 1), "=", over),
            Predicate("stable", (variable,), (polynomial,)),
        )
    )
    device = Predicate("device", (), (spring, damper, n1, n0, a_, e_))
    reading = Predicate("stable_substituted", (), tuple(found))
    return {device, Relation(sp.S.Zero, "<=", late)}, Implies((reading, Exists(tuple(names), body)))


@rule
def device_exists(spring: Any, damper: Any, names: Sequence[Symbol]) -> Judgement:
    """A device x'' + delta x' + gamma x = F has its four numbers, for all real gamma and delta."""
    gamma_, delta_ = term(spring), term(damper)
    if not (real(gamma_) and real(delta_)) or len(set(names)) != 4:
        raise NotShown("two real numbers and four names are wanted")
    if set(names) & (gamma_.free_symbols | delta_.free_symbols):
        raise NotShown("a name is taken")
    return conditions(gamma_, delta_), Exists(
        tuple(names), Predicate("device", (), (gamma_, delta_, *names))
    )


@rule
def device_at_rest(device: Theorem) -> Judgement:
    """1 - a + e = gamma (n1 + n0), for a held unit force rests at 1/gamma; e = exp(-delta).

    A held force pushes a device with a damper forwards: 0 < n1 + n0 for 0 <= gamma, 0 < delta.
    """
    gamma_, delta_, n1, n0, a_, e_ = device_numbers(device)
    damped = {Relation(sp.S.Zero, "<=", gamma_), Relation(sp.S.Zero, "<", delta_)}
    return device.hypotheses | damped, And(
        (
            Relation(1 - a_ + e_, "=", gamma_ * (n1 + n0)),
            Relation(sp.S.Zero, "<", n1 + n0),
            Relation(e_, "=", sp.exp(-delta_)),
        )
    )


@rule
def device_static(device: Theorem) -> Judgement:
    """1 - a + e = gamma (n1 + n0), of every device: under the force gamma it stays at x = 1."""
    gamma_, _, n1, n0, a_, e_ = device_numbers(device)
    return device.hypotheses, Relation(1 - a_ + e_, "=", gamma_ * (n1 + n0))


@rule
def device_comes_to_rest(device: Theorem, variable: Symbol) -> Judgement:
    """A device with damper and spring forgets its state: all zeros of A lie inside.

    They are exp(s) for the zeros s of s^2 + delta s + gamma, which have negative real parts.
    """
    gamma_, delta_, _, _, a_, e_ = device_numbers(device)
    if any(variable in t.free_symbols for t in (gamma_, delta_, a_, e_)):
        raise NotShown(f"{variable} is bound")
    held = {Relation(sp.S.Zero, "<", gamma_), Relation(sp.S.Zero, "<", delta_)}
    poles = Predicate("stable", (variable,), (variable**2 - a_ * variable + e_,))
    return device.hypotheses | held, poles


def device_numbers(device: Theorem) -> tuple[Expr, ...]:
    """gamma, delta, n1, n0, a and e of which a theorem says that they belong together."""
    claim = device.conclusion
    if not (isinstance(claim, Predicate) and claim.name == "device"):
        raise NotShown(f"{claim} is about no device")
    return claim.of


@rule
def swinging(device: Sequence[Any], rate: Symbol) -> Judgement:
    """x = exp(sigma t) sin(omega t) obeys Newton's law where both its parts vanish.

    ``device`` is m, b, k and omega; m x'' + b x' + k x is exp(sigma t) times a sine and a cosine.
    """
    mass, damping, stiffness, frequency = found = tuple(term(t) for t in device)
    if not all(map(real, found)) or any(rate in t.free_symbols for t in found):
        raise NotShown(f"four real terms without {rate} are wanted")
    sine = mass * (rate**2 - frequency**2) + damping * rate + stiffness
    cosine = 2 * mass * rate * frequency + damping * frequency
    parts = And((Relation(sine, "=", sp.S.Zero), Relation(cosine, "=", sp.S.Zero)))
    apart = Relation(frequency, "!=", sp.S.Zero)
    return conditions(*found) | {apart}, Iff(
        (Predicate("swings", (), found), Exists((rate,), parts))
    )
