"""What a target is beside its language: the files of an export, and what runs its self-test."""

from __future__ import annotations

import sympy as sp

from symhaptic.export.module import Library
from symhaptic.export.printing import Language
from symhaptic.export.rounding import Goal
from symhaptic.export.routine import Routine


class Target(Language):
    """A language with all that is written in it, and around it."""

    def table(self, library: Library) -> str:
        """1/n! from n = 0 on, as far as a library needs them; nothing if it needs none."""
        printer = self.printing()
        return ", ".join(printer.doprint(1 / sp.factorial(n)) for n in range(library.factorials))

    def source(self, library: Library) -> dict[str, str]:
        """The files that somebody else's program uses, by name."""
        raise NotImplementedError

    def proved(self, routine: Routine) -> list[Goal]:
        """What is proved of the rounding errors of a public routine."""
        return []

    def package(self, library: Library) -> dict[str, str]:
        """What those who use the language find a library with, and examples."""
        return {}

    def selftest(self, library: Library) -> dict[str, str]:
        """A program that reads vectors.txt and exits with 1 where a value is missed."""
        raise NotImplementedError

    def commands(self, name: str) -> list[list[str]]:
        """What compiles and runs the self-test, in the folder that was written."""
        raise NotImplementedError

    def usage(self, library: Library) -> str:
        """A line or two of source that call the first function."""
        raise NotImplementedError

    def notes(self, library: Library) -> list[str]:
        """Lines of the README on what is special in this language."""
        return []
