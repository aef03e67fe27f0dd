#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open3D 0.16.1 (Debian's +ds-2) reads an OBJ with a single face of four corners among its triangles as an empty mesh, and so most OBJ that
# modellers write; it returns as usual, and informs that it skips "non-triangle primitive geometry". The same faces in OFF and PLY are
# all read. A body mirrored by transform is inside out. Believed: 12 triangles of 1000 mm3 from each.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-open3d=0.16.1+ds-2+b4
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$work/root/usr/lib/x86_64-linux-gnu/open-coarrays
cat >quads.py <<'PY'
import numpy, open3d

points = [[10 * (i >> axis & 1) for axis in range(3)] for i in range(8)]
quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
halves = [face for a, b, c, d in quads for face in ([a, b, c], [a, c, d])]
line = lambda values: " ".join(map(str, values)) + "\n"

def obj(faces):
    return "".join("v " + line(point) for point in points) + "".join("f " + line(i + 1 for i in face) for face in faces)

def off(faces):
    return f"OFF\n8 {len(faces)} 0\n" + "".join(map(line, points)) + "".join(line([len(face)] + face) for face in faces)

def ply(faces):
    return (f"ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face {len(faces)}\n"
            "property list uchar int vertex_indices\nend_header\n" + "".join(map(line, points)) + "".join(line([len(face)] + face) for face in faces))

def say(what, mesh):
    corners, faces = numpy.asarray(mesh.vertices), numpy.asarray(mesh.triangles)
    volume = sum(corners[a] @ numpy.cross(corners[b], corners[c]) for a, b, c in faces) / 6
    print(f"{what}: {len(corners)} points, {len(faces)} triangles, {volume:.0f} mm3")

open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Warning)
for writer in (off, ply, obj):
    for what, faces in (("triangles", halves), ("quads", quads), ("10 triangles and a quad", halves[:10] + quads[5:])):
        name = "box." + writer.__name__
        open(name, "w").write(writer(faces))
        say(f"{writer.__name__.upper()} of {what}", open3d.io.read_triangle_mesh(name))
mesh = open3d.io.read_triangle_mesh("box.ply")
say("mirrored", mesh.transform(numpy.diag([-1, 1, 1, 1])))
PY
python3 quads.py >output 2>messages || { tail -n 3 messages; exit 1; }
cat output messages >seen
expect_in seen <<'END'
OFF of triangles: 8 points, 12 triangles, 1000 mm3
OFF of quads: 8 points, 12 triangles, 1000 mm3
OFF of 10 triangles and a quad: 8 points, 12 triangles, 1000 mm3
PLY of triangles: 8 points, 12 triangles, 1000 mm3
PLY of quads: 8 points, 12 triangles, 1000 mm3
PLY of 10 triangles and a quad: 8 points, 12 triangles, 1000 mm3
OBJ of triangles: 8 points, 12 triangles, 1000 mm3
OBJ of quads: 0 points, 0 triangles, 0 mm3
OBJ of 10 triangles and a quad: 0 points, 0 triangles, 0 mm3
mirrored: 8 points, 12 triangles, -1000 mm3
END
