// SPDX-License-Identifier: BSD-3-Clause
// Eight large numbers with their limits, set points and extremes of the last seconds.
import { byId, make, setText } from "./dom.js";
import { fieldOf, on, store } from "./store.js";
import { bigText, shownText, shownValue, unitOf } from "./units.js";

const NEAR = 0.9;        // share of a limit from which on a number is marked
const RECENT = 10;       // over which extremes are shown [s]
const OVER_PULL = -2e3;  // surface WOB below which the string is pulled [N]
const NEAR_DEPTH = 100;  // from the bit to where a weight was measured [m]
const WEIGHTS = [["up", "▲", "pick-up"], ["rotate", "●", "rotating"], ["down", "▼", "slack-off"]];
const cards = {};
let recent = [];

export function buildNumbers() {
  on("hello", build);
  on("state", show);
  document.addEventListener("units", () => store.state && show(store.state));
}

function build() {
  byId("numbers").replaceChildren(...store.hello.numbers.map(([name]) => {
    const parts = { label: make("span"), mark: make("span"), value: make("span", { class: "figure" }), unit: make("span", { class: "unit" }),
      bar: make("i"), set: make("b", { hidden: true }), marks: make("span"), left: make("span"), right: make("span"),
      weights: make("div", { class: "below", hidden: true }) };
    parts.card = make("div", { class: "number", id: "number_" + name }, make("div", { class: "label" }, parts.label, parts.mark),
      make("div", { class: "value" }, parts.value, parts.unit), make("div", { class: "bar" }, parts.bar, parts.set, parts.marks),
      make("div", { class: "below" }, parts.left, parts.right), parts.weights);
    cards[name] = parts;
    return parts.card;
  }));
  recent = [];
}

function show(state) {
  document.body.classList.toggle("stale", !state.status.heard && store.hello.live);
  if (!state.values) return;
  remember(state);
  for (const [name, second, label] of store.hello.numbers) showCard(name, second, label, state);
  showWeights(state);
}

function remember(state) {
  if (recent.length && (recent[0].run !== state.run || recent[recent.length - 1].t > state.t)) recent = [];
  recent.push({ t: state.t, run: state.run, values: state.values });
  while (recent[0].t < state.t - RECENT) recent.shift();
}

function extremesOf(name) {
  const low = recent.map((one) => one.values[name][1]).filter((value) => value !== null);
  const high = recent.map((one) => one.values[name][2]).filter((value) => value !== null);
  return low.length ? [Math.min(...low), Math.max(...high)] : null;
}

function showCard(name, second, label, state) {
  const parts = cards[name], field = fieldOf(name), value = state.values[name][0];
  const pulled = name === "wob" && value !== null && value < OVER_PULL;
  setText(parts.label, pulled ? "Over-pull" : field.label);
  setText(parts.value, value === null ? "–" : bigText(field.quantity, pulled ? -value : value));
  setText(parts.unit, unitOf(field.quantity).name);
  const limit = pulled ? yieldOf(value) : limitOf(name);
  showBar(parts, field, value, limit, pulled ? null : setPointOf(name, state));
  const extremes = extremesOf(name), ends = extremes && pulled ? [-extremes[1], -extremes[0]] : extremes;
  setText(parts.left, pulled && store.margin ? marginText(field.quantity) : ends && value !== null && !second ? `${bigText(field.quantity, ends[0])} … ${bigText(field.quantity, ends[1])}` : secondText(second, label, state));
  if (pulled) showPulled(parts);
  setText(parts.right, limit && !pulled ? "max " + shownText(field.quantity, limit, 0) : "");
}

/// The over-pull at which the weakest pipe yields; null where it is not known.
function yieldOf(value) {
  return store.margin && store.margin.pull_to_yield > 0 ? store.margin.pull_to_yield - value : null;
}

/// A pulled string is a caution at least.
function showPulled(parts) {
  if (parts.card.classList.contains("beyond")) return;
  parts.card.classList.add("near");
  if (!parts.mark.textContent) setText(parts.mark, "△");
}

/// Beside an over-pull: the further pull at which the weakest pipe yields.
function marginText(quantity) {
  const margin = store.margin.pull_to_yield;
  return margin > 0 ? `${shownText(quantity, margin, 0)} to yield` : "beyond yield";
}

/// Pick-up, rotating and slack-off weights that were measured last near this depth: marks of the hook load, and their numbers.
function showWeights(state) {
  const points = store.weights ? store.weights.points : [], parts = cards.hook_load, depth = state.values.bit_depth[0];
  const shown = WEIGHTS.flatMap(([motion, sign, name]) => {
    const last = points.filter((one) => one.motion === motion && Math.abs(one.depth - depth) <= NEAR_DEPTH).pop();
    return last ? [{ sign, name, ...last }] : [];
  });
  const whole = limitOf("hook_load") || fieldOf("hook_load").scale[1];
  parts.marks.replaceChildren(...shown.map((one) => make("u", { text: one.sign, style: `left: ${100 * Math.min(one.load / whole, 1)}%` })));
  parts.card.classList.toggle("weighed", shown.length > 0);
  parts.weights.hidden = shown.length === 0;
  parts.weights.title = shown.map((one) => `${one.sign} ${one.name} weight ${shownText("force", one.load)} ${unitOf("force").name} at ${shownText("length", one.depth)} ${unitOf("length").name}`).join("\n");
  parts.weights.replaceChildren(...shown.map((one) => make("span", { text: `${one.sign} ${shownText("force", one.load, Math.abs(shownValue("force", one.load)) < 100 ? 1 : 0)}` })));
}

function secondText(second, label, state) {
  if (!second) return "";
  const field = fieldOf(second);
  return `${label} ${bigText(field.quantity, state.values[second][0])} ${unitOf(field.quantity).name}`;
}

function showBar(parts, field, value, limit, set) {
  const whole = limit || field.scale[1], share = (number) => 100 * Math.min(Math.max(number / whole, 0), 1) + "%";
  parts.bar.style.width = value === null ? "0" : share(Math.abs(value));
  parts.set.hidden = set === null;
  if (set !== null) parts.set.style.left = share(Math.abs(set));
  const near = limit && value !== null && Math.abs(value) >= NEAR * limit, beyond = limit && value !== null && Math.abs(value) >= limit * 0.999;
  parts.card.classList.toggle("near", Boolean(near && !beyond));
  parts.card.classList.toggle("beyond", Boolean(beyond));
  setText(parts.mark, beyond ? "▲ limit" : near ? "△ near limit" : set === null ? "" : "set " + bigText(field.quantity, set));
}

/// Of rig_limits; null where the rig has none.
function limitOf(name) {
  if (!store.limits) return null;
  const limit = name === "torque" && store.state.torque_limit > 0 ? Math.min(store.state.torque_limit, store.limits.torque) : store.limits[name];
  return limit > 0 ? limit : null;
}

/// In force; null where there is none.
function setPointOf(name, state) {
  if (name === "rpm") return state.mode === "SPEED" || state.mode === "SOFT_TORQUE" || state.mode === "Z_TORQUE" ? state.rpm : null;
  if (name === "flow") return state.flow === undefined ? null : state.flow;
  const law = store.law && store.law.running ? store.law.settings : {};
  return { wob: law.weight, rop: law.rop }[name] === undefined ? null : { wob: law.weight, rop: law.rop }[name];
}
