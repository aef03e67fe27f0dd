#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Inkscape 1.2.2 opens a DXF with one of an array of blocks, blocks off by their base point, chords for the arcs of hatches, and without the weights of
# splines: an arc of a radius of 20 mm comes 1.2 mm too high. It draws what is on layers that are off, invisible, or on paper space.
# It says nothing of these; of mirrored planes it says that they may be wrong. Circles, bulges and turned blocks are right.
# Believed: the boxes that DXF's reference gives.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages inkscape=1.2.2-2+deb12u1 python3-cssselect=1.2.0-2 python3-lxml=4.9.2-1+deb12u1 python3-numpy=1:1.24.2-1+deb12u1
extensions=$work/root/usr/share/inkscape/extensions
export PYTHONPATH=$extensions:$work/root/usr/lib/python3/dist-packages HOME=$work
cat >boxes.py <<'PY'
import subprocess, sys
import inkex

LINE = "0 LINE 8 0 10 3 20 4 30 0 11 13 21 9 31 0"
TWO_ARCS = "10 0 20 0 42 1 10 40 20 0 42 1"
for what, entities, right in (
        ("a block", "0 INSERT 8 0 2 PART 10 20 20 30 30 0", "20 30 to 30 35"),
        ("three blocks in a row", "0 INSERT 8 0 2 PART 10 20 20 30 30 0 70 3 44 50", "20 30 to 130 35"),
        ("a block turned by 90 degrees", "0 INSERT 8 0 2 BARE 10 20 20 30 30 0 50 90", "11 33 to 16 43"),
        ("a half circle as polyline", "0 LWPOLYLINE 8 0 90 2 70 0 10 0 20 0 42 1 10 40 20 0", "0 -20 to 40 0"),
        ("a circle filled by a hatch", f"0 HATCH 8 0 10 0 20 0 30 0 2 SOLID 70 1 71 0 91 1 92 2 72 1 73 1 93 2 {TWO_ARCS} 97 0 75 0 76 1 98 0", "0 -20 to 40 20"),
        ("an arc as rational spline", "0 SPLINE 8 0 70 12 71 2 72 6 73 3 74 0 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.7071067811865476 41 1 "
         "10 14.1421356 20 14.1421356 30 0 10 0 20 28.2842712 30 0 10 -14.1421356 20 14.1421356 30 0", "-14 14 to 14 20"),
        ("a layer that is off", "0 LINE 8 OFF 10 0 20 0 30 0 11 10 21 5 31 0", "nothing"),
        ("an invisible line", "0 LINE 8 0 60 1 10 0 20 0 30 0 11 10 21 5 31 0", "nothing"),
        ("paper space", "0 LINE 8 0 67 1 10 0 20 0 30 0 11 10 21 5 31 0", "nothing")):
    text = f"""0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER 70 2
      0 LAYER 2 0 70 0 62 7 6 CONTINUOUS 0 LAYER 2 OFF 70 0 62 -7 6 CONTINUOUS 0 ENDTAB 0 ENDSEC 0 SECTION 2 BLOCKS
      0 BLOCK 8 0 2 PART 70 0 10 3 20 4 30 0 3 PART {LINE} 0 ENDBLK 8 0 0 BLOCK 8 0 2 BARE 70 0 10 0 20 0 30 0 3 BARE {LINE} 0 ENDBLK 8 0
      0 ENDSEC 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"""
    with open("part.dxf", "w") as file:
        file.write("\n".join(text.split()) + "\n")
    with open("part.svg", "wb") as file:
        subprocess.run([sys.executable, sys.argv[1], "--scalemethod=manual", "--scale=1", "part.dxf"], check=True, stdout=file)
    sheet = inkex.load_svg("part.svg").getroot()
    height, unit = sheet.viewbox_height, 96 / 25.4
    boxes = [shape.bounding_box() for shape in sheet.xpath('//svg:g[@inkscape:groupmode="layer"]/*')]
    low_high = [limit(getattr(box, edge) for box in boxes) for limit, edge in ((min, "left"), (max, "bottom"), (max, "right"), (min, "top"))] if boxes else None
    seen = "{:.0f} {:.0f} to {:.0f} {:.0f}".format(*(round(value / unit if axis % 2 == 0 else (height - value) / unit) + 0.0
                                                     for axis, value in enumerate(low_high))) if boxes else "nothing"
    print(f"{what}: {seen}" + ("" if seen == right else f", right would be {right}"))
PY
python3 boxes.py "$extensions/dxf_input.py" >seen
expect_in seen <<'END'
a block: 23 34 to 33 39, right would be 20 30 to 30 35
three blocks in a row: 23 34 to 33 39, right would be 20 30 to 130 35
a block turned by 90 degrees: 11 33 to 16 43
a half circle as polyline: 0 -20 to 40 0
a circle filled by a hatch: 0 0 to 40 0, right would be 0 -20 to 40 20
an arc as rational spline: -14 14 to 14 21, right would be -14 14 to 14 20
a layer that is off: 0 0 to 10 5, right would be nothing
an invisible line: 0 0 to 10 5, right would be nothing
paper space: 0 0 to 10 5, right would be nothing
END
