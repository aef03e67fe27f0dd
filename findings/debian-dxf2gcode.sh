#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Debian 12's dxf2gcode 20191025 makes no G-code of any DXF: it reads the file, a line here, and stops with a TypeError when it is to show it, since it
# gives PyQt5 a floating number for the size of a font. Python took such numbers for whole ones until 3.9, Debian 12 has 3.11. Without a
# window (-q) it is the same. Believed: the program of a package does what it is for.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages dxf2gcode=20191025-2
export HOME=$work QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR=$work PYTHONPATH=$work/root/usr/lib/python3/dist-packages QT_PLUGIN_PATH=$work/root/usr/lib/x86_64-linux-gnu/qt5/plugins
printf '%s\n' 0 SECTION 2 ENTITIES 0 LINE 8 0 10 3 20 4 30 0 11 13 21 9 31 0 0 ENDSEC 0 EOF >line.dxf
for _ in 1 2; do  # the first run writes its settings
  python3 root/usr/bin/dxf2gcode -q -e "$work/line.ngc" line.dxf >messages 2>&1 || true
done
{
  grep -E '^Loaded .* entity geometries' messages | sed 's/;.*//'
  sed -n 's/^  *QFont(family: .*): \(argument .*\)/QFont: \1/p' messages
  [ -e line.ngc ] && echo "G-code" || echo "no G-code"
} >seen
expect_in seen <<'END'
Loaded 1 entity geometries
QFont: argument 2 has unexpected type 'float'
no G-code
END
