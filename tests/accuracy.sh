#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# docs/accuracy.md must not lie:  tests/accuracy.sh EPURA
# Its commands are run again, in a scratch copy; errors must be those of docs/accuracy/*.csv, and the same diagrams come
# out. Times are others every time: they are not compared. Neither are other programs, which are not there.
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
EPURA=$epura docs/accuracy/renew --runs 1
# From the scene to the share that is undecided; from the scene to the length of phantoms.
same() { diff <(grep -vE '^[^,]*,"?(Open CASCADE|Blender)' "$root/docs/accuracy/$1" | cut -d, -f"$2") <(cut -d, -f"$2" "docs/accuracy/$1"); }
same report.csv 1-20
same paper.csv 1-11
# Parts are those of other programs: bench/part_errors.
cp "$root"/docs/accuracy/parts* docs/accuracy
diff <(cd "$root/docs/accuracy" && ls) <(ls docs/accuracy)
diff <(grep -oE 'accuracy/[a-z]+-[0-9]+\.png' "$root/docs/accuracy.md" | sort) <(ls docs/accuracy/*.png | cut -d/ -f2- | sort)
