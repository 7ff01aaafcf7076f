// SPDX-License-Identifier: BSD-3-Clause
// Forces along the string against measured depth, with what bounds them: yield and buckling load, make-up torque.
import { axisOf, curveOf, dropChart, makeChart, pointsOf, roundUp } from "./chart_base.js";
import { byId, make } from "./dom.js";
import { store } from "./store.js";
import { clockText, shownValue, unitOf } from "./units.js";

let panels = null;

export function buildString() {
  if (panels) Object.values(panels).forEach(dropChart);
  const box = make("div", { class: "panels" });
  byId("string").replaceChildren(make("p", { id: "string_summary", class: "faint" }), box);
  const force = unitOf("force").name, length = unitOf("length").name;
  panels = {
    tension: stringPanel(box, "Tension", `— tension, - - yield, ··· buckling [${force}]`, length,
      [curveOf("x", 1, { borderWidth: 2.5 }), curveOf("x", 2), curveOf("x", 3)]),
    torque: stringPanel(box, "Torque", `— torque, - - make-up torque [${unitOf("torque").name}]`, length,
      [curveOf("x", 1, { borderWidth: 2.5 }), curveOf("x", 2)]),
    side: stringPanel(box, "Side force", `side force per metre [${force}/m]`, length, [curveOf("x", 1, { borderWidth: 1.5 })]),
  };
}

function stringPanel(box, title, words, length, datasets) {
  const canvas = make("canvas", { "aria-label": title + " along the string" });
  box.append(make("div", { class: "panel" }, make("h2", { text: title }), make("div", { class: "canvas" }, canvas)));
  return makeChart(canvas, { x: axisOf({ title: words, beginAtZero: true }), y: axisOf({ reverse: true, title: `measured depth [${length}]` }) }, datasets);
}

export function drawString() {
  const string = store.string;
  byId("string").classList.toggle("empty", !string);
  if (!string || !panels) return;
  const depth = string.md.map((value) => shownValue("length", value)), points = (quantity,
    values) => pointsOf(values.map((value) => shownValue(quantity, value)), depth);
  fitTension(panels.tension, string);
  for (const panel of Object.values(panels)) Object.assign(panel.options.scales.y, { min: Math.min(0, ...depth), max: Math.max(...depth) });
  fillCurves(panels.tension, ["tension", "yield", "critical"].map((name) => points("force", string[name])));
  fillCurves(panels.torque, ["torque", "make_up"].map((name) => points("torque", string[name])));
  fillCurves(panels.side, [points("force", string.side)]);
  const unknown = string.make_up.every((value) => value === null) ? " The scene has no make-up torques." : "";
  byId("string_summary").textContent = `At ${clockText(string.t)}: simulated values along the string, not measurements. Tension is effective tension.${unknown}`;
}

/// The scale ends at the weakest pipe's yield load: that of collars is so much higher that the curve would be a line.
function fitTension(chart, string) {
  const yields = string.yield.filter((value) => value !== null), largest = Math.max(...string.tension.filter((value) => value !== null));
  chart.options.scales.x.max = yields.length ? roundUp(shownValue("force", 1.1 * Math.max(Math.min(...yields), largest))) : undefined;
}

function fillCurves(chart, curves) {
  curves.forEach((data, n) => { chart.data.datasets[n].data = data; });
  chart.update("none");
}
