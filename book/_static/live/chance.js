// The random numbers of a run: NumPy's SeedSequence and PCG64, as far as runs draw from them.
// Each file is one function, as a worker on a page from file:// can only be made from text.
"use strict";

function liveChance() {
  const [LOW64, LOW128] = [(1n << 64n) - 1n, (1n << 128n) - 1n];
  const WORDS = 4; // of 32 bits, in the pool of a sequence

  function words(number) {
    const found = [];
    let rest = BigInt(number);
    do {
      found.push(Number(rest & 0xffffffffn));
      rest >>= 32n;
    } while (rest);
    return found;
  }

  // Return the pool of a sequence: of a seed, and of the numbers by which it was spawned.
  function pool(seed, key) {
    const given = words(seed);
    while (key.length && given.length < WORDS) given.push(0);
    given.push(...key.flatMap(words));
    let multiplier = 0x43b0d7e5;
    const hash = (value) => {
      value ^= multiplier;
      multiplier = Math.imul(multiplier, 0x931e8875);
      value = Math.imul(value, multiplier);
      return value ^ (value >>> 16);
    };
    const mix = (one, other) => {
      const mixed = (Math.imul(0xca01f9dd, one) - Math.imul(0x4973f715, other)) | 0;
      return mixed ^ (mixed >>> 16);
    };
    const found = Array.from({ length: WORDS }, (_, i) => hash(given[i] ?? 0));
    for (let from = 0; from < WORDS; from++) {
      for (let to = 0; to < WORDS; to++) if (from !== to) found[to] = mix(found[to], hash(found[from]));
    }
    for (const more of given.slice(WORDS)) found.forEach((one, i) => (found[i] = mix(one, hash(more))));
    return found;
  }

  // Return so many numbers of 64 bits: SeedSequence(seed, spawn_key=key).generate_state(count, uint64).
  function state(seed, key, count) {
    const from = pool(seed, key);
    let multiplier = 0x8b51f9dd;
    const next = (i) => {
      let value = from[i % WORDS] ^ multiplier;
      multiplier = Math.imul(multiplier, 0x58f38ded);
      value = Math.imul(value, multiplier);
      return BigInt((value ^ (value >>> 16)) >>> 0);
    };
    return Array.from({ length: count }, (_, i) => next(2 * i) | (next(2 * i + 1) << 32n));
  }

  // Return a function that draws 32 bits: half of what PCG64 gives, the lower half first.
  function bits(seed, key) {
    const [high, low, highest, lowest] = state(seed, key, 4);
    const increment = ((((highest << 64n) | lowest) << 1n) | 1n) & LOW128;
    let at = 0n;
    const step = () => (at = (at * 0x2360ed051fc65da44385df649fccf645n + increment) & LOW128);
    step();
    at += (high << 64n) | low;
    step();
    let kept = null;
    return () => {
      if (kept !== null) {
        const half = kept;
        kept = null;
        return half;
      }
      step();
      const [folded, turn] = [(at >> 64n) ^ (at & LOW64), at >> 122n];
      const value = ((folded >> turn) | (folded << ((64n - turn) & 63n))) & LOW64;
      kept = Number(value >> 32n);
      return Number(value & 0xffffffffn);
    };
  }

  // Return a function that draws from 0 to 1, both halves of 64 bits at once: Generator.random().
  function fractions(seed, key) {
    const draw = bits(seed, key);
    return () => {
      const low = draw() >>> 11;
      return (draw() * 2 ** 21 + low) / 2 ** 53;
    };
  }

  return { state, bits, fractions };
}
