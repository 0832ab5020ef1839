// Made from the package by `make calculator` with sympy 1.14.0; do not edit.
const DISCOSTORM = (() => {
  const shared1 = "a whole number of at least 1 and at most 1,000,000,000";
  const shared2 = "a number of at least 0 and at most 1,000,000,000";
  const shared3 = "sending multicast at 24 instead of 6 Mbit/s";
  const shared4 = {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared5 = {"name": "paper (802.11n)", "model": "padded", "values": shared4};
  const shared6 = {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared7 = {"name": "802.11n 20 MHz 2x2, multicast 24 Mbit/s", "model": "padded", "values": shared6};
  const shared8 = {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared9 = {"name": "802.11n 40 MHz 2x2", "model": "padded", "values": shared8};
  const shared10 = {"R_uni": 866666666.6666666, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared11 = {"name": "802.11ac 80 MHz 2x2", "model": "padded", "values": shared10};
  const shared12 = {"R_uni": 2401960784.3137255, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared13 = {"name": "802.11ax 160 MHz 2x2", "model": "padded", "values": shared12};
  const shared14 = {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0};
  const shared15 = {"name": "802.11n 20 MHz 2x2, A-MPDU 64", "model": "aggregated", "values": shared14};
  const shared16 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared17 = {"name": "802.11a 20 MHz 1x1", "model": "padded", "values": shared16};
  const shared18 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared19 = {"R_uni": 54000000, "O_uni": 0.0001655, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 216, "N_add_uni": 22, "k_uni": 1, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
  const shared20 = "sending multicast at 24 instead of 1 Mbit/s";
  const shared21 = {"name": "802.11g 20 MHz 1x1", "model": "padded", "values": shared19};
  const shared22 = {"name": "802.11n 20 MHz 2x2", "model": "padded", "values": shared4};
  const shared23 = {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
  const shared24 = {"name": "802.11n 20 MHz 2x2, 2.4 GHz", "model": "padded", "values": shared23};
  const shared25 = {
    "name": "802.11n 40 MHz 2x2, A-MPDU 64",
    "model": "aggregated",
    "values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
  };
  const shared26 = {"R_uni": 866666666.6666666, "O_uni": 0.0001895, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0};
  const shared27 = {"name": "802.11ac 80 MHz 2x2, A-MPDU 64", "model": "aggregated", "values": shared26};
  const shared28 = {"R_uni": 286764705.88235295, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06};
  const shared29 = {"name": "802.11ax 20 MHz 2x2, 2.4 GHz", "model": "padded", "values": shared28};
  const shared30 = {"R_uni": 1200980392.1568627, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared31 = {"name": "802.11ax 80 MHz 2x2", "model": "padded", "values": shared30};
  const shared32 = {"R_uni": 1200980392.1568627, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0};
  const shared33 = {"name": "802.11ax 80 MHz 2x2, A-MPDU 64", "model": "aggregated", "values": shared32};
  const shared34 = {
    "name": "802.11ax 160 MHz 2x2, A-MPDU 64",
    "model": "aggregated",
    "values": {"R_uni": 2401960784.3137255, "O_uni": 0.0001959, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 1629214, "O_agg": 0.0001999, "A_least": 0},
  };
  const shared35 = {"R_uni": 1441176470.5882354, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared36 = {"name": "802.11be 80 MHz 2x2", "model": "padded", "values": shared35};
  const shared37 = {"R_uni": 5764705882.3529415, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06};
  const shared38 = {"name": "802.11be 320 MHz 2x2", "model": "padded", "values": shared37};
  const shared39 = "another radio (802.11ax 160 MHz 2x2, A-MPDU 64)";
  const shared40 = {"price": "the nodes must be built as components", "whole": true, "why": "fewer processes have fewer pairs that must find each other"};
  const shared41 = {"price": "parameters can no longer be read or set from outside; with every protocol a service is counted as the two endpoints of DDS", "whole": true, "why": "their endpoints are told to nobody"};
  const shared42 = {"price": "hosts too far away for this rate hear no multicast", "whole": true, "why": "multicast frames are shorter"};
  const shared43 = {"price": "all hosts and the access point need it, and must be near enough for its rate", "whole": true, "why": "unicast frames are shorter, but for their overhead"};
  const shared44 = {"price": "computed as if every exchange were full, so at best; a queue need not hold so many frames for one receiver", "whole": true, "why": "unicast frames share waiting, preamble and acknowledgement; multicast frames never do"};
  const shared45 = {"price": "all hosts must change together", "whole": true, "why": "other messages of other sizes"};
  const shared46 = {"until": [[1, "within a second at best"], [Infinity, "slow at best"], [Infinity, "leases at risk"]], "never": "never catches up"};
  const shared47 = {"count": "count", "more": ["more", "more2"]};
  const shared48 = [shared47, shared47];
  const shared49 = {"count": "count2", "more": ["more3", "more4", "more5"]};
  const shared50 = [shared49, shared49];
  const shared51 = {"count": "count3", "more": ["more6", "more7", "more8"]};
  const shared52 = [shared51, shared51];
  const shared53 = [shared48, shared52, shared50];
  const shared54 = {"until": [[1, "within a second at best"], [10, "slow at best"], [Infinity, "leases at risk"]], "never": "never catches up"};
  const shared55 = {"second": 1, "lease": 10, "ever": Infinity};
  const shared56 = {"count": "count4", "more": ["more9", "more10", "more11", "more12"]};
  const shared57 = [shared56, shared56];
  const shared58 = {"count": "count5", "more": ["more13", "more14", "more15", "more16"]};
  const shared59 = [shared58, shared58];
  const shared60 = [{"count": "count6", "more": []}, {"count": "count7", "more": ["more17", "more18", "more19"]}];
  const shared61 = [shared48, shared52, shared50, shared57, shared59, shared60];
  const shared62 = {"burst": 1.9875, "second": 2.1125, "lease": 0.32375, "ever": 0.125};
  const shared63 = {"burst": 0.9875, "second": 1.1125, "lease": 0.22375, "ever": 0.125};
  const shared64 = {"burst": 4, "second": 4, "lease": 0.4, "ever": 0};
  const shared65 = {"burst": 1, "second": 1, "lease": 0.1, "ever": 0};
  const shared66 = {"burst": 0, "second": 0.125, "lease": 0.125, "ever": 0.125};
  const shared67 = {"name": "Liveliness", "cast": "unicast", "bytes": 179.99005799502902, "frames": 0.7242, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared66};
  const shared68 = {"name": "Liveliness Heartbeat", "cast": "unicast", "bytes": 180.02610587382162, "frames": 0.2758, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared66};
  const shared69 = {"name": "Liveliness ACKNACK", "cast": "unicast", "bytes": 128, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared66};
  const shared70 = [shared48, shared52, shared50, shared59, shared60];
  const shared71 = {"name": "SPDP", "cast": "multicast", "bytes": 476, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared62};
  const shared72 = {"count": "count8", "more": ["more20", "more21", "more2"]};
  const shared73 = {"count": "count9", "more": ["more22", "more23", "more24"]};
  const shared74 = [shared73, shared73];
  const shared75 = {"burst": 1, "second": 1.125, "lease": 0.225, "ever": 0.125};
  const shared76 = {"until": [[1, "within a second at best"], [20, "slow at best"], [Infinity, "leases at risk"]], "never": "never catches up"};
  const shared77 = {"second": 1, "lease": 20, "ever": Infinity};
  const shared78 = {"count": "count11", "more": ["more28", "more29"]};
  const shared79 = [shared78, shared78];
  const shared80 = {"count": "count12", "more": ["more30", "more31", "more5"]};
  const shared81 = [{"count": "count6", "more": []}, {"count": "count13", "more": ["more32", "more33", "more27"]}];
  const shared82 = [shared48, [{"count": "count6", "more": []}, {"count": "count10", "more": ["more25", "more26", "more27"]}], shared79, [{"count": "count6", "more": []}, shared80], shared81, shared60];
  const shared83 = {"burst": 5.833333333333333, "second": 6.166666666666666, "lease": 0.625, "ever": 0.3333333333333333};
  const shared84 = {"burst": 0.5, "second": 0.8333333333333333, "lease": 0.35833333333333334, "ever": 0.3333333333333333};
  const shared85 = {"burst": 1, "second": 1, "lease": 0.05, "ever": 0};
  const shared86 = {"name": "Liveliness Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 4, "per_unit": 1.292, "hops": ["up", "down"], "sent": shared85};
  const shared87 = {"name": "Liveliness ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 4, "per_unit": 1.292, "hops": ["up", "down"], "sent": shared85};
  const shared88 = {"name": "User Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 5, "per_unit": 1.021, "hops": ["up", "down"], "sent": shared85};
  const shared89 = {"name": "User ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 5, "per_unit": 1.021, "hops": ["up", "down"], "sent": shared85};
  const shared90 = {"count": "count14", "more": ["more34", "more2"]};
  const shared91 = {"count": "count16", "more": ["more37", "more29"]};
  const shared92 = {"count": "count18", "more": ["more40", "more41", "more8"]};
  const shared93 = [shared92, shared92];
  const shared94 = {"burst": 4.833333333333333, "second": 5.166666666666666, "lease": 0.575, "ever": 0.3333333333333333};
  const shared95 = {"until": [[1, "within a second at best"], [23, "slow at best"], [Infinity, "leases at risk"]], "never": "never catches up"};
  const shared96 = {"second": 1, "lease": 23, "ever": Infinity};
  const shared97 = {"count": "count19", "more": ["more42", "more24"]};
  const shared98 = [shared97, shared97];
  const shared99 = [{"count": "more24", "more": ["more24"]}, {"count": "more24", "more": ["more24"]}];
  const shared100 = {"burst": 1, "second": 1, "lease": 0.043478260869565216, "ever": 0};
  const shared101 = {"name": "Announce", "cast": "multicast", "bytes": 80, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared100};
  const shared102 = {"name": "Process", "cast": "multicast", "bytes": 24, "frames": 0, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared100};
  const shared103 = {"name": "Endpoint", "cast": "multicast", "bytes": 20, "frames": 0, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared100};
  const shared104 = {"name": "Digest", "cast": "multicast", "bytes": 80, "frames": 1, "unit": 3, "per_unit": 1, "hops": ["up", "down"], "sent": shared100};
  const shared105 = {"name": "Listed", "cast": "multicast", "bytes": 1, "frames": 0, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared100};
  const shared106 = {"burst": 0, "second": 0.3333333333333333, "lease": 0.3333333333333333, "ever": 0.3333333333333333};
  const shared107 = {"name": "Heartbeat", "cast": "multicast", "bytes": 80, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared106};
  const shared108 = {"name": "Claimed", "cast": "multicast", "bytes": 0.125, "frames": 0, "unit": 4, "per_unit": 1, "hops": ["up", "down"], "sent": shared106};
  const shared109 = {"count": "count20", "more": ["count20"]};
  const shared110 = "The paper's messages, a product's periods";
  const shared111 = {"burst": 3.125, "second": 3.25, "lease": 0.4375, "ever": 0.125};
  const shared112 = {"burst": 0, "second": 0.4, "lease": 0.4, "ever": 0.4};
  const shared113 = [shared80, shared80];
  const shared114 = {"count": "count21", "more": ["more43", "more44"]};
  const shared115 = {"count": "count22", "more": ["more45", "more46", "more47"]};
  const shared116 = [shared48, shared52, shared59, shared50, [shared49, {"count": "count6", "more": []}], shared60];
  const shared117 = {"name": "Scout", "cast": "multicast", "bytes": 67, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared111};
  const shared118 = {"name": "Hello", "cast": "unicast", "bytes": 104, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": {"burst": 2.125, "second": 2.25, "lease": 0.3375, "ever": 0.125}};
  const shared119 = {"name": "InitAck", "cast": "unicast", "bytes": 153, "frames": 1, "unit": 1, "per_unit": 0.6667, "hops": ["up", "down"], "sent": shared65};
  const shared120 = {"name": "OpenSyn", "cast": "unicast", "bytes": 134, "frames": 1, "unit": 1, "per_unit": 0.6667, "hops": ["up", "down"], "sent": shared65};
  const shared121 = {"name": "OpenAck", "cast": "unicast", "bytes": 84, "frames": 1, "unit": 1, "per_unit": 0.6667, "hops": ["up", "down"], "sent": shared65};
  const shared122 = {"name": "KeepAlive", "cast": "unicast", "bytes": 79, "frames": 1, "unit": 1, "per_unit": 1.333, "hops": ["up", "down"], "sent": shared112};
  const shared123 = {"name": "TCP control", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 1, "per_unit": 1.333, "hops": ["up", "down"], "sent": shared65};
  const shared124 = {"burst": 1, "second": 1, "lease": 0.016666666666666666, "ever": 0};
  const shared125 = {"burst": 0, "second": 0.03333333333333333, "lease": 0.03333333333333333, "ever": 0.03333333333333333};
  return {
    "start": {"robot": "Nav2 in one process", "middleware": "Fast DDS"},
    "groups": ["Products as built", "As the paper counts", "The paper's messages, a product's periods", "Other tables", "Products arranged against the storm"],
    "palette": ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"],
    "fields": {
      "swarm": [
        {"name": "hosts", "label": "Robots", "symbol": "N_H", "unit": "", "scale": 1, "start": "5", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": shared1},
        {"name": "processes", "label": "Processes on each", "symbol": "N_P", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": shared1},
        {"name": "endpoints", "label": "Endpoints a process", "symbol": "N_E", "unit": "", "scale": 1, "start": "678", "low": 0, "high": 1000000000, "above": false, "whole": false, "allowed": shared2},
      ],
      "beside": [
        {"name": "beside_hosts", "label": "How many", "symbol": "N_H1", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": shared1},
        {"name": "beside_processes", "label": "Processes on each of them", "symbol": "N_P1", "unit": "", "scale": 1, "start": "1", "low": 1, "high": 1000000000, "above": false, "whole": true, "allowed": shared1},
        {"name": "beside_endpoints", "label": "Endpoints of each of these", "symbol": "N_E1", "unit": "", "scale": 1, "start": "90", "low": 0, "high": 1000000000, "above": false, "whole": false, "allowed": shared2},
      ],
      "own": [
        {"name": "unicast_rate", "label": "Rate, unicast", "symbol": "R_uni", "unit": "Mbit/s", "scale": 1000000, "start": "144.4", "low": 0, "high": Infinity, "above": true, "whole": false, "allowed": "a number above 0"},
        {"name": "unicast_overhead", "label": "Overhead of a frame, unicast", "symbol": "O_uni", "unit": "µs", "scale": 1e-06, "start": "180", "low": 0, "high": Infinity, "above": false, "whole": false, "allowed": "a number of at least 0"},
        {"name": "multicast_rate", "label": "Rate, multicast", "symbol": "R_multi", "unit": "Mbit/s", "scale": 1000000, "start": "6", "low": 0, "high": Infinity, "above": true, "whole": false, "allowed": "a number above 0"},
        {"name": "multicast_overhead", "label": "Overhead of a frame, multicast", "symbol": "O_multi", "unit": "µs", "scale": 1e-06, "start": "120", "low": 0, "high": Infinity, "above": false, "whole": false, "allowed": "a number of at least 0"},
      ],
    },
    "robots": [
      {"name": "The paper's swarm", "processes": "2", "endpoints": "10", "nodes": 0, "parts": [{"what": "processes with ten endpoints each", "processes": 2, "endpoints": 20, "kind": "printed", "source": "paper, Fig. 2"}]},
      {"name": "One bare node", "processes": "1", "endpoints": "18", "nodes": 1, "parts": [{"what": "participant, rclcpp node and one topic", "processes": 1, "endpoints": 18, "kind": "counted", "source": "the parts of rviz_endpoints.csv: 2 of the participant and 15 of a node; 1 publisher"}]},
      {"name": "Nav2 in one process", "processes": "1", "endpoints": "678", "nodes": 13, "parts": [{"what": "composed Nav2", "processes": 1, "endpoints": 678, "kind": "printed", "source": "paper, Sec. IV-C; nodes: nav2_nodes.csv"}]},
      {
        "name": "TurtleBot 4 with Nav2",
        "processes": "22",
        "endpoints": "42.1818",
        "nodes": 1.1363636363636365,
        "parts": [{"what": "Nav2's servers, each in a process of its own", "processes": 11, "endpoints": 698, "kind": "estimated", "source": "678 of paper, Sec. IV-C, and 2 for each of ten further participants; processes: turtlebot4 (humble, d688175), nav2.launch.py and localization.launch.py, which do not compose; nodes: nav2_nodes.csv"}, {"what": "drivers, description, joystick and diagnostics; without the Create 3 base, which is wired to them", "processes": 11, "endpoints": 230, "kind": "estimated", "source": "turtlebot4_robot (humble, f2f30da), standard.launch.py and diagnostics.launch.py: 17 for each participant with its node, and the topics that turtlebot4_base and turtlebot4_diagnostics create; topics of the other drivers would add to it"}],
      },
      {
        "name": "Drone, PX4 through uXRCE-DDS",
        "processes": "2",
        "endpoints": "45.5",
        "nodes": 0.5,
        "parts": [{"what": "agent: 29 topics out, 40 in, one service", "processes": 1, "endpoints": 71, "kind": "counted", "source": "PX4-Autopilot (00743c6), src/modules/uxrce_dds_client/dds_topics.yaml and vehicle_command_srv.cpp; all of them are there once each has been used"}, {"what": "a node that flies offboard", "processes": 1, "endpoints": 20, "kind": "counted", "source": "the parts of rviz_endpoints.csv: 2 of the participant and 15 of a node; three publishers: offboard_control_mode, trajectory_setpoint, vehicle_command"}],
      },
      {
        "name": "Drone, PX4 through MAVROS",
        "processes": "1",
        "endpoints": "1207",
        "nodes": 61,
        "parts": [{"what": "mavros_node with the plugins of px4_pluginlists.yaml", "processes": 1, "endpoints": 1207, "kind": "estimated", "source": "mavros 2.12.0: 59 plugins and 3 nodes of 15 (the one for parameters has 2), 2 of the participant; the source of these plugins has 162 lines that create a publisher or subscription, 58 that create a service, 5 a client"}],
      },
      {
        "name": "Manipulator with MoveIt",
        "processes": "3",
        "endpoints": "72.3333",
        "nodes": 2.3333333333333335,
        "parts": [{"what": "move_group", "processes": 1, "endpoints": 113, "kind": "estimated", "source": "moveit2 (8fcb5d2): three nodes of 15, and what the default capabilities, the planning scene monitor and one trajectory controller create: 15 services, two action servers and one client of 8 endpoints each, 12 topics; 2 of the participant"}, {"what": "ros2_control_node with a state broadcaster and a trajectory controller", "processes": 1, "endpoints": 83, "kind": "estimated", "source": "ros2_control (006681b): 2 of the participant, three nodes of 15, 10 services of the controller manager, one of the controller, its action server of 8 and 6 topics"}, {"what": "robot_state_publisher", "processes": 1, "endpoints": 21, "kind": "estimated", "source": "2 of the participant, 15 of the node; robot_description, tf, tf_static and joint_states"}],
      },
    ],
    "channels": [
      {
        "name": "paper (802.11n)",
        "model": "linear",
        "values": {"R_uni": 144400000, "O_uni": 0.00018, "R_multi": 6000000, "O_multi": 0.00012},
        "remedies": [
          {"kind": "multicast rate", "what": shared3, "note": "both by the standard's timing", "base": shared5, "wifi": shared7},
          {"kind": "radio", "what": "another radio (802.11n 40 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2, both by the standard's timing: 300 instead of 144 Mbit/s and 186 µs of overhead an exchange", "base": shared5, "wifi": shared9},
          {"kind": "radio", "what": "another radio (802.11ac 80 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2, both by the standard's timing: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead an exchange", "base": shared5, "wifi": shared11},
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2, both by the standard's timing: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead an exchange", "base": shared5, "wifi": shared13},
          {"kind": "aggregation", "what": "aggregating up to 64 frames", "note": "both by the standard's timing", "base": shared5, "wifi": shared15},
        ],
      },
      {
        "name": "802.11a 20 MHz 1x1",
        "model": "padded",
        "values": shared16,
        "remedies": [
          {"kind": "multicast rate", "what": shared3, "note": "", "base": shared17, "wifi": {"name": "802.11a 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": shared18}},
          {"kind": "radio", "what": "another radio (802.11n 40 MHz 2x2)", "note": "instead of 802.11a 20 MHz 1x1: 300 instead of 54 Mbit/s and 186 instead of 166 µs of overhead an exchange", "base": shared17, "wifi": shared9},
          {"kind": "radio", "what": "another radio (802.11ac 80 MHz 2x2)", "note": "instead of 802.11a 20 MHz 1x1: 867 instead of 54 Mbit/s and 190 instead of 166 µs of overhead an exchange", "base": shared17, "wifi": shared11},
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11a 20 MHz 1x1: 2402 instead of 54 Mbit/s and 196 instead of 166 µs of overhead an exchange", "base": shared17, "wifi": shared13},
        ],
      },
      {
        "name": "802.11g 20 MHz 1x1",
        "model": "padded",
        "values": shared19,
        "remedies": [
          {"kind": "multicast rate", "what": shared20, "note": "", "base": shared21, "wifi": {"name": "802.11g 20 MHz 1x1, multicast 24 Mbit/s", "model": "padded", "values": shared18}},
          {"kind": "radio", "what": "another radio (802.11n 40 MHz 2x2)", "note": "instead of 802.11g 20 MHz 1x1: 300 instead of 54 Mbit/s, 186 instead of 166 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared21, "wifi": shared9},
          {"kind": "radio", "what": "another radio (802.11ac 80 MHz 2x2)", "note": "instead of 802.11g 20 MHz 1x1: 867 instead of 54 Mbit/s, 190 instead of 166 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared21, "wifi": shared11},
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11g 20 MHz 1x1: 2402 instead of 54 Mbit/s, 196 instead of 166 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared21, "wifi": shared13},
        ],
      },
      {
        "name": "802.11n 20 MHz 2x2",
        "model": "padded",
        "values": shared4,
        "remedies": [
          {"kind": "multicast rate", "what": shared3, "note": "", "base": shared22, "wifi": shared7},
          {"kind": "radio", "what": "another radio (802.11n 40 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2: 300 instead of 144 Mbit/s and 186 µs of overhead an exchange", "base": shared22, "wifi": shared9},
          {"kind": "radio", "what": "another radio (802.11ac 80 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs of overhead an exchange", "base": shared22, "wifi": shared11},
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2: 2402 instead of 144 Mbit/s and 196 instead of 186 µs of overhead an exchange", "base": shared22, "wifi": shared13},
          {"kind": "aggregation", "what": "aggregating up to 64 frames", "note": "", "base": shared22, "wifi": shared15},
        ],
      },
      {
        "name": "802.11n 20 MHz 2x2, 2.4 GHz",
        "model": "padded",
        "values": shared23,
        "remedies": [
          {"kind": "multicast rate", "what": shared20, "note": "", "base": shared24, "wifi": {"name": "802.11n 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s", "model": "padded", "values": shared6}},
          {"kind": "radio", "what": "another radio (802.11n 40 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2, 2.4 GHz: 300 instead of 144 Mbit/s, 186 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared24, "wifi": shared9},
          {"kind": "radio", "what": "another radio (802.11ac 80 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2, 2.4 GHz: 867 instead of 144 Mbit/s, 190 instead of 186 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared24, "wifi": shared11},
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11n 20 MHz 2x2, 2.4 GHz: 2402 instead of 144 Mbit/s, 196 instead of 186 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared24, "wifi": shared13},
          {
            "kind": "aggregation",
            "what": "aggregating up to 64 frames",
            "note": "",
            "base": shared24,
            "wifi": {
              "name": "802.11n 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
              "model": "aggregated",
              "values": {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
            },
          },
        ],
      },
      {
        "name": "802.11n 40 MHz 2x2",
        "model": "padded",
        "values": shared8,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared9,
            "wifi": {
              "name": "802.11n 40 MHz 2x2, multicast 24 Mbit/s",
              "model": "padded",
              "values": {"R_uni": 300000000, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 1080, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
            },
          },
          {"kind": "radio", "what": "another radio (802.11ac 80 MHz 2x2)", "note": "instead of 802.11n 40 MHz 2x2: 867 instead of 300 Mbit/s and 190 instead of 186 µs of overhead an exchange", "base": shared9, "wifi": shared11},
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11n 40 MHz 2x2: 2402 instead of 300 Mbit/s and 196 instead of 186 µs of overhead an exchange", "base": shared9, "wifi": shared13},
          {"kind": "aggregation", "what": "aggregating up to 64 frames", "note": "", "base": shared9, "wifi": shared25},
        ],
      },
      {
        "name": "802.11ac 80 MHz 2x2",
        "model": "padded",
        "values": shared10,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared11,
            "wifi": {
              "name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s",
              "model": "padded",
              "values": {"R_uni": 866666666.6666666, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
            },
          },
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11ac 80 MHz 2x2: 2402 instead of 867 Mbit/s and 196 instead of 190 µs of overhead an exchange", "base": shared11, "wifi": shared13},
          {"kind": "aggregation", "what": "aggregating up to 64 frames", "note": "", "base": shared11, "wifi": shared27},
        ],
      },
      {
        "name": "802.11ax 20 MHz 2x2, 2.4 GHz",
        "model": "padded",
        "values": shared28,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared20,
            "note": "",
            "base": shared29,
            "wifi": {
              "name": "802.11ax 20 MHz 2x2, 2.4 GHz, multicast 24 Mbit/s",
              "model": "padded",
              "values": {"R_uni": 286764705.88235295, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
            },
          },
          {"kind": "radio", "what": "another radio (802.11n 40 MHz 2x2)", "note": "instead of 802.11ax 20 MHz 2x2, 2.4 GHz: 300 instead of 287 Mbit/s, 186 instead of 196 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared29, "wifi": shared9},
          {"kind": "radio", "what": "another radio (802.11ac 80 MHz 2x2)", "note": "instead of 802.11ax 20 MHz 2x2, 2.4 GHz: 867 instead of 287 Mbit/s, 190 instead of 196 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared29, "wifi": shared11},
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11ax 20 MHz 2x2, 2.4 GHz: 2402 instead of 287 Mbit/s, 196 µs of overhead an exchange and multicast at 6 instead of 1 Mbit/s", "base": shared29, "wifi": shared13},
          {
            "kind": "aggregation",
            "what": "aggregating up to 64 frames",
            "note": "",
            "base": shared29,
            "wifi": {
              "name": "802.11ax 20 MHz 2x2, 2.4 GHz, A-MPDU 64",
              "model": "aggregated",
              "values": {"R_uni": 286764705.88235295, "O_uni": 0.0001959, "R_multi": 1000000, "O_multi": 0.0002875, "N_DBPS_uni": 3900, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1, "N_add_multi": 0, "k_multi": 1, "t_grid_multi": 1e-06, "n_agg": 64, "A_most": 194510, "O_agg": 0.0001999, "A_least": 0},
            },
          },
        ],
      },
      {
        "name": "802.11ax 80 MHz 2x2",
        "model": "padded",
        "values": shared30,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared31,
            "wifi": {
              "name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s",
              "model": "padded",
              "values": {"R_uni": 1200980392.1568627, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
            },
          },
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11ax 80 MHz 2x2: 2402 instead of 1201 Mbit/s and 196 µs of overhead an exchange", "base": shared31, "wifi": shared13},
          {"kind": "aggregation", "what": "aggregating up to 64 frames", "note": "", "base": shared31, "wifi": shared33},
        ],
      },
      {
        "name": "802.11ax 160 MHz 2x2",
        "model": "padded",
        "values": shared12,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared13,
            "wifi": {
              "name": "802.11ax 160 MHz 2x2, multicast 24 Mbit/s",
              "model": "padded",
              "values": {"R_uni": 2401960784.3137255, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 32666, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
            },
          },
          {"kind": "aggregation", "what": "aggregating up to 64 frames", "note": "", "base": shared13, "wifi": shared34},
        ],
      },
      {
        "name": "802.11be 80 MHz 2x2",
        "model": "padded",
        "values": shared35,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared36,
            "wifi": {
              "name": "802.11be 80 MHz 2x2, multicast 24 Mbit/s",
              "model": "padded",
              "values": {"R_uni": 1441176470.5882354, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
            },
          },
          {"kind": "radio", "what": "another radio (802.11ax 160 MHz 2x2)", "note": "instead of 802.11be 80 MHz 2x2: 2402 instead of 1441 Mbit/s and 196 instead of 204 µs of overhead an exchange", "base": shared36, "wifi": shared13},
          {
            "kind": "aggregation",
            "what": "aggregating up to 64 frames",
            "note": "",
            "base": shared36,
            "wifi": {
              "name": "802.11be 80 MHz 2x2, A-MPDU 64",
              "model": "aggregated",
              "values": {"R_uni": 1441176470.5882354, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 19600, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 975098, "O_agg": 0.0002079, "A_least": 0},
            },
          },
        ],
      },
      {
        "name": "802.11be 320 MHz 2x2",
        "model": "padded",
        "values": shared37,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared38,
            "wifi": {
              "name": "802.11be 320 MHz 2x2, multicast 24 Mbit/s",
              "model": "padded",
              "values": {"R_uni": 5764705882.3529415, "O_uni": 0.0002039, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06},
            },
          },
          {
            "kind": "aggregation",
            "what": "aggregating up to 64 frames",
            "note": "",
            "base": shared38,
            "wifi": {
              "name": "802.11be 320 MHz 2x2, A-MPDU 64",
              "model": "aggregated",
              "values": {"R_uni": 5764705882.3529415, "O_uni": 0.0002039, "R_multi": 6000000, "O_multi": 0.0001215, "N_DBPS_uni": 78400, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 3900398, "O_agg": 0.0002079, "A_least": 0},
            },
          },
        ],
      },
      {
        "name": "802.11n 20 MHz 2x2, A-MPDU 64",
        "model": "aggregated",
        "values": shared14,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared15,
            "wifi": {
              "name": "802.11n 20 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
              "model": "aggregated",
              "values": {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 520, "N_add_uni": 22, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 65535, "O_agg": 0.0001895, "A_least": 0},
            },
          },
          {"kind": "radio", "what": "another radio (802.11n 40 MHz 2x2, A-MPDU 64)", "note": "instead of 802.11n 20 MHz 2x2, A-MPDU 64: 300 instead of 144 Mbit/s and 190 µs of overhead an exchange", "base": shared15, "wifi": shared25},
          {"kind": "radio", "what": "another radio (802.11ac 80 MHz 2x2, A-MPDU 64)", "note": "instead of 802.11n 20 MHz 2x2, A-MPDU 64: 867 instead of 144 Mbit/s and 194 instead of 190 µs of overhead an exchange", "base": shared15, "wifi": shared27},
          {"kind": "radio", "what": shared39, "note": "instead of 802.11n 20 MHz 2x2, A-MPDU 64: 2402 instead of 144 Mbit/s and 200 instead of 190 µs of overhead an exchange", "base": shared15, "wifi": shared34},
        ],
      },
      {
        "name": "802.11ac 80 MHz 2x2, A-MPDU 64",
        "model": "aggregated",
        "values": shared26,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared27,
            "wifi": {
              "name": "802.11ac 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
              "model": "aggregated",
              "values": {"R_uni": 866666666.6666666, "O_uni": 0.0001895, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 3120, "N_add_uni": 28, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 589286, "O_agg": 0.0001935, "A_least": 0},
            },
          },
          {"kind": "radio", "what": shared39, "note": "instead of 802.11ac 80 MHz 2x2, A-MPDU 64: 2402 instead of 867 Mbit/s and 200 instead of 194 µs of overhead an exchange", "base": shared27, "wifi": shared34},
        ],
      },
      {
        "name": "802.11ax 80 MHz 2x2, A-MPDU 64",
        "model": "aggregated",
        "values": shared32,
        "remedies": [
          {
            "kind": "multicast rate",
            "what": shared3,
            "note": "",
            "base": shared33,
            "wifi": {
              "name": "802.11ax 80 MHz 2x2, multicast 24 Mbit/s, A-MPDU 64",
              "model": "aggregated",
              "values": {"R_uni": 1200980392.1568627, "O_uni": 0.0001959, "R_multi": 24000000, "O_multi": 0.0001215, "N_DBPS_uni": 16333, "N_add_uni": 16, "k_uni": 1, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 96, "N_add_multi": 22, "k_multi": 1, "t_grid_multi": 4e-06, "n_agg": 64, "A_most": 814606, "O_agg": 0.0001999, "A_least": 0},
            },
          },
          {"kind": "radio", "what": shared39, "note": "instead of 802.11ax 80 MHz 2x2, A-MPDU 64: 2402 instead of 1201 Mbit/s and 200 µs of overhead an exchange", "base": shared33, "wifi": shared34},
        ],
      },
    ],
    "limit": 1,
    "times": [[0.0, 1e-06, "µs"], [0.001, 0.001, "ms"], [0.1, 1.0, "s"], [100.0, 60.0, "minutes"], [6000.0, 3600.0, "hours"], [172800.0, 86400.0, "days"], [60480000.0, 31557600.0, "years"]],
    "airtime": {
      "inside": {"up": "inside_unicast", "multicast": "inside_multicast", "unicast": "inside_unicast"},
      "linear": {"up": "linear_unicast", "multicast": "linear_multicast", "unicast": "linear_unicast"},
      "padded": {"up": "padded_unicast", "multicast": "padded_multicast", "unicast": "padded_unicast"},
      "aggregated": {"up": "aggregated_unicast", "multicast": "padded_multicast", "unicast": "aggregated_unicast"},
    },
    "laptop_nodes": 2,
    "service_endpoints": 12,
    "remedies": {
      "processes": {
        "of": {"DDS": shared40, "Zenoh": shared40, "None": shared40},
        "paste": {"any": [{"where": "where Nav2 is started", "version": "ROS 2 Humble", "text": "# ROS 2 Humble: where Nav2 is started\nros2 launch nav2_bringup bringup_launch.py use_composition:=True\n"}, {"where": "a launch file for nodes of your own that are built as components", "version": "ROS 2 Humble", "text": "# ROS 2 Humble: a launch file for nodes of your own that are built as components\nfrom launch import LaunchDescription\nfrom launch_ros.actions import ComposableNodeContainer\nfrom launch_ros.descriptions import ComposableNode\n\n\ndef generate_launch_description():\n    nodes = [\n        ComposableNode(package=\"composition\", plugin=\"composition::Talker\", name=\"talker\"),\n        ComposableNode(package=\"composition\", plugin=\"composition::Listener\", name=\"listener\"),\n    ]\n    container = ComposableNodeContainer(\n        name=\"robot\",\n        namespace=\"\",\n        package=\"rclcpp_components\",\n        executable=\"component_container\",\n        composable_node_descriptions=nodes,\n    )\n    return LaunchDescription([container])\n"}]},
      },
      "endpoints": {
        "of": {"DDS": shared41, "Zenoh": shared41, "None": shared41},
        "paste": {"any": [{"where": "where a node of your own is made (C++)", "version": "ROS 2 Humble", "text": "// ROS 2 Humble: where a node of your own is made (C++)\nauto options = rclcpp::NodeOptions().start_parameter_services(false);\nauto node = std::make_shared<rclcpp::Node>(\"name\", options);\n"}]},
      },
      "multicast rate": {
        "of": {"DDS": shared42, "Zenoh": shared42, "None": shared42},
        "paste": {"any": [{"where": "hostapd.conf of the access point", "version": "hostapd 2.10", "text": "# hostapd 2.10: hostapd.conf of the access point\n# Frames to a group go out at the lowest basic rate, here 24 Mbit/s (in units of 100 kbit/s).\nsupported_rates=240 360 480 540\nbasic_rates=240\n"}]},
      },
      "radio": {
        "of": {"DDS": shared43, "Zenoh": shared43, "None": shared43},
        "paste": {"802.11n 40 MHz": [{"where": "hostapd.conf of the access point", "version": "hostapd 2.10", "text": "# hostapd 2.10: hostapd.conf of the access point\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+]\n"}], "802.11ac 80 MHz": [{"where": "hostapd.conf of the access point", "version": "hostapd 2.10", "text": "# hostapd 2.10: hostapd.conf of the access point\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+]\nieee80211ac=1\nvht_oper_chwidth=1\nvht_oper_centr_freq_seg0_idx=42\n"}], "802.11ax 160 MHz": [{"where": "hostapd.conf of the access point", "version": "hostapd 2.10", "text": "# hostapd 2.10: hostapd.conf of the access point\n# Channels 52 to 64 are shared with radars: that needs a country.\ncountry_code=US\nieee80211d=1\nieee80211h=1\nhw_mode=a\nchannel=36\nwmm_enabled=1\nieee80211n=1\nht_capab=[HT40+]\nieee80211ac=1\nvht_oper_chwidth=2\nvht_oper_centr_freq_seg0_idx=50\nieee80211ax=1\nhe_oper_chwidth=2\nhe_oper_centr_freq_seg0_idx=50\n"}]},
      },
      "aggregation": {"of": {"DDS": shared44, "Zenoh": shared44, "None": shared44}, "paste": {"any": [{"where": "hostapd.conf of the access point", "version": "hostapd 2.10", "text": "# hostapd 2.10: hostapd.conf of the access point\nhw_mode=a\nchannel=36\nieee80211n=1\nwmm_enabled=1\n"}]}},
      "middleware": {
        "of": {
          "DDS": shared45,
          "Zenoh": {"price": "all hosts must change together; this is the count of peers that scout by multicast, while rmw_zenoh by default has a router on each host and no multicast, and nothing crosses hosts until routers are told of each other", "whole": true, "why": "other messages of other sizes"},
          "None": shared45,
        },
        "paste": {"Fast DDS": [{"where": "on every computer", "version": "ROS 2 Jazzy", "text": "# ROS 2 Jazzy: on every computer\nexport RMW_IMPLEMENTATION=rmw_fastrtps_cpp\n"}], "Cyclone DDS": [{"where": "on every computer", "version": "ROS 2 Jazzy", "text": "# ROS 2 Jazzy: on every computer\nexport RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n"}], "Zenoh": [{"where": "on every computer", "version": "ROS 2 Jazzy", "text": "# ROS 2 Jazzy: on every computer\nexport RMW_IMPLEMENTATION=rmw_zenoh_cpp\nros2 run rmw_zenoh_cpp rmw_zenohd &\n"}]},
      },
    },
    "largest": "largest",
    "saturation": [null, "saturation", "saturation2", "saturation3"],
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
      "count7": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return 0.5*N_E*x1*(N_P*(N_H - 1) + x0) + 0.5*N_E1*x0*(N_P1*(N_H1 - 1) + x1); },
      "more17": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = 0.5*N_H1*N_P1; return N_E*N_P*x0 + N_E1*x0*(N_P + N_P1*(N_H1 - 1)); },
      "more18": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = 0.5*N_E; const x1 = N_H1*N_P*N_P1; return 0.5*N_E1*x1 + Math.pow(N_P, 2)*x0 + x0*x1; },
      "more19": ({ N_E, N_P }) => { return 0.5*N_E*Math.pow(N_P, 2); },
      "count8": ({ N_H, N_H1, N_P, N_P1 }) => { return (N_H*N_P + N_H1*N_P1)*(N_H + N_H1 - 1); },
      "more20": ({ N_H1, N_P, N_P1 }) => { return N_H1*(N_H1*N_P1 + N_P); },
      "more21": ({ N_H1, N_P, N_P1 }) => { return N_H1*N_P + N_H1*N_P1 + N_P; },
      "count9": ({ N_H, N_H1 }) => { const x0 = N_H + N_H1; return x0*(x0 - 1); },
      "more22": ({ N_H1 }) => { return N_H1*(N_H1 + 1); },
      "more23": ({ N_H1 }) => { return 2*N_H1 + 1; },
      "more24": ({  }) => { return 1; },
      "count10": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P + N_H1*N_P1; return 1.0*x0*(x0 - 1); },
      "more25": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1 + N_P; return 1.0*x0*(x0 - 1); },
      "more26": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1 + N_P; const x1 = 1.0*N_P; return x0*x1 + x1*(x0 - 1); },
      "more27": ({ N_P }) => { return 1.0*Math.pow(N_P, 2); },
      "count11": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { return N_E*N_H*N_P + N_E1*N_H1*N_P1; },
      "more28": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { return N_E*N_P + N_E1*N_H1*N_P1; },
      "more29": ({ N_E, N_P }) => { return N_E*N_P; },
      "count12": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P; const x1 = N_H1*N_P1; return (N_E*x0 + N_E1*x1)*(x0 + x1 - 1); },
      "more30": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return (N_E*N_P + N_E1*x0)*(N_P + x0 - 1); },
      "more31": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_E*N_P; return N_P*(N_E1*x0 + x1) + x1*(N_P + x0 - 1); },
      "count13": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return 1.0*x0*(N_P1*(N_H1 - 1) + x1) + 1.0*x1*(N_P*(N_H - 1) + x0); },
      "more32": ({ N_H1, N_P, N_P1 }) => { const x0 = 1.0*N_H1*N_P1; return N_P*x0 + x0*(N_P + N_P1*(N_H1 - 1)); },
      "more33": ({ N_H1, N_P, N_P1 }) => { return 2.0*N_H1*N_P*N_P1 + 1.0*Math.pow(N_P, 2); },
      "count14": ({ N_H, N_H1, N_P, N_P1 }) => { return N_H*N_P + N_H1*N_P1 - N_P; },
      "more34": ({ N_H1, N_P1 }) => { return N_H1*N_P1; },
      "count15": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P + N_H1*N_P1; return 1.0*(-N_P + x0)*(x0 - 1); },
      "more35": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; return 1.0*x0*(N_P + x0 - 1); },
      "more36": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = 1.0*N_P; return x0*x1 + x1*(N_P + x0 - 1); },
      "count16": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_E*N_P; return N_E1*N_H1*N_P1 + N_H*x0 - x0; },
      "more37": ({ N_E1, N_H1, N_P1 }) => { return N_E1*N_H1*N_P1; },
      "count17": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_E*N_H*N_P + N_E1*x0; return N_E*N_P + x1*(N_H*N_P - N_P + x0) - x1; },
      "more38": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_E1*N_H1*N_P1; return N_H1*N_P1*(N_E*N_P + x0) - x0; },
      "more39": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = N_E*N_P; const x1 = N_H1*N_P1; return N_P*(N_E1*x1 + x0) + x0*x1 - x0; },
      "count18": ({ N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H*N_P + N_H1*N_P1; return x0*(x0 - 1); },
      "more40": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1 + N_P; return x0*(x0 - 1); },
      "more41": ({ N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1 + N_P; return N_P*x0 + N_P*(x0 - 1); },
      "count19": ({ N_H, N_H1 }) => { return N_H + N_H1; },
      "more42": ({ N_H1 }) => { return N_H1 + 1; },
      "count20": ({ N_E, N_E1, N_P, N_P1 }) => { return N_E*N_P + N_E1*N_P1; },
      "count21": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { return (1/2)*N_E*N_H*N_P*(N_E + 1) + (1/2)*N_E1*N_H1*N_P1*(N_E1 + 1); },
      "more43": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { return (1/2)*N_E*N_P*(N_E + 1) + (1/2)*N_E1*N_H1*N_P1*(N_E1 + 1); },
      "more44": ({ N_E, N_P }) => { return (1/2)*N_E*N_P*(N_E + 1); },
      "count22": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { const x0 = N_H1*N_P1; const x1 = N_H*N_P; return (1/2)*N_E*x1*(N_E + 1)*(N_P*(N_H - 1) + x0) + (1/2)*N_E1*x0*(N_E1 + 1)*(N_P1*(N_H1 - 1) + x1); },
      "more45": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = (1/2)*N_H1*N_P1; return N_E*N_P*x0*(N_E + 1) + N_E1*x0*(N_E1 + 1)*(N_P + N_P1*(N_H1 - 1)); },
      "more46": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { const x0 = (1/2)*N_E*(N_E + 1); const x1 = N_H1*N_P*N_P1; return (1/2)*N_E1*x1*(N_E1 + 1) + Math.pow(N_P, 2)*x0 + x0*x1; },
      "more47": ({ N_E, N_P }) => { return (1/2)*N_E*Math.pow(N_P, 2)*(N_E + 1); },
      "count23": ({ N_E, N_E1, N_H, N_H1, N_P, N_P1 }) => { return 0.5*N_E*N_H*N_P + 0.5*N_E1*N_H1*N_P1; },
      "more48": ({ N_E, N_E1, N_H1, N_P, N_P1 }) => { return 0.5*N_E*N_P + 0.5*N_E1*N_H1*N_P1; },
      "more49": ({ N_E, N_P }) => { return 0.5*N_E*N_P; },
      "saturation": ({ U_limit, b, c }) => { return 1 + (1/2)*(2*U_limit - 2*c)/b; },
      "saturation2": ({ U_limit, a, b, c }) => { return (2*U_limit - 2*c)/(b + Math.sqrt(4*a*(U_limit - c) + Math.pow(b, 2))) + 1; },
      "saturation3": ({ U_limit, a, b, c, third }) => { const rounded_0 = Math.min(1, ((1/6)*a*b*(U_limit - c) + (1/27)*Math.pow(b, 3) + (1/2)*third*Math.pow(U_limit - c, 2))/Math.pow((1/3)*a*(U_limit - c) + (1/9)*Math.pow(b, 2), 3/2)); const rounded_1 = Math.max(1, ((1/6)*a*b*(U_limit - c) + (1/27)*Math.pow(b, 3) + (1/2)*third*Math.pow(U_limit - c, 2))/Math.pow((1/3)*a*(U_limit - c) + (1/9)*Math.pow(b, 2), 3/2)); const x0 = U_limit - c; return x0/((1/3)*b + 2*Math.sqrt((1/3)*a*x0 + (1/9)*Math.pow(b, 2))*Math.cos((1/3)*Math.acos(rounded_0))*Math.cosh((1/3)*Math.acosh(rounded_1))) + 1; },
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
    "protocols": {
      "DDS": {
        "group": "As the paper counts",
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": Infinity,
        "repeats": false,
        "outlooks": shared46,
        "windows": {"second": 1, "ever": Infinity},
        "units": [shared48, shared50, shared52],
        "degree": 2,
        "messages": [
          {"name": "SPDP", "cast": "multicast", "bytes": 414, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": {"burst": 1, "second": 1, "ever": 0}},
          {"name": "SEDP", "cast": "unicast", "bytes": 464, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": {"burst": 1, "second": 1, "ever": 0}},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 116, "frames": 1, "unit": 2, "per_unit": 2, "hops": ["up", "down"], "sent": {"burst": 1, "second": 1, "ever": 0}},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 114, "frames": 1, "unit": 2, "per_unit": 2, "hops": ["up", "down"], "sent": {"burst": 1, "second": 1, "ever": 0}},
        ],
      },
      "Zenoh": {
        "group": "As the paper counts",
        "family": "Zenoh",
        "about": "",
        "variant": false,
        "lease": Infinity,
        "repeats": false,
        "outlooks": shared46,
        "windows": {"second": 1, "ever": Infinity},
        "units": shared53,
        "degree": 2,
        "messages": [
          {"name": "Scout", "cast": "multicast", "bytes": 80, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": {"burst": 1, "second": 1, "ever": 0}},
          {"name": "Hello", "cast": "unicast", "bytes": 144, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": {"burst": 1, "second": 1, "ever": 0}},
          {"name": "Declare", "cast": "unicast", "bytes": 176, "frames": 1, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": {"burst": 1, "second": 1, "ever": 0}},
          {"name": "KeepAlive", "cast": "unicast", "bytes": 84, "frames": 1, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": {"burst": 1, "second": 1, "ever": 0}},
        ],
      },
      "Cyclone DDS": {
        "group": "Products as built",
        "family": "DDS",
        "about": "on a network that it takes for Wi-Fi: multicast for SPDP alone (version 0.10.2)",
        "variant": false,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": shared61,
        "degree": 3,
        "messages": [
          {"name": "SPDP", "cast": "multicast", "bytes": 420, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared62},
          {"name": "SPDP unicast", "cast": "unicast", "bytes": 420, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared63},
          {"name": "SPDP directed", "cast": "unicast", "bytes": 436, "frames": 1, "unit": 1, "per_unit": 0.75, "hops": ["up", "down"], "sent": shared64},
          {"name": "SEDP", "cast": "unicast", "bytes": 1011.3931423203381, "frames": 0.2129, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "SEDP again", "cast": "unicast", "bytes": 1011.3931423203381, "frames": 0.2129, "unit": 3, "per_unit": 0.08438, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 153.6732788798133, "frames": 0.5142, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat of data", "cast": "unicast", "bytes": 153.6732788798133, "frames": 0.5142, "unit": 1, "per_unit": 2.375, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 187.56178089044522, "frames": 0.3998, "unit": 1, "per_unit": 4.635, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK for others", "cast": "unicast", "bytes": 187.56178089044522, "frames": 0.3998, "unit": 4, "per_unit": 0.09896, "hops": ["up", "down"], "sent": shared65},
          shared67,
          {"name": "Liveliness at start", "cast": "unicast", "bytes": 209.73193560464244, "frames": 0.5342, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness for others", "cast": "unicast", "bytes": 209.73193560464244, "frames": 0.5342, "unit": 4, "per_unit": 0.09375, "hops": ["up", "down"], "sent": shared65},
          shared68,
          {"name": "Liveliness Heartbeat at start", "cast": "unicast", "bytes": 157.8841449342257, "frames": 0.4333, "unit": 1, "per_unit": 2.208, "hops": ["up", "down"], "sent": shared65},
          shared69,
          {"name": "Liveliness ACKNACK at start", "cast": "unicast", "bytes": 193.64569775849603, "frames": 0.2766, "unit": 1, "per_unit": 2.275, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness ACKNACK for others", "cast": "unicast", "bytes": 193.64569775849603, "frames": 0.2766, "unit": 4, "per_unit": 0.05833, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup Heartbeat", "cast": "unicast", "bytes": 127.15414230714387, "frames": 0.7013, "unit": 1, "per_unit": 2.188, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK", "cast": "unicast", "bytes": 197.64779874213835, "frames": 0.2544, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK for others", "cast": "unicast", "bytes": 197.64779874213835, "frames": 0.2544, "unit": 4, "per_unit": 0.3125, "hops": ["up", "down"], "sent": shared65},
          {"name": "User Heartbeat", "cast": "unicast", "bytes": 141.09310113864703, "frames": 0.5972, "unit": 5, "per_unit": 1.15, "hops": ["up", "down"], "sent": shared65},
          {"name": "User ACKNACK", "cast": "unicast", "bytes": 184.34918723660445, "frames": 0.3322, "unit": 5, "per_unit": 1.6, "hops": ["up", "down"], "sent": shared65},
        ],
      },
      "Cyclone DDS, wired": {
        "group": "Products as built",
        "family": "DDS",
        "about": "on a network that it takes for wired, with three processes or more: multicast for SEDP and control, too (version 0.10.2)",
        "variant": true,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": shared70,
        "degree": 3,
        "messages": [
          shared71,
          {"name": "SPDP directed", "cast": "unicast", "bytes": 493.08762420957544, "frames": 0.9963, "unit": 1, "per_unit": 0.6667, "hops": ["up", "down"], "sent": shared64},
          {"name": "SEDP", "cast": "unicast", "bytes": 1167.7479630635523, "frames": 0.1841, "unit": 2, "per_unit": 0.5833, "hops": ["up", "down"], "sent": shared65},
          {"name": "SEDP multicast", "cast": "multicast", "bytes": 961.6660682226212, "frames": 0.2228, "unit": 2, "per_unit": 0.1667, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat multicast", "cast": "multicast", "bytes": 232, "frames": 0.25, "unit": 0, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 201.42013994523882, "frames": 0.3287, "unit": 1, "per_unit": 3, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 199.39703903095557, "frames": 0.3715, "unit": 1, "per_unit": 4.05, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK for others", "cast": "unicast", "bytes": 199.39703903095557, "frames": 0.3715, "unit": 3, "per_unit": 0.2833, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness", "cast": "multicast", "bytes": 179.99005799502902, "frames": 0.7242, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared66},
          {"name": "Liveliness at start", "cast": "multicast", "bytes": 150.79816322270926, "frames": 0.9582, "unit": 0, "per_unit": 0.3333, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness unicast", "cast": "unicast", "bytes": 429, "frames": 0.2, "unit": 1, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness Heartbeat", "cast": "multicast", "bytes": 180.02610587382162, "frames": 0.2758, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared66},
          {"name": "Liveliness Heartbeat at start", "cast": "multicast", "bytes": 245.09790605546124, "frames": 0.1767, "unit": 0, "per_unit": 0.875, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness Heartbeat unicast", "cast": "unicast", "bytes": 234.05196032120926, "frames": 0.2117, "unit": 1, "per_unit": 1.625, "hops": ["up", "down"], "sent": shared65},
          shared69,
          {"name": "Liveliness ACKNACK at start", "cast": "unicast", "bytes": 187.1920199501247, "frames": 0.2807, "unit": 1, "per_unit": 2.344, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness ACKNACK for others", "cast": "unicast", "bytes": 187.1920199501247, "frames": 0.2807, "unit": 3, "per_unit": 0.07812, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup Heartbeat", "cast": "multicast", "bytes": 224.96579476861166, "frames": 0.1988, "unit": 0, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup Heartbeat unicast", "cast": "unicast", "bytes": 230.92749087115283, "frames": 0.1917, "unit": 1, "per_unit": 0.6667, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK", "cast": "unicast", "bytes": 211.5, "frames": 0.2, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK for others", "cast": "unicast", "bytes": 211.5, "frames": 0.2, "unit": 3, "per_unit": 0.3125, "hops": ["up", "down"], "sent": shared65},
          {"name": "User Heartbeat", "cast": "unicast", "bytes": 230.46065100947672, "frames": 0.2427, "unit": 4, "per_unit": 0.75, "hops": ["up", "down"], "sent": shared65},
          {"name": "User Heartbeat multicast", "cast": "multicast", "bytes": 232.6802973977695, "frames": 0.2152, "unit": 4, "per_unit": 0.25, "hops": ["up", "down"], "sent": shared65},
          {"name": "User ACKNACK", "cast": "unicast", "bytes": 226.06745510293473, "frames": 0.2283, "unit": 4, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
        ],
      },
      "Cyclone DDS, version 11": {
        "group": "Products as built",
        "family": "DDS",
        "about": "as Cyclone DDS, with type information in SEDP (version 11.0.1)",
        "variant": true,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": shared61,
        "degree": 3,
        "messages": [
          {"name": "SPDP", "cast": "multicast", "bytes": 432, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared62},
          {"name": "SPDP unicast", "cast": "unicast", "bytes": 432, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared63},
          {"name": "SPDP directed", "cast": "unicast", "bytes": 432, "frames": 1, "unit": 1, "per_unit": 0.5625, "hops": ["up", "down"], "sent": shared64},
          {"name": "SEDP", "cast": "unicast", "bytes": 733.5900021925016, "frames": 0.4561, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "SEDP again", "cast": "unicast", "bytes": 733.5900021925016, "frames": 0.4561, "unit": 3, "per_unit": 0.04792, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 152.88683431952666, "frames": 0.5408, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat of data", "cast": "unicast", "bytes": 152.88683431952666, "frames": 0.5408, "unit": 1, "per_unit": 2.833, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 187.3409033560434, "frames": 0.3963, "unit": 1, "per_unit": 5.167, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK for others", "cast": "unicast", "bytes": 187.3409033560434, "frames": 0.3963, "unit": 4, "per_unit": 0.125, "hops": ["up", "down"], "sent": shared65},
          shared67,
          {"name": "Liveliness at start", "cast": "unicast", "bytes": 193.85449071751128, "frames": 0.5979, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness for others", "cast": "unicast", "bytes": 193.85449071751128, "frames": 0.5979, "unit": 4, "per_unit": 0.04167, "hops": ["up", "down"], "sent": shared65},
          shared68,
          {"name": "Liveliness Heartbeat at start", "cast": "unicast", "bytes": 156.73844753016164, "frames": 0.4393, "unit": 1, "per_unit": 2.188, "hops": ["up", "down"], "sent": shared65},
          shared69,
          {"name": "Liveliness ACKNACK at start", "cast": "unicast", "bytes": 188.55516014234874, "frames": 0.281, "unit": 1, "per_unit": 2.385, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness ACKNACK for others", "cast": "unicast", "bytes": 188.55516014234874, "frames": 0.281, "unit": 4, "per_unit": 0.05729, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup Heartbeat", "cast": "unicast", "bytes": 134.83743842364532, "frames": 0.609, "unit": 1, "per_unit": 2.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK", "cast": "unicast", "bytes": 212.09610154125116, "frames": 0.2206, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK for others", "cast": "unicast", "bytes": 212.09610154125116, "frames": 0.2206, "unit": 4, "per_unit": 0.3125, "hops": ["up", "down"], "sent": shared65},
          {"name": "User Heartbeat", "cast": "unicast", "bytes": 134.96727272727273, "frames": 0.6875, "unit": 5, "per_unit": 1.2, "hops": ["up", "down"], "sent": shared65},
          {"name": "User ACKNACK", "cast": "unicast", "bytes": 175.87453323375652, "frames": 0.4017, "unit": 5, "per_unit": 1.75, "hops": ["up", "down"], "sent": shared65},
        ],
      },
      "Cyclone DDS peers": {
        "group": "Products arranged against the storm",
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": [[shared72, shared72], shared74, shared52, shared50, shared57, shared59, shared60],
        "degree": 3,
        "messages": [
          {"name": "SPDP", "cast": "unicast", "bytes": 420, "frames": 1, "unit": 0, "per_unit": 9, "hops": ["up", "down"], "sent": shared62},
          {"name": "ICMP unreachable", "cast": "unicast", "bytes": 448, "frames": 1, "unit": 1, "per_unit": 6, "hops": ["up", "down"], "sent": shared75},
          {"name": "SPDP directed", "cast": "unicast", "bytes": 442.0177243557095, "frames": 0.9817, "unit": 2, "per_unit": 0.8333, "hops": ["up", "down"], "sent": shared64},
          {"name": "SEDP", "cast": "unicast", "bytes": 1224.46511627907, "frames": 0.172, "unit": 3, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "SEDP again", "cast": "unicast", "bytes": 334.84114485689287, "frames": 0.8001, "unit": 4, "per_unit": 0.08633, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 150.13620569840168, "frames": 0.5756, "unit": 2, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat of data", "cast": "unicast", "bytes": 150.13620569840168, "frames": 0.5756, "unit": 2, "per_unit": 2.944, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 191.25372354324537, "frames": 0.3827, "unit": 2, "per_unit": 4.424, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK for others", "cast": "unicast", "bytes": 191.25372354324537, "frames": 0.3827, "unit": 5, "per_unit": 0.2049, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness", "cast": "unicast", "bytes": 180.00607650876952, "frames": 0.7241, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared66},
          {"name": "Liveliness at start", "cast": "unicast", "bytes": 170.0050484920951, "frames": 0.7527, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness for others", "cast": "unicast", "bytes": 170.0050484920951, "frames": 0.7527, "unit": 5, "per_unit": 0.08333, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness Heartbeat", "cast": "unicast", "bytes": 179.9840521928235, "frames": 0.2759, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared66},
          {"name": "Liveliness Heartbeat at start", "cast": "unicast", "bytes": 156.0150305307656, "frames": 0.4258, "unit": 2, "per_unit": 2.556, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness ACKNACK", "cast": "unicast", "bytes": 128, "frames": 1, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared66},
          {"name": "Liveliness ACKNACK at start", "cast": "unicast", "bytes": 190.60377358490564, "frames": 0.265, "unit": 2, "per_unit": 2.296, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness ACKNACK for others", "cast": "unicast", "bytes": 190.60377358490564, "frames": 0.265, "unit": 5, "per_unit": 0.09271, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup Heartbeat", "cast": "unicast", "bytes": 134.67330119732546, "frames": 0.6431, "unit": 2, "per_unit": 3, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK", "cast": "unicast", "bytes": 185.2367491166078, "frames": 0.283, "unit": 2, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK for others", "cast": "unicast", "bytes": 185.2367491166078, "frames": 0.283, "unit": 5, "per_unit": 0.3631, "hops": ["up", "down"], "sent": shared65},
          {"name": "User Heartbeat", "cast": "unicast", "bytes": 147.20074005550418, "frames": 0.5405, "unit": 6, "per_unit": 1.542, "hops": ["up", "down"], "sent": shared65},
          {"name": "User ACKNACK", "cast": "unicast", "bytes": 166.51716247139586, "frames": 0.437, "unit": 6, "per_unit": 2.208, "hops": ["up", "down"], "sent": shared65},
        ],
      },
      "Cyclone DDS multicast SEDP": {
        "group": "Products arranged against the storm",
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": shared70,
        "degree": 3,
        "messages": [
          shared71,
          {"name": "SPDP directed", "cast": "unicast", "bytes": 492.4140969162995, "frames": 0.9988, "unit": 1, "per_unit": 0.8, "hops": ["up", "down"], "sent": shared64},
          {"name": "SEDP", "cast": "unicast", "bytes": 1040.4988009592325, "frames": 0.2085, "unit": 2, "per_unit": 0.3719, "hops": ["up", "down"], "sent": shared65},
          {"name": "SEDP multicast", "cast": "multicast", "bytes": 965.8901890189019, "frames": 0.2222, "unit": 2, "per_unit": 0.23, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat multicast", "cast": "multicast", "bytes": 215.89285714285714, "frames": 0.28, "unit": 0, "per_unit": 1.833, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 213.31594018453706, "frames": 0.3143, "unit": 1, "per_unit": 3.333, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 200.7060146149522, "frames": 0.3558, "unit": 1, "per_unit": 4.517, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK for others", "cast": "unicast", "bytes": 200.7060146149522, "frames": 0.3558, "unit": 3, "per_unit": 0.1494, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness", "cast": "multicast", "bytes": 180.02209944751382, "frames": 0.724, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared66},
          {"name": "Liveliness at start", "cast": "multicast", "bytes": 152.05954502568403, "frames": 0.9539, "unit": 0, "per_unit": 0.8333, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness unicast", "cast": "unicast", "bytes": 510.6666666666667, "frames": 0.15, "unit": 1, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness Heartbeat", "cast": "multicast", "bytes": 179.94202898550725, "frames": 0.276, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared66},
          {"name": "Liveliness Heartbeat at start", "cast": "multicast", "bytes": 201.4570446735395, "frames": 0.2328, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness Heartbeat unicast", "cast": "unicast", "bytes": 219.65142364106987, "frames": 0.2318, "unit": 1, "per_unit": 1.75, "hops": ["up", "down"], "sent": shared65},
          shared69,
          {"name": "Liveliness ACKNACK at start", "cast": "unicast", "bytes": 186.30392156862746, "frames": 0.2856, "unit": 1, "per_unit": 2.379, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness ACKNACK for others", "cast": "unicast", "bytes": 186.30392156862746, "frames": 0.2856, "unit": 3, "per_unit": 0.08854, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup Heartbeat", "cast": "multicast", "bytes": 207.01075268817203, "frames": 0.2325, "unit": 0, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup Heartbeat unicast", "cast": "unicast", "bytes": 249.3997682502897, "frames": 0.1726, "unit": 1, "per_unit": 1.167, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK", "cast": "unicast", "bytes": 210.50383141762453, "frames": 0.2088, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Type lookup ACKNACK for others", "cast": "unicast", "bytes": 210.50383141762453, "frames": 0.2088, "unit": 3, "per_unit": 0.3274, "hops": ["up", "down"], "sent": shared65},
          {"name": "User Heartbeat", "cast": "unicast", "bytes": 176.79097672186225, "frames": 0.4167, "unit": 4, "per_unit": 0.7917, "hops": ["up", "down"], "sent": shared65},
          {"name": "User Heartbeat multicast", "cast": "multicast", "bytes": 122.00209989500526, "frames": 0.6667, "unit": 4, "per_unit": 0.1667, "hops": ["up", "down"], "sent": shared65},
          {"name": "User ACKNACK", "cast": "unicast", "bytes": 167.19174466042716, "frames": 0.4167, "unit": 4, "per_unit": 2.167, "hops": ["up", "down"], "sent": shared65},
        ],
      },
      "Fast DDS Discovery Server": {
        "group": "Products arranged against the storm",
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": 20,
        "repeats": true,
        "outlooks": shared76,
        "windows": shared77,
        "units": shared82,
        "degree": 2,
        "messages": [
          {"name": "SPDP to server", "cast": "unicast", "bytes": 652, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared83},
          {"name": "SPDP of server", "cast": "unicast", "bytes": 700, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["down"], "sent": shared84},
          {"name": "SPDP of server at discovery", "cast": "unicast", "bytes": 748.3930635838151, "frames": 0.865, "unit": 0, "per_unit": 1, "hops": ["down"], "sent": shared85},
          {"name": "SPDP of others", "cast": "unicast", "bytes": 683.9365973934484, "frames": 0.8517, "unit": 1, "per_unit": 1.967, "hops": ["down"], "sent": shared85},
          {"name": "SPDP Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up"], "sent": shared85},
          {"name": "SPDP Heartbeat of server", "cast": "unicast", "bytes": 250.29586195342605, "frames": 0.5969, "unit": 0, "per_unit": 2.167, "hops": ["down"], "sent": shared85},
          {"name": "SPDP Heartbeat of others", "cast": "unicast", "bytes": 354.98051539912007, "frames": 0.3182, "unit": 1, "per_unit": 2.908, "hops": ["down"], "sent": shared85},
          {"name": "SPDP ACKNACK", "cast": "unicast", "bytes": 189.9, "frames": 1, "unit": 0, "per_unit": 2.167, "hops": ["up"], "sent": shared85},
          {"name": "SPDP ACKNACK of others", "cast": "unicast", "bytes": 190.2, "frames": 1, "unit": 1, "per_unit": 0.5083, "hops": ["up"], "sent": shared85},
          {"name": "SPDP ACKNACK of server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["down"], "sent": shared85},
          {"name": "SPDP Gap", "cast": "unicast", "bytes": 204.14209591474247, "frames": 0.6193, "unit": 1, "per_unit": 1.6, "hops": ["down"], "sent": shared85},
          {"name": "SEDP to server", "cast": "unicast", "bytes": 1152, "frames": 0.45, "unit": 2, "per_unit": 1, "hops": ["up"], "sent": shared85},
          {"name": "SEDP of others", "cast": "unicast", "bytes": 655.9962112242481, "frames": 0.8446, "unit": 3, "per_unit": 1.237, "hops": ["down"], "sent": shared85},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["up"], "sent": shared85},
          {"name": "Heartbeat of server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["down"], "sent": shared85},
          {"name": "Heartbeat of others", "cast": "unicast", "bytes": 451.4893977947413, "frames": 0.2358, "unit": 3, "per_unit": 1.892, "hops": ["down"], "sent": shared85},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["up"], "sent": shared85},
          {"name": "ACKNACK of others", "cast": "unicast", "bytes": 191.3, "frames": 1, "unit": 3, "per_unit": 0.45, "hops": ["up"], "sent": shared85},
          {"name": "ACKNACK of server", "cast": "unicast", "bytes": 188.5, "frames": 1, "unit": 0, "per_unit": 15.6, "hops": ["down"], "sent": shared85},
          {"name": "Gap", "cast": "unicast", "bytes": 205.97133664814274, "frames": 0.6838, "unit": 3, "per_unit": 0.645, "hops": ["down"], "sent": shared85},
          {"name": "Liveliness Heartbeat to server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared85},
          {"name": "Liveliness Heartbeat of server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["down"], "sent": shared85},
          shared86,
          {"name": "Liveliness ACKNACK to server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up"], "sent": shared85},
          {"name": "Liveliness ACKNACK of server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["down"], "sent": shared85},
          shared87,
          shared88,
          shared89,
        ],
      },
      "Fast DDS Discovery Server, two": {
        "group": "Products arranged against the storm",
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": 20,
        "repeats": true,
        "outlooks": shared76,
        "windows": shared77,
        "units": shared82,
        "degree": 2,
        "messages": [
          {"name": "SPDP to server", "cast": "unicast", "bytes": 636, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up"], "sent": shared83},
          {"name": "SPDP of server", "cast": "unicast", "bytes": 700, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["down"], "sent": shared84},
          {"name": "SPDP of server at discovery", "cast": "unicast", "bytes": 747.8396673212429, "frames": 0.8657, "unit": 0, "per_unit": 2, "hops": ["down"], "sent": shared85},
          {"name": "SPDP of others", "cast": "unicast", "bytes": 684.0093940817285, "frames": 0.8516, "unit": 1, "per_unit": 3.9, "hops": ["down"], "sent": shared85},
          {"name": "SPDP Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["up"], "sent": shared85},
          {"name": "SPDP Heartbeat of server", "cast": "unicast", "bytes": 244.85106382978725, "frames": 0.6204, "unit": 0, "per_unit": 4.625, "hops": ["down"], "sent": shared85},
          {"name": "SPDP Heartbeat of others", "cast": "unicast", "bytes": 402.48973607038124, "frames": 0.2728, "unit": 1, "per_unit": 5.942, "hops": ["down"], "sent": shared85},
          {"name": "SPDP ACKNACK", "cast": "unicast", "bytes": 189.8, "frames": 1, "unit": 0, "per_unit": 4.625, "hops": ["up"], "sent": shared85},
          {"name": "SPDP ACKNACK of others", "cast": "unicast", "bytes": 190.5, "frames": 1, "unit": 1, "per_unit": 0.9417, "hops": ["up"], "sent": shared85},
          {"name": "SPDP ACKNACK of server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["down"], "sent": shared85},
          {"name": "SPDP Gap", "cast": "unicast", "bytes": 199.09006997171358, "frames": 0.6717, "unit": 1, "per_unit": 3.333, "hops": ["down"], "sent": shared85},
          {"name": "SEDP to server", "cast": "unicast", "bytes": 1257.7301004163605, "frames": 0.4083, "unit": 2, "per_unit": 2, "hops": ["up"], "sent": shared85},
          {"name": "SEDP of others", "cast": "unicast", "bytes": 655.9962112242481, "frames": 0.8446, "unit": 3, "per_unit": 2.45, "hops": ["down"], "sent": shared85},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 184, "frames": 1, "unit": 0, "per_unit": 8, "hops": ["up"], "sent": shared85},
          {"name": "Heartbeat of server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 8, "hops": ["down"], "sent": shared85},
          {"name": "Heartbeat of others", "cast": "unicast", "bytes": 432.5140562248996, "frames": 0.249, "unit": 3, "per_unit": 3.242, "hops": ["down"], "sent": shared85},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 8, "hops": ["up"], "sent": shared85},
          {"name": "ACKNACK of others", "cast": "unicast", "bytes": 190.8, "frames": 1, "unit": 3, "per_unit": 0.85, "hops": ["up"], "sent": shared85},
          {"name": "ACKNACK of server", "cast": "unicast", "bytes": 188.5, "frames": 1, "unit": 0, "per_unit": 31.6, "hops": ["down"], "sent": shared85},
          {"name": "Gap", "cast": "unicast", "bytes": 207.54580397181294, "frames": 0.6244, "unit": 3, "per_unit": 1.03, "hops": ["down"], "sent": shared85},
          {"name": "Liveliness Heartbeat to server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up"], "sent": shared85},
          {"name": "Liveliness Heartbeat of server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["down"], "sent": shared85},
          {"name": "Liveliness Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 4, "per_unit": 1.208, "hops": ["up", "down"], "sent": shared85},
          {"name": "Liveliness ACKNACK to server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["up"], "sent": shared85},
          {"name": "Liveliness ACKNACK of server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["down"], "sent": shared85},
          {"name": "Liveliness ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 4, "per_unit": 1.208, "hops": ["up", "down"], "sent": shared85},
          {"name": "User Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 5, "per_unit": 1.08, "hops": ["up", "down"], "sent": shared85},
          {"name": "User ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 5, "per_unit": 1.179, "hops": ["up", "down"], "sent": shared85},
        ],
      },
      "Fast DDS Discovery Server, on a robot": {
        "group": "Products arranged against the storm",
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": 20,
        "repeats": true,
        "outlooks": shared76,
        "windows": shared77,
        "units": [[shared90, shared90], [{"count": "count6", "more": []}, {"count": "count15", "more": ["more35", "more36", "more27"]}], [shared91, shared91], [{"count": "count6", "more": []}, {"count": "count17", "more": ["more38", "more39", "more5"]}], shared81, shared60],
        "degree": 2,
        "messages": [
          {"name": "SPDP to server", "cast": "unicast", "bytes": 652, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared83},
          {"name": "SPDP of server", "cast": "unicast", "bytes": 700, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared84},
          {"name": "SPDP of server at discovery", "cast": "unicast", "bytes": 748.3930635838151, "frames": 0.865, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP of others", "cast": "unicast", "bytes": 683.9365973934484, "frames": 0.8517, "unit": 1, "per_unit": 1.967, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP Heartbeat of server", "cast": "unicast", "bytes": 250.29586195342605, "frames": 0.5969, "unit": 0, "per_unit": 2.167, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP Heartbeat of others", "cast": "unicast", "bytes": 354.98051539912007, "frames": 0.3182, "unit": 1, "per_unit": 2.908, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP ACKNACK", "cast": "unicast", "bytes": 189.9, "frames": 1, "unit": 0, "per_unit": 2.167, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP ACKNACK of others", "cast": "unicast", "bytes": 190.2, "frames": 1, "unit": 1, "per_unit": 0.5083, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP ACKNACK of server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP Gap", "cast": "unicast", "bytes": 204.14209591474247, "frames": 0.6193, "unit": 1, "per_unit": 1.6, "hops": ["up", "down"], "sent": shared85},
          {"name": "SEDP to server", "cast": "unicast", "bytes": 1152, "frames": 0.45, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "SEDP of others", "cast": "unicast", "bytes": 655.9962112242481, "frames": 0.8446, "unit": 3, "per_unit": 1.237, "hops": ["up", "down"], "sent": shared85},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["up", "down"], "sent": shared85},
          {"name": "Heartbeat of server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["up", "down"], "sent": shared85},
          {"name": "Heartbeat of others", "cast": "unicast", "bytes": 451.4893977947413, "frames": 0.2358, "unit": 3, "per_unit": 1.892, "hops": ["up", "down"], "sent": shared85},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 4, "hops": ["up", "down"], "sent": shared85},
          {"name": "ACKNACK of others", "cast": "unicast", "bytes": 191.3, "frames": 1, "unit": 3, "per_unit": 0.45, "hops": ["up", "down"], "sent": shared85},
          {"name": "ACKNACK of server", "cast": "unicast", "bytes": 188.5, "frames": 1, "unit": 0, "per_unit": 15.6, "hops": ["up", "down"], "sent": shared85},
          {"name": "Gap", "cast": "unicast", "bytes": 205.97133664814274, "frames": 0.6838, "unit": 3, "per_unit": 0.645, "hops": ["up", "down"], "sent": shared85},
          {"name": "Liveliness Heartbeat to server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "Liveliness Heartbeat of server", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
          shared86,
          {"name": "Liveliness ACKNACK to server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
          {"name": "Liveliness ACKNACK of server", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 0, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
          shared87,
          shared88,
          shared89,
        ],
      },
      "Fast DDS": {
        "group": "Products as built",
        "family": "DDS",
        "about": "with UDP and shared memory, as shipped and as in ROS 2 (version 2.9.1)",
        "variant": false,
        "lease": 20,
        "repeats": true,
        "outlooks": shared76,
        "windows": shared77,
        "units": [shared48, shared93, shared52, shared59, shared50, shared60],
        "degree": 3,
        "messages": [
          {"name": "SPDP", "cast": "multicast", "bytes": 580, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared83},
          {"name": "SPDP at discovery", "cast": "multicast", "bytes": 580, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP unicast", "cast": "unicast", "bytes": 580, "frames": 1, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared94},
          {"name": "SPDP unicast at discovery", "cast": "unicast", "bytes": 580, "frames": 1, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP unicast for others", "cast": "unicast", "bytes": 580, "frames": 1, "unit": 3, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared85},
          {"name": "SEDP", "cast": "unicast", "bytes": 821.0093457943925, "frames": 0.6313, "unit": 4, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 184.9, "frames": 1, "unit": 2, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
          {"name": "Heartbeat of data", "cast": "unicast", "bytes": 184.9, "frames": 1, "unit": 2, "per_unit": 1.893, "hops": ["up", "down"], "sent": shared85},
          {"name": "Heartbeat of endpoints", "cast": "unicast", "bytes": 184.9, "frames": 1, "unit": 4, "per_unit": 0.02679, "hops": ["up", "down"], "sent": shared85},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 189.6, "frames": 1, "unit": 2, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
          {"name": "ACKNACK of data", "cast": "unicast", "bytes": 189.6, "frames": 1, "unit": 2, "per_unit": 2.583, "hops": ["up", "down"], "sent": shared85},
          {"name": "Liveliness Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 2, "per_unit": 1.25, "hops": ["up", "down"], "sent": shared85},
          {"name": "Liveliness ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 2, "per_unit": 1.25, "hops": ["up", "down"], "sent": shared85},
          {"name": "User Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 5, "per_unit": 1.4, "hops": ["up", "down"], "sent": shared85},
          {"name": "User ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 5, "per_unit": 1.425, "hops": ["up", "down"], "sent": shared85},
        ],
      },
      "hybrid": {
        "group": "Other tables",
        "family": null,
        "about": "",
        "variant": false,
        "lease": 23,
        "repeats": true,
        "outlooks": shared95,
        "windows": shared96,
        "units": [shared98, shared48, shared79, shared99, shared74],
        "degree": 2,
        "messages": [shared101, shared102, shared103, shared104, shared105, shared107, shared108],
      },
      "hybrid, alike": {
        "group": "Other tables",
        "family": null,
        "about": "",
        "variant": false,
        "lease": 23,
        "repeats": true,
        "outlooks": shared95,
        "windows": shared96,
        "units": [shared98, shared48, [shared109, shared109], shared99, shared74],
        "degree": 2,
        "messages": [shared101, shared102, {"name": "Software", "cast": "multicast", "bytes": 8, "frames": 0, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared100}, shared103, shared104, shared105, shared107, shared108],
      },
      "DDS, periods of Fast DDS": {
        "group": shared110,
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": 20,
        "repeats": true,
        "outlooks": shared76,
        "windows": shared77,
        "units": shared53,
        "degree": 2,
        "messages": [
          {"name": "SPDP", "cast": "multicast", "bytes": 414, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared83},
          {"name": "UnicastSPDP", "cast": "unicast", "bytes": 414, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared83},
          {"name": "SEDP", "cast": "unicast", "bytes": 464, "frames": 1, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 116, "frames": 1, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 114, "frames": 1, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared85},
        ],
      },
      "DDS, periods of Cyclone DDS": {
        "group": shared110,
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": shared53,
        "degree": 2,
        "messages": [
          {"name": "SPDP", "cast": "multicast", "bytes": 414, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared62},
          {"name": "DirectedSPDP", "cast": "unicast", "bytes": 414, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared64},
          {"name": "SEDP", "cast": "unicast", "bytes": 464, "frames": 1, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Heartbeat", "cast": "unicast", "bytes": 116, "frames": 1, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "ACKNACK", "cast": "unicast", "bytes": 114, "frames": 1, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Liveliness", "cast": "unicast", "bytes": 180, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared75},
          {"name": "LivelinessACK", "cast": "unicast", "bytes": 114, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared75},
        ],
      },
      "Zenoh, periods of Zenoh peer": {
        "group": shared110,
        "family": "Zenoh",
        "about": "",
        "variant": false,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": shared53,
        "degree": 2,
        "messages": [
          {"name": "Scout", "cast": "multicast", "bytes": 80, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared111},
          {"name": "Hello", "cast": "unicast", "bytes": 144, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared111},
          {"name": "Declare", "cast": "unicast", "bytes": 176, "frames": 1, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "KeepAlive", "cast": "unicast", "bytes": 84, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared112},
        ],
      },
      "static endpoints": {
        "group": "Products arranged against the storm",
        "family": "DDS",
        "about": "",
        "variant": false,
        "lease": 20,
        "repeats": true,
        "outlooks": shared76,
        "windows": shared77,
        "units": [shared48, shared93, shared79, shared52, shared59, shared50, shared113, [shared114, shared114], shared57, [shared115, shared115], shared60],
        "degree": 3,
        "messages": [
          {"name": "SPDP", "cast": "multicast", "bytes": 609.2, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up", "down"], "sent": shared83},
          {"name": "SPDP at discovery", "cast": "multicast", "bytes": 609.2, "frames": 1, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP of endpoints", "cast": "multicast", "bytes": 609.2, "frames": 1, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP unicast", "cast": "unicast", "bytes": 609.2, "frames": 1, "unit": 3, "per_unit": 1, "hops": ["up", "down"], "sent": shared94},
          {"name": "SPDP unicast at discovery", "cast": "unicast", "bytes": 609.2, "frames": 1, "unit": 3, "per_unit": 1, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP unicast for others", "cast": "unicast", "bytes": 609.2, "frames": 1, "unit": 4, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared85},
          {"name": "SPDP unicast of endpoints", "cast": "unicast", "bytes": 609.2, "frames": 1, "unit": 5, "per_unit": 0.505, "hops": ["up", "down"], "sent": shared85},
          {"name": "Listed", "cast": "multicast", "bytes": 56.36, "frames": 0, "unit": 2, "per_unit": 1, "hops": ["up", "down"], "sent": shared94},
          {"name": "Listed at discovery", "cast": "multicast", "bytes": 56.36, "frames": 0, "unit": 6, "per_unit": 0.7288, "hops": ["up", "down"], "sent": shared85},
          {"name": "Listed of endpoints", "cast": "multicast", "bytes": 56.36, "frames": 0, "unit": 7, "per_unit": 0.7288, "hops": ["up", "down"], "sent": shared85},
          {"name": "Listed unicast", "cast": "unicast", "bytes": 56.36, "frames": 0, "unit": 5, "per_unit": 1, "hops": ["up", "down"], "sent": shared94},
          {"name": "Listed unicast at discovery", "cast": "unicast", "bytes": 56.36, "frames": 0, "unit": 5, "per_unit": 0.8369, "hops": ["up", "down"], "sent": shared85},
          {"name": "Listed unicast for others", "cast": "unicast", "bytes": 56.36, "frames": 0, "unit": 8, "per_unit": 0.4184, "hops": ["up", "down"], "sent": shared85},
          {"name": "Listed unicast of endpoints", "cast": "unicast", "bytes": 56.36, "frames": 0, "unit": 9, "per_unit": 0.4226, "hops": ["up", "down"], "sent": shared85},
          {"name": "Liveliness Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 3, "per_unit": 1.167, "hops": ["up", "down"], "sent": shared85},
          {"name": "Liveliness ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 3, "per_unit": 1.167, "hops": ["up", "down"], "sent": shared85},
          {"name": "User Heartbeat", "cast": "unicast", "bytes": 192, "frames": 1, "unit": 10, "per_unit": 1.33, "hops": ["up", "down"], "sent": shared85},
          {"name": "User ACKNACK", "cast": "unicast", "bytes": 188, "frames": 1, "unit": 10, "per_unit": 1.33, "hops": ["up", "down"], "sent": shared85},
        ],
      },
      "Zenoh peer": {
        "group": "Products as built",
        "family": "Zenoh",
        "about": "peers, each linked with each other (version 1.10.2)",
        "variant": false,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": shared116,
        "degree": 3,
        "messages": [
          shared117,
          shared118,
          {"name": "Hello first", "cast": "unicast", "bytes": 104, "frames": 1, "unit": 1, "per_unit": 0.5833, "hops": ["up", "down"], "sent": shared65},
          {"name": "InitSyn", "cast": "unicast", "bytes": 110, "frames": 1, "unit": 1, "per_unit": 0.6667, "hops": ["up", "down"], "sent": shared65},
          shared119,
          shared120,
          shared121,
          {"name": "OAM", "cast": "unicast", "bytes": 163.4251497005988, "frames": 0.835, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "OAM for others", "cast": "unicast", "bytes": 163.4251497005988, "frames": 0.835, "unit": 2, "per_unit": 0.625, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare", "cast": "unicast", "bytes": 106.65917220235053, "frames": 0.1957, "unit": 3, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare key expression", "cast": "unicast", "bytes": 229.04217991787982, "frames": 0.8037, "unit": 4, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare key expression of matching", "cast": "unicast", "bytes": 229.04217991787982, "frames": 0.8037, "unit": 5, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare final", "cast": "unicast", "bytes": 176, "frames": 0.05, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Frame", "cast": "unicast", "bytes": 112.31961259079904, "frames": 0.2478, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Frame of endpoints", "cast": "unicast", "bytes": 112.31961259079904, "frames": 0.2478, "unit": 3, "per_unit": 0.6083, "hops": ["up", "down"], "sent": shared65},
          shared122,
          shared123,
          {"name": "TCP ACK", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 1, "per_unit": 0.8708, "hops": ["up", "down"], "sent": shared112},
          {"name": "TCP ACK at start", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 1, "per_unit": 2.496, "hops": ["up", "down"], "sent": shared65},
          {"name": "TCP ACK of endpoints", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 3, "per_unit": 0.2188, "hops": ["up", "down"], "sent": shared65},
        ],
      },
      "Zenoh peer, tokens": {
        "group": "Products as built",
        "family": "Zenoh",
        "about": "with liveliness tokens, as rmw_zenoh has them, and a subscriber to all of them (version 1.10.2)",
        "variant": true,
        "lease": 10,
        "repeats": true,
        "outlooks": shared54,
        "windows": shared55,
        "units": shared116,
        "degree": 3,
        "messages": [
          shared117,
          shared118,
          {"name": "Hello first", "cast": "unicast", "bytes": 104, "frames": 1, "unit": 1, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "InitSyn", "cast": "unicast", "bytes": 109.86, "frames": 1, "unit": 1, "per_unit": 0.6667, "hops": ["up", "down"], "sent": shared65},
          shared119,
          shared120,
          shared121,
          {"name": "OAM", "cast": "unicast", "bytes": 179.4287333522244, "frames": 0.7058, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "OAM for others", "cast": "unicast", "bytes": 179.4287333522244, "frames": 0.7058, "unit": 2, "per_unit": 0.6493, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare", "cast": "unicast", "bytes": 167.6030534351145, "frames": 0.0655, "unit": 3, "per_unit": 0.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare token", "cast": "unicast", "bytes": 175.50248756218906, "frames": 0.0603, "unit": 3, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare token of node", "cast": "unicast", "bytes": 175.50248756218906, "frames": 0.0603, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare key expression", "cast": "unicast", "bytes": 362.8385800401876, "frames": 0.5972, "unit": 4, "per_unit": 1.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare key expression of matching", "cast": "unicast", "bytes": 362.8385800401876, "frames": 0.5972, "unit": 5, "per_unit": 2.5, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare key expression of node", "cast": "unicast", "bytes": 362.8385800401876, "frames": 0.5972, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Declare final", "cast": "unicast", "bytes": 159.33333333333334, "frames": 0.06, "unit": 1, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          {"name": "Frame", "cast": "unicast", "bytes": 142.56804733727813, "frames": 0.1352, "unit": 1, "per_unit": 2, "hops": ["up", "down"], "sent": shared65},
          {"name": "Frame of endpoints", "cast": "unicast", "bytes": 142.56804733727813, "frames": 0.1352, "unit": 3, "per_unit": 1, "hops": ["up", "down"], "sent": shared65},
          shared122,
          shared123,
          {"name": "TCP ACK", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 1, "per_unit": 0.7208, "hops": ["up", "down"], "sent": shared112},
          {"name": "TCP ACK at start", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 1, "per_unit": 3.325, "hops": ["up", "down"], "sent": shared65},
          {"name": "TCP ACK of endpoints", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 3, "per_unit": 0.4208, "hops": ["up", "down"], "sent": shared65},
        ],
      },
      "Zenoh router": {
        "group": "Products arranged against the storm",
        "family": "Zenoh",
        "about": "",
        "variant": false,
        "lease": 60,
        "repeats": true,
        "outlooks": {"until": [[1, "within a second at best"], [60, "slow at best"], [Infinity, "leases at risk"]], "never": "never catches up"},
        "windows": {"second": 1, "lease": 60, "ever": Infinity},
        "units": [shared48, shared79, [shared78, {"count": "count6", "more": []}], [{"count": "count6", "more": []}, {"count": "count23", "more": ["more48", "more49"]}], shared93, shared113],
        "degree": 2,
        "messages": [
          {"name": "TCP SYN", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared124},
          {"name": "TCP SYN-ACK", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "InitSyn", "cast": "unicast", "bytes": 110, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared124},
          {"name": "InitAck", "cast": "unicast", "bytes": 153, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "OpenSyn", "cast": "unicast", "bytes": 134, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared124},
          {"name": "OpenAck", "cast": "unicast", "bytes": 84, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Interest in tokens", "cast": "unicast", "bytes": 154.5017382527756, "frames": 0.08917, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared124},
          {"name": "Interest of publishers", "cast": "unicast", "bytes": 154.5017382527756, "frames": 0.08917, "unit": 1, "per_unit": 0.5, "hops": ["up"], "sent": shared124},
          {"name": "Declare", "cast": "unicast", "bytes": 144.9655172413793, "frames": 0.087, "unit": 1, "per_unit": 0.5, "hops": ["up"], "sent": shared124},
          {"name": "Declare token of node", "cast": "unicast", "bytes": 192.6407465007776, "frames": 0.05144, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared124},
          {"name": "Declare token", "cast": "unicast", "bytes": 192.6407465007776, "frames": 0.05144, "unit": 1, "per_unit": 1, "hops": ["up"], "sent": shared124},
          {"name": "Declare key expression of node", "cast": "unicast", "bytes": 358.9464799539613, "frames": 0.5213, "unit": 0, "per_unit": 2, "hops": ["up"], "sent": shared124},
          {"name": "Declare key expression", "cast": "unicast", "bytes": 358.9464799539613, "frames": 0.5213, "unit": 1, "per_unit": 1.5, "hops": ["up"], "sent": shared124},
          {"name": "Declare key expression of unmatched", "cast": "unicast", "bytes": 358.9464799539613, "frames": 0.5213, "unit": 2, "per_unit": 0.5, "hops": ["up"], "sent": shared124},
          {"name": "Frame up", "cast": "unicast", "bytes": 137.8131868131868, "frames": 0.1456, "unit": 0, "per_unit": 1.417, "hops": ["up"], "sent": shared124},
          {"name": "Frame of endpoints up", "cast": "unicast", "bytes": 137.8131868131868, "frames": 0.1456, "unit": 1, "per_unit": 1.292, "hops": ["up"], "sent": shared124},
          {"name": "Declare passed on", "cast": "unicast", "bytes": 125.74016332590944, "frames": 0.1347, "unit": 3, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Declare token of own node", "cast": "unicast", "bytes": 282.5695792880259, "frames": 0.0309, "unit": 0, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Declare own token", "cast": "unicast", "bytes": 282.5695792880259, "frames": 0.0309, "unit": 1, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Declare token of node passed on", "cast": "unicast", "bytes": 282.5695792880259, "frames": 0.0309, "unit": 4, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Declare token passed on", "cast": "unicast", "bytes": 282.5695792880259, "frames": 0.0309, "unit": 5, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Declare key expression of node passed on", "cast": "unicast", "bytes": 622.248870141609, "frames": 0.3319, "unit": 4, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Declare key expression passed on", "cast": "unicast", "bytes": 622.248870141609, "frames": 0.3319, "unit": 5, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Declare final", "cast": "unicast", "bytes": 148.72727272727272, "frames": 0.06875, "unit": 0, "per_unit": 1, "hops": ["down"], "sent": shared124},
          {"name": "Declare final to publishers", "cast": "unicast", "bytes": 148.72727272727272, "frames": 0.06875, "unit": 1, "per_unit": 0.5, "hops": ["down"], "sent": shared124},
          {"name": "Frame down", "cast": "unicast", "bytes": 156.64516129032256, "frames": 0.1116, "unit": 0, "per_unit": 3.188, "hops": ["down"], "sent": shared124},
          {"name": "Frame of endpoints down", "cast": "unicast", "bytes": 156.64516129032256, "frames": 0.1116, "unit": 1, "per_unit": 1.206, "hops": ["down"], "sent": shared124},
          {"name": "Frame of others down", "cast": "unicast", "bytes": 156.64516129032256, "frames": 0.1116, "unit": 5, "per_unit": 0.025, "hops": ["down"], "sent": shared124},
          {"name": "KeepAlive up", "cast": "unicast", "bytes": 79, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared125},
          {"name": "KeepAlive down", "cast": "unicast", "bytes": 79, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["down"], "sent": shared125},
          {"name": "TCP ACK up", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 0, "per_unit": 1, "hops": ["up"], "sent": shared125},
          {"name": "TCP ACK down", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 0, "per_unit": 0.5, "hops": ["down"], "sent": shared125},
          {"name": "TCP ACK at start up", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 0, "per_unit": 1.761, "hops": ["up"], "sent": shared124},
          {"name": "TCP ACK of endpoints up", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 1, "per_unit": 0.5636, "hops": ["up"], "sent": shared124},
          {"name": "TCP ACK of others up", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 4, "per_unit": 0.7871, "hops": ["up"], "sent": shared124},
          {"name": "TCP ACK at start down", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 0, "per_unit": 4.104, "hops": ["down"], "sent": shared124},
          {"name": "TCP ACK of endpoints down", "cast": "unicast", "bytes": 76, "frames": 1, "unit": 1, "per_unit": 0.07292, "hops": ["down"], "sent": shared124},
        ],
      },
    },
  };
})();
