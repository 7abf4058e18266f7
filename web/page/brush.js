// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that are painted: those that are seen within a circle about the pointer and hang together with the face under it.

/** Radius in pixels of the pointer. */
const RADIUS = 14;

export class Brush {
  #vertices;
  #faces;
  #centres; // of faces
  #reach; // of faces: how far corners are from the centre
  #first; // of each vertex, where its faces begin in #around
  #around;
  #isPainted;
  count = 0;

  /** Linear in the number of faces. */
  constructor({ vertices, faces }) {
    this.#vertices = vertices;
    this.#faces = faces;
    const count = faces.length / 3;
    this.#isPainted = new Uint8Array(count);
    this.#centres = new Float64Array(3 * count);
    this.#reach = new Float64Array(count);
    for (let f = 0; f < count; ++f) {
      const corners = [0, 1, 2].map((i) => this.#corner(f, i));
      const centre = [0, 1, 2].map((axis) => (corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3);
      this.#centres.set(centre, 3 * f);
      this.#reach[f] = Math.max(...corners.map((corner) => Math.hypot(corner[0] - centre[0], corner[1] - centre[1], corner[2] - centre[2])));
    }
    this.#first = new Int32Array(vertices.length / 3 + 1);
    faces.forEach((vertex) => ++this.#first[vertex + 1]);
    for (let v = 0; v + 1 < this.#first.length; ++v) {
      this.#first[v + 1] += this.#first[v];
    }
    const next = this.#first.slice();
    this.#around = new Int32Array(faces.length);
    faces.forEach((vertex, corner) => {
      this.#around[next[vertex]++] = Math.floor(corner / 3);
    });
  }

  #corner(face, i) {
    const at = 3 * this.#faces[3 * face + i];
    return this.#vertices.subarray(at, at + 3);
  }

  /** How far a face's centre is along a ray, and squared beside it. */
  #placeOf(face, [sx, sy, sz], [dx, dy, dz]) {
    const x = this.#centres[3 * face] - sx, y = this.#centres[3 * face + 1] - sy, z = this.#centres[3 * face + 2] - sz;
    const along = x * dx + y * dy + z * dz;
    return [along, x * x + y * y + z * z - along * along];
  }

  /** Where a ray meets a face (T. Möller, B. Trumbore, 1997); infinite where it does not. */
  #meets(face, start, direction) {
    const [a, b, c] = [this.#corner(face, 0), this.#corner(face, 1), this.#corner(face, 2)];
    const minus = (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    const [first, second, from] = [minus(b, a), minus(c, a), minus(start, a)];
    const [across, beside] = [cross(direction, second), cross(from, first)];
    const size = dot(first, across);
    const [u, v, t] = [dot(from, across) / size, dot(direction, beside) / size, dot(second, beside) / size];
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : Infinity;
  }

  #under({ start, direction }) {
    let [least, under] = [Infinity, -1];
    for (let f = 0; f < this.#reach.length; ++f) {
      const [along, squared] = this.#placeOf(f, start, direction);
      if (squared <= this.#reach[f] ** 2 && along - this.#reach[f] < least) {
        const t = this.#meets(f, start, direction);
        [least, under] = t < least ? [t, f] : [least, under];
      }
    }
    return under;
  }

  // Twice the area, negative where the face is seen from the front.
  #facing(face, direction) {
    const [a, b, c] = [this.#corner(face, 0), this.#corner(face, 1), this.#corner(face, 2)];
    const [x1, y1, z1] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    const [x2, y2, z2] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    return (y1 * z2 - z1 * y2) * direction[0] + (z1 * x2 - x1 * z2) * direction[1] + (x1 * y2 - y1 * x2) * direction[2];
  }

  /** Paints, or unpaints, what is near to a ray; whether that met the mesh. Linear in the number of faces. */
  paint({ start, direction, pixel, removes }) {
    const seed = this.#under({ start, direction });
    if (seed < 0) {
      return false;
    }
    const side = Math.sign(this.#facing(seed, direction));
    const known = new Set([seed]);
    for (const face of known) { // which grows meanwhile
      this.#set(face, removes ? 0 : 1);
      for (let i = 0; i < 3; ++i) {
        const vertex = this.#faces[3 * face + i];
        for (const other of this.#facesAround(vertex)) {
          const [along, squared] = this.#placeOf(other, start, direction);
          if (squared <= (RADIUS * pixel * along) ** 2 && this.#facing(other, direction) * side > 0) {
            known.add(other);
          }
        }
      }
    }
    return true;
  }

  #facesAround(vertex) {
    return this.#around.subarray(this.#first[vertex], this.#first[vertex + 1]);
  }

  // Whether the painted faces about a vertex are more than one fan: its edges with one of them are more than two.
  #isPinch(vertex) {
    const edges = new Map();
    for (const face of this.#facesAround(vertex)) {
      for (let i = 0; i < 3 && this.#isPainted[face]; ++i) {
        const other = this.#faces[3 * face + i];
        edges.set(other, (edges.get(other) ?? 0) + 1);
      }
    }
    edges.delete(vertex);
    return [...edges.values()].filter((count) => count === 1).length > 2;
  }

  /** Paints all faces about vertices where painted ones touch at a point, so that their edge is made of single loops. */
  close() {
    const waiting = [...this.corners];
    while (waiting.length > 0) {
      const vertex = waiting.pop();
      if (this.#isPinch(vertex)) {
        for (const face of this.#facesAround(vertex)) {
          this.#set(face, 1);
          waiting.push(...this.#faces.subarray(3 * face, 3 * face + 3));
        }
      }
    }
  }

  #set(face, isPainted) {
    this.count += isPainted - this.#isPainted[face];
    this.#isPainted[face] = isPainted;
  }

  /** Their ids. */
  get painted() {
    const ids = new Int32Array(this.count);
    let at = 0;
    this.#isPainted.forEach((isPainted, face) => {
      if (isPainted) {
        ids[at++] = face;
      }
    });
    return ids;
  }

  /** Their vertices, three of each. */
  get corners() {
    const corners = new Uint32Array(3 * this.count);
    this.painted.forEach((face, i) => corners.set(this.#faces.subarray(3 * face, 3 * face + 3), 3 * i));
    return corners;
  }
}
