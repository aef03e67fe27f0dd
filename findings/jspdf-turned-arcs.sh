#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# jsPDF 4.2.1: its context2d, by which programs draw on a canvas and into PDF alike, moves the centre of an arc by rotate, scale and transform, and
# not the arc: turned by 90 degrees, or mirrored, a quarter of a circle lies in another quadrant, and a circle scaled along x stays one. What
# follows closePath without moveTo is lost. Lines and curves are right. Nothing is said (arcTo, which it does not have, is an error).
# Believed: as a canvas draws them (HTML standard, "arc" and "closePath").
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages jspdf@4.2.1
cat >arcs.cjs <<'JS'
const { jsPDF } = require('jspdf');
// The box of what is drawn, y down as on a canvas, from the points and curves of the page.
const drawn = (draw) => {
  const pdf = new jsPDF({ unit: 'pt', format: [400, 400], compress: false }), canvas = pdf.context2d;
  canvas.beginPath();
  draw(canvas);
  canvas.stroke();
  const content = pdf.output().match(/stream\n([^]*?)endstream/)[1].split('\n').map((line) => line.split(' '));
  const points = [];
  for (const line of content) {
    const operator = line.at(-1), numbers = line.slice(0, -1).map(Number), last = points.at(-1);
    if (operator === 'm' || operator === 'l') points.push(numbers);
    for (let t = 0.01; operator === 'c' && t < 1.005; t += 0.01)
      points.push([0, 1].map((i) => (1 - t) ** 3 * last[i] + 3 * t * (1 - t) ** 2 * numbers[i] + 3 * t * t * (1 - t) * numbers[2 + i] + t ** 3 * numbers[4 + i]));
  }
  const x = points.map((point) => point[0]), y = points.map((point) => 400 - point[1]);
  return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)].map((value) => Math.round(value) + 0).join(' ');
};
const cases = {
  'quarter': [(canvas) => canvas.arc(100, 100, 50, 0, Math.PI / 2), '100 100 150 150'],
  'quarter, moved': [(canvas) => { canvas.translate(100, 0); canvas.arc(100, 100, 50, 0, Math.PI / 2); }, '200 100 250 150'],
  'quarter, turned by 90': [(canvas) => { canvas.rotate(Math.PI / 2); canvas.arc(100, -100, 50, 0, Math.PI / 2); }, '50 100 100 150'],
  'quarter, mirrored': [(canvas) => { canvas.scale(-1, 1); canvas.arc(-100, 100, 50, 0, Math.PI / 2); }, '50 100 100 150'],
  'circle, twice as wide': [(canvas) => { canvas.scale(2, 1); canvas.arc(100, 100, 50, 0, 2 * Math.PI); }, '100 50 300 150'],
  'curve, turned by 90': [(canvas) => { canvas.rotate(Math.PI / 2); canvas.moveTo(0, 0); canvas.bezierCurveTo(0, -40, 40, -40, 40, 0); }, '0 0 30 40'],
  'line after closing': [(canvas) => { canvas.moveTo(10, 10); canvas.lineTo(20, 10); canvas.lineTo(20, 20); canvas.closePath(); canvas.lineTo(5, 5); }, '5 5 20 20'],
};
for (const [name, [draw, right]] of Object.entries(cases)) console.log(`${name}: ${drawn(draw)}, right ${right}`);
JS
node arcs.cjs >seen
expect_in seen <<'END'
quarter: 100 100 150 150, right 100 100 150 150
quarter, moved: 200 100 250 150, right 200 100 250 150
quarter, turned by 90: 100 100 150 150, right 50 100 100 150
quarter, mirrored: 100 100 150 150, right 50 100 100 150
circle, twice as wide: 150 50 250 150, right 100 50 300 150
curve, turned by 90: 0 0 30 40, right 0 0 30 40
line after closing: 10 10 20 20, right 5 5 20 20
END
