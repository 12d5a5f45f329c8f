r"""When do all roots of a real polynomial lie inside the unit circle?

For :math:`p(z) = a_n z^n + \ldots + a_0` with :math:`a_n > 0` exactly if n + 1 expressions are
positive: half planes, that is coefficients :math:`c_k` of :math:`(1-s)^n p((1+s)/(1-s))`, and the
leading minors of one small symmetric matrix, which are Jury's inner determinants
:math:`|X-Y|` of orders n-1, n-3, ...  No other of his determinants is needed (Anderson and Jury,
*A simplified Schur-Cohn test*, IEEE Trans. Automatic Control 18, 1973); the chapter on these
inequalities says why.  All arithmetic is exact and free of fractions.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import comb, prod
from numbers import Integral
from typing import Any

import sympy as sp
from flint import arb, arb_mat, ctx, fmpz_mpoly
from sympy import Expr, Matrix, Symbol
from sympy.logic.boolalg import Boolean
from sympy.polys.matrices import DomainMatrix

from symhaptic.model import loop
from symhaptic.model.plant import Sampled
from symhaptic.model.polynomials import factored, integers, minors, primitive
from symhaptic.notation import a, alpha, beta, d, e, n_0, n_1, z
from symhaptic.notation.quantities import number, shown
from symhaptic.notation.sizes import LARGEST, STIFFEST

ANY = Sampled(n_1, n_0, a, e)
"""A sampled plant whose four numbers are symbols."""


@dataclass(frozen=True)
class Criterion:
    """Polynomials that are all positive exactly where every root lies inside.

    First the half planes, p(1) at their head, then the minors.  The last minor is the product of
    1 - z_i z_j over all pairs of roots, up to a positive number.
    """

    symbols: tuple[Symbol, ...]
    polynomials: tuple[fmpz_mpoly, ...]
    """Without their integer content, which is positive."""

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """The polynomials, factored over the integers and collected in alpha and beta."""
        return tuple(factored(p, self.symbols) for p in self.polynomials)

    @property
    def relations(self) -> tuple[Boolean, ...]:
        """One strict inequality each, without those that hold for all values."""
        found = [sp.StrictGreaterThan(x, 0, evaluate=x.is_number) for x in self.expressions]
        return tuple(relation for relation in found if relation != sp.true)

    @property
    def terms(self) -> int:
        """Number of terms of the largest polynomial, multiplied out."""
        return max(len(p) for p in self.polynomials)

    def degree(self, symbol: Symbol) -> int:
        """The highest power of a symbol in any of the polynomials."""
        index = self.symbols.index(symbol)
        return max(int(p.degrees()[index]) for p in self.polynomials)


def jury(delay: int, gamma: float | None = None, delta: float | None = None) -> tuple[Boolean, ...]:
    r"""Return Jury's inequalities; the loop is stable if and only if all of them hold.

    Parameters
    ----------
    delay : int
        The delay d in sampling periods, an integer from 0 to 20.
    gamma, delta : float, optional
        Numbers of the device, gamma = k T^2/m and delta = b T/m.  Give both or none.

    Returns
    -------
    tuple of sympy relations
        Strict inequalities ``polynomial > 0`` in alpha = K T^2/m, beta = B T/m and the four
        numbers n_1, n_0, a and e of the sampled device, which :func:`symhaptic.discretize` returns.
        No polynomial contains a fraction; each is factored and collected in alpha and beta.  If
        gamma and delta are given, each coefficient is rounded to 15 digits.  The half planes come
        first, then the minors.  There are d + 4 inequalities, less those that hold for all walls.

    Raises
    ------
    ValueError
        If ``delay`` is no integer from 0 to 20, the device is impossible, or gamma is above 1e15 or
        delta above 1e70, which no function takes.

    Notes
    -----
    The inequalities are from Anderson and Jury, *A simplified Schur-Cohn test*, IEEE Trans.
    Automatic Control 18(2), 1973, for the characteristic polynomial
    :math:`z^{d+1}(z^2-az+e)+(n_1z+n_0)((\alpha+\beta)z-\beta)`; derived in chapter s4d_jury.  The
    largest polynomial has 9 terms for d = 0, 57 for d = 2 and 3505 for d = 8.  Up to d = 8 the call
    takes less than about two seconds; each further period doubles the time.  For a longer or a
    fractional delay use :func:`symhaptic.is_stable` or :func:`symhaptic.stability_boundary`.

    Examples
    --------
    >>> for inequality in jury(0)[:3]:
    ...     print(inequality)
    -a + alpha*(n_0 + n_1) + e + 1 > 0
    -a + alpha*(-n_0 + n_1) + beta*(2*n_0 + 2*n_1) - e + 3 > 0
    a + alpha*(n_0 - n_1) + beta*(2*n_0 - 2*n_1) + e + 1 > 0

    For a free mass, the third inequality holds for all walls and is left out:

    >>> jury(0, gamma=0, delta=0)
    (1.0*alpha > 0, 2.0*beta > 0, -0.25*alpha*beta - 0.5*alpha - 0.5*beta**2 + 1.0*beta > 0)
    """
    if isinstance(delay, Integral) and delay > LONGEST:
        raise ValueError(
            f"delay: {shown(delay)} is not allowed; give at most {LONGEST} periods, or call "
            "is_stable: each further period doubles the time of this criterion"
        )
    found = criterion(coefficients(delay))
    if gamma is None and delta is None:
        return found.relations
    device = (_parameter("gamma", gamma, STIFFEST), _parameter("delta", delta, LARGEST))
    rounded = [form > 0 for form in _rounded(found, *device)]
    return tuple(relation for relation in rounded if relation != sp.true)


LONGEST = 20
"""Periods of delay at most: these take hours."""

_BITS = (256, 1024, 4096, 16384, 65536)
"""Precisions of the device's numbers.  A coefficient is 0 if the last one does not show its sign:
it is a polynomial in numbers of which the smallest is 1e-394."""

_DIGITS = 15
"""Digits of a coefficient."""


def _parameter(name: str, value: float | None, most: float) -> float:
    """A parameter of the device, which has to be given and as small as the package takes it."""
    if value is None:
        raise ValueError(f"{name}: is missing; give gamma and delta, or none")
    found = number(name, value, "", ">= 0")
    if found > most:
        raise ValueError(f"{name}: {found!r} is not allowed; give numbers 0 <= {name} <= {most:g}")
    return found


def _device(gamma: float, delta: float) -> dict[Symbol, arb]:
    """The numbers of the device, from the exponential of its matrix with the held force."""
    step = arb_mat([[0, 1, 0], [-arb(gamma), -arb(delta), 1], [0, 0, 0]]).exp()
    second = step[0, 1] * step[1, 2] - step[1, 1] * step[0, 2]
    values = step[0, 2], second, step[0, 0] + step[1, 1], (-arb(delta)).exp()
    return dict(zip((n_1, n_0, a, e), values, strict=True))


def _rounded(found: Criterion, gamma: float, delta: float) -> list[Expr]:
    """The polynomials in alpha and beta of a device, each coefficient rounded.

    The precision rises until each coefficient is known; where it is not, the coefficient is 0.
    """
    forms: list[dict[tuple[int, int], Expr]] = [{} for _ in found.polynomials]
    for bits in _BITS:
        left = False
        with ctx.workprec(bits):
            device = _device(gamma, delta)
            for form, polynomial in zip(forms, found.polynomials, strict=True):
                for powers, value in _coefficients(found.symbols, polynomial, device).items():
                    if value.rel_accuracy_bits() > 4 * _DIGITS:
                        digits = value.str(_DIGITS + 5, radius=False)
                        form.setdefault(powers, sp.Float(digits, _DIGITS))
                    elif powers not in form and not value.is_zero():
                        left = True
        if not left:
            break
    return [
        sp.Add(*(value * alpha**i * beta**j for (i, j), value in form.items())) for form in forms
    ]


def _coefficients(
    symbols: tuple[Symbol, ...], polynomial: fmpz_mpoly, device: Mapping[Symbol, arb]
) -> dict[tuple[int, int], arb]:
    """The coefficients of the powers of alpha and beta, in balls."""
    total: dict[tuple[int, int], arb] = {}
    for powers, factor in polynomial.to_dict().items():
        power = {s: int(p) for s, p in zip(symbols, powers, strict=True)}
        place = power.pop(alpha, 0), power.pop(beta, 0)
        value = prod((device[s] ** p for s, p in power.items()), start=arb(factor))
        total[place] = total.get(place, arb(0)) + value
    return total


def inequalities(delay: int, device: Sampled = ANY) -> tuple[Boolean, ...]:
    r"""Inequalities that hold together exactly where the loop with a delayed wall is stable.

    :math:`A(z)z^{d+1} + (n_1 z + n_0)((\alpha+\beta)z - \beta)` with :math:`A = z^2 - az + e` has
    all its d + 3 roots inside the unit circle (condition of Jury, Sec. IV-D of the paper).

    ``delay`` is the number d of whole periods, at least 0.  ``device`` is the sampled plant; its
    numbers are n_1, n_0, a and e unless given, and may be any polynomials with rational
    coefficients in symbols of one's own.  Returns strict inequalities in alpha, beta (both
    dimensionless, K T^2/m and B T/m) and the symbols of the device.  Raises ``ValueError`` for
    another delay or device.

    >>> from symhaptic.model import plant
    >>> from symhaptic.model.parts import Parts
    >>> free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    >>> inequalities(0, free)
    (alpha > 0, beta > 0, -alpha*beta - 2*alpha - 2*beta**2 + 4*beta > 0)
    >>> len(inequalities(7))
    11
    """
    return criterion(coefficients(delay, device)).relations


def coefficients(delay: int, device: Sampled = ANY) -> tuple[Expr, ...]:
    """Of the loop's characteristic polynomial, the highest power of z first.

    >>> coefficients(1, Sampled(n_1, n_0, 2, 1))[:2]
    (1, -2)
    """
    if isinstance(delay, bool) or not isinstance(delay, Integral) or delay < 0:
        raise ValueError(f"delay: {delay!r} is not an integer number of periods; give 0, 1, 2, ...")
    return tuple(sp.Poly(loop.closing(device).subs(d, int(delay)), z).all_coeffs())


def criterion(coefficients: Sequence[Expr]) -> Criterion:
    """The criterion for a polynomial, given its coefficients, the highest power first.

    Coefficients are polynomials in symbols with rational numbers; the first must be a positive
    number.  Raises ``ValueError`` where they are not.

    >>> b, c = sp.symbols("b c")
    >>> criterion([1, b, c]).relations
    (b + c + 1 > 0, -b + c + 1 > 0, 1 - c > 0)
    """
    symbols, rising = integers(coefficients)
    even, odd = halves(rising)
    matrix = bezoutian(even, odd)
    if len(odd) < len(even):  # the first row without its factor a_n + a_0
        matrix[0] = odd[::-1]
    found = [*half_planes(rising), *minors(matrix)]
    return Criterion(symbols, tuple(primitive(p) for p in found))


# -- on the circle -----------------------------------------------------------------------


def halves(rising: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """F and G, polynomials in x = z + 1/z, their coefficients from the lowest power up.

    With p(z) = sum of rising[i] z^i and n = 2m or 2m+1, the sum and the difference of z^(-n/2) p
    and its mirror image are F and (z - 1/z) G, or (z^(1/2) + z^(-1/2)) F and
    (z^(1/2) - z^(-1/2)) G.

    >>> halves(sp.symbols("a_0:4"))
    ([-a_0 + a_1 + a_2 - a_3, a_0 + a_3], [-a_0 - a_1 + a_2 + a_3, -a_0 + a_3])
    """
    n = len(rising) - 1
    m = n // 2
    upper, lower = rising[n - m :], rising[: m + 1][::-1]
    sums = [up + low for up, low in zip(upper, lower, strict=True)]
    differences = [up - low for up, low in zip(upper, lower, strict=True)]
    if n % 2:
        return _in_x(sums, -1), _in_x(differences, 1)
    # twice the middle coefficient stands for 1, and the difference there is zero
    return _in_x([rising[m], *sums[1:]], 0, first=2), _in_x(differences[1:], 0)


def _in_x(coefficients: Sequence[Any], shift: int, first: int = 1) -> list[Any]:
    """Sum of coefficient times b_k, for b_0 = first, b_1 = x + shift, b_(k+1) = x b_k - b_(k-1)."""
    before, now = [first], [shift, 1]
    total = [coefficients[0] * first]
    for coefficient in coefficients[1:]:
        total.append(coefficient * 0)
        total = [t + coefficient * b for t, b in zip(total, now, strict=True)]
        raised = [0, *now]
        padded = [*before, *[0] * (len(raised) - len(before))]
        before, now = now, [up - low for up, low in zip(raised, padded, strict=True)]
    return total


def bezoutian(even: Sequence[Any], odd: Sequence[Any]) -> list[list[Any]]:
    """The matrix of (F(x) G(y) - F(y) G(x))/(x - y), the highest powers first."""
    size = len(even) - 1
    full = [*odd, *[even[0] * 0] * (size + 1 - len(odd))]
    rows = [[even[0] * 0] * size for _ in range(size)]
    for i in range(size + 1):
        for j in range(i):
            minor = even[i] * full[j] - even[j] * full[i]
            for k in range(i - j):
                row, column = size - i + k, size - 1 - j - k
                rows[row][column] = rows[row][column] + minor
    return rows


def half_planes(rising: Sequence[Any]) -> list[Any]:
    """The coefficients c_0 and c_n, c_(n-2), ... of (1 - s)^n p((1 + s)/(1 - s)), c_0 first."""
    n = len(rising) - 1

    def weight(k: int, i: int) -> int:
        return sum((-1) ** (k - j) * comb(i, j) * comb(n - i, k - j) for j in range(k + 1))

    kept = sorted({0, *range(n, -1, -2)})
    return [sum(weight(k, i) * c for i, c in enumerate(rising)) for k in kept]


def inner(coefficients: Sequence[Expr], order: int) -> Matrix:
    """Jury's matrix X - Y of one order, an inner of that of order n-1.

    >>> inner(sp.symbols("a_3 a_2 a_1 a_0"), 2).tolist()
    [[a_3, -a_0 + a_2], [-a_0, -a_1 + a_3]]
    """
    rising = list(coefficients)[::-1]
    n = len(rising) - 1

    def entry(i: int, j: int) -> Expr:
        back = i + j - order + 1
        return (rising[n - j + i] if j >= i else 0) - (rising[back] if back >= 0 else 0)

    return Matrix(order, order, entry)


def determinant(matrix: Matrix) -> Expr:
    """Of polynomials in symbols, with rational coefficients, as of such; else as of expressions.

    >>> determinant(inner(sp.symbols("a_3 a_2 a_1 a_0"), 2))
    -a_0**2 + a_0*a_2 - a_1*a_3 + a_3**2
    """
    exact = DomainMatrix.from_Matrix(matrix)
    ring = exact.domain
    rational = ring.is_PolynomialRing and ring.domain in (sp.ZZ, sp.QQ)
    if rational and all(symbol.is_Symbol for symbol in ring.symbols):
        return ring.to_sympy(exact.det())
    return _by_first_row(matrix.tolist())


def _by_first_row(rows: Sequence[Sequence[Expr]]) -> Expr:
    """Laplace's expansion, which neither divides nor asks what an expression is."""
    if len(rows) == 1:
        return rows[0][0]
    minors = [[[*row[:j], *row[j + 1 :]] for row in rows[1:]] for j in range(len(rows))]
    return sp.Add(
        *((-1) ** j * rows[0][j] * _by_first_row(minor) for j, minor in enumerate(minors))
    )
