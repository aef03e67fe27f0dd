#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# tovrmlx3d 4.2.0 (converter of view3dscene, Castle Game Engine) takes the matrix of a glTF node that mirrors a part for a turn about no axis: the
# part comes as it was, a left one for a right one, on the other side of where it should be; what is mirrored at all three axes is turned half about z.
# Nodes mirrored by their scale are right, and so are turns, moves and scales by a matrix. It ends with success. Believed: the place
# that the matrix gives (glTF 2.0, 3.5.3), which X3D has as a negative scale.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages view3dscene=4.2.0-1
while IFS='|' read -r name node; do
  gltf part.gltf "{\"mesh\": 0, $node}"
  tovrmlx3d part.gltf >part.x3dv
  echo "$name: $(sed -nE 's/^\t((translation|rotation|scale) .*)/\1/p' part.x3dv | sed -E 's/(\.[0-9]{4})[0-9]*/\1/g' | paste -sd ' ')"
done >seen <<'END'
turned by 90 degrees about z|"matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
moved and scaled|"matrix": [2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 1, 2, 3, 1]
mirrored along x by its scale|"scale": [-1, 1, 1]
mirrored along x by its matrix|"matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
x and y exchanged|"matrix": [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
mirrored along x, y and z|"matrix": [-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1]
mirrored along x, moved by 1 2 3|"matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]
END
expect_in seen <<'END'
turned by 90 degrees about z: rotation 0 0 1 1.5707
moved and scaled: scale 2 3 4 translation 1 2 3
mirrored along x by its scale: scale -1 1 1
mirrored along x by its matrix: rotation 0 0 0 0.0006
x and y exchanged: rotation 0 0 0 0.0006
mirrored along x, y and z: rotation 0 0 0.9999 3.1415
mirrored along x, moved by 1 2 3: rotation 0 0 0 0.0006 translation 1 2 3
END
