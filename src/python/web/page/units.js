// SPDX-License-Identifier: BSD-3-Clause
// Numbers as they are shown, in the system of units that was chosen; everything else is in SI.
import { store } from "./store.js";

const BIG_DIGITS = { length: 2, torque: 2 };  // of large numbers; others have one, or none where the unit has none
let chosen = null;

export function systemOfUnits() {
  return chosen || store.hello.system;
}

export function chooseSystem(name) {
  chosen = name;
  document.dispatchEvent(new Event("units"));
}

export function unitOf(quantity) {
  return store.hello.units[quantity][store.hello.systems.indexOf(systemOfUnits())];
}

export function shownValue(quantity, si) {
  return si === null || si === undefined ? null : si * unitOf(quantity).per_si + unitOf(quantity).zero;
}

export function siValue(quantity, value) {
  return (value - unitOf(quantity).zero) / unitOf(quantity).per_si;
}

export function shownText(quantity, si, digits = unitOf(quantity).digits) {
  const value = shownValue(quantity, si);
  if (value === null || !Number.isFinite(value)) return "–";
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

export function bigText(quantity, si) {
  return shownText(quantity, si, Math.min(unitOf(quantity).digits, BIG_DIGITS[quantity] || 1));
}

/// Seconds as 1:02:03.
export function clockText(seconds) {
  if (seconds === null || seconds === undefined) return "–";
  if (seconds < 0) return "-" + clockText(-seconds);
  const whole = Math.floor(seconds + 1e-6), two = (n) => String(n).padStart(2, "0");
  return `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
}
