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
const s87 = ["radio", "setting"];
const s88 = "new or reconfigured radios and a setting";
const s89 = {"efforts": s87, "effort": 6, "takes": s88, "best_case": true, "cost": "the full gain needs full A-MPDUs; a queue may hold too few frames for one receiver; discovery cannot be complete before the last host starts"};
const s90 = "a configuration file";
const s91 = ["file", "setting"];
const s92 = "a configuration file and a setting";
const s93 = "one more program";
const s94 = ["server", "setting"];
const s95 = "one more program and a setting";
const s96 = "discovery server on a robot";
const s97 = {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "parameters cannot be set from outside a node; third-party nodes, such as Nav2's, must be rebuilt; we count a service as two endpoints, as in DDS"};
const s98 = ["build", "setting"];
const s99 = "rebuilt nodes and a setting";
const s100 = {"efforts": s98, "effort": 5, "takes": s99, "best_case": false, "cost": "parameters cannot be set from outside a node; third-party nodes, such as Nav2's, must be rebuilt; we count a service as two endpoints, as in DDS; discovery cannot be complete before the last host starts"};
const s101 = "another middleware";
const s102 = {"efforts": ["switch"], "effort": 8, "takes": s101, "best_case": false, "cost": "all hosts must change together"};
const s103 = ["switch", "server"];
const s104 = "another middleware and one more program";
const s105 = ["switch", "server", "setting"];
const s106 = "another middleware, one more program and a setting";
const s107 = "multicast endpoint data";
const s108 = ["switch", "file"];
const s109 = "another middleware and a configuration file";
const s110 = ["switch", "file", "setting"];
const s111 = "another middleware, a configuration file and a setting";
const s112 = "router on each host";
const s113 = ["switch", "servers"];
const s114 = "another middleware and several more programs";
const s115 = ["switch", "servers", "setting"];
const s116 = "another middleware, several more programs and a setting";
const s117 = ["switch", "setting"];
const s118 = "another middleware and a setting";
const s119 = {"efforts": s117, "effort": 8, "takes": s118, "best_case": false, "cost": "all hosts must change together; discovery cannot be complete before the last host starts"};
const s120 = "star of routers";
const s121 = "static endpoints";
const s122 = "two discovery servers";
const s123 = {"efforts": ["setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": "hosts too far away for this rate cannot join; no multicast or management frame may use a lower rate"};
const s124 = {"efforts": ["setting", "setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": "hosts too far away for this rate cannot join; no multicast or management frame may use a lower rate; discovery cannot be complete before the last host starts"};
const s125 = {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "only nodes built as components can be composed; a crash ends all composed nodes of its host"};
const s126 = {"efforts": s98, "effort": 5, "takes": s99, "best_case": false, "cost": "only nodes built as components can be composed; discovery cannot be complete before the last host starts; a crash ends all composed nodes of its host"};
const s127 = {"efforts": ["radio"], "effort": 6, "takes": s85, "best_case": false, "cost": "all hosts and the access point need this radio and must be close enough for its rate"};
const s128 = {"efforts": s87, "effort": 6, "takes": s88, "best_case": false, "cost": "all hosts and the access point need this radio and must be close enough for its rate; discovery cannot be complete before the last host starts"};
const s129 = {"efforts": ["upgrade"], "effort": 7, "takes": "another ROS release", "best_case": false, "cost": "all computers need the new ROS release; every package must be rebuilt and retested"};
const s130 = {"efforts": ["upgrade", "setting"], "effort": 7, "takes": "another ROS release and a setting", "best_case": false, "cost": "all computers need the new ROS release; every package must be rebuilt and retested; discovery cannot be complete before the last host starts"};
const s131 = "several more programs";
const s132 = ["servers", "setting"];
const s133 = "several more programs and a setting";
const s134 = {"efforts": ["setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": "discovery cannot be complete before the last host starts"};
const s135 = "hostapd.conf of the access point";
const s136 = "for every process";
const s137 = "Fast DDS 2.6, 2.9, 2.14 and 3.6";
const s138 = "Cyclone DDS 0.10.2 and 11.0.1";
const s139 = "on a computer that is wired to the access point";
const s140 = "on every robot";
const s141 = {
"where": s140,
"version": s137,
"text": "# on every robot (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: set\n# it in the shell or service file that starts the ROS 2 processes\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\n",
};
const s142 = {
"where": "for ros2 tools",
"version": "Fast DDS 2.6, 2.14 and 3.6",
"text": "# for ros2 tools (tested with Fast DDS 2.6, 2.14 and 3.6)\n# Load: both are environment variables of ros2 and its daemon: export them in the shell of\n# the tools, then ros2 daemon stop\n# Fast DDS reads ROS_SUPER_CLIENT from 2.6.7 on (ROS 2 Humble), 2.10.3 (Iron) and 2.13.0 (Jazzy and\n# later). Older releases, such as 2.9.1, ignore it: use the profile of a SUPER_CLIENT.\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\nexport ROS_SUPER_CLIENT=TRUE\n",
};
const s143 = {
"where": "for older ros2 tools that ignore ROS_SUPER_CLIENT",
"version": "Fast DDS 2.9.1",
"text": "<!-- for older ros2 tools that ignore ROS_SUPER_CLIENT (tested with Fast DDS 2.9.1) -->\n<!-- Load: save as /etc/fast_dds_tools.xml; ros2 and its daemon run with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds_tools.xml and without ROS_DISCOVERY_SERVER; -->\n<!-- begin with ros2 daemon stop; Fast DDS 3 refuses this file -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"super_client\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SUPER_CLIENT</discoveryProtocol>\n            <discoveryServersList>\n              <RemoteServer prefix=\"44.53.00.5f.45.50.52.4f.53.49.4d.41\">\n                <metatrafficUnicastLocatorList>\n                  <locator>\n                    <udpv4>\n                      <address>192.168.1.10</address>\n                      <port>11811</port>\n                    </udpv4>\n                  </locator>\n                </metatrafficUnicastLocatorList>\n              </RemoteServer>\n            </discoveryServersList>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
};
const s144 = "on every computer";
const s145 = {
"where": s139,
"version": "Zenoh 1.10.2",
"text": "// on a computer that is wired to the access point (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s146 = {
"where": "for every process of a robot",
"version": "Zenoh 1.10.2",
"text": "// for every process of a robot (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n{\n  mode: \"peer\",\n  connect: { endpoints: [\"tcp/localhost:7447\"] },\n  listen: { endpoints: [\"tcp/localhost:0\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: {\n      target: { router: [\"router\", \"peer\"], peer: [\"router\"] },\n      autoconnect_strategy: { peer: { to_router: \"always\", to_peer: \"greater-zid\" } },\n    },\n  },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s147 = "a Discovery Server";
const s148 = "both values use the measured model of Fast DDS";
const s149 = "Fast DDS Discovery Server";
const s150 = [s78, s147, s148, s149, "Fast DDS", s78];
const s151 = "two Discovery Servers";
const s152 = "Fast DDS Discovery Server, two";
const s153 = [s122, s151, s148, s152, "Fast DDS", s122];
const s154 = "a Discovery Server on a robot";
const s155 = "Fast DDS Discovery Server, on a robot";
const s156 = [s96, s154, s148, s155, "Fast DDS", s96];
const s157 = [s121, s121, s148, s121, "Fast DDS", s121];
const s158 = "both values use the measured model of Cyclone DDS";
const s159 = "Cyclone DDS peers";
const s160 = ["peers", "static peers", s158, s159, "Cyclone DDS", "peers"];
const s161 = "multicast SEDP announcements";
const s162 = "Cyclone DDS multicast SEDP";
const s163 = [s107, s161, s158, s162, "Cyclone DDS", s107];
const s164 = {"measured": "", "range": "0.5 to 2", "hosts": "0", "seconds": "0", "low": "0.5", "high": "2"};
const s165 = [1, "within a second at best"];
const s166 = [Infinity, "leases at risk"];
const s167 = "never catches up";
const s168 = {"until": [s165, [Infinity, "slow at best"], s166], "never": s167};
const s169 = {"second": 1, "ever": Infinity};
const s170 = {"count": "count", "more": ["more", "more2"]};
const s171 = [s170, s170, s170];
const s172 = {"count": "count2", "more": ["more3", "more4", "more5"]};
const s173 = [s172, s172, s172];
const s174 = {"count": "count3", "more": ["more6", "more7", "more8"]};
const s175 = [s174, s174, s174];
const s176 = {"burst": 1, "second": 1, "ever": 0};
const s177 = "a central router";
const s178 = "both values use the measured model of Zenoh peer with tokens";
const s179 = "Zenoh peer, tokens";
const s180 = ["router", s177, s178, "Zenoh router", s179, "router"];
const s181 = "a router on each host";
const s182 = "Zenoh router per host";
const s183 = [s112, s181, s178, s182, s179, s112];
const s184 = "a router on each host plus a wired router";
const s185 = "Zenoh router per host, star";
const s186 = [s120, s184, s178, s185, s179, s120];
const s187 = "--ds-family-zenoh";
const s188 = [s171, s175, s173];
const s189 = ["KeepAlive", "unicast", 84, 1, 1, 2, "up down", s176];
const s190 = "switching to Fast DDS with a Discovery Server";
const s191 = "Fast DDS 2.14 Discovery Server";
const s192 = "middleware and discovery server";
const s193 = "switching to Fast DDS with two Discovery Servers";
const s194 = "Fast DDS 2.14 Discovery Server, two";
const s195 = "middleware and two discovery servers";
const s196 = [s96, "switching to Fast DDS with a Discovery Server on a robot", "", s155, "Cyclone DDS", "middleware and discovery server on a robot"];
const s197 = "switching to Fast DDS with static endpoints";
const s198 = "middleware and static endpoints";
const s199 = [s121, s197, "", s121, "Cyclone DDS", s198];
const s200 = ["peers", "static peers", "", s159, "Cyclone DDS", "peers"];
const s201 = [s107, s161, "", s162, "Cyclone DDS", s107];
const s202 = "switching to Zenoh with a central router";
const s203 = "middleware and router";
const s204 = ["router", s202, "", "Zenoh router", "Cyclone DDS", s203];
const s205 = "switching to Zenoh with a router on each host";
const s206 = "middleware and router on each host";
const s207 = [s112, s205, "", s182, "Cyclone DDS", s206];
const s208 = "switching to Zenoh with a router on each host plus a wired router";
const s209 = "middleware and star of routers";
const s210 = [s120, s208, "", s185, "Cyclone DDS", s209];
const s211 = "a longer announcement interval";
const s212 = ["announcements", s211, "", "Cyclone DDS, a longer announcement interval", "Cyclone DDS", "announcements"];
const s213 = "moving to ROS 2 Lyrical (Cyclone DDS, version 11)";
const s214 = ["release", s213, "", s2, "Cyclone DDS", "release"];
const s215 = "switching to Zenoh peer, tokens";
const s216 = ["middleware", s215, "", s179, "Cyclone DDS", "middleware"];
const s217 = "Fast DDS 2.6 Discovery Server";
const s218 = "Fast DDS 2.6 Discovery Server, two";
const s219 = "Fast DDS 3.6 Discovery Server";
const s220 = "Fast DDS 3.6 Discovery Server, two";
const s221 = "switching to Fast DDS 3.6";
const s222 = "on a network that it takes for Wi-Fi: multicast for SPDP alone (measured with 0.10.2)";
const s223 = "in an emulated Wi-Fi cell without frame aggregation, real Cyclone DDS 0.10.5 took 3.6 to 6.8 times as long as in our simulation, and 8 robots had completed only 19% of discovery after 12 s";
const s224 = {"measured": "Cyclone DDS", "range": "0.08 to 6.76", "hosts": "8", "seconds": "12", "low": "0.08", "high": "6.76"};
const s225 = "--ds-product-cyclone-dds";
const s226 = [
[1, 1.67, 11.3, "In 24 swarms that were not used for the fit (within these limits), discovery took 0.68 to 1.26 times the predicted airtime (typical error 9%). We expect 92% of such swarms to be in this range"],
[2, 1.67, 11.3, "In 9 swarms that were not used for the fit (within twice these limits), discovery took 0.94 to 1.44 times the predicted airtime (typical error 16%). We expect 80% of such swarms to be in this range"],
[Infinity, 1.67, 11.3, "In 2 swarms that were not used for the fit (with up to 11 times as many endpoints), discovery took 1.31 to 1.47 times the predicted airtime (typical error 39%). That is too few swarms for a confidence interval"],
];
const s227 = {"until": [s165, [10, "slow at best"], s166], "never": s167};
const s228 = {"second": 1, "lease": 10, "ever": Infinity};
const s229 = {"count": "count4", "more": ["more9", "more10", "more11", "more12"]};
const s230 = [s229, s229, s229];
const s231 = {"count": "count5", "more": ["more13", "more14", "more15", "more16"]};
const s232 = [s231, s231, s231];
const s233 = {"count": "count6", "more": []};
const s234 = [s233, {"count": "count7", "more": ["more17", "more18", "more19"]}, {"count": "count8", "more": ["more20", "more21", "more22"]}];
const s235 = [s171, s175, s173, s230, s232, s234, [s233, {"count": "count9", "more": ["more23", "more24", "more25", "more26"]}, {"count": "count10", "more": ["more27", "more28", "more29", "more30"]}]];
const s236 = {"burst": 1.9875, "second": 2.1125, "lease": 0.32375, "ever": 0.125};
const s237 = {"burst": 0.9875, "second": 1.1125, "lease": 0.22375, "ever": 0.125};
const s238 = {"burst": 4, "second": 4, "lease": 0.4, "ever": 0};
const s239 = 972.4761045987376;
const s240 = {"burst": 1, "second": 1, "lease": 0.1, "ever": 0};
const s241 = 154.45158821278227;
const s242 = "Heartbeat of data";
const s243 = 187.0099502487562;
const s244 = "ACKNACK for others";
const s245 = 179.99005799502902;
const s246 = {"burst": 0, "second": 0.125, "lease": 0.125, "ever": 0.125};
const s247 = ["Liveliness", "unicast", s245, 0.7242, 1, 1, "up down", s246];
const s248 = "Liveliness at start";
const s249 = 190.54725731648807;
const s250 = "Liveliness for others";
const s251 = "Liveliness Heartbeat";
const s252 = 180.02610587382162;
const s253 = [s251, "unicast", s252, 0.2758, 1, 1, "up down", s246];
const s254 = "Liveliness Heartbeat at start";
const s255 = 153.8987676056338;
const s256 = "Liveliness ACKNACK";
const s257 = [s256, "unicast", 128, 1, 1, 1, "up down", s246];
const s258 = "Liveliness ACKNACK at start";
const s259 = 181.3784494086728;
const s260 = "Liveliness ACKNACK for others";
const s261 = "Type lookup Heartbeat";
const s262 = 129.08962679988247;
const s263 = "Type lookup ACKNACK";
const s264 = 195.20030291556228;
const s265 = "Type lookup ACKNACK for others";
const s266 = "User Heartbeat";
const s267 = 139.31615175284134;
const s268 = "User Heartbeat for others";
const s269 = 182.43195266272187;
const s270 = "User ACKNACK for others";
const s271 = "the server forwards everything, as in Fast DDS 3.6";
const s272 = "Cyclone DDS, wired";
const s273 = "moving to ROS 2 Jazzy (Cyclone DDS)";
const s274 = "on a network that it takes for wired, with three processes or more: multicast for SEDP and control, too (measured with 0.10.2)";
const s275 = [[1, 1, 1, "In 7 swarms that were not used for the fit (within these limits), discovery took 0.95 to 1.13 times the predicted airtime (typical error 5%). We expect 75% of such swarms to be in this range"]];
const s276 = [s171, s175, s173, s232, s234];
const s277 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s236];
const s278 = 493.08762420957544;
const s279 = 1167.7479630635523;
const s280 = "SEDP multicast";
const s281 = 961.6660682226212;
const s282 = "Heartbeat multicast";
const s283 = 201.42013994523882;
const s284 = 199.39703903095557;
const s285 = 150.79816322270926;
const s286 = "Liveliness unicast";
const s287 = 245.09790605546124;
const s288 = "Liveliness Heartbeat unicast";
const s289 = 234.05196032120926;
const s290 = 187.1920199501247;
const s291 = 224.96579476861166;
const s292 = "Type lookup Heartbeat unicast";
const s293 = 230.92749087115283;
const s294 = 230.46065100947672;
const s295 = "User Heartbeat multicast";
const s296 = 232.6802973977695;
const s297 = 226.06745510293473;
const s298 = "as Cyclone DDS, with type information in SEDP (measured with 11.0.1)";
const s299 = [
[1, 1.67, 11.3, "In 26 swarms that were not used for the fit (within these limits), discovery took 0.72 to 1.32 times the predicted airtime (typical error 9%). We expect 93% of such swarms to be in this range"],
[2, 1.67, 11.3, "In 11 swarms that were not used for the fit (within twice these limits), discovery took 1.00 to 1.43 times the predicted airtime (typical error 22%). We expect 83% of such swarms to be in this range"],
[Infinity, 1.67, 11.3, "In 2 swarms that were not used for the fit (with up to 11 times as many endpoints), discovery took 1.28 to 1.48 times the predicted airtime (typical error 38%). That is too few swarms for a confidence interval"],
];
const s300 = 432.2946357085669;
const s301 = 726.2444541104828;
const s302 = 153.93607305936075;
const s303 = 186.8277247614264;
const s304 = 187.05568338702255;
const s305 = 156.2517609634174;
const s306 = 190.87976752633492;
const s307 = 132.5107047976246;
const s308 = 204.12578616352204;
const s309 = 133.94982078853047;
const s310 = 167.8055937643283;
const s311 = "switching to Cyclone DDS 11";
const s312 = "AllowMulticast=false, all hosts as Peers, ParticipantIndex=auto and MaxAutoParticipantIndex=9, its default (measured with 0.10.2)";
const s313 = [[1, 1, 1, "In 7 swarms that were not used for the fit (within these limits), discovery took 0.94 to 1.33 times the predicted airtime (typical error 5%). We expect 75% of such swarms to be in this range"]];
const s314 = {"count": "count11", "more": ["more31", "more32", "more2"]};
const s315 = [s314, s314, s314];
const s316 = {"count": "count12", "more": ["more33", "more34", "more35"]};
const s317 = [s316, s316, s316];
const s318 = [s315, s317, s175, s173, s230, s232, s234];
const s319 = "ICMP unreachable";
const s320 = {"burst": 1, "second": 1.125, "lease": 0.225, "ever": 0.125};
const s321 = 442.0177243557095;
const s322 = 1224.46511627907;
const s323 = 334.84114485689287;
const s324 = 150.13620569840168;
const s325 = 191.25372354324537;
const s326 = 180.00607650876952;
const s327 = 170.0050484920951;
const s328 = 179.9840521928235;
const s329 = 156.0150305307656;
const s330 = 190.60377358490564;
const s331 = 134.67330119732546;
const s332 = 185.2367491166078;
const s333 = 147.20074005550418;
const s334 = 166.51716247139586;
const s335 = "AllowMulticast=true, as it chooses on a network that it takes for wired: of three processes or more (measured with 0.10.2)";
const s336 = [[1, 1, 1, "In 7 swarms that were not used for the fit (within these limits), discovery took 0.91 to 1.10 times the predicted airtime (typical error 8%). We expect 75% of such swarms to be in this range"]];
const s337 = 492.4140969162995;
const s338 = 1040.4988009592325;
const s339 = 965.8901890189019;
const s340 = 215.89285714285714;
const s341 = 213.31594018453706;
const s342 = 200.7060146149522;
const s343 = 180.02209944751382;
const s344 = 152.05954502568403;
const s345 = 510.6666666666667;
const s346 = 179.94202898550725;
const s347 = 201.4570446735395;
const s348 = 219.65142364106987;
const s349 = 186.30392156862746;
const s350 = 207.01075268817203;
const s351 = 249.3997682502897;
const s352 = 210.50383141762453;
const s353 = 176.79097672186225;
const s354 = 122.00209989500526;
const s355 = 167.19174466042716;
const s356 = "switching to Cyclone DDS with static peers";
const s357 = "middleware and peers";
const s358 = "switching to Cyclone DDS with multicast SEDP announcements";
const s359 = "middleware and multicast endpoint data";
const s360 = "one server, wired to the access point (measured with 2.9.1)";
const s361 = {"measured": s149, "range": "0.72 to 1.63", "hosts": "12", "seconds": "15", "low": "0.72", "high": "1.63"};
const s362 = "--ds-product-fast-dds";
const s363 = [[1, 1, 1, "In 6 swarms that were not used for the fit (within these limits), discovery took 1.00 to 1.10 times the predicted airtime (typical error 4%). We expect 71% of such swarms to be in this range"]];
const s364 = {"until": [s165, [20, "slow at best"], s166], "never": s167};
const s365 = {"second": 1, "lease": 20, "ever": Infinity};
const s366 = {"count": "count13", "more": ["more36", "more37", "more38"]};
const s367 = {"count": "count14", "more": ["more39", "more40"]};
const s368 = [s367, s367, s367];
const s369 = {"count": "count16", "more": ["more44", "more45", "more5"]};
const s370 = {"count": "count17", "more": ["more46", "more47", "more38"]};
const s371 = [s233, s370, s370];
const s372 = [s171, [s233, s366, s366], s368, [s233, {"count": "count15", "more": ["more41", "more42", "more43"]}, s369], s371, s234];
const s373 = "SPDP to server";
const s374 = 0.3333333333333333;
const s375 = {"burst": 5.833333333333333, "second": 6.166666666666666, "lease": 0.625, "ever": s374};
const s376 = "SPDP of server";
const s377 = {"burst": 0.5, "second": 0.8333333333333333, "lease": 0.35833333333333334, "ever": s374};
const s378 = "SPDP of server at discovery";
const s379 = 748.3930635838151;
const s380 = {"burst": 1, "second": 1, "lease": 0.05, "ever": 0};
const s381 = "SPDP of others";
const s382 = 683.9365973934484;
const s383 = "SPDP Heartbeat";
const s384 = "SPDP Heartbeat of server";
const s385 = 250.29586195342605;
const s386 = "SPDP Heartbeat of others";
const s387 = 354.98051539912007;
const s388 = "SPDP ACKNACK of others";
const s389 = "SPDP ACKNACK of server";
const s390 = 204.14209591474247;
const s391 = "SEDP to server";
const s392 = "SEDP of others";
const s393 = 655.9962112242481;
const s394 = "Heartbeat of server";
const s395 = "Heartbeat of others";
const s396 = 451.4893977947413;
const s397 = "ACKNACK of others";
const s398 = "ACKNACK of server";
const s399 = 205.97133664814274;
const s400 = "Liveliness Heartbeat to server";
const s401 = "Liveliness Heartbeat of server";
const s402 = [s251, "unicast", 192, 1, 4, 1.292, "up down", s380];
const s403 = "Liveliness ACKNACK to server";
const s404 = "Liveliness ACKNACK of server";
const s405 = [s256, "unicast", 188, 1, 4, 1.292, "up down", s380];
const s406 = [s266, "unicast", 192, 1, 5, 1.021, "up down", s380];
const s407 = ["User ACKNACK", "unicast", 188, 1, 5, 1.021, "up down", s380];
const s408 = [
[s373, "unicast", 652, 1, 0, 1, "up", s375],
[s376, "unicast", 700, 1, 0, 1, "down", s377],
[s378, "unicast", s379, 0.865, 0, 1, "down", s380],
[s381, "unicast", s382, 0.8517, 1, 1.967, "down", s380],
[s383, "unicast", 192, 1, 0, 2, "up", s380],
[s384, "unicast", s385, 0.5969, 0, 2.167, "down", s380],
[s386, "unicast", s387, 0.3182, 1, 2.908, "down", s380],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up", s380],
[s388, "unicast", 190.2, 1, 1, 0.5083, "up", s380],
[s389, "unicast", 188, 1, 0, 2, "down", s380],
["SPDP Gap", "unicast", s390, 0.6193, 1, 1.6, "down", s380],
[s391, "unicast", 1152, 0.45, 2, 1, "up", s380],
[s392, "unicast", s393, 0.8446, 3, 1.237, "down", s380],
["Heartbeat", "unicast", 192, 1, 0, 4, "up", s380],
[s394, "unicast", 192, 1, 0, 4, "down", s380],
[s395, "unicast", s396, 0.2358, 3, 1.892, "down", s380],
["ACKNACK", "unicast", 188, 1, 0, 4, "up", s380],
[s397, "unicast", 191.3, 1, 3, 0.45, "up", s380],
[s398, "unicast", 188.5, 1, 0, 15.6, "down", s380],
["Gap", "unicast", s399, 0.6838, 3, 0.645, "down", s380],
[s400, "unicast", 192, 1, 0, 1, "up", s380],
[s401, "unicast", 192, 1, 0, 2, "down", s380],
s402,
[s403, "unicast", 188, 1, 0, 2, "up", s380],
[s404, "unicast", 188, 1, 0, 2, "down", s380],
s405,
s406,
s407,
];
const s409 = "two servers that know nothing of each other, both wired to the access point; clients of both (measured with 2.9.1)";
const s410 = {"measured": "Fast DDS", "range": "0.97 to 2.03", "hosts": "8", "seconds": "15", "low": "0.97", "high": "2.03"};
const s411 = [[1, 1, 1, "In 6 swarms that were not used for the fit (within these limits), discovery took 1.00 to 1.05 times the predicted airtime (typical error 2%). We expect 71% of such swarms to be in this range"]];
const s412 = [
[s373, "unicast", 636, 1, 0, 2, "up", s375],
[s376, "unicast", 700, 1, 0, 2, "down", s377],
[s378, "unicast", 747.8396673212429, 0.8657, 0, 2, "down", s380],
[s381, "unicast", 684.0093940817285, 0.8516, 1, 3.9, "down", s380],
[s383, "unicast", 192, 1, 0, 4, "up", s380],
[s384, "unicast", 244.85106382978725, 0.6204, 0, 4.625, "down", s380],
[s386, "unicast", 402.48973607038124, 0.2728, 1, 5.942, "down", s380],
["SPDP ACKNACK", "unicast", 189.8, 1, 0, 4.625, "up", s380],
[s388, "unicast", 190.5, 1, 1, 0.9417, "up", s380],
[s389, "unicast", 188, 1, 0, 4, "down", s380],
["SPDP Gap", "unicast", 199.09006997171358, 0.6717, 1, 3.333, "down", s380],
[s391, "unicast", 1257.7301004163605, 0.4083, 2, 2, "up", s380],
[s392, "unicast", s393, 0.8446, 3, 2.45, "down", s380],
["Heartbeat", "unicast", 184, 1, 0, 8, "up", s380],
[s394, "unicast", 192, 1, 0, 8, "down", s380],
[s395, "unicast", 432.5140562248996, 0.249, 3, 3.242, "down", s380],
["ACKNACK", "unicast", 188, 1, 0, 8, "up", s380],
[s397, "unicast", 190.8, 1, 3, 0.85, "up", s380],
[s398, "unicast", 188.5, 1, 0, 31.6, "down", s380],
["Gap", "unicast", 207.54580397181294, 0.6244, 3, 1.03, "down", s380],
[s400, "unicast", 192, 1, 0, 2, "up", s380],
[s401, "unicast", 192, 1, 0, 4, "down", s380],
[s251, "unicast", 192, 1, 4, 1.208, "up down", s380],
[s403, "unicast", 188, 1, 0, 4, "up", s380],
[s404, "unicast", 188, 1, 0, 4, "down", s380],
[s256, "unicast", 188, 1, 4, 1.208, "up down", s380],
[s266, "unicast", 192, 1, 5, 1.08, "up down", s380],
["User ACKNACK", "unicast", 188, 1, 5, 1.179, "up down", s380],
];
const s413 = {"count": "count18", "more": ["more48", "more2"]};
const s414 = {"count": "count19", "more": ["more49", "more50", "more38"]};
const s415 = {"count": "count20", "more": ["more51", "more40"]};
const s416 = "moving to ROS 2 Lyrical (Fast DDS 3.6)";
const s417 = "moving to ROS 2 Humble (Fast DDS 2.6)";
const s418 = "moving to ROS 2 Jazzy (Fast DDS 2.14)";
const s419 = "with UDP and shared memory, as shipped and as ROS 2 sets it (measured with 2.9.1)";
const s420 = [
[1, 1.67, 11.3, "In 11 swarms that were not used for the fit (within these limits), discovery took 0.91 to 1.04 times the predicted airtime (typical error 3%). We expect 83% of such swarms to be in this range"],
[2, 1.67, 11.3, "In 2 swarms that were not used for the fit (within twice these limits), discovery took 0.95 to 1.22 times the predicted airtime (typical error 13%). That is too few swarms for a confidence interval"],
[Infinity, 1.67, 11.3, "In 2 swarms that were not used for the fit (with up to 11 times as many endpoints), discovery took 2.06 to 2.29 times the predicted airtime (typical error 118%). That is too few swarms for a confidence interval"],
];
const s421 = {"count": "count23", "more": ["more56", "more57", "more8"]};
const s422 = [s421, s421, s421];
const s423 = [s171, s422, s175, s232, s173, s234];
const s424 = "SPDP at discovery";
const s425 = 4.833333333333333;
const s426 = 5.166666666666666;
const s427 = {"burst": s425, "second": s426, "lease": 0.575, "ever": s374};
const s428 = "SPDP unicast at discovery";
const s429 = "SPDP unicast for others";
const s430 = 852.6666666666666;
const s431 = "Heartbeat for others";
const s432 = "ACKNACK of data";
const s433 = "switching to Cyclone DDS";
const s434 = [[1, 1, 1, "In 19 swarms that were not used for the fit (within these limits), discovery took 0.86 to 1.68 times the predicted airtime (typical error 14%). We expect 90% of such swarms to be in this range"]];
const s435 = 773.5594083028471;
const s436 = "ROS discovery info";
const s437 = "ROS Heartbeat for others";
const s438 = "ROS ACKNACK for others";
const s439 = [[1, 1, 1, "In 16 swarms that were not used for the fit (within these limits), discovery took 0.89 to 1.17 times the predicted airtime (typical error 5%). We expect 88% of such swarms to be in this range"]];
const s440 = [s171, s175, s173, s234, s232];
const s441 = 1014.7323568575234;
const s442 = "both values use the measured model of Fast DDS, and the server forwards everything, as in Fast DDS 3.6";
const s443 = ["peers", s356, "", s159, "Fast DDS 3.6", s357];
const s444 = [s107, s358, "", s162, "Fast DDS 3.6", s359];
const s445 = ["router", s202, "", "Zenoh router", "Fast DDS 3.6", s203];
const s446 = [s112, s205, "", s182, "Fast DDS 3.6", s206];
const s447 = [s120, s208, "", s185, "Fast DDS 3.6", s209];
const s448 = ["announcements", s211, "", "Fast DDS 3.6, a longer announcement interval", "Fast DDS 3.6", "announcements"];
const s449 = ["release", s417, "", "Fast DDS 2.6", "Fast DDS 3.6", "release"];
const s450 = ["release", s418, "", "Fast DDS 2.14", "Fast DDS 3.6", "release"];
const s451 = ["middleware", s215, "", s179, "Fast DDS 3.6", "middleware"];
const s452 = [[1, 1, 1, "In 64 of 68 swarms that were not used for the fit (within these limits), discovery took 0.90 to 1.57 times the predicted airtime (typical error 6%). We expect 91% of such swarms to be in this range"]];
const s453 = [s171, s175, s173, s234, [s233, s233, s233], s232];
const s454 = 896.8584995251663;
const s455 = 189.68085535606212;
const s456 = 808.8594208980277;
const s457 = "--ds-basis-proposal";
const s458 = {"until": [s165, [23, "slow at best"], s166], "never": s167};
const s459 = {"second": 1, "lease": 23, "ever": Infinity};
const s460 = {"count": "count24", "more": ["more58", "more35"]};
const s461 = [s460, s460, s460];
const s462 = {"count": "more35", "more": ["more35"]};
const s463 = [s462, s462, s462];
const s464 = {"burst": 1, "second": 1, "lease": 0.043478260869565216, "ever": 0};
const s465 = ["Announce", "multicast", 80, 1, 0, 1, "up down", s464];
const s466 = ["Process", "multicast", 24, 0, 1, 1, "up down", s464];
const s467 = ["Endpoint", "multicast", 20, 0, 2, 1, "up down", s464];
const s468 = ["Digest", "multicast", 80, 1, 3, 1, "up down", s464];
const s469 = ["Listed", "multicast", 1, 0, 0, 1, "up down", s464];
const s470 = {"burst": 0, "second": s374, "lease": s374, "ever": s374};
const s471 = ["Heartbeat", "multicast", 80, 1, 0, 1, "up down", s470];
const s472 = ["Claimed", "multicast", 0.125, 0, 4, 1, "up down", s470];
const s473 = {"count": "count25", "more": ["count25"]};
const s474 = "switching to DDS with the timers of Cyclone DDS";
const s475 = "DDS, periods of Cyclone DDS";
const s476 = "DDS, periods of Fast DDS";
const s477 = "switching to Zenoh with the timers of Zenoh peer";
const s478 = "Zenoh, periods of Zenoh peer";
const s479 = "switching to DDS with the timers of Fast DDS";
const s480 = "--ds-product-zenoh";
const s481 = {"burst": 3.125, "second": 3.25, "lease": 0.4375, "ever": 0.125};
const s482 = {"burst": 0, "second": 0.4, "lease": 0.4, "ever": 0.4};
const s483 = ["KeepAlive", "unicast", 84, 1, 1, 1, "up down", s482];
const s484 = "Fast DDS with endpoints that are known in advance (static EDP), participants announced as ever (measured with 2.9.1)";
const s485 = [[1, 1, 1, "In 10 swarms that were not used for the fit (within these limits), discovery took 0.95 to 1.31 times the predicted airtime (typical error 5%). We expect 82% of such swarms to be in this range"]];
const s486 = [s369, s369, s369];
const s487 = {"count": "count26", "more": ["more59", "more60"]};
const s488 = {"count": "count27", "more": ["more61", "more62", "more63"]};
const s489 = [s171, s422, s368, s175, s232, s173, s486, [s487, s487, s487], s230, [s488, s488, s488], s234];
const s490 = "SPDP of endpoints";
const s491 = "SPDP unicast of endpoints";
const s492 = "Listed at discovery";
const s493 = "Listed of endpoints";
const s494 = "Listed unicast";
const s495 = "Listed unicast at discovery";
const s496 = "Listed unicast for others";
const s497 = "Listed unicast of endpoints";
const s498 = "peers, each linked with each other (measured with 1.10.2)";
const s499 = [[1, 1, 1, "In 10 swarms that were not used for the fit (within these limits), discovery took 0.86 to 1.12 times the predicted airtime (typical error 8%). We expect 82% of such swarms to be in this range"]];
const s500 = [s172, {"count": "count28", "more": ["more64", "more65", "more66"]}, s233];
const s501 = [s171, s175, s232, s173, s500, s234];
const s502 = ["Scout", "multicast", 67, 1, 0, 1, "up down", s481];
const s503 = ["Hello", "unicast", 104, 1, 1, 1, "up down", {"burst": 2.125, "second": 2.25, "lease": 0.3375, "ever": 0.125}];
const s504 = ["InitAck", "unicast", 153, 1, 1, 0.6667, "up down", s240];
const s505 = ["OpenSyn", "unicast", 134, 1, 1, 0.6667, "up down", s240];
const s506 = ["OpenAck", "unicast", 84, 1, 1, 0.6667, "up down", s240];
const s507 = 163.4251497005988;
const s508 = "OAM for others";
const s509 = 106.65917220235053;
const s510 = "Declare key expression";
const s511 = 229.04217991787982;
const s512 = "Declare key expression of matching";
const s513 = 112.31961259079904;
const s514 = "Frame of endpoints";
const s515 = ["KeepAlive", "unicast", 79, 1, 1, 1.333, "up down", s482];
const s516 = ["TCP control", "unicast", 76, 1, 1, 1.333, "up down", s240];
const s517 = "TCP ACK at start";
const s518 = "TCP ACK of endpoints";
const s519 = "with liveliness tokens, as rmw_zenoh has them, and a subscriber to all of them (measured with 1.10.2)";
const s520 = [
[1, 1.67, 11.3, "In 12 swarms that were not used for the fit (within these limits), discovery took 0.90 to 1.41 times the predicted airtime (typical error 6%). We expect 85% of such swarms to be in this range"],
[2, 1.67, 11.3, "In 4 swarms that were not used for the fit (within twice these limits), discovery took 0.99 to 1.02 times the predicted airtime (typical error 1%). That is too few swarms for a confidence interval"],
[Infinity, 1.67, 11.3, "In 2 swarms that were not used for the fit (with up to 11 times as many endpoints), discovery took 0.93 to 1.15 times the predicted airtime (typical error 11%). That is too few swarms for a confidence interval"],
];
const s521 = 179.4287333522244;
const s522 = 167.6030534351145;
const s523 = 175.50248756218906;
const s524 = "Declare token of node";
const s525 = 362.8385800401876;
const s526 = "Declare key expression of node";
const s527 = 159.33333333333334;
const s528 = 142.56804733727813;
const s529 = "--ds-product-rmw-zenoh";
const s530 = {"until": [s165, [60, "slow at best"], s166], "never": s167};
const s531 = {"second": 1, "lease": 60, "ever": Infinity};
const s532 = [s367, {"count": "count29", "more": ["more67", "more68"]}, s233];
const s533 = {"burst": 1, "second": 1, "lease": 0.016666666666666666, "ever": 0};
const s534 = ["InitSyn", "unicast", 110, 1, 0, 1, "up", s533];
const s535 = ["InitAck", "unicast", 153, 1, 0, 1, "down", s533];
const s536 = ["OpenSyn", "unicast", 134, 1, 0, 1, "up", s533];
const s537 = ["OpenAck", "unicast", 84, 1, 0, 1, "down", s533];
const s538 = 154.5017382527756;
const s539 = 192.6407465007776;
const s540 = 358.9464799539613;
const s541 = 137.8131868131868;
const s542 = 282.5695792880259;
const s543 = 622.248870141609;
const s544 = 148.72727272727272;
const s545 = 156.64516129032256;
const s546 = 0.03333333333333333;
const s547 = {"burst": 0, "second": s546, "lease": s546, "ever": s546};
const s548 = ["KeepAlive down", "unicast", 79, 1, 0, 1, "down", s547];
const s549 = "TCP ACK at start down";
const s550 = "TCP ACK of endpoints down";
const s551 = {"count": "count32", "more": ["more73", "more74", "more75", "more35"]};
const s552 = {"count": "count33", "more": ["more76", "more77", "more78", "more79", "more35"]};
const s553 = {"count": "count34", "more": ["more80", "more81", "more40"]};
const s554 = [s553, s553, s553];
const s555 = [s553, {"count": "count35", "more": ["more82", "more83", "more68"]}, s233];
const s556 = [s233, {"count": "count36", "more": ["more84", "more85", "more86"]}, {"count": "count37", "more": ["more87", "more88", "more89"]}];
const s557 = 1523.8764478764479;
const s558 = 1523.7329974811084;
const s559 = "Frame of gossip";
const s560 = 86.42028482111844;
const s561 = "Declare of matching";
const s562 = 1523.275922671353;
const s563 = "Declare key expression of tokens";
const s564 = 1524.2088308803109;
const s565 = 86.11918147065437;
const s566 = 1524.6626402070751;
const s567 = 1523.8867459991793;
const s568 = 1523.9638009049772;
const s569 = [s173, s175];
const s570 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s360,
"caution": "",
"ratios": s361,
"server_ratios": s164,
"has_server": true,
"color": s362,
"measured": [8, 8, 10],
"band": s363,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s372,
"degree": 2,
"messages": s408,
};
const s571 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s409,
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": true,
"color": s362,
"measured": [8, 8, 10],
"band": s411,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s372,
"degree": 2,
"messages": s412,
};
const s572 = {"until": [s165, [100, "slow at best"], s166], "never": s167};
const s573 = {"second": 1, "lease": 100, "ever": Infinity};
const s574 = {"burst": 1.9966666666666666, "second": 2.03, "lease": 0.0533, "ever": s546};
const s575 = {"burst": 0.9966666666666667, "second": 1.03, "lease": 0.0433, "ever": s546};
const s576 = {"burst": 4, "second": 4, "lease": 0.04, "ever": 0};
const s577 = {"burst": 1, "second": 1, "lease": 0.01, "ever": 0};
const s578 = 0.01020408163265306;
const s579 = {"burst": 0, "second": s578, "lease": s578, "ever": s578};
const s580 = ["Liveliness", "unicast", s245, 0.7242, 1, 1, "up down", s579];
const s581 = [s251, "unicast", s252, 0.2758, 1, 1, "up down", s579];
const s582 = [s256, "unicast", 128, 1, 1, 1, "up down", s579];
const s583 = [s171, s422, s368, s486, s371, s234];
const s584 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s360,
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": true,
"color": s362,
"measured": [8, 8, 10],
"band": s363,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s583,
"degree": 2,
"messages": s408,
};
const s585 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s409,
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": true,
"color": s362,
"measured": [8, 8, 10],
"band": s411,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s583,
"degree": 2,
"messages": s412,
};
const s586 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s574];
const s587 = 0.06666666666666667;
const s588 = {"burst": 1.9333333333333333, "second": 2, "lease": 0.086, "ever": s587};
const s589 = {"burst": 0.9333333333333333, "second": 1, "lease": 0.076, "ever": s587};
const s590 = {"burst": s425, "second": s426, "lease": 0.38166666666666665, "ever": s374};
const s591 = [s175, s232, s173, s500, s234];
const s592 = ["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s240];
const s593 = ["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s240];
const s594 = ["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s240];
const s595 = 0.9997000149992501;
const s596 = ["KeepAlive", "unicast", 79, 1, 0, s595, "up down", s482];
const s597 = ["TCP control", "unicast", 76, 1, 0, s595, "up down", s240];
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
"give_up": 20,
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
"max_combinations": 3,
"most_pairs": 0.95,
"many_lost": 0.5,
"few_lost": 0.1,
"min_gain": 0.2,
"many_expired": 0.05,
"other_middleware": ["research", "switch", "upgrade"],
"other_software": ["build", "research", "switch", "upgrade"],
"too_large": "the simulation would take too much time or memory",
"shown": 3,
"near": 0.5,
},
"sentences": {
"works": "Yes, this startup works: {fleet} discover each other within {within} ({how}).",
"works in simulations": "Not sure: in simulations, {fleet} discover each other within {within} ({how}). But {caution}.",
"probably": "Probably: in simulations, {fleet} discover each other within {within} ({how}). But {slower}.",
"forgotten": "No: {fleet} discover each other ({how}), but forget each other again in {forgetful} of {runs} runs, because leases expire.",
"too slow": "No, not within {within}: {fleet} need longer to discover each other ({how}).",
"never": "No: {fleet} do not complete discovery within {until} ({how}).",
"seldom": "No: in {late} of {runs} runs, {fleet} do not complete discovery within {until} ({how}).",
"never in time": "No, not within {within}: {fleet} do not complete discovery even within {until} ({how}).",
"unrepaired": "Not sure: {fleet} need at least {median} ({how}), and longer if messages are lost.",
"unrepaired and slow": "No, not within {within}: {fleet} need at least {median} ({how}).",
"too busy": "No, not within {within}: {fleet} keep the channel busy for {drain} even if nothing is lost ({how}).",
"endless": "No: {fleet} never complete discovery ({how}).",
"unknown": "Not sure: {fleet} keep the channel busy for {drain} if nothing is lost ({how}), and their discovery time was not simulated.",
"times": "Discovery time: {median} in the median run, and at most {nine} in {most}.",
"times of some": "Discovery time: {median} in the median run, but {late} of {runs} runs do not finish within {until}.",
"time of one": "Discovery time: {median} in the one run that was simulated.",
"most pairs": "After {time}, {share} of process pairs have discovered each other.",
"share of pairs": "After {until}, {share} of process pairs have discovered each other.",
"busy": "The channel goes idle after {median} (median). But {lost} of the messages are lost in transit, and we do not simulate how {protocol} recovers them.",
"not simulated": "Not simulated: {reason}.",
"periodic traffic fills": "Periodic traffic alone fills the channel.",
"access point loses": "The access point's queue drops {lost} of all messages, more than {protocol} can resend in time.",
"robots lose": "The robots' queues drop {lost} of all messages, more than {protocol} can resend in time.",
"air loses": "Collisions cost {lost} of all messages, more than {protocol} can resend in time.",
"leases end": "Meanwhile, leases expire, so robots forget each other.",
"data fits": "The channel has room for your data: after discovery, data and periodic traffic together need {airtime} of airtime per second.",
"data may fit": "Your data fits only if radios aggregate frames well: data and periodic traffic then need {airtime} of airtime per second once discovery is complete. Without aggregation, your data does not fit.",
"data late": "Data may be late during startup: in its first second, discovery and data together need {airtime} of airtime.",
"data does not fit": "Your data does not fit: even after discovery, data and periodic traffic together need {airtime} of airtime per second. First step: send fewer samples, or send them to fewer hosts.",
"first": "First step:",
"covered": "To be sure, make one of these changes, least effort first:",
"faster": "These changes make it faster still, least effort first:",
"then": "Or:",
"shorter": "These changes help, but discovery is still not complete within {within}:",
"not sure either": "These changes help in simulations, but perhaps not enough:",
"none helps": "None of the {count} simulated changes helps much.",
"none known": "No change that we could simulate helps.",
"change": "{number}. {what}: {before} -> {after}. Effort: {effort}. {cost}.",
"leases": "{time}, but leases expire in {forgetful} of {runs} runs",
"enough": "{time}; {least} if all are composed into one",
"doubtful": " Not sure: {caution}.",
"perhaps": " Real runs may take up to {slow}, longer than your target.",
"slower": "in an emulated Wi-Fi cell, real {measured} took up to {times} times as long as simulated, which would be {slow} here",
"slower elsewhere": "real runs may take up to {times} times as long ({slow}); we have not measured any",
"easier": "A change of less effort, but not complete within {within}:",
"easier, perhaps": "A change of less effort, but perhaps not complete within {within}:",
"fewer": "start no more than {count} of the {group}{beside} on this channel. These {total} need {time} to discover each other. We did not simulate whether the others can start later.",
"stopgap": "First step: {fewer}",
"until then": "Until you make such a change, {fewer}",
"changes": "Then make one change that is enough for discovery:",
"none near": "No simulated change lets half of the pairs of processes discover each other within {until}.",
"paste": " To print its configuration: --paste {name}.",
"closed form": "Ranked by airtime saved, because discovery times were not simulated:",
"drain": "- {what}: never -> the channel goes idle after {after}, if nothing is lost.",
"none ends": "No change is enough: with each of them, periodic traffic alone still fills the channel.",
"possible": "These changes may help, but we do not simulate how lost messages are then recovered: {names}.",
"bounds": "We do not know the effect of these changes, because we do not simulate how lost messages are then recovered: {names}.",
"parts": "After these changes (with their discovery times), some robots no longer discover each other: {names}.",
"domains": "To print the configuration of domains: --paste domains. It assigns the hosts to the domains in turn, so swap hosts until robots that must hear each other share a domain. All domains share one channel. We simulate a single domain, on a channel slowed down by the airtime of the others. Real times are longer, because messages of different domains also collide and share the access point's queue.",
"others": "These changes (with their discovery times) helped little, or not at all: {names}.",
"left out": "We did not simulate these changes, because {reason}: {names}.",
"compared": "Discovery times are medians of {runs} in simulation. A startup works if nine of ten runs complete discovery within {within} and no running robot's lease expires. Name a single protocol to see which changes help.",
"cautious": "Not sure for {names}: {caution}.",
"some leases": "leases expire in {forgetful} of {runs} runs",
"lost": "{lost} of the messages are lost, and we do not simulate how they are recovered",
"reboot": "If one robot reboots, all others have rediscovered it {time} after its nodes start, and {kept}.",
"kept": "no other robot's lease expires",
"not kept": "other robots' leases expire in {forgetful} of {runs} runs",
"sure": "Confidence: we simulated {until} of each startup in {runs} with fixed seeds.",
"ranges": "Ranges span {interval}.",
"long runs": "only {runs} for slow startups",
"hopeless run": "{runs} for startups that cannot succeed",
"assumed": "Assumes: one access point, all robots in range, a simultaneous start, queues of 500 messages.",
"most runs": "the second-fastest to the second-slowest of {runs} runs",
"all runs": "all {runs} runs",
"both runs": "both runs",
"never means": "'Never' means not within {until}.",
"rounded": "In \"{name}\", a process has {mean} endpoints on average; we simulate {whole}.",
"domain": "All hosts have ROS_DOMAIN_ID {domain}, which does not change these times.",
"of paper: messages channel": "This answer uses the paper's messages and channel. To set yours, use `--protocol` and `--wifi`.",
"of paper: messages": "This answer uses the paper's messages. To use a product's messages, set `--protocol`.",
"of paper: channel": "This answer uses the paper's channel. To set yours, use `--wifi`.",
"server": "We assume that the server or router is wired to the access point and is not one of your hosts.",
"extrapolated": "We measured {protocol} in fleets of up to {hosts}; beyond that, we extrapolate.",
"air": "For startups longer than 1.5 s, real {measured} in an emulated Wi-Fi cell of up to {hosts} hosts took {range} times as long as in the simulation.",
"watched": "We observed real startups for at most {seconds} s, and extrapolate beyond.",
"not compared": "Real runs may take up to {high} times as long (we have not measured any).",
"server not compared": "Real startups with a server or router may take up to {high} times as long (we have not measured any).",
"interrupted": "Interrupted: not all runs are done, so some changes are missing.",
"cell": "Cell \"{cell}\": the startup needs {airtime} of airtime in its first second.",
"assumed of cells": "Assumes: all robots in range of their access points, a simultaneous start, queues of 500 messages. Cells do not interfere, and messages between access points take no time. We do not compare other radios and channels: to try others, change the fleet file and plan again.",
"surer": "To check this answer, run `discostorm capture` on a recorded startup.",
"why": "`--why` explains the answer.",
"all": "`--all` lists all changes that we tried.",
"searching": "Next we check how many robots can start unchanged, and look for smaller changes that suffice.",
"not known again": "No: if one robot reboots, not all others rediscover it within the simulated time.",
"no reboot": "Not sure: we simulate a reboot only if every startup has finished before it.",
"several at once": "The command `discostorm plan` also tries other combinations of changes.",
"other start": "Changes are compared for robots that start together.",
"paper (802.11n)": "802.11n as in the Discovery Storm paper",
"own channel": "your own channel",
"SPDP unicast for others": "SPDP unicast triggered by third processes",
"Declare key expression passed on": "Declare key expression, forwarded",
"Declare key expression of node passed on": "Declare key expression of a node, forwarded",
"Declare token passed on": "Declare token, forwarded",
"Declare token of node passed on": "Declare token of a node, forwarded",
"Declare passed on": "Declare, forwarded",
"OAM passed on": "OAM, forwarded",
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
"sooner": "Discovery can finish sooner, because dropped messages need no airtime, and the last retransmissions come after discovery is complete.",
"later": "Discovery takes longer, because processes wait before they answer and before they resend lost messages.",
"full A-MPDUs": "The drain time assumes full A-MPDUs. With fewer frames queued, A-MPDUs are less full.",
"may never fit": "The fleet may never fit: with one message per frame, its periodic traffic alone needs {share} of the channel.",
"reply wait": "While nodes start, service servers need a max_blocking_time (reliability QoS) of {wait} or more. The Fast DDS default is {usual}.",
"endless reply wait": "For services called while nodes start, no max_blocking_time is long enough, because some pairs never complete discovery.",
"data load": "Your data needs {data} of the channel, or {both} together with periodic discovery traffic. So your data {fit} once discovery is complete.",
"data load and little else": "Together with periodic discovery traffic, your data needs {both} of the channel. So your data {fit} once discovery is complete.",
"data during startup": "In {time}, discovery and data together need {airtime} of airtime, so your data {fit} during startup.",
"data wait": "If robots sent all data from the beginning, startup would keep the channel busy for {time} instead of {alone}. Data waits at most as long as the channel is busy. In practice, it waits less, because robots send only to robots that they have discovered. `discostorm simulate` shows when discovery is complete and how late the data is.",
"no room for data": "The channel can never carry discovery and all your data. Send fewer samples, or send them to fewer hosts.",
"captured": "The measured model of {name} comes from captures of up to {hosts} that started together, with up to {processes} in all and {endpoints} per process.",
"beyond captures": "This fleet exceeds these limits, so we extrapolate.",
"as the paper": "We count {names} as the paper does, although the product packs some of these messages together and sends other types as well.",
"whole burst": "We count the whole startup burst within {window}, and periodic traffic at its average rate. This can only overstate the airtime.",
"standard timing": "For radios other than the paper's, we use the timing of the 802.11 standard. With that timing, your unchanged fleet needs {airtime}.",
"nothing to write": "Your startup already works, so nothing needs changing, and we wrote no files. To write the configuration for a change anyway, name the change: --paste NAME.",
"nothing written": "--write: we are not sure that any configuration change is enough, so we wrote no files. Run the command without --write to see what helps, then name a change: --paste NAME",
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
"aggregation and staggered start": {"steps": ["aggregation", s77], "of": {"DDS": s89, "Zenoh": s89, "None": s89}},
"announcements": {"steps": ["announcements"], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s90, "best_case": false, "cost": "failed robots are noticed later, and lost announcements are repeated later"}, "Zenoh": null, "None": null}},
"announcements and staggered start": {"steps": ["announcements", s77], "of": {"DDS": {"efforts": s91, "effort": 2, "takes": s92, "best_case": false, "cost": "failed robots are noticed later, and lost announcements are repeated later; discovery cannot be complete before the last host starts"}, "Zenoh": null, "None": null}},
"discovery server": {"steps": [s78], "of": {"DDS": {"efforts": ["server"], "effort": 3, "takes": s93, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the server is down and after short outages"}, "Zenoh": null, "None": null}},
"discovery server and staggered start": {
"steps": [s78, s77],
"of": {
"DDS": {"efforts": s94, "effort": 3, "takes": s95, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while the server is down and after short outages"},
"Zenoh": null,
"None": null,
},
},
"discovery server on a robot": {"steps": [s96], "of": {"DDS": {"efforts": ["server"], "effort": 3, "takes": s93, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the robot with the server is away"}, "Zenoh": null, "None": null}},
"discovery server on a robot and staggered start": {
"steps": [s96, s77],
"of": {
"DDS": {"efforts": s94, "effort": 3, "takes": s95, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while the robot with the server is away"},
"Zenoh": null,
"None": null,
},
},
"endpoints": {"steps": ["endpoints"], "of": {"DDS": s97, "Zenoh": s97, "None": s97}},
"endpoints and staggered start": {"steps": ["endpoints", s77], "of": {"DDS": s100, "Zenoh": s100, "None": s100}},
"middleware": {"steps": ["middleware"], "of": {"DDS": s102, "Zenoh": {"efforts": ["switch"], "effort": 8, "takes": s101, "best_case": false, "cost": "all hosts must change together; we assume peers that scout by multicast; the paper does not count the tokens of rmw_zenoh"}, "None": s102}},
"middleware and discovery server": {
"steps": ["middleware", s78],
"of": {"DDS": {"efforts": s103, "effort": 8, "takes": s104, "best_case": false, "cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the server is down and after short outages"}, "Zenoh": null, "None": null},
},
"middleware and discovery server and staggered start": {
"steps": ["middleware", s78, s77],
"of": {
"DDS": {
"efforts": s105,
"effort": 8,
"takes": s106,
"best_case": false,
"cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while the server is down and after short outages",
},
"Zenoh": null,
"None": null,
},
},
"middleware and discovery server on a robot": {
"steps": ["middleware", s96],
"of": {"DDS": {"efforts": s103, "effort": 8, "takes": s104, "best_case": false, "cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the robot with the server is away"}, "Zenoh": null, "None": null},
},
"middleware and discovery server on a robot and staggered start": {
"steps": ["middleware", s96, s77],
"of": {
"DDS": {
"efforts": s105,
"effort": 8,
"takes": s106,
"best_case": false,
"cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while the robot with the server is away",
},
"Zenoh": null,
"None": null,
},
},
"middleware and multicast endpoint data": {"steps": ["middleware", s107], "of": {"DDS": {"efforts": s108, "effort": 8, "takes": s109, "best_case": false, "cost": "all hosts must change together; multicast uses the basic rate and has no acknowledgments, so lost announcements are noticed late"}, "Zenoh": null, "None": null}},
"middleware and multicast endpoint data and staggered start": {
"steps": ["middleware", s107, s77],
"of": {"DDS": {"efforts": s110, "effort": 8, "takes": s111, "best_case": false, "cost": "all hosts must change together; multicast uses the basic rate and has no acknowledgments, so lost announcements are noticed late; discovery cannot be complete before the last host starts"}, "Zenoh": null, "None": null},
},
"middleware and peers": {
"steps": ["middleware", "peers"],
"of": {
"DDS": {"efforts": s108, "effort": 8, "takes": s109, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS)"},
"Zenoh": {"efforts": s108, "effort": 8, "takes": s109, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; a process that calls a peer too early may keep calling every 4 s"},
"None": null,
},
},
"middleware and peers and staggered start": {
"steps": ["middleware", "peers", s77],
"of": {
"DDS": {"efforts": s110, "effort": 8, "takes": s111, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS); discovery cannot be complete before the last host starts"},
"Zenoh": {"efforts": s110, "effort": 8, "takes": s111, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; a process that calls a peer too early may keep calling every 4 s; discovery cannot be complete before the last host starts"},
"None": null,
},
},
"middleware and router": {
"steps": ["middleware", "router"],
"of": {"DDS": null, "Zenoh": {"efforts": s103, "effort": 8, "takes": s104, "best_case": false, "cost": "all hosts must change together; robots need the router's address; all data pass through it; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)"}, "None": null},
},
"middleware and router and staggered start": {
"steps": ["middleware", "router", s77],
"of": {
"DDS": null,
"Zenoh": {
"efforts": s105,
"effort": 8,
"takes": s106,
"best_case": false,
"cost": "all hosts must change together; robots need the router's address; all data pass through it; discovery cannot be complete before the last host starts; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)",
},
"None": null,
},
},
"middleware and router on each host": {
"steps": ["middleware", s112],
"of": {"DDS": null, "Zenoh": {"efforts": s113, "effort": 8, "takes": s114, "best_case": false, "cost": "all hosts must change together; every router needs the addresses of all other routers; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back"}, "None": null},
},
"middleware and router on each host and staggered start": {
"steps": ["middleware", s112, s77],
"of": {
"DDS": null,
"Zenoh": {
"efforts": s115,
"effort": 8,
"takes": s116,
"best_case": false,
"cost": "all hosts must change together; every router needs the addresses of all other routers; discovery cannot be complete before the last host starts; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back",
},
"None": null,
},
},
"middleware and staggered start": {
"steps": ["middleware", s77],
"of": {"DDS": s119, "Zenoh": {"efforts": s117, "effort": 8, "takes": s118, "best_case": false, "cost": "all hosts must change together; we assume peers that scout by multicast; the paper does not count the tokens of rmw_zenoh; discovery cannot be complete before the last host starts"}, "None": s119},
},
"middleware and star of routers": {"steps": ["middleware", s120], "of": {"DDS": null, "Zenoh": {"efforts": s113, "effort": 8, "takes": s114, "best_case": false, "cost": "all hosts must change together; every robot needs the wired router's address; robots do not hear each other while the wired router is down"}, "None": null}},
"middleware and star of routers and staggered start": {
"steps": ["middleware", s120, s77],
"of": {
"DDS": null,
"Zenoh": {"efforts": s115, "effort": 8, "takes": s116, "best_case": false, "cost": "all hosts must change together; every robot needs the wired router's address; discovery cannot be complete before the last host starts; robots do not hear each other while the wired router is down"},
"None": null,
},
},
"middleware and static endpoints": {
"steps": ["middleware", s121],
"of": {"DDS": {"efforts": ["switch", "build"], "effort": 8, "takes": "another middleware and rebuilt nodes", "best_case": false, "cost": "all hosts must change together; every robot needs a file that lists every endpoint, ROS 2's own included; Fast DDS 2.9.1 can crash"}, "Zenoh": null, "None": null},
},
"middleware and static endpoints and staggered start": {
"steps": ["middleware", s121, s77],
"of": {
"DDS": {
"efforts": ["switch", "build", "setting"],
"effort": 8,
"takes": "another middleware, rebuilt nodes and a setting",
"best_case": false,
"cost": "all hosts must change together; every robot needs a file that lists every endpoint, ROS 2's own included; Fast DDS 2.9.1 can crash; discovery cannot be complete before the last host starts",
},
"Zenoh": null,
"None": null,
},
},
"middleware and two discovery servers": {
"steps": ["middleware", s122],
"of": {"DDS": {"efforts": s113, "effort": 8, "takes": s114, "best_case": false, "cost": "all hosts must change together; each robot needs both addresses; ros2 tools must be super clients; late joiners stay undiscovered while both servers are down"}, "Zenoh": null, "None": null},
},
"middleware and two discovery servers and staggered start": {
"steps": ["middleware", s122, s77],
"of": {
"DDS": {"efforts": s115, "effort": 8, "takes": s116, "best_case": false, "cost": "all hosts must change together; each robot needs both addresses; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while both servers are down"},
"Zenoh": null,
"None": null,
},
},
"multicast endpoint data": {"steps": [s107], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s90, "best_case": false, "cost": "multicast uses the basic rate and has no acknowledgments, so lost announcements are noticed late"}, "Zenoh": null, "None": null}},
"multicast endpoint data and staggered start": {"steps": [s107, s77], "of": {"DDS": {"efforts": s91, "effort": 2, "takes": s92, "best_case": false, "cost": "multicast uses the basic rate and has no acknowledgments, so lost announcements are noticed late; discovery cannot be complete before the last host starts"}, "Zenoh": null, "None": null}},
"multicast rate": {"steps": [s14], "of": {"DDS": s123, "Zenoh": s123, "None": s123}},
"multicast rate and staggered start": {"steps": [s14, s77], "of": {"DDS": s124, "Zenoh": s124, "None": s124}},
"peers": {
"steps": ["peers"],
"of": {
"DDS": {"efforts": ["file"], "effort": 2, "takes": s90, "best_case": false, "cost": "you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS)"},
"Zenoh": {"efforts": ["file"], "effort": 2, "takes": s90, "best_case": false, "cost": "you must know the addresses beforehand; a process that calls a peer too early may keep calling every 4 s"},
"None": null,
},
},
"peers and staggered start": {
"steps": ["peers", s77],
"of": {
"DDS": {"efforts": s91, "effort": 2, "takes": s92, "best_case": false, "cost": "you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS); discovery cannot be complete before the last host starts"},
"Zenoh": {"efforts": s91, "effort": 2, "takes": s92, "best_case": false, "cost": "you must know the addresses beforehand; a process that calls a peer too early may keep calling every 4 s; discovery cannot be complete before the last host starts"},
"None": null,
},
},
"processes": {"steps": ["processes"], "of": {"DDS": s125, "Zenoh": s125, "None": s125}},
"processes and staggered start": {"steps": ["processes", s77], "of": {"DDS": s126, "Zenoh": s126, "None": s126}},
"radio": {"steps": ["radio"], "of": {"DDS": s127, "Zenoh": s127, "None": s127}},
"radio and staggered start": {"steps": ["radio", s77], "of": {"DDS": s128, "Zenoh": s128, "None": s128}},
"release": {"steps": ["release"], "of": {"DDS": s129, "Zenoh": s129, "None": s129}},
"release and staggered start": {"steps": ["release", s77], "of": {"DDS": s130, "Zenoh": s130, "None": s130}},
"router": {"steps": ["router"], "of": {"DDS": null, "Zenoh": {"efforts": ["server"], "effort": 3, "takes": s93, "best_case": false, "cost": "robots need the router's address; all data pass through it; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)"}, "None": null}},
"router and staggered start": {
"steps": ["router", s77],
"of": {
"DDS": null,
"Zenoh": {"efforts": s94, "effort": 3, "takes": s95, "best_case": false, "cost": "robots need the router's address; all data pass through it; discovery cannot be complete before the last host starts; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)"},
"None": null,
},
},
"router on each host": {"steps": [s112], "of": {"DDS": null, "Zenoh": {"efforts": ["servers"], "effort": 4, "takes": s131, "best_case": false, "cost": "every router needs the addresses of all other routers; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back"}, "None": null}},
"router on each host and staggered start": {
"steps": [s112, s77],
"of": {
"DDS": null,
"Zenoh": {"efforts": s132, "effort": 4, "takes": s133, "best_case": false, "cost": "every router needs the addresses of all other routers; discovery cannot be complete before the last host starts; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back"},
"None": null,
},
},
"staggered start": {"steps": [s77], "of": {"DDS": s134, "Zenoh": s134, "None": s134}},
"star of routers": {"steps": [s120], "of": {"DDS": null, "Zenoh": {"efforts": ["servers"], "effort": 4, "takes": s131, "best_case": false, "cost": "every robot needs the wired router's address; robots do not hear each other while the wired router is down"}, "None": null}},
"star of routers and staggered start": {
"steps": [s120, s77],
"of": {"DDS": null, "Zenoh": {"efforts": s132, "effort": 4, "takes": s133, "best_case": false, "cost": "every robot needs the wired router's address; discovery cannot be complete before the last host starts; robots do not hear each other while the wired router is down"}, "None": null},
},
"static endpoints": {"steps": [s121], "of": {"DDS": {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "every robot needs a file that lists every endpoint, ROS 2's own included; Fast DDS 2.9.1 can crash"}, "Zenoh": null, "None": null}},
"static endpoints and staggered start": {"steps": [s121, s77], "of": {"DDS": {"efforts": s98, "effort": 5, "takes": s99, "best_case": false, "cost": "every robot needs a file that lists every endpoint, ROS 2's own included; Fast DDS 2.9.1 can crash; discovery cannot be complete before the last host starts"}, "Zenoh": null, "None": null}},
"two discovery servers": {"steps": [s122], "of": {"DDS": {"efforts": ["servers"], "effort": 4, "takes": s131, "best_case": false, "cost": "each robot needs both addresses; ros2 tools must be super clients; late joiners stay undiscovered while both servers are down"}, "Zenoh": null, "None": null}},
"two discovery servers and staggered start": {
"steps": [s122, s77],
"of": {"DDS": {"efforts": s132, "effort": 4, "takes": s133, "best_case": false, "cost": "each robot needs both addresses; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while both servers are down"}, "Zenoh": null, "None": null},
},
},
"pastes": {
"aggregation": {
"any": [
{
"where": s135,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: merge into /etc/hostapd/hostapd.conf, which also sets interface and ssid; hostapd\n# reads it when it starts\n# Keep your band, channel and width. With 802.11ac and ax, vht_capab lets 64 frames of any length\n# share an exchange. With 802.11n only, leave out the last two lines.\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[SHORT-GI-20]\nieee80211ac=1\nvht_capab=[MAX-A-MPDU-LEN-EXP7]\n",
},
],
},
"announcements": {
"Fast DDS": [
{
"where": s136,
"version": s137,
"text": "<!-- for every process (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"calm\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <initialAnnouncements>\n              <count>1</count>\n              <period>\n                <sec>1</sec>\n              </period>\n            </initialAnnouncements>\n            <leaseAnnouncement>\n              <sec>15</sec>\n            </leaseAnnouncement>\n            <leaseDuration>\n              <sec>100</sec>\n            </leaseDuration>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
],
"Cyclone DDS": [
{
"where": s136,
"version": s138,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <Discovery>\n      <LeaseDuration>100 s</LeaseDuration>\n      <SPDPInterval>30 s</SPDPInterval>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"discovery server": {
"any": [
{
"where": s139,
"version": s137,
"text": "# on a computer that is wired to the access point (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Use the address of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n",
},
s141,
{
"where": "for the server if it is a program of your own",
"version": s137,
"text": "<!-- for the server if it is a program of your own (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; the server's process runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"server\" is_default_profile=\"true\">\n      <rtps>\n        <prefix>44.53.00.5f.45.50.52.4f.53.49.4d.41</prefix>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SERVER</discoveryProtocol>\n          </discovery_config>\n          <metatrafficUnicastLocatorList>\n            <locator>\n              <udpv4>\n                <address>192.168.1.10</address>\n                <port>11811</port>\n              </udpv4>\n            </locator>\n          </metatrafficUnicastLocatorList>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
s142,
s143,
],
},
"discovery server on a robot": {
"any": [
{
"where": "on one of the robots",
"version": s137,
"text": "# on one of the robots (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Use the address of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n",
},
s141,
s142,
s143,
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
"where": s144,
"version": "ROS 2 Jazzy",
"text": "# on every computer (ROS 2 Jazzy)\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: set it in the\n# shell or service file that starts the ROS 2 processes\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_fastrtps_cpp\n",
},
],
"Cyclone DDS": [
{
"where": s144,
"version": "ROS 2 Jazzy",
"text": "# on every computer (ROS 2 Jazzy)\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: set it in the\n# shell or service file that starts the ROS 2 processes\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n",
},
],
"Zenoh": [
{
"where": s144,
"version": "ROS 2 Jazzy",
"text": "# on every computer (ROS 2 Jazzy)\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: set it in the\n# shell or service file that starts the ROS 2 processes\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_zenoh_cpp\n# The next line names the configuration file that every process reads. Without a router, peers log\n# a warning and continue. If there is a router, start it first: ros2 run rmw_zenoh_cpp rmw_zenohd\nexport ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n",
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
"where": s136,
"version": s138,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <!-- On Wi-Fi, Cyclone DDS by default multicasts only participant announcements. -->\n      <AllowMulticast>true</AllowMulticast>\n    </General>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"multicast rate": {
"any": [
{
"where": s135,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: merge into /etc/hostapd/hostapd.conf, which also sets interface and ssid; hostapd\n# reads it when it starts\n# Multicast and management frames are sent at the lowest basic rate, here 24 Mbit/s (in units of\n# 100 kbit/s). Old rates below it are switched off, but not those of 802.11n and later. A station\n# that is too far away for 24 Mbit/s cannot join.\n# Keep your band and channel.\nhw_mode=a\nchannel=36\nsupported_rates=240 360 480 540\nbasic_rates=240\n",
},
],
},
"peers": {
"Cyclone DDS": [
{
"where": s136,
"version": s138,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <AllowMulticast>false</AllowMulticast>\n    </General>\n    <Discovery>\n      <!-- Allow at least as many indices as a host has processes. -->\n      <ParticipantIndex>auto</ParticipantIndex>\n      <MaxAutoParticipantIndex>9</MaxAutoParticipantIndex>\n      <!-- List every host, this one included. -->\n      <Peers>\n        <Peer Address=\"192.168.1.21\"/>\n        <Peer Address=\"192.168.1.22\"/>\n        <Peer Address=\"192.168.1.23\"/>\n      </Peers>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
"DDS": [
{
"where": s140,
"version": "ROS 2 Jazzy",
"text": "# on every robot (ROS 2 Jazzy)\n# Load: both are environment variables of every ROS 2 process: set them in the shell or\n# service file that starts the ROS 2 processes\n# Not run here: compared with its documentation\nexport ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST\nexport ROS_STATIC_PEERS=\"192.168.1.22;192.168.1.23\"\n",
},
],
"Zenoh": [
{
"where": "for every process, which connects to robots with lower addresses",
"version": "Zenoh 1.10.2",
"text": "// for every process, which connects to robots with lower addresses (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n// The first process of a host takes port 7447, and each further process another port. A process\n// that connects to a first process learns of the others from it: gossip.\n{\n  mode: \"peer\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\", \"tcp/0.0.0.0:0\"], exit_on_failure: false },\n  connect: {\n    endpoints: [\n      // This host. Its first process reaches itself here, logs an error and tries again later.\n      \"tcp/127.0.0.1:7447#retry_period_init_ms=60000;retry_period_max_ms=60000\",\n      // List only robots with lower addresses: a pair linked twice sends KeepAlives twice.\n      \"tcp/192.168.1.21:7447\",\n      \"tcp/192.168.1.22:7447\",\n    ],\n  },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: {\n      target: [\"router\", \"peer\"],\n      autoconnect_strategy: { peer: { to_router: \"always\", to_peer: \"greater-zid\" } },\n    },\n  },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 10000, // Zenoh's default: a KeepAlive every 2.5 s; rmw_zenoh sets 60000 and 2\n        keep_alive: 4,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
],
},
"processes": {
"any": [
{
"where": "where Nav2 is started",
"version": "ROS 2 Humble",
"text": "# where Nav2 is started (ROS 2 Humble)\n# Load: run in a shell; it starts ros2 launch\n# Not run here: compared with its documentation\n# Nav2 makes a container of its own, nav2_container. Load your other nodes into it, too:\n# nodes outside of it stay processes of their own.\nros2 launch nav2_bringup bringup_launch.py use_composition:=True\n",
},
{
"where": "a launch file for nodes of your own that are built as components",
"version": "ROS 2 Humble",
"text": "# a launch file for nodes of your own that are built as components (ROS 2 Humble)\n# Load: save as robot.launch.py; start it with ros2 launch robot.launch.py\n# Not run here: compared with its documentation\nfrom launch import LaunchDescription\nfrom launch_ros.actions import ComposableNodeContainer\nfrom launch_ros.descriptions import ComposableNode\n\n\ndef generate_launch_description():\n    nodes = [\n        ComposableNode(package=\"composition\", plugin=\"composition::Talker\", name=\"talker\"),\n        ComposableNode(package=\"composition\", plugin=\"composition::Listener\", name=\"listener\"),\n    ]\n    # With Nav2, load these nodes into its container, so that all share one process. Then let\n    # container be, from launch_ros.actions,\n    # LoadComposableNodes(target_container=\"nav2_container\", composable_node_descriptions=nodes).\n    container = ComposableNodeContainer(\n        name=\"robot\",\n        namespace=\"\",\n        package=\"rclcpp_components\",\n        executable=\"component_container\",\n        composable_node_descriptions=nodes,\n    )\n    return LaunchDescription([container])\n",
},
],
},
"radio": {
"802.11n 40 MHz": [
{
"where": s135,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: merge into /etc/hostapd/hostapd.conf, which also sets interface and ssid; hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\n",
},
],
"802.11ac 80 MHz": [
{
"where": s135,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: merge into /etc/hostapd/hostapd.conf, which also sets interface and ssid; hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=1\nvht_oper_centr_freq_seg0_idx=42\nvht_capab=[SHORT-GI-80][MAX-A-MPDU-LEN-EXP7]\n",
},
],
"802.11ax 160 MHz": [
{
"where": s135,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: merge into /etc/hostapd/hostapd.conf, which also sets interface and ssid; hostapd\n# reads it when it starts\n# Radars share channels 52 to 64, so hostapd needs your country's code.\ncountry_code=US\nieee80211d=1\nieee80211h=1\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=2\nvht_oper_centr_freq_seg0_idx=50\nvht_capab=[VHT160][SHORT-GI-80][SHORT-GI-160][MAX-A-MPDU-LEN-EXP7]\nieee80211ax=1\nhe_oper_chwidth=2\nhe_oper_centr_freq_seg0_idx=50\n",
},
],
},
"release": {},
"router": {
"any": [
s145,
{
"where": s136,
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
"text": "// on every robot for its router, which connects to lower addresses (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  // List only robots with lower addresses: a pair linked twice sends KeepAlives twice.\n  connect: { endpoints: [\"tcp/192.168.1.21:7447\", \"tcp/192.168.1.22:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
s146,
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
s145,
{
"where": "on every robot for its router, which connects only to the wired one",
"version": "Zenoh 1.10.2",
"text": "// on every robot for its router, which connects only to the wired one (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  // List only the router that is wired to the access point, and no robot.\n  connect: { endpoints: [\"tcp/192.168.1.10:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
s146,
],
},
"static endpoints": {
"any": [
{
"where": s136,
"version": s137,
"text": "<!-- for every process (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE); in ROS 2 it matches nothing without -->\n<!-- RMW_FASTRTPS_USE_QOS_FROM_XML=1 -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"robot\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <EDP>STATIC</EDP>\n            <static_edp_xml_config>file:///etc/fast_dds_static_endpoints.xml</static_edp_xml_config>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n    <!-- List a topic for each endpoint of this process. -->\n    <data_writer profile_name=\"/robot1/odom\">\n      <userDefinedID>1</userDefinedID>\n    </data_writer>\n  </profiles>\n</dds>\n",
},
{
"where": s140,
"version": "Fast DDS 2.9, 2.14 and 3.6",
"text": "<!-- on every robot (tested with Fast DDS 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds_static_endpoints.xml, the path in the profile for every -->\n<!-- process; it needs no environment variable -->\n<staticdiscovery>\n  <!-- List every process by the name of its participant (in ROS 2, its enclave), with all its\n       endpoints. Give every endpoint its own number. -->\n  <participant>\n    <name>/robot1</name>\n    <writer>\n      <userId>1</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </writer>\n  </participant>\n  <participant>\n    <name>/laptop</name>\n    <reader>\n      <userId>2</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </reader>\n  </participant>\n</staticdiscovery>\n",
},
],
},
"two discovery servers": {
"any": [
{
"where": "on two computers that are wired to the access point",
"version": s137,
"text": "# on two computers that are wired to the access point (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Run the first line on one computer and the second on another, each with its own address.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\nfastdds discovery -i 1 -l 192.168.1.11 -p 11811\n",
},
{
"where": "on every robot (with the servers in the same order)",
"version": s137,
"text": "# on every robot (with the servers in the same order) (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: set\n# it in the shell or service file that starts the ROS 2 processes\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811;192.168.1.11:11811\"\n",
},
s142,
s143,
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
"inside_unicast": ({ L, R_uni }) => { return 8*L/R_uni; },
"inside_multicast": ({ L, R_multi }) => { return 8*L/R_multi; },
"linear_unicast": ({ L, O_uni, R_uni }) => { return 8*L/R_uni + O_uni; },
"linear_multicast": ({ L, O_multi, R_multi }) => { return 8*L/R_multi + O_multi; },
"padded_unicast": ({ L, N_DBPS_uni, N_add_uni, O_uni, k_uni, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*L + N_add_uni)/N_DBPS_uni)); return O_uni + rounded_0*t_grid_uni; },
"padded_multicast": ({ L, N_DBPS_multi, N_add_multi, O_multi, k_multi, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*L + N_add_multi)/N_DBPS_multi)); return O_multi + rounded_0*t_grid_multi; },
"aggregated_unicast": ({ A_least, A_most, L, N_DBPS_uni, N_add_uni, O_agg, k_uni, n_agg, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*L + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*L + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*L + 1/2) + 4))))/N_DBPS_uni)); return (O_agg + rounded_1*t_grid_uni)/rounded_0; },
"largest": ({ N_sat }) => { const rounded_0 = Math.ceil(N_sat); return rounded_0 - 1; },
"drain": ({ B, rho }) => { return ((rho < 1) ? (
   B/(1 - rho)
)
: (
   Number.POSITIVE_INFINITY
)); },
},
"columns": ["name", "cast", "bytes", "frames", "unit", "per_unit", "hops", "sent"],
"protocols": {
"DDS": {
"group": s6,
"family": "DDS",
"product": null,
"tables": {"any": [s150, s153, s156, s157, s160, s163, ["middleware", "switching to Zenoh", "", "Zenoh", "DDS", "middleware"]]},
"about": "",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": "--ds-family-dds",
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s168,
"windows": s169,
"units": [s171, s173, s175],
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s176], ["SEDP", "unicast", 464, 1, 1, 1, "up down", s176], ["Heartbeat", "unicast", 116, 1, 2, 2, "up down", s176], ["ACKNACK", "unicast", 114, 1, 2, 2, "up down", s176]],
},
"Zenoh": {
"group": s6,
"family": "Zenoh",
"product": null,
"tables": {"any": [s180, s183, s186, ["peers", "static peers", "", "Zenoh, static peers", "Zenoh", "peers"], ["middleware", "switching to DDS", "", "DDS", "Zenoh", "middleware"]]},
"about": "",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s187,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s168,
"windows": s169,
"units": s188,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s176], ["Hello", "unicast", 144, 1, 1, 1, "up down", s176], ["Declare", "unicast", 176, 1, 2, 1, "up down", s176], s189],
},
"Cyclone DDS": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [[s78, s190, "", s191, "Cyclone DDS", s192], [s122, s193, "", s194, "Cyclone DDS", s195], s196, s199, s200, s201, s204, s207, s210, s212, s214, ["middleware", "switching to Fast DDS 2.14", "", "Fast DDS 2.14", "Cyclone DDS", "middleware"], s216],
"humble": [[s78, s190, "", s217, "Cyclone DDS", s192], [s122, s193, "", s218, "Cyclone DDS", s195], s196, s199, s200, s201, s204, s207, s210, s212, s214, ["middleware", "switching to Fast DDS 2.6", "", "Fast DDS 2.6", "Cyclone DDS", "middleware"], s216],
"kilted": [[s78, s190, "", s219, "Cyclone DDS", s192], [s122, s193, "", s220, "Cyclone DDS", s195], s196, s199, s200, s201, s204, s207, s210, s212, s214, ["middleware", s221, "", "Fast DDS 3.6", "Cyclone DDS", "middleware"], s216],
},
"about": s222,
"caution": s223,
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 60],
"band": s226,
"reboot": [1.45, 3.59],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s235,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s236],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s237],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s238],
["SEDP", "unicast", s239, 0.2218, 2, 1, "up down", s240],
["SEDP again", "unicast", s239, 0.2218, 3, 0.103, "up down", s240],
["Heartbeat", "unicast", s241, 0.5226, 1, 2, "up down", s240],
[s242, "unicast", s241, 0.5226, 1, 2.481, "up down", s240],
["ACKNACK", "unicast", s243, 0.402, 1, 4.635, "up down", s240],
[s244, "unicast", s243, 0.402, 4, 0.09896, "up down", s240],
s247,
[s248, "unicast", s249, 0.6253, 1, 1, "up down", s240],
[s250, "unicast", s249, 0.6253, 4, 0.1067, "up down", s240],
s253,
[s254, "unicast", s255, 0.4544, 1, 2.222, "up down", s240],
s257,
[s258, "unicast", s259, 0.3044, 1, 2.312, "up down", s240],
[s260, "unicast", s259, 0.3044, 4, 0.05208, "up down", s240],
[s261, "unicast", s262, 0.6806, 1, 2.333, "up down", s240],
[s263, "unicast", s264, 0.2641, 1, 2, "up down", s240],
[s265, "unicast", s264, 0.2641, 4, 0.2188, "up down", s240],
[s266, "unicast", s267, 0.6247, 5, 1.006, "up down", s240],
[s268, "unicast", s267, 0.6247, 6, 0.07217, "up down", s240],
["User ACKNACK", "unicast", s269, 0.338, 5, 1.404, "up down", s240],
[s270, "unicast", s269, 0.338, 6, 0.09793, "up down", s240],
],
},
"Cyclone DDS, wired": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s78, s190, s271, "Cyclone DDS, wired, switching to Fast DDS with a Discovery Server", s272, s192],
[s122, s193, s271, "Cyclone DDS, wired, switching to Fast DDS with two Discovery Servers", s272, s195],
[s121, s197, "", s121, s272, s198],
s160,
s163,
["router", s202, "", "Zenoh router", s272, s203],
[s112, s205, "", s182, s272, s206],
[s120, s208, "", s185, s272, s209],
["announcements", s211, "", "Cyclone DDS, wired, a longer announcement interval", s272, "announcements"],
["release", s273, "", "Cyclone DDS", s272, "release"],
["release", s213, "", s2, s272, "release"],
["middleware", s221, "", "Fast DDS 3.6", s272, "middleware"],
["middleware", s215, "", s179, s272, "middleware"],
],
},
"about": s274,
"caution": "Cyclone DDS as on a wired network was not measured in an emulated Wi-Fi cell, where Cyclone DDS as on Wi-Fi took up to 6.8 times as long as in our simulation",
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 20],
"band": s275,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s276,
"degree": 3,
"messages": [
s277,
["SPDP directed", "unicast", s278, 0.9963, 1, 0.6667, "up down", s238],
["SEDP", "unicast", s279, 0.1841, 2, 0.5833, "up down", s240],
[s280, "multicast", s281, 0.2228, 2, 0.1667, "up down", s240],
[s282, "multicast", 232, 0.25, 0, 2, "up down", s240],
["Heartbeat", "unicast", s283, 0.3287, 1, 3, "up down", s240],
["ACKNACK", "unicast", s284, 0.3715, 1, 4.05, "up down", s240],
[s244, "unicast", s284, 0.3715, 3, 0.2833, "up down", s240],
["Liveliness", "multicast", s245, 0.7242, 0, 1, "up down", s246],
[s248, "multicast", s285, 0.9582, 0, 0.3333, "up down", s240],
[s286, "unicast", 429, 0.2, 1, 0.5, "up down", s240],
[s251, "multicast", s252, 0.2758, 0, 1, "up down", s246],
[s254, "multicast", s287, 0.1767, 0, 0.875, "up down", s240],
[s288, "unicast", s289, 0.2117, 1, 1.625, "up down", s240],
s257,
[s258, "unicast", s290, 0.2807, 1, 2.344, "up down", s240],
[s260, "unicast", s290, 0.2807, 3, 0.07812, "up down", s240],
[s261, "multicast", s291, 0.1988, 0, 2, "up down", s240],
[s292, "unicast", s293, 0.1917, 1, 0.6667, "up down", s240],
[s263, "unicast", 211.5, 0.2, 1, 2, "up down", s240],
[s265, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s240],
[s266, "unicast", s294, 0.2427, 4, 0.75, "up down", s240],
[s295, "multicast", s296, 0.2152, 4, 0.25, "up down", s240],
["User ACKNACK", "unicast", s297, 0.2283, 4, 2, "up down", s240],
],
},
"Cyclone DDS, version 11": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s78, s190, s271, "Cyclone DDS, version 11, switching to Fast DDS with a Discovery Server", s2, s192],
[s122, s193, s271, "Cyclone DDS, version 11, switching to Fast DDS with two Discovery Servers", s2, s195],
[s121, s197, "", s121, s2, s198],
s160,
s163,
["router", s202, "", "Zenoh router", s2, s203],
[s112, s205, "", s182, s2, s206],
[s120, s208, "", s185, s2, s209],
["announcements", s211, "", "Cyclone DDS, version 11, a longer announcement interval", s2, "announcements"],
["release", s273, "", "Cyclone DDS", s2, "release"],
["middleware", s221, "", "Fast DDS 3.6", s2, "middleware"],
["middleware", s215, "", s179, s2, "middleware"],
],
},
"about": s298,
"caution": "Cyclone DDS 11 was not measured in an emulated Wi-Fi cell, where Cyclone DDS 0.10.5 took up to 6.8 times as long as in our simulation",
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 60],
"band": s299,
"reboot": [1.31, 3.21],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s235,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s236],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s237],
["SPDP directed", "unicast", s300, 0.9992, 1, 0.5413, "up down", s238],
["SEDP", "unicast", s301, 0.4598, 2, 1, "up down", s240],
["SEDP again", "unicast", s301, 0.4598, 3, 0.09093, "up down", s240],
["Heartbeat", "unicast", s302, 0.5475, 1, 2, "up down", s240],
[s242, "unicast", s302, 0.5475, 1, 2.833, "up down", s240],
["ACKNACK", "unicast", s303, 0.3982, 1, 5.167, "up down", s240],
[s244, "unicast", s303, 0.3982, 4, 0.125, "up down", s240],
s247,
[s248, "unicast", s304, 0.6519, 1, 1, "up down", s240],
[s250, "unicast", s304, 0.6519, 4, 0.09103, "up down", s240],
s253,
[s254, "unicast", s305, 0.4401, 1, 2.188, "up down", s240],
s257,
[s258, "unicast", s306, 0.2753, 1, 2.278, "up down", s240],
[s260, "unicast", s306, 0.2753, 4, 0.05556, "up down", s240],
[s261, "unicast", s307, 0.6399, 1, 2.542, "up down", s240],
[s263, "unicast", s308, 0.2385, 1, 2, "up down", s240],
[s265, "unicast", s308, 0.2385, 4, 0.1997, "up down", s240],
[s266, "unicast", s309, 0.6975, 5, 1.06, "up down", s240],
[s268, "unicast", s309, 0.6975, 6, 0.06995, "up down", s240],
["User ACKNACK", "unicast", s310, 0.4362, 5, 1.562, "up down", s240],
[s270, "unicast", s310, 0.4362, 6, 0.09399, "up down", s240],
],
},
"Cyclone DDS peers": {
"group": s5,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s78, s190, s271, "Cyclone DDS peers, switching to Fast DDS with a Discovery Server", s159, s192],
[s122, s193, s271, "Cyclone DDS peers, switching to Fast DDS with two Discovery Servers", s159, s195],
[s121, s197, "", s121, s159, s198],
[s107, s161, "", s162, s159, s107],
["router", s202, "", "Zenoh router", s159, s203],
[s112, s205, "", s182, s159, s206],
[s120, s208, "", s185, s159, s209],
["announcements", s211, "", "Cyclone DDS peers, a longer announcement interval", s159, "announcements"],
["middleware", s311, "", s2, s159, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s159, "middleware"],
["middleware", s215, "", s179, s159, "middleware"],
],
},
"about": s312,
"caution": s223,
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 10],
"band": s313,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s318,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s236],
[s319, "unicast", 448, 1, 1, 6, "up down", s320],
["SPDP directed", "unicast", s321, 0.9817, 2, 0.8333, "up down", s238],
["SEDP", "unicast", s322, 0.172, 3, 1, "up down", s240],
["SEDP again", "unicast", s323, 0.8001, 4, 0.08633, "up down", s240],
["Heartbeat", "unicast", s324, 0.5756, 2, 2, "up down", s240],
[s242, "unicast", s324, 0.5756, 2, 2.944, "up down", s240],
["ACKNACK", "unicast", s325, 0.3827, 2, 4.424, "up down", s240],
[s244, "unicast", s325, 0.3827, 5, 0.2049, "up down", s240],
["Liveliness", "unicast", s326, 0.7241, 2, 1, "up down", s246],
[s248, "unicast", s327, 0.7527, 2, 1, "up down", s240],
[s250, "unicast", s327, 0.7527, 5, 0.08333, "up down", s240],
[s251, "unicast", s328, 0.2759, 2, 1, "up down", s246],
[s254, "unicast", s329, 0.4258, 2, 2.556, "up down", s240],
[s256, "unicast", 128, 1, 2, 1, "up down", s246],
[s258, "unicast", s330, 0.265, 2, 2.296, "up down", s240],
[s260, "unicast", s330, 0.265, 5, 0.09271, "up down", s240],
[s261, "unicast", s331, 0.6431, 2, 3, "up down", s240],
[s263, "unicast", s332, 0.283, 2, 2, "up down", s240],
[s265, "unicast", s332, 0.283, 5, 0.3631, "up down", s240],
[s266, "unicast", s333, 0.5405, 6, 1.542, "up down", s240],
["User ACKNACK", "unicast", s334, 0.437, 6, 2.208, "up down", s240],
],
},
"Cyclone DDS multicast SEDP": {
"group": s5,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s78, s190, s271, "Cyclone DDS multicast SEDP, switching to Fast DDS with a Discovery Server", s162, s192],
[s122, s193, s271, "Cyclone DDS multicast SEDP, switching to Fast DDS with two Discovery Servers", s162, s195],
[s121, s197, "", s121, s162, s198],
["peers", "static peers", "", s159, s162, "peers"],
["router", s202, "", "Zenoh router", s162, s203],
[s112, s205, "", s182, s162, s206],
[s120, s208, "", s185, s162, s209],
["announcements", s211, "", "Cyclone DDS multicast SEDP, a longer announcement interval", s162, "announcements"],
["middleware", s311, "", s2, s162, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s162, "middleware"],
["middleware", s215, "", s179, s162, "middleware"],
],
},
"about": s335,
"caution": s223,
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 10],
"band": s336,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s276,
"degree": 3,
"messages": [
s277,
["SPDP directed", "unicast", s337, 0.9988, 1, 0.8, "up down", s238],
["SEDP", "unicast", s338, 0.2085, 2, 0.3719, "up down", s240],
[s280, "multicast", s339, 0.2222, 2, 0.23, "up down", s240],
[s282, "multicast", s340, 0.28, 0, 1.833, "up down", s240],
["Heartbeat", "unicast", s341, 0.3143, 1, 3.333, "up down", s240],
["ACKNACK", "unicast", s342, 0.3558, 1, 4.517, "up down", s240],
[s244, "unicast", s342, 0.3558, 3, 0.1494, "up down", s240],
["Liveliness", "multicast", s343, 0.724, 0, 1, "up down", s246],
[s248, "multicast", s344, 0.9539, 0, 0.8333, "up down", s240],
[s286, "unicast", s345, 0.15, 1, 0.5, "up down", s240],
[s251, "multicast", s346, 0.276, 0, 1, "up down", s246],
[s254, "multicast", s347, 0.2328, 0, 1, "up down", s240],
[s288, "unicast", s348, 0.2318, 1, 1.75, "up down", s240],
s257,
[s258, "unicast", s349, 0.2856, 1, 2.379, "up down", s240],
[s260, "unicast", s349, 0.2856, 3, 0.08854, "up down", s240],
[s261, "multicast", s350, 0.2325, 0, 2, "up down", s240],
[s292, "unicast", s351, 0.1726, 1, 1.167, "up down", s240],
[s263, "unicast", s352, 0.2088, 1, 2, "up down", s240],
[s265, "unicast", s352, 0.2088, 3, 0.3274, "up down", s240],
[s266, "unicast", s353, 0.4167, 4, 0.7917, "up down", s240],
[s295, "multicast", s354, 0.6667, 4, 0.1667, "up down", s240],
["User ACKNACK", "unicast", s355, 0.4167, 4, 2.167, "up down", s240],
],
},
"Fast DDS Discovery Server": {
"group": s5,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s122, s151, "", s152, s149, s122],
[s96, s154, "", s155, s149, s96],
[s121, s121, "", s121, s149, s121],
["peers", s356, "", s159, s149, s357],
[s107, s358, "", s162, s149, s359],
["router", s202, "", "Zenoh router", s149, s203],
[s112, s205, "", s182, s149, s206],
[s120, s208, "", s185, s149, s209],
["middleware", s311, "", s2, s149, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s149, "middleware"],
["middleware", s215, "", s179, s149, "middleware"],
],
},
"about": s360,
"caution": "",
"ratios": s361,
"server_ratios": s164,
"has_server": true,
"color": s362,
"measured": [8, 8, 10],
"band": s363,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s372,
"degree": 2,
"messages": s408,
},
"Fast DDS Discovery Server, two": {
"group": s5,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s147, "", s149, s152, s78],
[s96, s154, "", s155, s152, s96],
[s121, s121, "", s121, s152, s121],
["peers", s356, "", s159, s152, s357],
[s107, s358, "", s162, s152, s359],
["router", s202, "", "Zenoh router", s152, s203],
[s112, s205, "", s182, s152, s206],
[s120, s208, "", s185, s152, s209],
["middleware", s311, "", s2, s152, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s152, "middleware"],
["middleware", s215, "", s179, s152, "middleware"],
],
},
"about": s409,
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": true,
"color": s362,
"measured": [8, 8, 10],
"band": s411,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s372,
"degree": 2,
"messages": s412,
},
"Fast DDS Discovery Server, on a robot": {
"group": s5,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s147, "", s149, s155, s78],
[s122, s151, "", s152, s155, s122],
[s121, s121, "", s121, s155, s121],
["peers", s356, "", s159, s155, s357],
[s107, s358, "", s162, s155, s359],
["router", s202, "", "Zenoh router", s155, s203],
[s112, s205, "", s182, s155, s206],
[s120, s208, "", s185, s155, s209],
["middleware", s311, "", s2, s155, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s155, "middleware"],
["middleware", s215, "", s179, s155, "middleware"],
],
},
"about": "one server, on a robot with processes of its own; as the table of a wired one, on other hops (measured with 2.9.1)",
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": false,
"color": s362,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms that were not used for the fit (within these limits), discovery took 0.97 to 1.16 times the predicted airtime (typical error 3%). We expect 71% of such swarms to be in this range"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": [[s413, s413, s413], [s233, s414, s414], [s415, s415, s415], [s233, {"count": "count21", "more": ["more52", "more53", "more43"]}, {"count": "count22", "more": ["more54", "more55", "more5"]}], s371, s234],
"degree": 2,
"messages": [
[s373, "unicast", 652, 1, 0, 1, "up down", s375],
[s376, "unicast", 700, 1, 0, 1, "up down", s377],
[s378, "unicast", s379, 0.865, 0, 1, "up down", s380],
[s381, "unicast", s382, 0.8517, 1, 1.967, "up down", s380],
[s383, "unicast", 192, 1, 0, 2, "up down", s380],
[s384, "unicast", s385, 0.5969, 0, 2.167, "up down", s380],
[s386, "unicast", s387, 0.3182, 1, 2.908, "up down", s380],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up down", s380],
[s388, "unicast", 190.2, 1, 1, 0.5083, "up down", s380],
[s389, "unicast", 188, 1, 0, 2, "up down", s380],
["SPDP Gap", "unicast", s390, 0.6193, 1, 1.6, "up down", s380],
[s391, "unicast", 1152, 0.45, 2, 1, "up down", s380],
[s392, "unicast", s393, 0.8446, 3, 1.237, "up down", s380],
["Heartbeat", "unicast", 192, 1, 0, 4, "up down", s380],
[s394, "unicast", 192, 1, 0, 4, "up down", s380],
[s395, "unicast", s396, 0.2358, 3, 1.892, "up down", s380],
["ACKNACK", "unicast", 188, 1, 0, 4, "up down", s380],
[s397, "unicast", 191.3, 1, 3, 0.45, "up down", s380],
[s398, "unicast", 188.5, 1, 0, 15.6, "up down", s380],
["Gap", "unicast", s399, 0.6838, 3, 0.645, "up down", s380],
[s400, "unicast", 192, 1, 0, 1, "up down", s380],
[s401, "unicast", 192, 1, 0, 2, "up down", s380],
s402,
[s403, "unicast", 188, 1, 0, 2, "up down", s380],
[s404, "unicast", 188, 1, 0, 2, "up down", s380],
s405,
s406,
s407,
],
},
"Fast DDS": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s147, "", s149, "Fast DDS", s78],
[s122, s151, "", s152, "Fast DDS", s122],
[s96, s154, "", s155, "Fast DDS", s96],
[s121, s121, "", s121, "Fast DDS", s121],
["peers", s356, "", s159, "Fast DDS", s357],
[s107, s358, "", s162, "Fast DDS", s359],
["router", s202, "", "Zenoh router", "Fast DDS", s203],
[s112, s205, "", s182, "Fast DDS", s206],
[s120, s208, "", s185, "Fast DDS", s209],
["announcements", s211, "", "Fast DDS, a longer announcement interval", "Fast DDS", "announcements"],
["release", s416, "", "Fast DDS 3.6", "Fast DDS", "release"],
["release", s417, "", "Fast DDS 2.6", "Fast DDS", "release"],
["release", s418, "", "Fast DDS 2.14", "Fast DDS", "release"],
["middleware", s311, "", s2, "Fast DDS", "middleware"],
["middleware", s215, "", s179, "Fast DDS", "middleware"],
],
},
"about": s419,
"caution": "",
"ratios": s410,
"server_ratios": {"measured": s79, "range": "1.63", "hosts": "8", "seconds": "15", "low": "1.63", "high": "1.63"},
"has_server": false,
"color": s362,
"measured": [8, 12, 60],
"band": s420,
"reboot": [1.21, 1.71],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s423,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s375],
[s424, "multicast", 580, 1, 1, 1, "up down", s380],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s427],
[s428, "unicast", 580, 1, 2, 1, "up down", s380],
[s429, "unicast", 580, 1, 3, 0.5, "up down", s380],
["SEDP", "unicast", s430, 0.6, 4, 1, "up down", s380],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s380],
[s242, "unicast", 184.3, 1, 2, 1.65, "up down", s380],
[s431, "unicast", 184.3, 1, 3, 0.4252, "up down", s380],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s380],
[s432, "unicast", 189.4, 1, 2, 2.072, "up down", s380],
[s244, "unicast", 189.4, 1, 3, 0.2616, "up down", s380],
[s251, "unicast", 192, 1, 2, 1.148, "up down", s380],
[s256, "unicast", 188, 1, 2, 1.148, "up down", s380],
[s266, "unicast", 192, 1, 5, 1.4, "up down", s380],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s380],
],
},
"Fast DDS 2.6": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s147, s148, s217, "Fast DDS", s78],
[s122, s151, s148, s218, "Fast DDS", s122],
s156,
s157,
["peers", s356, "", s159, "Fast DDS 2.6", s357],
[s107, s358, "", s162, "Fast DDS 2.6", s359],
["router", s202, "", "Zenoh router", "Fast DDS 2.6", s203],
[s112, s205, "", s182, "Fast DDS 2.6", s206],
[s120, s208, "", s185, "Fast DDS 2.6", s209],
["announcements", s211, "", "Fast DDS 2.6, a longer announcement interval", "Fast DDS 2.6", "announcements"],
["release", s416, "", "Fast DDS 3.6", "Fast DDS 2.6", "release"],
["release", s418, "", "Fast DDS 2.14", "Fast DDS 2.6", "release"],
["middleware", s433, "", "Cyclone DDS", "Fast DDS 2.6", "middleware"],
["middleware", s215, "", s179, "Fast DDS 2.6", "middleware"],
],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 2.6", "range": "0.93 to 1.97", "hosts": "12", "seconds": "15", "low": "0.93", "high": "1.97"},
"server_ratios": {"measured": "Fast DDS 2.6 with a Discovery Server", "range": "0.72 to 1.05", "hosts": "12", "seconds": "15", "low": "0.72", "high": "1.05"},
"has_server": false,
"color": s362,
"measured": [10, 20, 42],
"band": s434,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s423,
"degree": 3,
"messages": [
["SPDP", "multicast", 344, 1, 0, 1, "up down", s375],
[s424, "multicast", 344, 1, 1, 1, "up down", s380],
["SPDP unicast", "unicast", 344, 1, 2, 1, "up down", s427],
[s428, "unicast", 344, 1, 2, 1, "up down", s380],
[s429, "unicast", 344, 1, 3, 0.5, "up down", s380],
["SEDP", "unicast", s435, 0.6287, 4, 1, "up down", s380],
["Heartbeat", "unicast", 118.85, 1, 2, 2, "up down", s380],
[s242, "unicast", 118.85, 1, 2, 3.274, "up down", s380],
[s431, "unicast", 118.85, 1, 3, 0.4879, "up down", s380],
["ACKNACK", "unicast", 129.22, 1, 2, 2, "up down", s380],
[s432, "unicast", 129.22, 1, 2, 1.884, "up down", s380],
[s244, "unicast", 129.22, 1, 3, 0.3703, "up down", s380],
[s251, "unicast", 132, 1, 2, 1.125, "up down", s380],
[s256, "unicast", 128, 1, 2, 1.167, "up down", s380],
[s266, "unicast", 125.14, 1, 5, 1.575, "up down", s380],
["User ACKNACK", "unicast", 128.35, 1, 5, 1.429, "up down", s380],
[s436, "unicast", 501.7, 1, 2, 1.685, "up down", s380],
["ROS Heartbeat", "unicast", 125.14, 1, 2, 3.37, "up down", s380],
[s437, "unicast", 125.14, 1, 3, 0.1534, "up down", s380],
["ROS ACKNACK", "unicast", 128.35, 1, 2, 1.426, "up down", s380],
[s438, "unicast", 128.35, 1, 3, 0.1351, "up down", s380],
],
},
"Fast DDS 2.14": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s147, s148, s191, "Fast DDS", s78],
[s122, s151, s148, s194, "Fast DDS", s122],
s156,
s157,
["peers", s356, "", s159, "Fast DDS 2.14", s357],
[s107, s358, "", s162, "Fast DDS 2.14", s359],
["router", s202, "", "Zenoh router", "Fast DDS 2.14", s203],
[s112, s205, "", s182, "Fast DDS 2.14", s206],
[s120, s208, "", s185, "Fast DDS 2.14", s209],
["announcements", s211, "", "Fast DDS 2.14, a longer announcement interval", "Fast DDS 2.14", "announcements"],
["release", s416, "", "Fast DDS 3.6", "Fast DDS 2.14", "release"],
["release", s417, "", "Fast DDS 2.6", "Fast DDS 2.14", "release"],
["middleware", s433, "", "Cyclone DDS", "Fast DDS 2.14", "middleware"],
["middleware", s215, "", s179, "Fast DDS 2.14", "middleware"],
],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 2.14", "range": "0.82 to 1.19", "hosts": "12", "seconds": "15", "low": "0.82", "high": "1.19"},
"server_ratios": {"measured": "Fast DDS 2.14 with a Discovery Server", "range": "1.04 to 1.19", "hosts": "12", "seconds": "15", "low": "1.04", "high": "1.19"},
"has_server": false,
"color": s362,
"measured": [10, 20, 42],
"band": s439,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s440,
"degree": 3,
"messages": [
["SPDP", "multicast", 560, 1, 0, 1, "up down", s375],
["SPDP unicast", "unicast", 560, 1, 1, 1, "up down", s427],
[s428, "unicast", 560, 1, 1, 1, "up down", s380],
["SEDP", "unicast", s441, 0.6008, 2, 1, "up down", s380],
["Heartbeat", "unicast", 183.8, 1, 1, 2, "up down", s380],
[s242, "unicast", 183.8, 1, 1, 2.375, "up down", s380],
["ACKNACK", "unicast", 189.7, 1, 1, 2, "up down", s380],
[s432, "unicast", 189.7, 1, 1, 2.625, "up down", s380],
[s251, "unicast", 192, 1, 1, 1.125, "up down", s380],
[s256, "unicast", 188, 1, 1, 1.216, "up down", s380],
[s266, "unicast", 183.7, 1, 3, 1.5, "up down", s380],
["User ACKNACK", "unicast", 189, 1, 3, 1.554, "up down", s380],
[s436, "unicast", 480, 1, 1, 1.037, "up down", s380],
["ROS Heartbeat", "unicast", 183.7, 1, 1, 0.7995, "up down", s380],
[s437, "unicast", 183.7, 1, 4, 0.288, "up down", s380],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.9597, "up down", s380],
[s438, "unicast", 189, 1, 4, 0.1806, "up down", s380],
],
},
"Fast DDS 3.6": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [[s78, s147, s442, "Fast DDS 3.6, a Discovery Server", "Fast DDS", s78], [s122, s151, s442, "Fast DDS 3.6, two Discovery Servers", "Fast DDS", s122], s157, s443, s444, s445, s446, s447, s448, s449, s450, ["middleware", s311, "", s2, "Fast DDS 3.6", "middleware"], s451],
"kilted": [[s78, s147, s148, s219, "Fast DDS", s78], [s122, s151, s148, s220, "Fast DDS", s122], s156, s157, s443, s444, s445, s446, s447, s448, s449, s450, ["middleware", s433, "", "Cyclone DDS", "Fast DDS 3.6", "middleware"], s451],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 3.6", "range": "0.83 to 1.07", "hosts": "12", "seconds": "15", "low": "0.83", "high": "1.07"},
"server_ratios": {"measured": "Fast DDS 3.6 with a Discovery Server", "range": "1.09 to 1.15", "hosts": "12", "seconds": "15", "low": "1.09", "high": "1.15"},
"has_server": false,
"color": s362,
"measured": [10, 20, 42],
"band": s452,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s453,
"degree": 3,
"messages": [
["SPDP", "multicast", 632, 1, 0, 1, "up down", s375],
["SPDP unicast", "unicast", 632, 1, 1, 1, "up down", s427],
[s428, "unicast", 632, 1, 1, 1, "up down", s380],
["SEDP", "unicast", s454, 0.6318, 2, 1, "up down", s380],
["Heartbeat", "unicast", 184.3, 1, 1, 2, "up down", s380],
[s242, "unicast", 184.3, 1, 1, 2.13, "up down", s380],
["ACKNACK", "unicast", 189.6, 1, 1, 2, "up down", s380],
[s432, "unicast", 189.6, 1, 1, 2.204, "up down", s380],
[s251, "unicast", 192, 1, 1, 1.046, "up down", s380],
[s256, "unicast", 188, 1, 1, 1.083, "up down", s380],
[s266, "unicast", 178.8, 1, 3, 1.306, "up down", s380],
["User ACKNACK", "unicast", 189, 1, 3, 1.633, "up down", s380],
[s436, "unicast", 459.4, 1, 1, 1.15, "up down", s380],
[s261, "unicast", s455, 0.9914, 1, 2.303, "up down", s380],
[s263, "unicast", 188, 1, 1, 2.5, "up down", s380],
["Type lookup", "unicast", s456, 0.2383, 4, 3.917, "up down", s380],
["ROS Heartbeat", "unicast", 178.8, 1, 1, 3.687, "up down", s380],
[s437, "unicast", 178.8, 1, 5, 0.1285, "up down", s380],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.4578, "up down", s380],
[s438, "unicast", 189, 1, 5, 0.2066, "up down", s380],
],
},
"hybrid": {
"group": s8,
"family": null,
"product": null,
"tables": {"any": []},
"about": "this book's proposal, for hosts with unlike software",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s457,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s458,
"windows": s459,
"units": [s461, s171, s368, s463, s317],
"degree": 2,
"messages": [s465, s466, s467, s468, s469, s471, s472],
},
"hybrid, alike": {
"group": s8,
"family": null,
"product": null,
"tables": {"any": []},
"about": "this book's proposal, for hosts that are alike",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s457,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s458,
"windows": s459,
"units": [s461, s171, [s473, s473, s473], s463, s317],
"degree": 2,
"messages": [s465, s466, ["Software", "multicast", 8, 0, 0, 1, "up down", s464], s467, s468, s469, s471, s472],
},
"DDS, periods of Fast DDS": {
"group": s7,
"family": "DDS",
"product": null,
"tables": {"any": [s150, s153, s156, s157, s160, s163, ["middleware", s474, "", s475, s476, "middleware"], ["middleware", s477, "", s478, s476, "middleware"]]},
"about": "",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s362,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s188,
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s375], ["UnicastSPDP", "unicast", 414, 1, 1, 1, "up down", s375], ["SEDP", "unicast", 464, 1, 2, 1, "up down", s380], ["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s380], ["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s380]],
},
"DDS, periods of Cyclone DDS": {
"group": s7,
"family": "DDS",
"product": null,
"tables": {"any": [s150, s153, s156, s157, s160, s163, ["middleware", s479, "", s476, s475, "middleware"], ["middleware", s477, "", s478, s475, "middleware"]]},
"about": "",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s188,
"degree": 2,
"messages": [
["SPDP", "multicast", 414, 1, 0, 1, "up down", s236],
["DirectedSPDP", "unicast", 414, 1, 1, 1, "up down", s238],
["SEDP", "unicast", 464, 1, 2, 1, "up down", s240],
["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s240],
["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s240],
["Liveliness", "unicast", 180, 1, 1, 1, "up down", s320],
["LivelinessACK", "unicast", 114, 1, 1, 1, "up down", s320],
],
},
"Zenoh, periods of Zenoh peer": {
"group": s7,
"family": "Zenoh",
"product": null,
"tables": {"any": [s180, s183, s186, ["peers", "static peers", "", "Zenoh, periods of Zenoh peer, static peers", s478, "peers"], ["middleware", s479, "", s476, s478, "middleware"], ["middleware", s474, "", s475, s478, "middleware"]]},
"about": "",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s480,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s188,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s481], ["Hello", "unicast", 144, 1, 1, 1, "up down", s481], ["Declare", "unicast", 176, 1, 2, 1, "up down", s240], s483],
},
"static endpoints": {
"group": s5,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s78, s147, "", s149, s121, s78],
[s122, s151, "", s152, s121, s122],
[s96, s154, "", s155, s121, s96],
["peers", s356, "", s159, s121, s357],
[s107, s358, "", s162, s121, s359],
["router", s202, "", "Zenoh router", s121, s203],
[s112, s205, "", s182, s121, s206],
[s120, s208, "", s185, s121, s209],
["announcements", s211, "", "static endpoints, a longer announcement interval", s121, "announcements"],
["middleware", s311, "", s2, s121, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s121, "middleware"],
["middleware", s215, "", s179, s121, "middleware"],
],
},
"about": s484,
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": false,
"color": s362,
"measured": [8, 8, 84],
"band": s485,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s364,
"windows": s365,
"units": s489,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s375],
[s424, "multicast", 589.2, 1, 1, 1, "up down", s380],
[s490, "multicast", 589.2, 1, 2, 1, "up down", s380],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s427],
[s428, "unicast", 589.2, 1, 3, 1, "up down", s380],
[s429, "unicast", 589.2, 1, 4, 0.5, "up down", s380],
[s491, "unicast", 589.2, 1, 5, 0.6542, "up down", s380],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s427],
[s492, "multicast", 59.47, 0, 6, 0.8987, "up down", s380],
[s493, "multicast", 59.47, 0, 7, 0.8987, "up down", s380],
[s494, "unicast", 59.47, 0, 5, 1, "up down", s427],
[s495, "unicast", 59.47, 0, 5, 0.9528, "up down", s380],
[s496, "unicast", 59.47, 0, 8, 0.4764, "up down", s380],
[s497, "unicast", 59.47, 0, 9, 0.6233, "up down", s380],
[s251, "unicast", 192, 1, 3, 1.167, "up down", s380],
[s256, "unicast", 188, 1, 3, 1.167, "up down", s380],
[s266, "unicast", 192, 1, 10, 1.33, "up down", s380],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s380],
],
},
"Zenoh peer": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s190, s271, "Zenoh peer, switching to Fast DDS with a Discovery Server", "Zenoh peer", s192],
[s122, s193, s271, "Zenoh peer, switching to Fast DDS with two Discovery Servers", "Zenoh peer", s195],
[s121, s197, "", s121, "Zenoh peer", s198],
["peers", s356, "", s159, "Zenoh peer", s357],
[s107, s358, "", s162, "Zenoh peer", s359],
s180,
s183,
s186,
["peers", "static peers", "", "Zenoh peer, static peers", "Zenoh peer", "peers"],
["middleware", s311, "", s2, "Zenoh peer", "middleware"],
["middleware", s221, "", "Fast DDS 3.6", "Zenoh peer", "middleware"],
],
},
"about": s498,
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s480,
"measured": [8, 12, 60],
"band": s499,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s501,
"degree": 3,
"messages": [
s502,
s503,
["Hello first", "unicast", 104, 1, 1, 0.5833, "up down", s240],
["InitSyn", "unicast", 110, 1, 1, 0.6667, "up down", s240],
s504,
s505,
s506,
["OAM", "unicast", s507, 0.835, 1, 1, "up down", s240],
[s508, "unicast", s507, 0.835, 2, 0.625, "up down", s240],
["Declare", "unicast", s509, 0.1957, 3, 0.5, "up down", s240],
[s510, "unicast", s511, 0.8037, 4, 0.5, "up down", s240],
[s512, "unicast", s511, 0.8037, 5, 0.5, "up down", s240],
["Declare final", "unicast", 176, 0.05, 1, 1, "up down", s240],
["Frame", "unicast", s513, 0.2478, 1, 1, "up down", s240],
[s514, "unicast", s513, 0.2478, 3, 0.6083, "up down", s240],
s515,
s516,
["TCP ACK", "unicast", 76, 1, 1, 0.8708, "up down", s482],
[s517, "unicast", 76, 1, 1, 2.496, "up down", s240],
[s518, "unicast", 76, 1, 3, 0.2188, "up down", s240],
],
},
"Zenoh peer, tokens": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s190, s271, "Zenoh peer, tokens, switching to Fast DDS with a Discovery Server", s179, s192],
[s122, s193, s271, "Zenoh peer, tokens, switching to Fast DDS with two Discovery Servers", s179, s195],
[s121, s197, "", s121, s179, s198],
["peers", s356, "", s159, s179, s357],
[s107, s358, "", s162, s179, s359],
["router", s177, "", "Zenoh router", s179, "router"],
[s112, s181, "", s182, s179, s112],
[s120, s184, "", s185, s179, s120],
["peers", "static peers", "", "Zenoh peer, tokens, static peers", s179, "peers"],
["middleware", s311, "", s2, s179, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s179, "middleware"],
],
},
"about": s519,
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s480,
"measured": [8, 12, 60],
"band": s520,
"reboot": [0.896, 1.43],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s501,
"degree": 3,
"messages": [
s502,
s503,
["Hello first", "unicast", 104, 1, 1, 0.5, "up down", s240],
["InitSyn", "unicast", 109.86, 1, 1, 0.6667, "up down", s240],
s504,
s505,
s506,
["OAM", "unicast", s521, 0.7058, 1, 1, "up down", s240],
[s508, "unicast", s521, 0.7058, 2, 0.6493, "up down", s240],
["Declare", "unicast", s522, 0.0655, 3, 0.5, "up down", s240],
["Declare token", "unicast", s523, 0.0603, 3, 1, "up down", s240],
[s524, "unicast", s523, 0.0603, 1, 1, "up down", s240],
[s510, "unicast", s525, 0.5972, 4, 1.5, "up down", s240],
[s512, "unicast", s525, 0.5972, 5, 2.5, "up down", s240],
[s526, "unicast", s525, 0.5972, 1, 1, "up down", s240],
["Declare final", "unicast", s527, 0.06, 1, 1, "up down", s240],
["Frame", "unicast", s528, 0.1352, 1, 2, "up down", s240],
[s514, "unicast", s528, 0.1352, 3, 1, "up down", s240],
s515,
s516,
["TCP ACK", "unicast", 76, 1, 1, 0.7208, "up down", s482],
[s517, "unicast", 76, 1, 1, 3.325, "up down", s240],
[s518, "unicast", 76, 1, 3, 0.4208, "up down", s240],
],
},
"Zenoh router": {
"group": s5,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s190, s271, "Zenoh router, switching to Fast DDS with a Discovery Server", "Zenoh router", s192],
[s122, s193, s271, "Zenoh router, switching to Fast DDS with two Discovery Servers", "Zenoh router", s195],
[s121, s197, "", s121, "Zenoh router", s198],
["peers", s356, "", s159, "Zenoh router", s357],
[s107, s358, "", s162, "Zenoh router", s359],
[s112, s181, "", s182, "Zenoh router", s112],
[s120, s184, "", s185, "Zenoh router", s120],
["middleware", s311, "", s2, "Zenoh router", "middleware"],
["middleware", s221, "", "Fast DDS 3.6", "Zenoh router", "middleware"],
["middleware", s215, "", s179, "Zenoh router", "middleware"],
],
},
"about": "one router, wired to the access point, and every process its client, with liveliness tokens, as rmw_zenoh has them (measured with 1.10.2)",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": true,
"color": s529,
"measured": [8, 12, 10],
"band": [[1, 1, 1, "In 7 swarms that were not used for the fit (within these limits), discovery took 0.84 to 1.18 times the predicted airtime (typical error 10%). We expect 75% of such swarms to be in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s530,
"windows": s531,
"units": [s171, s368, s532, [s233, {"count": "count30", "more": ["more69", "more70"]}, {"count": "count31", "more": ["more71", "more72"]}], s422, s486],
"degree": 2,
"messages": [
["TCP SYN", "unicast", 76, 1, 0, 1, "up", s533],
["TCP SYN-ACK", "unicast", 76, 1, 0, 1, "down", s533],
s534,
s535,
s536,
s537,
["Interest in tokens", "unicast", s538, 0.08917, 0, 1, "up", s533],
["Interest of publishers", "unicast", s538, 0.08917, 1, 0.5, "up", s533],
["Declare", "unicast", 144.9655172413793, 0.087, 1, 0.5, "up", s533],
[s524, "unicast", s539, 0.05144, 0, 1, "up", s533],
["Declare token", "unicast", s539, 0.05144, 1, 1, "up", s533],
[s526, "unicast", s540, 0.5213, 0, 2, "up", s533],
[s510, "unicast", s540, 0.5213, 1, 1.5, "up", s533],
["Declare key expression of unmatched", "unicast", s540, 0.5213, 2, 0.5, "up", s533],
["Frame up", "unicast", s541, 0.1456, 0, 1.417, "up", s533],
["Frame of endpoints up", "unicast", s541, 0.1456, 1, 1.292, "up", s533],
["Declare passed on", "unicast", 125.74016332590944, 0.1347, 3, 1, "down", s533],
["Declare token of own node", "unicast", s542, 0.0309, 0, 1, "down", s533],
["Declare own token", "unicast", s542, 0.0309, 1, 1, "down", s533],
["Declare token of node passed on", "unicast", s542, 0.0309, 4, 1, "down", s533],
["Declare token passed on", "unicast", s542, 0.0309, 5, 1, "down", s533],
["Declare key expression of node passed on", "unicast", s543, 0.3319, 4, 1, "down", s533],
["Declare key expression passed on", "unicast", s543, 0.3319, 5, 1, "down", s533],
["Declare final", "unicast", s544, 0.06875, 0, 1, "down", s533],
["Declare final to publishers", "unicast", s544, 0.06875, 1, 0.5, "down", s533],
["Frame down", "unicast", s545, 0.1116, 0, 3.188, "down", s533],
["Frame of endpoints down", "unicast", s545, 0.1116, 1, 1.206, "down", s533],
["Frame of others down", "unicast", s545, 0.1116, 5, 0.025, "down", s533],
["KeepAlive up", "unicast", 79, 1, 0, 1, "up", s547],
s548,
["TCP ACK up", "unicast", 76, 1, 0, 1, "up", s547],
["TCP ACK down", "unicast", 76, 1, 0, 0.5, "down", s547],
["TCP ACK at start up", "unicast", 76, 1, 0, 1.761, "up", s533],
["TCP ACK of endpoints up", "unicast", 76, 1, 1, 0.5636, "up", s533],
["TCP ACK of others up", "unicast", 76, 1, 4, 0.7871, "up", s533],
[s549, "unicast", 76, 1, 0, 4.104, "down", s533],
[s550, "unicast", 76, 1, 1, 0.07292, "down", s533],
],
},
"Zenoh router per host": {
"group": s5,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s190, s271, "Zenoh router per host, switching to Fast DDS with a Discovery Server", s182, s192],
[s122, s193, s271, "Zenoh router per host, switching to Fast DDS with two Discovery Servers", s182, s195],
[s121, s197, "", s121, s182, s198],
["peers", s356, "", s159, s182, s357],
[s107, s358, "", s162, s182, s359],
["router", s177, "", "Zenoh router", s182, "router"],
[s120, s184, "", s185, s182, s120],
["middleware", s311, "", s2, s182, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s182, "middleware"],
["middleware", s215, "", s179, s182, "middleware"],
],
},
"about": "a router on each host, as rmw_zenoh has it, linked with all others; processes meet their own host's on loopback (measured with 1.10.2)",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s529,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 11 swarms that were not used for the fit (within these limits), discovery took 0.84 to 1.25 times the predicted airtime (typical error 2%). We expect 83% of such swarms to be in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s530,
"windows": s531,
"units": [s317, [s551, s551, s551], [s552, s552, s552], s554, s555, s556, s315],
"degree": 4,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up down", s533],
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s533],
["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s533],
["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s533],
["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s533],
["OAM", "unicast", s557, 0.04144, 0, 2, "up down", s533],
["OAM of third hosts", "unicast", s558, 0.03176, 1, 0.3843, "up down", s533],
["OAM passed on", "unicast", s558, 0.03176, 2, 0.4715, "up down", s533],
[s559, "unicast", s560, 0.8637, 0, 4.25, "up down", s533],
["Frame of gossip passed on", "unicast", s560, 0.8637, 1, 1.6, "up down", s533],
[s514, "unicast", s560, 0.8637, 3, 0.775, "up down", s533],
["Declare", "unicast", s557, 0.004144, 4, 0.5, "up down", s533],
[s561, "unicast", s557, 0.004144, 5, 0.5, "up down", s533],
[s524, "unicast", s557, 0.004144, 6, 1, "up down", s533],
["Declare token", "unicast", s557, 0.004144, 3, 1, "up down", s533],
[s510, "unicast", s562, 0.1138, 4, 0.5, "up down", s533],
[s512, "unicast", s562, 0.1138, 5, 0.2634, "up down", s533],
[s563, "unicast", s562, 0.1138, 3, 1, "up down", s533],
[s526, "unicast", s562, 0.1138, 6, 1, "up down", s533],
["KeepAlive", "unicast", 79, 1, 0, 1, "up down", s547],
["TCP ACK", "unicast", 76, 1, 0, 0.55, "up down", s547],
[s517, "unicast", 76, 1, 0, 6.597, "up down", s533],
["TCP ACK of gossip", "unicast", 76, 1, 1, 0.2278, "up down", s533],
[s518, "unicast", 76, 1, 3, 0.1124, "up down", s533],
],
},
"Zenoh router per host, star": {
"group": s5,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s78, s190, s271, "Zenoh router per host, star, switching to Fast DDS with a Discovery Server", s185, s192],
[s122, s193, s271, "Zenoh router per host, star, switching to Fast DDS with two Discovery Servers", s185, s195],
[s121, s197, "", s121, s185, s198],
["peers", s356, "", s159, s185, s357],
[s107, s358, "", s162, s185, s359],
["router", s177, "", "Zenoh router", s185, "router"],
[s112, s181, "", s182, s185, s112],
["middleware", s311, "", s2, s185, "middleware"],
["middleware", s221, "", "Fast DDS 3.6", s185, "middleware"],
["middleware", s215, "", s179, s185, "middleware"],
],
},
"about": "a router on each host, as rmw_zenoh has it, linked with one router that is wired to the access point; processes meet their own host's on loopback (measured with 1.10.2)",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": true,
"color": s529,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 6 swarms that were not used for the fit (within these limits), discovery took 0.85 to 1.18 times the predicted airtime (typical error 15%). We expect 71% of such swarms to be in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s530,
"windows": s531,
"units": [s461, s317, s368, s532, [s233, {"count": "count38", "more": ["more90", "more86"]}, {"count": "count39", "more": ["more91", "more89"]}], s171, s315, s555, s556, s554, s463],
"degree": 2,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up", s533],
["TCP control down", "unicast", 76, 1, 0, 1, "down", s533],
s534,
s535,
s536,
s537,
["OAM", "unicast", s564, 0.03601, 0, 2, "up", s533],
["OAM of others", "unicast", s564, 0.03601, 1, 1.045, "up", s533],
[s559, "unicast", s565, 0.8894, 0, 12.18, "up", s533],
[s514, "unicast", s565, 0.8894, 2, 0.4077, "up", s533],
["Declare", "unicast", s557, 0.004144, 3, 0.5, "up", s533],
[s561, "unicast", s557, 0.004144, 4, 0.5, "up", s533],
[s524, "unicast", s557, 0.004144, 5, 1, "up", s533],
["Declare token", "unicast", s557, 0.004144, 2, 1, "up", s533],
[s510, "unicast", s566, 0.1159, 3, 0.5, "up", s533],
[s512, "unicast", s566, 0.1159, 4, 0.1042, "up", s533],
[s563, "unicast", s566, 0.1159, 2, 1, "up", s533],
[s526, "unicast", s566, 0.1159, 5, 1, "up", s533],
["KeepAlive", "unicast", 79, 1, 0, 1, "up", s547],
["TCP ACK", "unicast", 76, 1, 0, 1, "up", s547],
[s517, "unicast", 76, 1, 0, 3.783, "up", s533],
["TCP ACK of processes", "unicast", 76, 1, 6, 1.217, "up", s533],
["OAM down", "unicast", s567, 0.04874, 0, 2, "down", s533],
["OAM of others down", "unicast", s567, 0.04874, 1, 1.045, "down", s533],
["Frame of gossip down", "unicast", 87.23315027458811, 0.8012, 0, 26.88, "down", s533],
["Declare down", "unicast", s568, 0.005525, 7, 0.5, "down", s533],
["Declare of matching down", "unicast", s568, 0.005525, 8, 0.5, "down", s533],
["Declare token of node down", "unicast", s568, 0.005525, 6, 1, "down", s533],
["Declare token down", "unicast", s568, 0.005525, 9, 1, "down", s533],
["Declare key expression down", "unicast", s566, 0.1159, 7, 0.5, "down", s533],
["Declare key expression of matching down", "unicast", s566, 0.1159, 8, 0.0625, "down", s533],
["Declare key expression of tokens down", "unicast", s566, 0.1159, 9, 1, "down", s533],
["Declare key expression of node down", "unicast", s566, 0.1159, 6, 1, "down", s533],
s548,
["TCP ACK down", "unicast", 76, 1, 10, 1, "down", s547],
[s549, "unicast", 76, 1, 0, 4.958, "down", s533],
[s550, "unicast", 76, 1, 2, 0.1354, "down", s533],
],
},
"Zenoh, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s187,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s168,
"windows": s169,
"units": s569,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s176], s189],
},
"Fast DDS 2.14 Discovery Server": s570,
"Fast DDS 2.14 Discovery Server, two": s571,
"Cyclone DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s222,
"caution": s223,
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 60],
"band": s226,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s235,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s574],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s575],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s576],
["SEDP", "unicast", s239, 0.2218, 2, 1, "up down", s577],
["SEDP again", "unicast", s239, 0.2218, 3, 0.103, "up down", s577],
["Heartbeat", "unicast", s241, 0.5226, 1, 2, "up down", s577],
[s242, "unicast", s241, 0.5226, 1, 2.481, "up down", s577],
["ACKNACK", "unicast", s243, 0.402, 1, 4.635, "up down", s577],
[s244, "unicast", s243, 0.402, 4, 0.09896, "up down", s577],
s580,
[s248, "unicast", s249, 0.6253, 1, 1, "up down", s577],
[s250, "unicast", s249, 0.6253, 4, 0.1067, "up down", s577],
s581,
[s254, "unicast", s255, 0.4544, 1, 2.222, "up down", s577],
s582,
[s258, "unicast", s259, 0.3044, 1, 2.312, "up down", s577],
[s260, "unicast", s259, 0.3044, 4, 0.05208, "up down", s577],
[s261, "unicast", s262, 0.6806, 1, 2.333, "up down", s577],
[s263, "unicast", s264, 0.2641, 1, 2, "up down", s577],
[s265, "unicast", s264, 0.2641, 4, 0.2188, "up down", s577],
[s266, "unicast", s267, 0.6247, 5, 1.006, "up down", s577],
[s268, "unicast", s267, 0.6247, 6, 0.07217, "up down", s577],
["User ACKNACK", "unicast", s269, 0.338, 5, 1.404, "up down", s577],
[s270, "unicast", s269, 0.338, 6, 0.09793, "up down", s577],
],
},
"Fast DDS 2.6 Discovery Server": s570,
"Fast DDS 2.6 Discovery Server, two": s571,
"Fast DDS 3.6 Discovery Server": s570,
"Fast DDS 3.6 Discovery Server, two": s571,
"Cyclone DDS, wired, switching to Fast DDS with a Discovery Server": s584,
"Cyclone DDS, wired, switching to Fast DDS with two Discovery Servers": s585,
"Cyclone DDS, wired, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s274,
"caution": s223,
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 20],
"band": s275,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s276,
"degree": 3,
"messages": [
s586,
["SPDP directed", "unicast", s278, 0.9963, 1, 0.6667, "up down", s576],
["SEDP", "unicast", s279, 0.1841, 2, 0.5833, "up down", s577],
[s280, "multicast", s281, 0.2228, 2, 0.1667, "up down", s577],
[s282, "multicast", 232, 0.25, 0, 2, "up down", s577],
["Heartbeat", "unicast", s283, 0.3287, 1, 3, "up down", s577],
["ACKNACK", "unicast", s284, 0.3715, 1, 4.05, "up down", s577],
[s244, "unicast", s284, 0.3715, 3, 0.2833, "up down", s577],
["Liveliness", "multicast", s245, 0.7242, 0, 1, "up down", s579],
[s248, "multicast", s285, 0.9582, 0, 0.3333, "up down", s577],
[s286, "unicast", 429, 0.2, 1, 0.5, "up down", s577],
[s251, "multicast", s252, 0.2758, 0, 1, "up down", s579],
[s254, "multicast", s287, 0.1767, 0, 0.875, "up down", s577],
[s288, "unicast", s289, 0.2117, 1, 1.625, "up down", s577],
s582,
[s258, "unicast", s290, 0.2807, 1, 2.344, "up down", s577],
[s260, "unicast", s290, 0.2807, 3, 0.07812, "up down", s577],
[s261, "multicast", s291, 0.1988, 0, 2, "up down", s577],
[s292, "unicast", s293, 0.1917, 1, 0.6667, "up down", s577],
[s263, "unicast", 211.5, 0.2, 1, 2, "up down", s577],
[s265, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s577],
[s266, "unicast", s294, 0.2427, 4, 0.75, "up down", s577],
[s295, "multicast", s296, 0.2152, 4, 0.25, "up down", s577],
["User ACKNACK", "unicast", s297, 0.2283, 4, 2, "up down", s577],
],
},
"Cyclone DDS, version 11, switching to Fast DDS with a Discovery Server": s584,
"Cyclone DDS, version 11, switching to Fast DDS with two Discovery Servers": s585,
"Cyclone DDS, version 11, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s298,
"caution": s223,
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 60],
"band": s299,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s235,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s574],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s575],
["SPDP directed", "unicast", s300, 0.9992, 1, 0.5413, "up down", s576],
["SEDP", "unicast", s301, 0.4598, 2, 1, "up down", s577],
["SEDP again", "unicast", s301, 0.4598, 3, 0.09093, "up down", s577],
["Heartbeat", "unicast", s302, 0.5475, 1, 2, "up down", s577],
[s242, "unicast", s302, 0.5475, 1, 2.833, "up down", s577],
["ACKNACK", "unicast", s303, 0.3982, 1, 5.167, "up down", s577],
[s244, "unicast", s303, 0.3982, 4, 0.125, "up down", s577],
s580,
[s248, "unicast", s304, 0.6519, 1, 1, "up down", s577],
[s250, "unicast", s304, 0.6519, 4, 0.09103, "up down", s577],
s581,
[s254, "unicast", s305, 0.4401, 1, 2.188, "up down", s577],
s582,
[s258, "unicast", s306, 0.2753, 1, 2.278, "up down", s577],
[s260, "unicast", s306, 0.2753, 4, 0.05556, "up down", s577],
[s261, "unicast", s307, 0.6399, 1, 2.542, "up down", s577],
[s263, "unicast", s308, 0.2385, 1, 2, "up down", s577],
[s265, "unicast", s308, 0.2385, 4, 0.1997, "up down", s577],
[s266, "unicast", s309, 0.6975, 5, 1.06, "up down", s577],
[s268, "unicast", s309, 0.6975, 6, 0.06995, "up down", s577],
["User ACKNACK", "unicast", s310, 0.4362, 5, 1.562, "up down", s577],
[s270, "unicast", s310, 0.4362, 6, 0.09399, "up down", s577],
],
},
"Cyclone DDS peers, switching to Fast DDS with a Discovery Server": s584,
"Cyclone DDS peers, switching to Fast DDS with two Discovery Servers": s585,
"Cyclone DDS peers, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s312,
"caution": s223,
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 10],
"band": s313,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s318,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s574],
[s319, "unicast", 448, 1, 1, 6, "up down", {"burst": 1, "second": 1.125, "lease": 0.135, "ever": 0.125}],
["SPDP directed", "unicast", s321, 0.9817, 2, 0.8333, "up down", s576],
["SEDP", "unicast", s322, 0.172, 3, 1, "up down", s577],
["SEDP again", "unicast", s323, 0.8001, 4, 0.08633, "up down", s577],
["Heartbeat", "unicast", s324, 0.5756, 2, 2, "up down", s577],
[s242, "unicast", s324, 0.5756, 2, 2.944, "up down", s577],
["ACKNACK", "unicast", s325, 0.3827, 2, 4.424, "up down", s577],
[s244, "unicast", s325, 0.3827, 5, 0.2049, "up down", s577],
["Liveliness", "unicast", s326, 0.7241, 2, 1, "up down", s579],
[s248, "unicast", s327, 0.7527, 2, 1, "up down", s577],
[s250, "unicast", s327, 0.7527, 5, 0.08333, "up down", s577],
[s251, "unicast", s328, 0.2759, 2, 1, "up down", s579],
[s254, "unicast", s329, 0.4258, 2, 2.556, "up down", s577],
[s256, "unicast", 128, 1, 2, 1, "up down", s579],
[s258, "unicast", s330, 0.265, 2, 2.296, "up down", s577],
[s260, "unicast", s330, 0.265, 5, 0.09271, "up down", s577],
[s261, "unicast", s331, 0.6431, 2, 3, "up down", s577],
[s263, "unicast", s332, 0.283, 2, 2, "up down", s577],
[s265, "unicast", s332, 0.283, 5, 0.3631, "up down", s577],
[s266, "unicast", s333, 0.5405, 6, 1.542, "up down", s577],
["User ACKNACK", "unicast", s334, 0.437, 6, 2.208, "up down", s577],
],
},
"Cyclone DDS multicast SEDP, switching to Fast DDS with a Discovery Server": s584,
"Cyclone DDS multicast SEDP, switching to Fast DDS with two Discovery Servers": s585,
"Cyclone DDS multicast SEDP, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s335,
"caution": s223,
"ratios": s224,
"server_ratios": s164,
"has_server": false,
"color": s225,
"measured": [8, 12, 10],
"band": s336,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s276,
"degree": 3,
"messages": [
s586,
["SPDP directed", "unicast", s337, 0.9988, 1, 0.8, "up down", s576],
["SEDP", "unicast", s338, 0.2085, 2, 0.3719, "up down", s577],
[s280, "multicast", s339, 0.2222, 2, 0.23, "up down", s577],
[s282, "multicast", s340, 0.28, 0, 1.833, "up down", s577],
["Heartbeat", "unicast", s341, 0.3143, 1, 3.333, "up down", s577],
["ACKNACK", "unicast", s342, 0.3558, 1, 4.517, "up down", s577],
[s244, "unicast", s342, 0.3558, 3, 0.1494, "up down", s577],
["Liveliness", "multicast", s343, 0.724, 0, 1, "up down", s579],
[s248, "multicast", s344, 0.9539, 0, 0.8333, "up down", s577],
[s286, "unicast", s345, 0.15, 1, 0.5, "up down", s577],
[s251, "multicast", s346, 0.276, 0, 1, "up down", s579],
[s254, "multicast", s347, 0.2328, 0, 1, "up down", s577],
[s288, "unicast", s348, 0.2318, 1, 1.75, "up down", s577],
s582,
[s258, "unicast", s349, 0.2856, 1, 2.379, "up down", s577],
[s260, "unicast", s349, 0.2856, 3, 0.08854, "up down", s577],
[s261, "multicast", s350, 0.2325, 0, 2, "up down", s577],
[s292, "unicast", s351, 0.1726, 1, 1.167, "up down", s577],
[s263, "unicast", s352, 0.2088, 1, 2, "up down", s577],
[s265, "unicast", s352, 0.2088, 3, 0.3274, "up down", s577],
[s266, "unicast", s353, 0.4167, 4, 0.7917, "up down", s577],
[s295, "multicast", s354, 0.6667, 4, 0.1667, "up down", s577],
["User ACKNACK", "unicast", s355, 0.4167, 4, 2.167, "up down", s577],
],
},
"Fast DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s419,
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": false,
"color": s362,
"measured": [8, 12, 60],
"band": s420,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s423,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s588],
[s424, "multicast", 580, 1, 1, 1, "up down", s577],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s589],
[s428, "unicast", 580, 1, 2, 1, "up down", s577],
[s429, "unicast", 580, 1, 3, 0.5, "up down", s577],
["SEDP", "unicast", s430, 0.6, 4, 1, "up down", s577],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s577],
[s242, "unicast", 184.3, 1, 2, 1.65, "up down", s577],
[s431, "unicast", 184.3, 1, 3, 0.4252, "up down", s577],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s577],
[s432, "unicast", 189.4, 1, 2, 2.072, "up down", s577],
[s244, "unicast", 189.4, 1, 3, 0.2616, "up down", s577],
[s251, "unicast", 192, 1, 2, 1.148, "up down", s577],
[s256, "unicast", 188, 1, 2, 1.148, "up down", s577],
[s266, "unicast", 192, 1, 5, 1.4, "up down", s577],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s577],
],
},
"Fast DDS 2.6, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": false,
"color": s362,
"measured": [10, 20, 42],
"band": s434,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s423,
"degree": 3,
"messages": [
["SPDP", "multicast", 344, 1, 0, 1, "up down", s588],
[s424, "multicast", 344, 1, 1, 1, "up down", s577],
["SPDP unicast", "unicast", 344, 1, 2, 1, "up down", s589],
[s428, "unicast", 344, 1, 2, 1, "up down", s577],
[s429, "unicast", 344, 1, 3, 0.5, "up down", s577],
["SEDP", "unicast", s435, 0.6287, 4, 1, "up down", s577],
["Heartbeat", "unicast", 118.85, 1, 2, 2, "up down", s577],
[s242, "unicast", 118.85, 1, 2, 3.274, "up down", s577],
[s431, "unicast", 118.85, 1, 3, 0.4879, "up down", s577],
["ACKNACK", "unicast", 129.22, 1, 2, 2, "up down", s577],
[s432, "unicast", 129.22, 1, 2, 1.884, "up down", s577],
[s244, "unicast", 129.22, 1, 3, 0.3703, "up down", s577],
[s251, "unicast", 132, 1, 2, 1.125, "up down", s577],
[s256, "unicast", 128, 1, 2, 1.167, "up down", s577],
[s266, "unicast", 125.14, 1, 5, 1.575, "up down", s577],
["User ACKNACK", "unicast", 128.35, 1, 5, 1.429, "up down", s577],
[s436, "unicast", 501.7, 1, 2, 1.685, "up down", s577],
["ROS Heartbeat", "unicast", 125.14, 1, 2, 3.37, "up down", s577],
[s437, "unicast", 125.14, 1, 3, 0.1534, "up down", s577],
["ROS ACKNACK", "unicast", 128.35, 1, 2, 1.426, "up down", s577],
[s438, "unicast", 128.35, 1, 3, 0.1351, "up down", s577],
],
},
"Fast DDS 2.14, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": false,
"color": s362,
"measured": [10, 20, 42],
"band": s439,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s440,
"degree": 3,
"messages": [
["SPDP", "multicast", 560, 1, 0, 1, "up down", s588],
["SPDP unicast", "unicast", 560, 1, 1, 1, "up down", s589],
[s428, "unicast", 560, 1, 1, 1, "up down", s577],
["SEDP", "unicast", s441, 0.6008, 2, 1, "up down", s577],
["Heartbeat", "unicast", 183.8, 1, 1, 2, "up down", s577],
[s242, "unicast", 183.8, 1, 1, 2.375, "up down", s577],
["ACKNACK", "unicast", 189.7, 1, 1, 2, "up down", s577],
[s432, "unicast", 189.7, 1, 1, 2.625, "up down", s577],
[s251, "unicast", 192, 1, 1, 1.125, "up down", s577],
[s256, "unicast", 188, 1, 1, 1.216, "up down", s577],
[s266, "unicast", 183.7, 1, 3, 1.5, "up down", s577],
["User ACKNACK", "unicast", 189, 1, 3, 1.554, "up down", s577],
[s436, "unicast", 480, 1, 1, 1.037, "up down", s577],
["ROS Heartbeat", "unicast", 183.7, 1, 1, 0.7995, "up down", s577],
[s437, "unicast", 183.7, 1, 4, 0.288, "up down", s577],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.9597, "up down", s577],
[s438, "unicast", 189, 1, 4, 0.1806, "up down", s577],
],
},
"Fast DDS 3.6, a Discovery Server": s584,
"Fast DDS 3.6, two Discovery Servers": s585,
"Fast DDS 3.6, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": false,
"color": s362,
"measured": [10, 20, 42],
"band": s452,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s453,
"degree": 3,
"messages": [
["SPDP", "multicast", 632, 1, 0, 1, "up down", s588],
["SPDP unicast", "unicast", 632, 1, 1, 1, "up down", s589],
[s428, "unicast", 632, 1, 1, 1, "up down", s577],
["SEDP", "unicast", s454, 0.6318, 2, 1, "up down", s577],
["Heartbeat", "unicast", 184.3, 1, 1, 2, "up down", s577],
[s242, "unicast", 184.3, 1, 1, 2.13, "up down", s577],
["ACKNACK", "unicast", 189.6, 1, 1, 2, "up down", s577],
[s432, "unicast", 189.6, 1, 1, 2.204, "up down", s577],
[s251, "unicast", 192, 1, 1, 1.046, "up down", s577],
[s256, "unicast", 188, 1, 1, 1.083, "up down", s577],
[s266, "unicast", 178.8, 1, 3, 1.306, "up down", s577],
["User ACKNACK", "unicast", 189, 1, 3, 1.633, "up down", s577],
[s436, "unicast", 459.4, 1, 1, 1.15, "up down", s577],
[s261, "unicast", s455, 0.9914, 1, 2.303, "up down", s577],
[s263, "unicast", 188, 1, 1, 2.5, "up down", s577],
["Type lookup", "unicast", s456, 0.2383, 4, 3.917, "up down", s577],
["ROS Heartbeat", "unicast", 178.8, 1, 1, 3.687, "up down", s577],
[s437, "unicast", 178.8, 1, 5, 0.1285, "up down", s577],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.4578, "up down", s577],
[s438, "unicast", 189, 1, 5, 0.2066, "up down", s577],
],
},
"Zenoh, periods of Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s480,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s569,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s240], s483],
},
"static endpoints, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s484,
"caution": "",
"ratios": s410,
"server_ratios": s164,
"has_server": false,
"color": s362,
"measured": [8, 8, 84],
"band": s485,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s572,
"windows": s573,
"units": s489,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s588],
[s424, "multicast", 589.2, 1, 1, 1, "up down", s577],
[s490, "multicast", 589.2, 1, 2, 1, "up down", s577],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s589],
[s428, "unicast", 589.2, 1, 3, 1, "up down", s577],
[s429, "unicast", 589.2, 1, 4, 0.5, "up down", s577],
[s491, "unicast", 589.2, 1, 5, 0.6542, "up down", s577],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s590],
[s492, "multicast", 59.47, 0, 6, 0.8987, "up down", s577],
[s493, "multicast", 59.47, 0, 7, 0.8987, "up down", s577],
[s494, "unicast", 59.47, 0, 5, 1, "up down", s590],
[s495, "unicast", 59.47, 0, 5, 0.9528, "up down", s577],
[s496, "unicast", 59.47, 0, 8, 0.4764, "up down", s577],
[s497, "unicast", 59.47, 0, 9, 0.6233, "up down", s577],
[s251, "unicast", 192, 1, 3, 1.167, "up down", s577],
[s256, "unicast", 188, 1, 3, 1.167, "up down", s577],
[s266, "unicast", 192, 1, 10, 1.33, "up down", s577],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s577],
],
},
"Zenoh peer, switching to Fast DDS with a Discovery Server": s584,
"Zenoh peer, switching to Fast DDS with two Discovery Servers": s585,
"Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": {"any": []},
"about": s498,
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s480,
"measured": [8, 12, 60],
"band": s499,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s591,
"degree": 3,
"messages": [
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s240],
s592,
s593,
s594,
["OAM", "unicast", s507, 0.835, 0, 1, "up down", s240],
[s508, "unicast", s507, 0.835, 1, 0.625, "up down", s240],
["Declare", "unicast", s509, 0.1957, 2, 0.5, "up down", s240],
[s510, "unicast", s511, 0.8037, 3, 0.5, "up down", s240],
[s512, "unicast", s511, 0.8037, 4, 0.5, "up down", s240],
["Declare final", "unicast", 176, 0.05, 0, 1, "up down", s240],
["Frame", "unicast", s513, 0.2478, 0, 1, "up down", s240],
[s514, "unicast", s513, 0.2478, 2, 0.6083, "up down", s240],
s596,
s597,
["TCP ACK", "unicast", 76, 1, 0, 0.6530673466326684, "up down", s482],
[s517, "unicast", 76, 1, 0, 2.496, "up down", s240],
[s518, "unicast", 76, 1, 2, 0.2188, "up down", s240],
],
},
"Zenoh peer, tokens, switching to Fast DDS with a Discovery Server": s584,
"Zenoh peer, tokens, switching to Fast DDS with two Discovery Servers": s585,
"Zenoh peer, tokens, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": {"any": []},
"about": s519,
"caution": "",
"ratios": s164,
"server_ratios": s164,
"has_server": false,
"color": s480,
"measured": [8, 12, 60],
"band": s520,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s227,
"windows": s228,
"units": s591,
"degree": 3,
"messages": [
["InitSyn", "unicast", 109.86, 1, 0, 0.5, "up down", s240],
s592,
s593,
s594,
["OAM", "unicast", s521, 0.7058, 0, 1, "up down", s240],
[s508, "unicast", s521, 0.7058, 1, 0.6493, "up down", s240],
["Declare", "unicast", s522, 0.0655, 2, 0.5, "up down", s240],
["Declare token", "unicast", s523, 0.0603, 2, 1, "up down", s240],
[s524, "unicast", s523, 0.0603, 0, 1, "up down", s240],
[s510, "unicast", s525, 0.5972, 3, 1.5, "up down", s240],
[s512, "unicast", s525, 0.5972, 4, 2.5, "up down", s240],
[s526, "unicast", s525, 0.5972, 0, 1, "up down", s240],
["Declare final", "unicast", s527, 0.06, 0, 1, "up down", s240],
["Frame", "unicast", s528, 0.1352, 0, 2, "up down", s240],
[s514, "unicast", s528, 0.1352, 2, 1, "up down", s240],
s596,
s597,
["TCP ACK", "unicast", 76, 1, 0, 0.5405729713514325, "up down", s482],
[s517, "unicast", 76, 1, 0, 3.325, "up down", s240],
[s518, "unicast", 76, 1, 2, 0.4208, "up down", s240],
],
},
"Zenoh router, switching to Fast DDS with a Discovery Server": s584,
"Zenoh router, switching to Fast DDS with two Discovery Servers": s585,
"Zenoh router per host, switching to Fast DDS with a Discovery Server": s584,
"Zenoh router per host, switching to Fast DDS with two Discovery Servers": s585,
"Zenoh router per host, star, switching to Fast DDS with a Discovery Server": s584,
"Zenoh router per host, star, switching to Fast DDS with two Discovery Servers": s585,
},
};
})();
