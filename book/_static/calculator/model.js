// Made from the package by `make calculator` with sympy 1.14.0; do not edit.
const DISCOSTORM = (() => {
const s1 = "Nav2 in one process";
const s2 = "Products as built";
const s3 = "Products with mitigations";
const s4 = "As the paper counts";
const s5 = "The paper's messages, a product's periods";
const s6 = "Proposals and other tables";
const s7 = "a whole number of at least 1 and at most 1,000,000,000";
const s8 = "a number of at least 0 and at most 1,000,000,000";
const s9 = "a number above 0";
const s10 = "a number of at least 0";
const s11 = "paper (802.11n)";
const s12 = "multicast rate";
const s13 = "sending multicast at 24 instead of 6 Mbit/s";
const s14 = 144444444.44444445;
const s15 = {"R_uni": s14, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s16 = {"name": s11, "model": "padded", "values": s15};
const s17 = "802.11n 20 MHz 2x2, multicast 24 Mbit/s";
const s18 = {"R_uni": s14, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s19 = "another radio (802.11n 40 MHz 2x2)";
const s20 = "802.11n 40 MHz 2x2";
const s21 = {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s22 = {"name": s20, "model": "padded", "values": s21};
const s23 = "another radio (802.11ac 80 MHz 2x2)";
const s24 = "802.11ac 80 MHz 2x2";
const s25 = 866666666.6666666;
const s26 = {"R_uni": s25, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s27 = {"name": s24, "model": "padded", "values": s26};
const s28 = "another radio (802.11ax 160 MHz 2x2)";
const s29 = "802.11ax 160 MHz 2x2";
const s30 = 2401960784.3137255;
const s31 = {"R_uni": s30, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s32 = {"name": s29, "model": "padded", "values": s31};
const s33 = {
"name": "802.11n 20 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s14, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s34 = "802.11a 20 MHz 1x1";
const s35 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s36 = {"name": s34, "model": "padded", "values": s35};
const s37 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s38 = "802.11g 20 MHz 1x1";
const s39 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s40 = "sending multicast at 24 instead of 1 Mbit/s";
const s41 = {"name": s38, "model": "padded", "values": s39};
const s42 = "802.11n 20 MHz 2x2";
const s43 = {"name": s42, "model": "padded", "values": s15, "full": s33, "simulated": "n"};
const s44 = {"R_uni": s14, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0};
const s45 = {
"name": "802.11n 40 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s46 = {"name": s20, "model": "padded", "values": s21, "full": s45, "simulated": null};
const s47 = {
"name": "802.11ac 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s25, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
};
const s48 = {"name": s24, "model": "padded", "values": s26, "full": s47, "simulated": "ac"};
const s49 = {
"name": "802.11ax 160 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s30, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
};
const s50 = {"name": s29, "model": "padded", "values": s31, "full": s49, "simulated": null};
const s51 = "802.11n 20 MHz 2x2, 2.4 GHz";
const s52 = {"R_uni": s14, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s53 = {
"name": "802.11n 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s14, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s54 = {"name": s51, "model": "padded", "values": s52, "full": s53, "simulated": null};
const s55 = "802.11ax 20 MHz 2x2, 2.4 GHz";
const s56 = 286764705.88235295;
const s57 = {"R_uni": s56, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s58 = {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s56, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
};
const s59 = {"name": s55, "model": "padded", "values": s57, "full": s58, "simulated": null};
const s60 = "802.11ax 80 MHz 2x2";
const s61 = 1200980392.1568627;
const s62 = {"R_uni": s61, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s63 = {
"name": "802.11ax 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s61, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
};
const s64 = {"name": s60, "model": "padded", "values": s62, "full": s63, "simulated": null};
const s65 = "802.11be 80 MHz 2x2";
const s66 = 1441176470.5882354;
const s67 = {"R_uni": s66, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s68 = {
"name": "802.11be 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s66, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
};
const s69 = {"name": s65, "model": "padded", "values": s67, "full": s68, "simulated": null};
const s70 = "802.11be 320 MHz 2x2";
const s71 = 5764705882.3529415;
const s72 = {"R_uni": s71, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s73 = {
"name": "802.11be 320 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s71, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
};
const s74 = [16, Infinity, Infinity];
const s75 = [12, Infinity, Infinity];
const s76 = [4, Infinity, Infinity];
const s77 = [8, Infinity, Infinity];
const s78 = [2, Infinity, Infinity];
const s79 = [s78, s76];
const s80 = "inside_unicast";
const s81 = "linear_unicast";
const s82 = "padded_unicast";
const s83 = "padded_multicast";
const s84 = "aggregated_unicast";
const s85 = "new or reconfigured radios";
const s86 = {"effort": 6, "takes": s85, "best_case": true, "mind": "the full gain needs full A-MPDUs; a queue may hold fewer frames for one receiver"};
const s87 = "a configuration file";
const s88 = "discovery server";
const s89 = "one more program";
const s90 = "discovery server on a robot";
const s91 = {"effort": 5, "takes": "rebuilt nodes", "best_case": false, "mind": "parameters can no longer be set from outside; nodes of others, such as Nav2's, must be rebuilt; we count a service as in DDS"};
const s92 = "another middleware";
const s93 = {"effort": 7, "takes": s92, "best_case": false, "mind": "all hosts must change together"};
const s94 = "another middleware and one more program";
const s95 = "multicast endpoint data";
const s96 = "another middleware and a configuration file";
const s97 = "router on each host";
const s98 = "another middleware and several more programs";
const s99 = "star of routers";
const s100 = "static endpoints";
const s101 = "two discovery servers";
const s102 = {"effort": 1, "takes": "a setting", "best_case": false, "mind": "hosts too far away for this rate cannot join; no multicast or management frame may use a lower rate"};
const s103 = {"effort": 5, "takes": "rebuilt nodes", "best_case": false, "mind": "only nodes built as components can be composed; one crash ends all composed nodes of that host"};
const s104 = {"effort": 6, "takes": s85, "best_case": false, "mind": "all hosts and the access point need this radio and must be close enough for its rate"};
const s105 = "several more programs";
const s106 = "hostapd.conf of the access point";
const s107 = "for every process";
const s108 = "Fast DDS 2.9.1";
const s109 = "Cyclone DDS 0.10.2 and 11.0.1";
const s110 = "on a computer that is wired to the access point";
const s111 = "on every robot";
const s112 = {
"where": s111,
"version": s108,
"text": "# Fast DDS 2.9.1: on every robot\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: run\n# in the shell or put in the service file that starts the ROS 2 processes, before they start\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\n",
};
const s113 = {
"where": "for ros2 tools, of any version",
"version": s108,
"text": "<!-- Fast DDS 2.9.1: for ros2 tools, of any version -->\n<!-- Load: save as /etc/fast_dds_tools.xml; ros2 and its daemon run with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds_tools.xml and without ROS_DISCOVERY_SERVER -->\n<!-- (from Fast DDS 3.0 on, so in ROS 2 Kilted: FASTDDS_DEFAULT_PROFILES_FILE); begin with ros2 -->\n<!-- daemon stop -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"super_client\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SUPER_CLIENT</discoveryProtocol>\n            <discoveryServersList>\n              <RemoteServer prefix=\"44.53.00.5f.45.50.52.4f.53.49.4d.41\">\n                <metatrafficUnicastLocatorList>\n                  <locator>\n                    <udpv4>\n                      <address>192.168.1.10</address>\n                      <port>11811</port>\n                    </udpv4>\n                  </locator>\n                </metatrafficUnicastLocatorList>\n              </RemoteServer>\n            </discoveryServersList>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
};
const s114 = {
"where": "for ros2 tools, of versions that read it",
"version": "ROS 2 Jazzy",
"text": "# ROS 2 Jazzy: for ros2 tools, of versions that read it\n# Load: both are environment variables of ros2 and its daemon: export them in the shell of\n# the tools, then ros2 daemon stop\n# Not run here: compared with its documentation\n# Fast DDS reads ROS_SUPER_CLIENT from 2.6.7 on (ROS 2 Humble), 2.10.3 (Iron) and 2.13.0 (Jazzy and\n# later). Older ones, such as 2.9.1, ignore it: take the profile of a SUPER_CLIENT.\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\nexport ROS_SUPER_CLIENT=TRUE\n",
};
const s115 = "on every computer";
const s116 = {
"where": s110,
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: on a computer that is wired to the access point\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s117 = {
"where": "for every process of a robot",
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: for every process of a robot\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n{\n  mode: \"peer\",\n  connect: { endpoints: [\"tcp/localhost:7447\"] },\n  listen: { endpoints: [\"tcp/localhost:0\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: {\n      target: { router: [\"router\", \"peer\"], peer: [\"router\"] },\n      autoconnect_strategy: { peer: { to_router: \"always\", to_peer: \"greater-zid\" } },\n    },\n  },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s118 = "a Discovery Server";
const s119 = "both values are of Fast DDS's measured model";
const s120 = "Fast DDS Discovery Server";
const s121 = [s88, s118, s119, s120, "Fast DDS", s88];
const s122 = "two Discovery Servers";
const s123 = "Fast DDS Discovery Server, two";
const s124 = [s101, s122, s119, s123, "Fast DDS", s101];
const s125 = "a Discovery Server on a robot";
const s126 = "Fast DDS Discovery Server, on a robot";
const s127 = [s90, s125, s119, s126, "Fast DDS", s90];
const s128 = [s100, s100, s119, s100, "Fast DDS", s100];
const s129 = "both values are of Cyclone DDS's measured model";
const s130 = "Cyclone DDS peers";
const s131 = ["peers", "static peers", s129, s130, "Cyclone DDS", "peers"];
const s132 = "multicast SEDP announcements";
const s133 = "Cyclone DDS multicast SEDP";
const s134 = [s95, s132, s129, s133, "Cyclone DDS", s95];
const s135 = [1, "within a second at best"];
const s136 = [Infinity, "leases at risk"];
const s137 = "never catches up";
const s138 = {"until": [s135, [Infinity, "slow at best"], s136], "never": s137};
const s139 = {"second": 1, "ever": Infinity};
const s140 = {"count": "count", "more": ["more", "more2"]};
const s141 = [s140, s140, s140];
const s142 = {"count": "count2", "more": ["more3", "more4", "more5"]};
const s143 = [s142, s142, s142];
const s144 = {"count": "count3", "more": ["more6", "more7", "more8"]};
const s145 = [s144, s144, s144];
const s146 = {"burst": 1, "second": 1, "ever": 0};
const s147 = "a router behind the access point";
const s148 = "both values are of Zenoh peer with tokens's measured model";
const s149 = "Zenoh peer, tokens";
const s150 = ["router", s147, s148, "Zenoh router", s149, "router"];
const s151 = "a router on each host";
const s152 = "Zenoh router per host";
const s153 = [s97, s151, s148, s152, s149, s97];
const s154 = "a router on each host, linked with one behind the access point";
const s155 = "Zenoh router per host, star";
const s156 = [s99, s154, s148, s155, s149, s99];
const s157 = "--ds-family-zenoh";
const s158 = [s141, s145, s143];
const s159 = ["KeepAlive", "unicast", 84, 1, 1, 2, "up down", s146];
const s160 = "switching to Fast DDS with a Discovery Server";
const s161 = "middleware and discovery server";
const s162 = "switching to Fast DDS with two Discovery Servers";
const s163 = "middleware and two discovery servers";
const s164 = "switching to Fast DDS with a Discovery Server on a robot";
const s165 = "middleware and discovery server on a robot";
const s166 = "switching to Fast DDS with static endpoints";
const s167 = "middleware and static endpoints";
const s168 = "switching to Zenoh with a router behind the access point";
const s169 = "middleware and router";
const s170 = "switching to Zenoh with a router on each host";
const s171 = "middleware and router on each host";
const s172 = "switching to Zenoh with a router on each host, linked with one behind the access point";
const s173 = "middleware and star of routers";
const s174 = "a longer announcement interval";
const s175 = "switching to Cyclone DDS, version 11";
const s176 = "Cyclone DDS, version 11";
const s177 = "switching to Fast DDS";
const s178 = "switching to Zenoh peer, tokens";
const s179 = "on a network that it takes for Wi-Fi: multicast for SPDP alone (measured with 0.10.2)";
const s180 = "--ds-product-cyclone-dds";
const s181 = [
[1, 1.67, 11.3, "In 11 swarms within that range that we did not fit, discovery took 0.68 to 1.12 times the airtime of the model (typical error 7%)"],
[2, 1.67, 11.3, "In 2 swarms of up to twice that range that we did not fit, discovery took 0.99 to 1.09 times the airtime of the model (typical error 5%)"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints that we did not fit, discovery took 1.31 to 1.47 times the airtime of the model (typical error 39%)"],
];
const s182 = {"until": [s135, [10, "slow at best"], s136], "never": s137};
const s183 = {"second": 1, "lease": 10, "ever": Infinity};
const s184 = {"count": "count4", "more": ["more9", "more10", "more11", "more12"]};
const s185 = [s184, s184, s184];
const s186 = {"count": "count5", "more": ["more13", "more14", "more15", "more16"]};
const s187 = [s186, s186, s186];
const s188 = {"count": "count6", "more": []};
const s189 = [s188, {"count": "count7", "more": ["more17", "more18", "more19"]}, {"count": "count8", "more": ["more20", "more21", "more22"]}];
const s190 = [s141, s145, s143, s185, s187, s189, [s188, {"count": "count9", "more": ["more23", "more24", "more25", "more26"]}, {"count": "count10", "more": ["more27", "more28", "more29", "more30"]}]];
const s191 = {"burst": 1.9875, "second": 2.1125, "lease": 0.32375, "ever": 0.125};
const s192 = {"burst": 0.9875, "second": 1.1125, "lease": 0.22375, "ever": 0.125};
const s193 = {"burst": 4, "second": 4, "lease": 0.4, "ever": 0};
const s194 = 972.4761045987376;
const s195 = {"burst": 1, "second": 1, "lease": 0.1, "ever": 0};
const s196 = 154.45158821278227;
const s197 = "Heartbeat of data";
const s198 = 187.0099502487562;
const s199 = "ACKNACK for others";
const s200 = 179.99005799502902;
const s201 = {"burst": 0, "second": 0.125, "lease": 0.125, "ever": 0.125};
const s202 = ["Liveliness", "unicast", s200, 0.7242, 1, 1, "up down", s201];
const s203 = "Liveliness at start";
const s204 = 190.54725731648807;
const s205 = "Liveliness for others";
const s206 = "Liveliness Heartbeat";
const s207 = 180.02610587382162;
const s208 = [s206, "unicast", s207, 0.2758, 1, 1, "up down", s201];
const s209 = "Liveliness Heartbeat at start";
const s210 = 153.8987676056338;
const s211 = "Liveliness ACKNACK";
const s212 = [s211, "unicast", 128, 1, 1, 1, "up down", s201];
const s213 = "Liveliness ACKNACK at start";
const s214 = 181.3784494086728;
const s215 = "Liveliness ACKNACK for others";
const s216 = "Type lookup Heartbeat";
const s217 = 129.08962679988247;
const s218 = "Type lookup ACKNACK";
const s219 = 195.20030291556228;
const s220 = "Type lookup ACKNACK for others";
const s221 = "User Heartbeat";
const s222 = 139.31615175284134;
const s223 = "User Heartbeat for others";
const s224 = 182.43195266272187;
const s225 = "User ACKNACK for others";
const s226 = "Cyclone DDS, wired";
const s227 = "switching to Cyclone DDS";
const s228 = "on a network that it takes for wired, with three processes or more: multicast for SEDP and control, too (measured with 0.10.2)";
const s229 = [[1, 1, 1, "In 7 swarms within that range that we did not fit, discovery took 0.95 to 1.13 times the airtime of the model (typical error 5%)"]];
const s230 = [s141, s145, s143, s187, s189];
const s231 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s191];
const s232 = 493.08762420957544;
const s233 = 1167.7479630635523;
const s234 = "SEDP multicast";
const s235 = 961.6660682226212;
const s236 = "Heartbeat multicast";
const s237 = 201.42013994523882;
const s238 = 199.39703903095557;
const s239 = 150.79816322270926;
const s240 = "Liveliness unicast";
const s241 = 245.09790605546124;
const s242 = "Liveliness Heartbeat unicast";
const s243 = 234.05196032120926;
const s244 = 187.1920199501247;
const s245 = 224.96579476861166;
const s246 = "Type lookup Heartbeat unicast";
const s247 = 230.92749087115283;
const s248 = 230.46065100947672;
const s249 = "User Heartbeat multicast";
const s250 = 232.6802973977695;
const s251 = 226.06745510293473;
const s252 = "as Cyclone DDS, with type information in SEDP (measured with 11.0.1)";
const s253 = [
[1, 1.67, 11.3, "In 11 swarms within that range that we did not fit, discovery took 0.72 to 1.13 times the airtime of the model (typical error 9%)"],
[2, 1.67, 11.3, "In 2 swarms of up to twice that range that we did not fit, discovery took 1.15 to 1.24 times the airtime of the model (typical error 20%)"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints that we did not fit, discovery took 1.28 to 1.48 times the airtime of the model (typical error 38%)"],
];
const s254 = 432.2946357085669;
const s255 = 726.2444541104828;
const s256 = 153.93607305936075;
const s257 = 186.8277247614264;
const s258 = 187.05568338702255;
const s259 = 156.2517609634174;
const s260 = 190.87976752633492;
const s261 = 132.5107047976246;
const s262 = 204.12578616352204;
const s263 = 133.94982078853047;
const s264 = 167.8055937643283;
const s265 = "AllowMulticast=false, all hosts as Peers, ParticipantIndex=auto and MaxAutoParticipantIndex=9, its default (measured with 0.10.2)";
const s266 = [[1, 1, 1, "In 7 swarms within that range that we did not fit, discovery took 0.94 to 1.33 times the airtime of the model (typical error 5%)"]];
const s267 = {"count": "count11", "more": ["more31", "more32", "more2"]};
const s268 = [s267, s267, s267];
const s269 = {"count": "count12", "more": ["more33", "more34", "more35"]};
const s270 = [s269, s269, s269];
const s271 = [s268, s270, s145, s143, s185, s187, s189];
const s272 = "ICMP unreachable";
const s273 = {"burst": 1, "second": 1.125, "lease": 0.225, "ever": 0.125};
const s274 = 442.0177243557095;
const s275 = 1224.46511627907;
const s276 = 334.84114485689287;
const s277 = 150.13620569840168;
const s278 = 191.25372354324537;
const s279 = 180.00607650876952;
const s280 = 170.0050484920951;
const s281 = 179.9840521928235;
const s282 = 156.0150305307656;
const s283 = 190.60377358490564;
const s284 = 134.67330119732546;
const s285 = 185.2367491166078;
const s286 = 147.20074005550418;
const s287 = 166.51716247139586;
const s288 = "AllowMulticast=true, as it chooses on a network that it takes for wired: of three processes or more (measured with 0.10.2)";
const s289 = [[1, 1, 1, "In 7 swarms within that range that we did not fit, discovery took 0.91 to 1.10 times the airtime of the model (typical error 8%)"]];
const s290 = 492.4140969162995;
const s291 = 1040.4988009592325;
const s292 = 965.8901890189019;
const s293 = 215.89285714285714;
const s294 = 213.31594018453706;
const s295 = 200.7060146149522;
const s296 = 180.02209944751382;
const s297 = 152.05954502568403;
const s298 = 510.6666666666667;
const s299 = 179.94202898550725;
const s300 = 201.4570446735395;
const s301 = 219.65142364106987;
const s302 = 186.30392156862746;
const s303 = 207.01075268817203;
const s304 = 249.3997682502897;
const s305 = 210.50383141762453;
const s306 = 176.79097672186225;
const s307 = 122.00209989500526;
const s308 = 167.19174466042716;
const s309 = "switching to Cyclone DDS with static peers";
const s310 = "middleware and peers";
const s311 = "switching to Cyclone DDS with multicast SEDP announcements";
const s312 = "middleware and multicast endpoint data";
const s313 = "--ds-product-fast-dds";
const s314 = {"until": [s135, [20, "slow at best"], s136], "never": s137};
const s315 = {"second": 1, "lease": 20, "ever": Infinity};
const s316 = {"count": "count13", "more": ["more36", "more37", "more38"]};
const s317 = {"count": "count14", "more": ["more39", "more40"]};
const s318 = [s317, s317, s317];
const s319 = {"count": "count16", "more": ["more44", "more45", "more5"]};
const s320 = {"count": "count17", "more": ["more46", "more47", "more38"]};
const s321 = [s188, s320, s320];
const s322 = [s141, [s188, s316, s316], s318, [s188, {"count": "count15", "more": ["more41", "more42", "more43"]}, s319], s321, s189];
const s323 = "SPDP to server";
const s324 = 0.3333333333333333;
const s325 = {"burst": 5.833333333333333, "second": 6.166666666666666, "lease": 0.625, "ever": s324};
const s326 = "SPDP of server";
const s327 = {"burst": 0.5, "second": 0.8333333333333333, "lease": 0.35833333333333334, "ever": s324};
const s328 = "SPDP of server at discovery";
const s329 = 748.3930635838151;
const s330 = {"burst": 1, "second": 1, "lease": 0.05, "ever": 0};
const s331 = "SPDP of others";
const s332 = 683.9365973934484;
const s333 = "SPDP Heartbeat";
const s334 = "SPDP Heartbeat of server";
const s335 = 250.29586195342605;
const s336 = "SPDP Heartbeat of others";
const s337 = 354.98051539912007;
const s338 = "SPDP ACKNACK of others";
const s339 = "SPDP ACKNACK of server";
const s340 = 204.14209591474247;
const s341 = "SEDP to server";
const s342 = "SEDP of others";
const s343 = 655.9962112242481;
const s344 = "Heartbeat of server";
const s345 = "Heartbeat of others";
const s346 = 451.4893977947413;
const s347 = "ACKNACK of others";
const s348 = "ACKNACK of server";
const s349 = 205.97133664814274;
const s350 = "Liveliness Heartbeat to server";
const s351 = "Liveliness Heartbeat of server";
const s352 = [s206, "unicast", 192, 1, 4, 1.292, "up down", s330];
const s353 = "Liveliness ACKNACK to server";
const s354 = "Liveliness ACKNACK of server";
const s355 = [s211, "unicast", 188, 1, 4, 1.292, "up down", s330];
const s356 = [s221, "unicast", 192, 1, 5, 1.021, "up down", s330];
const s357 = ["User ACKNACK", "unicast", 188, 1, 5, 1.021, "up down", s330];
const s358 = {"count": "count18", "more": ["more48", "more2"]};
const s359 = {"count": "count19", "more": ["more49", "more50", "more38"]};
const s360 = {"count": "count20", "more": ["more51", "more40"]};
const s361 = "with UDP and shared memory, as shipped and as ROS 2 sets it (measured with 2.9.1)";
const s362 = [
[1, 1.67, 11.3, "In 11 swarms within that range that we did not fit, discovery took 0.91 to 1.04 times the airtime of the model (typical error 3%)"],
[2, 1.67, 11.3, "In 2 swarms of up to twice that range that we did not fit, discovery took 0.95 to 1.22 times the airtime of the model (typical error 13%)"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints that we did not fit, discovery took 2.06 to 2.29 times the airtime of the model (typical error 118%)"],
];
const s363 = {"count": "count23", "more": ["more56", "more57", "more8"]};
const s364 = [s363, s363, s363];
const s365 = [s141, s364, s145, s187, s143, s189];
const s366 = "SPDP at discovery";
const s367 = 4.833333333333333;
const s368 = 5.166666666666666;
const s369 = {"burst": s367, "second": s368, "lease": 0.575, "ever": s324};
const s370 = "SPDP unicast at discovery";
const s371 = "SPDP unicast for others";
const s372 = 852.6666666666666;
const s373 = "Heartbeat for others";
const s374 = "ACKNACK of data";
const s375 = "--ds-basis-proposal";
const s376 = {"until": [s135, [23, "slow at best"], s136], "never": s137};
const s377 = {"second": 1, "lease": 23, "ever": Infinity};
const s378 = {"count": "count24", "more": ["more58", "more35"]};
const s379 = [s378, s378, s378];
const s380 = {"count": "more35", "more": ["more35"]};
const s381 = [s380, s380, s380];
const s382 = {"burst": 1, "second": 1, "lease": 0.043478260869565216, "ever": 0};
const s383 = ["Announce", "multicast", 80, 1, 0, 1, "up down", s382];
const s384 = ["Process", "multicast", 24, 0, 1, 1, "up down", s382];
const s385 = ["Endpoint", "multicast", 20, 0, 2, 1, "up down", s382];
const s386 = ["Digest", "multicast", 80, 1, 3, 1, "up down", s382];
const s387 = ["Listed", "multicast", 1, 0, 0, 1, "up down", s382];
const s388 = {"burst": 0, "second": s324, "lease": s324, "ever": s324};
const s389 = ["Heartbeat", "multicast", 80, 1, 0, 1, "up down", s388];
const s390 = ["Claimed", "multicast", 0.125, 0, 4, 1, "up down", s388];
const s391 = {"count": "count25", "more": ["count25"]};
const s392 = "switching to DDS, periods of Cyclone DDS";
const s393 = "DDS, periods of Cyclone DDS";
const s394 = "DDS, periods of Fast DDS";
const s395 = "switching to Zenoh, periods of Zenoh peer";
const s396 = "Zenoh, periods of Zenoh peer";
const s397 = "switching to DDS, periods of Fast DDS";
const s398 = "--ds-product-zenoh";
const s399 = {"burst": 3.125, "second": 3.25, "lease": 0.4375, "ever": 0.125};
const s400 = {"burst": 0, "second": 0.4, "lease": 0.4, "ever": 0.4};
const s401 = ["KeepAlive", "unicast", 84, 1, 1, 1, "up down", s400];
const s402 = "Fast DDS with endpoints that are known in advance (static EDP), participants announced as ever (measured with 2.9.1)";
const s403 = [[1, 1, 1, "In 10 swarms within that range that we did not fit, discovery took 0.95 to 1.31 times the airtime of the model (typical error 5%)"]];
const s404 = [s319, s319, s319];
const s405 = {"count": "count26", "more": ["more59", "more60"]};
const s406 = {"count": "count27", "more": ["more61", "more62", "more63"]};
const s407 = [s141, s364, s318, s145, s187, s143, s404, [s405, s405, s405], s185, [s406, s406, s406], s189];
const s408 = "SPDP of endpoints";
const s409 = "SPDP unicast of endpoints";
const s410 = "Listed at discovery";
const s411 = "Listed of endpoints";
const s412 = "Listed unicast";
const s413 = "Listed unicast at discovery";
const s414 = "Listed unicast for others";
const s415 = "Listed unicast of endpoints";
const s416 = "peers, each linked with each other (measured with 1.10.2)";
const s417 = [[1, 1, 1, "In 10 swarms within that range that we did not fit, discovery took 0.86 to 1.12 times the airtime of the model (typical error 8%)"]];
const s418 = [s142, {"count": "count28", "more": ["more64", "more65", "more66"]}, s188];
const s419 = [s141, s145, s187, s143, s418, s189];
const s420 = ["Scout", "multicast", 67, 1, 0, 1, "up down", s399];
const s421 = ["Hello", "unicast", 104, 1, 1, 1, "up down", {"burst": 2.125, "second": 2.25, "lease": 0.3375, "ever": 0.125}];
const s422 = ["InitAck", "unicast", 153, 1, 1, 0.6667, "up down", s195];
const s423 = ["OpenSyn", "unicast", 134, 1, 1, 0.6667, "up down", s195];
const s424 = ["OpenAck", "unicast", 84, 1, 1, 0.6667, "up down", s195];
const s425 = 163.4251497005988;
const s426 = "OAM for others";
const s427 = 106.65917220235053;
const s428 = "Declare key expression";
const s429 = 229.04217991787982;
const s430 = "Declare key expression of matching";
const s431 = 112.31961259079904;
const s432 = "Frame of endpoints";
const s433 = ["KeepAlive", "unicast", 79, 1, 1, 1.333, "up down", s400];
const s434 = ["TCP control", "unicast", 76, 1, 1, 1.333, "up down", s195];
const s435 = "TCP ACK at start";
const s436 = "TCP ACK of endpoints";
const s437 = "with liveliness tokens, as rmw_zenoh has them, and a subscriber to all of them (measured with 1.10.2)";
const s438 = [
[1, 1.67, 11.3, "In 12 swarms within that range that we did not fit, discovery took 0.90 to 1.41 times the airtime of the model (typical error 6%)"],
[2, 1.67, 11.3, "In 4 swarms of up to twice that range that we did not fit, discovery took 0.99 to 1.02 times the airtime of the model (typical error 1%)"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints that we did not fit, discovery took 0.93 to 1.15 times the airtime of the model (typical error 11%)"],
];
const s439 = 179.4287333522244;
const s440 = 167.6030534351145;
const s441 = 175.50248756218906;
const s442 = "Declare token of node";
const s443 = 362.8385800401876;
const s444 = "Declare key expression of node";
const s445 = 159.33333333333334;
const s446 = 142.56804733727813;
const s447 = "--ds-product-rmw-zenoh";
const s448 = {"until": [s135, [60, "slow at best"], s136], "never": s137};
const s449 = {"second": 1, "lease": 60, "ever": Infinity};
const s450 = [s317, {"count": "count29", "more": ["more67", "more68"]}, s188];
const s451 = {"burst": 1, "second": 1, "lease": 0.016666666666666666, "ever": 0};
const s452 = ["InitSyn", "unicast", 110, 1, 0, 1, "up", s451];
const s453 = ["InitAck", "unicast", 153, 1, 0, 1, "down", s451];
const s454 = ["OpenSyn", "unicast", 134, 1, 0, 1, "up", s451];
const s455 = ["OpenAck", "unicast", 84, 1, 0, 1, "down", s451];
const s456 = 154.5017382527756;
const s457 = 192.6407465007776;
const s458 = 358.9464799539613;
const s459 = 137.8131868131868;
const s460 = 282.5695792880259;
const s461 = 622.248870141609;
const s462 = 148.72727272727272;
const s463 = 156.64516129032256;
const s464 = 0.03333333333333333;
const s465 = {"burst": 0, "second": s464, "lease": s464, "ever": s464};
const s466 = ["KeepAlive down", "unicast", 79, 1, 0, 1, "down", s465];
const s467 = "TCP ACK at start down";
const s468 = "TCP ACK of endpoints down";
const s469 = {"count": "count32", "more": ["more73", "more74", "more75", "more35"]};
const s470 = {"count": "count33", "more": ["more76", "more77", "more78", "more79", "more35"]};
const s471 = {"count": "count34", "more": ["more80", "more81", "more40"]};
const s472 = [s471, s471, s471];
const s473 = [s471, {"count": "count35", "more": ["more82", "more83", "more68"]}, s188];
const s474 = [s188, {"count": "count36", "more": ["more84", "more85", "more86"]}, {"count": "count37", "more": ["more87", "more88", "more89"]}];
const s475 = 1523.8764478764479;
const s476 = 1523.7329974811084;
const s477 = "Frame of gossip";
const s478 = 86.42028482111844;
const s479 = "Declare of matching";
const s480 = 1523.275922671353;
const s481 = "Declare key expression of tokens";
const s482 = 1524.2088308803109;
const s483 = 86.11918147065437;
const s484 = 1524.6626402070751;
const s485 = 1523.8867459991793;
const s486 = 1523.9638009049772;
const s487 = [s143, s145];
const s488 = {"until": [s135, [100, "slow at best"], s136], "never": s137};
const s489 = {"second": 1, "lease": 100, "ever": Infinity};
const s490 = {"burst": 1.9966666666666666, "second": 2.03, "lease": 0.0533, "ever": s464};
const s491 = {"burst": 0.9966666666666667, "second": 1.03, "lease": 0.0433, "ever": s464};
const s492 = {"burst": 4, "second": 4, "lease": 0.04, "ever": 0};
const s493 = {"burst": 1, "second": 1, "lease": 0.01, "ever": 0};
const s494 = 0.01020408163265306;
const s495 = {"burst": 0, "second": s494, "lease": s494, "ever": s494};
const s496 = ["Liveliness", "unicast", s200, 0.7242, 1, 1, "up down", s495];
const s497 = [s206, "unicast", s207, 0.2758, 1, 1, "up down", s495];
const s498 = [s211, "unicast", 128, 1, 1, 1, "up down", s495];
const s499 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s490];
const s500 = 0.06666666666666667;
const s501 = {"burst": 1.9333333333333333, "second": 2, "lease": 0.086, "ever": s500};
const s502 = {"burst": 0.9333333333333333, "second": 1, "lease": 0.076, "ever": s500};
const s503 = {"burst": s367, "second": s368, "lease": 0.38166666666666665, "ever": s324};
const s504 = [s145, s187, s143, s418, s189];
const s505 = ["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s195];
const s506 = ["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s195];
const s507 = ["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s195];
const s508 = 0.9997000149992501;
const s509 = ["KeepAlive", "unicast", 79, 1, 0, s508, "up down", s400];
const s510 = ["TCP control", "unicast", 76, 1, 0, s508, "up down", s195];
return {
"start": {"robot": s1, "middleware": "Fast DDS"},
"groups": [s2, s3, s4, s5, s6],
"fields": {
"swarm": [
{"name": "hosts", "label": "Robots", "symbol": "N_H", "unit": "", "scale": 1, "start": "5", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s7},
{"name": "processes", "label": "Processes per robot", "symbol": "N_P", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s7},
{"name": "endpoints", "label": "Endpoints per process", "symbol": "N_E", "unit": "", "scale": 1, "start": "678", "low": 0, "high": 1000000000, "above": false, "whole": false, "allowed": s8},
],
"beside": [
{"name": "beside_hosts", "label": "Computers", "symbol": "N_H1", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s7},
{"name": "beside_processes", "label": "Processes per computer", "symbol": "N_P1", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s7},
{"name": "beside_endpoints", "label": "Endpoints per process, computers", "symbol": "N_E1", "unit": "", "scale": 1, "start": "90", "low": 0, "high": 1000000000, "above": false, "whole": false, "allowed": s8},
],
"own": [
{"name": "unicast_rate", "label": "Rate, unicast", "symbol": "R_uni", "unit": "Mbit/s", "scale": 1000000, "start": "144.4", "low": 0, "high": Infinity, "above": true, "whole": false, "allowed": s9},
{"name": "unicast_overhead", "label": "Overhead of a frame, unicast", "symbol": "O_uni", "unit": "µs", "scale": 1e-06, "start": "180", "low": 0, "high": Infinity, "above": false, "whole": false, "allowed": s10},
{"name": "multicast_rate", "label": "Rate, multicast", "symbol": "R_multi", "unit": "Mbit/s", "scale": 1000000, "start": "6", "low": 0, "high": Infinity, "above": true, "whole": false, "allowed": s9},
{"name": "multicast_overhead", "label": "Overhead of a frame, multicast", "symbol": "O_multi", "unit": "µs", "scale": 1e-06, "start": "120", "low": 0, "high": Infinity, "above": false, "whole": false, "allowed": s10},
],
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
"name": s11,
"model": "linear",
"values": {"R_uni": 144400000, "O_uni": 0.00018, "R_multi": 6000000, "O_multi": 0.00012},
"remedies": [
{"kind": s12, "what": s13, "note": "both values use standard timing", "base": s16, "wifi": {"name": s17, "model": "padded", "values": s18}},
{"kind": "radio", "what": s19, "note": "compared with 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead per frame exchange. Both values use standard timing", "base": s16, "wifi": s22},
{"kind": "radio", "what": s23, "note": "compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead per frame exchange. Both values use standard timing", "base": s16, "wifi": s27},
{"kind": "radio", "what": s28, "note": "compared with 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead per frame exchange. Both values use standard timing", "base": s16, "wifi": s32},
{
"kind": "aggregation",
"what": "aggregating up to 64 frames",
"note": "both values use standard timing. When we simulated the paper model's startup of 20 robots of 2 processes with 10 endpoints each, they needed 18 s instead of 31 s with DDS and 31 s instead of 65 s with Zenoh (medians)",
"base": s16,
"wifi": s33,
},
],
},
{
"name": s34,
"model": "padded",
"values": s35,
"remedies": [
{"kind": s12, "what": s13, "note": "", "base": s36, "wifi": {"name": "802.11a 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": s37}},
{"kind": "radio", "what": s19, "note": "compared with 802.11a 20 MHz 1x1: 300 instead of 54 Mbit/s and 186 instead of 166 µs of overhead per frame exchange", "base": s36, "wifi": s22},
{"kind": "radio", "what": s23, "note": "compared with 802.11a 20 MHz 1x1: 867 instead of 54 Mbit/s and 190 instead of 166 µs of overhead per frame exchange", "base": s36, "wifi": s27},
{"kind": "radio", "what": s28, "note": "compared with 802.11a 20 MHz 1x1: 2402 instead of 54 Mbit/s and 196 instead of 166 µs of overhead per frame exchange", "base": s36, "wifi": s32},
],
},
{
"name": s38,
"model": "padded",
"values": s39,
"remedies": [
{"kind": s12, "what": s40, "note": "", "base": s41, "wifi": {"name": "802.11g 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": s37}},
{"kind": "radio", "what": s19, "note": "compared with 802.11g 20 MHz 1x1: 300 instead of 54 Mbit/s, 186 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s41, "wifi": s22},
{"kind": "radio", "what": s23, "note": "compared with 802.11g 20 MHz 1x1: 867 instead of 54 Mbit/s, 190 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s41, "wifi": s27},
{"kind": "radio", "what": s28, "note": "compared with 802.11g 20 MHz 1x1: 2402 instead of 54 Mbit/s, 196 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s41, "wifi": s32},
],
},
{
"name": s42,
"model": "padded",
"values": s15,
"full": s33,
"simulated": "n",
"remedies": [
{"kind": s12, "what": s13, "note": "", "base": s43, "wifi": {"name": s17, "model": "padded", "values": s18, "full": {"name": "802.11n 20 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64", "model": "aggregated", "values": s44}, "simulated": null}},
{"kind": "radio", "what": s19, "note": "compared with 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead per frame exchange", "base": s43, "wifi": s46},
{"kind": "radio", "what": s23, "note": "compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead per frame exchange", "base": s43, "wifi": s48},
{"kind": "radio", "what": s28, "note": "compared with 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead per frame exchange", "base": s43, "wifi": s50},
],
},
{
"name": s51,
"model": "padded",
"values": s52,
"full": s53,
"simulated": null,
"remedies": [
{"kind": s12, "what": s40, "note": "", "base": s54, "wifi": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s", "model": "padded", "values": s18, "full": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64", "model": "aggregated", "values": s44}, "simulated": null}},
{"kind": "radio", "what": s19, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 300 instead of 144 Mbit/s, 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s54, "wifi": s46},
{"kind": "radio", "what": s23, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 867 instead of 144 Mbit/s, 190 instead of 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s54, "wifi": s48},
{"kind": "radio", "what": s28, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 2402 instead of 144 Mbit/s, 196 instead of 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s54, "wifi": s50},
],
},
{
"name": s20,
"model": "padded",
"values": s21,
"full": s45,
"simulated": null,
"remedies": [
{
"kind": s12,
"what": s13,
"note": "",
"base": s46,
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
{"kind": "radio", "what": s23, "note": "compared with 802.11n 40 MHz 2x2: 867 instead of 300 Mbit/s and 190 instead of 186 µs of overhead per frame exchange", "base": s46, "wifi": s48},
{"kind": "radio", "what": s28, "note": "compared with 802.11n 40 MHz 2x2: 2402 instead of 300 Mbit/s and 196 instead of 186 µs of overhead per frame exchange", "base": s46, "wifi": s50},
],
},
{
"name": s24,
"model": "padded",
"values": s26,
"full": s47,
"simulated": "ac",
"remedies": [
{
"kind": s12,
"what": s13,
"note": "",
"base": s48,
"wifi": {
"name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s25, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s25, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s28, "note": "compared with 802.11ac 80 MHz 2x2: 2402 instead of 867 Mbit/s and 196 instead of 190 µs of overhead per frame exchange", "base": s48, "wifi": s50},
],
},
{
"name": s55,
"model": "padded",
"values": s57,
"full": s58,
"simulated": null,
"remedies": [
{
"kind": s12,
"what": s40,
"note": "",
"base": s59,
"wifi": {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s56, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s56, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s19, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 300 instead of 287 Mbit/s, 186 instead of 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s59, "wifi": s46},
{"kind": "radio", "what": s23, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 867 instead of 287 Mbit/s, 190 instead of 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s59, "wifi": s48},
{"kind": "radio", "what": s28, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 2402 instead of 287 Mbit/s, 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s59, "wifi": s50},
],
},
{
"name": s60,
"model": "padded",
"values": s62,
"full": s63,
"simulated": null,
"remedies": [
{
"kind": s12,
"what": s13,
"note": "",
"base": s64,
"wifi": {
"name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s61, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s61, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s28, "note": "compared with 802.11ax 80 MHz 2x2: 2402 instead of 1201 Mbit/s and 196 µs of overhead per frame exchange", "base": s64, "wifi": s50},
],
},
{
"name": s29,
"model": "padded",
"values": s31,
"full": s49,
"simulated": null,
"remedies": [
{
"kind": s12,
"what": s13,
"note": "",
"base": s50,
"wifi": {
"name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s30, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s30, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
},
"simulated": null,
},
},
],
},
{
"name": s65,
"model": "padded",
"values": s67,
"full": s68,
"simulated": null,
"remedies": [
{
"kind": s12,
"what": s13,
"note": "",
"base": s69,
"wifi": {
"name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s66, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s66, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
},
"simulated": null,
},
},
{"kind": "radio", "what": s28, "note": "compared with 802.11be 80 MHz 2x2: 2402 instead of 1441 Mbit/s and 196 instead of 204 µs of overhead per frame exchange", "base": s69, "wifi": s50},
],
},
{
"name": s70,
"model": "padded",
"values": s72,
"full": s73,
"simulated": null,
"remedies": [
{
"kind": s12,
"what": s13,
"note": "",
"base": {"name": s70, "model": "padded", "values": s72, "full": s73, "simulated": null},
"wifi": {
"name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s71, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s71, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
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
"until": 60,
"runs": 5,
"found": {
"ac": {
"Cyclone DDS": {
"One bare node": {
"0": {"bursts": [[2, 1.7829], [4, 1.3906], [8, 1.4035], [12, 1.4438], [16, 1.3855]], "known": [[2, 0.004238, 0.004307], [4, 0.011035, 0.105793], [8, 0.114049, 0.114867], [12, 0.13212, 12.9018], [16, 0.329515, 12.9019]]},
"1": {"bursts": [[2, 1.5104], [4, 1.4322], [8, 1.5227], [12, 1.3772], [16, 1.5527]], "known": [[2, 0.00859, 0.104756], [4, 0.108635, 0.108935], [8, 0.120859, 12.9019], [12, 0.141511, 0.147702], [16, 12.9031, 12.9075]]},
},
"Nav2 in one process": {
"0": {"bursts": [[2, 1.1789], [4, 1.1612], [8, 1.1454], [12, 1.2726], [16, 1.2736]], "known": [[2, 0.011649, 0.012192], [4, 0.11979, 0.304175], [8, 12.7245, 12.9249], [12, 19.1053, 19.1175], [16, 25.3107, 28.824]]},
"1": {"bursts": [[2, 1.2466], [4, 1.1201], [8, 1.2043], [12, 1.2627], [16, 1.3239]], "known": [[2, 0.029208, 0.108384], [4, 0.307614, 0.311209], [8, 12.916, 18.9022], [12, 19.1239, 19.3159], [16, 25.5453, 33.7177]]},
},
"Drone, PX4 through MAVROS": {
"0": {"bursts": [[2, 1.3065], [4, 1.2418], [8, 1.2045], [12, 1.2668], [16, 1.2835]], "known": [[2, 0.017714, 0.01872], [4, 0.310631, 0.504415], [8, 13.1093, 16.1253], [12, 25.5039, 25.5153], [16, 55.9307, Infinity]]},
"1": {"bursts": [[2, 1.1822], [4, 1.1054], [8, 1.1884], [12, 1.2421], [16, 1.2919]], "known": [[2, 0.110374, 0.115947], [4, 0.512055, 1.50943], [8, 13.5065, 19.1188], [12, 33.7307, 41.516], [16, 53.927, Infinity]]},
},
"The paper's swarm": {
"0": {"bursts": [[2, 1.3421], [4, 1.1862], [8, 1.3014], [12, 1.3069], [16, 1.3102]], "known": [[2, 0.006079, 0.006745], [4, 0.109807, 0.11279], [8, 0.142047, 0.317395], [12, 12.9115, 12.9138], s74]},
"1": {"bursts": [[2, 1.4138], [4, 1.2102], [8, 1.2398], [12, 1.3273], [16, 1.2987]], "known": [[2, 0.011966, 0.10673], [4, 0.113607, 0.114735], [8, 0.314674, 12.9092], [12, 12.9155, 12.9181], [16, 33.266, Infinity]]},
},
"Drone, PX4 through uXRCE-DDS": {
"0": {"bursts": [[2, 1.2154], [4, 1.157], [8, 1.2518], [12, 1.2172], [16, 1.3319]], "known": [[2, 0.007238, 0.00788], [4, 0.111443, 0.30357], [8, 0.342063, 12.9086], [12, 17.2322, 19.1129], [16, 40.2464, Infinity]]},
"1": {"bursts": [[2, 1.3226], [4, 1.1245], [8, 1.231], [12, 1.2867], [16, 1.2901]], "known": [[2, 0.014139, 0.10762], [4, 0.119534, 0.122285], [8, 12.9037, 12.911], [12, 19.1108, 20.8175], s74]},
},
"Manipulator with MoveIt": {
"0": {"bursts": [[2, 1.0716], [4, 1.1711], [8, 1.1989], [12, 1.258], [16, 1.3191]], "known": [[2, 0.015703, 0.10719], [4, 0.148759, 0.320613], [8, 19.1109, 25.3106], s75, s74]},
"1": {"bursts": [[2, 1.1573], [4, 1.1782], [8, 1.157], [12, 1.2686], [16, 1.3084]], "known": [[2, 0.108026, 0.110106], [4, 0.319974, 12.9043], [8, 19.1077, 24.457], s75, s74]},
},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0667], [4, 1.13], [8, 1.2092], [12, 1.2669]], "known": [[2, 16.5073, Infinity], s76, s77, s75]}, "1": {"bursts": [[2, 1.058], [4, 1.1381]], "known": s79}},
},
"Cyclone DDS multicast SEDP": {
"One bare node": {"0": {"bursts": [[2, 1.3352], [4, 1.1092], [8, 1.0767], [12, 1.0905], [16, 1.0997]], "known": []}, "1": {"bursts": [[2, 1.117], [4, 1.0264], [8, 1.0436], [12, 1.0693], [16, 1.0835]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.0175], [4, 1.0062], [8, 1.0092], [12, 1.0115], [16, 1.0118]], "known": []}, "1": {"bursts": [[2, 1.0123], [4, 1.0065], [8, 1.0141], [12, 1.0122], [16, 1.0201]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.0101], [4, 1.0087], [8, 1.0059], [12, 1.0113], [16, 1.0132]], "known": []}, "1": {"bursts": [[2, 1.0063], [4, 1.0054], [8, 1.0099], [12, 1.0122], [16, 1.017]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.0921], [4, 1.0381], [8, 1.0842], [12, 1.0586], [16, 1.064]], "known": []}, "1": {"bursts": [[2, 1.0402], [4, 1.0331], [8, 1.0233], [12, 1.0849], [16, 1.0587]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.0152], [4, 1.0144], [8, 1.0234], [12, 1.0262], [16, 1.0537]], "known": []}, "1": {"bursts": [[2, 1.0162], [4, 1.0148], [8, 1.0284], [12, 1.0272], [16, 1.0368]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.0144], [4, 1.0092], [8, 1.0146], [12, 1.0156], [16, 1.0189]], "known": []}, "1": {"bursts": [[2, 0.9944], [4, 1.0091], [8, 1.0127], [12, 1.0157], [16, 1.0233]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 0.9987], [4, 1.0044], [8, 1.0148], [12, 1.0269]], "known": []}, "1": {"bursts": [[2, 0.9999], [4, 1.0049]], "known": []}},
},
"Cyclone DDS peers": {
"One bare node": {"0": {"bursts": [[2, 2.8395], [4, 1.6801], [8, 1.3214], [12, 1.4036], [16, 1.3862]], "known": []}, "1": {"bursts": [[2, 2.3735], [4, 1.3859], [8, 1.3017], [12, 1.3703], [16, 1.3655]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.301], [4, 1.2217], [8, 1.202], [12, 1.2605], [16, 1.329]], "known": []}, "1": {"bursts": [[2, 1.3424], [4, 1.2041], [8, 1.1997], [12, 1.2782], [16, 1.3152]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1701], [4, 1.2506], [8, 1.1699], [12, 1.2868], [16, 1.2898]], "known": []}, "1": {"bursts": [[2, 1.2565], [4, 1.2453], [8, 1.2288], [12, 1.2532], [16, 1.3105]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.8717], [4, 1.2591], [8, 1.9316], [12, 1.2727], [16, 1.3159]], "known": []}, "1": {"bursts": [[2, 1.7411], [4, 1.19], [8, 1.2665], [12, 1.311], [16, 1.3291]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.5098], [4, 1.3543], [8, 1.1914], [12, 1.2247], [16, 1.2828]], "known": []}, "1": {"bursts": [[2, 1.5226], [4, 1.1744], [8, 1.2244], [12, 1.2841], [16, 1.3167]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.2365], [4, 1.1859], [8, 1.1863], [12, 1.2439], [16, 1.2983]], "known": []}, "1": {"bursts": [[2, 1.5933], [4, 1.1556], [8, 1.2018], [12, 1.2358], [16, 1.3198]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0501], [4, 1.1115], [8, 1.1863], [12, 1.2479]], "known": []}, "1": {"bursts": [[2, 1.0751], [4, 1.1141]], "known": []}},
},
"Cyclone DDS, version 11": {
"One bare node": {"0": {"bursts": [[2, 1.7201], [4, 1.4878], [8, 1.3364], [12, 1.3729], [16, 1.5491]], "known": []}, "1": {"bursts": [[2, 1.4143], [4, 1.3698], [8, 1.3574], [12, 1.3066], [16, 1.3635]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.1903], [4, 1.1757], [8, 1.1989], [12, 1.2275], [16, 1.302]], "known": []}, "1": {"bursts": [[2, 1.1752], [4, 1.1314], [8, 1.1595], [12, 1.2487], [16, 1.3307]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1591], [4, 1.1666], [8, 1.1952], [12, 1.2512], [16, 1.3039]], "known": []}, "1": {"bursts": [[2, 1.2075], [4, 1.1159], [8, 1.199], [12, 1.2429], [16, 1.3232]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.3045], [4, 1.2857], [8, 1.2699], [12, 1.2736], [16, 1.3904]], "known": []}, "1": {"bursts": [[2, 1.3219], [4, 1.2915], [8, 1.2783], [12, 1.3766], [16, 1.3066]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.1757], [4, 1.1456], [8, 1.1991], [12, 1.2399], [16, 1.2899]], "known": []}, "1": {"bursts": [[2, 1.2276], [4, 1.1795], [8, 1.2168], [12, 1.2461], [16, 1.3283]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1081], [4, 1.1165], [8, 1.1974], [12, 1.2424], [16, 1.3085]], "known": []}, "1": {"bursts": [[2, 1.1215], [4, 1.1536], [8, 1.1735], [12, 1.2634], [16, 1.3045]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0605], [4, 1.1235], [8, 1.2035], [12, 1.2592]], "known": []}, "1": {"bursts": [[2, 1.0791], [4, 1.1254]], "known": []}},
},
"DDS": {
"One bare node": {"0": {"bursts": [[2, 2.2271], [4, 1.7627], [8, 1.5364], [12, 1.5911], [16, 1.6648]], "known": []}, "1": {"bursts": [[2, 1.5854], [4, 1.4474], [8, 1.4216], [12, 1.6491], [16, 1.7248]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.0927], [4, 1.1618], [8, 1.172], [12, 1.247], [16, 1.295]], "known": []}, "1": {"bursts": [[2, 1.23], [4, 1.0848], [8, 1.193], [12, 1.2297], [16, 1.3005]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.0699], [4, 1.1599], [8, 1.1622], [12, 1.2352], [16, 1.2925]], "known": []}, "1": {"bursts": [[2, 1.1406], [4, 1.0564], [8, 1.2028], [12, 1.2356], [16, 1.296]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.4994], [4, 1.2314], [8, 1.3547], [12, 1.3753], [16, 1.4134]], "known": []}, "1": {"bursts": [[2, 1.645], [4, 1.2417], [8, 1.2369], [12, 1.8849], [16, 1.5581]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.3258], [4, 1.2585], [8, 1.3217], [12, 1.1912], [16, 1.3973]], "known": []}, "1": {"bursts": [[2, 1.2546], [4, 1.0986], [8, 1.2868], [12, 1.2446], [16, 1.2835]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1815], [4, 1.1495], [8, 1.1751], [12, 1.254], [16, 1.3022]], "known": []}, "1": {"bursts": [[2, 1.154], [4, 1.1342], [8, 1.1819], [12, 1.2317], [16, 1.293]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0227], [4, 1.1043], [8, 1.1799], [12, 1.24]], "known": []}, "1": {"bursts": [[2, 1.0585], [4, 1.1179]], "known": []}},
},
"Fast DDS": {
"One bare node": {
"0": {"bursts": [[2, 1.1881], [4, 1.0848], [8, 1.1209], [12, 1.1416], [16, 1.141]], "known": [[2, 0.006612, 0.006915], [4, 0.018597, 0.020478], [8, 1.01148, 1.01599], [12, 1.03856, 2.01717], [16, 3.02326, 3.031]]},
"1": {"bursts": [[2, 1.142], [4, 1.0863], [8, 1.083], [12, 1.1336], [16, 1.2117]], "known": [[2, 0.015448, 0.016262], [4, 0.038702, 0.04111], [8, 1.0254, 1.03033], [12, 2.02257, 2.02889], [16, 3.03022, 3.04496]]},
},
"Nav2 in one process": {
"0": {"bursts": [[2, 1.0918], [4, 1.0921], [8, 1.1565], [12, 1.196], [16, 1.2705]], "known": [[2, 0.027914, 1.00268], [4, 3.01252, 3.02026], [8, 12.0356, 13.0234], [12, 26.0296, 27.0368], [16, 45.0118, 48.0659]]},
"1": {"bursts": [[2, 1.0709], [4, 1.1011], [8, 1.1524], [12, 1.2157], [16, 1.2433]], "known": [[2, 1.01513, 1.02812], [4, 4.01343, 4.02782], [8, 13.0346, 16.0328], [12, 29.0276, 31.0597], [16, 49.0893, 50.0218]]},
},
"Drone, PX4 through MAVROS": {
"0": {"bursts": [[2, 1.0911], [4, 1.1215], [8, 1.1816], [12, 1.2281], [16, 1.2663]], "known": [[2, 1.0144, 1.01623], [4, 4.03045, 6.01553], [8, 21.0253, 23.03], [12, 45.0097, 49.0217], s74]},
"1": {"bursts": [[2, 1.0534], [4, 1.1164], [8, 1.1753], [12, 1.2376], [16, 1.2725]], "known": [[2, 3.00298, 3.00934], [4, 8.00879, 9.01848], [8, 25.0358, 27.017], [12, 54.0095, 57.0543], s74]},
},
"The paper's swarm": {
"0": {"bursts": [[2, 1.0433], [4, 1.0451], [8, 1.0702], [12, 1.1032], [16, 1.1492]], "known": [[2, 0.014055, 0.014595], [4, 1.00753, 1.00777], [8, 1.04707, 2.01962], [12, 4.03566, 4.03684], [16, 7.04385, 7.53404]]},
"1": {"bursts": [[2, 1.0278], [4, 1.0336], [8, 1.0727], [12, 1.0864], [16, 1.1352]], "known": [[2, 0.029794, 0.033211], [4, 1.01689, 1.02095], [8, 2.03271, 3.01867], [12, 5.02916, 5.03536], [16, 8.03587, 9.01797]]},
},
"Drone, PX4 through uXRCE-DDS": {
"0": {"bursts": [[2, 1.0549], [4, 1.0343], [8, 1.0695], [12, 1.1222], [16, 1.1594]], "known": [[2, 0.021401, 0.022935], [4, 1.02096, 1.02517], [8, 4.01982, 5.02059], [12, 10.0386, 11.0247], [16, 18.0325, 18.0449]]},
"1": {"bursts": [[2, 1.0475], [4, 1.0372], [8, 1.0695], [12, 1.138], [16, 1.1447]], "known": [[2, 1.0036, 1.00612], [4, 2.01045, 2.0143], [8, 6.0155, 6.02545], [12, 11.0351, 11.0373], [16, 20.012, 20.0408]]},
},
"Manipulator with MoveIt": {
"0": {"bursts": [[2, 1.0184], [4, 1.0181], [8, 1.0695], [12, 1.1248], [16, 1.1547]], "known": [[2, 1.00589, 1.00901], [4, 3.0136, 3.02138], [8, 14.0278, 15.0123], [12, 30.0311, 33.0188], [16, 57.0368, 58.0332]]},
"1": {"bursts": [[2, 1.011], [4, 1.034], [8, 1.0832], [12, 1.1307], [16, 1.1585]], "known": [[2, 1.02199, 1.02305], [4, 4.015, 4.03292], [8, 14.0502, 16.0249], [12, 34.0256, 35.0236], [16, 56.0287, Infinity]]},
},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 0.9882], [4, 1.033], [8, 1.1257], [12, 1.1949]], "known": [[2, 14.0394, 16.0372], s76, s77, s75]}, "1": {"bursts": [[2, 0.9909], [4, 1.0371]], "known": [[2, 24.0174, Infinity], s76]}},
},
"Fast DDS Discovery Server": {
"One bare node": {"0": {"bursts": [[2, 3.2388], [4, 2.0836], [8, 1.9225], [12, 1.5557], [16, 1.7839]], "known": []}, "1": {"bursts": [[2, 2.4795], [4, 1.9895], [8, 1.6854], [12, 3.8548], [16, 1.7376]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.2988], [4, 1.2544], [8, 1.3883], [12, 1.3785], [16, 1.3695]], "known": []}, "1": {"bursts": [[2, 1.4824], [4, 1.3413], [8, 1.4227], [12, 1.3588], [16, 1.4802]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.2531], [4, 1.196], [8, 1.2163], [12, 1.2361], [16, 1.2607]], "known": []}, "1": {"bursts": [[2, 1.2242], [4, 1.177], [8, 1.2582], [12, 1.2218], [16, 1.2796]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.9648], [4, 1.5714], [8, 1.4108], [12, 1.3854], [16, 1.3262]], "known": []}, "1": {"bursts": [[2, 2.3694], [4, 1.601], [8, 1.4375], [12, 1.5448], [16, 1.4591]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.688], [4, 1.4902], [8, 1.3784], [12, 1.3729], [16, 1.3276]], "known": []}, "1": {"bursts": [[2, 1.6516], [4, 1.5313], [8, 1.3707], [12, 1.3771], [16, 1.4905]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.3367], [4, 1.1887], [8, 1.2262], [12, 1.2399], [16, 1.194]], "known": []}, "1": {"bursts": [[2, 1.4896], [4, 1.2516], [8, 1.2111], [12, 1.2056], [16, 1.3267]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.065], [4, 1.0711], [8, 1.1091], [12, 1.1361]], "known": []}, "1": {"bursts": [[2, 1.0484], [4, 1.066]], "known": []}},
},
"Fast DDS Discovery Server, on a robot": {
"One bare node": {"0": {"bursts": [[2, 3.3198], [4, 2.0876], [8, 1.7623], [12, 1.7307], [16, 2.9383]], "known": []}, "1": {"bursts": [[2, 2.2679], [4, 1.718], [8, 1.5258], [12, 1.6053], [16, 1.8225]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.4626], [4, 1.3543], [8, 1.1722], [12, 1.2772], [16, 1.3418]], "known": []}, "1": {"bursts": [[2, 1.3986], [4, 1.2598], [8, 1.2777], [12, 1.2872], [16, 1.3829]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.2559], [4, 1.1649], [8, 1.2173], [12, 1.2675], [16, 1.3621]], "known": []}, "1": {"bursts": [[2, 1.1427], [4, 1.2297], [8, 1.2547], [12, 1.2815], [16, 1.3241]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 2.2927], [4, 1.4717], [8, 1.371], [12, 1.4548], [16, 1.4746]], "known": []}, "1": {"bursts": [[2, 1.821], [4, 1.4413], [8, 1.5826], [12, 1.3332], [16, 1.5985]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 2.201], [4, 1.6103], [8, 1.3606], [12, 1.7133], [16, 1.3797]], "known": []}, "1": {"bursts": [[2, 1.5268], [4, 1.3798], [8, 1.3011], [12, 1.7241], [16, 1.564]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.2962], [4, 1.2241], [8, 1.1773], [12, 1.2283], [16, 1.3132]], "known": []}, "1": {"bursts": [[2, 1.4172], [4, 1.1057], [8, 1.2462], [12, 1.2679], [16, 1.3431]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0522], [4, 1.1136], [8, 1.2006], [12, 1.2483]], "known": []}, "1": {"bursts": [[2, 1.0704], [4, 1.114]], "known": []}},
},
"Fast DDS Discovery Server, two": {
"One bare node": {"0": {"bursts": [[2, 2.2777], [4, 1.7212], [8, 1.8283], [12, 1.3854], [16, 1.9911]], "known": []}, "1": {"bursts": [[2, 2.1456], [4, 1.899], [8, 1.5059], [12, 1.6405], [16, 1.5549]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.3412], [4, 1.2871], [8, 1.277], [12, 1.355], [16, 1.3567]], "known": []}, "1": {"bursts": [[2, 1.3064], [4, 1.2874], [8, 1.2759], [12, 1.292], [16, 1.4283]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1782], [4, 1.1059], [8, 1.2363], [12, 1.2115], [16, 1.2336]], "known": []}, "1": {"bursts": [[2, 1.1679], [4, 1.1458], [8, 1.2102], [12, 1.2141], [16, 1.29]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.5744], [4, 1.4334], [8, 1.272], [12, 1.3517], [16, 1.2342]], "known": []}, "1": {"bursts": [[2, 1.4144], [4, 1.3554], [8, 1.2578], [12, 1.2788], [16, 1.2647]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.5404], [4, 1.3334], [8, 1.3661], [12, 1.3012], [16, 1.3452]], "known": []}, "1": {"bursts": [[2, 1.638], [4, 1.42], [8, 1.2299], [12, 1.3239], [16, 1.2594]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.3036], [4, 1.1491], [8, 1.1638], [12, 1.1081], [16, 1.1774]], "known": []}, "1": {"bursts": [[2, 1.2611], [4, 1.1748], [8, 1.1452], [12, 1.1636], [16, 1.2114]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0472], [4, 1.0566], [8, 1.085], [12, 1.1134]], "known": []}, "1": {"bursts": [[2, 1.0485], [4, 1.0583]], "known": []}},
},
"Zenoh": {
"One bare node": {"0": {"bursts": [[2, 3.7903], [4, 2.5525], [8, 1.8967], [12, 1.8304], [16, 1.7436]], "known": []}, "1": {"bursts": [[2, 2.0449], [4, 1.7666], [8, 1.4758], [12, 1.4669], [16, 2.1751]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.3085], [4, 1.1113], [8, 1.1701], [12, 1.2407], [16, 1.31]], "known": []}, "1": {"bursts": [[2, 1.088], [4, 1.0854], [8, 1.2018], [12, 1.2218], [16, 1.3106]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.2113], [4, 1.0833], [8, 1.1784], [12, 1.2408], [16, 1.2833]], "known": []}, "1": {"bursts": [[2, 1.0681], [4, 1.1497], [8, 1.1962], [12, 1.2213], [16, 1.2944]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 2.1219], [4, 1.4732], [8, 1.4018], [12, 1.4799], [16, 1.5722]], "known": []}, "1": {"bursts": [[2, 1.8398], [4, 1.4378], [8, 1.3747], [12, 1.4408], [16, 1.4619]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.6155], [4, 1.2298], [8, 1.2674], [12, 1.2593], [16, 1.39]], "known": []}, "1": {"bursts": [[2, 1.3104], [4, 1.1306], [8, 1.3319], [12, 1.2874], [16, 1.268]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.2339], [4, 1.1454], [8, 1.1794], [12, 1.2545], [16, 1.3201]], "known": []}, "1": {"bursts": [[2, 1.1969], [4, 1.1317], [8, 1.213], [12, 1.2195], [16, 1.286]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0459], [4, 1.0916], [8, 1.1724], [12, 1.2284]], "known": []}, "1": {"bursts": [[2, 1.0416], [4, 1.0878]], "known": []}},
},
"Zenoh peer": {
"One bare node": {
"0": {"bursts": [[2, 2.3519], [4, 1.9431], [8, 1.8101], [12, 1.5307], [16, 1.5589]], "known": [[2, 0.003563, 1.00341], [4, 1.00308, 1.00509], [8, 1.01495, 1.02036], [12, 1.05498, 3.0197], [16, 3.0597, 7.02396]]},
"1": {"bursts": [[2, 1.7058], [4, 1.5166], [8, 1.3825], [12, 1.4343], [16, 1.7735]], "known": [[2, 0.007436, 1.00507], [4, 1.00757, 1.00929], [8, 1.03113, 3.01099], [12, 3.19276, 7.01988], [16, 8.14931, 15.0592]]},
},
"Nav2 in one process": {
"0": {"bursts": [[2, 1.4174], [4, 1.1261], [8, 1.1982], [12, 1.2357], [16, 1.3554]], "known": [[2, 0.012634, 2.00449], [4, 14.7815, 16.6095], s77, s75, s74]},
"1": {"bursts": [[2, 1.1423], [4, 1.1281], [8, 1.215], [12, 1.2759], [16, 1.3591]], "known": [[2, 1.51545, 3.88235], [4, 26.385, 32.232], s77, s75, s74]},
},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.3318], [4, 1.1335], [8, 1.2375], [12, 1.2585], [16, 1.2942]], "known": [[2, 1.87378, 2.45847], [4, 33.1078, Infinity], s77, s75, s74]}, "1": {"bursts": [[2, 1.1168], [4, 1.1492], [8, 1.1961], [12, 1.2754], [16, 1.3254]], "known": [[2, 3.45966, 5.10264], s76, s77, s75, s74]}},
"The paper's swarm": {
"0": {"bursts": [[2, 1.5809], [4, 1.5661], [8, 1.343], [12, 1.3561], [16, 1.3527]], "known": [[2, 0.005001, 1.00316], [4, 1.00744, 1.00947], [8, 3.01928, 3.02039], [12, 7.03317, 15.0294], [16, 23.0514, 39.0522]]},
"1": {"bursts": [[2, 1.4081], [4, 1.1588], [8, 1.2671], [12, 1.3804], [16, 1.4317]], "known": [[2, 1.00408, 1.00562], [4, 1.01631, 1.01836], [8, 7.13947, 8.15157], [12, 31.2016, Infinity], s74]},
},
"Drone, PX4 through uXRCE-DDS": {
"0": {"bursts": [[2, 1.4166], [4, 1.4241], [8, 1.3036], [12, 1.2551], [16, 1.3697]], "known": [[2, 0.007758, 1.00329], [4, 3.04586, 3.05779], [8, 16.1304, 31.1325], s75, s74]},
"1": {"bursts": [[2, 1.2178], [4, 1.5087], [8, 1.3061], [12, 1.3083], [16, 1.3073]], "known": [[2, 1.00489, 1.00561], [4, 1.08694, 7.08833], [8, 31.1711, 32.1024], s75, s74]},
},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1651], [4, 1.0755], [8, 1.1556], [12, 1.2264], [16, 1.3025]], "known": [[2, 1.00628, 1.00974], [4, 31.1345, 32.1082], s77, s75, s74]}, "1": {"bursts": [[2, 1.1476], [4, 1.1265], [8, 1.1778], [12, 1.2174], [16, 1.3098]], "known": [[2, 3.08868, 7.07008], s76, s77, s75, s74]}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0115], [4, 1.0832], [8, 1.1698], [12, 1.2379]], "known": [s78, s76, s77, s75]}, "1": {"bursts": [[2, 1.042], [4, 1.0863]], "known": s79}},
},
"Zenoh peer, tokens": {
"One bare node": {"0": {"bursts": [[2, 1.9603], [4, 1.6045], [8, 1.4607], [12, 1.4194], [16, 1.5279]], "known": []}, "1": {"bursts": [[2, 1.678], [4, 1.8695], [8, 1.3547], [12, 2.4337], [16, 1.7537]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.2192], [4, 1.1724], [8, 1.2153], [12, 1.2598], [16, 1.279]], "known": []}, "1": {"bursts": [[2, 1.1609], [4, 1.1368], [8, 1.1877], [12, 1.2539], [16, 1.3057]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1446], [4, 1.1467], [8, 1.1718], [12, 1.263], [16, 1.3079]], "known": []}, "1": {"bursts": [[2, 1.1236], [4, 1.1187], [8, 1.1955], [12, 1.2431], [16, 1.3024]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.3543], [4, 1.263], [8, 1.2467], [12, 1.2791], [16, 1.3483]], "known": []}, "1": {"bursts": [[2, 1.1973], [4, 1.1805], [8, 1.1433], [12, 1.284], [16, 1.3185]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.3633], [4, 1.1325], [8, 1.2098], [12, 1.2652], [16, 1.3931]], "known": []}, "1": {"bursts": [[2, 1.1676], [4, 1.1414], [8, 1.2242], [12, 1.2429], [16, 1.3765]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.14], [4, 1.1081], [8, 1.1724], [12, 1.2463], [16, 1.2993]], "known": []}, "1": {"bursts": [[2, 1.0981], [4, 1.1269], [8, 1.1513], [12, 1.2357], [16, 1.31]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0618], [4, 1.1084], [8, 1.1881], [12, 1.249]], "known": []}, "1": {"bursts": [[2, 1.0635], [4, 1.106]], "known": []}},
},
"Zenoh router": {
"One bare node": {"0": {"bursts": [[2, 5.009], [4, 3.1443], [8, 2.544], [12, 2.0221], [16, 2.0495]], "known": []}, "1": {"bursts": [[2, 2.6583], [4, 2.2201], [8, 2.038], [12, 1.9643], [16, 2.0588]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.3824], [4, 1.2044], [8, 1.1528], [12, 1.1969], [16, 1.1214]], "known": []}, "1": {"bursts": [[2, 1.2656], [4, 1.1786], [8, 1.1523], [12, 1.1659], [16, 1.1721]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.2114], [4, 1.1484], [8, 1.2757], [12, 1.1566], [16, 1.1293]], "known": []}, "1": {"bursts": [[2, 1.1342], [4, 1.1725], [8, 1.1165], [12, 1.1221], [16, 1.1422]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 3.0834], [4, 2.1839], [8, 1.9535], [12, 1.5706], [16, 2.8486]], "known": []}, "1": {"bursts": [[2, 2.0053], [4, 1.7253], [8, 1.6283], [12, 1.4893], [16, 1.7629]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.497], [4, 1.4108], [8, 1.3771], [12, 1.2591], [16, 1.2956]], "known": []}, "1": {"bursts": [[2, 1.6419], [4, 1.4426], [8, 1.2601], [12, 1.2739], [16, 1.5456]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.2741], [4, 1.1369], [8, 1.1023], [12, 1.0945], [16, 1.1115]], "known": []}, "1": {"bursts": [[2, 1.2831], [4, 1.2078], [8, 1.1273], [12, 1.1004], [16, 1.2617]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0357], [4, 1.0231], [8, 1.0254], [12, 1.0158]], "known": []}, "1": {"bursts": [[2, 1.0199], [4, 1.0215]], "known": []}},
},
"Zenoh router per host": {
"One bare node": {"0": {"bursts": [[2, 4.7153], [4, 1.9841], [8, 1.6268], [12, 1.8973], [16, 1.4605]], "known": []}, "1": {"bursts": [[2, 2.031], [4, 1.5243], [8, 1.3135], [12, 1.4722], [16, 1.4126]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.2357], [4, 1.3292], [8, 1.1639], [12, 1.285], [16, 1.3167]], "known": []}, "1": {"bursts": [[2, 1.1805], [4, 1.1314], [8, 1.2621], [12, 1.2835], [16, 1.3267]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.0542], [4, 1.1219], [8, 1.2255], [12, 1.2818], [16, 1.3396]], "known": []}, "1": {"bursts": [[2, 1.0731], [4, 1.1291], [8, 1.1994], [12, 1.2517], [16, 1.3371]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 4.4324], [4, 1.9353], [8, 1.4802], [12, 1.4447], [16, 1.5193]], "known": []}, "1": {"bursts": [[2, 2.0735], [4, 1.5022], [8, 1.4476], [12, 1.6341], [16, 1.6938]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 2.1298], [4, 1.3013], [8, 1.3284], [12, 1.3389], [16, 1.4719]], "known": []}, "1": {"bursts": [[2, 1.9197], [4, 1.2768], [8, 1.3766], [12, 1.311], [16, 1.4161]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.6415], [4, 1.326], [8, 1.4202], [12, 1.2242], [16, 1.3301]], "known": []}, "1": {"bursts": [[2, 1.3771], [4, 1.1564], [8, 1.2609], [12, 1.2453], [16, 1.3814]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.1684], [4, 1.1754], [8, 1.1942], [12, 1.2643]], "known": []}, "1": {"bursts": [[2, 1.2024], [4, 1.1144]], "known": []}},
},
"Zenoh router per host, star": {
"One bare node": {"0": {"bursts": [[2, 4.7919], [4, 3.0751], [8, 2.5856], [12, 2.0798], [16, 1.9077]], "known": []}, "1": {"bursts": [[2, 2.8323], [4, 2.8421], [8, 2.1346], [12, 2.0369], [16, 2.0346]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.5484], [4, 1.142], [8, 1.1901], [12, 1.0882], [16, 1.108]], "known": []}, "1": {"bursts": [[2, 1.3296], [4, 1.1186], [8, 1.1331], [12, 1.1329], [16, 1.1979]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.3988], [4, 1.1141], [8, 1.1003], [12, 1.0921], [16, 1.089]], "known": []}, "1": {"bursts": [[2, 1.4605], [4, 1.2231], [8, 1.2174], [12, 1.1482], [16, 1.0721]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 4.5266], [4, 2.8567], [8, 2.367], [12, 1.9291], [16, 2.1229]], "known": []}, "1": {"bursts": [[2, 2.7835], [4, 2.3989], [8, 1.9995], [12, 2.1284], [16, 4.6262]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 2.3003], [4, 2.0314], [8, 1.5371], [12, 1.4008], [16, 1.3162]], "known": []}, "1": {"bursts": [[2, 2.5078], [4, 1.6863], [8, 1.3462], [12, 1.45], [16, 1.3776]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.6436], [4, 1.3476], [8, 1.2986], [12, 1.2849], [16, 1.2557]], "known": []}, "1": {"bursts": [[2, 1.6872], [4, 1.4462], [8, 1.2267], [12, 1.2256], [16, 1.245]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.4791], [4, 1.2031], [8, 1.1063], [12, 1.1024]], "known": []}, "1": {"bursts": [[2, 1.4318], [4, 1.1513]], "known": []}},
},
},
"n": {
"Cyclone DDS": {
"One bare node": {
"0": {"bursts": [[2, 1.5192], [4, 1.1685], [8, 1.2151], [12, 1.2871], [16, 1.3187]], "known": [[2, 0.00521, 0.005367], [4, 0.018745, 0.107098], [8, 0.12277, 0.132912], [12, 12.9053, 12.9102], [16, 12.9167, 19.1057]]},
"1": {"bursts": [[2, 1.2371], [4, 1.2656], [8, 1.2124], [12, 1.4949], [16, 1.2637]], "known": [[2, 0.014985, 0.105902], [4, 0.109871, 0.112586], [8, 0.163739, 0.188029], [12, 12.91, 12.9105], [16, 16.1421, 19.1063]]},
},
"Nav2 in one process": {
"0": {"bursts": [[2, 1.0755], [4, 1.1007], [8, 1.2178], [12, 1.2299], [16, 1.3149]], "known": [[2, 0.040493, 0.042638], [4, 0.36313, 1.51893], [8, 12.95, 13.2167], [12, 17.3241, 19.758], [16, 37.3128, 41.9246]]},
"1": {"bursts": [[2, 1.1671], [4, 1.114], [8, 1.2314], [12, 1.2227], [16, 1.2936]], "known": [[2, 0.10603, 0.118242], [4, 12.7369, 12.9187], [8, 13.3414, 16.1584], [12, 16.5635, 17.4395], [16, 31.9239, 38.166]]},
},
"Drone, PX4 through MAVROS": {
"0": {"bursts": [[2, 1.2467], [4, 1.107], [8, 1.1908], [12, 1.2743], [16, 1.3083]], "known": [[2, 0.06833, 0.073848], [4, 0.865357, 12.933], [8, 14.5333, 19.1951], [12, 36.9047, 46.1065], [16, 48.1687, Infinity]]},
"1": {"bursts": [[2, 1.0783], [4, 1.0969], [8, 1.2093], [12, 1.2837], [16, 1.3166]], "known": [[2, 0.166147, 0.304365], [4, 12.7864, 12.932], [8, 13.8456, 16.3111], [12, 28.9518, 33.766], s74]},
},
"The paper's swarm": {
"0": {"bursts": [[2, 1.2047], [4, 1.0782], [8, 1.3028], [12, 1.2627], [16, 1.2874]], "known": [[2, 0.008953, 0.009553], [4, 0.112425, 0.119606], [8, 12.9083, 12.9115], [12, 12.9266, 18.9161], [16, 41.7291, Infinity]]},
"1": {"bursts": [[2, 1.1593], [4, 1.1576], [8, 1.3115], [12, 1.2282], [16, 1.2697]], "known": [[2, 0.026288, 0.10791], [4, 0.11988, 0.124757], [8, 12.9077, 19.1072], [12, 19.1086, 19.1194], s74]},
},
"Drone, PX4 through uXRCE-DDS": {
"0": {"bursts": [[2, 1.0886], [4, 1.1195], [8, 1.2087], [12, 1.2537], [16, 1.2769]], "known": [[2, 0.015702, 0.016256], [4, 0.134846, 0.305832], [8, 12.925, 13.3238], [12, 16.5105, 19.3331], [16, 33.8481, Infinity]]},
"1": {"bursts": [[2, 1.1388], [4, 1.1667], [8, 1.2239], [12, 1.2146], [16, 1.2978]], "known": [[2, 0.041269, 0.110443], [4, 0.213186, 12.7036], [8, 12.7312, 13.1269], [12, 19.103, 19.3135], s74]},
},
"Manipulator with MoveIt": {
"0": {"bursts": [[2, 1.1062], [4, 1.1581], [8, 1.206], [12, 1.2682], [16, 1.2922]], "known": [[2, 0.051736, 0.112175], [4, 12.9085, 12.9213], [8, 17.6288, 19.1179], s75, s74]},
"1": {"bursts": [[2, 1.1361], [4, 1.1064], [8, 1.1984], [12, 1.2735], [16, 1.3168]], "known": [[2, 0.105901, 0.310104], [4, 12.9193, 12.9206], [8, 16.1627, 19.1826], s75, s74]},
},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0995], [4, 1.1485]], "known": [[2, 25.904, Infinity], s76]}, "1": {"bursts": [[2, 1.1015], [4, 1.1536]], "known": s79}},
},
"Cyclone DDS multicast SEDP": {
"One bare node": {"0": {"bursts": [[2, 1.2819], [4, 1.0831], [8, 1.0869], [12, 1.2226], [16, 1.2135]], "known": []}, "1": {"bursts": [[2, 1.0955], [4, 1.0289], [8, 1.0348], [12, 1.1838], [16, 1.1732]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.0147], [4, 1.0145], [8, 1.0301], [12, 1.046], [16, 1.0577]], "known": []}, "1": {"bursts": [[2, 1.0369], [4, 1.0226], [8, 1.0313], [12, 1.0461], [16, 1.0452]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.0305], [4, 1.0098], [8, 1.0411], [12, 1.0457], [16, 1.0532]], "known": []}, "1": {"bursts": [[2, 1.0369], [4, 1.0262], [8, 1.0442], [12, 1.0515], [16, 1.0584]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.0618], [4, 1.0268], [8, 1.1268], [12, 1.1045], [16, 1.1314]], "known": []}, "1": {"bursts": [[2, 1.0642], [4, 1.0826], [8, 1.0891], [12, 1.1148], [16, 1.1406]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.0085], [4, 1.0213], [8, 1.0627], [12, 1.0621], [16, 1.0849]], "known": []}, "1": {"bursts": [[2, 1.0263], [4, 1.0172], [8, 1.0557], [12, 1.0521], [16, 1.0844]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.0327], [4, 1.022], [8, 1.0484], [12, 1.0616], [16, 1.0626]], "known": []}, "1": {"bursts": [[2, 1.0047], [4, 1.0269], [8, 1.0382], [12, 1.0617], [16, 1.0691]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0082], [4, 1.0266]], "known": []}, "1": {"bursts": [[2, 1.0126], [4, 1.0239]], "known": []}},
},
"Cyclone DDS peers": {
"One bare node": {"0": {"bursts": [[2, 1.457], [4, 1.2192], [8, 1.2207], [12, 1.251], [16, 1.2983]], "known": []}, "1": {"bursts": [[2, 1.578], [4, 1.1686], [8, 1.2273], [12, 1.3072], [16, 1.2337]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.0997], [4, 1.1889], [8, 1.2701], [12, 1.2601], [16, 1.3048]], "known": []}, "1": {"bursts": [[2, 1.1687], [4, 1.1502], [8, 1.2454], [12, 1.2589], [16, 1.3222]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.0892], [4, 1.1065], [8, 1.213], [12, 1.2935], [16, 1.3034]], "known": []}, "1": {"bursts": [[2, 1.1547], [4, 1.124], [8, 1.2274], [12, 1.2778], [16, 1.3212]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.3296], [4, 1.166], [8, 1.2385], [12, 1.2332], [16, 1.2823]], "known": []}, "1": {"bursts": [[2, 1.4453], [4, 1.1679], [8, 1.1693], [12, 1.2251], [16, 1.2409]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.1461], [4, 1.2435], [8, 1.2227], [12, 1.2389], [16, 1.2917]], "known": []}, "1": {"bursts": [[2, 1.3943], [4, 1.11], [8, 1.203], [12, 1.2418], [16, 1.2826]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.0969], [4, 1.1476], [8, 1.1986], [12, 1.2471], [16, 1.2966]], "known": []}, "1": {"bursts": [[2, 1.127], [4, 1.1811], [8, 1.1775], [12, 1.241], [16, 1.3052]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0941], [4, 1.1322]], "known": []}, "1": {"bursts": [[2, 1.0889], [4, 1.1394]], "known": []}},
},
"Cyclone DDS, version 11": {
"One bare node": {"0": {"bursts": [[2, 1.4366], [4, 1.2866], [8, 1.2403], [12, 1.3978], [16, 1.2862]], "known": []}, "1": {"bursts": [[2, 1.1647], [4, 1.1679], [8, 1.2853], [12, 1.3413], [16, 1.2742]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.2213], [4, 1.1018], [8, 1.145], [12, 1.231], [16, 1.2776]], "known": []}, "1": {"bursts": [[2, 1.077], [4, 1.1517], [8, 1.1915], [12, 1.2244], [16, 1.2912]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1487], [4, 1.1281], [8, 1.1877], [12, 1.2545], [16, 1.2972]], "known": []}, "1": {"bursts": [[2, 1.0692], [4, 1.1515], [8, 1.2038], [12, 1.2482], [16, 1.3097]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.1567], [4, 1.1324], [8, 1.1748], [12, 1.2274], [16, 1.2195]], "known": []}, "1": {"bursts": [[2, 1.1564], [4, 1.1681], [8, 1.1423], [12, 1.2463], [16, 1.2838]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.0746], [4, 1.1177], [8, 1.1804], [12, 1.2689], [16, 1.2619]], "known": []}, "1": {"bursts": [[2, 1.1403], [4, 1.1305], [8, 1.2002], [12, 1.2577], [16, 1.3286]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.162], [4, 1.121], [8, 1.184], [12, 1.254], [16, 1.3049]], "known": []}, "1": {"bursts": [[2, 1.0712], [4, 1.1502], [8, 1.2015], [12, 1.2525], [16, 1.2948]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.087], [4, 1.1385]], "known": []}, "1": {"bursts": [[2, 1.0988], [4, 1.1417]], "known": []}},
},
"DDS": {
"One bare node": {"0": {"bursts": [[2, 1.6582], [4, 1.3723], [8, 1.4027], [12, 1.6284], [16, 1.4387]], "known": []}, "1": {"bursts": [[2, 1.2769], [4, 1.2064], [8, 1.3107], [12, 1.3705], [16, 1.2802]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.1823], [4, 1.1174], [8, 1.2034], [12, 1.2299], [16, 1.2952]], "known": []}, "1": {"bursts": [[2, 1.1265], [4, 1.1327], [8, 1.1813], [12, 1.2554], [16, 1.2982]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1414], [4, 1.1123], [8, 1.1733], [12, 1.2489], [16, 1.3026]], "known": []}, "1": {"bursts": [[2, 1.0966], [4, 1.1464], [8, 1.1941], [12, 1.2457], [16, 1.3057]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.2583], [4, 1.1827], [8, 1.2524], [12, 1.3412], [16, 1.3148]], "known": []}, "1": {"bursts": [[2, 1.3837], [4, 1.0907], [8, 1.2439], [12, 1.2839], [16, 1.2718]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.2306], [4, 1.1362], [8, 1.2097], [12, 1.2234], [16, 1.3139]], "known": []}, "1": {"bursts": [[2, 1.172], [4, 1.1325], [8, 1.1977], [12, 1.2334], [16, 1.2708]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1613], [4, 1.1231], [8, 1.2156], [12, 1.2419], [16, 1.3032]], "known": []}, "1": {"bursts": [[2, 1.0768], [4, 1.1039], [8, 1.202], [12, 1.2325], [16, 1.2584]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0789], [4, 1.1364]], "known": []}, "1": {"bursts": [[2, 1.1022], [4, 1.1383]], "known": []}},
},
"Fast DDS": {
"One bare node": {
"0": {"bursts": [[2, 1.1523], [4, 1.1182], [8, 1.1246], [12, 1.2183], [16, 1.2231]], "known": [[2, 0.008706, 0.009151], [4, 0.035326, 0.037518], [8, 1.02892, 1.03223], [12, 1.14029, 2.02076], [16, 2.15425, 3.02568]]},
"1": {"bursts": [[2, 1.1295], [4, 1.1061], [8, 1.1132], [12, 1.2798], [16, 1.2103]], "known": [[2, 0.0298, 0.032478], [4, 0.081187, 0.083182], [8, 1.07885, 1.09147], [12, 2.07105, 2.07846], [16, 3.08959, 3.11378]]},
},
"Nav2 in one process": {
"0": {"bursts": [[2, 1.1654], [4, 1.1251], [8, 1.2132], [12, 1.2297], [16, 1.2872]], "known": [[2, 0.108126, 1.02265], [4, 3.00917, 3.04289], [8, 12.1498, 14.1032], [12, 30.1156, 31.1697], [16, 55.0607, 55.2517]]},
"1": {"bursts": [[2, 1.1524], [4, 1.1065], [8, 1.1725], [12, 1.2498], [16, 1.285]], "known": [[2, 1.0727, 1.08628], [4, 4.0658, 4.09081], [8, 13.0466, 13.077], [12, 32.1804, 35.0765], s74]},
},
"Drone, PX4 through MAVROS": {
"0": {"bursts": [[2, 1.1329], [4, 1.1276], [8, 1.1826], [12, 1.2452], [16, 1.3172]], "known": [[2, 1.05505, 1.06822], [4, 5.07416, 6.04454], [8, 22.0804, 24.1422], [12, 52.0054, 52.0903], s74]},
"1": {"bursts": [[2, 1.1579], [4, 1.1396], [8, 1.202], [12, 1.2454], [16, 1.298]], "known": [[2, 3.00459, 3.03541], [4, 7.05832, 9.03111], [8, 26.0369, 30.1723], [12, 56.2178, 58.0744], s74]},
},
"The paper's swarm": {
"0": {"bursts": [[2, 1.0323], [4, 1.0354], [8, 1.1423], [12, 1.1512], [16, 1.1937]], "known": [[2, 0.019961, 0.020567], [4, 1.0099, 1.01354], [8, 2.0442, 2.04916], [12, 4.07963, 5.03524], [16, 8.06416, 8.14654]]},
"1": {"bursts": [[2, 1.037], [4, 1.0894], [8, 1.1451], [12, 1.2029], [16, 1.1862]], "known": [[2, 0.05774, 0.069245], [4, 1.04071, 1.05625], [8, 2.09608, 2.12609], [12, 5.10763, 6.03834], [16, 9.11247, 10.1244]]},
},
"Drone, PX4 through uXRCE-DDS": {
"0": {"bursts": [[2, 1.0988], [4, 1.0655], [8, 1.124], [12, 1.1886], [16, 1.2573]], "known": [[2, 0.043707, 0.045083], [4, 1.08321, 1.08897], [8, 4.10464, 4.1107], [12, 11.0895, 11.1075], [16, 19.1444, 21.1009]]},
"1": {"bursts": [[2, 1.0666], [4, 1.056], [8, 1.1573], [12, 1.186], [16, 1.2611]], "known": [[2, 0.092177, 0.103457], [4, 1.17012, 2.03237], [8, 5.09095, 5.1399], [12, 12.0476, 13.1208], [16, 20.1166, 22.0767]]},
},
"Manipulator with MoveIt": {
"0": {"bursts": [[2, 1.0726], [4, 1.0772], [8, 1.1837], [12, 1.2154], [16, 1.2557]], "known": [[2, 1.02633, 1.03035], [4, 3.07951, 4.05203], [8, 14.0998, 15.0485], [12, 33.1251, 35.0869], s74]},
"1": {"bursts": [[2, 1.0712], [4, 1.1079], [8, 1.1774], [12, 1.2233], [16, 1.2697]], "known": [[2, 1.0584, 1.06569], [4, 4.03684, 5.04449], [8, 15.1017, 17.0184], [12, 36.056, 37.1019], s74]},
},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0418], [4, 1.0993]], "known": [[2, 16.168, 17.12], s76]}, "1": {"bursts": [[2, 1.0404], [4, 1.1062]], "known": [[2, 18.1418, 24.0269], s76]}},
},
"Fast DDS Discovery Server": {
"One bare node": {"0": {"bursts": [[2, 1.6115], [4, 1.3047], [8, 1.4548], [12, 1.4219], [16, 1.3904]], "known": []}, "1": {"bursts": [[2, 1.6196], [4, 1.3106], [8, 1.2356], [12, 1.3459], [16, 1.7826]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.1259], [4, 1.369], [8, 1.4464], [12, 1.3575], [16, 1.3422]], "known": []}, "1": {"bursts": [[2, 1.255], [4, 1.1808], [8, 1.268], [12, 1.366], [16, 1.3456]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1286], [4, 1.1889], [8, 1.2169], [12, 1.2317], [16, 1.2589]], "known": []}, "1": {"bursts": [[2, 1.168], [4, 1.1625], [8, 1.2035], [12, 1.2153], [16, 1.2093]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.2658], [4, 1.1534], [8, 1.1959], [12, 1.4215], [16, 1.281]], "known": []}, "1": {"bursts": [[2, 2.8635], [4, 1.242], [8, 1.1888], [12, 1.3442], [16, 1.2508]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.1707], [4, 1.1371], [8, 1.2425], [12, 1.3066], [16, 1.2406]], "known": []}, "1": {"bursts": [[2, 1.2445], [4, 1.2228], [8, 1.0927], [12, 1.239], [16, 1.4255]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1536], [4, 1.1354], [8, 1.16], [12, 1.1609], [16, 1.2029]], "known": []}, "1": {"bursts": [[2, 1.2845], [4, 1.186], [8, 1.1661], [12, 1.1558], [16, 1.1902]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0678], [4, 1.0735]], "known": []}, "1": {"bursts": [[2, 1.0547], [4, 1.0767]], "known": []}},
},
"Fast DDS Discovery Server, on a robot": {
"One bare node": {"0": {"bursts": [[2, 1.6338], [4, 1.4811], [8, 1.4258], [12, 1.4281], [16, 1.4002]], "known": []}, "1": {"bursts": [[2, 1.3988], [4, 1.1871], [8, 1.2921], [12, 1.3256], [16, 1.6441]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.2142], [4, 1.2093], [8, 1.2472], [12, 1.2525], [16, 1.3769]], "known": []}, "1": {"bursts": [[2, 1.2144], [4, 1.2031], [8, 1.2183], [12, 1.2577], [16, 1.3224]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.177], [4, 1.1482], [8, 1.2399], [12, 1.275], [16, 1.3581]], "known": []}, "1": {"bursts": [[2, 1.1116], [4, 1.1596], [8, 1.1878], [12, 1.2469], [16, 1.3133]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.5022], [4, 1.2121], [8, 1.2985], [12, 1.2292], [16, 1.3476]], "known": []}, "1": {"bursts": [[2, 1.248], [4, 1.211], [8, 1.2659], [12, 1.4025], [16, 1.3132]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.437], [4, 1.1767], [8, 1.3661], [12, 1.2355], [16, 1.3715]], "known": []}, "1": {"bursts": [[2, 1.3554], [4, 1.1599], [8, 1.3003], [12, 1.2945], [16, 1.3226]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1368], [4, 1.1711], [8, 1.2445], [12, 1.2408], [16, 1.2838]], "known": []}, "1": {"bursts": [[2, 1.2215], [4, 1.1408], [8, 1.1721], [12, 1.257], [16, 1.2846]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.071], [4, 1.1339]], "known": []}, "1": {"bursts": [[2, 1.0911], [4, 1.1448]], "known": []}},
},
"Fast DDS Discovery Server, two": {
"One bare node": {"0": {"bursts": [[2, 1.3197], [4, 1.1955], [8, 1.361], [12, 1.7171], [16, 1.3667]], "known": []}, "1": {"bursts": [[2, 1.4639], [4, 1.1723], [8, 1.2451], [12, 1.2671], [16, 1.2135]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.2306], [4, 1.2137], [8, 1.2712], [12, 1.2348], [16, 1.2911]], "known": []}, "1": {"bursts": [[2, 1.252], [4, 1.1806], [8, 1.2704], [12, 1.2787], [16, 1.2984]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1558], [4, 1.2048], [8, 1.2031], [12, 1.2143], [16, 1.2387]], "known": []}, "1": {"bursts": [[2, 1.1344], [4, 1.192], [8, 1.2009], [12, 1.2208], [16, 1.2344]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.1544], [4, 1.1727], [8, 1.1852], [12, 1.1351], [16, 1.2347]], "known": []}, "1": {"bursts": [[2, 1.1495], [4, 1.1624], [8, 1.1654], [12, 1.2912], [16, 1.1926]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.2498], [4, 1.1311], [8, 1.358], [12, 1.1841], [16, 1.2237]], "known": []}, "1": {"bursts": [[2, 1.3439], [4, 1.2274], [8, 1.1395], [12, 1.193], [16, 1.2161]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.2051], [4, 1.1891], [8, 1.1313], [12, 1.194], [16, 1.1707]], "known": []}, "1": {"bursts": [[2, 1.3348], [4, 1.105], [8, 1.152], [12, 1.1525], [16, 1.1781]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0488], [4, 1.076]], "known": []}, "1": {"bursts": [[2, 1.0573], [4, 1.0708]], "known": []}},
},
"Zenoh": {
"One bare node": {"0": {"bursts": [[2, 2.5708], [4, 1.809], [8, 1.5348], [12, 1.5329], [16, 1.564]], "known": []}, "1": {"bursts": [[2, 1.5053], [4, 1.3616], [8, 1.4083], [12, 1.4696], [16, 1.978]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.2201], [4, 1.1178], [8, 1.1632], [12, 1.2435], [16, 1.3062]], "known": []}, "1": {"bursts": [[2, 1.1475], [4, 1.1244], [8, 1.2046], [12, 1.2523], [16, 1.2995]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1612], [4, 1.1005], [8, 1.1787], [12, 1.2438], [16, 1.3027]], "known": []}, "1": {"bursts": [[2, 1.099], [4, 1.1492], [8, 1.1816], [12, 1.2378], [16, 1.283]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.6089], [4, 1.3481], [8, 1.2902], [12, 1.3262], [16, 1.2974]], "known": []}, "1": {"bursts": [[2, 1.98], [4, 1.2243], [8, 1.3503], [12, 1.395], [16, 1.3592]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.3547], [4, 1.1626], [8, 1.2239], [12, 1.2331], [16, 1.222]], "known": []}, "1": {"bursts": [[2, 1.2323], [4, 1.1078], [8, 1.2004], [12, 1.306], [16, 1.2771]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1651], [4, 1.0951], [8, 1.1887], [12, 1.2415], [16, 1.2879]], "known": []}, "1": {"bursts": [[2, 1.1443], [4, 1.1563], [8, 1.234], [12, 1.2536], [16, 1.2958]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0892], [4, 1.1184]], "known": []}, "1": {"bursts": [[2, 1.0917], [4, 1.1223]], "known": []}},
},
"Zenoh peer": {
"One bare node": {
"0": {"bursts": [[2, 1.9735], [4, 1.5476], [8, 1.4762], [12, 1.5975], [16, 1.5067]], "known": [[2, 0.004127, 1.00387], [4, 1.00338, 1.00632], [8, 1.01813, 1.02568], [12, 1.12172, 3.01418], [16, 7.02563, 23.0278]]},
"1": {"bursts": [[2, 1.428], [4, 1.6394], [8, 1.4168], [12, 1.4047], [16, 1.6382]], "known": [[2, 0.010896, 1.00799], [4, 1.00835, 1.01342], [8, 3.01091, 3.01392], [12, 3.40787, 7.46236], [16, 7.41957, 15.0492]]},
},
"Nav2 in one process": {
"0": {"bursts": [[2, 1.3042], [4, 1.1196], [8, 1.1843], [12, 1.2755], [16, 1.3317]], "known": [[2, 0.030598, 2.00723], [4, 28.0504, 34.5461], s77, s75, s74]},
"1": {"bursts": [[2, 1.1691], [4, 1.1446], [8, 1.2172], [12, 1.2463], [16, 1.3063]], "known": [[2, 3.96297, 5.40384], [4, 54.1847, Infinity], s77, s75, s74]},
},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.2374], [4, 1.1168], [8, 1.2264], [12, 1.2581], [16, 1.3089]], "known": [[2, 3.31342, 4.44993], s76, s77, s75, s74]}, "1": {"bursts": [[2, 1.1391], [4, 1.1157], [8, 1.2218], [12, 1.2596], [16, 1.3039]], "known": [[2, 8.79743, 15.2817], s76, s77, s75, s74]}},
"The paper's swarm": {
"0": {"bursts": [[2, 1.3781], [4, 1.4078], [8, 1.1737], [12, 1.3932], [16, 1.3295]], "known": [[2, 0.006633, 1.00358], [4, 1.01053, 1.01283], [8, 3.02453, 7.02061], [12, 7.05269, 15.0405], [16, 15.0796, 39.0637]]},
"1": {"bursts": [[2, 1.2514], [4, 1.1156], [8, 1.2625], [12, 1.3108], [16, 1.326]], "known": [[2, 1.00536, 1.00816], [4, 1.02746, 1.0303], [8, 8.31863, 15.2735], [12, 31.3812, Infinity], s74]},
},
"Drone, PX4 through uXRCE-DDS": {
"0": {"bursts": [[2, 1.2844], [4, 1.1028], [8, 1.176], [12, 1.2931], [16, 1.2851]], "known": [[2, 0.013236, 1.00461], [4, 3.15553, 3.1813], [8, 16.3106, 31.2523], s75, s74]},
"1": {"bursts": [[2, 1.1368], [4, 1.1276], [8, 1.2836], [12, 1.2314], [16, 1.2876]], "known": [[2, 1.00629, 1.00957], [4, 3.12371, 7.01201], s77, s75, s74]},
},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.183], [4, 1.1192], [8, 1.2152], [12, 1.2326], [16, 1.2851]], "known": [[2, 1.00962, 1.01288], [4, 31.4495, Infinity], s77, s75, s74]}, "1": {"bursts": [[2, 1.1179], [4, 1.1609], [8, 1.2368], [12, 1.2585], [16, 1.2977]], "known": [[2, 3.1821, 7.15264], s76, s77, s75, s74]}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0823], [4, 1.1263]], "known": s79}, "1": {"bursts": [[2, 1.0747], [4, 1.1293]], "known": s79}},
},
"Zenoh peer, tokens": {
"One bare node": {"0": {"bursts": [[2, 1.527], [4, 1.2851], [8, 1.3514], [12, 1.4385], [16, 1.3265]], "known": []}, "1": {"bursts": [[2, 1.2209], [4, 1.176], [8, 1.2547], [12, 1.3451], [16, 1.2989]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.1785], [4, 1.1515], [8, 1.2215], [12, 1.2684], [16, 1.3138]], "known": []}, "1": {"bursts": [[2, 1.1718], [4, 1.1732], [8, 1.2391], [12, 1.2779], [16, 1.2984]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1459], [4, 1.1351], [8, 1.2388], [12, 1.2759], [16, 1.3296]], "known": []}, "1": {"bursts": [[2, 1.1259], [4, 1.1406], [8, 1.2259], [12, 1.261], [16, 1.3221]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.1848], [4, 1.2688], [8, 1.3019], [12, 1.25], [16, 1.3204]], "known": []}, "1": {"bursts": [[2, 1.2625], [4, 1.1269], [8, 1.2249], [12, 1.2538], [16, 1.2412]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.2807], [4, 1.0669], [8, 1.2237], [12, 1.2567], [16, 1.2785]], "known": []}, "1": {"bursts": [[2, 1.1831], [4, 1.1306], [8, 1.2024], [12, 1.285], [16, 1.3281]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1046], [4, 1.1284], [8, 1.186], [12, 1.2463], [16, 1.3154]], "known": []}, "1": {"bursts": [[2, 1.1577], [4, 1.126], [8, 1.233], [12, 1.2578], [16, 1.3097]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0827], [4, 1.131]], "known": []}, "1": {"bursts": [[2, 1.098], [4, 1.1311]], "known": []}},
},
"Zenoh router": {
"One bare node": {"0": {"bursts": [[2, 2.2575], [4, 1.6298], [8, 1.6748], [12, 1.3264], [16, 1.3945]], "known": []}, "1": {"bursts": [[2, 1.654], [4, 1.3956], [8, 1.3106], [12, 1.4499], [16, 1.3867]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.2576], [4, 1.145], [8, 1.1558], [12, 1.1195], [16, 1.0976]], "known": []}, "1": {"bursts": [[2, 1.2039], [4, 1.1426], [8, 1.1265], [12, 1.122], [16, 1.0995]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.1713], [4, 1.1302], [8, 1.1264], [12, 1.1254], [16, 1.1099]], "known": []}, "1": {"bursts": [[2, 1.246], [4, 1.1333], [8, 1.1286], [12, 1.1014], [16, 1.0946]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 1.6409], [4, 1.3359], [8, 1.2885], [12, 1.2639], [16, 1.1969]], "known": []}, "1": {"bursts": [[2, 1.3712], [4, 1.235], [8, 1.1406], [12, 1.2385], [16, 1.7924]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.1365], [4, 1.1481], [8, 1.1151], [12, 1.1225], [16, 1.083]], "known": []}, "1": {"bursts": [[2, 1.3366], [4, 1.2853], [8, 1.1012], [12, 1.1309], [16, 1.0923]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.2198], [4, 1.065], [8, 1.0326], [12, 1.0579], [16, 1.0564]], "known": []}, "1": {"bursts": [[2, 1.2237], [4, 1.1315], [8, 1.0486], [12, 1.0563], [16, 1.0664]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0263], [4, 1.0129]], "known": []}, "1": {"bursts": [[2, 1.0148], [4, 1.0154]], "known": []}},
},
"Zenoh router per host": {
"One bare node": {"0": {"bursts": [[2, 2.3139], [4, 1.3505], [8, 1.2277], [12, 1.2863], [16, 1.3934]], "known": []}, "1": {"bursts": [[2, 1.3569], [4, 1.2477], [8, 1.2517], [12, 1.3477], [16, 1.2813]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.1025], [4, 1.0868], [8, 1.172], [12, 1.2779], [16, 1.2866]], "known": []}, "1": {"bursts": [[2, 1.1704], [4, 1.1694], [8, 1.1955], [12, 1.2671], [16, 1.3326]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.0514], [4, 1.1071], [8, 1.2435], [12, 1.258], [16, 1.3119]], "known": []}, "1": {"bursts": [[2, 1.1317], [4, 1.1426], [8, 1.2245], [12, 1.2783], [16, 1.3247]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 2.222], [4, 1.3941], [8, 1.5802], [12, 1.2163], [16, 1.2838]], "known": []}, "1": {"bursts": [[2, 1.7761], [4, 1.2723], [8, 1.3797], [12, 1.3135], [16, 1.3201]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.4251], [4, 1.1972], [8, 1.1624], [12, 1.2029], [16, 1.3008]], "known": []}, "1": {"bursts": [[2, 1.5434], [4, 1.15], [8, 1.1878], [12, 1.2494], [16, 1.2957]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.2935], [4, 1.1675], [8, 1.1728], [12, 1.1937], [16, 1.2595]], "known": []}, "1": {"bursts": [[2, 1.2802], [4, 1.1291], [8, 1.1666], [12, 1.2428], [16, 1.2836]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.0831], [4, 1.1365]], "known": []}, "1": {"bursts": [[2, 1.2114], [4, 1.0717]], "known": []}},
},
"Zenoh router per host, star": {
"One bare node": {"0": {"bursts": [[2, 2.2144], [4, 1.5363], [8, 1.628], [12, 1.2837], [16, 1.4534]], "known": []}, "1": {"bursts": [[2, 1.6235], [4, 1.4788], [8, 1.2939], [12, 1.425], [16, 1.4078]], "known": []}},
"Nav2 in one process": {"0": {"bursts": [[2, 1.1473], [4, 1.0497], [8, 1.0835], [12, 1.062], [16, 1.0608]], "known": []}, "1": {"bursts": [[2, 1.1863], [4, 1.0905], [8, 1.035], [12, 1.0744], [16, 1.0573]], "known": []}},
"Drone, PX4 through MAVROS": {"0": {"bursts": [[2, 1.2668], [4, 1.1007], [8, 1.0372], [12, 1.0499], [16, 1.05]], "known": []}, "1": {"bursts": [[2, 1.3016], [4, 1.0162], [8, 1.0799], [12, 1.0618], [16, 1.0572]], "known": []}},
"The paper's swarm": {"0": {"bursts": [[2, 2.1114], [4, 1.4972], [8, 1.5421], [12, 1.3418], [16, 1.3155]], "known": []}, "1": {"bursts": [[2, 1.6416], [4, 1.6285], [8, 1.2509], [12, 1.2712], [16, 1.3364]], "known": []}},
"Drone, PX4 through uXRCE-DDS": {"0": {"bursts": [[2, 1.3121], [4, 1.4318], [8, 1.1352], [12, 1.0921], [16, 1.1089]], "known": []}, "1": {"bursts": [[2, 2.1681], [4, 1.2064], [8, 1.2097], [12, 1.2591], [16, 1.2127]], "known": []}},
"Manipulator with MoveIt": {"0": {"bursts": [[2, 1.1583], [4, 1.1798], [8, 1.1113], [12, 1.0971], [16, 1.0634]], "known": []}, "1": {"bursts": [[2, 1.2263], [4, 1.1593], [8, 1.0886], [12, 1.1], [16, 1.0789]], "known": []}},
"TurtleBot 4 with Nav2": {"0": {"bursts": [[2, 1.2603], [4, 1.093]], "known": []}, "1": {"bursts": [[2, 1.1657], [4, 1.0973]], "known": []}},
},
},
},
},
"simulation": {"runs": 10, "seed": 0, "queue": [500, 0.5], "until": 120},
"topology": "one access point, infrastructure",
"limit": 1,
"told": 2,
"beyond": "; we did not measure the error for a fleet of this size",
"times": [[0, 1e-06, "µs"], [0.001, 0.001, "ms"], [0.1, 1, "s"], [100, 60, "minutes"], [6000, 3600, "hours"], [172800, 86400, "days"], [60480000, 31557600, "years"]],
"airtime": {"inside": {"up": s80, "multicast": "inside_multicast", "unicast": s80}, "linear": {"up": s81, "multicast": "linear_multicast", "unicast": s81}, "padded": {"up": s82, "multicast": s83, "unicast": s82}, "aggregated": {"up": s84, "multicast": s83, "unicast": s84}},
"laptop_nodes": 2,
"service_endpoints": 12,
"endpoints_of_a_node": 28.40740740740741,
"shared_endpoints": [2, 4],
"remedies": {
"aggregation": {"steps": ["aggregation"], "of": {"DDS": s86, "Zenoh": s86, "None": s86}},
"announcements": {"steps": ["announcements"], "of": {"DDS": {"effort": 2, "takes": s87, "best_case": false, "mind": "a failed robot is noticed later, and a lost announcement is repeated later"}, "Zenoh": null, "None": null}},
"discovery server": {"steps": [s88], "of": {"DDS": {"effort": 3, "takes": s89, "best_case": false, "mind": "each robot needs its address; ros2 tools must be super clients; late joiners stay undiscovered while it is down, and after short outages without -b"}, "Zenoh": null, "None": null}},
"discovery server on a robot": {"steps": [s90], "of": {"DDS": {"effort": 3, "takes": s89, "best_case": false, "mind": "each robot needs its address; ros2 tools must be super clients; late joiners stay undiscovered while that robot is away"}, "Zenoh": null, "None": null}},
"endpoints": {"steps": ["endpoints"], "of": {"DDS": s91, "Zenoh": s91, "None": s91}},
"middleware": {"steps": ["middleware"], "of": {"DDS": s93, "Zenoh": {"effort": 7, "takes": s92, "best_case": false, "mind": "all hosts must change together; we count peers that scout by multicast; the paper does not count the tokens of rmw_zenoh"}, "None": s93}},
"middleware and discovery server": {
"steps": ["middleware", s88],
"of": {"DDS": {"effort": 7, "takes": s94, "best_case": false, "mind": "all hosts must change together; each robot needs its address; ros2 tools must be super clients; late joiners stay undiscovered while it is down, and after short outages without -b"}, "Zenoh": null, "None": null},
},
"middleware and discovery server on a robot": {"steps": ["middleware", s90], "of": {"DDS": {"effort": 7, "takes": s94, "best_case": false, "mind": "all hosts must change together; each robot needs its address; ros2 tools must be super clients; late joiners stay undiscovered while that robot is away"}, "Zenoh": null, "None": null}},
"middleware and multicast endpoint data": {"steps": ["middleware", s95], "of": {"DDS": {"effort": 7, "takes": s96, "best_case": false, "mind": "all hosts must change together; multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later"}, "Zenoh": null, "None": null}},
"middleware and peers": {
"steps": ["middleware", "peers"],
"of": {
"DDS": {"effort": 7, "takes": s96, "best_case": false, "mind": "all hosts must change together; you must know the addresses beforehand; every announcement goes to 9 ports of every address, with ROS_STATIC_PEERS to 32"},
"Zenoh": {"effort": 7, "takes": s96, "best_case": false, "mind": "all hosts must change together; you must know the addresses beforehand; a process that dials a peer before it is up may dial it every 4 s indefinitely"},
"None": null,
},
},
"middleware and router": {
"steps": ["middleware", "router"],
"of": {"DDS": null, "Zenoh": {"effort": 7, "takes": s94, "best_case": false, "mind": "all hosts must change together; each robot needs its address; data goes through it, too; robots do not hear each other until 2.2 s after the router is back (killed, lease of 10 s)"}, "None": null},
},
"middleware and router on each host": {"steps": ["middleware", s97], "of": {"DDS": null, "Zenoh": {"effort": 7, "takes": s98, "best_case": false, "mind": "all hosts must change together; every router needs the addresses of the others; a robot whose router is down hears no other robot until 4.2 s after the router is back"}, "None": null}},
"middleware and star of routers": {"steps": ["middleware", s99], "of": {"DDS": null, "Zenoh": {"effort": 7, "takes": s98, "best_case": false, "mind": "all hosts must change together; every robot needs the wired router's address; robots do not hear each other while the wired router is away"}, "None": null}},
"middleware and static endpoints": {
"steps": ["middleware", s100],
"of": {"DDS": {"effort": 7, "takes": "another middleware and rebuilt nodes", "best_case": false, "mind": "all hosts must change together; whoever adds an endpoint must list it in every file, and ROS 2's own endpoints too; Fast DDS 2.9.1 can crash"}, "Zenoh": null, "None": null},
},
"middleware and two discovery servers": {"steps": ["middleware", s101], "of": {"DDS": {"effort": 7, "takes": s98, "best_case": false, "mind": "all hosts must change together; each robot needs both addresses; ros2 tools must be super clients; late joiners stay undiscovered while both are down"}, "Zenoh": null, "None": null}},
"multicast endpoint data": {"steps": [s95], "of": {"DDS": {"effort": 2, "takes": s87, "best_case": false, "mind": "multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later"}, "Zenoh": null, "None": null}},
"multicast rate": {"steps": [s12], "of": {"DDS": s102, "Zenoh": s102, "None": s102}},
"peers": {
"steps": ["peers"],
"of": {
"DDS": {"effort": 2, "takes": s87, "best_case": false, "mind": "you must know the addresses beforehand; every announcement goes to 9 ports of every address, with ROS_STATIC_PEERS to 32"},
"Zenoh": {"effort": 2, "takes": s87, "best_case": false, "mind": "you must know the addresses beforehand; a process that dials a peer before it is up may dial it every 4 s indefinitely"},
"None": null,
},
},
"processes": {"steps": ["processes"], "of": {"DDS": s103, "Zenoh": s103, "None": s103}},
"radio": {"steps": ["radio"], "of": {"DDS": s104, "Zenoh": s104, "None": s104}},
"router": {"steps": ["router"], "of": {"DDS": null, "Zenoh": {"effort": 3, "takes": s89, "best_case": false, "mind": "each robot needs its address; data goes through it, too; robots do not hear each other until 2.2 s after the router is back (killed, lease of 10 s)"}, "None": null}},
"router on each host": {"steps": [s97], "of": {"DDS": null, "Zenoh": {"effort": 4, "takes": s105, "best_case": false, "mind": "every router needs the addresses of the others; a robot whose router is down hears no other robot until 4.2 s after the router is back"}, "None": null}},
"star of routers": {"steps": [s99], "of": {"DDS": null, "Zenoh": {"effort": 4, "takes": s105, "best_case": false, "mind": "every robot needs the wired router's address; robots do not hear each other while the wired router is away"}, "None": null}},
"static endpoints": {"steps": [s100], "of": {"DDS": {"effort": 5, "takes": "rebuilt nodes", "best_case": false, "mind": "whoever adds an endpoint must list it in every file, and ROS 2's own endpoints too; Fast DDS 2.9.1 can crash"}, "Zenoh": null, "None": null}},
"two discovery servers": {"steps": [s101], "of": {"DDS": {"effort": 4, "takes": s105, "best_case": false, "mind": "each robot needs both addresses; ros2 tools must be super clients; late joiners stay undiscovered while both are down"}, "Zenoh": null, "None": null}},
},
"pastes": {
"aggregation": {
"any": [
{
"where": s106,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Leave band, channel and width as they are. With 802.11ac and ax, vht_capab lets 64 frames of any\n# length into an exchange; with 802.11n alone, leave out the last two lines.\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[SHORT-GI-20]\nieee80211ac=1\nvht_capab=[MAX-A-MPDU-LEN-EXP7]\n",
},
],
},
"announcements": {
"Fast DDS": [
{
"where": s107,
"version": s108,
"text": "<!-- Fast DDS 2.9.1: for every process -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"calm\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <initialAnnouncements>\n              <count>1</count>\n              <period>\n                <sec>1</sec>\n              </period>\n            </initialAnnouncements>\n            <leaseAnnouncement>\n              <sec>15</sec>\n            </leaseAnnouncement>\n            <leaseDuration>\n              <sec>100</sec>\n            </leaseDuration>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
],
"Cyclone DDS": [
{
"where": s107,
"version": s109,
"text": "<!-- Cyclone DDS 0.10.2 and 11.0.1: for every process -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <Discovery>\n      <LeaseDuration>100 s</LeaseDuration>\n      <SPDPInterval>30 s</SPDPInterval>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"discovery server": {
"any": [
{"where": s110, "version": s108, "text": "# Fast DDS 2.9.1: on a computer that is wired to the access point\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# The address is that of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n"},
{
"where": "on the same computer, with a backup file",
"version": s108,
"text": "# Fast DDS 2.9.1: on the same computer, with a backup file\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# In place of the command above. -b keeps the server's state in a file, here in /var/tmp. We let a\n# process start while the server was away for 3 to 10 s: undiscovered in 14 of 15 runs, with -b\n# in 0 of 15. Without -b wait for the lease of 20 s before you start the server again.\ncd /var/tmp && fastdds discovery -i 0 -l 192.168.1.10 -p 11811 -b\n",
},
s112,
{
"where": "for the server if it is a program of your own",
"version": s108,
"text": "<!-- Fast DDS 2.9.1: for the server if it is a program of your own -->\n<!-- Load: save as /etc/fast_dds.xml; the server's process runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"server\" is_default_profile=\"true\">\n      <rtps>\n        <prefix>44.53.00.5f.45.50.52.4f.53.49.4d.41</prefix>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SERVER</discoveryProtocol>\n          </discovery_config>\n          <metatrafficUnicastLocatorList>\n            <locator>\n              <udpv4>\n                <address>192.168.1.10</address>\n                <port>11811</port>\n              </udpv4>\n            </locator>\n          </metatrafficUnicastLocatorList>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
{
"where": "for a client that reads no environment",
"version": s108,
"text": "<!-- Fast DDS 2.9.1: for a client that reads no environment -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"client\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>CLIENT</discoveryProtocol>\n            <discoveryServersList>\n              <RemoteServer prefix=\"44.53.00.5f.45.50.52.4f.53.49.4d.41\">\n                <metatrafficUnicastLocatorList>\n                  <locator>\n                    <udpv4>\n                      <address>192.168.1.10</address>\n                      <port>11811</port>\n                    </udpv4>\n                  </locator>\n                </metatrafficUnicastLocatorList>\n              </RemoteServer>\n            </discoveryServersList>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
s113,
s114,
],
},
"discovery server on a robot": {
"any": [
{"where": "on one of the robots", "version": s108, "text": "# Fast DDS 2.9.1: on one of the robots\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# The address is that of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n"},
{
"where": "on the same robot, with a backup file",
"version": s108,
"text": "# Fast DDS 2.9.1: on the same robot, with a backup file\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# In place of the command above. -b keeps the server's state in a file, here in /var/tmp. We let a\n# process start while the server was away for 3 to 10 s: undiscovered in 14 of 15 runs, with -b\n# in 0 of 15. Without -b wait for the lease of 20 s before you start the server again.\ncd /var/tmp && fastdds discovery -i 0 -l 192.168.1.10 -p 11811 -b\n",
},
s112,
s113,
s114,
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
"where": s115,
"version": "ROS 2 Jazzy",
"text": "# ROS 2 Jazzy: on every computer\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_fastrtps_cpp\n",
},
],
"Cyclone DDS": [
{
"where": s115,
"version": "ROS 2 Jazzy",
"text": "# ROS 2 Jazzy: on every computer\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n",
},
],
"Zenoh": [
{
"where": s115,
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
"where": s107,
"version": s109,
"text": "<!-- Cyclone DDS 0.10.2 and 11.0.1: for every process -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <!-- On Wi-Fi it would send by multicast no more than its announcements. -->\n      <AllowMulticast>true</AllowMulticast>\n    </General>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"multicast rate": {
"any": [
{
"where": s106,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Frames to a group and those of management go out at the lowest basic rate, here 24 Mbit/s (in\n# units of 100 kbit/s). Older rates (not those of 802.11n and later) below it are gone: who is\n# too far away for it cannot join.\n# Band and channel: as you have them.\nhw_mode=a\nchannel=36\nsupported_rates=240 360 480 540\nbasic_rates=240\n",
},
],
},
"peers": {
"Cyclone DDS": [
{
"where": s107,
"version": s109,
"text": "<!-- Cyclone DDS 0.10.2 and 11.0.1: for every process -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <AllowMulticast>false</AllowMulticast>\n    </General>\n    <Discovery>\n      <!-- At least as many as a host has processes. -->\n      <ParticipantIndex>auto</ParticipantIndex>\n      <MaxAutoParticipantIndex>9</MaxAutoParticipantIndex>\n      <!-- Every host, this one included. -->\n      <Peers>\n        <Peer Address=\"192.168.1.21\"/>\n        <Peer Address=\"192.168.1.22\"/>\n        <Peer Address=\"192.168.1.23\"/>\n      </Peers>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
"DDS": [
{
"where": s111,
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
"where": s106,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\n",
},
],
"802.11ac 80 MHz": [
{
"where": s106,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=1\nvht_oper_centr_freq_seg0_idx=42\nvht_capab=[SHORT-GI-80][MAX-A-MPDU-LEN-EXP7]\n",
},
],
"802.11ax 160 MHz": [
{
"where": s106,
"version": "hostapd 2.10",
"text": "# hostapd 2.10: hostapd.conf of the access point\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Channels 52 to 64 are shared with radars: that needs a country.\ncountry_code=US\nieee80211d=1\nieee80211h=1\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=2\nvht_oper_centr_freq_seg0_idx=50\nvht_capab=[VHT160][SHORT-GI-80][SHORT-GI-160][MAX-A-MPDU-LEN-EXP7]\nieee80211ax=1\nhe_oper_chwidth=2\nhe_oper_centr_freq_seg0_idx=50\n",
},
],
},
"router": {
"any": [
s116,
{
"where": s107,
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
s117,
],
},
"star of routers": {
"any": [
s116,
{
"where": "on every robot for its router, which is told of the wired one alone",
"version": "Zenoh 1.10.2",
"text": "// Zenoh 1.10.2: on every robot for its router, which is told of the wired one alone\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  // The router that is wired to the access point, and no other robot.\n  connect: { endpoints: [\"tcp/192.168.1.10:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // What rmw_zenoh sets in a file of its own, which this one takes the place of.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
s117,
],
},
"static endpoints": {
"any": [
{
"where": s107,
"version": s108,
"text": "<!-- Fast DDS 2.9.1: for every process -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE); in ROS 2 it matches nothing without -->\n<!-- RMW_FASTRTPS_USE_QOS_FROM_XML=1 -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"robot\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <EDP>STATIC</EDP>\n            <static_edp_xml_config>file:///etc/fast_dds_static_endpoints.xml</static_edp_xml_config>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n    <!-- One for each endpoint of this process, by the name of its topic. -->\n    <data_writer profile_name=\"/robot1/odom\">\n      <userDefinedID>1</userDefinedID>\n    </data_writer>\n  </profiles>\n</dds>\n",
},
{
"where": s111,
"version": s108,
"text": "<!-- Fast DDS 2.9.1: on every robot -->\n<!-- Load: save as /etc/fast_dds_static_endpoints.xml, where the profile for every process -->\n<!-- looks for it; no environment variable of its own -->\n<staticdiscovery>\n  <!-- Every process, by the name of its participant (in ROS 2 its enclave), with all its\n       endpoints; no two of them all have the same number. -->\n  <participant>\n    <name>/robot1</name>\n    <writer>\n      <userId>1</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </writer>\n  </participant>\n  <participant>\n    <name>/laptop</name>\n    <reader>\n      <userId>2</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </reader>\n  </participant>\n</staticdiscovery>\n",
},
],
},
"two discovery servers": {
"any": [
{
"where": "on two computers that are wired to the access point",
"version": s108,
"text": "# Fast DDS 2.9.1: on two computers that are wired to the access point\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# The first line on one of them, the second on the other, each with its own address.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\nfastdds discovery -i 1 -l 192.168.1.11 -p 11811\n",
},
{
"where": "on every robot; the servers stand in the order of their numbers",
"version": s108,
"text": "# Fast DDS 2.9.1: on every robot; the servers stand in the order of their numbers\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: run\n# in the shell or put in the service file that starts the ROS 2 processes, before they start\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811;192.168.1.11:11811\"\n",
},
s113,
s114,
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
"group": s4,
"family": "DDS",
"product": null,
"tables": [s121, s124, s127, s128, s131, s134, ["middleware", "switching to Zenoh", "", "Zenoh", "DDS", "middleware"]],
"about": "",
"color": "--ds-family-dds",
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s138,
"windows": s139,
"units": [s141, s143, s145],
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s146], ["SEDP", "unicast", 464, 1, 1, 1, "up down", s146], ["Heartbeat", "unicast", 116, 1, 2, 2, "up down", s146], ["ACKNACK", "unicast", 114, 1, 2, 2, "up down", s146]],
},
"Zenoh": {
"group": s4,
"family": "Zenoh",
"product": null,
"tables": [s150, s153, s156, ["peers", "static peers", "", "Zenoh, static peers", "Zenoh", "peers"], ["middleware", "switching to DDS", "", "DDS", "Zenoh", "middleware"]],
"about": "",
"color": s157,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s138,
"windows": s139,
"units": s158,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s146], ["Hello", "unicast", 144, 1, 1, 1, "up down", s146], ["Declare", "unicast", 176, 1, 2, 1, "up down", s146], s159],
},
"Cyclone DDS": {
"group": s2,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s88, s160, "", s120, "Cyclone DDS", s161],
[s101, s162, "", s123, "Cyclone DDS", s163],
[s90, s164, "", s126, "Cyclone DDS", s165],
[s100, s166, "", s100, "Cyclone DDS", s167],
["peers", "static peers", "", s130, "Cyclone DDS", "peers"],
[s95, s132, "", s133, "Cyclone DDS", s95],
["router", s168, "", "Zenoh router", "Cyclone DDS", s169],
[s97, s170, "", s152, "Cyclone DDS", s171],
[s99, s172, "", s155, "Cyclone DDS", s173],
["announcements", s174, "", "Cyclone DDS, a longer announcement interval", "Cyclone DDS", "announcements"],
["middleware", s175, "", s176, "Cyclone DDS", "middleware"],
["middleware", s177, "", "Fast DDS", "Cyclone DDS", "middleware"],
["middleware", s178, "", s149, "Cyclone DDS", "middleware"],
],
"about": s179,
"color": s180,
"measured": [8, 12, 60],
"band": s181,
"reboot": [1.45, 3.59],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s190,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s191],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s192],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s193],
["SEDP", "unicast", s194, 0.2218, 2, 1, "up down", s195],
["SEDP again", "unicast", s194, 0.2218, 3, 0.103, "up down", s195],
["Heartbeat", "unicast", s196, 0.5226, 1, 2, "up down", s195],
[s197, "unicast", s196, 0.5226, 1, 2.481, "up down", s195],
["ACKNACK", "unicast", s198, 0.402, 1, 4.635, "up down", s195],
[s199, "unicast", s198, 0.402, 4, 0.09896, "up down", s195],
s202,
[s203, "unicast", s204, 0.6253, 1, 1, "up down", s195],
[s205, "unicast", s204, 0.6253, 4, 0.1067, "up down", s195],
s208,
[s209, "unicast", s210, 0.4544, 1, 2.222, "up down", s195],
s212,
[s213, "unicast", s214, 0.3044, 1, 2.312, "up down", s195],
[s215, "unicast", s214, 0.3044, 4, 0.05208, "up down", s195],
[s216, "unicast", s217, 0.6806, 1, 2.333, "up down", s195],
[s218, "unicast", s219, 0.2641, 1, 2, "up down", s195],
[s220, "unicast", s219, 0.2641, 4, 0.2188, "up down", s195],
[s221, "unicast", s222, 0.6247, 5, 1.006, "up down", s195],
[s223, "unicast", s222, 0.6247, 6, 0.07217, "up down", s195],
["User ACKNACK", "unicast", s224, 0.338, 5, 1.404, "up down", s195],
[s225, "unicast", s224, 0.338, 6, 0.09793, "up down", s195],
],
},
"Cyclone DDS, wired": {
"group": s2,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s88, s160, "", s120, s226, s161],
[s101, s162, "", s123, s226, s163],
[s90, s164, "", s126, s226, s165],
[s100, s166, "", s100, s226, s167],
s131,
s134,
["router", s168, "", "Zenoh router", s226, s169],
[s97, s170, "", s152, s226, s171],
[s99, s172, "", s155, s226, s173],
["announcements", s174, "", "Cyclone DDS, wired, a longer announcement interval", s226, "announcements"],
["middleware", s227, "", "Cyclone DDS", s226, "middleware"],
["middleware", s175, "", s176, s226, "middleware"],
["middleware", s177, "", "Fast DDS", s226, "middleware"],
["middleware", s178, "", s149, s226, "middleware"],
],
"about": s228,
"color": s180,
"measured": [8, 12, 20],
"band": s229,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s230,
"degree": 3,
"messages": [
s231,
["SPDP directed", "unicast", s232, 0.9963, 1, 0.6667, "up down", s193],
["SEDP", "unicast", s233, 0.1841, 2, 0.5833, "up down", s195],
[s234, "multicast", s235, 0.2228, 2, 0.1667, "up down", s195],
[s236, "multicast", 232, 0.25, 0, 2, "up down", s195],
["Heartbeat", "unicast", s237, 0.3287, 1, 3, "up down", s195],
["ACKNACK", "unicast", s238, 0.3715, 1, 4.05, "up down", s195],
[s199, "unicast", s238, 0.3715, 3, 0.2833, "up down", s195],
["Liveliness", "multicast", s200, 0.7242, 0, 1, "up down", s201],
[s203, "multicast", s239, 0.9582, 0, 0.3333, "up down", s195],
[s240, "unicast", 429, 0.2, 1, 0.5, "up down", s195],
[s206, "multicast", s207, 0.2758, 0, 1, "up down", s201],
[s209, "multicast", s241, 0.1767, 0, 0.875, "up down", s195],
[s242, "unicast", s243, 0.2117, 1, 1.625, "up down", s195],
s212,
[s213, "unicast", s244, 0.2807, 1, 2.344, "up down", s195],
[s215, "unicast", s244, 0.2807, 3, 0.07812, "up down", s195],
[s216, "multicast", s245, 0.1988, 0, 2, "up down", s195],
[s246, "unicast", s247, 0.1917, 1, 0.6667, "up down", s195],
[s218, "unicast", 211.5, 0.2, 1, 2, "up down", s195],
[s220, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s195],
[s221, "unicast", s248, 0.2427, 4, 0.75, "up down", s195],
[s249, "multicast", s250, 0.2152, 4, 0.25, "up down", s195],
["User ACKNACK", "unicast", s251, 0.2283, 4, 2, "up down", s195],
],
},
"Cyclone DDS, version 11": {
"group": s2,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s88, s160, "", s120, s176, s161],
[s101, s162, "", s123, s176, s163],
[s90, s164, "", s126, s176, s165],
[s100, s166, "", s100, s176, s167],
s131,
s134,
["router", s168, "", "Zenoh router", s176, s169],
[s97, s170, "", s152, s176, s171],
[s99, s172, "", s155, s176, s173],
["announcements", s174, "", "Cyclone DDS, version 11, a longer announcement interval", s176, "announcements"],
["middleware", s227, "", "Cyclone DDS", s176, "middleware"],
["middleware", s177, "", "Fast DDS", s176, "middleware"],
["middleware", s178, "", s149, s176, "middleware"],
],
"about": s252,
"color": s180,
"measured": [8, 12, 60],
"band": s253,
"reboot": [1.31, 3.21],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s190,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s191],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s192],
["SPDP directed", "unicast", s254, 0.9992, 1, 0.5413, "up down", s193],
["SEDP", "unicast", s255, 0.4598, 2, 1, "up down", s195],
["SEDP again", "unicast", s255, 0.4598, 3, 0.09093, "up down", s195],
["Heartbeat", "unicast", s256, 0.5475, 1, 2, "up down", s195],
[s197, "unicast", s256, 0.5475, 1, 2.833, "up down", s195],
["ACKNACK", "unicast", s257, 0.3982, 1, 5.167, "up down", s195],
[s199, "unicast", s257, 0.3982, 4, 0.125, "up down", s195],
s202,
[s203, "unicast", s258, 0.6519, 1, 1, "up down", s195],
[s205, "unicast", s258, 0.6519, 4, 0.09103, "up down", s195],
s208,
[s209, "unicast", s259, 0.4401, 1, 2.188, "up down", s195],
s212,
[s213, "unicast", s260, 0.2753, 1, 2.278, "up down", s195],
[s215, "unicast", s260, 0.2753, 4, 0.05556, "up down", s195],
[s216, "unicast", s261, 0.6399, 1, 2.542, "up down", s195],
[s218, "unicast", s262, 0.2385, 1, 2, "up down", s195],
[s220, "unicast", s262, 0.2385, 4, 0.1997, "up down", s195],
[s221, "unicast", s263, 0.6975, 5, 1.06, "up down", s195],
[s223, "unicast", s263, 0.6975, 6, 0.06995, "up down", s195],
["User ACKNACK", "unicast", s264, 0.4362, 5, 1.562, "up down", s195],
[s225, "unicast", s264, 0.4362, 6, 0.09399, "up down", s195],
],
},
"Cyclone DDS peers": {
"group": s3,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s88, s160, "", s120, s130, s161],
[s101, s162, "", s123, s130, s163],
[s90, s164, "", s126, s130, s165],
[s100, s166, "", s100, s130, s167],
[s95, s132, "", s133, s130, s95],
["router", s168, "", "Zenoh router", s130, s169],
[s97, s170, "", s152, s130, s171],
[s99, s172, "", s155, s130, s173],
["announcements", s174, "", "Cyclone DDS peers, a longer announcement interval", s130, "announcements"],
["middleware", s227, "", "Cyclone DDS", s130, "middleware"],
["middleware", s175, "", s176, s130, "middleware"],
["middleware", s177, "", "Fast DDS", s130, "middleware"],
["middleware", s178, "", s149, s130, "middleware"],
],
"about": s265,
"color": s180,
"measured": [8, 12, 10],
"band": s266,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s271,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s191],
[s272, "unicast", 448, 1, 1, 6, "up down", s273],
["SPDP directed", "unicast", s274, 0.9817, 2, 0.8333, "up down", s193],
["SEDP", "unicast", s275, 0.172, 3, 1, "up down", s195],
["SEDP again", "unicast", s276, 0.8001, 4, 0.08633, "up down", s195],
["Heartbeat", "unicast", s277, 0.5756, 2, 2, "up down", s195],
[s197, "unicast", s277, 0.5756, 2, 2.944, "up down", s195],
["ACKNACK", "unicast", s278, 0.3827, 2, 4.424, "up down", s195],
[s199, "unicast", s278, 0.3827, 5, 0.2049, "up down", s195],
["Liveliness", "unicast", s279, 0.7241, 2, 1, "up down", s201],
[s203, "unicast", s280, 0.7527, 2, 1, "up down", s195],
[s205, "unicast", s280, 0.7527, 5, 0.08333, "up down", s195],
[s206, "unicast", s281, 0.2759, 2, 1, "up down", s201],
[s209, "unicast", s282, 0.4258, 2, 2.556, "up down", s195],
[s211, "unicast", 128, 1, 2, 1, "up down", s201],
[s213, "unicast", s283, 0.265, 2, 2.296, "up down", s195],
[s215, "unicast", s283, 0.265, 5, 0.09271, "up down", s195],
[s216, "unicast", s284, 0.6431, 2, 3, "up down", s195],
[s218, "unicast", s285, 0.283, 2, 2, "up down", s195],
[s220, "unicast", s285, 0.283, 5, 0.3631, "up down", s195],
[s221, "unicast", s286, 0.5405, 6, 1.542, "up down", s195],
["User ACKNACK", "unicast", s287, 0.437, 6, 2.208, "up down", s195],
],
},
"Cyclone DDS multicast SEDP": {
"group": s3,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [
[s88, s160, "", s120, s133, s161],
[s101, s162, "", s123, s133, s163],
[s90, s164, "", s126, s133, s165],
[s100, s166, "", s100, s133, s167],
["peers", "static peers", "", s130, s133, "peers"],
["router", s168, "", "Zenoh router", s133, s169],
[s97, s170, "", s152, s133, s171],
[s99, s172, "", s155, s133, s173],
["announcements", s174, "", "Cyclone DDS multicast SEDP, a longer announcement interval", s133, "announcements"],
["middleware", s227, "", "Cyclone DDS", s133, "middleware"],
["middleware", s175, "", s176, s133, "middleware"],
["middleware", s177, "", "Fast DDS", s133, "middleware"],
["middleware", s178, "", s149, s133, "middleware"],
],
"about": s288,
"color": s180,
"measured": [8, 12, 10],
"band": s289,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s230,
"degree": 3,
"messages": [
s231,
["SPDP directed", "unicast", s290, 0.9988, 1, 0.8, "up down", s193],
["SEDP", "unicast", s291, 0.2085, 2, 0.3719, "up down", s195],
[s234, "multicast", s292, 0.2222, 2, 0.23, "up down", s195],
[s236, "multicast", s293, 0.28, 0, 1.833, "up down", s195],
["Heartbeat", "unicast", s294, 0.3143, 1, 3.333, "up down", s195],
["ACKNACK", "unicast", s295, 0.3558, 1, 4.517, "up down", s195],
[s199, "unicast", s295, 0.3558, 3, 0.1494, "up down", s195],
["Liveliness", "multicast", s296, 0.724, 0, 1, "up down", s201],
[s203, "multicast", s297, 0.9539, 0, 0.8333, "up down", s195],
[s240, "unicast", s298, 0.15, 1, 0.5, "up down", s195],
[s206, "multicast", s299, 0.276, 0, 1, "up down", s201],
[s209, "multicast", s300, 0.2328, 0, 1, "up down", s195],
[s242, "unicast", s301, 0.2318, 1, 1.75, "up down", s195],
s212,
[s213, "unicast", s302, 0.2856, 1, 2.379, "up down", s195],
[s215, "unicast", s302, 0.2856, 3, 0.08854, "up down", s195],
[s216, "multicast", s303, 0.2325, 0, 2, "up down", s195],
[s246, "unicast", s304, 0.1726, 1, 1.167, "up down", s195],
[s218, "unicast", s305, 0.2088, 1, 2, "up down", s195],
[s220, "unicast", s305, 0.2088, 3, 0.3274, "up down", s195],
[s221, "unicast", s306, 0.4167, 4, 0.7917, "up down", s195],
[s249, "multicast", s307, 0.6667, 4, 0.1667, "up down", s195],
["User ACKNACK", "unicast", s308, 0.4167, 4, 2.167, "up down", s195],
],
},
"Fast DDS Discovery Server": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s101, s122, "", s123, s120, s101],
[s90, s125, "", s126, s120, s90],
[s100, s100, "", s100, s120, s100],
["peers", s309, "", s130, s120, s310],
[s95, s311, "", s133, s120, s312],
["router", s168, "", "Zenoh router", s120, s169],
[s97, s170, "", s152, s120, s171],
[s99, s172, "", s155, s120, s173],
["middleware", s227, "", "Cyclone DDS", s120, "middleware"],
["middleware", s175, "", s176, s120, "middleware"],
["middleware", s177, "", "Fast DDS", s120, "middleware"],
["middleware", s178, "", s149, s120, "middleware"],
],
"about": "one server, wired to the access point (measured with 2.9.1)",
"color": s313,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms within that range that we did not fit, discovery took 1.00 to 1.10 times the airtime of the model (typical error 4%)"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s314,
"windows": s315,
"units": s322,
"degree": 2,
"messages": [
[s323, "unicast", 652, 1, 0, 1, "up", s325],
[s326, "unicast", 700, 1, 0, 1, "down", s327],
[s328, "unicast", s329, 0.865, 0, 1, "down", s330],
[s331, "unicast", s332, 0.8517, 1, 1.967, "down", s330],
[s333, "unicast", 192, 1, 0, 2, "up", s330],
[s334, "unicast", s335, 0.5969, 0, 2.167, "down", s330],
[s336, "unicast", s337, 0.3182, 1, 2.908, "down", s330],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up", s330],
[s338, "unicast", 190.2, 1, 1, 0.5083, "up", s330],
[s339, "unicast", 188, 1, 0, 2, "down", s330],
["SPDP Gap", "unicast", s340, 0.6193, 1, 1.6, "down", s330],
[s341, "unicast", 1152, 0.45, 2, 1, "up", s330],
[s342, "unicast", s343, 0.8446, 3, 1.237, "down", s330],
["Heartbeat", "unicast", 192, 1, 0, 4, "up", s330],
[s344, "unicast", 192, 1, 0, 4, "down", s330],
[s345, "unicast", s346, 0.2358, 3, 1.892, "down", s330],
["ACKNACK", "unicast", 188, 1, 0, 4, "up", s330],
[s347, "unicast", 191.3, 1, 3, 0.45, "up", s330],
[s348, "unicast", 188.5, 1, 0, 15.6, "down", s330],
["Gap", "unicast", s349, 0.6838, 3, 0.645, "down", s330],
[s350, "unicast", 192, 1, 0, 1, "up", s330],
[s351, "unicast", 192, 1, 0, 2, "down", s330],
s352,
[s353, "unicast", 188, 1, 0, 2, "up", s330],
[s354, "unicast", 188, 1, 0, 2, "down", s330],
s355,
s356,
s357,
],
},
"Fast DDS Discovery Server, two": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s88, s118, "", s120, s123, s88],
[s90, s125, "", s126, s123, s90],
[s100, s100, "", s100, s123, s100],
["peers", s309, "", s130, s123, s310],
[s95, s311, "", s133, s123, s312],
["router", s168, "", "Zenoh router", s123, s169],
[s97, s170, "", s152, s123, s171],
[s99, s172, "", s155, s123, s173],
["middleware", s227, "", "Cyclone DDS", s123, "middleware"],
["middleware", s175, "", s176, s123, "middleware"],
["middleware", s177, "", "Fast DDS", s123, "middleware"],
["middleware", s178, "", s149, s123, "middleware"],
],
"about": "two servers that know nothing of each other, both wired to the access point; clients of both (measured with 2.9.1)",
"color": s313,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms within that range that we did not fit, discovery took 1.00 to 1.05 times the airtime of the model (typical error 2%)"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s314,
"windows": s315,
"units": s322,
"degree": 2,
"messages": [
[s323, "unicast", 636, 1, 0, 2, "up", s325],
[s326, "unicast", 700, 1, 0, 2, "down", s327],
[s328, "unicast", 747.8396673212429, 0.8657, 0, 2, "down", s330],
[s331, "unicast", 684.0093940817285, 0.8516, 1, 3.9, "down", s330],
[s333, "unicast", 192, 1, 0, 4, "up", s330],
[s334, "unicast", 244.85106382978725, 0.6204, 0, 4.625, "down", s330],
[s336, "unicast", 402.48973607038124, 0.2728, 1, 5.942, "down", s330],
["SPDP ACKNACK", "unicast", 189.8, 1, 0, 4.625, "up", s330],
[s338, "unicast", 190.5, 1, 1, 0.9417, "up", s330],
[s339, "unicast", 188, 1, 0, 4, "down", s330],
["SPDP Gap", "unicast", 199.09006997171358, 0.6717, 1, 3.333, "down", s330],
[s341, "unicast", 1257.7301004163605, 0.4083, 2, 2, "up", s330],
[s342, "unicast", s343, 0.8446, 3, 2.45, "down", s330],
["Heartbeat", "unicast", 184, 1, 0, 8, "up", s330],
[s344, "unicast", 192, 1, 0, 8, "down", s330],
[s345, "unicast", 432.5140562248996, 0.249, 3, 3.242, "down", s330],
["ACKNACK", "unicast", 188, 1, 0, 8, "up", s330],
[s347, "unicast", 190.8, 1, 3, 0.85, "up", s330],
[s348, "unicast", 188.5, 1, 0, 31.6, "down", s330],
["Gap", "unicast", 207.54580397181294, 0.6244, 3, 1.03, "down", s330],
[s350, "unicast", 192, 1, 0, 2, "up", s330],
[s351, "unicast", 192, 1, 0, 4, "down", s330],
[s206, "unicast", 192, 1, 4, 1.208, "up down", s330],
[s353, "unicast", 188, 1, 0, 4, "up", s330],
[s354, "unicast", 188, 1, 0, 4, "down", s330],
[s211, "unicast", 188, 1, 4, 1.208, "up down", s330],
[s221, "unicast", 192, 1, 5, 1.08, "up down", s330],
["User ACKNACK", "unicast", 188, 1, 5, 1.179, "up down", s330],
],
},
"Fast DDS Discovery Server, on a robot": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s88, s118, "", s120, s126, s88],
[s101, s122, "", s123, s126, s101],
[s100, s100, "", s100, s126, s100],
["peers", s309, "", s130, s126, s310],
[s95, s311, "", s133, s126, s312],
["router", s168, "", "Zenoh router", s126, s169],
[s97, s170, "", s152, s126, s171],
[s99, s172, "", s155, s126, s173],
["middleware", s227, "", "Cyclone DDS", s126, "middleware"],
["middleware", s175, "", s176, s126, "middleware"],
["middleware", s177, "", "Fast DDS", s126, "middleware"],
["middleware", s178, "", s149, s126, "middleware"],
],
"about": "one server, on a robot with processes of its own; as the table of a wired one, on other hops (measured with 2.9.1)",
"color": s313,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms within that range that we did not fit, discovery took 0.97 to 1.16 times the airtime of the model (typical error 3%)"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s314,
"windows": s315,
"units": [[s358, s358, s358], [s188, s359, s359], [s360, s360, s360], [s188, {"count": "count21", "more": ["more52", "more53", "more43"]}, {"count": "count22", "more": ["more54", "more55", "more5"]}], s321, s189],
"degree": 2,
"messages": [
[s323, "unicast", 652, 1, 0, 1, "up down", s325],
[s326, "unicast", 700, 1, 0, 1, "up down", s327],
[s328, "unicast", s329, 0.865, 0, 1, "up down", s330],
[s331, "unicast", s332, 0.8517, 1, 1.967, "up down", s330],
[s333, "unicast", 192, 1, 0, 2, "up down", s330],
[s334, "unicast", s335, 0.5969, 0, 2.167, "up down", s330],
[s336, "unicast", s337, 0.3182, 1, 2.908, "up down", s330],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up down", s330],
[s338, "unicast", 190.2, 1, 1, 0.5083, "up down", s330],
[s339, "unicast", 188, 1, 0, 2, "up down", s330],
["SPDP Gap", "unicast", s340, 0.6193, 1, 1.6, "up down", s330],
[s341, "unicast", 1152, 0.45, 2, 1, "up down", s330],
[s342, "unicast", s343, 0.8446, 3, 1.237, "up down", s330],
["Heartbeat", "unicast", 192, 1, 0, 4, "up down", s330],
[s344, "unicast", 192, 1, 0, 4, "up down", s330],
[s345, "unicast", s346, 0.2358, 3, 1.892, "up down", s330],
["ACKNACK", "unicast", 188, 1, 0, 4, "up down", s330],
[s347, "unicast", 191.3, 1, 3, 0.45, "up down", s330],
[s348, "unicast", 188.5, 1, 0, 15.6, "up down", s330],
["Gap", "unicast", s349, 0.6838, 3, 0.645, "up down", s330],
[s350, "unicast", 192, 1, 0, 1, "up down", s330],
[s351, "unicast", 192, 1, 0, 2, "up down", s330],
s352,
[s353, "unicast", 188, 1, 0, 2, "up down", s330],
[s354, "unicast", 188, 1, 0, 2, "up down", s330],
s355,
s356,
s357,
],
},
"Fast DDS": {
"group": s2,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s88, s118, "", s120, "Fast DDS", s88],
[s101, s122, "", s123, "Fast DDS", s101],
[s90, s125, "", s126, "Fast DDS", s90],
[s100, s100, "", s100, "Fast DDS", s100],
["peers", s309, "", s130, "Fast DDS", s310],
[s95, s311, "", s133, "Fast DDS", s312],
["router", s168, "", "Zenoh router", "Fast DDS", s169],
[s97, s170, "", s152, "Fast DDS", s171],
[s99, s172, "", s155, "Fast DDS", s173],
["announcements", s174, "", "Fast DDS, a longer announcement interval", "Fast DDS", "announcements"],
["middleware", s227, "", "Cyclone DDS", "Fast DDS", "middleware"],
["middleware", s175, "", s176, "Fast DDS", "middleware"],
["middleware", s178, "", s149, "Fast DDS", "middleware"],
],
"about": s361,
"color": s313,
"measured": [8, 12, 60],
"band": s362,
"reboot": [1.21, 1.71],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s314,
"windows": s315,
"units": s365,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s325],
[s366, "multicast", 580, 1, 1, 1, "up down", s330],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s369],
[s370, "unicast", 580, 1, 2, 1, "up down", s330],
[s371, "unicast", 580, 1, 3, 0.5, "up down", s330],
["SEDP", "unicast", s372, 0.6, 4, 1, "up down", s330],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s330],
[s197, "unicast", 184.3, 1, 2, 1.65, "up down", s330],
[s373, "unicast", 184.3, 1, 3, 0.4252, "up down", s330],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s330],
[s374, "unicast", 189.4, 1, 2, 2.072, "up down", s330],
[s199, "unicast", 189.4, 1, 3, 0.2616, "up down", s330],
[s206, "unicast", 192, 1, 2, 1.148, "up down", s330],
[s211, "unicast", 188, 1, 2, 1.148, "up down", s330],
[s221, "unicast", 192, 1, 5, 1.4, "up down", s330],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s330],
],
},
"hybrid": {
"group": s6,
"family": null,
"product": null,
"tables": [],
"about": "this book's proposal, for hosts with unlike software",
"color": s375,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s376,
"windows": s377,
"units": [s379, s141, s318, s381, s270],
"degree": 2,
"messages": [s383, s384, s385, s386, s387, s389, s390],
},
"hybrid, alike": {
"group": s6,
"family": null,
"product": null,
"tables": [],
"about": "this book's proposal, for hosts that are alike",
"color": s375,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s376,
"windows": s377,
"units": [s379, s141, [s391, s391, s391], s381, s270],
"degree": 2,
"messages": [s383, s384, ["Software", "multicast", 8, 0, 0, 1, "up down", s382], s385, s386, s387, s389, s390],
},
"DDS, periods of Fast DDS": {
"group": s5,
"family": "DDS",
"product": null,
"tables": [s121, s124, s127, s128, s131, s134, ["middleware", s392, "", s393, s394, "middleware"], ["middleware", s395, "", s396, s394, "middleware"]],
"about": "",
"color": s313,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s314,
"windows": s315,
"units": s158,
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s325], ["UnicastSPDP", "unicast", 414, 1, 1, 1, "up down", s325], ["SEDP", "unicast", 464, 1, 2, 1, "up down", s330], ["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s330], ["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s330]],
},
"DDS, periods of Cyclone DDS": {
"group": s5,
"family": "DDS",
"product": null,
"tables": [s121, s124, s127, s128, s131, s134, ["middleware", s397, "", s394, s393, "middleware"], ["middleware", s395, "", s396, s393, "middleware"]],
"about": "",
"color": s180,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s158,
"degree": 2,
"messages": [
["SPDP", "multicast", 414, 1, 0, 1, "up down", s191],
["DirectedSPDP", "unicast", 414, 1, 1, 1, "up down", s193],
["SEDP", "unicast", 464, 1, 2, 1, "up down", s195],
["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s195],
["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s195],
["Liveliness", "unicast", 180, 1, 1, 1, "up down", s273],
["LivelinessACK", "unicast", 114, 1, 1, 1, "up down", s273],
],
},
"Zenoh, periods of Zenoh peer": {
"group": s5,
"family": "Zenoh",
"product": null,
"tables": [s150, s153, s156, ["peers", "static peers", "", "Zenoh, periods of Zenoh peer, static peers", s396, "peers"], ["middleware", s397, "", s394, s396, "middleware"], ["middleware", s392, "", s393, s396, "middleware"]],
"about": "",
"color": s398,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s158,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s399], ["Hello", "unicast", 144, 1, 1, 1, "up down", s399], ["Declare", "unicast", 176, 1, 2, 1, "up down", s195], s401],
},
"static endpoints": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": [
[s88, s118, "", s120, s100, s88],
[s101, s122, "", s123, s100, s101],
[s90, s125, "", s126, s100, s90],
["peers", s309, "", s130, s100, s310],
[s95, s311, "", s133, s100, s312],
["router", s168, "", "Zenoh router", s100, s169],
[s97, s170, "", s152, s100, s171],
[s99, s172, "", s155, s100, s173],
["announcements", s174, "", "static endpoints, a longer announcement interval", s100, "announcements"],
["middleware", s227, "", "Cyclone DDS", s100, "middleware"],
["middleware", s175, "", s176, s100, "middleware"],
["middleware", s177, "", "Fast DDS", s100, "middleware"],
["middleware", s178, "", s149, s100, "middleware"],
],
"about": s402,
"color": s313,
"measured": [8, 8, 84],
"band": s403,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s314,
"windows": s315,
"units": s407,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s325],
[s366, "multicast", 589.2, 1, 1, 1, "up down", s330],
[s408, "multicast", 589.2, 1, 2, 1, "up down", s330],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s369],
[s370, "unicast", 589.2, 1, 3, 1, "up down", s330],
[s371, "unicast", 589.2, 1, 4, 0.5, "up down", s330],
[s409, "unicast", 589.2, 1, 5, 0.6542, "up down", s330],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s369],
[s410, "multicast", 59.47, 0, 6, 0.8987, "up down", s330],
[s411, "multicast", 59.47, 0, 7, 0.8987, "up down", s330],
[s412, "unicast", 59.47, 0, 5, 1, "up down", s369],
[s413, "unicast", 59.47, 0, 5, 0.9528, "up down", s330],
[s414, "unicast", 59.47, 0, 8, 0.4764, "up down", s330],
[s415, "unicast", 59.47, 0, 9, 0.6233, "up down", s330],
[s206, "unicast", 192, 1, 3, 1.167, "up down", s330],
[s211, "unicast", 188, 1, 3, 1.167, "up down", s330],
[s221, "unicast", 192, 1, 10, 1.33, "up down", s330],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s330],
],
},
"Zenoh peer": {
"group": s2,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s88, s160, "", s120, "Zenoh peer", s161],
[s101, s162, "", s123, "Zenoh peer", s163],
[s90, s164, "", s126, "Zenoh peer", s165],
[s100, s166, "", s100, "Zenoh peer", s167],
["peers", s309, "", s130, "Zenoh peer", s310],
[s95, s311, "", s133, "Zenoh peer", s312],
s150,
s153,
s156,
["peers", "static peers", "", "Zenoh peer, static peers", "Zenoh peer", "peers"],
["middleware", s227, "", "Cyclone DDS", "Zenoh peer", "middleware"],
["middleware", s175, "", s176, "Zenoh peer", "middleware"],
["middleware", s177, "", "Fast DDS", "Zenoh peer", "middleware"],
["middleware", s178, "", s149, "Zenoh peer", "middleware"],
],
"about": s416,
"color": s398,
"measured": [8, 12, 60],
"band": s417,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s419,
"degree": 3,
"messages": [
s420,
s421,
["Hello first", "unicast", 104, 1, 1, 0.5833, "up down", s195],
["InitSyn", "unicast", 110, 1, 1, 0.6667, "up down", s195],
s422,
s423,
s424,
["OAM", "unicast", s425, 0.835, 1, 1, "up down", s195],
[s426, "unicast", s425, 0.835, 2, 0.625, "up down", s195],
["Declare", "unicast", s427, 0.1957, 3, 0.5, "up down", s195],
[s428, "unicast", s429, 0.8037, 4, 0.5, "up down", s195],
[s430, "unicast", s429, 0.8037, 5, 0.5, "up down", s195],
["Declare final", "unicast", 176, 0.05, 1, 1, "up down", s195],
["Frame", "unicast", s431, 0.2478, 1, 1, "up down", s195],
[s432, "unicast", s431, 0.2478, 3, 0.6083, "up down", s195],
s433,
s434,
["TCP ACK", "unicast", 76, 1, 1, 0.8708, "up down", s400],
[s435, "unicast", 76, 1, 1, 2.496, "up down", s195],
[s436, "unicast", 76, 1, 3, 0.2188, "up down", s195],
],
},
"Zenoh peer, tokens": {
"group": s2,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s88, s160, "", s120, s149, s161],
[s101, s162, "", s123, s149, s163],
[s90, s164, "", s126, s149, s165],
[s100, s166, "", s100, s149, s167],
["peers", s309, "", s130, s149, s310],
[s95, s311, "", s133, s149, s312],
["router", s147, "", "Zenoh router", s149, "router"],
[s97, s151, "", s152, s149, s97],
[s99, s154, "", s155, s149, s99],
["peers", "static peers", "", "Zenoh peer, tokens, static peers", s149, "peers"],
["middleware", s227, "", "Cyclone DDS", s149, "middleware"],
["middleware", s175, "", s176, s149, "middleware"],
["middleware", s177, "", "Fast DDS", s149, "middleware"],
],
"about": s437,
"color": s398,
"measured": [8, 12, 60],
"band": s438,
"reboot": [0.896, 1.43],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s419,
"degree": 3,
"messages": [
s420,
s421,
["Hello first", "unicast", 104, 1, 1, 0.5, "up down", s195],
["InitSyn", "unicast", 109.86, 1, 1, 0.6667, "up down", s195],
s422,
s423,
s424,
["OAM", "unicast", s439, 0.7058, 1, 1, "up down", s195],
[s426, "unicast", s439, 0.7058, 2, 0.6493, "up down", s195],
["Declare", "unicast", s440, 0.0655, 3, 0.5, "up down", s195],
["Declare token", "unicast", s441, 0.0603, 3, 1, "up down", s195],
[s442, "unicast", s441, 0.0603, 1, 1, "up down", s195],
[s428, "unicast", s443, 0.5972, 4, 1.5, "up down", s195],
[s430, "unicast", s443, 0.5972, 5, 2.5, "up down", s195],
[s444, "unicast", s443, 0.5972, 1, 1, "up down", s195],
["Declare final", "unicast", s445, 0.06, 1, 1, "up down", s195],
["Frame", "unicast", s446, 0.1352, 1, 2, "up down", s195],
[s432, "unicast", s446, 0.1352, 3, 1, "up down", s195],
s433,
s434,
["TCP ACK", "unicast", 76, 1, 1, 0.7208, "up down", s400],
[s435, "unicast", 76, 1, 1, 3.325, "up down", s195],
[s436, "unicast", 76, 1, 3, 0.4208, "up down", s195],
],
},
"Zenoh router": {
"group": s3,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s88, s160, "", s120, "Zenoh router", s161],
[s101, s162, "", s123, "Zenoh router", s163],
[s90, s164, "", s126, "Zenoh router", s165],
[s100, s166, "", s100, "Zenoh router", s167],
["peers", s309, "", s130, "Zenoh router", s310],
[s95, s311, "", s133, "Zenoh router", s312],
[s97, s151, "", s152, "Zenoh router", s97],
[s99, s154, "", s155, "Zenoh router", s99],
["middleware", s227, "", "Cyclone DDS", "Zenoh router", "middleware"],
["middleware", s175, "", s176, "Zenoh router", "middleware"],
["middleware", s177, "", "Fast DDS", "Zenoh router", "middleware"],
["middleware", s178, "", s149, "Zenoh router", "middleware"],
],
"about": "one router, wired to the access point, and every process its client, with liveliness tokens, as rmw_zenoh has them (measured with 1.10.2)",
"color": s447,
"measured": [8, 12, 10],
"band": [[1, 1, 1, "In 7 swarms within that range that we did not fit, discovery took 0.84 to 1.18 times the airtime of the model (typical error 10%)"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s448,
"windows": s449,
"units": [s141, s318, s450, [s188, {"count": "count30", "more": ["more69", "more70"]}, {"count": "count31", "more": ["more71", "more72"]}], s364, s404],
"degree": 2,
"messages": [
["TCP SYN", "unicast", 76, 1, 0, 1, "up", s451],
["TCP SYN-ACK", "unicast", 76, 1, 0, 1, "down", s451],
s452,
s453,
s454,
s455,
["Interest in tokens", "unicast", s456, 0.08917, 0, 1, "up", s451],
["Interest of publishers", "unicast", s456, 0.08917, 1, 0.5, "up", s451],
["Declare", "unicast", 144.9655172413793, 0.087, 1, 0.5, "up", s451],
[s442, "unicast", s457, 0.05144, 0, 1, "up", s451],
["Declare token", "unicast", s457, 0.05144, 1, 1, "up", s451],
[s444, "unicast", s458, 0.5213, 0, 2, "up", s451],
[s428, "unicast", s458, 0.5213, 1, 1.5, "up", s451],
["Declare key expression of unmatched", "unicast", s458, 0.5213, 2, 0.5, "up", s451],
["Frame up", "unicast", s459, 0.1456, 0, 1.417, "up", s451],
["Frame of endpoints up", "unicast", s459, 0.1456, 1, 1.292, "up", s451],
["Declare passed on", "unicast", 125.74016332590944, 0.1347, 3, 1, "down", s451],
["Declare token of own node", "unicast", s460, 0.0309, 0, 1, "down", s451],
["Declare own token", "unicast", s460, 0.0309, 1, 1, "down", s451],
["Declare token of node passed on", "unicast", s460, 0.0309, 4, 1, "down", s451],
["Declare token passed on", "unicast", s460, 0.0309, 5, 1, "down", s451],
["Declare key expression of node passed on", "unicast", s461, 0.3319, 4, 1, "down", s451],
["Declare key expression passed on", "unicast", s461, 0.3319, 5, 1, "down", s451],
["Declare final", "unicast", s462, 0.06875, 0, 1, "down", s451],
["Declare final to publishers", "unicast", s462, 0.06875, 1, 0.5, "down", s451],
["Frame down", "unicast", s463, 0.1116, 0, 3.188, "down", s451],
["Frame of endpoints down", "unicast", s463, 0.1116, 1, 1.206, "down", s451],
["Frame of others down", "unicast", s463, 0.1116, 5, 0.025, "down", s451],
["KeepAlive up", "unicast", 79, 1, 0, 1, "up", s465],
s466,
["TCP ACK up", "unicast", 76, 1, 0, 1, "up", s465],
["TCP ACK down", "unicast", 76, 1, 0, 0.5, "down", s465],
["TCP ACK at start up", "unicast", 76, 1, 0, 1.761, "up", s451],
["TCP ACK of endpoints up", "unicast", 76, 1, 1, 0.5636, "up", s451],
["TCP ACK of others up", "unicast", 76, 1, 4, 0.7871, "up", s451],
[s467, "unicast", 76, 1, 0, 4.104, "down", s451],
[s468, "unicast", 76, 1, 1, 0.07292, "down", s451],
],
},
"Zenoh router per host": {
"group": s3,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s88, s160, "", s120, s152, s161],
[s101, s162, "", s123, s152, s163],
[s90, s164, "", s126, s152, s165],
[s100, s166, "", s100, s152, s167],
["peers", s309, "", s130, s152, s310],
[s95, s311, "", s133, s152, s312],
["router", s147, "", "Zenoh router", s152, "router"],
[s99, s154, "", s155, s152, s99],
["middleware", s227, "", "Cyclone DDS", s152, "middleware"],
["middleware", s175, "", s176, s152, "middleware"],
["middleware", s177, "", "Fast DDS", s152, "middleware"],
["middleware", s178, "", s149, s152, "middleware"],
],
"about": "a router on each host, as rmw_zenoh has it, linked with all others; processes meet their own host's on loopback (measured with 1.10.2)",
"color": s447,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 11 swarms within that range that we did not fit, discovery took 0.84 to 1.25 times the airtime of the model (typical error 2%)"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s448,
"windows": s449,
"units": [s270, [s469, s469, s469], [s470, s470, s470], s472, s473, s474, s268],
"degree": 4,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up down", s451],
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s451],
["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s451],
["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s451],
["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s451],
["OAM", "unicast", s475, 0.04144, 0, 2, "up down", s451],
["OAM of third hosts", "unicast", s476, 0.03176, 1, 0.3843, "up down", s451],
["OAM passed on", "unicast", s476, 0.03176, 2, 0.4715, "up down", s451],
[s477, "unicast", s478, 0.8637, 0, 4.25, "up down", s451],
["Frame of gossip passed on", "unicast", s478, 0.8637, 1, 1.6, "up down", s451],
[s432, "unicast", s478, 0.8637, 3, 0.775, "up down", s451],
["Declare", "unicast", s475, 0.004144, 4, 0.5, "up down", s451],
[s479, "unicast", s475, 0.004144, 5, 0.5, "up down", s451],
[s442, "unicast", s475, 0.004144, 6, 1, "up down", s451],
["Declare token", "unicast", s475, 0.004144, 3, 1, "up down", s451],
[s428, "unicast", s480, 0.1138, 4, 0.5, "up down", s451],
[s430, "unicast", s480, 0.1138, 5, 0.2634, "up down", s451],
[s481, "unicast", s480, 0.1138, 3, 1, "up down", s451],
[s444, "unicast", s480, 0.1138, 6, 1, "up down", s451],
["KeepAlive", "unicast", 79, 1, 0, 1, "up down", s465],
["TCP ACK", "unicast", 76, 1, 0, 0.55, "up down", s465],
[s435, "unicast", 76, 1, 0, 6.597, "up down", s451],
["TCP ACK of gossip", "unicast", 76, 1, 1, 0.2278, "up down", s451],
[s436, "unicast", 76, 1, 3, 0.1124, "up down", s451],
],
},
"Zenoh router per host, star": {
"group": s3,
"family": "Zenoh",
"product": "Zenoh",
"tables": [
[s88, s160, "", s120, s155, s161],
[s101, s162, "", s123, s155, s163],
[s90, s164, "", s126, s155, s165],
[s100, s166, "", s100, s155, s167],
["peers", s309, "", s130, s155, s310],
[s95, s311, "", s133, s155, s312],
["router", s147, "", "Zenoh router", s155, "router"],
[s97, s151, "", s152, s155, s97],
["middleware", s227, "", "Cyclone DDS", s155, "middleware"],
["middleware", s175, "", s176, s155, "middleware"],
["middleware", s177, "", "Fast DDS", s155, "middleware"],
["middleware", s178, "", s149, s155, "middleware"],
],
"about": "a router on each host, as rmw_zenoh has it, linked with one router that is wired to the access point; processes meet their own host's on loopback (measured with 1.10.2)",
"color": s447,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 6 swarms within that range that we did not fit, discovery took 0.85 to 1.18 times the airtime of the model (typical error 15%)"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s448,
"windows": s449,
"units": [s379, s270, s318, s450, [s188, {"count": "count38", "more": ["more90", "more86"]}, {"count": "count39", "more": ["more91", "more89"]}], s141, s268, s473, s474, s472, s381],
"degree": 2,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up", s451],
["TCP control down", "unicast", 76, 1, 0, 1, "down", s451],
s452,
s453,
s454,
s455,
["OAM", "unicast", s482, 0.03601, 0, 2, "up", s451],
["OAM of others", "unicast", s482, 0.03601, 1, 1.045, "up", s451],
[s477, "unicast", s483, 0.8894, 0, 12.18, "up", s451],
[s432, "unicast", s483, 0.8894, 2, 0.4077, "up", s451],
["Declare", "unicast", s475, 0.004144, 3, 0.5, "up", s451],
[s479, "unicast", s475, 0.004144, 4, 0.5, "up", s451],
[s442, "unicast", s475, 0.004144, 5, 1, "up", s451],
["Declare token", "unicast", s475, 0.004144, 2, 1, "up", s451],
[s428, "unicast", s484, 0.1159, 3, 0.5, "up", s451],
[s430, "unicast", s484, 0.1159, 4, 0.1042, "up", s451],
[s481, "unicast", s484, 0.1159, 2, 1, "up", s451],
[s444, "unicast", s484, 0.1159, 5, 1, "up", s451],
["KeepAlive", "unicast", 79, 1, 0, 1, "up", s465],
["TCP ACK", "unicast", 76, 1, 0, 1, "up", s465],
[s435, "unicast", 76, 1, 0, 3.783, "up", s451],
["TCP ACK of processes", "unicast", 76, 1, 6, 1.217, "up", s451],
["OAM down", "unicast", s485, 0.04874, 0, 2, "down", s451],
["OAM of others down", "unicast", s485, 0.04874, 1, 1.045, "down", s451],
["Frame of gossip down", "unicast", 87.23315027458811, 0.8012, 0, 26.88, "down", s451],
["Declare down", "unicast", s486, 0.005525, 7, 0.5, "down", s451],
["Declare of matching down", "unicast", s486, 0.005525, 8, 0.5, "down", s451],
["Declare token of node down", "unicast", s486, 0.005525, 6, 1, "down", s451],
["Declare token down", "unicast", s486, 0.005525, 9, 1, "down", s451],
["Declare key expression down", "unicast", s484, 0.1159, 7, 0.5, "down", s451],
["Declare key expression of matching down", "unicast", s484, 0.1159, 8, 0.0625, "down", s451],
["Declare key expression of tokens down", "unicast", s484, 0.1159, 9, 1, "down", s451],
["Declare key expression of node down", "unicast", s484, 0.1159, 6, 1, "down", s451],
s466,
["TCP ACK down", "unicast", 76, 1, 10, 1, "down", s465],
[s467, "unicast", 76, 1, 0, 4.958, "down", s451],
[s468, "unicast", 76, 1, 2, 0.1354, "down", s451],
],
},
"Zenoh, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": [],
"about": "",
"color": s157,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s138,
"windows": s139,
"units": s487,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s146], s159],
},
"Cyclone DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s179,
"color": s180,
"measured": [8, 12, 60],
"band": s181,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s488,
"windows": s489,
"units": s190,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s490],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s491],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s492],
["SEDP", "unicast", s194, 0.2218, 2, 1, "up down", s493],
["SEDP again", "unicast", s194, 0.2218, 3, 0.103, "up down", s493],
["Heartbeat", "unicast", s196, 0.5226, 1, 2, "up down", s493],
[s197, "unicast", s196, 0.5226, 1, 2.481, "up down", s493],
["ACKNACK", "unicast", s198, 0.402, 1, 4.635, "up down", s493],
[s199, "unicast", s198, 0.402, 4, 0.09896, "up down", s493],
s496,
[s203, "unicast", s204, 0.6253, 1, 1, "up down", s493],
[s205, "unicast", s204, 0.6253, 4, 0.1067, "up down", s493],
s497,
[s209, "unicast", s210, 0.4544, 1, 2.222, "up down", s493],
s498,
[s213, "unicast", s214, 0.3044, 1, 2.312, "up down", s493],
[s215, "unicast", s214, 0.3044, 4, 0.05208, "up down", s493],
[s216, "unicast", s217, 0.6806, 1, 2.333, "up down", s493],
[s218, "unicast", s219, 0.2641, 1, 2, "up down", s493],
[s220, "unicast", s219, 0.2641, 4, 0.2188, "up down", s493],
[s221, "unicast", s222, 0.6247, 5, 1.006, "up down", s493],
[s223, "unicast", s222, 0.6247, 6, 0.07217, "up down", s493],
["User ACKNACK", "unicast", s224, 0.338, 5, 1.404, "up down", s493],
[s225, "unicast", s224, 0.338, 6, 0.09793, "up down", s493],
],
},
"Cyclone DDS, wired, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s228,
"color": s180,
"measured": [8, 12, 20],
"band": s229,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s488,
"windows": s489,
"units": s230,
"degree": 3,
"messages": [
s499,
["SPDP directed", "unicast", s232, 0.9963, 1, 0.6667, "up down", s492],
["SEDP", "unicast", s233, 0.1841, 2, 0.5833, "up down", s493],
[s234, "multicast", s235, 0.2228, 2, 0.1667, "up down", s493],
[s236, "multicast", 232, 0.25, 0, 2, "up down", s493],
["Heartbeat", "unicast", s237, 0.3287, 1, 3, "up down", s493],
["ACKNACK", "unicast", s238, 0.3715, 1, 4.05, "up down", s493],
[s199, "unicast", s238, 0.3715, 3, 0.2833, "up down", s493],
["Liveliness", "multicast", s200, 0.7242, 0, 1, "up down", s495],
[s203, "multicast", s239, 0.9582, 0, 0.3333, "up down", s493],
[s240, "unicast", 429, 0.2, 1, 0.5, "up down", s493],
[s206, "multicast", s207, 0.2758, 0, 1, "up down", s495],
[s209, "multicast", s241, 0.1767, 0, 0.875, "up down", s493],
[s242, "unicast", s243, 0.2117, 1, 1.625, "up down", s493],
s498,
[s213, "unicast", s244, 0.2807, 1, 2.344, "up down", s493],
[s215, "unicast", s244, 0.2807, 3, 0.07812, "up down", s493],
[s216, "multicast", s245, 0.1988, 0, 2, "up down", s493],
[s246, "unicast", s247, 0.1917, 1, 0.6667, "up down", s493],
[s218, "unicast", 211.5, 0.2, 1, 2, "up down", s493],
[s220, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s493],
[s221, "unicast", s248, 0.2427, 4, 0.75, "up down", s493],
[s249, "multicast", s250, 0.2152, 4, 0.25, "up down", s493],
["User ACKNACK", "unicast", s251, 0.2283, 4, 2, "up down", s493],
],
},
"Cyclone DDS, version 11, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s252,
"color": s180,
"measured": [8, 12, 60],
"band": s253,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s488,
"windows": s489,
"units": s190,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s490],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s491],
["SPDP directed", "unicast", s254, 0.9992, 1, 0.5413, "up down", s492],
["SEDP", "unicast", s255, 0.4598, 2, 1, "up down", s493],
["SEDP again", "unicast", s255, 0.4598, 3, 0.09093, "up down", s493],
["Heartbeat", "unicast", s256, 0.5475, 1, 2, "up down", s493],
[s197, "unicast", s256, 0.5475, 1, 2.833, "up down", s493],
["ACKNACK", "unicast", s257, 0.3982, 1, 5.167, "up down", s493],
[s199, "unicast", s257, 0.3982, 4, 0.125, "up down", s493],
s496,
[s203, "unicast", s258, 0.6519, 1, 1, "up down", s493],
[s205, "unicast", s258, 0.6519, 4, 0.09103, "up down", s493],
s497,
[s209, "unicast", s259, 0.4401, 1, 2.188, "up down", s493],
s498,
[s213, "unicast", s260, 0.2753, 1, 2.278, "up down", s493],
[s215, "unicast", s260, 0.2753, 4, 0.05556, "up down", s493],
[s216, "unicast", s261, 0.6399, 1, 2.542, "up down", s493],
[s218, "unicast", s262, 0.2385, 1, 2, "up down", s493],
[s220, "unicast", s262, 0.2385, 4, 0.1997, "up down", s493],
[s221, "unicast", s263, 0.6975, 5, 1.06, "up down", s493],
[s223, "unicast", s263, 0.6975, 6, 0.06995, "up down", s493],
["User ACKNACK", "unicast", s264, 0.4362, 5, 1.562, "up down", s493],
[s225, "unicast", s264, 0.4362, 6, 0.09399, "up down", s493],
],
},
"Cyclone DDS peers, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s265,
"color": s180,
"measured": [8, 12, 10],
"band": s266,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s488,
"windows": s489,
"units": s271,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s490],
[s272, "unicast", 448, 1, 1, 6, "up down", {"burst": 1, "second": 1.125, "lease": 0.135, "ever": 0.125}],
["SPDP directed", "unicast", s274, 0.9817, 2, 0.8333, "up down", s492],
["SEDP", "unicast", s275, 0.172, 3, 1, "up down", s493],
["SEDP again", "unicast", s276, 0.8001, 4, 0.08633, "up down", s493],
["Heartbeat", "unicast", s277, 0.5756, 2, 2, "up down", s493],
[s197, "unicast", s277, 0.5756, 2, 2.944, "up down", s493],
["ACKNACK", "unicast", s278, 0.3827, 2, 4.424, "up down", s493],
[s199, "unicast", s278, 0.3827, 5, 0.2049, "up down", s493],
["Liveliness", "unicast", s279, 0.7241, 2, 1, "up down", s495],
[s203, "unicast", s280, 0.7527, 2, 1, "up down", s493],
[s205, "unicast", s280, 0.7527, 5, 0.08333, "up down", s493],
[s206, "unicast", s281, 0.2759, 2, 1, "up down", s495],
[s209, "unicast", s282, 0.4258, 2, 2.556, "up down", s493],
[s211, "unicast", 128, 1, 2, 1, "up down", s495],
[s213, "unicast", s283, 0.265, 2, 2.296, "up down", s493],
[s215, "unicast", s283, 0.265, 5, 0.09271, "up down", s493],
[s216, "unicast", s284, 0.6431, 2, 3, "up down", s493],
[s218, "unicast", s285, 0.283, 2, 2, "up down", s493],
[s220, "unicast", s285, 0.283, 5, 0.3631, "up down", s493],
[s221, "unicast", s286, 0.5405, 6, 1.542, "up down", s493],
["User ACKNACK", "unicast", s287, 0.437, 6, 2.208, "up down", s493],
],
},
"Cyclone DDS multicast SEDP, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": [],
"about": s288,
"color": s180,
"measured": [8, 12, 10],
"band": s289,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s488,
"windows": s489,
"units": s230,
"degree": 3,
"messages": [
s499,
["SPDP directed", "unicast", s290, 0.9988, 1, 0.8, "up down", s492],
["SEDP", "unicast", s291, 0.2085, 2, 0.3719, "up down", s493],
[s234, "multicast", s292, 0.2222, 2, 0.23, "up down", s493],
[s236, "multicast", s293, 0.28, 0, 1.833, "up down", s493],
["Heartbeat", "unicast", s294, 0.3143, 1, 3.333, "up down", s493],
["ACKNACK", "unicast", s295, 0.3558, 1, 4.517, "up down", s493],
[s199, "unicast", s295, 0.3558, 3, 0.1494, "up down", s493],
["Liveliness", "multicast", s296, 0.724, 0, 1, "up down", s495],
[s203, "multicast", s297, 0.9539, 0, 0.8333, "up down", s493],
[s240, "unicast", s298, 0.15, 1, 0.5, "up down", s493],
[s206, "multicast", s299, 0.276, 0, 1, "up down", s495],
[s209, "multicast", s300, 0.2328, 0, 1, "up down", s493],
[s242, "unicast", s301, 0.2318, 1, 1.75, "up down", s493],
s498,
[s213, "unicast", s302, 0.2856, 1, 2.379, "up down", s493],
[s215, "unicast", s302, 0.2856, 3, 0.08854, "up down", s493],
[s216, "multicast", s303, 0.2325, 0, 2, "up down", s493],
[s246, "unicast", s304, 0.1726, 1, 1.167, "up down", s493],
[s218, "unicast", s305, 0.2088, 1, 2, "up down", s493],
[s220, "unicast", s305, 0.2088, 3, 0.3274, "up down", s493],
[s221, "unicast", s306, 0.4167, 4, 0.7917, "up down", s493],
[s249, "multicast", s307, 0.6667, 4, 0.1667, "up down", s493],
["User ACKNACK", "unicast", s308, 0.4167, 4, 2.167, "up down", s493],
],
},
"Fast DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": [],
"about": s361,
"color": s313,
"measured": [8, 12, 60],
"band": s362,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s488,
"windows": s489,
"units": s365,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s501],
[s366, "multicast", 580, 1, 1, 1, "up down", s493],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s502],
[s370, "unicast", 580, 1, 2, 1, "up down", s493],
[s371, "unicast", 580, 1, 3, 0.5, "up down", s493],
["SEDP", "unicast", s372, 0.6, 4, 1, "up down", s493],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s493],
[s197, "unicast", 184.3, 1, 2, 1.65, "up down", s493],
[s373, "unicast", 184.3, 1, 3, 0.4252, "up down", s493],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s493],
[s374, "unicast", 189.4, 1, 2, 2.072, "up down", s493],
[s199, "unicast", 189.4, 1, 3, 0.2616, "up down", s493],
[s206, "unicast", 192, 1, 2, 1.148, "up down", s493],
[s211, "unicast", 188, 1, 2, 1.148, "up down", s493],
[s221, "unicast", 192, 1, 5, 1.4, "up down", s493],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s493],
],
},
"Zenoh, periods of Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": [],
"about": "",
"color": s398,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s487,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s195], s401],
},
"static endpoints, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": [],
"about": s402,
"color": s313,
"measured": [8, 8, 84],
"band": s403,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s488,
"windows": s489,
"units": s407,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s501],
[s366, "multicast", 589.2, 1, 1, 1, "up down", s493],
[s408, "multicast", 589.2, 1, 2, 1, "up down", s493],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s502],
[s370, "unicast", 589.2, 1, 3, 1, "up down", s493],
[s371, "unicast", 589.2, 1, 4, 0.5, "up down", s493],
[s409, "unicast", 589.2, 1, 5, 0.6542, "up down", s493],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s503],
[s410, "multicast", 59.47, 0, 6, 0.8987, "up down", s493],
[s411, "multicast", 59.47, 0, 7, 0.8987, "up down", s493],
[s412, "unicast", 59.47, 0, 5, 1, "up down", s503],
[s413, "unicast", 59.47, 0, 5, 0.9528, "up down", s493],
[s414, "unicast", 59.47, 0, 8, 0.4764, "up down", s493],
[s415, "unicast", 59.47, 0, 9, 0.6233, "up down", s493],
[s206, "unicast", 192, 1, 3, 1.167, "up down", s493],
[s211, "unicast", 188, 1, 3, 1.167, "up down", s493],
[s221, "unicast", 192, 1, 10, 1.33, "up down", s493],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s493],
],
},
"Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": [],
"about": s416,
"color": s398,
"measured": [8, 12, 60],
"band": s417,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s504,
"degree": 3,
"messages": [
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s195],
s505,
s506,
s507,
["OAM", "unicast", s425, 0.835, 0, 1, "up down", s195],
[s426, "unicast", s425, 0.835, 1, 0.625, "up down", s195],
["Declare", "unicast", s427, 0.1957, 2, 0.5, "up down", s195],
[s428, "unicast", s429, 0.8037, 3, 0.5, "up down", s195],
[s430, "unicast", s429, 0.8037, 4, 0.5, "up down", s195],
["Declare final", "unicast", 176, 0.05, 0, 1, "up down", s195],
["Frame", "unicast", s431, 0.2478, 0, 1, "up down", s195],
[s432, "unicast", s431, 0.2478, 2, 0.6083, "up down", s195],
s509,
s510,
["TCP ACK", "unicast", 76, 1, 0, 0.6530673466326684, "up down", s400],
[s435, "unicast", 76, 1, 0, 2.496, "up down", s195],
[s436, "unicast", 76, 1, 2, 0.2188, "up down", s195],
],
},
"Zenoh peer, tokens, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": [],
"about": s437,
"color": s398,
"measured": [8, 12, 60],
"band": s438,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s182,
"windows": s183,
"units": s504,
"degree": 3,
"messages": [
["InitSyn", "unicast", 109.86, 1, 0, 0.5, "up down", s195],
s505,
s506,
s507,
["OAM", "unicast", s439, 0.7058, 0, 1, "up down", s195],
[s426, "unicast", s439, 0.7058, 1, 0.6493, "up down", s195],
["Declare", "unicast", s440, 0.0655, 2, 0.5, "up down", s195],
["Declare token", "unicast", s441, 0.0603, 2, 1, "up down", s195],
[s442, "unicast", s441, 0.0603, 0, 1, "up down", s195],
[s428, "unicast", s443, 0.5972, 3, 1.5, "up down", s195],
[s430, "unicast", s443, 0.5972, 4, 2.5, "up down", s195],
[s444, "unicast", s443, 0.5972, 0, 1, "up down", s195],
["Declare final", "unicast", s445, 0.06, 0, 1, "up down", s195],
["Frame", "unicast", s446, 0.1352, 0, 2, "up down", s195],
[s432, "unicast", s446, 0.1352, 2, 1, "up down", s195],
s509,
s510,
["TCP ACK", "unicast", 76, 1, 0, 0.5405729713514325, "up down", s400],
[s435, "unicast", 76, 1, 0, 3.325, "up down", s195],
[s436, "unicast", 76, 1, 2, 0.4208, "up down", s195],
],
},
},
};
})();
