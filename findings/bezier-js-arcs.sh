#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bezier-js 6.1.4 (npm) makes of an S-shaped curve one "arc" that is a straight line, whatever error it is to keep (arcs): its circle goes through the ends
# and the middle of the curve, which lie on a line there, has a radius of 1e18, and all distances to its centre are equal as rounded. An S-bend of
# 300 x 173 mm is lost. Nothing is said. Curves that turn one way, and slightly uneven S-bends, are right. Believed: arcs that
# "approximate the curve" as far as the error threshold says.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages bezier-js@6.1.4
cat >arcs.mjs <<'JS'
import { Bezier } from "bezier-js";

for (const [what, points] of [
  ["quarter of a circle", [300, 0, 300, 165.685, 165.685, 300, 0, 300]],
  ["S-bend", [0, 0, 100, 300, 200, -300, 300, 0]],
  ["S-bend, leaning", [0, 0, 200, 0, 100, 150, 300, 150]],
  ["S-bend, uneven by 20", [0, 0, 100, 300, 200, -280, 300, 0]],
])
  for (const error of [0.5, 0.01]) {
    const curve = new Bezier(...points), arcs = curve.arcs(error);
    let off = 0;
    for (const { interval, x, y, r, s, e } of arcs)
      for (let t = interval.start; t <= interval.end; t += 1 / 1024) {
        const { x: px, y: py } = curve.get(t);
        const from = curve.get(interval.start), to = curve.get(interval.end);
        const chord = Math.hypot(to.x - from.x, to.y - from.y);
        const straight = Math.abs((to.x - from.x) * (py - from.y) - (to.y - from.y) * (px - from.x)) / chord;
        off = Math.max(off, r > 1e6 ? straight : Math.abs(Math.hypot(px - x, py - y) - r));
      }
    console.log(`${what}, error ${error}: ${arcs.length} arcs, up to ${off.toFixed(off > 1 ? 0 : 1)} off`);
  }
JS
node arcs.mjs >seen
expect_in seen <<'END'
quarter of a circle, error 0.5: 1 arcs, up to 0.1 off
quarter of a circle, error 0.01: 5 arcs, up to 0.0 off
S-bend, error 0.5: 1 arcs, up to 87 off
S-bend, error 0.01: 1 arcs, up to 87 off
S-bend, leaning, error 0.5: 1 arcs, up to 26 off
S-bend, leaning, error 0.01: 1 arcs, up to 26 off
S-bend, uneven by 20, error 0.5: 10 arcs, up to 0.3 off
S-bend, uneven by 20, error 0.01: 37 arcs, up to 0.0 off
END
