// SPDX-License-Identifier: BSD-3-Clause
// Sheets as tables: tally and connections, slides, the log of alarms.
import { byId, fillTable, make } from "./dom.js";
import { store } from "./store.js";
import { clockText, shownText, systemOfUnits, unitOf } from "./units.js";

const DIAMETER = { si: { name: "mm", per_si: 1e3, digits: 1 }, oilfield: { name: "in", per_si: 1 / 0.0254, digits: 3 } };
const named = (text, quantity) => `${text} [${unitOf(quantity).name}]`;

export function drawTally() {
  const box = byId("tally"), parts = store.parts ? store.parts.parts : [], connections = store.sheets ? store.sheets.connections : [];
  const bars = make("div", { class: "bars" }), table = make("table", { id: "connections" }), tally = make("table", { id: "parts" });
  fillTable(table, ["connection", "time", named("depth", "length"), "in slips", "weight to weight", ""],
    connections.map((one) => connectionRow(one, connections)));
  fillTable(tally, ["part, bit first", named("length", "length"), `outer [${DIAMETER[systemOfUnits()].name}]`,
    `inner [${DIAMETER[systemOfUnits()].name}]`, named("from bit", "length")], tallyRows(parts));
  box.replaceChildren(make("div", { class: "scroll" }, make("h2", { text: connections.length ? "Connections" : "Connections: none yet" }), bars,
    connections.length ? table : "",
    ...(parts.length ? [make("h2", { text: `Tally: ${store.state && store.state.stand_count !== undefined ? store.state.stand_count + " stands of drill pipe" : ""}` }), tally] : [])));
}

function connectionRow(one, all) {
  const longest = Math.max(...all.map((other) => other.weight_to_weight || other.in_slips));
  const bar = (seconds, kind) => make("i", { class: "span", style: `display: inline-block; height: .8rem; width: ${(10 * seconds / longest).toFixed(2)}rem; background: var(--${kind})` });
  const bars = make("span", { style: "display: inline-block; width: 10rem; text-align: left; white-space: nowrap" }, bar(one.in_slips, "connection"),
    ...(one.weight_to_weight ? [bar(one.weight_to_weight - one.in_slips, "circulate")] : []));
  return [String(one.number), clockText(one.time), shownText("length", one.depth), one.in_slips.toFixed(0) + " s",
    one.weight_to_weight === null ? "–" : one.weight_to_weight.toFixed(0) + " s", bars];
}

function tallyRows(parts) {
  const { per_si, digits } = DIAMETER[systemOfUnits()];
  let above = 0;
  return parts.map((part) => {
    above = part.length > 0 ? above + part.length : null;
    return [part.name, part.length > 0 ? shownText("length", part.length) : "to surface", (per_si * part.diameter).toFixed(digits),
      (per_si * part.bore).toFixed(digits), shownText("length", above)];
  });
}

export function drawSlides() {
  const box = byId("slides"), rows = store.sheets ? store.sheets.slides : [], table = make("table", { id: "slide_table" });
  box.classList.toggle("empty", rows.length === 0);
  if (!rows.length) {
    box.replaceChildren(make("p", { class: "nothing", text: "Nothing has been drilled yet." }));
    return;
  }
  const heads = ["mode", named("from", "length"), named("to", "length"), named("length", "length"), "time", named("ROP", "penetration"),
    named("WOB", "force"), named("diff. pressure", "pressure")];
  fillTable(table, heads, rows.map((row) => [row.kind, shownText("length", row.depth_from), shownText("length", row.depth_to),
    shownText("length", row.depth_to - row.depth_from),
    clockText(row.seconds), shownText("penetration", row.rop), shownText("force", row.wob), shownText("pressure", row.differential)]));
  const slid = rows.filter((row) => row.kind === "slide").reduce((sum, row) => sum + row.depth_to - row.depth_from, 0);
  const all = rows.reduce((sum, row) => sum + row.depth_to - row.depth_from, 0);
  const text = `${shownText("length", slid)} of ${shownText("length", all)} ${unitOf("length").name} drilled by sliding (${(100 * slid / (all || 1)).toFixed(0)} %).`;
  box.replaceChildren(make("div", { class: "scroll" }, make("p", { class: "faint", text }), table));
}

export function drawAlarmLog() {
  const entries = store.alarms ? store.alarms.entries : [], table = make("table", { id: "alarm_table" });
  byId("alarm_log").classList.toggle("empty", entries.length === 0);
  if (!entries.length) {
    byId("alarm_log").replaceChildren(make("p", { class: "nothing", text: "No alarm yet." }));
    return;
  }
  fillTable(table, ["alarm", "from", "to", "times", ""], entries.map((one) => [(one.rank === "red" ? "▲ " : "△ ") + one.text, clockText(one.from),
    one.to === null ? "active" : clockText(one.to),
    String(one.times), one.rank === "red" ? (one.acknowledged ? "acknowledged" : "not acknowledged") : ""]));
  byId("alarm_log").replaceChildren(make("div", { class: "scroll" }, table));
}
