# `make help` lists the targets. Set-up happens once, in .venv, from requirements.lock.
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
# One target after the other, also with -j: the tests read the book that `make book` writes.
.NOTPARALLEL:
# Packages from elsewhere, as a sourced ROS 2 brings them, are not those of the lock.
unexport PYTHONPATH PYTHONHOME
# What the user has set up for Matplotlib and IPython changes nothing here; HOME may be read-only.
unexport MATPLOTLIBRC
export MPLCONFIGDIR := $(CURDIR)/.venv/matplotlib
export IPYTHONDIR := $(CURDIR)/.venv/ipython
SHELL := /bin/sh
BIN := .venv/bin
READY := .venv/.ready
OUT ?= build/figures
# Points of the lab: lab/grids/GRID.csv. What whole grids gave lies where it is read.
GRID ?= grid
# Where the book is on its host, for `make serve`.
BASE ?= /
MEASURED = $(if $(filter grid mitigations shared,$(GRID)),packages/book/discostorm_book/data/measured,$(if $(filter security,$(GRID)),lab/data,"build/lab/$$GRID/measured"))
# Given to the shell as they are, with quotes and dollars.
override export OUT := $(value OUT)
override export PYTHON := $(value PYTHON)
override export GRID := $(value GRID)
override export BASE := $(value BASE)
override export SOURCES := $(value SOURCES)
override export MIRROR := $(value MIRROR)
BUILD = $(BIN)/python scripts/check_loopback.py && $(BIN)/jupyter-book build . -W --keep-going -n
TO_LATEX = sh scripts/checks/check_latex.sh && rm -rf _build/latex _build/.doctrees _build/run_times.csv \
	build/discostorm.pdf build/cheat_sheet.pdf && $(BUILD) --builder latex && echo "Running LaTeX ..."
LATEX = cd _build/latex && for name in discostorm cheat_sheet; do \
	SOURCE_DATE_EPOCH=$(EPOCH) FORCE_SOURCE_DATE=1 latexmk -xelatex -halt-on-error \
	-interaction=nonstopmode -quiet $$name.tex >$$name.latexmk 2>&1 \
	|| { tail -n 40 $$name.latexmk; exit 1; }; done
CHECK_PDF = $(BIN)/python scripts/book/check_pdf.py _build/latex/discostorm.pdf && \
	$(BIN)/python scripts/book/check_pdf.py _build/latex/cheat_sheet.pdf --pages 1 && mkdir -p build && \
	cp _build/latex/discostorm.pdf _build/latex/cheat_sheet.pdf build/
# What a release runs first; `make release NOTEBOOKS=` where `make book` has just run them.
NOTEBOOKS ?= notebooks
# The time of the commit instead of now: what is built twice comes out the same.
EPOCH = $(shell git log -1 --format=%ct 2>/dev/null || echo 0)

export PIP_DISABLE_PIP_VERSION_CHECK := 1

$(READY): requirements.lock pyproject.toml scripts/setup.sh
	@sh scripts/setup.sh

build/lab/.ready: $(READY) $(wildcard lab/programs/*.[ch] lab/programs/*.?pp lab/programs/*.idl lab/*.lock lab/*.sh)
	@sh lab/setup.sh

.PHONY: help book test test-all test-alone pdf release figures calculator live live-check palette notebooks lint bench lab lab-roots lab-releases air ills deaths published hybrid ns3 simulate test-oldest test-newest check-dist metadata serve lock clean

help: ## list what can be made
	@awk -F ':.*## ' '/^[a-z0-9-]+:.*## / {printf "make %-12s %s\n", $$1, $$2}' Makefile

book: $(READY) ## execute every notebook and build the HTML book
	@$(BIN)/python scripts/check_loopback.py
	@rm -rf _build
	@$(BIN)/python scripts/book/run_notebooks.py --report _build
	@$(BUILD)
	@touch _build/.done
	@echo; echo "The book is ready: open $$PWD/_build/html/index.html"

test: $(READY) ## test packages and notebooks, and visit each page once
	@$(BIN)/python scripts/check_loopback.py
	@$(BIN)/pytest -n 2 -m "not thorough"

test-all: $(READY) ## run all tests: pages in all modes, the PDF, the lab, the engine
	@$(BIN)/python scripts/check_loopback.py
	@$(BIN)/pytest -n 2

test-alone: $(READY) ## test each package where only what it names is installed
	@$(BIN)/python scripts/checks/check_distributions.py --alone all

pdf: $(READY) ## make the book as one PDF, build/discostorm.pdf (needs LaTeX)
	@$(TO_LATEX)
	@$(LATEX)
	@$(CHECK_PDF)
	@echo; echo "The PDF is ready: open $$PWD/build/discostorm.pdf, and cheat_sheet.pdf beside it"

release: $(READY) $(NOTEBOOKS) ## make the archive to publish, with HTML, PDF, notebooks, figures and data
	@$(TO_LATEX)
	@rm -rf _build/html _build/.doctrees build/release
	@($(LATEX)) & latex=$$!; $(BUILD) && wait $$latex
	@$(CHECK_PDF)
	@$(BIN)/discostorm figures --out build/release/figures
	@for package in . packages/simulation packages/planner packages/capture packages/book; do \
		(cd $$package && SOURCE_DATE_EPOCH=$(EPOCH) "$(CURDIR)/$(BIN)/python" -m hatchling build \
		--target wheel --directory "$(CURDIR)/build/release/dist") || exit 1; done
	@$(BIN)/python scripts/book/make_release.py --epoch $(EPOCH)

figures: $(READY) notebooks ## write Figs. 2-4 and their data to OUT (build/figures), and check what words cover
	@$(BIN)/discostorm figures --out "$$OUT"

calculator: $(READY) ## write the calculator's formulas, in JavaScript, from the package
	@$(BIN)/python scripts/generate/write_calculator.py

live: $(READY) ## compile the simulator, engine.wasm, and write what runs of the pages are set up from (needs lld)
	@$(BIN)/python scripts/generate/write_wasm_files.py

live-check: $(READY) ## compare the engine with its source and in the browser, in 1000 settings (needs Chromium)
	@$(BIN)/python scripts/generate/compare_wasm_with_python.py $(ARGS)

palette: $(READY) ## write the colors of the pages from the palette
	@$(BIN)/python scripts/generate/write_palette.py

notebooks: $(READY) ## execute every notebook in place
	@$(BIN)/python scripts/book/run_notebooks.py

lint: $(READY) ## check style, types and which module imports which
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-logo --cache-dir .venv/import-linter

bench: $(READY) ## measure the speed of the package against its limits
	@$(BIN)/python scripts/checks/measure_speed.py

lab: build/lab/.ready ## capture real middleware in network namespaces (Debian, root; GRID=short: a minute)
	@$(BIN)/python lab/measure/run_grid.py --grid "lab/grids/$$GRID.csv" --out "build/lab/$$GRID" \
		$(if $(filter short,$(GRID)),--busy)
	@$(BIN)/python lab/measure/count_messages.py "build/lab/$$GRID" --out $(MEASURED)
	@[ "$$GRID" != short ] || $(BIN)/python lab/proposed_discovery/run.py --grid lab/proposed_discovery/short.csv \
		--captures build/lab/short_hybrid --out $(MEASURED)/hybrid.csv
	@[ "$$GRID" != short ] || ! $(BIN)/python lab/releases/make_roots.py fast_dds-2.9.1 || \
		$(BIN)/python lab/measure/run_releases.py --grid lab/grids/releases_short.csv \
		--once --captures build/lab/short_releases --out build/lab/short/releases
	@test "$$GRID" != short || $(BIN)/python lab/measure/failures.py --short

lab-roots: build/lab/.ready ## make what lab-releases measures (SOURCES=folder of sources, MIRROR=Debian's; once, half an hour)
	@$(BIN)/python lab/releases/make_roots.py $${SOURCES:+--sources "$$SOURCES"} $${MIRROR:+--mirror "$$MIRROR"} $(ARGS)

lab-releases: build/lab/.ready ## measure releases of the middleware (Debian, root; three hours; goes on where it was)
	@$(BIN)/python lab/measure/run_releases.py $(ARGS)

air: $(READY) build/ns3/.ready ## run real middleware on an emulated Wi-Fi cell (root, TUN, g++, roots of lab-roots; GRID=short: two minutes)
	@[ "$$GRID" = short ] || exec $(BIN)/python lab/air/measure_air.py $(ARGS)
	@[ "$$GRID" != short ] || exec $(BIN)/python lab/air/measure_air.py --grid lab/grids/air_short.csv --once \
		--out build/air/short $(ARGS)

ills: build/lab/.ready ## capture sick and healthy fleets of real middleware (Debian, root; an hour and a half)
	@$(BIN)/python lab/measure/faults.py $(ARGS)
	@$(BIN)/python lab/measure/unlisted_faults.py
	@$(BIN)/python lab/measure/run_grid.py --grid lab/grids/faults_healthy.csv --out build/lab/ills_healthy --crowd 12
	@$(BIN)/python lab/measure/fault_findings.py
	@$(BIN)/python lab/measure/fault_benchmark.py

deaths: build/lab/.ready ## kill servers, routers and robots of real middleware (Debian, root; half an hour)
	@$(BIN)/python lab/measure/failures.py $(ARGS)
	@$(BIN)/python lab/measure/failures.py --outages $(ARGS)

published: build/lab/.ready ## stage the set-ups of which others published numbers (Debian, root; half an hour)
	@$(BIN)/python lab/measure/literature.py $(ARGS)

hybrid: $(READY) ## capture speakers of the hybrid discovery in network namespaces (Debian, root; 15 minutes)
	@$(BIN)/python lab/proposed_discovery/run.py --out packages/book/discostorm_book/data/measured/hybrid.csv

build/ns3/.ready: lab/ns3/requirements.txt | $(READY)
	@command -v $${CXX:-g++} >/dev/null || { echo "discostorm: make ns3 needs a C++ compiler (Debian: apt-get install g++)" >&2; exit 1; }
	@echo "Installing ns-3 into build/ns3 (once, 70 MB to download) ..."
	@mkdir -p build/ns3
	@sh scripts/install.sh build/ns3/packages --no-deps --require-hashes -r lab/ns3/requirements.txt || \
		{ echo "discostorm: no ns-3; its wheels are for Python 3.8 to 3.13 on 64-bit x86 Linux" >&2; exit 1; }
	@touch $@

ns3: $(READY) build/ns3/.ready ## run the storm in ns-3 and write what it measured (half an hour; needs g++)
	@$(BIN)/python lab/ns3/sweep.py $(ARGS)

simulate: $(READY) ## simulate what the chapters of Part IV read (half an hour; goes on where it was)
	@$(BIN)/python scripts/sweeps/run_sweeps.py $(ARGS)
	@$(BIN)/python lab/proposed_discovery/simulate.py

test-oldest: $(READY) ## test the package with the oldest supported versions of what it needs
	@$(BIN)/python scripts/checks/run_tests_with_versions.py oldest

test-newest: $(READY) ## test the package with the newest versions of what it needs
	@$(BIN)/python scripts/checks/run_tests_with_versions.py newest

build/dist-tools/.ready: scripts/checks/check_dist.lock | $(READY)
	@echo "Installing what checks distributions into build/dist-tools (once) ..."
	@sh scripts/install.sh build/dist-tools --no-deps --require-hashes -r scripts/checks/check_dist.lock
	@touch $@

check-dist: build/dist-tools/.ready ## build source archive and wheel, and try them as an index would
	@$(BIN)/python scripts/checks/check_distributions.py --tools build/dist-tools

metadata: $(READY) ## write what indexes and archives read, from CITATION.cff and _config.yml
	@$(BIN)/python scripts/generate/write_metadata.py

serve: book ## show the book at http://localhost:8000, or below it (BASE=/discostorm/)
	@$(BIN)/python scripts/serve_book.py _build/html --base "$$BASE"

lock: $(READY) ## resolve the versions anew (needs uv)
	printf -- '-e %s\n' . packages/*/ | uv pip compile --upgrade - --group book --group dev --universal --fork-strategy fewest \
		--python-version 3.11 --generate-hashes --no-header --no-annotate \
		--no-emit-package discostorm --no-emit-package discostorm-simulation --no-emit-package discostorm-planner \
		--no-emit-package discostorm-capture --no-emit-package discostorm-book -o requirements.lock
	$(BIN)/python scripts/generate/write_environment.py

clean: ## remove what was built, but not .venv
	rm -rf _build build
