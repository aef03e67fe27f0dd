#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1: vtkOBJReader splits the corners of a box that has normals (as CAD programs write them) into 24 points, so vtkFeatureEdges finds
# none of its 12 creases and takes every edge for a boundary, 24 lines. Without normals there are 12 creases and no boundary.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
cat >edges.py <<'PY'
import vtk

corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
faces = {(0, 0, -1): (1, 3, 4, 2), (0, 0, 1): (5, 6, 8, 7), (0, -1, 0): (1, 2, 6, 5), (0, 1, 0): (3, 7, 8, 4),
         (-1, 0, 0): (1, 5, 7, 3), (1, 0, 0): (2, 4, 8, 6)}
for normals in (False, True):
    with open("box.obj", "w") as file:
        file.writelines("v %g %g %g\n" % corner for corner in corners)
        file.writelines("vn %g %g %g\n" % normal for normal in faces if normals)
        for number, face in enumerate(faces.values(), 1):
            file.write("f " + " ".join(f"{corner}//{number}" if normals else str(corner) for corner in face) + "\n")
    reader = vtk.vtkOBJReader()
    reader.SetFileName("box.obj")
    counts = []
    for wanted in ("FeatureEdges", "BoundaryEdges"):
        edges = vtk.vtkFeatureEdges()
        edges.SetInputConnection(reader.GetOutputPort())
        for kind in ("FeatureEdges", "BoundaryEdges", "ManifoldEdges", "NonManifoldEdges"):
            getattr(edges, kind + ("On" if kind == wanted else "Off"))()
        edges.Update()
        counts.append(edges.GetOutput().GetNumberOfCells())
    print("normals" if normals else "plain", reader.GetOutput().GetNumberOfPoints(), "points, creases and boundaries", *counts)
PY
PYTHONPATH=root/usr/lib/python3/dist-packages root/usr/bin/python3.11 edges.py >seen
expect_in seen <<'END'
plain 8 points, creases and boundaries 12 0
normals 24 points, creases and boundaries 0 24
END
