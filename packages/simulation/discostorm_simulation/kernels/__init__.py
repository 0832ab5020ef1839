"""The simulator's inner loop as Python, which `make live` compiles with numba to `engine.wasm`.

Users do not need these modules to simulate. Importing the modules takes numba.
"""
