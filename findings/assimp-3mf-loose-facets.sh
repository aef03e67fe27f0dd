#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# assimp 5.2.5 writes the 3MF of a closed box (STL, 12 facets) with 36 corners, three for each facet: no edge belongs to two triangles,
# as the core specification asks of objects of type "model". Believed: equal corners are one.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1
box_stl box 0 >box.stl
assimp export box.stl box.3mf >/dev/null
python3 - >seen <<'PY'
import re, zipfile
text = zipfile.ZipFile("box.3mf").read("3D/3DModel.model").decode()
corners = re.findall(r'<vertex x="([^"]*)" y="([^"]*)" z="([^"]*)"', text)
print(f"{len(corners)} corners at {len(set(corners))} places")
PY
expect_in seen <<'END'
36 corners at 8 places
END
