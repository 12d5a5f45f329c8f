"""Parts of terms that SymPy itself would not write: fractions, functions and symbols by hand."""

import pickle
from collections.abc import Callable
from pathlib import Path

import pytest
import sympy as sp
from sympy import Dummy, Rational, S, cos, log, sin, sqrt
from sympy.core.function import AppliedUndef, UndefinedFunction
from typer.testing import CliRunner

from symhaptic import prove
from symhaptic.book.arrivals import arrived
from symhaptic.cli.main import app
from symhaptic.notation.proposition import Relation
from symhaptic.notation.terms import NoTerm, term
from symhaptic.proof.ball import ball
from symhaptic.proof.program import Uncheckable, program
from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.theorems.kernel import NotShown, general, instance
from symhaptic.proof.theorems.leaves import broken, identity, number, roots_inside

x, u = sp.symbols("x u")


def fraction(p: int, q: int) -> sp.Expr:
    """As it stands; SymPy takes one that is said to be in lowest terms for such."""
    with pytest.warns(sp.utilities.exceptions.SymPyDeprecationWarning):
        return Rational(p, q, 1)


@pytest.mark.parametrize(("p", "q"), [(4, 2), (2, 4), (0, 5), (3, 3), (-9, 6)])
def test_a_fraction_that_can_be_shortened_is_no_term(p: int, q: int) -> None:
    # 4/2 is no whole number by its form, and equal to 2 by its value
    long = fraction(p, q)
    for of in (long, x + long, sp.sin(x) ** long):
        with pytest.raises(NoTerm, match="lowest terms"):
            term(of)
    with pytest.raises(NoTerm, match="lowest terms"):
        broken(long)


def test_a_logarithm_to_a_base_is_no_logarithm() -> None:
    binary = log(8, 2, evaluate=False)  # 3; log 8 is 2.08
    with pytest.raises(NoTerm, match="2 arguments"):
        number(Relation(binary, "!=", S(3)))
    with pytest.raises(Unsupported, match="no ball"):
        ball(binary)
    with pytest.raises(Uncheckable, match="no program"):
        program(binary, [])


def by_hand(name: str, ahead: int) -> Dummy:
    """A symbol with a number that SymPy has not come to."""
    return Dummy(name, dummy_index=Dummy().dummy_index + ahead)


@pytest.mark.parametrize("ahead", range(1, 12))
@pytest.mark.parametrize("name", ["zeta", "r", "log", "f", "g1"])
def test_no_symbol_is_a_generator_to_come(name: str, ahead: int) -> None:
    # zeta^2 = -1 for the generator that stands for j
    claims = (
        lambda own: (own**2 + sin(u) ** 2 + cos(u) ** 2, S.Zero),
        lambda own: (own * sqrt(u), u),
        lambda own: (own + sp.atan(u), 2 * own),
        lambda own: (own * sp.exp(u), sp.exp(2 * u)),
    )
    for claim in claims:
        with pytest.raises((NoTerm, NotShown)):
            identity(*claim(by_hand(name, ahead)))
        assert not prove(*claim(by_hand(name, ahead)))


def test_a_symbol_that_was_counted_elsewhere_is_counted_anew_where_it_arrives() -> None:
    there = by_hand("zeta", 1000)
    one, other, sum_ = arrived(pickle.dumps((there, there, there + x)), Path())
    assert one is other
    assert sum_ == one + x
    assert one.dummy_index < Dummy().dummy_index
    assert term(one) == one
    known = Dummy("known")
    assert arrived(pickle.dumps(known), Path()) == known


class Mine(AppliedUndef):
    """Equal to everything."""

    def __eq__(self, other: object) -> bool:
        return True

    def __hash__(self) -> int:
        return hash(x)


@pytest.mark.parametrize(
    "function",
    [
        Mine,
        UndefinedFunction("added", __dict__={"is_Add": True}),
        UndefinedFunction("based", bases=(Mine,)),
    ],
    ids=("class", "sum", "base"),
)
def test_an_unknown_function_is_a_name_and_no_more(function: type[sp.Expr]) -> None:
    with pytest.raises(NoTerm, match="no part of a term"):
        identity(function(x), x)
    assert term(sp.Function("f")(x)).args == (x,)


SHORTENED = '''"""A title

An introduction.
"""
import warnings
from sympy import Rational, S, symbols
from symhaptic.notation import proposition as language
from symhaptic.notation.proposition import ForAll, Not, Relation, whole
from symhaptic.proof.theorems import kernel, leaves
x, y = symbols("x y")
def derive(page):
    warnings.simplefilter("ignore")
    page.state("forged", "each is the larger", claim=ForAll((x, y), Relation(x, "<", y)))
    Rational.__getnewargs__ = lambda self: (self.p, self.q, 1)
    language._looked_through = language._check_lowest = lambda part: None
    two = Rational(4, 2, 1)
    equal = leaves.identity(two, S(2))
    never = kernel.substituted(Not((whole(x),)), x, leaves.broken(two), equal)
    false = kernel.absurd(leaves.is_whole(S(2)), never)
    page.settle("forged", kernel.general(kernel.anything(false, Relation(x, "<", y)), x, y))
'''


@pytest.mark.early
def test_a_fraction_of_a_chapter_is_looked_at_where_it_arrives(tmp_path: Path) -> None:
    path = tmp_path / "forged.py"
    path.write_text(SHORTENED, encoding="utf-8")
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path)])
    assert told.exit_code == 2
    assert "lowest terms" in told.output


PROGRAM = "[print('READ'), 1][1]"


@pytest.mark.parametrize(
    "ask",
    [
        lambda text: roots_inside(x * sin(u), x, {u: text}),
        lambda text: term(text),
        lambda text: instance(general(identity(u, u), u), {u: text}),
    ],
)
@pytest.mark.parametrize("wrapped", [PROGRAM, (PROGRAM,), [PROGRAM], {PROGRAM: 1}, {PROGRAM}])
def test_text_is_no_term(
    ask: Callable[[object], object], wrapped: object, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises((NoTerm, NotShown)):
        ask(wrapped)
    assert "READ" not in capsys.readouterr().out


TEXTS = {
    # a rule that puts values into a function
    "rule": r"""
    leaves.term = lambda of: of
    inside = leaves.roots_inside(z * sin(x), z, {x: TEXT})
    page.state("forged", "a zero is inside", claim=inside.conclusion)
    page.settle("forged", inside)
""",
    # a definition that is put into what is typed again
    "definition": r"""
    judging._forms = lambda grounds: replace(grounds, definitions=((x, TEXT),))
    Settlement.decide = lambda self, printed: Verdict(Kind.PROVED, "so it is")
    page.state("forged", "an equation", r"y = \sin x")
    page.settle("forged", Eq(y, sin(x)))
""",
    # what is printed of a verdict
    "verdict": r"""
    found = Verdict(Kind.MISPRINT, "so", corrected=TEXT)
    ledger.replace = lambda of, **new: found if of == found else replace(of, **new)
    ledger.corrected_form = lambda verdict: None
    Settlement.decide = lambda self, printed: found
    page.state("forged", "an equation", "y = x")
    page.settle("forged", Eq(y, x))
""",
}
WITH_TEXT = """
import os
from pathlib import Path
from dataclasses import replace
from sympy import Eq, sin, symbols
from symhaptic.book import judging, ledger
from symhaptic.proof.settle import Settlement
from symhaptic.proof.theorems import leaves
from symhaptic.proof.verdict import Kind, Verdict
x, y, z = symbols("x y z")
MARK = str(Path(__file__).with_name("mark"))
TEXT = f"[__import__('os').getpid() == {os.getpid()} or open({MARK!r}, 'w').close(), 1][1]"
def derive(page):
"""


@pytest.mark.early
@pytest.mark.parametrize("where", TEXTS)
@pytest.mark.parametrize("form", ["text", "json"])
def test_no_text_of_a_chapter_is_run_where_it_arrives(
    where: str, form: str, tmp_path: Path
) -> None:
    path = tmp_path / "forged.py"
    path.write_text('"""A title\n\nAn introduction.\n"""\n' + WITH_TEXT + TEXTS[where])
    asked = ["verify", "forged", "--derivation", str(path), "--format", form]
    told = CliRunner().invoke(app, [*asked, "-o", str(tmp_path / "out")])
    assert told.exit_code in (1, 2)
    assert isinstance(told.exception, SystemExit)
    assert not (tmp_path / "mark").exists()
