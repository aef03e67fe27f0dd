#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# verb-nurbs 3.0.3 compares its tolerances with areas and with steps between parameters, not with distances: tessellate(0.01) makes of a circle
# of radius 1 an octagon 0.08 inside of it, and of one of 0.1 a line through its centre. Curves in which surfaces meet, whose points are
# good to 1e-3, run up to 0.07 off both cylinders between their points. Nothing is said. Believed: "the tolerance at which to sample the
# curve" is how far the chords lie off.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages verb-nurbs@3.0.3
cat >curves.cjs <<'JS'
globalThis.window = globalThis;
const { Circle, CylindricalSurface, Intersect } = require('verb-nurbs').geom;
const x = [1, 0, 0], y = [0, 1, 0], z = [0, 0, 1];
for (const radius of [0.1, 1, 10, 1000]) {
  const points = new Circle([0, 0, 0], x, y, radius).tessellate(0.01);
  const off = points.slice(1).map((p, i) => radius - Math.hypot(p[0] + points[i][0], p[1] + points[i][1]) / 2);
  // Where a curve is divided is drawn by chance, so that the last digits differ from run to run.
  console.log(`circle of radius ${radius}, tolerance 0.01: ${points.length < 12 ? `${points.length} points, ` : ''}${Math.max(...off) > 0.04 ? 'more than four times as far off' : 'kept'}`);
}
const pipe = new CylindricalSurface(z, x, [0, 0, -20], 40, 10), branch = new CylindricalSurface(x, y, [-20, 0, 0], 40, 5);
for (const curve of Intersect.surfaces(pipe, branch, 1e-3)) {
  const { min, max } = curve.domain();
  let off = 0;
  for (let i = 0; i <= 1000; ++i) {
    const p = curve.point(min + (max - min) * i / 1000);
    off = Math.max(off, Math.abs(Math.hypot(p[0], p[1]) - 10), Math.abs(Math.hypot(p[1], p[2]) - 5));
  }
  console.log(`branch of a pipe, tolerance 0.001: ${off > 0.04 ? 'more than forty times as far off' : 'kept'}`);
}
JS
node curves.cjs | grep tolerance >seen
expect_in seen <<'END'
circle of radius 0.1, tolerance 0.01: 3 points, more than four times as far off
circle of radius 1, tolerance 0.01: 9 points, more than four times as far off
circle of radius 10, tolerance 0.01: more than four times as far off
circle of radius 1000, tolerance 0.01: kept
branch of a pipe, tolerance 0.001: more than forty times as far off
branch of a pipe, tolerance 0.001: more than forty times as far off
END
