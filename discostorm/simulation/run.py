"""One run, from its start to its end."""

import numpy as np

from discostorm.simulation.cell import Cell
from discostorm.simulation.engine import MEMORY, OVER, advance
from discostorm.simulation.traffic import grown


def finish(cell: Cell, until: int, reserve: int = 1024, share: int = 5_000_000) -> Cell:
    while True:
        state = advance(cell, until, reserve, share)
        if state == OVER:
            return cell
        if state == MEMORY:
            cell = grown(cell)
