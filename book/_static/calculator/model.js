// Made from the package by `make calculator` with sympy 1.14.0; do not edit.
const DISCOSTORM = (() => {
const s1 = "Nav2 in one process";
const s2 = "Cyclone DDS, version 11";
const s3 = "Products as built";
const s4 = "Products with mitigations";
const s5 = "As the paper counts";
const s6 = "The paper's messages, a product's periods";
const s7 = "Proposals and other tables";
const s8 = "a whole number of at least 1 and at most 1,000,000,000";
const s9 = "a number of at least 0 and at most 1,000,000,000";
const s10 = "a number above 0";
const s11 = "a number of at least 0";
const s12 = "paper (802.11n)";
const s13 = "multicast rate";
const s14 = "sending multicast at 24 instead of 6 Mbit/s";
const s15 = 144444444.44444445;
const s16 = {"R_uni": s15, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s17 = {"name": s12, "model": "padded", "values": s16};
const s18 = "802.11n 20 MHz 2x2, multicast 24 Mbit/s";
const s19 = {"R_uni": s15, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s20 = "another radio (802.11n 40 MHz 2x2)";
const s21 = "802.11n 40 MHz 2x2";
const s22 = {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s23 = {"name": s21, "model": "padded", "values": s22};
const s24 = "another radio (802.11ac 80 MHz 2x2)";
const s25 = "802.11ac 80 MHz 2x2";
const s26 = 866666666.6666666;
const s27 = {"R_uni": s26, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s28 = {"name": s25, "model": "padded", "values": s27};
const s29 = "another radio (802.11ax 160 MHz 2x2)";
const s30 = "802.11ax 160 MHz 2x2";
const s31 = 2401960784.3137255;
const s32 = {"R_uni": s31, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s33 = {"name": s30, "model": "padded", "values": s32};
const s34 = {
"name": "802.11n 20 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s15, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s35 = "802.11a 20 MHz 1x1";
const s36 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s37 = {"name": s35, "model": "padded", "values": s36};
const s38 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s39 = "802.11g 20 MHz 1x1";
const s40 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s41 = "sending multicast at 24 instead of 1 Mbit/s";
const s42 = {"name": s39, "model": "padded", "values": s40};
const s43 = "802.11n 20 MHz 2x2";
const s44 = {"name": s43, "model": "padded", "values": s16, "full": s34, "simulated": "n"};
const s45 = {"R_uni": s15, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0};
const s46 = {
"name": "802.11n 40 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s47 = {"name": s21, "model": "padded", "values": s22, "full": s46, "simulated": null};
const s48 = {
"name": "802.11ac 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s26, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
};
const s49 = {"name": s25, "model": "padded", "values": s27, "full": s48, "simulated": "ac"};
const s50 = {
"name": "802.11ax 160 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s31, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
};
const s51 = {"name": s30, "model": "padded", "values": s32, "full": s50, "simulated": null};
const s52 = "802.11n 20 MHz 2x2, 2.4 GHz";
const s53 = {"R_uni": s15, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s54 = {
"name": "802.11n 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s15, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s55 = {"name": s52, "model": "padded", "values": s53, "full": s54, "simulated": null};
const s56 = "802.11ax 20 MHz 2x2, 2.4 GHz";
const s57 = 286764705.88235295;
const s58 = {"R_uni": s57, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s59 = {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s57, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
};
const s60 = {"name": s56, "model": "padded", "values": s58, "full": s59, "simulated": null};
const s61 = "802.11ax 80 MHz 2x2";
const s62 = 1200980392.1568627;
const s63 = {"R_uni": s62, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s64 = {
"name": "802.11ax 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s62, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
};
const s65 = {"name": s61, "model": "padded", "values": s63, "full": s64, "simulated": null};
const s66 = "802.11be 80 MHz 2x2";
const s67 = 1441176470.5882354;
const s68 = {"R_uni": s67, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s69 = {
"name": "802.11be 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s67, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
};
const s70 = {"name": s66, "model": "padded", "values": s68, "full": s69, "simulated": null};
const s71 = "802.11be 320 MHz 2x2";
const s72 = 5764705882.3529415;
const s73 = {"R_uni": s72, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s74 = {
"name": "802.11be 320 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s72, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
};
const s75 = "inside_unicast";
const s76 = "linear_unicast";
const s77 = "padded_unicast";
const s78 = "padded_multicast";
const s79 = "aggregated_unicast";
const s80 = "new or reconfigured radios";
const s81 = "the full gain needs full A-MPDUs; a queue may hold fewer frames for one receiver";
const s82 = {"efforts": ["radio"], "effort": 6, "takes": s80, "best_case": true, "cost": s81, "mind": s81};
const s83 = "a configuration file";
const s84 = "a failed robot is noticed later, and a lost announcement is repeated later";
const s85 = "discovery server";
const s86 = "one more program";
const s87 = "each robot needs its address; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less";
const s88 = "discovery server on a robot";
const s89 = "parameters can no longer be set from outside; nodes of others, such as Nav2's, must be rebuilt; we count a service as in DDS";
const s90 = {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": s89, "mind": s89};
const s91 = "another middleware";
const s92 = "all hosts must change together";
const s93 = {"efforts": ["switch"], "effort": 7, "takes": s91, "best_case": false, "cost": s92, "mind": s92};
const s94 = "all hosts must change together; we count peers that scout by multicast; the paper does not count the tokens of rmw_zenoh";
const s95 = ["switch", "server"];
const s96 = "another middleware and one more program";
const s97 = "all hosts must change together; each robot needs its address; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less";
const s98 = "multicast endpoint data";
const s99 = ["switch", "file"];
const s100 = "another middleware and a configuration file";
const s101 = "all hosts must change together; multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later";
const s102 = "all hosts must change together; you must know the addresses beforehand; every announcement goes to 9 ports of every address, with ROS_STATIC_PEERS to 32";
const s103 = "all hosts must change together; you must know the addresses beforehand; a process that dials a peer before it is up may dial it every 4 s indefinitely";
const s104 = "router on each host";
const s105 = ["switch", "servers"];
const s106 = "another middleware and several more programs";
const s107 = "star of routers";
const s108 = "static endpoints";
const s109 = "all hosts must change together; whoever adds an endpoint must list it in every file, and ROS 2's own endpoints too; Fast DDS 2.9.1 can crash";
const s110 = "two discovery servers";
const s111 = "multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later";
const s112 = "hosts too far away for this rate cannot join; no multicast or management frame may use a lower rate";
const s113 = {"efforts": ["setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": s112, "mind": s112};
const s114 = "you must know the addresses beforehand; every announcement goes to 9 ports of every address, with ROS_STATIC_PEERS to 32";
const s115 = "you must know the addresses beforehand; a process that dials a peer before it is up may dial it every 4 s indefinitely";
const s116 = {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "only nodes built as components can be composed", "mind": "only nodes built as components can be composed; one crash ends all composed nodes of that host"};
const s117 = "all hosts and the access point need this radio and must be close enough for its rate";
const s118 = {"efforts": ["radio"], "effort": 6, "takes": s80, "best_case": false, "cost": s117, "mind": s117};
const s119 = "several more programs";
const s120 = "discovery is complete no earlier than the last host starts";
const s121 = {"efforts": ["setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": s120, "mind": s120};
const s122 = "whoever adds an endpoint must list it in every file, and ROS 2's own endpoints too; Fast DDS 2.9.1 can crash";
const s123 = "hostapd.conf of the access point";
const s124 = "for every process";
const s125 = "Fast DDS 2.9.1";
const s126 = "Cyclone DDS 0.10.2 and 11.0.1";
const s127 = "on a computer that is wired to the access point";
const s128 = "on every robot";
const s129 = {
"where": s128,
"version": s125,
"text": "# Fast DDS 2.9.1: on every robot\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: run\n# in the shell or put in the service file that starts the ROS 2 processes, before they start\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\n",
};
const s130 = {
"where": "for ros2 tools, of any version",
"version": s125,
"text": "<!-- Fast DDS 2.9.1: for ros2 tools, of any version -->\n<!-- Load: save as /etc/fast_dds_tools.xml; ros2 and its daemon run with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds_tools.xml and without ROS_DISCOVERY_SERVER -->\n<!-- (from Fast DDS 3.0 on, so in ROS 2 Kilted: FASTDDS_DEFAULT_PROFILES_FILE); begin with ros2 -->\n<!-- daemon stop -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"super_client\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SUPER_CLIENT</discoveryProtocol>\n            <discoveryServersList>\n              <RemoteServer prefix=\"44.53.00.5f.45.50.52.4f.53.49.4d.41\">\n                <metatrafficUnicastLocatorList>\n                  <locator>\n                    <udpv4>\n                      <address>192.168.1.10</address>\n                      <port>11811</port>\n                    </udpv4>\n                  </locator>\n                </metatrafficUnicastLocatorList>\n              </RemoteServer>\n            </discoveryServersList>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
};
const s131 = {
"where": "for ros2 tools, of versions that read it",
"version": "ROS 2 Jazzy",
"text": "# ROS 2 Jazzy: for ros2 tools, of versions that read it\n# Load: both are environment variables of ros2 and its daemon: export them in the shell of\n# the tools, then ros2 daemon stop\n# Not run here: compared with its documentation\n# Fast DDS reads ROS_SUPER_CLIENT from 2.6.7 on (ROS 2 Humble), 2.10.3 (Iron) and 2.13.0 (Jazzy and\n# later). Older ones, such as 2.9.1, ignore it: take the profile of a SUPER_CLIENT.\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\nexport ROS_SUPER_CLIENT=TRUE\n",
};
const s132 = "on every computer";
const s133 = {
"where": s127,
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: on a computer that is wired to the access point\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s134 = {
"where": "for every process of a robot",
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: for every process of a robot\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n{\n  mode: \"peer\",\n  connect: { endpoints: [\"tcp/localhost:7447\"] },\n  listen: { endpoints: [\"tcp/localhost:0\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: {\n      target: { router: [\"router\", \"peer\"], peer: [\"router\"] },\n      autoconnect_strategy: { peer: { to_router: \"always\", to_peer: \"greater-zid\" } },\n    },\n  },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s135 = "a Discovery Server";
const s136 = "both values are of Fast DDS's measured model";
const s137 = "Fast DDS Discovery Server";
const s138 = [s85, s135, s136, s137, "Fast DDS", s85];
const s139 = "two Discovery Servers";
const s140 = "Fast DDS Discovery Server, two";
const s141 = [s110, s139, s136, s140, "Fast DDS", s110];
const s142 = "a Discovery Server on a robot";
const s143 = "Fast DDS Discovery Server, on a robot";
const s144 = [s88, s142, s136, s143, "Fast DDS", s88];
const s145 = [s108, s108, s136, s108, "Fast DDS", s108];
const s146 = "both values are of Cyclone DDS's measured model";
const s147 = "Cyclone DDS peers";
const s148 = ["peers", "static peers", s146, s147, "Cyclone DDS", "peers"];
const s149 = "multicast SEDP announcements";
const s150 = "Cyclone DDS multicast SEDP";
const s151 = [s98, s149, s146, s150, "Cyclone DDS", s98];
const s152 = [1, "within a second at best"];
const s153 = [Infinity, "leases at risk"];
const s154 = "never catches up";
const s155 = {"until": [s152, [Infinity, "slow at best"], s153], "never": s154};
const s156 = {"second": 1, "ever": Infinity};
const s157 = {"count": "count", "more": ["more", "more2"]};
const s158 = [s157, s157, s157];
const s159 = {"count": "count2", "more": ["more3", "more4", "more5"]};
const s160 = [s159, s159, s159];
const s161 = {"count": "count3", "more": ["more6", "more7", "more8"]};
const s162 = [s161, s161, s161];
const s163 = {"burst": 1, "second": 1, "ever": 0};
const s164 = "a central router";
const s165 = "both values are of Zenoh peer with tokens's measured model";
const s166 = "Zenoh peer, tokens";
const s167 = ["router", s164, s165, "Zenoh router", s166, "router"];
const s168 = "a router on each host";
const s169 = "Zenoh router per host";
const s170 = [s104, s168, s165, s169, s166, s104];
const s171 = "a router on each host plus a wired router";
const s172 = "Zenoh router per host, star";
const s173 = [s107, s171, s165, s172, s166, s107];
const s174 = "--ds-family-zenoh";
const s175 = [s158, s162, s160];
const s176 = ["KeepAlive", "unicast", 84, 1, 1, 2, "up down", s163];
const s177 = "switching to Fast DDS with a Discovery Server";
const s178 = "middleware and discovery server";
const s179 = "switching to Fast DDS with two Discovery Servers";
const s180 = "middleware and two discovery servers";
const s181 = "switching to Fast DDS with a Discovery Server on a robot";
const s182 = "middleware and discovery server on a robot";
const s183 = "switching to Fast DDS with static endpoints";
const s184 = "middleware and static endpoints";
const s185 = "switching to Zenoh with a central router";
const s186 = "middleware and router";
const s187 = "switching to Zenoh with a router on each host";
const s188 = "middleware and router on each host";
const s189 = "switching to Zenoh with a router on each host plus a wired router";
const s190 = "middleware and star of routers";
const s191 = "a longer announcement interval";
const s192 = "switching to Cyclone DDS, version 11";
const s193 = "switching to Fast DDS";
const s194 = "switching to Fast DDS 2.6";
const s195 = "switching to Fast DDS 2.14";
const s196 = "switching to Fast DDS 3.6";
const s197 = "switching to Zenoh peer, tokens";
const s198 = "on a network that it takes for Wi-Fi: multicast for SPDP alone (measured with 0.10.2)";
const s199 = "--ds-product-cyclone-dds";
const s200 = [
[1, 1.67, 11.3, "In 15 swarms within that range, each left out of the fit, discovery took 0.68 to 1.18 times the airtime of the model (typical error 7%). We expect 88% of such swarms in this range"],
[2, 1.67, 11.3, "In 4 swarms of up to twice that range, each left out of the fit, discovery took 0.99 to 1.33 times the airtime of the model (typical error 12%). So few swarms give no interval"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints, each left out of the fit, discovery took 1.31 to 1.47 times the airtime of the model (typical error 39%). So few swarms give no interval"],
];
const s201 = {"until": [s152, [10, "slow at best"], s153], "never": s154};
const s202 = {"second": 1, "lease": 10, "ever": Infinity};
const s203 = {"count": "count4", "more": ["more9", "more10", "more11", "more12"]};
const s204 = [s203, s203, s203];
const s205 = {"count": "count5", "more": ["more13", "more14", "more15", "more16"]};
const s206 = [s205, s205, s205];
const s207 = {"count": "count6", "more": []};
const s208 = [s207, {"count": "count7", "more": ["more17", "more18", "more19"]}, {"count": "count8", "more": ["more20", "more21", "more22"]}];
const s209 = [s158, s162, s160, s204, s206, s208, [s207, {"count": "count9", "more": ["more23", "more24", "more25", "more26"]}, {"count": "count10", "more": ["more27", "more28", "more29", "more30"]}]];
const s210 = {"burst": 1.9875, "second": 2.1125, "lease": 0.32375, "ever": 0.125};
const s211 = {"burst": 0.9875, "second": 1.1125, "lease": 0.22375, "ever": 0.125};
const s212 = {"burst": 4, "second": 4, "lease": 0.4, "ever": 0};
const s213 = 972.4761045987376;
const s214 = {"burst": 1, "second": 1, "lease": 0.1, "ever": 0};
const s215 = 154.45158821278227;
const s216 = "Heartbeat of data";
const s217 = 187.0099502487562;
const s218 = "ACKNACK for others";
const s219 = 179.99005799502902;
const s220 = {"burst": 0, "second": 0.125, "lease": 0.125, "ever": 0.125};
const s221 = ["Liveliness", "unicast", s219, 0.7242, 1, 1, "up down", s220];
const s222 = "Liveliness at start";
const s223 = 190.54725731648807;
const s224 = "Liveliness for others";
const s225 = "Liveliness Heartbeat";
const s226 = 180.02610587382162;
const s227 = [s225, "unicast", s226, 0.2758, 1, 1, "up down", s220];
const s228 = "Liveliness Heartbeat at start";
const s229 = 153.8987676056338;
const s230 = "Liveliness ACKNACK";
const s231 = [s230, "unicast", 128, 1, 1, 1, "up down", s220];
const s232 = "Liveliness ACKNACK at start";
const s233 = 181.3784494086728;
const s234 = "Liveliness ACKNACK for others";
const s235 = "Type lookup Heartbeat";
const s236 = 129.08962679988247;
const s237 = "Type lookup ACKNACK";
const s238 = 195.20030291556228;
const s239 = "Type lookup ACKNACK for others";
const s240 = "User Heartbeat";
const s241 = 139.31615175284134;
const s242 = "User Heartbeat for others";
const s243 = 182.43195266272187;
const s244 = "User ACKNACK for others";
const s245 = "Cyclone DDS, wired";
const s246 = "switching to Cyclone DDS";
const s247 = "on a network that it takes for wired, with three processes or more: multicast for SEDP and control, too (measured with 0.10.2)";
const s248 = [[1, 1, 1, "In 7 swarms within that range, each left out of the fit, discovery took 0.95 to 1.13 times the airtime of the model (typical error 5%). We expect 75% of such swarms in this range"]];
const s249 = [s158, s162, s160, s206, s208];
const s250 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s210];
const s251 = 493.08762420957544;
const s252 = 1167.7479630635523;
const s253 = "SEDP multicast";
const s254 = 961.6660682226212;
const s255 = "Heartbeat multicast";
const s256 = 201.42013994523882;
const s257 = 199.39703903095557;
const s258 = 150.79816322270926;
const s259 = "Liveliness unicast";
const s260 = 245.09790605546124;
const s261 = "Liveliness Heartbeat unicast";
const s262 = 234.05196032120926;
const s263 = 187.1920199501247;
const s264 = 224.96579476861166;
const s265 = "Type lookup Heartbeat unicast";
const s266 = 230.92749087115283;
const s267 = 230.46065100947672;
const s268 = "User Heartbeat multicast";
const s269 = 232.6802973977695;
const s270 = 226.06745510293473;
const s271 = "as Cyclone DDS, with type information in SEDP (measured with 11.0.1)";
const s272 = [
[1, 1.67, 11.3, "In 11 swarms within that range, each left out of the fit, discovery took 0.72 to 1.13 times the airtime of the model (typical error 9%). We expect 83% of such swarms in this range"],
[2, 1.67, 11.3, "In 2 swarms of up to twice that range, each left out of the fit, discovery took 1.15 to 1.24 times the airtime of the model (typical error 20%). So few swarms give no interval"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints, each left out of the fit, discovery took 1.28 to 1.48 times the airtime of the model (typical error 38%). So few swarms give no interval"],
];
const s273 = 432.2946357085669;
const s274 = 726.2444541104828;
const s275 = 153.93607305936075;
const s276 = 186.8277247614264;
const s277 = 187.05568338702255;
const s278 = 156.2517609634174;
const s279 = 190.87976752633492;
const s280 = 132.5107047976246;
const s281 = 204.12578616352204;
const s282 = 133.94982078853047;
const s283 = 167.8055937643283;
const s284 = "AllowMulticast=false, all hosts as Peers, ParticipantIndex=auto and MaxAutoParticipantIndex=9, its default (measured with 0.10.2)";
const s285 = [[1, 1, 1, "In 7 swarms within that range, each left out of the fit, discovery took 0.94 to 1.33 times the airtime of the model (typical error 5%). We expect 75% of such swarms in this range"]];
const s286 = {"count": "count11", "more": ["more31", "more32", "more2"]};
const s287 = [s286, s286, s286];
const s288 = {"count": "count12", "more": ["more33", "more34", "more35"]};
const s289 = [s288, s288, s288];
const s290 = [s287, s289, s162, s160, s204, s206, s208];
const s291 = "ICMP unreachable";
const s292 = {"burst": 1, "second": 1.125, "lease": 0.225, "ever": 0.125};
const s293 = 442.0177243557095;
const s294 = 1224.46511627907;
const s295 = 334.84114485689287;
const s296 = 150.13620569840168;
const s297 = 191.25372354324537;
const s298 = 180.00607650876952;
const s299 = 170.0050484920951;
const s300 = 179.9840521928235;
const s301 = 156.0150305307656;
const s302 = 190.60377358490564;
const s303 = 134.67330119732546;
const s304 = 185.2367491166078;
const s305 = 147.20074005550418;
const s306 = 166.51716247139586;
const s307 = "AllowMulticast=true, as it chooses on a network that it takes for wired: of three processes or more (measured with 0.10.2)";
const s308 = [[1, 1, 1, "In 7 swarms within that range, each left out of the fit, discovery took 0.91 to 1.10 times the airtime of the model (typical error 8%). We expect 75% of such swarms in this range"]];
const s309 = 492.4140969162995;
const s310 = 1040.4988009592325;
const s311 = 965.8901890189019;
const s312 = 215.89285714285714;
const s313 = 213.31594018453706;
const s314 = 200.7060146149522;
const s315 = 180.02209944751382;
const s316 = 152.05954502568403;
const s317 = 510.6666666666667;
const s318 = 179.94202898550725;
const s319 = 201.4570446735395;
const s320 = 219.65142364106987;
const s321 = 186.30392156862746;
const s322 = 207.01075268817203;
const s323 = 249.3997682502897;
const s324 = 210.50383141762453;
const s325 = 176.79097672186225;
const s326 = 122.00209989500526;
const s327 = 167.19174466042716;
const s328 = "switching to Cyclone DDS with static peers";
const s329 = "middleware and peers";
const s330 = "switching to Cyclone DDS with multicast SEDP announcements";
const s331 = "middleware and multicast endpoint data";
const s332 = "--ds-product-fast-dds";
const s333 = {"until": [s152, [20, "slow at best"], s153], "never": s154};
const s334 = {"second": 1, "lease": 20, "ever": Infinity};
const s335 = {"count": "count13", "more": ["more36", "more37", "more38"]};
const s336 = {"count": "count14", "more": ["more39", "more40"]};
const s337 = [s336, s336, s336];
const s338 = {"count": "count16", "more": ["more44", "more45", "more5"]};
const s339 = {"count": "count17", "more": ["more46", "more47", "more38"]};
const s340 = [s207, s339, s339];
const s341 = [s158, [s207, s335, s335], s337, [s207, {"count": "count15", "more": ["more41", "more42", "more43"]}, s338], s340, s208];
const s342 = "SPDP to server";
const s343 = 0.3333333333333333;
const s344 = {"burst": 5.833333333333333, "second": 6.166666666666666, "lease": 0.625, "ever": s343};
const s345 = "SPDP of server";
const s346 = {"burst": 0.5, "second": 0.8333333333333333, "lease": 0.35833333333333334, "ever": s343};
const s347 = "SPDP of server at discovery";
const s348 = 748.3930635838151;
const s349 = {"burst": 1, "second": 1, "lease": 0.05, "ever": 0};
const s350 = "SPDP of others";
const s351 = 683.9365973934484;
const s352 = "SPDP Heartbeat";
const s353 = "SPDP Heartbeat of server";
const s354 = 250.29586195342605;
const s355 = "SPDP Heartbeat of others";
const s356 = 354.98051539912007;
const s357 = "SPDP ACKNACK of others";
const s358 = "SPDP ACKNACK of server";
const s359 = 204.14209591474247;
const s360 = "SEDP to server";
const s361 = "SEDP of others";
const s362 = 655.9962112242481;
const s363 = "Heartbeat of server";
const s364 = "Heartbeat of others";
const s365 = 451.4893977947413;
const s366 = "ACKNACK of others";
const s367 = "ACKNACK of server";
const s368 = 205.97133664814274;
const s369 = "Liveliness Heartbeat to server";
const s370 = "Liveliness Heartbeat of server";
const s371 = [s225, "unicast", 192, 1, 4, 1.292, "up down", s349];
const s372 = "Liveliness ACKNACK to server";
const s373 = "Liveliness ACKNACK of server";
const s374 = [s230, "unicast", 188, 1, 4, 1.292, "up down", s349];
const s375 = [s240, "unicast", 192, 1, 5, 1.021, "up down", s349];
const s376 = ["User ACKNACK", "unicast", 188, 1, 5, 1.021, "up down", s349];
const s377 = {"count": "count18", "more": ["more48", "more2"]};
const s378 = {"count": "count19", "more": ["more49", "more50", "more38"]};
const s379 = {"count": "count20", "more": ["more51", "more40"]};
const s380 = "with UDP and shared memory, as shipped and as ROS 2 sets it (measured with 2.9.1)";
const s381 = "this release answers each request for repeats at once, which the simulation leaves out. On an emulated cell without aggregation, 8 small robots were not done after 15 s instead of 3.2 s";
const s382 = [
[1, 1.67, 11.3, "In 11 swarms within that range, each left out of the fit, discovery took 0.91 to 1.04 times the airtime of the model (typical error 3%). We expect 83% of such swarms in this range"],
[2, 1.67, 11.3, "In 2 swarms of up to twice that range, each left out of the fit, discovery took 0.95 to 1.22 times the airtime of the model (typical error 13%). So few swarms give no interval"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints, each left out of the fit, discovery took 2.06 to 2.29 times the airtime of the model (typical error 118%). So few swarms give no interval"],
];
const s383 = {"count": "count23", "more": ["more56", "more57", "more8"]};
const s384 = [s383, s383, s383];
const s385 = [s158, s384, s162, s206, s160, s208];
const s386 = "SPDP at discovery";
const s387 = 4.833333333333333;
const s388 = 5.166666666666666;
const s389 = {"burst": s387, "second": s388, "lease": 0.575, "ever": s343};
const s390 = "SPDP unicast at discovery";
const s391 = "SPDP unicast for others";
const s392 = 852.6666666666666;
const s393 = "Heartbeat for others";
const s394 = "ACKNACK of data";
const s395 = [[1, 1, 1, "In 19 swarms within that range, each left out of the fit, discovery took 0.86 to 1.68 times the airtime of the model (typical error 14%). We expect 90% of such swarms in this range"]];
const s396 = 773.5594083028471;
const s397 = "ROS discovery info";
const s398 = "ROS Heartbeat for others";
const s399 = "ROS ACKNACK for others";
const s400 = [[1, 1, 1, "In 16 swarms within that range, each left out of the fit, discovery took 0.89 to 1.17 times the airtime of the model (typical error 5%). We expect 88% of such swarms in this range"]];
const s401 = [s158, s162, s160, s208, s206];
const s402 = 1014.7323568575234;
const s403 = [[1, 1, 1, "In 32 swarms within that range, each left out of the fit, discovery took 0.88 to 1.47 times the airtime of the model (typical error 5%). We expect 94% of such swarms in this range"]];
const s404 = [s158, s162, s160, s208, [s207, s207, s207], s206];
const s405 = 896.8584995251663;
const s406 = 189.68085535606212;
const s407 = 808.8594208980277;
const s408 = "--ds-basis-proposal";
const s409 = {"until": [s152, [23, "slow at best"], s153], "never": s154};
const s410 = {"second": 1, "lease": 23, "ever": Infinity};
const s411 = {"count": "count24", "more": ["more58", "more35"]};
const s412 = [s411, s411, s411];
const s413 = {"count": "more35", "more": ["more35"]};
const s414 = [s413, s413, s413];
const s415 = {"burst": 1, "second": 1, "lease": 0.043478260869565216, "ever": 0};
const s416 = ["Announce", "multicast", 80, 1, 0, 1, "up down", s415];
const s417 = ["Process", "multicast", 24, 0, 1, 1, "up down", s415];
const s418 = ["Endpoint", "multicast", 20, 0, 2, 1, "up down", s415];
const s419 = ["Digest", "multicast", 80, 1, 3, 1, "up down", s415];
const s420 = ["Listed", "multicast", 1, 0, 0, 1, "up down", s415];
const s421 = {"burst": 0, "second": s343, "lease": s343, "ever": s343};
const s422 = ["Heartbeat", "multicast", 80, 1, 0, 1, "up down", s421];
const s423 = ["Claimed", "multicast", 0.125, 0, 4, 1, "up down", s421];
const s424 = {"count": "count25", "more": ["count25"]};
const s425 = "switching to DDS, periods of Cyclone DDS";
const s426 = "DDS, periods of Cyclone DDS";
const s427 = "DDS, periods of Fast DDS";
const s428 = "switching to Zenoh, periods of Zenoh peer";
const s429 = "Zenoh, periods of Zenoh peer";
const s430 = "switching to DDS, periods of Fast DDS";
const s431 = "--ds-product-zenoh";
const s432 = {"burst": 3.125, "second": 3.25, "lease": 0.4375, "ever": 0.125};
const s433 = {"burst": 0, "second": 0.4, "lease": 0.4, "ever": 0.4};
const s434 = ["KeepAlive", "unicast", 84, 1, 1, 1, "up down", s433];
const s435 = "Fast DDS with endpoints that are known in advance (static EDP), participants announced as ever (measured with 2.9.1)";
const s436 = [[1, 1, 1, "In 10 swarms within that range, each left out of the fit, discovery took 0.95 to 1.31 times the airtime of the model (typical error 5%). We expect 82% of such swarms in this range"]];
const s437 = [s338, s338, s338];
const s438 = {"count": "count26", "more": ["more59", "more60"]};
const s439 = {"count": "count27", "more": ["more61", "more62", "more63"]};
const s440 = [s158, s384, s337, s162, s206, s160, s437, [s438, s438, s438], s204, [s439, s439, s439], s208];
const s441 = "SPDP of endpoints";
const s442 = "SPDP unicast of endpoints";
const s443 = "Listed at discovery";
const s444 = "Listed of endpoints";
const s445 = "Listed unicast";
const s446 = "Listed unicast at discovery";
const s447 = "Listed unicast for others";
const s448 = "Listed unicast of endpoints";
const s449 = "peers, each linked with each other (measured with 1.10.2)";
const s450 = [[1, 1, 1, "In 10 swarms within that range, each left out of the fit, discovery took 0.86 to 1.12 times the airtime of the model (typical error 8%). We expect 82% of such swarms in this range"]];
const s451 = [s159, {"count": "count28", "more": ["more64", "more65", "more66"]}, s207];
const s452 = [s158, s162, s206, s160, s451, s208];
const s453 = ["Scout", "multicast", 67, 1, 0, 1, "up down", s432];
const s454 = ["Hello", "unicast", 104, 1, 1, 1, "up down", {"burst": 2.125, "second": 2.25, "lease": 0.3375, "ever": 0.125}];
const s455 = ["InitAck", "unicast", 153, 1, 1, 0.6667, "up down", s214];
const s456 = ["OpenSyn", "unicast", 134, 1, 1, 0.6667, "up down", s214];
const s457 = ["OpenAck", "unicast", 84, 1, 1, 0.6667, "up down", s214];
const s458 = 163.4251497005988;
const s459 = "OAM for others";
const s460 = 106.65917220235053;
const s461 = "Declare key expression";
const s462 = 229.04217991787982;
const s463 = "Declare key expression of matching";
const s464 = 112.31961259079904;
const s465 = "Frame of endpoints";
const s466 = ["KeepAlive", "unicast", 79, 1, 1, 1.333, "up down", s433];
const s467 = ["TCP control", "unicast", 76, 1, 1, 1.333, "up down", s214];
const s468 = "TCP ACK at start";
const s469 = "TCP ACK of endpoints";
const s470 = "with liveliness tokens, as rmw_zenoh has them, and a subscriber to all of them (measured with 1.10.2)";
const s471 = [
[1, 1.67, 11.3, "In 12 swarms within that range, each left out of the fit, discovery took 0.90 to 1.41 times the airtime of the model (typical error 6%). We expect 85% of such swarms in this range"],
[2, 1.67, 11.3, "In 4 swarms of up to twice that range, each left out of the fit, discovery took 0.99 to 1.02 times the airtime of the model (typical error 1%). So few swarms give no interval"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints, each left out of the fit, discovery took 0.93 to 1.15 times the airtime of the model (typical error 11%). So few swarms give no interval"],
];
const s472 = 179.4287333522244;
const s473 = 167.6030534351145;
const s474 = 175.50248756218906;
const s475 = "Declare token of node";
const s476 = 362.8385800401876;
const s477 = "Declare key expression of node";
const s478 = 159.33333333333334;
const s479 = 142.56804733727813;
const s480 = "--ds-product-rmw-zenoh";
const s481 = {"until": [s152, [60, "slow at best"], s153], "never": s154};
const s482 = {"second": 1, "lease": 60, "ever": Infinity};
const s483 = [s336, {"count": "count29", "more": ["more67", "more68"]}, s207];
const s484 = {"burst": 1, "second": 1, "lease": 0.016666666666666666, "ever": 0};
const s485 = ["InitSyn", "unicast", 110, 1, 0, 1, "up", s484];
const s486 = ["InitAck", "unicast", 153, 1, 0, 1, "down", s484];
const s487 = ["OpenSyn", "unicast", 134, 1, 0, 1, "up", s484];
const s488 = ["OpenAck", "unicast", 84, 1, 0, 1, "down", s484];
const s489 = 154.5017382527756;
const s490 = 192.6407465007776;
const s491 = 358.9464799539613;
const s492 = 137.8131868131868;
const s493 = 282.5695792880259;
const s494 = 622.248870141609;
const s495 = 148.72727272727272;
const s496 = 156.64516129032256;
const s497 = 0.03333333333333333;
const s498 = {"burst": 0, "second": s497, "lease": s497, "ever": s497};
const s499 = ["KeepAlive down", "unicast", 79, 1, 0, 1, "down", s498];
const s500 = "TCP ACK at start down";
const s501 = "TCP ACK of endpoints down";
const s502 = {"count": "count32", "more": ["more73", "more74", "more75", "more35"]};
const s503 = {"count": "count33", "more": ["more76", "more77", "more78", "more79", "more35"]};
const s504 = {"count": "count34", "more": ["more80", "more81", "more40"]};
const s505 = [s504, s504, s504];
const s506 = [s504, {"count": "count35", "more": ["more82", "more83", "more68"]}, s207];
const s507 = [s207, {"count": "count36", "more": ["more84", "more85", "more86"]}, {"count": "count37", "more": ["more87", "more88", "more89"]}];
const s508 = 1523.8764478764479;
const s509 = 1523.7329974811084;
const s510 = "Frame of gossip";
const s511 = 86.42028482111844;
const s512 = "Declare of matching";
const s513 = 1523.275922671353;
const s514 = "Declare key expression of tokens";
const s515 = 1524.2088308803109;
const s516 = 86.11918147065437;
const s517 = 1524.6626402070751;
const s518 = 1523.8867459991793;
const s519 = 1523.9638009049772;
const s520 = [s160, s162];
const s521 = {"until": [s152, [100, "slow at best"], s153], "never": s154};
const s522 = {"second": 1, "lease": 100, "ever": Infinity};
const s523 = {"burst": 1.9966666666666666, "second": 2.03, "lease": 0.0533, "ever": s497};
const s524 = {"burst": 0.9966666666666667, "second": 1.03, "lease": 0.0433, "ever": s497};
const s525 = {"burst": 4, "second": 4, "lease": 0.04, "ever": 0};
const s526 = {"burst": 1, "second": 1, "lease": 0.01, "ever": 0};
const s527 = 0.01020408163265306;
const s528 = {"burst": 0, "second": s527, "lease": s527, "ever": s527};
const s529 = ["Liveliness", "unicast", s219, 0.7242, 1, 1, "up down", s528];
const s530 = [s225, "unicast", s226, 0.2758, 1, 1, "up down", s528];
const s531 = [s230, "unicast", 128, 1, 1, 1, "up down", s528];
const s532 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s523];
const s533 = 0.06666666666666667;
const s534 = {"burst": 1.9333333333333333, "second": 2, "lease": 0.086, "ever": s533};
const s535 = {"burst": 0.9333333333333333, "second": 1, "lease": 0.076, "ever": s533};
const s536 = {"burst": s387, "second": s388, "lease": 0.38166666666666665, "ever": s343};
const s537 = [s162, s206, s160, s451, s208];
const s538 = ["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s214];
const s539 = ["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s214];
const s540 = ["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s214];
const s541 = 0.9997000149992501;
const s542 = ["KeepAlive", "unicast", 79, 1, 0, s541, "up down", s433];
const s543 = ["TCP control", "unicast", 76, 1, 0, s541, "up down", s214];
return {
"start": {"robot": s1, "middleware": "Fast DDS 3.6", "ros": "lyrical", "product": "Fast DDS"},
"ros": {"humble": {"Fast DDS": "Fast DDS 2.6", "Cyclone DDS": "Cyclone DDS"}, "jazzy": {"Fast DDS": "Fast DDS 2.14", "Cyclone DDS": "Cyclone DDS"}, "kilted": {"Fast DDS": "Fast DDS 3.6", "Cyclone DDS": "Cyclone DDS"}, "lyrical": {"Fast DDS": "Fast DDS 3.6", "Cyclone DDS": s2}},
"groups": [s3, s4, s5, s6, s7],
"fields": {
"swarm": [
{"name": "hosts", "label": "Robots", "symbol": "N_H", "unit": "", "scale": 1, "start": "5", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s8},
{"name": "processes", "label": "Processes per robot", "symbol": "N_P", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s8},
{"name": "endpoints", "label": "Endpoints per process", "symbol": "N_E", "unit": "", "scale": 1, "start": "678", "low": 0, "high": 1000000000, "above": false, "whole": false, "allowed": s9},
],
"beside": [
{"name": "beside_hosts", "label": "Computers", "symbol": "N_H1", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s8},
{"name": "beside_processes", "label": "Processes per computer", "symbol": "N_P1", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s8},
{"name": "beside_endpoints", "label": "Endpoints per process, computers", "symbol": "N_E1", "unit": "", "scale": 1, "start": "90", "low": 0, "high": 1000000000, "above": false, "whole": false, "allowed": s9},
],
"own": [
{"name": "unicast_rate", "label": "Rate, unicast", "symbol": "R_uni", "unit": "Mbit/s", "scale": 1000000, "start": "144.4", "low": 0, "high": Infinity, "above": true, "whole": false, "allowed": s10},
{"name": "unicast_overhead", "label": "Overhead of a frame, unicast", "symbol": "O_uni", "unit": "µs", "scale": 1e-06, "start": "180", "low": 0, "high": Infinity, "above": false, "whole": false, "allowed": s11},
{"name": "multicast_rate", "label": "Rate, multicast", "symbol": "R_multi", "unit": "Mbit/s", "scale": 1000000, "start": "6", "low": 0, "high": Infinity, "above": true, "whole": false, "allowed": s10},
{"name": "multicast_overhead", "label": "Overhead of a frame, multicast", "symbol": "O_multi", "unit": "µs", "scale": 1e-06, "start": "120", "low": 0, "high": Infinity, "above": false, "whole": false, "allowed": s11},
],
"target": [{"name": "within", "label": "Discovery within", "symbol": "within", "unit": "s", "scale": 1, "start": "60", "low": 0, "high": 600, "above": true, "whole": false, "allowed": "a number above 0 and at most 600"}],
},
"robots": [
{"name": "The paper's swarm", "processes": "2", "endpoints": "10", "nodes": 0, "parts": [{"what": "processes with ten endpoints each", "processes": 2, "endpoints": 20, "kind": "printed", "source": "paper, Fig. 2"}]},
{"name": "One bare node", "processes": "1", "endpoints": "18", "nodes": 1, "parts": [{"what": "participant, rclcpp node and one topic", "processes": 1, "endpoints": 18, "kind": "counted", "source": "the parts of rviz_endpoints.csv: 2 of the participant and 15 of a node; 1 publisher"}]},
{"name": s1, "processes": "1", "endpoints": "678", "nodes": 13, "parts": [{"what": "composed Nav2", "processes": 1, "endpoints": 678, "kind": "printed", "source": "paper, Sec. IV-C; nodes: nav2_nodes.csv"}]},
{
"name": "TurtleBot 4 with Nav2",
"processes": "22",
"endpoints": "42.1818",
"nodes": 1.1363636363636365,
"parts": [
{
"what": "Nav2's servers, each in a process of its own",
"processes": 11,
"endpoints": 698,
"kind": "estimated",
"source": "678 of paper, Sec. IV-C, and 2 for each of ten further participants; processes: turtlebot4 (humble, d688175), nav2.launch.py and localization.launch.py, which do not compose; nodes: nav2_nodes.csv",
},
{
"what": "drivers, description, joystick and diagnostics; without the Create 3 base, which is wired to them",
"processes": 11,
"endpoints": 230,
"kind": "estimated",
"source": "turtlebot4_robot (humble, f2f30da), standard.launch.py and diagnostics.launch.py: 17 for each participant with its node, and the topics that turtlebot4_base and turtlebot4_diagnostics create; topics of the other drivers would add to it",
},
],
},
{
"name": "Drone, PX4 through uXRCE-DDS",
"processes": "2",
"endpoints": "45.5",
"nodes": 0.5,
"parts": [
{"what": "agent: 29 topics out, 40 in, one service", "processes": 1, "endpoints": 71, "kind": "counted", "source": "PX4-Autopilot (00743c6), src/modules/uxrce_dds_client/dds_topics.yaml and vehicle_command_srv.cpp; all of them are there once each has been used"},
{"what": "a node that flies offboard", "processes": 1, "endpoints": 20, "kind": "counted", "source": "the parts of rviz_endpoints.csv: 2 of the participant and 15 of a node; three publishers: offboard_control_mode, trajectory_setpoint, vehicle_command"},
],
},
{
"name": "Drone, PX4 through MAVROS",
"processes": "1",
"endpoints": "1207",
"nodes": 61,
"parts": [
{
"what": "mavros_node with the plugins of px4_pluginlists.yaml",
"processes": 1,
"endpoints": 1207,
"kind": "estimated",
"source": "mavros 2.12.0: 59 plugins and 3 nodes of 15 (the one for parameters has 2), 2 of the participant; the source of these plugins has 162 lines that create a publisher or subscription, 58 that create a service, 5 a client",
},
],
},
{
"name": "Manipulator with MoveIt",
"processes": "3",
"endpoints": "72.3333",
"nodes": 2.3333333333333335,
"parts": [
{
"what": "move_group",
"processes": 1,
"endpoints": 113,
"kind": "estimated",
"source": "moveit2 (8fcb5d2): three nodes of 15, and what the default capabilities, the planning scene monitor and one trajectory controller create: 15 services, two action servers and one client of 8 endpoints each, 12 topics; 2 of the participant",
},
{
"what": "ros2_control_node with a state broadcaster and a trajectory controller",
"processes": 1,
"endpoints": 83,
"kind": "estimated",
"source": "ros2_control (006681b): 2 of the participant, three nodes of 15, 10 services of the controller manager, one of the controller, its action server of 8 and 6 topics",
},
{"what": "robot_state_publisher", "processes": 1, "endpoints": 21, "kind": "estimated", "source": "2 of the participant, 15 of the node; robot_description, tf, tf_static and joint_states"},
],
},
],
"channels": [
{
"name": s12,
"model": "linear",
"values": {"R_uni": 144400000, "O_uni": 0.00018, "R_multi": 6000000, "O_multi": 0.00012},
"remedies": [
{"kind": s13, "what": s14, "note": "both values use standard timing", "base": s17, "wifi": {"name": s18, "model": "padded", "values": s19}},
{"kind": "radio", "what": s20, "note": "compared with 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead per frame exchange. Both values use standard timing", "base": s17, "wifi": s23},
{"kind": "radio", "what": s24, "note": "compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead per frame exchange. Both values use standard timing", "base": s17, "wifi": s28},
{"kind": "radio", "what": s29, "note": "compared with 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead per frame exchange. Both values use standard timing", "base": s17, "wifi": s33},
{
"kind": "aggregation",
"what": "aggregating up to 64 frames",
"note": "both values use standard timing. When we simulated the paper model's startup of 20 robots of 2 processes with 10 endpoints each, they needed 18 s instead of 31 s with DDS and 31 s instead of 65 s with Zenoh (medians)",
"base": s17,
"wifi": s34,
},
],
},
{
"name": s35,
"model": "padded",
"values": s36,
"remedies": [
{"kind": s13, "what": s14, "note": "", "base": s37, "wifi": {"name": "802.11a 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": s38}},
{"kind": "radio", "what": s20, "note": "compared with 802.11a 20 MHz 1x1: 300 instead of 54 Mbit/s and 186 instead of 166 µs of overhead per frame exchange", "base": s37, "wifi": s23},
{"kind": "radio", "what": s24, "note": "compared with 802.11a 20 MHz 1x1: 867 instead of 54 Mbit/s and 190 instead of 166 µs of overhead per frame exchange", "base": s37, "wifi": s28},
{"kind": "radio", "what": s29, "note": "compared with 802.11a 20 MHz 1x1: 2402 instead of 54 Mbit/s and 196 instead of 166 µs of overhead per frame exchange", "base": s37, "wifi": s33},
],
},
{
"name": s39,
"model": "padded",
"values": s40,
"remedies": [
{"kind": s13, "what": s41, "note": "", "base": s42, "wifi": {"name": "802.11g 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": s38}},
{"kind": "radio", "what": s20, "note": "compared with 802.11g 20 MHz 1x1: 300 instead of 54 Mbit/s, 186 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s42, "wifi": s23},
{"kind": "radio", "what": s24, "note": "compared with 802.11g 20 MHz 1x1: 867 instead of 54 Mbit/s, 190 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s42, "wifi": s28},
{"kind": "radio", "what": s29, "note": "compared with 802.11g 20 MHz 1x1: 2402 instead of 54 Mbit/s, 196 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s42, "wifi": s33},
],
},
{
"name": s43,
"model": "padded",
"values": s16,
"full": s34,
"simulated": "n",
"remedies": [
{"kind": s13, "what": s14, "note": "", "base": s44, "wifi": {"name": s18, "model": "padded", "values": s19, "full": {"name": "802.11n 20 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64", "model": "aggregated", "values": s45}, "simulated": null}},
{"kind": "radio", "what": s20, "note": "compared with 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead per frame exchange", "base": s44, "wifi": s47},
{"kind": "radio", "what": s24, "note": "compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead per frame exchange", "base": s44, "wifi": s49},
{"kind": "radio", "what": s29, "note": "compared with 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead per frame exchange", "base": s44, "wifi": s51},
],
},
{
"name": s52,
"model": "padded",
"values": s53,
"full": s54,
"simulated": null,
"remedies": [
{"kind": s13, "what": s41, "note": "", "base": s55, "wifi": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s", "model": "padded", "values": s19, "full": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64", "model": "aggregated", "values": s45}, "simulated": null}},
{"kind": "radio", "what": s20, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 300 instead of 144 Mbit/s, 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s55, "wifi": s47},
{"kind": "radio", "what": s24, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 867 instead of 144 Mbit/s, 190 instead of 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s55, "wifi": s49},
{"kind": "radio", "what": s29, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 2402 instead of 144 Mbit/s, 196 instead of 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s55, "wifi": s51},
],
},
{
"name": s21,
"model": "padded",
"values": s22,
"full": s46,
"simulated": null,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s47,
"wifi": {
"name": "802.11n 40 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11n 40 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s24, "note": "compared with 802.11n 40 MHz 2x2: 867 instead of 300 Mbit/s and 190 instead of 186 µs of overhead per frame exchange", "base": s47, "wifi": s49},
{"kind": "radio", "what": s29, "note": "compared with 802.11n 40 MHz 2x2: 2402 instead of 300 Mbit/s and 196 instead of 186 µs of overhead per frame exchange", "base": s47, "wifi": s51},
],
},
{
"name": s25,
"model": "padded",
"values": s27,
"full": s48,
"simulated": "ac",
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s49,
"wifi": {
"name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s26, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s26, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s29, "note": "compared with 802.11ac 80 MHz 2x2: 2402 instead of 867 Mbit/s and 196 instead of 190 µs of overhead per frame exchange", "base": s49, "wifi": s51},
],
},
{
"name": s56,
"model": "padded",
"values": s58,
"full": s59,
"simulated": null,
"remedies": [
{
"kind": s13,
"what": s41,
"note": "",
"base": s60,
"wifi": {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s57, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s57, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s20, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 300 instead of 287 Mbit/s, 186 instead of 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s60, "wifi": s47},
{"kind": "radio", "what": s24, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 867 instead of 287 Mbit/s, 190 instead of 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s60, "wifi": s49},
{"kind": "radio", "what": s29, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 2402 instead of 287 Mbit/s, 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s60, "wifi": s51},
],
},
{
"name": s61,
"model": "padded",
"values": s63,
"full": s64,
"simulated": null,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s65,
"wifi": {
"name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s62, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s62, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s29, "note": "compared with 802.11ax 80 MHz 2x2: 2402 instead of 1201 Mbit/s and 196 µs of overhead per frame exchange", "base": s65, "wifi": s51},
],
},
{
"name": s30,
"model": "padded",
"values": s32,
"full": s50,
"simulated": null,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s51,
"wifi": {
"name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s31, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s31, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
},
"simulated": null,
},
},
],
},
{
"name": s66,
"model": "padded",
"values": s68,
"full": s69,
"simulated": null,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s70,
"wifi": {
"name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s67, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s67, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s29, "note": "compared with 802.11be 80 MHz 2x2: 2402 instead of 1441 Mbit/s and 196 instead of 204 µs of overhead per frame exchange", "base": s70, "wifi": s51},
],
},
{
"name": s71,
"model": "padded",
"values": s73,
"full": s74,
"simulated": null,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": {"name": s71, "model": "padded", "values": s73, "full": s74, "simulated": null},
"wifi": {
"name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s72, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s72, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
},
"simulated": null,
},
},
],
},
],
"ready": {
"robots": {
"The paper's swarm": {"N_P": 2, "N_E": 10, "N_S": 2},
"One bare node": {"N_P": 1, "N_E": 18, "N_S": 4},
"Nav2 in one process": {"N_P": 1, "N_E": 678, "N_S": 28},
"TurtleBot 4 with Nav2": {"N_P": 22, "N_E": 42.18181818181818, "N_S": 4.272727272727273},
"Drone, PX4 through uXRCE-DDS": {"N_P": 2, "N_E": 45.5, "N_S": 3},
"Drone, PX4 through MAVROS": {"N_P": 1, "N_E": 1207, "N_S": 124},
"Manipulator with MoveIt": {"N_P": 3, "N_E": 72.33333333333333, "N_S": 6.666666666666667},
},
"laptop": {"N_P": 1, "N_E": 90, "N_S": 6},
"shared": 0.05,
"whole": 0.5,
"bursts": {
"ac": {
"Cyclone DDS": {
"One bare node": {"0": [[2, 1.7829], [4, 1.3906], [8, 1.4035], [12, 1.4438], [16, 1.3855]], "1": [[2, 1.5104], [4, 1.4322], [8, 1.5227], [12, 1.3772], [16, 1.5527]]},
"Nav2 in one process": {"0": [[2, 1.1789], [4, 1.1612], [8, 1.1454], [12, 1.2726], [16, 1.2736]], "1": [[2, 1.2466], [4, 1.1201], [8, 1.2043], [12, 1.2627], [16, 1.3239]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.3065], [4, 1.2418], [8, 1.2045], [12, 1.2668], [16, 1.2835]], "1": [[2, 1.1822], [4, 1.1054], [8, 1.1884], [12, 1.2421], [16, 1.2919]]},
"The paper's swarm": {"0": [[2, 1.3421], [4, 1.1862], [8, 1.3014], [12, 1.3069], [16, 1.3102]], "1": [[2, 1.4138], [4, 1.2102], [8, 1.2398], [12, 1.3273], [16, 1.2987]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.2154], [4, 1.157], [8, 1.2518], [12, 1.2172], [16, 1.3319]], "1": [[2, 1.3226], [4, 1.1245], [8, 1.231], [12, 1.2867], [16, 1.2901]]},
"Manipulator with MoveIt": {"0": [[2, 1.0716], [4, 1.1711], [8, 1.1989], [12, 1.258], [16, 1.3191]], "1": [[2, 1.1573], [4, 1.1782], [8, 1.157], [12, 1.2686], [16, 1.3084]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0667], [4, 1.13], [8, 1.2092], [12, 1.2669]], "1": [[2, 1.058], [4, 1.1381]]},
},
"Cyclone DDS multicast SEDP": {
"One bare node": {"0": [[2, 1.3352], [4, 1.1092], [8, 1.0767], [12, 1.0905], [16, 1.0997]], "1": [[2, 1.117], [4, 1.0264], [8, 1.0436], [12, 1.0693], [16, 1.0835]]},
"Nav2 in one process": {"0": [[2, 1.0175], [4, 1.0062], [8, 1.0092], [12, 1.0115], [16, 1.0118]], "1": [[2, 1.0123], [4, 1.0065], [8, 1.0141], [12, 1.0122], [16, 1.0201]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.0101], [4, 1.0087], [8, 1.0059], [12, 1.0113], [16, 1.0132]], "1": [[2, 1.0063], [4, 1.0054], [8, 1.0099], [12, 1.0122], [16, 1.017]]},
"The paper's swarm": {"0": [[2, 1.0921], [4, 1.0381], [8, 1.0842], [12, 1.0586], [16, 1.064]], "1": [[2, 1.0402], [4, 1.0331], [8, 1.0233], [12, 1.0849], [16, 1.0587]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.0152], [4, 1.0144], [8, 1.0234], [12, 1.0262], [16, 1.0537]], "1": [[2, 1.0162], [4, 1.0148], [8, 1.0284], [12, 1.0272], [16, 1.0368]]},
"Manipulator with MoveIt": {"0": [[2, 1.0144], [4, 1.0092], [8, 1.0146], [12, 1.0156], [16, 1.0189]], "1": [[2, 0.9944], [4, 1.0091], [8, 1.0127], [12, 1.0157], [16, 1.0233]]},
"TurtleBot 4 with Nav2": {"0": [[2, 0.9987], [4, 1.0044], [8, 1.0148], [12, 1.0269]], "1": [[2, 0.9999], [4, 1.0049]]},
},
"Cyclone DDS peers": {
"One bare node": {"0": [[2, 2.8395], [4, 1.6801], [8, 1.3214], [12, 1.4036], [16, 1.3862]], "1": [[2, 2.3735], [4, 1.3859], [8, 1.3017], [12, 1.3703], [16, 1.3655]]},
"Nav2 in one process": {"0": [[2, 1.301], [4, 1.2217], [8, 1.202], [12, 1.2605], [16, 1.329]], "1": [[2, 1.3424], [4, 1.2041], [8, 1.1997], [12, 1.2782], [16, 1.3152]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1701], [4, 1.2506], [8, 1.1699], [12, 1.2868], [16, 1.2898]], "1": [[2, 1.2565], [4, 1.2453], [8, 1.2288], [12, 1.2532], [16, 1.3105]]},
"The paper's swarm": {"0": [[2, 1.8717], [4, 1.2591], [8, 1.9316], [12, 1.2727], [16, 1.3159]], "1": [[2, 1.7411], [4, 1.19], [8, 1.2665], [12, 1.311], [16, 1.3291]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.5098], [4, 1.3543], [8, 1.1914], [12, 1.2247], [16, 1.2828]], "1": [[2, 1.5226], [4, 1.1744], [8, 1.2244], [12, 1.2841], [16, 1.3167]]},
"Manipulator with MoveIt": {"0": [[2, 1.2365], [4, 1.1859], [8, 1.1863], [12, 1.2439], [16, 1.2983]], "1": [[2, 1.5933], [4, 1.1556], [8, 1.2018], [12, 1.2358], [16, 1.3198]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0501], [4, 1.1115], [8, 1.1863], [12, 1.2479]], "1": [[2, 1.0751], [4, 1.1141]]},
},
"Cyclone DDS, version 11": {
"One bare node": {"0": [[2, 1.7201], [4, 1.4878], [8, 1.3364], [12, 1.3729], [16, 1.5491]], "1": [[2, 1.4143], [4, 1.3698], [8, 1.3574], [12, 1.3066], [16, 1.3635]]},
"Nav2 in one process": {"0": [[2, 1.1903], [4, 1.1757], [8, 1.1989], [12, 1.2275], [16, 1.302]], "1": [[2, 1.1752], [4, 1.1314], [8, 1.1595], [12, 1.2487], [16, 1.3307]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1591], [4, 1.1666], [8, 1.1952], [12, 1.2512], [16, 1.3039]], "1": [[2, 1.2075], [4, 1.1159], [8, 1.199], [12, 1.2429], [16, 1.3232]]},
"The paper's swarm": {"0": [[2, 1.3045], [4, 1.2857], [8, 1.2699], [12, 1.2736], [16, 1.3904]], "1": [[2, 1.3219], [4, 1.2915], [8, 1.2783], [12, 1.3766], [16, 1.3066]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.1757], [4, 1.1456], [8, 1.1991], [12, 1.2399], [16, 1.2899]], "1": [[2, 1.2276], [4, 1.1795], [8, 1.2168], [12, 1.2461], [16, 1.3283]]},
"Manipulator with MoveIt": {"0": [[2, 1.1081], [4, 1.1165], [8, 1.1974], [12, 1.2424], [16, 1.3085]], "1": [[2, 1.1215], [4, 1.1536], [8, 1.1735], [12, 1.2634], [16, 1.3045]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0605], [4, 1.1235], [8, 1.2035], [12, 1.2592]], "1": [[2, 1.0791], [4, 1.1254]]},
},
"DDS": {
"One bare node": {"0": [[2, 2.2271], [4, 1.7627], [8, 1.5364], [12, 1.5911], [16, 1.6648]], "1": [[2, 1.5854], [4, 1.4474], [8, 1.4216], [12, 1.6491], [16, 1.7248]]},
"Nav2 in one process": {"0": [[2, 1.0927], [4, 1.1618], [8, 1.172], [12, 1.247], [16, 1.295]], "1": [[2, 1.23], [4, 1.0848], [8, 1.193], [12, 1.2297], [16, 1.3005]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.0699], [4, 1.1599], [8, 1.1622], [12, 1.2352], [16, 1.2925]], "1": [[2, 1.1406], [4, 1.0564], [8, 1.2028], [12, 1.2356], [16, 1.296]]},
"The paper's swarm": {"0": [[2, 1.4994], [4, 1.2314], [8, 1.3547], [12, 1.3753], [16, 1.4134]], "1": [[2, 1.645], [4, 1.2417], [8, 1.2369], [12, 1.8849], [16, 1.5581]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.3258], [4, 1.2585], [8, 1.3217], [12, 1.1912], [16, 1.3973]], "1": [[2, 1.2546], [4, 1.0986], [8, 1.2868], [12, 1.2446], [16, 1.2835]]},
"Manipulator with MoveIt": {"0": [[2, 1.1815], [4, 1.1495], [8, 1.1751], [12, 1.254], [16, 1.3022]], "1": [[2, 1.154], [4, 1.1342], [8, 1.1819], [12, 1.2317], [16, 1.293]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0227], [4, 1.1043], [8, 1.1799], [12, 1.24]], "1": [[2, 1.0585], [4, 1.1179]]},
},
"Fast DDS": {
"One bare node": {"0": [[2, 1.1881], [4, 1.0848], [8, 1.1209], [12, 1.1416], [16, 1.141]], "1": [[2, 1.142], [4, 1.0863], [8, 1.083], [12, 1.1336], [16, 1.2117]]},
"Nav2 in one process": {"0": [[2, 1.0918], [4, 1.0921], [8, 1.1565], [12, 1.196], [16, 1.2705]], "1": [[2, 1.0709], [4, 1.1011], [8, 1.1524], [12, 1.2157], [16, 1.2433]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.0911], [4, 1.1215], [8, 1.1816], [12, 1.2281], [16, 1.2663]], "1": [[2, 1.0534], [4, 1.1164], [8, 1.1753], [12, 1.2376], [16, 1.2725]]},
"The paper's swarm": {"0": [[2, 1.0433], [4, 1.0451], [8, 1.0702], [12, 1.1032], [16, 1.1492]], "1": [[2, 1.0278], [4, 1.0336], [8, 1.0727], [12, 1.0864], [16, 1.1352]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.0549], [4, 1.0343], [8, 1.0695], [12, 1.1222], [16, 1.1594]], "1": [[2, 1.0475], [4, 1.0372], [8, 1.0695], [12, 1.138], [16, 1.1447]]},
"Manipulator with MoveIt": {"0": [[2, 1.0184], [4, 1.0181], [8, 1.0695], [12, 1.1248], [16, 1.1547]], "1": [[2, 1.011], [4, 1.034], [8, 1.0832], [12, 1.1307], [16, 1.1585]]},
"TurtleBot 4 with Nav2": {"0": [[2, 0.9882], [4, 1.033], [8, 1.1257], [12, 1.1949]], "1": [[2, 0.9909], [4, 1.0371]]},
},
"Fast DDS Discovery Server": {
"One bare node": {"0": [[2, 3.2388], [4, 2.0836], [8, 1.9225], [12, 1.5557], [16, 1.7839]], "1": [[2, 2.4795], [4, 1.9895], [8, 1.6854], [12, 3.8548], [16, 1.7376]]},
"Nav2 in one process": {"0": [[2, 1.2988], [4, 1.2544], [8, 1.3883], [12, 1.3785], [16, 1.3695]], "1": [[2, 1.4824], [4, 1.3413], [8, 1.4227], [12, 1.3588], [16, 1.4802]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.2531], [4, 1.196], [8, 1.2163], [12, 1.2361], [16, 1.2607]], "1": [[2, 1.2242], [4, 1.177], [8, 1.2582], [12, 1.2218], [16, 1.2796]]},
"The paper's swarm": {"0": [[2, 1.9648], [4, 1.5714], [8, 1.4108], [12, 1.3854], [16, 1.3262]], "1": [[2, 2.3694], [4, 1.601], [8, 1.4375], [12, 1.5448], [16, 1.4591]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.688], [4, 1.4902], [8, 1.3784], [12, 1.3729], [16, 1.3276]], "1": [[2, 1.6516], [4, 1.5313], [8, 1.3707], [12, 1.3771], [16, 1.4905]]},
"Manipulator with MoveIt": {"0": [[2, 1.3367], [4, 1.1887], [8, 1.2262], [12, 1.2399], [16, 1.194]], "1": [[2, 1.4896], [4, 1.2516], [8, 1.2111], [12, 1.2056], [16, 1.3267]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.065], [4, 1.0711], [8, 1.1091], [12, 1.1361]], "1": [[2, 1.0484], [4, 1.066]]},
},
"Fast DDS Discovery Server, on a robot": {
"One bare node": {"0": [[2, 3.3198], [4, 2.0876], [8, 1.7623], [12, 1.7307], [16, 2.9383]], "1": [[2, 2.2679], [4, 1.718], [8, 1.5258], [12, 1.6053], [16, 1.8225]]},
"Nav2 in one process": {"0": [[2, 1.4626], [4, 1.3543], [8, 1.1722], [12, 1.2772], [16, 1.3418]], "1": [[2, 1.3986], [4, 1.2598], [8, 1.2777], [12, 1.2872], [16, 1.3829]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.2559], [4, 1.1649], [8, 1.2173], [12, 1.2675], [16, 1.3621]], "1": [[2, 1.1427], [4, 1.2297], [8, 1.2547], [12, 1.2815], [16, 1.3241]]},
"The paper's swarm": {"0": [[2, 2.2927], [4, 1.4717], [8, 1.371], [12, 1.4548], [16, 1.4746]], "1": [[2, 1.821], [4, 1.4413], [8, 1.5826], [12, 1.3332], [16, 1.5985]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 2.201], [4, 1.6103], [8, 1.3606], [12, 1.7133], [16, 1.3797]], "1": [[2, 1.5268], [4, 1.3798], [8, 1.3011], [12, 1.7241], [16, 1.564]]},
"Manipulator with MoveIt": {"0": [[2, 1.2962], [4, 1.2241], [8, 1.1773], [12, 1.2283], [16, 1.3132]], "1": [[2, 1.4172], [4, 1.1057], [8, 1.2462], [12, 1.2679], [16, 1.3431]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0522], [4, 1.1136], [8, 1.2006], [12, 1.2483]], "1": [[2, 1.0704], [4, 1.114]]},
},
"Fast DDS Discovery Server, two": {
"One bare node": {"0": [[2, 2.2777], [4, 1.7212], [8, 1.8283], [12, 1.3854], [16, 1.9911]], "1": [[2, 2.1456], [4, 1.899], [8, 1.5059], [12, 1.6405], [16, 1.5549]]},
"Nav2 in one process": {"0": [[2, 1.3412], [4, 1.2871], [8, 1.277], [12, 1.355], [16, 1.3567]], "1": [[2, 1.3064], [4, 1.2874], [8, 1.2759], [12, 1.292], [16, 1.4283]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1782], [4, 1.1059], [8, 1.2363], [12, 1.2115], [16, 1.2336]], "1": [[2, 1.1679], [4, 1.1458], [8, 1.2102], [12, 1.2141], [16, 1.29]]},
"The paper's swarm": {"0": [[2, 1.5744], [4, 1.4334], [8, 1.272], [12, 1.3517], [16, 1.2342]], "1": [[2, 1.4144], [4, 1.3554], [8, 1.2578], [12, 1.2788], [16, 1.2647]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.5404], [4, 1.3334], [8, 1.3661], [12, 1.3012], [16, 1.3452]], "1": [[2, 1.638], [4, 1.42], [8, 1.2299], [12, 1.3239], [16, 1.2594]]},
"Manipulator with MoveIt": {"0": [[2, 1.3036], [4, 1.1491], [8, 1.1638], [12, 1.1081], [16, 1.1774]], "1": [[2, 1.2611], [4, 1.1748], [8, 1.1452], [12, 1.1636], [16, 1.2114]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0472], [4, 1.0566], [8, 1.085], [12, 1.1134]], "1": [[2, 1.0485], [4, 1.0583]]},
},
"Zenoh": {
"One bare node": {"0": [[2, 3.7903], [4, 2.5525], [8, 1.8967], [12, 1.8304], [16, 1.7436]], "1": [[2, 2.0449], [4, 1.7666], [8, 1.4758], [12, 1.4669], [16, 2.1751]]},
"Nav2 in one process": {"0": [[2, 1.3085], [4, 1.1113], [8, 1.1701], [12, 1.2407], [16, 1.31]], "1": [[2, 1.088], [4, 1.0854], [8, 1.2018], [12, 1.2218], [16, 1.3106]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.2113], [4, 1.0833], [8, 1.1784], [12, 1.2408], [16, 1.2833]], "1": [[2, 1.0681], [4, 1.1497], [8, 1.1962], [12, 1.2213], [16, 1.2944]]},
"The paper's swarm": {"0": [[2, 2.1219], [4, 1.4732], [8, 1.4018], [12, 1.4799], [16, 1.5722]], "1": [[2, 1.8398], [4, 1.4378], [8, 1.3747], [12, 1.4408], [16, 1.4619]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.6155], [4, 1.2298], [8, 1.2674], [12, 1.2593], [16, 1.39]], "1": [[2, 1.3104], [4, 1.1306], [8, 1.3319], [12, 1.2874], [16, 1.268]]},
"Manipulator with MoveIt": {"0": [[2, 1.2339], [4, 1.1454], [8, 1.1794], [12, 1.2545], [16, 1.3201]], "1": [[2, 1.1969], [4, 1.1317], [8, 1.213], [12, 1.2195], [16, 1.286]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0459], [4, 1.0916], [8, 1.1724], [12, 1.2284]], "1": [[2, 1.0416], [4, 1.0878]]},
},
"Zenoh peer": {
"One bare node": {"0": [[2, 2.3519], [4, 1.9431], [8, 1.8101], [12, 1.5307], [16, 1.5589]], "1": [[2, 1.7058], [4, 1.5166], [8, 1.3825], [12, 1.4343], [16, 1.7735]]},
"Nav2 in one process": {"0": [[2, 1.4174], [4, 1.1261], [8, 1.1982], [12, 1.2357], [16, 1.3554]], "1": [[2, 1.1423], [4, 1.1281], [8, 1.215], [12, 1.2759], [16, 1.3591]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.3318], [4, 1.1335], [8, 1.2375], [12, 1.2585], [16, 1.2942]], "1": [[2, 1.1168], [4, 1.1492], [8, 1.1961], [12, 1.2754], [16, 1.3254]]},
"The paper's swarm": {"0": [[2, 1.5809], [4, 1.5661], [8, 1.343], [12, 1.3561], [16, 1.3527]], "1": [[2, 1.4081], [4, 1.1588], [8, 1.2671], [12, 1.3804], [16, 1.4317]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.4166], [4, 1.4241], [8, 1.3036], [12, 1.2551], [16, 1.3697]], "1": [[2, 1.2178], [4, 1.5087], [8, 1.3061], [12, 1.3083], [16, 1.3073]]},
"Manipulator with MoveIt": {"0": [[2, 1.1651], [4, 1.0755], [8, 1.1556], [12, 1.2264], [16, 1.3025]], "1": [[2, 1.1476], [4, 1.1265], [8, 1.1778], [12, 1.2174], [16, 1.3098]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0115], [4, 1.0832], [8, 1.1698], [12, 1.2379]], "1": [[2, 1.042], [4, 1.0863]]},
},
"Zenoh peer, tokens": {
"One bare node": {"0": [[2, 1.9603], [4, 1.6045], [8, 1.4607], [12, 1.4194], [16, 1.5279]], "1": [[2, 1.678], [4, 1.8695], [8, 1.3547], [12, 2.4337], [16, 1.7537]]},
"Nav2 in one process": {"0": [[2, 1.2192], [4, 1.1724], [8, 1.2153], [12, 1.2598], [16, 1.279]], "1": [[2, 1.1609], [4, 1.1368], [8, 1.1877], [12, 1.2539], [16, 1.3057]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1446], [4, 1.1467], [8, 1.1718], [12, 1.263], [16, 1.3079]], "1": [[2, 1.1236], [4, 1.1187], [8, 1.1955], [12, 1.2431], [16, 1.3024]]},
"The paper's swarm": {"0": [[2, 1.3543], [4, 1.263], [8, 1.2467], [12, 1.2791], [16, 1.3483]], "1": [[2, 1.1973], [4, 1.1805], [8, 1.1433], [12, 1.284], [16, 1.3185]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.3633], [4, 1.1325], [8, 1.2098], [12, 1.2652], [16, 1.3931]], "1": [[2, 1.1676], [4, 1.1414], [8, 1.2242], [12, 1.2429], [16, 1.3765]]},
"Manipulator with MoveIt": {"0": [[2, 1.14], [4, 1.1081], [8, 1.1724], [12, 1.2463], [16, 1.2993]], "1": [[2, 1.0981], [4, 1.1269], [8, 1.1513], [12, 1.2357], [16, 1.31]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0618], [4, 1.1084], [8, 1.1881], [12, 1.249]], "1": [[2, 1.0635], [4, 1.106]]},
},
"Zenoh router": {
"One bare node": {"0": [[2, 5.009], [4, 3.1443], [8, 2.544], [12, 2.0221], [16, 2.0495]], "1": [[2, 2.6583], [4, 2.2201], [8, 2.038], [12, 1.9643], [16, 2.0588]]},
"Nav2 in one process": {"0": [[2, 1.3824], [4, 1.2044], [8, 1.1528], [12, 1.1969], [16, 1.1214]], "1": [[2, 1.2656], [4, 1.1786], [8, 1.1523], [12, 1.1659], [16, 1.1721]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.2114], [4, 1.1484], [8, 1.2757], [12, 1.1566], [16, 1.1293]], "1": [[2, 1.1342], [4, 1.1725], [8, 1.1165], [12, 1.1221], [16, 1.1422]]},
"The paper's swarm": {"0": [[2, 3.0834], [4, 2.1839], [8, 1.9535], [12, 1.5706], [16, 2.8486]], "1": [[2, 2.0053], [4, 1.7253], [8, 1.6283], [12, 1.4893], [16, 1.7629]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.497], [4, 1.4108], [8, 1.3771], [12, 1.2591], [16, 1.2956]], "1": [[2, 1.6419], [4, 1.4426], [8, 1.2601], [12, 1.2739], [16, 1.5456]]},
"Manipulator with MoveIt": {"0": [[2, 1.2741], [4, 1.1369], [8, 1.1023], [12, 1.0945], [16, 1.1115]], "1": [[2, 1.2831], [4, 1.2078], [8, 1.1273], [12, 1.1004], [16, 1.2617]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0357], [4, 1.0231], [8, 1.0254], [12, 1.0158]], "1": [[2, 1.0199], [4, 1.0215]]},
},
"Zenoh router per host": {
"One bare node": {"0": [[2, 4.7153], [4, 1.9841], [8, 1.6268], [12, 1.8973], [16, 1.4605]], "1": [[2, 2.031], [4, 1.5243], [8, 1.3135], [12, 1.4722], [16, 1.4126]]},
"Nav2 in one process": {"0": [[2, 1.2357], [4, 1.3292], [8, 1.1639], [12, 1.285], [16, 1.3167]], "1": [[2, 1.1805], [4, 1.1314], [8, 1.2621], [12, 1.2835], [16, 1.3267]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.0542], [4, 1.1219], [8, 1.2255], [12, 1.2818], [16, 1.3396]], "1": [[2, 1.0731], [4, 1.1291], [8, 1.1994], [12, 1.2517], [16, 1.3371]]},
"The paper's swarm": {"0": [[2, 4.4324], [4, 1.9353], [8, 1.4802], [12, 1.4447], [16, 1.5193]], "1": [[2, 2.0735], [4, 1.5022], [8, 1.4476], [12, 1.6341], [16, 1.6938]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 2.1298], [4, 1.3013], [8, 1.3284], [12, 1.3389], [16, 1.4719]], "1": [[2, 1.9197], [4, 1.2768], [8, 1.3766], [12, 1.311], [16, 1.4161]]},
"Manipulator with MoveIt": {"0": [[2, 1.6415], [4, 1.326], [8, 1.4202], [12, 1.2242], [16, 1.3301]], "1": [[2, 1.3771], [4, 1.1564], [8, 1.2609], [12, 1.2453], [16, 1.3814]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.1684], [4, 1.1754], [8, 1.1942], [12, 1.2643]], "1": [[2, 1.2024], [4, 1.1144]]},
},
"Zenoh router per host, star": {
"One bare node": {"0": [[2, 4.7919], [4, 3.0751], [8, 2.5856], [12, 2.0798], [16, 1.9077]], "1": [[2, 2.8323], [4, 2.8421], [8, 2.1346], [12, 2.0369], [16, 2.0346]]},
"Nav2 in one process": {"0": [[2, 1.5484], [4, 1.142], [8, 1.1901], [12, 1.0882], [16, 1.108]], "1": [[2, 1.3296], [4, 1.1186], [8, 1.1331], [12, 1.1329], [16, 1.1979]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.3988], [4, 1.1141], [8, 1.1003], [12, 1.0921], [16, 1.089]], "1": [[2, 1.4605], [4, 1.2231], [8, 1.2174], [12, 1.1482], [16, 1.0721]]},
"The paper's swarm": {"0": [[2, 4.5266], [4, 2.8567], [8, 2.367], [12, 1.9291], [16, 2.1229]], "1": [[2, 2.7835], [4, 2.3989], [8, 1.9995], [12, 2.1284], [16, 4.6262]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 2.3003], [4, 2.0314], [8, 1.5371], [12, 1.4008], [16, 1.3162]], "1": [[2, 2.5078], [4, 1.6863], [8, 1.3462], [12, 1.45], [16, 1.3776]]},
"Manipulator with MoveIt": {"0": [[2, 1.6436], [4, 1.3476], [8, 1.2986], [12, 1.2849], [16, 1.2557]], "1": [[2, 1.6872], [4, 1.4462], [8, 1.2267], [12, 1.2256], [16, 1.245]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.4791], [4, 1.2031], [8, 1.1063], [12, 1.1024]], "1": [[2, 1.4318], [4, 1.1513]]},
},
},
"n": {
"Cyclone DDS": {
"One bare node": {"0": [[2, 1.5192], [4, 1.1685], [8, 1.2151], [12, 1.2871], [16, 1.3187]], "1": [[2, 1.2371], [4, 1.2656], [8, 1.2124], [12, 1.4949], [16, 1.2637]]},
"Nav2 in one process": {"0": [[2, 1.0755], [4, 1.1007], [8, 1.2178], [12, 1.2299], [16, 1.3149]], "1": [[2, 1.1671], [4, 1.114], [8, 1.2314], [12, 1.2227], [16, 1.2936]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.2467], [4, 1.107], [8, 1.1908], [12, 1.2743], [16, 1.3083]], "1": [[2, 1.0783], [4, 1.0969], [8, 1.2093], [12, 1.2837], [16, 1.3166]]},
"The paper's swarm": {"0": [[2, 1.2047], [4, 1.0782], [8, 1.3028], [12, 1.2627], [16, 1.2874]], "1": [[2, 1.1593], [4, 1.1576], [8, 1.3115], [12, 1.2282], [16, 1.2697]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.0886], [4, 1.1195], [8, 1.2087], [12, 1.2537], [16, 1.2769]], "1": [[2, 1.1388], [4, 1.1667], [8, 1.2239], [12, 1.2146], [16, 1.2978]]},
"Manipulator with MoveIt": {"0": [[2, 1.1062], [4, 1.1581], [8, 1.206], [12, 1.2682], [16, 1.2922]], "1": [[2, 1.1361], [4, 1.1064], [8, 1.1984], [12, 1.2735], [16, 1.3168]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0995], [4, 1.1485]], "1": [[2, 1.1015], [4, 1.1536]]},
},
"Cyclone DDS multicast SEDP": {
"One bare node": {"0": [[2, 1.2819], [4, 1.0831], [8, 1.0869], [12, 1.2226], [16, 1.2135]], "1": [[2, 1.0955], [4, 1.0289], [8, 1.0348], [12, 1.1838], [16, 1.1732]]},
"Nav2 in one process": {"0": [[2, 1.0147], [4, 1.0145], [8, 1.0301], [12, 1.046], [16, 1.0577]], "1": [[2, 1.0369], [4, 1.0226], [8, 1.0313], [12, 1.0461], [16, 1.0452]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.0305], [4, 1.0098], [8, 1.0411], [12, 1.0457], [16, 1.0532]], "1": [[2, 1.0369], [4, 1.0262], [8, 1.0442], [12, 1.0515], [16, 1.0584]]},
"The paper's swarm": {"0": [[2, 1.0618], [4, 1.0268], [8, 1.1268], [12, 1.1045], [16, 1.1314]], "1": [[2, 1.0642], [4, 1.0826], [8, 1.0891], [12, 1.1148], [16, 1.1406]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.0085], [4, 1.0213], [8, 1.0627], [12, 1.0621], [16, 1.0849]], "1": [[2, 1.0263], [4, 1.0172], [8, 1.0557], [12, 1.0521], [16, 1.0844]]},
"Manipulator with MoveIt": {"0": [[2, 1.0327], [4, 1.022], [8, 1.0484], [12, 1.0616], [16, 1.0626]], "1": [[2, 1.0047], [4, 1.0269], [8, 1.0382], [12, 1.0617], [16, 1.0691]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0082], [4, 1.0266]], "1": [[2, 1.0126], [4, 1.0239]]},
},
"Cyclone DDS peers": {
"One bare node": {"0": [[2, 1.457], [4, 1.2192], [8, 1.2207], [12, 1.251], [16, 1.2983]], "1": [[2, 1.578], [4, 1.1686], [8, 1.2273], [12, 1.3072], [16, 1.2337]]},
"Nav2 in one process": {"0": [[2, 1.0997], [4, 1.1889], [8, 1.2701], [12, 1.2601], [16, 1.3048]], "1": [[2, 1.1687], [4, 1.1502], [8, 1.2454], [12, 1.2589], [16, 1.3222]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.0892], [4, 1.1065], [8, 1.213], [12, 1.2935], [16, 1.3034]], "1": [[2, 1.1547], [4, 1.124], [8, 1.2274], [12, 1.2778], [16, 1.3212]]},
"The paper's swarm": {"0": [[2, 1.3296], [4, 1.166], [8, 1.2385], [12, 1.2332], [16, 1.2823]], "1": [[2, 1.4453], [4, 1.1679], [8, 1.1693], [12, 1.2251], [16, 1.2409]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.1461], [4, 1.2435], [8, 1.2227], [12, 1.2389], [16, 1.2917]], "1": [[2, 1.3943], [4, 1.11], [8, 1.203], [12, 1.2418], [16, 1.2826]]},
"Manipulator with MoveIt": {"0": [[2, 1.0969], [4, 1.1476], [8, 1.1986], [12, 1.2471], [16, 1.2966]], "1": [[2, 1.127], [4, 1.1811], [8, 1.1775], [12, 1.241], [16, 1.3052]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0941], [4, 1.1322]], "1": [[2, 1.0889], [4, 1.1394]]},
},
"Cyclone DDS, version 11": {
"One bare node": {"0": [[2, 1.4366], [4, 1.2866], [8, 1.2403], [12, 1.3978], [16, 1.2862]], "1": [[2, 1.1647], [4, 1.1679], [8, 1.2853], [12, 1.3413], [16, 1.2742]]},
"Nav2 in one process": {"0": [[2, 1.2213], [4, 1.1018], [8, 1.145], [12, 1.231], [16, 1.2776]], "1": [[2, 1.077], [4, 1.1517], [8, 1.1915], [12, 1.2244], [16, 1.2912]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1487], [4, 1.1281], [8, 1.1877], [12, 1.2545], [16, 1.2972]], "1": [[2, 1.0692], [4, 1.1515], [8, 1.2038], [12, 1.2482], [16, 1.3097]]},
"The paper's swarm": {"0": [[2, 1.1567], [4, 1.1324], [8, 1.1748], [12, 1.2274], [16, 1.2195]], "1": [[2, 1.1564], [4, 1.1681], [8, 1.1423], [12, 1.2463], [16, 1.2838]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.0746], [4, 1.1177], [8, 1.1804], [12, 1.2689], [16, 1.2619]], "1": [[2, 1.1403], [4, 1.1305], [8, 1.2002], [12, 1.2577], [16, 1.3286]]},
"Manipulator with MoveIt": {"0": [[2, 1.162], [4, 1.121], [8, 1.184], [12, 1.254], [16, 1.3049]], "1": [[2, 1.0712], [4, 1.1502], [8, 1.2015], [12, 1.2525], [16, 1.2948]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.087], [4, 1.1385]], "1": [[2, 1.0988], [4, 1.1417]]},
},
"DDS": {
"One bare node": {"0": [[2, 1.6582], [4, 1.3723], [8, 1.4027], [12, 1.6284], [16, 1.4387]], "1": [[2, 1.2769], [4, 1.2064], [8, 1.3107], [12, 1.3705], [16, 1.2802]]},
"Nav2 in one process": {"0": [[2, 1.1823], [4, 1.1174], [8, 1.2034], [12, 1.2299], [16, 1.2952]], "1": [[2, 1.1265], [4, 1.1327], [8, 1.1813], [12, 1.2554], [16, 1.2982]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1414], [4, 1.1123], [8, 1.1733], [12, 1.2489], [16, 1.3026]], "1": [[2, 1.0966], [4, 1.1464], [8, 1.1941], [12, 1.2457], [16, 1.3057]]},
"The paper's swarm": {"0": [[2, 1.2583], [4, 1.1827], [8, 1.2524], [12, 1.3412], [16, 1.3148]], "1": [[2, 1.3837], [4, 1.0907], [8, 1.2439], [12, 1.2839], [16, 1.2718]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.2306], [4, 1.1362], [8, 1.2097], [12, 1.2234], [16, 1.3139]], "1": [[2, 1.172], [4, 1.1325], [8, 1.1977], [12, 1.2334], [16, 1.2708]]},
"Manipulator with MoveIt": {"0": [[2, 1.1613], [4, 1.1231], [8, 1.2156], [12, 1.2419], [16, 1.3032]], "1": [[2, 1.0768], [4, 1.1039], [8, 1.202], [12, 1.2325], [16, 1.2584]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0789], [4, 1.1364]], "1": [[2, 1.1022], [4, 1.1383]]},
},
"Fast DDS": {
"One bare node": {"0": [[2, 1.1523], [4, 1.1182], [8, 1.1246], [12, 1.2183], [16, 1.2231]], "1": [[2, 1.1295], [4, 1.1061], [8, 1.1132], [12, 1.2798], [16, 1.2103]]},
"Nav2 in one process": {"0": [[2, 1.1654], [4, 1.1251], [8, 1.2132], [12, 1.2297], [16, 1.2872]], "1": [[2, 1.1524], [4, 1.1065], [8, 1.1725], [12, 1.2498], [16, 1.285]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1329], [4, 1.1276], [8, 1.1826], [12, 1.2452], [16, 1.3172]], "1": [[2, 1.1579], [4, 1.1396], [8, 1.202], [12, 1.2454], [16, 1.298]]},
"The paper's swarm": {"0": [[2, 1.0323], [4, 1.0354], [8, 1.1423], [12, 1.1512], [16, 1.1937]], "1": [[2, 1.037], [4, 1.0894], [8, 1.1451], [12, 1.2029], [16, 1.1862]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.0988], [4, 1.0655], [8, 1.124], [12, 1.1886], [16, 1.2573]], "1": [[2, 1.0666], [4, 1.056], [8, 1.1573], [12, 1.186], [16, 1.2611]]},
"Manipulator with MoveIt": {"0": [[2, 1.0726], [4, 1.0772], [8, 1.1837], [12, 1.2154], [16, 1.2557]], "1": [[2, 1.0712], [4, 1.1079], [8, 1.1774], [12, 1.2233], [16, 1.2697]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0418], [4, 1.0993]], "1": [[2, 1.0404], [4, 1.1062]]},
},
"Fast DDS Discovery Server": {
"One bare node": {"0": [[2, 1.6115], [4, 1.3047], [8, 1.4548], [12, 1.4219], [16, 1.3904]], "1": [[2, 1.6196], [4, 1.3106], [8, 1.2356], [12, 1.3459], [16, 1.7826]]},
"Nav2 in one process": {"0": [[2, 1.1259], [4, 1.369], [8, 1.4464], [12, 1.3575], [16, 1.3422]], "1": [[2, 1.255], [4, 1.1808], [8, 1.268], [12, 1.366], [16, 1.3456]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1286], [4, 1.1889], [8, 1.2169], [12, 1.2317], [16, 1.2589]], "1": [[2, 1.168], [4, 1.1625], [8, 1.2035], [12, 1.2153], [16, 1.2093]]},
"The paper's swarm": {"0": [[2, 1.2658], [4, 1.1534], [8, 1.1959], [12, 1.4215], [16, 1.281]], "1": [[2, 2.8635], [4, 1.242], [8, 1.1888], [12, 1.3442], [16, 1.2508]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.1707], [4, 1.1371], [8, 1.2425], [12, 1.3066], [16, 1.2406]], "1": [[2, 1.2445], [4, 1.2228], [8, 1.0927], [12, 1.239], [16, 1.4255]]},
"Manipulator with MoveIt": {"0": [[2, 1.1536], [4, 1.1354], [8, 1.16], [12, 1.1609], [16, 1.2029]], "1": [[2, 1.2845], [4, 1.186], [8, 1.1661], [12, 1.1558], [16, 1.1902]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0678], [4, 1.0735]], "1": [[2, 1.0547], [4, 1.0767]]},
},
"Fast DDS Discovery Server, on a robot": {
"One bare node": {"0": [[2, 1.6338], [4, 1.4811], [8, 1.4258], [12, 1.4281], [16, 1.4002]], "1": [[2, 1.3988], [4, 1.1871], [8, 1.2921], [12, 1.3256], [16, 1.6441]]},
"Nav2 in one process": {"0": [[2, 1.2142], [4, 1.2093], [8, 1.2472], [12, 1.2525], [16, 1.3769]], "1": [[2, 1.2144], [4, 1.2031], [8, 1.2183], [12, 1.2577], [16, 1.3224]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.177], [4, 1.1482], [8, 1.2399], [12, 1.275], [16, 1.3581]], "1": [[2, 1.1116], [4, 1.1596], [8, 1.1878], [12, 1.2469], [16, 1.3133]]},
"The paper's swarm": {"0": [[2, 1.5022], [4, 1.2121], [8, 1.2985], [12, 1.2292], [16, 1.3476]], "1": [[2, 1.248], [4, 1.211], [8, 1.2659], [12, 1.4025], [16, 1.3132]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.437], [4, 1.1767], [8, 1.3661], [12, 1.2355], [16, 1.3715]], "1": [[2, 1.3554], [4, 1.1599], [8, 1.3003], [12, 1.2945], [16, 1.3226]]},
"Manipulator with MoveIt": {"0": [[2, 1.1368], [4, 1.1711], [8, 1.2445], [12, 1.2408], [16, 1.2838]], "1": [[2, 1.2215], [4, 1.1408], [8, 1.1721], [12, 1.257], [16, 1.2846]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.071], [4, 1.1339]], "1": [[2, 1.0911], [4, 1.1448]]},
},
"Fast DDS Discovery Server, two": {
"One bare node": {"0": [[2, 1.3197], [4, 1.1955], [8, 1.361], [12, 1.7171], [16, 1.3667]], "1": [[2, 1.4639], [4, 1.1723], [8, 1.2451], [12, 1.2671], [16, 1.2135]]},
"Nav2 in one process": {"0": [[2, 1.2306], [4, 1.2137], [8, 1.2712], [12, 1.2348], [16, 1.2911]], "1": [[2, 1.252], [4, 1.1806], [8, 1.2704], [12, 1.2787], [16, 1.2984]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1558], [4, 1.2048], [8, 1.2031], [12, 1.2143], [16, 1.2387]], "1": [[2, 1.1344], [4, 1.192], [8, 1.2009], [12, 1.2208], [16, 1.2344]]},
"The paper's swarm": {"0": [[2, 1.1544], [4, 1.1727], [8, 1.1852], [12, 1.1351], [16, 1.2347]], "1": [[2, 1.1495], [4, 1.1624], [8, 1.1654], [12, 1.2912], [16, 1.1926]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.2498], [4, 1.1311], [8, 1.358], [12, 1.1841], [16, 1.2237]], "1": [[2, 1.3439], [4, 1.2274], [8, 1.1395], [12, 1.193], [16, 1.2161]]},
"Manipulator with MoveIt": {"0": [[2, 1.2051], [4, 1.1891], [8, 1.1313], [12, 1.194], [16, 1.1707]], "1": [[2, 1.3348], [4, 1.105], [8, 1.152], [12, 1.1525], [16, 1.1781]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0488], [4, 1.076]], "1": [[2, 1.0573], [4, 1.0708]]},
},
"Zenoh": {
"One bare node": {"0": [[2, 2.5708], [4, 1.809], [8, 1.5348], [12, 1.5329], [16, 1.564]], "1": [[2, 1.5053], [4, 1.3616], [8, 1.4083], [12, 1.4696], [16, 1.978]]},
"Nav2 in one process": {"0": [[2, 1.2201], [4, 1.1178], [8, 1.1632], [12, 1.2435], [16, 1.3062]], "1": [[2, 1.1475], [4, 1.1244], [8, 1.2046], [12, 1.2523], [16, 1.2995]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1612], [4, 1.1005], [8, 1.1787], [12, 1.2438], [16, 1.3027]], "1": [[2, 1.099], [4, 1.1492], [8, 1.1816], [12, 1.2378], [16, 1.283]]},
"The paper's swarm": {"0": [[2, 1.6089], [4, 1.3481], [8, 1.2902], [12, 1.3262], [16, 1.2974]], "1": [[2, 1.98], [4, 1.2243], [8, 1.3503], [12, 1.395], [16, 1.3592]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.3547], [4, 1.1626], [8, 1.2239], [12, 1.2331], [16, 1.222]], "1": [[2, 1.2323], [4, 1.1078], [8, 1.2004], [12, 1.306], [16, 1.2771]]},
"Manipulator with MoveIt": {"0": [[2, 1.1651], [4, 1.0951], [8, 1.1887], [12, 1.2415], [16, 1.2879]], "1": [[2, 1.1443], [4, 1.1563], [8, 1.234], [12, 1.2536], [16, 1.2958]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0892], [4, 1.1184]], "1": [[2, 1.0917], [4, 1.1223]]},
},
"Zenoh peer": {
"One bare node": {"0": [[2, 1.9735], [4, 1.5476], [8, 1.4762], [12, 1.5975], [16, 1.5067]], "1": [[2, 1.428], [4, 1.6394], [8, 1.4168], [12, 1.4047], [16, 1.6382]]},
"Nav2 in one process": {"0": [[2, 1.3042], [4, 1.1196], [8, 1.1843], [12, 1.2755], [16, 1.3317]], "1": [[2, 1.1691], [4, 1.1446], [8, 1.2172], [12, 1.2463], [16, 1.3063]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.2374], [4, 1.1168], [8, 1.2264], [12, 1.2581], [16, 1.3089]], "1": [[2, 1.1391], [4, 1.1157], [8, 1.2218], [12, 1.2596], [16, 1.3039]]},
"The paper's swarm": {"0": [[2, 1.3781], [4, 1.4078], [8, 1.1737], [12, 1.3932], [16, 1.3295]], "1": [[2, 1.2514], [4, 1.1156], [8, 1.2625], [12, 1.3108], [16, 1.326]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.2844], [4, 1.1028], [8, 1.176], [12, 1.2931], [16, 1.2851]], "1": [[2, 1.1368], [4, 1.1276], [8, 1.2836], [12, 1.2314], [16, 1.2876]]},
"Manipulator with MoveIt": {"0": [[2, 1.183], [4, 1.1192], [8, 1.2152], [12, 1.2326], [16, 1.2851]], "1": [[2, 1.1179], [4, 1.1609], [8, 1.2368], [12, 1.2585], [16, 1.2977]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0823], [4, 1.1263]], "1": [[2, 1.0747], [4, 1.1293]]},
},
"Zenoh peer, tokens": {
"One bare node": {"0": [[2, 1.527], [4, 1.2851], [8, 1.3514], [12, 1.4385], [16, 1.3265]], "1": [[2, 1.2209], [4, 1.176], [8, 1.2547], [12, 1.3451], [16, 1.2989]]},
"Nav2 in one process": {"0": [[2, 1.1785], [4, 1.1515], [8, 1.2215], [12, 1.2684], [16, 1.3138]], "1": [[2, 1.1718], [4, 1.1732], [8, 1.2391], [12, 1.2779], [16, 1.2984]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1459], [4, 1.1351], [8, 1.2388], [12, 1.2759], [16, 1.3296]], "1": [[2, 1.1259], [4, 1.1406], [8, 1.2259], [12, 1.261], [16, 1.3221]]},
"The paper's swarm": {"0": [[2, 1.1848], [4, 1.2688], [8, 1.3019], [12, 1.25], [16, 1.3204]], "1": [[2, 1.2625], [4, 1.1269], [8, 1.2249], [12, 1.2538], [16, 1.2412]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.2807], [4, 1.0669], [8, 1.2237], [12, 1.2567], [16, 1.2785]], "1": [[2, 1.1831], [4, 1.1306], [8, 1.2024], [12, 1.285], [16, 1.3281]]},
"Manipulator with MoveIt": {"0": [[2, 1.1046], [4, 1.1284], [8, 1.186], [12, 1.2463], [16, 1.3154]], "1": [[2, 1.1577], [4, 1.126], [8, 1.233], [12, 1.2578], [16, 1.3097]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0827], [4, 1.131]], "1": [[2, 1.098], [4, 1.1311]]},
},
"Zenoh router": {
"One bare node": {"0": [[2, 2.2575], [4, 1.6298], [8, 1.6748], [12, 1.3264], [16, 1.3945]], "1": [[2, 1.654], [4, 1.3956], [8, 1.3106], [12, 1.4499], [16, 1.3867]]},
"Nav2 in one process": {"0": [[2, 1.2576], [4, 1.145], [8, 1.1558], [12, 1.1195], [16, 1.0976]], "1": [[2, 1.2039], [4, 1.1426], [8, 1.1265], [12, 1.122], [16, 1.0995]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.1713], [4, 1.1302], [8, 1.1264], [12, 1.1254], [16, 1.1099]], "1": [[2, 1.246], [4, 1.1333], [8, 1.1286], [12, 1.1014], [16, 1.0946]]},
"The paper's swarm": {"0": [[2, 1.6409], [4, 1.3359], [8, 1.2885], [12, 1.2639], [16, 1.1969]], "1": [[2, 1.3712], [4, 1.235], [8, 1.1406], [12, 1.2385], [16, 1.7924]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.1365], [4, 1.1481], [8, 1.1151], [12, 1.1225], [16, 1.083]], "1": [[2, 1.3366], [4, 1.2853], [8, 1.1012], [12, 1.1309], [16, 1.0923]]},
"Manipulator with MoveIt": {"0": [[2, 1.2198], [4, 1.065], [8, 1.0326], [12, 1.0579], [16, 1.0564]], "1": [[2, 1.2237], [4, 1.1315], [8, 1.0486], [12, 1.0563], [16, 1.0664]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0263], [4, 1.0129]], "1": [[2, 1.0148], [4, 1.0154]]},
},
"Zenoh router per host": {
"One bare node": {"0": [[2, 2.3139], [4, 1.3505], [8, 1.2277], [12, 1.2863], [16, 1.3934]], "1": [[2, 1.3569], [4, 1.2477], [8, 1.2517], [12, 1.3477], [16, 1.2813]]},
"Nav2 in one process": {"0": [[2, 1.1025], [4, 1.0868], [8, 1.172], [12, 1.2779], [16, 1.2866]], "1": [[2, 1.1704], [4, 1.1694], [8, 1.1955], [12, 1.2671], [16, 1.3326]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.0514], [4, 1.1071], [8, 1.2435], [12, 1.258], [16, 1.3119]], "1": [[2, 1.1317], [4, 1.1426], [8, 1.2245], [12, 1.2783], [16, 1.3247]]},
"The paper's swarm": {"0": [[2, 2.222], [4, 1.3941], [8, 1.5802], [12, 1.2163], [16, 1.2838]], "1": [[2, 1.7761], [4, 1.2723], [8, 1.3797], [12, 1.3135], [16, 1.3201]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.4251], [4, 1.1972], [8, 1.1624], [12, 1.2029], [16, 1.3008]], "1": [[2, 1.5434], [4, 1.15], [8, 1.1878], [12, 1.2494], [16, 1.2957]]},
"Manipulator with MoveIt": {"0": [[2, 1.2935], [4, 1.1675], [8, 1.1728], [12, 1.1937], [16, 1.2595]], "1": [[2, 1.2802], [4, 1.1291], [8, 1.1666], [12, 1.2428], [16, 1.2836]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.0831], [4, 1.1365]], "1": [[2, 1.2114], [4, 1.0717]]},
},
"Zenoh router per host, star": {
"One bare node": {"0": [[2, 2.2144], [4, 1.5363], [8, 1.628], [12, 1.2837], [16, 1.4534]], "1": [[2, 1.6235], [4, 1.4788], [8, 1.2939], [12, 1.425], [16, 1.4078]]},
"Nav2 in one process": {"0": [[2, 1.1473], [4, 1.0497], [8, 1.0835], [12, 1.062], [16, 1.0608]], "1": [[2, 1.1863], [4, 1.0905], [8, 1.035], [12, 1.0744], [16, 1.0573]]},
"Drone, PX4 through MAVROS": {"0": [[2, 1.2668], [4, 1.1007], [8, 1.0372], [12, 1.0499], [16, 1.05]], "1": [[2, 1.3016], [4, 1.0162], [8, 1.0799], [12, 1.0618], [16, 1.0572]]},
"The paper's swarm": {"0": [[2, 2.1114], [4, 1.4972], [8, 1.5421], [12, 1.3418], [16, 1.3155]], "1": [[2, 1.6416], [4, 1.6285], [8, 1.2509], [12, 1.2712], [16, 1.3364]]},
"Drone, PX4 through uXRCE-DDS": {"0": [[2, 1.3121], [4, 1.4318], [8, 1.1352], [12, 1.0921], [16, 1.1089]], "1": [[2, 2.1681], [4, 1.2064], [8, 1.2097], [12, 1.2591], [16, 1.2127]]},
"Manipulator with MoveIt": {"0": [[2, 1.1583], [4, 1.1798], [8, 1.1113], [12, 1.0971], [16, 1.0634]], "1": [[2, 1.2263], [4, 1.1593], [8, 1.0886], [12, 1.1], [16, 1.0789]]},
"TurtleBot 4 with Nav2": {"0": [[2, 1.2603], [4, 1.093]], "1": [[2, 1.1657], [4, 1.0973]]},
},
},
},
},
"discovery": {
"within": 60,
"give_up": 3,
"runs": 10,
"few_runs": 3,
"long_run": 1,
"seed": 0,
"queue": [500, 0.5],
"max_seconds": 40,
"max_megabytes": 500,
"max_work": 50,
"max_processes": 3000,
"max_changes": 9,
"most_pairs": 0.95,
"many_lost": 0.5,
"few_lost": 0.1,
"many_expired": 0.05,
"other_software": ["build", "switch", "research"],
"too_large": "the simulation would take too much time or memory",
"shown": 3,
},
"sentences": {
"works": "Yes, this startup works: {fleet} discover each other within {within} ({how}).",
"works in simulations": "Not sure: in simulations, {fleet} discover each other within {within} ({how}), but {caution}.",
"too slow": "No, not within {within}: {fleet} need longer to discover each other ({how}).",
"never": "No. {fleet} do not all discover each other within {until} ({how}).",
"unrepaired": "Not sure: {fleet} need at least {low} ({how}), and losses make it longer.",
"unrepaired and slow": "No, not within {within}: {fleet} need at least {low} ({how}).",
"too busy": "No, not within {within}: {fleet} keep the channel busy for {drain} even if nothing is lost ({how}).",
"endless": "No. {fleet} never all discover each other ({how}).",
"unknown": "Not sure: {fleet} keep the channel busy for {drain} if nothing is lost ({how}), and their discovery time was not simulated.",
"times": "Discovery time: {median} in the median run, {nine} or less in nine of ten runs.",
"times of some": "Discovery time: {median} in the median run; {late} of {runs} runs do not finish within {until}.",
"most pairs": "{share} of the pairs of processes are done after {time}.",
"share of pairs": "After {until}, {share} of the pairs of processes are done.",
"busy": "The channel falls idle after {median} (median). {lost} of the messages are lost on the way, and no repairs are simulated with {protocol}.",
"not simulated": "Not simulated: {reason}.",
"periodic traffic fills": "Periodic traffic alone fills the channel.",
"access point loses": "The access point's queue loses {lost} of all messages, more than {protocol} repeats in time.",
"robots lose": "The robots' queues lose {lost} of all messages, more than {protocol} repeats in time.",
"air loses": "Collisions lose {lost} of all messages, more than {protocol} repeats in time.",
"leases end": "Leases end sooner than the startup, so robots forget each other.",
"data overload": "Your data do not fit beside discovery: see --why.",
"first": "First step:",
"faster": "Faster still:",
"then": "Or:",
"shorter": "These changes help, but none is enough within {within}:",
"none helps": "None of the {count} changes that we simulated helps by more than the runs scatter.",
"none known": "No change helps that we could simulate.",
"change": "{number}. {what}: {before} -> {after}. Effort: {effort}. Cost: {cost}.",
"paste": " Configuration: --paste {name}.",
"closed form": "In order of airtime saved; their discovery time was not simulated:",
"drain": "- {what}: never -> the channel falls idle after {after}, if nothing is lost.",
"none ends": "No change is enough: after each that we know, periodic traffic alone still fills the channel.",
"possible": "May help, but repairs are not simulated: {names}.",
"bounds": "Not known, because repairs are not simulated: {names}.",
"parts": "Some robots no longer discover each other after: {names}.",
"others": "Simulated without a gain: {names}.",
"left out": "Not simulated, because {reason}: {names}.",
"sure": "How sure: {runs} simulated runs of {until} with fixed seeds; in parentheses {interval}. One access point, all robots in reach, queues of 500 messages.",
"never means": "'never' means: not within the {until} that we simulated.",
"rounded": "{name}: a process has {mean} endpoints on average; we simulate {whole}.",
"extrapolated": "{protocol} was measured with at most {hosts}: more is extrapolated.",
"air": "Real {protocol} took {low} to {high} times the simulated time with up to {hosts} hosts on an emulated cell.",
"interrupted": "Interrupted: not all runs are done, so changes are missing.",
"surer": "To be surer, record one startup and compare it: `discostorm capture`.",
"why": "`--why` adds drain time, airtime, configurations, assumptions; `--all` all changes.",
},
"alone": "A single host has no one to discover, and no other host receives its messages.",
"topology": "one access point, infrastructure",
"limit": 1,
"told": 2,
"beyond": "; this fleet is larger, so expect a factor of 2, as far as we know",
"times": [[0, 1e-06, "µs"], [0.001, 0.001, "ms"], [0.1, 1, "s"], [100, 60, "minutes"], [6000, 3600, "hours"], [172800, 86400, "days"], [60480000, 31557600, "years"]],
"airtime": {"inside": {"up": s75, "multicast": "inside_multicast", "unicast": s75}, "linear": {"up": s76, "multicast": "linear_multicast", "unicast": s76}, "padded": {"up": s77, "multicast": s78, "unicast": s77}, "aggregated": {"up": s79, "multicast": s78, "unicast": s79}},
"laptop_nodes": 2,
"service_endpoints": 12,
"endpoints_of_a_node": 28.40740740740741,
"shared_endpoints": [2, 4],
"remedies": {
"aggregation": {"steps": ["aggregation"], "of": {"DDS": s82, "Zenoh": s82, "None": s82}},
"announcements": {"steps": ["announcements"], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s83, "best_case": false, "cost": s84, "mind": s84}, "Zenoh": null, "None": null}},
"discovery server": {
"steps": [s85],
"of": {
"DDS": {"efforts": ["server"], "effort": 3, "takes": s86, "best_case": false, "cost": s87, "mind": "each robot needs its address; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less; late joiners stay undiscovered while it is down, and after short outages"},
"Zenoh": null,
"None": null,
},
},
"discovery server on a robot": {
"steps": [s88],
"of": {"DDS": {"efforts": ["server"], "effort": 3, "takes": s86, "best_case": false, "cost": s87, "mind": "each robot needs its address; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less; late joiners stay undiscovered while that robot is away"}, "Zenoh": null, "None": null},
},
"endpoints": {"steps": ["endpoints"], "of": {"DDS": s90, "Zenoh": s90, "None": s90}},
"middleware": {"steps": ["middleware"], "of": {"DDS": s93, "Zenoh": {"efforts": ["switch"], "effort": 7, "takes": s91, "best_case": false, "cost": s94, "mind": s94}, "None": s93}},
"middleware and discovery server": {
"steps": ["middleware", s85],
"of": {
"DDS": {
"efforts": s95,
"effort": 7,
"takes": s96,
"best_case": false,
"cost": s97,
"mind": "all hosts must change together; each robot needs its address; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less; late joiners stay undiscovered while it is down, and after short outages",
},
"Zenoh": null,
"None": null,
},
},
"middleware and discovery server on a robot": {
"steps": ["middleware", s88],
"of": {
"DDS": {"efforts": s95, "effort": 7, "takes": s96, "best_case": false, "cost": s97, "mind": "all hosts must change together; each robot needs its address; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less; late joiners stay undiscovered while that robot is away"},
"Zenoh": null,
"None": null,
},
},
"middleware and multicast endpoint data": {"steps": ["middleware", s98], "of": {"DDS": {"efforts": s99, "effort": 7, "takes": s100, "best_case": false, "cost": s101, "mind": s101}, "Zenoh": null, "None": null}},
"middleware and peers": {"steps": ["middleware", "peers"], "of": {"DDS": {"efforts": s99, "effort": 7, "takes": s100, "best_case": false, "cost": s102, "mind": s102}, "Zenoh": {"efforts": s99, "effort": 7, "takes": s100, "best_case": false, "cost": s103, "mind": s103}, "None": null}},
"middleware and router": {
"steps": ["middleware", "router"],
"of": {
"DDS": null,
"Zenoh": {
"efforts": s95,
"effort": 7,
"takes": s96,
"best_case": false,
"cost": "all hosts must change together; each robot needs its address; data goes through it, too",
"mind": "all hosts must change together; each robot needs its address; data goes through it, too; robots do not hear each other until 2.2 s after the router is back (killed, lease of 10 s)",
},
"None": null,
},
},
"middleware and router on each host": {
"steps": ["middleware", s104],
"of": {
"DDS": null,
"Zenoh": {
"efforts": s105,
"effort": 7,
"takes": s106,
"best_case": false,
"cost": "all hosts must change together; every router needs the addresses of the others",
"mind": "all hosts must change together; every router needs the addresses of the others; a robot whose router is down hears no other robot until 4.2 s after the router is back",
},
"None": null,
},
},
"middleware and star of routers": {
"steps": ["middleware", s107],
"of": {
"DDS": null,
"Zenoh": {
"efforts": s105,
"effort": 7,
"takes": s106,
"best_case": false,
"cost": "all hosts must change together; every robot needs the wired router's address",
"mind": "all hosts must change together; every robot needs the wired router's address; robots do not hear each other while the wired router is away",
},
"None": null,
},
},
"middleware and static endpoints": {"steps": ["middleware", s108], "of": {"DDS": {"efforts": ["switch", "build"], "effort": 7, "takes": "another middleware and rebuilt nodes", "best_case": false, "cost": s109, "mind": s109}, "Zenoh": null, "None": null}},
"middleware and two discovery servers": {
"steps": ["middleware", s110],
"of": {
"DDS": {
"efforts": s105,
"effort": 7,
"takes": s106,
"best_case": false,
"cost": "all hosts must change together; each robot needs both addresses; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less",
"mind": "all hosts must change together; each robot needs both addresses; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less; late joiners stay undiscovered while both are down",
},
"Zenoh": null,
"None": null,
},
},
"multicast endpoint data": {"steps": [s98], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s83, "best_case": false, "cost": s111, "mind": s111}, "Zenoh": null, "None": null}},
"multicast rate": {"steps": [s13], "of": {"DDS": s113, "Zenoh": s113, "None": s113}},
"peers": {"steps": ["peers"], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s83, "best_case": false, "cost": s114, "mind": s114}, "Zenoh": {"efforts": ["file"], "effort": 2, "takes": s83, "best_case": false, "cost": s115, "mind": s115}, "None": null}},
"processes": {"steps": ["processes"], "of": {"DDS": s116, "Zenoh": s116, "None": s116}},
"radio": {"steps": ["radio"], "of": {"DDS": s118, "Zenoh": s118, "None": s118}},
"router": {
"steps": ["router"],
"of": {
"DDS": null,
"Zenoh": {"efforts": ["server"], "effort": 3, "takes": s86, "best_case": false, "cost": "each robot needs its address; data goes through it, too", "mind": "each robot needs its address; data goes through it, too; robots do not hear each other until 2.2 s after the router is back (killed, lease of 10 s)"},
"None": null,
},
},
"router on each host": {
"steps": [s104],
"of": {
"DDS": null,
"Zenoh": {"efforts": ["servers"], "effort": 4, "takes": s119, "best_case": false, "cost": "every router needs the addresses of the others", "mind": "every router needs the addresses of the others; a robot whose router is down hears no other robot until 4.2 s after the router is back"},
"None": null,
},
},
"staggered start": {"steps": ["staggered start"], "of": {"DDS": s121, "Zenoh": s121, "None": s121}},
"star of routers": {
"steps": [s107],
"of": {"DDS": null, "Zenoh": {"efforts": ["servers"], "effort": 4, "takes": s119, "best_case": false, "cost": "every robot needs the wired router's address", "mind": "every robot needs the wired router's address; robots do not hear each other while the wired router is away"}, "None": null},
},
"static endpoints": {"steps": [s108], "of": {"DDS": {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": s122, "mind": s122}, "Zenoh": null, "None": null}},
"two discovery servers": {
"steps": [s110],
"of": {
"DDS": {
"efforts": ["servers"],
"effort": 4,
"takes": s119,
"best_case": false,
"cost": "each robot needs both addresses; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less",
"mind": "each robot needs both addresses; ros2 tools must be super clients; servers of Fast DDS 3.5.0 and later save less; late joiners stay undiscovered while both are down",
},
"Zenoh": null,
"None": null,
},
},
},
"pastes": {
"aggregation": {
"any": [
{
"where": s123,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Leave band, channel and width as they are. With 802.11ac and ax, vht_capab lets 64 frames of any\n# length into an exchange; with 802.11n alone, leave out the last two lines.\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[SHORT-GI-20]\nieee80211ac=1\nvht_capab=[MAX-A-MPDU-LEN-EXP7]\n",
},
],
},
"announcements": {
"Fast DDS": [
{
"where": s124,
"version": s125,
"text": "<!-- Fast DDS 2.9.1: for every process -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"calm\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <initialAnnouncements>\n              <count>1</count>\n              <period>\n                <sec>1</sec>\n              </period>\n            </initialAnnouncements>\n            <leaseAnnouncement>\n              <sec>15</sec>\n            </leaseAnnouncement>\n            <leaseDuration>\n              <sec>100</sec>\n            </leaseDuration>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
],
"Cyclone DDS": [
{
"where": s124,
"version": s126,
"text": "<!-- Cyclone DDS 0.10.2 and 11.0.1: for every process -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <Discovery>\n      <LeaseDuration>100 s</LeaseDuration>\n      <SPDPInterval>30 s</SPDPInterval>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"discovery server": {
"any": [
{"where": s127, "version": s125, "text": "# Fast DDS 2.9.1: on a computer that is wired to the access point\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# The address is that of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n"},
s129,
{
"where": "for the server if it is a program of your own",
"version": s125,
"text": "<!-- Fast DDS 2.9.1: for the server if it is a program of your own -->\n<!-- Load: save as /etc/fast_dds.xml; the server's process runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"server\" is_default_profile=\"true\">\n      <rtps>\n        <prefix>44.53.00.5f.45.50.52.4f.53.49.4d.41</prefix>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SERVER</discoveryProtocol>\n          </discovery_config>\n          <metatrafficUnicastLocatorList>\n            <locator>\n              <udpv4>\n                <address>192.168.1.10</address>\n                <port>11811</port>\n              </udpv4>\n            </locator>\n          </metatrafficUnicastLocatorList>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
{
"where": "for a client that reads no environment",
"version": s125,
"text": "<!-- Fast DDS 2.9.1: for a client that reads no environment -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"client\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>CLIENT</discoveryProtocol>\n            <discoveryServersList>\n              <RemoteServer prefix=\"44.53.00.5f.45.50.52.4f.53.49.4d.41\">\n                <metatrafficUnicastLocatorList>\n                  <locator>\n                    <udpv4>\n                      <address>192.168.1.10</address>\n                      <port>11811</port>\n                    </udpv4>\n                  </locator>\n                </metatrafficUnicastLocatorList>\n              </RemoteServer>\n            </discoveryServersList>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
s130,
s131,
],
},
"discovery server on a robot": {
"any": [
{"where": "on one of the robots", "version": s125, "text": "# Fast DDS 2.9.1: on one of the robots\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# The address is that of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n"},
s129,
s130,
s131,
],
},
"endpoints": {
"any": [
{
"where": "where a node of your own is made (C++)",
"version": "ROS 2 Humble",
"text": "// ROS 2 Humble: where a node of your own is made (C++)\n// Load: compiled into the process of the node; no file, no environment variable\n// Not run here: compared with its documentation\nauto options = rclcpp::NodeOptions().start_parameter_services(false);\nauto node = std::make_shared<rclcpp::Node>(\"name\", options);\n",
},
],
},
"middleware": {
"Fast DDS": [
{
"where": s132,
"version": "ROS 2 Jazzy",
"text": "# ROS 2 Jazzy: on every computer\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_fastrtps_cpp\n",
},
],
"Cyclone DDS": [
{
"where": s132,
"version": "ROS 2 Jazzy",
"text": "# ROS 2 Jazzy: on every computer\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n",
},
],
"Zenoh": [
{
"where": s132,
"version": "ROS 2 Jazzy",
"text": "# ROS 2 Jazzy: on every computer\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_zenoh_cpp\n# The file for every process that is pasted beside this. Peers need no router: they warn and go on.\n# A router, where there is one, starts first: ros2 run rmw_zenoh_cpp rmw_zenohd\nexport ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n",
},
],
"Zenoh peers": [
{
"where": "on every computer, as /etc/zenoh_session.json5",
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: on every computer, as /etc/zenoh_session.json5\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n// Peers find each other by multicast, without a router, as Zenoh ships it.\n{\n  mode: \"peer\",\n  listen: { endpoints: [\"tcp/0.0.0.0:0\"] },\n  scouting: { multicast: { enabled: true } },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 10000, // as Zenoh ships it: a KeepAlive every 2.5 s; rmw_zenoh has 60000 and 2\n        keep_alive: 4,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
],
},
"multicast endpoint data": {
"any": [
{
"where": s124,
"version": s126,
"text": "<!-- Cyclone DDS 0.10.2 and 11.0.1: for every process -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <!-- On Wi-Fi it would send by multicast no more than its announcements. -->\n      <AllowMulticast>true</AllowMulticast>\n    </General>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"multicast rate": {
"any": [
{
"where": s123,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Frames to a group and those of management go out at the lowest basic rate, here 24 Mbit/s (in\n# units of 100 kbit/s). Older rates (not those of 802.11n and later) below it are gone: who is\n# too far away for it cannot join.\n# Band and channel: as you have them.\nhw_mode=a\nchannel=36\nsupported_rates=240 360 480 540\nbasic_rates=240\n",
},
],
},
"peers": {
"Cyclone DDS": [
{
"where": s124,
"version": s126,
"text": "<!-- Cyclone DDS 0.10.2 and 11.0.1: for every process -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <AllowMulticast>false</AllowMulticast>\n    </General>\n    <Discovery>\n      <!-- At least as many as a host has processes. -->\n      <ParticipantIndex>auto</ParticipantIndex>\n      <MaxAutoParticipantIndex>9</MaxAutoParticipantIndex>\n      <!-- Every host, this one included. -->\n      <Peers>\n        <Peer Address=\"192.168.1.21\"/>\n        <Peer Address=\"192.168.1.22\"/>\n        <Peer Address=\"192.168.1.23\"/>\n      </Peers>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
"DDS": [
{
"where": s128,
"version": "ROS 2 Jazzy",
"text": "# ROS 2 Jazzy: on every robot\n# Load: both are environment variables of every ROS 2 process: run in the shell or put in\n# the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST\nexport ROS_STATIC_PEERS=\"192.168.1.22;192.168.1.23\"\n",
},
],
"Zenoh": [
{
"where": "for every process, which is told of the robots of lower addresses",
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: for every process, which is told of the robots of lower addresses\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n// The first process of a host has port 7447, and goes on without the other one, as others without\n// that one. Who is connected to the first tells whom else to connect to: gossip.\n{\n  mode: \"peer\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\", \"tcp/0.0.0.0:0\"], exit_on_failure: false },\n  connect: {\n    endpoints: [\n      // The own host; the first process meets itself, says so as an error and tries again later.\n      \"tcp/127.0.0.1:7447#retry_period_init_ms=60000;retry_period_max_ms=60000\",\n      // Robots of lower addresses: each two are linked once, or both send KeepAlives twice.\n      \"tcp/192.168.1.21:7447\",\n      \"tcp/192.168.1.22:7447\",\n    ],\n  },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: {\n      target: [\"router\", \"peer\"],\n      autoconnect_strategy: { peer: { to_router: \"always\", to_peer: \"greater-zid\" } },\n    },\n  },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 10000, // as Zenoh ships it: a KeepAlive every 2.5 s; rmw_zenoh has 60000 and 2\n        keep_alive: 4,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
],
},
"processes": {
"any": [
{"where": "where Nav2 is started", "version": "ROS 2 Humble", "text": "# ROS 2 Humble: where Nav2 is started\n# Load: run in a shell; the process is ros2 launch\n# Not run here: compared with its documentation\nros2 launch nav2_bringup bringup_launch.py use_composition:=True\n"},
{
"where": "a launch file for nodes of your own that are built as components",
"version": "ROS 2 Humble",
"text": "# ROS 2 Humble: a launch file for nodes of your own that are built as components\n# Load: save as robot.launch.py; the process is ros2 launch robot.launch.py\n# Not run here: compared with its documentation\nfrom launch import LaunchDescription\nfrom launch_ros.actions import ComposableNodeContainer\nfrom launch_ros.descriptions import ComposableNode\n\n\ndef generate_launch_description():\n    nodes = [\n        ComposableNode(package=\"composition\", plugin=\"composition::Talker\", name=\"talker\"),\n        ComposableNode(package=\"composition\", plugin=\"composition::Listener\", name=\"listener\"),\n    ]\n    container = ComposableNodeContainer(\n        name=\"robot\",\n        namespace=\"\",\n        package=\"rclcpp_components\",\n        executable=\"component_container\",\n        composable_node_descriptions=nodes,\n    )\n    return LaunchDescription([container])\n",
},
],
},
"radio": {
"802.11n 40 MHz": [
{
"where": s123,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\n",
},
],
"802.11ac 80 MHz": [
{
"where": s123,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=1\nvht_oper_centr_freq_seg0_idx=42\nvht_capab=[SHORT-GI-80][MAX-A-MPDU-LEN-EXP7]\n",
},
],
"802.11ax 160 MHz": [
{
"where": s123,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Channels 52 to 64 are shared with radars: that needs a country.\ncountry_code=US\nieee80211d=1\nieee80211h=1\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=2\nvht_oper_centr_freq_seg0_idx=50\nvht_capab=[VHT160][SHORT-GI-80][SHORT-GI-160][MAX-A-MPDU-LEN-EXP7]\nieee80211ax=1\nhe_oper_chwidth=2\nhe_oper_centr_freq_seg0_idx=50\n",
},
],
},
"router": {
"any": [
s133,
{
"where": s124,
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: for every process\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n{\n  mode: \"client\",\n  connect: { endpoints: [\"tcp/192.168.1.10:7447\"] },\n  scouting: { multicast: { enabled: false } },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
],
},
"router on each host": {
"any": [
{
"where": "on every robot for its router, which is told of the robots of lower addresses",
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: on every robot for its router, which is told of the robots of lower addresses\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  // Robots of lower addresses: each two are linked once, or both send KeepAlives twice.\n  connect: { endpoints: [\"tcp/192.168.1.21:7447\", \"tcp/192.168.1.22:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
s134,
],
},
"staggered start": {
"any": [
{
"where": "where the programs of a robot are started",
"version": "bash 5.2",
"text": "# bash 5.2: where the programs of a robot are started\n# Load: put before the lines that start the processes, in the same bash script\n# The same WINDOW on all robots, in whole seconds: what the plan says, or more. $RANDOM is of bash.\nWINDOW=60\nsleep $((RANDOM % (WINDOW + 1)))\n",
},
],
},
"star of routers": {
"any": [
s133,
{
"where": "on every robot for its router, which is told of the wired one alone",
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: on every robot for its router, which is told of the wired one alone\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  // The router that is wired to the access point, and no other robot.\n  connect: { endpoints: [\"tcp/192.168.1.10:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
s134,
],
},
"static endpoints": {
"any": [
{
"where": s124,
"version": s125,
"text": "<!-- Fast DDS 2.9.1: for every process -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE); in ROS 2 it matches nothing without -->\n<!-- RMW_FASTRTPS_USE_QOS_FROM_XML=1 -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"robot\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <EDP>STATIC</EDP>\n            <static_edp_xml_config>file:///etc/fast_dds_static_endpoints.xml</static_edp_xml_config>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n    <!-- One for each endpoint of this process, by the name of its topic. -->\n    <data_writer profile_name=\"/robot1/odom\">\n      <userDefinedID>1</userDefinedID>\n    </data_writer>\n  </profiles>\n</dds>\n",
},
{
"where": s128,
"version": s125,
"text": "<!-- Fast DDS 2.9.1: on every robot -->\n<!-- Load: save as /etc/fast_dds_static_endpoints.xml, where the profile for every process -->\n<!-- looks for it; no environment variable of its own -->\n<staticdiscovery>\n  <!-- Every process, by the name of its participant (in ROS 2 its enclave), with all its\n       endpoints; no two of them all have the same number. -->\n  <participant>\n    <name>/robot1</name>\n    <writer>\n      <userId>1</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </writer>\n  </participant>\n  <participant>\n    <name>/laptop</name>\n    <reader>\n      <userId>2</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </reader>\n  </participant>\n</staticdiscovery>\n",
},
],
},
"two discovery servers": {
"any": [
{
"where": "on two computers that are wired to the access point",
"version": s125,
"text": "# Fast DDS 2.9.1: on two computers that are wired to the access point\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# The first line on one of them, the second on the other, each with its own address.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\nfastdds discovery -i 1 -l 192.168.1.11 -p 11811\n",
},
{
"where": "on every robot; the servers stand in the order of their numbers",
"version": s125,
"text": "# Fast DDS 2.9.1: on every robot; the servers stand in the order of their numbers\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: run\n# in the shell or put in the service file that starts the ROS 2 processes, before they start\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811;192.168.1.11:11811\"\n",
},
s130,
s131,
],
},
},
"fleets": ["processes", "endpoints"],
"largest": "largest",
"saturation": [null, "saturation", "saturation2"],
"drain": "drain",
"formulas": {
"count": ({ N_H, N_H1, N_P, N_P1 }) => { return N_H*N_P + N_H1*N_P1; },
"more": ({ N_H1, N_P, N_P1 }) => { return N_H1*N_P1 + N_P; },
"more2": ({ N_P }) => { return N_P; },
"count2": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return N_E*x1*(N_P*(N_H - 1) + x0) + N_E1*x0*(N_P1*(N_H1 - 1) + x1); },
"more3": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return N_E*N_P*x0 + N_E1*x0*(N_P + N_P1*(N_H1 - 1)); },
"more4": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P*N_P1; return N_E*Math.pow(N_P, 2) + N_E*x0 + N_E1*x0; },
"more5": ({ N_E, N_P }) => { return N_E*Math.pow(N_P, 2); },
"count3": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return x0*(N_P1*(N_H1 - 1) + x1) + x1*(N_P*(N_H - 1) + x0); },
"more6": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return N_P*x0 + x0*(N_P + N_P1*(N_H1 - 1)); },
"more7": ({ N_H1, N_P, N_P1 }) => { return 2*N_H1*N_P*N_P1 + Math.pow(N_P, 2); },
"more8": ({ N_P }) => { return Math.pow(N_P, 2); },
"count4": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; return (N_E*x0*(N_P*(N_H - 1) + x1) + N_E1*x1*(N_P1*(N_H1 - 1) + x0))*(x0 + x1 - 2); },
"more9": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return (N_E*N_P*x0 + N_E1*x0*(N_P + N_P1*(N_H1 - 1)))*(N_P + x0 - 2); },
"more10": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_P*x0; const x2 = N_E*x1; return N_P*(N_E1*x0*(N_P + N_P1*(N_H1 - 1)) + x2) + (N_P + x0 - 2)*(N_E*Math.pow(N_P, 2) + N_E1*x1 + x2); },
"more11": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return Math.pow(N_P, 2)*(N_E*N_P + N_E*x0 + N_E*(N_P + x0 - 2) + N_E1*x0); },
"more12": ({ N_E, N_P }) => { return N_E*Math.pow(N_P, 3); },
"count5": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; return (x0*(N_P*(N_H - 1) + x1) + x1*(N_P1*(N_H1 - 1) + x0))*(x0 + x1 - 2); },
"more13": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return (N_P*x0 + x0*(N_P + N_P1*(N_H1 - 1)))*(N_P + x0 - 2); },
"more14": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_P*x0; return N_P*(x0*(N_P + N_P1*(N_H1 - 1)) + x1) + (Math.pow(N_P, 2) + 2*x1)*(N_P + x0 - 2); },
"more15": ({ N_H1, N_P, N_P1 }) => { return Math.pow(N_P, 2)*(3*N_H1*N_P1 + 2*N_P - 2); },
"more16": ({ N_P }) => { return Math.pow(N_P, 3); },
"count6": ({  }) => { return 0; },
"count7": ({ N_H, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return (1/2)*N_S*x1*(N_P*(N_H - 1) + x0) + (1/2)*N_S1*x0*(N_P1*(N_H1 - 1) + x1); },
"more17": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = (1/2)*N_H1*N_P1; return N_P*N_S*x0 + N_S1*x0*(N_P + N_P1*(N_H1 - 1)); },
"more18": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = (1/2)*N_S; const x1 = N_H1*N_P*N_P1; return Math.pow(N_P, 2)*x0 + (1/2)*N_S1*x1 + x0*x1; },
"more19": ({ N_P, N_S }) => { return (1/2)*Math.pow(N_P, 2)*N_S; },
"count8": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return (1/2)*N_E*x1*(N_P*(N_H - 1) + x0) + (1/2)*N_E1*x0*(N_P1*(N_H1 - 1) + x1); },
"more20": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = (1/2)*N_H1*N_P1; return N_E*N_P*x0 + N_E1*x0*(N_P + N_P1*(N_H1 - 1)); },
"more21": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = (1/2)*N_E; const x1 = N_H1*N_P*N_P1; return (1/2)*N_E1*x1 + Math.pow(N_P, 2)*x0 + x0*x1; },
"more22": ({ N_E, N_P }) => { return (1/2)*N_E*Math.pow(N_P, 2); },
"count9": ({ N_H, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; return ((1/2)*N_S*x0*(N_P*(N_H - 1) + x1) + (1/2)*N_S1*x1*(N_P1*(N_H1 - 1) + x0))*(x0 + x1 - 2); },
"more23": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; const x1 = (1/2)*x0; return (N_P*N_S*x1 + N_S1*x1*(N_P + N_P1*(N_H1 - 1)))*(N_P + x0 - 2); },
"more24": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = (1/2)*N_S; const x1 = N_H1*N_P1; const x2 = N_P*x1; const x3 = x0*x2; const x4 = (1/2)*N_S1; return N_P*(x1*x4*(N_P + N_P1*(N_H1 - 1)) + x3) + (N_P + x1 - 2)*(Math.pow(N_P, 2)*x0 + x2*x4 + x3); },
"more25": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; return (1/2)*Math.pow(N_P, 2)*(N_P*N_S + N_S*x0 + N_S*(N_P + x0 - 2) + N_S1*x0); },
"more26": ({ N_P, N_S }) => { return (1/2)*Math.pow(N_P, 3)*N_S; },
"count10": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; return ((1/2)*N_E*x0*(N_P*(N_H - 1) + x1) + (1/2)*N_E1*x1*(N_P1*(N_H1 - 1) + x0))*(x0 + x1 - 2); },
"more27": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = (1/2)*x0; return (N_E*N_P*x1 + N_E1*x1*(N_P + N_P1*(N_H1 - 1)))*(N_P + x0 - 2); },
"more28": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = (1/2)*N_E; const x1 = N_H1*N_P1; const x2 = N_P*x1; const x3 = x0*x2; const x4 = (1/2)*N_E1; return N_P*(x1*x4*(N_P + N_P1*(N_H1 - 1)) + x3) + (N_P + x1 - 2)*(Math.pow(N_P, 2)*x0 + x2*x4 + x3); },
"more29": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return (1/2)*Math.pow(N_P, 2)*(N_E*N_P + N_E*x0 + N_E*(N_P + x0 - 2) + N_E1*x0); },
"more30": ({ N_E, N_P }) => { return (1/2)*N_E*Math.pow(N_P, 3); },
"count11": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H + N_H1 - 1; return N_H*N_P*x0 + N_H1*N_P1*x0; },
"more31": ({ N_H1, N_P, N_P1 }) => { return Math.pow(N_H1, 2)*N_P1 + N_H1*N_P; },
"more32": ({ N_H1, N_P, N_P1 }) => { return N_H1*N_P + N_H1*N_P1 + N_P; },
"count12": ({ N_H, N_H1 }) => { const x0 = N_H + N_H1 - 1; return N_H*x0 + N_H1*x0; },
"more33": ({ N_H1 }) => { return Math.pow(N_H1, 2) + N_H1; },
"more34": ({ N_H1 }) => { return 2*N_H1 + 1; },
"more35": ({  }) => { return 1; },
"count13": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; const x2 = 1.0*x0 + 1.0*x1 - 1.0; return x0*x2 + x1*x2; },
"more36": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = 1.0*N_P + 1.0*x0 - 1.0; return N_P*x1 + x0*x1; },
"more37": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = 1.0*N_P; return 1.0*Math.pow(N_P, 2) + x0*x1 + x1*(N_P + x0 - 1); },
"more38": ({ N_P }) => { return 1.0*Math.pow(N_P, 2); },
"count14": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { return N_E*N_H*N_P + N_E1*N_H1*N_P1; },
"more39": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { return N_E*N_P + N_E1*N_H1*N_P1; },
"more40": ({ N_E, N_P }) => { return N_E*N_P; },
"count15": ({ N_H, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; const x2 = x0 + x1 - 1; return N_S*x0*x2 + N_S1*x1*x2; },
"more41": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; const x1 = N_P + x0 - 1; return N_P*N_S*x1 + N_S1*x0*x1; },
"more42": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; return Math.pow(N_P, 2)*N_S + N_P*N_S*(N_P + x0 - 1) + N_P*N_S1*x0; },
"more43": ({ N_P, N_S }) => { return Math.pow(N_P, 2)*N_S; },
"count16": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; const x2 = x0 + x1 - 1; return N_E*x0*x2 + N_E1*x1*x2; },
"more44": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_P + x0 - 1; return N_E*N_P*x1 + N_E1*x0*x1; },
"more45": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return N_E*Math.pow(N_P, 2) + N_E*N_P*(N_P + x0 - 1) + N_E1*N_P*x0; },
"count17": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return 1.0*x0*(N_P1*(N_H1 - 1) + x1) + 1.0*x1*(N_P*(N_H - 1) + x0); },
"more46": ({ N_H1, N_P, N_P1 }) => { const x0 = 1.0*N_H1*N_P1; return N_P*x0 + x0*(N_P + N_P1*(N_H1 - 1)); },
"more47": ({ N_H1, N_P, N_P1 }) => { return 2.0*N_H1*N_P*N_P1 + 1.0*Math.pow(N_P, 2); },
"count18": ({ N_H, N_H1, N_P, N_P1 }) => { return N_H1*N_P1 + N_P*(N_H - 1); },
"more48": ({ N_H1, N_P1 }) => { return N_H1*N_P1; },
"count19": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return (N_P*(N_H - 1) + x0)*(1.0*N_H*N_P + 1.0*x0 - 1.0); },
"more49": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return x0*(1.0*N_P + 1.0*x0 - 1.0); },
"more50": ({ N_H1, N_P, N_P1 }) => { const x0 = 1.0*N_P; const x1 = N_H1*N_P1; return N_P*(x0 + 1.0*x1 - 1.0) + x0*x1; },
"count20": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { return N_E*N_P*(N_H - 1) + N_E1*N_H1*N_P1; },
"more51": ({ N_E1, N_H1, N_P1 }) => { return N_E1*N_H1*N_P1; },
"count21": ({ N_H, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P*N_S + N_S1*x0; return N_P*(N_H - 1)*(-N_S + x1) + x0*(-N_S1 + x1); },
"more52": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; return x0*(N_P*N_S + N_S1*x0 - N_S1); },
"more53": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_P*N_S; const x1 = N_H1*N_P1; return N_P*(-N_S + N_S1*x1 + x0) + x0*x1; },
"count22": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_E*N_H*N_P + N_E1*x0; return N_P*(-N_E + x1)*(N_H - 1) + x0*(-N_E1 + x1); },
"more54": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return x0*(N_E*N_P + N_E1*x0 - N_E1); },
"more55": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_E*N_P; const x1 = N_H1*N_P1; return N_P*(-N_E + N_E1*x1 + x0) + x0*x1; },
"count23": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; const x2 = x0 + x1 - 1; return x0*x2 + x1*x2; },
"more56": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_P + x0 - 1; return N_P*x1 + x0*x1; },
"more57": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return Math.pow(N_P, 2) + N_P*x0 + N_P*(N_P + x0 - 1); },
"count24": ({ N_H, N_H1 }) => { return N_H + N_H1; },
"more58": ({ N_H1 }) => { return N_H1 + 1; },
"count25": ({ N_E, N_E1, N_P, N_P1 }) => { return N_E*N_P + N_E1*N_P1; },
"count26": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { return (1/2)*N_E*N_H*N_P*(N_E + 1) + (1/2)*N_E1*N_H1*N_P1*(N_E1 + 1); },
"more59": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { return (1/2)*N_E*N_P*(N_E + 1) + (1/2)*N_E1*N_H1*N_P1*(N_E1 + 1); },
"more60": ({ N_E, N_P }) => { return (1/2)*N_E*N_P*(N_E + 1); },
"count27": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return (1/2)*N_E*x1*(N_E + 1)*(N_P*(N_H - 1) + x0) + (1/2)*N_E1*x0*(N_E1 + 1)*(N_P1*(N_H1 - 1) + x1); },
"more61": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = (1/2)*N_H1*N_P1; return N_E*N_P*x0*(N_E + 1) + N_E1*x0*(N_E1 + 1)*(N_P + N_P1*(N_H1 - 1)); },
"more62": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = (1/2)*N_E*(N_E + 1); const x1 = N_H1*N_P*N_P1; return (1/2)*N_E1*x1*(N_E1 + 1) + Math.pow(N_P, 2)*x0 + x0*x1; },
"more63": ({ N_E, N_P }) => { return (1/2)*N_E*Math.pow(N_P, 2)*(N_E + 1); },
"count28": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return x0*(N_E1 - N_S1)*(N_P1*(N_H1 - 1) + x1) + x1*(N_E - N_S)*(N_P*(N_H - 1) + x0); },
"more64": ({ N_E, N_E1, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H1*N_P1; return N_P*x0*(N_E - N_S) + x0*(N_E1 - N_S1)*(N_P + N_P1*(N_H1 - 1)); },
"more65": ({ N_E, N_E1, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_E - N_S; const x1 = N_H1*N_P*N_P1; return Math.pow(N_P, 2)*x0 + x0*x1 + x1*(N_E1 - N_S1); },
"more66": ({ N_E, N_P, N_S }) => { return Math.pow(N_P, 2)*(N_E - N_S); },
"count29": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1, N_S, N_S1 }) => { return N_H*N_P*(N_E - N_S) + N_H1*N_P1*(N_E1 - N_S1); },
"more67": ({ N_E, N_E1, N_H1, N_P, N_P1, N_S, N_S1 }) => { return N_H1*N_P1*(N_E1 - N_S1) + N_P*(N_E - N_S); },
"more68": ({ N_E, N_P, N_S }) => { return N_P*(N_E - N_S); },
"count30": ({ N_H, N_H1, N_P, N_P1, N_S, N_S1 }) => { return (1/2)*N_H*N_P*N_S + (1/2)*N_H1*N_P1*N_S1; },
"more69": ({ N_H1, N_P, N_P1, N_S, N_S1 }) => { return (1/2)*N_H1*N_P1*N_S1 + (1/2)*N_P*N_S; },
"more70": ({ N_P, N_S }) => { return (1/2)*N_P*N_S; },
"count31": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { return (1/2)*N_E*N_H*N_P + (1/2)*N_E1*N_H1*N_P1; },
"more71": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { return (1/2)*N_E*N_P + (1/2)*N_E1*N_H1*N_P1; },
"more72": ({ N_E, N_P }) => { return (1/2)*N_E*N_P; },
"count32": ({ N_H, N_H1 }) => { const x0 = N_H + N_H1; const x1 = x0 - 1; return (x0 - 2)*(N_H*x1 + N_H1*x1); },
"more73": ({ N_H1 }) => { return (N_H1 - 1)*(Math.pow(N_H1, 2) + N_H1); },
"more74": ({ N_H1 }) => { return Math.pow(N_H1, 2) + N_H1 + (N_H1 - 1)*(2*N_H1 + 1); },
"more75": ({ N_H1 }) => { return 3*N_H1; },
"count33": ({ N_H, N_H1 }) => { const x0 = N_H + N_H1; const x1 = x0 - 1; return x1*(x0 - 2)*(N_H*x1 + N_H1*x1); },
"more76": ({ N_H1 }) => { return N_H1*(N_H1 - 1)*(Math.pow(N_H1, 2) + N_H1); },
"more77": ({ N_H1 }) => { const x0 = Math.pow(N_H1, 2) + N_H1; const x1 = N_H1 - 1; return N_H1*x0 + N_H1*x1*(2*N_H1 + 1) + x0*x1; },
"more78": ({ N_H1 }) => { const x0 = N_H1 - 1; const x1 = 2*N_H1 + 1; return Math.pow(N_H1, 2) + N_H1*x0 + N_H1*x1 + N_H1 + x0*x1; },
"more79": ({ N_H1 }) => { return 4*N_H1; },
"count34": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H + N_H1 - 1; return N_E*N_H*N_P*x0 + N_E1*N_H1*N_P1*x0; },
"more80": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { return N_E*N_H1*N_P + N_E1*Math.pow(N_H1, 2)*N_P1; },
"more81": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_E*N_P; return N_E1*N_H1*N_P1 + N_H1*x0 + x0; },
"count35": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_H + N_H1 - 1; return N_H*N_P*x0*(N_E - N_S) + N_H1*N_P1*x0*(N_E1 - N_S1); },
"more82": ({ N_E, N_E1, N_H1, N_P, N_P1, N_S, N_S1 }) => { return Math.pow(N_H1, 2)*N_P1*(N_E1 - N_S1) + N_H1*N_P*(N_E - N_S); },
"more83": ({ N_E, N_E1, N_H1, N_P, N_P1, N_S, N_S1 }) => { const x0 = N_P*(N_E - N_S); return N_H1*N_P1*(N_E1 - N_S1) + N_H1*x0 + x0; },
"count36": ({ N_H, N_H1, N_S, N_S1 }) => { const x0 = N_H + N_H1 - 1; return N_H*N_S*x0 + N_H1*N_S1*x0; },
"more84": ({ N_H1, N_S, N_S1 }) => { return Math.pow(N_H1, 2)*N_S1 + N_H1*N_S; },
"more85": ({ N_H1, N_S, N_S1 }) => { return N_H1*N_S + N_H1*N_S1 + N_S; },
"more86": ({ N_S }) => { return N_S; },
"count37": ({ N_E, N_E1, N_H, N_H1 }) => { const x0 = N_H + N_H1 - 1; return N_E*N_H*x0 + N_E1*N_H1*x0; },
"more87": ({ N_E, N_E1, N_H1 }) => { return N_E*N_H1 + N_E1*Math.pow(N_H1, 2); },
"more88": ({ N_E, N_E1, N_H1 }) => { return N_E*N_H1 + N_E + N_E1*N_H1; },
"more89": ({ N_E }) => { return N_E; },
"count38": ({ N_H, N_H1, N_S, N_S1 }) => { return N_H*N_S + N_H1*N_S1; },
"more90": ({ N_H1, N_S, N_S1 }) => { return N_H1*N_S1 + N_S; },
"count39": ({ N_E, N_E1, N_H, N_H1 }) => { return N_E*N_H + N_E1*N_H1; },
"more91": ({ N_E, N_E1, N_H1 }) => { return N_E + N_E1*N_H1; },
"saturation": ({ U_limit, b, c }) => { return 1 + (1/2)*(2*U_limit - 2*c)/b; },
"saturation2": ({ U_limit, a, b, c }) => { return (2*U_limit - 2*c)/(b + Math.sqrt(4*a*(U_limit - c) + Math.pow(b, 2))) + 1; },
"drain": ({ B, rho }) => { return ((rho < 1) ? (
   B/(1 - rho)
)
: (
   Number.POSITIVE_INFINITY
)); },
"largest": ({ N_sat }) => { const rounded_0 = Math.ceil(N_sat); return rounded_0 - 1; },
"inside_unicast": ({ L, R_uni }) => { return 8*L/R_uni; },
"inside_multicast": ({ L, R_multi }) => { return 8*L/R_multi; },
"linear_unicast": ({ L, O_uni, R_uni }) => { return 8*L/R_uni + O_uni; },
"linear_multicast": ({ L, O_multi, R_multi }) => { return 8*L/R_multi + O_multi; },
"padded_unicast": ({ L, N_DBPS_uni, N_add_uni, O_uni, k_uni, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*L + N_add_uni)/N_DBPS_uni)); return O_uni + rounded_0*t_grid_uni; },
"padded_multicast": ({ L, N_DBPS_multi, N_add_multi, O_multi, k_multi, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*L + N_add_multi)/N_DBPS_multi)); return O_multi + rounded_0*t_grid_multi; },
"aggregated_unicast": ({ A_least, A_most, L, N_DBPS_uni, N_add_uni, O_agg, k_uni, n_agg, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*L + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*L + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*L + 1/2) + 4))))/N_DBPS_uni)); return (O_agg + rounded_1*t_grid_uni)/rounded_0; },
},
"columns": ["name", "cast", "bytes", "frames", "unit", "per_unit", "hops", "sent"],
"protocols": {
"DDS": {
"group": s5,
"family": "DDS",
"product": null,
"tables": [s138, s141, s144, s145, s148, s151, ["middleware", "switching to Zenoh", "", "Zenoh", "DDS", "middleware"]],
"about": "",
"caution": "",
"air": null,
"color": "--ds-family-dds",
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s155,
"windows": s156,
"units": [s158, s160, s162],
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s163], ["SEDP", "unicast", 464, 1, 1, 1, "up down", s163], ["Heartbeat", "unicast", 116, 1, 2, 2, "up down", s163], ["ACKNACK", "unicast", 114, 1, 2, 2, "up down", s163]],
},
"Zenoh": {
"group": s5,
"family": "Zenoh",
"product": null,
"tables": [s167, s170, s173, ["peers", "static peers", "", "Zenoh, static peers", "Zenoh", "peers"], ["middleware", "switching to DDS", "", "DDS", "Zenoh", "middleware"]],
"about": "",
"caution": "",
"air": null,
"color": s174,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s155,
"windows": s156,
"units": s175,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s163], ["Hello", "unicast", 144, 1, 1, 1, "up down", s163], ["Declare", "unicast", 176, 1, 2, 1, "up down", s163], s176],
},
"Cyclone DDS": {
"group": s3,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s85, s177, "", s137, "Cyclone DDS", s178],
[s110, s179, "", s140, "Cyclone DDS", s180],
[s88, s181, "", s143, "Cyclone DDS", s182],
[s108, s183, "", s108, "Cyclone DDS", s184],
["peers", "static peers", "", s147, "Cyclone DDS", "peers"],
[s98, s149, "", s150, "Cyclone DDS", s98],
["router", s185, "", "Zenoh router", "Cyclone DDS", s186],
[s104, s187, "", s169, "Cyclone DDS", s188],
[s107, s189, "", s172, "Cyclone DDS", s190],
["announcements", s191, "", "Cyclone DDS, a longer announcement interval", "Cyclone DDS", "announcements"],
["middleware", s192, "", s2, "Cyclone DDS", "middleware"],
["middleware", s193, "", "Fast DDS", "Cyclone DDS", "middleware"],
["middleware", s194, "", "Fast DDS 2.6", "Cyclone DDS", "middleware"],
["middleware", s195, "", "Fast DDS 2.14", "Cyclone DDS", "middleware"],
["middleware", s196, "", "Fast DDS 3.6", "Cyclone DDS", "middleware"],
["middleware", s197, "", s166, "Cyclone DDS", "middleware"],
],
"about": s198,
"caution": "",
"air": {"hosts": "5", "low": "0.95", "high": "6.98"},
"color": s199,
"measured": [8, 12, 60],
"band": s200,
"reboot": [1.45, 3.59],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s209,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s210],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s211],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s212],
["SEDP", "unicast", s213, 0.2218, 2, 1, "up down", s214],
["SEDP again", "unicast", s213, 0.2218, 3, 0.103, "up down", s214],
["Heartbeat", "unicast", s215, 0.5226, 1, 2, "up down", s214],
[s216, "unicast", s215, 0.5226, 1, 2.481, "up down", s214],
["ACKNACK", "unicast", s217, 0.402, 1, 4.635, "up down", s214],
[s218, "unicast", s217, 0.402, 4, 0.09896, "up down", s214],
s221,
[s222, "unicast", s223, 0.6253, 1, 1, "up down", s214],
[s224, "unicast", s223, 0.6253, 4, 0.1067, "up down", s214],
s227,
[s228, "unicast", s229, 0.4544, 1, 2.222, "up down", s214],
s231,
[s232, "unicast", s233, 0.3044, 1, 2.312, "up down", s214],
[s234, "unicast", s233, 0.3044, 4, 0.05208, "up down", s214],
[s235, "unicast", s236, 0.6806, 1, 2.333, "up down", s214],
[s237, "unicast", s238, 0.2641, 1, 2, "up down", s214],
[s239, "unicast", s238, 0.2641, 4, 0.2188, "up down", s214],
[s240, "unicast", s241, 0.6247, 5, 1.006, "up down", s214],
[s242, "unicast", s241, 0.6247, 6, 0.07217, "up down", s214],
["User ACKNACK", "unicast", s243, 0.338, 5, 1.404, "up down", s214],
[s244, "unicast", s243, 0.338, 6, 0.09793, "up down", s214],
],
},
"Cyclone DDS, wired": {
"group": s3,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s85, s177, "", s137, s245, s178],
[s110, s179, "", s140, s245, s180],
[s88, s181, "", s143, s245, s182],
[s108, s183, "", s108, s245, s184],
s148,
s151,
["router", s185, "", "Zenoh router", s245, s186],
[s104, s187, "", s169, s245, s188],
[s107, s189, "", s172, s245, s190],
["announcements", s191, "", "Cyclone DDS, wired, a longer announcement interval", s245, "announcements"],
["middleware", s246, "", "Cyclone DDS", s245, "middleware"],
["middleware", s192, "", s2, s245, "middleware"],
["middleware", s193, "", "Fast DDS", s245, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s245, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s245, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s245, "middleware"],
["middleware", s197, "", s166, s245, "middleware"],
],
"about": s247,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 20],
"band": s248,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s249,
"degree": 3,
"messages": [
s250,
["SPDP directed", "unicast", s251, 0.9963, 1, 0.6667, "up down", s212],
["SEDP", "unicast", s252, 0.1841, 2, 0.5833, "up down", s214],
[s253, "multicast", s254, 0.2228, 2, 0.1667, "up down", s214],
[s255, "multicast", 232, 0.25, 0, 2, "up down", s214],
["Heartbeat", "unicast", s256, 0.3287, 1, 3, "up down", s214],
["ACKNACK", "unicast", s257, 0.3715, 1, 4.05, "up down", s214],
[s218, "unicast", s257, 0.3715, 3, 0.2833, "up down", s214],
["Liveliness", "multicast", s219, 0.7242, 0, 1, "up down", s220],
[s222, "multicast", s258, 0.9582, 0, 0.3333, "up down", s214],
[s259, "unicast", 429, 0.2, 1, 0.5, "up down", s214],
[s225, "multicast", s226, 0.2758, 0, 1, "up down", s220],
[s228, "multicast", s260, 0.1767, 0, 0.875, "up down", s214],
[s261, "unicast", s262, 0.2117, 1, 1.625, "up down", s214],
s231,
[s232, "unicast", s263, 0.2807, 1, 2.344, "up down", s214],
[s234, "unicast", s263, 0.2807, 3, 0.07812, "up down", s214],
[s235, "multicast", s264, 0.1988, 0, 2, "up down", s214],
[s265, "unicast", s266, 0.1917, 1, 0.6667, "up down", s214],
[s237, "unicast", 211.5, 0.2, 1, 2, "up down", s214],
[s239, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s214],
[s240, "unicast", s267, 0.2427, 4, 0.75, "up down", s214],
[s268, "multicast", s269, 0.2152, 4, 0.25, "up down", s214],
["User ACKNACK", "unicast", s270, 0.2283, 4, 2, "up down", s214],
],
},
"Cyclone DDS, version 11": {
"group": s3,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s85, s177, "", s137, s2, s178],
[s110, s179, "", s140, s2, s180],
[s88, s181, "", s143, s2, s182],
[s108, s183, "", s108, s2, s184],
s148,
s151,
["router", s185, "", "Zenoh router", s2, s186],
[s104, s187, "", s169, s2, s188],
[s107, s189, "", s172, s2, s190],
["announcements", s191, "", "Cyclone DDS, version 11, a longer announcement interval", s2, "announcements"],
["middleware", s246, "", "Cyclone DDS", s2, "middleware"],
["middleware", s193, "", "Fast DDS", s2, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s2, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s2, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s2, "middleware"],
["middleware", s197, "", s166, s2, "middleware"],
],
"about": s271,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 60],
"band": s272,
"reboot": [1.31, 3.21],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s209,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s210],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s211],
["SPDP directed", "unicast", s273, 0.9992, 1, 0.5413, "up down", s212],
["SEDP", "unicast", s274, 0.4598, 2, 1, "up down", s214],
["SEDP again", "unicast", s274, 0.4598, 3, 0.09093, "up down", s214],
["Heartbeat", "unicast", s275, 0.5475, 1, 2, "up down", s214],
[s216, "unicast", s275, 0.5475, 1, 2.833, "up down", s214],
["ACKNACK", "unicast", s276, 0.3982, 1, 5.167, "up down", s214],
[s218, "unicast", s276, 0.3982, 4, 0.125, "up down", s214],
s221,
[s222, "unicast", s277, 0.6519, 1, 1, "up down", s214],
[s224, "unicast", s277, 0.6519, 4, 0.09103, "up down", s214],
s227,
[s228, "unicast", s278, 0.4401, 1, 2.188, "up down", s214],
s231,
[s232, "unicast", s279, 0.2753, 1, 2.278, "up down", s214],
[s234, "unicast", s279, 0.2753, 4, 0.05556, "up down", s214],
[s235, "unicast", s280, 0.6399, 1, 2.542, "up down", s214],
[s237, "unicast", s281, 0.2385, 1, 2, "up down", s214],
[s239, "unicast", s281, 0.2385, 4, 0.1997, "up down", s214],
[s240, "unicast", s282, 0.6975, 5, 1.06, "up down", s214],
[s242, "unicast", s282, 0.6975, 6, 0.06995, "up down", s214],
["User ACKNACK", "unicast", s283, 0.4362, 5, 1.562, "up down", s214],
[s244, "unicast", s283, 0.4362, 6, 0.09399, "up down", s214],
],
},
"Cyclone DDS peers": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s85, s177, "", s137, s147, s178],
[s110, s179, "", s140, s147, s180],
[s88, s181, "", s143, s147, s182],
[s108, s183, "", s108, s147, s184],
[s98, s149, "", s150, s147, s98],
["router", s185, "", "Zenoh router", s147, s186],
[s104, s187, "", s169, s147, s188],
[s107, s189, "", s172, s147, s190],
["announcements", s191, "", "Cyclone DDS peers, a longer announcement interval", s147, "announcements"],
["middleware", s246, "", "Cyclone DDS", s147, "middleware"],
["middleware", s192, "", s2, s147, "middleware"],
["middleware", s193, "", "Fast DDS", s147, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s147, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s147, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s147, "middleware"],
["middleware", s197, "", s166, s147, "middleware"],
],
"about": s284,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 10],
"band": s285,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s290,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s210],
[s291, "unicast", 448, 1, 1, 6, "up down", s292],
["SPDP directed", "unicast", s293, 0.9817, 2, 0.8333, "up down", s212],
["SEDP", "unicast", s294, 0.172, 3, 1, "up down", s214],
["SEDP again", "unicast", s295, 0.8001, 4, 0.08633, "up down", s214],
["Heartbeat", "unicast", s296, 0.5756, 2, 2, "up down", s214],
[s216, "unicast", s296, 0.5756, 2, 2.944, "up down", s214],
["ACKNACK", "unicast", s297, 0.3827, 2, 4.424, "up down", s214],
[s218, "unicast", s297, 0.3827, 5, 0.2049, "up down", s214],
["Liveliness", "unicast", s298, 0.7241, 2, 1, "up down", s220],
[s222, "unicast", s299, 0.7527, 2, 1, "up down", s214],
[s224, "unicast", s299, 0.7527, 5, 0.08333, "up down", s214],
[s225, "unicast", s300, 0.2759, 2, 1, "up down", s220],
[s228, "unicast", s301, 0.4258, 2, 2.556, "up down", s214],
[s230, "unicast", 128, 1, 2, 1, "up down", s220],
[s232, "unicast", s302, 0.265, 2, 2.296, "up down", s214],
[s234, "unicast", s302, 0.265, 5, 0.09271, "up down", s214],
[s235, "unicast", s303, 0.6431, 2, 3, "up down", s214],
[s237, "unicast", s304, 0.283, 2, 2, "up down", s214],
[s239, "unicast", s304, 0.283, 5, 0.3631, "up down", s214],
[s240, "unicast", s305, 0.5405, 6, 1.542, "up down", s214],
["User ACKNACK", "unicast", s306, 0.437, 6, 2.208, "up down", s214],
],
},
"Cyclone DDS multicast SEDP": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s85, s177, "", s137, s150, s178],
[s110, s179, "", s140, s150, s180],
[s88, s181, "", s143, s150, s182],
[s108, s183, "", s108, s150, s184],
["peers", "static peers", "", s147, s150, "peers"],
["router", s185, "", "Zenoh router", s150, s186],
[s104, s187, "", s169, s150, s188],
[s107, s189, "", s172, s150, s190],
["announcements", s191, "", "Cyclone DDS multicast SEDP, a longer announcement interval", s150, "announcements"],
["middleware", s246, "", "Cyclone DDS", s150, "middleware"],
["middleware", s192, "", s2, s150, "middleware"],
["middleware", s193, "", "Fast DDS", s150, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s150, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s150, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s150, "middleware"],
["middleware", s197, "", s166, s150, "middleware"],
],
"about": s307,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 10],
"band": s308,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s249,
"degree": 3,
"messages": [
s250,
["SPDP directed", "unicast", s309, 0.9988, 1, 0.8, "up down", s212],
["SEDP", "unicast", s310, 0.2085, 2, 0.3719, "up down", s214],
[s253, "multicast", s311, 0.2222, 2, 0.23, "up down", s214],
[s255, "multicast", s312, 0.28, 0, 1.833, "up down", s214],
["Heartbeat", "unicast", s313, 0.3143, 1, 3.333, "up down", s214],
["ACKNACK", "unicast", s314, 0.3558, 1, 4.517, "up down", s214],
[s218, "unicast", s314, 0.3558, 3, 0.1494, "up down", s214],
["Liveliness", "multicast", s315, 0.724, 0, 1, "up down", s220],
[s222, "multicast", s316, 0.9539, 0, 0.8333, "up down", s214],
[s259, "unicast", s317, 0.15, 1, 0.5, "up down", s214],
[s225, "multicast", s318, 0.276, 0, 1, "up down", s220],
[s228, "multicast", s319, 0.2328, 0, 1, "up down", s214],
[s261, "unicast", s320, 0.2318, 1, 1.75, "up down", s214],
s231,
[s232, "unicast", s321, 0.2856, 1, 2.379, "up down", s214],
[s234, "unicast", s321, 0.2856, 3, 0.08854, "up down", s214],
[s235, "multicast", s322, 0.2325, 0, 2, "up down", s214],
[s265, "unicast", s323, 0.1726, 1, 1.167, "up down", s214],
[s237, "unicast", s324, 0.2088, 1, 2, "up down", s214],
[s239, "unicast", s324, 0.2088, 3, 0.3274, "up down", s214],
[s240, "unicast", s325, 0.4167, 4, 0.7917, "up down", s214],
[s268, "multicast", s326, 0.6667, 4, 0.1667, "up down", s214],
["User ACKNACK", "unicast", s327, 0.4167, 4, 2.167, "up down", s214],
],
},
"Fast DDS Discovery Server": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s110, s139, "", s140, s137, s110],
[s88, s142, "", s143, s137, s88],
[s108, s108, "", s108, s137, s108],
["peers", s328, "", s147, s137, s329],
[s98, s330, "", s150, s137, s331],
["router", s185, "", "Zenoh router", s137, s186],
[s104, s187, "", s169, s137, s188],
[s107, s189, "", s172, s137, s190],
["middleware", s246, "", "Cyclone DDS", s137, "middleware"],
["middleware", s192, "", s2, s137, "middleware"],
["middleware", s193, "", "Fast DDS", s137, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s137, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s137, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s137, "middleware"],
["middleware", s197, "", s166, s137, "middleware"],
],
"about": "one server, wired to the access point (measured with 2.9.1)",
"caution": "",
"air": null,
"color": s332,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms within that range, each left out of the fit, discovery took 1.00 to 1.10 times the airtime of the model (typical error 4%). We expect 71% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": s341,
"degree": 2,
"messages": [
[s342, "unicast", 652, 1, 0, 1, "up", s344],
[s345, "unicast", 700, 1, 0, 1, "down", s346],
[s347, "unicast", s348, 0.865, 0, 1, "down", s349],
[s350, "unicast", s351, 0.8517, 1, 1.967, "down", s349],
[s352, "unicast", 192, 1, 0, 2, "up", s349],
[s353, "unicast", s354, 0.5969, 0, 2.167, "down", s349],
[s355, "unicast", s356, 0.3182, 1, 2.908, "down", s349],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up", s349],
[s357, "unicast", 190.2, 1, 1, 0.5083, "up", s349],
[s358, "unicast", 188, 1, 0, 2, "down", s349],
["SPDP Gap", "unicast", s359, 0.6193, 1, 1.6, "down", s349],
[s360, "unicast", 1152, 0.45, 2, 1, "up", s349],
[s361, "unicast", s362, 0.8446, 3, 1.237, "down", s349],
["Heartbeat", "unicast", 192, 1, 0, 4, "up", s349],
[s363, "unicast", 192, 1, 0, 4, "down", s349],
[s364, "unicast", s365, 0.2358, 3, 1.892, "down", s349],
["ACKNACK", "unicast", 188, 1, 0, 4, "up", s349],
[s366, "unicast", 191.3, 1, 3, 0.45, "up", s349],
[s367, "unicast", 188.5, 1, 0, 15.6, "down", s349],
["Gap", "unicast", s368, 0.6838, 3, 0.645, "down", s349],
[s369, "unicast", 192, 1, 0, 1, "up", s349],
[s370, "unicast", 192, 1, 0, 2, "down", s349],
s371,
[s372, "unicast", 188, 1, 0, 2, "up", s349],
[s373, "unicast", 188, 1, 0, 2, "down", s349],
s374,
s375,
s376,
],
},
"Fast DDS Discovery Server, two": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s85, s135, "", s137, s140, s85],
[s88, s142, "", s143, s140, s88],
[s108, s108, "", s108, s140, s108],
["peers", s328, "", s147, s140, s329],
[s98, s330, "", s150, s140, s331],
["router", s185, "", "Zenoh router", s140, s186],
[s104, s187, "", s169, s140, s188],
[s107, s189, "", s172, s140, s190],
["middleware", s246, "", "Cyclone DDS", s140, "middleware"],
["middleware", s192, "", s2, s140, "middleware"],
["middleware", s193, "", "Fast DDS", s140, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s140, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s140, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s140, "middleware"],
["middleware", s197, "", s166, s140, "middleware"],
],
"about": "two servers that know nothing of each other, both wired to the access point; clients of both (measured with 2.9.1)",
"caution": "",
"air": null,
"color": s332,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms within that range, each left out of the fit, discovery took 1.00 to 1.05 times the airtime of the model (typical error 2%). We expect 71% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": s341,
"degree": 2,
"messages": [
[s342, "unicast", 636, 1, 0, 2, "up", s344],
[s345, "unicast", 700, 1, 0, 2, "down", s346],
[s347, "unicast", 747.8396673212429, 0.8657, 0, 2, "down", s349],
[s350, "unicast", 684.0093940817285, 0.8516, 1, 3.9, "down", s349],
[s352, "unicast", 192, 1, 0, 4, "up", s349],
[s353, "unicast", 244.85106382978725, 0.6204, 0, 4.625, "down", s349],
[s355, "unicast", 402.48973607038124, 0.2728, 1, 5.942, "down", s349],
["SPDP ACKNACK", "unicast", 189.8, 1, 0, 4.625, "up", s349],
[s357, "unicast", 190.5, 1, 1, 0.9417, "up", s349],
[s358, "unicast", 188, 1, 0, 4, "down", s349],
["SPDP Gap", "unicast", 199.09006997171358, 0.6717, 1, 3.333, "down", s349],
[s360, "unicast", 1257.7301004163605, 0.4083, 2, 2, "up", s349],
[s361, "unicast", s362, 0.8446, 3, 2.45, "down", s349],
["Heartbeat", "unicast", 184, 1, 0, 8, "up", s349],
[s363, "unicast", 192, 1, 0, 8, "down", s349],
[s364, "unicast", 432.5140562248996, 0.249, 3, 3.242, "down", s349],
["ACKNACK", "unicast", 188, 1, 0, 8, "up", s349],
[s366, "unicast", 190.8, 1, 3, 0.85, "up", s349],
[s367, "unicast", 188.5, 1, 0, 31.6, "down", s349],
["Gap", "unicast", 207.54580397181294, 0.6244, 3, 1.03, "down", s349],
[s369, "unicast", 192, 1, 0, 2, "up", s349],
[s370, "unicast", 192, 1, 0, 4, "down", s349],
[s225, "unicast", 192, 1, 4, 1.208, "up down", s349],
[s372, "unicast", 188, 1, 0, 4, "up", s349],
[s373, "unicast", 188, 1, 0, 4, "down", s349],
[s230, "unicast", 188, 1, 4, 1.208, "up down", s349],
[s240, "unicast", 192, 1, 5, 1.08, "up down", s349],
["User ACKNACK", "unicast", 188, 1, 5, 1.179, "up down", s349],
],
},
"Fast DDS Discovery Server, on a robot": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s85, s135, "", s137, s143, s85],
[s110, s139, "", s140, s143, s110],
[s108, s108, "", s108, s143, s108],
["peers", s328, "", s147, s143, s329],
[s98, s330, "", s150, s143, s331],
["router", s185, "", "Zenoh router", s143, s186],
[s104, s187, "", s169, s143, s188],
[s107, s189, "", s172, s143, s190],
["middleware", s246, "", "Cyclone DDS", s143, "middleware"],
["middleware", s192, "", s2, s143, "middleware"],
["middleware", s193, "", "Fast DDS", s143, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s143, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s143, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s143, "middleware"],
["middleware", s197, "", s166, s143, "middleware"],
],
"about": "one server, on a robot with processes of its own; as the table of a wired one, on other hops (measured with 2.9.1)",
"caution": "",
"air": null,
"color": s332,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms within that range, each left out of the fit, discovery took 0.97 to 1.16 times the airtime of the model (typical error 3%). We expect 71% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": [[s377, s377, s377], [s207, s378, s378], [s379, s379, s379], [s207, {"count": "count21", "more": ["more52", "more53", "more43"]}, {"count": "count22", "more": ["more54", "more55", "more5"]}], s340, s208],
"degree": 2,
"messages": [
[s342, "unicast", 652, 1, 0, 1, "up down", s344],
[s345, "unicast", 700, 1, 0, 1, "up down", s346],
[s347, "unicast", s348, 0.865, 0, 1, "up down", s349],
[s350, "unicast", s351, 0.8517, 1, 1.967, "up down", s349],
[s352, "unicast", 192, 1, 0, 2, "up down", s349],
[s353, "unicast", s354, 0.5969, 0, 2.167, "up down", s349],
[s355, "unicast", s356, 0.3182, 1, 2.908, "up down", s349],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up down", s349],
[s357, "unicast", 190.2, 1, 1, 0.5083, "up down", s349],
[s358, "unicast", 188, 1, 0, 2, "up down", s349],
["SPDP Gap", "unicast", s359, 0.6193, 1, 1.6, "up down", s349],
[s360, "unicast", 1152, 0.45, 2, 1, "up down", s349],
[s361, "unicast", s362, 0.8446, 3, 1.237, "up down", s349],
["Heartbeat", "unicast", 192, 1, 0, 4, "up down", s349],
[s363, "unicast", 192, 1, 0, 4, "up down", s349],
[s364, "unicast", s365, 0.2358, 3, 1.892, "up down", s349],
["ACKNACK", "unicast", 188, 1, 0, 4, "up down", s349],
[s366, "unicast", 191.3, 1, 3, 0.45, "up down", s349],
[s367, "unicast", 188.5, 1, 0, 15.6, "up down", s349],
["Gap", "unicast", s368, 0.6838, 3, 0.645, "up down", s349],
[s369, "unicast", 192, 1, 0, 1, "up down", s349],
[s370, "unicast", 192, 1, 0, 2, "up down", s349],
s371,
[s372, "unicast", 188, 1, 0, 2, "up down", s349],
[s373, "unicast", 188, 1, 0, 2, "up down", s349],
s374,
s375,
s376,
],
},
"Fast DDS": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s85, s135, "", s137, "Fast DDS", s85],
[s110, s139, "", s140, "Fast DDS", s110],
[s88, s142, "", s143, "Fast DDS", s88],
[s108, s108, "", s108, "Fast DDS", s108],
["peers", s328, "", s147, "Fast DDS", s329],
[s98, s330, "", s150, "Fast DDS", s331],
["router", s185, "", "Zenoh router", "Fast DDS", s186],
[s104, s187, "", s169, "Fast DDS", s188],
[s107, s189, "", s172, "Fast DDS", s190],
["announcements", s191, "", "Fast DDS, a longer announcement interval", "Fast DDS", "announcements"],
["middleware", s246, "", "Cyclone DDS", "Fast DDS", "middleware"],
["middleware", s192, "", s2, "Fast DDS", "middleware"],
["middleware", s194, "", "Fast DDS 2.6", "Fast DDS", "middleware"],
["middleware", s195, "", "Fast DDS 2.14", "Fast DDS", "middleware"],
["middleware", s196, "", "Fast DDS 3.6", "Fast DDS", "middleware"],
["middleware", s197, "", s166, "Fast DDS", "middleware"],
],
"about": s380,
"caution": s381,
"air": null,
"color": s332,
"measured": [8, 12, 60],
"band": s382,
"reboot": [1.21, 1.71],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": s385,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s344],
[s386, "multicast", 580, 1, 1, 1, "up down", s349],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s389],
[s390, "unicast", 580, 1, 2, 1, "up down", s349],
[s391, "unicast", 580, 1, 3, 0.5, "up down", s349],
["SEDP", "unicast", s392, 0.6, 4, 1, "up down", s349],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s349],
[s216, "unicast", 184.3, 1, 2, 1.65, "up down", s349],
[s393, "unicast", 184.3, 1, 3, 0.4252, "up down", s349],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s349],
[s394, "unicast", 189.4, 1, 2, 2.072, "up down", s349],
[s218, "unicast", 189.4, 1, 3, 0.2616, "up down", s349],
[s225, "unicast", 192, 1, 2, 1.148, "up down", s349],
[s230, "unicast", 188, 1, 2, 1.148, "up down", s349],
[s240, "unicast", 192, 1, 5, 1.4, "up down", s349],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s349],
],
},
"Fast DDS 2.6": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": [
s138,
s141,
s144,
s145,
["peers", s328, "", s147, "Fast DDS 2.6", s329],
[s98, s330, "", s150, "Fast DDS 2.6", s331],
["router", s185, "", "Zenoh router", "Fast DDS 2.6", s186],
[s104, s187, "", s169, "Fast DDS 2.6", s188],
[s107, s189, "", s172, "Fast DDS 2.6", s190],
["announcements", s191, "", "Fast DDS 2.6, a longer announcement interval", "Fast DDS 2.6", "announcements"],
["middleware", s246, "", "Cyclone DDS", "Fast DDS 2.6", "middleware"],
["middleware", s192, "", s2, "Fast DDS 2.6", "middleware"],
["middleware", s193, "", "Fast DDS", "Fast DDS 2.6", "middleware"],
["middleware", s195, "", "Fast DDS 2.14", "Fast DDS 2.6", "middleware"],
["middleware", s196, "", "Fast DDS 3.6", "Fast DDS 2.6", "middleware"],
["middleware", s197, "", s166, "Fast DDS 2.6", "middleware"],
],
"about": "",
"caution": s381,
"air": null,
"color": s332,
"measured": [10, 20, 42],
"band": s395,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": s385,
"degree": 3,
"messages": [
["SPDP", "multicast", 344, 1, 0, 1, "up down", s344],
[s386, "multicast", 344, 1, 1, 1, "up down", s349],
["SPDP unicast", "unicast", 344, 1, 2, 1, "up down", s389],
[s390, "unicast", 344, 1, 2, 1, "up down", s349],
[s391, "unicast", 344, 1, 3, 0.5, "up down", s349],
["SEDP", "unicast", s396, 0.6287, 4, 1, "up down", s349],
["Heartbeat", "unicast", 118.85, 1, 2, 2, "up down", s349],
[s216, "unicast", 118.85, 1, 2, 3.274, "up down", s349],
[s393, "unicast", 118.85, 1, 3, 0.4879, "up down", s349],
["ACKNACK", "unicast", 129.22, 1, 2, 2, "up down", s349],
[s394, "unicast", 129.22, 1, 2, 1.884, "up down", s349],
[s218, "unicast", 129.22, 1, 3, 0.3703, "up down", s349],
[s225, "unicast", 132, 1, 2, 1.125, "up down", s349],
[s230, "unicast", 128, 1, 2, 1.167, "up down", s349],
[s240, "unicast", 125.14, 1, 5, 1.575, "up down", s349],
["User ACKNACK", "unicast", 128.35, 1, 5, 1.429, "up down", s349],
[s397, "unicast", 501.7, 1, 2, 1.685, "up down", s349],
["ROS Heartbeat", "unicast", 125.14, 1, 2, 3.37, "up down", s349],
[s398, "unicast", 125.14, 1, 3, 0.1534, "up down", s349],
["ROS ACKNACK", "unicast", 128.35, 1, 2, 1.426, "up down", s349],
[s399, "unicast", 128.35, 1, 3, 0.1351, "up down", s349],
],
},
"Fast DDS 2.14": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": [
s138,
s141,
s144,
s145,
["peers", s328, "", s147, "Fast DDS 2.14", s329],
[s98, s330, "", s150, "Fast DDS 2.14", s331],
["router", s185, "", "Zenoh router", "Fast DDS 2.14", s186],
[s104, s187, "", s169, "Fast DDS 2.14", s188],
[s107, s189, "", s172, "Fast DDS 2.14", s190],
["announcements", s191, "", "Fast DDS 2.14, a longer announcement interval", "Fast DDS 2.14", "announcements"],
["middleware", s246, "", "Cyclone DDS", "Fast DDS 2.14", "middleware"],
["middleware", s192, "", s2, "Fast DDS 2.14", "middleware"],
["middleware", s193, "", "Fast DDS", "Fast DDS 2.14", "middleware"],
["middleware", s194, "", "Fast DDS 2.6", "Fast DDS 2.14", "middleware"],
["middleware", s196, "", "Fast DDS 3.6", "Fast DDS 2.14", "middleware"],
["middleware", s197, "", s166, "Fast DDS 2.14", "middleware"],
],
"about": "",
"caution": "",
"air": {"hosts": "8", "low": "0.79", "high": "2.77"},
"color": s332,
"measured": [10, 20, 42],
"band": s400,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": s401,
"degree": 3,
"messages": [
["SPDP", "multicast", 560, 1, 0, 1, "up down", s344],
["SPDP unicast", "unicast", 560, 1, 1, 1, "up down", s389],
[s390, "unicast", 560, 1, 1, 1, "up down", s349],
["SEDP", "unicast", s402, 0.6008, 2, 1, "up down", s349],
["Heartbeat", "unicast", 183.8, 1, 1, 2, "up down", s349],
[s216, "unicast", 183.8, 1, 1, 2.375, "up down", s349],
["ACKNACK", "unicast", 189.7, 1, 1, 2, "up down", s349],
[s394, "unicast", 189.7, 1, 1, 2.625, "up down", s349],
[s225, "unicast", 192, 1, 1, 1.125, "up down", s349],
[s230, "unicast", 188, 1, 1, 1.216, "up down", s349],
[s240, "unicast", 183.7, 1, 3, 1.5, "up down", s349],
["User ACKNACK", "unicast", 189, 1, 3, 1.554, "up down", s349],
[s397, "unicast", 480, 1, 1, 1.037, "up down", s349],
["ROS Heartbeat", "unicast", 183.7, 1, 1, 0.7995, "up down", s349],
[s398, "unicast", 183.7, 1, 4, 0.288, "up down", s349],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.9597, "up down", s349],
[s399, "unicast", 189, 1, 4, 0.1806, "up down", s349],
],
},
"Fast DDS 3.6": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": [
s138,
s141,
s144,
s145,
["peers", s328, "", s147, "Fast DDS 3.6", s329],
[s98, s330, "", s150, "Fast DDS 3.6", s331],
["router", s185, "", "Zenoh router", "Fast DDS 3.6", s186],
[s104, s187, "", s169, "Fast DDS 3.6", s188],
[s107, s189, "", s172, "Fast DDS 3.6", s190],
["announcements", s191, "", "Fast DDS 3.6, a longer announcement interval", "Fast DDS 3.6", "announcements"],
["middleware", s246, "", "Cyclone DDS", "Fast DDS 3.6", "middleware"],
["middleware", s192, "", s2, "Fast DDS 3.6", "middleware"],
["middleware", s193, "", "Fast DDS", "Fast DDS 3.6", "middleware"],
["middleware", s194, "", "Fast DDS 2.6", "Fast DDS 3.6", "middleware"],
["middleware", s195, "", "Fast DDS 2.14", "Fast DDS 3.6", "middleware"],
["middleware", s197, "", s166, "Fast DDS 3.6", "middleware"],
],
"about": "",
"caution": "",
"air": {"hosts": "8", "low": "0.68", "high": "1.70"},
"color": s332,
"measured": [10, 20, 42],
"band": s403,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": s404,
"degree": 3,
"messages": [
["SPDP", "multicast", 632, 1, 0, 1, "up down", s344],
["SPDP unicast", "unicast", 632, 1, 1, 1, "up down", s389],
[s390, "unicast", 632, 1, 1, 1, "up down", s349],
["SEDP", "unicast", s405, 0.6318, 2, 1, "up down", s349],
["Heartbeat", "unicast", 184.3, 1, 1, 2, "up down", s349],
[s216, "unicast", 184.3, 1, 1, 2.13, "up down", s349],
["ACKNACK", "unicast", 189.6, 1, 1, 2, "up down", s349],
[s394, "unicast", 189.6, 1, 1, 2.204, "up down", s349],
[s225, "unicast", 192, 1, 1, 1.046, "up down", s349],
[s230, "unicast", 188, 1, 1, 1.083, "up down", s349],
[s240, "unicast", 178.8, 1, 3, 1.306, "up down", s349],
["User ACKNACK", "unicast", 189, 1, 3, 1.633, "up down", s349],
[s397, "unicast", 459.4, 1, 1, 1.15, "up down", s349],
[s235, "unicast", s406, 0.9914, 1, 2.303, "up down", s349],
[s237, "unicast", 188, 1, 1, 2.5, "up down", s349],
["Type lookup", "unicast", s407, 0.2383, 4, 3.917, "up down", s349],
["ROS Heartbeat", "unicast", 178.8, 1, 1, 3.687, "up down", s349],
[s398, "unicast", 178.8, 1, 5, 0.1285, "up down", s349],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.4578, "up down", s349],
[s399, "unicast", 189, 1, 5, 0.2066, "up down", s349],
],
},
"hybrid": {
"group": s7,
"family": null,
"product": null,
"tables": [],
"about": "this book's proposal, for hosts with unlike software",
"caution": "",
"air": null,
"color": s408,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s409,
"windows": s410,
"units": [s412, s158, s337, s414, s289],
"degree": 2,
"messages": [s416, s417, s418, s419, s420, s422, s423],
},
"hybrid, alike": {
"group": s7,
"family": null,
"product": null,
"tables": [],
"about": "this book's proposal, for hosts that are alike",
"caution": "",
"air": null,
"color": s408,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s409,
"windows": s410,
"units": [s412, s158, [s424, s424, s424], s414, s289],
"degree": 2,
"messages": [s416, s417, ["Software", "multicast", 8, 0, 0, 1, "up down", s415], s418, s419, s420, s422, s423],
},
"DDS, periods of Fast DDS": {
"group": s6,
"family": "DDS",
"product": null,
"tables": [s138, s141, s144, s145, s148, s151, ["middleware", s425, "", s426, s427, "middleware"], ["middleware", s428, "", s429, s427, "middleware"]],
"about": "",
"caution": "",
"air": null,
"color": s332,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": s175,
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s344], ["UnicastSPDP", "unicast", 414, 1, 1, 1, "up down", s344], ["SEDP", "unicast", 464, 1, 2, 1, "up down", s349], ["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s349], ["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s349]],
},
"DDS, periods of Cyclone DDS": {
"group": s6,
"family": "DDS",
"product": null,
"tables": [s138, s141, s144, s145, s148, s151, ["middleware", s430, "", s427, s426, "middleware"], ["middleware", s428, "", s429, s426, "middleware"]],
"about": "",
"caution": "",
"air": null,
"color": s199,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s175,
"degree": 2,
"messages": [
["SPDP", "multicast", 414, 1, 0, 1, "up down", s210],
["DirectedSPDP", "unicast", 414, 1, 1, 1, "up down", s212],
["SEDP", "unicast", 464, 1, 2, 1, "up down", s214],
["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s214],
["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s214],
["Liveliness", "unicast", 180, 1, 1, 1, "up down", s292],
["LivelinessACK", "unicast", 114, 1, 1, 1, "up down", s292],
],
},
"Zenoh, periods of Zenoh peer": {
"group": s6,
"family": "Zenoh",
"product": null,
"tables": [s167, s170, s173, ["peers", "static peers", "", "Zenoh, periods of Zenoh peer, static peers", s429, "peers"], ["middleware", s430, "", s427, s429, "middleware"], ["middleware", s425, "", s426, s429, "middleware"]],
"about": "",
"caution": "",
"air": null,
"color": s431,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s175,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s432], ["Hello", "unicast", 144, 1, 1, 1, "up down", s432], ["Declare", "unicast", 176, 1, 2, 1, "up down", s214], s434],
},
"static endpoints": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s85, s135, "", s137, s108, s85],
[s110, s139, "", s140, s108, s110],
[s88, s142, "", s143, s108, s88],
["peers", s328, "", s147, s108, s329],
[s98, s330, "", s150, s108, s331],
["router", s185, "", "Zenoh router", s108, s186],
[s104, s187, "", s169, s108, s188],
[s107, s189, "", s172, s108, s190],
["announcements", s191, "", "static endpoints, a longer announcement interval", s108, "announcements"],
["middleware", s246, "", "Cyclone DDS", s108, "middleware"],
["middleware", s192, "", s2, s108, "middleware"],
["middleware", s193, "", "Fast DDS", s108, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s108, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s108, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s108, "middleware"],
["middleware", s197, "", s166, s108, "middleware"],
],
"about": s435,
"caution": "",
"air": null,
"color": s332,
"measured": [8, 8, 84],
"band": s436,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s333,
"windows": s334,
"units": s440,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s344],
[s386, "multicast", 589.2, 1, 1, 1, "up down", s349],
[s441, "multicast", 589.2, 1, 2, 1, "up down", s349],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s389],
[s390, "unicast", 589.2, 1, 3, 1, "up down", s349],
[s391, "unicast", 589.2, 1, 4, 0.5, "up down", s349],
[s442, "unicast", 589.2, 1, 5, 0.6542, "up down", s349],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s389],
[s443, "multicast", 59.47, 0, 6, 0.8987, "up down", s349],
[s444, "multicast", 59.47, 0, 7, 0.8987, "up down", s349],
[s445, "unicast", 59.47, 0, 5, 1, "up down", s389],
[s446, "unicast", 59.47, 0, 5, 0.9528, "up down", s349],
[s447, "unicast", 59.47, 0, 8, 0.4764, "up down", s349],
[s448, "unicast", 59.47, 0, 9, 0.6233, "up down", s349],
[s225, "unicast", 192, 1, 3, 1.167, "up down", s349],
[s230, "unicast", 188, 1, 3, 1.167, "up down", s349],
[s240, "unicast", 192, 1, 10, 1.33, "up down", s349],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s349],
],
},
"Zenoh peer": {
"group": s3,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s85, s177, "", s137, "Zenoh peer", s178],
[s110, s179, "", s140, "Zenoh peer", s180],
[s88, s181, "", s143, "Zenoh peer", s182],
[s108, s183, "", s108, "Zenoh peer", s184],
["peers", s328, "", s147, "Zenoh peer", s329],
[s98, s330, "", s150, "Zenoh peer", s331],
s167,
s170,
s173,
["peers", "static peers", "", "Zenoh peer, static peers", "Zenoh peer", "peers"],
["middleware", s246, "", "Cyclone DDS", "Zenoh peer", "middleware"],
["middleware", s192, "", s2, "Zenoh peer", "middleware"],
["middleware", s193, "", "Fast DDS", "Zenoh peer", "middleware"],
["middleware", s194, "", "Fast DDS 2.6", "Zenoh peer", "middleware"],
["middleware", s195, "", "Fast DDS 2.14", "Zenoh peer", "middleware"],
["middleware", s196, "", "Fast DDS 3.6", "Zenoh peer", "middleware"],
["middleware", s197, "", s166, "Zenoh peer", "middleware"],
],
"about": s449,
"caution": "",
"air": null,
"color": s431,
"measured": [8, 12, 60],
"band": s450,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s452,
"degree": 3,
"messages": [
s453,
s454,
["Hello first", "unicast", 104, 1, 1, 0.5833, "up down", s214],
["InitSyn", "unicast", 110, 1, 1, 0.6667, "up down", s214],
s455,
s456,
s457,
["OAM", "unicast", s458, 0.835, 1, 1, "up down", s214],
[s459, "unicast", s458, 0.835, 2, 0.625, "up down", s214],
["Declare", "unicast", s460, 0.1957, 3, 0.5, "up down", s214],
[s461, "unicast", s462, 0.8037, 4, 0.5, "up down", s214],
[s463, "unicast", s462, 0.8037, 5, 0.5, "up down", s214],
["Declare final", "unicast", 176, 0.05, 1, 1, "up down", s214],
["Frame", "unicast", s464, 0.2478, 1, 1, "up down", s214],
[s465, "unicast", s464, 0.2478, 3, 0.6083, "up down", s214],
s466,
s467,
["TCP ACK", "unicast", 76, 1, 1, 0.8708, "up down", s433],
[s468, "unicast", 76, 1, 1, 2.496, "up down", s214],
[s469, "unicast", 76, 1, 3, 0.2188, "up down", s214],
],
},
"Zenoh peer, tokens": {
"group": s3,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s85, s177, "", s137, s166, s178],
[s110, s179, "", s140, s166, s180],
[s88, s181, "", s143, s166, s182],
[s108, s183, "", s108, s166, s184],
["peers", s328, "", s147, s166, s329],
[s98, s330, "", s150, s166, s331],
["router", s164, "", "Zenoh router", s166, "router"],
[s104, s168, "", s169, s166, s104],
[s107, s171, "", s172, s166, s107],
["peers", "static peers", "", "Zenoh peer, tokens, static peers", s166, "peers"],
["middleware", s246, "", "Cyclone DDS", s166, "middleware"],
["middleware", s192, "", s2, s166, "middleware"],
["middleware", s193, "", "Fast DDS", s166, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s166, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s166, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s166, "middleware"],
],
"about": s470,
"caution": "",
"air": null,
"color": s431,
"measured": [8, 12, 60],
"band": s471,
"reboot": [0.896, 1.43],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s452,
"degree": 3,
"messages": [
s453,
s454,
["Hello first", "unicast", 104, 1, 1, 0.5, "up down", s214],
["InitSyn", "unicast", 109.86, 1, 1, 0.6667, "up down", s214],
s455,
s456,
s457,
["OAM", "unicast", s472, 0.7058, 1, 1, "up down", s214],
[s459, "unicast", s472, 0.7058, 2, 0.6493, "up down", s214],
["Declare", "unicast", s473, 0.0655, 3, 0.5, "up down", s214],
["Declare token", "unicast", s474, 0.0603, 3, 1, "up down", s214],
[s475, "unicast", s474, 0.0603, 1, 1, "up down", s214],
[s461, "unicast", s476, 0.5972, 4, 1.5, "up down", s214],
[s463, "unicast", s476, 0.5972, 5, 2.5, "up down", s214],
[s477, "unicast", s476, 0.5972, 1, 1, "up down", s214],
["Declare final", "unicast", s478, 0.06, 1, 1, "up down", s214],
["Frame", "unicast", s479, 0.1352, 1, 2, "up down", s214],
[s465, "unicast", s479, 0.1352, 3, 1, "up down", s214],
s466,
s467,
["TCP ACK", "unicast", 76, 1, 1, 0.7208, "up down", s433],
[s468, "unicast", 76, 1, 1, 3.325, "up down", s214],
[s469, "unicast", 76, 1, 3, 0.4208, "up down", s214],
],
},
"Zenoh router": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s85, s177, "", s137, "Zenoh router", s178],
[s110, s179, "", s140, "Zenoh router", s180],
[s88, s181, "", s143, "Zenoh router", s182],
[s108, s183, "", s108, "Zenoh router", s184],
["peers", s328, "", s147, "Zenoh router", s329],
[s98, s330, "", s150, "Zenoh router", s331],
[s104, s168, "", s169, "Zenoh router", s104],
[s107, s171, "", s172, "Zenoh router", s107],
["middleware", s246, "", "Cyclone DDS", "Zenoh router", "middleware"],
["middleware", s192, "", s2, "Zenoh router", "middleware"],
["middleware", s193, "", "Fast DDS", "Zenoh router", "middleware"],
["middleware", s194, "", "Fast DDS 2.6", "Zenoh router", "middleware"],
["middleware", s195, "", "Fast DDS 2.14", "Zenoh router", "middleware"],
["middleware", s196, "", "Fast DDS 3.6", "Zenoh router", "middleware"],
["middleware", s197, "", s166, "Zenoh router", "middleware"],
],
"about": "one router, wired to the access point, and every process its client, with liveliness tokens, as rmw_zenoh has them (measured with 1.10.2)",
"caution": "",
"air": null,
"color": s480,
"measured": [8, 12, 10],
"band": [[1, 1, 1, "In 7 swarms within that range, each left out of the fit, discovery took 0.84 to 1.18 times the airtime of the model (typical error 10%). We expect 75% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s481,
"windows": s482,
"units": [s158, s337, s483, [s207, {"count": "count30", "more": ["more69", "more70"]}, {"count": "count31", "more": ["more71", "more72"]}], s384, s437],
"degree": 2,
"messages": [
["TCP SYN", "unicast", 76, 1, 0, 1, "up", s484],
["TCP SYN-ACK", "unicast", 76, 1, 0, 1, "down", s484],
s485,
s486,
s487,
s488,
["Interest in tokens", "unicast", s489, 0.08917, 0, 1, "up", s484],
["Interest of publishers", "unicast", s489, 0.08917, 1, 0.5, "up", s484],
["Declare", "unicast", 144.9655172413793, 0.087, 1, 0.5, "up", s484],
[s475, "unicast", s490, 0.05144, 0, 1, "up", s484],
["Declare token", "unicast", s490, 0.05144, 1, 1, "up", s484],
[s477, "unicast", s491, 0.5213, 0, 2, "up", s484],
[s461, "unicast", s491, 0.5213, 1, 1.5, "up", s484],
["Declare key expression of unmatched", "unicast", s491, 0.5213, 2, 0.5, "up", s484],
["Frame up", "unicast", s492, 0.1456, 0, 1.417, "up", s484],
["Frame of endpoints up", "unicast", s492, 0.1456, 1, 1.292, "up", s484],
["Declare passed on", "unicast", 125.74016332590944, 0.1347, 3, 1, "down", s484],
["Declare token of own node", "unicast", s493, 0.0309, 0, 1, "down", s484],
["Declare own token", "unicast", s493, 0.0309, 1, 1, "down", s484],
["Declare token of node passed on", "unicast", s493, 0.0309, 4, 1, "down", s484],
["Declare token passed on", "unicast", s493, 0.0309, 5, 1, "down", s484],
["Declare key expression of node passed on", "unicast", s494, 0.3319, 4, 1, "down", s484],
["Declare key expression passed on", "unicast", s494, 0.3319, 5, 1, "down", s484],
["Declare final", "unicast", s495, 0.06875, 0, 1, "down", s484],
["Declare final to publishers", "unicast", s495, 0.06875, 1, 0.5, "down", s484],
["Frame down", "unicast", s496, 0.1116, 0, 3.188, "down", s484],
["Frame of endpoints down", "unicast", s496, 0.1116, 1, 1.206, "down", s484],
["Frame of others down", "unicast", s496, 0.1116, 5, 0.025, "down", s484],
["KeepAlive up", "unicast", 79, 1, 0, 1, "up", s498],
s499,
["TCP ACK up", "unicast", 76, 1, 0, 1, "up", s498],
["TCP ACK down", "unicast", 76, 1, 0, 0.5, "down", s498],
["TCP ACK at start up", "unicast", 76, 1, 0, 1.761, "up", s484],
["TCP ACK of endpoints up", "unicast", 76, 1, 1, 0.5636, "up", s484],
["TCP ACK of others up", "unicast", 76, 1, 4, 0.7871, "up", s484],
[s500, "unicast", 76, 1, 0, 4.104, "down", s484],
[s501, "unicast", 76, 1, 1, 0.07292, "down", s484],
],
},
"Zenoh router per host": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s85, s177, "", s137, s169, s178],
[s110, s179, "", s140, s169, s180],
[s88, s181, "", s143, s169, s182],
[s108, s183, "", s108, s169, s184],
["peers", s328, "", s147, s169, s329],
[s98, s330, "", s150, s169, s331],
["router", s164, "", "Zenoh router", s169, "router"],
[s107, s171, "", s172, s169, s107],
["middleware", s246, "", "Cyclone DDS", s169, "middleware"],
["middleware", s192, "", s2, s169, "middleware"],
["middleware", s193, "", "Fast DDS", s169, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s169, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s169, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s169, "middleware"],
["middleware", s197, "", s166, s169, "middleware"],
],
"about": "a router on each host, as rmw_zenoh has it, linked with all others; processes meet their own host's on loopback (measured with 1.10.2)",
"caution": "",
"air": null,
"color": s480,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 11 swarms within that range, each left out of the fit, discovery took 0.84 to 1.25 times the airtime of the model (typical error 2%). We expect 83% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s481,
"windows": s482,
"units": [s289, [s502, s502, s502], [s503, s503, s503], s505, s506, s507, s287],
"degree": 4,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up down", s484],
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s484],
["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s484],
["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s484],
["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s484],
["OAM", "unicast", s508, 0.04144, 0, 2, "up down", s484],
["OAM of third hosts", "unicast", s509, 0.03176, 1, 0.3843, "up down", s484],
["OAM passed on", "unicast", s509, 0.03176, 2, 0.4715, "up down", s484],
[s510, "unicast", s511, 0.8637, 0, 4.25, "up down", s484],
["Frame of gossip passed on", "unicast", s511, 0.8637, 1, 1.6, "up down", s484],
[s465, "unicast", s511, 0.8637, 3, 0.775, "up down", s484],
["Declare", "unicast", s508, 0.004144, 4, 0.5, "up down", s484],
[s512, "unicast", s508, 0.004144, 5, 0.5, "up down", s484],
[s475, "unicast", s508, 0.004144, 6, 1, "up down", s484],
["Declare token", "unicast", s508, 0.004144, 3, 1, "up down", s484],
[s461, "unicast", s513, 0.1138, 4, 0.5, "up down", s484],
[s463, "unicast", s513, 0.1138, 5, 0.2634, "up down", s484],
[s514, "unicast", s513, 0.1138, 3, 1, "up down", s484],
[s477, "unicast", s513, 0.1138, 6, 1, "up down", s484],
["KeepAlive", "unicast", 79, 1, 0, 1, "up down", s498],
["TCP ACK", "unicast", 76, 1, 0, 0.55, "up down", s498],
[s468, "unicast", 76, 1, 0, 6.597, "up down", s484],
["TCP ACK of gossip", "unicast", 76, 1, 1, 0.2278, "up down", s484],
[s469, "unicast", 76, 1, 3, 0.1124, "up down", s484],
],
},
"Zenoh router per host, star": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s85, s177, "", s137, s172, s178],
[s110, s179, "", s140, s172, s180],
[s88, s181, "", s143, s172, s182],
[s108, s183, "", s108, s172, s184],
["peers", s328, "", s147, s172, s329],
[s98, s330, "", s150, s172, s331],
["router", s164, "", "Zenoh router", s172, "router"],
[s104, s168, "", s169, s172, s104],
["middleware", s246, "", "Cyclone DDS", s172, "middleware"],
["middleware", s192, "", s2, s172, "middleware"],
["middleware", s193, "", "Fast DDS", s172, "middleware"],
["middleware", s194, "", "Fast DDS 2.6", s172, "middleware"],
["middleware", s195, "", "Fast DDS 2.14", s172, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s172, "middleware"],
["middleware", s197, "", s166, s172, "middleware"],
],
"about": "a router on each host, as rmw_zenoh has it, linked with one router that is wired to the access point; processes meet their own host's on loopback (measured with 1.10.2)",
"caution": "",
"air": null,
"color": s480,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 6 swarms within that range, each left out of the fit, discovery took 0.85 to 1.18 times the airtime of the model (typical error 15%). We expect 71% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s481,
"windows": s482,
"units": [s412, s289, s337, s483, [s207, {"count": "count38", "more": ["more90", "more86"]}, {"count": "count39", "more": ["more91", "more89"]}], s158, s287, s506, s507, s505, s414],
"degree": 2,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up", s484],
["TCP control down", "unicast", 76, 1, 0, 1, "down", s484],
s485,
s486,
s487,
s488,
["OAM", "unicast", s515, 0.03601, 0, 2, "up", s484],
["OAM of others", "unicast", s515, 0.03601, 1, 1.045, "up", s484],
[s510, "unicast", s516, 0.8894, 0, 12.18, "up", s484],
[s465, "unicast", s516, 0.8894, 2, 0.4077, "up", s484],
["Declare", "unicast", s508, 0.004144, 3, 0.5, "up", s484],
[s512, "unicast", s508, 0.004144, 4, 0.5, "up", s484],
[s475, "unicast", s508, 0.004144, 5, 1, "up", s484],
["Declare token", "unicast", s508, 0.004144, 2, 1, "up", s484],
[s461, "unicast", s517, 0.1159, 3, 0.5, "up", s484],
[s463, "unicast", s517, 0.1159, 4, 0.1042, "up", s484],
[s514, "unicast", s517, 0.1159, 2, 1, "up", s484],
[s477, "unicast", s517, 0.1159, 5, 1, "up", s484],
["KeepAlive", "unicast", 79, 1, 0, 1, "up", s498],
["TCP ACK", "unicast", 76, 1, 0, 1, "up", s498],
[s468, "unicast", 76, 1, 0, 3.783, "up", s484],
["TCP ACK of processes", "unicast", 76, 1, 6, 1.217, "up", s484],
["OAM down", "unicast", s518, 0.04874, 0, 2, "down", s484],
["OAM of others down", "unicast", s518, 0.04874, 1, 1.045, "down", s484],
["Frame of gossip down", "unicast", 87.23315027458811, 0.8012, 0, 26.88, "down", s484],
["Declare down", "unicast", s519, 0.005525, 7, 0.5, "down", s484],
["Declare of matching down", "unicast", s519, 0.005525, 8, 0.5, "down", s484],
["Declare token of node down", "unicast", s519, 0.005525, 6, 1, "down", s484],
["Declare token down", "unicast", s519, 0.005525, 9, 1, "down", s484],
["Declare key expression down", "unicast", s517, 0.1159, 7, 0.5, "down", s484],
["Declare key expression of matching down", "unicast", s517, 0.1159, 8, 0.0625, "down", s484],
["Declare key expression of tokens down", "unicast", s517, 0.1159, 9, 1, "down", s484],
["Declare key expression of node down", "unicast", s517, 0.1159, 6, 1, "down", s484],
s499,
["TCP ACK down", "unicast", 76, 1, 10, 1, "down", s498],
[s500, "unicast", 76, 1, 0, 4.958, "down", s484],
[s501, "unicast", 76, 1, 2, 0.1354, "down", s484],
],
},
"Zenoh, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": [],
"about": "",
"caution": "",
"air": null,
"color": s174,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s155,
"windows": s156,
"units": s520,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s163], s176],
},
"Cyclone DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s198,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 60],
"band": s200,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s209,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s523],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s524],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s525],
["SEDP", "unicast", s213, 0.2218, 2, 1, "up down", s526],
["SEDP again", "unicast", s213, 0.2218, 3, 0.103, "up down", s526],
["Heartbeat", "unicast", s215, 0.5226, 1, 2, "up down", s526],
[s216, "unicast", s215, 0.5226, 1, 2.481, "up down", s526],
["ACKNACK", "unicast", s217, 0.402, 1, 4.635, "up down", s526],
[s218, "unicast", s217, 0.402, 4, 0.09896, "up down", s526],
s529,
[s222, "unicast", s223, 0.6253, 1, 1, "up down", s526],
[s224, "unicast", s223, 0.6253, 4, 0.1067, "up down", s526],
s530,
[s228, "unicast", s229, 0.4544, 1, 2.222, "up down", s526],
s531,
[s232, "unicast", s233, 0.3044, 1, 2.312, "up down", s526],
[s234, "unicast", s233, 0.3044, 4, 0.05208, "up down", s526],
[s235, "unicast", s236, 0.6806, 1, 2.333, "up down", s526],
[s237, "unicast", s238, 0.2641, 1, 2, "up down", s526],
[s239, "unicast", s238, 0.2641, 4, 0.2188, "up down", s526],
[s240, "unicast", s241, 0.6247, 5, 1.006, "up down", s526],
[s242, "unicast", s241, 0.6247, 6, 0.07217, "up down", s526],
["User ACKNACK", "unicast", s243, 0.338, 5, 1.404, "up down", s526],
[s244, "unicast", s243, 0.338, 6, 0.09793, "up down", s526],
],
},
"Cyclone DDS, wired, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s247,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 20],
"band": s248,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s249,
"degree": 3,
"messages": [
s532,
["SPDP directed", "unicast", s251, 0.9963, 1, 0.6667, "up down", s525],
["SEDP", "unicast", s252, 0.1841, 2, 0.5833, "up down", s526],
[s253, "multicast", s254, 0.2228, 2, 0.1667, "up down", s526],
[s255, "multicast", 232, 0.25, 0, 2, "up down", s526],
["Heartbeat", "unicast", s256, 0.3287, 1, 3, "up down", s526],
["ACKNACK", "unicast", s257, 0.3715, 1, 4.05, "up down", s526],
[s218, "unicast", s257, 0.3715, 3, 0.2833, "up down", s526],
["Liveliness", "multicast", s219, 0.7242, 0, 1, "up down", s528],
[s222, "multicast", s258, 0.9582, 0, 0.3333, "up down", s526],
[s259, "unicast", 429, 0.2, 1, 0.5, "up down", s526],
[s225, "multicast", s226, 0.2758, 0, 1, "up down", s528],
[s228, "multicast", s260, 0.1767, 0, 0.875, "up down", s526],
[s261, "unicast", s262, 0.2117, 1, 1.625, "up down", s526],
s531,
[s232, "unicast", s263, 0.2807, 1, 2.344, "up down", s526],
[s234, "unicast", s263, 0.2807, 3, 0.07812, "up down", s526],
[s235, "multicast", s264, 0.1988, 0, 2, "up down", s526],
[s265, "unicast", s266, 0.1917, 1, 0.6667, "up down", s526],
[s237, "unicast", 211.5, 0.2, 1, 2, "up down", s526],
[s239, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s526],
[s240, "unicast", s267, 0.2427, 4, 0.75, "up down", s526],
[s268, "multicast", s269, 0.2152, 4, 0.25, "up down", s526],
["User ACKNACK", "unicast", s270, 0.2283, 4, 2, "up down", s526],
],
},
"Cyclone DDS, version 11, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s271,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 60],
"band": s272,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s209,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s523],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s524],
["SPDP directed", "unicast", s273, 0.9992, 1, 0.5413, "up down", s525],
["SEDP", "unicast", s274, 0.4598, 2, 1, "up down", s526],
["SEDP again", "unicast", s274, 0.4598, 3, 0.09093, "up down", s526],
["Heartbeat", "unicast", s275, 0.5475, 1, 2, "up down", s526],
[s216, "unicast", s275, 0.5475, 1, 2.833, "up down", s526],
["ACKNACK", "unicast", s276, 0.3982, 1, 5.167, "up down", s526],
[s218, "unicast", s276, 0.3982, 4, 0.125, "up down", s526],
s529,
[s222, "unicast", s277, 0.6519, 1, 1, "up down", s526],
[s224, "unicast", s277, 0.6519, 4, 0.09103, "up down", s526],
s530,
[s228, "unicast", s278, 0.4401, 1, 2.188, "up down", s526],
s531,
[s232, "unicast", s279, 0.2753, 1, 2.278, "up down", s526],
[s234, "unicast", s279, 0.2753, 4, 0.05556, "up down", s526],
[s235, "unicast", s280, 0.6399, 1, 2.542, "up down", s526],
[s237, "unicast", s281, 0.2385, 1, 2, "up down", s526],
[s239, "unicast", s281, 0.2385, 4, 0.1997, "up down", s526],
[s240, "unicast", s282, 0.6975, 5, 1.06, "up down", s526],
[s242, "unicast", s282, 0.6975, 6, 0.06995, "up down", s526],
["User ACKNACK", "unicast", s283, 0.4362, 5, 1.562, "up down", s526],
[s244, "unicast", s283, 0.4362, 6, 0.09399, "up down", s526],
],
},
"Cyclone DDS peers, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s284,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 10],
"band": s285,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s290,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s523],
[s291, "unicast", 448, 1, 1, 6, "up down", {"burst": 1, "second": 1.125, "lease": 0.135, "ever": 0.125}],
["SPDP directed", "unicast", s293, 0.9817, 2, 0.8333, "up down", s525],
["SEDP", "unicast", s294, 0.172, 3, 1, "up down", s526],
["SEDP again", "unicast", s295, 0.8001, 4, 0.08633, "up down", s526],
["Heartbeat", "unicast", s296, 0.5756, 2, 2, "up down", s526],
[s216, "unicast", s296, 0.5756, 2, 2.944, "up down", s526],
["ACKNACK", "unicast", s297, 0.3827, 2, 4.424, "up down", s526],
[s218, "unicast", s297, 0.3827, 5, 0.2049, "up down", s526],
["Liveliness", "unicast", s298, 0.7241, 2, 1, "up down", s528],
[s222, "unicast", s299, 0.7527, 2, 1, "up down", s526],
[s224, "unicast", s299, 0.7527, 5, 0.08333, "up down", s526],
[s225, "unicast", s300, 0.2759, 2, 1, "up down", s528],
[s228, "unicast", s301, 0.4258, 2, 2.556, "up down", s526],
[s230, "unicast", 128, 1, 2, 1, "up down", s528],
[s232, "unicast", s302, 0.265, 2, 2.296, "up down", s526],
[s234, "unicast", s302, 0.265, 5, 0.09271, "up down", s526],
[s235, "unicast", s303, 0.6431, 2, 3, "up down", s526],
[s237, "unicast", s304, 0.283, 2, 2, "up down", s526],
[s239, "unicast", s304, 0.283, 5, 0.3631, "up down", s526],
[s240, "unicast", s305, 0.5405, 6, 1.542, "up down", s526],
["User ACKNACK", "unicast", s306, 0.437, 6, 2.208, "up down", s526],
],
},
"Cyclone DDS multicast SEDP, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s307,
"caution": "",
"air": null,
"color": s199,
"measured": [8, 12, 10],
"band": s308,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s249,
"degree": 3,
"messages": [
s532,
["SPDP directed", "unicast", s309, 0.9988, 1, 0.8, "up down", s525],
["SEDP", "unicast", s310, 0.2085, 2, 0.3719, "up down", s526],
[s253, "multicast", s311, 0.2222, 2, 0.23, "up down", s526],
[s255, "multicast", s312, 0.28, 0, 1.833, "up down", s526],
["Heartbeat", "unicast", s313, 0.3143, 1, 3.333, "up down", s526],
["ACKNACK", "unicast", s314, 0.3558, 1, 4.517, "up down", s526],
[s218, "unicast", s314, 0.3558, 3, 0.1494, "up down", s526],
["Liveliness", "multicast", s315, 0.724, 0, 1, "up down", s528],
[s222, "multicast", s316, 0.9539, 0, 0.8333, "up down", s526],
[s259, "unicast", s317, 0.15, 1, 0.5, "up down", s526],
[s225, "multicast", s318, 0.276, 0, 1, "up down", s528],
[s228, "multicast", s319, 0.2328, 0, 1, "up down", s526],
[s261, "unicast", s320, 0.2318, 1, 1.75, "up down", s526],
s531,
[s232, "unicast", s321, 0.2856, 1, 2.379, "up down", s526],
[s234, "unicast", s321, 0.2856, 3, 0.08854, "up down", s526],
[s235, "multicast", s322, 0.2325, 0, 2, "up down", s526],
[s265, "unicast", s323, 0.1726, 1, 1.167, "up down", s526],
[s237, "unicast", s324, 0.2088, 1, 2, "up down", s526],
[s239, "unicast", s324, 0.2088, 3, 0.3274, "up down", s526],
[s240, "unicast", s325, 0.4167, 4, 0.7917, "up down", s526],
[s268, "multicast", s326, 0.6667, 4, 0.1667, "up down", s526],
["User ACKNACK", "unicast", s327, 0.4167, 4, 2.167, "up down", s526],
],
},
"Fast DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": [],
"about": s380,
"caution": "",
"air": null,
"color": s332,
"measured": [8, 12, 60],
"band": s382,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s385,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s534],
[s386, "multicast", 580, 1, 1, 1, "up down", s526],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s535],
[s390, "unicast", 580, 1, 2, 1, "up down", s526],
[s391, "unicast", 580, 1, 3, 0.5, "up down", s526],
["SEDP", "unicast", s392, 0.6, 4, 1, "up down", s526],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s526],
[s216, "unicast", 184.3, 1, 2, 1.65, "up down", s526],
[s393, "unicast", 184.3, 1, 3, 0.4252, "up down", s526],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s526],
[s394, "unicast", 189.4, 1, 2, 2.072, "up down", s526],
[s218, "unicast", 189.4, 1, 3, 0.2616, "up down", s526],
[s225, "unicast", 192, 1, 2, 1.148, "up down", s526],
[s230, "unicast", 188, 1, 2, 1.148, "up down", s526],
[s240, "unicast", 192, 1, 5, 1.4, "up down", s526],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s526],
],
},
"Fast DDS 2.6, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": [],
"about": "",
"caution": "",
"air": null,
"color": s332,
"measured": [10, 20, 42],
"band": s395,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s385,
"degree": 3,
"messages": [
["SPDP", "multicast", 344, 1, 0, 1, "up down", s534],
[s386, "multicast", 344, 1, 1, 1, "up down", s526],
["SPDP unicast", "unicast", 344, 1, 2, 1, "up down", s535],
[s390, "unicast", 344, 1, 2, 1, "up down", s526],
[s391, "unicast", 344, 1, 3, 0.5, "up down", s526],
["SEDP", "unicast", s396, 0.6287, 4, 1, "up down", s526],
["Heartbeat", "unicast", 118.85, 1, 2, 2, "up down", s526],
[s216, "unicast", 118.85, 1, 2, 3.274, "up down", s526],
[s393, "unicast", 118.85, 1, 3, 0.4879, "up down", s526],
["ACKNACK", "unicast", 129.22, 1, 2, 2, "up down", s526],
[s394, "unicast", 129.22, 1, 2, 1.884, "up down", s526],
[s218, "unicast", 129.22, 1, 3, 0.3703, "up down", s526],
[s225, "unicast", 132, 1, 2, 1.125, "up down", s526],
[s230, "unicast", 128, 1, 2, 1.167, "up down", s526],
[s240, "unicast", 125.14, 1, 5, 1.575, "up down", s526],
["User ACKNACK", "unicast", 128.35, 1, 5, 1.429, "up down", s526],
[s397, "unicast", 501.7, 1, 2, 1.685, "up down", s526],
["ROS Heartbeat", "unicast", 125.14, 1, 2, 3.37, "up down", s526],
[s398, "unicast", 125.14, 1, 3, 0.1534, "up down", s526],
["ROS ACKNACK", "unicast", 128.35, 1, 2, 1.426, "up down", s526],
[s399, "unicast", 128.35, 1, 3, 0.1351, "up down", s526],
],
},
"Fast DDS 2.14, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": [],
"about": "",
"caution": "",
"air": null,
"color": s332,
"measured": [10, 20, 42],
"band": s400,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s401,
"degree": 3,
"messages": [
["SPDP", "multicast", 560, 1, 0, 1, "up down", s534],
["SPDP unicast", "unicast", 560, 1, 1, 1, "up down", s535],
[s390, "unicast", 560, 1, 1, 1, "up down", s526],
["SEDP", "unicast", s402, 0.6008, 2, 1, "up down", s526],
["Heartbeat", "unicast", 183.8, 1, 1, 2, "up down", s526],
[s216, "unicast", 183.8, 1, 1, 2.375, "up down", s526],
["ACKNACK", "unicast", 189.7, 1, 1, 2, "up down", s526],
[s394, "unicast", 189.7, 1, 1, 2.625, "up down", s526],
[s225, "unicast", 192, 1, 1, 1.125, "up down", s526],
[s230, "unicast", 188, 1, 1, 1.216, "up down", s526],
[s240, "unicast", 183.7, 1, 3, 1.5, "up down", s526],
["User ACKNACK", "unicast", 189, 1, 3, 1.554, "up down", s526],
[s397, "unicast", 480, 1, 1, 1.037, "up down", s526],
["ROS Heartbeat", "unicast", 183.7, 1, 1, 0.7995, "up down", s526],
[s398, "unicast", 183.7, 1, 4, 0.288, "up down", s526],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.9597, "up down", s526],
[s399, "unicast", 189, 1, 4, 0.1806, "up down", s526],
],
},
"Fast DDS 3.6, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": [],
"about": "",
"caution": "",
"air": null,
"color": s332,
"measured": [10, 20, 42],
"band": s403,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s404,
"degree": 3,
"messages": [
["SPDP", "multicast", 632, 1, 0, 1, "up down", s534],
["SPDP unicast", "unicast", 632, 1, 1, 1, "up down", s535],
[s390, "unicast", 632, 1, 1, 1, "up down", s526],
["SEDP", "unicast", s405, 0.6318, 2, 1, "up down", s526],
["Heartbeat", "unicast", 184.3, 1, 1, 2, "up down", s526],
[s216, "unicast", 184.3, 1, 1, 2.13, "up down", s526],
["ACKNACK", "unicast", 189.6, 1, 1, 2, "up down", s526],
[s394, "unicast", 189.6, 1, 1, 2.204, "up down", s526],
[s225, "unicast", 192, 1, 1, 1.046, "up down", s526],
[s230, "unicast", 188, 1, 1, 1.083, "up down", s526],
[s240, "unicast", 178.8, 1, 3, 1.306, "up down", s526],
["User ACKNACK", "unicast", 189, 1, 3, 1.633, "up down", s526],
[s397, "unicast", 459.4, 1, 1, 1.15, "up down", s526],
[s235, "unicast", s406, 0.9914, 1, 2.303, "up down", s526],
[s237, "unicast", 188, 1, 1, 2.5, "up down", s526],
["Type lookup", "unicast", s407, 0.2383, 4, 3.917, "up down", s526],
["ROS Heartbeat", "unicast", 178.8, 1, 1, 3.687, "up down", s526],
[s398, "unicast", 178.8, 1, 5, 0.1285, "up down", s526],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.4578, "up down", s526],
[s399, "unicast", 189, 1, 5, 0.2066, "up down", s526],
],
},
"Zenoh, periods of Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": [],
"about": "",
"caution": "",
"air": null,
"color": s431,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s520,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s214], s434],
},
"static endpoints, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": [],
"about": s435,
"caution": "",
"air": null,
"color": s332,
"measured": [8, 8, 84],
"band": s436,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s521,
"windows": s522,
"units": s440,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s534],
[s386, "multicast", 589.2, 1, 1, 1, "up down", s526],
[s441, "multicast", 589.2, 1, 2, 1, "up down", s526],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s535],
[s390, "unicast", 589.2, 1, 3, 1, "up down", s526],
[s391, "unicast", 589.2, 1, 4, 0.5, "up down", s526],
[s442, "unicast", 589.2, 1, 5, 0.6542, "up down", s526],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s536],
[s443, "multicast", 59.47, 0, 6, 0.8987, "up down", s526],
[s444, "multicast", 59.47, 0, 7, 0.8987, "up down", s526],
[s445, "unicast", 59.47, 0, 5, 1, "up down", s536],
[s446, "unicast", 59.47, 0, 5, 0.9528, "up down", s526],
[s447, "unicast", 59.47, 0, 8, 0.4764, "up down", s526],
[s448, "unicast", 59.47, 0, 9, 0.6233, "up down", s526],
[s225, "unicast", 192, 1, 3, 1.167, "up down", s526],
[s230, "unicast", 188, 1, 3, 1.167, "up down", s526],
[s240, "unicast", 192, 1, 10, 1.33, "up down", s526],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s526],
],
},
"Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": [],
"about": s449,
"caution": "",
"air": null,
"color": s431,
"measured": [8, 12, 60],
"band": s450,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s537,
"degree": 3,
"messages": [
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s214],
s538,
s539,
s540,
["OAM", "unicast", s458, 0.835, 0, 1, "up down", s214],
[s459, "unicast", s458, 0.835, 1, 0.625, "up down", s214],
["Declare", "unicast", s460, 0.1957, 2, 0.5, "up down", s214],
[s461, "unicast", s462, 0.8037, 3, 0.5, "up down", s214],
[s463, "unicast", s462, 0.8037, 4, 0.5, "up down", s214],
["Declare final", "unicast", 176, 0.05, 0, 1, "up down", s214],
["Frame", "unicast", s464, 0.2478, 0, 1, "up down", s214],
[s465, "unicast", s464, 0.2478, 2, 0.6083, "up down", s214],
s542,
s543,
["TCP ACK", "unicast", 76, 1, 0, 0.6530673466326684, "up down", s433],
[s468, "unicast", 76, 1, 0, 2.496, "up down", s214],
[s469, "unicast", 76, 1, 2, 0.2188, "up down", s214],
],
},
"Zenoh peer, tokens, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": [],
"about": s470,
"caution": "",
"air": null,
"color": s431,
"measured": [8, 12, 60],
"band": s471,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s201,
"windows": s202,
"units": s537,
"degree": 3,
"messages": [
["InitSyn", "unicast", 109.86, 1, 0, 0.5, "up down", s214],
s538,
s539,
s540,
["OAM", "unicast", s472, 0.7058, 0, 1, "up down", s214],
[s459, "unicast", s472, 0.7058, 1, 0.6493, "up down", s214],
["Declare", "unicast", s473, 0.0655, 2, 0.5, "up down", s214],
["Declare token", "unicast", s474, 0.0603, 2, 1, "up down", s214],
[s475, "unicast", s474, 0.0603, 0, 1, "up down", s214],
[s461, "unicast", s476, 0.5972, 3, 1.5, "up down", s214],
[s463, "unicast", s476, 0.5972, 4, 2.5, "up down", s214],
[s477, "unicast", s476, 0.5972, 0, 1, "up down", s214],
["Declare final", "unicast", s478, 0.06, 0, 1, "up down", s214],
["Frame", "unicast", s479, 0.1352, 0, 2, "up down", s214],
[s465, "unicast", s479, 0.1352, 2, 1, "up down", s214],
s542,
s543,
["TCP ACK", "unicast", 76, 1, 0, 0.5405729713514325, "up down", s433],
[s468, "unicast", 76, 1, 0, 3.325, "up down", s214],
[s469, "unicast", 76, 1, 2, 0.4208, "up down", s214],
],
},
},
};
})();
