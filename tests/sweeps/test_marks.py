"""A store accepts the function that began it, and no other: what it refers to counts."""

import itertools
import subprocess
import sys
import textwrap
from types import ModuleType

import pytest

from symhaptic import sweep
from symhaptic.sweeps.marks import mark

CHANGES = {
    "a constant": ("def f(a):\n    return 2*a", "def f(a):\n    return 3*a"),
    "an operation": ("def f(a):\n    return 2*a", "def f(a):\n    return 2+a"),
    "a tuple": ("def f(a):\n    return a*(1, 2)[1]", "def f(a):\n    return a*(1, 3)[1]"),
    "a set": ("def f(a):\n    return a*(a in {1, 2})", "def f(a):\n    return a*(a in {1, 3})"),
    "a comprehension": (
        "def f(a):\n    return sum([2*x for x in (a,)])",
        "def f(a):\n    return sum([3*x for x in (a,)])",
    ),
    "a lambda": ("f = lambda a: (lambda x: 2*x)(a)", "f = lambda a: (lambda x: 3*x)(a)"),
    "a nested class": (
        "g = 2\ndef f(a):\n    class C:\n        x = g\n    return a*C.x",
        "g = 3\ndef f(a):\n    class C:\n        x = g\n    return a*C.x",
    ),
    "a closure": (
        "def made(g):\n    return lambda a: g*a\nf = made(2)",
        "def made(g):\n    return lambda a: g*a\nf = made(3)",
    ),
    "a global": ("g = 2\ndef f(a):\n    return g*a", "g = 3\ndef f(a):\n    return g*a"),
    "a global in a comprehension": (
        "g = 2\ndef f(a):\n    return sum([g*x for x in (a,)])",
        "g = 3\ndef f(a):\n    return sum([g*x for x in (a,)])",
    ),
    "an array": (
        "import numpy\ng = numpy.array([1., 2.])\ndef f(a):\n    return a*g[1]",
        "import numpy\ng = numpy.array([1., 3.])\ndef f(a):\n    return a*g[1]",
    ),
    "a dictionary": (
        "g = {'a': [1, 2]}\ndef f(a):\n    return a*g['a'][1]",
        "g = {'a': [1, 3]}\ndef f(a):\n    return a*g['a'][1]",
    ),
    "a default": ("def f(a, g=2):\n    return a*g", "def f(a, g=3):\n    return a*g"),
    "another default": ("def f(a, *, g=2):\n    return a*g", "def f(a, *, g=3):\n    return a*g"),
    "a function": (
        "def h(a):\n    return 2*a\ndef f(a):\n    return h(a)",
        "def h(a):\n    return 3*a\ndef f(a):\n    return h(a)",
    ),
    "a function of the library": (
        "from math import sin as h\ndef f(a):\n    return h(a)",
        "from math import cos as h\ndef f(a):\n    return h(a)",
    ),
    "a function of NumPy": (
        "from numpy import sin as h\ndef f(a):\n    return h(a)",
        "from numpy import cos as h\ndef f(a):\n    return h(a)",
    ),
    "a method": (
        "class C:\n    def h(self, a):\n        return 2*a\nc = C()\ndef f(a):\n    return c.h(a)",
        "class C:\n    def h(self, a):\n        return 3*a\nc = C()\ndef f(a):\n    return c.h(a)",
    ),
    "a property": (
        "class C:\n    @property\n    def h(self):\n        return 2\nf = lambda a: a*C().h",
        "class C:\n    @property\n    def h(self):\n        return 3\nf = lambda a: a*C().h",
    ),
    "a base": (
        "class B:\n    g = 2\nclass C(B): pass\nf = lambda a: a*C.g",
        "class B:\n    g = 3\nclass C(B): pass\nf = lambda a: a*C.g",
    ),
    "an attribute": (
        "class C: pass\nc = C()\nc.g = 2\ndef f(a):\n    return c.g*a",
        "class C: pass\nc = C()\nc.g = 3\ndef f(a):\n    return c.g*a",
    ),
    "a callable": (
        "class C:\n    g = 2\n    def __call__(self, a):\n        return self.g*a\nf = C()",
        "class C:\n    g = 3\n    def __call__(self, a):\n        return self.g*a\nf = C()",
    ),
    "a bound method": (
        "class C:\n    def h(self, a):\n        return self.g*a\nc = C()\nc.g = 2\nf = c.h",
        "class C:\n    def h(self, a):\n        return self.g*a\nc = C()\nc.g = 3\nf = c.h",
    ),
    "a partial": (
        "from functools import partial\nf = partial(lambda g, a: g*a, 2)",
        "from functools import partial\nf = partial(lambda g, a: g*a, 3)",
    ),
    "a cached function": (
        "from functools import cache\n@cache\ndef f(a):\n    return 2*a",
        "from functools import cache\n@cache\ndef f(a):\n    return 3*a",
    ),
    "a decorated function": (
        "from functools import wraps\ndef w(h):\n    return wraps(h)(lambda a: h(a))\n"
        "@w\ndef f(a):\n    return 2*a",
        "from functools import wraps\ndef w(h):\n    return wraps(h)(lambda a: h(a))\n"
        "@w\ndef f(a):\n    return 3*a",
    ),
    "a wrapper's own value": (
        "from functools import update_wrapper\nclass C:\n    def __init__(self, h):\n"
        "        update_wrapper(self, h)\n        self.g = 2\n"
        "    def __call__(self, a):\n        return self.g*a\n@C\ndef f(a): pass",
        "from functools import update_wrapper\nclass C:\n    def __init__(self, h):\n"
        "        update_wrapper(self, h)\n        self.g = 3\n"
        "    def __call__(self, a):\n        return self.g*a\n@C\ndef f(a): pass",
    ),
    "a data class and an enumeration": (
        "import dataclasses, enum\n@dataclasses.dataclass\nclass P:\n    x: float = 2.0\n"
        "class E(enum.Enum):\n    one = 1\ndef f(a):\n    return P().x*a*E.one.value",
        "import dataclasses, enum\n@dataclasses.dataclass\nclass P:\n    x: float = 2.0\n"
        "class E(enum.Enum):\n    one = 2\ndef f(a):\n    return P().x*a*E.one.value",
    ),
    "an attribute of the function": (
        "def f(a):\n    return f.g*a\nf.g = 2",
        "def f(a):\n    return f.g*a\nf.g = 3",
    ),
    "a partial with the name of a function": (
        "from functools import partial, update_wrapper\ndef h(g, a):\n    return g*a\n"
        "f = update_wrapper(partial(h, 2), h)",
        "from functools import partial, update_wrapper\ndef h(g, a):\n    return g*a\n"
        "f = update_wrapper(partial(h, 3), h)",
    ),
    "an expression of SymPy": (
        "from sympy import Symbol, lambdify, sin\na = Symbol('a')\nf = lambdify(a, 2*sin(a))",
        "from sympy import Symbol, lambdify, sin\na = Symbol('a')\nf = lambdify(a, 3*sin(a))",
    ),
    "a function that an installed module wraps": (
        "from mpmath import memoize\nh = memoize(lambda a: 2*a)\nf = lambda a: h(a)",
        "from mpmath import memoize\nh = memoize(lambda a: 3*a)\nf = lambda a: h(a)",
    ),
    "a class that the library makes": (
        "import dataclasses as d\nP = d.make_dataclass('P', [('x', float, d.field(default=2))])\n"
        "f = lambda a: P().x*a",
        "import dataclasses as d\nP = d.make_dataclass('P', [('x', float, d.field(default=3))])\n"
        "f = lambda a: P().x*a",
    ),
    "a class of classes": (
        "class M(type):\n    def __getattr__(c, name):\n        return 2\n"
        "class C(metaclass=M): pass\nf = lambda a: C.g*a",
        "class M(type):\n    def __getattr__(c, name):\n        return 3\n"
        "class C(metaclass=M): pass\nf = lambda a: C.g*a",
    ),
    "a class of sets": (
        "class S(set):\n    def __len__(self):\n        return 2\ns = S()\nf = lambda a: len(s)*a",
        "class S(set):\n    def __len__(self):\n        return 3\ns = S()\nf = lambda a: len(s)*a",
    ),
    "a class of properties": (
        "class P(property):\n    def __get__(self, one, kind):\n        return 2\n"
        "class C:\n    x = P()\nf = lambda a: C().x*a",
        "class P(property):\n    def __get__(self, one, kind):\n        return 3\n"
        "class C:\n    x = P()\nf = lambda a: C().x*a",
    ),
}


def made(program):
    names = {"__name__": "__main__"}
    exec(program, names)
    return names["f"]


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_of_what_a_function_refers_to_changes_its_mark(change):
    one, other = CHANGES[change]
    assert mark(made(one)) == mark(made(one))
    assert mark(made(one)) != mark(made(other))
    assert mark(made(one)) == mark(made(f"# moved\n\n{one}\nbeside = 3"))


@pytest.mark.parametrize(
    "how", ["import own; h = own.h", "from own import h", "inside", "pkg", "not yet", "part"]
)
def test_a_change_of_ones_own_module_changes_the_mark(how, tmp_path):
    """And in another process everything has the mark that it had, whatever hashes are."""
    import_it = {
        "inside": "def f(a):\n    from own import h\n    return h(a)",
        "pkg": "import pkg.own\ndef f(a):\n    return pkg.own.h(a)",
        "not yet": "def f(a):\n    if a > 1:\n        from own import h\n        return h(a)",
        "part": "def f(a):\n    if a > 1:\n        from pkg import own\n        return own.h(a)",
    }.get(how, f"{how}\ndef f(a):\n    return h(a)")
    program = (
        f"import sys; sys.path.insert(0, {str(tmp_path)!r})\n{import_it}\nf(1)\n"
        "from symhaptic.sweeps.marks import mark\nprint(mark(f))"
    )
    (tmp_path / "pkg").mkdir()
    (tmp_path / "pkg" / "__init__.py").touch()

    def told(text):
        for place in (tmp_path / "own.py", tmp_path / "pkg" / "own.py"):
            place.write_text(textwrap.dedent(text))
        command = [sys.executable, "-B", "-c", program]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    words = "NAMES = {{'a', 'b', 'c', 'd'}}\nGAIN = {}\ndef h(a):\n    return a*GAIN*len(NAMES)\n"
    first = told(words.format(2))
    assert told(words.format(2)) == first
    assert told(words.format(3)) != first
    assert told(words.format(2).replace("len", "-len")) != first


def test_a_function_keeps_its_mark_while_it_is_called():
    """CPython replaces instructions of code that runs often."""
    function = made("def f(a):\n    return sum([x*a for x in range(3)])")
    before = mark(function)
    for _ in range(10_000):
        function(2.0)
    assert mark(function) == before


def test_a_module_that_has_the_name_of_what_is_imported_does_not_count(monkeypatch):
    function = made("def f(a):\n    from math import sin as h\n    return h(a)")
    before = mark(function)
    monkeypatch.setitem(sys.modules, "sin", ModuleType("sin"))
    assert mark(function) == before


def test_a_function_that_refers_to_itself_has_a_mark():
    program = (
        "def made(g):\n    def h(a):\n        return g if a else h(a)\n    return h\nf = made({})"
    )
    one, two, three = (made(program.format(g)) for g in (2, 2, 3))
    assert mark(one) == mark(two) != mark(three)


def test_a_variable_without_a_value_is_left_out_of_a_mark():
    def f(a):
        return g(a)

    before = mark(f)
    g = abs
    assert mark(f) != before


def test_what_cannot_be_compared_is_refused_where_it_is_kept(tmp_path):
    count = itertools.count()
    lines = (line for line in "ab")

    def f(a):
        next(lines, count)
        return a

    assert sweep(f, a=[1.0]).f.values.tolist() == [1.0]
    told = r"^quantity: refers to a builtins\.generator, which cannot be compared when .+ to= out$"
    with pytest.raises(ValueError, match=told):
        sweep(f, a=[1.0], to=tmp_path / "kept.parquet")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("program", "told"),
    [
        ("g = 2\nf = lambda a: eval('g*a')", "<lambda> calls eval, so what it computes"),
        ("g = 2\nf = lambda a: globals()['g']*a", "<lambda> calls globals, so what it computes"),
        ("import numpy\nf = numpy.frompyfunc(lambda a: 2*a, 1, 1)", "refers to a numpy.ufunc"),
        ("from functools import singledispatch\n@singledispatch\ndef f(a):\n    return 2*a",
         "refers to a weakref"),
    ],
)  # fmt: skip
def test_what_names_no_longer_tell_is_refused(program, told):
    with pytest.raises(ValueError, match=f"^quantity: {told}.+cannot be compared when"):
        mark(made(program))


@pytest.mark.parametrize("name", ["numpy.sin", "numpy.interp", "numpy.random.rand", "math.sin"])
def test_functions_of_installed_modules_have_a_mark(name):
    home, _, word = name.rpartition(".")
    assert mark(made(f"from {home} import {word} as h\nf = lambda a: h(a)"))


def test_a_function_with_many_names_has_a_mark():
    """Python writes the number of a name beyond the 256th in an instruction of its own."""
    names = "; ".join(f"x.a{i}" for i in range(300))
    space = {}
    exec(f"def many(x):\n    {names}\n    from os.path import join\n    return join", space)
    assert mark(space["many"])
