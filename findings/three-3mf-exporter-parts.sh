#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three-3mf-exporter 45.2.0 (three.js 0.160.0) leaves out of a 3MF what hangs below a mesh (a bolt added to its plate), below a level of
# detail, and all copies of an instanced mesh but one, and places at the origin what is placed by a matrix of its own (matrixAutoUpdate
# off). It writes what is hidden. It ends with success. Places of groups are right. Believed: all visible boxes, as three.js draws them; the
# common shift of the whole to the middle of the bed is said in its README.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three-3mf-exporter@45.2.0 three@0.160.0
cat >write.mjs <<'JS'
import { writeFileSync } from "node:fs";
import * as THREE from "three";
import { exportTo3MF } from "three-3mf-exporter";

const shape = new THREE.BoxGeometry(10, 10, 10), paint = new THREE.MeshBasicMaterial();
const box = (x = 0) => {
  const made = new THREE.Mesh(shape, paint);
  made.position.x = x;
  return made;
};
const beside = (...parts) => new THREE.Scene().add(box(), ...parts);
const copies = new THREE.InstancedMesh(shape, paint, 3);
for (const i of [0, 1, 2]) copies.setMatrixAt(i, new THREE.Matrix4().makeTranslation(30 + 30 * i, 0, 0));
const fixed = box();
fixed.matrixAutoUpdate = false;
fixed.matrix.makeTranslation(30, 0, 0);
const hidden = box(30);
hidden.visible = false;
const group = new THREE.Group().add(box(30));
const scenes = {
  "a box and a group with a box": beside(group), "a box with a box below it": new THREE.Scene().add(box().add(box(30))), "a box and a level of detail": beside(new THREE.LOD().addLevel(box(30))),
  "a box and an instanced mesh of three": beside(copies), "a box and one placed by its matrix": beside(fixed), "a box and a hidden one": beside(hidden),
};
for (const [name, scene] of Object.entries(scenes)) {
  scene.updateMatrixWorld(true);
  let drawn = 0, low = Infinity, high = -Infinity;
  scene.traverseVisible((it) => {
    if (!it.isMesh) return;
    for (let i = 0; i < (it.count ?? 1); ++i) {
      const place = new THREE.Matrix4();
      if (it.isInstancedMesh) it.getMatrixAt(i, place);
      const x = place.premultiply(it.matrixWorld).elements[12];
      drawn += 1, low = Math.min(low, x - 5), high = Math.max(high, x + 5);
    }
  });
  writeFileSync(name + ".3mf", Buffer.from(await (await exportTo3MF(scene)).arrayBuffer()));
  writeFileSync(name + ".txt", `${name}: ${drawn} drawn, ${high - low} long`);
}
JS
cat >read.py <<'PY'
import glob, zipfile
import xml.etree.ElementTree as xml

space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
for name in sorted(glob.glob("*.3mf")):
    model = xml.fromstring(zipfile.ZipFile(name).read("3D/3dmodel.model"))
    objects = {it.get("id"): it for it in model.iter(space + "object")}

    def middles(reference):  # of its boxes, none of which is turned or scaled
        offset = float(reference.get("transform").split()[9])
        parts = list(objects[reference.get("objectid")].iter(space + "component"))
        return [offset + x for part in parts for x in middles(part)] if parts else [offset]

    all_of = [x for item in model.iter(space + "item") for x in middles(item)]
    print(f"{open(name[:-3] + 'txt').read()}; {len(all_of)} written, {max(all_of) - min(all_of) + 10:g} long")
PY
node write.mjs
python3 read.py >seen
expect_in seen <<'END'
a box and a group with a box: 2 drawn, 40 long; 2 written, 40 long
a box and a hidden one: 1 drawn, 10 long; 2 written, 40 long
a box and a level of detail: 2 drawn, 40 long; 1 written, 10 long
a box and an instanced mesh of three: 4 drawn, 100 long; 2 written, 10 long
a box and one placed by its matrix: 2 drawn, 40 long; 2 written, 10 long
a box with a box below it: 2 drawn, 40 long; 1 written, 10 long
END
