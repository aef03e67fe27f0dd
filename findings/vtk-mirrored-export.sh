#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VTK 9.1.0 writes a part that a scale mirrors along x (a left part made of a right one) into VRML, X3D and Open Inventor mirrored along y, and so at
# another place, since it takes the matrix apart into a half turn about y and three scales of -1. Into OBJ it writes the part at its place with its facets
# inside out. Nothing is said. Its glTF is right, and so are moves and scales. Believed: the box that is shown, in all five, and a positive volume.
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
