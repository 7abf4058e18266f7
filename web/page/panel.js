// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons, settings and the list of curves: what they ask for, and what they show.

const element = (id) => document.getElementById(id);

function hex(colour) {
  return `#${colour.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
}

function channels(text) {
  return [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16));
}

function lengthText(length) {
  return length > 0 ? `Length ${length.toPrecision(5)}` : "";
}

export class Panel {
  #act;
  #drawing = null;
  #hasMesh = false;
  #hasPainted = false;
  #hasParts = false;

  constructor(act) {
    this.#act = act;
    for (const id of ["undo", "redo", "close", "new", "remove", "turn", "freehand", "paint", "unpaint", "snap", "fit", "help", "choose", "cancel", "open"]) {
      element(id).addEventListener("click", () => act[id]());
    }
    for (const button of document.querySelectorAll("[data-sample]")) {
      button.addEventListener("click", () => act.sample(button.dataset.sample));
    }
    for (const id of ["tension", "degree", "tolerance", "field", "weight"]) {
      element(id).addEventListener("input", () => act.options(this.#options(), id === "tension"));
      element(id).addEventListener("change", () => act.options(this.#options(), false));
    }
    element("kind").addEventListener("change", () => act.kind(element("kind").value));
    element("smooth").addEventListener("click", () => act.smooth(element("smooth-of").value, this.#smoothing()));
    element("smooth-of").addEventListener("change", () => this.#enable());
    element("imprint").addEventListener("click", () => act.use("imprint", {}));
    element("segment").addEventListener("click", () => act.use("segment", {}));
    element("cut").addEventListener("click", () =>
      act.use("cut", {
        keep: element("keep").value, fill: element("fill").value, solid: element("solid").value,
        height: element("height").valueAsNumber || 0,
      }));
    element("offset").addEventListener("click", () =>
      act.use("offset", { distance: element("distance").valueAsNumber || 0, side: element("side").value }));
    element("save-curves").addEventListener("click", () => act.saveCurves(element("curve-format").value));
    element("save-mesh").addEventListener("click", () => act.saveMesh(element("mesh-format").value));
    element("save-picture").addEventListener("click", () => act.savePicture());
    for (const id of ["keep", "solid"]) {
      element(id).addEventListener("change", () => this.#enable());
    }
    this.#enable();
  }

  #options() {
    const tolerance = element("tolerance").valueAsNumber || 0;
    return {
      closed: this.#active?.options.closed ?? false,
      tension: element("tension").valueAsNumber,
      degree: Number(element("degree").value),
      pick_tolerance: tolerance > 0 ? `${tolerance} edges` : "0",
      field: element("field").value,
      field_weight: Math.max(0, element("weight").valueAsNumber || 0),
    };
  }

  #smoothing() {
    const deviation = element("deviation").valueAsNumber || 0;
    return {
      degree: Number(element("degree").value), tension: element("tension").valueAsNumber,
      deviation: deviation > 0 ? `${deviation} edges` : "0",
    };
  }

  /** The kind of field that is chosen. */
  get field() {
    return element("field").value;
  }

  get #active() {
    return this.#drawing && this.#drawing.active >= 0 ? this.#drawing.curves[this.#drawing.active] : null;
  }

  hasMesh(hasMesh) {
    this.#hasMesh = hasMesh;
    element("start").hidden = hasMesh;
    this.#enable();
  }

  hasPainted(hasPainted) {
    this.#hasPainted = hasPainted;
    this.#enable();
  }

  hasParts(hasParts) {
    this.#hasParts = hasParts;
    this.#enable();
  }

  #enable() {
    const drawing = this.#drawing;
    const isThere = { painted: this.#hasPainted, parts: this.#hasParts, file: this.#hasMesh }[element("smooth-of").value];
    const hasCurves = this.#hasMesh && drawing !== null && drawing.curves.some(({ points }) => points.length > 0);
    const may = {
      undo: drawing?.can_undo, redo: drawing?.can_redo, close: this.#active && this.#active.picks.length >= 9, new: this.#active,
      remove: this.#active, turn: this.#hasMesh, freehand: this.#hasMesh, paint: this.#hasMesh, unpaint: this.#hasPainted, smooth: isThere,
      kind: this.#active && drawing.selected >= 0, snap: this.#hasMesh, fit: this.#hasMesh, imprint: hasCurves, segment: hasCurves, cut: hasCurves,
      offset: hasCurves, "save-curves": this.#hasMesh && drawing?.curves.length > 0, "save-mesh": this.#hasMesh,
      "save-picture": this.#hasMesh, fill: element("keep").value !== "all" && element("solid").value === "",
      height: element("solid").value !== "",
    };
    for (const [id, isOn] of Object.entries(may)) {
      element(id).disabled = !isOn;
    }
  }

  // ---- What the drawing is

  show(drawing) {
    this.#drawing = drawing;
    const active = this.#active;
    element("close").setAttribute("aria-pressed", String(active?.options.closed ?? false));
    element("close").textContent = active?.options.closed ? "Open" : "Close";
    element("length").textContent = active ? lengthText(active.length) : "";
    if (active && !document.activeElement.closest?.("aside label")) {
      this.#showOptions(active.options);
    }
    element("kind").selectedIndex = active && drawing.selected >= 0 ? active.kinds[drawing.selected] : 0;
    element("tension-value").textContent = element("tension").value;
    this.#showList(drawing);
    this.#enable();
  }

  #showOptions(options) {
    element("tension").value = options.tension;
    element("degree").value = String(options.degree);
    element("tolerance").value = parseFloat(options.pick_tolerance) || 0;
    element("field").value = options.field;
    element("weight").value = options.field_weight;
  }

  // Rows are kept, so that whoever is in one stays there.
  #showList({ curves, active }) {
    const list = element("curves");
    while (list.children.length > curves.length) {
      list.lastChild.remove();
    }
    while (list.children.length < curves.length) {
      list.append(this.#row(list.children.length));
    }
    curves.forEach((curve, i) => {
      const [colour, name, eye, problem] = list.children[i].children;
      colour.value = hex(curve.colour);
      name.textContent = `${curve.name || `Curve ${i + 1}`}${curve.length > 0 ? ` · ${curve.length.toPrecision(4)}` : ""}`;
      name.setAttribute("aria-current", String(i === active));
      eye.textContent = curve.hidden ? "Show" : "Hide";
      problem.textContent = curve.problem?.message ?? (curve.usable ? "" : curve.notes.join(" "));
    });
  }

  #row(index) {
    const row = document.createElement("li");
    const colour = Object.assign(document.createElement("input"), { type: "color", ariaLabel: `Colour of curve ${index + 1}` });
    colour.addEventListener("change", () => this.#act.look(index, { colour: channels(colour.value) }));
    const name = Object.assign(document.createElement("button"), { className: "name" });
    name.addEventListener("click", () => this.#act.select(index));
    const eye = document.createElement("button");
    eye.addEventListener("click", () => this.#act.look(index, { hidden: !this.#drawing.curves[index].hidden }));
    const problem = Object.assign(document.createElement("p"), { className: "problem" });
    row.append(colour, name, eye, problem);
    return row;
  }

  // ---- Words

  say(text, isProblem = false) {
    const status = element("status");
    status.textContent = text;
    status.classList.toggle("problem", isProblem);
  }

  /** Of a button that stays down. */
  pressed(id, isOn) {
    element(id).setAttribute("aria-pressed", String(isOn));
  }

  busy(isBusy) {
    element("busy").hidden = !isBusy;
  }

  progress({ fraction, stage }) {
    element("stage").textContent = stage || "working";
    element("progress").value = fraction;
  }
}
