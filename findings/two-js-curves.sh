#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# two.js 0.8.24 (npm) draws other curves than the SVG that it interprets: quadratic curves lean and are 5 % too high, corners of
# rectangles with rx and ry lean and stand out by 2 % of the radius, and those with rx alone are square. The box that it gives of an arc is that
# of its ends: a half circle of radius 20 is flat. Nothing is said. Lines, circles, cubic curves and the arcs themselves are right.
# Believed: as SVG 1.1 has them (8.3.7; 9.2: "If a properly specified value is provided for rx, but not for ry, then set ry to ... rx").
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages two.js@0.8.24 jsdom@24.1.3 svg-path-bbox@2.1.0
cat >draw.mjs <<'JS'
import { JSDOM } from "jsdom";
import { svgPathBbox } from "svg-path-bbox";
const { window } = new JSDOM("", { pretendToBeVisual: true });
Object.assign(globalThis, { window, document: window.document, DOMParser: window.DOMParser, requestAnimationFrame: () => 0 });
// Contexts of canvases, of which two.js asks for one and draws nothing on it.
window.HTMLCanvasElement.prototype.getContext = () => ({});
const { default: Two } = await import("two.js");
const around = (values) => values.map((value) => +value.toFixed(1) + 0).join(" ");
for (const [what, shape, right] of [
  ["cubic curve", '<path d="M0 0C0 20 20 20 20 0"/>', svgPathBbox("M0 0C0 20 20 20 20 0")],
  ["quadratic curve", '<path d="M0 0Q10 20 20 0"/>', svgPathBbox("M0 0Q10 20 20 0")],
  ["two smooth ones", '<path d="M0 0Q10 20 20 0T40 0"/>', svgPathBbox("M0 0Q10 20 20 0T40 0")],
  ["half circle", '<path d="M-20 0A20 20 0 0 1 20 0"/>', [-20, -20, 20, 0]],
  ["circle", '<circle cx="5" cy="6" r="4"/>', [1, 2, 9, 10]],
]) {
  const two = new Two({ type: Two.Types.svg });
  const root = new DOMParser().parseFromString(`<svg xmlns="http://www.w3.org/2000/svg">${shape.replace("/>", ' stroke="none"/>')}</svg>`, "image/svg+xml");
  const group = two.interpret(root.documentElement);
  two.update();
  const path = two.renderer.domElement.querySelector("path");
  const place = path.getAttribute("transform").match(/[-\d.]+/g).map(Number);
  const [x0, y0, x1, y1] = svgPathBbox(path.getAttribute("d"));
  // getBoundingClientRect adds a line of width 1, which is not drawn.
  const box = group.children[0].getBoundingClientRect();
  console.log(`${what}: drawn within ${around([x0 + place[4], y0 + place[5], x1 + place[4], y1 + place[5]])}, box given ${around([box.left + 0.5, box.top + 0.5, box.right - 0.5, box.bottom - 0.5])}, right is ${around(right)}`);
}
const at = ([p, q, r, s], t) => (1 - t) ** 3 * p + 3 * (1 - t) ** 2 * t * q + 3 * (1 - t) * t * t * r + t ** 3 * s;
for (const radii of ['rx="3" ry="3"', 'rx="3"']) {
  const two = new Two({ type: Two.Types.svg });
  two.interpret(new DOMParser().parseFromString(`<svg xmlns="http://www.w3.org/2000/svg"><rect width="10" height="20" ${radii}/></svg>`, "image/svg+xml").documentElement);
  two.update();
  // The second curve is the corner of which the middle is (2, -7).
  const [, , x0, y0, x1, y1, x2, y2, x3, y3] = two.renderer.domElement.querySelector("path").getAttribute("d").match(/[-\d.]+/g).map(Number).slice(4);
  const distances = [...Array(101).keys()].map((k) => Math.hypot(at([x0, x1, x2, x3], k / 100) - 2, at([y0, y1, y2, y3], k / 100) + 7));
  console.log(`rectangle with ${radii}: corner ${Math.min(...distances).toFixed(2)} to ${Math.max(...distances).toFixed(2)} from its centre`);
}
JS
node draw.mjs >seen 2>messages || { tail -n 3 messages; exit 1; }
expect_in seen <<'END'
cubic curve: drawn within 0 0 20 15, box given 0 0 20 15, right is 0 0 20 15
quadratic curve: drawn within 0 0 20 10.5, box given 0 0 20 10.5, right is 0 0 20 10
two smooth ones: drawn within 0 -10.5 40 10.5, box given 0 -10.5 40 10.5, right is 0 -10 40 10
half circle: drawn within -20 -20 20 0, box given -20 0 20 0, right is -20 -20 20 0
circle: drawn within 1 2 9 10, box given 1 2 9 10, right is 1 2 9 10
rectangle with rx="3" ry="3": corner 2.99 to 3.07 from its centre
rectangle with rx="3": corner 3.00 to 4.24 from its centre
END
