// SPDX-License-Identifier: BSD-3-Clause
// The well: from above, in section through the target, and its deviation from plan against depth.
import { axisOf, curveOf, dropChart, makeChart, pointsOf } from "./chart_base.js";
import { byId, make } from "./dom.js";
import { store } from "./store.js";
import { shownText, shownValue, unitOf } from "./units.js";

let panels = null;

export function buildWell() {
  if (panels) Object.values(panels).forEach(dropChart);
  const box = make("div", { class: "panels" }), unit = unitOf("length").name;
  byId("well").replaceChildren(make("p", { id: "well_summary", class: "faint" }), box);
  const styles = () => [curveOf("x", 1, { borderWidth: 2.5 }), curveOf("x", 2),
    curveOf("x", 2, { showLine: false, pointRadius: 6, pointStyle: "rectRot" }),
    curveOf("x", 1, { showLine: false, pointRadius: 5, pointStyle: "triangle" })];
  const inner = { includeBounds: false };
  const down = { reverse: true, title: `true vertical depth [${unit}]` };
  panels = { plan: panelOf(box, "Plan view", axisOf({ title: `east [${unit}]`, ticks: inner }), axisOf({ title: `north [${unit}]`, ticks: inner }), styles()),
    section: panelOf(box, "Section", axisOf({ title: `along section [${unit}]` }), axisOf(down), styles()),
    deviation: panelOf(box, "Deviation from plan", axisOf({ title: `[${unit}]` }), axisOf({ reverse: true, title: `measured depth [${unit}]` }),
      [curveOf("x", 1, { borderWidth: 2.5 }), curveOf("x", 2), curveOf("x", 3)]) };
}

function panelOf(box, title, x, y, datasets) {
  const canvas = make("canvas", { "aria-label": title });
  box.append(make("div", { class: "panel" }, make("h2", { text: title }), make("div", { class: "canvas" }, canvas)));
  return makeChart(canvas, { x, y }, datasets);
}

export function drawWell() {
  const well = store.well;
  byId("well").classList.toggle("empty", !well);
  if (!well || !panels) return;
  const inUnits = (values) => values.map((value) => shownValue("length", value));
  drawPaths(panels.plan, well, (table) => pointsOf(inUnits(table.east), inUnits(table.north)), true);
  drawPaths(panels.section, well, (table) => pointsOf(inUnits(table.section), inUnits(table.depth)), false);
  const away = well.deviation;
  ["distance", "right", "up"].forEach((name, n) => {
    panels.deviation.data.datasets[n].data = away ? pointsOf(inUnits(away[name]), inUnits(away.depth)) : [];
  });
  panels.deviation.update("none");
  byId("well_summary").textContent = summary(well);
}

function drawPaths(chart, well, points, square) {
  const path = points(well.path), plan = points(well.plan);
  [path, plan, plan.slice(-1), path.slice(-1)].forEach((data, n) => { chart.data.datasets[n].data = data; });
  if (square) fitSquare(chart, [...path, ...plan]);
  chart.update("none");
}

/// Both axes of a map show the same length.
function fitSquare(chart, points) {
  if (!points.length) return;
  const ends = (values) => [Math.min(...values), Math.max(...values)];
  const [left, right] = ends(points.map((p) => p.x)), [bottom, top] = ends(points.map((p) => p.y)), half = 0.55 * Math.max(right - left,
    top - bottom, 2);
  const ratio = chart.chartArea && chart.chartArea.height ? chart.chartArea.width / chart.chartArea.height : 1;
  Object.assign(chart.options.scales.x, { min: 0.5 * (left + right) - half * Math.max(ratio, 1),
    max: 0.5 * (left + right) + half * Math.max(ratio, 1) });
  Object.assign(chart.options.scales.y, { min: 0.5 * (bottom + top) - half * Math.max(1 / ratio, 1),
    max: 0.5 * (bottom + top) + half * Math.max(1 / ratio, 1) });
}

function summary(well) {
  const keys = "— drilled, ▲ bit; - - plan, ◆ target.";
  if (!well.deviation) return keys + " No plan.";
  const known = well.deviation.distance.map((value, n) => [value, n]).filter(([value]) => value !== null);
  if (!known.length) return keys;
  const [value, n] = known[known.length - 1], unit = unitOf("length").name;
  const side = (name, positive, negative) => `${shownText("length", Math.abs(well.deviation[name][n]))} ${unit} ${well.deviation[name][n] >= 0 ? positive : negative}`;
  const end = n === well.deviation.distance.length - 1 ? "At the end of the hole" : `At ${shownText("length", well.deviation.depth[n])} ${unit}, where the plan ends,`;
  return `${keys} ${end} the well is ${shownText("length", value)} ${unit} off plan: ${side("right", "right", "left")}, ${side("up", "high", "low")}. ` +
    "Deviation: — distance, - - right (+), ··· high (+).";
}
