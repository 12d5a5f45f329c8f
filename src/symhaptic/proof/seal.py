"""What may count as proved is made by the package only, not by hand."""

from __future__ import annotations

from typing import NoReturn

KEY = object()
"""Handed on by the rules and checkers of the package to what they make."""


class NotMade(TypeError):
    """Something made by hand that only a rule or a checker may make."""


class Sealed:
    """A record that needs the key to be made; it cannot be copied, replaced or sent elsewhere.

    A dataclass derives from it, with a field ``key: InitVar[object]``.
    """

    def __post_init__(self, key: object) -> None:
        if key is not KEY:
            name = type(self).__name__
            raise NotMade(f"a {name} is not made by hand; a rule or a step of the page returns it")

    def __reduce_ex__(self, protocol: object) -> NoReturn:
        raise NotMade(f"a {type(self).__name__} is not copied or pickled; make it where it is used")
