#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1.0 writes a part that a scale mirrors along x (a left part made of a right one) into VRML, X3D and Open Inventor mirrored along y, and so at
# another place, since it takes the matrix apart into a half turn about y and three scales of -1. Into OBJ it writes the part at its place with its facets
# inside out. Nothing is said. Its glTF is right, and so are moves and scales. Believed: the box that is shown, in all five, and a positive volume.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
vtk_exports
cat >export.py <<'PY'
from scenes import *


def actor(**place):
    part = box_actor()
    part.SetScale(*place.get("scale", (1, 1, 1)))
    part.SetPosition(*place.get("move", (0, 0, 0)))
    return part


def volume(text):
    """Of the facets of an OBJ; negative if they look inwards."""
    lines = [line.split() for line in text.splitlines()]
    corners = [[float(word) for word in words[1:4]] for words in lines if words[:1] == ["v"]]
    total = 0
    for words in lines:
        if words[:1] == ["f"]:
            face = [corners[int(word.split("/")[0]) - 1] for word in words[1:]]
            for b, c in zip(face[1:], face[2:]):
                a = face[0]
                total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


for what, place in (("moved by 100", {"move": (100, 0, 0)}), ("twice as long along x", {"scale": (2, 1, 1)}),
                    ("mirrored along x", {"scale": (-1, 1, 1)}), ("mirrored along x, moved by 100", {"scale": (-1, 1, 1), "move": (100, 0, 0)})):
    part = actor(**place)
    b = part.GetBounds()
    print(f"{what}, shown {box([(b[0], b[2], b[4]), (b[1], b[3], b[5])])}:")
    for kind in EXPORTERS:
        text = write(part, kind)
        print(f"  {kind}: {box(points_of(text, kind))}" + (f", volume {volume(text):.0f}" if kind == "OBJ" else ""))
PY
/usr/bin/python3 export.py >seen 2>messages || { tail -n 3 messages; exit 1; }
expect_in seen <<'END'
moved by 100, shown 100 0 0 to 110 20 30:
  VRML: 100 0 0 to 110 20 30
  X3D: 100 0 0 to 110 20 30
  Open Inventor: 100 0 0 to 110 20 30
  glTF: 100 0 0 to 110 20 30
  OBJ: 100 0 0 to 110 20 30, volume 6000
twice as long along x, shown 0 0 0 to 20 20 30:
  VRML: 0 0 0 to 20 20 30
  X3D: 0 0 0 to 20 20 30
  Open Inventor: 0 0 0 to 20 20 30
  glTF: 0 0 0 to 20 20 30
  OBJ: 0 0 0 to 20 20 30, volume 12000
mirrored along x, shown -10 0 0 to 0 20 30:
  VRML: 0 -20 0 to 10 0 30
  X3D: 0 -20 0 to 10 0 30
  Open Inventor: 0 -20 0 to 10 0 30
  glTF: -10 0 0 to 0 20 30
  OBJ: -10 0 0 to 0 20 30, volume -6000
mirrored along x, moved by 100, shown 90 0 0 to 100 20 30:
  VRML: 100 -20 0 to 110 0 30
  X3D: 100 -20 0 to 110 0 30
  Open Inventor: 100 -20 0 to 110 0 30
  glTF: 90 0 0 to 100 20 30
  OBJ: 90 0 0 to 100 20 30, volume -6000
END
