"""Derivatives of stable forms: proved by the normal form, and beside ball arithmetic."""

import itertools

import flint
import mpmath
import pytest
import sympy as sp
from flint import arb
from mpmath import mpf

from symhaptic.balls.exact import slopes as in_balls
from symhaptic.export import vectors
from symhaptic.export.vectors import sized
from symhaptic.forms import derivatives, entire, stable, values
from symhaptic.forms.derivatives import derivative, differentiable, with_derivatives
from symhaptic.forms.entire import SLOPES, Entire, NumeratorAtOne, PlantN0, PlantN1, written_out
from symhaptic.forms.implicit import Rated
from symhaptic.forms.values import BY_MATRIX
from symhaptic.model.parts import ALL, FULL, Parts
from symhaptic.notation import alpha, beta, d, delta, gamma, theta
from symhaptic.proof.decide import compare

CLAIMS = [
    (cls, i) for cls in (*SLOPES, values.ALL["CosNext"], values.ALL["SinNext"], values.ALL["C"])
    for i in range(next(iter(cls.nargs)))
]  # fmt: skip


@pytest.mark.parametrize(("cls", "index"), CLAIMS, ids=lambda x: getattr(x, "__name__", str(x)))
def test_each_function_that_is_called_a_derivative_is_one(cls, index):
    """Of the closed form, by the normal form."""
    symbols = sp.symbols(f"x:{next(iter(cls.nargs))}", positive=True)
    claimed = written_out(cls(*symbols).fdiff(index + 1))
    assert compare(claimed, cls.definition(*symbols).diff(symbols[index])).equal


PRODUCTS = [(whole, by) for whole, slopes in derivatives.WHOLE for by in slopes]


@pytest.mark.parametrize(("whole", "by"), PRODUCTS, ids=str)
def test_each_product_that_is_differentiated_as_a_whole_has_that_derivative(whole, by):
    """Of the closed form, by the normal form; another sign or one more term is not proved."""
    claimed = dict(derivatives.WHOLE)[whole][by]
    exact = written_out(whole).diff(by)
    assert compare(written_out(claimed), exact).equal
    assert not compare(written_out(-claimed), exact).equal
    assert not compare(written_out(claimed + whole), exact).equal


@pytest.mark.parametrize("cls", [PlantN1, PlantN0, NumeratorAtOne], ids=lambda c: c.__name__)
def test_a_wrong_derivative_is_not_proved(cls):
    for index in (0, 1):
        claimed = cls(gamma, delta).fdiff(index + 1)
        exact = cls.definition(gamma, delta).diff((gamma, delta)[index])
        for node in claimed.atoms(Entire):
            for wrong in (-node, node.func(gamma, 2 * delta), node.func(2 * gamma, delta)):
                mutant = written_out(claimed.xreplace({node: wrong}))
                assert not compare(mutant, exact).equal, (cls, wrong)


IN_NUMBERS = ("discretize_fractional", "passivity_margin", "max_stable_stiffness")


@pytest.mark.parametrize("parts", ALL, ids=lambda p: p.name)
def test_derivatives_of_forms_are_those_of_what_is_derived(parts):
    """By the normal form, at whole delays; the largest and the rest in numbers below."""
    positive = {s: sp.Symbol(s.name, positive=True) for s in (theta, d)}
    proved = 0
    for form in stable.forms(parts, 1 if parts.delay else None):
        numbers = form.outside is sp.nan
        if not numbers or form.name in (*IN_NUMBERS, "stability_conditions", "stability_boundary"):
            continue
        results = zip(dict(form.results), form.differentiated, strict=True)
        for (name, expr), symbol in itertools.product(results, form.arguments):
            if (form.name, symbol) == ("max_passive_stiffness", d):
                continue
            ours = expr.args[0][0] if isinstance(expr, sp.Piecewise) else expr
            slope = derivative(ours, symbol)
            if isinstance(ours, Rated):  # NaN at the same angles, else the value and its slope
                assert isinstance(slope, Rated)
                assert slope.args[0] == ours.args[0]
                ours, slope = ours.args[1], slope.args[1]
            left = written_out(slope.xreplace(positive))
            right = written_out(ours).diff(symbol).xreplace(positive)
            assert compare(left, right).equal, (form.name, name, symbol)
            proved += 1
    assert proved


def test_no_derivative_is_taken_factor_by_factor_where_it_would_cancel():
    """1 - a + e, n1 - n0 and 1 - e are differentiated as a whole."""
    assert derivative(gamma * NumeratorAtOne(gamma, delta), gamma) == entire.Kick(gamma, delta)
    assert derivative(delta**2 * entire.Decay(delta) ** 2, delta) == (
        2 * delta * entire.Decay(delta) * sp.exp(-delta)
    )
    for form in stable.forms(FULL, 1):
        if form.outside is sp.nan:
            wanted = with_derivatives(form, differentiable(form))
            found = {type(f) for e in wanted.expressions for f in e.atoms(Entire)}
            assert found <= {*values.ALL.values()}


# -- numbers ------------------------------------------------------------------------------


@pytest.mark.parametrize("cls", BY_MATRIX, ids=lambda c: c.__name__)
def test_values_of_the_device_beside_derivatives_of_a_closed_form(cls):
    """mpmath.diff of the textbook step response, away from where it is 0/0."""

    def response(g, dl):
        c = mpmath.sqrt(dl**2 / 4 - g + 0j)
        return ((1 - mpmath.exp(-dl / 2) * (mpmath.cosh(c) + dl / 2 * mpmath.sinh(c) / c)) / g).real

    def reversed_(g, dl):
        return mpmath.exp(-dl) * response(g, -dl)

    def trace(g, dl):
        return (2 * mpmath.exp(-dl / 2) * mpmath.cosh(mpmath.sqrt(dl**2 / 4 - g + 0j))).real

    def apart(g, dl):
        return (response(g, dl) - reversed_(g, dl)) / dl

    known = {
        "Kick": (trace, (1, 0), -1),
        "Coast": (trace, (0, 1), -1),
        "Echo": (response, (0, 1), -1),
        "Ebb": (reversed_, (0, 1), 1),
        "PlantN1Drop": (response, (1, 0), -1),
        "PlantN0Drop": (reversed_, (1, 0), -1),
        "NumeratorGapDrop": (apart, (1, 0), -1),
    }
    function, order, sign = known[cls.__name__]
    for g, dl in itertools.product(("0.3", "5", "80"), ("0.1", "3", "30")):
        with mpmath.workdps(60):
            expected = sign * mpmath.diff(function, (mpf(g), mpf(dl)), order)
            found = BY_MATRIX[cls](mpf(g), mpf(dl))
            assert abs(found - expected) < 1e-20 * abs(expected), (g, dl)


@pytest.mark.parametrize("at", [0, 1, 2, 3])
def test_the_limits_are_the_leading_terms(at):
    """exp over n + 1 nodes at 0 is 1/n!."""
    expected = {"Kick": 1, "Coast": 1, "Echo": "1/6", "PlantN1Drop": "1/24", "PlantN0Drop": "1/24",
                "NumeratorGapDrop": "1/120", "Ebb": "-1/3"}  # fmt: skip
    step = mpf(10) ** (-100 * at) if at else mpf(0)
    for cls, number in BY_MATRIX.items():
        with mpmath.workdps(40):
            exact = mpmath.mpmathify(sp.Rational(expected[cls.__name__]))
            assert abs(number(step, step) - exact) <= 2 * step + mpf(10) ** -35, cls


@pytest.mark.parametrize(
    "name", ["stability_boundary", "passivity_boundary", "passivity_margin_at"]
)
def test_forms_beside_power_series_in_balls(name):
    """Textbook formulas in ball arithmetic, differentiated as power series."""
    form = stable.form(name)
    some = {theta: ("0.01", "1", "2.9"), gamma: ("0", "1", "30"), delta: ("0", "2", "40"),
            alpha: ("0.3",), beta: ("-0.2",), d: ("0", "1", "2.5")}  # fmt: skip
    by = [s for s in form.arguments if s.name in differentiable(form)]
    found = {s: [derivative(expr, s) for expr in form.differentiated] for s in by}
    for numbers in itertools.product(*(some[s] for s in form.arguments)):
        point = dict(zip(form.arguments, numbers, strict=True))
        if name == "passivity_boundary" and (float(point[d]) + 1) * float(point[theta]) > 3.1:
            continue
        searched = name == "passivity_boundary" and float(point[d]) % 1
        close = 1e-28 if searched else 1e-40  # half of the digits that a search works with
        for symbol in by:
            with flint.ctx.workprec(400), mpmath.workdps(80):
                at = {s: (mpf(float(v)), abs(mpf(float(v)))) for s, v in point.items()}
                exact = in_balls(name, {s.name: float(v) for s, v in point.items()}, symbol.name)
                for slope, ball in zip(found[symbol], exact, strict=True):
                    number, size = sized(slope, at)
                    off = abs(arb(mpmath.nstr(number, 60)) - ball)
                    assert off <= close * float(size), (point, symbol)


SOME = {"alpha": ("0.3",), "beta": ("-0.05", "0.2"), "gamma": ("0.01", "3"),
        "delta": ("0.3", "2.5"), "d": ("2", "1.25"), "epsilon": ("0.3",)}  # fmt: skip


@pytest.mark.parametrize(
    ("name", "parts"),
    [(name, parts) for name in IN_NUMBERS for parts in (FULL, Parts(stiffness=False))]
    + [(name, Parts(damping=False)) for name in IN_NUMBERS[:1]]
    + [("passivity_margin", Parts(virtual_damping=False)),
       ("passivity_margin", Parts(delay=False))],
    ids=str,
)  # fmt: skip
def test_forms_beside_differences_of_their_values(name, parts, monkeypatch):
    """In 60 digits, to twice that of the step; at a whole delay to the right."""
    monkeypatch.setattr(vectors, "_FOUND", 60)
    vectors._searched.cache_clear()
    form = stable.form(name, parts)
    wanted = with_derivatives(form, differentiable(form))
    slopes_ = [(*key.split("_by_"), expr) for key, expr in wanted.results[len(form.results) :]]
    assert {by for _, by, _ in slopes_} == {s.name for s in form.arguments}
    step = mpf(10) ** -15
    for numbers in itertools.product(*(SOME[s.name] for s in form.arguments)):
        point = dict(zip((s.name for s in form.arguments), map(mpf, numbers), strict=True))

        def at(expr, point=point, **changed):
            now = point | changed
            return sized(expr, {s: (now[s.name], abs(now[s.name])) for s in form.arguments})[0]

        for result, by, slope in slopes_:
            expr, x = dict(form.results)[result], point[by]
            with mpmath.workdps(60):
                try:
                    ahead = [at(expr, **{by: x + i * step}) for i in (-1, 0, 1, 2)]
                except ArithmeticError:
                    assert name == "max_stable_stiffness"
                    continue  # no wall of this device is stable
                centre = (ahead[2] - ahead[0]) / (2 * step)
                right = (4 * ahead[2] - 3 * ahead[1] - ahead[3]) / (2 * step)
                exact = right if by == "d" and x == int(x) else centre
                assert abs(at(slope) - exact) < 1e-24 * max(abs(exact), 1), (result, by, point)


# -- what is refused ----------------------------------------------------------------------


def test_an_argument_that_is_not_there_is_refused_with_those_that_are():
    with pytest.raises(stable.NoForm, match=r"no argument 'gamma'; it has delta$"):
        with_derivatives(stable.form("discretize", Parts(stiffness=False)), ("gamma",))


def test_what_counts_has_no_derivative():
    with pytest.raises(stable.NoForm, match="is_stable: has no derivative, since it counts roots"):
        with_derivatives(stable.form("is_stable"), ("gamma",))


@pytest.mark.parametrize(
    ("name", "by"),
    [("passivity_boundary", "theta"), ("passivity_boundary", "d"), ("max_passive_stiffness", "d")],
)
def test_what_is_searched_for_has_one_only_where_it_is_largest(name, by):
    with pytest.raises(stable.NoForm, match=f"{name}: has no derivative with respect to {by}"):
        with_derivatives(stable.form(name), (by,))
    assert "delta" in differentiable(stable.form(name))


def test_a_function_whose_derivative_is_not_known_is_refused():
    """Better than its closed form, which is 0/0 somewhere."""
    with pytest.raises(stable.NoForm, match="no stable derivative of NumeratorGap"):
        derivative(values.ALL["NumeratorGap"](gamma, delta), delta)
    twice = with_derivatives(stable.form("discretize"), ("gamma",))
    with pytest.raises(stable.NoForm, match="no stable derivative of PlantN1Drop"):
        with_derivatives(twice, ("gamma",))


def test_results_come_first_and_their_derivatives_behind():
    form = with_derivatives(stable.form("discretize"), ("delta", "gamma"))
    names = [name for name, _ in form.results]
    assert names[:4] == ["n1", "n0", "a", "e"]
    assert names[4:8] == ["n1_by_delta", "n0_by_delta", "a_by_delta", "e_by_delta"]
    assert names[8:] == ["n1_by_gamma", "n0_by_gamma", "a_by_gamma", "e_by_gamma"]
    assert form.name == "discretize_and_derivatives"
