#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 (RWGltf_CafReader) loses a part of a glTF scene: where two of its nodes show the same mesh and the first stands at the
# origin, the document's free shapes have the second alone. With both moved, or both below one node, they have both. Believed: two parts in
# each case, since a mesh may be shown by many nodes (glTF 2.0, 3.5.1).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
gltf 'first at the origin.gltf' '{"mesh": 0}' '{"mesh": 0, "translation": [0.05, 0, 0]}'
gltf 'both moved.gltf' '{"mesh": 0, "translation": [0.02, 0, 0]}' '{"mesh": 0, "translation": [0.05, 0, 0]}'
gltf 'below one node.gltf' '{"children": [1, 2]}' '{"mesh": 0}' '{"mesh": 0, "translation": [0.05, 0, 0]}'
for name in 'first at the origin' 'both moved' 'below one node'; do
  echo "$name:"
  read_gltf "$name.gltf"
done >seen
expect_in seen <<'END'
first at the origin:
part from 50.0 0.0 0.0 to 60.0 10.0 10.0, 1000 mm3
both moved:
part from 20.0 0.0 0.0 to 30.0 10.0 10.0, 1000 mm3
part from 50.0 0.0 0.0 to 60.0 10.0 10.0, 1000 mm3
below one node:
part from 0.0 0.0 0.0 to 10.0 10.0 10.0, 1000 mm3
part from 50.0 0.0 0.0 to 60.0 10.0 10.0, 1000 mm3
END
