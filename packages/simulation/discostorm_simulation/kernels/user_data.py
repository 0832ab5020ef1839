"""User data on the air: senders and receivers of samples, and delays of their frames."""

from discostorm_simulation import state as st
from discostorm_simulation.kernels.channel_access import submit_frame
from discostorm_simulation.kernels.decorators import inlined, not_inlined
from discostorm_simulation.kernels.primitives import item_of, kind_of, pack_frame
from discostorm_simulation.kernels.queues import messages_to, multicast_count, receiver_count


@inlined
def time_stamp(cell, time):
    """Convert a time to a stamp, which a frame of user data carries in place of its item."""
    return (time // cell.state[0].stamp) & st.ITEMS


@not_inlined
def send_user_data(cell, row, source, to, time):
    """Send the frames of a sample, stamped with the time of the sample."""
    times, host = messages_to(cell, source, to, row), cell.processes[source].host
    if to == source:
        times = multicast_count(cell, source, row)
    for _ in range(times):
        frame = pack_frame(row, source, to, time_stamp(cell, time)) | st.STEADY
        sent = receiver_count(cell, frame, host)
        cell.delays[cell.kinds[row].user - 1, st.SENT_FRAMES] += sent
        submit_frame(cell, frame, time)


@not_inlined
def receive_user_data(cell, frame, time):
    """Count a received frame of user data by its delay."""
    row = cell.kinds[kind_of(frame)].user - 1
    cell.delays[row, (time_stamp(cell, time) - item_of(frame)) & st.ITEMS] += 1


@not_inlined
def is_user_data(cell, burst):
    """Return whether a burst is user data."""
    for row in range(cell.state[0].kinds):
        if cell.bursts[burst, row] and cell.kinds[row].user:
            return True
    return False


@inlined
def may_send_data(cell, process, other):
    """Return whether a process may send data to another: after discovery, or if remote."""
    if not cell.state[0].repairs:
        return cell.processes[process].host != cell.processes[other].host
    its = cell.processes[process]
    learning = cell.stations[its.host].first if its.mute else process
    return cell.pairs[learning, other].completed_at > 0
