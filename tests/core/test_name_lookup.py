"""Questions in the user's words: names that people use, ready-made robots, several products."""

import json
from typing import Any

import click
import pytest
from click.testing import CliRunner, Result

import discostorm as ds
from discostorm import _names, robots
from discostorm.cli import main
from discostorm.cli.options import SEVERAL
from discostorm.data import read_data
from discostorm.protocols import BASES, aliases, named, offered
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
        ("fastdds", "Fast DDS"),
        ("Fast-DDS", "Fast DDS"),
        ("rmw_fastrtps_cpp", "Fast DDS"),
        ("RMW-FastRTPS-CPP", "Fast DDS"),
        ("cyclonedds", "Cyclone DDS"),
        ("rmw_cyclonedds_cpp", "Cyclone DDS"),
        ("rmw_zenoh_cpp", "Zenoh router per host"),
        ("zenoh", "Zenoh"),
        ("dds", "DDS"),
        ("zenoh-peer", "Zenoh peer"),
    ],
)
def test_products_have_the_names_that_people_use(written: str, name: str) -> None:
    assert named(written).name == name
    assert [row["protocol"] for row in answer("utilization", *SWARM, "--protocol", written)] == [
        name
    ]


def test_no_name_means_two_products() -> None:
    names = [*ds.PROTOCOLS, *aliases()]
    assert len({_names.key(name) for name in names}) == len(names)
    assert not {_names.key(name) for name in names} & SEVERAL.keys()
    assert set(aliases().values()) <= set(ds.PROTOCOLS)
    others = [*robots.robots(), *robots.aliases()]
    assert len({_names.key(name) for name in others}) == len(others)


@pytest.mark.parametrize(
    ("arguments", "nearest"),
    [
        (["utilization", *SWARM, "--protocol", "fastdss"], "Did you mean 'Fast DDS'?"),
        (["utilization", *SWARM, "--protocol", "rmw_zenoh_cp"], "Did you mean 'rmw_zenoh_cpp'?"),
        (["utilization", *SWARM, "--protocol", "alll"], "Did you mean 'all'?"),
        (["breakdown", "--robot", "turtlebot3", "--hosts", "2"], "Did you mean 'TurtleBot 4'?"),
        (["breakdown", *SWARM, "--wifi", "802.11ax"], "Did you mean '802.11ax 80 MHz 2x2'?"),
        (["breakdwn"], "Did you mean 'breakdown'?"),
        (["breakdown", "--endpoint", "3"], "--endpoints"),
    ],
)
def test_a_wrong_name_gets_the_nearest_right_one(arguments: list[str], nearest: str) -> None:
    done = run(*arguments)
    assert (done.exit_code, done.stdout) == (2, "")
    assert nearest in " ".join(done.stderr.split())


def test_a_name_like_no_other_gets_none() -> None:
    assert _names.nearest("mqtt", ds.PROTOCOLS) is None
    assert "Did you mean" not in run("breakdown", *SWARM, "--protocol", "mqtt").stderr


def test_a_wrong_key_of_a_fleet_file_gets_the_nearest_right_one() -> None:
    with pytest.raises(ValueError, match=r"got endpoint = 90\. Did you mean 'endpoints'"):
        ds.Fleet.from_bytes(b"[[groups]]\nhosts = 1\nprocesses = 1\nendpoint = 90\n", "x")


def test_radios_need_no_number_of_streams() -> None:
    for name, wifi in ds.WIFI.items():
        assert wifi.radio is not None
        short = name.replace(" 2x2", "").replace(" 1x1", "")
        assert radio_named(short) == radio_named(name) == wifi.radio, name
    assert radio_named("802.11ac 80MHz").streams == 2


def test_the_papers_two_have_a_word() -> None:
    rows = answer("utilization", *SWARM, "--protocol", "paper")
    assert [row["protocol"] for row in rows] == ["DDS", "Zenoh"]


def test_all_are_in_one_table_in_the_calculators_order() -> None:
    names = [row["protocol"] for row in answer("utilization", *SWARM, "--protocol", "all")]
    assert names == [protocol.name for protocol in offered()]
    assert sorted(names) == sorted(ds.PROTOCOLS)
    order = list(BASES)
    places = [order.index(ds.PROTOCOLS[name].basis or "proposal") for name in names]
    assert places == sorted(places)


def test_what_one_product_sends_fits_the_terminal() -> None:
    for product in ("fastdds", "dds", "zenoh"):
        done = run("breakdown", *SWARM, "--protocol", product)
        name, _, heading, *_ = done.stdout.splitlines()
        assert name == f"Protocol: {named(product).name}"
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
    assert rows.keys() == robots.robots().keys()
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
        ("utilization --robot tb4", "--hosts must be given with --robot"),
        ("utilization --robot tb4 --hosts 2 --endpoints 3", "it goes without --endpoints"),
        ("breakdown --robot tb4 --hosts 2 x.toml", "--fleet goes without --hosts"),
        ("breakdown --robot tb4 --hosts 2,3", "--hosts must be one number here"),
        ("saturation x.toml --hosts 3", "--fleet goes without --hosts"),
        (
            "breakdown --hosts 2",
            "--processes, --endpoints must be given, or --fleet FILE, or --robot",
        ),
    ],
)
def test_one_way_to_say_who_is_there(arguments: str, message: str) -> None:
    done = run(*arguments.split())
    assert (done.exit_code, done.stdout) == (2, "")
    assert message in " ".join(done.stderr.split())
