// SPDX-License-Identifier: BSD-3-Clause
// Elements in few words.
export function byId(id) {
  return document.getElementById(id);
}

export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "text") element.textContent = value;
    else if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value !== false && value !== null) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}

/// Sets a text where it is another one: what does not change costs no layout.
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}

/// Rows as a table; a cell is a text or an element.
export function fillTable(table, heads, rows) {
  table.replaceChildren(make("thead", {}, make("tr", {}, ...heads.map((head) => make("th", { text: head })))),
    make("tbody", {}, ...rows.map((row) => make("tr", {}, ...row.map((cell) => (cell instanceof Node ? make("td", {}, cell) : make("td",
      { text: cell })))))));
}
