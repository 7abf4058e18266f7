// SPDX-License-Identifier: GPL-3.0-or-later

/** What is wrong with an input, and what helps. */
export class InputError extends Error {
  /**
   * @param {{code: string, message: string, elements: number[]}} error `code`: as in Python, or "cancelled", "memory",
   *   "internal", "crashed"
   */
  constructor({ code, message, elements }) {
    super(message);
    this.name = "InputError";
    this.code = code;
    /** Ids of the faces, vertices or picks concerned, from 0 on. */
    this.elements = elements ?? [];
  }
}
