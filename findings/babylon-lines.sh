#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Babylon.js 9.28.0 writes the lines of a scene, such as edges and axes, as faces: OBJExport into OBJ whose corners are called NaN, STLExport as
# facets without area between two ends. A mesh without normals, such as lines are, shifts the normals of all meshes behind it in the OBJ: those of
# a box behind one of three corners begin with its fourth normal, and the last three are not there. Nothing is said. Believed: lines as
# lines (l), or left out, and normals counted apart from corners (Wavefront's OBJ, "Referencing vertex data").
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @babylonjs/core@9.28.0 @babylonjs/serializers@9.28.0
cat >lines.cjs <<'JS'
const { Mesh, MeshBuilder, NullEngine, Scene, Vector3, VertexData } = require('@babylonjs/core');
const { OBJExport, STLExport } = require('@babylonjs/serializers');
const scene = new Scene(new NullEngine());
const box = MeshBuilder.CreateBox('box', { size: 10 }, scene);
const line = MeshBuilder.CreateLines('line', { points: [new Vector3(0, 0, 0), new Vector3(50, 0, 0), new Vector3(50, 50, 0)] }, scene);
const facet = new Mesh('facet', scene), data = new VertexData();
Object.assign(data, { positions: [0, 0, 0, 10, 0, 0, 0, 10, 0], indices: [0, 1, 2] });
data.applyToMesh(facet);
const described = (name, meshes) => {
  const text = OBJExport.OBJ(meshes, false, '', true);
  const faces = text.match(/^f .*$/gm), normals = text.match(/^vn /gm).length, lines = (text.match(/^l /gm) || []).length;
  const beyond = faces.filter((face) => face.split(' ').some((corner) => +corner.split('/')[2] > normals)).length;
  console.log(`${name}, OBJ: ${lines} lines, ${faces.length} faces, of corners NaN ${faces.filter((face) => /NaN/.test(face)).length}, `
    + `of normals beyond the ${normals} of the file ${beyond}`);
};
described('box alone', [box]);
described('box and line', [box, line]);
described('facet without normals and box', [facet, box]);
const facets = STLExport.CreateSTL([box, line], false, '', false, false).split('endfacet').slice(12, -1);
console.log('box and line, STL: 12 facets and ' + facets.map((one) => one.match(/vertex.*/g).map((corner) => corner.slice(7)).join(', ')).join('; '));
JS
node lines.cjs | grep -v BJS >seen
expect_in seen <<'END'
box alone, OBJ: 0 lines, 12 faces, of corners NaN 0, of normals beyond the 24 of the file 0
box and line, OBJ: 0 lines, 14 faces, of corners NaN 1, of normals beyond the 24 of the file 0
facet without normals and box, OBJ: 0 lines, 13 faces, of corners NaN 0, of normals beyond the 24 of the file 2
box and line, STL: 12 facets and 0 0 0, 50 0 0, 50 0 0; 50 0 50, 0 0 0, 0 0 0
END
