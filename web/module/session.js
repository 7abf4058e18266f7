// SPDX-License-Identifier: GPL-3.0-or-later
import { coordinates, ids } from "./arrays.js";
import { Curve } from "./curve.js";
import { call, Held } from "./instance.js";

/** How a curve passes a pick, by its number in `kinds`. */
export const PICK_KINDS = ["automatic", "aligned", "corner", "free"];

/**
 * Drawing with a mouse, a pen or fingers, without a window: takes events as rays into the scene, holds curves, picks,
 * what is hovered and selected, and a history. Nothing is solved in a call but update(), which solves one curve that
 * waits; call it again until `state.is_settled`, and between the moves of a drag.
 */
export class Session extends Held {
  #mesh;
  #curves = new Map();

  constructor(mesh, { radii, handles = 0, ...options } = {}) {
    const { session, state } = call("session.begin", { mesh: mesh.number, options, handles, ...(radii && { radii }) });
    super(session);
    this.#mesh = mesh;
    this.#take(state);
  }

  get mesh() {
    return this.#mesh;
  }

  // The module tells of curves only what changed.
  #take(state) {
    const known = new Map();
    state.curves = state.curves.map((told) => {
      const curve = "picks" in told ? told : this.#curves.get(told.id);
      known.set(told.id, curve);
      return curve;
    });
    this.#curves = known;
    this.state = state;
  }

  #call(name, values = {}) {
    const { state, ...rest } = call(`session.${name}`, { session: this.number, ...values });
    this.#take(state);
    return rest;
  }

  event(event) {
    return this.#call("event", event).taken;
  }

  update() {
    return this.#call("update").changed;
  }

  settle() {
    while (!this.state.is_settled) {
      this.update();
    }
  }

  add_curve(picks, options = {}) {
    this.add_curves([{ picks, ...options }]);
  }

  add_curves(curves) {
    this.#call("add_curves", {
      curves: curves.map(({ picks, corners = [], tangents = [], tangents_before = tangents, ...options }) => ({
        picks: coordinates(picks), corners: ids(corners), options,
        tangents: coordinates(tangents), tangents_before: coordinates(tangents_before),
      })),
    });
  }

  set_kind(pick, kind) {
    this.#call("set_kind", { pick, kind: PICK_KINDS.indexOf(kind) });
  }

  set_options(options, { live = false } = {}) {
    this.#call("set_options", { options, live });
  }

  set_look(curve, look) {
    this.#call("set_look", { curve, ...look });
  }

  set_colour(colour) {
    this.#call("set_colour", { colour });
  }

  select(curve, pick = -1) {
    this.#call("select", { curve, pick });
  }

  new_curve() {
    this.#call("new_curve");
  }

  remove_curve(curve) {
    this.#call("remove_curve", { curve });
  }

  set_closed(closed) {
    this.#call("set_closed", { closed });
  }

  undo() {
    this.#call("undo");
  }

  redo() {
    this.#call("redo");
  }

  open(name, bytes, { first = false } = {}) {
    return this.#call("open", { name, bytes: new Uint8Array(bytes), first }).notes;
  }

  save(name) {
    return call("session.save", { session: this.number, name }).bytes;
  }

  save_picks(name) {
    return call("session.save_picks", { session: this.number, name }).bytes;
  }

  curve(index) {
    const { options } = this.state.curves[index];
    return new Curve(call("session.curve", { session: this.number, curve: index }), this.#mesh, options);
  }
}
