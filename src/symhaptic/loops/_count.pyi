from numpy import float64
from numpy.typing import NDArray

Rows = NDArray[float64]

def roots_inside(A: Rows, a: int, W: Rows, w: int, M: Rows, inside: Rows, near: Rows) -> None: ...
