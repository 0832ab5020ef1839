"""The command ``discostorm``, which is ``python -m discostorm`` as well."""

import gc
import sys


def main() -> None:
    """Run the command; see `discostorm.cli.main`."""
    try:
        # What is loaded stays to the end: to look through it for garbage, again and again as it
        # comes and once more at the end, would take a third of the time of a short command.
        gc.disable()
        # Here, as Ctrl-C may come while NumPy and SymPy are loaded, before click answers it.
        from discostorm.cli import main as command

        gc.freeze()
        gc.enable()
        command(prog_name="discostorm")
    except KeyboardInterrupt:
        if sys.stderr is not None:
            sys.stderr.write("\nAborted!\n")
        sys.exit(1)
    finally:
        gc.freeze()


if __name__ == "__main__":
    main()
