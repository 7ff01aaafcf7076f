// SPDX-License-Identifier: BSD-3-Clause
// The time log, downwards: tracks with fixed scales, and a bar of what the rig does.
import { axisOf, curveOf, dropChart, gridOnly, makeChart, pointsOf, trackAxis } from "./chart_base.js";
import { byId, colour, make } from "./dom.js";
import { scaleOf } from "./scales.js";
import { store } from "./store.js";
import { trackHead } from "./track_head.js";
import { clockText, shownValue } from "./units.js";

const SPANS = [[60, "1 min"], [300, "5 min"], [1800, "30 min"], [7200, "2 h"], [0, "whole run"]];
const MOST_ROWS = 500;
const KINDS = ["rotary", "slide", "connection", "trip", "circulate", "other"];
const USUAL_SPAN = 300;  // [s]
let span = null, until = null, tracks = [], bar = null;

export function buildTimeLog() {
  if (span === null) span = store.hello.live ? USUAL_SPAN : 0;  // of a recorded run all
  dropAll();
  const box = byId("time_log"), spans = make("select", { id: "span", "aria-label": "time shown", onchange: () => chooseSpan(Number(spans.value)) },
    ...SPANS.map(([seconds, text]) => make("option", { value: seconds, text, selected: seconds === span })));
  const grid = make("div", { class: "tracks timed" });
  box.replaceChildren(make("div", { class: "row tools" }, spans,
    make("button", { id: "hold_log", text: "Hold", title: "stops the scrolling; recording continues", onclick: holdLog }),
    make("button", { text: "▲ earlier", onclick: () => move(-0.5) }), make("button",
      { text: "▼ later", onclick: () => move(0.5) }), ...keys()), grid);
  const clock = trackBox(grid, []);
  tracks.push({ chart: makeChart(clock.canvas, { x: trackAxis(false), y: timeAxis(true) }, [curveOf("x", 1)], "y"), curves: [] });
  bar = trackBox(grid, []);
  bar.chart = makeChart(bar.canvas, { x: trackAxis(false), y: timeAxis(false) }, [curveOf("x", 1)], "y");
  for (const [track, label] of store.hello.tracks) buildTrack(grid, track, label);
}

function dropAll() {
  for (const track of tracks) dropChart(track.chart);
  if (bar) dropChart(bar.chart);
  tracks = [];
  bar = null;
}

function keys() {
  return [make("span", { class: "keys" }, ...KINDS.map((kind) => make("span", {},
    make("i", { class: "key", style: `background: var(--${kind})` }), kind)))];
}

function timeAxis(display) {
  return axisOf({ reverse: true, display, min: 0, max: 1, ticks: { callback: (time) => (time < store.time.begin - 1 ? "" : clockText(time)), maxTicksLimit: 12, autoSkip: true },
    afterFit: display ? (axis) => { axis.width = Math.max(axis.width, 58); } : undefined });
}

function trackBox(grid, heads) {
  const canvas = make("canvas");
  grid.append(make("div", { class: "track" }, make("div", { class: "heads" }, ...heads), make("div", { class: "canvas" }, canvas)));
  return { canvas };
}

function buildTrack(grid, track, label) {
  const fields = store.hello.fields.filter((field) => field.track === track);
  const curves = fields.map((field, n) => ({ field, head: trackHead(field.name, field.label, field.quantity, n + 1, drawTimeLog) }));
  const { canvas } = trackBox(grid, curves.map((curve) => curve.head));
  canvas.setAttribute("aria-label", label + " against time");
  const scales = { y: { ...timeAxis(false), display: true, ticks: { display: false }, grid: gridOnly() } };
  fields.forEach((field, n) => { scales["x" + n] = trackAxis(n === 0); });
  const chart = makeChart(canvas, scales, fields.map((field, n) => curveOf("x" + n, n + 1)), "y");
  chart.bandAlpha = 0.18;
  tracks.push({ curves, chart });
}

function chooseSpan(seconds) {
  span = seconds;
  drawTimeLog();
}

function holdLog() {
  until = until === null ? store.time.end : null;
  byId("hold_log").setAttribute("aria-pressed", String(until !== null));
  drawTimeLog();
}

function move(share) {
  const length = span || store.time.end - store.time.begin;
  until = Math.min(Math.max((until === null ? store.time.end : until) + share * length, store.time.begin + 0.2 * length), store.time.end);
  byId("hold_log").setAttribute("aria-pressed", "true");
  drawTimeLog();
}

/// Of the log: from and to [s].
export function timeWindow() {
  const to = until === null ? store.time.end : until;
  return span === 0 ? [store.time.begin, Math.max(to, store.time.begin + 1)] : [to - span, to];
}

export function drawTimeLog() {
  if (!bar || store.time.first === null) return;
  const [from, to] = timeWindow(), shown = bandsOf(from, to);
  for (const track of tracks) {
    Object.assign(track.chart.options.scales.y, { min: from, max: to });
    track.chart.bands = shown.filter((band) => band.kind === "connection" || band.kind === "slide");
    track.curves.forEach((curve, n) => drawCurve(track.chart, curve, n, from, to));
    track.chart.update("none");
  }
  Object.assign(bar.chart.options.scales.y, { min: from, max: to });
  bar.chart.bands = shown;
  bar.chart.update("none");
}

function bandsOf(from, to) {
  const intervals = store.sheets ? store.sheets.intervals : [];
  return intervals.filter((one) => one.to >= from && one.from <= to).map((one) => ({ from: one.from, to: one.to, kind: one.kind,
    colour: colour(one.kind) }));
}

function drawCurve(chart, curve, n, from, to) {
  const { field, head } = curve, rows = store.time.rows(field.name, from, to, MOST_ROWS);
  const inUnits = (values) => values.map((value) => shownValue(field.quantity, value));
  const [low, high] = scaleOf(field.name, field.quantity, field.scale, store.time.extremes(field.name, from, to));
  Object.assign(chart.options.scales["x" + n], { min: low, max: high });
  const dataset = chart.data.datasets[n];
  dataset.envelope = { keys: rows.keys, low: inUnits(rows.low), high: inUnits(rows.high) };
  dataset.data = pointsOf(inUnits(rows.mean), rows.keys);
  head.show([low, high]);
}
