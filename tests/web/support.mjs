// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the module share: meshes that are made, and the program to compare with.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { SAMPLES } from "../../web/page/samples.js";

const root = join(import.meta.dirname, "../..");
export const program = process.env.BSPLINE_CURVE_PROGRAM ?? join(root, "build/release/bin/bspline_curve");
export const corpus = join(root, "tests/fuzz/corpus");
export const dist = join(root, "build/web/dist");

/** Relative to the diagonal: another C library and no fused multiply-adds leave less than this. */
export const SAME = 1e-9;

/** Beside vertices of a mesh. */
function beside({ vertices }, ids) {
  return ids.map((id) => [0.031, 0.0217, -0.0124].map((shift, axis) => vertices[3 * id + axis] + shift));
}

const ring = SAMPLES.ring();

function around(count, height) {
  return Array.from({ length: count }, (_, i) => [Math.cos(1.1 * i + 0.217), Math.sin(1.1 * i + 0.217), height + 0.07 * i]);
}

/**
 * Meshes, and points near to which picks are. None of these is at a vertex or on an edge: there the first path, and with
 * it the sixth digit of a curve, depends on the last bit of the pick.
 */
export const meshes = {
  pebble: { ...SAMPLES.pebble(), near: around(5, 0.213) },
  ring: { ...ring, near: beside(ring, [5, 3000, 6100, 9000, 11000]) },
  hills: { ...SAMPLES.hills(), near: [[-0.613, -0.507, 0], [0.217, -0.611, 0], [0.623, 0.313, 0], [-0.203, 0.617, 0]] },
};

/** The picks of one of these, on the mesh. */
export function picksOn(mesh, name) {
  const { points } = mesh.project(meshes[name].near);
  return meshes[name].near.map((_, i) => [...points.subarray(3 * i, 3 * i + 3)]);
}

/** A folder for the time of a test. */
export function folder(test) {
  const path = mkdtempSync(join(tmpdir(), "bspline-curve-web-"));
  test.after(() => rmSync(path, { recursive: true }));
  return path;
}

/** Runs the program in a folder; the paths that files written there have. */
export function runProgram(at, ...options) {
  execFileSync(program, options, { cwd: at, stdio: ["ignore", "ignore", "pipe"] });
  return (name) => readFileSync(join(at, name));
}

export function write(at, name, content) {
  writeFileSync(join(at, name), content);
}

/** Whether two arrays of numbers are the same but for rounding. */
export function assertClose(actual, expected, tolerance, what) {
  assert.equal(actual.length, expected.length, `${what}: counts differ`);
  let worst = 0;
  for (let i = 0; i < actual.length; ++i) {
    worst = Math.max(worst, Math.abs(actual[i] - expected[i]));
  }
  assert.ok(worst <= tolerance, `${what}: differ by ${worst}, more than ${tolerance}`);
}

const NUMBER = /[-+]?\d+(?:\.\d*)?(?:[eEdD][-+]?\d+)?/g;

/** Whether two texts are the same but for rounding of their numbers. */
export function assertSameText(actual, expected, tolerance, what) {
  assert.equal(actual.replace(NUMBER, "0"), expected.replace(NUMBER, "0"), `${what}: words differ`);
  const numbers = (text) => (text.match(NUMBER) ?? []).map((word) => Number(word.replace(/[dD]/, "e")));
  assertClose(numbers(actual), numbers(expected), tolerance, what);
}
