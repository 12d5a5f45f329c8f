"""A routine with what it calls written out in it, as steps of names and expressions alone."""

from dataclasses import replace

import sympy as sp
from sympy.core.function import AppliedUndef

from symhaptic.export.library import named
from symhaptic.export.routine import Repeat, Several, fresh, with_divisors


def inlined(routine, routines, kept=lambda _: False):
    """The same steps as one list; calls of routines whose names are ``kept`` stay."""
    taken = {s.name for s in routine.arguments}
    done = []

    def own(call):
        return isinstance(call, AppliedUndef) and not kept(type(call).__name__)

    def written(found, arguments):
        """All results of a routine at these arguments."""
        found = with_divisors(found, lambda divisor: divisor.anywhere)
        known = dict(zip(found.arguments, arguments, strict=True))

        def step(symbol, expr):
            known[symbol] = fresh(symbol.name, taken)
            done.append((known[symbol], called(sp.sympify(expr).xreplace(known))))

        for made in found.steps:
            if isinstance(made, Several):
                call = made.call.func(*(called(a.xreplace(known)) for a in made.call.args))
                values = results(call)
                for symbol, value in zip(made.names, values, strict=True):
                    known[symbol] = fresh(symbol.name, taken)
                    done.append((known[symbol], value))
            elif isinstance(made, Repeat):
                assert made.numbers, "a search is not written out"
                for state, start in zip(made.states, made.start, strict=True):
                    step(state, start)
                for number in made.numbers:
                    known[made.number] = number
                    for symbol, expr in made.steps:
                        step(symbol, expr)
                    known |= {s: known[n] for s, n in made.turned}
            else:
                step(*made)
        return [called(expr.xreplace(known)) for _, expr in found.results]

    def results(call):
        return written(named(type(call).__name__, routines), call.args)

    def called(expr):
        """With every such call replaced by what it gives."""
        while inner := [c for c in expr.atoms(AppliedUndef) if own(c)]:
            first = min(inner, key=sp.count_ops)
            name = fresh("given", taken)
            (value,) = results(first)
            done.append((name, value))
            expr = expr.xreplace({first: name})
        return expr

    found = written(routine, routine.arguments)
    names = [name for name, _ in routine.results]
    return replace(routine, steps=tuple(done), results=tuple(zip(names, found, strict=True)))


def program(routine, modules):
    """The list of its results as a function of its arguments, all of its steps in one piece."""
    results = [expr for _, expr in routine.results]
    return sp.lambdify(
        routine.arguments, results, modules, cse=lambda found: (list(routine.steps), found)
    )
