"""Run the paper's chapters and keep the certificates that they asked for, and no others.

python -m symhaptic.book.certificates
"""

from __future__ import annotations

import json
from pathlib import Path

from symhaptic.book import lemmas
from symhaptic.book.chapters import run, shipped
from symhaptic.proof.theorems.positivity import USED

FILE = Path(lemmas.__path__[0]) / "certificates.json"


def kept() -> str:
    """Return the certificates of all chapters, a line each."""
    for path in shipped():
        run(path)
    return json.dumps(USED, sort_keys=True, indent=0) + "\n"


if __name__ == "__main__":
    FILE.write_text(kept(), encoding="utf-8")
