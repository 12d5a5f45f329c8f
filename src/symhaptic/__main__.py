"""``symhaptic`` and ``python -m symhaptic``: the command line, which may be left while it loads."""

from __future__ import annotations

import sys


def main() -> None:
    """What the command line does; interrupted in its imports, one line."""
    try:
        from symhaptic.cli.main import main as answered
    except KeyboardInterrupt:
        sys.stderr.write("symhaptic: interrupted\n")
        raise SystemExit(130) from None
    answered()


if __name__ == "__main__":
    main()
