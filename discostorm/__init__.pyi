from . import (
    capture as capture,
    data as data,
    figures as figures,
    fleet as fleet,
    flows as flows,
    measured as measured,
    messages as messages,
    model as model,
    notation as notation,
    paper as paper,
    planner as planner,
    protocols as protocols,
    robots as robots,
    saturation as saturation,
    simulation as simulation,
    staggered as staggered,
    timeline as timeline,
    uncertainty as uncertainty,
    wifi as wifi,
)
from ._numeric import lambdify as lambdify
from .capture import Capture as Capture, CaptureError as CaptureError, read_capture as read_capture
from .fleet import Fleet as Fleet, HostGroup as HostGroup
from .messages import (
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
from .model import breakdown as breakdown, burst as burst, utilization as utilization
from .planner import Plan as Plan, Remedy as Remedy, Share as Share
from .planner.plan import plan as plan
from .protocols import DDS as DDS, PROTOCOLS as PROTOCOLS, ZENOH as ZENOH
from .saturation import saturation_hosts as saturation_hosts
from .simulation import Simulation as Simulation, simulate as simulate
from .timeline import drain_time as drain_time
from .uncertainty import bounds as bounds, sensitivity as sensitivity
from .wifi import (
    PAPER as PAPER,
    WIFI as WIFI,
    Aggregation as Aggregation,
    Link as Link,
    Padding as Padding,
    Radio as Radio,
    Wifi as Wifi,
)

__version__: str
