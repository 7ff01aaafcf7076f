// SPDX-License-Identifier: BSD-3-Clause
// The top line: whether messages of the rig arrive, simulated time and speed, what is under way; units, theme, print.
import { byId, setText } from "./dom.js";
import { on, store } from "./store.js";
import { chooseSystem, clockText, systemOfUnits } from "./units.js";

const RUN_STATES = ["running", "paused", "waiting for step", "FAILED"];
const THEMES = ["auto", "light", "dark"];
const SILENT = 10;  // seconds of silence that are shown as a whole number from here on
const HUNG = 2000;   // without a word of the bridge for so long, nothing that is shown is the present [ms]
let isOpen = false, cameAt = 0;

export function buildHeader() {
  byId("units").addEventListener("click", () => chooseSystem(systemOfUnits() === "si" ? "oilfield" : "si"));
  byId("theme").addEventListener("click", () => chooseTheme(THEMES[(THEMES.indexOf(byId("theme").textContent) + 1) % THEMES.length]));
  byId("print").addEventListener("click", () => window.print());
  document.addEventListener("units", () => setText(byId("units"), systemOfUnits() === "si" ? "SI" : "oilfield"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => chooseTheme(byId("theme").textContent));
  chooseTheme(localStorage.getItem("drill_web_theme") || "auto");
  on("hello", () => {
    document.title = "drill web: " + store.hello.source;
    setText(byId("title"), store.hello.source);
    document.dispatchEvent(new Event("units"));
  });
  on("state", showHeader);
  setInterval(watchBridge, 500);
  on("answer", (answer) => say(answer.text));
}

export function linkChanged(open) {
  isOpen = open;
  cameAt = Date.now();
  if (open) return;  // the first state from the bridge shows how things are
  setPill("no connection to drill web", "bad");
  document.body.classList.add("stale");
}

function watchBridge() {
  if (!isOpen || !store.hello || !store.hello.live || Date.now() - cameAt < HUNG) return;
  setPill("drill web does not answer", "bad");
  document.body.classList.add("stale");
}

function chooseTheme(name) {
  const dark = name === "dark" || (name === "auto" && matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  localStorage.setItem("drill_web_theme", name);
  setText(byId("theme"), name);
  document.dispatchEvent(new Event("theme"));
}

function setPill(text, kind) {
  setText(byId("link"), text);
  byId("link").className = "pill " + kind;
}

function showHeader(state) {
  if (!isOpen && store.hello.live) return;
  cameAt = Date.now();
  showPill(state);
  setText(byId("clock"), state.t === undefined ? "" : clockText(state.t) + (state.speed === null || !store.hello.live ? "" : `  at ${state.speed.toFixed(1)}×`));
  setText(byId("operation"), state.operation ? `${state.operation} ${(100 * state.progress).toFixed(0)} %` : "");
  setText(byId("accuracy"), state.flags && state.flags.includes("accuracy_warning") ? "△ simulation accuracy warning" : "");
  setText(byId("foot"), store.hello.live ? `${store.hello.control ? "with control" : "read-only"}; drill web uses ${state.cpu === null ? "–" : (100 * state.cpu).toFixed(0)} % of a core` : "recorded run: last values");
}

function showPill(state) {
  const { heard, why, silent } = state.status;
  if (!store.hello.live) setPill("recorded", "");
  else if (heard && state.run_state !== undefined) setPill(RUN_STATES[state.run_state],
    state.run_state === 0 ? "good" : state.run_state === 3 ? "bad" : "");
  else if (state.run_state === 1 || state.run_state === 2) setPill(why || RUN_STATES[state.run_state], why ? "bad" : "");
  else setPill(why || `no data for ${silent < SILENT ? silent.toFixed(1) : silent.toFixed(0)} s`, "bad");
}

let hiding = null;
function say(text) {
  const box = byId("answer");
  setText(box, text);
  box.hidden = false;
  clearTimeout(hiding);
  hiding = setTimeout(() => { box.hidden = true; }, 8000);
}
