"""A ledger is read as one, or not at all; ids do not look like each other."""

import json
from dataclasses import replace

import pytest

from symhaptic.book import ledger, listing
from symhaptic.book.committed import NoLedger, committed, expected, places, records, reworded
from symhaptic.book.sources import STATEMENTS, is_id
from symhaptic.proof.verdict import Kind, Verdict

RECORD = {"id": "a", "verdict": "proved", "derivation": "a.py"}


def written(tmp_path, *found, text=None):
    path = tmp_path / "ledger.json"
    path.write_text(json.dumps({"statements": list(found)}) if text is None else text)
    return path


def test_a_ledger_is_read(tmp_path):
    path = written(tmp_path, RECORD, {**RECORD, "id": "b", "verdict": "undecided"})
    assert expected(path) == {"a": "proved", "b": "undecided"}
    assert places(path) == {"a": "a.py", "b": "a.py"}


def test_an_id_stands_once(tmp_path):
    path = written(tmp_path, RECORD, {**RECORD, "verdict": "refuted"})
    with pytest.raises(NoLedger, match=r"ledger\.json: has the id 'a' 2 times; give one record"):
        records(path)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "null",
        "{}",
        '{"statements": 1}',
        '{"statements": [1]}',
        '{"statements": [{"id": "a"}]}',
        '{"statements": [{"verdict": "proved"}]}',
        '{"statements": [{"id": "a", "verdict": "prooved"}]}',
        '{"statements": [{"id": "a", "verdict": ["proved"]}]}',
        '{"statements": [{"id": "a", "verdict": "argued"}]}',
        '{"statements": [{"id": "a", "id": "b", "verdict": "proved"}]}',
        '{"statements": [{"id": "a", "verdict": "proved", "seconds": NaN}]}',
        '{"statements": [{"id": "a", "verdict": "proved", "seconds": Infinity}]}',
        '{"statements": []} {}',
        "[" * 100_000,
    ],
)
def test_what_is_no_ledger_is_told_in_a_line(tmp_path, text):
    with pytest.raises(NoLedger) as caught:
        records(written(tmp_path, text=text))
    assert "\n" not in str(caught.value)
    assert str(tmp_path) in str(caught.value)


def test_a_folder_or_nothing_is_no_ledger(tmp_path):
    with pytest.raises(NoLedger, match="is no file"):
        records(tmp_path / "ledger.json")
    with pytest.raises(NoLedger, match="is a folder"):
        records(tmp_path)


def test_the_counterexamples_that_come_with_the_package_are_compared_too(tmp_path):
    verdict = Verdict(Kind.REFUTED, "seen", counterexample={"x": "1"})
    entry = ledger.Entry(STATEMENTS["eq1"], verdict, None, 0.0)
    path = tmp_path / "ledger.json"
    path.write_text(committed([entry]))
    assert reworded([entry], path) == []
    other = replace(entry, verdict=replace(verdict, counterexample={"x": "2"}))
    assert reworded([other], path) == [
        "eq1: the counterexample is {'x': '2'}, but the ledger says {'x': '1'}"
    ]


def test_seconds_that_are_no_number_are_not_written():
    entry = ledger.Entry(STATEMENTS["eq1"], Verdict(Kind.PROVED, "seen"), None, float("nan"))
    with pytest.raises(ValueError, match="JSON"):
        listing.json_text([entry], [], strict=False)


@pytest.mark.parametrize(
    "id", ["eq11", "s3c-kmax-41", "drift:way", "a", "1", "A_b.c+d-e", "a" * 100]
)
def test_an_id_is_of_letters_and_digits(id):
    assert is_id(id)


@pytest.mark.parametrize(
    "id",
    [
        "",
        "-",
        "--strict",
        "-eq11",
        ":way",
        ".hidden",
        "\u0435q11",  # a Cyrillic e
        "e\u0301q11",  # a combining accent
        "\u00e9q11",
        "eq11\u200b",  # a space without width
        "eq\u0661",  # an Arabic digit
        "\uff45q11",  # a wide e
        "a b",
        "a\n",
        "a/b",
        "a" * 101,
        None,
        b"a",
        1,
    ],
)
def test_an_id_that_looks_like_another_or_like_an_option_is_refused(id):
    assert not is_id(id)
