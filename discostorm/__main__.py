"""The command ``discostorm``, which is ``python -m discostorm`` as well."""

import sys


def main() -> None:
    """Run the command; see `discostorm.cli.main`."""
    try:
        # Here, as Ctrl-C may come while NumPy and SymPy are loaded, before click answers it.
        from discostorm.cli import main as command

        command(prog_name="discostorm")
    except KeyboardInterrupt:
        sys.exit("\nAborted!")


if __name__ == "__main__":
    main()
