// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays that a graphics card takes: floats about the middle, so that meshes far from the origin keep their shape.

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
  return {
    positions, normals: normalsOf(positions, faces), faces: new Uint32Array(faces), colours, labels, middle, radius,
    uv: texture && Float32Array.from(texture), // of corners
  };
}
