// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth B-spline curves on triangle meshes. Names are those of the Python package.
export { init } from "./instance.js";
export { InputError } from "./errors.js";
export { Mesh } from "./mesh.js";
export { Curve } from "./curve.js";
export { Imprint } from "./imprint.js";
export { PICK_KINDS, Session } from "./session.js";
