// Made from the package by `make calculator` with sympy 1.14.0; do not edit.
const DISCOSTORM = {
  "fields": {
    "swarm": [
      {
        "name": "hosts",
        "label": "Hosts",
        "symbol": "N_H",
        "unit": "",
        "scale": 1,
        "start": "7",
        "low": 1,
        "high": 1000000000.0,
        "above": false,
        "allowed": "a number of at least 1 and at most 1,000,000,000",
      },
      {
        "name": "processes",
        "label": "Processes on each host",
        "symbol": "N_P",
        "unit": "",
        "scale": 1,
        "start": "2",
        "low": 1,
        "high": 1000000000.0,
        "above": false,
        "allowed": "a number of at least 1 and at most 1,000,000,000",
      },
      {
        "name": "endpoints",
        "label": "Endpoints of each process",
        "symbol": "N_E",
        "unit": "",
        "scale": 1,
        "start": "10",
        "low": 0,
        "high": 1000000000.0,
        "above": false,
        "allowed": "a number of at least 0 and at most 1,000,000,000",
      },
    ],
    "own": [
      {
        "name": "unicast_rate",
        "label": "Rate, unicast",
        "symbol": "R_uni",
        "unit": "Mbit/s",
        "scale": 1000000.0,
        "start": "144.4",
        "low": 0,
        "high": Infinity,
        "above": true,
        "allowed": "a number above 0",
      },
      {
        "name": "unicast_overhead",
        "label": "Overhead of a frame, unicast",
        "symbol": "O_uni",
        "unit": "µs",
        "scale": 1e-06,
        "start": "180",
        "low": 0,
        "high": Infinity,
        "above": false,
        "allowed": "a number of at least 0",
      },
      {
        "name": "multicast_rate",
        "label": "Rate, multicast",
        "symbol": "R_multi",
        "unit": "Mbit/s",
        "scale": 1000000.0,
        "start": "6",
        "low": 0,
        "high": Infinity,
        "above": true,
        "allowed": "a number above 0",
      },
      {
        "name": "multicast_overhead",
        "label": "Overhead of a frame, multicast",
        "symbol": "O_multi",
        "unit": "µs",
        "scale": 1e-06,
        "start": "120",
        "low": 0,
        "high": Infinity,
        "above": false,
        "allowed": "a number of at least 0",
      },
    ],
  },
  "channels": [
    {
      "name": "paper (802.11n)",
      "model": "linear",
      "values": {"R_uni": 144400000.0, "O_uni": 0.00018, "R_multi": 6000000.0, "O_multi": 0.00012},
    },
    {
      "name": "802.11a 20 MHz 1x1",
      "model": "padded",
      "values": {"R_uni": 54000000.0, "O_uni": 0.0001655, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 216.0, "N_add_uni": 22.0, "k_uni": 1.0, "t_grid_uni": 4e-06, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06},
    },
    {
      "name": "802.11g 20 MHz 1x1",
      "model": "padded",
      "values": {"R_uni": 54000000.0, "O_uni": 0.0001655, "R_multi": 1000000.0, "O_multi": 0.0002875, "N_DBPS_uni": 216.0, "N_add_uni": 22.0, "k_uni": 1.0, "t_grid_uni": 4e-06, "N_DBPS_multi": 1.0, "N_add_multi": 0.0, "k_multi": 1.0, "t_grid_multi": 1e-06},
    },
    {
      "name": "802.11n 20 MHz 2x2",
      "model": "padded",
      "values": {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 520.0, "N_add_uni": 22.0, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06},
    },
    {
      "name": "802.11n 20 MHz 2x2, 2.4 GHz",
      "model": "padded",
      "values": {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 1000000.0, "O_multi": 0.0002875, "N_DBPS_uni": 520.0, "N_add_uni": 22.0, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 1.0, "N_add_multi": 0.0, "k_multi": 1.0, "t_grid_multi": 1e-06},
    },
    {
      "name": "802.11n 40 MHz 2x2",
      "model": "padded",
      "values": {"R_uni": 300000000.0, "O_uni": 0.0001855, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 1080.0, "N_add_uni": 22.0, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06},
    },
    {
      "name": "802.11ac 80 MHz 2x2",
      "model": "padded",
      "values": {"R_uni": 866666666.6666666, "O_uni": 0.0001895, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 3120.0, "N_add_uni": 28.0, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06},
    },
    {
      "name": "802.11ax 20 MHz 2x2, 2.4 GHz",
      "model": "padded",
      "values": {"R_uni": 286764705.88235295, "O_uni": 0.0001959, "R_multi": 1000000.0, "O_multi": 0.0002875, "N_DBPS_uni": 3900.0, "N_add_uni": 16.0, "k_uni": 1.0, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 1.0, "N_add_multi": 0.0, "k_multi": 1.0, "t_grid_multi": 1e-06},
    },
    {
      "name": "802.11ax 80 MHz 2x2",
      "model": "padded",
      "values": {"R_uni": 1200980392.1568627, "O_uni": 0.0001959, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 16333.0, "N_add_uni": 16.0, "k_uni": 1.0, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06},
    },
    {
      "name": "802.11ax 160 MHz 2x2",
      "model": "padded",
      "values": {"R_uni": 2401960784.3137255, "O_uni": 0.0001959, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 32666.0, "N_add_uni": 16.0, "k_uni": 1.0, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06},
    },
    {
      "name": "802.11be 80 MHz 2x2",
      "model": "padded",
      "values": {"R_uni": 1441176470.5882354, "O_uni": 0.0002039, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 19600.0, "N_add_uni": 16.0, "k_uni": 1.0, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06},
    },
    {
      "name": "802.11be 320 MHz 2x2",
      "model": "padded",
      "values": {"R_uni": 5764705882.3529415, "O_uni": 0.0002039, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 78400.0, "N_add_uni": 16.0, "k_uni": 1.0, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06},
    },
    {
      "name": "802.11n 20 MHz 2x2, A-MPDU 64",
      "model": "aggregated",
      "values": {"R_uni": 144444444.44444445, "O_uni": 0.0001855, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 520.0, "N_add_uni": 22.0, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06, "n_agg": 64.0, "A_most": 65535.0, "O_agg": 0.0001895, "A_least": 0.0},
    },
    {
      "name": "802.11ac 80 MHz 2x2, A-MPDU 64",
      "model": "aggregated",
      "values": {"R_uni": 866666666.6666666, "O_uni": 0.0001895, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 3120.0, "N_add_uni": 28.0, "k_uni": 0.9, "t_grid_uni": 4e-06, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06, "n_agg": 64.0, "A_most": 589286.0, "O_agg": 0.0001935, "A_least": 0.0},
    },
    {
      "name": "802.11ax 80 MHz 2x2, A-MPDU 64",
      "model": "aggregated",
      "values": {"R_uni": 1200980392.1568627, "O_uni": 0.0001959, "R_multi": 6000000.0, "O_multi": 0.0001215, "N_DBPS_uni": 16333.0, "N_add_uni": 16.0, "k_uni": 1.0, "t_grid_uni": 1.36e-05, "N_DBPS_multi": 24.0, "N_add_multi": 22.0, "k_multi": 1.0, "t_grid_multi": 4e-06, "n_agg": 64.0, "A_most": 814606.0, "O_agg": 0.0001999, "A_least": 0.0},
    },
  ],
  "compared": ["DDS", "Zenoh"],
  "limit": {"U_limit": 1.0},
  "largest": ({ N_sat }) => { const rounded_0 = Math.ceil(N_sat); return rounded_0 - 1; },
  "drain": ({ B, rho }) => { return ((rho < 1) ? (
   B/(1 - rho)
)
: (
   Number.POSITIVE_INFINITY
)); },
  "protocols": {
    "DDS": {
      "color": "#0072B2",
      "values": {"s_SPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "H_UDP": 64.0},
      "messages": [
        {
          "name": "SPDP",
          "phase": "SPDP",
          "cast": "multicast",
          "load": ({ N_H, N_P }) => { return N_H*N_P; },
        },
        {
          "name": "SEDP",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_E, N_H, N_P }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "Heartbeat",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "ACKNACK",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
      ],
      "outlooks": {
        "Cyclone DDS": {
          "lease": 10.0,
          "until": [
            [
              1.0,
              "within a second at best",
            ],
            [
              10.0,
              "slow at best",
            ],
            [
              Infinity,
              "leases at risk",
            ],
          ],
          "never": "never catches up",
        },
        "Fast DDS": {
          "lease": 20.0,
          "until": [
            [
              1.0,
              "within a second at best",
            ],
            [
              20.0,
              "slow at best",
            ],
            [
              Infinity,
              "leases at risk",
            ],
          ],
          "never": "never catches up",
        },
      },
      "models": {
        "linear": {
          "utilization": ({ H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x3 = 8*s_SPDP + x1; const x4 = 4*x0; return N_E*x2*(2*O_uni + 2*x0*(8*s_SEDP + x1)) + N_H*N_P*(O_multi + O_uni + x0*x3 + x3/R_multi) + x2*(8*O_uni + x4*(8*s_ACKNACK + x1) + x4*(8*s_Heartbeat + x1)); },
          "saturation": ({ H_UDP, N_E, N_P, O_multi, O_uni, R_multi, R_uni, U_limit, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP }) => { const x0 = 8*H_UDP; const x1 = 8*s_SPDP + x0; const x2 = 1/R_uni; const x3 = N_P*(O_multi + O_uni + x1*x2 + x1/R_multi); const x4 = Math.pow(N_P, 2); const x5 = 16*x2; const x6 = 4*x2; const x7 = N_E*x4*(2*O_uni + 2*x2*(8*s_SEDP + x0)) + x3 + x4*(8*O_uni + x6*(8*s_ACKNACK + x0) + x6*(8*s_Heartbeat + x0)); return (2*U_limit - 2*x3)/(x7 + Math.sqrt(8*x4*(U_limit - x3)*(N_E*(O_uni + 8*x2*(H_UDP + s_SEDP)) + 4*O_uni + x5*(H_UDP + s_ACKNACK) + x5*(H_UDP + s_Heartbeat)) + Math.pow(x7, 2))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_SPDP }) => { return N_H*N_P*(O_uni + (8*H_UDP + 8*s_SPDP)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_multi, R_multi, s_SPDP }) => { return N_H*N_P*(O_multi + (8*H_UDP + 8*s_SPDP)/R_multi); },
              "both": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_SPDP }) => { const x0 = 8*H_UDP + 8*s_SPDP; const x1 = N_H*N_P; return x1*(O_multi + x0/R_multi) + x1*(O_uni + x0/R_uni); },
            },
            "SEDP": {
              "up": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
              "down": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
              "both": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
            },
            "Heartbeat": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
            },
            "ACKNACK": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
            },
          },
          "products": {
            "Cyclone DDS": {
              "values": {"s_SPDP": 350.0, "s_DirectedSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "s_Liveliness": 116.0, "s_LivelinessACK": 50.0, "H_UDP": 64.0},
              "burst": ({ H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP }) => { const x0 = 8*H_UDP; const x1 = 1/R_uni; const x2 = 2*x1; const x3 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x4 = 15.9*s_SPDP + 1.9875*x0; const x5 = 4*x1; return N_E*x3*(2*O_uni + x2*(8*s_SEDP + x0)) + N_H*N_P*(1.9875*O_multi + 1.9875*O_uni + x1*x4 + x4/R_multi) + x3*(20*O_uni + 8*x1*(8*s_DirectedSPDP + x0) + x2*(8*s_Liveliness + x0) + x2*(8*s_LivelinessACK + x0) + x5*(8*s_ACKNACK + x0) + x5*(8*s_Heartbeat + x0)); },
              "steady": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Liveliness, s_LivelinessACK, s_SPDP }) => { const x0 = 8*H_UDP; const x1 = 1.0*s_SPDP + 0.125*x0; const x2 = 1/R_uni; const x3 = 0.25*x2; return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.5*O_uni + x3*(8*s_Liveliness + x0) + x3*(8*s_LivelinessACK + x0)) + N_H*N_P*(0.125*O_multi + 0.125*O_uni + x1*x2 + x1/R_multi); },
            },
            "Fast DDS": {
              "values": {"s_SPDP": 350.0, "s_UnicastSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "H_UDP": 64.0},
              "burst": ({ H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x3 = 46.6666666666667*s_SPDP + 5.83333333333333*x1; const x4 = 4*x0; return N_E*x2*(2*O_uni + 2*x0*(8*s_SEDP + x1)) + N_H*N_P*(5.83333333333333*O_multi + 5.83333333333333*O_uni + x0*x3 + x3/R_multi) + x2*(19.6666666666667*O_uni + 11.6666666666667*x0*(8*s_UnicastSPDP + x1) + x4*(8*s_ACKNACK + x1) + x4*(8*s_Heartbeat + x1)); },
              "steady": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_SPDP, s_UnicastSPDP }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = 2.66666666666667*s_SPDP + 0.333333333333333*x1; return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.666666666666667*O_uni + 0.666666666666667*x0*(8*s_UnicastSPDP + x1)) + N_H*N_P*(0.333333333333333*O_multi + 0.333333333333333*O_uni + x0*x2 + x2/R_multi); },
            },
          },
        },
        "padded": {
          "utilization": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x1 = 4*t_grid_uni; return N_E*x0*(2*O_uni + 2*rounded_4*t_grid_uni) + N_H*N_P*(O_multi + O_uni + rounded_0*t_grid_multi + rounded_1*t_grid_uni) + x0*(8*O_uni + rounded_2*x1 + rounded_3*x1); },
          "saturation": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_multi, O_uni, U_limit, k_multi, k_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = N_P*(O_multi + O_uni + rounded_0*t_grid_multi + rounded_1*t_grid_uni); const x1 = Math.pow(N_P, 2); const x2 = 2*t_grid_uni; const x3 = rounded_4*t_grid_uni; const x4 = 4*t_grid_uni; const x5 = N_E*x1*(2*O_uni + 2*x3) + x0 + x1*(8*O_uni + rounded_2*x4 + rounded_3*x4); return (2*U_limit - 2*x0)/(x5 + Math.sqrt(8*x1*(U_limit - x0)*(N_E*(O_uni + x3) + 4*O_uni + rounded_2*x2 + rounded_3*x2) + Math.pow(x5, 2))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_SPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); return N_H*N_P*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_SPDP, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); return N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const x0 = N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_uni + rounded_1*t_grid_uni); },
            },
            "SEDP": {
              "up": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "Heartbeat": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "ACKNACK": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
          },
          "products": {
            "Cyclone DDS": {
              "values": {"s_SPDP": 350.0, "s_DirectedSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "s_Liveliness": 116.0, "s_LivelinessACK": 50.0, "H_UDP": 64.0},
              "burst": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_5 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_6 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_DirectedSPDP)/N_DBPS_uni)); const rounded_7 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = 2*t_grid_uni; const x1 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x2 = 4*t_grid_uni; return N_E*x1*(2*O_uni + rounded_7*x0) + N_H*N_P*(1.9875*O_multi + 1.9875*O_uni + 1.9875*rounded_0*t_grid_multi + 1.9875*rounded_1*t_grid_uni) + x1*(20*O_uni + rounded_2*x0 + rounded_3*x0 + rounded_4*x2 + rounded_5*x2 + 8*rounded_6*t_grid_uni); },
              "steady": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Liveliness, s_LivelinessACK, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); const x0 = 0.25*t_grid_uni; return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.5*O_uni + rounded_2*x0 + rounded_3*x0) + N_H*N_P*(0.125*O_multi + 0.125*O_uni + 0.125*rounded_0*t_grid_multi + 0.125*rounded_1*t_grid_uni); },
            },
            "Fast DDS": {
              "values": {"s_SPDP": 350.0, "s_UnicastSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "H_UDP": 64.0},
              "burst": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); const rounded_5 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x1 = 4*t_grid_uni; return N_E*x0*(2*O_uni + 2*rounded_5*t_grid_uni) + N_H*N_P*(5.83333333333333*O_multi + 5.83333333333333*O_uni + 5.83333333333333*rounded_0*t_grid_multi + 5.83333333333333*rounded_1*t_grid_uni) + x0*(19.6666666666667*O_uni + rounded_2*x1 + rounded_3*x1 + 11.6666666666667*rounded_4*t_grid_uni); },
              "steady": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.666666666666667*O_uni + 0.666666666666667*rounded_2*t_grid_uni) + N_H*N_P*(0.333333333333333*O_multi + 0.333333333333333*O_uni + 0.333333333333333*rounded_0*t_grid_multi + 0.333333333333333*rounded_1*t_grid_uni); },
            },
          },
        },
        "aggregated": {
          "utilization": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_8*t_grid_uni)/rounded_7 + N_H*N_P*(O_multi + rounded_0*t_grid_multi + (O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 4*(O_agg + rounded_4*t_grid_uni)/rounded_3); },
          "saturation": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_agg, O_multi, U_limit, k_multi, k_uni, n_agg, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1)))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1)))))/N_DBPS_uni)); const rounded_11 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1)))); const rounded_12 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1)))))/N_DBPS_uni)); const rounded_13 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1)))); const rounded_14 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1)))))/N_DBPS_uni)); const x0 = N_P*(O_multi + rounded_0*t_grid_multi + (O_agg + rounded_2*t_grid_uni)/rounded_1); const x1 = Math.pow(N_P, 2); const x2 = 2*N_E*x1*(O_agg + rounded_8*t_grid_uni)/rounded_7 + x0 + x1*(4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 4*(O_agg + rounded_4*t_grid_uni)/rounded_3); return (2*U_limit - 2*x0)/(x2 + Math.sqrt(8*x1*(U_limit - x0)*(N_E*(O_agg + rounded_14*t_grid_uni)/rounded_13 + 2*(O_agg + rounded_10*t_grid_uni)/rounded_9 + 2*(O_agg + rounded_12*t_grid_uni)/rounded_11) + Math.pow(x2, 2))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); return N_H*N_P*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_SPDP, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); return N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_agg + rounded_2*t_grid_uni)/rounded_1; },
            },
            "SEDP": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "Heartbeat": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "ACKNACK": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
          },
          "products": {
            "Cyclone DDS": {
              "values": {"s_SPDP": 350.0, "s_DirectedSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "s_Liveliness": 116.0, "s_LivelinessACK": 50.0, "H_UDP": 64.0},
              "burst": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_11 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))); const rounded_12 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_13 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_14 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_14*t_grid_uni)/rounded_13 + N_H*N_P*(1.9875*O_multi + 1.9875*rounded_0*t_grid_multi + 1.9875*(O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(4*(O_agg + rounded_10*t_grid_uni)/rounded_9 + 4*(O_agg + rounded_8*t_grid_uni)/rounded_7 + 2*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 2*(O_agg + rounded_4*t_grid_uni)/rounded_3 + 8*(O_agg + rounded_12*t_grid_uni)/rounded_11); },
              "steady": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Liveliness, s_LivelinessACK, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.25*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 0.25*(O_agg + rounded_4*t_grid_uni)/rounded_3) + N_H*N_P*(0.125*O_multi + 0.125*rounded_0*t_grid_multi + 0.125*(O_agg + rounded_2*t_grid_uni)/rounded_1); },
            },
            "Fast DDS": {
              "values": {"s_SPDP": 350.0, "s_UnicastSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "H_UDP": 64.0},
              "burst": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_10*t_grid_uni)/rounded_9 + N_H*N_P*(5.83333333333333*O_multi + 5.83333333333333*rounded_0*t_grid_multi + 5.83333333333333*(O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(11.6666666666667*(O_agg + rounded_8*t_grid_uni)/rounded_7 + 4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 4*(O_agg + rounded_4*t_grid_uni)/rounded_3); },
              "steady": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); return 0.666666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_4*t_grid_uni)/rounded_3 + N_H*N_P*(0.333333333333333*O_multi + 0.333333333333333*rounded_0*t_grid_multi + 0.333333333333333*(O_agg + rounded_2*t_grid_uni)/rounded_1); },
            },
          },
        },
      },
    },
    "Zenoh": {
      "color": "#D55E00",
      "values": {"s_Scout": 16.0, "s_Hello": 80.0, "s_Declare": 100.0, "s_KeepAlive": 8.0, "H_UDP": 64.0, "H_TCP": 76.0},
      "messages": [
        {
          "name": "Scout",
          "phase": "Scouting",
          "cast": "multicast",
          "load": ({ N_H, N_P }) => { return N_H*N_P; },
        },
        {
          "name": "Hello",
          "phase": "Scouting",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "Declare",
          "phase": "Declaration",
          "cast": "unicast",
          "load": ({ N_E, N_H, N_P }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "KeepAlive",
          "phase": "Declaration",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
      ],
      "outlooks": {
        "Zenoh peer": {
          "lease": 10.0,
          "until": [
            [
              1.0,
              "within a second at best",
            ],
            [
              10.0,
              "slow at best",
            ],
            [
              Infinity,
              "leases at risk",
            ],
          ],
          "never": "never catches up",
        },
      },
      "models": {
        "linear": {
          "utilization": ({ H_TCP, H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Declare, s_Hello, s_KeepAlive, s_Scout }) => { const x0 = 8*H_TCP; const x1 = 1/R_uni; const x2 = 2*x1; const x3 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x4 = 8*H_UDP; const x5 = 8*s_Scout + x4; return N_E*x3*(2*O_uni + x2*(8*s_Declare + x0)) + N_H*N_P*(O_multi + O_uni + x1*x5 + x5/R_multi) + x3*(6*O_uni + 4*x1*(8*s_KeepAlive + x0) + x2*(8*s_Hello + x4)); },
          "saturation": ({ H_TCP, H_UDP, N_E, N_P, O_multi, O_uni, R_multi, R_uni, U_limit, s_Declare, s_Hello, s_KeepAlive, s_Scout }) => { const x0 = 8*H_UDP; const x1 = 8*s_Scout + x0; const x2 = 1/R_uni; const x3 = N_P*(O_multi + O_uni + x1*x2 + x1/R_multi); const x4 = Math.pow(N_P, 2); const x5 = 8*x2; const x6 = 8*H_TCP; const x7 = 2*x2; const x8 = N_E*x4*(2*O_uni + x7*(8*s_Declare + x6)) + x3 + x4*(6*O_uni + 4*x2*(8*s_KeepAlive + x6) + x7*(8*s_Hello + x0)); return (2*U_limit - 2*x3)/(x8 + Math.sqrt(8*x4*(U_limit - x3)*(N_E*(O_uni + x5*(H_TCP + s_Declare)) + 3*O_uni + 16*x2*(H_TCP + s_KeepAlive) + x5*(H_UDP + s_Hello)) + Math.pow(x8, 2))) + 1; },
          "costs": {
            "Scout": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Scout }) => { return N_H*N_P*(O_uni + (8*H_UDP + 8*s_Scout)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_multi, R_multi, s_Scout }) => { return N_H*N_P*(O_multi + (8*H_UDP + 8*s_Scout)/R_multi); },
              "both": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Scout }) => { const x0 = 8*H_UDP + 8*s_Scout; const x1 = N_H*N_P; return x1*(O_multi + x0/R_multi) + x1*(O_uni + x0/R_uni); },
            },
            "Hello": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Hello }) => { return N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Hello)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Hello }) => { return N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Hello)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Hello }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Hello)/R_uni); },
            },
            "Declare": {
              "up": ({ H_TCP, N_E, N_H, N_P, O_uni, R_uni, s_Declare }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_Declare)/R_uni); },
              "down": ({ H_TCP, N_E, N_H, N_P, O_uni, R_uni, s_Declare }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_Declare)/R_uni); },
              "both": ({ H_TCP, N_E, N_H, N_P, O_uni, R_uni, s_Declare }) => { return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_Declare)/R_uni); },
            },
            "KeepAlive": {
              "up": ({ H_TCP, N_H, N_P, O_uni, R_uni, s_KeepAlive }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_KeepAlive)/R_uni); },
              "down": ({ H_TCP, N_H, N_P, O_uni, R_uni, s_KeepAlive }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_KeepAlive)/R_uni); },
              "both": ({ H_TCP, N_H, N_P, O_uni, R_uni, s_KeepAlive }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_KeepAlive)/R_uni); },
            },
          },
          "products": {
            "Zenoh peer": {
              "values": {"s_Scout": 16.0, "s_Hello": 80.0, "s_Declare": 100.0, "s_KeepAlive": 8.0, "H_UDP": 64.0, "H_TCP": 76.0},
              "burst": ({ H_TCP, H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Declare, s_Hello, s_Scout }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x3 = 25.0*s_Scout + 3.125*x1; return N_E*x2*(2*O_uni + 2*x0*(8*H_TCP + 8*s_Declare)) + N_H*N_P*(3.125*O_multi + 3.125*O_uni + x0*x3 + x3/R_multi) + x2*(6.25*O_uni + 6.25*x0*(8*s_Hello + x1)); },
              "steady": ({ H_TCP, H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Hello, s_KeepAlive, s_Scout }) => { const x0 = 8*H_UDP; const x1 = 1.0*s_Scout + 0.125*x0; const x2 = 1/R_uni; return N_H*Math.pow(N_P, 2)*(N_H - 1)*(1.05*O_uni + 0.8*x2*(8*H_TCP + 8*s_KeepAlive) + 0.25*x2*(8*s_Hello + x0)) + N_H*N_P*(0.125*O_multi + 0.125*O_uni + x1*x2 + x1/R_multi); },
            },
          },
        },
        "padded": {
          "utilization": ({ H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Declare, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); const x0 = 2*t_grid_uni; const x1 = N_H*Math.pow(N_P, 2)*(N_H - 1); return N_E*x1*(2*O_uni + rounded_4*x0) + N_H*N_P*(O_multi + O_uni + rounded_0*t_grid_multi + rounded_1*t_grid_uni) + x1*(6*O_uni + rounded_2*x0 + 4*rounded_3*t_grid_uni); },
          "saturation": ({ H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_multi, O_uni, U_limit, k_multi, k_uni, s_Declare, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); const x0 = N_P*(O_multi + O_uni + rounded_0*t_grid_multi + rounded_1*t_grid_uni); const x1 = Math.pow(N_P, 2); const x2 = rounded_2*t_grid_uni; const x3 = rounded_3*t_grid_uni; const x4 = rounded_4*t_grid_uni; const x5 = N_E*x1*(2*O_uni + 2*x4) + x0 + x1*(6*O_uni + 2*x2 + 4*x3); return (2*U_limit - 2*x0)/(x5 + Math.sqrt(8*x1*(U_limit - x0)*(N_E*(O_uni + x4) + 3*O_uni + x2 + 2*x3) + Math.pow(x5, 2))) + 1; },
          "costs": {
            "Scout": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Scout, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); return N_H*N_P*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_Scout, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); return N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const x0 = N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_uni + rounded_1*t_grid_uni); },
            },
            "Hello": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Hello, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Hello, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Hello, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "Declare": {
              "up": ({ H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_Declare, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_Declare, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_Declare, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "KeepAlive": {
              "up": ({ H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
          },
          "products": {
            "Zenoh peer": {
              "values": {"s_Scout": 16.0, "s_Hello": 80.0, "s_Declare": 100.0, "s_KeepAlive": 8.0, "H_UDP": 64.0, "H_TCP": 76.0},
              "burst": ({ H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Declare, s_Hello, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return N_E*x0*(2*O_uni + 2*rounded_3*t_grid_uni) + N_H*N_P*(3.125*O_multi + 3.125*O_uni + 3.125*rounded_0*t_grid_multi + 3.125*rounded_1*t_grid_uni) + x0*(6.25*O_uni + 6.25*rounded_2*t_grid_uni); },
              "steady": ({ H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(1.05*O_uni + 0.25*rounded_2*t_grid_uni + 0.8*rounded_3*t_grid_uni) + N_H*N_P*(0.125*O_multi + 0.125*O_uni + 0.125*rounded_0*t_grid_multi + 0.125*rounded_1*t_grid_uni); },
            },
          },
        },
        "aggregated": {
          "utilization": ({ A_least, A_most, H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Declare, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_8*t_grid_uni)/rounded_7 + N_H*N_P*(O_multi + rounded_0*t_grid_multi + (O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 2*(O_agg + rounded_4*t_grid_uni)/rounded_3); },
          "saturation": ({ A_least, A_most, H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_agg, O_multi, U_limit, k_multi, k_uni, n_agg, s_Declare, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Hello + 2)) + 1)))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Hello + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Hello + 2)) + 1)))))/N_DBPS_uni)); const rounded_11 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_KeepAlive + 2)) + 1)))); const rounded_12 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_KeepAlive + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_KeepAlive + 2)) + 1)))))/N_DBPS_uni)); const rounded_13 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_Declare + 2)) + 1)))); const rounded_14 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_Declare + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_Declare + 2)) + 1)))))/N_DBPS_uni)); const x0 = N_P*(O_multi + rounded_0*t_grid_multi + (O_agg + rounded_2*t_grid_uni)/rounded_1); const x1 = Math.pow(N_P, 2); const x2 = 2*N_E*x1*(O_agg + rounded_8*t_grid_uni)/rounded_7 + x0 + x1*(4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 2*(O_agg + rounded_4*t_grid_uni)/rounded_3); return (2*U_limit - 2*x0)/(x2 + Math.sqrt(8*x1*(U_limit - x0)*(N_E*(O_agg + rounded_14*t_grid_uni)/rounded_13 + (O_agg + rounded_10*t_grid_uni)/rounded_9 + 2*(O_agg + rounded_12*t_grid_uni)/rounded_11) + Math.pow(x2, 2))) + 1; },
          "costs": {
            "Scout": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Scout, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); return N_H*N_P*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_Scout, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); return N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_agg + rounded_2*t_grid_uni)/rounded_1; },
            },
            "Hello": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Hello, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Hello, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Hello, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "Declare": {
              "up": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Declare, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Declare, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Declare, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "KeepAlive": {
              "up": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
          },
          "products": {
            "Zenoh peer": {
              "values": {"s_Scout": 16.0, "s_Hello": 80.0, "s_Declare": 100.0, "s_KeepAlive": 8.0, "H_UDP": 64.0, "H_TCP": 76.0},
              "burst": ({ A_least, A_most, H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Declare, s_Hello, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_6*t_grid_uni)/rounded_5 + N_H*N_P*(3.125*O_multi + 3.125*rounded_0*t_grid_multi + 3.125*(O_agg + rounded_2*t_grid_uni)/rounded_1) + 6.25*x0*(O_agg + rounded_4*t_grid_uni)/rounded_3; },
              "steady": ({ A_least, A_most, H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.8*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 0.25*(O_agg + rounded_4*t_grid_uni)/rounded_3) + N_H*N_P*(0.125*O_multi + 0.125*rounded_0*t_grid_multi + 0.125*(O_agg + rounded_2*t_grid_uni)/rounded_1); },
            },
          },
        },
      },
    },
    "Cyclone DDS": {
      "color": "#009E73",
      "values": {"s_SPDP": 350.0, "s_DirectedSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "s_Liveliness": 116.0, "s_LivelinessACK": 50.0, "H_UDP": 64.0},
      "messages": [
        {
          "name": "SPDP",
          "phase": "SPDP",
          "cast": "multicast",
          "load": ({ N_H, N_P }) => { return 2.1125*N_H*N_P; },
        },
        {
          "name": "DirectedSPDP",
          "phase": "SPDP",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "SEDP",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_E, N_H, N_P }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "Heartbeat",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "ACKNACK",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "Liveliness",
          "phase": "Liveliness",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "LivelinessACK",
          "phase": "Liveliness",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
      ],
      "outlooks": {
        "Cyclone DDS": {
          "lease": 10.0,
          "until": [
            [
              1.0,
              "within a second at best",
            ],
            [
              10.0,
              "slow at best",
            ],
            [
              Infinity,
              "leases at risk",
            ],
          ],
          "never": "never catches up",
        },
      },
      "models": {
        "linear": {
          "utilization": ({ H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x3 = 16.9*s_SPDP + 2.1125*x1; const x4 = 2.25*x0; const x5 = 4*x0; return N_E*x2*(2*O_uni + 2*x0*(8*s_SEDP + x1)) + N_H*N_P*(2.1125*O_multi + 2.1125*O_uni + x0*x3 + x3/R_multi) + x2*(20.5*O_uni + 8*x0*(8*s_DirectedSPDP + x1) + x4*(8*s_Liveliness + x1) + x4*(8*s_LivelinessACK + x1) + x5*(8*s_ACKNACK + x1) + x5*(8*s_Heartbeat + x1)); },
          "saturation": ({ H_UDP, N_E, N_P, O_multi, O_uni, R_multi, R_uni, U_limit, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP }) => { const x0 = 8*H_UDP; const x1 = 16.9*s_SPDP + 2.1125*x0; const x2 = 1/R_uni; const x3 = N_P*(2.1125*O_multi + 2.1125*O_uni + x1*x2 + x1/R_multi); const x4 = Math.pow(N_P, 2); const x5 = 20.5*O_uni; const x6 = 32*x2; const x7 = 18.0*H_UDP; const x8 = 8*x2; const x9 = 2.25*x2; const x10 = 4*x2; const x11 = N_E*x4*(2*O_uni + 2*x2*(8*s_SEDP + x0)) + x3 + x4*(x10*(8*s_ACKNACK + x0) + x10*(8*s_Heartbeat + x0) + x5 + x8*(8*s_DirectedSPDP + x0) + x9*(8*s_Liveliness + x0) + x9*(8*s_LivelinessACK + x0)); return (2*U_limit - 2*x3)/(x11 + Math.sqrt(Math.pow(x11, 2) + 4*x4*(U_limit - x3)*(2*N_E*(O_uni + x8*(H_UDP + s_SEDP)) + 64*x2*(H_UDP + s_DirectedSPDP) + x2*(18.0*s_Liveliness + x7) + x2*(18.0*s_LivelinessACK + x7) + x5 + x6*(H_UDP + s_ACKNACK) + x6*(H_UDP + s_Heartbeat)))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_SPDP }) => { return 2.1125*N_H*N_P*(O_uni + (8*H_UDP + 8*s_SPDP)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_multi, R_multi, s_SPDP }) => { return 2.1125*N_H*N_P*(O_multi + (8*H_UDP + 8*s_SPDP)/R_multi); },
              "both": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_SPDP }) => { const x0 = 8*H_UDP + 8*s_SPDP; const x1 = 2.1125*N_H*N_P; return x1*(O_multi + x0/R_multi) + x1*(O_uni + x0/R_uni); },
            },
            "DirectedSPDP": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_DirectedSPDP }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_DirectedSPDP)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_DirectedSPDP }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_DirectedSPDP)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_DirectedSPDP }) => { return 8*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_DirectedSPDP)/R_uni); },
            },
            "SEDP": {
              "up": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
              "down": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
              "both": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
            },
            "Heartbeat": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
            },
            "ACKNACK": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
            },
            "Liveliness": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Liveliness }) => { return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Liveliness)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Liveliness }) => { return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Liveliness)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Liveliness }) => { return 2.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Liveliness)/R_uni); },
            },
            "LivelinessACK": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_LivelinessACK }) => { return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_LivelinessACK)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_LivelinessACK }) => { return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_LivelinessACK)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_LivelinessACK }) => { return 2.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_LivelinessACK)/R_uni); },
            },
          },
          "products": {
            "Cyclone DDS": {
              "values": {"s_SPDP": 350.0, "s_DirectedSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "s_Liveliness": 116.0, "s_LivelinessACK": 50.0, "H_UDP": 64.0},
              "burst": ({ H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP }) => { const x0 = 8*H_UDP; const x1 = 1/R_uni; const x2 = 2*x1; const x3 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x4 = 15.9*s_SPDP + 1.9875*x0; const x5 = 4*x1; return N_E*x3*(2*O_uni + x2*(8*s_SEDP + x0)) + N_H*N_P*(1.9875*O_multi + 1.9875*O_uni + x1*x4 + x4/R_multi) + x3*(20*O_uni + 8*x1*(8*s_DirectedSPDP + x0) + x2*(8*s_Liveliness + x0) + x2*(8*s_LivelinessACK + x0) + x5*(8*s_ACKNACK + x0) + x5*(8*s_Heartbeat + x0)); },
              "steady": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Liveliness, s_LivelinessACK, s_SPDP }) => { const x0 = 8*H_UDP; const x1 = 1.0*s_SPDP + 0.125*x0; const x2 = 1/R_uni; const x3 = 0.25*x2; return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.5*O_uni + x3*(8*s_Liveliness + x0) + x3*(8*s_LivelinessACK + x0)) + N_H*N_P*(0.125*O_multi + 0.125*O_uni + x1*x2 + x1/R_multi); },
            },
          },
        },
        "padded": {
          "utilization": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_DirectedSPDP)/N_DBPS_uni)); const rounded_5 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); const rounded_6 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); const rounded_7 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x1 = 2.25*t_grid_uni; const x2 = 4*t_grid_uni; return N_E*x0*(2*O_uni + 2*rounded_7*t_grid_uni) + N_H*N_P*(2.1125*O_multi + 2.1125*O_uni + 2.1125*rounded_0*t_grid_multi + 2.1125*rounded_1*t_grid_uni) + x0*(20.5*O_uni + rounded_2*x2 + rounded_3*x2 + 8*rounded_4*t_grid_uni + rounded_5*x1 + rounded_6*x1); },
          "saturation": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_multi, O_uni, U_limit, k_multi, k_uni, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_DirectedSPDP)/N_DBPS_uni)); const rounded_5 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); const rounded_6 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); const rounded_7 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = N_P*(2.1125*O_multi + 2.1125*O_uni + 2.1125*rounded_0*t_grid_multi + 2.1125*rounded_1*t_grid_uni); const x1 = Math.pow(N_P, 2); const x2 = rounded_7*t_grid_uni; const x3 = 2.25*t_grid_uni; const x4 = 4*t_grid_uni; const x5 = 20.5*O_uni + rounded_2*x4 + rounded_3*x4 + 8*rounded_4*t_grid_uni + rounded_5*x3 + rounded_6*x3; const x6 = N_E*x1*(2*O_uni + 2*x2) + x0 + x1*x5; return (2*U_limit - 2*x0)/(x6 + Math.sqrt(4*x1*(U_limit - x0)*(2*N_E*(O_uni + x2) + x5) + Math.pow(x6, 2))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_SPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); return 2.1125*N_H*N_P*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_SPDP, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); return 2.1125*N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const x0 = 2.1125*N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_uni + rounded_1*t_grid_uni); },
            },
            "DirectedSPDP": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_DirectedSPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_DirectedSPDP)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_DirectedSPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_DirectedSPDP)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_DirectedSPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_DirectedSPDP)/N_DBPS_uni)); return 8*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "SEDP": {
              "up": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "Heartbeat": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "ACKNACK": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "Liveliness": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Liveliness, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Liveliness, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Liveliness, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); return 2.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "LivelinessACK": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_LivelinessACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_LivelinessACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_LivelinessACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); return 2.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
          },
          "products": {
            "Cyclone DDS": {
              "values": {"s_SPDP": 350.0, "s_DirectedSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "s_Liveliness": 116.0, "s_LivelinessACK": 50.0, "H_UDP": 64.0},
              "burst": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_5 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_6 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_DirectedSPDP)/N_DBPS_uni)); const rounded_7 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = 2*t_grid_uni; const x1 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x2 = 4*t_grid_uni; return N_E*x1*(2*O_uni + rounded_7*x0) + N_H*N_P*(1.9875*O_multi + 1.9875*O_uni + 1.9875*rounded_0*t_grid_multi + 1.9875*rounded_1*t_grid_uni) + x1*(20*O_uni + rounded_2*x0 + rounded_3*x0 + rounded_4*x2 + rounded_5*x2 + 8*rounded_6*t_grid_uni); },
              "steady": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Liveliness, s_LivelinessACK, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Liveliness)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_LivelinessACK)/N_DBPS_uni)); const x0 = 0.25*t_grid_uni; return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.5*O_uni + rounded_2*x0 + rounded_3*x0) + N_H*N_P*(0.125*O_multi + 0.125*O_uni + 0.125*rounded_0*t_grid_multi + 0.125*rounded_1*t_grid_uni); },
            },
          },
        },
        "aggregated": {
          "utilization": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); const rounded_11 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_12 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_13 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_14 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_14*t_grid_uni)/rounded_13 + N_H*N_P*(2.1125*O_multi + 2.1125*rounded_0*t_grid_multi + 2.1125*(O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(2.25*(O_agg + rounded_10*t_grid_uni)/rounded_9 + 8*(O_agg + rounded_8*t_grid_uni)/rounded_7 + 4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 4*(O_agg + rounded_4*t_grid_uni)/rounded_3 + 2.25*(O_agg + rounded_12*t_grid_uni)/rounded_11); },
          "saturation": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_agg, O_multi, U_limit, k_multi, k_uni, n_agg, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); const rounded_11 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_12 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_13 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_14 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_15 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Liveliness + 2)) + 1)))); const rounded_16 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Liveliness + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Liveliness + 2)) + 1)))))/N_DBPS_uni)); const rounded_17 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_LivelinessACK + 2)) + 1)))); const rounded_18 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_LivelinessACK + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_LivelinessACK + 2)) + 1)))))/N_DBPS_uni)); const rounded_19 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1)))); const rounded_20 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1)))))/N_DBPS_uni)); const rounded_21 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1)))); const rounded_22 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1)))))/N_DBPS_uni)); const rounded_23 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_DirectedSPDP + 2)) + 1)))); const rounded_24 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_DirectedSPDP + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_DirectedSPDP + 2)) + 1)))))/N_DBPS_uni)); const rounded_25 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1)))); const rounded_26 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1)))))/N_DBPS_uni)); const x0 = N_P*(2.1125*O_multi + 2.1125*rounded_0*t_grid_multi + 2.1125*(O_agg + rounded_2*t_grid_uni)/rounded_1); const x1 = Math.pow(N_P, 2); const x2 = 2*N_E; const x3 = x0 + x1*(2.25*(O_agg + rounded_10*t_grid_uni)/rounded_9 + 8*(O_agg + rounded_8*t_grid_uni)/rounded_7 + 4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 4*(O_agg + rounded_4*t_grid_uni)/rounded_3 + 2.25*(O_agg + rounded_12*t_grid_uni)/rounded_11) + x1*x2*(O_agg + rounded_14*t_grid_uni)/rounded_13; const x4 = 2.25*O_agg; const x5 = 2.25*t_grid_uni; return (2*U_limit - 2*x0)/(x3 + Math.sqrt(4*x1*(U_limit - x0)*(x2*(O_agg + rounded_26*t_grid_uni)/rounded_25 + 8*(O_agg + rounded_24*t_grid_uni)/rounded_23 + 4*(O_agg + rounded_22*t_grid_uni)/rounded_21 + 4*(O_agg + rounded_20*t_grid_uni)/rounded_19 + (rounded_18*x5 + x4)/rounded_17 + (rounded_16*x5 + x4)/rounded_15) + Math.pow(x3, 2))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); return 2.1125*N_H*N_P*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_SPDP, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); return 2.1125*N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = 2.1125*N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_agg + rounded_2*t_grid_uni)/rounded_1; },
            },
            "DirectedSPDP": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_DirectedSPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_DirectedSPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_DirectedSPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))))/N_DBPS_uni)); return 8*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "SEDP": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "Heartbeat": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "ACKNACK": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "Liveliness": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Liveliness, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Liveliness, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Liveliness, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); return 2.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "LivelinessACK": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_LivelinessACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_LivelinessACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); return 1.125*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_LivelinessACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); return 2.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
          },
          "products": {
            "Cyclone DDS": {
              "values": {"s_SPDP": 350.0, "s_DirectedSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "s_Liveliness": 116.0, "s_LivelinessACK": 50.0, "H_UDP": 64.0},
              "burst": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_ACKNACK, s_DirectedSPDP, s_Heartbeat, s_Liveliness, s_LivelinessACK, s_SEDP, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_11 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))); const rounded_12 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_DirectedSPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_13 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_14 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_14*t_grid_uni)/rounded_13 + N_H*N_P*(1.9875*O_multi + 1.9875*rounded_0*t_grid_multi + 1.9875*(O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(4*(O_agg + rounded_10*t_grid_uni)/rounded_9 + 4*(O_agg + rounded_8*t_grid_uni)/rounded_7 + 2*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 2*(O_agg + rounded_4*t_grid_uni)/rounded_3 + 8*(O_agg + rounded_12*t_grid_uni)/rounded_11); },
              "steady": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Liveliness, s_LivelinessACK, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Liveliness + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_LivelinessACK + 1/2) + 4))))/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.25*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 0.25*(O_agg + rounded_4*t_grid_uni)/rounded_3) + N_H*N_P*(0.125*O_multi + 0.125*rounded_0*t_grid_multi + 0.125*(O_agg + rounded_2*t_grid_uni)/rounded_1); },
            },
          },
        },
      },
    },
    "Fast DDS": {
      "color": "#CC79A7",
      "values": {"s_SPDP": 350.0, "s_UnicastSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "H_UDP": 64.0},
      "messages": [
        {
          "name": "SPDP",
          "phase": "SPDP",
          "cast": "multicast",
          "load": ({ N_H, N_P }) => { return 6.16666666666667*N_H*N_P; },
        },
        {
          "name": "UnicastSPDP",
          "phase": "SPDP",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 6.16666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "SEDP",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_E, N_H, N_P }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "Heartbeat",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "ACKNACK",
          "phase": "SEDP",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
      ],
      "outlooks": {
        "Fast DDS": {
          "lease": 20.0,
          "until": [
            [
              1.0,
              "within a second at best",
            ],
            [
              20.0,
              "slow at best",
            ],
            [
              Infinity,
              "leases at risk",
            ],
          ],
          "never": "never catches up",
        },
      },
      "models": {
        "linear": {
          "utilization": ({ H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x3 = 49.3333333333333*s_SPDP + 6.16666666666667*x1; const x4 = 4*x0; return N_E*x2*(2*O_uni + 2*x0*(8*s_SEDP + x1)) + N_H*N_P*(6.16666666666667*O_multi + 6.16666666666667*O_uni + x0*x3 + x3/R_multi) + x2*(20.3333333333333*O_uni + 12.3333333333333*x0*(8*s_UnicastSPDP + x1) + x4*(8*s_ACKNACK + x1) + x4*(8*s_Heartbeat + x1)); },
          "saturation": ({ H_UDP, N_E, N_P, O_multi, O_uni, R_multi, R_uni, U_limit, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP }) => { const x0 = 8*H_UDP; const x1 = 49.3333333333333*s_SPDP + 6.16666666666667*x0; const x2 = 1/R_uni; const x3 = N_P*(6.16666666666667*O_multi + 6.16666666666667*O_uni + x1*x2 + x1/R_multi); const x4 = Math.pow(N_P, 2); const x5 = 20.3333333333333*O_uni; const x6 = 32*x2; const x7 = 4*x2; const x8 = N_E*x4*(2*O_uni + 2*x2*(8*s_SEDP + x0)) + x3 + x4*(12.3333333333333*x2*(8*s_UnicastSPDP + x0) + x5 + x7*(8*s_ACKNACK + x0) + x7*(8*s_Heartbeat + x0)); return (2*U_limit - 2*x3)/(x8 + Math.sqrt(4*x4*(U_limit - x3)*(2*N_E*(O_uni + 8*x2*(H_UDP + s_SEDP)) + x2*(98.6666666666667*H_UDP + 98.6666666666667*s_UnicastSPDP) + x5 + x6*(H_UDP + s_ACKNACK) + x6*(H_UDP + s_Heartbeat)) + Math.pow(x8, 2))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_SPDP }) => { return 6.16666666666667*N_H*N_P*(O_uni + (8*H_UDP + 8*s_SPDP)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_multi, R_multi, s_SPDP }) => { return 6.16666666666667*N_H*N_P*(O_multi + (8*H_UDP + 8*s_SPDP)/R_multi); },
              "both": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_SPDP }) => { const x0 = 8*H_UDP + 8*s_SPDP; const x1 = 6.16666666666667*N_H*N_P; return x1*(O_multi + x0/R_multi) + x1*(O_uni + x0/R_uni); },
            },
            "UnicastSPDP": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_UnicastSPDP }) => { return 6.16666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_UnicastSPDP)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_UnicastSPDP }) => { return 6.16666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_UnicastSPDP)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_UnicastSPDP }) => { return 12.3333333333333*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_UnicastSPDP)/R_uni); },
            },
            "SEDP": {
              "up": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
              "down": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
              "both": ({ H_UDP, N_E, N_H, N_P, O_uni, R_uni, s_SEDP }) => { return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_SEDP)/R_uni); },
            },
            "Heartbeat": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Heartbeat }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Heartbeat)/R_uni); },
            },
            "ACKNACK": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_ACKNACK }) => { return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_ACKNACK)/R_uni); },
            },
          },
          "products": {
            "Fast DDS": {
              "values": {"s_SPDP": 350.0, "s_UnicastSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "H_UDP": 64.0},
              "burst": ({ H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x3 = 46.6666666666667*s_SPDP + 5.83333333333333*x1; const x4 = 4*x0; return N_E*x2*(2*O_uni + 2*x0*(8*s_SEDP + x1)) + N_H*N_P*(5.83333333333333*O_multi + 5.83333333333333*O_uni + x0*x3 + x3/R_multi) + x2*(19.6666666666667*O_uni + 11.6666666666667*x0*(8*s_UnicastSPDP + x1) + x4*(8*s_ACKNACK + x1) + x4*(8*s_Heartbeat + x1)); },
              "steady": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_SPDP, s_UnicastSPDP }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = 2.66666666666667*s_SPDP + 0.333333333333333*x1; return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.666666666666667*O_uni + 0.666666666666667*x0*(8*s_UnicastSPDP + x1)) + N_H*N_P*(0.333333333333333*O_multi + 0.333333333333333*O_uni + x0*x2 + x2/R_multi); },
            },
          },
        },
        "padded": {
          "utilization": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); const rounded_5 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x1 = 4*t_grid_uni; return N_E*x0*(2*O_uni + 2*rounded_5*t_grid_uni) + N_H*N_P*(6.16666666666667*O_multi + 6.16666666666667*O_uni + 6.16666666666667*rounded_0*t_grid_multi + 6.16666666666667*rounded_1*t_grid_uni) + x0*(20.3333333333333*O_uni + rounded_2*x1 + rounded_3*x1 + 12.3333333333333*rounded_4*t_grid_uni); },
          "saturation": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_multi, O_uni, U_limit, k_multi, k_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); const rounded_5 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = N_P*(6.16666666666667*O_multi + 6.16666666666667*O_uni + 6.16666666666667*rounded_0*t_grid_multi + 6.16666666666667*rounded_1*t_grid_uni); const x1 = Math.pow(N_P, 2); const x2 = rounded_5*t_grid_uni; const x3 = 4*t_grid_uni; const x4 = 20.3333333333333*O_uni + rounded_2*x3 + rounded_3*x3 + 12.3333333333333*rounded_4*t_grid_uni; const x5 = N_E*x1*(2*O_uni + 2*x2) + x0 + x1*x4; return (2*U_limit - 2*x0)/(x5 + Math.sqrt(4*x1*(U_limit - x0)*(2*N_E*(O_uni + x2) + x4) + Math.pow(x5, 2))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_SPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); return 6.16666666666667*N_H*N_P*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_SPDP, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); return 6.16666666666667*N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const x0 = 6.16666666666667*N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_uni + rounded_1*t_grid_uni); },
            },
            "UnicastSPDP": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_UnicastSPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); return 6.16666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_UnicastSPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); return 6.16666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_UnicastSPDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); return 12.3333333333333*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "SEDP": {
              "up": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "Heartbeat": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "ACKNACK": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
          },
          "products": {
            "Fast DDS": {
              "values": {"s_SPDP": 350.0, "s_UnicastSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "H_UDP": 64.0},
              "burst": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_ACKNACK)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Heartbeat)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); const rounded_5 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SEDP)/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x1 = 4*t_grid_uni; return N_E*x0*(2*O_uni + 2*rounded_5*t_grid_uni) + N_H*N_P*(5.83333333333333*O_multi + 5.83333333333333*O_uni + 5.83333333333333*rounded_0*t_grid_multi + 5.83333333333333*rounded_1*t_grid_uni) + x0*(19.6666666666667*O_uni + rounded_2*x1 + rounded_3*x1 + 11.6666666666667*rounded_4*t_grid_uni); },
              "steady": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_SPDP)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_UnicastSPDP)/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.666666666666667*O_uni + 0.666666666666667*rounded_2*t_grid_uni) + N_H*N_P*(0.333333333333333*O_multi + 0.333333333333333*O_uni + 0.333333333333333*rounded_0*t_grid_multi + 0.333333333333333*rounded_1*t_grid_uni); },
            },
          },
        },
        "aggregated": {
          "utilization": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_10*t_grid_uni)/rounded_9 + N_H*N_P*(6.16666666666667*O_multi + 6.16666666666667*rounded_0*t_grid_multi + 6.16666666666667*(O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(12.3333333333333*(O_agg + rounded_8*t_grid_uni)/rounded_7 + 4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 4*(O_agg + rounded_4*t_grid_uni)/rounded_3); },
          "saturation": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_agg, O_multi, U_limit, k_multi, k_uni, n_agg, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_11 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_UnicastSPDP + 2)) + 1)))); const rounded_12 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_UnicastSPDP + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_UnicastSPDP + 2)) + 1)))))/N_DBPS_uni)); const rounded_13 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1)))); const rounded_14 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_ACKNACK + 2)) + 1)))))/N_DBPS_uni)); const rounded_15 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1)))); const rounded_16 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Heartbeat + 2)) + 1)))))/N_DBPS_uni)); const rounded_17 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1)))); const rounded_18 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_SEDP + 2)) + 1)))))/N_DBPS_uni)); const x0 = N_P*(6.16666666666667*O_multi + 6.16666666666667*rounded_0*t_grid_multi + 6.16666666666667*(O_agg + rounded_2*t_grid_uni)/rounded_1); const x1 = Math.pow(N_P, 2); const x2 = 2*N_E; const x3 = x0 + x1*(12.3333333333333*(O_agg + rounded_8*t_grid_uni)/rounded_7 + 4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 4*(O_agg + rounded_4*t_grid_uni)/rounded_3) + x1*x2*(O_agg + rounded_10*t_grid_uni)/rounded_9; return (2*U_limit - 2*x0)/(x3 + Math.sqrt(4*x1*(U_limit - x0)*(x2*(O_agg + rounded_18*t_grid_uni)/rounded_17 + 4*(O_agg + rounded_16*t_grid_uni)/rounded_15 + 4*(O_agg + rounded_14*t_grid_uni)/rounded_13 + (12.3333333333333*O_agg + 12.3333333333333*rounded_12*t_grid_uni)/rounded_11) + Math.pow(x3, 2))) + 1; },
          "costs": {
            "SPDP": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); return 6.16666666666667*N_H*N_P*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_SPDP, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); return 6.16666666666667*N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_SPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = 6.16666666666667*N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_agg + rounded_2*t_grid_uni)/rounded_1; },
            },
            "UnicastSPDP": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_UnicastSPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); return 6.16666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_UnicastSPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); return 6.16666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_UnicastSPDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); return 12.3333333333333*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "SEDP": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_SEDP, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "Heartbeat": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Heartbeat, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "ACKNACK": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 2*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_ACKNACK, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); return 4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
          },
          "products": {
            "Fast DDS": {
              "values": {"s_SPDP": 350.0, "s_UnicastSPDP": 350.0, "s_SEDP": 400.0, "s_Heartbeat": 52.0, "s_ACKNACK": 50.0, "H_UDP": 64.0},
              "burst": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_ACKNACK, s_Heartbeat, s_SEDP, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_ACKNACK + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Heartbeat + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SEDP + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_10*t_grid_uni)/rounded_9 + N_H*N_P*(5.83333333333333*O_multi + 5.83333333333333*rounded_0*t_grid_multi + 5.83333333333333*(O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(11.6666666666667*(O_agg + rounded_8*t_grid_uni)/rounded_7 + 4*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 4*(O_agg + rounded_4*t_grid_uni)/rounded_3); },
              "steady": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_SPDP, s_UnicastSPDP, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_SPDP)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_SPDP + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_UnicastSPDP + 1/2) + 4))))/N_DBPS_uni)); return 0.666666666666667*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_4*t_grid_uni)/rounded_3 + N_H*N_P*(0.333333333333333*O_multi + 0.333333333333333*rounded_0*t_grid_multi + 0.333333333333333*(O_agg + rounded_2*t_grid_uni)/rounded_1); },
            },
          },
        },
      },
    },
    "Zenoh peer": {
      "color": "#56B4E9",
      "values": {"s_Scout": 16.0, "s_Hello": 80.0, "s_Declare": 100.0, "s_KeepAlive": 8.0, "H_UDP": 64.0, "H_TCP": 76.0},
      "messages": [
        {
          "name": "Scout",
          "phase": "Scouting",
          "cast": "multicast",
          "load": ({ N_H, N_P }) => { return 3.25*N_H*N_P; },
        },
        {
          "name": "Hello",
          "phase": "Scouting",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 3.25*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "Declare",
          "phase": "Declaration",
          "cast": "unicast",
          "load": ({ N_E, N_H, N_P }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
        {
          "name": "KeepAlive",
          "phase": "Declaration",
          "cast": "unicast",
          "load": ({ N_H, N_P }) => { return 0.4*N_H*Math.pow(N_P, 2)*(N_H - 1); },
        },
      ],
      "outlooks": {
        "Zenoh peer": {
          "lease": 10.0,
          "until": [
            [
              1.0,
              "within a second at best",
            ],
            [
              10.0,
              "slow at best",
            ],
            [
              Infinity,
              "leases at risk",
            ],
          ],
          "never": "never catches up",
        },
      },
      "models": {
        "linear": {
          "utilization": ({ H_TCP, H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Declare, s_Hello, s_KeepAlive, s_Scout }) => { const x0 = 1/R_uni; const x1 = 8*H_TCP; const x2 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x3 = 8*H_UDP; const x4 = 26.0*s_Scout + 3.25*x3; return N_E*x2*(2*O_uni + 2*x0*(8*s_Declare + x1)) + N_H*N_P*(3.25*O_multi + 3.25*O_uni + x0*x4 + x4/R_multi) + x2*(7.3*O_uni + 6.5*x0*(8*s_Hello + x3) + 0.8*x0*(8*s_KeepAlive + x1)); },
          "saturation": ({ H_TCP, H_UDP, N_E, N_P, O_multi, O_uni, R_multi, R_uni, U_limit, s_Declare, s_Hello, s_KeepAlive, s_Scout }) => { const x0 = 8*H_UDP; const x1 = 26.0*s_Scout + 3.25*x0; const x2 = 1/R_uni; const x3 = N_P*(3.25*O_multi + 3.25*O_uni + x1*x2 + x1/R_multi); const x4 = Math.pow(N_P, 2); const x5 = 7.3*O_uni; const x6 = 8*H_TCP; const x7 = N_E*x4*(2*O_uni + 2*x2*(8*s_Declare + x6)) + x3 + x4*(6.5*x2*(8*s_Hello + x0) + 0.8*x2*(8*s_KeepAlive + x6) + x5); return (2*U_limit - 2*x3)/(x7 + Math.sqrt(4*x4*(U_limit - x3)*(2*N_E*(O_uni + 8*x2*(H_TCP + s_Declare)) + x2*(6.4*H_TCP + 6.4*s_KeepAlive) + x2*(52.0*H_UDP + 52.0*s_Hello) + x5) + Math.pow(x7, 2))) + 1; },
          "costs": {
            "Scout": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Scout }) => { return 3.25*N_H*N_P*(O_uni + (8*H_UDP + 8*s_Scout)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_multi, R_multi, s_Scout }) => { return 3.25*N_H*N_P*(O_multi + (8*H_UDP + 8*s_Scout)/R_multi); },
              "both": ({ H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Scout }) => { const x0 = 8*H_UDP + 8*s_Scout; const x1 = 3.25*N_H*N_P; return x1*(O_multi + x0/R_multi) + x1*(O_uni + x0/R_uni); },
            },
            "Hello": {
              "up": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Hello }) => { return 3.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Hello)/R_uni); },
              "down": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Hello }) => { return 3.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Hello)/R_uni); },
              "both": ({ H_UDP, N_H, N_P, O_uni, R_uni, s_Hello }) => { return 6.5*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_UDP + 8*s_Hello)/R_uni); },
            },
            "Declare": {
              "up": ({ H_TCP, N_E, N_H, N_P, O_uni, R_uni, s_Declare }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_Declare)/R_uni); },
              "down": ({ H_TCP, N_E, N_H, N_P, O_uni, R_uni, s_Declare }) => { return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_Declare)/R_uni); },
              "both": ({ H_TCP, N_E, N_H, N_P, O_uni, R_uni, s_Declare }) => { return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_Declare)/R_uni); },
            },
            "KeepAlive": {
              "up": ({ H_TCP, N_H, N_P, O_uni, R_uni, s_KeepAlive }) => { return 0.4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_KeepAlive)/R_uni); },
              "down": ({ H_TCP, N_H, N_P, O_uni, R_uni, s_KeepAlive }) => { return 0.4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_KeepAlive)/R_uni); },
              "both": ({ H_TCP, N_H, N_P, O_uni, R_uni, s_KeepAlive }) => { return 0.8*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + (8*H_TCP + 8*s_KeepAlive)/R_uni); },
            },
          },
          "products": {
            "Zenoh peer": {
              "values": {"s_Scout": 16.0, "s_Hello": 80.0, "s_Declare": 100.0, "s_KeepAlive": 8.0, "H_UDP": 64.0, "H_TCP": 76.0},
              "burst": ({ H_TCP, H_UDP, N_E, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Declare, s_Hello, s_Scout }) => { const x0 = 1/R_uni; const x1 = 8*H_UDP; const x2 = N_H*Math.pow(N_P, 2)*(N_H - 1); const x3 = 25.0*s_Scout + 3.125*x1; return N_E*x2*(2*O_uni + 2*x0*(8*H_TCP + 8*s_Declare)) + N_H*N_P*(3.125*O_multi + 3.125*O_uni + x0*x3 + x3/R_multi) + x2*(6.25*O_uni + 6.25*x0*(8*s_Hello + x1)); },
              "steady": ({ H_TCP, H_UDP, N_H, N_P, O_multi, O_uni, R_multi, R_uni, s_Hello, s_KeepAlive, s_Scout }) => { const x0 = 8*H_UDP; const x1 = 1.0*s_Scout + 0.125*x0; const x2 = 1/R_uni; return N_H*Math.pow(N_P, 2)*(N_H - 1)*(1.05*O_uni + 0.8*x2*(8*H_TCP + 8*s_KeepAlive) + 0.25*x2*(8*s_Hello + x0)) + N_H*N_P*(0.125*O_multi + 0.125*O_uni + x1*x2 + x1/R_multi); },
            },
          },
        },
        "padded": {
          "utilization": ({ H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Declare, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return N_E*x0*(2*O_uni + 2*rounded_4*t_grid_uni) + N_H*N_P*(3.25*O_multi + 3.25*O_uni + 3.25*rounded_0*t_grid_multi + 3.25*rounded_1*t_grid_uni) + x0*(7.3*O_uni + 6.5*rounded_2*t_grid_uni + 0.8*rounded_3*t_grid_uni); },
          "saturation": ({ H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_multi, O_uni, U_limit, k_multi, k_uni, s_Declare, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); const rounded_4 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); const x0 = N_P*(3.25*O_multi + 3.25*O_uni + 3.25*rounded_0*t_grid_multi + 3.25*rounded_1*t_grid_uni); const x1 = Math.pow(N_P, 2); const x2 = rounded_4*t_grid_uni; const x3 = 7.3*O_uni + 6.5*rounded_2*t_grid_uni + 0.8*rounded_3*t_grid_uni; const x4 = N_E*x1*(2*O_uni + 2*x2) + x0 + x1*x3; return (2*U_limit - 2*x0)/(x4 + Math.sqrt(4*x1*(U_limit - x0)*(2*N_E*(O_uni + x2) + x3) + Math.pow(x4, 2))) + 1; },
          "costs": {
            "Scout": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Scout, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); return 3.25*N_H*N_P*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_Scout, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); return 3.25*N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const x0 = 3.25*N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_uni + rounded_1*t_grid_uni); },
            },
            "Hello": {
              "up": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Hello, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); return 3.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Hello, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); return 3.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_Hello, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); return 6.5*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "Declare": {
              "up": ({ H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_Declare, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_Declare, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_uni, k_uni, s_Declare, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
            "KeepAlive": {
              "up": ({ H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); return 0.4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "down": ({ H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); return 0.4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
              "both": ({ H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_uni, k_uni, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); return 0.8*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_uni + rounded_0*t_grid_uni); },
            },
          },
          "products": {
            "Zenoh peer": {
              "values": {"s_Scout": 16.0, "s_Hello": 80.0, "s_Declare": 100.0, "s_KeepAlive": 8.0, "H_UDP": 64.0, "H_TCP": 76.0},
              "burst": ({ H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Declare, s_Hello, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_Declare)/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return N_E*x0*(2*O_uni + 2*rounded_3*t_grid_uni) + N_H*N_P*(3.125*O_multi + 3.125*O_uni + 3.125*rounded_0*t_grid_multi + 3.125*rounded_1*t_grid_uni) + x0*(6.25*O_uni + 6.25*rounded_2*t_grid_uni); },
              "steady": ({ H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_multi, O_uni, k_multi, k_uni, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Scout)/N_DBPS_uni)); const rounded_2 = Math.ceil(k_uni*Math.ceil((8*H_UDP + N_add_uni + 8*s_Hello)/N_DBPS_uni)); const rounded_3 = Math.ceil(k_uni*Math.ceil((8*H_TCP + N_add_uni + 8*s_KeepAlive)/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(1.05*O_uni + 0.25*rounded_2*t_grid_uni + 0.8*rounded_3*t_grid_uni) + N_H*N_P*(0.125*O_multi + 0.125*O_uni + 0.125*rounded_0*t_grid_multi + 0.125*rounded_1*t_grid_uni); },
            },
          },
        },
        "aggregated": {
          "utilization": ({ A_least, A_most, H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Declare, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_8*t_grid_uni)/rounded_7 + N_H*N_P*(3.25*O_multi + 3.25*rounded_0*t_grid_multi + 3.25*(O_agg + rounded_2*t_grid_uni)/rounded_1) + x0*(0.8*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 6.5*(O_agg + rounded_4*t_grid_uni)/rounded_3); },
          "saturation": ({ A_least, A_most, H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_P, N_add_multi, N_add_uni, O_agg, O_multi, U_limit, k_multi, k_uni, n_agg, s_Declare, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); const rounded_7 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_8 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); const rounded_9 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_KeepAlive + 2)) + 1)))); const rounded_10 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_KeepAlive + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_KeepAlive + 2)) + 1)))))/N_DBPS_uni)); const rounded_11 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Hello + 2)) + 1)))); const rounded_12 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Hello + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_UDP + s_Hello + 2)) + 1)))))/N_DBPS_uni)); const rounded_13 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_Declare + 2)) + 1)))); const rounded_14 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_Declare + 2)) + 1))*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*(Math.ceil((1/4)*(H_TCP + s_Declare + 2)) + 1)))))/N_DBPS_uni)); const x0 = N_P*(3.25*O_multi + 3.25*rounded_0*t_grid_multi + 3.25*(O_agg + rounded_2*t_grid_uni)/rounded_1); const x1 = Math.pow(N_P, 2); const x2 = 2*N_E; const x3 = x0 + x1*(0.8*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 6.5*(O_agg + rounded_4*t_grid_uni)/rounded_3) + x1*x2*(O_agg + rounded_8*t_grid_uni)/rounded_7; return (2*U_limit - 2*x0)/(x3 + Math.sqrt(4*x1*(U_limit - x0)*((0.8*O_agg + 0.8*rounded_10*t_grid_uni)/rounded_9 + x2*(O_agg + rounded_14*t_grid_uni)/rounded_13 + (6.5*O_agg + 6.5*rounded_12*t_grid_uni)/rounded_11) + Math.pow(x3, 2))) + 1; },
          "costs": {
            "Scout": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Scout, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); return 3.25*N_H*N_P*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ H_UDP, N_DBPS_multi, N_H, N_P, N_add_multi, O_multi, k_multi, s_Scout, t_grid_multi }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); return 3.25*N_H*N_P*(O_multi + rounded_0*t_grid_multi); },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const x0 = 3.25*N_H*N_P; return x0*(O_multi + rounded_0*t_grid_multi) + x0*(O_agg + rounded_2*t_grid_uni)/rounded_1; },
            },
            "Hello": {
              "up": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Hello, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); return 3.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Hello, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); return 3.25*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_UDP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Hello, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); return 6.5*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "Declare": {
              "up": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Declare, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Declare, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); return N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_E, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_Declare, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); return 2*N_E*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
            "KeepAlive": {
              "up": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); return 0.4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "down": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); return 0.4*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
              "both": ({ A_least, A_most, H_TCP, N_DBPS_uni, N_H, N_P, N_add_uni, O_agg, k_uni, n_agg, s_KeepAlive, t_grid_uni }) => { const rounded_0 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_1 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); return 0.8*N_H*Math.pow(N_P, 2)*(N_H - 1)*(O_agg + rounded_1*t_grid_uni)/rounded_0; },
            },
          },
          "products": {
            "Zenoh peer": {
              "values": {"s_Scout": 16.0, "s_Hello": 80.0, "s_Declare": 100.0, "s_KeepAlive": 8.0, "H_UDP": 64.0, "H_TCP": 76.0},
              "burst": ({ A_least, A_most, H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_E, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Declare, s_Hello, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_Declare + 1/2) + 4))))/N_DBPS_uni)); const x0 = N_H*Math.pow(N_P, 2)*(N_H - 1); return 2*N_E*x0*(O_agg + rounded_6*t_grid_uni)/rounded_5 + N_H*N_P*(3.125*O_multi + 3.125*rounded_0*t_grid_multi + 3.125*(O_agg + rounded_2*t_grid_uni)/rounded_1) + 6.25*x0*(O_agg + rounded_4*t_grid_uni)/rounded_3; },
              "steady": ({ A_least, A_most, H_TCP, H_UDP, N_DBPS_multi, N_DBPS_uni, N_H, N_P, N_add_multi, N_add_uni, O_agg, O_multi, k_multi, k_uni, n_agg, s_Hello, s_KeepAlive, s_Scout, t_grid_multi, t_grid_uni }) => { const rounded_0 = Math.ceil(k_multi*Math.ceil((8*H_UDP + N_add_multi + 8*s_Scout)/N_DBPS_multi)); const rounded_1 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))); const rounded_2 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Scout + 1/2) + 4))))/N_DBPS_uni)); const rounded_3 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))); const rounded_4 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_UDP + (1/4)*s_Hello + 1/2) + 4))))/N_DBPS_uni)); const rounded_5 = Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))); const rounded_6 = Math.ceil(k_uni*Math.ceil((N_add_uni + 8*Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4)*Math.min(n_agg, Math.floor(A_most/Math.max(A_least, 4*Math.ceil((1/4)*H_TCP + (1/4)*s_KeepAlive + 1/2) + 4))))/N_DBPS_uni)); return N_H*Math.pow(N_P, 2)*(N_H - 1)*(0.8*(O_agg + rounded_6*t_grid_uni)/rounded_5 + 0.25*(O_agg + rounded_4*t_grid_uni)/rounded_3) + N_H*N_P*(0.125*O_multi + 0.125*rounded_0*t_grid_multi + 0.125*(O_agg + rounded_2*t_grid_uni)/rounded_1); },
            },
          },
        },
      },
    },
  },
};
