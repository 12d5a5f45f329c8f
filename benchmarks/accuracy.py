"""How far exported C is off, in units in the last place, beside exact values in ball arithmetic.

python benchmarks/accuracy.py [POINTS] [FUNCTION ...]
"""

import sys

from symhaptic.bench.error import measure
from symhaptic.bench.exact import EXACT
from symhaptic.export import request


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    for form in request.chosen(sys.argv[2:] or list(EXACT)):
        for name, (error, point) in measure(form, count).items():
            print(f"{form.name:26} {name:7} {error:7.2f}  at {point}", flush=True)


if __name__ == "__main__":
    main()
