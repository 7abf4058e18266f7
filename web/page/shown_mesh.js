// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays that a graphics card takes: floats about the middle, so that meshes far from the origin keep their shape.
import { partColour } from "./colours.js";

function boxOf(vertices) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < vertices.length; ++i) {
    const axis = i % 3;
    low[axis] = Math.min(low[axis], vertices[i]);
    high[axis] = Math.max(high[axis], vertices[i]);
  }
  return { low, high };
}

/** Normals of vertices: sums of those of faces, by area. */
function normalsOf(positions, faces) {
  const normals = new Float32Array(positions.length);
  for (let f = 0; f < faces.length; f += 3) {
    const [a, b, c] = [3 * faces[f], 3 * faces[f + 1], 3 * faces[f + 2]];
    const ux = positions[b] - positions[a], uy = positions[b + 1] - positions[a + 1], uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a], vy = positions[c + 1] - positions[a + 1], vz = positions[c + 2] - positions[a + 2];
    const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    for (const at of [a, b, c]) {
      normals[at] += nx;
      normals[at + 1] += ny;
      normals[at + 2] += nz;
    }
  }
  return normals; // the card makes them unit vectors
}

/** Of values of vertices, 3 of each, those of the 3 corners of each face. */
export function atCorners(values, faces) {
  const corners = new values.constructor(3 * faces.length);
  for (let i = 0; i < faces.length; ++i) {
    const at = 3 * faces[i];
    corners[3 * i] = values[at];
    corners[3 * i + 1] = values[at + 1];
    corners[3 * i + 2] = values[at + 2];
  }
  return corners;
}

// Faces of parts look different at one vertex: corners of their own.
function cornersOf(positions, normals, faces, labels) {
  const tints = new Uint8Array(3 * faces.length);
  for (let i = 0; i < faces.length; ++i) {
    tints.set(partColour(labels[Math.floor(i / 3)]), 3 * i);
  }
  return { positions: atCorners(positions, faces), normals: atCorners(normals, faces), tints };
}

/**
 * @param {import("bspline-curve").Mesh} mesh
 * @param {Int32Array | null} labels a part of each face, to be told by colours
 */
export function shownMesh({ vertices, faces, colours, texture_coordinates: texture }, labels) {
  const { low, high } = boxOf(vertices);
  const middle = low.map((value, axis) => (value + high[axis]) / 2);
  const positions = new Float32Array(vertices.length);
  for (let i = 0; i < vertices.length; ++i) {
    positions[i] = vertices[i] - middle[i % 3];
  }
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3) {
    squared = Math.max(squared, positions[i] ** 2 + positions[i + 1] ** 2 + positions[i + 2] ** 2);
  }
  const radius = Math.sqrt(squared) || 1;
  const normals = normalsOf(positions, faces);
  return {
    positions, normals, faces: new Uint32Array(faces), colours, labels, middle, radius,
    corners: labels && cornersOf(positions, normals, faces, labels),
    uv: texture && Float32Array.from(texture), // of corners
  };
}
