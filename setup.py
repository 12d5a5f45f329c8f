"""What pyproject.toml cannot say: the compiled kernels and loops, and the data that lies beside src/.

The extensions are optional: where no compiler is found the package is installed without them, and
everything runs on NumPy and on the kernels for arrays of any library.
"""

import shutil
from pathlib import Path

import numpy
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

HERE = Path(__file__).parent
KERNELS = "src/symhaptic/kernels"
LIBRARIES = "haptic", "haptic_single"  # each is included by the file that has its loops


RECORDS = ("ledger.json", "rocq.json", "mutants.json", "bench.json")
PAGES = ("CONTRIBUTING.md", "CHANGELOG.md")


class WithData(build_py):
    """Chapters, guides and records become part of the package; an editable install finds them."""

    def run(self):
        """Copy them beside the modules."""
        super().run()
        if not self.editable_mode:
            inside = Path(self.build_lib) / "symhaptic"
            for folder in ("derivations", "docs"):
                shutil.copytree(HERE / folder, inside / folder, dirs_exist_ok=True,
                                ignore=shutil.ignore_patterns("__pycache__"))  # fmt: skip
            for page in PAGES:
                shutil.copy(HERE / page, inside / page)
            (inside / "reports").mkdir(exist_ok=True)
            for record in RECORDS:
                shutil.copy(HERE / "reports" / record, inside / "reports" / record)


class Exact(build_ext):
    """Sums and products as they are written: no contraction where the processor has fma."""

    def build_extension(self, ext):
        """Compile with what the compiler calls that."""
        if self.compiler.compiler_type != "msvc":
            ext.extra_compile_args = ["-O2", "-ffp-contract=off", "-fno-math-errno"]
            ext.libraries = ["m"]
        super().build_extension(ext)


setup(
    cmdclass={"build_py": WithData, "build_ext": Exact},
    ext_modules=[
        Extension(
            "symhaptic.kernels._compiled",
            sources=[
                f"{KERNELS}/_compiled.c",
                *(f"{KERNELS}/{name}_loops.c" for name in LIBRARIES),
            ],
            depends=[f"{KERNELS}/{name}.{end}" for name in LIBRARIES for end in "ch"],
            include_dirs=[numpy.get_include()],
            optional=True,
        ),
        Extension("symhaptic.loops._count", ["src/symhaptic/loops/_count.c"], optional=True),
    ],
)
