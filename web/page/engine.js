// SPDX-License-Identifier: GPL-3.0-or-later
// The page's end of the worker: requests as promises. A request that takes too long is given up with the worker, and a
// new one takes up the mesh and the picks where they were.

export class Engine {
  #worker = null;
  #waiting = new Map();
  #last = 0;
  #heard;
  #source = null; // of the mesh that is shown
  #drawing = null; // the last that was told

  /** @param {(message: object) => void} heard is told what the worker tells by itself */
  constructor(heard) {
    this.#heard = heard;
    this.#start();
  }

  #start() {
    this.#worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    this.#worker.onmessage = ({ data }) => this.#take(data);
    this.#worker.onerror = (event) => this.#failAll(event.message || "The worker could not be started.");
  }

  #take(message) {
    if (message.number !== undefined) {
      const { done, failed } = this.#waiting.get(message.number);
      this.#waiting.delete(message.number);
      if (message.error) {
        failed(Object.assign(new Error(message.error.message), { code: message.error.code }));
      } else {
        done(message.answer);
      }
      return;
    }
    if (message.mesh) {
      this.#source = message.mesh.source;
    }
    if (message.drawing) {
      this.#drawing = message.drawing;
    }
    this.#heard(message);
  }

  #failAll(reason) {
    for (const { failed } of this.#waiting.values()) {
      failed(Object.assign(new Error(reason), { code: "cancelled" }));
    }
    this.#waiting.clear();
  }

  get isBusy() {
    return this.#waiting.size > 0;
  }

  /** The answer to a request of worker.js; throws what went wrong. */
  request(request, values, transfer = []) {
    const number = ++this.#last;
    return new Promise((done, failed) => {
      this.#waiting.set(number, { done, failed });
      this.#worker.postMessage({ number, request, values }, transfer);
    });
  }

  /** Gives up all that is asked for. */
  async restart(reason) {
    this.#worker.terminate();
    this.#failAll(reason);
    this.#start();
    await this.request("ready");
    if (this.#source) {
      const { curves = [], active = -1 } = this.#drawing ?? {};
      await this.request("restore", { source: this.#source, curves, active });
    }
  }
}
