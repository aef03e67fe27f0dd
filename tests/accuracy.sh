#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# docs/accuracy.md must not lie:  tests/accuracy.sh EPURA
# Its command is run again, in a scratch copy; errors must be those of docs/accuracy/report.csv, and the same diagrams come
# out. Times are others every time: they are not compared.
set -euo pipefail
root=$(realpath "$(dirname "$(realpath "$0")")/..")
PATH=$(dirname "$(realpath "$1")"):$PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch/docs/accuracy" "$scratch/samples"
cp -r "$root/samples/models" "$scratch/samples"
command=$(sed -n '/^```sh$/,/^```$/p' "$root/docs/accuracy.md" | grep -v '^```')
cd "$scratch"
eval "$command --runs 1"
# From the scene to the share that is undecided.
diff <(cut -d, -f1-20 "$root/docs/accuracy/report.csv") <(cut -d, -f1-20 docs/accuracy/report.csv)
diff <(cd "$root/docs/accuracy" && ls) <(ls docs/accuracy)
diff <(grep -oE 'accuracy/diagram-[0-9]+\.png' "$root/docs/accuracy.md") <(ls docs/accuracy/*.png | cut -d/ -f2-)
