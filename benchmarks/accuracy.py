"""How far exported C is off, in units in the last place, beside exact values in ball arithmetic.

python benchmarks/accuracy.py [--derivatives] [POINTS] [FUNCTION ...]
"""

import sys

from symhaptic.bench.error import measure
from symhaptic.bench.exact import EXACT
from symhaptic.export import request
from symhaptic.model.derivatives import with_derivatives


def main():
    words = [word for word in sys.argv[1:] if word != "--derivatives"]
    count = int(words[0]) if words else 100_000
    for form in request.chosen(words[1:] or list(EXACT)):
        if "--derivatives" in sys.argv:
            form = with_derivatives(form, tuple(s.name for s in form.arguments))
        for name, (error, point) in measure(form, count).items():
            print(f"{form.name:26} {name:16} {error:7.2f}  at {point}", flush=True)


if __name__ == "__main__":
    main()
