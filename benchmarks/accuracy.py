"""How far exported C is off, in units in the last place, beside exact values in ball arithmetic.

python benchmarks/accuracy.py [OPTIONS] [POINTS] [SEED] [double|single] [FUNCTION ...]

--derivatives  of the functions with all derivatives that there are
--around       and around the worst points, and around the worst of these
--musl         with musl's mathematical functions (Debian: musl-tools), not those of this machine
"""

import sys

from symhaptic.balls.exact import EXACT
from symhaptic.bench.error import climb, measure
from symhaptic.bench.exported import GCC, MUSL
from symhaptic.export import request
from symhaptic.export.precision import PRECISIONS
from symhaptic.forms.derivatives import differentiable, with_derivatives


def main():
    numbers = [int(word) for word in sys.argv[1:] if word.isdigit()]
    count, seed = [*numbers, *(100_000, 1)[len(numbers) :]]
    words = [word for word in sys.argv[1:] if not word.isdigit() and not word.startswith("--")]
    asked = [PRECISIONS[word] for word in words if word in PRECISIONS] or list(PRECISIONS.values())
    names = [word for word in words if word not in PRECISIONS]
    search = climb if "--around" in sys.argv else measure
    compiler = MUSL if "--musl" in sys.argv else GCC
    for precision in asked:
        for form in request.chosen(names or list(EXACT)):
            if "--derivatives" in sys.argv:
                form = with_derivatives(form, differentiable(form))
            found = search(form, count, seed, precision, compiler)
            for name, (error, point) in found.items():
                print(f"{precision.name} {form.name:26} {name:7} {error:7.2f}  at {point}",
                      flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
