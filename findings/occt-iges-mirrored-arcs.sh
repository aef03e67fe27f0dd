#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 reads an arc of IGES that a matrix mirrors (124 of form 1, as CAD programs write the left one of a pair) as the rest of its circle: a mirrored
# quarter becomes three quarters, whatever the axis, and so does a quarter of an ellipse. Nothing is said. Turned and half turned arcs, mirrored lines and mirrored
# splines are right. Believed: the points of the arc, mirrored (IGES 5.3, 4.3 and 4.21).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
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
cat >iges.py <<'PY'
import math
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


ARC = (100, 0, (0, 0, 0, 10, 0, 0, 10), 2)
ELLIPSE = (104, 1, (1 / 400, 0, 1 / 100, 0, 0, -1, 0, 20, 0, 0, 10), 2)
LINE = (110, 0, (0, 0, 0, 10, 5, 0), 2)
w = math.sqrt(0.5)
SPLINE = (126, 0, (2, 2, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, w, 1, 10, 0, 0, 10, 10, 0, 0, 10, 0, 0, 1, 0, 0, 1), 2)
for what, curve, (x, y, z), right in (
        ("quarter of a circle", ARC, (1, 1, 1), "within 0 0 to 10 10, 15.7 long"), ("the same, turned half about z", ARC, (-1, -1, 1), "within -10 -10 to 0 0, 15.7 long"),
        ("the same, turned half about x", ARC, (1, -1, -1), "within 0 -10 to 10 0, 15.7 long"), ("mirrored in x", ARC, (-1, 1, 1), "within -10 0 to 0 10, 15.7 long"),
        ("mirrored in y", ARC, (1, -1, 1), "within 0 -10 to 10 0, 15.7 long"), ("mirrored in z", ARC, (1, 1, -1), "within 0 0 to 10 10, 15.7 long"),
        ("quarter of an ellipse, mirrored in x", ELLIPSE, (-1, 1, 1), "within -20 0 to 0 10, 24.2 long"),
        ("quarter of a circle as a spline, mirrored in x", SPLINE, (-1, 1, 1), "within -10 0 to 0 10, 15.7 long"),
        ("line, mirrored in x", LINE, (-1, 1, 1), "within -10 0 to 0 5, 11.2 long")):
    write([(124, 1 if x * y * z < 0 else 0, (x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0), 0), (*curve[:3], 1)])
    seen = read()
    print(f"{what}: {seen}" + ("" if seen == right else f"; right would be {right}"))
PY
python3 iges.py >seen
expect_in seen <<'END'
quarter of a circle: within 0 0 to 10 10, 15.7 long
the same, turned half about z: within -10 -10 to 0 0, 15.7 long
the same, turned half about x: within 0 -10 to 10 0, 15.7 long
mirrored in x: within -10 -10 to 10 10, 47.1 long; right would be within -10 0 to 0 10, 15.7 long
mirrored in y: within -10 -10 to 10 10, 47.1 long; right would be within 0 -10 to 10 0, 15.7 long
mirrored in z: within -10 -10 to 10 10, 47.1 long; right would be within 0 0 to 10 10, 15.7 long
quarter of an ellipse, mirrored in x: within -20 -10 to 20 10, 72.7 long; right would be within -20 0 to 0 10, 24.2 long
quarter of a circle as a spline, mirrored in x: within -10 0 to 0 10, 15.7 long
line, mirrored in x: within -10 0 to 0 5, 11.2 long
END
