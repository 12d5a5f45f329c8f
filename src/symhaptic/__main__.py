"""``python -m symhaptic`` is the command line."""

from symhaptic.cli.main import main

if __name__ == "__main__":
    main()
