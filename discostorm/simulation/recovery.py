"""stub"""

from discostorm.simulation._compile import njit
from discostorm.simulation.cell import later
from discostorm.simulation.medium import offer_burst


@njit
def arrive(cell, frame, process, time):
    return


@njit
def settled(cell):
    return True


@njit
def happen(cell, time, what, busy):
    host = what & 0xFFFFF
    batch = (what >> 20) & 0xFFFFF
    period = cell.batches[batch, cell.now[0].kinds]
    if period == 0:
        cell.now[0].coming -= 1
    else:
        later(cell, time + period, what)
    offer_burst(cell, host, batch, time, busy)
