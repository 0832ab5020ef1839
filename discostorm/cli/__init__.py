"""The command ``discostorm``: the package's answers as tables, JSON and CSV.

Each command is a module of its name; `output`, `options` and `fleets` hold what they share. What a
command needs beyond the package itself is imported when it runs: tables of a few rows do without
pandas, which takes as long to import as the rest.
"""

from discostorm.cli.main import main

__all__ = ["main"]
