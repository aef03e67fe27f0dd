#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fabric.js 7.4.0 measures quadratic curves of a Path as cubic ones whose control points are both at theirs: half as high again as they are. What is
# scaled to a height by it has two thirds of that. Cubic curves and arcs are right. Believed: the size of the curve.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages fabric@7.4.0 svg-path-bbox@2.1.0 svgpath@2.6.0
cat >size.mjs <<'JS'
import { Path, util } from 'fabric';
import { svgPathBbox } from 'svg-path-bbox';
import svgpath from 'svgpath';

for (const [name, d] of [['cubic curve', 'M0 0C0 10 10 10 10 0'], ['half circle', 'M0 0A5 5 0 0 0 10 0'], ['quadratic curve', 'M0 0Q5 10 10 0'], ['two of them', 'M0 0Q5 10 10 0T20 0']]) {
  const path = new Path(d, { strokeWidth: 0 }), [, top, , bottom] = svgPathBbox(d);
  path.scaleToHeight(100);
  const [, low, , high] = svgPathBbox(String(svgpath(util.joinPath(path.path)).scale(path.scaleX, path.scaleY)));
  console.log(`${name}: Fabric ${path.width} x ${path.height}, right ${bottom - top} high; scaled to a height of 100: ${(high - low).toFixed(1)}`);
}
JS
node size.mjs >seen
expect_in seen <<'END'
cubic curve: Fabric 10 x 7.5, right 7.5 high; scaled to a height of 100: 100.0
half circle: Fabric 10 x 5, right 5 high; scaled to a height of 100: 100.0
quadratic curve: Fabric 10 x 7.5, right 5 high; scaled to a height of 100: 66.7
two of them: Fabric 20 x 15, right 10 high; scaled to a height of 100: 66.7
END
