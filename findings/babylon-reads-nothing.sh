#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Babylon.js 9.28.0 reads nothing of an ASCII STL whose solids have no names, as GTS 0.7.6 (gts2stl) writes them, and no face of an OBJ whose faces refer
# to the latest corners (-3 -2 -1), go on in the next line after a backslash, or have tabs, which also makes its corners no numbers. Loading succeeds, and
# the part is not there; its log names such faces as unhandled, of the rest nothing is said. Lines of an OBJ become facets without area.
# Names, blanks, exponents and concave faces are right.
# Believed: the part in each case (names are optional in STL; Wavefront's OBJ, "General statement" and "Referencing groups of vertices").
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libgts-bin=0.7.6+darcs121130-5+b1
npm_packages @babylonjs/core@9.28.0 @babylonjs/loaders@9.28.0
corners='v 0 0 0\nv 10 0 0\nv 0 20 0\nv 0 0 30\n'
box_stl part 0 >"named.stl"
stl2gts <named.stl | gts2stl >"by GTS.stl"
printf "${corners}f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n" >"by number.obj"
printf "${corners}f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n" >"relative.obj"
printf "${corners}f 1 3 \\\\\n2\nf 1 2 \\\\\n4\nf 2 3 \\\\\n4\nf 1 4 \\\\\n3\n" >"continued.obj"
tr ' ' '\t' <"by number.obj" >"tabs.obj"
{ cat "by number.obj"; echo "l 1 2"; } >"with a line.obj"
cat >read.cjs <<'JS'
const { readFileSync } = require("fs");
const { NullEngine, Scene, SceneLoader } = require("@babylonjs/core");
require("@babylonjs/loaders");
(async () => {
  const engine = new NullEngine();
  for (const file of ["named.stl", "by GTS.stl", "by number.obj", "relative.obj", "continued.obj", "tabs.obj", "with a line.obj"]) {
    const scene = new Scene(engine);
    await SceneLoader.AppendAsync("", "data:" + readFileSync(file, "utf8"), scene, undefined, file.slice(-4));
    const meshes = scene.meshes.filter((it) => it.getTotalVertices() > 0);
    const facets = meshes.reduce((sum, it) => sum + it.getTotalIndices() / 3, 0), places = meshes.flatMap((it) => [...it.getVerticesData("position")]);
    console.log(`read ${file}: ${meshes.length} meshes, ${facets} facets${places.some(Number.isNaN) ? ", corners are no numbers" : ""}`);
  }
})();
JS
node read.cjs | grep ^read >seen
expect_in seen <<'END'
read named.stl: 1 meshes, 12 facets
read by GTS.stl: 0 meshes, 0 facets
read by number.obj: 1 meshes, 4 facets
read relative.obj: 1 meshes, 0 facets
read continued.obj: 1 meshes, 0 facets
read tabs.obj: 1 meshes, 0 facets, corners are no numbers
read with a line.obj: 1 meshes, 5 facets
END
