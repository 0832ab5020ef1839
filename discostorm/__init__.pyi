from discostorm import (
    data as data,
    drain_times as drain_times,
    figures as figures,
    fleet as fleet,
    flows as flows,
    messages as messages,
    model as model,
    notation as notation,
    prediction_error as prediction_error,
    protocols as protocols,
    robots as robots,
    saturation as saturation,
    snippets as snippets,
    uncertainty as uncertainty,
    wifi as wifi,
)
from discostorm._numeric import lambdify as lambdify
from discostorm.cells import Cell as Cell
from discostorm.drain_times import drain_time as drain_time
from discostorm.figures.parameter_sweep import sweep as sweep
from discostorm.fleet import Fleet as Fleet, HostGroup as HostGroup, Process as Process
from discostorm.messages import (
    ENDPOINT_PAIR as ENDPOINT_PAIR,
    ONCE as ONCE,
    PAIR as PAIR,
    PROCESS as PROCESS,
    Message as Message,
    Payload as Payload,
    Protocol as Protocol,
    Schedule as Schedule,
    Unit as Unit,
)
from discostorm.model import (
    breakdown as breakdown,
    burst as burst,
    cell_utilization as cell_utilization,
    utilization as utilization,
)
from discostorm.protocols import DDS as DDS, PROTOCOLS as PROTOCOLS, ZENOH as ZENOH
from discostorm.saturation import saturation_hosts as saturation_hosts
from discostorm.uncertainty import bounds as bounds, sensitivity as sensitivity
from discostorm.wifi import (
    PAPER as PAPER,
    WIFI as WIFI,
    Aggregation as Aggregation,
    Link as Link,
    OfdmSymbols as OfdmSymbols,
    Radio as Radio,
    Wifi as Wifi,
)
from discostorm_capture import (
    Capture as Capture,
    CaptureError as CaptureError,
    read_capture as read_capture,
)
from discostorm_planner import Plan as Plan, Remedy as Remedy, Share as Share, plan as plan
from discostorm_simulation import Simulation as Simulation, simulate as simulate

__version__: str
