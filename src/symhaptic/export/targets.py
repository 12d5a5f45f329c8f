"""All targets by name; a new language is a module beside these and one line here."""

from __future__ import annotations

from functools import cache

from symhaptic.export import arrays, c, cpp, fortran, javascript, microcontroller, octave, rust
from symhaptic.export.language import Target
from symhaptic.export.library import known
from symhaptic.export.routine import code_name

TARGETS: dict[str, Target] = {
    module.TARGET.name: module.TARGET
    for module in (arrays, c, cpp, fortran, rust, javascript, octave, microcontroller)
}


@cache
def _taken() -> frozenset[str]:
    return frozenset(map(code_name, known()))


for _target in TARGETS.values():
    _target.taken = _taken
