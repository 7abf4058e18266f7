// SPDX-License-Identifier: GPL-3.0-or-later
// The package bspline-curve in node, beside the program.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";

import { assertClose, assertSameText, corpus, dist, folder, meshes, picksOn, runProgram, SAME, write } from "./support.mjs";

const { Curve, init, InputError, Mesh, Session } = await import(join(dist, "module/index.js"));
const { memoryBytes } = await import(join(dist, "module/instance.js"));

before(() => init());

const made = {};
function meshOf(name) {
  made[name] ??= new Mesh(meshes[name].vertices, meshes[name].faces);
  return made[name];
}

/** The program's curve on a mesh, in a folder that has the mesh as mesh.ply. */
function programsCurve(at, name, picks, options, output) {
  write(at, "mesh.ply", meshOf(name).save("mesh.ply"));
  write(at, "picks.json", JSON.stringify({ picks }));
  const words = Object.entries(options).flatMap(([id, value]) =>
    value === true ? [`--${id}`] : [`--${id.replaceAll("_", "-")}`, String(value)],
  );
  return runProgram(at, "mesh.ply", "--picks", "picks.json", "--output", output, ...words)(output);
}

const kinds = [
  {}, { closed: true }, { degree: 2 }, { closed: true, degree: 4 }, { tension: 0.3 }, { pick_tolerance: "1 edges" },
  { closed: true, tension: 0.8 }, { samples: 40 }, { field: "ridge" },
];

for (const name of Object.keys(meshes)) {
  test(`curves on ${name} are the program's`, (t) => {
    const at = folder(t);
    const mesh = meshOf(name);
    const picks = picksOn(mesh, name);
    for (const options of kinds) {
      const expected = JSON.parse(programsCurve(at, name, picks, options, "curve.json"));
      const curve = mesh.curve(picks, options);
      const what = JSON.stringify(options);
      assertClose(curve.points, expected.polyline.points.flat(), SAME * mesh.diagonal, what);
      assert.deepEqual([...curve.faces], expected.polyline.faces, what);
      assertClose(curve.control_points, expected.spline.control_points.flat(), SAME * mesh.diagonal, what);
      assert.equal(curve.closed, options.closed ?? false);
      assert.equal(curve.usable, true);
      curve.free();
    }
  });
}

test("files of curves are the program's", (t) => {
  const at = folder(t);
  const picks = picksOn(meshOf("ring"), "ring");
  const curve = meshOf("ring").curve(picks, { closed: true });
  for (const name of ["c.json", "c.obj", "c.bspline.obj", "c.dxf", "c.bspline.dxf", "c.csv", "c.step", "c.polyline.step"]) {
    const expected = programsCurve(at, "ring", picks, { closed: true }, name).toString();
    // The header of STEP names the time.
    const timeless = (text) => text.replace(/\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d/g, "TIME");
    assertSameText(timeless(Buffer.from(curve.save(name)).toString()), timeless(expected), 2 * SAME * meshOf("ring").diagonal, name);
  }
  const ply = programsCurve(at, "ring", picks, { closed: true }, "c.ply");
  assert.equal(curve.save("c.ply").length, ply.length);
});

test("what is made of curves is the program's", (t) => {
  const at = folder(t);
  const mesh = meshOf("pebble");
  const picks = picksOn(mesh, "pebble");
  programsCurve(at, "pebble", picks, { closed: true }, "curve.json");
  const curve = mesh.curve(picks, { closed: true });
  const compare = (made, file, what) => {
    const expected = Mesh.read(file, read(file), { slits: true });
    assertClose(made.vertices, expected.vertices, SAME * mesh.diagonal, what);
    assert.deepEqual(made.faces, expected.faces, what);
    expected.free();
  };
  let read = runProgram(at, "imprint", "mesh.ply", "--curve", "curve.json", "--output", "imprint.ply");
  const imprint = mesh.imprint(curve);
  compare(imprint.mesh(), "imprint.ply", "imprint");
  assert.equal(imprint.parts.length, 2);
  for (const [keep, fill] of [["all", "none"], ["largest", "none"], ["inside", "flat"], ["outside", "smooth"]]) {
    read = runProgram(at, "cut", "mesh.ply", "--curve", "curve.json", "--keep", keep, "--fill", fill, "--output", "cut.ply");
    compare(imprint.cut({ keep, fill }).pieces[0].mesh, "cut.ply", `cut ${keep} ${fill}`);
  }
  const solids = [
    [{ keep: "inside", thickness: 0.05 }, ["--keep", "inside", "--thickness", "0.05"]],
    [{ keep: "inside", base: 0.2 }, ["--keep", "inside", "--base", "0.2"]],
    [{ keep: "largest", relief: -0.03 }, ["--keep", "largest", "--relief", "-0.03"]],
    [{ keep: "inside", relief: 0.04, profile: "ramp" }, ["--keep", "inside", "--relief", "0.04", "--profile", "ramp"]],
  ];
  for (const [options, words] of solids) {
    read = runProgram(at, "cut", "mesh.ply", "--curve", "curve.json", ...words, "--output", "solid.ply");
    compare(imprint.cut(options).pieces[0].mesh, "solid.ply", words.join(" "));
  }
  assert.throws(() => imprint.cut({ stroke: 0.1 }), InputError);
  const segments = imprint.segment();
  assert.deepEqual([...new Set(segments.pieces[0].labels)].sort(), [0, 1]);
  read = runProgram(at, "offset", "mesh.ply", "--curve", "curve.json", "--distance", "0.1", "--side", "left", "--output", "offset.json");
  const [offset] = curve.offset(0.1, "left");
  assertClose(offset.points, JSON.parse(read("offset.json")).polyline.points.flat(), SAME * mesh.diagonal, "offset");
});

test("meshes come back from their files", () => {
  const mesh = meshOf("hills");
  for (const name of ["m.ply", "m.obj", "m.off"]) {
    const again = Mesh.read(name, mesh.save(name));
    assert.deepEqual(again.vertices, mesh.vertices, name);
    assert.deepEqual(again.faces, mesh.faces, name);
    again.free();
  }
  const stl = Mesh.read("m.STL", mesh.save("m.stl"));
  assert.equal(stl.faces.length, mesh.faces.length);
});

test("colours of files are there, and go where faces go", () => {
  const text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
    "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\nproperty list uchar int vertex_indices\n" +
    "end_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 9 9\n3 0 1 2\n3 0 2 3\n";
  const mesh = Mesh.read("c.ply", new TextEncoder().encode(text));
  assert.deepEqual([...mesh.colours.subarray(0, 6)], [255, 0, 0, 0, 255, 0]);
  const curve = mesh.curve([[0.2, 0, 0], [1, 0.7, 0]]);
  const cut = mesh.imprint(curve).mesh();
  assert.equal(cut.colours.length, cut.vertices.length);
});

test("curves come back from their files exactly", () => {
  const mesh = meshOf("ring");
  const curve = mesh.curve(picksOn(meshOf("ring"), "ring"), { closed: true });
  const { curves, notes } = mesh.read_curves("c.json", curve.save("c.json"));
  assert.equal(curves.length, 1);
  assert.deepEqual(curves[0].points, curve.points);
  assert.deepEqual(notes, []);
  const both = mesh.read_curves("b.json", Curve.save([curve, curve], "b.json"));
  assert.equal(both.curves.length, 2);
});

test("a dragged pick is solved from the curve before, near to the one from scratch", () => {
  const mesh = meshOf("hills");
  const picks = picksOn(meshOf("hills"), "hills");
  const moved = picks.map((pick, i) => (i === 1 ? [...mesh.project([0.25, -0.58, 0]).points] : pick));
  const dragged = mesh.curve(picks).move(1, moved[1]);
  const scratch = mesh.curve(moved);
  assert.ok(Math.abs(dragged.length - scratch.length) < 1e-3 * scratch.length);
});

test("errors have the core's words", () => {
  const mesh = meshOf("ring");
  const refused = (code, words, call) =>
    assert.throws(call, (error) => error instanceof InputError && error.code === code && words.test(error.message));
  refused("too-few-picks", /at least 2/, () => mesh.curve([[1, 0, 0.3]]));
  refused("pick-too-far", /pick 2/, () => mesh.curve([[1.38, 0, 0], [9, 9, 9]]));
  refused("bad-option", /tension/, () => mesh.curve([], { tension: 2 }));
  refused("bad-option", /no option tensoin/, () => mesh.curve([], { tensoin: 1 }));
  refused("bad-option", /degree/, () => mesh.curve([], { degree: "three" }));
  refused("index-out-of-range", /outside/, () => new Mesh([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 7]));
  refused("unwritable-file", /extension|written/, () => mesh.save("mesh.xyz"));
  refused("unreadable-file", /extension/, () => Mesh.read("mesh.3mf", new Uint8Array(8)));
  refused("no-path", /part nothing/, () => mesh.cut(mesh.curve(picksOn(mesh, "ring").slice(0, 2)), { keep: "largest" }));
  assert.throws(() => new Mesh([NaN, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]), InputError);
});

test("what is freed is known to be", () => {
  const mesh = new Mesh(meshes.ring.vertices, meshes.ring.faces);
  mesh.free();
  assert.throws(() => mesh.save("m.ply"), /freed/);
});

test("progress is told, and gives up", () => {
  let calls = 0;
  const mesh = new Mesh(meshes.pebble.vertices, meshes.pebble.faces, { progress: () => ++calls });
  assert.ok(calls > 3);
  assert.throws(
    () => mesh.field("ridge", { progress: () => false }),
    (error) => error.code === "cancelled",
  );
  mesh.free();
});

// ---- Bad files

const FORMATS = { ply: ".ply", obj: ".obj", off: ".off", stl: ".stl" };

test("bad files are refused in one line or read, and leave the module alive", () => {
  let refusals = 0;
  let files = 0;
  const attempt = (call) => {
    ++files;
    try {
      call()?.free?.();
    } catch (error) {
      ++refusals;
      assert.ok(error instanceof InputError, String(error.stack));
      assert.ok(!["internal", "crashed"].includes(error.code), error.message);
      assert.match(error.message, /^[^\n]{8,}$/);
    }
  };
  const mesh = meshOf("hills");
  for (const kind of readdirSync(corpus)) {
    for (const name of readdirSync(join(corpus, kind))) {
      const bytes = readFileSync(join(corpus, kind, name));
      for (const extension of kind in FORMATS ? [FORMATS[kind]] : [".ply", ".obj", ".stl", ".off"]) {
        attempt(() => Mesh.read(`bad${extension}`, bytes));
      }
      for (const extension of [".json", ".dxf", ".obj", ".ply", ".csv", ".vtu"]) {
        attempt(() => void mesh.read_curves(`bad${extension}`, bytes));
        attempt(() => {
          const session = new Session(mesh);
          try {
            session.open(`bad${extension}`, bytes);
          } finally {
            session.free();
          }
        });
      }
    }
  }
  assert.ok(files > 100 && refusals > 50, `${refusals} of ${files}`);
  assert.equal(mesh.curve(picksOn(meshOf("hills"), "hills")).usable, true);
});

// ---- Drawing

/** A ray down onto the hills. */
function above(x, y) {
  return { start: [x, y, 5], direction: [0, 0, -1], pixel: 0.002 };
}

function click(session, x, y) {
  assert.equal(session.event({ event: "press", ...above(x, y) }), true);
  session.event({ event: "release", ...above(x, y) });
  session.settle();
}

test("a drawing is clicked, dragged, closed, undone, saved and opened", () => {
  const mesh = meshOf("hills");
  const session = new Session(mesh);
  const places = [[-0.6, -0.5], [0.2, -0.6], [0.6, 0.3], [-0.2, 0.6]];
  places.forEach(([x, y]) => click(session, x, y));
  assert.equal(session.state.curves.length, 1);
  assert.equal(session.state.curves[0].picks.length, 12);
  const open = session.state.curves[0].points;

  // The same curve as by picks.
  assert.deepEqual(session.curve(0).points, mesh.curve(session.state.curves[0].picks).points);

  // A drag: while it goes on there are curves, in the end the one from scratch.
  session.event({ event: "press", ...above(...places[1]) });
  session.event({ event: "move", ...above(0.25, -0.5) });
  session.update();
  assert.equal(session.state.dragging, true);
  session.event({ event: "move", ...above(0.3, -0.4) });
  session.update();
  session.event({ event: "release", ...above(0.3, -0.4) });
  session.settle();
  assert.ok(Math.abs(session.state.curves[0].picks[3] - 0.3) < 1e-9);
  session.undo();
  session.settle();
  assert.deepEqual(session.state.curves[0].points, open);
  session.redo();

  // A click on the first pick closes it.
  click(session, ...places[0]);
  assert.equal(session.state.curves[0].options.closed, true);
  session.set_options({ ...session.state.curves[0].options, tension: 0.4, degree: 4 });
  session.set_look(0, { name: "rim", colour: [1, 2, 3] });
  session.settle();
  const points = session.state.curves[0].points;
  const bytes = session.save("drawing.json");
  const again = new Session(mesh);
  assert.deepEqual(again.open("drawing.json", bytes), []);
  again.settle();
  const [curve] = again.state.curves;
  assert.deepEqual(curve.points, points);
  assert.deepEqual([curve.name, curve.colour, curve.options.tension], ["rim", [1, 2, 3], 0.4]);
  assert.match(Buffer.from(session.save_picks("picks.pp")).toString(), /<point/i);
  session.free();
  again.free();
});

test("what the surface does not take is the camera's", () => {
  const session = new Session(meshOf("hills"));
  assert.equal(session.event({ event: "press", ...above(3, 3) }), false);
  session.free();
});

test("a curve that cannot be says why", () => {
  const two = { ...meshes.hills };
  const shifted = Float64Array.from(two.vertices, (value, i) => value + (i % 3 === 0 ? 4 : 0));
  const vertices = Float64Array.from([...two.vertices, ...shifted]);
  const count = two.vertices.length / 3;
  const faces = Int32Array.from([...two.faces, ...two.faces.map((id) => id + count)]);
  const session = new Session(new Mesh(vertices, faces));
  click(session, 0, 0);
  click(session, 4, 0);
  assert.match(session.state.curves[0].problem.message, /component/);
  session.free();
});

// BSPLINE_CURVE_ROUNDS: how many, of a mesh and 100 curves each.
test("memory is steady", () => {
  const round = () => {
    const mesh = new Mesh(meshes.ring.vertices, meshes.ring.faces);
    const picks = picksOn(mesh, "ring");
    for (let i = 0; i < 100; ++i) {
      mesh.curve(picks, { closed: i % 2 === 0 }).free();
    }
    mesh.free();
  };
  round();
  round();
  const first = memoryBytes();
  for (let i = 0; i < Number(process.env.BSPLINE_CURVE_ROUNDS ?? 4); ++i) {
    round();
  }
  assert.equal(memoryBytes(), first);
});
