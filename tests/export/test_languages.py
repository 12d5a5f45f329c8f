"""What somebody does with an export beside calling it from the language itself."""

import re
import shutil
import subprocess

import pytest

from symhaptic.export import request
from symhaptic.export.c import CPP_KEYWORDS
from symhaptic.export.targets import TARGETS

pytestmark = pytest.mark.ci


def needs(*programs):
    for program in programs:
        if shutil.which(program) is None:
            pytest.skip(f"no {program} here: what is made for it is not tried")


def exported(language, folder, names=()):
    _, files = request.built(TARGETS[language], request.chosen(names))
    request.write(files, folder)
    return folder


def run(command, folder):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


IN_CPP = """#include "haptic.h"
#include <cmath>
#include <cstdio>

int main() {
    const bool yes = haptic_is_stable(0.01, 0.1, 0.001, 0.02, 1.0);
    const bool no = haptic_is_stable(0.01, NAN, 0.001, 0.02, 1.0);
    std::printf("%d %d", yes, no);
}
"""


def test_a_program_in_cpp_calls_exported_c(tmp_path):
    needs("gcc", "g++")
    folder = exported("c", tmp_path / "out", ["is_stable", "discretize"])
    (folder / "main.cpp").write_text(IN_CPP)
    run(["gcc", "-std=c99", "-O2", "-c", "haptic.c"], folder)
    run(["g++", "-std=c++17", "-Wall", "-Werror", "-o", "main", "main.cpp", "haptic.o"], folder)
    assert run(["./main"], folder) == "1 0"


def test_no_variable_of_c_is_a_keyword_of_cpp():
    _, files = request.built(TARGETS["c"], request.chosen([], delay=3), vectors=False)
    declared = set(re.findall(r"\b(?:double|bool) \*?(\w+)", "".join(files.values())))
    assert len(declared) > 100
    assert not CPP_KEYWORDS & declared


OF_ARRAYS = {
    "linear_limit": """% (beta + delta)/(d + 1/2), (25) of the paper
x = haptic.linear_limit([.1 .2], .1, [1 2]);
assert(x, [.2 .3]./[1.5 2.5], eps);
assert(haptic.linear_limit(int8(1), true, 0), 4);
assert(size(haptic.linear_limit(zeros(0, 3), .1, 1)), [0 3]);
assert(size(haptic.linear_limit(ones(2, 3, 4), .1, 1)), [2 3 4]);
failed = '';
try, haptic.linear_limit([1 2 3], [1 2], 1); catch wrong, failed = wrong.message; end
assert(failed, 'delta: has the size [1 2]; numbers and arrays of the size [1 3] are allowed');
try, haptic.linear_limit('1', 1, 1); catch wrong, failed = wrong.message; end
assert(failed, 'beta: not a real number; give real numbers');
failed = '';
try, haptic.linear_limit(1i, 1, 1); catch wrong, failed = wrong.message; end
assert(failed, 'beta: not a real number; give real numbers');
""",
    "is_stable": """% and a truth value
if haptic.is_stable(.1, NaN, .001, .02, 1), error('stable'); end
if ~haptic.is_stable(.01, .1, .001, .02, 1), error('not stable'); end
found = haptic.is_stable(.01, .1, .001, .02, [1; NaN; 400]);
assert(islogical(found) && isequal(found, [true; false; false]));
found = haptic.is_stable(.01, .1, .001, .02, zeros(0, 3));
assert(islogical(found) && isequal(size(found), [0 3]));
""",
}


@pytest.mark.parametrize("function", OF_ARRAYS)
def test_arrays_in_octave(function, tmp_path):
    needs("octave-cli")
    folder = exported("octave", tmp_path / "out", [function])
    (folder / "tried.m").write_text(OF_ARRAYS[function])
    run(["octave-cli", "--norc", "--quiet", "tried.m"], folder)


ONE = ("fabs", "cos", "exp", "expm1", "floor", "sin", "sqrt", "tan")
HEADS = dict.fromkeys(ONE, ("x: f64", "x")) | {
    "atan2": ("x: f64, y: f64", "x, y"),
    "fma": ("x: f64, y: f64, z: f64", "x, y, z"),
}
DECLARED = "\n".join(f"pub fn {f}({args}) -> f64;" for f, (args, _) in HEADS.items())
DEFINED = "\n".join(
    f"pub fn {f}({args}) -> f64 {{ unsafe {{ c::{f}({names}) }} }}"
    for f, (args, names) in HEADS.items()
)
LIBM = f'#![no_std]\nmod c {{ extern "C" {{ {DECLARED} }} }}\n{DEFINED}\n'
"""Stands for the crate libm: C's own functions, without std."""

OPTIONAL = """[features]
default = ["libm"]
libm = ["dep:libm"]
[dependencies]
libm = { path = "../libm", optional = true }
"""


def test_a_module_of_a_crate_without_std(tmp_path):
    needs("cargo", "cargo-clippy")
    crates = {"libm": (LIBM, ""), "user": ("#![no_std]\npub mod haptic;\n", OPTIONAL)}
    for name, (source, more) in crates.items():
        (tmp_path / name / "src").mkdir(parents=True)
        (tmp_path / name / "src" / "lib.rs").write_text(source)
        head = f'[package]\nname = "{name}"\nversion = "0.2.0"\nedition = "2021"\n'
        (tmp_path / name / "Cargo.toml").write_text(head + more)
    folder = exported("rust", tmp_path / "out")
    shutil.copy(folder / "src" / "haptic.rs", tmp_path / "user" / "src")
    clippy = ["cargo", "clippy", "--offline", "--quiet"]
    run([*clippy, "--", "-D", "warnings"], tmp_path / "user")


def test_no_unit_is_a_link_in_the_documentation_of_rust(tmp_path):
    """Which rustdoc would look for, and not find."""
    text = (exported("rust", tmp_path) / "src" / "haptic.rs").read_text()
    told = [line for line in text.splitlines() if line.lstrip().startswith("///")]
    assert "/// * `delta`: physical damping, b T/m (1)" in told
    assert not any("[" in line for line in told)


IN_NODE = """import { is_stable } from "./out/haptic.mjs";
import { readFileSync } from "node:fs";
import vm from "node:vm";
const page = vm.createContext({});
vm.runInContext(readFileSync("out/haptic.script.js", "utf8"), page);
const both = [is_stable, vm.runInContext("haptic.is_stable", page)];
const plant = [0.001, 0.02];
console.log(JSON.stringify(both.map((f) => [
    f(0.01, 0.1, ...plant, 1), f(0.01, 0.1, ...plant), f("0.01", 0.1, ...plant, 1),
    f(null, 0.1, ...plant, 1), f(0.01, 0.1, ...plant, 400),
])));
if (is_stable(0.01, 0.1, ...plant, NaN)) process.exit(1);
"""


def test_modules_and_scripts_of_javascript(tmp_path):
    """An argument forgotten, text and null are outside of every domain."""
    needs("node")
    exported("javascript", tmp_path / "out", ["is_stable", "linear_limit"])
    (tmp_path / "tried.mjs").write_text(IN_NODE)
    told = "[true,false,false,false,false]"
    assert run(["node", "tried.mjs"], tmp_path) == f"[{told},{told}]\n"
