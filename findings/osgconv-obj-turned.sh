#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenSceneGraph 3.6.5 (osgconv) turns an OBJ by 90 degrees about x as it reads it, y up to z up, and does not turn it back as it writes one: each
# pass through OBJ turns a part further, from OBJ to OBJ, and from STL to OBJ and back. Nothing is said. The option noRotation, of which only the
# list of its formats (osgconv --formats) tells, helps. Believed: OBJ to OBJ is the same model.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages openscenegraph=3.6.5+dfsg1-8+b2
export OSG_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu/osgPlugins-3.6.5
boxes() {  # FILE: an OBJ or an ASCII STL
  awk '$1 == "v" || $1 == "vertex" { print $2, $3, $4 }' "$1" >corners
  extent corners
}
box_stl part 0 | awk '$1 == "vertex" { $3 *= 2; $4 *= 3 } 1' >part.stl
awk '$1 == "vertex" { print "v", $2, $3, $4; if (++n % 3 == 0) faces = faces "f " n - 2 " " n - 1 " " n "\n" } END { printf "%s", faces }' part.stl >part.obj
convert() {  # [OPTION...] FROM TO
  osgconv "$@" >messages 2>&1
  echo "$*: $(boxes "${@: -1}")"
}
{
  echo "part.obj: $(boxes part.obj)"
  convert part.obj once.obj
  convert once.obj twice.obj
  convert -O noRotation part.obj kept.obj
  echo "part.stl: $(boxes part.stl)"
  convert part.stl written.obj
  convert written.obj back.stl
} >seen
expect_in seen <<'END'
part.obj: 0..10 0..20 0..30
part.obj once.obj: 0..10 -30..0 0..20
once.obj twice.obj: 0..10 -20..0 -30..0
-O noRotation part.obj kept.obj: 0..10 0..20 0..30
part.stl: 0..10 0..20 0..30
part.stl written.obj: 0..10 0..20 0..30
written.obj back.stl: 0..10 -30..0 0..20
END
