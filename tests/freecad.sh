#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The macro for FreeCAD, without its window: a part becomes a PDF and a page of TechDraw, true to scale; and its shape is
# drawn in memory, with its faces and edges. Outside CI, as it needs the package freecad.  tests/freecad.sh PROGRAM
set -uo pipefail
program=$(realpath "$1")
macro=$(realpath "$(dirname "$(realpath "$0")")/../samples/freecad/epura.FCMacro")
freecad=$(command -v freecadcmd || command -v /usr/lib/freecad/bin/freecadcmd-python3) ||
  { echo "freecad: skipped, for there is no freecadcmd (apt-get install freecad)" >&2; exit 0; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/bin"
ln -s "$program" "$scratch/bin/epura"
cat >"$scratch/bracket.py" <<END
import FreeCAD, runpy, sys
document = FreeCAD.newDocument("bracket")
plate = document.addObject("Part::Box", "Plate")
plate.Length, plate.Width, plate.Height = 60, 40, 10
bore = document.addObject("Part::Cylinder", "Bore")
bore.Radius, bore.Height, bore.Placement.Base = 6, 20, FreeCAD.Vector(20, 20, -2)
bracket = document.addObject("Part::Cut", "Bracket")
bracket.Base, bracket.Tool = plate, bore
document.recompute()
document.saveAs("$scratch/bracket.FCStd")
runpy.run_path("$macro", run_name="__main__")
pages = [part for part in document.Objects if part.TypeId == "TechDraw::DrawPage"]
sys.path.insert(0, "$(dirname "$program")/../lib/python")
import epura
curves = epura.hlr(bracket.Shape).curves
print("of the shape:", len({curve.edge for curve in curves} - {None}), "edges,", len({face for curve in curves for face in curve.faces}), "faces")
# FreeCAD tells no address; the shape is in what its object points to, and words that are no shape are refused.
import ctypes
def by_address(place):
    try:
        return {face for curve in epura.hlr(place).curves for face in curve.faces}
    except epura.InputError:
        return set()
shape = bracket.Shape
held = [ctypes.c_size_t.from_address(id(shape) + 8 * i).value for i in range(2, 8)]
print("by address:", max(len(by_address(place + 8 * i)) for place in held for i in range(24)), "faces")
print("pages:", [(str(page.Template.Width), str(page.Template.Height)) for page in pages])
END
PATH=$scratch/bin:$PATH HOME=$scratch "$freecad" "$scratch/bracket.py" >"$scratch/log" 2>&1
grep -q "pages: \[('297.0 mm', '210.0 mm')\]" "$scratch/log" && [ -s "$scratch/bracket.pdf" ] ||
  { echo "freecad: no sheet" >&2; cat "$scratch/log" >&2; exit 1; }
grep -q "of the shape: 14 edges, 7 faces" "$scratch/log" ||
  { echo "freecad: its shape is not drawn" >&2; cat "$scratch/log" >&2; exit 1; }
grep -q "by address: 7 faces" "$scratch/log" ||
  { echo "freecad: its shape is not found by address" >&2; cat "$scratch/log" >&2; exit 1; }
# The plate, its bore, and where that is: nothing else is dimensioned.
command -v pdftotext >/dev/null || exit 0
pdftotext "$scratch/bracket.pdf" - | grep -qx '⌀12' || { echo "freecad: no ⌀12 on the sheet" >&2; exit 1; }
