#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Babylon.js 9.28.0 (ThreeMfSerializer) numbers the objects of a 3MF from 0, where resources have positive numbers (3MF core specification,
# ST_ResourceID): OpenSCAD 2021.01, which reads by lib3mf, refuses the file whole; the same file numbered from 1 it reads. assimp 5.2.5 reads both.
# Copies (instances) are left out unless asked for, as the page of the option says. Believed: a file that the library of the consortium
# reads.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @babylonjs/core@9.28.0 @babylonjs/serializers@9.28.0 fflate@0.8.2
debian_packages openscad=2021.01-6 assimp-utils=5.2.5~ds0-1+b1
cat >export.cjs <<'JS'
const { MeshBuilder, NullEngine, Scene } = require('@babylonjs/core');
const { ThreeMfSerializer } = require('@babylonjs/serializers');
const { strFromU8, strToU8, unzipSync, zipSync } = globalThis.fflate = require('fflate');
const { writeFileSync } = require('fs');
const scene = new Scene(new NullEngine());
const box = MeshBuilder.CreateBox('box', { width: 10, height: 20, depth: 30 }, scene);
box.computeWorldMatrix(true);
const pieces = [];
new ThreeMfSerializer({ unit: 'millimeter' }).serializeAsync((error, piece) => piece && pieces.push(Buffer.from(piece)), box).then(() => {
  const file = Buffer.concat(pieces), parts = unzipSync(new Uint8Array(file));
  const model = strFromU8(parts['3D/3dmodel.model']);
  console.log(model.match(/<object [^>]*>|<item objectid="\d+"/g).join(' '));
  writeFileSync('written.3mf', file);
  parts['3D/3dmodel.model'] = strToU8(model.replace(/(object id|objectid)="(\d+)"/g, (all, name, number) => `${name}="${+number + 1}"`));
  writeFileSync('numbered from 1.3mf', zipSync(parts));
});
JS
node export.cjs | grep '<' >seen
for name in 'written' 'numbered from 1'; do
  echo "import(\"$name.3mf\");" >read.scad
  openscad -o read.off read.scad >messages 2>&1 && echo "$name, OpenSCAD: $(extent read.off)" || echo "$name, OpenSCAD: $(grep -o 'Could not read file' messages)"
  rm -f read.off
  assimp info "$name.3mf" | sed -n "s/^Faces: */$name, assimp: faces /p"
done >>seen
expect_in seen <<'END'
<object id="0" type="model" name="box"> <item objectid="0"
written, OpenSCAD: Could not read file
written, assimp: faces 12
numbered from 1, OpenSCAD: -5..5 -10..10 -15..15
numbered from 1, assimp: faces 12
END
