// SPDX-License-Identifier: GPL-3.0-or-later
// The one instance of the module: calls go out as JSON, arrays beside it through its memory.
import { InputError } from "./errors.js";
import { wasiImports } from "./wasi.js";

let wasm = null;
let failure = null; // of an instance that trapped: its memory is not to be trusted
let progress = null; // of the call that runs

async function bytesOf(source) {
  if (source === undefined) {
    source = new URL("./bspline_curve.wasm", import.meta.url);
  }
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) {
    return source;
  }
  if (source instanceof URL && source.protocol === "file:") {
    const { readFile } = await import(/* @vite-ignore */ "node:fs/promises");
    return readFile(source);
  }
  return fetch(source);
}

/**
 * Loads the module; to be awaited before anything else. A second call does nothing.
 * @param {string | URL | ArrayBuffer | ArrayBufferView} [source] where bspline_curve.wasm is, or its bytes; if not given,
 *   beside this file
 */
export async function init(source) {
  if (wasm) {
    return;
  }
  const imports = {
    wasi_snapshot_preview1: wasiImports(() => wasm.memory),
    host: { progress: tell },
  };
  const from = await bytesOf(source);
  let loaded;
  if (from instanceof Response) {
    if (!from.ok) {
      throw new Error(`${from.url}: ${from.status} ${from.statusText}`);
    }
    // Servers that do not know the type of .wasm are served as well.
    const isTyped = from.headers.get("content-type")?.startsWith("application/wasm");
    loaded = isTyped
      ? await WebAssembly.instantiateStreaming(from, imports)
      : await WebAssembly.instantiate(await from.arrayBuffer(), imports);
  } else {
    loaded = await WebAssembly.instantiate(from, imports);
  }
  wasm = loaded.instance.exports;
  wasm._initialize();
}

function textAt(place, size) {
  return new TextDecoder().decode(new Uint8Array(wasm.memory.buffer, place, size));
}

function tell(fraction, stage, length) {
  return !progress || progress(fraction, textAt(stage, length)) !== false ? 1 : 0;
}

const ARRAYS = { $f64: Float64Array, $i32: Int32Array, $u8: Uint8Array };

/** Copies arrays into the module; the answer stands for them in JSON. */
class Outgoing {
  #places = [];

  add(array) {
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    const place = wasm.bc_alloc(Math.max(1, bytes.length));
    if (place === 0) {
      throw new InputError({ code: "memory", message: "there is not enough memory for this" });
    }
    this.#places.push(place);
    new Uint8Array(wasm.memory.buffer).set(bytes, place);
    const name = Object.keys(ARRAYS).find((key) => array instanceof ARRAYS[key]);
    return { [name]: [place, array.length] };
  }

  free() {
    this.#places.forEach((place) => wasm.bc_free(place));
  }
}

// Arrays of the module's memory, copied out of it.
function received(_key, value) {
  if (value && typeof value === "object" && !Array.isArray(value)) {
    for (const name in ARRAYS) {
      if (name in value) {
        const [place, count] = value[name];
        return new ARRAYS[name](wasm.memory.buffer, place, count).slice();
      }
    }
  }
  return value;
}

/**
 * Carries out a call of the module.
 * @param {string} name as in web/core/calls.h
 * @param {object} values JSON; typed arrays may stand in it
 * @param {(fraction: number, stage: string) => unknown} [onProgress] gives the call up by returning false
 */
export function call(name, values, onProgress) {
  if (!wasm) {
    throw new Error("await init() first");
  }
  if (failure) {
    throw new InputError({ code: "crashed", message: failure });
  }
  const outgoing = new Outgoing();
  try {
    const json = JSON.stringify({ call: name, ...values }, (_key, value) =>
      ArrayBuffer.isView(value) ? outgoing.add(value) : value,
    );
    const { $u8: [place, size] } = outgoing.add(new TextEncoder().encode(json));
    progress = onProgress;
    const isDone = wasm.bc_call(place, size);
    const text = textAt(wasm.bc_answer(), wasm.bc_answer_size());
    if (!isDone) {
      throw new InputError(JSON.parse(text));
    }
    return JSON.parse(text, received);
  } catch (error) {
    if (error instanceof InputError) {
      throw error;
    }
    failure = `the module failed and has to be loaded again (${error.message})`;
    throw new InputError({ code: "crashed", message: failure });
  } finally {
    progress = null;
    if (!failure) {
      outgoing.free();
    }
  }
}

/** Bytes of the module's memory, which only grows. */
export function memoryBytes() {
  return wasm.memory.buffer.byteLength;
}

// ---- Objects that live in the module until they are freed, or nothing refers to them

const forgotten = new FinalizationRegistry((number) => {
  if (!failure) {
    call("object.free", { object: number });
  }
});

/** Has a number by which the module knows it. */
export class Held {
  #number;

  constructor(number) {
    this.#number = number;
    forgotten.register(this, number, this);
  }

  /** Of the module. */
  get number() {
    if (this.#number === null) {
      throw new Error("this was freed");
    }
    return this.#number;
  }

  /** Frees its memory in the module at once; it cannot be used any more. */
  free() {
    forgotten.unregister(this);
    call("object.free", { object: this.number });
    this.#number = null;
  }
}
