#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# meshio 5.0.0 (Debian's 7.0.0-3) takes the relative references of an OBJ, where -1 is the latest vertex before the facet, for places counted
# from the end of the file, less one: of two facets 100 mm apart it makes one long facet across both, twice, and writes it into STL without a
# word; into OFF it writes negative indices. Believed: as by number (Wavefront's OBJ, "Referencing groups of vertices").
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-meshio=7.0.0-3
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
vertices() { printf 'v %d 0 0\nv %d 0 0\nv %d 10 0\n' "$1" $(($1 + 10)) "$1"; }
{ vertices 0; echo f 1 2 3; vertices 100; echo f 4 5 6; } >numbers.obj
{ vertices 0; echo f -3 -2 -1; vertices 100; echo f -3 -2 -1; } >relative.obj
cat >convert.py <<'PY'
import meshio
for name in ("numbers", "relative"):
    mesh = meshio.read(name + ".obj")
    for format in ("stl", "off"):
        meshio.write(name + "." + format, mesh)
    corners = [float(line.split()[1]) for line in open(name + ".stl") if line.split()[:1] == ["vertex"]]
    print(f"{name}: STL of facets", *(f"{min(x):g} to {max(x):g} mm," for x in (corners[:3], corners[3:])),
          "OFF of", ", ".join(line.strip() for line in open(name + ".off") if line.startswith("3 ")))
PY
python3 convert.py >seen
expect_in seen <<'END'
numbers: STL of facets 0 to 10 mm, 100 to 110 mm, OFF of 3 0 1 2, 3 3 4 5
relative: STL of facets 0 to 110 mm, 0 to 110 mm, OFF of 3 -4 -3 -2, 3 -4 -3 -2
END
