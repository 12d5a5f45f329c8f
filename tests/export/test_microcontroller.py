"""What runs on a microcontroller: no double arithmetic, no memory taken, no errno, and its cost."""

import re
import subprocess
from pathlib import Path

import pytest
from export.test_languages import exported, needs, run
from export.test_request import symhaptic

from symhaptic.export import request
from symhaptic.export.microcontroller import COMPILER, CORTEX_M4, KINDS, LEAN, SIZES, most
from symhaptic.export.targets import TARGETS
from symhaptic.forms import stable

pytestmark = pytest.mark.ci

CONTROLLER = [
    "is_stable", "delay_margin", "max_stable_stiffness", "max_passive_stiffness",
    "stability_boundary",
]  # fmt: skip
BUILD = [COMPILER, "-std=c99", *CORTEX_M4, *LEAN]

STARTUP = """/* Two vectors, and a reset that switches the floating point unit on. */
extern void _start(void);
static void reset(void) {
    *(volatile unsigned *)0xE000ED88u |= 0xFu << 20;
    __asm volatile("dsb\\n isb");
    _start();
}
__attribute__((section(".vectors"), used))
static void (*const vectors[2])(void) = {(void (*)(void))0x20400000, reset};
"""
QEMU = ["qemu-system-arm", "-M", "mps2-an386", "-nographic", "-semihosting-config",
        "enable=on,target=native", "-kernel"]  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return exported("microcontroller", tmp_path_factory.mktemp("small") / "out", CONTROLLER)


def test_the_self_test_passes_on_a_cortex_m4(folder):
    """As written, and none of the functions sets errno at any vector."""
    needs(COMPILER, QEMU[0])
    (folder / "startup.c").write_text(STARTUP)
    text = (folder / "selftest.c").read_text()
    text = text.replace("#include <math.h>", "#include <errno.h>\n#include <math.h>")
    text = re.sub(r"(read_all\(file, x, arg.*;)", r"\1 errno = 0;", text)
    found = "if (results == 0) return 2;"
    assert found in text
    text = text.replace(found, f"{found} if (errno != 0) return 3;")
    (folder / "watched.c").write_text(text)
    for program in ("selftest", "watched"):
        sources = ["startup.c", f"{program}.c", "haptic.c", "-lm"]
        where = ["--specs=rdimon.specs", "-Wl,--section-start=.vectors=0"]
        run([*BUILD, *where, "-o", f"{program}.elf", *sources], folder)
        assert ", 0 missed" in run([*QEMU, f"{program}.elf"], folder)


USER = """#include "haptic.h"
volatile float given = 0.1f, found[3];
int main(void) {
    float a, b, t;
    found[0] = haptic_is_stable(given, given, given, given, given);
    found[1] = haptic_delay_margin(given, given, given, given, given);
    haptic_max_stable_stiffness(given, given, given, &a, &b, &t), found[0] = a + b + t;
    haptic_max_passive_stiffness(given, given, &a, &b, &t), found[1] = a + b + t;
    haptic_stability_boundary(given, given, given, given, &a, &b), found[2] = a + b;
    return 0;
}
"""


@pytest.mark.parametrize(
    "core",
    [pytest.param(CORTEX_M4, marks=pytest.mark.ci), ["-mcpu=cortex-m0plus", "-mthumb"]],
    ids=lambda c: c[0],
)
def test_no_double_and_no_memory_is_linked(core, folder):
    """Nor a fused multiplication where the processor has none: libraries take doubles for it."""
    needs(COMPILER)
    (folder / "user.c").write_text(USER)
    bare = ["--specs=nosys.specs", "-Wl,--gc-sections", "-ffunction-sections"]
    command = [COMPILER, "-std=c99", *core, *LEAN, *bare, "-o", "user.elf", "user.c", "haptic.c"]
    run([*command, "-lm"], folder)
    names = run(["arm-none-eabi-nm", "user.elf"], folder).split()
    assert "haptic_is_stable" in names
    assert not [n for n in names if re.search(r"alloc|_sbrk|__aeabi_(d|f2d|i2d|ui2d)|^fmaf?$", n)]
    run([*command[:-4], "-c", "-o", "haptic.o", "haptic.c"], folder)
    asked = run(["arm-none-eabi-nm", "-u", "haptic.o"], folder)
    assert "errno" not in asked
    assert not re.search(r"\bexpf\b", asked)


@pytest.mark.ci
@pytest.mark.parametrize("name", SIZES)
def test_the_bytes_are_those_that_the_readme_says(name, tmp_path):
    needs(COMPILER)
    version = run([COMPILER, "-dumpversion"], tmp_path)
    delay = 1 if name in stable.FOR_ONE_DELAY else None
    forms = request.chosen([name], delay=delay)
    _, files = request.built(TARGETS["microcontroller"], forms, vectors=False)
    for file, text in files.items():
        (tmp_path / file).write_text(text)
    run([*BUILD, "-c", "haptic.c"], tmp_path)
    told = run(["arm-none-eabi-size", "haptic.o"], tmp_path).split("\n")[1].split()
    if version.startswith("12.2"):
        assert int(told[0]) == SIZES[name]
    assert int(told[0]) < 1.2 * SIZES[name]
    assert told[1:3] == ["0", "0"]


COUNTED = """#include <cmath>
#include <limits>
struct Counted {
    static inline long additions = 0, products = 0, quotients = 0, roots = 0, comparisons = 0,
        functions = 0;
    float value;
    Counted() = default;
    constexpr Counted(float x) : value(x) {}
    explicit operator int() const { return int(value); }
};
using C = Counted;
inline C operator+(C x, C y) { ++C::additions; return x.value + y.value; }
inline C operator-(C x, C y) { ++C::additions; return x.value - y.value; }
inline C operator*(C x, C y) { ++C::products; return x.value*y.value; }
inline C operator/(C x, C y) { ++C::quotients; return x.value/y.value; }
inline C operator-(C x) { return -x.value; }
inline bool operator<(C x, C y) { ++C::comparisons; return x.value < y.value; }
inline bool operator<=(C x, C y) { ++C::comparisons; return x.value <= y.value; }
inline bool operator>(C x, C y) { ++C::comparisons; return x.value > y.value; }
inline bool operator>=(C x, C y) { ++C::comparisons; return x.value >= y.value; }
inline bool operator==(C x, C y) { ++C::comparisons; return x.value == y.value; }
inline bool operator!=(C x, C y) { ++C::comparisons; return x.value != y.value; }
inline C sqrtf(C x) { ++C::roots; return std::sqrt(x.value); }
inline C fabsf(C x) { return std::fabs(x.value); }
inline C fmaxf(C x, C y) { ++C::comparisons; return std::fmax(x.value, y.value); }
inline C fminf(C x, C y) { ++C::comparisons; return std::fmin(x.value, y.value); }
inline C sinf(C x) { ++C::functions; return std::sin(x.value); }
inline C cosf(C x) { ++C::functions; return std::cos(x.value); }
inline C tanf(C x) { ++C::functions; return std::tan(x.value); }
inline C expm1f(C x) { ++C::functions; return std::expm1(x.value); }
inline C exponential(C x) { ++C::functions; return std::exp(x.value); }
inline C floorf(C x) { ++C::functions; return std::floor(x.value); }
inline C atan2f(C x, C y) { ++C::functions; return std::atan2(x.value, y.value); }
"""


@pytest.mark.slow
def test_no_function_takes_more_operations_than_the_readme_says(tmp_path):
    """All are counted where the self-test goes, with a float that counts; the bounds are near."""
    needs("g++")
    forms = [*request.chosen([], delay=2), *request.chosen(["delay_margin"])]
    made, files = request.built(TARGETS["microcontroller"], forms)
    source = files["haptic.c"].partition("// exp(x), without errno")[2].partition("\n}\n")[2]
    source = source.replace("#if defined(FP_FAST_FMAF)", "#if 0 && defined(FP_FAST_FMAF)")
    sampled = files["haptic.h"].partition("typedef")[1:]
    source = "".join(sampled).partition("#ifdef __cplusplus")[0] + source
    text = COUNTED + source.replace("float ", "Counted ").replace("INFINITY", "C(INFINITY)")
    calls = []
    for routine in made.public:
        many = len(routine.results)
        args = [f"x[{i}]" for i in range(len(routine.arguments))]
        args += [f"&y[{i}]" for i in range(many)] if many > 1 else []
        sizes = ", ".join(f"C::{kind}" for kind in KINDS)
        reset = " = ".join(f"C::{kind}" for kind in KINDS)
        calls.append(
            f'if (name == "{routine.name}") {{ for (int i = 0; i < {len(routine.arguments)}; ++i)'
            " { std::string word; file >> word; x[i] = std::strtof(word.c_str(), nullptr); }"
            f" {reset} = 0; haptic_{routine.name}({', '.join(args)});"
            f' for (long n : {{{sizes}}}) std::printf("%ld ", n); }}'
        )
    text += f"""#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
int main() {{
    std::ifstream all("vectors.txt");
    std::string line, name;
    while (std::getline(all, line)) {{
        std::istringstream file(line);
        C x[16], y[16];
        file >> name;
        {"else ".join(calls)}
        std::printf("%s\\n", name.c_str());
    }}
}}
"""
    (tmp_path / "counted.cpp").write_text(text)
    (tmp_path / "vectors.txt").write_text(files["vectors.txt"])
    run(["g++", "-std=c++17", "-O1", "-w", "-o", "counted", "counted.cpp"], tmp_path)
    bounds, worst = most(made), {}
    for line in run(["./counted"], tmp_path).splitlines():
        *counts, name = line.split()
        for kind, count in zip(KINDS, map(int, counts), strict=True):
            assert count <= bounds[name][kind], (name, kind)
            worst[name, kind] = max(worst.get((name, kind), 0), count)
    near = ("discretize", "stability_boundary", "passivity_margin_at", "linear_limit")
    for name in near:
        for kind in ("additions", "products"):
            assert 3 * worst[name, kind] >= bounds[name][kind], (name, kind)


def test_the_readme_has_the_table():
    _, files = request.built(TARGETS["microcontroller"], request.chosen(["linear_limit"]))
    row = f"| linear_limit | 2 | 0 | 1 | 0 | 5 | 0 | {SIZES['linear_limit']} |"
    assert row in files["README.md"]


def test_double_precision_is_refused(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words = ["export", "linear_limit", "--target", "microcontroller", "--precision", "double"]
    code, _, err = symhaptic(monkeypatch, capsys, *words)
    assert code == 2
    assert err.count("\n") == 1
    assert "--precision double: C99 for microcontrollers is exported in single only" in err


def test_clang_promotes_nothing_to_double(folder):
    """Nor does the self-test of what it compiles miss a value; a promotion is an error, to see that
    the option is heard."""
    needs("clang")
    strict = [
        "clang",
        "-std=c99",
        "-Werror",
        "-Wall",
        "-Wextra",
        "-Wdouble-promotion",
        "-Wconversion",
    ]
    (folder / "promoted.c").write_text("double twice(float x) { return 2.0*x; }\n")
    with pytest.raises(subprocess.CalledProcessError):
        subprocess.run([*strict, "-c", "promoted.c"], cwd=folder, check=True, capture_output=True)
    run([*strict, "-c", "haptic.c"], folder)
    run(["clang", "-std=c99", "-o", "by_clang", "selftest.c", "haptic.c", "-lm"], folder)
    assert ", 0 missed" in run(["./by_clang"], folder)


@pytest.mark.slow
def test_the_rules_of_misra_that_it_breaks_are_those_of_the_page(folder):
    needs("cppcheck")
    command = ["cppcheck", "--addon=misra", "--std=c99", "--enable=style", "haptic.c"]
    told = subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stderr
    page = (Path(__file__).parents[2] / "docs" / "export.md").read_text()
    listed = re.findall(r"^\| (\d+\.\d+) \|", page, re.MULTILINE)
    assert set(re.findall(r"misra-c2012-([\d.]+)", told)) == set(listed)


def test_nothing_of_it_is_warned_of(folder):
    needs("gcc")
    for command in TARGETS["microcontroller"].commands("haptic"):
        subprocess.run(command, cwd=folder, check=True, capture_output=True)
