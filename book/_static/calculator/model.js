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
const s15 = "both values use the timing of the 802.11 standard";
const s16 = 144444444.44444445;
const s17 = {"R_uni": s16, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s18 = {"name": s12, "model": "padded", "values": s17};
const s19 = "802.11n 20 MHz 2x2, multicast 24 Mbit/s";
const s20 = {"R_uni": s16, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s21 = "another radio (802.11n 40 MHz 2x2)";
const s22 = "802.11n 40 MHz 2x2";
const s23 = {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s24 = {"name": s22, "model": "padded", "values": s23};
const s25 = "another radio (802.11ac 80 MHz 2x2)";
const s26 = "802.11ac 80 MHz 2x2";
const s27 = 866666666.6666666;
const s28 = {"R_uni": s27, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s29 = {"name": s26, "model": "padded", "values": s28};
const s30 = "another radio (802.11ax 160 MHz 2x2)";
const s31 = "802.11ax 160 MHz 2x2";
const s32 = 2401960784.3137255;
const s33 = {"R_uni": s32, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s34 = {"name": s31, "model": "padded", "values": s33};
const s35 = {
"name": "802.11n 20 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s16, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s36 = "802.11a 20 MHz 1x1";
const s37 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s38 = {"name": s36, "model": "padded", "values": s37};
const s39 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s40 = "802.11g 20 MHz 1x1";
const s41 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s42 = "sending multicast at 24 instead of 1 Mbit/s";
const s43 = {"name": s40, "model": "padded", "values": s41};
const s44 = "802.11n 20 MHz 2x2";
const s45 = {"name": s44, "model": "padded", "values": s17, "full": s35};
const s46 = {"R_uni": s16, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0};
const s47 = {
"name": "802.11n 40 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s48 = {"name": s22, "model": "padded", "values": s23, "full": s47};
const s49 = {
"name": "802.11ac 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s27, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
};
const s50 = {"name": s26, "model": "padded", "values": s28, "full": s49};
const s51 = {
"name": "802.11ax 160 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s32, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
};
const s52 = {"name": s31, "model": "padded", "values": s33, "full": s51};
const s53 = "802.11n 20 MHz 2x2, 2.4 GHz";
const s54 = {"R_uni": s16, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s55 = {
"name": "802.11n 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s16, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
};
const s56 = {"name": s53, "model": "padded", "values": s54, "full": s55};
const s57 = "802.11ax 20 MHz 2x2, 2.4 GHz";
const s58 = 286764705.88235295;
const s59 = {"R_uni": s58, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
const s60 = {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s58, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
};
const s61 = {"name": s57, "model": "padded", "values": s59, "full": s60};
const s62 = "802.11ax 80 MHz 2x2";
const s63 = 1200980392.1568627;
const s64 = {"R_uni": s63, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s65 = {
"name": "802.11ax 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s63, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
};
const s66 = {"name": s62, "model": "padded", "values": s64, "full": s65};
const s67 = "802.11be 80 MHz 2x2";
const s68 = 1441176470.5882354;
const s69 = {"R_uni": s68, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s70 = {
"name": "802.11be 80 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s68, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
};
const s71 = {"name": s67, "model": "padded", "values": s69, "full": s70};
const s72 = "802.11be 320 MHz 2x2";
const s73 = 5764705882.3529415;
const s74 = {"R_uni": s73, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
const s75 = {
"name": "802.11be 320 MHz 2x2, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s73, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
};
const s76 = "staggered start";
const s77 = "discovery server";
const s78 = "inside_unicast";
const s79 = "linear_unicast";
const s80 = "padded_unicast";
const s81 = "padded_multicast";
const s82 = "aggregated_unicast";
const s83 = "new or reconfigured radios";
const s84 = {"efforts": ["radio"], "effort": 6, "takes": s83, "best_case": true, "cost": "the full gain needs full A-MPDUs; a queue may hold too few frames for one receiver"};
const s85 = ["radio", "setting"];
const s86 = "new or reconfigured radios and a setting";
const s87 = {"efforts": s85, "effort": 6, "takes": s86, "best_case": true, "cost": "the full gain needs full A-MPDUs; a queue may hold too few frames for one receiver; discovery cannot be complete before the last host starts"};
const s88 = "a configuration file";
const s89 = ["file", "setting"];
const s90 = "a configuration file and a setting";
const s91 = "one more program";
const s92 = ["server", "setting"];
const s93 = "one more program and a setting";
const s94 = "discovery server on a robot";
const s95 = {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "parameters can no longer be set from outside a node; third-party nodes, such as Nav2's, must be rebuilt; services count as two endpoints, as in DDS"};
const s96 = ["build", "setting"];
const s97 = "rebuilt nodes and a setting";
const s98 = {"efforts": s96, "effort": 5, "takes": s97, "best_case": false, "cost": "parameters can no longer be set from outside a node; third-party nodes, such as Nav2's, must be rebuilt; services count as two endpoints, as in DDS; discovery cannot be complete before the last host starts"};
const s99 = "another middleware";
const s100 = {"efforts": ["switch"], "effort": 8, "takes": s99, "best_case": false, "cost": "all hosts must change together"};
const s101 = ["switch", "server"];
const s102 = "another middleware and one more program";
const s103 = ["switch", "server", "setting"];
const s104 = "another middleware, one more program and a setting";
const s105 = "multicast endpoint data";
const s106 = ["switch", "file"];
const s107 = "another middleware and a configuration file";
const s108 = ["switch", "file", "setting"];
const s109 = "another middleware, a configuration file and a setting";
const s110 = "router on each host";
const s111 = ["switch", "servers"];
const s112 = "another middleware and several more programs";
const s113 = ["switch", "servers", "setting"];
const s114 = "another middleware, several more programs and a setting";
const s115 = ["switch", "setting"];
const s116 = "another middleware and a setting";
const s117 = {"efforts": s115, "effort": 8, "takes": s116, "best_case": false, "cost": "all hosts must change together; discovery cannot be complete before the last host starts"};
const s118 = "star of routers";
const s119 = "static endpoints";
const s120 = "two discovery servers";
const s121 = {"efforts": ["setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": "hosts too far away for this rate cannot join; no multicast or management frame may use a lower rate"};
const s122 = {"efforts": ["setting", "setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": "hosts too far away for this rate cannot join; no multicast or management frame may use a lower rate; discovery cannot be complete before the last host starts"};
const s123 = {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "only nodes built as components can be composed; a crash ends all composed nodes of its host"};
const s124 = {"efforts": s96, "effort": 5, "takes": s97, "best_case": false, "cost": "only nodes built as components can be composed; discovery cannot be complete before the last host starts; a crash ends all composed nodes of its host"};
const s125 = {"efforts": ["radio"], "effort": 6, "takes": s83, "best_case": false, "cost": "all hosts and the access point need this radio and must be close enough for its rate"};
const s126 = {"efforts": s85, "effort": 6, "takes": s86, "best_case": false, "cost": "all hosts and the access point need this radio and must be close enough for its rate; discovery cannot be complete before the last host starts"};
const s127 = {"efforts": ["upgrade"], "effort": 7, "takes": "another ROS release", "best_case": false, "cost": "all computers need the new ROS release; every package must be rebuilt and retested"};
const s128 = {"efforts": ["upgrade", "setting"], "effort": 7, "takes": "another ROS release and a setting", "best_case": false, "cost": "all computers need the new ROS release; every package must be rebuilt and retested; discovery cannot be complete before the last host starts"};
const s129 = "several more programs";
const s130 = ["servers", "setting"];
const s131 = "several more programs and a setting";
const s132 = {"efforts": ["setting"], "effort": 1, "takes": "a setting", "best_case": false, "cost": "discovery cannot be complete before the last host starts"};
const s133 = "hostapd.conf of the access point";
const s134 = "for every process";
const s135 = "Fast DDS 2.6, 2.9, 2.14 and 3.6";
const s136 = "Cyclone DDS 0.10.2 and 11.0.1";
const s137 = "on a computer that is wired to the access point";
const s138 = "on every robot";
const s139 = {
"where": s138,
"version": s135,
"text": "# on every robot (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: run\n# in the shell or put in the service file that starts the ROS 2 processes, before they start\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\n",
};
const s140 = {
"where": "for ros2 tools",
"version": "Fast DDS 2.6, 2.14 and 3.6",
"text": "# for ros2 tools (tested with Fast DDS 2.6, 2.14 and 3.6)\n# Load: both are environment variables of ros2 and its daemon: export them in the shell of\n# the tools, then ros2 daemon stop\n# Fast DDS reads ROS_SUPER_CLIENT from 2.6.7 on (ROS 2 Humble), 2.10.3 (Iron) and 2.13.0 (Jazzy and\n# later). Older releases, such as 2.9.1, ignore it: use the profile of a SUPER_CLIENT.\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811\"\nexport ROS_SUPER_CLIENT=TRUE\n",
};
const s141 = {
"where": "for older ros2 tools that ignore ROS_SUPER_CLIENT",
"version": "Fast DDS 2.9.1",
"text": "<!-- for older ros2 tools that ignore ROS_SUPER_CLIENT (tested with Fast DDS 2.9.1) -->\n<!-- Load: save as /etc/fast_dds_tools.xml; ros2 and its daemon run with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds_tools.xml and without ROS_DISCOVERY_SERVER; -->\n<!-- begin with ros2 daemon stop; Fast DDS 3 refuses this file -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"super_client\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SUPER_CLIENT</discoveryProtocol>\n            <discoveryServersList>\n              <RemoteServer prefix=\"44.53.00.5f.45.50.52.4f.53.49.4d.41\">\n                <metatrafficUnicastLocatorList>\n                  <locator>\n                    <udpv4>\n                      <address>192.168.1.10</address>\n                      <port>11811</port>\n                    </udpv4>\n                  </locator>\n                </metatrafficUnicastLocatorList>\n              </RemoteServer>\n            </discoveryServersList>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
};
const s142 = "on every computer";
const s143 = {
"where": s137,
"version": "Zenoh 1.10.2",
"text": "// on a computer that is wired to the access point (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s144 = {
"where": "for every process of a robot",
"version": "Zenoh 1.10.2",
"text": "// for every process of a robot (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_session.json5; every ROS 2 process runs with\n// ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5\n{\n  mode: \"peer\",\n  connect: { endpoints: [\"tcp/localhost:7447\"] },\n  listen: { endpoints: [\"tcp/localhost:0\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: {\n      target: { router: [\"router\", \"peer\"], peer: [\"router\"] },\n      autoconnect_strategy: { peer: { to_router: \"always\", to_peer: \"greater-zid\" } },\n    },\n  },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
};
const s145 = "a Discovery Server";
const s146 = "both values use the measured model of Fast DDS";
const s147 = "Fast DDS Discovery Server";
const s148 = [s77, s145, s146, s147, "Fast DDS", s77];
const s149 = "two Discovery Servers";
const s150 = "Fast DDS Discovery Server, two";
const s151 = [s120, s149, s146, s150, "Fast DDS", s120];
const s152 = "a Discovery Server on a robot";
const s153 = "Fast DDS Discovery Server, on a robot";
const s154 = [s94, s152, s146, s153, "Fast DDS", s94];
const s155 = [s119, s119, s146, s119, "Fast DDS", s119];
const s156 = "both values use the measured model of Cyclone DDS";
const s157 = "Cyclone DDS peers";
const s158 = ["peers", "static peers", s156, s157, "Cyclone DDS", "peers"];
const s159 = "multicast SEDP announcements";
const s160 = "Cyclone DDS multicast SEDP";
const s161 = [s105, s159, s156, s160, "Cyclone DDS", s105];
const s162 = {"measured": "", "range": "0.5 to 2", "hosts": "0", "seconds": "0", "low": "0.5", "high": "2"};
const s163 = [1, "within a second at best"];
const s164 = [Infinity, "leases at risk"];
const s165 = "never catches up";
const s166 = {"until": [s163, [Infinity, "slow at best"], s164], "never": s165};
const s167 = {"second": 1, "ever": Infinity};
const s168 = {"count": "count", "more": ["more", "more2"]};
const s169 = [s168, s168, s168];
const s170 = {"count": "count2", "more": ["more3", "more4", "more5"]};
const s171 = [s170, s170, s170];
const s172 = {"count": "count3", "more": ["more6", "more7", "more8"]};
const s173 = [s172, s172, s172];
const s174 = {"burst": 1, "second": 1, "ever": 0};
const s175 = "a central router";
const s176 = "both values use the measured model of Zenoh peer with tokens";
const s177 = "Zenoh peer, tokens";
const s178 = ["router", s175, s176, "Zenoh router", s177, "router"];
const s179 = "a router on each host";
const s180 = "Zenoh router per host";
const s181 = [s110, s179, s176, s180, s177, s110];
const s182 = "a router on each host plus a wired router";
const s183 = "Zenoh router per host, star";
const s184 = [s118, s182, s176, s183, s177, s118];
const s185 = "--ds-family-zenoh";
const s186 = [s169, s173, s171];
const s187 = ["KeepAlive", "unicast", 84, 1, 1, 2, "up down", s174];
const s188 = "switching to Fast DDS with a Discovery Server";
const s189 = "Fast DDS 2.14 Discovery Server";
const s190 = "middleware and discovery server";
const s191 = "switching to Fast DDS with two Discovery Servers";
const s192 = "Fast DDS 2.14 Discovery Server, two";
const s193 = "middleware and two discovery servers";
const s194 = [s94, "switching to Fast DDS with a Discovery Server on a robot", "", s153, "Cyclone DDS", "middleware and discovery server on a robot"];
const s195 = "switching to Fast DDS with static endpoints";
const s196 = "middleware and static endpoints";
const s197 = [s119, s195, "", s119, "Cyclone DDS", s196];
const s198 = ["peers", "static peers", "", s157, "Cyclone DDS", "peers"];
const s199 = [s105, s159, "", s160, "Cyclone DDS", s105];
const s200 = "switching to Zenoh with a central router";
const s201 = "middleware and router";
const s202 = ["router", s200, "", "Zenoh router", "Cyclone DDS", s201];
const s203 = "switching to Zenoh with a router on each host";
const s204 = "middleware and router on each host";
const s205 = [s110, s203, "", s180, "Cyclone DDS", s204];
const s206 = "switching to Zenoh with a router on each host plus a wired router";
const s207 = "middleware and star of routers";
const s208 = [s118, s206, "", s183, "Cyclone DDS", s207];
const s209 = "a longer announcement interval";
const s210 = ["announcements", s209, "", "Cyclone DDS, a longer announcement interval", "Cyclone DDS", "announcements"];
const s211 = "moving to ROS 2 Lyrical (Cyclone DDS, version 11)";
const s212 = ["release", s211, "", s2, "Cyclone DDS", "release"];
const s213 = "switching to Zenoh peer, tokens";
const s214 = ["middleware", s213, "", s177, "Cyclone DDS", "middleware"];
const s215 = "Fast DDS 2.6 Discovery Server";
const s216 = "Fast DDS 2.6 Discovery Server, two";
const s217 = "Fast DDS 3.6 Discovery Server";
const s218 = "Fast DDS 3.6 Discovery Server, two";
const s219 = "switching to Fast DDS 3.6";
const s220 = "on a network that it takes for Wi-Fi: multicast for SPDP alone (measured with 0.10.2)";
const s221 = "Cyclone DDS 0.10.5 took 3.6 to 6.8 times as long as simulated in an emulated Wi-Fi cell without frame aggregation, where 8 robots had done only 19% of discovery after 12 s";
const s222 = {"measured": "Cyclone DDS", "range": "0.08 to 6.76", "hosts": "8", "seconds": "12", "low": "0.08", "high": "6.76"};
const s223 = "--ds-product-cyclone-dds";
const s224 = [
[1, 1.67, 11.3, "In 24 swarms within these sizes, left out of the fit, discovery took 0.68 to 1.26 times the predicted airtime (typical error 9%). We expect 92% of such swarms in this range"],
[2, 1.67, 11.3, "In 9 swarms of up to twice these sizes, left out of the fit, discovery took 0.94 to 1.44 times the predicted airtime (typical error 16%). We expect 80% of such swarms in this range"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints, left out of the fit, discovery took 1.31 to 1.47 times the predicted airtime (typical error 39%). With so few swarms, we give no interval"],
];
const s225 = {"until": [s163, [10, "slow at best"], s164], "never": s165};
const s226 = {"second": 1, "lease": 10, "ever": Infinity};
const s227 = {"count": "count4", "more": ["more9", "more10", "more11", "more12"]};
const s228 = [s227, s227, s227];
const s229 = {"count": "count5", "more": ["more13", "more14", "more15", "more16"]};
const s230 = [s229, s229, s229];
const s231 = {"count": "count6", "more": []};
const s232 = [s231, {"count": "count7", "more": ["more17", "more18", "more19"]}, {"count": "count8", "more": ["more20", "more21", "more22"]}];
const s233 = [s169, s173, s171, s228, s230, s232, [s231, {"count": "count9", "more": ["more23", "more24", "more25", "more26"]}, {"count": "count10", "more": ["more27", "more28", "more29", "more30"]}]];
const s234 = {"burst": 1.9875, "second": 2.1125, "lease": 0.32375, "ever": 0.125};
const s235 = {"burst": 0.9875, "second": 1.1125, "lease": 0.22375, "ever": 0.125};
const s236 = {"burst": 4, "second": 4, "lease": 0.4, "ever": 0};
const s237 = 972.4761045987376;
const s238 = {"burst": 1, "second": 1, "lease": 0.1, "ever": 0};
const s239 = 154.45158821278227;
const s240 = "Heartbeat of data";
const s241 = 187.0099502487562;
const s242 = "ACKNACK for others";
const s243 = 179.99005799502902;
const s244 = {"burst": 0, "second": 0.125, "lease": 0.125, "ever": 0.125};
const s245 = ["Liveliness", "unicast", s243, 0.7242, 1, 1, "up down", s244];
const s246 = "Liveliness at start";
const s247 = 190.54725731648807;
const s248 = "Liveliness for others";
const s249 = "Liveliness Heartbeat";
const s250 = 180.02610587382162;
const s251 = [s249, "unicast", s250, 0.2758, 1, 1, "up down", s244];
const s252 = "Liveliness Heartbeat at start";
const s253 = 153.8987676056338;
const s254 = "Liveliness ACKNACK";
const s255 = [s254, "unicast", 128, 1, 1, 1, "up down", s244];
const s256 = "Liveliness ACKNACK at start";
const s257 = 181.3784494086728;
const s258 = "Liveliness ACKNACK for others";
const s259 = "Type lookup Heartbeat";
const s260 = 129.08962679988247;
const s261 = "Type lookup ACKNACK";
const s262 = 195.20030291556228;
const s263 = "Type lookup ACKNACK for others";
const s264 = "User Heartbeat";
const s265 = 139.31615175284134;
const s266 = "User Heartbeat for others";
const s267 = 182.43195266272187;
const s268 = "User ACKNACK for others";
const s269 = "the server forwards everything, as in Fast DDS 3.6";
const s270 = "Cyclone DDS, wired";
const s271 = "moving to ROS 2 Jazzy (Cyclone DDS)";
const s272 = "on a network that it takes for wired, with three processes or more: multicast for SEDP and control, too (measured with 0.10.2)";
const s273 = [[1, 1, 1, "In 7 swarms within these sizes, left out of the fit, discovery took 0.95 to 1.13 times the predicted airtime (typical error 5%). We expect 75% of such swarms in this range"]];
const s274 = [s169, s173, s171, s230, s232];
const s275 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s234];
const s276 = 493.08762420957544;
const s277 = 1167.7479630635523;
const s278 = "SEDP multicast";
const s279 = 961.6660682226212;
const s280 = "Heartbeat multicast";
const s281 = 201.42013994523882;
const s282 = 199.39703903095557;
const s283 = 150.79816322270926;
const s284 = "Liveliness unicast";
const s285 = 245.09790605546124;
const s286 = "Liveliness Heartbeat unicast";
const s287 = 234.05196032120926;
const s288 = 187.1920199501247;
const s289 = 224.96579476861166;
const s290 = "Type lookup Heartbeat unicast";
const s291 = 230.92749087115283;
const s292 = 230.46065100947672;
const s293 = "User Heartbeat multicast";
const s294 = 232.6802973977695;
const s295 = 226.06745510293473;
const s296 = "as Cyclone DDS, with type information in SEDP (measured with 11.0.1)";
const s297 = [
[1, 1.67, 11.3, "In 26 swarms within these sizes, left out of the fit, discovery took 0.72 to 1.32 times the predicted airtime (typical error 9%). We expect 93% of such swarms in this range"],
[2, 1.67, 11.3, "In 11 swarms of up to twice these sizes, left out of the fit, discovery took 1.00 to 1.43 times the predicted airtime (typical error 22%). We expect 83% of such swarms in this range"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints, left out of the fit, discovery took 1.28 to 1.48 times the predicted airtime (typical error 38%). With so few swarms, we give no interval"],
];
const s298 = 432.2946357085669;
const s299 = 726.2444541104828;
const s300 = 153.93607305936075;
const s301 = 186.8277247614264;
const s302 = 187.05568338702255;
const s303 = 156.2517609634174;
const s304 = 190.87976752633492;
const s305 = 132.5107047976246;
const s306 = 204.12578616352204;
const s307 = 133.94982078853047;
const s308 = 167.8055937643283;
const s309 = "switching to Cyclone DDS, version 11";
const s310 = "AllowMulticast=false, all hosts as Peers, ParticipantIndex=auto and MaxAutoParticipantIndex=9, its default (measured with 0.10.2)";
const s311 = [[1, 1, 1, "In 7 swarms within these sizes, left out of the fit, discovery took 0.94 to 1.33 times the predicted airtime (typical error 5%). We expect 75% of such swarms in this range"]];
const s312 = {"count": "count11", "more": ["more31", "more32", "more2"]};
const s313 = [s312, s312, s312];
const s314 = {"count": "count12", "more": ["more33", "more34", "more35"]};
const s315 = [s314, s314, s314];
const s316 = [s313, s315, s173, s171, s228, s230, s232];
const s317 = "ICMP unreachable";
const s318 = {"burst": 1, "second": 1.125, "lease": 0.225, "ever": 0.125};
const s319 = 442.0177243557095;
const s320 = 1224.46511627907;
const s321 = 334.84114485689287;
const s322 = 150.13620569840168;
const s323 = 191.25372354324537;
const s324 = 180.00607650876952;
const s325 = 170.0050484920951;
const s326 = 179.9840521928235;
const s327 = 156.0150305307656;
const s328 = 190.60377358490564;
const s329 = 134.67330119732546;
const s330 = 185.2367491166078;
const s331 = 147.20074005550418;
const s332 = 166.51716247139586;
const s333 = "AllowMulticast=true, as it chooses on a network that it takes for wired: of three processes or more (measured with 0.10.2)";
const s334 = [[1, 1, 1, "In 7 swarms within these sizes, left out of the fit, discovery took 0.91 to 1.10 times the predicted airtime (typical error 8%). We expect 75% of such swarms in this range"]];
const s335 = 492.4140969162995;
const s336 = 1040.4988009592325;
const s337 = 965.8901890189019;
const s338 = 215.89285714285714;
const s339 = 213.31594018453706;
const s340 = 200.7060146149522;
const s341 = 180.02209944751382;
const s342 = 152.05954502568403;
const s343 = 510.6666666666667;
const s344 = 179.94202898550725;
const s345 = 201.4570446735395;
const s346 = 219.65142364106987;
const s347 = 186.30392156862746;
const s348 = 207.01075268817203;
const s349 = 249.3997682502897;
const s350 = 210.50383141762453;
const s351 = 176.79097672186225;
const s352 = 122.00209989500526;
const s353 = 167.19174466042716;
const s354 = "switching to Cyclone DDS with static peers";
const s355 = "middleware and peers";
const s356 = "switching to Cyclone DDS with multicast SEDP announcements";
const s357 = "middleware and multicast endpoint data";
const s358 = "one server, wired to the access point (measured with 2.9.1)";
const s359 = {"measured": s147, "range": "0.72 to 1.63", "hosts": "12", "seconds": "15", "low": "0.72", "high": "1.63"};
const s360 = "--ds-product-fast-dds";
const s361 = [[1, 1, 1, "In 6 swarms within these sizes, left out of the fit, discovery took 1.00 to 1.10 times the predicted airtime (typical error 4%). We expect 71% of such swarms in this range"]];
const s362 = {"until": [s163, [20, "slow at best"], s164], "never": s165};
const s363 = {"second": 1, "lease": 20, "ever": Infinity};
const s364 = {"count": "count13", "more": ["more36", "more37", "more38"]};
const s365 = {"count": "count14", "more": ["more39", "more40"]};
const s366 = [s365, s365, s365];
const s367 = {"count": "count16", "more": ["more44", "more45", "more5"]};
const s368 = {"count": "count17", "more": ["more46", "more47", "more38"]};
const s369 = [s231, s368, s368];
const s370 = [s169, [s231, s364, s364], s366, [s231, {"count": "count15", "more": ["more41", "more42", "more43"]}, s367], s369, s232];
const s371 = "SPDP to server";
const s372 = 0.3333333333333333;
const s373 = {"burst": 5.833333333333333, "second": 6.166666666666666, "lease": 0.625, "ever": s372};
const s374 = "SPDP of server";
const s375 = {"burst": 0.5, "second": 0.8333333333333333, "lease": 0.35833333333333334, "ever": s372};
const s376 = "SPDP of server at discovery";
const s377 = 748.3930635838151;
const s378 = {"burst": 1, "second": 1, "lease": 0.05, "ever": 0};
const s379 = "SPDP of others";
const s380 = 683.9365973934484;
const s381 = "SPDP Heartbeat";
const s382 = "SPDP Heartbeat of server";
const s383 = 250.29586195342605;
const s384 = "SPDP Heartbeat of others";
const s385 = 354.98051539912007;
const s386 = "SPDP ACKNACK of others";
const s387 = "SPDP ACKNACK of server";
const s388 = 204.14209591474247;
const s389 = "SEDP to server";
const s390 = "SEDP of others";
const s391 = 655.9962112242481;
const s392 = "Heartbeat of server";
const s393 = "Heartbeat of others";
const s394 = 451.4893977947413;
const s395 = "ACKNACK of others";
const s396 = "ACKNACK of server";
const s397 = 205.97133664814274;
const s398 = "Liveliness Heartbeat to server";
const s399 = "Liveliness Heartbeat of server";
const s400 = [s249, "unicast", 192, 1, 4, 1.292, "up down", s378];
const s401 = "Liveliness ACKNACK to server";
const s402 = "Liveliness ACKNACK of server";
const s403 = [s254, "unicast", 188, 1, 4, 1.292, "up down", s378];
const s404 = [s264, "unicast", 192, 1, 5, 1.021, "up down", s378];
const s405 = ["User ACKNACK", "unicast", 188, 1, 5, 1.021, "up down", s378];
const s406 = [
[s371, "unicast", 652, 1, 0, 1, "up", s373],
[s374, "unicast", 700, 1, 0, 1, "down", s375],
[s376, "unicast", s377, 0.865, 0, 1, "down", s378],
[s379, "unicast", s380, 0.8517, 1, 1.967, "down", s378],
[s381, "unicast", 192, 1, 0, 2, "up", s378],
[s382, "unicast", s383, 0.5969, 0, 2.167, "down", s378],
[s384, "unicast", s385, 0.3182, 1, 2.908, "down", s378],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up", s378],
[s386, "unicast", 190.2, 1, 1, 0.5083, "up", s378],
[s387, "unicast", 188, 1, 0, 2, "down", s378],
["SPDP Gap", "unicast", s388, 0.6193, 1, 1.6, "down", s378],
[s389, "unicast", 1152, 0.45, 2, 1, "up", s378],
[s390, "unicast", s391, 0.8446, 3, 1.237, "down", s378],
["Heartbeat", "unicast", 192, 1, 0, 4, "up", s378],
[s392, "unicast", 192, 1, 0, 4, "down", s378],
[s393, "unicast", s394, 0.2358, 3, 1.892, "down", s378],
["ACKNACK", "unicast", 188, 1, 0, 4, "up", s378],
[s395, "unicast", 191.3, 1, 3, 0.45, "up", s378],
[s396, "unicast", 188.5, 1, 0, 15.6, "down", s378],
["Gap", "unicast", s397, 0.6838, 3, 0.645, "down", s378],
[s398, "unicast", 192, 1, 0, 1, "up", s378],
[s399, "unicast", 192, 1, 0, 2, "down", s378],
s400,
[s401, "unicast", 188, 1, 0, 2, "up", s378],
[s402, "unicast", 188, 1, 0, 2, "down", s378],
s403,
s404,
s405,
];
const s407 = "two servers that know nothing of each other, both wired to the access point; clients of both (measured with 2.9.1)";
const s408 = {"measured": "Fast DDS", "range": "0.97 to 2.03", "hosts": "8", "seconds": "15", "low": "0.97", "high": "2.03"};
const s409 = [[1, 1, 1, "In 6 swarms within these sizes, left out of the fit, discovery took 1.00 to 1.05 times the predicted airtime (typical error 2%). We expect 71% of such swarms in this range"]];
const s410 = [
[s371, "unicast", 636, 1, 0, 2, "up", s373],
[s374, "unicast", 700, 1, 0, 2, "down", s375],
[s376, "unicast", 747.8396673212429, 0.8657, 0, 2, "down", s378],
[s379, "unicast", 684.0093940817285, 0.8516, 1, 3.9, "down", s378],
[s381, "unicast", 192, 1, 0, 4, "up", s378],
[s382, "unicast", 244.85106382978725, 0.6204, 0, 4.625, "down", s378],
[s384, "unicast", 402.48973607038124, 0.2728, 1, 5.942, "down", s378],
["SPDP ACKNACK", "unicast", 189.8, 1, 0, 4.625, "up", s378],
[s386, "unicast", 190.5, 1, 1, 0.9417, "up", s378],
[s387, "unicast", 188, 1, 0, 4, "down", s378],
["SPDP Gap", "unicast", 199.09006997171358, 0.6717, 1, 3.333, "down", s378],
[s389, "unicast", 1257.7301004163605, 0.4083, 2, 2, "up", s378],
[s390, "unicast", s391, 0.8446, 3, 2.45, "down", s378],
["Heartbeat", "unicast", 184, 1, 0, 8, "up", s378],
[s392, "unicast", 192, 1, 0, 8, "down", s378],
[s393, "unicast", 432.5140562248996, 0.249, 3, 3.242, "down", s378],
["ACKNACK", "unicast", 188, 1, 0, 8, "up", s378],
[s395, "unicast", 190.8, 1, 3, 0.85, "up", s378],
[s396, "unicast", 188.5, 1, 0, 31.6, "down", s378],
["Gap", "unicast", 207.54580397181294, 0.6244, 3, 1.03, "down", s378],
[s398, "unicast", 192, 1, 0, 2, "up", s378],
[s399, "unicast", 192, 1, 0, 4, "down", s378],
[s249, "unicast", 192, 1, 4, 1.208, "up down", s378],
[s401, "unicast", 188, 1, 0, 4, "up", s378],
[s402, "unicast", 188, 1, 0, 4, "down", s378],
[s254, "unicast", 188, 1, 4, 1.208, "up down", s378],
[s264, "unicast", 192, 1, 5, 1.08, "up down", s378],
["User ACKNACK", "unicast", 188, 1, 5, 1.179, "up down", s378],
];
const s411 = {"count": "count18", "more": ["more48", "more2"]};
const s412 = {"count": "count19", "more": ["more49", "more50", "more38"]};
const s413 = {"count": "count20", "more": ["more51", "more40"]};
const s414 = "moving to ROS 2 Lyrical (Fast DDS 3.6)";
const s415 = "moving to ROS 2 Humble (Fast DDS 2.6)";
const s416 = "moving to ROS 2 Jazzy (Fast DDS 2.14)";
const s417 = "with UDP and shared memory, as shipped and as ROS 2 sets it (measured with 2.9.1)";
const s418 = [
[1, 1.67, 11.3, "In 11 swarms within these sizes, left out of the fit, discovery took 0.91 to 1.04 times the predicted airtime (typical error 3%). We expect 83% of such swarms in this range"],
[2, 1.67, 11.3, "In 2 swarms of up to twice these sizes, left out of the fit, discovery took 0.95 to 1.22 times the predicted airtime (typical error 13%). With so few swarms, we give no interval"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints, left out of the fit, discovery took 2.06 to 2.29 times the predicted airtime (typical error 118%). With so few swarms, we give no interval"],
];
const s419 = {"count": "count23", "more": ["more56", "more57", "more8"]};
const s420 = [s419, s419, s419];
const s421 = [s169, s420, s173, s230, s171, s232];
const s422 = "SPDP at discovery";
const s423 = 4.833333333333333;
const s424 = 5.166666666666666;
const s425 = {"burst": s423, "second": s424, "lease": 0.575, "ever": s372};
const s426 = "SPDP unicast at discovery";
const s427 = "SPDP unicast for others";
const s428 = 852.6666666666666;
const s429 = "Heartbeat for others";
const s430 = "ACKNACK of data";
const s431 = "switching to Cyclone DDS";
const s432 = [[1, 1, 1, "In 19 swarms within these sizes, left out of the fit, discovery took 0.86 to 1.68 times the predicted airtime (typical error 14%). We expect 90% of such swarms in this range"]];
const s433 = 773.5594083028471;
const s434 = "ROS discovery info";
const s435 = "ROS Heartbeat for others";
const s436 = "ROS ACKNACK for others";
const s437 = [[1, 1, 1, "In 16 swarms within these sizes, left out of the fit, discovery took 0.89 to 1.17 times the predicted airtime (typical error 5%). We expect 88% of such swarms in this range"]];
const s438 = [s169, s173, s171, s232, s230];
const s439 = 1014.7323568575234;
const s440 = "both values use the measured model of Fast DDS, and the server forwards everything, as in Fast DDS 3.6";
const s441 = ["peers", s354, "", s157, "Fast DDS 3.6", s355];
const s442 = [s105, s356, "", s160, "Fast DDS 3.6", s357];
const s443 = ["router", s200, "", "Zenoh router", "Fast DDS 3.6", s201];
const s444 = [s110, s203, "", s180, "Fast DDS 3.6", s204];
const s445 = [s118, s206, "", s183, "Fast DDS 3.6", s207];
const s446 = ["announcements", s209, "", "Fast DDS 3.6, a longer announcement interval", "Fast DDS 3.6", "announcements"];
const s447 = ["release", s415, "", "Fast DDS 2.6", "Fast DDS 3.6", "release"];
const s448 = ["release", s416, "", "Fast DDS 2.14", "Fast DDS 3.6", "release"];
const s449 = ["middleware", s213, "", s177, "Fast DDS 3.6", "middleware"];
const s450 = [[1, 1, 1, "In 64 of 68 swarms within these sizes, left out of the fit, discovery took 0.90 to 1.57 times the predicted airtime (typical error 6%). We expect 91% of such swarms in this range"]];
const s451 = [s169, s173, s171, s232, [s231, s231, s231], s230];
const s452 = 896.8584995251663;
const s453 = 189.68085535606212;
const s454 = 808.8594208980277;
const s455 = "--ds-basis-proposal";
const s456 = {"until": [s163, [23, "slow at best"], s164], "never": s165};
const s457 = {"second": 1, "lease": 23, "ever": Infinity};
const s458 = {"count": "count24", "more": ["more58", "more35"]};
const s459 = [s458, s458, s458];
const s460 = {"count": "more35", "more": ["more35"]};
const s461 = [s460, s460, s460];
const s462 = {"burst": 1, "second": 1, "lease": 0.043478260869565216, "ever": 0};
const s463 = ["Announce", "multicast", 80, 1, 0, 1, "up down", s462];
const s464 = ["Process", "multicast", 24, 0, 1, 1, "up down", s462];
const s465 = ["Endpoint", "multicast", 20, 0, 2, 1, "up down", s462];
const s466 = ["Digest", "multicast", 80, 1, 3, 1, "up down", s462];
const s467 = ["Listed", "multicast", 1, 0, 0, 1, "up down", s462];
const s468 = {"burst": 0, "second": s372, "lease": s372, "ever": s372};
const s469 = ["Heartbeat", "multicast", 80, 1, 0, 1, "up down", s468];
const s470 = ["Claimed", "multicast", 0.125, 0, 4, 1, "up down", s468];
const s471 = {"count": "count25", "more": ["count25"]};
const s472 = "switching to DDS, periods of Cyclone DDS";
const s473 = "DDS, periods of Cyclone DDS";
const s474 = "DDS, periods of Fast DDS";
const s475 = "switching to Zenoh, periods of Zenoh peer";
const s476 = "Zenoh, periods of Zenoh peer";
const s477 = "switching to DDS, periods of Fast DDS";
const s478 = "--ds-product-zenoh";
const s479 = {"burst": 3.125, "second": 3.25, "lease": 0.4375, "ever": 0.125};
const s480 = {"burst": 0, "second": 0.4, "lease": 0.4, "ever": 0.4};
const s481 = ["KeepAlive", "unicast", 84, 1, 1, 1, "up down", s480];
const s482 = "Fast DDS with endpoints that are known in advance (static EDP), participants announced as ever (measured with 2.9.1)";
const s483 = [[1, 1, 1, "In 10 swarms within these sizes, left out of the fit, discovery took 0.95 to 1.31 times the predicted airtime (typical error 5%). We expect 82% of such swarms in this range"]];
const s484 = [s367, s367, s367];
const s485 = {"count": "count26", "more": ["more59", "more60"]};
const s486 = {"count": "count27", "more": ["more61", "more62", "more63"]};
const s487 = [s169, s420, s366, s173, s230, s171, s484, [s485, s485, s485], s228, [s486, s486, s486], s232];
const s488 = "SPDP of endpoints";
const s489 = "SPDP unicast of endpoints";
const s490 = "Listed at discovery";
const s491 = "Listed of endpoints";
const s492 = "Listed unicast";
const s493 = "Listed unicast at discovery";
const s494 = "Listed unicast for others";
const s495 = "Listed unicast of endpoints";
const s496 = "peers, each linked with each other (measured with 1.10.2)";
const s497 = [[1, 1, 1, "In 10 swarms within these sizes, left out of the fit, discovery took 0.86 to 1.12 times the predicted airtime (typical error 8%). We expect 82% of such swarms in this range"]];
const s498 = [s170, {"count": "count28", "more": ["more64", "more65", "more66"]}, s231];
const s499 = [s169, s173, s230, s171, s498, s232];
const s500 = ["Scout", "multicast", 67, 1, 0, 1, "up down", s479];
const s501 = ["Hello", "unicast", 104, 1, 1, 1, "up down", {"burst": 2.125, "second": 2.25, "lease": 0.3375, "ever": 0.125}];
const s502 = ["InitAck", "unicast", 153, 1, 1, 0.6667, "up down", s238];
const s503 = ["OpenSyn", "unicast", 134, 1, 1, 0.6667, "up down", s238];
const s504 = ["OpenAck", "unicast", 84, 1, 1, 0.6667, "up down", s238];
const s505 = 163.4251497005988;
const s506 = "OAM for others";
const s507 = 106.65917220235053;
const s508 = "Declare key expression";
const s509 = 229.04217991787982;
const s510 = "Declare key expression of matching";
const s511 = 112.31961259079904;
const s512 = "Frame of endpoints";
const s513 = ["KeepAlive", "unicast", 79, 1, 1, 1.333, "up down", s480];
const s514 = ["TCP control", "unicast", 76, 1, 1, 1.333, "up down", s238];
const s515 = "TCP ACK at start";
const s516 = "TCP ACK of endpoints";
const s517 = "with liveliness tokens, as rmw_zenoh has them, and a subscriber to all of them (measured with 1.10.2)";
const s518 = [
[1, 1.67, 11.3, "In 12 swarms within these sizes, left out of the fit, discovery took 0.90 to 1.41 times the predicted airtime (typical error 6%). We expect 85% of such swarms in this range"],
[2, 1.67, 11.3, "In 4 swarms of up to twice these sizes, left out of the fit, discovery took 0.99 to 1.02 times the predicted airtime (typical error 1%). With so few swarms, we give no interval"],
[Infinity, 1.67, 11.3, "In 2 swarms with up to 11 times the endpoints, left out of the fit, discovery took 0.93 to 1.15 times the predicted airtime (typical error 11%). With so few swarms, we give no interval"],
];
const s519 = 179.4287333522244;
const s520 = 167.6030534351145;
const s521 = 175.50248756218906;
const s522 = "Declare token of node";
const s523 = 362.8385800401876;
const s524 = "Declare key expression of node";
const s525 = 159.33333333333334;
const s526 = 142.56804733727813;
const s527 = "--ds-product-rmw-zenoh";
const s528 = {"until": [s163, [60, "slow at best"], s164], "never": s165};
const s529 = {"second": 1, "lease": 60, "ever": Infinity};
const s530 = [s365, {"count": "count29", "more": ["more67", "more68"]}, s231];
const s531 = {"burst": 1, "second": 1, "lease": 0.016666666666666666, "ever": 0};
const s532 = ["InitSyn", "unicast", 110, 1, 0, 1, "up", s531];
const s533 = ["InitAck", "unicast", 153, 1, 0, 1, "down", s531];
const s534 = ["OpenSyn", "unicast", 134, 1, 0, 1, "up", s531];
const s535 = ["OpenAck", "unicast", 84, 1, 0, 1, "down", s531];
const s536 = 154.5017382527756;
const s537 = 192.6407465007776;
const s538 = 358.9464799539613;
const s539 = 137.8131868131868;
const s540 = 282.5695792880259;
const s541 = 622.248870141609;
const s542 = 148.72727272727272;
const s543 = 156.64516129032256;
const s544 = 0.03333333333333333;
const s545 = {"burst": 0, "second": s544, "lease": s544, "ever": s544};
const s546 = ["KeepAlive down", "unicast", 79, 1, 0, 1, "down", s545];
const s547 = "TCP ACK at start down";
const s548 = "TCP ACK of endpoints down";
const s549 = {"count": "count32", "more": ["more73", "more74", "more75", "more35"]};
const s550 = {"count": "count33", "more": ["more76", "more77", "more78", "more79", "more35"]};
const s551 = {"count": "count34", "more": ["more80", "more81", "more40"]};
const s552 = [s551, s551, s551];
const s553 = [s551, {"count": "count35", "more": ["more82", "more83", "more68"]}, s231];
const s554 = [s231, {"count": "count36", "more": ["more84", "more85", "more86"]}, {"count": "count37", "more": ["more87", "more88", "more89"]}];
const s555 = 1523.8764478764479;
const s556 = 1523.7329974811084;
const s557 = "Frame of gossip";
const s558 = 86.42028482111844;
const s559 = "Declare of matching";
const s560 = 1523.275922671353;
const s561 = "Declare key expression of tokens";
const s562 = 1524.2088308803109;
const s563 = 86.11918147065437;
const s564 = 1524.6626402070751;
const s565 = 1523.8867459991793;
const s566 = 1523.9638009049772;
const s567 = [s171, s173];
const s568 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s358,
"caution": "",
"ratios": s359,
"server_ratios": s162,
"has_server": true,
"color": s360,
"measured": [8, 8, 10],
"band": s361,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s370,
"degree": 2,
"messages": s406,
};
const s569 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s407,
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": true,
"color": s360,
"measured": [8, 8, 10],
"band": s409,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s370,
"degree": 2,
"messages": s410,
};
const s570 = {"until": [s163, [100, "slow at best"], s164], "never": s165};
const s571 = {"second": 1, "lease": 100, "ever": Infinity};
const s572 = {"burst": 1.9966666666666666, "second": 2.03, "lease": 0.0533, "ever": s544};
const s573 = {"burst": 0.9966666666666667, "second": 1.03, "lease": 0.0433, "ever": s544};
const s574 = {"burst": 4, "second": 4, "lease": 0.04, "ever": 0};
const s575 = {"burst": 1, "second": 1, "lease": 0.01, "ever": 0};
const s576 = 0.01020408163265306;
const s577 = {"burst": 0, "second": s576, "lease": s576, "ever": s576};
const s578 = ["Liveliness", "unicast", s243, 0.7242, 1, 1, "up down", s577];
const s579 = [s249, "unicast", s250, 0.2758, 1, 1, "up down", s577];
const s580 = [s254, "unicast", 128, 1, 1, 1, "up down", s577];
const s581 = [s169, s420, s366, s484, s369, s232];
const s582 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s358,
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": true,
"color": s360,
"measured": [8, 8, 10],
"band": s361,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s581,
"degree": 2,
"messages": s406,
};
const s583 = {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s407,
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": true,
"color": s360,
"measured": [8, 8, 10],
"band": s409,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s581,
"degree": 2,
"messages": s410,
};
const s584 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", s572];
const s585 = 0.06666666666666667;
const s586 = {"burst": 1.9333333333333333, "second": 2, "lease": 0.086, "ever": s585};
const s587 = {"burst": 0.9333333333333333, "second": 1, "lease": 0.076, "ever": s585};
const s588 = {"burst": s423, "second": s424, "lease": 0.38166666666666665, "ever": s372};
const s589 = [s173, s230, s171, s498, s232];
const s590 = ["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s238];
const s591 = ["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s238];
const s592 = ["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s238];
const s593 = 0.9997000149992501;
const s594 = ["KeepAlive", "unicast", 79, 1, 0, s593, "up down", s480];
const s595 = ["TCP control", "unicast", 76, 1, 0, s593, "up down", s238];
return {
"start": {"robot": s1, "middleware": "Fast DDS 3.6", "ros": "lyrical", "product": "Fast DDS"},
"ros": {"humble": {"Fast DDS": "Fast DDS 2.6", "Cyclone DDS": "Cyclone DDS"}, "jazzy": {"Fast DDS": "Fast DDS 2.14", "Cyclone DDS": "Cyclone DDS"}, "kilted": {"Fast DDS": "Fast DDS 3.6", "Cyclone DDS": "Cyclone DDS"}, "lyrical": {"Fast DDS": "Fast DDS 3.6", "Cyclone DDS": s2}},
"exact": {"Fast DDS": "Fast DDS 2.9", "Cyclone DDS": "Cyclone DDS 0.10", "Cyclone DDS, version 11": "Cyclone DDS 11"},
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
"name": s12,
"model": "linear",
"values": {"R_uni": 144400000, "O_uni": 0.00018, "R_multi": 6000000, "O_multi": 0.00012},
"remedies": [
{"kind": s13, "what": s14, "note": s15, "base": s18, "wifi": {"name": s19, "model": "padded", "values": s20}},
{"kind": "radio", "what": s21, "note": "compared with 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead per frame exchange. Both values use the timing of the 802.11 standard", "base": s18, "wifi": s24},
{"kind": "radio", "what": s25, "note": "compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead per frame exchange. Both values use the timing of the 802.11 standard", "base": s18, "wifi": s29},
{"kind": "radio", "what": s30, "note": "compared with 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead per frame exchange. Both values use the timing of the 802.11 standard", "base": s18, "wifi": s34},
{"kind": "aggregation", "what": "aggregating up to 64 frames", "note": s15, "base": s18, "wifi": s35},
],
},
{
"name": s36,
"model": "padded",
"values": s37,
"remedies": [
{"kind": s13, "what": s14, "note": "", "base": s38, "wifi": {"name": "802.11a 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": s39}},
{"kind": "radio", "what": s21, "note": "compared with 802.11a 20 MHz 1x1: 300 instead of 54 Mbit/s and 186 instead of 166 µs of overhead per frame exchange", "base": s38, "wifi": s24},
{"kind": "radio", "what": s25, "note": "compared with 802.11a 20 MHz 1x1: 867 instead of 54 Mbit/s and 190 instead of 166 µs of overhead per frame exchange", "base": s38, "wifi": s29},
{"kind": "radio", "what": s30, "note": "compared with 802.11a 20 MHz 1x1: 2402 instead of 54 Mbit/s and 196 instead of 166 µs of overhead per frame exchange", "base": s38, "wifi": s34},
],
},
{
"name": s40,
"model": "padded",
"values": s41,
"remedies": [
{"kind": s13, "what": s42, "note": "", "base": s43, "wifi": {"name": "802.11g 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": s39}},
{"kind": "radio", "what": s21, "note": "compared with 802.11g 20 MHz 1x1: 300 instead of 54 Mbit/s, 186 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s43, "wifi": s24},
{"kind": "radio", "what": s25, "note": "compared with 802.11g 20 MHz 1x1: 867 instead of 54 Mbit/s, 190 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s43, "wifi": s29},
{"kind": "radio", "what": s30, "note": "compared with 802.11g 20 MHz 1x1: 2402 instead of 54 Mbit/s, 196 instead of 166 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s43, "wifi": s34},
],
},
{
"name": s44,
"model": "padded",
"values": s17,
"full": s35,
"remedies": [
{"kind": s13, "what": s14, "note": "", "base": s45, "wifi": {"name": s19, "model": "padded", "values": s20, "full": {"name": "802.11n 20 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64", "model": "aggregated", "values": s46}}},
{"kind": "radio", "what": s21, "note": "compared with 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead per frame exchange", "base": s45, "wifi": s48},
{"kind": "radio", "what": s25, "note": "compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead per frame exchange", "base": s45, "wifi": s50},
{"kind": "radio", "what": s30, "note": "compared with 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead per frame exchange", "base": s45, "wifi": s52},
],
},
{
"name": s53,
"model": "padded",
"values": s54,
"full": s55,
"remedies": [
{"kind": s13, "what": s42, "note": "", "base": s56, "wifi": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s", "model": "padded", "values": s20, "full": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64", "model": "aggregated", "values": s46}}},
{"kind": "radio", "what": s21, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 300 instead of 144 Mbit/s, 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s56, "wifi": s48},
{"kind": "radio", "what": s25, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 867 instead of 144 Mbit/s, 190 instead of 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s56, "wifi": s50},
{"kind": "radio", "what": s30, "note": "compared with 802.11n 20 MHz 2x2, 2.4 GHz: 2402 instead of 144 Mbit/s, 196 instead of 186 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s56, "wifi": s52},
],
},
{
"name": s22,
"model": "padded",
"values": s23,
"full": s47,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s48,
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
{"kind": "radio", "what": s25, "note": "compared with 802.11n 40 MHz 2x2: 867 instead of 300 Mbit/s and 190 instead of 186 µs of overhead per frame exchange", "base": s48, "wifi": s50},
{"kind": "radio", "what": s30, "note": "compared with 802.11n 40 MHz 2x2: 2402 instead of 300 Mbit/s and 196 instead of 186 µs of overhead per frame exchange", "base": s48, "wifi": s52},
],
},
{
"name": s26,
"model": "padded",
"values": s28,
"full": s49,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s50,
"wifi": {
"name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s27, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s27, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
},
},
},
{"kind": "radio", "what": s30, "note": "compared with 802.11ac 80 MHz 2x2: 2402 instead of 867 Mbit/s and 196 instead of 190 µs of overhead per frame exchange", "base": s50, "wifi": s52},
],
},
{
"name": s57,
"model": "padded",
"values": s59,
"full": s60,
"remedies": [
{
"kind": s13,
"what": s42,
"note": "",
"base": s61,
"wifi": {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s58, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s58, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
},
},
},
{"kind": "radio", "what": s21, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 300 instead of 287 Mbit/s, 186 instead of 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s61, "wifi": s48},
{"kind": "radio", "what": s25, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 867 instead of 287 Mbit/s, 190 instead of 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s61, "wifi": s50},
{"kind": "radio", "what": s30, "note": "compared with 802.11ax 20 MHz 2x2, 2.4 GHz: 2402 instead of 287 Mbit/s, 196 µs of overhead per frame exchange and multicast at 6 instead of 1 Mbit/s", "base": s61, "wifi": s52},
],
},
{
"name": s62,
"model": "padded",
"values": s64,
"full": s65,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s66,
"wifi": {
"name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s63, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s63, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
},
},
},
{"kind": "radio", "what": s30, "note": "compared with 802.11ax 80 MHz 2x2: 2402 instead of 1201 Mbit/s and 196 µs of overhead per frame exchange", "base": s66, "wifi": s52},
],
},
{
"name": s31,
"model": "padded",
"values": s33,
"full": s51,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s52,
"wifi": {
"name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s32, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s32, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
},
},
},
],
},
{
"name": s67,
"model": "padded",
"values": s69,
"full": s70,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": s71,
"wifi": {
"name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s68, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s68, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
},
},
},
{"kind": "radio", "what": s30, "note": "compared with 802.11be 80 MHz 2x2: 2402 instead of 1441 Mbit/s and 196 instead of 204 µs of overhead per frame exchange", "base": s71, "wifi": s52},
],
},
{
"name": s72,
"model": "padded",
"values": s74,
"full": s75,
"remedies": [
{
"kind": s13,
"what": s14,
"note": "",
"base": {"name": s72, "model": "padded", "values": s74, "full": s75},
"wifi": {
"name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s",
"model": "padded",
"values": {"R_uni": s73, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
"full": {
"name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
"model": "aggregated",
"values": {"R_uni": s73, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
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
"simulated_anyway": [s76, s77],
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
"works in simulations": "Not sure: in simulations, {fleet} discover each other within {within} ({how}), but {caution}.",
"probably": "Probably: in simulations, {fleet} discover each other within {within} ({how}), but {slower}.",
"forgotten": "No: {fleet} discover each other ({how}), but forget each other again in {forgetful} of {runs} runs, because leases expire.",
"too slow": "No, not within {within}: {fleet} need longer to discover each other ({how}).",
"never": "No: {fleet} do not complete discovery within {until} ({how}).",
"seldom": "No: in only {finished} of {runs} runs, {fleet} complete discovery within {until} ({how}).",
"never in time": "No, not within {within}: {fleet} do not complete discovery even within {until} ({how}).",
"unrepaired": "Not sure: {fleet} need at least {low} ({how}), and longer if messages are lost.",
"unrepaired and slow": "No, not within {within}: {fleet} need at least {low} ({how}).",
"too busy": "No, not within {within}: {fleet} keep the channel busy for {drain} even if nothing is lost ({how}).",
"endless": "No: {fleet} never complete discovery ({how}).",
"unknown": "Not sure: {fleet} keep the channel busy for {drain} if nothing is lost ({how}), and their discovery time was not simulated.",
"times": "Discovery time: {median} in the median run, at most {nine} in {most}.",
"times of some": "Discovery time: {median} in the median run; {late} of {runs} runs do not finish within {until}.",
"most pairs": "After {time}, {share} of the pairs of processes know each other.",
"share of pairs": "After {until}, {share} of the pairs of processes know each other.",
"busy": "The channel goes idle after {median} (median). {lost} of the messages are lost on the way, and we do not simulate how {protocol} repairs losses.",
"not simulated": "Not simulated: {reason}.",
"periodic traffic fills": "Periodic traffic alone fills the channel.",
"access point loses": "The access point's queue drops {lost} of all messages, more than {protocol} can resend in time.",
"robots lose": "Robots' queues drop {lost} of all messages, more than {protocol} can resend in time.",
"air loses": "Collisions cost {lost} of all messages, more than {protocol} can resend in time.",
"leases end": "Leases expire meanwhile, so robots forget each other.",
"data fits": "Your data fit: after discovery, data and periodic traffic together need {airtime} of airtime per second.",
"data may fit": "Your data fit only if radios aggregate well: data and periodic traffic then need {airtime} of airtime per second after discovery. With one frame at a time, they do not fit.",
"data late": "Data may be late during startup: in its first second, discovery and data together need {airtime} of airtime.",
"data does not fit": "Your data do not fit: even after discovery, data and periodic traffic together need {airtime} of airtime per second. First step: send fewer samples, or send them to fewer hosts.",
"first": "First step:",
"covered": "To be sure, make one of these changes, least effort first:",
"faster": "Faster still, least effort first:",
"then": "Or:",
"shorter": "Better, but not complete within {within}:",
"not sure either": "Better in simulations, but perhaps not enough:",
"none helps": "None of the {count} simulated changes helps much.",
"none known": "No change that we could simulate helps.",
"change": "{number}. {what}: {before} -> {after}. Effort: {effort}. Trade-off: {cost}.",
"leases": "{time}, but leases expire in {forgetful} of {runs} runs",
"enough": "{time}; {least} if all are composed into 1",
"doubtful": " Not sure: {caution}.",
"perhaps": " Real runs may take up to {slow}, longer than your target.",
"slower": "real {measured} took up to {times} times as long as simulated in startups of over 1.5 s in an emulated Wi-Fi cell, which would be {slow}",
"slower elsewhere": "real runs may take up to {times} times as long ({slow}; we have not measured any)",
"easier": "Less effort, but not complete within {within}:",
"easier, perhaps": "Less effort, but perhaps not complete within {within}:",
"fewer": "start no more than {count} of the {group} on this channel{beside}. These {total} discover each other after {time}. We did not simulate whether the others can start later.",
"stopgap": "First step: {fewer}",
"until then": "Until then, {fewer}",
"changes": "Then make one change that is enough for discovery:",
"none near": "No simulated change lets half of the pairs discover each other within {until}.",
"paste": " To configure it: --paste {name}.",
"closed form": "Ranked by airtime saved, because discovery times were not simulated:",
"drain": "- {what}: never -> the channel goes idle after {after}, if nothing is lost.",
"none ends": "No change is enough: after each one, periodic traffic alone fills the channel.",
"possible": "These may help, but we do not simulate how they repair losses: {names}.",
"bounds": "Unknown, because we do not simulate how these changes repair losses: {names}.",
"parts": "After these changes, some robots no longer discover each other: {names}.",
"domains": "To configure them: --paste domains, which deals the hosts to the domains in turn: swap hosts so that robots that must hear each other share a domain. Domains share the channel: we simulate one of them on a channel slowed down by the airtime of the others. Real times are longer, because messages of different domains also collide and share the access point's queue.",
"others": "Helped little, or not at all: {names}.",
"left out": "Not simulated, because {reason}: {names}.",
"compared": "Discovery times are medians of {runs}. A startup works if nine of ten runs complete discovery within {within} and no running robot's lease expires. Name a single protocol to see which changes help.",
"cautious": "Not sure for {names}: {caution}.",
"some leases": "leases expire in {forgetful} of {runs} runs",
"lost": "{lost} of the messages lost, and no repairs simulated",
"reboot": "If one robot reboots, all others rediscover it {time} after its nodes start, and {kept}.",
"kept": "none of their leases expires",
"not kept": "some of their leases expire in {forgetful} of {runs} runs",
"no robot rebooted": "No reboot was simulated, as not every startup finishes.",
"sure": "How sure: {runs} of {until} with fixed seeds.",
"ranges": "Ranges span {interval}.",
"long runs": "{runs} if they take long",
"hopeless run": "only {runs} if fewer than {share} of the pairs finish",
"assumed": "Assumes: one access point, all robots in range, a common start unless stated, queues of 500 messages.",
"most runs": "the second fastest to the second slowest of {runs} runs",
"all runs": "all {runs} runs",
"both runs": "both runs",
"never means": "'Never' means not within the {until} that we simulated.",
"rounded": "{name}: a process has {mean} endpoints on average; we simulate {whole}.",
"domain": "All hosts have ROS_DOMAIN_ID {domain}, which does not change these times.",
"of paper: messages channel": "Messages and channel are the paper's: set yours with `--protocol` and `--wifi`.",
"of paper: messages": "The messages are the paper's: set yours with `--protocol`.",
"of paper: channel": "The channel is the paper's: set yours with `--wifi`.",
"server": "The server is wired to the access point, and is not one of your hosts.",
"extrapolated": "{protocol} was measured with up to {hosts}; for larger fleets, we extrapolate.",
"air": "With up to {hosts} hosts in an emulated Wi-Fi cell, real {measured} took {range} times as long as simulated where one of the two took over 1.5 s.",
"watched": "We watched real startups for at most {seconds} s, so we extrapolate longer times.",
"not compared": "Real runs may take up to {high} times as long (we have not measured any).",
"server not compared": "Real startups with a server or router may take up to {high} times as long (we have not measured any).",
"interrupted": "Interrupted: not all runs are done, so some changes are missing.",
"cell": "{cell}: the startup needs {airtime} of airtime in its first second.",
"assumed of cells": "Assumes: all robots in range of their access points, a common start unless stated, queues of 500 messages. Cells do not interfere, and messages between access points take no time. We do not compare other radios and channels: change the fleet file, and plan again.",
"surer": "To check, record one startup: `discostorm capture`.",
"why": "`--why` adds airtime, configurations and assumptions; `--all` adds all changes.",
"searching": "Next we check how many robots can start unchanged, and look for smaller changes that suffice.",
"not known again": "Not after a reboot: if one robot reboots, not all others rediscover it within the simulated time.",
"no reboot": "Not sure: we simulate a reboot only if every startup has finished before it.",
"several at once": "The command discostorm plan also tries other changes together.",
"other start": "Changes are compared for robots that start together.",
"never fits": "The periodic traffic alone needs {share} of the channel, so the fleet never fits, however slowly it starts.",
"drain time": "Drain time: {busy}. {why}",
"sooner": "Discovery can be complete sooner, because dropped messages need no airtime and the last repeats come after discovery.",
"later": "Discovery takes longer, because processes wait before they answer and before they repeat lost messages.",
"full A-MPDUs": "The drain time assumes full A-MPDUs. They are fuller when more frames wait.",
"may never fit": "The fleet may never fit: with one message per frame, its periodic traffic alone needs {share} of the channel.",
"reply wait": "While nodes start, service servers need a max_blocking_time (reliability QoS) of {wait} or more. Fast DDS has {usual} by default.",
"endless reply wait": "While nodes start, no max_blocking_time is long enough for services: some pairs never complete discovery.",
"data load": "Your data need {data} of the channel, or {both} together with the periodic traffic of discovery. So your data {fit} once discovery is complete.",
"data during startup": "During startup, your data {fit}: discovery and data together need {airtime} of airtime in the first {time}.",
"data wait": "If robots sent all data from the beginning, startup would keep the channel busy for {time} instead of {alone}. Data wait at most that long, and in practice less, because robots send only to robots that they have discovered. `discostorm simulate` shows when discovery is complete, and how late the data are.",
"no room for data": "The channel can never carry discovery and all your data. Send fewer samples, or send them to fewer hosts.",
"captured": "The measured model of {name} comes from captures of up to {hosts} that started together, with up to {processes} in all and {endpoints} per process.",
"beyond captures": "Here, we extrapolate.",
"as the paper": "{name} counts {names} as the paper does. It leaves out the messages that the product packs together or adds.",
"whole burst": "We assign the whole startup burst to the first {window}, and count periodic traffic at its average rate. The result is an upper bound.",
"standard timing": "Radio changes use the timing of the 802.11 standard, by which this fleet needs {airtime} of airtime today.",
"nothing to write": "Your startup already works, so nothing needs changing, and we wrote no files. To write the configuration of a change all the same, name it: --paste NAME.",
"nothing written": "--write: no configuration change is surely enough, so we wrote no files. See what helps without --write, then name a change: --paste NAME",
},
"alone": "A single host has no one to discover, and no other host receives its messages.",
"security": ["DDS Security (SROS2) is not counted.", "In startups that we captured, it multiplied airtime by 1.6 to 5.7 with Fast DDS and 2.1 to 2.8 with Cyclone DDS. Keep it on your robots, but plan without it, and with a shorter target: in place of 60 s, within = 10 with Fast DDS or 21 with Cyclone DDS."],
"topology": "one access point, infrastructure",
"limit": 1,
"told": 2,
"beyond": "; this fleet is larger, so expect errors of up to a factor of 2",
"times": [[0, 1e-06, "µs"], [0.001, 0.001, "ms"], [0.1, 1, "s"], [100, 60, "minutes"], [6000, 3600, "hours"], [172800, 86400, "days"], [60480000, 31557600, "years"]],
"airtime": {"inside": {"up": s78, "multicast": "inside_multicast", "unicast": s78}, "linear": {"up": s79, "multicast": "linear_multicast", "unicast": s79}, "padded": {"up": s80, "multicast": s81, "unicast": s80}, "aggregated": {"up": s82, "multicast": s81, "unicast": s82}},
"laptop_nodes": 2,
"service_endpoints": 12,
"endpoints_of_a_node": 28.40740740740741,
"shared_endpoints": [2, 4],
"remedies": {
"aggregation": {"steps": ["aggregation"], "of": {"DDS": s84, "Zenoh": s84, "None": s84}},
"aggregation and staggered start": {"steps": ["aggregation", s76], "of": {"DDS": s87, "Zenoh": s87, "None": s87}},
"announcements": {"steps": ["announcements"], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s88, "best_case": false, "cost": "failed robots are noticed later, and lost announcements are repeated later"}, "Zenoh": null, "None": null}},
"announcements and staggered start": {"steps": ["announcements", s76], "of": {"DDS": {"efforts": s89, "effort": 2, "takes": s90, "best_case": false, "cost": "failed robots are noticed later, and lost announcements are repeated later; discovery cannot be complete before the last host starts"}, "Zenoh": null, "None": null}},
"discovery server": {"steps": [s77], "of": {"DDS": {"efforts": ["server"], "effort": 3, "takes": s91, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the server is down and after short outages"}, "Zenoh": null, "None": null}},
"discovery server and staggered start": {
"steps": [s77, s76],
"of": {
"DDS": {"efforts": s92, "effort": 3, "takes": s93, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while the server is down and after short outages"},
"Zenoh": null,
"None": null,
},
},
"discovery server on a robot": {"steps": [s94], "of": {"DDS": {"efforts": ["server"], "effort": 3, "takes": s91, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the robot with the server is away"}, "Zenoh": null, "None": null}},
"discovery server on a robot and staggered start": {
"steps": [s94, s76],
"of": {
"DDS": {"efforts": s92, "effort": 3, "takes": s93, "best_case": false, "cost": "robots need the server's address; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while the robot with the server is away"},
"Zenoh": null,
"None": null,
},
},
"endpoints": {"steps": ["endpoints"], "of": {"DDS": s95, "Zenoh": s95, "None": s95}},
"endpoints and staggered start": {"steps": ["endpoints", s76], "of": {"DDS": s98, "Zenoh": s98, "None": s98}},
"middleware": {"steps": ["middleware"], "of": {"DDS": s100, "Zenoh": {"efforts": ["switch"], "effort": 8, "takes": s99, "best_case": false, "cost": "all hosts must change together; we assume peers that scout by multicast; the paper does not count the tokens of rmw_zenoh"}, "None": s100}},
"middleware and discovery server": {
"steps": ["middleware", s77],
"of": {"DDS": {"efforts": s101, "effort": 8, "takes": s102, "best_case": false, "cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the server is down and after short outages"}, "Zenoh": null, "None": null},
},
"middleware and discovery server and staggered start": {
"steps": ["middleware", s77, s76],
"of": {
"DDS": {
"efforts": s103,
"effort": 8,
"takes": s104,
"best_case": false,
"cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while the server is down and after short outages",
},
"Zenoh": null,
"None": null,
},
},
"middleware and discovery server on a robot": {
"steps": ["middleware", s94],
"of": {"DDS": {"efforts": s101, "effort": 8, "takes": s102, "best_case": false, "cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; late joiners stay undiscovered while the robot with the server is away"}, "Zenoh": null, "None": null},
},
"middleware and discovery server on a robot and staggered start": {
"steps": ["middleware", s94, s76],
"of": {
"DDS": {
"efforts": s103,
"effort": 8,
"takes": s104,
"best_case": false,
"cost": "all hosts must change together; robots need the server's address; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while the robot with the server is away",
},
"Zenoh": null,
"None": null,
},
},
"middleware and multicast endpoint data": {"steps": ["middleware", s105], "of": {"DDS": {"efforts": s106, "effort": 8, "takes": s107, "best_case": false, "cost": "all hosts must change together; multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later"}, "Zenoh": null, "None": null}},
"middleware and multicast endpoint data and staggered start": {
"steps": ["middleware", s105, s76],
"of": {
"DDS": {"efforts": s108, "effort": 8, "takes": s109, "best_case": false, "cost": "all hosts must change together; multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later; discovery cannot be complete before the last host starts"},
"Zenoh": null,
"None": null,
},
},
"middleware and peers": {
"steps": ["middleware", "peers"],
"of": {
"DDS": {"efforts": s106, "effort": 8, "takes": s107, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS)"},
"Zenoh": {"efforts": s106, "effort": 8, "takes": s107, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; a process that dials a peer too early may keep dialing every 4 s"},
"None": null,
},
},
"middleware and peers and staggered start": {
"steps": ["middleware", "peers", s76],
"of": {
"DDS": {"efforts": s108, "effort": 8, "takes": s109, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS); discovery cannot be complete before the last host starts"},
"Zenoh": {"efforts": s108, "effort": 8, "takes": s109, "best_case": false, "cost": "all hosts must change together; you must know the addresses beforehand; a process that dials a peer too early may keep dialing every 4 s; discovery cannot be complete before the last host starts"},
"None": null,
},
},
"middleware and router": {
"steps": ["middleware", "router"],
"of": {"DDS": null, "Zenoh": {"efforts": s101, "effort": 8, "takes": s102, "best_case": false, "cost": "all hosts must change together; robots need the router's address; all data pass through it; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)"}, "None": null},
},
"middleware and router and staggered start": {
"steps": ["middleware", "router", s76],
"of": {
"DDS": null,
"Zenoh": {
"efforts": s103,
"effort": 8,
"takes": s104,
"best_case": false,
"cost": "all hosts must change together; robots need the router's address; all data pass through it; discovery cannot be complete before the last host starts; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)",
},
"None": null,
},
},
"middleware and router on each host": {
"steps": ["middleware", s110],
"of": {"DDS": null, "Zenoh": {"efforts": s111, "effort": 8, "takes": s112, "best_case": false, "cost": "all hosts must change together; every router needs the addresses of all other routers; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back"}, "None": null},
},
"middleware and router on each host and staggered start": {
"steps": ["middleware", s110, s76],
"of": {
"DDS": null,
"Zenoh": {
"efforts": s113,
"effort": 8,
"takes": s114,
"best_case": false,
"cost": "all hosts must change together; every router needs the addresses of all other routers; discovery cannot be complete before the last host starts; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back",
},
"None": null,
},
},
"middleware and staggered start": {
"steps": ["middleware", s76],
"of": {"DDS": s117, "Zenoh": {"efforts": s115, "effort": 8, "takes": s116, "best_case": false, "cost": "all hosts must change together; we assume peers that scout by multicast; the paper does not count the tokens of rmw_zenoh; discovery cannot be complete before the last host starts"}, "None": s117},
},
"middleware and star of routers": {"steps": ["middleware", s118], "of": {"DDS": null, "Zenoh": {"efforts": s111, "effort": 8, "takes": s112, "best_case": false, "cost": "all hosts must change together; every robot needs the wired router's address; robots do not hear each other while the wired router is down"}, "None": null}},
"middleware and star of routers and staggered start": {
"steps": ["middleware", s118, s76],
"of": {
"DDS": null,
"Zenoh": {"efforts": s113, "effort": 8, "takes": s114, "best_case": false, "cost": "all hosts must change together; every robot needs the wired router's address; discovery cannot be complete before the last host starts; robots do not hear each other while the wired router is down"},
"None": null,
},
},
"middleware and static endpoints": {
"steps": ["middleware", s119],
"of": {"DDS": {"efforts": ["switch", "build"], "effort": 8, "takes": "another middleware and rebuilt nodes", "best_case": false, "cost": "all hosts must change together; every endpoint, ROS 2's own included, must be listed in every file; Fast DDS 2.9.1 can crash"}, "Zenoh": null, "None": null},
},
"middleware and static endpoints and staggered start": {
"steps": ["middleware", s119, s76],
"of": {
"DDS": {
"efforts": ["switch", "build", "setting"],
"effort": 8,
"takes": "another middleware, rebuilt nodes and a setting",
"best_case": false,
"cost": "all hosts must change together; every endpoint, ROS 2's own included, must be listed in every file; Fast DDS 2.9.1 can crash; discovery cannot be complete before the last host starts",
},
"Zenoh": null,
"None": null,
},
},
"middleware and two discovery servers": {
"steps": ["middleware", s120],
"of": {"DDS": {"efforts": s111, "effort": 8, "takes": s112, "best_case": false, "cost": "all hosts must change together; each robot needs both addresses; ros2 tools must be super clients; late joiners stay undiscovered while both servers are down"}, "Zenoh": null, "None": null},
},
"middleware and two discovery servers and staggered start": {
"steps": ["middleware", s120, s76],
"of": {
"DDS": {"efforts": s113, "effort": 8, "takes": s114, "best_case": false, "cost": "all hosts must change together; each robot needs both addresses; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while both servers are down"},
"Zenoh": null,
"None": null,
},
},
"multicast endpoint data": {"steps": [s105], "of": {"DDS": {"efforts": ["file"], "effort": 2, "takes": s88, "best_case": false, "cost": "multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later"}, "Zenoh": null, "None": null}},
"multicast endpoint data and staggered start": {"steps": [s105, s76], "of": {"DDS": {"efforts": s89, "effort": 2, "takes": s90, "best_case": false, "cost": "multicast uses the basic rate and has no acknowledgments, so lost announcements are requested later; discovery cannot be complete before the last host starts"}, "Zenoh": null, "None": null}},
"multicast rate": {"steps": [s13], "of": {"DDS": s121, "Zenoh": s121, "None": s121}},
"multicast rate and staggered start": {"steps": [s13, s76], "of": {"DDS": s122, "Zenoh": s122, "None": s122}},
"peers": {
"steps": ["peers"],
"of": {
"DDS": {"efforts": ["file"], "effort": 2, "takes": s88, "best_case": false, "cost": "you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS)"},
"Zenoh": {"efforts": ["file"], "effort": 2, "takes": s88, "best_case": false, "cost": "you must know the addresses beforehand; a process that dials a peer too early may keep dialing every 4 s"},
"None": null,
},
},
"peers and staggered start": {
"steps": ["peers", s76],
"of": {
"DDS": {"efforts": s89, "effort": 2, "takes": s90, "best_case": false, "cost": "you must know the addresses beforehand; every announcement goes to 9 ports of every address (32 with ROS_STATIC_PEERS); discovery cannot be complete before the last host starts"},
"Zenoh": {"efforts": s89, "effort": 2, "takes": s90, "best_case": false, "cost": "you must know the addresses beforehand; a process that dials a peer too early may keep dialing every 4 s; discovery cannot be complete before the last host starts"},
"None": null,
},
},
"processes": {"steps": ["processes"], "of": {"DDS": s123, "Zenoh": s123, "None": s123}},
"processes and staggered start": {"steps": ["processes", s76], "of": {"DDS": s124, "Zenoh": s124, "None": s124}},
"radio": {"steps": ["radio"], "of": {"DDS": s125, "Zenoh": s125, "None": s125}},
"radio and staggered start": {"steps": ["radio", s76], "of": {"DDS": s126, "Zenoh": s126, "None": s126}},
"release": {"steps": ["release"], "of": {"DDS": s127, "Zenoh": s127, "None": s127}},
"release and staggered start": {"steps": ["release", s76], "of": {"DDS": s128, "Zenoh": s128, "None": s128}},
"router": {"steps": ["router"], "of": {"DDS": null, "Zenoh": {"efforts": ["server"], "effort": 3, "takes": s91, "best_case": false, "cost": "robots need the router's address; all data pass through it; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)"}, "None": null}},
"router and staggered start": {
"steps": ["router", s76],
"of": {
"DDS": null,
"Zenoh": {"efforts": s92, "effort": 3, "takes": s93, "best_case": false, "cost": "robots need the router's address; all data pass through it; discovery cannot be complete before the last host starts; if the router fails, robots hear nothing until 2.2 s after the router is back (10 s lease)"},
"None": null,
},
},
"router on each host": {"steps": [s110], "of": {"DDS": null, "Zenoh": {"efforts": ["servers"], "effort": 4, "takes": s129, "best_case": false, "cost": "every router needs the addresses of all other routers; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back"}, "None": null}},
"router on each host and staggered start": {
"steps": [s110, s76],
"of": {
"DDS": null,
"Zenoh": {"efforts": s130, "effort": 4, "takes": s131, "best_case": false, "cost": "every router needs the addresses of all other routers; discovery cannot be complete before the last host starts; if a robot's router fails, the robot hears no other robot until 4.2 s after the router is back"},
"None": null,
},
},
"staggered start": {"steps": [s76], "of": {"DDS": s132, "Zenoh": s132, "None": s132}},
"star of routers": {"steps": [s118], "of": {"DDS": null, "Zenoh": {"efforts": ["servers"], "effort": 4, "takes": s129, "best_case": false, "cost": "every robot needs the wired router's address; robots do not hear each other while the wired router is down"}, "None": null}},
"star of routers and staggered start": {
"steps": [s118, s76],
"of": {"DDS": null, "Zenoh": {"efforts": s130, "effort": 4, "takes": s131, "best_case": false, "cost": "every robot needs the wired router's address; discovery cannot be complete before the last host starts; robots do not hear each other while the wired router is down"}, "None": null},
},
"static endpoints": {"steps": [s119], "of": {"DDS": {"efforts": ["build"], "effort": 5, "takes": "rebuilt nodes", "best_case": false, "cost": "every endpoint, ROS 2's own included, must be listed in every file; Fast DDS 2.9.1 can crash"}, "Zenoh": null, "None": null}},
"static endpoints and staggered start": {"steps": [s119, s76], "of": {"DDS": {"efforts": s96, "effort": 5, "takes": s97, "best_case": false, "cost": "every endpoint, ROS 2's own included, must be listed in every file; Fast DDS 2.9.1 can crash; discovery cannot be complete before the last host starts"}, "Zenoh": null, "None": null}},
"two discovery servers": {"steps": [s120], "of": {"DDS": {"efforts": ["servers"], "effort": 4, "takes": s129, "best_case": false, "cost": "each robot needs both addresses; ros2 tools must be super clients; late joiners stay undiscovered while both servers are down"}, "Zenoh": null, "None": null}},
"two discovery servers and staggered start": {
"steps": [s120, s76],
"of": {"DDS": {"efforts": s130, "effort": 4, "takes": s131, "best_case": false, "cost": "each robot needs both addresses; ros2 tools must be super clients; discovery cannot be complete before the last host starts; late joiners stay undiscovered while both servers are down"}, "Zenoh": null, "None": null},
},
},
"pastes": {
"aggregation": {
"any": [
{
"where": s133,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Keep your band, channel and width. With 802.11ac and ax, vht_capab lets 64 frames of any length\n# share an exchange. With 802.11n only, leave out the last two lines.\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[SHORT-GI-20]\nieee80211ac=1\nvht_capab=[MAX-A-MPDU-LEN-EXP7]\n",
},
],
},
"announcements": {
"Fast DDS": [
{
"where": s134,
"version": s135,
"text": "<!-- for every process (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"calm\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <initialAnnouncements>\n              <count>1</count>\n              <period>\n                <sec>1</sec>\n              </period>\n            </initialAnnouncements>\n            <leaseAnnouncement>\n              <sec>15</sec>\n            </leaseAnnouncement>\n            <leaseDuration>\n              <sec>100</sec>\n            </leaseDuration>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
],
"Cyclone DDS": [
{
"where": s134,
"version": s136,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <Discovery>\n      <LeaseDuration>100 s</LeaseDuration>\n      <SPDPInterval>30 s</SPDPInterval>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"discovery server": {
"any": [
{
"where": s137,
"version": s135,
"text": "# on a computer that is wired to the access point (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Use the address of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n",
},
s139,
{
"where": "for the server if it is a program of your own",
"version": s135,
"text": "<!-- for the server if it is a program of your own (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; the server's process runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE) -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"server\" is_default_profile=\"true\">\n      <rtps>\n        <prefix>44.53.00.5f.45.50.52.4f.53.49.4d.41</prefix>\n        <builtin>\n          <discovery_config>\n            <discoveryProtocol>SERVER</discoveryProtocol>\n          </discovery_config>\n          <metatrafficUnicastLocatorList>\n            <locator>\n              <udpv4>\n                <address>192.168.1.10</address>\n                <port>11811</port>\n              </udpv4>\n            </locator>\n          </metatrafficUnicastLocatorList>\n        </builtin>\n      </rtps>\n    </participant>\n  </profiles>\n</dds>\n",
},
s140,
s141,
],
},
"discovery server on a robot": {
"any": [
{
"where": "on one of the robots",
"version": s135,
"text": "# on one of the robots (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Use the address of this computer.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\n",
},
s139,
s140,
s141,
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
"where": s142,
"version": "ROS 2 Jazzy",
"text": "# on every computer (ROS 2 Jazzy)\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_fastrtps_cpp\n",
},
],
"Cyclone DDS": [
{
"where": s142,
"version": "ROS 2 Jazzy",
"text": "# on every computer (ROS 2 Jazzy)\n# Load: RMW_IMPLEMENTATION is an environment variable of every ROS 2 process: run in the\n# shell or put in the service file that starts the ROS 2 processes, before they start\n# Not run here: compared with its documentation\nexport RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n",
},
],
"Zenoh": [
{
"where": s142,
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
"where": s134,
"version": s136,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <!-- By default, Cyclone DDS multicasts only its announcements on Wi-Fi. -->\n      <AllowMulticast>true</AllowMulticast>\n    </General>\n  </Domain>\n</CycloneDDS>\n",
},
],
},
"multicast rate": {
"any": [
{
"where": s133,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Multicast and management frames are sent at the lowest basic rate, here 24 Mbit/s (in units of\n# 100 kbit/s). Old rates below it are switched off, but not those of 802.11n and later. A station\n# that is too far away for 24 Mbit/s cannot join.\n# Keep your band and channel.\nhw_mode=a\nchannel=36\nsupported_rates=240 360 480 540\nbasic_rates=240\n",
},
],
},
"peers": {
"Cyclone DDS": [
{
"where": s134,
"version": s136,
"text": "<!-- for every process (tested with Cyclone DDS 0.10.2 and 11.0.1) -->\n<!-- Load: save as /etc/cyclonedds.xml; every process runs with -->\n<!-- CYCLONEDDS_URI=file:///etc/cyclonedds.xml -->\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n  <Domain Id=\"any\">\n    <General>\n      <AllowMulticast>false</AllowMulticast>\n    </General>\n    <Discovery>\n      <!-- Allow at least as many indices as a host has processes. -->\n      <ParticipantIndex>auto</ParticipantIndex>\n      <MaxAutoParticipantIndex>9</MaxAutoParticipantIndex>\n      <!-- Every host, this one included. -->\n      <Peers>\n        <Peer Address=\"192.168.1.21\"/>\n        <Peer Address=\"192.168.1.22\"/>\n        <Peer Address=\"192.168.1.23\"/>\n      </Peers>\n    </Discovery>\n  </Domain>\n</CycloneDDS>\n",
},
],
"DDS": [
{
"where": s138,
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
{
"where": "where Nav2 is started",
"version": "ROS 2 Humble",
"text": "# where Nav2 is started (ROS 2 Humble)\n# Load: run in a shell; the process is ros2 launch\n# Not run here: compared with its documentation\n# Nav2 makes a container of its own, nav2_container. Load your other nodes into it, too:\n# nodes outside of it stay processes of their own.\nros2 launch nav2_bringup bringup_launch.py use_composition:=True\n",
},
{
"where": "a launch file for nodes of your own that are built as components",
"version": "ROS 2 Humble",
"text": "# a launch file for nodes of your own that are built as components (ROS 2 Humble)\n# Load: save as robot.launch.py; the process is ros2 launch robot.launch.py\n# Not run here: compared with its documentation\nfrom launch import LaunchDescription\nfrom launch_ros.actions import ComposableNodeContainer\nfrom launch_ros.descriptions import ComposableNode\n\n\ndef generate_launch_description():\n    nodes = [\n        ComposableNode(package=\"composition\", plugin=\"composition::Talker\", name=\"talker\"),\n        ComposableNode(package=\"composition\", plugin=\"composition::Listener\", name=\"listener\"),\n    ]\n    # With Nav2, load these nodes into its container, so that all share one process: let container be\n    # LoadComposableNodes(target_container=\"nav2_container\", composable_node_descriptions=nodes),\n    # from launch_ros.actions.\n    container = ComposableNodeContainer(\n        name=\"robot\",\n        namespace=\"\",\n        package=\"rclcpp_components\",\n        executable=\"component_container\",\n        composable_node_descriptions=nodes,\n    )\n    return LaunchDescription([container])\n",
},
],
},
"radio": {
"802.11n 40 MHz": [
{
"where": s133,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\n",
},
],
"802.11ac 80 MHz": [
{
"where": s133,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=1\nvht_oper_centr_freq_seg0_idx=42\nvht_capab=[SHORT-GI-80][MAX-A-MPDU-LEN-EXP7]\n",
},
],
"802.11ax 160 MHz": [
{
"where": s133,
"version": "hostapd 2.10",
"text": "# hostapd.conf of the access point (tested with hostapd 2.10)\n# Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd\n# reads it when it starts\n# Radars share channels 52 to 64, so hostapd needs your country's code.\ncountry_code=US\nieee80211d=1\nieee80211h=1\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+][SHORT-GI-20][SHORT-GI-40]\nieee80211ac=1\nvht_oper_chwidth=2\nvht_oper_centr_freq_seg0_idx=50\nvht_capab=[VHT160][SHORT-GI-80][SHORT-GI-160][MAX-A-MPDU-LEN-EXP7]\nieee80211ax=1\nhe_oper_chwidth=2\nhe_oper_centr_freq_seg0_idx=50\n",
},
],
},
"release": {},
"router": {
"any": [
s143,
{
"where": s134,
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
s144,
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
s143,
{
"where": "on every robot for its router, which connects only to the wired one",
"version": "Zenoh 1.10.2",
"text": "// on every robot for its router, which connects only to the wired one (tested with Zenoh 1.10.2)\n// Load: save as /etc/zenoh_router.json5; the router runs with\n// ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5 (ros2 run rmw_zenoh_cpp rmw_zenohd)\n{\n  mode: \"router\",\n  listen: { endpoints: [\"tcp/0.0.0.0:7447\"] },\n  // Only the router that is wired to the access point, and no robot.\n  connect: { endpoints: [\"tcp/192.168.1.10:7447\"] },\n  scouting: {\n    multicast: { enabled: false },\n    gossip: { target: { router: [\"router\", \"peer\"], peer: [\"router\"] } },\n  },\n  routing: { router: { peers_failover_brokering: false } },\n  // These settings repeat those of rmw_zenoh's own file, which this file replaces.\n  timestamping: { enabled: true },\n  queries_default_timeout: 600000,\n  transport: {\n    unicast: {\n      open_timeout: 60000,\n      accept_timeout: 60000,\n      accept_pending: 10000,\n      max_sessions: 10000,\n    },\n    link: {\n      tx: {\n        lease: 60000, // a KeepAlive every 30 s\n        keep_alive: 2,\n        queue: { congestion_control: { block: { wait_before_close: 60000000 } } },\n      },\n    },\n    shared_memory: { enabled: false },\n  },\n}\n",
},
s144,
],
},
"static endpoints": {
"any": [
{
"where": s134,
"version": s135,
"text": "<!-- for every process (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds.xml; every process that should read it runs with -->\n<!-- FASTRTPS_DEFAULT_PROFILES_FILE=/etc/fast_dds.xml (from Fast DDS 3.0 on, so in ROS 2 -->\n<!-- Kilted: FASTDDS_DEFAULT_PROFILES_FILE); in ROS 2 it matches nothing without -->\n<!-- RMW_FASTRTPS_USE_QOS_FROM_XML=1 -->\n<dds xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n  <profiles>\n    <participant profile_name=\"robot\" is_default_profile=\"true\">\n      <rtps>\n        <builtin>\n          <discovery_config>\n            <EDP>STATIC</EDP>\n            <static_edp_xml_config>file:///etc/fast_dds_static_endpoints.xml</static_edp_xml_config>\n          </discovery_config>\n        </builtin>\n      </rtps>\n    </participant>\n    <!-- One for each endpoint of this process, by the name of its topic. -->\n    <data_writer profile_name=\"/robot1/odom\">\n      <userDefinedID>1</userDefinedID>\n    </data_writer>\n  </profiles>\n</dds>\n",
},
{
"where": s138,
"version": "Fast DDS 2.9, 2.14 and 3.6",
"text": "<!-- on every robot (tested with Fast DDS 2.9, 2.14 and 3.6) -->\n<!-- Load: save as /etc/fast_dds_static_endpoints.xml, where the profile for every process -->\n<!-- looks for it; no environment variable of its own -->\n<staticdiscovery>\n  <!-- Every process, by the name of its participant (in ROS 2 its enclave), with all its\n       endpoints. Every endpoint has a number of its own. -->\n  <participant>\n    <name>/robot1</name>\n    <writer>\n      <userId>1</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </writer>\n  </participant>\n  <participant>\n    <name>/laptop</name>\n    <reader>\n      <userId>2</userId>\n      <topicName>rt/robot1/odom</topicName>\n      <topicDataType>nav_msgs::msg::dds_::Odometry_</topicDataType>\n      <topicKind>NO_KEY</topicKind>\n      <reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>\n      <durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos>\n    </reader>\n  </participant>\n</staticdiscovery>\n",
},
],
},
"two discovery servers": {
"any": [
{
"where": "on two computers that are wired to the access point",
"version": s135,
"text": "# on two computers that are wired to the access point (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: run in a shell, or as the command of a service; the process is fastdds discovery\n# Run the first line on one computer, the second on the other, each with its own address.\nfastdds discovery -i 0 -l 192.168.1.10 -p 11811\nfastdds discovery -i 1 -l 192.168.1.11 -p 11811\n",
},
{
"where": "on every robot (servers in this order)",
"version": s135,
"text": "# on every robot (servers in this order) (tested with Fast DDS 2.6, 2.9, 2.14 and 3.6)\n# Load: ROS_DISCOVERY_SERVER is an environment variable of every process with Fast DDS: run\n# in the shell or put in the service file that starts the ROS 2 processes, before they start\nexport ROS_DISCOVERY_SERVER=\"192.168.1.10:11811;192.168.1.11:11811\"\n",
},
s140,
s141,
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
"group": s5,
"family": "DDS",
"product": null,
"tables": {"any": [s148, s151, s154, s155, s158, s161, ["middleware", "switching to Zenoh", "", "Zenoh", "DDS", "middleware"]]},
"about": "",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": "--ds-family-dds",
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s166,
"windows": s167,
"units": [s169, s171, s173],
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s174], ["SEDP", "unicast", 464, 1, 1, 1, "up down", s174], ["Heartbeat", "unicast", 116, 1, 2, 2, "up down", s174], ["ACKNACK", "unicast", 114, 1, 2, 2, "up down", s174]],
},
"Zenoh": {
"group": s5,
"family": "Zenoh",
"product": null,
"tables": {"any": [s178, s181, s184, ["peers", "static peers", "", "Zenoh, static peers", "Zenoh", "peers"], ["middleware", "switching to DDS", "", "DDS", "Zenoh", "middleware"]]},
"about": "",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s185,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s166,
"windows": s167,
"units": s186,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s174], ["Hello", "unicast", 144, 1, 1, 1, "up down", s174], ["Declare", "unicast", 176, 1, 2, 1, "up down", s174], s187],
},
"Cyclone DDS": {
"group": s3,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [[s77, s188, "", s189, "Cyclone DDS", s190], [s120, s191, "", s192, "Cyclone DDS", s193], s194, s197, s198, s199, s202, s205, s208, s210, s212, ["middleware", "switching to Fast DDS 2.14", "", "Fast DDS 2.14", "Cyclone DDS", "middleware"], s214],
"humble": [[s77, s188, "", s215, "Cyclone DDS", s190], [s120, s191, "", s216, "Cyclone DDS", s193], s194, s197, s198, s199, s202, s205, s208, s210, s212, ["middleware", "switching to Fast DDS 2.6", "", "Fast DDS 2.6", "Cyclone DDS", "middleware"], s214],
"kilted": [[s77, s188, "", s217, "Cyclone DDS", s190], [s120, s191, "", s218, "Cyclone DDS", s193], s194, s197, s198, s199, s202, s205, s208, s210, s212, ["middleware", s219, "", "Fast DDS 3.6", "Cyclone DDS", "middleware"], s214],
},
"about": s220,
"caution": s221,
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 60],
"band": s224,
"reboot": [1.45, 3.59],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s233,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s234],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s235],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s236],
["SEDP", "unicast", s237, 0.2218, 2, 1, "up down", s238],
["SEDP again", "unicast", s237, 0.2218, 3, 0.103, "up down", s238],
["Heartbeat", "unicast", s239, 0.5226, 1, 2, "up down", s238],
[s240, "unicast", s239, 0.5226, 1, 2.481, "up down", s238],
["ACKNACK", "unicast", s241, 0.402, 1, 4.635, "up down", s238],
[s242, "unicast", s241, 0.402, 4, 0.09896, "up down", s238],
s245,
[s246, "unicast", s247, 0.6253, 1, 1, "up down", s238],
[s248, "unicast", s247, 0.6253, 4, 0.1067, "up down", s238],
s251,
[s252, "unicast", s253, 0.4544, 1, 2.222, "up down", s238],
s255,
[s256, "unicast", s257, 0.3044, 1, 2.312, "up down", s238],
[s258, "unicast", s257, 0.3044, 4, 0.05208, "up down", s238],
[s259, "unicast", s260, 0.6806, 1, 2.333, "up down", s238],
[s261, "unicast", s262, 0.2641, 1, 2, "up down", s238],
[s263, "unicast", s262, 0.2641, 4, 0.2188, "up down", s238],
[s264, "unicast", s265, 0.6247, 5, 1.006, "up down", s238],
[s266, "unicast", s265, 0.6247, 6, 0.07217, "up down", s238],
["User ACKNACK", "unicast", s267, 0.338, 5, 1.404, "up down", s238],
[s268, "unicast", s267, 0.338, 6, 0.09793, "up down", s238],
],
},
"Cyclone DDS, wired": {
"group": s3,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s77, s188, s269, "Cyclone DDS, wired, switching to Fast DDS with a Discovery Server", s270, s190],
[s120, s191, s269, "Cyclone DDS, wired, switching to Fast DDS with two Discovery Servers", s270, s193],
[s119, s195, "", s119, s270, s196],
s158,
s161,
["router", s200, "", "Zenoh router", s270, s201],
[s110, s203, "", s180, s270, s204],
[s118, s206, "", s183, s270, s207],
["announcements", s209, "", "Cyclone DDS, wired, a longer announcement interval", s270, "announcements"],
["release", s271, "", "Cyclone DDS", s270, "release"],
["release", s211, "", s2, s270, "release"],
["middleware", s219, "", "Fast DDS 3.6", s270, "middleware"],
["middleware", s213, "", s177, s270, "middleware"],
],
},
"about": s272,
"caution": "Cyclone DDS in this form was not measured in an emulated Wi-Fi cell, where its form for Wi-Fi took up to 6.8 times as long as simulated",
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 20],
"band": s273,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s274,
"degree": 3,
"messages": [
s275,
["SPDP directed", "unicast", s276, 0.9963, 1, 0.6667, "up down", s236],
["SEDP", "unicast", s277, 0.1841, 2, 0.5833, "up down", s238],
[s278, "multicast", s279, 0.2228, 2, 0.1667, "up down", s238],
[s280, "multicast", 232, 0.25, 0, 2, "up down", s238],
["Heartbeat", "unicast", s281, 0.3287, 1, 3, "up down", s238],
["ACKNACK", "unicast", s282, 0.3715, 1, 4.05, "up down", s238],
[s242, "unicast", s282, 0.3715, 3, 0.2833, "up down", s238],
["Liveliness", "multicast", s243, 0.7242, 0, 1, "up down", s244],
[s246, "multicast", s283, 0.9582, 0, 0.3333, "up down", s238],
[s284, "unicast", 429, 0.2, 1, 0.5, "up down", s238],
[s249, "multicast", s250, 0.2758, 0, 1, "up down", s244],
[s252, "multicast", s285, 0.1767, 0, 0.875, "up down", s238],
[s286, "unicast", s287, 0.2117, 1, 1.625, "up down", s238],
s255,
[s256, "unicast", s288, 0.2807, 1, 2.344, "up down", s238],
[s258, "unicast", s288, 0.2807, 3, 0.07812, "up down", s238],
[s259, "multicast", s289, 0.1988, 0, 2, "up down", s238],
[s290, "unicast", s291, 0.1917, 1, 0.6667, "up down", s238],
[s261, "unicast", 211.5, 0.2, 1, 2, "up down", s238],
[s263, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s238],
[s264, "unicast", s292, 0.2427, 4, 0.75, "up down", s238],
[s293, "multicast", s294, 0.2152, 4, 0.25, "up down", s238],
["User ACKNACK", "unicast", s295, 0.2283, 4, 2, "up down", s238],
],
},
"Cyclone DDS, version 11": {
"group": s3,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s77, s188, s269, "Cyclone DDS, version 11, switching to Fast DDS with a Discovery Server", s2, s190],
[s120, s191, s269, "Cyclone DDS, version 11, switching to Fast DDS with two Discovery Servers", s2, s193],
[s119, s195, "", s119, s2, s196],
s158,
s161,
["router", s200, "", "Zenoh router", s2, s201],
[s110, s203, "", s180, s2, s204],
[s118, s206, "", s183, s2, s207],
["announcements", s209, "", "Cyclone DDS, version 11, a longer announcement interval", s2, "announcements"],
["release", s271, "", "Cyclone DDS", s2, "release"],
["middleware", s219, "", "Fast DDS 3.6", s2, "middleware"],
["middleware", s213, "", s177, s2, "middleware"],
],
},
"about": s296,
"caution": "Cyclone DDS 11 was not measured in an emulated Wi-Fi cell, where Cyclone DDS 0.10.5 took up to 6.8 times as long as simulated",
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 60],
"band": s297,
"reboot": [1.31, 3.21],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s233,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s234],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s235],
["SPDP directed", "unicast", s298, 0.9992, 1, 0.5413, "up down", s236],
["SEDP", "unicast", s299, 0.4598, 2, 1, "up down", s238],
["SEDP again", "unicast", s299, 0.4598, 3, 0.09093, "up down", s238],
["Heartbeat", "unicast", s300, 0.5475, 1, 2, "up down", s238],
[s240, "unicast", s300, 0.5475, 1, 2.833, "up down", s238],
["ACKNACK", "unicast", s301, 0.3982, 1, 5.167, "up down", s238],
[s242, "unicast", s301, 0.3982, 4, 0.125, "up down", s238],
s245,
[s246, "unicast", s302, 0.6519, 1, 1, "up down", s238],
[s248, "unicast", s302, 0.6519, 4, 0.09103, "up down", s238],
s251,
[s252, "unicast", s303, 0.4401, 1, 2.188, "up down", s238],
s255,
[s256, "unicast", s304, 0.2753, 1, 2.278, "up down", s238],
[s258, "unicast", s304, 0.2753, 4, 0.05556, "up down", s238],
[s259, "unicast", s305, 0.6399, 1, 2.542, "up down", s238],
[s261, "unicast", s306, 0.2385, 1, 2, "up down", s238],
[s263, "unicast", s306, 0.2385, 4, 0.1997, "up down", s238],
[s264, "unicast", s307, 0.6975, 5, 1.06, "up down", s238],
[s266, "unicast", s307, 0.6975, 6, 0.06995, "up down", s238],
["User ACKNACK", "unicast", s308, 0.4362, 5, 1.562, "up down", s238],
[s268, "unicast", s308, 0.4362, 6, 0.09399, "up down", s238],
],
},
"Cyclone DDS peers": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s77, s188, s269, "Cyclone DDS peers, switching to Fast DDS with a Discovery Server", s157, s190],
[s120, s191, s269, "Cyclone DDS peers, switching to Fast DDS with two Discovery Servers", s157, s193],
[s119, s195, "", s119, s157, s196],
[s105, s159, "", s160, s157, s105],
["router", s200, "", "Zenoh router", s157, s201],
[s110, s203, "", s180, s157, s204],
[s118, s206, "", s183, s157, s207],
["announcements", s209, "", "Cyclone DDS peers, a longer announcement interval", s157, "announcements"],
["middleware", s309, "", s2, s157, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s157, "middleware"],
["middleware", s213, "", s177, s157, "middleware"],
],
},
"about": s310,
"caution": s221,
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 10],
"band": s311,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s316,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s234],
[s317, "unicast", 448, 1, 1, 6, "up down", s318],
["SPDP directed", "unicast", s319, 0.9817, 2, 0.8333, "up down", s236],
["SEDP", "unicast", s320, 0.172, 3, 1, "up down", s238],
["SEDP again", "unicast", s321, 0.8001, 4, 0.08633, "up down", s238],
["Heartbeat", "unicast", s322, 0.5756, 2, 2, "up down", s238],
[s240, "unicast", s322, 0.5756, 2, 2.944, "up down", s238],
["ACKNACK", "unicast", s323, 0.3827, 2, 4.424, "up down", s238],
[s242, "unicast", s323, 0.3827, 5, 0.2049, "up down", s238],
["Liveliness", "unicast", s324, 0.7241, 2, 1, "up down", s244],
[s246, "unicast", s325, 0.7527, 2, 1, "up down", s238],
[s248, "unicast", s325, 0.7527, 5, 0.08333, "up down", s238],
[s249, "unicast", s326, 0.2759, 2, 1, "up down", s244],
[s252, "unicast", s327, 0.4258, 2, 2.556, "up down", s238],
[s254, "unicast", 128, 1, 2, 1, "up down", s244],
[s256, "unicast", s328, 0.265, 2, 2.296, "up down", s238],
[s258, "unicast", s328, 0.265, 5, 0.09271, "up down", s238],
[s259, "unicast", s329, 0.6431, 2, 3, "up down", s238],
[s261, "unicast", s330, 0.283, 2, 2, "up down", s238],
[s263, "unicast", s330, 0.283, 5, 0.3631, "up down", s238],
[s264, "unicast", s331, 0.5405, 6, 1.542, "up down", s238],
["User ACKNACK", "unicast", s332, 0.437, 6, 2.208, "up down", s238],
],
},
"Cyclone DDS multicast SEDP": {
"group": s4,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {
"any": [
[s77, s188, s269, "Cyclone DDS multicast SEDP, switching to Fast DDS with a Discovery Server", s160, s190],
[s120, s191, s269, "Cyclone DDS multicast SEDP, switching to Fast DDS with two Discovery Servers", s160, s193],
[s119, s195, "", s119, s160, s196],
["peers", "static peers", "", s157, s160, "peers"],
["router", s200, "", "Zenoh router", s160, s201],
[s110, s203, "", s180, s160, s204],
[s118, s206, "", s183, s160, s207],
["announcements", s209, "", "Cyclone DDS multicast SEDP, a longer announcement interval", s160, "announcements"],
["middleware", s309, "", s2, s160, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s160, "middleware"],
["middleware", s213, "", s177, s160, "middleware"],
],
},
"about": s333,
"caution": s221,
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 10],
"band": s334,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s274,
"degree": 3,
"messages": [
s275,
["SPDP directed", "unicast", s335, 0.9988, 1, 0.8, "up down", s236],
["SEDP", "unicast", s336, 0.2085, 2, 0.3719, "up down", s238],
[s278, "multicast", s337, 0.2222, 2, 0.23, "up down", s238],
[s280, "multicast", s338, 0.28, 0, 1.833, "up down", s238],
["Heartbeat", "unicast", s339, 0.3143, 1, 3.333, "up down", s238],
["ACKNACK", "unicast", s340, 0.3558, 1, 4.517, "up down", s238],
[s242, "unicast", s340, 0.3558, 3, 0.1494, "up down", s238],
["Liveliness", "multicast", s341, 0.724, 0, 1, "up down", s244],
[s246, "multicast", s342, 0.9539, 0, 0.8333, "up down", s238],
[s284, "unicast", s343, 0.15, 1, 0.5, "up down", s238],
[s249, "multicast", s344, 0.276, 0, 1, "up down", s244],
[s252, "multicast", s345, 0.2328, 0, 1, "up down", s238],
[s286, "unicast", s346, 0.2318, 1, 1.75, "up down", s238],
s255,
[s256, "unicast", s347, 0.2856, 1, 2.379, "up down", s238],
[s258, "unicast", s347, 0.2856, 3, 0.08854, "up down", s238],
[s259, "multicast", s348, 0.2325, 0, 2, "up down", s238],
[s290, "unicast", s349, 0.1726, 1, 1.167, "up down", s238],
[s261, "unicast", s350, 0.2088, 1, 2, "up down", s238],
[s263, "unicast", s350, 0.2088, 3, 0.3274, "up down", s238],
[s264, "unicast", s351, 0.4167, 4, 0.7917, "up down", s238],
[s293, "multicast", s352, 0.6667, 4, 0.1667, "up down", s238],
["User ACKNACK", "unicast", s353, 0.4167, 4, 2.167, "up down", s238],
],
},
"Fast DDS Discovery Server": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s120, s149, "", s150, s147, s120],
[s94, s152, "", s153, s147, s94],
[s119, s119, "", s119, s147, s119],
["peers", s354, "", s157, s147, s355],
[s105, s356, "", s160, s147, s357],
["router", s200, "", "Zenoh router", s147, s201],
[s110, s203, "", s180, s147, s204],
[s118, s206, "", s183, s147, s207],
["middleware", s309, "", s2, s147, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s147, "middleware"],
["middleware", s213, "", s177, s147, "middleware"],
],
},
"about": s358,
"caution": "",
"ratios": s359,
"server_ratios": s162,
"has_server": true,
"color": s360,
"measured": [8, 8, 10],
"band": s361,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s370,
"degree": 2,
"messages": s406,
},
"Fast DDS Discovery Server, two": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s77, s145, "", s147, s150, s77],
[s94, s152, "", s153, s150, s94],
[s119, s119, "", s119, s150, s119],
["peers", s354, "", s157, s150, s355],
[s105, s356, "", s160, s150, s357],
["router", s200, "", "Zenoh router", s150, s201],
[s110, s203, "", s180, s150, s204],
[s118, s206, "", s183, s150, s207],
["middleware", s309, "", s2, s150, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s150, "middleware"],
["middleware", s213, "", s177, s150, "middleware"],
],
},
"about": s407,
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": true,
"color": s360,
"measured": [8, 8, 10],
"band": s409,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s370,
"degree": 2,
"messages": s410,
},
"Fast DDS Discovery Server, on a robot": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s77, s145, "", s147, s153, s77],
[s120, s149, "", s150, s153, s120],
[s119, s119, "", s119, s153, s119],
["peers", s354, "", s157, s153, s355],
[s105, s356, "", s160, s153, s357],
["router", s200, "", "Zenoh router", s153, s201],
[s110, s203, "", s180, s153, s204],
[s118, s206, "", s183, s153, s207],
["middleware", s309, "", s2, s153, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s153, "middleware"],
["middleware", s213, "", s177, s153, "middleware"],
],
},
"about": "one server, on a robot with processes of its own; as the table of a wired one, on other hops (measured with 2.9.1)",
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": false,
"color": s360,
"measured": [8, 8, 10],
"band": [[1, 1, 1, "In 6 swarms within these sizes, left out of the fit, discovery took 0.97 to 1.16 times the predicted airtime (typical error 3%). We expect 71% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": [[s411, s411, s411], [s231, s412, s412], [s413, s413, s413], [s231, {"count": "count21", "more": ["more52", "more53", "more43"]}, {"count": "count22", "more": ["more54", "more55", "more5"]}], s369, s232],
"degree": 2,
"messages": [
[s371, "unicast", 652, 1, 0, 1, "up down", s373],
[s374, "unicast", 700, 1, 0, 1, "up down", s375],
[s376, "unicast", s377, 0.865, 0, 1, "up down", s378],
[s379, "unicast", s380, 0.8517, 1, 1.967, "up down", s378],
[s381, "unicast", 192, 1, 0, 2, "up down", s378],
[s382, "unicast", s383, 0.5969, 0, 2.167, "up down", s378],
[s384, "unicast", s385, 0.3182, 1, 2.908, "up down", s378],
["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up down", s378],
[s386, "unicast", 190.2, 1, 1, 0.5083, "up down", s378],
[s387, "unicast", 188, 1, 0, 2, "up down", s378],
["SPDP Gap", "unicast", s388, 0.6193, 1, 1.6, "up down", s378],
[s389, "unicast", 1152, 0.45, 2, 1, "up down", s378],
[s390, "unicast", s391, 0.8446, 3, 1.237, "up down", s378],
["Heartbeat", "unicast", 192, 1, 0, 4, "up down", s378],
[s392, "unicast", 192, 1, 0, 4, "up down", s378],
[s393, "unicast", s394, 0.2358, 3, 1.892, "up down", s378],
["ACKNACK", "unicast", 188, 1, 0, 4, "up down", s378],
[s395, "unicast", 191.3, 1, 3, 0.45, "up down", s378],
[s396, "unicast", 188.5, 1, 0, 15.6, "up down", s378],
["Gap", "unicast", s397, 0.6838, 3, 0.645, "up down", s378],
[s398, "unicast", 192, 1, 0, 1, "up down", s378],
[s399, "unicast", 192, 1, 0, 2, "up down", s378],
s400,
[s401, "unicast", 188, 1, 0, 2, "up down", s378],
[s402, "unicast", 188, 1, 0, 2, "up down", s378],
s403,
s404,
s405,
],
},
"Fast DDS": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s77, s145, "", s147, "Fast DDS", s77],
[s120, s149, "", s150, "Fast DDS", s120],
[s94, s152, "", s153, "Fast DDS", s94],
[s119, s119, "", s119, "Fast DDS", s119],
["peers", s354, "", s157, "Fast DDS", s355],
[s105, s356, "", s160, "Fast DDS", s357],
["router", s200, "", "Zenoh router", "Fast DDS", s201],
[s110, s203, "", s180, "Fast DDS", s204],
[s118, s206, "", s183, "Fast DDS", s207],
["announcements", s209, "", "Fast DDS, a longer announcement interval", "Fast DDS", "announcements"],
["release", s414, "", "Fast DDS 3.6", "Fast DDS", "release"],
["release", s415, "", "Fast DDS 2.6", "Fast DDS", "release"],
["release", s416, "", "Fast DDS 2.14", "Fast DDS", "release"],
["middleware", s309, "", s2, "Fast DDS", "middleware"],
["middleware", s213, "", s177, "Fast DDS", "middleware"],
],
},
"about": s417,
"caution": "",
"ratios": s408,
"server_ratios": {"measured": "Fast DDS with a Discovery Server", "range": "1.63", "hosts": "8", "seconds": "15", "low": "1.63", "high": "1.63"},
"has_server": false,
"color": s360,
"measured": [8, 12, 60],
"band": s418,
"reboot": [1.21, 1.71],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s421,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s373],
[s422, "multicast", 580, 1, 1, 1, "up down", s378],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s425],
[s426, "unicast", 580, 1, 2, 1, "up down", s378],
[s427, "unicast", 580, 1, 3, 0.5, "up down", s378],
["SEDP", "unicast", s428, 0.6, 4, 1, "up down", s378],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s378],
[s240, "unicast", 184.3, 1, 2, 1.65, "up down", s378],
[s429, "unicast", 184.3, 1, 3, 0.4252, "up down", s378],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s378],
[s430, "unicast", 189.4, 1, 2, 2.072, "up down", s378],
[s242, "unicast", 189.4, 1, 3, 0.2616, "up down", s378],
[s249, "unicast", 192, 1, 2, 1.148, "up down", s378],
[s254, "unicast", 188, 1, 2, 1.148, "up down", s378],
[s264, "unicast", 192, 1, 5, 1.4, "up down", s378],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s378],
],
},
"Fast DDS 2.6": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s77, s145, s146, s215, "Fast DDS", s77],
[s120, s149, s146, s216, "Fast DDS", s120],
s154,
s155,
["peers", s354, "", s157, "Fast DDS 2.6", s355],
[s105, s356, "", s160, "Fast DDS 2.6", s357],
["router", s200, "", "Zenoh router", "Fast DDS 2.6", s201],
[s110, s203, "", s180, "Fast DDS 2.6", s204],
[s118, s206, "", s183, "Fast DDS 2.6", s207],
["announcements", s209, "", "Fast DDS 2.6, a longer announcement interval", "Fast DDS 2.6", "announcements"],
["release", s414, "", "Fast DDS 3.6", "Fast DDS 2.6", "release"],
["release", s416, "", "Fast DDS 2.14", "Fast DDS 2.6", "release"],
["middleware", s431, "", "Cyclone DDS", "Fast DDS 2.6", "middleware"],
["middleware", s213, "", s177, "Fast DDS 2.6", "middleware"],
],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 2.6", "range": "0.93 to 1.97", "hosts": "12", "seconds": "15", "low": "0.93", "high": "1.97"},
"server_ratios": {"measured": "Fast DDS 2.6 with a Discovery Server", "range": "0.72 to 1.05", "hosts": "12", "seconds": "15", "low": "0.72", "high": "1.05"},
"has_server": false,
"color": s360,
"measured": [10, 20, 42],
"band": s432,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s421,
"degree": 3,
"messages": [
["SPDP", "multicast", 344, 1, 0, 1, "up down", s373],
[s422, "multicast", 344, 1, 1, 1, "up down", s378],
["SPDP unicast", "unicast", 344, 1, 2, 1, "up down", s425],
[s426, "unicast", 344, 1, 2, 1, "up down", s378],
[s427, "unicast", 344, 1, 3, 0.5, "up down", s378],
["SEDP", "unicast", s433, 0.6287, 4, 1, "up down", s378],
["Heartbeat", "unicast", 118.85, 1, 2, 2, "up down", s378],
[s240, "unicast", 118.85, 1, 2, 3.274, "up down", s378],
[s429, "unicast", 118.85, 1, 3, 0.4879, "up down", s378],
["ACKNACK", "unicast", 129.22, 1, 2, 2, "up down", s378],
[s430, "unicast", 129.22, 1, 2, 1.884, "up down", s378],
[s242, "unicast", 129.22, 1, 3, 0.3703, "up down", s378],
[s249, "unicast", 132, 1, 2, 1.125, "up down", s378],
[s254, "unicast", 128, 1, 2, 1.167, "up down", s378],
[s264, "unicast", 125.14, 1, 5, 1.575, "up down", s378],
["User ACKNACK", "unicast", 128.35, 1, 5, 1.429, "up down", s378],
[s434, "unicast", 501.7, 1, 2, 1.685, "up down", s378],
["ROS Heartbeat", "unicast", 125.14, 1, 2, 3.37, "up down", s378],
[s435, "unicast", 125.14, 1, 3, 0.1534, "up down", s378],
["ROS ACKNACK", "unicast", 128.35, 1, 2, 1.426, "up down", s378],
[s436, "unicast", 128.35, 1, 3, 0.1351, "up down", s378],
],
},
"Fast DDS 2.14": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s77, s145, s146, s189, "Fast DDS", s77],
[s120, s149, s146, s192, "Fast DDS", s120],
s154,
s155,
["peers", s354, "", s157, "Fast DDS 2.14", s355],
[s105, s356, "", s160, "Fast DDS 2.14", s357],
["router", s200, "", "Zenoh router", "Fast DDS 2.14", s201],
[s110, s203, "", s180, "Fast DDS 2.14", s204],
[s118, s206, "", s183, "Fast DDS 2.14", s207],
["announcements", s209, "", "Fast DDS 2.14, a longer announcement interval", "Fast DDS 2.14", "announcements"],
["release", s414, "", "Fast DDS 3.6", "Fast DDS 2.14", "release"],
["release", s415, "", "Fast DDS 2.6", "Fast DDS 2.14", "release"],
["middleware", s431, "", "Cyclone DDS", "Fast DDS 2.14", "middleware"],
["middleware", s213, "", s177, "Fast DDS 2.14", "middleware"],
],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 2.14", "range": "0.82 to 1.19", "hosts": "12", "seconds": "15", "low": "0.82", "high": "1.19"},
"server_ratios": {"measured": "Fast DDS 2.14 with a Discovery Server", "range": "1.04 to 1.19", "hosts": "12", "seconds": "15", "low": "1.04", "high": "1.19"},
"has_server": false,
"color": s360,
"measured": [10, 20, 42],
"band": s437,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s438,
"degree": 3,
"messages": [
["SPDP", "multicast", 560, 1, 0, 1, "up down", s373],
["SPDP unicast", "unicast", 560, 1, 1, 1, "up down", s425],
[s426, "unicast", 560, 1, 1, 1, "up down", s378],
["SEDP", "unicast", s439, 0.6008, 2, 1, "up down", s378],
["Heartbeat", "unicast", 183.8, 1, 1, 2, "up down", s378],
[s240, "unicast", 183.8, 1, 1, 2.375, "up down", s378],
["ACKNACK", "unicast", 189.7, 1, 1, 2, "up down", s378],
[s430, "unicast", 189.7, 1, 1, 2.625, "up down", s378],
[s249, "unicast", 192, 1, 1, 1.125, "up down", s378],
[s254, "unicast", 188, 1, 1, 1.216, "up down", s378],
[s264, "unicast", 183.7, 1, 3, 1.5, "up down", s378],
["User ACKNACK", "unicast", 189, 1, 3, 1.554, "up down", s378],
[s434, "unicast", 480, 1, 1, 1.037, "up down", s378],
["ROS Heartbeat", "unicast", 183.7, 1, 1, 0.7995, "up down", s378],
[s435, "unicast", 183.7, 1, 4, 0.288, "up down", s378],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.9597, "up down", s378],
[s436, "unicast", 189, 1, 4, 0.1806, "up down", s378],
],
},
"Fast DDS 3.6": {
"group": s3,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [[s77, s145, s440, "Fast DDS 3.6, a Discovery Server", "Fast DDS", s77], [s120, s149, s440, "Fast DDS 3.6, two Discovery Servers", "Fast DDS", s120], s155, s441, s442, s443, s444, s445, s446, s447, s448, ["middleware", s309, "", s2, "Fast DDS 3.6", "middleware"], s449],
"kilted": [[s77, s145, s146, s217, "Fast DDS", s77], [s120, s149, s146, s218, "Fast DDS", s120], s154, s155, s441, s442, s443, s444, s445, s446, s447, s448, ["middleware", s431, "", "Cyclone DDS", "Fast DDS 3.6", "middleware"], s449],
},
"about": "",
"caution": "",
"ratios": {"measured": "Fast DDS 3.6", "range": "0.83 to 1.07", "hosts": "12", "seconds": "15", "low": "0.83", "high": "1.07"},
"server_ratios": {"measured": "Fast DDS 3.6 with a Discovery Server", "range": "1.09 to 1.15", "hosts": "12", "seconds": "15", "low": "1.09", "high": "1.15"},
"has_server": false,
"color": s360,
"measured": [10, 20, 42],
"band": s450,
"reboot": [],
"variant": true,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s451,
"degree": 3,
"messages": [
["SPDP", "multicast", 632, 1, 0, 1, "up down", s373],
["SPDP unicast", "unicast", 632, 1, 1, 1, "up down", s425],
[s426, "unicast", 632, 1, 1, 1, "up down", s378],
["SEDP", "unicast", s452, 0.6318, 2, 1, "up down", s378],
["Heartbeat", "unicast", 184.3, 1, 1, 2, "up down", s378],
[s240, "unicast", 184.3, 1, 1, 2.13, "up down", s378],
["ACKNACK", "unicast", 189.6, 1, 1, 2, "up down", s378],
[s430, "unicast", 189.6, 1, 1, 2.204, "up down", s378],
[s249, "unicast", 192, 1, 1, 1.046, "up down", s378],
[s254, "unicast", 188, 1, 1, 1.083, "up down", s378],
[s264, "unicast", 178.8, 1, 3, 1.306, "up down", s378],
["User ACKNACK", "unicast", 189, 1, 3, 1.633, "up down", s378],
[s434, "unicast", 459.4, 1, 1, 1.15, "up down", s378],
[s259, "unicast", s453, 0.9914, 1, 2.303, "up down", s378],
[s261, "unicast", 188, 1, 1, 2.5, "up down", s378],
["Type lookup", "unicast", s454, 0.2383, 4, 3.917, "up down", s378],
["ROS Heartbeat", "unicast", 178.8, 1, 1, 3.687, "up down", s378],
[s435, "unicast", 178.8, 1, 5, 0.1285, "up down", s378],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.4578, "up down", s378],
[s436, "unicast", 189, 1, 5, 0.2066, "up down", s378],
],
},
"hybrid": {
"group": s7,
"family": null,
"product": null,
"tables": {"any": []},
"about": "this book's proposal, for hosts with unlike software",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s455,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s456,
"windows": s457,
"units": [s459, s169, s366, s461, s315],
"degree": 2,
"messages": [s463, s464, s465, s466, s467, s469, s470],
},
"hybrid, alike": {
"group": s7,
"family": null,
"product": null,
"tables": {"any": []},
"about": "this book's proposal, for hosts that are alike",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s455,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 23,
"repeats": true,
"outlooks": s456,
"windows": s457,
"units": [s459, s169, [s471, s471, s471], s461, s315],
"degree": 2,
"messages": [s463, s464, ["Software", "multicast", 8, 0, 0, 1, "up down", s462], s465, s466, s467, s469, s470],
},
"DDS, periods of Fast DDS": {
"group": s6,
"family": "DDS",
"product": null,
"tables": {"any": [s148, s151, s154, s155, s158, s161, ["middleware", s472, "", s473, s474, "middleware"], ["middleware", s475, "", s476, s474, "middleware"]]},
"about": "",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s360,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s186,
"degree": 2,
"messages": [["SPDP", "multicast", 414, 1, 0, 1, "up down", s373], ["UnicastSPDP", "unicast", 414, 1, 1, 1, "up down", s373], ["SEDP", "unicast", 464, 1, 2, 1, "up down", s378], ["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s378], ["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s378]],
},
"DDS, periods of Cyclone DDS": {
"group": s6,
"family": "DDS",
"product": null,
"tables": {"any": [s148, s151, s154, s155, s158, s161, ["middleware", s477, "", s474, s473, "middleware"], ["middleware", s475, "", s476, s473, "middleware"]]},
"about": "",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s186,
"degree": 2,
"messages": [
["SPDP", "multicast", 414, 1, 0, 1, "up down", s234],
["DirectedSPDP", "unicast", 414, 1, 1, 1, "up down", s236],
["SEDP", "unicast", 464, 1, 2, 1, "up down", s238],
["Heartbeat", "unicast", 116, 1, 1, 2, "up down", s238],
["ACKNACK", "unicast", 114, 1, 1, 2, "up down", s238],
["Liveliness", "unicast", 180, 1, 1, 1, "up down", s318],
["LivelinessACK", "unicast", 114, 1, 1, 1, "up down", s318],
],
},
"Zenoh, periods of Zenoh peer": {
"group": s6,
"family": "Zenoh",
"product": null,
"tables": {"any": [s178, s181, s184, ["peers", "static peers", "", "Zenoh, periods of Zenoh peer, static peers", s476, "peers"], ["middleware", s477, "", s474, s476, "middleware"], ["middleware", s472, "", s473, s476, "middleware"]]},
"about": "",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s478,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s186,
"degree": 2,
"messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", s479], ["Hello", "unicast", 144, 1, 1, 1, "up down", s479], ["Declare", "unicast", 176, 1, 2, 1, "up down", s238], s481],
},
"static endpoints": {
"group": s4,
"family": "DDS",
"product": "Fast DDS",
"tables": {
"any": [
[s77, s145, "", s147, s119, s77],
[s120, s149, "", s150, s119, s120],
[s94, s152, "", s153, s119, s94],
["peers", s354, "", s157, s119, s355],
[s105, s356, "", s160, s119, s357],
["router", s200, "", "Zenoh router", s119, s201],
[s110, s203, "", s180, s119, s204],
[s118, s206, "", s183, s119, s207],
["announcements", s209, "", "static endpoints, a longer announcement interval", s119, "announcements"],
["middleware", s309, "", s2, s119, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s119, "middleware"],
["middleware", s213, "", s177, s119, "middleware"],
],
},
"about": s482,
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": false,
"color": s360,
"measured": [8, 8, 84],
"band": s483,
"reboot": [],
"variant": false,
"lease": 20,
"repeats": true,
"outlooks": s362,
"windows": s363,
"units": s487,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s373],
[s422, "multicast", 589.2, 1, 1, 1, "up down", s378],
[s488, "multicast", 589.2, 1, 2, 1, "up down", s378],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s425],
[s426, "unicast", 589.2, 1, 3, 1, "up down", s378],
[s427, "unicast", 589.2, 1, 4, 0.5, "up down", s378],
[s489, "unicast", 589.2, 1, 5, 0.6542, "up down", s378],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s425],
[s490, "multicast", 59.47, 0, 6, 0.8987, "up down", s378],
[s491, "multicast", 59.47, 0, 7, 0.8987, "up down", s378],
[s492, "unicast", 59.47, 0, 5, 1, "up down", s425],
[s493, "unicast", 59.47, 0, 5, 0.9528, "up down", s378],
[s494, "unicast", 59.47, 0, 8, 0.4764, "up down", s378],
[s495, "unicast", 59.47, 0, 9, 0.6233, "up down", s378],
[s249, "unicast", 192, 1, 3, 1.167, "up down", s378],
[s254, "unicast", 188, 1, 3, 1.167, "up down", s378],
[s264, "unicast", 192, 1, 10, 1.33, "up down", s378],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s378],
],
},
"Zenoh peer": {
"group": s3,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s77, s188, s269, "Zenoh peer, switching to Fast DDS with a Discovery Server", "Zenoh peer", s190],
[s120, s191, s269, "Zenoh peer, switching to Fast DDS with two Discovery Servers", "Zenoh peer", s193],
[s119, s195, "", s119, "Zenoh peer", s196],
["peers", s354, "", s157, "Zenoh peer", s355],
[s105, s356, "", s160, "Zenoh peer", s357],
s178,
s181,
s184,
["peers", "static peers", "", "Zenoh peer, static peers", "Zenoh peer", "peers"],
["middleware", s309, "", s2, "Zenoh peer", "middleware"],
["middleware", s219, "", "Fast DDS 3.6", "Zenoh peer", "middleware"],
],
},
"about": s496,
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s478,
"measured": [8, 12, 60],
"band": s497,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s499,
"degree": 3,
"messages": [
s500,
s501,
["Hello first", "unicast", 104, 1, 1, 0.5833, "up down", s238],
["InitSyn", "unicast", 110, 1, 1, 0.6667, "up down", s238],
s502,
s503,
s504,
["OAM", "unicast", s505, 0.835, 1, 1, "up down", s238],
[s506, "unicast", s505, 0.835, 2, 0.625, "up down", s238],
["Declare", "unicast", s507, 0.1957, 3, 0.5, "up down", s238],
[s508, "unicast", s509, 0.8037, 4, 0.5, "up down", s238],
[s510, "unicast", s509, 0.8037, 5, 0.5, "up down", s238],
["Declare final", "unicast", 176, 0.05, 1, 1, "up down", s238],
["Frame", "unicast", s511, 0.2478, 1, 1, "up down", s238],
[s512, "unicast", s511, 0.2478, 3, 0.6083, "up down", s238],
s513,
s514,
["TCP ACK", "unicast", 76, 1, 1, 0.8708, "up down", s480],
[s515, "unicast", 76, 1, 1, 2.496, "up down", s238],
[s516, "unicast", 76, 1, 3, 0.2188, "up down", s238],
],
},
"Zenoh peer, tokens": {
"group": s3,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s77, s188, s269, "Zenoh peer, tokens, switching to Fast DDS with a Discovery Server", s177, s190],
[s120, s191, s269, "Zenoh peer, tokens, switching to Fast DDS with two Discovery Servers", s177, s193],
[s119, s195, "", s119, s177, s196],
["peers", s354, "", s157, s177, s355],
[s105, s356, "", s160, s177, s357],
["router", s175, "", "Zenoh router", s177, "router"],
[s110, s179, "", s180, s177, s110],
[s118, s182, "", s183, s177, s118],
["peers", "static peers", "", "Zenoh peer, tokens, static peers", s177, "peers"],
["middleware", s309, "", s2, s177, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s177, "middleware"],
],
},
"about": s517,
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s478,
"measured": [8, 12, 60],
"band": s518,
"reboot": [0.896, 1.43],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s499,
"degree": 3,
"messages": [
s500,
s501,
["Hello first", "unicast", 104, 1, 1, 0.5, "up down", s238],
["InitSyn", "unicast", 109.86, 1, 1, 0.6667, "up down", s238],
s502,
s503,
s504,
["OAM", "unicast", s519, 0.7058, 1, 1, "up down", s238],
[s506, "unicast", s519, 0.7058, 2, 0.6493, "up down", s238],
["Declare", "unicast", s520, 0.0655, 3, 0.5, "up down", s238],
["Declare token", "unicast", s521, 0.0603, 3, 1, "up down", s238],
[s522, "unicast", s521, 0.0603, 1, 1, "up down", s238],
[s508, "unicast", s523, 0.5972, 4, 1.5, "up down", s238],
[s510, "unicast", s523, 0.5972, 5, 2.5, "up down", s238],
[s524, "unicast", s523, 0.5972, 1, 1, "up down", s238],
["Declare final", "unicast", s525, 0.06, 1, 1, "up down", s238],
["Frame", "unicast", s526, 0.1352, 1, 2, "up down", s238],
[s512, "unicast", s526, 0.1352, 3, 1, "up down", s238],
s513,
s514,
["TCP ACK", "unicast", 76, 1, 1, 0.7208, "up down", s480],
[s515, "unicast", 76, 1, 1, 3.325, "up down", s238],
[s516, "unicast", 76, 1, 3, 0.4208, "up down", s238],
],
},
"Zenoh router": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s77, s188, s269, "Zenoh router, switching to Fast DDS with a Discovery Server", "Zenoh router", s190],
[s120, s191, s269, "Zenoh router, switching to Fast DDS with two Discovery Servers", "Zenoh router", s193],
[s119, s195, "", s119, "Zenoh router", s196],
["peers", s354, "", s157, "Zenoh router", s355],
[s105, s356, "", s160, "Zenoh router", s357],
[s110, s179, "", s180, "Zenoh router", s110],
[s118, s182, "", s183, "Zenoh router", s118],
["middleware", s309, "", s2, "Zenoh router", "middleware"],
["middleware", s219, "", "Fast DDS 3.6", "Zenoh router", "middleware"],
["middleware", s213, "", s177, "Zenoh router", "middleware"],
],
},
"about": "one router, wired to the access point, and every process its client, with liveliness tokens, as rmw_zenoh has them (measured with 1.10.2)",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": true,
"color": s527,
"measured": [8, 12, 10],
"band": [[1, 1, 1, "In 7 swarms within these sizes, left out of the fit, discovery took 0.84 to 1.18 times the predicted airtime (typical error 10%). We expect 75% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s528,
"windows": s529,
"units": [s169, s366, s530, [s231, {"count": "count30", "more": ["more69", "more70"]}, {"count": "count31", "more": ["more71", "more72"]}], s420, s484],
"degree": 2,
"messages": [
["TCP SYN", "unicast", 76, 1, 0, 1, "up", s531],
["TCP SYN-ACK", "unicast", 76, 1, 0, 1, "down", s531],
s532,
s533,
s534,
s535,
["Interest in tokens", "unicast", s536, 0.08917, 0, 1, "up", s531],
["Interest of publishers", "unicast", s536, 0.08917, 1, 0.5, "up", s531],
["Declare", "unicast", 144.9655172413793, 0.087, 1, 0.5, "up", s531],
[s522, "unicast", s537, 0.05144, 0, 1, "up", s531],
["Declare token", "unicast", s537, 0.05144, 1, 1, "up", s531],
[s524, "unicast", s538, 0.5213, 0, 2, "up", s531],
[s508, "unicast", s538, 0.5213, 1, 1.5, "up", s531],
["Declare key expression of unmatched", "unicast", s538, 0.5213, 2, 0.5, "up", s531],
["Frame up", "unicast", s539, 0.1456, 0, 1.417, "up", s531],
["Frame of endpoints up", "unicast", s539, 0.1456, 1, 1.292, "up", s531],
["Declare passed on", "unicast", 125.74016332590944, 0.1347, 3, 1, "down", s531],
["Declare token of own node", "unicast", s540, 0.0309, 0, 1, "down", s531],
["Declare own token", "unicast", s540, 0.0309, 1, 1, "down", s531],
["Declare token of node passed on", "unicast", s540, 0.0309, 4, 1, "down", s531],
["Declare token passed on", "unicast", s540, 0.0309, 5, 1, "down", s531],
["Declare key expression of node passed on", "unicast", s541, 0.3319, 4, 1, "down", s531],
["Declare key expression passed on", "unicast", s541, 0.3319, 5, 1, "down", s531],
["Declare final", "unicast", s542, 0.06875, 0, 1, "down", s531],
["Declare final to publishers", "unicast", s542, 0.06875, 1, 0.5, "down", s531],
["Frame down", "unicast", s543, 0.1116, 0, 3.188, "down", s531],
["Frame of endpoints down", "unicast", s543, 0.1116, 1, 1.206, "down", s531],
["Frame of others down", "unicast", s543, 0.1116, 5, 0.025, "down", s531],
["KeepAlive up", "unicast", 79, 1, 0, 1, "up", s545],
s546,
["TCP ACK up", "unicast", 76, 1, 0, 1, "up", s545],
["TCP ACK down", "unicast", 76, 1, 0, 0.5, "down", s545],
["TCP ACK at start up", "unicast", 76, 1, 0, 1.761, "up", s531],
["TCP ACK of endpoints up", "unicast", 76, 1, 1, 0.5636, "up", s531],
["TCP ACK of others up", "unicast", 76, 1, 4, 0.7871, "up", s531],
[s547, "unicast", 76, 1, 0, 4.104, "down", s531],
[s548, "unicast", 76, 1, 1, 0.07292, "down", s531],
],
},
"Zenoh router per host": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s77, s188, s269, "Zenoh router per host, switching to Fast DDS with a Discovery Server", s180, s190],
[s120, s191, s269, "Zenoh router per host, switching to Fast DDS with two Discovery Servers", s180, s193],
[s119, s195, "", s119, s180, s196],
["peers", s354, "", s157, s180, s355],
[s105, s356, "", s160, s180, s357],
["router", s175, "", "Zenoh router", s180, "router"],
[s118, s182, "", s183, s180, s118],
["middleware", s309, "", s2, s180, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s180, "middleware"],
["middleware", s213, "", s177, s180, "middleware"],
],
},
"about": "a router on each host, as rmw_zenoh has it, linked with all others; processes meet their own host's on loopback (measured with 1.10.2)",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s527,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 11 swarms within these sizes, left out of the fit, discovery took 0.84 to 1.25 times the predicted airtime (typical error 2%). We expect 83% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s528,
"windows": s529,
"units": [s315, [s549, s549, s549], [s550, s550, s550], s552, s553, s554, s313],
"degree": 4,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up down", s531],
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s531],
["InitAck", "unicast", 153, 1, 0, 0.5, "up down", s531],
["OpenSyn", "unicast", 134, 1, 0, 0.5, "up down", s531],
["OpenAck", "unicast", 84, 1, 0, 0.5, "up down", s531],
["OAM", "unicast", s555, 0.04144, 0, 2, "up down", s531],
["OAM of third hosts", "unicast", s556, 0.03176, 1, 0.3843, "up down", s531],
["OAM passed on", "unicast", s556, 0.03176, 2, 0.4715, "up down", s531],
[s557, "unicast", s558, 0.8637, 0, 4.25, "up down", s531],
["Frame of gossip passed on", "unicast", s558, 0.8637, 1, 1.6, "up down", s531],
[s512, "unicast", s558, 0.8637, 3, 0.775, "up down", s531],
["Declare", "unicast", s555, 0.004144, 4, 0.5, "up down", s531],
[s559, "unicast", s555, 0.004144, 5, 0.5, "up down", s531],
[s522, "unicast", s555, 0.004144, 6, 1, "up down", s531],
["Declare token", "unicast", s555, 0.004144, 3, 1, "up down", s531],
[s508, "unicast", s560, 0.1138, 4, 0.5, "up down", s531],
[s510, "unicast", s560, 0.1138, 5, 0.2634, "up down", s531],
[s561, "unicast", s560, 0.1138, 3, 1, "up down", s531],
[s524, "unicast", s560, 0.1138, 6, 1, "up down", s531],
["KeepAlive", "unicast", 79, 1, 0, 1, "up down", s545],
["TCP ACK", "unicast", 76, 1, 0, 0.55, "up down", s545],
[s515, "unicast", 76, 1, 0, 6.597, "up down", s531],
["TCP ACK of gossip", "unicast", 76, 1, 1, 0.2278, "up down", s531],
[s516, "unicast", 76, 1, 3, 0.1124, "up down", s531],
],
},
"Zenoh router per host, star": {
"group": s4,
"family": "Zenoh",
"product": "Zenoh",
"tables": {
"any": [
[s77, s188, s269, "Zenoh router per host, star, switching to Fast DDS with a Discovery Server", s183, s190],
[s120, s191, s269, "Zenoh router per host, star, switching to Fast DDS with two Discovery Servers", s183, s193],
[s119, s195, "", s119, s183, s196],
["peers", s354, "", s157, s183, s355],
[s105, s356, "", s160, s183, s357],
["router", s175, "", "Zenoh router", s183, "router"],
[s110, s179, "", s180, s183, s110],
["middleware", s309, "", s2, s183, "middleware"],
["middleware", s219, "", "Fast DDS 3.6", s183, "middleware"],
["middleware", s213, "", s177, s183, "middleware"],
],
},
"about": "a router on each host, as rmw_zenoh has it, linked with one router that is wired to the access point; processes meet their own host's on loopback (measured with 1.10.2)",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": true,
"color": s527,
"measured": [16, 16, 10],
"band": [[1, 1, 1, "In 6 swarms within these sizes, left out of the fit, discovery took 0.85 to 1.18 times the predicted airtime (typical error 15%). We expect 71% of such swarms in this range"]],
"reboot": [],
"variant": false,
"lease": 60,
"repeats": true,
"outlooks": s528,
"windows": s529,
"units": [s459, s315, s366, s530, [s231, {"count": "count38", "more": ["more90", "more86"]}, {"count": "count39", "more": ["more91", "more89"]}], s169, s313, s553, s554, s552, s461],
"degree": 2,
"messages": [
["TCP control", "unicast", 76, 1, 0, 1, "up", s531],
["TCP control down", "unicast", 76, 1, 0, 1, "down", s531],
s532,
s533,
s534,
s535,
["OAM", "unicast", s562, 0.03601, 0, 2, "up", s531],
["OAM of others", "unicast", s562, 0.03601, 1, 1.045, "up", s531],
[s557, "unicast", s563, 0.8894, 0, 12.18, "up", s531],
[s512, "unicast", s563, 0.8894, 2, 0.4077, "up", s531],
["Declare", "unicast", s555, 0.004144, 3, 0.5, "up", s531],
[s559, "unicast", s555, 0.004144, 4, 0.5, "up", s531],
[s522, "unicast", s555, 0.004144, 5, 1, "up", s531],
["Declare token", "unicast", s555, 0.004144, 2, 1, "up", s531],
[s508, "unicast", s564, 0.1159, 3, 0.5, "up", s531],
[s510, "unicast", s564, 0.1159, 4, 0.1042, "up", s531],
[s561, "unicast", s564, 0.1159, 2, 1, "up", s531],
[s524, "unicast", s564, 0.1159, 5, 1, "up", s531],
["KeepAlive", "unicast", 79, 1, 0, 1, "up", s545],
["TCP ACK", "unicast", 76, 1, 0, 1, "up", s545],
[s515, "unicast", 76, 1, 0, 3.783, "up", s531],
["TCP ACK of processes", "unicast", 76, 1, 6, 1.217, "up", s531],
["OAM down", "unicast", s565, 0.04874, 0, 2, "down", s531],
["OAM of others down", "unicast", s565, 0.04874, 1, 1.045, "down", s531],
["Frame of gossip down", "unicast", 87.23315027458811, 0.8012, 0, 26.88, "down", s531],
["Declare down", "unicast", s566, 0.005525, 7, 0.5, "down", s531],
["Declare of matching down", "unicast", s566, 0.005525, 8, 0.5, "down", s531],
["Declare token of node down", "unicast", s566, 0.005525, 6, 1, "down", s531],
["Declare token down", "unicast", s566, 0.005525, 9, 1, "down", s531],
["Declare key expression down", "unicast", s564, 0.1159, 7, 0.5, "down", s531],
["Declare key expression of matching down", "unicast", s564, 0.1159, 8, 0.0625, "down", s531],
["Declare key expression of tokens down", "unicast", s564, 0.1159, 9, 1, "down", s531],
["Declare key expression of node down", "unicast", s564, 0.1159, 6, 1, "down", s531],
s546,
["TCP ACK down", "unicast", 76, 1, 10, 1, "down", s545],
[s547, "unicast", 76, 1, 0, 4.958, "down", s531],
[s548, "unicast", 76, 1, 2, 0.1354, "down", s531],
],
},
"Zenoh, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s185,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": Infinity,
"repeats": false,
"outlooks": s166,
"windows": s167,
"units": s567,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s174], s187],
},
"Fast DDS 2.14 Discovery Server": s568,
"Fast DDS 2.14 Discovery Server, two": s569,
"Cyclone DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s220,
"caution": s221,
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 60],
"band": s224,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s233,
"degree": 3,
"messages": [
["SPDP", "multicast", 420, 1, 0, 1, "up down", s572],
["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", s573],
["SPDP directed", "unicast", 436, 1, 1, 0.7917, "up down", s574],
["SEDP", "unicast", s237, 0.2218, 2, 1, "up down", s575],
["SEDP again", "unicast", s237, 0.2218, 3, 0.103, "up down", s575],
["Heartbeat", "unicast", s239, 0.5226, 1, 2, "up down", s575],
[s240, "unicast", s239, 0.5226, 1, 2.481, "up down", s575],
["ACKNACK", "unicast", s241, 0.402, 1, 4.635, "up down", s575],
[s242, "unicast", s241, 0.402, 4, 0.09896, "up down", s575],
s578,
[s246, "unicast", s247, 0.6253, 1, 1, "up down", s575],
[s248, "unicast", s247, 0.6253, 4, 0.1067, "up down", s575],
s579,
[s252, "unicast", s253, 0.4544, 1, 2.222, "up down", s575],
s580,
[s256, "unicast", s257, 0.3044, 1, 2.312, "up down", s575],
[s258, "unicast", s257, 0.3044, 4, 0.05208, "up down", s575],
[s259, "unicast", s260, 0.6806, 1, 2.333, "up down", s575],
[s261, "unicast", s262, 0.2641, 1, 2, "up down", s575],
[s263, "unicast", s262, 0.2641, 4, 0.2188, "up down", s575],
[s264, "unicast", s265, 0.6247, 5, 1.006, "up down", s575],
[s266, "unicast", s265, 0.6247, 6, 0.07217, "up down", s575],
["User ACKNACK", "unicast", s267, 0.338, 5, 1.404, "up down", s575],
[s268, "unicast", s267, 0.338, 6, 0.09793, "up down", s575],
],
},
"Fast DDS 2.6 Discovery Server": s568,
"Fast DDS 2.6 Discovery Server, two": s569,
"Fast DDS 3.6 Discovery Server": s568,
"Fast DDS 3.6 Discovery Server, two": s569,
"Cyclone DDS, wired, switching to Fast DDS with a Discovery Server": s582,
"Cyclone DDS, wired, switching to Fast DDS with two Discovery Servers": s583,
"Cyclone DDS, wired, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s272,
"caution": s221,
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 20],
"band": s273,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s274,
"degree": 3,
"messages": [
s584,
["SPDP directed", "unicast", s276, 0.9963, 1, 0.6667, "up down", s574],
["SEDP", "unicast", s277, 0.1841, 2, 0.5833, "up down", s575],
[s278, "multicast", s279, 0.2228, 2, 0.1667, "up down", s575],
[s280, "multicast", 232, 0.25, 0, 2, "up down", s575],
["Heartbeat", "unicast", s281, 0.3287, 1, 3, "up down", s575],
["ACKNACK", "unicast", s282, 0.3715, 1, 4.05, "up down", s575],
[s242, "unicast", s282, 0.3715, 3, 0.2833, "up down", s575],
["Liveliness", "multicast", s243, 0.7242, 0, 1, "up down", s577],
[s246, "multicast", s283, 0.9582, 0, 0.3333, "up down", s575],
[s284, "unicast", 429, 0.2, 1, 0.5, "up down", s575],
[s249, "multicast", s250, 0.2758, 0, 1, "up down", s577],
[s252, "multicast", s285, 0.1767, 0, 0.875, "up down", s575],
[s286, "unicast", s287, 0.2117, 1, 1.625, "up down", s575],
s580,
[s256, "unicast", s288, 0.2807, 1, 2.344, "up down", s575],
[s258, "unicast", s288, 0.2807, 3, 0.07812, "up down", s575],
[s259, "multicast", s289, 0.1988, 0, 2, "up down", s575],
[s290, "unicast", s291, 0.1917, 1, 0.6667, "up down", s575],
[s261, "unicast", 211.5, 0.2, 1, 2, "up down", s575],
[s263, "unicast", 211.5, 0.2, 3, 0.3125, "up down", s575],
[s264, "unicast", s292, 0.2427, 4, 0.75, "up down", s575],
[s293, "multicast", s294, 0.2152, 4, 0.25, "up down", s575],
["User ACKNACK", "unicast", s295, 0.2283, 4, 2, "up down", s575],
],
},
"Cyclone DDS, version 11, switching to Fast DDS with a Discovery Server": s582,
"Cyclone DDS, version 11, switching to Fast DDS with two Discovery Servers": s583,
"Cyclone DDS, version 11, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s296,
"caution": s221,
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 60],
"band": s297,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s233,
"degree": 3,
"messages": [
["SPDP", "multicast", 432, 1, 0, 1, "up down", s572],
["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", s573],
["SPDP directed", "unicast", s298, 0.9992, 1, 0.5413, "up down", s574],
["SEDP", "unicast", s299, 0.4598, 2, 1, "up down", s575],
["SEDP again", "unicast", s299, 0.4598, 3, 0.09093, "up down", s575],
["Heartbeat", "unicast", s300, 0.5475, 1, 2, "up down", s575],
[s240, "unicast", s300, 0.5475, 1, 2.833, "up down", s575],
["ACKNACK", "unicast", s301, 0.3982, 1, 5.167, "up down", s575],
[s242, "unicast", s301, 0.3982, 4, 0.125, "up down", s575],
s578,
[s246, "unicast", s302, 0.6519, 1, 1, "up down", s575],
[s248, "unicast", s302, 0.6519, 4, 0.09103, "up down", s575],
s579,
[s252, "unicast", s303, 0.4401, 1, 2.188, "up down", s575],
s580,
[s256, "unicast", s304, 0.2753, 1, 2.278, "up down", s575],
[s258, "unicast", s304, 0.2753, 4, 0.05556, "up down", s575],
[s259, "unicast", s305, 0.6399, 1, 2.542, "up down", s575],
[s261, "unicast", s306, 0.2385, 1, 2, "up down", s575],
[s263, "unicast", s306, 0.2385, 4, 0.1997, "up down", s575],
[s264, "unicast", s307, 0.6975, 5, 1.06, "up down", s575],
[s266, "unicast", s307, 0.6975, 6, 0.06995, "up down", s575],
["User ACKNACK", "unicast", s308, 0.4362, 5, 1.562, "up down", s575],
[s268, "unicast", s308, 0.4362, 6, 0.09399, "up down", s575],
],
},
"Cyclone DDS peers, switching to Fast DDS with a Discovery Server": s582,
"Cyclone DDS peers, switching to Fast DDS with two Discovery Servers": s583,
"Cyclone DDS peers, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s310,
"caution": s221,
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 10],
"band": s311,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s316,
"degree": 3,
"messages": [
["SPDP", "unicast", 420, 1, 0, 9, "up down", s572],
[s317, "unicast", 448, 1, 1, 6, "up down", {"burst": 1, "second": 1.125, "lease": 0.135, "ever": 0.125}],
["SPDP directed", "unicast", s319, 0.9817, 2, 0.8333, "up down", s574],
["SEDP", "unicast", s320, 0.172, 3, 1, "up down", s575],
["SEDP again", "unicast", s321, 0.8001, 4, 0.08633, "up down", s575],
["Heartbeat", "unicast", s322, 0.5756, 2, 2, "up down", s575],
[s240, "unicast", s322, 0.5756, 2, 2.944, "up down", s575],
["ACKNACK", "unicast", s323, 0.3827, 2, 4.424, "up down", s575],
[s242, "unicast", s323, 0.3827, 5, 0.2049, "up down", s575],
["Liveliness", "unicast", s324, 0.7241, 2, 1, "up down", s577],
[s246, "unicast", s325, 0.7527, 2, 1, "up down", s575],
[s248, "unicast", s325, 0.7527, 5, 0.08333, "up down", s575],
[s249, "unicast", s326, 0.2759, 2, 1, "up down", s577],
[s252, "unicast", s327, 0.4258, 2, 2.556, "up down", s575],
[s254, "unicast", 128, 1, 2, 1, "up down", s577],
[s256, "unicast", s328, 0.265, 2, 2.296, "up down", s575],
[s258, "unicast", s328, 0.265, 5, 0.09271, "up down", s575],
[s259, "unicast", s329, 0.6431, 2, 3, "up down", s575],
[s261, "unicast", s330, 0.283, 2, 2, "up down", s575],
[s263, "unicast", s330, 0.283, 5, 0.3631, "up down", s575],
[s264, "unicast", s331, 0.5405, 6, 1.542, "up down", s575],
["User ACKNACK", "unicast", s332, 0.437, 6, 2.208, "up down", s575],
],
},
"Cyclone DDS multicast SEDP, switching to Fast DDS with a Discovery Server": s582,
"Cyclone DDS multicast SEDP, switching to Fast DDS with two Discovery Servers": s583,
"Cyclone DDS multicast SEDP, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Cyclone DDS",
"tables": {"any": []},
"about": s333,
"caution": s221,
"ratios": s222,
"server_ratios": s162,
"has_server": false,
"color": s223,
"measured": [8, 12, 10],
"band": s334,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s274,
"degree": 3,
"messages": [
s584,
["SPDP directed", "unicast", s335, 0.9988, 1, 0.8, "up down", s574],
["SEDP", "unicast", s336, 0.2085, 2, 0.3719, "up down", s575],
[s278, "multicast", s337, 0.2222, 2, 0.23, "up down", s575],
[s280, "multicast", s338, 0.28, 0, 1.833, "up down", s575],
["Heartbeat", "unicast", s339, 0.3143, 1, 3.333, "up down", s575],
["ACKNACK", "unicast", s340, 0.3558, 1, 4.517, "up down", s575],
[s242, "unicast", s340, 0.3558, 3, 0.1494, "up down", s575],
["Liveliness", "multicast", s341, 0.724, 0, 1, "up down", s577],
[s246, "multicast", s342, 0.9539, 0, 0.8333, "up down", s575],
[s284, "unicast", s343, 0.15, 1, 0.5, "up down", s575],
[s249, "multicast", s344, 0.276, 0, 1, "up down", s577],
[s252, "multicast", s345, 0.2328, 0, 1, "up down", s575],
[s286, "unicast", s346, 0.2318, 1, 1.75, "up down", s575],
s580,
[s256, "unicast", s347, 0.2856, 1, 2.379, "up down", s575],
[s258, "unicast", s347, 0.2856, 3, 0.08854, "up down", s575],
[s259, "multicast", s348, 0.2325, 0, 2, "up down", s575],
[s290, "unicast", s349, 0.1726, 1, 1.167, "up down", s575],
[s261, "unicast", s350, 0.2088, 1, 2, "up down", s575],
[s263, "unicast", s350, 0.2088, 3, 0.3274, "up down", s575],
[s264, "unicast", s351, 0.4167, 4, 0.7917, "up down", s575],
[s293, "multicast", s352, 0.6667, 4, 0.1667, "up down", s575],
["User ACKNACK", "unicast", s353, 0.4167, 4, 2.167, "up down", s575],
],
},
"Fast DDS, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s417,
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": false,
"color": s360,
"measured": [8, 12, 60],
"band": s418,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s421,
"degree": 3,
"messages": [
["SPDP", "multicast", 580, 1, 0, 1, "up down", s586],
[s422, "multicast", 580, 1, 1, 1, "up down", s575],
["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", s587],
[s426, "unicast", 580, 1, 2, 1, "up down", s575],
[s427, "unicast", 580, 1, 3, 0.5, "up down", s575],
["SEDP", "unicast", s428, 0.6, 4, 1, "up down", s575],
["Heartbeat", "unicast", 184.3, 1, 2, 2, "up down", s575],
[s240, "unicast", 184.3, 1, 2, 1.65, "up down", s575],
[s429, "unicast", 184.3, 1, 3, 0.4252, "up down", s575],
["ACKNACK", "unicast", 189.4, 1, 2, 2, "up down", s575],
[s430, "unicast", 189.4, 1, 2, 2.072, "up down", s575],
[s242, "unicast", 189.4, 1, 3, 0.2616, "up down", s575],
[s249, "unicast", 192, 1, 2, 1.148, "up down", s575],
[s254, "unicast", 188, 1, 2, 1.148, "up down", s575],
[s264, "unicast", 192, 1, 5, 1.4, "up down", s575],
["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", s575],
],
},
"Fast DDS 2.6, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": false,
"color": s360,
"measured": [10, 20, 42],
"band": s432,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s421,
"degree": 3,
"messages": [
["SPDP", "multicast", 344, 1, 0, 1, "up down", s586],
[s422, "multicast", 344, 1, 1, 1, "up down", s575],
["SPDP unicast", "unicast", 344, 1, 2, 1, "up down", s587],
[s426, "unicast", 344, 1, 2, 1, "up down", s575],
[s427, "unicast", 344, 1, 3, 0.5, "up down", s575],
["SEDP", "unicast", s433, 0.6287, 4, 1, "up down", s575],
["Heartbeat", "unicast", 118.85, 1, 2, 2, "up down", s575],
[s240, "unicast", 118.85, 1, 2, 3.274, "up down", s575],
[s429, "unicast", 118.85, 1, 3, 0.4879, "up down", s575],
["ACKNACK", "unicast", 129.22, 1, 2, 2, "up down", s575],
[s430, "unicast", 129.22, 1, 2, 1.884, "up down", s575],
[s242, "unicast", 129.22, 1, 3, 0.3703, "up down", s575],
[s249, "unicast", 132, 1, 2, 1.125, "up down", s575],
[s254, "unicast", 128, 1, 2, 1.167, "up down", s575],
[s264, "unicast", 125.14, 1, 5, 1.575, "up down", s575],
["User ACKNACK", "unicast", 128.35, 1, 5, 1.429, "up down", s575],
[s434, "unicast", 501.7, 1, 2, 1.685, "up down", s575],
["ROS Heartbeat", "unicast", 125.14, 1, 2, 3.37, "up down", s575],
[s435, "unicast", 125.14, 1, 3, 0.1534, "up down", s575],
["ROS ACKNACK", "unicast", 128.35, 1, 2, 1.426, "up down", s575],
[s436, "unicast", 128.35, 1, 3, 0.1351, "up down", s575],
],
},
"Fast DDS 2.14, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": false,
"color": s360,
"measured": [10, 20, 42],
"band": s437,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s438,
"degree": 3,
"messages": [
["SPDP", "multicast", 560, 1, 0, 1, "up down", s586],
["SPDP unicast", "unicast", 560, 1, 1, 1, "up down", s587],
[s426, "unicast", 560, 1, 1, 1, "up down", s575],
["SEDP", "unicast", s439, 0.6008, 2, 1, "up down", s575],
["Heartbeat", "unicast", 183.8, 1, 1, 2, "up down", s575],
[s240, "unicast", 183.8, 1, 1, 2.375, "up down", s575],
["ACKNACK", "unicast", 189.7, 1, 1, 2, "up down", s575],
[s430, "unicast", 189.7, 1, 1, 2.625, "up down", s575],
[s249, "unicast", 192, 1, 1, 1.125, "up down", s575],
[s254, "unicast", 188, 1, 1, 1.216, "up down", s575],
[s264, "unicast", 183.7, 1, 3, 1.5, "up down", s575],
["User ACKNACK", "unicast", 189, 1, 3, 1.554, "up down", s575],
[s434, "unicast", 480, 1, 1, 1.037, "up down", s575],
["ROS Heartbeat", "unicast", 183.7, 1, 1, 0.7995, "up down", s575],
[s435, "unicast", 183.7, 1, 4, 0.288, "up down", s575],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.9597, "up down", s575],
[s436, "unicast", 189, 1, 4, 0.1806, "up down", s575],
],
},
"Fast DDS 3.6, a Discovery Server": s582,
"Fast DDS 3.6, two Discovery Servers": s583,
"Fast DDS 3.6, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": false,
"color": s360,
"measured": [10, 20, 42],
"band": s450,
"reboot": [],
"variant": true,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s451,
"degree": 3,
"messages": [
["SPDP", "multicast", 632, 1, 0, 1, "up down", s586],
["SPDP unicast", "unicast", 632, 1, 1, 1, "up down", s587],
[s426, "unicast", 632, 1, 1, 1, "up down", s575],
["SEDP", "unicast", s452, 0.6318, 2, 1, "up down", s575],
["Heartbeat", "unicast", 184.3, 1, 1, 2, "up down", s575],
[s240, "unicast", 184.3, 1, 1, 2.13, "up down", s575],
["ACKNACK", "unicast", 189.6, 1, 1, 2, "up down", s575],
[s430, "unicast", 189.6, 1, 1, 2.204, "up down", s575],
[s249, "unicast", 192, 1, 1, 1.046, "up down", s575],
[s254, "unicast", 188, 1, 1, 1.083, "up down", s575],
[s264, "unicast", 178.8, 1, 3, 1.306, "up down", s575],
["User ACKNACK", "unicast", 189, 1, 3, 1.633, "up down", s575],
[s434, "unicast", 459.4, 1, 1, 1.15, "up down", s575],
[s259, "unicast", s453, 0.9914, 1, 2.303, "up down", s575],
[s261, "unicast", 188, 1, 1, 2.5, "up down", s575],
["Type lookup", "unicast", s454, 0.2383, 4, 3.917, "up down", s575],
["ROS Heartbeat", "unicast", 178.8, 1, 1, 3.687, "up down", s575],
[s435, "unicast", 178.8, 1, 5, 0.1285, "up down", s575],
["ROS ACKNACK", "unicast", 189, 1, 1, 0.4578, "up down", s575],
[s436, "unicast", 189, 1, 5, 0.2066, "up down", s575],
],
},
"Zenoh, periods of Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": null,
"tables": {"any": []},
"about": "",
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s478,
"measured": [],
"band": [],
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s567,
"degree": 2,
"messages": [["Declare", "unicast", 176, 1, 0, 1, "up down", s238], s481],
},
"static endpoints, a longer announcement interval": {
"group": null,
"family": "DDS",
"product": "Fast DDS",
"tables": {"any": []},
"about": s482,
"caution": "",
"ratios": s408,
"server_ratios": s162,
"has_server": false,
"color": s360,
"measured": [8, 8, 84],
"band": s483,
"reboot": [],
"variant": false,
"lease": 100,
"repeats": true,
"outlooks": s570,
"windows": s571,
"units": s487,
"degree": 3,
"messages": [
["SPDP", "multicast", 589.2, 1, 0, 1, "up down", s586],
[s422, "multicast", 589.2, 1, 1, 1, "up down", s575],
[s488, "multicast", 589.2, 1, 2, 1, "up down", s575],
["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", s587],
[s426, "unicast", 589.2, 1, 3, 1, "up down", s575],
[s427, "unicast", 589.2, 1, 4, 0.5, "up down", s575],
[s489, "unicast", 589.2, 1, 5, 0.6542, "up down", s575],
["Listed", "multicast", 59.47, 0, 2, 1, "up down", s588],
[s490, "multicast", 59.47, 0, 6, 0.8987, "up down", s575],
[s491, "multicast", 59.47, 0, 7, 0.8987, "up down", s575],
[s492, "unicast", 59.47, 0, 5, 1, "up down", s588],
[s493, "unicast", 59.47, 0, 5, 0.9528, "up down", s575],
[s494, "unicast", 59.47, 0, 8, 0.4764, "up down", s575],
[s495, "unicast", 59.47, 0, 9, 0.6233, "up down", s575],
[s249, "unicast", 192, 1, 3, 1.167, "up down", s575],
[s254, "unicast", 188, 1, 3, 1.167, "up down", s575],
[s264, "unicast", 192, 1, 10, 1.33, "up down", s575],
["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", s575],
],
},
"Zenoh peer, switching to Fast DDS with a Discovery Server": s582,
"Zenoh peer, switching to Fast DDS with two Discovery Servers": s583,
"Zenoh peer, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": {"any": []},
"about": s496,
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s478,
"measured": [8, 12, 60],
"band": s497,
"reboot": [],
"variant": false,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s589,
"degree": 3,
"messages": [
["InitSyn", "unicast", 110, 1, 0, 0.5, "up down", s238],
s590,
s591,
s592,
["OAM", "unicast", s505, 0.835, 0, 1, "up down", s238],
[s506, "unicast", s505, 0.835, 1, 0.625, "up down", s238],
["Declare", "unicast", s507, 0.1957, 2, 0.5, "up down", s238],
[s508, "unicast", s509, 0.8037, 3, 0.5, "up down", s238],
[s510, "unicast", s509, 0.8037, 4, 0.5, "up down", s238],
["Declare final", "unicast", 176, 0.05, 0, 1, "up down", s238],
["Frame", "unicast", s511, 0.2478, 0, 1, "up down", s238],
[s512, "unicast", s511, 0.2478, 2, 0.6083, "up down", s238],
s594,
s595,
["TCP ACK", "unicast", 76, 1, 0, 0.6530673466326684, "up down", s480],
[s515, "unicast", 76, 1, 0, 2.496, "up down", s238],
[s516, "unicast", 76, 1, 2, 0.2188, "up down", s238],
],
},
"Zenoh peer, tokens, switching to Fast DDS with a Discovery Server": s582,
"Zenoh peer, tokens, switching to Fast DDS with two Discovery Servers": s583,
"Zenoh peer, tokens, static peers": {
"group": null,
"family": "Zenoh",
"product": "Zenoh",
"tables": {"any": []},
"about": s517,
"caution": "",
"ratios": s162,
"server_ratios": s162,
"has_server": false,
"color": s478,
"measured": [8, 12, 60],
"band": s518,
"reboot": [],
"variant": true,
"lease": 10,
"repeats": true,
"outlooks": s225,
"windows": s226,
"units": s589,
"degree": 3,
"messages": [
["InitSyn", "unicast", 109.86, 1, 0, 0.5, "up down", s238],
s590,
s591,
s592,
["OAM", "unicast", s519, 0.7058, 0, 1, "up down", s238],
[s506, "unicast", s519, 0.7058, 1, 0.6493, "up down", s238],
["Declare", "unicast", s520, 0.0655, 2, 0.5, "up down", s238],
["Declare token", "unicast", s521, 0.0603, 2, 1, "up down", s238],
[s522, "unicast", s521, 0.0603, 0, 1, "up down", s238],
[s508, "unicast", s523, 0.5972, 3, 1.5, "up down", s238],
[s510, "unicast", s523, 0.5972, 4, 2.5, "up down", s238],
[s524, "unicast", s523, 0.5972, 0, 1, "up down", s238],
["Declare final", "unicast", s525, 0.06, 0, 1, "up down", s238],
["Frame", "unicast", s526, 0.1352, 0, 2, "up down", s238],
[s512, "unicast", s526, 0.1352, 2, 1, "up down", s238],
s594,
s595,
["TCP ACK", "unicast", 76, 1, 0, 0.5405729713514325, "up down", s480],
[s515, "unicast", 76, 1, 0, 3.325, "up down", s238],
[s516, "unicast", 76, 1, 2, 0.4208, "up down", s238],
],
},
"Zenoh router, switching to Fast DDS with a Discovery Server": s582,
"Zenoh router, switching to Fast DDS with two Discovery Servers": s583,
"Zenoh router per host, switching to Fast DDS with a Discovery Server": s582,
"Zenoh router per host, switching to Fast DDS with two Discovery Servers": s583,
"Zenoh router per host, star, switching to Fast DDS with a Discovery Server": s582,
"Zenoh router per host, star, switching to Fast DDS with two Discovery Servers": s583,
},
};
})();
