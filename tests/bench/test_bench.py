"""A measurement on tiny sizes: what is measured is right; how long it takes is not tested."""

import json
import math
import subprocess
import sys

import flint
import numpy as np
import pytest
from docutils import nodes
from flint import arb

from symhaptic.balls import winding
from symhaptic.balls.exact import EXACT
from symhaptic.bench import error, functions, measuring, models, peers, timing, tracing, verdicts
from symhaptic.bench.error import errors as exported_errors
from symhaptic.bench.error import suspects
from symhaptic.bench.functions import Effort, WrongExact, chosen, confirm, errors
from symhaptic.bench.printed import expressions, function, swings
from symhaptic.book.chapters import expected_bench
from symhaptic.book.measured import record, tables
from symhaptic.book.measured.chapter import measurement
from symhaptic.cli.computing import bench
from symhaptic.export import request

TINY = measuring.Size(
    Effort(12, 2, 20), (0, 1), (1e-3, 1e-5), 15, 3, (0, 2), 2, 4, 3, 4, ("max_passive_stiffness",)
)


@pytest.fixture(scope="module", autouse=True)
def _no_waiting():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(timing, "LEAST", 1e-9)
        yield


@pytest.fixture(scope="module")
def tiny(_no_waiting):
    return measuring.measured(TINY)


def form(name):
    return request.chosen([name])[0]


# -- errors -------------------------------------------------------------------------------


def test_errors_of_a_hand_made_case():
    """linear limit (25): (beta + delta)/(d + 1/2) = 3/(3/2) = 2, whose last place is 2^-51."""
    points = [[1.0, 2.0, 1.0]] * 3
    found = [[2.0], [2.0 + 3 * 2.0**-51], [math.nan]]
    row = errors(form("linear_limit"), points, found, 2.0**-52)
    assert (row["points"], row["worst"], row["median"]) == (3, 3.0, 1.5)
    assert row["missing"] == pytest.approx(1 / 3)


def test_the_error_of_a_ball_is_its_radius():
    row = errors(form("linear_limit"), [[1.0, 2.0, 1.0]], [[arb(2, 2.0**-50)]], 2.0**-52)
    assert row["worst"] == pytest.approx(2.0, rel=1e-8)  # radii are rounded upwards, 30 bits


def test_the_worst_angle_is_found_next_to_the_end_of_a_flat_need():
    # the largest of the need at 4 000 001 angles by NumPy; a Newton step that came back to where it
    # began left 39.0604369
    wall = 1.3359001321000095, 0.933828551283679, 40.38085173538582, 0.17566314077674589
    with flint.ctx.workprec(200):
        (margin,) = EXACT["passivity_margin"](*wall)
    assert abs(float(margin) - 39.06043201637795) < 1e-13


@pytest.mark.slow
def test_what_is_no_number_anywhere_is_no_suspect():
    """A planted error among many points outside the domain."""
    stiffest = form("max_stable_stiffness")
    arrays = [np.full(200, x, dtype=np.float32) for x in (20.0, 1.0, 2.0)]
    arrays[0][77] = 0.5
    found = np.full((3, 200), np.nan, dtype=np.float32)
    assert 77 in suspects(stiffest, arrays, found)
    found[:, 77] = 1.0
    assert 77 in suspects(stiffest, arrays, found)


def test_no_number_where_there_is_one_is_infinitely_wrong(monkeypatch):
    """Also where the routines that find the sizes of terms give none, as the function does."""
    stiffest, device = form("max_stable_stiffness"), [np.array([x]) for x in (0.5, 1.0, 2.0)]
    monkeypatch.setattr("symhaptic.bench.error.largest", lambda *_: np.full((3, 1), math.nan))
    off = exported_errors(stiffest, device, np.full((3, 1), math.nan))
    assert np.isinf(off).all()


def test_a_wrong_exact_value_is_noticed(monkeypatch):
    exact = error.EXACT["linear_limit"]
    points = [np.array([0.3]), np.array([0.01]), np.array([4.0])]
    confirm(form("linear_limit"), points)
    error.exactly.cache_clear()
    wrong = {"linear_limit": lambda *p: tuple(v * (1 + arb(2) ** -120) for v in exact(*p))}
    monkeypatch.setattr(error, "EXACT", wrong)
    with pytest.raises(WrongExact, match="linear_limit, alpha"):
        confirm(form("linear_limit"), points)
    error.exactly.cache_clear()


@pytest.mark.parametrize("name", list(functions.FUNCTIONS))
def test_the_exact_values_are_those_of_another_road(name):
    for which in functions.SETS:
        confirm(form(name), [a[:3] for a in chosen(form(name), which, 40)])


def test_the_print_is_read_as_it_stands():
    """A free mass pushed for one period: n1 = n0 = 1/2, a = 2, e = 1; (14) is 0/0 there."""
    plant = form("discretize")
    near = [complex(v) for v in function(plant, "printed", "numpy")(1e-6 + 0j, 0j)]
    assert near == pytest.approx([0.5, 0.5, 2.0, 1.0], abs=1e-3)
    with np.errstate(all="ignore"):
        there = function(plant, "printed", "numpy")(np.array([0j]), np.array([0j]))
    assert np.isnan(there[0]).all()
    assert swings(plant, "printed")
    assert not swings(form("linear_limit"), "printed")
    assert expressions(form("stability_boundary"), "printed") == ()


# -- the other sections -------------------------------------------------------------------


def test_the_distance_of_a_point_from_the_curve():
    """Beside a point of the curve, along its normal, by differences of exact points."""
    with_root = np.array(
        [tracing.stability_boundary(t, tracing.GAMMA, tracing.DELTA, 1) for t in (0.4, 0.4 + 1e-6)]
    )
    way = with_root[1] - with_root[0]
    normal = np.array([-way[1], way[0]]) / np.hypot(*way)
    assert tracing.distance(with_root[0], 1) < 1e-15
    assert tracing.distance(with_root[0] + 1e-5 * normal, 1) == pytest.approx(1e-5, rel=1e-4)


def test_the_truth_of_a_verdict_agrees_with_eigenvalues_away_from_the_boundary():
    for distance in (1e-3, 1e-2):
        for delay in (0, 3):
            walls, truth = verdicts.near(delay, distance, 3)
            rows = verdicts.coefficients(walls, delay)
            assert (verdicts.by_roots(rows) == truth).all()
            assert (verdicts.by_jury(rows) == truth).all()


@pytest.mark.ci
def test_the_print_refuses_a_plant_without_stiffness(tmp_path):
    """(14) is 0/0 for gamma = 0; the other methods judge: this free mass is stable."""
    one = np.array([0.5]), np.array([1.0]), np.array([0.0]), np.array([0.0])
    with np.errstate(all="ignore"):
        said = {name: way(one, 0)[0] for name, (way, _) in verdicts.methods(tmp_path).items()}
    assert np.isnan(said.pop("(14) as printed"))
    assert all(said.values())


def test_the_limit_at_a_virtual_damping_is_on_the_boundary():
    gamma, delta, beta = np.array([5e-4]), np.array([0.01]), np.array([0.02])
    alpha = models.limit(beta, gamma, delta, 1)
    for side in (-1e-9, 1e-9):
        one = winding.stable(float(alpha[0] * (1 + side)), 0.02, 5e-4, 0.01, 1)
        assert one is (side < 0)


@pytest.mark.ci
def test_peers_answer_the_same(tiny):
    """But a phase margin in fractions of a period, which is not the delay that a loop bears."""
    for row in tiny["peers"]:
        if row["installed"] and row["worst"] is not None:
            phase = row["tool"].endswith("stability_margins")
            assert row["worst"] < (0.02 if phase else 1e-9), row


def test_what_users_call_is_what_is_timed():
    import symhaptic

    asked = {task.name: task for task in peers.tasks(2)}
    assert asked["delay margin"].own is symhaptic.delay_margin
    assert asked["sampled device"].own is symhaptic.discretize


def test_a_verdict_that_is_not_known_is_no_wrong_one():
    said = verdicts.known([True, False, False], [0, 2, -1])
    assert said[:2].tolist() == [1.0, 0.0]
    assert np.isnan(said[2])


def test_figures_in_sentences_are_those_of_the_record(tiny):
    """A rival that takes 37 times as long does so in words."""
    from symhaptic.book.measured.says import sentences

    rows = [dict(row) for row in tiny["peers"] if row["task"] == "stable or not"]
    for row in rows:
        row["ratio_one"], row["ratio_many"] = (1, 1) if row["tool"] == "symhaptic" else (37, 4100)
    assert "37 times as long for one" in sentences({**tiny, "peers": rows})["peers"]
    assert "4100 times" in sentences({**tiny, "peers": rows})["peers"]
    assert set(sentences(tiny)) == set(record.FIELDS) - {"functions"} | {"formulas"}


def test_a_record_says_when_and_of_what_it_is(tiny):
    assert tiny["date"] in tables.about(tiny)
    assert tables.about({**tiny, "commit": "0123abcd"}).count("commit 0123abcd") == 1
    old = {k: v for k, v in tiny.items() if k not in ("date", "commit", "seconds")}
    assert "commit" not in tables.about(old)


def test_a_tool_that_is_missing_is_said_to_be(monkeypatch, tiny):
    monkeypatch.setattr(peers, "find_spec", lambda name: None)
    rows = [r for r in peers.measured(4) if r["tool"].startswith("python-control")]
    assert rows
    assert not any(r["installed"] for r in rows)
    text = tables.markdown({**tiny, "peers": rows})
    assert "not installed" in text


# -- the record ---------------------------------------------------------------------------


def test_a_record_is_read_back(tiny, tmp_path):
    path = tmp_path / "bench.json"
    path.write_text(record.text(tiny))
    assert record.read(path) == json.loads(path.read_text())
    assert tiny["quick"] is True
    for table in tables.tables(tiny):
        assert all(len(row) == len(table.head) for row in table.rows), table.title


@pytest.mark.parametrize("section", list(record.FIELDS))
def test_a_record_that_lacks_something_is_refused(section, tiny, tmp_path):
    path = tmp_path / "bench.json"
    path.write_text(record.text({k: v for k, v in tiny.items() if k != section}))
    with pytest.raises(record.BadRecord, match=f"has no {section}"):
        record.read(path)
    field = next(iter(record.FIELDS[section]))
    rows = [{k: v for k, v in tiny[section][0].items() if k != field}]
    path.write_text(record.text({**tiny, section: rows}))
    with pytest.raises(record.BadRecord, match=f"{section}, row 0: {field}"):
        record.read(path)


@pytest.mark.parametrize("content", ["", "[]", '{"schema": 0}', "\x00"])
def test_what_is_no_record_is_refused_in_one_line(content, tmp_path):
    path = tmp_path / "bench.json"
    path.write_text(content)
    with pytest.raises(record.BadRecord) as wrong:
        record.read(path)
    assert "\n" not in str(wrong.value)
    assert str(path) in str(wrong.value)


def test_bad_input_gives_one_line_and_writes_nothing(tmp_path):
    taken = tmp_path / "file"
    taken.write_text("x")
    for place in (taken, taken / "inside"):
        run = subprocess.run(
            [sys.executable, "-m", "symhaptic", "bench", "--quick", "-o", str(place)],
            capture_output=True,
            text=True,
            check=False,
        )
        assert run.returncode == 2
        assert run.stderr.startswith("symhaptic: error: -o ")
        assert run.stderr.count("\n") == 1
    assert taken.read_text() == "x"


def test_a_measurement_without_matplotlib_claims_no_plots(tmp_path, monkeypatch, capsys):
    known = record.read(expected_bench())
    monkeypatch.setattr(measuring, "measured", lambda *_: known)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    bench(quick=True, output=tmp_path)
    told = capsys.readouterr()
    assert told.out == f"wrote {tmp_path / 'bench.json'} and tables in {known['seconds']} s\n"
    assert told.err == "no plots: they need matplotlib; pip install 'symhaptic[report]'\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["bench.json", "bench.md"]


def test_the_page_of_the_book_has_each_table_with_its_rows(tiny, tmp_path):
    path = tmp_path / "bench.json"
    path.write_text(record.text(tiny))
    found = list(measurement(path).findall(nodes.table))
    wanted = [[table.head, *table.rows] for table in tables.tables(tiny)]
    assert [[len(row) for row in one.findall(nodes.row)] for one in found] == [
        [len(row) for row in one] for one in wanted
    ]
    first = [next(one.findall(nodes.entry)).astext() for one in found]
    assert first == [one[0][0] for one in wanted]
    assert measurement(tmp_path / "none.json") is None


@pytest.mark.slow
def test_plots_and_tables_are_written(tiny, tmp_path):
    from symhaptic.bench.measuring import FORMATS, write

    write(tiny, tmp_path)
    names = {p.name for p in tmp_path.iterdir()}
    assert {"bench.json", "bench.md"} < names
    for format in FORMATS:
        assert f"bench_functions.{format}" in names
    shown = measurement(tmp_path / "bench.json")
    assert "Functions in double precision." in shown.astext()
    assert measurement(tmp_path / "none.json") is None


# -- the page ------------------------------------------------------------------------------


def test_the_page_shows_the_committed_record():
    from symhaptic.book.chapters import beside
    from symhaptic.book.measured.page import renewed

    page = (beside("docs") / "speed.md").read_text(encoding="utf-8")
    assert renewed(page, record.read(expected_bench())) == page


def test_the_call_for_an_error_is_the_fastest_that_keeps_it():
    row = {"function": "f", "missing": 0, "last": 1.0, "way": "C", "precision": "float64"}
    slow = {"way": "package", "precision": "50 digits", "last": 1e-49}
    rows = [
        {**row, **own, "set": which, "seconds": seconds, "worst": worst}
        for which in ("ordinary", "hard")
        for own, seconds, worst in (({}, 1e-7, 1e-15), (slow, 1e-4, 1e-3))
    ]
    (cells,) = tables.calls(rows).rows
    assert cells == ("f", *["C: 100 ns"] * 2, *["digits=50: 100 us"] * 2)
    rows[-2]["missing"] = 0.1
    assert tables.calls(rows).rows[0][1] == "digits=50: 100 us"
    assert tables.calls(rows[:1]).rows[0][3] == "-"


def test_the_call_for_a_distance_judges_all_and_rightly():
    good, open_ = {"0.1": 0.0, "1e-14": 0.0}, {"0.1": 0.0, "1e-14": 0.2}
    rows = [
        {"delay": 0, "method": "counted", "wrong": good, "open": open_, "near": {"0.1": 1e-7}},
        {"delay": 0, "method": "certified", "wrong": good, "open": good,
         "near": {"0.1": 2e-7, "1e-14": 1e-4}},
    ]  # fmt: skip
    assert tables.judges(rows).rows == (
        ("1e-1", "is_stable", "100 ns"),
        ("1e-14", "is_stable, certified=True", "100 us"),
    )
