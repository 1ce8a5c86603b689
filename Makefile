# The same commands for people and CI. Each first creates its environment in .venv; system packages stay unchanged.
# On Windows, or without make: see "Without make" in CONTRIBUTING.md.

PYTHON ?= python3
VENV ?= .venv
WORKERS ?= 2
CONSTRAINTS ?= constraints.txt
ARGS ?=
PROGRAMS ?=
MINUTES ?= 10

BIN := $(VENV)/bin
RUNTIME := $(VENV)/.runtime
STAMP := $(VENV)/.installed
SITE := $(VENV)/.site
PIP := $(BIN)/python -m pip install --disable-pip-version-check -c $(CONSTRAINTS)

.DEFAULT_GOAL := help
.PHONY: help install site demo programs learning backlash sweep-demo test check lint types imports size doctests page-check page docs package bench fuzz clean

help:
	@echo "make demo     run the demonstration; results in results/demo"
	@echo "make test     run the tests; make test ARGS=\"--slow\" runs the slow ones too"
	@echo "              (in WORKERS=2 processes; WORKERS=0 for one that a debugger can enter)"
	@echo "make check    ruff, mypy --strict, import contracts, examples in docstrings, documents"
	@echo "make page     build the viewer of reports from page/ (needs Node and npm)"
	@echo "make docs     check the documents, run the examples, build the site: docs/_build/html/index.html"
	@echo "make package  build wheel and source archive in dist; try the wheel in an environment of its own"
	@echo "make fuzz     look for wrong answers and crashes on random inputs; make fuzz MINUTES=10"
	@echo "make bench    measure the speed of the engine on this machine"
	@echo "make programs run every part program of a folder; make programs PROGRAMS=my/folder"
	@echo "make learning measure cost and benefit of learning and cross-coupling; reports in results/learning"
	@echo "make sweep-demo  ask which of 10,000 machines of a series will make the part; writes results/sweep-demo/report.html"
	@echo "make backlash measure the cost of backlash in the loop, and all schemes on real parts"
	@echo "make install  only make $(VENV); with another Python: make install PYTHON=python3.12"
	@echo "make clean    remove $(VENV) and all generated files"

# Rebuilt only when the package lists change: first the packages of the demonstration, then those of tests and extras.
$(RUNTIME): pyproject.toml $(CONSTRAINTS)
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { \
	  echo "contourlab needs Python 3.11 to 3.14; '$(PYTHON)' is: $$($(PYTHON) --version 2>&1 || true)" >&2; \
	  echo "Install one and name it: make PYTHON=python3.11 $(MAKECMDGOALS)" >&2; exit 1; }
	@$(BIN)/python -m pip --version >/dev/null 2>&1 || $(PYTHON) -m venv --clear $(VENV) || { \
	  rm -rf $(VENV); \
	  echo "'$(PYTHON) -m venv' failed; on Debian and Ubuntu it needs: apt-get install python3-venv" >&2; exit 1; }
	@echo "installing contourlab into $(VENV) (a minute or two, once)"
	@$(PIP) -e .
	@$(BIN)/python -m contourlab.app.precompile
	@touch $@

$(STAMP): $(RUNTIME)
	@echo "installing extras and tools for tests into $(VENV) (a minute, once)"
	@$(PIP) -e ".[dev]"
	@touch $@

$(SITE): $(RUNTIME)
	@echo "installing the tools of the site into $(VENV) (half a minute, once)"
	@$(PIP) -e ".[docs]"
	@touch $@

install: $(STAMP)

site: $(SITE)

demo: $(RUNTIME)
	$(BIN)/contourlab demo $(ARGS)

test: $(STAMP)
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal $(ARGS)

check: lint types imports size doctests page-check docs

lint: $(STAMP)
	$(BIN)/ruff check .

types: $(STAMP)
	$(BIN)/mypy

imports: $(STAMP)
	$(BIN)/lint-imports

size: $(STAMP)
	$(BIN)/python tools/size.py --check

doctests: $(STAMP)
	$(BIN)/python -m pytest --doctest-modules src/contourlab --quiet

page/node_modules/.installed: page/package.json page/package-lock.json
	cd page && npm ci --silent
	@touch $@

page: $(STAMP) page/node_modules/.installed
	$(BIN)/python tools/page_contract.py
	cd page && npm run --silent build

# Build the viewer again and compare it with the one that is committed.
page-check:
	@command -v npm >/dev/null || { echo "no npm: the viewer's bundle is not compared"; exit 0; }; \
	  $(MAKE) --no-print-directory page/node_modules/.installed && cd page && npm run --silent build -- built && \
	  for file in built/*; do cmp $$file ../src/contourlab/rendering/viewer/$${file#built/} || { \
	    echo "the viewer is not the one that page/ builds: make page" >&2; exit 1; }; done

# -E reads every page again, so that a second run repeats the warnings of the first.
docs: $(SITE)
	$(BIN)/python docs/check.py
	$(BIN)/python -m sphinx -E -W --keep-going --nitpicky --quiet docs docs/_build/html
	$(BIN)/python docs/check_site.py

package: $(STAMP)
	$(BIN)/python tools/package.py

fuzz: $(STAMP)
	$(BIN)/python tools/fuzz --minutes $(MINUTES) $(ARGS)

bench: $(STAMP)
	$(BIN)/python benchmarks/run.py $(ARGS)

programs: $(STAMP)
	$(BIN)/python benchmarks/programs.py $(PROGRAMS) $(ARGS)

learning: $(STAMP)
	$(BIN)/python benchmarks/learning.py $(ARGS)

# A second call continues where the first one was stopped.
sweep-demo: $(STAMP)
	$(BIN)/contourlab sweep examples/sweep-production-line.toml --out results/sweep-demo --resume $(ARGS)
	$(BIN)/contourlab sweep report results/sweep-demo

backlash: $(STAMP)
	$(BIN)/python benchmarks/backlash.py $(ARGS)

clean:
	rm -rf $(VENV) src/contourlab/native/kept results benchmarks/out build dist .mypy_cache .ruff_cache .pytest_cache .import_linter_cache .hypothesis page/node_modules page/built
	cd docs && rm -rf _build examples reference/api $(addsuffix .md,$(addprefix reference/,api commands components findings json) \
	  $(addprefix development/,benchmarks changelog contributing))
	find src tests benchmarks docs -name __pycache__ -type d -prune -exec rm -rf {} +
