// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen: the mesh, the curves, their picks. Drawn only when something changed.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, ColorManagement, DirectionalLight, DoubleSide, LinearSRGBColorSpace, Mesh,
  MeshBasicMaterial, MeshLambertMaterial, Scene, Sphere, Texture, Vector3, WebGLRenderer,
} from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";

import { Camera } from "./camera.js";
import { Glyphs } from "./glyphs.js";
import { lineMaterial } from "./line_materials.js";
import { atCorners } from "./shown_mesh.js";

// Colours are shown as they are in the file.
ColorManagement.enabled = false;

const CURVE_WIDTH = 3.5; // pixels
const PREVIEW_WIDTH = 2;
const LINE_WIDTH = 2.5;
const STROKE_COLOUR = [120, 60, 160];
const PAINT = { color: 0xffa000, transparent: true, opacity: 0.55, depthWrite: false, side: DoubleSide };
export class View {
  camera = new Camera();
  #canvas;
  #renderer;
  #scene = new Scene();
  #light = new DirectionalLight(0xffffff, 2.0);
  #mesh = null;
  #shown = null; // arrays of the mesh
  #texture = null;
  #curves = new Map(); // Line2 of each, by id
  #lines = [];
  #preview = null;
  #stroke = null;
  #painted = null; // faces
  #glyphs = new Glyphs(this.#scene);
  #isWaiting = false;

  constructor(canvas) {
    this.#canvas = canvas;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.#renderer.outputColorSpace = LinearSRGBColorSpace;
    this.#scene.add(new AmbientLight(0xffffff, 1.2), this.camera.three, this.#light.target);
    this.camera.three.add(this.#light);
    this.#light.position.set(0.4, 0.6, 1);
    new ResizeObserver(() => this.#resize()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#theme());
    this.#theme();
    this.#resize();
  }

  #theme() {
    this.#scene.background = new Color(getComputedStyle(document.documentElement).getPropertyValue("--view").trim());
    this.draw();
  }

  #resize() {
    const { clientWidth, clientHeight } = this.#canvas;
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.camera.resize(clientWidth, clientHeight);
    this.draw();
  }

  /** Soon, once for all that changes meanwhile. */
  draw() {
    if (!this.#isWaiting) {
      this.#isWaiting = true;
      requestAnimationFrame(() => {
        this.#isWaiting = false;
        this.#render();
      });
    }
  }

  #render() {
    this.#glyphs.place(this.camera);
    this.#renderer.render(this.#scene, this.camera.three);
  }

  // ---- The mesh

  show(shown, lines) {
    const isNew = !this.#shown || this.#shown.radius !== shown.radius || this.#shown.middle.some((value, i) => value !== shown.middle[i]);
    this.#shown = shown;
    this.#showSurface();
    this.paint(null);
    this.#lines.forEach((line) => this.#removeLine(line));
    this.#lines = lines.map(({ points, closed }) => this.#line(points, closed, [0x1d, 0x6f, 0xb8], LINE_WIDTH));
    this.#lines.forEach((line) => this.#scene.add(line));
    if (isNew) {
      this.camera.fit(shown.radius, true);
    }
    this.draw();
  }

  #showSurface() {
    this.#remove(this.#mesh);
    const isTextured = this.#texture !== null && this.#shown.uv !== null && this.#shown.labels === null;
    this.#mesh = new Mesh(this.#geometry(this.#shown, isTextured), new MeshLambertMaterial({
      color: 0xffffff, vertexColors: true, map: isTextured ? this.#texture : null, side: DoubleSide, flatShading: this.#shown.isSharp,
      polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 4, // lines lie on it
    }));
    this.#scene.add(this.#mesh);
    this.draw();
  }

  /** An image that meshes with texture coordinates are covered with; null: none. */
  setTexture(image) {
    this.#texture?.dispose();
    this.#texture = image && Object.assign(new Texture(image), { needsUpdate: true, flipY: false });
    if (this.#shown) {
      this.#showSurface();
    }
  }

  #geometry({ positions, normals, faces, colours, corners, uv, radius }, isTextured) {
    const geometry = new BufferGeometry();
    const set = (name, values, size, isNormalised = false) =>
      geometry.setAttribute(name, new BufferAttribute(values, size, isNormalised));
    if (corners) {
      set("position", corners.positions, 3);
      set("normal", corners.normals, 3);
      set("color", corners.tints, 3, true);
    } else if (isTextured) {
      set("position", atCorners(positions, faces), 3);
      set("normal", atCorners(normals, faces), 3);
      set("color", new Uint8Array(3 * faces.length).fill(255), 3, true);
      set("uv", uv, 2);
    } else {
      set("position", positions, 3);
      set("normal", normals, 3);
      set("color", colours ?? new Uint8Array(positions.length).fill(205), 3, true);
      geometry.setIndex(new BufferAttribute(faces, 1));
    }
    geometry.boundingSphere = new Sphere(new Vector3(), radius);
    return geometry;
  }

  /** Colours the mesh by 3 numbers of each vertex, 0 to 255; null: as it was. */
  colourBy(tints) {
    if (!this.#shown || this.#shown.labels || !this.#mesh.geometry.index) {
      return;
    }
    const colours = tints ?? this.#shown.colours ?? new Uint8Array(this.#shown.positions.length).fill(205);
    this.#mesh.geometry.setAttribute("color", new BufferAttribute(colours, 3, true));
    this.draw();
  }

  /** Faces that are chosen, three ids of vertices of each; null: none. */
  paint(faces) {
    if (!faces) {
      this.#remove(this.#painted);
      this.#painted = null;
    } else {
      if (!this.#painted) {
        const geometry = new BufferGeometry();
        geometry.setAttribute("position", new BufferAttribute(this.#shown.positions, 3));
        geometry.boundingSphere = new Sphere(new Vector3(), this.#shown.radius);
        geometry.setIndex(new BufferAttribute(new Uint32Array(this.#shown.faces.length), 1));
        this.#painted = new Mesh(geometry, new MeshBasicMaterial(PAINT));
        this.#scene.add(this.#painted);
      }
      const { index } = this.#painted.geometry;
      index.array.set(faces);
      index.clearUpdateRanges();
      index.addUpdateRange(0, faces.length);
      index.needsUpdate = true;
      this.#painted.geometry.setDrawRange(0, faces.length);
    }
    this.draw();
  }

  #remove(object) {
    this.#removeLine(object);
    object?.material.dispose();
  }

  // Whose material is kept.
  #removeLine(object) {
    if (object) {
      this.#scene.remove(object);
      object.geometry.dispose();
    }
  }

  // ---- Curves

  #local(points) {
    const { middle } = this.#shown;
    return Float32Array.from(points, (value, i) => value - middle[i % 3]);
  }

  #line(points, isClosed, colour, width) {
    const local = this.#local(points);
    const all = isClosed ? Float32Array.from([...local, ...local.subarray(0, 3)]) : local;
    const geometry = new LineGeometry();
    geometry.setPositions(all);
    const line = new Line2(geometry, lineMaterial(colour, width));
    line.frustumCulled = false;
    return line;
  }

  /** What is drawn, as the session tells it. */
  showDrawing(drawing) {
    const { curves, active, preview, stroke } = drawing;
    if (!this.#shown) {
      return;
    }
    const before = this.#curves;
    this.#curves = new Map();
    for (const curve of curves) {
      const known = before.get(curve.id);
      if (known && known.curve === curve) {
        this.#curves.set(curve.id, known);
        before.delete(curve.id);
      } else if (!curve.hidden && curve.points.length >= 6) {
        const colour = curve.usable ? curve.colour : [150, 20, 160];
        const line = this.#line(curve.points, curve.options.closed, colour, CURVE_WIDTH);
        this.#scene.add(line);
        this.#curves.set(curve.id, { curve, line });
      }
    }
    before.forEach(({ line }) => this.#removeLine(line));
    this.#removeLine(this.#preview);
    this.#preview = null;
    if (preview && active >= 0) {
      this.#preview = this.#line(preview, curves[active].options.closed, [140, 140, 150], PREVIEW_WIDTH);
      this.#scene.add(this.#preview);
    }
    this.#removeLine(this.#stroke);
    this.#stroke = stroke.length >= 6 ? this.#line(stroke, false, STROKE_COLOUR, PREVIEW_WIDTH) : null;
    if (this.#stroke) {
      this.#scene.add(this.#stroke);
    }
    this.#glyphs.show(drawing, (points) => this.#local(points));
    this.draw();
  }

  // ---- Between the view and the mesh

  get faceCount() {
    return this.#shown.faces.length / 3;
  }

  fit() {
    if (this.#shown) {
      this.camera.fit(this.#shown.radius);
      this.draw();
    }
  }

  /** The ray through a place of the canvas in pixels, as the session takes it. */
  rayAt(x, y) {
    const { clientWidth, clientHeight } = this.#canvas;
    const { start, direction } = this.camera.rayThrough((2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight);
    const middle = this.#shown?.middle ?? [0, 0, 0];
    return { start: start.map((value, i) => value + middle[i]), direction, pixel: this.camera.pixel };
  }

  /** Pixels of the view that are one of the pointer's: fingers have large ones. */
  setPointerScale(scale) {
    if (scale !== this.#glyphs.pointerScale) {
      this.#glyphs.pointerScale = scale;
      this.draw();
    }
  }

  /** Where the handles of the selected pick's direction are on the canvas, in pixels. */
  get handles() {
    return this.#glyphs.handlePlaces(this.camera).map((place) => this.#onCanvas(place));
  }

  /** Where a point of the mesh is on the canvas, in pixels. */
  placeOf(point) {
    return this.#onCanvas(new Vector3().fromArray(this.#local(point)));
  }

  #onCanvas(place) {
    const at = place.project(this.camera.three);
    return [((at.x + 1) / 2) * this.#canvas.clientWidth, ((1 - at.y) / 2) * this.#canvas.clientHeight];
  }

  picture() {
    this.#render();
    return new Promise((done) => this.#canvas.toBlob(done, "image/png"));
  }
}
