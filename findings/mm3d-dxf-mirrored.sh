#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Maverick Model 3D 1.3.13 (mm3d) makes the mirror image of a model when it converts DXF into OBJ or OBJ into DXF: it exchanges y and z, which
# no turn does, so that a left part becomes a right one, inside out. It leaves out what stands in blocks, as many parts of drawings do, and
# ends with success. Believed: y up for z up, by a turn about x; parts of blocks where they are inserted.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages mm3d=1.3.13-1
export HOME=$work QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR=$work
cat >models.py <<'PY'
import sys

# A tetrahedron with one corner at the origin and edges of 10, 20 and 30 along x, y and z.
corners = [(0, 0, 0), (10, 0, 0), (0, 20, 0), (0, 0, 30)]
facets = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]

def tags(*pairs):
    return "".join(f"{code}\n{value}\n" for code, value in pairs)

def face(points):
    points = [*points, points[-1]]
    return tags((0, "3DFACE"), (8, "0"), *((10 * (axis + 1) + k, p[axis]) for k, p in enumerate(points) for axis in range(3)))

def dxf(name, blocks, entities):
    with open(name, "w") as file:
        file.write(tags((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), (0, "ENDSEC"), (0, "SECTION"), (2, "BLOCKS")) + blocks
                   + tags((0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")) + entities + tags((0, "ENDSEC"), (0, "EOF")))

def write():
    body = "".join(face([corners[i] for i in facet]) for facet in facets)
    dxf("faces.dxf", "", body)
    dxf("block.dxf", tags((0, "BLOCK"), (8, "0"), (2, "PART"), (70, 0), (10, 0), (20, 0), (30, 0), (3, "PART")) + body + tags((0, "ENDBLK"), (8, "0")),
        tags((0, "INSERT"), (8, "0"), (2, "PART"), (10, 0), (20, 0), (30, 0)))
    with open("model.obj", "w") as file:
        file.write("".join("v %d %d %d\n" % corner for corner in corners) + "".join("f %d %d %d\n" % tuple(i + 1 for i in facet) for facet in facets))

def read(name):
    if name.endswith(".obj"):
        lines = [line.split() for line in open(name)]
        points = [tuple(map(float, line[1:4])) for line in lines if line[:1] == ["v"]]
        return [[points[int(word.split("/")[0]) - 1] for word in line[1:]] for line in lines if line[:1] == ["f"]]
    words = open(name).read().split()
    faces, face = [], None
    for code, value in zip(words[::2], words[1::2]):
        if code == "0":
            face = {}
            if value == "3DFACE":
                faces.append(face)
        elif face is not None:
            face[int(code)] = value
    return [[tuple(float(face[10 * (axis + 1) + k]) for axis in range(3)) for k in range(3)] for face in faces]

def det(a, b, c):
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])

def say(name):
    faces = read(name)
    if not faces:
        return "nothing"
    edges = {round(max(map(abs, p))): tuple(round(value) + 0 for value in p) for face in faces for p in face if any(p)}
    hand = "right-handed, as the model" if det(edges[10], edges[20], edges[30]) > 0 else "left-handed: mirrored"
    return f"edges {edges[10]} {edges[20]} {edges[30]}, {hand}; volume by its facets {sum(det(*face) for face in faces) / 6:.0f}"

if sys.argv[1] == "write":
    write()
else:
    print(sys.argv[1] + ": " + say(sys.argv[2]))
PY
python3 models.py write
mkdir out
convert_model() {  # FROM TO
  cp "$1" "out/part.${1##*.}"
  rm -f "out/part.$2"
  (cd out && mm3d --convert "$2" "part.${1##*.}" >messages 2>&1)
  python3 models.py "$1 into $2" "out/part.$2"
}
{
  python3 models.py "the model in DXF" faces.dxf
  convert_model faces.dxf obj
  convert_model model.obj dxf
  convert_model block.dxf obj
} >seen
expect_in seen <<'END'
the model in DXF: edges (10, 0, 0) (0, 20, 0) (0, 0, 30), right-handed, as the model; volume by its facets 1000
faces.dxf into obj: edges (10, 0, 0) (0, 0, 20) (0, 30, 0), left-handed: mirrored; volume by its facets -1000
model.obj into dxf: edges (10, 0, 0) (0, 0, 20) (0, 30, 0), left-handed: mirrored; volume by its facets -1000
block.dxf into obj: nothing
END
