# `make help` lists the targets. Set-up happens once, in .venv, from requirements.lock.
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
SHELL := /bin/sh
PYTHON ?= python3
BIN := .venv/bin
READY := .venv/.ready
OUT ?= build/figures

export PIP_DISABLE_PIP_VERSION_CHECK := 1

$(READY): requirements.lock pyproject.toml scripts/setup.sh
	@PYTHON="$(PYTHON)" sh scripts/setup.sh

.PHONY: help book test figures notebooks lint bench serve lock clean

help: ## list what can be made
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "make %-10s %s\n", $$1, $$2}' Makefile

book: $(READY) ## execute every notebook and build the HTML book
	@rm -rf _build
	@$(BIN)/jupyter-book build . -W --keep-going -n
	@echo; echo "The book is ready: open $(CURDIR)/_build/html/index.html"

test: $(READY) ## run all tests, notebooks included
	@$(BIN)/python scripts/run_tests.py

figures: $(READY) ## write Figs. 2-4 and their data to OUT (build/figures)
	@$(BIN)/python -m discostorm.figures "$(OUT)"

notebooks: $(READY) ## execute every notebook in place
	@$(BIN)/python scripts/run_notebooks.py

lint: $(READY) ## check style and types
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

bench: $(READY) ## measure the speed that the README promises
	@$(BIN)/python scripts/bench.py

serve: book ## show the book at http://localhost:8000
	@$(BIN)/python -m http.server 8000 --bind 127.0.0.1 --directory _build/html

lock: ## resolve the versions anew (needs uv)
	uv pip compile pyproject.toml --group book --group dev --universal --fork-strategy fewest \
		--python-version 3.11 --generate-hashes --no-header --no-annotate -o requirements.lock
	$(BIN)/python scripts/write_environment.py

clean: ## remove what was built, but not .venv
	rm -rf _build build
