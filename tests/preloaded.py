"""What commands import and do once in a process: `command.py` forks from where it is done."""

import concurrent.futures.process  # noqa: F401
import gc
import io
from contextlib import redirect_stdout

import array_api_compat.numpy  # noqa: F401
import jinja2  # noqa: F401
import typer
from matplotlib.figure import Figure

import symhaptic.book.figures
import symhaptic.book.listing
import symhaptic.book.parallel
import symhaptic.book.parts
import symhaptic.book.report.printed
import symhaptic.bounds.walls
import symhaptic.check.callers
import symhaptic.check.checked
import symhaptic.check.compare
import symhaptic.check.formulas
import symhaptic.check.report
import symhaptic.numeric.tracing.output
import symhaptic.scene.device_file
import symhaptic.scene.picture
import symhaptic.scene.scene  # noqa: F401
from symhaptic.cli.main import app

with redirect_stdout(io.StringIO()):  # what the parser imports, it imports when it is used
    typer.main.get_command(app).main(["--version"], standalone_mode=False)
figure = Figure(layout="constrained")
figure.add_subplot(title=r"$\alpha$", xlabel="x").plot([0, 1], label="$x^2$")
figure.legend()
for kind in ("svg", "png", "pdf"):  # fonts
    figure.savefig(io.BytesIO(), format=kind)
gc.freeze()  # what is forked does not look through this
