// SPDX-License-Identifier: GPL-3.0-or-later
// node web/build.mjs WASM OUT: the npm package into OUT/module, the page into OUT/page. Only static files come of it.
import { createHash } from "node:crypto";
import { cp, mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

import { build } from "esbuild";

const [wasm, out] = process.argv.slice(2);
const here = import.meta.dirname;
const [module, page] = [join(out, "module"), join(out, "page")];

async function copy(from, to, names) {
  await mkdir(to, { recursive: true });
  for (const name of names) {
    await cp(join(from, name), join(to, name));
  }
}

// ---- The package

await rm(out, { recursive: true, force: true });
await copy(join(here, "module"), module, await readdir(join(here, "module")));
await cp(wasm, join(module, "bspline_curve.wasm"));

// ---- The page

await copy(join(here, "page"), page, ["index.html", "style.css", "icon.svg", "manifest.webmanifest"]);
await cp(wasm, join(page, "bspline_curve.wasm"));
await build({
  entryPoints: [join(here, "page/main.js"), join(here, "page/worker.js")],
  outdir: page,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  alias: { "bspline-curve": join(here, "module/index.js") },
  external: ["node:*"],
  legalComments: "linked", // licences of what is bundled, beside it
  logLevel: "warning",
});

// ---- What works without a network

const files = (await readdir(page)).sort();
const hash = createHash("sha256");
for (const name of files) {
  hash.update(await readFile(join(page, name)));
}
const service = await readFile(join(here, "page/service_worker.js"), "utf8");
const kept = ["./", ...files.filter((name) => !name.endsWith(".txt"))];
await writeFile(
  join(page, "service_worker.js"),
  service.replace("@BUILD@", `curves-${hash.digest("hex").slice(0, 12)}`).replace("@FILES@", kept.join(" ")),
);

// ---- How much there is to load

let total = 0;
for (const name of [...files, "service_worker.js"].filter((each) => !each.endsWith(".txt"))) {
  const size = gzipSync(await readFile(join(page, name)), { level: 9 }).length;
  total += size;
  console.log(`${name.padEnd(24)}${(size / 1000).toFixed(1).padStart(8)} kB gzipped`);
}
console.log(`${"the page".padEnd(24)}${(total / 1000).toFixed(1).padStart(8)} kB gzipped`);
