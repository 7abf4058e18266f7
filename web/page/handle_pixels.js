// SPDX-License-Identifier: GPL-3.0-or-later

/** The handles of a pick's direction are so far from it, in pixels of the pointer. */
export const HANDLE_PIXELS = 40;
