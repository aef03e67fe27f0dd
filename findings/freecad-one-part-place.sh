#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2 writes one placed part into STEP or IGES (Import.export, its usual exporter) at the origin and unturned; the same
# part together with another stands where it is, and so does one by Part.export. Nothing
# is said. Believed: the file has the part where the model has it, however many are chosen.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work
cat >place.py <<'PY'
import FreeCAD, Part, Import

document = FreeCAD.newDocument("d")
pin, plate = (document.addObject("Part::Feature", name) for name in ("Pin", "Plate"))
pin.Shape, plate.Shape = Part.makeCylinder(1, 10), Part.makeBox(20, 20, 5)
pin.Placement = FreeCAD.Placement(FreeCAD.Vector(60, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90))
document.recompute()
for ending in ("step", "iges"):
    for name, write, parts in (("alone", Import.export, [pin]), ("with the plate", Import.export, [pin, plate]), ("alone, Part.export", Part.export, [pin])):
        file = f"{name}.{ending}"
        write(parts, file)
        shape = Part.Shape()
        shape.read(file)
        boxes = [face.BoundBox for face in shape.Faces if face.BoundBox.DiagonalLength < 12]  # those of the plate are longer
        sides = ["{:.0f} to {:.0f}".format(*(round(limit(getattr(box, axis + end) for box in boxes)) + 0 for limit, end in ((min, "Min"), (max, "Max"))))
                 for axis in "XYZ"]
        print(f"{ending}, pin {name}: x {sides[0]}, y {sides[1]}, z {sides[2]}")
PY
python3 place.py >all 2>messages || { cat messages >&2; exit 1; }
grep ', pin ' all >seen
expect_in seen <<'END'
step, pin alone: x -1 to 1, y -1 to 1, z 0 to 10
step, pin with the plate: x 59 to 61, y -10 to 0, z -1 to 1
step, pin alone, Part.export: x 59 to 61, y -10 to 0, z -1 to 1
iges, pin alone: x -1 to 1, y -1 to 1, z 0 to 10
iges, pin with the plate: x 59 to 61, y -10 to 0, z -1 to 1
iges, pin alone, Part.export: x 59 to 61, y -10 to 0, z -1 to 1
END
