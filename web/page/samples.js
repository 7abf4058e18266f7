// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that are made: nothing is downloaded for them.

/** A grid of n by m points by a function of [0, 1) by [0, 1), closed in the directions that are said to be. */
function grid(n, m, closedU, closedV, point) {
  const vertices = new Float64Array(3 * n * m);
  for (let i = 0; i < n; ++i) {
    for (let j = 0; j < m; ++j) {
      vertices.set(point(i / (closedU ? n : n - 1), j / (closedV ? m : m - 1)), 3 * (i * m + j));
    }
  }
  const faces = [];
  for (let i = 0; i < n - (closedU ? 0 : 1); ++i) {
    for (let j = 0; j < m - (closedV ? 0 : 1); ++j) {
      const [i1, j1] = [(i + 1) % n, (j + 1) % m];
      const [a, b, c, d] = [i * m + j, i1 * m + j, i1 * m + j1, i * m + j1];
      faces.push(a, b, c, a, c, d);
    }
  }
  return { vertices, faces: Int32Array.from(faces) };
}

/** A sphere of a divided octahedron, moved along its normals by a function. */
function sphere(divisions, radius) {
  const ids = new Map();
  const vertices = [];
  const faces = [];
  const vertex = (x, y, z) => {
    const key = `${x},${y},${z}`;
    if (!ids.has(key)) {
      ids.set(key, ids.size);
      // Evenly spaced angles rather than coordinates: triangles of about one size.
      const angle = (value) => Math.sign(value) * Math.sin((Math.abs(value) / divisions) * (Math.PI / 2)) ** 1.0;
      const p = [angle(x), angle(y), angle(z)];
      const length = Math.hypot(...p);
      const unit = p.map((value) => value / length);
      const r = radius(...unit);
      vertices.push(...unit.map((value) => value * r));
    }
    return ids.get(key);
  };
  for (const sx of [1, -1]) {
    for (const sy of [1, -1]) {
      for (const sz of [1, -1]) {
        const at = (i, j) => vertex(sx * i, sy * j, sz * (divisions - i - j));
        const isTurned = sx * sy * sz < 0;
        const add = (a, b, c) => faces.push(...(isTurned ? [a, c, b] : [a, b, c]));
        for (let i = 0; i < divisions; ++i) {
          for (let j = 0; j < divisions - i; ++j) {
            add(at(i, j), at(i + 1, j), at(i, j + 1));
            if (i + j + 2 <= divisions) {
              add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
          }
        }
      }
    }
  }
  return { vertices: Float64Array.from(vertices), faces: Int32Array.from(faces) };
}

const TURN = 2 * Math.PI;

export const SAMPLES = {
  pebble: () =>
    sphere(56, (x, y, z) => 1 + 0.16 * Math.sin(3 * x + 1) * Math.cos(2.5 * y) + 0.12 * Math.cos(4 * z) - 0.2 * z * z),
  ring: () =>
    grid(160, 80, true, true, (u, v) => {
      const r = 0.35 + 0.03 * Math.sin(7 * TURN * u) * Math.cos(3 * TURN * v);
      const out = 1 + r * Math.cos(TURN * v);
      return [out * Math.cos(TURN * u), out * Math.sin(TURN * u), r * Math.sin(TURN * v)];
    }),
  hills: () =>
    grid(120, 120, false, false, (u, v) => {
      const [x, y] = [2 * u - 1, 2 * v - 1];
      const z = 0.18 * Math.sin(4 * x + 1) * Math.cos(3 * y) + 0.08 * Math.cos(7 * x - 3 * y) + 0.25 * Math.exp(-8 * (x * x + y * y));
      return [x, y, z];
    }),
};
