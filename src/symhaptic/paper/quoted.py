"""A number as a text quotes it: about, below or above so much, with so many digits."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from typing import Literal


@dataclass(frozen=True)
class Quoted:
    """A quoted number; an exponent marks its last digit: ``10000`` to one digit is ``1e4``."""

    how: Literal["about", "below", "above"]
    digits: str

    @property
    def unit(self) -> Decimal:
        """One unit of the last printed digit.

        >>> str(Quoted("about", "0.41").unit), str(Quoted("about", "987e3").unit)
        ('0.01', '1E+3')
        """
        exponent = Decimal(self.digits).as_tuple().exponent
        return Decimal(1).scaleb(int(exponent))

    def changed(self) -> Iterator[Quoted]:
        """Every digit one up and one down: numbers that the text does not print.

        >>> [q.digits for q in Quoted("about", "0.41").changed()]
        ['0.51', '0.31', '0.42', '0.40']
        """
        number = Decimal(self.digits)
        digits, exponent = number.as_tuple().digits, int(number.as_tuple().exponent)
        for i in range(len(digits)):
            step = Decimal(1).scaleb(exponent + len(digits) - 1 - i)
            for other in (number + step, number - step):
                scaled = other.scaleb(-exponent)
                if exponent > 0:
                    yield Quoted(self.how, f"{int(scaled)}e{exponent}")
                else:
                    yield Quoted(self.how, f"{other:f}")
