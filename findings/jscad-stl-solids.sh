#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/stl-deserializer 2.1.30 makes of an ASCII STL of n solids, as CAD programs write assemblies, n bodies of which each has the facets of all:
# of three boxes beside each other there are nine, three at each place, and none can be moved, coloured, left out or counted by itself.
# The script that it writes has the same bodies. Nothing is said. One solid is right. Believed: a body for each solid.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/stl-deserializer@2.1.30 @jscad/modeling@2.13.0
cat >read.js <<'JS'
const { readFileSync } = require("fs");
const { deserialize } = require("@jscad/stl-deserializer");
const { measureBoundingBox } = require("@jscad/modeling").measurements;
for (const file of ["1 solid", "2 solids", "3 solids"]) {
  const text = readFileSync(file + ".stl", "utf8");
  for (const body of [deserialize({ output: "geometry" }, text)].flat()) {
    const [low, high] = measureBoundingBox(body);
    console.log(`${file}: a body of ${body.polygons.length} facets, x ${low[0]} to ${high[0]}`);
  }
  const script = deserialize({ output: "script" }, text);
  console.log(`${file} as a script: ${[...script.matchAll(/(\d+) faces/g)].map((it) => it[1] + " facets").join(", ")}`);
}
JS
box_stl a 0 >"1 solid.stl"
{ cat "1 solid.stl"; box_stl b 20; } >"2 solids.stl"
{ cat "2 solids.stl"; box_stl c 40; } >"3 solids.stl"
node read.js >seen
expect_in seen <<'END'
1 solid: a body of 12 facets, x 0 to 10
1 solid as a script: 12 facets
2 solids: a body of 24 facets, x 0 to 30
2 solids: a body of 24 facets, x 0 to 30
2 solids as a script: 24 facets, 24 facets
3 solids: a body of 36 facets, x 0 to 50
3 solids: a body of 36 facets, x 0 to 50
3 solids: a body of 36 facets, x 0 to 50
3 solids as a script: 36 facets, 36 facets, 36 facets
END
