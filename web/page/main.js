// SPDX-License-Identifier: GPL-3.0-or-later
// The page: what people do becomes requests to the worker, what it tells becomes what they see.
import { Engine } from "./engine.js";
import { listenToKeys } from "./keys.js";
import { Panel } from "./panel.js";
import { PointerInput } from "./pointer_input.js";
import { download } from "./saving.js";
import { View } from "./view.js";

const BUSY_AFTER = 250; // ms: what is done sooner shows no bar
/** Of one curve after the other. */
const COLOURS = [[225, 60, 30], [30, 110, 200], [20, 140, 80], [170, 90, 190], [200, 140, 20]];

const canvas = document.getElementById("canvas");
const file = document.getElementById("file");
const lineFile = document.getElementById("line-file");
const overlay = document.getElementById("overlay");

const view = new View(canvas);
const engine = new Engine(heard);
const panel = new Panel(new Proxy({}, { get: (_, name) => act[name] }));
const input = new PointerInput(canvas, view, engine, report);
let drawing = null;
let shownField = "none";
let meshName = "mesh";
let smoothing = {}; // options for the lines of a file that is being chosen

function report(error) {
  panel.say(error.message, true);
}

/** A request that may take long; its answer, lines of words, is told. Undefined where it failed. */
async function ask(request, values, transfer) {
  const timer = setTimeout(() => panel.busy(true), BUSY_AFTER);
  try {
    const answer = await engine.request(request, values, transfer);
    if (Array.isArray(answer)) {
      panel.say(answer.join(" "));
    }
    return answer;
  } catch (error) {
    report(error);
    return undefined;
  } finally {
    clearTimeout(timer);
    panel.busy(false);
  }
}

function heard(message) {
  if (message.progress) {
    panel.progress(message.progress);
  }
  if (message.mesh) {
    view.show(message.mesh, message.lines);
    panel.hasPainted(false);
    panel.hasParts(message.mesh.labels !== null);
    shownField = "none";
    panel.hasMesh(true);
    if (panel.field !== "none") {
      act.colourBy(panel.field);
    }
  }
  if (message.painted !== undefined) {
    view.paint(message.painted);
    panel.hasPainted(message.painted !== null && message.painted.length > 0);
  }
  if (message.drawing) {
    if (message.drawing.curves.length !== drawing?.curves.length) {
      engine.request("colour", { colour: COLOURS[message.drawing.curves.length % COLOURS.length] }).catch(report);
    }
    drawing = message.drawing;
    view.showDrawing(drawing);
    panel.show(drawing);
  }
}

// ---- What people do

function rayNow() {
  return view.rayAt(...(input.at ?? [canvas.clientWidth / 2, canvas.clientHeight / 2]));
}

/** One of these at a time. */
const USES = { turn: "turns", freehand: "strokes", paint: "paints" };

function toggle(id, use) {
  for (const [other, name] of Object.entries(USES)) {
    input[name] = name === use && !input[name];
    panel.pressed(other, input[name]);
  }
}

const act = {
  undo: () => ask("undo"),
  redo: () => ask("redo"),
  close: () => ask("closed", { closed: !drawing.curves[drawing.active].options.closed }),
  new: () => act.key("new_curve", rayNow()),
  remove: () => act.key("remove", rayNow()),
  key: (key, ray) => ask("event", { event: { event: "key", key, ...ray } }),
  snap() {
    input.snaps = !input.snaps;
    panel.pressed("snap", input.snaps);
  },
  turn: () => toggle("turn", "turns"),
  freehand: () => toggle("freehand", "strokes"),
  paint: () => toggle("paint", "paints"),
  unpaint: () => ask("unpaint"),
  kind: (kind) => ask("kind", { kind }),
  smooth(of, options) {
    if (of === "file") { // which people choose now
      smoothing = options;
      lineFile.value = "";
      lineFile.click();
      return undefined;
    }
    return ask("smooth", { of, options });
  },
  fit: () => view.fit(),
  help() {
    overlay.showModal();
    overlay.scrollTop = 0; // its button at the end has the focus
  },
  choose: () => file.click(),
  open: () => file.click(),
  cancel: () => engine.restart("Given up; the drawing is as it was.").catch(report),
  sample: (kind) => {
    meshName = kind;
    return ask("sample", { kind });
  },
  async options(options, live) {
    const answer = await ask("options", { options, live });
    if (answer !== undefined && options.field !== shownField) {
      await act.colourBy(options.field);
    }
  },
  async colourBy(field) {
    shownField = field;
    view.colourBy(field === "none" ? null : await ask("field", { kind: field }));
  },
  look: (curve, look) => ask("look", { curve, look }),
  select: (curve) => ask("select", { curve }),
  use: (kind, options) => ask("use", { kind, options }),
  async saveCurves(name) {
    const bytes = await ask("save_curves", { name });
    if (bytes) {
      download(bytes, `${meshName}-${name}`);
      panel.say(`Saved ${meshName}-${name}.`);
    }
  },
  async saveMesh(extension) {
    const bytes = await ask("save_mesh", { name: `${meshName}${extension}` });
    if (bytes) {
      download(bytes, `${meshName}-new${extension}`);
      panel.say(`Saved ${meshName}-new${extension}.`);
    }
  },
  async savePicture() {
    download(await view.picture(), `${meshName}.png`);
  },
};

// ---- Files

const IS_MESH = /\.(ply|obj|stl|off)$/i;

async function openFiles(files) {
  const images = [...files].filter(({ type }) => type.startsWith("image/"));
  const others = [...files].filter((each) => !images.includes(each));
  if (images.length > 0 || others.some(({ name }) => IS_MESH.test(name))) {
    // Of a mesh that comes with several images, the first.
    view.setTexture(images.length > 0 ? await createImageBitmap(images[0], { imageOrientation: "flipY" }) : null);
  }
  // The mesh first, then what is on it.
  const inOrder = others.sort((a, b) => Number(/\.(json|dxf)$/i.test(a.name)) - Number(/\.(json|dxf)$/i.test(b.name)));
  for (const each of inOrder) {
    const bytes = await each.arrayBuffer();
    const answer = await ask("open", { name: each.name, bytes }, [bytes]);
    if (answer !== undefined && IS_MESH.test(each.name)) {
      meshName = each.name.replace(/\.[^.]*$/, "");
    }
  }
}

file.addEventListener("change", async () => {
  await openFiles(file.files);
  file.value = "";
});
lineFile.addEventListener("change", async () => {
  const [chosen] = lineFile.files;
  await ask("smooth", { of: "file", options: smoothing, name: chosen.name, bytes: await chosen.arrayBuffer() });
  lineFile.value = "";
});
document.addEventListener("dragover", (event) => {
  event.preventDefault();
  document.body.classList.add("dropping");
});
document.addEventListener("dragleave", (event) => {
  if (event.relatedTarget === null) {
    document.body.classList.remove("dropping");
  }
});
document.addEventListener("drop", (event) => {
  event.preventDefault();
  document.body.classList.remove("dropping");
  openFiles(event.dataTransfer.files).catch(report);
});

listenToKeys({ canvas, view, input, act });

engine.request("ready").then(
  () => {
    panel.say("Ready. Files never leave this machine.");
    document.body.dataset.ready = "true";
  },
  report,
);

// Afterwards the page works without a network. Pages of file: and some private windows have no such service.
if ("serviceWorker" in navigator && location.protocol.startsWith("http")) {
  navigator.serviceWorker.register("service_worker.js").catch(() => panel.say("Ready; works only with a network here."));
}

// For tests and the curious.
globalThis.curves = { view, engine, get drawing() { return drawing; } };
