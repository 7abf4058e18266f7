// SPDX-License-Identifier: GPL-3.0-or-later
import { coordinates, ids } from "./arrays.js";
import { Curve } from "./curve.js";
import { Imprint } from "./imprint.js";
import { call, Held } from "./instance.js";

// Corners and tangents as the module takes them: text, which counts picks from 1.
function inText({ corners, tangents, ...options }) {
  if (corners !== undefined) {
    options.corners = typeof corners === "string" ? corners : [...corners].map((pick) => pick + 1).join();
  }
  if (tangents !== undefined) {
    const entries = typeof tangents === "string" ? null : Object.entries(tangents);
    const inWords = (direction) => (direction ? [...direction].join() : "any");
    const sidesOf = (direction) => (direction.length === 2 ? direction.map(inWords).join("/") : inWords(direction));
    options.tangents = entries?.map(([pick, direction]) => `${Number(pick) + 1}: ${sidesOf(direction)}`).join("; ") ?? tangents;
  }
  return options;
}

/** A validated triangle mesh, prepared for curves; it does not change. */
export class Mesh extends Held {
  constructor(vertices, faces, { progress, ...options } = {}) {
    const made =
      vertices instanceof Answer
        ? vertices.json
        : call("mesh.make", { vertices: coordinates(vertices), faces: ids(faces), options }, progress);
    super(made.mesh);
    this.vertices = made.vertices;
    this.faces = made.faces;
    this.colours = made.colours;
    this.texture_coordinates = made.texture_coordinates ?? null;
    this.diagonal = made.diagonal;
    this.components = made.components;
    this.mending = made.mending;
    this.notes = made.notes;
  }

  static read(name, bytes, { progress, ...options } = {}) {
    return Mesh.of(call("mesh.load", { name, bytes: new Uint8Array(bytes), options }, progress));
  }

  /** Of an answer of the module. */
  static of(json) {
    return new Mesh(new Answer(json));
  }

  curve(picks, { field, avoid, start, progress, ...drawn } = {}) {
    const options = inText(drawn);
    const values = { mesh: this.number, picks: coordinates(picks), options };
    if (typeof field === "string") {
      options.field = field;
    } else if (field) {
      values.field = coordinates(field);
    }
    if (avoid) {
      values.avoid = ids(avoid);
    }
    if (start) {
      values.start = start.number;
    }
    return new Curve(call("curve.draw", values, progress), this, { field, avoid, ...options });
  }

  #fitted(values, progress) {
    const { curves, notes } = call("mesh.fit", { mesh: this.number, ...values }, progress);
    const { tension = 0 } = values.options;
    return {
      curves: curves.map((json) => {
        const { closed, degree, corners } = json;
        return new Curve(json, this, { closed, degree, tension, corners });
      }),
      notes,
    };
  }

  fit(line, { closed = false, progress, ...options } = {}) {
    return this.#fitted({ line: coordinates(line), closed, options }, progress).curves[0];
  }

  fit_boundary(faces, { labels, progress, ...options } = {}) {
    return this.#fitted(labels ? { labels: ids(labels), options } : { faces: ids(faces), options }, progress);
  }

  read_curves(name, bytes) {
    const { curves, notes } = call("curves.read", { mesh: this.number, name, bytes: new Uint8Array(bytes) });
    return { curves: curves.map((json) => new Curve(json, this, {})), notes };
  }

  field(kind = "maximal-curvature", { quality, region, progress, ...options } = {}) {
    const values = { mesh: this.number, options: { kind, ...options } };
    if (quality) {
      values.quality = coordinates(quality);
    }
    if (region) {
      values.region = ids(region);
    }
    return call("mesh.field", values, progress).values;
  }

  project(points) {
    return call("mesh.project", { mesh: this.number, points: coordinates(points) });
  }

  imprint(curves, { snap, progress } = {}) {
    const numbers = [curves].flat().map((curve) => curve.number);
    const options = snap === undefined ? {} : { snap };
    return new Imprint(call("curves.imprint", { curves: numbers, options }, progress));
  }

  cut(curves, { snap, ...options } = {}) {
    const imprint = this.imprint(curves, { snap });
    try {
      return imprint.cut(options);
    } finally {
      imprint.free();
    }
  }

  segment(curves, { snap, ...options } = {}) {
    const imprint = this.imprint(curves, { snap });
    try {
      return imprint.segment(options);
    } finally {
      imprint.free();
    }
  }

  save(name) {
    return call("mesh.save", { mesh: this.number, name }).bytes;
  }
}

// Tells the constructor that the mesh is there already.
class Answer {
  constructor(json) {
    this.json = json;
  }
}
