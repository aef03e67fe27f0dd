#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1.0 (vtkVRMLImporter) drops the turns of a VRML97: parts of an assembly stand unturned, those below a turned node elsewhere, and what turns about a
# centre is not moved; scales go along the wrong axis (scaleOrientation). It draws all choices of a Switch and all levels of an LOD at once,
# and lays cones along x. Nothing is said. Moves, scales, copies, boxes and cylinders are right. Believed: as ISO/IEC 14772-1 has
# them (6.12, 6.26, 6.46, 6.52).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >boxes.py <<'PY'
import vtkmodules.all as vtk

BOX = """Shape { geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 10 0 0, 10 20 0, 0 20 0, 0 0 30, 10 0 30, 10 20 30, 0 20 30] }
  coordIndex [0 3 2 1 -1 4 5 6 7 -1 0 1 5 4 -1 1 2 6 5 -1 2 3 7 6 -1 3 0 4 7 -1] } }"""
FAR = f"Transform {{ translation 100 0 0 children [ {BOX} ] }}"
QUARTER = "rotation 0 0 1 1.5707963"
for what, text, right in (
        ("moved", FAR, "100 0 0 to 110 20 30"),
        ("copied by USE", f"DEF PART {BOX} Transform {{ translation 100 0 0 children [ USE PART ] }}", "0 0 0 to 10 20 30, 100 0 0 to 110 20 30"),
        ("twice as large", f"Transform {{ scale 2 2 2 children [ {BOX} ] }}", "0 0 0 to 20 40 60"),
        ("turned about z", f"Transform {{ {QUARTER} children [ {BOX} ] }}", "-20 0 0 to 0 10 30"),
        ("turned about z at (10, 0, 0)", f"Transform {{ center 10 0 0 {QUARTER} children [ {BOX} ] }}", "-10 -10 0 to 10 0 30"),
        ("moved below a turn", f"Transform {{ {QUARTER} children [ {FAR} ] }}", "-20 100 0 to 0 110 30"),
        ("twice as long along y", f"Transform {{ scale 2 1 1 scaleOrientation 0 0 1 1.5707963 children [ {BOX} ] }}", "0 0 0 to 10 40 30"),
        ("first of two choices", f"Switch {{ whichChoice 0 choice [ {BOX} {FAR} ] }}", "0 0 0 to 10 20 30"),
        ("two levels of detail", f"LOD {{ range [ 10 ] level [ {BOX} {BOX} ] }}", "0 0 0 to 10 20 30"),
        ("cylinder", "Shape { geometry Cylinder { radius 5 height 20 } }", "-5 -10 -5 to 5 10 5"),
        ("cone", "Shape { geometry Cone { bottomRadius 5 height 20 } }", "-5 -10 -5 to 5 10 5")):
    with open("part.wrl", "w") as file:
        file.write("#VRML V2.0 utf8\n" + text + "\n")
    importer = vtk.vtkVRMLImporter()
    importer.SetFileName("part.wrl")
    importer.Read()
    actors, boxes = importer.GetRenderer().GetActors(), []
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextActor()
        actor.GetMapper().Update()
        b = [round(value) for value in actor.GetBounds()]
        boxes.append("{0} {2} {4} to {1} {3} {5}".format(*b))
    seen = ", ".join(boxes)
    print(f"{what}: {seen}" + ("" if seen == right else f", right would be {right}"))
PY
/usr/bin/python3 boxes.py >seen 2>messages || { tail -n 3 messages; exit 1; }
expect_in seen <<'END'
moved: 100 0 0 to 110 20 30
copied by USE: 0 0 0 to 10 20 30, 100 0 0 to 110 20 30
twice as large: 0 0 0 to 20 40 60
turned about z: 0 0 0 to 10 20 30, right would be -20 0 0 to 0 10 30
turned about z at (10, 0, 0): 0 0 0 to 10 20 30, right would be -10 -10 0 to 10 0 30
moved below a turn: 100 0 0 to 110 20 30, right would be -20 100 0 to 0 110 30
twice as long along y: 0 0 0 to 20 20 30, right would be 0 0 0 to 10 40 30
first of two choices: 0 0 0 to 10 20 30, 100 0 0 to 110 20 30, right would be 0 0 0 to 10 20 30
two levels of detail: 0 0 0 to 10 20 30, 0 0 0 to 10 20 30, right would be 0 0 0 to 10 20 30
cylinder: -5 -10 -5 to 5 10 5
cone: -10 -5 -5 to 10 5 5, right would be -5 -10 -5 to 5 10 5
END
