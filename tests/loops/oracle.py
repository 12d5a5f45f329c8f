"""Loops as matrices: SciPy's exponential of the device, a memory of samples and forces, and
NumPy's eigenvalues.  Nothing here is the package's: no polynomial, no characteristic equation."""

import itertools
import math

import flint
import numpy as np
from scipy.linalg import expm

HALF = math.sqrt(0.5)
"""The damping ratio of Butterworth's filter."""


def device(gamma, delta, lag=None, second=None):
    """A and b of a mass with its parts, position and velocity rows; periods and unit mass."""
    if second is None:
        A = np.array([[0.0, 1.0], [-gamma, -delta]])
        b, x, v = np.array([0.0, 1.0]), np.array([1.0, 0.0]), np.array([0.0, 1.0])
    else:
        mass, k, c, sensor = second
        A = np.zeros((4, 4))
        A[0, 1] = A[2, 3] = 1.0
        A[1] = [-gamma - k, -delta - c, k, c]
        A[3] = np.array([k, c, -k, -c]) / mass
        b, x, v = np.eye(4)[1], np.zeros(4), np.zeros(4)
        at = 0 if sensor == "motor" else 2
        x[at], v[at + 1] = 1.0, 1.0
    if lag is not None:
        n = len(b)
        A = np.block([[A, b[:, None]], [np.zeros((1, n)), np.array([[-1 / lag]])]])
        b = np.append(np.zeros(n), 1 / lag)
        x, v = np.append(x, 0.0), np.append(v, 0.0)
    return A, b, x, v


def under_force(A, b, time):
    """The transition over a time, and what a constant force adds."""
    n = len(b)
    both = expm(np.block([[A, b[:, None]], [np.zeros((1, n + 1))]]) * time)
    return both[:n, :n], both[:n, n]


def matrix(A, b, x, v, K, B, delay, wall, kind, virtual_mass=0.0, euler=None, coupling=None):
    """One period of the closed loop.

    State: the device, then the positions of the last samples, the filter's memory, and the forces
    that are still on their way.  ``wall`` makes the velocity from memory: a function of positions
    (newest first) and filter outputs that returns coefficients; see :func:`velocity`.
    """
    whole, part = int(np.floor(delay)), delay - np.floor(delay)
    if euler is None:
        whole_step, _ = under_force(A, b, 1.0)
        _, early = under_force(A, b, 1.0 - part)
        on, _ = under_force(A, b, 1.0 - part)
        _, begun = under_force(A, b, part)
        late = on @ begun
    else:
        whole_step, early = euler(A, b)
        late = np.zeros(len(b))
    n, past, outs = len(b), kind["past"], kind["outs"]
    forces = whole + 1
    size = n + past + outs + forces
    place = np.zeros(size)
    place[:n] = x
    positions = [place, *np.eye(size)[n : n + past]]
    outputs = list(np.eye(size)[n + past : n + past + outs])
    speed = (
        np.concatenate([v, np.zeros(size - n)]) if kind["measured"] else wall(positions, outputs)
    )
    heavy = positions[0] - 2 * positions[1] + positions[2] if virtual_mass else 0.0
    command = -(K * place + B * speed + virtual_mass * heavy)
    now = command if whole == 0 else np.eye(size)[n + past + outs + whole - 1]
    before = np.eye(size)[n + past + outs + whole]
    step = np.zeros((size, size))
    step[:n] = np.outer(early, now) + np.outer(late, before)
    step[:n, :n] += whole_step
    for k in range(past):
        step[n + k] = positions[k]
    for k in range(outs):
        step[n + past + k] = speed if k == 0 else outputs[k - 1]
    step[n + past + outs] = command
    for k in range(1, forces):
        step[n + past + outs + k] = np.eye(size)[n + past + outs + k - 1]
    return step


def difference_equation(above, below):
    """v_k from differences and its own past: sums of above over below, in powers of 1/z."""

    def wall(positions, outputs):
        differences = [p - q for p, q in itertools.pairwise(positions)]
        found = sum(a * x for a, x in zip(above, differences, strict=False))
        found = found - sum(c * y for c, y in zip(below[1:], outputs, strict=False))
        return found / below[0]

    return wall, {"past": max(2, len(above)), "outs": len(below) - 1, "measured": False}


def low_pass(tau, order, mapping, ratio=HALF):
    """Coefficients in powers of 1/z by substitution into 1/(tau^2 s^2 + 2 D tau s + 1)."""
    z = np.poly1d([1.0, 0.0])
    above, below = (
        (np.poly1d([1.0, -1.0]), z)
        if mapping == "backward Euler"
        else (2 * np.poly1d([1.0, -1.0]), np.poly1d([1.0, 1.0]))
    )
    if order == 1:
        top, bottom = below, tau * above + below
    else:
        top = below * below
        bottom = tau**2 * above * above + 2 * ratio * tau * above * below + below * below
    top = np.append(np.zeros(bottom.order - top.order), top.c)
    return list(top), list(bottom.c)


def euler_steps(kind):
    """x+ and v+ of a simulator."""

    def steps(A, b):
        gamma, delta = -A[1]
        accelerate = np.array([-gamma, 1 - delta])  # v+ = v + (force - delta v - gamma x)
        if kind == "explicit Euler":
            return np.array([[1.0, 1.0], accelerate]), np.array([0.0, 1.0])
        return np.array([accelerate + np.array([1.0, 0.0]), accelerate]), np.array([1.0, 1.0])

    return steps


def sizes(step):
    """Of the eigenvalues; next to the unit circle with more digits, of the entries as they are."""
    found = np.abs(np.linalg.eigvals(step))
    if np.abs(found - 1).min() < 1e-6:
        with flint.ctx.workprec(160):
            roots = flint.acb_mat(step.tolist()).eig(algorithm="approx")
            found = np.array([float(abs(root) - 1) for root in roots]) + 1
    return found
