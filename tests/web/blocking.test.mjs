// SPDX-License-Identifier: GPL-3.0-or-later
// The page's main thread is never busy for long: on a mesh of 100,000 faces, while that is opened, drawn on, and used.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";
import { after, before, describe, test } from "node:test";

import { openPage, startBrowser, withoutBrowser } from "./browser.mjs";
import { folder, write } from "./support.mjs";

const LONGEST = 50; // ms of one task, on a machine of the common pace
const COMMON_PACE = 4.5; // ms of paceOf() there

/** Bumps of 2 (n - 1)^2 faces as a binary .ply. */
function bumps(n) {
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${n * n}\nproperty float x\nproperty float y\nproperty float z\n` +
    `element face ${2 * (n - 1) ** 2}\nproperty list uchar int vertex_indices\nend_header\n`;
  const vertices = Float32Array.from({ length: 3 * n * n }, (_, i) => {
    const [x, y] = [Math.floor(Math.floor(i / 3) / n), Math.floor(i / 3) % n].map((step) => (4 * step) / (n - 1) - 2);
    return [x, y, 0.3 * Math.sin(3 * x) * Math.cos(2 * y)][i % 3];
  });
  const faces = Buffer.alloc(13 * 2 * (n - 1) ** 2);
  let at = 0;
  for (let i = 0; i + 1 < n; ++i) {
    for (let j = 0; j + 1 < n; ++j) {
      const a = n * i + j;
      for (const corners of [[a, a + n, a + n + 1], [a, a + n + 1, a + 1]]) {
        faces[at] = 3;
        corners.forEach((corner, k) => faces.writeInt32LE(corner, at + 1 + 4 * k));
        at += 13;
      }
    }
  }
  return Buffer.concat([Buffer.from(header), Buffer.from(vertices.buffer), faces]);
}

/**
 * The longest tasks of a page's main thread in a trace, in ms of the processor, so that other work of the machine does
 * not count.
 */
function longestTasks({ traceEvents }) {
  const mains = new Set(traceEvents.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain")
    .map(({ pid, tid }) => `${pid} ${tid}`));
  const tasks = traceEvents.filter(({ name, pid, tid, tdur }) =>
    tdur !== undefined && /^(ThreadControllerImpl::)?RunTask$/.test(name) && mains.has(`${pid} ${tid}`));
  return tasks.map(({ tdur }) => tdur / 1000).sort((a, b) => b - a);
}

/** How long a page takes for a fixed computation, in ms: the least of several times, so that other work does not count. */
const paceOf = (page) => page.evaluate(() => {
  const values = new Float64Array(100_000);
  const times = Array.from({ length: 20 }, () => {
    const start = performance.now();
    for (let round = 0; round < 20; ++round) {
      for (let i = 0; i < values.length; ++i) {
        values[i] = Math.sqrt(values[i] + i + round);
      }
    }
    return performance.now() - start;
  });
  return Math.min(...times);
});

describe("the page's main thread", { skip: withoutBrowser }, () => {
  let browser;
  before(async () => {
    browser = await startBrowser();
  });
  after(() => browser.close());

  test("is never busy for long", async (t) => {
    const at = folder(t);
    write(at, "bumps.ply", bumps(225));
    const seen = await openPage(browser);
    const slowness = Math.max(1, (await paceOf(seen.page)) / COMMON_PACE);
    const figures = {};
    const traced = async (what, work) => {
      const path = join(at, "trace.json");
      await seen.page.tracing.start({ path, categories: ["toplevel", "disabled-by-default-devtools.timeline", "devtools.timeline"] });
      await work();
      await seen.settled();
      await seen.page.tracing.stop();
      const tasks = longestTasks(JSON.parse(readFileSync(path, "utf8")));
      assert.ok(tasks.length > 20, `${tasks.length} tasks while ${what}`);
      figures[what] = tasks[0];
    };

    await traced("opening", () => seen.upload(join(at, "bumps.ply")));
    const { left, top, width, height } = await seen.page.$eval("#canvas", (canvas) => canvas.getBoundingClientRect().toJSON());
    await traced("drawing", async () => {
      for (const [x, y] of [[0.35, 0.5], [0.45, 0.4], [0.55, 0.45], [0.6, 0.55], [0.45, 0.6]]) {
        await seen.page.mouse.click(left + x * width, top + y * height);
      }
      await seen.settled();
    });
    await traced("dragging", async () => {
      const [x, y] = await seen.placeOf(0, 2);
      await seen.page.mouse.move(x, y);
      await seen.page.mouse.down();
      for (let i = 0; i < 60; ++i) {
        await seen.page.mouse.move(x + 20 * Math.sin(i / 8), y - 30 * Math.sin(i / 10));
        await pause(10);
      }
      await seen.page.mouse.up();
    });
    await traced("turning", async () => {
      await seen.page.mouse.move(left + 10, top + 10);
      await seen.page.mouse.down({ button: "right" });
      await seen.page.mouse.move(left + 160, top + 110, { steps: 20 });
      await seen.page.mouse.up({ button: "right" });
    });
    await traced("painting", async () => {
      await seen.page.click("#paint");
      await seen.page.mouse.move(left + 0.45 * width, top + 0.5 * height);
      await seen.page.mouse.down();
      await seen.page.mouse.move(left + 0.55 * width, top + 0.55 * height, { steps: 20 });
      await seen.page.mouse.up();
      await seen.page.click("#paint");
    });
    await traced("colouring", () => seen.page.select("#field", "ridge"));
    await traced("segmenting", async () => {
      await seen.press("#close");
      await seen.press("#segment");
    });
    assert.match(await seen.status(), /2 parts/);
    const words = Object.entries(figures).map(([what, longest]) => `${what} ${longest.toFixed(1)}`).join(", ");
    t.diagnostic(`longest tasks, ms: ${words}; the machine takes ${slowness.toFixed(2)} times as long as a common one`);
    assert.ok(Math.max(...Object.values(figures)) <= LONGEST * slowness, words);
    await seen.end();
  });
});
