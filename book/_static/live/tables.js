// What a run is set up from; made from the package by `make live`; do not edit.
const LIVE_TABLES = (() => {
const s1 = 4611686018427387904;
const s2 = ["process", "all"];
const s3 = {"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 414};
const s4 = "remote process";
const s5 = ["endpoint", s4];
const s6 = {"name": "SEDP", "unit": s5, "multicast": 0, "sent": 1, "alone": 1, "bytes": 464};
const s7 = ["process", s4];
const s8 = {"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 116};
const s9 = {"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 114};
const s10 = {"multicast": [1, 0, 0, 0], "to_all": [1, 0, 0, 0], "up": [1, 1, 1, 1], "down": [1, 1, 1, 1]};
const s11 = {"kinds": s10, "bursts": {"messages": [[0, 1, 2, 3]], "periods": [0], "times": [[0, 0]]}};
const s12 = [0, s1, s1, s1];
const s13 = {"messages": [[0]], "periods": [0], "times": [[0, 0]]};
const s14 = {"name": "Scout", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 80};
const s15 = {"name": "Hello", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 144};
const s16 = {"name": "Declare", "unit": s5, "multicast": 0, "sent": 1, "alone": 1, "bytes": 176};
const s17 = 972.4761045987376;
const s18 = ["endpoint", s4, "third process"];
const s19 = 154.45158821278227;
const s20 = "Heartbeat of data";
const s21 = 187.0099502487562;
const s22 = "ACKNACK for others";
const s23 = ["process", s4, "third process"];
const s24 = 179.99005799502902;
const s25 = {"name": "Liveliness", "unit": s7, "multicast": 0, "sent": 0.7242, "alone": 1, "bytes": s24};
const s26 = "Liveliness at start";
const s27 = 190.54725731648807;
const s28 = "Liveliness for others";
const s29 = "Liveliness Heartbeat";
const s30 = 180.02610587382162;
const s31 = {"name": s29, "unit": s7, "multicast": 0, "sent": 0.2758, "alone": 1, "bytes": s30};
const s32 = "Liveliness Heartbeat at start";
const s33 = "Liveliness ACKNACK";
const s34 = {"name": s33, "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 128};
const s35 = "Liveliness ACKNACK at start";
const s36 = 181.3784494086728;
const s37 = "Liveliness ACKNACK for others";
const s38 = "Type lookup Heartbeat";
const s39 = "Type lookup ACKNACK";
const s40 = 195.20030291556228;
const s41 = "Type lookup ACKNACK for others";
const s42 = "User Heartbeat";
const s43 = "matched writer";
const s44 = [s43, s4];
const s45 = 139.31615175284134;
const s46 = "User Heartbeat for others";
const s47 = [s43, s4, "third process"];
const s48 = 182.43195266272187;
const s49 = "User ACKNACK for others";
const s50 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s51 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s52 = [3, 4, 5, 6, 7, 8, 10, 11, 13, 15, 16, 17, 18, 19];
const s53 = [0, 0, 0, 0, 0, 80000000, 80000000];
const s54 = [[0, 0], [0.05, 1], [0.1, 2], [1, 3], [2, 3], [3, 3], [8, 4], [8.1, 5], [16, 6]];
const s55 = {"kinds": {"multicast": s50, "to_all": s50, "up": s51, "down": s51}, "bursts": {"messages": [[0, 2], s52, [0, 1, 20, 21, 22, 23], [2], [9, 12, 14], [0, 1], [9, 12, 14]], "periods": s53, "times": s54}};
const s56 = [0, 0, 0, 80000000, 80000000];
const s57 = {"heartbeat_period_initial": 1000000, "heartbeat_period_max": 80000000, "lease": 100000000, "topics": 1, "heartbeat": 5, "acknack": 7, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000};
const s58 = {
"kinds": {
"multicast": s50,
"to_all": s50,
"up": s51,
"down": s51,
"role": [0, 0, 0, 1, 0, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 0, 2, 2, 1, 2, 1, 1, 1, 0, 2, 2, 0, 2, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1],
"answers": [-1, -1, 0, 0, 7, 0, 3, 5, 5, -1, 0, 0, -1, 0, 12, 13, 13, 0, 17, 17, 3, 3, 20, 21],
"when": [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 0, 500000, 500000, s1, 500000, s1, s1, s1, 0, 500000, 500000, 0, 500000, 120000000, s1, s1, 500000, s1, s1, s1, s1, s1, s1],
"to_unknown": s50,
"gap_first": [0, 0, 10000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"gap_number": [0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0], [0, 1], [9, 12], [0, 1], [9, 12]], "periods": s56, "times": [[0, 0], [0.1, 1], [8, 2], [8.1, 3], [16, 4]]},
"repairs": s57,
};
const s59 = {"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 476};
const s60 = "SEDP multicast";
const s61 = "Heartbeat multicast";
const s62 = 199.39703903095557;
const s63 = "Liveliness unicast";
const s64 = "Liveliness Heartbeat unicast";
const s65 = 187.1920199501247;
const s66 = "Type lookup Heartbeat unicast";
const s67 = "User Heartbeat multicast";
const s68 = [1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
const s69 = {"kinds": {"multicast": s68, "to_all": s68, "up": s51, "down": s51}, "bursts": {"messages": [[0, 1], [2, 3, 4, 5, 6, 7, 9, 10, 12, 13, 15, 16, 17, 18, 19, 20], [0, 21, 22, 23], [1], [8, 11, 14], [0], [8, 11, 14]], "periods": s53, "times": s54}};
const s70 = [0, 0, 80000000, 80000000];
const s71 = [[0, 0], [0.1, 0], [8, 1], [8.1, 2], [16, 3]];
const s72 = {
"kinds": {
"multicast": s68,
"to_all": s68,
"up": s51,
"down": s51,
"role": [0, 0, 1, 1, 0, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 2, 2, 2, 2, 2, 1, 1, 0, 2, 2, 0, 2, 2, 1, 1, 1, 2, 2, 1, 1, 1, 1, 1],
"answers": [-1, 0, 0, 0, 0, 2, 5, 5, -1, 0, 0, -1, 0, 0, 11, 12, 12, 0, 0, 17, 17, 2, 2, 21],
"when": [0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 500000, 500000, 500000, 500000, s1, s1, s1, 0, 500000, 500000, 0, 500000, 500000, 120000000, s1, s1, 500000, 500000, s1, s1, s1, s1, s1],
"to_unknown": s50,
"gap_first": [0, 10000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"gap_number": [0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0], [8, 11], [0], [8, 11]], "periods": s70, "times": s71},
"repairs": {"heartbeat_period_initial": 1000000, "heartbeat_period_max": 80000000, "lease": 100000000, "topics": 1, "heartbeat": 5, "acknack": 6, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
};
const s73 = 726.2444541104828;
const s74 = 153.93607305936075;
const s75 = 186.8277247614264;
const s76 = 187.05568338702255;
const s77 = 190.87976752633492;
const s78 = 204.12578616352204;
const s79 = 133.94982078853047;
const s80 = 167.8055937643283;
const s81 = ["process", "other host"];
const s82 = ["host", "other host"];
const s83 = 150.13620569840168;
const s84 = 191.25372354324537;
const s85 = 170.0050484920951;
const s86 = 190.60377358490564;
const s87 = 185.2367491166078;
const s88 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s89 = 200.7060146149522;
const s90 = 186.30392156862746;
const s91 = 210.50383141762453;
const s92 = "SPDP to server";
const s93 = "SPDP of server";
const s94 = "SPDP of server at discovery";
const s95 = 748.3930635838151;
const s96 = "SPDP of others";
const s97 = ["process", "other process", "match"];
const s98 = 683.9365973934484;
const s99 = "SPDP Heartbeat";
const s100 = "SPDP Heartbeat of server";
const s101 = 1.2934822999999998;
const s102 = 250.29586195342605;
const s103 = "SPDP Heartbeat of others";
const s104 = 354.98051539912007;
const s105 = "SPDP ACKNACK of others";
const s106 = "SPDP ACKNACK of server";
const s107 = 204.14209591474247;
const s108 = "SEDP to server";
const s109 = ["endpoint", "all"];
const s110 = "SEDP of others";
const s111 = ["matched endpoint", "other process"];
const s112 = 655.9962112242481;
const s113 = "Heartbeat of server";
const s114 = "Heartbeat of others";
const s115 = 451.4893977947413;
const s116 = "ACKNACK of others";
const s117 = "ACKNACK of server";
const s118 = 0.44105099999999997;
const s119 = 205.97133664814274;
const s120 = "Liveliness Heartbeat to server";
const s121 = "Liveliness Heartbeat of server";
const s122 = ["process", s4, "match"];
const s123 = {"name": s29, "unit": s122, "multicast": 0, "sent": 1.292, "alone": 1.292, "bytes": 192};
const s124 = "Liveliness ACKNACK to server";
const s125 = "Liveliness ACKNACK of server";
const s126 = {"name": s33, "unit": s122, "multicast": 0, "sent": 1.292, "alone": 1.292, "bytes": 188};
const s127 = {"name": s42, "unit": s44, "multicast": 0, "sent": 1.021, "alone": 1.021, "bytes": 192};
const s128 = {"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 1.021, "alone": 1.021, "bytes": 188};
const s129 = [1, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 1, 0, 1, 1, 1];
const s130 = [0, 1, 1, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1, 1, 1, 1];
const s131 = {
"messages": [[0], [2, 4, 5, 9], [0, 7], [0, 3, 6, 10, 11, 12, 13, 14, 15, 19, 20, 21], [8, 16, 17, 18, 22, 23, 24, 26], [25, 27], [1], [0], [1]],
"periods": [0, 0, 0, 0, 0, 0, 0, 30000000, 30000000],
"times": [[0, 0], [0.05, 1], [0.1, 2], [0.2, 0], [0.3, 0], [0.4, 0], [0.5, 3], [0.6, 4], [0.7, 5], [1.5, 6], [3.5, 7], [4.5, 8]],
};
const s132 = {"kinds": {"to_all": [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 0, 0, 0], "up": s129, "down": s130}, "bursts": s131};
const s133 = [0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 3, 3, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s134 = [0, 0, 2, 2, 2, 2, 2, 2, 1, 1, 2, 2, 2, 2, 2, 2, 1, 1, 1, 2, 2, 2, 2, 1, 1, 1, 1, 1];
const s135 = [0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s136 = [0, 0, 500000, s1, 500000, 500000, s1, 30000000, s1, s1, s1, 30000000, s1, 30000000, 500000, s1, s1, s1, s1, s1, 30000000, 500000, s1, s1, s1, s1, s1, s1];
const s137 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s138 = [1, 2, 2, 3, 1, 2, 3, 1, 4, 2, 3, 1, 3, 1, 2, 3, 1, 4, 2, 3, 1, 2, 0, 1, 2, 0, 0, 0];
const s139 = [0, 0, 0, 0, 0, 0, 0, 500000, 0, 0, 0, 4500000, 0, 4500000, 4500000, 0, 0, 0, 0, 0, 4500000, 4500000, 0, 0, 0, 0, 0, 0];
const s140 = {"messages": [[0], [1], [0], [1]], "periods": [0, 0, 30000000, 30000000], "times": [[0, 0], [0.1, 0], [0.2, 0], [0.3, 0], [0.4, 0], [0.5, 0], [1.5, 1], [3.5, 2], [4.5, 3]]};
const s141 = ["process", "server"];
const s142 = ["process", "server", "matched process"];
const s143 = ["matched endpoint of others", "server"];
const s144 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s145 = "SPDP at discovery";
const s146 = ["process", "other process"];
const s147 = "SPDP unicast at discovery";
const s148 = "SPDP unicast for others";
const s149 = {"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 184.3};
const s150 = "Heartbeat for others";
const s151 = "ACKNACK of data";
const s152 = [1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s153 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s154 = [1, 3, 4, 5, 6, 12];
const s155 = [0, 2, 9, 13, 14];
const s156 = [0, 0, 30000000];
const s157 = [[0, 0], [0.1, 1], [0.2, 1], [0.3, 1], [0.4, 1], [0.5, 1], [3.5, 2]];
const s158 = {"messages": [[0], [0, 2], [0, 2]], "periods": s156, "times": s157};
const s159 = "ROS discovery info";
const s160 = "ROS Heartbeat for others";
const s161 = "ROS ACKNACK for others";
const s162 = [1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s163 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s164 = [0, 0, 0, 0, 0, 0, 0, 0, 0, 30000000];
const s165 = [[0, 0], [0.05, 1], [0.1, 2], [0.17, 3], [0.2, 4], [0.25, 5], [0.3, 6], [0.4, 7], [0.5, 7], [1, 8], [3.5, 9]];
const s166 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s167 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s168 = {"messages": [[0], [0, 1], [0, 1]], "periods": s156, "times": s157};
const s169 = {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 200000000, "topics": 2, "heartbeat": 4, "acknack": 6, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000, "nack_response_delay": 1000000};
const s170 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s171 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s172 = {"multicast": s170, "to_all": s170, "up": s171, "down": s171};
const s173 = {"name": "Announce", "unit": ["host", "all"], "multicast": 1, "sent": 1, "alone": 1, "bytes": 80};
const s174 = {"name": "Process", "unit": s2, "multicast": 1, "sent": 0, "alone": 1, "bytes": 24};
const s175 = ["fleet", "all"];
const s176 = {"name": "Digest", "unit": s175, "multicast": 1, "sent": 1, "alone": 1, "bytes": 80};
const s177 = {"name": "Listed", "unit": ["host", "all"], "multicast": 1, "sent": 0, "alone": 1, "bytes": 1};
const s178 = {"name": "Heartbeat", "unit": ["host", "all"], "multicast": 1, "sent": 1, "alone": 1, "bytes": 80};
const s179 = {"name": "Claimed", "unit": s82, "multicast": 1, "sent": 0, "alone": 1, "bytes": 0.125};
const s180 = [1, 1, 1, 1, 1, 1, 1];
const s181 = [[0, 0], [3, 1], [6, 2]];
const s182 = [1, 0, 0, 0, 0, 0, 0];
const s183 = {"announce_interval_initial": 30000000, "announce_interval_max": 30000000, "lease": 230000000, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000};
const s184 = [1, 1, 1, 1, 1, 1, 1, 1];
const s185 = [0, 1, 2, 3, 4, 5];
const s186 = [0, 0, 25000000, 80000000];
const s187 = [[0, 0], [1, 0], [2.5, 1], [3, 0], [5, 2], [7, 0], [15, 3]];
const s188 = {"lease": 100000000, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000};
const s189 = ["endpoint", "other process"];
const s190 = "listed endpoint";
const s191 = [1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0];
const s192 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s193 = {"name": "Scout", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 67};
const s194 = {"name": "Hello", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 104};
const s195 = {"name": "InitAck", "unit": s7, "multicast": 0, "sent": 0.6667, "alone": 0.6667, "bytes": 153};
const s196 = {"name": "OpenSyn", "unit": s7, "multicast": 0, "sent": 0.6667, "alone": 0.6667, "bytes": 134};
const s197 = {"name": "OpenAck", "unit": s7, "multicast": 0, "sent": 0.6667, "alone": 0.6667, "bytes": 84};
const s198 = 163.4251497005988;
const s199 = "OAM for others";
const s200 = "Declare key expression";
const s201 = "unmatched endpoint";
const s202 = [s201, s4];
const s203 = 229.04217991787982;
const s204 = "Declare key expression of matching";
const s205 = 112.31961259079904;
const s206 = "Frame of endpoints";
const s207 = {"name": "KeepAlive", "unit": s7, "multicast": 0, "sent": 1.333, "alone": 1.333, "bytes": 79};
const s208 = {"name": "TCP control", "unit": s7, "multicast": 0, "sent": 1.333, "alone": 1.333, "bytes": 76};
const s209 = "TCP ACK at start";
const s210 = "TCP ACK of endpoints";
const s211 = [0, 0, 0, 0, 0, 25000000, 80000000];
const s212 = [[0, 0], [0.05, 1], [0.1, 2], [1, 3], [2.5, 4], [3, 3], [5, 5], [7, 3], [15, 6]];
const s213 = 179.4287333522244;
const s214 = 175.50248756218906;
const s215 = "Declare token of node";
const s216 = 362.8385800401876;
const s217 = "Declare key expression of node";
const s218 = 142.56804733727813;
const s219 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s220 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s221 = 154.5017382527756;
const s222 = 192.6407465007776;
const s223 = 358.9464799539613;
const s224 = [s201, "all"];
const s225 = 137.8131868131868;
const s226 = 282.5695792880259;
const s227 = 622.248870141609;
const s228 = 148.72727272727272;
const s229 = 156.64516129032256;
const s230 = "KeepAlive down";
const s231 = "TCP ACK at start down";
const s232 = "TCP ACK of endpoints down";
const s233 = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s234 = [1, 0, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 0, 0];
const s235 = [0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 0, 1, 0, 0, 0, 1, 1];
const s236 = [28, 29, 30, 31];
const s237 = [0, 0, 0, 0, 300000000];
const s238 = [[0, 0], [0.05, 1], [0.1, 2], [30, 3], [60, 4]];
const s239 = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s240 = [0, 0, 300000000];
const s241 = [[0, 0], [30, 1], [60, 2]];
const s242 = {"announce_interval_initial": 10000000, "announce_interval_max": 40000000, "lease": 600000000, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000};
const s243 = 1523.8764478764479;
const s244 = ["host", "other host", "third host"];
const s245 = 1523.7329974811084;
const s246 = "Frame of gossip";
const s247 = 86.42028482111844;
const s248 = ["endpoint", "other host"];
const s249 = [s201, "other host"];
const s250 = "Declare of matching";
const s251 = "matched endpoint of a host";
const s252 = [s251, "other host"];
const s253 = 1523.275922671353;
const s254 = "Declare key expression of tokens";
const s255 = 1524.2088308803109;
const s256 = 86.11918147065437;
const s257 = [s251, "all"];
const s258 = 1524.6626402070751;
const s259 = 1523.8867459991793;
const s260 = 1523.9638009049772;
const s261 = [1, 0, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
const s262 = [0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1];
const s263 = [18, 19, 33, 34];
const s264 = 158.48931924611142;
const s265 = 2.51188643150958;
const s266 = {"bits": 520, "added": 22, "symbol": 36, "grid": 40, "preamble": 400};
const s267 = {"bits": 24, "added": 22, "symbol": 40, "grid": 40, "preamble": 200};
const s268 = {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s266,
"slow": s267,
};
const s269 = {"bits": 1, "added": 0, "symbol": 10, "grid": 10, "preamble": 1920};
const s270 = {"bits": 520, "added": 22, "symbol": 36, "grid": 40, "preamble": 460};
const s271 = {"bits": 1080, "added": 22, "symbol": 36, "grid": 40, "preamble": 400};
const s272 = {"bits": 3120, "added": 28, "symbol": 36, "grid": 40, "preamble": 440};
const s273 = {"bits": 3900, "added": 16, "symbol": 136, "grid": 136, "preamble": 564};
const s274 = {"bits": 16333, "added": 16, "symbol": 136, "grid": 136, "preamble": 504};
const s275 = {"bits": 32666, "added": 16, "symbol": 136, "grid": 136, "preamble": 504};
const s276 = {"bits": 19600, "added": 16, "symbol": 136, "grid": 136, "preamble": 584};
const s277 = {"bits": 78400, "added": 16, "symbol": 136, "grid": 136, "preamble": 584};
return {
"layouts": {
"radio": {
"size": 216,
"fields": {
"slot": [0, "i8"],
"sifs": [8, "i8"],
"aifs": [16, "i8"],
"cw_min": [24, "i8"],
"cw_max": [32, "i8"],
"attempts": [40, "i8"],
"edca": [48, "i8"],
"timeout": [56, "i8"],
"eifs_extra": [64, "i8"],
"ack": [72, "i8"],
"block_ack": [80, "i8"],
"bar": [88, "i8"],
"preamble": [96, "i8"],
"symbol": [104, "i8"],
"grid": [112, "i8"],
"bits": [120, "i8"],
"added": [128, "i8"],
"addba": [136, "i8"],
"basic_ack": [144, "i8"],
"mpdus": [152, "i8"],
"max_bytes": [160, "i8"],
"min_subframe": [168, "i8"],
"window": [176, "i8"],
"queue": [184, "i8"],
"lifetime": [192, "i8"],
"capture_threshold": [200, "f8"],
"capture_threshold_basic": [208, "f8"],
},
},
"state": {
"size": 472,
"fields": {
"clock": [0, "i8"],
"base": [8, "i8"],
"slot": [16, "i8"],
"idle": [24, "i8"],
"ahead": [32, "i8"],
"waiting": [40, "i8"],
"deferred": [48, "i8"],
"deferred_time": [56, "i8"],
"events": [64, "i8"],
"free": [72, "i8"],
"spare": [80, "i8"],
"open": [88, "i8"],
"coming": [96, "i8"],
"drained": [104, "i8"],
"queued": [112, "i8"],
"sample": [120, "i8"],
"step": [128, "i8"],
"samples": [136, "i8"],
"logged": [144, "i8"],
"random": [152, "i8"],
"hosts": [160, "i8"],
"links": [168, "i8"],
"kinds": [176, "i8"],
"per_receiver": [184, "i8"],
"finished": [192, "i8"],
"pairs": [200, "i8"],
"converged": [208, "i8"],
"repairs": [216, "i8"],
"expected": [224, "i8"],
"arrived": [232, "i8"],
"host_full": [240, "i8"],
"host_age": [248, "i8"],
"host_retry": [256, "i8"],
"ap_full": [264, "i8"],
"ap_age": [272, "i8"],
"ap_retry": [280, "i8"],
"on_air": [288, "i8"],
"ppdus": [296, "i8"],
"mpdus": [304, "i8"],
"retried": [312, "i8"],
"collisions": [320, "i8"],
"collided": [328, "i8"],
"requests": [336, "i8"],
"busy": [344, "i8"],
"wasted": [352, "i8"],
"expired": [360, "i8"],
"cold": [368, "i8"],
"addba_frames": [376, "i8"],
"unlike": [384, "i8"],
"overlapping": [392, "i8"],
"others": [400, "i8"],
"damaged": [408, "i8"],
"stamp": [416, "i8"],
"most": [424, "i8"],
"progress": [432, "i8"],
"patience": [440, "i8"],
"cells": [448, "i8"],
"here": [456, "i8"],
"rows_at": [464, "i8"],
},
},
"channels": {"size": 88, "fields": {"base": [0, "i8"], "slot": [8, "i8"], "idle": [16, "i8"], "ahead": [24, "i8"], "waiting": [32, "i8"], "deferred": [40, "i8"], "deferred_time": [48, "i8"], "per_receiver": [56, "i8"], "cold": [64, "i8"], "hosts": [72, "i8"], "next": [80, "i8"]}},
"stations": {
"size": 192,
"fields": {
"held": [0, "i4"],
"failures": [4, "i4"],
"waits": [8, "i4"],
"begun": [12, "i4"],
"times": [16, "i4"],
"number": [20, "i4"],
"length": [24, "i8"],
"made": [32, "i8"],
"last": [40, "i8"],
"missed": [48, "i8"],
"head": [56, "i8"],
"tail": [64, "i8"],
"following": [72, "i8"],
"send_slot": [80, "i8"],
"to_head": [88, "i8"],
"to_tail": [96, "i8"],
"processes": [104, "i8"],
"first": [112, "i8"],
"loss": [120, "f8"],
"sent": [128, "i4"],
"bar_pending": [132, "i4"],
"stage": [136, "i8"],
"process": [144, "i8"],
"steps": [152, "i8"],
"there": [160, "i8"],
"kind": [168, "i8"],
"sought": [176, "i8"],
"to_number": [184, "i4"],
"passed": [188, "i4"],
},
},
"window": {"size": 32, "fields": {"frame": [0, "i8"], "came": [8, "i8"], "number": [16, "i8"], "tries": [24, "i8"]}},
"deferred": {"size": 32, "fields": {"station": [0, "i8"], "base": [8, "i8"], "left": [16, "i8"], "time": [24, "i8"]}},
"senders": {"size": 40, "fields": {"station": [0, "i8"], "end": [8, "i8"], "base": [16, "i8"], "slots": [24, "i8"], "frame": [32, "i8"]}},
"pool": {"size": 40, "fields": {"frame": [0, "i8"], "came": [8, "i8"], "next": [16, "i8"], "same": [24, "i8"], "number": [32, "i4"], "tries": [36, "i4"]}},
"block_acks": {"size": 40, "fields": {"state": [0, "i8"], "request": [8, "i8"], "response": [16, "i8"], "request_tries": [24, "i8"], "response_tries": [32, "i8"]}},
"addba": {"size": 16, "fields": {"waiting": [0, "i8"], "sends": [8, "i8"]}},
"events": {"size": 16, "fields": {"time": [0, "i8"], "what": [8, "i8"]}},
"kinds": {
"size": 192,
"fields": {
"octets": [0, "i8"],
"multicast": [8, "i8"],
"to_all": [16, "i8"],
"up": [24, "i8"],
"down": [32, "i8"],
"set": [40, "i8"],
"whole": [48, "i8"],
"time_up": [56, "i8"],
"time_down": [64, "i8"],
"role": [72, "i8"],
"informs": [80, "i8"],
"of_host": [88, "i8"],
"trigger": [96, "i8"],
"answers": [104, "i8"],
"when": [112, "i8"],
"since": [120, "i8"],
"tcp": [128, "i8"],
"to_unknown": [136, "i8"],
"gap_first": [144, "i8"],
"gap_number": [152, "i8"],
"user": [160, "i8"],
"leg": [168, "i8"],
"to_host": [176, "i8"],
"delay": [184, "i8"],
},
},
"processes": {"size": 48, "fields": {"host": [0, "i8"], "start": [8, "i8"], "announce": [16, "i8"], "heartbeat": [24, "i8"], "heartbeat_active": [32, "i8"], "mute": [40, "i8"]}},
"repairs": {
"size": 104,
"fields": {
"announce_interval_initial": [0, "i8"],
"announce_interval_max": [8, "i8"],
"heartbeat_period_initial": [16, "i8"],
"heartbeat_period_max": [24, "i8"],
"lease": [32, "i8"],
"topics": [40, "i8"],
"heartbeat": [48, "i8"],
"acknack": [56, "i8"],
"rto_first": [64, "i8"],
"rto_min": [72, "i8"],
"rto_max": [80, "i8"],
"server": [88, "i8"],
"nack_response_delay": [96, "i8"],
},
},
"pairs": {"size": 88, "fields": {"discovered": [0, "i8"], "last_heard": [8, "i8"], "missing": [16, "i8"], "completed_at": [24, "i8"], "announced_at": [32, "i8"], "acknowledged": [40, "i8"], "rto": [48, "i8"], "expires_at": [56, "i8"], "srtt": [64, "i8"], "rttvar": [72, "i8"], "due": [80, "i8"]}},
"queue_samples": {"size": 24, "fields": {"time": [0, "i8"], "hosts": [8, "i8"], "access_point": [16, "i8"]}},
"log": {"size": 48, "fields": {"start": [0, "i8"], "end": [8, "i8"], "station": [16, "i8"], "kind": [24, "i8"], "frames": [32, "i8"], "outcome": [40, "i8"]}},
},
"arrays": {
"radio": "radio",
"state": "state",
"channels": "channels",
"cell_of": "i8",
"stations": "stations",
"window": "window",
"ordered": "i8",
"wheel": "i4",
"behind": "i4",
"deferred": "deferred",
"senders": "senders",
"pool": "pool",
"block_acks": "block_acks",
"addba": "addba",
"events": "events",
"kinds": "kinds",
"bursts": "i8",
"processes": "processes",
"each": "f8",
"to_all": "f8",
"part": "f8",
"receivers_before": "i8",
"power": "f8",
"repairs": "repairs",
"pairs": "pairs",
"received_bitmap": "i8",
"delays": "i8",
"airtime": "i8",
"queue_samples": "queue_samples",
"log": "log",
},
"constants": {
"SEND": 0n,
"ANNOUNCE": 72057594037927936n,
"LEASE_CHECK": 216172782113783808n,
"NEVER": s1,
"TICK": 1e-07,
"KIND_BITS": 6,
"PROCESS_BITS": 20,
"ITEM_BITS": 14,
"OCTETS": 65535,
"DATA": 1,
"TO_SERVER": 1,
"FROM_SERVER": 2,
"PASSED_ON": 3,
"QUEUE_SAMPLES": 512,
"LOG": 4096,
"POOL": 4096,
"OVER": 0,
"MEMORY": 1,
"CAUSES": ["host_full", "host_age", "host_retry", "ap_full", "ap_age", "ap_retry", "on_air"],
},
"tables": {
"DDS": {
"messages": [s3, s6, s8, s9],
"inside": [],
"alone": s11,
"recovering": {
"kinds": {"multicast": [1, 0, 0, 0], "to_all": [1, 0, 0, 0], "up": [1, 1, 1, 1], "down": [1, 1, 1, 1], "role": [0, 1, 2, 3], "informs": [1, 0, 0, 0], "trigger": [0, 2, 2, 1], "answers": [-1, 0, 0, 2], "since": s12, "to_unknown": [1, 0, 0, 0]},
"bursts": s13,
"repairs": {"announce_interval_initial": 30000000, "announce_interval_max": 30000000, "heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": s1, "topics": 2, "heartbeat": 2, "acknack": 3, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
},
},
"Zenoh": {
"messages": [s14, s15, s16, {"name": "KeepAlive", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 84}],
"inside": [],
"alone": s11,
"recovering": {
"kinds": {"multicast": [1, 0, 0, 0], "to_all": [1, 0, 0, 0], "up": [1, 1, 1, 1], "down": [1, 1, 1, 1], "role": [0, 0, 1, 0], "informs": [0, 1, 1, 0], "trigger": [0, 1, 2, 2], "answers": [-1, 0, 1, 1], "since": s12, "tcp": [0, 0, 1, 1], "to_unknown": [1, 0, 0, 0]},
"bursts": s13,
"repairs": {"announce_interval_initial": 10000000, "announce_interval_max": 80000000, "lease": s1, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
},
},
"Cyclone DDS": {
"messages": [
{"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 420},
{"name": "SPDP unicast", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 420},
{"name": "SPDP directed", "unit": s7, "multicast": 0, "sent": 0.7917, "alone": 0.7917, "bytes": 436},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.2218, "alone": 1, "bytes": s17},
{"name": "SEDP again", "unit": s18, "multicast": 0, "sent": 0.0228454, "alone": 0.103, "bytes": s17},
{"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 1.0452, "alone": 2, "bytes": s19},
{"name": s20, "unit": s7, "multicast": 0, "sent": 1.2965706, "alone": 2.481, "bytes": s19},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 1.86327, "alone": 4.635, "bytes": s21},
{"name": s22, "unit": s23, "multicast": 0, "sent": 0.039781920000000005, "alone": 0.09896, "bytes": s21},
s25,
{"name": s26, "unit": s7, "multicast": 0, "sent": 0.6253, "alone": 1, "bytes": s27},
{"name": s28, "unit": s23, "multicast": 0, "sent": 0.06671951, "alone": 0.1067, "bytes": s27},
s31,
{"name": s32, "unit": s7, "multicast": 0, "sent": 1.0096768, "alone": 2.222, "bytes": 153.8987676056338},
s34,
{"name": s35, "unit": s7, "multicast": 0, "sent": 0.7037728, "alone": 2.312, "bytes": s36},
{"name": s37, "unit": s23, "multicast": 0, "sent": 0.015853152000000002, "alone": 0.05208, "bytes": s36},
{"name": s38, "unit": s7, "multicast": 0, "sent": 1.5878398, "alone": 2.333, "bytes": 129.08962679988247},
{"name": s39, "unit": s7, "multicast": 0, "sent": 0.5282, "alone": 2, "bytes": s40},
{"name": s41, "unit": s23, "multicast": 0, "sent": 0.057785079999999996, "alone": 0.2188, "bytes": s40},
{"name": s42, "unit": s44, "multicast": 0, "sent": 0.6284482, "alone": 1.006, "bytes": s45},
{"name": s46, "unit": s47, "multicast": 0, "sent": 0.045084599, "alone": 0.07217, "bytes": s45},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 0.47455200000000003, "alone": 1.404, "bytes": s48},
{"name": s49, "unit": s47, "multicast": 0, "sent": 0.033100340000000006, "alone": 0.09793, "bytes": s48},
],
"inside": [],
"alone": s55,
"recovering": s58,
},
"Cyclone DDS, wired": {
"messages": [
s59,
{"name": "SPDP directed", "unit": s7, "multicast": 0, "sent": 0.6642332099999999, "alone": 0.6667, "bytes": 493.08762420957544},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.10738553000000002, "alone": 0.5833, "bytes": 1167.7479630635523},
{"name": s60, "unit": s5, "multicast": 1, "sent": 0.037140759999999995, "alone": 0.1667, "bytes": 961.6660682226212},
{"name": s61, "unit": s2, "multicast": 1, "sent": 0.5, "alone": 2, "bytes": 232},
{"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 0.9861, "alone": 3, "bytes": 201.42013994523882},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 1.504575, "alone": 4.05, "bytes": s62},
{"name": s22, "unit": s23, "multicast": 0, "sent": 0.10524594999999999, "alone": 0.2833, "bytes": s62},
{"name": "Liveliness", "unit": s2, "multicast": 1, "sent": 0.7242, "alone": 1, "bytes": s24},
{"name": s26, "unit": s2, "multicast": 1, "sent": 0.31936806, "alone": 0.3333, "bytes": 150.79816322270926},
{"name": s63, "unit": s7, "multicast": 0, "sent": 0.1, "alone": 0.5, "bytes": 429},
{"name": s29, "unit": s2, "multicast": 1, "sent": 0.2758, "alone": 1, "bytes": s30},
{"name": s32, "unit": s2, "multicast": 1, "sent": 0.15461249999999999, "alone": 0.875, "bytes": 245.09790605546124},
{"name": s64, "unit": s7, "multicast": 0, "sent": 0.3440125, "alone": 1.625, "bytes": 234.05196032120926},
s34,
{"name": s35, "unit": s7, "multicast": 0, "sent": 0.6579608, "alone": 2.344, "bytes": s65},
{"name": s37, "unit": s23, "multicast": 0, "sent": 0.021928284, "alone": 0.07812, "bytes": s65},
{"name": s38, "unit": s2, "multicast": 1, "sent": 0.3976, "alone": 2, "bytes": 224.96579476861166},
{"name": s66, "unit": s7, "multicast": 0, "sent": 0.12780639, "alone": 0.6667, "bytes": 230.92749087115283},
{"name": s39, "unit": s7, "multicast": 0, "sent": 0.4, "alone": 2, "bytes": 211.5},
{"name": s41, "unit": s23, "multicast": 0, "sent": 0.0625, "alone": 0.3125, "bytes": 211.5},
{"name": s42, "unit": s44, "multicast": 0, "sent": 0.182025, "alone": 0.75, "bytes": 230.46065100947672},
{"name": s67, "unit": s44, "multicast": 1, "sent": 0.0538, "alone": 0.25, "bytes": 232.6802973977695},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 0.4566, "alone": 2, "bytes": 226.06745510293473},
],
"inside": [],
"alone": s69,
"recovering": s72,
},
"Cyclone DDS, version 11": {
"messages": [
{"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 432},
{"name": "SPDP unicast", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 432},
{"name": "SPDP directed", "unit": s7, "multicast": 0, "sent": 0.54086696, "alone": 0.5413, "bytes": 432.2946357085669},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.4598, "alone": 1, "bytes": s73},
{"name": "SEDP again", "unit": s18, "multicast": 0, "sent": 0.041809613999999995, "alone": 0.09093, "bytes": s73},
{"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 1.095, "alone": 2, "bytes": s74},
{"name": s20, "unit": s7, "multicast": 0, "sent": 1.5510675, "alone": 2.833, "bytes": s74},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 2.0574993999999998, "alone": 5.167, "bytes": s75},
{"name": s22, "unit": s23, "multicast": 0, "sent": 0.049775, "alone": 0.125, "bytes": s75},
s25,
{"name": s26, "unit": s7, "multicast": 0, "sent": 0.6519, "alone": 1, "bytes": s76},
{"name": s28, "unit": s23, "multicast": 0, "sent": 0.059342457, "alone": 0.09103, "bytes": s76},
s31,
{"name": s32, "unit": s7, "multicast": 0, "sent": 0.9629388000000001, "alone": 2.188, "bytes": 156.2517609634174},
s34,
{"name": s35, "unit": s7, "multicast": 0, "sent": 0.6271334, "alone": 2.278, "bytes": s77},
{"name": s37, "unit": s23, "multicast": 0, "sent": 0.015295667999999998, "alone": 0.05556, "bytes": s77},
{"name": s38, "unit": s7, "multicast": 0, "sent": 1.6266258, "alone": 2.542, "bytes": 132.5107047976246},
{"name": s39, "unit": s7, "multicast": 0, "sent": 0.477, "alone": 2, "bytes": s78},
{"name": s41, "unit": s23, "multicast": 0, "sent": 0.047628449999999996, "alone": 0.1997, "bytes": s78},
{"name": s42, "unit": s44, "multicast": 0, "sent": 0.7393500000000001, "alone": 1.06, "bytes": s79},
{"name": s46, "unit": s47, "multicast": 0, "sent": 0.048790125, "alone": 0.06995, "bytes": s79},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 0.6813444, "alone": 1.562, "bytes": s80},
{"name": s49, "unit": s47, "multicast": 0, "sent": 0.040998438, "alone": 0.09399, "bytes": s80},
],
"inside": [],
"alone": s55,
"recovering": s58,
},
"Cyclone DDS peers": {
"messages": [
{"name": "SPDP", "unit": s81, "multicast": 0, "sent": 9, "alone": 9, "bytes": 420},
{"name": "ICMP unreachable", "unit": s82, "multicast": 0, "sent": 6, "alone": 6, "bytes": 448},
{"name": "SPDP directed", "unit": s7, "multicast": 0, "sent": 0.81805061, "alone": 0.8333, "bytes": 442.0177243557095},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.172, "alone": 1, "bytes": 1224.46511627907},
{"name": "SEDP again", "unit": s18, "multicast": 0, "sent": 0.06907263300000001, "alone": 0.08633, "bytes": 334.84114485689287},
{"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 1.1512, "alone": 2, "bytes": s83},
{"name": s20, "unit": s7, "multicast": 0, "sent": 1.6945664, "alone": 2.944, "bytes": s83},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 1.6930648000000001, "alone": 4.424, "bytes": s84},
{"name": s22, "unit": s23, "multicast": 0, "sent": 0.07841523, "alone": 0.2049, "bytes": s84},
{"name": "Liveliness", "unit": s7, "multicast": 0, "sent": 0.7241, "alone": 1, "bytes": 180.00607650876952},
{"name": s26, "unit": s7, "multicast": 0, "sent": 0.7527, "alone": 1, "bytes": s85},
{"name": s28, "unit": s23, "multicast": 0, "sent": 0.062722491, "alone": 0.08333, "bytes": s85},
{"name": s29, "unit": s7, "multicast": 0, "sent": 0.2759, "alone": 1, "bytes": 179.9840521928235},
{"name": s32, "unit": s7, "multicast": 0, "sent": 1.0883448, "alone": 2.556, "bytes": 156.0150305307656},
s34,
{"name": s35, "unit": s7, "multicast": 0, "sent": 0.60844, "alone": 2.296, "bytes": s86},
{"name": s37, "unit": s23, "multicast": 0, "sent": 0.02456815, "alone": 0.09271, "bytes": s86},
{"name": s38, "unit": s7, "multicast": 0, "sent": 1.9293, "alone": 3, "bytes": 134.67330119732546},
{"name": s39, "unit": s7, "multicast": 0, "sent": 0.566, "alone": 2, "bytes": s87},
{"name": s41, "unit": s23, "multicast": 0, "sent": 0.10275729999999998, "alone": 0.3631, "bytes": s87},
{"name": s42, "unit": s44, "multicast": 0, "sent": 0.8334509999999999, "alone": 1.542, "bytes": 147.20074005550418},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 0.9648960000000001, "alone": 2.208, "bytes": 166.51716247139586},
],
"inside": [],
"alone": {"kinds": {"up": s88, "down": s88}, "bursts": {"messages": [[0, 1, 2], s52, [0, 20, 21], [2], [9, 12, 14], [1], [0], [9, 12, 14]], "periods": [0, 0, 0, 0, 0, 80000000, 80000000, 80000000], "times": [[0, 0], [0.05, 1], [0.1, 2], [1, 3], [2, 3], [3, 3], [8, 4], [8, 5], [8.1, 6], [16, 7]]}},
"recovering": {
"kinds": {
"up": s88,
"down": s88,
"role": [0, 0, 0, 1, 0, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 2, 2, 2, 1, 2, 1, 1, 1, 0, 2, 2, 0, 2, 1, 1, 1, 2, 1, 1, 1, 1],
"answers": [-1, 0, 0, 0, 7, 0, 3, 5, 5, -1, 0, 0, -1, 0, 12, 13, 13, 0, 17, 17, 3, 20],
"when": [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 500000, 500000, 500000, s1, 500000, s1, s1, s1, 0, 500000, 500000, 0, 500000, 120000000, s1, s1, 500000, s1, s1, s1, s1],
"to_unknown": [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"gap_first": [0, 0, 10000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"gap_number": [0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0], [9, 12], [0], [9, 12]], "periods": s70, "times": s71},
"repairs": s57,
"spread": [0],
},
},
"Cyclone DDS multicast SEDP": {
"messages": [
s59,
{"name": "SPDP directed", "unit": s7, "multicast": 0, "sent": 0.7990400000000001, "alone": 0.8, "bytes": 492.4140969162995},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.07754115, "alone": 0.3719, "bytes": 1040.4988009592325},
{"name": s60, "unit": s5, "multicast": 1, "sent": 0.051106000000000006, "alone": 0.23, "bytes": 965.8901890189019},
{"name": s61, "unit": s2, "multicast": 1, "sent": 0.51324, "alone": 1.833, "bytes": 215.89285714285714},
{"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 1.0475619, "alone": 3.333, "bytes": 213.31594018453706},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 1.6071486000000001, "alone": 4.517, "bytes": s89},
{"name": s22, "unit": s23, "multicast": 0, "sent": 0.053156520000000006, "alone": 0.1494, "bytes": s89},
{"name": "Liveliness", "unit": s2, "multicast": 1, "sent": 0.724, "alone": 1, "bytes": 180.02209944751382},
{"name": s26, "unit": s2, "multicast": 1, "sent": 0.79488487, "alone": 0.8333, "bytes": 152.05954502568403},
{"name": s63, "unit": s7, "multicast": 0, "sent": 0.075, "alone": 0.5, "bytes": 510.6666666666667},
{"name": s29, "unit": s2, "multicast": 1, "sent": 0.276, "alone": 1, "bytes": 179.94202898550725},
{"name": s32, "unit": s2, "multicast": 1, "sent": 0.2328, "alone": 1, "bytes": 201.4570446735395},
{"name": s64, "unit": s7, "multicast": 0, "sent": 0.40565, "alone": 1.75, "bytes": 219.65142364106987},
s34,
{"name": s35, "unit": s7, "multicast": 0, "sent": 0.6794424, "alone": 2.379, "bytes": s90},
{"name": s37, "unit": s23, "multicast": 0, "sent": 0.025287024, "alone": 0.08854, "bytes": s90},
{"name": s38, "unit": s2, "multicast": 1, "sent": 0.465, "alone": 2, "bytes": 207.01075268817203},
{"name": s66, "unit": s7, "multicast": 0, "sent": 0.2014242, "alone": 1.167, "bytes": 249.3997682502897},
{"name": s39, "unit": s7, "multicast": 0, "sent": 0.4176, "alone": 2, "bytes": s91},
{"name": s41, "unit": s23, "multicast": 0, "sent": 0.06836112000000001, "alone": 0.3274, "bytes": s91},
{"name": s42, "unit": s44, "multicast": 0, "sent": 0.32990139, "alone": 0.7917, "bytes": 176.79097672186225},
{"name": s67, "unit": s44, "multicast": 1, "sent": 0.11113888999999999, "alone": 0.1667, "bytes": 122.00209989500526},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 0.9029889, "alone": 2.167, "bytes": 167.19174466042716},
],
"inside": [],
"alone": s69,
"recovering": s72,
},
"Fast DDS Discovery Server": {
"messages": [
{"name": s92, "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 652},
{"name": s93, "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 700},
{"name": s94, "unit": s2, "multicast": 0, "sent": 0.865, "alone": 1, "bytes": s95},
{"name": s96, "unit": s97, "multicast": 0, "sent": 1.6752939, "alone": 1.967, "bytes": s98},
{"name": s99, "unit": s2, "multicast": 0, "sent": 2, "alone": 2, "bytes": 192},
{"name": s100, "unit": s2, "multicast": 0, "sent": s101, "alone": 2.167, "bytes": s102},
{"name": s103, "unit": s97, "multicast": 0, "sent": 0.9253256, "alone": 2.908, "bytes": s104},
{"name": "SPDP ACKNACK", "unit": s2, "multicast": 0, "sent": 2.167, "alone": 2.167, "bytes": 189.9},
{"name": s105, "unit": s97, "multicast": 0, "sent": 0.5083, "alone": 0.5083, "bytes": 190.2},
{"name": s106, "unit": s2, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
{"name": "SPDP Gap", "unit": s97, "multicast": 0, "sent": 0.99088, "alone": 1.6, "bytes": s107},
{"name": s108, "unit": s109, "multicast": 0, "sent": 0.45, "alone": 1, "bytes": 1152},
{"name": s110, "unit": s111, "multicast": 0, "sent": 1.0447702, "alone": 1.237, "bytes": s112},
{"name": "Heartbeat", "unit": s2, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s113, "unit": s2, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s114, "unit": s111, "multicast": 0, "sent": 0.4461336, "alone": 1.892, "bytes": s115},
{"name": "ACKNACK", "unit": s2, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": s116, "unit": s111, "multicast": 0, "sent": 0.45, "alone": 0.45, "bytes": 191.3},
{"name": s117, "unit": s2, "multicast": 0, "sent": 15.6, "alone": 15.6, "bytes": 188.5},
{"name": "Gap", "unit": s111, "multicast": 0, "sent": s118, "alone": 0.645, "bytes": s119},
{"name": s120, "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 192},
{"name": s121, "unit": s2, "multicast": 0, "sent": 2, "alone": 2, "bytes": 192},
s123,
{"name": s124, "unit": s2, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
{"name": s125, "unit": s2, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
s126,
s127,
s128,
],
"inside": [],
"alone": s132,
"recovering": {
"kinds": {
"up": s129,
"down": s130,
"role": s133,
"informs": [1, 1, 1, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": s134,
"answers": [-1, -1, 0, 11, 0, 0, 3, 1, 12, 4, 3, 1, 11, 1, 0, 12, 14, 12, 13, 12, 1, 0, 3, 21, 20, 22, 12, 26],
"when": s135,
"since": s136,
"to_unknown": s137,
"leg": s138,
"delay": s139,
},
"bursts": s140,
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 200000000, "topics": 4, "heartbeat": 13, "acknack": 16, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
"server": true,
},
},
"Fast DDS Discovery Server, two": {
"messages": [
{"name": s92, "unit": s2, "multicast": 0, "sent": 2, "alone": 2, "bytes": 636},
{"name": s93, "unit": s2, "multicast": 0, "sent": 2, "alone": 2, "bytes": 700},
{"name": s94, "unit": s2, "multicast": 0, "sent": 1.7314, "alone": 2, "bytes": 747.8396673212429},
{"name": s96, "unit": s97, "multicast": 0, "sent": 3.32124, "alone": 3.9, "bytes": 684.0093940817285},
{"name": s99, "unit": s2, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s100, "unit": s2, "multicast": 0, "sent": 2.86935, "alone": 4.625, "bytes": 244.85106382978725},
{"name": s103, "unit": s97, "multicast": 0, "sent": 1.6209776, "alone": 5.942, "bytes": 402.48973607038124},
{"name": "SPDP ACKNACK", "unit": s2, "multicast": 0, "sent": 4.625, "alone": 4.625, "bytes": 189.8},
{"name": s105, "unit": s97, "multicast": 0, "sent": 0.9417, "alone": 0.9417, "bytes": 190.5},
{"name": s106, "unit": s2, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": "SPDP Gap", "unit": s97, "multicast": 0, "sent": 2.2387761, "alone": 3.333, "bytes": 199.09006997171358},
{"name": s108, "unit": s109, "multicast": 0, "sent": 0.8166, "alone": 2, "bytes": 1257.7301004163605},
{"name": s110, "unit": s111, "multicast": 0, "sent": 2.0692700000000004, "alone": 2.45, "bytes": s112},
{"name": "Heartbeat", "unit": s2, "multicast": 0, "sent": 8, "alone": 8, "bytes": 184},
{"name": s113, "unit": s2, "multicast": 0, "sent": 8, "alone": 8, "bytes": 192},
{"name": s114, "unit": s111, "multicast": 0, "sent": 0.807258, "alone": 3.242, "bytes": 432.5140562248996},
{"name": "ACKNACK", "unit": s2, "multicast": 0, "sent": 8, "alone": 8, "bytes": 188},
{"name": s116, "unit": s111, "multicast": 0, "sent": 0.85, "alone": 0.85, "bytes": 190.8},
{"name": s117, "unit": s2, "multicast": 0, "sent": 31.6, "alone": 31.6, "bytes": 188.5},
{"name": "Gap", "unit": s111, "multicast": 0, "sent": 0.6431319999999999, "alone": 1.03, "bytes": 207.54580397181294},
{"name": s120, "unit": s2, "multicast": 0, "sent": 2, "alone": 2, "bytes": 192},
{"name": s121, "unit": s2, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s29, "unit": s122, "multicast": 0, "sent": 1.208, "alone": 1.208, "bytes": 192},
{"name": s124, "unit": s2, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": s125, "unit": s2, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": s33, "unit": s122, "multicast": 0, "sent": 1.208, "alone": 1.208, "bytes": 188},
{"name": s42, "unit": s44, "multicast": 0, "sent": 1.08, "alone": 1.08, "bytes": 192},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 1.179, "alone": 1.179, "bytes": 188},
],
"inside": [],
"alone": s132,
"recovering": {
"kinds": {
"up": s129,
"down": s130,
"role": s133,
"informs": [1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": s134,
"answers": [-1, -1, 0, 11, 0, 0, 3, 1, 6, 4, 3, 1, 11, 1, 0, 12, 14, 12, 13, 12, 1, 0, 3, 21, 20, 22, 12, 26],
"when": s135,
"since": s136,
"to_unknown": s137,
"leg": s138,
"delay": s139,
},
"bursts": s140,
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 200000000, "topics": 8, "heartbeat": 13, "acknack": 16, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
"server": true,
},
},
"Fast DDS Discovery Server, on a robot": {
"messages": [
{"name": s92, "unit": s141, "multicast": 0, "sent": 1, "alone": 1, "bytes": 652},
{"name": s93, "unit": s141, "multicast": 0, "sent": 1, "alone": 1, "bytes": 700},
{"name": s94, "unit": s141, "multicast": 0, "sent": 0.865, "alone": 1, "bytes": s95},
{"name": s96, "unit": s142, "multicast": 0, "sent": 1.6752939, "alone": 1.967, "bytes": s98},
{"name": s99, "unit": s141, "multicast": 0, "sent": 2, "alone": 2, "bytes": 192},
{"name": s100, "unit": s141, "multicast": 0, "sent": s101, "alone": 2.167, "bytes": s102},
{"name": s103, "unit": s142, "multicast": 0, "sent": 0.9253256, "alone": 2.908, "bytes": s104},
{"name": "SPDP ACKNACK", "unit": s141, "multicast": 0, "sent": 2.167, "alone": 2.167, "bytes": 189.9},
{"name": s105, "unit": s142, "multicast": 0, "sent": 0.5083, "alone": 0.5083, "bytes": 190.2},
{"name": s106, "unit": s141, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
{"name": "SPDP Gap", "unit": s142, "multicast": 0, "sent": 0.99088, "alone": 1.6, "bytes": s107},
{"name": s108, "unit": ["endpoint", "server"], "multicast": 0, "sent": 0.45, "alone": 1, "bytes": 1152},
{"name": s110, "unit": s143, "multicast": 0, "sent": 1.0447702, "alone": 1.237, "bytes": s112},
{"name": "Heartbeat", "unit": s141, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s113, "unit": s141, "multicast": 0, "sent": 4, "alone": 4, "bytes": 192},
{"name": s114, "unit": s143, "multicast": 0, "sent": 0.4461336, "alone": 1.892, "bytes": s115},
{"name": "ACKNACK", "unit": s141, "multicast": 0, "sent": 4, "alone": 4, "bytes": 188},
{"name": s116, "unit": s143, "multicast": 0, "sent": 0.45, "alone": 0.45, "bytes": 191.3},
{"name": s117, "unit": s141, "multicast": 0, "sent": 15.6, "alone": 15.6, "bytes": 188.5},
{"name": "Gap", "unit": s143, "multicast": 0, "sent": s118, "alone": 0.645, "bytes": s119},
{"name": s120, "unit": s141, "multicast": 0, "sent": 1, "alone": 1, "bytes": 192},
{"name": s121, "unit": s141, "multicast": 0, "sent": 2, "alone": 2, "bytes": 192},
s123,
{"name": s124, "unit": s141, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
{"name": s125, "unit": s141, "multicast": 0, "sent": 2, "alone": 2, "bytes": 188},
s126,
s127,
s128,
],
"inside": [],
"alone": {"kinds": {"up": s144, "down": s144}, "bursts": s131},
"recovering": {"refused": "recovery must be False for the protocol 'Fast DDS Discovery Server, on a robot': it does not say how processes find each other, or, with a server on a host, which of its messages go to the server"},
},
"Fast DDS": {
"messages": [
{"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 580},
{"name": s145, "unit": s146, "multicast": 1, "sent": 1, "alone": 1, "bytes": 580},
{"name": "SPDP unicast", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 580},
{"name": s147, "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 580},
{"name": s148, "unit": s23, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 580},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.6, "alone": 1, "bytes": 852.6666666666666},
s149,
{"name": s20, "unit": s7, "multicast": 0, "sent": 1.65, "alone": 1.65, "bytes": 184.3},
{"name": s150, "unit": s23, "multicast": 0, "sent": 0.4252, "alone": 0.4252, "bytes": 184.3},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 189.4},
{"name": s151, "unit": s7, "multicast": 0, "sent": 2.072, "alone": 2.072, "bytes": 189.4},
{"name": s22, "unit": s23, "multicast": 0, "sent": 0.2616, "alone": 0.2616, "bytes": 189.4},
{"name": s29, "unit": s7, "multicast": 0, "sent": 1.148, "alone": 1.148, "bytes": 192},
{"name": s33, "unit": s7, "multicast": 0, "sent": 1.148, "alone": 1.148, "bytes": 188},
{"name": s42, "unit": s44, "multicast": 0, "sent": 1.4, "alone": 1.4, "bytes": 192},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 1.425, "alone": 1.425, "bytes": 188},
],
"inside": [],
"alone": {
"kinds": {"multicast": s152, "to_all": s152, "up": s153, "down": s153},
"bursts": {"messages": [[0], s154, s155, [15], [0, 2], [7, 8, 10, 11], [0, 2]], "periods": [0, 0, 0, 0, 0, 0, 30000000], "times": [[0, 0], [0.05, 1], [0.1, 2], [0.17, 3], [0.2, 4], [0.3, 4], [0.4, 4], [0.5, 4], [1, 5], [3.5, 6]]},
},
"recovering": {
"kinds": {
"multicast": s152,
"to_all": s152,
"up": s153,
"down": s153,
"role": [0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 2, 0, 2, 2, 2, 2, 1, 1, 1, 1, 1, 2, 1, 1, 1],
"answers": [-1, 0, -1, 0, 0, 0, 0, 5, 5, 6, 7, 8, 0, 12, 5, 14],
"when": [0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 500000, 0, 500000, 500000, 500000, 500000, s1, s1, s1, s1, s1, 500000, s1, s1, s1],
"to_unknown": [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": s158,
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 200000000, "topics": 2, "heartbeat": 6, "acknack": 9, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
},
},
"Fast DDS 2.6": {
"messages": [
{"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 344},
{"name": s145, "unit": s146, "multicast": 1, "sent": 1, "alone": 1, "bytes": 344},
{"name": "SPDP unicast", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 344},
{"name": s147, "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 344},
{"name": s148, "unit": s23, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 344},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.6287, "alone": 1, "bytes": 773.5594083028471},
{"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 118.85},
{"name": s20, "unit": s7, "multicast": 0, "sent": 3.274, "alone": 3.274, "bytes": 118.85},
{"name": s150, "unit": s23, "multicast": 0, "sent": 0.4879, "alone": 0.4879, "bytes": 118.85},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 129.22},
{"name": s151, "unit": s7, "multicast": 0, "sent": 1.884, "alone": 1.884, "bytes": 129.22},
{"name": s22, "unit": s23, "multicast": 0, "sent": 0.3703, "alone": 0.3703, "bytes": 129.22},
{"name": s29, "unit": s7, "multicast": 0, "sent": 1.125, "alone": 1.125, "bytes": 132},
{"name": s33, "unit": s7, "multicast": 0, "sent": 1.167, "alone": 1.167, "bytes": 128},
{"name": s42, "unit": s44, "multicast": 0, "sent": 1.575, "alone": 1.575, "bytes": 125.14},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 1.429, "alone": 1.429, "bytes": 128.35},
{"name": s159, "unit": s7, "multicast": 0, "sent": 1.685, "alone": 1.685, "bytes": 501.7},
{"name": "ROS Heartbeat", "unit": s7, "multicast": 0, "sent": 3.37, "alone": 3.37, "bytes": 125.14},
{"name": s160, "unit": s23, "multicast": 0, "sent": 0.1534, "alone": 0.1534, "bytes": 125.14},
{"name": "ROS ACKNACK", "unit": s7, "multicast": 0, "sent": 1.426, "alone": 1.426, "bytes": 128.35},
{"name": s161, "unit": s23, "multicast": 0, "sent": 0.1351, "alone": 0.1351, "bytes": 128.35},
],
"inside": [],
"alone": {"kinds": {"multicast": s162, "to_all": s162, "up": s163, "down": s163}, "bursts": {"messages": [[0], s154, s155, [15], [0, 2, 16], [17, 18], [0, 2, 19, 20], [0, 2], [7, 8, 10, 11], [0, 2]], "periods": s164, "times": s165}},
"recovering": {
"kinds": {
"multicast": s162,
"to_all": s162,
"up": s163,
"down": s163,
"role": [0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 2, 0, 2, 2, 2, 2, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1],
"answers": [-1, 0, -1, 0, 0, 0, 0, 5, 5, 6, 7, 8, 0, 12, 5, 14, 5, 16, 16, 17, 18],
"when": [0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 500000, 0, 500000, 500000, 500000, 500000, s1, s1, s1, s1, s1, 500000, s1, s1, s1, s1, s1, s1, s1, s1],
"to_unknown": [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"delay": [0, 0, 0, 0, 0, 1000, 1000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": s158,
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 200000000, "topics": 2, "heartbeat": 6, "acknack": 9, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000, "nack_response_delay": 1000},
},
},
"Fast DDS 2.14": {
"messages": [
{"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 560},
{"name": "SPDP unicast", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 560},
{"name": s147, "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 560},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.6008, "alone": 1, "bytes": 1014.7323568575234},
{"name": "Heartbeat", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 183.8},
{"name": s20, "unit": s7, "multicast": 0, "sent": 2.375, "alone": 2.375, "bytes": 183.8},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 189.7},
{"name": s151, "unit": s7, "multicast": 0, "sent": 2.625, "alone": 2.625, "bytes": 189.7},
{"name": s29, "unit": s7, "multicast": 0, "sent": 1.125, "alone": 1.125, "bytes": 192},
{"name": s33, "unit": s7, "multicast": 0, "sent": 1.216, "alone": 1.216, "bytes": 188},
{"name": s42, "unit": s44, "multicast": 0, "sent": 1.5, "alone": 1.5, "bytes": 183.7},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 1.554, "alone": 1.554, "bytes": 189},
{"name": s159, "unit": s7, "multicast": 0, "sent": 1.037, "alone": 1.037, "bytes": 480},
{"name": "ROS Heartbeat", "unit": s7, "multicast": 0, "sent": 0.7995, "alone": 0.7995, "bytes": 183.7},
{"name": s160, "unit": s23, "multicast": 0, "sent": 0.288, "alone": 0.288, "bytes": 183.7},
{"name": "ROS ACKNACK", "unit": s7, "multicast": 0, "sent": 0.9597, "alone": 0.9597, "bytes": 189},
{"name": s161, "unit": s23, "multicast": 0, "sent": 0.1806, "alone": 0.1806, "bytes": 189},
],
"inside": [],
"alone": {"kinds": {"multicast": s166, "to_all": s166, "up": s167, "down": s167}, "bursts": {"messages": [[0], [2, 3, 4, 8], [0, 1, 6, 9, 10], [11], [0, 1, 12], [13, 14], [0, 1, 15, 16], [0, 1], [5, 7], [0, 1]], "periods": s164, "times": s165}},
"recovering": {
"kinds": {
"multicast": s166,
"to_all": s166,
"up": s167,
"down": s167,
"role": [0, 0, 0, 1, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 0, 2, 2, 2, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1],
"answers": [-1, -1, 0, 0, 0, 3, 4, 5, 0, 8, 3, 10, 3, 12, 12, 13, 14],
"when": [0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 0, 500000, 500000, 500000, s1, s1, s1, 500000, s1, s1, s1, s1, s1, s1, s1, s1],
"to_unknown": s166,
"delay": [0, 0, 0, 1000000, 1000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": s168,
"repairs": s169,
},
},
"Fast DDS 3.6": {
"messages": [
{"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 632},
{"name": "SPDP unicast", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 632},
{"name": s147, "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 632},
{"name": "SEDP", "unit": s5, "multicast": 0, "sent": 0.6318, "alone": 1, "bytes": 896.8584995251663},
s149,
{"name": s20, "unit": s7, "multicast": 0, "sent": 2.13, "alone": 2.13, "bytes": 184.3},
{"name": "ACKNACK", "unit": s7, "multicast": 0, "sent": 2, "alone": 2, "bytes": 189.6},
{"name": s151, "unit": s7, "multicast": 0, "sent": 2.204, "alone": 2.204, "bytes": 189.6},
{"name": s29, "unit": s7, "multicast": 0, "sent": 1.046, "alone": 1.046, "bytes": 192},
{"name": s33, "unit": s7, "multicast": 0, "sent": 1.083, "alone": 1.083, "bytes": 188},
{"name": s42, "unit": s44, "multicast": 0, "sent": 1.306, "alone": 1.306, "bytes": 178.8},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 1.633, "alone": 1.633, "bytes": 189},
{"name": s159, "unit": s7, "multicast": 0, "sent": 1.15, "alone": 1.15, "bytes": 459.4},
{"name": s38, "unit": s7, "multicast": 0, "sent": 2.2831941999999996, "alone": 2.303, "bytes": 189.68085535606212},
{"name": s39, "unit": s7, "multicast": 0, "sent": 2.5, "alone": 2.5, "bytes": 188},
{"name": "Type lookup", "unit": ["unknown type", s4], "multicast": 0, "sent": 0.9334211, "alone": 3.917, "bytes": 808.8594208980277},
{"name": "ROS Heartbeat", "unit": s7, "multicast": 0, "sent": 3.687, "alone": 3.687, "bytes": 178.8},
{"name": s160, "unit": s23, "multicast": 0, "sent": 0.1285, "alone": 0.1285, "bytes": 178.8},
{"name": "ROS ACKNACK", "unit": s7, "multicast": 0, "sent": 0.4578, "alone": 0.4578, "bytes": 189},
{"name": s161, "unit": s23, "multicast": 0, "sent": 0.2066, "alone": 0.2066, "bytes": 189},
],
"inside": [],
"alone": {"kinds": s172, "bursts": {"messages": [[0], [2, 3, 4, 8, 13], [0, 1, 6, 9, 10, 14], [11], [0, 1, 12], [16, 17], [0, 1, 15, 18, 19], [0, 1], [5, 7], [0, 1]], "periods": s164, "times": s165}},
"recovering": {
"kinds": {
"multicast": s170,
"to_all": s170,
"up": s171,
"down": s171,
"role": [0, 0, 0, 1, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 0, 2, 2, 2, 1, 1, 1, 2, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1],
"answers": [-1, -1, 0, 0, 0, 3, 4, 5, 0, 8, 3, 10, 3, 0, 13, 3, 12, 12, 16, 17],
"when": [0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 0, 500000, 500000, 500000, s1, s1, s1, 500000, s1, s1, s1, s1, 500000, s1, s1, s1, s1, s1, s1],
"to_unknown": s170,
"delay": [0, 0, 0, 1000000, 1000000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": s168,
"repairs": s169,
},
},
"hybrid": {
"messages": [s173, s174, {"name": "Endpoint", "unit": s109, "multicast": 1, "sent": 0, "alone": 1, "bytes": 20}, s176, s177, s178, s179],
"inside": [[1, 0, 24], [2, 0, 20], [4, 3, 1], [6, 5, 0.125]],
"alone": {"kinds": {"multicast": s180, "to_all": s180, "up": s180, "down": s180}, "bursts": {"messages": [[0, 1, 2, 3, 4], [5, 6], [5, 6]], "periods": s156, "times": s181}},
"recovering": {
"kinds": {"multicast": s180, "to_all": s180, "up": s180, "down": s180, "informs": [1, 1, 1, 0, 0, 0, 0], "of_host": [1, 0, 0, 0, 1, 1, 0], "trigger": [0, 0, 0, 2, 2, 0, 0], "answers": [-1, -1, -1, 0, 0, -1, -1], "since": [0, 0, 0, s1, s1, 0, 0], "to_unknown": s182},
"bursts": {"messages": [[0, 1, 2], [5, 6], [5, 6]], "periods": s156, "times": s181},
"repairs": s183,
},
},
"hybrid, alike": {
"messages": [s173, s174, {"name": "Software", "unit": ["host", "all"], "multicast": 1, "sent": 0, "alone": 1, "bytes": 8}, {"name": "Endpoint", "unit": ["endpoint of a kind of host", "all"], "multicast": 1, "sent": 0, "alone": 1, "bytes": 20}, s176, s177, s178, s179],
"inside": [[1, 0, 24], [2, 0, 8], [3, 0, 20], [5, 4, 1], [7, 6, 0.125]],
"alone": {"kinds": {"multicast": s184, "to_all": s184, "up": s184, "down": s184}, "bursts": {"messages": [s185, [6, 7], [6, 7]], "periods": s156, "times": s181}},
"recovering": {
"kinds": {"multicast": s184, "to_all": s184, "up": s184, "down": s184, "informs": [1, 1, 1, 1, 0, 0, 0, 0], "of_host": [1, 0, 1, 0, 0, 1, 1, 0], "trigger": [0, 0, 0, 0, 2, 2, 0, 0], "answers": [-1, -1, -1, -1, 0, 0, -1, -1], "since": [0, 0, 0, 0, s1, s1, 0, 0], "to_unknown": [1, 0, 0, 0, 0, 0, 0, 0]},
"bursts": {"messages": [[0, 1, 2, 3], [6, 7], [6, 7]], "periods": s156, "times": s181},
"repairs": s183,
},
},
"DDS, periods of Fast DDS": {
"messages": [s3, {"name": "UnicastSPDP", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 414}, s6, s8, s9],
"inside": [],
"alone": {"kinds": {"multicast": [1, 0, 0, 0, 0], "to_all": [1, 0, 0, 0, 0], "up": [1, 1, 1, 1, 1], "down": [1, 1, 1, 1, 1]}, "bursts": {"messages": [[0, 1, 2, 3, 4], [0, 1], [0, 1]], "periods": s156, "times": s157}},
"recovering": {
"kinds": {"multicast": [1, 0, 0, 0, 0], "to_all": [1, 0, 0, 0, 0], "up": [1, 1, 1, 1, 1], "down": [1, 1, 1, 1, 1], "role": [0, 0, 1, 2, 3], "informs": [1, 1, 0, 0, 0], "trigger": [0, 0, 2, 2, 1], "answers": [-1, -1, 0, 0, 3], "since": [0, 0, 500000, 500000, s1], "to_unknown": [1, 0, 0, 0, 0]},
"bursts": {"messages": [[0, 1], [0, 1]], "periods": [0, 30000000], "times": [[0, 0], [0.1, 0], [0.2, 0], [0.3, 0], [0.4, 0], [0.5, 0], [3.5, 1]]},
"repairs": {"heartbeat_period_initial": 10000000, "heartbeat_period_max": 10000000, "lease": 200000000, "topics": 2, "heartbeat": 3, "acknack": 4, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
},
},
"DDS, periods of Cyclone DDS": {
"messages": [s3, {"name": "DirectedSPDP", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 414}, s6, s8, s9, {"name": "Liveliness", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 180}, {"name": "LivelinessACK", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 114}],
"inside": [],
"alone": {"kinds": {"multicast": s182, "to_all": s182, "up": s180, "down": s180}, "bursts": {"messages": [[0, 1, 2, 3, 4, 5, 6], [0], [1], [5, 6], [0]], "periods": s56, "times": [[0, 0], [0.1, 1], [1, 2], [2, 2], [3, 2], [8, 3], [8.1, 4]]}},
"recovering": {
"kinds": {
"multicast": s182,
"to_all": s182,
"up": s180,
"down": s180,
"role": [0, 0, 1, 2, 3, 0, 0],
"informs": [1, 1, 0, 0, 0, 0, 0],
"trigger": [0, 2, 2, 2, 1, 0, 1],
"answers": [-1, 0, 0, 0, 3, -1, 5],
"when": [0, 2, 0, 0, 0, 0, 0],
"since": [0, 500000, 500000, 500000, s1, 0, 40000000],
"to_unknown": s182,
"gap_first": [0, 10000000, 0, 0, 0, 0, 0],
"gap_number": [0, 3, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0, 5], [0], [5], [0]], "periods": s70, "times": [[0, 0], [0.1, 1], [8, 2], [8.1, 3]]},
"repairs": {"heartbeat_period_initial": 1000000, "heartbeat_period_max": 80000000, "lease": 100000000, "topics": 2, "heartbeat": 3, "acknack": 4, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
},
},
"Zenoh, periods of Zenoh peer": {
"messages": [s14, s15, s16, {"name": "KeepAlive", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 84}],
"inside": [],
"alone": {"kinds": s10, "bursts": {"messages": [[0, 1, 2], [0, 1], [3], [3], [0, 1]], "periods": [0, 0, 0, 25000000, 80000000], "times": [[0, 0], [1, 1], [2.5, 2], [3, 1], [5, 3], [7, 1], [15, 4]]}},
"recovering": {
"kinds": {"multicast": [1, 0, 0, 0], "to_all": [1, 0, 0, 0], "up": [1, 1, 1, 1], "down": [1, 1, 1, 1], "role": [0, 0, 1, 0], "informs": [0, 1, 1, 0], "trigger": [0, 1, 2, 0], "answers": [-1, 0, 1, -1], "since": [0, 5000000, 5000000, 0], "tcp": [0, 0, 1, 1], "to_unknown": [1, 0, 0, 0]},
"bursts": {"messages": [[0], [3], [3], [0]], "periods": s186, "times": s187},
"repairs": s188,
},
},
"static endpoints": {
"messages": [
{"name": "SPDP", "unit": s2, "multicast": 1, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": s145, "unit": s146, "multicast": 1, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": "SPDP of endpoints", "unit": s109, "multicast": 1, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": "SPDP unicast", "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": s147, "unit": s7, "multicast": 0, "sent": 1, "alone": 1, "bytes": 589.2},
{"name": s148, "unit": s23, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 589.2},
{"name": "SPDP unicast of endpoints", "unit": s5, "multicast": 0, "sent": 0.6542, "alone": 0.6542, "bytes": 589.2},
{"name": "Listed", "unit": s109, "multicast": 1, "sent": 0, "alone": 1, "bytes": 59.47},
{"name": "Listed at discovery", "unit": s189, "multicast": 1, "sent": 0, "alone": 0.8987, "bytes": 59.47},
{"name": "Listed of endpoints", "unit": [s190, "all"], "multicast": 1, "sent": 0, "alone": 0.8987, "bytes": 59.47},
{"name": "Listed unicast", "unit": s5, "multicast": 0, "sent": 0, "alone": 1, "bytes": 59.47},
{"name": "Listed unicast at discovery", "unit": s5, "multicast": 0, "sent": 0, "alone": 0.9528, "bytes": 59.47},
{"name": "Listed unicast for others", "unit": s18, "multicast": 0, "sent": 0, "alone": 0.4764, "bytes": 59.47},
{"name": "Listed unicast of endpoints", "unit": [s190, s4], "multicast": 0, "sent": 0, "alone": 0.6233, "bytes": 59.47},
{"name": s29, "unit": s7, "multicast": 0, "sent": 1.167, "alone": 1.167, "bytes": 192},
{"name": s33, "unit": s7, "multicast": 0, "sent": 1.167, "alone": 1.167, "bytes": 188},
{"name": s42, "unit": s44, "multicast": 0, "sent": 1.33, "alone": 1.33, "bytes": 192},
{"name": "User ACKNACK", "unit": s44, "multicast": 0, "sent": 1.33, "alone": 1.33, "bytes": 188},
],
"inside": [[7, 0, 59.47], [8, 1, 59.47], [9, 2, 59.47], [10, 3, 59.47], [11, 4, 59.47], [12, 5, 59.47], [13, 6, 59.47]],
"alone": {
"kinds": {"multicast": s191, "to_all": s191, "up": s192, "down": s192},
"bursts": {"messages": [[0], [1, 2, 4, 5, 6, 8, 9, 11, 12, 13, 14], [0, 3, 7, 10, 15, 16], [17], [0, 3, 7, 10], [0, 3, 7, 10]], "periods": [0, 0, 0, 0, 0, 30000000], "times": [[0, 0], [0.05, 1], [0.1, 2], [0.17, 3], [0.2, 4], [0.3, 4], [0.4, 4], [0.5, 4], [3.5, 5]]},
},
"recovering": {
"kinds": {
"multicast": s191,
"to_all": s191,
"up": s192,
"down": s192,
"informs": [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0],
"trigger": [0, 2, 0, 0, 2, 2, 2, 0, 2, 0, 0, 2, 2, 2, 2, 1, 2, 1],
"answers": [-1, 0, -1, -1, 0, 0, 0, -1, 0, -1, -1, 0, 0, 0, 0, 14, 0, 16],
"when": [0, 1, 0, 0, 1, 1, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 0, 0],
"since": [0, 500000, 0, 0, 500000, 500000, 500000, 0, 500000, 0, 0, 500000, 500000, 500000, 500000, s1, 500000, s1],
"to_unknown": [1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
},
"bursts": {"messages": [[0], [2, 9], [0, 3, 7, 10], [0, 3, 7, 10]], "periods": [0, 0, 0, 30000000], "times": [[0, 0], [0.05, 1], [0.1, 2], [0.2, 2], [0.3, 2], [0.4, 2], [0.5, 2], [3.5, 3]]},
"repairs": {"lease": 200000000, "rto_first": 10000000, "rto_min": 2000000, "rto_max": 1200000000},
},
},
"Zenoh peer": {
"messages": [
s193,
s194,
{"name": "Hello first", "unit": s7, "multicast": 0, "sent": 0.5833, "alone": 0.5833, "bytes": 104},
{"name": "InitSyn", "unit": s7, "multicast": 0, "sent": 0.6667, "alone": 0.6667, "bytes": 110},
s195,
s196,
s197,
{"name": "OAM", "unit": s7, "multicast": 0, "sent": 0.835, "alone": 1, "bytes": s198},
{"name": s199, "unit": s23, "multicast": 0, "sent": 0.521875, "alone": 0.625, "bytes": s198},
{"name": "Declare", "unit": s5, "multicast": 0, "sent": 0.09785, "alone": 0.5, "bytes": 106.65917220235053},
{"name": s200, "unit": s202, "multicast": 0, "sent": 0.40185, "alone": 0.5, "bytes": s203},
{"name": s204, "unit": s44, "multicast": 0, "sent": 0.40185, "alone": 0.5, "bytes": s203},
{"name": "Declare final", "unit": s7, "multicast": 0, "sent": 0.05, "alone": 1, "bytes": 176},
{"name": "Frame", "unit": s7, "multicast": 0, "sent": 0.2478, "alone": 1, "bytes": s205},
{"name": s206, "unit": s5, "multicast": 0, "sent": 0.15073673999999998, "alone": 0.6083, "bytes": s205},
s207,
s208,
{"name": "TCP ACK", "unit": s7, "multicast": 0, "sent": 0.8708, "alone": 0.8708, "bytes": 76},
{"name": s209, "unit": s7, "multicast": 0, "sent": 2.496, "alone": 2.496, "bytes": 76},
{"name": s210, "unit": s5, "multicast": 0, "sent": 0.2188, "alone": 0.2188, "bytes": 76},
],
"inside": [],
"alone": {"kinds": s172, "bursts": {"messages": [[0, 2], [3, 4, 5, 6, 16], [7, 8, 9, 10, 11, 12, 13, 14, 18, 19], [0, 1], [15, 17], [15, 17], [0, 1]], "periods": s211, "times": s212}},
"recovering": {
"kinds": {
"multicast": s170,
"to_all": s170,
"up": s171,
"down": s171,
"role": [0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 1, 1, 2, 1, 1, 1, 1, 1, 2, 2, 2, 1, 2, 2, 0, 2, 1, 2, 2],
"answers": [-1, 0, 0, 1, 3, 4, 5, 6, 6, 6, 6, 6, 6, -1, -1, -1, 1, 15, -1, -1],
"when": [0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 5000000, 5000000, 20000000, s1, s1, s1, s1, s1, s1, s1, s1, s1, 0, 0, 0, 20000000, 37500000, 0, 0],
"tcp": [0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1],
"to_unknown": s170,
},
"bursts": {"messages": [[0], [15], [15], [0]], "periods": s186, "times": s187},
"repairs": s188,
},
},
"Zenoh peer, tokens": {
"messages": [
s193,
s194,
{"name": "Hello first", "unit": s7, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 104},
{"name": "InitSyn", "unit": s7, "multicast": 0, "sent": 0.6667, "alone": 0.6667, "bytes": 109.86},
s195,
s196,
s197,
{"name": "OAM", "unit": s7, "multicast": 0, "sent": 0.7058, "alone": 1, "bytes": s213},
{"name": s199, "unit": s23, "multicast": 0, "sent": 0.45827594, "alone": 0.6493, "bytes": s213},
{"name": "Declare", "unit": s5, "multicast": 0, "sent": 0.03275, "alone": 0.5, "bytes": 167.6030534351145},
{"name": "Declare token", "unit": s5, "multicast": 0, "sent": 0.0603, "alone": 1, "bytes": s214},
{"name": s215, "unit": s7, "multicast": 0, "sent": 0.0603, "alone": 1, "bytes": s214},
{"name": s200, "unit": s202, "multicast": 0, "sent": 0.8957999999999999, "alone": 1.5, "bytes": s216},
{"name": s204, "unit": s44, "multicast": 0, "sent": 1.4929999999999999, "alone": 2.5, "bytes": s216},
{"name": s217, "unit": s7, "multicast": 0, "sent": 0.5972, "alone": 1, "bytes": s216},
{"name": "Declare final", "unit": s7, "multicast": 0, "sent": 0.06, "alone": 1, "bytes": 159.33333333333334},
{"name": "Frame", "unit": s7, "multicast": 0, "sent": 0.2704, "alone": 2, "bytes": s218},
{"name": s206, "unit": s5, "multicast": 0, "sent": 0.1352, "alone": 1, "bytes": s218},
s207,
s208,
{"name": "TCP ACK", "unit": s7, "multicast": 0, "sent": 0.7208, "alone": 0.7208, "bytes": 76},
{"name": s209, "unit": s7, "multicast": 0, "sent": 3.325, "alone": 3.325, "bytes": 76},
{"name": s210, "unit": s5, "multicast": 0, "sent": 0.4208, "alone": 0.4208, "bytes": 76},
],
"inside": [],
"alone": {"kinds": {"multicast": s219, "to_all": s219, "up": s220, "down": s220}, "bursts": {"messages": [[0, 2], [3, 4, 5, 6, 19], [7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 21, 22], [0, 1], [18, 20], [18, 20], [0, 1]], "periods": s211, "times": s212}},
"recovering": {
"kinds": {
"multicast": s219,
"to_all": s219,
"up": s220,
"down": s220,
"role": [0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 1, 1, 2, 1, 1, 1, 1, 1, 2, 2, 1, 2, 2, 1, 1, 2, 2, 0, 2, 1, 2, 2],
"answers": [-1, 0, 0, 1, 3, 4, 5, 6, 6, 6, 6, 6, 6, 6, 6, 6, -1, -1, -1, 1, 18, -1, -1],
"when": [0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"since": [0, 5000000, 5000000, 20000000, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, 0, 0, 0, 20000000, 37500000, 0, 0],
"tcp": [0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1],
"to_unknown": s219,
},
"bursts": {"messages": [[0], [18], [18], [0]], "periods": s186, "times": s187},
"repairs": s188,
},
},
"Zenoh router": {
"messages": [
{"name": "TCP SYN", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 76},
{"name": "TCP SYN-ACK", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 76},
{"name": "InitSyn", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 110},
{"name": "InitAck", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 153},
{"name": "OpenSyn", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 134},
{"name": "OpenAck", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 84},
{"name": "Interest in tokens", "unit": s2, "multicast": 0, "sent": 0.08917, "alone": 1, "bytes": s221},
{"name": "Interest of publishers", "unit": s109, "multicast": 0, "sent": 0.044585, "alone": 0.5, "bytes": s221},
{"name": "Declare", "unit": s109, "multicast": 0, "sent": 0.0435, "alone": 0.5, "bytes": 144.9655172413793},
{"name": s215, "unit": s2, "multicast": 0, "sent": 0.05144, "alone": 1, "bytes": s222},
{"name": "Declare token", "unit": s109, "multicast": 0, "sent": 0.05144, "alone": 1, "bytes": s222},
{"name": s217, "unit": s2, "multicast": 0, "sent": 1.0426, "alone": 2, "bytes": s223},
{"name": s200, "unit": s109, "multicast": 0, "sent": 0.7819499999999999, "alone": 1.5, "bytes": s223},
{"name": "Declare key expression of unmatched", "unit": s224, "multicast": 0, "sent": 0.26065, "alone": 0.5, "bytes": s223},
{"name": "Frame up", "unit": s2, "multicast": 0, "sent": 0.2063152, "alone": 1.417, "bytes": s225},
{"name": "Frame of endpoints up", "unit": s109, "multicast": 0, "sent": 0.1881152, "alone": 1.292, "bytes": s225},
{"name": "Declare passed on", "unit": [s43, "all"], "multicast": 0, "sent": 0.1347, "alone": 1, "bytes": 125.74016332590944},
{"name": "Declare token of own node", "unit": s2, "multicast": 0, "sent": 0.0309, "alone": 1, "bytes": s226},
{"name": "Declare own token", "unit": s109, "multicast": 0, "sent": 0.0309, "alone": 1, "bytes": s226},
{"name": "Declare token of node passed on", "unit": s146, "multicast": 0, "sent": 0.0309, "alone": 1, "bytes": s226},
{"name": "Declare token passed on", "unit": s189, "multicast": 0, "sent": 0.0309, "alone": 1, "bytes": s226},
{"name": "Declare key expression of node passed on", "unit": s146, "multicast": 0, "sent": 0.3319, "alone": 1, "bytes": s227},
{"name": "Declare key expression passed on", "unit": s189, "multicast": 0, "sent": 0.3319, "alone": 1, "bytes": s227},
{"name": "Declare final", "unit": s2, "multicast": 0, "sent": 0.06875, "alone": 1, "bytes": s228},
{"name": "Declare final to publishers", "unit": s109, "multicast": 0, "sent": 0.034375, "alone": 0.5, "bytes": s228},
{"name": "Frame down", "unit": s2, "multicast": 0, "sent": 0.3557808, "alone": 3.188, "bytes": s229},
{"name": "Frame of endpoints down", "unit": s109, "multicast": 0, "sent": 0.1345896, "alone": 1.206, "bytes": s229},
{"name": "Frame of others down", "unit": s189, "multicast": 0, "sent": 0.0027900000000000004, "alone": 0.025, "bytes": s229},
{"name": "KeepAlive up", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 79},
{"name": s230, "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 79},
{"name": "TCP ACK up", "unit": s2, "multicast": 0, "sent": 1, "alone": 1, "bytes": 76},
{"name": "TCP ACK down", "unit": s2, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 76},
{"name": "TCP ACK at start up", "unit": s2, "multicast": 0, "sent": 1.761, "alone": 1.761, "bytes": 76},
{"name": "TCP ACK of endpoints up", "unit": s109, "multicast": 0, "sent": 0.5636, "alone": 0.5636, "bytes": 76},
{"name": "TCP ACK of others up", "unit": s146, "multicast": 0, "sent": 0.7871, "alone": 0.7871, "bytes": 76},
{"name": s231, "unit": s2, "multicast": 0, "sent": 4.104, "alone": 4.104, "bytes": 76},
{"name": s232, "unit": s109, "multicast": 0, "sent": 0.07292, "alone": 0.07292, "bytes": 76},
],
"inside": [],
"alone": {"kinds": {"to_all": s233, "up": s234, "down": s235}, "bursts": {"messages": [s185, [6, 7, 8, 9, 10, 11, 12, 13, 14, 15], [16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 32, 33, 34, 35, 36], s236, s236], "periods": s237, "times": s238}},
"recovering": {
"kinds": {
"up": s234,
"down": s235,
"role": [0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"informs": [0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 1, 1, 1, 1, 1, 1, 1, 2, 1, 2, 1, 2, 2, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 0, 0, 1, 1, 2, 2, 1, 2, 2],
"answers": [-1, 0, 1, 2, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 7, 9, 10, 9, 10, 9, 10, 6, 7, 14, 14, 14, -1, -1, 29, 28, 25, 26, 22, 14, 15],
"since": [0, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, s1, 0, 0, 450000000, 450000000, s1, s1, s1, s1, s1],
"tcp": s233,
"to_unknown": s239,
"leg": [1, 2, 1, 2, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 3, 3, 3, 3, 2, 2, 2, 2, 3, 1, 2, 1, 2, 1, 1, 4, 2, 2],
},
"bursts": {"messages": [[0], [28, 29], [28, 29]], "periods": s240, "times": s241},
"repairs": s242,
"server": true,
},
},
"Zenoh router per host": {
"messages": [
{"name": "TCP control", "unit": s82, "multicast": 0, "sent": 1, "alone": 1, "bytes": 76},
{"name": "InitSyn", "unit": s82, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 110},
{"name": "InitAck", "unit": s82, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 153},
{"name": "OpenSyn", "unit": s82, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 134},
{"name": "OpenAck", "unit": s82, "multicast": 0, "sent": 0.5, "alone": 0.5, "bytes": 84},
{"name": "OAM", "unit": s82, "multicast": 0, "sent": 0.08288, "alone": 2, "bytes": s243},
{"name": "OAM of third hosts", "unit": s244, "multicast": 0, "sent": 0.012205367999999998, "alone": 0.3843, "bytes": s245},
{"name": "OAM passed on", "unit": ["host", "other host", "link"], "multicast": 0, "sent": 0.014974839999999998, "alone": 0.4715, "bytes": s245},
{"name": s246, "unit": s82, "multicast": 0, "sent": 3.670725, "alone": 4.25, "bytes": s247},
{"name": "Frame of gossip passed on", "unit": s244, "multicast": 0, "sent": 1.38192, "alone": 1.6, "bytes": s247},
{"name": s206, "unit": s248, "multicast": 0, "sent": 0.6693675, "alone": 0.775, "bytes": s247},
{"name": "Declare", "unit": s249, "multicast": 0, "sent": 0.002072, "alone": 0.5, "bytes": s243},
{"name": s250, "unit": s252, "multicast": 0, "sent": 0.002072, "alone": 0.5, "bytes": s243},
{"name": s215, "unit": s81, "multicast": 0, "sent": 0.004144, "alone": 1, "bytes": s243},
{"name": "Declare token", "unit": s248, "multicast": 0, "sent": 0.004144, "alone": 1, "bytes": s243},
{"name": s200, "unit": s249, "multicast": 0, "sent": 0.0569, "alone": 0.5, "bytes": s253},
{"name": s204, "unit": s252, "multicast": 0, "sent": 0.029974920000000002, "alone": 0.2634, "bytes": s253},
{"name": s254, "unit": s248, "multicast": 0, "sent": 0.1138, "alone": 1, "bytes": s253},
{"name": s217, "unit": s81, "multicast": 0, "sent": 0.1138, "alone": 1, "bytes": s253},
{"name": "KeepAlive", "unit": s82, "multicast": 0, "sent": 1, "alone": 1, "bytes": 79},
{"name": "TCP ACK", "unit": s82, "multicast": 0, "sent": 0.55, "alone": 0.55, "bytes": 76},
{"name": s209, "unit": s82, "multicast": 0, "sent": 6.597, "alone": 6.597, "bytes": 76},
{"name": "TCP ACK of gossip", "unit": s244, "multicast": 0, "sent": 0.2278, "alone": 0.2278, "bytes": 76},
{"name": s210, "unit": s248, "multicast": 0, "sent": 0.1124, "alone": 0.1124, "bytes": 76},
],
"inside": [],
"alone": {"kinds": {"up": s51, "down": s51}, "bursts": {"messages": [[0, 1, 2, 3, 4], [5, 6, 7, 8, 9], [10, 11, 12, 13, 14, 15, 16, 17, 18, 21, 22, 23], [19, 20], [19, 20]], "periods": s237, "times": s238}},
"recovering": {
"kinds": {
"up": s51,
"down": s51,
"role": [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0],
"informs": [0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0],
"of_host": [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0],
"trigger": [0, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 0, 1, 2, 2, 2],
"answers": [-1, 0, 1, 2, 3, 4, 5, 5, 5, 6, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 19, -1, 6, -1],
"since": [0, s1, s1, s1, s1, s1, s1, s1, s1, s1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 450000000, 0, s1, 0],
"tcp": s51,
"to_unknown": s50,
"to_host": s51,
},
"bursts": {"messages": [[0], [19], [19]], "periods": s240, "times": s241},
"repairs": s242,
},
},
"Zenoh router per host, star": {
"messages": [
{"name": "TCP control", "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 76},
{"name": "TCP control down", "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 76},
{"name": "InitSyn", "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 110},
{"name": "InitAck", "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 153},
{"name": "OpenSyn", "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 134},
{"name": "OpenAck", "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 84},
{"name": "OAM", "unit": ["host", "all"], "multicast": 0, "sent": 0.07202, "alone": 2, "bytes": s255},
{"name": "OAM of others", "unit": s82, "multicast": 0, "sent": 0.037630449999999996, "alone": 1.045, "bytes": s255},
{"name": s246, "unit": ["host", "all"], "multicast": 0, "sent": 10.832892, "alone": 12.18, "bytes": s256},
{"name": s206, "unit": s109, "multicast": 0, "sent": 0.36260838, "alone": 0.4077, "bytes": s256},
{"name": "Declare", "unit": s224, "multicast": 0, "sent": 0.002072, "alone": 0.5, "bytes": s243},
{"name": s250, "unit": s257, "multicast": 0, "sent": 0.002072, "alone": 0.5, "bytes": s243},
{"name": s215, "unit": s2, "multicast": 0, "sent": 0.004144, "alone": 1, "bytes": s243},
{"name": "Declare token", "unit": s109, "multicast": 0, "sent": 0.004144, "alone": 1, "bytes": s243},
{"name": s200, "unit": s224, "multicast": 0, "sent": 0.05795, "alone": 0.5, "bytes": s258},
{"name": s204, "unit": s257, "multicast": 0, "sent": 0.01207678, "alone": 0.1042, "bytes": s258},
{"name": s254, "unit": s109, "multicast": 0, "sent": 0.1159, "alone": 1, "bytes": s258},
{"name": s217, "unit": s2, "multicast": 0, "sent": 0.1159, "alone": 1, "bytes": s258},
{"name": "KeepAlive", "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 79},
{"name": "TCP ACK", "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 76},
{"name": s209, "unit": ["host", "all"], "multicast": 0, "sent": 3.783, "alone": 3.783, "bytes": 76},
{"name": "TCP ACK of processes", "unit": s81, "multicast": 0, "sent": 1.217, "alone": 1.217, "bytes": 76},
{"name": "OAM down", "unit": ["host", "all"], "multicast": 0, "sent": 0.09748, "alone": 2, "bytes": s259},
{"name": "OAM of others down", "unit": s82, "multicast": 0, "sent": 0.050933299999999994, "alone": 1.045, "bytes": s259},
{"name": "Frame of gossip down", "unit": ["host", "all"], "multicast": 0, "sent": 21.536255999999998, "alone": 26.88, "bytes": 87.23315027458811},
{"name": "Declare down", "unit": s249, "multicast": 0, "sent": 0.0027625, "alone": 0.5, "bytes": s260},
{"name": "Declare of matching down", "unit": s252, "multicast": 0, "sent": 0.0027625, "alone": 0.5, "bytes": s260},
{"name": "Declare token of node down", "unit": s81, "multicast": 0, "sent": 0.005525, "alone": 1, "bytes": s260},
{"name": "Declare token down", "unit": s248, "multicast": 0, "sent": 0.005525, "alone": 1, "bytes": s260},
{"name": "Declare key expression down", "unit": s249, "multicast": 0, "sent": 0.05795, "alone": 0.5, "bytes": s258},
{"name": "Declare key expression of matching down", "unit": s252, "multicast": 0, "sent": 0.00724375, "alone": 0.0625, "bytes": s258},
{"name": "Declare key expression of tokens down", "unit": s248, "multicast": 0, "sent": 0.1159, "alone": 1, "bytes": s258},
{"name": "Declare key expression of node down", "unit": s81, "multicast": 0, "sent": 0.1159, "alone": 1, "bytes": s258},
{"name": s230, "unit": ["host", "all"], "multicast": 0, "sent": 1, "alone": 1, "bytes": 79},
{"name": "TCP ACK down", "unit": s175, "multicast": 0, "sent": 1, "alone": 1, "bytes": 76},
{"name": s231, "unit": ["host", "all"], "multicast": 0, "sent": 4.958, "alone": 4.958, "bytes": 76},
{"name": s232, "unit": s109, "multicast": 0, "sent": 0.1354, "alone": 0.1354, "bytes": 76},
],
"inside": [],
"alone": {
"kinds": {"to_all": [1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1], "up": s261, "down": s262},
"bursts": {"messages": [s185, [6, 7, 8, 22, 23, 24], [9, 10, 11, 12, 13, 14, 15, 16, 17, 20, 21, 25, 26, 27, 28, 29, 30, 31, 32, 35, 36], s263, s263], "periods": s237, "times": s238},
},
"recovering": {
"kinds": {
"up": s261,
"down": s262,
"role": [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0],
"informs": [0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0],
"of_host": [1, 0, 1, 0, 1, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
"trigger": [0, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 0, 0, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 0, 0, 2, 2],
"answers": [-1, 0, 1, 2, 3, 4, 5, 6, 6, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 18, -1, -1, 5, 22, 22, -1, -1, -1, -1, -1, -1, -1, -1, -1, 33, -1, -1],
"since": [0, s1, s1, s1, s1, s1, s1, s1, s1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 450000000, 0, 0, s1, s1, s1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 450000000, 0, 0],
"tcp": s233,
"to_unknown": s239,
"leg": [1, 2, 1, 2, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 3, 2, 3, 3, 3, 3, 3, 3, 3, 3, 2, 2, 2, 2],
"to_host": [0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 0],
},
"bursts": {"messages": [[0], s263, s263], "periods": s240, "times": s241},
"repairs": s242,
"server": true,
},
},
},
"radios": {
"paper (802.11n)": s268,
"802.11a 20 MHz 1x1": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": {"bits": 216, "added": 22, "symbol": 40, "grid": 40, "preamble": 200},
"slow": s267,
},
"802.11g 20 MHz 1x1": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": {"bits": 216, "added": 22, "symbol": 40, "grid": 40, "preamble": 260},
"slow": s269,
},
"802.11n 20 MHz 2x2": s268,
"802.11n 20 MHz 2x2, 2.4 GHz": {
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
"mpdus": 1,
"window": 1,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s270,
"slow": s269,
},
"802.11n 40 MHz 2x2": {
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
"mpdus": 1,
"window": 1,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s271,
"slow": s267,
},
"802.11ac 80 MHz 2x2": {
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
"mpdus": 1,
"window": 1,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s272,
"slow": s267,
},
"802.11ax 20 MHz 2x2, 2.4 GHz": {
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
"mpdus": 1,
"window": 1,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s273,
"slow": s269,
},
"802.11ax 80 MHz 2x2": {
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
"mpdus": 1,
"window": 1,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s274,
"slow": s267,
},
"802.11ax 160 MHz 2x2": {
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
"mpdus": 1,
"window": 1,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s275,
"slow": s267,
},
"802.11be 80 MHz 2x2": {
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
"mpdus": 1,
"window": 1,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s276,
"slow": s267,
},
"802.11be 320 MHz 2x2": {
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
"mpdus": 1,
"window": 1,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s277,
"slow": s267,
},
"802.11n 20 MHz 2x2, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s266,
"slow": s267,
},
"802.11n 20 MHz 2x2, 2.4 GHz, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s270,
"slow": s269,
},
"802.11n 40 MHz 2x2, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s271,
"slow": s267,
},
"802.11ac 80 MHz 2x2, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s272,
"slow": s267,
},
"802.11ax 20 MHz 2x2, 2.4 GHz, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s273,
"slow": s269,
},
"802.11ax 80 MHz 2x2, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s274,
"slow": s267,
},
"802.11ax 160 MHz 2x2, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s275,
"slow": s267,
},
"802.11be 80 MHz 2x2, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s276,
"slow": s267,
},
"802.11be 320 MHz 2x2, A-MPDU 64": {
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": s277,
"slow": s267,
},
"802.11n 20 MHz 1x1, A-MPDU 16": {
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
"preamble": 360,
"symbol": 36,
"grid": 40,
"bits": 260,
"added": 22,
"addba": 760,
"basic_ack": 440,
"mpdus": 16,
"max_bytes": 49169,
"window": 64,
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": true,
"fast": {"bits": 260, "added": 22, "symbol": 36, "grid": 40, "preamble": 360},
"slow": s267,
},
"802.11n 20 MHz 2x2, AIFSN 3": {
"record": {
"slot": 90,
"sifs": 160,
"aifs": 430,
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
"capture_threshold": s264,
"capture_threshold_basic": s265,
},
"aggregates": false,
"fast": s266,
"slow": s267,
},
},
};
})();
