// SPDX-License-Identifier: BSD-3-Clause
// The package's autodriller: set points that start it, that it follows, and a button that stops it; which loop leads.
import { make, setText } from "./dom.js";
import { inputBox } from "./input_box.js";
import { send } from "./link.js";
import { on, store } from "./store.js";


export function buildLaw() {
  const boxes = Object.fromEntries(store.hello.law_points.map((point) => [point.order,
    inputBox("law_" + point.order, labelOf(point), point.quantity, () => applyLaw(boxes))]));
  const start = make("button", { id: "start_law", class: "primary", text: "Start", onclick: () => applyLaw(boxes, "start_law") });
  const change = make("button", { id: "set_law", text: "Apply", onclick: () => applyLaw(boxes) });
  const stop = make("button", { id: "stop_law", text: "Stop", onclick: () => send({ type: "stop_law" }) }), status = make("p",
    { id: "law_status", class: "faint", text: "stopped" });
  on("law", (law) => showLaw(law, boxes, { start, change, stop, status }));
  return make("div", { class: "box" }, make("h2", { text: "Autodriller" }), ...Object.values(boxes),
    make("div", { class: "row" }, start, change, stop), status);
}

function labelOf(point) {
  const label = point.label[0].toUpperCase() + point.label.slice(1);
  return point.quantity === "penetration" ? label + " at most" : label;
}

function showLaw(law, boxes, parts) {
  for (const { order, first } of store.hello.law_points) {
    boxes[order].show(order in law.settings ? law.settings[order] : order === "to_depth" ? depthAhead() : law.settings.weight ? null : first || null);
  }
  parts.start.disabled = law.running;
  parts.change.disabled = !law.running || law.connects;
  parts.stop.disabled = !law.running;
  const leads = law.leads ? `, ${store.hello.law_points.find((point) => point.name === law.leads).label} leads` : "", stalls = law.stalls ? `, ${law.stalls} ${law.stalls === 1 ? "stall" : "stalls"}` : "";
  setText(parts.status, law.running ? (law.connects ? "connection: " : "") + law.phase + leads + stalls : law.problem || "stopped");
}

/// To where the block can go without a connection.
function depthAhead() {
  const values = store.state && store.state.values;
  return values ? values.hole_depth[0] + Math.max(values.block_height[0] - (store.limits ? store.limits.block_lowest : 1) - 1, 0) : null;
}

function applyLaw(boxes, type = store.law && store.law.running ? "set_law" : "start_law") {
  const order = { type };
  for (const [name, box] of Object.entries(boxes)) {
    const value = box.value();
    if (Number.isNaN(value)) return;
    order[name] = value;
  }
  send(order);
  for (const box of Object.values(boxes)) box.taken();
}
