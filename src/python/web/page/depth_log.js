// SPDX-License-Identifier: BSD-3-Clause
// The depth log: what was seen while new hole was made, downwards by measured depth.
import { axisOf, curveOf, dropChart, makeChart, pointsOf, trackAxis } from "./chart_base.js";
import { byId, colour, make } from "./dom.js";
import { scaleOf, usualScale } from "./scales.js";
import { fieldOf, store } from "./store.js";
import { trackHead } from "./track_head.js";
import { shownText, shownValue, unitOf } from "./units.js";

const MOST_ROWS = 400;
const LEAST_SPAN = 2;  // of the depth that is shown [m]
let tracks = [];

export function buildDepthLog() {
  for (const track of tracks) dropChart(track.chart);
  const grid = make("div", { class: "tracks" });
  byId("depth_log").replaceChildren(grid);
  tracks = store.hello.depth_tracks.map(([name, label], n) => buildDepthTrack(grid, name, label, n));
}

function quantityOf(name) {
  const field = fieldOf(name);
  return field ? field.quantity : "specific_energy";
}

function buildDepthTrack(grid, name, label, n) {
  const head = trackHead("depth_" + name, label, quantityOf(name), 1 + n % 4, drawDepthLog);
  const canvas = make("canvas", { "aria-label": label + " against depth" });
  grid.append(make("div", { class: "track" }, make("div", { class: "heads" }, head), make("div", { class: "canvas" }, canvas)));
  const y = axisOf({ reverse: true, title: n === 0 ? "hole depth" : "", ticks: n === 0 ? {} : { display: false } });
  const chart = makeChart(canvas, { y, x: trackAxis() }, [curveOf("x", 1 + n % 4)], "y");
  chart.bandAlpha = 0.18;
  return { name, head, chart, first: n === 0 };
}

export function drawDepthLog() {
  const log = store.depth, to = Math.max(log.end, log.begin + LEAST_SPAN);
  byId("depth_log").classList.toggle("empty", log.first === null);
  for (const track of tracks) drawDepthTrack(track, log, log.begin, to);
}

function drawDepthTrack({ name, head, chart, first }, log, from, to) {
  const quantity = quantityOf(name), rows = log.rows(name, from, to,
    MOST_ROWS), inUnits = (values) => values.map((value) => shownValue(quantity, value));
  const [low, high] = scaleOf("depth_" + name, quantity, usualScale(name), log.extremes(name, from, to)), length = unitOf("length");
  Object.assign(chart.options.scales.x, { min: low, max: high });
  Object.assign(chart.options.scales.y, { min: from * length.per_si, max: to * length.per_si });
  if (first) chart.options.scales.y.title.text = `hole depth [${length.name}], ${shownText("length", log.end - log.begin)} ${length.name} drilled`;
  chart.bands = slideBands().map((band) => ({ ...band, from: band.from * length.per_si, to: band.to * length.per_si }));
  const dataset = chart.data.datasets[0], keys = rows.keys.map((key) => key * length.per_si);
  dataset.envelope = { keys, low: inUnits(rows.low), high: inUnits(rows.high) };
  dataset.data = pointsOf(inUnits(rows.mean), keys);
  head.show([low, high]);
  chart.update("none");
}

function slideBands() {
  return store.sheets ? store.sheets.slides.filter((row) => row.kind === "slide").map((row) => ({ from: row.depth_from, to: row.depth_to,
    colour: colour("slide") })) : [];
}
