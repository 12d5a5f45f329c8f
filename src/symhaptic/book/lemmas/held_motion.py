"""Motion under a held force obeys the equations of the device, and what two samples make of it."""

from typing import Any

from sympy import Expr, Matrix, S

from symhaptic.book.lemmas.circulation import damped_contact, outside
from symhaptic.book.page import Page
from symhaptic.loops.plant import Plant
from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, k, m, t
from symhaptic.paper.reading import read

RIGHT = r"K < \frac{2B(2m-BT)}{T(2m+BT)}"
"""The limit of a free mass without delay, with the difference of two samples."""


def show_motion(
    page: Page, device: Plant, motions: tuple[Matrix, Matrix], letters: str, obeys: str
) -> None:
    """Print that Phi(t) and Gamma(t) solve the equations of a device with states ``letters``."""
    rate, push = Matrix(device.state), Matrix(device.force)
    for name, motion, force in zip((r"\Phi", r"\Gamma"), motions, (0, 1), strict=True):
        for row, letter in enumerate(letters):
            for column in range(motion.cols):
                page.step(
                    f"$\\{name[1:]}$ {obeys}",
                    motion[row, column].diff(t),
                    (rate * motion)[row, column] + force * push[row],
                    name=rf"\dot{name}_{{{letter}{column + 1}}}",
                )


def of_two_samples() -> Expr:
    """The largest stiffness of that limit."""
    [right] = read(RIGHT)
    return right.rhs


def settle_by_two_samples(page: Page, id: str, note: str) -> None:
    """Correct a rule of loops that know the velocity: with a difference the limit is lower."""
    [right] = read(RIGHT)
    wall: dict[Any, Any] = {K: S.One, B: S.One, T: S.One, m: S.One, b: S.Zero, k: S.Zero, d: S.Zero}
    driven = {alpha: S.One, beta: S.One, gamma: S.Zero, delta: S.Zero, d: S.Zero}
    page.lemma("The wall $K=B=1$ of $m=T=1$ has a root outside the circle", outside(driven))
    page.settle(
        id,
        damped_contact(right),
        corrected=[RIGHT],
        misprint=False,
        example=wall | {K: S.Half},
        unless=[(wall, outside(driven))],
        shows="$m=T=B=1$: $K=1$ is half of what is allowed, and the limit is $\\tfrac23$",
        note=note,
    )
