"""Each branch of a routine is the function that it claims to be, its roundings left out."""

from functools import cache, partial

import mpmath
import pytest
import sympy as sp
from export.inlining import inlined, program
from mpmath import mpf
from sympy import Max, Piecewise
from sympy.codegen.cfunctions import expm1

from symhaptic.export.branches import Assign, Choice, Join, Set, lazy
from symhaptic.export.library import known
from symhaptic.export.precision import PRECISIONS
from symhaptic.export.routine import OPERATIONS, Repeat, TwoProdError, code_name, names
from symhaptic.export.routines import device
from symhaptic.export.vectors import slope_size as largest_term
from symhaptic.forms import values
from symhaptic.forms.entire import written_out
from symhaptic.notation import delta, gamma
from symhaptic.proof.normal import Field

ROUTINES = known()
SERIES = tuple(name for name in ROUTINES if name.endswith("Series"))
CLOSED = [name for name in ROUTINES if name in values.ALL]


def leaves(block, steps=()):
    """What each branch returns, with the steps that lead there put in, in exact arithmetic."""
    known_ = dict(steps)
    for at, statement in enumerate(block):
        if isinstance(statement, Assign | Set):
            known_[statement.name] = exactly(statement.expr).xreplace(known_)
        elif isinstance(statement, Choice | Join):
            rest = () if isinstance(statement, Choice) else block[at + 1 :]
            for side in (statement.yes, statement.no):
                yield from leaves((*side, *rest), known_.items())
            return
        else:
            yield exactly(statement.results[0]).xreplace(known_)


def exactly(expr):
    """What an expression means where nothing is rounded."""
    return expr.replace(TwoProdError, lambda *_: sp.S.Zero).replace(expm1, lambda x: sp.exp(x) - 1)


R = sp.Symbol("r", positive=True)
W = sp.Symbol("w")


def plain(expr, sign):
    """A formula without guards, where the root of the motion is real or imaginary.

    No divisor is 0, and w = delta^2/4 - gamma is r^2 or -r^2.
    """
    while guards := [p for p in expr.atoms(Piecewise) if not p.args[0][0].has(Piecewise)]:
        first = min(guards, key=sp.count_ops)
        expr = expr.xreplace({first: first.args[-1][0]})
    expr = expr.replace(Max, lambda *a: max(a, key=lambda x: len(x.free_symbols)))
    expr = written_out(expr.xreplace({gamma: delta**2 / 4 - sign * R**2, W: sign * R**2}))
    expr = expr.replace(sp.Abs, lambda x: sign * sp.expand(x))
    return expr.replace(lambda e: e.is_Pow, lambda e: sp.expand(e.base) ** e.exp)


@pytest.mark.parametrize("name", CLOSED)
def test_closed_branches_are_the_definition(name):
    """By the normal form: proved wherever both are defined."""
    routine = inlined(ROUTINES[name], ROUTINES, lambda called: called.endswith("Series"))
    closed = values.ALL[name].definition(*routine.arguments)
    proved = 0
    for leaf in leaves(lazy(routine)):
        if any(leaf.has(sp.Function(s)) for s in SERIES) or leaf.is_number:
            continue
        if name == "Gap" and not leaf.has(sp.sin):
            continue  # its own series
        found = []
        for sign in (1, -1):
            ours, theirs = (plain(side, sign) for side in (leaf, closed))
            found.append(Field([ours, theirs]).are_equal(ours, theirs))
        assert any(found), (name, leaf)
        proved += 1
    assert proved


@cache
def in_digits(name):
    """A routine in mpmath, which has nothing to put back then."""
    modules = [{n: partial(run, n) for n in ROUTINES}, {"TwoProdError": lambda *_: 0}, "mpmath"]
    return program(inlined(ROUTINES[name], ROUTINES), modules)


def run(name, *values):
    """Its result in as many digits as are asked for."""
    return in_digits(name)(*values)[0]


PAIRS = [("0.01", "0.1"), ("3.99", "0.01"), ("3.9", "3.97"), ("4.9", "4.43"), ("3.99", "3"),
         ("0", "1.99"), ("1", "2"), ("0.5", "1.9"), ("1e-5", "1.2"), ("0", "2.5"), ("4.5", "0.1"),
         ("9", "6"), ("30", "1"), ("2", "40")]  # fmt: skip
SINGLE = ["0.01", "0.5", "1.4", "1.6", "1.999", "2.5", "30"]
TURNS = [("0", "0.3"), ("0", "3"), ("1", "0.7"), ("1", "1.3"), ("10", "0.1"), ("10.5", "0.2")]


@pytest.mark.parametrize("name", CLOSED)
def test_every_branch_reaches_the_last_digit_of_a_float(name):
    """Series to the ends of their regions and closed branches beyond, beside the definition."""
    routine = ROUTINES[name]
    points = [(x,) for x in SINGLE] + [(f"-{x}",) for x in SINGLE if name in ("C", "S", "Bend")]
    if len(routine.arguments) == 2:
        points = PAIRS if gamma in routine.arguments else TURNS
    for point in points:
        with mpmath.workdps(60):
            numbers = [mpf(x) for x in point]
            found = run(name, *numbers)
            at = dict(zip(routine.arguments, numbers, strict=True))
            exact = values.value(values.ALL[name](*routine.arguments), at)
            term = largest_term(values.ALL[name], map(float, numbers))  # where the value vanishes
            assert abs(found - exact) < 1e-19 * (abs(exact) or float(term) or 1e-20), point


@pytest.mark.parametrize("precision", PRECISIONS.values(), ids=PRECISIONS)
@pytest.mark.parametrize("name", ["PlantN1Series", "PlantN0Series"])
def test_the_series_have_enough_terms(name, precision):
    """The next term of the divided difference of exp at three nodes of the largest size."""
    assert device.STIFF <= device.NEAR**2
    routine = known(precision)[name]
    (loop,) = (step for step in routine.steps if isinstance(step, Repeat))
    sizes = []
    for largest, size in ((loop.few, device.TINY), (loop.factorials[0], device.NEAR)):
        terms = largest - 1
        sizes.append(terms)
        missed = size**terms * (terms + 1) / sp.factorial(terms + 2)
        assert missed < precision.last / 1000
    assert sizes[0] < sizes[1]


@pytest.mark.parametrize("name", ["CosNext", "SinNext"])
def test_a_long_angle_in_single_precision_is_turned_back(name):
    """Beside the library's sine, in many digits: three floats of pi reach 1e-20 of an angle."""
    routines = known(PRECISIONS["single"])
    single = inlined(routines[name], routines)
    turned = program(single, [{"TwoProdError": lambda *_: 0}, "mpmath"])
    for steps, angle in [(0, "0.3"), (1, "1.4"), (7, "0.9"), (1000, "2.2"), (10**6, "3.1")]:
        with mpmath.workdps(60):
            (found,) = turned(mpf(steps), mpf(angle))
            wave = mpmath.cos if name == "CosNext" else mpmath.sin
            assert abs(found - wave((steps + 1) * mpf(angle))) < 1e-14


def test_names_in_code_are_unique():
    written = [code_name(name) for name in ROUTINES]
    assert len(set(written)) == len(written)
    assert not set(written) & {op.lower() for op in OPERATIONS}


def test_no_step_hides_a_routine_that_is_called():
    for routine in ROUTINES.values():
        made = [s for step in routine.steps for s in names(step)]
        loops = [step for step in routine.steps if isinstance(step, Repeat)]
        made += [s for loop in loops for s in (*(s for s, _ in loop.steps), loop.number) if s]
        made += routine.arguments
        assert len(set(made)) == len(made), routine.name
