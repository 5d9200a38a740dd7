// Compares tangents with those of the package mikktspace: node mikktspace.js FILE...; exits 1 when they disagree.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
const fs = require("fs"), path = require("path");
const { generateTangents } = require("mikktspace");

const pick = (all, from, size) => {
  const out = new Float32Array(all.length / 12 * size);
  for (let i = 0; i < out.length; ++i) out[i] = all[Math.floor(i / size) * 12 + from + i % size];
  return out;
};
// MikkTSpace cannot say that it knows nothing: then it answers with its default (1, 0, 0), or with 0 where directions cancel.
const says = (t) => !(t[0] === 1 && t[1] === 0 && t[2] === 0) && Math.hypot(t[0], t[1], t[2]) > 0.5;

let failed = false;
console.log("mesh".padEnd(28) + "corners  beyond 0.1 deg  of other sign  largest angle within 99.9 %");
for (const file of process.argv.slice(2)) {
  const bytes = fs.readFileSync(file);
  const all = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
  const theirs = generateTangents(pick(all, 0, 3), pick(all, 3, 3), pick(all, 6, 2)), ours = pick(all, 8, 4);
  const angles = [];
  let otherSign = 0;
  for (let i = 0; i < ours.length; i += 4) {
    const a = ours.subarray(i, i + 4), b = theirs.subarray(i, i + 4);
    if (a[3] === 0 && !says(b)) continue;
    const cross = Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    const angle = Math.atan2(cross, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / Math.PI;
    angles.push(a[3] === 0 ? 180 : angle);
    otherSign += a[3] !== b[3];
  }
  const beyond = angles.filter((angle) => !(angle < 0.1)).length;
  angles.sort((x, y) => x - y);
  const largest = angles[Math.ceil(angles.length * 0.999) - 1] ?? 0;
  failed ||= beyond > 0.001 * angles.length || otherSign > 0.001 * angles.length;
  console.log(path.basename(file, ".corners").padEnd(28) + String(angles.length).padStart(7) + String(beyond).padStart(16) +
    String(otherSign).padStart(15) + largest.toExponential(1).padStart(16) + " deg");
}
process.exit(failed ? 1 : 0);
