// SPDX-License-Identifier: BSD-3-Clause
// Puts the page together: what is built once, what is drawn again when data, units or theme change.
import { buildAlarms } from "./alarms_view.js";
import { resizeCharts } from "./chart_base.js";
import { buildBroomstick, drawBroomstick } from "./broomstick_view.js";
import { buildControl } from "./control_view.js";
import { buildDepthLog, drawDepthLog } from "./depth_log.js";
import { byId, make } from "./dom.js";
import { buildHeader, linkChanged } from "./header_view.js";
import { openLink } from "./link.js";
import { buildNumbers } from "./numbers_view.js";
import { drawAlarmLog, drawSlides, drawTally } from "./sheets_view.js";
import { on, store, take } from "./store.js";
import { buildString, drawString } from "./string_view.js";
import { buildTimeLog, drawTimeLog } from "./time_log.js";
import { buildWell, drawWell } from "./well_view.js";

const LEAST_PAUSE = 200;  // between two drawings of a sheet [ms]
const sheets = {
  time_log: { build: buildTimeLog, draw: drawTimeLog, types: ["bins", "sheets"] },
  depth_log: { build: buildDepthLog, draw: drawDepthLog, types: ["bins", "sheets"] },
  well: { build: buildWell, draw: drawWell, types: ["well"] },
  string: { build: buildString, draw: drawString, types: ["string"] },
  broomstick: { build: buildBroomstick, draw: drawBroomstick, types: ["broomstick", "weights"] },
  tally: { build: () => {}, draw: drawTally, types: ["sheets", "parts"] },
  slides: { build: () => {}, draw: drawSlides, types: ["sheets"] },
  alarm_log: { build: () => {}, draw: drawAlarmLog, types: ["alarms"] },
};
let opened = "time_log", isDue = false, drawnAt = 0;

function buildTabs() {
  byId("tabs").replaceChildren(...Object.keys(sheets).map((name) => make("button",
    { role: "tab", id: "tab_" + name, text: byId(name).dataset.title, onclick: () => openSheet(name) })));
  openSheet(opened);
}

function openSheet(name) {
  opened = name;
  for (const one of Object.keys(sheets)) {
    byId(one).classList.toggle("open", one === name);
    byId("tab_" + one).setAttribute("aria-pressed", String(one === name));
  }
  draw(name);
}

function draw(name) {
  if (store.hello) sheets[name].draw();
}

/// Charts take their colours and units when they are made.
function rebuild() {
  if (!store.hello) return;
  for (const sheet of Object.values(sheets)) sheet.build();
  draw(opened);
}

function drawWhenDue(now) {
  if (isDue && now - drawnAt >= LEAST_PAUSE) {
    isDue = false;
    drawnAt = now;
    draw(opened);
  }
  requestAnimationFrame(drawWhenDue);
}

/// Charts are measured where they stand, which a hidden sheet does not: all sheets stand on the page before it is printed.
function drawForPaper() {
  document.body.classList.add("paper");
  for (const name of Object.keys(sheets)) draw(name);
  resizeCharts();
}

function drawForScreen() {
  document.body.classList.remove("paper");
  resizeCharts();
}

buildTabs();
buildHeader();
buildNumbers();
buildAlarms();
on("hello", () => {
  store.run = null;
  buildControl();
});
on("hello", rebuild);
for (const type of ["bins", "sheets", "well", "string", "parts", "alarms", "broomstick", "weights"]) {
  on(type, () => { isDue = isDue || sheets[opened].types.includes(type); });
}
for (const event of ["units", "theme"]) document.addEventListener(event, rebuild);
window.addEventListener("beforeprint", drawForPaper);
window.addEventListener("afterprint", drawForScreen);
const inside = byId("run");  // of a page that is a file: all its messages
if (inside) for (const message of JSON.parse(inside.textContent)) take(message);
else openLink(linkChanged);
requestAnimationFrame(drawWhenDue);
