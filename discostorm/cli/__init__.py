"""The command ``discostorm``: one module per subcommand, with the same name.

A command imports what it needs when it runs. Small tables avoid pandas, which is slow to import.
"""

from discostorm.cli.main import main

__all__ = ["main"]
