"""A strict `verify` of all statements, of chapters that the other tests have run as well."""

import json

import pytest
from chapters import chapter
from typer.testing import CliRunner

from symhaptic.book import ledger
from symhaptic.cli.main import app


@pytest.fixture(scope="module")
def told():
    """What the command says and its status, in processes that have the chapters of this one.

    The rest is as always.  A slow test of ``test_cli.py`` runs the command from nothing.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(ledger, "run", lambda path: chapter(path.stem))
        return CliRunner().invoke(app, ["verify", "--strict", "--format", "json"])


@pytest.fixture(scope="module")
def everything(told):
    assert told.exit_code == 0, told.output
    return json.loads(told.stdout)


def test_json_has_the_fields_of_the_contract(everything):
    assert set(everything) == {"package", "version", "statements"}
    # field names from the published contract of `verify --format json`
    fields = {
        "id", "location", "statement", "verdict", "method", "condition", "corrected",
        "counterexample", "value", "radius", "derivation", "seconds",
    }  # fmt: skip
    for record in everything["statements"]:
        assert fields <= set(record)


def test_a_constant_has_at_least_20_digits_and_a_narrow_radius(everything):
    record = next(r for r in everything["statements"] if r["id"] == "s3c-kmax-41")
    # sqrt(2) - 1, OEIS A014176 less 2
    assert record["value"].startswith("0.4142135623730950488016887")
    assert float(record["radius"]) < 1e-28  # 30 digits are printed


def test_a_misprint_carries_its_correction_and_a_counterexample(everything):
    record = next(r for r in everything["statements"] if r["id"] == "eq12")
    assert record["verdict"] == "misprint"
    assert "frac{m}{T}" in record["corrected"]
    assert record["counterexample"]
