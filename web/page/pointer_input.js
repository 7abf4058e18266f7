// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, pen and fingers: to the drawing what it takes, the rest to the camera. The drawing answers from the worker, so
// what comes before its answer waits for it.

const FINGER = 2.3; // pixels of a mouse that are one of a finger, which hits less exactly
const LONG_WAIT = 400; // ms: a press that is answered so late is the camera's no more

export class PointerInput {
  #canvas;
  #view;
  #engine;
  #fingers = new Map(); // where each pointer that is down was last
  #use = null; // of the press: "asked", "draw", "turn", "move"
  #isMoveSent = false;
  #nextMove = null;
  /** The first button turns the view. */
  turns = false;
  /** Points snap without a key, too. */
  snaps = false;
  /** Where the pointer is over the canvas; null: it is not. */
  at = null;

  constructor(canvas, view, engine, report) {
    this.#canvas = canvas;
    this.#view = view;
    this.#engine = engine;
    this.report = report;
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("pointercancel", (event) => this.#cancel(event));
    canvas.addEventListener("pointerleave", () => this.#leave());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
  }

  #placeOf(event) {
    return [event.offsetX, event.offsetY];
  }

  #rayOf(event) {
    const ray = this.#view.rayAt(...this.#placeOf(event));
    const pixel = ray.pixel * (event.pointerType === "touch" ? FINGER : 1);
    return { ...ray, pixel, snaps: event.altKey || this.snaps, removes: event.ctrlKey || event.metaKey };
  }

  #send(kind, event) {
    return this.#engine.request("event", { event: { event: kind, ...this.#rayOf(event) } }).catch((error) => {
      this.report(error);
      return false;
    });
  }

  async #press(event) {
    this.#canvas.focus({ preventScroll: true, focusVisible: false });
    this.#canvas.setPointerCapture(event.pointerId);
    this.#fingers.set(event.pointerId, this.#placeOf(event));
    if (this.#fingers.size > 1) {
      this.#twoFingers();
      return;
    }
    if (event.button === 1 || (event.button === 2 && event.shiftKey)) {
      this.#use = "move";
    } else if (event.button === 2 || this.turns) {
      this.#use = "turn";
    } else if (event.button === 0) {
      this.#use = "asked";
      const start = performance.now();
      const isTaken = await this.#send("press", event);
      if (this.#use === "asked") {
        this.#use = isTaken ? "draw" : performance.now() - start < LONG_WAIT ? "turn" : null;
      }
    }
  }

  // A second finger: the first did not mean to draw.
  #twoFingers() {
    this.#giveUp();
    this.#use = "fingers";
  }

  #giveUp() {
    if (this.#use === "draw" || this.#use === "asked") {
      this.#nextMove = null;
      this.#engine.request("event", { event: { event: "key", key: "cancel", ...this.#view.rayAt(0, 0) } }).catch(this.report);
    }
  }

  // The system took the pointer away.
  #cancel(event) {
    this.#giveUp();
    this.#fingers.delete(event.pointerId);
    this.#use = this.#fingers.size > 0 ? this.#use : null;
  }

  #move(event) {
    this.at = this.#placeOf(event);
    const before = this.#fingers.get(event.pointerId);
    if (!before) {
      this.#sendMove(event);
      return;
    }
    const [dx, dy] = [event.offsetX - before[0], event.offsetY - before[1]];
    if (this.#use === "fingers") {
      this.#moveFingers(event, dx, dy);
    } else if (this.#use === "turn") {
      this.#view.camera.turn(dx, dy);
      this.#view.draw();
    } else if (this.#use === "move") {
      this.#view.camera.move(dx, dy);
      this.#view.draw();
    } else if (this.#use === "draw" || this.#use === "asked") {
      this.#sendMove(event);
    }
    this.#fingers.set(event.pointerId, this.#placeOf(event));
  }

  // Two fingers turn together, and zoom by their distance.
  #moveFingers(event, dx, dy) {
    const [first, second] = [...this.#fingers.values()];
    const before = Math.hypot(first[0] - second[0], first[1] - second[1]);
    this.#fingers.set(event.pointerId, this.#placeOf(event));
    const [a, b] = [...this.#fingers.values()];
    const now = Math.hypot(a[0] - b[0], a[1] - b[1]);
    this.#view.camera.turn(dx / 2, dy / 2);
    this.#view.camera.zoom(before / Math.max(1, now));
    this.#view.draw();
  }

  // One at a time: the newest waits until the worker has taken the one before.
  #sendMove(event) {
    this.#nextMove = { event: "move", ...this.#rayOf(event) };
    if (this.#isMoveSent) {
      return;
    }
    this.#flushMove();
  }

  async #flushMove() {
    while (this.#nextMove) {
      const move = this.#nextMove;
      this.#nextMove = null;
      this.#isMoveSent = true;
      try {
        await this.#engine.request("event", { event: move });
      } catch (error) {
        this.report(error);
      }
      this.#isMoveSent = false;
    }
  }

  #release(event) {
    this.#fingers.delete(event.pointerId);
    if (this.#use === "draw" || this.#use === "asked") {
      this.#nextMove = null;
      this.#send("release", event);
    }
    if (this.#fingers.size === 0) {
      this.#use = null;
    }
  }

  #leave() {
    this.at = null;
    if (this.#use === null) {
      this.#nextMove = null;
      this.#engine.request("event", { event: { event: "leave" } }).catch(this.report);
    }
  }

  #wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    this.#view.camera.zoom(Math.exp(event.deltaY * lines * 0.0012));
    this.#view.draw();
  }
}
