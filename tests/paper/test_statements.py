"""Every statement of the contract is there, located, readable and, but for two, of one unit."""

import pytest

from symhaptic.notation.latex import refused
from symhaptic.paper import STATEMENTS
from symhaptic.paper.quoted import Quoted
from symhaptic.proof.units import UnitError, dimension_of

EQUATIONS = [f"eq{n}" for n in range(1, 32)]  # (1) to (31)
TABLES = ["tab1", "tab2"]
PLOTS = [f"fig{n}" for n in range(4, 14)]  # Figs. 4 to 13
# The contract's list of statements in the text, in its order.
CLAIMS = [
    "s2c-delays-lump",
    "s2c-rational-delay",
    "s3a-mass-free",
    "s3a-undelayed",
    "s3c-limit-points",
    "s3c-bmax-frequency",
    "s3c-lower-part",
    "s3c-kmax-frequency",
    "s3c-kmax-41",
    "s3c-kmax-27",
    "s4a-delay-equivalent",
    "s4b-five-parameters",
    "s4c-extension-30",
    "s4d-degree",
    "s4d-explicit-only-undelayed",
    "s4d-left-bound",
    "s4d-quadratic-in-period",
    "s4d-damping-bound",
    "s4d-delta-grows",
    "s4d-gamma-invisible",
    "s4d-all-stabilising",
    "s4d-delay-shrinks",
    "s4e-same-as-passive",
    "s4e-stiffness-free",
    "s4e-unstable-side",
    "s4e-two-percent",
    "s4e-passive-range",
    "s5a-subset",
    "s5a-proportional",
    "s5b-eta-d0",
    "s5b-eta-d1",
    "s5b-eta-grows",
    "s5c-human-10000",
    "s5c-robust-subset",
    "s5c-robust-vanishes",
    "s5c-undamped-limit",
    "s6-stable-22",
    "s6-sampling",
    "s6-damping-marginal",
    "s6-mass",
]
CONTRACT = [*EQUATIONS, *TABLES, *PLOTS, *CLAIMS, "one-delta"]

WRONG_UNITS = {
    "eq12": "b c_1 (...) lacks the factor m/T beside b^2 - 4km",
    "s4a-delay-equivalent": "d T_s is a time in an exponent",
}
SECTIONS = {"0": "Abstract", "1": "I", "2": "II", "3": "III", "4": "IV", "5": "V", "6": "VI"}


def test_contract_names_statements():
    assert [STATEMENTS[id].id for id in CONTRACT] == CONTRACT


def test_what_is_beyond_the_contract_belongs_to_a_section():
    for id in set(STATEMENTS) - {*CONTRACT, "one-delta"}:
        assert id[0] == "s", id
        assert id[1] in SECTIONS, id


FORMULAS = {"eq13", "eq15", "eq17"}
"""What the paper introduces by "with" only."""


def test_every_statement_quotes_the_paper_and_reads_it_in_other_words():
    for id, statement in STATEMENTS.items():
        assert bool(statement.quote) == (id not in FORMULAS), id
        assert not any(map(refused, statement.quote.split("$")[1::2])), id
        assert statement.quote.count("$") % 2 == 0, id
        assert statement.quote != statement.says, id
        assert len(statement.quote) < 420, id  # short


def test_statements_have_a_location_and_say_something():
    for id, statement in STATEMENTS.items():
        assert statement.location.startswith(("Abstract", "Sec. ", "Table ", "Fig. ")), id
        assert statement.says.strip(), id
        assert statement.text.strip(), id


def test_claims_stand_in_the_section_of_their_ids():
    for id in CLAIMS:
        section, part = SECTIONS[id[1]], id[2].upper()
        place = f"Sec. {section}" + (f"-{part}" if part.isalpha() else "")
        assert STATEMENTS[id].location == place, id


def test_equations_are_printed_and_readable():
    assert [id for id in EQUATIONS if not STATEMENTS[id].printed] == []


@pytest.mark.parametrize("id", [i for i, s in STATEMENTS.items() if s.latex])
def test_printed_units_agree_but_where_the_paper_errs(id):
    def check():
        for part in STATEMENTS[id].printed:
            dimension_of(part)

    if id in WRONG_UNITS:
        with pytest.raises(UnitError):
            check()
    else:
        check()


# Numbers quoted in Sec. III-C: "approximately 41%", "less than 27%".
@pytest.mark.parametrize(
    ("id", "quoted"), [("s3c-kmax-41", ("about", "0.41")), ("s3c-kmax-27", ("below", "0.27"))]
)
def test_quoted_number(id, quoted):
    assert STATEMENTS[id].quoted == (Quoted(*quoted),)
