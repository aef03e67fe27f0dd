#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: STLExporter and OBJExporter write an InstancedMesh of three boxes as one box, at the place of the mesh and not of
# any instance, without a word. Believed: what is seen is written, three times 12 facets.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >instances.mjs <<'JS'
import { BoxGeometry, InstancedMesh, Matrix4 } from 'three';
import { STLExporter } from 'three/examples/jsm/exporters/STLExporter.js';
import { OBJExporter } from 'three/examples/jsm/exporters/OBJExporter.js';
const mesh = new InstancedMesh(new BoxGeometry(1, 1, 1), undefined, 3);
for (let i = 0; i < 3; ++i) mesh.setMatrixAt(i, new Matrix4().makeTranslation(10 + 2 * i, 0, 0));
mesh.updateMatrixWorld();
const stl = new STLExporter().parse(mesh);
const x = [...stl.matchAll(/vertex (\S+)/g)].map(match => Number(match[1]));
console.log(`STL ${stl.match(/facet normal/g).length} facets, x ${Math.min(...x)} to ${Math.max(...x)}`);
console.log(`OBJ ${new OBJExporter().parse(mesh).match(/^f /gm).length} faces`);
JS
node instances.mjs >seen
expect_in seen <<'END'
STL 12 facets, x -0.5 to 0.5
OBJ 12 faces
END
