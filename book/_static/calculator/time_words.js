// Times and shares in the words of a plan, as discostorm.wording and discostorm_planner.answer_text have them.
"use strict";

const TimeWords = (({ times: UNITS }) => {
  const SPACE = "\u00a0"; // no line ends between a number and its unit

  /** A time to two or three digits, as discostorm.wording.duration has it. */
  function longTime(time) {
    if (time === 0 || time === Infinity) return time ? "indefinitely" : "no time";
    const [, length, unit] = UNITS.findLast(([least]) => time >= least);
    const value = time / length;
    if (value >= 1e6) return `${value.toExponential(0)}${SPACE}${unit}`;
    if (length < 1) return `${Number(value.toPrecision(3))}${SPACE}${unit}`;
    if (length === 1) return `${value.toFixed(value < 10 ? 2 : 1)}${SPACE}${unit}`;
    return `${value < 10 ? value.toFixed(1) : Number(value.toPrecision(3)).toLocaleString("en-US")}${SPACE}${unit}`;
  }

  /** A time to two digits; whole targets as they are. */
  function seconds(time) {
    if (time > 0 && time < 0.1) return `${Number((1000 * time).toPrecision(2))}${SPACE}ms`;
    if (time < 0.1 || time >= 100) return longTime(time);
    return `${Number.isInteger(time) ? time : Number(time.toPrecision(2))}${SPACE}s`;
  }

  function share(part) {
    if (part >= 0.995 && part < 1) return "more than 99%";
    if (part > 0 && part < 0.01) return "less than 1%";
    return `${(100 * part).toFixed(0)}%`;
  }

  return { SPACE, longTime, seconds, share };
})(DISCOSTORM);
