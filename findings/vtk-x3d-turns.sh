#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1.0 (vtkX3DExporter, ParaView's X3D) turns parts the other way: one turned by 90 degrees about z, so that its x points along y, has "0 0 1 -1.57" in
# the file, and stands on the other side of the axis there. Its VRML of the same scene has +1.57, by the same rule for both formats, and so have
# Open Inventor and glTF. Nothing is said. Half turns and moves are right. Believed: turns by the right-hand rule (ISO/IEC 19775-1, 4.3.5, and
# ISO/IEC 14772-1, 5.8).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >turns.py <<'PY'
import json
import math
import re
import vtkmodules.all as vtk


def write(actor, exporter, file):
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.AddRenderer(renderer)
    renderer.AddActor(actor)
    exporter.SetRenderWindow(window)
    exporter.SetFileName(file)
    exporter.Write()
    return open(file).read()


def angle(text, axis):
    words = re.findall(r"rotation[\s=\"]+((?:[-+.\deE]+\s*){4})", text)[-1].split()
    x, y, z, turn = map(float, words)
    return round(math.degrees(turn * (x, y, z)[axis]))


for axis, name in enumerate("XYZ"):
    for turn in (90, 30):
        cube, mapper, actor = vtk.vtkCubeSource(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
        mapper.SetInputConnection(cube.GetOutputPort())
        actor.SetMapper(mapper)
        getattr(actor, "Rotate" + name)(turn)
        write(actor, vtk.vtkGLTFExporter(), "part.gltf")
        m = next(node["matrix"] for node in json.load(open("part.gltf"))["nodes"] if "mesh" in node)
        first, second = (axis + 1) % 3, (axis + 2) % 3
        gltf = round(math.degrees(math.atan2(m[4 * first + second], m[4 * first + first])))
        seen = {"VRML": angle(write(actor, vtk.vtkVRMLExporter(), "part.wrl"), axis), "Open Inventor": angle(write(actor, vtk.vtkIVExporter(), "part.iv"), axis),
                "glTF": gltf, "X3D": angle(write(actor, vtk.vtkX3DExporter(), "part.x3d"), axis)}
        print(f"turned by {turn} about {name}: " + ", ".join(f"{kind} {value}" for kind, value in seen.items()))
PY
/usr/bin/python3 turns.py >seen 2>messages || { tail -n 3 messages; exit 1; }
expect_in seen <<'END'
turned by 90 about X: VRML 90, Open Inventor 90, glTF 90, X3D -90
turned by 30 about X: VRML 30, Open Inventor 30, glTF 30, X3D -30
turned by 90 about Y: VRML 90, Open Inventor 90, glTF 90, X3D -90
turned by 30 about Y: VRML 30, Open Inventor 30, glTF 30, X3D -30
turned by 90 about Z: VRML 90, Open Inventor 90, glTF 90, X3D -90
turned by 30 about Z: VRML 30, Open Inventor 30, glTF 30, X3D -30
END
