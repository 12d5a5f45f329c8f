"""All targets by name; a new language is a module beside these and one line here."""

from __future__ import annotations

from symhaptic.export import array_api, c, cpp, fortran, javascript, octave, rust
from symhaptic.export.target import Target

TARGETS: dict[str, Target] = {
    module.TARGET.name: module.TARGET
    for module in (array_api, c, cpp, fortran, rust, javascript, octave)
}
