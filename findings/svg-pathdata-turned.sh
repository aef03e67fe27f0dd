#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-pathdata 9.0.0 turns and skews absolute horizontals and verticals of a path as though their other coordinate were
# that of the point before, already turned: a plate of 20 x 10 written by H and V, turned by 90 degrees, becomes an arrow of
# half its area. Relative ones (h, v) are right, and so is what normalizeHVZ has made lines of before. Believed: as svgpath 2.6.0.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-pathdata@9.0.0 svgpath@2.6.0
cat >turn.mjs <<'JS'
import { SVGPathData } from 'svg-pathdata';
import svgpath from 'svgpath';

const quarter = [0, 1, -1, 0, 0, 0];
for (const d of ['M0 0L20 0L20 10L0 10Z', 'M0 0h20v10h-20z', 'M0 0H20V10H0Z', 'M1 2H10', 'M1 2V10'])
  console.log(`${d} turned: ${new SVGPathData(d).matrix(...quarter).encode()}, after normalizeHVZ ${new SVGPathData(d).normalizeHVZ().matrix(...quarter).encode()}; svgpath ${svgpath(d).matrix(quarter)}`);
console.log(`M1 2V10 skewed: ${new SVGPathData('M1 2V10').matrix(1, 0, 1, 1, 0, 0).encode()}; svgpath ${svgpath('M1 2V10').matrix([1, 0, 1, 1, 0, 0])}`);
JS
node turn.mjs >seen
expect_in seen <<'END'
M0 0L20 0L20 10L0 10Z turned: M0 0L0 20L-10 20L-10 0z, after normalizeHVZ M0 0L0 20L-10 20L-10 0L0 0; svgpath M0 0L0 20-10 20-10 0Z
M0 0h20v10h-20z turned: M0 0l0 20l-10 0l0 -20z, after normalizeHVZ M0 0l0 20l-10 0l0 -20L0 0; svgpath M0 0l0 20-10 0 0-20z
M0 0H20V10H0Z turned: M0 0L0 20L-10 0L0 0z, after normalizeHVZ M0 0L0 20L-10 20L-10 0L0 0; svgpath M0 0L0 20-10 20-10 0Z
M1 2H10 turned: M-2 1L-1 10, after normalizeHVZ M-2 1L-2 10; svgpath M-2 1L-2 10
M1 2V10 turned: M-2 1L-10 -2, after normalizeHVZ M-2 1L-10 1; svgpath M-2 1L-10 1
M1 2V10 skewed: M3 2L13 10; svgpath M3 2L11 10
END
