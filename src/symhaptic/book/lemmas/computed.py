"""What a statement on a computed form says, and its theorem: its pairs, block by block."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_forms import Later
from symhaptic.book.page import Page
from symhaptic.forms.entire import Entire
from symhaptic.notation import function


def statement(form: str) -> str:
    """The id of the statement on a form.

    >>> statement("is_stable")
    'computed-is-stable'
    """
    return f"computed-{form.replace('_', '-')}"


def settle(page: Page, form: str, blocks: Sequence[Later], says: str) -> None:
    """State on a page that what a form computes is what is derived, and settle it.

    The claim is that of all the blocks that are the form's own.
    """
    page.state(statement(form), says, claim=both(later.block.says() for later in blocks))
    shown = [later.derive() for later in blocks]
    whole = shown[0] if len(shown) == 1 else conj(*shown)
    page.settle(
        statement(form), whole, example=None if len(shown) > 1 else blocks[0].block.example()
    )


def upright(computed: Expr) -> Expr:
    """A computed formula with unknown functions, named as its entire ones, for a page to define.

    >>> from symhaptic.forms.entire import Sinc
    >>> from symhaptic.notation import psi
    >>> print(upright(2 * Sinc(psi)))
    2*\\mathrm{Sinc}(psi)
    """
    named = {
        e: function(rf"\mathrm{{{type(e).__name__}}}")(*e.args) for e in computed.atoms(Entire)
    }
    return computed.xreplace(named)
