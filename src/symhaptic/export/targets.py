"""All targets by name; a new language is a module beside these and one line here."""

from __future__ import annotations

from symhaptic.export import arrays, c, cpp, fortran, javascript, microcontroller, octave, rust
from symhaptic.export.language import Target

TARGETS: dict[str, Target] = {
    module.TARGET.name: module.TARGET
    for module in (arrays, c, cpp, fortran, rust, javascript, octave, microcontroller)
}
