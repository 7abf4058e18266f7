// SPDX-License-Identifier: GPL-3.0-or-later
// The page in headless Chromium: lines drawn freehand, kinds of picks, soft picks, painted faces, lines of files.
import assert from "node:assert/strict";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";
import { after, before, describe, test } from "node:test";

import { openPage, startBrowser, withoutBrowser } from "./browser.mjs";
import { folder, meshes, runProgram, write } from "./support.mjs";

const PICKS = [[0.42, 0.42], [0.52, 0.36], [0.6, 0.45], [0.58, 0.58], [0.46, 0.6]];

describe("lines on the page", { skip: withoutBrowser }, () => {
  let browser;
  before(async () => {
    browser = await startBrowser();
  });
  after(() => browser.close());

  async function drawn(options) {
    const seen = await openPage(browser, options);
    await seen.sample("pebble");
    for (const [x, y] of PICKS) {
      await seen.click(x, y);
    }
    return seen;
  }

  /** Where shares of the canvas's width and height are on the window. */
  async function places(seen, shares) {
    const { left, top, width, height } = await seen.page.$eval("#canvas", (canvas) => canvas.getBoundingClientRect().toJSON());
    return shares.map(([x, y]) => [left + x * width, top + y * height]);
  }

  async function drag(seen, way, milliseconds = 0) {
    await seen.page.mouse.move(...way[0]);
    await seen.page.mouse.down();
    for (const place of way.slice(1)) {
      await pause(milliseconds);
      await seen.page.mouse.move(...place);
    }
    await seen.page.mouse.up();
    await seen.settled();
  }

  const round = (count, turn) => Array.from({ length: count + 1 }, (_, i) => {
    const angle = (turn * 2 * Math.PI * i) / count;
    return [0.5 + 0.13 * Math.cos(angle), 0.5 + 0.17 * Math.sin(angle)];
  });

  /** The colour of the picture at a place of the canvas. */
  const colourAt = (seen, place) => seen.page.evaluate(async ([x, y]) => {
    const bitmap = await createImageBitmap(await globalThis.curves.view.picture());
    const scale = bitmap.width / document.getElementById("canvas").clientWidth;
    const context = new OffscreenCanvas(1, 1).getContext("2d");
    context.drawImage(bitmap, Math.round(scale * x), Math.round(scale * y), 1, 1, 0, 0, 1, 1);
    return [...context.getImageData(0, 0, 1, 1).data];
  }, place);

  test("are drawn freehand, and replace the stretch where they begin and end at a curve", async () => {
    const seen = await openPage(browser);
    await seen.sample("pebble");
    await seen.page.keyboard.down("Shift");
    await drag(seen, await places(seen, round(60, 1)));
    await seen.page.keyboard.up("Shift");
    const first = (await seen.drawing()).curves[0];
    assert.equal(first.options.closed, true);
    assert.ok(first.picks.length / 3 >= 4 && first.picks.length / 3 <= 24, `${first.picks.length / 3} picks`);
    await seen.picture("freehand");

    // By the button: a bulge in place of a stretch.
    await seen.page.click("#freehand");
    const bulge = round(60, 0.2).map(([x, y], i) => [x + 0.05 * Math.sin((Math.PI * i) / 60), y]);
    await drag(seen, await places(seen, bulge));
    const now = await seen.drawing();
    assert.equal(now.curves.length, 1);
    assert.ok(now.curves[0].length > first.length);
    await seen.picture("replaced");
    await seen.press("#undo");
    assert.deepEqual((await seen.drawing()).curves[0].picks, first.picks);
    await seen.press("#undo");
    assert.equal((await seen.drawing()).curves.length, 0);

    // A click with the button down adds a point, as without.
    await seen.click(0.5, 0.5);
    assert.equal((await seen.drawing()).curves[0].picks.length, 3);
    await seen.end();
  });

  test("are drawn freehand by a finger on a screen of 390 pixels", async () => {
    const seen = await openPage(browser, { width: 390, height: 780, touch: true });
    await seen.page.tap("[data-sample=pebble]");
    await seen.page.waitForFunction(() => globalThis.curves.drawing);
    await seen.settled();
    await seen.page.tap("#freehand");
    const way = await places(seen, round(30, 0.7).map(([x, y]) => [0.5 + 1.6 * (x - 0.5), y]));
    const finger = await seen.page.touchscreen.touchStart(...way[0]);
    for (const place of way.slice(1)) {
      await finger.move(...place);
    }
    await finger.end();
    await seen.settled();
    const { curves } = await seen.drawing();
    assert.equal(curves.length, 1);
    assert.equal(curves[0].options.closed, false);
    await seen.picture("phone freehand");
    await seen.end();
  });

  test("turn at corners, and pass picks in the direction of their handles", async () => {
    const seen = await drawn();
    await seen.page.mouse.click(...(await seen.placeOf(0, 2)));
    await seen.settled();
    const smooth = (await seen.drawing()).curves[0];
    await seen.page.select("#kind", "corner");
    await seen.settled();
    const turned = (await seen.drawing()).curves[0];
    assert.equal(turned.kinds[2], 2);
    assert.notDeepEqual(turned.points, smooth.points);
    assert.deepEqual(turned.picks, smooth.picks);
    await seen.picture("corner");

    await seen.page.focus("#canvas");
    await seen.page.keyboard.press("t");
    await seen.settled();
    assert.equal((await seen.drawing()).curves[0].kinds[2], 3);
    await seen.picture("corner-with-directions");
    await seen.page.keyboard.press("t");
    await seen.page.keyboard.press("t");
    await seen.settled();
    const aligned = (await seen.drawing()).curves[0];
    assert.equal(aligned.kinds[2], 1);
    assert.equal(await seen.page.$eval("#kind", ({ value }) => value), "aligned");
    const [handle, other] = await seen.page.evaluate(() => globalThis.curves.view.handles);
    const { left, top } = await seen.page.$eval("#canvas", (canvas) => canvas.getBoundingClientRect().toJSON());
    const pick = (await seen.placeOf(0, 2)).map((value, i) => value - [left, top][i]);
    for (const end of [handle, other]) {
      const far = Math.hypot(end[0] - pick[0], end[1] - pick[1]);
      assert.ok(far > 15 && far < 42, `${far} pixels`);
    }
    const side = [pick[0] - 1.3 * (handle[1] - pick[1]), pick[1] + 1.3 * (handle[0] - pick[0])];
    await drag(seen, [handle, [handle[0] + 6, handle[1] + 6], side].map(([x, y]) => [left + x, top + y]));
    const dragged = (await seen.drawing()).curves[0];
    assert.deepEqual(dragged.picks, aligned.picks);
    const cosine = [6, 7, 8].reduce((sum, i) => sum + dragged.tangents[i] * aligned.tangents[i], 0);
    assert.ok(Math.abs(cosine) < 0.7, `cosine ${cosine}`);
    await seen.picture("handles");
    await seen.press("#undo");
    assert.deepEqual((await seen.drawing()).curves[0].points, aligned.points);

    // Work that is given up leaves kinds as they were.
    await seen.page.evaluate(() => globalThis.curves.engine.restart("given up"));
    await seen.settled();
    assert.deepEqual((await seen.drawing()).curves[0].kinds, aligned.kinds);
    await seen.end();
  });

  test("have discs about soft picks", async () => {
    const seen = await drawn();
    await seen.page.$eval("#tolerance", (input) => {
      input.value = "3";
      input.dispatchEvent(new Event("change"));
    });
    await seen.settled();
    const [curve] = (await seen.drawing()).curves;
    assert.ok(curve.leeway > 0);
    // A point of a disc, across the curve.
    const place = await seen.page.evaluate(() => {
      const { view, drawing } = globalThis.curves;
      const { picks, normals, leeway } = drawing.curves[0];
      const at = (values, i) => [...values.subarray(3 * i, 3 * i + 3)];
      const [before, pick, next, normal] = [at(picks, 1), at(picks, 2), at(picks, 3), at(normals, 2)];
      const along = next.map((value, i) => value - before[i]);
      const across = [0, 1, 2].map((i) => normal[(i + 1) % 3] * along[(i + 2) % 3] - normal[(i + 2) % 3] * along[(i + 1) % 3]);
      const size = Math.hypot(...across);
      return view.placeOf(pick.map((value, i) => value + (leeway * across[i]) / size));
    });
    const [red, green, blue] = await colourAt(seen, place);
    assert.ok(red > 110 && green > 85 && blue < 90, `${red} ${green} ${blue}`);
    await seen.picture("discs");
    await seen.end();
  });

  test("become smooth curves: round painted faces, between parts, of files", async (t) => {
    const at = folder(t);
    const seen = await openPage(browser);
    await seen.sample("pebble");
    await seen.page.click("#paint");
    const way = await places(seen, Array.from({ length: 12 }, (_, i) => [0.42 + 0.012 * i, 0.45 + 0.05 * Math.sin(i)]));
    await drag(seen, way);
    assert.equal((await seen.drawing()).curves.length, 0);
    await seen.picture("painted");
    await seen.press("#smooth");
    assert.match(await seen.status(), /^\d smooth curves? through \d+ points/);
    const round = (await seen.drawing()).curves;
    assert.ok(round.length >= 1 && round.every(({ options, settled }) => options.closed && settled));
    await seen.picture("smoothed");
    await seen.press("#unpaint");
    assert.equal(await seen.page.$eval("#smooth", ({ disabled }) => disabled), true);

    // Beside the mesh the button turns the view.
    const place = await seen.placeOf(0, 0);
    await drag(seen, Array.from({ length: 20 }, (_, i) => [20 + 5 * i, 100 + 2 * i]), 20);
    assert.notDeepEqual(await seen.placeOf(0, 0), place);
    await seen.page.click("#paint");

    await seen.press("#segment");
    const before = (await seen.drawing()).curves.length;
    await seen.page.select("#smooth-of", "parts");
    await seen.press("#smooth");
    assert.ok((await seen.drawing()).curves.length > before);
    await seen.press("#undo");
    assert.equal((await seen.drawing()).curves.length, before);

    // The lines of a file: the program's curve, to be followed.
    const { vertices, faces } = meshes.pebble;
    const rows = (array) => Array.from({ length: array.length / 3 }, (_, i) => [...array.slice(3 * i, 3 * i + 3)]);
    write(at, "mesh.obj", [...rows(vertices).map((v) => `v ${v.join(" ")}`), ...rows(faces).map((f) => `f ${f.map((id) => id + 1).join(" ")}`)].join("\n"));
    write(at, "picks.json", JSON.stringify({ picks: rows(Float64Array.from(round[0].picks)).slice(0, 5) }));
    runProgram(at, "mesh.obj", "--picks", "picks.json", "--output", "line.obj");
    await seen.page.select("#smooth-of", "file");
    const [chooser] = await Promise.all([seen.page.waitForFileChooser(), seen.page.click("#smooth")]);
    await chooser.accept([join(at, "line.obj")]);
    for (let i = 0; i < 100 && (await seen.drawing()).curves.length === before; ++i) {
      await pause(50);
    }
    await seen.settled();
    assert.match(await seen.status(), /^1 smooth curve through/);
    assert.equal((await seen.drawing()).curves.length, before + 1);
    await seen.end();
  });
});
