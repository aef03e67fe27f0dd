#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The checks of the tree must be able to fail: each is shown a small tree with one fault.
set -uo pipefail
tests=$(dirname "$(realpath "$0")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

expect() {  # passes|fails title command...
  local wanted=$1 title=$2 got=passes
  shift 2
  "$@" >"$scratch/log" 2>&1 || got=fails
  [ "$got" = "$wanted" ] || { echo "$title: $got" >&2; cat "$scratch/log" >&2; status=1; }
}

licence='// SPDX-License-Identifier: Apache-2.0\n'
tree() {  # file text [first line]: a sound tree plus one file
  rm -rf "$scratch/tree"
  mkdir -p "$scratch/tree/src/input/mesh" "$scratch/tree/src/sheet/output" "$scratch/tree/src/run/app"
  cp "$tests/../.clang-format" "$scratch/tree"
  printf '// SPDX-License-Identifier: Apache-2.0\n#include <OpenMesh/Core/IO/MeshIO.hh>\n\n#include "base/text.hpp"\n' >"$scratch/tree/src/input/mesh/read.cpp"
  mkdir -p "$(dirname "$scratch/tree/src/$1")"
  printf '%b' "${3-$licence}$2" >"$scratch/tree/src/$1"
}

layers() { cmake -DROOT="$scratch/tree" -P "$tests/layers.cmake"; }
style() { "$tests/style.sh" "$scratch/tree"; }

tree sheet/output/a.cpp '#include "mesh/read.hpp"\n'
expect passes "a folder to the left" layers
expect passes "nothing wrong" style
tree input/mesh/a.cpp '#include "output/write.hpp"\n'
expect fails "a folder to the right" layers
tree input/mesh/a.cpp '#include "elsewhere/write.hpp"\n'
expect fails "an unknown folder" layers
tree run/mesh/a.cpp '#include "base/text.hpp"\n'
expect fails "a folder in another district" layers
tree mesh/a.cpp '#include "base/text.hpp"\n'
expect fails "a folder outside of the districts" layers
tree sheet/output/a.cpp '#include <OpenMesh/Core/IO/MeshIO.hh>\n'
expect fails "a library out of its place" layers

tree run/app/a.cpp '#include "study/commands.hpp"\n'
expect fails "a tool in src" layers

tree input/mesh/a.cpp 'int x;\n' ''
expect fails "a file without a licence" style
tree input/mesh/a.cpp 'int   x;\n'
expect fails "not formatted" style
tree input/mesh/a.cpp "$(printf 'int x;\\n%.0s' {1..600})"
expect fails "a long file" style
tree input/mesh/a.cpp "int f(int a) {\\n$(printf '  ++a;\\n%.0s' {1..70})  return a;\\n}\\n"
expect fails "a long function" style
tree input/mesh/a.cpp 'namespace epura {\nint x;\n}  // namespace epura\n'
expect fails "a file outside the namespace of its folder" style
tree input/mesh/a.cpp 'namespace epura::mesh {\nint x;\n}  // namespace epura::mesh\n'
expect passes "a file in the namespace of its folder" style
tree input/mesh/a.cpp '#include <cstdio>\n\nvoid f() { printf("x"); }\n'
expect fails "a stage that prints" style
tree run/app/a.cpp '#include <cstdio>\n\nvoid f() { std::printf("x"); }\n'
expect passes "a command that prints" style
tree input/mesh/a.cpp 'constexpr double near = 4;\n'
expect passes "a limit in a folder without a header of limits" style
printf '%b#pragma once\n\ninline constexpr double far = 8;\n' "$licence" >"$scratch/tree/src/input/mesh/limits.hpp"
expect fails "a limit beside the header of limits" style
printf '%bconstexpr int near = 4;\n' "$licence" >"$scratch/tree/src/input/mesh/a.cpp"
expect passes "a count beside the header of limits" style
tree input/mesh/a.hpp 'int f();\n'
expect fails "a header without a guard" style
tree input/mesh/a.cpp '// As in mesh/b.hpp.\n'
expect fails "a comment that names a header that is not there" style
tree input/mesh/a.cpp "// see /ho""me/me\\n"
expect fails "a path of a machine" style

# What plants faults removes files: never those of others.
mkdir -p "$scratch/clone/.git" "$scratch/full"
touch "$scratch/clone/.git/HEAD" "$scratch/full/kept"
for folder in clone full full/kept; do
  expect fails "planting into $folder" "$tests/mutants/run" --tree "$scratch/$folder" --only "no such fault"
done
[ -e "$scratch/clone/.git/HEAD" ] && [ -e "$scratch/full/kept" ] || { echo "planting removes files" >&2; status=1; }
traces() { (cd "$scratch/built" && cc -o program "$1" && "$scratch/copy/tests/traces.sh" program); }
mkdir -p "$scratch/copy/tests" "$scratch/built"
cp "$tests/traces.sh" "$scratch/copy/tests"
built() {  # text: a program of one source in the tree
  printf '#include <stdio.h>\nint main() { return puts(%s) < 0; }\n' "$1" >"$scratch/copy/main.c"
}
built '"here"'
expect passes "a program without traces" traces "$scratch/copy/main.c"
built __FILE__
expect fails "the folder of a source" traces "$scratch/copy/main.c"
built __DATE__
expect fails "the day of building" traces "$scratch/copy/main.c"

exit $status
