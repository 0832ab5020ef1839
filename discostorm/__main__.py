"""``python -m discostorm`` is the command ``discostorm``."""

from discostorm.cli import main

if __name__ == "__main__":
    main(prog_name="discostorm")
