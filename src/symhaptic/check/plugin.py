"""The fixture ``symhaptic_formula`` of pytest's; nothing else is loaded until a test asks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from symhaptic.scene.scene import Scene


class Agreement:
    """A formula that somebody's function is held against, by its id, of a scene or the paper."""

    def __init__(self, id: str, scene: Scene | None = None) -> None:
        from symhaptic.check.devices import known
        from symhaptic.notation.suggest import suggested

        formulas = known(scene)
        if id not in formulas:
            raise ValueError(f"id: {id!r} is not known; {suggested(id, formulas)}")
        self.checked = formulas[id]

    def agrees(
        self,
        function: Callable[..., Any],
        ulp: float = 8,
        over: Mapping[str, tuple[float, float]] | None = None,
        points: int | None = None,
    ) -> None:
        """Fail the test where the function is off by more than ``ulp`` units in the last place.

        ``over`` narrows the ranges of arguments: ``{"b": (0, 10)}``.
        """
        from symhaptic.check.callers import called
        from symhaptic.check.compare import compared
        from symhaptic.check.report import Report, text

        if points is not None and points < 1:
            raise ValueError(f"points: {points} is not positive; give 1 or more")
        for name, (low, high) in (over or {}).items():
            if name not in self.checked.arguments or not -inf < low <= high < inf:
                known = ", ".join(self.checked.arguments)
                raise ValueError(
                    f"over: {name!r}: ({low}, {high}) is no range; give (least, most) of {known}"
                )
        found = compared(self.checked, called(function), ulp, points, over)
        if not found.agrees:
            name = getattr(function, "__qualname__", repr(function))
            pytest.fail(text(Report(found, name, 0.0)), pytrace=False)


@pytest.fixture
def symhaptic_formula() -> type[Agreement]:
    """``symhaptic_formula("eq11").agrees(mine, ulp=4, over={"b": (0, 10)})``.

    With a scene: ``symhaptic_formula("is_stable", scene).agrees(mine, ulp=1e6)``.
    """
    return Agreement
