#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Blender 3.4.1's import of DXF adds the base point of a block instead of subtracting it: a copy of a block with the base (5, 0) stands
# 10 mm to the right of its place. Arrays of copies are twice as far apart as they say, and those of one row are one copy. Nested
# copies and scales are right. Believed: 60 10 to 64 12 for the first, further copies 20 mm to the right.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages blender=3.4.1+dfsg-2+b1
dxf() {  # FILE BLOCKS ENTITIES, of which / divides the lines
  { echo "0/SECTION/2/BLOCKS$2/0/ENDSEC/0/SECTION/2/ENTITIES$3/0/ENDSEC/0/EOF" | tr '/' '\n'; } >"$1"
}
block() { echo "/0/BLOCK/8/0/2/$1/70/0/10/$2/20/0/30/0/3/$1/1/$3/0/ENDBLK/8/0"; }
line() { echo "/0/LINE/8/0/10/$1/20/0/30/0/11/$2/21/2/31/0"; }
insert() { echo "/0/INSERT/8/0/2/$1/10/$2/20/$3/30/0${4:-}"; }
plain=$(block PLAIN 0 "$(line 0 4)")
dxf plain.dxf "$plain" "$(insert PLAIN 60 10)"
dxf scaled.dxf "$plain" "$(insert PLAIN 60 10 /41/2/42/2)"
dxf nested.dxf "$plain$(block OUTER 0 "$(insert PLAIN 10 0)")" "$(insert OUTER 50 10)"
dxf base.dxf "$(block BASE 5 "$(line 5 9)")" "$(insert BASE 60 10)"
dxf array.dxf "$plain" "$(insert PLAIN 60 10 /70/2/71/2/44/20/45/10)"
dxf row.dxf "$plain" "$(insert PLAIN 60 10 /70/2/71/1/44/20)"
cat >blocks.py <<'PY'
import addon_utils, bpy

addon_utils.enable("io_import_dxf")
for name in ("plain", "scaled", "nested", "base", "array", "row"):
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    bpy.ops.import_scene.dxf(filepath=name + ".dxf")
    bpy.context.view_layer.update()
    lines = set()
    for copy in bpy.context.evaluated_depsgraph_get().object_instances:
        if copy.object.type == "CURVE":
            mesh = copy.object.to_mesh()
            for edge in mesh.edges:
                lines.add(tuple(round(number, 3) for corner in edge.vertices for number in (copy.matrix_world @ mesh.vertices[corner].co)[:2]))
    print("lines of", name, *("%g %g to %g %g;" % line for line in sorted(lines)))
PY
export BLENDER_SYSTEM_SCRIPTS=$work/root/usr/share/blender/scripts BLENDER_SYSTEM_DATAFILES=$work/root/usr/share/blender/datafiles HOME=$work
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/share/blender/scripts/modules
blender -b --factory-startup -P blocks.py >output 2>&1 || { cat output; exit 1; }
grep '^lines of' output >seen
expect_in seen <<'END'
lines of plain 60 10 to 64 12;
lines of scaled 60 10 to 68 14;
lines of nested 60 10 to 64 12;
lines of base 70 10 to 74 12;
lines of array 60 10 to 64 12; 60 30 to 64 32; 100 10 to 104 12; 100 30 to 104 32;
lines of row 60 10 to 64 12;
END
