#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gcode-toolpath 3.0.0 of npm (of the makers of CNCjs): of a drilling cycle G81 over three holes in a row at y = 10 the first is lost, and
# the others are rapid moves above y = 0; absolute arc centres (G90.1) are added to the place; numbers as expressions (X[1+2], as in
# pstoedit's G-code) are zero. Nothing is said. Believed: what it does not know is reported.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages gcode-toolpath@3.0.0
cat >paths.cjs <<'JS'
const Toolpath = require('gcode-toolpath');
const programs = {
  drilling: 'G0 X0 Y0 Z5\nG81 X10 Y10 Z-5 R2 F100\nX20\nX30\nG80\n',
  'relative centre': 'G90 G91.1\nG0 X10 Y0\nG3 X10 Y20 I0 J10\n',
  'absolute centre': 'G90 G90.1\nG0 X10 Y0\nG3 X10 Y20 I10 J10\n',
  number: 'G1 X3 F100\n',
  expression: 'G1 X[1+2] F100\n',
};
const place = ({ x, y, z }) => `(${x}, ${y}, ${z})`;
for (const [name, text] of Object.entries(programs)) {
  const moves = [];
  new Toolpath({
    addLine: ({ motion }, from, to) => moves.push(`${motion} to ${place(to)}`),
    addArcCurve: ({ motion }, from, to, centre) => moves.push(`${motion} to ${place(to)} about ${place(centre)}`),
  }).loadFromStringSync(text);
  console.log(`${name}: ${moves.join(', ') || 'nothing'}`);
}
JS
node paths.cjs >seen
expect_in seen <<'END'
drilling: G0 to (0, 0, 5), G0 to (20, 0, 5), G0 to (30, 0, 5)
relative centre: G0 to (10, 0, 0), G3 to (10, 20, 0) about (10, 10, 0)
absolute centre: G0 to (10, 0, 0), G3 to (10, 20, 0) about (20, 10, 0)
number: G1 to (3, 0, 0)
expression: G1 to (0, 0, 0)
END
