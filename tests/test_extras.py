"""Without an optional dependency, each name that needs it says in one line what to install."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from symhaptic import ArmRange, Scene, lambdify, sweep
from symhaptic.book.report.place import ReportError
from symhaptic.notation.extras import missing, needed
from symhaptic.sweeps import charts

SCENE = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.001)


def swept(**given):
    return sweep("is_stable", alpha=0.1, beta=[0.1, 0.2], gamma=0.0, delta=0.0, delay=1, **given)


CASES = [
    (swept, "xarray", "symhaptic.sweep needs xarray: pip install 'symhaptic[sweep]'"),
    (swept, "dask", "symhaptic.sweep needs dask: pip install 'symhaptic[sweep]'"),
    (
        swept,
        "dask xarray",
        "symhaptic.sweep needs dask and xarray: pip install 'symhaptic[sweep]'",
    ),
    (
        lambda: swept(to="x.zarr"),
        "zarr",
        "symhaptic.sweep to a Zarr store needs zarr: pip install 'symhaptic[sweep]'",
    ),
    (
        lambda: swept(to="x.parquet"),
        "pyarrow",
        "symhaptic.sweep to Parquet files needs pyarrow: pip install 'symhaptic[sweep]'",
    ),
    *(
        (
            getattr(charts, name),
            "dask matplotlib xarray",
            f"symhaptic.sweeps.charts.{name} needs dask, matplotlib and xarray: "
            "pip install 'symhaptic[sweep]'",
        )
        for name in ("robust_limits", "stiffest", "delay_margin", "model_costs")
    ),
    (
        SCENE.plot,
        "matplotlib",
        "Scene.plot needs matplotlib: pip install 'symhaptic[report]'",
    ),
    (SCENE.to_control, "control", "Scene.to_control needs control: pip install control"),
    *(
        (
            lambda name=name: lambdify("eq11", modules=name),
            name,
            f"symhaptic.lambdify(modules='{name}') needs {name}: pip install '{of}'",
        )
        for name, of in (("jax", "symhaptic[arrays]"), ("torch", "symhaptic[arrays]"))
    ),
    (
        lambda: lambdify("eq11", modules="cupy"),
        "cupy",
        "symhaptic.lambdify(modules='cupy') needs cupy: pip install cupy",
    ),
]


@pytest.fixture
def hidden(monkeypatch):
    def hide(names):
        for name in names.split():
            monkeypatch.setitem(sys.modules, name, None)

    return hide


@pytest.mark.parametrize(("call", "names", "said"), CASES)
def test_a_name_says_what_to_install(call, names, said, hidden, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    hidden(names)
    with pytest.raises(ModuleNotFoundError) as wrong:
        call()
    assert str(wrong.value) == said
    assert list(tmp_path.iterdir()) == []


def test_the_picture_of_safe_walls_does_so_too(hidden):
    arm = ArmRange(mass=(0.1, 0.1), damping=(1.0, 1.0), stiffness=(10.0, 10.0))
    safe = Scene(mass=0.1, damping=0.5, sampling_period=0.001).safe_walls(arm)
    hidden("matplotlib")
    with pytest.raises(ModuleNotFoundError, match=r"SafeWalls\.plot needs matplotlib: pip install"):
        safe.plot()


@pytest.mark.parametrize("name", ["sphinx", "furo", "jinja2", "nbformat", "matplotlib", "pypandoc"])
def test_the_site_says_what_to_install(name, hidden, tmp_path):
    from symhaptic.book.report.place import allowed

    hidden(name)
    with pytest.raises(ReportError, match=r"pip install 'symhaptic\[report\]'$"):
        allowed(tmp_path / "site")


def test_what_is_installed_is_not_asked_for(hidden):
    needed("x", "sys", "numpy")
    assert missing("numpy", "pypandoc_no", "sys") == ["pypandoc_no"]
    hidden("pypandoc")
    assert missing("pypandoc") == ["pypandoc_binary"]


COMMANDS = [
    ("report -o out", "jinja2"),
    ("report --format html -o out", "sphinx"),
    ("trace --gamma 1 --delta 1 --delay 1 -o out.png", "matplotlib"),
    ("limits device.toml -o out.png", "matplotlib"),
]
FURTHER = [
    ("report -o out", "matplotlib"),
    ("report --check -o out", "jinja2"),
    ("report --chapter s2a_device -o out", "jinja2"),
    ("report --chapter s2a_device -o out", "matplotlib"),
    ("report --format html -o out", "nbformat"),
    ("report --format html -o out", "pypandoc"),
    ("report --chapter s2a_device --standalone --format html -o out", "jinja2"),
]

FORKED = """
import json, os, sys
import symhaptic.book.ledger, symhaptic.book.parts, symhaptic.scene.device_file  # once for all
from symhaptic.cli.main import main
for asked, name in json.loads(sys.argv[1]):
    assert name not in sys.modules
    if (child := os.fork()) == 0:
        sys.modules[name] = None
        sys.argv = ["symhaptic", *asked.split()]
        main()
        os._exit(0)
    _, status = os.waitpid(child, 0)
    print(os.waitstatus_to_exitcode(status), sorted(os.listdir()), file=sys.stderr)
"""
"""Each command in a process of its own, which has imported none of the packages."""


@pytest.mark.parametrize("commands", [COMMANDS, pytest.param(FURTHER, marks=pytest.mark.ci)])
def test_a_command_says_at_once_what_to_install(commands, tmp_path):
    (tmp_path / "device.toml").write_text(
        'mass = "100 g"\ndamping = "0.5 Ns/m"\nsampling_period = "1 ms"\ndelay = "1 ms"\n'
    )
    paths = os.environ | {"PYTHONPATH": str(Path(needed.__code__.co_filename).parents[2])}
    run = subprocess.run(
        [sys.executable, "-c", FORKED, json.dumps(commands)], cwd=tmp_path, env=paths,
        capture_output=True, text=True, timeout=1200, check=True,
    )  # fmt: skip
    said = run.stderr.splitlines()
    assert len(said) == 2 * len(commands), run.stderr
    for case, line, status in zip(commands, said[::2], said[1::2], strict=True):
        assert line.startswith("symhaptic: error: "), case
        assert line.endswith("pip install 'symhaptic[report]'"), case
        assert status == "2 ['device.toml']", case
