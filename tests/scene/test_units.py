"""Text with units, beside Pint, and text that is none."""

import subprocess
import sys
import time
from fractions import Fraction
from itertools import product
from random import Random

import pytest

from symhaptic import Arm, ArmRange, Scene
from symhaptic.notation.quantities import number
from symhaptic.notation.units import said

try:
    import pint

    THEIRS = pint.UnitRegistry()
except ModuleNotFoundError:
    THEIRS = None

needs_pint = pytest.mark.skipif(THEIRS is None, reason="no Pint here to compare with")

SI = {
    "kg": ["kg", "g", "mg", "kilogram", "grams", "lb", "slug", "oz", "N s^2/m", "N*s**2/m"],
    "N*s/m": [
        "N*s/m", "N s/m", "N/(m/s)", "N / (m / s)", "kg/s", "g/ms", "N*s*m^-1", "N s m**-1",
        "N/m*s", "N·s/m", "mN*s/mm", "kN s/m", "newton second per meter", "newton*second/meter",
        "lbf s/in", "N min/km", "J s/m^2", "J*s/m²", "kg*s^-1", "1/(m/(N s))",
    ],
    "N/m": [
        "N/m", "N/mm", "N/cm", "kN/m", "mN/um", "N/µm", "N*m^-1", "kg/s^2", "kg/s**2", "kg/s²",
        "g/ms^2", "J/m^2", "lbf/in", "newton/millimeter", "newton per centimeter", "kgf/mm",
        "kilogram / second squared", "joule per square meter", "N/(mm)",
    ],
    "s": ["s", "ms", "us", "µs", "μs", "ns", "min", "second", "milliseconds", "1/Hz", "1/kHz"],
    "Hz": ["Hz", "kHz", "MHz", "1/s", "s^-1", "s**-1", "1/ms", "hertz", "1/min"],
    "1/s": ["1/s", "1/ms", "Hz", "N s/m/kg", "N*s/(m*kg)", "kg/s/kg"],
    "1/s**2": ["1/s^2", "s^-2", "1/s²", "N/m/kg", "N/(m*kg)", "kHz^2"],
    "kg*m**2": [
        "kg m^2", "kg*m**2", "kg·m²", "g cm^2", "g*cm**2", "kg mm^2", "kg square meter", "lb in^2",
        "oz inch^2", "N m s^2", "N*m*s**2/rad", "kilogram meter squared",
    ],
    "N*m*s/rad": [
        "N m s/rad", "N*m*s/rad", "N m s", "mN m s/rad", "N m s/deg", "N*m/(deg/s)", "N m/rpm",
        "N cm s/rad", "N m/(rad/s)", "N m s/turn", "N m/(turn/min)", "mN*m*s/degree",
        "kg m^2/s/rad", "N m s/arcmin", "ozf inch s/rad",
    ],
    "N*m/rad": [
        "N m/rad", "N*m/rad", "N m/deg", "N*m/degree", "mN m/deg", "N m/turn", "N m/revolution",
        "m N/deg", "N cm/rad", "N mm/deg", "kg m^2/s^2/rad", "J/rad^2", "lbf inch/deg", "N m/grade",
        "newton meter per radian",
    ],
    "N": ["N", "mN", "kN", "kg m/s^2", "lbf", "J/m"],
    "N*m": ["N m", "mN m", "N cm", "kg m^2/s^2", "lbf inch", "J"],
    "m": ["m", "um", "mm", "inch"],
    "rad": ["rad", "deg", "turn", "mrad", "arcmin", "degree"],
    "": ["", "mm/m", "s/ms"],
}  # fmt: skip
"""Spellings of Pint's for the unit of each argument."""

SHORT = {
    ("N*s/m", "Ns/m"): "N*s/m",
    ("N*s/m", "Ns/mm"): "N*s/mm",
    ("N*s/m", "mNs/m"): "mN*s/m",
    ("N*s/m", "kNs/m"): "kN*s/m",
    ("N*s/m", "Ns m^-1"): "N*s/m",
    ("1/s", "Ns/m/kg"): "N*s/m/kg",
    ("kg*m**2", "kgm^2"): "kg*m**2",
    ("kg*m**2", "kgm²"): "kg*m**2",
    ("kg*m**2", "kg m2"): "kg*m**2",
    ("kg*m**2", "gcm^2"): "g*cm**2",
    ("kg*m**2", "kgcm²"): "kg*cm**2",
    ("kg*m**2", "kg.m^2"): "kg*m**2",
    ("N*m*s/rad", "Nms/rad"): "N*m*s/rad",
    ("N*m*s/rad", "Nm s/rad"): "N*m*s/rad",
    ("N*m*s/rad", "mNms/rad"): "mN*m*s/rad",
    ("N*m*s/rad", "Nmms/rad"): "N*mm*s/rad",
    ("N*m*s/rad", "Nms/\N{DEGREE SIGN}"): "N*m*s/deg",
    ("N*m*s/rad", "Nm/rpm"): "N*m/rpm",
    ("N*m/rad", "Nm/rad"): "N*m/rad",
    ("N*m/rad", "mNm/deg"): "mN*m/deg",
    ("N*m/rad", "Ncm/deg"): "N*cm/deg",
    ("N*m/rad", "Nm/rev"): "N*m/turn",
    ("N*m/rad", "Nmm/turn"): "N*mm/turn",
    ("Hz", "s⁻¹"): "1/s",
    ("Hz", "s-1"): "1/s",
}
"""Spellings that Pint refuses or takes for something else, and what they mean."""

CASES = [(unit, text, text) for unit, texts in SI.items() for text in texts]
CASES += [(unit, text, spelled) for (unit, text), spelled in SHORT.items()]


@needs_pint
@pytest.mark.parametrize(("unit", "text", "spelled"), CASES)
def test_each_spelling_is_what_pint_says(unit, text, spelled):
    theirs = THEIRS.Quantity(0.0625, spelled).to(unit).magnitude
    for separator in (" ", "  "):
        assert number("x", f"0.0625{separator}{text}", unit) == pytest.approx(theirs, rel=4e-16)


@needs_pint
def test_products_of_symbols_are_what_pint_says():
    """Any order and any of the signs that Pint reads; Pint's angle is a number, ours is not."""
    for first, sign, angle in product(
        ("mN m", "m*mN", "m mN", "mN·m"), ("/", " / ", " per "), ("rad", "deg", "turn", "mrad")
    ):
        text = f"{first}{sign}{angle}"
        theirs = THEIRS.Quantity(3.0, text).to("N*m/rad").magnitude
        assert number("K", f"3 {text}", "N*m/rad") == pytest.approx(theirs, rel=4e-16)


NAMES = (
    *(
        "g",
        "kg",
        "m",
        "mm",
        "s",
        "ms",
        "us",
        "N",
        "kN",
        "mN",
        "J",
        "Hz",
        "rad",
        "deg",
        "turn",
        "rpm",
    ),
    *("min", "lb", "inch", "second", "newton", "degrees"),
)
POWERS = "^2", "**2", "²", "^-1", "**-2", "**3", " squared", " cubed"


def some_product(dice, depth=0):
    """A random product of units with powers and brackets, as Pint reads it."""
    factors = []
    for _ in range(dice.randint(1, 4)):
        name = dice.choice(NAMES) + dice.choice([""] * 30 + [*POWERS])
        if depth < 2 and dice.random() < 0.2:
            name = f"({some_product(dice, depth + 1)})"
        factors += [name, dice.choice(["*", " ", "/", " / ", " per ", "·"])]
    return "".join(factors[:-1])


@needs_pint
def test_random_products_are_what_pint_says():
    dice = Random(4)
    for text in (some_product(dice) for _ in range(400)):
        theirs = THEIRS.Quantity(3.0, text).to_base_units()
        largest = max(map(abs, dict(theirs.unit_items()).values()), default=0)
        if len(text) <= 80 and largest <= 9:
            wanted = f"{theirs.units:~C}" if theirs.units != THEIRS.dimensionless else ""
            assert number("x", f"3 {text}", wanted) == pytest.approx(theirs.magnitude, rel=1e-12)


@pytest.mark.parametrize("unit", SI)
def test_what_is_printed_is_read(unit):
    assert number("x", f"0.1 {said(unit)}", unit) == 0.1


@pytest.mark.parametrize("text", ["0.1 g", "72 g", "5e-324 kg", "0.3 mg", "1.1e3 g", "7 g"])
def test_a_number_is_the_nearest_to_its_decimal(text):
    digits, unit = text.split()
    size = {"g": Fraction(1, 1000), "mg": Fraction(1, 10**6), "kg": 1}[unit]
    assert number("mass", text, "kg") == float(Fraction(digits) * size)


ANGLES = [
    ("Hz", "1 rad/s"), ("Hz", "60 rpm"), ("Hz", "360 deg/s"), ("Hz", "1 turn/s"),
    ("N/m", "1 N/m/rad"), ("N/m", "1 N/m*deg"), ("N*s/m", "1 N*s/(m*turn)"), ("kg", "1 kg deg"),
    ("N*m/rad", "1 N m deg"), ("N*m/rad", "1 N m rad"), ("N*m*s/rad", "1 N m rad/s"),
    ("N*m", "1 N m/deg"), ("N*m", "1 J/rad"), ("rad", "1"), ("rad", "1 m/m"), ("m", "1 m rad"),
    ("", "1 rad"), ("", "90 deg"), ("s", "1 s/turn"),
]  # fmt: skip


@pytest.mark.parametrize(("unit", "text"), ANGLES)
def test_an_angle_is_not_a_number(unit, text):
    """Pint would convert each of these."""
    with pytest.raises(ValueError, match=r"^x: '.*' is not allowed; give "):
        number("x", text, unit)
    if THEIRS is not None and unit:
        digits, _, spelled = text.partition(" ")
        with pytest.raises(ValueError, match=r"^x: .* is not allowed; give "):
            number("x", THEIRS.Quantity(float(digits), spelled), unit)


HOSTILE = [
    "", " ", "kg", "5", "5 ", "-", "1e999 kg", "-1e999 kg", "NaN kg", "inf kg", "1 m", "5 kg; rm",
    "5 kg\n5 kg", "1,5 kg", "1 000 kg", "0x10 kg", "1_0 kg", "1/3 kg", "5*kg*2", "5 2kg", "5 kg^2",
    "5 kg^0", "5 kg^99999999999", "5 kg^1.5", "5 kg**2**3", "5 kg^^1", "5 kg//1", "5 (kg", "5 kg)",
    "5 ()", "5 /kg", "5 kg/", "5 kg/0", "5 *kg", "5 per kg", "5 kg per", "5 kg squared",
    "5 squared", "5 square", "2² kg", "\u0665 kg", "5 kgs", "5 degC", "5 kg degC/K", "5 kg dB",
    "5 kg delta_degC/K", "5 kg*__import__('os')", "__import__('os').system('true')",
    "5 kg if 1 else 2",
    "{0} kg",
    "5 " + "m" * 79, "5 " + "m" * 10**6, "9" * 4000 + " kg", "9" * 10**6 + " kg",
    "5 " + "(" * 78, "5 " + "(" * 10**5, "5 " + "mNms Nms Nmms " * 5, "5 " + " m/m" * 19,
    "1e" + "9" * 400 + " kg", "5 kg\0", "5 \ud800", "5 kg $(ls)", "5 Gkg", "5 kkg", "5 KG",
    "\u22125 kg",
]  # fmt: skip


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_other_text_is_refused_on_one_short_line(text):
    begin = time.perf_counter()
    for ask in (lambda: Scene(mass=text, sampling_period=1), lambda: Arm(mass=text)):
        with pytest.raises(ValueError, match=r"mass: .+ is not allowed; give ") as caught:
            ask()
        assert len(str(caught.value)) < 250
        assert "\n" not in str(caught.value)
    assert time.perf_counter() - begin < 60  # Pint alone takes a second when it is loaded


def test_a_number_too_small_for_a_float_is_zero():
    for text in ("1e-999 kg", "1e-999999999 kg", "1e-" + "9" * 4000 + " kg"):
        assert number("mass", text, "kg") == 0
        with pytest.raises(ValueError, match="give finite numbers > 0"):
            Scene(mass=text, sampling_period=1)


def test_text_goes_wherever_a_number_does():
    scene = Scene(
        mass="72 g", damping="5 mN*s/m", stiffness="1 N/cm", sampling_rate="2 kHz", delay="750 us",
        arm=Arm(mass="0.5 kg", damping="6 N/(m/s)", stiffness="40 kg/s^2"),
    )  # fmt: skip
    arm = Arm(mass=0.5, damping=6, stiffness=40)
    plain = {"mass": 0.072, "damping": 0.005, "stiffness": 100, "sampling_period": 5e-4}
    assert scene == Scene(**plain, delay=7.5e-4, arm=arm)
    assert scene.periods == Fraction(3, 2)
    assert scene.is_stable("2 N/mm", "14 Ns/m") == scene.is_stable(2000, 14)
    found = scene.is_stable(["2 N/mm", "9 kN/mm"], "14 Ns/m")
    assert found.tolist() == scene.is_stable([2000, 9e6], 14).tolist()
    assert scene.limit_at("14 Ns/m") == scene.limit_at(14)
    assert scene.max_stable_stiffness("14 Ns/m") == scene.max_stable_stiffness(14)
    assert scene.stability_boundary("0.1 kHz") == scene.stability_boundary(100)
    assert scene.max_delay("2 N/mm", "14 Ns/m") == scene.max_delay(2000, 14)
    assert ArmRange(mass=("0 g", "500 g"), damping="6 Ns/m") == ArmRange(mass=(0, 0.5), damping=6)
    free = Scene(mass="1 kg", sampling_period="1 ms", delay_samples="1")
    assert str(free.simplest(0.5, mass=("1 kg", "2 kg"))) == str(free.simplest(0.5, mass=(1, 2)))


@pytest.mark.parametrize("rate", [1000, "1 kHz", "1000 1/s", "1 1/ms", 3000, 1e-3, 44100.0])
def test_a_rate_is_one_over_a_period(rate):
    scene = Scene(mass=1, sampling_rate=rate)
    assert scene.sampling_period == float(1 / Fraction(number("rate", rate, "Hz")))


def test_periods_of_a_rate_count_as_whole():
    for rate in (3000, 7000, 12345, 44100):
        for periods in (1, 2, 3, 7, 30):
            scene = Scene(mass=1, sampling_rate=rate, delay=periods / rate)
            assert scene.periods == periods


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"mass": 1}, "sampling_period: is missing; give sampling_period or sampling_rate"),
        ({"sampling_rate": 1}, "mass: is missing; give mass or inertia"),
        ({"mass": 1, "inertia": 1, "sampling_rate": 1}, "inertia: 1 and mass=1 exclude each other"),
        ({"mass": 1, "sampling_period": 1, "sampling_rate": 1}, "sampling_rate: 1 and sampl"),
        ({"mass": 1, "sampling_rate": 0}, "sampling_rate: 0 is not allowed; give finite numbers"),
        ({"mass": 1, "sampling_rate": "1 s"}, "sampling_rate: '1 s' is not allowed; give a number"),
        ({"mass": 1, "sampling_rate": 1e-310}, "sampling_period: inf is not allowed"),
    ],
)
def test_exactly_one_of_each_pair(given, told):
    with pytest.raises(ValueError, match=told):
        Scene(**given)


def test_pint_is_loaded_for_its_own_names_alone():
    code = (
        "import sys; from symhaptic import Scene\n"
        "s = Scene(inertia='2e-4 kgm^2', damping='1 mNms/deg', sampling_rate='1 kHz')\n"
        "assert 'pint' not in sys.modules\n"
        "sys.modules['pint'] = None\n"
        "import importlib.util as u; u.find_spec = lambda name: None\n"
        "import symhaptic.notation.units as n; n.find_spec = u.find_spec\n"
        "try: Scene(mass='1 lb', sampling_period=1)\n"
        "except ValueError as wrong: print(wrong)\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert run.stdout == (
        "mass: '1 lb' is not allowed; give kg; pip install pint reads the names of other units\n"
    ), run.stderr
