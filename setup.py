"""What pyproject.toml cannot say: what is compiled, and the data that lies beside src/.

The extensions are optional: where no compiler is found the package is installed without them, and
everything runs on NumPy and on the kernels for arrays of any library.
"""

import re
import shutil
from pathlib import Path

import numpy
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

HERE = Path(__file__).parent
KERNELS = "src/symhaptic/kernels"
HEADERS = "table.h", "filter.h", "ordinary.h"
SOURCES = "ufuncs.cpp", "filter.cpp", "delay.cpp", "ordinary.cpp", "haptic.c", "haptic_single.c"


RECORDS = ("ledger.json", "rocq.json", "mutants.json", "bench.json")
PAGES = ("CONTRIBUTING.md", "CHANGELOG.md")
LINK = re.compile(r"(!?)\[([^\]]*)\]\((?!https?:)([^)]*)\)")


def described() -> str:
    """Return the README as an index shows it, where no file lies beside it: names, not links."""
    text = (HERE / "README.md").read_text(encoding="utf-8")
    return LINK.sub(lambda link: "" if link[1] else f"{link[2]} (`{link[3]}`)", text)


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
        """Compile with what the compiler calls that, and the ufuncs as C++17."""
        compile_ = self.compiler._compile

        def compiled(obj, source, *rest):
            *others, flags, macros = rest
            more = ["-std=c++17"] * source.endswith(".cpp")
            compile_(obj, source, *others, [*flags, *more], macros)

        if self.compiler.compiler_type == "msvc":
            ext.extra_compile_args = ["/std:c++17"]
        else:
            self.compiler._compile = compiled
            ext.extra_compile_args = ["-O2", "-ffp-contract=off", "-fno-math-errno",
                                      "-fvisibility=hidden"]  # fmt: skip
            ext.libraries = ["m"]
        super().build_extension(ext)


setup(
    long_description=described(),
    long_description_content_type="text/markdown",
    cmdclass={"build_py": WithData, "build_ext": Exact},
    ext_modules=[
        Extension(
            "symhaptic.kernels._compiled",
            sources=[f"{KERNELS}/{name}" for name in SOURCES],
            depends=[f"{KERNELS}/{name}" for name in ("haptic.c", *HEADERS)],
            include_dirs=[numpy.get_include()],
            optional=True,
        ),
        Extension("symhaptic.loops._count", ["src/symhaptic/loops/_count.c"], optional=True),
    ],
)
