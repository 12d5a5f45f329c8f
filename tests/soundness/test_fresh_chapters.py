"""False steps, prints, claims and sources, thought out afresh: none is shown as proved."""

import json
from itertools import count
from types import SimpleNamespace

import pytest
import sympy as sp
from sympy import Eq, I, Rational, S, exp, pi, re, sin, sqrt

from symhaptic.book import chapters, sources
from symhaptic.book.committed import NoLedger, records, reworded
from symhaptic.book.ledger import of_chapter
from symhaptic.book.page import Page
from symhaptic.book.record import FalseStep
from symhaptic.notation import B, F, K, T, alpha, b, beta, d, m, t, theta, v, w, x, z
from symhaptic.notation.proposition import (
    FALSE,
    And,
    ForAll,
    Iff,
    Implies,
    Not,
    Or,
    Predicate,
    Relation,
    implied,
    proposition,
    whole,
)
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.reading import Unreadable, read
from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.roots import NoSuchRoot
from symhaptic.proof.theorems.axioms import known
from symhaptic.proof.theorems.leaves import identity
from symhaptic.proof.verdict import Unfounded

H, f = sp.Function("H"), sp.Function("f")
ZERO_IS_ONE = Relation(S.Zero, "=", S.One)
FAKE = SimpleNamespace(hypotheses=frozenset(), conclusion=ZERO_IS_ONE)

# -- steps, names, limits and decimals ---------------------------------------------------


def kept(head, *sides):
    return head(*sides, evaluate=False)


def define(name, meaning, *then):
    """A definition, and a step that would show what it makes of it."""
    return lambda page: (page.define("A name", name, meaning), then and page.step("So", *then))


def step(*chain, **named):
    return lambda page: page.step("A step", *chain, **named)


def named(*names):
    """A number that is called so: 3 is none of these."""
    return [
        (name, lambda page, name=name: page.step("A step", S(3), S(3), name=name)) for name in names
    ]


def limit(expr, value, variable=x, at=S.Zero, **named):
    return lambda page: page.limit("A limit", expr, variable, at, value, **named)


def decimals(name, number, places):
    return lambda page: page.enclosed("A number", [(name, number)], places=places)


OTHER, MINE = sp.Dummy("x"), sp.Symbol("q")

STEPS = {
    "0 = 1 beside itself": step(kept(Eq, 0, 1), kept(Eq, 0, 1)),
    "x < 0 beside 2 x < 0": step(x < 0, 2 * x < 0),
    "true": step(sp.true, sp.true),
    "a list of relations": step([x < 0], [x < 0]),
    "one side": step(x),
    "lists of other lengths": step([x, x], [x]),
    "x = -x": step(x, -x),
    "sqrt x^2 = x": step(sqrt(x**2), x),
    "0/0 = 1": step(kept(sp.Mul, 0, 1 / kept(sp.Add, x, -x)), S.One),
    "oo = oo": step(sp.oo, sp.oo),
    "nan = nan": step(sp.nan, sp.nan),
    "z is real": step(re(z, evaluate=False), z),
    "two symbols of one print": step(OTHER + x, x + OTHER),
    "a symbol 0 = 1": step(sp.Symbol("0 = 1"), sp.Symbol("0 = 1")),
    "a symbol 1": step(sp.Symbol("1") + 1, 1 + sp.Symbol("1")),
    "a function 0 = 1": step(sp.Function("0 = 1; f")(x), sp.Function("0 = 1; f")(x)),
    "a theorem by hand": lambda page: page.lemma("Proved", FAKE),
    "a relation as a theorem": lambda page: page.lemma("Proved", ZERO_IS_ONE),
    "a theorem of two symbols of one print": lambda page: page.lemma(
        "Proved", identity(OTHER + x, x + OTHER)
    ),
    # what a name may stand for
    "pi := 3": define(pi, S(3), pi, S(3)),
    "0 := 1": define(S.Zero, S.One, S.Zero, S.One),
    "sin theta := 2": define(sin(theta), S(2), sin(theta) + 1, S(3)),
    "x^2 := -1": define(x**2, S.NegativeOne, x**2 + 1, S.Zero),
    "1+1 := 3": define("1+1", S(3)),
    "a command sin := 2": define(r"\sin\theta", S(2)),
    "|x| := -1": define("|x|", S.NegativeOne),
    "a symbol pi": define(sp.Symbol("pi"), S(3)),
    "a symbol j": define(sp.Symbol("j"), S(3)),
    "a symbol \\alpha": define(sp.Symbol(r"\alpha"), S(3)),
    "a function sin": define(sp.Function("sin")(theta), S(2)),
    "a function \\cos": define(sp.Function(r"\cos")(theta), S(2)),
    "w := w + 1": define(w, w + 1),
    "w := j": define(w, I, re(w, evaluate=False), w),
    "H(x) := j": define(H(z), I * K, re(H(x), evaluate=False), H(x)),
    "a length for a force": define(F, x),
    "two things": lambda page: (define(w, S.One)(page), define(w, S(2))(page)),
    "two things by steps": lambda page: (
        step(S(3), S(3), name=w)(page),
        step(S(4), S(4), name=w)(page),
    ),
    "a circle": lambda page: (define(alpha, beta + 1)(page), define(beta, alpha)(page)),
    "a circle of three": lambda page: (
        define(alpha, beta)(page),
        define(beta, d)(page),
        define(d, alpha + 1)(page),
    ),
    **dict(
        named(
            "{1+1}",
            r"1\ +\ 1",
            r"\mathbf{1+1}",
            r"\mathrm{1}+1",
            r"\displaystyle 1+1",
            r"\frac12",
            r"\tfrac 1 2",
            r"\ln 1",
            r"\sqrt[3]{8}",
            "5!",
            r"\max(1,2)",
            r"0 = 1,\quad q",
            r"q < 0,\ q",
            r"1\ne1,\ \kappa",
            r"{\pi}",
            "j^2",
            r"\cos^2\theta+\sin^2\theta",
            pi,
            2 * MINE,
            S(2),
        )
    ),
    # limits
    "lim x + 2 for x + 1": limit(x + 1, S.One, name="x+2"),
    "lim 2x + 1 for x + 1": limit(x + 1, S.One, name=2 * x + 1),
    "lim of a number": limit(x + 1, S.One, name="2"),
    "lim of another x": limit(x + OTHER, OTHER),
    "lim 1/x": limit(1 / x, S.Zero),
    "lim |x|/x": limit(sp.Abs(x) / x, S.One),
    "lim sin x/x": limit(sin(x) / x, S.Zero),
    "lim at infinity": limit(1 / x, S.Zero, at=sp.oo),
    "lim x^x": limit(x**x, S.One),
    "lim with x": limit(x, x),
    "lim a relation": limit(x < 1, sp.true),
    # decimals
    "3.1 for 314": decimals("q", S(314), -1),
    ".314 for 314": decimals("q", S(314), 0),
    "ln 2 = 1/3": decimals(r"\ln 2", Rational(1, 3), 4),
    "pi in braces": decimals(r"{\pi}", Rational(1, 3), 4),
    "pi = 22/7": decimals(pi, Rational(22, 7), 4),
    "a symbol": decimals("q", x, 4),
    "j": decimals("q", I, 4),
    "below 0": decimals("q", -pi, 4),
    "1/0": decimals("q", 1 / kept(sp.Add, 1, -1), 4),
    "q = 0 too": decimals("q = 0, r", pi, 4),
    "not more digits than known": decimals("q", sp.oo, 4),
    # what is no theorem
    "no wrong word": lambda page: (
        page.state("mine", "whatever it says"),
        page.settle_slip("mine", "", "right", "why"),
    ),
    "no wrong word but a space": lambda page: (
        page.state("mine", "whatever it says"),
        page.settle_slip("mine", " ", "right", "why"),
    ),
}
"""Each is shown as proved, or as a definition of what is no name, where it passes."""


@pytest.mark.parametrize("name", STEPS)
def test_a_false_step_is_not_shown(name):
    page = Page("test")
    with pytest.raises((FalseStep, NoSuchRoot, Unsupported)):
        STEPS[name](page)


def test_a_name_stays_a_name():
    page = Page("test")
    for name in (r"\frac{dz}{d\beta}", r"p_1(z)", r"x\big|_{t=0}", r"\text{need}", r"\lim x/t", w):
        page.step("A step", 2 * x - x, x, name=name)
    page.define("A function", H(z), K + B * (z - 1) / (T * z))
    page.define("A size", r"|\varepsilon|", sp.Abs(alpha - beta))
    page.limit("A limit", sin(x) / x, x, S.Zero, S.One, name=r"\sin x\,/x")
    page.enclosed("A number", [("314", S(314))], places=1)


# -- prints that may be read in two ways -------------------------------------------------

TWO_WAYS = (
    # a differential, or the delay d
    r"F = \frac{m dv}{dt}",
    r"v = \frac{2dx}{2dt}",
    r"v = m dx/2 dt",
    r"dx = v dt",
    r"m\,dv = F\,dt",
    r"\frac{d^2x}{dt^2} = 0",
    # a value at a time, or a product
    "x(kT) = x",
    "F(kT) = K x(kT)",
    "x(2T) = 0",
    "v(t/2) = v",
    "x(-t) = -x",
    "x((k+1)T) = x",
    "x(T - t_d) = x",
    r"v\left(kT\right) = 0",
    "F_E(kT) = 0",
    # a derivative, or a power
    "x^{(2)} = 0",
    r"\sin x^{(d+1)}",
    # in the function before, or a factor beside it
    r"\cos\theta(1+x)",
    r"\cos\theta[1+x]",
    r"\sin\theta\frac{1}{2}",
    r"\sin\theta\tfrac{K}{2}",
    r"\sin\theta\sqrt{x}",
    r"\exp x(1+x)",
    r"\sin\theta/2",
    r"\cos x\cdot 2",
    # a mixed number, or a product
    r"2\frac{1}{2}",
    r"K = 3\tfrac{1}{2}",
    r"1\frac{1}{2} = 1",
    # what prints nothing, or something else
    "x!",
    "x'",
    r"K\%",
    "K = K % = 2",
    r"K \not= K",
    r"K \neq\!\!= B",
    r"\sin{x}y",
    "x^2_1",
    "2^10",
    "K = B, T = 1",
    r"K < B \\ B < K",
    r"K \pm B",
    "K == B",
    "K =< B",
    "|x|y|z|",
    "x^2^3",
    "e = 1",
    r"\sqrt[3]{K}",
    r"\sin^{-1} x",
    "0.5.1",
    "1,5",
)


@pytest.mark.parametrize("line", TWO_WAYS)
def test_a_print_of_two_readings_is_refused(line):
    with pytest.raises(Unreadable):
        read(line)


def test_a_print_of_one_reading_is_read():
    for line, meant in (
        (r"\sin 2(d+1)\theta", sin(2 * (d + 1) * theta)),
        ("x(K+B)", x * (K + B)),
        (r"\frac{d\sin\theta}{\sin d\theta}", d * sin(theta) / sin(d * theta)),
        (r"\frac{K}{(d+1)T}", K / ((d + 1) * T)),
        (r"\mathrm{e}^{-bt/m}", exp(-b * t / m)),
        (r"3\frac{K}{2}", 3 * K / 2),
    ):
        assert read(line) == (meant,)


NO_NAMES = (
    r"\not", r"\ln", r"\log", r"\overline", r"\neg", r"\max", r"\int", r"\sum", r"\partial", r"\in",
    r"\sim", r"\pm", r"\quad", r"\mathrm", r"\pi", r"\sin", r"\approx", "K_{1=2}", "1", "KT", "",
)  # fmt: skip


@pytest.mark.parametrize("name", NO_NAMES)
def test_no_source_calls_something_by_what_is_no_letter(name):
    """w := 1, and then T \\not w = T would say that T is not T."""
    with pytest.raises(Unreadable):
        read("T = T", ((name, "w"),))


def test_an_upright_e_is_eulers_number_in_every_source():
    assert read(r"\mathrm{e}^{2}e", (("e", "w"),)) == (w * exp(2),)


# -- sources -----------------------------------------------------------------------------

_numbers = count()
BEGIN = """
from sympy import *
from symhaptic.notation import *
from symhaptic.notation import B, F, K, T, alpha, b, d, m, t, v, w, x
from symhaptic.notation.proposition import *
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.statement import Source, Statement
from symhaptic.proof.theorems.axioms import known
from symhaptic.proof.theorems.leaves import identity
from symhaptic.proof.theorems.kernel import *
from symhaptic.proof.theorems.leaves import *
from symhaptic.proof.theorems.tactics import *
"""


@pytest.fixture
def settle(tmp_path):
    """The verdict of a source of one statement, or the reason why it has none."""
    keys = []

    def run(statement, chapter='page.settle("odd:a")', claim="", source=""):
        key = f"odd{next(_numbers)}"
        keys.append(key)
        folder = tmp_path / key
        folder.mkdir()
        claimed = f'\n\n@claims("odd:a")\ndef claim(p):\n    return {claim}\n' if claim else ""
        text = (
            f'{BEGIN}\nSOURCE = Source("odd", "Notes"{source})\n'
            f'STATEMENTS = (Statement("odd:a", "(1)", "says so", {statement}),){claimed}'
        )
        body = "".join(f"    {line}\n" for line in chapter.splitlines())
        files = {"source": text, "one": f'"""A title."""{BEGIN}\n\ndef derive(page):\n{body}'}
        for name, content in files.items():
            (folder / f"{name}.py").write_text(content.replace("odd", key), encoding="utf-8")
        try:
            found = of_chapter(chapters.run(folder / "one.py"))
        except chapters.BadChapter as wrong:
            return str(wrong)
        return str(next((e.verdict.kind for e in found if e.statement.id == f"{key}:a"), "none"))

    yield run
    for key in keys:
        for table in (sources.STATEMENTS, CLAIMED):
            for id in [id for id in table if id.startswith(f"{key}:")]:
                del table[id]
        sources.SOURCES[:] = [s for s in sources.SOURCES if s.key != key]


ONE = 'page.define("One", w, S(1))\npage.settle("odd:a")'
WALL = 'Predicate("passive_wall", (), (K, B, b, T, d))'
VACUOUS = f"""wall = {WALL}
never = not_intro(spec(known("square"), {{symbols("x"): x}}), assume(x**2 < 0))
shown = add_assum(contr(never, K < 0), wall)
"""
SOURCES = {
    # a reading that says something else, or numbers that nobody measures
    "0 = 1 read as 1 = 1": {"statement": '("0 = 1",), reading=("1 = 1",)'},
    "the same beside a quoted number": {
        "statement": '("0 = 1",), reading=("1 = 1",), quoted=(Quoted("about", "1"),)'
    },
    "a number that is not measured": {"statement": '("1 = 1",), quoted=(Quoted("about", "5"),)'},
    "a number that is not in the claim": {
        "statement": 'quoted=(Quoted("above", "17.8"),)',
        "claim": 'ForAll((symbols("x"),), Relation(S(0), "<=", symbols("x")**2))',
        "chapter": 'page.settle("odd:a", known("square"))',
    },
    "a number that is shown of itself": {
        "statement": 'quoted=(Quoted("about", "17.8"),)',
        "claim": 'ForAll((symbols("x"),), Relation(S(0), "<=", symbols("x")**2))',
        "chapter": 'page.settle("odd:a", known("square"), value=Rational(178, 10))',
    },
    "the same beside an equation": {
        "statement": '("1 = 1",), quoted=(Quoted("about", "5"),)',
        "chapter": 'page.settle("odd:a", Eq(1, 1, evaluate=False), value=S(5))',
    },
    "ln 1 = 5": {"statement": r'(r"\ln 1 = 5",), reading=("5 = 5",)'},
    "5 = ln 1": {"statement": r'(r"5 = \ln 1",), reading=("1 = 1",)'},
    "ln K = 2": {"statement": r'(r"\ln K = 2",), reading=("K = K",)'},
    "less read as not more": {"statement": r'(r"\ln K < 2",), reading=(r"K \leq 2",)'},
    "a chain read as one": {"statement": r'(r"\ln K = 2 = 3",), reading=("K = 2",)'},
    "a reading of nothing": {"statement": '("0 = 1",), reading=()'},
    # notation
    "not": {
        "statement": r'(r"T \not= T",)',
        "source": r', notation=((r"\not", "w"),)',
        "chapter": ONE,
    },
    "ln": {
        "statement": r'(r"\ln T = T",)',
        "source": r', notation=((r"\ln", "w"),)',
        "chapter": ONE,
    },
    "e": {
        "statement": r'(r"\mathrm{e}^{2} = 1",)',
        "source": ', notation=(("e", "w"),)',
        "chapter": ONE,
    },
    "a sign in a subscript": {
        "statement": '("K_{0=1} T = T",)',
        "source": ', notation=(("K_{0=1}", "w"),)',
        "chapter": ONE,
    },
    "two names": {"statement": '("K = B",)', "source": ', notation=(("K", "B"), ("K", "B"))'},
    "no symbol": {"statement": '("K = B",)', "source": ', notation=(("K", "0"),)'},
    "a derivative": {
        "statement": r'(r"F = \frac{m dv}{dt}",)',
        "chapter": 'page.define("Force", F, m*v/t)\npage.settle("odd:a")',
    },
    # conditions and claims
    "K < 0 implies that 0 is whole": {
        "statement": '("K < 0",), condition=True',
        "claim": "ForAll((K,), implied(p, whole(0)))",
        "chapter": 'page.settle("odd:a", for_all([K], [K < 0], add_assum(is_whole(0), K < 0)), '
        "example=example({K: -1}, [K < 0]))",
    },
    "2 K < 0 beside what is whole": {
        "statement": r'("K < 0",), condition=True, domain=r"d\in\mathbb{N}_0, 2K < 0"',
        "claim": "ForAll((K, d), implied([whole(d), 2 * K < 0], p[0]))",
        "chapter": 'page.settle("odd:a", known("square"))',
    },
    "a condition under a contradiction, of a passive wall": {
        "statement": '("K < 0",), condition=True',
        "claim": f"ForAll((K, x), And((implied([{WALL}, x**2 < 0], p[0]),)))",
        "chapter": VACUOUS + "shown = conj(disch(shown, both([wall, x**2 < 0])))\n"
        'page.settle("odd:a", gen(shown, K, x))',
    },
    "a condition for all squares below 0": {
        "statement": '("K < 0",), condition=True',
        "claim": f"ForAll((K,), And((implied([{WALL}], "
        "ForAll((x,), implied([x**2 < 0], p[0]))),)))",
        "chapter": VACUOUS + "shown = conj(disch(gen(disch(shown, x**2 < 0), x), wall))\n"
        'page.settle("odd:a", gen(shown, K))',
    },
    "under its denial's denial": {
        "statement": '("K < 0",)',
        "claim": "ForAll((K,), Implies((Not((Not((proposition(p[0]),)),)), proposition(p[0]))))",
    },
    "under what the domain does not say": {
        "statement": '("K < 0",), domain="B < 0"',
        "claim": "ForAll((K,), implied([K < -1], p[0]))",
    },
    "under a contradiction": {
        "statement": '("K < 0",), domain="T < K, K < T"',
        "claim": "ForAll((K, T), implied([T < K, K < T], p[0]))",
        "chapter": 'page.settle("odd:a", for_all([K, T], [T < K, K < T], '
        "contr(not_intro(assume(T < K), assume(K < T)), K < 0)))",
    },
    "an expression": {
        "statement": '("0",)',
        "claim": 'ForAll((symbols("x"),), Relation(S(0), "<=", symbols("x")**2))',
        "chapter": 'page.settle("odd:a", known("square"))',
    },
    "another relation": {"statement": '("K < 0",)', "claim": "ForAll((K,), proposition(K <= 0))"},
    "a multiple": {"statement": '("K < 0",)', "claim": "ForAll((K,), proposition(2 * K < 0))"},
    "nothing": {"statement": '("K < 0",)', "claim": "TRUE"},
    "one of two": {
        "statement": '("1 = 1", "0 = 1")',
        "claim": "proposition(p[0])",
        "chapter": 'page.settle("odd:a", identity(1, 1))',
    },
    # verdicts
    "0 = 1 instead": {
        "statement": '("x < 0",)',
        "claim": "ForAll((x,), proposition(p[0]))",
        "chapter": 'right = ForAll((x,), Relation(S(0), "<=", x**2))\n'
        'page.settle("odd:a", gen(spec(known("square"), {symbols("x"): x}), x), '
        'instead=right, corrected=("0 = 1",), '
        "unless=[counterexample(ForAll((x,), proposition(x < 0)), {x: 1})])",
    },
    "w = 2 after w := 1": {
        "statement": '("w = 2",)',
        "chapter": 'page.define("One", w, S(1))\npage.settle("odd:a")',
    },
    "a definition of K": {
        "statement": r'(r"K = \frac{17b}{T}",)',
        "chapter": 'page.define("Wall", K, 17*b/T)\npage.settle("odd:a")',
    },
    "a number of the wall in between": {
        "statement": r'(r"2K = \frac{34b}{T}",)',
        "chapter": 'page.define("Wall", K, 17*b/T)\npage.settle("odd:a")',
    },
    "a definition of the device": {
        "statement": r'(r"K = \frac{17b}{T}",)',
        "chapter": 'page.define("Damper", b, K*T/17)\npage.settle("odd:a")',
    },
    "a definition turned": {
        "statement": '("2F = 34xw",)',
        "chapter": 'page.define("Force", F, 17*x*w)\npage.settle("odd:a")',
    },
    "1 = 1 and 0 = 1": {"statement": '("1 = 1", "0 = 1")'},
    "data outside": {
        "statement": '("0 = 1",)',
        "chapter": 'page.settle_external("odd:a", "data", "seen", Eq(0, 1, evaluate=False))',
    },
    "left open": {"statement": '("0 = 1",)', "chapter": 'page.leave_open("odd:a", "proved")'},
    "settled twice": {
        "statement": '("1 = 1",)',
        "chapter": 'page.settle("odd:a")\npage.settle("odd:a")',
    },
    "another's id": {"statement": '("1 = 1",)', "chapter": 'page.settle("eq5")'},
}


@pytest.mark.parametrize("name", SOURCES)
def test_a_false_source_has_no_proof(name, settle):
    assert settle(**SOURCES[name]) not in ("proved", "enclosed", "qualified", "misprint")


def test_a_claim_may_suppose_what_the_notation_says_of_a_symbol_and_nothing_else(settle):
    for symbol, sign, good in (("b", ">=", True), ("K", ">=", False), ("T", ">", True)):
        statement = f'("{symbol} + 1 > 0",)'
        claim = f"ForAll(({symbol},), implied([{symbol} {sign} 0], p[0]))"
        assert ("the claim supposes" not in settle(statement=statement, claim=claim)) == good
    claim = "ForAll((K, T), implied([K < T], p[0]))"
    assert "the claim supposes" in settle(statement='("K < 0",)', claim=claim)


def test_the_same_rightly_is_proved(settle):
    assert settle(statement='("1 = 1",)') == "proved"
    named = {"statement": r'(r"\sin\theta/2 = w",), reading=(r"\nu = w",)'}
    assert (
        settle(**named, chapter='page.define("Own", w, symbols("nu"))\npage.settle("odd:a")')
        == "definition"
    )


# -- claims of a chapter's own -----------------------------------------------------------

NEGATIVE = proposition(K < 0)
SUPPOSED = {
    "not not": Not((Not((NEGATIVE,)),)),
    "or": Or((NEGATIVE, NEGATIVE)),
    "and in or": Or((And((NEGATIVE,)), FALSE)),
    "iff": Iff((NEGATIVE, And(()))),
    "implied": Implies((And(()), NEGATIVE)),
    "for all": ForAll((T,), NEGATIVE),
    "a multiple": proposition(3 * K < 0),
    "turned": proposition(-K > 0),
    "a multiple in or": Or((proposition(2 * K < 0),)),
    "not not a multiple": Not((Not((proposition(K / 2 < 0),)),)),
}


@pytest.mark.parametrize("name", SUPPOSED)
def test_a_claim_does_not_suppose_its_print_in_another_form(name):
    page = Page("test")
    page.state("mine", "no wall", "K < 0", claim=ForAll((K,), implied([SUPPOSED[name]], NEGATIVE)))
    with pytest.raises(Unfounded, match="supposes the print"):
        page.settle("mine", known("square"))


@pytest.mark.parametrize(
    "then",
    [
        whole(0),
        whole(d),
        And((whole(d), whole(0))),
        Predicate("degree", (z,), (z + K, S.One)),
        Predicate("passive_wall", (), (S.Zero, S.Zero, b, S.One, d)),
    ],
)
def test_what_judges_no_wall_of_the_print_makes_no_condition_of_it(then):
    page = Page("test")
    page.state(
        "mine", "no wall", "K < 0", claim=ForAll((K,), implied([K < 0], then)), condition=True
    )
    with pytest.raises(Unfounded, match="no condition of a predicate"):
        page.settle("mine", known("square"))


# -- ledgers -----------------------------------------------------------------------------

RECORD = {"id": "mine", "verdict": "proved"}
NO_LEDGERS = {
    "no object": "[]",
    "no statements": "{}",
    "statements as text": '{"statements": "mine"}',
    "a record as text": '{"statements": ["mine"]}',
    "no id": '{"statements": [{"verdict": "proved"}]}',
    "no verdict": '{"statements": [{"id": "mine"}]}',
    "an unknown verdict": '{"statements": [{"id": "mine", "verdict": "true"}]}',
    "a verdict of two": '{"statements": [{"id": "a", "verdict": "proved", "verdict": "slip"}]}',
    "an id of two": json.dumps({"statements": [RECORD, {**RECORD, "verdict": "refuted"}]}),
    "a number that is none": '{"statements": [{"id": "a", "verdict": "slip", "seconds": NaN}]}',
    "two values": '{"statements": []} {"statements": []}',
    "nothing": "",
}


@pytest.mark.parametrize("name", NO_LEDGERS)
def test_what_is_no_ledger_is_refused(name, tmp_path):
    file = tmp_path / "ledger.json"
    file.write_text(NO_LEDGERS[name], encoding="utf-8")
    with pytest.raises(NoLedger):
        records(file)


@pytest.mark.parametrize("left_out", ["statement", "proposition", "definitions", "corrected"])
def test_what_a_record_leaves_out_is_compared_too(left_out, tmp_path):
    page = Page("test")
    page.define("Force", F, b * v)
    page.state("mine", "a misprint", "F = 2 b v")
    page.settle("mine", Eq(F, b * v))
    chapter = chapters.Chapter(tmp_path / "one.py", "A title", "", page, 0.0)
    [entry] = of_chapter(chapter)
    assert entry.verdict.kind == "misprint"
    file = tmp_path / "ledger.json"
    record = entry.as_json()
    file.write_text(json.dumps({"statements": [record]}), encoding="utf-8")
    assert reworded([entry], file) == []
    for other in (
        {name: record[name] for name in record if name != left_out},
        {**record, left_out: "0 = 1"},
    ):
        file.write_text(json.dumps({"statements": [other]}), encoding="utf-8")
        assert reworded([entry], file)
