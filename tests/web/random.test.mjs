// SPDX-License-Identifier: GPL-3.0-or-later
// Random sequences of real events on the page in headless Chromium, each on a mesh opened anew. None may leave an error
// in the console, an answer that is no message for people, or a page that is not drawn on any more.
//
// BSPLINE_CURVE_SEQUENCES: how many; BSPLINE_CURVE_FIRST_SEQUENCE: the first one's seed.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";

import { openPage, startBrowser, withoutBrowser } from "./browser.mjs";
import { folder } from "./support.mjs";

const count = Number(process.env.BSPLINE_CURVE_SEQUENCES ?? 12);
const first = Number(process.env.BSPLINE_CURVE_FIRST_SEQUENCE ?? 1);
const MOST_EVENTS = 12;

const KEYS = ["Enter", "c", "n", "[", "]", "g", "Delete", "Escape", "ArrowLeft", "ArrowUp", "+", "f", "m", "v", "t", "t", "s", "p"];
const BUTTONS = [
  "#undo", "#undo", "#redo", "#close", "#new", "#remove", "#imprint", "#segment", "#cut", "#offset", "#fit", "#turn", "#freehand", "#paint",
  "#unpaint", "#snap", "#smooth", "#save-curves", "#save-mesh",
];
const CHOICES = {
  "#kind": ["automatic", "aligned", "corner"], "#degree": ["2", "3", "4"], "#tolerance": ["0", "2", "1e9", ""], "#deviation": ["0", "3", "-1"],
  "#field": ["none", "ridge", "boundary-distance", "quality"], "#weight": ["0", "2000"], "#tension": ["0", "0.4", "1"],
  "#keep": ["all", "largest", "inside"], "#solid": ["", "", "thickness", "base", "relief"], "#height": ["2", "-1", "0"], "#fill": ["none", "flat", "smooth"], "#smooth-of": ["painted", "parts"],
  "#distance": ["3", "0.01", "50", ""], "#side": ["both", "left"], "#curve-format": ["drawing.json", "curves.step", "picks.pp"],
};

/** Of a grid of n by n points over the unit square, by a function: an OFF file. */
function grid(n, point) {
  const at = (i) => i / (n - 1);
  const vertices = Array.from({ length: n * n }, (_, i) => point(at(Math.floor(i / n)), at(i % n)).join(" "));
  const faces = [];
  for (let i = 0; i + 1 < n; ++i) {
    for (let j = 0; j + 1 < n; ++j) {
      const a = n * i + j;
      faces.push(`3 ${a} ${a + n} ${a + n + 1}`, `3 ${a} ${a + n + 1} ${a + 1}`);
    }
  }
  return `OFF\n${vertices.length} ${faces.length} 0\n${vertices.join("\n")}\n${faces.join("\n")}\n`;
}

const MESHES = {
  "hills.off": grid(28, (u, v) => [4 * u, 4 * v, 0.4 * Math.sin(5 * u) * Math.cos(4 * v)]),
  "tube.off": grid(30, (u, v) => [Math.cos(5.5 * u), Math.sin(5.5 * u), 3 * v]),
  "fold.off": grid(16, (u, v) => [u, v, Math.abs(u - 0.5)]),
};

class Random {
  #state;

  constructor(seed) {
    this.#state = seed * 7919 + 17;
  }

  /** In [0, 1) (G. Marsaglia's xorshift). */
  next() {
    this.#state ^= this.#state << 13;
    this.#state ^= this.#state >>> 17;
    this.#state ^= this.#state << 5;
    return (this.#state >>> 0) / 2 ** 32;
  }

  of(list) {
    return list[Math.floor(this.next() * list.length)];
  }
}

describe("random events on the page", { skip: withoutBrowser }, () => {
  let browser;
  before(async () => {
    browser = await startBrowser();
  });
  after(() => browser.close());

  // Each sends what it does, and does not wait: events come as quickly as the page takes them.
  const EVENTS = {
    click: (page, random, place) => [page.mouse.click(...place(), { button: random.next() < 0.95 ? "left" : "right" })],
    drag(page, random, place) {
      const held = random.of([null, null, "Shift", "Control", "Alt"]);
      const button = random.next() < 0.9 ? "left" : "right";
      return [
        held && page.keyboard.down(held),
        page.mouse.move(...place()),
        page.mouse.down({ button }),
        page.mouse.move(...place(), { steps: 1 + Math.floor(8 * random.next()) }),
        random.next() < 0.1 && page.keyboard.press(random.of(["Escape", "t", "c"])),
        page.mouse.up({ button }),
        held && page.keyboard.up(held),
      ];
    },
    key: (page, random) => [
      page.evaluate(() => document.getElementById("canvas").focus()),
      page.keyboard.press(random.of(KEYS)),
    ],
    button: (page, random) => [page.evaluate((id) => document.querySelector(id).click(), random.of(BUTTONS))],
    choice(page, random) {
      const id = random.of(Object.keys(CHOICES));
      return [page.evaluate((where, value) => {
        const chooser = document.querySelector(where);
        if (!chooser.disabled) {
          chooser.value = value;
          chooser.dispatchEvent(new Event("input"));
          chooser.dispatchEvent(new Event("change"));
        }
      }, id, random.of(CHOICES[id]))];
    },
    wheel: (page, random) => [page.mouse.wheel({ deltaY: 200 * (random.next() - 0.5) })],
  };
  const KINDS = ["click", "click", "click", "drag", "drag", "key", "button", "button", "choice", "wheel"];

  async function sequence(seen, seed) {
    const random = new Random(seed);
    const name = random.of(Object.keys(MESHES));
    const { left, top, width, height } = await seen.page.evaluate(async (file, text) => {
      const { engine, view } = globalThis.curves;
      await engine.request("open", { name: file, bytes: new TextEncoder().encode(text).buffer });
      view.fit();
      return document.getElementById("canvas").getBoundingClientRect().toJSON();
    }, name, MESHES[name]);
    const place = () => [left + width * (0.1 + 0.8 * random.next()), top + height * (0.1 + 0.8 * random.next())];
    const events = 1 + Math.floor(random.next() * MOST_EVENTS);
    const sent = Array.from({ length: events }, () => EVENTS[random.of(KINDS)](seen.page, random, place));
    await Promise.all(sent.flat());
    const { said, isAlive } = await seen.page.evaluate(async () => {
      const { codes, curves } = globalThis;
      do {
        await curves.engine.request("ready");
        await new Promise((done) => setTimeout(done, 1));
      } while (curves.engine.isBusy || !curves.drawing.is_settled);
      await curves.view.picture();
      return { said: codes.splice(0), isAlive: curves.drawing.curves.every(({ settled }) => settled) };
    });
    assert.equal(isAlive, true);
    for (const text of said) {
      assert.doesNotMatch(text, /^(internal|crashed|memory|undefined|cancelled):/);
      assert.match(text, /^[\w-]+: [^\n]{8,}$/);
    }
    assert.deepEqual(seen.said, []);
  }

  test(`${count} sequences leave it alive and silent`, { timeout: 60_000 + 5_000 * count }, async (t) => {
    const seen = await openPage(browser, { width: 420, height: 600 });
    await seen.downloadsTo(folder(t));
    await seen.page.evaluate(() => {
      const { engine, view } = globalThis.curves;
      view.draw = () => {}; // once at the end of each: software draws slowly
      const request = engine.request.bind(engine);
      globalThis.codes = [];
      engine.request = (...asked) => request(...asked).catch((error) => {
        globalThis.codes.push(`${error.code}: ${error.message}`);
        throw error;
      });
    });
    const start = performance.now();
    for (let i = 0; i < count; ++i) {
      try {
        await sequence(seen, first + i);
      } catch (error) {
        error.message = `sequence ${first + i}: ${error.message}`;
        throw error;
      }
      if (count > 100 && i % 50 === 49) {
        const { bytes } = await seen.page.evaluate(() => globalThis.curves.engine.request("memory"));
        const { JSHeapUsedSize: heap } = await seen.page.metrics();
        const seconds = ((performance.now() - start) / 1000).toFixed(0);
        console.log(`${i + 1} sequences, ${seconds} s, module ${(bytes / 1e6).toFixed(1)} MB, page ${(heap / 1e6).toFixed(1)} MB`);
      }
    }
    await seen.end();
  });
});
