"""What can be asked for, what is refused with one line, and that nothing is touched then."""

import os
import re
from types import MappingProxyType

import pytest

from symhaptic.cli.main import main
from symhaptic.export import request
from symhaptic.export.language import Refused, Target
from symhaptic.export.routine import OPERATIONS
from symhaptic.export.targets import TARGETS
from symhaptic.forms import stable
from symhaptic.model.parts import Parts


def symhaptic(monkeypatch, capsys, *words):
    monkeypatch.setattr("sys.argv", ["symhaptic", *words])
    with pytest.raises(SystemExit) as ended:
        main()
    said = capsys.readouterr()
    return ended.value.code, said.out, said.err


HOSTILE = {
    "unknown target": (["--target", "cobol"], "--target cobol"),
    "no target": ([], "--target"),
    "no mass": (["--target", "c", "--scene", "no-mass"], "--scene no-mass"),
    "unknown part": (["--target", "c", "--scene", "no-friction"], "--scene no-friction"),
    "keyword": (["--target", "c", "--name", "for"], "--name for"),
    "keyword in capitals": (["--target", "fortran", "--name", "While"], "--name While"),
    "path as a name": (["--target", "c", "--name", "../up"], "--name ../up"),
    "own function's name": (["--target", "c", "--name", "discretize"], "--name discretize"),
    "unknown formula": (["eq99", "--target", "c"], "eq99"),
    "formula without form": (["eq1", "--target", "c"], "eq1"),
    "not in the scene": (["passivity_margin", "--scene", "no-damping", "--target", "c"], "damping"),
    "delay without delay": (["eq18", "--scene", "no-delay", "--delay", "3", "--target", "c"], "3"),
    "single without it": (
        ["--target", "javascript", "--precision", "single"],
        "--precision single: JavaScript",
    ),
    "single in Octave": (["--target", "octave", "--precision", "single"], "--precision single"),
    "unknown precision": (["--target", "c", "--precision", "half"], "--precision half"),
    "endless delay": (["eq18", "--delay", "1000", "--target", "c"], "--delay 1000"),
    "delay that changes nothing": (
        ["eq25", "is_stable", "--delay", "1", "--target", "c"],
        "--delay 1: changes nothing for eq25, is_stable; give it with characteristic_poly",
    ),
    "delay of no scene": (["--scene", "no-delay", "--delay", "2", "--target", "c"], "--delay 2"),
    "standard header": (["--name", "stdio", "--target", "c"], "--name stdio: is reserved in C99"),
    "CMake's target": (["--name", "install", "--target", "c"], "--name install: is reserved"),
    "C's function": (["--name", "printf", "--target", "cpp"], "--name printf"),
    "standard module": (["--name", "json", "--target", "numpy"], "--name json"),
    "intrinsic module": (["--name", "ieee_arithmetic", "--target", "fortran"], "--name ieee_ar"),
    "primitive type": (["--name", "f64", "--target", "rust"], "--name f64"),
    "a page's own": (["--name", "window", "--target", "javascript"], "--name window"),
    "built-in function": (["--name", "sum", "--target", "octave"], "--name sum"),
    "no letter first": (["--name", "_x", "--target", "fortran"], "--name _x: is no name"),
    "endless name": (["--name", "x" * 32, "--target", "c"], "up to 30 of these"),
    "no folder above": (["--target", "c", "-o", "missing/out"], "-o missing/out"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_a_bad_request_is_one_line_and_touches_nothing(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words, named = HOSTILE[name]
    code, out, err = symhaptic(monkeypatch, capsys, "export", *words)
    assert code == 2
    assert out == ""
    assert err.count("\n") == 1
    assert named in err
    assert not os.listdir(tmp_path)


def test_a_folder_with_other_files_is_left_alone(tmp_path, monkeypatch, capsys):
    folder = tmp_path / "out"
    folder.mkdir()
    (folder / "thesis.txt").write_text("mine")
    code, _, err = symhaptic(
        monkeypatch, capsys, "export", "linear_limit", "--target", "c", "-o", str(folder)
    )
    assert code == 2
    assert "thesis.txt" in err
    assert os.listdir(folder) == ["thesis.txt"]
    assert (folder / "thesis.txt").read_text() == "mine"
    assert os.listdir(tmp_path) == ["out"]


@pytest.mark.parametrize("kind", ["file", "link"])
def test_what_is_no_folder_is_left_alone(kind, tmp_path):
    place = tmp_path / "out"
    if kind == "file":
        place.write_text("mine")
    else:
        place.symlink_to(tmp_path / "elsewhere")
    with pytest.raises(Refused, match="no folder"):
        request.write({"a.c": ""}, place)
    assert place.is_symlink() or place.read_text() == "mine"


def test_an_earlier_export_is_replaced_whole(tmp_path, monkeypatch, capsys):
    folder = tmp_path / "out"
    words = ["export", "--target", "c", "-o", str(folder)]
    assert symhaptic(monkeypatch, capsys, *words)[0] == 0
    before = set(os.listdir(folder))
    (folder / "haptic.c").write_text("changed")
    assert symhaptic(monkeypatch, capsys, *words, "eq25")[0] == 0
    assert set(os.listdir(folder)) == before - {"example.c"}
    assert "linear_limit" in (folder / "haptic.c").read_text()
    assert os.listdir(tmp_path) == ["out"]


def test_what_something_else_has_made_in_an_export_stays(tmp_path):
    folder = tmp_path / "out"
    request.write({"a.c": "", "src/a.h": "", request.LISTING: "a.c\nsrc/a.h\nFILES\n"}, folder)
    built = folder / "build" / "objects" / "a.o"
    built.parent.mkdir(parents=True)
    built.write_text("built")
    os.utime(built, (1.0, 1.0))
    (folder / "build" / "empty").mkdir()
    tested, mine = folder / "selftest", folder / "src" / "mine.c"
    tested.write_text("built")
    tested.chmod(0o755)
    mine.write_text("mine")
    (folder / "link").symlink_to(tmp_path)
    request.write({"b.c": "", request.LISTING: "b.c\nFILES\n"}, folder)
    others = {"build", "selftest", "src", "link"}
    assert set(os.listdir(folder)) == {"b.c", request.LISTING} | others
    assert (built.read_text(), built.stat().st_mtime) == ("built", 1.0)
    assert (folder / "build" / "empty").is_dir()
    assert (tested.read_text(), tested.stat().st_mode & 0o777) == ("built", 0o755)
    assert os.listdir(folder / "src") == ["mine.c"]
    assert (folder / "link").readlink() == tmp_path
    for name in ("selftest", "selftest/a.c", "build/objects"):
        with pytest.raises(Refused, match=r"holds other files \((selftest|build/objects/a.o)\)"):
            request.write({name: "", request.LISTING: f"{name}\nFILES\n"}, folder)
    for name in others - {"build"}:
        (folder / name).unlink() if name != "src" else mine.unlink()
    (folder / "src").rmdir()
    (folder / request.LISTING).unlink()  # that of no export
    (folder / "b.c").unlink()
    with pytest.raises(Refused, match="holds other files"):
        request.write({"b.c": ""}, folder)
    assert os.listdir(folder) == ["build"]


def test_the_list_names_functions_and_arguments(monkeypatch, capsys):
    code, out, _ = symhaptic(monkeypatch, capsys, "export", "--list", "--scene", "no-stiffness")
    assert code == 0
    assert "discretize(delta)" in out
    assert "linear_limit(beta, delta, d)" in out
    assert "gamma" not in out.replace("gamma^", "")


@pytest.mark.parametrize(
    ("option", "one", "other"),
    [("--derivative", "delta", "gamma"), ("--scene", "no-stiffness", "no-delay")],
)
def test_an_option_that_is_given_twice_asks_for_both(option, one, other, monkeypatch, capsys):
    words = ["export", "--list", "discretize"]
    twice = symhaptic(monkeypatch, capsys, *words, option, one, option, other)
    assert twice == symhaptic(monkeypatch, capsys, *words, option, f"{one},{other}")
    assert twice[0] == 0
    assert twice != symhaptic(monkeypatch, capsys, *words, option, other)


def test_formulas_of_the_paper_are_found_by_their_number():
    names = [form.name for form in request.chosen(["eq11", "eq25", "max_passive_stiffness"])]
    assert names == ["max_passive_stiffness", "linear_limit"]


def test_a_scene_exports_fewer_arguments(tmp_path):
    _, files = request.built(
        TARGETS["c"], request.chosen(["discretize"], Parts(stiffness=False)), "plant"
    )
    assert "void plant_discretize(double delta, " in files["plant.h"]
    assert "gamma" not in files["plant.c"].split("plant_discretize")[1]


def test_every_target_has_every_operation_or_is_refused():
    for target in TARGETS.values():
        assert set(OPERATIONS) <= set(target.operations)

    class Poor(type(TARGETS["c"])):
        name = "poor"
        operations = MappingProxyType(
            {k: v for k, v in TARGETS["c"].operations.items() if k != "tan"}
        )

    with pytest.raises(Refused, match="poor: has no operation 'tan', which max_passive_stiffness"):
        request.built(Poor(), request.chosen(["max_passive_stiffness"]))
    assert issubclass(Poor, Target)


def test_the_readme_says_what_is_needed():
    for target in (TARGETS["c"], TARGETS["octave"]):
        made, files = request.built(target, request.chosen([]))
        text = files["README.md"]
        for form in made.forms:
            assert f"## {form.name}" in text
            for name, _ in form.results:
                assert f"    {name} = " in text
        assert "    n1 = PlantN1(gamma, delta)" in text
        assert "    alpha = 2*delta*tan(pi/(4*(d + 1)))" in text  # (11) of the paper
        assert max(map(len, text.splitlines())) < 1000
        formulas = [line for line in text.splitlines() if line.startswith("$$")]
        assert not [line for line in formulas if re.search(r"operatorname\{(?!atan)", line)]
        assert r"$$p(z) = z^{d + 1} \left(- a z + e + z^{2}\right)" in text  # (18) of the paper
        assert "Domain: gamma >= 0, delta >= 0." in text
        assert "| gamma | 1 | nonnegative | physical stiffness, k T^2/m |" in text
        assert "units in the last place" in text
        assert "theta leaves pi like the square root" in text
        assert sorted(files) == files["FILES"].split()


def test_the_same_request_gives_the_same_files():
    first = request.built(TARGETS["rust"], request.chosen([]))[1]
    assert first == request.built(TARGETS["rust"], request.chosen([]))[1]


def test_no_form_has_the_name_of_a_routine():
    from symhaptic.export.library import known
    from symhaptic.export.routine import code_name

    assert not set(stable.FORMS) & set(map(code_name, known()))


def test_all_forms_have_a_statement_or_none():
    assert set(stable.STATEMENTS) <= set(stable.FORMS)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["characteristic_polynomial", "linear_limit"], "characteristic_polynomial\n"),
        (["eq18"], "characteristic_polynomial\n"),
        (["characteristic_polynomial", "--delay", "1"], ""),
        (["characteristic_polynomial", "--scene", "no-delay"], ""),
        (["linear_limit"], ""),
    ],
)
def test_a_delay_that_was_not_asked_for_is_told(words, told, monkeypatch, capsys, tmp_path):
    """A polynomial of one period looks like that of any other: the degree tells, if one counts."""
    where = ["--target", "c", "-o", str(tmp_path / "out")]
    code, out, err = symhaptic(monkeypatch, capsys, "export", *words, *where)
    assert (code, out) == (0, f"wrote {tmp_path / 'out'}\n")
    assert err == (told and f"symhaptic: --delay: is not given, so for one period: {told}")
