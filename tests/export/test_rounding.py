"""What is proved of rounding errors: Gappa proves it, Coq checks that, and half is refused."""

import random
import re
import shutil
import subprocess
from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from symhaptic.export import request
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.request import chosen
from symhaptic.export.rounding import FORMATS, goals
from symhaptic.export.targets import TARGETS
from symhaptic.model.parts import ALL, FULL

pytestmark = pytest.mark.ci

NEEDS_GAPPA = pytest.mark.skipif(
    shutil.which("gappa") is None, reason="gappa is not found; on Debian: apt install gappa"
)


def proved(names=(), parts=FULL, precision=DOUBLE, **options):
    target = TARGETS["c"].at(precision)
    made, _ = request.built(target, chosen(names, parts, **options), vectors=False)
    return {goal.name: goal for routine in made.public for goal in goals(routine, target)}


def gappa(text, *options):
    return subprocess.run(
        ["gappa", *options], input=text, capture_output=True, text=True, timeout=600, check=False
    )


FOUND = {
    # three roundings; 2 delta is exact; a sum of two terms, one or two of them rounded; one product
    "linear_limit_alpha": ((), "3.01"),
    "max_passive_stiffness_alpha": (("tan",), "1"),
    "characteristic_polynomial_p2": (("n1", "exp"), "4.01"),
    "characteristic_polynomial_p1": (("n0", "n1"), "5.01"),
    "characteristic_polynomial_p0": (("n0",), "1"),
}
"""What is given, and the bound, as counted by hand: u for each rounding of a product or quotient;
of a sum of two terms up to M, those of the terms and 2 u for the sum."""


def test_what_is_proved_in_the_full_scene():
    found = proved(list({"_".join(name.split("_")[:-1]) for name in FOUND}))
    assert {n: (g.given, f"{float(g.bound):g}") for n, g in found.items()} == FOUND


def every_goal():
    """Of each scene and precision, derivatives included, each text once."""
    texts = {}
    for parts, precision in product(ALL, (DOUBLE, SINGLE)):
        for goal in proved(parts=parts, precision=precision).values():
            texts.setdefault(goal.text, goal)
    derivatives = proved(["linear_limit", "characteristic_polynomial"], derivatives=("beta",))
    return [*texts.values(), *derivatives.values()]


@pytest.mark.slow
@NEEDS_GAPPA
def test_gappa_proves_each_goal_of_every_scene():
    for goal in every_goal():
        found = gappa(goal.text)
        assert found.returncode == 0, (goal.text, found.stderr)


@pytest.mark.parametrize("name", FOUND)
@NEEDS_GAPPA
def test_gappa_proves_a_bound_and_refuses_half_of_it(name):
    goal = proved([name.rpartition("_")[0]])[name]
    assert gappa(goal.text).returncode == 0
    half = goal.at(goal.bound / 2)
    assert half != goal.text
    assert gappa(half).returncode == 1


@pytest.mark.slow
@pytest.mark.parametrize("name", FOUND)
@NEEDS_GAPPA
def test_gappa_refuses_what_is_changed_in_one_place(name):
    """Another operation, one more rounding, fewer digits, a wider range: the bound is not left."""
    text = proved([name.rpartition("_")[0]])[name].text
    last = re.findall(r"^v\d+ = rnd\((s\d+)\);$", text, re.M)[-1]
    small = re.findall(r"^(s\d+) = \S+ [*/] \S+;$", text, re.M)[-1]
    wrong = [
        text.replace(f" = rnd({last});", f" = rnd(1.5 * {last});"),
        text.replace(f" = rnd({last});", f" = rnd(rnd(3 * {last}) / 3);"),
        text.replace("@rnd = float<ieee_64, ne>;", "@rnd = float<ieee_64, zr>;"),
        text.replace("@rnd = float<ieee_64, ne>;", "@rnd = float<ieee_32, ne>;"),
        text.replace(f"|{small}| in [1b-1021,", f"|{small}| in [1b-1060,"),
    ]
    for changed in wrong:
        assert changed != text
        assert gappa(changed).returncode != 0, changed


_BY_FIELD = (
    "intros; field; repeat split; first [assumption | intro Z; match goal with "
    "H : _ <> _ |- _ => apply H; rewrite Z; ring end]."
)
"""A quotient rewritten; where a product is not zero, no factor is."""


def for_coq(proof: str) -> str:
    """What `gappa -Bcoq` writes, with each rewriting that it was told of shown, and not assumed."""
    shown = re.sub(
        r"^Hypothesis (\w+ : .*?\.)$", rf"Lemma \1\nProof. {_BY_FIELD} Qed.", proof, flags=re.M
    )
    last = re.findall(r"^Lemma (\w+)", proof, flags=re.M)[-1]
    return f"Require Import Reals.\n{shown.rstrip()}\nPrint Assumptions {last}.\n"


COQ = "coqc is not found or knows no Gappa; on Debian: apt install gappa libcoq-gappa"


@pytest.mark.slow
@pytest.mark.parametrize("name", FOUND)
@NEEDS_GAPPA
def test_coq_checks_the_proof_and_assumes_the_reals_alone(name, tmp_path):
    if shutil.which("coqc") is None:
        pytest.skip(COQ)
    (tmp_path / "known.v").write_text("Require Import Gappa.Gappa_library.\n")
    compile_ = {"cwd": tmp_path, "capture_output": True, "text": True, "check": False}
    if subprocess.run(["coqc", "-q", "known.v"], **compile_).returncode:
        pytest.skip(COQ)
    proof = gappa(proved([name.rpartition("_")[0]])[name].text, "-Bcoq").stdout
    (tmp_path / "goal.v").write_text(for_coq(proof))
    done = subprocess.run(["coqc", "-q", "goal.v"], **compile_)
    assert done.returncode == 0, done.stderr
    axioms = re.findall(r"^([\w.]+)$|^([\w.]+) :", done.stdout.partition("Axioms:")[2], re.M)
    known = ("ClassicalDedekindReals.", "FunctionalExtensionality.", "Classical_Prop.")
    assert axioms
    assert all("".join(found).startswith(known) for found in axioms), done.stdout


# -- against floats and exact fractions, by another road ------------------------------------

RANGE = {53: np.float64, 24: np.float32}


def at_random(goal, seed):
    """The largest error that random floats show, in parts of a last place of the largest term.

    The lines of the goal are read as assignments: once with NumPy's floats, once with fractions.
    """
    generator, worst = random.Random(seed), Fraction(0)
    kind = RANGE[goal.bits]
    lines = re.findall(r"^(\w+) = (.*);$", goal.text, re.M)
    constant = re.compile(r"\b(\d+)b(-?\d+)\b")
    for _ in range(300):
        given = {
            f"{name}_": kind(generator.choice((-1, 1)) * generator.lognormvariate(0, 3))
            for name, text in lines
            if text == f"rnd({name}_)"
        }
        floats = {"rnd": kind, **given}
        exact = {name: Fraction(*value.as_integer_ratio()) for name, value in given.items()}
        for name, text in lines:
            if name.startswith("V"):
                exact[name] = eval(constant.sub(r"(\1*F(2)**\2)", text), {"F": Fraction}, exact)
            else:
                floats[name] = eval(constant.sub(r"K(\1*2.0**\2)", text), {"K": kind}, floats)
                if not name.startswith(("s", "v")):
                    exact[name] = exact[f"{name}_"]
        final = f"V{sum(name.startswith('V') for name, _ in lines)}"
        off = abs(Fraction(*floats[final.replace("V", "v")].as_integer_ratio()) - exact[final])
        terms = [exact[t] for t in re.findall(r"\|(\w+) / M\| <= 1", goal.text)] or [exact[final]]
        unit = Fraction(*np.spacing(kind(float(max(map(abs, terms))))).as_integer_ratio())
        worst = max(worst, off / unit)
    return worst


@pytest.mark.parametrize("precision", [DOUBLE, SINGLE], ids=lambda p: p.name)
def test_floats_are_within_what_is_proved(precision):
    """And come near to it: the bounds are not idle."""
    names = list({"_".join(name.split("_")[:-1]) for name in FOUND})
    for goal in proved(names, precision=precision).values():
        worst = at_random(goal, 2014)
        assert worst <= goal.bound, goal.name
        assert worst > goal.bound / 4, goal.name


def test_a_readme_says_proved_where_it_is_and_measured_elsewhere():
    made, files = request.built(TARGETS["c"], chosen([]))
    about = dict(re.findall(r"^## (\w+)\n(.*?)(?=^## |\Z)", files["README.md"], re.M | re.S))
    for routine in made.public:
        for goal in goals(routine, TARGETS["c"]):
            assert f"- {goal.result}: at most {float(goal.bound):g}" in about[routine.name]
            assert files[goal.file] == goal.text
            low, high = FORMATS[53][1:]
            assert f"has a size from 2^{low} to 2^{high}" in about[routine.name]
    with_goals = {r.name for r in made.public if goals(r, TARGETS["c"])}
    assert {name for name, text in about.items() if "proved by" in text} == with_goals
    assert (
        "alpha: at most 1, with the value of tan taken as given, for integer delays"
        in (about["max_passive_stiffness"])
    )
    assert "integer delays (rounding" not in about["linear_limit"]
    assert all("measured" in text for name, text in about.items() if name in with_goals)
    assert "proved by" not in about["stability_boundary"]
    assert "proved by" not in request.built(TARGETS["rust"], chosen([]))[1]["README.md"]
