#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What strangers build against an installed epura:  tests/sdk.sh BUILD
# The build folder is installed into a scratch prefix; the samples are configured against it, drawn with and checked.
set -uo pipefail
build=$(realpath "$1")
samples=$(realpath "$(dirname "$(realpath "$0")")/../samples")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset EPURA_PLUGIN_PATH
status=0

complain() {
  echo "sdk: $*" >&2
  status=1
}

try() {  # command...
  "$@" >"$scratch/log" 2>&1 || { complain "fails: $*"; cat "$scratch/log" >&2; return 1; }
}

# Moved after it was installed: nothing may remember where.
cmake --install "$build" --prefix "$scratch/first" >"$scratch/log" || { cat "$scratch/log" >&2; exit 1; }
mv "$scratch/first" "$scratch/prefix"
epura=$scratch/prefix/bin/epura

make_it() {  # folder build-folder [CMake option...]
  local source=$1 to=$2
  shift 2
  try cmake -S "$source" -B "$to" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_BUILD_TYPE=Debug "$@" &&
    try cmake --build "$to"
}

draw() {  # folder-of-plugins projection svg; without the prefix, ids would tell views apart by their names
  try "$epura" draw "$samples/models/bracket.obj" --plugin-path "$1" --projection "$2" --id-prefix part -o "$3" &&
    [ -s "$3" ]
}

# One compiler after the other: what they draw must have the same bytes.
plugin() {  # folder projection
  local compiler
  for compiler in gcc clang; do
    command -v $compiler >/dev/null || { echo "sdk: no $compiler" >&2; continue; }
    local to=$scratch/$2-$compiler
    make_it "$1" "$to" -DCMAKE_C_COMPILER=$compiler -DCMAKE_CXX_COMPILER=${compiler/gcc/g}++ &&
      try "$epura" plugins check "$to/$2.so" && draw "$to" "$2" "$scratch/$2-$compiler.svg"
  done
  [ ! -f "$scratch/$2-clang.svg" ] || cmp "$scratch/$2-gcc.svg" "$scratch/$2-clang.svg" || complain "$2: compilers differ"
}

plugin "$samples/plugin-military" military
plugin "$samples/plugin-c" worms-eye

# The sample is the planometric projection, which is built in.
draw "$scratch" planometric "$scratch/planometric.svg"
sed 's/military/planometric/g' "$scratch/military-gcc.svg" | cmp - "$scratch/planometric.svg" ||
  complain "the sample draws something else than the planometric projection"

# Importers: what they read is drawn, and their authors can check them.
importer() {  # folder name file
  local compiler
  for compiler in gcc clang; do
    command -v $compiler >/dev/null || continue
    local to=$scratch/$2-$compiler
    make_it "$1" "$to" -DCMAKE_C_COMPILER=$compiler -DCMAKE_CXX_COMPILER=${compiler/gcc/g}++ &&
      try "$epura" importers check "$to/$2.so" "$3" &&
      try "$epura" draw "$3" --plugin-path "$to" --id-prefix part -o "$scratch/$2-$compiler.svg"
  done
  [ ! -f "$scratch/$2-clang.svg" ] || cmp "$scratch/$2-gcc.svg" "$scratch/$2-clang.svg" || complain "$2: compilers differ"
}

importer "$samples/importer-boxes" boxes "$samples/importer-boxes/table.boxes"
[ "$(wc -l < "$samples/importer-requirements/plates.cpp")" -le 60 ] || complain "plates: the sample has more than 60 lines"
importer "$samples/importer-requirements" plates "$samples/importer-requirements/base.plate"
importer "$samples/importer-c" terrain "$samples/importer-c/hill.terrain"
try cmake --install "$scratch/boxes-gcc" --prefix "$scratch/prefix" &&
  try "$epura" draw "$samples/importer-boxes/table.boxes" -o "$scratch/found.svg"
"$epura" importers | grep '^  boxes ' >/dev/null || complain "boxes are not listed"

# Installed into the same prefix, a plugin is found by itself.
try cmake --install "$scratch/military-gcc" --prefix "$scratch/prefix" &&
  try "$epura" draw "$samples/models/bracket.obj" --projection military -o "$scratch/found.svg"

# What it says of itself is completed and stands in the manual, of the program as installed and of one asked now.
"$epura" completion words -- draw --projection mil | grep '^military' >/dev/null || complain "military is not completed"
"$epura" completion words -- draw --projection military: | grep '^military:[a-z]*=' >/dev/null ||
  complain "parameters of military are not completed"
"$epura" manual | grep fBmilitary >/dev/null || complain "the manual does not tell military"
grep -q fBcabinet "$scratch/prefix/share/man/man1/epura.1" || complain "the installed manual tells no projection"
"$epura" completion bash | cmp - "$scratch/prefix/share/bash-completion/completions/epura" || complain "bash: no script"

# A new projection, begun by the program and built from where it was begun; never over another one.
cd "$scratch" || exit 2
# Its line for CMake works as it is printed.
if "$epura" new-projection 3-quarters >steps && grep '^  cmake ' steps >build.sh && try sh -e build.sh &&
  try "$epura" plugins check 3-quarters/build/3-quarters.so && draw 3-quarters/build 3-quarters new.svg; then
  echo mine >3-quarters/3-quarters.cpp
  "$epura" new-projection 3-quarters >log 2>&1 && complain "a folder was overwritten"
  grep -q 'exists already' log && [ "$(cat 3-quarters/3-quarters.cpp)" = mine ] || complain "no refusal: $(cat log)"
fi

# The study is a program beside epura, and may be missing.
"$epura" study stability --cases P1 | grep '^P1 ' >/dev/null || complain "the study does not run"
grep -q stability "$scratch/prefix/share/man/man1/epura-study.1" || complain "the study has no manual page"
rm "$scratch/prefix/bin/epura-study"
"$epura" study stability --cases P1 2>log && complain "there is no study, and that is no failure"
grep -q 'install the package epura-study' log || complain "nothing is told of the missing study: $(cat log)"

# The library, from another program: a cube in memory, and the same drawing as the program makes of a file.
printf 'v %s\n' '0 0 0' '9 0 0' '9 9 0' '0 9 0' '0 0 9' '9 0 9' '9 9 9' '0 9 9' >cube.obj
printf 'f %s\n' '4 3 2 1' '5 6 7 8' '1 2 6 5' '2 3 7 6' '3 4 8 7' '4 1 5 8' >>cube.obj
same_drawing() {  # program extension
  rm -f "library.$2"
  try "$1" "library.$2" && try "$epura" draw cube.obj -o "program.$2" &&
    { cmp "library.$2" "program.$2" || complain "$1, $2: library and program differ"; }
}

if make_it "$samples/library" library; then
  same_drawing library/sheet svg
  same_drawing library/sheet pdf
  library/sheet missing/x.svg 2>log && complain "a missing folder is no failure"
  grep -q 'missing/x.svg' log || complain "a failure does not name its file: $(cat log)"
fi

# Hidden lines in memory, from a program in C.
if make_it "$samples/hlr" curves; then
  { curves/curves >curves.svg && [ "$(grep -c polyline curves.svg)" -gt 10 ]; } || complain "curves are not drawn"
  # The handle is seen over the cylinder, and hidden behind the plate.
  { [ "$(grep -c '<path.*"0.2" d="M.*C' curves.svg)" -ge 1 ] && grep -q '<path.*dasharray.* d="M.*C' curves.svg; } ||
    complain "the handle is no spline, or all of it is seen"
fi

# By hand, with the flags of pkg-config, and by the other compiler.
PKG_CONFIG_PATH=$(dirname "$(find "$scratch/prefix" -name epura.pc)")
export PKG_CONFIG_PATH
read -ra flags < <(pkg-config --cflags epura)
read -ra libraries < <(pkg-config --libs epura)
compiler=c++
command -v clang++ >/dev/null && compiler=clang++
try cc -shared -fPIC "${flags[@]}" "$samples/plugin-c/worms-eye.c" -o by-hand.so &&
  try "$epura" plugins check by-hand.so
try $compiler -std=c++20 "${flags[@]}" "$samples/library/sheet.cpp" "${libraries[@]}" \
  -Wl,-rpath,"$(pkg-config --variable=libdir epura)" -o by-hand && same_drawing ./by-hand dxf

read -ra libraries < <(pkg-config --libs epura-hlr)
try cc -std=c99 -Wall -Wextra -Werror "${flags[@]}" "$samples/hlr/curves.c" "${libraries[@]}" -lm \
  -Wl,-rpath,"$(pkg-config --variable=libdir epura-hlr)" -o curves-by-hand && ./curves-by-hand | cmp - curves.svg ||
  complain "curves by hand differ"

# The module for Python, on this library.
if [ -f "$(find "$scratch/prefix" -path '*/cmake/epura/_parts.py')" ]; then
  try "$samples/../tests/pip.sh" --config-settings=installed="$scratch/prefix" --config-settings=build="$scratch/pip" \
    --config-settings=cmake=-DCMAKE_CXX_FLAGS_RELEASE=-O0
else
  complain "the classes of scenes for Python are not installed"
fi
exit $status
