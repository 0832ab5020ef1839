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
  const shared67 = ["Liveliness", "unicast", 179.99005799502902, 0.7242, 1, 1, "up down", shared66];
  const shared68 = ["Liveliness Heartbeat", "unicast", 180.02610587382162, 0.2758, 1, 1, "up down", shared66];
  const shared69 = ["Liveliness ACKNACK", "unicast", 128, 1, 1, 1, "up down", shared66];
  const shared70 = [shared48, shared52, shared50, shared59, shared60];
  const shared71 = ["SPDP", "multicast", 476, 1, 0, 1, "up down", shared62];
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
  const shared86 = ["Liveliness Heartbeat", "unicast", 192, 1, 4, 1.292, "up down", shared85];
  const shared87 = ["Liveliness ACKNACK", "unicast", 188, 1, 4, 1.292, "up down", shared85];
  const shared88 = ["User Heartbeat", "unicast", 192, 1, 5, 1.021, "up down", shared85];
  const shared89 = ["User ACKNACK", "unicast", 188, 1, 5, 1.021, "up down", shared85];
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
  const shared101 = ["Announce", "multicast", 80, 1, 0, 1, "up down", shared100];
  const shared102 = ["Process", "multicast", 24, 0, 1, 1, "up down", shared100];
  const shared103 = ["Endpoint", "multicast", 20, 0, 2, 1, "up down", shared100];
  const shared104 = ["Digest", "multicast", 80, 1, 3, 1, "up down", shared100];
  const shared105 = ["Listed", "multicast", 1, 0, 0, 1, "up down", shared100];
  const shared106 = {"burst": 0, "second": 0.3333333333333333, "lease": 0.3333333333333333, "ever": 0.3333333333333333};
  const shared107 = ["Heartbeat", "multicast", 80, 1, 0, 1, "up down", shared106];
  const shared108 = ["Claimed", "multicast", 0.125, 0, 4, 1, "up down", shared106];
  const shared109 = {"count": "count20", "more": ["count20"]};
  const shared110 = "The paper's messages, a product's periods";
  const shared111 = {"burst": 3.125, "second": 3.25, "lease": 0.4375, "ever": 0.125};
  const shared112 = {"burst": 0, "second": 0.4, "lease": 0.4, "ever": 0.4};
  const shared113 = [shared80, shared80];
  const shared114 = {"count": "count21", "more": ["more43", "more44"]};
  const shared115 = {"count": "count22", "more": ["more45", "more46", "more47"]};
  const shared116 = [shared48, shared52, shared59, shared50, [shared49, {"count": "count6", "more": []}], shared60];
  const shared117 = ["Scout", "multicast", 67, 1, 0, 1, "up down", shared111];
  const shared118 = ["Hello", "unicast", 104, 1, 1, 1, "up down", {"burst": 2.125, "second": 2.25, "lease": 0.3375, "ever": 0.125}];
  const shared119 = ["InitAck", "unicast", 153, 1, 1, 0.6667, "up down", shared65];
  const shared120 = ["OpenSyn", "unicast", 134, 1, 1, 0.6667, "up down", shared65];
  const shared121 = ["OpenAck", "unicast", 84, 1, 1, 0.6667, "up down", shared65];
  const shared122 = ["KeepAlive", "unicast", 79, 1, 1, 1.333, "up down", shared112];
  const shared123 = ["TCP control", "unicast", 76, 1, 1, 1.333, "up down", shared65];
  const shared124 = {"burst": 1, "second": 1, "lease": 0.016666666666666666, "ever": 0};
  const shared125 = {"burst": 0, "second": 0.03333333333333333, "lease": 0.03333333333333333, "ever": 0.03333333333333333};
  return {
    "start": {"robot": "Nav2 in one process", "middleware": "Fast DDS"},
    "groups": ["Products as built", "Products arranged against the storm", "As the paper counts", "The paper's messages, a product's periods", "Other tables"],
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
    "columns": ["name", "cast", "bytes", "frames", "unit", "per_unit", "hops", "sent"],
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
          ["SPDP", "multicast", 414, 1, 0, 1, "up down", {"burst": 1, "second": 1, "ever": 0}],
          ["SEDP", "unicast", 464, 1, 1, 1, "up down", {"burst": 1, "second": 1, "ever": 0}],
          ["Heartbeat", "unicast", 116, 1, 2, 2, "up down", {"burst": 1, "second": 1, "ever": 0}],
          ["ACKNACK", "unicast", 114, 1, 2, 2, "up down", {"burst": 1, "second": 1, "ever": 0}],
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
          ["Scout", "multicast", 80, 1, 0, 1, "up down", {"burst": 1, "second": 1, "ever": 0}],
          ["Hello", "unicast", 144, 1, 1, 1, "up down", {"burst": 1, "second": 1, "ever": 0}],
          ["Declare", "unicast", 176, 1, 2, 1, "up down", {"burst": 1, "second": 1, "ever": 0}],
          ["KeepAlive", "unicast", 84, 1, 1, 2, "up down", {"burst": 1, "second": 1, "ever": 0}],
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
          ["SPDP", "multicast", 420, 1, 0, 1, "up down", shared62],
          ["SPDP unicast", "unicast", 420, 1, 1, 1, "up down", shared63],
          ["SPDP directed", "unicast", 436, 1, 1, 0.75, "up down", shared64],
          ["SEDP", "unicast", 1011.3931423203381, 0.2129, 2, 1, "up down", shared65],
          ["SEDP again", "unicast", 1011.3931423203381, 0.2129, 3, 0.08438, "up down", shared65],
          ["Heartbeat", "unicast", 153.6732788798133, 0.5142, 1, 2, "up down", shared65],
          ["Heartbeat of data", "unicast", 153.6732788798133, 0.5142, 1, 2.375, "up down", shared65],
          ["ACKNACK", "unicast", 187.56178089044522, 0.3998, 1, 4.635, "up down", shared65],
          ["ACKNACK for others", "unicast", 187.56178089044522, 0.3998, 4, 0.09896, "up down", shared65],
          shared67,
          ["Liveliness at start", "unicast", 209.73193560464244, 0.5342, 1, 1, "up down", shared65],
          ["Liveliness for others", "unicast", 209.73193560464244, 0.5342, 4, 0.09375, "up down", shared65],
          shared68,
          ["Liveliness Heartbeat at start", "unicast", 157.8841449342257, 0.4333, 1, 2.208, "up down", shared65],
          shared69,
          ["Liveliness ACKNACK at start", "unicast", 193.64569775849603, 0.2766, 1, 2.275, "up down", shared65],
          ["Liveliness ACKNACK for others", "unicast", 193.64569775849603, 0.2766, 4, 0.05833, "up down", shared65],
          ["Type lookup Heartbeat", "unicast", 127.15414230714387, 0.7013, 1, 2.188, "up down", shared65],
          ["Type lookup ACKNACK", "unicast", 197.64779874213835, 0.2544, 1, 2, "up down", shared65],
          ["Type lookup ACKNACK for others", "unicast", 197.64779874213835, 0.2544, 4, 0.3125, "up down", shared65],
          ["User Heartbeat", "unicast", 141.09310113864703, 0.5972, 5, 1.15, "up down", shared65],
          ["User ACKNACK", "unicast", 184.34918723660445, 0.3322, 5, 1.6, "up down", shared65],
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
          ["SPDP directed", "unicast", 493.08762420957544, 0.9963, 1, 0.6667, "up down", shared64],
          ["SEDP", "unicast", 1167.7479630635523, 0.1841, 2, 0.5833, "up down", shared65],
          ["SEDP multicast", "multicast", 961.6660682226212, 0.2228, 2, 0.1667, "up down", shared65],
          ["Heartbeat multicast", "multicast", 232, 0.25, 0, 2, "up down", shared65],
          ["Heartbeat", "unicast", 201.42013994523882, 0.3287, 1, 3, "up down", shared65],
          ["ACKNACK", "unicast", 199.39703903095557, 0.3715, 1, 4.05, "up down", shared65],
          ["ACKNACK for others", "unicast", 199.39703903095557, 0.3715, 3, 0.2833, "up down", shared65],
          ["Liveliness", "multicast", 179.99005799502902, 0.7242, 0, 1, "up down", shared66],
          ["Liveliness at start", "multicast", 150.79816322270926, 0.9582, 0, 0.3333, "up down", shared65],
          ["Liveliness unicast", "unicast", 429, 0.2, 1, 0.5, "up down", shared65],
          ["Liveliness Heartbeat", "multicast", 180.02610587382162, 0.2758, 0, 1, "up down", shared66],
          ["Liveliness Heartbeat at start", "multicast", 245.09790605546124, 0.1767, 0, 0.875, "up down", shared65],
          ["Liveliness Heartbeat unicast", "unicast", 234.05196032120926, 0.2117, 1, 1.625, "up down", shared65],
          shared69,
          ["Liveliness ACKNACK at start", "unicast", 187.1920199501247, 0.2807, 1, 2.344, "up down", shared65],
          ["Liveliness ACKNACK for others", "unicast", 187.1920199501247, 0.2807, 3, 0.07812, "up down", shared65],
          ["Type lookup Heartbeat", "multicast", 224.96579476861166, 0.1988, 0, 2, "up down", shared65],
          ["Type lookup Heartbeat unicast", "unicast", 230.92749087115283, 0.1917, 1, 0.6667, "up down", shared65],
          ["Type lookup ACKNACK", "unicast", 211.5, 0.2, 1, 2, "up down", shared65],
          ["Type lookup ACKNACK for others", "unicast", 211.5, 0.2, 3, 0.3125, "up down", shared65],
          ["User Heartbeat", "unicast", 230.46065100947672, 0.2427, 4, 0.75, "up down", shared65],
          ["User Heartbeat multicast", "multicast", 232.6802973977695, 0.2152, 4, 0.25, "up down", shared65],
          ["User ACKNACK", "unicast", 226.06745510293473, 0.2283, 4, 2, "up down", shared65],
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
          ["SPDP", "multicast", 432, 1, 0, 1, "up down", shared62],
          ["SPDP unicast", "unicast", 432, 1, 1, 1, "up down", shared63],
          ["SPDP directed", "unicast", 432, 1, 1, 0.5625, "up down", shared64],
          ["SEDP", "unicast", 733.5900021925016, 0.4561, 2, 1, "up down", shared65],
          ["SEDP again", "unicast", 733.5900021925016, 0.4561, 3, 0.04792, "up down", shared65],
          ["Heartbeat", "unicast", 152.88683431952666, 0.5408, 1, 2, "up down", shared65],
          ["Heartbeat of data", "unicast", 152.88683431952666, 0.5408, 1, 2.833, "up down", shared65],
          ["ACKNACK", "unicast", 187.3409033560434, 0.3963, 1, 5.167, "up down", shared65],
          ["ACKNACK for others", "unicast", 187.3409033560434, 0.3963, 4, 0.125, "up down", shared65],
          shared67,
          ["Liveliness at start", "unicast", 193.85449071751128, 0.5979, 1, 1, "up down", shared65],
          ["Liveliness for others", "unicast", 193.85449071751128, 0.5979, 4, 0.04167, "up down", shared65],
          shared68,
          ["Liveliness Heartbeat at start", "unicast", 156.73844753016164, 0.4393, 1, 2.188, "up down", shared65],
          shared69,
          ["Liveliness ACKNACK at start", "unicast", 188.55516014234874, 0.281, 1, 2.385, "up down", shared65],
          ["Liveliness ACKNACK for others", "unicast", 188.55516014234874, 0.281, 4, 0.05729, "up down", shared65],
          ["Type lookup Heartbeat", "unicast", 134.83743842364532, 0.609, 1, 2.5, "up down", shared65],
          ["Type lookup ACKNACK", "unicast", 212.09610154125116, 0.2206, 1, 2, "up down", shared65],
          ["Type lookup ACKNACK for others", "unicast", 212.09610154125116, 0.2206, 4, 0.3125, "up down", shared65],
          ["User Heartbeat", "unicast", 134.96727272727273, 0.6875, 5, 1.2, "up down", shared65],
          ["User ACKNACK", "unicast", 175.87453323375652, 0.4017, 5, 1.75, "up down", shared65],
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
          ["SPDP", "unicast", 420, 1, 0, 9, "up down", shared62],
          ["ICMP unreachable", "unicast", 448, 1, 1, 6, "up down", shared75],
          ["SPDP directed", "unicast", 442.0177243557095, 0.9817, 2, 0.8333, "up down", shared64],
          ["SEDP", "unicast", 1224.46511627907, 0.172, 3, 1, "up down", shared65],
          ["SEDP again", "unicast", 334.84114485689287, 0.8001, 4, 0.08633, "up down", shared65],
          ["Heartbeat", "unicast", 150.13620569840168, 0.5756, 2, 2, "up down", shared65],
          ["Heartbeat of data", "unicast", 150.13620569840168, 0.5756, 2, 2.944, "up down", shared65],
          ["ACKNACK", "unicast", 191.25372354324537, 0.3827, 2, 4.424, "up down", shared65],
          ["ACKNACK for others", "unicast", 191.25372354324537, 0.3827, 5, 0.2049, "up down", shared65],
          ["Liveliness", "unicast", 180.00607650876952, 0.7241, 2, 1, "up down", shared66],
          ["Liveliness at start", "unicast", 170.0050484920951, 0.7527, 2, 1, "up down", shared65],
          ["Liveliness for others", "unicast", 170.0050484920951, 0.7527, 5, 0.08333, "up down", shared65],
          ["Liveliness Heartbeat", "unicast", 179.9840521928235, 0.2759, 2, 1, "up down", shared66],
          ["Liveliness Heartbeat at start", "unicast", 156.0150305307656, 0.4258, 2, 2.556, "up down", shared65],
          ["Liveliness ACKNACK", "unicast", 128, 1, 2, 1, "up down", shared66],
          ["Liveliness ACKNACK at start", "unicast", 190.60377358490564, 0.265, 2, 2.296, "up down", shared65],
          ["Liveliness ACKNACK for others", "unicast", 190.60377358490564, 0.265, 5, 0.09271, "up down", shared65],
          ["Type lookup Heartbeat", "unicast", 134.67330119732546, 0.6431, 2, 3, "up down", shared65],
          ["Type lookup ACKNACK", "unicast", 185.2367491166078, 0.283, 2, 2, "up down", shared65],
          ["Type lookup ACKNACK for others", "unicast", 185.2367491166078, 0.283, 5, 0.3631, "up down", shared65],
          ["User Heartbeat", "unicast", 147.20074005550418, 0.5405, 6, 1.542, "up down", shared65],
          ["User ACKNACK", "unicast", 166.51716247139586, 0.437, 6, 2.208, "up down", shared65],
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
          ["SPDP directed", "unicast", 492.4140969162995, 0.9988, 1, 0.8, "up down", shared64],
          ["SEDP", "unicast", 1040.4988009592325, 0.2085, 2, 0.3719, "up down", shared65],
          ["SEDP multicast", "multicast", 965.8901890189019, 0.2222, 2, 0.23, "up down", shared65],
          ["Heartbeat multicast", "multicast", 215.89285714285714, 0.28, 0, 1.833, "up down", shared65],
          ["Heartbeat", "unicast", 213.31594018453706, 0.3143, 1, 3.333, "up down", shared65],
          ["ACKNACK", "unicast", 200.7060146149522, 0.3558, 1, 4.517, "up down", shared65],
          ["ACKNACK for others", "unicast", 200.7060146149522, 0.3558, 3, 0.1494, "up down", shared65],
          ["Liveliness", "multicast", 180.02209944751382, 0.724, 0, 1, "up down", shared66],
          ["Liveliness at start", "multicast", 152.05954502568403, 0.9539, 0, 0.8333, "up down", shared65],
          ["Liveliness unicast", "unicast", 510.6666666666667, 0.15, 1, 0.5, "up down", shared65],
          ["Liveliness Heartbeat", "multicast", 179.94202898550725, 0.276, 0, 1, "up down", shared66],
          ["Liveliness Heartbeat at start", "multicast", 201.4570446735395, 0.2328, 0, 1, "up down", shared65],
          ["Liveliness Heartbeat unicast", "unicast", 219.65142364106987, 0.2318, 1, 1.75, "up down", shared65],
          shared69,
          ["Liveliness ACKNACK at start", "unicast", 186.30392156862746, 0.2856, 1, 2.379, "up down", shared65],
          ["Liveliness ACKNACK for others", "unicast", 186.30392156862746, 0.2856, 3, 0.08854, "up down", shared65],
          ["Type lookup Heartbeat", "multicast", 207.01075268817203, 0.2325, 0, 2, "up down", shared65],
          ["Type lookup Heartbeat unicast", "unicast", 249.3997682502897, 0.1726, 1, 1.167, "up down", shared65],
          ["Type lookup ACKNACK", "unicast", 210.50383141762453, 0.2088, 1, 2, "up down", shared65],
          ["Type lookup ACKNACK for others", "unicast", 210.50383141762453, 0.2088, 3, 0.3274, "up down", shared65],
          ["User Heartbeat", "unicast", 176.79097672186225, 0.4167, 4, 0.7917, "up down", shared65],
          ["User Heartbeat multicast", "multicast", 122.00209989500526, 0.6667, 4, 0.1667, "up down", shared65],
          ["User ACKNACK", "unicast", 167.19174466042716, 0.4167, 4, 2.167, "up down", shared65],
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
          ["SPDP to server", "unicast", 652, 1, 0, 1, "up", shared83],
          ["SPDP of server", "unicast", 700, 1, 0, 1, "down", shared84],
          ["SPDP of server at discovery", "unicast", 748.3930635838151, 0.865, 0, 1, "down", shared85],
          ["SPDP of others", "unicast", 683.9365973934484, 0.8517, 1, 1.967, "down", shared85],
          ["SPDP Heartbeat", "unicast", 192, 1, 0, 2, "up", shared85],
          ["SPDP Heartbeat of server", "unicast", 250.29586195342605, 0.5969, 0, 2.167, "down", shared85],
          ["SPDP Heartbeat of others", "unicast", 354.98051539912007, 0.3182, 1, 2.908, "down", shared85],
          ["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up", shared85],
          ["SPDP ACKNACK of others", "unicast", 190.2, 1, 1, 0.5083, "up", shared85],
          ["SPDP ACKNACK of server", "unicast", 188, 1, 0, 2, "down", shared85],
          ["SPDP Gap", "unicast", 204.14209591474247, 0.6193, 1, 1.6, "down", shared85],
          ["SEDP to server", "unicast", 1152, 0.45, 2, 1, "up", shared85],
          ["SEDP of others", "unicast", 655.9962112242481, 0.8446, 3, 1.237, "down", shared85],
          ["Heartbeat", "unicast", 192, 1, 0, 4, "up", shared85],
          ["Heartbeat of server", "unicast", 192, 1, 0, 4, "down", shared85],
          ["Heartbeat of others", "unicast", 451.4893977947413, 0.2358, 3, 1.892, "down", shared85],
          ["ACKNACK", "unicast", 188, 1, 0, 4, "up", shared85],
          ["ACKNACK of others", "unicast", 191.3, 1, 3, 0.45, "up", shared85],
          ["ACKNACK of server", "unicast", 188.5, 1, 0, 15.6, "down", shared85],
          ["Gap", "unicast", 205.97133664814274, 0.6838, 3, 0.645, "down", shared85],
          ["Liveliness Heartbeat to server", "unicast", 192, 1, 0, 1, "up", shared85],
          ["Liveliness Heartbeat of server", "unicast", 192, 1, 0, 2, "down", shared85],
          shared86,
          ["Liveliness ACKNACK to server", "unicast", 188, 1, 0, 2, "up", shared85],
          ["Liveliness ACKNACK of server", "unicast", 188, 1, 0, 2, "down", shared85],
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
          ["SPDP to server", "unicast", 636, 1, 0, 2, "up", shared83],
          ["SPDP of server", "unicast", 700, 1, 0, 2, "down", shared84],
          ["SPDP of server at discovery", "unicast", 747.8396673212429, 0.8657, 0, 2, "down", shared85],
          ["SPDP of others", "unicast", 684.0093940817285, 0.8516, 1, 3.9, "down", shared85],
          ["SPDP Heartbeat", "unicast", 192, 1, 0, 4, "up", shared85],
          ["SPDP Heartbeat of server", "unicast", 244.85106382978725, 0.6204, 0, 4.625, "down", shared85],
          ["SPDP Heartbeat of others", "unicast", 402.48973607038124, 0.2728, 1, 5.942, "down", shared85],
          ["SPDP ACKNACK", "unicast", 189.8, 1, 0, 4.625, "up", shared85],
          ["SPDP ACKNACK of others", "unicast", 190.5, 1, 1, 0.9417, "up", shared85],
          ["SPDP ACKNACK of server", "unicast", 188, 1, 0, 4, "down", shared85],
          ["SPDP Gap", "unicast", 199.09006997171358, 0.6717, 1, 3.333, "down", shared85],
          ["SEDP to server", "unicast", 1257.7301004163605, 0.4083, 2, 2, "up", shared85],
          ["SEDP of others", "unicast", 655.9962112242481, 0.8446, 3, 2.45, "down", shared85],
          ["Heartbeat", "unicast", 184, 1, 0, 8, "up", shared85],
          ["Heartbeat of server", "unicast", 192, 1, 0, 8, "down", shared85],
          ["Heartbeat of others", "unicast", 432.5140562248996, 0.249, 3, 3.242, "down", shared85],
          ["ACKNACK", "unicast", 188, 1, 0, 8, "up", shared85],
          ["ACKNACK of others", "unicast", 190.8, 1, 3, 0.85, "up", shared85],
          ["ACKNACK of server", "unicast", 188.5, 1, 0, 31.6, "down", shared85],
          ["Gap", "unicast", 207.54580397181294, 0.6244, 3, 1.03, "down", shared85],
          ["Liveliness Heartbeat to server", "unicast", 192, 1, 0, 2, "up", shared85],
          ["Liveliness Heartbeat of server", "unicast", 192, 1, 0, 4, "down", shared85],
          ["Liveliness Heartbeat", "unicast", 192, 1, 4, 1.208, "up down", shared85],
          ["Liveliness ACKNACK to server", "unicast", 188, 1, 0, 4, "up", shared85],
          ["Liveliness ACKNACK of server", "unicast", 188, 1, 0, 4, "down", shared85],
          ["Liveliness ACKNACK", "unicast", 188, 1, 4, 1.208, "up down", shared85],
          ["User Heartbeat", "unicast", 192, 1, 5, 1.08, "up down", shared85],
          ["User ACKNACK", "unicast", 188, 1, 5, 1.179, "up down", shared85],
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
          ["SPDP to server", "unicast", 652, 1, 0, 1, "up down", shared83],
          ["SPDP of server", "unicast", 700, 1, 0, 1, "up down", shared84],
          ["SPDP of server at discovery", "unicast", 748.3930635838151, 0.865, 0, 1, "up down", shared85],
          ["SPDP of others", "unicast", 683.9365973934484, 0.8517, 1, 1.967, "up down", shared85],
          ["SPDP Heartbeat", "unicast", 192, 1, 0, 2, "up down", shared85],
          ["SPDP Heartbeat of server", "unicast", 250.29586195342605, 0.5969, 0, 2.167, "up down", shared85],
          ["SPDP Heartbeat of others", "unicast", 354.98051539912007, 0.3182, 1, 2.908, "up down", shared85],
          ["SPDP ACKNACK", "unicast", 189.9, 1, 0, 2.167, "up down", shared85],
          ["SPDP ACKNACK of others", "unicast", 190.2, 1, 1, 0.5083, "up down", shared85],
          ["SPDP ACKNACK of server", "unicast", 188, 1, 0, 2, "up down", shared85],
          ["SPDP Gap", "unicast", 204.14209591474247, 0.6193, 1, 1.6, "up down", shared85],
          ["SEDP to server", "unicast", 1152, 0.45, 2, 1, "up down", shared85],
          ["SEDP of others", "unicast", 655.9962112242481, 0.8446, 3, 1.237, "up down", shared85],
          ["Heartbeat", "unicast", 192, 1, 0, 4, "up down", shared85],
          ["Heartbeat of server", "unicast", 192, 1, 0, 4, "up down", shared85],
          ["Heartbeat of others", "unicast", 451.4893977947413, 0.2358, 3, 1.892, "up down", shared85],
          ["ACKNACK", "unicast", 188, 1, 0, 4, "up down", shared85],
          ["ACKNACK of others", "unicast", 191.3, 1, 3, 0.45, "up down", shared85],
          ["ACKNACK of server", "unicast", 188.5, 1, 0, 15.6, "up down", shared85],
          ["Gap", "unicast", 205.97133664814274, 0.6838, 3, 0.645, "up down", shared85],
          ["Liveliness Heartbeat to server", "unicast", 192, 1, 0, 1, "up down", shared85],
          ["Liveliness Heartbeat of server", "unicast", 192, 1, 0, 2, "up down", shared85],
          shared86,
          ["Liveliness ACKNACK to server", "unicast", 188, 1, 0, 2, "up down", shared85],
          ["Liveliness ACKNACK of server", "unicast", 188, 1, 0, 2, "up down", shared85],
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
          ["SPDP", "multicast", 580, 1, 0, 1, "up down", shared83],
          ["SPDP at discovery", "multicast", 580, 1, 1, 1, "up down", shared85],
          ["SPDP unicast", "unicast", 580, 1, 2, 1, "up down", shared94],
          ["SPDP unicast at discovery", "unicast", 580, 1, 2, 1, "up down", shared85],
          ["SPDP unicast for others", "unicast", 580, 1, 3, 0.5, "up down", shared85],
          ["SEDP", "unicast", 821.0093457943925, 0.6313, 4, 1, "up down", shared85],
          ["Heartbeat", "unicast", 184.9, 1, 2, 2, "up down", shared85],
          ["Heartbeat of data", "unicast", 184.9, 1, 2, 1.893, "up down", shared85],
          ["Heartbeat of endpoints", "unicast", 184.9, 1, 4, 0.02679, "up down", shared85],
          ["ACKNACK", "unicast", 189.6, 1, 2, 2, "up down", shared85],
          ["ACKNACK of data", "unicast", 189.6, 1, 2, 2.583, "up down", shared85],
          ["Liveliness Heartbeat", "unicast", 192, 1, 2, 1.25, "up down", shared85],
          ["Liveliness ACKNACK", "unicast", 188, 1, 2, 1.25, "up down", shared85],
          ["User Heartbeat", "unicast", 192, 1, 5, 1.4, "up down", shared85],
          ["User ACKNACK", "unicast", 188, 1, 5, 1.425, "up down", shared85],
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
        "messages": [shared101, shared102, ["Software", "multicast", 8, 0, 0, 1, "up down", shared100], shared103, shared104, shared105, shared107, shared108],
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
          ["SPDP", "multicast", 414, 1, 0, 1, "up down", shared83],
          ["UnicastSPDP", "unicast", 414, 1, 1, 1, "up down", shared83],
          ["SEDP", "unicast", 464, 1, 2, 1, "up down", shared85],
          ["Heartbeat", "unicast", 116, 1, 1, 2, "up down", shared85],
          ["ACKNACK", "unicast", 114, 1, 1, 2, "up down", shared85],
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
          ["SPDP", "multicast", 414, 1, 0, 1, "up down", shared62],
          ["DirectedSPDP", "unicast", 414, 1, 1, 1, "up down", shared64],
          ["SEDP", "unicast", 464, 1, 2, 1, "up down", shared65],
          ["Heartbeat", "unicast", 116, 1, 1, 2, "up down", shared65],
          ["ACKNACK", "unicast", 114, 1, 1, 2, "up down", shared65],
          ["Liveliness", "unicast", 180, 1, 1, 1, "up down", shared75],
          ["LivelinessACK", "unicast", 114, 1, 1, 1, "up down", shared75],
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
        "messages": [["Scout", "multicast", 80, 1, 0, 1, "up down", shared111], ["Hello", "unicast", 144, 1, 1, 1, "up down", shared111], ["Declare", "unicast", 176, 1, 2, 1, "up down", shared65], ["KeepAlive", "unicast", 84, 1, 1, 1, "up down", shared112]],
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
          ["SPDP", "multicast", 589.2, 1, 0, 1, "up down", shared83],
          ["SPDP at discovery", "multicast", 589.2, 1, 1, 1, "up down", shared85],
          ["SPDP of endpoints", "multicast", 589.2, 1, 2, 1, "up down", shared85],
          ["SPDP unicast", "unicast", 589.2, 1, 3, 1, "up down", shared94],
          ["SPDP unicast at discovery", "unicast", 589.2, 1, 3, 1, "up down", shared85],
          ["SPDP unicast for others", "unicast", 589.2, 1, 4, 0.5, "up down", shared85],
          ["SPDP unicast of endpoints", "unicast", 589.2, 1, 5, 0.6542, "up down", shared85],
          ["Listed", "multicast", 59.47, 0, 2, 1, "up down", shared94],
          ["Listed at discovery", "multicast", 59.47, 0, 6, 0.8987, "up down", shared85],
          ["Listed of endpoints", "multicast", 59.47, 0, 7, 0.8987, "up down", shared85],
          ["Listed unicast", "unicast", 59.47, 0, 5, 1, "up down", shared94],
          ["Listed unicast at discovery", "unicast", 59.47, 0, 5, 0.9528, "up down", shared85],
          ["Listed unicast for others", "unicast", 59.47, 0, 8, 0.4764, "up down", shared85],
          ["Listed unicast of endpoints", "unicast", 59.47, 0, 9, 0.6233, "up down", shared85],
          ["Liveliness Heartbeat", "unicast", 192, 1, 3, 1.167, "up down", shared85],
          ["Liveliness ACKNACK", "unicast", 188, 1, 3, 1.167, "up down", shared85],
          ["User Heartbeat", "unicast", 192, 1, 10, 1.33, "up down", shared85],
          ["User ACKNACK", "unicast", 188, 1, 10, 1.33, "up down", shared85],
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
          ["Hello first", "unicast", 104, 1, 1, 0.5833, "up down", shared65],
          ["InitSyn", "unicast", 110, 1, 1, 0.6667, "up down", shared65],
          shared119,
          shared120,
          shared121,
          ["OAM", "unicast", 163.4251497005988, 0.835, 1, 1, "up down", shared65],
          ["OAM for others", "unicast", 163.4251497005988, 0.835, 2, 0.625, "up down", shared65],
          ["Declare", "unicast", 106.65917220235053, 0.1957, 3, 0.5, "up down", shared65],
          ["Declare key expression", "unicast", 229.04217991787982, 0.8037, 4, 0.5, "up down", shared65],
          ["Declare key expression of matching", "unicast", 229.04217991787982, 0.8037, 5, 0.5, "up down", shared65],
          ["Declare final", "unicast", 176, 0.05, 1, 1, "up down", shared65],
          ["Frame", "unicast", 112.31961259079904, 0.2478, 1, 1, "up down", shared65],
          ["Frame of endpoints", "unicast", 112.31961259079904, 0.2478, 3, 0.6083, "up down", shared65],
          shared122,
          shared123,
          ["TCP ACK", "unicast", 76, 1, 1, 0.8708, "up down", shared112],
          ["TCP ACK at start", "unicast", 76, 1, 1, 2.496, "up down", shared65],
          ["TCP ACK of endpoints", "unicast", 76, 1, 3, 0.2188, "up down", shared65],
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
          ["Hello first", "unicast", 104, 1, 1, 0.5, "up down", shared65],
          ["InitSyn", "unicast", 109.86, 1, 1, 0.6667, "up down", shared65],
          shared119,
          shared120,
          shared121,
          ["OAM", "unicast", 179.4287333522244, 0.7058, 1, 1, "up down", shared65],
          ["OAM for others", "unicast", 179.4287333522244, 0.7058, 2, 0.6493, "up down", shared65],
          ["Declare", "unicast", 167.6030534351145, 0.0655, 3, 0.5, "up down", shared65],
          ["Declare token", "unicast", 175.50248756218906, 0.0603, 3, 1, "up down", shared65],
          ["Declare token of node", "unicast", 175.50248756218906, 0.0603, 1, 1, "up down", shared65],
          ["Declare key expression", "unicast", 362.8385800401876, 0.5972, 4, 1.5, "up down", shared65],
          ["Declare key expression of matching", "unicast", 362.8385800401876, 0.5972, 5, 2.5, "up down", shared65],
          ["Declare key expression of node", "unicast", 362.8385800401876, 0.5972, 1, 1, "up down", shared65],
          ["Declare final", "unicast", 159.33333333333334, 0.06, 1, 1, "up down", shared65],
          ["Frame", "unicast", 142.56804733727813, 0.1352, 1, 2, "up down", shared65],
          ["Frame of endpoints", "unicast", 142.56804733727813, 0.1352, 3, 1, "up down", shared65],
          shared122,
          shared123,
          ["TCP ACK", "unicast", 76, 1, 1, 0.7208, "up down", shared112],
          ["TCP ACK at start", "unicast", 76, 1, 1, 3.325, "up down", shared65],
          ["TCP ACK of endpoints", "unicast", 76, 1, 3, 0.4208, "up down", shared65],
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
          ["TCP SYN", "unicast", 76, 1, 0, 1, "up", shared124],
          ["TCP SYN-ACK", "unicast", 76, 1, 0, 1, "down", shared124],
          ["InitSyn", "unicast", 110, 1, 0, 1, "up", shared124],
          ["InitAck", "unicast", 153, 1, 0, 1, "down", shared124],
          ["OpenSyn", "unicast", 134, 1, 0, 1, "up", shared124],
          ["OpenAck", "unicast", 84, 1, 0, 1, "down", shared124],
          ["Interest in tokens", "unicast", 154.5017382527756, 0.08917, 0, 1, "up", shared124],
          ["Interest of publishers", "unicast", 154.5017382527756, 0.08917, 1, 0.5, "up", shared124],
          ["Declare", "unicast", 144.9655172413793, 0.087, 1, 0.5, "up", shared124],
          ["Declare token of node", "unicast", 192.6407465007776, 0.05144, 0, 1, "up", shared124],
          ["Declare token", "unicast", 192.6407465007776, 0.05144, 1, 1, "up", shared124],
          ["Declare key expression of node", "unicast", 358.9464799539613, 0.5213, 0, 2, "up", shared124],
          ["Declare key expression", "unicast", 358.9464799539613, 0.5213, 1, 1.5, "up", shared124],
          ["Declare key expression of unmatched", "unicast", 358.9464799539613, 0.5213, 2, 0.5, "up", shared124],
          ["Frame up", "unicast", 137.8131868131868, 0.1456, 0, 1.417, "up", shared124],
          ["Frame of endpoints up", "unicast", 137.8131868131868, 0.1456, 1, 1.292, "up", shared124],
          ["Declare passed on", "unicast", 125.74016332590944, 0.1347, 3, 1, "down", shared124],
          ["Declare token of own node", "unicast", 282.5695792880259, 0.0309, 0, 1, "down", shared124],
          ["Declare own token", "unicast", 282.5695792880259, 0.0309, 1, 1, "down", shared124],
          ["Declare token of node passed on", "unicast", 282.5695792880259, 0.0309, 4, 1, "down", shared124],
          ["Declare token passed on", "unicast", 282.5695792880259, 0.0309, 5, 1, "down", shared124],
          ["Declare key expression of node passed on", "unicast", 622.248870141609, 0.3319, 4, 1, "down", shared124],
          ["Declare key expression passed on", "unicast", 622.248870141609, 0.3319, 5, 1, "down", shared124],
          ["Declare final", "unicast", 148.72727272727272, 0.06875, 0, 1, "down", shared124],
          ["Declare final to publishers", "unicast", 148.72727272727272, 0.06875, 1, 0.5, "down", shared124],
          ["Frame down", "unicast", 156.64516129032256, 0.1116, 0, 3.188, "down", shared124],
          ["Frame of endpoints down", "unicast", 156.64516129032256, 0.1116, 1, 1.206, "down", shared124],
          ["Frame of others down", "unicast", 156.64516129032256, 0.1116, 5, 0.025, "down", shared124],
          ["KeepAlive up", "unicast", 79, 1, 0, 1, "up", shared125],
          ["KeepAlive down", "unicast", 79, 1, 0, 1, "down", shared125],
          ["TCP ACK up", "unicast", 76, 1, 0, 1, "up", shared125],
          ["TCP ACK down", "unicast", 76, 1, 0, 0.5, "down", shared125],
          ["TCP ACK at start up", "unicast", 76, 1, 0, 1.761, "up", shared124],
          ["TCP ACK of endpoints up", "unicast", 76, 1, 1, 0.5636, "up", shared124],
          ["TCP ACK of others up", "unicast", 76, 1, 4, 0.7871, "up", shared124],
          ["TCP ACK at start down", "unicast", 76, 1, 0, 4.104, "down", shared124],
          ["TCP ACK of endpoints down", "unicast", 76, 1, 1, 0.07292, "down", shared124],
        ],
      },
    },
  };
})();
