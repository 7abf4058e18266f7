// SPDX-License-Identifier: GPL-3.0-or-later
// The few system calls that the C library of the module makes. There are no files: those that are read and written are
// arrays of bytes.

const SUCCESS = 0;
const NO_SUCH_FILE = 8; // EBADF
const NOT_THERE = 52; // ENOSYS

/** The imports of WASI. `memoryOf` gives the module's memory once there is one. */
export function wasiImports(memoryOf) {
  const view = () => new DataView(memoryOf().buffer);
  const calls = {
    clock_time_get(_clock, _precision, place) {
      view().setBigUint64(place, BigInt(Math.round(performance.now() * 1e6)), true);
      return SUCCESS;
    },
    random_get(place, count) {
      globalThis.crypto.getRandomValues(new Uint8Array(memoryOf().buffer, place, count));
      return SUCCESS;
    },
    environ_sizes_get(countPlace, sizePlace) {
      view().setUint32(countPlace, 0, true);
      view().setUint32(sizePlace, 0, true);
      return SUCCESS;
    },
    environ_get: () => SUCCESS,
    // What abort() says on its way out.
    fd_write(_file, parts, count, writtenPlace) {
      let text = "";
      let written = 0;
      for (let i = 0; i < count; ++i) {
        const place = view().getUint32(parts + 8 * i, true);
        const size = view().getUint32(parts + 8 * i + 4, true);
        text += new TextDecoder().decode(new Uint8Array(memoryOf().buffer, place, size));
        written += size;
      }
      console.error(text);
      view().setUint32(writtenPlace, written, true);
      return SUCCESS;
    },
    proc_exit(code) {
      throw new WebAssembly.RuntimeError(`the module ended with ${code}`);
    },
    fd_prestat_get: () => NO_SUCH_FILE,
  };
  return new Proxy(calls, { get: (known, name) => known[name] ?? (() => NOT_THERE), has: () => true });
}
