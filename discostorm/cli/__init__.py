"""The command ``discostorm``: one module per subcommand, with the same name.

A command imports its own needs when it runs. Small tables avoid pandas, which takes as long to
import as everything else.
"""

from discostorm.cli.main import main

__all__ = ["main"]
