#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# JSCAD (@jscad/3mf-serializer 2.1.17) leaves a body without facets, such as the intersection of two parts that do not touch, out of the objects of a
# 3MF, but not out of what is to be built: OpenSCAD 2021.01 refuses the whole file, with all other parts. Of the units that its
# documentation names, "feet" and "micrometer" are none of 3MF ("foot", "micron"). It says nothing. Believed: valid files.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/3mf-serializer@2.1.17 @jscad/modeling@2.13.0
debian_packages openscad=2021.01-6
cat >write.cjs <<'JS'
const { booleans, primitives, transforms } = require('@jscad/modeling'), { serialize } = require('@jscad/3mf-serializer');
const { readFileSync, writeFileSync } = require('fs');
const box = primitives.cube({ size: 10 }), nothing = booleans.intersect(box, transforms.translate([100, 0, 0], box));
for (const [name, parts] of Object.entries({ one: [box], two: [box, transforms.translate([20, 0, 0], box)], empty: [box, nothing] })) {
  writeFileSync(name + '.3mf', Buffer.from(serialize({}, ...parts)[0]));
  const ids = (pattern) => [...serialize({ compress: false }, ...parts)[0].matchAll(pattern)].map(([, id]) => id).join(' ');
  writeFileSync(name + '.txt', `objects ${ids(/<object id="(.*?)"/g)}, to be built ${ids(/<item objectid="(.*?)"/g)}`);
}
const named = readFileSync(require.resolve('@jscad/3mf-serializer'), 'utf8').match(/options\.unit='millimeter'\] - (.*)/)[1];
console.log('documented: ' + named);
console.log('written: ' + ['feet', 'micrometer'].map((unit) => serialize({ unit, compress: false }, box)[0].match(/unit=".*?"/)[0]).join(' '));
JS
{
  node write.cjs
  for part in one two empty; do
    echo "import(\"$work/$part.3mf\");" >part.scad
    openscad -o part.off part.scad >messages 2>&1 && told=$(extent part.off) || told=$(grep -o 'WARNING: Could not read file' messages)
    echo "$part: $(cat $part.txt); OpenSCAD: $told"
  done
} >seen
expect_in seen <<'END'
documented: unit of design; millimeter, inch, feet, meter or micrometer
written: unit="feet" unit="micrometer"
one: objects 1, to be built 1; OpenSCAD: -5..5 -5..5 -5..5
two: objects 1 2, to be built 1 2; OpenSCAD: -5..25 -5..5 -5..5
empty: objects 1, to be built 1 2; OpenSCAD: WARNING: Could not read file
END
