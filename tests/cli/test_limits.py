"""A device from a file: limits with its arm and without, a picture, one line for bad files."""

import json
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from command import symhaptic
from scipy.linalg import expm

from symhaptic.cli.main import main

GUIDE = (Path(__file__).parents[2] / "docs" / "limits.md").read_text(encoding="utf-8")
DEVICE = GUIDE.split("```toml\n")[1].split("```")[0]


@pytest.fixture
def device(tmp_path):
    path = tmp_path / "device.toml"
    path.write_text(DEVICE, encoding="utf-8")
    return path


def growth(K, B, m, b, k, T):
    """Largest modulus of the loop's roots, 1.5 periods late: half a period by half a period."""
    state = np.array([[0, 1, 0], [-k / m, -b / m, 1 / m], [0, 0, 0]])
    half = expm(state * T / 2)
    step, push = half[:2, :2], half[:2, 2]

    def period(start):
        """Position, speed, the position one sample ago, and the forces of the last two samples."""
        x, before, one, two = start[:2], start[2], start[3], start[4]
        force = K * x[0] + B * (x[0] - before) / T
        middle = step @ x - push * two  # what was measured two samples ago still pushes
        return np.r_[step @ middle - push * one, x[0], force, one]

    matrix = np.column_stack([period(row) for row in np.eye(5)])
    return np.abs(np.linalg.eigvals(matrix)).max()


def test_the_example_of_the_guide(device):
    run = symhaptic("limits", device, "--format", "json")
    assert run.returncode == 0, run.stderr
    found = json.loads(run.stdout)
    loop = {"m": 0.572, "b": 6.005, "k": 40.0, "T": 1e-3}
    stiffest = found["stiffest_stable"]
    for share, stable in ((0.999, True), (1.001, False)):
        assert (growth(share * stiffest["K"], stiffest["B"], **loop) < 1) == stable
        free = found["stable_without_virtual_damping"]
        assert (growth(share * free["K"], 0.0, **loop) < 1) == stable
        here = found["wall"]["stable_up_to"]
        assert (growth(share * here["K"], 5.0, **loop) < 1) == stable
    assert found["wall"]["stable"] is True
    assert found["wall"]["passive"] is False
    assert found["wall"]["passive_up_to"]["K"] is None  # 5 Ns/m are more than the device damps
    assert found["wall"]["passivity_margin"] < 0
    # the device alone: less than what its damper bears without delay, 2 b/T (Colgate, Schenkel)
    assert 0 < found["stiffest_passive"]["K"] < 2 * 0.005 / 1e-3


def test_a_wall_of_little_damping_has_a_passive_limit(device):
    """Without delay b > K T/2 + |B| (Colgate, Schenkel), b that of the device."""
    text = device.read_text().replace('delay = "1.5 ms"\n', "").replace('"5 Ns/m"', '"0.002 Ns/m"')
    device.write_text(text)
    found = json.loads(symhaptic("limits", device, "--format", "json").stdout)
    assert found["wall"]["passive_up_to"]["K"] == pytest.approx(2 * 0.003 / 1e-3)


def test_words_and_a_picture(device, tmp_path):
    run = symhaptic("limits", device, "-o", tmp_path / "walls.png")
    assert run.returncode == 0, run.stderr
    assert "is stable and not passive" in run.stdout
    assert "passive up to no stiffness" in run.stdout
    assert (tmp_path / "walls.png").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('"72 g"', '"72 V"', "device.toml:1: mass: '72 V' is not allowed; give a number"),
        ("\ndelay", "\ndealy", "device.toml:4: dealy is not known; did you mean 'delay'?"),
        ('"1 ms"', '"0 ms"', "device.toml:3: sampling_period: '0 ms' is not allowed"),
        ('mass = "72 g"\n', "", "device.toml: mass is missing, such as mass = "),
        ("[arm]", "[hand]", "device.toml:6: [hand] is no table; give one of"),
        ('B = "5 Ns/m"', "", "device.toml: [wall] needs K and B"),
        ('K = "800 N/m"', "K = true", "device.toml:12: K: True is not allowed"),
        ('"800 N/m"', '"800 N"', "device.toml:12: K: '800 N' is not allowed"),
        ("[wall]", "[wall", "device.toml: "),
        ('K = "800 N/m"\nB = "5 Ns/m"\n', "", "device.toml: [wall] needs K and B"),
        ('"800 N/m"', '"1e400 N/m"', "device.toml:12: K: '1e400 N/m' is not allowed; give finite"),
        ('"5 Ns/m"', "nan", "device.toml:13: B: nan is not allowed; give finite numbers"),
        ('"800 N/m"', '"1e80 N/m"', "device.toml: K: 1e+80 is not allowed; "),
        ('"40 N/m"', '"1e25 N/m"', "device.toml:9: stiffness: 1e+25 with mass=0.572 and s"),
        ('"0.005 Ns/m"', '"1e80 Ns/m"', "device.toml:2: damping: 1e+80 with mass=0.072 and sa"),
        ('delay = "1.5 ms"', "delay_samples = 1e16", "device.toml:4: delay_samples: 1e+16 with"),
        ('delay = "1.5 ms"', "delay_samples = 2e5", "device.toml: delay: 200000.0 is not allowed"),
        ('"72 g"', 400 * "9", "... is not allowed; give finite numbers > 0"),
        ('"72 g"', 9999 * "9", "device.toml: Exceeds the limit (4300 digits) for integer string"),
        ('"72 g"', 3000 * "[" + 3000 * "]", "device.toml: is nested too deeply"),
        ("[arm]\n", '[arm]\nname = "Hogan"\n', "device.toml:8: mass and name exclude"),
        ("[arm]", "[[arm]]", "device.toml: arm is not a table; write [arm]"),
    ],
)
def test_a_bad_file_is_told_in_one_line(device, old, new, told):
    assert old in DEVICE
    device.write_text(DEVICE.replace(old, new, 1), encoding="utf-8")
    run = symhaptic("limits", device)
    assert run.returncode == 2
    assert not run.stdout
    assert told in run.stderr
    assert len(run.stderr.splitlines()) == 1


RANGED = """device = "Phantom Premium 1.5"
sampling_period = "1 ms"
delay_samples = 1.5

[arms]
mass = ["0.5 kg", "2 kg"]
damping = "6 Ns/m"
stiffness = ["0 N/m", "600 N/m"]

[wall]
K = "2 N/mm"
B = "14 Ns/m"
"""


def test_a_range_of_arms_is_proved_and_drawn(tmp_path):
    from symhaptic import Arm, Scene

    path = tmp_path / "device.toml"
    path.write_text(RANGED, encoding="utf-8")
    run = symhaptic("limits", path, "--format", "json", "-o", tmp_path / "walls.svg")
    assert run.returncode == 0, run.stderr
    safe = json.loads(run.stdout)["safe"]
    assert safe["wall"] is True
    assert safe["arms"] == "0.5 to 2 kg, 6 Ns/m, 0 to 600 N/m"
    (_, high), (left, right) = safe["rectangle"]["K"], safe["rectangle"]["B"]
    device = Scene.of("Phantom Premium 1.5", sampling_period=1e-3, delay_samples=1.5)
    for mass in (0.5, 1, 2):
        for stiffness in (0, 300, 600):
            held = device.held_by(Arm(mass=mass, damping=6, stiffness=stiffness))
            assert held.is_stable(high, [left, right]).all()
            assert not held.is_stable(4 * safe["stiffest"]["K"], safe["stiffest"]["B"] / 4)
    assert (tmp_path / "walls.svg").stat().st_size > 10_000
    path.write_text(RANGED.replace("2 N/mm", "900 N/mm"), encoding="utf-8")
    run = symhaptic("limits", path, "--format", "json")
    assert run.returncode == 0, run.stderr
    beyond = json.loads(run.stdout)["safe"]
    assert (beyond["wall"], beyond["best_damping"]) == (False, None)
    path.write_text(RANGED, encoding="utf-8")
    words = symhaptic("limits", path).stdout
    assert "with every arm   of 0.5 to 2 kg, 6 Ns/m, 0 to 600 N/m:\n  proved stable  up to" in words
    assert "the wall is    safe" in words
    assert " Ns/m gives 2000 N/m the largest delay margin; safe are " in words


def test_where_nothing_is_proved_the_limits_of_the_device_are_said(tmp_path):
    """And that nothing is: 0.1 s of delay, with heavy arms on springs of 32 rad/s."""
    path = tmp_path / "device.toml"
    path.write_text(
        'mass = "50 g"\ndamping = "0.05 Ns/m"\nsampling_period = "2 ms"\ndelay = "0.13 s"\n'
        '[arms]\n[wall]\nK = "0.1 N/m"\nB = "0.01 Ns/m"\n'
    )
    run = symhaptic("limits", path, "-o", tmp_path / "walls.svg")
    assert run.returncode == 0, run.stderr
    assert "stable up to     " in run.stdout
    assert "\n  not proved     delay: nothing is shown for more than 60 sampling per" in run.stdout
    assert "\n  the wall is    NOT PROVED SAFE\n" in run.stdout
    assert (tmp_path / "walls.svg").stat().st_size > 10_000
    found = json.loads(symhaptic("limits", path, "--format", "json").stdout)
    assert found["safe"]["not_proved"].startswith("delay: nothing is shown for more than 60 ")
    assert found["stiffest_stable"]["K"] > 0


@pytest.mark.ci
def test_a_slow_loop_is_proved_in_time(tmp_path):
    """50 g, 0.05 Ns/m, 2 ms, 6 ms of delay: nothing was proved after 60 000 pieces."""
    path = tmp_path / "device.toml"
    path.write_text(
        'mass = "50 g"\ndamping = "0.05 Ns/m"\nsampling_period = "2 ms"\ndelay = "6 ms"\n'
        '[arms]\n[wall]\nK = "50 N/m"\nB = "1 Ns/m"\n'
    )
    found = json.loads(symhaptic("limits", path, "--format", "json").stdout)
    assert found["safe"]["wall"] is True
    assert found["safe"]["stiffest"]["K"] > 0.95 * found["stiffest_stable"]["K"]


def test_the_delay_margin_of_a_wall_begins_at_the_delay_of_the_loop(tmp_path):
    path = tmp_path / "device.toml"
    path.write_text(RANGED.partition("[arms]")[0] + "[wall]" + RANGED.partition("[wall]")[2])
    wall = json.loads(symhaptic("limits", path, "--format", "json").stdout)["wall"]
    assert wall["delay_margin_s"] == pytest.approx(wall["max_delay_s"] - 1.5e-3)
    later = 1.5e-3 + 0.99 * wall["delay_margin_s"]
    loop = {"mass": 0.072, "damping": 0.005, "sampling_period": 1e-3}
    from symhaptic import Scene

    assert Scene(**loop, delay=later).is_stable(2000.0, 14.0)
    assert not Scene(**loop, delay=later * 1.02).is_stable(2000.0, 14.0)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('"Phantom Premium 1.5"', '"Phantom Premium 2"', "device.toml:1: device: 'Phantom Premi"),
        ('"Phantom Premium 1.5"', '"Touch"', "device.toml: mass is missing, such as mass = "),
        ('["0.5 kg", "2 kg"]', '["2 kg", "0.5 kg"]', "device.toml:6: mass: ['2 kg', '0.5 kg'] is"),
        ('["0.5 kg", "2 kg"]', '["2 kg"]', "device.toml:6: mass: ['2 kg'] is not allowed"),
        ('"6 Ns/m"', '"6 N/m"', "device.toml:7: damping: '6 N/m' is not allowed; give a number"),
        ('damping = "6', 'dampng = "6', "device.toml:7: dampng is not known; did you mean 'damp"),
    ],
)
def test_a_bad_range_is_told_in_one_line(tmp_path, old, new, told):
    path = tmp_path / "device.toml"
    assert old in RANGED
    path.write_text(RANGED.replace(old, new, 1), encoding="utf-8")
    run = symhaptic("limits", path)
    assert run.returncode == 2
    assert not run.stdout
    assert told in run.stderr
    assert len(run.stderr.splitlines()) == 1


@pytest.mark.parametrize("text", ["\ufeff" + DEVICE, DEVICE.replace("1.5 ms", "1500 \u03bcs")])
def test_what_editors_and_keyboards_make_of_it_is_the_same_device(device, text):
    """A mark of the byte order before it; the Greek letter that looks like the micro sign."""
    asked = ("limits", device, "--format", "json")
    meant = symhaptic(*asked).stdout
    device.write_text(text, encoding="utf-8")
    assert symhaptic(*asked).stdout == meant


@pytest.mark.parametrize(("delay", "period"), [("4.9", "0.7"), ("4.1", "0.1"), ("2.95", "0.05")])
def test_whole_periods_in_milliseconds_are_whole(tmp_path, delay, period):
    from symhaptic.scene.device_file import read

    path = tmp_path / "device.toml"
    loop = f'mass = "72 g"\nsampling_period = "{period} ms"\ndelay = "{delay} ms"\n'
    path.write_text(loop, encoding="utf-8")
    scene = read(path).scene
    assert scene.periods == Fraction(delay) / Fraction(period)
    assert (scene.mass, scene.delay) == (0.072, float(f"{delay}e-3"))


@pytest.mark.ci
def test_each_format_is_written_where_it_is_said(device, tmp_path):
    printed = {name: symhaptic("limits", device, "--format", name).stdout for name in ALL[:2]}
    for name, ending in ((*pair,) for pair in zip(ALL, ("txt", *ALL[1:]), strict=True)):
        for place, more in ((f"as.{ending.upper()}", ()), ("plain", ("--format", name))):
            run = symhaptic("limits", device, "-o", tmp_path / place, *more)
            assert (run.returncode, run.stderr) == (0, f"wrote {tmp_path / place}\n")
            written = (tmp_path / place).read_bytes()
            assert run.stdout == ("" if name in printed else printed["text"])
            assert written.decode() == printed[name] if name in printed else BEGIN[name] in written
    both = symhaptic("limits", device, "--format", "json", "-o", tmp_path / "walls.svg")
    assert both.stdout == printed["json"]


ALL = "text", "json", "svg", "png", "pdf"
BEGIN = {"svg": b"<svg", "png": b"\x89PNG", "pdf": b"%PDF-"}


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        (["--format", "png"], "--format png: needs -o FILE; text and json can be printed"),
        (["--format", "png", "-o", "walls.svg"], "-o walls.svg: does not end as --format png do"),
        (["--format", "text", "-o", "walls.json"], "-o walls.json: does not end as --format tex"),
        (["-o", "walls"], "-o walls: the ending '' is not allowed; give one of .text, .json, .svg"),
        (["-o", "no/walls.svg"], "-o no/walls.svg: cannot write there (No such file or direct"),
    ],
)
def test_a_format_that_is_not_that_of_the_file_is_refused(device, tmp_path, asked, told):
    run = symhaptic("limits", device, *asked, cwd=tmp_path)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr.startswith(f"symhaptic: error: {told}")
    assert run.stderr.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["device.toml"]


@pytest.mark.parametrize("asked", ["limits", "trace"])
def test_a_picture_without_what_draws_is_refused_before_the_work(
    device, monkeypatch, capsys, asked
):
    """After ``pip install symhaptic``, without what reports need."""
    place = device.with_name("walls.svg")
    words = {"limits": [device], "trace": ["--gamma", "0", "--delta", "1", "--delay", "0"]}
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setattr(
        sys, "argv", ["symhaptic", asked, *map(str, words[asked]), "-o", str(place)]
    )
    with pytest.raises(SystemExit, match="2"):
        main()
    out, error = capsys.readouterr()
    assert not out
    assert "needs matplotlib; pip install 'symhaptic[report]'" in error
    assert error.count("\n") == 1


def test_a_warning_is_one_line_that_names_the_argument(device):
    device.write_text(DEVICE.replace('"1.5 ms"', '"0.2 s"'), encoding="utf-8")
    run = symhaptic("limits", device)
    assert run.returncode == 0
    assert run.stderr.startswith("symhaptic: warning: delay: 0.2 s are 200 sampling periods; a ")
    assert run.stderr.count("\n") == 1


def test_no_file_and_no_picture(device, tmp_path):
    assert "cannot be read" in symhaptic("limits", tmp_path / "none.toml").stderr
    run = symhaptic("limits", device, "-o", tmp_path / "walls.gif")
    assert run.returncode == 2
    assert "'.gif' is not allowed" in run.stderr


def test_a_wall_that_only_a_delay_makes_stable_has_no_negative_margin(tmp_path):
    """Stable with a delay of 3 ms and unstable without, by eigenvalues."""
    path = tmp_path / "device.toml"
    path.write_text(
        'mass = "0.1 kg"\ndamping = "0.05 Ns/m"\nstiffness = "64989.5 N/m"\n'
        'sampling_period = "1 ms"\ndelay = "3 ms"\n[wall]\nK = "8779.6 N/m"\nB = "-12.466 Ns/m"\n'
    )
    wall = json.loads(symhaptic("limits", path, "--format", "json").stdout)["wall"]
    told = {key: wall[key] for key in ("stable", "max_delay_s", "delay_margin_s")}
    assert told == {"stable": True, "max_delay_s": 0.0, "delay_margin_s": None}
    said = "delay margin     not computed, because the wall is unstable with some smaller delay\n"
    assert said in symhaptic("limits", path).stdout


@pytest.mark.parametrize(
    ("spring", "wall", "told"),
    [
        ("0 N/m", ("1e5 N/m", "1 Ns/m"), "none, because the wall is not stable"),
        ("3000 N/m", ("1 N/m", "0 Ns/m"), "unlimited"),
        ("0 N/m", ("1000 N/m", "5 Ns/m"), "2.901 ms, up to a delay of 4.401 ms"),
    ],
)
def test_the_delay_margin_in_words(tmp_path, spring, wall, told):
    path = tmp_path / "device.toml"
    path.write_text(
        f'mass = "0.1 kg"\ndamping = "0.5 Ns/m"\nstiffness = "{spring}"\n'
        f'sampling_period = "1 ms"\ndelay = "1.5 ms"\n[wall]\nK = "{wall[0]}"\nB = "{wall[1]}"\n'
    )
    assert f"\ndelay margin     {told}\n" in symhaptic("limits", path).stdout
    found = json.loads(symhaptic("limits", path, "--format", "json").stdout)["wall"]
    if told == "unlimited":
        assert found["delay_margin_s"] is found["max_delay_s"] is None
    elif not found["stable"]:
        assert found["delay_margin_s"] == 0


def test_the_delay_margin_of_a_simulator_is_not_computed_and_not_unlimited(tmp_path):
    """One step of delay gives z^3 - 2 z^2 + 2.5 z - 0.5, which has two roots of modulus 1.44."""
    path = tmp_path / "device.toml"
    path.write_text(
        'mass = "1 kg"\nsampling_period = "1 s"\nintegrator = "semi-implicit Euler"\n'
        '[velocity]\nkind = "measured"\n[wall]\nK = "1 N/m"\nB = "0.5 Ns/m"\n'
    )
    said = "delay margin     not computed (a simulator has no time between its steps)\n"
    assert said in symhaptic("limits", path).stdout
    wall = json.loads(symhaptic("limits", path, "--format", "json").stdout)["wall"]
    assert wall["delay_margin_s"] is wall["max_delay_s"] is None
    assert wall["delay_margin_not_computed"] == "a simulator has no time between its steps"


def test_an_arm_that_was_measured_with_its_device_may_be_said_to_be(tmp_path):
    from symhaptic.scene.device_file import read

    path = tmp_path / "device.toml"
    loop = 'mass = "0.3 kg"\ndamping = "1 Ns/m"\nsampling_period = "1 ms"\n'
    path.write_text(f'{loop}[arm]\nmass = "1 kg"\ndamping = "12.6 Ns/m"\nwith_device = true\n')
    scene = read(path).scene
    assert scene.coupled == (1.0, 12.6, 0.0)
    assert scene.max_passive_stiffness() == pytest.approx(2000.0)  # 2 b/T of the device
    path.write_text(f'{loop}[arm]\nmass = "1 kg"\nwith_device = 1\n')
    told = symhaptic("limits", path).stderr
    assert told.endswith("device.toml:6: with_device = 1 is not allowed; give true or false\n")


def test_a_wall_that_pulls_has_no_margin_and_json_has_no_infinity(device):
    device.write_text(device.read_text().replace("800 N/m", "-800 N/m"))
    assert "-800 N/m" in device.read_text()
    said = symhaptic("limits", device, "--format", "json").stdout
    wall = json.loads(said, parse_constant=pytest.fail)["wall"]
    assert (wall["passive"], wall["passivity_margin"]) == (False, None)
    assert "passivity margin none, because K < 0\n" in symhaptic("limits", device).stdout


def test_a_device_is_not_written_over(device):
    text = device.read_text()
    place = device.rename(device.with_suffix(".txt"))
    done = symhaptic("limits", place, "-o", place)
    assert done.returncode == 2
    assert done.stderr.endswith(": is the input file; give another one\n")
    assert place.read_text() == text


@pytest.mark.parametrize(
    "ending", ["svg", *(pytest.param(e, marks=pytest.mark.ci) for e in ("pdf", "png"))]
)
def test_a_picture_has_the_same_bytes_each_time(ending, device, tmp_path):
    pytest.importorskip("matplotlib")
    pictures = [tmp_path / f"{name}.{ending}" for name in "ab"]
    for picture in pictures:
        assert symhaptic("limits", device, "-o", picture).returncode == 0
    assert pictures[0].read_bytes() == pictures[1].read_bytes()


KNOB = """inertia = "200 g cm^2"
damping = "0.01 mN m s/deg"
sampling_rate = "1 kHz"
delay = "1 ms"

[wall]
K = "0.5 N m/turn"
B = "0.05 N m s/turn"
"""


def test_a_rotary_device_has_its_limits_in_its_units(tmp_path):
    path = tmp_path / "knob.toml"
    path.write_text(KNOB)
    words = symhaptic("limits", path, "--chart", "-o", tmp_path / "chart.svg").stdout
    assert "N m/rad with B = " in words
    assert "passivity margin -0.007425 N m s/rad" in words
    assert "N/m" not in words
    assert "Ns/m" not in words
    assert "B in N m s/rad  stable K in N m/rad  at Hz  passive K in N m/rad\n" in words
    assert (tmp_path / "chart.svg").stat().st_size > 10_000
    found = json.loads(symhaptic("limits", path, "--format", "json").stdout)
    assert found["units"] == {"K": "N m/rad", "B": "N m s/rad", "frequency_hz": "Hz"}
    assert found["wall"]["K"] == pytest.approx(0.5 / (2 * np.pi))


def test_the_chart_has_the_limits_over_the_damping(device, tmp_path):
    from symhaptic.scene.device_file import read

    scene = read(device).scene
    run = symhaptic("limits", device, "--chart", "--format", "json", "-o", tmp_path / "chart.png")
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "chart.png").stat().st_size > 10_000
    found = json.loads(run.stdout)
    chart = {name: np.array(values, float) for name, values in found["chart"].items()}
    assert chart.keys() == {"B", "stable_up_to", "frequency_hz", "passive_up_to"}
    assert np.nanmax(chart["stable_up_to"]) == pytest.approx(
        found["stiffest_stable"]["K"], rel=1e-3
    )
    assert np.isnan(chart["stable_up_to"][-1])
    for row in range(0, len(chart["B"]), 50):
        limit = scene.limit_at(chart["B"][row])
        assert (limit.K, limit.frequency_hz) == (
            chart["stable_up_to"][row],
            chart["frequency_hz"][row],
        )
    listed = symhaptic("limits", device, "--chart").stdout.partition("\nB in Ns/m")[2]
    assert 15 <= len(listed.splitlines()) <= 25


def test_the_damping_with_the_largest_delay_margin_is_said(device):
    wall = json.loads(symhaptic("limits", device, "--format", "json").stdout)["wall"]
    ((low, high),) = wall["stable_B"]
    assert low < wall["best_B"] < high
    assert wall["best_delay_margin_s"] >= wall["delay_margin_s"]
    said = f"stable with B = {low:.4g} to {high:.4g} Ns/m; the largest delay margin, "
    assert said in symhaptic("limits", device).stdout
    device.write_text(DEVICE.replace("800 N/m", "80 kN/m"))
    assert "  with this K    no damping makes it stable\n" in symhaptic("limits", device).stdout


def test_a_device_that_no_wall_makes_stable_has_an_empty_chart(tmp_path):
    path = tmp_path / "device.toml"
    path.write_text("mass = 1\nstiffness = 1e6\nsampling_period = 1\ndelay_samples = 3\n")
    run = symhaptic("limits", path, "--chart", "-o", tmp_path / "chart.svg")
    assert run.returncode == 0, run.stderr
    assert run.stdout.endswith("B in Ns/m  stable K in N/m  at Hz  passive K in N/m\n")


COURSE = """mass = "40 g"
damping = "0.8 Ns/m"
sampling_rate = "1 kHz"
coulomb_friction = "20 mN"

[encoder]
resolution = "61.4 um"
"""


@pytest.mark.parametrize(
    ("friction", "K", "by", "said"),
    [
        ("20 mN", 2 * 0.02 / 61.4e-6, "friction", "passive up to 651.5 N/m without B, limited by"),
        ("60 mN", 2 * 0.8 / 1e-3, "damping", "friction would allow 1954 N/m"),
        ("0 N", 0.0, "friction", "nothing: without Coulomb friction, the steps can sustain"),
    ],
)
def test_friction_or_damping_limits_a_wall_with_an_encoder(friction, K, by, said, tmp_path):
    """K <= min(2 b/T, 2 f_c/Delta) without virtual damping (Abbott and Okamura 2005)."""
    path = tmp_path / "device.toml"
    path.write_text(COURSE.replace("20 mN", friction), encoding="utf-8")
    found = json.loads(symhaptic("limits", path, "--format", "json").stdout)["passive_with_encoder"]
    assert (found["K"], found["B"], found["limited_by"]) == (pytest.approx(K), 0.0, by)
    assert f"\nwith encoder     {found['words']}\n" in symhaptic("limits", path).stdout
    assert said in found["words"]


def test_an_encoder_without_a_resolution_is_refused(tmp_path):
    path = tmp_path / "device.toml"
    path.write_text(COURSE.partition("resolution")[0], encoding="utf-8")
    assert symhaptic("limits", path).stderr.endswith("[encoder] needs resolution\n")
