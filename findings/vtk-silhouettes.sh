#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1.0: vtkPolyDataSilhouette finds no silhouette of a box seen along one of its edges, as in every front, top or side view, because
# walls seen edge-on count as neither front nor back; seen along (1, 1, 1), or from a point, it is whole. It finds none either where
# triangles share no points, or stand in strips. Believed: the outline of 10 x 20, length 60, in all of these.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >silhouettes.py <<'PY'
import math
import vtk

def through(step, data):
    step.SetInputData(data)
    step.Update()
    return step.GetOutput()

def silhouette(data, direction=None, origin=None):
    finder = vtk.vtkPolyDataSilhouette()
    finder.SetEnableFeatureAngle(False)
    if origin:
        finder.SetDirectionToSpecifiedOrigin()
        finder.SetOrigin(*origin)
    else:
        finder.SetDirectionToSpecifiedVector()
        finder.SetVector(*direction)
    lines = through(finder, data)
    length = 0
    for i in range(lines.GetNumberOfCells()):
        points = lines.GetCell(i).GetPoints()
        length += math.dist(points.GetPoint(0), points.GetPoint(1))
    return f"{lines.GetNumberOfCells()} edges, length {length:.0f}"

source = vtk.vtkCubeSource()
source.SetXLength(10)
source.SetYLength(20)
source.SetZLength(30)
source.Update()
apart = through(vtk.vtkTriangleFilter(), source.GetOutput())
box = through(vtk.vtkCleanPolyData(), apart)
strips = through(vtk.vtkStripper(), box)
print("along z:", silhouette(box, (0, 0, 1)))
print("along (0, 1, 1):", silhouette(box, (0, 1, 1)))
print("along (1, 1, 1):", silhouette(box, (1, 1, 1)))
print("from a point on z:", silhouette(box, origin=(0, 0, 100)))
print("points not shared, along (1, 1, 1):", silhouette(apart, (1, 1, 1)))
print("strips, along (1, 1, 1):", silhouette(strips, (1, 1, 1)))
PY
python3 silhouettes.py >seen
expect_in seen <<'END'
along z: 0 edges, length 0
along (0, 1, 1): 2 edges, length 20
along (1, 1, 1): 6 edges, length 120
from a point on z: 4 edges, length 60
points not shared, along (1, 1, 1): 0 edges, length 0
strips, along (1, 1, 1): 0 edges, length 0
END
