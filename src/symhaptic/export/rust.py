"""Rust."""

from __future__ import annotations

from types import MappingProxyType

from symhaptic.export import reserved
from symhaptic.export.branches import guarded
from symhaptic.export.language import Target, describe
from symhaptic.export.precision import DOUBLE
from symhaptic.export.reserved import vocabulary
from symhaptic.export.routine import Library, Routine
from symhaptic.export.statements import braces, wrapped
from symhaptic.export.vectors import ORDINARY
from symhaptic.forms.stable import Form
from symhaptic.version import __version__


class Rust(Target):
    """One module; several results are a tuple."""

    name, title = "rust", "Rust"
    changing = "let mut"
    each = (
        "for n in ({last}..={first}).rev().step_by({step}) {{",
        "    let {name} = INVERSE_FACTORIAL[n];",
    )
    times = "for _ in 0..{1} {{"
    choice = "(if {0} {{ {1} }} else {{ {2} }})"
    keywords = vocabulary(
        "as async await break const continue crate dyn else enum extern false fn for if impl in "
        "let loop match mod move mut pub ref return self Self static struct super trait true type "
        "unsafe use where while abstract become box do final macro override priv typeof unsized "
        "virtual yield try union gen core std main"
    )
    modules = reserved.RUST
    operations = MappingProxyType(
        {
            "Abs": "({0}).abs()",
            "Infinity": "{real}::INFINITY",
            "NaN": "{real}::NAN",
            "Max": "({0}).max({1})",
            "Min": "({0}).min({1})",
            "TwoProdError": "({0}).mul_add({1}, -({0}*{1}))",
            "atan2": "({0}).atan2({1})",
            "cos": "({0}).cos()",
            "exp": "({0}).exp()",
            "expm1": "({0}).exp_m1()",
            "floor": "({0}).floor()",
            "sin": "({0}).sin()",
            "sqrt": "({0}).sqrt()",
            "tan": "({0}).tan()",
        }
    )
    single = operations

    @property
    def real(self) -> str:
        """The type."""
        return f"f{64 if self.precision is DOUBLE else 32}"

    def number(self, value: float) -> str:
        """A literal with its type, so that methods can be called."""
        return f"{super().number(value)}_{self.real}"

    def source(self, library: Library) -> dict[str, str]:
        """src/NAME.rs, a module that stands alone."""
        lines = [*_ALLOWED.split("\n"), *_without_std(self.real)]
        if table := self.table(library):
            kind = f"[{self.real}; {library.factorials}]"
            lines += ["// 1/n!", f"const INVERSE_FACTORIAL: {kind} = [{table}];", ""]
        for helper in library.helpers:
            lines += [f"// {helper.about}", *self._written(helper, "fn")]
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += [
                *(f"/// {line}".rstrip() for line in self._documented(form)),
                *self._written(routine, "pub fn"),
            ]
        return {f"src/{library.name}.rs": "\n".join(wrapped(lines))}

    def _documented(self, form: Form) -> list[str]:
        """In Markdown, where square brackets are a link."""
        about = "\n".join(describe(form, self.precision))
        first, *others = about.replace("[", "(").replace("]", ")").splitlines()
        arguments = others[: len(form.arguments)]
        listed = [f"* `{line.replace(': ', '`: ', 1)}" for line in arguments]
        return [first[0].upper() + first[1:],
                *[""] * bool(listed), *listed,
                *(part for line in others[len(arguments):] for part in ("", line))]  # fmt: skip

    def package(self, library: Library) -> dict[str, str]:
        """A crate with its documentation and its test, which can do without std."""
        first = library.public[0]
        args = ", ".join(str(ORDINARY[symbol]) for symbol in first.arguments)
        words = {"name": library.name, "title": library.title, "release": __version__,
                 "call": f"{library.name}::{self.call(first.name)}({args})"}  # fmt: skip
        return {"Cargo.toml": _PACKAGE % words, "src/lib.rs": _CRATE % words}

    def _written(self, routine: Routine, word: str) -> list[str]:
        args = ", ".join(f"{self.rename(s.name)}: {self.real}" for s in routine.arguments)
        count = len(routine.results)
        values = ", ".join(f"{{{i}}}" for i in range(count))
        end = f"return ({values});" if count > 1 else "return {0};"
        kind = f"({', '.join([self.real] * count)})" if count > 1 else self.real
        kind = "bool" if routine.truth else kind
        head = f"{word} {self.call(routine.name)}({args}) -> {kind} {{"
        return [head, *braces(self, guarded(routine), [end], "let"), "}", ""]

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """From a tuple."""
        return f"let ({', '.join(names)}) = {function}({args});"

    def notes(self, library: Library) -> list[str]:
        """As a crate, without std, and as a module."""
        name = library.name
        return [
            "It is a crate: `cargo test` runs its self-test and the example of its documentation,",
            "`cargo doc --open` shows that, and `cargo add --path` takes it into yours. Without",
            f'std its user says `{name} = {{ path = "...", default-features = false, features = '
            '["libm"] }`;',
            "the functions of libm may differ in their last digits from those measured below.",
            f"src/{name}.rs alone is a module for a crate of yours.",
        ]

    def usage(self, library: Library) -> str:
        """A use of the first function."""
        return f"use {library.name}::{library.public[0].name};"

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.rs."""
        arms = []
        for r in library.public:
            count, many = len(r.arguments), len(r.results)
            args = ", ".join(f"x[{i}]" for i in range(count))
            call = f"{library.name}::{r.name}({args})"
            call = f"if {call} {{ 1.0 }} else {{ 0.0 }}" if r.truth else call
            got = (
                f"{{ let y = {call}; vec![{', '.join(f'y.{i}' for i in range(many))}] }}"
                if many > 1
                else f"vec![{call}]"
            )
            arm = wrapped([f'            "{r.name}" => ({count}, {got}),'])
            arms += [f"{part}\n" for part in arm]
        return {
            "selftest.rs": _SELFTEST.replace("NAME", library.name)
            .replace("ARMS", "".join(arms))
            .replace("REAL", self.real)
        }

    def commands(self, name: str) -> list[list[str]]:
        """Compile with warnings as errors, then run."""
        return [
            ["rustc", "--edition=2021", "-O", "-D", "warnings", "-o", "selftest", "selftest.rs"],
            ["./selftest"],
        ]


_ALLOWED = """\
// Formulas keep their brackets, digits and arguments; what is asked is what is true inside the
// domain, since NaN makes every comparison false; a name may get its value in a branch.
#![allow(unused_parens, unused_variables)]
#![allow(unexpected_cfgs)] // of the feature "libm", which a crate with std need not know
#![allow(clippy::approx_constant, clippy::double_parens, clippy::excessive_precision)]
#![allow(clippy::manual_range_contains, clippy::nonminimal_bool)]
#![allow(clippy::neg_cmp_op_on_partial_ord, clippy::needless_late_init, clippy::needless_return)]
#![allow(clippy::too_many_arguments, clippy::type_complexity, clippy::doc_lazy_continuation)]
"""

_CALLS = {
    "abs": "fabs", "atan2": "atan2", "cos": "cos", "exp": "exp", "exp_m1": "expm1",
    "floor": "floor", "mul_add": "fma", "sin": "sin", "sqrt": "sqrt", "tan": "tan",
}  # fmt: skip
"""Methods of std, and functions of the crate libm, which has them without std."""


def _without_std(real: str) -> list[str]:
    """A trait with the methods that floats have with std alone."""
    lines = []
    for method, call in _CALLS.items():
        more = {"atan2": ["x"], "mul_add": ["x", "y"]}.get(method, [])
        given = "".join(f", {name}: Self" for name in more)
        lines.append((f"        fn {method}(self{given}) -> Self", call, ["self", *more]))
    end = "" if real == "f64" else "f"
    return [
        '#[cfg(feature = "libm")]',
        "#[allow(unused_imports)] // where std is linked all the same",
        "use without_std::Real;",
        "",
        '#[cfg(feature = "libm")]',
        "#[allow(dead_code)] // newer compilers have some of these without std, too",
        "mod without_std {",
        "    pub trait Real {",
        *(f"{head};" for head, _, _ in lines),
        "    }",
        "",
        f"    impl Real for {real} {{",
        *(f"{head} {{ libm::{call}{end}({', '.join(args)}) }}" for head, call, args in lines),
        "    }",
        "}",
        "",
    ]


_PACKAGE = """\
[package]
name = "%(name)s"
version = "%(release)s"
edition = "2021"
rust-version = "1.60"
description = "%(title)s"
categories = ["no-std", "science::robotics"]
publish = false

[features]
default = ["std"]
std = []
libm = ["dep:libm"] # instead of std

[dependencies]
libm = { version = "0.2", optional = true }

[[test]]
name = "selftest"
path = "selftest.rs"
harness = false
"""

_CRATE = """\
//! %(title)s.
//!
//! All quantities are dimensionless, in units of the moving mass `m` and the sampling period `T`:
//! `alpha = K T^2/m`, `beta = B T/m`, `gamma = k T^2/m`, `delta = b T/m`, `d = t_d/T`,
//! `theta = omega T`.
//!
//! ```
//! let found = %(call)s;
//! println!("{found:?}");
//! ```
#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("one of the features std and libm is needed");

mod %(name)s;
pub use %(name)s::*;
"""

_SELFTEST = """#[path = "src/NAME.rs"]
mod NAME;

// -0x1.8000000000000p+1, always with 13 digits
fn parse(word: &str) -> REAL {
    if word.ends_with("nan") || word.ends_with("inf") {
        return word.parse().unwrap();
    }
    let (sign, rest) = match word.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, word),
    };
    let digits = format!("{}{}", &rest[2..3], &rest[4..17]);
    let whole = u64::from_str_radix(&digits, 16).unwrap() as f64;
    let power: i32 = rest[18..].parse().unwrap();
    let half = (power - 52) / 2; // in two steps, since 2^-1074 is no normal number
    (sign * whole * 2f64.powi(half) * 2f64.powi(power - 52 - half)) as REAL
}

fn main() {
    let text = std::fs::read_to_string("vectors.txt").unwrap();
    let (mut tried, mut missed) = (0, 0);
    for line in text.lines() {
        let mut words = line.split(' ');
        let name = words.next().unwrap();
        let x: Vec<REAL> = words.map(parse).collect();
        let (count, got): (usize, Vec<REAL>) = match name {
ARMS            _ => panic!("{}", name),
        };
        for (i, value) in got.iter().enumerate() {
            let (expected, allowed) = (x[count + 2 * i], x[count + 2 * i + 1]);
            tried += 1;
            let close = (value - expected).abs() <= allowed
                || (value.is_nan() && expected.is_nan());
            if !close {
                missed += 1;
                println!("{}, result {}: {} instead of {}", name, i, value, expected);
            }
        }
    }
    println!("{} values, {} missed", tried, missed);
    std::process::exit(if tried == 0 || missed > 0 { 1 } else { 0 });
}
"""

TARGET = Rust()
