#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# manifold-3d 3.5.4 (npm) makes nothing of clockwise outlines, and fills holes that turn as their border does: a plate whose y points down, as those
# of an SVG, has no volume, and one with a hole of 10 x 10 in 40 x 20 has it only if the hole turns the other way. So does revolving, where
# all left of the axis is nothing, too. Downward extrusions are empty. Nothing is said but by isEmpty(). Believed: the area within the
# outlines, as OpenSCAD and JSCAD take them. ("EvenOdd", which has to be asked for, is right.)
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages manifold-3d@3.5.4
cat >outlines.mjs <<'JS'
import load from "manifold-3d";
const wasm = await load();
wasm.setup();
const { CrossSection, Manifold } = wasm;
const box = (x, y, width, height) => [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
const turned = (points) => [...points].reverse();
const plate = box(0, 0, 40, 20), hole = box(10, 5, 10, 10);
const volumes = (body) => `${body.volume().toFixed(0)}${body.isEmpty() ? " (empty)" : ""}`;
for (const [what, outlines, right] of [
  ["counterclockwise", [plate], 4000], ["clockwise", [turned(plate)], 4000],
  ["hole the other way", [plate, turned(hole)], 3500], ["hole the same way", [plate, hole], 3500],
  ["y down, hole the other way", [turned(plate), hole], 3500],
]) {
  const even = CrossSection.ofPolygons(outlines, "EvenOdd");
  console.log(`${what}: extruded by 5 ${volumes(Manifold.extrude(outlines, 5))}, as even-odd ${volumes(even.extrude(5))}, right is ${right}`);
}
for (const [what, profile] of [["right", box(2, 0, 2, 5)], ["right, clockwise", turned(box(2, 0, 2, 5))], ["left", box(-4, 0, 2, 5)]])
  console.log(`ring, profile ${what}: ${volumes(Manifold.revolve([profile], 512))}, right is ${(60 * Math.PI).toFixed(0)}`);
console.log(`extruded by -5: ${volumes(Manifold.extrude([plate], -5))}, right is 4000`);
JS
node outlines.mjs >seen
expect_in seen <<'END'
counterclockwise: extruded by 5 4000, as even-odd 4000, right is 4000
clockwise: extruded by 5 0 (empty), as even-odd 4000, right is 4000
hole the other way: extruded by 5 3500, as even-odd 3500, right is 3500
hole the same way: extruded by 5 4000, as even-odd 3500, right is 3500
y down, hole the other way: extruded by 5 0 (empty), as even-odd 3500, right is 3500
ring, profile right: 188, right is 188
ring, profile right, clockwise: 0 (empty), right is 188
ring, profile left: 0 (empty), right is 188
extruded by -5: 0 (empty), right is 4000
END
