#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# PCL 1.13.0: pcl_ply2obj takes no coordinates of a PLY whose numbers are doubles, as measuring programs write them: all corners are 0 0 0 in the OBJ, with warnings
# of properties that are "not handled" and the same exit code as for a good file; floats are read. pcl_pcd2vtk writes five digits: points measured at 1234.56 mm stand
# at 1234.6. Nothing is said of that. pcl_converter, and pcl_pcd2ply with all digits, are right. Believed: one library has one reader of
# PLY, and writes the digits that a float has.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages pcl-tools=1.13.0+dfsg-3
for type in float double; do
  { printf 'ply\nformat ascii 1.0\nelement vertex 4\n'; for axis in x y z; do echo "property $type $axis"; done
    printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n10.5 0 0\n10.5 20 0\n0 20 5\n4 0 1 2 3\n'; } >$type.ply
done
printf '%s\n' 'VERSION .7' 'FIELDS x y z' 'SIZE 4 4 4' 'TYPE F F F' 'COUNT 1 1 1' 'WIDTH 2' 'HEIGHT 1' 'VIEWPOINT 0 0 0 1 0 0 0' 'POINTS 2' 'DATA ascii' \
  '1234.56 0.25 0' '1234.51 10.4 0' >points.pcd
corners() { grep -E '^v ' "$1" | sed 's/^v //' | paste -sd, | sed 's/,/, /g'; }
{
  for type in float double; do
    code=0
    pcl_ply2obj $type.ply $type.obj >/dev/null 2>messages || code=$?
    echo "pcl_ply2obj of ${type}s: $(corners $type.obj); $(grep -c 'not handled' messages || true) warnings, exit code $code"
    pcl_converter -f ascii $type.ply $type.obj >/dev/null 2>&1
    echo "pcl_converter of ${type}s: $(corners $type.obj)"
  done
  pcl_pcd2vtk points.pcd points.vtk >/dev/null 2>&1
  pcl_pcd2ply -format 0 points.pcd points.ply >/dev/null 2>&1
  echo "points at 1234.56 and 1234.51, pcl_pcd2vtk: $(sed -n '/^POINTS/,/^VERTICES/p' points.vtk | awk 'NF == 3 && !/^[PV]/ { print $1 }' | paste -sd' ' | sed 's/ / and /')"
  echo "points at 1234.56 and 1234.51, pcl_pcd2ply: $(awk 'body && NF == 3 { print $1 } /^end_header/ { body = 1 }' points.ply | paste -sd' ' | sed 's/ / and /')"
} >seen
expect_in seen <<'END'
pcl_ply2obj of floats: 0 0 0, 10.5 0 0, 10.5 20 0, 0 20 5; 0 warnings, exit code 1
pcl_converter of floats: 0 0 0, 10.5 0 0, 10.5 20 0, 0 20 5
pcl_ply2obj of doubles: 0 0 0, 0 0 0, 0 0 0, 0 0 0; 3 warnings, exit code 1
pcl_converter of doubles: 0 0 0, 10.5 0 0, 10.5 20 0, 0 20 5
points at 1234.56 and 1234.51, pcl_pcd2vtk: 1234.6 and 1234.5
points at 1234.56 and 1234.51, pcl_pcd2ply: 1234.5601 and 1234.51
END
