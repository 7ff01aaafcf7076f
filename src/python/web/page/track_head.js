// SPDX-License-Identifier: BSD-3-Clause
// The head of a track: each curve's name, unit and the ends of its scale, which a click changes.
import { make, setText } from "./dom.js";
import { fixScale, isFixed } from "./scales.js";
import { unitOf } from "./units.js";

/// A head for one curve; show(ends, value) writes the ends of its scale. `changed`: called when a person has changed them.
export function trackHead(name, label, quantity, style, changed) {
  const low = make("button", { class: "low", title: "set this end of the scale" }), high = make("button",
    { class: "high", title: "set this end of the scale" });
  const unit = make("span"), title = make("div", { class: "name" }, label + " ", unit);
  const head = make("div", { class: "head" + (style === 1 ? "" : " dashed"), "data-name": name,
    style: `border-color: var(--curve-${style}); color: var(--curve-${style})` }, title,
    make("div", { class: "ends" }, low, make("span"), high));
  let ends = [0, 1];
  const ask = (n) => {
    const text = window.prompt(`${label} [${unitOf(quantity).name}]: ${n ? "largest" : "smallest"} value of the scale (empty: automatic)`, ends[n]);
    if (text === null) return;
    const wanted = [...ends];
    wanted[n] = Number(text);
    if (text.trim() === "") fixScale(name, quantity, null);
    else if (Number.isFinite(wanted[n]) && wanted[0] < wanted[1]) fixScale(name, quantity, wanted);
    changed();
  };
  low.addEventListener("click", () => ask(0));
  high.addEventListener("click", () => ask(1));
  head.show = (now) => {
    ends = now.map((end) => Number(end.toPrecision(4)));
    setText(unit, `[${unitOf(quantity).name}]`);
    setText(low, String(ends[0]));
    setText(high, String(ends[1]) + (isFixed(name) ? " ⚲" : ""));
  };
  return head;
}
