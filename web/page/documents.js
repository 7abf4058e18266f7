// SPDX-License-Identifier: GPL-3.0-or-later
// What people work on: meshes one after the other, each made of the one before, with the drawing on each. Undo goes
// back through the drawing, then to the mesh before.
import { Curve, Session } from "bspline-curve";

import { Brush } from "./brush.js";
import { HANDLE_PIXELS } from "./handle_pixels.js";

/** Undo leads back over so many meshes at most: each has its tree, some hundred bytes a face. */
const MOST_MESHES = 20;

export class Documents {
  #all = [];
  #position = -1;
  #options = {}; // of new curves

  get count() {
    return this.#all.length;
  }

  get now() {
    return this.#all[this.#position];
  }

  get canUndo() {
    return Boolean(this.now) && (this.now.session.state.can_undo || this.#position > 0);
  }

  get canRedo() {
    return Boolean(this.now) && (this.now.session.state.can_redo || this.#position + 1 < this.#all.length);
  }

  /** A mesh of a file or of a sample: all before is freed. */
  begin(mesh, source) {
    this.#free(this.#all.splice(0));
    this.#position = -1;
    return this.#add({ mesh, source, lines: [], labels: null, session: this.#session(mesh), isSharp: false });
  }

  #session(mesh) {
    return new Session(mesh, { ...this.#options, handles: HANDLE_PIXELS });
  }

  /** Of the active curve and of new ones, also of meshes to come. */
  setOptions(options, live) {
    this.#options = { ...options, closed: false };
    this.now?.session.set_options(options, { live });
  }

  /** What people work on; throws where there is nothing yet. */
  get here() {
    if (!this.now) {
      throw new Error("Open a mesh first.");
    }
    return this.now;
  }

  /** What was made of it; `isSharp`: it has edges to be seen; `keepsCurves`: they are drawn on it anew. */
  push({ mesh = this.now.mesh, labels = null, lines = [], keepsCurves = true, isSharp = this.now.isSharp }) {
    const before = this.now;
    const session = this.#session(mesh);
    if (keepsCurves && before.session.state.curves.length > 0) {
      session.open("drawing.json", before.session.save("drawing.json"), { first: true });
    }
    const source = mesh === before.mesh ? before.source : { vertices: mesh.vertices, faces: mesh.faces };
    return this.#add({ mesh, source, lines, labels, session, isSharp });
  }

  #add(document) {
    this.dropUndone();
    this.#all.push(document);
    this.#free(this.#all.splice(0, this.#all.length - MOST_MESHES));
    this.#position = this.#all.length - 1;
    return document;
  }

  /** What redo would lead to, once something else is done. */
  dropUndone() {
    this.#free(this.#all.splice(this.#position + 1));
  }

  // Several may have lines and a mesh in common, with each other and with those that stay.
  #free(documents) {
    documents.forEach(({ session }) => session.free());
    for (const line of new Set(documents.flatMap(({ lines }) => lines))) {
      if (!this.#isShared(line)) {
        line.free();
      }
    }
    for (const each of new Set(documents.map(({ mesh }) => mesh))) {
      if (!this.#all.some(({ mesh }) => mesh === each)) {
        each.free();
      }
    }
  }

  #isShared(line) {
    return this.#all.some(({ lines }) => lines.includes(line));
  }

  /** Whether another mesh is to be shown. */
  undo() {
    if (this.now.session.state.can_undo) {
      this.now.session.undo();
      return false;
    }
    if (this.#position > 0) {
      --this.#position;
      return true;
    }
    return false;
  }

  redo() {
    if (this.now.session.state.can_redo) {
      this.now.session.redo();
      return false;
    }
    if (this.#position + 1 < this.#all.length) {
      ++this.#position;
      return true;
    }
    return false;
  }

  // ---- Uses

  /** The curves that can be used; throws what is wrong where there is none. */
  #curves() {
    const { session } = this.here;
    session.settle();
    const usable = session.state.curves.flatMap((curve, i) => (curve.hidden || curve.points.length === 0 ? [] : [i]));
    if (usable.length === 0) {
      throw new Error(session.state.curves.find(({ problem }) => problem)?.problem.message ?? "Draw a curve first.");
    }
    return usable.map((i) => session.curve(i));
  }

  #imprinted(curves, use, progress) {
    const imprint = this.now.mesh.imprint(curves, { progress });
    try {
      return use(imprint);
    } finally {
      imprint.free();
    }
  }

  use(kind, options, progress) {
    const curves = this.#curves();
    try {
      return this[`use_${kind}`](curves, options, progress);
    } finally {
      curves.forEach((curve) => curve.free());
    }
  }

  use_imprint(curves, _options, progress) {
    return this.#imprinted(curves, (imprint) => {
      const before = this.now.mesh.faces.length / 3;
      this.push({ mesh: imprint.mesh() });
      return [`The curves are edges: ${before} faces became ${this.now.mesh.faces.length / 3}.`];
    }, progress);
  }

  use_segment(curves, _options, progress) {
    return this.#imprinted(curves, (imprint) => {
      const { pieces, notes } = imprint.segment({ progress });
      this.push({ mesh: pieces[0].mesh, labels: pieces[0].labels });
      const count = imprint.parts.length;
      const areas = imprint.parts.slice(0, 6).map(({ area }) => area.toPrecision(4));
      return [`${count} parts; areas: ${areas.join(", ")}${count > 6 ? " …" : ""}.`, ...notes];
    }, progress);
  }

  /** `solid`: what parts become by `height`, in per cent of the diagonal: thickness, base, relief; empty: nothing. */
  use_cut(curves, { keep, fill, solid, height }, progress) {
    const size = (height / 100) * this.now.mesh.diagonal;
    if (solid && size === 0) {
      throw new Error("Give a height other than 0.");
    }
    if (solid === "relief" && keep === "all") {
      throw new Error("Choose at Keep which parts the relief moves.");
    }
    return this.#imprinted(curves, (imprint) => {
      const { pieces, notes, filled_holes, dropped } = imprint.cut({ keep, progress, ...(solid ? { [solid]: size } : { fill }) });
      const [first, ...others] = pieces;
      others.forEach(({ mesh }) => mesh.free());
      this.push({ mesh: first.mesh, labels: keep === "all" ? first.labels : null, keepsCurves: false, isSharp: solid !== "" });
      const kept = first.parts.length;
      const holes = filled_holes ? ` ${filled_holes} ${filled_holes === 1 ? "hole was" : "holes were"} filled.` : "";
      const parts = kept === 1 ? "part" : "parts";
      return [solid === "relief" ? "The relief is made." : `${kept} ${parts} kept, ${dropped.length} left out.${holes}`, ...notes];
    }, progress);
  }

  use_offset(curves, { distance, side }, progress) {
    const length = (distance / 100) * this.now.mesh.diagonal;
    const lines = curves.flatMap((curve) => curve.offset(length, side, { progress }));
    this.push({ lines: [...this.now.lines, ...lines], labels: this.now.labels });
    return [`${lines.length} ${lines.length === 1 ? "curve" : "curves"} at a distance of ${length.toPrecision(4)}.`];
  }

  // ---- Faces that are painted, and smooth curves along lines

  /** Whether a ray met the mesh. */
  paint(rays) {
    const { here } = this;
    here.brush ??= new Brush(here.mesh);
    return rays.map((ray) => here.brush.paint(ray)).includes(true);
  }

  #smoothed(of, options, { name, bytes }) {
    const { mesh, brush, labels } = this.here;
    if (of === "parts") {
      if (!labels) {
        throw new Error("The mesh has no parts yet: draw curves and press Segment.");
      }
      return mesh.fit_boundary(null, { labels, ...options });
    }
    if (of === "painted") {
      if (!brush?.count) {
        throw new Error("Paint some faces first.");
      }
      brush.close();
      return mesh.fit_boundary(brush.painted, options);
    }
    const { curves: lines, notes } = mesh.read_curves(name, bytes);
    try {
      return { curves: lines.map(({ points, closed }) => mesh.fit(points, { closed, ...options })), notes };
    } finally {
      lines.forEach((line) => line.free());
    }
  }

  /** Draws along what is painted, between parts, or along the lines of a file. */
  smooth(of, { degree, tension, deviation }, file, progress) {
    const { curves, notes } = this.#smoothed(of, { degree, tension, deviation, progress }, file);
    this.dropUndone();
    this.now.session.add_curves(curves.map((curve) => ({
      ...this.#options, picks: curve.pick_points(), corners: curve.corners, closed: curve.closed, degree, tension,
      field: "none", pick_tolerance: "0",
    })));
    curves.forEach((curve) => curve.free());
    const points = curves.reduce((sum, { picks }) => sum + picks.length, 0);
    return [`${curves.length} smooth ${curves.length === 1 ? "curve" : "curves"} through ${points} points.`, ...notes];
  }

  // ---- Files

  /** The bytes of a file of all curves; drawings can be gone on with. */
  saveCurves(name) {
    const { session, lines } = this.here;
    if (name.endsWith(".pp")) {
      return session.save_picks(name);
    }
    if (name === "drawing.json" && lines.length === 0) {
      session.settle();
      return session.save(name);
    }
    const curves = lines.length > 0 && session.state.curves.length === 0 ? [] : this.#curves();
    try {
      return Curve.save([...curves, ...lines], name);
    } finally {
      curves.forEach((curve) => curve.free());
    }
  }
}
