// Made from the package by `make calculator` with sympy 1.14.0; do not edit.
const DISCOSTORM = (() => {
const s1 = "Nav2 in one process";
const s2 = "Cyclone DDS, version 11";
const s3 = "Cyclone DDS 11";
const s4 = "Products as built";
const s5 = "Products with mitigations";
const s6 = "As the paper counts";
const s7 = "The paper's messages, a product's periods";
const s8 = "Proposals and other tables";
const s9 = "a whole number of at least 1 and at most 1,000,000,000";
const s10 = "a number of at least 0 and at most 1,000,000,000";
const s11 = "a number above 0";
const s12 = "a number of at least 0";
const s13 = "paper (802.11n)";
const s14 = "multicast rate";
const s15 = "sending multicast at 24 instead of 6 Mbit/s";
const s16 = "both values use the timing of the 802.11 standard";
const s17 = 144444444.44444445;
const s18 = {"R_uni": s17, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s19 = {"name": s13, "model": "padded", "values": s18};
const s20 = "802.11n 20 MHz 2x2, multicast 24 Mbit/s";
const s21 = {"R_uni": s17, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s22 = "another radio (802.11n 40 MHz 2x2)";
const s23 = "802.11n 40 MHz 2x2";
const s24 = {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s25 = {"name": s23, "model": "padded", "values": s24};
const s26 = "another radio (802.11ac 80 MHz 2x2)";
const s27 = "802.11ac 80 MHz 2x2";
const s28 = 866666666.6666666;
const s29 = {"R_uni": s28, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s30 = {"name": s27, "model": "padded", "values": s29};
const s31 = "another radio (802.11ax 160 MHz 2x2)";
const s32 = "802.11ax 160 MHz 2x2";
const s33 = 2401960784.3137255;
const s34 = {"R_uni": s33, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s35 = {"name": s32, "model": "padded", "values": s34};
const s36 = {
"name": "802.11n 20 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s17, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s37 = "802.11a 20 MHz 1x1";
const s38 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s39 = {"name": s37, "model": "padded", "values": s38};
const s40 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s41 = "802.11g 20 MHz 1x1";
const s42 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s43 = "sending multicast at 24 instead of 1 Mbit/s";
const s44 = {"name": s41, "model": "padded", "values": s42};
const s45 = "802.11n 20 MHz 2x2";
const s46 = {"name": s45, "model": "padded", "values": s18, "full": s36};
const s47 = {"R_uni": s17, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0};
const s48 = {
"name": "802.11n 40 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s49 = {"name": s23, "model": "padded", "values": s24, "full": s48};
const s50 = {
"name": "802.11ac 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s28, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
};
const s51 = {"name": s27, "model": "padded", "values": s29, "full": s50};
const s52 = {
"name": "802.11ax 160 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s33, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
};
const s53 = {"name": s32, "model": "padded", "values": s34, "full": s52};
const s54 = "802.11n 20 MHz 2x2, 2.4 GHz";
const s55 = {"R_uni": s17, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s56 = {
"name": "802.11n 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s17, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s57 = {"name": s54, "model": "padded", "values": s55, "full": s56};
const s58 = "802.11ax 20 MHz 2x2, 2.4 GHz";
const s59 = 286764705.88235295;
const s60 = {"R_uni": s59, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s61 = {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s59, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
};
const s62 = {"name": s58, "model": "padded", "values": s60, "full": s61};
const s63 = "802.11ax 80 MHz 2x2";
const s64 = 1200980392.1568627;
const s65 = {"R_uni": s64, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s66 = {
"name": "802.11ax 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s64, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
};
const s67 = {"name": s63, "model": "padded", "values": s65, "full": s66};
const s68 = "802.11be 80 MHz 2x2";
const s69 = 1441176470.5882354;
const s70 = {"R_uni": s69, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s71 = {
"name": "802.11be 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s69, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
};
const s72 = {"name": s68, "model": "padded", "values": s70, "full": s71};
const s73 = "802.11be 320 MHz 2x2";
const s74 = 5764705882.3529415;
const s75 = {"R_uni": s74, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s76 = {
"name": "802.11be 320 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s74, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
};
const s77 = "staggered start";
const s78 = "discovery server";
const s79 = "Fast DDS with a Discovery Server";
const s80 = "inside_unicast";
const s81 = "linear_unicast";
const s82 = "padded_unicast";
const s83 = "padded_multicast";
const s84 = "aggregated_unicast";
const s85 = "new or reconfigured radios";
const s86 = {"efforts": ["radio"], "effort": 6, "takes": s85, "best_case": true, "cost": "the full gain needs full A-MPDUs; a queue may hold too few frames for one receiver"};
const s87 = "a configuration file";
const s88 = "one more program";
const s89 = "discovery server on a robot";
const s90 = {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "parameters can no longer be set from outside a node; third-party nodes, such as Nav2's, must be rebuilt; services count as two endpoints, as in DDS"};
const s91 = "another middleware";
const s92 = {"efforts": ["switch"], "effort": 8, "takes": s91, "best_case": false, "cost": "all hosts must change together"};
const s93 = ["switch", "server"];
const s94 = "another middleware and one more program";
const s95 = "multicast endpoint data";
const s96 = ["switch", "file"];
const s97 = "another middleware and a configuration file";
const s98 = "router on each host";
const s99 = ["switch", "servers"];
const s100 = "another middleware and several more programs";
const s101 = "star of routers";
const s102 = "static endpoints";
const s103 = "two discovery servers";
const s104 = {"efforts": ["setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": "hosts too far away for this rate cannot join; no multicast or management frame may use a lower rate"};
const s105 = {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "only nodes built as components can be composed; a crash ends all composed nodes of its host"};
const s106 = {"efforts": ["radio"], "effort": 6, "takes": s85, "best_case": false, "cost": "all hosts and the access point need this radio and must be close enough for its rate"};
const s107 = {"efforts": ["upgrade"], "effort": 7, "takes": "another ROS release", "best_case": false, "cost": "all computers need the new ROS release; every package must be rebuilt and retested"};
const s108 = "several more programs";
const s109 = {"efforts": ["setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": "discovery cannot be complete before the last host starts"};
const s110 = "hostapd.conf of the access point";
const s111 = "for every process";
const s112 = "Fast DDS 2.6, 2.9, 2.14 and 3.6";
const s113 = "Cyclone DDS 0.10.2 and 11.0.1";
const s114 = "on a computer that is wired to the access point";
const s115 = "on every robot";
const s116 = {
"where": s115,
"version": s112,
"text": "# on every robot (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: run\n# in the shell or put in the service file that starts the ROS 2 processes, before they start\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\n",
};
const s117 = {
"where": "for ros2 tools",
"version": "Fast DDS 2.6, 2.14 and 3.6",
"text": "# for ros2 tools (tested with Fast DDS 2.6, 2.14 and 3.6)\n# Load: both are environment variables of ros2 and its daemon: export them in the shell of\n# the tools, then ros2 daemon stop\n# Fast DDS reads ROS_SUPER_CLIENT from 2.6.7 on (ROS 2 Humble), 2.10.3 (Iron) and 2.13.0 (Jazzy and\n# later). Older releases, such as 2.9.1, ignore it: use the profile of a SUPER_CLIENT.\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\nexport ROS_SUPER_CLIENT=TRUE\n",
};
const s118 = {
"where": "for older ros2 tools that ignore ROS_SUPER_CLIENT",
"version": "Fast DDS 2.9.1",
"text": "<!-- for older ros2 tools that ignore ROS_SUPER_CLIENT (tested with Fast DDS 2.9.1) -->\n<!-- Load: save as /etc/fast_dds_tools.xml; ros2 and its daemon run with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds_tools.xml and without ROS_DISCOVERY_SERVER; -->\n<!-- begin with ros2 daemon stop; Fast DDS 3 refuses this file -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"super_client\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SUPER_CLIENT</discoveryProtocol>\n            <discoveryServersList>\n              <RemoteServer prefix=\"44.53.00.5f.45.50.52.4f.53.49.4d.41\">\n                <metatrafficUnicastLocatorList>\n                  <locator>\n                    <udpv4>\n                      <address>192.168.1.10</address>\n                      <port>11811</port>\n                    </udpv4>\n                  </locator>\n                </metatrafficUnicastLocatorList>\n              </RemoteServer>\n            </discoveryServersList>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
};
const s119 = "on every computer";
const s120 = {
"where": s114,
"version": "Zenoh 1.10.2",
"text": "// on a computer that is wired to the access point (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s121 = {
"where": "for every process of a robot",
"version": "Zenoh 1.10.2",
"text": "// for every process of a robot (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n{\n  mode: \"peer\",\n  connect: { endpoints: [\"tcp/localhost:7447\"] },\n  listen: { endpoints: [\"tcp/localhost:0\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: {\n      target: { router: [\"router\", \"peer\"], peer: [\"router\"] },\n      autoconnect_strategy: { peer: { to_router: \"always\", to_peer: \"greater-zid\" } },\n    },\n  },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s122 = "a Discovery Server";
const s123 = "both values use the measured model of Fast DDS";
const s124 = "Fast DDS Discovery Server";
const s125 = [s78, s122, s123, s124, "Fast DDS", s78];
const s126 = "two Discovery Servers";
const s127 = "Fast DDS Discovery Server, two";
const s128 = [s103, s126, s123, s127, "Fast DDS", s103];
const s129 = "a Discovery Server on a robot";
const s130 = "Fast DDS Discovery Server, on a robot";
const s131 = [s89, s129, s123, s130, "Fast DDS", s89];
const s132 = [s102, s102, s123, s102, "Fast DDS", s102];
const s133 = "both values use the measured model of Cyclone DDS";
const s134 = "Cyclone DDS peers";
const s135 = ["peers", "static peers", s133, s134, "Cyclone DDS", "peers"];
const s136 = "multicast SEDP announcements";
const s137 = "Cyclone DDS multicast SEDP";
const s138 = [s95, s136, s133, s137, "Cyclone DDS", s95];
const s139 = {"measured": "", "range": "0.5 to 2", "hosts": "0", "seconds": "0", "low": "0.5", "high": "2"};
const s140 = [1, "within a second at best"];
const s141 = [Infinity, "leases at risk"];
const s142 = "never catches up";
const s143 = {"until": [s140, [Infinity, "slow at best"], s141], "never": s142};
const s144 = {"second": 1, "ever": Infinity};
const s145 = {"count": "count", "more": ["more", "more2"]};
const s146 = [s145, s145, s145];
const s147 = {"count": "count2", "more": ["more3", "more4", "more5"]};
const s148 = [s147, s147, s147];
const s149 = {"count": "count3", "more": ["more6", "more7", "more8"]};
const s150 = [s149, s149, s149];
const s151 = {"burst": 1, "second": 1, "ever": 0};
const s152 = "a central router";
const s153 = "both values use the measured model of Zenoh peer with tokens";
const s154 = "Zenoh peer, tokens";
const s155 = ["router", s152, s153, "Zenoh router", s154, "router"];
const s156 = "a router on each host";
const s157 = "Zenoh router per host";
const s158 = [s98, s156, s153, s157, s154, s98];
const s159 = "a router on each host plus a wired router";
const s160 = "Zenoh router per host, star";
const s161 = [s101, s159, s153, s160, s154, s101];
const s162 = "--ds-family-zenoh";
const s163 = [s146, s150, s148];
const s164 = ["KeepAlive", "unicast", 84, 1, 1, 2, "up down", s151];
const s165 = "switching to Fast DDS with a Discovery Server";
const s166 = "Fast DDS 2.14 Discovery Server";
const s167 = "middleware and discovery server";
const s168 = "switching to Fast DDS with two Discovery Servers";
const s169 = "Fast DDS 2.14 Discovery Server, two";
const s170 = "middleware and two discovery servers";
const s171 = [s89, "switching to Fast DDS with a Discovery Server on a robot", "", s130, "Cyclone DDS", "middleware and discovery server on a robot"];
const s172 = "switching to Fast DDS with static endpoints";
const s173 = "middleware and static endpoints";
const s174 = [s102, s172, "", s102, "Cyclone DDS", s173];
const s175 = ["peers", "static peers", "", s134, "Cyclone DDS", "peers"];
const s176 = [s95, s136, "", s137, "Cyclone DDS", s95];
const s177 = "switching to Zenoh with a central router";
const s178 = "middleware and router";
const s179 = ["router", s177, "", "Zenoh router", "Cyclone DDS", s178];
const s180 = "switching to Zenoh with a router on each host";
const s181 = "middleware and router on each host";
const s182 = [s98, s180, "", s157, "Cyclone DDS", s181];
const s183 = "switching to Zenoh with a router on each host plus a wired router";
const s184 = "middleware and star of routers";
const s185 = [s101, s183, "", s160, "Cyclone DDS", s184];
const s186 = "a longer announcement interval";
const s187 = ["announcements", s186, "", "Cyclone DDS, a longer announcement interval", "Cyclone DDS", "announcements"];
const s188 = "moving to ROS 2 Lyrical (Cyclone DDS, version 11)";
const s189 = ["release", s188, "", s2, "Cyclone DDS", "release"];
const s190 = "switching to Zenoh peer, tokens";
const s191 = ["middleware", s190, "", s154, "Cyclone DDS", "middleware"];
const s192 = "Fast DDS 2.6 Discovery Server";
const s193 = "Fast DDS 2.6 Discovery Server, two";
const s194 = "Fast DDS 3.6 Discovery Server";
const s195 = "Fast DDS 3.6 Discovery Server, two";
const s196 = "switching to Fast DDS 3.6";
const s197 = "on a network that it takes for Wi-Fi: multicast for SPDP alone (measured with 0.10.2)";
const s198 = "Cyclone DDS 0.10.5 took 3.6 to 6.8 times as long as simulated in an emulated Wi-Fi cell without frame aggregation, where 8 robots had done only 19% of discovery after 12 s";
const s199 = {"measured": "Cyclone DDS", "range": "0.08 to 6.76", "hosts": "8", "seconds": "12", "low": "0.08", "high": "6.76"};
const s200 = "--ds-product-cyclone-dds";
const s201 = [
[1, 1.67, 11.3, "In 24 swarms within these sizes that we left out of the fit, discovery took 0.68 to 1.26 times the predicted airtime (typical error 9%). We expect 92% of such swarms in this range"],
[2, 1.67, 11.3, "In 9 swarms of up to twice these sizes that we left out of the fit, discovery took 0.94 to 1.44 times the predicted airtime (typical error 16%). We expect 80% of such swarms in this range"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints that we left out of the fit, discovery took 1.31 to 1.47 times the predicted airtime (typical error 39%). From so few swarms, we derive no interval"],
];
const s202 = {"until": [s140, [10, "slow at best"], s141], "never": s142};
const s203 = {"second": 1, "lease": 10, "ever": Infinity};
const s204 = {"count": "count4", "more": ["more9", "more10", "more11", "more12"]};
const s205 = [s204, s204, s204];
const s206 = {"count": "count5", "more": ["more13", "more14", "more15", "more16"]};
const s207 = [s206, s206, s206];
const s208 = {"count": "count6", "more": []};
const s209 = [s208, {"count": "count7", "more": ["more17", "more18", "more19"]}, {"count": "count8", "more": ["more20", "more21", "more22"]}];
const s210 = [s146, s150, s148, s205, s207, s209, [s208, {"count": "count9", "more": ["more23", "more24", "more25", "more26"]}, {"count": "count10", "more": ["more27", "more28", "more29", "more30"]}]];
const s211 = {"burst": 1.9875, "second": 2.1125, "lease": 0.32375, "ever": 0.125};
const s212 = {"burst": 0.9875, "second": 1.1125, "lease": 0.22375, "ever": 0.125};
const s213 = {"burst": 4, "second": 4, "lease": 0.4, "ever": 0};
const s214 = 972.4761045987376;
const s215 = {"burst": 1, "second": 1, "lease": 0.1, "ever": 0};
const s216 = 154.45158821278227;
const s217 = "Heartbeat of data";
const s218 = 187.0099502487562;
const s219 = "ACKNACK for others";
const s220 = 179.99005799502902;
const s221 = {"burst": 0, "second": 0.125, "lease": 0.125, "ever": 0.125};
const s222 = ["Liveliness", "unicast", s220, 0.7242, 1, 1, "up down", s221];
const s223 = "Liveliness at start";
const s224 = 190.54725731648807;
const s225 = "Liveliness for others";
const s226 = "Liveliness Heartbeat";
const s227 = 180.02610587382162;
const s228 = [s226, "unicast", s227, 0.2758, 1, 1, "up down", s221];
const s229 = "Liveliness Heartbeat at start";
const s230 = 153.8987676056338;
const s231 = "Liveliness ACKNACK";
const s232 = [s231, "unicast", 128, 1, 1, 1, "up down", s221];
const s233 = "Liveliness ACKNACK at start";
const s234 = 181.3784494086728;
const s235 = "Liveliness ACKNACK for others";
const s236 = "Type lookup Heartbeat";
const s237 = 129.08962679988247;
const s238 = "Type lookup ACKNACK";
const s239 = 195.20030291556228;
const s240 = "Type lookup ACKNACK for others";
const s241 = "User Heartbeat";
const s242 = 139.31615175284134;
const s243 = "User Heartbeat for others";
const s244 = 182.43195266272187;
const s245 = "User ACKNACK for others";
const s246 = "the server forwards everything, as in Fast DDS 3.6";
const s247 = "Cyclone DDS, wired";
const s248 = "moving to ROS 2 Jazzy (Cyclone DDS)";
const s249 = "on a network that it takes for wired, with three processes or more: multicast for SEDP and control, too (measured with 0.10.2)";
const s250 = [[1, 1, 1, "In 7 swarms within these sizes that we left out of the fit, discovery took 0.95 to 1.13 times the predicted airtime (typical error 5%). We expect 75% of such swarms in this range"]];
const s251 = [s146, s150, s148, s207, s209];
const s252 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s211];
const s253 = 493.08762420957544;
const s254 = 1167.7479630635523;
const s255 = "SEDP multicast";
const s256 = 961.6660682226212;
const s257 = "Heartbeat multicast";
const s258 = 201.42013994523882;
const s259 = 199.39703903095557;
const s260 = 150.79816322270926;
const s261 = "Liveliness unicast";
const s262 = 245.09790605546124;
const s263 = "Liveliness Heartbeat unicast";
const s264 = 234.05196032120926;
const s265 = 187.1920199501247;
const s266 = 224.96579476861166;
const s267 = "Type lookup Heartbeat unicast";
const s268 = 230.92749087115283;
const s269 = 230.46065100947672;
const s270 = "User Heartbeat multicast";
const s271 = 232.6802973977695;
const s272 = 226.06745510293473;
const s273 = "as Cyclone DDS, with type information in SEDP (measured with 11.0.1)";
const s274 = [
[1, 1.67, 11.3, "In 26 swarms within these sizes that we left out of the fit, discovery took 0.72 to 1.32 times the predicted airtime (typical error 9%). We expect 93% of such swarms in this range"],
[2, 1.67, 11.3, "In 11 swarms of up to twice these sizes that we left out of the fit, discovery took 1.00 to 1.43 times the predicted airtime (typical error 22%). We expect 83% of such swarms in this range"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints that we left out of the fit, discovery took 1.28 to 1.48 times the predicted airtime (typical error 38%). From so few swarms, we derive no interval"],
];
const s275 = 432.2946357085669;
const s276 = 726.2444541104828;
const s277 = 153.93607305936075;
const s278 = 186.8277247614264;
const s279 = 187.05568338702255;
const s280 = 156.2517609634174;
const s281 = 190.87976752633492;
const s282 = 132.5107047976246;
const s283 = 204.12578616352204;
const s284 = 133.94982078853047;
const s285 = 167.8055937643283;
const s286 = "switching to Cyclone DDS, version 11";
const s287 = "AllowMulticast=false, all hosts as Peers, ParticipantIndex=auto and MaxAutoParticipantIndex=9, its default (measured with 0.10.2)";
const s288 = [[1, 1, 1, "In 7 swarms within these sizes that we left out of the fit, discovery took 0.94 to 1.33 times the predicted airtime (typical error 5%). We expect 75% of such swarms in this range"]];
const s289 = {"count": "count11", "more": ["more31", "more32", "more2"]};
const s290 = [s289, s289, s289];
const s291 = {"count": "count12", "more": ["more33", "more34", "more35"]};
const s292 = [s291, s291, s291];
const s293 = [s290, s292, s150, s148, s205, s207, s209];
const s294 = "ICMP unreachable";
const s295 = {"burst": 1, "second": 1.125, "lease": 0.225, "ever": 0.125};
const s296 = 442.0177243557095;
const s297 = 1224.46511627907;
const s298 = 334.84114485689287;
const s299 = 150.13620569840168;
const s300 = 191.25372354324537;
const s301 = 180.00607650876952;
const s302 = 170.0050484920951;
const s303 = 179.9840521928235;
const s304 = 156.0150305307656;
const s305 = 190.60377358490564;
const s306 = 134.67330119732546;
const s307 = 185.2367491166078;
const s308 = 147.20074005550418;
const s309 = 166.51716247139586;
const s310 = "AllowMulticast=true, as it chooses on a network that it takes for wired: of three processes or more (measured with 0.10.2)";
const s311 = [[1, 1, 1, "In 7 swarms within these sizes that we left out of the fit, discovery took 0.91 to 1.10 times the predicted airtime (typical error 8%). We expect 75% of such swarms in this range"]];
const s312 = 492.4140969162995;
const s313 = 1040.4988009592325;
const s314 = 965.8901890189019;
const s315 = 215.89285714285714;
const s316 = 213.31594018453706;
const s317 = 200.7060146149522;
const s318 = 180.02209944751382;
const s319 = 152.05954502568403;
const s320 = 510.6666666666667;
const s321 = 179.94202898550725;
const s322 = 201.4570446735395;
const s323 = 219.65142364106987;
const s324 = 186.30392156862746;
const s325 = 207.01075268817203;
const s326 = 249.3997682502897;
const s327 = 210.50383141762453;
const s328 = 176.79097672186225;
const s329 = 122.00209989500526;
const s330 = 167.19174466042716;
const s331 = "switching to Cyclone DDS with static peers";
const s332 = "middleware and peers";
const s333 = "switching to Cyclone DDS with multicast SEDP announcements";
const s334 = "middleware and multicast endpoint data";
const s335 = "one server, wired to the access point (measured with 2.9.1)";
const s336 = {"measured": s124, "range": "0.72 to 1.63", "hosts": "12", "seconds": "15", "low": "0.72", "high": "1.63"};
const s337 = "--ds-product-fast-dds";
const s338 = [[1, 1, 1, "In 6 swarms within these sizes that we left out of the fit, discovery took 1.00 to 1.10 times the predicted airtime (typical error 4%). We expect 71% of such swarms in this range"]];
const s339 = {"until": [s140, [20, "slow at best"], s141], "never": s142};
const s340 = {"second": 1, "lease": 20, "ever": Infinity};
const s341 = {"count": "count13", "more": ["more36", "more37", "more38"]};
const s342 = {"count": "count14", "more": ["more39", "more40"]};
const s343 = [s342, s342, s342];
const s344 = {"count": "count16", "more": ["more44", "more45", "more5"]};
const s345 = {"count": "count17", "more": ["more46", "more47", "more38"]};
const s346 = [s208, s345, s345];
const s347 = [s146, [s208, s341, s341], s343, [s208, {"count": "count15", "more": ["more41", "more42", "more43"]}, s344], s346, s209];
const s348 = "SPDP to server";
const s349 = 0.3333333333333333;
const s350 = {"burst": 5.833333333333333, "second": 6.166666666666666, "lease": 0.625, "ever": s349};
const s351 = "SPDP of server";
const s352 = {"burst": 0.5, "second": 0.8333333333333333, "lease": 0.35833333333333334, "ever": s349};
const s353 = "SPDP of server at discovery";
const s354 = 748.3930635838151;
const s355 = {"burst": 1, "second": 1, "lease": 0.05, "ever": 0};
const s356 = "SPDP of others";
const s357 = 683.9365973934484;
const s358 = "SPDP Heartbeat";
const s359 = "SPDP Heartbeat of server";
const s360 = 250.29586195342605;
const s361 = "SPDP Heartbeat of others";
const s362 = 354.98051539912007;
const s363 = "SPDP ACKNACK of others";
const s364 = "SPDP ACKNACK of server";
const s365 = 204.14209591474247;
const s366 = "SEDP to server";
const s367 = "SEDP of others";
const s368 = 655.9962112242481;
const s369 = "Heartbeat of server";
const s370 = "Heartbeat of others";
const s371 = 451.4893977947413;
const s372 = "ACKNACK of others";
const s373 = "ACKNACK of server";
const s374 = 205.97133664814274;
const s375 = "Liveliness Heartbeat to server";
const s376 = "Liveliness Heartbeat of server";
const s377 = [s226, "unicast", 192, 1, 4, 1.292, "up down", s355];
const s378 = "Liveliness ACKNACK to server";
const s379 = "Liveliness ACKNACK of server";
const s380 = [s231, "unicast", 188, 1, 4, 1.292, "up down", s355];
const s381 = [s241, "unicast", 192, 1, 5, 1.021, "up down", s355];
const s382 = ["User ACKNACK", "unicast", 188, 1, 5, 1.021, "up down", s355];
const s383 = [
[s348, "unicast", 652, 1, 0, 1, "up", s350],
[s351, "unicast", 700, 1, 0, 1, "down", s352],
[s353, "unicast", s354, 0.865, 0, 1, "down", s355],
[s356, "unicast", s357, 0.8517, 1, 1.967, "down", s355],
[s358, "unicast", 192, 1, 0, 2, "up", s355],
[s359, "unicast", s360, 0.5969, 0, 2.167, "down", s355],
[s361, "unicast", s362, 0.3182, 1, 2.908, "down", s355],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up", s355],
[s363, "unicast", 190.2, 1, 1, 0.5083, "up", s355],
[s364, "unicast", 188, 1, 0, 2, "down", s355],
["SPDP Gap", "unicast", s365, 0.6193, 1, 1.6, "down", s355],
[s366, "unicast", 1152, 0.45, 2, 1, "up", s355],
[s367, "unicast", s368, 0.8446, 3, 1.237, "down", s355],
["Heartbeat", "unicast", 192, 1, 0, 4, "up", s355],
[s369, "unicast", 192, 1, 0, 4, "down", s355],
[s370, "unicast", s371, 0.2358, 3, 1.892, "down", s355],
["ACKNACK", "unicast", 188, 1, 0, 4, "up", s355],
[s372, "unicast", 191.3, 1, 3, 0.45, "up", s355],
[s373, "unicast", 188.5, 1, 0, 15.6, "down", s355],
["Gap", "unicast", s374, 0.6838, 3, 0.645, "down", s355],
[s375, "unicast", 192, 1, 0, 1, "up", s355],
[s376, "unicast", 192, 1, 0, 2, "down", s355],
s377,
[s378, "unicast", 188, 1, 0, 2, "up", s355],
[s379, "unicast", 188, 1, 0, 2, "down", s355],
s380,
s381,
s382,
];
const s384 = "two servers that know nothing of each other, both wired to the access point; clients of both (measured with 2.9.1)";
const s385 = {"measured": "Fast DDS", "range": "0.97 to 2.03", "hosts": "8", "seconds": "15", "low": "0.97", "high": "2.03"};
const s386 = [[1, 1, 1, "In 6 swarms within these sizes that we left out of the fit, discovery took 1.00 to 1.05 times the predicted airtime (typical error 2%). We expect 71% of such swarms in this range"]];
const s387 = [
[s348, "unicast", 636, 1, 0, 2, "up", s350],
[s351, "unicast", 700, 1, 0, 2, "down", s352],
[s353, "unicast", 747.8396673212429, 0.8657, 0, 2, "down", s355],
[s356, "unicast", 684.0093940817285, 0.8516, 1, 3.9, "down", s355],
[s358, "unicast", 192, 1, 0, 4, "up", s355],
[s359, "unicast", 244.85106382978725, 0.6204, 0, 4.625, "down", s355],
[s361, "unicast", 402.48973607038124, 0.2728, 1, 5.942, "down", s355],
["SPDP ACKNACK", "unicast", 189.8, 1, 0, 4.625, "up", s355],
[s363, "unicast", 190.5, 1, 1, 0.9417, "up", s355],
[s364, "unicast", 188, 1, 0, 4, "down", s355],
["SPDP Gap", "unicast", 199.09006997171358, 0.6717, 1, 3.333, "down", s355],
[s366, "unicast", 1257.7301004163605, 0.4083, 2, 2, "up", s355],
[s367, "unicast", s368, 0.8446, 3, 2.45, "down", s355],
["Heartbeat", "unicast", 184, 1, 0, 8, "up", s355],
[s369, "unicast", 192, 1, 0, 8, "down", s355],
[s370, "unicast", 432.5140562248996, 0.249, 3, 3.242, "down", s355],
["ACKNACK", "unicast", 188, 1, 0, 8, "up", s355],
[s372, "unicast", 190.8, 1, 3, 0.85, "up", s355],
[s373, "unicast", 188.5, 1, 0, 31.6, "down", s355],
["Gap", "unicast", 207.54580397181294, 0.6244, 3, 1.03, "down", s355],
[s375, "unicast", 192, 1, 0, 2, "up", s355],
[s376, "unicast", 192, 1, 0, 4, "down", s355],
[s226, "unicast", 192, 1, 4, 1.208, "up down", s355],
[s378, "unicast", 188, 1, 0, 4, "up", s355],
[s379, "unicast", 188, 1, 0, 4, "down", s355],
[s231, "unicast", 188, 1, 4, 1.208, "up down", s355],
[s241, "unicast", 192, 1, 5, 1.08, "up down", s355],
["User ACKNACK", "unicast", 188, 1, 5, 1.179, "up down", s355],
];
const s388 = {"count": "count18", "more": ["more48", "more2"]};
const s389 = {"count": "count19", "more": ["more49", "more50", "more38"]};
const s390 = {"count": "count20", "more": ["more51", "more40"]};
const s391 = "moving to ROS 2 Lyrical (Fast DDS 3.6)";
const s392 = "moving to ROS 2 Humble (Fast DDS 2.6)";
const s393 = "moving to ROS 2 Jazzy (Fast DDS 2.14)";
const s394 = "with UDP and shared memory, as shipped and as ROS 2 sets it (measured with 2.9.1)";
const s395 = [
[1, 1.67, 11.3, "In 11 swarms within these sizes that we left out of the fit, discovery took 0.91 to 1.04 times the predicted airtime (typical error 3%). We expect 83% of such swarms in this range"],
[2, 1.67, 11.3, "In 2 swarms of up to twice these sizes that we left out of the fit, discovery took 0.95 to 1.22 times the predicted airtime (typical error 13%). From so few swarms, we derive no interval"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints that we left out of the fit, discovery took 2.06 to 2.29 times the predicted airtime (typical error 118%). From so few swarms, we derive no interval"],
];
const s396 = {"count": "count23", "more": ["more56", "more57", "more8"]};
const s397 = [s396, s396, s396];
const s398 = [s146, s397, s150, s207, s148, s209];
const s399 = "SPDP at discovery";
const s400 = 4.833333333333333;
const s401 = 5.166666666666666;
const s402 = {"burst": s400, "second": s401, "lease": 0.575, "ever": s349};
const s403 = "SPDP unicast at discovery";
const s404 = "SPDP unicast for others";
const s405 = 852.6666666666666;
const s406 = "Heartbeat for others";
const s407 = "ACKNACK of data";
const s408 = "switching to Cyclone DDS";
const s409 = [[1, 1, 1, "In 19 swarms within these sizes that we left out of the fit, discovery took 0.86 to 1.68 times the predicted airtime (typical error 14%). We expect 90% of such swarms in this range"]];
const s410 = 773.5594083028471;
const s411 = "ROS discovery info";
const s412 = "ROS Heartbeat for others";
const s413 = "ROS ACKNACK for others";
const s414 = [[1, 1, 1, "In 16 swarms within these sizes that we left out of the fit, discovery took 0.89 to 1.17 times the predicted airtime (typical error 5%). We expect 88% of such swarms in this range"]];
const s415 = [s146, s150, s148, s209, s207];
const s416 = 1014.7323568575234;
const s417 = "both values use the measured model of Fast DDS, and the server forwards everything, as in Fast DDS 3.6";
const s418 = ["peers", s331, "", s134, "Fast DDS 3.6", s332];
const s419 = [s95, s333, "", s137, "Fast DDS 3.6", s334];
const s420 = ["router", s177, "", "Zenoh router", "Fast DDS 3.6", s178];
const s421 = [s98, s180, "", s157, "Fast DDS 3.6", s181];
const s422 = [s101, s183, "", s160, "Fast DDS 3.6", s184];
const s423 = ["announcements", s186, "", "Fast DDS 3.6, a longer announcement interval", "Fast DDS 3.6", "announcements"];
const s424 = ["release", s392, "", "Fast DDS 2.6", "Fast DDS 3.6", "release"];
const s425 = ["release", s393, "", "Fast DDS 2.14", "Fast DDS 3.6", "release"];
const s426 = ["middleware", s190, "", s154, "Fast DDS 3.6", "middleware"];
const s427 = [[1, 1, 1, "In 64 of 68 swarms within these sizes that we left out of the fit, discovery took 0.90 to 1.57 times the predicted airtime (typical error 6%). We expect 91% of such swarms in this range"]];
const s428 = [s146, s150, s148, s209, [s208, s208, s208], s207];
const s429 = 896.8584995251663;
const s430 = 189.68085535606212;
const s431 = 808.8594208980277;
const s432 = "--ds-basis-proposal";
const s433 = {"until": [s140, [23, "slow at best"], s141], "never": s142};
const s434 = {"second": 1, "lease": 23, "ever": Infinity};
const s435 = {"count": "count24", "more": ["more58", "more35"]};
const s436 = [s435, s435, s435];
const s437 = {"count": "more35", "more": ["more35"]};
const s438 = [s437, s437, s437];
const s439 = {"burst": 1, "second": 1, "lease": 0.043478260869565216, "ever": 0};
const s440 = ["Announce", "multicast", 80, 1, 0, 1, "up down", s439];
const s441 = ["Process", "multicast", 24, 0, 1, 1, "up down", s439];
const s442 = ["Endpoint", "multicast", 20, 0, 2, 1, "up down", s439];
const s443 = ["Digest", "multicast", 80, 1, 3, 1, "up down", s439];
const s444 = ["Listed", "multicast", 1, 0, 0, 1, "up down", s439];
const s445 = {"burst": 0, "second": s349, "lease": s349, "ever": s349};
const s446 = ["Heartbeat", "multicast", 80, 1, 0, 1, "up down", s445];
const s447 = ["Claimed", "multicast", 0.125, 0, 4, 1, "up down", s445];
const s448 = {"count": "count25", "more": ["count25"]};
const s449 = "switching to DDS with the timers of Cyclone DDS";
const s450 = "DDS, periods of Cyclone DDS";
const s451 = "DDS, periods of Fast DDS";
const s452 = "switching to Zenoh with the timers of Zenoh peer";
const s453 = "Zenoh, periods of Zenoh peer";
const s454 = "switching to DDS with the timers of Fast DDS";
const s455 = "--ds-product-zenoh";
const s456 = {"burst": 3.125, "second": 3.25, "lease": 0.4375, "ever": 0.125};
const s457 = {"burst": 0, "second": 0.4, "lease": 0.4, "ever": 0.4};
const s458 = ["KeepAlive", "unicast", 84, 1, 1, 1, "up down", s457];
const s459 = "Fast DDS with endpoints that are known in advance (static EDP), participants announced as ever (measured with 2.9.1)";
const s460 = [[1, 1, 1, "In 10 swarms within these sizes that we left out of the fit, discovery took 0.95 to 1.31 times the predicted airtime (typical error 5%). We expect 82% of such swarms in this range"]];
const s461 = [s344, s344, s344];
const s462 = {"count": "count26", "more": ["more59", "more60"]};
const s463 = {"count": "count27", "more": ["more61", "more62", "more63"]};
const s464 = [s146, s397, s343, s150, s207, s148, s461, [s462, s462, s462], s205, [s463, s463, s463], s209];
const s465 = "SPDP of endpoints";
const s466 = "SPDP unicast of endpoints";
const s467 = "Listed at discovery";
const s468 = "Listed of endpoints";
const s469 = "Listed unicast";
const s470 = "Listed unicast at discovery";
const s471 = "Listed unicast for others";
const s472 = "Listed unicast of endpoints";
const s473 = "peers, each linked with each other (measured with 1.10.2)";
const s474 = [[1, 1, 1, "In 10 swarms within these sizes that we left out of the fit, discovery took 0.86 to 1.12 times the predicted airtime (typical error 8%). We expect 82% of such swarms in this range"]];
const s475 = [s147, {"count": "count28", "more": ["more64", "more65", "more66"]}, s208];
const s476 = [s146, s150, s207, s148, s475, s209];
const s477 = ["Scout", "multicast", 67, 1, 0, 1, "up down", s456];
const s478 = ["Hello", "unicast", 104, 1, 1, 1, "up down", {"burst": 2.125, "second": 2.25, "lease": 0.3375, "ever": 0.125}];
const s479 = ["InitAck", "unicast", 153, 1, 1, 0.6667, "up down", s215];
const s480 = ["OpenSyn", "unicast", 134, 1, 1, 0.6667, "up down", s215];
const s481 = ["OpenAck", "unicast", 84, 1, 1, 0.6667, "up down", s215];
const s482 = 163.4251497005988;
const s483 = "OAM for others";
const s484 = 106.65917220235053;
const s485 = "Declare key expression";
const s486 = 229.04217991787982;
const s487 = "Declare key expression of matching";
const s488 = 112.31961259079904;
const s489 = "Frame of endpoints";
const s490 = ["KeepAlive", "unicast", 79, 1, 1, 1.333, "up down", s457];
const s491 = ["TCP control", "unicast", 76, 1, 1, 1.333, "up down", s215];
const s492 = "TCP ACK at start";
const s493 = "TCP ACK of endpoints";
const s494 = "with liveliness tokens, as rmw_zenoh has them, and a subscriber to all of them (measured with 1.10.2)";
const s495 = [
[1, 1.67, 11.3, "In 12 swarms within these sizes that we left out of the fit, discovery took 0.90 to 1.41 times the predicted airtime (typical error 6%). We expect 85% of such swarms in this range"],
[2, 1.67, 11.3, "In 4 swarms of up to twice these sizes that we left out of the fit, discovery took 0.99 to 1.02 times the predicted airtime (typical error 1%). From so few swarms, we derive no interval"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints that we left out of the fit, discovery took 0.93 to 1.15 times the predicted airtime (typical error 11%). From so few swarms, we derive no interval"],
];
const s496 = 179.4287333522244;
const s497 = 167.6030534351145;
const s498 = 175.50248756218906;
const s499 = "Declare token of node";
const s500 = 362.8385800401876;
const s501 = "Declare key expression of node";
const s502 = 159.33333333333334;
const s503 = 142.56804733727813;
const s504 = "--ds-product-rmw-zenoh";
const s505 = {"until": [s140, [60, "slow at best"], s141], "never": s142};
const s506 = {"second": 1, "lease": 60, "ever": Infinity};
const s507 = [s342, {"count": "count29", "more": ["more67", "more68"]}, s208];
const s508 = {"burst": 1, "second": 1, "lease": 0.016666666666666666, "ever": 0};
const s509 = ["InitSyn", "unicast", 110, 1, 0, 1, "up", s508];
const s510 = ["InitAck", "unicast", 153, 1, 0, 1, "down", s508];
const s511 = ["OpenSyn", "unicast", 134, 1, 0, 1, "up", s508];
const s512 = ["OpenAck", "unicast", 84, 1, 0, 1, "down", s508];
const s513 = 154.5017382527756;
const s514 = 192.6407465007776;
const s515 = 358.9464799539613;
const s516 = 137.8131868131868;
const s517 = 282.5695792880259;
const s518 = 622.248870141609;
const s519 = 148.72727272727272;
const s520 = 156.64516129032256;
const s521 = 0.03333333333333333;
const s522 = {"burst": 0, "second": s521, "lease": s521, "ever": s521};
const s523 = ["KeepAlive down", "unicast", 79, 1, 0, 1, "down", s522];
const s524 = "TCP ACK at start down";
const s525 = "TCP ACK of endpoints down";
const s526 = {"count": "count32", "more": ["more73", "more74", "more75", "more35"]};
const s527 = {"count": "count33", "more": ["more76", "more77", "more78", "more79", "more35"]};
const s528 = {"count": "count34", "more": ["more80", "more81", "more40"]};
const s529 = [s528, s528, s528];
const s530 = [s528, {"count": "count35", "more": ["more82", "more83", "more68"]}, s208];
const s531 = [s208, {"count": "count36", "more": ["more84", "more85", "more86"]}, {"count": "count37", "more": ["more87", "more88", "more89"]}];
const s532 = 1523.8764478764479;
const s533 = 1523.7329974811084;
const s534 = "Frame of gossip";
const s535 = 86.42028482111844;
const s536 = "Declare of matching";
const s537 = 1523.275922671353;
const s538 = "Declare key expression of tokens";
const s539 = 1524.2088308803109;
const s540 = 86.11918147065437;
const s541 = 1524.6626402070751;
const s542 = 1523.8867459991793;
const s543 = 1523.9638009049772;
const s544 = [s148, s150];
const s545 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s335,
"caution": "",
"ratios": s336,
"server_ratios": s139,
"has_server": true,
"color": s337,
"measured": [8, 8, 10],
"band": s338,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s347,
"degree": 2,
"messages": s383,
};
const s546 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s384,
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": true,
"color": s337,
"measured": [8, 8, 10],
"band": s386,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s347,
"degree": 2,
"messages": s387,
};
const s547 = {"until": [s140, [100, "slow at best"], s141], "never": s142};
const s548 = {"second": 1, "lease": 100, "ever": Infinity};
const s549 = {"burst": 1.9966666666666666, "second": 2.03, "lease": 0.0533, "ever": s521};
const s550 = {"burst": 0.9966666666666667, "second": 1.03, "lease": 0.0433, "ever": s521};
const s551 = {"burst": 4, "second": 4, "lease": 0.04, "ever": 0};
const s552 = {"burst": 1, "second": 1, "lease": 0.01, "ever": 0};
const s553 = 0.01020408163265306;
const s554 = {"burst": 0, "second": s553, "lease": s553, "ever": s553};
const s555 = ["Liveliness", "unicast", s220, 0.7242, 1, 1, "up down", s554];
const s556 = [s226, "unicast", s227, 0.2758, 1, 1, "up down", s554];
const s557 = [s231, "unicast", 128, 1, 1, 1, "up down", s554];
const s558 = [s146, s397, s343, s461, s346, s209];
const s559 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s335,
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": true,
"color": s337,
"measured": [8, 8, 10],
"band": s338,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s558,
"degree": 2,
"messages": s383,
};
const s560 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s384,
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": true,
"color": s337,
"measured": [8, 8, 10],
"band": s386,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s558,
"degree": 2,
"messages": s387,
};
const s561 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s549];
const s562 = 0.06666666666666667;
const s563 = {"burst": 1.9333333333333333, "second": 2, "lease": 0.086, "ever": s562};
const s564 = {"burst": 0.9333333333333333, "second": 1, "lease": 0.076, "ever": s562};
const s565 = {"burst": s400, "second": s401, "lease": 0.38166666666666665, "ever": s349};
const s566 = [s150, s207, s148, s475, s209];
const s567 = ["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s215];
const s568 = ["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s215];
const s569 = ["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s215];
const s570 = 0.9997000149992501;
const s571 = ["KeepAlive", "unicast", 79, 1, 0, s570, "up down", s457];
const s572 = ["TCP control", "unicast", 76, 1, 0, s570, "up down", s215];
return {
"start": {"robot": s1, "middleware": "Fast DDS 3.6", "ros": "lyrical", "product": "Fast DDS"},
"ros": {"humble": {"Fast DDS": "Fast DDS 2.6", "Cyclone DDS": "Cyclone DDS"}, "jazzy": {"Fast DDS": "Fast DDS 2.14", "Cyclone DDS": "Cyclone DDS"}, "kilted": {"Fast DDS": "Fast DDS 3.6", "Cyclone DDS": "Cyclone DDS"}, "lyrical": {"Fast DDS": "Fast DDS 3.6", "Cyclone DDS": s2}},
"exact": {"Fast DDS": "Fast DDS 2.9", "Cyclone DDS": "Cyclone DDS 0.10", "Cyclone DDS, version 11": s3},
"groups": [s4, s5, s6, s7, s8],
"fields": {
"swarm": [
{"name": "hosts", "label": "Robots", "symbol": "N_H", "unit": "", "scale": 1, "start": "5", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s9},
{"name": "processes", "label": "Processes per robot", "symbol": "N_P", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s9},
{"name": "endpoints", "label": "Endpoints per process", "symbol": "N_E", "unit": "", "scale": 1, "start": "678", "low": 0, "high": 1000000000, "above": false, "whole": false, "allowed": s10},
],
"beside": [
{"name": "beside_hosts", "label": "Computers", "symbol": "N_H1", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s9},
{"name": "beside_processes", "label": "Processes per computer", "symbol": "N_P1", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": s9},
{"name": "beside_endpoints", "label": "Endpoints per process, computers", "symbol": "N_E1", "unit": "", "scale": 1, "start": "90", "low": 0, "high": 1000000000, "above": false, "whole": false, "allowed": s10},
],
"own": [
{"name": "unicast_rate", "label": "Rate, unicast", "symbol": "R_uni", "unit": "Mbit/s", "scale": 1000000, "start": "144.4", "low": 0, "high": Infinity, "above": true, "whole": false, "allowed": s11},
{"name": "unicast_overhead", "label": "Overhead of a frame, unicast", "symbol": "O_uni", "unit": "µs", "scale": 1e-06, "start": "180", "low": 0, "high": Infinity, "above": false, "whole": false, "allowed": s12},
{"name": "multicast_rate", "label": "Rate, multicast", "symbol": "R_multi", "unit": "Mbit/s", "scale": 1000000, "start": "6", "low": 0, "high": Infinity, "above": true, "whole": false, "allowed": s11},
{"name": "multicast_overhead", "label": "Overhead of a frame, multicast", "symbol": "O_multi", "unit": "µs", "scale": 1e-06, "start": "120", "low": 0, "high": Infinity, "above": false, "whole": false, "allowed": s12},
],
"cells": [{"name": "cells", "label": "Access points", "symbol": "cells", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 233, "above": false, "whole": true, "allowed": "a whole number of at least 1 and at most 233"}],
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
"name": s13,
"model": "linear",
"values": {"R_uni": 144400000, "O_uni": 0.00018, "R_multi": 6000000, "O_multi": 0.00012},
"remedies": [
{"kind": s14, "what": s15, "note": s16, "base": s19, "wifi": {"name": s20, "model": "padded", "values": s21}},
{"kind": "radio", "what": s22, "note": "compared with 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead per frame exchange. Both values use the timing of the 802.11 standard", "base": s19, "wifi": s25},
{"kind": "radio", "what": s26, "note": "compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead per frame exchange. Both values use the timing of the 802.11 standard", "base": s19, "wifi": s30},
{"kind": "radio", "what": s31, "note": "compared with 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead per frame exchange. Both values use the timing of the 802.11 standard", "base": s19, "wifi": s35},
{"kind": "aggregation", "what": "aggregating up to 64 frames", "note": s16, "base": s19, "wifi": s36},
],
},
{
"name": s37,
"model": "padded",
"values": s38,
"remedies": [
{"kind": s14, "what": s15, "note": "", "base": s39, "wifi": {"name": "802.11a 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": s40}},
{"kind": "radio", "what": s22, "note": "compared with 802.11a 20 MHz 1x1: 300 instead of 54 Mbit/s and 186 instead of 166 µs of overhead per frame exchange", "base": s39, "wifi": s25},
{"kind": "radio", "what": s26, "note": "compared with 802.11a 20 MHz 1x1: 867 instead of 54 Mbit/s and 190 instead of 166 µs of overhead per frame exchange", "base": s39, "wifi": s30},
{"kind": "radio", "what": s31, "note": "compared with 802.11a 20 MHz 1x1: 2402 instead of 54 Mbit/s and 196 instead of 166 µs of overhead per frame exchange", "base": s39, "wifi": s35},
],
},
{
"name": s41,
"model": "padded",
"values": s42,
"remedies": [
{"kind": s14, "what": s43, "note": "", "base": s44, "wifi": {"name": "802.11g 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": s40}},
{"kind": "radio", "what": s22, "note": "compared with 802.11g 20 MHz 1x1: 300 instead of 54 Mbit/s, 186 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s44, "wifi": s25},
{"kind": "radio", "what": s26, "note": "compared with 802.11g 20 MHz 1x1: 867 instead of 54 Mbit/s, 190 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s44, "wifi": s30},
{"kind": "radio", "what": s31, "note": "compared with 802.11g 20 MHz 1x1: 2402 instead of 54 Mbit/s, 196 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s44, "wifi": s35},
],
},
{
"name": s45,
"model": "padded",
"values": s18,
"full": s36,
"remedies": [
{"kind": s14, "what": s15, "note": "", "base": s46, "wifi": {"name": s20, "model": "padded", "values": s21, "full": {"name": "802.11n 20 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64", "model": "aggregated", "values": s47}}},
{"kind": "radio", "what": s22, "note": "compared with 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead per frame exchange", "base": s46, "wifi": s49},
{"kind": "radio", "what": s26, "note": "compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead per frame exchange", "base": s46, "wifi": s51},
{"kind": "radio", "what": s31, "note": "compared with 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead per frame exchange", "base": s46, "wifi": s53},
],
},
{
"name": s54,
"model": "padded",
"values": s55,
"full": s56,
"remedies": [
{"kind": s14, "what": s43, "note": "", "base": s57, "wifi": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s", "model": "padded", "values": s21, "full": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64", "model": "aggregated", "values": s47}}},
{"kind": "radio", "what": s22, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 300 instead of 144 Mbit/s, 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s57, "wifi": s49},
{"kind": "radio", "what": s26, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 867 instead of 144 Mbit/s, 190 instead of 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s57, "wifi": s51},
{"kind": "radio", "what": s31, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 2402 instead of 144 Mbit/s, 196 instead of 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s57, "wifi": s53},
],
},
{
"name": s23,
"model": "padded",
"values": s24,
"full": s48,
"remedies": [
{
"kind": s14,
"what": s15,
"note": "",
"base": s49,
"wifi": {
"name": "802.11n 40 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11n 40 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
},
},
},
{"kind": "radio", "what": s26, "note": "compared with 802.11n 40 MHz 2x2: 867 instead of 300 Mbit/s and 190 instead of 186 µs of overhead per frame exchange", "base": s49, "wifi": s51},
{"kind": "radio", "what": s31, "note": "compared with 802.11n 40 MHz 2x2: 2402 instead of 300 Mbit/s and 196 instead of 186 µs of overhead per frame exchange", "base": s49, "wifi": s53},
],
},
{
"name": s27,
"model": "padded",
"values": s29,
"full": s50,
"remedies": [
{
"kind": s14,
"what": s15,
"note": "",
"base": s51,
"wifi": {
"name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s28, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s28, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
},
},
},
{"kind": "radio", "what": s31, "note": "compared with 802.11ac 80 MHz 2x2: 2402 instead of 867 Mbit/s and 196 instead of 190 µs of overhead per frame exchange", "base": s51, "wifi": s53},
],
},
{
"name": s58,
"model": "padded",
"values": s60,
"full": s61,
"remedies": [
{
"kind": s14,
"what": s43,
"note": "",
"base": s62,
"wifi": {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s59, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s59, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
},
},
},
{"kind": "radio", "what": s22, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 300 instead of 287 Mbit/s, 186 instead of 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s62, "wifi": s49},
{"kind": "radio", "what": s26, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 867 instead of 287 Mbit/s, 190 instead of 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s62, "wifi": s51},
{"kind": "radio", "what": s31, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 2402 instead of 287 Mbit/s, 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s62, "wifi": s53},
],
},
{
"name": s63,
"model": "padded",
"values": s65,
"full": s66,
"remedies": [
{
"kind": s14,
"what": s15,
"note": "",
"base": s67,
"wifi": {
"name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s64, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s64, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
},
},
},
{"kind": "radio", "what": s31, "note": "compared with 802.11ax 80 MHz 2x2: 2402 instead of 1201 Mbit/s and 196 µs of overhead per frame exchange", "base": s67, "wifi": s53},
],
},
{
"name": s32,
"model": "padded",
"values": s34,
"full": s52,
"remedies": [
{
"kind": s14,
"what": s15,
"note": "",
"base": s53,
"wifi": {
"name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s33, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s33, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
},
},
},
],
},
{
"name": s68,
"model": "padded",
"values": s70,
"full": s71,
"remedies": [
{
"kind": s14,
"what": s15,
"note": "",
"base": s72,
"wifi": {
"name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s69, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s69, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
},
},
},
{"kind": "radio", "what": s31, "note": "compared with 802.11be 80 MHz 2x2: 2402 instead of 1441 Mbit/s and 196 instead of 204 µs of overhead per frame exchange", "base": s72, "wifi": s53},
],
},
{
"name": s73,
"model": "padded",
"values": s75,
"full": s76,
"remedies": [
{
"kind": s14,
"what": s15,
"note": "",
"base": {"name": s73, "model": "padded", "values": s75, "full": s76},
"wifi": {
"name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s74, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s74, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
},
},
},
],
},
],
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
"max_work": 30,
"max_processes": 3000,
"simulated_anyway": [s77, s78],
"max_changes": 9,
"most_pairs": 0.95,
"many_lost": 0.5,
"few_lost": 0.1,
"min_gain": 0.2,
"many_expired": 0.05,
"other_software": ["build", "research", "switch", "upgrade"],
"too_large": "the simulation would take too much time or memory",
"shown": 3,
"near": 0.5,
},
"sentences": {
"works": "Yes, this startup works: {fleet} discover each other within {within} ({how}).",
"works in simulations": "Not sure: in simulations, {fleet} discover each other within {within} ({how}). But {caution}.",
"probably": "Probably: in simulations, {fleet} discover each other within {within} ({how}). But {slower}.",
"forgotten": "No: {fleet} discover each other within {within} ({how}), but leases expire in {forgetful} of {runs} runs, and robots forget each other.",
"too slow": "No, not within {within}: {fleet} need longer to discover each other ({how}).",
"never": "No: {fleet} do not complete discovery within {until} ({how}).",
"never in time": "No, not within {within}: {fleet} do not complete discovery even within {until} ({how}).",
"unrepaired": "Not sure: {fleet} need at least {low} ({how}), and longer if messages are lost.",
"unrepaired and slow": "No, not within {within}: {fleet} need at least {low} ({how}).",
"too busy": "No, not within {within}: {fleet} keep the channel busy for {drain} even if nothing is lost ({how}).",
"endless": "No: {fleet} never complete discovery ({how}).",
"unknown": "Not sure: {fleet} keep the channel busy for {drain} if nothing is lost ({how}), and their discovery time was not simulated.",
"times": "Discovery time: {median} in the median run, at most {nine} in {most}.",
"times of some": "Discovery time: {median} in the median run, but {late} of {runs} runs do not finish within {until}.",
"time of one": "Discovery time: {median} in the one run that was simulated.",
"most pairs": "After {time}, {share} of the pairs of processes know each other.",
"share of pairs": "After {until}, {share} of the pairs of processes know each other.",
"busy": "The channel goes idle after {median} (median). But {lost} of the messages are lost on the way, and we do not simulate how {protocol} repairs losses.",
"not simulated": "Not simulated: {reason}.",
"periodic traffic fills": "Periodic traffic alone fills the channel.",
"access point loses": "The access point's queue drops {lost} of all messages, more than {protocol} can resend in time.",
"robots lose": "Robots' queues drop {lost} of all messages, more than {protocol} can resend in time.",
"air loses": "Collisions cost {lost} of all messages, more than {protocol} can resend in time.",
"leases end": "Leases expire meanwhile, so robots forget each other.",
"data fits": "Your data fit: after discovery, data and periodic traffic together need {airtime} of airtime per second.",
"data may fit": "Your data fit only if A-MPDUs are full: data and periodic traffic then need {airtime} of airtime per second after discovery.",
"data does not fit": "Your data do not fit: even after discovery, data and periodic traffic together need {airtime} of airtime per second. First step: send fewer samples, or send them to fewer hosts.",
"first": "First step:",
"covered": "To be sure, make one of these changes, least effort first:",
"faster": "These changes make it faster still, least effort first:",
"then": "Or:",
"shorter": "These changes make it faster, but not complete within {within}:",
"not sure either": "These changes make it faster in simulations, but perhaps not fast enough:",
"none helps": "None of the {count} simulated changes helps by more than the scatter between runs.",
"none known": "No change that we could simulate helps.",
"change": "{number}. {what}: {before} -> {after}. Effort: {effort}. {cost}.",
"leases": "{time}, but leases expire in {forgetful} of {runs} runs",
"enough": "{time}; {least} if all are composed into 1",
"doubtful": " Not sure: {caution}.",
"perhaps": " Probably enough: real runs may take up to {slow}.",
"slower": "in an emulated Wi-Fi cell, startups of over 1.5 s took real {measured} up to {times} times as long as simulated, which would be {slow} here",
"slower elsewhere": "real runs may take up to {times} times as long, that is {slow}; we have not measured any",
"easier": "A change of less effort, but not complete within {within}:",
"easier, perhaps": "A change of less effort, but perhaps not complete within {within}:",
"fewer": "start no more than {count} of the {group} on this channel{beside}. These {total} discover each other after {time}. We did not simulate whether the others can start later.",
"stopgap": "First step: {fewer}",
"until then": "Until then, {fewer}",
"changes": "Then make one change that is enough for discovery:",
"none near": "No simulated change lets half of the pairs discover each other within {until}.",
"paste": " Configure it with --paste {name}.",
"closed form": "Ranked by airtime saved, because discovery times were not simulated:",
"drain": "- {what}: never -> the channel goes idle after {after}, if nothing is lost.",
"none ends": "No change is enough: after each one, periodic traffic alone fills the channel.",
"possible": "These may help, but we do not simulate how they repair losses: {names}.",
"bounds": "We do not know the effect of these changes, because we do not simulate how they repair losses: {names}.",
"parts": "After these changes, some robots no longer discover each other: {names}.",
"domains": "Domains share the channel: we simulate one of them on a channel slowed down by the airtime of the others. Real times are longer, because messages of different domains also collide and share the access point's queue.",
"others": "These changes did not help by more than the scatter between runs: {names}.",
"left out": "We did not simulate these changes, because {reason}: {names}.",
"compared": "Discovery times are medians of {runs} in simulation. A startup works if nine of ten runs complete discovery within {within} and no running robot's lease expires. Name a single protocol to see which changes help.",
"cautious": "Not sure for {names}: {caution}.",
"some leases": "leases expire in {forgetful} of {runs} runs",
"lost": "{lost} of the messages are lost, and we do not simulate repairs",
"reboot": "If one robot reboots, all others rediscover it {time} after its nodes start, and {kept}.",
"kept": "none of their leases expires",
"not kept": "some of their leases expire in {forgetful} of {runs} runs",
"no robot rebooted": "We simulated no reboot, as not every startup finishes.",
"sure": "How sure: with fixed seeds, we simulated {until} in {runs}.",
"ranges": "Ranges span {interval}.",
"long runs": "{runs} if they take long",
"hopeless run": "only {runs} if fewer than {share} of the pairs complete discovery",
"assumed": "Assumes: one access point, all robots in range, a common start, queues of 500 messages.",
"most runs": "the second fastest to the second slowest of {runs} runs",
"all runs": "all {runs} runs",
"both runs": "both runs",
"never means": "'Never' means not within the {until} that we simulated.",
"rounded": "{name}: a process has {mean} endpoints on average; we simulate {whole}.",
"domain": "All hosts have ROS_DOMAIN_ID {domain}, which does not change these times.",
"of paper: messages channel": "Messages and channel are the paper's: set yours with `--protocol` and `--wifi`.",
"of paper: messages": "The messages are the paper's: set yours with `--protocol`.",
"of paper: channel": "The channel is the paper's: set yours with `--wifi`.",
"server": "The server or router is wired to the access point, and is not one of your hosts.",
"extrapolated": "We measured {protocol} in fleets of up to {hosts}; beyond, we extrapolate.",
"air": "In an emulated Wi-Fi cell of up to {hosts} hosts, startups of over 1.5 s took real {measured} {range} times as long as simulated.",
"watched": "We watched real startups for at most {seconds} s, so we extrapolate longer times.",
"not compared": "Real runs may take up to {high} times as long (we have not measured any).",
"server not compared": "Real startups with a server or router may take up to {high} times as long (we have not measured any).",
"interrupted": "Interrupted: not all runs are done, so some changes are missing.",
"cell": "{cell}: the startup needs {airtime} of airtime in its first second.",
"assumed of cells": "Assumes: all robots in range of their access points, a common start, queues of 500 messages. Cells do not interfere, and messages between access points take no time. We do not compare other radios and channels: change the fleet file, and plan again.",
"surer": "To check, run `discostorm capture` on a recorded startup.",
"why": "`--why` adds airtime, configurations and assumptions.",
"all": "`--all` adds all changes.",
"searching": "Next we check how many robots can start unchanged, and look for smaller changes that suffice.",
"not known again": "No: if one robot reboots, not all others rediscover it within the simulated time.",
"no reboot": "Not sure: we simulate a reboot only if every startup has finished before it.",
"other start": "Changes are compared for robots that start together.",
"paper (802.11n)": "the paper's 802.11n",
"own channel": "your own channel",
"DDS, periods of Fast DDS": "DDS with Fast DDS timers",
"DDS, periods of Cyclone DDS": "DDS with Cyclone DDS timers",
"Zenoh, periods of Zenoh peer": "Zenoh with peer timers",
"Cyclone DDS, wired": "Cyclone DDS as on a wired network",
"Cyclone DDS, version 11": s3,
"Cyclone DDS, version 11, wired": "Cyclone DDS 11 as on a wired network",
"Cyclone DDS peers": "Cyclone DDS with static peers",
"Cyclone DDS multicast SEDP": "Cyclone DDS with multicast SEDP",
"Fast DDS Discovery Server": s79,
"Fast DDS Discovery Server, two": "Fast DDS with two Discovery Servers",
"Fast DDS Discovery Server, on a robot": "Fast DDS with a Discovery Server on a robot",
"static endpoints": "Fast DDS with static endpoints",
"Zenoh peer": "Zenoh with peers",
"Zenoh peer, tokens": "Zenoh with peers and tokens",
"Zenoh router": "Zenoh with a router",
"Zenoh router per host": "Zenoh with a router on each host",
"Zenoh router per host, star": "Zenoh with a router on each host plus a wired router",
"hybrid": "the hybrid discovery",
"hybrid, alike": "the hybrid discovery with identical hosts",
"never fits": "The periodic traffic alone needs {share} of the channel, so the fleet never fits, however slowly it starts.",
"drain time": "Drain time: {busy}. {why}",
"sooner": "Discovery can be complete sooner, because dropped messages need no airtime and the last repeats come after discovery.",
"later": "Discovery takes longer, because processes wait before they answer and before they repeat lost messages.",
"full A-MPDUs": "The drain time assumes full A-MPDUs. The fewer frames wait, the less full they are.",
"may never fit": "The fleet may never fit: with one message per frame, its periodic traffic alone needs {share} of the channel.",
"reply wait": "While nodes start, service servers need a max_blocking_time (reliability QoS) of {wait} or more. The default of Fast DDS is {usual}.",
"endless reply wait": "While nodes start, no max_blocking_time is long enough for services: some pairs never complete discovery.",
"data load": "Your data need {data} of the channel, or {both} together with the periodic traffic of discovery. So your data {fit} once discovery is complete.",
"data load and little else": "Together with the periodic traffic of discovery, your data need {both} of the channel. So your data {fit} once discovery is complete.",
"data during startup": "During startup, your data {fit}: discovery and data together need {airtime} of airtime in {time}.",
"data wait": "If robots sent all data from the beginning, startup would keep the channel busy for {time} instead of {alone}. Data wait at most that long, and in practice less, because robots send only to robots that they have discovered. `discostorm simulate` shows when discovery is complete, and how late the data are.",
"no room for data": "The channel can never carry discovery and all your data. Send fewer samples, or send them to fewer hosts.",
"captured": "The measured model of {name} comes from captures of up to {hosts} that started together, with up to {processes} in all and {endpoints} per process.",
"beyond captures": "Here, we extrapolate.",
"as the paper": "We count {names} as the paper does, and leave out messages that the product packs together or adds.",
"whole burst": "We assign the whole startup burst to {window}, and count periodic traffic at its average rate. The result is an upper bound.",
"standard timing": "For other radios, we use the timing of the 802.11 standard. By it, the airtime of this fleet is {airtime} today.",
"nothing to write": "Your startup already works, so nothing needs changing, and we wrote no files. To write the configuration of a change all the same, name it: --paste NAME.",
"nothing written": "--write: no configuration change is surely enough, so we wrote no files. See what helps without --write, then name a change: --paste NAME",
},
"alone": "A single host has no one to discover, and no other host receives its messages.",
"security": ["DDS Security (SROS2) is not counted.", "In startups that we captured, it multiplied airtime by 1.6 to 5.7 with Fast DDS and 2.1 to 2.8 with Cyclone DDS. Keep it on your robots, but plan without it, and with a shorter target: in place of 60 s, within = 10 with Fast DDS or 21 with Cyclone DDS."],
"topology": "one access point in infrastructure mode",
"limit": 1,
"told": 2,
"beyond": "; this fleet is larger, so expect errors of up to a factor of 2",
"times": [[0, 1e-06, "µs"], [0.001, 0.001, "ms"], [0.1, 1, "s"], [100, 60, "minutes"], [6000, 3600, "hours"], [172800, 86400, "days"], [60480000, 31557600, "years"]],
"airtime": {"inside": {"up": s80, "multicast": "inside_multicast", "unicast": s80}, "linear": {"up": s81, "multicast": "linear_multicast", "unicast": s81}, "padded": {"up": s82, "multicast": s83, "unicast": s82}, "aggregated": {"up": s84, "multicast": s83, "unicast": s84}},
"laptop_nodes": 2,
"service_endpoints": 12,
"endpoints_of_a_node": 28.40740740740741,
"shared_endpoints": [2, 4],
"remedies": {
"aggregation": {"steps": ["aggregation"], "of": {"DDS": s86, "Zenoh": s86, "None": s86}},
"announcements": {"steps": ["announcements"], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s87, "best_case": false, "cost": "failed robots are noticed later, and lost announcements are repeated later"}, "Zenoh": null, "None": null}},
"discovery server": {"steps": [s78], "of": {"DDS": {"efforts": ["server"], "effort": 3, "takes": s88, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the server is down and after short outages"}, "Zenoh": null, "None": null}},
"discovery server on a robot": {"steps": [s89], "of": {"DDS": {"efforts": ["server"], "effort": 3, "takes": s88, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the robot with the server is away"}, "Zenoh": null, "None": null}},
"endpoints": {"steps": ["endpoints"], "of": {"DDS": s90, "Zenoh": s90, "None": s90}},
"middleware": {"steps": ["middleware"], "of": {"DDS": s92, "Zenoh": {"efforts": ["switch"], "effort": 8, "takes": s91, "best_case": false, "cost": "all hosts must change together; we assume peers that scout by multicast; the paper does not count the tokens of rmw_zenoh"}, "None": s92}},
"middleware and discovery server": {
"steps": ["middleware", s78],
"of": {"DDS": {"efforts": s93, "effort": 8, "takes": s94, "best_case": false, "cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the server is down and after short outages"}, "Zenoh": null, "None": null},
},
"middleware and discovery server on a robot": {
"steps": ["middleware", s89],
"of": {"DDS": {"efforts": s93, "effort": 8, "takes": s94, "best_case": false, "cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the robot with the server is away"}, "Zenoh": null, "None": null},
},
"middleware and multicast endpoint data": {"steps": ["middleware", s95], "of": {"DDS": {"efforts": s96, "effort": 8, "takes": s97, "best_case": false, "cost": "all hosts must change together; multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later"}, "Zenoh": null, "None": null}},
"middleware and peers": {
"steps": ["middleware", "peers"],
"of": {
"DDS": {"efforts": s96, "effort": 8, "takes": s97, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS)"},
"Zenoh": {"efforts": s96, "effort": 8, "takes": s97, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; a process that dials a peer too early may keep dialing every 4 s"},
"None": null,
},
},
"middleware and router": {
"steps": ["middleware", "router"],
"of": {"DDS": null, "Zenoh": {"efforts": s93, "effort": 8, "takes": s94, "best_case": false, "cost": "all hosts must change together; robots need the router's address; all data pass through it; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)"}, "None": null},
},
"middleware and router on each host": {
"steps": ["middleware", s98],
"of": {"DDS": null, "Zenoh": {"efforts": s99, "effort": 8, "takes": s100, "best_case": false, "cost": "all hosts must change together; every router needs the addresses of all other routers; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back"}, "None": null},
},
"middleware and star of routers": {"steps": ["middleware", s101], "of": {"DDS": null, "Zenoh": {"efforts": s99, "effort": 8, "takes": s100, "best_case": false, "cost": "all hosts must change together; every robot needs the wired router's address; robots do not hear each other while the wired router is down"}, "None": null}},
"middleware and static endpoints": {
"steps": ["middleware", s102],
"of": {"DDS": {"efforts": ["switch", "build"], "effort": 8, "takes": "another middleware and rebuilt nodes", "best_case": false, "cost": "all hosts must change together; every endpoint, ROS 2's own included, must be listed in every file; Fast DDS 2.9.1 can crash"}, "Zenoh": null, "None": null},
},
"middleware and two discovery servers": {
"steps": ["middleware", s103],
"of": {"DDS": {"efforts": s99, "effort": 8, "takes": s100, "best_case": false, "cost": "all hosts must change together; each robot needs both addresses; ros2 tools must be super clients; late joiners stay undiscovered while both servers are down"}, "Zenoh": null, "None": null},
},
"multicast endpoint data": {"steps": [s95], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s87, "best_case": false, "cost": "multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later"}, "Zenoh": null, "None": null}},
"multicast rate": {"steps": [s14], "of": {"DDS": s104, "Zenoh": s104, "None": s104}},
"peers": {
"steps": ["peers"],
"of": {
"DDS": {"efforts": ["file"], "effort": 2, "takes": s87, "best_case": false, "cost": "you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS)"},
"Zenoh": {"efforts": ["file"], "effort": 2, "takes": s87, "best_case": false, "cost": "you must know the addresses beforehand; a process that dials a peer too early may keep dialing every 4 s"},
"None": null,
},
},
"processes": {"steps": ["processes"], "of": {"DDS": s105, "Zenoh": s105, "None": s105}},
"radio": {"steps": ["radio"], "of": {"DDS": s106, "Zenoh": s106, "None": s106}},
"release": {"steps": ["release"], "of": {"DDS": s107, "Zenoh": s107, "None": s107}},
"router": {"steps": ["router"], "of": {"DDS": null, "Zenoh": {"efforts": ["server"], "effort": 3, "takes": s88, "best_case": false, "cost": "robots need the router's address; all data pass through it; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)"}, "None": null}},
"router on each host": {"steps": [s98], "of": {"DDS": null, "Zenoh": {"efforts": ["servers"], "effort": 4, "takes": s108, "best_case": false, "cost": "every router needs the addresses of all other routers; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back"}, "None": null}},
"staggered start": {"steps": [s77], "of": {"DDS": s109, "Zenoh": s109, "None": s109}},
"star of routers": {"steps": [s101], "of": {"DDS": null, "Zenoh": {"efforts": ["servers"], "effort": 4, "takes": s108, "best_case": false, "cost": "every robot needs the wired router's address; robots do not hear each other while the wired router is down"}, "None": null}},
"static endpoints": {"steps": [s102], "of": {"DDS": {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "every endpoint, ROS 2's own included, must be listed in every file; Fast DDS 2.9.1 can crash"}, "Zenoh": null, "None": null}},
"two discovery servers": {"steps": [s103], "of": {"DDS": {"efforts": ["servers"], "effort": 4, "takes": s108, "best_case": false, "cost": "each robot needs both addresses; ros2 tools must be super clients; late joiners stay undiscovered while both servers are down"}, "Zenoh": null, "None": null}},
},
"pastes": {
"aggregation": {
"any": [
{
"where": s110,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Keep your band, channel and width. With 802.11ac and ax, vht_capab lets 64 frames of any length\n# share an exchange. With 802.11n only, leave out the last two lines.\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[SHORT-GI-20]\nieee80211ac=1\nvht_capab=[MAX-A-MPDU-LEN-EXP7]\n",
},
],
},
"announcements": {
"Fast DDS": [
{
"where": s111,
"version": s112,
"text": "<!-- for every process (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"calm\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <initialAnnouncements>\n              <count>1</count>\n              <period>\n                <sec>1</sec>\n              </period>\n            </initialAnnouncements>\n            <leaseAnnouncement>\n              <sec>15</sec>\n            </leaseAnnouncement>\n            <leaseDuration>\n              <sec>100</sec>\n            </leaseDuration>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
],
"Cyclone DDS": [
{
"where": s111,
"version": s113,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <Discovery>\n      <LeaseDuration>100 s</LeaseDuration>\n      <SPDPInterval>30 s</SPDPInterval>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"discovery server": {
"any": [
{
"where": s114,
"version": s112,
"text": "# on a computer that is wired to the access point (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Use the address of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n",
},
s116,
{
"where": "for the server if it is a program of your own",
"version": s112,
"text": "<!-- for the server if it is a program of your own (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; the server's process runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"server\" is_default_profile=\"true\">\n      <rtps>\n        <prefix>44.53.00.5f.45.50.52.4f.53.49.4d.41</prefix>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SERVER</discoveryProtocol>\n          </discovery_config>\n          <metatrafficUnicastLocatorList>\n            <locator>\n              <udpv4>\n                <address>192.168.1.10</address>\n                <port>11811</port>\n              </udpv4>\n            </locator>\n          </metatrafficUnicastLocatorList>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
s117,
s118,
],
},
"discovery server on a robot": {
"any": [
{
"where": "on one of the robots",
"version": s112,
"text": "# on one of the robots (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Use the address of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n",
},
s116,
s117,
s118,
],
},
"endpoints": {
"any": [
{
"where": "where a node of your own is made (C++)",
"version": "ROS 2 Humble",
"text": "// where a node of your own is made (C++) (ROS 2 Humble)\n// Load: compiled into the process of the node; no file, no environment variable\n// Not run here: compared with its documentation\nauto options = rclcpp::NodeOptions().start_parameter_services(false);\nauto node = std::make_shared<rclcpp::Node>(\"name\", options);\n",
},
],
},
"middleware": {
"Fast DDS": [
{
"where": s119,
"version": "ROS 2 Jazzy",
"text": "# on every computer (ROS 2 Jazzy)\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_fastrtps_cpp\n",
},
],
"Cyclone DDS": [
{
"where": s119,
"version": "ROS 2 Jazzy",
"text": "# on every computer (ROS 2 Jazzy)\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n",
},
],
"Zenoh": [
{
"where": s119,
"version": "ROS 2 Jazzy",
"text": "# on every computer (ROS 2 Jazzy)\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_zenoh_cpp\n# This names the file for every process, which comes with these lines. Without a router, peers warn\n# and go on. If there is a router, start it first: ros2 run rmw_zenoh_cpp rmw_zenohd\nexport ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n",
},
],
"Zenoh peers": [
{
"where": "on every computer, as /etc/zenoh_session.json5",
"version": "Zenoh 1.10.2",
"text": "// on every computer, as /etc/zenoh_session.json5 (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n// Peers find each other by multicast, without a router. This is Zenoh's default.\n{\n  mode: \"peer\",\n  listen: { endpoints: [\"tcp/0.0.0.0:0\"] },\n  scouting: { multicast: { enabled: true } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 10000, // Zenoh's default: a KeepAlive every 2.5 s; rmw_zenoh sets 60000 and 2\n        keep_alive: 4,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
],
},
"multicast endpoint data": {
"any": [
{
"where": s111,
"version": s113,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <!-- By default, Cyclone DDS multicasts only its announcements on Wi-Fi. -->\n      <AllowMulticast>true</AllowMulticast>\n    </General>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"multicast rate": {
"any": [
{
"where": s110,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Multicast and management frames are sent at the lowest basic rate, here 24 Mbit/s (in units of\n# 100 kbit/s). Old rates below it are switched off, but not those of 802.11n and later. A station\n# that is too far away for 24 Mbit/s cannot join.\n# Keep your band and channel.\nhw_mode=a\nchannel=36\nsupported_rates=240 360 480 540\nbasic_rates=240\n",
},
],
},
"peers": {
"Cyclone DDS": [
{
"where": s111,
"version": s113,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <AllowMulticast>false</AllowMulticast>\n    </General>\n    <Discovery>\n      <!-- Allow at least as many indices as a host has processes. -->\n      <ParticipantIndex>auto</ParticipantIndex>\n      <MaxAutoParticipantIndex>9</MaxAutoParticipantIndex>\n      <!-- Every host, this one included. -->\n      <Peers>\n        <Peer Address=\"192.168.1.21\"/>\n        <Peer Address=\"192.168.1.22\"/>\n        <Peer Address=\"192.168.1.23\"/>\n      </Peers>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
"DDS": [
{
"where": s115,
"version": "ROS 2 Jazzy",
"text": "# on every robot (ROS 2 Jazzy)\n# Load: both are environment variables of every ROS 2 process: run in the shell or put in\n# the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST\nexport ROS_STATIC_PEERS=\"192.168.1.22;192.168.1.23\"\n",
},
],
"Zenoh": [
{
"where": "for every process, which connects to robots with lower addresses",
"version": "Zenoh 1.10.2",
"text": "// for every process, which connects to robots with lower addresses (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n// The first process of a host takes port 7447, and each further process another port. A process\n// that connects to a first process learns of the others from it: gossip.\n{\n  mode: \"peer\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\", \"tcp/0.0.0.0:0\"], exit_on_failure: false },\n  connect: {\n    endpoints: [\n      // This host. Its first process reaches itself here, logs an error and tries again later.\n      \"tcp/127.0.0.1:7447#retry_period_init_ms=60000;retry_period_max_ms=60000\",\n      // Only robots with lower addresses: a pair that is linked twice sends its KeepAlives twice.\n      \"tcp/192.168.1.21:7447\",\n      \"tcp/192.168.1.22:7447\",\n    ],\n  },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: {\n      target: [\"router\", \"peer\"],\n      autoconnect_strategy: { peer: { to_router: \"always\", to_peer: \"greater-zid\" } },\n    },\n  },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 10000, // Zenoh's default: a KeepAlive every 2.5 s; rmw_zenoh sets 60000 and 2\n        keep_alive: 4,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
],
},
"processes": {
"any": [
{"where": "where Nav2 is started", "version": "ROS 2 Humble", "text": "# where Nav2 is started (ROS 2 Humble)\n# Load: run in a shell; the process is ros2 launch\n# Not run here: compared with its documentation\nros2 launch nav2_bringup bringup_launch.py use_composition:=True\n"},
{
"where": "a launch file for nodes of your own that are built as components",
"version": "ROS 2 Humble",
"text": "# a launch file for nodes of your own that are built as components (ROS 2 Humble)\n# Load: save as robot.launch.py; the process is ros2 launch robot.launch.py\n# Not run here: compared with its documentation\nfrom launch import LaunchDescription\nfrom launch_ros.actions import ComposableNodeContainer\nfrom launch_ros.descriptions import ComposableNode\n\n\ndef generate_launch_description():\n    nodes = [\n        ComposableNode(package=\"composition\", plugin=\"composition::Talker\", name=\"talker\"),\n        ComposableNode(package=\"composition\", plugin=\"composition::Listener\", name=\"listener\"),\n    ]\n    container = ComposableNodeContainer(\n        name=\"robot\",\n        namespace=\"\",\n        package=\"rclcpp_components\",\n        executable=\"component_container\",\n        composable_node_descriptions=nodes,\n    )\n    return LaunchDescription([container])\n",
},
],
},
"radio": {
"802.11n 40 MHz": [
{
"where": s110,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\n",
},
],
"802.11ac 80 MHz": [
{
"where": s110,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=1\nvht_oper_centr_freq_seg0_idx=42\nvht_capab=[SHORT-GI-80][MAX-A-MPDU-LEN-EXP7]\n",
},
],
"802.11ax 160 MHz": [
{
"where": s110,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Radars share channels 52 to 64, so hostapd needs your country's code.\ncountry_code=US\nieee80211d=1\nieee80211h=1\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=2\nvht_oper_centr_freq_seg0_idx=50\nvht_capab=[VHT160][SHORT-GI-80][SHORT-GI-160][MAX-A-MPDU-LEN-EXP7]\nieee80211ax=1\nhe_oper_chwidth=2\nhe_oper_centr_freq_seg0_idx=50\n",
},
],
},
"release": {},
"router": {
"any": [
s120,
{
"where": s111,
"version": "Zenoh 1.10.2",
"text": "// for every process (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n{\n  mode: \"client\",\n  connect: { endpoints: [\"tcp/192.168.1.10:7447\"] },\n  scouting: { multicast: { enabled: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
],
},
"router on each host": {
"any": [
{
"where": "on every robot for its router, which connects to lower addresses",
"version": "Zenoh 1.10.2",
"text": "// on every robot for its router, which connects to lower addresses (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  // Only robots with lower addresses: a pair that is linked twice sends its KeepAlives twice.\n  connect: { endpoints: [\"tcp/192.168.1.21:7447\", \"tcp/192.168.1.22:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
s121,
],
},
"staggered start": {
"any": [
{
"where": "where the programs of a robot are started",
"version": "bash 5.2",
"text": "# where the programs of a robot are started (tested with bash 5.2)\n# Load: put before the lines that start the processes, in the same bash script\n# Use one WINDOW on all robots, in whole seconds: the plan's, or a longer one. $RANDOM needs bash.\nWINDOW=60\nsleep \"$((RANDOM % WINDOW)).$((RANDOM % 10))\"\n",
},
],
},
"star of routers": {
"any": [
s120,
{
"where": "on every robot for its router, which connects only to the wired one",
"version": "Zenoh 1.10.2",
"text": "// on every robot for its router, which connects only to the wired one (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  // Only the router that is wired to the access point, and no robot.\n  connect: { endpoints: [\"tcp/192.168.1.10:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
s121,
],
},
"static endpoints": {
"any": [
{
"where": s111,
"version": s112,
"text": "<!-- for every process (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE); in ROS 2 it matches nothing without -->\n<!-- RMW_FASTRTPS_USE_QOS_FROM_XML=1 -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"robot\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <EDP>STATIC</EDP>\n            <static_edp_xml_config>file:///etc/fast_dds_static_endpoints.xml</static_edp_xml_config>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n    <!-- One for each endpoint of this process, by the name of its topic. -->\n    <data_writer profile_name=\"/robot1/odom\">\n      <userDefinedID>1</userDefinedID>\n    </data_writer>\n  </profiles>\n</dds>\n",
},
{
"where": s115,
"version": "Fast DDS 2.9, 2.14 and 3.6",
"text": "<!-- on every robot (tested with Fast DDS 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds_static_endpoints.xml, where the profile for every process -->\n<!-- looks for it; no environment variable of its own -->\n<staticdiscovery>\n  <!-- Every process, by the name of its participant (in ROS 2 its enclave), with all its\n       endpoints. Every endpoint has a number of its own. -->\n  <participant>\n    <name>/robot1</name>\n    <writer>\n      <userId>1</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </writer>\n  </participant>\n  <participant>\n    <name>/laptop</name>\n    <reader>\n      <userId>2</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </reader>\n  </participant>\n</staticdiscovery>\n",
},
],
},
"two discovery servers": {
"any": [
{
"where": "on two computers that are wired to the access point",
"version": s112,
"text": "# on two computers that are wired to the access point (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Run the first line on one computer, the second on the other, each with its own address.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\nfastdds discovery -i 1 -l 192.168.1.11 -p 11811\n",
},
{
"where": "on every robot (servers in this order)",
"version": s112,
"text": "# on every robot (servers in this order) (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: run\n# in the shell or put in the service file that starts the ROS 2 processes, before they start\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811;192.168.1.11:11811\"\n",
},
s117,
s118,
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
"group": s6,
"family": "DDS",
"product": null,
"tables": {"any": [s125, s128, s131, s132, s135, s138, ["middleware", "switching to Zenoh", "", "Zenoh", "DDS", "middleware"]]},
"about": "",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": "--ds-family-dds",
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s143,
"windows": s144,
"units": [s146, s148, s150],
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s151], ["SEDP", "unicast", 464, 1, 1, 1, "up down", s151], ["Heartbeat", "unicast", 116, 1, 2, 2, "up down", s151], ["ACKNACK", "unicast", 114, 1, 2, 2, "up down", s151]],
},
"Zenoh": {
"group": s6,
"family": "Zenoh",
"product": null,
"tables": {"any": [s155, s158, s161, ["peers", "static peers", "", "Zenoh, static peers", "Zenoh", "peers"], ["middleware", "switching to DDS", "", "DDS", "Zenoh", "middleware"]]},
"about": "",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s162,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s143,
"windows": s144,
"units": s163,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s151], ["Hello", "unicast", 144, 1, 1, 1, "up down", s151], ["Declare", "unicast", 176, 1, 2, 1, "up down", s151], s164],
},
"Cyclone DDS": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [[s78, s165, "", s166, "Cyclone DDS", s167], [s103, s168, "", s169, "Cyclone DDS", s170], s171, s174, s175, s176, s179, s182, s185, s187, s189, ["middleware", "switching to Fast DDS 2.14", "", "Fast DDS 2.14", "Cyclone DDS", "middleware"], s191],
"humble": [[s78, s165, "", s192, "Cyclone DDS", s167], [s103, s168, "", s193, "Cyclone DDS", s170], s171, s174, s175, s176, s179, s182, s185, s187, s189, ["middleware", "switching to Fast DDS 2.6", "", "Fast DDS 2.6", "Cyclone DDS", "middleware"], s191],
"kilted": [[s78, s165, "", s194, "Cyclone DDS", s167], [s103, s168, "", s195, "Cyclone DDS", s170], s171, s174, s175, s176, s179, s182, s185, s187, s189, ["middleware", s196, "", "Fast DDS 3.6", "Cyclone DDS", "middleware"], s191],
},
"about": s197,
"caution": s198,
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 60],
"band": s201,
"reboot": [1.45, 3.59],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s210,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s211],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s212],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s213],
["SEDP", "unicast", s214, 0.2218, 2, 1, "up down", s215],
["SEDP again", "unicast", s214, 0.2218, 3, 0.103, "up down", s215],
["Heartbeat", "unicast", s216, 0.5226, 1, 2, "up down", s215],
[s217, "unicast", s216, 0.5226, 1, 2.481, "up down", s215],
["ACKNACK", "unicast", s218, 0.402, 1, 4.635, "up down", s215],
[s219, "unicast", s218, 0.402, 4, 0.09896, "up down", s215],
s222,
[s223, "unicast", s224, 0.6253, 1, 1, "up down", s215],
[s225, "unicast", s224, 0.6253, 4, 0.1067, "up down", s215],
s228,
[s229, "unicast", s230, 0.4544, 1, 2.222, "up down", s215],
s232,
[s233, "unicast", s234, 0.3044, 1, 2.312, "up down", s215],
[s235, "unicast", s234, 0.3044, 4, 0.05208, "up down", s215],
[s236, "unicast", s237, 0.6806, 1, 2.333, "up down", s215],
[s238, "unicast", s239, 0.2641, 1, 2, "up down", s215],
[s240, "unicast", s239, 0.2641, 4, 0.2188, "up down", s215],
[s241, "unicast", s242, 0.6247, 5, 1.006, "up down", s215],
[s243, "unicast", s242, 0.6247, 6, 0.07217, "up down", s215],
["User ACKNACK", "unicast", s244, 0.338, 5, 1.404, "up down", s215],
[s245, "unicast", s244, 0.338, 6, 0.09793, "up down", s215],
],
},
"Cyclone DDS, wired": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s78, s165, s246, "Cyclone DDS, wired, switching to Fast DDS with a Discovery Server", s247, s167],
[s103, s168, s246, "Cyclone DDS, wired, switching to Fast DDS with two Discovery Servers", s247, s170],
[s102, s172, "", s102, s247, s173],
s135,
s138,
["router", s177, "", "Zenoh router", s247, s178],
[s98, s180, "", s157, s247, s181],
[s101, s183, "", s160, s247, s184],
["announcements", s186, "", "Cyclone DDS, wired, a longer announcement interval", s247, "announcements"],
["release", s248, "", "Cyclone DDS", s247, "release"],
["release", s188, "", s2, s247, "release"],
["middleware", s196, "", "Fast DDS 3.6", s247, "middleware"],
["middleware", s190, "", s154, s247, "middleware"],
],
},
"about": s249,
"caution": "Cyclone DDS in this form was not measured in an emulated Wi-Fi cell, where its form for Wi-Fi took up to 6.8 times as long as simulated",
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 20],
"band": s250,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s251,
"degree": 3,
"messages": [
s252,
["SPDP directed", "unicast", s253, 0.9963, 1, 0.6667, "up down", s213],
["SEDP", "unicast", s254, 0.1841, 2, 0.5833, "up down", s215],
[s255, "multicast", s256, 0.2228, 2, 0.1667, "up down", s215],
[s257, "multicast", 232, 0.25, 0, 2, "up down", s215],
["Heartbeat", "unicast", s258, 0.3287, 1, 3, "up down", s215],
["ACKNACK", "unicast", s259, 0.3715, 1, 4.05, "up down", s215],
[s219, "unicast", s259, 0.3715, 3, 0.2833, "up down", s215],
["Liveliness", "multicast", s220, 0.7242, 0, 1, "up down", s221],
[s223, "multicast", s260, 0.9582, 0, 0.3333, "up down", s215],
[s261, "unicast", 429, 0.2, 1, 0.5, "up down", s215],
[s226, "multicast", s227, 0.2758, 0, 1, "up down", s221],
[s229, "multicast", s262, 0.1767, 0, 0.875, "up down", s215],
[s263, "unicast", s264, 0.2117, 1, 1.625, "up down", s215],
s232,
[s233, "unicast", s265, 0.2807, 1, 2.344, "up down", s215],
[s235, "unicast", s265, 0.2807, 3, 0.07812, "up down", s215],
[s236, "multicast", s266, 0.1988, 0, 2, "up down", s215],
[s267, "unicast", s268, 0.1917, 1, 0.6667, "up down", s215],
[s238, "unicast", 211.5, 0.2, 1, 2, "up down", s215],
[s240, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s215],
[s241, "unicast", s269, 0.2427, 4, 0.75, "up down", s215],
[s270, "multicast", s271, 0.2152, 4, 0.25, "up down", s215],
["User ACKNACK", "unicast", s272, 0.2283, 4, 2, "up down", s215],
],
},
"Cyclone DDS, version 11": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s78, s165, s246, "Cyclone DDS, version 11, switching to Fast DDS with a Discovery Server", s2, s167],
[s103, s168, s246, "Cyclone DDS, version 11, switching to Fast DDS with two Discovery Servers", s2, s170],
[s102, s172, "", s102, s2, s173],
s135,
s138,
["router", s177, "", "Zenoh router", s2, s178],
[s98, s180, "", s157, s2, s181],
[s101, s183, "", s160, s2, s184],
["announcements", s186, "", "Cyclone DDS, version 11, a longer announcement interval", s2, "announcements"],
["release", s248, "", "Cyclone DDS", s2, "release"],
["middleware", s196, "", "Fast DDS 3.6", s2, "middleware"],
["middleware", s190, "", s154, s2, "middleware"],
],
},
"about": s273,
"caution": "Cyclone DDS 11 was not measured in an emulated Wi-Fi cell, where Cyclone DDS 0.10.5 took up to 6.8 times as long as simulated",
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 60],
"band": s274,
"reboot": [1.31, 3.21],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s210,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s211],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s212],
["SPDP directed", "unicast", s275, 0.9992, 1, 0.5413, "up down", s213],
["SEDP", "unicast", s276, 0.4598, 2, 1, "up down", s215],
["SEDP again", "unicast", s276, 0.4598, 3, 0.09093, "up down", s215],
["Heartbeat", "unicast", s277, 0.5475, 1, 2, "up down", s215],
[s217, "unicast", s277, 0.5475, 1, 2.833, "up down", s215],
["ACKNACK", "unicast", s278, 0.3982, 1, 5.167, "up down", s215],
[s219, "unicast", s278, 0.3982, 4, 0.125, "up down", s215],
s222,
[s223, "unicast", s279, 0.6519, 1, 1, "up down", s215],
[s225, "unicast", s279, 0.6519, 4, 0.09103, "up down", s215],
s228,
[s229, "unicast", s280, 0.4401, 1, 2.188, "up down", s215],
s232,
[s233, "unicast", s281, 0.2753, 1, 2.278, "up down", s215],
[s235, "unicast", s281, 0.2753, 4, 0.05556, "up down", s215],
[s236, "unicast", s282, 0.6399, 1, 2.542, "up down", s215],
[s238, "unicast", s283, 0.2385, 1, 2, "up down", s215],
[s240, "unicast", s283, 0.2385, 4, 0.1997, "up down", s215],
[s241, "unicast", s284, 0.6975, 5, 1.06, "up down", s215],
[s243, "unicast", s284, 0.6975, 6, 0.06995, "up down", s215],
["User ACKNACK", "unicast", s285, 0.4362, 5, 1.562, "up down", s215],
[s245, "unicast", s285, 0.4362, 6, 0.09399, "up down", s215],
],
},
"Cyclone DDS peers": {
"group": s5,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s78, s165, s246, "Cyclone DDS peers, switching to Fast DDS with a Discovery Server", s134, s167],
[s103, s168, s246, "Cyclone DDS peers, switching to Fast DDS with two Discovery Servers", s134, s170],
[s102, s172, "", s102, s134, s173],
[s95, s136, "", s137, s134, s95],
["router", s177, "", "Zenoh router", s134, s178],
[s98, s180, "", s157, s134, s181],
[s101, s183, "", s160, s134, s184],
["announcements", s186, "", "Cyclone DDS peers, a longer announcement interval", s134, "announcements"],
["middleware", s286, "", s2, s134, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s134, "middleware"],
["middleware", s190, "", s154, s134, "middleware"],
],
},
"about": s287,
"caution": s198,
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 10],
"band": s288,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s293,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s211],
[s294, "unicast", 448, 1, 1, 6, "up down", s295],
["SPDP directed", "unicast", s296, 0.9817, 2, 0.8333, "up down", s213],
["SEDP", "unicast", s297, 0.172, 3, 1, "up down", s215],
["SEDP again", "unicast", s298, 0.8001, 4, 0.08633, "up down", s215],
["Heartbeat", "unicast", s299, 0.5756, 2, 2, "up down", s215],
[s217, "unicast", s299, 0.5756, 2, 2.944, "up down", s215],
["ACKNACK", "unicast", s300, 0.3827, 2, 4.424, "up down", s215],
[s219, "unicast", s300, 0.3827, 5, 0.2049, "up down", s215],
["Liveliness", "unicast", s301, 0.7241, 2, 1, "up down", s221],
[s223, "unicast", s302, 0.7527, 2, 1, "up down", s215],
[s225, "unicast", s302, 0.7527, 5, 0.08333, "up down", s215],
[s226, "unicast", s303, 0.2759, 2, 1, "up down", s221],
[s229, "unicast", s304, 0.4258, 2, 2.556, "up down", s215],
[s231, "unicast", 128, 1, 2, 1, "up down", s221],
[s233, "unicast", s305, 0.265, 2, 2.296, "up down", s215],
[s235, "unicast", s305, 0.265, 5, 0.09271, "up down", s215],
[s236, "unicast", s306, 0.6431, 2, 3, "up down", s215],
[s238, "unicast", s307, 0.283, 2, 2, "up down", s215],
[s240, "unicast", s307, 0.283, 5, 0.3631, "up down", s215],
[s241, "unicast", s308, 0.5405, 6, 1.542, "up down", s215],
["User ACKNACK", "unicast", s309, 0.437, 6, 2.208, "up down", s215],
],
},
"Cyclone DDS multicast SEDP": {
"group": s5,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s78, s165, s246, "Cyclone DDS multicast SEDP, switching to Fast DDS with a Discovery Server", s137, s167],
[s103, s168, s246, "Cyclone DDS multicast SEDP, switching to Fast DDS with two Discovery Servers", s137, s170],
[s102, s172, "", s102, s137, s173],
["peers", "static peers", "", s134, s137, "peers"],
["router", s177, "", "Zenoh router", s137, s178],
[s98, s180, "", s157, s137, s181],
[s101, s183, "", s160, s137, s184],
["announcements", s186, "", "Cyclone DDS multicast SEDP, a longer announcement interval", s137, "announcements"],
["middleware", s286, "", s2, s137, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s137, "middleware"],
["middleware", s190, "", s154, s137, "middleware"],
],
},
"about": s310,
"caution": s198,
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 10],
"band": s311,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s251,
"degree": 3,
"messages": [
s252,
["SPDP directed", "unicast", s312, 0.9988, 1, 0.8, "up down", s213],
["SEDP", "unicast", s313, 0.2085, 2, 0.3719, "up down", s215],
[s255, "multicast", s314, 0.2222, 2, 0.23, "up down", s215],
[s257, "multicast", s315, 0.28, 0, 1.833, "up down", s215],
["Heartbeat", "unicast", s316, 0.3143, 1, 3.333, "up down", s215],
["ACKNACK", "unicast", s317, 0.3558, 1, 4.517, "up down", s215],
[s219, "unicast", s317, 0.3558, 3, 0.1494, "up down", s215],
["Liveliness", "multicast", s318, 0.724, 0, 1, "up down", s221],
[s223, "multicast", s319, 0.9539, 0, 0.8333, "up down", s215],
[s261, "unicast", s320, 0.15, 1, 0.5, "up down", s215],
[s226, "multicast", s321, 0.276, 0, 1, "up down", s221],
[s229, "multicast", s322, 0.2328, 0, 1, "up down", s215],
[s263, "unicast", s323, 0.2318, 1, 1.75, "up down", s215],
s232,
[s233, "unicast", s324, 0.2856, 1, 2.379, "up down", s215],
[s235, "unicast", s324, 0.2856, 3, 0.08854, "up down", s215],
[s236, "multicast", s325, 0.2325, 0, 2, "up down", s215],
[s267, "unicast", s326, 0.1726, 1, 1.167, "up down", s215],
[s238, "unicast", s327, 0.2088, 1, 2, "up down", s215],
[s240, "unicast", s327, 0.2088, 3, 0.3274, "up down", s215],
[s241, "unicast", s328, 0.4167, 4, 0.7917, "up down", s215],
[s270, "multicast", s329, 0.6667, 4, 0.1667, "up down", s215],
["User ACKNACK", "unicast", s330, 0.4167, 4, 2.167, "up down", s215],
],
},
"Fast DDS Discovery Server": {
"group": s5,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s103, s126, "", s127, s124, s103],
[s89, s129, "", s130, s124, s89],
[s102, s102, "", s102, s124, s102],
["peers", s331, "", s134, s124, s332],
[s95, s333, "", s137, s124, s334],
["router", s177, "", "Zenoh router", s124, s178],
[s98, s180, "", s157, s124, s181],
[s101, s183, "", s160, s124, s184],
["middleware", s286, "", s2, s124, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s124, "middleware"],
["middleware", s190, "", s154, s124, "middleware"],
],
},
"about": s335,
"caution": "",
"ratios": s336,
"server_ratios": s139,
"has_server": true,
"color": s337,
"measured": [8, 8, 10],
"band": s338,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s347,
"degree": 2,
"messages": s383,
},
"Fast DDS Discovery Server, two": {
"group": s5,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s122, "", s124, s127, s78],
[s89, s129, "", s130, s127, s89],
[s102, s102, "", s102, s127, s102],
["peers", s331, "", s134, s127, s332],
[s95, s333, "", s137, s127, s334],
["router", s177, "", "Zenoh router", s127, s178],
[s98, s180, "", s157, s127, s181],
[s101, s183, "", s160, s127, s184],
["middleware", s286, "", s2, s127, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s127, "middleware"],
["middleware", s190, "", s154, s127, "middleware"],
],
},
"about": s384,
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": true,
"color": s337,
"measured": [8, 8, 10],
"band": s386,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s347,
"degree": 2,
"messages": s387,
},
"Fast DDS Discovery Server, on a robot": {
"group": s5,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s122, "", s124, s130, s78],
[s103, s126, "", s127, s130, s103],
[s102, s102, "", s102, s130, s102],
["peers", s331, "", s134, s130, s332],
[s95, s333, "", s137, s130, s334],
["router", s177, "", "Zenoh router", s130, s178],
[s98, s180, "", s157, s130, s181],
[s101, s183, "", s160, s130, s184],
["middleware", s286, "", s2, s130, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s130, "middleware"],
["middleware", s190, "", s154, s130, "middleware"],
],
},
"about": "one server, on a robot with processes of its own; as the table of a wired one, on other hops (measured with 2.9.1)",
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": false,
"color": s337,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms within these sizes that we left out of the fit, discovery took 0.97 to 1.16 times the predicted airtime (typical error 3%). We expect 71% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": [[s388, s388, s388], [s208, s389, s389], [s390, s390, s390], [s208, {"count": "count21", "more": ["more52", "more53", "more43"]}, {"count": "count22", "more": ["more54", "more55", "more5"]}], s346, s209],
"degree": 2,
"messages": [
[s348, "unicast", 652, 1, 0, 1, "up down", s350],
[s351, "unicast", 700, 1, 0, 1, "up down", s352],
[s353, "unicast", s354, 0.865, 0, 1, "up down", s355],
[s356, "unicast", s357, 0.8517, 1, 1.967, "up down", s355],
[s358, "unicast", 192, 1, 0, 2, "up down", s355],
[s359, "unicast", s360, 0.5969, 0, 2.167, "up down", s355],
[s361, "unicast", s362, 0.3182, 1, 2.908, "up down", s355],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up down", s355],
[s363, "unicast", 190.2, 1, 1, 0.5083, "up down", s355],
[s364, "unicast", 188, 1, 0, 2, "up down", s355],
["SPDP Gap", "unicast", s365, 0.6193, 1, 1.6, "up down", s355],
[s366, "unicast", 1152, 0.45, 2, 1, "up down", s355],
[s367, "unicast", s368, 0.8446, 3, 1.237, "up down", s355],
["Heartbeat", "unicast", 192, 1, 0, 4, "up down", s355],
[s369, "unicast", 192, 1, 0, 4, "up down", s355],
[s370, "unicast", s371, 0.2358, 3, 1.892, "up down", s355],
["ACKNACK", "unicast", 188, 1, 0, 4, "up down", s355],
[s372, "unicast", 191.3, 1, 3, 0.45, "up down", s355],
[s373, "unicast", 188.5, 1, 0, 15.6, "up down", s355],
["Gap", "unicast", s374, 0.6838, 3, 0.645, "up down", s355],
[s375, "unicast", 192, 1, 0, 1, "up down", s355],
[s376, "unicast", 192, 1, 0, 2, "up down", s355],
s377,
[s378, "unicast", 188, 1, 0, 2, "up down", s355],
[s379, "unicast", 188, 1, 0, 2, "up down", s355],
s380,
s381,
s382,
],
},
"Fast DDS": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s122, "", s124, "Fast DDS", s78],
[s103, s126, "", s127, "Fast DDS", s103],
[s89, s129, "", s130, "Fast DDS", s89],
[s102, s102, "", s102, "Fast DDS", s102],
["peers", s331, "", s134, "Fast DDS", s332],
[s95, s333, "", s137, "Fast DDS", s334],
["router", s177, "", "Zenoh router", "Fast DDS", s178],
[s98, s180, "", s157, "Fast DDS", s181],
[s101, s183, "", s160, "Fast DDS", s184],
["announcements", s186, "", "Fast DDS, a longer announcement interval", "Fast DDS", "announcements"],
["release", s391, "", "Fast DDS 3.6", "Fast DDS", "release"],
["release", s392, "", "Fast DDS 2.6", "Fast DDS", "release"],
["release", s393, "", "Fast DDS 2.14", "Fast DDS", "release"],
["middleware", s286, "", s2, "Fast DDS", "middleware"],
["middleware", s190, "", s154, "Fast DDS", "middleware"],
],
},
"about": s394,
"caution": "",
"ratios": s385,
"server_ratios": {"measured": s79, "range": "1.63", "hosts": "8", "seconds": "15", "low": "1.63", "high": "1.63"},
"has_server": false,
"color": s337,
"measured": [8, 12, 60],
"band": s395,
"reboot": [1.21, 1.71],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s398,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s350],
[s399, "multicast", 580, 1, 1, 1, "up down", s355],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s402],
[s403, "unicast", 580, 1, 2, 1, "up down", s355],
[s404, "unicast", 580, 1, 3, 0.5, "up down", s355],
["SEDP", "unicast", s405, 0.6, 4, 1, "up down", s355],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s355],
[s217, "unicast", 184.3, 1, 2, 1.65, "up down", s355],
[s406, "unicast", 184.3, 1, 3, 0.4252, "up down", s355],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s355],
[s407, "unicast", 189.4, 1, 2, 2.072, "up down", s355],
[s219, "unicast", 189.4, 1, 3, 0.2616, "up down", s355],
[s226, "unicast", 192, 1, 2, 1.148, "up down", s355],
[s231, "unicast", 188, 1, 2, 1.148, "up down", s355],
[s241, "unicast", 192, 1, 5, 1.4, "up down", s355],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s355],
],
},
"Fast DDS 2.6": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s122, s123, s192, "Fast DDS", s78],
[s103, s126, s123, s193, "Fast DDS", s103],
s131,
s132,
["peers", s331, "", s134, "Fast DDS 2.6", s332],
[s95, s333, "", s137, "Fast DDS 2.6", s334],
["router", s177, "", "Zenoh router", "Fast DDS 2.6", s178],
[s98, s180, "", s157, "Fast DDS 2.6", s181],
[s101, s183, "", s160, "Fast DDS 2.6", s184],
["announcements", s186, "", "Fast DDS 2.6, a longer announcement interval", "Fast DDS 2.6", "announcements"],
["release", s391, "", "Fast DDS 3.6", "Fast DDS 2.6", "release"],
["release", s393, "", "Fast DDS 2.14", "Fast DDS 2.6", "release"],
["middleware", s408, "", "Cyclone DDS", "Fast DDS 2.6", "middleware"],
["middleware", s190, "", s154, "Fast DDS 2.6", "middleware"],
],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 2.6", "range": "0.93 to 1.97", "hosts": "12", "seconds": "15", "low": "0.93", "high": "1.97"},
"server_ratios": {"measured": "Fast DDS 2.6 with a Discovery Server", "range": "0.72 to 1.05", "hosts": "12", "seconds": "15", "low": "0.72", "high": "1.05"},
"has_server": false,
"color": s337,
"measured": [10, 20, 42],
"band": s409,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s398,
"degree": 3,
"messages": [
["SPDP", "multicast", 344, 1, 0, 1, "up down", s350],
[s399, "multicast", 344, 1, 1, 1, "up down", s355],
["SPDP unicast", "unicast", 344, 1, 2, 1, "up down", s402],
[s403, "unicast", 344, 1, 2, 1, "up down", s355],
[s404, "unicast", 344, 1, 3, 0.5, "up down", s355],
["SEDP", "unicast", s410, 0.6287, 4, 1, "up down", s355],
["Heartbeat", "unicast", 118.85, 1, 2, 2, "up down", s355],
[s217, "unicast", 118.85, 1, 2, 3.274, "up down", s355],
[s406, "unicast", 118.85, 1, 3, 0.4879, "up down", s355],
["ACKNACK", "unicast", 129.22, 1, 2, 2, "up down", s355],
[s407, "unicast", 129.22, 1, 2, 1.884, "up down", s355],
[s219, "unicast", 129.22, 1, 3, 0.3703, "up down", s355],
[s226, "unicast", 132, 1, 2, 1.125, "up down", s355],
[s231, "unicast", 128, 1, 2, 1.167, "up down", s355],
[s241, "unicast", 125.14, 1, 5, 1.575, "up down", s355],
["User ACKNACK", "unicast", 128.35, 1, 5, 1.429, "up down", s355],
[s411, "unicast", 501.7, 1, 2, 1.685, "up down", s355],
["ROS Heartbeat", "unicast", 125.14, 1, 2, 3.37, "up down", s355],
[s412, "unicast", 125.14, 1, 3, 0.1534, "up down", s355],
["ROS ACKNACK", "unicast", 128.35, 1, 2, 1.426, "up down", s355],
[s413, "unicast", 128.35, 1, 3, 0.1351, "up down", s355],
],
},
"Fast DDS 2.14": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s122, s123, s166, "Fast DDS", s78],
[s103, s126, s123, s169, "Fast DDS", s103],
s131,
s132,
["peers", s331, "", s134, "Fast DDS 2.14", s332],
[s95, s333, "", s137, "Fast DDS 2.14", s334],
["router", s177, "", "Zenoh router", "Fast DDS 2.14", s178],
[s98, s180, "", s157, "Fast DDS 2.14", s181],
[s101, s183, "", s160, "Fast DDS 2.14", s184],
["announcements", s186, "", "Fast DDS 2.14, a longer announcement interval", "Fast DDS 2.14", "announcements"],
["release", s391, "", "Fast DDS 3.6", "Fast DDS 2.14", "release"],
["release", s392, "", "Fast DDS 2.6", "Fast DDS 2.14", "release"],
["middleware", s408, "", "Cyclone DDS", "Fast DDS 2.14", "middleware"],
["middleware", s190, "", s154, "Fast DDS 2.14", "middleware"],
],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 2.14", "range": "0.82 to 1.19", "hosts": "12", "seconds": "15", "low": "0.82", "high": "1.19"},
"server_ratios": {"measured": "Fast DDS 2.14 with a Discovery Server", "range": "1.04 to 1.19", "hosts": "12", "seconds": "15", "low": "1.04", "high": "1.19"},
"has_server": false,
"color": s337,
"measured": [10, 20, 42],
"band": s414,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s415,
"degree": 3,
"messages": [
["SPDP", "multicast", 560, 1, 0, 1, "up down", s350],
["SPDP unicast", "unicast", 560, 1, 1, 1, "up down", s402],
[s403, "unicast", 560, 1, 1, 1, "up down", s355],
["SEDP", "unicast", s416, 0.6008, 2, 1, "up down", s355],
["Heartbeat", "unicast", 183.8, 1, 1, 2, "up down", s355],
[s217, "unicast", 183.8, 1, 1, 2.375, "up down", s355],
["ACKNACK", "unicast", 189.7, 1, 1, 2, "up down", s355],
[s407, "unicast", 189.7, 1, 1, 2.625, "up down", s355],
[s226, "unicast", 192, 1, 1, 1.125, "up down", s355],
[s231, "unicast", 188, 1, 1, 1.216, "up down", s355],
[s241, "unicast", 183.7, 1, 3, 1.5, "up down", s355],
["User ACKNACK", "unicast", 189, 1, 3, 1.554, "up down", s355],
[s411, "unicast", 480, 1, 1, 1.037, "up down", s355],
["ROS Heartbeat", "unicast", 183.7, 1, 1, 0.7995, "up down", s355],
[s412, "unicast", 183.7, 1, 4, 0.288, "up down", s355],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.9597, "up down", s355],
[s413, "unicast", 189, 1, 4, 0.1806, "up down", s355],
],
},
"Fast DDS 3.6": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [[s78, s122, s417, "Fast DDS 3.6, a Discovery Server", "Fast DDS", s78], [s103, s126, s417, "Fast DDS 3.6, two Discovery Servers", "Fast DDS", s103], s132, s418, s419, s420, s421, s422, s423, s424, s425, ["middleware", s286, "", s2, "Fast DDS 3.6", "middleware"], s426],
"kilted": [[s78, s122, s123, s194, "Fast DDS", s78], [s103, s126, s123, s195, "Fast DDS", s103], s131, s132, s418, s419, s420, s421, s422, s423, s424, s425, ["middleware", s408, "", "Cyclone DDS", "Fast DDS 3.6", "middleware"], s426],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 3.6", "range": "0.83 to 1.07", "hosts": "12", "seconds": "15", "low": "0.83", "high": "1.07"},
"server_ratios": {"measured": "Fast DDS 3.6 with a Discovery Server", "range": "1.09 to 1.15", "hosts": "12", "seconds": "15", "low": "1.09", "high": "1.15"},
"has_server": false,
"color": s337,
"measured": [10, 20, 42],
"band": s427,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s428,
"degree": 3,
"messages": [
["SPDP", "multicast", 632, 1, 0, 1, "up down", s350],
["SPDP unicast", "unicast", 632, 1, 1, 1, "up down", s402],
[s403, "unicast", 632, 1, 1, 1, "up down", s355],
["SEDP", "unicast", s429, 0.6318, 2, 1, "up down", s355],
["Heartbeat", "unicast", 184.3, 1, 1, 2, "up down", s355],
[s217, "unicast", 184.3, 1, 1, 2.13, "up down", s355],
["ACKNACK", "unicast", 189.6, 1, 1, 2, "up down", s355],
[s407, "unicast", 189.6, 1, 1, 2.204, "up down", s355],
[s226, "unicast", 192, 1, 1, 1.046, "up down", s355],
[s231, "unicast", 188, 1, 1, 1.083, "up down", s355],
[s241, "unicast", 178.8, 1, 3, 1.306, "up down", s355],
["User ACKNACK", "unicast", 189, 1, 3, 1.633, "up down", s355],
[s411, "unicast", 459.4, 1, 1, 1.15, "up down", s355],
[s236, "unicast", s430, 0.9914, 1, 2.303, "up down", s355],
[s238, "unicast", 188, 1, 1, 2.5, "up down", s355],
["Type lookup", "unicast", s431, 0.2383, 4, 3.917, "up down", s355],
["ROS Heartbeat", "unicast", 178.8, 1, 1, 3.687, "up down", s355],
[s412, "unicast", 178.8, 1, 5, 0.1285, "up down", s355],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.4578, "up down", s355],
[s413, "unicast", 189, 1, 5, 0.2066, "up down", s355],
],
},
"hybrid": {
"group": s8,
"family": null,
"product": null,
"tables": {"any": []},
"about": "this book's proposal, for hosts with unlike software",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s432,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s433,
"windows": s434,
"units": [s436, s146, s343, s438, s292],
"degree": 2,
"messages": [s440, s441, s442, s443, s444, s446, s447],
},
"hybrid, alike": {
"group": s8,
"family": null,
"product": null,
"tables": {"any": []},
"about": "this book's proposal, for hosts that are alike",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s432,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s433,
"windows": s434,
"units": [s436, s146, [s448, s448, s448], s438, s292],
"degree": 2,
"messages": [s440, s441, ["Software", "multicast", 8, 0, 0, 1, "up down", s439], s442, s443, s444, s446, s447],
},
"DDS, periods of Fast DDS": {
"group": s7,
"family": "DDS",
"product": null,
"tables": {"any": [s125, s128, s131, s132, s135, s138, ["middleware", s449, "", s450, s451, "middleware"], ["middleware", s452, "", s453, s451, "middleware"]]},
"about": "",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s337,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s163,
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s350], ["UnicastSPDP", "unicast", 414, 1, 1, 1, "up down", s350], ["SEDP", "unicast", 464, 1, 2, 1, "up down", s355], ["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s355], ["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s355]],
},
"DDS, periods of Cyclone DDS": {
"group": s7,
"family": "DDS",
"product": null,
"tables": {"any": [s125, s128, s131, s132, s135, s138, ["middleware", s454, "", s451, s450, "middleware"], ["middleware", s452, "", s453, s450, "middleware"]]},
"about": "",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s163,
"degree": 2,
"messages": [
["SPDP", "multicast", 414, 1, 0, 1, "up down", s211],
["DirectedSPDP", "unicast", 414, 1, 1, 1, "up down", s213],
["SEDP", "unicast", 464, 1, 2, 1, "up down", s215],
["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s215],
["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s215],
["Liveliness", "unicast", 180, 1, 1, 1, "up down", s295],
["LivelinessACK", "unicast", 114, 1, 1, 1, "up down", s295],
],
},
"Zenoh, periods of Zenoh peer": {
"group": s7,
"family": "Zenoh",
"product": null,
"tables": {"any": [s155, s158, s161, ["peers", "static peers", "", "Zenoh, periods of Zenoh peer, static peers", s453, "peers"], ["middleware", s454, "", s451, s453, "middleware"], ["middleware", s449, "", s450, s453, "middleware"]]},
"about": "",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s455,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s163,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s456], ["Hello", "unicast", 144, 1, 1, 1, "up down", s456], ["Declare", "unicast", 176, 1, 2, 1, "up down", s215], s458],
},
"static endpoints": {
"group": s5,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s122, "", s124, s102, s78],
[s103, s126, "", s127, s102, s103],
[s89, s129, "", s130, s102, s89],
["peers", s331, "", s134, s102, s332],
[s95, s333, "", s137, s102, s334],
["router", s177, "", "Zenoh router", s102, s178],
[s98, s180, "", s157, s102, s181],
[s101, s183, "", s160, s102, s184],
["announcements", s186, "", "static endpoints, a longer announcement interval", s102, "announcements"],
["middleware", s286, "", s2, s102, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s102, "middleware"],
["middleware", s190, "", s154, s102, "middleware"],
],
},
"about": s459,
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": false,
"color": s337,
"measured": [8, 8, 84],
"band": s460,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s339,
"windows": s340,
"units": s464,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s350],
[s399, "multicast", 589.2, 1, 1, 1, "up down", s355],
[s465, "multicast", 589.2, 1, 2, 1, "up down", s355],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s402],
[s403, "unicast", 589.2, 1, 3, 1, "up down", s355],
[s404, "unicast", 589.2, 1, 4, 0.5, "up down", s355],
[s466, "unicast", 589.2, 1, 5, 0.6542, "up down", s355],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s402],
[s467, "multicast", 59.47, 0, 6, 0.8987, "up down", s355],
[s468, "multicast", 59.47, 0, 7, 0.8987, "up down", s355],
[s469, "unicast", 59.47, 0, 5, 1, "up down", s402],
[s470, "unicast", 59.47, 0, 5, 0.9528, "up down", s355],
[s471, "unicast", 59.47, 0, 8, 0.4764, "up down", s355],
[s472, "unicast", 59.47, 0, 9, 0.6233, "up down", s355],
[s226, "unicast", 192, 1, 3, 1.167, "up down", s355],
[s231, "unicast", 188, 1, 3, 1.167, "up down", s355],
[s241, "unicast", 192, 1, 10, 1.33, "up down", s355],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s355],
],
},
"Zenoh peer": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s165, s246, "Zenoh peer, switching to Fast DDS with a Discovery Server", "Zenoh peer", s167],
[s103, s168, s246, "Zenoh peer, switching to Fast DDS with two Discovery Servers", "Zenoh peer", s170],
[s102, s172, "", s102, "Zenoh peer", s173],
["peers", s331, "", s134, "Zenoh peer", s332],
[s95, s333, "", s137, "Zenoh peer", s334],
s155,
s158,
s161,
["peers", "static peers", "", "Zenoh peer, static peers", "Zenoh peer", "peers"],
["middleware", s286, "", s2, "Zenoh peer", "middleware"],
["middleware", s196, "", "Fast DDS 3.6", "Zenoh peer", "middleware"],
],
},
"about": s473,
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s455,
"measured": [8, 12, 60],
"band": s474,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s476,
"degree": 3,
"messages": [
s477,
s478,
["Hello first", "unicast", 104, 1, 1, 0.5833, "up down", s215],
["InitSyn", "unicast", 110, 1, 1, 0.6667, "up down", s215],
s479,
s480,
s481,
["OAM", "unicast", s482, 0.835, 1, 1, "up down", s215],
[s483, "unicast", s482, 0.835, 2, 0.625, "up down", s215],
["Declare", "unicast", s484, 0.1957, 3, 0.5, "up down", s215],
[s485, "unicast", s486, 0.8037, 4, 0.5, "up down", s215],
[s487, "unicast", s486, 0.8037, 5, 0.5, "up down", s215],
["Declare final", "unicast", 176, 0.05, 1, 1, "up down", s215],
["Frame", "unicast", s488, 0.2478, 1, 1, "up down", s215],
[s489, "unicast", s488, 0.2478, 3, 0.6083, "up down", s215],
s490,
s491,
["TCP ACK", "unicast", 76, 1, 1, 0.8708, "up down", s457],
[s492, "unicast", 76, 1, 1, 2.496, "up down", s215],
[s493, "unicast", 76, 1, 3, 0.2188, "up down", s215],
],
},
"Zenoh peer, tokens": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s165, s246, "Zenoh peer, tokens, switching to Fast DDS with a Discovery Server", s154, s167],
[s103, s168, s246, "Zenoh peer, tokens, switching to Fast DDS with two Discovery Servers", s154, s170],
[s102, s172, "", s102, s154, s173],
["peers", s331, "", s134, s154, s332],
[s95, s333, "", s137, s154, s334],
["router", s152, "", "Zenoh router", s154, "router"],
[s98, s156, "", s157, s154, s98],
[s101, s159, "", s160, s154, s101],
["peers", "static peers", "", "Zenoh peer, tokens, static peers", s154, "peers"],
["middleware", s286, "", s2, s154, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s154, "middleware"],
],
},
"about": s494,
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s455,
"measured": [8, 12, 60],
"band": s495,
"reboot": [0.896, 1.43],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s476,
"degree": 3,
"messages": [
s477,
s478,
["Hello first", "unicast", 104, 1, 1, 0.5, "up down", s215],
["InitSyn", "unicast", 109.86, 1, 1, 0.6667, "up down", s215],
s479,
s480,
s481,
["OAM", "unicast", s496, 0.7058, 1, 1, "up down", s215],
[s483, "unicast", s496, 0.7058, 2, 0.6493, "up down", s215],
["Declare", "unicast", s497, 0.0655, 3, 0.5, "up down", s215],
["Declare token", "unicast", s498, 0.0603, 3, 1, "up down", s215],
[s499, "unicast", s498, 0.0603, 1, 1, "up down", s215],
[s485, "unicast", s500, 0.5972, 4, 1.5, "up down", s215],
[s487, "unicast", s500, 0.5972, 5, 2.5, "up down", s215],
[s501, "unicast", s500, 0.5972, 1, 1, "up down", s215],
["Declare final", "unicast", s502, 0.06, 1, 1, "up down", s215],
["Frame", "unicast", s503, 0.1352, 1, 2, "up down", s215],
[s489, "unicast", s503, 0.1352, 3, 1, "up down", s215],
s490,
s491,
["TCP ACK", "unicast", 76, 1, 1, 0.7208, "up down", s457],
[s492, "unicast", 76, 1, 1, 3.325, "up down", s215],
[s493, "unicast", 76, 1, 3, 0.4208, "up down", s215],
],
},
"Zenoh router": {
"group": s5,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s165, s246, "Zenoh router, switching to Fast DDS with a Discovery Server", "Zenoh router", s167],
[s103, s168, s246, "Zenoh router, switching to Fast DDS with two Discovery Servers", "Zenoh router", s170],
[s102, s172, "", s102, "Zenoh router", s173],
["peers", s331, "", s134, "Zenoh router", s332],
[s95, s333, "", s137, "Zenoh router", s334],
[s98, s156, "", s157, "Zenoh router", s98],
[s101, s159, "", s160, "Zenoh router", s101],
["middleware", s286, "", s2, "Zenoh router", "middleware"],
["middleware", s196, "", "Fast DDS 3.6", "Zenoh router", "middleware"],
["middleware", s190, "", s154, "Zenoh router", "middleware"],
],
},
"about": "one router, wired to the access point, and every process its client, with liveliness tokens, as rmw_zenoh has them (measured with 1.10.2)",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": true,
"color": s504,
"measured": [8, 12, 10],
"band": [[1, 1, 1, "In 7 swarms within these sizes that we left out of the fit, discovery took 0.84 to 1.18 times the predicted airtime (typical error 10%). We expect 75% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s505,
"windows": s506,
"units": [s146, s343, s507, [s208, {"count": "count30", "more": ["more69", "more70"]}, {"count": "count31", "more": ["more71", "more72"]}], s397, s461],
"degree": 2,
"messages": [
["TCP SYN", "unicast", 76, 1, 0, 1, "up", s508],
["TCP SYN-ACK", "unicast", 76, 1, 0, 1, "down", s508],
s509,
s510,
s511,
s512,
["Interest in tokens", "unicast", s513, 0.08917, 0, 1, "up", s508],
["Interest of publishers", "unicast", s513, 0.08917, 1, 0.5, "up", s508],
["Declare", "unicast", 144.9655172413793, 0.087, 1, 0.5, "up", s508],
[s499, "unicast", s514, 0.05144, 0, 1, "up", s508],
["Declare token", "unicast", s514, 0.05144, 1, 1, "up", s508],
[s501, "unicast", s515, 0.5213, 0, 2, "up", s508],
[s485, "unicast", s515, 0.5213, 1, 1.5, "up", s508],
["Declare key expression of unmatched", "unicast", s515, 0.5213, 2, 0.5, "up", s508],
["Frame up", "unicast", s516, 0.1456, 0, 1.417, "up", s508],
["Frame of endpoints up", "unicast", s516, 0.1456, 1, 1.292, "up", s508],
["Declare passed on", "unicast", 125.74016332590944, 0.1347, 3, 1, "down", s508],
["Declare token of own node", "unicast", s517, 0.0309, 0, 1, "down", s508],
["Declare own token", "unicast", s517, 0.0309, 1, 1, "down", s508],
["Declare token of node passed on", "unicast", s517, 0.0309, 4, 1, "down", s508],
["Declare token passed on", "unicast", s517, 0.0309, 5, 1, "down", s508],
["Declare key expression of node passed on", "unicast", s518, 0.3319, 4, 1, "down", s508],
["Declare key expression passed on", "unicast", s518, 0.3319, 5, 1, "down", s508],
["Declare final", "unicast", s519, 0.06875, 0, 1, "down", s508],
["Declare final to publishers", "unicast", s519, 0.06875, 1, 0.5, "down", s508],
["Frame down", "unicast", s520, 0.1116, 0, 3.188, "down", s508],
["Frame of endpoints down", "unicast", s520, 0.1116, 1, 1.206, "down", s508],
["Frame of others down", "unicast", s520, 0.1116, 5, 0.025, "down", s508],
["KeepAlive up", "unicast", 79, 1, 0, 1, "up", s522],
s523,
["TCP ACK up", "unicast", 76, 1, 0, 1, "up", s522],
["TCP ACK down", "unicast", 76, 1, 0, 0.5, "down", s522],
["TCP ACK at start up", "unicast", 76, 1, 0, 1.761, "up", s508],
["TCP ACK of endpoints up", "unicast", 76, 1, 1, 0.5636, "up", s508],
["TCP ACK of others up", "unicast", 76, 1, 4, 0.7871, "up", s508],
[s524, "unicast", 76, 1, 0, 4.104, "down", s508],
[s525, "unicast", 76, 1, 1, 0.07292, "down", s508],
],
},
"Zenoh router per host": {
"group": s5,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s165, s246, "Zenoh router per host, switching to Fast DDS with a Discovery Server", s157, s167],
[s103, s168, s246, "Zenoh router per host, switching to Fast DDS with two Discovery Servers", s157, s170],
[s102, s172, "", s102, s157, s173],
["peers", s331, "", s134, s157, s332],
[s95, s333, "", s137, s157, s334],
["router", s152, "", "Zenoh router", s157, "router"],
[s101, s159, "", s160, s157, s101],
["middleware", s286, "", s2, s157, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s157, "middleware"],
["middleware", s190, "", s154, s157, "middleware"],
],
},
"about": "a router on each host, as rmw_zenoh has it, linked with all others; processes meet their own host's on loopback (measured with 1.10.2)",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s504,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 11 swarms within these sizes that we left out of the fit, discovery took 0.84 to 1.25 times the predicted airtime (typical error 2%). We expect 83% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s505,
"windows": s506,
"units": [s292, [s526, s526, s526], [s527, s527, s527], s529, s530, s531, s290],
"degree": 4,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up down", s508],
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s508],
["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s508],
["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s508],
["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s508],
["OAM", "unicast", s532, 0.04144, 0, 2, "up down", s508],
["OAM of third hosts", "unicast", s533, 0.03176, 1, 0.3843, "up down", s508],
["OAM passed on", "unicast", s533, 0.03176, 2, 0.4715, "up down", s508],
[s534, "unicast", s535, 0.8637, 0, 4.25, "up down", s508],
["Frame of gossip passed on", "unicast", s535, 0.8637, 1, 1.6, "up down", s508],
[s489, "unicast", s535, 0.8637, 3, 0.775, "up down", s508],
["Declare", "unicast", s532, 0.004144, 4, 0.5, "up down", s508],
[s536, "unicast", s532, 0.004144, 5, 0.5, "up down", s508],
[s499, "unicast", s532, 0.004144, 6, 1, "up down", s508],
["Declare token", "unicast", s532, 0.004144, 3, 1, "up down", s508],
[s485, "unicast", s537, 0.1138, 4, 0.5, "up down", s508],
[s487, "unicast", s537, 0.1138, 5, 0.2634, "up down", s508],
[s538, "unicast", s537, 0.1138, 3, 1, "up down", s508],
[s501, "unicast", s537, 0.1138, 6, 1, "up down", s508],
["KeepAlive", "unicast", 79, 1, 0, 1, "up down", s522],
["TCP ACK", "unicast", 76, 1, 0, 0.55, "up down", s522],
[s492, "unicast", 76, 1, 0, 6.597, "up down", s508],
["TCP ACK of gossip", "unicast", 76, 1, 1, 0.2278, "up down", s508],
[s493, "unicast", 76, 1, 3, 0.1124, "up down", s508],
],
},
"Zenoh router per host, star": {
"group": s5,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s165, s246, "Zenoh router per host, star, switching to Fast DDS with a Discovery Server", s160, s167],
[s103, s168, s246, "Zenoh router per host, star, switching to Fast DDS with two Discovery Servers", s160, s170],
[s102, s172, "", s102, s160, s173],
["peers", s331, "", s134, s160, s332],
[s95, s333, "", s137, s160, s334],
["router", s152, "", "Zenoh router", s160, "router"],
[s98, s156, "", s157, s160, s98],
["middleware", s286, "", s2, s160, "middleware"],
["middleware", s196, "", "Fast DDS 3.6", s160, "middleware"],
["middleware", s190, "", s154, s160, "middleware"],
],
},
"about": "a router on each host, as rmw_zenoh has it, linked with one router that is wired to the access point; processes meet their own host's on loopback (measured with 1.10.2)",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": true,
"color": s504,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 6 swarms within these sizes that we left out of the fit, discovery took 0.85 to 1.18 times the predicted airtime (typical error 15%). We expect 71% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s505,
"windows": s506,
"units": [s436, s292, s343, s507, [s208, {"count": "count38", "more": ["more90", "more86"]}, {"count": "count39", "more": ["more91", "more89"]}], s146, s290, s530, s531, s529, s438],
"degree": 2,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up", s508],
["TCP control down", "unicast", 76, 1, 0, 1, "down", s508],
s509,
s510,
s511,
s512,
["OAM", "unicast", s539, 0.03601, 0, 2, "up", s508],
["OAM of others", "unicast", s539, 0.03601, 1, 1.045, "up", s508],
[s534, "unicast", s540, 0.8894, 0, 12.18, "up", s508],
[s489, "unicast", s540, 0.8894, 2, 0.4077, "up", s508],
["Declare", "unicast", s532, 0.004144, 3, 0.5, "up", s508],
[s536, "unicast", s532, 0.004144, 4, 0.5, "up", s508],
[s499, "unicast", s532, 0.004144, 5, 1, "up", s508],
["Declare token", "unicast", s532, 0.004144, 2, 1, "up", s508],
[s485, "unicast", s541, 0.1159, 3, 0.5, "up", s508],
[s487, "unicast", s541, 0.1159, 4, 0.1042, "up", s508],
[s538, "unicast", s541, 0.1159, 2, 1, "up", s508],
[s501, "unicast", s541, 0.1159, 5, 1, "up", s508],
["KeepAlive", "unicast", 79, 1, 0, 1, "up", s522],
["TCP ACK", "unicast", 76, 1, 0, 1, "up", s522],
[s492, "unicast", 76, 1, 0, 3.783, "up", s508],
["TCP ACK of processes", "unicast", 76, 1, 6, 1.217, "up", s508],
["OAM down", "unicast", s542, 0.04874, 0, 2, "down", s508],
["OAM of others down", "unicast", s542, 0.04874, 1, 1.045, "down", s508],
["Frame of gossip down", "unicast", 87.23315027458811, 0.8012, 0, 26.88, "down", s508],
["Declare down", "unicast", s543, 0.005525, 7, 0.5, "down", s508],
["Declare of matching down", "unicast", s543, 0.005525, 8, 0.5, "down", s508],
["Declare token of node down", "unicast", s543, 0.005525, 6, 1, "down", s508],
["Declare token down", "unicast", s543, 0.005525, 9, 1, "down", s508],
["Declare key expression down", "unicast", s541, 0.1159, 7, 0.5, "down", s508],
["Declare key expression of matching down", "unicast", s541, 0.1159, 8, 0.0625, "down", s508],
["Declare key expression of tokens down", "unicast", s541, 0.1159, 9, 1, "down", s508],
["Declare key expression of node down", "unicast", s541, 0.1159, 6, 1, "down", s508],
s523,
["TCP ACK down", "unicast", 76, 1, 10, 1, "down", s522],
[s524, "unicast", 76, 1, 0, 4.958, "down", s508],
[s525, "unicast", 76, 1, 2, 0.1354, "down", s508],
],
},
"Zenoh, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s162,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s143,
"windows": s144,
"units": s544,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s151], s164],
},
"Fast DDS 2.14 Discovery Server": s545,
"Fast DDS 2.14 Discovery Server, two": s546,
"Cyclone DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s197,
"caution": s198,
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 60],
"band": s201,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s210,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s549],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s550],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s551],
["SEDP", "unicast", s214, 0.2218, 2, 1, "up down", s552],
["SEDP again", "unicast", s214, 0.2218, 3, 0.103, "up down", s552],
["Heartbeat", "unicast", s216, 0.5226, 1, 2, "up down", s552],
[s217, "unicast", s216, 0.5226, 1, 2.481, "up down", s552],
["ACKNACK", "unicast", s218, 0.402, 1, 4.635, "up down", s552],
[s219, "unicast", s218, 0.402, 4, 0.09896, "up down", s552],
s555,
[s223, "unicast", s224, 0.6253, 1, 1, "up down", s552],
[s225, "unicast", s224, 0.6253, 4, 0.1067, "up down", s552],
s556,
[s229, "unicast", s230, 0.4544, 1, 2.222, "up down", s552],
s557,
[s233, "unicast", s234, 0.3044, 1, 2.312, "up down", s552],
[s235, "unicast", s234, 0.3044, 4, 0.05208, "up down", s552],
[s236, "unicast", s237, 0.6806, 1, 2.333, "up down", s552],
[s238, "unicast", s239, 0.2641, 1, 2, "up down", s552],
[s240, "unicast", s239, 0.2641, 4, 0.2188, "up down", s552],
[s241, "unicast", s242, 0.6247, 5, 1.006, "up down", s552],
[s243, "unicast", s242, 0.6247, 6, 0.07217, "up down", s552],
["User ACKNACK", "unicast", s244, 0.338, 5, 1.404, "up down", s552],
[s245, "unicast", s244, 0.338, 6, 0.09793, "up down", s552],
],
},
"Fast DDS 2.6 Discovery Server": s545,
"Fast DDS 2.6 Discovery Server, two": s546,
"Fast DDS 3.6 Discovery Server": s545,
"Fast DDS 3.6 Discovery Server, two": s546,
"Cyclone DDS, wired, switching to Fast DDS with a Discovery Server": s559,
"Cyclone DDS, wired, switching to Fast DDS with two Discovery Servers": s560,
"Cyclone DDS, wired, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s249,
"caution": s198,
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 20],
"band": s250,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s251,
"degree": 3,
"messages": [
s561,
["SPDP directed", "unicast", s253, 0.9963, 1, 0.6667, "up down", s551],
["SEDP", "unicast", s254, 0.1841, 2, 0.5833, "up down", s552],
[s255, "multicast", s256, 0.2228, 2, 0.1667, "up down", s552],
[s257, "multicast", 232, 0.25, 0, 2, "up down", s552],
["Heartbeat", "unicast", s258, 0.3287, 1, 3, "up down", s552],
["ACKNACK", "unicast", s259, 0.3715, 1, 4.05, "up down", s552],
[s219, "unicast", s259, 0.3715, 3, 0.2833, "up down", s552],
["Liveliness", "multicast", s220, 0.7242, 0, 1, "up down", s554],
[s223, "multicast", s260, 0.9582, 0, 0.3333, "up down", s552],
[s261, "unicast", 429, 0.2, 1, 0.5, "up down", s552],
[s226, "multicast", s227, 0.2758, 0, 1, "up down", s554],
[s229, "multicast", s262, 0.1767, 0, 0.875, "up down", s552],
[s263, "unicast", s264, 0.2117, 1, 1.625, "up down", s552],
s557,
[s233, "unicast", s265, 0.2807, 1, 2.344, "up down", s552],
[s235, "unicast", s265, 0.2807, 3, 0.07812, "up down", s552],
[s236, "multicast", s266, 0.1988, 0, 2, "up down", s552],
[s267, "unicast", s268, 0.1917, 1, 0.6667, "up down", s552],
[s238, "unicast", 211.5, 0.2, 1, 2, "up down", s552],
[s240, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s552],
[s241, "unicast", s269, 0.2427, 4, 0.75, "up down", s552],
[s270, "multicast", s271, 0.2152, 4, 0.25, "up down", s552],
["User ACKNACK", "unicast", s272, 0.2283, 4, 2, "up down", s552],
],
},
"Cyclone DDS, version 11, switching to Fast DDS with a Discovery Server": s559,
"Cyclone DDS, version 11, switching to Fast DDS with two Discovery Servers": s560,
"Cyclone DDS, version 11, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s273,
"caution": s198,
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 60],
"band": s274,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s210,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s549],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s550],
["SPDP directed", "unicast", s275, 0.9992, 1, 0.5413, "up down", s551],
["SEDP", "unicast", s276, 0.4598, 2, 1, "up down", s552],
["SEDP again", "unicast", s276, 0.4598, 3, 0.09093, "up down", s552],
["Heartbeat", "unicast", s277, 0.5475, 1, 2, "up down", s552],
[s217, "unicast", s277, 0.5475, 1, 2.833, "up down", s552],
["ACKNACK", "unicast", s278, 0.3982, 1, 5.167, "up down", s552],
[s219, "unicast", s278, 0.3982, 4, 0.125, "up down", s552],
s555,
[s223, "unicast", s279, 0.6519, 1, 1, "up down", s552],
[s225, "unicast", s279, 0.6519, 4, 0.09103, "up down", s552],
s556,
[s229, "unicast", s280, 0.4401, 1, 2.188, "up down", s552],
s557,
[s233, "unicast", s281, 0.2753, 1, 2.278, "up down", s552],
[s235, "unicast", s281, 0.2753, 4, 0.05556, "up down", s552],
[s236, "unicast", s282, 0.6399, 1, 2.542, "up down", s552],
[s238, "unicast", s283, 0.2385, 1, 2, "up down", s552],
[s240, "unicast", s283, 0.2385, 4, 0.1997, "up down", s552],
[s241, "unicast", s284, 0.6975, 5, 1.06, "up down", s552],
[s243, "unicast", s284, 0.6975, 6, 0.06995, "up down", s552],
["User ACKNACK", "unicast", s285, 0.4362, 5, 1.562, "up down", s552],
[s245, "unicast", s285, 0.4362, 6, 0.09399, "up down", s552],
],
},
"Cyclone DDS peers, switching to Fast DDS with a Discovery Server": s559,
"Cyclone DDS peers, switching to Fast DDS with two Discovery Servers": s560,
"Cyclone DDS peers, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s287,
"caution": s198,
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 10],
"band": s288,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s293,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s549],
[s294, "unicast", 448, 1, 1, 6, "up down", {"burst": 1, "second": 1.125, "lease": 0.135, "ever": 0.125}],
["SPDP directed", "unicast", s296, 0.9817, 2, 0.8333, "up down", s551],
["SEDP", "unicast", s297, 0.172, 3, 1, "up down", s552],
["SEDP again", "unicast", s298, 0.8001, 4, 0.08633, "up down", s552],
["Heartbeat", "unicast", s299, 0.5756, 2, 2, "up down", s552],
[s217, "unicast", s299, 0.5756, 2, 2.944, "up down", s552],
["ACKNACK", "unicast", s300, 0.3827, 2, 4.424, "up down", s552],
[s219, "unicast", s300, 0.3827, 5, 0.2049, "up down", s552],
["Liveliness", "unicast", s301, 0.7241, 2, 1, "up down", s554],
[s223, "unicast", s302, 0.7527, 2, 1, "up down", s552],
[s225, "unicast", s302, 0.7527, 5, 0.08333, "up down", s552],
[s226, "unicast", s303, 0.2759, 2, 1, "up down", s554],
[s229, "unicast", s304, 0.4258, 2, 2.556, "up down", s552],
[s231, "unicast", 128, 1, 2, 1, "up down", s554],
[s233, "unicast", s305, 0.265, 2, 2.296, "up down", s552],
[s235, "unicast", s305, 0.265, 5, 0.09271, "up down", s552],
[s236, "unicast", s306, 0.6431, 2, 3, "up down", s552],
[s238, "unicast", s307, 0.283, 2, 2, "up down", s552],
[s240, "unicast", s307, 0.283, 5, 0.3631, "up down", s552],
[s241, "unicast", s308, 0.5405, 6, 1.542, "up down", s552],
["User ACKNACK", "unicast", s309, 0.437, 6, 2.208, "up down", s552],
],
},
"Cyclone DDS multicast SEDP, switching to Fast DDS with a Discovery Server": s559,
"Cyclone DDS multicast SEDP, switching to Fast DDS with two Discovery Servers": s560,
"Cyclone DDS multicast SEDP, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s310,
"caution": s198,
"ratios": s199,
"server_ratios": s139,
"has_server": false,
"color": s200,
"measured": [8, 12, 10],
"band": s311,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s251,
"degree": 3,
"messages": [
s561,
["SPDP directed", "unicast", s312, 0.9988, 1, 0.8, "up down", s551],
["SEDP", "unicast", s313, 0.2085, 2, 0.3719, "up down", s552],
[s255, "multicast", s314, 0.2222, 2, 0.23, "up down", s552],
[s257, "multicast", s315, 0.28, 0, 1.833, "up down", s552],
["Heartbeat", "unicast", s316, 0.3143, 1, 3.333, "up down", s552],
["ACKNACK", "unicast", s317, 0.3558, 1, 4.517, "up down", s552],
[s219, "unicast", s317, 0.3558, 3, 0.1494, "up down", s552],
["Liveliness", "multicast", s318, 0.724, 0, 1, "up down", s554],
[s223, "multicast", s319, 0.9539, 0, 0.8333, "up down", s552],
[s261, "unicast", s320, 0.15, 1, 0.5, "up down", s552],
[s226, "multicast", s321, 0.276, 0, 1, "up down", s554],
[s229, "multicast", s322, 0.2328, 0, 1, "up down", s552],
[s263, "unicast", s323, 0.2318, 1, 1.75, "up down", s552],
s557,
[s233, "unicast", s324, 0.2856, 1, 2.379, "up down", s552],
[s235, "unicast", s324, 0.2856, 3, 0.08854, "up down", s552],
[s236, "multicast", s325, 0.2325, 0, 2, "up down", s552],
[s267, "unicast", s326, 0.1726, 1, 1.167, "up down", s552],
[s238, "unicast", s327, 0.2088, 1, 2, "up down", s552],
[s240, "unicast", s327, 0.2088, 3, 0.3274, "up down", s552],
[s241, "unicast", s328, 0.4167, 4, 0.7917, "up down", s552],
[s270, "multicast", s329, 0.6667, 4, 0.1667, "up down", s552],
["User ACKNACK", "unicast", s330, 0.4167, 4, 2.167, "up down", s552],
],
},
"Fast DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s394,
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": false,
"color": s337,
"measured": [8, 12, 60],
"band": s395,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s398,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s563],
[s399, "multicast", 580, 1, 1, 1, "up down", s552],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s564],
[s403, "unicast", 580, 1, 2, 1, "up down", s552],
[s404, "unicast", 580, 1, 3, 0.5, "up down", s552],
["SEDP", "unicast", s405, 0.6, 4, 1, "up down", s552],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s552],
[s217, "unicast", 184.3, 1, 2, 1.65, "up down", s552],
[s406, "unicast", 184.3, 1, 3, 0.4252, "up down", s552],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s552],
[s407, "unicast", 189.4, 1, 2, 2.072, "up down", s552],
[s219, "unicast", 189.4, 1, 3, 0.2616, "up down", s552],
[s226, "unicast", 192, 1, 2, 1.148, "up down", s552],
[s231, "unicast", 188, 1, 2, 1.148, "up down", s552],
[s241, "unicast", 192, 1, 5, 1.4, "up down", s552],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s552],
],
},
"Fast DDS 2.6, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": false,
"color": s337,
"measured": [10, 20, 42],
"band": s409,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s398,
"degree": 3,
"messages": [
["SPDP", "multicast", 344, 1, 0, 1, "up down", s563],
[s399, "multicast", 344, 1, 1, 1, "up down", s552],
["SPDP unicast", "unicast", 344, 1, 2, 1, "up down", s564],
[s403, "unicast", 344, 1, 2, 1, "up down", s552],
[s404, "unicast", 344, 1, 3, 0.5, "up down", s552],
["SEDP", "unicast", s410, 0.6287, 4, 1, "up down", s552],
["Heartbeat", "unicast", 118.85, 1, 2, 2, "up down", s552],
[s217, "unicast", 118.85, 1, 2, 3.274, "up down", s552],
[s406, "unicast", 118.85, 1, 3, 0.4879, "up down", s552],
["ACKNACK", "unicast", 129.22, 1, 2, 2, "up down", s552],
[s407, "unicast", 129.22, 1, 2, 1.884, "up down", s552],
[s219, "unicast", 129.22, 1, 3, 0.3703, "up down", s552],
[s226, "unicast", 132, 1, 2, 1.125, "up down", s552],
[s231, "unicast", 128, 1, 2, 1.167, "up down", s552],
[s241, "unicast", 125.14, 1, 5, 1.575, "up down", s552],
["User ACKNACK", "unicast", 128.35, 1, 5, 1.429, "up down", s552],
[s411, "unicast", 501.7, 1, 2, 1.685, "up down", s552],
["ROS Heartbeat", "unicast", 125.14, 1, 2, 3.37, "up down", s552],
[s412, "unicast", 125.14, 1, 3, 0.1534, "up down", s552],
["ROS ACKNACK", "unicast", 128.35, 1, 2, 1.426, "up down", s552],
[s413, "unicast", 128.35, 1, 3, 0.1351, "up down", s552],
],
},
"Fast DDS 2.14, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": false,
"color": s337,
"measured": [10, 20, 42],
"band": s414,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s415,
"degree": 3,
"messages": [
["SPDP", "multicast", 560, 1, 0, 1, "up down", s563],
["SPDP unicast", "unicast", 560, 1, 1, 1, "up down", s564],
[s403, "unicast", 560, 1, 1, 1, "up down", s552],
["SEDP", "unicast", s416, 0.6008, 2, 1, "up down", s552],
["Heartbeat", "unicast", 183.8, 1, 1, 2, "up down", s552],
[s217, "unicast", 183.8, 1, 1, 2.375, "up down", s552],
["ACKNACK", "unicast", 189.7, 1, 1, 2, "up down", s552],
[s407, "unicast", 189.7, 1, 1, 2.625, "up down", s552],
[s226, "unicast", 192, 1, 1, 1.125, "up down", s552],
[s231, "unicast", 188, 1, 1, 1.216, "up down", s552],
[s241, "unicast", 183.7, 1, 3, 1.5, "up down", s552],
["User ACKNACK", "unicast", 189, 1, 3, 1.554, "up down", s552],
[s411, "unicast", 480, 1, 1, 1.037, "up down", s552],
["ROS Heartbeat", "unicast", 183.7, 1, 1, 0.7995, "up down", s552],
[s412, "unicast", 183.7, 1, 4, 0.288, "up down", s552],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.9597, "up down", s552],
[s413, "unicast", 189, 1, 4, 0.1806, "up down", s552],
],
},
"Fast DDS 3.6, a Discovery Server": s559,
"Fast DDS 3.6, two Discovery Servers": s560,
"Fast DDS 3.6, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": false,
"color": s337,
"measured": [10, 20, 42],
"band": s427,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s428,
"degree": 3,
"messages": [
["SPDP", "multicast", 632, 1, 0, 1, "up down", s563],
["SPDP unicast", "unicast", 632, 1, 1, 1, "up down", s564],
[s403, "unicast", 632, 1, 1, 1, "up down", s552],
["SEDP", "unicast", s429, 0.6318, 2, 1, "up down", s552],
["Heartbeat", "unicast", 184.3, 1, 1, 2, "up down", s552],
[s217, "unicast", 184.3, 1, 1, 2.13, "up down", s552],
["ACKNACK", "unicast", 189.6, 1, 1, 2, "up down", s552],
[s407, "unicast", 189.6, 1, 1, 2.204, "up down", s552],
[s226, "unicast", 192, 1, 1, 1.046, "up down", s552],
[s231, "unicast", 188, 1, 1, 1.083, "up down", s552],
[s241, "unicast", 178.8, 1, 3, 1.306, "up down", s552],
["User ACKNACK", "unicast", 189, 1, 3, 1.633, "up down", s552],
[s411, "unicast", 459.4, 1, 1, 1.15, "up down", s552],
[s236, "unicast", s430, 0.9914, 1, 2.303, "up down", s552],
[s238, "unicast", 188, 1, 1, 2.5, "up down", s552],
["Type lookup", "unicast", s431, 0.2383, 4, 3.917, "up down", s552],
["ROS Heartbeat", "unicast", 178.8, 1, 1, 3.687, "up down", s552],
[s412, "unicast", 178.8, 1, 5, 0.1285, "up down", s552],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.4578, "up down", s552],
[s413, "unicast", 189, 1, 5, 0.2066, "up down", s552],
],
},
"Zenoh, periods of Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s455,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s544,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s215], s458],
},
"static endpoints, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s459,
"caution": "",
"ratios": s385,
"server_ratios": s139,
"has_server": false,
"color": s337,
"measured": [8, 8, 84],
"band": s460,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s547,
"windows": s548,
"units": s464,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s563],
[s399, "multicast", 589.2, 1, 1, 1, "up down", s552],
[s465, "multicast", 589.2, 1, 2, 1, "up down", s552],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s564],
[s403, "unicast", 589.2, 1, 3, 1, "up down", s552],
[s404, "unicast", 589.2, 1, 4, 0.5, "up down", s552],
[s466, "unicast", 589.2, 1, 5, 0.6542, "up down", s552],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s565],
[s467, "multicast", 59.47, 0, 6, 0.8987, "up down", s552],
[s468, "multicast", 59.47, 0, 7, 0.8987, "up down", s552],
[s469, "unicast", 59.47, 0, 5, 1, "up down", s565],
[s470, "unicast", 59.47, 0, 5, 0.9528, "up down", s552],
[s471, "unicast", 59.47, 0, 8, 0.4764, "up down", s552],
[s472, "unicast", 59.47, 0, 9, 0.6233, "up down", s552],
[s226, "unicast", 192, 1, 3, 1.167, "up down", s552],
[s231, "unicast", 188, 1, 3, 1.167, "up down", s552],
[s241, "unicast", 192, 1, 10, 1.33, "up down", s552],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s552],
],
},
"Zenoh peer, switching to Fast DDS with a Discovery Server": s559,
"Zenoh peer, switching to Fast DDS with two Discovery Servers": s560,
"Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": {"any": []},
"about": s473,
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s455,
"measured": [8, 12, 60],
"band": s474,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s566,
"degree": 3,
"messages": [
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s215],
s567,
s568,
s569,
["OAM", "unicast", s482, 0.835, 0, 1, "up down", s215],
[s483, "unicast", s482, 0.835, 1, 0.625, "up down", s215],
["Declare", "unicast", s484, 0.1957, 2, 0.5, "up down", s215],
[s485, "unicast", s486, 0.8037, 3, 0.5, "up down", s215],
[s487, "unicast", s486, 0.8037, 4, 0.5, "up down", s215],
["Declare final", "unicast", 176, 0.05, 0, 1, "up down", s215],
["Frame", "unicast", s488, 0.2478, 0, 1, "up down", s215],
[s489, "unicast", s488, 0.2478, 2, 0.6083, "up down", s215],
s571,
s572,
["TCP ACK", "unicast", 76, 1, 0, 0.6530673466326684, "up down", s457],
[s492, "unicast", 76, 1, 0, 2.496, "up down", s215],
[s493, "unicast", 76, 1, 2, 0.2188, "up down", s215],
],
},
"Zenoh peer, tokens, switching to Fast DDS with a Discovery Server": s559,
"Zenoh peer, tokens, switching to Fast DDS with two Discovery Servers": s560,
"Zenoh peer, tokens, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": {"any": []},
"about": s494,
"caution": "",
"ratios": s139,
"server_ratios": s139,
"has_server": false,
"color": s455,
"measured": [8, 12, 60],
"band": s495,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s202,
"windows": s203,
"units": s566,
"degree": 3,
"messages": [
["InitSyn", "unicast", 109.86, 1, 0, 0.5, "up down", s215],
s567,
s568,
s569,
["OAM", "unicast", s496, 0.7058, 0, 1, "up down", s215],
[s483, "unicast", s496, 0.7058, 1, 0.6493, "up down", s215],
["Declare", "unicast", s497, 0.0655, 2, 0.5, "up down", s215],
["Declare token", "unicast", s498, 0.0603, 2, 1, "up down", s215],
[s499, "unicast", s498, 0.0603, 0, 1, "up down", s215],
[s485, "unicast", s500, 0.5972, 3, 1.5, "up down", s215],
[s487, "unicast", s500, 0.5972, 4, 2.5, "up down", s215],
[s501, "unicast", s500, 0.5972, 0, 1, "up down", s215],
["Declare final", "unicast", s502, 0.06, 0, 1, "up down", s215],
["Frame", "unicast", s503, 0.1352, 0, 2, "up down", s215],
[s489, "unicast", s503, 0.1352, 2, 1, "up down", s215],
s571,
s572,
["TCP ACK", "unicast", 76, 1, 0, 0.5405729713514325, "up down", s457],
[s492, "unicast", 76, 1, 0, 3.325, "up down", s215],
[s493, "unicast", 76, 1, 2, 0.4208, "up down", s215],
],
},
"Zenoh router, switching to Fast DDS with a Discovery Server": s559,
"Zenoh router, switching to Fast DDS with two Discovery Servers": s560,
"Zenoh router per host, switching to Fast DDS with a Discovery Server": s559,
"Zenoh router per host, switching to Fast DDS with two Discovery Servers": s560,
"Zenoh router per host, star, switching to Fast DDS with a Discovery Server": s559,
"Zenoh router per host, star, switching to Fast DDS with two Discovery Servers": s560,
},
};
})();
