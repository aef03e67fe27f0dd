#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1.0: a box of strips of triangles, as vtkStripper makes them to save memory, is written without a face by the writers of PLY and
# BYU, with success, whereas STL and OBJ have all 12 triangles. The PLY reader reads no face of a file whose triangles stand in an element
# "tristrips", as scanned models' often do, and has no error. Believed: 12 triangles in each file, 2 from the strip.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
printf '%s\n' ply 'format ascii 1.0' 'element vertex 4' 'property float x' 'property float y' 'property float z' \
  'element tristrips 1' 'property list int int vertex_indices' end_header '0 0 0' '10 0 0' '0 10 0' '10 10 0' '4 0 1 2 3' >strip.ply
cat >strips.py <<'PY'
import re
import vtk

def through(step, data):
    step.SetInputData(data)
    step.Update()
    return step.GetOutput()

def triangles_of(name):
    data = open(name, "rb").read()
    if name.endswith("ply"):
        return int(re.search(rb"element face (\d+)", data)[1])
    if name.endswith("byu"):
        return int(data.split()[2])
    return len(re.findall(rb"^f " if name.endswith("obj") else rb"outer loop", data, re.M))

source = vtk.vtkCubeSource()
source.Update()
triangles = through(vtk.vtkTriangleFilter(), source.GetOutput())
for kind, box in (("triangles", triangles), ("strips", through(vtk.vtkStripper(), triangles))):
    for ending, writer in (("stl", vtk.vtkSTLWriter()), ("obj", vtk.vtkOBJWriter()), ("ply", vtk.vtkPLYWriter()), ("byu", vtk.vtkBYUWriter())):
        name = f"{kind}.{ending}"
        writer.SetInputData(box)
        writer.SetGeometryFileName(name) if ending == "byu" else writer.SetFileName(name)
        success = writer.Write()
        print(f"{kind} as {ending}: {triangles_of(name)} faces, success {success}, error {writer.GetErrorCode()}")
reader = vtk.vtkPLYReader()
reader.SetFileName("strip.ply")
reader.Update()
strip = reader.GetOutput()
print(f"strip of PLY: {strip.GetNumberOfPoints()} points, {strip.GetNumberOfCells()} faces or strips, error {reader.GetErrorCode()}")
PY
python3 strips.py >seen
expect_in seen <<'END'
triangles as stl: 12 faces, success 1, error 0
triangles as obj: 12 faces, success 1, error 0
triangles as ply: 12 faces, success 1, error 0
triangles as byu: 12 faces, success 1, error 0
strips as stl: 12 faces, success 1, error 0
strips as obj: 12 faces, success 1, error 0
strips as ply: 0 faces, success 1, error 0
strips as byu: 0 faces, success 1, error 0
strip of PLY: 4 points, 0 faces or strips, error 0
END
