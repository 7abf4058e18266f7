// SPDX-License-Identifier: GPL-3.0-or-later
// The page in headless Chromium, by clicks, drags, fingers and keys.
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";
import { gzipSync } from "node:zlib";
import { after, before, describe, test } from "node:test";

import { openPage, startBrowser, withoutBrowser } from "./browser.mjs";
import { assertClose, assertSameText, corpus, dist, folder, meshes, runProgram, SAME, write } from "./support.mjs";

const axe = join(import.meta.dirname, "../../web/node_modules/axe-core/axe.min.js");

const PICKS = [[0.42, 0.42], [0.52, 0.36], [0.6, 0.45], [0.58, 0.58], [0.46, 0.6]];

describe("the page", { skip: withoutBrowser }, () => {
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

  async function saved(seen, at, name, button) {
    await seen.page.click(button);
    for (let i = 0; i < 100 && !existsSync(join(at, name)); ++i) {
      await pause(50);
    }
    await pause(50);
    return readFileSync(join(at, name));
  }

  test("is small and says that files stay", async () => {
    const seen = await openPage(browser);
    const sizes = readdirSync(join(dist, "page")).map((name) => gzipSync(readFileSync(join(dist, "page", name))).length);
    assert.ok(sizes.reduce((sum, size) => sum + size) <= 1.5e6 && Math.max(...sizes) <= 1e6, String(sizes));
    assert.match(await seen.page.$eval("#start", ({ textContent }) => textContent), /never leave this machine/);
    await seen.picture("start");
    await seen.end();
  });

  test("draws through clicks; drags, inserts, closes, undoes, removes", async () => {
    const seen = await drawn();
    let now = await seen.drawing();
    assert.equal(now.curves.length, 1);
    assert.equal(now.curves[0].picks.length, 3 * PICKS.length);
    assert.ok(now.curves[0].points.length > 600);
    await seen.picture("drawn");

    // A drag.
    const [x, y] = await seen.placeOf(0, 2);
    await seen.page.mouse.move(x, y);
    await seen.page.mouse.down();
    for (let i = 1; i <= 10; ++i) {
      await seen.page.mouse.move(x + 3 * i, y - 4 * i);
      await pause(20);
    }
    await seen.page.mouse.up();
    await seen.settled();
    const dragged = await seen.drawing();
    assert.equal(dragged.curves[0].picks.length, 3 * PICKS.length);
    assert.notDeepEqual(dragged.curves[0].picks.slice(6, 9), now.curves[0].picks.slice(6, 9));
    await seen.press("#undo");
    assert.deepEqual((await seen.drawing()).curves[0].picks, now.curves[0].picks);
    await seen.press("#redo");
    assert.deepEqual((await seen.drawing()).curves[0].picks, dragged.curves[0].picks);

    // A click on the curve inserts a pick.
    const middle = await seen.page.evaluate(() => {
      const { view, drawing } = globalThis.curves;
      const { left, top } = document.getElementById("canvas").getBoundingClientRect();
      const { points } = drawing.curves[0];
      const at = 3 * Math.floor(points.length / 6 / 2.2);
      const [px, py] = view.placeOf(points.subarray(at, at + 3));
      return [left + px, top + py];
    });
    await seen.page.mouse.click(...middle);
    await seen.settled();
    assert.equal((await seen.drawing()).curves[0].picks.length, 3 * PICKS.length + 3);
    await seen.press("#remove");
    assert.equal((await seen.drawing()).curves[0].picks.length, 3 * PICKS.length);

    // A click on the first pick closes it.
    await seen.page.mouse.click(...(await seen.placeOf(0, 0)));
    await seen.settled();
    now = await seen.drawing();
    assert.equal(now.curves[0].options.closed, true);

    // Another curve.
    await seen.press("#new");
    await seen.click(0.4, 0.7);
    await seen.click(0.5, 0.72);
    assert.equal((await seen.drawing()).curves.length, 2);
    await seen.picture("two curves");
    await seen.end();
  });

  test("turns, zooms and fits without touching the drawing", async () => {
    const seen = await drawn();
    const before = (await seen.drawing()).curves[0].picks;
    const place = await seen.placeOf(0, 0);
    await seen.page.mouse.move(30, 90); // beside the mesh
    await seen.page.mouse.down();
    await seen.page.mouse.move(130, 140, { steps: 4 });
    await seen.page.mouse.up();
    await seen.page.mouse.wheel({ deltaY: -300 });
    await seen.settled();
    assert.notDeepEqual(await seen.placeOf(0, 0), place);
    assert.deepEqual((await seen.drawing()).curves[0].picks, before);
    await seen.press("#fit");
    await seen.end();
  });

  test("saved curves are the program's, and are taken up again", async (t) => {
    const at = folder(t);
    const seen = await drawn();
    await seen.downloadsTo(at);
    await seen.press("#close");
    const document = JSON.parse(await saved(seen, at, "pebble-drawing.json", "#save-curves"));
    const { vertices, faces } = meshes.pebble;
    const rows = (array) => Array.from({ length: array.length / 3 }, (_, i) => [...array.slice(3 * i, 3 * i + 3)]);
    write(at, "mesh.obj", [...rows(vertices).map((v) => `v ${v.join(" ")}`), ...rows(faces).map((f) => `f ${f.map((id) => id + 1).join(" ")}`)].join("\n"));
    write(at, "picks.json", JSON.stringify({ picks: rows((await seen.drawing()).curves[0].picks) }));
    const read = runProgram(at, "mesh.obj", "--picks", "picks.json", "--closed", "--output", "curve.json");
    const expected = JSON.parse(read("curve.json"));
    assert.deepEqual(document.mesh, expected.mesh);
    assertClose(document.polyline.points.flat(), expected.polyline.points.flat(), SAME * 4, "the curve");
    assertClose(document.spline.control_points.flat(), expected.spline.control_points.flat(), SAME * 4, "the spline");
    // Headers of STEP name the time. Lines of IGES break where numbers are long: its parameters alone, joined.
    const comparable = {
      "curves.step": (text) => text.replace(/\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d/g, "TIME"),
      "curves.iges": (text) => text.split("\n").filter((line) => line[72] === "P").map((line) => line.slice(0, 64).trimEnd()).join(""),
      "curves.dxf": (text) => text,
      "curves.obj": (text) => text,
    };
    const savedCurves = async (format) => {
      await seen.page.select("#curve-format", format);
      return saved(seen, at, `pebble-${format}`, "#save-curves");
    };
    for (const [format, textOf] of Object.entries(comparable)) {
      const made = runProgram(at, "mesh.obj", "--picks", "picks.json", "--closed", "--output", format)(format);
      assertSameText(textOf((await savedCurves(format)).toString()), textOf(made.toString()), SAME * 4, format);
    }
    const made = runProgram(at, "mesh.obj", "--picks", "picks.json", "--closed", "--output", "curves.ply")("curves.ply");
    assert.equal((await savedCurves("curves.ply")).length, made.length);
    const coordinates = [...(await savedCurves("picks.pp")).toString().matchAll(/ [xyz]="([^"]*)"/g)].map(([, value]) => Number(value));
    assert.deepEqual(coordinates.sort(), (await seen.drawing()).curves[0].picks.sort()); // in any order of x, y, z
    const again = await openPage(browser);
    await again.upload(join(at, "mesh.obj"), join(at, "pebble-drawing.json"));
    assertClose((await again.drawing()).curves[0].points, document.polyline.points.flat(), SAME * 4, "taken up");
    assert.ok((await saved(seen, at, "pebble.png", "#save-picture")).length > 5000);

    // Meshes, too.
    await seen.page.select("#keep", "largest");
    await seen.press("#cut");
    for (const format of [".obj", ".off", ".stl"]) {
      const cut = runProgram(at, "cut", "mesh.obj", "--curve", "curve.json", "--keep", "largest", "--output", `cut${format}`)(`cut${format}`);
      await seen.page.select("#mesh-format", format);
      const own = await saved(seen, at, `pebble-new${format}`, "#save-mesh");
      if (format === ".stl") {
        assert.equal(own.length, cut.length);
      } else {
        assertSameText(own.toString(), cut.toString(), SAME * 4, format);
      }
    }
    await again.end();
    await seen.end();
  });

  test("a click beside the mesh that is answered late leaves the next one its own", async () => {
    const seen = await openPage(browser);
    await seen.sample("pebble");
    await seen.page.evaluate(() => {
      const { engine } = globalThis.curves;
      const request = engine.request.bind(engine);
      engine.request = async (...asked) => {
        const answer = await request(...asked);
        if (asked[1]?.event?.event === "press") {
          await new Promise((done) => setTimeout(done, 300));
        }
        return answer;
      };
    });
    const { left, top, width, height } = await seen.page.$eval("#canvas", (canvas) => canvas.getBoundingClientRect().toJSON());
    await seen.page.mouse.click(left + 3, top + height - 3);
    await seen.page.mouse.move(left + 0.5 * width, top + 0.5 * height);
    await seen.page.mouse.down();
    await pause(600);
    await seen.page.mouse.up();
    await pause(600);
    await seen.page.mouse.move(left + 0.6 * width, top + 0.6 * height);
    await seen.settled();
    const [curve] = (await seen.drawing()).curves;
    assert.equal(curve.picks.length, 3);
    const [x, y] = await seen.placeOf(0, 0);
    assert.ok(Math.hypot(x - left - 0.5 * width, y - top - 0.5 * height) < 2, `${x} ${y}`);
    await seen.end();
  });

  test("opens another mesh where several steps were on one", async () => {
    const seen = await drawn();
    for (const step of ["#offset", "#offset", "#undo", "#undo", "#redo", "#offset"]) {
      await seen.press(step);
      assert.doesNotMatch(await seen.status(), /freed/);
    }
    for (const kind of ["ring", "pebble"]) {
      await seen.page.evaluate((sample) => document.querySelector(`[data-sample=${sample}]`).click(), kind);
      await seen.settled();
      assert.doesNotMatch(await seen.status(), /freed/);
    }
    assert.equal((await seen.drawing()).curves.length, 0);
    await seen.end();
  });

  test("says what is wrong where a number is missing", async () => {
    const seen = await drawn();
    for (const id of ["distance", "tolerance", "weight", "deviation", "height"]) {
      await seen.page.$eval(`#${id}`, (input) => {
        input.value = "";
        input.dispatchEvent(new Event("input"));
        input.dispatchEvent(new Event("change"));
      });
    }
    await seen.press("#offset");
    assert.match(await seen.status(), /distance must be a number above 0/);
    assert.equal((await seen.drawing()).curves.length, 1);
    await seen.end();
  });

  test("imprints, segments, cuts, fills and offsets, each undoable", async (t) => {
    const at = folder(t);
    const seen = await drawn();
    await seen.downloadsTo(at);
    await seen.press("#close");
    const faces = () => seen.page.evaluate(() => globalThis.curves.view.faceCount);
    const before = await faces();
    await seen.press("#imprint");
    assert.match(await seen.status(), /are edges/);
    assert.ok((await faces()) > before);
    await seen.press("#undo");
    assert.equal(await faces(), before);
    await seen.press("#segment");
    assert.match(await seen.status(), /2 parts/);
    await seen.picture("segmented");
    await seen.press("#undo");
    await seen.press("#offset");
    assert.match(await seen.status(), /curves? at a distance/);
    await seen.picture("offset");
    await seen.press("#undo");
    await seen.page.select("#keep", "largest");
    await seen.press("#cut");
    assert.match(await seen.status(), /1 part kept, 1 left out/);
    await seen.picture("cut");
    await seen.press("#undo");
    await seen.page.select("#fill", "smooth");
    await seen.press("#cut");
    assert.match(await seen.status(), /1 hole was filled/);
    assert.match((await saved(seen, at, "pebble-new.ply", "#save-mesh")).subarray(0, 3).toString(), /ply/);
    await seen.press("#undo");
    for (const [solid, words] of [["thickness", /1 part kept/], ["base", /1 part kept/], ["relief", /relief is made/]]) {
      await seen.page.select("#solid", solid);
      await seen.press("#cut");
      assert.match(await seen.status(), words);
      assert.ok((await faces()) > 0);
      await seen.picture(solid);
      await seen.press("#undo");
    }
    assert.equal((await seen.drawing()).curves.length, 1);
    await seen.press("#redo");
    assert.equal((await seen.drawing()).curves.length, 0);
    await seen.end();
  });

  test("has tension, degree, tolerance and fields with their colours", async () => {
    const seen = await drawn();
    const before = (await seen.drawing()).curves[0];
    await seen.page.focus("#tension");
    for (let i = 0; i < 5; ++i) {
      await seen.page.keyboard.press("ArrowRight");
    }
    await seen.settled();
    const tense = (await seen.drawing()).curves[0];
    assert.equal(tense.options.tension, 0.05);
    assert.ok(tense.length < before.length);
    await seen.page.select("#degree", "4");
    await seen.settled();
    assert.equal((await seen.drawing()).curves[0].options.degree, 4);
    await seen.page.select("#field", "valley");
    await seen.settled();
    assert.equal((await seen.drawing()).curves[0].options.field, "valley");
    await pause(300);
    await seen.settled();
    await seen.picture("field");
    await seen.page.select("#field", "boundary-distance");
    await seen.page.waitForFunction(() => /boundary/.test(document.getElementById("status").textContent));
    await seen.end();
  });

  test("is drawn on by keys alone", async () => {
    const seen = await openPage(browser);
    await seen.sample("hills");
    await seen.page.focus("#canvas");
    const keys = async (...names) => {
      for (const name of names) {
        await seen.page.keyboard.press(name);
        await seen.settled();
      }
    };
    await keys("Enter", "ArrowLeft", "ArrowLeft", "Enter", "ArrowUp", "ArrowUp", "ArrowUp", "Enter");
    assert.equal((await seen.drawing()).curves[0].picks.length, 9);
    await keys("c");
    assert.equal((await seen.drawing()).curves[0].options.closed, true);
    await keys("[", "Delete");
    assert.equal((await seen.drawing()).curves[0].picks.length, 6);
    await seen.page.keyboard.down("Control");
    await keys("z");
    await seen.page.keyboard.up("Control");
    assert.equal((await seen.drawing()).curves[0].picks.length, 9);
    await keys("?");
    assert.equal(await seen.page.$eval("#overlay", ({ open }) => open), true);
    assert.equal(await seen.page.$eval("#overlay", ({ scrollTop }) => scrollTop), 0);
    await seen.picture("help");
    await keys("Escape");
    await seen.end();
  });

  test("is drawn on by fingers on a screen of 390 pixels", async () => {
    const seen = await openPage(browser, { width: 390, height: 780, touch: true });
    await seen.page.tap("[data-sample=ring]");
    await seen.page.waitForFunction(() => globalThis.curves.drawing);
    await seen.settled();
    const { left, top, width, height } = await seen.page.$eval("#canvas", (canvas) => canvas.getBoundingClientRect().toJSON());
    for (const [x, y] of [[0.3, 0.6], [0.5, 0.7], [0.7, 0.6]]) {
      await seen.page.touchscreen.tap(left + x * width, top + y * height);
      await seen.settled();
    }
    assert.equal((await seen.drawing()).curves[0].picks.length, 9);
    const wide = await seen.page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 390, `${wide} pixels`);
    await seen.picture("phone");
    // Two fingers turn and zoom, and draw nothing.
    const a = await seen.page.touchscreen.touchStart(left + 0.3 * width, top + 0.3 * height);
    const b = await seen.page.touchscreen.touchStart(left + 0.7 * width, top + 0.5 * height);
    await a.move(left + 0.2 * width, top + 0.2 * height);
    await b.move(left + 0.8 * width, top + 0.6 * height);
    await a.end();
    await b.end();
    await seen.settled();
    assert.equal((await seen.drawing()).curves[0].picks.length, 9);
    await seen.end();
  });

  test("refuses bad files with one clear line", async (t) => {
    const at = folder(t);
    const seen = await openPage(browser);
    write(at, "bad.ply", readFileSync(join(corpus, "ply", "big.ply")).subarray(0, 40));
    write(at, "note.json", "{}");
    await seen.upload(join(at, "note.json"));
    assert.match(await seen.status(), /open the mesh/);
    await seen.upload(join(at, "bad.ply"));
    assert.match(await seen.status(), /^bad\.ply: [^\n]+/);
    await seen.sample("hills");
    await seen.upload(join(at, "note.json"));
    assert.match(await seen.status(), /^note\.json: [^\n]+/);
    await seen.click(0.5, 0.5);
    assert.equal((await seen.drawing()).curves.length, 1);
    await seen.end();
  });

  test("shows colours of vertices, and the image of an OBJ with texture coordinates", async (t) => {
    const at = folder(t);
    const seen = await openPage(browser);
    const colour = () => seen.page.evaluate(async () => {
      const bitmap = await createImageBitmap(await globalThis.curves.view.picture());
      const context = new OffscreenCanvas(1, 1).getContext("2d");
      context.drawImage(bitmap, bitmap.width / 2, bitmap.height / 2, 1, 1, 0, 0, 1, 1);
      return [...context.getImageData(0, 0, 1, 1).data];
    });
    const corners = ["0 0 0", "1 0 0", "1 1 0", "0 1 0"];
    write(at, "green.obj", [...corners.map((v) => `v ${v} 0 1 0`), "f 1 2 3", "f 1 3 4"].join("\n"));
    await seen.upload(join(at, "green.obj"));
    let [red, green] = await colour();
    assert.ok(green > 120 && red < 60, `${red} ${green}`);
    const red1 = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/pLvAAAAAElFTkSuQmCC"; // 1 pixel
    write(at, "image.png", Buffer.from(red1, "base64"));
    write(at, "red.obj", [...corners.map((v) => `v ${v}`), "vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1", "f 1/1 2/2 3/3", "f 1/1 3/3 4/4"].join("\n"));
    await seen.upload(join(at, "red.obj"), join(at, "image.png"));
    [red, green] = await colour();
    assert.ok(red > 120 && green < 60, `${red} ${green}`);
    await seen.click(0.45, 0.5);
    await seen.click(0.55, 0.45);
    await seen.press("#imprint");
    [red, green] = await colour();
    assert.ok(red > 120 && green < 60, `${red} ${green}`);
    await seen.end();
  });

  test("gives up long work, and the drawing is as it was", async () => {
    const seen = await drawn();
    const before = await seen.drawing();
    const failed = await seen.page.evaluate(async () => {
      const { engine } = globalThis.curves;
      const asked = engine.request("use", { kind: "offset", options: { distance: 10, side: "both" } }).then(() => "done", ({ code }) => code);
      await engine.restart("given up");
      return asked;
    });
    assert.equal(failed, "cancelled");
    await seen.settled();
    const now = await seen.drawing();
    assertClose(now.curves[0].points, before.curves[0].points, 1e-9, "the curve");
    await seen.click(0.4, 0.7);
    assert.equal((await seen.drawing()).curves[0].picks.length, before.curves[0].picks.length + 3);
    await seen.end();
  });

  test("works without a network once it was loaded", async () => {
    const seen = await openPage(browser);
    await seen.page.evaluate(() => navigator.serviceWorker.ready);
    await seen.page.waitForFunction(async () => (await caches.keys()).length > 0 && navigator.serviceWorker.controller !== null);
    await seen.page.setOfflineMode(true);
    await seen.page.reload();
    await seen.page.waitForSelector("body[data-ready]");
    await seen.sample("ring");
    await seen.end();
  });

  for (const dark of [false, true]) {
    test(`has no serious finding of axe, ${dark ? "dark" : "light"}`, async () => {
      const seen = await drawn({ dark });
      await seen.page.addStyleTag({ content: "*, ::before { transition: none !important; }" }).catch(() => {});
      // The page's policy lets no foreign script in: the audit runs as the debugger does.
      await seen.page.evaluate(readFileSync(axe, "utf8"));
      const audit = async () => {
        const { violations } = await seen.page.evaluate(() => globalThis.axe.run());
        return violations.filter(({ impact }) => impact === "serious" || impact === "critical")
          .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
      };
      assert.deepEqual(await audit(), []);
      await seen.page.click("#help");
      assert.deepEqual(await audit(), []);
      await seen.picture(dark ? "dark" : "light");
      seen.said.length = 0; // its style tag was refused by the policy
      await seen.end();
    });
  }
});
