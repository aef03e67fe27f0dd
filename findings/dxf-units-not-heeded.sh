#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A DXF in inches ($INSUNITS 1) with a line of 10 is 10 mm long in OpenSCAD 2021.01 and @jscad/dxf-deserializer 2.3.30, which both
# work in mm. Believed: it is 254 mm, or a warning is given.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/dxf-deserializer@2.3.30 @jscad/modeling@2.13.0
debian_packages openscad=2021.01-6
drawing() {  # units
  printf '%s\n' 0 SECTION 2 HEADER 9 '$ACADVER' 1 AC1015 9 '$INSUNITS' 70 "$1" 0 ENDSEC 0 SECTION 2 ENTITIES
  printf '%s\n' 0 LWPOLYLINE 8 0 90 4 70 1 10 0 20 0 10 10 20 0 10 10 20 5 10 0 20 5
  printf '%s\n' 0 ENDSEC 0 EOF
}
cat >read.cjs <<'JS'
const { deserialize } = require('@jscad/dxf-deserializer');
const { measureBoundingBox } = require('@jscad/modeling').measurements;
const [low, high] = measureBoundingBox([].concat(deserialize({ output: 'geometry' }, require('fs').readFileSync(process.argv[2], 'utf8')))[0]);
console.log(high[0] - low[0]);
JS
for units in 1 4; do
  drawing "$units" >"$units.dxf"
  echo "import(\"$units.dxf\");" >"$units.scad"
  openscad -o "$units.svg" "$units.scad" 2>"$units.log"
  echo "units $units: OpenSCAD $(grep -o 'width="[0-9.]*mm"' "$units.svg"), warnings $(grep -ci warning "$units.log" || true), JSCAD $(node read.cjs "$units.dxf")"
done >seen
expect_in seen <<'END'
units 1: OpenSCAD width="10mm", warnings 0, JSCAD 10
units 4: OpenSCAD width="10mm", warnings 0, JSCAD 10
END
