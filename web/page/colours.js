// SPDX-License-Identifier: GPL-3.0-or-later

/** Of a part: hues far from each other, one after the other by the golden angle. */
export function partColour(label) {
  if (label < 0) {
    return [225, 225, 225];
  }
  const hue = (label * 137.508 + 20) % 360;
  const channel = (n) => {
    const k = (n + hue / 30) % 12;
    return Math.round(255 * (0.66 - 0.24 * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}

const RAMP = [[48, 62, 130], [61, 129, 158], [120, 182, 150], [214, 212, 130], [244, 235, 190]];

/** Of a value in [0, 1]: dark and blue to light and yellow. */
export function valueColour(value) {
  const place = Math.min(Math.max(value, 0), 1) * (RAMP.length - 1);
  const low = Math.min(Math.floor(place), RAMP.length - 2);
  return RAMP[low].map((channel, i) => Math.round(channel + (place - low) * (RAMP[low + 1][i] - channel)));
}
