// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of lines and points, which live as long as the page: a new one would be compiled anew for each picture.
import { Color } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";

const known = new Map();

/** @param {number[]} colour 0 to 255 @param {number} width in pixels */
export function lineMaterial(colour, width) {
  const key = `${colour} ${width}`;
  if (!known.has(key)) {
    known.set(key, new LineMaterial({ color: new Color(...colour.map((channel) => channel / 255)), linewidth: width }));
  }
  return known.get(key);
}
