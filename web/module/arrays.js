// SPDX-License-Identifier: GPL-3.0-or-later

/** Numbers of points, 3 of each: a typed array as it is, or a list of numbers or of lists of 3. */
export function coordinates(points) {
  return points instanceof Float64Array ? points : Float64Array.from(Array.isArray(points) ? points.flat() : points);
}

/** Ids, likewise. */
export function ids(values) {
  return values instanceof Int32Array ? values : Int32Array.from(Array.isArray(values) ? values.flat() : values);
}
