# Two commands: `make` sets up, derives and generates all, and runs the main job; `make test` tests.

PYTHON3 ?= python3
VENV    := .venv
PYTHON  := $(VENV)/bin/python
PIP     := PYTHONWARNINGS=ignore $(PYTHON) -m pip --quiet --disable-pip-version-check
INSTALL := $(PIP) install --no-compile
SOURCES := $(wildcard $(addprefix generated/,gufunc/*.[ch] gufunc/*/*.[ch] c/include/ksl/*.h))

# Packages bring thousands of modules.  Those that are imported are compiled then, once.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: all generate check build example scene test test-quick bench attack cuda report figure docs web clean

# Derives everything, so that nothing is left to check, whatever the cache holds.
all: $(VENV)/ready
	$(PYTHON) -m coscrew_codegen generate --anew
	@$(MAKE) --no-print-directory example scene

# The environment.  Its first install uses generated/ as committed, so the generator can import
# coscrew; `build` compiles its extension modules.
$(VENV)/ready: pyproject.toml hatch_build.py
	$(PYTHON3) -m venv $(VENV)
	$(INSTALL) --upgrade pip "hatchling>=1.27" "setuptools>=77" "numpy>=2.0"
	COSCREW_COMPILE=later $(INSTALL) --no-build-isolation --editable ".[simulate]"
	touch $@

generate: $(VENV)/ready
	$(PYTHON) -m coscrew_codegen generate

check: $(VENV)/ready
	$(PYTHON) -m coscrew_codegen generate --check

# Compiled again only if its sources changed; without a C compiler coscrew runs in pure NumPy.
build: $(VENV)/ready
	@$(MAKE) --no-print-directory $(VENV)/built
	@$(COMPILED) || echo "no working C compiler: coscrew runs in pure NumPy (gcc or clang, and the \
	headers of Python, compile it)" >&2

COMPILE = PYTHONPATH=codegen $(PYTHON) -m coscrew_codegen.runtime.build

COMPILED = $(PYTHON) -c "from pathlib import Path; from coscrew_codegen.runtime.build import compiled; \
    raise SystemExit(not compiled(Path()))"

$(VENV)/built: $(SOURCES) codegen/coscrew_codegen/runtime/build.py
	$(COMPILE)
	@$(COMPILED) && touch $@ || true

# The main job: static joint torques of a Panda arm with a payload, in C and Python.
example: build
	@mkdir -p build
	@if $(CC) -O2 -I generated/c/include examples/static_torques.c \
	    -o build/static_torques -lm 2>build/static_torques.log; then \
	  $(PYTHON) examples/static_torques.py build/static_torques; \
	else \
	  echo "no C program ($(CC): see build/static_torques.log): Python only" >&2; \
	  $(PYTHON) examples/static_torques.py; \
	fi

# An arm with friction, motors and a payload: generated, simulated, and checked against results
# of Pinocchio; build/arm6/ holds its C and Python, build/arm6.html plays it back.
scene: build
	@mkdir -p build
	$(PYTHON) -m coscrew_codegen generate examples/scenes/arm6.toml -o build/arm6
	$(PYTHON) -m coscrew_codegen simulate examples/scenes/arm6.toml --view build/arm6.html \
	    --output build/arm6.csv >build/arm6.txt
	$(PYTHON) -m coscrew_codegen check examples/scenes/arm6.toml

# The packages that the tests need in addition.
$(VENV)/test-ready: $(VENV)/ready
	$(INSTALL) "coscrew[test]"
	touch $@

# First the compilers, emulators and browser that tests run: installed, or named, before anything
# else happens.  Then the extension modules are compiled while packages come.  The tests use
# generated/ as it is; that it is up to date is the first of test_generate.py.
test:
	@PYTHON3="$(PYTHON3)" sh tests/install_tools.sh
	@$(MAKE) --no-print-directory $(VENV)/ready
	@$(MAKE) --no-print-directory -j2 build $(VENV)/test-ready
	$(PYTHON) -m pytest -n auto --dist loadfile --no-loadscope-reorder

# For the working day, in a minute: without slow tests, and with samples of large ones.
test-quick: $(VENV)/test-ready build
	$(PYTHON) -m pytest -n auto --dist loadfile --no-loadscope-reorder --quick

# Rivals that only benchmarks need; the table says which of them are missing.
$(VENV)/peers-ready: $(VENV)/test-ready
	@$(INSTALL) "coscrew[peers]" && touch $@ || echo "not every rival can be installed" >&2

# Ends with a table of the bars of performance, also in build/benchmarks.md; some of them:
# .venv/bin/python -m tests.benchmarks many_states dynamics
bench: $(VENV)/peers-ready build
	$(PYTHON) -m tests.benchmarks

# Compares every proven error bound with exact arithmetic, at length, elementary functions with the
# C library's in long double, in single precision on all 2^32 arguments, certified bounds of scenes
# with numbers of 113 bits, and verdicts on motions with motions that share nothing with
# coscrew: more than an hour.
attack: $(VENV)/test-ready build
	$(PYTHON) -m tests.long_attack
	$(PYTHON) -m tests.elementary_attack
	$(PYTHON) -m tests.robots_attack
	$(PYTHON) -m tests.signs_attack
	$(PYTHON) -m tests.certified_attack
	$(PYTHON) -m tests.functions_attack
	$(PYTHON) -m tests.lanes_attack
	$(PYTHON) -m tests.fixed_attack
	$(PYTHON) -m tests.many_attack
	$(PYTHON) -m tests.hard_cases.near_zeros --judge --seed 2
	$(PYTHON) -m tests.motions_attack

# Kernels for CUDA, compiled by nvcc (else from PyPI: 125 MB, 320 MB on disk), and arrays, on a GPU if there is one.
cuda: $(VENV)/test-ready build
	command -v nvcc >/dev/null || $(INSTALL) "coscrew[cuda]"
	$(PYTHON) -m tests.cuda_attack
	$(PYTHON) -m tests.devices_attack

# Errors and times of everything on this machine, in about two minutes: build/report/.
report: $(VENV)/test-ready build
	$(PYTHON) -m coscrew_codegen report --hard-cases tests/hard_cases

# The README's figure of the cost of accuracy for a Panda, in a minute; it shows times, so the
# machine should be idle.
figure: $(VENV)/test-ready build
	$(PYTHON) -m tests.benchmarks.published_bounds --function inverse_dynamics \
	    --plot examples/cost/panda.svg

# The figure of docs/bounds.md, of bounds beside errors.
calibration: $(VENV)/test-ready build
	$(PYTHON) -m tests.benchmarks.certified_scenes --robot ur5 panda --calibration \
	    --plot examples/bounds/calibration.svg

# README, docs/ and generated/docs/ as pages in build/docs, without network access; warnings, such as
# for broken links, are errors.
$(VENV)/docs-ready: $(VENV)/ready
	$(INSTALL) "coscrew[docs]"
	touch $@

docs: $(VENV)/docs-ready
	$(PYTHON) -m sphinx -q -W --keep-going -c docs . build/docs
	@echo "build/docs/docs/index.html"

# The player of the playback page, from its sources in web/: needs Node and network access.
web:
	cd web && npm ci --silent && node build.mjs

clean:
	rm -rf $(VENV) build *.egg-info
