#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Babylon.js 9.28.0 exchanges y and z of each STL that it reads or writes, which turns its left-handed scene into the right-handed file, in right-handed
# scenes (useRightHandedSystem), too: there a left part becomes a right one, with its facets turned so that it stays closed: as read, in
# the OBJ and glTF that are made of it, and in the STL that is made of an OBJ. From STL to STL it is undone. Left-handed scenes are right. Nothing
# is said. Believed: right-handed files are read into right-handed scenes as they are.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @babylonjs/core@9.28.0 @babylonjs/loaders@9.28.0 @babylonjs/serializers@9.28.0
cat >convert.cjs <<'JS'
const { NullEngine, Scene, SceneLoader } = require("@babylonjs/core");
require("@babylonjs/loaders");
const { GLTF2Export, OBJExport, STLExport } = require("@babylonjs/serializers");
const corners = [[0, 0, 0], [10, 0, 0], [0, 20, 0], [0, 0, 30]], facets = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];  // edges along x, y and z
const files = {
  ".obj": corners.map((it) => `v ${it.join(" ")}\n`).join("") + facets.map((it) => `f ${it.map((i) => i + 1).join(" ")}\n`).join(""),
  ".stl": "solid part\n" + facets.map((it) => `facet normal 0 0 0\nouter loop\n${it.map((i) => `vertex ${corners[i].join(" ")}\n`).join("")}endloop\nendfacet\n`).join("") + "endsolid part\n",
};
const numbers = (text, word) => [...text.matchAll(new RegExp(`^\\s*${word} (\\S+) (\\S+) (\\S+)`, "gm"))].map((it) => it.slice(1).map(Number));
const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => Array.from(flat.slice(3 * i, 3 * i + 3)));
const minus = (a, b) => a.map((x, i) => x - b[i]), dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
// The part is right if its edges of 10, 20 and 30 follow each other as x, y and z.
const side = (points) => {
  for (const root of points) {
    const [a, b, c] = [10, 20, 30].map((length) => points.map((it) => minus(it, root)).find((it) => Math.abs(Math.hypot(...it) - length) < 1e-3));
    if (a && b && c && Math.abs(dot(a, b)) + Math.abs(dot(b, c)) + Math.abs(dot(c, a)) < 1) return dot(cross(a, b), c) > 0 ? "as it was" : "mirrored";
  }
};
(async () => {
  const engine = new NullEngine();
  for (const rightHanded of [true, false])
    for (const [ending, text] of Object.entries(files)) {
      const scene = new Scene(engine);
      scene.useRightHandedSystem = rightHanded;
      await SceneLoader.AppendAsync("", "data:" + text, scene, undefined, ending);
      const meshes = scene.meshes.filter((it) => it.getTotalVertices() > 0);
      const gltf = (await GLTF2Export.GLTFAsync(scene, "part")).files;
      const json = JSON.parse(gltf["part.gltf"]), places = json.accessors[json.meshes[0].primitives[0].attributes.POSITION], view = json.bufferViews[places.bufferView];
      const buffer = Buffer.from(await gltf["part.bin"].arrayBuffer());
      const floats = Array.from({ length: 3 * places.count }, (_, i) => buffer.readFloatLE((view.byteOffset || 0) + (places.byteOffset || 0) + (view.byteStride || 12) * Math.floor(i / 3) + 4 * (i % 3)));
      const results = {
        OBJ: numbers(OBJExport.OBJ(meshes, false, "", true), "v"), STL: numbers(STLExport.CreateSTL(meshes, false, "", false, false), "vertex"), glTF: triples(floats),
      };
      if (rightHanded) results.scene = triples(meshes[0].getVerticesData("position"));
      console.log(`${rightHanded ? "right" : "left"}-handed scene, ${ending.slice(1).toUpperCase()} read: ${Object.entries(results).map(([name, points]) => `${name} ${side(points)}`).join(", ")}`);
    }
})();
JS
node convert.cjs | grep read: >seen
expect_in seen <<'END'
right-handed scene, OBJ read: OBJ as it was, STL mirrored, glTF as it was, scene as it was
right-handed scene, STL read: OBJ mirrored, STL as it was, glTF mirrored, scene mirrored
left-handed scene, OBJ read: OBJ as it was, STL as it was, glTF as it was
left-handed scene, STL read: OBJ as it was, STL as it was, glTF as it was
END
