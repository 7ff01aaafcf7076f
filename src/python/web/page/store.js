// SPDX-License-Identifier: BSD-3-Clause
// What has come of a run, by the type of its message; views are called when a type has come.
import { BinLog } from "./bins.js";

export const store = { time: new BinLog(), depth: new BinLog(), run: null };
const listeners = {};

export function on(type, tell) {
  (listeners[type] = listeners[type] || []).push(tell);
}

export function take(message) {
  if (message.type === "bins") {
    if (message.run !== store.run) {
      store.time.clear();
      store.depth.clear();
      store.run = message.run;
    }
    store[message.log].take(message);
  } else {
    store[message.type] = message;
  }
  for (const tell of listeners[message.type] || []) tell(message);
}

export function fieldOf(name) {
  return store.hello.fields.find((field) => field.name === name);
}
