PYTHON ?= python3
BIN := .venv/bin

# what Python has compiled is kept: a test that starts processes would compile the package in each
unexport PYTHONDONTWRITEBYTECODE

.PHONY: report certificates test ci check bounds mutation conditions mutants rocq bench clean

report: .venv/ready
	$(BIN)/symhaptic report

# the sums of products that lemmas rest on, searched for where none is kept
certificates: .venv/ready
	$(BIN)/python -m symhaptic.book.certificates

test: .venv/ready
	$(BIN)/ruff check
	$(BIN)/pytest $(SIDE_BY_SIDE)

# the same, and what no quick test sees: the wheel, mypy, a `verify` from nothing, all chapters
# typeset and the PDF, the text that is written for Rocq; the kernel's rules without one of their
# conditions; all changed statements
ci: .venv/ready
	$(BIN)/ruff check
	$(BIN)/pytest $(SIDE_BY_SIDE) -m 'not slow'
	$(MAKE) -j2 -O conditions mutants

# all tests, what takes longer by its nature among them: exports in every pair of a language, a scene,
# a delay and a precision, with sanitizers, as packages and for microcontrollers; errors at ten
# times as many points, and with musl; all that Rocq has checked; the whole site, and in a browser;
# what JAX has to compile; the array kernels behind public functions; random identities
check: .venv/ready
	$(BIN)/ruff check
	SYMHAPTIC_SOUNDNESS=$(SOUNDNESS) $(BIN)/pytest -n 2 --dist worksteal --durations 12 -m 'slow or not slow'
	SYMHAPTIC_KERNELS=array $(BIN)/pytest -n 2 tests/numeric tests/test_hard_cases.py
	$(MAKE) -j2 -O conditions mutants
	$(MAKE) bounds mutation

# the oldest and the newest versions of all dependencies that pyproject.toml allows
bounds:
	PYTHON=$(PYTHON) .ci/bounds

# what differs from the branch main, changed in one place at a time: its quick tests have to notice
mutation: .venv/ready
	$(BIN)/python .ci/mutation --since $(SINCE)

conditions: .venv/ready
	$(BIN)/pytest -s -p soundness.unconditional $(ATTACKS)

mutants: .venv/ready
	$(BIN)/symhaptic mutants --check

# files as a whole, and all that look at chapters in one process, see tests/conftest.py
SIDE_BY_SIDE := -n 2 --dist loadfile --no-loadscope-reorder --durations 12

# what is attacked once more with each condition of a rule left out, which one attack has to notice
ATTACKS := $(patsubst %,tests/soundness/test_%.py,kernel captured_names inert_terms \
	internal_names leaves leaves_right judge chapters) $(wildcard tests/soundness/test_rules_*.py) \
	$(wildcard tests/soundness/test_axiom*.py)

SINCE ?= main

# how many random identities `prove` is held to; a tenth as many boxes are
SOUNDNESS ?= 100000

# has Rocq check every chapter whose text has changed, as far as the record has it; status 1 tells
# that the record was another
rocq: .venv/ready
	$(BIN)/symhaptic verify --rocq .rocq --as-recorded --format json -o reports/rocq.json || test $$? = 1

bench: .venv/ready
	$(BIN)/pytest benchmarks --benchmark-only

.venv/ready: pyproject.toml setup.py constraints.txt $(wildcard src/symhaptic/*/*.[ch] src/symhaptic/*/*.cpp)
	test -x $(BIN)/python || $(PYTHON) -m venv .venv  # another Python over it would mix both
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[test]'
	touch $@

clean:
	rm -rf .venv .rocq build src/*.egg-info src/symhaptic/*/*.so .bounds .mutation reports/figures reports/*.pdf
