// SPDX-License-Identifier: GPL-3.0-or-later
// A headless Chromium with the page in it, from a server of files in a subfolder.
import assert from "node:assert/strict";
import { existsSync, mkdirSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";

import { dist } from "./support.mjs";

const { default: puppeteer } = await import(join(import.meta.dirname, "../../web/node_modules/puppeteer-core/lib/esm/puppeteer/puppeteer-core.js"));

const chromium = ["/usr/bin/chromium", "/usr/bin/google-chrome"].find(existsSync);
export const withoutBrowser = chromium ? false : "there is no Chromium (apt-get install chromium)";

const TYPES = {
  ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml",
  ".webmanifest": "application/manifest+json",
};

/** Serves folders, each under its prefix. */
export function serve(folders) {
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, "http://localhost").pathname;
    const at = Object.keys(folders).find((prefix) => path.startsWith(prefix));
    const name = path.slice(at?.length) || "index.html";
    try {
      assert.ok(at && !name.includes(".."));
      const bytes = await readFile(join(folders[at], name));
      response.writeHead(200, { "content-type": TYPES[extname(name)] ?? "application/octet-stream" });
      response.end(bytes);
    } catch {
      response.writeHead(404);
      response.end();
    }
  });
  return new Promise((done) => {
    server.listen(0, "localhost", () => done({ server, origin: `http://localhost:${server.address().port}` }));
  });
}

export function launch() {
  // Software rendering: machines that test have no graphics card.
  return puppeteer.launch({
    executablePath: chromium,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
}

export async function startBrowser() {
  const { server, origin } = await serve({ "/a/folder/": join(dist, "page") });
  const browser = await launch();
  return { browser, url: `${origin}/a/folder/`, close: () => Promise.all([browser.close(), server.close()]) };
}

/** In ms: a machine that builds as well may take long for what takes a second otherwise. */
const PATIENCE = 120_000;

const pictures = process.env.BSPLINE_CURVE_PICTURES; // a folder for screenshots

/**
 * A page that is ready, and what a test does with it. What it says on its console, and
 * what it asks of other servers, fails the test in the end.
 */
export async function openPage({ browser, url }, { width = 900, height = 640, touch = false, dark = false } = {}) {
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  const said = [];
  page.on("console", (message) => said.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => said.push(`error: ${error.message}`));
  page.on("request", (request) => {
    if (!request.url().startsWith(url) && !/^(blob|data):/.test(request.url())) {
      said.push(`asked for ${request.url()}`);
    }
  });
  await page.setViewport({ width, height, hasTouch: touch, isMobile: touch });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }]);
  await page.goto(url);
  await page.waitForSelector("body[data-ready]");

  const status = () => page.$eval("#status", ({ textContent }) => textContent);
  const drawing = () => page.evaluate(() => {
    const { drawing } = globalThis.curves;
    return drawing && {
      ...drawing,
      curves: drawing.curves.map((curve) => ({ ...curve, picks: [...curve.picks], points: [...curve.points] })),
    };
  });
  /** Until nothing is asked for or solved any more. */
  const settled = async () => {
    await page.waitForFunction(() => !globalThis.curves.engine.isBusy && globalThis.curves.drawing?.is_settled !== false);
    await page.evaluate(() => globalThis.curves.engine.request("ready"));
    await page.waitForFunction(() => !globalThis.curves.engine.isBusy && globalThis.curves.drawing?.is_settled !== false);
  };
  return {
    page, said, status, drawing, settled,
    async press(selector) {
      await page.click(selector);
      await settled();
    },
    async sample(kind) {
      await page.click(`[data-sample=${kind}]`);
      await page.waitForFunction(() => globalThis.curves.drawing);
      await settled();
    },
    /** Clicks the canvas at shares of its width and height. */
    async click(x, y) {
      const { left, top, width: w, height: h } = await page.$eval("#canvas", (canvas) => canvas.getBoundingClientRect().toJSON());
      await page.mouse.click(left + x * w, top + y * h);
      await settled();
    },
    /** Where pick i of a curve is on the window. */
    placeOf(curve, pick) {
      return page.evaluate((c, p) => {
        const { view, drawing: now } = globalThis.curves;
        const { left, top } = document.getElementById("canvas").getBoundingClientRect();
        const [x, y] = view.placeOf(now.curves[c].picks.subarray(3 * p, 3 * p + 3));
        return [left + x, top + y];
      }, curve, pick);
    },
    async upload(...paths) {
      const input = await page.$("#file");
      await input.uploadFile(...paths);
      await page.waitForFunction(() => document.getElementById("file").files.length === 0);
      await settled();
    },
    async downloadsTo(folder) {
      const session = await page.createCDPSession();
      await session.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder, browserContextId: context.id });
    },
    async picture(name) {
      if (pictures) {
        mkdirSync(pictures, { recursive: true });
        await page.screenshot({ path: join(pictures, `${name}.png`) });
      }
    },
    async end() {
      assert.deepEqual(said, []);
      await context.close();
    },
  };
}
