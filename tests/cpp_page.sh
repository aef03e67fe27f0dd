#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# docs/cpp.md must not lie: its programs are compiled and run, and its members exist.
#   tests/cpp_page.sh LIBEPURA.so FOLDER_OF_MADE_HEADERS
set -uo pipefail
root=$(realpath "$(dirname "$(realpath "$0")")/..")
library=$(realpath "$1")
made=$(realpath "$2")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
page=$root/docs/cpp.md
status=0

complain() {
  echo "cpp_page: $*" >&2
  status=1
}

cd "$scratch" || exit 2
ln -s "$root/samples" samples
awk '/^```cpp$/ { inside = 1; ++n; next } /^```$/ { inside = 0 } inside { print > ("program-" n ".cpp") }' "$page"
programs=(program-*.cpp)
[ ${#programs[@]} -ge 3 ] || complain "has ${#programs[@]} programs"
for program in "${programs[@]}"; do
  c++ -std=c++20 -Wall -Wextra -Werror -I"$root/include" -I"$made" "$program" "$library" -Wl,-rpath,"$(dirname "$library")" \
    -o "${program%.cpp}" 2>log && "./${program%.cpp}" >out 2>>log || { complain "$program fails"; cat log >&2; }
done
for file in flange.pdf cube.svg bracket.pdf; do [ -s $file ] || complain "no program writes $file"; done
for word in $(grep '^|' "$page" | grep -oE '(DimensionType|AutomaticSize|AutomaticScale|HiddenLines|SheetOptions|Style|Note|View|Scene|Settings|Dimension)::[a-z_]+' |
  sed 's/.*:://' | sort -u); do
  grep -qE "\b$word\b" "$made"/epura/scene.hpp "$root"/include/epura/{scene_types,choices,epura}.hpp || complain "there is no '$word'"
done
exit $status
