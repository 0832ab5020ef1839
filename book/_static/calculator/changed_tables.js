// Tables and radios after changes; made from the package by `make live`; do not edit.
(() => {
const s1 = "remote process";
const s2 = ["endpoint", s1];
const s3 = {"name": "Declare", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 176};
const s4 = ["process", s1];
const s5 = {"up": [1, 1], "down": [1, 1]};
const s6 = ["process", "all"];
const s7 = 972.4761045987376;
const s8 = ["endpoint", s1, "third process"];
const s9 = 154.45158821278227;
const s10 = "Heartbeat of data";
const s11 = 187.0099502487562;
const s12 = "ACKNACK for others";
const s13 = ["process", s1, "third process"];
const s14 = 179.99005799502902;
const s15 = {"name": "Liveliness", "unit": s4, "multicast": 0, "sent": 0.7242, "alone": 1, "bytes": s14};
const s16 = "Liveliness at start";
const s17 = 190.54725731648807;
const s18 = "Liveliness for others";
const s19 = "Liveliness Heartbeat";
const s20 = 180.02610587382162;
const s21 = {"name": s19, "unit": s4, "multicast": 0, "sent": 0.2758, "alone": 1, "bytes": s20};
const s22 = "Liveliness Heartbeat at start";
const s23 = "Liveliness ACKNACK";
const s24 = {"name": s23, "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 128};
const s25 = "Liveliness ACKNACK at start";
const s26 = 181.3784494086728;
const s27 = "Liveliness ACKNACK for others";
const s28 = "Type lookup Heartbeat";
const s29 = "Type lookup ACKNACK";
const s30 = 195.20030291556228;
const s31 = "Type lookup ACKNACK for others";
const s32 = "User Heartbeat";
const s33 = "matched writer";
const s34 = [s33, s1];
const s35 = 139.31615175284134;
const s36 = "User Heartbeat for others";
const s37 = [s33, s1, "third process"];
const s38 = 182.43195266272187;
const s39 = "User ACKNACK for others";
const s40 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s41 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s42 = [3, 4, 5, 6, 7, 8, 10, 11, 13, 15, 16, 17, 18, 19];
const s43 = [0, 0, 0, 0, 300000000, 0, 980000000];
const s44 = [[0, 0], [0.05, 1], [0.1, 2], [1, 3], [2, 3], [3, 3], [30.1, 4], [98, 5], [196, 6]];
const s45 = {"kinds": {"multicast": s40, "to_all": s40, "up": s41, "down": s41}, "bursts": {"messages": [[0, 2], s42, [0, 1, 20, 21, 22, 23], [2], [0, 1], [9, 12, 14], [9, 12, 14]], "periods": s43, "times": s44}};
const s46 = 4611686018427387904;
const s47 = {"heartbeat_period_initial": 1000000, "heartbeat_period_max": 80000000, "lease": 1000000000, "topics": 1, "heartbeat": 5, "acknack": 7, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000};
const s48 = {
"kinds": {
"multicast": s40,
"to_all": s40,
"up": s41,
"down": s41,
"role": [0, 0, 0, 1, 0, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 0, 2, 2, 1, 2, 1, 1, 1, 0, 2, 2, 0, 2, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1],
"answers": [-1, -1, 0, 0, 7, 0, 3, 5, 5, -1, 0, 0, -1, 0, 12, 13, 13, 0, 17, 17, 3, 3, 20, 21],
"when": [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 0, 500000, 500000, s46, 500000, s46, s46, s46, 0, 500000, 500000, 0, 500000, 1470000000, s46, s46, 500000, s46, s46, s46, s46, s46, s46],
"to_unknown": s40,
"gap_first": [0, 0, 10000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"gap_number": [0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0], [0, 1], [0, 1], [9, 12], [9, 12]], "periods": [0, 0, 300000000, 0, 980000000], "times": [[0, 0], [0.1, 1], [30.1, 2], [98, 3], [196, 4]]},
"repairs": s47,
};
const s49 = {"name": "SPDP", "unit": s6, "multicast": 1, "sent": 1, "alone": 1, "bytes": 476};
const s50 = "SEDP multicast";
const s51 = "Heartbeat multicast";
const s52 = 199.39703903095557;
const s53 = "Liveliness unicast";
const s54 = "Liveliness Heartbeat unicast";
const s55 = 187.1920199501247;
const s56 = "Type lookup Heartbeat unicast";
const s57 = "User Heartbeat multicast";
const s58 = [1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
const s59 = {"kinds": {"multicast": s58, "to_all": s58, "up": s41, "down": s41}, "bursts": {"messages": [[0, 1], [2, 3, 4, 5, 6, 7, 9, 10, 12, 13, 15, 16, 17, 18, 19, 20], [0, 21, 22, 23], [1], [0], [8, 11, 14], [8, 11, 14]], "periods": s43, "times": s44}};
const s60 = [0, 300000000, 0, 980000000];
const s61 = [[0, 0], [0.1, 0], [30.1, 1], [98, 2], [196, 3]];
const s62 = {
"kinds": {
"multicast": s58,
"to_all": s58,
"up": s41,
"down": s41,
"role": [0, 0, 1, 1, 0, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 2, 2, 2, 2, 2, 1, 1, 0, 2, 2, 0, 2, 2, 1, 1, 1, 2, 2, 1, 1, 1, 1, 1],
"answers": [-1, 0, 0, 0, 0, 2, 5, 5, -1, 0, 0, -1, 0, 0, 11, 12, 12, 0, 0, 17, 17, 2, 2, 21],
"when": [0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 500000, 500000, 500000, 500000, s46, s46, s46, 0, 500000, 500000, 0, 500000, 500000, 1470000000, s46, s46, 500000, 500000, s46, s46, s46, s46, s46],
"to_unknown": s40,
"gap_first": [0, 10000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"gap_number": [0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0], [0], [8, 11], [8, 11]], "periods": s60, "times": s61},
"repairs": {"heartbeat_period_initial": 1000000, "heartbeat_period_max": 80000000, "lease": 1000000000, "topics": 1, "heartbeat": 5, "acknack": 6, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
};
const s63 = 726.2444541104828;
const s64 = 153.93607305936075;
const s65 = 186.8277247614264;
const s66 = 187.05568338702255;
const s67 = 190.87976752633492;
const s68 = 204.12578616352204;
const s69 = 133.94982078853047;
const s70 = 167.8055937643283;
const s71 = 150.13620569840168;
const s72 = 191.25372354324537;
const s73 = 170.0050484920951;
const s74 = 190.60377358490564;
const s75 = 185.2367491166078;
const s76 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s77 = 200.7060146149522;
const s78 = 186.30392156862746;
const s79 = 210.50383141762453;
const s80 = "SPDP at discovery";
const s81 = ["process", "other process"];
const s82 = "SPDP unicast at discovery";
const s83 = "SPDP unicast for others";
const s84 = {"name": "Heartbeat", "unit": s4, "multicast": 0, "sent": 2, "alone": 2, "bytes": 184.3};
const s85 = "Heartbeat for others";
const s86 = "ACKNACK of data";
const s87 = [1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s88 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s89 = [1, 3, 4, 5, 6, 12];
const s90 = [0, 2, 7, 8, 10, 11];
const s91 = [0, 0, 150000000];
const s92 = [[0, 0], [1, 1], [16, 2]];
const s93 = {"messages": [[0], [0, 2], [0, 2]], "periods": s91, "times": s92};
const s94 = "ROS discovery info";
const s95 = "ROS Heartbeat for others";
const s96 = "ROS ACKNACK for others";
const s97 = [1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s98 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s99 = [0, 0, 0, 0, 0, 0, 0, 0, 150000000];
const s100 = [[0, 0], [0.05, 1], [0.1, 2], [0.17, 3], [0.2, 4], [0.25, 5], [0.3, 6], [1, 7], [16, 8]];
const s101 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s102 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s103 = {"messages": [[0], [0, 1], [0, 1]], "periods": s91, "times": s92};
const s104 = {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 1000000000, "topics": 2, "heartbeat": 4, "acknack": 6, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000, "nack_response_delay": 1000000};
const s105 = "SPDP to server";
const s106 = "SPDP of server";
const s107 = "SPDP of server at discovery";
const s108 = "SPDP of others";
const s109 = "SPDP Heartbeat";
const s110 = "SPDP Heartbeat of server";
const s111 = "SPDP Heartbeat of others";
const s112 = "SPDP ACKNACK of others";
const s113 = "SPDP ACKNACK of server";
const s114 = "SEDP to server";
const s115 = ["endpoint", "all"];
const s116 = "SEDP of others";
const s117 = ["endpoint", "other process"];
const s118 = 655.9962112242481;
const s119 = "Heartbeat of server";
const s120 = "Heartbeat of others";
const s121 = "ACKNACK of others";
const s122 = "ACKNACK of server";
const s123 = "Liveliness Heartbeat to server";
const s124 = "Liveliness Heartbeat of server";
const s125 = ["process", s1, "match"];
const s126 = "Liveliness ACKNACK to server";
const s127 = "Liveliness ACKNACK of server";
const s128 = [1, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 1, 0, 1, 1, 1];
const s129 = [0, 1, 1, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1, 1, 1, 1];
const s130 = {
"kinds": {"to_all": [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 0, 0, 0], "up": s128, "down": s129},
"bursts": {
"messages": [[0], [2, 4, 5, 9], [0, 7], [0, 3, 6, 10, 11, 12, 13, 14, 15, 19, 20, 21], [8, 16, 17, 18, 22, 23, 24, 26], [25, 27], [1], [0], [1]],
"periods": [0, 0, 0, 0, 0, 0, 0, 30000000, 30000000],
"times": [[0, 0], [0.05, 1], [0.1, 2], [0.2, 0], [0.3, 0], [0.4, 0], [0.5, 3], [0.6, 4], [0.7, 5], [1.5, 6], [3.5, 7], [4.5, 8]],
},
};
const s131 = [0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 3, 3, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s132 = [0, 0, 2, 2, 2, 2, 2, 2, 1, 1, 2, 2, 2, 2, 2, 2, 1, 1, 1, 2, 2, 2, 2, 1, 1, 1, 1, 1];
const s133 = [0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s134 = [0, 0, 500000, s46, 500000, 500000, s46, 30000000, s46, s46, s46, 30000000, s46, 30000000, 500000, s46, s46, s46, s46, s46, 30000000, 500000, s46, s46, s46, s46, s46, s46];
const s135 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s136 = [1, 2, 2, 3, 1, 2, 3, 1, 4, 2, 3, 1, 3, 1, 2, 3, 1, 4, 2, 3, 1, 2, 0, 1, 2, 0, 0, 0];
const s137 = [0, 0, 0, 0, 0, 0, 0, 500000, 0, 0, 0, 4500000, 0, 4500000, 4500000, 0, 0, 0, 0, 0, 4500000, 4500000, 0, 0, 0, 0, 0, 0];
const s138 = {"messages": [[0], [1], [0], [1]], "periods": [0, 0, 30000000, 30000000], "times": [[0, 0], [0.1, 0], [0.2, 0], [0.3, 0], [0.4, 0], [0.5, 0], [1.5, 1], [3.5, 2], [4.5, 3]]};
const s139 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s140 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s141 = "listed endpoint";
const s142 = [1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0];
const s143 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s144 = {"name": "InitAck", "unit": s4, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 153};
const s145 = {"name": "OpenSyn", "unit": s4, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 134};
const s146 = {"name": "OpenAck", "unit": s4, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 84};
const s147 = 163.4251497005988;
const s148 = "OAM for others";
const s149 = "Declare key expression";
const s150 = ["unmatched endpoint", s1];
const s151 = 229.04217991787982;
const s152 = "Declare key expression of matching";
const s153 = 112.31961259079904;
const s154 = "Frame of endpoints";
const s155 = 0.9997000149992501;
const s156 = {"name": "KeepAlive", "unit": s4, "multicast": 0, "sent": s155, "alone": s155, "bytes": 79};
const s157 = {"name": "TCP control", "unit": s4, "multicast": 0, "sent": s155, "alone": s155, "bytes": 76};
const s158 = 0.6530673466326684;
const s159 = "TCP ACK at start";
const s160 = "TCP ACK of endpoints";
const s161 = [0, 0, 0, 25000000];
const s162 = [[0.05, 0], [0.1, 1], [2.5, 2], [5, 3]];
const s163 = 179.4287333522244;
const s164 = 175.50248756218906;
const s165 = 362.8385800401876;
const s166 = 142.56804733727813;
const s167 = 0.5405729713514325;
const s168 = 158.48931924611142;
const s169 = 2.51188643150958;
const s170 = {"bits": 520, "added": 22, "symbol": 36, "grid": 40, "preamble": 400};
const s171 = {"bits": 96, "added": 22, "symbol": 40, "grid": 40, "preamble": 200};
const s172 = {"bits": 96, "added": 22, "symbol": 40, "grid": 40, "preamble": 260};
const { tables, radios } = {
"tables": {
"Zenoh, static peers": {
"messages": [s3, {"name": "KeepAlive", "unit": s4, "multicast": 0, "sent": 2, "alone": 2, "bytes": 84}],
"inside": [],
"alone": {"kinds": s5, "bursts": {"messages": [[0, 1]], "periods": [0], "times": [[0, 0]]}},
"recovering": {"refused": "recovery must be False for the protocol 'Zenoh': it does not say how processes find each other, or, with a server on a host, which of its messages go to the server"},
},
"Cyclone DDS, a longer announcement interval": {
"messages": [
{"name": "SPDP", "unit": s6, "multicast": 1, "sent": 1, "alone": 1, "bytes": 420},
{"name": "SPDP unicast", "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 420},
{"name": "SPDP directed", "unit": s4, "multicast": 0, "sent": 0.7917, "alone": 0.7917, "bytes": 436},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.2218, "alone": 1, "bytes": s7},
{"name": "SEDP again", "unit": s8, "multicast": 0, "sent": 0.0228454, "alone": 0.103, "bytes": s7},
{"name": "Heartbeat", "unit": s4, "multicast": 0, "sent": 1.0452, "alone": 2, "bytes": s9},
{"name": s10, "unit": s4, "multicast": 0, "sent": 1.2965706, "alone": 2.481, "bytes": s9},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 1.86327, "alone": 4.635, "bytes": s11},
{"name": s12, "unit": s13, "multicast": 0, "sent": 0.039781920000000005, "alone": 0.09896, "bytes": s11},
s15,
{"name": s16, "unit": s4, "multicast": 0, "sent": 0.6253, "alone": 1, "bytes": s17},
{"name": s18, "unit": s13, "multicast": 0, "sent": 0.06671951, "alone": 0.1067, "bytes": s17},
s21,
{"name": s22, "unit": s4, "multicast": 0, "sent": 1.0096768, "alone": 2.222, "bytes": 153.8987676056338},
s24,
{"name": s25, "unit": s4, "multicast": 0, "sent": 0.7037728, "alone": 2.312, "bytes": s26},
{"name": s27, "unit": s13, "multicast": 0, "sent": 0.015853152000000002, "alone": 0.05208, "bytes": s26},
{"name": s28, "unit": s4, "multicast": 0, "sent": 1.5878398, "alone": 2.333, "bytes": 129.08962679988247},
{"name": s29, "unit": s4, "multicast": 0, "sent": 0.5282, "alone": 2, "bytes": s30},
{"name": s31, "unit": s13, "multicast": 0, "sent": 0.057785079999999996, "alone": 0.2188, "bytes": s30},
{"name": s32, "unit": s34, "multicast": 0, "sent": 0.6284482, "alone": 1.006, "bytes": s35},
{"name": s36, "unit": s37, "multicast": 0, "sent": 0.045084599, "alone": 0.07217, "bytes": s35},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 0.47455200000000003, "alone": 1.404, "bytes": s38},
{"name": s39, "unit": s37, "multicast": 0, "sent": 0.033100340000000006, "alone": 0.09793, "bytes": s38},
],
"inside": [],
"alone": s45,
"recovering": s48,
},
"Cyclone DDS, wired, a longer announcement interval": {
"messages": [
s49,
{"name": "SPDP directed", "unit": s4, "multicast": 0, "sent": 0.6642332099999999, "alone": 0.6667, "bytes": 493.08762420957544},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.10738553000000002, "alone": 0.5833, "bytes": 1167.7479630635523},
{"name": s50, "unit": s2, "multicast": 1, "sent": 0.037140759999999995, "alone": 0.1667, "bytes": 961.6660682226212},
{"name": s51, "unit": s6, "multicast": 1, "sent": 0.5, "alone": 2, "bytes": 232},
{"name": "Heartbeat", "unit": s4, "multicast": 0, "sent": 0.9861, "alone": 3, "bytes": 201.42013994523882},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 1.504575, "alone": 4.05, "bytes": s52},
{"name": s12, "unit": s13, "multicast": 0, "sent": 0.10524594999999999, "alone": 0.2833, "bytes": s52},
{"name": "Liveliness", "unit": s6, "multicast": 1, "sent": 0.7242, "alone": 1, "bytes": s14},
{"name": s16, "unit": s6, "multicast": 1, "sent": 0.31936806, "alone": 0.3333, "bytes": 150.79816322270926},
{"name": s53, "unit": s4, "multicast": 0, "sent": 0.1, "alone": 0.5, "bytes": 429},
{"name": s19, "unit": s6, "multicast": 1, "sent": 0.2758, "alone": 1, "bytes": s20},
{"name": s22, "unit": s6, "multicast": 1, "sent": 0.15461249999999999, "alone": 0.875, "bytes": 245.09790605546124},
{"name": s54, "unit": s4, "multicast": 0, "sent": 0.3440125, "alone": 1.625, "bytes": 234.05196032120926},
s24,
{"name": s25, "unit": s4, "multicast": 0, "sent": 0.6579608, "alone": 2.344, "bytes": s55},
{"name": s27, "unit": s13, "multicast": 0, "sent": 0.021928284, "alone": 0.07812, "bytes": s55},
{"name": s28, "unit": s6, "multicast": 1, "sent": 0.3976, "alone": 2, "bytes": 224.96579476861166},
{"name": s56, "unit": s4, "multicast": 0, "sent": 0.12780639, "alone": 0.6667, "bytes": 230.92749087115283},
{"name": s29, "unit": s4, "multicast": 0, "sent": 0.4, "alone": 2, "bytes": 211.5},
{"name": s31, "unit": s13, "multicast": 0, "sent": 0.0625, "alone": 0.3125, "bytes": 211.5},
{"name": s32, "unit": s34, "multicast": 0, "sent": 0.182025, "alone": 0.75, "bytes": 230.46065100947672},
{"name": s57, "unit": s34, "multicast": 1, "sent": 0.0538, "alone": 0.25, "bytes": 232.6802973977695},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 0.4566, "alone": 2, "bytes": 226.06745510293473},
],
"inside": [],
"alone": s59,
"recovering": s62,
},
"Cyclone DDS, version 11, a longer announcement interval": {
"messages": [
{"name": "SPDP", "unit": s6, "multicast": 1, "sent": 1, "alone": 1, "bytes": 432},
{"name": "SPDP unicast", "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 432},
{"name": "SPDP directed", "unit": s4, "multicast": 0, "sent": 0.54086696, "alone": 0.5413, "bytes": 432.2946357085669},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.4598, "alone": 1, "bytes": s63},
{"name": "SEDP again", "unit": s8, "multicast": 0, "sent": 0.041809613999999995, "alone": 0.09093, "bytes": s63},
{"name": "Heartbeat", "unit": s4, "multicast": 0, "sent": 1.095, "alone": 2, "bytes": s64},
{"name": s10, "unit": s4, "multicast": 0, "sent": 1.5510675, "alone": 2.833, "bytes": s64},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 2.0574993999999998, "alone": 5.167, "bytes": s65},
{"name": s12, "unit": s13, "multicast": 0, "sent": 0.049775, "alone": 0.125, "bytes": s65},
s15,
{"name": s16, "unit": s4, "multicast": 0, "sent": 0.6519, "alone": 1, "bytes": s66},
{"name": s18, "unit": s13, "multicast": 0, "sent": 0.059342457, "alone": 0.09103, "bytes": s66},
s21,
{"name": s22, "unit": s4, "multicast": 0, "sent": 0.9629388000000001, "alone": 2.188, "bytes": 156.2517609634174},
s24,
{"name": s25, "unit": s4, "multicast": 0, "sent": 0.6271334, "alone": 2.278, "bytes": s67},
{"name": s27, "unit": s13, "multicast": 0, "sent": 0.015295667999999998, "alone": 0.05556, "bytes": s67},
{"name": s28, "unit": s4, "multicast": 0, "sent": 1.6266258, "alone": 2.542, "bytes": 132.5107047976246},
{"name": s29, "unit": s4, "multicast": 0, "sent": 0.477, "alone": 2, "bytes": s68},
{"name": s31, "unit": s13, "multicast": 0, "sent": 0.047628449999999996, "alone": 0.1997, "bytes": s68},
{"name": s32, "unit": s34, "multicast": 0, "sent": 0.7393500000000001, "alone": 1.06, "bytes": s69},
{"name": s36, "unit": s37, "multicast": 0, "sent": 0.048790125, "alone": 0.06995, "bytes": s69},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 0.6813444, "alone": 1.562, "bytes": s70},
{"name": s39, "unit": s37, "multicast": 0, "sent": 0.040998438, "alone": 0.09399, "bytes": s70},
],
"inside": [],
"alone": s45,
"recovering": s48,
},
"Cyclone DDS peers, a longer announcement interval": {
"messages": [
{"name": "SPDP", "unit": ["process", "other host"], "multicast": 0, "sent": 9, "alone": 9, "bytes": 420},
{"name": "ICMP unreachable", "unit": ["host", "other host"], "multicast": 0, "sent": 6, "alone": 6, "bytes": 448},
{"name": "SPDP directed", "unit": s4, "multicast": 0, "sent": 0.81805061, "alone": 0.8333, "bytes": 442.0177243557095},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.172, "alone": 1, "bytes": 1224.46511627907},
{"name": "SEDP again", "unit": s8, "multicast": 0, "sent": 0.06907263300000001, "alone": 0.08633, "bytes": 334.84114485689287},
{"name": "Heartbeat", "unit": s4, "multicast": 0, "sent": 1.1512, "alone": 2, "bytes": s71},
{"name": s10, "unit": s4, "multicast": 0, "sent": 1.6945664, "alone": 2.944, "bytes": s71},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 1.6930648000000001, "alone": 4.424, "bytes": s72},
{"name": s12, "unit": s13, "multicast": 0, "sent": 0.07841523, "alone": 0.2049, "bytes": s72},
{"name": "Liveliness", "unit": s4, "multicast": 0, "sent": 0.7241, "alone": 1, "bytes": 180.00607650876952},
{"name": s16, "unit": s4, "multicast": 0, "sent": 0.7527, "alone": 1, "bytes": s73},
{"name": s18, "unit": s13, "multicast": 0, "sent": 0.062722491, "alone": 0.08333, "bytes": s73},
{"name": s19, "unit": s4, "multicast": 0, "sent": 0.2759, "alone": 1, "bytes": 179.9840521928235},
{"name": s22, "unit": s4, "multicast": 0, "sent": 1.0883448, "alone": 2.556, "bytes": 156.0150305307656},
s24,
{"name": s25, "unit": s4, "multicast": 0, "sent": 0.60844, "alone": 2.296, "bytes": s74},
{"name": s27, "unit": s13, "multicast": 0, "sent": 0.02456815, "alone": 0.09271, "bytes": s74},
{"name": s28, "unit": s4, "multicast": 0, "sent": 1.9293, "alone": 3, "bytes": 134.67330119732546},
{"name": s29, "unit": s4, "multicast": 0, "sent": 0.566, "alone": 2, "bytes": s75},
{"name": s31, "unit": s13, "multicast": 0, "sent": 0.10275729999999998, "alone": 0.3631, "bytes": s75},
{"name": s32, "unit": s34, "multicast": 0, "sent": 0.8334509999999999, "alone": 1.542, "bytes": 147.20074005550418},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 0.9648960000000001, "alone": 2.208, "bytes": 166.51716247139586},
],
"inside": [],
"alone": {"kinds": {"up": s76, "down": s76}, "bursts": {"messages": [[0, 1, 2], s42, [0, 20, 21], [2], [1], [0], [9, 12, 14], [9, 12, 14]], "periods": [0, 0, 0, 0, 80000000, 300000000, 0, 980000000], "times": [[0, 0], [0.05, 1], [0.1, 2], [1, 3], [2, 3], [3, 3], [8, 4], [30.1, 5], [98, 6], [196, 7]]}},
"recovering": {
"kinds": {
"up": s76,
"down": s76,
"role": [0, 0, 0, 1, 0, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 2, 2, 2, 1, 2, 1, 1, 1, 0, 2, 2, 0, 2, 1, 1, 1, 2, 1, 1, 1, 1],
"answers": [-1, 0, 0, 0, 7, 0, 3, 5, 5, -1, 0, 0, -1, 0, 12, 13, 13, 0, 17, 17, 3, 20],
"when": [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 500000, 500000, 500000, s46, 500000, s46, s46, s46, 0, 500000, 500000, 0, 500000, 1470000000, s46, s46, 500000, s46, s46, s46, s46],
"to_unknown": [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"gap_first": [0, 0, 10000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"gap_number": [0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0], [0], [9, 12], [9, 12]], "periods": s60, "times": s61},
"repairs": s47,
"spread": [0],
},
},
"Cyclone DDS multicast SEDP, a longer announcement interval": {
"messages": [
s49,
{"name": "SPDP directed", "unit": s4, "multicast": 0, "sent": 0.7990400000000001, "alone": 0.8, "bytes": 492.4140969162995},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.07754115, "alone": 0.3719, "bytes": 1040.4988009592325},
{"name": s50, "unit": s2, "multicast": 1, "sent": 0.051106000000000006, "alone": 0.23, "bytes": 965.8901890189019},
{"name": s51, "unit": s6, "multicast": 1, "sent": 0.51324, "alone": 1.833, "bytes": 215.89285714285714},
{"name": "Heartbeat", "unit": s4, "multicast": 0, "sent": 1.0475619, "alone": 3.333, "bytes": 213.31594018453706},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 1.6071486000000001, "alone": 4.517, "bytes": s77},
{"name": s12, "unit": s13, "multicast": 0, "sent": 0.053156520000000006, "alone": 0.1494, "bytes": s77},
{"name": "Liveliness", "unit": s6, "multicast": 1, "sent": 0.724, "alone": 1, "bytes": 180.02209944751382},
{"name": s16, "unit": s6, "multicast": 1, "sent": 0.79488487, "alone": 0.8333, "bytes": 152.05954502568403},
{"name": s53, "unit": s4, "multicast": 0, "sent": 0.075, "alone": 0.5, "bytes": 510.6666666666667},
{"name": s19, "unit": s6, "multicast": 1, "sent": 0.276, "alone": 1, "bytes": 179.94202898550725},
{"name": s22, "unit": s6, "multicast": 1, "sent": 0.2328, "alone": 1, "bytes": 201.4570446735395},
{"name": s54, "unit": s4, "multicast": 0, "sent": 0.40565, "alone": 1.75, "bytes": 219.65142364106987},
s24,
{"name": s25, "unit": s4, "multicast": 0, "sent": 0.6794424, "alone": 2.379, "bytes": s78},
{"name": s27, "unit": s13, "multicast": 0, "sent": 0.025287024, "alone": 0.08854, "bytes": s78},
{"name": s28, "unit": s6, "multicast": 1, "sent": 0.465, "alone": 2, "bytes": 207.01075268817203},
{"name": s56, "unit": s4, "multicast": 0, "sent": 0.2014242, "alone": 1.167, "bytes": 249.3997682502897},
{"name": s29, "unit": s4, "multicast": 0, "sent": 0.4176, "alone": 2, "bytes": s79},
{"name": s31, "unit": s13, "multicast": 0, "sent": 0.06836112000000001, "alone": 0.3274, "bytes": s79},
{"name": s32, "unit": s34, "multicast": 0, "sent": 0.32990139, "alone": 0.7917, "bytes": 176.79097672186225},
{"name": s57, "unit": s34, "multicast": 1, "sent": 0.11113888999999999, "alone": 0.1667, "bytes": 122.00209989500526},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 0.9029889, "alone": 2.167, "bytes": 167.19174466042716},
],
"inside": [],
"alone": s59,
"recovering": s62,
},
"Fast DDS, a longer announcement interval": {
"messages": [
{"name": "SPDP", "unit": s6, "multicast": 1, "sent": 1, "alone": 1, "bytes": 580},
{"name": s80, "unit": s81, "multicast": 1, "sent": 1, "alone": 1, "bytes": 580},
{"name": "SPDP unicast", "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 580},
{"name": s82, "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 580},
{"name": s83, "unit": s13, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 580},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.6, "alone": 1, "bytes": 852.6666666666666},
s84,
{"name": s10, "unit": s4, "multicast": 0, "sent": 1.65, "alone": 1.65, "bytes": 184.3},
{"name": s85, "unit": s13, "multicast": 0, "sent": 0.4252, "alone": 0.4252, "bytes": 184.3},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 2, "alone": 2, "bytes": 189.4},
{"name": s86, "unit": s4, "multicast": 0, "sent": 2.072, "alone": 2.072, "bytes": 189.4},
{"name": s12, "unit": s13, "multicast": 0, "sent": 0.2616, "alone": 0.2616, "bytes": 189.4},
{"name": s19, "unit": s4, "multicast": 0, "sent": 1.148, "alone": 1.148, "bytes": 192},
{"name": s23, "unit": s4, "multicast": 0, "sent": 1.148, "alone": 1.148, "bytes": 188},
{"name": s32, "unit": s34, "multicast": 0, "sent": 1.4, "alone": 1.4, "bytes": 192},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 1.425, "alone": 1.425, "bytes": 188},
],
"inside": [],
"alone": {"kinds": {"multicast": s87, "to_all": s87, "up": s88, "down": s88}, "bursts": {"messages": [[0], s89, [9, 13, 14], [15], s90, [0, 2]], "periods": [0, 0, 0, 0, 0, 150000000], "times": [[0, 0], [0.05, 1], [0.1, 2], [0.17, 3], [1, 4], [16, 5]]}},
"recovering": {
"kinds": {
"multicast": s87,
"to_all": s87,
"up": s88,
"down": s88,
"role": [0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 2, 0, 2, 2, 2, 2, 1, 1, 1, 1, 1, 2, 1, 1, 1],
"answers": [-1, 0, -1, 0, 0, 0, 0, 5, 5, 6, 7, 8, 0, 12, 5, 14],
"when": [0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 5000000, 0, 5000000, 5000000, 5000000, 5000000, s46, s46, s46, s46, s46, 5000000, s46, s46, s46],
"to_unknown": [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": s93,
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 1000000000, "topics": 2, "heartbeat": 6, "acknack": 9, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
},
},
"Fast DDS 2.6, a longer announcement interval": {
"messages": [
{"name": "SPDP", "unit": s6, "multicast": 1, "sent": 1, "alone": 1, "bytes": 344},
{"name": s80, "unit": s81, "multicast": 1, "sent": 1, "alone": 1, "bytes": 344},
{"name": "SPDP unicast", "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 344},
{"name": s82, "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 344},
{"name": s83, "unit": s13, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 344},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.6287, "alone": 1, "bytes": 773.5594083028471},
{"name": "Heartbeat", "unit": s4, "multicast": 0, "sent": 2, "alone": 2, "bytes": 118.85},
{"name": s10, "unit": s4, "multicast": 0, "sent": 3.274, "alone": 3.274, "bytes": 118.85},
{"name": s85, "unit": s13, "multicast": 0, "sent": 0.4879, "alone": 0.4879, "bytes": 118.85},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 2, "alone": 2, "bytes": 129.22},
{"name": s86, "unit": s4, "multicast": 0, "sent": 1.884, "alone": 1.884, "bytes": 129.22},
{"name": s12, "unit": s13, "multicast": 0, "sent": 0.3703, "alone": 0.3703, "bytes": 129.22},
{"name": s19, "unit": s4, "multicast": 0, "sent": 1.125, "alone": 1.125, "bytes": 132},
{"name": s23, "unit": s4, "multicast": 0, "sent": 1.167, "alone": 1.167, "bytes": 128},
{"name": s32, "unit": s34, "multicast": 0, "sent": 1.575, "alone": 1.575, "bytes": 125.14},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 1.429, "alone": 1.429, "bytes": 128.35},
{"name": s94, "unit": s4, "multicast": 0, "sent": 1.685, "alone": 1.685, "bytes": 501.7},
{"name": "ROS Heartbeat", "unit": s4, "multicast": 0, "sent": 3.37, "alone": 3.37, "bytes": 125.14},
{"name": s95, "unit": s13, "multicast": 0, "sent": 0.1534, "alone": 0.1534, "bytes": 125.14},
{"name": "ROS ACKNACK", "unit": s4, "multicast": 0, "sent": 1.426, "alone": 1.426, "bytes": 128.35},
{"name": s96, "unit": s13, "multicast": 0, "sent": 0.1351, "alone": 0.1351, "bytes": 128.35},
],
"inside": [],
"alone": {"kinds": {"multicast": s97, "to_all": s97, "up": s98, "down": s98}, "bursts": {"messages": [[0], s89, [9, 13, 14], [15], [16], [17, 18], [19, 20], s90, [0, 2]], "periods": s99, "times": s100}},
"recovering": {
"kinds": {
"multicast": s97,
"to_all": s97,
"up": s98,
"down": s98,
"role": [0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 2, 0, 2, 2, 2, 2, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1],
"answers": [-1, 0, -1, 0, 0, 0, 0, 5, 5, 6, 7, 8, 0, 12, 5, 14, 5, 16, 16, 17, 18],
"when": [0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 5000000, 0, 5000000, 5000000, 5000000, 5000000, s46, s46, s46, s46, s46, 5000000, s46, s46, s46, s46, s46, s46, s46, s46],
"to_unknown": [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"delay": [0, 0, 0, 0, 0, 1000, 1000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": s93,
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 1000000000, "topics": 2, "heartbeat": 6, "acknack": 9, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000, "nack_response_delay": 1000},
},
},
"Fast DDS 2.14, a longer announcement interval": {
"messages": [
{"name": "SPDP", "unit": s6, "multicast": 1, "sent": 1, "alone": 1, "bytes": 560},
{"name": "SPDP unicast", "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 560},
{"name": s82, "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 560},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.6008, "alone": 1, "bytes": 1014.7323568575234},
{"name": "Heartbeat", "unit": s4, "multicast": 0, "sent": 2, "alone": 2, "bytes": 183.8},
{"name": s10, "unit": s4, "multicast": 0, "sent": 2.375, "alone": 2.375, "bytes": 183.8},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 2, "alone": 2, "bytes": 189.7},
{"name": s86, "unit": s4, "multicast": 0, "sent": 2.625, "alone": 2.625, "bytes": 189.7},
{"name": s19, "unit": s4, "multicast": 0, "sent": 1.125, "alone": 1.125, "bytes": 192},
{"name": s23, "unit": s4, "multicast": 0, "sent": 1.216, "alone": 1.216, "bytes": 188},
{"name": s32, "unit": s34, "multicast": 0, "sent": 1.5, "alone": 1.5, "bytes": 183.7},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 1.554, "alone": 1.554, "bytes": 189},
{"name": s94, "unit": s4, "multicast": 0, "sent": 1.037, "alone": 1.037, "bytes": 480},
{"name": "ROS Heartbeat", "unit": s4, "multicast": 0, "sent": 0.7995, "alone": 0.7995, "bytes": 183.7},
{"name": s95, "unit": s13, "multicast": 0, "sent": 0.288, "alone": 0.288, "bytes": 183.7},
{"name": "ROS ACKNACK", "unit": s4, "multicast": 0, "sent": 0.9597, "alone": 0.9597, "bytes": 189},
{"name": s96, "unit": s13, "multicast": 0, "sent": 0.1806, "alone": 0.1806, "bytes": 189},
],
"inside": [],
"alone": {"kinds": {"multicast": s101, "to_all": s101, "up": s102, "down": s102}, "bursts": {"messages": [[0], [2, 3, 4, 8], [6, 9, 10], [11], [12], [13, 14], [15, 16], [0, 1, 5, 7], [0, 1]], "periods": s99, "times": s100}},
"recovering": {
"kinds": {
"multicast": s101,
"to_all": s101,
"up": s102,
"down": s102,
"role": [0, 0, 0, 1, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 0, 2, 2, 2, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1],
"answers": [-1, -1, 0, 0, 0, 3, 4, 5, 0, 8, 3, 10, 3, 12, 12, 13, 14],
"when": [0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 0, 5000000, 5000000, 5000000, s46, s46, s46, 5000000, s46, s46, s46, s46, s46, s46, s46, s46],
"to_unknown": s101,
"delay": [0, 0, 0, 1000000, 1000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": s103,
"repairs": s104,
},
},
"Fast DDS 3.6, a Discovery Server": {
"messages": [
{"name": s105, "unit": s6, "multicast": 0, "sent": 1, "alone": 1, "bytes": 652},
{"name": s106, "unit": s6, "multicast": 0, "sent": 1, "alone": 1, "bytes": 700},
{"name": s107, "unit": s6, "multicast": 0, "sent": 0.865, "alone": 1, "bytes": 748.3930635838151},
{"name": s108, "unit": s81, "multicast": 0, "sent": 1.6752939, "alone": 1.967, "bytes": 683.9365973934484},
{"name": s109, "unit": s6, "multicast": 0, "sent": 2, "alone": 2, "bytes": 192},
{"name": s110, "unit": s6, "multicast": 0, "sent": 1.2934822999999998, "alone": 2.167, "bytes": 250.29586195342605},
{"name": s111, "unit": s81, "multicast": 0, "sent": 0.9253256, "alone": 2.908, "bytes": 354.98051539912007},
{"name": "SPDP ACKNACK", "unit": s6, "multicast": 0, "sent": 2.167, "alone": 2.167, "bytes": 189.9},
{"name": s112, "unit": s81, "multicast": 0, "sent": 0.5083, "alone": 0.5083, "bytes": 190.2},
{"name": s113, "unit": s6, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
{"name": "SPDP Gap", "unit": s81, "multicast": 0, "sent": 0.99088, "alone": 1.6, "bytes": 204.14209591474247},
{"name": s114, "unit": s115, "multicast": 0, "sent": 0.45, "alone": 1, "bytes": 1152},
{"name": s116, "unit": s117, "multicast": 0, "sent": 1.0447702, "alone": 1.237, "bytes": s118},
{"name": "Heartbeat", "unit": s6, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s119, "unit": s6, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s120, "unit": s117, "multicast": 0, "sent": 0.4461336, "alone": 1.892, "bytes": 451.4893977947413},
{"name": "ACKNACK", "unit": s6, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": s121, "unit": s117, "multicast": 0, "sent": 0.45, "alone": 0.45, "bytes": 191.3},
{"name": s122, "unit": s6, "multicast": 0, "sent": 15.6, "alone": 15.6, "bytes": 188.5},
{"name": "Gap", "unit": s117, "multicast": 0, "sent": 0.44105099999999997, "alone": 0.645, "bytes": 205.97133664814274},
{"name": s123, "unit": s6, "multicast": 0, "sent": 1, "alone": 1, "bytes": 192},
{"name": s124, "unit": s6, "multicast": 0, "sent": 2, "alone": 2, "bytes": 192},
{"name": s19, "unit": s125, "multicast": 0, "sent": 1.292, "alone": 1.292, "bytes": 192},
{"name": s126, "unit": s6, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
{"name": s127, "unit": s6, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
{"name": s23, "unit": s125, "multicast": 0, "sent": 1.292, "alone": 1.292, "bytes": 188},
{"name": s32, "unit": s34, "multicast": 0, "sent": 1.021, "alone": 1.021, "bytes": 192},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 1.021, "alone": 1.021, "bytes": 188},
],
"inside": [],
"alone": s130,
"recovering": {
"kinds": {
"up": s128,
"down": s129,
"role": s131,
"informs": [1, 1, 1, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": s132,
"answers": [-1, -1, 0, 11, 0, 0, 3, 1, 12, 4, 3, 1, 11, 1, 0, 12, 14, 12, 13, 12, 1, 0, 3, 21, 20, 22, 12, 26],
"when": s133,
"since": s134,
"to_unknown": s135,
"leg": s136,
"delay": s137,
},
"bursts": s138,
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 200000000, "topics": 4, "heartbeat": 13, "acknack": 16, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
"server": true,
},
},
"Fast DDS 3.6, two Discovery Servers": {
"messages": [
{"name": s105, "unit": s6, "multicast": 0, "sent": 2, "alone": 2, "bytes": 636},
{"name": s106, "unit": s6, "multicast": 0, "sent": 2, "alone": 2, "bytes": 700},
{"name": s107, "unit": s6, "multicast": 0, "sent": 1.7314, "alone": 2, "bytes": 747.8396673212429},
{"name": s108, "unit": s81, "multicast": 0, "sent": 3.32124, "alone": 3.9, "bytes": 684.0093940817285},
{"name": s109, "unit": s6, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s110, "unit": s6, "multicast": 0, "sent": 2.86935, "alone": 4.625, "bytes": 244.85106382978725},
{"name": s111, "unit": s81, "multicast": 0, "sent": 1.6209776, "alone": 5.942, "bytes": 402.48973607038124},
{"name": "SPDP ACKNACK", "unit": s6, "multicast": 0, "sent": 4.625, "alone": 4.625, "bytes": 189.8},
{"name": s112, "unit": s81, "multicast": 0, "sent": 0.9417, "alone": 0.9417, "bytes": 190.5},
{"name": s113, "unit": s6, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": "SPDP Gap", "unit": s81, "multicast": 0, "sent": 2.2387761, "alone": 3.333, "bytes": 199.09006997171358},
{"name": s114, "unit": s115, "multicast": 0, "sent": 0.8166, "alone": 2, "bytes": 1257.7301004163605},
{"name": s116, "unit": s117, "multicast": 0, "sent": 2.0692700000000004, "alone": 2.45, "bytes": s118},
{"name": "Heartbeat", "unit": s6, "multicast": 0, "sent": 8, "alone": 8, "bytes": 184},
{"name": s119, "unit": s6, "multicast": 0, "sent": 8, "alone": 8, "bytes": 192},
{"name": s120, "unit": s117, "multicast": 0, "sent": 0.807258, "alone": 3.242, "bytes": 432.5140562248996},
{"name": "ACKNACK", "unit": s6, "multicast": 0, "sent": 8, "alone": 8, "bytes": 188},
{"name": s121, "unit": s117, "multicast": 0, "sent": 0.85, "alone": 0.85, "bytes": 190.8},
{"name": s122, "unit": s6, "multicast": 0, "sent": 31.6, "alone": 31.6, "bytes": 188.5},
{"name": "Gap", "unit": s117, "multicast": 0, "sent": 0.6431319999999999, "alone": 1.03, "bytes": 207.54580397181294},
{"name": s123, "unit": s6, "multicast": 0, "sent": 2, "alone": 2, "bytes": 192},
{"name": s124, "unit": s6, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s19, "unit": s125, "multicast": 0, "sent": 1.208, "alone": 1.208, "bytes": 192},
{"name": s126, "unit": s6, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": s127, "unit": s6, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": s23, "unit": s125, "multicast": 0, "sent": 1.208, "alone": 1.208, "bytes": 188},
{"name": s32, "unit": s34, "multicast": 0, "sent": 1.08, "alone": 1.08, "bytes": 192},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 1.179, "alone": 1.179, "bytes": 188},
],
"inside": [],
"alone": s130,
"recovering": {
"kinds": {
"up": s128,
"down": s129,
"role": s131,
"informs": [1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": s132,
"answers": [-1, -1, 0, 11, 0, 0, 3, 1, 6, 4, 3, 1, 11, 1, 0, 12, 14, 12, 13, 12, 1, 0, 3, 21, 20, 22, 12, 26],
"when": s133,
"since": s134,
"to_unknown": s135,
"leg": s136,
"delay": s137,
},
"bursts": s138,
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 200000000, "topics": 8, "heartbeat": 13, "acknack": 16, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
"server": true,
},
},
"Fast DDS 3.6, a longer announcement interval": {
"messages": [
{"name": "SPDP", "unit": s6, "multicast": 1, "sent": 1, "alone": 1, "bytes": 632},
{"name": "SPDP unicast", "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 632},
{"name": s82, "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 632},
{"name": "SEDP", "unit": s2, "multicast": 0, "sent": 0.6318, "alone": 1, "bytes": 896.8584995251663},
s84,
{"name": s10, "unit": s4, "multicast": 0, "sent": 2.13, "alone": 2.13, "bytes": 184.3},
{"name": "ACKNACK", "unit": s4, "multicast": 0, "sent": 2, "alone": 2, "bytes": 189.6},
{"name": s86, "unit": s4, "multicast": 0, "sent": 2.204, "alone": 2.204, "bytes": 189.6},
{"name": s19, "unit": s4, "multicast": 0, "sent": 1.046, "alone": 1.046, "bytes": 192},
{"name": s23, "unit": s4, "multicast": 0, "sent": 1.083, "alone": 1.083, "bytes": 188},
{"name": s32, "unit": s34, "multicast": 0, "sent": 1.306, "alone": 1.306, "bytes": 178.8},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 1.633, "alone": 1.633, "bytes": 189},
{"name": s94, "unit": s4, "multicast": 0, "sent": 1.15, "alone": 1.15, "bytes": 459.4},
{"name": s28, "unit": s4, "multicast": 0, "sent": 2.2831941999999996, "alone": 2.303, "bytes": 189.68085535606212},
{"name": s29, "unit": s4, "multicast": 0, "sent": 2.5, "alone": 2.5, "bytes": 188},
{"name": "Type lookup", "unit": ["unknown type", s1], "multicast": 0, "sent": 0.9334211, "alone": 3.917, "bytes": 808.8594208980277},
{"name": "ROS Heartbeat", "unit": s4, "multicast": 0, "sent": 3.687, "alone": 3.687, "bytes": 178.8},
{"name": s95, "unit": s13, "multicast": 0, "sent": 0.1285, "alone": 0.1285, "bytes": 178.8},
{"name": "ROS ACKNACK", "unit": s4, "multicast": 0, "sent": 0.4578, "alone": 0.4578, "bytes": 189},
{"name": s96, "unit": s13, "multicast": 0, "sent": 0.2066, "alone": 0.2066, "bytes": 189},
],
"inside": [],
"alone": {"kinds": {"multicast": s139, "to_all": s139, "up": s140, "down": s140}, "bursts": {"messages": [[0], [2, 3, 4, 8, 13], [6, 9, 10, 14], [11], [12], [16, 17], [15, 18, 19], [0, 1, 5, 7], [0, 1]], "periods": s99, "times": s100}},
"recovering": {
"kinds": {
"multicast": s139,
"to_all": s139,
"up": s140,
"down": s140,
"role": [0, 0, 0, 1, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 0, 2, 2, 2, 1, 1, 1, 2, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1],
"answers": [-1, -1, 0, 0, 0, 3, 4, 5, 0, 8, 3, 10, 3, 0, 13, 3, 12, 12, 16, 17],
"when": [0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 0, 5000000, 5000000, 5000000, s46, s46, s46, 5000000, s46, s46, s46, s46, 5000000, s46, s46, s46, s46, s46, s46],
"to_unknown": s139,
"delay": [0, 0, 0, 1000000, 1000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": s103,
"repairs": s104,
},
},
"Zenoh, periods of Zenoh peer, static peers": {
"messages": [s3, {"name": "KeepAlive", "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 84}],
"inside": [],
"alone": {"kinds": s5, "bursts": {"messages": [[0], [1], [1]], "periods": [0, 0, 25000000], "times": [[0, 0], [2.5, 1], [5, 2]]}},
"recovering": {"refused": "recovery must be False for the protocol 'Zenoh, periods of Zenoh peer': it does not say how processes find each other, or, with a server on a host, which of its messages go to the server"},
},
"static endpoints, a longer announcement interval": {
"messages": [
{"name": "SPDP", "unit": s6, "multicast": 1, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": s80, "unit": s81, "multicast": 1, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": "SPDP of endpoints", "unit": s115, "multicast": 1, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": "SPDP unicast", "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": s82, "unit": s4, "multicast": 0, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": s83, "unit": s13, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 589.2},
{"name": "SPDP unicast of endpoints", "unit": s2, "multicast": 0, "sent": 0.6542, "alone": 0.6542, "bytes": 589.2},
{"name": "Listed", "unit": s115, "multicast": 1, "sent": 0, "alone": 1, "bytes": 59.47},
{"name": "Listed at discovery", "unit": s117, "multicast": 1, "sent": 0, "alone": 0.8987, "bytes": 59.47},
{"name": "Listed of endpoints", "unit": [s141, "all"], "multicast": 1, "sent": 0, "alone": 0.8987, "bytes": 59.47},
{"name": "Listed unicast", "unit": s2, "multicast": 0, "sent": 0, "alone": 1, "bytes": 59.47},
{"name": "Listed unicast at discovery", "unit": s2, "multicast": 0, "sent": 0, "alone": 0.9528, "bytes": 59.47},
{"name": "Listed unicast for others", "unit": s8, "multicast": 0, "sent": 0, "alone": 0.4764, "bytes": 59.47},
{"name": "Listed unicast of endpoints", "unit": [s141, s1], "multicast": 0, "sent": 0, "alone": 0.6233, "bytes": 59.47},
{"name": s19, "unit": s4, "multicast": 0, "sent": 1.167, "alone": 1.167, "bytes": 192},
{"name": s23, "unit": s4, "multicast": 0, "sent": 1.167, "alone": 1.167, "bytes": 188},
{"name": s32, "unit": s34, "multicast": 0, "sent": 1.33, "alone": 1.33, "bytes": 192},
{"name": "User ACKNACK", "unit": s34, "multicast": 0, "sent": 1.33, "alone": 1.33, "bytes": 188},
],
"inside": [[7, 0, 59.47], [8, 1, 59.47], [9, 2, 59.47], [10, 3, 59.47], [11, 4, 59.47], [12, 5, 59.47], [13, 6, 59.47]],
"alone": {
"kinds": {"multicast": s142, "to_all": s142, "up": s143, "down": s143},
"bursts": {"messages": [[0], [1, 2, 4, 5, 6, 8, 9, 11, 12, 13, 14], [7, 10, 15, 16], [17], [7, 10], [0, 3], [7, 10], [0, 3]], "periods": [0, 0, 0, 0, 0, 0, 30000000, 150000000], "times": [[0, 0], [0.05, 1], [0.1, 2], [0.17, 3], [0.2, 4], [0.3, 4], [0.4, 4], [0.5, 4], [1, 5], [3.5, 6], [16, 7]]},
},
"recovering": {
"kinds": {
"multicast": s142,
"to_all": s142,
"up": s143,
"down": s143,
"informs": [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0],
"trigger": [0, 2, 0, 0, 2, 2, 2, 0, 2, 0, 0, 2, 2, 2, 2, 1, 2, 1],
"answers": [-1, 0, -1, -1, 0, 0, 0, -1, 0, -1, -1, 0, 0, 0, 0, 14, 0, 16],
"when": [0, 1, 0, 0, 1, 1, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 0, 0],
"since": [0, 5000000, 0, 0, 5000000, 5000000, 5000000, 0, 5000000, 0, 0, 5000000, 5000000, 5000000, 5000000, s46, 5000000, s46],
"to_unknown": [1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0], [2, 9], [7, 10], [0, 3], [7, 10], [0, 3]], "periods": [0, 0, 0, 0, 30000000, 150000000], "times": [[0, 0], [0.05, 1], [0.1, 2], [0.2, 2], [0.3, 2], [0.4, 2], [0.5, 2], [1, 3], [3.5, 4], [16, 5]]},
"repairs": {"lease": 1000000000, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
},
},
"Zenoh peer, static peers": {
"messages": [
{"name": "InitSyn", "unit": s4, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 110},
s144,
s145,
s146,
{"name": "OAM", "unit": s4, "multicast": 0, "sent": 0.835, "alone": 1, "bytes": s147},
{"name": s148, "unit": s13, "multicast": 0, "sent": 0.521875, "alone": 0.625, "bytes": s147},
{"name": "Declare", "unit": s2, "multicast": 0, "sent": 0.09785, "alone": 0.5, "bytes": 106.65917220235053},
{"name": s149, "unit": s150, "multicast": 0, "sent": 0.40185, "alone": 0.5, "bytes": s151},
{"name": s152, "unit": s34, "multicast": 0, "sent": 0.40185, "alone": 0.5, "bytes": s151},
{"name": "Declare final", "unit": s4, "multicast": 0, "sent": 0.05, "alone": 1, "bytes": 176},
{"name": "Frame", "unit": s4, "multicast": 0, "sent": 0.2478, "alone": 1, "bytes": s153},
{"name": s154, "unit": s2, "multicast": 0, "sent": 0.15073673999999998, "alone": 0.6083, "bytes": s153},
s156,
s157,
{"name": "TCP ACK", "unit": s4, "multicast": 0, "sent": s158, "alone": s158, "bytes": 76},
{"name": s159, "unit": s4, "multicast": 0, "sent": 2.496, "alone": 2.496, "bytes": 76},
{"name": s160, "unit": s2, "multicast": 0, "sent": 0.2188, "alone": 0.2188, "bytes": 76},
],
"inside": [],
"alone": {"kinds": {"up": s102, "down": s102}, "bursts": {"messages": [[0, 1, 2, 3, 13], [4, 5, 6, 7, 8, 9, 10, 11, 15, 16], [12, 14], [12, 14]], "periods": s161, "times": s162}},
"recovering": {"refused": "recovery must be False for the protocol 'Zenoh peer': it does not say how processes find each other, or, with a server on a host, which of its messages go to the server"},
},
"Zenoh peer, tokens, static peers": {
"messages": [
{"name": "InitSyn", "unit": s4, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 109.86},
s144,
s145,
s146,
{"name": "OAM", "unit": s4, "multicast": 0, "sent": 0.7058, "alone": 1, "bytes": s163},
{"name": s148, "unit": s13, "multicast": 0, "sent": 0.45827594, "alone": 0.6493, "bytes": s163},
{"name": "Declare", "unit": s2, "multicast": 0, "sent": 0.03275, "alone": 0.5, "bytes": 167.6030534351145},
{"name": "Declare token", "unit": s2, "multicast": 0, "sent": 0.0603, "alone": 1, "bytes": s164},
{"name": "Declare token of node", "unit": s4, "multicast": 0, "sent": 0.0603, "alone": 1, "bytes": s164},
{"name": s149, "unit": s150, "multicast": 0, "sent": 0.8957999999999999, "alone": 1.5, "bytes": s165},
{"name": s152, "unit": s34, "multicast": 0, "sent": 1.4929999999999999, "alone": 2.5, "bytes": s165},
{"name": "Declare key expression of node", "unit": s4, "multicast": 0, "sent": 0.5972, "alone": 1, "bytes": s165},
{"name": "Declare final", "unit": s4, "multicast": 0, "sent": 0.06, "alone": 1, "bytes": 159.33333333333334},
{"name": "Frame", "unit": s4, "multicast": 0, "sent": 0.2704, "alone": 2, "bytes": s166},
{"name": s154, "unit": s2, "multicast": 0, "sent": 0.1352, "alone": 1, "bytes": s166},
s156,
s157,
{"name": "TCP ACK", "unit": s4, "multicast": 0, "sent": s167, "alone": s167, "bytes": 76},
{"name": s159, "unit": s4, "multicast": 0, "sent": 3.325, "alone": 3.325, "bytes": 76},
{"name": s160, "unit": s2, "multicast": 0, "sent": 0.4208, "alone": 0.4208, "bytes": 76},
],
"inside": [],
"alone": {"kinds": {"up": s140, "down": s140}, "bursts": {"messages": [[0, 1, 2, 3, 16], [4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 18, 19], [15, 17], [15, 17]], "periods": s161, "times": s162}},
"recovering": {"refused": "recovery must be False for the protocol 'Zenoh peer, tokens': it does not say how processes find each other, or, with a server on a host, which of its messages go to the server"},
},
},
"radios": {
"802.11n 20 MHz 2x2, multicast 24 Mbit/s": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 400,
"symbol": 36,
"grid": 40,
"bits": 520,
"added": 22,
"addba": 760,
"basic_ack": 440,
"mpdus": 1,
"window": 1,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": false,
"fast": s170,
"slow": s171,
},
"802.11a 20 MHz 1x1, multicast 24 Mbit/s": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 200,
"symbol": 40,
"grid": 40,
"bits": 216,
"added": 22,
"addba": 760,
"basic_ack": 440,
"mpdus": 1,
"window": 1,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": false,
"fast": {"bits": 216, "added": 22, "symbol": 40, "grid": 40, "preamble": 200},
"slow": s171,
},
"802.11g 20 MHz 1x1, multicast 24 Mbit/s": {
"record": {
"slot": 90,
"sifs": 100,
"aifs": 280,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"timeout": 390,
"eifs_extra": 600,
"ack": 340,
"block_ack": 380,
"bar": 380,
"preamble": 260,
"symbol": 40,
"grid": 40,
"bits": 216,
"added": 22,
"addba": 820,
"basic_ack": 500,
"mpdus": 1,
"window": 1,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": false,
"fast": {"bits": 216, "added": 22, "symbol": 40, "grid": 40, "preamble": 260},
"slow": s172,
},
"802.11n 20 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 400,
"symbol": 36,
"grid": 40,
"bits": 520,
"added": 22,
"addba": 760,
"basic_ack": 440,
"mpdus": 64,
"max_bytes": 65535,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": s170,
"slow": s171,
},
"802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 100,
"aifs": 280,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 390,
"eifs_extra": 600,
"ack": 340,
"block_ack": 380,
"bar": 380,
"preamble": 460,
"symbol": 36,
"grid": 40,
"bits": 520,
"added": 22,
"addba": 820,
"basic_ack": 500,
"mpdus": 64,
"max_bytes": 65535,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": {"bits": 520, "added": 22, "symbol": 36, "grid": 40, "preamble": 460},
"slow": s172,
},
"802.11n 40 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 400,
"symbol": 36,
"grid": 40,
"bits": 1080,
"added": 22,
"addba": 760,
"basic_ack": 440,
"mpdus": 64,
"max_bytes": 65535,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": {"bits": 1080, "added": 22, "symbol": 36, "grid": 40, "preamble": 400},
"slow": s171,
},
"802.11ac 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 440,
"symbol": 36,
"grid": 40,
"bits": 3120,
"added": 28,
"addba": 760,
"basic_ack": 440,
"mpdus": 64,
"max_bytes": 589286,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": {"bits": 3120, "added": 28, "symbol": 36, "grid": 40, "preamble": 440},
"slow": s171,
},
"802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 100,
"aifs": 280,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 390,
"eifs_extra": 600,
"ack": 340,
"block_ack": 380,
"bar": 380,
"preamble": 564,
"symbol": 136,
"grid": 136,
"bits": 3900,
"added": 16,
"addba": 820,
"basic_ack": 500,
"mpdus": 64,
"max_bytes": 194510,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": {"bits": 3900, "added": 16, "symbol": 136, "grid": 136, "preamble": 564},
"slow": s172,
},
"802.11ax 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 504,
"symbol": 136,
"grid": 136,
"bits": 16333,
"added": 16,
"addba": 760,
"basic_ack": 440,
"mpdus": 64,
"max_bytes": 814606,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": {"bits": 16333, "added": 16, "symbol": 136, "grid": 136, "preamble": 504},
"slow": s171,
},
"802.11ax 160 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 504,
"symbol": 136,
"grid": 136,
"bits": 32666,
"added": 16,
"addba": 760,
"basic_ack": 440,
"mpdus": 64,
"max_bytes": 1629214,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": {"bits": 32666, "added": 16, "symbol": 136, "grid": 136, "preamble": 504},
"slow": s171,
},
"802.11be 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 584,
"symbol": 136,
"grid": 136,
"bits": 19600,
"added": 16,
"addba": 760,
"basic_ack": 440,
"mpdus": 64,
"max_bytes": 975098,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": {"bits": 19600, "added": 16, "symbol": 136, "grid": 136, "preamble": 584},
"slow": s171,
},
"802.11be 320 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 340,
"cw_min": 15,
"cw_max": 1023,
"attempts": 7,
"edca": 1,
"timeout": 450,
"eifs_extra": 600,
"ack": 280,
"block_ack": 320,
"bar": 320,
"preamble": 584,
"symbol": 136,
"grid": 136,
"bits": 78400,
"added": 16,
"addba": 760,
"basic_ack": 440,
"mpdus": 64,
"max_bytes": 3900398,
"window": 64,
"capture_threshold": s168,
"capture_threshold_basic": s169,
},
"aggregates": true,
"fast": {"bits": 78400, "added": 16, "symbol": 136, "grid": 136, "preamble": 584},
"slow": s171,
},
},
};
Object.assign(LIVE_TABLES.tables, tables);
Object.assign(LIVE_TABLES.radios, radios);
})();
