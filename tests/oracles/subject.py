"""What the oracles are held against: the formulas of the chapters, and numbers put into them."""

from functools import cache

import mpmath
import sympy as sp
from chapters import chapter

DIGITS = 60


def page(name):
    """The page of a chapter, run once per process."""
    return chapter(name).page


def shown(chapter, title, which=0):
    """Right side of an equation on a chapter's page, its last line; ``which`` of equal titles."""
    found = [block for block in page(chapter).blocks if block.title == title]
    assert found, f"{chapter} has no equation titled {title!r}"
    return sp.sympify(found[which].lines[-1][2])


def meant(chapter, title):
    """The same, with what its names stand for on the page."""
    return page(chapter)._meant(shown(chapter, title))


def said(chapter, title):
    """The theorem of this title on a chapter's page."""
    (found,) = [b.theorem for b in page(chapter).blocks if b.title == title]
    return found


def solved(relations, name):
    """What the equation of a symbol among these relations says that it is."""
    (found,) = [right for left, right in (r.terms for r in relations) if str(left) == name]
    return found


def decimals(chapter, title):
    """The numbers of all equations of this title, all printed digits, cut and not rounded."""
    found = [block for block in page(chapter).blocks if block.title == title]
    assert found, f"{chapter} has no numbers titled {title!r}"
    with mpmath.workdps(DIGITS):
        return [mpmath.mpf(n.removesuffix(r"\ldots")) for b in found for _, _, n in b.lines]


def settled(chapter, statement):
    """The derived form of a statement that a chapter settles, line by line."""
    return page(chapter).settled[statement].settlement.derived


def counterexample(chapter, statement):
    """The point at which a statement was shown to fail, by names."""
    settlement = page(chapter).settled[statement].settlement
    unless = settlement.judged.unless[0].values if settlement.judged else settlement.unless
    return {symbol.name: float(sp.N(number)) for symbol, number in unless.items()}


@cache
def _function(expr):
    names = sorted(expr.free_symbols, key=str)
    return [s.name for s in names], sp.lambdify(names, expr, "mpmath")


def value(expr, **at):
    """An expression with numbers in place of its symbols, to 60 digits less rounding."""
    names, function = _function(sp.sympify(expr))
    with mpmath.workdps(DIGITS):
        return function(*(mpmath.mpmathify(at[name]) for name in names))


def number(expr, **at):
    """The same, real, as a float."""
    found = mpmath.mpmathify(value(expr, **at))
    # a real value that goes through complex numbers: what rounding leaves of its imaginary part
    assert abs(mpmath.im(found)) <= 1e-30 * (1 + abs(found)), f"not real: {found}"
    return float(mpmath.re(found))


def altered(expr, by, kept=()):
    """The expression off by a factor, in one of its symbols, in one sign and in one function.

    Factors are 1 + by; zero becomes ``by``.  The sign is that of a term in the outermost sum, and
    symbols and terms with what is ``kept`` are left alone.
    """
    yield expr * (1 + sp.Float(by)) if expr else sp.Float(by)
    for symbol in sorted(expr.free_symbols, key=str):
        if symbol.name not in kept:
            yield expr.xreplace({symbol: symbol * (1 + sp.Float(by))})
    nodes = list(sp.preorder_traversal(expr))
    for node in [n for n in nodes if n.is_Add][:1]:
        for term in [t for t in node.args if not {s.name for s in t.free_symbols} & set(kept)][-1:]:
            yield expr.xreplace({node: node - 2 * term})
    for node in [n for n in nodes if isinstance(n, (sp.sin, sp.cos))][:1]:
        swapped = sp.cos if isinstance(node, sp.sin) else sp.sin
        yield expr.xreplace({node: swapped(*node.args)})


def only(agrees, *formulas, by=0.01, kept=()):
    """``agrees`` accepts these formulas, and no variant that is altered as above.

    ``kept`` are the names of symbols that are left alone, since the formula does not depend on
    them where it is looked at.
    """
    agrees(*formulas)
    for place, formula in enumerate(map(sp.sympify, formulas)):
        for mutant in altered(formula, by, kept):
            try:
                agrees(*formulas[:place], mutant, *formulas[place + 1 :])
            except (AssertionError, ZeroDivisionError):
                continue
            raise AssertionError(f"the oracle accepts {mutant} in place of {formula}")
