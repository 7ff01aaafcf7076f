// SPDX-License-Identifier: BSD-3-Clause
// Control by hand, where drill web was started with --control. The block moves while a button is held: dead-man.
import { byId, make } from "./dom.js";
import { inputBox } from "./input_box.js";
import { buildLaw } from "./law_view.js";
import { send } from "./link.js";
import { on, store } from "./store.js";

const REPEAT = 150;  // between orders while a button is held [ms]
const ALIVE = 500;   // between signs of life [ms]
const SPEEDS = [1, 2, 5, 10, 20];
let held = null, press = 0;

export function buildControl() {
  const box = byId("control");
  box.hidden = !store.hello.control;
  if (box.hidden || box.childElementCount) return;
  box.append(blockBox(), driveBox(), buildLaw(), rigBox());
  setInterval(() => send({ type: "alive" }), ALIVE);
  on("press_ended", (ended) => ended.press === press && letGo());  // by the dead-man of the bridge; a later press is another one
  for (const event of ["blur", "pagehide"]) window.addEventListener(event, letGo);
  document.addEventListener("visibilitychange", letGo);
}

function blockBox() {
  const speed = inputBox("block_speed", "Block speed", "speed", () => {});
  speed.show(0.1);
  const hold = (id, text, sign) => {
    const button = make("button", { id, text });
    button.addEventListener("pointerdown", (event) => {
      button.setPointerCapture(event.pointerId);
      begin(button, () => sign * Math.abs(speed.value() || 0));
    });
    for (const event of ["pointerup", "pointercancel", "lostpointercapture"]) button.addEventListener(event, letGo);
    button.addEventListener("keydown", (event) => event.key === " " && !event.repeat && begin(button, () => sign * Math.abs(speed.value() || 0)));
    button.addEventListener("keyup", (event) => event.key === " " && letGo());
    button.addEventListener("contextmenu", (event) => event.preventDefault());
    return button;
  };
  return make("div", { class: "box" }, make("h2", { text: "Block: hold to move" }),
    make("div", { class: "hold" }, hold("raise", "▲ Raise", 1), hold("lower", "▼ Lower", -1)), speed);
}

function begin(button, velocity) {
  letGo();
  button.classList.add("held");
  press += 1;
  const order = () => send({ type: "hold", velocity: velocity(), press });
  held = { button, timer: setInterval(order, REPEAT) };
  order();
}

function letGo() {
  if (!held) return;
  clearInterval(held.timer);
  held.button.classList.remove("held");
  held = null;
  send({ type: "release" });
}

function driveBox() {
  const apply = () => {
    const order = { type: "set" };
    for (const [name, box] of [["rpm", rpm], ["flow", flow]]) {
      if (box.edited() && Number.isFinite(box.value())) {
        order[name] = box.value();
        box.taken();
      }
    }
    if ("rpm" in order || "flow" in order) send(order);
  };
  const rpm = inputBox("rpm", "Rotary speed", "rotation", apply), flow = inputBox("flow", "Flow", "flow", apply);
  on("state", (state) => {
    rpm.show(state.rpm);
    flow.show(state.flow);
  });
  return make("div", { class: "box" }, make("h2", { text: "Top drive and pump" }), rpm, flow,
    make("button", { id: "apply_set", class: "primary", text: "Apply", onclick: apply }));
}

function rigBox() {
  const call = (service, value, question) => () => (!question || window.confirm(question)) && send({ type: "call", service, value });
  const button = (id, text, action) => make("button", { id, text, onclick: action });
  const speeds = SPEEDS.map((speed) => button("speed_" + speed, speed + "×", call("set_speed", speed)));
  return make("div", { class: "box" }, make("h2", { text: "Rig and simulation" }),
    make("div", { class: "row" }, button("pause", "Pause", call("pause")), button("resume", "Resume", call("resume")),
      button("tare", "Zero WOB", call("tare"))),
    make("div", { class: "row" }, button("slips_in", "Set slips", call("set_slips", true)),
      button("slips_out", "Pull slips", call("set_slips", false)),
      button("connection", "Make connection",
        () => window.confirm("Make a connection now? The crew stops rotary and pump, and adds a stand.") && send({ type: "connect" }))), make("div", { class: "row" }, ...speeds));
}
