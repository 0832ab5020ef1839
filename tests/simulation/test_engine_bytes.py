"""The engine of the package is what its source is compiled to."""

import importlib

import pytest

check_wasm = importlib.import_module("check_wasm")
compile_wasm = importlib.import_module("compile_wasm")

pytestmark = [pytest.mark.book, pytest.mark.thorough]


def test_the_same_sources_give_the_same_bytes() -> None:
    """With the versions that made it; with others its results are compared."""
    if compile_wasm.find_linker() is None:
        pytest.skip("no wasm-ld here")
    assert check_wasm.check_bytes().startswith("engine: ")


def test_the_engine_does_what_its_source_says() -> None:
    """In few settings; `make live-check` tries many."""
    tried = list(check_wasm.random_settings(20, seed=2))
    assert (
        check_wasm.compare_with_numba(tried, [check_wasm.run_in_python(one) for one in tried]) == []
    )
