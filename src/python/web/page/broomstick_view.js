// SPDX-License-Identifier: BSD-3-Clause
// The broomstick chart: hook load over depth by theory, and the weights that the run has shown on it.
import { axisOf, curveOf, dropChart, makeChart } from "./chart_base.js";
import { byId, make, setText } from "./dom.js";
import { send } from "./link.js";
import { store } from "./store.js";
import { shownText, shownValue, unitOf } from "./units.js";

const MOTIONS = [["up", 2, "triangle", 0], ["rotate", 3, "circle", 0], ["down", 1, "triangle", 180]];  // motion, style, sign and its rotation
let chart = null;

export function buildBroomstick() {
  if (chart) dropChart(chart);
  const canvas = make("canvas", { "aria-label": "broomstick chart" });
  byId("broomstick").replaceChildren(
    make("div", { class: "row" }, make("button", { id: "work_out", class: "primary", hidden: Boolean(byId("run")), text: "Compute", onclick: () => send({ type: "broomstick" }) }),
      make("span", { id: "broomstick_status", class: "faint" })),
    make("div", { class: "canvas" }, canvas));
  chart = makeChart(canvas, {
    x: axisOf({ title: `hook load of the gauge [${unitOf("force").name}]` }),
    y: axisOf({ reverse: true, title: `bit depth [${unitOf("length").name}]`, min: 0 }),
  }, []);
}

export function drawBroomstick() {
  if (!chart) return;
  const theory = store.broomstick || { points: [] }, measured = store.weights ? store.weights.points : [];
  chart.data.datasets = [...curves(theory.points), ...MOTIONS.map(([motion, style, pointStyle, rotation]) => curveOf("x", style, {
    showLine: false, pointRadius: 6, pointStyle, rotation, borderWidth: 2, data: measured.filter((one) => one.motion === motion).map(pointOf),
  }))];
  chart.update("none");
  setText(byId("broomstick_status"), statusText(theory, measured));
  byId("work_out").disabled = Boolean(theory.running);
  byId("broomstick").classList.toggle("empty", !theory.points.length && !measured.length);
}

function pointOf(one) {
  return { x: one.load === null ? NaN : shownValue("force", one.load), y: shownValue("length", one.depth) };
}

/// One for each motion and friction; the scene's own friction thick.
function curves(points) {
  const factors = [...new Set(points.map((one) => one.factor))];
  return MOTIONS.flatMap(([motion, style]) => factors.map((factor) => curveOf("x", style, {
    borderWidth: factor === 1 ? 2.5 : 1, borderDash: factor < 1 ? [2, 3] : factor > 1 ? [7, 3] : [],
    data: points.filter((one) => one.motion === motion && one.factor === factor).sort((a, b) => a.depth - b.depth).map(pointOf),
  })));
}

function statusText(theory, measured) {
  const keys = "Orange: pick-up. Green: rotating. Blue: slack-off. Thick: friction of the scene. Dotted: 0.5 times. Dashed: 1.5 times.";
  const failed = theory.points.filter((one) => one.load === null);
  const state = theory.problem || (theory.running ? `${theory.points.length} of ${theory.count} points` : theory.points.length ? "" : "Not computed yet.");
  return [state, failed.length ? `${failed.length} points could not be computed: ${failed[0].why}.` : "", `${measured.length} measured weights (▲ ● ▼).`,
    theory.points.length ? keys + wayText(theory.ways) : ""].join(" ");
}

/// With what drag of the mud the curves are computed.
function wayText(ways) {
  const speeds = ["up", "down"].filter((motion) => ways[motion]).map((motion) => `${shownText("speed", Math.abs(ways[motion].speed))} ${unitOf("speed").name} ${motion}`);
  return speeds.length ? ` With the drag of the mud at ${speeds.join(" and ")}, as in the measured weights.` : " Without drag of the mud: no pick-up or slack-off weight was measured.";
}
