"""What the named predicates mean of a sampled device: its four numbers n1, n0, a and e."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation import a, delta, e, gamma, n_0, n_1
from symhaptic.notation.proposition import (
    And,
    Exists,
    Iff,
    Implies,
    Predicate,
    Relation,
    term,
)
from symhaptic.proof.certificate import Positive
from symhaptic.proof.plants import AT_ONE, LOSS, TOGETHER, Named
from symhaptic.proof.theorems.definedness import conditions, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, Theorem, rule, whole
from symhaptic.proof.theorems.leaves import on_certificate


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
def on_plants(certificate: Positive) -> Judgement:
    """0 < f on a box of plants, f being made of their numbers n1, n0, a and e and of other symbols.

    The certificate's balls are those of exp of the device's matrix (:mod:`symhaptic.proof.plants`)
    for each piece of gamma and delta; it is checked again.
    """
    given = certificate.given if isinstance(certificate, Positive) else None
    if type(given) is not Named:
        raise NotShown("a certificate of a box of plants is wanted")
    plant = {LOSS: 1 - e, TOGETHER: n_1 + n_0, AT_ONE: 1 - a + e}
    numbers = {gamma, delta, n_1, n_0, a, e}
    meanings = {s: term(m).xreplace(plant) for s, m in given.meanings.items()}
    if set(certificate.box) & (numbers - {gamma, delta} | set(meanings)):
        raise NotShown("a number of the plant is no side of the box")
    expr = term(certificate.expr).xreplace(meanings)
    allowed = set(certificate.box) | numbers
    if not {gamma, delta} <= set(certificate.box) or not expr.free_symbols <= allowed:
        raise NotShown(f"{expr} is not made of the plant's numbers and the sides of the box")
    device = Predicate("device", (), (gamma, delta, n_1, n_0, a, e))
    fresh = replace(certificate, given=Named(dict(given.meanings)))
    ends, claim = on_certificate(fresh, expr)
    return {device, *ends}, claim


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
