// SPDX-License-Identifier: BSD-3-Clause
// Alarms above all: what lasts, and red ones until they are acknowledged; with a shape, not by colour alone.
import { byId, make } from "./dom.js";
import { send } from "./link.js";
import { on, store } from "./store.js";
import { clockText } from "./units.js";

const MOST = 3;

export function buildAlarms() {
  on("alarms", showAlarms);
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
