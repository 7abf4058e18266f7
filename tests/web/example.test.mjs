// SPDX-License-Identifier: GPL-3.0-or-later
// The example of docs/WEB.md, as it stands there; and the types of the package.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { launch, serve, withoutBrowser } from "./browser.mjs";
import { dist, folder, write } from "./support.mjs";

const root = join(import.meta.dirname, "../..");

test("the example for pages runs", { skip: withoutBrowser }, async (t) => {
  const at = folder(t);
  const [, example] = readFileSync(join(root, "docs/WEB.md"), "utf8").match(/```html\n([\s\S]*?)```/);
  write(at, "index.html", example);
  cpSync(join(dist, "module"), join(at, "bspline-curve"), { recursive: true });
  const { server, origin } = await serve({ "/": at });
  const browser = await launch();
  try {
    const page = await browser.newPage();
    await page.goto(`${origin}/`);
    await page.waitForFunction(() => document.getElementById("out").textContent !== "");
    assert.match(await page.$eval("#out", ({ textContent }) => textContent), /^length [45]\.\d{4}, \d{3,4} faces inside$/);
  } finally {
    await browser.close();
    server.close();
  }
});

test("the package has types", () => {
  execFileSync(process.execPath, [
    join(root, "web/node_modules/typescript/bin/tsc"), "--noEmit", "--strict", "--target", "es2022", "--lib", "es2022,dom",
    "--module", "nodenext", join(import.meta.dirname, "types.ts"),
  ], { stdio: "inherit" });
});
