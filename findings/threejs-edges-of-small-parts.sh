#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: EdgesGeometry tells corners apart by four decimals. A box of 0.1 mm in a model in metres, the unit of glTF,
# has no edge at all; one of 1 mm has its twelve. Believed: edges depend on angles, not on the unit.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >edges.mjs <<'JS'
import { BoxGeometry, EdgesGeometry } from 'three';
for (const side of [1, 0.001, 0.0001])
  console.log(side, new EdgesGeometry(new BoxGeometry(side, side, side)).attributes.position.count / 2);
JS
node edges.mjs >seen
expect_in seen <<'END'
1 12
0.001 12
0.0001 0
END
