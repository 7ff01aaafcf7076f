// SPDX-License-Identifier: BSD-3-Clause
// The web socket to the bridge; where it is lost it is opened again and again.
import { take } from "./store.js";

const AGAIN = 1000;  // [ms]
let socket = null;

export function openLink(tell) {
  socket = new WebSocket(new URL("socket", location.href).href.replace(/^http/, "ws"));
  socket.onopen = () => tell(true);
  socket.onmessage = (event) => take(JSON.parse(event.data));
  socket.onclose = () => {
    tell(false);
    setTimeout(() => openLink(tell), AGAIN);
  };
}

export function send(order) {
  if (socket && socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(order));
}
