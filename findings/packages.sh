# SPDX-License-Identifier: Apache-2.0
# What every script of this folder begins with: a temporary folder to work in, packages in it, and a comparison. To be sourced.
set -euo pipefail
export LC_ALL=C.UTF-8
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm_packages() {  # NAME@VERSION...
  npm init -y >/dev/null
  npm install --no-audit --no-fund --silent "$@"
}

# Unpacks Debian packages with all they depend on below "$work/root", without installing anything on the system.
debian_packages() {  # NAME=VERSION...
  mkdir -p archives/partial root
  : >status
  apt-get -qq -y -o Dir::State::status="$work/status" -o Dir::Cache::archives="$work/archives" -o Debug::NoLocking=1 \
    -o APT::Install-Recommends=false -o APT::Sandbox::User="$(id -un)" --download-only install "$@" >apt.log 2>&1 ||
    { tail -n 3 apt.log >&2; return 1; }
  local archive library=$work/root/usr/lib/x86_64-linux-gnu
  for archive in archives/*.deb; do
    case $archive in */libc6_*) ;; *) dpkg-deb --extract "$archive" root ;; esac
  done
  export PATH=$work/root/usr/bin:$PATH
  export LD_LIBRARY_PATH=$library:$work/root/lib/x86_64-linux-gnu:$library/blas:$library/lapack:$library/pulseaudio:$work/root/usr/lib
  LD_LIBRARY_PATH+=:$work/root/usr/lib/freecad-python3/lib
}

# Fails, and shows the difference, if what stands on standard input is not what the file has.
expect_in() {  # FILE
  diff -u --label expected - --label seen "$1" && echo "as stated"
}

# A closed box of STL facets: box NAME X, 10 mm wide, from X on.
box_stl() {
  awk -v name="$1" -v x="$2" 'BEGIN {
    n = split("0 2 3,0 3 1,4 5 7,4 7 6,0 1 5,0 5 4,2 6 7,2 7 3,0 4 6,0 6 2,1 3 7,1 7 5", facets, ",")
    print "solid " name
    for (i = 1; i <= n; ++i) {
      print " facet normal 0 0 0\n  outer loop"
      split(facets[i], corner, " ")
      for (k = 1; k <= 3; ++k) {
        c = corner[k]
        printf "   vertex %g %g %g\n", x + 10 * (c % 2), 10 * (int(c / 2) % 2), 10 * int(c / 4)
      }
      print "  endloop\n endfacet"
    }
    print "endsolid " name
  }'
}

# A 3MF package around the model part on standard input.
pack_3mf() {  # FILE
  mkdir -p package/_rels package/3D
  cat >package/3D/3dmodel.model
  echo '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>' >'package/[Content_Types].xml'
  echo '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>' >package/_rels/.rels
  python3 - "$1" <<'PY'
import pathlib, sys, zipfile
with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as archive:
    for name in ("[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"):
        archive.write(pathlib.Path("package") / name, name)
PY
}

# A box of 3MF, 10 units wide, as an object: object_3mf ID TYPE.
object_3mf() {
  awk -v id="$1" -v type="$2" 'BEGIN {
    printf "<object id=\"%s\" type=\"%s\"><mesh><vertices>", id, type
    for (c = 0; c < 8; ++c) printf "<vertex x=\"%d\" y=\"%d\" z=\"%d\"/>", 10 * (c % 2), 10 * (int(c / 2) % 2), 10 * int(c / 4)
    printf "</vertices><triangles>"
    n = split("0 2 3,0 3 1,4 5 7,4 7 6,0 1 5,0 5 4,2 6 7,2 7 3,0 4 6,0 6 2,1 3 7,1 7 5", facets, ",")
    for (i = 1; i <= n; ++i) { split(facets[i], v, " "); printf "<triangle v1=\"%d\" v2=\"%d\" v3=\"%d\"/>", v[1], v[2], v[3] }
    print "</triangles></mesh></object>"
  }'
}

# A model part: model_3mf UNIT OBJECTS ITEMS.
model_3mf() {
  printf '<?xml version="1.0"?><model unit="%s" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>%s</resources><build>%s</build></model>\n' "$1" "$2" "$3"
}

# The box of a file of OFF or of the vertices of an OBJ.
extent() {  # FILE
  awk '{ sub(/^v /, "") } NF == 3 && /^[-0-9]/ { for (i = 1; i <= 3; ++i) { if (!n || $i < low[i]) low[i] = $i; if (!n || $i > high[i]) high[i] = $i }; n = 1 }
       END { printf "%g..%g %g..%g %g..%g\n", low[1], high[1], low[2], high[2], low[3], high[3] }' "$1"
}

# Compiles against Debian's Open CASCADE below "$work/root": occt_program SOURCE LIBRARY...
occt_program() {
  local source=$1
  shift
  c++ -std=c++17 -w -I root/usr/include/opencascade "$source" -L root/usr/lib/x86_64-linux-gnu "${@/#/-l}" -o "${source%.cpp}"
}

# A STEP file of AP242: a box of 40 x 30 x 20 mm in the unit MM or INCH, and what the statements on standard input say of it. They find
# the unit of length as #346, the context of sizes as #345, the shape of the product as #4, the box as #10 and its faces as #331 (top) and #338 (bottom).
step_with_pmi() {  # FILE UNIT
  cat >box.cpp <<'CPP'
#include <BRepPrimAPI_MakeBox.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>

int main(int, char** words) {
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", words[2]);
  Interface_Static::SetIVal("write.step.schema", 5);
  writer.Transfer(BRepPrimAPI_MakeBox(40, 30, 20).Shape(), STEPControl_AsIs);
  return writer.Write(words[1]) != IFSelect_RetDone;
}
CPP
  [ -x box ] || occt_program box.cpp TKSTEP TKXSBase TKPrim TKTopAlgo TKBRep TKMath TKernel
  ./box box.step "$2" >/dev/null
  { sed '$d' box.step | sed '$d'; cat; printf 'ENDSEC;\nEND-ISO-10303-21;\n'; } >"$1"
}

# Says of each dimension and tolerance of a STEP file what Open CASCADE's document (XCAF) has of it.
read_pmi() {  # FILE
  cat >pmi.cpp <<'CPP'
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDimTolObjects_DimensionObject.hxx>
#include <XCAFDimTolObjects_GeomToleranceObject.hxx>
#include <XCAFDoc_DimTolTool.hxx>
#include <XCAFDoc_Dimension.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_GeomTolerance.hxx>
#include <cstdio>

int main(int, char** words) {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  STEPCAFControl_Reader reader;
  reader.SetGDTMode(true);
  if (reader.ReadFile(words[1]) != IFSelect_RetDone || !reader.Transfer(document)) return 1;
  const Handle(XCAFDoc_DimTolTool) tool = XCAFDoc_DocumentTool::DimTolTool(document->Main());
  TDF_LabelSequence dimensions, tolerances;
  tool->GetDimensionLabels(dimensions);
  for (const TDF_Label& label : dimensions) {
    Handle(XCAFDoc_Dimension) found;
    label.FindAttribute(XCAFDoc_Dimension::GetID(), found);
    const Handle(XCAFDimTolObjects_DimensionObject) it = found->GetObject();
    int before = 0, after = 0;
    it->GetNbOfDecimalPlaces(before, after);
    std::printf("%s: %.4f", it->GetSemanticName()->ToCString(), it->GetValue());
    if (it->IsDimWithPlusMinusTolerance()) std::printf(", upper %.4f, lower %.4f", it->GetUpperTolValue(), it->GetLowerTolValue());
    if (it->IsDimWithRange()) std::printf(", between %.4f and %.4f", it->GetLowerBound(), it->GetUpperBound());
    std::printf(", %d decimals\n", after);
  }
  tool->GetGeomToleranceLabels(tolerances);
  for (const TDF_Label& label : tolerances) {
    Handle(XCAFDoc_GeomTolerance) found;
    label.FindAttribute(XCAFDoc_GeomTolerance::GetID(), found);
    std::printf("%s: %.4f\n", found->GetObject()->GetSemanticName()->ToCString(), found->GetObject()->GetValue());
  }
}
CPP
  [ -x pmi ] || occt_program pmi.cpp TKXDESTEP TKXCAF TKSTEP TKXSBase TKLCAF TKCAF TKCDF TKBRep TKMath TKernel
  ./pmi "$1" | grep -a ': [0-9]'
}

# Writes a glTF file of a box of 10 mm and the nodes, which are numbered from 0 and of which the scene has the first: gltf FILE NODE...
gltf() {
  python3 - "$@" <<'PY'
import base64, json, struct, sys
corners = [[(i >> axis & 1) / 100 for axis in range(3)] for i in range(8)]
facets = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5]
data = struct.pack("<24f36H", *sum(corners, []), *facets)
nodes = [json.loads(node) for node in sys.argv[2:]]
children = {child for node in nodes for child in node.get("children", [])}
json.dump({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [i for i in range(len(nodes)) if i not in children]}], "nodes": nodes,
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [0.01, 0.01, 0.01]},
                  {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
    "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
}, open(sys.argv[1], "w"))
PY
}

# Says of each part of a glTF file what Open CASCADE's document has of it: its box in millimetres, and its volume.
read_gltf() {  # FILE
  cat >parts.cpp <<'CPP'
#include <BRep_Tool.hxx>
#include <RWGltf_CafReader.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cstdio>

int main(int, char** words) {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  RWGltf_CafReader reader;
  reader.SetSystemLengthUnit(0.001);
  reader.SetFileCoordinateSystem(RWMesh_CoordinateSystem_Zup);
  reader.SetSystemCoordinateSystem(RWMesh_CoordinateSystem_Zup);
  reader.SetDocument(document);
  if (!reader.Perform(words[1], Message_ProgressRange())) return 1;
  TDF_LabelSequence labels;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(labels);
  for (const TDF_Label& label : labels)
    for (TopExp_Explorer at(XCAFDoc_ShapeTool::GetShape(label), TopAbs_FACE); at.More(); at.Next()) {
      TopLoc_Location place;
      const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(TopoDS::Face(at.Current()), place);
      double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9}, volume = 0;
      for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        gp_XYZ corners[3];
        for (int k = 0; k < 3; ++k) corners[k] = mesh->Node(mesh->Triangle(i).Value(k + 1)).Transformed(place.Transformation()).XYZ();
        volume += corners[0].Dot(corners[1].Crossed(corners[2])) / 6;
        for (const gp_XYZ& corner : corners)
          for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], corner.Coord(axis + 1));
            high[axis] = std::max(high[axis], corner.Coord(axis + 1));
          }
      }
      if (at.Current().Orientation() == TopAbs_REVERSED) volume = -volume;
      std::printf("part from");
      for (double value : low) std::printf(" %.1f", value + 0.0);
      std::printf(" to");
      for (double value : high) std::printf(" %.1f", value + 0.0);
      std::printf(", %.0f mm3\n", volume);
    }
}
CPP
  [ -x parts ] || occt_program parts.cpp TKRWMesh TKXCAF TKLCAF TKCAF TKCDF TKBRep TKTopAlgo TKMath TKernel
  ./parts "$1" | grep -a ' mm3'
}

# Runs a Java source with the archives of Debian packages below "$work/root", by the newest Java 17 that Debian has: java_program SOURCE
java_program() {
  local home=$work/root/usr/lib/jvm/java-17-openjdk-amd64 link
  find "$home" -lname '/etc/*' | while read -r link; do ln -sfn "$work/root$(readlink "$link")" "$link"; done
  "$home/bin/java" -Djava.awt.headless=true -XX:-UsePerfData -cp "$work/root/usr/share/java/*" "$1"
}

# Writes scenes.py: EXPORTERS of VTK, box_actor() of 10 x 20 x 30 mm, write(thing, kind) returns the text of a file with it, box(points_of(text, kind))
# says where the corners in that are.
vtk_exports() {
  export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
  cat >scenes.py <<'PY'
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
PY
}

# Makes ./curve, which reads an IGES file by Open CASCADE and says where its curve is, and iges_curves.py with write(entities) and read().
iges_curves() {
  cat >curve.cpp <<'CPP'
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <cmath>
#include <cstdio>

int main(int, char** words) {
  IGESControl_Reader reader;
  if (reader.ReadFile(words[1]) != IFSelect_RetDone || !reader.TransferRoots()) return 1;
  Bnd_Box box;
  BRepBndLib::AddOptimal(reader.OneShape(), box, false, false);
  double b[6];
  box.Get(b[0], b[1], b[2], b[3], b[4], b[5]);
  GProp_GProps length;
  BRepGProp::LinearProperties(reader.OneShape(), length);
  std::printf("within %.0f %.0f to %.0f %.0f, %.1f long\n", std::round(b[0]) + 0.0, std::round(b[1]) + 0.0, std::round(b[3]) + 0.0, std::round(b[4]) + 0.0, length.Mass());
}
CPP
  occt_program curve.cpp TKIGES TKXSBase TKPrim TKTopAlgo TKBRep TKGeomBase TKG3d TKMath TKernel
  cat >iges_curves.py <<'PY'
import re
import subprocess


def record(text, section, number):
    return f"{text:<72}{section}{number:7d}"


def write(entities):
    """An IGES file in millimetres of entities: type, form, parameters and the number of the matrix (1 for the first entity, 0 for none)."""
    header = "1H,,1H;,4Hpart,8Hpart.igs,3Hown,3Hown,32,38,6,308,15,4Hpart,1.,2,2HMM,1,0.01,15H20261130.000000,1.E-6,100.,3Hown,3Hown,11,0,15H20261130.000000;"
    lines = [record("", "S", 1)] + [record(header[k:k + 72], "G", k // 72 + 1) for k in range(0, len(header), 72)]
    directory, parameters = [], []
    for place, (kind, form, values, matrix) in enumerate(entities):
        words, first = [f"{kind},"] + [f"{value:.12g}," for value in values[:-1]] + [f"{values[-1]:.12g};"], len(parameters) + 1
        text = ""
        for word in words + [None]:
            if word is None or len(text) + len(word) > 64:
                parameters.append(record(f"{text:<64}{2 * place + 1:8d}", "P", len(parameters) + 1))
                text = ""
            text += word or ""
        directory.append(record(f"{kind:8d}{first:8d}" + "       0" * 4 + f"{2 * matrix - 1 if matrix else 0:8d}       000000000", "D", 2 * place + 1))
        directory.append(record(f"{kind:8d}" + "       0" * 2 + f"{len(parameters) - first + 1:8d}{form:8d}{'':24}       0", "D", 2 * place + 2))
    counts = [1, len(lines) - 1, len(directory), len(parameters)]
    lines += directory + parameters
    lines.append(record("".join(f"{name}{count:7d}" for name, count in zip("SGDP", counts)), "T", 1))
    with open("part.igs", "w") as file:
        file.write("\n".join(lines) + "\n")


def read():
    told = subprocess.run(["./curve", "part.igs"], capture_output=True, text=True, check=True).stdout
    return re.search(r"within .*", told)[0]
PY
}
