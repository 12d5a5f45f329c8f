"""Roots of |f| = |g| beside NumPy's roots and beside roots that were chosen."""

import numpy as np
import pytest

from symhaptic.numeric.cubic import roots

CENTER = 1.3


def about(p):
    """A polynomial in y, lowest power first, about 0, about CENTER, and in 4 - y."""
    p = np.polynomial.Polynomial(p)
    shift = np.polynomial.Polynomial
    own, far = p(shift([CENTER, 1])), p(shift([4, -1]))
    return tuple(
        [np.asarray(v) for v in np.pad(q.coef, (0, 4 - len(q.coef)))] for q in (p, own, far)
    )


def found(p):
    """The roots that are there with the directions, sorted; all three coordinates agree."""
    near, own, far = about(p)
    some = [c for c in roots(near, own, far, np.asarray(CENTER), np.asarray(4 - CENTER)) if c[4]]
    for y, rest, off, _, _ in some:
        assert float(y + rest) == pytest.approx(4, rel=1e-15)
        assert float(y - off) == pytest.approx(CENTER, rel=1e-14)
    return sorted((float(y), bool(rises)) for y, _, _, rises, _ in some)


def test_random_cubics():
    rng = np.random.default_rng(81)
    for _ in range(400):
        true = rng.uniform(-2, 6, 3)
        if np.min(np.abs(np.subtract.outer(true, [0, 4]))) < 1e-6:
            continue
        p = np.polynomial.polynomial.polyfromroots(true) * rng.choice([-1, 1])
        inside = np.sort(true[(true > 0) & (true < 4)])
        got = found(p)
        assert [y for y, _ in got] == pytest.approx(list(inside), rel=1e-6, abs=1e-9)
        slope = np.polynomial.Polynomial(p).deriv()(inside)
        clear = np.abs(slope) > 1e-6
        assert [r for _, r in np.array(got)[clear]] == list(slope[clear] > 0)


@pytest.mark.parametrize(
    "true", [[1e-12, 2.0, 3.0], [1e-9, 1e-8, 3.9], [CENTER + 1e-12, -1.0, 5.0],
             [CENTER - 1e-10, CENTER + 3e-10, 7.0], [4 - 1e-11, 0.5, -3.0]],
    ids=str,
)  # fmt: skip
def test_roots_next_to_a_point_of_expansion_keep_their_digits(true):
    """Coefficients about each point from the distances to the roots, which are exact there."""

    def terms(distances, sign=1.0):
        c = np.polynomial.polynomial.polyfromroots(distances) * sign
        return [np.asarray(v) for v in c]

    near = terms(true)
    own = terms([t - CENTER for t in true])
    far = terms([4 - t for t in true], -1.0)
    given = near, own, far, np.asarray(CENTER), np.asarray(4 - CENTER)
    inside = sorted(t for t in true if 0 < t < 4)
    got = sorted((c for c in roots(*given) if c[4]), key=lambda c: float(c[0]))
    assert len(got) == len(inside)
    for (y, rest, off, _, _), t in zip(got, inside, strict=True):
        nearest = min((t, y), (4 - t, rest), (t - CENTER, off), key=lambda pair: abs(pair[0]))
        assert float(nearest[1]) == pytest.approx(nearest[0], rel=1e-10)


@pytest.mark.parametrize(
    "p", [[1.0], [-1.0], [0.0], [1.0, 0, 1], [0.0, -1.0], [4.0, -1.0]], ids=str
)
def test_no_root_inside(p):
    """Constants, no real root, and roots at 0 and 4, which are the ends and not inside."""
    assert found(p) == []


def test_lower_degrees_and_double_roots():
    assert found([-1.0, 1.0]) == [(1.0, True)]
    assert found([2.0, -3.0, 1.0]) == [(1.0, False), (2.0, True)]
    got = found([4.5, -12.0, 10.5, -3.0])  # -3 (y - 1)^2 (y - 3/2)
    assert got[-1][0] == pytest.approx(1.5)
    assert len(got) in (1, 3)  # the double root is there twice or not at all


def test_stacks_are_what_their_elements_are():
    rng = np.random.default_rng(82)
    p = np.polynomial.polynomial.polyfromroots
    many = [about(p(rng.uniform(-2, 6, 3))) for _ in range(60)]
    near, own, far = ([np.array([m[i][k] for m in many]) for k in range(4)] for i in range(3))
    stacked = roots(near, own, far, np.full(60, CENTER), np.full(60, 4 - CENTER))
    for i, one in enumerate(many):
        alone = roots(*one, np.asarray(CENTER), np.asarray(4 - CENTER))
        expected = sorted(float(c[0]) for c in alone if c[4])
        assert sorted(float(c[0][i]) for c in stacked if c[4][i]) == expected
