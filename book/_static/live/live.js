// The simulator on a page: loaded when a reader first wants it; it runs in a worker.
//   const run = Live.run(setting, { each, steps, looks, until, log });
//   await run.found; run.stop();
"use strict";

const Live = (() => {
  const FILES = ["tables", "engine", "chance", "traffic", "pairs", "setup", "run", "worker"];
  const folder = document.currentScript.src.replace(/[^/]*$/, "");
  let loaded = null; // a promise
  let worker = null; // one that is ready, with nothing to do
  let current = null; // the run under way

  function script(name) {
    return new Promise((done, failed) => {
      const element = document.createElement("script");
      element.src = `${folder}${name}.js`;
      element.onload = done;
      element.onerror = () => failed(new Error(`${name}.js does not load. Reload the page.`));
      document.head.append(element);
    });
  }

  // Return, once all files are here, what runs are set up from: tables.js.
  function load() {
    loaded ??= Promise.all(FILES.map(script)).then(() => LIVE_TABLES);
    return loaded;
  }

  // Return the bytes of what is compressed (deflate) and written in base64.
  function unpacked(text) {
    const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return new Response(bytes).arrayBuffer();
  }

  // Return a worker that is ready. It is made from text: workers do not load from file://.
  async function started() {
    await load();
    const parts = [liveChance, liveTraffic, livePairs, liveSetup, liveRun, liveWorker];
    const address = URL.createObjectURL(new Blob([`"use strict";\n${parts.join("\n")}\nliveWorker();\n`]));
    const found = new Worker(address);
    const engine = await unpacked(LIVE_ENGINE);
    await new Promise((done, failed) => {
      found.onmessage = ({ data }) => (data.error ? failed(new Error(data.error)) : done());
      found.onerror = (event) => failed(new Error(event.message));
      found.postMessage({ engine, tables: LIVE_TABLES }, [engine]);
    });
    URL.revokeObjectURL(address);
    return found;
  }

  // Simulate a setting (setup.js lists its options); a run under way is stopped. `each` is called with
  // each share of the run: what it is at, and at each of some `looks` after `steps`. `until` "complete" ends
  // with discovery; with `log` shares have the rows of what was sent, and looks say how many of these were
  // before; with `trace`, for radios without aggregation, they also have what these carried (run.js). Return a promise of what was found, and a function that stops the run.
  function run(setting, { each = () => {}, steps = 100_000, looks = 1, until = "over", log = false, trace = false } = {}) {
    current?.stop();
    let stopped = false;
    let at = null; // the worker that has it
    const own = {};
    own.found = (async () => {
      at = worker ?? (await started());
      worker = null;
      if (stopped) {
        worker ??= at;
        return null;
      }
      return new Promise((done, failed) => {
        own.end = done;
        at.onerror = (event) => failed(new Error(event.message));
        at.onmessage = ({ data }) => {
          if (!data.error) each(data);
          if (!data.error && !data.over) return;
          [worker, current] = [at, null];
          if (data.error) failed(new Error(data.error));
          else done(data.result);
        };
        at.postMessage({ setting, steps, looks, until, log, trace });
      });
    })();
    own.stop = () => {
      if (stopped || current !== own) return;
      [stopped, current] = [true, null];
      if (own.end) at.terminate(); // it answers to nothing while it computes
      own.end?.(null);
    };
    current = own;
    return own;
  }

  return { load, run, unpacked };
})();
