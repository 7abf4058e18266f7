// SPDX-License-Identifier: GPL-3.0-or-later
// The worker: everything that takes time. Requests come in order, each with a number, and are answered; what is to be
// seen of the drawing is told after each, and after each curve that was solved meanwhile.
import { init, Mesh, PICK_KINDS } from "bspline-curve";
import { memoryBytes } from "../module/instance.js";

import { valueColour } from "./colours.js";
import { Documents } from "./documents.js";
import { SAMPLES } from "./samples.js";
import { shownMesh } from "./shown_mesh.js";
import { warmUp } from "./warm_up.js";

const documents = new Documents();
const ready = init();
ready.then(() => warmUp(() => documents.now !== undefined), () => {}); // who asks for something hears why
/** The bar need not move oftener, in ms. */
const PROGRESS_EVERY = 80;

let lastTold = 0;

function progress(fraction, stage) {
  const now = performance.now();
  if (now - lastTold > PROGRESS_EVERY) {
    lastTold = now;
    postMessage({ progress: { fraction, stage } });
  }
}

// ---- What is to be seen

function tell() {
  const document = documents.now;
  if (!document) {
    return;
  }
  postMessage({
    drawing: { ...document.session.state, can_undo: documents.canUndo, can_redo: documents.canRedo },
  });
}

function showMesh() {
  const { mesh, labels, lines, source, isSharp } = documents.now;
  const shown = shownMesh(mesh, labels);
  postMessage(
    { mesh: { ...shown, source, isSharp }, lines: lines.map(({ points, closed }) => ({ points, closed })) },
    [shown, shown.corners ?? {}].flatMap(({ positions, normals, faces, tints }) => [positions, normals, faces, tints])
      .flatMap((array) => array?.buffer ?? []),
  );
  if (documents.now.brush) {
    showPainted();
  }
}

function showPainted() {
  const { corners } = documents.now.brush;
  postMessage({ painted: corners }, [corners.buffer]);
}

// ---- Curves that wait are solved between requests

const solving = new MessageChannel();
let isSolvingSoon = false;

function solveSoon() {
  if (!isSolvingSoon) {
    isSolvingSoon = true;
    solving.port2.postMessage(null);
  }
}

solving.port1.onmessage = () => {
  isSolvingSoon = false;
  const session = documents.now?.session;
  if (!session) {
    return;
  }
  const start = performance.now();
  const isChanged = session.update();
  if (isChanged) {
    postMessage({ solved: performance.now() - start });
    tell();
  }
  if (isChanged || !session.state.is_settled) {
    solveSoon();
  } else {
    postMessage({ idle: true });
  }
};

// ---- Files

function extensionOf(name) {
  return name.slice(name.lastIndexOf(".")).toLowerCase();
}

function openCurves(name, bytes) {
  documents.dropUndone();
  return documents.now.session.open(name, bytes);
}

function openMesh(name, bytes, options) {
  documents.begin(Mesh.read(name, bytes, { ...options, progress }), { name, bytes });
  showMesh();
  const { mesh } = documents.now;
  const count = (mesh.faces.length / 3).toLocaleString("en");
  return [`${name}: ${count} faces${mesh.components > 1 ? ` in ${mesh.components} components` : ""}.`, ...mesh.notes];
}

function openFile({ name, bytes, options }) {
  const extension = extensionOf(name);
  if (extension === ".json" || extension === ".dxf") {
    if (!documents.now) {
      throw new Error(`${name} has curves: open the mesh that they were drawn on first.`);
    }
    return openCurves(name, bytes);
  }
  try {
    return openMesh(name, bytes, options);
  } catch (error) {
    // Polylines come in the formats of meshes, too.
    if (documents.now && /has no faces/.test(error.message)) {
      return openCurves(name, bytes);
    }
    throw error;
  }
}

// ---- Requests

/** Whether the drawing took an event. */
function carryOut(event) {
  const isTaken = documents.now?.session.event(event) ?? false;
  if (isTaken && event.event !== "move" && event.event !== "leave") {
    documents.dropUndone();
  }
  return isTaken;
}

/** Colours of vertices, 3 numbers of each. */
function fieldColours(kind) {
  const values = documents.here.mesh.field(kind, { normalised: true, progress });
  const tints = new Uint8Array(3 * values.length);
  values.forEach((value, i) => tints.set(valueColour(value), 3 * i));
  return tints;
}

const requests = {
  ready: () => null,
  open: openFile,
  sample({ kind }) {
    const { vertices, faces } = SAMPLES[kind]();
    documents.begin(new Mesh(vertices, faces, { progress }), { vertices, faces });
    showMesh();
    return [`${kind}: ${faces.length / 3} faces.`];
  },
  restore({ source, curves, active }) {
    const mesh = source.bytes
      ? Mesh.read(source.name, source.bytes, { progress })
      : new Mesh(source.vertices, source.faces, { slits: true, progress });
    documents.begin(mesh, source);
    curves.forEach((curve, i) => {
      const { picks, kinds, tangents, tangents_before, options } = curve;
      const corners = [...kinds.keys()].filter((pick) => ["corner", "free"].includes(PICK_KINDS[kinds[pick]]));
      documents.now.session.add_curve(picks, { corners, tangents, tangents_before, ...options });
      documents.now.session.set_look(i, { name: curve.name, colour: curve.colour, hidden: curve.hidden });
    });
    if (active >= 0) {
      documents.now.session.select(active);
    }
    showMesh();
  },
  event: ({ event }) => carryOut(event),
  events: ({ events }) => events.map(carryOut).includes(true),
  paint({ rays }) {
    const isMet = documents.now !== undefined && documents.paint(rays);
    if (isMet) {
      showPainted();
    }
    return isMet;
  },
  unpaint() {
    documents.here.brush = null;
    postMessage({ painted: null });
  },
  kind({ kind }) {
    const { session } = documents.here;
    if (session.state.selected >= 0) {
      documents.dropUndone();
      session.set_kind(session.state.selected, kind);
    }
  },
  smooth({ of, options, name, bytes }) {
    const words = documents.smooth(of, options, { name, bytes }, progress);
    if (of === "painted") {
      showPainted();
    }
    return words;
  },
  options({ options, live }) {
    documents.setOptions(options, live);
  },
  look({ curve, look }) {
    documents.here.session.set_look(curve, look);
  },
  colour({ colour }) {
    documents.now?.session.set_colour(colour);
  },
  select({ curve }) {
    documents.here.session.select(curve);
  },
  new_curve() {
    documents.here.session.new_curve();
  },
  remove_curve({ curve }) {
    documents.dropUndone();
    documents.here.session.remove_curve(curve);
  },
  closed({ closed }) {
    documents.here.session.set_closed(closed);
  },
  undo() {
    if (documents.now && documents.undo()) {
      showMesh();
    }
  },
  redo() {
    if (documents.now && documents.redo()) {
      showMesh();
    }
  },
  use({ kind, options }) {
    const words = documents.use(kind, options, progress);
    showMesh();
    return words;
  },
  field: ({ kind }) => fieldColours(kind),
  save_curves: ({ name }) => documents.saveCurves(name),
  /** Of the module. */
  memory: () => ({ bytes: memoryBytes(), meshes: documents.count }),
  save_mesh: ({ name }) => documents.here.mesh.save(name),
};

onmessage = async ({ data: { number, request, values } }) => {
  try {
    await ready;
    const answer = requests[request](values ?? {});
    postMessage({ number, answer: answer ?? null });
  } catch (error) {
    // Errors of the page's own have words for people; others are faults of it.
    const code = error.code ?? (error.constructor === Error ? "page" : "internal");
    postMessage({ number, error: { message: error.message, code } });
  }
  tell();
  solveSoon();
};
