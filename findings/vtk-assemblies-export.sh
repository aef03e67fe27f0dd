#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1.0 writes the parts of a vtkAssembly into VRML, X3D, Open Inventor, glTF and OBJ at their places within it, and leaves out where the assembly
# stands: one that is lifted by 100 mm, or turned, is in the file where it was built, whatever is seen. Two assemblies of equal parts lie on each other.
# Nothing is said. Parts that are placed themselves are right. Believed: what the window shows is written, as the exporters' pages say.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >export.py <<'PY'
import itertools
import json
import math
import re
import vtkmodules.all as vtk

EXPORTERS = {"VRML": (vtk.vtkVRMLExporter, "wrl"), "X3D": (vtk.vtkX3DExporter, "x3d"), "Open Inventor": (vtk.vtkIVExporter, "iv"),
             "glTF": (vtk.vtkGLTFExporter, "gltf"), "OBJ": (vtk.vtkOBJExporter, "obj")}


def box_actor():
    cube = vtk.vtkCubeSource()
    cube.SetBounds(0, 10, 0, 20, 0, 30)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(cube.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def write(thing, kind):
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.AddRenderer(renderer)
    renderer.AddViewProp(thing)
    make, ending = EXPORTERS[kind]
    exporter = make()
    exporter.SetRenderWindow(window)
    if kind == "OBJ":
        exporter.SetFilePrefix("part")
    else:
        exporter.SetFileName("part." + ending)
    exporter.Write()
    return open("part." + ending).read()


def placed(point, place):
    """T R S of VRML, X3D and Open Inventor."""
    x, y, z = (value * scale for value, scale in zip(point, place["scale"]))
    *axis, angle = place["rotation"]
    length = math.hypot(*axis) or 1
    ax, ay, az = (value / length for value in axis)
    c, s = math.cos(angle), math.sin(angle)
    dot = (ax * x + ay * y + az * z) * (1 - c)
    turned = (x * c + (ay * z - az * y) * s + ax * dot, y * c + (az * x - ax * z) * s + ay * dot, z * c + (ax * y - ay * x) * s + az * dot)
    return [value + move for value, move in zip(turned, place["translation"])]


def points_of(text, kind):
    numbers = lambda words: [float(word) for word in re.findall(r"-?\d+\.?\d*(?:[eE][-+]?\d+)?", words)]
    triples = lambda words: list(zip(*[iter(numbers(words))] * 3))
    if kind == "OBJ":
        return triples(" ".join(line[2:] for line in text.splitlines() if line.startswith("v ")))
    if kind == "glTF":
        file, points = json.loads(text), []
        for node in file["nodes"]:
            if "mesh" in node:
                m = node.get("matrix", [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
                at = file["accessors"][file["meshes"][node["mesh"]]["primitives"][0]["attributes"]["POSITION"]]
                for p in itertools.product(*zip(at["min"], at["max"])):
                    points.append([sum(m[4 * k + axis] * p[k] for k in range(3)) + m[12 + axis] for axis in range(3)])
        return points
    place, points = None, []
    for name, words in re.findall(r"\b(translation|rotation|scale|scaleFactor|point)\b[\s=\"\[]*((?:[-+.\deE]+[\s,]*)+)", text):
        if name == "translation":
            place = {"translation": numbers(words), "rotation": [0, 0, 1, 0], "scale": [1, 1, 1]}
        elif name != "point":
            place[name.removesuffix("Factor")] = numbers(words)
        elif place:  # the points after them are those of textures
            points += [placed(point, place) for point in triples(words)]
            place = None
    return points


def box(points):
    low, high = ([round(limit(point[axis] for point in points)) for axis in range(3)] for limit in (min, max))
    return "{} {} {} to {} {} {}".format(*low, *high)


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
