# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Common code of the scripts beside it, which source it: epura, in $EPURA, and Debian's Python with FreeCAD and the modules here.
. "$(dirname "$(realpath "${BASH_SOURCE[0]}")")/../common.sh"
here=$root/bench/drawings
"$root/.ci/packages" build drawings
if [ -z "${EPURA:-}" ]; then
  (cd "$root" && cmake --preset bench >/dev/null && cmake --build --preset bench --target program >/dev/null)
  EPURA=$programs/epura
fi
export PATH=/usr/bin:$PATH  # Debian's Python, which its modules are for
export EPURA QT_QPA_PLATFORM=offscreen PYTHONDONTWRITEBYTECODE=1
export PYTHONPATH=/usr/lib/freecad-python3/lib:$here
