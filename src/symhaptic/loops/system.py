"""Any linear device: state-space matrices, or a system of python-control or SciPy."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.loops.circle import Array
from symhaptic.loops.plant import Plant
from symhaptic.notation.quantities import shown

if TYPE_CHECKING:
    from flint import fmpq_mat

_SEVERAL = "system: it has several inputs or outputs; give a system with one input and one output"

_LARGEST = 12
"""States of the largest device: beyond, the roots of its polynomial lose their digits."""


@dataclass(frozen=True)
class LinearDevice:
    """Any linear device in SI units: d/dt x = A x + B F, position = C x, with the force F in N.

    Parameters
    ----------
    A : array_like
        State matrix in 1/s, n rows of n numbers, n <= 12.
    B : array_like
        How the force enters, n numbers.
    C : array_like
        How the position in m is read from the state, n numbers.  The force must not reach the
        position at once (D = 0).

    Raises
    ------
    ValueError
        If the shapes do not fit or a number is not finite.

    Notes
    -----
    Next to the boundary a verdict is that of matrices that differ from these by rounding.

    Examples
    --------
    >>> mass = LinearDevice([[0, 1], [0, -0.5]], [0, 10], [1, 0])  # 0.1 kg, 0.05 Ns/m
    >>> mass.words
    'linear device of 2 states'
    """

    A: tuple[tuple[float, ...], ...]
    B: tuple[float, ...]
    C: tuple[float, ...]

    def __init__(self, A: Any, B: Any, C: Any) -> None:
        A, B, C = (np.asarray(each, dtype=float) for each in (A, B, C))
        B, C = B.ravel(), C.ravel()
        size = len(B)
        if not 1 <= size <= _LARGEST or A.shape != (size, size) or len(C) != size:
            raise ValueError(
                f"A: of shape {A.shape} with {len(B)} numbers in B and {len(C)} in C is not "
                f"allowed; give n rows of n numbers, n in B and n in C, 1 <= n <= {_LARGEST}"
            )
        for name, each in (("A", A), ("B", B), ("C", C)):
            if not np.isfinite(each).all():
                given = shown(each.tolist())
                raise ValueError(f"{name}: {given} is not allowed; give finite numbers")
        object.__setattr__(self, "A", tuple(map(tuple, A.tolist())))
        object.__setattr__(self, "B", tuple(B.tolist()))
        object.__setattr__(self, "C", tuple(C.tolist()))

    @classmethod
    def of(cls, system: Any) -> LinearDevice:
        """The device of a continuous system of python-control or ``scipy.signal``.

        Raises :class:`ValueError` for a discrete system, for several inputs or outputs, and for
        one whose output follows its input at once.

        >>> from scipy import signal
        >>> len(LinearDevice.of(signal.lti([1.0], [0.1, 0.5, 0.0])).B)
        2
        """
        if getattr(system, "dt", None) not in (None, 0):
            given = f"of dt={system.dt!r}"
            raise ValueError(f"system: {given} is not allowed; give a continuous system")
        if hasattr(system, "to_ss"):  # SciPy's
            system = system.to_ss()
        elif not hasattr(system, "A"):  # python-control's transfer functions
            from scipy.signal import tf2ss

            above, below = system.num_array, system.den_array
            if above.shape != (1, 1):
                raise ValueError(_SEVERAL)
            A, B, C, D = tf2ss(above[0, 0], below[0, 0])
            return cls._checked(A, B, C, D)
        return cls._checked(*(np.asarray(getattr(system, name)) for name in "ABCD"))

    @classmethod
    def _checked(cls, A: Any, B: Any, C: Any, D: Any) -> LinearDevice:
        if np.size(D) > 1:
            raise ValueError(_SEVERAL)
        if np.any(D):
            raise ValueError(
                f"system: D = {shown(np.asarray(D).tolist())} moves the device without delay; "
                "give a system with D = 0"
            )
        return cls(A, B, C)

    @property
    def jumps(self) -> bool:
        """Whether a force changes the velocity at once, as it does without a mass."""
        return bool(np.dot(self.C, self.B))

    def before(self, plant: Plant, mass: float, period: float) -> Plant:
        """This device instead of the moving mass, in units of ``mass`` and ``period``."""
        A, B, C, free = _rewritten(self)
        rows = (A * period).tolist()
        return Plant(
            tuple(map(tuple, rows)),
            tuple((B * mass / period).tolist()),
            tuple(C.tolist()),
            tuple((C @ A * period).tolist()),
            free,
        )

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return f"linear device of {len(self.B)} states"


@lru_cache(maxsize=64)
def _rewritten(device: LinearDevice) -> tuple[Array, Array, Array, bool]:
    """A, B and C with other states, in which the samples lose no digits; whether det A = 0.

    Those of Schur's form, found in floats and put in exactly, in units that balance A.
    """
    from flint import fmpq, fmpq_mat
    from scipy.linalg import matrix_balance, schur

    def exact(rows: Array) -> fmpq_mat:
        entries = [fmpq(*float(x).as_integer_ratio()) for x in rows.ravel()]
        return fmpq_mat(*rows.shape, entries)

    def rounded(matrix: fmpq_mat) -> Array:
        entries = [int(x.p) / int(x.q) for x in matrix.entries()]
        return np.reshape(entries, (matrix.nrows(), matrix.ncols()))

    A, B, C = (np.array(each) for each in (device.A, device.B, device.C))
    free = _singular(exact(A))
    _, states = schur(A)
    basis = exact(states)
    back = basis.inv()
    A, B, C = back * exact(A) * basis, back * exact(B[:, None]), exact(C[None]) * basis
    A, (unit, _) = matrix_balance(rounded(A), permute=False, separate=True)
    return A, rounded(B)[:, 0] / unit, rounded(C)[0] * unit, free


def _singular(matrix: fmpq_mat) -> bool:
    """Whether changes of the entries by their rounding may make the determinant 0."""
    if matrix.det() == 0:
        return True
    cofactors = (matrix.inv() * matrix.det()).transpose()
    terms = (abs(x * y) for x, y in zip(matrix.entries(), cofactors.entries(), strict=True))
    return bool(abs(matrix.det()) * 2**_EXACT <= sum(terms))


_EXACT = 50
"""Correct bits of an entry: a change of states rounds each entry a few times."""
