// SPDX-License-Identifier: GPL-3.0-or-later
import { coordinates } from "./arrays.js";
import { call, Held } from "./instance.js";

/** A polyline on a mesh, and the B-spline that was projected onto it; it does not change. */
export class Curve extends Held {
  #mesh;
  #options;

  constructor(json, mesh, options) {
    const { curve, ...values } = json;
    super(curve);
    Object.assign(this, values);
    this.#mesh = mesh;
    this.#options = options;
  }

  /** The curve through other picks, as many, each near the one of now: solved from this one. */
  redraw(picks, { progress } = {}) {
    return this.#mesh.curve(picks, { ...this.#options, start: this, progress });
  }

  /** Where its picks are: 3 numbers of each. */
  pick_points() {
    return Float64Array.from([...this.picks].flatMap((i) => [...this.points.subarray(3 * i, 3 * i + 3)]));
  }

  /** The same with one pick elsewhere. */
  move(pick, position, options) {
    const picks = this.pick_points();
    picks.set(coordinates(position), 3 * pick);
    return this.redraw(picks, options);
  }

  offset(distance, side = "both", { progress } = {}) {
    const { curves } = call("curve.offset", { curve: this.number, distance, side }, progress);
    return curves.map((json) => new Curve(json, this.#mesh, {}));
  }

  save(name, unit = "mm") {
    return Curve.save([this], name, unit);
  }

  static save(curves, name, unit = "mm") {
    return call("curves.save", { curves: curves.map((curve) => curve.number), name, unit }).bytes;
  }
}
