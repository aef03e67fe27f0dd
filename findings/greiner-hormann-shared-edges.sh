#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# greiner-hormann 1.5.0 computes other areas where outlines share an edge or a corner: a square less its right half is the whole square, a lug flush
# with a side is cut where it should be added and the other way round, a square that touches another at a corner vanishes from the sum.
# Nothing is said, nor in its README. Outlines that cross, or lie in each other, are right. Believed: as polygon-clipping 0.15.7.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages greiner-hormann@1.5.0 polygon-clipping@0.15.7
cat >areas.cjs <<'JS'
const greiner = require('greiner-hormann'), clipping = require('polygon-clipping');
const box = (x, y, width, height) => [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
const area = (ring) => Math.abs(ring.reduce((sum, [x, y], i) => sum + x * ring[(i + 1) % ring.length][1] - ring[(i + 1) % ring.length][0] * y, 0) / 2);
const square = box(0, 0, 10, 10);
for (const [name, other] of [['crosses', box(5, 3, 10, 10)], ['slot through', box(3, -5, 4, 20)], ['right half', box(5, 0, 10, 10)], ['slot flush with both sides', box(3, 0, 4, 10)],
  ['lug flush with a side', box(10, 3, 4, 4)], ['touches at a corner', box(10, 10, 10, 10)]]) {
  const seen = [greiner.diff, greiner.union, greiner.intersection].map((it) => (it(square, other) || []).reduce((sum, ring) => sum + area(ring), 0));
  const right = [clipping.difference, clipping.union, clipping.intersection].map((it) => it([square], [other]).flat().reduce((sum, ring) => sum + area(ring), 0));
  console.log(`${name}: difference, union, intersection ${seen.join(' ')}, right ${right.join(' ')}`);
}
JS
node areas.cjs >seen
expect_in seen <<'END'
crosses: difference, union, intersection 65 165 35, right 65 165 35
slot through: difference, union, intersection 60 140 40, right 60 140 40
right half: difference, union, intersection 100 200 0, right 50 150 50
slot flush with both sides: difference, union, intersection 100 140 0, right 60 100 40
lug flush with a side: difference, union, intersection 116 100 16, right 100 116 0
touches at a corner: difference, union, intersection 200 100 100, right 100 200 0
END
