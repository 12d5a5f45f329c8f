"""Fortran 2008."""

from __future__ import annotations

from types import MappingProxyType

from symhaptic.export import reserved
from symhaptic.export.branches import Assign, Block, Choice, Join, Set, guarded
from symhaptic.export.language import Target, called, describe
from symhaptic.export.precision import DOUBLE
from symhaptic.export.reserved import vocabulary
from symhaptic.export.routine import Library, Repeat, Routine, Several, plain
from symhaptic.export.statements import Words, worded, wrapped
from symhaptic.version import __version__

_WORDS = Words(
    end="",
    when="if ({}) then",
    otherwise="else",
    decided="end if",
    loop="do count_ = 1, {1}",
    leave=("if ({}) exit",),
    looped="end do",
    each=("do count_ = {first}, {last}, -{step}", "  {name} = inverse_factorial(count_)"),
)


class Fortran(Target):
    """One module; a function has one result, a subroutine several; both take arrays, too."""

    name, title, ignores_case = "fortran", "Fortran 2008", True
    choice = "merge({1}, {2}, {0})"
    words = MappingProxyType(
        {"&&": ".and.", "||": ".or.", "!=": "/=", "!": ".not.", "false": ".false."}
    )
    keywords = vocabulary(
        "allocatable allocate assign associate block call case character class close common "
        "complex contains continue cycle data deallocate default dimension do double elemental "
        "else elsewhere end endif enddo entry equivalence exit external final forall format "
        "function generic goto if implicit import include inquire integer intent interface "
        "intrinsic logical module namelist none nullify only open operator optional parameter "
        "pause pointer print private procedure program protected public pure read real recursive "
        "return rewind save select sequence stop submodule subroutine target then type use value "
        "volatile where while write exp sin cos tan sqrt abs max min floor merge wp expm1 fma "
        "selftest spread scale"
    )
    modules = reserved.FORTRAN
    operations = called(
        "",
        Infinity="ieee_value(1.0_wp, ieee_positive_inf)",
        NaN="ieee_value(1.0_wp, ieee_quiet_nan)",
        TwoProdError="fma({0}, {1}, -({1}*{0}))",  # the second may be a negative number
        floor="(aint({0}) - merge(1.0_wp, 0.0_wp, aint({0}) > {0}))",
    )
    single = operations

    @property
    def real(self) -> str:
        """The name of the kind."""
        return f"real{64 if self.precision is DOUBLE else 32}"

    def number(self, value: float) -> str:
        """A literal of the kind."""
        return f"{super().number(value)}_wp"

    def source(self, library: Library) -> dict[str, str]:
        """src/NAME.f90."""
        names = ", ".join(r.name for r in library.public)
        end, c_kind = ("", "c_double") if self.precision is DOUBLE else ("f", "c_float")
        lines = [
            f"module {library.name}",
            f"  use, intrinsic :: iso_fortran_env, only: wp => {self.real}",
            "  use, intrinsic :: ieee_arithmetic",
            "  implicit none",
            "  private",
            *_folded(f"  public :: {names}"),
            "",
            "  interface",
            *_of_c("expm1", "x", end, c_kind),
            *_of_c("fma", "x, y, z", end, c_kind),
            "  end interface",
            "",
        ]
        if table := self.table(library):
            listed = f"inverse_factorial(0:{library.factorials - 1})"
            lines += [*_folded("  ! 1/n!"),
                      *_folded(f"  real(wp), parameter :: {listed} = [{table}]"), ""]  # fmt: skip
        lines += ["contains", ""]
        for helper in library.helpers:
            lines += [*_folded(f"  ! {helper.about}"), *self._written(helper, "pure"), ""]
        for form, routine in zip(library.forms, library.public, strict=True):
            about = describe(form, self.precision)
            lines += [part for line in about for part in _folded(f"  ! {line}")]
            lines += [*self._written(routine, "elemental"), ""]
        text = "\n".join([*lines, f"end module {library.name}", ""])
        return {f"src/{library.name}.f90": text}

    def package(self, library: Library) -> dict[str, str]:
        """For the Fortran package manager."""
        words = {"name": library.name, "title": library.title, "release": __version__}
        return {"fpm.toml": _PACKAGE % words}

    def _results(self, routine: Routine) -> list[str]:
        if len(routine.results) == 1:
            return ["y_out"]
        return [f"{name}_out" for name, _ in routine.results]

    def _written(self, routine: Routine, word: str) -> list[str]:
        args = [self.rename(s.name) for s in routine.arguments]
        results, name = self._results(routine), self.call(routine.name)
        block = guarded(routine)
        locals_ = sorted({self.rename(n) for n in _assigned(block)})
        if len(results) == 1:
            head = f"  {word} function {name}({', '.join(args)}) result({results[0]})"
            kind = "logical" if routine.truth else "real(wp)"
            kinds, tail = [f"    {kind} :: {results[0]}"], "function"
        else:
            head = f"  {word} subroutine {name}({', '.join(args + results)})"
            kinds, tail = [f"    real(wp), intent(out) :: {', '.join(results)}"], "subroutine"
        declared = [f"    real(wp), intent(in) :: {', '.join(args)}"] if args else []
        declared += kinds + ([f"    real(wp) :: {', '.join(locals_)}"] if locals_ else [])
        if any(isinstance(step, Repeat) for step in plain(routine).steps):
            declared.append("    integer :: count_")
        lines = [
            head,
            *declared,
            *worded(self, block, results, _WORDS, "  ", 2),
            f"  end {tail} {name}",
        ]
        return [part for line in lines for part in _folded(line)]

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """From a subroutine."""
        return f"call {function}({', '.join([args, *names])})"

    def notes(self, library: Library) -> list[str]:
        """As a package, of arrays, and what it must not be compiled with."""
        name = library.name
        return [
            "Arguments are numbers or arrays of one shape: all functions and subroutines are",
            f'elemental. With fpm, `{name} = {{ path = "..." }}` under `[dependencies]` is enough,',
            "and `fpm test` runs the self-test.",
            "",
            "Never compile it with -ffast-math, -Ofast, -Mfprelaxed or -fp-model=fast (ifx's own;",
            "-fp-model=precise is right): they assume that there is no NaN, and reorder sums.",
            "Never use -freal-8-real-10 or similar flags either, which change the kind of the",
            "module's reals; -fdefault-real-8 does not. The self-test fails with gfortran's flags",
            "of both kinds. If the processor has fused multiplication (ARM, -march=native), use",
            "-ffp-contract=off to get the measured accuracy; in fpm, pass it with --flag.",
            "With -ffpe-trap=invalid, a program stops if a result is NaN, -1 or undecided.",
            "For 32-bit x86, compile it with -msse2 -mfpmath=sse: the x87 unit rounds each step to",
            "more digits, and a wall that is not stable may then count as stable.",
        ]

    def usage(self, library: Library) -> str:
        """A use of the first function."""
        return f"use {library.name}, only: {library.public[0].name}"

    def selftest(self, library: Library) -> dict[str, str]:
        """test/selftest.f90."""
        cases = []
        for r in library.public:
            count, many = len(r.arguments), len(r.results)
            args = [f"x({i + 1})" for i in range(count)]
            if many == 1:
                call = f"{r.name}({', '.join(args)})"
                call = f"got(1) = {f'merge(1.0_wp, 0.0_wp, {call})' if r.truth else call}"
            else:
                call = (
                    f"call {r.name}({', '.join([*args, *(f'got({i + 1})' for i in range(many))])})"
                )
            lines = [
                f'    case ("{r.name}")',
                f"      arguments = {count}",
                f"      results = {many}",
            ]
            lines += ["      call read_all(line, x, arguments + 2*results)"]
            cases += [part for line in [*lines, f"      {call}"] for part in _folded(line)]
        text = _SELFTEST.replace("NAME", library.name).replace("CASES", "\n".join(cases))
        text = text.replace("KIND", self.real)
        return {"test/selftest.f90": text}

    def commands(self, name: str) -> list[list[str]]:
        """Compile with warnings as errors, then run."""
        flags = [
            "-std=f2008",
            "-O2",
            "-ffp-contract=off",
            "-Wall",
            "-Wextra",
            "-pedantic",
            "-Werror",
        ]
        # exact comparisons with zero are meant
        flags += ["-Wno-compare-reals"]
        return [
            ["gfortran", *flags, "-o", "selftest", f"src/{name}.f90", "test/selftest.f90"],
            ["./selftest"],
        ]


def _of_c(name: str, args: str, end: str, kind: str) -> list[str]:
    """The interface of a function of the C library that Fortran 2008 lacks."""
    return [
        f'    pure function {name}({args}) bind(c, name="{name}{end}") result(value)',
        f"      use, intrinsic :: iso_c_binding, only: {kind}",
        f"      real({kind}), intent(in), value :: {args}",
        f"      real({kind}) :: value",
        f"    end function {name}",
    ]


def _assigned(block: Block) -> set[str]:
    found: set[str] = set()
    for statement in block:
        if isinstance(statement, (Assign, Set)):
            found.add(statement.name.name)
        elif isinstance(statement, Repeat):
            own = {*statement.states, *(n for n, _ in statement.steps), statement.number} - {None}
            found |= {s.name for s in own}
        elif isinstance(statement, Several):
            found |= {s.name for s in statement.names}
        elif isinstance(statement, (Choice, Join)):
            found |= _assigned(statement.yes) | _assigned(statement.no)
    return found


def _folded(line: str) -> list[str]:
    """A line in pieces that a compiler takes, each continued by an ampersand."""
    return wrapped([line], " &")


_PACKAGE = """\
name = "%(name)s"
version = "%(release)s"
description = "%(title)s"

[build]
auto-executables = false
auto-examples = false
auto-tests = false

[fortran]
implicit-typing = false
implicit-external = false
source-form = "free"

[library]
source-dir = "src"

[[test]]
name = "selftest"
source-dir = "test"
main = "selftest.f90"
"""

_SELFTEST = """program selftest
  use, intrinsic :: iso_fortran_env, only: wp => KIND, int64
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
  use NAME
  implicit none
  character(len=8000) :: line
  character(len=64) :: name
  real(wp) :: x(256), got(128), expected, allowed
  integer :: file, status, arguments, results, i, tried, missed
  tried = 0
  missed = 0
  open (newunit=file, file="vectors.txt", status="old", action="read")
  do
    read (file, '(a)', iostat=status) line
    if (status /= 0) exit
    i = index(line, " ")
    name = line(1:i - 1)
    line = adjustl(line(i:))
    select case (name)
CASES
    case default
      stop 2
    end select
    do i = 1, results
      expected = x(arguments + 2*i - 1)
      allowed = x(arguments + 2*i)
      tried = tried + 1
      if (ieee_is_nan(expected) .and. ieee_is_nan(got(i))) cycle
      if (.not. abs(got(i) - expected) <= allowed) then
        missed = missed + 1
        print *, trim(name), i, got(i), expected
      end if
    end do
  end do
  close (file)
  print *, tried, "values,", missed, "missed"
  if (tried == 0 .or. missed > 0) stop 1

contains

  ! -0x1.8000000000000p+1, always with 13 digits
  subroutine read_all(text, into, count)
    character(len=*), intent(inout) :: text
    real(wp), intent(out) :: into(:)
    integer, intent(in) :: count
    integer :: k, at, power
    integer(int64) :: whole
    character(len=14) :: digits
    into = 0
    do k = 1, count
      at = index(text(1:index(text, " ")), "x")
      if (at == 0) then ! nan, inf or -inf
        read (text(1:index(text, " ") - 1), *) into(k)
        text = adjustl(text(index(text, " "):))
        cycle
      end if
      digits = text(at + 1:at + 1)//text(at + 3:at + 15)
      read (digits, '(z14)') whole
      read (text(at + 17:index(text, " ") - 1), *) power
      into(k) = scale(real(whole, wp), power - 52)
      if (text(1:1) == "-") into(k) = -into(k)
      text = adjustl(text(index(text, " "):))
    end do
  end subroutine read_all
end program selftest
"""

TARGET = Fortran()
