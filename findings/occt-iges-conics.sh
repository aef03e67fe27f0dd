#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 reads conic arcs of IGES (104) right only if their axis is along x: an ellipse that is longer along y is drawn along x, a parabola that opens up or down is
# elsewhere and half as long again, a hyperbola that opens up is elsewhere, and one that opens to the left is drawn on the right. It says nothing, and ends
# with success. Ellipses along x, and parabolas and hyperbolas that open to the right, are right. Believed: the curves of the equation (IGES 5.3,
# 4.4, which has parameters for both axes).
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


# A, B, C, D, E and F of A x2 + B x y + C y2 + D x + E y + F = 0, the height, and where the arc begins and ends.
c, s = math.cosh(1), math.sinh(1)
for what, form, values, right in (
        ("quarter of an ellipse, 20 along x", 1, (1 / 400, 0, 1 / 100, 0, 0, -1, 0, 20, 0, 0, 10), "within 0 0 to 20 10, 24.2 long"),
        ("quarter of an ellipse, 20 along y", 1, (1 / 100, 0, 1 / 400, 0, 0, -1, 0, 10, 0, 0, 20), "within 0 0 to 10 20, 24.2 long"),
        ("parabola to the right", 3, (0, 0, 1, -20, 0, 0, 0, 0, 0, 20, 20), "within 0 0 to 20 20, 29.6 long"),
        ("parabola to the left", 3, (0, 0, 1, 20, 0, 0, 0, 0, 0, -20, 20), "within -20 0 to 0 20, 29.6 long"),
        ("parabola upwards", 3, (1, 0, 0, 0, -20, 0, 0, 0, 0, 20, 20), "within 0 0 to 20 20, 29.6 long"),
        ("parabola downwards", 3, (1, 0, 0, 0, 20, 0, 0, 0, 0, 20, -20), "within 0 -20 to 20 0, 29.6 long"),
        ("hyperbola to the right", 2, (1 / 100, 0, -1 / 25, 0, 0, -1, 0, 10, 0, 10 * c, 5 * s), "within 10 0 to 15 6, 8.3 long"),
        ("hyperbola to the left", 2, (1 / 100, 0, -1 / 25, 0, 0, -1, 0, -10, 0, -10 * c, 5 * s), "within -15 0 to -10 6, 8.3 long"),
        ("hyperbola upwards", 2, (-1 / 25, 0, 1 / 100, 0, 0, -1, 0, 0, 10, 5 * s, 10 * c), "within 0 10 to 6 15, 8.3 long")):
    x1, y1, x2, y2 = values[7:]
    for x, y in ((x1, y1), (x2, y2)):
        assert abs(values[0] * x * x + values[2] * y * y + values[3] * x + values[4] * y + values[5]) < 1e-9, what
    write([(104, form, values, 0)])
    seen = read()
    print(f"{what}: {seen}" + ("" if seen == right else f"; right would be {right}"))
PY
python3 iges.py >seen
expect_in seen <<'END'
quarter of an ellipse, 20 along x: within 0 0 to 20 10, 24.2 long
quarter of an ellipse, 20 along y: within 0 0 to 20 10, 24.2 long; right would be within 0 0 to 10 20, 24.2 long
parabola to the right: within 0 0 to 20 20, 29.6 long
parabola to the left: within -20 0 to 0 20, 29.6 long
parabola upwards: within 0 -40 to 20 0, 46.5 long; right would be within 0 0 to 20 20, 29.6 long
parabola downwards: within 0 0 to 20 40, 46.5 long; right would be within 0 -20 to 20 0, 29.6 long
hyperbola to the right: within 10 0 to 15 6, 8.3 long
hyperbola to the left: within 10 0 to 15 6, 8.3 long; right would be within -15 0 to -10 6, 8.3 long
hyperbola upwards: within 22 10 to 32 15, 11.5 long; right would be within 0 10 to 6 15, 8.3 long
END
