r"""Formulas set as by hand: SymPy expressions to LaTeX, in the order an engineer writes them.

Products run number, parameters, sums, angles, functions; sums start with a positive term and
fall in powers of z; :math:`\sin d\theta` has no needless brackets; exponents use a slash.
"""

from __future__ import annotations

import re

import sympy as sp
from sympy import Expr

from symhaptic.notation import SYMBOLS
from symhaptic.notation.term_order import NAMED, base_of, factors, ordered_terms

_RELATIONS = {"==": "=", "!=": r"\ne", "<": "<", ">": ">", "<=": r"\le", ">=": r"\ge"}


EULER = r"\mathrm{e}"
"""Euler's number, upright: the determinant of a sampled device is an italic e."""


def euler(typed: str) -> str:
    r"""Typed LaTeX with Euler's number upright where it has an exponent.

    >>> euler(r"2e^{j\theta}+\theta e^{-1}+e")
    '2\\mathrm{e}^{j\\theta}+\\theta \\mathrm{e}^{-1}+e'
    """
    return re.sub(r"(?<![A-Za-z\\])e(?=\^)", r"\\mathrm{e}", typed)


def latex(expr: Expr, inline: bool = False) -> str:
    r"""LaTeX of an expression, relation or vector; ``inline`` avoids built-up fractions.

    >>> from symhaptic.notation import K, T, d, theta
    >>> latex(K*T*sp.sin((d + 1)*theta)/2)
    '\\frac{KT\\sin(d+1)\\theta}{2}'
    >>> latex(sp.exp(-d/2))
    '\\mathrm{e}^{-d/2}'
    """
    return _Writer(inline).write(sp.sympify(expr, strict=True))


_COMMANDS = frozenset(
    """
    alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi pi
    varpi rho varrho sigma varsigma tau upsilon phi varphi chi psi omega Gamma Delta Theta Lambda
    Xi Pi Sigma Upsilon Phi Psi Omega ell hbar imath jmath Re Im infty partial nabla emptyset prime
    sin cos tan cot sec csc sinh cosh tanh coth arcsin arccos arctan exp ln log lim liminf limsup
    max min sup inf arg det gcd deg dim ker mod bmod pmod sum prod int iint oint
    frac tfrac dfrac binom sqrt overline underline overbrace underbrace hat widehat bar dot ddot
    tilde widetilde vec mathrm mathbf mathit mathbb mathcal mathsf operatorname text mathrel
    mathbin mathop left right big Big bigg Bigg bigl bigr Bigl Bigr biggl biggr Biggl Biggr
    langle rangle lceil rceil lfloor rfloor lvert rvert lVert rVert vert Vert
    le leq ge geq ne neq ll gg lesssim gtrsim approx sim simeq equiv cong propto in notin ni subset
    subseteq supset supseteq not neg lnot wedge land vee lor forall exists vdash models mid
    parallel perp to gets mapsto rightarrow leftarrow Rightarrow Leftarrow leftrightarrow
    Leftrightarrow implies iff cdot times div pm mp ast star circ bullet oplus otimes cap cup
    setminus ldots cdots dots vdots ddots quad qquad displaystyle textstyle limits nolimits
    allowbreak br changed
    """.split()  # noqa: SIM905
)
"""Commands that a typed formula may have: none reads a file, defines anything or leaves math."""

_ENVIRONMENT = re.compile(
    r"\\begin\{([bpvV]?matrix|cases|aligned|gathered)\}((?:(?!\\begin|\\end).)*)\\end\{\1\}",
    re.DOTALL,
)
_REFUSED = re.compile(r"\\(?P<name>[A-Za-z]+)|(?P<sign>\\\\|[$%#`&]|\^\^)|\\.", re.DOTALL)
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f]|\n\s*\n")


def refused(tex: str) -> str | None:
    r"""Return why a typed text is not printed as a formula, or None.

    TeX would run a text such as ``\input{file}``, and a dollar sign would end the formula.

    >>> refused(r"\frac{K}{2} < \text{50\%}"), refused("x_{1"), refused(r"x\input{a}")
    (None, 'has braces that do not match', 'has \\input, which is no command of a formula')
    """
    depth = 0
    for brace in re.findall(r"\\.|[{}]", tex):
        depth += {"{": 1, "}": -1}.get(brace, 0)
        if depth < 0:
            break
    if depth:
        return "has braces that do not match"
    inner, found = tex, 1
    while found:
        inner, found = _ENVIRONMENT.subn(lambda rows: re.sub(r"\\\\|&", " ", rows[2]), inner)
    for sign in _REFUSED.finditer(inner):
        if sign["name"] and sign["name"] not in _COMMANDS:
            return f"has {sign[0]}, which is no command of a formula"
        if sign["sign"]:
            return f"has {sign[0]!r}, which is no sign of a formula"
    if _CONTROL.search(tex) or tex.endswith("\\"):
        return "has a blank line, a control character or a backslash at its end"
    return None


def _inert(tex: str) -> str:
    r"""LaTeX of a name, whose signs become question marks where TeX would run it.

    >>> latex(sp.Symbol(r"\input{a}")), latex(sp.Symbol("k_w"))
    ('\\text{?input?a?}', 'k_{w}')
    """
    return tex if refused(tex) is None else rf"\text{{{re.sub(r'[^A-Za-z0-9 ]', '?', tex)}}}"


class _Writer:
    def __init__(self, inline: bool) -> None:
        self.inline = inline

    def write(self, expr: Expr) -> str:
        if isinstance(expr, sp.core.relational.Relational):
            sign = _RELATIONS[expr.rel_op]
            return f"{self.write(expr.lhs)} {sign} {self.write(expr.rhs)}"
        if isinstance(expr, sp.MatrixBase):
            rows = r" \\ ".join(
                " & ".join(self.write(e) for e in expr.row(i)) for i in range(expr.rows)
            )
            return rf"\begin{{pmatrix}} {rows} \end{{pmatrix}}"
        if isinstance(expr, (tuple, sp.Tuple)):
            return r",\quad ".join(self.write(e) for e in expr)
        if expr.is_Symbol:
            name = expr.name.rstrip("'")
            plain = SYMBOLS[name].latex if name in SYMBOLS else _inert(sp.latex(sp.Symbol(name)))
            return f"{plain}{expr.name[len(name) :]}"
        if expr.is_Rational:
            if expr.q == 1:
                return str(expr.p)
            return ("-" if expr.p < 0 else "") + self.fraction(str(abs(expr.p)), str(expr.q))
        if expr is sp.I:
            return "j"
        if expr.is_Add:
            return self.sum(expr)
        if isinstance(expr, sp.exp):
            return f"{EULER}^{{{_Writer(True).write(_joined(expr.args[-1]))}}}"
        if expr is sp.E:
            return EULER
        if expr.is_Pow and not (expr.args[1].is_Rational and expr.args[1] < 0):
            return self.power(expr)
        if expr.is_Mul or expr.is_Pow:
            return self.product(expr)
        if expr.func in NAMED:
            return self.function(expr, 1)
        if isinstance(expr, sp.atan):
            return rf"\arctan({self.write(expr.args[0])})"
        if isinstance(expr, sp.Abs):
            return f"|{self.write(expr.args[0])}|"
        if isinstance(expr, sp.re):
            return rf"\Re\{{{self.write(expr.args[0])}\}}"
        if isinstance(expr, sp.core.function.AppliedUndef):
            name = _inert(expr.func.__name__)
            inner = ",".join(self.write(a) for a in expr.args)
            return f"{name}({inner})"
        return _inert(str(sp.latex(expr)))

    # -- sums -------------------------------------------------------------------------

    def sum(self, expr: Expr) -> str:
        return joined([self.write(term) for term in ordered_terms(expr)])

    # -- products and powers -----------------------------------------------------------

    def product(self, expr: Expr) -> str:
        negative, top, bottom = factors(expr)
        if bottom:
            lone_sum = len(top) == 1 and top[0].is_Add and all(f.is_Integer for f in bottom)
            if lone_sum and not self.inline:
                scale = self.fraction("1", self.factors_of(bottom))
                text = scale + self.bracketed(top[0])
            else:
                lead = _Writer(self.inline)
                below = lead.factors_of(bottom, alone=True)
                text = self.fraction(lead.factors_of(top, alone=True), below)
        else:
            text = self.factors_of(top)
        return f"-{text}" if negative else text

    def fraction(self, top: str, bottom: str) -> str:
        if not self.inline:
            digits = top.isdigit() and bottom.isdigit()
            return rf"{chr(92)}{'tfrac' if digits else 'frac'}{{{top}}}{{{bottom}}}"
        if _loose(top) and not _enclosed(top):
            top = f"({top})"
        if not (len(bottom) == 1 or bottom.isdigit() or _one_command(bottom)):
            bottom = bottom if _enclosed(bottom) else f"({bottom})"
        return f"{top}/{bottom}"

    def factors_of(self, items: list[Expr], alone: bool = False) -> str:
        if not items:
            return "1"
        if alone and len(items) == 1:
            return self.write(items[0])
        texts = [self.factor(f) for f in items]
        out = texts[0]
        for before, item, text in zip(items, items[1:], texts[1:], strict=False):
            spaced = base_of(before).func in NAMED or isinstance(before, sp.exp)
            if text.startswith("-"):
                text = f"({text})"
            if before.is_Integer and (item.is_Rational or text[0].isdigit()):
                out += r" \cdot "
            elif spaced:
                out += r"\,"
            elif out[-1].isalpha() and "\\" in out.split("{")[-1] and text[0].isalpha():
                out += " "
            out += text
        return out

    def factor(self, expr: Expr) -> str:
        if expr.is_Add or expr.is_Mul or (self.inline and expr.is_Rational and expr.q != 1):
            return self.bracketed(expr)
        return self.write(expr)

    def bracketed(self, expr: Expr) -> str:
        inner = self.write(expr)
        if r"\frac" in inner:
            return rf"\left({inner}\right)"
        if r"\tfrac" in inner:
            return rf"\bigl({inner}\bigr)"
        if "(" in inner and not self.inline:
            return rf"\bigl({inner}\bigr)"
        return f"({inner})"

    def power(self, expr: Expr) -> str:
        base, exponent = expr.args
        if exponent == sp.Rational(1, 2):
            return rf"\sqrt{{{self.write(base)}}}"
        if base.func in NAMED and exponent.is_Integer:
            return self.function(base, int(exponent))
        script = _Writer(True).write(_joined(exponent))
        if base.is_Symbol and not (base.name in SYMBOLS and "_" in SYMBOLS[base.name].latex):
            return f"{self.write(base)}^{script if len(script) == 1 else '{' + script + '}'}"
        inner = self.write(base) if base.is_Symbol else self.bracketed(base)
        if base.is_Symbol:
            name, sub = inner.split("_", 1)
            return f"{name}_{sub}^{{{script}}}"
        if isinstance(base, sp.exp):
            inner = rf"\left({self.write(base)}\right)"
        elif base is sp.pi or (base.is_Integer and base > 0):
            inner = self.write(base)
        return f"{inner}^{{{script}}}"

    def function(self, expr: Expr, power: int) -> str:
        script = f"^{power}" if 1 < power < 10 else f"^{{{power}}}" if power != 1 else ""
        name = NAMED[expr.func] + script
        argument = expr.args[0]
        if argument.is_Rational or argument.is_Add or argument.could_extract_minus_sign():
            return f"{name}{self.bracketed(argument)}"
        shown = _Writer(self.inline).write(argument)
        if not self.inline:
            shown = shown.replace(r"\frac", r"\tfrac")
        elif "/" in shown:
            shown = f"({shown})"
        if _ends_early(shown):
            shown = rf"\bigl({shown}\bigr)"
        return name + (shown if shown[0] in "\\(" else " " + shown)


def joined(terms: list[str]) -> str:
    """Terms written one after the other with their signs.

    >>> joined(["a", "-b", "c"])
    'a-b+c'
    """
    return terms[0] + "".join(t if t.startswith("-") else f"+{t}" for t in terms[1:])


def _joined(exponent: Expr) -> Expr:
    return sp.together(exponent) if exponent.is_Add else exponent


def _enclosed(text: str) -> bool:
    if not (text.startswith("(") and text.endswith(")")):
        return False
    depth = 0
    for i, c in enumerate(text):
        depth += (c == "(") - (c == ")")
        if depth == 0:
            return i == len(text) - 1
    return False


def _flat(text: str, opening: str = "(", closing: str = ")", left: str = "[]") -> str:
    """LaTeX with ``[]`` in place of each bracket."""
    inner = rf"\{opening}[^{opening}{closing}]*\{closing}"
    while (outside := re.sub(inner, left, text)) != text:
        text = outside
    return text


_NAMES = rf"\\(?:{'|'.join(name[1:] for name in NAMED.values())})(?![a-z])"


def _ends_early(argument: str) -> bool:
    r"""Whether a function before it seems to be of its first bracket, or factors, alone.

    >>> _ends_early("(a+b)^{2}"), _ends_early("(a+b)(c+d)"), _ends_early(r"(d+1)\theta")
    (True, True, False)
    >>> _ends_early(r"a\cos b"), _ends_early(r"\cos ab"), _ends_early(r"\tfrac{a\cos b}{2}")
    (True, False, False)
    """
    flat, command = _flat(_flat(argument), "{", "}", ""), r"(?:\\left|\\bigl)?"
    again = rf"{command}\[\](?:\^|{command}\[\])"
    return bool(re.match(again, flat) or re.match(rf"(?!{_NAMES}).+?{_NAMES}", flat))


def is_sum(text: str) -> bool:
    r"""Whether LaTeX has a sign outside of all brackets and braces.

    >>> is_sum("a+b"), is_sum("-b"), is_sum("2(a+b)"), is_sum("e^{-a}")
    (True, True, False, False)
    """
    return re.search(r"[-+]", _flat(_flat(text, "{", "}", ""))) is not None


def is_factor(text: str) -> bool:
    r"""Whether what is written behind it multiplies all of it: no sum, quotient or bare function.

    >>> is_factor("KT"), is_factor("K/T"), is_factor(r"\sin x"), is_factor(r"\sin(x)")
    (True, False, False, True)
    """
    return not (_loose(text) or "/" in _flat(_flat(text, "{", "}", "")))


def _loose(top: str) -> bool:
    r"""Whether a slash behind it would not divide all of it: a sum, or a function without brackets.

    >>> _loose(r"2b(1-\cos x)"), _loose("a+b"), _loose(r"\cos\theta"), _loose(r"\cos(d+1)\theta")
    (False, True, True, True)
    """
    flat = _flat(re.sub(r"\{[^{}]*\}", "{}", top))
    if "+" in flat or "-" in flat:
        return True
    last = re.split(_NAMES, flat)
    return len(last) > 1 and re.fullmatch(r"(\^\w)?\[\]", last[-1]) is None


def _one_command(text: str) -> bool:
    r"""Whether a slash before it divides by all of it.

    >>> _one_command("m'"), _one_command("n_1^2"), _one_command(r"\delta"), _one_command("T^2m")
    (True, True, True, False)
    """
    name, script = r"(\\[A-Za-z]+|[A-Za-z])'*", r"(\w|\{\w+\})"
    return re.fullmatch(f"{name}(_{script})?(\\^{script})?", text) is not None
