"""The simulator's inner loop as Python: what `make live` compiles with numba to `engine.wasm`.

Nobody needs these modules to simulate; importing them takes numba.
"""
