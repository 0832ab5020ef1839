"""Test the configuration to copy: the product itself loads each piece, in a namespace."""

import ast
import csv
import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import make_roots
import pytest
from support import REFERENCE, ROOT, skip_or_fail
from test_lab_programs import lab, ready

from discostorm.data import data_path, read_data
from discostorm.files import write_folder
from discostorm.fleet import Fleet
from discostorm.protocols import PROTOCOLS
from discostorm.snippets import Snippet, snippets
from discostorm_planner import plan as plan_of
from discostorm_planner.changes import Change
from discostorm_planner.configuration_folder import texts_by_path
from discostorm_planner.protocol_changes import protocol_changes

pytestmark = pytest.mark.book

ROWS = read_data("vendors/snippets.csv")
FILES = sorted({row["file"] for row in ROWS})
BIN = lab.BUILD / "bin"

#: A host without a way out: eth0 has the addresses that are pasted.
HOST = """
sysctl -q -w net.ipv6.conf.all.disable_ipv6=1
ip link set lo up
ip link add eth0 type veth peer name eth1
for last in 10 11 21; do ip address add 192.168.1.$last/24 dev eth0; done
ip link set eth0 up && ip link set eth1 up && ip route add default dev eth0
mount -t tmpfs shm /dev/shm
exec "$@"
"""
ALONE = ["setpriv", "--pdeathsig", "KILL", "unshare", "--net", "--mount", "--fork", "--pid"]
ALONE += ["--kill-child", "--mount-proc", "sh", "-euc", HOST, "host"]


def of(file: str) -> Snippet:
    (piece, *_) = (s for row in ROWS for s in snippets(row["kind"], row["for"]) if s.file == file)
    return piece


def run_in_namespace(
    *command: str | Path, env: dict[str, str] | None = None, given: str = ""
) -> str:
    """Run a program in a namespace; return all that it says. It must end well."""
    done = subprocess.run(
        [*ALONE, *map(str, command)],
        input=given,
        capture_output=True,
        text=True,
        check=False,
        env={"PATH": os.environ["PATH"]} | (env or {}),
        timeout=300,
    )
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    return said


def fast_dds(path: Path) -> dict[str, str]:
    """Return Fast DDS's output for a file of profiles, or of static endpoints."""
    text = path.read_text()
    profile = re.search(r'participant profile_name="(\w+)"', text)
    said = run_in_namespace(BIN / "fast_dds_load", path, profile[1] if profile else "static")
    assert "Error" not in said, said
    return dict(line.partition(" ")[::2] for line in said.splitlines())


def cyclone_dds(path: Path) -> dict[str, str]:
    """Have both versions make a participant with this configuration."""
    for program in (lab.CYCLONE_DDS, lab.CYCLONE_DDS_11):
        words = [*program, "0", "1", "1", "0", "unique", "default"]
        said = run_in_namespace(*words, env={"CYCLONEDDS_URI": f"file://{path}"}, given="0\n")
        assert "\nparticipant " in said, said
        assert "config:" not in said, said
    return {}


ZENOH = """
import json, sys, zenoh
config = zenoh.Config.from_file(sys.argv[1])
keys = ["mode", "connect/endpoints", "listen/endpoints", "scouting/multicast/enabled"]
keys += ["scouting/gossip/target", "transport/link/tx/lease", "transport/link/tx/keep_alive"]
keys += [f"transport/unicast/{name}" for name in ("open_timeout", "accept_timeout")]
keys += [f"transport/unicast/{name}" for name in ("accept_pending", "max_sessions")]
print(json.dumps({key: config.get_json(key) for key in keys}))
"""


def zenoh(path: Path) -> dict[str, str]:
    """Return the settings that Zenoh reads in a file."""
    found: dict[str, str] = json.loads(run_in_namespace(lab.PYTHON, "-c", ZENOH, path))
    return found


def hostapd(path: Path) -> dict[str, str]:
    """Start hostapd without a radio, with these lines and those that it always needs."""
    program = shutil.which("hostapd")
    if program is None:
        skip_or_fail("hostapd is not installed: apt-get install hostapd")
    lines = path.read_text()
    whole = path.with_suffix(".whole")
    given = "interface=wlan0\ndriver=none\nssid=robots\n"
    whole.write_text(given + lines)
    with subprocess.Popen(
        [*ALONE, program, str(whole)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    ) as running:
        assert running.stdout is not None
        said = ""
        for line in running.stdout:
            said += line
            if "AP-ENABLED" in line:
                break
        running.kill()
    assert "AP-ENABLED" in said, said
    return {}


LOADED: dict[str, Callable[[Path], dict[str, str]]] = {
    "fast_dds": fast_dds,
    "cyclone_dds": cyclone_dds,
    "zenoh": zenoh,
    "hostapd": hostapd,
}


def loader(file: str) -> Callable[[Path], dict[str, str]] | None:
    """Return the program that loads a file; None for shell commands and code."""
    if Path(file).suffix not in (".xml", ".json5", ".conf"):
        return None
    return next(load for product, load in LOADED.items() if file.startswith(product))


#: What is sent by a snippet for Zenoh is counted by a table, and was measured with the settings
#: of a variant of `lab/programs/zenoh.json` (none: as shipped, but for what changes no number).
COUNTED = {
    "zenoh_router.json5": ("Zenoh router", "zenohd"),
    "zenoh_client.json5": ("Zenoh router", "router"),
    "zenoh_router_of_host.json5": ("Zenoh router per host", "zenohd"),
    "zenoh_session_of_host.json5": ("Zenoh router per host", "router_per_host"),
    "zenoh_router_of_star.json5": ("Zenoh router per host, star", "zenohd"),
    "zenoh_peers.json5": ("Zenoh peer, tokens", None),
    "zenoh_session.json5": ("Zenoh peer, tokens", None),
}
#: What is no file of a product but runs here all the same.
RUN = {
    "fast_dds_server.sh",
    "fast_dds_client.sh",
    "fast_dds_two_servers.sh",
    "fast_dds_client_of_two.sh",
    "fast_dds_super_client.sh",
    "staggered_start.sh",
}
#: Variables of Fast DDS that name a file of profiles: before 3.0, and since.
VARIABLES = ["FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"]
#: What must have come of it: as its product says, not as the file does.
SIXTY = {"transport/link/tx/lease": "60000", "transport/link/tx/keep_alive": "2"}
EFFECTS = {
    "fast_dds_server.xml": {"protocol": "4", "ports": "11811"},
    "fast_dds_static.xml": {"protocol": "1", "simple": "0", "static": "1"},
    "fast_dds_announcements.xml": {"announcements": "1", "period": "15", "lease": "100"},
    "fast_dds_super_client.xml": {"protocol": "6", "servers": "1"},
    "zenoh_router.json5": {"mode": '"router"', "scouting/multicast/enabled": "false"} | SIXTY,
    "zenoh_client.json5": {"mode": '"client"', "connect/endpoints": '["tcp/192.168.1.10:7447"]'}
    | SIXTY,
    "zenoh_peers.json5": {"mode": '"peer"', "scouting/multicast/enabled": "false"}
    | {"transport/link/tx/lease": "10000", "transport/link/tx/keep_alive": "4"},
    "zenoh_session.json5": {"mode": '"peer"', "scouting/multicast/enabled": "true"}
    | {"connect/endpoints": "[]", "listen/endpoints": '["tcp/0.0.0.0:0"]'},
    "zenoh_router_of_host.json5": {"mode": '"router"', "scouting/multicast/enabled": "false"}
    | SIXTY,
    "zenoh_router_of_star.json5": {"mode": '"router"', "scouting/multicast/enabled": "false"}
    | {"connect/endpoints": '["tcp/192.168.1.10:7447"]'}
    | SIXTY,
    "zenoh_session_of_host.json5": {"mode": '"peer"', "listen/endpoints": '["tcp/localhost:0"]'}
    | SIXTY,
}


def write_piece(file: str, folder: Path) -> Path:
    """Write a piece as a user would, with the files that it refers to."""
    path = folder / file
    path.write_text(of(file).text.replace("/etc/", f"{folder}/"))
    return path


@pytest.mark.parametrize("file", [file for file in FILES if loader(file)])
def test_the_product_loads_it(file: str, tmp_path: Path) -> None:
    ready()
    load = loader(file)
    assert load is not None
    write_piece("fast_dds_static_endpoints.xml", tmp_path)
    found = load(write_piece(file, tmp_path))
    assert EFFECTS.get(file, {}).items() <= found.items()


#: Changes that are written for each host: a table of the fleet's middleware, and the change.
WRITTEN = [
    *(("Fast DDS", name) for name in ("discovery server", "two discovery servers")),
    *(("Cyclone DDS", name) for name in ("peers", "announcements", "multicast endpoint data")),
    *(("Zenoh peer, tokens", name) for name in ("peers", "router", "router on each host")),
    *(("Zenoh peer, tokens", name) for name in ("star of routers",)),
    ("Fast DDS", "announcements"),
]


@pytest.mark.parametrize(("table", "change"), WRITTEN)
def test_the_product_loads_what_is_written_for_each_host(
    table: str, change: str, tmp_path: Path
) -> None:
    """Addresses are those that the namespace has; units are those that systemd reads."""
    ready()
    addresses = (("server", "192.168.1.10"), ("robot1", "192.168.1.21"))
    more = (("robot2", "192.168.1.10"), ("robot3", "192.168.1.11"))
    servers = (("server1", "192.168.1.10"), ("server2", "192.168.1.11"))
    fleet = Fleet(Fleet.swarm(3, 12, 10).groups, addresses=(*addresses, *more, *servers))
    plan = plan_of(fleet, PROTOCOLS[table])
    write_folder(tmp_path / "out", texts_by_path(fleet, plan.find_change(change), plan.within))
    loaded = set()
    for path in (p for p in (tmp_path / "out").rglob("*") if p.parent.name == "etc"):
        load = cyclone_dds if path.name == "cyclonedds.xml" else loader(path.name)
        if load:
            load(path)
            loaded.add(path.name)
    units = [*(tmp_path / "out").rglob("*.service")]
    assert loaded or units
    if units and shutil.which("systemd-analyze"):
        said = subprocess.run(
            ["systemd-analyze", "verify", *map(str, units)],
            capture_output=True,
            text=True,
            check=False,
        )
        assert not [line for line in said.stderr.splitlines() if str(tmp_path) in line], said.stderr


@pytest.mark.parametrize("file", sorted(f for f in EFFECTS if f.startswith("fast_dds")))
def test_fast_dds_reads_it_by_the_variable_that_the_paste_names(file: str, tmp_path: Path) -> None:
    """The variable of 2.9.1; that of 3.0 is not read yet."""
    ready()
    write_piece("fast_dds_static_endpoints.xml", tmp_path)
    path = write_piece(file, tmp_path)
    is_for_both = file != "fast_dds_super_client.xml"
    assert re.findall(r"\b(FAST\w+_FILE)\b", of(file).load) == VARIABLES[: 1 + is_for_both]
    old, new = (run_in_namespace(BIN / "fast_dds_load", env={v: str(path)}) for v in VARIABLES)
    effects = {f"{key} {value}" for key, value in EFFECTS[file].items()}
    assert effects <= set(old.splitlines())
    assert not effects <= set(new.splitlines())


def wait_for_clients(folder: Path) -> str:
    """Return the profile with which a service waits for its clients, as the page has it."""
    page = (ROOT / "book" / "what_is_wrong.md").read_text(encoding="utf-8")
    (text,) = re.findall(r'^```xml\n(.*profile_name="service".*?)^```$', page, re.M | re.S)
    (folder / "fast_dds.xml").write_text(text)
    # It has no profile of a participant, which is the last thing that the program asks for.
    done = subprocess.run(
        [*ALONE, BIN / "fast_dds_load", folder / "fast_dds.xml", "service"],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    return done.stderr.splitlines()[-1]


def test_fast_dds_takes_the_wait_of_a_service_from_the_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ready()
    assert wait_for_clients(tmp_path) == "fast_dds_load: no participant"
    write = Path.write_text
    monkeypatch.setattr(
        Path, "write_text", lambda path, text: write(path, text.replace("blocking", "waiting"))
    )
    assert wait_for_clients(tmp_path) == "fast_dds_load: not a file of profiles"


def test_no_server_is_started_with_a_backup_file() -> None:
    """Restarted with its fleet, such a server needs more than a second of airtime."""
    starts = [
        line.split()
        for file in FILES
        for line in data_path(f"vendors/snippets/{file}").read_text(encoding="utf-8").splitlines()
        if line.startswith("fastdds discovery")
    ]
    assert len(starts) >= 3
    assert not any({"-b", "--backup"} & set(words) for words in starts)
    runs = read_data("measured/backup_restarts.csv", "discostorm_book")
    assert all(float(run["airtime_s"]) > 1 for run in runs if run["backup"] == "1")


def test_the_versions_that_read_ros_super_client_are_told() -> None:
    rows = read_data("vendors/super_client.csv")
    assert {row["distribution"] for row in rows} == {"Humble", "Iron", "Jazzy", "Kilted"}
    text = of("fast_dds_super_client.sh").text
    for row in rows:
        assert row["since"] in text, row
        # Where a distribution began with an older version, it is named beside that.
        if row["since"].startswith(f"{row['fast_dds']}."):
            assert row["distribution"] in text, row
    remedies = [row for row in read_data("vendors/remedies.csv") if "servers" in row["kind"] + "s"]
    assert all("ROS_SUPER_CLIENT" not in row["price"] for row in remedies)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row['kind']} {row['file']}")
def test_every_paste_says_how_it_is_loaded_and_whether_it_ran(row: dict[str, str]) -> None:
    piece = next(s for s in snippets(row["kind"], row["for"]) if s.file == row["file"])
    told = " ".join(re.sub(r"^(# |// |<!-- )|( -->)$", "", piece.text, flags=re.M).split())
    assert f"Load: {row['load']}" in told
    by_file = f"/{'hostapd/hostapd.conf' if 'hostapd' in row['file'] else ''}"
    assert by_file in row["load"] or row["file"].endswith((".sh", ".cpp", ".launch"))
    assert re.search(r"process|router runs with|ros2 |hostapd", row["load"]), row
    ran = bool(loader(row["file"])) or row["file"] in RUN
    assert (row["run_here"] == "yes") == ran, row
    assert ("Not run here" in piece.text) != ran
    assert (piece.to_dict()["checked"] == "loaded by the product in a test") == ran


@pytest.mark.parametrize("width", [20, 40, 80, 160])
@pytest.mark.parametrize("band", [2.4, 5])
def test_channels_of_parts_follow_band_and_width(band: float, width: int) -> None:
    """No two parts are given channels that share one of 20 MHz."""
    found = snippets("channels", f"{band:g} GHz {width} MHz")
    if (band, width) in {(2.4, 80), (2.4, 160)}:
        assert not found, "no such channels"
        return
    (piece,) = found
    lines = piece.text.splitlines()
    assert f"hw_mode={'a' if band == 5 else 'g'}" in lines
    told = [int(number) for number in re.findall(r"channel=(\d+)", piece.text)]
    wide = width // 20
    # Channels of 5 GHz lie on a raster from 36, 100 and 149 on; HT40+ has its second one above.
    start = {36: 36, 40: 36, 44: 36, 48: 36, 52: 36, 100: 100, 149: 149}
    parts = [
        {(n - start[n]) // 4 // wide + start[n] * 100}
        if band == 5
        else set(range(n - 2, n - 2 + 4 * wide))  # in steps of 5 MHz
        for n in told
    ]
    for i, part in enumerate(parts):
        assert all(part.isdisjoint(other) for other in parts[:i]), (told, parts)
    assert len(told) >= 2


@pytest.mark.parametrize("width", [40, 80])
def test_radios_have_the_short_guard_interval_and_64_frames_of_the_model(width: int) -> None:
    standard = "802.11n" if width == 40 else "802.11ac"
    (piece,) = snippets("radio", f"{standard} {width} MHz")
    assert "[SHORT-GI-40]" in piece.text
    if width == 80:
        assert "vht_capab=[SHORT-GI-80][MAX-A-MPDU-LEN-EXP7]" in piece.text


@pytest.mark.parametrize("file", COUNTED)
def test_what_is_pasted_for_zenoh_sends_as_the_table_counts_and_as_was_measured(
    file: str, tmp_path: Path
) -> None:
    """KeepAlives as often as the table has them, and the settings that the lab ran with."""
    ready()
    name, variant = COUNTED[file]
    found = {key: json.loads(value) for key, value in zenoh(write_piece(file, tmp_path)).items()}
    seconds = found["transport/link/tx/lease"] / found["transport/link/tx/keep_alive"] / 1000
    periods = {m.schedule.period for m in PROTOCOLS[name].messages if m.kind == "KeepAlive"}
    assert periods == {seconds}
    if variant is not None:
        settings = json.loads((lab.PROGRAMS / "zenoh.json").read_text())
        measured = settings["all"] | settings[variant]
        keys = {key for key in found if key.startswith("transport/")} | {"mode"}
        keys |= {"scouting/multicast/enabled"}
        if found["mode"] != "client":  # clients do not gossip
            keys |= {"scouting/gossip/target"}
        # zenohd begins with "mode": "router"; what Zenoh leaves out is its default.
        assert {key: found[key] for key in keys} == {key: measured[key] for key in keys}


@pytest.mark.parametrize(
    ("file", "word", "wrong"),
    [
        ("fast_dds_announcements.xml", "leaseDuration>", "leaseDur>"),
        ("fast_dds_static_endpoints.xml", "<userId>2", "<userId>1"),
        ("cyclone_dds_peers.xml", "MaxAutoParticipantIndex", "MaxParticipantIndex"),
        ("zenoh_client.json5", "multicast", "multicats"),
        ("hostapd_multicast_rate.conf", "basic_rates", "basic_rate"),
    ],
)
def test_the_product_would_refuse_a_mistake(
    file: str, word: str, wrong: str, tmp_path: Path
) -> None:
    ready()
    path = write_piece(file, tmp_path)
    text = path.read_text()
    assert word in text
    path.write_text(text.replace(word, wrong))
    load = loader(file)
    assert load is not None
    with pytest.raises(AssertionError):
        load(path)


#: Another host, at the end of the first one's cable.
OTHER = """
unshare --net --mount sleep 300 &
other=$!
# A busy machine may be slow to make the other host, and to begin to listen.
while [ "$(readlink /proc/$other/ns/mnt)" = "$(readlink /proc/self/ns/mnt)" ]; do sleep 0.05; done
ip link set eth1 netns $other
inside() { nsenter --target=$other --net --mount "$@"; }
inside sh -euc '
mount -t tmpfs shm /dev/shm
ip link set lo up
ip address add 192.168.1.22/24 dev eth1
ip link set eth1 up && ip route add default dev eth1'
tcpdump -n -i eth0 -l udp 2>/dev/null &
until ss -H --packet | grep -q .; do sleep 0.05; done
"""


def spread(begins: list[str], seen: list[str]) -> str:
    """Run processes on two hosts until tcpdump has seen all that is asked for; return all of it.

    Nothing is slow to end: who is not seen within a while is asserted by the caller.
    """
    script = [
        OTHER.replace("-l udp", "-l -A --immediate-mode > dump"),
        *begins,
        *(f"until grep -q '{text}' dump || ((SECONDS > 60)); do sleep 0.1; done" for text in seen),
        "sleep 1",  # for what must not come
        "kill $(jobs -p)",
        "cat dump",
    ]
    return run_in_namespace("bash", "-c", "\n".join(["cd $(mktemp -d -p /dev/shm)", *script]))


@pytest.mark.parametrize(
    ("server", "client", "hosts"),
    [
        ("fast_dds_server.sh", "fast_dds_client.sh", (10,)),
        # The second server does not run here, as if it were down.
        ("fast_dds_two_servers.sh", "fast_dds_client_of_two.sh", (10, 11)),
    ],
)
def test_a_client_talks_to_its_servers_and_to_no_group(
    server: str, client: str, hosts: tuple[int, ...]
) -> None:
    ready()
    begin = next(line for line in of(server).text.splitlines() if line.startswith("fastdds "))
    sent = [f"> 192.168.1.{host}.11811:" for host in hosts]
    answered = r" 192\.168\.1\.10\.[0-9]* > 192\.168\.1\.22\."
    served = spread(
        [
            f"{begin} >/dev/null &",
            "until ss -Hlun 'sport = 11811' | grep -q .; do sleep 0.1; done",
            of(client).text,
            f"date +%s | inside {BIN}/fast_dds 90 1 1 0 unique udp >/dev/null &",
        ],
        [*sent, answered],
    )
    assert "> 239.255.0.1.7400" not in served
    assert all(text in served for text in sent)
    assert re.search(answered, served)


#: Fast DDS as ROS 2 distributions ship it, made by `make lab-roots`.
RELEASES = [row for row in make_roots.releases() if row["product"] == "fast_dds" and row["ros"]]


@pytest.fixture(params=RELEASES, ids=lambda row: row["release"])
def release(request: pytest.FixtureRequest) -> Path:
    """Return the root of a release; skip the test where it was not made."""
    root = make_roots.ROOTS / request.param["release"]
    if not (root / make_roots.DESCRIPTION_FILE).exists():
        pytest.skip(f"{root.name} is not made: make lab-roots")
    return root


def test_each_release_of_ros_2_takes_the_profiles(release: Path, tmp_path: Path) -> None:
    """But for the profile of a super client, which releases from 3.0 on refuse."""
    ready()
    is_new = release.name.startswith("fast_dds-3")
    source, program = ROOT / "lab" / "programs" / "fast_dds_load.cpp", tmp_path / "load"
    library = [f"-L{release / 'lib'}", f"-Wl,--disable-new-dtags,-rpath,{release / 'lib'}"]
    library += ["-lfastdds" if is_new else "-lfastrtps", "-lfastcdr", "-Wl,--allow-shlib-undefined"]
    compiler = ["c++", "-std=c++17", "-isystem", str(release / "include")]
    subprocess.run([*compiler, str(source), "-o", str(program), *library], check=True)
    endpoints = write_piece("fast_dds_static_endpoints.xml", tmp_path)
    if release.name != "fast_dds-2.6.12":  # which cannot check a list
        run_in_namespace(program, endpoints, "static")
    for file in sorted(f for f in EFFECTS if f.startswith("fast_dds")):
        path = write_piece(file, tmp_path)
        said = run_in_namespace(program, env={VARIABLES[is_new]: str(path)})
        effects = {f"{key} {value}" for key, value in EFFECTS[file].items()}
        refused = is_new and file == "fast_dds_super_client.xml"
        assert (effects <= set(said.splitlines())) == (not refused), (file, said)


@pytest.mark.parametrize("way", ["client", "client of two", "super client"])
def test_each_release_of_ros_2_serves_clients_and_super_clients(release: Path, way: str) -> None:
    """The pasted commands themselves; who is told of topics that it does not use, is as we say."""
    ready()
    version = tuple(map(int, release.name.partition("-")[2].split(".")))
    program = json.loads((release / make_roots.DESCRIPTION_FILE).read_text())["command"][0]
    begin = next(line for line in of("fast_dds_server.sh").text.splitlines() if "-i 0" in line)
    # The second of two servers does not run here, as if it were down.
    client = of(f"fast_dds_{'client_of_two' if way == 'client of two' else 'client'}.sh").text
    tool = of("fast_dds_super_client.sh").text if way == "super client" else client
    found = spread(
        [
            # The command is a script of Python that needs psutil.
            f"export PATH={release}/bin:{Path(sys.executable).parent}:$PATH",
            f"LD_LIBRARY_PATH={release}/lib {begin} >/dev/null &",
            "until ss -Hlun 'sport = 11811' | grep -q .; do sleep 0.1; done",
            client,
            f"date +%s | {program} 90 1 1 4 unique one >/dev/null &",
            tool,
            f"date +%s | inside {program} 90 2 1 0 unique one >/dev/null &",
        ],
        [r" 192\.168\.1\.10\.[0-9]* > 192\.168\.1\.22\.", "> 192.168.1.22.7411:"],
    )
    assert "> 239.255.0.1.7400" not in found
    assert "> 192.168.1.10.11811:" in found
    assert "> 192.168.1.22.7411:" in found  # ros_discovery_info is matched
    assert ("rt/lab_0101_w000" in found) == (way == "super client" or version >= (3, 5))


@pytest.mark.parametrize("served", [False, True])
def test_domains_part_those_who_find_each_other_and_not_those_whom_a_server_introduces(
    served: bool,
) -> None:
    """Two hosts in two domains: do their endpoints match?"""
    ready()
    run = f"{BIN}/fast_dds 90 1 1 4 matching udp >/dev/null"
    server = next(line for line in of("fast_dds_server.sh").text.splitlines() if "-i 0" in line)
    # The port of user traffic in domain 1 (RTPS 2.5, 9.6.2): who is matched alone sends there.
    matched = f"> 192.168.1.22.{7400 + 250 + 11}:"
    groups = [f" > 239.255.0.1.{7400 + 250 * domain}:" for domain in (0, 1)]
    said = spread(
        [
            f"{server} >/dev/null &" if served else "",
            "until ss -Hlun 'sport = 11811' | grep -q .; do sleep 0.1; done" if served else "",
            of("fast_dds_client.sh").text if served else "",
            f"date +%s | {run} &",
            of("ros_domain.sh").text,
            f"date +%s | inside {run} &",
        ],
        [" > 192.168.1.10.11811:", matched] if served else groups,
    )
    assert all(text in said for text in ([" > 192.168.1.10.11811:"] if served else groups))
    assert (matched in said) == served


def cyclone_traffic(uri: str) -> tuple[int, int]:
    """Return the octets by multicast and by unicast of two processes on each of two hosts.

    SEDP goes by multicast only to hosts that are known before an endpoint is made, so a process
    has so many endpoints that it meets the others while it makes them.
    """
    run = f"{BIN}/cyclone_dds 5 {{}} {{}} 300 unique default >/dev/null"
    script = [OTHER, "begin=$(($(date +%s) + 3))"]
    for process in (1, 2):
        script.append(f"echo $begin | {run.format(1, process)} & running+=($!)")
        script.append(f"echo $begin | inside {run.format(2, process)} & running+=($!)")
    said = run_in_namespace(
        "bash",
        "-c",
        "\n".join([*script, "wait ${running[@]}", "sleep 0.5", "kill $(jobs -p)"]),
        env={"CYCLONEDDS_URI": uri},
    )
    sent = re.findall(r"> (239\.255)?\S+: UDP, length (\d+)", said)
    many = [sum(int(size) for group, size in sent if bool(group) == cast) for cast in (True, False)]
    return many[0], many[1]


def test_what_is_pasted_for_cyclone_dds_moves_its_traffic_as_the_planner_says(
    tmp_path: Path,
) -> None:
    """By CYCLONEDDS_URI, as the paste says: peers use no multicast, multicast SEDP more of it."""
    ready()
    files = ("cyclone_dds_peers.xml", "cyclone_dds_multicast.xml")
    pasted = [f"file://{write_piece(file, tmp_path)}" for file in files]
    with ThreadPoolExecutor(3) as three:
        wifi, peers, multicast = three.map(cyclone_traffic, [lab.SPDP_ONLY, *pasted])
    assert all(wifi)
    assert peers[0] == 0
    assert multicast[0] > 2 * wifi[0]
    assert 0 < multicast[1] < max(wifi[1], peers[1])


ODOMETRY = "nav_msgs::msg::dds_::Odometry_"


@pytest.mark.parametrize("way", ["client", "variable", "profile"])
def test_fast_dds_2_9_ignores_ros_super_client_and_heeds_the_profile(
    way: str, tmp_path: Path
) -> None:
    """A tool reads one of two topics: a super client is told of the other one as well."""
    ready()
    assert lab.installed_version("fast_dds").startswith("2.9.1")
    begin = next(line for line in of("fast_dds_server.sh").text.splitlines() if "-i 0" in line)
    client = of("fast_dds_client.sh").text
    lines = {
        "client": client,
        "variable": of("fast_dds_super_client.sh").text,
        "profile": "unset ROS_DISCOVERY_SERVER; export FASTRTPS_DEFAULT_PROFILES_FILE="
        f"{write_piece('fast_dds_super_client.xml', tmp_path)}",
    }
    told, wanted = f"w rt/hidden {ODOMETRY},w rt/shown {ODOMETRY}", f"r rt/shown {ODOMETRY}"
    found = spread(
        [
            f"{begin} >/dev/null &",
            "until ss -Hlun 'sport = 11811' | grep -q .; do sleep 0.1; done",
            client,
            f"date +%s | {BIN}/fast_dds 90 1 1 '{told}' unique udp >/dev/null &",
            lines[way],
            f"date +%s | inside {BIN}/fast_dds 90 2 1 '{wanted}' unique udp >/dev/null &",
        ],
        # The port of user traffic (RTPS 2.5, 9.6.2): the writer has found the tool's reader.
        [r"> 192.168.1.22.7411:"],
    )
    assert "> 192.168.1.22.7411:" in found
    assert "rt/shown" in found
    assert ("rt/hidden" in found) == (way == "profile")


@pytest.mark.parametrize("way", ["as shipped", "without the variable", "as pasted"])
def test_static_endpoints_match_and_nobody_announces_them(way: str, tmp_path: Path) -> None:
    """By file and variable, as the paste says; and not without RMW_FASTRTPS_USE_QOS_FROM_XML."""
    ready()
    write_piece("fast_dds_static_endpoints.xml", tmp_path)
    robot = write_piece("fast_dds_static.xml", tmp_path)
    laptop = tmp_path / "laptop.xml"
    text = robot.read_text().replace("data_writer", "data_reader")
    laptop.write_text(text.replace("<userDefinedID>1", "<userDefinedID>2"))
    begins = []
    if way == "as pasted":
        assert "RMW_FASTRTPS_USE_QOS_FROM_XML=1" in of("fast_dds_static.xml").load
        begins.append("export RMW_FASTRTPS_USE_QOS_FROM_XML=1")
    for inside, name, file, role in (("", "robot1", robot, "w"), ("inside", "laptop", laptop, "r")):
        if way != "as shipped":
            begins.append(f"export FASTRTPS_DEFAULT_PROFILES_FILE={file}")
        begins.append(f"export ROS_SECURITY_ENCLAVE_OVERRIDE=/{name}")
        told = f"{role} rt/robot1/odom {ODOMETRY}"
        begins.append(f"date +%s | {inside} {BIN}/fast_dds 90 1 1 '{told}' unique udp >/dev/null &")
    # Each knows the other as a participant; the port of user traffic is that of a matched reader.
    matched = "> 192.168.1.22.7411:"
    known = ["> 192.168.1.22.7410:", "> 192.168.1.10.7410:"]
    found = spread(begins, known if way == "without the variable" else [*known, matched])
    assert all(text in found for text in known)
    assert (matched in found) == (way != "without the variable")
    assert ("rt/robot1/odom" in found) == (way == "as shipped")


def announcement_count(seconds: float, program: list[str], env: dict[str, str]) -> int:
    """Return how many announcements to the group a lone process sends at first."""
    transport = "udp" if program == lab.FAST_DDS else "default"
    words = " ".join([*program, f"{seconds:g}", "1", "1", "2", "unique", transport])
    script = [
        # Fast DDS sends one from each address.
        "for last in 11 21; do ip address delete 192.168.1.$last/24 dev eth0; done",
        "tcpdump -n -i eth0 -l --immediate-mode dst host 239.255.0.1 2>/dev/null &",
        "until ss -H --packet | grep -q .; do sleep 0.05; done",
        # By then a busy machine has loaded the program as well, so that its last one is in time.
        f"echo $(($(date +%s) + 2)) | {words} >/dev/null",
        "kill $(jobs -p)",
    ]
    return run_in_namespace("bash", "-c", "\n".join(script), env=env).count("> 239.255.0.1.7400:")


@pytest.mark.parametrize(
    ("product", "variable", "program", "seconds"),
    [
        ("Fast DDS", "FASTRTPS_DEFAULT_PROFILES_FILE", lab.FAST_DDS, 8),
        ("Cyclone DDS", "CYCLONEDDS_URI", lab.CYCLONE_DDS, 11),
    ],
)
def test_calmer_announcements_are_as_many_as_the_planner_counts(
    product: str, variable: str, program: list[str], seconds: float, tmp_path: Path
) -> None:
    ready()
    table = PROTOCOLS[product]
    changes = [change for change in protocol_changes(table) if isinstance(change, Change)]
    (calm,) = (change.table for change in changes if change.kind == "announcements")
    assert calm is not None
    path = write_piece(f"{product.lower().replace(' ', '_')}_announcements.xml", tmp_path)
    pasted = {variable: f"file://{path}" if product == "Cyclone DDS" else str(path)}
    with ThreadPoolExecutor(2) as two:
        sent = [*two.map(lambda env: announcement_count(seconds, program, env), ({}, pasted))]
    counted = []
    for one in (table, calm):
        (schedule,) = (m.schedule for m in one.messages if m.name == "SPDP")
        early = [time for time in schedule.starts if time < seconds]
        counted.append(len(early) + int((seconds - early[-1]) // schedule.period))
    # On a busy machine the last ones may be late.
    assert counted[0] - 1 <= sent[0] <= counted[0]
    assert sent[1] == counted[1] < sent[0]


#: A process of Zenoh's that says how many there are, once all that it was told of are there.
MEETING = """
import sys, time, zenoh
session = zenoh.open(zenoh.Config.from_file(sys.argv[1]))
met = set()
token = session.liveliness().declare_token(f"met/{session.info.zid()}")
told = lambda sample: met.add(str(sample.key_expr))
watching = session.liveliness().declare_subscriber("met/*", told, history=True)
while len(met) < int(sys.argv[2]):
    time.sleep(0.02)
print("met", len(met), flush=True)
time.sleep(300)
"""


@pytest.mark.parametrize("file", ["zenoh_peers.json5", "zenoh_session.json5"])
def test_peers_find_each_other_several_on_a_host(file: str, tmp_path: Path) -> None:
    """Two processes on each of two hosts, all with the file that is pasted."""
    ready()
    path = write_piece(file, tmp_path)
    # As the comment says: the host of the lowest address, .21, is told of nobody.
    text = path.read_text()
    first = tmp_path / "first.json5"
    first.write_text(re.sub(r'"tcp/192.*",', "", text))
    path.write_text(text.replace('"tcp/192.168.1.22:7447",', ""))
    program, out = tmp_path / "meeting.py", tmp_path / "out"
    program.write_text(MEETING)
    run = f"{lab.PYTHON} {program}"
    script = [
        OTHER,
        f"for which in 1 2; do {run} {first} 4 2>&1 >>{out} & inside {run} {path} 4 2>&1 >>{out} &",
        "done",
        f"until [ $(grep -c 'met 4' {out}) = 4 ]; do sleep 0.1; done",
        "kill $(jobs -p)",
    ]
    out.touch()
    run_in_namespace("bash", "-c", "\n".join(script))


#: A router of Zenoh's.
ROUTING = """
import sys, time, zenoh
session = zenoh.open(zenoh.Config.from_file(sys.argv[1]))
time.sleep(300)
"""

#: Pastes for Zenoh: a file for the routers and how many hosts have one, a file for the sessions.
#: Then how many links between two hosts of two sessions each, and whether anybody scouts: who is
#: found by Scouts or gossip may be connected to by both sides; one connection is closed again then.
ZENOH_WAYS = {
    "peers that scout": ("", 0, "zenoh_session.json5", range(4, 9), True),
    "listed peers": ("", 0, "zenoh_peers.json5", range(4, 9), False),
    "router": ("zenoh_router.json5", 1, "zenoh_client.json5", range(2, 3), False),
    "router on each host": (
        *("zenoh_router_of_host.json5", 2, "zenoh_session_of_host.json5", range(1, 2)),
        False,
    ),
}


@pytest.mark.parametrize("way", ZENOH_WAYS)
def test_what_is_pasted_for_zenoh_makes_as_many_links_as_the_planner_says(
    way: str, tmp_path: Path
) -> None:
    """Two sessions on each of two hosts: a link for each two, for each client, for the routers."""
    ready()
    router, routers, session, links, scouts = ZENOH_WAYS[way]

    def configured(file: str, host: int) -> Path:
        # As the comments say: only hosts of lower addresses are listed.
        lower = re.sub(
            r'"tcp/192\.168\.1\.(\d+):7447",?',
            lambda found: found[0] if int(found[1]) < host else "",
            of(file).text,
        )
        path = tmp_path / f"{host}_{file}"
        path.write_text(lower)
        return path

    program, routing, out = (tmp_path / name for name in ("meeting.py", "routing.py", "out"))
    program.write_text(MEETING)
    routing.write_text(ROUTING)
    out.touch()
    script = [OTHER.replace("-l udp", f"-l --immediate-mode 'udp or tcp' > {tmp_path}/dump")]
    hosts = {21: "", 22: "inside"}
    for host, inside in [*hosts.items()][:routers]:
        script.append(f"{inside} {lab.PYTHON} {routing} {configured(router, host)} &")
        script.append(f"until {inside} ss -Hltn 'sport = 7447' | grep -q .; do sleep 0.1; done")
    script += [
        f"{inside} {lab.PYTHON} {program} {configured(session, host)} 4 >>{out} 2>&1 &"
        for host, inside in [*hosts.items()] * 2
    ]
    script += [
        f"until [ $(grep -c 'met 4' {out}) = 4 ]; do sleep 0.1; done",
        "kill $(jobs -p)",
        f"cat {tmp_path}/dump",
    ]
    said = run_in_namespace("bash", "-c", "\n".join(script))
    # Those with octets: the others were refused.
    sent = re.findall(r"IP (\S+) > (\S+): Flags .* length (\d+)", said)
    linked = {frozenset(ends) for *ends, length in sent if int(length)}
    assert len(linked) in links
    assert ("> 224.0.0.224.7446" in said) == scouts


#: What a shell's lines may set and start, each looked up in the source that the table names.
NAMES = {
    "ROS_DISCOVERY_SERVER",
    "ROS_SUPER_CLIENT",
    "ROS_AUTOMATIC_DISCOVERY_RANGE",
    "ROS_STATIC_PEERS",
    "ROS_DOMAIN_ID",
    "RMW_IMPLEMENTATION",
    "ZENOH_SESSION_CONFIG_URI",
    "WINDOW",
}


@pytest.mark.parametrize("file", [file for file in FILES if file.endswith(".sh")])
def test_lines_for_a_shell_are_lines_of_a_shell(file: str) -> None:
    text = of(file).text
    subprocess.run(["bash", "-n"], input=text, text=True, check=True)
    assert set(re.findall(r"^(?:export )?(\w+)=", text, re.MULTILINE)) <= NAMES


#: What cannot be loaded here, line by line as its documentation has it: file, line, source.
with (REFERENCE / "vendor" / "snippet_lines.csv").open(encoding="utf-8") as _lines:
    DOCUMENTED = list(csv.DictReader(_lines))


@pytest.mark.parametrize("file", sorted({row["file"] for row in DOCUMENTED}))
def test_what_nothing_loads_is_what_the_documentation_says(file: str) -> None:
    lines = [line for line in of(file).text.splitlines() if not line.startswith(("#", "//"))]
    assert lines == [row["line"] for row in DOCUMENTED if row["file"] == file]


def test_all_that_nothing_loads_is_held_against_documentation() -> None:
    # The staggered start and the launch file have tests of their own.
    alone = {"staggered_start.sh", "composition.launch"}
    assert {file for file in FILES if not loader(file)} - alone <= {r["file"] for r in DOCUMENTED}


def test_a_staggered_start_waits_for_no_longer_than_its_window() -> None:
    text = of("staggered_start.sh").text.replace("sleep", "echo")
    said = {
        float(subprocess.run(["bash", "-c", text], capture_output=True, check=True).stdout)
        for _ in range(20)
    }
    assert all(0 <= seconds <= 60 for seconds in said)
    # In whole seconds, many of a short window would start in one instant.
    assert any(seconds % 1 for seconds in said)


def test_the_launch_file_uses_what_launch_has() -> None:
    """The names of launch and launch_ros, branch humble, and their keywords."""
    tree = ast.parse(of("composition.launch").text)
    imported = {
        (node.module, name.name)
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
        for name in node.names
    }
    assert imported == {
        ("launch", "LaunchDescription"),
        ("launch_ros.actions", "ComposableNodeContainer"),
        ("launch_ros.descriptions", "ComposableNode"),
    }
    keywords = {
        node.func.id: {keyword.arg for keyword in node.keywords}
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    }
    assert keywords == {
        "LaunchDescription": set(),
        "ComposableNode": {"package", "plugin", "name"},
        "ComposableNodeContainer": {
            "name",
            "namespace",
            "package",
            "executable",
            "composable_node_descriptions",
        },
    }
    assert [node.name for node in tree.body if isinstance(node, ast.FunctionDef)] == [
        "generate_launch_description"
    ]


def test_every_file_is_for_a_remedy_and_every_piece_says_for_what() -> None:
    there = {path.name for path in data_path("vendors/snippets").iterdir()}
    assert there == set(FILES)
    families = {row["family"] for row in read_data("vendors/families.csv")}
    products = {"any", *PROTOCOLS, *families, "Zenoh peers"}
    for row in ROWS:
        if row["kind"] not in ("radio", "channels"):
            assert row["for"] in products, row
        assert re.search(r" \d+(\.\d+)+| Humble$| Jazzy$", row["version"]), row
    for file in FILES:
        piece = of(file)
        head = piece.text.splitlines()[0]
        assert piece.version in head
        assert piece.where in head
        assert max(map(len, piece.text.splitlines())) <= 100


def test_versions_are_those_that_load_it() -> None:
    """What is installed for the lab is what the pieces say."""
    ready()
    installed = {
        product: lab.installed_version(product).split("-")[0].split("+")[0]
        for product in lab.PACKAGES
    }
    known = {
        "Fast DDS": [installed["fast_dds"]],
        "Cyclone DDS": [installed["cyclone_dds_0.10"], installed["cyclone_dds_11"]],
        "Zenoh": [installed["zenoh_peer"]],
    }
    known["Fast DDS"] += [row["version"] for row in RELEASES]
    for product, versions in known.items():
        for told in {row["version"] for row in ROWS if row["version"].startswith(product)}:
            for version in re.findall(r"[\d.]+", told):
                assert any(f"{one}.".startswith(f"{version}.") for one in versions), told
