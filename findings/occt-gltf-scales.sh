#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 (RWGltf_CafReader): a glTF node that is scaled by 3 along x alone becomes one scaled by 1.44, the cube root of 3, along
# all axes, of the same volume; if the node has a matrix, without a word (by "scale", with a warning). A mirrored one is inside out. Believed:
# 30 x 10 x 10 mm, as glTF 2.0 (3.5.3) has it, or refused; and what is mirrored turned by its negative determinant (3.7.4).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
gltf plain.gltf '{"mesh": 0}'
gltf even.gltf '{"mesh": 0, "scale": [2, 2, 2]}'
gltf uneven.gltf '{"mesh": 0, "scale": [3, 1, 1]}'
gltf matrix.gltf '{"mesh": 0, "matrix": [3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}'
gltf mirrored.gltf '{"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}'
for name in plain even uneven matrix mirrored; do
  echo "$name: $(read_gltf $name.gltf)"
done >seen
expect_in seen <<'END'
plain: part from 0.0 0.0 0.0 to 10.0 10.0 10.0, 1000 mm3
even: part from 0.0 0.0 0.0 to 20.0 20.0 20.0, 8000 mm3
uneven: part from 0.0 0.0 0.0 to 14.4 14.4 14.4, 3000 mm3
matrix: part from 0.0 0.0 0.0 to 14.4 14.4 14.4, 3000 mm3
mirrored: part from -10.0 0.0 0.0 to 0.0 10.0 10.0, -1000 mm3
END
