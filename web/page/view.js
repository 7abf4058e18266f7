// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen: the mesh, the curves, their picks. Drawn only when something changed.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, ColorManagement, DirectionalLight, DoubleSide, LinearSRGBColorSpace, Mesh,
  MeshLambertMaterial, Points, Scene, ShaderMaterial, Texture, WebGLRenderer,
} from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";

import { Camera } from "./camera.js";
import { partColour, valueColour } from "./colours.js";

// Colours are shown as they are in the file.
ColorManagement.enabled = false;

const CURVE_WIDTH = 3.5; // pixels
const PREVIEW_WIDTH = 2;
const LINE_WIDTH = 2.5;
const PICK_SIZE = 12;
const SELECTED_SIZE = 17;

// Round points of fixed size, a little in front of the surface that they lie on.
function pointMaterial(scale) {
  return new ShaderMaterial({
    vertexShader: `attribute vec3 colour; attribute float size; varying vec3 shown;
      void main() {
        shown = colour;
        // Nearer to the viewer, so at the same place of the view.
        gl_Position = projectionMatrix * vec4(0.985 * (modelViewMatrix * vec4(position, 1.0)).xyz, 1.0);
        gl_PointSize = size * ${scale.toFixed(3)};
      }`,
    fragmentShader: `varying vec3 shown;
      void main() {
        float r = length(gl_PointCoord - 0.5);
        if (r > 0.5) { discard; }
        gl_FragColor = vec4(r > 0.38 ? vec3(1.0) : shown, 1.0);
      }`,
  });
}

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
  #picks = null;
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
        this.#renderer.render(this.#scene, this.camera.three);
      });
    }
  }

  // ---- The mesh

  show(shown, lines) {
    const isNew = !this.#shown || this.#shown.radius !== shown.radius || this.#shown.middle.some((value, i) => value !== shown.middle[i]);
    this.#shown = shown;
    this.#showSurface();
    this.#lines.forEach((line) => this.#remove(line));
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
      color: 0xffffff, vertexColors: true, map: isTextured ? this.#texture : null, side: DoubleSide,
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

  #geometry({ positions, normals, faces, colours, labels, uv }, isTextured) {
    const geometry = new BufferGeometry();
    if (labels || isTextured) { // faces look different at one vertex: corners of their own
      const count = faces.length;
      const [corners, directions] = [new Float32Array(3 * count), new Float32Array(3 * count)];
      const tints = new Uint8Array(3 * count).fill(255);
      for (let i = 0; i < count; ++i) {
        const at = 3 * faces[i];
        corners.set(positions.subarray(at, at + 3), 3 * i);
        directions.set(normals.subarray(at, at + 3), 3 * i);
        if (labels) {
          tints.set(partColour(labels[Math.floor(i / 3)]), 3 * i);
        }
      }
      geometry.setAttribute("position", new BufferAttribute(corners, 3));
      geometry.setAttribute("normal", new BufferAttribute(directions, 3));
      geometry.setAttribute("color", new BufferAttribute(tints, 3, true));
      if (isTextured) {
        geometry.setAttribute("uv", new BufferAttribute(uv, 2));
      }
      return geometry;
    }
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    geometry.setIndex(new BufferAttribute(faces, 1));
    geometry.setAttribute("color", new BufferAttribute(colours ?? new Uint8Array(positions.length).fill(205), 3, true));
    return geometry;
  }

  /** Colours the mesh by a value in [0, 1] of each vertex; null: as it was. */
  colourBy(values) {
    if (!this.#shown || this.#shown.labels || !this.#mesh.geometry.index) {
      return;
    }
    const tints = new Uint8Array(this.#shown.positions.length);
    if (values) {
      values.forEach((value, i) => tints.set(valueColour(value), 3 * i));
    } else {
      tints.set(this.#shown.colours ?? tints.fill(205));
    }
    this.#mesh.geometry.setAttribute("color", new BufferAttribute(tints, 3, true));
    this.draw();
  }

  #remove(object) {
    if (object) {
      this.#scene.remove(object);
      object.geometry.dispose();
      object.material.dispose();
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
    const line = new Line2(geometry, new LineMaterial({ color: new Color(...colour.map((c) => c / 255)), linewidth: width }));
    line.frustumCulled = false;
    return line;
  }

  /** What is drawn, as the session tells it. */
  showDrawing({ curves, active, selected, hovered, preview }) {
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
    before.forEach(({ line }) => this.#remove(line));
    this.#remove(this.#preview);
    this.#preview = null;
    if (preview && active >= 0) {
      this.#preview = this.#line(preview, curves[active].options.closed, [140, 140, 150], PREVIEW_WIDTH);
      this.#scene.add(this.#preview);
    }
    this.#showPicks(curves, active, selected, hovered);
    this.draw();
  }

  #showPicks(curves, active, selected, hovered) {
    this.#remove(this.#picks);
    const [positions, colours, sizes] = [[], [], []];
    curves.forEach((curve, c) => {
      const count = curve.hidden ? 0 : curve.picks.length / 3;
      for (let i = 0; i < count; ++i) {
        const isBad = curve.problem && (curve.problem.picks.length === 0 || curve.problem.picks.includes(i));
        const isChosen = (c === active && i === selected) || (c === hovered.curve && i === hovered.pick);
        positions.push(...curve.picks.subarray(3 * i, 3 * i + 3));
        colours.push(...(isBad ? [0.9, 0, 0] : c === active ? [0.1, 0.12, 0.15] : [0.5, 0.53, 0.57]));
        sizes.push(isChosen ? SELECTED_SIZE : PICK_SIZE);
      }
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(this.#local(positions), 3));
    geometry.setAttribute("colour", new BufferAttribute(Float32Array.from(colours), 3));
    geometry.setAttribute("size", new BufferAttribute(Float32Array.from(sizes), 1));
    this.#picks = new Points(geometry, pointMaterial(Math.min(devicePixelRatio, 2)));
    this.#picks.frustumCulled = false;
    this.#scene.add(this.#picks);
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

  /** Where a point of the mesh is on the canvas, in pixels. */
  placeOf(point) {
    const at = this.#picks.position.clone().fromArray(this.#local(point)).project(this.camera.three);
    return [((at.x + 1) / 2) * this.#canvas.clientWidth, ((1 - at.y) / 2) * this.#canvas.clientHeight];
  }

  picture() {
    this.#renderer.render(this.#scene, this.camera.three);
    return new Promise((done) => this.#canvas.toBlob(done, "image/png"));
  }
}
