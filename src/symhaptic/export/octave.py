"""GNU Octave and MATLAB."""

from __future__ import annotations

from types import MappingProxyType

from sympy.printing.octave import OctaveCodePrinter

from symhaptic.export.branches import lazy
from symhaptic.export.library import Library
from symhaptic.export.printing import Printing
from symhaptic.export.routine import Routine
from symhaptic.export.statements import Words, worded
from symhaptic.export.target import Target, called, describe, vocabulary


class _Printer(Printing, OctaveCodePrinter):  # type: ignore[misc]
    """SymPy's, with the shared operations."""


_WORDS = Words(
    end=";",
    when="if {}",
    otherwise="else",
    decided="end",
    loop="for count_{0} = 1:{1}",
    leave=("if {}", "  break;", "end"),
    looped="end",
)


class Octave(Target):
    """One file a function, of scalars, with what it needs behind it; arrayfun does arrays."""

    name, title, printer = "octave", "GNU Octave and MATLAB", _Printer
    choice = "pick({0}, {1}, {2})"
    words = MappingProxyType({"!=": "~=", "!": "~"})
    keywords = vocabulary(
        "break case catch classdef continue do else elseif end endfunction endif endwhile "
        "enumeration events for function global if methods otherwise parfor persistent properties "
        "return spmd switch try unwind_protect until while pick pi i j ans selftest"
    )
    operations = called(
        "",
        Infinity="Inf",
        NaN="NaN",
        ProductError="product_error({0}, {1})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """FUNCTION.m for each of them, in a folder +NAME, which is a package."""
        files = {}
        written = {helper.name: self._helper(helper) for helper in library.helpers}
        for form, routine in zip(library.forms, library.public, strict=True):
            lines = [self._head(routine), *(f"  % {line}" for line in describe(form))]
            lines += [*self._body(routine), "end", ""]
            for helper in library.needed(routine):
                lines += written[helper.name]
            files[f"+{library.name}/{routine.name}.m"] = "\n".join([*lines, _PICK])
        return files

    def _helper(self, routine: Routine) -> list[str]:
        return [f"% {routine.about}", self._head(routine), *self._body(routine), "end", ""]

    def _results(self, routine: Routine) -> list[str]:
        return [f"{self.rename(name)}_out" for name, _ in routine.results]

    def _body(self, routine: Routine) -> list[str]:
        return worded(self, lazy(routine), self._results(routine), _WORDS, "  ")

    def _head(self, routine: Routine) -> str:
        args = ", ".join(self.rename(s.name) for s in routine.arguments)
        results = ", ".join(self._results(routine))
        return f"function [{results}] = {self.call(routine.name)}({args})"

    def unpacked(self, names: list[str], function: str, args: str) -> list[str]:
        """As results."""
        return [f"[{', '.join(names)}] = {function}({args});"]

    def usage(self, library: Library) -> str:
        """A call of the first function."""
        first = library.public[0]
        args = ", ".join(s.name for s in first.arguments)
        names = ", ".join(name for name, _ in first.results)
        return f"[{names}] = {library.name}.{first.name}({args});"

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.m."""
        cases = []
        for r in library.public:
            many = len(r.results)
            args = ", ".join(f"x({i + 1})" for i in range(len(r.arguments)))
            outs = ", ".join(f"got({i + 1})" for i in range(many))
            cases.append(
                f"    case '{r.name}'\n      count = {len(r.arguments)}; got = zeros(1, {many});\n"
                f"      [{outs}] = {library.name}.{r.name}({args});\n"
            )
        return {"selftest.m": _SELFTEST.replace("CASES", "".join(cases))}

    def commands(self, name: str) -> list[list[str]]:
        """Run; the program takes a warning for a miss."""
        return [["octave-cli", "--norc", "--no-history", "--quiet", "--eval", "selftest"]]


_PICK = """% one of two numbers
function y = pick(condition, yes, no)
  if condition
    y = yes;
  else
    y = no;
  end
end
"""

_SELFTEST = """function selftest()
  tried = 0; missed = 0;
  file = fopen('vectors.txt', 'r');
  line = fgetl(file);
  while ischar(line)
    words = strsplit(strtrim(line), ' ');
    x = cellfun(@parse, words(2:end));
    switch words{1}
CASES    otherwise
      exit(2);
    end
    for i = 1:numel(got)
      tried = tried + 1;
      if ~(abs(got(i) - x(count + 2*i - 1)) <= x(count + 2*i))
        missed = missed + 1;
        printf('%s, result %d: %.17g instead of %.17g\\n', words{1}, i, got(i), x(count + 2*i - 1));
      end
    end
    line = fgetl(file);
  end
  fclose(file);
  printf('%d values, %d missed\\n', tried, missed);
  exit(tried == 0 || missed > 0 || ~isempty(lastwarn()));
end

% -0x1.8000000000000p+1, always with 13 digits
function y = parse(word)
  sign = 1;
  if word(1) == '-'
    sign = -1; word = word(2:end);
  end
  whole = hex2dec([word(3) word(5:11)])*2^24 + hex2dec(word(12:17));
  y = sign*whole*2^(str2double(word(19:end)) - 52);
end
"""

TARGET = Octave()
