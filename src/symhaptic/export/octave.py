"""GNU Octave and MATLAB."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType

from symhaptic.export import reserved
from symhaptic.export.branches import guarded
from symhaptic.export.language import Target, called, describe
from symhaptic.export.reserved import vocabulary
from symhaptic.export.routine import Library, Routine
from symhaptic.export.statements import Words, worded, wrapped
from symhaptic.forms.stable import Form

_WORDS = Words(
    end=";",
    when="if {}",
    otherwise="else",
    decided="end",
    loop="for count_{0} = 1:{1}",
    leave=("if {}", "  break;", "end"),
    looped="end",
    each=("for {name} = inverse_factorial({first}:-{step}:{last})",),
)


class Octave(Target):
    """One file a function, of numbers and of arrays, with what it needs behind it."""

    name, title = "octave", "GNU Octave and MATLAB"
    choice = "pick({0}, {1}, {2})"
    words = MappingProxyType({"!=": "~=", "!": "~"})
    keywords = vocabulary(
        "break case catch classdef continue do else elseif end endfunction endif endwhile "
        "enumeration events for function global if methods otherwise parfor persistent properties "
        "return spmd switch try unwind_protect until while pick pi i j ans selftest "
        "elementwise names varargout varargin nargout"
    )
    modules = reserved.OCTAVE
    operations = called(
        "",
        Infinity="Inf",
        NaN="NaN",
        TwoProdError="two_prod_error({0}, {1})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """FUNCTION.m for each of them, in a folder +NAME, which is a package."""
        files = {}
        written = {helper.name: self._helper(helper) for helper in library.helpers}
        for form, routine in zip(library.forms, library.public, strict=True):
            about = [f"  % {line}".rstrip() for line in self._help(library, routine, form)]
            lines = [self._head(routine, "varargout" if routine.arguments else ""), *about]
            if routine.arguments:
                lines += [*_of_arrays(routine), "end", "", *_ELEMENTWISE.split("\n")]
                lines += ["% the same of numbers", self._head(replace(routine, name="of_numbers"))]
            lines += [*self._body(routine), "end", ""]
            needed = list(library.needed(routine))
            if table := self.table(replace(library, helpers=tuple(needed))):
                lines += ["% 1/n!", "function y_out = inverse_factorial(n)"]
                lines += [f"  numbers = [{table}];", "  y_out = numbers(n + 1);", "end", ""]
            for helper in needed:
                lines += written[helper.name]
            text = [*wrapped(lines, " ..."), _PICK]
            files[f"+{library.name}/{routine.name}.m"] = "\n".join(text)
        return files

    def _help(self, library: Library, routine: Routine, form: Form) -> list[str]:
        """As `help` shows it: the name and what it is, a call, the arguments and the domain."""
        first, *others = describe(form, self.precision)
        count = len(form.arguments)
        arrays = ["Arguments are numbers or arrays; all arrays must have the same size.", ""]
        return [
            f"{routine.name.upper()}  {first}", "", f"  {self._call(library, routine)}", "",
            *(f"  {line}" for line in others[:count]), *[""] * bool(count), *arrays * bool(count),
            *others[count:],
        ]  # fmt: skip

    def _call(self, library: Library, routine: Routine) -> str:
        args = ", ".join(symbol.name for symbol in routine.arguments)
        names = ", ".join(name for name, _ in routine.results)
        outs = f"[{names}]" if len(routine.results) > 1 else names
        return f"{outs} = {library.name}.{routine.name}({args})"

    def _helper(self, routine: Routine) -> list[str]:
        return [f"% {routine.about}", self._head(routine), *self._body(routine), "end", ""]

    def _results(self, routine: Routine) -> list[str]:
        return [f"{self.rename(name)}_out" for name, _ in routine.results]

    def _body(self, routine: Routine) -> list[str]:
        return worded(self, guarded(routine), self._results(routine), _WORDS, "  ")

    def _head(self, routine: Routine, outs: str = "") -> str:
        args = ", ".join(self.rename(s.name) for s in routine.arguments)
        outs = outs or f"[{', '.join(self._results(routine))}]"
        return f"function {outs} = {self.call(routine.name)}({args})"

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """As results."""
        return f"[{', '.join(names)}] = {function}({args});"

    def notes(self, library: Library) -> list[str]:
        """What it takes."""
        return [
            "Arguments are numbers or arrays. All arrays must have the same size, and the results",
            "have this size.",
            f"The folder that contains +{library.name} must be on the path.",
        ]

    def usage(self, library: Library) -> str:
        """A call of the first function."""
        return f"{self._call(library, library.public[0])};"

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.m."""
        cases = []
        for r in library.public:
            many = len(r.results)
            args = ", ".join(f"x({i + 1})" for i in range(len(r.arguments)))
            outs = ", ".join(f"got({i + 1})" for i in range(many))
            lines = [
                f"    case '{r.name}'",
                f"      count = {len(r.arguments)}; got = zeros(1, {many});",
                f"      [{outs}] = {library.name}.{r.name}({args});",
            ]
            cases += [f"{part}\n" for part in wrapped(lines, " ...")]
        return {"selftest.m": _SELFTEST.replace("CASES", "".join(cases))}

    def commands(self, name: str) -> list[list[str]]:
        """Run; the program takes a warning for a miss."""
        return [["octave-cli", "--norc", "--no-history", "--quiet", "--eval", "selftest"]]


def _of_arrays(routine: Routine) -> list[str]:
    """The call for each element."""
    names = ", ".join(f"'{s.name}'" for s in routine.arguments)
    args = ", ".join(TARGET.rename(s.name) for s in routine.arguments)
    return [
        f"  names = {{{names}}};",
        f"  [varargout{{1:max(nargout, 1)}}] = elementwise(@of_numbers, names, {args});",
    ]


_ELEMENTWISE = """% one function of numbers, and of arrays of one size beside numbers
function varargout = elementwise(one, names, varargin)
  wide = [1 1];
  for k = 1:numel(varargin)
    x = varargin{k};
    if ~(isnumeric(x) || islogical(x)) || ~isreal(x)
      error('%s: not a real number; give real numbers', names{k});
    elseif numel(x) ~= 1 && isequal(wide, [1 1])
      wide = size(x);
    elseif numel(x) ~= 1 && ~isequal(wide, size(x))
      error('%s: has the size %s; numbers and arrays of the size %s are allowed', ...
          names{k}, mat2str(size(x)), mat2str(wide));
    end
    varargin{k} = double(x);
  end
  if isequal(wide, [1 1])
    [varargout{1:nargout}] = one(varargin{:});
    return
  end
  if any(wide == 0)
    none = num2cell(NaN(size(varargin)));
    [varargout{1:nargout}] = one(none{:});
    varargout = cellfun(@(y) repmat(y, wide), varargout, 'UniformOutput', false);
    return
  end
  for k = 1:numel(varargin)
    if numel(varargin{k}) == 1
      varargin{k} = repmat(varargin{k}, wide);
    end
  end
  [varargout{1:nargout}] = arrayfun(one, varargin{:});
end
"""

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
      none = isnan(got(i)) && isnan(x(count + 2*i - 1));
      if ~(abs(got(i) - x(count + 2*i - 1)) <= x(count + 2*i)) && ~none
        missed = missed + 1;
        fprintf('%s, result %d: %.17g instead of %.17g\\n', ...
            words{1}, i, got(i), x(count + 2*i - 1));
      end
    end
    line = fgetl(file);
  end
  fclose(file);
  fprintf('%d values, %d missed\\n', tried, missed);
  exit(tried == 0 || missed > 0 || ~isempty(lastwarn()));
end

% -0x1.8000000000000p+1, always with 13 digits
function y = parse(word)
  if any(strcmp(word, {'nan', 'inf', '-inf'}))
    y = str2double(word);
    return
  end
  sign = 1;
  if word(1) == '-'
    sign = -1; word = word(2:end);
  end
  whole = hex2dec([word(3) word(5:11)])*2^24 + hex2dec(word(12:17));
  y = sign*whole*2^(str2double(word(19:end)) - 52);
end
"""

TARGET = Octave()
