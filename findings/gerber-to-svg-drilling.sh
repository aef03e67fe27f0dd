#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gerber-to-svg 4.2.8 (npm, below pcb-stackup) takes the repeat of a hole in a drill file (R3X5.0, three more holes 5 mm apart) for a hole at X 5, and holes
# in increments (G91, in a Gerber %FSLI) for the same place each time, so that rows of holes are lost; polygons of an aperture macro turn about their own
# middle instead of the macro's origin. It warns of what it does not know, not of these. Slots, arcs of routing, steps and repeats of a Gerber, and
# outlines of macros are right. Believed: as Excellon's R and G91, and the Gerber format (4.5.1.7, 7.2), have them.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages gerber-to-svg@4.2.8
cat >holes.js <<'JS'
const convert = require("gerber-to-svg");
const drill = (...lines) => ["M48", "METRIC,TZ", "T1C1.0", "%", ...lines, "M30"].join("\n") + "\n";
const gerber = (format, ...lines) => [`%FS${format}X34Y34*%`, "%MOMM*%", ...lines, "M02*"].join("\n") + "\n";
const flashes = (svg) => [...svg.matchAll(/<use [^>]*x="([^"]*)" y="([^"]*)"/g)].map(([, x, y]) => `${x / 1000} ${y / 1000}`).join(", ");
const middle = (svg) => {
  const points = svg.match(/<polygon points="([^"]*)"/)[1].split(" ").map((point) => point.split(",").map(Number));
  return [0, 1].map((axis) => (points.reduce((sum, point) => sum + point[axis], 0) / points.length / 1000).toFixed(2)).join(" ");
};
const cases = [
  ["four holes", drill("T1", "X1.0Y1.0", "X6.0", "X11.0", "X16.0"), flashes, "1 1, 6 1, 11 1, 16 1"],
  ["a hole and three more 5 mm apart", drill("T1", "X1.0Y1.0", "R3X5.0"), flashes, "1 1, 6 1, 11 1, 16 1"],
  ["holes in increments", drill("G91", "T1", "X1.0Y1.0", "X5.0", "X5.0"), flashes, "1 1, 6 1, 11 1"],
  ["pads", gerber("LA", "%ADD10C,1*%", "D10*", "X10000Y10000D03*", "X60000D03*"), flashes, "1 1, 6 1"],
  ["pads in increments", gerber("LI", "%ADD10C,1*%", "D10*", "X10000Y10000D03*", "X50000D03*"), flashes, "1 1, 6 1"],
  ["outline at 10 0, turned by 45", gerber("LA", "%AMSHAPE*4,1,4,9,-1,11,-1,11,1,9,1,9,-1,45*%", "%ADD10SHAPE*%", "D10*", "X0Y0D03*"), middle, "7.07 7.07"],
  ["polygon at 10 0, turned by 45", gerber("LA", "%AMSHAPE*5,1,4,10,0,2,45*%", "%ADD10SHAPE*%", "D10*", "X0Y0D03*"), middle, "7.07 7.07"],
];
(async () => {
  for (const [what, text, tell, right] of cases) {
    const seen = await new Promise((done, fail) => convert(text, { id: "board" }, (error, svg) => (error ? fail(error) : done(tell(svg)))));
    console.log(`${what}: ${seen}` + (seen === right ? "" : `, right would be ${right}`));
  }
})();
JS
node holes.js >seen
expect_in seen <<'END'
four holes: 1 1, 6 1, 11 1, 16 1
a hole and three more 5 mm apart: 1 1, 5 1, right would be 1 1, 6 1, 11 1, 16 1
holes in increments: 1 1, 5 1, 5 1, right would be 1 1, 6 1, 11 1
pads: 1 1, 6 1
pads in increments: 1 1, 5 1, right would be 1 1, 6 1
outline at 10 0, turned by 45: 7.07 7.07
polygon at 10 0, turned by 45: 10.00 0.00, right would be 7.07 7.07
END
