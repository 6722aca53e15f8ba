# Two commands: `make` sets up, generates, verifies and runs the main job; `make test` tests.

PYTHON3 ?= python3
VENV    := .venv
PYTHON  := $(VENV)/bin/python
PIP     := PYTHONWARNINGS=ignore $(PYTHON) -m pip --quiet --disable-pip-version-check
SOURCES := $(wildcard generated/gufunc/*.c generated/gufunc/*.h) generated/c/coscrew.h

.PHONY: all generate check build example test bench clean

all: example

# The environment.  Its first install finds generated/ as committed, so coscrew itself is there to
# be regenerated from, and its extension module is built.
$(VENV)/ready: pyproject.toml
	$(PYTHON3) -m venv $(VENV)
	$(PIP) install --upgrade pip "setuptools>=77" wheel
	$(PIP) install "numpy>=2.0"
	$(PIP) install --no-build-isolation --editable ".[codegen]"
	touch $@ $(VENV)/built

generate: $(VENV)/ready
	$(PYTHON) -m coscrew_codegen generate

check: generate
	$(PYTHON) -m coscrew_codegen generate --check

# Built again only if generating changed its sources; without a C compiler, pure NumPy it is.
build: check
	@$(MAKE) --no-print-directory $(VENV)/built
	@$(PYTHON) -c "import coscrew, sys; coscrew.COMPILED or print('no working C compiler: coscrew \
	runs in pure NumPy (gcc or clang and the headers of Python compile it)', file=sys.stderr)"

$(VENV)/built: $(SOURCES) codegen/build.py
	$(PIP) install --no-build-isolation --no-deps --editable .
	touch $@

# The main job: static joint torques of a Panda arm with a payload, in C and Python.
example: build
	@mkdir -p build
	@if $(CC) -std=c11 -O2 -ffp-contract=off -I generated/c/include examples/static_torques.c \
	    -o build/static_torques -lm 2>build/static_torques.log; then \
	  $(PYTHON) examples/static_torques.py build/static_torques; \
	else \
	  echo "no C program ($(CC): see build/static_torques.log): Python alone" >&2; \
	  $(PYTHON) examples/static_torques.py; \
	fi

$(VENV)/test-ready: $(VENV)/ready
	$(PIP) install --no-build-isolation --editable ".[test]"
	touch $@

test: $(VENV)/test-ready build
	$(PYTHON) -m pytest

bench: $(VENV)/test-ready build
	$(PYTHON) -m tests.benchmarks

clean:
	rm -rf $(VENV) build *.egg-info
