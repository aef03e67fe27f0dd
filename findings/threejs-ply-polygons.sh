#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: PLYLoader reads faces of three and four corners and drops those of more without a word: of a hexagonal bar whose
# sides are quads the ends are missing, half of its surface. In a file of such faces only, what is left has no faces, and is drawn as
# triangles of any three corners in a row. Believed: PLY has polygons, as its name says.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >bar.mjs <<'JS'
import { Vector3 } from 'three';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
const ply = (corners, faces) => ['ply', 'format ascii 1.0', `element vertex ${corners.length}`, ...'xyz'].map((word, i) => (i > 2 ? `property float ${word}` : word))
  .concat(`element face ${faces.length}`, 'property list uchar int vertex_indices', 'end_header',
          ...corners.map(corner => corner.join(' ')), ...faces.map(face => [face.length, ...face].join(' ')), '').join('\n');
const report = (name, corners, faces) => {
  const { index, attributes: { position } } = new PLYLoader().parse(ply(corners, faces));
  const corner = i => new Vector3().fromBufferAttribute(position, index ? index.getX(i) : i);
  let area = 0;
  const count = index ? index.count : position.count;
  for (let i = 0; i + 2 < count; i += 3) area += corner(i + 1).sub(corner(i)).cross(corner(i + 2).sub(corner(i))).length() / 2;
  console.log(`${name}: ${index ? index.count / 3 : 'no'} triangles, area ${area.toFixed(1)}`);
};
const ring = [0, 1, 2, 3, 4, 5];
const hexagon = z => ring.map(i => [10 * Math.cos((i * Math.PI) / 3), 10 * Math.sin((i * Math.PI) / 3), z]);
const sides = ring.map(i => [i, (i + 1) % 6, ((i + 1) % 6) + 6, i + 6]);
const ends = [ring.toReversed(), ring.map(i => i + 6)];
const triangles = ends.flatMap(end => [1, 2, 3, 4].map(i => [end[0], end[i], end[i + 1]]));
const bar = [...hexagon(0), ...hexagon(8)];
report('bar, ends as triangles', bar, [...sides, ...triangles]);
report('bar, ends as hexagons', bar, [...sides, ...ends]);
report('ends as hexagons only', bar, ends);
JS
node bar.mjs >seen
expect_in seen <<'END'
bar, ends as triangles: 20 triangles, area 999.6
bar, ends as hexagons: 12 triangles, area 480.0
ends as hexagons only: no triangles, area 173.2
END
