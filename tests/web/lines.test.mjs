// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth curves along lines, lines drawn freehand, and kinds of picks: the package in node, beside the program.
import assert from "node:assert/strict";
import { join } from "node:path";
import { before, test } from "node:test";

import { Brush } from "../../web/page/brush.js";
import { assertClose, dist, folder, meshes, picksOn, runProgram, SAME, write } from "./support.mjs";

const { init, InputError, Mesh, PICK_KINDS, Session } = await import(join(dist, "module/index.js"));

before(() => init());

let made;
function hills() {
  made ??= new Mesh(meshes.hills.vertices, meshes.hills.faces);
  return made;
}

/** Faces of the hills whose middle is within a radius of the origin. */
function round(radius) {
  const { vertices, faces } = hills();
  const middle = (face, axis) => [0, 1, 2].reduce((sum, i) => sum + vertices[3 * faces[3 * face + i] + axis] / 3, 0);
  return Array.from({ length: faces.length / 3 }, (_, face) => face).filter((face) => Math.hypot(middle(face, 0), middle(face, 1)) < radius);
}

const rows = (array) => Array.from({ length: array.length / 3 }, (_, i) => [...array.subarray(3 * i, 3 * i + 3)]);

test("fits are the program's: round faces, between labels, along lines", (t) => {
  const at = folder(t);
  const mesh = hills();
  write(at, "mesh.ply", mesh.save("mesh.ply"));
  const faces = round(0.5);
  write(at, "faces.txt", faces.join("\n"));
  const compare = (curve, words, what) => {
    const read = runProgram(at, "fit", "mesh.ply", ...words, "--output", "fit.json");
    const expected = JSON.parse(read("fit.json"));
    assertClose(curve.points, expected.polyline.points.flat(), SAME * mesh.diagonal, what);
    assertClose(curve.control_points, expected.spline.control_points.flat(), SAME * mesh.diagonal, what);
  };
  const [ring] = mesh.fit_boundary(faces).curves;
  assert.equal(ring.closed, true);
  compare(ring, ["--selection", "faces.txt"], "selection");
  compare(mesh.fit_boundary(faces, { deviation: "2 edges", degree: 4 }).curves[0],
    ["--selection", "faces.txt", "--deviation", "2 edges", "--degree", "4"], "deviation");

  const labels = new Int32Array(mesh.faces.length / 3);
  faces.forEach((face) => (labels[face] = 7));
  write(at, "labels.txt", labels.join("\n"));
  compare(mesh.fit_boundary(null, { labels }).curves[0], ["--labels", "labels.txt"], "labels");

  const line = picksOn(mesh, "hills");
  write(at, "line.obj", [...line.map((point) => `v ${point.join(" ")}`), "l 1 2 3 4"].join("\n"));
  compare(mesh.fit(line, { corner_angle: 180, deviation: "5 edges" }),
    ["--line", "line.obj", "--corner-angle", "180", "--deviation", "5 edges"], "line");
});

test("fits refuse what has no line", () => {
  const mesh = hills();
  const refused = (code, call) => assert.throws(call, (error) => error instanceof InputError && error.code === code);
  refused("no-path", () => mesh.fit_boundary([]));
  refused("index-out-of-range", () => mesh.fit_boundary([1e6]));
  refused("bad-option", () => mesh.fit_boundary(null, { labels: [1, 2] }));
  refused("bad-option", () => mesh.fit_boundary(round(0.5), { corner_angle: 0 }));
});

test("corners and tangents of curves are the program's", (t) => {
  const at = folder(t);
  const mesh = hills();
  const picks = picksOn(mesh, "hills");
  write(at, "mesh.ply", mesh.save("mesh.ply"));
  write(at, "picks.json", JSON.stringify({ picks }));
  const read = runProgram(at, "mesh.ply", "--picks", "picks.json", "--corners", "2", "--tangents", "3: 0, 1, 0", "--output", "c.json");
  const curve = mesh.curve(picks, { corners: [1], tangents: { 2: [0, 1, 0] } });
  assertClose(curve.points, JSON.parse(read("c.json")).polyline.points.flat(), SAME * mesh.diagonal, "the curve");
  assert.deepEqual([...curve.corners], [1]);
  const sides = runProgram(at, "mesh.ply", "--picks", "picks.json", "--corners", "2", "--tangents", "2: any/0, 1, 0", "--output", "s.json");
  const free = mesh.curve(picks, { corners: [1], tangents: { 1: [null, [0, 1, 0]] } });
  assertClose(free.points, JSON.parse(sides("s.json")).polyline.points.flat(), SAME * mesh.diagonal, "the curve with a direction after its corner");
});

// ---- Drawing

/** A ray down onto the hills. */
function above(x, y, more) {
  return { start: [x, y, 5], direction: [0, 0, -1], pixel: 0.002, ...more };
}

function click(session, x, y) {
  session.event({ event: "press", ...above(x, y) });
  session.event({ event: "release", ...above(x, y) });
}

function drag(session, places, more) {
  session.event({ event: "press", ...above(...places[0], more) });
  places.slice(1).forEach((place) => session.event({ event: "move", ...above(...place, more) }));
  session.event({ event: "release", ...above(...places.at(-1), more) });
}

function drawn() {
  const session = new Session(hills(), { handles: 40 });
  [[-0.6, -0.5], [0.1, -0.6], [0.6, 0.3], [-0.2, 0.6]].forEach((place) => click(session, ...place));
  session.settle();
  return session;
}

test("a line drawn freehand becomes a smooth curve of few picks", () => {
  const session = new Session(hills());
  const wave = Array.from({ length: 120 }, (_, i) => [-0.6 + i / 100, 0.3 * Math.sin(i / 20)]);
  session.event({ event: "press", ...above(...wave[0], { strokes: true }) });
  wave.forEach((place) => session.event({ event: "move", ...above(...place, { strokes: true }) }));
  assert.ok(session.state.stroke.length > 3 * 40);
  session.event({ event: "release", ...above(...wave.at(-1), { strokes: true }) });
  assert.equal(session.state.stroke.length, 0);
  session.settle();
  const [{ points, picks, settled }] = session.state.curves;
  assert.equal(settled, true);
  assert.ok(picks.length / 3 >= 4 && picks.length / 3 <= 24, `${picks.length / 3} picks`);
  for (const [x, y] of rows(points)) {
    const near = Math.min(...wave.map(([u, v]) => Math.hypot(u - x, v - y)));
    assert.ok(near < 0.04, `${near} beside the line`);
  }
  session.undo();
  assert.equal(session.state.curves.length, 0);
  session.free();
});

test("a line from a curve to itself replaces the stretch between", () => {
  const session = drawn();
  const before = session.state.curves[0];
  const [first, , third, fourth] = rows(before.picks);
  const arc = Array.from({ length: 60 }, (_, i) => {
    const s = i / 59;
    return [first[0] + s * (third[0] - first[0]) + 0.3 * Math.sin(Math.PI * s), first[1] + s * (third[1] - first[1]) - 0.3 * Math.sin(Math.PI * s)];
  });
  drag(session, arc, { strokes: true });
  session.settle();
  assert.equal(session.state.curves.length, 1);
  const now = session.state.curves[0];
  assert.equal(now.id, before.id);
  assertClose(now.picks.slice(0, 3), first, 1e-12, "the first pick stays");
  assertClose(now.picks.slice(-3), fourth, 1e-12, "the last pick stays");
  const nearest = (curve, [x, y]) => Math.min(...rows(curve.points).map((point) => Math.hypot(point[0] - x, point[1] - y)));
  assert.ok(nearest(now, arc[30]) < 0.05 && nearest(before, arc[30]) > 0.1);
  session.undo();
  session.settle();
  assert.deepEqual(session.state.curves[0].points, before.points);
  session.free();
});

test("picks become corners, and get a direction that a handle turns", () => {
  const session = drawn();
  const kinds = () => [...session.state.curves[0].kinds].map((kind) => PICK_KINDS[kind]);
  session.select(0, 1);
  assert.deepEqual(kinds(), ["automatic", "automatic", "automatic", "automatic"]);
  const smooth = session.state.curves[0].points;
  session.set_kind(1, "corner");
  session.settle();
  assert.equal(kinds()[1], "corner");
  assert.notDeepEqual(session.state.curves[0].points, smooth);

  const next = () => session.event({ event: "key", key: "kind", ...above(0, 0) });
  next();
  session.settle();
  const free = session.state.curves[0];
  assert.equal(kinds()[1], "free");
  assert.notDeepEqual(free.tangents.subarray(3, 6), free.tangents_before.subarray(3, 6));
  const reopened = new Session(hills());
  reopened.open("drawing.json", session.save("drawing.json"));
  reopened.settle();
  assert.deepEqual(reopened.state.curves[0].points, free.points);
  reopened.free();
  next();
  assert.equal(kinds()[1], "automatic");
  next();
  session.settle();
  assert.equal(kinds()[1], "aligned");
  const [tangent, pick] = [session.state.curves[0].tangents, session.state.curves[0].picks].map((values) => [...values.subarray(3, 6)]);
  assert.ok(Math.abs(Math.hypot(...tangent) - 1) < 1e-9);
  assert.equal(Math.hypot(...session.state.curves[0].normals.subarray(3, 6)).toFixed(9), "1.000000000");

  // The handle ahead is 40 pixels from the pick, as it is seen from above, which looks down to it.
  const depth = 5 - pick[2];
  const reach = 40 * 0.002 * depth;
  const handle = [pick[0] + reach * tangent[0], pick[1] + reach * tangent[1]];
  session.event({ event: "move", ...above(...handle) });
  assert.equal(session.state.hovered.handle, 1);
  drag(session, [handle, [pick[0], pick[1] + 0.2], [pick[0], pick[1] + 0.3]]);
  session.settle();
  const turned = session.state.curves[0].tangents.subarray(3, 6);
  assert.ok(turned[1] > 0.5 && Math.abs(turned[0]) < 1e-6, String(turned)); // as seen from above
  assert.deepEqual([...session.state.curves[0].picks.subarray(3, 6)], pick);

  // Saved and opened it is the same.
  const again = new Session(hills());
  again.open("drawing.json", session.save("drawing.json"));
  again.settle();
  assert.deepEqual(again.state.curves[0].tangents, session.state.curves[0].tangents);
  assert.deepEqual(again.state.curves[0].points, session.state.curves[0].points);
  again.free();
  session.free();
});

test("curves are added with corners, tangents and a leeway, as one step", () => {
  const session = new Session(hills());
  const picks = picksOn(hills(), "hills");
  session.add_curves([
    { picks, corners: [2], pick_tolerance: "2 edges" },
    { picks, tangents: [[0, 0, 0], [1, 0, 0], [0, 0, 0], [0, 0, 0]] },
  ]);
  session.settle();
  const [first, second] = session.state.curves;
  assert.deepEqual([...first.kinds], [0, 0, 2, 0]);
  assert.deepEqual([...second.kinds], [0, 1, 0, 0]);
  assert.ok(first.leeway > 0 && second.leeway === 0);
  session.undo();
  assert.equal(session.state.curves.length, 0);
  session.free();
});

// ---- Painting faces

/** A flat grid of n by n squares, each of two faces: 2 (n i + j), below its diagonal, and the next. */
function flat(n) {
  const vertices = [];
  const faces = [];
  for (let i = 0; i <= n; ++i) {
    for (let j = 0; j <= n; ++j) {
      vertices.push(i, j, 0);
      if (i < n && j < n) {
        const a = (n + 1) * i + j;
        faces.push(a, a + n + 1, a + n + 2, a, a + n + 2, a + 1);
      }
    }
  }
  return { vertices: Float64Array.from(vertices), faces: Int32Array.from(faces) };
}

test("the brush paints what is seen about the pointer, and wipes it", () => {
  const brush = new Brush(flat(20));
  const ray = { start: [10.3, 10.1, 100], direction: [0, 0, -1], pixel: 3 / 14 / 100 }; // of radius 3 there
  assert.equal(brush.paint(ray), true);
  const area = brush.count / 2;
  assert.ok(area > 0.8 * 9 * Math.PI && area < 1.2 * 9 * Math.PI, `${area}`);
  assert.equal(brush.painted.length, brush.count);
  assert.equal(brush.corners.length, 3 * brush.count);
  assert.equal(brush.paint({ ...ray, start: [30, 10, 100] }), false);
  brush.paint({ ...ray, removes: true });
  assert.equal(brush.count, 0);
  // The far side of a sheet that is folded back is not painted through it.
  const [near, far] = [flat(2), flat(2)];
  const both = {
    vertices: Float64Array.from([...near.vertices, ...far.vertices.map((value, i) => (i % 3 === 2 ? -1 : value))]),
    faces: Int32Array.from([...near.faces, ...far.faces.map((vertex) => vertex + near.vertices.length / 3)]),
  };
  const two = new Brush(both);
  two.paint({ ...ray, start: [1.1, 1.05, 100], pixel: 1 });
  assert.deepEqual([...two.painted], [0, 1, 2, 3, 4, 5, 6, 7]);
});

test("painted faces that touch at a point are joined there", () => {
  const brush = new Brush(flat(4));
  const small = { direction: [0, 0, -1], pixel: 1e-9 };
  brush.paint({ start: [1.2, 1.7, 9], ...small }); // of the squares (1, 1) and (2, 2), which have the corner (2, 2)
  brush.paint({ start: [2.7, 2.2, 9], ...small });
  assert.equal(brush.count, 2);
  brush.close();
  assert.equal(brush.count, 6, "all round that corner");
});
