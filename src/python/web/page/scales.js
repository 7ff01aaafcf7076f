// SPDX-License-Identifier: BSD-3-Clause
// The scale of each signal: it holds its ends while the run stays within them and grows by round steps; a person may fix them.
import { roundUp, SLACK } from "./chart_base.js";
import { fieldOf, store } from "./store.js";
import { shownValue, siValue, systemOfUnits } from "./units.js";

const KEY = "drill_web_scales";
const fixed = JSON.parse(localStorage.getItem(KEY) || "{}");
let grown = {}, grownOf = null;

/// [least, largest] in shown units; `extremes` of the run in SI, or null.
export function scaleOf(name, quantity, usual, extremes) {
  if (fixed[name]) return fixed[name].map((si) => shownValue(quantity, si));
  const of = `${systemOfUnits()} ${store.run}`;
  if (grownOf !== of) {
    grown = {};
    grownOf = of;
  }
  const [low, high] = grown[name] || [0, roundUp(Math.abs(shownValue(quantity, usual[1])))];
  const least = extremes ? shownValue(quantity, extremes[0]) : 0, largest = extremes ? shownValue(quantity, extremes[1]) : 0;
  const slack = SLACK * high;
  grown[name] = [least < low - slack ? Math.max(-roundUp(-least), -0.5 * high) : low, largest > high ? roundUp(largest * 1.05) : high];
  return grown[name];
}

export function isFixed(name) {
  return Boolean(fixed[name]);
}

/// Fixes both ends, in shown units; null frees them.
export function fixScale(name, quantity, ends) {
  if (ends === null) delete fixed[name];
  else fixed[name] = ends.map((value) => siValue(quantity, value));
  localStorage.setItem(KEY, JSON.stringify(fixed));
}

/// A field of the hello message, or of the depth log.
export function usualScale(name) {
  const field = fieldOf(name);
  return field ? field.scale : [0, 1e8];
}
