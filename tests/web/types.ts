// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled, not run: what people write has types.
import { Curve, init, InputError, Mesh, PICK_KINDS, Session, type Pieces } from "../../web/module/index.js";

export async function use(bytes: ArrayBuffer): Promise<Uint8Array> {
  await init("bspline_curve.wasm");
  const mesh: Mesh = Mesh.read("mesh.ply", bytes, { weld: 1e-6, progress: (fraction, stage) => stage !== "" && fraction < 1 });
  const curve: Curve = mesh.curve([[0, 0, 0], [1, 0, 0]], { closed: false, degree: 3, tension: 0.1, field: "ridge" });
  const cut: Pieces = mesh.cut([curve], { keep: "inside", fill: "smooth" });
  const values: Float64Array = cut.pieces[0].mesh.field("valley", { normalised: true });
  const session = new Session(mesh, { tension: 0.2 });
  session.event({ event: "press", start: [0, 0, 5], direction: [0, 0, -1], pixel: 0.01, strokes: true });
  session.set_kind(0, PICK_KINDS[session.state.curves[0].kinds[0]]);
  session.add_curves([{ picks: mesh.fit([[0, 0, 0], [1, 0, 0]], { deviation: "1 edges" }).pick_points(), corners: [1] }]);
  mesh.curve([], { corners: mesh.fit_boundary([0, 1]).curves[0].corners, tangents: { 2: [1, 0, 0] } });
  // @ts-expect-error: no such kind
  session.set_kind(0, "round");
  // @ts-expect-error: no such degree
  mesh.curve([], { degree: 5 });
  // @ts-expect-error: read-only
  curve.length = values.length;
  try {
    return curve.offset(0.1, "left")[0].save("offset.step", "mm");
  } catch (error) {
    throw error instanceof InputError ? new Error(`${error.code}: ${error.elements.join()}`) : error;
  }
}
