// SPDX-License-Identifier: GPL-3.0-or-later

/** Hands bytes to whoever saves downloads. */
export function download(bytes, name) {
  const url = URL.createObjectURL(bytes instanceof Blob ? bytes : new Blob([bytes]));
  Object.assign(document.createElement("a"), { href: url, download: name }).click();
  // The browser reads it a little later.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
