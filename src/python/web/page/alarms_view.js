// SPDX-License-Identifier: BSD-3-Clause
// Alarms above all: what lasts, and red ones until they are acknowledged; with a shape, not only by colour.
import { byId, make } from "./dom.js";
import { send } from "./link.js";
import { on, store } from "./store.js";
import { clockText, shownText, unitOf } from "./units.js";

const MOST = 3;

export function buildAlarms() {
  on("alarms", showAlarms);
  on("faults", showFaults);
  on("hello", () => {
    store.faults = null;  // of another server
    showFaults();
  });
  document.addEventListener("units", showFaults);
}

/// Those that were ordered, by a scene or an instructor: no rig senses them.
function showFaults() {
  const faults = store.faults ? store.faults.entries : [], box = byId("faults");
  box.hidden = faults.length === 0;
  box.textContent = "Faults under way: " + faults.map(faultText).join(", ");
}

function faultText(one) {
  return one.depth === null ? one.text : `${one.text} at ${shownText("length", one.depth, 0)} ${unitOf("length").name}`;
}

function showAlarms() {
  const open = store.alarms.entries.filter((one) => one.to === null || !one.acknowledged);
  open.sort((a, b) => (a.rank === b.rank ? b.number - a.number : a.rank === "red" ? -1 : 1));
  const box = byId("alarms"), unseen = open.filter((one) => !one.acknowledged);
  box.hidden = open.length === 0;
  box.replaceChildren(...open.slice(0, MOST).map(alarmLine), ...(open.length > MOST ? [make("div",
    { class: "faint", text: `and ${open.length - MOST} more: see Alarms` })] : []));
  if (unseen.length > 1) box.append(make("button", { id: "acknowledge_all", text: `Acknowledge all ${unseen.length}`,
    onclick: () => send({ type: "acknowledge" }) }));
}

function alarmLine(one) {
  const when = one.to === null ? `since ${clockText(one.from)}` : `from ${clockText(one.from)} to ${clockText(one.to)}`, line = make("div", { class: "alarm " + one.rank, "data-flag": one.flag },
    make("span", { text: one.rank === "red" ? "▲" : "△" }), make("span", { text: one.text }), make("span",
      { text: `${when}${one.times > 1 ? `, ${one.times} times` : ""}` }));
  if (!one.acknowledged) line.append(make("button", { class: "acknowledge", text: "Acknowledge",
    onclick: () => send({ type: "acknowledge", number: one.number }) }));
  return line;
}
