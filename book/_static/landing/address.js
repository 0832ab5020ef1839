// What a reader has chosen on the first page, in its address: #robots=12&middleware=Fast+DDS&ladder=measured
"use strict";

const Address = (() => {
  const NAMES = ["robots", "middleware", "compare", "aggregation", "seed", "ladder"];
  const WAIT = 200; // browsers take a limited number of changes [ms]
  let chosen = new Map();
  let writing;
  let shown; // the address that was last read or written

  // Take what the address says; return whether it says anything: it may name a place on the page instead.
  function read() {
    const parts = new URLSearchParams(location.hash.slice(1));
    if (!NAMES.some((name) => parts.has(name))) return false;
    clearTimeout(writing);
    chosen = new Map(NAMES.filter((name) => parts.has(name)).map((name) => [name, parts.get(name)]));
    return true;
  }

  // Change some of it; what is null is left out.
  function write(changes) {
    for (const [name, value] of Object.entries(changes)) {
      if (value === null) chosen.delete(name);
      else chosen.set(name, String(value));
    }
    clearTimeout(writing);
    writing = setTimeout(() => {
      if (location.hash !== shown) return; // a link was opened meanwhile: the page is about to read it
      const parts = new URLSearchParams(NAMES.filter((name) => chosen.has(name)).map((name) => [name, chosen.get(name)]));
      history.replaceState(null, "", chosen.size ? `#${parts}` : location.pathname + location.search);
      shown = location.hash;
    }, WAIT);
  }

  // Call back now, and whenever the address says something else.
  const followers = [];
  function follow(callback) {
    followers.push(callback);
    callback();
  }

  read();
  shown = location.hash;
  addEventListener("hashchange", () => {
    shown = location.hash;
    if (read()) for (const callback of followers) callback();
  });
  return { get: (name) => chosen.get(name) ?? null, write, follow };
})();
