"""``python -m symhaptic`` is the command line."""

from symhaptic.cli import main

if __name__ == "__main__":
    main()
