// SPDX-License-Identifier: BSD-3-Clause
// What all charts share: colours of the theme, plain axes, and two plugins of Chart.js: bands across a chart, and envelopes from least to largest.
import { colour } from "./dom.js";

const Chart = window.Chart;
const charts = new Set();
const MARK = 14;  // height of the mark of a cut value [px]
/// Share of a scale beyond which a value counts as outside.
export const SLACK = 0.02;

const bands = {
  id: "bands",
  beforeDatasetsDraw(chart) {
    const { ctx, chartArea: area, scales } = chart;
    for (const band of chart.bands || []) {
      const top = Math.max(scales.y.getPixelForValue(band.from), area.top), bottom = Math.min(scales.y.getPixelForValue(band.to), area.bottom);
      if (bottom < area.top || top > area.bottom) continue;
      ctx.save();
      ctx.globalAlpha = chart.bandAlpha || 1;
      ctx.fillStyle = band.colour;
      ctx.fillRect(area.left, top, area.width, Math.max(bottom - top, 1));
      ctx.restore();
    }
  },
};

const envelopes = {
  id: "envelopes",
  beforeDatasetsDraw(chart) {
    for (const [n, dataset] of chart.data.datasets.entries()) {
      if (dataset.envelope && chart.isDatasetVisible(n)) drawEnvelope(chart, dataset);
    }
  },
  afterDatasetsDraw(chart) {
    for (const dataset of chart.data.datasets) if (dataset.envelope) markCuts(chart, dataset);
  },
};

function drawEnvelope(chart, dataset) {
  const { ctx, chartArea: area } = chart, x = chart.scales[dataset.xAxisID], y = chart.scales.y, { keys, low, high } = dataset.envelope;
  ctx.save();
  ctx.beginPath();
  ctx.rect(area.left, area.top, area.width, area.height);
  ctx.clip();
  ctx.fillStyle = dataset.borderColor;
  ctx.globalAlpha = 0.3;
  for (const [begin, end] of stretchesOf(low)) {
    ctx.beginPath();
    for (let n = begin; n < end; n++) ctx.lineTo(x.getPixelForValue(high[n]) + 0.5, y.getPixelForValue(keys[n]));
    for (let n = end - 1; n >= begin; n--) ctx.lineTo(x.getPixelForValue(low[n]) - 0.5, y.getPixelForValue(keys[n]));
    ctx.fill();
  }
  ctx.restore();
}

/// Where values leave the scale by more than can be seen: an arrow with the value that is cut, one where several would stand over each other.
function markCuts(chart, dataset) {
  const x = chart.scales[dataset.xAxisID], { high, low } = dataset.envelope, slack = SLACK * (x.max - x.min);
  const over = (n) => high[n] !== null && high[n] > x.max + slack, under = (n) => low[n] !== null && low[n] < x.min - slack;
  for (const [test, table, sign] of [[over, high, 1], [under, low, -1]]) {
    for (const n of farthest(chart, dataset.envelope.keys, test, (one) => sign * table[one])) writeCut(chart, dataset, n, table[n], sign);
  }
}

/// Of what is cut, the rows with the largest value of each stretch; stretches whose marks would touch are one.
function farthest(chart, keys, test, value) {
  const found = [], pixel = (n) => chart.scales.y.getPixelForValue(keys[n]);
  let last = null;
  for (let n = 0; n < keys.length; n++) {
    if (!test(n)) continue;
    const near = last !== null && (n === last + 1 || pixel(n) - pixel(found[found.length - 1]) < MARK);
    if (!near) found.push(n);
    else if (value(n) > value(found[found.length - 1])) found[found.length - 1] = n;
    last = n;
  }
  return found;
}

function writeCut(chart, dataset, n, value, sign) {
  const { ctx, chartArea: area } = chart, y = chart.scales.y.getPixelForValue(dataset.envelope.keys[n]);
  if (y < area.top || y > area.bottom) return;
  const text = Math.abs(value) >= 100 ? value.toFixed(0) : value.toPrecision(3);
  ctx.save();
  ctx.fillStyle = dataset.borderColor;
  ctx.font = "bold 11px sans-serif";
  ctx.textBaseline = "middle";
  ctx.textAlign = sign > 0 ? "right" : "left";
  ctx.fillText(sign > 0 ? text + " ▶" : "◀ " + text, sign > 0 ? area.right - 1 : area.left + 1, y);
  ctx.restore();
}

/// Begin and end of what has values without a gap.
function stretchesOf(values) {
  const found = [];
  let begin = null;
  for (let n = 0; n <= values.length; n++) {
    const known = n < values.length && values[n] !== null;
    if (known && begin === null) begin = n;
    if (!known && begin !== null) {
      found.push([begin, n]);
      begin = null;
    }
  }
  return found;
}

/// A chart in a box of its own; `scales` and `datasets` as Chart.js has them. It must be destroyed with dropChart(). `indexAxis`: "y" where a log
/// goes downwards. chart.bands: what is drawn across it, {from, to, colour}.
export function makeChart(canvas, scales, datasets, indexAxis = "x") {
  const chart = new Chart(canvas, {
    type: "scatter",
    data: { datasets },
    options: {
      animation: false, responsive: true, maintainAspectRatio: false, indexAxis, events: [], scales,
      layout: indexAxis === "y" ? { autoPadding: false, padding: { top: 8, bottom: 8, left: 0, right: 2 } } : {},  // tracks stand in line
      plugins: { legend: { display: false }, tooltip: { enabled: false } },
    },
    plugins: [bands, envelopes],
  });
  charts.add(chart);
  return chart;
}

export function dropChart(chart) {
  charts.delete(chart);
  chart.destroy();
}

/// A curve: `style` 1 to 4 says colour and dashes, so that print without colour can be told apart.
export function curveOf(axis, style, more = {}) {
  const dashes = [[], [6, 3], [2, 2], [8, 3, 2, 3]];
  return { xAxisID: axis, data: [], showLine: true, pointRadius: 0, borderWidth: 1.6, borderColor: colour("curve-" + style),
    backgroundColor: colour("curve-" + style),
    borderDash: dashes[style - 1], spanGaps: false, ...more };
}

export function axisOf(more = {}) {
  const { title, ticks, ...rest } = more;
  return { type: "linear", grid: { color: colour("grid"), borderColor: colour("line"), tickLength: 4 },
    ticks: { color: colour("faint"), maxRotation: 0, font: { size: 11 }, format: { useGrouping: false }, ...ticks },
    title: { display: Boolean(title), text: title || "", color: colour("faint"), font: { size: 12 }, padding: 2 }, ...rest };
}

export function gridOnly() {
  return { color: colour("grid"), borderColor: colour("line"), drawTicks: false };
}

/// The axis of values of a track, whose ends stand in its head: a grid of five.
export function trackAxis(display = true) {
  return axisOf({ min: 0, max: 1, display, position: "top", ticks: { display: false, count: 6 },
    grid: gridOnly() });
}

/// All are measured again: for paper, and for the screen after it.
export function resizeCharts() {
  for (const chart of charts) chart.resize();
}

/// Points of a curve from two arrays; null where there is a gap.
export function pointsOf(xs, ys) {
  return xs.map((x, n) => ({ x: x === null ? NaN : x, y: ys[n] === null ? NaN : ys[n] }));
}

/// A round number not below this one: 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten.
export function roundUp(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((step) => step * power >= value * 0.99999);
}
