#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1.0 writes the parts of a vtkAssembly into VRML, X3D, Open Inventor, glTF and OBJ at their places within it, and leaves out where the assembly
# stands: one that is lifted by 100 mm, or turned, is in the file where it was built, whatever is seen. Two assemblies of equal parts lie on each other.
# Nothing is said. Parts that are placed themselves are right. Believed: what the window shows is written, as the exporters' pages say.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
vtk_exports
cat >export.py <<'PY'
from scenes import *


def assembly(move):
    group, far = vtk.vtkAssembly(), box_actor()
    far.SetPosition(50, 0, 0)
    group.AddPart(box_actor())
    group.AddPart(far)
    move(group)
    return group


def shown(thing):
    b = thing.GetBounds()
    return box([(b[0], b[2], b[4]), (b[1], b[3], b[5])])


lifted = box_actor()
lifted.SetPosition(0, 0, 100)
for what, thing in (("part lifted by 100", lifted), ("assembly as it was built", assembly(lambda group: None)),
                    ("assembly lifted by 100", assembly(lambda group: group.SetPosition(0, 0, 100))),
                    ("assembly turned by 90 degrees about z", assembly(lambda group: group.RotateZ(90)))):
    print(f"{what}, shown {shown(thing)}:")
    for kind in EXPORTERS:
        seen = box(points_of(write(thing, kind), kind))
        print(f"  {kind}: {seen}")
PY
/usr/bin/python3 export.py >seen 2>messages || { tail -n 3 messages; exit 1; }
expect_in seen <<'END'
part lifted by 100, shown 0 0 100 to 10 20 130:
  VRML: 0 0 100 to 10 20 130
  X3D: 0 0 100 to 10 20 130
  Open Inventor: 0 0 100 to 10 20 130
  glTF: 0 0 100 to 10 20 130
  OBJ: 0 0 100 to 10 20 130
assembly as it was built, shown 0 0 0 to 60 20 30:
  VRML: 0 0 0 to 60 20 30
  X3D: 0 0 0 to 60 20 30
  Open Inventor: 0 0 0 to 60 20 30
  glTF: 0 0 0 to 60 20 30
  OBJ: 0 0 0 to 60 20 30
assembly lifted by 100, shown 0 0 100 to 60 20 130:
  VRML: 0 0 0 to 60 20 30
  X3D: 0 0 0 to 60 20 30
  Open Inventor: 0 0 0 to 60 20 30
  glTF: 0 0 0 to 60 20 30
  OBJ: 0 0 0 to 60 20 30
assembly turned by 90 degrees about z, shown -20 0 0 to 0 60 30:
  VRML: 0 0 0 to 60 20 30
  X3D: 0 0 0 to 60 20 30
  Open Inventor: 0 0 0 to 60 20 30
  glTF: 0 0 0 to 60 20 30
  OBJ: 0 0 0 to 60 20 30
END
