#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three.js 0.170.0 makes bodies inside out, in the STL too: extrusions with a negative depth, and lathes whose profile goes down. An extrusion has
# bevels unless they are forbidden: a plate of 40 x 20 x 5 becomes 42.0 x 22.0 x 5.4 with bevels of 1 x 0.2, outside of the outline. A part of a
# turn has no end faces, so that its STL is open. Nothing is said. Believed: bodies of the outline, closed,
# with facets that turn to the outside. Clockwise outlines of an extrusion are right.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.170.0
cat >bodies.mjs <<'JS'
import * as THREE from "three";
import { STLExporter } from "three/addons/exporters/STLExporter.js";
const points = (values) => values.map(([x, y]) => new THREE.Vector2(x, y));
const plate = new THREE.Shape(points([[0, 0], [40, 0], [40, 20], [0, 20]])), clockwise = new THREE.Shape(points([[0, 20], [40, 20], [40, 0], [0, 0]]));
const ring = [[8, 0], [10, 0], [10, 5], [8, 5], [8, 0]];
function told(geometry) {
  const corners = [...new STLExporter().parse(new THREE.Mesh(geometry)).matchAll(/vertex (\S+) (\S+) (\S+)/g)].map((m) => m.slice(1).map(Number));
  const edges = new Map(), name = (p) => p.map((value) => value.toFixed(4)).join(" ").replace(/-(0\.0+)\b/g, "$1");
  let volume = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = corners.slice(i, i + 3);
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    const names = [a, b, c].map(name);
    if (new Set(names).size === 3)
      names.forEach((from, k) => { const to = names[(k + 1) % 3]; edges.set(`${from}>${to}`, (edges.get(`${from}>${to}`) ?? 0) + 1); });
  }
  const open = [...edges].filter(([edge, count]) => edges.get(edge.split(">").reverse().join(">")) !== count).length;
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox;
  return `${[max.x - min.x, max.y - min.y, max.z - min.z].map((value) => +value.toFixed(1)).join(" x ")}, ${volume.toFixed(0)} mm3${open ? `, ${open} open edges` : ""}`;
}
const plain = { bevelEnabled: false };
const part = Math.PI / 2, whole = 2 * Math.PI, full = Math.PI * 36 * 5;
for (const [what, geometry, right] of [
  ["plate", new THREE.ExtrudeGeometry(plate, { depth: 5, ...plain }), 4000],
  ["clockwise plate", new THREE.ExtrudeGeometry(clockwise, { depth: 5, ...plain }), 4000],
  ["plate downwards", new THREE.ExtrudeGeometry(plate, { depth: -5, ...plain }), 4000],
  ["plate with bevels", new THREE.ExtrudeGeometry(plate, { depth: 5, bevelSize: 1, bevelThickness: 0.2 }), "less than 4000"],
  ["ring", new THREE.LatheGeometry(points(ring), 256, 0, whole), full.toFixed(0)],
  ["ring by a profile downwards", new THREE.LatheGeometry(points([...ring].reverse()), 256, 0, whole), full.toFixed(0)],
  ["quarter of the ring", new THREE.LatheGeometry(points(ring), 64, 0, part), (full / 4).toFixed(0)],
]) console.log(`${what}: ${told(geometry)}, right is ${right}`);
JS
node bodies.mjs >seen
expect_in seen <<'END'
plate: 40 x 20 x 5, 4000 mm3, right is 4000
clockwise plate: 40 x 20 x 5, 4000 mm3, right is 4000
plate downwards: 40 x 20 x 5, -4000 mm3, right is 4000
plate with bevels: 42 x 22 x 5.4, 4977 mm3, right is less than 4000
ring: 20 x 5 x 20, 565 mm3, right is 565
ring by a profile downwards: 20 x 5 x 20, -565 mm3, right is 565
quarter of the ring: 10 x 5 x 10, 141 mm3, 8 open edges, right is 141
END
