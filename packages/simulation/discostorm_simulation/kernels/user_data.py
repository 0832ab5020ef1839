"""User data on the air: who sends a sample to whom, and how late its frames arrive."""

from discostorm_simulation import state as st
from discostorm_simulation.kernels.channel_access import submit_frame
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import compose, item_of, kind_of
from discostorm_simulation.kernels.queues import messages_to, multicast_count, receiver_count


@njit
def stamp(cell, time):
    """Return the time in stamps, as user data carry it in the place of a number."""
    return (time // cell.state[0].stamp) & st.ITEMS


@shared
def send_user_data(cell, row, source, to, time):
    """Send the frames of a sample, with the time at which it was made."""
    times = (
        multicast_count(cell, source, row) if to == source else messages_to(cell, source, to, row)
    )
    for _ in range(times):
        frame = compose(row, source, to, stamp(cell, time)) | st.STEADY
        cell.delays[cell.kinds[row].user - 1, st.SENT_FRAMES] += receiver_count(cell, frame)
        submit_frame(cell, frame, time)


@shared
def receive_user_data(cell, frame, time):
    """Note how late a frame of user data has arrived."""
    row = cell.kinds[kind_of(frame)].user - 1
    cell.delays[row, (stamp(cell, time) - item_of(frame)) & st.ITEMS] += 1


@shared
def is_user_data(cell, burst):
    """Return whether what a host sends by the clock is user data."""
    for row in range(cell.state[0].kinds):
        if cell.bursts[burst, row] and cell.kinds[row].user:
            return True
    return False


@njit
def may_send_data(cell, process, other):
    """Return whether a process has all of another; without recovery, whether that is remote."""
    if not cell.state[0].repairs:
        return cell.processes[process].host != cell.processes[other].host
    return cell.pairs[process, other].completed_at > 0
