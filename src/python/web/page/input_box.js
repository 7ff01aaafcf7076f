// SPDX-License-Identifier: BSD-3-Clause
// A box for a set point: it follows what is in force until it is edited; an edited one is marked, Enter applies it, Escape takes it back.
import { make, setText } from "./dom.js";
import { shownText, unitOf } from "./units.js";

/// `apply`: called by Enter. The box has show(si), value() in SI (null: empty; NaN: no number) and taken(), after which it follows again.
export function inputBox(name, label, quantity, apply) {
  const input = make("input", { id: "set_" + name, name, inputmode: "decimal", autocomplete: "off" }), unit = make("span", { class: "faint" });
  const box = make("label", {}, make("span", {}, label + " ", unit), input);
  let inUnit = null;  // of what the box holds
  const showUnit = () => {
    inUnit = unitOf(quantity);
    setText(unit, `[${inUnit.name}]`);
  };
  const follow = () => {
    input.classList.remove("edited", "wrong");
    input.value = box.inForce === null ? "" : shownText(quantity, box.inForce);
  };
  box.inForce = null;
  box.edited = () => input.classList.contains("edited");
  box.value = () => (input.value.trim() === "" ? null : Number(input.value.replace(",", ".")) / inUnit.per_si);
  box.show = (si) => {
    box.inForce = si === undefined ? null : si;
    if (!box.edited() && document.activeElement !== input) follow();
  };
  box.mark = () => input.classList.toggle("wrong", Number.isNaN(box.value()));
  box.taken = () => { input.classList.remove("edited", "wrong"); };
  input.addEventListener("input", () => {
    input.classList.add("edited");
    box.mark();
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") apply();
    if (event.key === "Escape") {
      follow();
      input.blur();
    }
  });
  document.addEventListener("units", () => {
    const edited = box.edited() ? box.value() : null;
    showUnit();
    if (Number.isFinite(edited)) input.value = shownText(quantity, edited);
    else follow();
  });
  showUnit();
  return box;
}
