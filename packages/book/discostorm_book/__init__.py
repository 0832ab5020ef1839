"""Figures, tables and checks of the book; no other package imports this one."""

from importlib.util import find_spec

# pandas writes tables with tabulate.
for _name in ("IPython", "matplotlib_inline", "tabulate"):
    if find_spec(_name) is None:
        raise ImportError(
            f"discostorm_book needs {_name}; to get it: pip install 'discostorm[book]'", name=_name
        )
