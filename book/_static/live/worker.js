// In the worker: runs, one at a time, told of share by share.
"use strict";

function liveWorker() {
  let Run = null;

  // Go on with a run until it is over, or until discovery is complete if no more is wanted. A share
  // has some looks, after so many steps each, at what the run is at; one that is traced takes single steps.
  function simulate({ setting, steps, looks, until, log, trace }) {
    const stations = setting.fleet.groups.reduce((total, { hosts }) => total + hosts, 1);
    // In one step no station sends twice, so that what a share sends fits in the log.
    const run = new Run(log ? { ...setting, log: steps * looks * stations } : setting);
    for (let over = false; !over; ) {
      const states = [];
      const traced = [];
      while (!over && states.length < looks) {
        over = run.go(trace ? 1 : steps) || (until === "complete" && run.now("converged") > 0);
        if (trace) traced.push(...run.traced());
        states.push({ ...run.state(), rows: log ? run.now("logged") : 0 });
      }
      const rows = log ? run.sent() : Float64Array.from(traced);
      postMessage({ ...states.at(-1), over, rows, states, ...(over && { result: run.result() }) }, [rows.buffer]);
    }
  }

  onmessage = async ({ data }) => {
    try {
      if (data.engine) {
        Run = liveRun(await WebAssembly.compile(data.engine), data.tables);
        postMessage({ ready: true });
      } else {
        simulate(data);
      }
    } catch (error) {
      postMessage({ error: error.message });
    }
  };
}
