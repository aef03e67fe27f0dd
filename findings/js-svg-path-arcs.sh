#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# js-svg-path 1.1.0 (npm) takes the radii, angle and flags of an arc of a path for coordinates of corners: a slot of 60 x 20
# becomes lines to and fro, 50 long. Nothing is said, but for a path of arcs alone, which ends in a TypeError; its readme promises "an
# identically rendered path", and does not name arcs. Lines, H and V are right. Believed: arcs (SVG 1.1, 8.3.8), or an error.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages js-svg-path@1.1.0 svg-path-bbox@2.1.0
cat >paths.mjs <<'JS'
import library from "js-svg-path";
import { svgPathBbox } from "svg-path-bbox";
const box = (text) => text && !text.startsWith("an error") ? svgPathBbox(text).map((value) => Math.round(value)).join(" ") : "none";
for (const [what, path] of [
  ["plate", "M0 0L60 0L60 20L0 20Z"],
  ["plate by H and V", "M0 0H60V20H0Z"],
  ["slot", "M10 0L50 0A10 10 0 0 1 50 20L10 20A10 10 0 0 1 10 0Z"],
  ["quarter", "M0 0L30 0A30 30 0 0 1 0 30Z"],
  ["circle of arcs", "M-20 0A20 20 0 1 1 20 0A20 20 0 1 1 -20 0Z"],
]) {
  let written;
  try { written = library.parse(path).toSVG(); } catch (error) { written = "an error"; }
  console.log(`${what}: box ${box(written)}, right is ${box(path)}; written ${written || "nothing"}`);
}
JS
node paths.mjs >seen
expect_in seen <<'END'
plate: box 0 0 60 20, right is 0 0 60 20; written M0 0L60 0L60 20L0 20Z
plate by H and V: box 0 0 60 20, right is 0 0 60 20; written M0 0L60 0L60 20L0 20Z
slot: box 0 0 50 20, right is 0 0 60 20; written M10 0L50 0L10 0L0 1L50 20L10 20L10 0L0 1L10 0Z
quarter: box 0 0 30 30, right is 0 0 30 30; written M0 0L30 0L30 0L0 1L0 30Z
circle of arcs: box none, right is -20 -20 20 20; written an error
END
