"""Sweeps that are killed and go on: nothing is computed twice, and the bytes are the same."""

import os
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from threading import Thread

import numpy as np
import pytest

from symhaptic import is_stable, sweep
from symhaptic.sweeps.axes import plan_of
from symhaptic.sweeps.marks import package
from symhaptic.sweeps.stores import _named

zarr = pytest.importorskip("zarr", reason="no zarr here: no sweeps are kept")
pytest.importorskip("xarray", reason="no xarray here: no sweeps")
pytest.importorskip("pyarrow", reason="no pyarrow here: no sweeps are kept")

ALPHA, DELTA = np.linspace(0, 0.5, 40), np.linspace(0, 0.02, 25)

PROGRAM = """
import os, sys, time
import numpy as np
from symhaptic import sweep

def slow(alpha, delta):
    with open(sys.argv[2], "a") as log:
        log.write(f"{float(alpha.ravel()[0])!r}\\n")
    time.sleep(0.02)
    return np.sin(alpha) * delta

sweep(slow, alpha=np.linspace(0, 0.5, 40), delta=np.linspace(0, 0.02, 25), to=sys.argv[1],
      chunks={"alpha": 1}, workers=2)
"""


def tree(place):
    """Every file with its bytes."""
    place = Path(place)
    return {p.relative_to(place): p.read_bytes() for p in place.rglob("*") if p.is_file()}


def begun(place, log):
    return subprocess.Popen(
        [sys.executable, "-c", PROGRAM, str(place), str(log)], stderr=subprocess.PIPE
    )


def marks(place):
    """How many blocks are done."""
    if place.suffix == ".zarr":
        return sum(1 for _ in (place / "blocks/done/c").rglob("*") if _.is_file())
    return sum(1 for _ in place.glob("block-*"))


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["zarr", pytest.param("parquet", marks=pytest.mark.slow)])
def test_a_killed_process_goes_on_to_the_same_bytes(kind, tmp_path):
    whole, killed = tmp_path / f"whole.{kind}", tmp_path / f"killed.{kind}"
    first, second = begun(whole, tmp_path / "whole"), begun(killed, tmp_path / "before")
    until = time.monotonic() + 600
    while not (killed.exists() and marks(killed) >= 12) and time.monotonic() < until:
        time.sleep(0.005)
    second.send_signal(signal.SIGKILL)
    assert second.wait() != 0
    assert first.wait() == 0, first.stderr.read()
    done = marks(killed)
    assert 12 <= done < 40
    last = begun(killed, tmp_path / "after")
    assert last.wait() == 0, last.stderr.read()
    assert tree(killed) == tree(whole)
    read = {n: Counter((tmp_path / n).read_text().split()) for n in ("whole", "before", "after")}
    probe = repr(float(ALPHA[0]))  # asked once more, for what a function of one's own gives
    read["after"][probe] -= 1
    assert sum(read["after"].values()) == 40 - done
    assert max((read["before"] + read["after"]).values()) <= 2
    assert len(set(read["before"]) & {a for a, n in read["after"].items() if n}) <= 2  # two threads


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
def test_what_is_kept_is_what_is_computed(kind, tmp_path):
    axes = {"alpha": ALPHA, "beta": [0.1, 0.4], "gamma": 0.0, "delta": DELTA, "delay": 1.0}
    place = tmp_path / f"kept.{kind}"
    found = sweep("is_stable", to=place, chunks=300, over="delta", reduce=("all", "mean"), **axes)
    wanted = sweep("is_stable", over="delta", reduce=("all", "mean"), **axes)
    assert found.compute().identical(wanted)
    before = tree(place)
    times = {p: p.stat().st_mtime_ns for p in place.rglob("*")}
    sweep("is_stable", to=place, chunks=300, over="delta", reduce=("all", "mean"), **axes)
    assert tree(place) == before
    assert {p: p.stat().st_mtime_ns for p in place.rglob("*")} == times  # nothing is done again


def arms(labels, name="arm", **said):
    """Two arms with these labels, each with one wall."""
    xarray = pytest.importorskip("xarray")
    gamma = xarray.DataArray([0.0, 0.001], coords={name: (name, labels, said)}, dims=name)
    return {"alpha": 0.1, "beta": 0.4, "gamma": gamma, "delta": 0.02, "delay": 1}


@pytest.mark.parametrize(
    ("labels", "name", "said"),
    [
        (np.array(["a", None], object), "arm", {}),
        (np.array(["a", 1], object), "arm", {}),
        ([1.0, 2.0], "arm", {"scale_factor": 10.0}),
        ([1, 2], "arm", {"units": "days since 2000-01-01"}),
        ([1, 2], "arm", {"_FillValue": 1}),
        ([1, 2], "left/right", {}),
        ([1, 2], "blocks", {}),
    ],
)
def test_labels_that_zarr_would_lose_or_change_are_refused(labels, name, said, tmp_path):
    with pytest.raises(ValueError, match=f"^{name}: .* as labels are not allowed in "):
        sweep("is_stable", to=tmp_path / "kept.zarr", **arms(labels, name, **said))
    assert not list(tmp_path.iterdir())


@pytest.mark.filterwarnings("ignore:.*does not have a Zarr V3 specification")
@pytest.mark.parametrize("name", ["blocks", "zarr.json", "a/b", "..", ""])
def test_a_result_whose_name_zarr_has_not_is_refused(name, tmp_path):
    def f(a):
        return a

    f.__name__ = name
    told = r"^quantity: a result has the name .+, which is not allowed in .+; give it another name"
    with pytest.raises(ValueError, match=told):
        sweep(f, a=[1.0], to=tmp_path / "kept.zarr")
    assert list(tmp_path.iterdir()) == []


def test_a_folder_with_the_name_of_a_draft_is_none(tmp_path):
    def f(a):
        return a

    f.__name__ = "f.partial"
    found = sweep(f, a=[1.0], to=tmp_path / "kept.zarr")
    assert found["f.partial"].values.tolist() == [1.0]


def test_a_sweep_of_other_labels_is_another(tmp_path):
    place = tmp_path / "kept.zarr"
    sweep("is_stable", to=place, **arms(["Hogan", "Lee"]))
    again = sweep("is_stable", to=place, **arms(["Hogan", "Lee"]))
    assert list(again.arm.values) == ["Hogan", "Lee"]
    with pytest.raises(ValueError, match="another sweep, which differs in the labels 'arm'"):
        sweep("is_stable", to=place, **arms(["Lee", "Hogan"]))


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
def test_what_stands_beside_it_stays_and_nothing_is_left_beside_it(kind, tmp_path):
    mine = tmp_path / f"kept.{kind}.begun" / "thesis.txt"
    mine.parent.mkdir()
    mine.write_text("mine")
    sweep("is_stable", to=tmp_path / f"kept.{kind}", **arms([1, 2]))
    assert mine.read_text() == "mine"
    (tmp_path / f"link.{kind}").symlink_to("nowhere")
    with pytest.raises(ValueError, match=r"^to: .+ exists and holds no sweep"):
        sweep("is_stable", to=tmp_path / f"link.{kind}", **arms([1, 2]))
    names = {f"kept.{kind}", f"kept.{kind}.begun", f"link.{kind}"}
    assert set(os.listdir(tmp_path)) == names


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
@pytest.mark.parametrize(
    ("place", "why"),
    [("a_file/kept", "Not a dir"), ("a_file/b/kept", "Not a dir"), ("a" * 300, "File name too")],
)
def test_a_place_that_cannot_be_is_told_in_one_line(place, why, kind, tmp_path):
    (tmp_path / "a_file").write_text("mine")
    told = rf"^to: '.+{kind}' cannot be made there \({why}.*\); give a name .+$"
    with pytest.raises(ValueError, match=told):
        sweep("is_stable", to=tmp_path / f"{place}.{kind}", **arms([1, 2]))
    assert os.listdir(tmp_path) == ["a_file"]


@pytest.mark.parametrize("said", ['{"over":', "[]", "3", ""])
@pytest.mark.parametrize(("kind", "file"), [("zarr", "zarr.json"), ("parquet", "_sym.+.json")])
def test_a_plan_that_is_damaged_is_told_in_one_line(kind, file, said, tmp_path):
    place = tmp_path / f"kept.{kind}"
    if kind == "zarr":
        zarr.open_group(place, mode="w").attrs["symhaptic_sweep"] = said
    else:
        place.mkdir()
        (place / "_symhaptic_sweep.json").write_text(said)
    told = rf"^to: {place}/{file}, which .+ is damaged.*; give another place, or remove this one$"
    with pytest.raises(ValueError, match=told):
        sweep("is_stable", to=place, **arms([1, 2]))
    if kind == "zarr":
        (place / "zarr.json").write_text('{"attributes":')
        with pytest.raises(ValueError, match=told):
            sweep("is_stable", to=place, **arms([1, 2]))


def test_a_table_has_a_row_a_point_and_units(tmp_path):
    pandas = pytest.importorskip("pandas", reason="no pandas here: it reads no Parquet")
    from pyarrow import parquet

    place = tmp_path / "walls.parquet"
    sweep("is_stable", alpha=ALPHA, beta=[0.1, 0.4], gamma=0.0, delta=0.01, delay=1.0, to=place,
          chunks=30)  # fmt: skip
    table = pandas.read_parquet(place)
    assert list(table) == ["alpha", "beta", "gamma", "delta", "delay", "is_stable"]
    assert len(table) == 80
    wanted = is_stable(table.alpha, table.beta, table.gamma, table.delta, table.delay)
    assert (table.is_stable == wanted).all()
    field = parquet.read_schema(next(place.glob("block-*"))).field("alpha")
    assert field.metadata[b"units"] == b"1"


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
def test_another_sweep_is_refused(kind, tmp_path):
    place = tmp_path / f"kept.{kind}"
    axes = {"delta": DELTA, "delay": 1.0, "to": place}
    sweep("max_stable_stiffness", gamma=0.0, **axes)
    with pytest.raises(
        ValueError,
        match=r"^to: .+ holds another sweep, which differs in inputs; give another name$",
    ):
        sweep("max_stable_stiffness", gamma=0.1, **axes)
    with pytest.raises(ValueError, match=r"which differs in blocks; give another name$"):
        sweep("max_stable_stiffness", gamma=0.0, chunks=2, **axes)
    stranger = tmp_path / f"other.{kind}"
    stranger.mkdir()
    (stranger / "letter").write_text("mine")
    with pytest.raises(ValueError, match=r"^to: .+ exists and holds no sweep"):
        sweep("max_stable_stiffness", gamma=0.0, **{**axes, "to": stranger})
    assert [p.name for p in stranger.iterdir()] == ["letter"]


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
@pytest.mark.parametrize(
    ("first", "second", "said"),
    [
        ({"over": "b", "reduce": "min"}, {"over": "b", "reduce": "max"}, "variables"),
        ({"over": "b", "reduce": ("min", "max")}, {"over": "b", "reduce": ("max", "min")},
         "variables"),
        ({}, {"swapped": True}, "dimensions"),
        ({"chunks": 2}, {"chunks": 2, "swapped": True}, "dimensions"),
    ],
)  # fmt: skip
def test_another_reduction_and_another_order_are_another_sweep(first, second, said, kind, tmp_path):
    """Neither the names of the results nor the lengths of their dimensions tell them apart."""

    def f(a, b):
        return 10 * a + b

    def swept(words):
        axes = {"a": [0.0, 1.0], "b": [5.0, 6.0]}
        if words.get("swapped"):
            axes = dict(reversed(axes.items()))
        words = {n: word for n, word in words.items() if n != "swapped"}
        return sweep(f, to=tmp_path / f"kept.{kind}", **words, **axes)

    swept(first)
    with pytest.raises(ValueError, match=rf"which differs in {said}"):
        swept(second)


def test_a_function_that_has_changed_is_refused(tmp_path):
    """Blocks of what it was do not stand beside blocks of what it is."""

    def limit(beta):
        return 2.0 * beta

    first = limit

    def limit(beta):
        return 3.0 * beta

    axes = {"beta": DELTA, "to": tmp_path / "kept.zarr"}
    sweep(first, **axes)
    sweep(first, **axes)
    with pytest.raises(ValueError, match=r"which differs in function; give another name$"):
        sweep(limit, **axes)


def test_a_store_begun_with_other_kernels_is_refused(tmp_path, monkeypatch):
    """Their bits differ: no half of one beside half of the other."""
    axes = {"gamma": 0.0, "delta": DELTA, "delay": 1.0, "to": tmp_path / "kept.zarr"}
    sweep("max_stable_stiffness", **axes)
    monkeypatch.setattr("symhaptic.sweeps.plan.kernels_used", lambda: "other")
    with pytest.raises(ValueError, match=r"which differs in kernels; give another name$"):
        sweep("max_stable_stiffness", **axes)


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
def test_a_store_of_other_code_is_refused(kind, tmp_path, monkeypatch):
    """The version of a checkout stays the same while its code changes."""
    axes = {"gamma": 0.0, "delta": DELTA, "delay": 1.0, "to": tmp_path / f"kept.{kind}"}
    sweep("max_stable_stiffness", **axes)
    monkeypatch.setattr("symhaptic.sweeps.plan.package", lambda: "0.1.0 (0123456789ab)")
    with pytest.raises(ValueError, match=r"which differs in symhaptic; give another name$"):
        sweep("max_stable_stiffness", **axes)


def test_the_digest_of_the_package_changes_with_its_code(tmp_path, monkeypatch):
    (tmp_path / "numeric").mkdir()
    file = tmp_path / "numeric" / "plant.py"
    monkeypatch.setattr("symhaptic.sweeps.marks.__file__", str(tmp_path / "sweeps" / "marks.py"))
    found = set()
    for text in ("a = 1", "a = 2", "a = 1"):
        file.write_text(text)
        found.add(package.__wrapped__())
    assert len(found) == 2
    assert all(re.fullmatch(r"\d+\.\d+.* \([0-9a-f]{12}\)", one) for one in found)


def test_a_worker_with_other_code_is_refused(monkeypatch):
    plan = plan_of("linear_limit", None, (), (), None, {"beta": DELTA, "delta": 0, "delay": 1})
    piece = plan.piece((0,))
    monkeypatch.setattr("symhaptic.sweeps.plan.package", lambda: "0.2.0 (0123456789ab)")
    told = r"^workers: this one has symhaptic 0\.2\.0 \(0123456789ab\), and the sweep began with "
    with pytest.raises(ValueError, match=told):
        piece.compute()


def kept(kind, place):
    """A small sweep with numbers and NaN: its values, and how it is asked for again."""
    axes = {"beta": np.array([0.1, np.nan, 0.4, 0.7]), "delta": 0.01, "delay": 1.0, "chunks": 2}
    return sweep("linear_limit", to=place, **axes), axes


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
def test_a_file_that_is_deleted_is_named_or_computed_again(kind, tmp_path):
    place = tmp_path / f"kept.{kind}"
    found, axes = kept(kind, place)
    wanted = found.compute()
    file = place / {"zarr": "alpha/c/1", "parquet": "block-00001.parquet"}[kind]
    file.unlink()
    for read in (found, *([sweep("linear_limit", to=place, **axes)] if kind == "zarr" else ())):
        with pytest.raises(
            ValueError, match=rf"^to: {file} is damaged or missing; delete "
        ) as told:
            read.compute()
    mark = str(told.value).split("delete ")[1].split(",")[0]
    if kind == "zarr":
        Path(mark).unlink()
    assert sweep("linear_limit", to=place, **axes).compute().identical(wanted)


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
def test_no_flipped_bit_gives_other_values(kind, tmp_path):
    """Of a block and of its mark; with a step of 1 instead of 101 the test takes a minute."""
    place = tmp_path / f"kept.{kind}"
    found, _ = kept(kind, place)
    wanted = found.alpha.values
    names = {"zarr": ["alpha/c/1", "blocks/done/c/1/0"], "parquet": ["block-00001.parquet"]}[kind]
    for file in (place / name for name in names):
        whole, refused = file.read_bytes(), 0
        for i in range(0, 8 * len(whole), 101):
            damaged = bytearray(whole)
            damaged[i // 8] ^= 1 << i % 8
            file.write_bytes(damaged)
            try:
                values = found.alpha.values
            except ValueError as wrong:
                refused += "is damaged or missing; delete " in str(wrong)
            else:
                assert np.array_equal(values, wanted, equal_nan=True), i
        file.write_bytes(whole)
        assert refused
    assert np.array_equal(found.alpha.values, wanted, equal_nan=True)


@pytest.mark.parametrize("kind", ["zarr", "parquet"])
@pytest.mark.parametrize("other", ["block", "sweep"])
def test_a_block_in_the_place_of_another_is_not_read(other, kind, tmp_path):
    """With its own mark, as a copy of a part of a store leaves it."""

    def f(a):
        return a

    def stored(name, factor):
        return sweep(f, a=factor * np.arange(3), to=tmp_path / f"{name}.{kind}", chunks=1)

    found, _ = stored("kept", 1.0), stored("other", 2.0)
    place = tmp_path / f"kept.{kind}"
    taken = place if other == "block" else tmp_path / f"other.{kind}"
    files = {"zarr": ("f/c/{}", "blocks/done/c/{}/0"), "parquet": ("block-{:05}.parquet",)}[kind]
    for file in files:
        (place / file.format(2)).write_bytes((taken / file.format(1)).read_bytes())
    with pytest.raises(ValueError, match=r"is damaged or missing; delete .+ computes this block"):
        found.load()


def test_a_folder_with_the_name_of_a_block_or_of_a_column_is_no_data(tmp_path):
    """PyArrow reads a folder as a table, and the name of a folder as a column."""
    place = tmp_path / "f=7" / "kept.parquet"
    place.parent.mkdir()

    def f(a):
        return a

    found = sweep(f, a=[1.0, 2.0], to=place, chunks=1)
    assert found.f.values.tolist() == [1.0, 2.0]
    block = place / "block-00000.parquet"
    block.unlink()
    block.mkdir()
    (block / "one.parquet").write_bytes((place / "block-00001.parquet").read_bytes())
    with pytest.raises(ValueError, match=r"is damaged or missing; delete .+ computes this block"):
        found.load()


@pytest.mark.filterwarnings("ignore:Object at .* is not recognized")
@pytest.mark.parametrize("name", ["zarr.json", "alpha/zarr.json", "blocks/done/zarr.json",
                                  "beta/zarr.json", "beta/c/0"])  # fmt: skip
def test_damage_of_what_describes_a_group_is_reported_in_one_line(name, tmp_path):
    place = tmp_path / "kept.zarr"
    found, axes = kept("zarr", place)
    wanted, whole, told = found.alpha.values, (place / name).read_bytes(), []
    for i in range(3, 8 * len(whole), 401 if len(whole) > 100 else 29):
        damaged = bytearray(whole)
        damaged[i // 8] ^= 1 << i % 8
        (place / name).write_bytes(damaged)
        try:
            values = sweep("linear_limit", to=place, **axes).alpha.values
        except ValueError as wrong:
            told.append(str(wrong))
        else:
            assert np.array_equal(values, wanted, equal_nan=True), i
    named = rf"to: {place / name}[^\n]*, which [^\n]+ is damaged or [^\n]+$"
    assert told
    assert [one for one in told if not re.match(named, one)] == []


def test_another_reader_of_zarr_notices_a_flipped_bit(tmp_path):
    kept("zarr", tmp_path / "kept.zarr")
    file = tmp_path / "kept.zarr" / "alpha/c/1"
    damaged = bytearray(file.read_bytes())
    damaged[len(damaged) // 2] ^= 1
    file.write_bytes(damaged)
    with pytest.raises(ValueError, match="checksum"):
        zarr.open_group(tmp_path / "kept.zarr", mode="r")["alpha"][...]


TWICE = """
import sys, time
import numpy as np
from symhaptic import sweep

def slow(alpha):
    time.sleep(0.2)
    return 2*alpha

print("ready", flush=True)
sys.stdin.readline()
sweep(slow, alpha=np.arange(6.0), chunks=1, to=sys.argv[1], workers=1)
"""


@pytest.mark.parametrize("kind", ["zarr", pytest.param("parquet", marks=pytest.mark.ci)])
def test_of_two_that_start_at_once_one_is_refused_in_one_line(kind, tmp_path):
    place = tmp_path / f"kept.{kind}"
    both = [
        subprocess.Popen([sys.executable, "-c", TWICE, place], text=True, bufsize=1,
                         stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for _ in range(2)
    ]  # fmt: skip
    for process in both:
        assert process.stdout.readline() == "ready\n"
    for process in both:
        process.stdin.write("\n")
        process.stdin.flush()
    said = [process.communicate(timeout=600)[1] for process in both]
    ends = sorted(zip((process.returncode for process in both), said, strict=True))
    assert [status for status, _ in ends] == [0, 1]
    told = f"ValueError: to: another process is writing to {str(place)!r}; wait until it has ended"
    assert ends[1][1].splitlines()[-1].startswith(told)
    assert "Error" not in ends[0][1]  # what is imported may warn, whatever the filters
    assert os.listdir(tmp_path) == [place.name]


@pytest.mark.parametrize(("kind", "draft"), [
    ("zarr", "alpha/c/1.0123.partial"), ("parquet", "_draft-0123"),
])  # fmt: skip
def test_the_next_run_removes_drafts_of_one_that_was_killed(kind, draft, tmp_path):
    place = tmp_path / f"kept.{kind}"
    _, axes = kept(kind, place)
    before = tree(place)
    (place / draft).write_text("half")
    file = {"zarr": "blocks/done/c/1/0", "parquet": "block-00001.parquet"}[kind]
    (place / file).unlink()
    sweep("linear_limit", to=place, **axes)
    assert tree(place) == before


@pytest.mark.parametrize(
    "guard", ['if __name__ == "__main__":', pytest.param("if True:", marks=pytest.mark.ci)]
)
def test_a_killed_worker_process_is_reported_in_one_line(guard, tmp_path):
    program = f"""
import os, signal
from symhaptic import sweep

def deadly(alpha):
    if alpha.size > 1:
        os.kill(os.getpid(), signal.SIGKILL)
    return alpha

{guard}
    sweep(deadly, alpha=[0.0, 1.0], on="processes", workers=1)
"""
    (tmp_path / "program.py").write_text(program)
    command = [sys.executable, tmp_path / "program.py"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    last = done.stderr.splitlines()[-1]
    told = "BrokenExecutor: a worker process was killed or could not start; where memory is short"
    assert told in last


@pytest.mark.ci
def test_a_worker_that_is_killed_half_way(tmp_path):
    """Two processes of a local cluster, one of them killed: its blocks go to another one."""
    distributed = pytest.importorskip("distributed", reason="no dask.distributed here: no cluster")
    log, place = tmp_path / "log", tmp_path / "cluster.zarr"
    path = str(log)

    def slow(alpha, delta):
        with open(path, "a") as file:
            file.write(f"{float(alpha.ravel()[0])!r} {os.getpid()}\n")
        time.sleep(0.03)
        return np.sin(alpha) * delta

    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        own = os.getpid()
        victims = list(client.run(os.getpid).values())

        def kill():
            while not place.exists() or marks(place) < 12:
                time.sleep(0.005)
            os.kill(victims[0], signal.SIGKILL)

        killer = Thread(target=kill)
        killer.start()
        found = sweep(slow, alpha=ALPHA, delta=DELTA, to=place, chunks={"alpha": 1}, on=client)
        killer.join()
    assert np.array_equal(found.slow, np.sin(ALPHA)[:, None] * DELTA)
    done = [line.split() for line in log.read_text().splitlines()]
    done = Counter(alpha for alpha, pid in done if int(pid) != own)
    assert len(done) == 40
    assert sum(done.values()) <= 41  # the block that the killed one was at


def test_a_store_may_have_an_address():
    pytest.importorskip("fsspec", reason="no fsspec here: no stores with addresses")
    axes = {"beta": np.linspace(0, 1, 50), "delta": 0.01, "delay": 1.0, "chunks": 10}
    found = sweep("linear_limit", to="memory://walls/limit.zarr", **axes)
    again = sweep("linear_limit", to="memory://walls/limit.zarr", **axes)
    assert found.compute().identical(again.compute())
    assert found.compute().identical(sweep("linear_limit", **axes))


def test_a_store_that_another_process_has_named_first_stays(tmp_path):
    draft, store = tmp_path / "draft", tmp_path / "store"
    for folder in (draft, store):
        folder.mkdir()
        (folder / folder.name).touch()
    _named(draft, str(store))
    assert (store / "store").exists()
    with pytest.raises(FileNotFoundError):
        _named(tmp_path / "none", str(tmp_path / "other"))
