"""The command ``discostorm``: each of its commands is a module of its name.

What a command needs beyond the package itself is imported when it runs: tables of a few rows do
without pandas, which takes as long to import as the rest.
"""

from discostorm.cli.main import main

__all__ = ["main"]
