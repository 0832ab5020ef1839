"""Ills that nobody had listed when they were staged: settings, firewalls, places to record.

The captures are the first seconds of those that lab/measure/unlisted_faults.py makes, without data
of users that do not matter, of `two_networks` without most acknowledgements, and of `server_away`
what the server sends or gets. Hosts are
10.77.0.1 to 10.77.0.4, servers and routers 10.77.0.101 and 10.77.0.102.
"""

import io
import lzma
import re
from dataclasses import replace
from pathlib import Path

import handmade_captures as handmade
import numpy as np
import pandas as pd
import pytest
from support import REFERENCE, check_first_sentence

import discostorm as ds
from discostorm_capture.diagnosis.diagnose import Diagnosis

STAGED = Path(__file__).with_name("captures")


def diagnosis(name: str, expected: int | None = None) -> Diagnosis:
    return ds.read_capture(STAGED / f"{name}.pcap.xz").diagnosis(expected)


@pytest.mark.parametrize(
    ("name", "cause", "evidence", "action"),
    [
        (
            "one_without_server",
            "10.77.0.3 uses a different discovery method than the other hosts",
            "n 10.77.0.3, discovery uses multicast; on 10.77.0.1, 10.77.0.101 and",
            "the same ROS_DISCOVERY_SERVER (or Zenoh router, or peers in CYCLONEDDS_URI)",
        ),
        (
            "humble_beside_jazzy_zenoh",
            "a host behind the router on 10.77.0.101 runs a ROS 2 distribution without type hashes",
            "(RIHS01_df668c740... and TypeHashNotSuppo...)",
            "Run the same ROS 2 distribution on all hosts",
        ),
        (
            "security_seen_from_outside",
            "10.77.0.101 differs from the other hosts in DDS Security, which is enabled on",
            "DDS Security is enabled on 10.77.0.1, 10.77.0.2 and 10.77.0.3",
            "Compare ROS_SECURITY_ENABLE and ROS_SECURITY_KEYSTORE",
        ),
        (
            "localhost_only_any",
            "the programs on 10.77.0.2 use only the loopback interface, so no other host hears",
            "but its DDS processes (2) sent only to themselves (127.0.0.1)",
            "On 10.77.0.2, unset ROS_LOCALHOST_ONLY",
        ),
        (
            "router_alone",
            "the Zenoh router on 10.77.0.101 has sessions only with programs on its own host",
            "but its router exchanged Zenoh messages only with itself (127.0.0.1)",
            "Name the router of another host in connect/endpoints of the router on 10.77.0.101",
        ),
        (
            "number_of_another_server",
            "10.77.0.4 asks for a server number that the server does not have",
            "to 10.77.0.102 with one server number, but the server there has a different number",
            "move the server's address within ROS_DISCOVERY_SERVER",
        ),
        (
            "old_zenoh_version",
            "10.77.0.101 speaks a different version of the Zenoh protocol than the router",
            "it speaks version 8 of the Zenoh protocol, while Zenoh 1.x speaks version 9",
            "Install the same release of Zenoh",
        ),
        (
            "too_few_peer_ports",
            "10.77.0.101 and 10.77.0.3 run more processes than there are ports at which",
            "but other hosts search only at ports 7410 to 7416, by unicast",
            "Raise maxInitialPeersRange",
        ),
        (
            "container_bridge",
            "172.17.0.2 is in the network of containers (172.17.0.0/16 is Docker's default)",
            "and none got an answer from another subnet",
            "`docker run --network host --ipc=host`",
        ),
        (
            "looks_for_routers_only",
            "10.77.0.3 looks only for a Zenoh router, and none answers",
            "10.77.0.3 asked 4 times by multicast for a router, but not for peers",
            "Or make peers connect without a router",
        ),
        (
            "peer_beside_router",
            "10.77.0.3 uses a different discovery method than the other hosts",
            "n 10.77.0.3, discovery uses multicast; on 10.77.0.1, 10.77.0.101 and",
            "the same ROS_DISCOVERY_SERVER (or Zenoh router, or peers in CYCLONEDDS_URI)",
        ),
        (
            "two_servers",
            "10.77.0.3 uses a different server or router than the other hosts",
            "10.77.0.1, 10.77.0.101 and 10.77.0.2; 10.77.0.102 and 10.77.0.3",
            "list the same servers in the same order",
        ),
        (
            "two_routers",
            "10.77.0.3 uses a different server or router than the other hosts",
            "10.77.0.1, 10.77.0.101 and 10.77.0.2; 10.77.0.102 and 10.77.0.3",
            "link the Zenoh routers",
        ),
        (
            "peers_in_two_groups",
            "10.77.0.3 and 10.77.0.4 neither search for the other hosts by multicast nor list",
            "between these groups: 10.77.0.1 and 10.77.0.2; 10.77.0.3 and 10.77.0.4",
            "add 10.77.0.3 and 10.77.0.4 to the peers of the other hosts",
        ),
        (
            "other_base_port",
            "10.77.0.3 uses a different multicast address or port than the other hosts",
            "multicast to 239.255.0.1, port 7500, comes from 10.77.0.3",
            "Give 10.77.0.3 the same multicast address and ports",
        ),
        (
            "other_group",
            "10.77.0.3 uses a different multicast address or port than the other hosts",
            "multicast to 239.255.0.2, port 7400, comes from 10.77.0.3",
            "Give 10.77.0.3 the same multicast address and ports",
        ),
        (
            "domain_tag",
            "the hosts are in different domains",
            "domain 0 (tag 'team') contains 10.77.0.3",
            "set the same ROS_DOMAIN_ID (and domain tag, if any)",
        ),
        (
            "copied_profile",
            "10.77.0.2 and 10.77.0.3 use the same ID, so either they are one host",
            "10.77.0.2 and 10.77.0.3 announce the same ID, 426f74000001000000000002",
            "or the copied `prefix` from the Fast DDS profile",
        ),
        (
            "ports_above_7411",
            "a firewall on 10.77.0.2 leaves too few ports open",
            "other hosts send to ports 7410, 7411 and 7412",
            "On 10.77.0.2, check `ufw status`",
        ),
        (
            "security_on_one",
            "10.77.0.2 differs from the other hosts in DDS Security",
            "DDS Security is enabled on 10.77.0.2 and disabled on 10.77.0.1 and 10.77.0.3",
            "Compare ROS_SECURITY_ENABLE",
        ),
        (
            "loopback_locators",
            "10.77.0.1, 10.77.0.3 and 10.77.0.2 announce only a loopback address",
            "10.77.0.1 announces itself as 127.0.0.1",
            "With Zenoh, set listen/endpoints",
        ),
        (
            "no_incoming_tcp",
            "TCP connections to 10.77.0.3 and 10.77.0.2 get no answer, because a firewall drops",
            "10.77.0.2 to 10.77.0.3 (1 time) and from 10.77.0.3 to 10.77.0.2 (1 time)",
            "On 10.77.0.3 and 10.77.0.2, check `ufw status`",
        ),
        (
            "peers_behind_firewalls",  # each lists the addresses of the others
            "TCP connections to 10.77.0.2 and 10.77.0.3 get no answer, because a firewall drops",
            "10.77.0.3 to 10.77.0.2 (3 times) and from 10.77.0.2 to 10.77.0.3 (1 time)",
            "On 10.77.0.2 and 10.77.0.3, check `ufw status`",
        ),
        (
            "ntp_beside_server",  # all hosts ask the same host for the time
            "10.77.0.4 uses a different discovery method than the other hosts",
            "n 10.77.0.4, discovery uses multicast; on 10.77.0.1, 10.77.0.101,",
            "the same ROS_DISCOVERY_SERVER (or Zenoh router, or peers in CYCLONEDDS_URI)",
        ),
        (
            "robot_with_zenoh",  # its router runs on a host with DDS nodes
            "10.77.0.3 uses a different middleware than the other hosts",
            "10.77.0.1, 10.77.0.101 and 10.77.0.2 speak DDS, and 10.77.0.3 speaks Zenoh",
            "Set the same RMW_IMPLEMENTATION on all hosts",
        ),
        (
            "laptop_without_peers",
            "10.77.0.101 uses a different discovery method than the other hosts",
            "10.77.0.101 looks for others only by multicast, but 10.77.0.1, 10.77.0.2 and",
            "peers in CYCLONEDDS_URI) on all hosts, or none at all",
        ),
        (
            "foreign_arp",
            "another device answers ARP requests for 10.77.0.101, 10.77.0.1 and 10.77.0.3",
            "The MAC address 02:00:00:00:00:fe claims the addresses 10.77.0.101, 10.77.0.1 and",
            "Find the device with this MAC address",
        ),
        (
            "no_multicast_between_clients",  # pings show that the capture has their unicast
            "some packets between 10.77.0.2, 10.77.0.1 and 10.77.0.3 never arrive",
            "10.77.0.1 never answered 10.77.0.2 and 10.77.0.3, nor vice versa",
            "make access points pass multicast between their clients",
        ),
        (
            "address_by_dhcp",
            "10.77.0.3 got another address, but other hosts still look for it at the old one",
            "From 4.1 s on, packets of the same host came from 10.77.0.33 instead of 10.77.0.3",
            "Give this host a fixed address",
        ),
        (
            "data_port_closed",
            "10.77.0.2 receives discovery messages but no data",
            "but none of the",
            "On 10.77.0.2, check `ufw status`",
        ),
        (
            "watch_firewall",  # from 30 s on
            "10.77.0.2 still sends, but no longer answers any host",
            "10.77.0.2 keeps sending, but no longer acknowledges the Heartbeats of 10.77.0.1 (",
            "On 10.77.0.2, check `ufw status`",
        ),
        (
            "fragments_dropped",
            "large packets between 10.77.0.1 and 10.77.0.2 vanish",
            "packets of 1,500 bytes or more do not",
            "Find the largest packet that gets through",
        ),
        (
            "udp_instead_of_tcp",
            "10.77.0.3 uses the wrong port or transport for the server or router",
            "10.77.0.3 tried port 7447 on 10.77.0.101 over UDP",
            "On 10.77.0.3, correct the port and the transport (tcp/, udp/ or tls/)",
        ),
        (
            "peers_without_index",
            "10.77.0.1, 10.77.0.2 and 10.77.0.3 search for each other on ports that",
            "search for each other on ports 7410 to 7426, and each replies with ICMP",
            "Set ParticipantIndex to auto on all hosts",
        ),
        (
            "older_zenoh",
            "10.77.0.3 speaks a different version of the Zenoh protocol",
            "the two ends speak versions 8 and 9 of the Zenoh protocol",
            "Install the same release of Zenoh",
        ),
        (
            "router_between",
            "10.78.0.3 is in a different subnet from the other hosts",
            "announced themselves from different subnets",
            "Give all hosts addresses in one subnet",
        ),
        (
            "pruned_peer",  # the other host had given up before
            "10.77.0.2 neither searches for the other hosts by multicast nor lists them as peers",
            "10.77.0.2 started at 43.3 s, and since then 10.77.0.1 has sent nothing to it",
            "add 10.77.0.2 to the peers of the other hosts",
        ),
        (
            "one_client_lists_number_1",
            "10.77.0.3 asks for a server number that the server does not have",
            "with one server number, but the server there has a different number",
            "On 10.77.0.3, move the server's address within ROS_DISCOVERY_SERVER, so that",
        ),
        (
            "client_behind_firewall",
            "10.77.0.2 receives no unicast, because either a firewall there or the network",
            "10.77.0.2 keeps asking its server for data, but has acknowledged none of",
            "On 10.77.0.2, check `ufw status`",
        ),
        (
            "tls_on_one",
            "10.77.0.3 uses the wrong port or transport for the server or router",
            "10.77.0.3 opened 3 connections to port 7447 on 10.77.0.101",
            "On 10.77.0.3, correct the port and the transport (tcp/, udp/ or tls/)",
        ),
        (
            "tls_to_a_plain_router",  # it tries again after 10 s
            "10.77.0.3 uses the wrong port or transport for the server or router",
            "opened 2 connections to port 7447 on 10.77.0.101, and unlike the others, sent only",
            "On 10.77.0.3, correct the port and the transport (tcp/, udp/ or tls/)",
        ),
        (
            "humble_behind_a_router",
            "10.77.0.3 runs a ROS 2 distribution without type hashes (Humble)",
            "the writer on 10.77.0.1 and the reader on 10.77.0.3 have different definitions",
            "Run the same ROS 2 distribution on all hosts",
        ),
        (
            "isolated_peers_by_tcp",  # an access point that answers ARP requests for its clients
            "the access point isolates its clients from each other (client isolation)",
            "have sessions only with 10.77.0.101, and sent each other connection or ARP req",
            "Turn off client isolation",
        ),
        (
            "router_session_limit",
            "a router rejects the Zenoh sessions of 10.77.0.6 and 10.77.0.7 and accepts others",
            "10.77.0.6 opened 5 connections to port 7447 on 10.77.0.101, and each was closed",
            "raise transport/unicast/max_sessions",
        ),
        (
            "router_forwards_nothing",
            "the Zenoh router on 10.77.0.101 forwards nothing between its clients, as with",
            "10.77.0.101 on different hosts publish and read /odom and /pose, but it sent them",
            "On 10.77.0.101, look at access_control in the router's Zenoh configuration",
        ),
        (
            "routers_apart_on_loopback",  # two hosts exchange packets, and either may have recorded
            "the Zenoh router on 127.0.0.1 (the recording host) has sessions only with programs on",
            "but its router exchanged Zenoh messages only with itself (127.0.0.1)",
            "Name the router of another host in connect/endpoints",
        ),
        (
            "peers_of_one_remote_router",
            "10.77.0.2, 10.77.0.5, 10.77.0.1, 10.77.0.4 and 10.77.0.3 are peers whose router is on",
            "10.77.0.4 and 10.77.0.3 are with 10.77.0.101, which declared nothing of other peers",
            "set mode to client for the nodes on 10.77.0.2, 10.77.0.5, 10.77.0.1, 10.77.0.4 and "
            "10.77.0.3",
        ),
        (
            "laptop_as_peer",  # its router declares endpoints of a client
            "10.77.0.2 is a peer whose router is on another host",
            "sessions of 10.77.0.2 are with 10.77.0.1, which declared nothing of other peers",
            "set mode to client for the nodes on 10.77.0.2, not for a router",
        ),
        (
            "peer_of_a_remote_router",  # nothing is sent for 28 s
            "10.77.0.2 is a peer whose router is on another host",
            "sessions of 10.77.0.2 are with 10.77.0.1, which declared nothing of other peers",
            "set mode to client for the nodes on 10.77.0.2, not for a router",
        ),
        (
            "rviz_as_peer",
            "10.77.0.2 is a peer whose router is on another host",
            "sessions of 10.77.0.2 are with 10.77.0.1, which declared nothing of other peers",
            "set mode to client for the nodes on 10.77.0.2, not for a router",
        ),
        (
            "same_host_number",
            "Fast DDS takes 10.77.0.25 and 10.77.0.107 for one machine",
            "have the same host number (970b), and these processes send each other no unicast",
            "let Fast DDS use only UDP on all but one of them",
        ),
        (
            "index_above_nine",  # on 10.77.0.1, with its loopback interface
            "10.77.0.1 runs more processes than there are ports at which other hosts search",
            "3 of 12 processes exchange messages only with processes on 10.77.0.1 itself; other "
            "hosts search only at ports 7410 to 7426",
            "set MaxAutoParticipantIndex",
        ),
        (
            "addresses_in_vain",  # such as those of Docker and a VPN, each called for 10 s
            "10.77.0.2, 10.77.0.1 and 10.77.0.3 announce addresses that other hosts cannot reach",
            "none answered: 10.77.0.2 (10.8.2.1, 172.22.0.1, 172.32.0.1 and 192.168.182.1), ",
            "set listen/endpoints in the Zenoh configuration to the address in the robots' network",
        ),
        (
            "loopback_on_one_of_three",  # it logs into 10.77.0.1, which announces itself
            "the programs on 10.77.0.3 use only the loopback interface, so no other host hears",
            "but its DDS processes (2) sent only to themselves (127.0.0.1)",
            "On 10.77.0.3, unset ROS_LOCALHOST_ONLY",
        ),
        (
            "two_networks",
            "either the access point isolates its clients from each other (client isolation), or",
            "gets through between them: 10.77.0.3 and 10.77.0.4; 10.77.0.2 and 10.77.0.1",
            "Check whether `ping` works from host to host",
        ),
        (
            "jumbo_frames",
            "large packets between 10.77.0.1 and 10.77.0.2 vanish",
            "10.77.0.2 asked 10.77.0.1 for samples 6 times, but the capture contains none",
            "Find the largest packet that gets through",
        ),
        (
            "server_number",
            "10.77.0.101 is on, but neither answers nor refuses requests to the server there",
            "369 messages from 3 hosts to port 11811 on 10.77.0.101 got no answer",
            "the server's number (`fastdds discovery -i`) equals its position",
        ),
        (
            "no_password",
            "a router or peer rejects every Zenoh session of 10.77.0.3 before it opens",
            "10.77.0.3 opened 8 connections to port 7447 on 10.77.0.101, and each was closed",
            "Compare 10.77.0.3 with a host that works: username and password",
        ),
        (
            "nothing_between_two",
            "some packets between 10.77.0.3 and 10.77.0.4 never arrive",
            "10.77.0.3 and 10.77.0.4 never answered each other",
            "Run `ping` between these hosts",
        ),
        (
            "network_splits",  # from 14 s on
            "some packets between 10.77.0.1, 10.77.0.2, 10.77.0.3 and 10.77.0.4 never arrive",
            "no longer acknowledge Heartbeats: 10.77.0.1 acknowledges none from 10.77.0.3",
            "Run `ping` between these hosts",
        ),
        (
            "server_allow_list",
            "10.77.0.3 gets no answer from a server or router that answers other hosts",
            " times) and got no answer, although 10.77.0.101 answers 10.77.0.1 and 10.77.0.2",
            "allow 10.77.0.3 in the firewall of the server",
        ),
        (
            "router_allow_list",
            "10.77.0.3 gets no answer from a server or router that answers other hosts",
            "10.77.0.3 tried to reach 10.77.0.101 (3 times on TCP port 7447) and got no answer",
            "allow 10.77.0.3 in the firewall of the server",
        ),
        (
            "tcp_is_rejected",
            "TCP connections to 10.77.0.2 and 10.77.0.3 get no answer, because a firewall drops",
            "onnection attempts to the announced TCP port got no answer: from 10.77.0.",
            "On 10.77.0.2 and 10.77.0.3, check `ufw status`",
        ),
        (
            "order_by_source",
            "the writer and reader of a topic have incompatible QoS",
            "/tf: the writer on 10.77.0.1 offers 'by reception', but the reader on 10.77.0.2 asks "
            "for 'by source' (DESTINATION_ORDER_QOS_POLICY)",
            "Run `ros2 topic info --verbose TOPIC`",
        ),
        (
            "other_encoding",
            "the writer and reader of a topic have incompatible QoS",
            "the writer on 10.77.0.1 offers 'XCDR2', but the reader on 10.77.0.2 asks for 'XCDR1'",
            "Run `ros2 topic info --verbose TOPIC`",
        ),
        (
            "other_scouting_port",
            "10.77.0.3 uses a different multicast address or port than the other hosts",
            "multicast to 224.0.0.224, port 7450, comes from 10.77.0.3",
            "(with Zenoh, scouting/multicast/address)",
        ),
        (
            "two_processes_one_id",
            "two processes on 10.77.0.2 use the same ID, so other hosts take them for one process",
            "others know only one process on 10.77.0.2, but send to 2 of its ports",
            "or the copied `prefix` from the Fast DDS profile",
        ),
        (
            "access_point_answers_arp",  # with its own MAC address, for all hosts
            "either the access point isolates its clients from each other (client isolation), or",
            "but no unicast between them (3 pairs) is ever acknowledged",
            "Check whether `ping` works from host to host",
        ),
        (
            "router_behind_firewall",  # which answers ARP, but no call
            "10.77.0.101 is on, but does not answer requests to the server or router there,",
            "3 hosts failed to connect to port 7447 on 10.77.0.101 (9 attempts unanswered)",
            "On 10.77.0.101, check `ufw status` or `nft list ruleset`, and allow the port",
        ),
        (
            "two_servers_with_one_number",  # a client lists the second one as number 1
            "the servers on 10.77.0.1 and 10.77.0.2 have the same number, so clients that list",
            "10.77.0.3 (119 times) asked one of them for another number in vain",
            "Start one of the servers on 10.77.0.1 and 10.77.0.2 with another number",
        ),
        (
            "one_client_distrusts",
            "connections from 10.77.0.3 to the router end before a session begins, unlike those of",
            "5 connections to 10.77.0.101, and each ended before a session began; 10.77.0.1 and",
            "On 10.77.0.3, compare the CA certificate",
        ),
        (
            "multicast_stops_for_all",
            "multicast from 10.77.0.2, 10.77.0.3 and 10.77.0.4 stopped, but unicast goes on",
            "by multicast until 17.2 s, and no more after that, though unicast still comes from",
            "turn an IGMP querier on",
        ),
        (
            "laptop_behind_firewall",  # recorded on the laptop
            "10.77.0.3 hears no other host although packets reach it, most likely because a",
            "so frames do reach it; the capture was recorded there, so they arrived",
            "On 10.77.0.3, check `ufw status`",
        ),
        (
            "laptop_deaf_to_one_robot",  # recorded on the robot, which sees no other pair
            "10.77.0.4 hears no other host although packets reach it, most likely because a",
            "others sent it 384 messages, but it never answered any; it answered 1 ARP requests",
            "On 10.77.0.4, check `ufw status`",
        ),
        (
            "router_elsewhere",  # refused by a host with a client of the router
            "10.77.0.3 looks for a Zenoh router on a host that runs none, while another host runs",
            "10.77.0.4 runs Zenoh, but no router; the router of other hosts is 10.77.0.101",
            "On 10.77.0.3, correct the address of the server, router or peer",
        ),
        (
            "plain_to_tls",
            "10.77.0.3 uses the wrong port or transport for the server or router",
            "sent unencrypted Zenoh messages, to which no Zenoh came back, as from TLS",
            "correct the port and the transport (tcp/, udp/ or tls/)",
        ),
        (
            "uses_docker_interface",
            "172.17.0.1 is the address of Docker's own interface (docker0), so the middleware of",
            "announced themselves from different subnets",
            "On 172.17.0.1, name the interface of the robots' network",
        ),
        (
            "jumbo_frames_of_recorder",  # MTU 9000 on the host that recorded
            "10.77.0.2 sends packets larger than 1500 bytes (jumbo frames), and parts of them",
            "10.77.0.2 sends IP fragments of up to 8,976 bytes; 22 of its datagrams lack fragments",
            "Where the MTU is above 1500 (jumbo frames), set it to 1500 first",
        ),
        (
            "same_id_again",
            "a process on 10.77.0.2 restarted with the ID that it had before, so other hosts",
            "2 writers began to number their samples from 1 again at 20.0 s",
            "remove the copied `id` from the Zenoh configuration, or the copied `prefix`",
        ),
        (
            "topics_without_prefix",
            "10.77.0.4 uses topic names without the prefix of ROS 2, which do not match those of",
            "10.77.0.4 announces fix and gnss/corrections, while 10.77.0.1, 10.77.0.2 and",
            "use the names of ROS 2: the topic `rt/` followed by the name",
        ),
    ],
)
def test_the_first_sentence_has_cause_and_hosts_and_the_action_follows(
    name: str, cause: str, evidence: str, action: str
) -> None:
    found = diagnosis(name)
    check_first_sentence(found.summary(), cause, evidence, action)
    assert len(found.wrong) == 1


@pytest.mark.parametrize(
    ("name", "headline", "action"),
    [
        (
            "peer_typing_error",
            "Other hosts look for 10.77.0.33, but no host has this address.",
            "If 10.77.0.33 should exist, check that it is powered on and connected to this network",
        ),
        (
            "other_namespace",
            "A topic or service has different names at its two ends",
            "At both ends, compare the names",
        ),
        (
            "lone_peer",  # no other node runs
            "10.77.0.2 is a peer whose router announces no endpoints to it",
            "If other nodes are running, set mode to client for the nodes on 10.77.0.2",
        ),
        (
            "two_on_laptop",  # its router tells it of no peer but the one beside it
            "10.77.0.2 is a peer whose router announces no endpoints to it",
            "If other nodes are running, set mode to client for the nodes on 10.77.0.2",
        ),
        (
            "server_away",
            "The server or router on 10.77.0.101 did not answer for a while",
            "Keep the server at 10.77.0.101 running",
        ),
        (
            "planner_not_started",
            "10.77.0.2 calls a service that no host offers",
            "Start the node that offers this service",
        ),
        (
            "rviz_misses_map",
            "10.77.0.3 asks only for new samples (volatile) of a topic whose publisher keeps old",
            "On 10.77.0.3, set the durability of the subscription to transient local",
        ),
        (
            "service_never_answers",
            "10.77.0.1 gets requests of a service again and again, but never replies.",
            "On 10.77.0.1, read the log of the node that offers the service",
        ),
        (
            "use_sim_time_left_on",
            "10.77.0.2 waits for simulation time (/clock), which no host publishes",
            "Set use_sim_time to false for the nodes on 10.77.0.2",
        ),
        (
            "primary_server_dies",
            "One of several servers (on 10.77.0.1) went silent without a goodbye",
            "Keep the server at 10.77.0.1 running",
        ),
        (
            "roams_longer_than_lease",
            "10.77.0.2 lost its connection for a while and came back, although its process kept",
            "Check the radio of 10.77.0.2: roaming",
        ),
        (
            "slow_service",  # with a backlog of requests
            "10.77.0.2 takes seconds to reply to each request of a service",
            "On 10.77.0.2, find what the callback of this service waits for",
        ),
        (
            "log_flood",
            "A process on 10.77.0.2 logs very often, as in a loop with an error",
            "wrote up to 800 messages a second to /rosout. Read what it logs",
        ),
        (
            "healthy_server_update",
            "The server on 10.77.0.102 ended and started again, so all hosts discovered each other",
            "There is nothing to do if you restarted it on purpose",
        ),
        (
            "healthy_domains_on_one_router",  # two teams of three hosts
            "The hosts form fleets in different domains, which do not discover each other",
            "If all hosts should discover each other, set the same ROS_DOMAIN_ID",
        ),
        (
            "access_point_restarts",
            "10.77.0.1, 10.77.0.2 and 10.77.0.3 lost the connection at the same time and came back",
            "Look at the access point, and at the cable or switch behind it",
        ),
        (
            "clouds_by_multicast",  # recorded on a receiver
            "Large samples that 10.77.0.1 sends by multicast arrive only in part",
            "Make 10.77.0.1 send data by unicast",
        ),
        (
            "robot_launched_twice",
            "Two processes on 10.77.0.2 have the same topics and services",
            "On 10.77.0.2, stop one of the two",
        ),
        (
            "cable_pulled",  # no process that ended: its host refuses nothing
            "10.77.0.2 fell silent and no longer answers anything, so it is off or disconnected.",
            "Check whether 10.77.0.2 is on and connected (battery, Wi-Fi, cable)",
        ),
        (
            "robot_router_dies",
            "A process on 10.77.0.2 went silent without a goodbye.",
            "Check the log of 10.77.0.2 for a crash",
        ),
        (
            "laptop_sleeps",  # what was sent to it meanwhile is lost when it wakes, by TCP
            "10.77.0.101 lost its connection for a while and came back, although its process kept",
            "If 10.77.0.101 is a laptop, check for suspend",
        ),
        (
            "bridge_feeds_itself_beside_commander",  # what it repeats are commands
            "10.77.0.3 sends a topic far more often than the other robots send theirs, from a",
            "let it send to another topic or domain",
        ),
        (
            "router_calls_nobody",  # and its host is called by SSH
            "10.77.0.3 looks for a server or router at an address that no host has, while other",
            "On 10.77.0.3, correct the address of the server, router or peer",
        ),
        (
            "script_in_parallel_loops",
            "A process on 10.77.0.5 keeps exiting cleanly and starting again.",
            "such as a script that runs `ros2` commands in a loop, and replace it by one node",
        ),
        (
            "sensor_not_activated",  # the publisher on robot 3 is there, but sends nothing
            "A sensor's topic of 10.77.0.3 is not published, although the other robots publish",
            "is active (`ros2 lifecycle get NODE`)",
        ),
    ],
)
def test_what_may_be_meant_is_said_above_a_healthy_fleet(
    name: str, headline: str, action: str
) -> None:
    found = diagnosis(name)
    assert not found.wrong
    assert found.summary().startswith(headline)
    assert action in found.summary()


@pytest.mark.parametrize(
    ("name", "kind", "host", "evidence", "action"),
    [
        (
            "isolated_zenoh_peers",
            "client isolation",
            "10.77.0.4",
            "have sessions only with 10.77.0.101, and sent each other connection or ARP req",
            "Turn off client isolation (AP isolation)",
        ),
        (
            "server_gets_new_address",
            "new address",
            "10.77.0.101",
            "10.77.0.150 instead of 10.77.0.101; since then, others sent 49 messages",
            "Give this host a fixed address",
        ),
        (
            "firewalld_on_robot2",
            "rejects",
            "10.77.0.2",
            "10.77.0.2 rejected packets 7 times by ICMP as administratively prohibited",
            "On 10.77.0.2, check `ufw status`",
        ),
        (
            "laptop_in_domain_42",  # recorded on the laptop, so that nothing is answered
            "two domains",
            "10.77.0.4",
            "domain 42 contains 10.77.0.4",
            "If all hosts should discover each other, set the same ROS_DOMAIN_ID",
        ),
        (
            "fair_wifi_isolation",  # one host asks for one other by ARP
            "client isolation",
            "10.77.0.4",
            "(10.77.0.4 for 10.77.0.1: 18), but the capture contains no answer",
            "Turn off client isolation (AP isolation)",
        ),
        (
            "guest_wifi",  # Zenoh never gets a connection
            "client isolation",
            "10.77.0.1",
            "though all of these hosts exchange packets with 10.77.0.101",
            "Turn off client isolation (AP isolation)",
        ),
        (
            "laptop_domain_77",  # a router on each host, which tells the endpoints of its host
            "two domains",
            "10.77.0.4",
            "domain 77 contains 10.77.0.4",
            "If all hosts should discover each other, set the same ROS_DOMAIN_ID",
        ),
        (
            "planner_frozen",
            "process hangs",
            "10.77.0.2",
            "10.77.0.2 sent nothing but TCP acknowledgments from 9.0 s on, though others",
            "On 10.77.0.2, find out why the process waits",
        ),
        (
            "static_address_typo",  # it is heard, but hears no other
            "other subnet",
            "10.70.0.3",
            "only hosts in the same subnet answer each other",
            "Give all hosts addresses in one subnet",
        ),
        (
            "second_robot_same_address",  # its only ARP request shows one MAC address
            "same address",
            "10.77.0.2",
            "whose first and last packets are of different processes",
            "Give each host its own address",
        ),
        (
            "arp_is_filtered",  # on host 1: it hears multicast, but no ARP requests of others
            "unicast or ARP dropped",
            "10.77.0.1",
            "10.77.0.1 for 10.77.0.3: 20), so they heard each other",
            "On the access point, turn off client isolation (ap_isolate=0 in hostapd), and filters",
        ),
        (
            "lidar_port_taken",  # on all interfaces of the host that uses the wrong one
            "wrong own interface",
            "192.168.1.5",
            "the host that recorded also has the address 10.77.0.3, in the other hosts' subnet",
            "Run `ip address` on 192.168.1.5, and name the interface of the robots' network",
        ),
        (
            "peers_at_wrong_port",
            "refuses",
            "10.77.0.1",
            "sent packets to port 5100 on 10.77.0.1",
            "Start the server, router or agent on 10.77.0.1 (`ss -lunp`",
        ),
        (
            "cyclone_only_on_usb0",  # two hosts in each subnet
            "interface apart",
            "192.168.186.3",
            "the other hosts exchange packets with 10.77.0.2, too, but it announces nothing",
            "Run `ip address` on 192.168.186.2 and 192.168.186.3",
        ),
        (
            "two_keystores",
            "not authenticated",
            "10.77.0.3",
            "as if each had a CA of its own: 10.77.0.1 and 10.77.0.2; 10.77.0.3",
            "Check that the keys of these hosts come from one keystore",
        ),
        (
            "docker_proxy",
            "no router behind",
            "10.77.0.101",
            "connections to 10.77.0.101 was closed without an answer: ",
            "On 10.77.0.101, check whether the router runs (`docker ps`",
        ),
        (
            "laptop_gets_no_multicast",
            "alone, but connected",
            "10.77.0.4",
            "nothing came from another host except traffic of other programs on 10.77.0.1",
            "Run `ros2 multicast receive` on 10.77.0.4",
        ),
    ],
)
def test_what_is_below_discovery_is_the_first_finding(
    name: str, kind: str, host: str, evidence: str, action: str
) -> None:
    first = diagnosis(name).findings[0]
    assert first.kind == kind
    assert host in first.hosts
    assert evidence in first.evidence
    assert first.advice.startswith(action)


def test_a_third_host_sees_multicast_alone() -> None:
    found = diagnosis("third_host")
    assert found.complete is None
    assert found.summary().startswith("The capture does not show whether discovery is complete")
    assert "as if a third host had recorded it" in found.summary()
    assert "Record again on one of the robots or on the access point" in found.summary()


def test_hosts_that_never_ask_for_each_other_may_not_hear_each_other() -> None:
    found = diagnosis("deaf_to_multicast")
    assert "complete" not in found.summary()
    assert "Only pairs that include 10.77.0.1 discovered each other" in found.summary()
    (finding,) = found.findings
    assert finding.kind == "multicast of one host"
    assert found.healthy is None
    assert found.summary().startswith("Either the access point isolates all hosts except 10.77.0.1")
    assert finding.advice.startswith("Turn off client isolation (AP isolation)")
    assert (
        "works between the other hosts, make the access point and switches forward"
        in finding.advice
    )
    assert "10.77.0.2 and 10.77.0.3 never sent ARP requests for each other" in finding.evidence


@pytest.mark.parametrize(
    ("name", "state", "cause", "action"),
    [
        (
            "images_lose_fragments",  # recorded at the receiver
            "complete, but not healthy: most large samples to 10.77.0.3 are incomplete, because",
            "71 IP datagrams lack fragments: 36 from 10.77.0.2 to 10.77.0.3",
            "datagrams that fit a frame help, too (maxMessageSize 1400",
        ),
        (
            "reader_with_full_window",
            "complete, but not healthy: a program on 10.77.0.4 reads nothing any more from its",
            "told 10.77.0.1 by TCP from 8.7 s to 23.8 s that its receive window is full",
            "On 10.77.0.4, restart this program",
        ),
        (
            "link_drops_images",  # images of 24 Mbit/s on a link of 6 Mbit/s
            "complete, but not healthy: Zenoh drops large samples to or from 10.77.0.2 before",
            "10.77.0.2 began 15 large samples to 10.77.0.101, but left them incomplete, as Zenoh",
            "If a few large samples are enough, let Zenoh finish those that it began",
        ),
        (
            "packets_limited_one_way",
            "complete, but not healthy: many frames to 10.77.0.2 and 10.77.0.3 are lost, but",
            "nearly all of these were sent to 10.77.0.2 and 10.77.0.3",
            "look for what limits packets: flood protection",
        ),
        (
            "busy_computer",  # the process runs for 0.2 s of every 2 s
            "complete, but not healthy: a process on 10.77.0.2 pauses again and again",
            "10.77.0.2 went silent 6 times for 1.5 s to 3.1 s, while others",
            "On 10.77.0.2, run `top`",
        ),
        (
            "weak_link_of_one_of_five",  # over all hosts, little is lost
            "complete, but not healthy: many frames to and from 10.77.0.3 are lost, as on a weak",
            "17 of 2271 captured frames with samples or TCP segments were requested again",
            "Check the radio link of 10.77.0.3",
        ),
        (
            "weak_wifi",  # 30% of the packets to and from host 3 are dropped
            "complete, but not healthy: many frames to and from 10.77.0.3 are lost",
            "100% of the resent frames were to or from 10.77.0.3 (about 21% of its 248 frames)",
            "Check the radio link of 10.77.0.3",
        ),
        (
            "image_by_multicast",
            "complete, but not healthy: 10.77.0.1 sends so much data by multicast",
            "10.77.0.1 sends /camera/image_raw by multicast; this topic takes 59% of the paper's",
            "Make 10.77.0.1 send data by unicast (set AllowMulticast to spdp in Cyclone DDS)",
        ),
        (
            "multicast_is_lossy",
            "complete, but not healthy: some multicast is lost",
            "10.77.0.3 heard 10.77.0.1",
            "Find out why frames are lost",
        ),
    ],
)
def test_what_harms_a_complete_discovery_is_told(
    name: str, state: str, cause: str, action: str
) -> None:
    said = diagnosis(name).summary()
    assert said.startswith(f"Discovery is {state}")
    assert 0 < said.index(cause) < said.index(action)


def test_a_loop_in_the_network_comes_before_the_loss_that_it_causes() -> None:
    first, second = diagnosis("network_loop").findings
    assert (first.kind, second.kind) == ("network loop", "heavy loss")
    assert "99% of the multicast packets are copies of earlier ones" in first.evidence


def test_who_has_one_peer_only_may_not_know_the_others() -> None:
    found = diagnosis("star_of_peers")
    assert found.healthy is None
    assert "10.77.0.2, 10.77.0.3 and 10.77.0.4 never sent ARP requests for each" in found.summary()
    assert "If you recorded on 10.77.0.1, record on the access point" in found.summary()
    assert "list all hosts as peers on every host" in found.summary()


def test_who_asks_anew_after_an_outage_lost_nothing() -> None:
    (first,) = diagnosis("access_point_reboots").findings
    assert (first.kind, len(first.hosts)) == ("forgotten", 4)


def test_sessions_that_break_come_before_the_segments_that_are_lost_then() -> None:
    first, second = diagnosis("sessions_are_reset").findings
    assert (first.kind, second.kind) == ("sessions break", "unacknowledged")
    assert first.evidence.startswith(
        "10.77.0.3 opened 4 sessions with 10.77.0.101 between 0.0 s and"
    )


def test_a_late_joiner_without_contact_points_at_multicast_that_stopped() -> None:
    first = diagnosis("multicast_stops").findings[0]
    assert (first.kind, first.hosts) == ("multicast stopped", ("10.77.0.4",))
    assert "multicast may have stopped since" in first.evidence
    assert "turn an IGMP querier on, or turn IGMP snooping off" in first.advice


def test_a_host_without_multicast_is_missing() -> None:
    first = diagnosis("one_without_multicast", 3).findings[0]
    assert first.kind == "too few hosts"
    assert "the capture shows 2 of 3 expected hosts" in first.evidence


def test_one_mac_address_of_two_hosts_comes_before_the_loss_that_it_causes() -> None:
    first, *others = diagnosis("same_mac").findings
    assert (first.kind, first.hosts) == ("duplicate MAC", ("10.77.0.2", "10.77.0.3"))
    assert "have the MAC address 02:00:00:00:00:02" in first.evidence
    assert {one.kind for one in others} <= {"heavy loss", "loss"}


def test_what_may_be_on_purpose_is_an_event_of_a_healthy_fleet() -> None:
    for name, kind, host, advice in (
        ("service_without_domain", "process alone", "10.77.0.1", "the same ROS_DOMAIN_ID"),
        ("healthy_two_teams", "two fleets", "10.77.0.4", "the same ROS_DOMAIN_ID"),
        ("healthy_two_zenoh_teams", "two fleets", "10.77.0.4", "the same ROS_DOMAIN_ID"),
        (
            "no_free_participant_index",
            "no free index",
            "10.77.0.2",
            "set MaxAutoParticipantIndex",
        ),
    ):
        found = diagnosis(name)
        (first,) = found.findings
        assert (found.healthy, first.kind, first.about) == (True, kind, "event")
        assert host in first.hosts
        assert advice in found.summary()


@pytest.mark.parametrize(
    ("name", "kind", "host", "advice"),
    [
        ("nine_of_ten_indices", "no free index", "10.77.0.2", "set MaxAutoParticipantIndex"),
        ("teleop_without_namespace", "topic names", "10.77.0.101", "the namespaces of the nodes"),
    ],
)
def test_the_recording_host_sees_an_event_of_a_healthy_fleet(
    name: str, kind: str, host: str, advice: str
) -> None:
    found = diagnosis(name)
    first, other = found.findings
    assert (found.healthy, first.kind, first.about) == (True, kind, "event")
    assert other.kind == "view of one host"
    assert host in first.hosts
    assert advice in found.summary()


def test_the_times_in_samples_show_a_clock_that_is_not_set() -> None:
    found = diagnosis("clock_not_set")
    (first,) = found.findings
    assert (found.complete, first.kind, first.hosts) == (True, "clock differs", ("10.77.0.3",))
    assert first.evidence.endswith("10.77.0.3's clock is 90 minutes behind the others")
    assert "Set the clock on 10.77.0.3" in found.summary()


def test_a_sample_that_is_sent_again_does_not_set_the_clock_back() -> None:
    capture = ds.read_capture(STAGED / "clock_not_set.pcap.xz")
    events = capture._network_events
    times = events["kind"].eq("time stamp") & events["sender"].eq("10.77.0.3")
    old = events.loc[times, "port"].iloc[0] + 5400 - 60
    repeats = events.assign(port=events["port"].where(~times, old))
    assert replace(capture, _network_events=repeats).diagnosis().findings == ()


def test_a_sensor_that_no_node_publishes_is_named_unless_no_robot_publishes_it() -> None:
    capture = ds.read_capture(STAGED / "sensor_not_activated.pcap.xz")
    ends = capture._endpoints
    scans = ends["topic"].str.endswith("/scan") & ends["writer"].eq(other=True)
    mute = ends["topic"].eq("rt/robot3/scan")
    (found,) = replace(capture, _endpoints=ends[~(scans & mute)]).diagnosis().findings
    assert found.evidence == (
        "/robot3/scan is read by 10.77.0.101, but has no publisher; "
        "/robot1/scan and /robot2/scan have one"
    )
    assert replace(capture, _endpoints=ends[~scans]).diagnosis().findings == ()


def test_a_router_that_passes_on_a_part_of_the_samples_is_named() -> None:
    found = diagnosis("router_limits_rate")
    (one,) = found.findings
    assert found.healthy
    assert (one.kind, one.hosts) == ("samples skipped", ("10.77.0.101",))
    assert "10.77.0.102 sent 10.77.0.101 only a part of these samples: 5 of 37 of" in one.evidence
    assert "look for downsampling and low_pass_filter" in one.advice


@pytest.mark.parametrize(
    ("name", "sender", "to", "wrong"),
    [
        ("netmask_of_one_host", "10.77.0.3", "10.77.0.101", "fe, but those of 10.77.0.101"),
        ("stale_arp_entry", "10.77.0.101", "10.77.0.2", "99, but those of 10.77.0.2 come"),
    ],
)
def test_packets_to_a_foreign_mac_address_come_before_the_pair_that_they_part(
    name: str, sender: str, to: str, wrong: str
) -> None:
    first, second = diagnosis(name).wrong
    assert (first.kind, first.hosts) == ("wrong MAC", (sender,))
    assert f"from {sender} to {to} go to the MAC address 02:00:00:00:00:{wrong}" in first.evidence
    assert second.kind == "one direction of pairs"


def test_a_process_that_speaks_from_another_address_is_named_with_both() -> None:
    (found,) = diagnosis("robot_leaves_its_dock").findings
    assert (found.kind, found.hosts) == ("new address", ("10.77.0.2",))
    assert "10.77.0.52 instead of 10.77.0.2; since then, others sent" in found.evidence


@pytest.mark.parametrize(
    ("name", "kind", "host", "evidence"),
    [
        ("two_maps", "several maps", "10.77.0.1", "10.77.0.102 and 10.77.0.1 publish /map"),
        (
            "loop_without_pause",
            "busy topic",
            "10.77.0.2",
            "/robot2/joint_states 583 times a second; other robots send theirs at most 11 times",
        ),
        ("service_in_a_loop", "many calls", "10.77.0.102", "/robot3/get_state (service) 57 times"),
    ],
)
def test_sources_that_contradict_each_other_or_send_too_much_are_events(
    name: str, kind: str, host: str, evidence: str
) -> None:
    found = diagnosis(name)
    (one,) = found.findings
    assert found.healthy
    assert (one.kind, host in one.hosts, evidence in one.evidence) == (kind, True, True)


def test_who_calls_a_router_too_early_and_gives_up_is_not_behind_a_firewall() -> None:
    (found,) = diagnosis("robot_starts_before_router").findings
    assert (found.kind, found.hosts) == ("called early", ("10.77.0.3",))
    assert "was refused and did not try again; 10.77.0.101 answers" in found.evidence
    assert "restart the nodes. Start the router before them" in found.advice


@pytest.mark.parametrize(
    ("name", "times"), [("computer_stalls", "11 times, for 0.8 s"), ("flow_control", "11 times")]
)
def test_samples_in_bursts_show_a_stalling_or_throttled_sender(name: str, times: str) -> None:
    found = diagnosis(name)
    (one,) = found.findings
    assert (one.kind, one.hosts, found.complete) == ("bursts", ("10.77.0.2",), True)
    assert f"all writers on 10.77.0.2 paused together {times}" in one.evidence
    assert "run `top`" in one.advice
    assert "flow control (throughputController" in one.advice


def test_who_announces_too_often_is_told_to_set_the_period_back() -> None:
    (found,) = diagnosis("announces_too_often").findings
    assert (found.kind, found.hosts) == ("announces often", ("10.77.0.3",))
    assert "set the announcement period back: leaseAnnouncement" in found.advice


def test_nodes_that_started_before_their_network_are_restarted() -> None:
    everyone = ("10.77.0.1", "10.77.0.2", "10.77.0.3", "10.77.0.101")
    capture = ds.read_capture(STAGED / "starts_before_network.pcap.xz")
    (found,) = capture.diagnosis(everyone).wrong
    assert (found.kind, found.hosts) == ("missing, late network", ("10.77.0.3",))
    assert "but it sent its first packet only at 4.7 s" in found.evidence
    assert "restart the nodes" in found.advice


def test_the_one_host_with_another_transport_is_named() -> None:
    (found,) = diagnosis("data_by_tcp").findings
    assert (found.kind, found.hosts) == ("transports differ", ("10.77.0.2",))


def test_a_lifespan_explains_why_a_late_reader_gets_nothing() -> None:
    found = diagnosis("samples_expire")
    (one,) = [one for one in found.findings if one.kind != "late joiner"]
    assert (one.kind, one.hosts, found.healthy) == ("expired samples", ("10.77.0.2",), True)
    assert "/robot2/map: 10.77.0.2 keeps each sample for 3 s" in one.evidence
    assert "lifespan in the QoS of the publisher on 10.77.0.2 infinite" in one.advice


def test_hosts_behind_a_repeater_are_healthy() -> None:
    assert [*diagnosis("behind_a_repeater").findings] == []


@pytest.mark.parametrize(
    ("name", "kind", "host", "evidence", "action"),
    [
        (
            "guest_downloads",
            "crowded by a device",
            "10.77.0.60",
            "mainly to 10.77.0.60",
            "move it to another Wi-Fi",
        ),
        (
            "plotter_freezes",
            "process hangs",
            "10.77.0.102",
            "refused none of 544 messages, but its system sent other packets until 21.7 s",
            "find out why the process waits",
        ),
        (
            "readers_alone_announced",
            "half",
            "10.77.0.3",
            "the built-in endpoints of 10.77.0.3 announce only writers or only readers",
            "remove simpleEDP",
        ),
        (
            "messages_grow",
            "stream on a slow link",
            "10.77.0.2",
            "samples of /robot2/trail from 10.77.0.2 to 10.77.0.101 take 6% of the paper's channel",
            "shorten messages that grow",
        ),
    ],
)
def test_what_disturbs_a_fleet_is_named_first(
    name: str, kind: str, host: str, evidence: str, action: str
) -> None:
    first = diagnosis(name).findings[0]
    assert (first.kind, first.hosts) == (kind, (host,))
    assert evidence in first.evidence
    assert action in first.advice


@pytest.mark.parametrize(
    ("name", "kind", "host", "evidence", "action"),
    [
        (
            "ssh_session_ends",
            "ended together",
            "10.77.0.2",
            "2 processes on 10.77.0.2 ended within a second, but the host sent packets until",
            "If the nodes on 10.77.0.2 were started in an SSH session",
        ),
        (
            "switch_port_blocks",
            "deaf at first",
            "10.77.0.3",
            "but the first packet from another host came at 17.7 s",
            "make the switch port of 10.77.0.3 an edge port (PortFast)",
        ),
    ],
)
def test_what_happens_to_one_host_is_an_event(
    name: str, kind: str, host: str, evidence: str, action: str
) -> None:
    found = diagnosis(name)
    assert found.healthy
    (one,) = [one for one in found.findings if one.kind == kind]
    assert (one.hosts, evidence in one.evidence, action in one.advice) == ((host,), True, True)


def test_packets_that_are_late_to_several_hosts_have_one_cause() -> None:
    (found,) = diagnosis("channel_is_full").findings
    assert (found.kind, found.hosts) == ("late deliveries", ("10.77.0.1", "10.77.0.2", "10.77.0.3"))
    assert "to 10.77.0.1, from 10.77.0.101 to 10.77.0.2 and from 10.77.0.101 to" in found.evidence
    assert found.advice.startswith("Look for what fills the channel")


def test_late_pings_beside_an_upload_show_a_crowded_link() -> None:
    (found,) = diagnosis("upload_fills_link").wrong
    assert (found.kind, found.hosts) == ("crowded link", ("10.77.0.2",))
    assert "mainly to 10.77.0.102" in found.evidence
    assert "and from 10.77.0.101 to 10.77.0.2 waited at least" in found.evidence


def test_appended_files_do_not_set_the_clocks_of_hosts_back(tmp_path: Path) -> None:
    names = ("lease_never_ends", "humble_beside_jazzy")  # the second was recorded first
    later, earlier = (lzma.decompress((STAGED / f"{n}.pcap.xz").read_bytes()) for n in names)
    path = tmp_path / "both.pcap"
    path.write_bytes(later + earlier[24:])
    kinds = {finding.kind for finding in ds.read_capture(path).diagnosis().findings}
    assert "clock back" in kinds
    assert not kinds & {"clock steps", "clock differs"}


@pytest.mark.parametrize(
    "name",
    [
        "healthy_port_scan",  # a host that speaks neither DDS nor Zenoh tries port 7447, too
        "healthy_two_interfaces",  # announces an address of Docker, too
        "healthy_cable_and_wifi",  # one host has two addresses in the network
        "healthy_server_and_data",  # a server sends samples only to those that they concern
        "topics_of_1_hz",  # one host pauses for just over a second, again and again
        "healthy_best_effort_reader",  # answers no Heartbeat
        "healthy_peers_of_hub",  # the router's lease is long, so that it says little
        "healthy_syslog",  # to a host where no server for it runs
        "healthy_delay_of_a_second",  # who asks again has not yet got what was sent
    ],
)
def test_nothing_is_found_in_healthy_fleets(name: str) -> None:
    found = diagnosis(name)
    assert found.healthy
    assert found.findings == ()


def test_commands_in_a_loop_are_an_event_of_a_healthy_fleet() -> None:
    found = diagnosis("shell_loop")
    assert (found.healthy, found.findings[0].kind) == (True, "command loop")
    assert "said goodbye 7 times, about every 2.6 s" in found.summary()
    assert "Find what keeps starting a short-lived program on 10.77.0.1" in found.summary()


def test_a_participant_that_fast_dds_disposes_of_without_its_key_has_left() -> None:
    found, *others = diagnosis("command_in_a_loop").findings
    assert (found.kind, found.hosts) == ("command loop", ("10.77.0.4",))
    assert "said goodbye 6 times, about every 2.0 s" in found.evidence
    assert others == []


def test_an_outage_explains_the_frames_that_are_lost_in_it() -> None:
    found = diagnosis("outage_of_3_s")
    assert [one.kind for one in found.findings] == ["outages"]
    assert found.summary().startswith("10.77.0.2 lost its connection for a while and came back")
    assert "10.77.0.2 sent nothing from 7.7 s to 10.8 s (others sent it" in found.summary()


def test_late_acknowledgments_of_tcp_show_a_radio_that_sleeps() -> None:
    (found,) = diagnosis("power_save_zenoh").wrong
    assert (found.kind, found.hosts) == ("late delivery", ("10.77.0.2",))
    assert "from 10.77.0.101 to 10.77.0.2 waited at least 249 ms longer" in found.evidence
    assert "Turn off power saving on 10.77.0.2" in found.advice


def test_packets_that_come_in_bursts_after_pauses_show_a_radio_that_scans() -> None:
    (found,) = diagnosis("wifi_scans").wrong
    assert (found.kind, found.hosts) == ("held back", ("10.77.0.2",))
    assert "sent nothing 3 times for 1.3 s to 1.3 s" in found.evidence
    assert "stop background scans of the Wi-Fi radio" in found.advice


@pytest.mark.parametrize(
    ("name", "missing", "kind", "evidence", "action"),
    [
        (
            "laptop_in_another_subnet",
            "10.78.0.5",
            "missing, other subnet",
            "10.78.0.5 sent other packets",
            "Let nodes on 10.78.0.5 and on the other hosts",
        ),
        (
            "name_of_router_unknown",
            "10.77.0.3",
            "missing, unknown name",
            "DNS replied to 10.77.0.3 (20 times) that a name does not exist",
            "On 10.77.0.3, check the name of the server, router or peer",
        ),
    ],
)
def test_why_a_host_is_missing_is_told_if_its_packets_show_it(
    name: str, missing: str, kind: str, evidence: str, action: str
) -> None:
    capture = ds.read_capture(STAGED / f"{name}.pcap.xz")
    (found,) = capture.diagnosis(sorted({"10.77.0.1", "10.77.0.2", missing})).wrong
    assert (found.kind, found.hosts) == (kind, (missing,))
    assert evidence in found.evidence
    assert action in found.advice


@pytest.mark.parametrize(
    ("name", "summary", "advice"),
    [
        (
            "robot_loses_power",
            "10.77.0.2 vanished without a goodbye and came back with new processes",
            "look at its power (battery, undervoltage",
        ),
        (
            "robot_slows_down",
            "A process on 10.77.0.3 sends its topics much more slowly than before",
            "On 10.77.0.3, check whether the processor is throttled or overloaded",
        ),
    ],
)
def test_events_of_a_computer_are_told_apart_from_those_of_a_process(
    name: str, summary: str, advice: str
) -> None:
    found = diagnosis(name)
    assert found.summary().startswith(summary)
    assert advice in found.summary()
    assert not found.wrong


def test_several_hosts_with_weak_links_are_named() -> None:
    (found,) = diagnosis("two_weak_links").wrong
    assert (found.kind, found.hosts) == ("weak link", ("10.77.0.3", "10.77.0.4"))


def test_participants_that_pile_up_are_no_storm() -> None:
    (found,) = diagnosis("participants_pile_up").wrong
    assert (found.kind, found.hosts) == ("processes pile up", ("10.77.0.2",))
    assert "Create one and reuse it" in found.advice


def test_where_all_hosts_lose_alike_the_channel_is_the_cause() -> None:
    (found,) = diagnosis("all_lose_alike").wrong
    assert (found.kind, found.hosts) == ("channel loss", ())
    assert (
        "per host: 10.77.0.1 (10%), 10.77.0.2 (10%), 10.77.0.3 (10%) and 10.77.0.4 (7%)"
        in found.evidence
    )
    assert found.advice.startswith("The cause is the channel rather than one host")


def test_the_link_of_the_host_that_recorded_may_be_the_weak_one() -> None:
    found = diagnosis("weak_link_of_recorder").wrong[0]
    assert (found.kind, found.hosts) == ("weak link", ("10.77.0.101",))
    assert "Check the radio link of 10.77.0.101" in found.advice


def test_replies_that_are_errors_are_no_replies() -> None:
    (found,) = diagnosis("service_replies_by_errors").findings
    assert (found.kind, found.hosts) == ("no Zenoh reply", ("10.77.0.2",))
    assert "10 requests of /robot2/is_path_valid (service); it replied to 0" in found.evidence


def test_two_servers_with_one_number_come_before_the_one_that_is_down() -> None:
    first, second = diagnosis("servers_with_one_number").wrong
    assert (first.kind, first.hosts) == ("same server number", ("10.77.0.101", "10.77.0.102"))
    assert "10.77.0.1 (220 times) and 10.77.0.3 (93 times) asked one of them" in first.evidence
    assert "with another number (`fastdds discovery -i 1`)" in first.advice
    assert (second.kind, second.hosts) == ("server down", ("10.77.0.101",))


def test_multicast_that_ends_explains_a_host_that_is_missing() -> None:
    first, second = diagnosis("multicast_stops_for_all", 5).wrong
    assert (first.kind, second.kind) == ("multicast ends", "too few hosts")


def test_senders_by_multicast_are_ranked_and_the_largest_topic_is_named() -> None:
    first = diagnosis("three_send_by_multicast").findings[0]
    assert (first.kind, first.hosts[0], len(first.hosts)) == ("data by multicast", "10.77.0.1", 3)
    assert first.evidence.endswith("most bytes are of /robot1/camera/image_raw")


def test_programs_that_broadcast_much_are_an_event() -> None:
    seen = ds.read_capture(STAGED / "healthy_dual_stack.pcap.xz")
    events = seen._network_events.astype({"kind": str, "sender": str, "receiver": str})
    own = {"kind": "other traffic", "sender": "10.77.0.1", "receiver": "10.77.0.255"}
    sent = events.iloc[[0]].assign(**own, port=4_000_000)
    found = replace(seen, _network_events=pd.concat([events, sent])).diagnosis()
    (event,) = found.findings
    assert (found.healthy, event.kind, event.hosts) == (True, "much broadcast", ("10.77.0.1",))
    assert "Mbit/s to 10.77.0.255" in event.evidence
    assert "for MAVROS, set gcs_url to udp:// with an address" in event.advice


def test_few_losses_of_few_frames_are_no_slow_link() -> None:
    found = diagnosis("healthy_camera_with_few_losses")
    assert (found.healthy, found.findings[0].kind) == (True, "some loss")


def test_a_best_effort_reader_that_answers_no_samples_is_not_behind_a_firewall() -> None:
    found = diagnosis("healthy_best_effort_seen_late")  # the endpoints were announced before
    assert found.wrong == ()
    assert "capture began late" in {one.kind for one in found.findings}


def test_a_capture_on_another_interface_does_not_show_what_other_hosts_exchange() -> None:
    kinds = [one.kind for one in diagnosis("cyclone_only_on_usb0").wrong]
    assert kinds == ["interface apart"]  # and not that the two laptops never answer each other


def test_writers_that_need_no_confirmation_do_not_show_power_saving() -> None:
    # It confirms the topic of one writer, which sends once a second.
    assert diagnosis("healthy_confirms_every_second").wrong == ()


def test_a_full_window_of_another_program_is_none_of_zenoh() -> None:
    seen = ds.read_capture(STAGED / "reader_with_full_window.pcap.xz")
    (finding,) = seen.diagnosis().findings
    assert finding.kind == "reads nothing"
    events = seen._network_events
    frames = events["frame"].where(events["kind"].ne("full window"), 10**6)
    assert replace(seen, _network_events=events.assign(frame=frames)).diagnosis().findings == ()


def test_who_only_checks_whether_the_port_of_a_router_is_open_speaks_no_tls() -> None:
    seen = ds.read_capture(STAGED / "tls_to_a_plain_router.pcap.xz")
    events = seen._network_events
    sent = events["kind"].eq("arrived") & events["sender"].eq("10.77.0.3")
    assert replace(seen, _network_events=events[~sent]).diagnosis().wrong == ()


@pytest.mark.parametrize(
    "kind",
    ["unanswered", "connection", "exchange"],
)
def test_further_addresses_harm_only_if_they_alone_are_called_in_vain(kind: str) -> None:
    seen = ds.read_capture(STAGED / "addresses_in_vain.pcap.xz")
    events = seen._network_events.astype({"kind": str, "sender": str, "receiver": str})
    call = events[events["kind"].eq("unanswered")].sort_values("time").iloc[[0]]
    call = call.assign(kind=kind, receiver="10.77.0.2", time=call["time"] + 1.0)
    found = replace(seen, _network_events=pd.concat([events, call])).diagnosis()
    hosts = [one.hosts for one in found.findings if one.kind == "unreachable locators"]
    assert hosts == [("10.77.0.1", "10.77.0.3")]


def test_downloads_beside_an_old_session_are_no_rejected_sessions() -> None:
    found = diagnosis("healthy_downloads_seen_late")
    kinds = {one.kind for one in found.findings}
    assert (found.wrong, kinds) == ((), {"capture began late", "view of one host"})


def test_a_router_that_refuses_a_session_has_not_left() -> None:
    found = diagnosis("two_clients_with_one_id")
    assert [one.kind for one in found.findings] == ["processes with one id"]
    assert re.search(r"; 10.77.0.101 closed \d+ of their sessions", found.findings[0].evidence)


def test_calls_between_other_hosts_show_that_the_capture_has_their_unicast() -> None:
    found = diagnosis("peers_behind_firewalls")  # only one of three has sessions
    assert [one.kind for one in found.findings] == ["no TCP"]


def test_hosts_that_started_before_the_capture_need_not_ask_by_arp() -> None:
    found = diagnosis("healthy_recorded_late")
    assert {one.about for one in found.findings} == {"capture"}
    assert "isolation" not in found.summary()


def test_a_fleet_with_odd_but_sound_services_shutdowns_and_routers_is_healthy() -> None:
    found = diagnosis("healthy_services")  # one client waits for a server, and a host pauses
    assert (found.healthy, [one.kind for one in found.findings]) == (
        True,
        ["late joiner", "waits for server"],
    )
    night = diagnosis("healthy_night_shutdown")  # withdrawn endpoints stay readable
    assert (night.healthy, {one.kind for one in night.findings}) == (True, {"left"})


def test_frames_that_a_switch_floods_do_not_hide_where_the_capture_was_recorded() -> None:
    found = diagnosis("healthy_flooded_frames")  # some are between two robots
    assert found.healthy
    assert [one.hosts for one in found.findings if one.kind == "view of one host"] == [
        ("10.77.0.101",)
    ]


def test_the_address_of_a_vpn_does_not_hide_where_the_capture_was_recorded() -> None:
    found = diagnosis("healthy_vpn_beside")  # robots send to the VPN's address of the laptop, too
    assert found.healthy
    assert [one.hosts for one in found.findings] == [("10.77.0.101",)]


def test_a_server_restart_that_one_client_recorded_is_none_of_the_client() -> None:
    first = diagnosis("healthy_server_restart").findings[0]
    assert (first.kind, first.hosts) == ("server restarted", ("10.77.0.102",))


def test_a_computer_that_answers_once_more_while_it_goes_down_restarted() -> None:
    first = diagnosis("computer_reboots").findings[0]
    assert (first.kind, first.hosts) == ("host restarted", ("10.77.0.2",))
    assert "look at its power" in first.advice


def test_dds_may_stay_on_a_host_that_has_a_bridge() -> None:
    capture = ds.read_capture(STAGED / "localhost_only_any.pcap.xz")
    bridge = capture._processes.iloc[:1].rename(index=lambda name: f"{name}00")
    bridge = bridge.assign(protocol="Zenoh", product="Zenoh client", host="10.77.0.2")
    both = replace(capture, _processes=pd.concat([capture._processes, bridge]))
    assert not {one.kind for one in both.diagnosis().findings} & {"loopback only", "router alone"}


def test_commands_that_come_and_go_leave_no_pair_open() -> None:
    found = diagnosis("healthy_commands_in_a_script")
    assert (found.healthy, found.findings[0].kind) == (True, "command loop")


def test_a_reader_that_blocks_a_writer_is_named() -> None:
    first = diagnosis("reader_blocks_writer").findings[0]
    assert (first.kind, first.hosts) == ("slow reader", ("10.77.0.1",))
    assert "a reader on 10.77.0.101 joined at 6.8 s" in first.evidence
    assert "Stop that reader" in first.advice


def test_a_laptop_that_left_need_not_know_the_one_that_came() -> None:
    found = diagnosis("healthy_shift_change")  # both send commands, one after the other
    assert (found.healthy, [one.kind for one in found.findings]) == (
        True,
        ["left", "late joiner"],
    )


def test_a_host_that_was_not_counted_as_a_server_is_named() -> None:
    (first,) = diagnosis("healthy_router_on_each", 4).wrong  # recorded on one robot
    assert first.evidence.endswith("not counting 10.77.0.1, which seems to be a server")
    assert diagnosis("healthy_router_on_each", 3).healthy


def test_much_data_by_unicast_stands_above_a_healthy_fleet() -> None:
    capture = ds.read_capture(STAGED / "healthy_dual_stack.pcap.xz")
    rows = capture._messages
    frames = rows["frames"].where(~rows["kind"].isin(["User data", "Push"]), np.float32(600))
    found = replace(capture, _messages=rows.assign(frames=frames)).diagnosis()
    assert (found.healthy, [one.kind for one in found.findings]) == (True, ["much data"])
    assert found.summary().startswith("User data needs more airtime than the paper's channel has, ")


def test_two_fleets_of_which_one_keeps_the_default_domain_are_a_fault() -> None:
    seen = ds.read_capture(STAGED / "healthy_two_teams.pcap.xz")
    seen._processes["domain"] = seen._processes["domain"].replace(11, 0)
    found = seen.diagnosis()
    assert [finding.kind for finding in found.findings] == ["two domains"]
    assert not found.healthy


def test_the_router_of_each_group_is_named_unless_a_domain_separates_them() -> None:
    seen = ds.read_capture(STAGED / "two_routers.pcap.xz")
    (found,) = seen.diagnosis().wrong
    assert found.evidence.endswith(
        "For 10.77.0.3, the server or router is 10.77.0.102; for the other hosts, it is 10.77.0.101"
    )
    domains = seen._processes["host"].map({"10.77.0.1": 0, "10.77.0.2": 0, "10.77.0.3": 7})
    domains = domains.fillna(-1).astype(int)
    apart = replace(seen, _processes=seen._processes.assign(domain=domains)).diagnosis()
    assert [one.kind for one in apart.wrong] == ["two domains"]


def test_in_a_fleet_of_routers_the_group_without_a_link_is_named() -> None:
    seen = ds.read_capture(STAGED / "two_routers.pcap.xz")
    routers = seen._processes.assign(server=True)
    (found,) = replace(seen, _processes=routers).diagnosis().wrong
    assert found.hosts == ("10.77.0.102", "10.77.0.3")


@pytest.mark.parametrize(
    ("name", "kind", "host", "evidence", "action"),
    [
        (
            "copies_to_other_addresses",
            "copies",
            "10.77.0.4",
            "10.77.0.4 also announces 172.17.0.1, 10.8.0.6 and 192.168.50.20; 10.77.0.3, 10.77.0.2 "
            "and 10.77.0.1 sent 117 messages with samples there (74% of the bytes",
            "name the interface of the robots' network",
        ),
        (
            "bridge_feeds_itself",
            "feeds itself",
            "10.77.0.3",
            " times a second, and the same process reads it; other robots send theirs at most 1",
            "look for a bridge, relay or republisher that reads this topic",
        ),
        (
            "router_denies_all",
            "silent router",
            "10.77.0.1",
            "10.77.0.1 got declarations from other routers, but sent neither declarations nor "
            "samples; 10.77.0.4 read robot1/odom and robot1/scan, which no process in the capture",
            "look at access_control in the router's Zenoh configuration",
        ),
    ],
)
def test_an_event_beside_complete_discovery_is_named(
    name: str, kind: str, host: str, evidence: str, action: str
) -> None:
    found = diagnosis(name)
    assert (found.healthy, found.findings[0].kind, found.findings[0].hosts) == (True, kind, (host,))
    assert evidence in found.findings[0].evidence
    assert action in found.findings[0].advice


def test_a_short_capture_does_not_show_that_announcements_end() -> None:
    kinds = {one.kind for one in diagnosis("images_lose_fragments").findings}  # of 3.4 s
    assert "multicast ends" not in kinds


def test_an_outage_of_the_access_point_does_not_end_announcements() -> None:
    assert diagnosis("access_point_restarts").findings[0].kind == "network outage"


def test_without_an_arp_reply_the_network_may_be_what_delivers_nothing() -> None:
    seen = ds.read_capture(
        REFERENCE / "captures/ills/firewall_on_one_host-cyclone_dds_0_10.pcap.xz"
    )
    events = seen._network_events[~seen._network_events["kind"].isin(["ARP reply"])]
    (found,) = replace(seen, _network_events=events).diagnosis().wrong
    assert (found.kind, found.hosts) == ("firewall or network", ("10.77.0.2",))
    assert "or the network delivers none to it" in found.summary


def test_parts_of_samples_that_are_lost_and_repaired_at_once_do_no_harm() -> None:
    found = diagnosis("small_socket_buffer")
    assert (found.healthy, [one.kind for one in found.findings]) == (True, ["repaired bursts"])
    slow = ds.read_capture(STAGED / "small_socket_buffer.pcap.xz")
    acks = slow._messages["submessage"].eq("ACKNACK")
    rows = slow._messages.assign(time=slow._messages["time"] + 0.15 * acks).sort_values("time")
    assert replace(slow, _messages=rows).diagnosis().findings[0].kind == "burst loss"


def test_a_path_on_which_nothing_arrives_shows_no_size() -> None:
    kinds = {one.kind for one in diagnosis("packets_limited_one_way").findings}
    assert "large packets" not in kinds


def test_a_router_without_readers_of_missing_topics_is_no_finding() -> None:
    seen = ds.read_capture(STAGED / "router_denies_all.pcap.xz")
    ends = seen._endpoints[~seen._endpoints["topic"].astype(str).str.startswith("robot1/")]
    assert replace(seen, _endpoints=ends).diagnosis().findings == ()


def test_groups_between_which_only_unicast_passes_are_told() -> None:
    first = diagnosis("multicast_within_groups").findings[0]
    assert (first.kind, len(first.hosts)) == ("multicast filtered", 3)
    assert first.evidence.endswith(
        "never from one to the other: 10.77.0.3, 10.77.0.5 and 10.77.0.4; 10.77.0.2 and 10.77.0.1; "
        "unicast passes, such as between 10.77.0.1 and 10.77.0.3"
    )
    assert "make the access point and switches pass multicast" in first.advice.lower()


@pytest.mark.parametrize(
    ("name", "skipped"),
    [
        ("night_shutdown", 3.0),
        ("shift_change", 0.5),
        ("shift_change", 3.0),
        ("late_and_leaving", 3.0),
    ],
)
def test_a_healthy_fleet_has_no_fault_if_the_capture_began_late(name: str, skipped: float) -> None:
    frames = handmade.packets(f"healthy_{name}", STAGED)
    later = [frame for frame in frames if frame[0] - frames[0][0] >= skipped * 1e9]
    assert not ds.read_capture(io.BytesIO(handmade.pcap(later))).diagnosis().wrong


def test_a_late_joiner_shows_that_others_had_started_before_the_capture() -> None:
    found = diagnosis("late_joiner_in_a_late_capture")  # the others announce themselves to it again
    kinds = {one.kind: one for one in found.findings}
    assert kinds["late joiner"].hosts == ("10.77.0.4",)
    assert kinds["capture began late"].evidence.startswith("3 of 4 processes")
    assert found.complete is None


def test_a_reader_that_asks_once_and_gets_nothing_more_has_no_share_of_losses() -> None:
    assert diagnosis("losses_of_one_sample").findings  # once, a division by zero


def test_losses_of_a_stream_in_large_datagrams_are_told_with_their_fragments() -> None:
    kinds = {one.kind: one for one in diagnosis("fragments_fill_memory").findings}
    found = kinds["stream in parts"]
    assert found.evidence.endswith("a datagram has up to 45 IP fragments")
    assert "datagrams that fit a frame help" in found.advice


def test_a_process_at_a_searched_port_will_be_found_later() -> None:
    frames = handmade.packets("index_above_nine", STAGED)
    mine, laptop = bytes.fromhex("0110d6e1915fcf402d3408fb"), bytes([10, 77, 0, 2])
    # As if one of the processes that the laptop finds had just started.
    kept = [frame for frame in frames if not (mine in frame[1] and laptop in frame[1])]
    found = ds.read_capture(io.BytesIO(handmade.pcap(kept, link=276))).diagnosis()
    assert len(kept) < len(frames)
    assert not found.wrong


def test_announcements_that_nobody_takes_are_no_talk_of_before_the_capture() -> None:
    found = diagnosis("peers_at_wrong_port")
    assert [one.kind for one in found.findings] == ["refuses"]
    assert "or in the initial peers of a profile" in found.findings[0].advice
