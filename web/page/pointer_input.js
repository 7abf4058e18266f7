// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, pen and fingers: to the drawing what it takes, the rest to the camera. The drawing answers from the worker, so
// what comes before its answer waits for it.

const FINGER = 2.3; // pixels of a mouse that are one of a finger, which hits less exactly
const LONG_WAIT = 400; // ms: a press that is answered so late is the camera's no more
const BRUSH_STEP = 8; // pixels

export class PointerInput {
  #canvas;
  #view;
  #engine;
  #fingers = new Map(); // where each pointer that is down was last
  #use = null; // of the press: "asked", "draw", "turn", "move"
  #presses = 0; // so far
  #work = null; // of the press that is the drawing's: "drag", "stroke", "paint"
  #isSending = false;
  #moves = []; // that wait: of a drag the newest, of strokes and paint all
  #before = null; // where the brush was
  /** The first button turns the view. */
  turns = false;
  /** Points snap without a key, too. */
  snaps = false;
  /** A drag draws a line freehand without a key, too. */
  strokes = false;
  /** The first button paints faces. */
  paints = false;
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
    canvas.addEventListener("lostpointercapture", (event) => {
      if (this.#fingers.has(event.pointerId)) {
        this.#cancel(event); // no pointerup came before: a dialog, another window
      }
    });
    canvas.addEventListener("pointerleave", () => this.#leave());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
  }

  #placeOf(event) {
    return [event.offsetX, event.offsetY];
  }

  #rayOf(event, place = this.#placeOf(event)) {
    const scale = event.pointerType === "touch" ? FINGER : 1;
    this.#view.setPointerScale(scale);
    const ray = this.#view.rayAt(...place);
    return {
      ...ray, pixel: scale * ray.pixel, snaps: event.altKey || this.snaps, removes: event.ctrlKey || event.metaKey,
      strokes: event.shiftKey || this.strokes,
    };
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
      this.#work = this.paints ? "paint" : event.shiftKey || this.strokes ? "stroke" : "drag";
      this.#moves = [];
      this.#before = this.#placeOf(event);
      const start = performance.now();
      const press = ++this.#presses;
      const isTaken = await (this.paints ? this.#paint([this.#rayOf(event)]) : this.#send("press", event));
      if (this.#use === "asked" && press === this.#presses) { // and not of a later one
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
      this.#moves = [];
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
    if (event.buttons === 0) {
      this.#release(event); // of which the page was not told
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

  #paint(rays) {
    return this.#engine.request("paint", { rays }).catch((error) => {
      this.report(error);
      return false;
    });
  }

  // Of a drag the newest waits until the worker has taken the one before.
  #sendMove(event) {
    const isDown = this.#fingers.has(event.pointerId);
    if (isDown && this.#work === "paint") {
      this.#moves.push(...this.#brushedTo(event));
    } else if (isDown && this.#work === "stroke") {
      const { left, top } = this.#canvas.getBoundingClientRect();
      const all = event.getCoalescedEvents?.() ?? [];
      const places = all.length > 1 ? all.map(({ clientX, clientY }) => [clientX - left, clientY - top]) : [this.#placeOf(event)];
      this.#moves.push(...places.map((place) => ({ event: "move", ...this.#rayOf(event, place) })));
    } else {
      this.#moves = [{ event: "move", ...this.#rayOf(event) }];
    }
    this.#flushMoves();
  }

  // Rays on the way from where the brush was.
  #brushedTo(event) {
    const [to, from] = [this.#placeOf(event), this.#before];
    const steps = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / BRUSH_STEP));
    this.#before = to;
    return Array.from({ length: steps }, (_, i) =>
      this.#rayOf(event, from.map((value, axis) => value + ((i + 1) / steps) * (to[axis] - value))));
  }

  async #flushMoves() {
    if (this.#isSending) {
      return;
    }
    this.#isSending = true;
    while (this.#moves.length > 0) {
      const moves = this.#moves;
      this.#moves = [];
      if ("event" in moves[0]) {
        await this.#engine.request("events", { events: moves }).catch(this.report);
      } else {
        await this.#paint(moves);
      }
    }
    this.#isSending = false;
  }

  #release(event) {
    this.#fingers.delete(event.pointerId);
    if ((this.#use === "draw" || this.#use === "asked") && this.#work !== "paint") {
      const moves = this.#work === "stroke" ? this.#moves : [];
      this.#moves = [];
      this.#engine.request("events", { events: [...moves, { event: "release", ...this.#rayOf(event) }] }).catch(this.report);
    }
    if (this.#fingers.size === 0) {
      this.#use = null;
    }
  }

  #leave() {
    this.at = null;
    if (this.#use === null) {
      this.#moves = [];
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
