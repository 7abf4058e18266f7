// SPDX-License-Identifier: GPL-3.0-or-later
import { InputError } from "./errors.js";
import { call, Held } from "./instance.js";
import { Mesh } from "./mesh.js";

/** Curves as edges of a copy of a mesh, and the parts between them. */
export class Imprint extends Held {
  constructor(json) {
    const { imprint, ...values } = json;
    super(imprint);
    Object.assign(this, values);
  }

  #pieces(name, { progress, ...options }) {
    const answer = call(name, { imprint: this.number, options }, progress);
    return {
      ...answer,
      pieces: answer.pieces.map(({ labels, parts, ...json }) => ({ mesh: Mesh.of(json), labels, parts })),
    };
  }

  mesh() {
    return Mesh.of(call("imprint.mesh", { imprint: this.number }));
  }

  cut(options = {}) {
    if (options.stroke !== undefined) {
      throw new InputError({ code: "bad-option", message: "there is no option stroke here: strokes are in the program and in Python" });
    }
    return this.#pieces("imprint.cut", options);
  }

  segment(options = {}) {
    return this.#pieces("imprint.segment", options);
  }
}
