#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# canvas2svg 1.0.16 (npm), which makes SVG of what is drawn on a canvas: circles end a thousandth of a radian before their beginning, 1 mm at a
# radius of 1 m, and stay open, so that cutters and hatches find no closed outline; arcs of more than a whole turn become what is left over
# after it, such as 0.7 of 7. Other arcs, both ways round, are right. Nothing is said. Believed: closed circles, and the whole
# circumference from 2 pi on, as the arc of a canvas has it (HTML standard, "arc").
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages canvas2svg@1.0.16 jsdom@29.1.1
cat >circles.cjs <<'JS'
const { window } = Object.assign(globalThis, { window: new (require('jsdom').JSDOM)('').window });
Object.assign(globalThis, { document: window.document, XMLSerializer: window.XMLSerializer });
window.HTMLCanvasElement.prototype.getContext = () => ({});  // it asks a canvas for the widths of texts alone
require('canvas2svg');
for (const [radius, from, to, backwards] of [[20, 0, 2 * Math.PI], [1000, 0, 2 * Math.PI], [1000, 2 * Math.PI, 0, true], [20, 0, 7], [20, 1, 0.5], [20, 0, 4, true]]) {
  const canvas = new window.C2S(2000, 2000);
  canvas.beginPath();
  canvas.arc(0, 0, radius, from, to, backwards);
  canvas.stroke();
  const [x, y, , , , , sweep, endX, endY] = canvas.getSerializedSvg().match(/ d="([^"]*)"/)[1].match(/[-\d.e]+/g).map(Number);
  // The centre is the origin, so that the end alone says how far the arc runs.
  const turn = ((sweep ? 1 : -1) * (Math.atan2(endY, endX) - Math.atan2(y, x)) + 4 * Math.PI) % (2 * Math.PI);
  console.log(`radius ${radius}, ${from.toFixed(1)} to ${to.toFixed(1)}${backwards ? ' backwards' : ''}: ${turn.toFixed(3)} rad, the end ${Math.hypot(endX - x, endY - y).toFixed(2)} from the beginning`);
}
JS
node circles.cjs >seen
expect_in seen <<'END'
radius 20, 0.0 to 6.3: 6.282 rad, the end 0.02 from the beginning
radius 1000, 0.0 to 6.3: 6.282 rad, the end 1.00 from the beginning
radius 1000, 6.3 to 0.0 backwards: 6.282 rad, the end 1.00 from the beginning
radius 20, 0.0 to 7.0: 0.717 rad, the end 14.03 from the beginning
radius 20, 1.0 to 0.5: 5.783 rad, the end 9.90 from the beginning
radius 20, 0.0 to 4.0 backwards: 2.283 rad, the end 36.37 from the beginning
END
