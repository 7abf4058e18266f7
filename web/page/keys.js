// SPDX-License-Identifier: GPL-3.0-or-later
// The keyboard: everything that the pointer can do.

const TURN = 24; // pixels of a drag, for each press of an arrow
const ZOOM = 1.15;

const SESSION_KEYS = {
  Enter: "add", m: "move", "]": "next", "[": "previous", g: "next_curve", Delete: "remove", Backspace: "remove", c: "close",
  n: "new_curve", t: "kind", Escape: "cancel",
};

export function listenToKeys({ canvas, view, input, act }) {
  const turns = {
    ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, -TURN], ArrowDown: [0, TURN],
  };
  const onView = (event) => {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (key in turns) {
      view.camera.turn(...turns[key]);
    } else if (key === "+" || key === "=" || key === "-") {
      view.camera.zoom(key === "-" ? ZOOM : 1 / ZOOM);
    } else if (key in SESSION_KEYS) {
      const at = input.at ?? [canvas.clientWidth / 2, canvas.clientHeight / 2];
      act.key(SESSION_KEYS[key], { ...view.rayAt(...at), snaps: event.altKey });
    } else if (key === "f") {
      view.fit();
    } else if (key === "v") {
      act.turn();
    } else if (key === "s") {
      act.freehand();
    } else if (key === "p") {
      act.paint();
    } else {
      return false;
    }
    view.draw();
    return true;
  };
  document.addEventListener("keydown", (event) => {
    const isText = event.target.matches("input:not([type=range]), select, textarea");
    const isDialog = document.querySelector("dialog[open]");
    if (isText || isDialog) {
      return;
    }
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey) {
      if (key === "z" || key === "y") {
        event.preventDefault();
        act[key === "y" || event.shiftKey ? "redo" : "undo"]();
      }
      return;
    }
    if (event.key === "?") {
      act.help();
    } else if ((event.target === canvas || event.target === document.body) && onView(event)) {
      event.preventDefault();
    }
  });
}
