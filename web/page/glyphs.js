// SPDX-License-Identifier: GPL-3.0-or-later
// Picks and what belongs to them: their kinds by shape, how far the curve may pass from soft ones, and the handles of
// the selected one's direction.
import { BufferAttribute, BufferGeometry, Points, ShaderMaterial, Vector3 } from "three";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

import { HANDLE_PIXELS } from "./handle_pixels.js";
import { lineMaterial } from "./line_materials.js";

const PICK_SIZE = 12; // pixels
const SELECTED_SIZE = 17;
const HANDLE_SIZE = 11;
const DISC_CORNERS = 48;
const DISC_WIDTH = 1.5;
const DISC_COLOUR = [138, 109, 0];
const HANDLE_COLOUR = [217, 140, 0];
/** Glyphs are nearer to the viewer than the surface that they lie on. */
const LIFT = 0.985;
const AUTOMATIC = 0; // number of a kind

// Points of fixed size: discs of automatic picks, diamonds of those with a direction, squares of corners.
function pointMaterial(scale) {
  return new ShaderMaterial({
    vertexShader: `attribute vec3 colour; attribute float size; attribute float shape; varying vec3 shown; varying float form;
      void main() {
        shown = colour;
        form = shape;
        // Nearer to the viewer, so at the same place of the view.
        gl_Position = projectionMatrix * vec4(${LIFT} * (modelViewMatrix * vec4(position, 1.0)).xyz, 1.0);
        gl_PointSize = size * ${scale.toFixed(3)};
      }`,
    fragmentShader: `varying vec3 shown; varying float form;
      void main() {
        vec2 at = abs(gl_PointCoord - 0.5);
        float r = form > 1.5 ? 1.1 * max(at.x, at.y) : form > 0.5 ? at.x + at.y : length(at);
        if (r > 0.5) { discard; }
        gl_FragColor = vec4(r > 0.38 ? vec3(1.0) : shown, 1.0);
      }`,
  });
}

const material = pointMaterial(Math.min(devicePixelRatio, 2));

function pointsOf(positions, colours, sizes, shapes) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setAttribute("colour", new BufferAttribute(Uint8Array.from(colours), 3, true));
  geometry.setAttribute("size", new BufferAttribute(Float32Array.from(sizes), 1));
  geometry.setAttribute("shape", new BufferAttribute(Float32Array.from(shapes), 1));
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  return points;
}

function segmentsOf(positions, colour, width) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(positions);
  const segments = new LineSegments2(geometry, lineMaterial(colour, width));
  segments.frustumCulled = false;
  return segments;
}

// A circle about a point in the plane with this normal, as segments.
function circle(centre, normal, radius) {
  const axis = Math.abs(normal.x) < 0.6 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
  const first = axis.cross(normal).normalize().multiplyScalar(radius);
  const second = normal.clone().cross(first);
  const at = (i) => {
    const angle = (2 * Math.PI * i) / DISC_CORNERS;
    return centre.clone().addScaledVector(first, Math.cos(angle)).addScaledVector(second, Math.sin(angle)).toArray();
  };
  return Array.from({ length: DISC_CORNERS }, (_, i) => [...at(i), ...at(i + 1)]).flat();
}

export class Glyphs {
  #scene;
  #shown = [];
  #lifted = []; // of these
  #handles = null; // { pick, ways, line, ends }: their place depends on the view
  /** Pixels of the view that are one of the pointer's. */
  pointerScale = 1;

  constructor(scene) {
    this.#scene = scene;
  }

  #add(object) {
    this.#scene.add(object);
    this.#shown.push(object);
    return object;
  }

  /** @param {(points: ArrayLike<number>) => Float32Array} local about the middle of the mesh */
  show({ curves, active, selected, hovered }, local) {
    for (const object of this.#shown.splice(0)) {
      this.#scene.remove(object);
      object.geometry.dispose();
    }
    this.#handles = null;
    this.#lifted = [];
    const all = curves.map((curve) => ({ ...curve, places: curve.hidden ? [] : local(curve.picks) }));
    if (active >= 0 && !all[active].hidden) {
      this.#showDiscs(all[active]);
      this.#showHandles(all[active], selected, hovered.handle);
    }
    this.#showPicks(all, active, selected, hovered);
  }

  #showPicks(curves, active, selected, hovered) {
    const [positions, colours, sizes, shapes] = [[], [], [], []];
    curves.forEach(({ places, kinds, problem }, c) => {
      positions.push(...places);
      for (let i = 0; i < places.length / 3; ++i) {
        const isBad = problem && (problem.picks.length === 0 || problem.picks.includes(i));
        const isChosen = (c === active && i === selected) || (c === hovered.curve && i === hovered.pick && !hovered.handle);
        colours.push(...(isBad ? [230, 0, 0] : c === active ? [26, 31, 38] : [128, 135, 145]));
        sizes.push(isChosen ? SELECTED_SIZE : PICK_SIZE);
        shapes.push(kinds[i]);
      }
    });
    this.#add(pointsOf(positions, colours, sizes, shapes));
  }

  // Round each pick that the curve need not pass, how far from it that may be.
  #showDiscs({ places, kinds, normals, leeway }) {
    const at = (values, i) => new Vector3().fromArray(values, 3 * i);
    const soft = leeway > 0 ? [...kinds.keys()].filter((i) => kinds[i] === AUTOMATIC) : [];
    if (soft.length > 0) {
      const segments = soft.flatMap((i) => circle(at(places, i), at(normals, i), leeway));
      this.#lifted.push(this.#add(segmentsOf(segments, DISC_COLOUR, DISC_WIDTH)));
    }
  }

  #showHandles({ places, tangents, tangents_before }, selected, hovered) {
    const wayOf = (values, side) => new Vector3().fromArray(values, 3 * selected).normalize().multiplyScalar(side);
    const ways = selected < 0 ? [] : [wayOf(tangents, 1), wayOf(tangents_before, -1)];
    if (ways.some((way) => way.lengthSq() > 0)) {
      const sizes = ways.map((way, i) => (way.lengthSq() > 0 ? HANDLE_SIZE * (hovered === (i ? -1 : 1) ? 1.4 : 1) : 0));
      this.#handles = {
        pick: new Vector3().fromArray(places, 3 * selected), ways,
        line: this.#add(segmentsOf(new Array(12).fill(0), HANDLE_COLOUR, 2)),
        ends: this.#add(pointsOf([0, 0, 0, 0, 0, 0], [...HANDLE_COLOUR, ...HANDLE_COLOUR], sizes, [0, 0])),
      };
      this.#lifted.push(this.#handles.line);
    }
  }

  /** Where the handles are about the middle of the mesh, the one ahead first, at the pick where its side has none; empty: none has. */
  handlePlaces(camera) {
    if (!this.#handles) {
      return [];
    }
    const { pick, ways } = this.#handles;
    const reach = HANDLE_PIXELS * this.pointerScale * camera.pixel * camera.three.position.distanceTo(pick);
    return ways.map((way) => pick.clone().addScaledVector(way, reach));
  }

  /** To be called before each picture. */
  place(camera) {
    for (const { position, scale } of this.#lifted) { // about the viewer, so to the same place of the view
      position.copy(camera.three.position).multiplyScalar(1 - LIFT);
      scale.setScalar(LIFT);
    }
    if (this.#handles) {
      const ends = this.handlePlaces(camera).map((end) => end.toArray());
      const { position } = this.#handles.ends.geometry.attributes;
      position.array.set(ends.flat());
      position.needsUpdate = true;
      const pick = this.#handles.pick.toArray();
      this.#handles.line.geometry.setPositions(ends.flatMap((end) => [...pick, ...end]));
    }
  }
}
