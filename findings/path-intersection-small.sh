#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# path-intersection 4.2.1 (below bpmn.io's editors) finds where paths meet by chords about as long as five user units: where they are few
# units wide, as small parts in millimetres or sheets in inches or metres, it is far off. A diagonal meets a quarter of a circle of 10 at
# 6.84, not 7.07, one of 1 at 0.5, not 0.71; a line meets a curve of 1 at y 0, not 0.73. At 100 it is 0.02 off, at 1000 right. Nothing is
# said. Believed: as exact for each size.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages path-intersection@4.2.1
cat >meet.mjs <<'JS'
import * as all from "path-intersection";
const meet = typeof all.default === "function" ? all.default : all.default.default;
const text = (points) => points.map(({ x, y }) => `(${+x.toFixed(4)}, ${+y.toFixed(4)})`).join(" ") || "nowhere";
for (const r of [0.1, 1, 10, 100, 1000]) {
  const circle = meet(`M0 0L${r} ${r}`, `M${r} 0A${r} ${r} 0 0 1 0 ${r}`), curve = meet(`M${0.37 * r} ${-r}V${r}`, `M0 0C0 ${r} ${r} ${r} ${r} 0`);
  const t = [...Array(60)].reduce(([low, high]) => {
    const t = (low + high) / 2;
    return 3 * t * t - 2 * t * t * t < 0.37 ? [t, high] : [low, t];
  }, [0, 1])[0];
  console.log(`size ${r}: a diagonal and a circle meet at ${text(circle)}, right would be ${+(r * Math.SQRT1_2).toFixed(4)} each`);
  console.log(`size ${r}: a line and a curve meet at ${text(curve)}, right would be y ${+(3 * r * t * (1 - t)).toFixed(4)}`);
}
JS
node meet.mjs >seen
expect_in seen <<'END'
size 0.1: a diagonal and a circle meet at (0.05, 0.05), right would be 0.0707 each
size 0.1: a line and a curve meet at (0.037, 0), right would be y 0.0727
size 1: a diagonal and a circle meet at (0.5, 0.5), right would be 0.7071 each
size 1: a line and a curve meet at (0.37, 0), right would be y 0.727
size 10: a diagonal and a circle meet at (6.8409, 6.8409), right would be 7.0711 each
size 10: a line and a curve meet at (3.7, 6.7909), right would be y 7.27
size 100: a diagonal and a circle meet at (70.6891, 70.6891), right would be 70.7107 each
size 100: a line and a curve meet at (37, 72.65), right would be y 72.6999
size 1000: a diagonal and a circle meet at (707.1068, 707.1068), right would be 707.1068 each
size 1000: a line and a curve meet at (370, 726.9983), right would be y 726.9988
END
