#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# README, CONTRIBUTING, recipes, docs/office.md and docs/scale.md must not lie:  [ACCEPT=1] tests/readme.sh EPURA
# Every ```sh block is run, in a scratch copy, with EPURA first in PATH; docs/office has the pictures that its blocks draw,
# or, with ACCEPT=1, gets them; the folders are those of src/CMakeLists.txt and below.
set -uo pipefail
root=$(realpath "$(dirname "$(realpath "$0")")/..")
PATH=$(dirname "$(realpath "$1")"):$PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

complain() {
  echo "documentation: $*" >&2
  status=1
}

cp -r "$root/include" "$root/cmake" "$scratch"
mkdir "$scratch/samples"
cp -r "$root/samples/models" "$root/samples/step" "$root/samples/frames" "$root/samples/bracket.toml" "$root/samples/plugin" "$scratch/samples"
for page in README.md docs/office.md docs/recipes.md docs/scale.md; do
  awk -v out="$scratch/$(basename $page)-" '/^```sh$/ { inside = 1; ++n; next } /^```$/ { inside = 0 }
                                            inside { print > (out n ".sh") }' "$root/$page"
  [ -f "$scratch/$(basename $page)-1.sh" ] || complain "no sh block found in $page"
done

cd "$scratch" || exit 2
for block in *.md-*.sh; do
  # The two big commands would run this test again: that they are there is enough.
  if ! grep -vqE '^(samples/draw|tests/run)( |$)' "$block"; then
    while read -r program _; do
      [ -x "$root/$program" ] || complain "$program is not a program"
    done <"$block"
  elif ! bash -euo pipefail "$block" >log 2>&1; then
    complain "this block of ${block%-*} fails:"
    cat "$block" log >&2
  fi
done

for picture in $(sed -nE 's/^!\[.*\]\(office\/(.*)\)$/\1/p' "$root/docs/office.md"); do
  if [ -n "${ACCEPT:-}" ]; then cp "$picture" "$root/docs/office/"; fi
  cmp -s "$picture" "$root/docs/office/$picture" || complain "docs/office/$picture is not what its command draws"
done

sed -n '/^```cpp$/,/^```$/p' "$root/README.md" | sed '1d;$d' | diff - <(sed 1,2d "$root/samples/plugin/shadow.cpp") ||
  complain "its plugin is not samples/plugin/shadow.cpp"
while IFS= read -r line; do
  grep -qxF -- "$line" "$root/CONTRIBUTING.md" || complain "lacks the line of a CMakeLists.txt of src: $line"
done < <(sed -nE 's/^add_subdirectory\((.*)\) *# (.*)$/- `\1`: \2/p' "$root"/src/*/CMakeLists.txt
         sed -nE 's/^add_subdirectory\((.*)\) *# (.*)$/**`\1`**: \2/p' "$root/src/CMakeLists.txt")
grep -oE '\]\([^)#:]+\)' "$root/README.md" | tr -d '()]' | while read -r link; do
  [ -e "$root/$link" ] || echo "$link"
done >broken
[ -s broken ] && complain "broken links: $(tr '\n' ' ' <broken)"
exit $status
