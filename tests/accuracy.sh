#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# docs/accuracy.md must not lie:  [EPURA_AT_LENGTH=1] tests/accuracy.sh EPURA
# Its commands are run again, in a scratch copy; errors must be those of docs/accuracy/*.csv, and the same diagrams come
# out. Times are others every time: they are not compared. Neither are other programs, which are not there. At length, all
# scenes are drawn; else two of four, and bodies of no more than 48 facets around.
set -euo pipefail
root=$(realpath "$(dirname "$(realpath "$0")")/..")
epura=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch/docs/accuracy" "$scratch/samples"
cp -r "$root/samples/models" "$scratch/samples"
cp "$root/docs/accuracy.md" "$scratch/docs"
cp "$root/docs/accuracy/renew" "$scratch/docs/accuracy"
cd "$scratch"
left_out='^$'
if [ -z "${EPURA_AT_LENGTH:-}" ]; then
  sed -i -e 's/{bracket.obj,gear.stl,house.obj,sombrero.obj}/{bracket.obj,house.obj}/' -e 's/--finest 384/--finest 48/' docs/accuracy.md
  grep -q 'models/{bracket.obj,house.obj}' docs/accuracy.md && grep -q 'finest 48' docs/accuracy.md
  left_out='^(gear|sombrero),isometric,|^[^,]*,[^,]*,(96|192|384),'
fi
EPURA=$epura docs/accuracy/renew --runs 1
# From the scene to the share that is undecided; from the scene to the length of phantoms.
same() {
  local shown=$root/docs/accuracy/$1
  diff <(grep -vE "^[^,]*,\"?(Open CASCADE|Blender)|$left_out" "$shown" | cut -d, -f"$2") <(cut -d, -f"$2" "docs/accuracy/$1")
}
same report.csv 1-20
same paper.csv 1-11
# Parts are those of other programs: bench/part_errors.
cp "$root"/docs/accuracy/parts* docs/accuracy
if [ -n "${EPURA_AT_LENGTH:-}" ]; then
  diff <(cd "$root/docs/accuracy" && ls) <(ls docs/accuracy)
else
  for made in docs/accuracy/*; do [ -e "$root/$made" ]; done
fi
diff <(grep -oE 'accuracy/[a-z]+-[0-9]+\.png' "$root/docs/accuracy.md" | sort) <(cd "$root/docs" && ls accuracy/*.png | sort)
