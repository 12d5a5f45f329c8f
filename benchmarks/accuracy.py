"""How far exported C is off, in units in the last place, beside exact values in ball arithmetic.

    python benchmarks/accuracy.py [POINTS] [FUNCTION ...]

The exact values come from the exponential of the device's matrix and from textbook formulas, not
from the package; the last place is that of the largest term of the stable form, as in the tests.
"""

import ctypes
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import flint
import numpy as np
import sympy as sp
from flint import acb, arb

from symhaptic.export import request
from symhaptic.export.target import code_name
from symhaptic.export.targets import TARGETS
from symhaptic.model.entire import C, Entire, S
from symhaptic.model.entire_device import Apart, Fall, Rise, Swing

HARD = [0.0, 1e-300, 1e-16, 1e-12, 1e-8, 1e-4, 1.0, 10.0, 700.0]
DELAYS = [0.0, 1.0, 2.0, 5.0, 100.0, 1e6, 0.5, 1e-3, 0.1]


# -- points ---------------------------------------------------------------------------------


def plants(rng, count):
    """gamma and delta: hard cases first, then ordinary, wide, critical and stiff ones."""
    found = [(g, d) for g in HARD for d in HARD]
    for d in (1e-8, 0.1, 1.0, 2.0, 3.0, 3.9999, 4.0, 4.5, 5.0, 7.0, 20.0, 100.0, 700.0):
        g = (d / 2) ** 2
        found += [(v, d) for v in (g, np.nextafter(g, 0), np.nextafter(g, 1e9), g * (1 + 1e-15))]
        found += [(g * (1 - 1e-12), d), (g * (1 + 1e-8), d)]
    found += [(math.pi**2, 0.0), (math.pi**2, 0.02), (39.47841760435743, 0.0)]
    while len(found) < count:
        d = 10 ** rng.uniform(-3, 2.8)
        near = rng.choice([0, 1e-15, -1e-15, 1e-12, -1e-8, 1e-4, -1e-3])
        found += [
            (rng.uniform(0, 1e-3), rng.uniform(0, 0.02)),
            (rng.uniform(0, 10), rng.uniform(0, 6)),
            (10 ** rng.uniform(-12, 3), 10 ** rng.uniform(-12, 2.85)),
            ((d / 2) ** 2 * (1 + near), d),
            (rng.uniform(0, 700), rng.uniform(0, 60)),
            (0.0, 10 ** rng.uniform(-12, 2.85)),
        ]
    return np.array(found[:count])


def columns(form, rng, count):
    """Arguments of a form, one array each."""
    both = plants(rng, count)
    if "gamma" not in {s.name for s in form.arguments}:
        rng.shuffle(both)
    signs = rng.choice([-1.0, 1.0], count)
    delay = rng.choice(DELAYS, count)
    some = rng.random(count) < 0.5
    delay = np.where(some, delay, np.floor(10 ** rng.uniform(0, 6, count)))
    most = np.pi / (delay + 1) if form.name == "passivity_boundary" else np.full(count, np.pi)
    theta = most * np.where(some, rng.uniform(0, 1, count), 10 ** rng.uniform(-6, 0, count))
    theta = np.where(rng.random(count) < 0.1, most * (1 - 10 ** rng.uniform(-12, -1, count)), theta)
    values = {
        "gamma": both[:, 0],
        "delta": both[:, 1],
        "alpha": signs * 10 ** rng.uniform(-6, 2, count),
        "beta": rng.choice([-1.0, 1.0], count) * 10 ** rng.uniform(-6, 2, count),
        "d": delay,
        "theta": np.minimum(theta, 3.14159265),
    }
    return [np.ascontiguousarray(values[s.name], dtype=float) for s in form.arguments]


# -- exact values ---------------------------------------------------------------------------


def device(gamma, delta):
    """n1, n0, a and e, from the exponential of the device's matrix."""
    g, d = arb(gamma), arb(delta)
    moved = flint.arb_mat([[0, 1, 0], [-g, -d, 1], [0, 0, 0]]).exp()
    n1, trace = moved[0, 2], moved[0, 0] + moved[1, 1]
    return n1, moved[0, 1] * moved[1, 2] - moved[1, 1] * n1, trace, (-d).exp()


def polynomial(alpha, beta, gamma, delta):
    """Coefficients for a delay of one period."""
    n1, n0, a, e = device(gamma, delta)
    al, be = arb(alpha), arb(beta)
    return arb(1), -a, e + n1 * (al + be), n0 * (al + be) - n1 * be, -n0 * be


def boundary(theta, gamma, delta, d):
    """-z^d A/(n1 z + n0) on the unit circle."""
    n1, n0, a, e = device(gamma, delta)
    t = arb(theta)
    z = acb(t.cos(), t.sin())
    turn = (arb(d) + 1) * t
    q = -acb(turn.cos(), turn.sin()) / z * (z * z - a * z + e) / (n1 * z + n0)
    beta = q.imag / t.sin()
    return q.real - beta * (1 - t.cos()), beta


def margin(theta, alpha, beta, delta, d):
    """(5) of the paper in half angles."""
    t, n = arb(theta), arb(d) + 1
    kernel = ((n - arb(1) / 2) * t).sin() / (2 * (t / 2).sin())
    return (arb(delta) - arb(alpha) * kernel + arb(beta) * (n * t).cos(),)


def envelope(theta, delta, d):
    """Where the margin and its slope vanish: two linear equations."""
    t, n = arb(theta), arb(d) + 1
    up, half = (n - arb(1) / 2) * t, t / 2
    k = up.sin() / (2 * half.sin())
    k1 = (n - arb(1) / 2) * up.cos() / (2 * half.sin())
    k1 -= up.sin() * half.cos() / 4 / half.sin() ** 2
    c, c1 = -(n * t).cos(), n * (n * t).sin()
    det = k * c1 - k1 * c
    return arb(delta) * c1 / det, -arb(delta) * k1 / det


def stiffest(delta, d):
    """(11) of the paper."""
    n = arb(d) + 1
    angle = arb.pi() / (2 * n)
    beta = ((angle * arb(d)).sin() - arb(d) / n) / angle.sin()
    return 2 * arb(delta) * (angle / 2).tan(), arb(delta) * beta, angle


def line(beta, delta, d):
    """(25) of the paper."""
    return ((arb(beta) + arb(delta)) / (arb(d) + arb(1) / 2),)


EXACT = {
    "discretize": device,
    "characteristic_polynomial": polynomial,
    "stability_boundary": boundary,
    "passivity_margin": margin,
    "passivity_boundary": envelope,
    "max_passive_stiffness": stiffest,
    "linear_limit": line,
}


def bits(point):
    """Enough for exponentials of the largest and cubes of the smallest argument."""
    small = max([0.0, *(-math.log2(abs(v)) for v in point if v)])
    large = max(min(abs(v), 700.0) for v in point)
    return int(200 + 3 * small + 7 * large)


# -- sizes of terms -------------------------------------------------------------------------


def sized(expr, at, functions):
    """Values and largest terms, as in symhaptic.export.vectors but in floats, on arrays."""
    if expr.is_Symbol:
        return at[expr.name], np.abs(at[expr.name])
    if expr.is_number:
        return float(expr), abs(float(expr))
    parts = [sized(a, at, functions) for a in expr.args]
    if isinstance(expr, Entire):
        value = getattr(functions, code_name(type(expr).__name__))(np, *(v for v, _ in parts))
        return value, np.maximum(np.abs(value), swing(expr, [v for v, _ in parts]))
    if expr.is_Add:
        total = sum(v for v, _ in parts)
        terms = np.broadcast_arrays(np.abs(total), *(size for _, size in parts))
        return total, np.max(terms, axis=0)
    if expr.is_Mul:
        return math.prod(v for v, _ in parts), math.prod(s for _, s in parts)
    if expr.is_Pow:
        power = int(expr.args[1])
        base, size = parts[0]
        return base**power, size**power if power > 0 else np.abs(base**power)
    value = {sp.exp: np.exp, sp.sin: np.sin, sp.cos: np.cos, sp.tan: np.tan}[expr.func](parts[0][0])
    return value, np.abs(value)


def swing(expr, args):
    """The size of sines and cosines in functions that swing through zero."""
    if isinstance(expr, (C, S)):
        w = np.minimum(args[0], -1)
        return np.where(args[0] < -1, 1 if isinstance(expr, C) else 1 / np.sqrt(-w), 0)
    if not isinstance(expr, (Rise, Fall, Swing, Apart)):
        return 0.0
    g, d = args
    swings = (g >= 4) & (d * d < 4 * g)
    decayed, g = np.exp(-d / 2), np.maximum(g, 4)
    size = {Swing: 2 * decayed, Apart: 1 / g / np.maximum(d, 1), Rise: 1 / g, Fall: decayed / g}
    return np.where(swings, size[type(expr)], 0.0)


# -- the measurement ------------------------------------------------------------------------


def compiled(form, folder):
    """The exported C function on arrays, in a loop that is compiled with it."""
    made, files = request.built(TARGETS["c"], [form])
    for name, text in files.items():
        (folder / name).write_text(text)
    routine = made.public[0]
    many = len(routine.results)
    inner = ", ".join(f"x{i}[k]" for i in range(len(form.arguments)))
    outs = ", ".join(f"y{i} + k" for i in range(many))
    call = (
        f"y0[k] = haptic_{form.name}({inner})" if many == 1
        else f"haptic_{form.name}({inner}, {outs})"
    )  # fmt: skip
    args = [f"const double *x{i}" for i in range(len(form.arguments))]
    args += [f"double *y{i}" for i in range(many)]
    (folder / "loop.c").write_text(
        f'#include "haptic.h"\nvoid all(long n, {", ".join(args)}) {{\n'
        f"  for (long k = 0; k < n; ++k) {call};\n}}\n"
    )
    library = folder / f"{form.name}.so"
    subprocess.run(
        ["gcc", "-std=c99", "-O2", "-shared", "-fPIC", "-o", library, folder / "loop.c",
         folder / "haptic.c", "-lm"],
        check=True,
    )  # fmt: skip
    function = ctypes.CDLL(str(library)).all

    def run(arrays):
        found = np.empty((many, arrays[0].size))
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (*arrays, *found)]
        function(ctypes.c_long(arrays[0].size), *pointers)
        return found

    return run


def functions(form):
    """The routines of the array export, to find the sizes of terms with."""
    _, files = request.built(TARGETS["numpy"], [form], "terms")
    space = {}
    exec(compile(files["terms.py"], "terms.py", "exec"), space)
    return type("Terms", (), {k: staticmethod(v) for k, v in space.items() if callable(v)})


def measure(form, count, seed=1):
    """The worst error of each result, with its arguments; NaN counts as infinitely wrong."""
    arrays = columns(form, np.random.default_rng(seed), count)
    with tempfile.TemporaryDirectory() as place:
        found = compiled(form, Path(place))(arrays)
    at = {s.name: a for s, a in zip(form.arguments, arrays, strict=True)}
    helpers = functions(form)
    with np.errstate(all="ignore"):
        sizes = [np.broadcast_to(sized(e, at, helpers)[1], count) for e in form.expressions]
    worst = {name: (0.0, ()) for name, _ in form.results}
    for k in range(count):
        point = [float(a[k]) for a in arrays]
        with flint.ctx.workprec(bits(point)):
            exact = EXACT[form.name](*point)
            for i, (name, _) in enumerate(form.results):
                size = float(sizes[i][k])
                if not math.isfinite(size) or size < 1e-290 or not exact[i].is_finite():
                    continue
                off = float(abs(arb(float(found[i][k])) - exact[i])) / math.ulp(size)
                off = math.inf if off != off else off
                if off > worst[name][0]:
                    worst[name] = (off, tuple(point))
    return worst


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    for form in request.chosen(sys.argv[2:] or list(EXACT)):
        for name, (error, point) in measure(form, count).items():
            print(f"{form.name:26} {name:7} {error:7.2f}  at {point}", flush=True)


if __name__ == "__main__":
    main()
