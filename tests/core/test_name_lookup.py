"""Questions in the user's words: names that people use, ready-made robots, several products."""

import json
from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner, Result

import discostorm as ds
from discostorm import _names, drain_times, figures, notation, robots, saturation, uncertainty
from discostorm.cli import main
from discostorm.cli.options import PROTOCOL_SETS
from discostorm.data import read_data
from discostorm.lookup import as_protocol, as_wifi
from discostorm.protocols import BASES, aliases, protocols_in_order
from discostorm.wifi.radio import radio_named

SWARM = ["--hosts", "3", "--processes", "2", "--endpoints", "10"]


def run(*words: str, columns: int = 79) -> Result:
    return CliRunner(env={"COLUMNS": str(columns)}).invoke(main, list(words))


def answer(*words: str) -> Any:
    done = run(*words, "--json")
    assert done.exit_code == 0, done.output
    return json.loads(done.stdout)


# Products


@pytest.mark.parametrize(
    ("written", "name"),
    [
        ("fastdds", "Fast DDS 3.6"),
        ("fastdds-2.14", "Fast DDS 2.14"),
        ("Fast DDS 2.9", "Fast DDS"),
        ("Fast-DDS", "Fast DDS 3.6"),
        ("rmw_fastrtps_cpp", "Fast DDS 3.6"),
        ("RMW-FastRTPS-CPP", "Fast DDS 3.6"),
        ("cyclonedds", "Cyclone DDS, version 11"),
        ("rmw_cyclonedds_cpp", "Cyclone DDS, version 11"),
        ("Cyclone DDS 0.10", "Cyclone DDS"),
        ("rmw_zenoh_cpp", "Zenoh router per host"),
        ("zenoh", "Zenoh"),
        ("dds", "DDS"),
        ("zenoh-peer", "Zenoh peer"),
    ],
)
def test_products_have_the_names_that_people_use(written: str, name: str) -> None:
    assert as_protocol(written).name == name
    assert [row["protocol"] for row in answer("utilization", *SWARM, "--protocol", written)] == [
        name
    ]


SWARM_COUNTS = {"hosts": 7, "processes": 2, "endpoints": 10}
FLEET = ds.Fleet.swarm(**SWARM_COUNTS)
RADIO = ds.Radio("802.11ac", width=80e6, streams=2)


@pytest.mark.parametrize(
    "call",
    [
        lambda protocol, wifi: ds.utilization(protocol, **SWARM_COUNTS, wifi=wifi),
        lambda protocol, wifi: ds.utilization(protocol, FLEET, wifi=wifi, phase="data"),
        lambda protocol, wifi: ds.burst(protocol, FLEET, wifi=wifi),
        lambda protocol, wifi: ds.breakdown(protocol, FLEET, wifi=wifi).to_csv(),
        lambda protocol, wifi: ds.saturation_hosts(protocol, 2, 10, wifi),
        lambda protocol, wifi: ds.drain_time(protocol, FLEET, wifi=wifi),
        lambda protocol, wifi: drain_times.demand(protocol, 1, 7, 2, 10, wifi),
        lambda protocol, wifi: drain_times.first_idle(protocol, 7, 2, 10, wifi),
        lambda protocol, wifi: drain_times.outlook(protocol, 7, 2, 10, wifi),
        lambda protocol, _: ds.bounds(protocol, FLEET),
        lambda protocol, _: uncertainty.saturation_bounds(protocol, 2, 10),
        lambda protocol, _: ds.sensitivity(protocol, 2, 10).to_csv(),
        lambda protocol, _: uncertainty.derivative_signs(protocol),
        lambda protocol, _: uncertainty.utilization_at({}, protocol, FLEET),
        lambda protocol, _: uncertainty.sample(protocol, size=1)[notation.R_UNI].item(),
        lambda protocol, _: figures.color_of(protocol),
    ],
)
def test_functions_take_names_of_protocols_and_radios(call: Any) -> None:
    expected = call(ds.PROTOCOLS["Fast DDS 3.6"], ds.WIFI["802.11ac 80 MHz 2x2"])
    assert call("rmw_fastrtps_cpp", "802.11AC 80 MHz") == expected
    assert call("Fast DDS 3.6", RADIO) == expected
    assert saturation.saturation("dds") == saturation.saturation(ds.DDS)
    with pytest.raises(ValueError, match=r"protocol must be 'DDS', .*'Cyclone DDS', .*; got 'fa"):
        call("fastdss", RADIO)


def test_a_misspelt_name_gets_the_nearest_and_the_list_in_one_sentence() -> None:
    listed = "', '".join([*ds.WIFI][:3])
    with pytest.raises(
        ValueError, match=f"{listed}.*; got '802.1ax 80'. Did you mean '802.11ax 80"
    ):
        as_wifi("802.1ax 80")
    assert as_wifi("Paper") is ds.PAPER
    for known, name, like in (
        (ds.PROTOCOLS, "FastDDS", "Fast DDS"),
        (ds.WIFI, "802.11ac 80 MHz", "802.11ac 80 MHz 2x2"),
    ):
        with pytest.raises(KeyError) as caught:
            known[name]
        assert str(caught.value).endswith(f"; got '{name}'. Did you mean '{like}'?")
        assert name not in known
        assert known.get(name) is None
    with pytest.raises(AttributeError, match=r"no attribute 'utilisation'. Did you mean 'utiliz"):
        ds.utilisation  # noqa: B018
    with pytest.raises(TypeError, match="robot must be a str; got 4"):
        robots.robot(4)  # type: ignore[arg-type]


def test_public_objects_have_representations_of_at_most_two_lines() -> None:
    shown: list[Any] = [ds.PROTOCOLS, ds.WIFI, ds.PAPER, *ds.WIFI.values()]
    shown += [wifi.radio for wifi in ds.WIFI.values()]
    for table in ds.PROTOCOLS.values():
        shown += [table, *table.messages, table.timers]
        shown += [part for row in table.messages for part in (row.payload, row.unit, row.schedule)]
    many = tuple(ds.HostGroup(n, 22, 42.2, f"robots {n}", nodes=1.2) for n in range(1, 50))
    shown += [ds.Fleet(many), *many, FLEET, ds.bounds("DDS", FLEET)]
    assert {len(repr(each)) <= 158 and "\n" not in repr(each) for each in shown} == {True}
    for wifi in ds.WIFI.values():
        assert eval(repr(wifi.radio), {"Radio": ds.Radio}) == wifi.radio
    assert "<td>unicast</td>" in ds.DDS._repr_html_()
    assert "<th>robots 49</th>" in ds.Fleet(many)._repr_html_()


def test_a_payload_is_a_number_of_bytes() -> None:
    assert ds.Payload(350) == ds.Payload(350, 350, 350, "")
    row: Any = ("Hello", "Hello", "multicast", "UDP", 350, ds.PROCESS, 1)
    assert ds.Message(*row).payload == ds.Payload(350)


@pytest.mark.parametrize(
    ("ros", "written", "name"),
    [
        ("humble", "fastdds", "Fast DDS 2.6"),
        ("Jazzy", "rmw_fastrtps_cpp", "Fast DDS 2.14"),
        ("kilted", "rmw_fastrtps", "Fast DDS 3.6"),
        ("ros2 lyrical", "fast dds", "Fast DDS 3.6"),
        ("jazzy", "cyclonedds", "Cyclone DDS"),
        ("lyrical", "rmw_cyclonedds_cpp", "Cyclone DDS, version 11"),
        ("jazzy", "rmw_zenoh_cpp", "Zenoh router per host"),
        ("jazzy", "discovery server", "Fast DDS Discovery Server"),
    ],
)
def test_a_ros_distribution_picks_the_release_that_it_ships(
    ros: str, written: str, name: str
) -> None:
    assert as_protocol(written, ros).name == name
    for words in (["--ros", ros, "--protocol", written], ["--protocol", written, "--ros", ros]):
        assert [row["protocol"] for row in answer("utilization", *SWARM, *words)] == [name]


@pytest.mark.parametrize(
    ("ros", "written", "versions"),
    [
        ("kilted", "Fast DDS", ("Fast DDS 3.2.5", "is 3.6.2")),
        ("jazzy", "Cyclone DDS", ("Cyclone DDS 0.10.5", "is 0.10.2")),
        ("jazzy", "Fast DDS", ()),
        ("lyrical", "Cyclone DDS", ()),
    ],
)
def test_the_nearest_release_is_named_where_another_one_was_measured(
    ros: str, written: str, versions: tuple[str, ...]
) -> None:
    done = run("utilization", *SWARM, "--ros", ros, "--protocol", written, "--json")
    assert done.stderr.count(f"ROS 2 {ros.capitalize()} ships") == bool(versions)
    assert all(version in done.stderr for version in versions)


def test_a_fleet_file_names_the_distribution_of_its_robots(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    group = "[[groups]]\nhosts = 3\nprocesses = 2\nendpoints = 10\n"
    path.write_text('ros = "jazzy"\n' + group)
    assert ds.Fleet.from_toml(path).ros == "jazzy"
    for words, name in (((), "Fast DDS 2.14"), (("--ros", "lyrical"), "Fast DDS 3.6")):
        assert [row["protocol"] for row in answer("utilization", str(path), *words)] == [name]
    path.write_text('ros = "jazz"\n' + group)
    done = run("utilization", str(path), columns=200)
    assert "ros must be 'humble', 'jazzy', 'kilted' or 'lyrical'; got 'jazz'" in done.output
    path.write_text("ros = 3\n" + group)
    assert "ros must be a str; got 3" in run("utilization", str(path), columns=200).output


def test_each_shipped_table_is_there() -> None:
    for row in read_data("vendors/ros.csv"):
        assert row["product"] in ds.PROTOCOLS
        assert row["protocol"] in ds.PROTOCOLS


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--ros", "jazy"), "'jazy'. Did you mean 'jazzy'?"),
        (("--ros", "foxy"), "ros must be 'humble', 'jazzy', 'kilted' or 'lyrical'; got 'foxy'"),
        (
            ("--ros", "jazzy", "--protocol", "Fast DDS 3.6"),
            "ROS 2 Jazzy ships, such as 'Fast DDS 2.14'; got 'Fast DDS 3.6'",
        ),
    ],
)
def test_a_release_that_a_distribution_does_not_ship_is_refused(
    words: tuple[str, ...], said: str
) -> None:
    done = run("utilization", *SWARM, *words, columns=200)
    assert done.exit_code == 2
    assert said in done.output


def test_no_name_means_two_products() -> None:
    names = [*ds.PROTOCOLS, *aliases()]
    assert len({_names.normalize(name) for name in names}) == len(names)
    assert not {_names.normalize(name) for name in names} & PROTOCOL_SETS.keys()
    assert set(aliases().values()) <= set(ds.PROTOCOLS)
    others = [*robots.robots(), *robots.aliases()]
    assert len({_names.normalize(name) for name in others}) == len(others)


@pytest.mark.parametrize(
    ("arguments", "nearest"),
    [
        (["utilization", *SWARM, "--protocol", "fastdss"], "Did you mean 'Fast DDS'?"),
        (["utilization", *SWARM, "--protocol", "rmw_zenoh_cp"], "Did you mean 'rmw_zenoh_cpp'?"),
        (["utilization", *SWARM, "--protocol", "alll"], "Did you mean 'all'?"),
        (["breakdown", "--robot", "turtlebot3", "--hosts", "2"], "Did you mean 'TurtleBot 4'?"),
        (["breakdown", *SWARM, "--wifi", "802.1ax 80"], "Did you mean '802.11ax 80 MHz 2x2'?"),
        (["breakdwn"], "Did you mean 'breakdown'?"),
        (["breakdown", "--endpoint", "3"], "--endpoints"),
    ],
)
def test_a_wrong_name_gets_the_nearest_right_one(arguments: list[str], nearest: str) -> None:
    done = run(*arguments)
    assert (done.exit_code, done.stdout) == (2, "")
    assert nearest in " ".join(done.stderr.split())


def test_a_name_like_no_other_gets_none() -> None:
    assert _names.nearest_name("mqtt", ds.PROTOCOLS) is None
    assert "Did you mean" not in run("breakdown", *SWARM, "--protocol", "mqtt").stderr


def test_a_wrong_key_of_a_fleet_file_gets_the_nearest_right_one() -> None:
    with pytest.raises(ValueError, match=r"unknown key endpoint = 90\. Did you mean 'endpoints'"):
        ds.Fleet.from_bytes(b"[[groups]]\nhosts = 1\nprocesses = 1\nendpoint = 90\n", "x")


def test_radios_need_no_number_of_streams() -> None:
    for name, wifi in ds.WIFI.items():
        assert wifi.radio is not None
        short = name.replace(" 2x2", "").replace(" 1x1", "")
        assert radio_named(short) == radio_named(name) == wifi.radio, name
    assert radio_named("802.11ac 80MHz").streams == 2


def test_the_parts_of_a_radio_come_in_any_order_and_the_usual_ones_may_be_left_out() -> None:
    for name, usual in (
        ("80 MHz 802.11ac", "802.11ac 80 MHz 2x2"),
        ("802.11ac 5 GHz", "802.11ac 80 MHz 2x2"),
        ("802.11AC", "802.11ac 80 MHz 2x2"),
        ("2x2 802.11ac, 5 GHz 80 MHz", "802.11ac 80 MHz 2x2"),
        ("802.11n 40 MHz 5 GHz", "802.11n 40 MHz 2x2"),
        ("2.4 GHz 802.11n", "802.11n 20 MHz 2x2, 2.4 GHz"),
    ):
        found = radio_named(name).wifi()
        assert (found.name, found.unicast) == (usual, ds.WIFI[usual].unicast)
    with pytest.raises(ValueError, match="'80' cannot be in the name of a radio"):
        radio_named("802.11ac 80")


def test_the_papers_two_have_a_word() -> None:
    rows = answer("utilization", *SWARM, "--protocol", "paper")
    assert [row["protocol"] for row in rows] == ["DDS", "Zenoh"]


def test_all_are_in_one_table_in_the_calculators_order() -> None:
    names = [row["protocol"] for row in answer("utilization", *SWARM, "--protocol", "all")]
    assert names == [protocol.name for protocol in protocols_in_order()]
    assert sorted(names) == sorted(ds.PROTOCOLS)
    order = list(BASES)
    places = [order.index(ds.PROTOCOLS[name].basis or "proposal") for name in names]
    assert places == sorted(places)


def test_what_one_product_sends_fits_the_terminal() -> None:
    for product in ("fastdds", "dds", "zenoh"):
        done = run("breakdown", *SWARM, "--protocol", product)
        name, _, heading, *_ = done.stdout.splitlines()
        assert name == f"Protocol: {as_protocol(product).name}"
        assert heading.split()[:2] == ["message", "cast"]
        assert max(map(len, done.stdout.splitlines())) <= 79


def every_option() -> list[tuple[str, click.Option]]:
    context = click.Context(main)
    assert isinstance(main, click.Group)
    commands = {name: main.get_command(context, name) for name in main.list_commands(context)}
    return [
        (name, option)
        for name, command in commands.items()
        if command is not None
        for option in command.params
        if isinstance(option, click.Option) and not option.is_flag
    ]


@pytest.mark.parametrize(
    ("command", "option"), every_option(), ids=lambda one: getattr(one, "name", one)
)
def test_a_repeated_option_is_never_dropped_silently(command: str, option: click.Option) -> None:
    flag = option.opts[0]
    done = run(command, flag, "1", flag, "2")
    if option.multiple:
        assert "give it once" not in done.stderr
    else:
        assert (done.exit_code, done.stdout) == (2, "")
        assert f"{flag} is given 2 times; give it once" in done.stderr
        assert f"{flag} is given 3 times" in run(command, f"{flag}=1", flag, "2", flag, "1").stderr


# Ready-made robots


def test_robots_lists_the_ready_made_ones() -> None:
    rows = {row["robot"]: row for row in answer("robots")}
    named = robots.robots() | {"laptop": robots.laptop()}
    assert rows.keys() == named.keys()
    assert rows.pop("laptop")["endpoints"] == robots.laptop().endpoints
    for name, host in robots.robots().items():
        assert rows[name]["processes"] * rows[name]["endpoints"] == pytest.approx(
            float(host.processes * host.endpoints)
        )
        parts = [row for row in read_data("fleets/robots.csv") if row["robot"] == name]
        assert rows[name]["nodes"] == pytest.approx(sum(int(part["nodes"]) for part in parts))
        assert all(part["source"] in rows[name]["source"] for part in parts)
    said = run("robots").stdout
    assert max(map(len, said.splitlines())) <= 79
    assert all(alias in said for alias in robots.aliases())


def test_saturation_says_whether_the_given_hosts_fit() -> None:
    words = ["saturation", "--processes", "2", "--endpoints", "10", "--protocol", "dds", "--hosts"]
    for hosts, fit in (("7", True), ("7.15", True), ("7.16", False), ("8", False)):
        (row,) = answer(*words, hosts)
        assert (row["asked"], row["asked_fit"]) == (float(hosts), fit)
    assert "yours  fit" in run(*words, "7").stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("utilization --robot tb4", "--robot needs --hosts"),
        ("utilization --robot tb4 --hosts 2 --endpoints 3", "cannot be combined with --endpoints"),
        ("breakdown --robot tb4 --hosts 2 x.toml", "--fleet cannot be combined with --hosts"),
        ("breakdown --robot tb4 --hosts 2,3", "--hosts must be one number here"),
        ("saturation x.toml --hosts 3", "--fleet cannot be combined with --hosts"),
        (
            "breakdown --hosts 2",
            "give --processes and --endpoints, --fleet FILE, or --robot",
        ),
    ],
)
def test_one_way_to_say_who_is_there(arguments: str, message: str) -> None:
    done = run(*arguments.split())
    assert (done.exit_code, done.stdout) == (2, "")
    assert message in " ".join(done.stderr.split())


def test_a_server_forwards_as_that_of_the_distribution_also_by_name() -> None:
    fleet = ds.Fleet((ds.HostGroup(8, 4, 30, shared=8),))
    loads = [
        ds.utilization(as_protocol("Discovery Server", ros), fleet)
        for ros in (None, "lyrical", "kilted")
    ]
    assert loads[0] == loads[1] > 2 * loads[2]
