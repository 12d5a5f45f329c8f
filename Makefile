PYTHON ?= python3
BIN := .venv/bin

.PHONY: report test bench clean

report: .venv/ready
	$(BIN)/symhaptic report

test: .venv/ready
	$(BIN)/ruff check
	$(BIN)/mypy
	$(BIN)/symhaptic verify --strict
	$(BIN)/pytest -n 2 --dist worksteal --durations 12

bench: .venv/ready
	$(BIN)/pytest benchmarks --benchmark-only

.venv/ready: pyproject.toml constraints.txt
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[test]'
	touch $@

clean:
	rm -rf .venv reports/figures reports/*.pdf
