// SPDX-License-Identifier: GPL-3.0-or-later
// Browsers compile twice: quickly, and well what was called often. Curves that nobody sees are drawn while people look
// for their mesh, so that the first one that they see comes as quickly as the next.
import { Mesh } from "bspline-curve";

import { SAMPLES } from "./samples.js";

const CURVES = 24;

/** Ends as soon as `isNeeded` says that there is other work. */
export async function warmUp(isNeeded) {
  const { vertices, faces } = SAMPLES.pebble();
  const mesh = new Mesh(vertices, faces);
  const picks = mesh.project([[0.9, 0.1, 0.2], [0.1, 0.9, 0.3], [-0.9, 0.2, 0.4], [0.3, -0.9, 0.1]]).points;
  for (let i = 0; i < CURVES && !isNeeded(); ++i) {
    mesh.curve(picks, { closed: i % 2 === 0 }).free();
    await new Promise((done) => setTimeout(done)); // requests come between
  }
  mesh.free();
}
