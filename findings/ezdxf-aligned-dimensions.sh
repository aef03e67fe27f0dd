#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# ezdxf 0.18.1 measures an aligned dimension of DXF (get_measurement) along x, not along its points: one of 50 over 30 to the right and 40 up has 30,
# and one straight up 0, unless the file gives an angle, which aligned dimensions do not have (groups of AcDbAlignedDimension). A program that
# checks or reads sizes by it takes others. Rotated ones are right. Believed: the distance of the points, as the name says.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages HOME=$work
cat >measure.py <<'PY'
import ezdxf

ALIGNED, ROTATED = 33, 32
for what, kind, x, y, angle, right in (("aligned, 30 to the right", ALIGNED, 30, 0, "", 30), ("aligned, 40 up", ALIGNED, 0, 40, "", 40),
                                       ("aligned, 30 to the right and 40 up", ALIGNED, 30, 40, "", 50), ("along x, 30 to the right and 40 up", ROTATED, 30, 40, "50 0", 30),
                                       ("along y, 30 to the right and 40 up", ROTATED, 30, 40, "50 90", 40)):
    text = f"""0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 0 ENDSEC 0 SECTION 2 ENTITIES
        0 DIMENSION 5 A0 100 AcDbEntity 8 0 100 AcDbDimension 2 *D1 10 {x} 20 {y} 30 0 70 {kind} 100 AcDbAlignedDimension
        13 0 23 0 33 0 14 {x} 24 {y} 34 0 {angle} {'100 AcDbRotatedDimension' if kind == ROTATED else ''} 0 ENDSEC 0 EOF"""
    with open("dimension.dxf", "w") as file:
        file.write("\n".join(text.split()) + "\n")
    dimension = ezdxf.readfile("dimension.dxf").modelspace().query("DIMENSION")[0]
    print(f"{what}: {dimension.get_measurement():.1f}" + ("" if round(dimension.get_measurement()) == right else f", right would be {right}"))
PY
python3 measure.py >output 2>messages || { tail -n 3 messages; exit 1; }
grep ': ' output >seen
expect_in seen <<'END'
aligned, 30 to the right: 30.0
aligned, 40 up: 0.0, right would be 40
aligned, 30 to the right and 40 up: 30.0, right would be 50
along x, 30 to the right and 40 up: 30.0
along y, 30 to the right and 40 up: 40.0
END
