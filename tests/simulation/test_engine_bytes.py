"""The engine of the package is what its source is compiled to."""

import importlib

import pytest

check_live = importlib.import_module("check_live")
compile_live = importlib.import_module("compile_live")

pytestmark = [pytest.mark.book, pytest.mark.thorough]


def test_the_same_sources_give_the_same_bytes() -> None:
    """With the versions that made it; with others its results are compared."""
    if compile_live.find_linker() is None:
        pytest.skip("no wasm-ld here")
    assert check_live.check_bytes().startswith("engine: ")


def test_the_engine_does_what_its_source_says() -> None:
    """In few settings; `make live-check` tries many."""
    tried = list(check_live.random_settings(20, seed=2))
    assert (
        check_live.compare_with_numba(tried, [check_live.run_in_python(one) for one in tried]) == []
    )
